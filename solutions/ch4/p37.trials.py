# %% wrong
# Are the two errors uncorrelated because the two noises are? (hint 1)
covariance = sp.diag(sp.sqrt(6) - 1, 1)
# If only the sum is measured, what is the sign of the covariance of the errors? (hint 1)
covariance = sp.Matrix([[2, 1], [1, 2]])
# Can a variance be negative? Try the other root. (hint 2)
covariance = sp.Matrix([[-10, 5], [5, -4]])
# Is this matrix positive definite? (hint 2)
covariance = sp.Matrix([[0, sp.sqrt(5)], [sp.sqrt(5), -1 - sp.sqrt(5)]])
gain = [-5, 1]  # Which variance belongs to this gain? (hint 2)
gain = [2, -1]  # Is only one coordinate measured? (hint 1)
gain = [3, 3]  # With which sign do the two entries of a row of the covariance add up? (hint 1)
eigenvalues = [-1, 0]  # Are these the eigenvalues of the processes, without a filter? (hint 1)
# Is the matrix diagonal, so that its entries are the eigenvalues? (hint 1)
eigenvalues = [-2, -1]
# Was a sign lost in the quadratic formula? Do errors with these eigenvalues decay?
eigenvalues = [(3 + sp.sqrt(5)) / 2, (3 - sp.sqrt(5)) / 2]

# %% right
# squares of the golden ratio
eigenvalues = [-(((1 + sp.sqrt(5)) / 2) ** 2), -(((1 - sp.sqrt(5)) / 2) ** 2)]
eigenvalues = [-2.62, -0.382]  # decimals
