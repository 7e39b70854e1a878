# %% wrong
# Is this where the first two lines meet? Is the third equation satisfied? (hint 1)
z1, z2, z3 = map(sp.Integer, readings)
estimate = [(z1 + z2) / 2, (z1 - z2) / 2]
# Is a plain mean of the three crossings the least sum? (hint 2)
lines = [sp.Eq(quantity, reading) for quantity, reading in measured]
crossings = [sp.solve(pair, unknowns) for pair in (lines[:2], lines[1:], lines[::2])]
estimate = [sum(crossing[x] for crossing in crossings) / 3 for x in unknowns]
# Were the two components interchanged? (hint 1)
estimate = estimate[::-1]
least = 0  # Is there a point on all three lines?
# Is the question about the length of the residual, or its square?
least = sp.sqrt(least)
# Were the residuals taken at the crossing of two lines? (hint 1)
z1, z2, z3 = map(sp.Integer, readings)
least = (z3 - (z1 + z2) / 2 - weight * (z1 - z2) / 2) ** 2

# %% right
# over a common denominator
z1, z2, z3 = readings
first, second = z1 + z2 + z3, z1 - z2 + weight * z3
share = sp.Rational(1, 6 + 2 * weight**2)
estimate = [
    ((2 + weight**2) * first - weight * second) * share,
    (3 * second - weight * first) * share,
]
# as the sum of three squares
normal = [-1 - weight, weight - 1, 2]
length = sp.Rational(sum(c * z for c, z in zip(normal, readings)), sum(c**2 for c in normal))
least = sum((c * length) ** 2 for c in normal)

# %% numbers
weight, readings = [
    (2, [2, 0, 4]),
    (3, [2, 1, 5]),
    (2, [1, 2, 3]),
    (3, [3, 1, 2]),
    (2, [3, 1, 2]),
    (3, [4, 2, 1]),
    (4, [2, 1, 2]),
    (3, [5, 1, 3]),
    (3, [2, 1, 2]),
    (2, [1, 0, 1]),
    (2, [3, 2, 5]),
    (2, [5, 1, 2]),
    (2, [5, 1, 4]),
    (2, [3, 0, 1]),
]
shown = [
    r"z_1 &= x_1 + x_2 + r_1 = «readings[0]»,",
    r"z_2 &= x_1 - x_2 + r_2 = «readings[1]»,",
    r"z_3 &= x_1 + «weight*»x_2 + r_3 = «readings[2]» .",
]
H, z = sp.Matrix(quantities).jacobian(unknowns), sp.Matrix(readings)
estimate = list((H.T * H).inv() * H.T * z)
residuals = z - H * sp.Matrix(estimate)
least = residuals.dot(residuals)
