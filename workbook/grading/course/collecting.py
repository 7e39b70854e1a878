"""Collecting: put a download from Moodle or Canvas into folders STUDENT/HOMEWORK.

Moodle names a folder for each student, or without folders begins each file,
`Ann Able_12345_assignsubmission_file`. Canvas begins each file with `ableann_12345_67890_`, or
`ableann_LATE_12345_67890_`, or `anon_Ab3de_67890_` where it hides names; 12345 is the student. What
stands after that is the student's own and decides nothing. Every file is copied, not only
notebooks, since it is a student's work, and the notebooks of a .zip archive beside it; files that
exist are never overwritten. Who handed in what, and when, is noted in the ledger. All of it is one
transaction.
"""

import os
import re
import time
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path
from unicodedata import normalize

from workbook.grading.course import archives, ledger, worksheet
from workbook.grading.course import assignment as assignments
from workbook.grading.course.assignment import InputError
from workbook.grading.course.ledger import UNKNOWN, Entry, Ledger
from workbook.grading.course.transaction import transaction
from workbook.grading.sandbox.sanitising import portable_name, sanitise, sanitise_name
from workbook.grading.sandbox.submitted_file import MAX_FILE, UnreadableFileError

#: Bytes of a name; the number that a second file of the same name gets still fits.
MAX_NAME = 240
#: Characters of a name in a download, with what the system writes before it.
MAX_PART = 1000
#: Bytes that one student's files in a download have in all, those in archives too.
MAX_STUDENT = 400 * 2**20
#: Moodle replaces each _ in a name, so its own marker is the first one.
MOODLE = re.compile(
    r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(?P<plugin>[a-z0-9]+)(?P<rest>.*)", re.DOTALL
)
#: Each place where the numbers of a student and of a file may stand in a name that Canvas gives.
CANVAS = re.compile(r"(?=_(?P<number>\d+)_\d+_(?P<file>.+))", re.DOTALL)
ANONYMOUS = re.compile(
    r"(?P<late>LATE_)?(?P<number>anon_[A-Za-z0-9]{5})_\d+_(?P<file>.+)", re.DOTALL
)
CANVAS_TEXT = re.compile(
    r"(?P<name>.*?)_?(?P<late>LATE_)?(?P<number>\d+|anon_[A-Za-z0-9]{5})_(?:text|link)\.html",
    re.DOTALL,
)
NO_NAME = "its name is not one that Moodle or Canvas gives"
TYPED_IN = "this is text typed in at Moodle or Canvas, not a file: only a lecturer can grade it"
TOO_LONG = "its name is too long"
TOO_DEEP = "it lies deeper than the names that Moodle or Canvas gives: who packed it named it"


@dataclass
class Collected:
    """What became of a download.

    Parameters
    ----------
    files : dict
        The files by student.
    aside : list of tuple
        (path, why it was not copied).
    absent : list of str
        Participants in the worksheet who handed in nothing.
    untimed : int
        Of how many files no download so far says when they were handed in.
    """

    files: dict = field(default_factory=dict)
    aside: list = field(default_factory=list)
    absent: list = field(default_factory=list)
    untimed: int = 0

    def count(self, entry):
        """Count an entry of the ledger."""
        if entry.trouble:
            self.aside.append((entry.source, entry.trouble))
            return
        self.files.setdefault(entry.student, []).append(entry.file)


@dataclass(frozen=True)
class _Owner:
    """What the name that the system gave to a file says.

    `level` is the number of folders above that name, and `trouble` why the file is not copied.
    """

    student: str
    number: str
    name: str
    file: str
    late: bool | None = None
    trouble: str = ""
    level: int = 0


