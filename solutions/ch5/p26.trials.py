# %% wrong
bound_left = -2 * x2 * sp.Abs(x2)  # Is this the curve for the price of fuel? (hint 1)
bound_left = 43 * x2**2 / 6  # Is it the same parabola for both signs of the velocity? (hint 3)
# Was the control on the middle arc taken as zero all the time? (hint 3)
bound_left = -9 * x2 * sp.Abs(x2) / 2
# Was the distance covered on the last arc left out? (hint 3)
bound_left = -20 * x2 * sp.Abs(x2) / 3
# Do these branches lead to the origin, or away from it? (hint 1)
bound_reached = x2 * sp.Abs(x2) / 2
bound_reached = -43 * x2 * sp.Abs(x2) / 6  # Which of the two curves is met first? (hint 1)
bound_reached = -x2 * sp.Abs(x2)  # Was a factor of the parabola lost? (hint 1)
law = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)  # Does the energy cost nothing here? (hint 1)
# Is it worthwhile to switch off the drive between the curves?
law = -(sp.sign(x1 + 43 * x2 * sp.Abs(x2) / 6) + sp.sign(x1 + x2 * sp.Abs(x2) / 2)) / 2
# Does the equation hold for both signs of the velocity? (hint 3)
law = sp.Eq(
    sp.Piecewise(
        (u + 1, x1 > 43 * x2**2 / 6),
        (u - 1, x1 < x2**2 / 2),
        (
            x1 * (2 - u**2) ** 2 - x2**2 * (sp.Rational(23, 6) - 4 * u + sp.Rational(2, 3) * u**3),
            True,
        ),
    ),
    0,
)
# Is the second costate at the end what it would be without a bound?
middle = (
    x1 * (2 - u**2) ** 2
    + 8 * sp.sqrt(2) * x2 * sp.Abs(x2) / 3
    + x2**2 * (4 * u - sp.Rational(2, 3) * u**3)
)
law = sp.Eq(
    sp.Piecewise(
        (u + 1, sp.And(x1 + 43 * x2 * sp.Abs(x2) / 6 > 0, x1 + x2 * sp.Abs(x2) / 2 > 0)),
        (u - 1, sp.And(x1 + 43 * x2 * sp.Abs(x2) / 6 < 0, x1 + x2 * sp.Abs(x2) / 2 < 0)),
        (middle, True),
    ),
    0,
)
# Is the control linear in the position, or in time? (hint 2)
even = u * sp.Rational(20, 3) * x2 * sp.Abs(x2) - 2 * x1 - sp.Rational(23, 3) * x2 * sp.Abs(x2)
law = sp.Eq(
    sp.Piecewise(
        (u + 1, sp.And(x1 + 43 * x2 * sp.Abs(x2) / 6 > 0, x1 + x2 * sp.Abs(x2) / 2 > 0)),
        (u - 1, sp.And(x1 + 43 * x2 * sp.Abs(x2) / 6 < 0, x1 + x2 * sp.Abs(x2) / 2 < 0)),
        (even, True),
    ),
    0,
)
cost = 6 * sp.sqrt(3 * d / 23)  # Is this the time alone? (hint 1)
cost = sp.sqrt(10 * d)  # Is this the price of fuel? (hint 1)
cost = 28 * sp.sqrt(3 * d / 23) / 3  # Is the price half of the energy? (hint 1)
# Does the energy cost nothing here? (hint 1)
control = sp.Piecewise((-1, t < sp.sqrt(d)), (1, True))
# Is the control linear in time from the initial time to the final one? (hint 1)
control = t / (3 * sp.sqrt(3 * d / 23)) - 1
# Are the outer arcs as long as the middle one? (hint 1)
control = sp.Piecewise(
    (-1, t < sp.sqrt(6 * d / 13)),
    (2 * t / sp.sqrt(6 * d / 13) - 3, t < 2 * sp.sqrt(6 * d / 13)),
    (1, True),
)
duration = 2 * sp.sqrt(d)  # Is this the fastest transfer? (hint 1)
duration = 7 * sp.sqrt(2 * d / 5) / 2  # Is this the transfer for the price of fuel? (hint 1)
duration = sp.sqrt(23 * d / 3)  # Is this the cost of the transfer? (hint 1)
# Was the sign of the cost reversed? (hint 1)
costate = [sp.sqrt(23 / (12 * d)), sp.Rational(3, 2) - t * sp.sqrt(23 / (12 * d))]
# Does the control leave its bound at once? (hint 1)
costate = [-sp.sqrt(23 / (12 * d)), t * sp.sqrt(23 / (12 * d)) - 1]
# Which sign does the first costate have in the equation for the second one? (hint 1)
costate = [sp.sqrt(23 / (12 * d)), t * sp.sqrt(23 / (12 * d)) - sp.Rational(3, 2)]

# %% right
bound_left = sp.Piecewise((43 * x2**2 / 6, x2 < 0), (-43 * x2**2 / 6, True))  # cases
bound_left = -7.17 * sp.sign(x2) * x2**2  # decimals
bound_reached = -sp.sign(x2) * x2**2 / 2  # with the sign
# as a quotient, with the sign of the velocity
quotient = (sp.Rational(23, 6) + 4 * u * sp.sign(x2) - sp.Rational(2, 3) * u**3 * sp.sign(x2)) / (
    2 - u**2
) ** 2
p = -sp.sign(x2) * x1 / x2**2
law = sp.Eq(
    u,
    sp.Piecewise(
        (-sp.sign(x1), p > sp.Rational(43, 6)),
        (u + p - quotient, p > sp.Rational(1, 2)),
        (-sp.sign(x2), True),
    ),
)
cost = sp.sqrt(69 * d) / 3  # one root
cost = 2.769 * sp.sqrt(d)  # decimals
# cut off
control = sp.Max(-1, sp.Min(1, t * sp.sqrt(23 / (12 * d)) - sp.Rational(3, 2)))
duration = sp.sqrt(108 * d / 23)  # one root
# a column
costate = sp.Matrix([-sp.sqrt(69 * d) / (6 * d), (t * sp.sqrt(69 * d) - 9 * d) / (6 * d)])
