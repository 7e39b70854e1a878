# %% wrong
# Were the complex eigenvalues left out? (hint 1)
a_region = sp.Ne(alpha, max(a_uncontrolled))
# Are these the exceptional values instead of all others? (hint 1)
a_region = sp.Or(*(sp.Eq(alpha, value) for value in a_uncontrolled))
# Does the sign of the determinant matter, or only whether it vanishes? (hint 1)
a_region = sp.And(sp.Ne(alpha, min(a_uncontrolled)), alpha < max(a_uncontrolled))
# Is one combination the whole basis at each of these values? (hint 2)
a_uncontrolled = {value: rows[:1] for value, rows in a_uncontrolled.items()}
# Is one of these bases a basis of the controllable part? (hint 1)
a_uncontrolled = {
    value: rows if len(rows) > 1 else [list(v.subs(alpha, value)) for v in (B_a, A_a * B_a)]
    for value, rows in a_uncontrolled.items()
}
# Is one of these an eigenvector of A instead of a left one? (hint 1)
value, rows = min(b_uncontrolled.items(), key=lambda item: len(item[1]))
w = sp.Matrix([rows[0]])
eigenvalue = (w * A_b * w.T)[0] / (w * w.T)[0]
b_uncontrolled = b_uncontrolled | {value: [list((A_b - eigenvalue * sp.eye(3)).nullspace()[0])]}
# Was one factor of the determinant overlooked? (hint 1)
b_region = sp.Ne(alpha, max(b_uncontrolled))
# Does the sign of a factor matter here, or only its zero? (hint 1)
b_region = sp.And(alpha > min(b_uncontrolled), alpha < max(b_uncontrolled))
# Is one row the whole basis at each of these values? (hint 2)
b_uncontrolled = {value: rows[:1] for value, rows in b_uncontrolled.items()}
# Were the two values swapped? (hint 2)
p, q = b_uncontrolled
b_uncontrolled = {p: b_uncontrolled[q], q: b_uncontrolled[p]}
# Were the roots taken with the wrong sign? (hint 1)
c_region = sp.And(*(sp.Ne(alpha, -value) for value in c_uncontrolled))
# Is a double eigenvalue without growth harmless? (hint 1)
c_region = sp.Ne(alpha, min(c_uncontrolled))
# Does a squared factor always mean two uncontrollable combinations? (hint 1)
c_uncontrolled = {
    value: [*rows, [1, 0, 0]] if value == max(c_uncontrolled) else rows
    for value, rows in c_uncontrolled.items()
}
# Was one of the values overlooked? (hint 1)
c_uncontrolled = dict([min(c_uncontrolled.items())])
# Were only some of the coordinates considered? (hint 1)
d_region = sp.Ne(2 * alpha**2 + 2 * alpha + 1, 0)
# Is the system uncontrollable at a single value only? Look at the rows of W first. (hint 1)
d_region = sp.Ne(alpha, 1)
# Does it matter at which value the control enters fewer equations? (hint 1)
d_region = sp.Ne(alpha, 0)
# Is everything controllable? Look for a combination whose derivative does not contain u. (hint 1)
d_uncontrolled = []
# Was a sign lost? Does the control enter this combination? (hint 1)
d_uncontrolled = [[d_uncontrolled[0][0], -d_uncontrolled[0][1], 0]]
d_uncontrolled = [d_uncontrolled[0], [0, 0, 1]]  # Is one row too many here? (hint 2)

# %% right
# the determinant
a_region = sp.Ne(sp.factor(sp.Matrix.hstack(B_a, A_a * B_a, A_a**2 * B_a).det()), 0)
# another basis
a_uncontrolled = {
    float(value): [[2 * p + q for p, q in zip(rows[0], rows[-1])], *rows[1:]]
    for value, rows in a_uncontrolled.items()
}
# matrices with the basis as columns
a_uncontrolled = {value: -2 * sp.Matrix(rows).T for value, rows in a_uncontrolled.items()}
# the absolute value
p, q = b_uncontrolled
b_region = sp.Ne(sp.Abs(alpha - (p + q) / sp.Integer(2)), abs(p - q) / sp.Integer(2))
# three intervals
p, q = sorted(b_uncontrolled)
b_region = sp.Or(alpha < p, sp.And(alpha > p, alpha < q), alpha > q)
# another basis
b_uncontrolled = {
    value: [tuple(p - 3 * q for p, q in zip(rows[0], rows[-1])), *rows[1:]]
    for value, rows in b_uncontrolled.items()
}
# a list of rows, floats
import numpy as np

