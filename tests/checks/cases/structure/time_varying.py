import sympy as sp
from case import Case

from workbook.systems import Linear, Varying

t, w, a, b = sp.symbols("t omega a b", real=True)
# A body on a line: H(t) mixes place and speed.
FREE = sp.Matrix([[0, 1], [0, 0]])
FADES = (Varying(FREE, sp.Matrix([[1, -t]]), t), [])  # z = x1 - t x2 is the start x1(0)
MIXED = sp.Matrix([[1, (w - 2) * t**2]])  # z = x10 + t x20 + (w - 2) t^2 x20
RADAR = sp.Matrix([[sp.cos(w * t), sp.sin(w * t), 0, 0]])
PLANE = sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0, 0]])
# unseen by the direction that does not turn
SIDEWAYS = {0: sp.Matrix([[0, 0], [1, 0], [0, 0], [0, 2]])}
# z = x10 e^((1 + w) t) + (w - 1) x20 e^(4 t): one part vanishes, or both have one rate.
GROWTH = (Varying(sp.diag(1, 3), sp.Matrix([[sp.exp(w * t), (w - 1) * sp.exp(t)]]), t),)
# The phase of an oscillator of frequency 2, compared with one of frequency w.
BEAT = (Varying(sp.Matrix([[0, 2], [-2, 0]]), sp.Matrix([[sp.sin(w * t), sp.cos(w * t)]]), t),)
BEAT_Z = a * sp.sin((w - 2) * t) + b * sp.cos((w - 2) * t)
ONES = sp.Matrix([[1, t]])
WHOLE = sp.Matrix([[sp.Rational(1), 1], [1, sp.Rational(4, 3)]])  # of z = a + 2 t b on [0, 1]
# The phases of BEAT over a second, each entry as it is written for w other than 2, and at 2.
SINE, BOTH, HALF = (
    sp.sin(2 * w - 4) / (4 * w - 8),
    sp.sin(w - 2) ** 2 / (2 * w - 4),
    sp.Rational(1, 2),
)
FIRST = sp.Piecewise((0, sp.Eq(w, 2)), (HALF - SINE, True))
MEAN = sp.Piecewise((BOTH, sp.Ne(w, 2)), (0, True))
SECOND = sp.Piecewise((HALF + SINE, w < 2), (HALF + SINE, w > 2), (1, True))

# The speed of a platform that is levelled by it, with a drift and a bias.
g, R = sp.symbols("g R", positive=True)
v0, phi0, eps, bias = sp.symbols("v0 phi0 eps b", real=True)
PLATFORM = Linear([[0, -g, 0, 1], [1 / R, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 0]], H=[[1, 0, 0, 0]])
SPEED = (PLATFORM, [v0, phi0, eps, bias], t, [g, R])
f = sp.sqrt(g / R)

