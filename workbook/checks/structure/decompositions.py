"""Observability (2.7) and controllability (2.6) decompositions.

A change of variables is judged by the zeros of the new matrices. A system given in new variables is
judged by the existence of the change: a matrix T with T A = A' T and H = H' T is the solution of
linear equations, and an invertible one exists if a random solution is invertible. So every choice
of coordinates is right that has the form asked.

No check here is declared by a reference: any coordinates with the zeros asked are right.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Matrix
from workbook.checks.contract.tolerance import EXACT, relative_tolerance
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.exceptional_values import judge_everywhere, judge_where_generic
from workbook.checks.references.invariant_subspaces import chain, orthogonal_complement
from workbook.checks.references.pairs import pair_of
from workbook.checks.references.records import (
    controlled_pair,
    has_control,
    matrix_of,
    observed_pair,
)
from workbook.checks.structure.canonical_forms import BY_OBSERVATION, shape_of_form
from workbook.checks.structure.similar_systems import are_similar, difference_text
from workbook.checks.tools.values import entry_uncertainties, matrix_at
from workbook.checks.tools.wording import number_text, where_text


@dataclass(frozen=True)
class _Side:
    """The wording of one of two dual questions, both judged as observability decompositions."""

    part: str  # the part that stands first
    complement: str
    size: str
    expected: str
    reverse: str
    by_control: bool

    def mixed(self, row, column, value):
        """Return a text on a nonzero entry that should vanish, by names of its row and column."""
        inner, outer = (row, column) if self.by_control else (column, row)
        return f"{outer}' contains {inner} with the coefficient {number_text(value)}"

    def shown(self, k, count, column, value):
        number = k + 1 if count > 1 else ""
        what = f"u{number} enters {column}'" if self.by_control else f"z{number} contains {column}"
        return f"{what} with the coefficient {number_text(value)}"


OUTPUT = _Side(
    "observable", "unobservable", "rank N", "T in (xi; eta) = T x", "x from (xi; eta)", False
)
CONTROL = _Side(
    "controllable", "uncontrollable", "rank W", "P in x = P (xi; eta)", "(xi; eta) from x", True
)


@judged(Matrix("parameters", shape="system.A"))
def decomposition(claim, system, parameters=()):
    """Check the change of variables of a decomposition into (xi; eta).

    Of a system with an output it is T of (xi; eta) = T x, which leads to the form (2.7):
    neither xi' nor z contains eta, and xi has rank N coordinates. With a control it is P of x =
    P (xi; eta), which leads to the form (2.6): eta' contains neither xi nor u, and xi has rank
    W coordinates.

    Can decide when the entries are exact numbers, or rational functions of the parameters. Any
    change of variables with the zeros of the form is right.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 1], [1, 0]], H=[[1, 1]])
    >>> checks.decomposition([[1, 1], [0, 1]], pair).status
    'right'
    >>> checks.decomposition([[1, 0], [0, 1]], pair).status
    'wrong'
    """
    return _judge_split(*by_observation(claim, system, parameters))


@judged
def decomposed_system(answer, system, parameters=()):
    """Check the system [A', H'] or [A', B'] in coordinates (xi; eta), as in (2.7) or (2.6).

    Any right coordinates are accepted, xi first, with as many coordinates as N or W has rank.

    Can decide when the entries are exact numbers, or rational functions of the parameters. Any
    right coordinates are accepted.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 1], [1, 0]], H=[[1, 1]])
    >>> checks.decomposed_system(([[1, 0], [1, -1]], [1, 0]), pair).status
    'right'
    >>> checks.decomposed_system(([[0, 1], [1, 0]], [1, 1]), pair).status
    'wrong'
    """
    return judge_system(*by_equations(answer, system, parameters))


@judged
def canonical_observable_part(answer, system, parameters=()):
    """Check the observable subsystem [A11, H1] in the canonical form (2.5), H1 = (1 0 ... 0).

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 1, 0], [1, 1, 1], [1, 0, 1]], H=[[0, 1, 0]])
    >>> checks.canonical_observable_part([[[2, 1], [0, 0]], [1, 0]], pair).status
    'right'
    >>> checks.canonical_observable_part([[[0, 1], [0, 2]], [1, 0]], pair).status
    'wrong'
    """
    matrix, output = _as_system(answer, parameters, ("A11", "H1"), system.H.rows)
    pair, tolerance = observed_pair(system, parameters), relative_tolerance(matrix, output)
    for values, *_ in pair.samples_for([matrix, output]):
        claimed = matrix_at(output, values)
        if not abs(claimed - np.eye(len(claimed), claimed.shape[1])).max(initial=0) <= 1e-6:
            raise Wrong(
                "in the form (2.5) z is the first coordinate alone, and with your H1 it is "
                f"not{where_text(values)}"
            )
        shape_of_form(matrix_at(matrix, values), tolerance, BY_OBSERVATION, where_text(values))
    return _judge_part(matrix, output, pair)


@judged(Matrix("parameters", shape="system.A"))
def similarity_matrix(claim, system, other, parameters=()):
    """Check a matrix S of y = S x that turns x' = A x into the `other` system y' = A' y.

    The other system may be in `Deviations`; S is invertible and S A = A' S (all n x n).

    Can decide when the entries are exact numbers, or rational functions of the parameters. Any
    right matrix is accepted.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> one, other = Linear(A=[[0, 1], [2, 1]]), Linear(A=[[2, 0], [0, -1]])
    >>> checks.similarity_matrix([[1, 1], [2, -1]], one, other).status
    'right'
    >>> checks.similarity_matrix([[1, 0], [0, 1]], one, other).status
    'wrong'
    """

    tolerance = relative_tolerance(claim)
    source, target = (
        pair_of(A, A[:1, :], parameters) for A in (system.A, matrix_of(other, parameters))
    )
    for (values, A_source, _, _), (_, A_target, _, _) in zip(source.systems, target.systems):
        claimed = matrix_at(claim, values)
        require_invertible(claimed, tolerance, values)
        left, right = claimed @ A_source, A_target @ claimed
        uncertainty = entry_uncertainties(claim, values)
        lengths = np.linalg.norm(claimed, axis=1)[:, None]
        bound = EXACT * (lengths * np.linalg.norm(A_source) + abs(A_target) @ lengths)
        bound = bound + uncertainty @ abs(A_source) + abs(A_target) @ uncertainty
        mismatched = ~(abs(left - right) <= bound)
        if mismatched.any():
            inverse = np.linalg.inv(claimed)
            off = np.linalg.norm(inverse @ A_source - A_target @ inverse)
            if off <= tolerance * np.linalg.norm(inverse) * np.linalg.norm(A_source):
                raise Wrong("this matrix gives x from y; asked is S in y = S x")
            i, j = np.argwhere(mismatched)[0]
            raise Wrong(
                f"for x with x{j + 1} = 1 and zeros elsewhere{where_text(values)} y{i + 1}' is "
                f"{number_text(left[i, j])} by the first system and {number_text(right[i, j])} by "
                "the second"
            )
    undefined, singular = "your matrix is undefined", "your matrix has no inverse"
    judge_everywhere(claim, source.parameters, lambda: sp.true, undefined, singular)
    return "it is invertible, and the derivatives of y agree in both systems"


def by_observation(claim, system, parameters=()):
    """Return a matrix, the pair and the wording of a question, transposed if it is one of control."""
    if has_control(system):
        return claim.T, controlled_pair(system, parameters), CONTROL
    return claim, observed_pair(system, parameters), OUTPUT


def by_equations(answer, system, parameters=()):
    """Return the matrices of a claimed system, the pair and the wording, transposed for a control."""
    control = has_control(system)
    names, width = (("A'", "B'"), system.B.cols) if control else (("A'", "H'"), system.H.rows)
    matrix, coupling = _as_system(answer, parameters, names, width, columns=control)
    matrix, pair, side = by_observation(matrix, system, parameters)
    return matrix, coupling.T if control else coupling, pair, side


def _judge_split(claim, pair, side):
    """Judge the rows of T for the pair: the first ones vanish on the unobservable states."""
    n, tolerance = pair.order, relative_tolerance(claim)
    for values, A, H, unobservable in pair.systems_for(claim):
        claimed, size = matrix_at(claim, values), n - len(unobservable)
        require_invertible(claimed, tolerance, values)
        space, _ = np.linalg.qr(unobservable.T)
        bound = EXACT * np.linalg.norm(claimed[:size], axis=1)[:, None]
        bound = bound + entry_uncertainties(claim, values)[:size] @ abs(space)
        if (abs(claimed[:size] @ space) <= bound).all():
            continue
        if _vanishes(np.linalg.inv(claimed)[:size], space, tolerance):
            raise Wrong(f"this matrix gives {side.reverse}; asked is {side.expected}")
        if _vanishes(claimed[n - size :], space, tolerance):
            raise Wrong(
                f"your matrix has the {side.complement} coordinates first; the {side.part} ones, xi, "
                "have to stand first"
            )
        if _vanishes(claimed.T[:size], space, tolerance):
            raise Wrong(
                f"the coordinates stand in your matrix the other way, as "
                f"{'rows' if side.by_control else 'columns'}; asked is {side.expected}"
            )
        new_A, new_H = claimed @ A @ np.linalg.inv(claimed), H @ np.linalg.inv(claimed)
        raise Wrong(
            f"{_first_mixed(new_A, new_H, size, side)}{where_text(values)}; the number of "
            f"coordinates of xi is {side.size}"
        )
    judge_where_generic(claim, pair, "your matrix is undefined", "your matrix has no inverse")
    return f"it is invertible, and in the new coordinates the {side.part} part is separated as the form requires"


def judge_system(matrix, output, pair, side):
    """Judge a system (A', H') of the pair's order: zero blocks, and similarity to the pair."""
    n, tolerance = pair.order, relative_tolerance(matrix, output)
    if matrix.rows != n:
        raise Invalid(
            f"expected the matrices of the whole system of order {n}; the order of yours is "
            f"{matrix.rows}"
        )
    for values, A, H, unobservable in pair.systems_for([matrix, output]):
        new_A, new_H = matrix_at(matrix, values), matrix_at(output, values)
        size, bound = n - len(unobservable), max(tolerance, 1e-9)
        if (abs(new_A[:size, size:]) > bound * np.linalg.norm(new_A)).any() or (
            abs(new_H[:, size:]) > bound * np.linalg.norm(new_H)
        ).any():
            raise Wrong(
                f"in your system {_first_mixed(new_A, new_H, size, side)}{where_text(values)}; xi "
                f"has as many coordinates as {side.size} gives"
            )
        uncertainty = entry_uncertainties(matrix, values)
        if not are_similar(A, H, new_A, new_H, tolerance, A, uncertainty):
            part = new_A[:size, :size], new_H[:, :size]
            block = _observable_block(A, unobservable)
            if (
                size < n
                and np.allclose(np.poly(new_A), np.poly(A))
                and are_similar(A, H, *part, tolerance, block, uncertainty)
            ):
                raise Wrong(
                    f"your {side.part} part is that of the given system, but no change of "
                    f"variables gives the rest of your equations{where_text(values)}: look at eta, "
                    "and at how the two parts act on each other"
                )
            raise Wrong(difference_text(A, new_A, *part, values, side))
    _judge_parameters(matrix, output, pair, side)
    return "the blocks are zero where they have to be, and a change of variables turns the given system into yours"


