import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear

a = sp.symbols("alpha", real=True)
M = sp.Matrix
# Its polynomial is lambda^3 - 2 lambda - 2.
PLANT = M([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
SEEN, DRIVEN = (Linear(PLANT, H=M([[1, 0, 0]])),), (Linear(PLANT.T, M([1, 0, 0])),)
BY_OBSERVATION, BY_CONTROL = (
    M([[0, 1, 0], [2, 0, 1], [2, 0, 0]]),
    M([[0, 1, 0], [0, 0, 1], [2, 2, 0]]),
)
T = M([[1, 0, 0], [0, 1, 0], [-1, 1, 1]])
P = M([[-1, 0, 1], [1, 1, 0], [1, 0, 0]])
FREE = (Linear(M([[0, 1], [a, 1]]), H=M([[1, 1]])), [a])
FREE_DRIVEN = (Linear(M([[0, 1], [a, 1]]), M([0, 1])), [a])
W = M.hstack(*[DRIVEN[0].A ** k * DRIVEN[0].B for k in range(3)])

CASES = [
    Case("canonical_matrix", BY_OBSERVATION, SEEN, "right", "a matrix"),
    Case("canonical_matrix", BY_OBSERVATION.tolist(), SEEN, "right", "nested lists"),
    Case(
        "canonical_matrix",
        np.array(BY_OBSERVATION.tolist(), dtype=float),
        SEEN,
        "right",
        "an array of floats",
    ),
    Case(
        "canonical_matrix",
        [[1, 1], [sp.Symbol("alpha"), 0]],
        FREE,
        "right",
        "with a parameter, a plain symbol",
    ),
    Case("canonical_matrix", BY_CONTROL, SEEN, "wrong", "the controllable form"),
    Case("canonical_matrix", BY_OBSERVATION.T, SEEN, "wrong", "transposed"),
    Case("canonical_matrix", [[0, 1, 0], [-2, 0, 1], [2, 0, 0]], SEEN, "wrong", "a sign"),
    Case(
        "canonical_matrix",
        [[2, 1, 0], [2, 0, 1], [0, 0, 0]],
        SEEN,
        "wrong",
        "the coefficients in the opposite order",
    ),
    Case("canonical_matrix", PLANT, SEEN, "wrong", "the matrix as given"),
    Case("canonical_matrix", ..., SEEN, "missing", "the untouched stub"),
    Case("canonical_matrix", [[0, 1], [2, 0]], SEEN, "invalid", "another order"),
    Case("canonical_matrix", BY_CONTROL, DRIVEN, "right", "a matrix"),
    Case("canonical_matrix", [[0, 1], [a, 1]], FREE_DRIVEN, "right", "with a parameter"),
    Case("canonical_matrix", BY_OBSERVATION, DRIVEN, "wrong", "the observable form"),
    Case("canonical_matrix", [[0, 1, 0], [0, 0, 1], [2, -2, 0]], DRIVEN, "wrong", "a sign"),
    Case(
        "canonical_matrix",
        [[0, 1, 0], [0, 0, 2], [1, 1, 0]],
        DRIVEN,
        "wrong",
        "the eigenvalues of A in another shape",
    ),
    Case("canonical_matrix", [2, 2, 0], DRIVEN, "invalid", "the last row alone"),
    Case("chain_basis_matrix", BY_CONTROL.T, DRIVEN, "right", "a matrix"),
    Case("chain_basis_matrix", W.inv() * DRIVEN[0].A * W, DRIVEN, "right", "carried over"),
    Case(
        "chain_basis_matrix",
        np.array(BY_CONTROL.T.tolist(), dtype=float),
        DRIVEN,
        "right",
        "an array of floats",
    ),
    Case("chain_basis_matrix", [[0, a], [1, 1]], FREE_DRIVEN, "right", "with a parameter"),
    Case(
        "chain_basis_matrix", BY_CONTROL, DRIVEN, "wrong", "the controllable form: rows for columns"
    ),
    Case(
        "chain_basis_matrix",
        BY_OBSERVATION,
        DRIVEN,
        "wrong",
        "the observable form: the basis in reverse order",
    ),
    Case(
        "chain_basis_matrix", BY_OBSERVATION.T, DRIVEN, "wrong", "the coefficients in the first row"
    ),
    Case(
        "chain_basis_matrix",
        [[0, 0, -2], [1, 0, -2], [0, 1, 0]],
        DRIVEN,
        "wrong",
        "signs of the polynomial",
    ),
    Case(
        "chain_basis_matrix",
        [[0, 0, 0], [1, 0, 2], [0, 1, 2]],
        DRIVEN,
        "wrong",
        "the coefficients in the opposite order",
    ),
    Case(
        "chain_basis_matrix",
        W * DRIVEN[0].A * W.inv(),
        DRIVEN,
        "wrong",
        "the inverse on the wrong side",
    ),
    Case("chain_basis_matrix", W, DRIVEN, "wrong", "the basis itself"),
    Case("chain_basis_matrix", [[0, a], [1, -1]], FREE_DRIVEN, "wrong", "a sign, with a parameter"),
    Case("chain_basis_matrix", [[0, 2], [1, 2]], DRIVEN, "invalid", "another order"),
    Case("chain_basis_matrix", "companion", DRIVEN, "invalid", "text"),
    Case("canonical_change", T, SEEN, "right", "a matrix"),
    Case("canonical_change", np.array(T.tolist(), dtype=float), SEEN, "right", "an array"),
    Case("canonical_change", [[1, 1], [a - 1, 1]], FREE, "right", "with a parameter"),
    Case("canonical_change", T.inv(), SEEN, "wrong", "the inverse"),
    Case("canonical_change", 2 * T, SEEN, "wrong", "twice as large: z is not xi1"),
    Case(
        "canonical_change", M([[1, 0, 0], [0, 1, 0], [1, 1, 1]]), SEEN, "wrong", "Kalman's matrix"
    ),
    Case("canonical_change", [1, 2, 3], SEEN, "invalid", "a vector"),
    Case("canonical_change", P, DRIVEN, "right", "a matrix"),
    Case("canonical_change", P.tolist(), DRIVEN, "right", "nested lists"),
    Case("canonical_change", P.inv(), DRIVEN, "wrong", "the inverse"),
    Case("canonical_change", P[:, ::-1], DRIVEN, "wrong", "the columns in reverse order"),
    Case("canonical_change", P.T, DRIVEN, "wrong", "transposed"),
    Case("canonical_change", [[1, 0], [0, 1]], DRIVEN, "invalid", "another order"),
]
LIMITS = [
    "With parameters the matrices are judged at six rational values in general position; decimals "
    "count to three digits."
]