CASES = [
    Case(
        "measured_output",
        BEAT_Z,
        (*BEAT, [a, b], t, [w]),
        "right",
        "the difference of two frequencies",
    ),
    Case("measured_output", a, (FADES[0], [a, b], t), "right", "a constant"),
    Case(
        "measured_output",
        sp.expand_trig(sp.expand(BEAT_Z)),
        (*BEAT, [a, b], t, [w]),
        "right",
        "products",
    ),
    Case(
        "measured_output",
        BEAT_Z.subs(w, w + 4),
        (*BEAT, [a, b], t, [w]),
        "wrong",
        "the sum of the frequencies",
    ),
    Case("measured_output", a - t * b, (FADES[0], [a, b], t), "wrong", "the state held fast"),
    Case(
        "measured_output",
        sp.Piecewise((BEAT_Z, w > 1)),
        (*BEAT, [a, b], t, [w]),
        "wrong",
        "defined for some parameters alone",
    ),
    Case(
        "measured_output",
        sp.Symbol("x1"),
        (*BEAT, [a, b], t, [w]),
        "invalid",
        "a symbol that is not of the start",
    ),
    Case(
        "measured_output",
        -R * eps + (v0 + R * eps) * sp.cos(f * t) + (bias - g * phi0) / f * sp.sin(f * t),
        SPEED,
        "right",
        "a constant row",
    ),
    Case(
        "measured_output",
        v0 * sp.cos(f * t)
        - 2 * R * eps * sp.sin(f * t / 2) ** 2
        + (bias - g * phi0) / f * sp.sin(f * t),
        SPEED,
        "right",
        "half angle",
    ),
    Case("measured_output", v0 + (bias - g * phi0) * t, SPEED, "wrong", "for short times only"),
    Case(
        "measured_output",
        -R * eps + v0 * sp.cos(f * t) + (bias - g * phi0) / f * sp.sin(f * t),
        SPEED,
        "wrong",
        "another start",
    ),
    Case("measured_output", sp.Function("v")(t), SPEED, "invalid", "an unknown function"),
    Case("measured_output", ..., SPEED, "missing", "the untouched stub"),
    Case("observability_matrix", [[1, -t], [0, 0]], FADES, "right", "a first integral"),
    Case(
        "observability_matrix",
        sp.Matrix([[1, t], [0, 2]]),
        (Varying(FREE, ONES, t), []),
        "right",
        "a power of t",
    ),
    Case("observability_matrix", sp.Matrix([[1, -t], [0, 1]]), FADES, "wrong", "H and HA"),
    Case(
        "observability_matrix",
        sp.Matrix([[1, -t], [0, -1]]),
        FADES,
        "wrong",
        "H and its derivative",
    ),
    Case("observability_matrix", sp.Matrix([[1, 0], [0, 0]]), FADES, "wrong", "at t = 0 alone"),
    Case("observability_matrix", sp.Matrix([[1, -t]]), FADES, "invalid", "a single row"),
    Case("output_gramian", WHOLE, (Varying(FREE, ONES, t), 1, []), "right", "a polynomial"),
    Case(
        "output_gramian",
        [[1.0, 1.0], [1.0, 1.333]],
        (Varying(FREE, ONES, t), 1, []),
        "right",
        "decimals",
    ),
    Case(
        "output_gramian",
        sp.Matrix([[1, 1], [1, 1.3]]),
        (Varying(FREE, ONES, t), 1, []),
        "wrong",
        "two digits",
    ),
    Case("output_gramian", 2 * WHOLE, (Varying(FREE, ONES, t), 1, []), "wrong", "twice as much"),
    Case(
        "output_gramian",
        sp.Matrix([[1, sp.Rational(1, 2)], [sp.Rational(1, 2), sp.Rational(1, 3)]]),
        (Varying(FREE, ONES, t), 1, []),
        "wrong",
        "the state held fast",
    ),
    Case(
        "output_gramian",
        [[FIRST, BOTH], [BOTH, 1 - FIRST]],
        (*BEAT, 1, [w]),
        "right",
        "a limit in some entries, where the others have no value",
    ),
    Case(
        "output_gramian",
        sp.ImmutableMatrix([[HALF - SINE, MEAN], [MEAN, HALF + SINE]]),
        (*BEAT, 1, [w]),
        "right",
        "by an inequation",
    ),
    Case(
        "output_gramian",
        sp.Matrix([[HALF - SINE, BOTH], [BOTH, SECOND]]),
        (*BEAT, 1, [w]),
        "right",
        "by intervals",
    ),
    Case(
        "output_gramian",
        [[FIRST, MEAN], [MEAN, SECOND]],
        (*BEAT, 1, [w]),
        "right",
        "a limit in every entry",
    ),
    Case(
        "output_gramian",
        [[FIRST, MEAN + 1 - sp.sign(sp.Abs(w - 2))], [MEAN, SECOND]],
        (*BEAT, 1, [w]),
        "wrong",
        "wrong at one value alone",
    ),
    Case(
        "output_gramian",
        [[FIRST, MEAN], [MEAN, sp.Piecewise((1 / (w - 2), sp.Eq(w, 2)), (HALF + SINE, True))]],
        (*BEAT, 1, [w]),
        "wrong",
        "a value left out in the case that is for it",
    ),
    Case(
        "output_gramian",
        [[FIRST, BOTH], [BOTH, HALF - SINE]],
        (*BEAT, 1, [w]),
        "wrong",
        "twice the first",
    ),
    Case(
        "output_gramian", sp.Matrix([1, 1]), (Varying(FREE, ONES, t), 1, []), "invalid", "a column"
    ),
    Case("frozen_determinant", 2, (*BEAT, [w]), "right", "the same at all moments"),
    Case(
        "frozen_determinant",
        2.004 * sp.cos(w * t) ** 2 + 2 * sp.sin(w * t) ** 2,
        (*BEAT, [w]),
        "right",
        "a coefficient to three digits",
    ),
    Case(
        "frozen_determinant",
        2.009 * sp.cos(w * t) ** 2 + 2 * sp.sin(w * t) ** 2,
        (*BEAT, [w]),
        "wrong",
        "a coefficient to two digits",
    ),
    Case(
        "frozen_determinant",
        2 * sp.cos(w * t) ** 2 + 2 * sp.sin(w * t) ** 2,
        (*BEAT, [w]),
        "right",
        "not simplified",
    ),
    Case("frozen_determinant", 2 - w, (*BEAT, [w]), "wrong", "with the derivative of H"),
    Case("frozen_determinant", -2, (*BEAT, [w]), "wrong", "the rows interchanged"),
    Case("frozen_determinant", "two", (*BEAT, [w]), "invalid", "a word"),
    Case("observable_parameters", sp.Ne(w, 2), (*BEAT, [w]), "right", "the common frequency"),
    Case(
        "observable_parameters",
        sp.Ne(w, 0),
        (Varying(PLANE, RADAR, t), [w]),
        "right",
        "a direction that turns; frozen rows fail",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(w, 1), sp.Ne(w, 3)),
        (*GROWTH, [w]),
        "right",
        "exponentials",
    ),
    Case("observable_parameters", sp.Ne(w, 1), (*GROWTH, [w]), "wrong", "equal rates overlooked"),
    Case(
        "observable_parameters",
        sp.true,
        (Varying(FREE, MIXED, t), [w]),
        "right",
        "polynomials, always",
    ),
    Case("observable_parameters", sp.true, (*BEAT, [w]), "wrong", "the frozen test"),
    Case(
        "observable_parameters",
        sp.Ne(w**2, 4),
        (*BEAT, [w]),
        "wrong",
        "the opposite direction excluded as well",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(w, 2), sp.Ne(w, sp.sqrt(3))),
        (*BEAT, [w]),
        "wrong",
        "an irrational value too many",
    ),
    Case(
        "observable_parameters",
        sp.false,
        (Varying(PLANE, RADAR, t), [w]),
        "wrong",
        "the frozen test again",
    ),
    Case(
        "observable_parameters",
        sp.Ne(w, 2),
        (Varying(FREE, MIXED, t), [w]),
        "wrong",
        "a coefficient that vanishes, and does no harm",
    ),
    Case("observable_parameters", w - 2, (*BEAT, [w]), "invalid", "no condition"),
    Case(
        "observable_parameters",
        sp.Ne(w, 2),
        (Varying(FREE, sp.Matrix([[1, 1 / (1 + t)]]), t), [w]),
        "refused",
        "a row beyond the method",
    ),
    Case("unobservable_states_at", {2: [[1, 0]]}, (*BEAT, w), "right", "one value"),
    Case(
        "unobservable_states_at",
        SIDEWAYS,
        (Varying(PLANE, RADAR, w),),
        "refused",
        "the time forgotten in the data",
    ),
    Case(
        "unobservable_states_at",
        SIDEWAYS,
        (Varying(PLANE, RADAR, t), w),
        "right",
        "a plane, as columns",
    ),
    Case("unobservable_states_at", {}, (Varying(FREE, MIXED, t), w), "right", "no value"),
    Case("unobservable_states_at", {2: [[0, 1]]}, (*BEAT, w), "wrong", "what is seen"),
    Case(
        "unobservable_states_at",
        {2: [[1, 0]], -2: [[1, 0]]},
        (*BEAT, w),
        "wrong",
        "a value too many",
    ),
    Case(
        "unobservable_states_at",
        {0: [[0, 1, 0, 0]]},
        (Varying(PLANE, RADAR, t), w),
        "wrong",
        "half of the plane",
    ),
    Case("unobservable_states_at", {}, (*BEAT, w), "wrong", "none"),
    Case("unobservable_states_at", [[1, 0]], (*BEAT, w), "invalid", "without the value"),
    Case("unobservable_states_at", ..., (*BEAT, w), "missing", "the untouched stub"),
]
LIMITS = [
    "H(t) has to consist of sines, cosines, exponentials and powers of t, and be rational with "
    "its derivatives at t = 0."
]
