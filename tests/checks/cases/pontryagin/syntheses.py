import sympy as sp
from case import Case

from workbook.systems import Controlled

x1, x2, u, v, w, alpha = sp.symbols("x1 x2 u v w alpha", real=True)
R = sp.symbols("R", positive=True)
half, infinity, interval = sp.Rational(1, 2), sp.oo, sp.Interval.open
sine, cosine, tangent = sp.sin(alpha), sp.cos(alpha), sp.tan(alpha)
PUSHED = Controlled({x1: x2, x2: x1 + u}, {u: (-1, 1)})

# The double integrator: to the origin, to a line, to a segment, to a circle, to a parabola; with a
# one-sided control; a saddle to a circle.
DOUBLE = (Controlled({x1: x2, x2: u}, {u: (-1, 1)}),)
ORIGIN, LINE, SEGMENT = (*DOUBLE, [x1, x2]), (*DOUBLE, [x1 - x2]), (*DOUBLE, [(0, -1), (0, 1)])
ONE_SIDED = (Controlled({x1: x2, x2: u}, {u: (0, 1)}), [x1, x2])
PARABOLA = (*DOUBLE, [x2**2 - x1])
POSITIONS = (*DOUBLE, [x1])
CIRCLE, OUTSIDE, RADII = (
    (*DOUBLE, [x1**2 + x2**2 - R**2]),
    x1**2 + x2**2 > R**2,
    {R: interval(1, infinity)},
)
ROUND = (*CIRCLE, RADII, OUTSIDE)
SADDLE = (PUSHED, [x1**2 + x2**2 - R**2], {R: interval(0, 1)}, OUTSIDE)
SADDLE_CURVE = (w, -sp.Abs(x1), [R * cosine, R * sine], alpha, interval(3 * sp.pi / 4, sp.pi))
SADDLE_ORIGIN = (PUSHED, [x1, x2])

TO_ORIGIN = -sp.sign(x1 + x2 * sp.Abs(x2) / 2)
W = sp.sqrt(R**2 + 1 + 2 * sp.Abs(x1))
TO_CIRCLE = sp.Piecewise(
    (-sp.sign(x2 + sp.sign(x1) * W * sp.sqrt(1 - 1 / (W - R) ** 2)), sp.Abs(x1) > R),
    (-sp.sign(x2), True),
)
CORNER = sp.Piecewise((1, sp.And(x1 > 3, x2 > 3)), (TO_ORIGIN, True))
TO_SADDLE_CIRCLE = sp.Piecewise(
    (-sp.sign(x2 + sp.sign(x1) * w), sp.Abs(x1) > R), (-sp.sign(x2), True)
)
INSIDE_PARABOLA = sp.Piecewise((1, sp.And(x2 > 0, x1 < 13 * x2**2)), (-1, True))
OUTSIDE_PARABOLA = sp.Piecewise((-1, sp.And(x2 > 0, x1 > -(x2**2) / 3)), (1, True))
TO_PARABOLA = sp.Piecewise((OUTSIDE_PARABOLA, x1 < x2**2), (INSIDE_PARABOLA, True))
TO_SEGMENT = -sp.sign(x2 + sp.sign(x1) * sp.sqrt(1 + 2 * sp.Abs(x1)))

# The oscillator: semicircles side by side, here only so many of them.
SWING = (Controlled({x1: x2, x2: u - x1}, {u: (-1, 1)}), [x1, x2])
SEMICIRCLES = -sp.sign(x1) * sp.sqrt(1 - (sp.Abs(x1) - 2 * sp.floor(sp.Abs(x1) / 2) - 1) ** 2)


def to_parabola(steepness):
    return TO_PARABOLA.xreplace({sp.Integer(13): steepness})


