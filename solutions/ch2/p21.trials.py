# %% wrong
possible = sp.Ne(beta, max(uncontrollable_rows))  # Was one of the two roots overlooked? (hint 2)
# The form does not depend on the parameter. But can the system always be brought to it? (hint 1)
possible = True
# Are these the values at which one element of P vanishes? (hint 2)
possible = sp.And(*(sp.Ne(element, 0) for element in sp.Matrix(basis)[:, 0]))
# Were the two combinations swapped? (hint 1)
p, q = uncontrollable_rows
uncontrollable_rows = {p: uncontrollable_rows[q], q: uncontrollable_rows[p]}
# Are these right eigenvectors where left ones are needed? (hint 2)
p, q = uncontrollable_rows
uncontrollable_rows = {p: [[q, 1]], q: [[p, 1]]}
canonical = sp.Matrix(canonical)[::-1, ::-1].T  # Is this the observable canonical form?
# In which order are the coefficients in the last row? (hint 1)
canonical = sp.Matrix([[0, 1], [A.trace(), -A.det()]])
# Was a coefficient of the polynomial added instead of subtracted? (hint 1)
basis = sp.Matrix.hstack(A * b + A.trace() * b, b)
# Does this lead from x to the new coordinates, instead of from them to x? (hint 1)
basis = sp.Matrix(basis).inv()
coordinate = [-c for c in coordinate]  # What must the sign of c A b be?
# Must c be parallel to b, or such that u drops out? (hint 1)
coordinate = [-coordinate[1], coordinate[0]]
# Is this the equation of one of the given coordinates? (hint 1)
equation = sp.Eq(
    y.diff(t, 2) - A.trace() * y.diff(t) + A.det() * y,
    u.diff(t) + (A[1, 0] * beta - A[0, 0]) * u,
)
# Did the signs of the terms change when they were moved to the left? (hint 1)
equation = sp.Eq(y.diff(t, 2) + A.trace() * y.diff(t) - A.det() * y, u)
# Is this the equation of a single mode? (hint 1)
equation = sp.Eq(y.diff(t) - min(A.eigenvals()) * y, (beta - max(uncontrollable_rows)) * u)

# %% right
possible = sp.Ne(sp.expand(sp.Matrix.hstack(b, A * b).det()), 0)  # the determinant
# three intervals
p, q = sorted(map(float, uncontrollable_rows))
possible = sp.Union(sp.Interval.open(-sp.oo, p), sp.Interval.open(p, q), sp.Interval.open(q, sp.oo))
uncontrollable_rows = {
    float(p): [[-3, 3 * p]] for p in uncontrollable_rows
}  # decimals as the values, other lengths
uncontrollable_rows = {
    p: [sp.Matrix([[-2, 2 * p]])] for p in uncontrollable_rows
}  # rows as matrices
# an array
import numpy as np

canonical = np.array([[0.0, 1], [float(-A.det()), float(A.trace())]])
# multiplied out, a list
d = sp.expand((b.T * sp.Matrix([[0, -1], [1, 0]]) * A * b)[0])
coordinate = [1 / d, -beta / d]
# by the modes
coordinate = [sp.apart(sp.cancel(c), beta) for c in coordinate]
# solved for u
equation = sp.Eq(u, A.det() * y - A.trace() * y.diff(t) + y.diff(t, 2))
# in factors, one bracket after the other
p, q = A.eigenvals()
inner = y.diff(t) - p * y
equation = sp.Eq(inner.diff(t) - q * inner - u, 0)


# %% numbers
from workbook.authoring.numbers import linear_form


def matrix(p, q, v, w):
    """The matrix with the eigenvectors (p, 1), (q, 1) of the eigenvalues v, w."""
    P = sp.Matrix([[p, q], [1, 1]])
    return P * sp.diag(v, w) * P.inv()


A = [
    matrix(*parts)
    for parts in [
        (1, sp.Rational(1, 2), -1, -3),
        (2, 1, -2, -3),
        (3, 2, -1, -2),
        (1, -2, -1, -4),
        (1, 4, -1, -7),
        (-1, -2, -2, -5),
        (2, -2, -1, -5),
        (-1, 0, -3, -4),
        (4, -1, -1, -6),
        (-3, -2, -2, -7),
        (-1, -3, -2, -4),
        (2, -1, -4, -7),
        (1, 3, -2, -6),
        (-1, 3, -3, -7),
    ]
]
sides = [linear_form([*A.row(k), b[k]], ["x_1", "x_2", "u"]) for k in range(2)]
shown = [r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]»"]
values = [vectors[0][0] / vectors[0][1] for _, _, vectors in A.eigenvects()]
possible = sp.And(*(sp.Ne(beta, value) for value in values))
uncontrollable_rows = {value: [[1, -value]] for value in values}
canonical = sp.Matrix([[0, 1], [-A.det(), A.trace()]])
basis = sp.Matrix.hstack(A * b - A.trace() * b, b)
c = sp.Matrix([[1, -beta]])
coordinate = list(c / sp.factor((c * A * b)[0]))
equation = sp.Eq(y.diff(t, 2) - A.trace() * y.diff(t) + A.det() * y, u)
