# %% wrong
exists = sp.true  # Is the position observable if no force depends on it? (hint 1)
exists = a < 0  # Does instability rule out a filter? (hint 2)
exists = a > 0  # Is an oscillator harder to observe than an unstable system? (hint 2)
# Put a number below zero for a: is the first variance positive? (hint 2)
covariance_negative = sp.sqrt(Q) * sp.diag(1 / a, 1)
# Is the middle equation satisfied with equal variances? (hint 1)
covariance_negative = sp.sqrt(Q) * sp.eye(2)
# Is this the other solution of the first equation? Put a number below zero for a. (hint 2)
covariance_negative = sp.Matrix([[sp.sqrt(Q + 4 * a) / a, 2], [2, sp.sqrt(Q + 4 * a)]])
gain_negative = [-sp.sqrt(Q) / a, 0]  # Is it the position that is measured? (hint 1)
gain_negative = [0, Q]  # Was a square root forgotten?
gain_negative = [sp.sqrt(Q), 0]  # Were the two entries interchanged? (hint 1)
# Is this the solution for the oscillator? Put a number above zero for a. (hint 1)
covariance_positive = sp.sqrt(Q) * sp.diag(-1 / a, 1)
# Does the last equation contain the term with a? (hint 2)
covariance_positive = sp.Matrix([[sp.sqrt(Q) / a, 2], [2, sp.sqrt(Q)]])
# What is the sign of the term with a in the last equation? (hint 2)
covariance_positive = sp.Matrix([[sp.sqrt(Q - 4 * a) / a, 2], [2, sp.sqrt(Q - 4 * a)]])
# Are the two errors uncorrelated? (hint 1)
covariance_positive = sp.diag(sp.sqrt(Q + 4 * a) / a, sp.sqrt(Q + 4 * a))
# With this gain, do the errors decay if a is positive? (hint 1)
gain_positive = [0, sp.sqrt(Q)]
gain_positive = [sp.sqrt(Q + 4 * a) / a, 2]  # Is it the position that is measured? (hint 1)
gain_positive = [sp.sqrt(Q + 4 * a), 2]  # Were the two entries interchanged? (hint 1)
# Are these the eigenvalues of the system, without a filter? (hint 1)
eigenvalues = [sp.sqrt(a), -sp.sqrt(a)]
# Was the constant term taken with the wrong sign? (hint 1)
eigenvalues = [
    (-sp.sqrt(Q + 4 * a) + sp.sqrt(Q + 8 * a)) / 2,
    (-sp.sqrt(Q + 4 * a) - sp.sqrt(Q + 8 * a)) / 2,
]
# Do errors with these eigenvalues decay? (hint 2)
eigenvalues = [(sp.sqrt(Q + 4 * a) + sp.sqrt(Q)) / 2, (sp.sqrt(Q + 4 * a) - sp.sqrt(Q)) / 2]

# %% right
exists = sp.Or(a < 0, a > 0)  # two cases
covariance_negative = sp.sqrt(Q) * sp.diag(1 / sp.Abs(a), 1)  # the modulus
# in two parts
covariance_positive = sp.sqrt(Q + 4 * a) * sp.Matrix([[1 / a, 0], [0, 1]]) + sp.Matrix(
    [[0, 2], [2, 0]]
)
# their product is a
eigenvalues = [
    -2 * a / (sp.sqrt(Q + 4 * a) + sp.sqrt(Q)),
    -2 * a / (sp.sqrt(Q + 4 * a) - sp.sqrt(Q)),
]
