"""The page's Python judges as a native one does: check cells and trials, right and wrong.

A sample of problems; `make test-page` sets WORKBOOK_ALL_PROBLEMS and takes all.
"""

import functools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from engine_page import ROOT, literal

from workbook.authoring import read_master
from workbook.notebooks import exercises
from workbook.numbering import read_number

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]
HERE = Path(__file__).parent
SAMPLE = ["1.15", "2.3", "3.5", "4.2", "5.9", "6.1"]
NUMBERS = (
    [exercise.number for exercise in exercises.read_all()]
    if os.environ.get("WORKBOOK_ALL_PROBLEMS")
    else SAMPLE
)
#: What the page's Python does not have.
ABSENT = ("casadi", "control", "flint", "matplotlib", "z3")


@functools.cache
def task(number):
    """Return the arguments of `judging.judged_problem`."""
    problem = read_master(ROOT / "solutions" / read_number(number).file(".md"))
    roles = ("data", "answer", "check")
    cells = [(cell.role, cell.source) for cell in problem.cells if cell.role in roles]
    trials = [
        (role, trial.name, trial.source)
        for role, trials in problem.trials.items()
        for trial in trials
    ]
    needs_library = number.startswith("5.") or any("import control" in code for _, code in cells)
    answers = natively("encoded_answers", cells) if needs_library else {}
    return cells, trials, answers


def natively(function, *arguments, absent=()):
    run = subprocess.run(
        [sys.executable, str(HERE / "judging.py"), function, *absent],
        input=json.dumps(arguments),
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
        env=os.environ | {"PYTHONPATH": str(ROOT), "PYTHONHASHSEED": "0"},
    )
    return json.loads(run.stdout)


def judge_in(browser, address):
    """Return the function that judges a problem by the page's Python in a browser."""
    browser.open(address)
    browser.evaluate("await workbookEngine.start()")
    source = (HERE / "judging.py").read_text(encoding="utf-8")

    @functools.cache
    def judged(number):
        code = (
            f"import json\nnames = {{'__name__': 'judging'}}\nexec({literal(source)}, names)\n"
            f"result = names['judged_problem'](*{literal(task(number))})"
        )
        outcome = browser.evaluate("return workbookEngine.run(args[0], 250)", code)
        assert outcome["error"] is None, outcome["error"]
        return {what: (status, message) for what, status, message, _ in outcome["result"]}

    return judged


@pytest.fixture(scope="module")
def judged_in_page(addresses, browser):
    return judge_in(browser, addresses["http"])


@pytest.fixture(scope="module")
def judged_in_firefox(addresses, firefox):
    return judge_in(firefox, addresses["http"])


@pytest.mark.parametrize("number", NUMBERS)
def test_no_right_answer_is_refused_and_no_wrong_one_accepted(number, judged_in_page):
    rows = judged_in_page(number)
    assert {what[5:] for what in rows if what.startswith("cell ")} == set(
        exercises.find(number).about["answers"]
    )
    expected = {what: "wrong" if what.startswith("wrong") else "right" for what in rows}
    bad = {
        what: (status, message)
        for what, (status, message) in rows.items()
        if status != expected[what] and not needs_notebook(status, message)
    }
    assert not bad


def needs_notebook(status, message):
    """Return whether a verdict or an error says that a library is not in the page."""
    return (status == "unchecked" and "runs in the notebook" in message) or (
        status == "failed" and "No module named" in message
    )


@functools.cache
def judged_natively(number):
    """Return what the function of `judge_in` does, by this Python without the libraries that a page lacks."""
    rows = natively("judged_problem", *task(number), absent=ABSENT)
    return {what: (status, message) for what, status, message, _ in rows}


@pytest.mark.parametrize("number", NUMBERS)
def test_verdicts_are_those_of_a_native_python(number, judged_in_page):
    """Python, NumPy and SciPy are newer in the page, and compiled for another machine."""
    native, page = judged_natively(number), judged_in_page(number)
    assert {what: page[what][0] for what in native} == {what: native[what][0] for what in native}


@pytest.mark.parametrize("number", SAMPLE)
def test_texts_are_those_of_a_native_python(number, judged_in_page):
    native, page = judged_natively(number), judged_in_page(number)
    assert {what: page[what] for what in native} == native


@pytest.mark.parametrize("number", SAMPLE)
def test_firefox_gives_the_verdicts_and_texts_of_chromium(
    number, judged_in_page, judged_in_firefox
):
    assert judged_in_firefox(number) == judged_in_page(number)
