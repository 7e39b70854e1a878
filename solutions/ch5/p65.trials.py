# %% wrong
control = control + motion  # Is the whole velocity due to the control? (hint 2)
control = -control  # Which sign does u have in the equation of motion? (hint 2)
control = end * (1 - t)  # Does this belong to a uniform motion? What does it cost? (hint 1)
# Was the cost of x forgotten? (hint 1)
control = end * (sp.cosh(t) - sp.sinh(t)) / sp.sinh(1)
# Does the law for an infinite time lead away from zero? (hint 1)
control = -(1 + sp.sqrt(1 + weight)) * motion
# Was the free motion of the system left out in the elimination? (hint 1)
motion = end * sp.sinh(sp.sqrt(weight) * t) / sp.sinh(sp.sqrt(weight))
motion = end * t  # Is the straight line an extremal? (hint 1)
# Which sign does the term with x have in the second-order equation? (hint 1)
rate = sp.sqrt(1 + weight)
motion = end * sp.sin(rate * t) / sp.sin(rate)
motion = end * sp.exp(sp.sqrt(1 + weight) * (t - 1))  # Where does this motion begin? (hint 2)
motion = end * sp.sinh(t) / sp.sinh(1)  # Does a deviation from zero cost nothing? (hint 1)
costate = -costate  # If H is maximised, which sign does the costate have? (hint 1)
costate = 2 * costate  # Was the half in front of the integral left out? (hint 1)
# Does the Riccati equation for an infinite time apply to a given end value? (hint 1)
costate = -(1 + sp.sqrt(1 + weight)) * motion
cost = 2 * cost  # Was the half in front of the integral left out? (hint 1)
cost = cost + sp.Rational(end**2, 2)  # Was a derivative in the integrand forgotten? (hint 1)
# Which sign does the product of x and its velocity have in the square of u? (hint 1)
cost = cost + end**2
# Is this bound attained by a motion with these ends?
cost = end**2 * (sp.sqrt(1 + weight) - 1) / 2

# %% right
# with exponentials
rate = sp.sqrt(1 + weight)
growing, decaying = (rate - 1) * sp.exp(rate * t), (rate + 1) * sp.exp(-rate * t)
control = end * (growing + decaying) / (sp.exp(rate) - sp.exp(-rate))
# of the half argument
half = sp.sqrt(1 + weight) / 2
motion = end * sp.sinh(half * t) * sp.cosh(half * t) / (sp.sinh(half) * sp.cosh(half))
costate = [control]  # a list of one
# with an exponential
rate = sp.sqrt(1 + weight)
cost = end**2 * (rate - 1 + 2 * rate / (sp.exp(2 * rate) - 1)) / 2
cost = round(float(cost), 3)  # three digits

# %% numbers
weight, end = [
    (rate**2 - 1, end)
    for rate, end in [
        *[(2, 1), (3, 1), (4, 1), (2, 2), (3, 2), (4, 2), (2, 3)],
        *[(3, 3), (4, 3), (2, 4), (3, 4), (4, 4), (2, 5), (3, 5)],
    ]
]
shown = [r"$x(1) = «end»$", r"\big(«weight*»x^2 + u^2\big)"]
rate = sp.sqrt(1 + weight)
motion = end * sp.sinh(rate * t) / sp.sinh(rate)
control = costate = sp.diff(motion, t) - motion
cost = end**2 * (rate * sp.coth(rate) - 1) / 2