b_uncontrolled = {
    float(value): [sp.Matrix([row]) for row in rows]
    if len(rows) > 1
    else np.array(rows, dtype=float) / 2
    for value, rows in b_uncontrolled.items()
}
# the roots of a parabola
p, q = c_uncontrolled
c_region = sp.Ne(sp.expand((alpha - p) * (alpha - q)), 0)
# as a solver of linear equations gives it
W = sp.Matrix.hstack(B_c, A_c * B_c, A_c**2 * B_c)
c_uncontrolled = {value: W.subs(alpha, value).T.nullspace() for value in c_uncontrolled}
# columns of another length
c_uncontrolled = {value: -sp.Matrix(rows[0]) / 2 for value, rows in c_uncontrolled.items()}
d_region = sp.S.EmptySet  # the empty set
d_region = sp.And(alpha < 0, alpha > 1)  # a condition that nothing satisfies
d_uncontrolled = (tuple(-w for w in d_uncontrolled[0]),)  # the other sign, as a tuple
# a length that depends on alpha but is never zero
d_uncontrolled = [[(1 + alpha**2) * w for w in d_uncontrolled[0]]]


# %% numbers
from workbook.authoring.numbers import linear_form


def sheared(A, row, column, factor):
    """The matrix after a multiple of one coordinate is added to another."""
    T = sp.eye(3)
    T[row, column] = factor
    return T * A * T.inv()


def changed(a, b, c, d):
    """The systems with alpha moved by a, b, c, and other rows lost in d."""
    matrices = [sheared(A_a, 0, 1, a), sheared(A_b, 2, 0, b), sheared(A_c, 1, 0, c)]
    return *matrices, sheared(A_d, 1, 0, d), sp.Matrix([1, 1 + d, alpha])


A_a, A_b, A_c, A_d, B_d = [
    changed(*factors)
    for factors in [
        (0, 0, 0, 0),
        (1, 1, 1, 1),
        (2, -1, -1, -2),
        (-1, 2, 2, -3),
        (-2, -4, -3, 2),
        (-3, -2, -5, -3),
        (3, -7, -2, -3),
        (-4, 4, 4, -3),
        (5, -3, 5, 3),
        (4, 7, -4, 1),
        (7, 5, 3, -3),
        (-5, 3, 7, 6),
        (-6, -5, 6, 3),
        (6, 6, -7, 1),
    ]
]


def side(A, B, k):
    return linear_form([*A.row(k), B[k]], ["x_1", "x_2", "x_3", "u"])


shown = [
    f"{item}) $\\quad\\dot x_1 = «side(A_{item}, B_{item}, 0)»,$ "
    f"$\\quad \\dot x_2 = «side(A_{item}, B_{item}, 1)»,$ "
    f"$\\quad \\dot x_3 = «side(A_{item}, B_{item}, 2)»"
    for item in "abcd"
]


def lost(A, B):
    """The values of alpha at which the rank falls, with the rows that are lost there."""
    W = sp.Matrix.hstack(B, A * B, A**2 * B)
    return {
        value: [list(w) for w in W.subs(alpha, value).T.nullspace()]
        for value in sp.roots(W.det(), alpha)
    }


def region(values):
    return sp.And(*(sp.Ne(alpha, value) for value in values))


a_uncontrolled, b_uncontrolled, c_uncontrolled = lost(A_a, B_a), lost(A_b, B_b), lost(A_c, B_c)
a_region, b_region, c_region = (
    region(a_uncontrolled),
    region(b_uncontrolled),
    region(c_uncontrolled),
)
d_uncontrolled = [[B_d[1], -B_d[0], 0]]
