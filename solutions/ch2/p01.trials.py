# %% wrong
# Which sign do the coefficients of the polynomial have in this form? (hint 2)
a_canonical = sp.Matrix(a_canonical) * sp.diag(-1, 1)
# Is this another canonical form, with the eigenvalues on the diagonal? (hint 1)
a_canonical = sp.diag(*a_matrix.eigenvals())
# Are the two coefficients in the right order? (hint 1)
p, q = sp.Matrix(a_canonical)[:, 0]
a_canonical = sp.Matrix([[q, 1], [p, 0]])
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
a_transformation = sp.Matrix(a_transformation).inv()
# Were the vectors written as columns instead of rows? (hint 1)
a_transformation = sp.Matrix(a_transformation).T
# Is this the controllable canonical form, with the coefficients in the last row? (hint 1)
b_canonical = sp.Matrix(b_canonical)[::-1, ::-1].T
# Is the column of coefficients upside down? (hint 1)
columns = sp.Matrix(b_canonical)
b_canonical = sp.Matrix.hstack(columns[::-1, 0], columns[:, 1:])
# Which sign do the coefficients of the polynomial have in this form?
b_canonical = sp.Matrix(b_canonical) * sp.diag(-1, 1, 1)
# Are these the derivatives of z? The canonical coordinates differ from them. (hint 1)
b_transformation = sp.Matrix.vstack(*(b_output * b_matrix**k for k in range(3)))
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
b_transformation = sp.Matrix(b_transformation).inv()
# Was the matrix used where its transpose belongs? (hint 2)
last, middle, _ = sp.Matrix(b_canonical)[:, 0]
second = b_output * b_matrix.T - last * b_output
b_transformation = sp.Matrix.vstack(b_output, second, second * b_matrix.T - middle * b_output)

# %% right
# floats
import numpy as np

a_canonical = np.array(a_canonical, dtype=float)
# floats
import numpy as np

b_transformation = np.array(b_transformation, dtype=float)

# %% numbers
from workbook.authoring.numbers import linear_form

a_matrix, b_matrix = [
    (sp.Matrix(a), sp.Matrix(b))
    for a, b in [
        ([[1, 1], [1, -1]], [[0, 1, 0], [1, 1, 1], [1, 0, -1]]),
        ([[3, 1], [1, 3]], [[-1, -1, 1], [0, -2, 0], [0, 0, 2]]),
        ([[-1, 2], [3, -2]], [[0, 2, -1], [0, 0, 2], [1, 1, 1]]),
        ([[-1, -2], [-1, 3]], [[2, 0, -2], [0, 1, 1], [0, -1, 0]]),
        ([[-2, 3], [2, 1]], [[0, 0, 1], [0, 1, 1], [2, 1, 1]]),
        ([[-1, 2], [-1, -1]], [[1, -1, 0], [0, 1, -1], [-2, 0, -1]]),
        ([[2, -2], [-1, 2]], [[-1, 1, 1], [0, 0, 2], [-1, 0, 0]]),
        ([[-1, 3], [2, 2]], [[0, 2, 0], [0, -2, 1], [-2, 1, 0]]),
        ([[1, 2], [1, 1]], [[0, 2, 0], [0, 0, 1], [-2, -2, -1]]),
        ([[1, 3], [3, 3]], [[0, 1, 0], [2, -1, 1], [-2, -1, 0]]),
        ([[-1, 1], [2, -2]], [[0, 0, -1], [0, 1, 0], [0, -1, 0]]),
        ([[2, -2], [1, -1]], [[0, -1, 1], [2, 0, 0], [-1, 0, 1]]),
        ([[1, 2], [1, 3]], [[0, 0, 2], [2, 1, -2], [0, 1, 2]]),
        ([[-1, 1], [1, 2]], [[0, 0, 1], [1, -1, -1], [1, -1, 0]]),
    ]
]
x = ["x_1", "x_2", "x_3"]
a_sides = [linear_form(a_matrix.row(k), x) for k in range(2)]
b_sides = [linear_form(b_matrix.row(k), x) for k in range(3)]
shown = [
    r"\dot x_1 = «a_sides[0]»,$ $\quad \dot x_2 = «a_sides[1]»,$ $\quad z = x_1;",
    r"\dot x_1 = «b_sides[0]»,$ $\quad \dot x_2 = «b_sides[1]»,$ "
    r"$\quad \dot x_3 = «b_sides[2]»,$ $\quad z = x_1.",
]


def canonical_form(matrix, row):
    """The matrix of the canonical form, and its coordinates."""
    rows, column = [row], [-c for c in matrix.charpoly().all_coeffs()[1:]]
    for coefficient in column[:-1]:
        rows.append(rows[-1] * matrix - coefficient * row)
    unit = sp.eye(len(column))[:, :-1]
    return sp.Matrix.hstack(sp.Matrix(column), unit), sp.Matrix.vstack(*rows)


a_canonical, a_transformation = canonical_form(a_matrix, a_output)
b_canonical, b_transformation = canonical_form(b_matrix, b_output)
