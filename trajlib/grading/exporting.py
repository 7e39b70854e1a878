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
    already has for the assignment, "Title (1234)", is filled; else Canvas makes a new one. A row without a grade stays
    empty. Raises `BadInput` if the text is no such export.
    """
    table = Roster(roster)
    known = {score.student: score for score in scores}
    key = max(("SIS User ID", "SIS Login ID", "ID"), key=lambda name: sum(row in known for row in table.column(name)))
    column = next((name for name in table.header if re.fullmatch(rf"{re.escape(assignment.title)} \(\d+\)", name)), assignment.title)
    possible = table.possible(column) or _points(assignment.max_points)
    rows = [["    Points Possible", *[""] * (table.width - 1), possible]]
    for identity, row in zip(table.column(key), table.rows):
        score = known.get(identity)
        rows.append([*row, _points(score.points) if score and score.handed_in and not score.needs_review else ""])
    text = _csv([[*table.header[:table.width], column], *rows], table.delimiter)
    return text, [score.student for score in scores if score.student not in set(table.column(key))]


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


def gradescope_json(score, hints, remarks=(), seconds=None):
    """results.json for one student: a test an answer, with its message and the next hint, never the solution.

    `hints` maps (problem, answer) to the hints that are open to the student.
    """
    tests = [{"name": f"{answer.problem} {answer.answer}", "score": round(answer.points, 4), "max_score": round(answer.max_points, 4),
              # Gradescope knows no third state: what no check could judge says so in its text.
              "status": "passed" if answer.verdict.status == RIGHT else "failed",
              "output": "\n".join([f"{answer.verdict.status}: {answer.verdict.message}",
                                   *(["Your lecturer has to look at this answer; it is not counted as wrong."] if answer.verdict.status == UNCHECKED else []),
                                   *(f"Hint: {hint}" for hint in hints.get((answer.problem, answer.answer), ()))]),
              "output_format": "text", "visibility": "visible"} for answer in score.answers]
    result = {"score": round(score.points, 4), "output": "\n".join(remarks), "output_format": "text",
              "visibility": "visible", "stdout_visibility": "hidden", "tests": tests}
    if seconds is not None:
        result["execution_time"] = round(seconds)
    return json.dumps(result, ensure_ascii=False, indent=1) + "\n"


class Roster:
    """A gradebook exported from Canvas: `header`, `rows` of students up to the column Section, `width` of those."""

    def __init__(self, text):
        text = text.lstrip("\ufeff")
        self.delimiter = ";" if text.split("\n")[0].count(";") > text.split("\n")[0].count(",") else ","
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=self.delimiter))
        self.header = lines[0] if lines else []
        if self.header[:2] != ["Student", "ID"] or "Section" not in self.header:
            raise BadInput("the roster is not a gradebook exported from Canvas: its columns are to be Student, ID, ..., Section, ...")
        self.width = self.header.index("Section") + 1
        self._possible = next((line for line in lines[1:] if line and line[0].strip() == "Points Possible"), [])
        # Further lines about columns ("Manual Posting") name no student.
        students = [line for line in lines[1:] if line and line is not self._possible and len(line) > 1 and line[1].strip()]
        self.rows = [(line + [""] * self.width)[:self.width] for line in students]

    def column(self, name):
        place = self.header.index(name) if name in self.header[:self.width] else None
        return [row[place] if place is not None else "" for row in self.rows]

    def possible(self, name):
        place = self.header.index(name) if name in self.header else len(self._possible)
        return self._possible[place].strip() if place < len(self._possible) else ""


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
