import sympy as sp
from case import Case

t, x0, x, rate = sp.symbols("t x0 x rate", real=True)
half = sp.Rational(1, 2)
MOTION = x0 / (1 + x0 * t)
NODES = {t: [0, half, 1], x0: [1, 2]}
BUMP = sp.Piecewise((1, sp.Eq(t, half)), (0, True))
FORMULA = (2 - x0) * (1 - 5 * t / 6 + t**2 / 3) + (x0 - 1) * (2 - 8 * t / 3 + 4 * t**2 / 3)
MIDDLE = (x, BUMP, {t: [0, half, 1]}, x)
TABLE = (x, MOTION, NODES, x)
ERROR = (x - MOTION, MOTION, NODES, x, None, {x0: 1})
DEFECT = (rate + x**2, MOTION, NODES, x, rate, {t: 0})
DECIMALS = (x, sp.exp(-t), {t: [0, sp.Float("0.1"), sp.Rational(1, 3)]}, x)
found = sp.interpolate([(0, 1), (0.1, sp.exp(-0.1)), (1 / 3, sp.exp(-1 / 3))], t)

h = sp.Symbol("h", positive=True)
CUBIC = (t * (t - h) * (t - 2 * h), {t: (0, 2 * h)})
DECAY = (x0 * sp.exp(-t) * (t - 1), {t: (0, 3), x0: (-1, 2)})

CASES = [
    Case("research.greatest_magnitude", 2 * h**3 / sp.sqrt(27), CUBIC, "right", "inside"),
    Case("research.greatest_magnitude", 0.385 * h**3, CUBIC, "right", "three digits"),
    Case("research.greatest_magnitude", -2 * h**3 / sp.sqrt(27), CUBIC, "wrong", "the least value"),
    Case("research.greatest_magnitude", 3 * h**3 / 8, CUBIC, "wrong", "halfway between the zeros"),
    Case("research.greatest_magnitude", t**3, CUBIC, "invalid", "a variable of the box"),
    Case("research.greatest_magnitude", ..., CUBIC, "missing", "the untouched stub"),
    Case("research.greatest_magnitude", 2, DECAY, "right", "a corner of two variables"),
    Case("research.greatest_magnitude", 2 * sp.exp(-2), DECAY, "wrong", "the other extreme"),
    Case("research.interpolant_quantity", 4 * t * (1 - t), MIDDLE, "right", "by its zeros"),
    Case("research.interpolant_quantity", 1 - (2 * t - 1) ** 2, MIDDLE, "right", "by its vertex"),
    Case("research.interpolant_quantity", t * (1 - t), MIDDLE, "wrong", "not 1 at its own node"),
    Case("research.interpolant_quantity", BUMP, MIDDLE, "wrong", "right at the nodes alone"),
    Case(
        "research.interpolant_quantity",
        FORMULA,
        TABLE,
        "right",
        "two curves joined by straight lines",
    ),
    Case("research.interpolant_quantity", sp.expand(FORMULA), TABLE, "right", "by powers"),
    Case(
        "research.interpolant_quantity",
        FORMULA.subs({t: sp.Symbol("t"), x0: sp.Symbol("x0")}),
        TABLE,
        "right",
        "plain symbols",
    ),
    Case("research.interpolant_quantity", MOTION, TABLE, "wrong", "the motion itself"),
    Case(
        "research.interpolant_quantity",
        FORMULA + t * (1 - t) * (1 - 2 * t),
        TABLE,
        "wrong",
        "it agrees at all nodes, but is of too high a degree",
    ),
    Case("research.interpolant_quantity", FORMULA.subs(x0, 1), TABLE, "wrong", "one of the curves"),
    Case(
        "research.interpolant_quantity",
        t * (1 - t) * (1 - 2 * t) / (6 * (1 + t)),
        ERROR,
        "right",
        "with the zeros at the nodes",
    ),
    Case(
        "research.interpolant_quantity",
        FORMULA - MOTION,
        ERROR,
        "right",
        "with the start left in it",
    ),
    Case(
        "research.interpolant_quantity",
        -t * (1 - t) * (1 - 2 * t) / (6 * (1 + t)),
        ERROR,
        "wrong",
        "with the other sign",
    ),
    Case(
        "research.interpolant_quantity",
        1 - 11 * x0 / 6 + x0**2,
        DEFECT,
        "right",
        "by powers of the start",
    ),
    Case("research.interpolant_quantity", 1 - 11 * x0 / 6, DEFECT, "wrong", "the rate alone"),
    Case("research.interpolant_quantity", found, DECIMALS, "right", "nodes in decimals"),
    Case("research.interpolant_quantity", sp.exp(-t), DECIMALS, "wrong", "the function itself"),
    Case(
        "research.interpolant_quantity",
        sp.Symbol("y") * t,
        TABLE,
        "invalid",
        "a symbol that is not among the data",
    ),
    Case("research.interpolant_quantity", FORMULA / (t - t), TABLE, "invalid", "undefined"),
    Case("research.interpolant_quantity", [FORMULA, FORMULA], TABLE, "invalid", "two expressions"),
    Case("research.interpolant_quantity", ..., TABLE, "missing", "the untouched stub"),
]
LIMITS = [
    "A maximum is sought on a grid of 25 points on each side and improved from the best of them.",
    "Agreement is tried at eight places between the nodes; two polynomials of these degrees that "
    "agree there are taken for equal.",
]
