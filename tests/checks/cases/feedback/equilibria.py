import sympy as sp
from case import Case

y1, y2, u = sp.symbols("y1 y2 u", real=True)
M, pi = sp.Matrix, sp.pi
TURN = {y1: sp.Interval.Lopen(-pi, pi)}
# A pendulum with a push: hanging at 0, standing at pi.
PENDULUM = ([y2, -sp.sin(y1) + u], [y1, y2], [u], TURN)
HANGING, STANDING = [(0, 0), [0, -1]], [(pi, 0), [-3, -2]]
# y1 is uncontrollable, with an eigenvalue 0, and comes back by its cube, or drifts away by its
# square.
CUBE = ([-(y1**3), y2 + u], [y1, y2], [u], None, [y1, y2])
SQUARE = ([y1**2, y2 + u], [y1, y2], [u], None, [y1, y2])
# y1 grows, uncontrollable, or decays.
GROWS, DECAYS = ([y1, y2 + u], [y1, y2], [u]), ([-y1, y2 + u], [y1, y2], [u])
ZERO = (0, 0)

CASES = [
    Case("equilibrium_gains", [HANGING, STANDING], PENDULUM, "right", "a pair for each point"),
    Case(
        "equilibrium_gains",
        [[(pi, 0.0), M([[-3.5, -2]])], [M([0, 0]), (1 / sp.Integer(2), -1)]],
        PENDULUM,
        "right",
        "another order, matrices and decimals",
    ),
    Case(
        "equilibrium_gains",
        [[(-pi, 0), [-3.5, -2]], HANGING],
        PENDULUM,
        "wrong",
        "an angle on the border that is left out",
    ),
    Case(
        "equilibrium_gains",
        [[ZERO, [0, -1]]],
        CUBE,
        "right",
        "critical, and the terms of third order bring it back",
    ),
    Case("equilibrium_gains", [[ZERO, []]], SQUARE, "right", "critical, and no gain keeps it"),
    Case("equilibrium_gains", [[ZERO, []]], GROWS, "right", "a growing mode uncontrollable"),
    Case("equilibrium_gains", [[ZERO, [5, -2]]], DECAYS, "right", "a decaying mode uncontrollable"),
    Case(
        "equilibrium_gains",
        [HANGING, [(pi, 0), [0, -1]]],
        PENDULUM,
        "wrong",
        "the gain of the other point",
    ),
    Case(
        "equilibrium_gains",
        [[(0, 0), [0, 1]], STANDING],
        PENDULUM,
        "wrong",
        "the sign of the friction",
    ),
    Case(
        "equilibrium_gains",
        [[(0, 0), [-1, 0]], STANDING],
        PENDULUM,
        "wrong",
        "an oscillation for ever",
    ),
    Case("equilibrium_gains", [HANGING, [(pi, 0), []]], PENDULUM, "wrong", "there is a gain"),
    Case("equilibrium_gains", [HANGING], PENDULUM, "wrong", "a point left out"),
    Case(
        "equilibrium_gains",
        [HANGING, STANDING, [(pi / 2, 0), []]],
        PENDULUM,
        "wrong",
        "no equilibrium",
    ),
    Case(
        "equilibrium_gains",
        [HANGING, STANDING, [(-pi, 0), [-3, -2]]],
        PENDULUM,
        "wrong",
        "a point twice",
    ),
    Case("equilibrium_gains", [[ZERO, []]], CUBE, "wrong", "critical, and some gain does"),
    Case(
        "equilibrium_gains",
        [[ZERO, [0, -2]]],
        SQUARE,
        "wrong",
        "critical, and the motions run away",
    ),
    Case("equilibrium_gains", [[ZERO, []]], DECAYS, "wrong", "what is uncontrollable decays"),
    Case("equilibrium_gains", [[ZERO, [0, -2]]], GROWS, "wrong", "what is uncontrollable grows"),
    Case("equilibrium_gains", [HANGING, [(pi, 0), [sp.I, -2]]], PENDULUM, "wrong", "not real"),
    Case("equilibrium_gains", [HANGING, [(pi, 0), ...]], PENDULUM, "missing", "half of it"),
    Case("equilibrium_gains", [0, -1], PENDULUM, "invalid", "one gain"),
    Case(
        "equilibrium_gains", [HANGING, [(pi, 0), [1, 2, 3]]], PENDULUM, "invalid", "three entries"
    ),
    Case(
        "equilibrium_gains",
        [HANGING, [(pi, 0), [y1, -2]]],
        PENDULUM,
        "invalid",
        "a gain that is no number",
    ),
]
LIMITS = [
    "A gain at which the loop has eigenvalues on the imaginary axis is refused, unless no gain "
    "moves them; then "
    "motions that start at the distance 0.05 decide, and for an empty list those under three gains."
]
