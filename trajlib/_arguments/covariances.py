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


def read_covariance(matrix, name, order, floats, definite=False):
    """Return a symmetric positive semidefinite (or `definite`) matrix of a given order or any."""
    matrix = read_matrix(matrix, name, order, order, floats)
    require_square(matrix, name)
    kind = "positive definite" if definite else "positive semidefinite"
    if floats:
        size = np.abs(matrix).max()
        if np.abs(matrix - matrix.T).max() > ROUNDING * size:
            raise ValueError(f"{name}: expected a symmetric matrix")
        matrix = (matrix + matrix.T) / 2
        # Each variable in units of its own, so that metres beside radians are judged alike.
        units = np.sqrt(np.maximum(np.diag(matrix), 0))
        scale = np.where(units > 0, units, np.sqrt(size) or 1)
        least = np.linalg.eigvalsh(matrix / np.outer(scale, scale))[0]
        if least < -ROUNDING or (definite and not least > 0):
            raise ValueError(
                f"{name}: expected a {kind} matrix, its least eigenvalue "
                f"(after scaling to unit variances) is {least:.3g}"
            )
        return matrix
    if not all(vanishes(matrix[i, j] - matrix[j, i]) for i in range(matrix.rows) for j in range(i)):
        raise ValueError(f"{name}: expected a symmetric matrix")
    if _is_never_positive(matrix, definite):
        raise ValueError(f"{name}: expected a {kind} matrix, got {matrix.tolist()}")
    return matrix


def read_measurement(H, z, R, order, floats):
    """Return (H, z, R) of z = Hx + r; R left out is the unit matrix."""
    H = read_matrix(H, "H", None, order, floats)
    z = read_vector(z, "z", H.shape[0], floats)
    if R is None:
        R = np.eye(H.shape[0]) if floats else sp.eye(H.shape[0])
    return H, z, read_covariance(R, "R", H.shape[0], floats, definite=True)


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
