"""Reading of covariances and weights: symmetric matrices that are positive (semi)definite.

A covariance that is not symmetric, or has a negative direction, would go through every formula of
chapter 4 and give numbers; so it is refused here.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_matrix, read_vector, require_square
from trajlib._real_symbols import vanishes

#: By how much, relative to its greatest entry, a covariance of floats may miss symmetry or fall
#: below zero: beyond rounding, below anything that is meant.
ROUNDING = 1e-10


#: What to do where a covariance of errors of measurement is singular.
EXACT = (
    "; an exact measurement (singular R) makes a part of the state known: leave that out of the state, "
    "or give the measurement a small variance"
)


def read_noise(R, order, floats):
    """Return the positive definite intensity or covariance R of the errors of measurement."""
    try:
        return read_covariance(R, "R", order, floats, definite=True)
    except ValueError as error:
        if "positive definite" not in str(error):
            raise
        raise ValueError(f"{error}{EXACT}") from None


def read_symmetric(matrix, name, order, floats):
    """Return a symmetric matrix of a given order or any."""
    matrix = read_matrix(matrix, name, order, order, floats)
    require_square(matrix, name)
    if floats:
        return _read_symmetric_floats(matrix[None], name)[0]
    if not all(vanishes(matrix[i, j] - matrix[j, i]) for i in range(matrix.rows) for j in range(i)):
        raise ValueError(f"{name}: expected a symmetric matrix")
    return matrix


def read_covariance(matrix, name, order, floats, definite=False):
    """Return a symmetric positive semidefinite (or `definite`) matrix of a given order or any."""
    matrix = read_symmetric(matrix, name, order, floats)
    kind = "positive definite" if definite else "positive semidefinite"
    if floats:
        _require_positive(matrix[None], name, kind, definite)
    elif _is_never_positive(matrix, definite):
        raise ValueError(f"{name}: expected a {kind} matrix, got {matrix.tolist()}")
    return matrix


def is_semidefinite(matrix):
    """Whether a symmetric matrix is positive semidefinite, for symbols unless it is known not to be."""
    if isinstance(matrix, np.ndarray):
        return bool(_least_eigenvalues(matrix[None])[0] >= -ROUNDING)
    return not _is_never_positive(matrix, False)


def definiteness(matrix):
    """Return 1 for a positive definite matrix of numbers, 0 for a singular semidefinite one, else -1.

    0 for floats that may be any of these but for rounding.
    """
    if isinstance(matrix, np.ndarray):
        least = _least_eigenvalues(matrix[None])[0]
        return int(np.sign(least)) if abs(least) > ROUNDING else 0
    if not _is_never_positive(matrix, True):
        return 1
    return -1 if _is_never_positive(matrix, False) else 0


def read_covariance_stack(matrices, name):
    """Return a stack of symmetric positive semidefinite arrays, of shape (N, n, n)."""
    matrices = _read_symmetric_floats(matrices, name)
    _require_positive(matrices, name, "positive semidefinite", False)
    return matrices


def _read_symmetric_floats(matrices, name):
    transposed = np.swapaxes(matrices, 1, 2)
    size = np.abs(matrices).max(axis=(1, 2))
    if (np.abs(matrices - transposed).max(axis=(1, 2)) > ROUNDING * size).any():
        raise ValueError(f"{name}: expected a symmetric matrix")
    return (matrices + transposed) / 2


def _require_positive(matrices, name, kind, definite):
    least = _least_eigenvalues(matrices).min()
    if least < -ROUNDING or (definite and not least > 0):
        raise ValueError(
            f"{name}: expected a {kind} matrix, its least eigenvalue "
            f"(after scaling to unit variances) is {least:.3g}"
        )


def _least_eigenvalues(matrices):
    """Return the least eigenvalues with each variable in units of its own.

    So metres beside radians are judged alike.
    """
    size = np.abs(matrices).max(axis=(1, 2))
    units = np.sqrt(np.maximum(np.einsum("kii->ki", matrices), 0))
    scale = np.where(units > 0, units, np.where(size > 0, np.sqrt(size), 1.0)[:, None])
    return np.linalg.eigvalsh(matrices / (scale[:, :, None] * scale[:, None, :]))[:, 0]


def read_measurement(H, z, R, order, floats, definite=True):
    """Return (H, z, R) of z = Hx + r; R left out is the unit matrix."""
    H = read_matrix(H, "H", None, order, floats)
    z = read_vector(z, "z", H.shape[0], floats)
    if R is None:
        R = np.eye(H.shape[0]) if floats else sp.eye(H.shape[0])
    return H, z, read_covariance(R, "R", H.shape[0], floats, definite)


def _is_never_positive(matrix, definite):
    """Whether an exact symmetric matrix is known not to be positive; with symbols it may be."""
    if matrix.free_symbols:
        minors = [
            *matrix.diagonal(),
            *(matrix.extract([j, i], [j, i]).det() for i in range(matrix.rows) for j in range(i)),
        ]
        return any(minor.is_negative or (definite and minor.is_zero) for minor in minors)
    complement = matrix
    while complement.rows:
        pivots = [sp.N(complement[i, i], 30) for i in range(complement.rows)]
        k = max(range(complement.rows), key=lambda i: pivots[i])
        if vanishes(complement[k, k]):
            # No diagonal entry is positive: then nothing but zeros may be left.
            return definite or not all(vanishes(entry) for entry in complement)
        if pivots[k] < 0:
            return True
        indices = [i for i in range(complement.rows) if i != k]
        column = complement.extract(indices, [k])
        complement = (
            complement.extract(indices, indices) - column * column.T / complement[k, k]
        ).applyfunc(sp.radsimp)
    return False
