"""A check that declares the type of its answer gets it read, and every comparison that it yields is done."""

import pytest
import sympy as sp

from trajlib.checks import judged
from trajlib.checks.contract.claims import Expression, Expressions, symbols_in
from trajlib.checks.tools.comparisons import Agrees, Same

x, k = sp.symbols("x k", positive=True)


@judged(Expression("x", "parameters"))
def twice(claim, x, parameters=(k,)):
    """Twice the product."""
    for value in (1, 2, 3):
        yield Same(claim, 2.5 * 2 * value, "twice the product", {x: 2.5, k: value})
    return "it is"


@pytest.mark.parametrize("answer, status", [
    (2 * x * k, "right"), (2.0 * sp.Symbol("x") * k, "right"), (2 * x, "wrong"), (2.1 * x * k, "wrong"),
    (x + sp.Symbol("y"), "invalid"), (x / (k - 2), "wrong"), ("2", "invalid"), (..., "missing"),
])
def test_an_expression(answer, status):
    assert twice(answer, x).status == status, twice(answer, x).message


def test_the_last_comparison_counts():
    assert twice(sp.Piecewise((2 * x * k, k < 3), (0, True)), x).message == (
        "for x = 2.5, k = 3 twice the product is 15; your expression gives 0")


def test_the_form_depends_on_the_data():
    @judged(Expressions("A", length=lambda data: data["A"].rows))
    def rows(claims, A):
        return f"{len(claims)}"

    assert rows([k, 1], sp.diag(k, 2)).message == "2"
    assert rows([k], sp.diag(k, 2)).status == rows([x, 1], sp.diag(k, 2)).status == "invalid"


def test_a_truth_that_cannot_be_computed_is_no_verdict_on_the_answer():
    @judged(Expression())
    def lost(claim):
        yield Same(claim, float("nan"), "the number", {})

    assert lost(1).status == "unchecked"


def test_a_condition_agrees():
    Agrees(x > 1, True, "it holds", {x: 2}).judge()
    with pytest.raises(Exception, match="for x = 0.5 it fails, yet your condition holds"):
        Agrees(x < 1, False, "it fails", {x: 0.5}).judge()


def test_symbols_in_data():
    assert symbols_in([x, {k: sp.Interval(0, 1)}, sp.Matrix([[x * k]]), None, 3]) == [x, k, k, x]
