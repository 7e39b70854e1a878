"""Questions that are asked both of an output and of a control: one judgement serves both, by transposition.

What a control cannot reach is what the output B^T y of y' = A^T y does not show: a row w with w A = lambda w and w B =
0 is a column there. So each function here takes a `Pair`, of (A, H) or of (A^T, B^T), and the `Side` with the words of
its messages.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import same
from trajlib.checks.contract.verdict import Wrong
from trajlib.checks.tools.conditions import compare, place_text
from trajlib.checks.tools.members import NUMBERS, members
from trajlib.checks.tools.values import matrix_at, number_at
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.invariant_subspaces import (
    characteristic_coefficients,
    different_roots,
    product,
    restricted,
    to_floats,
)


def _output_shows(k, order, number, value):
    """That a motion is seen: the first derivative of an output that is not zero; `number` is empty for a single
    output."""
    name = f"z{number}" + "'" * order if order < 4 else f"the derivative of z{number} of order {order}"
    return f"the motion from your vector {k} gives {name} = {value} at t = 0, not 0"


def _control_changes(k, order, number, value):
    """That a combination w x is changed: the first of its derivatives that holds the control."""
    power = "" if order == 0 else "A " if order == 1 else f"A^{order} "
    which = "the first derivative" if order == 0 else f"the derivative of order {order + 1}"
    return (f"the control u{number} changes your combination {k}: it enters {which} of w x with the coefficient w "
            f"{power}b{number} = "
            f"{value}, not 0")


@dataclass(frozen=True)
class Side:
    """The words of one of the two questions."""

    holds: str
    fails: str
    free: str  # what is left over where the property fails, one of them and several
    several_free: str
    none_free: str
    matrix: str
    block: str  # of the matrix: row or column
    pencil: str
    vector: str  # that shows the loss of an eigenvalue
    spectrum: str = "eigenvalue of A"
    left: str = "what is unseen"  # all that is left over, and why a basis of it is one
    basis_right: str = "from each of them z stays zero, they are independent, and there are no more"
    shows: Callable = _output_shows  # why a vector does not belong
    shows_little: str = "the motion from your vector {k} does not keep z = 0 to three digits"


OUTPUT = Side("observable", "not observable", "independent initial state with z = 0 for all time",
              "independent initial states with z = 0 "
              "for all time", "no initial state but zero gives z = 0 for all time", "N", "row", "(A - lambda E; H)",
              "eigenvector v of A with H v = 0")
CONTROL = Side("controllable", "not controllable", "independent combination of the coordinates that no control changes",
               "independent combinations of the coordinates that no control changes",
               "every combination of the coordinates is changed by "
               "some control", "W", "column", "(A - lambda E, B)", "row w with w A = lambda w and w B = 0",
               left="what no control changes",
               basis_right="no control changes any of them, they are independent, and there are no more",
               shows=_control_changes,
               shows_little="a control changes your combination {k}, though little")


def judge_yes_no(answer, pair, side):
    """Whether the property holds, for all values of the parameters that their assumptions allow."""
    claim = coercion.as_yes_no(answer)
    if not pair.parameters:
        (unseen,) = pair.unseen
        if claim != (not unseen):
            raise Wrong(f"there {how_many(unseen, side)}" if unseen else side.none_free)
        return f"there {how_many(unseen, side)}" if unseen else side.none_free

    def told(values, holds):
        return f"for some values of the parameters there {_number_of(pair.dimension_at(values), side)}"

    try:
        compare(sp.true, pair.parameters, pair.truth(True), told)
    except Wrong as reason:
        if claim:
            raise
        if all(pair.unseen):
            return f"there {_number_of(min(map(len, pair.unseen)), side)}, whatever the parameters"
        return str(reason)
    if not claim:
        raise Wrong(f"{side.none_free}, for any values of the parameters")
    return f"{side.none_free}, for any values of the parameters"


def judge_region(answer, pair, side, holds):
    """The parameters for which the property holds (or, with `holds` False, fails)."""
    wanted = side.holds if holds else side.fails

    def told(values, truth):
        claimed, dimension = not truth, pair.dimension_at(values)
        told = f"there {_number_of(dimension, side)}" if dimension else side.none_free
        if claimed == holds and dimension:
            # An exceptional value itself would be the answer: one parameter of those it depends on stays unsaid.
            hidden = next((p for p in pair.parameters if any(p in poly.free_symbols for poly in pair.boundaries)),
                          pair.parameters[0])
            shown = [(p, x) for p, x in values.items() if p != hidden]
            others = "".join(f"with {p} = {float(x):.4g} "
                             for p, x in shown[:1]) + "".join(f"and {p} = {float(x):.4g} " for p, x in shown[1:])
            return (f"{others}your condition {'holds' if claimed else 'does not hold'} at a value of {hidden} where "
                    f"the system is "
                    f"{side.fails}: {told}")
        return (f"at {place_text(values)} your condition {'holds' if claimed else 'does not hold'}, "
                f"yet the system is "
                f"{side.fails if dimension else side.holds} there: {told}")

    if not holds and len(pair.parameters) == 1:
        answer = _among(answer, pair.parameters[0])
    try:
        agreement = compare(answer, pair.parameters, pair.truth(holds), told)
    except Wrong as reason:
        if not holds and isinstance(answer, (list, tuple)) and len(answer) > 1:
            raise Wrong(f"{reason} (the conditions of a list hold all together; "
                        "alternatives are joined by sp.Or)") from None
        raise
    return f"the system is {wanted} exactly there: {agreement}"


def judge_rank(answer, pair, side):
    """The rank: the order less the number of independent unseen states."""
    claim = coercion.as_integer(answer)
    (unseen,) = pair.unseen
    if claim != pair.order - len(unseen):
        if not 0 <= claim <= pair.order:
            raise Wrong(f"{claim} cannot be the rank of a matrix with {pair.order} "
                        f"{'columns' if side is OUTPUT else 'rows'}")
        raise Wrong(f"the order less the rank is the number of {side.several_free}; by your rank it would be "
                    f"{pair.order - claim}, and "
                    f"there are {'more' if len(unseen) > pair.order - claim else 'fewer'}")
    return f"there {how_many(unseen, side)}" if unseen else side.none_free


def judge_kalman(claim, pair, side):
    """Kalman's matrix by its definition: the output first, then each block is the one before times A."""
    n, m = pair.order, pair.outputs
    for values, place in pair.samples:
        A, H = pair.at(place)
        columns, rows = list(zip(*A)), list(H)
        for k in range(m * (n - 1)):
            rows.append(product(columns, rows[k]))
        said, true = matrix_at(claim, values), to_floats(rows, n)
        right = _right_entries(said, true, claim)
        if right.all():
            continue
        if said.shape == true.T.shape and _right_entries(said.T, true, claim.T).all():
            raise Wrong(f"this is the transpose of {side.matrix}")
        k = int(np.argmin(right.all(axis=1)))
        before = (f"have to be the {side.block}s of {'H' if side is OUTPUT else 'B'}" if k < m else
                  f"has to be {side.block} {k - m + 1} times A" if side is OUTPUT
                  else f"has to be A times {side.block} {k - m + 1}")
        which = ((f"the first {m} {side.block}s" if m > 1 else f"the first {side.block}") if k < m
                 else f"{side.block} {k + 1}")
        if k < m and m == 1:
            before = f"has to be {'H' if side is OUTPUT else 'B'}"
        j = int(np.argmax(abs(said[k] - true[k]) * ~right[k]))
        raise Wrong(f"{which} of {side.matrix} {before}{where_text(values)}: {side.block} {k + 1} of your matrix, with "
                    f"{number_text(said[k, j])} in {'column' if side is OUTPUT else 'row'} {j + 1}, does not fit")
    return f"the {side.block}s are those of the definition, each block the one before times A"


