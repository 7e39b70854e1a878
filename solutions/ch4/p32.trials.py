# %% wrong
estimate = sp.E  # Was anything measured here? (hint 1)
estimate = 2 * sp.E  # Is the measurement without an error?
estimate = sp.Rational(3, 2)  # Does the mean stay where it is after the measurement? (hint 1)
# Which sign has the rate in the equation of the process?
estimate = sp.Rational(3, 2) * sp.exp(-1)
deviation = sp.exp(2) - sp.Rational(1, 2)  # Is this the variance?
# Is this just after the measurement, or does the process decay here? (hint 1)
deviation = sp.sqrt(sp.Rational(1, 2))
deviation = sp.E / sp.sqrt(2)  # Does noise act on the way? (hint 1)
deviation = sp.sqrt(3 * sp.exp(2) / 2 - sp.Rational(1, 2))  # Was anything measured here?
blind = sp.sqrt(sp.exp(2) - sp.Rational(1, 2))  # Is a measurement used here? (hint 1)
blind = sp.E  # Does noise act on the way?
blind = 3 * sp.exp(2) / 2 - sp.Rational(1, 2)  # Is this the variance?

# %% right
deviation = sp.sqrt(sp.exp(2) / 2 + (sp.exp(2) - 1) / 2)  # what is left and what is new
blind = sp.sqrt((3 * sp.exp(2) - 1) / 2)  # over one denominator
