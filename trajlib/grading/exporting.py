"""Grades as other systems read them: a plain table, Moodle, Canvas, nbgrader, and Gradescope's results.json.

Every table is quoted CSV in UTF-8. Tables for people's eyes (grades.csv, changes.csv) guard against names that a
spreadsheet would run as a formula; in tables that another system reads back, an identifier goes through as it is.
A grade that still needs a lecturer's look is not handed to Moodle, Canvas or nbgrader: it is neither right nor wrong yet.
"""

import csv
import io
import json
import re
from datetime import datetime, timezone
from pathlib import Path

from trajlib.checks.verdict import RIGHT, UNCHECKED
from trajlib.grading.assignment import BadInput

# For people

#: Without it spreadsheets take UTF-8 for an older encoding, and accents go wrong.
BOM = "\ufeff"


def grades_csv(assignment, scores):
    """One row a student: points by problem, total, late problems, whether somebody has to look at it."""
    header = ["student", *assignment.problems, "total", "max", "late", "needs review"]
    rows = [[score.student, *(_points(sum(answer.points for answer in score.of_problem(problem))) for problem in assignment.problems),
             _points(score.points), _points(score.max_points), " ".join(score.late), "yes" if score.needs_review else "no"]
            for score in scores]
    return BOM + _csv([header, *(map(_harmless, row) for row in rows)])


def changes_csv(changes):
    """One row for each answer whose verdict or points changed since they were first written, oldest first."""
    header = ["when", "student", "problem", "answer", "old verdict", "new verdict", "old points", "new points", "why"]
    rows = [[change.when, change.student, change.problem, change.answer, change.old_verdict, change.new_verdict,
             _points(change.old_points), _points(change.new_points), change.why] for change in changes]
    return BOM + _csv([header, *(map(_harmless, row) for row in rows)])


def _harmless(cell):
    """A name such as =cmd() is data, but spreadsheets run what begins like a formula. A signed number stays a number."""
    return f"'{cell}" if re.match(r"[=@\t\r\n]|[+-](?!\d*\Z)", cell) else cell


# For other systems


def moodle_csv(assignment, scores):
    """For Moodle's import, which maps columns by hand: the grade and its feedback always together.

    Importing feedback without the grade would wipe grades, so who has no grade yet has no row.
    """
    ready = [score for score in scores if score.handed_in and not score.needs_review]
    identity = "Email address" if ready and all("@" in score.student for score in ready) else "ID number"
    rows = [[score.student, _points(score.points), _feedback(score)] for score in ready]
    return _csv([[identity, assignment.title, f"{assignment.title} (feedback)"], *rows])


def canvas_csv(assignment, scores, roster):
    """(text, unmatched): the gradebook exported from Canvas with one column filled, and students it does not know.

    Students are matched by whichever of "SIS User ID", "SIS Login ID" and "ID" fits most of them. A column that Canvas
    already has for the assignment, "Title (1234)", is filled; else Canvas makes a new one. Who has no grade yet keeps what
    stands there. `roster` is a `Roster`.
    """
    known = {score.student: score for score in scores}
    key = max(("SIS User ID", "SIS Login ID", "ID"), key=lambda name: sum(row in known for row in roster.column(name)))
    column = next((name for name in roster.header if re.fullmatch(rf"{re.escape(assignment.title)} \(\d+\)", name)), assignment.title)
    possible = roster.possible(column) or _points(assignment.max_points)
    rows = [["    Points Possible", *[""] * (roster.width - 1), possible]]
    for identity, row, present in zip(roster.column(key), roster.rows, roster.column(column)):
        score = known.get(identity)
        rows.append([*row[:roster.width], _points(score.points) if score and score.handed_in and not score.needs_review else present])
    text = _csv([[*roster.header[:roster.width], column], *rows], roster.delimiter)
    return text, [score.student for score in scores if score.student not in set(roster.column(key))]


