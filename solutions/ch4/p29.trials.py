# %% wrong
before = 3 * sp.exp(-2)  # Does noise act on the way?
before = 3 * sp.exp(-2) + 6 * (1 - sp.exp(-2))  # At which rate do variances decay?
before = sp.sqrt(3)  # Is this the standard deviation?
estimate = sp.Rational(5, 2)  # Has the mean moved since the start? (hint 2)
estimate = sp.Rational(5, 2) * sp.exp(-1)  # At which time is it measured here? (hint 1)
estimate = sp.exp(-1)  # Was anything measured here?
estimate = 3  # Is the measurement without an error?
deviation = sp.Rational(3, 4)  # Is this the variance? (hint 1)
deviation = sp.sqrt(3)  # Is this before the measurement? (hint 1)
deviation = sp.sqrt(3 - sp.Rational(9, 4) * sp.exp(-2))  # At which time is it measured here?
deviation = 1  # Is the measurement the only source of information?

# %% right
estimate = (sp.exp(-1) / 3 + 3) / (sp.Rational(1, 3) + 1)  # weights inverse to the variances
deviation = 1 / sp.sqrt(1 + sp.Rational(1, 3))  # the inverse variances add up
before = 3 * sp.exp(-2) + 3 * (1 - sp.exp(-2))  # what is left and what is new
