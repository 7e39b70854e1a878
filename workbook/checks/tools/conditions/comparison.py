"""A student's condition, in any form that is read, against the truth."""

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract import condition_coercion
from workbook.checks.contract.verdict import Wrong
from workbook.checks.tools.conditions.decimals import readings
from workbook.checks.tools.conditions.decision import find_difference
from workbook.checks.tools.conditions.evaluation import place_text
from workbook.checks.tools.conditions.plain import is_finite
from workbook.checks.tools.conditions.sampling import try_samples


def compare(answer, parameters, truth, told):
    """Compare a student's condition, in any form that is read, with the truth.

    Returns how the agreement is known, for the end of a sentence. `told(values, holds)` is the
    message at a place, given as SymPy numbers, where the truth is `holds` and the claim says
    otherwise.
    """
    parameters = list(parameters)
    said = readings(read_condition(answer, parameters, truth))
    decided, place = find_difference(said[:1], parameters, truth)
    if decided and place and len(said) > 1:
        # Decimals stand for all numbers that round to them, but a border that they meet exactly is
        # not rounded.
        off_border = [
            sp.Ne(atom.lhs, atom.rhs) for atom in said[0].atoms(Relational) if is_finite(atom)
        ]
        decided, elsewhere = find_difference(said[:1], parameters, truth, sp.And(*off_border))
        if decided and elsewhere:
            decided, place = find_difference(said, parameters, truth)
    if decided and place is None:
        return "proved for all values"
    count = 0
    if not decided:
        place, count = try_samples(said, parameters, truth)
    if place is not None:
        values, holds = place
        raise Wrong(told(values, holds))
    return f"agrees at {count} points"


def read_condition(answer, parameters, truth):
    """A condition on parameters; a set of numbers stands for values of the one that the truth
    depends on, or of the first of several."""
    numbers = isinstance(answer, sp.Set) and not answer.has(sp.ConditionSet, sp.ProductSet)
    if numbers and len(parameters) > 1 and answer.is_subset(sp.S.Reals):
        asked = set().union(*(case.condition.free_symbols for case, _ in truth.cases))
        parameters = [p for p in parameters if p in asked] or parameters
        return condition_coercion.as_condition(answer, parameters[:1])
    return condition_coercion.as_condition(answer, parameters)


def contrary(reason):
    """The message that a condition says otherwise at a place, with the `reason(values)`."""

    def told(values, holds):
        return f"your condition {'does not hold' if holds else 'holds'} for {place_text(values)}; {reason(values)}"

    return told


def decide(condition, symbols, truth):
    """(whether it could be decided, where a condition is not as the truth: (values, what holds), or
    None)."""
    return find_difference([condition], list(symbols), truth)
