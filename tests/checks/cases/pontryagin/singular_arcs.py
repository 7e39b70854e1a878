import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x1, x2, u, b, beta, alpha, y1, y2, w = sp.symbols("x1 x2 u b beta alpha y1 y2 w", real=True)
c, t = sp.symbols("c t", real=True)
h = sp.Symbol("h", real=True)
rho, m, v, k, g, gas, T, speed, P, full, left = sp.symbols(
    "rho m v k g c_gas T vbar P Pmax mT", positive=True
)
psi1, psi2, psi3 = sp.symbols("psi1 psi2 psi3", real=True)
TWO, THREE = [psi1, psi2], [psi1, psi2, psi3]

# A square in the cost, as a second state and under the integral; a rocket in air; a pursuit; a
# robot with two controls.
SQUARE = Problem({x1: u, x2: x1**2}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
WORST = Problem({x1: u, x2: -(x1**2)}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
ESCORT = Problem(
    {rho: 2 - sp.cos(beta), beta: sp.sin(beta) / rho + u},
    {u: (-1, 1)},
    {rho: 3, beta: 1},
    [rho - 5],
    maximise=True,
)
FULLER = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, [x1, x2], running=x1**2)
LINES = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, [x1, x2], running=(x1 - x2) ** 2 / 2)
ROCKET = Problem(
    {h: v, v: (P - k * v**2) / m - g, m: -P / gas},
    {P: (0, full)},
    {h: 0, v: 0, m: 2},
    [v, m - left],
    final=-h,
)
# With h downwards, a landing: nothing says how large its costates are.
LANDING = Problem(
    {h: v, v: g - (P + k * v**2) / m, m: -P / gas},
    {P: (0, full)},
    {h: -2, v: 0, m: 2},
    [h, v],
    final=-m,
)
ESCORT = Problem(
    {rho: b - sp.cos(beta), beta: sp.sin(beta) / rho + u},
    {u: (-1, 1)},
    {rho: 1, beta: 1},
    [rho - 2],
    maximise=True,
)
FASTER = {b: sp.Interval(1, 3)}
# The farthest flight with a drag that is a product of powers.
of_speed, of_mass = sp.symbols("p q", positive=True)
GLIDER = Problem(
    {h: v, v: (P - k * v**of_speed * m**of_mass) / m, m: -P / gas},
    {P: (0, full)},
    {h: 0, v: 1, m: 2},
    [v - speed, m - left],
    final=h,
    maximise=True,
)
STEEP = {of_speed: sp.Interval(1, sp.oo), of_mass: sp.Interval(1, sp.oo)}
ROBOT = Problem(
    {y1: v * sp.cos(alpha), y2: v * sp.sin(alpha), alpha: w},
    {v: (0, speed), w: (-1, 1)},
    {y1: 0, y2: 0, alpha: 0},
    [y1 - 1, y2 - 2],
)
GUIDED = Problem(
    {rho: x1, x1: rho * w**2, w: (u - 2 * x1) * w / rho},
    {u: (-1, 1)},
    {rho: 1, x1: 0, w: 1},
    [rho - 2],
)
SLOPE = k * v * (3 * v + 2 * gas)
SURFACE = gas * m * g - k * v**2 * (v + gas)

