# %% wrong
a_control = -bound  # Does this force help on the way to the right? (hint 2)
# Should the mass be braked before its stop? (hint 2)
a_control = sp.Piecewise((bound, t < sp.pi / 2), (-bound, True))
a_control = bound * sp.cos(t)  # Is it worthwhile to stay off the bound? (hint 2)
a_motion = start * sp.cos(t)  # Is this the free swing? (hint 1)
# About which point does the motion turn? (hint 1)
a_motion = (start + bound) * sp.cos(t) - bound
a_motion = bound + start * sp.cos(t)  # Does this motion start at the given position? (hint 1)
a_costate = [sp.cos(t), -sp.sin(t)]  # Was the sign of the cost reversed? (hint 1)
a_costate = [-sp.cos(t) + sp.sin(t), sp.sin(t) + sp.cos(t)]  # Is H zero at the end? (hint 2)
a_time = 2 * sp.pi  # Is this a whole turn? (hint 1)
a_time = 0  # Is this the initial position itself? (hint 1)
a_reached = -start  # Is this reached without a force? (hint 1)
# Is this the radius of the circle, or the position where it ends? (hint 1)
a_reached = bound - start
a_reached = -a_reached  # Is this J or the position? (hint 1)
b_control = -bound  # To which side does this lead? (hint 1)
b_control = sp.Integer(0)  # Does the mass move at all? (hint 1)
b_motion = bound * (sp.cos(t) - 1)  # To which side does this lead? (hint 1)
b_motion = bound * t**2 / 2  # Was the spring forgotten? (hint 1)
b_time = sp.pi / 2  # Is the velocity zero after a quarter of the circle? (hint 1)
b_reached = bound  # Is this the centre of the circle? (hint 1)
b_reached = -2 * bound  # Is this the worst process? (hint 1)
# In which direction does an early push move the final position? (hint 1)
c_control = -bound
# Is this the law for the velocity instead of the position? (hint 1)
c_control = bound * sp.sign(sp.cos(t))
c_motion = start * sp.cos(t)  # Is this the free swing? (hint 1)
c_motion = a_motion + sp.sin(t)  # Does the mass start from rest? (hint 1)
# Is psi2 positive all the time? (hint 1)
c_costate = [-sp.cos(t) + sp.sin(t) / 2, sp.sin(t) + sp.cos(t) / 2]
c_costate = [sp.cos(t), -sp.sin(t)]  # Was the sign of the cost reversed? (hint 1)
c_reached = -start  # Was the integral of the force left out? (hint 1)
c_reached = -start - 2 * bound  # Was the sign of the force reversed? (hint 1)

# %% right
a_control = [[bound, sp.pi]]  # a list of one arc
# half the angle, both states
a_motion = [2 * (bound - start) * sp.sin(t / 2) ** 2 + start, (bound - start) * sp.sin(t)]
a_costate = sp.Matrix([sp.sin(t - sp.pi / 2), sp.sin(sp.pi - t)])  # shifted, a column
a_time = 3.14159  # decimals
a_reached = sp.sqrt((2 * bound - start) ** 2)  # a root
b_control = bound * sp.sign(t)  # one sign for all times
b_motion = 2 * bound * sp.sin(t / 2) ** 2  # half the angle
b_time = sp.acos(-1)  # an arc cosine
b_reached = float(b_reached)  # a decimal
c_control = [(bound, sp.pi)]  # a list of one arc
# both states
c_motion = [bound + (bound - start) * sp.cos(sp.pi - t), (bound - start) * sp.sin(t)]
c_costate = (-sp.cos(t), sp.cos(t - sp.pi / 2))  # a cosine
c_reached = float(c_reached)  # a decimal

# %% numbers
start, bound = [
    (-2, 1),
    (-3, 2),
    (-5, 3),
    (-6, 4),
    (-10, 8),
    (-9, 7),
    (-10, 9),
    (-7, 5),
    (-12, 11),
    (-14, 12),
    (-7, 6),
    (-16, 13),
]
shown = [
    r"|u| \leq «bound», \qquad",
    r"x(0) = «start», \quad",
    r"$(x - «bound»)^2 + \dot x^2$",
]
a_control = b_control = c_control = sp.Integer(bound)
a_motion = c_motion = bound - (bound - start) * sp.cos(t)
b_motion = bound * (1 - sp.cos(t))
a_reached = c_reached = sp.Integer(2 * bound - start)
b_reached = sp.Integer(2 * bound)