def _judge_part(matrix, output, pair):
    """Judge an observable system of order rank N that is the image of the pair's."""
    tolerance = relative_tolerance(matrix, output)
    for values, A, H, unobservable in pair.systems_for([matrix, output]):
        if matrix.rows != pair.order - len(unobservable):
            raise Wrong(
                f"your subsystem has the order {matrix.rows}; the observable one has the order "
                f"rank N, and that is not {matrix.rows}{where_text(values)}"
            )
        new_A, new_H = matrix_at(matrix, values), matrix_at(output, values)
        block, uncertainty = _observable_block(A, unobservable), entry_uncertainties(matrix, values)
        if not are_similar(A, H, new_A, new_H, tolerance, block, uncertainty):
            raise Wrong(difference_text(None, new_A, new_A, new_H, values, OUTPUT))
    _judge_parameters(matrix, output, pair, OUTPUT)
    return "its outputs are those of the given system, and it is observable"


def _judge_parameters(matrix, output, pair, side):
    """Judge that a system is defined, with the pair's rank N, for all values of the parameters."""
    undefined, rows = "your system is undefined", chain(output, matrix, matrix.rows)
    observability = sp.Matrix.vstack(*rows)[:, : pair.order - len(pair.unobservable[0])]
    judge_where_generic(matrix, pair, undefined)
    less = f"less of your system than of the given one is {side.part}"
    judge_where_generic(observability, pair, undefined, less)


