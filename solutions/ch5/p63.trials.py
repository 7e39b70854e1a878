# %% wrong
# Which sign has a feedback that holds the motion back, with $u = Kx$? (hint 1)
gain = 1 + sp.sqrt(6) / 2
# Which root of the Riccati equation was taken, and where does the motion go with it? (hint 2)
gain = -1 + sp.sqrt(6) / 2
gain = -(2 + sp.sqrt(6))  # Was the weight of the control in the square forgotten? (hint 1)
gain = -(1 + sp.sqrt(2))  # Is the weight of the control 1 here? (hint 1)
# This mirrors the eigenvalue of the free motion. Does the deviation cost nothing here?
gain = -2
gain = -(2 + sp.sqrt(5)) / 2  # Does the factor before the integral belong to both terms? (hint 1)
cost = (2 + sp.sqrt(6)) * x0**2  # Is this the value of the integral alone? (hint 2)
cost = (2 - sp.sqrt(6)) / 2 * x0**2  # Can an integral of squares be negative?
cost = (2 + sp.sqrt(6)) / 2 * x0  # How does the cost change if the start is doubled? (hint 1)
cost = (2 + sp.sqrt(6)) / 4 * x0**2  # Was a half counted twice? (hint 2)
eigenvalues = [sp.sqrt(6) / 2]  # Does this motion decay? (hint 1)
eigenvalues = [1]  # Is this the motion without control? (hint 1)
eigenvalues = [-1 - sp.sqrt(6) / 2]  # Is this the gain alone, without the free motion? (hint 1)

# %% right
gain = 1 / (2 - sp.sqrt(6))  # the conjugate
gain = -2.22  # three digits
gain = sp.Matrix([[-1 - sp.sqrt(sp.Rational(3, 2))]])  # a matrix of one entry
cost = x0**2 * (1 + sp.sqrt(sp.Rational(3, 2)))  # under one root
cost = x0**2 / (sp.sqrt(6) - 2)  # the conjugate
eigenvalues = [-sp.sqrt(sp.Rational(3, 2))]  # under one root
eigenvalues = [-1.22]  # three digits
