"""The reduced-order observer, which estimates only what is not measured (Luenberger).

Take z and y = Cx for coordinates, x = Pz + Qy. Then y' = A22 y + A21 z + B2 u, and z' - A11 z - B1
u = A12 y is known of y. The estimate of y is p + Gz with

    p' = (A22 - G A12)(p + Gz) + (A21 - G A11) z + (B2 - G B1) u,

in which no derivative of z is needed; its error obeys d' = (A22 - G A12) d, and the pair (A22, A12)
is observable exactly when (A, H) is.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed, require_exact
from trajlib._arguments.renamed import renamed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import ExprLike, MatrixLike
from trajlib.feedback.gains import GainFamily, observer
from trajlib.structure import exact


@dataclass(frozen=True)
class ReducedObserver:
    """The observer p' = `matrix` p + `by_output` z + `by_control` u.

    The estimate of x is `state_by_p` p + `state_by_output` z.

    Attributes
    ----------
    matrix : sympy.Matrix, shape (n - m, n - m)
        Matrix of p and also of the errors.
    by_output, by_control : sympy.Matrix
        Matrices of z and u in the equation of p.
    state_by_p, state_by_output : sympy.Matrix
        Matrices of p and z in the estimate of x.
    coordinates : sympy.Matrix
        C, the rows of y = Cx.
    family : GainFamily
        The gains G with their free symbols, which are zero in the matrices above.
    """

    matrix: sp.Matrix
    by_output: sp.Matrix
    by_control: sp.Matrix
    state_by_p: sp.Matrix
    state_by_output: sp.Matrix
    coordinates: sp.Matrix
    family: GainFamily


@renamed(margin="degree")
@accepts_state_space("A", "B", "H", C="H")
def reduced_observer(
    A: MatrixLike,
    B: MatrixLike,
    H: MatrixLike,
    polynomial: ExprLike | sp.Poly | None = None,
    symbol: sp.Symbol | None = None,
    *,
    eigenvalues: Sequence[ExprLike] | None = None,
    degree: ExprLike | None = None,
) -> ReducedObserver:
    """Return an observer of order n - m for m independent outputs, with a prescribed spectrum.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu, exact.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx, of rank m < n.
    polynomial : sympy.Expr or sympy.Poly, optional
        Characteristic polynomial of order n - m, as in `observer`.
    symbol : sympy.Symbol, optional
        Variable of `polynomial`.
    eigenvalues : sequence of number, optional
        The eigenvalues, as in `observer`.
    degree : float or sympy.Expr, optional
        The degree of stability, as in `observer`.

    Returns
    -------
    ReducedObserver
        The observer with the simplest of its gains.

    Raises
    ------
    ValueError
        If the outputs depend on one another or determine the whole state, if shapes do not fit, and as
        `observer`.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``place`` on a block. Source: added to the problem book; after D. G. Luenberger.

    Examples
    --------
    >>> import sympy as sp
    >>> found = reduced_observer(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), sp.Matrix([[1, 0]]), degree=2)
    >>> found.matrix, found.by_output, found.by_control
    (Matrix([[-2]]), Matrix([[-3]]), Matrix([[1]]))
    >>> found.state_by_p.T, found.state_by_output.T
    (Matrix([[0, 1]]), Matrix([[1, 2]]))
    """
    require_exact("use place for the block (A22, A12) of y and z (trajlib.feedback)", A=A, B=B, H=H)
    A, H = read_observed(A, H)
    B = read_controlled(A, B)[1].T
    n, m = A.rows, H.rows
    if exact.rank(H) < m or m == n:
        raise ValueError("H: expected fewer independent outputs than state variables")
    C = exact.null_columns(H).T
    T = H.col_join(C)
    back = exact.inverse(T)
    a, b = exact.product(T, A, back), exact.product(T, B)
    family = observer(
        a[m:, m:], a[:m, m:], polynomial, symbol, eigenvalues=eigenvalues, degree=degree
    )
    G = family.simplest
    matrix = exact.tidy(a[m:, m:] - G * a[:m, m:])
    return ReducedObserver(
        matrix,
        exact.tidy(matrix * G + a[m:, :m] - G * a[:m, :m]),
        exact.tidy(b[m:, :] - G * b[:m, :]),
        back[:, m:],
        exact.tidy(back[:, :m] + back[:, m:] * G),
        C,
        family,
    )
