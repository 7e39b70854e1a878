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
ROBOT = Problem(
    {y1: v * sp.cos(alpha), y2: v * sp.sin(alpha), alpha: w},
    {v: (0, speed), w: (-1, 1)},
    {y1: 0, y2: 0, alpha: 0},
    [y1 - 1, y2 - 2],
)
CIRCLE = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 3, x2: 0}, [x1**2 + x2**2 - 1])
GUIDED = Problem(
    {rho: x1, x1: rho * w**2, w: (u - 2 * x1) * w / rho},
    {u: (-1, 1)},
    {rho: 1, x1: 0, w: 1},
    [rho - 2],
)
TOTAL = Problem({x1: u, x2: -u * x1}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
STEERED = Problem(
    {x1: sp.cos(alpha), x2: sp.sin(alpha)}, {alpha: None}, {x1: 0, x2: 0}, [x1 - 1, x2 - 2]
)
ANY = {c: sp.Interval(-1, 1)}
H_ROCKET = psi1 * v + psi2 * ((P - k * v**2) / m - g) - psi3 * P / gas
SLOPE = k * v * (3 * v + 2 * gas)
SURFACE = gas * m * g - k * v**2 * (v + gas)

CASES = [
    Case(
        "pontryagin_function", psi1 * u + psi2 * x1**2, (SQUARE, TWO), "right", "the cost a state"
    ),
    Case(
        "pontryagin_function",
        psi1 * x2 + psi2 * u - x1**2,
        (FULLER, TWO),
        "right",
        "the cost an integral",
    ),
    Case(
        "pontryagin_function",
        psi1 * x2 + psi2 * u + x1**2,
        (FULLER, TWO),
        "wrong",
        "the sign of the cost",
    ),
    Case("pontryagin_function", psi1 * x2 + psi2 * u, (FULLER, TWO), "wrong", "without the cost"),
    Case("pontryagin_function", psi1 * t, (FULLER, TWO), "invalid", "another symbol"),
    Case(
        "adjoint_equations",
        [0, -psi1 + 2 * k * v * psi2 / m, psi2 * (P - k * v**2) / m**2],
        (ROCKET, THREE),
        "right",
        "three states",
    ),
    Case("adjoint_equations", [2 * x1, -psi1], (FULLER, TWO), "right", "a running cost"),
    Case("adjoint_equations", [-2 * x1, -psi1], (FULLER, TWO), "wrong", "the sign of the cost"),
    Case("adjoint_equations", [-psi2, 0], (FULLER, TWO), "wrong", "the matrix for its transpose"),
    Case("adjoint_equations", [0], (FULLER, TWO), "invalid", "one of two"),
    Case("switching_function", psi2 / m - psi3 / gas, (ROCKET, THREE, P), "right", "a difference"),
    Case(
        "switching_function",
        gas * psi2 - m * psi3,
        (ROCKET, THREE, P),
        "right",
        "times a positive factor",
    ),
    Case("switching_function", psi1 + x1, (TOTAL, TWO), "right", "with the costate that is known"),
    Case("switching_function", psi3, (ROBOT, THREE, w), "right", "one of two controls"),
    Case(
        "switching_function", psi3 / gas - psi2 / m, (ROCKET, THREE, P), "wrong", "the other sign"
    ),
    Case("switching_function", psi2, (ROCKET, THREE, P), "wrong", "a part"),
    Case(
        "switching_function",
        1.0 * gas * psi2 - m * psi3,
        (ROCKET, THREE, P),
        "right",
        "in decimals",
    ),
    Case(
        "switching_function",
        psi2 / m - 1.02 * psi3 / gas,
        (ROCKET, THREE, P),
        "wrong",
        "two per cent off",
    ),
    Case("switching_function", psi3 * P, (ROBOT, THREE, w), "invalid", "another symbol"),
    Case("switching_rate", 0, (TOTAL, TWO), "right", "it does not change"),
    Case("switching_rate", -2 * psi2 * x1, (SQUARE, TWO), "right", "with the costate"),
    Case("switching_rate", 2 * x1, (SQUARE, TWO), "right", "with its value"),
    Case("switching_rate", u, (TOTAL, TWO), "wrong", "half of it"),
    Case("switching_rate", 2 * psi2 * x1, (SQUARE, TWO), "wrong", "the sign"),
    Case("switching_rate", c, (SQUARE, TWO), "invalid", "another symbol"),
    Case("transversality", [psi1, psi2 + 1], (SQUARE, TWO), "right", "a free end"),
    Case("transversality", [sp.Eq(psi1, -1)], (ROCKET, THREE), "wrong", "the sign of the cost"),
    Case("transversality", sp.Eq(psi1, 1), (ROCKET, THREE), "right", "one equation"),
    Case("transversality", psi1 * x2 - psi2 * x1, (CIRCLE, TWO), "right", "a circle"),
    Case("transversality", [], (FULLER, TWO), "right", "a given end"),
    Case("transversality", [psi1], (FULLER, TWO), "wrong", "where the state is given"),
    Case("transversality", [psi1], (SQUARE, TWO), "wrong", "one of two"),
    Case("transversality", [psi1, psi2], (SQUARE, TWO), "wrong", "without the cost"),
    Case("transversality", psi1**2 + (psi2 + 1) ** 2, (SQUARE, TWO), "right", "a sum of squares"),
    Case("transversality", psi1**2, (SQUARE, TWO), "wrong", "a square of one of two"),
    Case("transversality", psi1 * (psi2 + 1), (SQUARE, TWO), "invalid", "not linear"),
    Case("maximising_control", sp.sign(psi2), (FULLER, TWO), "right", "a sign"),
    Case(
        "maximising_control",
        sp.Piecewise((full, gas * psi2 > m * psi3), (0, True)),
        (ROCKET, THREE),
        "right",
        "cases",
    ),
    Case(
        "maximising_control",
        [
            sp.Piecewise((speed, psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha) > 0), (0, True)),
            sp.sign(psi3),
        ],
        (ROBOT, THREE),
        "right",
        "two controls",
    ),
    Case("maximising_control", -sp.sign(psi2), (FULLER, TWO), "wrong", "the least H"),
    Case("maximising_control", psi2, (FULLER, TWO), "wrong", "not admissible"),
    Case(
        "maximising_control",
        sp.tanh(100 * psi2),
        (FULLER, TWO),
        "wrong",
        "a smooth imitation of the sign",
    ),
    Case(
        "maximising_control",
        sp.atan2(1.0 * psi2, psi1),
        (STEERED, TWO),
        "right",
        "a direction in decimals",
    ),
    Case(
        "maximising_control",
        sp.atan2(1.03 * psi2, psi1),
        (STEERED, TWO),
        "wrong",
        "off by little, which H hardly shows",
    ),
    Case("maximising_control", [0, 0, 0], (ROBOT, THREE), "invalid", "three of two"),
    Case("singular_order", 1, (ROCKET, THREE), "right", "a rocket"),
    Case("singular_order", 2, (FULLER, TWO), "right", "Fuller's problem"),
    Case("singular_order", 1, (FULLER, TWO), "wrong", "half of it"),
    Case("singular_order", 4, (FULLER, TWO), "wrong", "the derivative's own"),
    Case("singular_order", "two", (FULLER, TWO), "invalid", "a word"),
    Case("singular_surface", x1, (SQUARE, TWO), "right", "one of the states"),
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
        "maximised_hamiltonian",
        sp.Abs(psi2) + psi1 * x2 - x1**2,
        (FULLER, TWO),
        "right",
        "one control",
    ),
    Case(
        "maximised_hamiltonian",
        speed * sp.Max(0, psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + sp.Abs(psi3) - 1,
        (ROBOT, THREE),
        "right",
        "two controls, one of them not negative",
    ),
    Case(
        "maximised_hamiltonian",
        psi2 + psi1 * x2 - x1**2,
        (FULLER, TWO),
        "wrong",
        "one bound for all",
    ),
    Case(
        "maximised_hamiltonian",
        speed * (psi1 * sp.cos(alpha) + psi2 * sp.sin(alpha)) + sp.Abs(psi3) - 1,
        (ROBOT, THREE),
        "wrong",
        "full speed always",
    ),
    Case("maximised_hamiltonian", u * psi2, (FULLER, TWO), "invalid", "the control is left in it"),
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
    Case(
        "extremal_control", c * (1 - 2 * t), (TOTAL, t, ANY, c), "right", "a line through its mean"
    ),
    Case("extremal_control", c * sp.cos(sp.pi * t), (TOTAL, t, ANY, c), "right", "half a wave"),
    Case("extremal_control", c * sp.cos(3.14 * t), (TOTAL, t, ANY, c), "right", "in decimals"),
    Case("extremal_control", c * sp.cos(3.18 * t), (TOTAL, t, ANY, c), "wrong", "one per cent off"),
    Case("extremal_control", 0, (SQUARE, t), "right", "singular all the time"),
    Case("extremal_control", 0, (WORST, t), "right", "the worst one"),
    Case("extremal_control", 1, (WORST, t), "right", "on a bound"),
    Case("extremal_control", c, (TOTAL, t, ANY, c), "wrong", "constant"),
    Case("extremal_control", 0, (TOTAL, t, ANY, c), "wrong", "another beginning"),
    Case("extremal_control", c * (1 - 4 * t), (TOTAL, t, ANY, c), "wrong", "beyond the bounds"),
    Case("extremal_control", 1, (SQUARE, t), "wrong", "a bound for the other one"),
    Case("extremal_control", x1, (SQUARE, t), "invalid", "a law"),
]

LIMITS = [
    "`singular_costates`: what `pontryagin.Problem` says of the end has no part in it, so that "
    "such an arc may be "
    "excluded by it. `maximised_hamiltonian`: controls that enter H linearly, between bounds.",
    "`singular_control` and its like: points of singular arcs are searched with lambda_0 = 1; "
    "abnormal ones do not count.",
    "`singular_surface`: an equation is followed to its zeros by Newton's method from random "
    "places, so that a part of it far from all others may go unseen.",
    "`maximising_control`: a control without a bound is compared with those up to 20 away.",
]
