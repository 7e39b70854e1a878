# %% wrong
# Is this the line through the first and the last point? (hint 1)
slope = sp.Rational(readings[-1] - readings[0], times[-1] - times[0])
estimate = [readings[0] - slope * times[0], slope]
estimate = estimate[::-1]  # Were height and slope interchanged?
# Were the times taken as 0, 1, 2, 3? (hint 1)
slope = sp.Rational(sum((2 * k - 3) * z for k, z in enumerate(readings)), 10)
estimate = [sp.Rational(sum(readings), 4) - 3 * slope / 2, slope]
# Is this the height in the middle of the times? (hint 1)
estimate = [sp.Rational(sum(readings), 4), estimate[1]]
# Is this the part explained by the trend, or the rest? (hint 1)
middle = sp.Rational(sum(readings), 4)
least = sum((z - middle) ** 2 for z in readings) - least
# Is this the sum before the trend was subtracted? (hint 1)
middle = sp.Rational(sum(readings), 4)
least = sum((z - middle) ** 2 for z in readings)
least = sp.sqrt(least)  # Is the question about the length of the residual, or its square?

# %% right
# from the means
slope = estimate[1]
estimate = [sp.Rational(sum(readings), 4) - slope * sp.Rational(sum(times), 4), slope]
# the residuals themselves
least = sum((z - estimate[0] - estimate[1] * t) ** 2 for t, z in record.items())

# %% numbers
times, readings = [
    ([0, 2, 3, 5], [1, 2, 3, 4]),
    ([0, 1, 3, 4], [2, 1, 5, 3]),
    ([0, 1, 2, 5], [1, 3, 2, 6]),
    ([0, 2, 4, 6], [3, 1, 4, 6]),
    ([0, 1, 4, 5], [1, 2, 2, 5]),
    ([0, 3, 4, 5], [4, 3, 1, 2]),
    ([0, 2, 3, 7], [1, 4, 3, 6]),
    ([0, 1, 3, 6], [5, 4, 2, 1]),
    ([0, 2, 5, 7], [1, 3, 6, 5]),
    ([0, 1, 5, 6], [2, 4, 5, 9]),
    ([0, 4, 5, 7], [1, 2, 5, 6]),
    ([0, 2, 3, 4], [6, 3, 2, 3]),
    ([0, 1, 2, 6], [1, 4, 3, 7]),
    ([0, 3, 5, 6], [2, 3, 6, 4]),
]
shown = [
    "$z(«times[0]») = «readings[0]»$, $z(«times[1]») = «readings[1]»$, "
    "$z(«times[2]») = «readings[2]»$, $z(«times[3]») = «readings[3]»$"
]
H, z = sp.Matrix([[1, t] for t in times]), sp.Matrix(readings)
estimate = list((H.T * H).inv() * H.T * z)
residuals = z - H * sp.Matrix(estimate)
least = residuals.dot(residuals)
