"""What the notebooks of one student may use, and in which order those of a class are graded."""

import json
import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, an_assignment, hand_in, notebook, write_assignment

from workbook.grading.course import course, submissions
from workbook.grading.course.assignment import InputError
from workbook.grading.course.options import GradingOptions
from workbook.grading.course.policy import Budget
from workbook.grading.course.store import Store
from workbook.grading.course.submissions import LeftAside
from workbook.grading.pool.turns import Turns
from workbook.grading.reports.scores import scores
from workbook.grading.sandbox.limits import Limits

HOMEWORK = 'problems = ["1.15"]\n'


def _order(tasks, seconds, budgets=None, slots=1, used=None):
    """Return the order in which tasks begin in so many slots, each slot's oldest ending first."""
    turns = Turns(tasks, used or {}, budgets or dict.fromkeys(tasks, 10**9))
    order, running = [], []
    while True:
        while len(running) < slots and (task := next(turns, None)) is not None:
            order.append(task)
            running.append(task)
        if not running:
            return order, turns.left_over
        ended = running.pop(0)
        turns.done(ended[0], seconds[ended[0]])


def test_students_take_turns():
    tasks = {name: [f"{name}{k}" for k in range(count)] for name, count in [("a", 2), ("b", 3)]}
    assert _order(tasks, {"a": 1, "b": 1})[0] == ["a0", "b0", "a1", "b1", "b2"]


@pytest.mark.parametrize("slots", [1, 2, 4])
def test_a_hundred_endless_notebooks_of_one_do_not_hold_the_class(slots):
    tasks = {"m": [f"m{k}" for k in range(100)]}
    tasks |= {name: [f"{name}{k}" for k in range(5)] for name in "abcdefgh"}
    order, left = _order(tasks, dict.fromkeys("abcdefgh", 1) | {"m": 120}, slots=slots)
    assert len(order) == 140 and not left
    assert sum(task[0] == "m" for task in order[:41]) == 1, "all others come before its second"


def test_a_budget_ends_a_students_turns():
    tasks = {"m": [f"m{k}" for k in range(9)], "a": ["a0", "a1"]}
    order, left = _order(tasks, {"m": 120, "a": 1}, {"m": 300, "a": 300})
    assert [task for task in order if task[0] == "m"] == ["m0", "m1", "m2"]
    assert left == [f"m{k}" for k in range(3, 9)]
    _, left = _order(tasks, {"m": 1, "a": 1}, {"m": 300, "a": 300}, used={"m": 300})
    assert left == tasks["m"], "used up by an earlier run"


@pytest.mark.parametrize(
    "budget, kept, reason",
    [
        (Budget(notebooks=2), ["b", "a"], "more than 2 notebooks here ([budget] in assignment"),
        (Budget(megabytes=2.5), ["b", "a"], "notebooks here have more than 2.5 MB together"),
        (Budget(notebooks=0), [], "more than 0 notebooks"),
        (Budget(), ["b", "a", "c"], None),
    ],
)
def test_what_exceeds_the_number_and_the_bytes_is_left_aside(tmp_path, budget, kept, reason):
    """The earliest come first, whatever their names; and another student has a budget of their own."""
    for at, name in enumerate(["b", "a", "c"]):
        path = hand_in(tmp_path, "ann", "1.15", {}, at=at, name=f"{name}-ch1-p15.ipynb")
        path.write_text(json.dumps(notebook("1.15", {}) | {"picture": name * 2**20}))
        os.utime(path, (at, at))
    hand_in(tmp_path, "bob", "1.15", {})
    entries = list(submissions.find(tmp_path / "submitted", lambda name: budget))
    read = sorted(
        (entry.submitted, Path(entry.path).name[0])
        for entry in entries
        if entry.student == "ann" and not isinstance(entry, LeftAside)
    )
    assert [name for _, name in read] == kept
    asides = [entry for entry in entries if isinstance(entry, LeftAside) and entry.student == "ann"]
    assert len(asides) == 3 - len(kept) and all(
        reason in entry.reason and entry.assignment == "hw1" for entry in asides
    )


def test_computing_time_of_a_student(tmp_path):
    """Endless notebooks end with the budget; others are graded; a larger budget goes on from there."""
    text = f"{HOMEWORK}[budget]\ncpu_minutes = 0.04\n"
    path = write_assignment(tmp_path, text)
    for k in range(6):
        # A cell that takes half of the time that is left is stopped, and the next one begins.
        answers = dict.fromkeys(RIGHT_1_15, f"exec('while True: pass')  # {k}")
        hand_in(tmp_path, "mallory", "1.15", answers, name=f"{k}-ch1-p15.ipynb")
    hand_in(tmp_path, "ann", "1.15", RIGHT_1_15)
    limits = Limits(cpu_seconds=1, wall_seconds=60)

    def grade():
        return course.grade(
            GradingOptions(
                tmp_path / "submitted",
                tmp_path / "graded",
                tmp_path / "assignments",
                1,
                limits=limits,
            )
        )

    homeworks, plan, failures = grade()
    assert failures == 0 and {entry.student for entry in plan.aside} == {"mallory"}
    assert len(plan.pending) + len(plan.aside) == 7 and 2 <= len(plan.aside) <= 4
    assert "have used up 0.04 minutes of computing ([budget] in" in plan.aside[0].reason
    with Store(tmp_path / "graded" / "grades.sqlite") as store:
        ann, mallory = scores(store, homeworks["hw1"], (), plan.aside)
        attempts = {a.id: a for a in store.attempts("hw1")}
        used = sum(store.seconds_used(i) for i, a in attempts.items() if a.student == "mallory")
    assert ann.points == 5 and not ann.needs_review
    assert mallory.points == 0 and mallory.needs_review and 2.4 <= used < 6
    _, again, _ = grade()
    assert again.pending == () and again.aside == plan.aside, "nothing is begun once more"
    path.write_text(f"{HOMEWORK}[budget]\ncpu_minutes = 10\n")
    _, raised, _ = grade()
    assert len(raised.pending) == len(plan.aside) and raised.aside == ()


@pytest.mark.parametrize(
    "text, message",
    [
        ("budget = 3", "budget is a table"),
        ("[budget]\nmemory = 3", "budget is a table"),
        ("[budget]\nnotebooks = 1.5", "budget.notebooks is a whole number"),
        ("[budget]\nmegabytes = -1", "budget.megabytes is a number from 0"),
        ("[budget]\ncpu_minutes = true", "budget.cpu_minutes is a number from 0"),
        ('[budget]\ncpu_minutes = "3"', "budget.cpu_minutes is a number from 0"),
    ],
)
def test_errors_in_a_budget(tmp_path, text, message):
    with pytest.raises(InputError, match=message):
        an_assignment(tmp_path, HOMEWORK + text)
