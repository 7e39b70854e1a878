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
ENERGY = Problem(
    {x1: x2, x2: u - x1},
    {u: (None, None)},
    {x1: 0, x2: 0},
    [x1 - a],
    running=u**2,
    duration=sp.pi / 2,
)
PLACES = {a: sp.Interval(-3, 3)}
FAR = Problem(
    {x1: x2, x2: u},
    {u: (-1, 1)},
    {x1: 0, x2: None},
    [x1 - 1],
    final=x1**2 / 2 + x2**2 / 2,
    duration=1,
    maximise=True,
)
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

TINY = Problem({x: u}, {u: (-1, 1)}, {x: sp.Rational(1, 2)}, [], running=x**2 / 10**6, duration=1)
NOTHING = Problem({x: u}, {u: (-1, 1)}, {x: 0}, [x], running=x**2, final=1000, duration=1)


# An oscillator at rest is driven as far as it goes before it first stops; not moving is no process.
OUT_OF_REST = Problem(
    {x1: x2, x2: u - x1},
    {u: (-2, 2)},
    {x1: 0, x2: 0},
    [x2],
    final=x1,
    maximise=True,
    first_return=True,
)

# From any state; on the curve on which the braking begins no other arc is left.
b = sp.Symbol("b", real=True)
DEAR = Problem(
    {x1: x2, x2: u},
    {u: (-1, 1)},
    {x1: a, x2: b},
    [x1, x2],
    running=1 + sp.Rational(5, 4) * sp.Abs(u),
)
STATES = {a: sp.Interval(-16, 16), b: sp.Interval(-4, 4)}


def dear(price):
    side = sp.sign(a + (2 * price + sp.Rational(1, 2)) * b * sp.Abs(b))
    driven = (1 + price) * side * b + 2 * sp.sqrt((1 + 2 * price) * (side * a + b**2 / 2))
    drifts = side * (a + b * sp.Abs(b) / 2) < 0
    return Piecewise(
        (sp.Abs(a / b) + (price + sp.Rational(1, 2)) * sp.Abs(b), drifts), (driven, True)
    )


CASES = [
    Case("optimal_duration", sp.pi, (OUT_OF_REST,), "right", "it leaves its rest at once"),
    Case("optimal_duration", 3 * sp.pi, (OUT_OF_REST,), "wrong", "a later return"),
    Case("optimal_cost", dear(sp.Rational(5, 4)), (DEAR, STATES), "right", "three formulas"),
    Case("optimal_cost", dear(sp.Rational(6, 5)), (DEAR, STATES), "wrong", "another price"),
    Case("optimal_cost", sp.Rational(1, 24 * 10**6), (TINY,), "right", "a small unit"),
    Case("optimal_cost", sp.Rational(1, 23 * 10**6), (TINY,), "wrong", "a small unit"),
    Case("optimal_cost", 1000, (NOTHING,), "right", "zero and a constant"),
    Case(
        "optimal_cost",
        1000 + sp.Rational(1, 10**4),
        (NOTHING,),
        "wrong",
        "small beside the constant, and too much",
    ),
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
    Case("optimal_cost", 1.27 * a**2, (ENERGY, PLACES), "right", "4/pi to three digits"),
    Case("optimal_cost", 1.28 * a**2, (ENERGY, PLACES), "wrong", "half a per cent off"),
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
    "`optimal_duration`, `initial_arc_duration` with several controls: the best process found among "
    "those whose controls are constant on a few arcs, from a given start in least time."
]
