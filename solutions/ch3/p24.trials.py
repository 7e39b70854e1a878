# %% wrong
regulator = sp.Matrix([[-b2, -b1]])  # Has the friction of the plant been forgotten? (hint 1)
regulator = sp.Matrix([[b2, b1 - 1]])  # Is the feedback taken with a minus sign?
# Which of the two numbers belongs to the position, and which to the velocity?
regulator = sp.Matrix([[1 - b1, -b2]])
regulator = sp.Matrix([[-b2, 1 + b1]])  # Look at the sum of the roots again. (hint 1)
correction = sp.Matrix([g1, g2])  # Has the friction of the plant been forgotten?
# Does the first number not enter the product of the roots, too? (hint 1)
correction = sp.Matrix([g1 - 1, g2])
correction = sp.Matrix([1 - g1, g1 - g2 - 1])  # What is the sign of L in the observer?
# Is the control zero when there is no deviation? (hint 1)
model = [v, -v + k1 * e1 + k2 * e2, *model[2:]]
# Is the measurement compared with an estimate of the same quantity? (hint 2)
model = [*model[:2], e2 + l1 * (y - e1), -e2 + k1 * e1 + k2 * e2 + l2 * (y - e1)]
model = [*model[:3], -e2 + l2 * (y - t - e1)]  # Does the observer contain the control? (hint 2)
# Are the coordinates of the observer velocities or deviations from them?
model = [*model[:3], -e2 + 1 + k1 * e1 + k2 * e2 + l2 * (y - t - e1)]
# Is the velocity measured? The control can only use estimates. (hint 1)
model = [v, -v + 1 + k1 * (y - t) + k2 * (v - 1), *model[2:]]
model = [*model[:2], e2 - l1 * (y - t - e1), *model[3:]]  # What is the sign of the correction?
regulator_region = (k1 < 0) & (k2 < 0)  # Does the friction not help? (hint 1)
regulator_region = k1 < 0  # What is the effect of too large a gain of the velocity?
regulator_region = (k1 > 0) & (k2 > -1)  # Is the feedback taken with a minus sign?
# What becomes of a delay without a feedback of the position?
regulator_region = (k1 <= 0) & (k2 < 1)
place_margins = mu <= 1  # Is the root of the friction uncontrollable or unobservable? (hint 1)
# Must the velocity be measured? What does a record of the position show about it?
place_margins = sp.false
speed_margins = sp.true  # Which column of the matrix N is zero? (hint 1)
speed_margins = mu <= 1  # Which of the two motions is the hidden one? (hint 1)
# What is hidden if $a = b$, and what becomes of it? (hint 2)
observer_margins = sp.And(sp.Ne(a, 0), sp.Ne(a, b))
observer_margins = sp.Ne(a, 0)  # Look at $a = b$. Is every degree of stability possible? (hint 2)
# Which of the two is needed, the position or the velocity? (hint 1)
observer_margins = sp.Ne(b, 0)
# Does the velocity of the decaying motion have the sign of its position? (hint 1)
observer_margins = sp.And(sp.Ne(a, 0), sp.Or(sp.Ne(b, -a), mu <= 1))
# Does the measured velocity alone show a delay?
observer_margins = sp.Or(sp.Ne(a, b), mu <= 1)

# %% right
regulator = [-b2, -b1 + 1]  # a flat list
correction = sp.Matrix([[g1 - 1, g2 + 1 - g1]])  # lying down
# a column
model = sp.Matrix(
    [
        v,
        1 - v + k1 * e1 + k2 * e2,
        e2 + l1 * y - l1 * t - l1 * e1,
        (k2 - 1) * e2 + k1 * e1 + l2 * (y - t - e1),
    ]
)
regulator_region = sp.And(-k1 > 0, 1 - k2 > 0)  # the coefficients
place_margins = mu > 0  # what is known of mu
# the cases one by one
observer_margins = sp.Or(sp.Ne(a * (a - b), 0), sp.And(sp.Eq(a, b), sp.Ne(b, 0), mu <= 1))
observer_margins = sp.And(sp.Ne(a, 0), sp.Or(b < a, b > a, mu - 1 <= 0))  # in another form
