"""Copied answers: a wrong answer that is right for other numbers of the same problem.

Where each student has numbers of their own, an answer copied from the site or from a classmate is
wrong, and right for row 0 or for the classmate's row. So a notebook with wrong answers is judged
once more with those rows. The remark is for the lecturer, who decides what it means: some answers,
such as yes, are right for many rows.
"""

import time
from dataclasses import replace

from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.verdict import RIGHT, WRONG
from workbook.notebooks import exercises

#: How a remark begins; those of a notebook, of limits and of the grader begin otherwise.
PREFIX = "right for row "
#: Seconds for one notebook, after which no further row is tried.
SECONDS = 60


def remarks(judgement, other_variants, outcome, judge):
    """Return a remark for each row for which a wrong answer is right.

    Parameters
    ----------
    judgement : Judgement
        On the notebook, with the student's own numbers.
    other_variants : sequence of str
        Names of the same problem with other numbers; the first is tried first.
    outcome : Outcome
        What the notebook handed over.
    judge : Judge
        The judge.

    Returns
    -------
    list of str
        Such as "right for row 17: a_gain, b_region"; row 0 has the site's numbers.
    """
    wrong = {name for name, verdict in judgement.verdicts.items() if verdict.status == WRONG}
    remarks, end = [], time.monotonic() + SECONDS
    for variant in other_variants if wrong else ():
        if time.monotonic() > end:
            break
        verdicts = judge.judge(_with_checks_of(exercises.find(variant), wrong), outcome).verdicts
        right = [n for n, verdict in verdicts.items() if n in wrong and verdict.status == RIGHT]
        if right:
            remarks.append(f"{PREFIX}{variant.partition('~')[2] or 0}: {', '.join(right)}")
    return remarks


def is_copying(remark):
    """Return whether a remark is one of these."""
    return remark.startswith(PREFIX)


def read_remark(remark):
    """Return (row, names of answers) of a remark.

    >>> read_remark("right for row 17: a_gain, b_region")
    (17, ['a_gain', 'b_region'])
    """
    row, _, names = remark.removeprefix(PREFIX).partition(": ")
    return int(row), names.split(", ")


def _with_checks_of(exercise, names):
    """Return an exercise with those check cells only that judge one of the answers."""
    cells = [
        (role, source)
        for role, source in exercise.cells
        if role != "check" or names & set(reported_names(source))
    ]
    judged = {name for role, source in cells if role == "check" for name in reported_names(source)}
    answers = {name: kind for name, kind in exercise.about["answers"].items() if name in judged}
    return replace(exercise, cells=tuple(cells), about=exercise.about | {"answers": answers})
