# %% wrong
a_gain = [3, 3]  # Which sign does a law $u = Kx$ that stabilises a saddle have? (hint 1)
a_gain = [1, -1]  # Is $S$ positive definite with this root of the first equation? (hint 2)
a_gain = [-2, -2]  # Does this law depend on the weight of the state? (hint 1)
# This is the guarantee for all regulators. Is the loop stable at $m = 0.4$? (hint 2)
a_factors = [sp.Rational(1, 2), sp.oo]
a_factors = [0, sp.oo]  # What does the saddle do without control? (hint 1)
a_factors = [1, sp.oo]  # May the control be weaker than the optimal one? (hint 1)
a_factors = [sp.Rational(1, 3), 3]  # Which coefficient becomes negative for large $m$? (hint 1)
b_gain = [0, 0]  # Does this law bring every state to zero? (hint 1)
b_gain = [-3, -3]  # Has the cost of item a been used? (hint 2)
b_gain = [-2, 2]  # Is the sum of the two roots of the closed loop negative? (hint 2)
b_factors = [0, sp.oo]  # Compute the last coefficient of the polynomial for a small $m$. (hint 1)
b_factors = [sp.Rational(1, 3), sp.oo]  # Is this the loop of item a? (hint 1)
b_factors = [1, sp.oo]  # What are the roots for $m = 0.9$? (hint 1)
b_phase = 2 * sp.pi / 3  # Is this the angle to the direction of $+1$? (hint 2)
b_phase = 60  # In radians, please. (hint 2)
b_phase = sp.pi / 2  # Where does the curve cross the unit circle? (hint 1)
b_delay = sp.pi / 3  # This is an angle. How long does the oscillation take for it? (hint 1)
b_delay = sp.pi / sp.sqrt(3)  # The angle to $-1$ is smaller than half a turn. (hint 1)
b_delay = (
    2 * sp.pi / (3 * sp.sqrt(3))
)  # A delay turns the curve clockwise. Towards $-1$ or away? (hint 1)

# %% right
a_gain = sp.Matrix(
    [
        [
            -growth - sp.sqrt(growth**2 + weight),
            -sp.sqrt(-weight / (growth - sp.sqrt(growth**2 + weight)) * 2 + weight),
        ]
    ]
)  # a row, by the other root
# by the other root
a_factors = [growth * (sp.sqrt(growth**2 + weight) - growth) / sp.Integer(weight), sp.oo]
b_gain = sp.Matrix([[-2 * growth, -sp.sqrt(4 * growth)]])  # a row
b_factors = [0.5, sp.oo]  # decimals
b_phase = sp.acos(sp.Rational(1, 2))  # by the real part
b_phase = sp.atan(sp.sqrt(3))  # by both parts
b_delay = sp.acos(sp.Rational(1, 2)) / sp.sqrt(3 * growth)  # angle by frequency

# %% numbers
growth, weight = [
    *[(1, 3), (2, 21), (3, 7), (4, 20), (5, 24), (6, 13), (7, 32)],
    *[(8, 17), (9, 40), (10, 21), (11, 48), (12, 25), (13, 56), (14, 29)],
]
shown = [
    r"\dot x_1 = x_2, \qquad \dot x_2 = «growth*»x_1 + u",
    r"\int_0^\infty\big(«weight»x_1^2 + «weight»x_2^2 + u^2\big)\,dt",
]
a_gain = [
    -growth - sp.sqrt(growth**2 + weight),
    -sp.sqrt(2 * growth + 2 * sp.sqrt(growth**2 + weight) + weight),
]
a_factors = [growth / (growth + sp.sqrt(growth**2 + weight)), sp.oo]
b_gain = [-2 * growth, -2 * sp.sqrt(growth)]
b_factors = [sp.Rational(1, 2), sp.oo]
b_phase = sp.pi / 3
b_delay = sp.pi / (3 * sp.sqrt(3 * growth))
