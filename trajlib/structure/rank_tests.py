"""Is the state seen, can it be steered? The criteria of Kalman and of Popov, Theorems 2.1 - 2.4 of
the problem book.

Exact systems: the rank of Kalman's matrix, and Popov's criterion for the characteristic numbers at
which the rank of (A - lambda E; H) falls, with the motions exp(lambda t) v that the output does not
show. Floats: the staircase form in balanced units and Popov's singular values (module `floats`).
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact, floats
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.pbh import LAMBDA, HiddenMode, hidden_modes
from trajlib.typesetting import escape_markdown

__all__ = ["HiddenMode", "RankTest", "controllability", "observability"]


@dataclass(frozen=True)
class RankTest:
    """Whether a system is observable (or controllable), the rank of Kalman's matrix, and what is
    lost; true in an `if` if it is.

    - `holds`: the verdict, `rank == order`; `rank`: of N (or W); `order`: the dimension of the
      state;
    - `hidden_modes`: tuple of `HiddenMode`, the characteristic numbers at which the rank of Popov's criterion
      falls;
    - `margin`: for floats the smallest singular value in Popov's criterion that was found, A having
      the norm 1 and every output the length 1 in units that balance the system. A change of that
      size makes the verdict no; a smaller one may do so too, since the search is not proved to be
      complete (`distance_to_unobservable` and `distance_to_uncontrollable` give proved bounds, in
      the units given). None for exact systems;
    - `reason`: the verdict in words. With symbols everything is generic: true for all values of the
      symbols but exceptional ones, which `observability_conditions` and
      `controllability_conditions` give.
    """

    holds: bool
    rank: int
    order: int
    hidden_modes: tuple
    margin: float | None = None
    reason: str = ""

    def __bool__(self):
        return self.holds

    def _repr_markdown_(self):
        return escape_markdown(self.reason)


def observability(A, H=None):
    """Is x' = Ax, z = Hx observable? Rank, lost modes, margin (MATLAB: rank(obsv(A, C)), Popov's or
    PBH test).

    `A`: n x n, `H`: m x n. SymPy matrices or lists of rows are judged exactly; with symbols the
    verdict is generic (it may fail for special values: see `observability_conditions`). NumPy
    arrays of floats, or a StateSpace in place of `A`, are judged in balanced units by their
    staircase form, with a margin. Returns `RankTest`. Raises ValueError for shapes that do not fit
    and entries that are not real. Source: Theorems 2.1 and 2.3 of the problem book.

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


def controllability(A, B=None):
    """Is x' = Ax + Bu controllable? Rank, lost modes, margin (MATLAB: rank(ctrb(A, B)), Popov's or
    PBH test).

    `A`: n x n, `B`: n x s; exact, symbolic (generic) or floats as in `observability`. The vectors
    of the lost modes are rows w with w A = lambda w, w B = 0: no control changes w x exp(-lambda
    t). Returns `RankTest`. Raises ValueError for shapes that do not fit and entries that are not
    real. Source: Theorems 2.2 and 2.4 of the problem book.

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
    """The modes of A in an invariant subspace, found in its own coordinates: there they all are
    lost."""
    rows, columns = list(exact.independent_rows(subspace)), list(range(subspace.cols))
    inner = exact.product(
        exact.inverse(subspace.extract(rows, columns)), (A * subspace).extract(rows, columns)
    )
    return hidden_modes(
        inner - LAMBDA * sp.eye(inner.rows), characteristic_polynomial(inner, LAMBDA), subspace
    )


def rank_test(rank, order, modes, word, margin=None, generic=False, remark=""):
    """A `RankTest` with its verdict in words."""
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
    """The verdict in floats; a margin close to rounding is told."""
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
