"""Reading of matrices, exact (SymPy) or floats (NumPy), and of the pairs (A, H) and (A, B).

A matrix is one of floats if it, or any other one of the same system, is a NumPy array of numbers
or a list of numbers with a float among them. Exact are SymPy matrices and lists of integers,
fractions and expressions; a decimal beside a symbol is the number that was written, 0.1 = 1/10.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.symbols import exact_decimals
from trajlib._typing import Matrix


def is_float_array(matrix):
    """Whether this is a NumPy array of numbers."""
    return isinstance(matrix, np.ndarray) and matrix.dtype.kind in "fiuc"


def any_floats(*matrices):
    """Whether any of the matrices, which may be None, is one of floats."""
    return any(has_floats(matrix) for matrix in matrices)


def has_floats(matrix):
    """Whether this is a NumPy array of numbers, a float or a list of numbers with a float."""
    if not isinstance(matrix, (list, tuple)):
        return is_float_array(matrix) or isinstance(matrix, float)
    entries = list(_flattened(matrix))
    return any(isinstance(entry, float) or is_float_array(entry) for entry in entries) and not any(
        isinstance(entry, (sp.Basic, sp.MatrixBase)) and entry.free_symbols for entry in entries
    )


def _flattened(matrix):
    for entry in matrix:
        if isinstance(entry, (list, tuple)):
            yield from _flattened(entry)
        else:
            yield entry


def require_exact(instead, **matrices):
    """Raise ValueError if a matrix is one of floats; `instead` names what is for these."""
    for name, matrix in matrices.items():
        if has_floats(matrix):
            raise ValueError(
                f"{name}: expected exact entries (SymPy, integers, fractions); for floats {instead}"
            )


def is_state_space(system):
    """Whether this is python-control's StateSpace, by its attributes: the import takes a second."""
    return hasattr(system, "nstates") and hasattr(system, "A") and hasattr(system, "C")


def read_exact_matrix(matrix, name="A", flat="row", square=False):
    """Return a real SymPy matrix with exact entries; a flat list is one row, or one "column"."""
    try:
        result = sp.Matrix(matrix)
    except (TypeError, ValueError, sp.SympifyError):
        raise TypeError(f"{name}: expected a matrix, got {matrix!r}") from None
    flat_list = (
        not isinstance(matrix, sp.MatrixBase) and np.ndim(np.array(matrix, dtype=object)) == 1
    )
    if flat_list and flat == "row":
        result = result.T
    if square:
        require_square(result, name)
    result = result.applyfunc(exact_decimals)
    if result.has(sp.nan, sp.oo, -sp.oo, sp.zoo):
        raise ValueError(f"{name}: expected finite entries")
    if result.has(sp.I) or any(entry.is_real is False for entry in result):
        raise ValueError(f"{name}: expected a real matrix")
    return result


def read_float_matrix(matrix, name="A", square=False):
    """Return an array of finite floats; symbols, also in a matrix beside floats, are refused."""
    if is_float_array(matrix):
        if matrix.dtype.kind == "c":
            raise ValueError(f"{name}: expected a real matrix")
        result = matrix.astype(float)
    else:
        try:
            result = np.array(
                matrix.tolist() if isinstance(matrix, sp.MatrixBase) else matrix, dtype=float
            )
        except (TypeError, ValueError):
            raise ValueError(
                f"{name}: floats and exact symbols stand in one system; write all of it exactly "
                "(SymPy)"
            ) from None
    if square:
        require_square(result, name)
    if not np.all(np.isfinite(result)):
        raise ValueError(f"{name}: expected finite entries")
    return result


def require_square(matrix, name):
    """Raise ValueError unless a matrix is square and not empty."""
    shape = tuple(matrix.shape)
    if len(shape) != 2 or shape[0] != shape[1] or not shape[0]:
        raise ValueError(f"{name}: expected a square matrix, got shape {shape}")


