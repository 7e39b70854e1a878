"""Observer and controller canonical forms, Theorem 2.7 of the problem book.

With Delta(lambda) = lambda^n - alpha_n lambda^(n-1) - ... - alpha_1 the coordinates of the observer
form are, as in example 1,

    xi_1 = h^T x,    xi_(k+1) = xi_k' - alpha_(n-k+1) xi_1,

so that the rows of T are f_1 = g_1 and f_k = g_k - alpha_n g_(k-1) - ... - alpha_(n-k+2) g_1 with
g_k = (A^T)^(k-1) h. The controller form is the transposed one of the dual system, with the
coordinates in the opposite order.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact, floats
from trajlib.structure.decomposition import holds_where, inverse, named_matrices
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.pbh import visible_symbol

_WORST_CONDITION = 1e12


@dataclass(frozen=True)
class CanonicalForm:
    """A pair in canonical form, in the coordinates xi = `transformation` x.

    Attributes
    ----------
    matrix : matrix, shape (n, n)
        T A T^-1.
    vector : matrix
        The row h^T T^-1 = (1, 0, ..., 0) or the column T b = (0, ..., 0, 1).
    transformation : matrix, shape (n, n)
        T.
    polynomial : sympy.Expr
        The characteristic polynomial in lambda.
    """

    matrix: Matrix
    vector: Matrix
    transformation: Matrix
    polynomial: sp.Expr

    @property
    def basis(self) -> Matrix:
        """Return the inverse of the transformation, x = `basis` xi."""
        return inverse(self.transformation)

    @property
    def where(self) -> sp.Basic:
        """Return the condition on the symbols under which this form exists, as in a `Decomposition`."""
        return holds_where(self.transformation, self.basis, self.matrix, self.vector)

    def _repr_latex_(self):
        row = self.vector.shape[0] == 1 < self.vector.shape[1]
        return named_matrices(
            {
                "A^0" if row else "A_0": self.matrix,
                r"h_0^\top" if row else "b_0": self.vector,
                "T": self.transformation,
            },
            self.where,
        )


@accepts_state_space(C="h")
def observer_canonical_form(A: MatrixLike, h: MatrixLike | None = None) -> CanonicalForm:
    """Return the observer canonical form of an observable pair with one output.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; exact or floats, or a StateSpace, which has its own `h`.
    h : matrix_like, shape (1, n)
        The row h^T; a column or a flat list of n numbers is read as h.

    Returns
    -------
    CanonicalForm
        First column (alpha_n, ..., alpha_1), ones above the diagonal, h_0^T = (1, 0, ..., 0), and T
        with xi = T x; with symbols for all values for which det N is not zero
        (`observability_conditions`).

    Raises
    ------
    ValueError
        If there are several outputs, or if the pair is not observable: then there is no such form.

    Notes
    -----
    MATLAB: ``canon``, "companion". Source: Definition 2.6, Theorem 2.7, example 1 of the problem
    book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = observer_canonical_form(sp.Matrix([[1, 1], [1, -1]]), sp.Matrix([[1, 0]]))
    >>> found.matrix, found.transformation
    (Matrix([
    [0, 1],
    [2, 0]]), Matrix([
    [1, 0],
    [1, 1]]))
    """
    A, H = read_observed(A, _upright(h, row=True), "h")
    T, a, polynomial = _coordinates(
        A, H, "h", "output", "observable", "observability_decomposition"
    )
    matrix, vector = _form(a)
    return CanonicalForm(matrix, vector, T, polynomial)


@accepts_state_space(B="b")
def controller_canonical_form(A: MatrixLike, b: MatrixLike | None = None) -> CanonicalForm:
    """Return the controller canonical form of a controllable pair with one control.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + bu; exact or floats, or a StateSpace, which has its own `b`.
    b : matrix_like, shape (n, 1)
        The column b; a row or a flat list of n numbers is read as b.

    Returns
    -------
    CanonicalForm
        Last row (alpha_1, ..., alpha_n), ones above the diagonal, b_0 = (0, ..., 0, 1), and T with
        xi = T x, x = `basis` xi; with symbols for all values for which det W is not zero
        (`controllability_conditions`).

    Raises
    ------
    ValueError
        If there are several controls, or if the pair is not controllable: then there is no such
        form.

    Notes
    -----
    Keywords of python-control: `B` for `b`.
    Keywords of python-control: `C` for `h`.
    MATLAB: ``canon``; ``ss(tf(...))`` up to order. Source: Definition 2.5 and Theorem 2.7 of the
    problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = controller_canonical_form(sp.Matrix([[1, 1], [-3, 1]]), sp.Matrix([0, 1]))
    >>> found.matrix, found.basis
    (Matrix([
    [ 0, 1],
    [-4, 2]]), Matrix([
    [ 1, 0],
    [-1, 1]]))
    """
    A, H = read_controlled(A, _upright(b, row=False))
    rows, a, polynomial = _coordinates(
        A, H, "b", "control", "controllable", "controllability_decomposition"
    )
    matrix, vector = _form(a)
    return CanonicalForm(
        matrix[::-1, ::-1].T, vector[:, ::-1].T, inverse(rows[::-1, :].T), polynomial
    )


def _upright(vector, row):
    """Return a vector as one row or one column, whichever way it was written."""
    shape = getattr(vector, "shape", ())
    wrong = len(shape) == 2 and shape[0 if row else 1] != 1 and shape[1 if row else 0] == 1
    return vector.T if wrong else vector


def _coordinates(A, H, name, kind, word, way_out):
    """Return the rows f_1, ..., f_n of T, the coefficients 1, -alpha_n, ..., and Delta."""
    n = A.shape[0]
    if H.shape[0] != 1:
        raise ValueError(
            f"{name}: the canonical form is that of one {kind}, got {H.shape[0]}; for several take "
            "one of them or their sum, or decompose by components (decompose_by_outputs, "
            "decompose_by_inputs)"
        )
    g = stacked_powers(A, H)
    floating = isinstance(A, np.ndarray)
    rank = floats.split(A, H).rank if floating else exact.rank(g)
    if rank < n:
        raise ValueError(
            f"{name}: the pair is not {word} (rank {rank} of {n}), so it has no canonical form; "
            f"{way_out} gives its {word} part, which has one"
        )
    symbol = sp.Symbol("lambda") if floating else visible_symbol(A)
    polynomial = characteristic_polynomial(A, symbol)
    a = np.poly(A) if floating else sp.Poly(polynomial, symbol).all_coeffs()
    toeplitz = [[a[i - j] if i >= j else 0 for j in range(n)] for i in range(n)]
    if not floating:
        return (sp.Matrix(toeplitz) * g).applyfunc(sp.expand), a, polynomial
    T = np.array(toeplitz, dtype=float) @ g
    if np.linalg.cond(T) > _WORST_CONDITION:
        raise ValueError(
            f"A: the transformation to the canonical form has the condition number "
            f"{np.linalg.cond(T):.0e}, so that "
            "rounding spoils it; give the matrices exactly (SymPy)"
        )
    return T, a, polynomial


def _form(a):
    """Return the pair (2.5) from the coefficients of the characteristic polynomial."""
    n = len(a) - 1
    matrix = [[-a[i + 1] if j == 0 else int(j == i + 1) for j in range(n)] for i in range(n)]
    vector = [[1] + [0] * (n - 1)]
    if isinstance(a, np.ndarray):
        return np.array(matrix, dtype=float), np.array(vector, dtype=float)
    return sp.Matrix(matrix), sp.Matrix(vector)
