"""Questions about an output or a control, judged by the same code through duality.

A row w with w A = lambda w and w B = 0 is an unobservable eigenvector of y' = A^T y with the output
B^T y. So each function here takes a `Pair`, of (A, H) or of (A^T, B^T), and the `Side` with the
wording of its messages.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.claims import Values
from workbook.checks.contract.tolerance import EXACT, agree, in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.references.fixed_modes import fixed_eigenvalues
from workbook.checks.tools.comparisons import SameEntries, SameMembers, SameWord
from workbook.checks.tools.conditions import compare
from workbook.checks.tools.values import numbers_at, uncertainty_at
from workbook.checks.tools.wording import number_text, values_text, where_text, with_article


def _output_shows(k, order, number, value):
    """Return a text on the first nonzero derivative of an output; `number` is "" for a single one."""
    z = f"z{number}"
    name = z + "'" * order if order < 4 else f"the derivative of {z} of order {order}"
    return f"the motion from your vector {k} gives {name} = {value} at t = 0, not 0"


def _control_changes(k, order, number, value):
    """Return a text on the first derivative of a combination w x that the control enters."""
    power = "" if order == 0 else "A " if order == 1 else f"A^{order} "
    derivative = "first derivative" if order == 0 else f"derivative of order {order + 1}"
    return (
        f"the control u{number} changes your combination {k}: it enters the {derivative} of w x "
        f"with the coefficient w {power}b{number} = {value}, not 0"
    )


@dataclass(frozen=True)
class Side:
    """The wording of one of the two questions."""

    holds: str
    fails: str
    free: str  # an element of the subspace where the property fails
    none_free: str
    matrix: str
    block: str  # of the matrix: row or column
    pencil: str
    vector: str  # the eigenvector of the PBH test
    spectrum: str = "eigenvalue of A"
    subspace: str = "the unobservable states"
    basis_right: str = "from each of them z stays zero, they are independent, and there are no more"
    shows: Callable = _output_shows  # text on a wrong vector of a basis
    nearly_zero: str = "the motion from your vector {k} does not keep z = 0 to three digits"

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
    "(A - lambda I; H)",
    "eigenvector v of A with H v = 0",
)
CONTROL = Side(
    "controllable",
    "not controllable",
    "linear combination of the coordinates, not zero, on which the control has no effect",
    "the control has an effect on every linear combination of the coordinates but zero",
    "W",
    "column",
    "(A - lambda I, B)",
    "row w with w A = lambda w and w B = 0",
    subspace="the combinations on which the control has no effect",
    shows=_control_changes,
    basis_right="the control has no effect on any of them, they are independent, and there are no more",
    nearly_zero="the control changes your combination {k}, though little",
)
#: The type of the claim that `judge_eigenvalues` takes.
EIGENVALUES = Values(
    "parameters", expected="a list or a set of eigenvalues; an empty one if there are none"
)


def judge_yes_no(claim, pair, side):
    """Judge whether the property holds for all values that the assumptions of the symbols allow."""
    if not pair.parameters:
        (unobservable,) = pair.unobservable
        return (yield SameWord(claim, not unobservable, existence_text(len(unobservable), side)))
    try:
        compare(
            sp.true,
            pair.parameters,
            pair.reference(True),
            lambda values, _: (
                f"for some values of the parameters {existence_text(pair.dimension_at(values), side)}"
            ),
        )
    except Wrong as error:
        always = all(pair.unobservable)
        reason = f"{existence_text(1, side)}, whatever the parameters" if always else str(error)
        return (yield SameWord(claim, False, reason))
    return (yield SameWord(claim, True, f"{side.none_free}, for any values of the parameters"))


def judge_region(answer, pair, side, holds=True):
    """Judge the parameters for which the property holds (or, with `holds` False, fails)."""

    def message(values, reference):
        dimension, claim_text = pair.dimension_at(values), "does not hold" if reference else "holds"
        property_text = f"the system is {side.fails if dimension else side.holds}"
        if reference == holds or not dimension:
            return (
                f"at {values_text(values)} your condition {claim_text}, yet {property_text} there: "
                f"{existence_text(dimension, side)}"
            )
        # An exceptional value itself would be the answer: the message omits one of the parameters
        # that it depends on.
        dependent = set().union(*(poly.free_symbols for poly in pair.boundaries))
        hidden = next((p for p in pair.parameters if p in dependent), pair.parameters[0])
        shown = " and ".join(f"{p} = {float(x):.4g}" for p, x in values.items() if p != hidden)
        return (
            f"{f'with {shown} ' if shown else ''}your condition {claim_text} at a value of {hidden} "
            f"where {property_text}: {existence_text(dimension, side)}"
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
    """Judge the transposed Kalman matrix of a control: B first, then each block A times the last."""
    m, block = pair.outputs, side.block
    for values, A, H, _ in pair.systems_for(claim):
        true = np.vstack([H @ np.linalg.matrix_power(A, k) for k in range(pair.order)])
        sizes = np.maximum(np.linalg.norm(true, axis=1), 1e-4 * np.linalg.norm(true))[:, None]

        def message(claimed, k, j):
            if claimed.shape == true.T.shape:
                uncertain = [[uncertainty_at(e, values) for e in row] for row in claim.T.tolist()]
                if agree(claimed.T, true, claim.T, sizes, uncertain=uncertain).all():
                    return f"this is the transpose of {side.matrix}"
            requirement = (
                f"{block} {k + 1} of {side.matrix} has to be A times {block} {k - m + 1}"
                if k >= m
                else f"the first {block} of {side.matrix} has to be B"
                if m == 1
                else f"the first {m} {block}s of {side.matrix} have to be the {block}s of B"
            )
            return (
                f"{requirement}{where_text(values)}: {block} {k + 1} of your matrix, with "
                f"{number_text(claimed[k, j])} in {side.across} {j + 1}, does not fit"
            )

        yield SameEntries(claim, true, message, values, sizes)
    return f"the {block}s are those of the definition, each block A times the one before"


def judge_eigenvalues(claims, pair, side):
    """Judge the different eigenvalues of the PBH test: those of A on the unobservable states."""
    spectra = [
        (values, roots, np.linalg.eigvals(A))
        for roots, (values, A, *_) in zip(fixed_eigenvalues(pair, claims), pair.systems_for(claims))
    ]
    return compare_eigenvalues(claims, spectra, side)


def compare_eigenvalues(claims, spectra, side, equation=None):
    """Compare a set of numbers with those where the rank falls.

    `spectra` are rows (values, these numbers, all eigenvalues). With `equation` = (symbol,
    polynomial whose roots are these numbers) the verdict says whether it is proved.
    """
    for values, fixed, eigenvalues in spectra:
        scale, where = max([1e-30, *abs(eigenvalues)]), where_text(values)

        def matches(entry, eigenvalue, computed=EXACT):
            claim, number = entry
            return agree(number, eigenvalue, claim, scale, computed, uncertainty_at(claim, values))

        def extra_text(entry):
            number = number_text(entry[1])
            if any(matches(entry, eigenvalue, 1e-7) for eigenvalue in eigenvalues):
                return (
                    f"{number} is {with_article(side.spectrum)}{where}, but the rank of {side.pencil} does "
                    f"not fall there: there is no {side.vector}"
                )
            return (
                f"{number} is no {side.spectrum}{where}, so the rank of {side.pencil} is full there"
            )

        numbers = numbers_at(claims, values, [f"value {k}" for k in range(1, len(claims) + 1)])
        yield SameMembers(
            list(zip(claims, numbers)),
            list(fixed),
            matches,
            extra_text,
            lambda *_: (
                f"the rank of {side.pencil} falls at a value of lambda that your answer does not "
                f"name{where}"
            ),
        )
    evidence = f": {roots_evidence(claims, *equation)}" if equation else ""
    if not claims:
        return f"the rank of {side.pencil} is full at every {side.spectrum}{evidence}"
    return f"at each of them there is {with_article(side.vector)}, and at no other {side.spectrum}{evidence}"


def roots_evidence(claims, symbol, polynomial):
    """Return how it is known that numbers are all roots of a polynomial, given they are at samples.

    It is proved if each is a root identically: then they are different roots in general position,
    and there are no others.
    """
    if in_decimals(*claims):
        return "to three digits, for sample values"
    residuals = (sp.together(polynomial.as_expr().subs(symbol, claim)) for claim in claims)
    proved = all(sp.expand(sp.numer(part)) == 0 for part in residuals)
    return "proved" if proved else "to the digits computed, for sample values"


def existence_text(count, side):
    """Return a text on whether the subspace is zero; its dimension is for the student to find."""
    return f"there is {with_article(side.free)}" if count else side.none_free
