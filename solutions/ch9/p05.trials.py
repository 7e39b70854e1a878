# %% wrong
# What is the sign of the derivative of $H$ in an adjoint equation? (hint 1)
a_adjoint = [
    0 * x,
    0 * x,
    V * (px * sp.cos(psi) - py * sp.sin(psi)),
    px * sp.sin(psi) + py * sp.cos(psi) - ppsi * k * u / V**2,
]
# Does the rate of the heading depend on the speed? (hint 2)
a_adjoint = [
    0 * x,
    0 * x,
    V * (py * sp.sin(psi) - px * sp.cos(psi)),
    -px * sp.sin(psi) - py * sp.cos(psi),
]
b_controls = [sp.sign(ppsi), mu2 * sp.sign(pV)]  # Which acceleration is the least one? (hint 2)
# Is $H$ to be made as great or as small as possible? (hint 2)
b_controls = [-sp.sign(ppsi), sp.Piecewise((mu1, pV > 0), (mu2, True))]
c_long = T  # Does the turn cost no distance? (hint 2)
c_long = 1 + T - phi  # How far does the vehicle move in this direction during the turn? (hint 2)
c_long = sp.sin(phi) + T  # How much time is left after the turn? (hint 2)
d_short = sp.sin(T)  # Is this the distance to the north? (hint 1)
d_short = 1 - sp.cos(T)  # Is this the distance to the east? (hint 1)
# What is the sign of the distance of a short flight? (hint 2)
d_short = sp.sin(phi - T) - sp.sin(phi)
# Is this the greatest without a condition on the last heading? (hint 1)
e_section = 1 + T - sp.pi / 2
e_section = T - sp.pi  # Does the vehicle move to the east while it turns? (hint 2)
e_section = 2 + T - sp.pi / 2  # How many turns are there, and how long do they take? (hint 2)

# %% right
# by the angle between heading and direction of the costates
a_adjoint = [
    sp.Integer(0),
    sp.Integer(0),
    -V * px * sp.cos(psi) + V * py * sp.sin(psi),
    (k * u * ppsi - V**2 * (px * sp.sin(psi) + py * sp.cos(psi))) / V**2,
]
# by the mean and half the width of the bounds
b_controls = [
    ppsi / sp.Abs(ppsi),
    (mu1 + mu2) / 2 + (mu2 - mu1) / 2 * sp.sign(pV),
]
c_long = T - (phi - sp.sin(phi))  # what the turn costs
d_short = 2 * sp.cos(phi - T / 2) * sp.sin(T / 2)  # a chord, by its direction
e_section = 2 * (1 - sp.cos(sp.pi / 2)) + (T - sp.pi)  # two arcs and a straight line
