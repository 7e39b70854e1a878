# %% wrong
# Does the error of the instrument push the body?
a_augmented = [sp.Matrix([[0, 1, 0], [*acceleration_a, 1], [0, 0, 0]]), sp.Matrix([[weight, 1, 1]])]
# What is the rate of a constant?
a_augmented = [sp.diag(A_a, 1), sp.Matrix([[weight, 1, 1]])]
# Where does the error enter, if the measurement does not contain it?
a_augmented = [sp.diag(A_a, 0), sp.Matrix([[weight, 1, 0]])]
# Is the third coordinate here $r$ itself, or twice as much?
a_augmented = [sp.diag(A_a, 0), sp.Matrix([[weight, 1, sp.Rational(1, 2)]])]
a_margins = sp.true  # Does the measurement show every motion of the equation?
a_margins = sp.false  # There is a hidden motion. Is it the offset, and does it grow?
# Look at the end of your interval: which root could be slower?
a_margins = mu < weight
# Compute the roots of the errors: what is the effect of the sign of $l_3$?
a_gains = [a_gains[0], sp.diag(1, 1, -1) * a_gains[1]]
# Can an estimate that is never corrected converge?
a_gains = [a_gains[0], sp.diag(1, 1, 0) * a_gains[1]]
a_gains = [-a_gains[0], a_gains[1]]  # Is the feedback taken with a minus sign, $u = -Ke$?
# How large is the stiffness with this control?
a_gains = [a_gains[0] + sp.Matrix([[1, 0]]), a_gains[1]]
# It is stable; is it fast enough?
growing = acceleration_a[1] + weight
last = -sp.Rational(1, 2 * growing)
a_gains = [a_gains[0], sp.Matrix([(growing + sp.Rational(1, 2) - last) / weight, 0, last])]
# Does the error of the instrument push the body?
b_augmented = [sp.Matrix([[0, 1, 0], [*acceleration_b, 1], [0, 0, 0]]), sp.Matrix([[weight, 1, 1]])]
# Which coefficient is that of x?
b_augmented = [sp.diag(sp.Matrix([[0, 1], acceleration_b[::-1]]), 0), sp.Matrix([[weight, 1, 1]])]
# Which of the two roots of the equation belongs to the unobservable motion?
b_margins = mu <= acceleration_b[1] + weight
b_margins = sp.false  # Is the hidden motion the growing one?
# What is the sign of the product of the roots of the errors?
b_gains = [b_gains[0], sp.diag(1, 1, -1) * b_gains[1]]
# Is this the control of item a? Look at the friction here.
b_gains = [a_gains[0], b_gains[1]]
b_gains = [-b_gains[0], b_gains[1]]  # Is the feedback taken with a minus sign, $u = -Ke$?

# %% right
a_margins = sp.And(mu > 0, mu <= weight)  # with what is known of mu
# another control, and another splitting of the sum
a_gains = [
    [-acceleration_a[0] - 4, -acceleration_a[1] - 4],
    [0, weight * a_gains[1][0], a_gains[1][2]],
]
# decimals, the sum in halves
first, second, last = a_gains[1]
a_gains = [a_gains[0].evalf(), sp.Matrix([first / 2, weight * first / 2, last]).evalf()]
b_augmented = [sp.diag(A_b, 0).tolist(), [weight, 1, 1]]  # nested lists, the row flat
b_margins = mu**3 <= weight**3  # a cube
# upright and lying down
b_gains = [
    sp.Matrix([-acceleration_b[0] - 4, -acceleration_b[1] - 4]),
    sp.Matrix([[0, weight * b_gains[1][0], b_gains[1][2]]]),
]
# a faster observer
growing = acceleration_b[1] + weight
last = -sp.Rational(25, growing)
b_gains = [list(b_gains[0]), [(growing + 6 - last) / weight, 0, last]]

# %% numbers
from workbook.authoring.numbers import linear_form

weight, acceleration_a, acceleration_b = [
    (slow, [slow * growing_a, growing_a - slow], [slow * growing_b, growing_b - slow])
    for slow, growing_a, growing_b in [
        *[(1, 1, 2), (2, 1, 3), (3, 2, 4), (4, 1, 3), (6, 1, 3), (8, 1, 2), (7, 1, 2), (10, 2, 3)],
        *[
            (11, 1, 3),
            (9, 2, 3),
            (5, 2, 4),
            (13, 1, 2),
            (14, 1, 2),
            (12, 1, 2),
            (15, 1, 4),
        ],
    ]
]
terms = [r"\ddot\alpha", r"\dot\alpha", r"\alpha"]
shown = [
    f"«linear_form([1, -acceleration_{item}[1], -acceleration_{item}[0]], terms)» = u"
    for item in "ab"
] + [r"«weight*»\alpha + \dot\alpha", r"$\dot s = «acceleration_b[1] + weight*»s + u$"]


def answers(A):
    """The augmented system, the degrees of stability, and gains with the roots -1, -1; -2, -2 of all that moves."""
    growing = A[1, 1] + weight
    last = -sp.Rational(4, growing)
    gains = [
        sp.Matrix([[-A[1, 0] - 1, -A[1, 1] - 2]]),
        sp.Matrix([(growing + 4 - last) / weight, 0, last]),
    ]
    return [sp.diag(A, 0), sp.Matrix([[weight, 1, 1]])], mu <= weight, gains


a_augmented, a_margins, a_gains = answers(A_a)
b_augmented, b_margins, b_gains = answers(A_b)
