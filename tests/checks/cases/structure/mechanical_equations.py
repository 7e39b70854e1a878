import sympy as sp
from case import Case

from workbook.systems import Mechanical

r, g, m, M = sp.symbols("r g m M", positive=True)
# An inverted pendulum on a cart that is moved: r phi'' - g phi = -u.
ONE = (Mechanical([[m * r**2]], 0, [[-m * g * r]], L=[-m * r]), [r, g, m])
# Two links of length r, with the masses M and m.
LINKS = Mechanical(
    [[(M + m) * r**2, m * r**2], [m * r**2, m * r**2]],
    0,
    sp.diag(-(M + m) * g * r, -m * g * r),
    L=[-(M + m) * r, -m * r],
)
TWO = (LINKS, [r, g, m, M])
SOLVED = [
    sp.eye(2),
    sp.Matrix([[-(M + m) * g, m * g], [(M + m) * g, -(M + m) * g]]) / (M * r),
    sp.Matrix([-1 / r, 0]),
]
NUMBERS = (Mechanical([[1]], 0, [[3]], L=[1]),)

CASES = [
    Case("mechanical_equations", [[[r]], [[-g]], [-1]], ONE, "right", "divided by m r"),
    Case("mechanical_equations", [[[r]], [[-1.004 * g]], [-1]], ONE, "right", "three digits"),
    Case("mechanical_equations", [[[r]], [[-0.996 * g]], [-1]], ONE, "wrong", "two digits"),
    Case(
        "mechanical_equations",
        [ONE[0].M, ONE[0].K, ONE[0].L],
        ONE,
        "right",
        "as the energies give them",
    ),
    Case(
        "mechanical_equations",
        [sp.eye(1), sp.Matrix([[-g / r]]), sp.Matrix([-1 / r])],
        ONE,
        "right",
        "solved",
    ),
    Case("mechanical_equations", SOLVED, TWO, "right", "solved for the accelerations"),
    Case(
        "mechanical_equations",
        (LINKS.M[::-1, :], LINKS.K[::-1, :], LINKS.L[::-1, :]),
        TWO,
        "right",
        "the equations in another order",
    ),
    Case("mechanical_equations", [sp.eye(1), [[3.0]], [1.0]], NUMBERS, "right", "floats"),
    Case("mechanical_equations", [sp.eye(1), [[3.004]], [1]], NUMBERS, "right", "three digits"),
    Case(
        "mechanical_equations", [sp.eye(1), [[3.02]], [1]], NUMBERS, "wrong", "the third digit off"
    ),
    Case(
        "mechanical_equations",
        [[[r * (r - g)]], [[g * (g - r)]], [g - r]],
        ONE,
        "wrong",
        "nothing is said at r = g",
    ),
    Case("mechanical_equations", [[[r]], [[g]], [-1]], ONE, "wrong", "hanging down"),
    Case("mechanical_equations", [[[r]], [[-g]], [1]], ONE, "wrong", "the sign of the control"),
    Case(
        "mechanical_equations", [[[r]], [[-g]], [-m]], ONE, "wrong", "a force for an acceleration"
    ),
    Case(
        "mechanical_equations",
        [LINKS.M, LINKS.K, [-(M + m) * r, 0]],
        TWO,
        "wrong",
        "one link not dragged",
    ),
    Case("mechanical_equations", [sp.ones(2), LINKS.K, LINKS.L], TWO, "wrong", "no inverse"),
    Case("mechanical_equations", [..., [[-g]], [-1]], ONE, "missing", "a matrix left open"),
    Case("mechanical_equations", [[[r]], [[-g]]], ONE, "invalid", "the control forgotten"),
    Case("mechanical_equations", sp.eye(1), ONE, "invalid", "one matrix"),
]
LIMITS = ["Damping is not asked: the systems are those that the energies give."]
