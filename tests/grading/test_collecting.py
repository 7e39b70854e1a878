"""Downloads from Moodle or Canvas become folders that `workbook grade` reads."""

import json
import re
import sys
import time
import zipfile
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import notebook

from workbook.cli import app
from workbook.grading.assignment import InputError
from workbook.grading.collecting import collect
from workbook.grading.submissions import LeftAside, Submission, find

MOODLE = {
    "Ann Able_101_assignsubmission_file/ch1-p15.ipynb": 1,
    "Renée_O Neil_102_assignsubmission_file_/sub/ch1-p15.ipynb": 2,
    "Bob_Bee_103_assignsubmission_file_ch1-p15.ipynb": 3,
    "Cid_104_assignsubmission_file/notes.pdf": 4,
}
CANVAS = {
    "ableann_101_9001_ch1-p15.ipynb": 1,
    "beebob_LATE_102_9002_ch1-p15-1.ipynb": 2,
    "ceecid_103_9003_my_ch1-p15.ipynb": 3,
    "ceecid_103_9004_ch1-p17.ipynb": 4,
}
WHEN = (2026, 9, 30, 12, 0, 0)


def download(folder, files, archive):
    """Make a folder or archive of the files, whose contents differ."""
    contents = {
        name: json.dumps(notebook("1.15", {"a_region": f"k1 > {k}"})) for name, k in files.items()
    }
    if archive:
        with zipfile.ZipFile(folder / "all.zip", "w") as into:
            for name, content in contents.items():
                into.writestr(zipfile.ZipInfo(name, WHEN), content)
        return folder / "all.zip"
    for name, content in contents.items():
        (folder / "all" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "all" / name).write_text(content)
    return folder / "all"


