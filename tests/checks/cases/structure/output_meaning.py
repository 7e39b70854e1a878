import sympy as sp
from case import Case

from workbook.systems import Linear

# A free body pulled along a line by a constant: place (1, t, t^2), speed (1, t), force (1).
FREE = sp.Matrix([[0, 1, 0], [0, 0, 1], [0, 0, 0]])
NAMES = {
    "place": sp.Matrix([[1, 0, 0]]),
    "speed": sp.Matrix([[0, 1, 0]]),
    "force": sp.Matrix([[0, 0, 1]]),
}
# The same in the variables (force, speed + force, place).
CHANGED = sp.Matrix([[0, 0, 1], [0, 1, 1], [1, 0, 0]])
AGAIN = CHANGED * FREE * CHANGED.inv()
PLACE = (Linear(AGAIN, H=sp.Matrix([[0, 0, 1]])), Linear(FREE), NAMES)
SPEED = (Linear(AGAIN, H=sp.Matrix([[2, -2, 0]])), Linear(FREE), NAMES)
# A mass on a spring with a turning wheel beside it: frequencies 1 and 2.
BOTH = sp.Matrix([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 2], [0, 0, -2, 0]])
PARTS = {"mass": sp.Matrix([[1, 0, 0, 0]]), "wheel": sp.Matrix([[0, 0, 1, 0]])}

CASES = [
    Case("measured_quantity", "place", PLACE, "right", "one coordinate of three"),
    Case("measured_quantity", "Speed", SPEED, "right", "another scale and sign, a capital letter"),
    Case(
        "measured_quantity",
        "wheel",
        (Linear(BOTH, H=sp.Matrix([[0, 0, 1, 1]])), Linear(BOTH), PARTS),
        "right",
        "a combination of one frequency",
    ),
    Case("measured_quantity", "speed", PLACE, "wrong", "its derivative"),
    Case("measured_quantity", "place", SPEED, "wrong", "its integral"),
    Case("measured_quantity", "force", PLACE, "wrong", "a constant"),
    Case(
        "measured_quantity",
        "mass",
        (Linear(BOTH, H=sp.Matrix([[0, 0, 1, 1]])), Linear(BOTH), PARTS),
        "wrong",
        "the other frequency",
    ),
    Case("measured_quantity", ..., PLACE, "missing", "the untouched stub"),
    Case("measured_quantity", "height", PLACE, "invalid", "a word that was not offered"),
    Case("measured_quantity", 1, PLACE, "invalid", "a number"),
    Case(
        "measured_quantity",
        "mass",
        (Linear(BOTH, H=sp.Matrix([[1, 0, 1, 0]])), Linear(BOTH), PARTS),
        "refused",
        "a measurement of neither: no such problem is set",
    ),
]
LIMITS = [
    "the sign and the scale of the measured quantity are not asked, since the equations do not "
    "tell them",
    "quantities that satisfy the same equation of lowest order cannot be told apart; a problem "
    "offers none",
]
