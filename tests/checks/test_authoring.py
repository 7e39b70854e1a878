"""A lecturer's own check: written in a data cell, judged in a notebook and by the grader."""

import pytest
import sympy as sp

from workbook import checks, page
from workbook.checks import authoring
from workbook.notebooks.execution import judge, run_notebook

DATA = """\
import sympy as sp
from workbook import checks
from workbook.checks.authoring import Expression, SameValue, Wrong, allowed_values

q, l = sp.symbols("q l", positive=True)

@checks.judged(Expression("symbols"))
def height(claim, symbols):
    if not claim.has(symbols[0]):
        raise Wrong("your height does not depend on the angle")
    for values in allowed_values(symbols, sp.true, 6):
        yield SameValue(claim, float((l*sp.sin(q)).subs(values)), "the height", values)
    return "it is the height of the hand"

@checks.judged
def word(answer):
    if answer != "up":
        raise Wrong("the hand does not move this way")
    return "it moves up"
"""
CHECK = "checks.report(a_height=height(a_height, [q, l]), a_word=word(a_word))"
NAMES = ["a_height", "a_word"]


@pytest.mark.parametrize(
    "typed, status",
    [
        ("a_height, a_word = l*sp.sin(q), 'up'", ("right", "right")),
        ("a_height, a_word = l*sp.cos(q), 'down'", ("wrong", "wrong")),
        ("a_height, a_word = l, ...", ("wrong", "missing")),
        ("a_height, a_word = [l], 'up'", ("invalid", "right")),
    ],
)
def test_a_check_in_a_data_cell(typed, status):
    result = page.run_cell([DATA, typed], CHECK, names=["", *NAMES])
    assert result["verdicts"] == dict(zip(NAMES, status)), result
    run = run_notebook([DATA, typed, CHECK], NAMES, timeout=60)
    verdicts = judge([("data", DATA), ("check", CHECK)], run, NAMES)
    assert tuple(verdicts[name].status for name in NAMES) == status, verdicts


def test_a_failure_of_the_check_counts_against_nobody():
    @authoring.judged
    def failing(answer):
        return 1 / 0

    assert failing(5).status == "unchecked"


def test_every_public_name_is_described():
    imported = {name for name in vars(authoring) if name.isidentifier() and name[0] != "_"}
    assert imported == set(authoring.__all__)
    assert all(getattr(authoring, name).__doc__.strip() for name in imported)


@pytest.mark.parametrize("answer", [3, sp.Integer(2), 2.5, sp.sqrt(2), 7 / sp.Integer(3)])
def test_no_message_gives_a_reference_away(answer):
    """Neither the reference nor what it is computed from stands in a message on a wrong answer."""
    k = sp.Symbol("k", positive=True)
    reference = sp.Rational(47, 19)
    for verdict in (
        checks.same_value(answer, reference),
        checks.same_expression(answer * k, reference * k),
        checks.same_matrix([[answer * k, 0]], [[reference * k, 0]]),
    ):
        assert verdict.status == "wrong"
        assert not any(text in verdict.message for text in ("47/19", "2.47", "less", "greater"))
