# %% wrong
# Does the upper link move with the end of the lower one? These are two separate pendulums. (hint 1)
equations = [sp.diag(l1, l2), -g * sp.eye(2), sp.Matrix([-1, -1])]
# From which direction is the second angle measured? (hint 1)
relative = sp.Matrix([[(m1 + m2) * l1 + m2 * l2, m2 * l2], [l1 + l2, l2]])
equations = [relative, sp.diag(-(m1 + m2) * g, -g), sp.Matrix([-(m1 + m2), -1])]
# Do the links hang down or stand? (hint 1)
equations = [
    sp.Matrix([[(m1 + m2) * l1, m2 * l2], [l1, l2]]),
    sp.diag((m1 + m2) * g, g),
    sp.Matrix([-(m1 + m2), -1]),
]
# In which direction does the force of inertia act? (hint 1)
equations = [
    sp.Matrix([[(m1 + m2) * l1, m2 * l2], [l1, l2]]),
    sp.diag(-(m1 + m2) * g, -g),
    sp.Matrix([m1 + m2, 1]),
]
# Was the control left out of one of the equations? (hint 1)
equations = [
    sp.Matrix([[(m1 + m2) * l1, m2 * l2], [l1, l2]]),
    sp.diag(-(m1 + m2) * g, -g),
    sp.Matrix([-(m1 + m2), 0]),
]
# Are these the roots of two separate pendulums? (hint 1)
roots = [sp.sqrt(g / l1), -sp.sqrt(g / l1), sp.sqrt(g / l2), -sp.sqrt(g / l2)]
roots = [value**2 for value in roots]  # Are these the squares of the roots? (hint 1)
roots = [sp.I * value for value in roots]  # Do the links hang down or stand?
# Is the system uncontrollable because one of the solved equations does not contain the control?
# (hint 2)
controllable = False
side_by_side = sp.true  # Are two separate pendulums always controllable too? (hint 1)
side_by_side = sp.Eq(l1, l2)  # Is this the exceptional case instead of all others? (hint 1)

# %% right
equations = [double_pendulum.M, double_pendulum.K, double_pendulum.L]  # not divided by anything
# solved for the accelerations
solved = sp.Matrix(
    [
        [-(m1 + m2) * g / (m1 * l1), m2 * g / (m1 * l1)],
        [(m1 + m2) * g / (m1 * l2), -(m1 + m2) * g / (m1 * l2)],
    ]
)
equations = [sp.eye(2), solved, sp.Matrix([-1 / l1, 0])]
# the squares multiplied out
roots = [sign * sp.sqrt(sp.expand(value**2)) for value, sign in zip(roots, (1, -1, 1, -1))]
side_by_side = sp.Or(l1 < l2, l1 > l2)  # either is longer
