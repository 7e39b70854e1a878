"""Comparison of a student's condition with its reference."""

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract import condition_coercion
from workbook.checks.contract.tolerance import in_decimals
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.conditions.decimals import (
    opened,
    readings,
    with_either_strictness,
    with_plain_powers,
)
from workbook.checks.tools.conditions.decision import find_difference, find_numbers
from workbook.checks.tools.conditions.polynomial_form import is_finite
from workbook.checks.tools.conditions.sampling import try_samples
from workbook.checks.tools.wording import values_text


def compare(answer, parameters, reference, message):
    """Compare a student's condition with its reference.

    Parameters
    ----------
    answer : object
        The condition in any form that is read.
    parameters : list of sympy.Symbol
        Its symbols.
    reference : ReferenceCondition
        Where the condition has to hold.
    message : callable
        `message(values, holds)` builds the message at a point, given as SymPy numbers, where the
        reference is `holds` and the claim is not.

    Returns
    -------
    str
        How the agreement is known, for the end of a sentence.

    Raises
    ------
    Wrong
        If there is a point where they differ.
    """
    parameters, wrong = list(parameters), None
    for claim in _read_conditions(answer, parameters, reference):
        try:
            return _compare(with_plain_powers(claim), parameters, reference, message)
        except Wrong as reason:
            wrong = wrong or reason
    raise wrong


def _compare(claim, parameters, reference, message):
    decided, difference = find_difference([claim], parameters, reference)
    if in_decimals(claim) and not (decided and difference is None):
        decided, difference = _find_difference_in_decimals(claim, parameters, reference)
    evidence = "to three digits, for all values" if in_decimals(claim) else "proved for all values"
    if not decided:
        difference, count = try_samples(readings(claim), parameters, reference)
        evidence = f"agrees at {count} points"
        if in_decimals(claim):
            evidence += " to three digits"
    if difference is not None:
        values, holds = difference
        raise Wrong(message(values, holds))
    return evidence


def _find_difference_in_decimals(claim, parameters, reference):
    """Return (decided, difference) of a claim with decimals, whatever numbers they stand for."""
    as_written, intervals = opened(claim)
    decided, numbers = find_numbers(as_written, intervals, parameters, reference)
    if decided and not numbers:
        # perhaps there are some where only what is on the borders differs
        _, numbers = find_numbers(
            *with_either_strictness(as_written, intervals), parameters, reference
        )
        _, difference = (
            find_difference([as_written.xreplace(numbers)], parameters, reference)
            if numbers
            else _find_strip(claim, parameters, reference)
        )
        # that there are no numbers is not enough for a difference
        return bool(difference), difference
    return (True, None) if decided else _find_strip(claim, parameters, reference)


def _find_strip(claim, parameters, reference):
    """Return (decided, difference) of a claim outside the strips that its decimals stand for."""
    interpretations = readings(claim)
    # A border that decimals meet exactly is not rounded.
    off_border = [
        sp.Ne(atom.lhs, atom.rhs)
        for atom in interpretations[0].atoms(Relational)
        if is_finite(atom)
    ]
    decided, difference = find_difference(
        interpretations[:1], parameters, reference, sp.And(*off_border)
    )
    if decided and difference:
        return find_difference(interpretations, parameters, reference)
    return find_difference(interpretations[:1], parameters, reference)


def _read_conditions(answer, parameters, reference):
    """Return the conditions on parameters that an answer may be.

    A set of numbers stands for values of one of the parameters in the reference.
    """
    numbers = isinstance(answer, sp.Set) and not answer.has(sp.ConditionSet, sp.ProductSet)
    if numbers and len(parameters) > 1 and answer.is_subset(sp.S.Reals):
        used = set().union(*(case.condition.free_symbols for case, _ in reference.cases))
        return [
            condition_coercion.as_condition(answer, [p])
            for p in [p for p in parameters if p in used] or parameters[:1]
        ]
    return [condition_coercion.as_condition(answer, parameters)]


def contradiction_message(reason):
    """Return the function that builds the message on a point where a condition is wrong.

    Parameters
    ----------
    reason : callable
        `reason(values)` explains how it is there.
    """

    def message(values, holds):
        return f"your condition {'does not hold' if holds else 'holds'} for {values_text(values)}; {reason(values)}"

    return message


def decide(condition, symbols, reference):
    """Return whether a condition could be decided, and a difference from its reference.

    Returns
    -------
    tuple
        (decided, (values, what holds)), the second None without a difference.
    """
    return find_difference([condition], list(symbols), reference)
