"""Reading what is given: exact matrices, or floats as soon as one of them is an array; covariances
are held to theirs.

A covariance that is not symmetric, or has a negative direction, would go through every formula of
the chapter and give numbers; so it is refused here.
"""

import numpy as np
import sympy as sp

from trajlib.stability.hurwitz import is_float_array
from trajlib.stability.systems import vanishes
from trajlib.structure.pairs import as_floats, read_exact_rectangle

#: By how much, relative to its greatest entry, a covariance of floats may miss symmetry or fall
#: below zero: beyond rounding, below anything that is meant.
ROUNDING = 1e-10


def in_floats(*given):
    """Whether any of the arguments, which may be None, is an array of floats."""
    return any(is_float_array(matrix) for matrix in given)


def read_matrix(given, name, rows, columns, floats):
    """A matrix of the shape (rows, columns), None for any number; a flat list is one row, a scalar
    is 1 x 1."""
    if given is None:
        raise ValueError(f"{name}: expected a matrix")
    depth = np.ndim(given) if is_float_array(given) else np.array(given, dtype=object).ndim
    if floats:
        matrix = as_floats(given if depth or is_float_array(given) else [given], name)
        # A flat list has become a column on its way.
        matrix = matrix.reshape(1, -1) if depth < 2 else matrix
    else:
        matrix = read_exact_rectangle(given if depth else [given], name)
    wanted = tuple(
        actual if size is None else size for size, actual in zip((rows, columns), matrix.shape)
    )
    if tuple(matrix.shape) != wanted or 0 in wanted:
        size = " x ".join("any" if part is None else str(part) for part in (rows, columns))
        raise ValueError(f"{name}: expected a matrix {size}, got the shape {tuple(matrix.shape)}")
    return matrix


def read_square(given, name, floats):
    matrix = read_matrix(given, name, None, None, floats)
    if matrix.shape[0] != matrix.shape[1]:
        raise ValueError(f"{name}: expected a square matrix, got the shape {tuple(matrix.shape)}")
    return matrix


def read_vector(given, name, length, floats):
    """A column of SymPy expressions, or a flat array; `length` None for any."""
    flat = (np.array(given, dtype=object) if not is_float_array(given) else given).reshape(-1)
    shape = np.shape(given) if not isinstance(given, sp.MatrixBase) else given.shape
    if len(shape) > 2 or (len(shape) == 2 and 1 not in shape):
        raise ValueError(f"{name}: expected a vector, got the shape {tuple(shape)}")
    row = read_matrix(list(flat) if not is_float_array(flat) else flat, name, None, None, floats)
    if length is not None and row.shape[1] != length:
        raise ValueError(
            f"{name}: expected {length} component{'s' * (length != 1)}, got {row.shape[1]}"
        )
    return row[0] if floats else row.T


def read_covariance(given, name, order, floats, definite=False):
    """A symmetric matrix, order x order, that is positive semidefinite, or definite where that is
    asked for."""
    matrix = read_matrix(given, name, order, order, floats)
    if matrix.shape[0] != matrix.shape[1]:
        raise ValueError(f"{name}: expected a square matrix, got the shape {tuple(matrix.shape)}")
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
                f"{name}: expected a {_kind(definite)} matrix, its least eigenvalue "
                f"(after scaling to unit variances) is {least:.3g}"
            )
        return matrix
    if not all(vanishes(matrix[i, j] - matrix[j, i]) for i in range(matrix.rows) for j in range(i)):
        raise ValueError(f"{name}: expected a symmetric matrix")
    if _refuted(matrix, definite):
        raise ValueError(f"{name}: expected a {_kind(definite)} matrix, got {matrix.tolist()}")
    return matrix


def read_measurement(H, z, R, order, floats):
    """(H, z, R) of z = Hx + r; R left out is the unit matrix."""
    H = read_matrix(H, "H", None, order, floats)
    z = read_vector(z, "z", H.shape[0], floats)
    if R is None:
        R = np.eye(H.shape[0]) if floats else sp.eye(H.shape[0])
    return H, z, read_covariance(R, "R", H.shape[0], floats, definite=True)


def _kind(definite):
    return "positive definite" if definite else "positive semidefinite"


def _refuted(matrix, definite):
    """Whether an exact symmetric matrix is known not to be positive; one with symbols gets the
    benefit of the doubt."""
    if matrix.free_symbols:
        minors = [
            *matrix.diagonal(),
            *(matrix.extract([j, i], [j, i]).det() for i in range(matrix.rows) for j in range(i)),
        ]
        return any(minor.is_negative or (definite and minor.is_zero) for minor in minors)
    rest = matrix
    while rest.rows:
        pivots = [sp.N(rest[i, i], 30) for i in range(rest.rows)]
        k = max(range(rest.rows), key=lambda i: pivots[i])
        if vanishes(rest[k, k]):
            # No diagonal entry is positive: then nothing but zeros may be left.
            return definite or not all(vanishes(entry) for entry in rest)
        if pivots[k] < 0:
            return True
        others = [i for i in range(rest.rows) if i != k]
        column = rest.extract(others, [k])
        rest = (rest.extract(others, others) - column * column.T / rest[k, k]).applyfunc(sp.radsimp)
    return False
