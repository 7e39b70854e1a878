# %% wrong
a_equilibria = a_equilibria[:1]  # Has the quadratic equation for $y_2$ only one root? (hint 2)
# May the signs of the two coordinates be chosen freely, or does the second equation tie one to the
# other? (hint 1)
size = abs(a_equilibria[0][0])
a_equilibria = [[p, q] for p in (size, -size) for q in (size, -size)]
# Is a logarithm zero where its argument is zero? (hint 2)
size = sp.sqrt(a_bound)
a_equilibria = [[size, size], [-size, -size]]
# Was the matrix of one point used at the other one too? (hint 1)
a_spectra = [[*point, *a_spectra[0][2:]] for point in a_equilibria]
# Was the argument of the logarithm differentiated as well? (hint 1)
a_spectra = [
    [p, q, *sp.Matrix([[0, 1], [sp.exp(p), -sp.exp(p)]]).eigenvals()] for p, q in a_equilibria
]
# Is a negative trace enough? What is the sign of the determinant at each point? (hint 1)
a_stable = a_equilibria
# Were the two points swapped? Compare trace and determinant at each of them. (hint 1)
a_stable = [point for point in a_equilibria if list(point) != list(a_stable[0])]
# In which order are the coordinates asked for? (hint 2)
b_equilibria = [[q, p] for p, q in b_equilibria]
# Was a sign lost when one unknown was eliminated? Substitute the points into the linear equation.
# (hint 1)
b_equilibria = [[p - 2 * b_shift, q] for p, q in b_equilibria]
# What is the sign of the derivative of the denominator $y^2 - x$ with respect to $x$? (hint 1)
b_spectra = [[p, q, *sp.Matrix([[1, 2 * q], [1, -b_slope]]).eigenvals()] for p, q in b_equilibria]
# Was the imaginary unit lost under a root? Look at the discriminant once more. (hint 1)
b_spectra = [[p, q, sp.re(v) + sp.im(v), sp.re(w) + sp.im(w)] for p, q, v, w in b_spectra]
b_stable = b_equilibria  # Is one negative eigenvalue enough? (hint 1)
# Are complex eigenvalues a sign of instability, or does their real part decide? (hint 1)
b_stable = []
# Is the argument of the logarithm set to 1 here? The other side is not zero. (hint 2)
c_equilibria = [[0, 0], [c_slope, c_slope**2]]
# Were the signs of the roots of the quadratic reversed? Test the roots in the equation. (hint 1)
c_equilibria = [[-p, q] for p, q in c_equilibria]
# Was the logarithm differentiated without dividing by its argument? (hint 1)
c_spectra = [
    [p, q, *sp.Matrix([[-2 * p, 1], [c_slope - 2 * p, 0]]).eigenvals(multiple=True)]
    for p, q in c_equilibria
]
# Are the eigenvalues of an unstable point asked for as well?
c_spectra = [row for row in c_spectra if list(row[:2]) == list(c_stable[0])]
c_stable = c_equilibria  # Can eigenvalues of opposite signs mean stability? (hint 1)

# %% right
a_equilibria = [{y2: q, y1: p} for p, q in a_equilibria]  # as dicts, the way solve gives them
# decimals to three digits, the points in the other order
a_spectra = [[sp.N(v, 3) for v in row] for row in a_spectra[::-1]]
# exact, by the formula for a quadratic, not simplified
a_spectra = [
    [
        c,
        c,
        *((-sp.exp(c) + sign * sp.sqrt(sp.exp(2 * c) - 8 * c * sp.exp(c))) / 2 for sign in (1, -1)),
    ]
    for c, _ in a_equilibria
]
a_stable = [float(p) for p in a_stable[0]]  # the point alone, as decimals
b_equilibria = sp.Matrix(b_equilibria)  # a matrix with a row for each point
# the roots of (2 lambda + 1 + slope)**2 = (1 - slope)**2 + 8 y, not simplified
b_spectra = [
    [p, q, *((-1 - b_slope + sign * sp.sqrt((1 - b_slope) ** 2 + 8 * q)) / 2 for sign in (1, -1))]
    for p, q in b_equilibria
]
# pairs of a point and its eigenvalues, with decimals
b_spectra = [[(p, q), (complex(v), complex(w))] for p, q, v, w in b_spectra]
b_stable = [{x: p, y: q} for p, q in b_stable]  # as a dict
c_equilibria = [tuple(map(float, point)) for point in c_equilibria]  # tuples of floats
# a matrix, the eigenvalues in the other order
c_spectra = sp.Matrix([[p, q, w, v] for p, q, v, w in c_spectra])
c_spectra = [[sp.N(v, 3) for v in row] for row in c_spectra]  # decimals to three digits
c_stable = [c_stable[0], [float(v) for v in c_stable[0]]]  # twice the same point


# %% numbers
def row(a_root, b_roots, c_roots):
    """The numbers with which a has the roots +-a_root, b and c those given."""
    (p, q), (v, w) = b_roots, c_roots
    return a_root**2 + 1, p + q, -1 - p * q, v + w, 1 - v * w


a_bound, b_slope, b_shift, c_slope, c_bound = [
    row(*roots)
    for roots in [
        (1, (2, -1), (2, -1)),
        (2, (3, -1), (3, -1)),
        (4, (3, -2), (-4, 3)),
        (6, (4, -1), (-5, 6)),
        (3, (4, -2), (1, -2)),
        (5, (5, -2), (5, -1)),
        (7, (6, -4), (1, -4)),
        (8, (5, -3), (-6, 3)),
        (9, (8, -3), (-2, 4)),
        (10, (5, -4), (-4, 2)),
        (14, (4, -3), (5, -2)),
        (13, (7, -4), (-7, 5)),
    ]
]
shown = [
    r"\ln(«a_bound» - y_2^2)",
    r"\dot y = x «+-b_slope*»y «+-b_shift»,",
    r"-\ln(1 «+-c_slope*»y_1 + y_1^2) + \ln «c_bound»",
]


def spectrum(field, state, point):
    """A point with the two eigenvalues there, and whether they have negative real parts."""
    matrix = field.jacobian(state).subs(dict(zip(state, point)))
    half, root = matrix.trace() / 2, sp.sqrt(matrix.trace() ** 2 / 4 - matrix.det())
    return [*point, half + root, half - root], matrix.det() > 0 and half < 0


def answers(field, state, points):
    rows = [spectrum(field, state, point) for point in points]
    return points, [row for row, _ in rows], [row[:2] for row, stable in rows if stable]


size = sp.sqrt(a_bound - 1)
roots = sp.roots(y**2 - b_slope * y - b_shift - 1, y)
c_roots = sp.roots(y**2 - c_slope * y + 1 - c_bound, y)
a_equilibria, a_spectra, a_stable = answers(a_field, a_state, [[size, size], [-size, -size]])
b_equilibria, b_spectra, b_stable = answers(b_field, b_state, [[r**2 - 1, r] for r in roots])
c_equilibria, c_spectra, c_stable = answers(c_field, c_state, [[r, r**2] for r in c_roots])
