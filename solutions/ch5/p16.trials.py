# %% wrong
a_control = 1  # Does the force push the way the mass moves? (hint 1)
a_control = 0  # Is the free oscillation the best one can do? (hint 1)
# Where does the velocity change its sign? (hint 1)
a_control = sp.Piecewise((-1, t < sp.pi / 2), (1, True))
a_trajectory = 3 * sp.cos(t)  # Is this the motion without a force? (hint 1)
# Is this the motion with the force in the other direction? (hint 1)
a_trajectory = 2 * sp.cos(t) + 1
a_trajectory = 4 * sp.cos(t)  # Does this motion begin where the mass does? (hint 1)
a_duration = sp.pi / 2  # Is this a quarter of a period? (hint 1)
a_duration = 2 * sp.pi  # Is this the second return? (hint 1)
a_cost = sp.Rational(-9, 2)  # Is this the energy at the start? (hint 1)
a_cost = -5  # Is the place the cost, or the energy? (hint 1)
a_cost = -25  # Was the factor in the cost forgotten? (hint 1)
a_cost = sp.Rational(-1, 2)  # Is this the end for the other bound? (hint 1)
a_costate = [-5 * sp.cos(t), 5 * sp.sin(t)]  # Which sign has the costate at the end? (hint 1)
# Does the costate at the end satisfy transversality? (hint 1)
a_costate = [sp.cos(t), -sp.sin(t)]
a_costate = [5 * sp.cos(t), 5 * sp.sin(t)]  # Which sign has psi1 in the equation for psi2? (hint 2)
b_control = 1  # Is this the end next to zero? (hint 2)
# Does psi2 change its sign for the farthest end? (hint 1)
b_control = sp.Piecewise((1, t < sp.pi / 2), (-1, True))
b_control = -2  # Is this force within its bounds? (hint 1)
b_trajectory = 3 * sp.cos(t)  # Is this the motion without a force? (hint 1)
b_trajectory = 2 * sp.cos(t) + 1  # Is this the motion to the end next to zero? (hint 1)
b_cost = sp.Rational(-9, 2)  # Is this the energy without a force? (hint 1)
b_cost = -5  # Is the distance the cost, or the energy? (hint 1)
b_cost = sp.Rational(-13, 2)  # Is the farthest point of the disc beside its centre? (hint 1)
# Has the costate the direction of the state at the end? (hint 1)
b_costate = [-5 * sp.cos(t), 5 * sp.sin(t)]
# Is this the end of the motion without a force? (hint 1)
b_costate = [3 * sp.cos(t), -3 * sp.sin(t)]

# %% right
a_control = [[-1, sp.pi]]  # one arc
a_trajectory = 8 * sp.cos(t / 2) ** 2 - 5  # half the angle
a_trajectory = [4 * sp.cos(t) - 1, -4 * sp.sin(t)]  # both states
a_duration = 3.14  # three digits
a_cost = -12.5  # decimals
a_costate = [5 * sp.sin(t + sp.pi / 2), 5 * sp.cos(t + sp.pi / 2)]  # a shifted time
b_control = -sp.sign(sp.sin(t))  # the sign of psi2
b_trajectory = 3 - 8 * sp.sin(t / 2) ** 2  # half the angle
b_cost = -sp.sqrt(625) / 2  # a root
# a column, half the angle
b_costate = sp.Matrix([5 - 10 * sp.sin(t / 2) ** 2, -10 * sp.sin(t / 2) * sp.cos(t / 2)])
