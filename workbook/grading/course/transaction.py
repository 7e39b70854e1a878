"""Transaction: files of students and their ledger are put into a folder all together or not at all.

New files are written into `.collecting` beside the students' folders, the new ledger last. Only then
all are renamed to their places. A run that is killed, or finds the disk full, while it writes has
changed nothing, and the next one begins anew; one that is killed while it renames is finished by the
next. As long as `.collecting` is there, the folder is not graded.
"""

import os
import shutil
from contextlib import contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout

from workbook.grading.course.assignment import InputError
from workbook.grading.sandbox.sanitising import portable_name, sanitise_name

FOLDER = ".collecting"


class UnfinishedError(InputError):
    """The folder of submissions is being collected into, or `workbook collect` was stopped."""


def require_finished(root):
    """Raise `UnfinishedError` if a transaction in a folder of submissions has not ended."""
    if (Path(root) / FOLDER).exists():
        raise UnfinishedError(
            f"{root}: workbook collect is at work there, or was stopped before its end: run the same "
            "workbook collect again, which finishes it"
        )


@contextmanager
def transaction(root, record):
    """Lock a folder of submissions, end what a killed run has left, and give a `Transaction`.

    At the end of the block everything is put in its place; an error in the block changes nothing.

    Parameters
    ----------
    root : path
        The folder, made if it does not exist.
    record : str
        Name of the file beside the students' folders, without which a transaction is not complete.

    Raises
    ------
    InputError
        If the folder cannot be written to, or another process is at work there.
    """
    root = Path(root)
    staging, is_new = root / FOLDER, not root.exists()
    try:
        staging.mkdir(parents=True, exist_ok=True)
        lock = FileLock(staging / "lock", timeout=0).acquire()
    except Timeout:
        raise InputError(f"another workbook collect is at work on {root}") from None
    except OSError as error:
        raise InputError(f"{root} cannot be written to: {error.strerror}") from None
    current = Transaction(root, record)
    try:
        with lock:
            current.end_former()
            yield current
            current.commit()
    finally:
        # After the lock, whose file cannot be removed on Windows while it is open.
        if not current.is_complete:  # else the next run puts everything in its place
            shutil.rmtree(staging, ignore_errors=True)
            if is_new:
                with suppress(OSError):
                    root.rmdir()  # if nothing was put there


class Transaction:
    """Files that are going to be in a folder of submissions. Made by `transaction`."""

    def __init__(self, root, record):
        self._root, self._record = root, record
        self._staging = root / FOLDER
        self._files = self._staging / "files"
        #: Whether everything is written, so that only renaming is left.
        self.is_complete = False

    def put(self, folder, name, content):
        """Write a file unless it is there; return its name, with a number if another file has it.

        No two names differ by the case of letters alone, which Windows and macOS do not distinguish.

        Parameters
        ----------
        folder : path
            STUDENT/HOMEWORK, below the folder of submissions.
        name : str
            The name wanted.
        content : bytes
            What the file is to hold.
        """
        name = portable_name(name)
        stem, suffix = os.path.splitext(name)
        file, number = Path(folder, name), 1
        try:
            while (present := self._present(file)) is not None:
                if present.name == file.name and _holds(present, content):
                    return file.name
                number += 1
                file = Path(folder, f"{stem} ({number}){suffix}")
        except OSError as error:
            raise InputError(
                f"{sanitise_name(self._root / file)} cannot be read: {error.strerror}"
            ) from None
        self._write(self._files / file, content)
        return file.name

    def record(self, text):
        """Write the file without which nothing of this is put in its place."""
        writing = self._staging / f"{self._record}.writing"
        self._write(writing, text.encode("utf-8", "backslashreplace"))
        with _writing(self._root / self._record):
            # Else, after a power failure, a name might be there without its content. Together at
            # the end, for the disk then waits once.
            for path in [*self._staged(), writing]:
                with open(path, "r+b") as file:
                    os.fsync(file.fileno())
            writing.replace(self._staging / self._record)
        self.is_complete = True

    def commit(self):
        """Rename all files to their places, the record last."""
        for staged in self._staged():
            target = self._root / staged.relative_to(self._files)
            with _writing(target):
                target.parent.mkdir(parents=True, exist_ok=True)
                staged.replace(target)
        if self.is_complete:
            with _writing(self._root / self._record):
                (self._staging / self._record).replace(self._root / self._record)
            self.is_complete = False

    def end_former(self):
        """Finish a complete transaction that a killed run has left; remove an incomplete one."""
        self.is_complete = (self._staging / self._record).exists()
        if self.is_complete:
            self.commit()
        shutil.rmtree(self._files, ignore_errors=True)

    def _staged(self):
        return sorted(path for path in self._files.rglob("*") if path.is_file())

    def _present(self, file):
        """Return the path of a file of this name that is there, or is going to be; else None."""
        for folder in (self._files / file.parent, self._root / file.parent):
            with suppress(FileNotFoundError):
                for path in folder.iterdir():
                    if path.name.casefold() == file.name.casefold():
                        return path
        return None

    @staticmethod
    def _write(path, content):
        with _writing(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)


def _holds(path, content):
    """Return whether a path is that of a file with this content."""
    return path.is_file() and path.stat().st_size == len(content) and path.read_bytes() == content


@contextmanager
def _writing(path):
    try:
        yield
    except OSError as error:
        raise InputError(
            f"{sanitise_name(path)} cannot be written: {error.strerror}; nothing that was there is "
            "lost, and the same command goes on from there"
        ) from None
