"""Find what was submitted.

Notebooks are submitted/<student>/<assignment>/<notebook>.ipynb, as in nbgrader. Symbolic links are
reported and not followed. A file that cannot be read as a notebook is still a submission, with the
reason why it earns nothing.
"""

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path

from workbook.grading import submitted_file
from workbook.grading.assignment import RESERVED_NAMES
from workbook.grading.sanitising import normalise_name, sanitise_name

#: Folders that operating systems make, besides hidden ones.
SYSTEM_FOLDERS = {"__MACOSX", "@eaDir", "System Volume Information", "$RECYCLE.BIN", "lost+found"}
#: Later times of files, as archives may have them, become this one: in 9999, the last year of
#: `datetime`.
MAX_TIME = 253370764800.0


@dataclass(frozen=True)
class Submission:
    """One submitted notebook.

    Parameters
    ----------
    student, assignment, path : str
        Its folders and file, safe to print and store (`sanitise_name`).
    content : str
        SHA-256 of the file.
    submitted : float
        The file's time, in seconds since 1970.
    problem : str or None
        The problem that it names.
    cells : tuple of str
        The sources of its code cells; empty if it cannot be read.
    trouble : str
        Why it cannot be read; else empty.
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
class LeftAside:
    """A file or folder that is not graded.

    Parameters
    ----------
    path : str
        Its path, safe to print.
    why : str
        The reason.
    student, assignment : str
        Whose work it may be, and for what, as far as known; else empty.
    problem : str
        That of a notebook for a problem of the workbook that the homework does not ask for.
    """

    path: str
    why: str
    student: str = ""
    assignment: str = ""
    problem: str = ""


def students(root):
    """Return the names of all students with a folder, even an empty one."""
    return list(
        dict.fromkeys(
            normalise_name(entry.name)
            for entry in _listed(Path(root))
            if entry.is_dir() and not entry.is_symlink() and not _is_system_file(entry)
        )
    )


def find(root):
    """Yield each `Submission` and `LeftAside` below `root`, by student, assignment and file."""
    for student in _folders(Path(root)):
        if isinstance(student, LeftAside):
            yield student
            continue
        try:
            yield from _of_student(student, normalise_name(student.name))
        except (FileNotFoundError, NotADirectoryError):
            yield _gone(student, normalise_name(student.name))


def _of_student(folder, student):
    for assignment in _folders(folder, student):
        if isinstance(assignment, LeftAside):
            yield assignment
        else:
            yield from _of_homework(assignment, student, normalise_name(assignment.name))


def _of_homework(folder, student, assignment):
    if assignment in RESERVED_NAMES or len(assignment.encode()) > 255:
        why = (
            "the folder of results needs this name for itself"
            if assignment in RESERVED_NAMES
            else "this name is too long for a folder of results"
        )
        yield LeftAside(sanitise_name(folder), f"{why}: no homework can be called so", student)
        return
    notebooks = [path for path in _listed(folder) if _is_notebook(path)]
    yield from (_read(student, assignment, path) for path in notebooks)
    below = [
        path
        for inner in _folders(folder, student, assignment)
        if isinstance(inner, Path) and inner not in notebooks
        for path in _listed(inner)
        if _is_notebook(path)
    ]
    yield from (_misplaced(path, student, assignment) for path in below)
    if not notebooks and not below:
        # Other files in it are a student's work, though no notebook.
        owner = (
            (student, assignment)
            if any(not _is_system_file(path) for path in _listed(folder))
            else ()
        )
        yield LeftAside(sanitise_name(folder), "there is no notebook in this folder", *owner)


def _folders(path, student="", assignment=""):
    """Yield the folders in a folder, and a `LeftAside` for links and misplaced notebooks."""
    for entry in _listed(path):
        if _is_system_file(entry):
            continue
        # Each folder of a student is a homework, of which this may be the only trace.
        owner = (student, assignment or normalise_name(entry.name)) if student else ()
        if entry.is_symlink():
            yield LeftAside(sanitise_name(entry), "this is a symbolic link", *owner)
        elif entry.is_dir():
            if os.access(entry, os.R_OK | os.X_OK):
                yield entry
            else:
                yield LeftAside(
                    sanitise_name(entry),
                    "this folder cannot be opened",
                    *(owner or (normalise_name(entry.name),)),
                )
        elif not os.path.lexists(entry):
            yield _gone(entry, *(owner or (normalise_name(entry.name),)))
        elif _is_notebook(entry):
            yield _misplaced(entry, student, assignment)


def _listed(path):
    return sorted(path.iterdir(), key=lambda entry: os.fsencode(entry.name))


def _is_system_file(path):
    return path.name.startswith(".") or path.name in SYSTEM_FOLDERS


def _is_notebook(path):
    """Return whether a name is that of a notebook; macOS puts ._p15.ipynb beside p15.ipynb."""
    return path.suffix.lower() == ".ipynb" and not path.name.startswith("._")


def _gone(path, *owner):
    return LeftAside(
        sanitise_name(path), "it was renamed or removed while it was read: grade again", *owner
    )


def _misplaced(path, student="", assignment=""):
    return LeftAside(
        sanitise_name(path),
        "it does not lie in a folder STUDENT/HOMEWORK, where notebooks are read",
        student,
        assignment,
    )


def _read(student, assignment, path):
    content, cells, trouble, number = b"", (), "", None
    try:
        submitted = min(max(path.lstat().st_mtime, 0.0), MAX_TIME)
        content = submitted_file.content(path)
        number, cells = submitted_file.notebook(content)
    except submitted_file.UnreadableFileError as error:
        trouble = str(error)
    except OSError as error:  # missing rights or a bad disk: not an attempt of the student's
        return LeftAside(
            sanitise_name(path),
            f"this file cannot be read ({error.strerror})",
            student,
            assignment,
        )
    fingerprint = hashlib.sha256(content or trouble.encode()).hexdigest()
    return Submission(
        student,
        assignment,
        sanitise_name(path),
        fingerprint,
        submitted,
        number or submitted_file.number_of_name(path.stem),
        cells,
        trouble,
    )
