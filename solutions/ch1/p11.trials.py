# %% wrong
# Can the distance be positive with an angle of this sign? (hint 1)
plus_point = [sp.sqrt(1 - b**2) / ubar, sp.acos(b)]
plus_point = [(1 - b) / ubar, -sp.acos(b)]  # How does the sine follow from the cosine? (hint 1)
# Can a distance be negative? Determine the sign of the angle instead. (hint 1)
minus_point = [-sp.sqrt(1 - b**2) / ubar, -sp.acos(b)]
# Is this the stationary solution for the other control? (hint 2)
minus_point = [sp.sqrt(1 - b**2) / ubar, -sp.acos(b)]
# What is the sign of the derivative of the cosine? (hint 2)
plus_matrix = sp.Matrix(
    [[0, sp.sqrt(1 - b**2)], [ubar**2 / sp.sqrt(1 - b**2), b * ubar / sp.sqrt(1 - b**2)]]
)
# Was $\sin\beta/\rho$ differentiated with respect to the angle too? (hint 2)
plus_matrix = sp.Matrix([[0, -sp.sqrt(1 - b**2)], [ubar**2 / sp.sqrt(1 - b**2), 0]])
# Does the trace change its sign together with the control? (hint 1)
minus_matrix = sp.Matrix(
    [[0, sp.sqrt(1 - b**2)], [-(ubar**2) / sp.sqrt(1 - b**2), -b * ubar / sp.sqrt(1 - b**2)]]
)
# Is this the matrix for the other control? (hint 1)
minus_matrix = sp.Matrix(
    [[0, -sp.sqrt(1 - b**2)], [ubar**2 / sp.sqrt(1 - b**2), b * ubar / sp.sqrt(1 - b**2)]]
)
# Is the motion near the point a pure rotation? Look at the trace. (hint 1)
stability = "stable"
stability = "asymptotically stable"  # Does the trace have the wrong sign? (hint 1)
focus = b < 1 / sp.sqrt(2)  # Was the factor 4 in the discriminant forgotten? (hint 1)
focus = b < 1  # Are the roots complex for every ratio of the speeds? (hint 1)
node = b < 2 / sp.sqrt(5)  # Is this the condition for the other type of point? (hint 1)
# Was the root taken at the end? The condition is on b, not on its square.
node = b > sp.Rational(4, 5)
# Does this divergence keep its sign? Without a multiplier no conclusion follows. (hint 1)
no_cycles = [sp.Integer(1), sp.cos(beta) / rho]
# Is there one power too many in the multiplier? (hint 2)
no_cycles = [rho**2, rho * (2 * b - sp.cos(beta))]
no_cycles = [rho, sp.cos(beta)]  # Was the multiplier differentiated as well? (hint 2)
curve = sp.sin(beta) / ubar  # Is the distance positive for these angles? (hint 1)
curve = -ubar * sp.sin(beta)  # Was the rate of turn multiplied instead of divided by? (hint 1)
# Does this angle lie in the interval of the statement?
plus_point = [sp.sqrt(1 - b**2) / ubar, 2 * sp.pi - sp.acos(b)]

# %% right
# plain symbols, the angle by the arctangent, as a column
plus_point = sp.Matrix(
    [
        sp.sqrt(1 - sp.Symbol("b") ** 2) / sp.Symbol("ubar"),
        -sp.atan(sp.sqrt(1 - sp.Symbol("b") ** 2) / sp.Symbol("b")),
    ]
)
# the distance by the sine of the angle, the angle by the arcsine, as a dict
plus_point = {rho: sp.sin(sp.acos(b)) / ubar, beta: -sp.asin(sp.sqrt(1 - b**2))}
minus_point = (sp.sqrt((1 - b) * (1 + b)) / ubar, sp.acos(b))  # factored, a tuple
# by the arcsine: the angle is acute
minus_point = [sp.sqrt(1 - b**2) / ubar, sp.asin(sp.sqrt(1 - b**2))]
focus = sp.Symbol("b") ** 2 < 4 * (1 - sp.Symbol("b") ** 2)  # the discriminant, plain symbols
focus = sp.Interval.open(0, 0.894)  # as an interval, with decimals
node = sp.And(b >= 2 * sp.sqrt(5) / 5, b < 1)  # with the range of b, the border counted in
node = b**2 / (1 - b**2) > 4  # the quotient of the discriminant
no_cycles = (-3 * rho, -3 * b)  # another factor, a tuple
curve = sp.Abs(sp.sin(beta)) / ubar  # positive for these angles
