"""A notebook that is the same for all students: who has which row of its numbers.

Its first cell asks for the student's name in the course; `row_of` returns the row, by which the data
cell takes its numbers and `show` the texts. Grades do not depend on it: `numbers.csv` decides.
"""

import hashlib
from unicodedata import normalize

#: Hexadecimal digits of a name's key: enough for different keys in a class of thousands.
DIGITS = 12


def key(student):
    """Return what stands for a student's name in a notebook that all students get.

    >>> key("ann") == key(" Ann ")
    True
    """
    name = normalize("NFC", str(student)).strip().lower()
    return hashlib.sha256(name.encode()).hexdigest()[:DIGITS]


def row_of(student, rows):
    """Return the row of numbers that a student has, and print it.

    Parameters
    ----------
    student : str
        The name in the course: a login, an address or a number.
    rows : dict
        The rows by `key`.

    Raises
    ------
    ValueError
        If the name is not that of a student in the course.
    """
    if student is ...:
        raise ValueError("replace the ... above by your name in the course, in quotes")
    if key(student) not in rows:
        raise ValueError(
            f"{student!r} is nobody in the course: write your name as in the course, in quotes, such "
            "as your login or your address"
        )
    print(f"Row {rows[key(student)]} of the numbers is yours. Run the cells below.")
    return rows[key(student)]


def show(texts, row):
    """Display the text for a row of numbers.

    Parameters
    ----------
    texts : dict
        Markdown by row.
    row : int
        The row.
    """
    from IPython.display import Markdown, display

    display(Markdown(texts[row]))
