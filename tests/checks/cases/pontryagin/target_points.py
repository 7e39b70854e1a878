import sympy as sp
from case import Case

from workbook.systems import Controlled

x1, x2, u, v, w, alpha = sp.symbols("x1 x2 u v w alpha", real=True)
R = sp.symbols("R", positive=True)
half, infinity, interval = sp.Rational(1, 2), sp.oo, sp.Interval.open
sine, cosine, tangent = sp.sin(alpha), sp.cos(alpha), sp.tan(alpha)

DOUBLE = (Controlled({x1: x2, x2: u}, {u: (-1, 1)}),)
ORIGIN, LINE, SEGMENT = (*DOUBLE, [x1, x2]), (*DOUBLE, [x1 - x2]), (*DOUBLE, [(0, -1), (0, 1)])
CIRCLE, OUTSIDE, RADII = (
    (*DOUBLE, [x1**2 + x2**2 - R**2]),
    x1**2 + x2**2 > R**2,
    {R: interval(1, infinity)},
)
ON_CIRCLE = ([R * cosine, R * sine], alpha)
ALL_ROUND, QUARTER = (
    {**RADII, alpha: sp.Interval(0, 2 * sp.pi)},
    {**RADII, alpha: interval(sp.pi / 2, sp.pi)},
)
REACHED, SWITCHED = (
    (*CIRCLE, *ON_CIRCLE, ALL_ROUND, OUTSIDE),
    (*CIRCLE, *ON_CIRCLE, QUARTER, OUTSIDE),
)
ELLIPSE = (
    *DOUBLE,
    [x1**2 + R**2 * x2**2 - R**2],
    [R * cosine, sine],
    alpha,
    {R: interval(0, infinity), alpha: sp.Interval(0, 2 * sp.pi)},
    x1**2 + R**2 * x2**2 > R**2,
)

ORDINATE = R * sine - tangent
CURVE = [R / cosine - tangent**2 / 2, ORDINATE]
DETERMINANTS = [ORDINATE * (2 / cosine**2 - R * cosine), -R * cosine * ORDINATE]
ARCS = sp.Or(sp.And(sine > 0, R * cosine < 1), sp.And(sine < 0, R * cosine > -1))


CASES = [
    Case("reached_target_points", ARCS, REACHED, "right", "two arcs"),
    Case(
        "reached_target_points", R * sine * cosine < sp.Abs(sine), REACHED, "right", "by the rate"
    ),
    Case(
        "reached_target_points",
        sp.Or(
            sp.And(alpha > sp.acos(1 / R), alpha < sp.pi),
            sp.And(alpha > sp.pi + sp.acos(1 / R), alpha < 2 * sp.pi),
        ),
        REACHED,
        "right",
        "by angles",
    ),
    Case("reached_target_points", sp.Ne(sine, 0), REACHED, "wrong", "the whole circle"),
    Case(
        "reached_target_points",
        sp.Or(sp.And(sine > 0, cosine < 1 / R**2), sp.And(sine < 0, cosine > -1 / R**2)),
        REACHED,
        "wrong",
        "other ends",
    ),
    Case("reached_target_points", v < 1, (*LINE, [v, v], v, {}, x1 > x2), "right", "half a line"),
    Case(
        "reached_target_points",
        v < 1,
        (*LINE, [v, v], v, {}, x1 < x2),
        "wrong",
        "the half for the other side",
    ),
    Case(
        "reached_target_points",
        sp.And(ARCS, sp.Ne(alpha, 2)),
        REACHED,
        "wrong",
        "without one point",
    ),
    Case(
        "reached_target_points",
        sp.Or(ARCS, sp.And(R > 1000, alpha < sp.pi)),
        REACHED,
        "wrong",
        "too much of a huge circle",
    ),
    Case(
        "reached_target_points",
        sp.Or(
            sp.And(alpha > sp.pi / 2 - sp.asin(1 / R), alpha < sp.pi),
            sp.And(alpha > sp.pi + sp.acos(1 / R), alpha < 2 * sp.pi),
        ),
        REACHED,
        "right",
        "by other angles",
    ),
    Case(
        "reached_target_points",
        sp.Or(
            sp.And(alpha > sp.acos(1 / R), alpha < sp.pi),
            sp.And(alpha > 2 * sp.pi - sp.acos(1 / R), alpha < 2 * sp.pi),
        ),
        REACHED,
        "wrong",
        "the lower arc mirrored the other way",
    ),
    Case("reached_target_points", [R * cosine, R * sine], REACHED, "invalid", "the points"),
    Case("switching_points", CURVE, SWITCHED, "right", "coordinates by tangents"),
    Case(
        "switching_points",
        sp.Matrix([R / cosine + 0.5 * (1 - 1 / cosine**2), sine * (R - 1 / cosine)]),
        SWITCHED,
        "right",
        "by the cosine, decimals",
    ),
    Case(
        "switching_points",
        sp.Matrix([R / cosine + 0.5004 * (1 - 1 / cosine**2), sine * (R - 1 / cosine)]),
        SWITCHED,
        "right",
        "three digits",
    ),
    Case(
        "switching_points",
        sp.Matrix([R / cosine + 0.502 * (1 - 1 / cosine**2), sine * (R - 1 / cosine)]),
        SWITCHED,
        "wrong",
        "half a per cent of 0.5",
    ),
    Case("switching_points", [CURVE[0], -CURVE[1]], SWITCHED, "wrong", "the other branch"),
    Case("switching_points", [CURVE[0], R * (sine - tangent)], SWITCHED, "wrong", "a factor"),
    Case("switching_points", CURVE[1], SWITCHED, "invalid", "one coordinate"),
    Case("switching_curve_crossing", DETERMINANTS, SWITCHED, "right", "before and after"),
    Case(
        "switching_curve_crossing",
        [
            sp.diff(CURVE[0], alpha) * value - sp.diff(CURVE[1], alpha) * CURVE[1]
            for value in (1, -1)
        ],
        SWITCHED,
        "right",
        "not simplified",
    ),
    Case("switching_curve_crossing", DETERMINANTS[::-1], SWITCHED, "wrong", "after and before"),
    Case(
        "switching_curve_crossing",
        [DETERMINANTS[0], 0],
        SWITCHED,
        "wrong",
        "taken for a trajectory",
    ),
    Case("switching_curve_crossing", True, SWITCHED, "invalid", "a word of another kind"),
    Case("minimal_time_continuous", R >= 1, ELLIPSE, "right", "the border counted in"),
    Case("minimal_time_continuous", interval(1, infinity), ELLIPSE, "right", "an interval"),
    Case("minimal_time_continuous", R <= 1, ELLIPSE, "wrong", "the other half"),
    Case("minimal_time_continuous", R >= sp.Rational(11, 10), ELLIPSE, "wrong", "off by a tenth"),
    Case(
        "minimal_time_continuous",
        R >= sp.Rational(1001, 1000),
        ELLIPSE,
        "wrong",
        "off by a thousandth",
    ),
    Case(
        "minimal_time_continuous", sp.And(R >= 1, sp.Ne(R, 2)), ELLIPSE, "wrong", "a value left out"
    ),
    Case("minimal_time_continuous", 1, ELLIPSE, "invalid", "a number"),
]
LIMITS = []
