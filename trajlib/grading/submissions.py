"""Find what was submitted: submitted/<student>/<assignment>/<notebook>.ipynb, as nbgrader lays it out.

Nothing is followed out of the folder: symbolic links are named and left alone. What cannot be read as a notebook is a
submission all the same, with a sentence that says why it earns nothing.
"""

import hashlib
import json
import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path

#: A notebook of text and code is far smaller; outputs are not read, but their bytes count.
LARGEST = 20 * 2**20


@dataclass(frozen=True)
class Submission:
    """One submitted notebook: `cells` are (role, source) of its code cells, none, with the `trouble` in words, when it cannot be read."""

    student: str
    assignment: str
    path: Path
    content: str
    submitted: float
    problem: str | None
    cells: tuple
    trouble: str = ""


def find(root, assignments=None):
    """All submissions below `root`, sorted by student, assignment and file; of the named assignments, or of all."""
    for student in _folders(Path(root)):
        for assignment in _folders(student):
            if assignments is None or assignment.name in assignments:
                for path in sorted(assignment.iterdir()):
                    if path.suffix == ".ipynb":
                        yield _read(student.name, assignment.name, path)


def _folders(path):
    return sorted(entry for entry in path.iterdir() if entry.is_dir() and not entry.is_symlink() and not entry.name.startswith("."))


def _read(student, assignment, path):
    def unreadable(why, content=b"", submitted=0.0):
        return Submission(student, assignment, path, hashlib.sha256(content or why.encode()).hexdigest(), submitted, _by_name(path.stem), (), why)

    try:
        # O_NOFOLLOW and O_NONBLOCK: neither a link to somebody else's file nor a pipe that never ends.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return unreadable("the file is a symbolic link or cannot be opened")
    with os.fdopen(descriptor, "rb") as file:
        about = os.fstat(file.fileno())
        if not stat.S_ISREG(about.st_mode):
            return unreadable("this is not a regular file")
        if about.st_size > LARGEST:
            return unreadable(f"the file has {about.st_size / 2**20:.0f} MB; notebooks up to {LARGEST // 2**20} MB are read", b"", about.st_mtime)
        content = file.read(LARGEST + 1)
    try:
        notebook = json.loads(content.decode("utf-8"))
        cells = tuple(_cell(cell) for cell in notebook["cells"] if cell.get("cell_type") == "code")
    except (UnicodeDecodeError, ValueError, RecursionError):
        return unreadable("the file is not a notebook (no JSON in UTF-8)", content, about.st_mtime)
    except (KeyError, TypeError, AttributeError):
        return unreadable("the file is JSON, but not a notebook", content, about.st_mtime)
    return Submission(student, assignment, path, hashlib.sha256(content).hexdigest(), about.st_mtime,
                      _number(notebook) or _by_name(path.stem), cells)


def _cell(cell):
    metadata = cell.get("metadata")
    tags = metadata.get("tags") if isinstance(metadata, dict) else None
    role = next((tag for tag in tags if tag in ("data", "answer", "check")), "") if isinstance(tags, list) else ""
    source = cell.get("source", "")
    return role, source if isinstance(source, str) else "".join(part for part in source if isinstance(part, str))


def _number(notebook):
    """The problem that the notebook's metadata names, if it names one."""
    try:
        number = notebook["metadata"]["trajlib"]["number"]
    except (KeyError, TypeError):
        return None
    return number if isinstance(number, str) and re.fullmatch(r"\d{1,3}\.\d{1,3}", number) else None


def _by_name(stem):
    """A notebook that lost its metadata is known by its name: 1.15, ch1-p15, 1_15."""
    match = re.fullmatch(r"(?:ch)?(\d{1,3})[._-]p?0*(\d{1,3})(?:\D.*)?", stem)
    return f"{match[1]}.{match[2]}" if match else None
