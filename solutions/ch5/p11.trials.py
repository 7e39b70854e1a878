# %% wrong
angular_rate = u*sp.cos(theta)**2 + sp.sin(theta)**2  # counted clockwise
angular_rate = -u*sp.sin(theta)**2 - sp.cos(theta)**2  # sine and cosine exchanged
angular_rate = -sp.sqrt(u)  # the mean rate
time = sp.pi  # a whole period
time = 0  # the start itself, where the velocity vanishes
time = sp.pi/4  # a quarter of the period, when x vanishes
control = 1  # the softest spring
control = sp.Piecewise((4, t < sp.pi/4), (1, True))  # a switching at x = 0, where the switching function touches zero
control = 5  # stiffer than the bound allows
trajectory = sp.cos(t)  # the softest spring
trajectory = sp.cos(4*t)  # the frequency is the root of the stiffness
trajectory = sp.sin(2*t)/2  # starts at zero
# transversality forgotten: psi1 does not vanish at the end
costate = [sp.cos(2*t)/2 - sp.sin(2*t)/2, -sp.cos(2*t)/4 - sp.sin(2*t)/4]
costate = [-2*sp.sin(2*t), -sp.cos(2*t)]  # not normalised
costate = [sp.sin(2*t)/2, sp.cos(2*t)/4]  # the sign turned, lambda_0 = -1
costate = [-sp.cos(2*t)/4, -sp.sin(2*t)/2]  # the two exchanged
switching = -sp.cos(2*t)**2/4  # the sign turned
switching = -sp.cos(2*t)/4  # psi2 alone, which changes its sign
switching = sp.cos(2*t)**2  # not normalised
meeting = n*sp.pi  # whole periods
meeting = (n - 1)*sp.pi/2  # the start counted as number 1
meeting = sp.pi/2  # the first return for every n

# %% right
angular_rate = -1 - (u - 1)*sp.cos(theta)**2  # over r^2
angular_rate = -(u + 1)/2 - (u - 1)/2*sp.cos(2*theta)  # doubled angle
time = 1.57  # three digits
control = [[4, sp.pi/2]]  # a list of one arc
trajectory = [1 - 2*sp.sin(t)**2, -4*sp.sin(t)*sp.cos(t)]  # both states
costate = [-sp.sin(t)*sp.cos(t), sp.Rational(1, 4) - sp.cos(t)**2/2]  # products
costate = sp.Matrix([-0.5*sp.sin(2*t), -0.25*sp.cos(2*t)])  # a column, decimals
switching = (1 + sp.cos(4*t))/8  # doubled angle
switching = 0.25 - sp.sin(2*t)**2/4  # by the sine
meeting = 1.5708*n  # decimals
