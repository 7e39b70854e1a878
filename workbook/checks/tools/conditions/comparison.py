"""Comparison of a student's condition with its reference."""

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract import condition_coercion
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.conditions.decimals import readings
from workbook.checks.tools.conditions.decision import find_difference
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
    parameters = list(parameters)
    interpretations = readings(read_condition(answer, parameters, reference))
    decided, difference = find_difference(interpretations[:1], parameters, reference)
    if decided and difference and len(interpretations) > 1:
        # Decimals stand for all numbers that round to them, but a border that they meet exactly is
        # not rounded.
        off_border = [
            sp.Ne(atom.lhs, atom.rhs)
            for atom in interpretations[0].atoms(Relational)
            if is_finite(atom)
        ]
        decided, elsewhere = find_difference(
            interpretations[:1], parameters, reference, sp.And(*off_border)
        )
        if decided and elsewhere:
            decided, difference = find_difference(interpretations, parameters, reference)
    if decided and difference is None:
        return "proved for all values"
    count = 0
    if not decided:
        difference, count = try_samples(interpretations, parameters, reference)
    if difference is not None:
        values, holds = difference
        raise Wrong(message(values, holds))
    return f"agrees at {count} points"


def read_condition(answer, parameters, reference):
    """Return an answer as a condition on parameters.

    A set of numbers stands for values of the parameter that the reference depends on, or of the first
    of several.
    """
    numbers = isinstance(answer, sp.Set) and not answer.has(sp.ConditionSet, sp.ProductSet)
    if numbers and len(parameters) > 1 and answer.is_subset(sp.S.Reals):
        asked = set().union(*(case.condition.free_symbols for case, _ in reference.cases))
        parameters = [p for p in parameters if p in asked] or parameters
        return condition_coercion.as_condition(answer, parameters[:1])
    return condition_coercion.as_condition(answer, parameters)


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
