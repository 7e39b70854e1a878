"""The part of the summary page on wrong answers that are right for other students' numbers."""

from html import escape

from workbook.grading.pool.copying import is_copying, read_remark
from workbook.grading.reports.pages import person, table


def right_for_others(assignment, scores):
    """Return a table of them: student, problem, answers, and whose numbers they are right for."""
    rows = [
        f"<tr><td>{person(score.student)}</td><td>{escape(problem)}</td>"
        f"<td><code>{escape(', '.join(names))}</code></td><td>{_owners(assignment, problem, row)}</td></tr>"
        for score in scores
        for problem, attempt in score.counted.items()
        for row, names in map(read_remark, filter(is_copying, attempt.remarks))
    ]
    return (
        "<p>These answers are wrong for the student’s own numbers and right for those named here. "
        "An answer that is right for many rows proves little.</p>"
        + table(("student", "problem", "answers", "right for"), rows)
    )


def _owners(assignment, problem, row):
    """Return the row with the students who have it."""
    owners = [name for name, rows in assignment.numbers.items() if rows.get(problem) == row]
    return f"row {row} ({'the site' if row == 0 else ', '.join(map(person, owners))})"
