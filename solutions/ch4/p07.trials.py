# %% wrong
covariance = 1  # With which signs does the common term enter? (hint 2)
covariance = 0  # Are the sums independent because their terms are? (hint 2)
covariance = -2  # Is a mean meant here, or the mean of a product of deviations? (hint 1)
# Is it the variances that stand below, or their roots? (hint 1)
correlation = -sp.Rational(1, 274)
correlation = -1 / (sp.sqrt(2) * sp.sqrt(35))  # Was every coefficient squared? (hint 2)
correlation = -1  # Is this the covariance? (hint 1)

# %% right
correlation = -sp.sqrt(274) / 274  # without a root below
correlation = -1 / sp.sqrt(137) / sp.sqrt(2)  # two roots
