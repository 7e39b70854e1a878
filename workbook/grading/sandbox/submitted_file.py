"""Read one submitted file: the sources of its code cells, and the problem that it is for.

Only code counts: pictures in a notebook may be as large as they like, within what can be held in
memory.
"""

import errno
import hashlib
import json
import os
import re
import stat
import sys
from dataclasses import dataclass

from workbook.grading.sandbox.limited_process import LimitedProcess, LimitError
from workbook.grading.sandbox.sanitising import sanitise
from workbook.notebooks.origin import marks_of
from workbook.numbering import base_number, read_number

#: Bytes: larger files are not read.
MAX_FILE = 200 * 2**20
#: Characters of code in one notebook, since all notebooks of a course are in memory while they wait;
#: and its code cells.
MAX_CODE, MAX_CELLS = 2**20, 2000
#: Neither a link to somebody else's file is opened nor a pipe that never ends. Windows has no such
#: flags and no such pipes.
if sys.platform == "win32":
    READ_REGULAR = os.O_RDONLY | os.O_BINARY
else:
    READ_REGULAR = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK
#: Errors on opening a file that is a link, a socket or a device; others are the machine's.
FILE_ERRORS = {errno.ELOOP, errno.ENXIO, errno.ENODEV}
#: Characters of a text cell, and of the text cells of one notebook, that are shown to a lecturer.
MAX_SHOWN, MAX_SHOWN_TOGETHER = 20_000, 100_000
#: A link, which a notebook that was handed out has or has not. No bracket in it is one's own: else
#: thousands of brackets without an end would take hours.
LINK = re.compile(r"\[([^\[\]]*)\]\([^()]*\)")
#: A line of text that assigns a variable.
ASSIGNED_NAME = re.compile(r"^[ ]{0,3}([A-Za-z_]\w{0,100})\s{0,9}=(?!=)", re.MULTILINE)


class UnreadableFileError(Exception):
    """The file is not a notebook that can be run; the message gives the reason."""


def content(path):
    """Return the bytes of a regular file; nothing else is read."""
    try:
        if sys.platform == "win32" and os.path.islink(path):
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
        descriptor = os.open(path, READ_REGULAR)
    except OSError as error:
        if error.errno not in FILE_ERRORS:
            raise
        raise UnreadableFileError("the file is a symbolic link or cannot be opened") from None
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise UnreadableFileError("this is not a regular file")
        if status.st_size > MAX_FILE:
            raise UnreadableFileError(
                f"the file has {status.st_size / 2**20:.0f} MB; notebooks up to {MAX_FILE // 2**20} "
                "MB are read"
            )
        with open(descriptor, "rb", closefd=False) as file:
            return file.read(MAX_FILE + 1)
    finally:
        os.close(descriptor)


@dataclass(frozen=True)
class Notebook:
    """What is read in a notebook.

    Parameters
    ----------
    number : str or None
        The problem in its metadata.
    cells : tuple of str
        The sources of its code cells.
    names_in_text : tuple of str
        What its cells of text assign, as one does that was a code cell before.
    marks : tuple of str
        Its course and the fingerprint of its statement (`workbook.notebooks.origin`).
    """

    number: str | None
    cells: tuple
    names_in_text: tuple
    marks: tuple = ("", "")


class Reader:
    """Reads notebooks in a process of limited time and memory; use it as a context manager."""

    def __init__(self):
        self._process = LimitedProcess(_read_notebook, _read_text)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self._process.__exit__(*error)

    def notebook(self, content):
        """Return the `Notebook` in a file's bytes; raise `UnreadableFileError`."""
        number, cells, names, marks = self._read(_read_notebook, content)
        return Notebook(number, tuple(cells), tuple(names), tuple(marks))

    def text(self, content):
        """Return (number in the metadata or None, [(hash, text)] of the cells that are no code).

        The hash is that of `text_hash`; the text is safe to show, and what is long is cut.
        """
        number, cells = self._read(_read_text, content)
        return number, [tuple(cell) for cell in cells]

    def _read(self, function, content):
        try:
            result = self._process.call(function, content)
        except LimitError:
            raise UnreadableFileError(
                f"the file has {len(content) / 2**20:.0f} MB, and reading it took more time or "
                "memory than allowed"
            ) from None
        if "trouble" in result:
            raise UnreadableFileError(result["trouble"])
        return result["read"]


