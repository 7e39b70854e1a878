"""Finding submissions: no file stops the search, and every one is reported."""

import json
import os
import sys
from datetime import UTC, datetime
from pathlib import Path
from unicodedata import normalize

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import hand_in, notebook

from workbook.grading.course import submissions
from workbook.grading.course.submissions import LeftAside, Submission, find, students
from workbook.grading.sandbox import limited_process, submitted_file
from workbook.grading.sandbox.sanitising import sanitise, sanitise_name


def test_order_and_what_was_left_aside(tmp_path):
    hand_in(tmp_path, "bela", "1.15", {})
    hand_in(tmp_path, "ada", "1.4", {}, at=5.0)
    root = tmp_path / "submitted"
    (root / "cyd").symlink_to(root / "ada")
    (root / "dora" / "hw1").mkdir(parents=True)
    (root / "dora" / "hw1" / "notes.pdf").touch()
    (root / "ellen" / "real").mkdir(parents=True)
    (root / "ellen" / "hw1").symlink_to(root / "ada" / "hw1")
    (root / "ellen" / "real" / "p15.ipynb").symlink_to(root / "ada" / "hw1" / "ch1-p04.ipynb")
    (root / ".git" / "hw1").mkdir(parents=True)
    (root / "README.txt").touch()
    entries = list(find(root))
    asides = {
        Path(entry.path).relative_to(root).as_posix(): entry.reason
        for entry in entries
        if isinstance(entry, LeftAside)
    }
    assert asides == {
        "cyd": "this is a symbolic link",
        "dora/hw1": "there is no notebook in this folder, only notes.pdf",
        "ellen/hw1": "this is a symbolic link",
    }
    read = [entry for entry in entries if isinstance(entry, Submission)]
    assert [(entry.student, entry.problem, bool(entry.trouble)) for entry in read] == [
        ("ada", "1.4", False),
        ("bela", "1.15", False),
        ("ellen", None, True),
    ]
    assert read[0].submitted == 5.0 and read[2].cells == ()


def test_misplaced_notebooks_are_reported(tmp_path):
    """A class whose notebooks are one folder too high or low has not handed in nothing."""
    real = hand_in(tmp_path, "ada", "1.15", {})
    root = tmp_path / "submitted"
    for path_in_root in (
        "ch1-p15.ipynb",
        "bela/ch1-p15.ipynb",
        "ada/hw1/inner/ch1-p15.ipynb",
        "ada/hw1/._ch1-p15.ipynb",
        "ada/hw1/.ipynb_checkpoints/ch1-p15.ipynb",
    ):
        (root / path_in_root).parent.mkdir(exist_ok=True)
        (root / path_in_root).write_bytes(real.read_bytes())
    (root / "ada" / "hw1" / "pictures").mkdir()
    entries = list(find(root))
    asides = {
        Path(entry.path).relative_to(root).as_posix()
        for entry in entries
        if isinstance(entry, LeftAside)
    }
    assert asides == {"ch1-p15.ipynb", "bela/ch1-p15.ipynb", "ada/hw1/inner/ch1-p15.ipynb"}
    reasons = {entry.reason for entry in entries if isinstance(entry, LeftAside)}
    assert reasons == {"it does not lie in a folder STUDENT/HOMEWORK, where notebooks are read"}
    assert [entry.path for entry in entries if isinstance(entry, Submission)] == [str(real)]


@pytest.mark.parametrize(
    "trouble",
    [
        PermissionError(13, "Permission denied"),
        OSError(5, "Input/output error"),
        OSError(24, "Too many open files"),
    ],
)
@pytest.mark.parametrize("call", ["open", "fstat"])
def test_a_file_without_read_permission_is_no_attempt(tmp_path, monkeypatch, trouble, call):
    """It is not the student's fault, so it must not count as the only attempt."""
    hand_in(tmp_path, "ada", "1.15", {})
    real = getattr(os, call)

    def fail(what, *options):
        if call == "fstat" or Path(what).suffix == ".ipynb":
            raise trouble
        return real(what, *options)

    with monkeypatch.context() as broken:
        broken.setattr(os, call, fail)
        (aside,) = find(tmp_path / "submitted")
    assert (
        isinstance(aside, LeftAside)
        and aside.reason == f"this file cannot be read ({trouble.strerror})"
    )
    assert isinstance(next(find(tmp_path / "submitted")), Submission)


def test_a_folder_that_cannot_be_opened(tmp_path, monkeypatch):
    hand_in(tmp_path, "ada", "1.15", {})
    hand_in(tmp_path, "bela", "1.15", {})
    # root can open everything
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path).name != "ada")
    entries = list(find(tmp_path / "submitted"))
    assert (
        isinstance(entries[0], LeftAside)
        and entries[0].reason == "this folder cannot be opened"
        and entries[1].student == "bela"
    )


