"""CSV files: read in any of their forms, written in one.

The separator of a file that is read is whichever of comma, semicolon and tab divides the first line
most often; a byte order mark may be there or not. A spreadsheet saves CSV in UTF-8 or UTF-16 if it
is told to, else in an encoding of Windows.
"""

import codecs
import csv
import io
import sys
from functools import cache
from pathlib import Path

from workbook.grading.course.assignment import InputError
from workbook.grading.course.encodings import decoded

# Moodle's worksheet holds whole texts of students in a cell; by default a longer one is an error.
csv.field_size_limit(2**27)

#: The byte order mark, without which spreadsheets take UTF-8 for an older encoding.
BOM = "\ufeff"
#: Encodings that are tried in this order, with the names of those that are told.
ENCODINGS = {"utf-8-sig": None, "cp1251": "Windows-1251", "cp1252": "Windows-1252"}


def read_text(path):
    """Return the text of a file, in whichever of `ENCODINGS` fits first; raises `InputError`.

    One that is not UTF-8 is named on the standard error stream.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    is_utf_16 = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    text, encoding = decoded(data, ["utf-16"] if is_utf_16 else ENCODINGS)
    if encoding is None:
        raise InputError(
            f"{path} is not CSV in UTF-8, UTF-16, Windows-1251 or Windows-1252: save it in the "
            'spreadsheet as "CSV UTF-8 (comma delimited)"'
        )
    if name := ENCODINGS.get(encoding):
        _tell(path, name)
    return text


@cache
def _tell(path, encoding):
    """Name an encoding, once for each file."""
    print(f"{path} is read as {encoding}", file=sys.stderr)


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
