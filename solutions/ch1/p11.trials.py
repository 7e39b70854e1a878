# %% wrong
plus_point = [sp.sqrt(1 - b**2)/ubar, sp.acos(b)]  # the sign of the angle: the distance would be negative
plus_point = [(1 - b)/ubar, -sp.acos(b)]  # the sine taken as 1 - b
minus_point = [-sp.sqrt(1 - b**2)/ubar, -sp.acos(b)]  # the negative distance that the sign of u seems to give
minus_point = [sp.sqrt(1 - b**2)/ubar, -sp.acos(b)]  # the solution for the other control
# the sign in the derivative of the cosine
plus_matrix = sp.Matrix([[0, sp.sqrt(1 - b**2)], [ubar**2/sp.sqrt(1 - b**2), b*ubar/sp.sqrt(1 - b**2)]])
# the derivative of sin(beta)/rho with respect to beta forgotten: a centre
plus_matrix = sp.Matrix([[0, -sp.sqrt(1 - b**2)], [ubar**2/sp.sqrt(1 - b**2), 0]])
# the sign of the trace changed along with u
minus_matrix = sp.Matrix([[0, sp.sqrt(1 - b**2)], [-ubar**2/sp.sqrt(1 - b**2), -b*ubar/sp.sqrt(1 - b**2)]])
# the matrix for the other control
minus_matrix = sp.Matrix([[0, -sp.sqrt(1 - b**2)], [ubar**2/sp.sqrt(1 - b**2), b*ubar/sp.sqrt(1 - b**2)]])
stability = "stable"  # the pure rotation in mind: the trace overlooked
stability = "asymptotically stable"  # the sign of the trace turned
focus = b < 1/sp.sqrt(2)  # the factor 4 in the discriminant forgotten
focus = b < 1  # a focus for every ratio of speeds
node = b < 2/sp.sqrt(5)  # the condition of the focus
node = b > sp.Rational(4, 5)  # the root not taken
no_cycles = [sp.Integer(1), sp.cos(beta)/rho]  # no multiplier: the divergence changes its sign
no_cycles = [rho**2, rho*(2*b - sp.cos(beta))]  # one power too many
no_cycles = [rho, sp.cos(beta)]  # the multiplier not differentiated
curve = sp.sin(beta)/ubar  # the sign: negative for these angles
curve = -ubar*sp.sin(beta)  # multiplied instead of divided by the rate of turn

# %% right
# plain symbols, the angle by the arctangent, as a column
plus_point = sp.Matrix([sp.sqrt(1 - sp.Symbol("b")**2)/sp.Symbol("ubar"),
                        -sp.atan(sp.sqrt(1 - sp.Symbol("b")**2)/sp.Symbol("b"))])
# the distance by the sine of the angle, the angle modulo 2 pi, as a dict
plus_point = {rho: sp.sin(sp.acos(b))/ubar, beta: 2*sp.pi - sp.acos(b)}
minus_point = (sp.sqrt((1 - b)*(1 + b))/ubar, sp.acos(b))  # factored, a tuple
minus_point = [sp.sqrt(1 - b**2)/ubar, sp.asin(sp.sqrt(1 - b**2))]  # by the arcsine: the angle is acute
focus = sp.Symbol("b")**2 < 4*(1 - sp.Symbol("b")**2)  # the discriminant, plain symbols
focus = sp.Interval.open(0, 0.894)  # as an interval, with decimals
node = sp.And(b >= 2*sp.sqrt(5)/5, b < 1)  # with the range of b, the border counted in
node = b**2/(1 - b**2) > 4  # the quotient of the discriminant
no_cycles = (-3*rho, -3*b)  # another factor, a tuple
curve = sp.Abs(sp.sin(beta))/ubar  # positive for these angles