def read_matrix(matrix, name, rows, columns, floats):
    """Return a matrix of the shape (rows, columns), None for any number.

    A flat list is one row, a scalar is 1 x 1.
    """
    if matrix is None:
        raise ValueError(f"{name}: expected a matrix")
    array = is_float_array(matrix)
    depth = np.ndim(matrix) if array else np.array(matrix, dtype=object).ndim
    nested = matrix if depth or (floats and array) else [matrix]
    if floats:
        result = read_float_matrix(nested, name)
        # A flat list has become a column on its way.
        result = result.reshape(1, -1) if depth < 2 else result
    else:
        result = read_exact_matrix(nested, name)
    shape = tuple(
        actual if size is None else size for size, actual in zip((rows, columns), result.shape)
    )
    if tuple(result.shape) != shape or 0 in shape:
        size = " x ".join("any" if part is None else str(part) for part in (rows, columns))
        raise ValueError(f"{name}: expected a matrix {size}, got the shape {tuple(result.shape)}")
    return result


def read_square(matrix, name, floats):
    """Return a square matrix; a scalar is 1 x 1."""
    matrix = read_matrix(matrix, name, None, None, floats)
    require_square(matrix, name)
    return matrix


def read_vector(vector, name, length, floats):
    """Return a column of SymPy expressions, or a flat array; `length` None for any."""
    shape = tuple(np.shape(vector) if not isinstance(vector, sp.MatrixBase) else vector.shape)
    if len(shape) > 2 or (len(shape) == 2 and 1 not in shape):
        raise ValueError(f"{name}: expected a vector, got the shape {shape}")
    if is_float_array(vector):
        flat = vector.reshape(-1)
    else:
        flat = list(np.array(vector, dtype=object).reshape(-1))
    row = read_matrix(flat, name, None, None, floats)
    if length is not None and row.shape[1] != length:
        raise ValueError(
            f"{name}: expected {length} component{'s' * (length != 1)}, got {row.shape[1]}"
        )
    return row[0] if floats else row.T


def read_observed(A, H, name="H") -> tuple[Matrix, Matrix]:
    """Return the pair (A, H), both exact or both floats; a StateSpace in place of A has its own."""
    if is_state_space(A):
        A, H = A.A, A.C if H is None else H
    if H is None:
        raise ValueError(
            f"{name}: expected a matrix beside A (it may be left out only for a StateSpace)"
        )
    if any_floats(A, H):
        A, H = read_float_matrix(A, square=True), read_float_matrix(H, name)
        H = H[None, :] if H.ndim == 1 else H
    else:
        A, H = read_exact_matrix(A, square=True), read_exact_matrix(H, name)
    if H.shape[1:] != A.shape[1:] or not H.shape[0]:
        hint = "; a scalar output is a matrix with one row" if H.shape == (A.shape[0], 1) else ""
        raise ValueError(
            f"{name}: expected a matrix with {A.shape[0]} columns, one for each state variable, "
            f"got shape {tuple(H.shape)}{hint}"
        )
    return A, H


def read_controlled(A, B) -> tuple[Matrix, Matrix]:
    """Return the dual pair (A^T, B^T) of (A, B), which is observable if (A, B) is controllable."""
    if is_state_space(A):
        A, B = A.A, A.B if B is None else B
    if B is None:
        raise ValueError("B: expected a matrix beside A (it may be left out only for a StateSpace)")
    if any_floats(A, B):
        A, B = read_float_matrix(A, square=True), read_float_matrix(B, "B")
        B = B[:, None] if B.ndim == 1 else B
    else:
        A, B = read_exact_matrix(A, square=True), read_exact_matrix(B, "B", flat="column")
    if B.shape[:1] != A.shape[:1] or len(B.shape) != 2 or not B.shape[1]:
        hint = (
            "; a scalar control is a matrix with one column" if B.shape == (1, A.shape[0]) else ""
        )
        raise ValueError(
            f"B: expected a matrix with {A.shape[0]} rows, one for each state variable, "
            f"got shape {tuple(B.shape)}{hint}"
        )
    return A.T, B.T
