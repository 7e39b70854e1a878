# %% wrong
drift_begins = -x2 * sp.Abs(x2) / 2  # Does the drive stay on until the body has to brake? (hint 1)
drift_begins = -2 * price * x2 * sp.Abs(x2)  # Was the braking distance left out? (hint 3)
# Is it the same parabola for both signs of the velocity? (hint 3)
drift_begins = (2 * price + sp.Rational(1, 2)) * x2**2
# By how much does the second costate fall while the body drifts? (hint 2)
drift_begins = -(price + sp.Rational(1, 2)) * x2 * sp.Abs(x2)
drift_ends = x2 * sp.Abs(x2) / 2  # Do these branches lead to the origin, or away from it? (hint 1)
drift_ends = drift_begins  # Which of the two changes comes last? (hint 1)
drift_ends = -(x2**2) / 2  # Is it the same parabola for both signs of the velocity? (hint 1)
law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Does the fuel cost nothing here? (hint 1)
# What lies between the two curves? (hint 1)
law = -sp.sign(x1 - drift_begins)
# Do the two sides of the curves have the right signs?
law = (sp.sign(x1 - drift_begins) + sp.sign(x1 + x2 * sp.Abs(x2) / 2)) / 2
# Does the body brake too late here?
law = -(sp.sign(x1 - drift_begins) + sp.sign(x1 + x2 * sp.Abs(x2) / 4)) / 2
# Do the curves look the same for both signs of the velocity? (hint 1)
k = 2 * price + sp.Rational(1, 2)
law = sp.Piecewise((-1, x1 > k * x2**2), (0, x1 > x2**2 / 2), (1, True))
# Does this hold for all three kinds of initial states? (hint 2)
cost = (1 + price) * b + 2 * sp.sqrt((1 + 2 * price) * (a + b**2 / 2))
# Is this the time alone?
speed = sp.sqrt((a + b**2 / 2) / (1 + 2 * price))
cost = sp.Piecewise((b + 2 * (1 + price) * speed, a > -b * sp.Abs(b) / 2), (0, True))
cost = 2 * sp.sqrt(sp.Abs(a))  # Is this the minimum time from rest?
control = [[-1, sp.sqrt(d)], [1, 2 * sp.sqrt(d)]]  # Does the fuel cost nothing here? (hint 1)
# Are the three arcs equally long? (hint 1)
control = [[-1, sp.sqrt(d / 2)], [0, sp.sqrt(2 * d)], [1, 3 * sp.sqrt(d / 2)]]
# Is the drift half as long as each of the other arcs?
control = [
    [-1, sp.sqrt(2 * d / 3)],
    [0, 3 * sp.sqrt(2 * d / 3) / 2],
    [1, 5 * sp.sqrt(2 * d / 3) / 2],
]
duration = 2 * sp.sqrt(d)  # Is this the fastest transfer? (hint 1)
duration = 3 * sp.sqrt(d / 2)  # Are the three arcs equally long? (hint 1)
# Is this the cost of the transfer? (hint 1)
duration = 2 * sp.sqrt((1 + 2 * price) * d)
# Was the sign of the cost reversed? (hint 1)
costate = [-costate[0], -costate[1]]
# What is the second costate where the control changes? (hint 1)
costate = [costate[0], -costate[0] * t - 1]
# Do these costates belong to the fastest transfer? (hint 1)
costate = [-1 / sp.sqrt(d), t / sp.sqrt(d) - 1]

# %% right
# cases
k = 2 * price + sp.Rational(1, 2)
drift_begins = sp.Piecewise((k * x2**2, x2 < 0), (-k * x2**2, True))
# with the sign
drift_begins = -(2 * price + sp.Rational(1, 2)) * sp.sign(x2) * x2**2
drift_ends = sp.Piecewise((x2**2 / 2, x2 < 0), (-(x2**2) / 2, True))  # cases
# half the sum of two signs
law = -(sp.sign(x1 - drift_begins) + sp.sign(x1 + x2 * sp.Abs(x2) / 2)) / 2
# solved for the velocity
fast = sp.sqrt(2 * sp.Abs(x1))
slow = sp.sqrt(sp.Abs(x1) / (2 * price + sp.Rational(1, 2)))
v = sp.sign(x1) * x2
law = sp.sign(x1) * sp.Piecewise((1, v < -fast), (0, v < -slow), (-1, True))
# by the side and one formula
m = 1 + 2 * price
switching = a + (m - sp.Rational(1, 2)) * b * sp.Abs(b)
e = sp.sign(switching)
cost = sp.Piecewise(
    (
        sp.Abs(a / b) + (price + sp.Rational(1, 2)) * sp.Abs(b),
        switching * (a + b * sp.Abs(b) / 2) < 0,
    ),
    ((1 + price) * e * b + sp.sqrt(4 * m * e * a + 2 * m * b**2), True),
)
# cases
v = sp.sqrt(d / (1 + 2 * price))
control = sp.Piecewise((-1, t < v), (0, t < (1 + 2 * price) * v), (1, True))
# one root
duration = sp.sqrt(4 * (1 + price) ** 2 / (1 + 2 * price) * d)
# decimals
duration = round(float(duration.subs(d, 1)), 4) * sp.sqrt(d)
# with the root above
m = 1 + 2 * price
costate = [-sp.sqrt(m * d) / d, (t * sp.sqrt(m * d) - (1 + price) * d) / d]

# %% numbers
price = [
    sp.Rational(p, q)
    for p, q in [
        (3, 4),
        (1, 3),
        (2, 3),
        (1, 1),
        (2, 5),
        (3, 5),
        (4, 5),
        (5, 6),
        (3, 8),
        (5, 8),
        (7, 8),
        (1, 6),
        (1, 5),
        (7, 9),
        (4, 9),
        (5, 4),
        (3, 2),
        (7, 4),
        (5, 2),
    ]
]
fraction = "" if price == 1 else rf"\tfrac{price.p}{price.q}"
shown = [r"1 + «fraction»|u|"]
k = 2 * price + sp.Rational(1, 2)
drift_begins = -k * x2 * sp.Abs(x2)
drift_ends = -x2 * sp.Abs(x2) / 2
law = -(sp.sign(x1 - drift_begins) + sp.sign(x1 - drift_ends)) / 2
m, side = 1 + 2 * price, sp.sign(a + k * b * sp.Abs(b))
driven = (1 + price) * side * b + 2 * sp.sqrt(m * (side * a + b**2 / 2))
drifting = (a + k * b * sp.Abs(b)) * (a + b * sp.Abs(b) / 2) < 0
cost = sp.Piecewise(
    (sp.Abs(a / b) + (price + sp.Rational(1, 2)) * sp.Abs(b), drifting), (driven, True)
)
v = sp.sqrt(d / m)
control = [[-1, v], [0, m * v], [1, (m + 1) * v]]
duration = (m + 1) * v
costate = [-1 / v, t / v - (1 + price)]
