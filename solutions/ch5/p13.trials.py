# %% wrong
meeting = n * sp.pi / 2  # Is this the time of the fastest spring? (hint 1)
meeting = 2 * n * sp.pi  # Are these whole periods instead of half-turns? (hint 2)
meeting = sp.pi  # Is this the first return for every n? (hint 2)
time = sp.pi / 2  # Is this the time of the fastest spring? (hint 1)
time = 2 * sp.pi  # Is this a whole period, past the first return? (hint 1)
# Is there no bound at all? The velocity has to vanish at some time. (hint 1)
time = sp.Integer(10) ** 6
control = 4  # Is the stiffest spring the slowest? (hint 1)
# Would a stiff spring for half of the time make the return later? (hint 1)
control = sp.Piecewise((1, t < sp.pi / 2), (4, True))
control = sp.Rational(1, 4)  # Does the bound allow so soft a spring?
trajectory = sp.cos(2 * t)  # Is this the motion with the fastest spring? (hint 1)
# Does this motion start at the given position, and is the spring the right one? (hint 1)
trajectory = (3 + sp.cos(2 * t)) / 4
trajectory = sp.sin(t)  # Is this the initial state of problem 5.12? (hint 1)
costate = [-sp.sin(t), -sp.cos(t)]  # Are these the costates for minimum time? (hint 1)
# Are these the costates of problem 5.11? (hint 1)
costate = [
    -sp.sin(2 * t) / 2,
    -sp.cos(2 * t) / 4,
]
costate = [sp.cos(t), sp.sin(t)]  # Were the two costates interchanged? (hint 1)
switching = sp.cos(t) ** 2  # Does the function have the wrong sign? (hint 1)
switching = -sp.cos(t)  # Is this psi2 alone? (hint 1)
switching = sp.cos(2 * t) ** 2 / 4  # Is this the function of problem 5.11? (hint 1)

# %% right
meeting = 3.1416 * n  # decimals
time = 3.14  # three digits
control = [[1, sp.pi]]  # a list of one arc
trajectory = [2 * sp.cos(t / 2) ** 2 - 1, -sp.sin(t)]  # both states
costate = sp.Matrix([sp.sin(t), sp.cos(t)])  # a column
costate = (2 * sp.sin(t / 2) * sp.cos(t / 2), 1 - 2 * sp.sin(t / 2) ** 2)  # half angles, a tuple
switching = sp.sin(t) ** 2 - 1  # by the sine
switching = -(1 + sp.cos(2 * t)) / 2  # doubled angle
