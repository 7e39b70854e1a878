# %% wrong
# Does the point turn clockwise or counter-clockwise? (hint 1)
angular_rate = u * sp.cos(theta) ** 2 + sp.sin(theta) ** 2
# Were sine and cosine interchanged? (hint 1)
angular_rate = -u * sp.sin(theta) ** 2 - sp.cos(theta) ** 2
angular_rate = -sp.sqrt(u)  # Is this the mean rate of a whole turn? (hint 1)
time = 2 * time  # Is this a whole period instead of a half-turn? (hint 1)
time = 0  # Does the initial state count as a return?
time = time / 2  # Does x vanish at this time, or its rate? (hint 1)
control = softest  # Is the softest spring the fastest? (hint 2)
# Does the switching function change its sign where it touches zero? (hint 1)
control = sp.Piecewise((stiffest, t < time / 2), (softest, True))
control = stiffest + 1  # Does the bound allow so stiff a spring?
# Is this the motion with the softest spring? (hint 1)
trajectory = stretch * sp.cos(sp.sqrt(softest) * t)
# Is the frequency the stiffness itself, or its root? (hint 1)
trajectory = stretch * sp.cos(stiffest * t)
# Where does the motion start? (hint 1)
omega = sp.sqrt(stiffest)
trajectory = stretch * sp.sin(omega * t) / omega
# Was transversality forgotten? Look at psi1 at the end. (hint 1)
omega = sp.sqrt(stiffest)
c, s = sp.cos(omega * t) / stretch, sp.sin(omega * t) / stretch
costate = [c / omega - s / omega, -c / omega**2 - s / omega**2]
# Does H vanish with these costates? They have to be normalised. (hint 2)
omega = sp.sqrt(stiffest)
costate = [-omega * sp.sin(omega * t), -sp.cos(omega * t)]
# Is $\lambda_0$ positive with this sign? (hint 2)
costate = [-costate[0], -costate[1]]
costate = [costate[1], costate[0]]  # Were the two costates interchanged? (hint 1)
switching = -switching  # Does the function have the wrong sign? (hint 1)
# Is this psi2 alone? (hint 1)
switching = -sp.cos(sp.sqrt(stiffest) * t) / (stiffest * stretch)
# Does H vanish with these costates? They have to be normalised.
switching = sp.cos(sp.sqrt(stiffest) * t) ** 2
meeting = 2 * n * time  # Are these whole periods instead of half-turns? (hint 1)
meeting = (n - 1) * time  # What is the number of the initial state? (hint 1)
meeting = time  # Is this the first return for every n? (hint 1)

# %% right
angular_rate = -1 - (u - 1) * sp.cos(theta) ** 2  # over r^2
angular_rate = -(u + 1) / 2 - (u - 1) / 2 * sp.cos(2 * theta)  # doubled angle
time = round(float(time), 3)  # three digits
control = [[stiffest, time]]  # a list of one arc
# both states
omega = sp.sqrt(stiffest)
half = omega * t / 2
trajectory = [
    stretch * (1 - 2 * sp.sin(half) ** 2),
    -2 * omega * stretch * sp.sin(half) * sp.cos(half),
]
# products
omega = sp.sqrt(stiffest)
half = omega * t / 2
costate = [
    -2 * sp.sin(half) * sp.cos(half) / (omega * stretch),
    (1 - 2 * sp.cos(half) ** 2) / (omega**2 * stretch),
]
# a column, decimals
omega = sp.sqrt(stiffest)
first, second = float(1 / (omega * stretch)), float(1 / (omega**2 * stretch))
costate = sp.Matrix([-first * sp.sin(omega * t), -second * sp.cos(omega * t)])
# doubled angle
switching = (1 + sp.cos(2 * sp.sqrt(stiffest) * t)) / (2 * stiffest)
# by the sine
switching = 1 / stiffest - sp.sin(sp.sqrt(stiffest) * t) ** 2 / stiffest
meeting = round(float(time), 4) * n  # decimals

# %% numbers
softest, stiffest, stretch = [
    (1, 4, 1),
    (1, 9, 2),
    (4, 16, 1),
    (1, 25, 3),
    (4, 36, 2),
    (9, 49, 1),
    (1, 64, 2),
    (1, 121, 4),
    (1, 144, 1),
    (1, 169, 4),
    (4, 196, 2),
    (9, 225, 1),
    (1, 256, 3),
    (4, 81, 2),
    (1, 100, 3),
]
shown = [
    r"«softest» \leq u(t) \leq «stiffest» .",
    r"starts with $x(0) = «stretch»$",
]
omega = sp.sqrt(stiffest)
time = sp.pi / omega
control = sp.Integer(stiffest)
trajectory = stretch * sp.cos(omega * t)
costate = [-sp.sin(omega * t) / (omega * stretch), -sp.cos(omega * t) / (stiffest * stretch)]
switching = sp.cos(omega * t) ** 2 / stiffest
meeting = n * time