def collect(download, homework, into, grading_worksheet=None, roster=None, zone=None):
    """Copy the files of a download to `into`/STUDENT/`homework`, and note them in the ledger.

    A student of Canvas is named by the number that Canvas's gradebook has as "ID"; one of Moodle
    `Ann Able_12345`, or by the address in the grading worksheet.

    Parameters
    ----------
    download : path
        A folder or .zip.
    homework : str
        The homework's name.
    into : path
        The folder of all submissions.
    grading_worksheet : path, optional
        Moodle's grading worksheet of the same assignment.
    roster : Roster, optional
        The class, by which a file name of Canvas is understood that can be read in two ways.
    zone : datetime.tzinfo, optional
        The time zone of the times in the worksheet; by default this computer's.

    Returns
    -------
    Collected
        What was copied and what was not.

    Raises
    ------
    InputError
        If a file cannot be read or written, or nothing is named as a submission.
    """
    if not assignments.can_be_name(homework):
        raise InputError(
            f"{homework!r} cannot be the name of a homework: take letters, digits, - and _"
        )
    homework = normalize("NFC", homework)
    participants = worksheet.read(grading_worksheet, zone) if grading_worksheet is not None else {}
    people, result = _people(roster), Collected()
    with archives.opened(download) as files:
        owned_files, result.aside = _by_owner(files, people)
        if not owned_files:
            raise InputError(
                f"{download} holds no file that is named as Moodle or Canvas names submissions"
            )
        numbers = {owner.number for _, owner in owned_files}
        if participants and numbers.isdisjoint(participants):
            raise InputError(
                f"{grading_worksheet} is of another assignment: it has none of the participants in "
                f"{download}"
            )
        with transaction(into, ledger.NAME) as current:
            entries = Ledger(into)
            earlier = [entry for entry in entries.entries(homework) if entry.number]
            refused = _with_two_names(owned_files, participants, earlier)
            students = _students(owned_files, participants, earlier)
            # Later than all before it, for its time tells what was collected, and handed in, at once.
            now = max([time.time(), *(entry.collected + 1 for entry in earlier)])
            sizes = Counter()  # by student
            blank = Entry(homework, "", archive=sanitise_name(Path(download).name), collected=now)
            for file, owner in owned_files:
                if owner.number in refused:
                    result.aside.append((sanitise_name(file.path), refused[owner.number]))
                    continue
                entry = replace(
                    blank,
                    student=students[owner.number],
                    number=owner.number,
                    name=owner.name,
                    late=owner.late,
                    source=sanitise_name(file.path),
                )
                if owner.number in participants:
                    entry = replace(entry, submitted=participants[owner.number].submitted)
                for noted in _copied(current, file, owner, entry, sizes):
                    entries.add(noted)
                    result.count(noted)
            for number, participant in participants.items():
                if number not in numbers:
                    student = students[number]
                    entries.add(
                        replace(blank, student=student, number=number, name=participant.name)
                    )
            current.record(entries.text())
    result.absent = sorted(entries.absent(homework))
    timed = {(e.student, e.file) for e in entries.entries(homework) if e.timing != UNKNOWN}
    result.untimed = sum(
        (student, file) not in timed for student, files in result.files.items() for file in files
    )
    return result


