# %% wrong
value = next(iter(uncontrollable_rows))
possible = sp.Ne(alpha, -value)  # Was a sign lost in the determinant? (hint 2)
# Is this the determinant of A instead of that of W? (hint 2)
possible = sp.Ne(A.det(), 0)
possible = True  # Is it enough that the characteristic polynomial exists? (hint 1)
uncontrollable_rows = {
    value: [[1, 1]] for value in uncontrollable_rows
}  # Is this the controllable direction? (hint 1)
# Is this a right eigenvector where a left one is needed? (hint 2)
value = next(iter(uncontrollable_rows))
matrix = A.subs(alpha, value)
uncontrollable_rows = {value: [list((matrix - (A[0, 0] - A[1, 0]) * sp.eye(2)).nullspace()[0])]}
# Is this the observable canonical form? (hint 1)
canonical = sp.Matrix(canonical)[::-1, ::-1].T
# What is the sign of the coefficients of the polynomial in this form? (hint 1)
canonical = sp.diag(1, -1) * sp.Matrix(canonical)
# Are these the columns of W, which lead to another form? (hint 1)
basis = sp.Matrix.hstack(A * b, b)
basis = sp.Matrix(basis)[:, ::-1]  # Are the columns in the right order? (hint 1)
coordinate = [1, -1]  # Is the direction right and its factor missing? (hint 2)
# Was a column of P taken where a row of its inverse is needed? (hint 1)
coordinate = list(sp.Matrix(basis)[:, 0])
# Is this the equation of another variable? (hint 1)
equation = sp.Eq(
    y.diff(t, 2) - A.trace() * y.diff(t) + A.det() * y, u.diff(t) + (A[1, 0] - A[0, 0]) * u
)
# Does the control have a factor that it lacks in the canonical form? (hint 1)
factor = alpha - next(iter(uncontrollable_rows))
equation = sp.Eq(y.diff(t, 2) - A.trace() * y.diff(t) + A.det() * y, factor * u)
# Did the signs of the terms change when they were moved to the left? (hint 1)
equation = sp.Eq(y.diff(t, 2) + A.trace() * y.diff(t) - A.det() * y, u)

# %% right
value = next(iter(uncontrollable_rows))
possible = sp.Or(alpha < value, alpha > value)  # two half-lines
# another length, a row of a matrix
uncontrollable_rows = {float(value): [sp.Matrix([[-2, 2]])] for value in uncontrollable_rows}
# the left eigenvector computed
import numpy as np

value = next(iter(uncontrollable_rows))
values, rows = np.linalg.eig(np.array(A.subs(alpha, value).T, dtype=float))
uncontrollable_rows = {value: [rows[:, int(np.argmin(abs(values - float(A[0, 0] - A[1, 0]))))]]}
# solved for the second derivative
equation = sp.Eq(y.diff(t, 2), A.trace() * y.diff(t) - A.det() * y + u)
# multiplied by a number, with functions of one's own
s, q = sp.symbols("t alpha")
Y, U = sp.Function("y"), sp.Function("u")
last = sp.expand(2 * A.det().subs(alpha, q))
equation = sp.Eq(2 * U(s), 2 * sp.diff(Y(s), s, s) - sp.diff(2 * A.trace() * Y(s), s) + last * Y(s))

# %% numbers
from workbook.authoring.numbers import linear_form

A = [
    sp.Matrix([[p, alpha], [q, r]])
    for p, q, r in [
        (1, -3, -2),
        (1, -3, -3),
        (2, -2, -1),
        (1, -1, 3),
        (-1, 3, -2),
        (-3, 3, -2),
        (2, -1, -1),
        (2, -2, 1),
        (2, -2, 3),
        (-2, 2, 3),
        (1, -3, 2),
        (-3, 3, -1),
        (1, 2, 2),
        (3, -3, -2),
    ]
]
sides = [linear_form([*A.row(k), b[k]], ["x_1", "x_2", "u"]) for k in range(2)]
shown = [r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]»"]
value = A[1, 0] + A[1, 1] - A[0, 0]
possible = sp.Ne(alpha, value)
uncontrollable_rows = {value: [[1, -1]]}
canonical = sp.Matrix([[0, 1], [-A.det(), A.trace()]])
basis = sp.Matrix.hstack(A * b - A.trace() * b, b)
coordinate = [1 / (alpha - value), -1 / (alpha - value)]
equation = sp.Eq(y.diff(t, 2) - A.trace() * y.diff(t) + A.det() * y, u)
