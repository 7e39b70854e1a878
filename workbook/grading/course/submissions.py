"""Find what was submitted.

Notebooks are submitted/<student>/<assignment>/<notebook>.ipynb, as in nbgrader. Symbolic links are
reported and not followed. A file that cannot be read as a notebook is still a submission, with the
reason why it earns nothing.
"""

import hashlib
import os
import re
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

from workbook.grading.course import ledger, objections
from workbook.grading.course.assignment import RESERVED_NAMES
from workbook.grading.course.ledger import KNOWN, UNKNOWN
from workbook.grading.course.policy import Budget
from workbook.grading.sandbox import submitted_file
from workbook.grading.sandbox.sanitising import normalise_name, sanitise_name
from workbook.numbering import number_of_name

#: Folders that operating systems make, besides hidden ones.
SYSTEM_FOLDERS = {"__MACOSX", "@eaDir", "System Volume Information", "$RECYCLE.BIN", "lost+found"}
#: Later times of files, as archives may have them, become this one: in 9999, the last year of
#: `datetime`.
MAX_TIME = 253370764800.0
#: The file in which nbgrader notes the time of a submission, such as 2026-09-30 12:00:00.000000 UTC.
TIMESTAMP = "timestamp.txt"
#: Names of other files that are listed one by one.
MAX_LISTED = 5


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
        When it was handed in, in seconds since 1970; where that is not known, what orders it.
    problem : str or None
        The problem that it names.
    cells : tuple of str
        The sources of its code cells; empty if it cannot be read.
    trouble : str
        Why it cannot be read; else empty.
    timing : str
        What is known of the time: one of those in `ledger`.
    names_in_text : tuple of str
        What its cells of text assign, which is not run.
    rank : tuple
        Among what the student handed in at the same time, by the system that took it: the first
        time of the file, then what orders them. Empty where no system says so.
    marks : tuple of str
        Its course and the fingerprint of its statement, "" where it does not say.
    """

    student: str
    assignment: str
    path: str
    content: str
    submitted: float
    problem: str | None
    cells: tuple
    trouble: str = ""
    timing: str = KNOWN
    names_in_text: tuple = ()
    rank: tuple = ()
    marks: tuple = ("", "")


@dataclass(frozen=True)
class LeftAside:
    """A file or folder that is not graded.

    Parameters
    ----------
    path : str
        Its path, safe to print.
    reason : str
        Why it is not graded.
    student, assignment : str
        Whose work it may be, and for what, as far as known; else empty.
    problem : str
        That of a notebook for a problem of the workbook that the homework does not ask for.
    by_hand : bool
        Whether points by hand settle it: it is no notebook, or cannot be read.
    is_extra : bool
        Whether it lies beside a notebook of the homework, so that nothing waits for it.
    """

    path: str
    reason: str
    student: str = ""
    assignment: str = ""
    problem: str = ""
    by_hand: bool = False
    is_extra: bool = False


def students(root):
    """Return the names of all students with a folder, even an empty one, or in the ledger."""
    folders = [
        normalise_name(entry.name)
        for entry in _listed(Path(root))
        if entry.is_dir() and not entry.is_symlink() and not _is_system_file(entry)
    ]
    return list(dict.fromkeys(folders + [entry.student for entry in ledger.read(root)]))


def find(root, budget_of=lambda assignment: Budget()):
    """Yield each `Submission` and `LeftAside` below `root`, by student, assignment and file.

    A notebook that the ledger has at several times is yielded once for each. What exceeds a
    student's `Budget` for a homework, which `budget_of` returns, is left aside.
    """
    entries, times = ledger.read(root), {}
    for entry in entries:
        if entry.file:
            key = (entry.student, entry.assignment, entry.file)
            times.setdefault(key, []).append((entry.when, entry.timing, entry.rank))
    yield from _left_aside(entries)
    with submitted_file.Reader() as reader:
        for student in _folders(Path(root)):
            if isinstance(student, LeftAside):
                yield student
                continue
            try:
                name = normalise_name(student.name)
                yield from _of_student(student, name, times, reader, budget_of)
            except (FileNotFoundError, NotADirectoryError):
                yield _gone(student, normalise_name(student.name))
    for student, assignment, file in times:  # what no folder has
        yield LeftAside(
            f"{student}/{assignment}/{file}",
            f"{ledger.NAME} has it, but it is not there: move it back, or correct the ledger",
            student,
            assignment,
            by_hand=True,
        )


def _left_aside(entries):
    """Yield a `LeftAside` for each line of the ledger on what was not copied."""
    with_notebook = {
        (entry.student, entry.assignment)
        for entry in entries
        if entry.file.lower().endswith(".ipynb")
    }
    for entry in entries:
        if entry.trouble:
            may_be_notebook = entry.source.lower().rstrip("/").endswith((".ipynb", ".zip"))
            owner = entry.student, entry.assignment
            yield LeftAside(
                f"{entry.archive}/{entry.source}",
                entry.trouble,
                *owner,
                by_hand=True,
                is_extra=owner in with_notebook and not may_be_notebook,
            )


def _of_student(folder, student, times, reader, budget_of):
    for assignment in _folders(folder, student):
        if isinstance(assignment, LeftAside):
            yield assignment
        else:
            name = normalise_name(assignment.name)
            yield from _of_homework(assignment, student, name, times, reader, budget_of(name))


def _of_homework(folder, student, assignment, times, reader, budget):
    if assignment in RESERVED_NAMES or len(assignment.encode()) > 255:
        reason = (
            "the folder of results needs this name for itself"
            if assignment in RESERVED_NAMES
            else "this name is too long for a folder of results"
        )
        yield LeftAside(sanitise_name(folder), f"{reason}: no homework can be called so", student)
        return
    times_by_path = {
        path: times.pop((student, assignment, sanitise_name(path.name)), None)
        for path in _listed(folder)
    }
    notebooks = [path for path in times_by_path if _is_notebook(path)]
    stamped = not times_by_path.get(folder / TIMESTAMP)  # else a student handed that in
    for path, over in _over_budget(notebooks, times_by_path, budget):
        if over:
            yield LeftAside(sanitise_name(path), over, student, assignment, by_hand=True)
            continue
        notebook = _read(student, assignment, path, reader)
        if isinstance(notebook, LeftAside):
            yield notebook
            continue
        times_of_file = times_by_path[path] or [_time(folder, path, notebook.submitted, stamped)]
        first = min(when for when, _, _ in times_of_file)
        for when, timing, rank in times_of_file:
            rank = (first, *rank) if rank else ()
            yield replace(notebook, submitted=when, timing=timing, rank=rank)
    below = [
        path
        for inner in _folders(folder, student, assignment)
        if isinstance(inner, Path) and inner not in notebooks
        for path in _listed(inner)
        if _is_notebook(path)
    ]
    yield from (_misplaced(path, student, assignment) for path in below)
    other_files = [
        sanitise_name(path.name)
        for path in times_by_path
        if not _is_system_file(path)
        and not objections.is_objection(path)
        and path not in notebooks
        and not (stamped and path.name == TIMESTAMP)
        and not path.is_symlink()
        and path.is_file()
    ]
    if len(other_files) > MAX_LISTED:
        other_files[MAX_LISTED:] = [f"and {len(other_files) - MAX_LISTED} more"]
    if not notebooks and not below:
        # Other files in it are a student's work, though no notebook.
        owner = (
            (student, assignment)
            if any(
                not (_is_system_file(path) or objections.is_objection(path))
                for path in times_by_path
            )
            else ()
        )
        reason = (
            "there is no notebook in this folder"
            + ", only " * bool(other_files)
            + ", ".join(other_files)
        )
        yield LeftAside(sanitise_name(folder), reason, *owner, by_hand=True)
    elif other_files:
        reason = f"beside the notebooks there is also {', '.join(other_files)}: only a lecturer can grade it"
        yield LeftAside(
            sanitise_name(folder), reason, student, assignment, by_hand=True, is_extra=True
        )


def _over_budget(notebooks, times_by_path, budget):
    """Return (path, why it exceeds the budget, else "") of each notebook; the earliest fit first."""
    sizes, over, bytes_left = {}, {}, budget.megabytes * 2**20
    for path in notebooks:
        with suppress(OSError):  # it is gone, or cannot be read: reading it says so
            status = path.lstat()
            known = times_by_path[path]
            sizes[path] = (min(known)[0] if known else status.st_mtime, status.st_size)
    for number, path in enumerate(sorted(sizes, key=sizes.get)):
        size = sizes[path][1]
        if number >= budget.notebooks:
            over[path] = (
                f"the student has more than {budget.notebooks} notebooks here ([budget] in "
                "assignment.toml)"
            )
        elif size > bytes_left and size <= submitted_file.MAX_FILE:
            over[path] = (
                f"the student's notebooks here have more than {budget.megabytes:g} MB together "
                "([budget] in assignment.toml)"
            )
        elif size <= submitted_file.MAX_FILE:  # a larger one is not read
            bytes_left -= size
    return [(path, over.get(path, "")) for path in notebooks]


def _time(folder, path, of_file, stamped):
    """Return (time, what is known of it, rank) by nbgrader's note, or by the file if there is none."""
    note = folder / TIMESTAMP
    if not stamped or note.is_symlink() or not note.is_file():
        return of_file, KNOWN, ()
    try:
        with open(note, encoding="utf-8") as file:
            text = re.sub(r"\s*UTC\Z", "+00:00", file.read(100).strip())
        when = datetime.fromisoformat(text)
        when = when if when.tzinfo else when.replace(tzinfo=UTC)
        return min(max(when.timestamp(), 0.0), MAX_TIME), KNOWN, (path.name,)
    except (OSError, ValueError, OverflowError):
        return of_file, UNKNOWN, ()


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


def _read(student, assignment, path, reader):
    content, trouble, read = b"", "", submitted_file.Notebook(None, (), ())
    try:
        submitted = min(max(path.lstat().st_mtime, 0.0), MAX_TIME)
        content = submitted_file.content(path)
        read = reader.notebook(content)
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
        read.number or number_of_name(path.stem),
        read.cells,
        trouble,
        names_in_text=read.names_in_text,
        marks=read.marks,
    )
