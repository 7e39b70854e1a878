# %% wrong
# Which of the two coordinates does the control drive, the first?
a_control_split = sp.Matrix.hstack(sp.Matrix([-H_a[1], H_a[0]]), B_a)
a_control_split = sp.eye(2)  # Does the control act on both of the old coordinates?
# Can the old coordinates be found from these two?
a_control_split = sp.Matrix.hstack(B_a, B_a)
# Is this the matrix that leads to the new coordinates, or back?
a_observation_split = sp.Matrix.hstack(B_a, sp.Matrix([-H_a[1], H_a[0]]))
# Which coordinate does the measurement show, the first?
a_observation_split = sp.Matrix([[B_a[1], -B_a[0]], list(H_a)])
a_observation_split = sp.eye(2)  # Does the measurement contain only one of the old coordinates?
a_margins = sp.true  # One root is fixed. Which one?
a_margins = sp.false  # Is the growing motion the fixed one?
# Is the feedback taken with a minus sign, $u = -Ke$?
a_gains = [-a_gains[0], a_gains[1]]
# In which direction does this correction move the error?
a_gains = [a_gains[0], -a_gains[1]]
# In which combination do the two numbers enter?
K, L = a_gains
a_gains = [sp.Matrix([[K[0], -K[0] * B_a[0] / B_a[1]]]), L]
# Which of the two coordinates does the control drive, the first?
b_control_split = sp.Matrix.hstack(sp.Matrix([-H_b[1], H_b[0]]), B_b)
# Is this a row that measures, or a vector that is not shown?
b_observation_split = sp.Matrix([[-H_b[1], H_b[0]], [1, 0]])
b_margins = a_margins  # Is the fixed root that of item a?
# In which combination do the two numbers enter?
K, L = b_gains
b_gains = [sp.Matrix([[K[0], -K[0] * B_b[0] / B_b[1]]]), L]
# What is the sign of HL with these numbers?
b_gains = [b_gains[0], -b_gains[1]]
# With which sign does u enter the second equation?
c_control_split = sp.Matrix([[B_c[0], -H_c[1]], [-B_c[1], H_c[0]]])
# Mind the sign in the measurement.
c_observation_split = sp.Matrix([[H_c[0], -H_c[1]], [1, 0]])
c_margins = sp.false  # The growing motion has the root 2. Is it the fixed one?
# Here the root to be moved is 2. Is the correction enough?
root = (A_c * B_c)[0] / B_c[0]
K, L = c_gains
c_gains = [K, root / (H_c * L)[0] * L]
# With which sign does the second number enter?
K, L = c_gains
c_gains = [sp.Matrix([[0, -(K * B_c)[0] / B_c[1]]]), L]
# Which of the two coordinates does the control drive, the first?
d_control_split = sp.Matrix.hstack(-sp.Matrix([-H_d[1], H_d[0]]), B_d)
# Is this a row that measures, or a vector that is not shown?
d_observation_split = sp.Matrix([[H_d[1], -H_d[0]], [1, 0]])
# Look at the greatest degree of stability itself: which root could be slower?
slow = (A_d * B_d)[0] / B_d[0] - A_d.trace()
d_margins = mu < slow
# In which combination do the two numbers enter?
K, L = d_gains
d_gains = [sp.Matrix([[K[0], -K[0] * B_d[0] / B_d[1]]]), L]
# What is H times this column?
d_gains = [d_gains[0], sp.Matrix([H_d[1], -H_d[0]])]

# %% right
a_control_split = sp.Matrix([[B_a[0], 1], [B_a[1], 0]])  # b with any other column
a_observation_split = sp.Matrix([list(H_a), [0, 1]])  # H with any other row
# a square
slow = (A_a * B_a)[0] / B_a[0] - A_a.trace()
a_margins = mu**2 <= slow**2
# decimals, other numbers of the right sum
root = (A_a * B_a)[0] / B_a[0]
half = float(root + 2) / 2
a_gains = [[-half / B_a[0], -half / B_a[1]], [0.0, float((root + 4) / H_a[1])]]
b_control_split = sp.Matrix([[2 * B_b[0], 0], [2 * B_b[1], 1]])  # a multiple of b
b_observation_split = sp.Matrix([list(-H_b), [1, 0]])  # H with the other sign
# with what is known of mu
slow = (A_b * B_b)[0] / B_b[0] - A_b.trace()
b_margins = sp.And(mu > 0, mu <= slow)
# the other coordinate alone, a fraction
root = (A_b * B_b)[0] / B_b[0]
b_gains = [sp.Matrix([[0, -(root + 3) / B_b[1]]]), sp.Matrix([(root + 2) / H_b[0], 0])]
c_control_split = sp.Matrix([[-B_c[0], 0], [-B_c[1], 1]])  # b with the other sign
c_observation_split = sp.Matrix([list(H_c / H_c[0]), [0, 1]])  # a part of H
# moved to one side
slow = (A_c * B_c)[0] / B_c[0] - A_c.trace()
c_margins = mu - slow <= 0
# other roots
root = (A_c * B_c)[0] / B_c[0]
c_gains = [[0, -(root + 3) / B_c[1]], [(root + 4) / H_c[0], 0]]
d_control_split = sp.Matrix([[B_d[0], 5], [B_d[1], 2]])  # b with any other column
d_observation_split = sp.Matrix([list(2 * H_d), [1, 1]])  # twice H
# a negation
slow = (A_d * B_d)[0] / B_d[0] - A_d.trace()
d_margins = sp.Not(mu > slow)
# the other coordinates alone
root = (A_d * B_d)[0] / B_d[0]
d_gains = [sp.Matrix([[0, -(root + 2) / B_d[1]]]), sp.Matrix([0, (root + 2) / H_d[1]])]


