"""The matrices of Kalman's criteria, Definitions 2.3 and 2.4 of the problem book.

    N = (H; HA; ...; HA^(n-1)),    W = (B, AB, ..., A^(n-1)B).

They serve exact systems. With floats their rank is worthless from about n = 12 on, because powers
of A differ by too many orders of magnitude: ask `observability` and `controllability`, which use
Popov's criterion there.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed


def observability_matrix(A, H=None):
    """The observability matrix N = (H; HA; ...; HA^(n-1)), mn x n (MATLAB: obsv).

    `A`: n x n, `H`: m x n, SymPy matrices or lists of rows (exact) or NumPy arrays (floats); a
    StateSpace in place of `A` brings its own `H`. Raises ValueError if `A` is not square, if `H`
    has not n columns, for entries not real. Source: Definition 2.3 of the problem book.

    >>> import sympy as sp
    >>> observability_matrix(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, -1]]), sp.Matrix([[1, 0, 0]]))
    Matrix([
    [1, 0, 0],
    [0, 1, 0],
    [1, 1, 1]])
    """
    return stacked_powers(*read_observed(A, H))


def controllability_matrix(A, B=None):
    """The controllability matrix W = (B, AB, ..., A^(n-1)B), n x ns (MATLAB: ctrb).

    `A`: n x n, `B`: n x s, exact or floats as in `observability_matrix`. Raises ValueError if `A`
    is not square, if `B` has not n rows, for entries not real. Source: Definition 2.4 of the
    problem book.

    >>> import sympy as sp
    >>> controllability_matrix(sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), sp.Matrix([0, 1, 0]))
    Matrix([
    [0,  1, 0],
    [1,  1, 2],
    [0, -1, 0]])
    """
    return stacked_powers(*read_controlled(A, B)).T


def stacked_powers(A, H):
    """(H; HA; ...; HA^(n-1)) of matrices that have been read."""
    blocks = [H]
    while len(blocks) < A.shape[0]:
        blocks.append(
            blocks[-1] @ A if isinstance(A, np.ndarray) else (blocks[-1] * A).applyfunc(sp.expand)
        )
    return np.vstack(blocks) if isinstance(A, np.ndarray) else sp.Matrix.vstack(*blocks)
