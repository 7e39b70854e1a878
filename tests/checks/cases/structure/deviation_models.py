import sympy as sp
from case import Case

from workbook.systems import Deviations, Linear

x, v, t = sp.symbols("x v t", real=True)
M = sp.Matrix
# A stone in a stream that resists with the square of its speed, moving on evenly: v = 1.
STONE = Deviations([v, 1 - v**2], [x, v], {x: t, v: 1})
SLOWED = M([[0, 1], [0, -2]])  # the same deviations
OTHER = M([[-2, 0], [1, 0]])  # in the variables (v, x)
WALL = M([[-3, 1], [-2, 0]])  # eigenvalues -1 and -2, no place at rest
QUANTITIES = {"place": x, "speed": v}
MEASURED = (Linear(OTHER, H=M([[0, 1]])), STONE, QUANTITIES)
# A pendulum that never comes to rest in these coordinates: the deviations change with time.
TURNING = Deviations([v, -sp.sin(x)], [x, v], {x: t, v: 1})

CASES = [
    Case(
        "similarity_matrix", M([[0, 1], [1, 0]]), (Linear(OTHER), STONE), "right", "another order"
    ),
    Case(
        "similarity_matrix",
        [[3, 2], [-4, 0]],
        (Linear(OTHER), STONE),
        "right",
        "the place at another moment, another unit",
    ),
    Case("similarity_matrix", sp.eye(2), (Linear(SLOWED), STONE), "right", "nothing to change"),
    Case(
        "similarity_matrix", sp.eye(2), (Linear(OTHER), STONE), "wrong", "the variables as they are"
    ),
    Case(
        "similarity_matrix",
        M([[0, 1], [1, 0]]),
        (Linear(WALL), STONE),
        "wrong",
        "a system that is no model of it",
    ),
    Case("similarity_matrix", sp.zeros(2), (Linear(OTHER), STONE), "wrong", "no inverse"),
    Case("similarity_matrix", ..., (Linear(OTHER), STONE), "missing", "the untouched stub"),
    Case("similarity_matrix", [[0, 1]], (Linear(OTHER), STONE), "invalid", "a row too few"),
    Case(
        "similarity_matrix",
        sp.eye(2),
        (Linear(OTHER), TURNING),
        "refused",
        "deviations that change with time: no such problem is set",
    ),
    Case("measured_quantity", "place", MEASURED, "right", "a linear quantity"),
    Case(
        "measured_quantity",
        "speed",
        (Linear(OTHER, H=M([[5, 0]])), STONE, QUANTITIES),
        "right",
        "another unit",
    ),
    Case(
        "measured_quantity",
        "power",
        (Linear(OTHER, H=M([[1, 0]])), STONE, {"place": x, "power": v**3}),
        "right",
        "made linear along the motion",
    ),
    Case("measured_quantity", "speed", MEASURED, "wrong", "its derivative"),
    Case(
        "measured_quantity",
        "place",
        (Linear(OTHER, H=M([[5, 0]])), STONE, QUANTITIES),
        "wrong",
        "its integral",
    ),
    Case("measured_quantity", ..., MEASURED, "missing", "the untouched stub"),
    Case("measured_quantity", "height", MEASURED, "invalid", "a word that was not offered"),
    Case(
        "measured_quantity",
        "place",
        (Linear(OTHER, H=M([[0, 1]])), STONE, {"place": x, "way": 2 * x}),
        "refused",
        "two quantities that the equations do not tell apart",
    ),
]
LIMITS = [
    "what keeps the equations as they are (another unit, all deviations at another moment) is "
    "right in a change of variables",
    "quantities whose deviations satisfy the same equation of lowest order cannot be told apart; a "
    "problem offers none",
]
