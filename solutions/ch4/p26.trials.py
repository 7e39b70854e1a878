# %% wrong
# Is this the mean before the measurement? (hint 1)
estimate = [position + moment * speed, speed]
# Is the measured position uncorrelated with the speed? (hint 2)
estimate = [estimate[0], speed]
# Was the noise left out of the covariance? (hint 2)
surprise = sp.Rational(reading - position - moment * speed, 1 + moment**2 + variance)
estimate = [
    position + moment * speed + (1 + moment**2) * surprise,
    speed + moment * surprise,
]
# Which is subtracted, the expected value or the measured one?
estimate = [2 * (position + moment * speed) - estimate[0], 2 * speed - estimate[1]]
# Is this before the measurement? (hint 1)
t = sp.Integer(moment)
covariance = sp.Matrix([[1 + t**2 + t**3 / 3, t + t**2 / 2], [t + t**2 / 2, 1 + t]])
# Does the variance of the speed remain unchanged? (hint 2)
p, q, _, _ = covariance
covariance = sp.Matrix([[p, q], [q, 1 + moment]])
# Was the noise left out of the prediction?
t = moment
without = sp.Matrix([[(1 + t**2) * variance, t * variance], [t * variance, 1 + variance]])
covariance = without / (1 + t**2 + variance)

# %% right
# the inverse matrices add up
t = sp.Integer(moment)
before = sp.Matrix([[1 + t**2 + t**3 / 3, t + t**2 / 2], [t + t**2 / 2, 1 + t]])
covariance = (before.inv() + sp.diag(sp.Rational(1, variance), 0)).inv()
# the position from the two variances, the speed from the regression on it
t = sp.Integer(moment)
p, q, expected = 1 + t**2 + t**3 / 3, t + t**2 / 2, position + t * speed
first = (variance * expected + reading * p) / (p + variance)
estimate = [first, speed + q * (first - expected) / p]

# %% numbers
position, speed, moment, variance, reading = [
    (1, 1, 3, 1, 3),
    (2, 1, 1, 1, 5),
    (1, 2, 2, 1, 3),
    (3, 1, 1, 2, 2),
    (1, 1, 2, 2, 5),
    (2, 1, 3, 2, 4),
    (1, 2, 3, 3, 5),
    (3, 1, 3, 5, 4),
    (2, 2, 3, 6, 5),
    (1, 1, 1, 3, 4),
    (2, 2, 2, 3, 4),
    (1, 3, 2, 4, 5),
    (4, 1, 3, 4, 5),
    (2, 3, 1, 5, 2),
    (3, 2, 2, 5, 4),
]
shown = [
    r"E[x(0)] = \begin{pmatrix} «position»\\ «speed»\end{pmatrix}",
    r"At the time $t = «moment»$ the measurement $z = x_1(«moment») + r$ with $E[r] = 0$, "
    r"$E[r^2] = «variance»$ gives the value $z = «reading»$.",
    r"$\tilde x(«moment»)$",
    r"the estimate of $x(«moment»)$",
    r"from $t = 0$ to $t = «moment»$",
]
flow = sp.Matrix([[1, moment], [0, 1]])
before = flow * flow.T + sp.Matrix(
    [[sp.Rational(moment**3, 3), sp.Rational(moment**2, 2)], [sp.Rational(moment**2, 2), moment]]
)
gain = before[:, 0] / (before[0, 0] + variance)
forecast = flow * sp.Matrix([position, speed])
estimate = list(forecast + gain * (reading - forecast[0]))
covariance = before - gain * before[0, :]
