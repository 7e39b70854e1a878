"""Put a download from Moodle or Canvas into folders STUDENT/HOMEWORK, as `workbook grade` reads
them.

Moodle names a folder for each student, or without folders begins each file, `Ann
Able_12345_assignsubmission_file`. Canvas begins each file with `ableann_12345_67890_`, or
`ableann_LATE_12345_67890_`, where 12345 is the student. Every file is copied, not only notebooks,
since it is somebody's work; what is there already is never written over.
"""

import csv
import io
import os
import re
import stat
import time
import zipfile
from pathlib import Path

from workbook.grading import assignment as assignments
from workbook.grading.assignment import BadInput
from workbook.grading.sanitising import printable_name
from workbook.grading.submitted_file import LARGEST

#: Bytes; a file beside another of its name gets a number too.
MOST_NAME = 240
MOODLE = re.compile(
    r"(?P<name>[^/]+)_(?P<number>\d+)_assignsubmission_file(?:_(?P<file>[^/]*))?", re.DOTALL
)
#: Of an entry in an archive.
NAMES_ARE_UTF_8 = 0x800
#: What a student typed into Moodle's editor, which it hands out as a page of its own.
TYPED = re.compile(r"[^/]+_\d+_assignsubmission_onlinetext.*", re.DOTALL)
CANVAS = re.compile(r"[^_/]+_(?:LATE_)?(?P<number>\d+)_\d+_(?P<file>[^/]+)", re.DOTALL)


def collect(download, homework, into, worksheet=None):
    """Copy the files of `download`, a folder or .zip, to `into`/STUDENT/`homework`; returns
    ({student: files}, [(path, why not)]).

    A student of Canvas is named by the number that Canvas's gradebook has as "ID"; one of Moodle
    `Ann Able_12345`, or, with the grading `worksheet` of the same assignment (a file), by the
    address that stands there. Raises `BadInput`.
    """
    if not assignments.can_be_name(homework):
        raise BadInput(
            f"{homework!r} cannot be the name of a homework: take letters, digits, - and _"
        )
    addresses = _addresses(worksheet) if worksheet is not None else {}
    collected, aside = {}, []
    for path, size, when, read in _files(Path(download)):
        found = _whose(path, addresses)
        if found is None:
            why = (
                "this is text typed in at Moodle, not a file: nobody grades it but you"
                if any(TYPED.fullmatch(part) for part in path.split("/"))
                else "its name is not one that Moodle or Canvas gives"
            )
            aside.append((printable_name(path), why))
        elif len(os.fsencode(found[1])) > MOST_NAME or len(os.fsencode(found[0])) > MOST_NAME:
            aside.append((printable_name(path), "its name is too long"))
        elif size > LARGEST:
            why = f"it has {size / 2**20:.0f} MB; files up to {LARGEST // 2**20} MB are read"
            aside.append((printable_name(path), why))
        else:
            student, name = found
            _put(Path(into) / student / homework, name, read(), when)
            collected.setdefault(student, []).append(name)
    if not collected:
        raise BadInput(
            f"{download} holds no file that is named as Moodle or Canvas names submissions"
        )
    return collected, aside


def _whose(path, addresses):
    """(student, name of the file) by a path in a download, or None."""
    *folders, last = path.split("/")
    if last.startswith("."):  # also what would lead out of the folder
        return None
    for _k, folder in enumerate(folders):
        if match := MOODLE.fullmatch(folder):
            return _of_moodle(match, addresses), last
    if match := MOODLE.fullmatch(last):
        name = (match["file"] or ".").removeprefix("_")
        return (_of_moodle(match, addresses), name) if not name.startswith(".") else None
    match = CANVAS.fullmatch(last)
    return (match["number"], match["file"]) if match and not match["file"].startswith(".") else None


def _of_moodle(match, addresses):
    return addresses.get(match["number"], f"{match['name']}_{match['number']}")


def _addresses(worksheet):
    """{number of the participant: address} from Moodle's grading worksheet."""
    try:
        rows = list(
            csv.DictReader(
                io.StringIO(Path(worksheet).read_bytes().decode("utf-8-sig"), newline="")
            )
        )
        found = {row["Identifier"].rpartition(" ")[2]: row["Email address"].strip() for row in rows}
    except OSError as error:
        raise BadInput(f"{worksheet}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error, KeyError, AttributeError):
        raise BadInput(
            f"{worksheet} is not a grading worksheet of Moodle: CSV in UTF-8 with the columns "
            "Identifier and Email address"
        ) from None
    return {
        number: address
        for number, address in found.items()
        if re.fullmatch(r"[^/\s]+@[^/\s]+", address)
    }


def _files(download):
    """(path with slashes, bytes, time, function that reads it) of every regular file in a folder or
    archive."""
    if download.is_dir():
        for path in sorted(download.rglob("*")):
            about = path.lstat()
            if stat.S_ISREG(about.st_mode):
                yield (
                    path.relative_to(download).as_posix(),
                    about.st_size,
                    about.st_mtime,
                    path.read_bytes,
                )
        return
    try:
        with zipfile.ZipFile(download) as archive:
            for entry in archive.infolist():
                name = _name(entry)
                if not entry.is_dir() and not name.startswith("__MACOSX/"):
                    when = time.mktime((*entry.date_time, 0, 0, -1))
                    yield name, entry.file_size, when, lambda entry=entry: archive.read(entry)
    except OSError as error:
        raise BadInput(f"{download}: {error.strerror or error}") from None
    except (
        zipfile.BadZipFile,
        RuntimeError,
        NotImplementedError,
        ValueError,
        OverflowError,
    ) as error:
        raise BadInput(
            f"{download} is neither a folder nor a .zip that can be read: {error}"
        ) from None


def _name(entry):
    """An entry's name: a Mac and Linux write it in UTF-8 without saying so, and `zipfile` takes it
    for that of DOS."""
    try:
        return (
            entry.filename
            if entry.flag_bits & NAMES_ARE_UTF_8
            else entry.filename.encode("cp437").decode()
        )
    except UnicodeError:
        return entry.filename


def _put(folder, name, content, when):
    """Write a file unless the same one is there; beside another one of its name it gets a
    number."""
    stem, suffix = os.path.splitext(name)
    place, number = folder / name, 1
    try:
        while place.exists() and place.read_bytes() != content:
            number += 1
            place = folder / f"{stem} ({number}){suffix}"
        folder.mkdir(parents=True, exist_ok=True)
        if not place.exists():
            place.write_bytes(content)
        os.utime(place, (when, when))
    except OSError as error:
        raise BadInput(f"{printable_name(place)} cannot be written: {error.strerror}") from None
