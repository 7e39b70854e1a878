"""Observability and controllability by the Kalman criterion and the PBH test.

Exact systems: the rank of the Kalman matrix, and the PBH test (Popov, Belevitch, Hautus) for the
eigenvalues at which the rank of (A - lambda I; H) falls, with the motions exp(lambda t) v whose
output is zero. Floats: the staircase form in balanced units and the least singular value in the PBH
test (module `floats`).
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import MatrixLike
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.pbh import LAMBDA, HiddenMode, hidden_modes
from trajlib.typesetting import escape_markdown

__all__ = ["HiddenMode", "RankTest", "controllability", "observability"]


@dataclass(frozen=True)
class RankTest:
    """The verdict on observability or controllability; true in an `if` if the property holds.

    With symbols everything is generic: true for all values of the symbols but exceptional ones,
    which `observability_conditions` and `controllability_conditions` give.

    Attributes
    ----------
    holds : bool
        The verdict, `rank == order`.
    rank : int
        Rank of the Kalman matrix N (or W).
    order : int
        Dimension of the state.
    hidden_modes : tuple of HiddenMode
        The eigenvalues at which the rank in the PBH test falls, with their vectors.
    margin : float or None
        For floats the smallest singular value found in the PBH test, A having the norm 1 and every
        output the length 1 in units that balance the system. A change of that size makes the
        verdict no; a smaller one may do so too, since the search is not proved to be complete
        (`distance_to_unobservable` and `distance_to_uncontrollable` give proved bounds, in the
        units given). None for exact systems.
    reason : str
        The verdict in words.
    """

    holds: bool
    rank: int
    order: int
    hidden_modes: tuple[HiddenMode, ...]
    margin: float | None = None
    reason: str = ""

    def __bool__(self):
        return self.holds

    def _repr_markdown_(self):
        return escape_markdown(self.reason)


@accepts_state_space(C="H")
def observability(A: MatrixLike, H: MatrixLike | None = None) -> RankTest:
    """Decide whether x' = Ax, z = Hx is observable, with rank, unobservable modes and margin.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        A SymPy matrix or list of rows is judged exactly; with symbols the verdict is generic (it
        may fail for special values: see `observability_conditions`). A NumPy array of floats, or a
        StateSpace, is judged in balanced units by its staircase form, with a margin.
    H : matrix_like, shape (m, n)
        Matrix of the output; left out for a StateSpace, which has its own.

    Returns
    -------
    RankTest
        True in an `if` if the system is observable; the vectors of its modes are columns.

    Raises
    ------
    ValueError
        If shapes do not fit, or for entries that are not real.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``rank(obsv(A, C))``, or the PBH test. Source: Theorems 2.1 and 2.3 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = observability(sp.Matrix([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), sp.Matrix([[0, 1, 0]]))
    >>> found.holds, found.rank, found.order
    (False, 2, 3)
    >>> found.hidden_modes
    (HiddenMode(eigenvalue=0, vectors=Matrix([
    [ 1],
    [ 0],
    [-1]])),)
    """
    A, H = read_observed(A, H)
    return _test(A, H, "observable", lambda vectors: vectors)


def controllability(A: MatrixLike, B: MatrixLike | None = None) -> RankTest:
    """Decide whether x' = Ax + Bu is controllable, with rank, uncontrollable modes and margin.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Exact, symbolic (generic) or floats, as in `observability`.
    B : matrix_like, shape (n, s)
        Matrix of the control; left out for a StateSpace, which has its own.

    Returns
    -------
    RankTest
        True in an `if` if the system is controllable; the vectors of its modes are rows w with w A
        = lambda w, w B = 0: no control changes w x exp(-lambda t).

    Raises
    ------
    ValueError
        If shapes do not fit, or for entries that are not real.

    Notes
    -----
    MATLAB: ``rank(ctrb(A, B))``, or the PBH test. Source: Theorems 2.2 and 2.4 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = controllability(sp.Matrix([[0, 1, 1], [1, 1, 0], [0, -1, -1]]), sp.Matrix([0, 1, 0]))
    >>> found.rank, found.hidden_modes
    (2, (HiddenMode(eigenvalue=0, vectors=Matrix([[1, 0, 1]])),))
    """
    A, H = read_controlled(A, B)
    return _test(A, H, "controllable", lambda vectors: vectors.T)


def _test(A, H, word, orient):
    if isinstance(A, np.ndarray):
        return float_test(A, H, word, orient)
    if A.free_symbols | H.free_symbols:
        at_point = exact.at_a_point(sp.Matrix.vstack(A, H))
        if (
            at_point is not None
            and exact.rank(stacked_powers(at_point[: A.rows, :], at_point[A.rows :, :])) == A.rows
        ):
            return rank_test(A.rows, A.rows, (), word, generic=True)
    N = stacked_powers(A, H)
    rank = exact.rank(N)
    modes = _modes_in(A, exact.null_columns(N)) if rank < A.rows else ()
    return rank_test(
        rank,
        A.rows,
        [HiddenMode(m.eigenvalue, orient(m.vectors)) for m in modes],
        word,
        generic=bool(A.free_symbols | H.free_symbols),
    )


def _modes_in(A, subspace):
    """Return the modes of A in an invariant subspace, found in its own coordinates."""
    rows, columns = list(exact.independent_rows(subspace)), list(range(subspace.cols))
    inner = exact.product(
        exact.inverse(subspace.extract(rows, columns)), (A * subspace).extract(rows, columns)
    )
    return hidden_modes(
        inner - LAMBDA * sp.eye(inner.rows), characteristic_polynomial(inner, LAMBDA), subspace
    )


def rank_test(rank, order, modes, word, margin=None, generic=False, remark=""):
    """Return a `RankTest` with its verdict in words."""
    holds = rank == order
    reason = f"{word if holds else f'not {word}'}: rank {rank} of {order}"
    if modes:
        reason += ", the rank in the PBH test falls at " + ", ".join(
            dict.fromkeys(_named(m.eigenvalue) for m in modes)
        )
    if generic:
        reason += " (for general values of the symbols)"
    return RankTest(holds, rank, order, tuple(modes), margin, reason + remark)


def _named(eigenvalue):
    if isinstance(eigenvalue, sp.Poly):
        return f"the roots of {eigenvalue.as_expr()}"
    if isinstance(eigenvalue, sp.Basic):
        return f"lambda = {eigenvalue}"
    return (
        f"lambda = {complex(eigenvalue):.6g}"
        if np.imag(eigenvalue)
        else f"lambda = {float(eigenvalue):.6g}"
    )


def float_test(A, H, word, orient=lambda vectors: vectors):
    """Return the verdict in floats; a margin close to rounding is reported."""
    split = floats.split(A, H)
    remark = f"; margin {split.margin:.3g} in balanced units"
    if split.rank < len(A):
        doubt = split.margin or split.scaled.cleared
        remark += ", zero within rounding; exact entries (SymPy) would decide" if doubt else ""
    elif split.margin < floats.DOUBTFUL:
        remark += (
            f", small: a change of the entries by {split.margin:.1e} of their size can turn the "
            "verdict; exact entries (SymPy) would decide"
        )
    modes = [HiddenMode(value, orient(vectors)) for value, vectors in floats.hidden_modes(split)]
    return rank_test(split.rank, len(A), modes, word, split.margin, remark=remark)
