"""The problem that a notebook is for, and the problems of a homework without a file."""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, hand_in

from workbook.grading.course import course, matching, submissions
from workbook.grading.gradescope import autograder
from workbook.grading.sandbox import submitted_file
from workbook.numbering import number_of_name


def without_metadata(path):
    nb = json.loads(path.read_text())
    path.write_text(json.dumps(nb | {"metadata": {}}))
    return path


def found(folder):
    return list(submissions.find(folder / "submitted"))


@pytest.mark.parametrize(
    "problem, name, named, meant",
    [
        ("1.15", "ch1-p15.ipynb", True, "1.15"),
        ("1.17", "ch1-p17.ipynb", True, None),
        ("1.17", "mine.ipynb", True, None),
        ("1.17", "ch1-p17.ipynb", False, None),
        ("1.15", "mine.ipynb", False, "1.15"),
        ("1.17", "ch99-p98.ipynb", False, "1.15"),
    ],
)
def test_a_homework_of_one_problem(tmp_path, problem, name, named, meant):
    """A notebook that names another problem of the workbook is not an attempt at this one."""
    homework = an_assignment(tmp_path, 'problems = ["1.15"]')
    path = hand_in(tmp_path, "ann", problem, {}, name=name)
    if not named:
        without_metadata(path)
    (submission,) = found(tmp_path)
    answer = matching.problem_for(submission, homework)
    assert (
        answer == meant
        if meant
        else answer
        == submissions.LeftAside(
            submission.path,
            "it is for problem 1.17, which this homework does not ask for",
            "ann",
            "hw1",
            "1.17",
        )
    )


@pytest.mark.parametrize(
    "name, problem",
    [
        ("Petrov 1.15.ipynb", "1.15"),
        ("Петров_1_15 (2).ipynb", "1.15"),
        ("hw1 Petrov 1-p15 final.ipynb", "1.15"),
        ("Petrov 1.15 and 1.17.ipynb", None),
        ("Petrov 1.15.2026.ipynb", None),
        ("Petrov 11.15.ipynb", None),
        ("Petrov 2026-1.15.ipynb", None),
        ("Petrov 1.18.ipynb", None),
        ("Petrov.ipynb", None),
    ],
)
def test_a_number_anywhere_in_a_name(tmp_path, name, problem):
    """Without metadata a name decides if it has the number of one problem of the homework."""
    homework = an_assignment(tmp_path, 'problems = ["1.15", "1.17"]')
    without_metadata(hand_in(tmp_path, "ann", "1.15", {}, name=name))
    (submission,) = found(tmp_path)
    answer = matching.problem_for(submission, homework)
    assert answer == problem if problem else "which problem of the homework" in answer.reason
    copies, _ = course._by_attempt([submission], {"hw1": homework}, {}, {})
    assert course._assumed(copies) == ({problem: [submission.path]} if problem else {})


def test_a_homework_of_one_problem_on_gradescope(tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.15"]')
    stray = hand_in(tmp_path, "ann", "1.17", {})
    (tmp_path / "scratch").mkdir()
    graded, aside, remarks = autograder._submitted(stray.parent, tmp_path / "scratch", homework)
    assert graded == [] and len(aside) == 1
    assert (
        remarks[0]
        == "left aside: ch1-p17.ipynb: it is for problem 1.17, which this homework does not ask for"
    )


def test_a_file_that_cannot_be_read_on_gradescope_is_reported(tmp_path, monkeypatch):
    homework = an_assignment(tmp_path, 'problems = ["1.15"]')
    path = hand_in(tmp_path, "ann", "1.15", {})
    (tmp_path / "scratch").mkdir()
    monkeypatch.setattr(
        submitted_file,
        "content",
        lambda path: (_ for _ in ()).throw(OSError(5, "Input/output error")),
    )
    graded, _, remarks = autograder._submitted(path.parent, tmp_path / "scratch", homework)
    assert (
        graded == []
        and "left aside: ch1-p15.ipynb: this file cannot be read (Input/output error)" in remarks
    )


@pytest.mark.parametrize(
    "name, number",
    [
        ("ch1-p15", "1.15"),
        ("Copy of ch1-p15", "1.15"),
        ("Able_Ann_12345_ch1-p15", "1.15"),
        ("ch1-p15 (1)", "1.15"),
        ("123_45_ch1-p15", "1.15"),
        ("ann-ch1-p15", "1.15"),
        ("ch1-p15-Copy1", "1.15"),
        ("Ch1-P04", "1.4"),
        ("ch2_5", "2.5"),
        ("ch1p15", "1.15"),
        ("1.15", "1.15"),
        ("1_15-final", "1.15"),
        ("ch1-p15 and ch1-p17", None),
        ("notes", None),
        ("Able_1_15", None),
        ("branch1-p15", None),
        ("ch1-p1500", None),
    ],
)
def test_names(name, number):
    assert number_of_name(name) == number


def hands_in(folder, **problems):
    for student, numbers in problems.items():
        for number in numbers:
            hand_in(folder, student, number, {})


@pytest.mark.parametrize(
    "problems, asked, alone",
    [
        ({"ann": ["1.15"], "bob": ["1.15"], "cid": ["1.15", "1.17"]}, ("1.15",), ["1.17"]),
        ({"ann": ["1.15", "1.17"], "bob": ["1.15", "1.17"], "cid": ["1.15"]}, ("1.15", "1.17"), []),
        ({"ann": ["1.15"], "bob": ["1.15", "1.17"]}, ("1.15", "1.17"), []),
        ({"ann": ["1.4"], "bob": ["1.15"], "cid": ["1.17"]}, ("1.4", "1.15", "1.17"), []),
    ],
)
def test_a_problem_of_one_student_in_a_homework_without_a_file(tmp_path, problems, asked, alone):
    hands_in(tmp_path, **problems)
    homework, reasons = matching.infer_homework("hw1", found(tmp_path))
    assert homework.problems == asked and list(reasons) == alone
    for why in reasons.values():
        assert why == (
            "only cid handed in problem 1.17, while others share 1.15: it is not taken for part "
            "of hw1; an assignment.toml would say what is"
        )
