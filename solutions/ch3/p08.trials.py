# %% wrong
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 1)
gain = sp.Matrix([-1, -1, -1])
# Are these the coefficients of the polynomial instead of the gain? (hint 1)
gain = sp.Matrix([6, 11, 6])
# Are these differences of coefficients, as in a canonical form? (hint 1)
gain = sp.Matrix([3, 12, 9])
gain = sp.Matrix([2, 2, 2])  # Was the growing root moved too far? (hint 2)
# Is the measurement added, or its difference from what is expected? (hint 1)
equations = [e2 + z, e3 + z, 3 * e1 + e2 - 3 * e3 + z]
# Is it enough to correct the last line alone? (hint 1)
equations = [e2, e3, 3 * e1 + e2 - 3 * e3 + z - 2 * e1 - e2]
# Does this correction have the right sign? (hint 1)
equations = [
    e2 - (z - 2 * e1 - e2),
    e3 - (z - 2 * e1 - e2),
    3 * e1 + e2 - 3 * e3 - (z - 2 * e1 - e2),
]
# What should z be compared with? It is not x itself. (hint 1)
equations = [e2 + z - e1, e3 + z - e1, 3 * e1 + e2 - 3 * e3 + z - e1]

# %% right
gain = [sp.Rational(3, 3), 1.0, 1]  # a flat list
equations = [z - 2 * e1, z - 2 * e1 - e2 + e3, z + e1 - 3 * e3]  # collected
# a matrix equation
equations = sp.Matrix([[e2], [e3], [3 * e1 + e2 - 3 * e3]]) + sp.ones(3, 1) * (z - 2 * e1 - e2)
