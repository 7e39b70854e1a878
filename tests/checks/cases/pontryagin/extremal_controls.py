import sympy as sp
from case import Case

from trajlib.pontryagin import Problem

x1, x2, u, b, beta, alpha, y1, y2, w = sp.symbols("x1 x2 u b beta alpha y1 y2 w", real=True)
c, t = sp.symbols("c t", real=True)

SQUARE = Problem({x1: u, x2: x1**2}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
WORST = Problem({x1: u, x2: -(x1**2)}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
TOTAL = Problem({x1: u, x2: -u * x1}, {u: (-1, 1)}, {x1: 0, x2: 0}, final=x2, duration=1)
ANY = {c: sp.Interval(-1, 1)}

CASES = [
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
    Case("extremal_control", 0, (TOTAL, t, ANY, c), "wrong", "another initial state"),
    Case("extremal_control", c * (1 - 4 * t), (TOTAL, t, ANY, c), "wrong", "beyond the bounds"),
    Case("extremal_control", 1, (SQUARE, t), "wrong", "a bound for the other one"),
    Case("extremal_control", x1, (SQUARE, t), "invalid", "a law"),
]
LIMITS = []
