"""`checks.report`: one bad answer hides no other, our failures are never the student's, nothing
leaks."""

import decimal
import fractions
import re
from collections import OrderedDict, namedtuple

import casadi
import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from workbook import checks
from workbook.checks.contract import reporting
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.traversal import EncodingError
from workbook.checks.contract.verdict import Unusable, Verdict, Wrong, judged
from workbook.systems import Linear, Process


@judged
def positive(answer):
    if answer == "explode":
        raise ZeroDivisionError("in the check")
    if answer <= 0:
        raise Wrong("not positive")
    return "it is positive"


@judged
def told(answer):
    return f"{type(answer).__name__} {answer!r}"


def test_all_right_is_shown_and_does_not_raise(capsys):
    assert checks.report(a=Verdict("right", "fine"), b=Verdict("right", "fine")) is None
    assert capsys.readouterr().out == "✓ a: right: fine\n✓ b: right: fine\n"


@pytest.mark.parametrize("status", ["wrong", "missing", "invalid", "unchecked"])
def test_anything_else_raises_and_names_every_answer(status):
    with pytest.raises(checks.NotYet) as raised:
        checks.report(a=Verdict("right", "fine"), b=Verdict(status, "because"))
    assert raised.value._render_traceback_() == [
        "✓ a: right: fine",
        raised.value._render_traceback_()[1],
    ]
    assert f"b: {status}: because" in str(raised.value)


def test_formulas_of_a_verdict_are_set_in_a_notebook_and_typed_in_a_terminal():
    verdict = Verdict(
        "wrong", "at k1 = -2 the root of x**2 + 2*k1*x >= 0 is <b>0.5</b>", "Was lambda left out?"
    )
    shown, typed = (
        reporting.as_html({"a_region": verdict}),
        reporting.as_text({"a_region": verdict}),
    )
    assert (
        "at <i>k</i><sub>1</sub> = −2 the root of <i>x</i><sup>2</sup> + "
        "2\u202f<i>k</i><sub>1</sub>\u202f<i>x</i> ≥ 0 is &lt;<i>b</i>&gt;0.5&lt;/<i>b</i>&gt;"
    ) in shown
    assert ">a_region</code>" in shown and "Was λ left out?" in shown
    assert typed.splitlines() == [f"✗ a_region: wrong: {verdict.message}", "  Was lambda left out?"]


def test_the_mistake_stands_below_what_failed_and_only_where_the_problem_is_known():
    k1, k2, s = sp.symbols("k1 k2 s")

    def said(*problem, claim):
        with pytest.raises(checks.NotYet) as raised:
            checks.report(
                *problem,
                a_region=checks.stability_region(claim, s**3 + k1 * s**2 + k2 * s + 1, [k1, k2]),
            )
        return str(raised.value).split("\n")

    wrong, question, hint = said("1.15", claim=[k2 > 0, k1 > 0])
    assert "1/2" in wrong and question.strip().endswith("?") and hint.strip().startswith("Hint 1: ")
    assert said(claim=[k2 > 0, k1 > 0]) == said("99.1", claim=[k2 > 0, k1 > 0]) == [wrong]
    assert (
        len(said("1.15", claim=k1 > 7))
        == len(said("1.15", claim=...))
        == len(said("1.15", claim="no"))
        == 1
    )


def test_right_and_wrong():
    assert positive(1) == Verdict("right", "it is positive")
    assert positive(-1) == Verdict("wrong", "not positive")


def test_failures_of_a_check_are_unchecked():
    verdict = positive("explode")
    assert verdict.status == "unchecked" and "not yours" in verdict.message


@pytest.mark.parametrize("stub", [..., [1, ...], (1, [..., 2]), {"a": ...}])
def test_stubs_are_missing_however_deep(stub):
    assert positive(stub).status == "missing"


@pytest.mark.parametrize(
    "answer",
    [[..., None], {1, ...}, np.array([..., 1])],
    ids=["beside what cannot cross", "set", "array"],
)
def test_stubs_beside_other_things(answer):
    assert positive(answer).status == ("invalid" if None in list(answer) else "missing")


ODD = [
    fractions.Fraction(1, 3),
    np.str_("yes"),
    np.float32(2),
    np.array([1, None]),
    np.array([[sp.pi, 1]]),
    mpmath.mpf(3),
    casadi.DM(2),
    sp.Array([1, 2]),
    sp.Symbol("x"),
    ...,
    None,
    positive,
    casadi.SX(1),
    decimal.Decimal(1),
    OrderedDict(),
    range(3),
    object,
    namedtuple("P", "x")(1),
    sp.Sum(1, (sp.Symbol("n"), 1, 2)),
    10**2000,
]
leaves = st.integers(0, len(ODD) - 1).map(ODD.__getitem__) | st.integers() | st.text(max_size=5)
keys = (
    st.text(max_size=3)
    | st.integers(-9, 9).map(np.int64)
    | st.text(max_size=3).map(np.str_)
    | st.just((1,))
)
answers = st.recursive(
    leaves,
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.tuples(inner, inner)
        | st.dictionaries(keys, inner, max_size=3)
    ),
    max_leaves=6,
)


