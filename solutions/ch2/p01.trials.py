# %% wrong
a_canonical = sp.Matrix([[0, 1], [-2, 0]])  # the coefficient of the polynomial with its own sign
a_canonical = sp.diag(sp.sqrt(2), -sp.sqrt(2))  # another canonical form: the eigenvalues on the diagonal
a_canonical = sp.Matrix([[2, 1], [0, 0]])  # the two coefficients in the order of the polynomial's constant term first
a_transformation = sp.Matrix([[1, 0], [-1, 1]])  # x = T xi instead of xi = T x
a_transformation = sp.Matrix([[1, 1], [0, 1]])  # the vectors f_i as columns
# the coefficients in the last row, as in the form by control
b_canonical = sp.Matrix([[0, 1, 0], [0, 0, 1], [2, 2, 0]])
b_canonical = sp.Matrix([[2, 1, 0], [2, 0, 1], [0, 0, 0]])  # the column upside down
b_canonical = sp.Matrix([[0, 1, 0], [-2, 0, 1], [-2, 0, 0]])  # the coefficients of the polynomial with their own signs
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, 1, 1]])  # the derivatives of z taken for the coordinates: T = N
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, -1, 1]])  # x = T xi instead of xi = T x
# A in the place of its transpose in g2 = A'g1, g3 = A'g2
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 1], [-1, 2, -1]])

# %% right
# floats
import numpy as np
a_canonical = np.array([[0.0, 1.0], [2.0, 0.0]])
# floats
import numpy as np
b_transformation = np.array([[1.0, 0, 0], [0, 1, 0], [-1, 1, 1]])
