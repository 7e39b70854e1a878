# %% wrong
possible = sp.Ne(alpha, 6)  # a sign in the determinant
possible = sp.Ne(alpha, sp.Rational(2, 3))  # the determinant of A taken in place of that of W
possible = True  # the characteristic polynomial exists always, so the form is thought to
lost = {-6: [[1, 1]]}  # the direction that is controlled in place of the combination that is not
lost = {-6: [[2, -1]]}  # the right eigenvector of the eigenvalue 4 in place of the left one
canonical = sp.Matrix([[-1, 1], [2 - 3*alpha, 0]])  # the form by observation
canonical = sp.Matrix([[0, 1], [3*alpha - 2, 1]])  # the coefficients of the polynomial with their own signs
basis = sp.Matrix([[1 + alpha, 1], [-5, 1]])  # the columns of W, which lead to another form
basis = sp.Matrix([[1, alpha + 2], [1, -4]])  # the columns in the order in which they were found
coordinate = [1, -1]  # the right direction without its factor
coordinate = [alpha + 2, -4]  # the first column of P in place of the first row of its inverse
equation = sp.Eq(y.diff(t, 2) + y.diff(t) + (3*alpha - 2)*y, u.diff(t) - 4*u)  # the equation of x2
equation = sp.Eq(y.diff(t, 2) + y.diff(t) + (3*alpha - 2)*y, (alpha + 6)*u)  # the equation of x1 - x2
# the last row of the form moved to the left without a change of sign
equation = sp.Eq(y.diff(t, 2) - y.diff(t) + (2 - 3*alpha)*y, u)

# %% right
possible = sp.Or(alpha < -6, alpha > -6)  # two half-lines
lost = {-6.0: [sp.Matrix([[-2, 2]])]}  # another length, a row of a matrix
# the left eigenvector computed
import numpy as np
values, rows = np.linalg.eig(np.array([[1.0, -6], [-3, -2]]).T)
lost = {-6: [rows[:, int(np.argmax(values))]]}
equation = sp.Eq(y.diff(t, 2), (2 - 3*alpha)*y - y.diff(t) + u)  # solved for the second derivative
# multiplied by a number, with functions of one's own
s, q = sp.symbols("t alpha")
Y, U = sp.Function("y"), sp.Function("u")
equation = sp.Eq(2*U(s), 2*sp.diff(Y(s), s, s) + sp.diff(2*Y(s), s) + (6*q - 4)*Y(s))