@settings(deadline=None, derandomize=True)
@given(answers)
def test_a_verdict_is_that_on_the_answer_as_it_crosses(answer):
    try:
        received = decode(encode(answer))
    except EncodingError as error:
        received = Unusable(str(error))
    assert told(answer) == told(received)


def test_a_check_cannot_change_the_answer():
    @judged
    def greedy(answer):
        answer.clear()
        return "it is mine"

    mine = [1, 2]
    assert greedy(mine).status == "right" and mine == [1, 2]


def test_an_answer_that_holds_itself_is_invalid():
    cycle = []
    cycle.append(cycle)
    assert "levels allowed" in positive(cycle).message


def test_an_unusable_answer_is_invalid_with_its_reason():
    assert positive(Unusable("functions are called by value")) == Verdict(
        "invalid", "functions are called by value"
    )


def test_a_changed_check_cell_earns_nothing():
    with pytest.raises(checks.NotYet, match="unchecked"):
        checks.report(a=True)


def test_collecting_neither_shows_nor_raises(capsys):
    with checks.collecting() as verdicts:
        checks.report(a=Verdict("wrong", "no"))
        checks.report(b=Verdict("right", "yes"))
    assert capsys.readouterr().out == "" and {n: v.status for n, v in verdicts.items()} == {
        "a": "wrong",
        "b": "right",
    }
    with pytest.raises(checks.NotYet):
        checks.report(a=Verdict("wrong", "no"))


def test_no_message_holds_the_reference():
    k1, k2, s = sp.symbols("k1 k2 s")
    verdict = checks.stability_region(k1 > 0, s**3 + k1 * s**2 + k2 * s + 1, [k1, k2])
    assert "k1*k2" not in verdict.message and "1/k1" not in verdict.message


def test_a_condition_that_python_has_decided_is_told_so_when_it_is_wrong():
    alpha = sp.Symbol("alpha", real=True)
    chain = Linear([[0, 1], [0, 0]], H=[[alpha, 1]])
    said = checks.observable_parameters(alpha != -1, chain, [alpha])
    assert said.status == "wrong" and "just True" in said.message and "sp.Ne" in said.message
    assert (
        checks.observable_parameters(True, Linear(chain.A, H=[[1, alpha]]), [alpha]).status
        == "right"
    )
    other = checks.observable_parameters(alpha > 0, chain, [alpha])
    assert other.status == "wrong" and "bare" not in other.message


def test_a_wrong_growth_rate_is_not_told_where_its_answers_are():
    x, v = sp.symbols("x v", real=True)
    pendulum, growth = sp.Matrix([v, -v - 4 * sp.sin(x)]), (sp.sqrt(17) - 1) / 2
    assert checks.growth_rate(growth, pendulum, [x, v]).status == "right"
    assert not any(
        angle in checks.growth_rate(2 * growth, pendulum, [x, v]).message
        for angle in ("3.14", "9.42")
    )


@pytest.mark.parametrize(
    "process", [Process(A=1, Q=1, H=1, R=1), Process(A=2, Q=1, H=1, R=1, discrete=True)]
)
def test_a_gain_with_which_errors_grow_is_not_said_to_settle(process):
    assert "an error grows" in checks.steady_gain(sp.Rational(-1, 2), process).message
    assert (
        "settle to a larger covariance"
        in checks.steady_gain(2 if process.A[0] == 1 else sp.Rational(3, 4), process).message
    )


def test_a_negative_root_is_not_told_that_its_square_is_wrong():
    process = Process(A=0, Q=2, H=1, R=1, mean=1, covariance=1)
    message = checks.estimate_standard_deviations(-sp.sqrt(3) / 2, process, [(1, 2)], 1).message
    assert "not negative" in message and "square" not in message


def test_nothing_is_said_of_parameters_that_a_system_has_not():
    (x, v), a = sp.symbols("x v", real=True), sp.Symbol("a", positive=True)
    box = {x: sp.Interval(-4, 4), v: sp.Interval(-4, 4)}
    for field, parameters in (
        (sp.Matrix([v, x - x**3]), []),
        (sp.Matrix([v, a * (x - x**3)]), [a]),
    ):
        right = checks.equilibria([(0, 0), (1, 0), (-1, 0)], field, [x, v], parameters, box)
        short = checks.equilibria([(0, 0)], field, [x, v], parameters, box)
        assert ("parameters" in right.message) == ("for a = " in short.message) == bool(parameters)


def test_a_question_ends_once():
    assert "?." not in positive(None).message


def test_code_in_a_message_is_set_as_code():
    """Code such as `x != 1`, which typesetting would change, is shown as code."""
    x = sp.Symbol("x")
    shown = reporting.as_html(
        {"a": checks.observable_parameters(True, Linear(sp.diag(x, 1), H=[[1, 1]]), [x])}
    )
    assert re.findall("<code style='color: inherit; background: none'>(.*?)</code>", shown) == [
        "x != y",
        "x == y",
        "sp.Ne(x, y)",
        "sp.Eq(x, y)",
    ]
    assert checks.covariance("[[1]]", x, x, [x], sp.eye(1)).message.endswith(
        "leave its quotation marks out"
    )
