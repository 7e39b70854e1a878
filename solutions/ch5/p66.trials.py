# %% wrong
# Is the integrand itself the cost of the whole way? (hint 1)
a_cost = sp.Matrix([[1, 0], [0, 1]])
# Which sign has the root of the second equation? (hint 2)
a_cost = -sp.Matrix([[sp.sqrt(2) - 2, 1 - sp.sqrt(2)], [1 - sp.sqrt(2), 1 - sp.sqrt(2)]])
# Is there a half before the integral? (hint 1)
a_cost = sp.Matrix([[2 + sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), 1 + sp.sqrt(2)]]) / 2
# Does this S have both signs? Can a cost be negative? (hint 2)
a_cost = sp.Matrix([[-2 - sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), -1 - sp.sqrt(2)]])
# Which sign has a feedback $u = Kx$ that holds a saddle? (hint 1)
a_gain = [1 + sp.sqrt(2), 1 + sp.sqrt(2)]
a_gain = [-2 - sp.sqrt(2), -1 - sp.sqrt(2)]  # Which row of S does B select? (hint 1)
a_gain = [-1, -sp.sqrt(3)]  # Is the free motion in this equation a saddle?
# Is this the coefficient of the loop, with the free motion in it? (hint 1)
a_gain = [-sp.sqrt(2), -1 - sp.sqrt(2)]
a_gain = [-2, -2]  # This puts both eigenvalues to -1. What decides how much to spend?
a_eigenvalues = [1, sp.sqrt(2)]  # Do these motions decay? (hint 1)
a_eigenvalues = [-1]  # How many eigenvalues has a system of the second order? (hint 1)
a_eigenvalues = [-1, 1]  # Are these the eigenvalues without control? (hint 1)
b_seen = False  # What does $x_2$ do if $x_1$ stays where it is, without control? (hint 1)
b_cost = sp.diag(0, 1)  # Is the integrand itself the cost of the whole way? (hint 1)
b_cost = sp.diag(-1, 1)  # Does this solution of the equation have both signs? (hint 2)
# Is this the cost of anything? Look at its sign. (hint 2)
b_cost = sp.Matrix([[-sp.sqrt(5), 2], [2, -sp.sqrt(5)]])
# Is the place paid for in this item? (hint 1)
b_cost = sp.Matrix([[2 + sp.sqrt(2), 1 + sp.sqrt(2)], [1 + sp.sqrt(2), 1 + sp.sqrt(2)]])
# Which solution of the Riccati equation has this law, and does its loop decay? (hint 1)
b_gain = [0, -1]
b_gain = [0, -sp.sqrt(5)]  # Nothing is paid for $x_1$: may it therefore run away? (hint 1)
b_gain = [2, sp.sqrt(5)]  # Which sign has a feedback $u = Kx$ here?
b_gain = [-sp.sqrt(5), -2]  # Which row of S does B select?
b_gain = []  # Is there a motion that grows and costs nothing? (hint 1)
b_eigenvalues = [(1 + sp.sqrt(5)) / 2, (sp.sqrt(5) - 1) / 2]  # Do these motions decay?
b_eigenvalues = [-1]  # Are the two roots of the loop equal? (hint 1)
# Does this loop belong to another solution of the Riccati equation?
b_eigenvalues = [-(1 + sp.sqrt(5)) / 2, (sp.sqrt(5) - 1) / 2]

# %% right
a_cost = [[3.41, 2.41], [2.41, 2.41]]  # three digits, lists
a_gain = [1 / (1 - sp.sqrt(2)), 1 / (1 - sp.sqrt(2))]  # the conjugates
a_eigenvalues = {-1, -2 / sp.sqrt(2)}  # a set
b_cost = sp.sqrt(5) * sp.eye(2) + 2 * sp.Matrix([[0, 1], [1, 0]])  # a sum
b_gain = sp.Matrix([-2, -5 / sp.sqrt(5)])  # a column
b_eigenvalues = [-sp.GoldenRatio, 1 - sp.GoldenRatio]  # by the golden ratio
