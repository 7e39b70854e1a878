import numpy as np
import sympy as sp
from case import Case

x, y, a, b, d = sp.symbols("x y a b d", real=True)
# Duffing's equation: at rest at zero and, for b < 0, at two further places, which are saddles.
SOFT = (sp.Matrix([y, -a * y - x - b * x**3]), [x, y], [a, b], [a > 0, b < 0])
PORTRAIT = (SOFT[0].subs({a: 1, b: -sp.Rational(1, 25)}), [x, y])

CASES = [
    Case(
        "equilibrium_type",
        {0: "stable focus", 5: "saddle", -5: "saddle"},
        PORTRAIT,
        "right",
        "a dict",
    ),
    Case(
        "equilibrium_type",
        [[5.0, "Saddle"], [-5, "saddle"], [(0, 0), "stable-focus"]],
        PORTRAIT,
        "right",
        "pairs, a point among them",
    ),
    Case(
        "equilibrium_type",
        {0: "stable node", 5: "saddle", -5: "saddle"},
        PORTRAIT,
        "wrong",
        "node for focus",
    ),
    Case("equilibrium_type", {0: "stable focus", 5: "saddle"}, PORTRAIT, "wrong", "one left out"),
    Case(
        "equilibrium_type",
        {0: "stable focus", 25: "saddle", -25: "saddle"},
        PORTRAIT,
        "wrong",
        "no equilibria",
    ),
    Case(
        "equilibrium_type",
        {0: "stable", 5: "unstable", -5: "unstable"},
        PORTRAIT,
        "invalid",
        "words that were not offered",
    ),
    Case("saddle_slopes", [1, -2], PORTRAIT, "right", "integers"),
    Case("saddle_slopes", np.array([1.0, -2.0]), PORTRAIT, "right", "an array"),
    Case("saddle_slopes", [-2, 1], PORTRAIT, "wrong", "the other order"),
    Case("saddle_slopes", [1, -1], PORTRAIT, "wrong", "symmetric, as without friction"),
    Case("saddle_slopes", [1, -2.02], PORTRAIT, "wrong", "one per cent off"),
    Case(
        "saddle_slopes",
        [1, -2 - sp.Rational(1, 1000)],
        PORTRAIT,
        "wrong",
        "a fraction is meant exactly",
    ),
    Case("saddle_slopes", [1.0, -2.004], PORTRAIT, "right", "-2.00 to three digits"),
    Case("saddle_slopes", [1, -2.1], PORTRAIT, "wrong", "the second digit off"),
    Case("saddle_slopes", [1], PORTRAIT, "invalid", "one slope"),
]
LIMITS = []
