# %% wrong
a_control = sp.Matrix([[-b2, -b1]])  # Have the plant's own coefficients been cancelled?
a_control = -a_control  # Is the feedback taken with a minus sign, $u = -Kx$?
# Which of the two numbers is multiplied by x, and which by its rate?
a_control = sp.Matrix([[a_control[1], a_control[0]]])
# The product of the roots contains both numbers. Is the second one complete?
a_correction = sp.Matrix([a_correction[0], g2 + acceleration_a[0]])
# Are these the numbers for a plant with zero coefficients?
a_correction = sp.Matrix([g1, g2])
# Does the correction enter the equation of the errors as + LH?
a_correction = -a_correction
# Is there a motion that the measurement does not show? What becomes of an error along it?
b_margins = sp.true
b_margins = sp.false  # Something is hidden. Does it grow or decay?
# Look at the end of your interval: can the slowest root be as fast as that?
b_margins = mu < weight_b
# Which of the two roots is the fixed one?
b_margins = mu <= acceleration_a[1] + weight_b
# Put it into $A - LH$: where is the second root for $\gamma = 1$?
b_correction = sp.Matrix([g, 0])
# Is this the gain of a measurement of x alone?
b_correction = a_correction.subs({g1: g + weight_b, g2: g * weight_b})
# In which combination do the two numbers enter the polynomial?
b_correction = sp.Matrix([1, 1]) * (g + acceleration_a[1] + weight_b)
c_margins = mu <= 1  # The exponential that is not shown: is it a motion of this plant?
# A zero of the measurement is not a hidden motion. Compare it with the roots of the equation.
c_margins = sp.false
# What is the sign of the plant's own friction?
c_control = sp.Matrix([[c_control[0], acceleration_c[1] - b1]])
# What is the sign of the plant's own stiffness?
c_control = sp.Matrix([[acceleration_c[0] - b2, c_control[1]]])
# These are the sum and the difference; what are the two numbers?
c_correction = 2 * c_correction
# Are these the numbers themselves, or their difference and their sum?
c_correction = sp.Matrix([g1 + acceleration_c[1], g2 + acceleration_c[0]])
# Does the plant move like the exponential that the measurement does not show?
d_margins = sp.false
d_margins = mu <= weight_d  # Is a zero of the measurement a root that no gain can move?
# What is the sign of the plant's own friction?
d_control = sp.Matrix([[d_control[0], acceleration_d[1] - b1]])
d_control = -d_control  # Is the feedback taken with a minus sign, $u = -Kx$?
# Were the factors of $l_1$ and $l_2$ taken into account?
d_correction = weight_d**2 * d_correction
# The sum of the roots contains both numbers. Is the first one complete?
d_correction = sp.Matrix([g1 / weight_d, d_correction[1]])

# %% right
a_control = list(a_control)  # a flat list
a_correction = a_correction.T  # lying down
b_margins = sp.And(mu > 0, mu <= weight_b)  # with what is known of mu
b_margins = mu**2 <= weight_b**2  # a square
# the whole correction on the second equation
b_correction = sp.Matrix([0, g + acceleration_a[1] + weight_b])
# another splitting of the sum
b_correction = sp.Matrix([g / weight_b, acceleration_a[1] + weight_b])
# in two halves
b_correction = sp.Matrix([1 / sp.Integer(weight_b), 1]) * (g + acceleration_a[1] + weight_b) / 2
c_margins = mu > 0  # what is known of mu
c_control = c_control.tolist()  # nested lists
c_correction = [sp.N(gain) for gain in c_correction]  # decimals
d_margins = mu < sp.oo  # no bound
d_control = d_control.T  # upright
d_correction = list(d_correction.expand())  # each by itself

# %% numbers
weight_b, acceleration_a, acceleration_c, acceleration_d, weight_d = [
    (slow, [slow * fast, fast - slow], [k, -1 - k], [weight * friction, -friction], weight)
    for fast, slow, k, weight, friction in [
        *[(2, 1, 1, 2, 1), (1, 2, 2, 2, 2), (3, 2, 3, 3, 1), (1, 3, 4, 2, 3), (2, 3, 5, 3, 2)],
        *[(1, 4, 9, 5, 1), (4, 2, 8, 3, 6), (7, 2, 7, 3, 3), (4, 1, 13, 3, 7), (4, 5, 11, 4, 5)],
        *[
            (2, 4, 6, 3, 5),
            (8, 1, 12, 4, 2),
            (6, 2, 10, 5, 2),
            (8, 3, 14, 2, 7),
        ],
    ]
]
shown = [
    rf"\ddot x «+-acceleration_{item}[1]*»\dot x «+-acceleration_{item}[0]*»x = u" for item in "acd"
] + [
    r"z = «weight_b*»x + \dot x",
    r"z = «weight_d*»x - \dot x",
    r"(\lambda + «weight_b»)(\lambda + \gamma)",
]
(a0, a1), (c0, c1), (d0, d1) = acceleration_a, acceleration_c, acceleration_d
a_control, c_control, d_control = [
    sp.Matrix([[-first - b2, -second - b1]]) for first, second in [(a0, a1), (c0, c1), (d0, d1)]
]
a_correction = sp.Matrix([g1 + a1, g2 + a0 + a1 * (g1 + a1)]).expand()
b_margins = mu <= weight_b
b_correction = sp.Matrix([(g + a1 + weight_b) / weight_b, 0])
c_correction = sp.Matrix([g1 + g2 + c0 + c1, g2 - g1 + c0 - c1]) / 2
d_correction = sp.Matrix([weight_d * g1 + g2, weight_d * (g2 + d0)]) / weight_d**2
