"""A declared check has its data in order, names the wrong entry, and covers cases of an answer."""

import inspect

import numpy as np
import pytest
import sympy as sp

from workbook.checks.contract.claims import Expression, Matrix, Values
from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.tools.declared import Truth, at_symbols, declared

a, k, s = sp.symbols("a k s")


@declared(
    Matrix("parameters", shape="A"),
    right="it is the multiple",
    wrong=lambda entry: f"with factor {entry.context}{entry.where}: {entry.text}",
)
def multiple(values, A, factor=2):
    """Check a multiple of a matrix."""
    return Truth(factor * np.array(A.subs(values), dtype=float), 1.0, factor)


@declared(
    Expression("start", "parameters"),
    right=lambda data: f"it is the square of {data['start'][0]}",
    wrong="the square",
    samples=at_symbols("start", count=3),
)
def square(values, start):
    """Check a square."""
    return Truth(float(values[start[0]]) ** 2)


def test_parameters_stand_before_the_options():
    assert list(inspect.signature(multiple).parameters) == [
        "claim",
        "A",
        "parameters",
        "given",
        "factor",
    ]
    assert multiple.__name__ == "multiple" and multiple.__doc__.startswith("Check a multiple")


@pytest.mark.parametrize(
    "answer, options, status",
    [
        ([[2 * k, 0], [0, 2]], {}, "right"),
        ([[3 * k, 0], [0, 3]], {"factor": 3}, "right"),
        ([[2 * k, 0], [0, 3]], {}, "wrong"),
        ([[2 * sp.Abs(k), 0], [0, 2]], {}, "wrong"),
        ([[2 * sp.Abs(k), 0], [0, 2]], {"given": k > 0}, "right"),
        ([[sp.Piecewise((0, k > 50), (2 * k, True)), 0], [0, 2]], {}, "wrong"),
        ([[sp.Piecewise((0, k > 50), (2 * k, True)), 0], [0, 2]], {"given": k < 50}, "right"),
        ([[2 * k / (k - k), 0], [0, 2]], {}, "invalid"),
        ([[2 * a, 0], [0, 2]], {}, "invalid"),
        ([2 * k], {}, "invalid"),
        (..., {}, "missing"),
    ],
)
def test_entries(answer, options, status):
    verdict = multiple(answer, sp.Matrix([[k, 0], [0, 1]]), [k], **options)
    assert verdict.status == status, verdict.message


def test_the_phrase_gets_the_wrong_entry_the_sample_and_the_context():
    verdict = multiple([[2, 0], [0, 5]], sp.eye(2))
    assert verdict.message == "with factor 2: look at the entry (2, 2), where yours is 5"
    assert " for k = " in multiple([[k]], sp.Matrix([[k]]), [k]).message


def test_a_value_at_symbols_of_the_data():
    assert square(s**2, [s]).message == "it is the square of s"
    assert square(s**3, [s]).status == "wrong"
    assert square(k, [s]).status == "invalid"


def test_data_without_a_sample_are_refused():
    with pytest.raises(UnsuitableData):
        multiple([[2]], sp.eye(1), (), sp.false)


@declared(
    Values("parameters", expected="a list of roots"),
    right="these are the roots",
    wrong=("{number} is no root{where}", "a root is not named{where}"),
)
def roots(values, polynomial, symbol):
    """Check the roots of a polynomial."""
    return Truth(list(map(complex, sp.Poly(polynomial.subs(values), symbol).nroots())))


@pytest.mark.parametrize(
    "answer, message",
    [
        ([k, -k], "these are the roots"),
        ({-sp.sqrt(k**2), sp.sqrt(k**2)}, "these are the roots"),
        ([k], "a root is not named for k = "),
        ([k, -k, 2 * k], "is no root for k = "),
        (s, "the answer contains s"),
    ],
)
def test_numbers_in_any_order(answer, message):
    assert message in roots(answer, s**2 - k**2, s, [k]).message
