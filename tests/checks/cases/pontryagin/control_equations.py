import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x, y, x0, y0, U0, Ux, Uy, V0, Vx, Vy = sp.symbols("x y x0 y0 U_0 U_x U_y V_0 V_x V_y", real=True)
theta, alpha, beta, w, p1, p2 = sp.symbols("theta alpha beta w p1 p2", real=True)
v, g, T, s, r, end, b = sp.symbols("v g T s r r_T b", positive=True)
c, psi = sp.Symbol("c", negative=True), sp.Symbol("psi", real=True)
cos, sin, tan = sp.cos(theta), sp.sin(theta), sp.tan(theta)
FREE = {theta: (None, None)}

# The farthest flight in a plane without and with drag; the fastest way in a current that is linear
# about a place, in a constant one, and with a speed that changes linearly; the longest evasion; a
# planned speed.
FLIGHT = Problem(
    {x: v * cos, y: v * sin, v: -g * sin}, FREE, {x: x0, y: y0, v: 1}, final=-x, duration=T
)
IN_AIR = Problem(
    {x: v * cos, y: v * sin, v: -(v**2) - sin}, FREE, {x: x0, y: y0, v: 1}, final=-x, duration=T
)
U, V = U0 + Ux * x + Uy * y, V0 + Vx * x + Vy * y
CURRENT = Problem({x: s * cos + U, y: s * sin + V}, FREE, {x: x0, y: y0}, [x, y])
STEADY = Problem({x: s * cos + U0, y: s * sin + V0}, FREE, {x: x0, y: y0}, [x, y])
PLACE = Problem({x: U * cos, y: U * sin}, FREE, {x: x0, y: y0}, [x, y])
EVASION = Problem(
    {r: sp.cos(alpha) - b * sp.cos(beta), beta: (b * sp.sin(beta) - sp.sin(alpha)) / (r * c)},
    {alpha: (None, None)},
    {r: 2, beta: 1},
    [r - end],
    maximise=True,
)
MOVED = {b: sp.Interval.open(1, sp.oo)}
EVADED = (b * sp.sin(beta) - sp.sin(alpha)) / r - b * (1 - c) / (r * c) * sp.cos(alpha) * sp.sin(
    alpha - beta
)
REGULATOR = Problem({x: w}, {w: (-5, 5)}, {x: 1}, running=x**2 + w**2, duration=2)
THRUST = Problem(
    {x: p1, y: p2, p1: cos, p2: sin},
    FREE,
    {x: 0, y: 0, p1: 0, p2: 0},
    [y - 1, p2],
    final=-p1,
    duration=T,
)

ZERMELO = Vx * sin**2 + (Ux - Vy) * sin * cos - Uy * cos**2

CASES = [
    Case("control_equation", g * cos / v, (FLIGHT,), "right", "a flight without drag"),
    Case(
        "control_equation",
        g / (v * sp.sqrt(1 + tan**2)),
        (FLIGHT, {theta: sp.Interval(-1.5, 1.5)}),
        "right",
        "in another form, where the domain lets it",
    ),
    Case("control_equation", -g * cos / v, (FLIGHT,), "wrong", "the other sign"),
    Case("control_equation", g * cos, (FLIGHT,), "wrong", "without the speed"),
    Case("control_equation", g * psi / v, (FLIGHT,), "invalid", "a costate"),
    Case("control_equation", cos * (1 + 3 * v**2 * sin) / v, (IN_AIR,), "right", "a flight in air"),
    Case("control_equation", cos / v, (IN_AIR,), "wrong", "the drag forgotten"),
    Case("control_equation", cos * (1 + 2 * v**2 * sin) / v, (IN_AIR,), "wrong", "a wrong number"),
    Case("control_equation", ZERMELO, (CURRENT,), "right", "a current"),
    Case(
        "control_equation",
        V.diff(x) * sin**2 + (U.diff(x) - V.diff(y)) * sp.sin(2 * theta) / 2 - U.diff(y) * cos**2,
        (CURRENT,),
        "right",
        "with derivatives of the current",
    ),
    Case(
        "control_equation",
        ZERMELO + (Ux - Vx) * sin**2,
        (CURRENT,),
        "wrong",
        "one derivative for another",
    ),
    Case("control_equation", -ZERMELO, (CURRENT,), "wrong", "the other sign of a current"),
    Case("control_equation", 0, (STEADY,), "right", "a constant current"),
    Case(
        "control_equation",
        U0 * sin - V0 * cos,
        (STEADY,),
        "wrong",
        "a constant current that turns the ship",
    ),
    Case(
        "control_equation",
        Ux * sin - Uy * cos,
        (PLACE,),
        "right",
        "a speed that depends on the place",
    ),
    Case("control_equation", Uy * cos - Ux * sin, (PLACE,), "wrong", "away from the faster side"),
    Case("control_equation", EVADED, (EVASION, MOVED), "right", "an evasion"),
    Case(
        "control_equation",
        EVADED.subs(c, -1),
        (EVASION, MOVED),
        "wrong",
        "for one value of a parameter",
    ),
    Case(
        "control_equation",
        EVADED.subs(b, 2),
        (EVASION, {b: sp.Interval(1.5, 2.5)}),
        "wrong",
        "for another parameter, near it",
    ),
    Case("control_equation", 0, (THRUST,), "refused", "a costate cannot be eliminated"),
    Case("control_equation", x, (REGULATOR,), "right", "a quadratic cost"),
    Case("control_equation", 2 * x, (REGULATOR,), "wrong", "a quadratic cost with a factor"),
]

LIMITS = [
    "`control_equation`: the equation must follow from H_u = 0 and the costates that "
    "transversality says, or with H = 0 where the time is free; where it does not, as in "
    "steering by the linear tangent, the check cannot judge.",
    "`control_equation`: an equation is compared where some costate makes H greatest, with H_uu < "
    "0.",
]
