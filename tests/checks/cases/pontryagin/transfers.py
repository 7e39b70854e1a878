import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, x1, x2, u, a, b, x0, theta = sp.symbols("x x1 x2 u a b x0 theta", real=True)
t, T, A, R = sp.symbols("t T A R", positive=True)
n = sp.symbols("n", integer=True, nonnegative=True)
Piecewise, sign = sp.Piecewise, sp.sign

# A point on a line, an unstable one, a spring of variable stiffness, the double integrator, the
# oscillator: problems of §5.1.
LINE = Problem({x: u}, {u: (-A, A)}, {x: a}, [x - b])
PARAMETERS = [A, a, b]
RUNAWAY = Problem({x: x + u}, {u: (-1, 1)}, {x: x0}, [x])
SPRING, LATE = (
    Problem(
        {x1: x2, x2: -u * x1}, {u: (1, 4)}, {x1: 1, x2: 0}, [x2], maximise=late, first_return=True
    )
    for late in (False, True)
)
ORIGIN, ANYWHERE, STATE = [x1, x2], {x1: None, x2: None}, [x1, x2]
MASS = Problem({x1: x2, x2: u}, {u: (-1, 1)}, ANYWHERE, ORIGIN)
REST = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, ORIGIN)
PUSHED = Problem({x1: x2, x2: u}, {u: (0, 1)}, ANYWHERE, ORIGIN)
SWING = Problem({x1: x2, x2: u - x1}, {u: (-1, 1)}, ANYWHERE, ORIGIN)
AT_R = Problem({x1: x2, x2: u - x1}, {u: (-1, 1)}, {x1: R, x2: 0}, ORIGIN)
SADDLE = Problem({x1: x2, x2: u + x1}, {u: (-1, 1)}, ANYWHERE, ORIGIN)
SIDE = x1 + x2 * sp.Abs(x2) / 2
MASS_TIME = Piecewise(
    (x2 + 2 * sp.sqrt(x1 + x2**2 / 2), SIDE >= 0), (-x2 + 2 * sp.sqrt(x2**2 / 2 - x1), True)
)

