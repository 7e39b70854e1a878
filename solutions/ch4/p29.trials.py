# %% wrong
before = variance * sp.exp(-2 * rate)  # Was the noise left out?
# At what rate do variances decay?
before = variance * sp.exp(-2 * rate) + intensity * (1 - sp.exp(-2 * rate))
before = sp.sqrt(variance)  # Is this the standard deviation?
# Has the mean changed since $t = 0$? (hint 2)
estimate = mean + sp.Rational(variance, variance + error) * (reading - mean)
# When is the measurement made here? (hint 1)
estimate = (mean + sp.Rational(variance, variance + error) * (reading - mean)) * sp.exp(-rate)
estimate = mean * sp.exp(-rate)  # Was anything measured here?
estimate = reading  # Is the measurement without an error?
deviation = deviation**2  # Is this the variance? (hint 1)
deviation = sp.sqrt(variance)  # Is this before the measurement? (hint 1)
# When is the measurement made here?
decay = sp.exp(-2 * rate)
deviation = sp.sqrt(deviation**2 * decay + variance * (1 - decay))
deviation = sp.sqrt(error)  # Is the measurement the only source of information?

# %% right
# weights inverse to the variances
weights = sp.Rational(1, variance), sp.Rational(1, error)
estimate = (mean * sp.exp(-rate) * weights[0] + reading * weights[1]) / sum(weights)
# the inverse variances add up
deviation = 1 / sp.sqrt(sp.Rational(1, variance) + sp.Rational(1, error))
# what is left and what is new
decay = sp.exp(-2 * rate)
before = variance * decay + sp.Rational(intensity, 2 * rate) * (1 - decay)


# %% numbers
def row(rate, mean, variance, error, reading):
    """Numbers with the intensity that keeps the variance."""
    return rate, 2 * rate * variance, mean, variance, error, reading


rate, intensity, mean, variance, error, reading = [
    row(*parts)
    for parts in [
        (1, 1, 3, 1, 3),
        (1, 2, 2, 1, 5),
        (2, 1, 5, 2, 4),
        (1, 1, 10, 2, 1),
        (3, 1, 8, 1, 1),
        (1, 1, 6, 3, 5),
        (1, 1, 11, 2, 4),
        (2, 1, 15, 1, 2),
        (1, 2, 12, 4, 1),
        (2, 1, 7, 2, 5),
        (3, 2, 13, 2, 2),
        (1, 3, 14, 3, 2),
        (1, 3, 17, 3, 1),
        (1, 4, 19, 1, 2),
    ]
]
shown = [
    r"\dot x = -«rate*»x + q",
    r"«intensity»\,\delta(t - s)",
    r"\mu_x(0) = «mean», \quad \sigma_x(0) = \sqrt«str(variance)»",
    r"$E[r^2] = «error»$ gives $z = «reading»$",
    r"$\dot P = -«2 * rate»P + «intensity»$",
]
before = sp.Integer(variance)
forecast = mean * sp.exp(-rate)
estimate = forecast + sp.Rational(variance, variance + error) * (reading - forecast)
deviation = sp.sqrt(sp.Rational(variance * error, variance + error))
