# %% wrong
shaping = [-1, 8, 8]  # Is the variance constant with this intensity? (hint 2)
shaping = [1, 16, 8]  # Does the correlation of the process decay with this coefficient? (hint 1)
shaping = [-1, 16, 0]  # Is y known exactly at $t = 0$?
shaping = [-8, 16, 8]  # Was the decay rate confused with the variance? (hint 1)
# Do the measurements give no information about y? (hint 2)
covariance = sp.Matrix([[2, 2], [2, 8]])
# Can a variance be negative? Try the other root. (hint 2)
covariance = sp.Matrix([[-4, 8], [8, -24]])
covariance = sp.diag(2, 6)  # Does the error of y not affect that of x? (hint 1)
# Was y taken as white noise, without correlation in time? (hint 1)
covariance = sp.Matrix([[2 * sp.sqrt(2), 4], [4, 8 * sp.sqrt(2)]])
gain = [2, 6]  # Are these the two variances? Which column is the gain? (hint 1)
gain = [4, 0]  # Was y taken as white noise, which cannot be estimated?
gain = [2, 0]  # Does the measurement of x not correct y as well? (hint 1)
eigenvalues = [0, -1]  # Are these the eigenvalues without a measurement?
eigenvalues = [-2, -1]  # Is the matrix of the errors triangular? (hint 1)
# Do errors with these eigenvalues decay? (hint 1)
eigenvalues = [(3 + sp.sqrt(7) * sp.I) / 2, (3 - sp.sqrt(7) * sp.I) / 2]

# %% right
# by the modulus and the angle
eigenvalues = [
    2 * sp.exp(sp.I * (sp.pi - sp.acos(sp.Rational(3, 4)))),
    2 * sp.exp(-sp.I * (sp.pi - sp.acos(sp.Rational(3, 4)))),
]
shaping = sp.Matrix([-1, 16, 8])  # as a column
