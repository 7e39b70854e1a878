"""Statistics: each answer of a homework as an item of a test, and a class over several homeworks.

Nothing handed in and an answer left empty are two things: the difficulty of an item is the share of
right answers among those who handed in a notebook for its problem, with the empty ones. Its
discrimination is the correlation of its points with those of the rest of the homework: near 0 or
below, an item does not tell strong students from weak ones, and deserves a look.
"""

import statistics
from collections import Counter
from html import escape

from workbook.checks.contract.verdict import MISSING, RIGHT
from workbook.grading.course.csv_files import BOM, quoted
from workbook.grading.reports.exporting import decimal, without_formula
from workbook.grading.reports.pages import page, table

ITEM_HEADER = [
    "problem",
    "answer",
    "asked",
    "nothing handed in",
    "empty",
    "right",
    "difficulty",
    "discrimination",
    "named mistakes",
]
#: With fewer students a correlation says nothing.
LEAST_STUDENTS = 5


def items_csv(assignment, scores):
    """Return the table of items of a homework, a row for each answer."""
    rows = [
        _item(problem, answer, scores)
        for problem, answers in assignment.points.items()
        for answer in answers
    ]
    return BOM + quoted([ITEM_HEADER, *(map(without_formula, map(str, row)) for row in rows)])


def course_csv(homeworks):
    """Return a row for each student, and a column for each homework.

    Parameters
    ----------
    homeworks : list of (Assignment, list of StudentScore)
        In the order of time.

    Returns
    -------
    str
        A cell is empty where nothing was handed in, "exempt" where nothing was asked.
    """
    by_student = {}
    for assignment, scores in homeworks:
        for score in scores:
            by_student.setdefault(score.student, {})[assignment.name] = score
    names = [assignment.name for assignment, _ in homeworks]
    rows = [
        [
            student,
            *(_cell(scores.get(name)) for name in names),
            decimal(sum(score.points for score in scores.values())),
            str(sum(score.handed_in for score in scores.values())),
            str(sum(_is_empty(score) for score in scores.values())),
        ]
        for student, scores in sorted(by_student.items())
    ]
    header = ["student", *names, "total", "handed in", "left empty"]
    return BOM + quoted([header, *(map(without_formula, row) for row in rows)])


def course_page(homeworks):
    """Return the page on the class over several homeworks, as HTML; arguments as `course_csv`."""
    rows = [_homework_row(assignment, scores) for assignment, scores in homeworks]
    header = ("homework", "asked", "nothing handed in", "all left empty", "median of the others")
    return page(
        "Course",
        f"{len(homeworks)} homeworks",
        table(header, rows)
        + "<h2>Mistakes that have a name, over time</h2>"
        + _mistakes_over_time(homeworks),
    )


def _item(problem, answer, scores):
    selected = [
        (score, entry)
        for score in scores
        for entry in score.of_problem(problem)
        if entry.answer == answer
    ]
    graded = [
        (score, entry)
        for score, entry in selected
        if problem in score.counted or entry.by_hand is not None
    ]
    right = sum(entry.verdict.status == RIGHT for _, entry in graded)
    mistakes = Counter(
        entry.verdict.mistake.splitlines()[0] for _, entry in graded if entry.verdict.mistake
    )
    return [
        problem,
        answer,
        len(selected),
        len(selected) - len(graded),
        sum(entry.verdict.status == MISSING and entry.by_hand is None for _, entry in graded),
        right,
        decimal(right / len(graded)) if graded else "",
        _discrimination(graded),
        "; ".join(f"{mistake} ({times})" for mistake, times in mistakes.most_common()),
    ]


def _discrimination(graded):
    """Return the correlation of an item's points with those of the rest, "" if there is none."""
    own = [entry.points for _, entry in graded]
    remaining = [score.points - entry.points for score, entry in graded]
    if len(graded) < LEAST_STUDENTS or len(set(own)) == 1 or len(set(remaining)) == 1:
        return ""
    return decimal(statistics.correlation(own, remaining))


def _is_empty(score):
    """Return whether a student handed in notebooks without any answer."""
    return bool(score.counted) and all(
        answer.verdict.status == MISSING and answer.by_hand is None for answer in score.answers
    )


def _cell(score):
    if score is None or score.is_absent:
        return ""
    return decimal(score.points) if score.answers else "exempt"


def _homework_row(assignment, scores):
    selected = [score for score in scores if score.answers]
    empty = [score for score in selected if _is_empty(score)]
    worked = [score.points for score in selected if score.handed_in and score not in empty]
    median = (
        f"{decimal(statistics.median(worked))} of {decimal(assignment.max_points)}"
        if worked
        else ""
    )
    numbers = (len(selected), sum(score.is_absent for score in selected), len(empty), median)
    cells = "".join(f'<td class="number">{number}</td>' for number in numbers)
    return f"<tr><td>{escape(assignment.title)}</td>{cells}</tr>"


def _mistakes_over_time(homeworks):
    """List the named mistakes, with the number of students who made them in each homework."""
    counts = {}
    for k, (_, scores) in enumerate(homeworks):
        for score in scores:
            mistakes = {
                answer.verdict.mistake.splitlines()[0]
                for answer in score.answers
                if answer.verdict.mistake
            }
            for mistake in mistakes:
                counts.setdefault(mistake, [0] * len(homeworks))[k] += 1
    rows = [
        f"<tr><td>{escape(mistake)}</td>"
        + "".join(f'<td class="number">{number or ""}</td>' for number in numbers)
        + "</tr>"
        for mistake, numbers in sorted(counts.items(), key=lambda pair: -sum(pair[1]))
    ]
    names = (escape(assignment.name) for assignment, _ in homeworks)
    return table(("what they were asked", *names), rows)
