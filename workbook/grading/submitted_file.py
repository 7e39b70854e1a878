"""Read one submitted file: the sources of its code cells, and the problem that it names; or a
sentence that says why not.

Only code counts: pictures that a notebook shows may be as large as they like, within what can be
held in memory.
"""

import errno
import json
import multiprocessing
import os
import re
import resource
import stat

from workbook.grading.isolation import end_with_parent, loaded
from workbook.notebooks.execution import in_child

#: Files up to the first are read here; larger ones, up to the second, in a process of limited time
#: and memory.
LARGE, LARGEST = 10 * 2**20, 200 * 2**20
SECONDS, MEMORY = 20, 2 * 2**30
#: Of code in one notebook, in characters: all notebooks of a course are held in memory while they
#: wait.
MOST_CODE, MOST_CELLS = 2**20, 2000
#: Errors on opening a file that are the file's own doing: it is a link, a socket, a device.
THEIRS = {errno.ELOOP, errno.ENXIO, errno.ENODEV}
#: How a notebook is handed out, ch1-p15, also within the name that a browser or a learning platform
#: gave it.
AS_HANDED_OUT = re.compile(
    r"(?<![a-z0-9])ch0*([0-9]{1,3})(?:[ ._-]p?|p)0*([0-9]{1,3})(?![0-9])", re.IGNORECASE
)
IN_SHORT = re.compile(r"0*([0-9]{1,3})[._-]p?0*([0-9]{1,3})(?:[^0-9].*)?", re.DOTALL)


class Unreadable(Exception):
    """The file is no notebook that can be run; the message says why."""


def content(path):
    """The bytes of a regular file; of anything else nothing is read."""
    try:
        # O_NOFOLLOW and O_NONBLOCK: neither a link to somebody else's file nor a pipe that never
        # ends.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError as error:
        if error.errno not in THEIRS:
            raise
        raise Unreadable("the file is a symbolic link or cannot be opened") from None
    try:
        about = os.fstat(descriptor)
        if not stat.S_ISREG(about.st_mode):
            raise Unreadable("this is not a regular file")
        if about.st_size > LARGEST:
            raise Unreadable(
                f"the file has {about.st_size / 2**20:.0f} MB; notebooks up to {LARGEST // 2**20} "
                "MB are read"
            )
        with open(descriptor, "rb", closefd=False) as file:
            return file.read(LARGEST + 1)
    finally:
        os.close(descriptor)


def notebook(content):
    """(number that its metadata names or None, sources of its code cells). Raises `Unreadable`."""
    if len(content) <= LARGE:
        return _notebook(content)
    try:
        number, cells, trouble = in_child(_within_limits, content, timeout=6 * SECONDS)
    except RuntimeError:
        raise Unreadable(
            f"the file has {len(content) / 2**20:.0f} MB, and reading it took more time or memory "
            "than allowed"
        ) from None
    if trouble:
        raise Unreadable(trouble)
    return number, tuple(cells)


def number_of_name(stem):
    """The problem of a notebook that lost its metadata: 1.15, 1_15, ch1-p15, Copy of ch1-p15,
    Ann_123_ch1-p15 (1); or None."""
    found = {match.groups() for match in AS_HANDED_OUT.finditer(stem)}
    if not found and (match := IN_SHORT.fullmatch(stem)):
        found = {match.groups()}
    return ".".join(found.pop()) if len(found) == 1 else None


def _within_limits(content):
    """In a child: 200 MB of empty lists would take many times that in memory."""
    end_with_parent(multiprocessing.parent_process().pid)
    resource.setrlimit(resource.RLIMIT_AS, (loaded() + MEMORY,) * 2)
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    try:
        return [*_notebook(content), ""]
    except Unreadable as trouble:
        return [None, [], str(trouble)]


def _notebook(content):
    if not content.strip():
        raise Unreadable("the file is empty")
    if content.startswith(b"PK\x03\x04"):
        raise Unreadable("the file is a .zip archive with the name of a notebook")
    try:
        given = json.loads(content.decode("utf-8-sig"))
        cells = tuple(_source(cell) for cell in _cells(given) if cell.get("cell_type") == "code")
    except (UnicodeDecodeError, ValueError, RecursionError):
        raise Unreadable("the file is not a notebook (no JSON in UTF-8)") from None
    except (KeyError, TypeError, AttributeError):
        raise Unreadable("the file is JSON, but not a notebook") from None
    if sum(map(len, cells)) > MOST_CODE or len(cells) > MOST_CELLS:
        raise Unreadable(
            f"the notebook holds more than {MOST_CODE // 2**20} MB of code, or more than "
            f"{MOST_CELLS} cells of it"
        )
    return _number(given), cells


def _cells(given):
    """Old notebooks, of format 3, hold them in worksheets."""
    return (
        given["cells"]
        if "cells" in given
        else [cell for sheet in given["worksheets"] for cell in sheet["cells"]]
    )


def _source(cell):
    source = cell.get("source", cell.get("input", ""))
    return (
        source
        if isinstance(source, str)
        else "".join(part for part in source if isinstance(part, str))
    )


def _number(given):
    """The problem that the notebook's metadata names, if it names one."""
    try:
        number = given["metadata"]["workbook"]["number"]
    except (KeyError, TypeError):
        return None
    return (
        number
        if isinstance(number, str) and re.fullmatch(r"[0-9]{1,3}\.[0-9]{1,3}", number)
        else None
    )
