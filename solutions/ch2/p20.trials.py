# %% wrong
possible = sp.Ne(alpha, 6)  # Was a sign lost in the determinant? (hint 2)
# Is this the determinant of A instead of that of W? (hint 2)
possible = sp.Ne(alpha, sp.Rational(2, 3))
possible = True  # Is it enough that the characteristic polynomial exists? (hint 1)
lost = {-6: [[1, 1]]}  # Is this the direction that is controlled? (hint 1)
lost = {-6: [[2, -1]]}  # Is this a right eigenvector where a left one is needed? (hint 2)
canonical = sp.Matrix([[-1, 1], [2 - 3 * alpha, 0]])  # Is this the form by observation? (hint 1)
# Which sign have the coefficients of the polynomial in this form? (hint 1)
canonical = sp.Matrix([[0, 1], [3 * alpha - 2, 1]])
# Are these the columns of W, which lead to another form? (hint 1)
basis = sp.Matrix([[1 + alpha, 1], [-5, 1]])
# Do the columns stand in the right order? (hint 1)
basis = sp.Matrix([[1, alpha + 2], [1, -4]])
coordinate = [1, -1]  # Is the direction right and its factor missing? (hint 2)
# Was a column of P taken where a row of its inverse is needed? (hint 1)
coordinate = [alpha + 2, -4]
# Is this the equation of another variable? (hint 1)
equation = sp.Eq(y.diff(t, 2) + y.diff(t) + (3 * alpha - 2) * y, u.diff(t) - 4 * u)
# Is a factor of the control left that the canonical coordinate has not? (hint 1)
equation = sp.Eq(y.diff(t, 2) + y.diff(t) + (3 * alpha - 2) * y, (alpha + 6) * u)
# Did the terms change their sign when they were moved to the left? (hint 1)
equation = sp.Eq(y.diff(t, 2) - y.diff(t) + (2 - 3 * alpha) * y, u)

# %% right
possible = sp.Or(alpha < -6, alpha > -6)  # two half-lines
lost = {-6.0: [sp.Matrix([[-2, 2]])]}  # another length, a row of a matrix
# the left eigenvector computed
import numpy as np

values, rows = np.linalg.eig(np.array([[1.0, -6], [-3, -2]]).T)
lost = {-6: [rows[:, int(np.argmax(values))]]}
# solved for the second derivative
equation = sp.Eq(y.diff(t, 2), (2 - 3 * alpha) * y - y.diff(t) + u)
# multiplied by a number, with functions of one's own
s, q = sp.symbols("t alpha")
Y, U = sp.Function("y"), sp.Function("u")
equation = sp.Eq(2 * U(s), 2 * sp.diff(Y(s), s, s) + sp.diff(2 * Y(s), s) + (6 * q - 4) * Y(s))
