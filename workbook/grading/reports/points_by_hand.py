"""Points by hand: for one answer, or by a table that goes out, is filled in, and comes back.

The table has a row for each answer that waits for a lecturer or has points by hand already. A row
without points changes nothing, and a table with one error is refused as a whole.
"""

from pathlib import Path
from unicodedata import normalize

from workbook.checks.contract.verdict import UNCHECKED
from workbook.grading.course import record
from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import BOM, parse, quoted, read_text
from workbook.grading.course.store import HandPoints, Store
from workbook.grading.reports.exporting import without_formula

HEADER = ["assignment", "student", "problem", "answer", "max", "points", "comment", "why", "by"]


def score_by_hand(graded, student, assignment, problem, answer, points, comment="", by=""):
    """Store a lecturer's points for one answer.

    Parameters
    ----------
    graded : path
        Folder of results.
    student, assignment, problem, answer : str
        Which answer.
    points : float or None
        None removes the points given by hand.
    comment : str
        For the student.
    by : str
        Who gives the points.

    Returns
    -------
    str
        A sentence for the lecturer.

    Raises
    ------
    InputError
        If there is no such answer, or it is not worth so many points.
    """
    student, assignment = normalize("NFC", student), normalize("NFC", assignment)
    label = f"{student}, {assignment}, {problem} {answer}"
    students = _students(graded, assignment)
    worth = _worth(students, assignment, student, problem, answer)
    if points is not None:
        _check_points(points, worth, label)
    with Store(Path(graded) / "grades.sqlite") as store:
        if points is not None:
            key = (student, assignment, problem, answer)
            store.set_points({key: HandPoints(points, comment, by)})
            return f"{label}: {points:g} of {worth:g} points by hand"
        if not store.take_back(student, assignment, problem, answer):
            raise InputError(f"{label} has no points by hand")
        return f"{label}: the automatic points count again"


def export_table(graded, path):
    """Write the table to `path`; return its number of rows. Raises `InputError`."""
    rows = [
        [
            path_of_grades.parent.name,
            name,
            answer["problem"],
            answer["answer"],
            f"{answer['max points']:g}",
            "" if answer["points by hand"] is None else f"{answer['points by hand']:g}",
            answer["by hand"] or "",
            answer["message"],
            answer.get("given by", ""),
        ]
        for path_of_grades in sorted(Path(graded).glob("*/grades.json"))
        for name, student in record.read(path_of_grades)["students"].items()
        for answer in student["answers"]
        if answer["verdict"] == UNCHECKED or answer["by hand"] is not None
    ]
    text = BOM + quoted([HEADER, *(map(without_formula, row) for row in rows)])
    record.put(Path(path), text)
    return len(rows)


def import_table(graded, path, by=""):
    """Store the points in the table at `path`; return for how many answers. Raises `InputError`.

    `by` is who gives those of rows whose column "by" is empty.
    """
    _, lines = parse(read_text(path))
    header, *rows = lines or [[]]
    columns = {name.strip().lower(): column for column, name in enumerate(header)}
    if missing := [name for name in [*HEADER[:4], "points"] if name not in columns]:
        raise InputError(
            f"{path} has no column {', '.join(missing)}; workbook score --export writes such a table"
        )
    grades, entries = {}, {}
    for line, row in enumerate(rows, 2):
        cells = {name: _without_apostrophe(row[column].strip()) for name, column in columns.items()}
        if not cells["points"]:
            continue
        label = f"{path}, row {line}"
        assignment, student = (
            normalize("NFC", cells["assignment"]),
            normalize("NFC", cells["student"]),
        )
        key = (student, assignment, cells["problem"], cells["answer"])
        if key in entries:
            raise InputError(f"{label}: {', '.join(key)} has another row above")
        try:
            if assignment not in grades:
                grades[assignment] = _students(graded, assignment)
            worth = _worth(grades[assignment], assignment, *key[:1], *key[2:])
        except InputError as error:
            raise InputError(f"{label}: {error}") from None
        try:
            points = float(cells["points"].replace(",", "."))
        except ValueError:
            raise InputError(
                f"{label}: points is {cells['points']!r}, and is to be a number from 0 to {worth:g}"
            ) from None
        _check_points(points, worth, label)
        entries[key] = HandPoints(points, cells.get("comment", ""), cells.get("by") or by)
    with Store(Path(graded) / "grades.sqlite") as store:
        store.set_points(entries)
    return len(entries)


def _without_apostrophe(cell):
    return cell[1:] if cell[:1] == "'" and without_formula(cell[1:]) == cell else cell


def _students(graded, assignment):
    students = record.read(Path(graded) / assignment / "grades.json")["students"]
    if not students:
        raise InputError(
            f"there are no grades of {assignment} in {graded}; run workbook grade first, or say "
            "where with --graded"
        )
    return students


def _worth(students, assignment, student, problem, answer):
    """Return what an answer of a student is worth."""
    if student not in students:
        raise InputError(
            f"{assignment} has no student {student}; a folder of that name beside the others' "
            "makes one known to workbook grade"
        )
    worth = {
        (row["problem"], row["answer"]): row["max points"] for row in students[student]["answers"]
    }
    if (problem, answer) not in worth:
        raise InputError(
            f"{assignment} asks for no {problem} {answer}; there are "
            f"{', '.join(f'{p} {a}' for p, a in worth)}"
        )
    return worth[problem, answer]


def _check_points(points, worth, label):
    # The table shows what an answer is worth with six digits.
    if not 0 <= points <= worth * (1 + 1e-5):
        raise InputError(f"{label} is worth {worth:g} points; assignment.toml can make it more")
