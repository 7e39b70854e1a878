import sympy as sp
from case import Case

from workbook.systems import Controlled

x1, x2, u, v, w, alpha = sp.symbols("x1 x2 u v w alpha", real=True)

DOUBLE = (Controlled({x1: x2, x2: u}, {u: (-1, 1)}),)
POSITIONS = (*DOUBLE, [x1])


CASES = [
    Case(
        "other_extremal_exists",
        sp.And(x1 * x2 < 0, x2**2 >= 2 * sp.Abs(x1)),
        POSITIONS,
        "right",
        "both sides",
    ),
    Case(
        "other_extremal_exists",
        sp.Or(sp.And(x1 > 0, x2 < -sp.sqrt(2 * x1)), sp.And(x1 < 0, x2 > sp.sqrt(-2 * x1))),
        POSITIONS,
        "right",
        "side by side",
    ),
    Case(
        "other_extremal_exists",
        x2**2 >= 2 * sp.Abs(x1),
        POSITIONS,
        "wrong",
        "motions away from the line too",
    ),
    Case(
        "other_extremal_exists",
        sp.And(x1 * x2 < 0, x2**2 >= 2 * sp.Abs(x1), x2 < 100),
        POSITIONS,
        "wrong",
        "not when fast",
    ),
    Case("other_extremal_exists", False, POSITIONS, "wrong", "never"),
    Case(
        "other_extremal_exists",
        False,
        (*DOUBLE, [x2]),
        "right",
        "a line with one extremal for each start",
    ),
    Case("other_extremal_exists", x1, POSITIONS, "invalid", "an expression"),
    Case(
        "other_extremal_time",
        sp.Abs(x2) + sp.sqrt(x2**2 - 2 * sp.Abs(x1)),
        POSITIONS,
        "right",
        "the second meeting",
    ),
    Case(
        "other_extremal_time",
        -sp.sign(x1) * x2 + (x2**2 - 2.0 * sp.Abs(x1)) ** 0.5,
        POSITIONS,
        "right",
        "decimals",
    ),
    Case(
        "other_extremal_time",
        -sp.sign(x1) * x2 + sp.sqrt(x2**2 - 2.008 * sp.Abs(x1)),
        POSITIONS,
        "wrong",
        "two digits",
    ),
    Case(
        "other_extremal_time",
        sp.Abs(x2) - sp.sqrt(x2**2 - 2 * sp.Abs(x1)),
        POSITIONS,
        "wrong",
        "the first meeting",
    ),
    Case(
        "other_extremal_time",
        sp.sign(x1) * x2 + sp.sqrt(x2**2 + 2 * sp.Abs(x1)),
        POSITIONS,
        "wrong",
        "the fastest extremal",
    ),
    Case("other_extremal_time", x1 > 0, POSITIONS, "invalid", "a condition"),
]
LIMITS = []
