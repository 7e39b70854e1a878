# %% wrong
# Does the point turn clockwise or counter-clockwise? (hint 1)
angular_rate = u * sp.cos(theta) ** 2 + sp.sin(theta) ** 2
angular_rate = -u  # Is the control the whole rate of the angle? (hint 1)
time = 2 * time  # Is this a half-turn? The motion starts in the middle. (hint 1)
# Is the frequency the stiffness itself, or its root? (hint 2)
time = sp.pi / (2 * stiffest)
control = softest  # Is the softest spring the fastest? (hint 1)
# Does the switching function change its sign along the motion? (hint 1)
control = sp.Piecewise((softest, t < time / 2), (stiffest, True))
control = -stiffest  # Does the bound allow this value?
# What is the initial velocity of this motion? (hint 1)
trajectory = push * sp.sin(sp.sqrt(stiffest) * t)
# Is this the motion with the softest spring? (hint 1)
trajectory = push * sp.sin(sp.sqrt(softest) * t) / sp.sqrt(softest)
# Is this the initial state of problem 5.11? (hint 1)
trajectory = push * sp.cos(sp.sqrt(stiffest) * t)
# Are these the costates of problem 5.11? (hint 1)
omega = sp.sqrt(stiffest)
costate = [-sp.sin(omega * t) / omega, -sp.cos(omega * t) / stiffest]
costate = [-costate[0], -costate[1]]  # Is $\lambda_0$ positive with this sign? (hint 1)
# Which sign relates psi1 and the rate of psi2? (hint 1)
costate = [-costate[0], costate[1]]
# Is this the function of problem 5.11? (hint 1)
switching = sp.cos(sp.sqrt(stiffest) * t) ** 2 / stiffest
switching = -switching  # Does the function have the wrong sign? (hint 1)
# Does H vanish with these costates? They have to be normalised.
switching = sp.sin(sp.sqrt(stiffest) * t) ** 2
latest = time  # Is this the minimum time instead of the maximum? (hint 1)
latest = 2 * latest  # Is this a half-turn? The motion starts in the middle.

# %% right
angular_rate = -(u + 1) / 2 - (u - 1) / 2 * sp.cos(2 * theta)  # doubled angle
time = round(float(time), 3)  # three digits
control = [[stiffest, time]]  # a list of one arc
# a product
omega = sp.sqrt(stiffest)
trajectory = 2 * push / omega * sp.sin(omega * t / 2) * sp.cos(omega * t / 2)
# both states, a column
omega = sp.sqrt(stiffest)
trajectory = push * sp.Matrix([sp.sin(omega * t) / omega, sp.cos(omega * t)])
# squares and products
omega = sp.sqrt(stiffest)
s, c = sp.sin(omega * t / 2), sp.cos(omega * t / 2)
costate = [(1 - 2 * s**2) / push, -2 * s * c / (omega * push)]
# a tuple, decimals
omega = sp.sqrt(stiffest)
first, second = float(1 / sp.Integer(push)), float(1 / (omega * push))
costate = (first * sp.cos(omega * t), -second * sp.sin(omega * t))
switching = (1 - sp.cos(2 * sp.sqrt(stiffest) * t)) / (2 * stiffest)  # doubled angle
# a product
half = sp.sqrt(stiffest) * t / 2
switching = 4 * sp.sin(half) ** 2 * sp.cos(half) ** 2 / stiffest
latest = round(float(latest), 3)  # three digits

# %% numbers
softest, stiffest, push = [
    (1, 4, 1),
    (4, 9, 2),
    (4, 16, 1),
    (9, 25, 3),
    (4, 36, 2),
    (9, 49, 1),
    (1, 64, 2),
    (4, 100, 1),
    (1, 121, 4),
    (9, 144, 2),
    (1, 169, 1),
    (16, 196, 3),
    (1, 225, 2),
    (4, 81, 2),
]
shown = [
    r"«softest» \leq u(t) \leq «stiffest» ,",
    r"$\dot x(0) = «push»$",
    r"its velocity at the initial instant is «push».",
]
omega = sp.sqrt(stiffest)
time, latest = sp.pi / (2 * omega), sp.pi / (2 * sp.sqrt(softest))
control = sp.Integer(stiffest)
trajectory = push * sp.sin(omega * t) / omega
costate = [sp.cos(omega * t) / push, -sp.sin(omega * t) / (omega * push)]
switching = sp.sin(omega * t) ** 2 / stiffest