def nbgrader_csv(assignment, scores):
    """The columns of `nbgrader export`, quoted (its own export is not); times in UTC without a zone, as there."""
    header = ["assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email", "raw_score",
              "late_submission_penalty", "score", "max_score"]
    rows = []
    for score in scores:
        times = [attempt.submitted for attempt in score.counted.values()]
        points = "" if score.needs_review else _points(score.points)
        rows.append([assignment.name, _utc(assignment.due.timestamp()) if assignment.due else "", _utc(max(times)) if times else "",
                     score.student, "", "", "", points, "0.00", points, _points(score.max_points)])
    return _csv([header, *rows])


def gradescope_json(score, hints, remarks, points, seconds):
    """results.json for one submission: a test an answer, with its message and the next hint, never the solution.

    `hints` maps (problem, answer) to the hints that are open to the student; `points` are those that count, which may
    be an earlier submission's; `seconds` is how long grading took.
    """
    tests = [_gradescope_test(answer, hints.get((answer.problem, answer.answer), ())) for answer in score.answers]
    return json.dumps({"score": round(points, 4), "execution_time": round(seconds), "output": "\n".join(remarks), "output_format": "text",
                       "visibility": "visible", "stdout_visibility": "hidden", "tests": tests}, ensure_ascii=False, indent=1) + "\n"


def _gradescope_test(answer, hints):
    status, message = answer.verdict.status, answer.verdict.message
    # Gradescope knows no third state beside passed and failed: the text has to say it.
    waiting = ["It is not judged wrong; it has no points until your lecturer has looked at it."] if status == UNCHECKED else []
    return {"name": f"{answer.problem} {answer.answer}", "score": round(answer.points, 4), "max_score": round(answer.max_points, 4),
            "status": "passed" if status == RIGHT else "failed",
            "output": "\n".join([f"{status}: {message}", *waiting, *(f"Hint: {hint}" for hint in hints)]),
            "output_format": "text", "visibility": "visible"}


def read_roster(path):
    """The `Roster` in a file; raises `BadInput`."""
    try:
        return Roster(Path(path).read_bytes().decode("utf-8"))
    except OSError as error:
        raise BadInput(f"{path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise BadInput(f"{path} is not CSV in UTF-8: {error}") from None


class Roster:
    """A gradebook exported from Canvas: `header`, `rows` of students, `width` of the columns about them (up to Section).

    Raises `BadInput` if the text is no such export.
    """

    def __init__(self, text):
        text = text.lstrip("\ufeff")
        first = text.partition("\n")[0]
        self.delimiter = ";" if first.count(";") > first.count(",") else ","
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=self.delimiter))
        self.header = lines[0] if lines else []
        if self.header[:2] != ["Student", "ID"] or "Section" not in self.header:
            raise BadInput("the roster is not a gradebook exported from Canvas: its columns are to be Student, ID, ..., Section, ...")
        self.width = self.header.index("Section") + 1
        lines = [(line + [""] * len(self.header))[:len(self.header)] for line in lines[1:]]
        self._possible = next((line for line in lines if line[0].strip() == "Points Possible"), [""] * len(self.header))
        # Other lines without an ID say something about columns ("Manual Posting"), not about a student.
        self.rows = [line for line in lines if line[1].strip() and line is not self._possible]

    def column(self, name):
        """What each student has in a column; nothing in one that is not there."""
        return [row[self.header.index(name)] if name in self.header else "" for row in self.rows]

    def possible(self, name):
        return self._possible[self.header.index(name)].strip() if name in self.header else ""


def _feedback(score):
    return "; ".join(f"{answer.problem} {answer.answer}: " + (answer.verdict.status if answer.manual is None else
                     f"{_points(answer.points)} by hand" + (f" ({answer.manual})" if answer.manual else "")) for answer in score.answers)


def _utc(seconds):
    return f"{datetime.fromtimestamp(seconds, timezone.utc):%Y-%m-%d %H:%M:%S}"


def _points(value):
    return f"{value:.2f}"


def _csv(rows, delimiter=","):
    text = io.StringIO()
    csv.writer(text, quoting=csv.QUOTE_ALL, delimiter=delimiter, lineterminator="\r\n").writerows(rows)
    return text.getvalue()