@pytest.mark.parametrize(
    "name",
    [
        b"ada",
        b"\xff\xfe",
        "Łódź".encode(),
        b"a\nb",
        b"'; rm x",
        b'"',
        b"-rf",
        b"a\\xff",
        b"a\\",
        b"\xe2\x80\xaegnp",
        b"\x1b[2J",
        b"x" * 255,
    ],
)
def test_odd_names(tmp_path, name):
    folder = os.fsencode(tmp_path / "submitted") + b"/" + name + b"/hw1"
    os.makedirs(folder)
    with open(folder + b"/p15.ipynb", "w") as file:
        json.dump(notebook("1.15", {}), file)
    (entry,) = find(tmp_path / "submitted")
    assert entry.problem == "1.15" and not entry.trouble
    for text in (entry.student, entry.path):
        assert text.encode() and text.isprintable()


def test_both_unicode_forms_of_a_name_are_one_student(tmp_path):
    """macOS writes é as e and an accent, other systems as one letter."""
    for k, spelling in enumerate(("NFC", "NFD")):
        hand_in(
            tmp_path,
            normalize(spelling, "renée"),
            "1.15",
            {},
            name=f"ch1-p15-{k}.ipynb",
            assignment=normalize(spelling, "été"),
        )
    entries = list(find(tmp_path / "submitted"))
    assert len(entries) == 2 and {(entry.student, entry.assignment) for entry in entries} == {
        (normalize("NFC", "renée"), normalize("NFC", "été"))
    }
    assert students(tmp_path / "submitted") == [normalize("NFC", "renée")]


@pytest.mark.parametrize("gone", ["ada", "ada/hw1", "ada/hw1/ch1-p15.ipynb"])
def test_what_is_renamed_meanwhile_is_reported(tmp_path, monkeypatch, gone):
    hand_in(tmp_path, "ada", "1.15", {})
    hand_in(tmp_path, "ada", "1.15", {}, assignment="hw1/inner")
    hand_in(tmp_path, "bela", "1.15", {})
    root, listed = tmp_path / "submitted", submissions._listed

    def then_renamed(path):
        entries = listed(path)
        if root / gone in entries:
            (root / gone).rename(root / f"renamed-{gone.replace(chr(47), chr(45))}")
        return entries

    monkeypatch.setattr(submissions, "_listed", then_renamed)
    entries = list(find(root))
    assert any(isinstance(entry, Submission) and entry.student == "bela" for entry in entries)
    asides = [entry for entry in entries if isinstance(entry, LeftAside)]
    assert any(Path(entry.path) == root / gone and entry.student == "ada" for entry in asides), (
        asides
    )
    reasons = ("renamed or removed", "cannot be read", "does not lie")
    assert all(any(words in entry.reason for words in reasons) for entry in asides)


def test_different_names_stay_different():
    names = [
        b"\xff",
        b"\\xff",
        b"\\\\xff",
        "ÿ".encode(),
        b"a\n",
        b"a\\n",
        "\u202e".encode(),
        b"\\u202e",
        b"ada",
    ]
    assert len({sanitise_name(name) for name in names}) == len(names)
    assert (
        sanitise_name("ada") == "ada"
        and sanitise_name("Łódź") == "Łódź"
        and sanitise_name("محمد علی") == "محمد علی"
    )


def test_sanitise():
    assert sanitise("a\x1b[2J\ud800\u2028b\n") == "a\\x1b[2J\\ud800\\u2028b\\n"
    assert sanitise("a\nb", keep="\n") == "a\nb"


@pytest.mark.parametrize(
    "name, message",
    [
        (b"grades.sqlite", "the folder of results needs this name for itself"),
        (b"grades.sqlite-wal", "needs this name for itself"),
        (b"grades.sqlite-shm", "needs this name for itself"),
        (b"\x01" * 250, "this name is too long for a folder of results"),
    ],
)
def test_names_that_no_homework_can_have(tmp_path, name, message):
    folder = os.fsencode(tmp_path / "submitted") + b"/eve/" + name
    os.makedirs(folder)
    with open(folder + b"/p15.ipynb", "w") as file:
        json.dump(notebook("1.15", {}), file)
    hand_in(tmp_path, "ada", "1.15", {})
    ada, aside = find(tmp_path / "submitted")
    assert (
        ada.student == "ada"
        and message in aside.reason
        and (aside.student, aside.assignment) == ("eve", "")
    )