def judge_eigenvalues(answer, pair, side):
    """The different eigenvalues at which the rank of Popov's criterion falls: those of A on the unseen states."""
    true = [different_roots(characteristic_coefficients(restricted(pair.at(place)[0], unseen))) if unseen
            else np.array([])
            for (_, place), unseen in zip(pair.samples, pair.unseen)]
    whole = [np.linalg.eigvals(to_floats(pair.at(place)[0], pair.order)) for _, place in pair.samples]
    return compare_eigenvalues(answer, pair.parameters, [values for values, _ in pair.samples], true, whole, side)


def compare_eigenvalues(answer, parameters, samples, true, whole, side):
    """Compare a set of numbers with those where the rank falls, at every sample; `whole` are all eigenvalues there."""
    for multiplicity in answer.values() if isinstance(answer, dict) else ():
        coercion.as_integer(multiplicity)  # as A.eigenvals() gives them
    parts = members(list(answer) if isinstance(answer, dict) else answer,
                    "a list or a set of eigenvalues; an empty one if there are none", single=NUMBERS)
    claims = [coercion.as_expression(part, parameters) for part in parts]
    for values, lost, every in zip(samples, true, whole):
        scale = max([1e-30, *abs(every)])
        said = [number_at(claim, values, f"your value {k}") for k, claim in enumerate(claims, 1)]
        for number, claim in zip(said, claims):
            if any(same(number, other, claim, scale) for other in lost):
                continue
            if any(same(number, other, claim, scale, computed=1e-7) for other in every):
                raise Wrong(f"{number_text(number)} is {_a(side.spectrum)}{where_text(values)}, but the rank of "
                            f"{side.pencil} does not "
                            f"fall there: there is no {side.vector}")
            raise Wrong(f"{number_text(number)} is no {side.spectrum}{where_text(values)}, so the rank of "
                        f"{side.pencil} is full there")
        named = sum(any(same(number, other, claim, scale) for number, claim in zip(said, claims)) for other in lost)
        if named < len(lost):
            raise Wrong(f"the rank of {side.pencil} falls at {_count(len(lost), 'value')} of "
                        f"lambda{where_text(values)}; your answer names "
                        f"{named or 'none'} of them")
    if not claims:
        return f"the rank of {side.pencil} is full at every {side.spectrum}"
    return f"at each of them there is {_a(side.vector)}, and at no other {side.spectrum}"


def _among(answer, parameter):
    """The condition that a parameter has one of the values in a list or a set; other answers as they are."""
    if isinstance(answer, (list, tuple, set, frozenset)) and answer and not any(
            isinstance(part, (bool, str, sp.logic.boolalg.Boolean)) for part in answer):
        return sp.Or(*[sp.Eq(parameter, coercion.as_number(part)) for part in answer])
    return sp.false if isinstance(answer, (list, tuple, set, frozenset)) and not answer else answer


def _right_entries(said, true, claim):
    """Which entries are right; what is zero is measured by its row."""
    size = np.maximum(np.linalg.norm(true, axis=1), 1e-4 * np.linalg.norm(true))
    return same(said, true, claim, size[:, None])


def how_many(unseen, side):
    return _number_of(len(unseen), side)


def _number_of(count, side):
    return f"is {count} {side.free}" if count == 1 else f"are {count} {side.several_free}"


def _a(noun):
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def _count(number, noun):
    return f"{number} {noun}{'s' if number != 1 else ''}"
