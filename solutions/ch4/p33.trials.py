# %% wrong
# Which component of the state is measured? (hint 2)
estimates = [y2 + p11 * (z - y1) / R, -b * y1 - a * y2 + p12 * (z - y1) / R]
# Is the position not corrected, though its error is correlated with that of the speed? (hint 1)
estimates = [y2, -b * y1 - a * y2 + p22 * (z - y2) / R]
# Which is subtracted, the estimate or the measurement?
estimates = [y2 + p12 * (y2 - z) / R, -b * y1 - a * y2 + p22 * (y2 - z) / R]
# Is there a division by R? (hint 2)
estimates = [y2 + p12 * (z - y2), -b * y1 - a * y2 + p22 * (z - y2)]
# Does the measurement make the variances smaller? (hint 2)
riccati = sp.Matrix(
    [[2 * p12, p22 - b * p11 - a * p12], [p22 - b * p11 - a * p12, Q - 2 * b * p12 - 2 * a * p22]]
)
# Which column of P appears in the last term? (hint 2)
riccati = sp.Matrix(
    [
        [2 * p12 - p11**2 / R, p22 - b * p11 - a * p12 - p11 * p12 / R],
        [p22 - b * p11 - a * p12 - p11 * p12 / R, Q - 2 * b * p12 - 2 * a * p22 - p12**2 / R],
    ]
)
# On which coordinate does the noise act?
riccati = sp.Matrix(
    [
        [Q + 2 * p12 - p12**2 / R, p22 - b * p11 - a * p12 - p12 * p22 / R],
        [p22 - b * p11 - a * p12 - p12 * p22 / R, -2 * b * p12 - 2 * a * p22 - p22**2 / R],
    ]
)
exists = b > 0  # Can an unstable motion be estimated, too? (hint 1)
exists = sp.And(a > 0, b > 0)  # Must the system itself be stable? (hint 1)
exists = sp.true  # Is there a position that the measured speed does not show? (hint 2)
# Does an error of the position decay without a spring, however strong the damping?
exists = sp.Or(sp.Ne(b, 0), a > 0)
# Does $P_{12}$ vanish for both signs of $b$? (hint 1)
negative = sp.diag(-R * (sp.sqrt(a**2 + Q / R) - a) / b, R * (sp.sqrt(a**2 + Q / R) - a))
# Is $P_{11}$ a variance here? (hint 1)
negative = sp.diag(R * (sp.sqrt(a**2 + Q / R) - a) / b, R * (sp.sqrt(a**2 + Q / R) - a))
# Does the equation for the variance of the speed contain $P_{12}$? (hint 2)
negative = sp.Matrix(
    [[-R * (sp.sqrt(a**2 + Q / R) + a) / b, 2 * R], [2 * R, R * (sp.sqrt(a**2 + Q / R) - a)]]
)
# Which root of the quadratic equation is a variance? (hint 2)
positive = sp.diag(-R * (sp.sqrt(a**2 + Q / R) + a) / b, -R * (sp.sqrt(a**2 + Q / R) + a))
# What does the equation for $P_{12}$ give in the stationary case? (hint 1)
positive = sp.diag(R * (sp.sqrt(a**2 + Q / R) - a), R * (sp.sqrt(a**2 + Q / R) - a))
# Is this $P_{12}$ one with which $P_{11}$ is a variance? (hint 2)
positive = sp.Matrix(
    [[-R * (sp.sqrt(a**2 + Q / R) + a) / b, 2 * R], [2 * R, R * (sp.sqrt(a**2 + Q / R) - a)]]
)
positive_gain = [0, R * (sp.sqrt(a**2 + Q / R) - a)]  # Is this the column of P itself? (hint 1)
positive_gain = [(sp.sqrt(a**2 + Q / R) - a) / b, 0]  # Which column of P does H pick out? (hint 1)
positive_gain = [2, sp.sqrt(a**2 + Q / R) - a]  # What is the value of $P_{12}$ here?
negative_gain = [0, sp.sqrt(a**2 + Q / R - 4 * b) - a]  # What is the value of $P_{12}$ here?
# Is this the column of P itself? (hint 1)
negative_gain = [2 * R, R * (sp.sqrt(a**2 + Q / R - 4 * b) - a)]

# %% right
exists = sp.Or(b > 0, b < 0)  # the two cases
# without a difference
positive = sp.diag(Q / (sp.sqrt(a**2 + Q / R) + a) / b, Q / (sp.sqrt(a**2 + Q / R) + a))
negative_gain = [2, (Q / R - 4 * b) / (a + sp.sqrt(a**2 + Q / R - 4 * b))]  # without a difference
