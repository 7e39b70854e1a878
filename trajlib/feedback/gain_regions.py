"""Stabilising gains as a region in the space of their entries.

The closed loop is A + BK for a feedback u = Kx, A + BKH for a static feedback u = Kz, A - LH for
the errors of an observer; its characteristic polynomial is tested by the Hurwitz criterion. The
entries of a gain may be zero, equal or any expressions of its symbols: a feedback of part of the
coordinates is one with zeros.
"""

import sympy as sp

from trajlib._arguments.matrices import (
    read_controlled,
    read_exact_matrix,
    read_observed,
    require_exact,
)
from trajlib._arguments.renamed import renamed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import ExprLike, MatrixLike, Symbols
from trajlib.stability.regions import StabilityConditions, stability_conditions


@renamed(margin="degree")
@accepts_state_space("A", "B", C="H")
def stabilising_gains(
    A: MatrixLike,
    B: MatrixLike,
    K: MatrixLike,
    H: MatrixLike | None = None,
    parameters: Symbols | None = None,
    degree: ExprLike = 0,
) -> StabilityConditions:
    """Return the values of the symbols in K for which u = Kx, or u = Kz, stabilises the system.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu, exact.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    K : matrix_like, shape (s, n), with `H` shape (s, m)
        The gain, of symbols and expressions.
    H : matrix_like, shape (m, n), optional
        Matrix of the output, for the static feedback u = Kz, z = Hx.
    parameters : sequence of sympy.Symbol, optional
        All symbols of the system, by default those of K.
    degree : float or sympy.Expr, default 0
        mu >= 0, for Re lambda < -mu.

    Returns
    -------
    StabilityConditions
        Its `region` is `sp.false` if no gain stabilises.

    Raises
    ------
    ValueError
        If shapes do not fit, or for symbols that are not named.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    Source: examples 4, 5 and 7 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> k1, k2 = sp.symbols("k1 k2")
    >>> A, B = sp.Matrix([[0, 1], [7, 5]]), sp.Matrix([0, 1])
    >>> stabilising_gains(A, B, [k1, k2]).region
    (k1 < -7) & (k2 < -5)
    >>> stabilising_gains(A, B, [k1], H=sp.Matrix([[1, 1]])).region
    k1 < -7
    """
    require_exact("use place, which gives one gain (trajlib.feedback)", A=A, B=B, H=H)
    A, B = (matrix.T for matrix in read_controlled(A, B))
    K = read_exact_matrix(K, "K")
    measured = sp.eye(A.rows) if H is None else read_observed(A, H)[1]
    if K.shape != (B.cols, measured.rows):
        raise ValueError(f"K: expected shape {(B.cols, measured.rows)}, got {K.shape}")
    return stability_conditions(A + B * K * measured, _named(K, parameters), degree=degree)


@renamed(margin="degree")
@accepts_state_space("A", "H", C="H")
def convergent_gains(
    A: MatrixLike,
    H: MatrixLike,
    L: MatrixLike,
    parameters: Symbols | None = None,
    degree: ExprLike = 0,
) -> StabilityConditions:
    """Return the values of the symbols in L for which the errors of the observer, A - LH, decay.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax, exact.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.
    L : matrix_like, shape (n, m)
        The gain, of symbols and expressions.
    parameters : sequence of sympy.Symbol, optional
        All symbols of the system, by default those of L.
    degree : float or sympy.Expr, default 0
        mu >= 0, for Re lambda < -mu.

    Returns
    -------
    StabilityConditions
        Its `region` is `sp.false` if the errors decay for no gain.

    Raises
    ------
    ValueError
        If shapes do not fit, or for symbols that are not named.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    Source: equation (3.3) and example 1 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> l1, l2 = sp.symbols("l1 l2")
    >>> convergent_gains(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 0]]), [l1, l2]).region
    (l1 > 0) & (l2 > 1)
    """
    require_exact(
        "use place, which gives one gain, -place(A.T, H.T, eigenvalues).gain.T (trajlib.feedback)",
        A=A,
        H=H,
    )
    A, H = read_observed(A, H)
    L = read_exact_matrix(L, "L", flat="column")
    if L.shape != (A.rows, H.rows):
        raise ValueError(f"L: expected shape {(A.rows, H.rows)}, got {L.shape}")
    return stability_conditions(A - L * H, _named(L, parameters), degree=degree)


def _named(gain, parameters):
    return sorted(gain.free_symbols, key=str) if parameters is None else parameters
