"""Values are put in all at once where that gives a number, and one after the other where the order
decides."""

import pytest
import sympy as sp

from workbook.checks.contract.verdict import Invalid, Wrong
from workbook.checks.tools import values
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import no_number_text, number_at

x, y = sp.symbols("x y")
ANGLE = sp.Symbol("psi", positive=True)
CASES = {
    "a factor that vanishes beside an infinite one": (x / (y - 1), {x: 0, y: 1}, 0),
    "a later case has no value": (
        sp.Piecewise((2, x > 0), (1, sp.sqrt(x - 5) > 0), evaluate=False),
        {x: 1},
        2,
    ),
    "a symbol that is bound": (sp.Integral(x * y, (x, 0, 1)), {x: 3, y: 2}, 1),
    "a sum": (sp.Sum(x**y, (y, 0, 3)), {x: 2, y: 7}, 15),
    "a sum of nothing": (1 + sp.Sum(x * y, (y, 1, x)), {x: 0}, 1),
    "a geometric series": (sp.Sum(x**y, (y, 0, sp.oo)), {x: sp.Rational(9, 10)}, 10),
    "a slow series": (sp.Sum(y**-2, (y, 1, sp.oo)), {}, float(sp.pi**2 / 6)),
    "floats": (sp.exp(-x) * sp.cos(y), {x: 0.5, y: -2.0}, float(sp.exp(-0.5) * sp.cos(2))),
    "the least, one of which is the greatest": (sp.Min(sp.Max(x, sp.sin(x), 1), 5), {x: 7}, 5),
    "the greatest of two like ones": (sp.Max(sp.sqrt(x) ** 2, x), {x: 2}, 2),
    "a root of a negative number": (sp.sqrt(x * y), {x: -2, y: 8}, 4j),
    "a symbol of which more is assumed": (sp.sqrt(ANGLE**2 * x), {ANGLE: 3, x: 4}, 6),
}


@pytest.mark.parametrize("claim, values, number", CASES.values(), ids=CASES)
def test_the_number_is_that_of_one_after_the_other(claim, values, number):
    one_by_one = complex(claim.subs(values).evalf(20))
    assert number_at(claim, values) == pytest.approx(number) and one_by_one == pytest.approx(number)


def test_what_has_no_value_has_none():
    with pytest.raises(Wrong, match="undefined|infinite"):
        number_at(1 / (x - y), {x: 2, y: 2})
    assert real_at(sp.Piecewise((1, sp.sqrt(x) > 0)), {x: -1}) is None


@pytest.mark.parametrize("limits", [(0, 10**9), (0, sp.oo), (0, sp.Rational(1, 2)), (0, x)])
def test_a_sum_that_cannot_be_written_out_is_refused(limits):
    with pytest.raises(Invalid, match="write it without"):
        number_at(sp.Sum(sp.sin(y**2), (y, *limits)), {})


@pytest.mark.parametrize("term", [1 / y, (-2) ** y, 1 + 0 * y, y])
def test_a_series_that_does_not_converge_has_no_sum(term):
    with pytest.raises(Invalid, match="converge"):
        number_at(sp.Sum(term, (y, 1, sp.oo)), {})


def test_a_plain_expression_is_not_asked_for_one_after_the_other(monkeypatch):
    monkeypatch.setattr(sp.Basic, "subs", None)
    assert values.number_at(x**2 + y / 3, {x: sp.Rational(1, 2), y: 3}) == 1.25


def test_the_greatest_of_no_numbers_is_none():
    with pytest.raises(Wrong, match="undefined"):
        number_at(sp.Max(0, sp.acos(x)), {x: 3})


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        (sp.exp(2000 * x), "too large to be computed with"),
        (-(sp.Integer(10) ** 400) * x, "too large to be computed with"),
        (sp.sqrt(-x), "no real number, or not defined"),
        (1 / (x - 1), "no real number, or not defined"),
    ],
)
def test_a_huge_number_is_a_number(claim, reason):
    assert no_number_text(claim, {x: sp.Integer(1)}) == reason
