"""Collecting is a transaction: killed at any point, or on a full disk, it loses and doubles nothing."""

import errno
import json
import os
import random
import shutil
import sys
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import killed_collecting
from classroom import notebook
from filelock import FileLock
from test_collecting import WORKSHEET, packed

from workbook.grading.course import course, ledger, submissions
from workbook.grading.course.assignment import InputError
from workbook.grading.course.collecting import collect
from workbook.grading.course.options import GradingOptions
from workbook.grading.course.transaction import FOLDER, UnfinishedError, transaction

KILLS = 40
STUDENTS = {"Ann Able_101": "k1 > 1", "Renée_O Neil_102": "k1 > 2", "Cid_104": "k1 > 3"}


def moodle(folder, name, version):
    """Make an archive of two notebooks and a .zip of each student, long enough to be interrupted."""
    files = {}
    for student, answer in STUDENTS.items():
        for problem in ("1.15", "1.17"):
            text = json.dumps(notebook(problem, {"a_region": f"{answer}{version}"}))
            path = f"{student}_assignsubmission_file/ch{problem.replace('.', '-p')}.ipynb"
            files[path] = text + " " * 300_000
        files[f"{student}_assignsubmission_file/photo.png"] = f"{student}{version}"
    return packed(folder, files, name)


def tree(folder):
    """Return {path: content} of all files and folders."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in folder.rglob("*")
    }


@pytest.fixture
def second_download(tmp_path):
    """A folder with one download collected, and the arguments by which the next is collected."""
    (tmp_path / "sheet.csv").write_text(WORKSHEET, encoding="utf-8")
    arguments = ["hw1", tmp_path / "in", tmp_path / "sheet.csv"]
    code, _ = killed_collecting.run([moodle(tmp_path, "first.zip", 1), *arguments])
    assert code == 0
    later = WORKSHEET.replace("2:14 PM", "5:14 PM").replace("9:00 AM", "9:30 AM")
    (tmp_path / "sheet.csv").write_text(later, encoding="utf-8")
    return [moodle(tmp_path, "second.zip", 2), *arguments]


def test_collecting_that_is_killed_at_any_point_ends_in_the_same(tmp_path, second_download):
    into = second_download[2]
    before = tree(into)
    shutil.copytree(into, tmp_path / "undisturbed")
    began = time.monotonic()
    arguments = [second_download[0], "hw1", tmp_path / "undisturbed", second_download[3]]
    code, touches = killed_collecting.run(arguments)
    seconds = time.monotonic() - began
    expected = tree(tmp_path / "undisturbed")
    assert code == 0 and before.keys() < expected.keys()
    choose, refused, killed = random.Random(0), 0, 0
    for kill in range(KILLS):
        shutil.rmtree(into)
        for name, content in before.items():
            (into / name).parent.mkdir(parents=True, exist_ok=True)
            (into / name).write_bytes(content) if content is not None else None
        for _ in range(1 + kill % 2):  # every other one is killed twice
            at_touch = {"touches": choose.randint(1, touches)}
            limits = at_touch if kill % 4 else {"seconds": choose.uniform(0.005, seconds)}
            code, _ = killed_collecting.run(second_download, **limits)
            killed += code < 0
        if (into / FOLDER).exists():
            refused += 1
            with pytest.raises(UnfinishedError, match="run the same workbook collect again"):
                list(submissions.find(into))
        else:
            assert tree(into) in (before, expected)
        assert killed_collecting.run(second_download)[0] == 0
        assert tree(into) == expected
    assert killed > KILLS // 2 and refused > KILLS // 2


@pytest.mark.parametrize("call", [0, 3, 5, len(STUDENTS) * 3])
@pytest.mark.parametrize("owner, name", [(Path, "write_bytes"), (os, "fsync")])
def test_a_disk_that_gets_full_while_files_are_written(
    monkeypatch, second_download, owner, name, call
):
    """Nothing has changed then, and there is no half of a download to be graded."""
    into, real, calls = second_download[2], getattr(owner, name), []
    before = tree(into)

    def fail(file, *content):
        calls.append(file)
        if len(calls) == call + 1:
            real(file, *(half[: len(half) // 2] for half in content))
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(file, *content)

    with monkeypatch.context() as full:
        full.setattr(owner, name, fail)
        with pytest.raises(InputError, match="cannot be written: No space left on device"):
            collect(*second_download)
    assert tree(into) == before and list(submissions.find(into))
    collect(*second_download)
    assert len(tree(into)) == len(before) + len(STUDENTS) * 3


@pytest.mark.parametrize("call", [1, 4, 10])
def test_a_disk_that_fails_while_files_are_put_in_their_places(monkeypatch, second_download, call):
    """Then the folder is not graded until the next run has put the others in theirs."""
    into, real, calls = second_download[2], Path.replace, []

    def fail(path, target):
        calls.append(path)
        if len(calls) == call + 1:  # the first makes the transaction complete
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(path, target)

    before = tree(into)
    with monkeypatch.context() as full:
        full.setattr(Path, "replace", fail)
        with pytest.raises(InputError, match="cannot be written: No space left on device"):
            collect(*second_download)
    with pytest.raises(UnfinishedError):
        course.grade(GradingOptions(into, into.parent / "graded", trusting=True))
    collect(*second_download)
    assert len(tree(into)) == len(before) + len(STUDENTS) * 3
    assert FOLDER not in tree(into)


def test_an_error_in_a_new_folder_leaves_no_folder(tmp_path):
    with pytest.raises(ZeroDivisionError), transaction(tmp_path / "in", ledger.NAME) as current:
        current.put("ann/hw1", "a.ipynb", b"{}")
        1 / 0
    assert not (tmp_path / "in").exists()


def test_two_at_a_time_are_refused(tmp_path, second_download):
    into = second_download[2]
    (into / FOLDER).mkdir()
    with (
        FileLock(into / FOLDER / "lock"),
        pytest.raises(InputError, match="another workbook collect is at work on"),
    ):
        collect(*second_download)


def test_a_name_that_is_taken(tmp_path):
    """A name that is taken by something else, a folder or a link, is not written over."""
    (tmp_path / "in" / "ann" / "hw1" / "a.ipynb").mkdir(parents=True)
    (tmp_path / "in" / "ann" / "hw1" / "a (2).ipynb").symlink_to(tmp_path / "nowhere")
    with transaction(tmp_path / "in", ledger.NAME) as current:
        assert current.put("ann/hw1", "a.ipynb", b"{}") == "a (3).ipynb"
        assert current.put("ann/hw1", "a.ipynb", b"{}") == "a (3).ipynb"
        assert current.put("ann/hw1", "a.ipynb", b"[]") == "a (4).ipynb"
    assert not (tmp_path / "nowhere").exists()
    assert (tmp_path / "in" / "ann" / "hw1" / "a (4).ipynb").read_bytes() == b"[]"
