"""Grades for Canvas: one column of the gradebook that was exported from there, with the points of
this homework.

The points stand as they are, also where Canvas has other points possible for the column: they are
what the student's page and every other table say.
"""

import csv
import io
import re
from pathlib import Path
from unicodedata import normalize

from workbook.grading.assignment import BadInput
from workbook.grading.exporting import decimal, quoted


def canvas_csv(assignment, scores, roster):
    """(text, unmatched): the gradebook exported from Canvas with one column filled, and students it
    does not know.

    Students are matched by whichever of "SIS User ID", "SIS Login ID" and "ID" fits most of them. A
    column that Canvas already has for the assignment, "Title (1234)", is filled; else Canvas makes
    a new one. Who has no grade yet keeps what stands there. `roster` is a `Roster`.
    """
    known = {score.student: score for score in scores}
    # Spelt as the names of students are, which are those of folders.
    keys = [
        [normalize("NFC", given) for given in roster.column(name)]
        for name in ("SIS User ID", "SIS Login ID", "ID")
    ]
    identities = max(keys, key=lambda given: sum(one in known for one in given))
    column = _column(assignment, roster)
    possible = roster.possible(column) or decimal(assignment.max_points)
    rows = [["    Points Possible", *[""] * (roster.width - 1), possible]]
    for identity, row, present in zip(identities, roster.rows, roster.column(column)):
        score = known.get(identity)
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


def difference(assignment, roster):
    """What the gradebook says the homework is worth, as text, if that is not what the assignment
    says; else nothing."""
    possible = roster.possible(_column(assignment, roster))
    try:
        same = abs(float(possible.replace(",", ".")) - assignment.max_points) < 0.005
    except ValueError:
        same = True  # nothing, or "(read only)"
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
    """The `Roster` in a file; raises `BadInput`."""
    try:
        return Roster(Path(path).read_bytes().decode("utf-8"))
    except OSError as error:
        raise BadInput(f"{path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise BadInput(f"{path} is not CSV in UTF-8: {error}") from None


class Roster:
    """A gradebook exported from Canvas: `header`, `rows` of students, `width` of the columns about
    them (up to Section).

    Raises `BadInput` if the text is no such export.
    """

    def __init__(self, text):
        text = text.lstrip("\ufeff")
        first = text.partition("\n")[0]
        self.delimiter = ";" if first.count(";") > first.count(",") else ","
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=self.delimiter))
        self.header = lines[0] if lines else []
        if self.header[:2] != ["Student", "ID"] or "Section" not in self.header:
            raise BadInput(
                "the roster is not a gradebook exported from Canvas: its columns are to be "
                "Student, ID, ..., Section, ..."
            )
        self.width = self.header.index("Section") + 1
        lines = [(line + [""] * len(self.header))[: len(self.header)] for line in lines[1:]]
        self._possible = next(
            (line for line in lines if line[0].strip() == "Points Possible"),
            [""] * len(self.header),
        )
        # Other lines without an ID say something about columns ("Manual Posting"), not about a
        # student.
        self.rows = [line for line in lines if line[1].strip() and line is not self._possible]

    def column(self, name):
        """What each student has in a column; nothing in one that is not there."""
        return [row[self.header.index(name)] if name in self.header else "" for row in self.rows]

    def possible(self, name):
        return self._possible[self.header.index(name)].strip() if name in self.header else ""
