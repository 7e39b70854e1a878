# %% wrong
a_control = bound  # Does the force push in the direction of motion? (hint 1)
a_control = 0  # Is the free oscillation the best motion? (hint 1)
# Where does the velocity change its sign? (hint 1)
a_control = sp.Piecewise((-bound, t < sp.pi / 2), (bound, True))
a_trajectory = start * sp.cos(t)  # Is this the motion without a force? (hint 1)
# Is this the motion with the force in the other direction? (hint 1)
a_trajectory = (start - bound) * sp.cos(t) + bound
# Does this motion start at the initial state? (hint 1)
a_trajectory = (start + bound) * sp.cos(t)
a_duration = sp.pi / 2  # Is this a quarter of a period? (hint 1)
a_duration = 2 * sp.pi  # Is this the second return? (hint 1)
a_cost = -sp.Rational(start**2, 2)  # Is this the initial energy? (hint 1)
a_cost = -start - 2 * bound  # Is the position the cost, or the energy? (hint 1)
a_cost = 2 * a_cost  # Was the factor in the cost forgotten? (hint 1)
# Is this the end for the other bound? (hint 1)
a_cost = -sp.Rational((start - 2 * bound) ** 2, 2)
a_costate = [-psi for psi in a_costate]  # Which sign does the costate have at the end? (hint 1)
# Does the costate at the end satisfy transversality? (hint 1)
a_costate = [sp.cos(t), -sp.sin(t)]
# Which sign does psi1 have in the equation for psi2? (hint 2)
a_costate = [a_costate[0], -a_costate[1]]
b_control = bound  # Is this the end nearest to zero? (hint 2)
# Does psi2 change its sign for the farthest end? (hint 1)
b_control = sp.Piecewise((bound, t < sp.pi / 2), (-bound, True))
b_control = -2 * bound  # Is this force within its bounds? (hint 1)
b_trajectory = start * sp.cos(t)  # Is this the motion without a force? (hint 1)
# Is this the motion to the final state nearest to zero? (hint 1)
b_trajectory = (start - bound) * sp.cos(t) + bound
b_cost = -sp.Rational(start**2, 2)  # Is this the energy without a force? (hint 1)
b_cost = -start - 2 * bound  # Is the distance the cost, or the energy? (hint 1)
# Is the farthest point of the disc to the side of its centre? (hint 1)
b_cost = -sp.Rational(start**2 + 4 * bound**2, 2)
# Does the costate have the direction of the state at the end? (hint 1)
b_costate = [-psi for psi in b_costate]
# Is this the end of the motion without a force? (hint 1)
b_costate = [start * sp.cos(t), -start * sp.sin(t)]

# %% right
a_control = [[-bound, sp.pi]]  # one arc
# half the angle
a_trajectory = 2 * (start + bound) * sp.cos(t / 2) ** 2 - start - 2 * bound
# both states
a_trajectory = [(start + bound) * sp.cos(t) - bound, -(start + bound) * sp.sin(t)]
a_duration = 3.14  # three digits
a_cost = float(a_cost)  # decimals
# a shifted time
a_costate = [(start + 2 * bound) * f(t + sp.pi / 2) for f in (sp.sin, sp.cos)]
b_control = -bound * sp.sign(sp.sin(t))  # the sign of psi2
b_trajectory = start - 2 * (start + bound) * sp.sin(t / 2) ** 2  # half the angle
b_cost = -sp.sqrt(4 * b_cost**2) / 2  # a root
# a column, half the angle
s, c = sp.sin(t / 2), sp.cos(t / 2)
b_costate = (start + 2 * bound) * sp.Matrix([1 - 2 * s**2, -2 * s * c])

# %% numbers
start, bound = [
    (3, 1),
    (5, 2),
    (4, 3),
    (7, 6),
    (5, 4),
    (2, sp.Rational(1, 2)),
    (3, sp.Rational(3, 2)),
    (3, sp.Rational(5, 2)),
    (4, sp.Rational(7, 2)),
    (7, sp.Rational(13, 2)),
    (6, sp.Rational(11, 2)),
    (6, 5),
]
shown = [r"|u(t)| \leq «bound»,", r"x(0) = «start», \quad"]
a_control = b_control = sp.sympify(-bound)
a_trajectory = b_trajectory = (start + bound) * sp.cos(t) - bound
a_cost = b_cost = -sp.Rational((start + 2 * bound) ** 2, 2)
a_costate = b_costate = [(start + 2 * bound) * sp.cos(t), -(start + 2 * bound) * sp.sin(t)]