CASES = [
    Case("singular_order", 1, (ROCKET, THREE), "right", "a rocket"),
    Case("singular_order", 2, (FULLER, TWO), "right", "Fuller's problem"),
    Case("singular_order", 1, (FULLER, TWO), "wrong", "half of it"),
    Case("singular_order", 4, (FULLER, TWO), "wrong", "the derivative's own"),
    Case("singular_order", "two", (FULLER, TWO), "invalid", "a word"),
    Case("singular_surface", x1, (SQUARE, TWO), "right", "one of the states"),
    Case(
        "singular_surface",
        sp.Eq((k * v**2 * (v + gas)) ** 200, (gas * m * g) ** 200),
        (ROCKET, THREE),
        "right",
        "powers that no float holds",
    ),
    Case(
        "singular_surface",
        sp.Eq(SURFACE + sp.cosh(30 * v) ** 2 - sp.sinh(30 * v) ** 2, 1),
        (ROCKET, THREE),
        "right",
        "large terms that cancel",
    ),
    Case(
        "singular_surface",
        sp.Eq(SURFACE + sp.cosh(30 * v) ** 2 - sp.sinh(30 * v) ** 2, sp.Rational(1001, 1000)),
        (ROCKET, THREE),
        "wrong",
        "large terms that cancel, and a thousandth",
    ),
    Case(
        "singular_surface",
        sp.Eq(x1, 0) | sp.Eq(2 * x1, 0, evaluate=False),
        (SQUARE, TWO),
        "right",
        "equations of which one holds",
    ),
    Case(
        "singular_surface",
        sp.Eq(x1, 0) | sp.Eq(x2, 0),
        (SQUARE, TWO),
        "wrong",
        "one equation too many",
    ),
    *(
        Case("singular_surface", surface, (ESCORT, TWO), verdict, note)
        for surface, verdict, note in (
            (sp.Eq(beta, 0) | sp.Eq(beta, sp.pi), "right", "angles of one turn"),
            (sp.Eq(beta, 0), "wrong", "one of two angles"),
        )
    ),
    Case(
        "singular_surface",
        x1,
        (SQUARE, TWO),
        "refused",
        "a domain that the surface does not meet",
        (("domain", {x1: sp.Interval(1, 2)}),),
    ),
    Case("singular_surface", [x1, x2], (FULLER, TWO), "right", "a point"),
    Case(
        "singular_surface",
        sp.Eq(x1, 0) & sp.Eq(x2, 0),
        (FULLER, TWO),
        "right",
        "equations that hold together",
    ),
    Case(
        "singular_surface",
        sp.Eq(w, 0),
        (GUIDED, THREE),
        "right",
        "elsewhere no control keeps dH/du at zero",
    ),
    Case(
        "singular_surface",
        w * (rho - 1),
        (GUIDED, THREE),
        "wrong",
        "a place where none does as well",
    ),
    Case("singular_surface", sp.Eq(x1**2, x2**2), (LINES, TWO), "right", "two lines"),
    *(
        Case("singular_surface", surface, (GLIDER, THREE, None, STEEP), verdict, note)
        for surface, verdict, note in (
            (
                sp.Eq(v * (of_mass - 1), gas * (of_speed - 1)),
                "right",
                "drags of thousands, since nothing bounds the exponents",
            ),
            (sp.Eq(v * of_mass, gas * (of_speed - 1)), "wrong", "at the same drags"),
        )
    ),
    Case("singular_surface", sp.Eq(SURFACE, 0), (ROCKET, THREE), "right", "with parameters"),
    Case(
        "singular_surface",
        sp.sin(beta),
        (ESCORT, TWO, u, FASTER),
        "right",
        "a function with many zeros",
    ),
    Case(
        "singular_surface",
        sp.Eq(k * v**2 * (v - gas), m * g * gas),
        (LANDING, THREE),
        "right",
        "costates of any size",
    ),
    Case(
        "singular_surface",
        sp.Eq(k * v**2 * (v + gas), m * g * gas),
        (LANDING, THREE),
        "wrong",
        "that of the ascent",
    ),
    Case(
        "singular_surface",
        sp.Eq(m * g, k * v**2),
        (LANDING, THREE),
        "wrong",
        "costates would have to vanish",
    ),
    Case("singular_surface", x1, (FULLER, TWO), "wrong", "too much"),
    Case("singular_surface", sp.Eq(x1, x2), (LINES, TWO), "wrong", "one line of two"),
    Case("singular_surface", sp.Eq(x1**2, 1.0 * x2**2), (LINES, TWO), "right", "in decimals"),
    Case(
        "singular_surface",
        sp.Eq(x1**2, 1.02 * x2**2),
        (LINES, TWO),
        "wrong",
        "lines one per cent off",
    ),
    Case("singular_surface", sp.Eq(m * g, k * v**2), (ROCKET, THREE), "wrong", "weight and drag"),
    Case("singular_surface", "x1 = 0", (SQUARE, TWO), "invalid", "a text"),
    Case("singular_control", 0, (SQUARE, TWO), "right", "zero"),
    Case("singular_control", x1, (LINES, TWO), "right", "on two lines"),
    Case("singular_control", x2**2 / x1, (LINES, TWO), "right", "the same on the lines"),
    Case(
        "singular_control",
        SLOPE * (k * v**2 + m * g) / (m * g + SLOPE),
        (ROCKET, THREE),
        "right",
        "of a rocket",
    ),
    Case("singular_control", k * v**2 + m * g, (ROCKET, THREE), "wrong", "hovering"),
    Case("singular_control", x2, (LINES, TWO), "wrong", "right on one line of two"),
    Case("singular_control", t, (LINES, TWO), "invalid", "in time"),
    Case("kelley_expression", -2, (SQUARE, TWO), "right", "a number"),
    Case("kelley_expression", 2 * psi2, (SQUARE, TWO), "right", "with the costate"),
    Case("kelley_expression", -2, (FULLER, TWO), "right", "order two"),
    Case(
        "kelley_expression",
        -v * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)),
        (ROBOT, THREE, w),
        "right",
        "with the other control",
    ),
    Case("kelley_expression", -w, (ROBOT, THREE, w), "wrong", "with the control itself"),
    Case("kelley_expression", 2, (SQUARE, TWO), "wrong", "without the sign"),
    Case("kelley_expression", 2, (FULLER, TWO), "wrong", "the sign of order one"),
    Case("kelley_expression", c, (SQUARE, TWO), "invalid", "another symbol"),
    Case("kelley_holds", "yes", (SQUARE, TWO), "right", "it holds"),
    Case("kelley_holds", False, (WORST, TWO), "right", "it fails"),
    Case("kelley_holds", "yes", (WORST, TWO), "wrong", "it fails"),
    Case("kelley_holds", "no", (FULLER, TWO), "wrong", "it holds"),
    Case("kelley_holds", 2, (SQUARE, TWO), "invalid", "a number"),
    Case(
        "singular_costates",
        [sp.cos(alpha) / v, sp.sin(alpha) / v, 0],
        (ROBOT, THREE, w),
        "right",
        "straight on",
    ),
    Case(
        "singular_costates",
        [0, 0, 1 / w],
        (ROBOT, THREE, v),
        "right",
        "the other control; the end has no part",
    ),
    Case(
        "singular_costates",
        [sp.cos(alpha), sp.sin(alpha), 0],
        (ROBOT, THREE, w),
        "wrong",
        "another length",
    ),
    Case("singular_costates", [0, 0, 1], (ROBOT, THREE, v), "wrong", "another sign on one side"),
    Case(
        "singular_costates",
        [0, 0, 1 / w + v],
        (ROBOT, THREE, v),
        "wrong",
        "with the control that is singular",
    ),
    Case("singular_costates", [0, 0], (ROBOT, THREE, v), "invalid", "two of three"),
]
LIMITS = [
    "`singular_costates`: what `pontryagin.Problem` says of the end has no part in it, so that "
    "such an arc may be excluded by it.",
    "`singular_control` and its like: points of singular arcs are searched with lambda_0 = 1; "
    "abnormal ones do not count.",
    "`singular_surface`: an equation is followed to its zeros by Newton's method from random "
    "places, so that a part of it far from all others may go unseen.",
]
