"""Decomposition by observation and by control, Theorems 2.8 and 2.9 of the problem book.

By observation (2.7) the new coordinates are (xi; eta) = T x with T A T^-1 = [[A11, 0], [A21, A22]],
H T^-1 = [H1, 0] and (A11, H1) observable. As in example 3, xi_i = g_i^T x with the first
independent ones of the vectors of N (for one output g_1 = h, g_2 = A^T h, ...), and eta comes from
the simplest whole vectors orthogonal to them.

By control (2.6) x = T^-1 (xi; eta), T A T^-1 = [[A11, A12], [0, A22]], T B = [B1; 0] and (A11, B1)
is controllable. As in example 6, the columns of T^-1 are the first independent columns of W and
whole vectors orthogonal to them.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib.stability.regions import latex_condition
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers


@dataclass(frozen=True)
class Decomposition:
    """A system in coordinates (xi; eta) = `transformation` x, xi being the observable (or
    controllable) ones.

    - `transformation`: T, n x n; `basis`: its inverse, x = `basis` (xi; eta);
    - `matrix`: T A T^-1; `outputs`: H T^-1 = [H1, 0], or `inputs`: T B = [B1; 0] (the other one is
      None);
    - `sizes`: (number of xi, number of eta); `part` and `rest`: the pair (A11, H1) or (A11, B1),
      and A22;
    - `where`: the values of the symbols, taken as real, for which all this holds. At the others the
      coordinates fail or the sizes are different: put such a value into the system and decompose it
      anew.
    """

    transformation: object
    matrix: object
    sizes: tuple
    outputs: object = None
    inputs: object = None

    @property
    def basis(self):
        return inverse(self.transformation)

    @property
    def part(self):
        k = self.sizes[0]
        return self.matrix[:k, :k], self.outputs[
            :, :k
        ] if self.outputs is not None else self.inputs[:k, :]

    @property
    def rest(self):
        return self.matrix[self.sizes[0] :, self.sizes[0] :]

    @property
    def where(self):
        return holds_where(self.transformation, self.basis, self.matrix, self.outputs, self.inputs)

    def _repr_latex_(self):
        shown = {
            "T": self.transformation,
            "TAT^{-1}": self.matrix,
            "HT^{-1}": self.outputs,
            "TB": self.inputs,
        }
        return named_matrices(shown, self.where)


def observability_decomposition(A, H=None):
    """Decomposition by observation, observable coordinates first (MATLAB: obsvf, which puts them
    last).

    `A`: n x n, `H`: m x n. Exact input gives the basis of the problem book (generic if there are
    symbols), floats a T that is orthogonal in the units that balance the system. An observable pair
    gives sizes (n, 0); one that rounding could make unobservable, a warning. Returns
    `Decomposition` with `outputs`. Raises ValueError for shapes that do not fit. Source: Theorem
    2.9 and example 3 of the problem book.

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
    back = inverse(T)
    return Decomposition(T, multiply(T, A, back), sizes, outputs=multiply(H, back))


def controllability_decomposition(A, B=None):
    """Decomposition by control, controllable coordinates first (MATLAB: ctrbf, which puts them
    last).

    `A`: n x n, `B`: n x s. Exact input gives the basis of the problem book (generic if there are
    symbols), floats a T that is orthogonal in the units that balance the system. A controllable
    pair gives sizes (n, 0); one that rounding could make uncontrollable, a warning. Returns
    `Decomposition` with `inputs`. Raises ValueError for shapes that do not fit. Source: Theorem 2.8
    and example 6 of the problem book.

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
    """Rows g of the observable coordinates, then rows orthogonal to them; and the two numbers."""
    n = A.shape[0]
    if isinstance(A, np.ndarray):
        split = floats.split_with_warning(A, H)
        return split.rows, (split.rank, n - split.rank)
    N = stacked_powers(A, H)
    chosen = exact.independent_rows(N)
    rows = N.extract(list(chosen), list(range(n))) if chosen else sp.zeros(0, n)
    return sp.Matrix.vstack(rows, exact.null_columns(rows).T), (len(chosen), n - len(chosen))


def inverse(T):
    return np.linalg.inv(T) if isinstance(T, np.ndarray) else exact.inverse(T)


def multiply(*matrices):
    return (
        np.linalg.multi_dot(matrices)
        if isinstance(matrices[0], np.ndarray)
        else exact.product(*matrices)
    )


def holds_where(*matrices):
    """Where coordinates hold that were found for general values of the symbols: T, its inverse and
    all in them defined.

    Where both T and its inverse are defined their product is E, also after the last cancellation;
    the system itself is defined there, being made of the others; and the rows that span xi are
    independent, so that the sizes are right.
    """
    return (
        sp.true
        if isinstance(matrices[0], np.ndarray)
        else exact.where_defined(*(m for m in matrices if m))
    )


def named_matrices(shown, where=sp.true):
    """LaTeX of several matrices with their names, those that are None left out, and where they
    hold."""

    def latex(m):
        return sp.latex(sp.Matrix(np.round(m, 6)) if isinstance(m, np.ndarray) else m)

    body = r",\quad ".join(f"{name} = {latex(m)}" for name, m in shown.items() if m is not None)
    condition = "" if where == sp.true else rf",\quad {latex_condition(where)}"
    return f"$\\displaystyle {body}{condition}$"
