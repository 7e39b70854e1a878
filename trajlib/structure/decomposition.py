"""Observability and controllability decompositions, Theorems 2.8 and 2.9.

By observability (2.7) the new coordinates are (xi; eta) = T x with T A T^-1 = [[A11, 0], [A21,
A22]], H T^-1 = [H1, 0] and (A11, H1) observable. As in example 3, xi_i = g_i^T x with the first
independent ones of the vectors of N (for one output g_1 = h, g_2 = A^T h, ...), and eta comes from
the simplest integer vectors orthogonal to them.

By controllability (2.6) x = T^-1 (xi; eta), T A T^-1 = [[A11, A12], [0, A22]], T B = [B1; 0] and
(A11, B1) is controllable. As in example 6, the columns of T^-1 are the first independent columns of
W and integer vectors orthogonal to them.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.stability.regions import latex_condition
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers


@dataclass(frozen=True)
class Decomposition:
    """A system in coordinates (xi; eta) = T x, xi being observable (or controllable).

    Attributes
    ----------
    transformation : matrix, shape (n, n)
        T.
    matrix : matrix, shape (n, n)
        T A T^-1.
    sizes : tuple of int
        (number of xi, number of eta).
    outputs : matrix or None
        H T^-1 = [H1, 0], for a decomposition by observability.
    inputs : matrix or None
        T B = [B1; 0], for a decomposition by controllability.
    """

    transformation: Matrix
    matrix: Matrix
    sizes: tuple[int, int]
    outputs: Matrix = None
    inputs: Matrix = None

    @property
    def basis(self) -> Matrix:
        """Return the inverse of the transformation, x = `basis` (xi; eta)."""
        return inverse(self.transformation)

    @property
    def part(self) -> tuple[Matrix, Matrix]:
        """Return the observable pair (A11, H1) or the controllable pair (A11, B1)."""
        k = self.sizes[0]
        A11 = self.matrix[:k, :k]
        return (A11, self.inputs[:k, :]) if self.outputs is None else (A11, self.outputs[:, :k])

    @property
    def complement(self) -> Matrix:
        """Return A22, the matrix of the unobservable (uncontrollable) part."""
        return self.matrix[self.sizes[0] :, self.sizes[0] :]

    @property
    def where(self) -> sp.Basic:
        """Return the condition on the symbols, taken as real, under which the decomposition holds.

        At other values the coordinates fail or the sizes are different: put such a value into the
        system and decompose it anew.
        """
        return holds_where(self.transformation, self.basis, self.matrix, self.outputs, self.inputs)

    def _repr_latex_(self):
        shown = {
            "T": self.transformation,
            "TAT^{-1}": self.matrix,
            "HT^{-1}": self.outputs,
            "TB": self.inputs,
        }
        return named_matrices(shown, self.where)


@accepts_state_space(C="H")
def observability_decomposition(A: MatrixLike, H: MatrixLike | None = None) -> Decomposition:
    """Return the decomposition into an observable and an unobservable part, in this order.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; a StateSpace in place of it has its own `H`.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx.

    Returns
    -------
    Decomposition
        With `outputs`. Exact input gives the basis of the problem book (generic if there are
        symbols), floats a T that is orthogonal in the units that balance the system. An observable
        pair has sizes (n, 0); one that rounding could make unobservable gives a warning.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``obsvf``, which puts the observable coordinates last. Source: Theorem 2.9
    and example 3 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = observability_decomposition(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), sp.Matrix([[0, 1, 0]]))
    >>> found.transformation, found.sizes
    (Matrix([
    [0, 1,  0],
    [1, 1,  1],
    [1, 0, -1]]), (2, 1))
    >>> found.matrix
    Matrix([
    [0,  1, 0],
    [0,  2, 0],
    [2, -1, 0]])
    """
    A, H = read_observed(A, H)
    T, sizes = _coordinates(A, H)
    T_inverse = inverse(T)
    return Decomposition(T, multiply(T, A, T_inverse), sizes, outputs=multiply(H, T_inverse))


def controllability_decomposition(A: MatrixLike, B: MatrixLike | None = None) -> Decomposition:
    """Return the decomposition into a controllable and an uncontrollable part, in this order.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; a StateSpace in place of it has its own `B`.
    B : matrix_like, shape (n, s)
        Matrix of the control.

    Returns
    -------
    Decomposition
        With `inputs`. Exact input gives the basis of the problem book (generic if there are
        symbols), floats a T that is orthogonal in the units that balance the system. A controllable
        pair has sizes (n, 0); one that rounding could make uncontrollable gives a warning.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    MATLAB: ``ctrbf``, which puts the controllable coordinates last. Source: Theorem 2.8 and example
    6 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = controllability_decomposition(sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), sp.Matrix([0, 1, 0]))
    >>> found.basis, found.sizes
    (Matrix([
    [0,  1, 1],
    [1,  1, 0],
    [0, -1, 1]]), (2, 1))
    >>> found.matrix
    Matrix([
    [0, 2, 0],
    [1, 0, 1],
    [0, 0, 0]])
    """
    A, H = read_controlled(A, B)
    rows, sizes = _coordinates(A, H)
    basis = rows.T
    T = inverse(basis)
    return Decomposition(T, multiply(T, A.T, basis), sizes, inputs=multiply(T, H.T))


def _coordinates(A, H):
    """Return the rows of xi, then rows orthogonal to them; and the two numbers."""
    n = A.shape[0]
    if isinstance(A, np.ndarray):
        split = floats.split_with_warning(A, H)
        return split.rows, (split.rank, n - split.rank)
    N = stacked_powers(A, H)
    chosen = exact.independent_rows(N)
    rows = N.extract(list(chosen), list(range(n))) if chosen else sp.zeros(0, n)
    return sp.Matrix.vstack(rows, exact.null_columns(rows).T), (len(chosen), n - len(chosen))


def inverse(T):
    """Return the inverse of an exact matrix or an array."""
    return np.linalg.inv(T) if isinstance(T, np.ndarray) else exact.inverse(T)


def multiply(*matrices):
    """Return the product of exact matrices or arrays."""
    return (
        np.linalg.multi_dot(matrices)
        if isinstance(matrices[0], np.ndarray)
        else exact.product(*matrices)
    )


def holds_where(*matrices):
    """Return the condition under which coordinates found for general values of the symbols hold.

    T, its inverse and all other matrices must be defined. Where both T and its inverse are, their
    product is the identity, also after the last cancellation; the system itself is defined there,
    being made of the others; and the rows that span xi are independent, so that the sizes are
    right.
    """
    return (
        sp.true
        if isinstance(matrices[0], np.ndarray)
        else exact.where_defined(*(m for m in matrices if m))
    )


def named_matrices(shown, where=sp.true):
    """Return LaTeX of matrices (None left out) with their names, and where they hold."""

    def latex(m):
        return sp.latex(sp.Matrix(np.round(m, 6)) if isinstance(m, np.ndarray) else m)

    body = r",\quad ".join(f"{name} = {latex(m)}" for name, m in shown.items() if m is not None)
    condition = "" if where == sp.true else rf",\quad {latex_condition(where)}"
    return f"$\\displaystyle {body}{condition}$"
