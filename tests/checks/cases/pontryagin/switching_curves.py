import sympy as sp
from case import Case

from workbook.systems import Controlled

x1, x2, u, v, w, alpha = sp.symbols("x1 x2 u v w alpha", real=True)
R = sp.symbols("R", positive=True)
half, infinity, interval = sp.Rational(1, 2), sp.oo, sp.Interval.open

DOUBLE = (Controlled({x1: x2, x2: u}, {u: (-1, 1)}),)
ORIGIN, LINE, SEGMENT = (*DOUBLE, [x1, x2]), (*DOUBLE, [x1 - x2]), (*DOUBLE, [(0, -1), (0, 1)])
BRAKED = (*ORIGIN, {x2: sp.Interval(-3, 3)})
PARABOLA = (*DOUBLE, [x2**2 - x1])
CIRCLE, OUTSIDE, RADII = (
    (*DOUBLE, [x1**2 + x2**2 - R**2]),
    x1**2 + x2**2 > R**2,
    {R: interval(1, infinity)},
)

DISPERSAL, BARRIER = (("kind", "dispersal"),), (("kind", "barrier"),)

CONTACT = {x2: sp.Interval(sp.sqrt(R**2 - 1), infinity)}


CASES = [
    Case(
        "switching_curve",
        half,
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "right",
        "a vertical ray",
    ),
    Case(
        "switching_curve",
        0.5,
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "right",
        "a decimal",
    ),
    Case(
        "switching_curve",
        sp.Rational(3, 5),
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "wrong",
        "another ray",
    ),
    Case("switching_curve", -0.501 * x2 * sp.Abs(x2), BRAKED, "wrong", "two digits of a constant"),
    Case(
        "switching_curve", -0.5004 * x2 * sp.Abs(x2), BRAKED, "right", "three digits of a constant"
    ),
    Case("switching_curve", -0.49 * x2 * sp.Abs(x2), BRAKED, "wrong", "a constant too small"),
    Case("switching_curve", -0.51 * x2 * sp.Abs(x2), BRAKED, "wrong", "a constant too large"),
    Case(
        "switching_curve",
        -sp.Rational(499, 1000) * x2 * sp.Abs(x2),
        BRAKED,
        "wrong",
        "an exact constant, a little off",
    ),
    Case(
        "switching_curve",
        0.501,
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "wrong",
        "another third digit of a number",
    ),
    Case(
        "switching_curve",
        13 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "wrong",
        "a dispersal curve",
    ),
    Case(
        "switching_curve",
        sp.Eq(x1, half),
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "invalid",
        "an equation",
    ),
    Case(
        "switching_curve",
        13 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "right",
        "a parabola",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        13.0 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "right",
        "a decimal",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        12.97 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "right",
        "three digits of a constant",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        12.9 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "wrong",
        "another third digit of a constant",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        sp.Rational(1299, 100) * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "wrong",
        "an exact constant, a little off",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        12 * x2**2,
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "wrong",
        "another parabola",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        half,
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "wrong",
        "a switching curve",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        [13],
        (*PARABOLA, {x2: interval(0, 2)}, {}, x1 > x2**2),
        "invalid",
        "a list",
        DISPERSAL,
    ),
    Case(
        "switching_curve",
        (R**2 + 1 - x2**2) / 2,
        (*CIRCLE, CONTACT, RADII, OUTSIDE),
        "right",
        "the trajectory that touches",
        BARRIER,
    ),
    Case(
        "switching_curve",
        0.5 * (R**2 + 1) - 0.5 * x2**2,
        (*CIRCLE, CONTACT, RADII, OUTSIDE),
        "right",
        "decimals",
        BARRIER,
    ),
    Case(
        "switching_curve",
        (R**2 - x2**2) / 2,
        (*CIRCLE, CONTACT, RADII, OUTSIDE),
        "wrong",
        "the trajectory to the top",
        BARRIER,
    ),
    Case(
        "switching_curve",
        half,
        (*LINE, {x2: interval(-infinity, 0)}, {}, x1 > x2),
        "wrong",
        "a switching curve",
        BARRIER,
    ),
    Case(
        "switching_curve",
        "none",
        (*CIRCLE, CONTACT, RADII, OUTSIDE),
        "invalid",
        "text",
        BARRIER,
    ),
]
LIMITS = [
    "A switching or dispersal curve has to lie where the control changes, up to 0.01 per cent of "
    "its coordinates, or to three digits if it contains decimals; a barrier may lie 0.01 per "
    "cent beside, with decimals 0.06."
]
