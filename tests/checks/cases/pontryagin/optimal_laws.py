import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, x1, x2, u, a, b = sp.symbols("x x1 x2 u a b", real=True)
t, T = sp.symbols("t T", positive=True)
Piecewise, R = sp.Piecewise, sp.Rational

# A point brought close to zero, without and with a price for the control; the carriage to rest at
# the origin, the time being paid and the fuel, or the energy.
NEAR = Problem({x: u}, {u: (-1, 1)}, {x: a}, [], running=x**2 / 2, duration=T)
LINEAR = Problem({x: u}, {u: (-1, 1)}, {x: a}, [], running=(x**2 + u**2) / 2, duration=T)
STARTS = {a: sp.Interval(-3, 3), T: sp.Interval(1, 3)}
FARTHER = {a: sp.Interval(-4, 3), T: sp.Interval(1, 3)}
WISH = -x * sp.tanh(T - t)
PLANE = ({x1: x2, x2: u}, {u: (-1, 1)}, {x1: a, x2: b}, [x1, x2])
FUEL = Problem(*PLANE, running=1 + R(3, 4) * sp.Abs(u))
DEAR_FUEL = Problem(*PLANE, running=1 + R(5, 2) * sp.Abs(u))
ENERGY = Problem(*PLANE, running=1 + u**2 / 2)
WIDE = {a: sp.Interval(-16, 16), b: sp.Interval(-4, 4)}
TURNED, STEEP, ROUND = x2 * sp.Abs(x2), x2**2 * sp.tanh(10**6 * x2), sp.sqrt(x2**2 + R(1, 10**12))
# To the origin at a given moment, without bounds: the gain of the law grows beyond all bounds at
# the end.
MOMENT = Problem({x: u}, {u: None}, {x: a}, [x], running=u**2 + x**2, duration=2)
MOVED = Problem({x1: x2, x2: u}, {u: None}, {x1: a, x2: b}, [x1, x2], running=u**2, duration=2)
NEARER = {a: sp.Interval(-1, 1), b: sp.Interval(-1, 1)}


def fuel(off, on, drive=1):
    """Drive, drift and brake, with the curves x1 = -off x2 |x2| and x1 = -on x2 |x2|."""
    far, near = x1 + off * TURNED, x1 + on * TURNED
    return Piecewise(
        (-drive, sp.And(far > 0, near > 0)), (drive, sp.And(far < 0, near < 0)), (0, True)
    )


def energy(leaves, reaches, constant=R(23, 6)):
    """The law as an equation for u, of the fourth degree between the curves."""
    first, last = x1 + leaves * TURNED, x1 + reaches * TURNED
    between = x1 * (2 - u**2) ** 2 + TURNED * constant + x2**2 * (4 * u - R(2, 3) * u**3)
    return sp.Eq(
        Piecewise(
            (u + 1, sp.And(first > 0, last > 0)),
            (u - 1, sp.And(first < 0, last < 0)),
            (between, True),
        ),
        0,
    )


def smooth(steepness):
    return -(sp.tanh(steepness * (x1 + 2 * TURNED)) + sp.tanh(steepness * (x1 + TURNED / 2))) / 2


def powers(off, on):
    return -(sp.sign(sp.exp(x1) - sp.exp(-off)) + sp.sign(sp.exp(x1 + on) - 1)) / 2


LEFT, REACHED, RANGE = ("bound", "inside"), ("inside", "bound"), {x2: sp.Interval(-4, 4)}

