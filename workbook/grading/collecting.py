"""Collecting: put a download from Moodle or Canvas into folders STUDENT/HOMEWORK.

Moodle names a folder for each student, or without folders begins each file,
`Ann Able_12345_assignsubmission_file`. Canvas begins each file with `ableann_12345_67890_`, or
`ableann_LATE_12345_67890_`, where 12345 is the student. Every file is copied, not only notebooks,
since it is a student's work; files that exist are never overwritten.
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
from workbook.grading.assignment import InputError
from workbook.grading.sanitising import sanitise_name
from workbook.grading.submitted_file import MAX_FILE

#: Bytes of a name; the number that a second file of the same name gets still fits.
MAX_NAME = 240
MOODLE = re.compile(
    r"(?P<name>[^/]+)_(?P<number>\d+)_assignsubmission_file(?:_(?P<file>[^/]*))?", re.DOTALL
)
#: Flag of an entry in a .zip archive.
UTF_8_FLAG = 0x800
#: The page for a text that a student typed into Moodle's editor.
ONLINE_TEXT = re.compile(r"[^/]+_\d+_assignsubmission_onlinetext.*", re.DOTALL)
CANVAS = re.compile(r"[^_/]+_(?:LATE_)?(?P<number>\d+)_\d+_(?P<file>[^/]+)", re.DOTALL)


def collect(download, homework, into, worksheet=None):
    """Copy the files of a download to `into`/STUDENT/`homework`.

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
    worksheet : path, optional
        Moodle's grading worksheet of the same assignment.

    Returns
    -------
    tuple
        ({student: files}, [(path, why it was not copied)]).

    Raises
    ------
    InputError
        If a file cannot be read or written, or nothing is named as a submission.
    """
    if not assignments.can_be_name(homework):
        raise InputError(
            f"{homework!r} cannot be the name of a homework: take letters, digits, - and _"
        )
    addresses = _addresses(worksheet) if worksheet is not None else {}
    collected, aside = {}, []
    for path, size, when, read in _files(Path(download)):
        owner = _owner(path, addresses)
        if owner is None:
            why = (
                "this is text typed in at Moodle, not a file: nobody grades it but you"
                if any(ONLINE_TEXT.fullmatch(part) for part in path.split("/"))
                else "its name is not one that Moodle or Canvas gives"
            )
            aside.append((sanitise_name(path), why))
        elif len(os.fsencode(owner[1])) > MAX_NAME or len(os.fsencode(owner[0])) > MAX_NAME:
            aside.append((sanitise_name(path), "its name is too long"))
        elif size > MAX_FILE:
            why = f"it has {size / 2**20:.0f} MB; files up to {MAX_FILE // 2**20} MB are read"
            aside.append((sanitise_name(path), why))
        else:
            student, name = owner
            _put(Path(into) / student / homework, name, read(), when)
            collected.setdefault(student, []).append(name)
    if not collected:
        raise InputError(
            f"{download} holds no file that is named as Moodle or Canvas names submissions"
        )
    return collected, aside


def _owner(path, addresses):
    """Return (student, name of the file) by a path in a download, or None."""
    *folders, last = path.split("/")
    if last.startswith("."):  # also ".."
        return None
    for folder in folders:
        if match := MOODLE.fullmatch(folder):
            return _moodle_student(match, addresses), last
    if match := MOODLE.fullmatch(last):
        name = (match["file"] or ".").removeprefix("_")
        return (_moodle_student(match, addresses), name) if not name.startswith(".") else None
    match = CANVAS.fullmatch(last)
    return (match["number"], match["file"]) if match and not match["file"].startswith(".") else None


def _moodle_student(match, addresses):
    return addresses.get(match["number"], f"{match['name']}_{match['number']}")


def _addresses(worksheet):
    """Return {number of the participant: address} from Moodle's grading worksheet."""
    try:
        rows = list(
            csv.DictReader(
                io.StringIO(Path(worksheet).read_bytes().decode("utf-8-sig"), newline="")
            )
        )
        by_number = {
            row["Identifier"].rpartition(" ")[2]: row["Email address"].strip() for row in rows
        }
    except OSError as error:
        raise InputError(f"{worksheet}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error, KeyError, AttributeError):
        raise InputError(
            f"{worksheet} is not a grading worksheet of Moodle: CSV in UTF-8 with the columns "
            "Identifier and Email address"
        ) from None
    return {
        number: address
        for number, address in by_number.items()
        if re.fullmatch(r"[^/\s]+@[^/\s]+", address)
    }


def _files(download):
    """Yield (path with slashes, size, time, function that reads it) of every regular file."""
    if download.is_dir():
        for path in sorted(download.rglob("*")):
            status = path.lstat()
            if stat.S_ISREG(status.st_mode):
                yield (
                    path.relative_to(download).as_posix(),
                    status.st_size,
                    status.st_mtime,
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
        raise InputError(f"{download}: {error.strerror or error}") from None
    except (
        zipfile.BadZipFile,
        RuntimeError,
        NotImplementedError,
        ValueError,
        OverflowError,
    ) as error:
        raise InputError(
            f"{download} is neither a folder nor a .zip that can be read: {error}"
        ) from None


def _name(entry):
    """Return an entry's name, which macOS and Linux write in UTF-8 without setting the flag."""
    try:
        return (
            entry.filename
            if entry.flag_bits & UTF_8_FLAG
            else entry.filename.encode("cp437").decode()
        )
    except UnicodeError:
        return entry.filename


def _put(folder, name, content, when):
    """Write a file unless it is there; its name gets a number if another file has it."""
    stem, suffix = os.path.splitext(name)
    path, number = folder / name, 1
    try:
        while path.exists() and path.read_bytes() != content:
            number += 1
            path = folder / f"{stem} ({number}){suffix}"
        folder.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            path.write_bytes(content)
        os.utime(path, (when, when))
    except OSError as error:
        raise InputError(f"{sanitise_name(path)} cannot be written: {error.strerror}") from None
