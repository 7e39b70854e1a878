# %% wrong
# Was the growth of the coordinates forgotten? Look at the second row of A. (hint 1)
covariance = sp.Matrix(
    [[sp.sqrt(2 * sp.sqrt(3)), sp.sqrt(3)], [sp.sqrt(3), sp.sqrt(6 * sp.sqrt(3))]]
)
# Are these the errors of a system that swings? Which sign has $x_1$ in the second equation? (hint
# 1)
covariance = sp.Matrix([[sp.sqrt(2), 1], [1, 2 * sp.sqrt(2)]])
# Are the errors of both coordinates independent? (hint 1)
covariance = sp.diag(sp.sqrt(6), 2 * sp.sqrt(6))
# Which term of the middle equation was left out? (hint 1)
covariance = sp.Matrix([[sp.sqrt(6), 3], [3, 3 * sp.sqrt(6)]])
gain = [3, sp.sqrt(6)]  # Have the two entries changed places? (hint 1)
gain = [3, 2 * sp.sqrt(6)]  # Which column of the covariance does this measurement take? (hint 1)
gain = [0, -1]  # Is the variance that belongs to this gain more than zero? (hint 1)
eigenvalues = [1, -1]  # Are these the eigenvalues of the system, without a filter? (hint 1)
# Was the entry of A forgotten that stands in the same place as the second entry of the gain? (hint
# 2)
eigenvalues = [(-sp.sqrt(6) + sp.I * sp.sqrt(6)) / 2, (-sp.sqrt(6) - sp.I * sp.sqrt(6)) / 2]
# Do errors with these eigenvalues decay? (hint 2)
eigenvalues = [(sp.sqrt(6) + sp.I * sp.sqrt(2)) / 2, (sp.sqrt(6) - sp.I * sp.sqrt(2)) / 2]

# %% right
# by the modulus and the angle
eigenvalues = [
    sp.sqrt(2) * sp.exp(5 * sp.pi * sp.I / 6),
    sp.sqrt(2) * sp.exp(-5 * sp.pi * sp.I / 6),
]
gain = [sp.sqrt(2) * sp.sqrt(3), sp.sqrt(9)]  # other roots
