"""`workbook.page.run_cell`: what a page runs says what a notebook would say."""

import json
import re
import sys

import pytest

from workbook import page
from workbook.checks.tools.conditions import decomposition
from workbook.notebooks import exercises

EXERCISE = exercises.find("1.15")
(DATA,) = (source for _, source in EXERCISE.code("data"))
CHECK_A, CHECK_B = (source for _, source in EXERCISE.code("check")[:2])
RIGHT_A = "a_region = sp.And(k1 > 0, k1 * k2 > 1)"


def run(*boxes, check=CHECK_A, **options):
    result = page.run_cell([DATA, *boxes], check, **options)
    assert json.loads(json.dumps(result)) == result
    return result


def test_a_right_and_a_wrong_answer_are_judged_as_in_a_notebook():
    assert run(RIGHT_A)["verdicts"] == {"a_region": "right"}
    wrong = run("a_region = sp.And(k1 > 0, k2 > 0)")
    assert wrong["verdicts"] == {"a_region": "wrong"}
    assert "Which minor was not looked at?" in wrong["text"]
    assert 'class="workbook-verdict wrong"' in wrong["html"]


def test_a_check_without_a_number_names_the_mistake_if_the_page_gives_the_number():
    check = "checks.report(a_region=checks.stability_region(a_region, a_poly, [k1, k2]))"
    box = "a_region = sp.And(k1 > 0, k2 > 0)"
    assert "Which minor" not in run(box, check=check)["text"]
    assert "Which minor" in run(box, check=check, problem="1.15")["text"]


def test_no_run_sees_the_names_of_another():
    assert run(RIGHT_A + "; k1 = 5")["verdicts"] == {"a_region": "right"}
    assert run("a_region = k1 > 0; k1 = 5")["text"].count("Your code overwrote k1") == 1
    assert run("a_region = ...")["verdicts"] == {"a_region": "missing"}
    assert run()["verdicts"] == {"a_region": "missing"}


def test_a_failing_box_hides_no_verdict_on_another():
    result = run("a_region = (", "b_region = sp.And(k2 > 0, k1 > k2)", check=CHECK_B)
    assert result["verdicts"] == {"b_region": "right"}
    assert [error["cell"] for error in result["errors"]] == [1]


@pytest.mark.parametrize(
    "box, line, text, hint",
    [
        ("a_region = (", 1, "SyntaxError: '(' was never closed", ""),
        ("x = 1\n\na_region = k1 > 0 and k2 > 0", 3, "TypeError", "Join conditions of SymPy"),
        ("a_region = 4k1 > 0", 1, "SyntaxError: invalid decimal literal", "A product needs"),
        ("a_region = exp(k1) > 0", 1, "NameError", "Write sp.exp"),
        ("def f():\n    return 1 / 0\nf()", 2, "ZeroDivisionError: division by zero", ""),
        ("import pandas_of_another", 1, "ModuleNotFoundError", "This library is not here"),
        ("import sys\nsys.exit()", 2, "SystemExit", ""),
        ("raise ValueError\0", 1, "", ""),
    ],
)
def test_an_error_has_its_line_and_a_hint(box, line, text, hint):
    (error,) = run(box)["errors"]
    assert error["cell"] == 1 and error["text"].startswith(text) and error["hint"].startswith(hint)
    assert error["line"] in (line, None) if "\0" in box else error["line"] == line


def test_a_stopped_box_is_named_in_its_verdict():
    assert "its cell stopped with NameError" in run("a_region = K1 > 0")["text"]


def test_output_and_the_value_of_the_last_line_are_printed():
    result = run("print('above')", RIGHT_A + "\nprint(a_poly)\na_region")
    assert result["printed"] == [
        "",
        "above\n",
        "k1*s**2 + k2*s + s**3 + 1\n(k1 > 0) & (k1*k2 > 1)\n",
    ]


def test_endless_output_is_cut():
    printed = run("for k in range(10**5): print(k)")["printed"][-1]
    assert len(printed) < page.MOST_PRINTED + 100 and printed.endswith("(more is not shown)")


def test_an_agreement_that_was_only_sampled_is_not_called_more(monkeypatch):
    """Without z3 a condition is decided cell by cell, or, where that takes too long, tried at points."""
    assert run(RIGHT_A)["text"].endswith("proved for all values")
    monkeypatch.setitem(sys.modules, "z3", None)
    assert run(RIGHT_A)["text"].endswith("proved for all values")
    monkeypatch.setattr(decomposition, "MOST_WORK", 0)
    assert re.search(r"agrees at \d+ points; the notebook can decide more$", run(RIGHT_A)["text"])
