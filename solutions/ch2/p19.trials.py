# %% wrong
controllable = False  # neither u nor x1 stands in the third equation
basis = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, 1, 1]])  # the vectors as rows
basis = sp.eye(3)  # what is new in each vector only, as if any basis of the same subspaces would do
basis = sp.Matrix.hstack(b, A.T*b, A.T**2*b)  # the transposed matrix applied: the rows of an observability matrix
matrix = sp.Matrix([[0, 1, 0], [0, 0, 1], [2, 2, 0]])  # the canonical form (2.4), which belongs to another basis
# the inverse on the wrong side
P = sp.Matrix([[1, 0, 1], [0, 1, 1], [0, 0, 1]])
matrix = P*A*P.inv()
matrix = sp.Matrix([[0, 0, -2], [1, 0, -2], [0, 1, 0]])  # the coefficients of the polynomial with their own signs
matrix = sp.Matrix([[0, 0, 0], [1, 0, 2], [0, 1, 2]])  # the coefficients in the order of the powers from above
# the vectors g^i from the last to the first: the polynomial forgotten
canonical_basis = sp.Matrix([[1, 0, 1], [1, 1, 0], [1, 0, 0]])
canonical_basis = sp.Matrix([[0, 0, 1], [0, 1, -1], [1, 0, 1]])  # the matrix of the coordinates, zeta from x
canonical_basis = sp.Matrix([[3, 0, 1], [1, 1, 0], [1, 0, 0]])  # the coefficient added where it is to be subtracted

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
