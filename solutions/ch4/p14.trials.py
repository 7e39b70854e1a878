# %% wrong
# Where does the line through the three points start? (hint 1)
estimate = [readings[0], estimate[1]]
estimate = estimate[::-1]  # Were height and slope interchanged? (hint 1)
# Were the weights left out? (hint 1)
rows = sp.Matrix([[1, 1], [1, 2], [1, 3]])
covariance = (rows.T * rows).inv()
# Is a square divided by the standard deviation or by the variance? (hint 2)
rows = sp.Matrix([[1, 1], [1, 2], [1, 3]])
covariance = (rows.T * sp.diag(*deviations).inv() * rows).inv()
# Is this the matrix of the normal equations itself? (hint 1)
covariance = covariance.inv()
weighted = plain  # Were the weights left out? (hint 2)
# Is a square divided by the standard deviation or by the variance? (hint 2)
rows, record = sp.Matrix([[1, 1], [1, 2], [1, 3]]), sp.Matrix([readings[0], c, readings[2]])
weights = sp.diag(*deviations).inv()
weighted = list((rows.T * weights * rows).inv() * rows.T * weights * record)
# Is this the height in the middle of the times? (hint 2)
weighted = [weighted[0] + 2 * weighted[1], weighted[1]]
plain = weighted  # Are these the weights of the accurate measurement?
# Is this the height in the middle of the times?
plain = [plain[0] + 2 * plain[1], plain[1]]

# %% right
# from the middle
weights, slope = [sp.S.One / d**2 for d in deviations], sp.Rational(readings[2] - readings[0], 2)
middle = (weights[0] * readings[0] + weights[1] * c + weights[2] * readings[2]) / sum(weights)
weighted = [middle - 2 * slope, slope]

# %% numbers
half = sp.Rational(1, 2)
readings, deviations = [
    ([1, 2, 3], [1, half, 1]),
    ([1, 3, 5], [1, 2, 1]),
    ([5, 6, 7], [half, 1, half]),
    ([4, 3, 2], [2, 1, 2]),
    ([5, 3, 1], [1, 3, 1]),
    ([3, 2, 1], [3 * half, 2, 3 * half]),
    ([1, 4, 7], [half, 3 * half, half]),
    ([7, 4, 1], [3 * half, half, 3 * half]),
    ([6, 4, 2], [half, 2, half]),
    ([3, 5, 7], [3, 1, 3]),
    ([2, 4, 6], [half, 3, half]),
    ([5, 4, 3], [3 * half, 5, 3 * half]),
    ([7, 5, 3], [3 * half, 1, 3 * half]),
    ([3, 4, 5], [3 * half, 4, 3 * half]),
]


def fraction(number):
    """A number in the notation of the page."""
    return str(sp.sympify(number))


shown = [
    r"$z(1) = «readings[0]»$, $z(2) = «readings[1]»$, $z(3) = «readings[2]»$",
    r"$\sigma_{r_1} = «fraction(deviations[0])»$, $\sigma_{r_2} = «fraction(deviations[1])»$, "
    r"$\sigma_{r_3} = «fraction(deviations[2])»$",
    r"the standard deviation is $«fraction(deviations[1])»$",
]
rows, weights = sp.Matrix([[1, 1], [1, 2], [1, 3]]), sp.diag(*[sp.S.One / d**2 for d in deviations])
covariance = (rows.T * weights * rows).inv()
slope = sp.Rational(readings[2] - readings[0], 2)
estimate = [readings[0] - slope, slope]
record = sp.Matrix([readings[0], c, readings[2]])
weighted = list(covariance * rows.T * weights * record)
plain = list((rows.T * rows).inv() * rows.T * record)
