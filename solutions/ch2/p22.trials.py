# %% wrong
# Does the trace have the right sign? (hint 2)
first_equation = sp.Eq(x1.diff(t, 2) + A.trace() * x1.diff(t) + A.det() * x1, A[0, 1] * u1)
# How do the off-diagonal elements enter the determinant? (hint 2)
product = A[0, 0] * A[1, 1] + A[0, 1] * A[1, 0]
first_equation = sp.Eq(x1.diff(t, 2) - A.trace() * x1.diff(t) + product * x1, A[0, 1] * u1)
# Was $x_2$ left out of the second equation? (hint 1)
first_equation = sp.Eq(x1.diff(t, 2), A[0, 0] * x1.diff(t) + A[0, 1] * (A[1, 0] * x1 + u1))
# Was the control differentiated together with the equation? (hint 2)
second_equation = sp.Eq(x2.diff(t, 2) - A.trace() * x2.diff(t) + A.det() * x2, u1)
# Was the control lost where $x_1$ was replaced? (hint 1)
second_equation = sp.Eq(x2.diff(t, 2) - A.trace() * x2.diff(t) + A.det() * x2, u1.diff(t))
# Was a sign lost where $x_1$ was replaced? (hint 1)
second_equation = sp.Eq(
    x2.diff(t, 2) - A.trace() * x2.diff(t) + A.det() * x2, u1.diff(t) + A[0, 0] * u1
)
coordinate = [0, 1]  # Is this the coordinate that the control enters directly? (hint 1)
# Which sign does the control have in the equation of this coordinate? (hint 2)
coordinate = [-c for c in coordinate]

# %% right
# solved for the second derivative
first_equation = sp.Eq(x1.diff(t, 2), A.trace() * x1.diff(t) - A.det() * x1 + A[0, 1] * u1)
# in brackets, with functions of one's own
s = sp.Symbol("t")
X, U = sp.Function("x1")(s), sp.Function("u1")(s)
inner = X.diff(s) - A[0, 0] * X
first_equation = sp.Eq(A[0, 1] * U, inner.diff(s) - A[1, 1] * inner - A[0, 1] * A[1, 0] * X)
# all on one side, times 3
second_equation = sp.Eq(
    3 * x2.diff(t, 2)
    - 3 * A.trace() * x2.diff(t)
    + 3 * A.det() * x2
    - 3 * u1.diff(t)
    + 3 * A[0, 0] * u1,
    0,
)
# a derivative that is not carried out
inner = x2.diff(t) - A[1, 1] * x2 - u1
second_equation = sp.Eq(sp.Derivative(inner, t), A[0, 0] * inner + A[0, 1] * A[1, 0] * x2)

# %% numbers
from workbook.authoring.numbers import linear_form

A = [
    sp.Matrix([[p, q], [r, s]])
    for p, q, r, s in [
        (1, 1, -3, 1),
        (2, 3, -1, 1),
        (1, 2, 3, -2),
        (3, -2, 1, 1),
        (-1, 4, 2, 2),
        (2, -3, 1, -1),
        (-1, -1, -1, -1),
        (-2, 5, -1, 1),
        (2, -5, 1, -1),
        (-1, 6, -1, -1),
        (2, -4, 1, 2),
        (2, -6, 1, -1),
        (-2, -7, -1, -1),
        (-1, 7, -1, -1),
    ]
]
sides = [linear_form([*A.row(k), b[k]], ["x_1", "x_2", "u_1"]) for k in range(2)]
shown = [r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]»"]
first_equation = sp.Eq(x1.diff(t, 2) - A.trace() * x1.diff(t) + A.det() * x1, A[0, 1] * u1)
second_equation = sp.Eq(
    x2.diff(t, 2) - A.trace() * x2.diff(t) + A.det() * x2, u1.diff(t) - A[0, 0] * u1
)
coordinate = [sp.Rational(1, A[0, 1]), 0]