CASES = [
    Case("optimal_duration", sp.Abs(b - a) / A, (LINE, PARAMETERS), "right", "one state"),
    Case(
        "optimal_duration",
        sp.sqrt((a - b) ** 2) / sp.Symbol("A"),
        (LINE, PARAMETERS),
        "right",
        "plain symbols, a root",
    ),
    Case(
        "optimal_duration",
        -sp.log(1 - sp.Abs(x0)),
        (RUNAWAY, [x0]),
        "right",
        "where the target can be reached",
    ),
    Case("optimal_duration", 1.57, (SPRING,), "right", "three digits"),
    Case("optimal_duration", MASS_TIME, (MASS, STATE), "right", "a function of the start"),
    Case("optimal_duration", (b - a) / A, (LINE, PARAMETERS), "wrong", "to one side only"),
    Case("optimal_duration", sp.Abs(x0), (RUNAWAY, [x0]), "wrong", "the instability forgotten"),
    Case("optimal_duration", sp.pi, (SPRING,), "wrong", "the slowest"),
    Case("optimal_duration", 0, (SPRING,), "wrong", "the start itself"),
    Case("optimal_duration", 1.59, (SPRING,), "wrong", "slow by a percent"),
    Case(
        "optimal_duration",
        1.01 * MASS_TIME,
        (MASS, STATE),
        "wrong",
        "a function that is slow by a percent",
    ),
    Case("optimal_duration", ..., (SPRING,), "missing", "the untouched stub"),
    Case("optimal_duration", sp.Eq(T, 1), (LINE, PARAMETERS), "invalid", "an equation"),
    Case("optimal_duration", sp.pi, (LATE,), "right", "the first return at the latest"),
    Case("optimal_duration", 3.14, (LATE,), "right", "three digits"),
    Case("optimal_duration", 2 * sp.pi, (LATE,), "wrong", "a later return"),
    Case("optimal_duration", sp.pi / 2, (LATE,), "wrong", "the fastest"),
    Case("optimal_duration", "pi", (LATE,), "invalid", "text"),
    Case(
        "optimal_control",
        A * sign(b - a),
        (LINE, t, PARAMETERS),
        "right",
        "a constant with parameters",
    ),
    Case(
        "optimal_control",
        [[A * sign(b - a), sp.Abs(b - a) / A]],
        (LINE, t, PARAMETERS),
        "right",
        "one arc",
    ),
    Case("optimal_control", 4, (SPRING, t), "right", "a number"),
    Case("optimal_control", Piecewise((-1, t < 1), (1, True)), (REST, t), "right", "a switching"),
    Case("optimal_control", [(-1, 1), (1, 2)], (REST, t), "right", "two arcs"),
    Case("optimal_control", sign(t - 1), (REST, t), "right", "the sign of the switching function"),
    Case("optimal_control", [(-1, 1.0), (1, 2.0)], (REST, t), "right", "decimals"),
    Case("optimal_control", A, (LINE, t, PARAMETERS), "wrong", "to one side only"),
    Case(
        "optimal_control",
        Piecewise((-1, t < sp.Rational(11, 10)), (1, True)),
        (REST, t),
        "wrong",
        "switching too late",
    ),
    Case("optimal_control", 5, (SPRING, t), "wrong", "beyond the bound"),
    Case(
        "optimal_control",
        Piecewise((4, t < 1), (3, True)),
        (SPRING, t),
        "wrong",
        "slower at the end",
    ),
    Case("optimal_control", [(-1, 1)], (REST, t), "wrong", "the last arc missing"),
    Case(
        "optimal_control",
        [(-1, 1), (1, 2), (1, 3)],
        (REST, t),
        "right",
        "what comes after the end is of no account",
    ),
    Case(
        "optimal_control",
        [(-1, 1), (1, 2), (1, 1)],
        (REST, t),
        "wrong",
        "an arc that ends before it begins",
    ),
    Case("optimal_control", x2, (REST, t), "invalid", "a law in the state"),
    Case("optimal_control", 1, (LATE, t), "right", "a number"),
    Case("optimal_control", [[1, sp.pi]], (LATE, t), "right", "one arc"),
    Case(
        "optimal_control",
        4,
        (LATE, t),
        "wrong",
        "it has met the target before, and meets it again in time",
    ),
    Case("optimal_control", Piecewise((1, t < 1), (2, True)), (LATE, t), "wrong", "too fast"),
    Case("optimal_control", [1, 4], (LATE, t), "invalid", "values without times"),
    Case("optimal_motion", a + A * t * sign(b - a), (LINE, t, PARAMETERS), "right", "one state"),
    Case(
        "optimal_motion",
        [a + A * t * sign(b - a)],
        (LINE, t, PARAMETERS),
        "right",
        "one state in a list",
    ),
    Case("optimal_motion", sp.cos(2 * t), (SPRING, t), "right", "the first of two states"),
    Case(
        "optimal_motion",
        [sp.cos(2 * t), -2.0 * sp.sin(2 * t)],
        (SPRING, t),
        "right",
        "both states, a decimal",
    ),
    Case(
        "optimal_motion",
        Piecewise((1 - t**2 / 2, t < 1), ((t - 2) ** 2 / 2, True)),
        (REST, t),
        "right",
        "two arcs",
    ),
    Case(
        "optimal_motion",
        a + (b - a) * t,
        (LINE, t, PARAMETERS),
        "wrong",
        "faster than the bounds allow, or slower",
    ),
    Case("optimal_motion", sp.cos(t), (SPRING, t), "wrong", "too slow"),
    Case("optimal_motion", sp.sin(2 * t), (SPRING, t), "wrong", "another start"),
    Case(
        "optimal_motion",
        [sp.cos(2 * t), sp.sin(2 * t)],
        (SPRING, t),
        "wrong",
        "the second state is not the velocity",
    ),
    Case("optimal_motion", [1, 2, 3], (SPRING, t), "invalid", "three states"),
    Case("optimal_motion", sp.cos(t), (LATE, t), "right", "the slowest"),
    Case("optimal_motion", [sp.cos(t), -sp.sin(t)], (LATE, t), "right", "both states"),
    Case("optimal_motion", sp.cos(2 * t), (LATE, t), "wrong", "meets the target twice as early"),
    Case("optimal_motion", sp.cos(t) + t / 100, (LATE, t), "wrong", "not a motion"),
    Case("optimal_motion", sp.Eq(x, sp.cos(t)), (LATE, t), "invalid", "an equation"),
    Case("optimal_costate", sign(b - a) / A, (LINE, t, PARAMETERS), "right", "one state"),
    Case(
        "optimal_costate",
        [-sp.sin(2 * t) / 2, -sp.cos(2 * t) / 4],
        (SPRING, t),
        "right",
        "two states",
    ),
    Case("optimal_costate", sp.Matrix([-1, t - 1]), (REST, t), "right", "a column"),
    Case("optimal_costate", sign(b - a), (LINE, t, PARAMETERS), "wrong", "not normalised"),
    Case(
        "optimal_costate",
        [sp.sin(2 * t) / 2, sp.cos(2 * t) / 4],
        (SPRING, t),
        "wrong",
        "the sign of the slowest",
    ),
    Case(
        "optimal_costate",
        [sp.cos(2 * t) - sp.sin(2 * t) / 2, -sp.sin(2 * t) / 2 - sp.cos(2 * t) / 4],
        (SPRING, t),
        "wrong",
        "no transversality",
    ),
    Case("optimal_costate", [-1, 1 - t], (REST, t), "wrong", "the adjoint equation"),
    Case("optimal_costate", [-1], (REST, t), "invalid", "one component"),
    Case("optimal_costate", [sp.sin(t), sp.cos(t)], (LATE, t), "right", "two states"),
    Case("optimal_costate", (1.0 * sp.sin(t), 1.0 * sp.cos(t)), (LATE, t), "right", "decimals"),
    Case(
        "optimal_costate", [-sp.sin(t), -sp.cos(t)], (LATE, t), "wrong", "the sign of the fastest"
    ),
    Case("optimal_costate", [2 * sp.sin(t), 2 * sp.cos(t)], (LATE, t), "wrong", "not normalised"),
    Case("optimal_costate", "sin", (LATE, t), "invalid", "text"),
    Case("optimal_switching", sp.cos(2 * t) ** 2 / 4, (SPRING, t), "right", "touching zero"),
    Case("optimal_switching", 0.125 + 0.125 * sp.cos(4 * t), (SPRING, t), "right", "decimals"),
    Case("optimal_switching", sp.cos(2 * t) / 4, (SPRING, t), "wrong", "changing its sign"),
    Case("optimal_switching", sp.cos(2 * t) ** 2, (SPRING, t), "wrong", "not normalised"),
    Case("optimal_switching", [1, 2], (SPRING, t), "invalid", "a list"),
    Case("optimal_switching", -(sp.cos(t) ** 2), (LATE, t), "right", "negative"),
    Case("optimal_switching", sp.sin(t) ** 2 - 1, (LATE, t), "right", "by the sine"),
    Case("optimal_switching", sp.cos(t) ** 2, (LATE, t), "wrong", "the sign"),
    Case("optimal_switching", -1, (LATE, t), "wrong", "a constant"),
    Case("optimal_switching", sp.Symbol("psi2"), (LATE, t), "invalid", "a symbol of its own"),
    Case("meeting_time", n * sp.pi / 2, (SPRING, n), "right", "half-turns"),
    Case(
        "meeting_time", 1.5708 * sp.Symbol("n"), (SPRING, n), "right", "a decimal, a plain symbol"
    ),
    Case("meeting_time", sp.pi / 2, (SPRING, n), "wrong", "the first for all"),
    Case(
        "meeting_time", (n + 1) * sp.pi / 2, (SPRING, n), "wrong", "counted from the first return"
    ),
    Case("meeting_time", sp.Eq(n, 1), (SPRING, n), "invalid", "an equation"),
    Case("meeting_time", n * sp.pi, (LATE, n), "right", "half-turns"),
    Case("meeting_time", 3.1416 * n, (LATE, n), "right", "a decimal"),
    Case("meeting_time", n * sp.pi / 2, (LATE, n), "wrong", "the earliest"),
    Case("meeting_time", sp.pi * n**2, (LATE, n), "wrong", "growing too fast"),
    Case("meeting_time", None, (LATE, n), "invalid", "computed but not assigned"),
    Case(
        "transferable_initial_states", sp.Abs(x0) < 1, (RUNAWAY, [x0]), "right", "an open interval"
    ),
    Case("transferable_initial_states", sp.Interval.open(-1, 1), (RUNAWAY, [x0]), "right", "a set"),
    Case(
        "transferable_initial_states",
        sp.And(sp.Abs(x0) < 1, sp.Ne(x0, 0)),
        (RUNAWAY, [x0]),
        "right",
        "the target itself left out",
    ),
    Case("transferable_initial_states", True, (LINE, PARAMETERS), "right", "all of them"),
    Case(
        "transferable_initial_states",
        sp.And(x2 < 0, 2 * x1 >= x2**2),
        (PUSHED, STATE),
        "right",
        "a border that is reached, and one that is not",
    ),
    Case(
        "transferable_initial_states", (x1 + x2) ** 2 < 1, (SADDLE, STATE), "right", "an open strip"
    ),
    Case("transferable_initial_states", sp.Abs(x0) <= 1, (RUNAWAY, [x0]), "wrong", "the border"),
    Case(
        "transferable_initial_states",
        sp.And(x2 < 0, 2 * x1 > x2**2),
        (PUSHED, STATE),
        "wrong",
        "a border left out",
    ),
    Case(
        "transferable_initial_states",
        sp.And(x2 <= 0, 2 * x1 >= x2**2),
        (PUSHED, STATE),
        "wrong",
        "a border too many",
    ),
    Case(
        "transferable_initial_states",
        sp.Abs(x1 + x2) <= 1,
        (SADDLE, STATE),
        "wrong",
        "the border of the strip",
    ),
    Case(
        "transferable_initial_states",
        sp.Abs(x1 + x2) < sp.Rational(99, 100),
        (SADDLE, STATE),
        "wrong",
        "too narrow by a percent",
    ),
    Case(
        "transferable_initial_states",
        sp.Or(sp.Abs(x1 + x2) < 1, sp.Eq(x1, 7)),
        (SADDLE, STATE),
        "wrong",
        "a line too many",
    ),
    Case(
        "transferable_initial_states",
        sp.And(sp.Abs(x1 + x2) < 1, x1 < 1000),
        (SADDLE, STATE),
        "wrong",
        "a strip that ends far out",
    ),
    Case(
        "transferable_initial_states",
        sp.Ne(x1**2 + x2**2, 2),
        (SWING, STATE),
        "wrong",
        "without a circle",
    ),
    Case("transferable_initial_states", sp.Abs(x1) < 1, (SADDLE, STATE), "wrong", "another strip"),
    Case("transferable_initial_states", x1 + x2, (SADDLE, STATE), "invalid", "an expression"),
    Case(
        "reachable_in_time",
        sp.Abs(a - b) <= A * T,
        (LINE, T, PARAMETERS),
        "right",
        "the border counted in",
    ),
    Case(
        "reachable_in_time",
        [b - a <= A * T, a - b <= A * T],
        (LINE, T, PARAMETERS),
        "right",
        "two conditions",
    ),
    Case(
        "reachable_in_time",
        sp.Abs(a - b) < A * T,
        (LINE, T, PARAMETERS),
        "wrong",
        "the border left out",
    ),
    Case(
        "reachable_in_time",
        sp.Abs(a - b) <= T,
        (LINE, T, PARAMETERS),
        "wrong",
        "the bound forgotten",
    ),
    Case(
        "reachable_in_time",
        sp.And(sp.Abs(a - b) <= A * T, T < 10**6),
        (LINE, T, PARAMETERS),
        "wrong",
        "right up to a very long time",
    ),
    Case(
        "reachable_in_time",
        sp.And(sp.Abs(a - b) <= A * T, sp.Ne(a, 1)),
        (LINE, T, PARAMETERS),
        "wrong",
        "without one start",
    ),
    Case("reachable_in_time", A * T, (LINE, T, PARAMETERS), "invalid", "an expression"),
    Case("least_rate", sp.Abs(x) - 1, (sp.Abs(x), RUNAWAY), "right", "by the absolute value"),
    Case(
        "least_rate",
        Piecewise((x - 1, x > 0), (-x - 1, True)),
        (sp.Abs(x), RUNAWAY),
        "right",
        "cases",
    ),
    Case("least_rate", x - 1, (sp.Abs(x), RUNAWAY), "wrong", "for one sign"),
    Case("least_rate", sp.Abs(x) + 1, (sp.Abs(x), RUNAWAY), "wrong", "the greatest"),
    Case("least_rate", x + u, (sp.Abs(x), RUNAWAY), "invalid", "the control left in"),
    Case(
        "polar_angle_rate",
        -u * sp.cos(theta) ** 2 - sp.sin(theta) ** 2,
        (SPRING, theta),
        "right",
        "as it comes",
    ),
    Case(
        "polar_angle_rate",
        -1 - (u - 1) * sp.cos(theta) ** 2,
        (SPRING, theta),
        "right",
        "simplified",
    ),
    Case("polar_angle_rate", -u, (SPRING, theta), "wrong", "no angle"),
    Case(
        "polar_angle_rate",
        u * sp.cos(theta) ** 2 + sp.sin(theta) ** 2,
        (SPRING, theta),
        "wrong",
        "the sign",
    ),
    Case("polar_angle_rate", x1 * x2, (SPRING, theta), "invalid", "the state left in"),
    Case("switching_count", sp.floor(R / 2) + 1, (AT_R, [R]), "right", "growing with the distance"),
    Case(
        "switching_count", sp.ceiling(R / 2), (AT_R, [R]), "right", "the same where R is not even"
    ),
    Case("switching_count", sp.floor(R / 2), (AT_R, [R]), "wrong", "one too few"),
    Case("switching_count", 1, (AT_R, [R]), "wrong", "as for real eigenvalues"),
    Case("switching_count", [1], (AT_R, [R]), "invalid", "a list"),
    Case("switching_count", 1, (MASS,), "right", "real eigenvalues"),
    Case("switching_count", 1.0, (MASS,), "right", "a float"),
    Case("switching_count", 0, (MASS,), "wrong", "one too few"),
    Case("switching_count", 2, (MASS,), "wrong", "one too many"),
    Case("switching_count", 0.5, (MASS,), "invalid", "no whole number"),
    Case("switching_interval", sp.pi, (SWING, STATE), "right", "half a period"),
    Case("switching_interval", 3.14, (SWING, STATE), "right", "three digits"),
    Case("switching_interval", 2 * sp.pi, (SWING, STATE), "wrong", "a period"),
    Case(
        "switching_interval",
        sp.Rational(22, 7),
        (SWING, STATE),
        "wrong",
        "a fraction counts as exact",
    ),
    Case("switching_interval", R, (SWING, STATE), "invalid", "a symbol"),
    Case("isochrone_radius", 2 * n, (SWING, sp.pi * n, n), "right", "circles"),
    Case(
        "isochrone_radius",
        2.0 * sp.Symbol("n"),
        (SWING, sp.pi * n, n),
        "right",
        "a plain symbol, a decimal",
    ),
    Case("isochrone_radius", n, (SWING, sp.pi * n, n), "wrong", "half of it"),
    Case("isochrone_radius", sp.pi * n, (SWING, sp.pi * n, n), "wrong", "the time itself"),
    Case("isochrone_radius", "2n", (SWING, sp.pi * n, n), "invalid", "text"),
]
LIMITS = [
    "Of its own an optimum is known for one state, for the first meeting with a line of a system "
    "homogeneous in two states whose direction turns in one sense, and for a linear plane system "
    "with the origin as the target; of other transfers a control, a motion, a costate and the "
    "time are compared with the best process found.",
    "A control is tried by the motion that it gives, up to the least time: what it says later is "
    "of no account, and values at single instants are not seen.",
    "A motion is compared with the bounds on its rates at 37 instants.",
    "Times, controls and motions with parameters are tried for ten to twenty sets of values; "
    "switchings are counted for forty.",
    "A control or motion that is written with decimals may be off by half a percent, one without "
    "them by a hundred-thousandth.",
]
