# %% wrong
estimate = mean * sp.exp(-rate)  # Was anything measured here? (hint 1)
estimate = reading * sp.exp(-rate)  # Is the measurement without an error? (hint 2)
# Is the mean constant after the measurement? (hint 1)
estimate = mean + sp.Rational(variance, variance + error) * (reading - mean)
# Is the standard deviation used where the variance belongs? (hint 2)
spreads = sp.sqrt(variance), sp.sqrt(error)
estimate = (mean + spreads[0] / sum(spreads) * (reading - mean)) * sp.exp(-rate)
deviation = deviation**2  # Is this the variance? (hint 2)
# Is this just after the measurement? (hint 1)
deviation = sp.sqrt(sp.Rational(variance * error, variance + error))
# Was the noise after the measurement left out? (hint 1)
deviation = sp.sqrt(sp.Rational(variance * error, variance + error)) * sp.exp(-rate)
# Was anything measured here?
decay = sp.exp(-2 * rate)
deviation = sp.sqrt(variance * decay + (1 - decay) / (2 * rate))

# %% right
# over one root
decay, corrected = sp.exp(-2 * rate), sp.Rational(variance * error, variance + error)
deviation = sp.sqrt((2 * rate * corrected - 1) * decay + 1) / sp.sqrt(2 * rate)
# mean and covariance of x(1) with z
covariance = variance * sp.exp(-rate)
estimate = mean * sp.exp(-rate) + covariance * sp.Rational(reading - mean, variance + error)

# %% numbers
rate, mean, variance, error, reading = [
    (1, 1, 3, 1, 3),
    (1, 2, 2, 1, 5),
    (2, 1, 3, 2, 4),
    (1, 3, 5, 1, 1),
    (2, 1, 5, 2, 2),
    (1, 1, 3, 2, 5),
    (3, 1, 2, 1, 5),
    (2, 3, 5, 3, 1),
    (1, 2, 6, 2, 4),
    (2, 1, 7, 2, 5),
    (1, 4, 5, 2, 2),
    (3, 2, 6, 3, 5),
    (2, 4, 3, 1, 2),
    (4, 2, 3, 2, 1),
]
shown = [
    r"\dot x = -«rate*»x + q",
    r"\mu_x(0) = «mean», \quad \sigma_x(0) = \sqrt«str(variance)»",
    r"$E[r^2] = «error»$ gives $z = «reading»$",
    r"$\dot P = -«2 * rate»P + 1$",
]
estimate = (mean + sp.Rational(variance, variance + error) * (reading - mean)) * sp.exp(-rate)
decay, corrected = sp.exp(-2 * rate), sp.Rational(variance * error, variance + error)
deviation = sp.sqrt(corrected * decay + (1 - decay) / (2 * rate))
