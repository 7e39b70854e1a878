"""Rosters: who is in the class, from a CSV file with columns in any order and language.

The separator is whichever of comma, semicolon and tab divides the first line most often. Which
column names the students is decided by what stands in it: the one that fits most folders of
submissions, so that a list of a dean's office does as well as one of a learning platform.
"""

from collections import Counter
from itertools import chain, permutations
from unicodedata import normalize

from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import parse


class Roster:
    """The students of a class, from the text of a CSV file.

    Parameters
    ----------
    text : str
        The file's content; its first line has the headers, unless an address or a number is in it.

    Raises
    ------
    InputError
        If there is no student.
    """

    def __init__(self, text):
        self.delimiter, lines = parse(text)
        self.header, self.rows = lines[0] if lines else [], lines[1:]
        if any("@" in cell or cell.strip().isdigit() for cell in self.header):
            self.rows = lines
        if not self.rows:
            raise InputError("the roster is to have a line of headers and one for each student")

    def identities(self, students):
        """Return the name of each person as the folders of submissions have it.

        Parameters
        ----------
        students : iterable of str
            The names of the folders.

        Returns
        -------
        list of str
            One for each of `rows`, "" if it has none.

        Raises
        ------
        InputError
            If two persons have the same.
        """
        folder_names = set(students)
        names = max(
            self._identity_columns(),
            key=lambda column: (
                sum(name in folder_names for name in column),
                sum("@" in name for name in column),
                len(set(column)),
            ),
        )
        if repeated := duplicates(names):
            raise InputError(f"the roster has {', '.join(repeated)} more than once")
        return names

    def _identity_columns(self):
        """Return the columns that may name students."""
        return [[normalise_cell(cell) for cell in column] for column in zip(*self.rows)]

    def pairs(self):
        """Return all pairs of two cells of a person: a name and an ID are one of them."""
        return chain.from_iterable(permutations(row, 2) for row in self.rows)


def normalise_cell(cell):
    """Return the name in a cell in the normal form of folders' names."""
    return normalize("NFC", cell)


def duplicates(names):
    """Return what occurs more than once, except ""."""
    return [name for name, times in Counter(names).items() if name and times > 1]