def named_files(download, roster=None):
    """Return [(path, the student's number, the name that the student gave)] of a download.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    with archives.opened(download) as files:
        owned_files, _ = _by_owner(files, _people(roster))
    return [(file.path, owner.number, owner.file) for file, owner in owned_files]


# Who: the names that the systems give


def _people(roster):
    """Return {(name as in Canvas, ID)} of a class."""
    pairs = roster.pairs() if roster else ()
    return {(_as_in_canvas(name), identifier) for name, identifier in pairs}


def _by_owner(files, people):
    """Return ([(file, its `_Owner`)], [(path, why it has none)])."""
    owners = [(file, _owner(file.path, people)) for file in files]
    # Names below those of the system are in a folder that a student made, or packed.
    top = min((owner.level for _, owner in owners if isinstance(owner, _Owner)), default=0)
    owned_files = [(file, o) for file, o in owners if isinstance(o, _Owner) and o.level == top]
    aside = [
        (sanitise_name(file.path), o if isinstance(o, str) else TOO_DEEP)
        for file, o in owners
        if isinstance(o, str) or o.level > top
    ]
    return owned_files, aside


def _owner(path, people):
    """Return the `_Owner` of a file by its path in a download, or why there is none."""
    *folders, last = path.split("/")
    if last.startswith("."):  # also ".."
        return NO_NAME
    if max(map(len, [*folders, last])) > MAX_PART:
        return TOO_LONG
    for level, folder in enumerate(folders):
        if match := MOODLE.fullmatch(folder):
            return _at(level, _of_moodle(match, last))
    if match := MOODLE.fullmatch(last):
        return _at(len(folders), _of_moodle(match, match["rest"].removeprefix("_")))
    return _at(len(folders), _of_canvas(last, people))


def _at(level, owner):
    return owner if isinstance(owner, str) else replace(owner, level=level)


def _of_moodle(match, file):
    student = _safe(f"{match['name']}_{match['number']}")
    owner = _Owner(student, match["number"], match["name"], file)
    if match["plugin"] != "file":
        return replace(owner, trouble=TYPED_IN)
    return NO_NAME if file.startswith(".") or not file else owner


def _of_canvas(name, people):
    owners = []
    if match := CANVAS_TEXT.fullmatch(name):
        late = match["late"] is not None
        owners.append(
            _Owner(match["number"], match["number"], match["name"], "text", late, TYPED_IN)
        )
    if match := ANONYMOUS.fullmatch(name):
        late = match["late"] is not None
        owners.append(_Owner(match["number"], match["number"], "", match["file"], late))
    for match in CANVAS.finditer(name):
        before = name[: match.start()]
        late, person = before.endswith("_LATE"), before.removesuffix("_LATE")
        owners.append(_Owner(match["number"], match["number"], person, match["file"], late))
    candidates = [owner for owner in owners if (owner.name, owner.number) in people] or owners
    if len(candidates) > 1:
        return (
            f"its name may be that of the student {' or '.join(o.number for o in candidates)}: collect "
            "with --roster, the gradebook exported from Canvas"
        )
    return candidates[0] if candidates and not candidates[0].file.startswith(".") else NO_NAME


def _as_in_canvas(name):
    """Return a name as Canvas writes it before a file: without marks, in small letters."""
    return re.sub(r"\W", "", re.sub(r"_(\d+)_", r"\1", name)).lower()


def _safe(name):
    """Return a name as that of a folder, which is not hidden and holds nothing unprintable."""
    name = portable_name(normalize("NFC", name).lstrip("."))
    return "".join(c if sanitise(c) == c and c not in "/\\" else "_" for c in name)


def _students(owned_files, participants, earlier):
    """Return {number: student}: as collected earlier, else by address, else by name and number."""
    return (
        {
            number: _safe(f"{participant.name}_{number}")
            for number, participant in participants.items()
        }
        | {owner.number: owner.student for _, owner in owned_files}
        | {
            number: _safe(participant.address)
            for number, participant in participants.items()
            if participant.address
        }
        | {entry.number: entry.student for entry in earlier}
    )


def _with_two_names(owned_files, participants, earlier):
    """Return {number: why it is refused} for numbers that stand with different names.

    A number that the worksheet has is a participant's, however an archive spells the name.
    """
    names, known = {}, {}
    for entry in earlier:
        if entry.source:
            known.setdefault(entry.number, {})[normalize("NFC", entry.name)] = None
    for _, owner in owned_files:
        if owner.number not in participants:
            names.setdefault(owner.number, {})[normalize("NFC", owner.name)] = None
    different = {}
    for number, of_number in names.items():
        if len(of_number) > 1:
            different[number] = list(of_number)
        elif number in known and not known[number].keys() & of_number:
            different[number] = [f"{next(iter(known[number]))} in ledger.csv", *of_number]
    return {
        number: f"the number {number} stands with two names, {' and '.join(two)}: nothing of it was "
        "collected; if both are the same student, collect with --worksheet, which goes by the number"
        for number, two in different.items()
    }


# What: the files


def _copied(current, file, owner, entry, sizes):
    """Copy a file, and the notebooks in it; yield an `Entry` for each.

    `sizes` has the bytes so far by student.
    """
    size = sizes[entry.student] + file.size
    trouble = owner.trouble or _trouble(entry.student, owner.file, file.size, size)
    if not trouble:
        try:
            content = file.read()
        except UnreadableFileError as error:
            trouble = str(error)
    if trouble:
        yield replace(entry, trouble=trouble)
        return
    sizes[entry.student] = size
    folder = Path(entry.student, entry.assignment)
    yield replace(entry, file=sanitise_name(current.put(folder, owner.file, content)))
    if not owner.file.lower().endswith(".zip"):
        return
    try:
        inside = archives.notebooks(content)
    except UnreadableFileError as error:
        yield replace(entry, source=f"{entry.source}/", trouble=str(error))
        return
    for notebook in inside:
        name = notebook.path.rpartition("/")[2]
        yield from _copied(
            current,
            notebook,
            replace(owner, file=name),
            replace(entry, source=f"{entry.source}/{sanitise_name(notebook.path)}"),
            sizes,
        )


def _trouble(student, name, size, size_in_all):
    """Return why a file cannot be copied, or ""."""
    if max(len(os.fsencode(student)), len(os.fsencode(name))) > MAX_NAME:
        return TOO_LONG
    if size > MAX_FILE:
        return f"it has {size / 2**20:.0f} MB; files up to {MAX_FILE // 2**20} MB are read"
    if size_in_all > MAX_STUDENT:
        return (
            f"with it the student's files would have {size_in_all / 2**20:.0f} MB in all, unpacked; "
            f"up to {MAX_STUDENT // 2**20} MB of a student are collected from a download"
        )
    return ""
