# %% wrong
# Is the time to be minimised here? (hint 1)
a_pontryagin = (
    psi1 * (sp.cos(alpha) - b * sp.cos(beta))
    + psi2 * (-sp.sin(alpha) + b * sp.sin(beta)) / (r * c)
    - 1
)
# Where is the cost? (hint 1)
a_pontryagin = psi1 * (sp.cos(alpha) - b * sp.cos(beta)) + psi2 * (
    -sp.sin(alpha) + b * sp.sin(beta)
) / (r * c)
# Does the second equation of motion contain the distance? (hint 1)
a_adjoint = [0, -b * (psi1 * sp.sin(beta) + psi2 * sp.cos(beta) / (r * c))]
# Which sign precedes the derivative of $H$? (hint 1)
a_adjoint = [
    -psi2 * (b * sp.sin(beta) - sp.sin(alpha)) / (r**2 * c),
    b * (psi1 * sp.sin(beta) + psi2 * sp.cos(beta) / (r * c)),
]
a_transversality = [psi1]  # Which state is given at the end, and which is not? (hint 1)
a_transversality = [psi1, psi2]  # Is the distance free at the end? (hint 1)
# Which sign does the sine have in the equation for $\beta$? (hint 1)
a_control = sp.atan2(psi2 / (r * c), psi1)
# Which of the two directions with this tangent maximises $H$? (hint 1)
a_control = sp.atan(-psi2 / (r * c * psi1))
a_control = sp.atan2(-psi2, psi1)  # By what is the second costate multiplied in $H$? (hint 1)
# Is the first costate constant while the second one changes? (hint 2)
a_rate = -b * (1 - c) / (r * c) * sp.cos(alpha) * sp.sin(alpha - beta)
# Which sign does the last term have? (hint 1)
a_rate = (-sp.sin(alpha) + b * sp.sin(beta)) / r + b * (1 - c) / (r * c) * sp.cos(alpha) * sp.sin(
    alpha - beta
)
# Is this in the new time? The answer is required in the given one. (hint 1)
a_rate = -sp.sin(alpha) + b * sp.sin(beta) - b * (1 - c) / c * sp.cos(alpha) * sp.sin(alpha - beta)
# When does the other factor vanish? (hint 2)
b_rest = [(0, 0), (0, sp.pi), (sp.pi, 0), (sp.pi, sp.pi)]
b_rest = [(0, 0)]  # For which other angles does the line of sight not turn? (hint 1)
# How many angles have a given sine? (hint 3)
b_rest = [
    (0, 0),
    (0, sp.pi),
    (sp.pi, 0),
    (sp.pi, sp.pi),
    (sp.pi / 2, sp.asin(1 / b)),
    (-sp.pi / 2, -sp.asin(1 / b)),
]
# What is the order of the angles? (hint 1)
b_chase = sp.Matrix([[b / c, -1 / c], [b / c, b - 1 - b / c]])
# Was the product in the last term differentiated too? (hint 1)
b_chase = sp.Matrix([[-1, b], [-1 / c, b / c]])
b_chase_type = "stable node"  # What is the sign of the product of the roots? (hint 1)
b_chase_type = "unstable focus"  # Are the roots complex? (hint 1)
# Is the cosine of the target's angle a factor of the product that vanishes? (hint 1)
b_collision = sp.sqrt(b**2 - 1) * sp.Matrix([[0, 1], [0, 1 / c]])
# What is the cosine of $\beta$ there? (hint 1)
b_collision = sp.Matrix([[(1 - c) / c, 1], [0, 1 / c]])
b_collision_type = "saddle"  # Which signs do the two diagonal elements have? (hint 1)
b_collision_type = "unstable node"  # Which sign does $c$ have? (hint 1)
b_straight = (3 - r_T) / (b + 1)  # Does the target fly towards the pursuer? (hint 1)
b_straight = (3 - r_T) / sp.sqrt(b**2 - 1)  # Is this the time on a collision course? (hint 1)
b_straight = 3 - r_T  # For which speed of the pursuer is this right? (hint 1)
# Is this the time from a pursuer that flies straight at the target? (hint 1)
b_time = sp.Integer(2)
# Does the target fly straight away along the line of sight all the time? (hint 2)
b_time = sp.Float("2.694")

# %% right
a_control = sp.atan2(psi2, -psi1 * r * c)  # times a positive number
# the turn of the target's velocity less the turn of the line of sight
a_rate = (
    b * (1 - 1 / c) / r * sp.cos(alpha) * sp.sin(alpha - beta)
    - (sp.sin(alpha) - b * sp.sin(beta)) / r
)
b_time = sp.Float("2.779")  # four digits
b_straight = (r_T - 3) / (1 - b)  # both signs reversed
