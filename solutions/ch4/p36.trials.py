# %% wrong
# Which of the roots of the first equation can be a variance? (hint 2)
covariance = sp.Matrix([[-3, sp.Rational(3, 2)], [sp.Rational(3, 2), -3]])
# Was the lag forgotten? Look at the first row of A. (hint 1)
covariance = sp.Matrix([[sp.sqrt(3), sp.Rational(3, 2)], [sp.Rational(3, 2), 3 * sp.sqrt(3) / 2]])
# Are the errors of the two coordinates uncorrelated? (hint 1)
covariance = sp.diag(1, 3)
# Is the middle equation satisfied, too? (hint 1)
covariance = sp.Matrix([[1, sp.Rational(3, 2)], [sp.Rational(3, 2), sp.Rational(3, 2)]])
gain = [1, 3]  # Which column of the covariance belongs to this measurement? (hint 1)
gain = [sp.Rational(3, 2), 1]  # Were the two entries interchanged? (hint 1)
# Is the error of the measured coordinate itself not corrected? (hint 1)
gain = [0, sp.Rational(3, 2)]
eigenvalues = [0, -1]  # Are these the eigenvalues of the system, without a filter? (hint 1)
# With which sign does the gain enter the matrix of the errors? (hint 1)
eigenvalues = [sp.sqrt(6) / 2, -sp.sqrt(6) / 2]
# Do errors with these eigenvalues decay?
eigenvalues = [1 + sp.I / sp.sqrt(2), 1 - sp.I / sp.sqrt(2)]

# %% right
# by the quadratic formula
eigenvalues = [sp.Rational(-1) + sp.I * sp.sqrt(sp.Rational(1, 2)), (-2 - sp.sqrt(-2)) / 2]
gain = sp.Matrix([[1, sp.Rational(3, 2)], [sp.Rational(3, 2), 3]])[:, 0]  # a column of a matrix
