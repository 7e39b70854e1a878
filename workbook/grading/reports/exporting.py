"""Exporting: grades as a plain table, for Moodle, for nbgrader and for Gradescope.

Canvas is in `canvas`. Every table is quoted CSV in UTF-8. Tables for people (grades.csv,
changes.csv) guard against names that a spreadsheet would run as a formula; in tables that another
system reads, an identifier is unchanged. A grade that still needs a lecturer's look is not exported
to Moodle, Canvas or nbgrader: it is neither right nor wrong yet.
"""

import json
import re
import time
from datetime import UTC, datetime

from workbook.checks.contract.verdict import RIGHT, UNCHECKED
from workbook.grading.course.csv_files import BOM, quoted
from workbook.grading.course.ledger import KNOWN

# For people


def grades_csv(assignment, scores):
    """Return a row for each student: points by problem, total, what is late, what is to be done.

    A student who handed in nothing has no points as one who left all empty, but is another.
    """
    header = [
        "student",
        *assignment.points,
        "total",
        "before lateness",
        "max",
        "handed in",
        "late",
        "grace days used",
        "time unknown",
        "needs review",
    ]
    rows = [
        [
            score.student,
            *(
                decimal(sum(answer.points for answer in score.of_problem(problem)))
                if problem not in assignment.exempt_of(score.student)
                else "exempt"
                for problem in assignment.points
            ),
            decimal(score.points),
            decimal(score.points_before_lateness),
            decimal(score.max_points),
            "yes" if score.handed_in else "no",
            " ".join(score.late),
            str(score.grace_days_used or ""),
            " ".join(score.untimed),
            "yes" if score.needs_review else "no",
        ]
        for score in scores
    ]
    return BOM + quoted([header, *(map(without_formula, row) for row in rows)])


def changes_csv(changes):
    """Return a row for each `Change` of a verdict or of points, oldest first."""
    header = [
        "when",
        "student",
        "problem",
        "answer",
        "old verdict",
        "new verdict",
        "old points",
        "new points",
        "reason",
    ]
    rows = [
        [
            change.when,
            change.student,
            change.problem,
            change.answer,
            change.old_verdict,
            change.new_verdict,
            decimal(change.old_points),
            decimal(change.new_points),
            change.reason,
        ]
        for change in changes
    ]
    return BOM + quoted([header, *(map(without_formula, row) for row in rows)])


def without_formula(cell):
    """Return a cell that spreadsheets do not run as a formula, as they would =cmd().

    A signed number stays a number.
    """
    return f"'{cell}" if re.match(r"[=@\t\r\n]|[+-](?!\d*\Z)", cell) else cell


# For other systems


def moodle_csv(assignment, scores, now=None):
    """Return a table for Moodle's import, with a column of grades and one of feedback.

    Importing feedback without the grade would delete grades, so a student without one has no row.
    Who handed in nothing by the due date has no points; `now` is the time in seconds since 1970.
    """
    now = time.time() if now is None else now
    final_scores = [
        score
        for score in scores
        if not score.needs_review and (score.handed_in or _has_missed(score, assignment, now))
    ]
    identity = (
        "Email address"
        if final_scores and all("@" in score.student for score in final_scores)
        else "ID number"
    )
    rows = [[score.student, decimal(score.points), _feedback(score)] for score in final_scores]
    return quoted([[identity, assignment.title, f"{assignment.title} (feedback)"], *rows])


def _has_missed(score, assignment, now):
    """Return whether a student has handed in nothing, and the due date is over if there is one."""
    due = assignment.policy.due_of(score.student)
    return score.is_absent and (due is None or due.timestamp() < now)


def nbgrader_csv(assignment, scores):
    """Return the columns of `nbgrader export`, quoted; times in UTC without a zone, as there."""
    header = [
        "assignment",
        "duedate",
        "timestamp",
        "student_id",
        "last_name",
        "first_name",
        "email",
        "raw_score",
        "late_submission_penalty",
        "score",
        "max_score",
    ]
    rows = []
    for score in scores:
        times = [attempt.submitted for attempt in score.counted.values() if attempt.timing == KNOWN]
        penalty = sum(answer.late_penalty for answer in score.answers)
        raw, points = (
            ("", "")
            if score.needs_review
            else (decimal(score.points_before_lateness), decimal(score.points))
        )
        due = assignment.policy.due_of(score.student)
        rows.append(
            [
                assignment.name,
                _utc(due.timestamp()) if due else "",
                _utc(max(times)) if times else "",
                score.student,
                "",
                "",
                "",
                raw,
                decimal(penalty),
                points,
                decimal(score.max_points),
            ]
        )
    return quoted([header, *rows])


def gradescope_json(score, homework, hint_counts, remarks, points, seconds):
    """Return results.json for one submission: a test for each answer, never the solution.

    Parameters
    ----------
    score : StudentScore
        Of the submission.
    homework : Assignment
        Its kept answers are shown to the student only when the grades are published.
    hint_counts : dict
        How many hints the notebook has, by (problem, answer).
    remarks : list of str
        On the submission.
    points : float
        Those that count, which may be an earlier submission's.
    seconds : float
        How long grading took.

    Returns
    -------
    str
        JSON.
    """
    tests = [
        _gradescope_test(answer, hint_counts.get((answer.problem, answer.answer), 0))
        | {"visibility": "after_published" if answer.answer in kept else "visible"}
        for answer in score.answers
        for kept in [homework.kept_of(answer.problem)]
    ]
    return (
        json.dumps(
            {
                "score": round(points, 4),
                "execution_time": round(seconds),
                "output": "\n".join(remarks),
                "output_format": "text",
                "visibility": "visible",
                "stdout_visibility": "hidden",
                "tests": tests,
            },
            ensure_ascii=False,
            indent=1,
        )
        + "\n"
    )


def _gradescope_test(answer, hint_count):
    status, message, mistake = answer.verdict.status, answer.verdict.message, answer.verdict.mistake
    # Gradescope has only the states passed and failed, so the text says it.
    waiting = (
        ["It is not judged wrong; it has no points until your lecturer has looked at it."]
        if status == UNCHECKED
        else []
    )
    # Nothing can be folded here, so the hints are only counted.
    hints = (
        [f"The notebook has {hint_count} hint{'s' * (hint_count > 1)} to this answer."]
        if hint_count
        else []
    )
    return {
        "name": f"{answer.problem} {answer.answer}",
        "score": round(answer.points, 4),
        "max_score": round(answer.max_points, 4),
        "status": "passed" if status == RIGHT else "failed",
        "output": "\n".join([f"{status}: {message}", *mistake.splitlines(), *waiting, *hints]),
        "output_format": "text",
    }


def _feedback(score):
    if score.is_absent:
        return "nothing was handed in"
    return "; ".join(
        f"{answer.problem} {answer.answer}: "
        + (
            answer.verdict.status + _timing(answer)
            if answer.manual is None
            else f"{decimal(answer.points)} by hand"
            + (f" ({answer.manual})" if answer.manual else "")
        )
        for answer in score.answers
    )


def _timing(answer):
    """Say what the time of an attempt did to the points of a right answer."""
    if answer.verdict.status != RIGHT or answer.share == 1:
        return ""
    return f", {'late' if answer.share < 1 else 'early'}: {answer.share:.0%} of the points"


def _utc(seconds):
    return f"{datetime.fromtimestamp(seconds, UTC):%Y-%m-%d %H:%M:%S}"


def decimal(value):
    """Return a number with two decimals."""
    return f"{value:.2f}"
