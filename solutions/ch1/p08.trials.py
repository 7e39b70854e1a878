# %% wrong
a_point = [sp.pi / 2, sp.sqrt(g / k)]  # Can gravity and drag balance at this angle? (hint 2)
a_point = [sp.sqrt(g / k), -sp.pi / 2]  # In which order does the problem list the state? (hint 2)
a_point = [-sp.pi / 2, g / k]  # Is the drag proportional to the speed or to its square? (hint 1)
a_matrix = -sp.sqrt(g * k) * sp.eye(2)  # Was the factor 2 lost in the derivative? (hint 1)
a_matrix = sp.sqrt(g * k) * sp.diag(1, -2)  # What is the sign of the sine at this point? (hint 2)
# In which order does the problem list the state? (hint 1)
a_matrix = sp.sqrt(g * k) * sp.diag(-2, -1)
a_type = "stable star"  # Is every diagonal matrix a multiple of the unit matrix? (hint 1)
a_type = "stable focus"  # Are the roots complex? (hint 1)
a_curve = sp.sqrt(g * sp.sin(theta) / k)  # For which angles is this root real? (hint 2)
a_curve = sp.sqrt(g / k)  # Is this the speed of the steady fall, whatever the angle? (hint 1)
# Is there only the dive for a large thrust? (hint 1)
b_points = [[-sp.pi / 2, sp.sqrt((P + g) / k)]]
# Were the speeds of climb and dive swapped? (hint 2)
b_points = [[-sp.pi / 2, sp.sqrt((P - g) / k)], [sp.pi / 2, sp.sqrt((P + g) / k)]]
b_up_exists = P >= g  # Is a speed of zero a motion? (hint 1)
# Does every positive thrust lift the body, as the printed problem assumes? (hint 1)
b_up_exists = P > 0
# Does the sine keep the sign that it has in the dive? (hint 1)
b_up_matrix = sp.diag(-g / sp.sqrt((P - g) / k), -2 * k * sp.sqrt((P - g) / k))
b_up_matrix = sp.sqrt(g * k) * sp.diag(1, -2)  # Is this the speed of the passive fall? (hint 1)
b_up_type = "stable node"  # Is one negative root enough for stability? (hint 1)
b_up_type = "unstable node"  # It is unstable, but in every direction? (hint 1)
# Is this still the speed of the passive fall? (hint 1)
b_down_matrix = sp.sqrt(g * k) * sp.diag(-1, -2)
# Does the thrust oppose the dive? (hint 1)
b_down_matrix = sp.diag(-g / sp.sqrt((g - P) / k), -2 * k * sp.sqrt((g - P) / k))
b_down_type = "saddle"  # Were the types of climb and dive swapped? (hint 1)
b_down_type = "stable degenerate node"  # Can the two roots be equal for any thrust? (hint 1)
b_curve = sp.sqrt(-g * sp.sin(theta) / k)  # Was the thrust forgotten? (hint 1)
b_curve = sp.sqrt((P + g) / k)  # Is this the speed of the dive, whatever the angle? (hint 1)

# %% right
# the angle in decimals, the point as a dict
a_point = {v: (g / k) ** sp.Rational(1, 2), theta: -1.571}
# for these angles the sine is negative
a_curve = sp.sqrt(sp.Symbol("g") * sp.Abs(sp.sin(sp.Symbol("theta"))) / sp.Symbol("k"))
# as dicts, in the other order
b_points = [
    {theta: sp.pi / 2, v: sp.sqrt(P - g) / sp.sqrt(k)},
    {theta: -sp.pi / 2, v: sp.sqrt(P + g) / sp.sqrt(k)},
]
# the rows of a matrix, the fractions divided out
b_points = sp.Matrix([[sp.pi / 2, sp.sqrt(P / k - g / k)], [-sp.pi / 2, sp.sqrt(P / k + g / k)]])
# the square of the speed, plain symbols
b_up_exists = (sp.Symbol("P") - sp.Symbol("g")) / sp.Symbol("k") > 0
b_up_exists = P / g > 1  # the ratio of thrust and weight
b_up_matrix = [[g * sp.sqrt(k / (P - g)), 0], [0, -2 * sp.sqrt(k * (P - g))]]  # roots written out
b_down_matrix = -sp.sqrt(k / (P + g)) * sp.diag(g, 2.0 * (P + g))  # a common factor, a decimal
b_curve = sp.sqrt(P / k - g / k * sp.sin(theta))  # two terms
b_curve = [((P - g * sp.sin(theta)) / k) ** 0.5]  # as a list with one branch
