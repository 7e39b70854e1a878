# %% wrong
drift_begins = -x2 * sp.Abs(x2) / 2  # Does the drive stay on until the body has to brake? (hint 1)
drift_begins = -3 * x2 * sp.Abs(x2) / 2  # Was the path of the braking left out? (hint 3)
drift_begins = 2 * x2**2  # Is it the same parabola for both signs of the velocity? (hint 3)
# By how much does the second costate fall while the body drifts? (hint 2)
drift_begins = -5 * x2 * sp.Abs(x2) / 4
drift_ends = x2 * sp.Abs(x2) / 2  # Do these branches lead to the origin, or away from it? (hint 1)
drift_ends = -2 * x2 * sp.Abs(x2)  # Which of the two changes comes last? (hint 1)
drift_ends = -(x2**2) / 2  # Is it the same parabola for both signs of the velocity? (hint 1)
law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Is the fuel free of charge here? (hint 1)
law = -sp.sign(x1 + 2 * x2 * sp.Abs(x2))  # What lies between the two curves? (hint 1)
# Do the two sides of the curves have the right signs?
law = (sp.sign(x1 + 2 * x2 * sp.Abs(x2)) + sp.sign(x1 + x2 * sp.Abs(x2) / 2)) / 2
# Does the body brake too late here?
law = -(sp.sign(x1 + 2 * x2 * sp.Abs(x2)) + sp.sign(x1 + x2 * sp.Abs(x2) / 4)) / 2
# Do the curves look the same for both signs of the velocity? (hint 1)
law = sp.Piecewise((-1, x1 > 2 * x2**2), (0, x1 > x2**2 / 2), (1, True))
# Does this hold for all three kinds of starts? (hint 2)
cost = sp.Rational(7, 4) * b + sp.sqrt(10 * a + 5 * b**2)
# Is this the time alone?
cost = sp.Piecewise(
    (b + sp.Rational(7, 2) * sp.sqrt(2 * (a + b**2 / 2) / 5), a > -b * sp.Abs(b) / 2), (0, True)
)
cost = 2 * sp.sqrt(sp.Abs(a))  # Is this the least time from rest?
control = [[-1, sp.sqrt(d)], [1, 2 * sp.sqrt(d)]]  # Is the fuel free of charge here? (hint 1)
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
duration = sp.sqrt(10 * d)  # Is this what the transfer costs? (hint 1)
# Was the cost given the other sign? (hint 1)
costate = [sp.sqrt(5 / (2 * d)), sp.Rational(7, 4) - t * sp.sqrt(5 / (2 * d))]
# What is the second costate where the control changes? (hint 1)
costate = [-sp.sqrt(5 / (2 * d)), t * sp.sqrt(5 / (2 * d)) - 1]
# Do these costates belong to the fastest transfer? (hint 1)
costate = [-1 / sp.sqrt(d), t / sp.sqrt(d) - 1]

# %% right
drift_begins = sp.Piecewise((2 * x2**2, x2 < 0), (-2 * x2**2, True))  # cases
drift_begins = -2 * sp.sign(x2) * x2**2  # with the sign
drift_ends = sp.Piecewise((x2**2 / 2, x2 < 0), (-(x2**2) / 2, True))  # cases
# half the sum of two signs
law = -(sp.sign(x1 + 2 * x2 * sp.Abs(x2)) + sp.sign(x1 + x2 * sp.Abs(x2) / 2)) / 2
# solved for the velocity
fast, slow = sp.sqrt(2 * sp.Abs(x1)), sp.sqrt(sp.Abs(x1) / 2)
v = sp.sign(x1) * x2
law = sp.sign(x1) * sp.Piecewise((1, v < -fast), (0, v < -slow), (-1, True))
# by the side and one formula
e = sp.sign(a + 2 * b * sp.Abs(b))
cost = sp.Piecewise(
    (sp.Abs(a / b) + 5 * sp.Abs(b) / 4, (a + 2 * b * sp.Abs(b)) * (a + b * sp.Abs(b) / 2) < 0),
    (7 * e * b / 4 + sp.sqrt(10 * e * a + 5 * b**2), True),
)
# cases
control = sp.Piecewise((-1, t < sp.sqrt(2 * d / 5)), (0, t < sp.sqrt(5 * d / 2)), (1, True))
duration = sp.sqrt(sp.Rational(49, 10) * d)  # one root
duration = 2.2136 * sp.sqrt(d)  # decimals
# with the root above
costate = [
    -sp.sqrt(10 * d) / (2 * d),
    (2 * t * sp.sqrt(10 * d) - 7 * d) / (4 * d),
]
