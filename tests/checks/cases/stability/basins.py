import sympy as sp
from case import Case

x, y, e, a, b = sp.symbols("x y e a b", real=True)
V = (x**2 + y**2) / 2
POL = (V, sp.Matrix([y, -e * (x**2 - 1) * y - x]), [x, y], [e])
# Worked example 2 of the source with a = 1, b = 1: the level through the saddle (-2/3, 0).
WELL = (y**2 / 2 + x**2 + x**3, sp.Matrix([y, -2 * x - y - 3 * x**2]), [x, y])
SPRING = ((b * x**4 + 2 * x**2 + 2 * y**2) / 4, sp.Matrix([y, -a * y - x - b * x**3]), [x, y])
SOFT = (*SPRING, [a, b], [a > 0, b < 0])
r, c = 1 / sp.sqrt(-b), -1 / (4 * b)

CASES = [
    Case("basin_estimate", x**2 + y**2 < 1, POL, "right", "the disc"),
    Case("basin_estimate", V < sp.Rational(1, 2), POL, "right", "by the level"),
    Case("basin_estimate", x**2 + y**2 < sp.Rational(9, 10), POL, "wrong", "too small"),
    Case("basin_estimate", x**2 + y**2 < sp.Rational(12, 10), POL, "wrong", "too large"),
    Case("basin_estimate", sp.Abs(x) < 1, POL, "wrong", "the strip"),
    Case("basin_estimate", x**2 + 2 * y**2 < 1, POL, "wrong", "an ellipse inside the disc"),
    Case(
        "basin_estimate",
        sp.And(WELL[0] < sp.Rational(4, 27), x > -sp.Rational(2, 3)),
        WELL,
        "right",
        "worked example 2",
    ),
    Case(
        "basin_estimate",
        sp.And(WELL[0] < 0.1481481, x > -sp.Rational(2, 3)),
        WELL,
        "right",
        "with decimals",
    ),
    Case(
        "basin_estimate",
        sp.And(WELL[0] < sp.Rational(3, 27), x > -sp.Rational(2, 3)),
        WELL,
        "wrong",
        "a lower level",
    ),
    Case("basin_level", c, SOFT, "right", "by b"),
    Case("basin_level", 0.25 / sp.Abs(b), SOFT, "right", "by the modulus, with a decimal"),
    Case("basin_level", -1 / (2 * b), SOFT, "wrong", "twice too high"),
    Case("basin_level", -1 / (8 * b), SOFT, "wrong", "twice too low"),
    Case("basin_level", 1.02 * c, SOFT, "wrong", "a little too high"),
    Case("basin_level", 1 / (4 * b), SOFT, "wrong", "negative"),
    Case("basin_level", SPRING[0] < c, SOFT, "invalid", "the set instead of the level"),
    Case(
        "basin_estimate",
        sp.And(SPRING[0] < c, sp.Abs(x) < r),
        SOFT,
        "right",
        "a set that contains a parameter",
    ),
    Case("basin_estimate", [SPRING[0] < c, -r < x, x < r], SOFT, "right", "a list"),
    Case(
        "basin_estimate",
        sp.And(SPRING[0] <= c, x**2 < -1 / b),
        SOFT,
        "right",
        "closed, without the saddles",
    ),
    Case(
        "basin_estimate",
        sp.And(SPRING[0] <= c, x**2 <= -1 / b),
        SOFT,
        "wrong",
        "closed, with the saddles",
    ),
    Case(
        "basin_estimate", SPRING[0] < c, SOFT, "wrong", "the parts beyond the saddles taken along"
    ),
    Case(
        "basin_estimate",
        sp.And(SPRING[0] < c, sp.Abs(x) < 1.05 * r),
        SOFT,
        "wrong",
        "a little of the parts beyond the saddles",
    ),
    Case("basin_estimate", sp.And(x**2 + y**2 < 1, sp.Ne(x, 0)), POL, "wrong", "an axis left out"),
    Case(
        "basin_estimate",
        sp.And(x**2 + y**2 < 1, sp.Or(sp.Ne(x**2, 2 * y**2), sp.Eq(x, 0))),
        POL,
        "wrong",
        "two oblique lines left out, but for zero",
    ),
    Case(
        "basin_estimate",
        sp.And(x**2 + y**2 < 1, (x - y) ** 2 > 0),
        POL,
        "wrong",
        "by an inequality",
    ),
    Case(
        "basin_estimate",
        sp.And(SPRING[0] < c, sp.Abs(x) < r, sp.Ne(x, y)),
        SOFT,
        "wrong",
        "a diagonal left out",
    ),
    Case("basin_estimate", sp.Abs(x) < r, SOFT, "wrong", "the strip between the saddles"),
    Case(
        "basin_estimate", sp.And(SPRING[0] < c / 2, sp.Abs(x) < r), SOFT, "wrong", "half the level"
    ),
    Case(
        "basin_estimate",
        sp.Or(sp.And(SPRING[0] < c, sp.Abs(x) < r), x > 1000),
        SOFT,
        "wrong",
        "a part far away",
    ),
    Case(
        "basin_estimate",
        sp.Or(x**2 + y**2 < 1, (x - 9) ** 2 + y**2 < sp.Rational(1, 100)),
        POL,
        "wrong",
        "a small disc far away",
    ),
    Case("basin_estimate", ..., WELL, "missing", "the untouched stub"),
    Case("basin_estimate", 0.5, POL, "invalid", "the level alone"),
]
LIMITS = [
    "A basin estimate is followed along 240 rays from zero, so the set has to be star-shaped "
    "around zero.",
    "The set is judged for two samples of the parameters at which the linearisation is "
    "asymptotically stable; that the level line itself belongs to the set, or does not, is told "
    "apart only at other equilibria.",
]
