"""Archives: the files of a download, each of which can be read or not for itself."""

import io
import lzma
import re
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from workbook.grading.course.assignment import InputError
from workbook.grading.course.encodings import decoded
from workbook.grading.sandbox.submitted_file import MAX_FILE, UnreadableFileError

#: Flags of an entry in a .zip archive.
ENCRYPTED_FLAG, UTF_8_FLAG = 0x1, 0x800
#: The kind of a field with a name in UTF-8 and a checksum of the name that it stands for.
UNICODE_PATH = 0x7075
#: Encodings in which Windows writes names of files into archives, where it is Russian.
WINDOWS_ENCODINGS = ["cp866", "cp1251"]
#: What `zipfile` raises on an archive or an entry that is damaged.
DAMAGE = (
    zipfile.BadZipFile,
    RuntimeError,
    ValueError,
    OverflowError,
    EOFError,
    OSError,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    MemoryError,
)
#: Notebooks, and entries of any kind, in one archive that a student hands in.
MAX_NOTEBOOKS, MAX_ENTRIES = 100, 10_000
#: What each entry begins with in the directory of an archive.
ENTRY = b"PK\x01\x02"


@dataclass(frozen=True)
class File:
    """A file of a download.

    Parameters
    ----------
    path : str
        With slashes.
    size : int
        In bytes.
    read : callable
        Returns its content; raises `UnreadableFileError`.
    """

    path: str
    size: int
    read: Callable


@contextmanager
def opened(download):
    """Open a download, a folder or .zip, and give the list of its files; raises `InputError`."""
    download = Path(download)
    if download.is_dir():
        yield [
            _in_folder(path, download, status.st_size)
            for path in sorted(download.rglob("*"))
            if stat.S_ISREG((status := path.lstat()).st_mode)
        ]
        return
    try:
        archive = zipfile.ZipFile(download)
    except FileNotFoundError as error:
        raise InputError(f"{download}: {error.strerror}") from None
    except DAMAGE as error:
        raise InputError(
            f"{download} is neither a folder nor a .zip that can be read: {error}"
        ) from None
    with archive:
        yield _files(archive)


def notebooks(content):
    """Return the notebooks of a .zip archive that a student handed in.

    Raises `UnreadableFileError` if it cannot be opened, or holds more than is read.
    """
    if content.count(ENTRY) > MAX_ENTRIES:  # each takes a thousand bytes when it is opened
        raise UnreadableFileError(f"it holds more than {MAX_ENTRIES} files")
    try:
        files = _files(zipfile.ZipFile(io.BytesIO(content)))
    except DAMAGE as error:
        raise UnreadableFileError(f"it is no .zip archive that can be opened ({error})") from None
    inside = [
        file
        for file in files
        if file.path.lower().endswith(".ipynb")
        and not any(re.match(r"\.[^.]", part) for part in file.path.split("/"))  # hidden
    ]
    if len(inside) > MAX_NOTEBOOKS or sum(file.size for file in inside) > MAX_FILE:
        raise UnreadableFileError(
            f"it holds more than {MAX_NOTEBOOKS} notebooks, or more than {MAX_FILE // 2**20} MB of "
            "them"
        )
    return inside


def _in_folder(path, folder, size):
    def read():
        try:
            return path.read_bytes()
        except OSError as error:
            raise UnreadableFileError(f"it cannot be read ({error.strerror})") from None

    return File(path.relative_to(folder).as_posix(), size, read)


def _files(archive):
    """Return the files of an open archive, except those that macOS adds."""
    entries = [entry for entry in archive.infolist() if not entry.is_dir()]
    return [
        File(name, entry.file_size, lambda entry=entry: _content(archive, entry))
        for entry, name in zip(entries, _names(entries))
        if not name.startswith("__MACOSX/")
    ]


def _content(archive, entry):
    if entry.flag_bits & ENCRYPTED_FLAG:
        raise UnreadableFileError("it is encrypted")
    try:
        return archive.read(entry)
    except NotImplementedError:
        raise UnreadableFileError("it is compressed in a way that cannot be read here") from None
    except DAMAGE as error:
        raise UnreadableFileError(f"it is damaged ({error})") from None


def _names(entries):
    """Return the names of entries.

    Where neither a flag nor a field says that they are in UTF-8, `zipfile` reads them in the first
    encoding that archives had; macOS and Linux write UTF-8 all the same, Windows its own encodings.
    """
    known = [_name_in_utf_8(entry) for entry in entries]
    others = [_name_as_bytes(entry) for entry, name in zip(entries, known) if name is None]
    _, encoding = decoded(b"\n".join(others), ["utf-8", *WINDOWS_ENCODINGS])
    return [
        decoded(_name_as_bytes(entry), [encoding or "utf-8"])[0] or entry.filename
        if name is None
        else name
        for entry, name in zip(entries, known)
    ]


def _name_in_utf_8(entry):
    """Return the name of an entry that says itself that it is in UTF-8, else None."""
    if entry.flag_bits & UTF_8_FLAG:
        return entry.filename
    extra = entry.extra
    while len(extra) > 9:
        kind, length, _, checksum = struct.unpack_from("<HHBL", extra)
        if kind == UNICODE_PATH and checksum == zlib.crc32(_name_as_bytes(entry)):
            return decoded(extra[9 : 4 + length], ["utf-8"])[0] or None
        extra = extra[4 + length :]
    return None


def _name_as_bytes(entry):
    return entry.orig_filename.partition("\0")[0].encode("cp437")
