import numpy as np
import sympy as sp
from case import REFUSED, Case

k, x = sp.symbols("k x")
r, n = sp.Symbol("r", real=True), sp.Symbol("n", integer=True)
a = sp.Symbol("a", positive=True)
THIRD = sp.Rational(1, 3)
SUM = sp.Matrix([[k, 1], [0, 2]])
ROTATION = sp.Matrix([[sp.cos(r), -sp.sin(r)], [sp.sin(r), sp.cos(r)]])
#: Zero at each multiple of a thirteenth, of which samples are made.
AT_SAMPLES = sp.prod([k - sp.Rational(j, 13) for j in range(-6, 7)])


def _values(reference, *rows):
    return [Case("same_value", answer, (reference,), *row) for answer, *row in rows]


def _expressions(reference, *rows, **options):
    return [
        Case("same_expression", answer, (reference,), *row, options=tuple(options.items()))
        for answer, *row in rows
    ]


def _matrices(reference, *rows, **options):
    return [
        Case("same_matrix", answer, (reference,), *row, options=tuple(options.items()))
        for answer, *row in rows
    ]


CASES = [
    *_values(
        THIRD,
        (THIRD, "right", "exact"),
        (0.333, "right", "three digits"),
        (0.33333333, "right", "more digits"),
        (0.33, "wrong", "two digits"),
        (sp.Rational(333, 1000), "wrong", "a fraction is exact"),
        (np.float64(1 / 3), "right", "of NumPy"),
        (1 - sp.Rational(2, 3) * k / k, "right", "a symbol that cancels"),
        (k / 3, "invalid", "a symbol"),
        (sp.I / 3, "invalid", "not real"),
        ([THIRD], "invalid", "a list"),
        ("1/3", "invalid", "a text"),
        (sp.oo, "invalid", "infinite"),
        (sp.nan, "invalid", "undefined"),
        (..., "missing", "the stub as it was"),
    ),
    *_values(
        0.7071, (1 / sp.sqrt(2), "right", "a reference in decimals"), (0.71, "wrong", "two digits")
    ),
    *_values(0, (0, "right", "zero"), (0.0, "right", "zero in decimals"), (1e-9, "wrong", "small")),
    *_values(k, (k, REFUSED, "a reference with a symbol")),
    *_values("1/3", (THIRD, REFUSED, "a reference as a text")),
    *_values(sp.oo, (5, REFUSED, "a reference that is infinite")),
    *_expressions(
        1 / (k + 1) - 1 / (k + 2),
        (1 / ((k + 1) * (k + 2)), "right", "in another form"),
        (1 / (sp.Symbol("k", real=True) ** 2 + 3 * k + 2), "right", "symbols by name"),
        (1 / (k**2 + 3 * k + 2) + sp.Rational(1, 10**30), "wrong", "a small exact difference"),
        (k**2 / (k**4 + 3 * k**3 + 2 * k**2), "right", "a common factor k**2"),
        ((k**2 - 1) / ((k - 1) * (k + 2) * (k + 1) ** 2), "wrong", "without a value at 1"),
        (1.0 / (k**2 + 3.0 * k + 2), "right", "decimals for whole numbers"),
        (1 / (k**2 + 3 * k + 2.1), "wrong", "a decimal"),
        (1 / ((x + 1) * (x + 2)), "invalid", "another symbol"),
        (sp.Eq(k, 1), "invalid", "an equation"),
        (sp.Function("f")(k), "invalid", "a function without a value"),
        (..., "missing", "the stub as it was"),
    ),
    *_expressions(
        k,
        (k + AT_SAMPLES, "wrong", "the same at many simple fractions"),
        (k + sp.sin(13 * sp.pi * k), "wrong", "the same at all multiples of a thirteenth"),
        (sp.Abs(k), "wrong", "the same for positive values"),
        (sp.sqrt(k**2), "wrong", "a root of a square"),
        (sp.Piecewise((k, k < 1000), (0, True)), "wrong", "the same up to 1000"),
        (sp.Piecewise((5, sp.Eq(k, 1)), (k, True)), "wrong", "another value at one point"),
        (sp.oo, "wrong", "infinite"),
    ),
    *_expressions(k, (sp.Abs(k), "right", "for positive values"), given=k > 0),
    *_expressions(k, (k, "right", "nothing given"), given=True),
    *_expressions(
        k,
        (sp.Piecewise((k, k < 1000), (0, True)), "right", "up to 1000, as given"),
        (sp.Min(k, 1), "wrong", "the same up to 1"),
        given=[k > 0, k < 10],
    ),
    *_expressions(
        (r**2 - 1) / (r - 1),
        (r + 1, "right", "with a value where the reference has none"),
        (r - 1, "wrong", "a sign"),
    ),
    *_expressions(
        r / sp.pi,
        (0.318 * r, "right", "a coefficient of three digits"),
        (0.32 * r, "wrong", "a coefficient of two digits"),
    ),
    *_expressions(100 - r, (sp.sqrt((r - 100) ** 2), "wrong", "the same below 100")),
    *_expressions(1 / sp.cos(r), (1 / sp.cos(r), "right", "poles of a function")),
    *_expressions(
        sp.sin(2 * r), (2 * sp.sin(r) * sp.cos(r), "right", "an identity of trigonometry")
    ),
    *_expressions(sp.exp(-1000 * r), (sp.exp(-1000 * r), "right", "too large at some samples")),
    *_expressions(
        sp.log(a * x),
        (sp.log(a) + sp.log(x), "right", "complex where x is negative"),
        (sp.log(a) - sp.log(x), "wrong", "a sign"),
    ),
    *_expressions(
        -1 + sp.I * a,
        (sp.I * (a + sp.I), "right", "complex"),
        (-1 - sp.I * a, "wrong", "conjugate"),
    ),
    *_expressions((-1) ** n, (sp.cos(sp.pi * n), "right", "at whole numbers")),
    *_expressions(
        5,
        (5 + k - k, "right", "a parameter that cancels"),
        (5 + k, "wrong", "a parameter that does not"),
        parameters=[k],
    ),
    *_expressions("k", (k, REFUSED, "a reference as a text")),
    *_expressions(SUM, (k, REFUSED, "a matrix as the reference")),
    *_expressions(sp.log(0 * k), (k, REFUSED, "a reference without a value")),
    *_expressions(k, (k, REFUSED, "conditions that no value satisfies"), given=sp.false),
    *_matrices(
        SUM,
        (SUM, "right", "the matrix"),
        ([[k**2 / k, 1], [0, sp.sqrt(4)]], "right", "lists"),
        ([[k, 1], [0, 2.0]], "right", "decimals"),
        (SUM.T, "wrong", "transposed"),
        (SUM + SUM / 10**30, "wrong", "a small exact difference"),
        ([[k, 1], [1e-5, 2]], "wrong", "a decimal for zero beside larger numbers"),
        ([[k, 1], [x, 2]], "invalid", "another symbol"),
        ([k, 1, 0, 2], "invalid", "its entries in a row"),
        (sp.eye(3), "invalid", "another shape"),
        (k, "invalid", "an expression"),
        (..., "missing", "the stub as it was"),
    ),
    *_matrices(
        [[1 / k, 1]],
        ([[1 / k, 1]], "right", "a pole of the reference"),
        ([1 / k, 1], "right", "a row as a list"),
        (sp.Matrix([1 / k, 1]), "right", "a column for a row"),
        ([1 / k, (k - 1) / (k - 1 + 0 * k)], "right", "a factor that cancels"),
        ([1 / k, (k**2 - 1) / (k - 1) - k], "wrong", "without a value at 1"),
    ),
    *_matrices(
        ROTATION,
        (ROTATION, "right", "functions"),
        (ROTATION.T, "wrong", "the other direction"),
        (ROTATION.subs(r, r + 2 * sp.pi), "right", "a full turn later"),
    ),
    *_matrices(
        np.array([[0.7071, 0.0]]), ([[1 / sp.sqrt(2), 0]], "right", "an array as reference")
    ),
    *_matrices("rotation", (ROTATION, REFUSED, "a reference as a text")),
]
LIMITS = [
    "Where the difference is no rational function, or decimals stand in it, it is compared at six to "
    "fourteen points: an answer that differs beside all of them alone is right.",
    "Everybody can read a reference in a check cell; in a homework keep the answer for the grading.",
]
