"""Grades for Canvas: one column of a gradebook that was exported from there.

The points are written as they are, also where Canvas has other points possible for the column: so
they agree with the student's page and every other table.
"""

import re

from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import quoted, read_text
from workbook.grading.course.roster import Roster, normalise_cell
from workbook.grading.reports.exporting import decimal


def canvas_csv(assignment, scores, gradebook):
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
    gradebook : Gradebook
        The gradebook.

    Returns
    -------
    str
        The text of the gradebook.
    """
    score_of = {score.student: score for score in scores}
    column = _column(assignment, gradebook)
    possible = gradebook.possible(column) or decimal(assignment.max_points)
    rows = [["    Points Possible", *[""] * (gradebook.width - 1), possible]]
    for identity, row, present in zip(
        gradebook.identities(score_of), gradebook.rows, gradebook.column(column)
    ):
        score = score_of.get(identity)
        rows.append(
            [
                *row[: gradebook.width],
                decimal(score.points)
                if score and score.handed_in and not score.needs_review
                else present,
            ]
        )
    header = [*gradebook.header[: gradebook.width], column]
    return quoted([header, *rows], gradebook.delimiter)


def different_points(assignment, gradebook):
    """Return the gradebook's points possible as text if the assignment's differ, else ""."""
    possible = gradebook.possible(_column(assignment, gradebook))
    try:
        equal = abs(float(possible.replace(",", ".")) - assignment.max_points) < 0.005
    except ValueError:
        equal = True  # empty, or "(read only)"
    return "" if equal else possible


def _column(assignment, gradebook):
    return next(
        (
            name
            for name in gradebook.header
            if re.fullmatch(rf"{re.escape(assignment.title)} \(\d+\)", name)
        ),
        assignment.title,
    )


def read_roster(path):
    """Return the `Gradebook` in a file, or the `Roster` if it is another; raises `InputError`."""
    text = read_text(path)
    try:
        return (Gradebook if Gradebook.is_one(text) else Roster)(text)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


class Gradebook(Roster):
    """A gradebook exported from Canvas.

    It has the `header`, the `rows` of students, and as `width` the number of columns about them, up
    to Section.
    """

    def __init__(self, text):
        super().__init__(text)
        self.width = self.header.index("Section") + 1
        self._possible = next(
            (row for row in self.rows if row[0].strip() == "Points Possible"),
            [""] * len(self.header),
        )
        # Other lines without an ID are about columns ("Manual Posting"), not about a student.
        self.rows = [row for row in self.rows if row[1].strip() and row is not self._possible]

    @staticmethod
    def is_one(text):
        """Return whether a text is such an export."""
        header = Roster(text).header
        return header[:2] == ["Student", "ID"] and "Section" in header

    def _identity_columns(self):
        return [
            [normalise_cell(cell) for cell in self.column(name)]
            for name in ("SIS User ID", "SIS Login ID", "ID")
        ]

    def pairs(self):
        """Return (name, ID) of each person."""
        return zip(self.column("Student"), self.column("ID"))

    def column(self, name):
        """Return each student's cell in a column; "" if there is no such column."""
        return [row[self.header.index(name)] if name in self.header else "" for row in self.rows]

    def possible(self, name):
        """Return the points possible in a column as text; "" if there is no such column."""
        return self._possible[self.header.index(name)].strip() if name in self.header else ""
