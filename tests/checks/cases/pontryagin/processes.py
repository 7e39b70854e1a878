import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, x1, x2, u, a = sp.symbols("x x1 x2 u a", real=True)
t, T, low, high = sp.symbols("t T u_min u_max", positive=True)
Piecewise = sp.Piecewise

# A spring of variable stiffness, swung far; the least energy to a place; a point brought close to
# zero.
SWING = Problem(
    {x1: x2, x2: -u * x1}, {u: (low, high)}, {x1: 1, x2: 0}, [x2], final=x1, first_return=True
)
STIFF = {low: sp.Interval(sp.Rational(1, 2), 1), high: sp.Interval(2, 4)}
TURN = sp.pi / (2 * sp.sqrt(high))
SWUNG = Piecewise(
    (sp.cos(sp.sqrt(high) * t), t < TURN),
    (-sp.sqrt(high / low) * sp.sin(sp.sqrt(low) * (t - TURN)), True),
)
ENERGY = Problem(
    {x1: x2, x2: u - x1},
    {u: (None, None)},
    {x1: 0, x2: 0},
    [x1 - a],
    running=u**2,
    duration=sp.pi / 2,
)
PLACES = {a: sp.Interval(-3, 3)}
PUSH = 4 * a / sp.pi * sp.cos(t)
NEAR = Problem({x: u}, {u: (-1, 1)}, {x: a}, [], running=x**2 / 2, duration=T)
STARTS = {a: sp.Interval(-3, 3), T: sp.Interval(1, 3)}
HELD = Piecewise((-sp.sign(a), t < sp.Abs(a)), (0, True))
FAR = Problem(
    {x1: x2, x2: u},
    {u: (-1, 1)},
    {x1: 0, x2: None},
    [x1 - 1],
    final=x1**2 / 2 + x2**2 / 2,
    duration=1,
    maximise=True,
)
BEAM = Problem(
    {x1: x2, x2: u}, {u: (None, None)}, {x1: 0, x2: 0}, [], running=u**2 - 48 * x1, duration=1
)
# A fall from rest along the path that comes farthest: the control enters by its sine and cosine.
FALL = Problem(
    {x1: x2 * sp.cos(u), x2: -sp.sin(u)},
    {u: (-sp.pi / 2, sp.pi / 2)},
    {x1: 0, x2: 0},
    final=x1,
    duration=T,
    maximise=True,
)
LONG = {T: sp.Interval(1, 3)}
# A ship in a current, on any heading.
STREAM = Problem(
    {x1: sp.cos(u) + sp.Rational(1, 2), x2: sp.sin(u)},
    {u: (None, None)},
    {x1: 0, x2: 0},
    [x1 - 1, x2 - 2],
)
BENT = (
    T**2 / sp.pi**2 * (sp.pi * t / T - sp.sin(sp.pi * t / T)),
    2 * T / sp.pi * sp.sin(sp.pi * t / (2 * T)),
)
SLIDE = t**2 / 4, t / sp.sqrt(2)
# The fastest way under a heading where the speed grows with the height: circles.
theta, y = sp.symbols("theta y", real=True)
CLIMB = Problem(
    {x: (1 + y) * sp.cos(theta), y: (1 + y) * sp.sin(theta)},
    {theta: (None, None)},
    {x: -2 * a, y: 0},
    [x, y],
)
WIDE = {a: sp.Interval(sp.Rational(1, 2), 2)}

