# %% wrong
# Must the control stand in every equation? Follow what it acts on. (hint 1)
controllable = False
# Were the vectors written as rows? (hint 1)
basis = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, 1, 1]])
basis = sp.eye(3)  # Does any basis of the same subspaces do? (hint 1)
basis = sp.Matrix.hstack(b, A.T * b, A.T**2 * b)  # Was the transposed matrix applied? (hint 1)
# Is this the canonical form, which belongs to another basis? (hint 1)
matrix = sp.Matrix([[0, 1, 0], [0, 0, 1], [2, 2, 0]])
# Does the inverse stand on the right side? (hint 1)
P = sp.Matrix([[1, 0, 1], [0, 1, 1], [0, 0, 1]])
matrix = P * A * P.inv()
# Which sign have the coefficients of the polynomial here? (hint 2)
matrix = sp.Matrix([[0, 0, -2], [1, 0, -2], [0, 1, 0]])
# Do the coefficients stand in the right order? (hint 2)
matrix = sp.Matrix([[0, 0, 0], [1, 0, 2], [0, 1, 2]])
# Was the polynomial forgotten, so that these are only the vectors in the opposite order? (hint 2)
canonical_basis = sp.Matrix([[1, 0, 1], [1, 1, 0], [1, 0, 0]])
# Does this lead from x to the coordinates, instead of from them to x? (hint 1)
canonical_basis = sp.Matrix([[0, 0, 1], [0, 1, -1], [1, 0, 1]])
# Is a coefficient added where it has to be subtracted? (hint 1)
canonical_basis = sp.Matrix([[3, 0, 1], [1, 1, 0], [1, 0, 0]])

# %% right
# columns of floats
import numpy as np

g = [np.array(b, dtype=float).ravel()]
for _ in range(2):
    g.append(np.array(A, dtype=float) @ g[-1])
basis = np.column_stack(g)
# carried over, in floats
import numpy as np

P = np.array([[1.0, 0, 1], [0, 1, 1], [0, 0, 1]])
matrix = np.linalg.solve(P, np.array(A, dtype=float) @ P)
