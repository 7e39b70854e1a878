# %% wrong
# Are the two errors independent because the two noises are? (hint 1)
covariance = sp.diag(sp.sqrt(6) - 1, 1)
# Which sign has the covariance of two errors of which only the sum is seen? (hint 1)
covariance = sp.Matrix([[2, 1], [1, 2]])
# Can a variance be negative? Try the other root. (hint 2)
covariance = sp.Matrix([[-10, 5], [5, -4]])
# Is this matrix positive definite? (hint 2)
covariance = sp.Matrix([[0, sp.sqrt(5)], [sp.sqrt(5), -1 - sp.sqrt(5)]])
gain = [-5, 1]  # Which variance belongs to this gain? (hint 2)
gain = [2, -1]  # Does the measurement see one coordinate alone? (hint 1)
gain = [3, 3]  # With which sign do the two entries of a row of the covariance add up? (hint 1)
eigenvalues = [-1, 0]  # Are these the eigenvalues of the processes, without a filter? (hint 1)
# Are the diagonal entries the eigenvalues of a matrix that has more than a diagonal? (hint 1)
eigenvalues = [-2, -1]
# Was a sign lost on the way to the quadratic formula? Can errors with these eigenvalues decay?
eigenvalues = [(3 + sp.sqrt(5)) / 2, (3 - sp.sqrt(5)) / 2]

# %% right
# squares of the golden ratio
eigenvalues = [-(((1 + sp.sqrt(5)) / 2) ** 2), -(((1 - sp.sqrt(5)) / 2) ** 2)]
eigenvalues = [-2.62, -0.382]  # decimals