CASES = [
    Case(
        "optimal_law",
        Piecewise((WISH, sp.Abs(WISH) < 1), (sp.sign(WISH), True)),
        (LINEAR, STARTS, t),
        "right",
        "saturated, with time",
    ),
    Case(
        "optimal_law",
        Piecewise((WISH, sp.Abs(WISH) < 1), (sp.sign(WISH), True)),
        (LINEAR, FARTHER, t),
        "right",
        "saturated for a short time only",
    ),
    Case(
        "optimal_law", -sp.sign(x), (NEAR, STARTS), "right", "a sign that holds the motion at zero"
    ),
    Case("optimal_law", fuel(2, R(1, 2)), (FUEL, WIDE), "right", "three values"),
    Case(
        "optimal_law",
        fuel(R(11, 2), R(1, 2)),
        (DEAR_FUEL, WIDE),
        "right",
        "a price that makes late switchings cost much",
    ),
    Case(
        "optimal_law",
        fuel(R(11, 2), R(51, 100)),
        (DEAR_FUEL, WIDE),
        "wrong",
        "there it brakes a little early",
    ),
    Case(
        "optimal_law",
        -(sp.sign(x1 + 2 * TURNED) + sp.sign(x1 + TURNED / 2)) / 2,
        (FUEL, WIDE),
        "right",
        "half the sum of two signs",
    ),
    Case(
        "optimal_law",
        powers(2 * TURNED, TURNED / 2),
        (FUEL, WIDE),
        "right",
        "signs of differences of large powers",
    ),
    Case(
        "optimal_law",
        powers(2 * STEEP, STEEP / 2),
        (FUEL, WIDE),
        "wrong",
        "these with a smooth imitation of a sign",
    ),
    Case("optimal_law", fuel(2.004, 0.5004), (FUEL, WIDE), "right", "three digits"),
    Case("optimal_law", fuel(2.0, 0.502), (FUEL, WIDE), "wrong", "half a per cent of 0.5"),
    Case(
        "optimal_law",
        sp.Eq(u, fuel(2, R(1, 2))),
        (FUEL, WIDE),
        "right",
        "an equation that is solved for u",
    ),
    Case("optimal_law", energy(R(43, 6), R(1, 2)), (ENERGY, WIDE), "right", "an equation"),
    Case(
        "optimal_law", energy(7.17, 0.5, 3.83), (ENERGY, WIDE), "right", "an equation in decimals"
    ),
    Case(
        "optimal_law",
        -x * sp.coth(2 - t),
        (MOMENT, {a: NEARER[a]}, t),
        "right",
        "singular at the end",
    ),
    Case(
        "optimal_law",
        -6 * x1 / (2 - t) ** 2 - 4 * x2 / (2 - t),
        (MOVED, NEARER, t),
        "right",
        "two states, the same",
    ),
    Case(
        "optimal_law",
        -x * sp.tanh(2 - t),
        (MOMENT, {a: NEARER[a]}, t),
        "wrong",
        "the law of a free end",
    ),
    Case(
        "optimal_law",
        -x / (2 - t),
        (MOMENT, {a: NEARER[a]}, t),
        "wrong",
        "the law of the control's price alone",
    ),
    Case("optimal_law", -x, (NEAR, STARTS), "wrong", "beyond the bounds"),
    Case("optimal_law", -sp.sign(x), (LINEAR, STARTS, t), "wrong", "it costs more"),
    Case("optimal_law", fuel(2, R(49, 100)), (FUEL, WIDE), "wrong", "it brakes a little late"),
    Case("optimal_law", fuel(2, R(51, 100)), (FUEL, WIDE), "wrong", "it brakes a little early"),
    Case(
        "optimal_law",
        fuel(R(201, 100), R(1, 2)),
        (FUEL, WIDE),
        "wrong",
        "it drifts half a percent early",
    ),
    Case(
        "optimal_law",
        fuel(R(199, 100), R(1, 2)),
        (FUEL, WIDE),
        "wrong",
        "it drifts half a percent late",
    ),
    Case("optimal_law", fuel(2.1, 0.5), (FUEL, WIDE), "wrong", "decimals five percent off"),
    Case("optimal_law", fuel(2, R(1, 2), -1), (FUEL, WIDE), "wrong", "the sides exchanged"),
    Case("optimal_law", smooth(100), (FUEL, WIDE), "wrong", "a smooth imitation"),
    Case("optimal_law", smooth(10**5), (FUEL, WIDE), "wrong", "a steep imitation"),
    Case(
        "optimal_law",
        -(sp.sign(x1 + 2 * STEEP) + sp.sign(x1 + STEEP / 2)) / 2,
        (FUEL, WIDE),
        "wrong",
        "curves with a smooth imitation of the sign, which differ next to the target alone",
    ),
    Case(
        "optimal_law",
        -(sp.sign(x1 + 2 * x2 * ROUND) + sp.sign(x1 + x2 * ROUND / 2)) / 2,
        (FUEL, WIDE),
        "wrong",
        "curves with a smooth imitation of the modulus",
    ),
    Case(
        "optimal_law",
        Piecewise((fuel(2, R(1, 2)), sp.Abs(x1) < 8), (-sp.sign(x1), True)),
        (FUEL, WIDE),
        "wrong",
        "right in a window, it does not drift far out",
    ),
    Case("optimal_law", -sp.sign(x1 + TURNED / 2), (FUEL, WIDE), "wrong", "the fastest law"),
    Case("optimal_law", energy(7, R(1, 2)), (ENERGY, WIDE), "wrong", "a border two percent off"),
    Case(
        "optimal_law",
        energy(R(43, 6), R(1, 2), R(11, 3)),
        (ENERGY, WIDE),
        "wrong",
        "a constant of the equation",
    ),
    Case(
        "optimal_law",
        fuel(R(43, 6), R(1, 2)),
        (ENERGY, WIDE),
        "wrong",
        "nothing between the curves",
    ),
    Case("optimal_law", sp.Eq(u**3, u), (FUEL, WIDE), "wrong", "an equation with three solutions"),
    Case("optimal_law", [1, 2], (NEAR, STARTS), "invalid", "a list"),
    Case("optimal_law", sp.Eq(x1, x2), (FUEL, WIDE), "invalid", "an equation without the control"),
    Case(
        "arc_transition_curve",
        -2 * TURNED,
        (FUEL, LEFT, RANGE, WIDE),
        "right",
        "both branches in one",
    ),
    Case(
        "arc_transition_curve",
        Piecewise((x2**2 / 2, x2 < 0), (-(x2**2) / 2, True)),
        (FUEL, REACHED, RANGE, WIDE),
        "right",
        "cases",
    ),
    Case(
        "arc_transition_curve",
        -7.17 * TURNED,
        (ENERGY, LEFT, RANGE, WIDE),
        "right",
        "where the control only bends",
    ),
    Case(
        "arc_transition_curve",
        -7.2 * TURNED,
        (ENERGY, LEFT, RANGE, WIDE),
        "wrong",
        "43/6 to two digits",
    ),
    Case(
        "arc_transition_curve",
        -R(201, 100) * TURNED,
        (FUEL, LEFT, RANGE, WIDE),
        "wrong",
        "half a percent off",
    ),
    Case(
        "arc_transition_curve",
        2 * x2**2,
        (FUEL, LEFT, RANGE, WIDE),
        "wrong",
        "one parabola for both sides",
    ),
    Case(
        "arc_transition_curve",
        -2 * STEEP,
        (FUEL, LEFT, RANGE, WIDE),
        "wrong",
        "a smooth imitation of the sign",
    ),
    Case(
        "arc_transition_curve",
        -2 * x2**2 * sp.tanh(20 * x2),
        (FUEL, LEFT, RANGE, WIDE),
        "wrong",
        "one less steep",
    ),
    Case(
        "arc_transition_curve",
        -x2 * ROUND / 2,
        (FUEL, REACHED, RANGE, WIDE),
        "wrong",
        "one of the modulus",
    ),
    Case(
        "arc_transition_curve",
        -2 * sp.sign(x2) * sp.Abs(x2) ** 2.0,
        (FUEL, LEFT, RANGE, WIDE),
        "right",
        "an exponent in decimals",
    ),
    Case(
        "arc_transition_curve",
        -2 * TURNED,
        (FUEL, REACHED, RANGE, WIDE),
        "wrong",
        "the other change",
    ),
    Case(
        "arc_transition_curve", sp.sqrt(-1 - x2**2), (FUEL, LEFT, RANGE, WIDE), "wrong", "not real"
    ),
    Case(
        "arc_transition_curve", sp.Eq(x1, x2), (FUEL, LEFT, RANGE, WIDE), "invalid", "an equation"
    ),
]

LIMITS = [
    "One control. The optimum is the best process found; where several processes are best from "
    "one start, a law has to do what the one found does.",
    "A law is compared with the best processes from six starts, or as many as a finite set of "
    "them holds; then it is followed in small steps, in each of which the control is constant.",
    "A law that is written as an equation needs a control with bounds.",
]
