import sympy as sp
from case import Case

q = sp.Symbol("q", positive=True)
LEVEL = ([[1, 1, 1]], [[1, q, q**2]], [1])
SLOPE = ([[1, 1, 1], [0, 1, 2]], [[1, q, q**2]], [0, 1])
FREE = ([[1, 1, 1, 1]], [], [1])
weights = [q / (q - 1) / 2, sp.Rational(1, 2), 1 / (1 - q) / 2]

CASES = [
    Case("research.invariant_weights", weights, LEVEL, "right", "by hand"),
    Case("research.invariant_weights", sp.Matrix(weights), LEVEL, "right", "a column"),
    Case("research.invariant_weights", sp.Matrix([weights]), LEVEL, "right", "a row"),
    Case(
        "research.invariant_weights",
        [(1 - q + q**2 - q**k) / (2 * (1 - q) ** 2) for k in range(3)],
        LEVEL,
        "right",
        "over a common denominator",
    ),
    Case("research.invariant_weights", [sp.Rational(1, 3)] * 3, LEVEL, "wrong", "the mean"),
    Case(
        "research.invariant_weights",
        [q / (q - 1), 1 / (1 - q), 0],
        LEVEL,
        "wrong",
        "unbiased and invariant by two samples alone",
    ),
    Case(
        "research.invariant_weights", [2 * w for w in weights], LEVEL, "wrong", "biased by a factor"
    ),
    Case("research.invariant_weights", [0, 0, 0], LEVEL, "wrong", "nothing comes through"),
    Case("research.invariant_weights", weights[::-1], LEVEL, "wrong", "in the other order"),
    Case(
        "research.invariant_weights",
        [q / (1 - q), -(1 + q) / (1 - q), 1 / (1 - q)],
        SLOPE,
        "right",
        "a slope",
    ),
    Case(
        "research.invariant_weights",
        [-sp.Rational(1, 2), 0, sp.Rational(1, 2)],
        SLOPE,
        "wrong",
        "the slope without a nuisance",
    ),
    Case(
        "research.invariant_weights",
        [sp.Rational(1, 4)] * 4,
        FREE,
        "right",
        "no nuisance: the mean",
    ),
    Case("research.invariant_weights", [0.25] * 4, FREE, "right", "in decimals"),
    Case(
        "research.invariant_weights",
        [0.26, 0.24, 0.25, 0.25],
        FREE,
        "wrong",
        "unbiased, but not of least variance",
    ),
    Case("research.invariant_weights", weights[:2], LEVEL, "invalid", "too few"),
    Case("research.invariant_weights", [sp.Symbol("y"), 0, 0], LEVEL, "invalid", "another symbol"),
    Case("research.invariant_weights", ..., LEVEL, "missing", "the untouched stub"),
]
LIMITS = ["Random positive values of the symbols are tried."]
