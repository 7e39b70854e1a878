"""The unobservable subspace and the controllable subspace of a linear system.

The kernel of N is the largest subspace inside the kernel of H that A maps into itself: a motion
that starts there has z = 0 for all time. The image of W is the set of states that are reached from
x = 0. One is the orthogonal complement of the other for the transposed system.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers


@accepts_state_space(C="H")
def unobservable_subspace(A: MatrixLike, H: MatrixLike | None = None) -> Matrix:
    """Return a basis of the initial states with z = 0 for all time.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; a StateSpace in place of it has its own `H`.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.

    Returns
    -------
    matrix, shape (n, k)
        Columns of a basis, k = n - rank N (also 0). Exact input gives coprime integer entries,
        generic if there are symbols; floats give orthonormal columns, and a warning if rounding
        could make a state unobservable.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``null(obsv(A, C))``. Source: Theorem 2.9 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> unobservable_subspace(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), sp.Matrix([[0, 1, 0]])).T
    Matrix([[1, 0, -1]])
    """
    A, H = read_observed(A, H)
    if isinstance(A, np.ndarray):
        return floats.split_with_warning(A, H).unobservable
    return exact.null_columns(stacked_powers(A, H))


def controllable_subspace(A: MatrixLike, B: MatrixLike | None = None) -> Matrix:
    """Return a basis of the states that some control reaches from x = 0.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; a StateSpace in place of it has its own `B`.
    B : matrix_like, shape (n, s)
        Matrix of the control.

    Returns
    -------
    matrix, shape (n, k)
        The first k = rank W independent columns of W (b, Ab, ...), generic if there are symbols;
        floats give orthonormal columns, and a warning if rounding could make a state
        uncontrollable.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    MATLAB: ``orth(ctrb(A, B))``. Source: Theorem 2.8 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> controllable_subspace(sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), sp.Matrix([0, 1, 0])).T
    Matrix([
    [0, 1,  0],
    [1, 1, -1]])
    """
    A, H = read_controlled(A, B)
    if isinstance(A, np.ndarray):
        return floats.split_with_warning(A, H).complement
    powers = stacked_powers(A, H)
    chosen = list(exact.independent_rows(powers))
    return powers.extract(chosen, list(range(A.rows))).T if chosen else sp.zeros(A.rows, 0)
