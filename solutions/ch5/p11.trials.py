# %% wrong
# Does the point turn clockwise or counter-clockwise? (hint 1)
angular_rate = u * sp.cos(theta) ** 2 + sp.sin(theta) ** 2
# Did sine and cosine change places? (hint 1)
angular_rate = -u * sp.sin(theta) ** 2 - sp.cos(theta) ** 2
angular_rate = -sp.sqrt(u)  # Is this the mean rate of a whole turn? (hint 1)
time = sp.pi  # Is this a whole period instead of a half-turn? (hint 1)
time = 0  # Does the start count as a return?
time = sp.pi / 4  # Does x vanish at this time, or its rate? (hint 1)
control = 1  # Is the softest spring the fastest? (hint 2)
# Does the switching function change its sign where it touches zero? (hint 1)
control = sp.Piecewise((4, t < sp.pi / 4), (1, True))
control = 5  # Does the bound allow so stiff a spring?
trajectory = sp.cos(t)  # Is this the motion with the softest spring? (hint 1)
trajectory = sp.cos(4 * t)  # Is the frequency the stiffness itself, or its root? (hint 1)
trajectory = sp.sin(2 * t) / 2  # Where does the motion start? (hint 1)
# Was transversality forgotten? Look at psi1 at the end. (hint 1)
costate = [sp.cos(2 * t) / 2 - sp.sin(2 * t) / 2, -sp.cos(2 * t) / 4 - sp.sin(2 * t) / 4]
# Does H vanish with these costates? They have to be normalised. (hint 2)
costate = [-2 * sp.sin(2 * t), -sp.cos(2 * t)]
costate = [sp.sin(2 * t) / 2, sp.cos(2 * t) / 4]  # Is $\lambda_0$ positive with this sign? (hint 2)
costate = [-sp.cos(2 * t) / 4, -sp.sin(2 * t) / 2]  # Did the two costates change places? (hint 1)
switching = -(sp.cos(2 * t) ** 2) / 4  # Did the function get the wrong sign? (hint 1)
switching = -sp.cos(2 * t) / 4  # Is this psi2 alone? (hint 1)
switching = sp.cos(2 * t) ** 2  # Does H vanish with these costates? They have to be normalised.
meeting = n * sp.pi  # Are these whole periods instead of half-turns? (hint 1)
meeting = (n - 1) * sp.pi / 2  # Which number has the start? (hint 1)
meeting = sp.pi / 2  # Is this the first return, whatever n is? (hint 1)

# %% right
angular_rate = -1 - (u - 1) * sp.cos(theta) ** 2  # over r^2
angular_rate = -(u + 1) / 2 - (u - 1) / 2 * sp.cos(2 * theta)  # doubled angle
time = 1.57  # three digits
control = [[4, sp.pi / 2]]  # a list of one arc
trajectory = [1 - 2 * sp.sin(t) ** 2, -4 * sp.sin(t) * sp.cos(t)]  # both states
costate = [-sp.sin(t) * sp.cos(t), sp.Rational(1, 4) - sp.cos(t) ** 2 / 2]  # products
costate = sp.Matrix([-0.5 * sp.sin(2 * t), -0.25 * sp.cos(2 * t)])  # a column, decimals
switching = (1 + sp.cos(4 * t)) / 8  # doubled angle
switching = 0.25 - sp.sin(2 * t) ** 2 / 4  # by the sine
meeting = 1.5708 * n  # decimals
