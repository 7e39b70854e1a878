# %% wrong
# Does an output show everything because it contains both x and its rate? (hint 1)
printed_obstacle = {}
# Does this motion decay, and is it really hidden? (hint 1)
printed_obstacle = {-margin: [1, -margin, margin**2]}
# Is the fastest motion the unobservable one? (hint 1)
fast = max(A.eigenvals())
printed_obstacle = {fast: [1, fast, fast**2]}
# Is a degree of stability reached where a root lies just on its border? (hint 1)
margins = mu < margin
margins = sp.true  # Does a hidden mode that decays impose no limit? (hint 1)
margins = sp.false  # Does every unobservable motion rule out an observer? (hint 1)
gain = sp.Matrix([0, 0, 0])  # Do the errors decay without a correction? (hint 1)
# Is this the sign of a feedback $u = Kx$? The correction enters the errors with a minus. (hint 1)
gain = -gain
# Were the corrections of the new coordinate used for x? (hint 1)
gain = sp.Matrix([gain[1], gain[2] + margin * gain[1], 0])
# Is it impossible because the system is not observable? How fast does the hidden motion decay?
# (hint 1)
gain = []
# Do all roots lie far enough to the left? (hint 1)
gain = family.subs({beta1: 1, beta2: 0})
family = weights[1] * family  # Was the factor of the measurement forgotten? (hint 1)
family = []  # Is a polynomial with the right factor impossible? (hint 1)

# %% right
# another multiple, decimals
(growing,) = printed_obstacle
printed_obstacle = {float(growing): -2 * sp.Matrix([1, growing, growing**2])}
margins = sp.Not(mu > margin)  # the complement
gain = gain + 2 * sp.Matrix([1, -margin, margin**2])  # another correction of the first equation
# other roots of y, a flat list
gain = list(family.subs({beta1: 4 * margin, beta2: 7 * margin**2}))
# no correction of the last equation
gain = gain - gain[2] * sp.Matrix([1, -margin, margin**2]) / margin**2
# no correction of the second equation
family = family + family[1] * sp.Matrix([1, -margin, margin**2]) / margin


# %% numbers
def row(growing, fast, margin, factor):
    """The equation with two growing roots, of which the printed z does not show the first."""
    polynomial = sp.Poly((lam - growing) * (lam - fast) * (lam + margin), lam)
    coefficients = [int(c) for c in polynomial.all_coeffs()[:0:-1]]
    return coefficients, [-factor * growing, factor], [factor * margin, factor], margin


coefficients, printed, weights, margin = [
    row(*parts)
    for parts in [
        (1, 3, 1, 2),
        (4, 5, 5, 2),
        (5, 8, 7, 3),
        (6, 8, 6, 3),
        (7, 9, 11, 3),
        (3, 4, 2, 2),
        (8, 10, 4, 3),
        (2, 5, 3, 2),
        (9, 11, 9, 3),
        (11, 12, 8, 4),
        (10, 11, 12, 3),
        (13, 14, 14, 2),
        (14, 15, 10, 2),
        (12, 14, 13, 2),
    ]
]
numerals = [
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
]
shown = [
    r"\dddot x «+coefficients[2]*»\ddot x «+coefficients[1]*»\dot x «+coefficients[0]*»x = 0 .",
    "degree of stability «numerals[margin - 1]»",
    r"$\lambda_0 = «margin»$",
    r"$z = «printed[1]*»\dot x «+printed[0]*»x$",
    r"$z = «weights[1]*»\dot x «+weights[0]*»x$",
    r"the degree of stability «margin»;",
    r"(\lambda + «margin»)(\lambda^2 + \beta_1\lambda + \beta_2)",
    r"(\lambda + «margin»)(\lambda^2 + \beta_1 \lambda + \beta_2)",
    r"$y = \dot x + «margin*»x$",
    "$z = «weights[1]*»y$",
]
growing = -sp.Rational(printed[0], printed[1])
printed_obstacle = {growing: [1, growing, growing**2]}
margins = mu <= margin
l2, l3 = sp.symbols("l2 l3")
of_errors = (A - sp.Matrix([0, l2, l3]) * H).charpoly(lam).as_expr(lam)
family = sp.Matrix([0, l2, l3]).subs(sp.solve(sp.Poly(of_errors - wanted, lam).coeffs(), [l2, l3]))
gain = family.subs({beta1: 2 * margin, beta2: margin**2})
