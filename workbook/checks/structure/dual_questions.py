"""Questions about an output or a control: one judgement serves both, by transposition.

What a control cannot reach is what the output B^T y of y' = A^T y does not show: a row w with w A =
lambda w and w B = 0 is a column there. So each function here takes a `Pair`, of (A, H) or of (A^T,
B^T), and the `Side` with the words of its messages.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.claims import Values
from workbook.checks.contract.tolerance import EXACT, agree, in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.invariant_subspaces import (
    characteristic_coefficients,
    different_roots,
    restricted,
)
from workbook.checks.tools.comparisons import SameEntries, SameMembers, SameWord
from workbook.checks.tools.conditions import compare
from workbook.checks.tools.values import numbers_at, uncertainty_at
from workbook.checks.tools.wording import number_text, values_text, where_text


def _output_shows(k, order, number, value):
    """That a motion is seen: the first derivative of an output that is not zero; `number` is empty
    for a single output."""
    name = (
        f"z{number}" + "'" * order if order < 4 else f"the derivative of z{number} of order {order}"
    )
    return f"the motion from your vector {k} gives {name} = {value} at t = 0, not 0"


def _control_changes(k, order, number, value):
    """That a combination w x is changed: the first of its derivatives that holds the control."""
    power = "" if order == 0 else "A " if order == 1 else f"A^{order} "
    which = "the first derivative" if order == 0 else f"the derivative of order {order + 1}"
    return (
        f"the control u{number} changes your combination {k}: it enters {which} of w x with the "
        f"coefficient w {power}b{number} = {value}, not 0"
    )


@dataclass(frozen=True)
class Side:
    """The words of one of the two questions."""

    holds: str
    fails: str
    free: str  # what is left over where the property fails, one of them
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

    @property
    def across(self):
        return "column" if self.block == "row" else "row"


OUTPUT = Side(
    "observable",
    "not observable",
    "initial state, not zero, with z = 0 for all time",
    "no initial state but zero gives z = 0 for all time",
    "N",
    "row",
    "(A - lambda E; H)",
    "eigenvector v of A with H v = 0",
)
CONTROL = Side(
    "controllable",
    "not controllable",
    "combination of the coordinates on which the control has no effect",
    "the control has an effect on every combination of the coordinates",
    "W",
    "column",
    "(A - lambda E, B)",
    "row w with w A = lambda w and w B = 0",
    left="what the control has no effect on",
    shows=_control_changes,
    basis_right="the control has no effect on any of them, they are independent, and there are no more",
    shows_little="the control changes your combination {k}, though little",
)
#: The type of the claim that `judge_eigenvalues` takes.
EIGENVALUES = Values(
    "parameters", expected="a list or a set of eigenvalues; an empty one if there are none"
)


def judge_yes_no(claim, pair, side):
    """Whether the property holds, for all values of the parameters that their assumptions allow."""
    if not pair.parameters:
        (unseen,) = pair.unobservable
        return (yield SameWord(claim, not unseen, left_over(len(unseen), side)))
    holds, reason = True, f"{side.none_free}, for any values of the parameters"
    try:
        compare(
            sp.true,
            pair.parameters,
            pair.reference(True),
            lambda values, _: (
                f"for some values of the parameters {left_over(pair.dimension_at(values), side)}"
            ),
        )
    except Wrong as found:
        always = min(map(len, pair.unobservable))
        holds, reason = (
            False,
            f"{left_over(always, side)}, whatever the parameters" if always else str(found),
        )
    return (yield SameWord(claim, holds, reason))


def judge_region(answer, pair, side, holds=True):
    """The parameters for which the property holds (or, with `holds` False, fails)."""

    def message(values, reference):
        dimension, says = pair.dimension_at(values), "does not hold" if reference else "holds"
        found = f"the system is {side.fails if dimension else side.holds}"
        if reference == holds or not dimension:
            return f"at {values_text(values)} your condition {says}, yet {found} there: {left_over(dimension, side)}"
        # An exceptional value itself would be the answer: one parameter of those it depends on
        # stays unsaid.
        asked = set().union(*(poly.free_symbols for poly in pair.boundaries))
        hidden = next((p for p in pair.parameters if p in asked), pair.parameters[0])
        shown = " and ".join(f"{p} = {float(x):.4g}" for p, x in values.items() if p != hidden)
        return (
            f"{f'with {shown} ' if shown else ''}your condition {says} at a value of {hidden} "
            f"where {found}: {left_over(dimension, side)}"
        )

    try:
        agreement = compare(answer, pair.parameters, pair.reference(holds), message)
    except Wrong as reason:
        if (
            not holds
            and isinstance(answer, (list, tuple))
            and any(isinstance(part, Relational) for part in answer[1:])
        ):
            raise Wrong(
                f"{reason} (the conditions of a list hold all together; alternatives are joined by "
                "`sp.Or`)"
            ) from None
        raise
    return f"the system is {side.holds if holds else side.fails} exactly there: {agreement}"


def judge_kalman(claim, pair, side):
    """Kalman's matrix of a control, transposed, by its definition: B first, then each block is A
    times the one before."""
    m, block = pair.outputs, side.block
    for values, A, H, _ in pair.systems_for(claim):
        true = np.vstack([H @ np.linalg.matrix_power(A, k) for k in range(pair.order)])
        sizes = np.maximum(np.linalg.norm(true, axis=1), 1e-4 * np.linalg.norm(true))[:, None]

        def message(claimed, k, j):
            if (
                claimed.shape == true.T.shape
                and agree(
                    claimed.T,
                    true,
                    claim.T,
                    sizes,
                    uncertain=[
                        [uncertainty_at(e, values) for e in column] for column in claim.T.tolist()
                    ],
                ).all()
            ):
                return f"this is the transpose of {side.matrix}"
            asked = (
                f"{block} {k + 1} of {side.matrix} has to be A times {block} {k - m + 1}"
                if k >= m
                else f"the first {block} of {side.matrix} has to be B"
                if m == 1
                else f"the first {m} {block}s of {side.matrix} have to be the {block}s of B"
            )
            return (
                f"{asked}{where_text(values)}: {block} {k + 1} of your matrix, with "
                f"{number_text(claimed[k, j])} in {side.across} {j + 1}, does not fit"
            )

        yield SameEntries(claim, true, message, values, sizes)
    return f"the {block}s are those of the definition, each block A times the one before"


def judge_eigenvalues(claims, pair, side):
    """The different eigenvalues at which the rank of Popov's criterion falls: those of A on the
    unseen states."""
    lost = [
        different_roots(characteristic_coefficients(restricted(pair.at(point)[0], unseen)))
        if unseen
        else np.array([])
        for _, point, unseen in pair.samples_for(claims)
    ]
    spectra = [
        (values, found, np.linalg.eigvals(A))
        for found, (values, A, _, _) in zip(lost, pair.systems_for(claims))
    ]
    return compare_eigenvalues(claims, spectra, side)


def compare_eigenvalues(claims, spectra, side, equation=None):
    """Compare a set of numbers with those where the rank falls; `spectra` are (values, these, all
    eigenvalues).

    `equation` = (symbol, polynomial whose roots are these numbers) lets the verdict say whether it
    is proved.
    """
    for values, lost, every in spectra:
        scale, where = max([1e-30, *abs(every)]), where_text(values)

        def fits(one, other, computed=EXACT):
            return agree(one[1], other, one[0], scale, computed, uncertainty_at(one[0], values))

        def stranger(one):
            number = number_text(one[1])
            if any(fits(one, other, 1e-7) for other in every):
                return (
                    f"{number} is {_a(side.spectrum)}{where}, but the rank of {side.pencil} does "
                    f"not fall there: there is no {side.vector}"
                )
            return (
                f"{number} is no {side.spectrum}{where}, so the rank of {side.pencil} is full there"
            )

        numbers = numbers_at(claims, values, [f"value {k}" for k in range(1, len(claims) + 1)])
        yield SameMembers(
            list(zip(claims, numbers)),
            list(lost),
            fits,
            stranger,
            lambda *_: (
                f"the rank of {side.pencil} falls at a value of lambda that your answer does not "
                f"name{where}"
            ),
        )
    known = f": {known_roots(claims, *equation)}" if equation else ""
    if not claims:
        return f"the rank of {side.pencil} is full at every {side.spectrum}{known}"
    return f"at each of them there is {_a(side.vector)}, and at no other {side.spectrum}{known}"


def known_roots(claims, symbol, polynomial):
    """How it is known, for the end of a sentence, that numbers which name all roots at sample
    values are the roots.

    It is proved if each is one identically: then they are different roots in general position, and
    all there are.
    """
    if in_decimals(*claims):
        return "to three digits, for sample values"
    left = [sp.numer(sp.together(polynomial.as_expr().subs(symbol, claim))) for claim in claims]
    return (
        "proved"
        if all(sp.expand(part) == 0 for part in left)
        else "to the digits computed, for sample values"
    )


def left_over(count, side):
    """The sentence on whether something is left over; how much is for the student to find."""
    return f"there is {_a(side.free)}" if count else side.none_free


def _a(noun):
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"