def handed_in(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("archive", [True, False])
@pytest.mark.parametrize(
    "files, expected",
    [
        (
            MOODLE,
            {
                "Ann Able_101/hw1/ch1-p15.ipynb",
                "Renée_O Neil_102/hw1/ch1-p15.ipynb",
                "Bob_Bee_103/hw1/ch1-p15.ipynb",
                "Cid_104/hw1/notes.pdf",
            },
        ),
        (
            CANVAS,
            {
                "101/hw1/ch1-p15.ipynb",
                "102/hw1/ch1-p15-1.ipynb",
                "103/hw1/my_ch1-p15.ipynb",
                "103/hw1/ch1-p17.ipynb",
            },
        ),
    ],
)
def test_a_download(tmp_path, files, expected, archive):
    downloaded = download(tmp_path, files, archive)
    into = tmp_path / "submitted"
    collected, aside = collect(downloaded, "hw1", into)
    assert handed_in(into) == expected and aside == [] and sum(map(len, collected.values())) == 4
    if archive:
        assert {path.stat().st_mtime for path in into.rglob("*") if path.is_file()} == {
            time.mktime((*WHEN, 0, 0, -1))
        }
    collect(downloaded, "hw1", into)
    assert handed_in(into) == expected, "once more is no more"
    assert sum(
        isinstance(entry, Submission) and entry.problem == "1.15" for entry in find(into)
    ) == len([name for name in expected if name.endswith(".ipynb")])
    assert [entry.student for entry in find(into) if isinstance(entry, LeftAside)] == [
        "Cid_104"
    ] * (files is MOODLE)


def test_accents_in_an_archive_without_the_utf_8_flag(tmp_path):
    """macOS writes names in UTF-8 without setting the flag."""
    path = download(tmp_path, MOODLE, True)
    packed, header = path.read_bytes(), rb"(PK(?:\x03\x04..|\x01\x02....))\x00\x08"
    assert len(re.findall(header, packed, re.DOTALL)) == 2, "one name has an accent"
    path.write_bytes(re.sub(header, rb"\1" + bytes(2), packed, flags=re.DOTALL))
    assert "Renée_O Neil_102" in collect(path, "hw1", tmp_path / "submitted")[0]


@pytest.mark.parametrize(
    "path_in_archive",
    [
        "Ann Able_101_assignsubmission_onlinetext/onlinetext.html",
        "Ann Able_101_assignsubmission_onlinetext_.html",
    ],
)
def test_online_text_is_reported_as_such(tmp_path, path_in_archive):
    downloaded = download(
        tmp_path, {path_in_archive: 1, "Bob_102_assignsubmission_file_/ch1-p15.ipynb": 2}, True
    )
    collected, aside = collect(downloaded, "hw1", tmp_path / "submitted")
    assert list(collected) == ["Bob_102"] and [
        (path, "typed in at Moodle" in why) for path, why in aside
    ] == [(path_in_archive, True)]


def test_a_later_download_overwrites_nothing(tmp_path):
    collect(
        download(tmp_path, {"ableann_101_9001_ch1-p15.ipynb": 1}, True),
        "hw1",
        tmp_path / "submitted",
    )
    collect(
        download(tmp_path, {"ableann_101_9009_ch1-p15.ipynb": 2}, True),
        "hw1",
        tmp_path / "submitted",
    )
    assert handed_in(tmp_path / "submitted") == {
        "101/hw1/ch1-p15.ipynb",
        "101/hw1/ch1-p15 (2).ipynb",
    }
    assert {entry.problem for entry in find(tmp_path / "submitted")} == {"1.15"}


def test_addresses_from_the_worksheet(tmp_path):
    worksheet = tmp_path / "worksheet.csv"
    worksheet.write_text(
        "\ufeffIdentifier,Full name,Email address,Grade\nParticipant 101,Ann "
        "Able,ann@uni.example,\n"
        "Participant 103,Bob Bee,../../x@y,\n",
        encoding="utf-8",
    )
    collect(download(tmp_path, MOODLE, True), "hw1", tmp_path / "submitted", worksheet)
    assert {path.name for path in (tmp_path / "submitted").iterdir()} == {
        "ann@uni.example",
        "Renée_O Neil_102",
        "Bob_Bee_103",
        "Cid_104",
    }


@pytest.mark.parametrize("archive", [True, False])
def test_names_that_lead_out_of_the_folder(tmp_path, archive):
    """Nothing is written outside STUDENT/HOMEWORK, and what is left aside is reported."""
    odd = {
        "ableann_101_9001_ch1-p15.ipynb": 1,
        "README.txt": 2,
        "x" * 200 + "_1_assignsubmission_file/" + "y" * 250: 3,
    }
    if archive:
        odd |= {
            "../../a_1_2_../x.ipynb": 4,
            "a_1_assignsubmission_file/..": 5,
            "a_1_2_..": 6,
            "/etc/passwd": 7,
            "a_1_assignsubmission_file/../../../ch1-p15.ipynb": 8,
        }
    collected, aside = collect(
        download(tmp_path, odd, archive), "hw1", tmp_path / "deep" / "submitted"
    )
    written = handed_in(tmp_path / "deep")
    assert (
        all(len(Path(path).parts) == 4 and ".." not in path for path in written)
        and "101" in collected
    )
    assert {path for path, _ in aside} >= {"README.txt"} and len(aside) + sum(
        map(len, collected.values())
    ) == len(odd)


@pytest.mark.parametrize(
    "content, message", [(b"no archive", "neither a folder nor a .zip"), (None, "No such file")]
)
def test_files_that_are_no_download(tmp_path, content, message):
    path = tmp_path / "all.zip"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=message):
        collect(path, "hw1", tmp_path / "submitted")
    with pytest.raises(InputError, match="cannot be the name of a homework"):
        collect(path, "../hw1", tmp_path / "submitted")
    with pytest.raises(InputError, match="no file that is named as Moodle or Canvas"):
        collect(download(tmp_path, {"ch1-p15.ipynb": 1}, False), "hw1", tmp_path / "submitted")


def test_the_command(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    path = download(tmp_path, CANVAS | {"README.txt": 9}, True)
    app(["collect", str(path), "hw1"], standalone_mode=False)
    output = capsys.readouterr().out
    assert (
        "submitted: 4 files of 3 students for hw1" in output
        and "left aside: README.txt: its name is not one" in output
    )
