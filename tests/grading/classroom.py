"""A small class for the tests: assignments, graded attempts, and notebooks to submit."""

import hashlib
import json
import os

from workbook.checks.contract.verdict import Verdict
from workbook.grading.course import assignment as assignments
from workbook.grading.pool.judging import Judgement
from workbook.notebooks import exercises

#: Right answers of problem 1.15, each in one line (the import is in the notebook's own data cell).
RIGHT_1_15 = {
    "a_region": "(k1 > 0) & (k1*k2 > 1)",
    "b_region": "(k2 > 0) & (k1 > k2)",
    "c_region": "(k1 > 0) & (k2 > 0) & (k1*k2 < 1)",
    "d_region": "(k1 > 0) & (k2 > k1)",
    "e_region": "(k1 > 0) & (k2 > k1)",
}
#: Right answers of problem 2.4 for all rows of numbers, and those of the site.
RIGHT_1_18 = {"a_region": "(k1 > 0) & (k1*k2 > 1)", "b_region": "(k1 > k2) & (k2 > 0)"}
RIGHT_2_4 = {
    "a_observable": "sp.Ne(weight*alpha - beta, weight**2)",
    "b_unobservable": "sp.Eq(h**2 - friction*h + stiffness, 0)",
    "b_unobservable_states": "{-r: [[1, r]] for r in b_matrix.eigenvals()}",
}
SITE_2_4 = {
    "a_observable": "sp.Ne(alpha - beta, 1)",
    "b_unobservable": "sp.Or(sp.Eq(h, 1), sp.Eq(h, 2))",
    "b_unobservable_states": "{1: [[1, -1]], 2: [[1, -2]]}",
}


def write_assignment(folder, text, name="hw1"):
    """Write assignments/NAME/assignment.toml below `folder` and return its path."""
    path = folder / "assignments" / name / "assignment.toml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


def an_assignment(folder, text, name="hw1"):
    return assignments.read(write_assignment(folder, text, name))


def graded(
    store,
    student,
    problem,
    statuses,
    submitted=0.0,
    assignment="hw1",
    exercise="first",
    content=None,
    texts=None,
):
    """Record an attempt with its result and return its id; `statuses` maps answers to right, ..."""
    attempt = store.note_attempt(
        student, assignment, problem, content or f"{student}-{problem}-{submitted}", submitted
    )
    verdicts = {name: Verdict(status, f"{name} is {status}") for name, status in statuses.items()}
    hashes = {
        name: hashlib.sha256(text.encode()).hexdigest() for name, text in (texts or {}).items()
    }
    store.record(attempt, exercise, Judgement(verdicts, texts or {}, (), hashes=hashes))
    return attempt


def notebook(problem, answers):
    """Return a student's notebook: the exercise with the stubs of `answers` replaced by code."""
    pristine = json.loads(exercises.find(problem).path.read_text(encoding="utf-8"))
    for cell in pristine["cells"]:
        if cell["metadata"].get("tags") == ["answer"]:
            lines = "".join(cell["source"]).split("\n")
            cell["source"] = "\n".join(_answered(line, answers) for line in lines)
    return pristine


def _answered(line, answers):
    name = line.split(" = ")[0]
    return f"{name} = {answers[name]}" if name in answers else line


def hand_in(folder, student, problem, answers, assignment="hw1", at=None, name=None):
    """Write a notebook to submitted/<student>/<assignment>/ and return its path."""
    chapter, number = problem.split(".")
    path = (
        folder / "submitted" / student / assignment / (name or f"ch{chapter}-p{number:0>2}.ipynb")
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(notebook(problem, answers)), encoding="utf-8")
    if at is not None:
        os.utime(path, (at, at))
    return path
