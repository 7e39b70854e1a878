import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, x1, x2, u, a = sp.symbols("x x1 x2 u a", real=True)
t, T, low, high = sp.symbols("t T u_min u_max", positive=True)
Piecewise = sp.Piecewise

ENERGY = Problem(
    {x1: x2, x2: u - x1},
    {u: (None, None)},
    {x1: 0, x2: 0},
    [x1 - a],
    running=u**2,
    duration=sp.pi / 2,
)
#: The best process stays at zero, and so does its costate.
STANDING = Problem({x: u}, {u: (-1000, 1000)}, {x: 0}, running=10**6 * x**2, duration=1)
PLACES = {a: sp.Interval(-3, 3)}
NEAR = Problem({x: u}, {u: (-1, 1)}, {x: a}, [], running=x**2 / 2, duration=T)
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


LOW, HIGH = sp.symbols("u_min u_max", positive=True)
SWING = Problem(
    {x1: x2, x2: -u * x1}, {u: (LOW, HIGH)}, {x1: 1, x2: 0}, [x2], final=x1, first_return=True
)
STIFF = {LOW: sp.Interval(sp.Rational(1, 2), 1), HIGH: sp.Interval(2, 4)}


def _swung(factor):
    """Return the costates of the swing, with the change of their formulas at a factor of its time."""
    fast, slow, farthest = sp.sqrt(HIGH), sp.sqrt(LOW), sp.sqrt(HIGH / LOW)
    turn = sp.pi / (2 * fast)
    early = [farthest * sp.cos(fast * t), -farthest * sp.sin(fast * t) / fast]
    late = [-sp.sin(slow * (t - turn)), -sp.cos(slow * (t - turn)) / slow]
    return [Piecewise((a, t < factor * turn), (b, True)) for a, b in zip(early, late)]


def _first_stop(start, bound):
    """Return the costates of a swing pushed by at most a force, to its first stop, and the problem."""
    problem = Problem(
        {x1: x2, x2: u - x1},
        {u: (-bound, bound)},
        {x1: start, x2: 0},
        [x2],
        final=-(x1**2 + x2**2) / 2,
        first_return=True,
    )
    size = start + 2 * bound
    return [size * sp.cos(t), -size * sp.sin(t)], problem


PUSHED, PUSH = _first_stop(5, sp.Rational(9, 2))
STRONGLY_PUSHED, STRONG_PUSH = _first_stop(8, 7)


CASES = [
    Case("optimal_costate", PUSHED, (PUSH, t), "right", "a first arc of no length in the search"),
    Case("optimal_costate", STRONGLY_PUSHED, (STRONG_PUSH, t), "right", "fast at the end"),
    Case("optimal_costate", [psi / 2 for psi in PUSHED], (PUSH, t), "wrong", "half of them"),
    Case("optimal_costate", 0, (STANDING, t), "right", "zero all the time"),
    Case("optimal_costate", (1 - t) / 100, (STANDING, t), "wrong", "small, where it is zero"),
    Case("optimal_costate", _swung(1), (SWING, t, STIFF), "right", "two arcs"),
    Case(
        "optimal_costate",
        _swung(sp.Rational(1001, 1000)),
        (SWING, t, STIFF),
        "wrong",
        "they jump where their formula changes, between two samples",
    ),
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
]
LIMITS = []