def _observable_block(A, unobservable):
    """Return A on the orthogonal complement of the unobservable states, in an orthonormal basis."""
    complement = orthogonal_complement(unobservable)
    return complement @ A @ complement.T


def _as_system(answer, parameters, names, outputs, columns=False):
    """Return two matrices from a list: a square one, and that of outputs (rows) or controls."""
    if not isinstance(answer, (list, tuple)) or len(answer) != 2:
        raise Invalid(f"expected a list of two matrices, [{', '.join(names)}]")
    matrix, coupling = (
        coercion.as_matrix(
            part if isinstance(part, (sp.MatrixBase, np.ndarray, list, tuple)) else [part],
            parameters,
        )
        for part in answer
    )
    n = matrix.rows
    if matrix.cols != n:
        raise Invalid(f"expected a square matrix {names[0]}, got the shape {matrix.shape}")
    shape = (n, outputs) if columns else (outputs, n)
    if outputs == 1 and coupling.shape == shape[::-1]:
        coupling = coupling.T  # a vector, whichever way it is written
    if coupling.shape != shape:
        raise Invalid(
            f"expected a matrix {names[1]} of shape {shape} beside your {names[0]}, got "
            f"{coupling.shape}"
        )
    return matrix, coupling


def require_invertible(claimed, tolerance, values):
    """Raise `Wrong` for a matrix without an inverse, whatever the units of its rows."""
    lengths = np.linalg.norm(claimed, axis=1)
    failure = f"your matrix has no inverse{where_text(values)}"
    if not lengths.all():
        raise Wrong(f"{failure}: one of its rows or columns is zero")
    if np.linalg.svd(claimed / lengths[:, None], compute_uv=False)[-1] <= 1e-2 * tolerance:
        raise Wrong(failure)


def _vanishes(rows, space, tolerance):
    """Return whether rows vanish on a subspace, relative to their own norms."""
    return bool(
        (np.linalg.norm(rows @ space, axis=1) <= tolerance * np.linalg.norm(rows, axis=1)).all()
    )


def _first_mixed(new_A, new_H, size, side):
    """Return a text on the largest entry that should be zero."""
    upper, shown = new_A[:size, size:], new_H[:, size:]
    in_motion = upper.size and abs(upper).max() >= abs(shown).max(initial=0)
    block = upper if in_motion else shown
    i, j = np.unravel_index(np.argmax(abs(block)), block.shape)
    if in_motion:
        return side.mixed(f"xi{i + 1}", f"eta{j + 1}", block[i, j])
    return side.shown(i, len(new_H), f"eta{j + 1}", block[i, j])