CASES = [
    Case("time_optimal_law", TO_ORIGIN, ORIGIN, "right", "the sign of one expression"),
    Case(
        "time_optimal_law",
        sp.Piecewise(
            (-1, 2.0 * x1 > -x2 * sp.Abs(x2)), (1, 2 * x1 < -x2 * sp.Abs(x2)), (-sp.sign(x2), True)
        ),
        ORIGIN,
        "right",
        "cases, the curve apart, a decimal",
    ),
    Case("time_optimal_law", -sp.sign(x2 - SEMICIRCLES), SWING, "right", "a curve of many arcs"),
    Case(
        "time_optimal_law",
        sp.Piecewise((-sp.sign(x2 - SEMICIRCLES), sp.Abs(x1) < 12), (-sp.sign(x2), True)),
        SWING,
        "wrong",
        "six arcs and then the axis",
    ),
    Case(
        "time_optimal_law",
        to_parabola(sp.Rational(25, 2)),
        PARABOLA,
        "wrong",
        "a constant of the dispersal curve",
    ),
    Case(
        "time_optimal_law",
        to_parabola(sp.Rational(129, 10)),
        PARABOLA,
        "wrong",
        "this constant off by a percent",
    ),
    Case(
        "time_optimal_law",
        to_parabola(sp.Float(12.5)),
        PARABOLA,
        "wrong",
        "the constant as a decimal",
    ),
    Case("time_optimal_law", to_parabola(sp.Float(13.02)), PARABOLA, "right", "three digits of it"),
    Case("time_optimal_law", -sp.tanh(1000 * x2), (*DOUBLE, [x2]), "wrong", "a smooth imitation"),
    Case(
        "time_optimal_law",
        -sp.tanh(10**5 * (x1 + x2 * sp.Abs(x2) / 2)),
        ORIGIN,
        "wrong",
        "a steep imitation",
    ),
    Case(
        "time_optimal_law", sp.Lambda((x1, x2), TO_ORIGIN), ORIGIN, "right", "a function of SymPy"
    ),
    Case(
        "time_optimal_law",
        sp.Lambda((v, w), -sp.sign(v + w * sp.Abs(w) / 2)),
        ORIGIN,
        "right",
        "in other names",
    ),
    Case(
        "time_optimal_law",
        sp.Piecewise((0, x1 > x2**2 / 2), (1, sp.Eq(x1, x2**2 / 2))),
        ONE_SIDED,
        "right",
        "said on the border alone, and not beyond",
    ),
    Case(
        "time_optimal_law",
        sp.Piecewise((0, x1 > x2**2 / 2), (1, sp.Eq(x1, x2**2))),
        ONE_SIDED,
        "wrong",
        "said on another curve",
    ),
    Case(
        "time_optimal_law",
        1 - 2 * sp.Heaviside(sp.Symbol("x1") + sp.Symbol("x2") * sp.Abs(sp.Symbol("x2")) / 2),
        ORIGIN,
        "right",
        "a step function, plain symbols",
    ),
    Case(
        "time_optimal_law",
        -sp.sign(x1 + x2 * sp.Abs(x2) * sp.Rational(52, 100)),
        ORIGIN,
        "wrong",
        "a curve that is off by four hundredths",
    ),
    Case("time_optimal_law", CORNER, ORIGIN, "wrong", "one corner of the plane wrong"),
    Case("time_optimal_law", -sp.sign(x1 + x2), ORIGIN, "wrong", "a straight switching line"),
    Case(
        "time_optimal_law",
        sp.Max(-1, sp.Min(1, -20 * (x1 + x2 * sp.Abs(x2) / 2))),
        ORIGIN,
        "wrong",
        "saturated instead of switched",
    ),
    Case("time_optimal_law", 2 * TO_ORIGIN, ORIGIN, "wrong", "outside the bounds"),
    Case("time_optimal_law", sp.sqrt(x1), ORIGIN, "wrong", "not real everywhere"),
    Case("time_optimal_law", ..., ORIGIN, "missing", "the untouched stub"),
    Case("time_optimal_law", x1 + x2 * sp.Abs(x2) / 2 > 0, ORIGIN, "invalid", "a condition"),
    Case("time_optimal_law", "-sign(x1)", ORIGIN, "invalid", "text"),
    Case("time_optimal_law", -sp.sign(x1 + R), ORIGIN, "invalid", "a foreign symbol"),
    Case(
        "time_optimal_law",
        sp.Piecewise((1, x1 <= x2**2 / 2), (0, True)),
        ONE_SIDED,
        "right",
        "along the border of the reachable set",
    ),
    Case("time_optimal_law", sp.S.Zero, ONE_SIDED, "wrong", "never braking"),
    Case("time_optimal_law", TO_CIRCLE, ROUND, "right", "a circle with a parameter"),
    Case(
        "time_optimal_law",
        TO_CIRCLE.subs(W, W * sp.Rational(103, 100)),
        ROUND,
        "wrong",
        "a curve three hundredths too high",
    ),
    Case("time_optimal_law", -sp.sign(x2), ROUND, "wrong", "no switching curve"),
    Case("time_optimal_law", TO_PARABOLA, PARABOLA, "right", "both sides of a parabola"),
    Case(
        "time_optimal_law",
        TO_PARABOLA.subs(13 * x2**2, 11 * x2**2),
        PARABOLA,
        "wrong",
        "another dispersal curve",
    ),
    Case("time_optimal_law", TO_SEGMENT, SEGMENT, "right", "a segment"),
    Case("time_optimal_law", -sp.sign(x1), SEGMENT, "wrong", "the line that contains it"),
    Case(
        "time_optimal_law",
        TO_SADDLE_CIRCLE,
        (*SADDLE, SADDLE_CURVE),
        "right",
        "a switching curve without elementary equation, by its ordinate",
    ),
    Case(
        "time_optimal_law",
        TO_SADDLE_CIRCLE.subs(w, w / 2),
        (*SADDLE, SADDLE_CURVE),
        "wrong",
        "half the ordinate",
    ),
    Case(
        "minimal_time",
        sp.sign(x1) * x2 + sp.sqrt(x2**2 + 2 * sp.Abs(x1)),
        POSITIONS,
        "right",
        "one formula for both sides",
    ),
    Case(
        "minimal_time",
        sp.Piecewise(
            (x2 + sp.sqrt(x2**2 + 2.0 * x1), x1 > 0), (-x2 + sp.sqrt(x2**2 - 2 * x1), True)
        ),
        POSITIONS,
        "right",
        "cases",
    ),
    Case(
        "minimal_time",
        x2 + sp.sqrt(x2**2 + 2 * sp.Abs(x1)),
        POSITIONS,
        "wrong",
        "right on one side only",
    ),
    Case(
        "minimal_time",
        sp.Rational(99, 100) * (sp.sign(x1) * x2 + sp.sqrt(x2**2 + 2 * sp.Abs(x1))),
        POSITIONS,
        "wrong",
        "faster than possible",
    ),
    Case("minimal_time", sp.Eq(x1, x2), POSITIONS, "invalid", "an equation"),
    Case(
        "reachable_initial_states",
        sp.And(x2 < 0, x1 >= x2**2 / 2),
        ONE_SIDED,
        "right",
        "the border counted in",
    ),
    Case(
        "reachable_initial_states",
        sp.And(x2 <= 0, 2.0 * x1 > x2**2),
        ONE_SIDED,
        "right",
        "the border left out, a decimal",
    ),
    Case(
        "reachable_initial_states", x1 >= x2**2 / 2, ONE_SIDED, "wrong", "velocities of both signs"
    ),
    Case("reachable_initial_states", sp.Abs(x1 + x2) < 1, SADDLE_ORIGIN, "right", "a strip"),
    Case(
        "reachable_initial_states",
        sp.Abs(x1 + x2) < sp.Rational(21, 20),
        SADDLE_ORIGIN,
        "wrong",
        "a wider strip",
    ),
    Case("reachable_initial_states", True, SADDLE_ORIGIN, "wrong", "the whole plane"),
    Case("reachable_initial_states", x1 + x2, SADDLE_ORIGIN, "invalid", "an expression"),
]
LIMITS = [
    "A law is tried from 80 to 400 starts: some spread over the plane to a distance of about "
    "ten, some at 0.6 per cent of their distance from the origin on both sides of the switching "
    "curves (1.5 per cent if it contains decimals), some at 0.02 per cent. A mistake that no "
    "start meets passes.",
    "Far from the origin, up to a distance of about thirty, a law is tried for targets that are "
    "points.",
    "A law may be slower than the optimum by 0.4 per cent of the time; the last 3 per cent of a "
    "motion are taken from the optimum.",
    "The value of a law on a curve alone is judged where it has none on one side: on the border "
    "of the set from which the target can be reached.",
    "Next to a barrier (2 per cent) a law is not judged when the target is so thin that the "
    "optimum itself may have missed it.",
    "Parameters are tried at six values of each interval, at most about 4 where an interval is "
    "infinite.",
    "Whether a target can be reached is decided within a time of 400; starts that border on the "
    "other kind are left out.",
]
