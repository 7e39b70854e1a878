# %% wrong
a_control = -1  # Does this force help on the way to the right? (hint 2)
# Should the mass be braked before its stop? (hint 2)
a_control = sp.Piecewise((1, t < sp.pi / 2), (-1, True))
a_control = sp.cos(t)  # Does it pay to stay off the bound? (hint 2)
a_motion = -2 * sp.cos(t)  # Is this the free swing? (hint 1)
a_motion = -1 - sp.cos(t)  # About which point does the motion turn? (hint 1)
a_motion = 1 - 2 * sp.cos(t)  # Does this motion start at the given place? (hint 1)
a_costate = [sp.cos(t), -sp.sin(t)]  # Was the cost given the other sign? (hint 1)
a_costate = [-sp.cos(t) + sp.sin(t), sp.sin(t) + sp.cos(t)]  # Is H zero at the end? (hint 2)
a_time = 2 * sp.pi  # Is this a whole turn? (hint 1)
a_time = 0  # Is this the start itself? (hint 1)
a_reached = 2  # Is this reached without a force? (hint 1)
a_reached = 3  # Is this the radius of the circle, or the place where it ends? (hint 1)
a_reached = -4  # Is this J or the place? (hint 1)
b_control = -1  # To which side does this lead? (hint 1)
b_control = sp.Integer(0)  # Does the mass leave its place? (hint 1)
b_motion = sp.cos(t) - 1  # To which side does this lead? (hint 1)
b_motion = t**2 / 2  # Was the spring forgotten? (hint 1)
b_time = sp.pi / 2  # Is the velocity zero after a quarter of the circle? (hint 1)
b_reached = 1  # Is this the centre of the circle? (hint 1)
b_reached = -2  # Is this the worst process? (hint 1)
c_control = -1  # Which way does a push early in the motion move the place at its end? (hint 1)
# Is this the law for the velocity instead of the place? (hint 1)
c_control = sp.sign(sp.cos(t))
c_motion = -2 * sp.cos(t)  # Is this the free swing? (hint 1)
c_motion = 1 - 3 * sp.cos(t) + sp.sin(t)  # Does the mass start from rest? (hint 1)
# Is psi2 positive all the time? (hint 1)
c_costate = [-sp.cos(t) + sp.sin(t) / 2, sp.sin(t) + sp.cos(t) / 2]
c_costate = [sp.cos(t), -sp.sin(t)]  # Was the cost given the other sign? (hint 1)
c_reached = 2  # Was the integral of the force left out? (hint 1)
c_reached = 0  # Was the force taken with the other sign? (hint 1)

# %% right
a_control = [[1, sp.pi]]  # a list of one arc
a_motion = [6 * sp.sin(t / 2) ** 2 - 2, 3 * sp.sin(t)]  # half the angle, both states
a_costate = sp.Matrix([sp.sin(t - sp.pi / 2), sp.sin(sp.pi - t)])  # shifted, a column
a_time = 3.14159  # decimals
a_reached = sp.sqrt(16)  # a root
b_control = sp.sign(t)  # one sign for all times
b_motion = 2 * sp.sin(t / 2) ** 2  # half the angle
b_time = sp.acos(-1)  # an arc cosine
b_reached = 2.0  # a decimal
c_control = [(1, sp.pi)]  # a list of one arc
c_motion = [1 + 3 * sp.cos(sp.pi - t), 3 * sp.sin(t)]  # both states
c_costate = (-sp.cos(t), sp.cos(t - sp.pi / 2))  # a cosine
c_reached = 4.0  # a decimal
