import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x1, x2, u, b, beta, alpha, y1, y2, w = sp.symbols("x1 x2 u b beta alpha y1 y2 w", real=True)
h = sp.Symbol("h", real=True)
rho, m, v, k, g, gas, T, speed, P, full, left = sp.symbols(
    "rho m v k g c_gas T vbar P Pmax mT", positive=True
)
psi1, psi2, psi3 = sp.symbols("psi1 psi2 psi3", real=True)
TWO, THREE = [psi1, psi2], [psi1, psi2, psi3]

SQUARE = Problem({x1: u, x2: x1**2}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
FULLER = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, [x1, x2], running=x1**2)
ROCKET = Problem(
    {h: v, v: (P - k * v**2) / m - g, m: -P / gas},
    {P: (0, full)},
    {h: 0, v: 0, m: 2},
    [v, m - left],
    final=-h,
)
CIRCLE = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 3, x2: 0}, [x1**2 + x2**2 - 1])

CASES = [
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
]
LIMITS = []