def text_cells(content):
    """Return the texts of a notebook's cells that are no code, for one that was handed out."""
    return _parse_json(content)[1]


def text_hash(text):
    """Return a hash of a text cell, the same with and without links and with other spaces."""
    plain = " ".join(LINK.sub(r"\1", text).split())
    return hashlib.sha256(plain.encode("utf-8", "surrogatepass")).hexdigest()


# In the limited process


def _read_notebook(content):
    return _told(_parse, content)


def _read_text(content):
    return _told(_parse_text, content)


def _told(parse, content):
    """Return what `parse` returns as data, or the trouble that it raises."""
    try:
        return {"read": parse(content)}
    except UnreadableFileError as trouble:
        return {"trouble": str(trouble)}


def _parse(content):
    if not content.strip():
        raise UnreadableFileError("the file is empty")
    if content.startswith(b"PK\x03\x04"):
        raise UnreadableFileError("the file is a .zip archive with the name of a notebook")
    data, texts, cells = _parse_json(content)
    if sum(map(len, cells)) > MAX_CODE or len(cells) > MAX_CELLS:
        raise UnreadableFileError(
            f"the notebook holds more than {MAX_CODE // 2**20} MB of code, or more than "
            f"{MAX_CELLS} cells of it"
        )
    names = {name for text in texts[:MAX_CELLS] for name in ASSIGNED_NAME.findall(text[:MAX_CODE])}
    return _number(data), cells, sorted(names)[:MAX_CELLS], marks_of(_about(data))


def _parse_text(content):
    data, texts, _ = _parse_json(content)
    shown, left = [], MAX_SHOWN_TOGETHER
    for text in texts[:MAX_CELLS]:
        if not text.strip():
            continue
        length = min(len(text), MAX_SHOWN, left)
        left -= length
        more = f"\n(and {len(text) - length} more characters: open the notebook to read them)"
        part = sanitise(text[:length], keep="\n\t") + more * (len(text) > length)
        shown.append((text_hash(text), part))
    return _number(data), shown


def _parse_json(content):
    """Return (data, sources of the cells of text, sources of the code cells)."""
    try:
        data = json.loads(content.decode("utf-8-sig"))
        sources = {True: [], False: []}
        for cell in _cells(data):
            sources[cell.get("cell_type") == "code"].append(_source(cell))
        return data, tuple(sources[False]), tuple(sources[True])
    except (UnicodeDecodeError, ValueError, RecursionError):
        raise UnreadableFileError("the file is not a notebook (no JSON in UTF-8)") from None
    except (KeyError, TypeError, AttributeError):
        raise UnreadableFileError("the file is JSON, but not a notebook") from None


def _cells(data):
    """Return the cells; notebooks of format 3 have them in worksheets."""
    return (
        data["cells"]
        if "cells" in data
        else [cell for sheet in data["worksheets"] for cell in sheet["cells"]]
    )


def _source(cell):
    source = cell.get("source", cell.get("input", ""))
    return (
        source
        if isinstance(source, str)
        else "".join(part for part in source if isinstance(part, str))
    )


def _number(data):
    """Return the problem in the notebook's metadata, or None."""
    number = _about(data).get("number")
    # whose numbers a notebook has is not the student's to say
    return base_number(number) if isinstance(number, str) and read_number(number) else None


def _about(data):
    """Return the workbook's metadata of a notebook, {} where they are not as they were handed out."""
    try:
        about = data["metadata"]["workbook"]
    except (KeyError, TypeError):
        return {}
    return about if isinstance(about, dict) else {}
