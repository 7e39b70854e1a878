"""The states that the output never shows, and the states that a control reaches.

The kernel of N is the largest subspace inside the kernel of H that A maps into itself: a motion
that starts there has z = 0 for all time. The image of W is what can be reached from x = 0. One is
the orthogonal complement of the other for the transposed system.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers


def unobservable_subspace(A, H=None):
    """Basis of the initial states with z = 0 for all time (MATLAB: null(obsv(A, C))).

    `A`: n x n, `H`: m x n. Returns an n x k matrix whose columns are a basis (k = n - rank N, also
    0): exact input gives coprime whole entries, generic if there are symbols; floats give
    orthonormal columns, and a warning if rounding could make a state unobservable. Raises
    ValueError for shapes that do not fit. Source: Theorem 2.9 of the problem book.

    >>> import sympy as sp
    >>> unobservable_subspace(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), sp.Matrix([[0, 1, 0]])).T
    Matrix([[1, 0, -1]])
    """
    A, H = read_observed(A, H)
    if isinstance(A, np.ndarray):
        return floats.split_with_warning(A, H).unobservable
    return exact.null_columns(stacked_powers(A, H))


def controllable_subspace(A, B=None):
    """Basis of the states reached from x = 0 by some control (MATLAB: orth(ctrb(A, B))).

    `A`: n x n, `B`: n x s. Returns an n x k matrix, k = rank W, whose columns are the first
    independent columns of W (b, Ab, ...), generic if there are symbols; floats give orthonormal
    columns, and a warning if rounding could take a state away. Raises ValueError for shapes that do
    not fit. Source: Theorem 2.8 of the problem book.

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
