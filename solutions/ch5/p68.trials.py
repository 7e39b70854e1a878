# %% wrong
a_cost = sp.diag(a_weight, 0)  # Is the integrand itself the cost of the whole way? (hint 1)
# Can a cost be negative?
a_cost = sp.Matrix([[-a_cost[0, 0], a_cost[0, 1]], [a_cost[0, 1], -a_cost[1, 1]]])
# Which sign does the off-diagonal entry have in the second equation? (hint 1)
a_cost = sp.Matrix([[a_cost[0, 0], -a_cost[0, 1]], [-a_cost[0, 1], a_cost[1, 1]]])
# Were the two coordinates interchanged?
a_cost = sp.Matrix([[a_cost[1, 1], a_cost[0, 1]], [a_cost[0, 1], a_cost[0, 0]]])
a_gain = [-k for k in a_gain]  # Which sign does a braking feedback $u = Kx$ have? (hint 1)
a_gain = [-a_cost[0, 0], -a_cost[0, 1]]  # Which row of S does B select? (hint 1)
# Was the sign of the spring lost in the Riccati equation?
joint = 1 + sp.sqrt(1 + a_weight)
a_gain = [-joint, -sp.sqrt(2 * joint)]
# Is there no spring in this equation?
a_gain = [-sp.sqrt(a_weight), -sp.sqrt(2 * sp.sqrt(a_weight))]
a_gain = [0, -sp.sqrt(a_weight)]  # Is the weight put on the velocity here?
# Are these the coefficients of the closed loop, which contains the spring? (hint 1)
a_gain = [a_gain[0] - 1, a_gain[1]]
a_eigenvalues = [sp.I, -sp.I]  # Is this the motion without control? (hint 1)
a_eigenvalues = [-value for value in a_eigenvalues]  # Do these motions decay?
a_eigenvalues = a_gain  # Are these the gains? (hint 1)
b_motion_observable = False  # Does a mass on a stretched spring stay at rest? (hint 1)
b_cost = b_cost / 2  # Is the cost the energy, or twice the energy? (hint 1)
b_cost = sp.diag(0, b_weight)  # Does a mass on a stretched spring stay at rest? (hint 1)
b_cost = -b_cost  # Can a cost be negative? (hint 2)
b_cost = a_cost  # Does the cost of this item contain the position?
b_gain = [0, -b_gain[1]]  # Does this law take energy out, or put it in? (hint 1)
b_gain = [0, -2]  # This makes the motion aperiodic. What does so much friction cost?
b_gain = [b_gain[1], b_gain[1]]  # Does the cost of this item contain the position? (hint 1)
b_gain = [0, 0]  # Does the oscillation come to an end by itself? (hint 1)
b_gain = [b_gain[1], 0]  # Which row of S does B select?
b_gain = []  # Is there a motion that costs nothing and does not decay? (hint 1)
b_eigenvalues = [-1]  # How much friction is critical here? (hint 1)
b_eigenvalues = [-value for value in b_eigenvalues]  # Do these motions decay?
b_eigenvalues = [sp.I, -sp.I]  # Is this the motion without control? (hint 1)

# %% right
# a factor taken out
a_cost = a_cost[1, 1] * (a_cost / a_cost[1, 1])
a_gain = sp.Matrix([a_gain[0], -2 * a_cost[0, 1] / a_cost[1, 1]])  # a column
# polar form
modulus = sp.sqrt(1 + a_cost[0, 1])
angle = sp.acos(a_gain[1] / (2 * modulus))
a_eigenvalues = {modulus * sp.exp(sign * sp.I * angle) for sign in (1, -1)}
# decimals, lists
size = round(float(b_cost[0, 0]), 3)
b_cost = [[size, 0], [0, size]]
b_gain = -sp.Matrix([[0, sp.sqrt(b_weight)]])  # a row
# polar form
angle = sp.acos(b_gain[1] / 2)
b_eigenvalues = [sp.exp(sign * sp.I * angle) for sign in (1, -1)]

# %% numbers
a_weight, b_weight = [
    (root**2 - 1, speed)
    for root, speed in [
        *[(2, 1), (3, 2), (4, 3), (5, 6), (7, 5), (6, 7), (8, 8)],
        *[(9, 10), (11, 9), (10, 14), (15, 11), (14, 12), (12, 16), (13, 13)],
    ]
]
shown = [r"\big(«a_weight*»x_1^2 + u^2\big)", r"\big(«b_weight*»x_2^2 + u^2\big)"]
root = sp.sqrt(1 + a_weight)
last = sp.sqrt(2 * (root - 1))
a_cost = sp.Matrix([[root * last, root - 1], [root - 1, last]])
a_gain = [1 - root, -last]
a_eigenvalues = [(-last + sign * sp.I * sp.sqrt(2 * (root + 1))) / 2 for sign in (1, -1)]
b_cost = sp.sqrt(b_weight) * sp.eye(2)
b_gain = [0, -sp.sqrt(b_weight)]
b_eigenvalues = [(-sp.sqrt(b_weight) + sign * sp.I * sp.sqrt(4 - b_weight)) / 2 for sign in (1, -1)]