# A robot with two controls, which turns on the spot and then runs straight to a place on a line
# behind it.
v, w, y1, y2, q, bound = (*sp.symbols("v w y1 y2 q", real=True), sp.Symbol("vbar", positive=True))
ROBOT = Problem(
    {y1: v * sp.cos(q), y2: v * sp.sin(q), q: w},
    {v: (0, bound), w: (-1, 1)},
    {y1: 0, y2: 0, q: 0},
    [y1 + a * bound, y2 - 2 * bound],
)
BEHIND = {a: sp.Interval(1, 3), bound: sp.Interval(1, 2)}
SPOT = sp.pi - sp.atan(2 / a) - sp.acos(1 / sp.sqrt(a**2 + 4))
# The same on both sides, where it need not turn on the spot at all; and the carriage at least cost,
# from rest.
AROUND = BEHIND | {a: sp.Interval(-3, 3)}
SMALL, TURNED = sp.Rational(1, 10**4), sp.atan2(2, -a) - sp.acos(1 / sp.sqrt(a**2 + 4))
AWAY = {a: sp.Interval(-6, 6)}
IN_POWERS = sp.log(2 * sp.exp(sp.sqrt(10 * sp.Abs(a))))
CARRIAGE = Problem(
    {x1: x2, x2: u},
    {u: (-1, 1)},
    {x1: a, x2: 0},
    [x1, x2],
    running=1 + sp.Rational(3, 4) * sp.Abs(u),
)