# %% numbers
def plant(root, slow, control, measurement):
    """The system with a controlled and measured root, and one that is neither, at -slow."""
    B, H = sp.Matrix(control), sp.Matrix([measurement])
    return root * sp.eye(2) + (root + slow) * (B * H / (H * B)[0] - sp.eye(2)), B, H


A_a, B_a, H_a, A_b, B_b, H_b, A_c, B_c, H_c, A_d, B_d, H_d = [
    sum((plant(*parts) for parts in systems), ())
    for systems in [
        [
            (1, 1, (1, 1), (3, -5)),
            (1, 2, (1, 1), (4, -7)),
            (2, 2, (1, -1), (3, -1)),
            (1, 2, (1, -1), (4, 1)),
        ],
        [
            (2, 1, (2, 1), (2, -1)),
            (2, 3, (1, 2), (3, -4)),
            (2, 1, (1, 2), (1, -2)),
            (1, 3, (2, -1), (1, -2)),
        ],
        [
            (2, 3, (2, 1), (2, 1)),
            (2, 2, (2, 3), (1, -2)),
            (2, 1, (2, -1), (2, 1)),
            (1, 1, (1, 2), (4, -3)),
        ],
        [
            (1, 3, (2, -3), (1, 2)),
            (2, 2, (3, 2), (2, -1)),
            (2, 2, (2, 1), (3, -2)),
            (2, 1, (3, 2), (1, -3)),
        ],
        [
            (1, 2, (1, 3), (3, -2)),
            (1, 3, (1, 2), (2, 1)),
            (2, 3, (3, 2), (3, -2)),
            (2, 1, (1, 3), (3, -2)),
        ],
        [
            (2, 1, (3, -1), (2, 3)),
            (1, 3, (3, 2), (2, -1)),
            (2, 3, (2, -1), (2, -1)),
            (2, 3, (3, 1), (2, -1)),
        ],
        [
            (2, 2, (1, 2), (2, -3)),
            (1, 1, (2, -1), (3, 4)),
            (2, 1, (2, -3), (3, 1)),
            (1, 2, (1, 3), (3, -2)),
        ],
        [
            (1, 2, (1, -2), (3, 2)),
            (2, 3, (2, 1), (1, -1)),
            (3, 1, (1, -3), (2, 1)),
            (2, 3, (2, 3), (1, -1)),
        ],
        [
            (2, 2, (2, -1), (1, 3)),
            (1, 3, (2, -1), (1, -2)),
            (1, 3, (1, 2), (1, -1)),
            (1, 3, (1, -2), (2, 3)),
        ],
        [
            (1, 1, (2, -3), (2, 1)),
            (2, 2, (3, 2), (1, -1)),
            (1, 4, (1, -3), (1, 2)),
            (1, 3, (1, 2), (3, -1)),
        ],
        [
            (2, 3, (1, -3), (1, 2)),
            (2, 4, (1, 2), (1, -2)),
            (1, 2, (3, 2), (1, -1)),
            (1, 4, (1, -2), (3, -1)),
        ],
        [
            (1, 2, (3, 2), (1, -3)),
            (2, 1, (1, -2), (1, 2)),
            (2, 2, (3, 2), (2, -1)),
            (2, 2, (1, 2), (2, -3)),
        ],
        [
            (2, 2, (2, 1), (3, -2)),
            (2, 1, (1, -3), (3, 2)),
            (2, 2, (2, -1), (3, 2)),
            (2, 1, (3, -1), (2, 3)),
        ],
        [
            (2, 4, (2, 1), (1, -4)),
            (2, 2, (1, -3), (1, -1)),
            (1, 3, (3, -1), (1, 2)),
            (1, 2, (3, 2), (1, -2)),
        ],
        [
            (2, 4, (3, 2), (4, -3)),
            (1, 2, (2, 1), (2, -1)),
            (1, 3, (1, -2), (2, -1)),
            (1, 1, (2, 1), (2, -3)),
        ],
    ]
]


def answers(A, B, H):
    """Both splits, the degrees of stability and gains [K, L] with the roots -1 and less."""
    root = (A * B)[0] / B[0]
    control_split = sp.Matrix.hstack(B, sp.Matrix([0, 1]))
    K = sp.Matrix([[-(root + 1) / B[0], 0]])
    L = sp.Matrix([(root + 2) / H[0], 0])
    return control_split, sp.Matrix([list(H), [0, 1]]), mu <= root - A.trace(), [K, L]


a_control_split, a_observation_split, a_margins, a_gains = answers(A_a, B_a, H_a)
b_control_split, b_observation_split, b_margins, b_gains = answers(A_b, B_b, H_b)
c_control_split, c_observation_split, c_margins, c_gains = answers(A_c, B_c, H_c)
d_control_split, d_observation_split, d_margins, d_gains = answers(A_d, B_d, H_d)
shown = [
    rf"{item}) $\quad\dot x_1 = «A_{item}[0, 0]*»x_1 «+A_{item}[0, 1]*»x_2 «+B_{item}[0]*»u,$ "
    rf"$\quad \dot x_2 = «A_{item}[1, 0]*»x_1 «+A_{item}[1, 1]*»x_2 «+B_{item}[1]*»u,$ "
    rf"$\quad z = «H_{item}[0]*»x_1 «+H_{item}[1]*»x_2"
    for item in "abcd"
] + ["The root to be moved is «(A_c * B_c)[0] / B_c[0]» here."]