def test_system_folders_are_ignored(tmp_path):
    real = hand_in(tmp_path, "ada", "1.15", {})
    for path_in_root in (
        "__MACOSX/ada/hw1/ch1-p15.ipynb",
        "ada/__MACOSX/ch1-p15.ipynb",
        "ada/hw1/__MACOSX/ch1-p15.ipynb",
        ".Trashes/hw1/ch1-p15.ipynb",
        "@eaDir/hw1/ch1-p15.ipynb",
    ):
        (tmp_path / "submitted" / path_in_root).parent.mkdir(parents=True)
        (tmp_path / "submitted" / path_in_root).write_bytes(real.read_bytes())
    (tmp_path / "submitted" / ".DS_Store").touch()
    (entry,) = find(tmp_path / "submitted")
    assert entry.path == str(real) and students(tmp_path / "submitted") == ["ada"]
    (tmp_path / "submitted" / "bela" / "hw1").mkdir(parents=True)
    (tmp_path / "submitted" / "bela" / "hw1" / ".DS_Store").touch()
    assert list(find(tmp_path / "submitted"))[-1].student == "", "an empty folder is nobody's work"


@pytest.mark.parametrize("megabytes", [6, 25])
def test_pictures_cost_nothing(tmp_path, megabytes):
    nb = notebook("1.15", {"a_region": "k1 > 0"})
    nb["cells"][2]["outputs"] = [
        {
            "output_type": "display_data",
            "data": {"image/png": "A" * megabytes * 2**20},
            "metadata": {},
        }
    ]
    hand_in(tmp_path, "ada", "1.15", {}).write_text(json.dumps(nb))
    (entry,) = find(tmp_path / "submitted")
    assert (
        entry.trouble == ""
        and entry.problem == "1.15"
        and any("a_region = k1 > 0" in cell for cell in entry.cells)
    )


@pytest.mark.parametrize(
    "content, message",
    [(b"[" + b"[]," * 2**21 + b"[]]", "not a notebook"), (b"{" * 12 * 2**20, "no JSON in UTF-8")],
)
def test_large_files_that_are_no_notebooks(tmp_path, content, message):
    hand_in(tmp_path, "ada", "1.15", {}).write_bytes(content)
    (entry,) = find(tmp_path / "submitted")
    assert message in entry.trouble and entry.submitted > 0


@pytest.mark.parametrize(
    "content, message", [(b"", "empty"), (b" \r\n", "empty"), (b"PK\x03\x04rest", ".zip archive")]
)
def test_files_of_other_formats_with_the_name_of_a_notebook(tmp_path, content, message):
    hand_in(tmp_path, "ada", "1.15", {}).write_bytes(content)
    (entry,) = find(tmp_path / "submitted")
    assert message in entry.trouble and entry.problem == "1.15" and entry.cells == ()


def test_reading_has_limits(tmp_path, monkeypatch):
    """Twenty megabytes of empty lists are half a gigabyte in memory."""
    monkeypatch.setattr(limited_process, "MEMORY", 100 * 2**20)
    hand_in(tmp_path, "ada", "1.15", {}).write_bytes(b'{"cells": [' + b"[]," * 7 * 2**20 + b"[]]}")
    (entry,) = find(tmp_path / "submitted")
    assert (
        entry.trouble == "the file has 21 MB, and reading it took more time or memory than allowed"
    )


def test_the_time_of_a_file_that_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr(submitted_file, "MAX_FILE", 100)
    hand_in(tmp_path, "ada", "1.15", {}, at=5.0)
    (entry,) = find(tmp_path / "submitted")
    assert entry.submitted == 5.0 and "notebooks up to" in entry.trouble


def test_times_beyond_datetime(tmp_path, monkeypatch):
    path = hand_in(tmp_path, "ada", "1.15", {})
    monkeypatch.setattr(Path, "lstat", lambda path: os.stat_result((0,) * 8 + (10**15, 0)))
    with submitted_file.Reader() as reader:
        entry = submissions._read("ada", "hw1", path, reader)
    assert datetime.fromtimestamp(entry.submitted, UTC).year == 9999


def test_notebooks_of_format_3(tmp_path):
    nb = notebook("1.15", {"a_region": "k1 > 0"})
    cells = [dict(cell) for cell in nb["cells"]]
    for cell in cells:
        if cell["cell_type"] == "code":
            cell["input"] = cell.pop("source")
    old = {
        "nbformat": 3,
        "nbformat_minor": 0,
        "metadata": nb["metadata"],
        "worksheets": [{"cells": cells[:3]}, {"cells": cells[3:]}],
    }
    hand_in(tmp_path, "ada", "1.15", {}).write_text(json.dumps(old))
    (entry,) = find(tmp_path / "submitted")
    assert entry.problem == "1.15"
    assert entry.cells == tuple(
        "".join(cell["source"]) for cell in nb["cells"] if cell["cell_type"] == "code"
    )


def test_too_much_code(tmp_path):
    nb = notebook("1.15", {})
    nb["cells"] += [{"cell_type": "code", "metadata": {}, "source": "x = 1\n" * 200_000}]
    path = hand_in(tmp_path, "ada", "1.15", {})
    path.write_text(json.dumps(nb))
    (entry,) = find(tmp_path / "submitted")
    assert "more than 1 MB of code" in entry.trouble and entry.cells == ()
