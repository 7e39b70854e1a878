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
NEAR = Problem({x: u}, {u: (-1, 1)}, {x: a}, [], running=x**2 / 2, duration=T)
STARTS = {a: sp.Interval(-3, 3), T: sp.Interval(1, 3)}
FAR = Problem(
    {x1: x2, x2: u},
    {u: (-1, 1)},
    {x1: 0, x2: None},
    [x1 - 1],
    final=x1**2 / 2 + x2**2 / 2,
    duration=1,
    maximise=True,
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


CASES = [
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
    *(
        Case(
            "optimal_motion",
            SWUNG.func((SWUNG.args[0][0], t < factor * TURN), SWUNG.args[1]),
            (SWING, t, STIFF),
            "wrong",
            f"the change at {factor} of its time, with a jump that is smaller than a sample's step",
        )
        for factor in (sp.Rational(101, 100), sp.Rational(1001, 1000), 1.01)
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
        "both states, the initial state free",
    ),
    Case(
        "optimal_motion",
        BENT,
        (FALL, t, LONG),
        "right",
        "the equations are not linear in the control",
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
]
LIMITS = []
