"""Canonical forms by observation and by control, Theorem 2.7 of the problem book.

With Delta(lambda) = lambda^n - alpha_n lambda^(n-1) - ... - alpha_1 the coordinates by observation
are, as in example 1,

    xi_1 = h^T x,    xi_(k+1) = xi_k' - alpha_(n-k+1) xi_1,

so that the rows of T are f_1 = g_1 and f_k = g_k - alpha_n g_(k-1) - ... - alpha_(n-k+2) g_1 with
g_k = (A^T)^(k-1) h. The form by control is the transposed one of the dual system, with the
coordinates in the opposite order.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact, floats
from trajlib.structure.decomposition import holds_where, inverse, named_matrices
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.pbh import visible_symbol

_WORST_CONDITION = 1e12


@dataclass(frozen=True)
class CanonicalForm:
    """A pair in canonical form, in the coordinates xi = `transformation` x.

    - `matrix`: T A T^-1; `vector`: the row h^T T^-1 = (1, 0, ..., 0) or the column T b = (0, ...,
      0, 1);
    - `transformation`: T, n x n; `basis`: its inverse, x = `basis` xi;
    - `polynomial`: the characteristic polynomial in lambda;
    - `where`: the values of the symbols for which there is this form, as in a `Decomposition`.
    """

    matrix: object
    vector: object
    transformation: object
    polynomial: sp.Expr

    @property
    def basis(self):
        return inverse(self.transformation)

    @property
    def where(self):
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


def observer_canonical_form(A, h=None):
    """Canonical form by observation of an observable pair with one output (MATLAB: canon,
    "companion").

    `A`: n x n; `h`: the row h^T, 1 x n (a column or a flat list of n numbers is read as h). Returns
    `CanonicalForm`: first column (alpha_n, ..., alpha_1), ones above the diagonal, h_0^T = (1, 0,
    ..., 0), and T with xi = T x. Exact or floats; with symbols for all values for which det N is
    not zero (`observability_conditions`). Raises ValueError if there are several outputs, and if
    the pair is not observable: then there is no such form. Source: Definition 2.6, Theorem 2.7,
    example 1 of the problem book.

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
    return CanonicalForm(*_form(a), T, polynomial)


def controller_canonical_form(A, b=None):
    """Canonical form by control of a controllable pair with one control (MATLAB: canon; ss(tf(...))
    up to order).

    `A`: n x n; `b`: the column b, n x 1 (a row or a flat list of n numbers is read as b). Returns
    `CanonicalForm`: last row (alpha_1, ..., alpha_n), ones above the diagonal, b_0 = (0, ..., 0,
    1), and T with xi = T x (x = `basis` xi). Exact or floats; with symbols for all values for which
    det W is not zero (`controllability_conditions`). Raises ValueError if there are several
    controls, and if the pair is not controllable: then there is no such form. Source: Definition
    2.5 and Theorem 2.7 of the problem book.

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
    """A vector as one row or one column, whichever way it was written."""
    shape = getattr(vector, "shape", ())
    wrong = len(shape) == 2 and shape[0 if row else 1] != 1 and shape[1 if row else 0] == 1
    return vector.T if wrong else vector


def _coordinates(A, H, name, kind, word, way_out):
    """Rows f_1, ..., f_n of example 1, the coefficients 1, a_1, ..., a_n = 1, -alpha_n, ...,
    -alpha_1, and Delta."""
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
    """The pair (2.5) from the coefficients of the characteristic polynomial."""
    n = len(a) - 1
    matrix = [[-a[i + 1] if j == 0 else int(j == i + 1) for j in range(n)] for i in range(n)]
    vector = [[1] + [0] * (n - 1)]
    if isinstance(a, np.ndarray):
        return np.array(matrix, dtype=float), np.array(vector, dtype=float)
    return sp.Matrix(matrix), sp.Matrix(vector)
