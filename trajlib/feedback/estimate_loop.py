"""Feedback by an estimate, u = K e, and the separation of its spectrum, (3.7) - (3.10).

With the error d = x - e the plant and the observer are

    x' = (A + BK) x - BK d
    d' = (A - LH) d

so the characteristic polynomial of the whole is the product of the two, and K and L are chosen
independently. A measurement with an error c w, w' = S w, adds w to what the observer estimates,
while the control uses the estimate of x alone.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import (
    read_controlled,
    read_exact_matrix,
    read_observed,
    require_exact,
)
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import MatrixLike
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure.decomposition import named_matrices
from trajlib.structure.measurement_errors import with_measurement_error


@dataclass(frozen=True)
class EstimateLoop:
    """A plant under feedback by an estimate of its state.

    Attributes
    ----------
    errors : sympy.Matrix
        Matrix of (x; d), block triangular, d the error of the estimate (with that of w below it).
    estimates : sympy.Matrix
        For measurements without error the matrix of (x; e), plant and observer as they are built (3.8),
        (3.9); with an error that of (x; w; e), which also has the eigenvalues of S.
    regulator : sympy.Matrix
        The block A + BK.
    observer : sympy.Matrix
        The block A - LH.
    """

    errors: sp.Matrix
    estimates: sp.Matrix
    regulator: sp.Matrix
    observer: sp.Matrix

    def polynomials(self, symbol: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
        """Return the characteristic polynomials of the regulator and of the observer.

        Parameters
        ----------
        symbol : sympy.Symbol
            Variable of the polynomials.

        Returns
        -------
        tuple of sympy.Expr
            The two polynomials; their product is that of `errors`.
        """
        return characteristic_polynomial(self.regulator, symbol), characteristic_polynomial(
            self.observer, symbol
        )

    def _repr_latex_(self):
        return named_matrices(
            {r"\begin{pmatrix} x\\ \Delta x\end{pmatrix}^{\!\cdot}:\;": self.errors}
        )


@accepts_state_space("A", "B", "H", C="H")
def feedback_by_estimate(
    A: MatrixLike,
    B: MatrixLike,
    H: MatrixLike,
    K: MatrixLike,
    L: MatrixLike,
    S: MatrixLike | None = None,
    c: MatrixLike | None = None,
) -> EstimateLoop:
    """Return the closed loop of a plant, its observer and u = K e.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu, exact.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.
    K : matrix_like, shape (s, n)
        Gain of the regulator, u = Ke.
    L : matrix_like, shape (n, m), with `S` shape (n + k, m)
        Gain of the observer.
    S : matrix_like, shape (k, k), optional
        Matrix of the error of measurement, w' = S w (a constant: [[0]]).
    c : matrix_like, shape (m, k), optional
        The measurement is z = Hx + c w.

    Returns
    -------
    EstimateLoop
        The matrices of the loop.

    Raises
    ------
    ValueError
        If shapes do not fit, or if only one of `S` and `c` is given.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``reg(sys, -K, L)``, closed. Source: equations (3.8) - (3.10), example 8 of the problem
    book.

    Examples
    --------
    >>> import sympy as sp
    >>> s, k1, k2, l1, l2 = sp.symbols("s k1 k2 l1 l2")
    >>> loop = feedback_by_estimate(sp.Matrix([[0, 1], [0, -1]]), sp.Matrix([0, 1]), sp.Matrix([[1, 0]]),
    ...                             sp.Matrix([[k1, k2]]), sp.Matrix([l1, l2]))
    >>> loop.polynomials(s)
    (-k1 - k2*s + s**2 + s, l1*s + l1 + l2 + s**2 + s)
    >>> whole = loop.estimates.charpoly(s).as_expr()
    >>> sp.expand(whole - sp.prod(loop.polynomials(s)))
    0
    """
    require_exact("join the blocks with numpy.block", A=A, B=B, H=H, K=K, L=L, S=S, c=c)
    A, B = (matrix.T for matrix in read_controlled(A, B))
    A, H = read_observed(A, H)
    K, L = read_exact_matrix(K, "K"), read_exact_matrix(L, "L", flat="column")
    if (S is None) != (c is None):
        raise ValueError("S, c: expected both or neither")
    n, m = A.rows, H.rows
    larger, output = (A, H) if S is None else with_measurement_error(A, H, S, c)
    extra = larger.rows - n
    if K.shape != (B.cols, n):
        raise ValueError(f"K: expected shape {(B.cols, n)}, got {K.shape}")
    if L.shape != (n + extra, m):
        raise ValueError(f"L: expected shape {(n + extra, m)}, got {L.shape}")
    push, wide = B * K, K.row_join(sp.zeros(B.cols, extra))
    control = B.col_join(sp.zeros(extra, B.cols)) * wide
    regulated, observed = A + push, larger - L * output
    return EstimateLoop(
        errors=_blocks(regulated, -B * wide, sp.zeros(n + extra, n), observed),
        estimates=_blocks(larger, control, L * output, observed + control),
        regulator=regulated,
        observer=observed,
    )


def _blocks(first, second, third, fourth):
    return first.row_join(second).col_join(third.row_join(fourth))
