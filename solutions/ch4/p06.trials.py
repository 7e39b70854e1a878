# %% wrong
covariance = -6  # Are all three components uncorrelated? (hint 1)
# How many products of $x_1$ and $x_2$ are there, and with which signs? (hint 1)
covariance = -7
covariance = sp.Rational(13, 2)  # Was the minus in the second sum lost? (hint 1)
covariance = 7  # Is this a variance instead? (hint 2)

# %% right
covariance = -sp.Integer(6) - sp.Rational(1, 2)  # squares and mixed products apart
