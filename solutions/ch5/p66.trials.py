# %% wrong
# Is the integrand itself the cost of the whole motion? (hint 1)
a_cost = sp.Matrix([[1, 0], [0, 1]])
# Which sign does the root of the second equation have? (hint 2)
a_cost = -sp.Matrix([[sp.sqrt(2) - 2, 1 - sp.sqrt(2)], [1 - sp.sqrt(2), 1 - sp.sqrt(2)]])
# Is there a half in front of the integral? (hint 1)
a_cost = sp.Matrix([[2 + sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), 1 + sp.sqrt(2)]]) / 2
# Is this S indefinite? Can a cost be negative? (hint 2)
a_cost = sp.Matrix([[-2 - sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), -1 - sp.sqrt(2)]])
# Which sign does a feedback $u = Kx$ that stabilises a saddle have? (hint 1)
a_gain = [1 + sp.sqrt(2), 1 + sp.sqrt(2)]
a_gain = [-2 - sp.sqrt(2), -1 - sp.sqrt(2)]  # Which row of S does B select? (hint 1)
a_gain = [-1, -sp.sqrt(3)]  # Is the free motion in this equation a saddle?
# Is this the coefficient of the closed loop, which contains the free motion? (hint 1)
a_gain = [-sp.sqrt(2), -1 - sp.sqrt(2)]
a_gain = [-2, -2]  # This puts both eigenvalues at -1. What determines the best control effort?
a_eigenvalues = [1, sp.sqrt(2)]  # Do these motions decay? (hint 1)
a_eigenvalues = [-1]  # How many eigenvalues does a second-order system have? (hint 1)
a_eigenvalues = [-1, 1]  # Are these the eigenvalues without control? (hint 1)
# What does $x_2$ do if $x_1$ stays where it is, without control? (hint 1)
b_motion_observable = False
b_cost = sp.diag(0, 1)  # Is the integrand itself the cost of the whole motion? (hint 1)
b_cost = sp.diag(-1, 1)  # Is this solution of the equation indefinite? (hint 2)
# Can this be a cost? Look at its sign. (hint 2)
b_cost = sp.Matrix([[-sp.sqrt(5), 2], [2, -sp.sqrt(5)]])
# Does the cost of this item contain the position? (hint 1)
b_cost = sp.Matrix([[2 + sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), 1 + sp.sqrt(2)]])
# Which solution of the Riccati equation gives this law, and is its closed loop stable? (hint 1)
b_gain = [0, -1]
b_gain = [0, -sp.sqrt(5)]  # The cost does not contain $x_1$: may it therefore diverge? (hint 1)
b_gain = [2, sp.sqrt(5)]  # Which sign does a feedback $u = Kx$ have here?
b_gain = [-sp.sqrt(5), -2]  # Which row of S does B select?
b_gain = []  # Is there a motion that grows and costs nothing? (hint 1)
b_eigenvalues = [(1 + sp.sqrt(5)) / 2, (sp.sqrt(5) - 1) / 2]  # Do these motions decay?
b_eigenvalues = [-1]  # Are the two eigenvalues of the closed loop equal? (hint 1)
# Does this closed loop belong to another solution of the Riccati equation?
b_eigenvalues = [-(1 + sp.sqrt(5)) / 2, (sp.sqrt(5) - 1) / 2]

# %% right
a_cost = [[3.41, 2.41], [2.41, 2.41]]  # three digits, lists
a_gain = [1 / (1 - sp.sqrt(2)), 1 / (1 - sp.sqrt(2))]  # the conjugates
a_eigenvalues = {-1, -2 / sp.sqrt(2)}  # a set
b_cost = sp.sqrt(5) * sp.eye(2) + 2 * sp.Matrix([[0, 1], [1, 0]])  # a sum
b_gain = sp.Matrix([-2, -5 / sp.sqrt(5)])  # a column
b_eigenvalues = [-sp.GoldenRatio, 1 - sp.GoldenRatio]  # by the golden ratio
