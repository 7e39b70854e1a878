"""The Kalman observability and controllability matrices, Definitions 2.3 and 2.4.

    N = (H; HA; ...; HA^(n-1)),    W = (B, AB, ..., A^(n-1)B).

They serve exact systems. With floats their rank is worthless from about n = 12 on, because powers
of A differ by too many orders of magnitude: ask `observability` and `controllability`, which use
the PBH test there.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike


@accepts_state_space(C="H")
def observability_matrix(A: MatrixLike, H: MatrixLike | None = None) -> Matrix:
    """Return the observability matrix N = (H; HA; ...; HA^(n-1)).

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; a StateSpace in place of it has its own `H`.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.

    Returns
    -------
    matrix, shape (m n, n)
        Exact for SymPy matrices or lists of rows, floats for NumPy arrays or a StateSpace.

    Raises
    ------
    ValueError
        If `A` is not square, if `H` has not n columns, or for entries that are not real.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``obsv``. Source: Definition 2.3 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> observability_matrix(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, -1]]), sp.Matrix([[1, 0, 0]]))
    Matrix([
    [1, 0, 0],
    [0, 1, 0],
    [1, 1, 1]])
    """
    return stacked_powers(*read_observed(A, H))


def controllability_matrix(A: MatrixLike, B: MatrixLike | None = None) -> Matrix:
    """Return the controllability matrix W = (B, AB, ..., A^(n-1)B).

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; a StateSpace in place of it has its own `B`.
    B : matrix_like, shape (n, s)
        Matrix of the control.

    Returns
    -------
    matrix, shape (n, n s)
        Exact for SymPy matrices or lists of rows, floats for NumPy arrays or a StateSpace.

    Raises
    ------
    ValueError
        If `A` is not square, if `B` has not n rows, or for entries that are not real.

    Notes
    -----
    MATLAB: ``ctrb``. Source: Definition 2.4 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> controllability_matrix(sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), sp.Matrix([0, 1, 0]))
    Matrix([
    [0,  1, 0],
    [1,  1, 2],
    [0, -1, 0]])
    """
    return stacked_powers(*read_controlled(A, B)).T


def stacked_powers(A, H):
    """Return (H; HA; ...; HA^(n-1)) of matrices that have been read."""
    blocks = [H]
    while len(blocks) < A.shape[0]:
        blocks.append(
            blocks[-1] @ A if isinstance(A, np.ndarray) else (blocks[-1] * A).applyfunc(sp.expand)
        )
    return np.vstack(blocks) if isinstance(A, np.ndarray) else sp.Matrix.vstack(*blocks)
