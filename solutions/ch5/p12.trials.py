# %% wrong
angular_rate = u*sp.cos(theta)**2 + sp.sin(theta)**2  # counted clockwise
angular_rate = -u  # the control taken for the whole rate
time = sp.pi/2  # a half-turn, as in Problem 5.11
time = sp.pi/8  # the frequency taken for 4
control = 1  # the softest spring
# the least stiffness first, since the switching function starts at zero
control = sp.Piecewise((1, t < sp.pi/8), (4, True))
control = -4  # beyond the bounds, with the opposite sign
trajectory = sp.sin(2*t)  # the velocity at the start is 2
trajectory = sp.sin(t)  # the softest spring
trajectory = sp.cos(2*t)  # the start of Problem 5.11
costate = [-sp.sin(2*t)/2, -sp.cos(2*t)/4]  # the costates of Problem 5.11
costate = [-sp.cos(2*t), sp.sin(2*t)/2]  # lambda_0 = -1
costate = [-sp.cos(2*t), -sp.sin(2*t)/2]  # psi1 taken for +psi2'
switching = sp.cos(2*t)**2/4  # that of Problem 5.11
switching = -sp.sin(2*t)**2/4  # the sign turned
switching = sp.sin(2*t)**2  # not normalised
latest = sp.pi/4  # the least time
latest = sp.pi  # a half-turn

# %% right
angular_rate = -(u + 1)/2 - (u - 1)/2*sp.cos(2*theta)  # doubled angle
time = 0.785  # three digits
control = [[4, sp.pi/4]]  # a list of one arc
trajectory = sp.sin(t)*sp.cos(t)  # a product
trajectory = sp.Matrix([sp.sin(2*t)/2, sp.cos(2*t)])  # both states, a column
costate = [1 - 2*sp.sin(t)**2, -sp.sin(t)*sp.cos(t)]  # squares and products
costate = (1.0*sp.cos(2*t), -0.5*sp.sin(2*t))  # a tuple, decimals
switching = (1 - sp.cos(4*t))/8  # doubled angle
switching = sp.sin(t)**2*sp.cos(t)**2  # a product
latest = 1.57  # three digits