CASES = [
    Case("initial_arc_duration", SPOT, (ROBOT, v, 0, BEHIND), "right", "a turn on the spot"),
    Case(
        "initial_arc_duration",
        0,
        (ROBOT, v, bound, BEHIND),
        "right",
        "it does not begin with the other bound",
    ),
    Case(
        "initial_arc_duration",
        sp.pi - sp.atan(2 / a),
        (ROBOT, v, 0, BEHIND),
        "wrong",
        "until it looks at the target",
    ),
    Case("initial_arc_duration", 0, (ROBOT, v, 0, BEHIND), "wrong", "not at all"),
    Case(
        "initial_arc_duration",
        sp.Max(TURNED, 0),
        (ROBOT, v, 0, AROUND),
        "right",
        "at some places alone",
    ),
    Case(
        "initial_arc_duration",
        (TURNED + sp.Abs(TURNED)) / 2,
        (ROBOT, v, 0, AROUND),
        "right",
        "by a modulus",
    ),
    Case(
        "initial_arc_duration",
        sp.Max(sp.N(TURNED, 4), 0),
        (ROBOT, v, 0, AROUND),
        "right",
        "in decimals",
    ),
    Case(
        "initial_arc_duration",
        (TURNED + sp.sqrt(TURNED**2 + sp.Rational(1, 10**9))) / 2,
        (ROBOT, v, 0, AROUND),
        "wrong",
        "the corner made smooth by a root",
    ),
    Case(
        "initial_arc_duration",
        TURNED * (1 + sp.tanh(10**4 * TURNED)) / 2,
        (ROBOT, v, 0, AROUND),
        "wrong",
        "by a tanh",
    ),
    Case(
        "initial_arc_duration",
        Piecewise(
            (0, TURNED < -SMALL),
            ((TURNED + SMALL) ** 2 / (4 * SMALL), TURNED < SMALL),
            (TURNED, True),
        ),
        (ROBOT, v, 0, AROUND),
        "wrong",
        "by a parabola",
    ),
    Case("initial_arc_duration", q, (ROBOT, v, 0, BEHIND), "invalid", "in the state"),
    Case(
        "optimal_duration",
        SPOT + sp.pi / 2 + sp.sqrt(a**2 + 3) - 1,
        (ROBOT, BEHIND),
        "right",
        "two controls",
    ),
    Case(
        "optimal_duration",
        SPOT + sp.pi / 2 + sp.sqrt(a**2 + 3),
        (ROBOT, BEHIND),
        "wrong",
        "two controls",
    ),
    Case(
        "optimal_control",
        Piecewise((high, t < TURN), (low, True)),
        (SWING, t, STIFF),
        "right",
        "two arcs, cases",
    ),
    Case(
        "optimal_control",
        [[high, TURN], [low, TURN + sp.pi / (2 * sp.sqrt(low))]],
        (SWING, t, STIFF),
        "right",
        "a list of arcs",
    ),
    Case("optimal_control", PUSH, (ENERGY, t, PLACES), "right", "inside, without bounds"),
    Case("optimal_control", 1.2732 * a * sp.cos(t), (ENERGY, t, PLACES), "right", "decimals"),
    Case(
        "optimal_control",
        1.286 * a * sp.cos(t),
        (ENERGY, t, PLACES),
        "wrong",
        "one per cent too strong",
    ),
    Case(
        "optimal_control",
        Piecewise((high, t < 1.571 / sp.sqrt(high)), (low, True)),
        (SWING, t, STIFF),
        "right",
        "a switching in decimals, where the stiffness acts on nothing",
    ),
    Case(
        "optimal_control",
        Piecewise((high, t < 1.587 / sp.sqrt(high)), (low, True)),
        (SWING, t, STIFF),
        "wrong",
        "the same, one per cent late",
    ),
    Case("optimal_control", HELD, (NEAR, t, STARTS), "right", "a bound, then a singular arc"),
    Case("optimal_control", 1, (FAR, t), "right", "a maximum, with a free beginning"),
    Case(
        "optimal_control",
        Piecewise((low, t < TURN), (high, True)),
        (SWING, t, STIFF),
        "wrong",
        "the arcs changed",
    ),
    Case("optimal_control", high, (SWING, t, STIFF), "wrong", "it meets the target too early"),
    Case(
        "optimal_control",
        a,
        (ENERGY, t, PLACES),
        "wrong",
        "it keeps to the ends, and another one costs less",
    ),
    Case(
        "optimal_control",
        1.1 * PUSH,
        (ENERGY, t, PLACES),
        "wrong",
        "too strong, it misses the target",
    ),
    Case("optimal_control", -2 * sp.sign(a), (NEAR, t, STARTS), "wrong", "beyond the bounds"),
    Case("optimal_control", -sp.sign(a), (NEAR, t, STARTS), "wrong", "past zero"),
    Case("optimal_control", -1, (FAR, t), "wrong", "the other bound"),
    Case("optimal_control", x, (NEAR, t, STARTS), "invalid", "a law in the state"),
    Case("optimal_motion", SWUNG, (SWING, t, STIFF), "right", "the first state, two arcs"),
    Case(
        "optimal_motion",
        2 * a / sp.pi * t * sp.sin(t),
        (ENERGY, t, PLACES),
        "right",
        "without bounds",
    ),
    Case("optimal_motion", 0.637 * a * t * sp.sin(t), (ENERGY, t, PLACES), "right", "in decimals"),
    Case(
        "optimal_motion",
        0.644 * a * t * sp.sin(t),
        (ENERGY, t, PLACES),
        "wrong",
        "one per cent too far",
    ),
    Case(
        "optimal_motion",
        SWUNG.xreplace({TURN: 1.57 / sp.sqrt(high)}),
        (SWING, t, STIFF),
        "right",
        "a change in decimals, where it jumps a little",
    ),
    Case(
        "optimal_motion",
        [a + Piecewise((-sp.sign(a) * t, t < sp.Abs(a)), (-a, True))],
        (NEAR, t, STARTS),
        "right",
        "one state in a list",
    ),
    Case(
        "optimal_motion",
        [t / 2 + t**2 / 2, t + 0.5],
        (FAR, t),
        "right",
        "both states, the beginning free",
    ),
    Case(
        "optimal_motion",
        BENT,
        (FALL, t, LONG),
        "right",
        "the equations are not linear in the control",
    ),
    Case(
        "optimal_control",
        high + (low - high) * (1 + sp.tanh(1000 * (t - TURN))) / 2,
        (SWING, t, STIFF),
        "wrong",
        "it goes over by and by",
    ),
    Case("optimal_motion", SLIDE, (FALL, t, LONG), "wrong", "a possible motion, not the best"),
    Case(
        "optimal_motion", (BENT[0], t), (FALL, t, LONG), "wrong", "possible rates, but not together"
    ),
    Case("optimal_motion", (2 * t, t), (FALL, t, LONG), "wrong", "faster than the speed"),
    Case(
        "optimal_motion", (t / 2, t), (STREAM, t), "right", "an angle without bounds, the time free"
    ),
    Case(
        "optimal_motion",
        (t**2 / 4, t),
        (STREAM, t),
        "wrong",
        "the right ends and time, but faster than the ship",
    ),
    Case(
        "optimal_motion", sp.cos(sp.sqrt(high) * t), (SWING, t, STIFF), "wrong", "one arc for both"
    ),
    Case("optimal_motion", a * sp.sin(t), (ENERGY, t, PLACES), "wrong", "another start"),
    Case(
        "optimal_motion",
        a * (1 - sp.cos(t)),
        (ENERGY, t, PLACES),
        "wrong",
        "another control, with the same ends",
    ),
    Case("optimal_motion", [t, 1 + t], (FAR, t), "wrong", "the second state is not the derivative"),
    Case("optimal_motion", [t, 1, 0], (FAR, t), "invalid", "three states of two"),
    Case("optimal_cost", -sp.sqrt(high / low), (SWING, STIFF), "right", "with parameters"),
    Case(
        "optimal_cost",
        -((high / low) ** 0.5),
        (SWING, STIFF),
        "right",
        "a root as a decimal that leaves nothing open",
    ),
    Case("optimal_cost", 4 * a**2 / sp.pi, (ENERGY, PLACES), "right", "an integral"),
    Case("optimal_cost", 1.625, (FAR,), "right", "a maximum, a number"),
    Case("optimal_cost", sp.sqrt(high / low), (SWING, STIFF), "wrong", "the sign"),
    Case("optimal_cost", a**2 * sp.pi / 2, (ENERGY, PLACES), "wrong", "of a constant control"),
    Case("optimal_cost", 1, (FAR,), "wrong", "without the velocity"),
    Case("optimal_cost", sp.sqrt(10 * sp.Abs(a)), (CARRIAGE, AWAY), "right", "from both sides"),
    Case(
        "optimal_cost",
        3.162 * sp.Abs(a) ** 0.5,
        (CARRIAGE, AWAY),
        "right",
        "an exponent in decimals",
    ),
    Case(
        "optimal_cost",
        sp.sqrt(10 * sp.Abs(a)) * sp.gamma(2 + a) / (1 + a) / sp.gamma(1 + a),
        (CARRIAGE, AWAY),
        "right",
        "a function that NumPy does not know",
    ),
    Case(
        "optimal_cost",
        sp.sqrt(10 * a * sp.tanh(1000 * a)),
        (CARRIAGE, AWAY),
        "wrong",
        "a smooth imitation",
    ),
    Case(
        "optimal_cost",
        sp.sqrt(10 * sp.sqrt(a**2 + SMALL**3)),
        (CARRIAGE, AWAY),
        "wrong",
        "its corner made smooth",
    ),
    Case(
        "optimal_cost",
        IN_POWERS - sp.log(2),
        (CARRIAGE, AWAY),
        "right",
        "powers for which floats have no room",
    ),
    Case(
        "optimal_cost",
        sp.acosh(sp.cosh(sp.sqrt(10 * sp.Abs(a)))),
        (CARRIAGE, AWAY),
        "right",
        "cosines, all alike",
    ),
    Case(
        "optimal_cost",
        sp.log(2 * sp.exp(sp.sqrt(10 * sp.Abs(a))) + SMALL**2) - sp.log(2),
        (CARRIAGE, AWAY),
        "wrong",
        "more than such powers",
    ),
    Case(
        "optimal_cost",
        IN_POWERS - sp.Piecewise((sp.log(2), sp.Abs(a) < 1000), (0, True)),
        (CARRIAGE, AWAY),
        "wrong",
        "another number far out, where floats have no room",
    ),
    Case(
        "optimal_cost",
        sp.Piecewise((sp.sqrt(10 * sp.Abs(a)), sp.Abs(a) < 1000)),
        (CARRIAGE, AWAY),
        "wrong",
        "no number far out",
    ),
    Case("optimal_cost", sp.Eq(x, 1), (FAR,), "invalid", "an equation"),
    Case(
        "optimal_duration",
        sp.pi / 2 * (1 / sp.sqrt(low) + 1 / sp.sqrt(high)),
        (SWING, STIFF),
        "right",
        "two arcs",
    ),
    Case(
        "optimal_duration", 1.5708 * (low**-0.5 + high**-0.5), (SWING, STIFF), "right", "decimals"
    ),
    Case("optimal_duration", sp.pi / sp.sqrt(low), (SWING, STIFF), "wrong", "of the soft spring"),
    Case(
        "optimal_duration",
        sp.sqrt(sp.Abs(a) * sp.Rational(49, 10)),
        (CARRIAGE, AWAY),
        "right",
        "from both sides",
    ),
    Case(
        "optimal_duration",
        sp.sqrt(4.9 * sp.sqrt(a**2 + SMALL**3)),
        (CARRIAGE, AWAY),
        "wrong",
        "its corner smooth",
    ),
    Case("optimal_duration", 2 * TURN, (SWING, STIFF), "wrong", "of the stiff spring"),
    Case("optimal_duration", "pi", (SWING, STIFF), "invalid", "text"),
    Case(
        "optimal_costate",
        [8 * a / sp.pi * sp.sin(t), 8 * a / sp.pi * sp.cos(t)],
        (ENERGY, t, PLACES),
        "right",
        "the control inside",
    ),
    Case(
        "optimal_costate",
        Piecewise((-sp.sign(a) * (sp.Abs(a) - t) ** 2 / 2, t < sp.Abs(a)), (0, True)),
        (NEAR, t, {a: sp.Interval(sp.Rational(-1, 2), sp.Rational(1, 2)), T: sp.Interval(1, 3)}),
        "right",
        "zero on the singular arc; one expression for one state",
    ),
    Case(
        "optimal_costate",
        [48 * (1 - t), 24 * (1 - t) ** 2],
        (BEAM, t),
        "right",
        "both vanish at a free end",
    ),
    Case(
        "optimal_costate",
        [0, sp.Rational(3, 2)],
        (FAR, t),
        "wrong",
        "the adjoint equation holds, the end does not",
    ),
    Case(
        "optimal_costate",
        [-8 * a / sp.pi * sp.sin(t), -8 * a / sp.pi * sp.cos(t)],
        (ENERGY, t, PLACES),
        "wrong",
        "the sign",
    ),
    Case(
        "optimal_costate",
        [2.546 * a * sp.sin(t), 2.546 * a * sp.cos(t)],
        (ENERGY, t, PLACES),
        "right",
        "decimals",
    ),
    Case(
        "optimal_costate",
        [2.572 * a * sp.sin(t), 2.572 * a * sp.cos(t)],
        (ENERGY, t, PLACES),
        "wrong",
        "one per cent too large",
    ),
    Case(
        "optimal_costate", [sp.sin(t), sp.cos(t)], (ENERGY, t, PLACES), "wrong", "another multiple"
    ),
    Case("optimal_costate", [sp.sin(t)], (ENERGY, t, PLACES), "invalid", "one of two"),
    Case("optimal_range", sp.sqrt(1 + a**2) - 1, (CLIMB, y, WIDE), "right", "how high a way leads"),
    Case("optimal_range", 2 * a, (CLIMB, x, WIDE), "right", "between the ends"),
    Case("optimal_range", 3, (FAR, x1 + 2 * x2), "right", "a quantity of two states"),
    Case(
        "optimal_range",
        sp.sqrt(1 + a**2),
        (CLIMB, y, WIDE),
        "wrong",
        "the greatest value of another quantity",
    ),
    Case("optimal_range", a / 2, (CLIMB, y, WIDE), "wrong", "half the way"),
    Case("optimal_range", 0, (CLIMB, y, WIDE), "wrong", "along the straight way"),
    Case("optimal_range", y, (CLIMB, y, WIDE), "invalid", "the quantity itself"),
]

LIMITS = [
    "One control. The optimum is the best process found: a proof only where the problem is convex.",
    "`optimal_duration`, `initial_arc_duration` with several controls: the best process found among "
    "those whose controls are constant on a few arcs, from a given start in least time.",
]
