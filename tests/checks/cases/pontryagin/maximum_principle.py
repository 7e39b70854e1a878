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
FULLER = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, [x1, x2], running=x1**2)
ROCKET = Problem(
    {h: v, v: (P - k * v**2) / m - g, m: -P / gas},
    {P: (0, full)},
    {h: 0, v: 0, m: 2},
    [v, m - left],
    final=-h,
)
ROBOT = Problem(
    {y1: v * sp.cos(alpha), y2: v * sp.sin(alpha), alpha: w},
    {v: (0, speed), w: (-1, 1)},
    {y1: 0, y2: 0, alpha: 0},
    [y1 - 1, y2 - 2],
)
TOTAL = Problem({x1: u, x2: -u * x1}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
STEERED = Problem(
    {x1: sp.cos(alpha), x2: sp.sin(alpha)}, {alpha: None}, {x1: 0, x2: 0}, [x1 - 1, x2 - 2]
)

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
]
LIMITS = [
    "`maximised_hamiltonian`: controls that enter H linearly, between bounds.",
    "`maximising_control`: a control without a bound is compared with those up to 20 away.",
]
