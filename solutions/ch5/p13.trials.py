# %% wrong
meeting = n*sp.pi/2  # the fastest spring
meeting = 2*n*sp.pi  # whole periods
meeting = sp.pi  # the first return only
time = sp.pi/2  # the fastest spring
time = 2*sp.pi  # a whole period, past the first return
time = sp.Integer(10)**6  # no bound, as for the question as printed
control = 4  # the fastest spring
control = sp.Piecewise((1, t < sp.pi/2), (4, True))  # stiff half of the time
control = sp.Rational(1, 4)  # softer than the bound allows
trajectory = sp.cos(2*t)  # the fastest spring
trajectory = (3 + sp.cos(2*t))/4  # goes on beyond x = -1 after a first return at half the time
trajectory = sp.sin(t)  # the start of Problem 5.12
costate = [-sp.sin(t), -sp.cos(t)]  # the sign of the costates for the least time
costate = [-sp.sin(2*t)/2, -sp.cos(2*t)/4]  # those of Problem 5.11
costate = [sp.cos(t), sp.sin(t)]  # the two exchanged
switching = sp.cos(t)**2  # the sign turned
switching = -sp.cos(t)  # psi2 alone
switching = sp.cos(2*t)**2/4  # that of Problem 5.11

# %% right
meeting = 3.1416*n  # decimals
time = 3.14  # three digits
control = [[1, sp.pi]]  # a list of one arc
trajectory = [2*sp.cos(t/2)**2 - 1, -sp.sin(t)]  # both states
costate = sp.Matrix([sp.sin(t), sp.cos(t)])  # a column
costate = (2*sp.sin(t/2)*sp.cos(t/2), 1 - 2*sp.sin(t/2)**2)  # half angles, a tuple
switching = sp.sin(t)**2 - 1  # by the sine
switching = -(1 + sp.cos(2*t))/2  # doubled angle
