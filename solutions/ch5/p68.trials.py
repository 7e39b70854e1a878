# %% wrong
a_cost = sp.diag(3, 0)  # Is the integrand itself the cost of the whole way? (hint 1)
a_cost = sp.Matrix([[-2 * sp.sqrt(2), 1], [1, -sp.sqrt(2)]])  # Can a cost be negative?
# Which sign has the off-diagonal entry in the second equation? (hint 1)
a_cost = sp.Matrix([[2 * sp.sqrt(2), -1], [-1, sp.sqrt(2)]])
# Have the two coordinates changed places?
a_cost = sp.Matrix([[sp.sqrt(2), 1], [1, 2 * sp.sqrt(2)]])
a_gain = [1, sp.sqrt(2)]  # Which sign has a feedback $u = Kx$ that brakes? (hint 1)
a_gain = [-2 * sp.sqrt(2), -1]  # Which row of S does B select? (hint 1)
a_gain = [-3, -sp.sqrt(6)]  # Was the sign of the spring lost in the Riccati equation?
a_gain = [-sp.sqrt(3), -sp.sqrt(2 * sp.sqrt(3))]  # Is there no spring in this equation?
a_gain = [0, -sp.sqrt(3)]  # Is the weight put on the velocity here?
# Are these the coefficients of the loop, with the spring in it? (hint 1)
a_gain = [-2, -sp.sqrt(2)]
a_eigenvalues = [sp.I, -sp.I]  # Is this the motion without control? (hint 1)
# Do these motions decay?
a_eigenvalues = [(1 + sp.I * sp.sqrt(3)) / sp.sqrt(2), (1 - sp.I * sp.sqrt(3)) / sp.sqrt(2)]
a_eigenvalues = [-1, -sp.sqrt(2)]  # Are these the gains? (hint 1)
b_seen = False  # Does a spring that is drawn out stay without a velocity? (hint 1)
b_cost = sp.eye(2) / 2  # Is it once or twice the energy that has to be paid? (hint 1)
b_cost = sp.diag(0, 1)  # What does a spring that is drawn out do a moment later? (hint 1)
b_cost = -sp.eye(2)  # Can a cost be negative? (hint 2)
b_cost = sp.Matrix([[2 * sp.sqrt(2), 1], [1, sp.sqrt(2)]])  # Is the place paid for in this item?
b_gain = [0, 1]  # Does this law take energy out, or put it in? (hint 1)
b_gain = [0, -2]  # This makes the motion aperiodic. What does so much friction cost?
b_gain = [-1, -1]  # Is the place paid for in this item? (hint 1)
b_gain = [0, 0]  # Does the oscillation come to an end by itself? (hint 1)
b_gain = [-1, 0]  # Which row of S does B select?
b_gain = []  # Is there a motion that costs nothing and does not decay? (hint 1)
b_eigenvalues = [-1]  # How much friction is critical here? (hint 1)
# Do these motions decay?
b_eigenvalues = [
    (1 + sp.I * sp.sqrt(3)) / 2,
    (1 - sp.I * sp.sqrt(3)) / 2,
]
b_eigenvalues = [sp.I, -sp.I]  # Is this the motion without control? (hint 1)

# %% right
a_cost = sp.sqrt(2) * sp.Matrix([[2, 1 / sp.sqrt(2)], [1 / sp.sqrt(2), 1]])  # a factor taken out
a_gain = sp.Matrix([-1, -2 / sp.sqrt(2)])  # a column
# polar form
a_eigenvalues = {
    sp.sqrt(2) * sp.exp(2 * sp.pi * sp.I / 3),
    sp.sqrt(2) * sp.exp(-2 * sp.pi * sp.I / 3),
}
b_cost = [[1.0, 0], [0, 1.0]]  # lists of decimals
b_gain = -sp.Matrix([[0, 1]])  # a row
b_eigenvalues = [sp.exp(2 * sp.pi * sp.I / 3), sp.exp(-2 * sp.pi * sp.I / 3)]  # polar form
