"""Grades for Canvas: one column of a gradebook that was exported from there.

The points are written as they are, also where Canvas has other points possible for the column: so
they agree with the student's page and every other table.
"""

import csv
import io
import re
from pathlib import Path
from unicodedata import normalize

from workbook.grading.assignment import InputError
from workbook.grading.exporting import decimal, quoted


def canvas_csv(assignment, scores, roster):
    """Fill one column of the gradebook exported from Canvas.

    Students are matched by whichever of "SIS User ID", "SIS Login ID" and "ID" fits most of them. A
    column that Canvas already has for the assignment, "Title (1234)", is filled; else Canvas makes
    a new one. The cell of a student without a grade stays as it is.

    Parameters
    ----------
    assignment : Assignment
        The homework.
    scores : list of StudentScore
        The scores of the class.
    roster : Roster
        The gradebook.

    Returns
    -------
    tuple
        (text of the gradebook, students that it does not have).
    """
    score_of = {score.student: score for score in scores}
    # In the normal form of students' names, which are those of folders.
    keys = [
        [normalize("NFC", identity) for identity in roster.column(name)]
        for name in ("SIS User ID", "SIS Login ID", "ID")
    ]
    identities = max(keys, key=lambda column: sum(name in score_of for name in column))
    column = _column(assignment, roster)
    possible = roster.possible(column) or decimal(assignment.max_points)
    rows = [["    Points Possible", *[""] * (roster.width - 1), possible]]
    for identity, row, present in zip(identities, roster.rows, roster.column(column)):
        score = score_of.get(identity)
        rows.append(
            [
                *row[: roster.width],
                decimal(score.points)
                if score and score.handed_in and not score.needs_review
                else present,
            ]
        )
    text = quoted([[*roster.header[: roster.width], column], *rows], roster.delimiter)
    return text, [score.student for score in scores if score.student not in set(identities)]


def different_points(assignment, roster):
    """Return the gradebook's points possible as text if the assignment's differ, else ""."""
    possible = roster.possible(_column(assignment, roster))
    try:
        same = abs(float(possible.replace(",", ".")) - assignment.max_points) < 0.005
    except ValueError:
        same = True  # empty, or "(read only)"
    return "" if same else possible


def _column(assignment, roster):
    return next(
        (
            name
            for name in roster.header
            if re.fullmatch(rf"{re.escape(assignment.title)} \(\d+\)", name)
        ),
        assignment.title,
    )


def read_roster(path):
    """Return the `Roster` in a file; raises `InputError`."""
    try:
        return Roster(Path(path).read_bytes().decode("utf-8"))
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{path} is not CSV in UTF-8: {error}") from None


class Roster:
    """A gradebook exported from Canvas.

    It has the `header`, the `rows` of students, and as `width` the number of columns about them, up
    to Section. Raises `InputError` if the text is no such export.
    """

    def __init__(self, text):
        text = text.lstrip("\ufeff")
        first = text.partition("\n")[0]
        self.delimiter = ";" if first.count(";") > first.count(",") else ","
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=self.delimiter))
        self.header = lines[0] if lines else []
        if self.header[:2] != ["Student", "ID"] or "Section" not in self.header:
            raise InputError(
                "the roster is not a gradebook exported from Canvas: its columns are to be "
                "Student, ID, ..., Section, ..."
            )
        self.width = self.header.index("Section") + 1
        lines = [(line + [""] * len(self.header))[: len(self.header)] for line in lines[1:]]
        self._possible = next(
            (line for line in lines if line[0].strip() == "Points Possible"),
            [""] * len(self.header),
        )
        # Other lines without an ID are about columns ("Manual Posting"), not about a student.
        self.rows = [line for line in lines if line[1].strip() and line is not self._possible]

    def column(self, name):
        """Return each student's cell in a column; "" if there is no such column."""
        return [row[self.header.index(name)] if name in self.header else "" for row in self.rows]

    def possible(self, name):
        """Return the points possible in a column as text; "" if there is no such column."""
        return self._possible[self.header.index(name)].strip() if name in self.header else ""
