"""Reading a pair (A, H) or (A, B): exact matrices, arrays of floats, or a StateSpace of
python-control.

All mathematics of the package is written for observation; control is its dual, reached by
transposing: (A, B) is controllable exactly when (A^T, B^T) is observable.
"""

import numpy as np
import sympy as sp

from trajlib.stability.hurwitz import is_float_array, read_exact_matrix, read_float_matrix
from trajlib.stability.systems import exact_decimals


def read_observed(A, H, name="H"):
    """(A, H) as two SymPy matrices or two float arrays; H may be left out for a StateSpace, whose C
    it then is."""
    if is_state_space(A):
        A, H = A.A, A.C if H is None else H
    if H is None:
        raise ValueError(
            f"{name}: expected a matrix beside A (it may be left out only for a StateSpace)"
        )
    if is_float_array(A) or is_float_array(H):
        A, H = read_float_matrix(as_floats(A, "A")), as_floats(H, name)
        H = H[None, :] if H.ndim == 1 else H
    else:
        A, H = read_exact_matrix(A), read_exact_rectangle(H, name)
    if H.shape[1:] != A.shape[1:] or not H.shape[0]:
        hint = "; a scalar output is a matrix with one row" if H.shape == (A.shape[0], 1) else ""
        raise ValueError(
            f"{name}: expected a matrix with {A.shape[0]} columns, one for each state variable, "
            f"got shape {tuple(H.shape)}{hint}"
        )
    return A, H


def read_controlled(A, B):
    """The dual pair (A^T, B^T), ready for the mathematics of observation."""
    if is_state_space(A):
        A, B = A.A, A.B if B is None else B
    if B is None:
        raise ValueError("B: expected a matrix beside A (it may be left out only for a StateSpace)")
    if is_float_array(A) or is_float_array(B):
        A, B = read_float_matrix(as_floats(A, "A")), as_floats(B, "B")
        B = B[:, None] if B.ndim == 1 else B
    else:
        A, B = read_exact_matrix(A), read_exact_rectangle(B, "B", flat="column")
    if B.shape[:1] != A.shape[:1] or len(B.shape) != 2 or not B.shape[1]:
        hint = (
            "; a scalar control is a matrix with one column" if B.shape == (1, A.shape[0]) else ""
        )
        raise ValueError(
            f"B: expected a matrix with {A.shape[0]} rows, one for each state variable, "
            f"got shape {tuple(B.shape)}{hint}"
        )
    return A.T, B.T


def is_state_space(system):
    """Whether this is python-control's StateSpace (told by its attributes: the import takes a
    second)."""
    return hasattr(system, "nstates") and hasattr(system, "A") and hasattr(system, "C")


def as_floats(matrix, name):
    """An array of floats; a matrix with symbols beside one of floats is refused."""
    if is_float_array(matrix):
        if matrix.dtype.kind == "c":
            raise ValueError(f"{name}: expected a real matrix")
        result = matrix.astype(float)
    else:
        try:
            result = np.array(sp.Matrix(matrix).tolist(), dtype=float)
        except (TypeError, ValueError, sp.SympifyError):
            raise ValueError(
                f"{name}: floats and exact symbols stand in one system; write all of it exactly "
                "(SymPy)"
            ) from None
    if not np.all(np.isfinite(result)):
        raise ValueError(f"{name}: expected finite entries")
    return result


def read_exact_rectangle(matrix, name, flat="row"):
    """A real SymPy matrix of any shape with exact entries; a flat list is one row, or one
    column."""
    try:
        result = sp.Matrix(matrix)
    except (TypeError, ValueError, sp.SympifyError):
        raise TypeError(f"{name}: expected a matrix, got {matrix!r}") from None
    flat_list = (
        not isinstance(matrix, sp.MatrixBase) and np.ndim(np.array(matrix, dtype=object)) == 1
    )
    if flat_list and flat == "row":
        result = result.T
    result = result.applyfunc(exact_decimals)
    if result.has(sp.nan, sp.oo, -sp.oo, sp.zoo):
        raise ValueError(f"{name}: expected finite entries")
    if result.has(sp.I) or any(entry.is_real is False for entry in result):
        raise ValueError(f"{name}: expected a real matrix")
    return result.as_mutable()
