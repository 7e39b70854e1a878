"""Bases of the unobservable states, and of the uncontrollable combinations by duality.

They are asked for a system, for all values of a parameter, or at the values at which observability
is lost. The combinations are those of the coordinates that no control changes.

A condition such as alpha != 1 can be guessed; the unobservable states at the excluded value cannot.
 The reference is that of `pairs`: the largest invariant subspace in the kernel of the output, at
every value where it can appear.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Number, Table, Vectors
from workbook.checks.contract.tolerance import EXACT, in_decimals, relative_tolerance, rounds_to
from workbook.checks.contract.verdict import UnsuitableData, Wrong
from workbook.checks.references.exceptional_values import judge_where_generic
from workbook.checks.references.invariant_subspaces import to_floats
from workbook.checks.references.pairs import point_of, special_values
from workbook.checks.structure.dual_questions import existence_text
from workbook.checks.tools.comparisons import SameMembers
from workbook.checks.tools.conditions import allowed
from workbook.checks.tools.values import entry_uncertainties, number_at
from workbook.checks.tools.wording import number_text, where_text


def judge_basis(vectors, pair, side, where_suffix=None):
    """Judge a basis of the unobservable states, a list of vectors.

    `where_suffix` describes the parameter value in messages, if `pair` has no parameters.
    """
    n, tolerance = pair.unknowns, relative_tolerance(*vectors)
    for values, point, unobservable in pair.samples_for(vectors):
        where = where_text(values) if where_suffix is None else where_suffix
        claimed = np.array(
            [
                [
                    number_at(entry, values, f"component {i} of your vector {k}")
                    for i, entry in enumerate(vector, 1)
                ]
                for k, vector in enumerate(vectors, 1)
            ]
        ).reshape(len(vectors), n)
        space, _ = np.linalg.qr(to_floats(unobservable, n).T)
        uncertainties = entry_uncertainties(
            sp.Matrix(len(vectors), n, [entry for row in vectors for entry in row]), values
        )
        projection = abs(np.eye(n) - space @ space.T)
        for k, vector in enumerate(claimed, 1):
            size = np.linalg.norm(vector)
            if size == 0:
                raise Wrong(
                    f"your vector {k} is zero{where}; a basis consists of vectors that are not"
                )
            bound = EXACT * size + projection @ uncertainties[k - 1]
            if not (abs(vector - space @ (space.T @ vector)) <= bound).all():
                raise Wrong(f"{_nonzero_text(pair, point, vector, k, side)}{where}")
        directions = claimed / np.linalg.norm(claimed, axis=1)[:, None]
        if len(claimed) and np.linalg.svd(directions, compute_uv=False)[-1] < 1e-2 * tolerance:
            raise Wrong(f"your {len(claimed)} vectors are linearly dependent{where}")
        if len(claimed) < len(unobservable):
            raise Wrong(
                f"{existence_text(len(unobservable), side)}{where}, and it is no combination of those in your "
                "answer"
            )
    if vectors:
        judge_where_generic(
            sp.Matrix(vectors).T,
            pair,
            "one of your vectors is undefined",
            "your vectors are linearly dependent" if len(vectors) > 1 else "your vector is zero",
        )
    return side.basis_right if vectors else side.none_free


def _nonzero_text(pair, point, vector, k, side):
    """Return a text on the first nonzero number among H A^k v, or w A^k B, of a wrong vector."""
    A, H = (to_floats(rows, pair.order) for rows in pair.at(point))
    state = pair.state_of(vector)
    scale, growth = max(np.linalg.norm(state), 1e-30), max(1.0, np.linalg.norm(A))
    for order in range(pair.order):
        for j, value in enumerate(H @ state):
            if abs(value) > 1e-4 * scale * growth**order * max(np.linalg.norm(H[j]), 1e-30):
                return side.shows(k, order, "" if len(H) == 1 else j + 1, number_text(value))
        state = A @ state
    return side.nearly_zero.format(k=k)


def bases_by_value(side):
    """Return the claim {value: basis of the unobservable states} for the datum `system`."""

    def size(data):
        return data["system"].unknowns

    return Table(
        Number(),
        Vectors(size=size),
        lambda data: (
            f"a dictionary such as {{4: [{[3, 1, *[0] * (size(data) - 2)]}]}}, from each value to "
            f"a basis of {side.subspace} there"
        ),
    )


def judge_exceptional_bases(claim, pair, side, at_value):
    """Judge every value of the parameter without observability, with a basis at each.

    The values are finitely many and rational; `at_value(value)` is the pair without the parameter.
    """
    (parameter,) = pair.parameters

    def text(value):
        return f"{parameter} = {sp.N(value, 4) if value.has(sp.Float) else value}"

    named = yield SameMembers(
        [value for value, _ in claim],
        _exceptional_values(pair, parameter),
        _values_agree,
        lambda value: f"at {text(value)} {side.none_free}",
        lambda *_: f"the system is {side.fails} at a value that your answer does not name",
        lambda value: f"the value {text(value)} is listed twice",
    )
    for value, (_, basis) in zip(named, claim):
        judge_basis(basis, at_value(value), side, f" for {parameter} = {value}")
    return (
        f"at these values of the parameter and no others the system is {side.fails}, and the "
        f"vectors are bases of {side.subspace}"
    )


def _exceptional_values(pair, parameter):
    """Return the exceptional values, SymPy rationals."""
    if all(pair.unobservable):
        raise UnsuitableData("there are unobservable states for all values in general position")
    values = special_values(pair.boundaries, parameter)
    roots = {root for poly in pair.boundaries for root in sp.Poly(poly, parameter).real_roots()}
    if any(
        pair.dimension_at({parameter: root})
        for root in roots
        if not root.is_Rational and allowed(parameter, 1 if root > 0 else -1)
    ):
        raise UnsuitableData("there are unobservable states at an irrational value")
    return [value for value in values if pair.unobservable_at(point_of({parameter: value}))]


def _values_agree(value, reference):
    """Return whether two values agree: decimals to three digits, exact ones identically."""
    return (
        rounds_to(value, reference, size=1)
        if in_decimals(value)
        else sp.simplify(value - reference).is_zero
    )
