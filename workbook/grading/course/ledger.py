"""Ledger of submissions: who handed in which file, and when, by the system that took it.

It is the file `ledger.csv` beside the students' folders. `workbook collect` writes a line for each
file, one for each that was left aside, and one for each participant who handed in nothing. For a
file that has a line, `workbook grade` takes the time from there and from nowhere else: the times
in a download are those of the download, and what students write decides nothing. A lecturer may
correct a line in any spreadsheet.
"""

import re
from dataclasses import astuple, dataclass, fields
from datetime import datetime
from pathlib import Path

from workbook.grading.course.assignment import InputError
from workbook.grading.course.csv_files import BOM, parse, quoted, read_text
from workbook.grading.course.transaction import require_finished

NAME = "ledger.csv"
#: What the system says of the time of a submission: when it was; that it was late, or in time,
#: without the time; nothing.
KNOWN, LATE, IN_TIME, UNKNOWN = "known", "late", "in time", "unknown"
#: A cell that a spreadsheet would run as a formula is written with an apostrophe before it, and so
#: is one that begins with an apostrophe.
FORMULA = re.compile(r"['=@\t\r\n]|[+-](?!\d*\Z)")


@dataclass(frozen=True)
class Entry:
    """A line of the ledger.

    Parameters
    ----------
    assignment, student : str
        The names of the folders.
    number, name : str
        The participant's in the system, if it gives them.
    file : str
        The name of the file there, safe to print; "" if nothing was handed in or it was left aside.
    submitted : float or None
        When it was handed in, in seconds since 1970; None if the system does not say.
    late : bool or None
        Whether the system marked it as late; None if it marks nothing.
    archive, source : str
        The download, and the path in it.
    collected : float
        When it was collected, which orders what has no other time.
    trouble : str
        Why it was left aside.
    """

    assignment: str
    student: str
    number: str = ""
    name: str = ""
    file: str = ""
    submitted: float | None = None
    late: bool | None = None
    archive: str = ""
    source: str = ""
    collected: float = 0.0
    trouble: str = ""

    @property
    def timing(self):
        """What the system says of the time."""
        if self.submitted is not None:
            return KNOWN
        return {True: LATE, False: IN_TIME, None: UNKNOWN}[self.late]

    @property
    def when(self):
        """The time by which attempts are ordered."""
        return self.collected if self.submitted is None else self.submitted

    @property
    def stable_source(self):
        """The path in the download, by which a later download has the same file."""
        # Canvas adds LATE_ to a name, also afterwards, when the due date is moved.
        return self.source.replace("LATE_", "", 1)

    @property
    def rank(self):
        """What orders the files of one hand-in: Canvas's number of the file, else its path.

        A file beside an archive goes before one in it.
        """
        parts = self.source.split("/")
        given = (re.match(rf"(?:.*?_)?{re.escape(self.number)}_(\d+)_", part) for part in parts)
        number = next((int(match[1]) for match in given if match), 0)
        return number, ".zip/" not in self.source.lower(), self.source


def read(root):
    """Return the entries of the ledger in a folder of submissions; raises `InputError`."""
    require_finished(root)
    return _read(Path(root) / NAME)


def _read(path):
    if not path.exists():
        return []
    try:
        _, (header, *rows) = parse(read_text(path))
        return [_entry(dict(zip(header, map(_without_apostrophe, row)))) for row in rows]
    except (KeyError, ValueError, OverflowError) as error:
        raise InputError(
            f"{path} is not as workbook collect wrote it ({error}): correct it, or take it away "
            "and collect again"
        ) from None


class Ledger:
    """The ledger of a folder of submissions, to be added to.

    Parameters
    ----------
    root : path
        The folder.

    Raises
    ------
    InputError
        If there is a ledger that cannot be read.
    """

    def __init__(self, root):
        self._entries = {}
        for entry in _read(Path(root) / NAME):
            self._entries.setdefault((entry.assignment, entry.student), []).append(entry)

    def entries(self, assignment):
        """Return the entries of a homework."""
        return [
            entry
            for (homework, _), entries in self._entries.items()
            if homework == assignment
            for entry in entries
        ]

    def absent(self, assignment):
        """Return the participants in a homework who handed in nothing."""
        return [
            entry.student for entry in self.entries(assignment) if not (entry.file or entry.trouble)
        ]

    def add(self, new):
        """Add an entry; it replaces what said less of the same file.

        The same file at another time is a line of its own: it was handed in again.
        """
        key = (new.assignment, new.student)
        self._entries[key] = _merged(self._entries.get(key, []), new)

    def text(self):
        """Return the text of the file."""
        header = [field.name for field in fields(Entry)]
        entries = [entry for of_student in self._entries.values() for entry in of_student]
        rows = [[_cell(value) for value in astuple(entry)] for entry in entries]
        return BOM + quoted([header, *rows])


def _merged(entries, new):
    if not new.file:
        if not new.source:  # handed in nothing, now
            return entries or [new]
        if any(entry.file and entry.stable_source == new.stable_source for entry in entries):
            return entries
        return [
            *(
                entry
                for entry in entries
                if entry.source and entry.stable_source != new.stable_source
            ),
            new,
        ]
    entries = [
        entry
        for entry in entries
        if entry.file or entry.stable_source not in ("", new.stable_source)
    ]
    duplicates = [
        entry
        for entry in entries
        if (entry.file, entry.stable_source) == (new.file, new.stable_source)
    ]
    if any(
        new.timing == UNKNOWN
        or _times(entry) == _times(new)
        or (entry.timing == KNOWN and new.submitted is None)
        for entry in duplicates
    ):
        return entries
    return [*(entry for entry in entries if entry not in duplicates or entry.timing == KNOWN), new]


def _times(entry):
    return entry.submitted, entry.late


def _entry(line):
    texts = {field.name: line[field.name] for field in fields(Entry)}
    return Entry(
        **texts
        | {
            "submitted": _seconds(texts["submitted"]) if texts["submitted"] else None,
            "late": {"yes": True, "no": False, "": None}[texts["late"]],
            "collected": _seconds(texts["collected"]),
        }
    )


def _seconds(text):
    when = datetime.fromisoformat(text)
    if when.tzinfo is None:
        raise ValueError(f"{text} has no time zone, as 2026-09-30 23:59:00+03:00 has")
    return when.timestamp()


def _cell(value):
    if isinstance(value, float):
        return datetime.fromtimestamp(value).astimezone().isoformat(" ", timespec="seconds")
    text = {None: "", True: "yes", False: "no"}.get(value, value)
    return f"'{text}" if FORMULA.match(text) else text


def _without_apostrophe(cell):
    return cell.removeprefix("'")
