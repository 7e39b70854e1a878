"""Chains from the solutions of problems, whole and spoilt at one step each."""

import sympy as sp
from case import Case

s, lam, t, tau, x, y, z = sp.symbols("s lambda t tau x y z", real=True)
k1, k2, mu = sp.symbols("k1 k2 mu", real=True)
a, T, c = sp.symbols("a T c", positive=True)
M, Eq, And, Or = sp.Matrix, sp.Eq, sp.And, sp.Or
LOOP = M([[0, 1], [k1, k2]])

CASES = []


def chain(note, good, spoilt):
    """Add a chain, and the same with one step that does not follow."""
    CASES.append(Case("steps", good, (), "right", note))
    CASES.append(Case("steps", spoilt, (), "wrong", f"{note}, spoilt"))


chain(
    "Hurwitz conditions (1.15)",
    [(k1 > 0) & (k1 * k2 - 1 > 0), (k1 > 0) & (k2 > 1 / k1)],
    [(k1 > 0) & (k1 * k2 - 1 > 0), k2 > 1 / k1],
)
chain(
    "a division by a negative number",
    [-2 * x + 4 > 0, -2 * x > -4, x < 2],
    [-2 * x + 4 > 0, -2 * x > -4, x > 2],
)
chain(
    "a quadratic inequality",
    [x**2 > 4, sp.Abs(x) > 2, (x > 2) | (x < -2)],
    [x**2 > 4, x > 2],
)
chain(
    "a characteristic polynomial (3.9)",
    [
        (lam * sp.eye(2) - LOOP).det(method="berkowitz"),
        lam * (lam - k2) - k1,
        lam**2 - k2 * lam - k1,
    ],
    [lam * (lam - k2) - k1, lam**2 - k2 * lam + k1],
)
chain(
    "a shifted polynomial (1.16)",
    [s**2 + 3 * s + 5, ("substitute", {s: s - 1}), (s - 1) ** 2 + 3 * (s - 1) + 5, s**2 + s + 3],
    [s**2 + 3 * s + 5, ("substitute", {s: s - 1}), (s - 1) ** 2 + 3 * s + 5],
)
chain(
    "a scalar Riccati equation (5.63)",
    [Eq(y**2 - 2 * y - 3, 0), Eq((y - 3) * (y + 1), 0), Eq(2 * (y - 3) * (y + 1), 0)],
    [Eq(y**2 - 2 * y - 3, 0), Eq((y - 3) * (y + 1), 0), Eq(y, 3)],
)
chain(
    "of two roots the positive one",
    [Eq(a**2 - 2 * a - 3, 0), Eq(a, 3)],
    [Eq(a**2 - 2 * a - 3, 0), Eq(a, 1)],
)
chain(
    "a square root taken",
    [Eq(x**2, c), Eq((x - sp.sqrt(c)) * (x + sp.sqrt(c)), 0)],
    [Eq(x**2, y**2), Eq(x, y)],
)
chain(
    "both sides divided by an expression that may be zero",
    [Eq(x * y, x * z), Eq(x * (y - z), 0)],
    [Eq(x * y, x * z), Eq(y, z)],
)
chain(
    "a derivative along a motion (1.25)",
    [t**2 * sp.exp(-2 * t), ("derivative", t), 2 * t * sp.exp(-2 * t) - 2 * t**2 * sp.exp(-2 * t)],
    [t**2 * sp.exp(-2 * t), ("derivative", t), -4 * t * sp.exp(-2 * t)],
)
chain(
    "an integral, with any constant",
    [sp.sin(2 * t), ("integral", t), -sp.cos(2 * t) / 2 + 5, sp.sin(t) ** 2 + sp.Rational(9, 2)],
    [sp.sin(2 * t), ("integral", t), -2 * sp.cos(2 * t)],
)
chain(
    "a Laplace transform",
    [t * sp.exp(-2 * t), ("Laplace", t, s), 1 / (s + 2) ** 2],
    [t * sp.exp(-2 * t), ("Laplace", t, s), 1 / (s + 2)],
)
chain(
    "a matrix product (2.1)",
    [M([[0, 1], [-1, 0]]) ** 2, -sp.eye(2)],
    [M([[0, 1], [-1, 0]]) ** 2, sp.eye(2)],
)
chain(
    "a covariance with a parameter (4.10)",
    [M([[1, a], [0, 1]]) * M([[1, 0], [a, 1]]), M([[1 + a**2, a], [a, 1]])],
    [M([[1, a], [0, 1]]) * M([[1, 0], [a, 1]]), M([[1 + a**2, a], [-a, 1]])],
)
chain(
    "partial fractions",
    [1 / (s * (s + 1)), 1 / s - 1 / (s + 1)],
    [1 / (s * (s + 1)), 1 / s + 1 / (s + 1)],
)
chain(
    "an addition theorem",
    [sp.sin(t + tau), sp.sin(t) * sp.cos(tau) + sp.cos(t) * sp.sin(tau)],
    [sp.sin(t + tau), sp.sin(t) + sp.sin(tau)],
)
chain(
    "a root of a square",
    [sp.sqrt(a**2 * c), a * sp.sqrt(c)],
    [sp.sqrt(x**2), x],
)
chain(
    "a cost as a function of the duration (5.46)",
    [sp.integrate((6 / T**2 - 12 * t / T**3) ** 2, (t, 0, T)), 12 / T**3],
    [sp.integrate((6 / T**2 - 12 * t / T**3) ** 2, (t, 0, T)), 12 / T**2],
)
chain("decimals", [sp.sqrt(2), 1.414], [sp.sqrt(2), 1.42])
chain(
    "a vector",
    [[x + x, x * y], [2 * x, y * x]],
    [[x + x, x * y], [2 * x, y + x]],
)
CASES += [
    Case(
        "steps", [Eq(sp.sin(x), 1), Eq(3 * sp.sin(x), 3)], (), "right", "a multiple of an equation"
    ),
    Case(
        "steps", [Eq(x**2 + 1, 0), Eq(x**4 + 1, 0)], (), "right", "two equations without solutions"
    ),
    Case("steps", [x], (), "invalid", "a single step"),
    Case("steps", x, (), "invalid", "no list"),
    Case("steps", [x > 0, x], (), "invalid", "steps of two kinds"),
    Case("steps", [x, ("square", x), x**2], (), "invalid", "an operation that is not known"),
    Case("steps", [("derivative", x), x, 1], (), "invalid", "an operation before all steps"),
    Case(
        "steps",
        [Eq(sp.sin(x), 0), Eq(sp.cos(x), 1)],
        (),
        "invalid",
        "equations that are no polynomials",
    ),
    Case("steps", [M([[1, 2]]), M([1, 2])], (), "wrong", "another shape"),
    Case("steps", [1 / x, sp.oo], (), "wrong", "an infinite step"),
]

LIMITS = [
    "Equations that are no polynomials are compared only if one is a multiple of the other.",
    "What cannot be decided is compared at points, and the verdict says at how many.",
]
