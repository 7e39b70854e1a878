# %% wrong
estimate = mean * sp.exp(rate)  # Was anything measured here? (hint 1)
estimate = reading * sp.exp(rate)  # Is the measurement without an error?
# Is the mean constant after the measurement? (hint 1)
estimate = estimate * sp.exp(-rate)
# What is the sign of the rate in the equation of the process?
estimate = estimate * sp.exp(-2 * rate)
deviation = deviation**2  # Is this the variance?
# Is this just after the measurement, or does the process decay here? (hint 1)
deviation = sp.sqrt(sp.Rational(spread**2 * error, spread**2 + error))
# Was the noise after $t = 0$ left out? (hint 1)
deviation = sp.exp(rate) * sp.sqrt(sp.Rational(spread**2 * error, spread**2 + error))
deviation = blind  # Was anything measured here?
blind = deviation  # Is a measurement used here? (hint 1)
blind = spread * sp.exp(rate)  # Was the noise after $t = 0$ left out?
blind = blind**2  # Is this the variance?

# %% right
# what is left and what is new
growth, corrected = sp.exp(2 * rate), sp.Rational(spread**2 * error, spread**2 + error)
deviation = sp.sqrt(corrected * growth + (growth - 1) / (2 * rate))
# over one denominator
growth = sp.exp(2 * rate)
blind = sp.sqrt(((2 * rate * spread**2 + 1) * growth - 1) / (2 * rate))

# %% numbers
rate, mean, spread, error, reading = [
    (1, 1, 1, 1, 2),
    (1, 2, 2, 2, 5),
    (2, 3, 1, 4, 1),
    (1, 4, 4, 2, 1),
    (2, 2, 3, 2, 3),
    (3, 1, 1, 3, 6),
    (1, 4, 3, 1, 2),
    (2, 2, 2, 5, 6),
    (3, 3, 2, 2, 5),
    (4, 3, 2, 2, 1),
    (2, 4, 5, 1, 1),
    (3, 1, 3, 2, 5),
    (2, 4, 4, 1, 2),
    (5, 1, 2, 3, 3),
]
shown = [
    r"\dot x = «rate*»x + q",
    r"\mu_x(0) = «mean», \quad \sigma_x(0) = «spread»",
    r"$E[r^2] = «error»$ gives $z = «reading»$",
    r"$\dot P = «2 * rate»P + 1$",
]
growth, share = sp.exp(2 * rate), sp.Rational(spread**2, spread**2 + error)
estimate = (mean + share * (reading - mean)) * sp.exp(rate)
noise = (growth - 1) / (2 * rate)
deviation = sp.sqrt(share * error * growth + noise)
blind = sp.sqrt(spread**2 * growth + noise)
