# %% wrong
# Which sign do the coefficients of the polynomial have in this form? (hint 2)
a_canonical = sp.Matrix([[0, 1], [-2, 0]])
# Is this another canonical form, with the eigenvalues on the diagonal? (hint 1)
a_canonical = sp.diag(sp.sqrt(2), -sp.sqrt(2))
# Do the two coefficients stand in the right order? (hint 1)
a_canonical = sp.Matrix([[2, 1], [0, 0]])
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
a_transformation = sp.Matrix([[1, 0], [-1, 1]])
# Were the vectors written as columns instead of rows? (hint 1)
a_transformation = sp.Matrix([[1, 1], [0, 1]])
# Is this the form by control, with the coefficients in the last row? (hint 1)
b_canonical = sp.Matrix([[0, 1, 0], [0, 0, 1], [2, 2, 0]])
# Is the column of coefficients upside down? (hint 1)
b_canonical = sp.Matrix([[2, 1, 0], [2, 0, 1], [0, 0, 0]])
# Which sign do the coefficients of the polynomial have in this form?
b_canonical = sp.Matrix([[0, 1, 0], [-2, 0, 1], [-2, 0, 0]])
# Are these the derivatives of z? The canonical coordinates differ from them. (hint 1)
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, 1, 1]])
# Does this lead from the new coordinates to the old ones, instead of the other way? (hint 1)
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 0], [1, -1, 1]])
# Was the matrix used where its transpose belongs? (hint 2)
b_transformation = sp.Matrix([[1, 0, 0], [0, 1, 1], [-1, 2, -1]])

# %% right
# floats
import numpy as np

a_canonical = np.array([[0.0, 1.0], [2.0, 0.0]])
# floats
import numpy as np

b_transformation = np.array([[1.0, 0, 0], [0, 1, 0], [-1, 1, 1]])
