"""CSV files: read in any of their forms, written in one.

The separator of a file that is read is whichever of comma, semicolon and tab divides the first line
most often; a byte order mark may be there or not.
"""

import csv
import io
from pathlib import Path

from workbook.grading.course.assignment import InputError

# Moodle's worksheet holds whole texts of students in a cell; by default a longer one is an error.
csv.field_size_limit(2**27)

#: The byte order mark, without which spreadsheets take UTF-8 for an older encoding.
BOM = "\ufeff"


def read_text(path):
    """Return the text of a file in UTF-8; raises `InputError`."""
    try:
        return Path(path).read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not CSV in UTF-8: {error}") from None


def parse(text):
    """Return (separator, rows that are not empty, all as long as the first) of a CSV text.

    Raises `InputError` if it is none.
    """
    text = text.lstrip("\ufeff")
    first = text.partition("\n")[0]
    try:
        delimiter = max(",;\t", key=lambda mark: len(next(csv.reader([first], delimiter=mark), [])))
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))
    except csv.Error as error:
        raise InputError(f"this is not CSV: {error}") from None
    rows = [row for row in lines if any(row)]
    width = len(rows[0]) if rows else 0
    return delimiter, [(row + [""] * width)[:width] for row in rows]


def quoted(rows, delimiter=","):
    """Return rows as CSV with every cell quoted."""
    text = io.StringIO()
    csv.writer(text, quoting=csv.QUOTE_ALL, delimiter=delimiter, lineterminator="\r\n").writerows(
        rows
    )
    return text.getvalue()
