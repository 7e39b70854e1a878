"""Read one submitted file: the sources of its code cells, and the problem that it is for.

Only code counts: pictures in a notebook may be as large as they like, within what can be held in
memory.
"""

import errno
import json
import multiprocessing
import os
import re
import resource
import stat

from workbook.grading.sandbox.system_calls import address_space_bytes, die_with_parent
from workbook.notebooks.execution import in_child
from workbook.notebooks.exercises import base_number

#: Bytes: larger files are read in a process of limited time and memory, and none above the second.
LARGE_FILE, MAX_FILE = 10 * 2**20, 200 * 2**20
SECONDS, MEMORY = 20, 2 * 2**30
#: Characters of code in one notebook, since all notebooks of a course are in memory while they wait;
#: and its code cells.
MAX_CODE, MAX_CELLS = 2**20, 2000
#: Errors on opening a file that is a link, a socket or a device; others are the machine's.
FILE_ERRORS = {errno.ELOOP, errno.ENXIO, errno.ENODEV}
#: The name of a notebook as it is handed out, ch1-p15, also within the name that a browser or a
#: learning platform gave it.
HANDED_OUT_NAME = re.compile(
    r"(?<![a-z0-9])ch0*([0-9]{1,3})(?:[ ._-]p?|p)0*([0-9]{1,3})(?![0-9])", re.IGNORECASE
)
#: A line of text that assigns a variable.
ASSIGNED_NAME = re.compile(r"^[ ]{0,3}([A-Za-z_]\w{0,100})\s{0,9}=(?!=)", re.MULTILINE)
SHORT_NAME = re.compile(r"0*([0-9]{1,3})[._-]p?0*([0-9]{1,3})(?:[^0-9].*)?", re.DOTALL)


class UnreadableFileError(Exception):
    """The file is not a notebook that can be run; the message gives the reason."""


def content(path):
    """Return the bytes of a regular file; nothing else is read."""
    try:
        # O_NOFOLLOW and O_NONBLOCK: neither a link to somebody else's file nor a pipe that never
        # ends.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
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


def notebook(content):
    """Return (number in its metadata or None, sources of its code cells, names in its text cells).

    The names are those that a cell of text assigns, as one does that was a code cell before.
    """
    if len(content) <= LARGE_FILE:
        return _parse(content)
    try:
        number, cells, names, trouble = in_child(_parse_within_limits, content, timeout=6 * SECONDS)
    except RuntimeError:
        raise UnreadableFileError(
            f"the file has {len(content) / 2**20:.0f} MB, and reading it took more time or memory "
            "than allowed"
        ) from None
    if trouble:
        raise UnreadableFileError(trouble)
    return number, tuple(cells), tuple(names)


def text_cells(content):
    """Return the texts of a notebook's cells that are no code, without those of a large file."""
    if len(content) > LARGE_FILE:
        return (f"(a notebook of {len(content) / 2**20:.0f} MB: open it to read its text)",)
    return _parse_json(content)[1]


def number_of_name(stem):
    """Return the problem that the name of a file gives, or None.

    Such names are 1.15, 1_15, ch1-p15, Copy of ch1-p15, Ann_123_ch1-p15 (1).
    """
    numbers = {match.groups() for match in HANDED_OUT_NAME.finditer(stem)}
    if not numbers and (match := SHORT_NAME.fullmatch(stem)):
        numbers = {match.groups()}
    return ".".join(numbers.pop()) if len(numbers) == 1 else None


def _parse_within_limits(content):
    """Parse in a child: 200 MB of empty lists would take many times that in memory."""
    die_with_parent(multiprocessing.parent_process().pid)
    resource.setrlimit(resource.RLIMIT_AS, (address_space_bytes() + MEMORY,) * 2)
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    try:
        return [*_parse(content), ""]
    except UnreadableFileError as trouble:
        return [None, [], [], str(trouble)]


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
    return _number(data), cells, tuple(sorted(names)[:MAX_CELLS])


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
    try:
        number = data["metadata"]["workbook"]["number"]
    except (KeyError, TypeError):
        return None
    # whose numbers a notebook has is not the student's to say
    return (
        base_number(number)
        if isinstance(number, str) and re.fullmatch(r"[0-9]{1,3}\.[0-9]{1,3}(~[0-9]{1,4})?", number)
        else None
    )
