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
# The same in a unit of cost that makes it small, and a least cost that is zero.
SMALL = Problem({x: u}, {u: (-1, 1)}, {x: sp.Rational(1, 2)}, [], running=x**2 / 10**6, duration=1)
NOTHING = Problem({x: u}, {u: (-1, 1)}, {x: 0}, [x], running=x**2, duration=1)
NO_BOUNDS = Problem({x: u}, {u: (None, None)}, {x: 0}, [x - 1], running=u**2, duration=1)
n = sp.Symbol("n", integer=True)


CASES = [
    Case(
        "optimal_control",
        [[high, sp.Rational(1001, 1000) * sp.pi / (2 * sp.sqrt(high))], [low, 10]],
        (SWING, t, STIFF),
        "wrong",
        "it switches a thousandth too late, which costs a millionth",
    ),
    Case(
        "optimal_control",
        [[-1, sp.Rational(1, 2)], [0, 1]],
        (SMALL, t),
        "right",
        "a cost in a small unit",
    ),
    Case(
        "optimal_control",
        [[-1, sp.Rational(1, 2)], [0.1, 1]],
        (SMALL, t),
        "wrong",
        "a cost in a small unit, and a control past zero",
    ),
    Case("optimal_control", 0, (NOTHING, t), "right", "a least cost of zero"),
    Case("optimal_control", 1e-4, (NOTHING, t), "wrong", "a least cost of zero, and a small one"),
    Case("optimal_control", 1e160, (NO_BOUNDS, t), "wrong", "beyond what floats can square"),
    Case(
        "optimal_control",
        sp.Sum(t**n / sp.factorial(n), (n, 0, 50)),
        (NO_BOUNDS, t),
        "invalid",
        "a sum that is not worked out",
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
    Case("optimal_control", 1, (FAR, t), "right", "a maximum, with a free initial state"),
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
    Case(
        "optimal_control",
        high + (low - high) * (1 + sp.tanh(1000 * (t - TURN))) / 2,
        (SWING, t, STIFF),
        "wrong",
        "it goes over by and by",
    ),
]
LIMITS = [
    "One control. The optimum is the best process found: a proof only where the problem is convex."
]
