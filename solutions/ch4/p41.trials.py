# %% wrong
shaping = [-1, 8, 8]  # Does the variance stay what it is with this intensity? (hint 2)
shaping = [1, 16, 8]  # Does the correlation of the process decay with this coefficient? (hint 1)
shaping = [-1, 16, 0]  # Is y known exactly at the start?
shaping = [-8, 16, 8]  # Is the rate of decay mixed up with the variance? (hint 1)
# Does one learn nothing of y from the measurements? (hint 2)
covariance = sp.Matrix([[2, 2], [2, 8]])
# Can a variance be negative? Try the other root. (hint 2)
covariance = sp.Matrix([[-4, 8], [8, -24]])
covariance = sp.diag(2, 6)  # Does the error of y not pass into that of x? (hint 1)
# Was y taken for a white noise that pushes without a memory? (hint 1)
covariance = sp.Matrix([[2 * sp.sqrt(2), 4], [4, 8 * sp.sqrt(2)]])
gain = [2, 6]  # Are these the two variances? Which column is the gain? (hint 1)
gain = [4, 0]  # Was y taken for white noise, so that there is nothing of it to estimate?
gain = [2, 0]  # Can a filter correct y by the measurement of x? (hint 1)
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
