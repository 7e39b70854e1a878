import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, y, u = sp.symbols("x y u", real=True)
t, T = sp.symbols("t T", positive=True)

# A thrust of free direction: to the origin, and to rest there.
v, w, x0, y0, v0 = sp.symbols("v w x0 y0 v0", real=True)
THRUST = {x: v, y: w, v: sp.cos(u), w: sp.sin(u)}
START = {x0: sp.Interval(1, 2), y0: sp.Interval(-1, 1), v0: sp.Interval(-1, 1)}
MEET = Problem(THRUST, {u: None}, {x: x0, y: y0, v: v0, w: 0}, [x, y])
QUARTIC = (x0 + v0 * T) ** 2 + y0**2 - T**4 / 4
REST = {x0: sp.Interval(1, 2), y0: sp.Interval(-2, 2)}
STOP = Problem(THRUST, {u: None}, {x: x0, y: y0, v: 0, w: 0}, [x, y, v, w])
HALFWAY = (x0**2 + y0**2) ** sp.Rational(1, 4)
BACK = sp.atan2(-y0, -x0)

CASES = [
    Case("duration_equation", sp.Eq(QUARTIC, 0), (MEET, T, START), "right", "an equation"),
    Case(
        "duration_equation",
        3 * sp.sqrt((x0 + v0 * T) ** 2 + y0**2) - 1.5 * T**2,
        (MEET, T, START),
        "right",
        "an expression, decimals",
    ),
    Case(
        "duration_equation",
        3.004 * sp.sqrt((x0 + v0 * T) ** 2 + y0**2) - 1.5 * T**2,
        (MEET, T, START),
        "right",
        "three digits",
    ),
    Case(
        "duration_equation",
        3 * sp.sqrt((x0 + v0 * T) ** 2 + y0**2) - 1.51 * T**2,
        (MEET, T, START),
        "wrong",
        "two digits",
    ),
    Case("duration_equation", QUARTIC + T, (MEET, T, START), "wrong", "another root"),
    Case(
        "duration_equation",
        (T - sp.Rational(1, 2)) * QUARTIC,
        (MEET, T, START),
        "wrong",
        "a shorter root besides",
    ),
    Case("duration_equation", sp.Eq(x0, 1), (MEET, T, START), "invalid", "no duration in it"),
    Case("optimal_duration", 2 * HALFWAY, (STOP, REST), "right", "to rest, along a line"),
    Case("optimal_duration", sp.sqrt(2) * HALFWAY, (STOP, REST), "wrong", "to the place only"),
    Case(
        "optimal_control",
        [[BACK, HALFWAY], [BACK + sp.pi, 2 * HALFWAY]],
        (STOP, t, REST),
        "right",
        "a thrust that turns round",
    ),
    Case("optimal_control", BACK, (STOP, t, REST), "wrong", "a thrust that does not"),
]

LIMITS = ["Shorter roots are tried at 400 places, up to 0.99 of the duration."]
