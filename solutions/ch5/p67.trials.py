# %% wrong
a_cost = sp.eye(2)  # Is the integrand itself the cost of the whole way? (hint 1)
a_cost = sp.Matrix([[2, 1], [1, 3]]) / 2  # Is there a half in front of the integral?
# Is a form with a zero on its diagonal and a non-zero entry beside it definite? (hint 2)
a_cost = sp.Matrix([[0, -1], [-1, 1]])
a_cost = sp.Matrix([[-2, 1], [1, -1]])  # Can a cost be negative? (hint 2)
a_gain = [1, 3]  # Which sign does a braking feedback $u = Kx$ have? (hint 1)
a_gain = [-1, -2]  # Is this the coefficient of the closed loop, which contains the free motion?
a_gain = [-2, -1]  # Which row of S does B select? (hint 1)
a_gain = [-1, 1]  # Which root of the third equation gives this law? Is its closed loop stable?
a_gain = [-1, -sp.sqrt(3)]  # Is there a term with the velocity in the free motion?
a_eigenvalues = [0, 1]  # Are these the eigenvalues without control? (hint 1)
a_eigenvalues = [1]  # Does this motion decay? (hint 1)
a_eigenvalues = [-1, -3]  # Are these the gains? (hint 1)
b_stabilising = [0, -1 - sp.sqrt(2)]  # Does x tend to zero under this law? (hint 1)
b_stabilising = [-1, -3]  # Is this law the best for a cost that does not contain x?
# Does half of this position feedback cost more, or less? (hint 2)
b_stabilising = [-sp.Rational(1, 100), -1 - sp.sqrt(2)]
b_gain = [-1, -3]  # Does the cost of this item contain the position? (hint 1)
# Which root of the quadratic equation was taken, and does v decay with it?
b_gain = [0, sp.sqrt(2) - 1]
b_gain = [0, 1 + sp.sqrt(2)]  # Which sign does the feedback have? (hint 1)
b_gain = [0, -sp.sqrt(2)]  # Is this the eigenvalue of the closed loop instead of the gain?
b_gain = [0, 0]  # Does the velocity stay as it is without control? (hint 1)
b_cost = sp.Matrix([[2, 1], [1, 3]])  # Does the cost of this item contain the position? (hint 1)
b_cost = sp.diag(0, 1 - sp.sqrt(2))  # Can a cost be negative? (hint 1)
b_cost = sp.diag(1, 1 + sp.sqrt(2))  # What does it cost to stay at rest at some position? (hint 1)
b_cost = sp.diag(0, sp.sqrt(2))  # Is this a rate of decay instead of a cost?
b_rest = [0, 0]  # Does anything bring x back? (hint 1)
b_rest = [x1, 0]  # Does the position not change while the velocity decays? (hint 1)
b_rest = [x1 + x2, 0]  # How fast does the velocity decay? (hint 1)
# Is this the rate due to the gain alone, without the free motion? (hint 1)
b_rest = [x1 + x2 / (1 + sp.sqrt(2)), 0]
# Which power of the gain appears in the first equation? (hint 1)
b_repaired = [-(epsilon**2), -1 - sp.sqrt(2 + 2 * epsilon**2)]
# Is the gain of the velocity independent of the position? (hint 1)
b_repaired = [-epsilon, -1 - sp.sqrt(2)]
b_repaired = [0, -1 - sp.sqrt(2)]  # Is this the law without the additional weight? (hint 1)
# Which sign of the root was taken in the first equation? (hint 1)
b_repaired = [epsilon, -1 - sp.sqrt(2 - 2 * epsilon)]
# Is this the coefficient of the closed loop, which contains the free motion? (hint 1)
b_repaired = [-epsilon, -sp.sqrt(2 + 2 * epsilon)]

# %% right
a_cost = [[2, 1], [1, 3]]  # lists
a_gain = sp.Matrix([-1.0, -3.0])  # a column of decimals
a_eigenvalues = {-1: 2}  # with its multiplicity
b_stabilising = ()  # an empty tuple
b_gain = [0, 1 / (1 - sp.sqrt(2))]  # the conjugate
b_cost = sp.Matrix([[0, 0], [0, 1 / (sp.sqrt(2) - 1)]])  # the conjugate
b_rest = [(2 * x1 + sp.sqrt(2) * x2) / 2, 0]  # over a common denominator
b_repaired = [-epsilon, (1 + 2 * epsilon) / (1 - sp.sqrt(2 + 2 * epsilon))]  # the conjugate
