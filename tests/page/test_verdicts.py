"""The page's Python judges as a native one does: check cells and trials, right and wrong.

A sample of problems; `make test-page` sets WORKBOOK_ALL_PROBLEMS and takes all.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from engine_page import ROOT, evaluate, literal

from workbook.authoring import master

HERE = Path(__file__).parent
SAMPLE = ["1.15", "2.3", "3.5", "4.2", "5.9", "6.1"]
PROBLEMS = {
    problem.number: problem for problem in map(master.read, master.master_paths(ROOT / "solutions"))
}
NUMBERS = list(PROBLEMS) if os.environ.get("WORKBOOK_ALL_PROBLEMS") else SAMPLE
#: What the page's Python does not have.
ABSENT = ("casadi", "control", "flint", "matplotlib", "z3")


def task(number):
    problem = PROBLEMS[number]
    roles = ("data", "answer", "check")
    cells = [(cell.role, cell.source) for cell in problem.cells if cell.role in roles]
    return cells, [
        (role, trial.name, trial.source)
        for role, trials in problem.trials.items()
        for trial in trials
    ]


def native(number, absent=ABSENT):
    """Return the rows of a problem, judged natively without some libraries."""
    run = subprocess.run(
        [sys.executable, str(HERE / "judging.py"), *absent],
        input=json.dumps(task(number)) + "\n",
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
        env=os.environ | {"PYTHONPATH": str(ROOT), "PYTHONHASHSEED": "0"},
    )
    return {what: (status, message) for what, status, message, _ in json.loads(run.stdout)}


@pytest.fixture(scope="module")
def judged_in_page(addresses, browser):
    """Return the function that judges a problem in the page's Python."""
    browser.open(addresses["http"])
    evaluate(browser, "await workbookEngine.start()")

    def judged(number):
        source = (HERE / "judging.py").read_text(encoding="utf-8")
        code = (
            f"import json\nexec({literal(source)}, globals())\n"
            f"result = judged_problem(*{literal(task(number))})"
        )
        outcome = evaluate(browser, "return workbookEngine.run(args[0], 250)", code)
        assert outcome["error"] is None, outcome["error"]
        return outcome["result"]

    return judged


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("number", NUMBERS)
def test_verdicts_are_those_of_a_native_python(number, judged_in_page, record_property):
    rows = judged_in_page(number)
    record_property("seconds of verdicts", [seconds for *_, seconds in rows])
    here = {what: (status, message) for what, status, message, _ in rows}
    without = native(number)
    assert here.keys() == without.keys()
    assert {w: here[w] for w in here if here[w][0] != without[w][0]} == {}


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("number", NUMBERS)
def test_no_right_answer_is_refused_and_no_wrong_one_accepted(number, judged_in_page):
    rows = {what: status for what, status, *_ in judged_in_page(number)}
    expected = {what: "wrong" if what.startswith("wrong") else "right" for what in rows}
    allowed = ("unchecked", "failed")  # computes with a library that a page does not have
    assert {w: s for w, s in rows.items() if s not in (expected[w], *allowed)} == {}
