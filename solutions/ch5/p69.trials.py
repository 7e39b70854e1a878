# %% wrong
# Which sign does the root of the last equation have, if S is a cost? (hint 2)
s22 = 3 - sp.sqrt(8 + 2 * sp.sqrt(2))
S = sp.Matrix([[sp.sqrt(2) * s22 - 3 * (sp.sqrt(2) - 1), sp.sqrt(2) - 1], [sp.sqrt(2) - 1, s22]])
# Is the closed loop for this root of the first equation stable? (hint 2)
s12, s22 = -1 - sp.sqrt(2), 3 + sp.sqrt(8 - 2 * sp.sqrt(2))
S = sp.Matrix([[(1 + s12) * s22 - 3 * s12, s12], [s12, s22]])
S = sp.eye(2)  # Is the weight itself the cost of the whole way?
S = sp.diag(3 + sp.sqrt(11), 3 + sp.sqrt(11))  # Is this the matrix of the filter? (hint 1)
# Which sign does a stabilising feedback $u = Ke$ have? (hint 1)
gain = [sp.sqrt(2) - 1, 3 + sp.sqrt(8 + 2 * sp.sqrt(2))]
gain = [0, -3 - sp.sqrt(11)]  # Is this the gain of the filter, with a sign?
# Which row of S does B select? (hint 1)
gain = [-3 - sp.sqrt(16 + 4 * sp.sqrt(2)), 1 - sp.sqrt(2)]
# This mirrors the eigenvalues of the free motion. Does a deviation cost nothing here?
gain = [0, -6]
# Which root was taken, and what is the stiffness with it?
gain = [1 + sp.sqrt(2), -3 - sp.sqrt(8 - 2 * sp.sqrt(2))]
# Can the determinant of a covariance be negative? (hint 2)
covariance = sp.Matrix([[3 - sp.sqrt(7), 2], [2, 3 + sp.sqrt(7)]])
covariance = (3 - sp.sqrt(11)) * sp.eye(2)  # Can a variance be negative?
covariance = 2 * sp.eye(2)  # Is the motion stable by itself, as an oscillator without friction?
covariance = sp.diag(0, 3 + sp.sqrt(11))  # Is the position known without error?
covariance = (3 + sp.sqrt(13)) * sp.eye(2)  # What is the intensity of the noise q? (hint 1)
filter_gain = [3 + sp.sqrt(11), 0]  # Which of the two coordinates is measured? (hint 1)
# Does the filter move towards the measurement with this sign?
filter_gain = [0, -3 - sp.sqrt(11)]
# Is this the gain of the regulator?
filter_gain = [sp.sqrt(2) - 1, 3 + sp.sqrt(8 + 2 * sp.sqrt(2))]
# Is this the coefficient of the error matrix, which contains the free motion?
filter_gain = [0, sp.sqrt(11)]
# Does the filter contain the control? (hint 1)
controller = [e2, -e1 + 3 * e2 + (3 + sp.sqrt(11)) * (z - e2)]
# Which value is subtracted from the measurement?
controller = [e2, -sp.sqrt(2) * e1 - sp.sqrt(8 + 2 * sp.sqrt(2)) * e2 + (3 + sp.sqrt(11)) * z]
# Which gain belongs to the innovation? (hint 1)
controller = [
    e2,
    -sp.sqrt(2) * e1
    - sp.sqrt(8 + 2 * sp.sqrt(2)) * e2
    + (3 + sp.sqrt(8 + 2 * sp.sqrt(2))) * (z - e2),
]
# What does the innovation correct? (hint 1)
controller = [e2, -sp.sqrt(2) * e1 - sp.sqrt(8 + 2 * sp.sqrt(2)) * e2]
price = 6 + 2 * sp.sqrt(8 + 2 * sp.sqrt(2))  # Is the state known without error? (hint 2)
# Is this the cost of not knowing the state alone? (hint 1)
price = (3 + sp.sqrt(11)) * ((sp.sqrt(2) - 1) ** 2 + (3 + sp.sqrt(8 + 2 * sp.sqrt(2))) ** 2)
# Was the square of the gain forgotten in the cost of the error? (hint 2)
price = 12 + 2 * sp.sqrt(11) + 2 * sp.sqrt(8 + 2 * sp.sqrt(2))
price = 252  # Were the two costs added to three digits?
known = 3 + sp.sqrt(8 + 2 * sp.sqrt(2))  # Does the strength of the noise not matter? (hint 1)
known = 263.6  # What is this value with the given measurement? (hint 1)
# On how many of the two equations does the noise act? (hint 1)
known = 12 + 2 * sp.sqrt(8 + 2 * sp.sqrt(2)) + 2 * sp.sqrt(16 + 4 * sp.sqrt(2))

# %% right
# by the second entry
s22 = 3 + sp.sqrt(8 + 2 * sp.sqrt(2))
S = sp.Matrix([[sp.sqrt(2) * s22 - 3 * (sp.sqrt(2) - 1), sp.sqrt(2) - 1], [sp.sqrt(2) - 1, s22]])
gain = [-1 / (1 + sp.sqrt(2)), -3 - sp.sqrt(8 + 2 * sp.sqrt(2))]  # the conjugate
covariance = 2 / (sp.sqrt(11) - 3) * sp.eye(2)  # the conjugate
filter_gain = sp.Matrix([0, 6.32])  # three digits
# collected
w = sp.sqrt(8 + 2 * sp.sqrt(2))
controller = sp.Matrix([e2, (3 + sp.sqrt(11)) * z - sp.sqrt(2) * e1 - (3 + sp.sqrt(11) + w) * e2])
# the second form of the trace, in decimals
price = 264.0
known = 12.6  # three digits
