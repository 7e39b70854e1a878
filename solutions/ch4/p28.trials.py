# %% wrong
estimate = sp.exp(-1)  # Was anything measured here? (hint 1)
estimate = 3 * sp.exp(-1)  # Is the measurement without an error? (hint 2)
estimate = sp.Rational(5, 2)  # Does the mean stay where it is after the measurement? (hint 1)
# Is the standard deviation used where the variance belongs? (hint 2)
estimate = (1 + 2 * sp.sqrt(3) / (sp.sqrt(3) + 1)) * sp.exp(-1)
deviation = sp.Rational(1, 2) + sp.exp(-2) / 4  # Is this the variance? (hint 2)
deviation = sp.sqrt(3) / 2  # Is this just after the measurement? (hint 1)
deviation = sp.sqrt(3) / 2 * sp.exp(-1)  # Does noise act on the way? (hint 1)
deviation = sp.sqrt(sp.Rational(1, 2) + 5 * sp.exp(-2) / 2)  # Was anything measured here?

# %% right
deviation = sp.sqrt(2 + sp.exp(-2)) / 2  # over one root
# mean and covariance of x(1) with z
estimate = sp.exp(-1) + sp.Rational(3, 4) * sp.exp(-1) * (3 - 1)
