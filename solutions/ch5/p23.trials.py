# %% wrong
# Which sign does the cost have in the adjoint equation? (hint 1)
costate = [-psi for psi in costate]
# Was the velocity in the cost forgotten? (hint 2)
costate = [costate[0], costate[1] - weight * (t - sp.Rational(duration, 2))]
# Where does the control switch, and where is this second function zero? (hint 2)
costate = [costate[0], (weight + duration) * t - t**2 / 2]
# Where should the carriage be most of the time? (hint 1)
control = sp.Piecewise((bound, t < sp.Rational(duration, 2)), (-bound, True))
control = -bound  # Is the velocity zero at the end? (hint 2)
control = sp.Integer(0)  # Is rest the best motion? (hint 1)
trajectory = -bound * t**2 / 2  # Does this motion come to rest at the end? (hint 1)
# Do the two arcs join? (hint 1)
trajectory = bound * sp.Piecewise(
    (-(t**2) / 2, t < sp.Rational(duration, 2)), ((t - duration) ** 2 / 2, True)
)
trajectory = -trajectory  # Is the cost small on this side? (hint 1)
# Was the integral of the velocity left out? (hint 1)
cost = -sp.Rational(bound * duration**3, 8)
cost = -cost  # Is this the maximum? (hint 1)

# %% right
# factors, a column
costate = sp.Matrix(
    [t - duration, (2 * weight + 3 * sp.Rational(duration, 2) - t) * (2 * t - duration) / 4]
)
# a list of arcs
control = [[-bound, sp.Rational(duration, 2)], [bound, duration]]
control = bound * sp.sign(2 * t - duration)  # the sign of the switching function
# both states
half = sp.Rational(duration, 2)
second = (t - duration) ** 2 / 2 - half**2
position = bound * sp.Piecewise((-(t**2) / 2, t <= half), (second, True))
trajectory = [position, bound * (sp.Abs(t - half) - half)]
# the second arc first, expanded
half = sp.Rational(duration, 2)
second = half**2 - duration * t + t**2 / 2
trajectory = bound * sp.Piecewise((second, t > half), (-(t**2) / 2, True))
cost = float(cost)  # a decimal

# %% numbers
bound, weight, duration = [
    (1, 1, 2),
    (2, 2, 4),
    (3, 1, 4),
    (2, 3, 2),
    (5, 5, 2),
    (2, 1, 6),
    (3, 4, 2),
    (1, 3, 6),
    (4, 2, 2),
    (6, 6, 2),
    (3, 2, 6),
    (4, 3, 4),
    (1, 4, 4),
    (3, 3, 8),
]
shown = [
    r"$|u| \leq «bound»$",
    r"$\dot x(«duration») = 0$",
    r"\int_0^«duration»(x + «weight*»\dot x)\,dt",
    "at $t = «duration»$",
    "$x(«duration»)$",
]
half = sp.Rational(duration, 2)
rate = weight + duration - t
costate = [t - duration, sp.integrate(rate, t) - sp.integrate(rate, t).subs(t, half)]
control = sp.Piecewise((-bound, t < half), (bound, True))
second = bound * ((t - duration) ** 2 / 2 - half**2)
trajectory = sp.Piecewise((-bound * t**2 / 2, t < half), (second, True))
cost = -bound * (half**3 + weight * half**2)
