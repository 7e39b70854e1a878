"""Answers compared with a reference that the author of a problem gives as data.

They are for quantities that no other check judges by a property. Symbols take exact values of both
signs and several sizes that satisfy what is given; of the values where the reference exists, those
where it is real count, if there are any. A difference of exact rational functions is decided for all
values, and so is whether the answer has a value wherever the reference has one.

Decimals of the answer count to three significant digits, as everywhere, and so do those of the
reference. No message holds a number of the reference: the only ones are those of the sample and of
the answer there.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.answer_forms import counted
from workbook.checks.contract.claims import Expression, MatrixOrVector, Number, symbols_in
from workbook.checks.contract.tolerance import agree, in_decimals
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Wrong, judged
from workbook.checks.references.exceptional_values import MOST_OPERATIONS, judge_everywhere
from workbook.checks.tools.conditions import compare, exactly
from workbook.checks.tools.samples import (
    allowed_values,
    conjunction,
    general_values,
    in_every_case,
)
from workbook.checks.tools.values import entry_uncertainties, matrix_at, number_at
from workbook.checks.tools.wording import entry_text, values_text, where_text

#: The number of samples that satisfy what is given, besides those in general position.
SAMPLES = 6
#: The number of samples with a real reference from which on they alone count.
FEWEST_REAL = 3


def _number(reference):
    return _read(reference, lambda one, _: coercion.as_number(one), "number")


def _expression(reference):
    return _read(reference, coercion.as_expression, "expression")


def _matrix(reference):
    return _read(reference, coercion.as_matrix, "matrix")


def _read(reference, coerce, kind):
    """Return a reference as a matrix; raise `UnsuitableData` if it is of another kind."""
    try:
        read = coerce(reference, sorted(_free_symbols(reference), key=str))
    except Invalid as reason:
        raise UnsuitableData(f"reference: expected a finite {kind}; {reason}") from None
    return read if kind == "matrix" else sp.ImmutableMatrix([[read]])


def _free_symbols(part):
    if isinstance(part, (list, tuple, np.ndarray)):
        return set().union(*map(_free_symbols, part))
    return getattr(part, "free_symbols", set())


@judged(Number(lambda data: _number(data["reference"])))
def same_value(claim, reference):
    """Check a real number against the number that is its reference.

    Can decide always: an exact answer has to be the number itself, a decimal may be off by half a unit
    of its third significant digit.

    Examples
    --------
    >>> checks.same_value(0.318, 1 / sp.pi).status, checks.same_value(0.32, 1 / sp.pi).status
    ('right', 'wrong')
    """
    return _compared(sp.ImmutableMatrix([[claim]]), _number(reference), (), sp.true)


@judged(Expression(lambda data: _expression(data["reference"]), "parameters"))
def same_expression(claim, reference, parameters=(), given=sp.true):
    """Check an expression against the expression that is its reference.

    The answer may hold the symbols of the reference and the parameters, and may be written in any
    form. Where `given` does not hold, it is not judged.

    Can decide when answer and reference are rational functions without decimals; elsewhere they are
    compared at sample values, and the verdict says at how many.

    Examples
    --------
    >>> k = sp.Symbol("k")
    >>> checks.same_expression((k - 1) * (k + 1), k**2 - 1).message
    'it equals what is asked for, proved for all values'
    >>> checks.same_expression(k**2 + 1, k**2 - 1).status
    'wrong'
    """
    return _compared(sp.ImmutableMatrix([[claim]]), _expression(reference), parameters, given)


@judged(
    MatrixOrVector(
        lambda data: _matrix(data["reference"]),
        "parameters",
        shape=lambda data: _matrix(data["reference"]).shape,
    )
)
def same_matrix(claim, reference, parameters=(), given=sp.true):
    """Check a matrix against the matrix that is its reference, entry by entry.

    A vector may be a list, a row or a column. Symbols are those of the reference and the parameters.

    Can decide when the entries of both are rational functions without decimals; elsewhere they are
    compared at sample values, and the verdict says at how many.

    Examples
    --------
    >>> a = sp.Symbol("a", real=True)
    >>> rotation = [[sp.cos(a), -sp.sin(a)], [sp.sin(a), sp.cos(a)]]
    >>> checks.same_matrix([[sp.cos(a), sp.cos(a + sp.pi / 2)], rotation[1]], rotation).status
    'right'
    >>> checks.same_matrix([[sp.cos(a), sp.sin(a)], rotation[1]], rotation).status
    'wrong'
    """
    return _compared(claim, _matrix(reference), parameters, given)


def _compared(claim, reference, parameters, given):
    """Return the message on an answer equal to its reference; raise `Wrong` if it is another one."""
    domain = sp.sympify(conjunction(given))
    symbols = list(dict.fromkeys([*parameters, *symbols_in([reference, domain])]))
    samples = _samples(reference, tuple(symbols), domain)
    points = in_every_case([values for values, _ in samples], [*claim, *reference], domain)
    compared = 0
    for values, true in itertools.zip_longest(points, [numbers for _, numbers in samples]):
        true = _numbers(reference, values) if true is None else true
        if true is not None:
            _judge_at(claim, reference, true, values)
            compared += 1
    exists = [sp.Ne(sp.denom(sp.together(entry)), 0) for entry in reference]
    # near a zero of another denominator of the reference nothing is known of the answer
    if all(c in (True, False) or c.lhs.is_rational_function(*symbols) for c in exists):
        judge_everywhere(
            claim,
            symbols,
            lambda: sp.And(domain, *exists),
            f"your {'expression' if claim.shape == (1, 1) else 'matrix'} has no value",
        )
    if not (claim.free_symbols or reference.free_symbols):
        return "it equals what is asked for"
    proof = _decide(claim, reference, symbols, sp.And(domain, *exists))
    return f"it equals what is asked for, {proof or 'at ' + counted(compared, 'point')}"


@functools.lru_cache(maxsize=16)
def _samples(reference, symbols, domain):
    """Return pairs (allowed values of the symbols, numbers of the reference there); for all answers."""
    allowed = [
        *(values for values in general_values(symbols) if domain.subs(values) == sp.true),
        *allowed_values(symbols, domain, SAMPLES),
    ]
    existing = [
        (values, numbers)
        for values in allowed
        if (numbers := _numbers(reference, values)) is not None
    ]
    if not existing:
        raise UnsuitableData(
            "reference: it has no value at any of the values that were tried; say by `given` for which "
            "values of its symbols it is asked"
        )
    real = [(values, numbers) for values, numbers in existing if not np.imag(numbers).any()]
    return real if len(real) >= FEWEST_REAL else existing


def _numbers(reference, values):
    """Return the numbers of a reference at values of its symbols; None where it has none."""
    try:
        return matrix_at(reference, values)
    except (Invalid, Wrong):
        return None


def _judge_at(claim, reference, true, values):
    """Raise `Wrong` unless the answer has the numbers of its reference at a sample."""
    single, noun = claim.shape == (1, 1), "expression" if values else "number"
    numbers = (
        np.array([[number_at(claim[0], values, f"your {noun}")]])
        if single
        else matrix_at(claim, values)
    )
    size = 0.0 if single else abs(true).max()
    right = agree(numbers, true, claim, size, uncertain=entry_uncertainties(claim, values))
    if in_decimals(reference):
        right |= agree(
            true, numbers, reference, size, uncertain=entry_uncertainties(reference, values)
        )
    if not right.all():
        raise Wrong(
            f"your {noun if single else 'matrix'} is not the one asked for: "
            f"{entry_text(numbers, *divmod(int(right.argmin()), claim.cols))}{where_text(values)}"
        )


def _decide(claim, reference, symbols, domain):
    """Return how it is known that rational functions are equal; "" for others, or with decimals."""
    if in_decimals(*claim, *reference) or not all(
        entry.is_rational_function(*symbols) and sp.count_ops(entry) <= MOST_OPERATIONS
        for entry in [*claim, *reference]
    ):
        return ""
    differences = [sp.expand(sp.numer(sp.together(entry))) for entry in claim - reference]
    return compare(
        sp.And(*(sp.Eq(difference, 0) for difference in differences)),
        symbols,
        exactly(sp.true, domain),
        lambda values, holds: (
            f"your answer is not the one asked for: they differ for {values_text(values)}"
        ),
    )
