import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, v, u, t, b, k, c, T = sp.symbols("x v u t b k c T", real=True)

# A point pushed by a force that falls with time, and a speed that is turned by its control.
PUSHED = Problem({x: v, v: u}, {u: None}, {x: 0, v: k}, [v], final=x, duration=T)
FALLING = b - c * t
PUSHES = {
    b: sp.Interval(1, 2),
    c: sp.Interval(sp.Rational(1, 2), 1),
    k: sp.Interval(-1, 1),
    T: sp.Interval(1, 2),
}
IN_TIME = [k * t + b * t**2 / 2 - c * t**3 / 6, k + b * t - c * t**2 / 2]
BY_PUSH = [part.subs(t, (b - u) / c) for part in IN_TIME]
BACK = {b: sp.Interval(1, 2), k: sp.Interval(0, 1), T: sp.Interval(1, 2)}
SLOPE = 2 * (b * T + k) / T**2
STOPS = (PUSHED, FALLING, t, {c: sp.Interval(0, 20)}, BACK)
# To rest at a given place: the slope and the duration are sought.
THERE = Problem({x: v, v: u}, {u: None}, {x: 0, v: 0}, [v, x - k], final=x, duration=T)
SOUGHT = {c: sp.Interval(0, 10), T: sp.Interval(sp.Rational(1, 2), 6)}
PLACES = {b: sp.Interval(1, 2), k: sp.Interval(1, 2)}

CASES = [
    Case("motion_under_law", IN_TIME, (PUSHED, FALLING, t, PUSHES), "right", "in time"),
    Case(
        "motion_under_law",
        BY_PUSH,
        (PUSHED, FALLING, t, PUSHES),
        "right",
        "in the control",
        (("by", u),),
    ),
    Case(
        "motion_under_law",
        [k * t + t**2 * (0.5 * b - 0.1667 * c * t), k + b * t - c * t**2 / 2],
        (PUSHED, FALLING, t, PUSHES),
        "right",
        "decimals",
    ),
    Case(
        "motion_under_law",
        [b * t**2 / 2 - c * t**3 / 6, b * t - c * t**2 / 2],
        (PUSHED, FALLING, t, PUSHES),
        "wrong",
        "from rest",
    ),
    Case(
        "motion_under_law",
        [k * t + b * t**2 / 2, k + b * t],
        (PUSHED, FALLING, t, PUSHES),
        "wrong",
        "under a constant push",
    ),
    Case(
        "motion_under_law",
        IN_TIME[::-1],
        (PUSHED, FALLING, t, PUSHES),
        "wrong",
        "the states changed",
    ),
    Case(
        "motion_under_law",
        IN_TIME,
        (PUSHED, FALLING, t, PUSHES),
        "invalid",
        "in time, asked in the control",
        (("by", u),),
    ),
    Case(
        "motion_under_law",
        IN_TIME[:1],
        (PUSHED, FALLING, t, PUSHES),
        "invalid",
        "one of two states",
    ),
    Case(
        "final_value_under_law",
        SLOPE,
        (c, *STOPS),
        "right",
        "the slope with which the point stops in time",
    ),
    Case(
        "final_value_under_law",
        k * T + b * T**2 / 2 - SLOPE * T**3 / 6,
        (x, *STOPS),
        "right",
        "where it stops then",
    ),
    Case(
        "final_value_under_law",
        sp.sqrt(6 * k / b),
        (T, THERE, FALLING, t, SOUGHT, PLACES),
        "right",
        "a duration, one of two unknowns",
    ),
    Case(
        "final_value_under_law",
        2.449 * sp.sqrt(k / b),
        (T, THERE, FALLING, t, SOUGHT, PLACES),
        "right",
        "decimals",
    ),
    Case(
        "final_value_under_law",
        b / T,
        (c, *STOPS),
        "wrong",
        "the push ends with zero, not the speed",
    ),
    Case(
        "final_value_under_law", 2 * b / T, (c, *STOPS), "wrong", "without the speed at the start"
    ),
    Case(
        "final_value_under_law",
        sp.sqrt(2 * k / b),
        (T, THERE, FALLING, t, SOUGHT, PLACES),
        "wrong",
        "it does not stop",
    ),
    Case("final_value_under_law", c * T, (c, *STOPS), "invalid", "in the unknown itself"),
]

LIMITS = [
    "One control, and a law that is continuous in time; the unknown constants have to be "
    "determined by the conditions at the end."
]
