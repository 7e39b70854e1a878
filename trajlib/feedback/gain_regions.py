"""All gains that stabilise, as a region in their space.

The closed loop is A + BK for a feedback u = Kx, A + BKH for a static feedback u = Kz, A - LH for
the errors of an observer; its characteristic polynomial goes through the criterion of Hurwitz. The
entries of a gain may be zero, equal or any expressions of its symbols: a feedback of part of the
coordinates is one with zeros.
"""

import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_exact_matrix, read_observed
from trajlib.stability.regions import stability_conditions


def stabilising_gains(A, B, K, H=None, parameters=None, margin=0):
    """The values of the symbols in K for which u = Kx, or with `H` the static feedback u = Kz,
    stabilises.

    `A`: n x n, `B`: n x s; `K`: s x n, or s x m with `H`: m x n, of symbols and expressions.
    `parameters`: all symbols of the system, by default those of K. `margin` mu asks for Re lambda <
    -mu. Returns `StabilityConditions`, whose region is `sp.false` if no gain will do. Raises
    ValueError for shapes that do not fit and symbols not named. Source: examples 4, 5 and 7 of the
    problem book.

    >>> import sympy as sp
    >>> k1, k2 = sp.symbols("k1 k2")
    >>> A, B = sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1])
    >>> stabilising_gains(A, B, [k1, k2]).region
    (k1 < -1) & (k2 < 0)
    >>> stabilising_gains(A, B, [k1], H=sp.Matrix([[1, 1]])).region
    k1 < -1
    """
    A, B = (matrix.T for matrix in read_controlled(A, B))
    K = read_exact_matrix(K, "K")
    measured = sp.eye(A.rows) if H is None else read_observed(A, H)[1]
    if K.shape != (B.cols, measured.rows):
        raise ValueError(f"K: expected shape {(B.cols, measured.rows)}, got {K.shape}")
    return stability_conditions(A + B * K * measured, _named(K, parameters), margin=margin)


def convergent_gains(A, H, L, parameters=None, margin=0):
    """The values of the symbols in L for which the errors of the observer, A - LH, decay.

    `A`: n x n, `H`: m x n; `L`: n x m, of symbols and expressions; the rest as in
    `stabilising_gains`. Source: equation (3.3) and example 1 of the problem book.

    >>> import sympy as sp
    >>> l1, l2 = sp.symbols("l1 l2")
    >>> convergent_gains(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 0]]), [l1, l2]).region
    (l1 > 0) & (l2 > 1)
    """
    A, H = read_observed(A, H)
    L = read_exact_matrix(L, "L", flat="column")
    if L.shape != (A.rows, H.rows):
        raise ValueError(f"L: expected shape {(A.rows, H.rows)}, got {L.shape}")
    return stability_conditions(A - L * H, _named(L, parameters), margin=margin)


def _named(gain, parameters):
    return sorted(gain.free_symbols, key=str) if parameters is None else parameters
