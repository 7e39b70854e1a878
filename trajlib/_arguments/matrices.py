"""Reading of matrices, exact (SymPy) or floats (NumPy), and of the pairs (A, H) and (A, B).

A matrix is one of floats if it, or any other one of the same system, is a NumPy array of numbers
or a list of numbers with a float among them. Exact are SymPy matrices and lists of integers,
fractions and expressions; a decimal beside a symbol is the number that was written, 0.1 = 1/10.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.arrays import brief, plain_array, unwrapped
from trajlib._arguments.symbols import exact_decimals
from trajlib._typing import Matrix

#: What a matrix of any form holds, for messages.
MATRIX = "a matrix of real numbers"


def is_float_array(matrix):
    """Whether this is a NumPy array of numbers."""
    return isinstance(matrix, np.ndarray) and matrix.dtype.kind in "fiuc"


def any_floats(*matrices):
    """Whether any of the matrices, which may be None, is one of floats."""
    return any(has_floats(matrix) for matrix in matrices)


def has_floats(matrix):
    """Whether this is an array or a list of numbers, of floats or with a float among them."""
    matrix = unwrapped(matrix)
    if is_float_array(matrix):
        return True
    entries = list(_flattened(matrix))
    return any(
        isinstance(entry, float | np.floating) or is_float_array(entry) for entry in entries
    ) and not any(getattr(entry, "free_symbols", None) for entry in entries)


def _flattened(matrix):
    if isinstance(matrix, list | tuple) or (
        isinstance(matrix, np.ndarray) and matrix.dtype.kind == "O" and matrix.ndim
    ):
        for entry in matrix:
            yield from _flattened(entry)
    else:
        yield matrix


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
    array = plain_array(matrix, name, MATRIX)
    if array.ndim not in (1, 2):
        got = brief(matrix) if array.ndim == 0 else f"the shape {array.shape}"
        raise TypeError(f"{name}: expected {MATRIX}, got {got}")
    if array.ndim == 1:
        array = array[None, :] if flat == "row" else array[:, None]
    result = sp.Matrix(*array.shape, [_exact(entry, name) for entry in array.flat])
    if square:
        require_square(result, name)
    if result.has(sp.nan, sp.oo, -sp.oo, sp.zoo):
        raise ValueError(f"{name}: expected finite entries")
    if result.has(sp.I) or any(entry.is_real is False for entry in result):
        raise ValueError(f"{name}: expected a real matrix")
    return result


def _exact(entry, name):
    try:
        result = sp.sympify(entry, strict=True)
    except (sp.SympifyError, TypeError, ValueError):
        result = None
    if not isinstance(result, sp.Expr):
        raise TypeError(f"{name}: expected {MATRIX}, got {brief(entry)}")
    return exact_decimals(result)


def read_float_matrix(matrix, name="A", square=False):
    """Return an array of finite floats; symbols, also in a matrix beside floats, are refused.

    It is stored by rows: LAPACK rounds the same matrix stored by columns otherwise.
    """
    result = _finite_floats(plain_array(matrix, name, MATRIX), name, matrix)
    if square:
        require_square(result, name)
    return result


def _finite_floats(array, name, given):
    try:
        result = array.astype(float, order="C")
    except OverflowError:
        raise ValueError(f"{name}: an entry is beyond all floats") from None
    except (TypeError, ValueError):
        if not any(getattr(entry, "free_symbols", None) for entry in array.flat):
            raise TypeError(f"{name}: expected {MATRIX}, got {brief(given)}") from None
        raise ValueError(
            f"{name}: floats and exact symbols stand in one system; write all of it exactly (SymPy)"
        ) from None
    if not np.isfinite(result).all():
        raise ValueError(f"{name}: expected finite entries")
    return result


def require_square(matrix, name):
    """Raise ValueError unless a matrix is square and not empty."""
    shape = tuple(matrix.shape)
    if len(shape) != 2 or shape[0] != shape[1] or not shape[0]:
        raise ValueError(f"{name}: expected a square matrix, got shape {shape}")


def read_matrix(matrix, name, rows, columns, floats, flat="row"):
    """Return a matrix of the shape (rows, columns), None for any number.

    A flat list is one row, or one "column"; a scalar is 1 x 1.
    """
    if matrix is None:
        raise ValueError(f"{name}: expected a matrix")
    array = plain_array(matrix, name, MATRIX)
    array = array if array.ndim else array.reshape(1)
    if not floats:
        result = read_exact_matrix(array, name, flat)
    else:
        result = _finite_floats(array, name, matrix)
        if result.ndim == 1:
            result = result[None, :] if flat == "row" else result[:, None]
    shape = tuple(result.shape)
    if (
        len(shape) != 2
        or 0 in shape
        or not (rows in (None, shape[0]) and columns in (None, shape[1]))
    ):
        size = " x ".join("any" if part is None else str(part) for part in (rows, columns))
        raise ValueError(f"{name}: expected a matrix {size}, got the shape {shape}")
    return result


def read_square(matrix, name, floats):
    """Return a square matrix; a scalar is 1 x 1."""
    matrix = read_matrix(matrix, name, None, None, floats)
    require_square(matrix, name)
    return matrix


def read_vector(vector, name, length, floats):
    """Return a column of SymPy expressions, or a flat array; `length` None for any."""
    array = plain_array(vector, name, "a vector of real numbers")
    if array.ndim > 2 or (array.ndim == 2 and 1 not in array.shape):
        raise ValueError(f"{name}: expected a vector, got the shape {array.shape}")
    row = read_matrix(array.reshape(-1), name, None, None, floats)
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
    return A.T.copy(), B.T.copy()  # stored by rows, as a pair (A, H) that is given
