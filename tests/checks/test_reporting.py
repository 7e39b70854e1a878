"""`checks.report`: one bad answer hides no other, our failures are never the student's, nothing leaks."""

import pytest
import sympy as sp

from trajlib import checks
from trajlib.checks.verdict import Unusable, Verdict, Wrong, judged


@judged
def positive(answer):
    if answer == "explode":
        raise ZeroDivisionError("in the check")
    if answer <= 0:
        raise Wrong("not positive")
    return "it is positive"




def test_all_right_is_shown_and_does_not_raise(capsys):
    assert checks.report(a=Verdict("right", "fine"), b=Verdict("right", "fine")) is None
    assert capsys.readouterr().out == "✓ a: right: fine\n✓ b: right: fine\n"


@pytest.mark.parametrize("status", ["wrong", "missing", "invalid", "unchecked"])
def test_anything_else_raises_and_names_every_answer(status):
    with pytest.raises(checks.NotYet) as raised:
        checks.report(a=Verdict("right", "fine"), b=Verdict(status, "because"))
    assert raised.value._render_traceback_() == ["✓ a: right: fine", raised.value._render_traceback_()[1]]
    assert f"b: {status}: because" in str(raised.value)


def test_right_and_wrong():
    assert positive(1) == Verdict("right", "it is positive")
    assert positive(-1) == Verdict("wrong", "not positive")


def test_failures_of_a_check_are_unchecked():
    verdict = positive("explode")
    assert verdict.status == "unchecked" and "not yours" in verdict.message


@pytest.mark.parametrize("stub", [..., [1, ...], (1, [..., 2]), {"a": ...}])
def test_stubs_are_missing_however_deep(stub):
    assert positive(stub).status == "missing"


def test_an_unusable_answer_is_invalid_with_its_reason():
    assert positive(Unusable("functions are called by value")) == Verdict("invalid", "functions are called by value")


def test_a_changed_check_cell_earns_nothing():
    with pytest.raises(checks.NotYet, match="unchecked"):
        checks.report(a=True)


def test_collecting_neither_shows_nor_raises(capsys):
    with checks.collecting() as verdicts:
        checks.report(a=Verdict("wrong", "no"))
        checks.report(b=Verdict("right", "yes"))
    assert capsys.readouterr().out == "" and {n: v.status for n, v in verdicts.items()} == {"a": "wrong", "b": "right"}
    with pytest.raises(checks.NotYet):
        checks.report(a=Verdict("wrong", "no"))


def test_no_message_holds_the_reference():
    k1, k2, s = sp.symbols("k1 k2 s")
    verdict = checks.stability_region(k1 > 0, s**3 + k1 * s**2 + k2 * s + 1, [k1, k2])
    assert "k1*k2" not in verdict.message and "1/k1" not in verdict.message
