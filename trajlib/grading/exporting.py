"""Grades as other systems read them: plain CSV, Moodle, Canvas, nbgrader, and Gradescope's results.json.

Every file is quoted CSV in UTF-8. A cell that a spreadsheet would take for a formula gets an apostrophe in front.
"""

import csv
import io
import json

#: Gradescope knows passed and failed; what no check could judge is failed there until a lecturer has looked.
GRADESCOPE_STATUS = {True: "passed", False: "failed"}


def plain_csv(assignment, scores):
    """One row a student: points by problem, total, late problems, whether somebody has to look at it."""
    header = ["student", *assignment.problems, "total", "max", "late", "needs review"]
    rows = []
    for score in scores:
        by_problem = [_points(sum(a.points for a in score.answers if a.problem == problem)) for problem in assignment.problems]
        rows.append([score.student, *by_problem, _points(score.points), _points(score.max_points), " ".join(score.late),
                     "yes" if score.needs_review else "no"])
    return _csv([header, *rows])


def moodle_csv(assignment, scores):
    """For Moodle's import, which maps columns by hand: the grade and its feedback always together.

    Importing feedback without the grade would wipe grades, and one unknown user aborts the whole import.
    """
    header = ["ID number", assignment.title, f"{assignment.title} (feedback)"]
    return _csv([header, *([score.student, _points(score.points), _feedback(score)] for score in scores)])


def canvas_csv(assignment, scores, roster):
    """The roster exported from Canvas with one column filled; `roster` is the text of that file.

    Students are matched by "SIS User ID", "SIS Login ID" or "ID"; rows of students without a submission stay empty.
    Raises `ValueError` if the text has not the columns of a Canvas export.
    """
    rows = list(csv.reader(io.StringIO(roster.lstrip("\ufeff"))))
    if not rows or rows[0][:1] != ["Student"] or "ID" not in rows[0] or "Section" not in rows[0]:
        raise ValueError("roster: expected a gradebook exported from Canvas, with the columns Student, ID, ..., Section")
    columns = rows[0][:rows[0].index("Section") + 1]
    known = {score.student: score for score in scores}
    header = [*columns, assignment.title]
    filled = [["    Points Possible", *[""] * (len(columns) - 1), _points(assignment.max_points)]]
    for row in rows[1:]:
        if row and row[0].strip() != "Points Possible":
            row = row[:len(columns)] + [""] * (len(columns) - len(row))
            keys = [row[columns.index(name)] for name in ("SIS User ID", "SIS Login ID", "ID") if name in columns]
            score = next((known[key] for key in keys if key in known), None)
            filled.append([*row, _points(score.points) if score else ""])
    return _csv([header, *filled], guard=False)  # Canvas's own cells go back as they came


def nbgrader_csv(assignment, scores):
    """The columns of `nbgrader export`, quoted (its own export is not)."""
    header = ["assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email", "raw_score",
              "late_submission_penalty", "score", "max_score"]
    due = assignment.due.isoformat() if assignment.due else ""
    return _csv([header, *([assignment.name, due, "", score.student, "", "", "", _points(score.points), "0.0", _points(score.points),
                            _points(score.max_points)] for score in scores)])


def gradescope_json(score):
    """results.json for one student: a test an answer, with its message, never the solution."""
    tests = [{"name": f"{answer.problem} {answer.answer}", "score": round(answer.points, 4), "max_score": round(answer.max_points, 4),
              "status": GRADESCOPE_STATUS[answer.points >= answer.max_points], "output": f"{answer.verdict.status}: {answer.verdict.message}",
              "output_format": "text", "visibility": "visible"} for answer in score.answers]
    remarks = [f"{problem}: {remark}" for problem, said in score.remarks.items() for remark in said]
    return json.dumps({"score": round(score.points, 4), "output": "\n".join(remarks), "output_format": "text",
                       "visibility": "visible", "stdout_visibility": "hidden", "tests": tests}, ensure_ascii=False, indent=1)


def _feedback(score):
    return "; ".join(f"{answer.problem} {answer.answer}: {answer.verdict.status}" for answer in score.answers)


def _points(value):
    return f"{value:.2f}"


def _csv(rows, guard=True):
    text = io.StringIO()
    writer = csv.writer(text, quoting=csv.QUOTE_ALL, lineterminator="\r\n")
    writer.writerows([_harmless(cell) if guard else cell for cell in row] for row in rows)
    return text.getvalue()


def _harmless(cell):
    """A name such as =cmd() is data: spreadsheets run what begins like a formula."""
    return f"'{cell}" if cell[:1] in ("=", "+", "-", "@", "\t", "\r") else cell
