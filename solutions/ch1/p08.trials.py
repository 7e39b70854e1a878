# %% wrong
a_point = [sp.pi/2, sp.sqrt(g/k)]  # the wrong zero of the cosine: there gravity and drag act in one direction
a_point = [sp.sqrt(g/k), -sp.pi/2]  # the order of the state not kept
a_point = [-sp.pi/2, g/k]  # the drag taken as proportional to the speed
a_matrix = -sp.sqrt(g*k)*sp.eye(2)  # the square differentiated without its factor 2: a star
a_matrix = sp.sqrt(g*k)*sp.diag(1, -2)  # the sine taken as +1
a_matrix = sp.sqrt(g*k)*sp.diag(-2, -1)  # the order of the state not kept
a_type = "stable star"  # a diagonal matrix taken for a multiple of the unit matrix
a_type = "stable focus"  # real roots overlooked
a_curve = sp.sqrt(g*sp.sin(theta)/k)  # the sign of the weight turned: not real for downward flight
a_curve = sp.sqrt(g/k)  # the speed of the steady fall for all angles
b_points = [[-sp.pi/2, sp.sqrt((P + g)/k)]]  # only the dive
b_points = [[-sp.pi/2, sp.sqrt((P - g)/k)], [sp.pi/2, sp.sqrt((P + g)/k)]]  # the speeds of climb and dive exchanged
b_up_exists = P >= g  # a speed of zero counted as a motion
b_up_exists = P > 0  # as the printed problem has it: for every positive thrust
b_up_matrix = sp.diag(-g/sp.sqrt((P - g)/k), -2*k*sp.sqrt((P - g)/k))  # the sine keeps the sign it has in the dive
b_up_matrix = sp.sqrt(g*k)*sp.diag(1, -2)  # the speed of the passive fall put in
b_up_type = "stable node"  # one negative root taken for stability
b_up_type = "unstable node"  # unstable, but not in every direction
b_down_matrix = sp.sqrt(g*k)*sp.diag(-1, -2)  # the speed of the passive fall kept
b_down_matrix = sp.diag(-g/sp.sqrt((g - P)/k), -2*k*sp.sqrt((g - P)/k))  # the thrust thought to work against the fall
b_down_type = "saddle"  # the types of climb and dive exchanged
b_down_type = "stable degenerate node"  # equal roots for a certain thrust expected; their ratio is above 2
b_curve = sp.sqrt(-g*sp.sin(theta)/k)  # the thrust forgotten
b_curve = sp.sqrt((P + g)/k)  # the speed of the dive for all angles

# %% right
a_point = {v: (g/k)**sp.Rational(1, 2), theta: 4.71}  # the angle modulo 2 pi and in decimals, the point as a dict
# for these angles the sine is negative
a_curve = sp.sqrt(sp.Symbol("g")*sp.Abs(sp.sin(sp.Symbol("theta")))/sp.Symbol("k"))
# as dicts, in the other order
b_points = [{theta: sp.pi/2, v: sp.sqrt(P - g)/sp.sqrt(k)}, {theta: -sp.pi/2, v: sp.sqrt(P + g)/sp.sqrt(k)}]
# the rows of a matrix, another image of the lower angle
b_points = sp.Matrix([[sp.pi/2, sp.sqrt(P/k - g/k)], [3*sp.pi/2, sp.sqrt(P/k + g/k)]])
b_up_exists = (sp.Symbol("P") - sp.Symbol("g"))/sp.Symbol("k") > 0  # the square of the speed, plain symbols
b_up_exists = P/g > 1  # the ratio of thrust and weight
b_up_matrix = [[g*sp.sqrt(k/(P - g)), 0], [0, -2*sp.sqrt(k*(P - g))]]  # roots written out
b_down_matrix = -sp.sqrt(k/(P + g))*sp.diag(g, 2.0*(P + g))  # a common factor, a decimal
b_curve = sp.sqrt(P/k - g/k*sp.sin(theta))  # two terms
b_curve = [((P - g*sp.sin(theta))/k)**0.5]  # as a list with one branch
