"""Bases of the unobservable states, and of the uncontrollable combinations by duality.

They are asked for a system, for all values of a parameter, or at the values at which observability
is lost. The combinations are those of the coordinates that no control changes.

A condition such as alpha != 1 may be guessed; the states that stay unobservable at the value left out may
not. The reference is that of `pairs`: the largest invariant subspace in the kernel of the output, at
every value where it can appear.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Number, Table, Vectors
from workbook.checks.contract.tolerance import EXACT, in_decimals, relative_tolerance, rounds_to
from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.exceptional_values import judge_everywhere
from workbook.checks.references.invariant_subspaces import to_floats
from workbook.checks.references.pairs import point_of, special_values
from workbook.checks.structure.dual_questions import left_over
from workbook.checks.tools.comparisons import SameMembers
from workbook.checks.tools.conditions import allowed
from workbook.checks.tools.values import entry_uncertainties, number_at
from workbook.checks.tools.wording import number_text, where_text


def judge_basis(vectors, pair, side, at=None):
    """A basis of what is unseen, a list of vectors; `at` tells of the place, if `pair` does not."""
    n, tolerance = pair.unknowns, relative_tolerance(*vectors)
    for values, point, unseen in pair.samples_for(vectors):
        where = where_text(values) if at is None else at
        claimed = np.array(
            [
                [
                    number_at(entry, values, f"component {i} of your vector {k}")
                    for i, entry in enumerate(vector, 1)
                ]
                for k, vector in enumerate(vectors, 1)
            ]
        ).reshape(len(vectors), n)
        space, _ = np.linalg.qr(to_floats(unseen, n).T)
        left_open = entry_uncertainties(
            sp.Matrix(len(vectors), n, [entry for one in vectors for entry in one]), values
        )
        across = abs(np.eye(n) - space @ space.T)
        for k, vector in enumerate(claimed, 1):
            size = np.linalg.norm(vector)
            if size == 0:
                raise Wrong(
                    f"your vector {k} is zero{where}; a basis consists of vectors that are not"
                )
            if not (
                abs(vector - space @ (space.T @ vector)) <= EXACT * size + across @ left_open[k - 1]
            ).all():
                raise Wrong(f"{_seen(pair, point, vector, k, side)}{where}")
        if (
            len(claimed)
            and np.linalg.svd(claimed / np.linalg.norm(claimed, axis=1)[:, None], compute_uv=False)[
                -1
            ]
            < 1e-2 * tolerance
        ):
            raise Wrong(f"your {len(claimed)} vectors are linearly dependent{where}")
        if len(claimed) < len(unseen):
            raise Wrong(
                f"{left_over(len(unseen), side)}{where}, and it is no combination of those in your "
                "answer"
            )
    if vectors:
        judge_everywhere(
            sp.Matrix(vectors).T,
            pair.parameters,
            lambda: pair.generic_condition,
            "one of your vectors is undefined",
            "your vectors are linearly dependent" if len(vectors) > 1 else "your vector is zero",
        )
    return side.basis_right if vectors else side.none_free


def _seen(pair, point, vector, k, side):
    """Why a vector does not belong: the first of the numbers H A^k v, or w A^k B, that is not
    zero."""
    A, H = (to_floats(rows, pair.order) for rows in pair.at(point))
    state = pair.state_of(vector)
    scale, growth = max(np.linalg.norm(state), 1e-30), max(1.0, np.linalg.norm(A))
    for order in range(pair.order):
        for j, value in enumerate(H @ state):
            if abs(value) > 1e-4 * scale * growth**order * max(np.linalg.norm(H[j]), 1e-30):
                return side.shows(k, order, "" if len(H) == 1 else j + 1, number_text(value))
        state = A @ state
    return side.shows_little.format(k=k)


def bases_by_value(side):
    """The claim {value: basis of what is unseen there}, of vectors with the unknowns of the datum
    `system`."""

    def size(data):
        return data["system"].unknowns

    return Table(
        Number(),
        Vectors(size=size),
        lambda data: (
            f"a dictionary such as {{4: [{[3, 1, *[0] * (size(data) - 2)]}]}}, from each value to "
            f"a basis of {side.left} there"
        ),
    )


def judge_where_lost(claim, pair, side, at_value):
    """Every real value of the single parameter at which something is unseen, with a basis of what
    is unseen there.

    For what is lost at finitely many values, all of them rational; `at_value(value)` is the pair
    without the parameter.
    """
    (parameter,) = pair.parameters
    lost = _values_where_lost(pair, parameter)
    named = yield SameMembers(
        [value for value, _ in claim],
        lost,
        _same,
        lambda value: (
            f"at {parameter} = {sp.N(value, 4) if value.has(sp.Float) else value} {side.none_free}"
        ),
        lambda *_: f"the system is {side.fails} at a value that your answer does not name",
        lambda value: f"the value {parameter} = {value} comes twice",
    )
    for value, (_, basis) in zip(named, claim):
        judge_basis(basis, at_value(value), side, f" for {parameter} = {value}")
    return (
        f"at these values of the parameter and no others the system is {side.fails}, and the "
        f"vectors are bases of {side.left}"
    )


def _values_where_lost(pair, parameter):
    """The exceptional values, SymPy rationals."""
    if all(pair.unobservable):
        raise ValueError("something is unseen for all values in general position")
    values = special_values(pair.boundaries, parameter)
    real = {
        root
        for poly in pair.boundaries
        for root in sp.Poly(poly, parameter).real_roots()
        if not root.is_Rational
    }
    if any(
        pair.dimension_at({parameter: root})
        for root in real
        if allowed(parameter, 1 if root > 0 else -1)
    ):
        raise ValueError("something is unseen at an irrational value")
    return [value for value in values if pair.unobservable_at(point_of({parameter: value}))]


def _same(value, other):
    """Decimals count to three digits; what is exact has to be right."""
    return (
        rounds_to(value, other, size=1)
        if in_decimals(value)
        else sp.simplify(value - other).is_zero
    )
