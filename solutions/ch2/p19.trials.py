# %% wrong
# Must the control appear in every equation? Follow what it acts on. (hint 1)
controllable = False
# Were the vectors written as rows? (hint 1)
basis = sp.Matrix(basis).T
basis = sp.eye(3)  # Does any basis of the same subspaces do? (hint 1)
basis = sp.Matrix.hstack(b, A.T * b, A.T**2 * b)  # Was the transposed matrix applied? (hint 1)
# Is this the canonical form, which belongs to another basis? (hint 1)
matrix = sp.Matrix(matrix).T
# Is the inverse on the correct side? (hint 1)
P = sp.Matrix(basis)
matrix = P * A * P.inv()
# What is the sign of the coefficients of the polynomial here? (hint 2)
matrix = sp.Matrix(matrix) * sp.diag(1, 1, -1)
# Are the coefficients in the right order? (hint 2)
columns = sp.Matrix(matrix)
matrix = sp.Matrix.hstack(columns[:, :2], columns[::-1, 2])
# Was the polynomial forgotten, so that these are only the vectors in the opposite order? (hint 2)
canonical_basis = sp.Matrix(basis)[:, ::-1]
# Does this lead from x to the coordinates, instead of from them to x? (hint 1)
canonical_basis = sp.Matrix(canonical_basis).inv()
# Is a coefficient added where it has to be subtracted? (hint 1)
canonical_basis = 2 * sp.Matrix(basis)[:, ::-1] - sp.Matrix(canonical_basis)

# %% right
# columns of floats
import numpy as np

g = [np.array(b, dtype=float).ravel()]
for _ in range(2):
    g.append(np.array(A, dtype=float) @ g[-1])
basis = np.column_stack(g)
# carried over, in floats
import numpy as np

P = np.array(basis, dtype=float)
matrix = np.linalg.solve(P, np.array(A, dtype=float) @ P)

# %% numbers
from workbook.authoring.numbers import linear_form

A = [
    sp.Matrix(rows)
    for rows in [
        [[0, 1, 1], [1, 1, 0], [0, 1, -1]],
        [[-2, 0, -2], [2, 0, 1], [0, -1, 1]],
        [[0, 1, 0], [-1, 1, 2], [0, 2, 2]],
        [[2, 1, 2], [1, -1, 0], [0, 2, 0]],
        [[2, 0, 2], [-1, 0, 2], [0, 1, -2]],
        [[0, -1, -2], [2, 0, 0], [0, -1, -1]],
        [[1, 1, 0], [2, 0, 1], [0, 1, 2]],
        [[-1, -2, 0], [1, -1, 2], [0, 1, 0]],
        [[-2, 2, 0], [-1, 2, -1], [0, -1, 0]],
        [[0, 1, 0], [2, 1, 2], [0, 1, -2]],
        [[-1, 0, -2], [-1, 0, 1], [0, -1, 2]],
        [[1, 0, 2], [1, 0, -2], [0, 1, 2]],
        [[1, -1, 2], [1, 0, 1], [0, 2, 0]],
        [[0, -2, 0], [-1, 2, -1], [0, 2, -1]],
    ]
]
sides = [linear_form([*A.row(k), b[k]], ["x_1", "x_2", "x_3", "u"]) for k in range(3)]
shown = [
    r"\dot x_1 = «sides[0]», \qquad \dot x_2 = «sides[1]», \qquad \dot x_3 = «sides[2]» ,",
]
basis = sp.Matrix.hstack(b, A * b, A**2 * b)
matrix = basis.inv() * A * basis
middle, last = matrix[1, 2], matrix[2, 2]
canonical_basis = basis * sp.Matrix([[-middle, -last, 1], [-last, 1, 0], [1, 0, 0]])
