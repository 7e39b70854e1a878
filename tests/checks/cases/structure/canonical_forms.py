import numpy as np
import sympy as sp
from case import Case

a = sp.symbols("alpha", real=True)
M = sp.Matrix
# Its polynomial is lambda^3 - 2 lambda - 2.
PLANT = M([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
SEEN, DRIVEN = (PLANT, M([[1, 0, 0]])), (PLANT.T, M([1, 0, 0]))
BY_OBSERVATION, BY_CONTROL = M([[0, 1, 0], [2, 0, 1], [2, 0, 0]]), M([[0, 1, 0], [0, 0, 1], [2, 2, 0]])
T = M([[1, 0, 0], [0, 1, 0], [-1, 1, 1]])
P = M([[-1, 0, 1], [1, 1, 0], [1, 0, 0]])
FREE = (M([[0, 1], [a, 1]]), M([[1, 1]]), [a])
FREE_DRIVEN = (M([[0, 1], [a, 1]]), M([0, 1]), [a])
W = M.hstack(*[DRIVEN[0]**k * DRIVEN[1] for k in range(3)])

CASES = [
    Case("observer_canonical_matrix", BY_OBSERVATION, (PLANT,), "right", "a matrix"),
    Case("observer_canonical_matrix", BY_OBSERVATION.tolist(), (PLANT,), "right", "nested lists"),
    Case("observer_canonical_matrix", np.array(BY_OBSERVATION.tolist(), dtype=float), (PLANT,), "right",
         "an array of floats"),
    Case("observer_canonical_matrix", [[1, 1], [sp.Symbol("alpha"), 0]], (FREE[0], [a]), "right",
         "with a parameter, a plain symbol"),
    Case("observer_canonical_matrix", BY_CONTROL, (PLANT,), "wrong", "the form by control"),
    Case("observer_canonical_matrix", BY_OBSERVATION.T, (PLANT,), "wrong", "transposed"),
    Case("observer_canonical_matrix", [[0, 1, 0], [-2, 0, 1], [2, 0, 0]], (PLANT,), "wrong", "a sign"),
    Case("observer_canonical_matrix", [[2, 1, 0], [2, 0, 1], [0, 0, 0]], (PLANT,), "wrong",
         "the coefficients in the opposite order"),
    Case("observer_canonical_matrix", PLANT, (PLANT,), "wrong", "the matrix as given"),
    Case("observer_canonical_matrix", ..., (PLANT,), "missing", "the untouched stub"),
    Case("observer_canonical_matrix", [[0, 1], [2, 0]], (PLANT,), "invalid", "another order"),
    Case("controller_canonical_matrix", BY_CONTROL, (PLANT,), "right", "a matrix"),
    Case("controller_canonical_matrix", [[0, 1], [a, 1]], (FREE[0], [a]), "right", "with a parameter"),
    Case("controller_canonical_matrix", BY_OBSERVATION, (PLANT,), "wrong", "the form by observation"),
    Case("controller_canonical_matrix", [[0, 1, 0], [0, 0, 1], [2, -2, 0]], (PLANT,), "wrong", "a sign"),
    Case("controller_canonical_matrix", [[0, 1, 0], [0, 0, 2], [1, 1, 0]], (PLANT,), "wrong",
         "the eigenvalues of A in another shape"),
    Case("controller_canonical_matrix", [2, 2, 0], (PLANT,), "invalid", "the last row alone"),
    Case("chain_basis_matrix", BY_CONTROL.T, DRIVEN, "right", "a matrix"),
    Case("chain_basis_matrix", W.inv() * DRIVEN[0] * W, DRIVEN, "right", "carried over"),
    Case("chain_basis_matrix", np.array(BY_CONTROL.T.tolist(), dtype=float), DRIVEN, "right", "an array of floats"),
    Case("chain_basis_matrix", [[0, a], [1, 1]], FREE_DRIVEN, "right", "with a parameter"),
    Case("chain_basis_matrix", BY_CONTROL, DRIVEN, "wrong", "the form by control: rows for columns"),
    Case("chain_basis_matrix", BY_OBSERVATION, DRIVEN, "wrong", "the form by observation: the basis in reverse order"),
    Case("chain_basis_matrix", BY_OBSERVATION.T, DRIVEN, "wrong", "the coefficients in the first row"),
    Case("chain_basis_matrix", [[0, 0, -2], [1, 0, -2], [0, 1, 0]], DRIVEN, "wrong", "signs of the polynomial"),
    Case("chain_basis_matrix", [[0, 0, 0], [1, 0, 2], [0, 1, 2]], DRIVEN, "wrong",
         "the coefficients in the opposite order"),
    Case("chain_basis_matrix", W * DRIVEN[0] * W.inv(), DRIVEN, "wrong", "the inverse on the wrong side"),
    Case("chain_basis_matrix", W, DRIVEN, "wrong", "the basis itself"),
    Case("chain_basis_matrix", [[0, a], [1, -1]], FREE_DRIVEN, "wrong", "a sign, with a parameter"),
    Case("chain_basis_matrix", [[0, 2], [1, 2]], DRIVEN, "invalid", "another order"),
    Case("chain_basis_matrix", "companion", DRIVEN, "invalid", "text"),
    Case("observer_canonical_transformation", T, SEEN, "right", "a matrix"),
    Case("observer_canonical_transformation", np.array(T.tolist(), dtype=float), SEEN, "right", "an array"),
    Case("observer_canonical_transformation", [[1, 1], [a - 1, 1]], FREE, "right", "with a parameter"),
    Case("observer_canonical_transformation", T.inv(), SEEN, "wrong", "the inverse"),
    Case("observer_canonical_transformation", 2 * T, SEEN, "wrong", "twice as large: z is not xi1"),
    Case("observer_canonical_transformation", M([[1, 0, 0], [0, 1, 0], [1, 1, 1]]), SEEN, "wrong", "Kalman's matrix"),
    Case("observer_canonical_transformation", [1, 2, 3], SEEN, "invalid", "a vector"),
    Case("controller_canonical_basis", P, DRIVEN, "right", "a matrix"),
    Case("controller_canonical_basis", P.tolist(), DRIVEN, "right", "nested lists"),
    Case("controller_canonical_basis", P.inv(), DRIVEN, "wrong", "the inverse"),
    Case("controller_canonical_basis", P[:, ::-1], DRIVEN, "wrong", "the columns in reverse order"),
    Case("controller_canonical_basis", P.T, DRIVEN, "wrong", "transposed"),
    Case("controller_canonical_basis", [[1, 0], [0, 1]], DRIVEN, "invalid", "another order"),
]
LIMITS = ["With parameters the matrices are judged at six rational values in general position; decimals count to "
          "three digits."]
