# %% wrong
estimate = 1  # Was anything measured here?
estimate = 2  # Is the measurement without an error?
estimate = sp.Rational(3, 2)  # Has the variance stayed as it was at the start? (hint 1)
estimate = sp.Rational(5, 4)  # Are the weights of the two pieces of evidence interchanged?
deviation = sp.Rational(3, 4)  # Is this the variance? (hint 1)
deviation = sp.sqrt(3)  # Is this before the measurement? (hint 1)
deviation = sp.sqrt(sp.Rational(1, 2))  # Has the variance stayed as it was at the start?
start_estimate = 1  # Is the later measurement uncorrelated with the initial value? (hint 1)
# Is the noise on the way an error for this estimate? (hint 1)
start_estimate = sp.Rational(3, 2)
start_estimate = sp.Rational(7, 4)  # Is this the end of the interval? (hint 1)
start_deviation = 1  # Is the later measurement uncorrelated with the initial value?
start_deviation = sp.Rational(3, 4)  # Is this the variance?
# Is the noise on the way an error for this estimate? (hint 1)
start_deviation = sp.sqrt(sp.Rational(1, 2))

# %% right
estimate = sp.Rational(1 * 1 + 3 * 2, 4)  # a mean with the inverse variances as weights
start_deviation = 1 / sp.sqrt(1 + sp.Rational(1, 3))  # the inverse variances add up
