# %% wrong
# Does the point turn clockwise or counter-clockwise? (hint 1)
angular_rate = u * sp.cos(theta) ** 2 + sp.sin(theta) ** 2
angular_rate = -u  # Is the control the whole rate of the angle? (hint 1)
time = sp.pi / 2  # Is this a half-turn? The motion starts in the middle. (hint 1)
time = sp.pi / 8  # Is the frequency the stiffness itself, or its root? (hint 2)
control = 1  # Is the softest spring the fastest? (hint 1)
# Does the switching function change its sign on the way? (hint 1)
control = sp.Piecewise((1, t < sp.pi / 8), (4, True))
control = -4  # Does the bound allow this value?
trajectory = sp.sin(2 * t)  # Which velocity has this motion at the start? (hint 1)
trajectory = sp.sin(t)  # Is this the motion with the softest spring? (hint 1)
trajectory = sp.cos(2 * t)  # Is this the start of problem 5.11? (hint 1)
# Are these the costates of problem 5.11? (hint 1)
costate = [
    -sp.sin(2 * t) / 2,
    -sp.cos(2 * t) / 4,
]
costate = [-sp.cos(2 * t), sp.sin(2 * t) / 2]  # Is $\lambda_0$ positive with this sign? (hint 1)
# Which sign stands between psi1 and the rate of psi2? (hint 1)
costate = [-sp.cos(2 * t), -sp.sin(2 * t) / 2]
switching = sp.cos(2 * t) ** 2 / 4  # Is this the function of problem 5.11? (hint 1)
switching = -(sp.sin(2 * t) ** 2) / 4  # Did the function get the wrong sign? (hint 1)
switching = sp.sin(2 * t) ** 2  # Does H vanish with these costates? They have to be normalised.
latest = sp.pi / 4  # Is this the least time instead of the greatest? (hint 1)
latest = sp.pi  # Is this a half-turn? The motion starts in the middle.

# %% right
angular_rate = -(u + 1) / 2 - (u - 1) / 2 * sp.cos(2 * theta)  # doubled angle
time = 0.785  # three digits
control = [[4, sp.pi / 4]]  # a list of one arc
trajectory = sp.sin(t) * sp.cos(t)  # a product
trajectory = sp.Matrix([sp.sin(2 * t) / 2, sp.cos(2 * t)])  # both states, a column
costate = [1 - 2 * sp.sin(t) ** 2, -sp.sin(t) * sp.cos(t)]  # squares and products
costate = (1.0 * sp.cos(2 * t), -0.5 * sp.sin(2 * t))  # a tuple, decimals
switching = (1 - sp.cos(4 * t)) / 8  # doubled angle
switching = sp.sin(t) ** 2 * sp.cos(t) ** 2  # a product
latest = 1.57  # three digits
