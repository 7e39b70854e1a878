# %% wrong
estimate = mean  # Was anything measured here?
estimate = reading  # Is the measurement without an error?
# Is the variance before the measurement the initial one? (hint 1)
estimate = mean + sp.Rational(spread**2, spread**2 + error) * (reading - mean)
# Are the weights of the two pieces of information interchanged?
estimate = mean + reading - estimate
deviation = deviation**2  # Is this the variance? (hint 1)
deviation = sp.sqrt(spread**2 + intensity)  # Is this before the measurement? (hint 1)
# Is the variance before the measurement the initial one?
deviation = sp.sqrt(sp.Rational(spread**2 * error, spread**2 + error))
# Is the later measurement uncorrelated with the initial value? (hint 1)
start_estimate = mean
# Is the noise before $t = 1$ an error for this estimate? (hint 1)
start_estimate = mean + sp.Rational(spread**2, spread**2 + error) * (reading - mean)
start_estimate = estimate  # Is this the end of the interval? (hint 1)
start_deviation = spread  # Is the later measurement uncorrelated with the initial value?
start_deviation = start_deviation**2  # Is this the variance?
# Is the noise before $t = 1$ an error for this estimate? (hint 1)
start_deviation = sp.sqrt(sp.Rational(spread**2 * error, spread**2 + error))

# %% right
# a mean with the inverse variances as weights
whole = spread**2 + intensity
estimate = sp.Rational(error * mean + whole * reading, whole + error)
# the inverse variances add up
start_deviation = 1 / sp.sqrt(sp.Rational(1, spread**2) + sp.Rational(1, intensity + error))

# %% numbers
intensity, mean, spread, error, reading = [
    (2, 1, 1, 1, 2),
    (3, 2, 2, 2, 5),
    (2, 3, 1, 4, 1),
    (4, 1, 2, 3, 4),
    (5, 2, 3, 2, 3),
    (2, 1, 2, 1, 3),
    (1, 1, 2, 3, 3),
    (1, 1, 1, 3, 5),
    (5, 3, 1, 2, 5),
    (4, 2, 3, 1, 4),
    (3, 5, 2, 6, 1),
    (7, 1, 1, 2, 5),
    (6, 1, 2, 2, 2),
    (6, 3, 3, 2, 1),
]
shown = [
    r"«intensity»\,\delta(t - s)",
    r"\mu_x(0) = «mean», \quad \sigma_x(0) = «spread»",
    r"$E[r^2] = «error»$ gives $z = «reading»$",
]
whole = spread**2 + intensity
estimate = mean + sp.Rational(whole, whole + error) * (reading - mean)
deviation = sp.sqrt(sp.Rational(whole * error, whole + error))
start_estimate = mean + sp.Rational(spread**2, whole + error) * (reading - mean)
start_deviation = spread * sp.sqrt(sp.Rational(intensity + error, whole + error))
