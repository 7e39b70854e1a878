"""Find what was submitted: submitted/<student>/<assignment>/<notebook>.ipynb, as nbgrader lays it out.

Nothing is followed out of the folder: symbolic links are named and left alone. What cannot be read as a notebook is a
submission all the same, with a sentence that says why it earns nothing.
"""

import errno
import hashlib
import json
import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path

from trajlib.grading.printable import printable_name

#: A notebook of text and code is far smaller; outputs are not read, but their bytes count.
LARGEST = 20 * 2**20
#: Of code in one notebook, in characters: all notebooks of a course are held in memory while they wait.
MOST_CODE, MOST_CELLS = 2**20, 2000


@dataclass(frozen=True)
class Submission:
    """One submitted notebook: `cells` are the sources of its code cells, none, with the `trouble` in words, when it cannot be read.

    `student`, `assignment` and `path` are fit to be printed and stored (`printable_name`).
    """

    student: str
    assignment: str
    path: str
    content: str
    submitted: float
    problem: str | None
    cells: tuple
    trouble: str = ""


@dataclass(frozen=True)
class Aside:
    """Something below the folder that is not read, and why."""

    path: str
    why: str


def find(root, assignments=None):
    """All submissions below `root`, and what was left aside, by student, assignment and file; of the named assignments, or of all."""
    for student in _folders(Path(root)):
        if isinstance(student, Aside):
            yield student
            continue
        for assignment in _folders(student):
            if isinstance(assignment, Aside):
                yield assignment
            elif assignments is None or assignment.name in assignments:
                notebooks = [path for path in _listed(assignment) if _is_notebook(path)]
                yield from (_read(printable_name(student.name), printable_name(assignment.name), path) for path in notebooks)
                below = [path for folder in _folders(assignment) if isinstance(folder, Path) and folder not in notebooks
                         for path in _listed(folder) if _is_notebook(path)]
                yield from map(_misplaced, below)
                if not notebooks and not below:
                    yield Aside(printable_name(assignment), "there is no notebook in this folder")


def _folders(path):
    """Folders in a folder, and what is wrong with others; notebooks beside them are too high."""
    for entry in _listed(path):
        if entry.name.startswith("."):
            continue
        if entry.is_symlink():
            yield Aside(printable_name(entry), "this is a symbolic link")
        elif entry.is_dir():
            if os.access(entry, os.R_OK | os.X_OK):
                yield entry
            else:
                yield Aside(printable_name(entry), "this folder cannot be opened")
        elif _is_notebook(entry):
            yield _misplaced(entry)


def _listed(path):
    return sorted(path.iterdir(), key=lambda entry: os.fsencode(entry.name))


def _is_notebook(path):
    """By its name; ._p15.ipynb is what a Mac puts beside p15.ipynb, and nobody's work."""
    return path.suffix.lower() == ".ipynb" and not path.name.startswith("._")


def _misplaced(path):
    return Aside(printable_name(path), "it does not lie in a folder STUDENT/HOMEWORK, where notebooks are read")


class _Unreadable(Exception):
    """The file is no notebook that can be run; the message says why."""


#: Errors on opening a file that are the file's own doing: it is a link, a socket, a device.
THEIRS = {errno.ELOOP, errno.ENXIO, errno.ENODEV}


def _read(student, assignment, path):
    content, submitted, cells, trouble, number = b"", 0.0, (), "", None
    try:
        content, submitted = _content(path)
        number, cells = _notebook(content)
    except _Unreadable as error:
        trouble = str(error)
    except OSError as error:  # our rights or our disk: no attempt of the student's
        return Aside(printable_name(path), f"this file cannot be read ({error.strerror})")
    fingerprint = hashlib.sha256(content or trouble.encode()).hexdigest()
    return Submission(student, assignment, printable_name(path), fingerprint, submitted, number or _by_name(path.stem), cells, trouble)


def _content(path):
    """(bytes, time of the last change) of a regular file; of anything else nothing is read."""
    try:
        # O_NOFOLLOW and O_NONBLOCK: neither a link to somebody else's file nor a pipe that never ends.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError as error:
        if error.errno not in THEIRS:
            raise
        raise _Unreadable("the file is a symbolic link or cannot be opened") from None
    try:
        about = os.fstat(descriptor)
        if not stat.S_ISREG(about.st_mode):
            raise _Unreadable("this is not a regular file")
        if about.st_size > LARGEST:
            raise _Unreadable(f"the file has {about.st_size / 2**20:.0f} MB; notebooks up to {LARGEST // 2**20} MB are read")
        with open(descriptor, "rb", closefd=False) as file:
            return file.read(LARGEST + 1), about.st_mtime
    finally:
        os.close(descriptor)


def _notebook(content):
    """(number that its metadata names, sources of its code cells)."""
    try:
        notebook = json.loads(content.decode("utf-8-sig"))
        cells = tuple(_source(cell) for cell in notebook["cells"] if cell.get("cell_type") == "code")
    except (UnicodeDecodeError, ValueError, RecursionError):
        raise _Unreadable("the file is not a notebook (no JSON in UTF-8)") from None
    except (KeyError, TypeError, AttributeError):
        raise _Unreadable("the file is JSON, but not a notebook") from None
    if sum(map(len, cells)) > MOST_CODE or len(cells) > MOST_CELLS:
        raise _Unreadable(f"the notebook holds more than {MOST_CODE // 2**20} MB of code, or more than {MOST_CELLS} cells of it")
    return _number(notebook), cells


def _source(cell):
    source = cell.get("source", "")
    return source if isinstance(source, str) else "".join(part for part in source if isinstance(part, str))


def _number(notebook):
    """The problem that the notebook's metadata names, if it names one."""
    try:
        number = notebook["metadata"]["trajlib"]["number"]
    except (KeyError, TypeError):
        return None
    return number if isinstance(number, str) and re.fullmatch(r"[0-9]{1,3}\.[0-9]{1,3}", number) else None


def _by_name(stem):
    """A notebook that lost its metadata is known by its name: 1.15, ch1-p15, 1_15."""
    match = re.fullmatch(r"(?:ch)?([0-9]{1,3})[._-]p?0*([0-9]{1,3})(?:[^0-9].*)?", stem, re.DOTALL)
    return f"{match[1]}.{match[2]}" if match else None
