import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

k, c = sp.symbols("k", real=True), sp.symbols("c", positive=True)
half = sp.Rational(1, 2)
# Eigenvalues 1, 2, 3 with the coordinate axes as eigenvectors: the first is lost at 2, the other
# two together at 1/2.
AXES = (Linear(sp.diag(1, 2, 3), H=sp.Matrix([[k - 2, 2 * k - 1, 1 - 2 * k]])), k)
# A plane of eigenvectors and two outputs: lost at -1; the eigenvalue 5 is lost by the first output
# alone, at 4.
PLANE = (Linear(sp.diag(1, 1, 5), H=sp.Matrix([[1, k + 2, 4 - k], [1, 1, 1]])), k)
ALWAYS = (Linear(sp.Matrix([[0, 1], [-1, 0]]), H=sp.Matrix([[1, k]])), k)
POSITIVE = (Linear(sp.diag(1, 2), H=sp.Matrix([[c**2 - 4, 1]])), c)
FLAT = sp.Matrix([[0, 1, 0], [0, 0, 1]])
BOTH = {2: [[1, 0, 0]], half: [[0, 1, 0], [0, 0, 1]]}

CASES = [
    Case("unobservable_states_at", BOTH, AXES, "right", "two values, the second with two vectors"),
    Case(
        "unobservable_states_at",
        {0.5: [(0, 1, 1), (0, 1, -1)], 2.0: [(-3, 0, 0)]},
        AXES,
        "right",
        "decimals, another order and other bases",
    ),
    Case(
        "unobservable_states_at",
        {half: FLAT.T, 2: sp.Matrix([1, 0, 0])},
        AXES,
        "right",
        "matrices with the basis as columns",
    ),
    Case(
        "unobservable_states_at",
        {2: np.array([[1.0, 0, 0]]), half: [np.array([0, 1, 0]), np.array([0, 0, 1])]},
        AXES,
        "right",
        "arrays",
    ),
    Case(
        "unobservable_states_at",
        {2: [1, 0, 0], half: [[0, 1, 0], [0, 0, 1]]},
        AXES,
        "right",
        "a single vector without the outer list",
    ),
    Case("unobservable_states_at", {-1: [[1, -1, 0]]}, PLANE, "right", "two outputs"),
    Case("unobservable_states_at", {}, ALWAYS, "right", "no such value"),
    Case(
        "unobservable_states_at",
        {2: [[1, 0]]},
        POSITIVE,
        "right",
        "the negative value is not among those of the data",
    ),
    Case("unobservable_states_at", {2: [[1, 0, 0]]}, AXES, "wrong", "a value overlooked"),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, 0]], half: [[0, 1, 1]]},
        AXES,
        "wrong",
        "a vector overlooked",
    ),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, 0]], half: [[0, 1, 0], [0, 2, 0]]},
        AXES,
        "wrong",
        "dependent vectors",
    ),
    Case("unobservable_states_at", {2: [[1, 0, 0]], half: []}, AXES, "wrong", "no vector"),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, 1]], half: FLAT.T},
        AXES,
        "wrong",
        "a vector that is seen",
    ),
    Case(
        "unobservable_states_at",
        {half: [[1, 0, 0]], 2: FLAT.T},
        AXES,
        "wrong",
        "the values interchanged",
    ),
    Case(
        "unobservable_states_at",
        BOTH | {4: [[1, 0, 0]]},
        AXES,
        "wrong",
        "a value at which nothing is lost",
    ),
    Case(
        "unobservable_states_at",
        BOTH | {2.0: [[1, 0, 0]], sp.Float("2.001"): [[1, 0, 0]]},
        AXES,
        "wrong",
        "one value twice",
    ),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, 0]], 0.51: FLAT.T},
        AXES,
        "wrong",
        "a value right to one digit",
    ),
    Case(
        "unobservable_states_at",
        {4: [[0, 0, 1]], -1: [[1, -1, 0]]},
        PLANE,
        "wrong",
        "what the first output alone does not see",
    ),
    Case("unobservable_states_at", {}, PLANE, "wrong", "none"),
    Case(
        "unobservable_states_at",
        {2: [[1, 0]], -2: [[1, 0]]},
        POSITIVE,
        "wrong",
        "a value that the data exclude",
    ),
    Case("unobservable_states_at", {0: [[1, 0]]}, ALWAYS, "wrong", "a value where there is none"),
    Case(
        "unobservable_states_at",
        {2: [[sp.nan, 0, 0]], half: FLAT.T},
        AXES,
        "invalid",
        "an undefined component",
    ),
    Case("unobservable_states_at", ..., AXES, "missing", "the untouched stub"),
    Case("unobservable_states_at", {2: ..., half: FLAT.T}, AXES, "missing", "half of it"),
    Case("unobservable_states_at", [[1, 0, 0]], AXES, "invalid", "a basis without its value"),
    Case("unobservable_states_at", {k: [[1, 0, 0]]}, AXES, "invalid", "the symbol as the value"),
    Case("unobservable_states_at", {2: [[1, 0]], half: FLAT.T}, AXES, "invalid", "two components"),
    Case("unobservable_states_at", {2: "x1", half: FLAT.T}, AXES, "invalid", "text"),
]
LIMITS = [
    "The values at which observability is lost have to be rational, and finitely many: a matter "
    "of the problem, not of the answer."
]
