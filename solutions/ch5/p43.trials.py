# %% wrong
# Is the time to be maximised here? (hint 1)
a_pontryagin = (
    psi1 * (sp.cos(alpha) - b * sp.cos(beta))
    + psi2 * (-sp.sin(alpha) + b * sp.sin(beta)) / (r * c)
    + 1
)
# Was the cost forgotten? (hint 1)
a_pontryagin = psi1 * (sp.cos(alpha) - b * sp.cos(beta)) + psi2 * (
    -sp.sin(alpha) + b * sp.sin(beta)
) / (r * c)
# Does the second equation of motion not contain the distance? (hint 1)
a_adjoint = [0, -b * (psi1 * sp.sin(beta) + psi2 * sp.cos(beta) / (r * c))]
# With which sign does the derivative of $H$ enter? (hint 1)
a_adjoint = [
    -psi2 * (b * sp.sin(beta) - sp.sin(alpha)) / (r**2 * c),
    b * (psi1 * sp.sin(beta) + psi2 * sp.cos(beta) / (r * c)),
]
a_transversality = [psi1]  # Which state has a given value at the end? (hint 1)
a_transversality = [psi1, psi2]  # Is the distance at the end free? (hint 1)
a_control = sp.atan2(psi2 / (r * c), psi1)  # With which sign does the sine enter? (hint 1)
a_control = sp.atan2(psi2 / (r * c), -psi1)  # Does $H$ have a minimum or a maximum there? (hint 1)
# Does the first costate not change with time?
a_rate = -b * (1 - c) / (r * c) * sp.cos(alpha) * sp.sin(alpha - beta)
# Does the sign of the cost reverse the rate of the control? (hint 1)
a_rate = -(-sp.sin(alpha) + b * sp.sin(beta)) / r + b * (1 - c) / (r * c) * sp.cos(alpha) * sp.sin(
    alpha - beta
)
b_rest = [(0, 0)]  # For which other angles does the line of sight not turn? (hint 1)
b_rest = [(0, 0), (sp.pi, sp.pi)]  # May the two fly in opposite directions? (hint 1)
# Can the sine of an angle be so large? (hint 1)
b_rest = [(0, 0), (0, sp.pi), (sp.pi, 0), (sp.pi / 2, sp.asin(b))]
# What is the order of the deviations? (hint 1)
b_flight = sp.Matrix([[b / c, -1 / c], [b / c, b - 1 - b / c]])
# Was the second term of the target's rate differentiated? (hint 1)
b_flight = sp.Matrix([[-1, b], [-1 / c, b / c]])
b_flight_stability = "unstable"  # Is this the matrix for a fast pursuer? (hint 1)
b_flight_stability = "stable"  # Is the trace zero? (hint 1)
# Does the determinant have the same sign as for a fast pursuer? (hint 1)
b_flight_type = "saddle"
b_flight_type = "stable node"  # Are the eigenvalues real for these numbers? (hint 1)
b_apart_type = "unstable node"  # Do all small deviations grow there? (hint 1)
b_apart_type = "unstable focus"  # Is this the solution at which the target catches up? (hint 1)
b_straight = (r_T - 1) / (1 + b)  # Does the pursuer fly away from the target? (hint 1)
b_straight = r_T - 1  # Does the pursuer stand still? (hint 1)
# Is this the time from a pursuer that flies straight at the target? (hint 1)
b_time = sp.Integer(1)
b_time = sp.Float("2.297728")  # Is this the fastest of the extremals? (hint 2)

# %% right
a_control = sp.atan2(psi2, -psi1 * r * c)  # times a positive number
# the turn of the target's velocity less the turn of the line of sight
a_rate = (
    b * (1 - 1 / c) / r * sp.cos(alpha) * sp.sin(alpha - beta)
    - (sp.sin(alpha) - b * sp.sin(beta)) / r
)
b_rest = [(3.1416, 0), (0, 3.1416), (0, 0), (3.1416, 3.1416)]  # in decimals
b_straight = (1 - r_T) / (b - 1)  # both signs reversed
b_time = sp.Float("0.9679")  # four digits
