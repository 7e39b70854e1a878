# %% wrong
covariance = -8  # Do $x_1$ and $x_2$ vary independently of each other? (hint 2)
# How many products of $x_1$ and $x_2$ are there, and with which signs? (hint 2)
covariance = -9
covariance = -sp.Rational(13, 2)  # Which sign has $x_3$ in the second sum? (hint 2)
# Do the variances of $x_1$ and $x_2$ alone make the variance of a sum in which both stand? (hint 2)
matrix = sp.Matrix([[6, -sp.Rational(17, 2)], [-sp.Rational(17, 2), 18]])
# Was a minus in the rows lost? (hint 1)
matrix = sp.Matrix([[7, sp.Rational(17, 2)], [sp.Rational(17, 2), 16]])
matrix = sp.diag(7, 16)  # Are the two sums uncorrelated? (hint 1)

# %% right
covariance = -8 - half  # squares and mixed products apart
