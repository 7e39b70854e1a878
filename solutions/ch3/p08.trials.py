# %% wrong
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 1)
gain = -gain
# Are these the coefficients of the polynomial instead of the gain? (hint 1)
gain = sp.Matrix(sp.Poly(prescribed, lam).all_coeffs()[1:])
# Are these differences of coefficients, as in a canonical form? (hint 1)
difference = sp.Poly(prescribed - (lam * sp.eye(3) - A).det(), lam)
gain = sp.Matrix([difference.coeff_monomial(lam**k) for k in (2, 1, 0)])
gain = 2 * gain  # Was the growing root moved too far? (hint 2)
# Is the measurement added, or its difference from what is expected? (hint 1)
equations = list(A * sp.Matrix(estimates) + gain * z)
# Is it enough to correct the last line alone? (hint 1)
e = sp.Matrix(estimates)
equations = list(A * e + sp.Matrix([0, 0, gain[2]]) * (z - (H * e)[0]))
# Does this correction have the right sign? (hint 1)
e = sp.Matrix(estimates)
equations = list(A * e - gain * (z - (H * e)[0]))
# What should z be compared with? It is not x itself. (hint 1)
equations = list(A * sp.Matrix(estimates) + gain * (z - e1))

# %% right
gain = [sp.sympify(gain[0]), float(gain[1]), gain[2]]  # a flat list
# collected
e = sp.Matrix(estimates)
equations = [sp.expand(rate) for rate in A * e + gain * (z - (H * e)[0])]
# a matrix equation
e = sp.Matrix(estimates)
equations = A * e + gain * (z - (H * e)[0])


# %% numbers
def row(growing, kept, moved, weight):
    """The equation with the roots `kept` and one growing root, which is moved."""
    polynomial = sp.Poly((lam - growing) * (lam - kept[0]) * (lam - kept[1]), lam)
    coefficients = [int(c) for c in polynomial.all_coeffs()[:0:-1]]
    return coefficients, weight, [*kept, moved]


coefficients, weight, roots = [
    row(*parts)
    for parts in [
        (1, (-3, -1), -2, 2),
        (1, (-2, -4), -3, 1),
        (2, (-1, -4), -3, 3),
        (3, (-2, -4), -5, 1),
        (1, (-2, -3), -5, 1),
        (2, (-2, -3), -1, 5),
        (4, (-2, -5), -1, 1),
        (2, (-2, -3), -4, 1),
        (2, (-1, -5), -2, 3),
        (3, (-2, -5), -1, 1),
        (2, (-2, -4), -1, 3),
        (1, (-3, -4), -7, 1),
        (1, (-1, -2), -6, 4),
        (1, (-1, -3), -4, 2),
    ]
]
shown = [
    r"\dddot x «+coefficients[2]*»\ddot x «+coefficients[1]*»\dot x «+coefficients[0]*»x = 0, "
    r"\qquad z = \dot x + «weight*»x",
    r"(\lambda + «-roots[0]»)(\lambda + «-roots[1]»)(\lambda + «-roots[2]»)",
]
growing = max(A.eigenvals())
motion = sp.Matrix([1, growing, growing**2])
gain = (growing - roots[2]) / (weight + growing) * motion
e = sp.Matrix(estimates)
equations = list(A * e + gain * (z - (H * e)[0]))
