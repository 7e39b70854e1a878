"""Find what was submitted: submitted/<student>/<assignment>/<notebook>.ipynb, as nbgrader lays it
out.

Nothing is followed out of the folder: symbolic links are named and left alone. What cannot be read
as a notebook is a submission all the same, with a sentence that says why it earns nothing.
"""

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path

from workbook.grading import submitted_file
from workbook.grading.assignment import TAKEN
from workbook.grading.sanitising import person_or_homework, printable_name

#: Folders that systems leave beside people's, besides hidden ones.
OF_SYSTEMS = {"__MACOSX", "@eaDir", "System Volume Information", "$RECYCLE.BIN", "lost+found"}
#: No file is younger: 9999, the last year of calendars. An archive may say otherwise.
LATEST = 253370764800.0


@dataclass(frozen=True)
class Submission:
    """One submitted notebook: `cells` are the sources of its code cells, none, with the `trouble`
    in words, when it cannot be read.

    `student`, `assignment` and `path` are fit to be printed and stored (`printable_name`);
    `submitted` is the file's time.
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
    """Something below the folder that does not count, and why; `student` and `assignment` if it is
    somebody's work, as far as known.

    `problem` is that of a notebook for a problem of the workbook that the homework does not ask
    for.
    """

    path: str
    why: str
    student: str = ""
    assignment: str = ""
    problem: str = ""


def students(root):
    """The names of all who have a folder, also of who handed nothing in."""
    return list(
        dict.fromkeys(
            person_or_homework(entry.name)
            for entry in _listed(Path(root))
            if entry.is_dir() and not entry.is_symlink() and not _is_nobodys(entry)
        )
    )


def find(root):
    """All submissions below `root`, and what was left aside, by student, assignment and file."""
    for student in _folders(Path(root)):
        if isinstance(student, Aside):
            yield student
            continue
        try:
            yield from _of_student(student, person_or_homework(student.name))
        except (FileNotFoundError, NotADirectoryError):
            yield _gone(student, person_or_homework(student.name))


def _of_student(folder, who):
    for assignment in _folders(folder, who):
        if isinstance(assignment, Aside):
            yield assignment
        else:
            yield from _of_homework(assignment, who, person_or_homework(assignment.name))


def _of_homework(folder, student, assignment):
    if assignment in TAKEN or len(assignment.encode()) > 255:
        why = (
            "the folder of results needs this name for itself"
            if assignment in TAKEN
            else "this name is too long for a folder of results"
        )
        yield Aside(printable_name(folder), f"{why}: no homework can be called so", student)
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
        # Something else in it is somebody's work, though no notebook.
        whose = (
            (student, assignment) if any(not _is_nobodys(path) for path in _listed(folder)) else ()
        )
        yield Aside(printable_name(folder), "there is no notebook in this folder", *whose)


def _folders(path, student="", assignment=""):
    """Folders in a folder, and what is wrong with others; notebooks beside them are too high."""
    for entry in _listed(path):
        if _is_nobodys(entry):
            continue
        # Of a student's folders each is a homework, of which this may be the only trace.
        whose = (student, assignment or person_or_homework(entry.name)) if student else ()
        if entry.is_symlink():
            yield Aside(printable_name(entry), "this is a symbolic link", *whose)
        elif entry.is_dir():
            if os.access(entry, os.R_OK | os.X_OK):
                yield entry
            else:
                yield Aside(
                    printable_name(entry),
                    "this folder cannot be opened",
                    *(whose or (person_or_homework(entry.name),)),
                )
        elif not os.path.lexists(entry):
            yield _gone(entry, *(whose or (person_or_homework(entry.name),)))
        elif _is_notebook(entry):
            yield _misplaced(entry, student, assignment)


def _listed(path):
    return sorted(path.iterdir(), key=lambda entry: os.fsencode(entry.name))


def _is_nobodys(path):
    return path.name.startswith(".") or path.name in OF_SYSTEMS


def _is_notebook(path):
    """By its name; ._p15.ipynb is what a Mac puts beside p15.ipynb, and nobody's work."""
    return path.suffix.lower() == ".ipynb" and not path.name.startswith("._")


def _gone(path, *whose):
    return Aside(
        printable_name(path), "it was renamed or removed while it was read: grade again", *whose
    )


def _misplaced(path, student="", assignment=""):
    return Aside(
        printable_name(path),
        "it does not lie in a folder STUDENT/HOMEWORK, where notebooks are read",
        student,
        assignment,
    )


def _read(student, assignment, path):
    content, cells, trouble, number = b"", (), "", None
    try:
        submitted = min(max(path.lstat().st_mtime, 0.0), LATEST)
        content = submitted_file.content(path)
        number, cells = submitted_file.notebook(content)
    except submitted_file.Unreadable as error:
        trouble = str(error)
    except OSError as error:  # our rights or our disk: no attempt of the student's
        return Aside(
            printable_name(path),
            f"this file cannot be read ({error.strerror})",
            student,
            assignment,
        )
    fingerprint = hashlib.sha256(content or trouble.encode()).hexdigest()
    return Submission(
        student,
        assignment,
        printable_name(path),
        fingerprint,
        submitted,
        number or submitted_file.number_of_name(path.stem),
        cells,
        trouble,
    )
