"""Downloads from Moodle or Canvas become folders that `workbook grade` reads."""

import io
import json
import re
import struct
import sys
import time
import zipfile
import zlib
from datetime import datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, notebook

from workbook.cli import app
from workbook.grading.course import collecting, ledger
from workbook.grading.course.assignment import InputError
from workbook.grading.course.collecting import collect
from workbook.grading.course.roster import Roster
from workbook.grading.course.submissions import LeftAside, Submission, find, students
from workbook.grading.reports.canvas import Gradebook
from workbook.terminal import UserError

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
    paths = (path for path in folder.rglob("*") if path.is_file() and path.name != ledger.NAME)
    return {str(path.relative_to(folder)) for path in paths}


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
    collected = collect(downloaded, "hw1", into)
    assert handed_in(into) == expected and collected.aside == []
    assert sum(map(len, collected.files.values())) == 4
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
    assert "Renée_O Neil_102" in collect(path, "hw1", tmp_path / "submitted").files


@pytest.mark.parametrize(
    "path_in_archive",
    [
        "Ann Able_101_assignsubmission_onlinetext/onlinetext.html",
        "Ann Able_101_assignsubmission_onlinetext_.html",
        "Ann Able_101_assignsubmission_onlinetext_onlinetext.html",
    ],
)
def test_online_text_is_reported_as_such(tmp_path, path_in_archive):
    downloaded = download(
        tmp_path, {path_in_archive: 1, "Bob_102_assignsubmission_file_/ch1-p15.ipynb": 2}, True
    )
    collected = collect(downloaded, "hw1", tmp_path / "submitted")
    assert list(collected.files) == ["Bob_102"] and [
        (path, "typed in at Moodle" in why) for path, why in collected.aside
    ] == [(path_in_archive, True)]
    aside = [entry for entry in find(tmp_path / "submitted") if isinstance(entry, LeftAside)]
    assert [(entry.student, entry.assignment) for entry in aside] == [("Ann Able_101", "hw1")]


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
    assert {path.name for path in (tmp_path / "submitted").iterdir() if path.is_dir()} == {
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
    collected = collect(download(tmp_path, odd, archive), "hw1", tmp_path / "deep" / "submitted")
    written = handed_in(tmp_path / "deep")
    assert (
        all(len(Path(path).parts) == 4 and ".." not in path for path in written)
        and "101" in collected.files
    )
    assert {path for path, _ in collected.aside} >= {"README.txt"}
    assert len(collected.aside) + sum(map(len, collected.files.values())) == len(odd)


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


# Who: by the system, never by what a student writes


def packed(folder, files, name="all.zip"):
    """Make an archive of files with the given content."""
    with zipfile.ZipFile(folder / name, "w") as into:
        for path, content in files.items():
            into.writestr(zipfile.ZipInfo(path, WHEN), content)
    return folder / name


def files_of(folder, files, roster=None):
    """Collect files of no content that matters; return {student: its files}, and what is aside."""
    collected = collect(
        packed(folder, dict.fromkeys(files, "{}")), "hw1", folder / "in", None, roster
    )
    return collected.files, collected.aside


@pytest.mark.parametrize(
    "path, student, file",
    [
        (
            "Eve Evil_1777_assignsubmission_file_Some Body_1000_assignsubmission_file_ch1-p15.ipynb",
            "Eve Evil_1777",
            "Some Body_1000_assignsubmission_file_ch1-p15.ipynb",
        ),
        (
            "Eve Evil_1777_assignsubmission_file/Some Body_1000_assignsubmission_file/ch1-p15.ipynb",
            "Eve Evil_1777",
            "ch1-p15.ipynb",
        ),
        ("Eve_1777_assignsubmission_file_/a_1_2_b.ipynb", "Eve_1777", "a_1_2_b.ipynb"),
        ("eve_1777_9001_Some Body_1000_x.ipynb", "1777", "Some Body_1000_x.ipynb"),
        ("eve_de_la_cruz_1777_9001_ch1-p15.ipynb", "1777", "ch1-p15.ipynb"),
        ("eve_LATE_1777_9001_ch1-p15.ipynb", "1777", "ch1-p15.ipynb"),
        ("x_500_LATE_1777_9001_ch1-p15.ipynb", "1777", "ch1-p15.ipynb"),
        ("anon_Ab3de_9001_ch1-p15.ipynb", "anon_Ab3de", "ch1-p15.ipynb"),
        ("LATE_anon_Ab3de_9001_ch1-p15.ipynb", "anon_Ab3de", "ch1-p15.ipynb"),
        (".eve_17_assignsubmission_file_ch1-p15.ipynb", None, None),
        ("\\eve_17_assignsubmission_file_/ch1-p15.ipynb", "_eve_17", "ch1-p15.ipynb"),
    ],
)
def test_the_owner_is_whom_the_system_names_first(tmp_path, path, student, file):
    other = "Bob_1_assignsubmission_file_ch1-p15.ipynb"
    files, _ = files_of(tmp_path, [path, other])
    assert files == {"Bob_1": ["ch1-p15.ipynb"]} | ({student: [file]} if student else {})
    assert {entry.student for entry in find(tmp_path / "in")} == set(files)


@pytest.mark.parametrize("part", ["_1", "_1_2", "a_", "_", "1", "LATE_", "_1_assignsubmission_"])
def test_a_long_name_takes_no_time(part):
    began = time.process_time()
    for path in (part * (60_000 // len(part)), f"{part * (900 // len(part))}/x_1_2_"):
        assert isinstance(collecting._owner(path, set()), str | collecting._Owner)
    assert time.process_time() - began < 1


def test_another_plugin_of_moodle_names_no_file(tmp_path):
    path = "Eve_17_assignsubmission_poodll_Bob_1_assignsubmission_file_ch1-p15.ipynb"
    files, aside = files_of(tmp_path, [path, "Bob_1_assignsubmission_file_ch1-p15.ipynb"])
    assert files == {"Bob_1": ["ch1-p15.ipynb"]} and [where for where, _ in aside] == [path]


@pytest.mark.parametrize("later", [False, True])
def test_a_number_with_two_names_is_refused(tmp_path, later):
    one, two = (f"{name}_7_assignsubmission_file_ch1-p15.ipynb" for name in ("Ann", "Bob"))
    other = "Cid_8_assignsubmission_file_ch1-p15.ipynb"
    if later:
        files_of(tmp_path, [one])
    files, aside = files_of(tmp_path, [two, other] if later else [one, two, other])
    assert list(files) == ["Cid_8"]
    assert all("the number 7 stands with two names, Ann" in why for _, why in aside)
    assert len(aside) == (1 if later else 2)


RUSSIAN = {1110: "Иванов Пётр", 1111: "Юлия Щукина", 1112: "Ann Able"}
RUSSIAN_SHEET = "Идентификатор,Полное имя,Оценка\n" + "".join(
    f"Участник{number},{name},\n" for number, name in RUSSIAN.items()
)


def packed_on_windows(folder, encoding, file_name):
    """Make an archive as Windows does: names in its encoding, without the flag for UTF-8."""
    names = [f"{name}_{n}_assignsubmission_file/{file_name}" for n, name in RUSSIAN.items()]
    path = packed(
        folder, {f"{k}" * len(name.encode(encoding)): "{}" for k, name in enumerate(names)}
    )
    content = path.read_bytes()
    for k, name in enumerate(names):
        raw = name.encode(encoding)
        content = content.replace(f"{k}".encode() * len(raw), raw)
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("encoding", ["cp866", "cp1251", "koi8-r", "utf-8"])
def test_an_archive_that_was_packed_again_on_windows(tmp_path, encoding):
    """The worksheet has the number, so the right archive of the same Moodle is not refused."""
    (tmp_path / "sheet.csv").write_text(RUSSIAN_SHEET, encoding="utf-8")
    spoilt = packed_on_windows(tmp_path, encoding, "ch1-p15.ipynb")
    first = collect(spoilt, "hw1", tmp_path / "in", tmp_path / "sheet.csv")
    assert first.aside == [] and len(first.files) == 3
    if encoding != "koi8-r":  # which nothing distinguishes from the others
        assert set(first.files) == {f"{name}_{number}" for number, name in RUSSIAN.items()}
    files = {f"{name}_{n}_assignsubmission_file/b.ipynb": "[]" for n, name in RUSSIAN.items()}
    right = packed(tmp_path, files, "right.zip")
    then = collect(right, "hw1", tmp_path / "in", tmp_path / "sheet.csv")
    assert then.aside == [] and then.files == dict.fromkeys(first.files, ["b.ipynb"])
    assert collect(right, "hw1", tmp_path / "in").aside == [], "either spelling is known now"
    assert collect(spoilt, "hw1", tmp_path / "in").aside == []


@pytest.mark.parametrize("encoding", ["cp866", "cp437"])
def test_a_name_beside_which_stands_one_in_utf_8(tmp_path, encoding):
    """As Info-ZIP writes it, for the name that is there; of another name it says nothing."""
    raw = {"cp866": "Пётр".encode("cp866"), "cp437": "René".encode("cp437")}[encoding]
    name = "Renée O'Neil"
    for checksum, student in ((zlib.crc32(raw + b"_1_9_a.ipynb"), name), (1, raw.decode(encoding))):
        entry = zipfile.ZipInfo("x" * len(raw) + "_1_9_a.ipynb", WHEN)
        path = f"{name}_1_9_a.ipynb".encode()
        entry.extra = struct.pack("<HHBL", 0x7075, len(path) + 5, 1, checksum) + path
        with zipfile.ZipFile(tmp_path / "all.zip", "w") as into:
            into.writestr(entry, "{}")
        content = (tmp_path / "all.zip").read_bytes()
        (tmp_path / "all.zip").write_bytes(content.replace(b"x" * len(raw), raw))
        (found,) = collecting.named_files(tmp_path / "all.zip")
        assert found == (f"{student}_1_9_a.ipynb", "1", "a.ipynb")


def test_western_names_are_not_taken_for_russian_ones(tmp_path):
    names = [f"{name}_{k}_9_a.ipynb" for k, name in enumerate(["Müller", "Köln", "Zoë", "Ann"])]
    path = packed(
        tmp_path, {name.translate({252: "1", 246: "2", 235: "3"}): "{}" for name in names}
    )
    content = path.read_bytes()
    for spelt, raw in ((b"M1ller", "Müller"), (b"K2ln", "Köln"), (b"Zo3_", "Zoë_")):
        content = content.replace(spelt, raw.encode("cp437"))
    path.write_bytes(content)
    assert [name for name, _, _ in collecting.named_files(path)] == names


ROSTER = Roster('Student,ID\n"X_500",101\n"Bee, Bob",500\n"Cee, Cid",102\n')


@pytest.mark.parametrize(
    "name, student",
    [
        ("x_500_101_9001_ch1-p15.ipynb", "101"),
        ("beebob_500_9002_1_15_final.ipynb", "500"),
        ("ceecid_102_9003_500_7_x.ipynb", "102"),
    ],
)
def test_a_name_that_can_be_read_in_two_ways_needs_the_roster(tmp_path, name, student):
    files, aside = files_of(tmp_path, [name, "ceecid_102_9009_y.ipynb"])
    assert "500" not in files and student in aside[0][1] and "--roster" in aside[0][1]
    assert student in files_of(tmp_path, [name], ROSTER)[0]


def test_points_in_a_gradebook_are_no_ids(tmp_path):
    roster = Gradebook("Student,ID,Section,hw (1)\nX,77,A,500\nX_500,101,A,1\n")
    assert files_of(tmp_path, ["x_500_101_9001_f.ipynb"], roster)[0] == {"101": ["f.ipynb"]}


def test_a_name_that_fits_two_students_of_the_roster_is_left_aside(tmp_path):
    roster = Roster("Student,ID\nX,500\nX_500,101\nCee,102\n")
    files, aside = files_of(tmp_path, ["x_500_101_9001_f.ipynb", "cee_102_9_f.ipynb"], roster)
    assert list(files) == ["102"] and "500 or 101" in aside[0][1]


@pytest.mark.parametrize("name", ["eve_1777_text.html", "eve_LATE_1777_link.html"])
def test_text_typed_in_at_canvas_is_reported_as_such(tmp_path, name):
    files, aside = files_of(tmp_path, [name, "bob_1_9_f.ipynb"])
    assert list(files) == ["1"] and "typed in" in aside[0][1]
    assert "1777" in [entry.student for entry in find(tmp_path / "in")]


@pytest.mark.parametrize("evil", ["500_text.html", "LATE_500_link.html", "500_9_x.ipynb"])
def test_no_file_name_keeps_the_work_of_another_student_back(tmp_path, evil):
    files, aside = files_of(tmp_path, [f"eve_1777_9001_{evil}", "beebob_500_9002_ch1-p15.ipynb"])
    assert files == {"500": ["ch1-p15.ipynb"]} and "--roster" in aside[0][1]
    assert not any(isinstance(entry, LeftAside) for entry in find(tmp_path / "in"))


@pytest.mark.parametrize(
    "top, below",
    [
        ("eve_1777_9001_work.txt", "eve_1777_9001_work/bob_500_9_ch1-p15.ipynb"),
        ("Eve_17_assignsubmission_file_a", "work/Bob_1_assignsubmission_file_ch1-p15.ipynb"),
    ],
)
def test_names_in_a_folder_that_a_student_packed_name_nobody(tmp_path, top, below):
    files, aside = files_of(tmp_path, ["README.txt", top, below])
    assert len(files) == 1 and not {"500", "Bob_1"} & set(files)
    assert ("lies deeper" in dict(aside)[below]) and "README.txt" in dict(aside)
    wrapped = [f"download/{path}" for path in (top, below)]
    assert files_of(tmp_path, wrapped)[0] == files


# When: by the system, never by the archive


def timings(folder):
    return {
        entry.student: (entry.timing, entry.submitted)
        for entry in find(folder)
        if isinstance(entry, Submission)
    }


def test_times_of_an_archive_are_those_of_the_download(tmp_path):
    collect(download(tmp_path, CANVAS, True), "hw1", tmp_path / "canvas")
    assert {name: timing for name, (timing, _) in timings(tmp_path / "canvas").items()} == {
        "101": "in time",
        "102": "late",
        "103": "in time",
    }
    moodle = collect(download(tmp_path, MOODLE, True), "hw1", tmp_path / "moodle")
    assert {timing for timing, _ in timings(tmp_path / "moodle").values()} == {"unknown"}
    assert moodle.untimed == 4


WORKSHEET = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last "
    "modified (submission),Last modified (grade),Feedback comments\n"
    'Participant 101,Ann Able,ann@uni.example,Submitted for grading,,7.00,Yes,"Wednesday, 30 '
    'September 2026, 2:14 PM",-,\n'
    'Participant 102,Renée O Neil,,Submitted for grading,,7.00,Yes,"Thursday, 1 October 2026, 9:00 '
    'AM","Friday, 2 October 2026, 9:00 AM",\n'
    "Participant 105,Eva Eve,eva@uni.example,No submission,,7.00,Yes,-,-,\n"
)


def test_times_and_absent_students_from_the_worksheet(tmp_path):
    (tmp_path / "sheet.csv").write_text(WORKSHEET, encoding="utf-8")
    archive = download(tmp_path, MOODLE, True)
    collected = collect(archive, "hw1", tmp_path / "in", tmp_path / "sheet.csv")
    assert collected.absent == ["eva@uni.example"] and collected.untimed == 2
    found = timings(tmp_path / "in")
    assert found["ann@uni.example"] == ("known", time.mktime((2026, 9, 30, 14, 14, 0, 0, 0, -1)))
    assert found["Renée_O Neil_102"][1] == time.mktime((2026, 10, 1, 9, 0, 0, 0, 0, -1))
    assert found["Bob_Bee_103"][0] == "unknown"
    assert "eva@uni.example" in students(tmp_path / "in")


@pytest.mark.parametrize(
    "zone, options, said",
    [
        ("", [], "zone UTC+03:00, by assignments/hw1/assignment.toml"),
        ('zone = "Asia/Tokyo"\n', ["--zone", "Europe/Moscow"], "zone Europe/Moscow, by --zone"),
        ('zone = "Europe/Moscow"\n', [], "zone Europe/Moscow, by assignments/hw1/assignment.toml"),
    ],
)
def test_a_time_of_the_zone_of_the_course_is_not_late(
    tmp_path, monkeypatch, capsys, zone, options, said
):
    """On a server, whose clock is UTC, 23:30 in Moscow was a day late for 23:59 there."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TZ", "UTC")
    time.tzset()
    homework = an_assignment(
        tmp_path, f'{zone}problems = ["1.15"]\ndue = 2026-09-30T23:59:00+03:00\n'
    )
    (tmp_path / "sheet.csv").write_text(WORKSHEET.replace("2:14 PM", "11:30 PM"), encoding="utf-8")
    path = download(tmp_path, MOODLE, True)
    command = ["collect", str(path), "hw1", "--worksheet", "sheet.csv", *options]
    try:
        app(command, standalone_mode=False)
        _, submitted = timings(tmp_path / "submitted")["ann@uni.example"]
        assert homework.due.timestamp() - submitted == 29 * 60
        assert f"sheet.csv: times are of the {said}" in capsys.readouterr().out
        (tmp_path / "assignments" / "hw1" / "assignment.toml").unlink()
        app(command[:5], standalone_mode=False)
        assert "sheet.csv: times are of this computer's zone, UTC; if" in capsys.readouterr().out
    finally:
        monkeypatch.undo()
        time.tzset()


@pytest.mark.parametrize(
    "options, message",
    [
        (["--zone", "Europe/Moscow"], "--zone is for the times in a --worksheet"),
        (
            ["--worksheet", "sheet.csv", "--zone", "MSK"],
            "--zone is 'MSK', and is to be the name of",
        ),
    ],
)
def test_a_zone_that_cannot_be_used(tmp_path, options, message):
    with pytest.raises(UserError, match=message):
        app(["collect", str(tmp_path), "hw1", *options], standalone_mode=False)


def test_a_worksheet_that_comes_later_gives_the_times(tmp_path):
    (tmp_path / "sheet.csv").write_text(WORKSHEET, encoding="utf-8")
    archive = download(tmp_path, MOODLE, True)
    collect(archive, "hw1", tmp_path / "in")
    collect(archive, "hw1", tmp_path / "in", tmp_path / "sheet.csv")
    found = timings(tmp_path / "in")
    assert found["Ann Able_101"][0] == "known", "who was collected under a name keeps it"
    assert len(found) == 3 and len(list(find(tmp_path / "in"))) == 4
    (tmp_path / "later.csv").write_text(WORKSHEET.replace("2:14 PM", "5:14 PM"), encoding="utf-8")
    collect(archive, "hw1", tmp_path / "in", tmp_path / "later.csv")
    times = [e.submitted for e in find(tmp_path / "in") if e.student == "Ann Able_101"]
    assert times[1] - times[0] == 3 * 3600, "handed in again"
    assert collect(archive, "hw1", tmp_path / "in").untimed == 2, "of the others it is known"
    assert len(list(find(tmp_path / "in"))) == 5, "nothing is learnt without the worksheet"


def test_a_worksheet_of_another_assignment_is_refused(tmp_path):
    (tmp_path / "sheet.csv").write_text(WORKSHEET.replace("Participant 1", "Participant 9"))
    with pytest.raises(InputError, match="sheet.csv is of another assignment"):
        collect(download(tmp_path, MOODLE, True), "hw1", tmp_path / "in", tmp_path / "sheet.csv")
    assert not (tmp_path / "in").exists()


def test_a_due_date_that_canvas_moved(tmp_path):
    """The newest download says who is late, and an absent student who came is not absent."""
    for name, timing in (("bee_102_9_f.ipynb", "in time"), ("bee_LATE_102_9_f.ipynb", "late")) * 2:
        files_of(tmp_path, [name])
        assert timings(tmp_path / "in")["102"][0] == timing


def test_a_time_that_a_lecturer_writes_for_canvas(tmp_path):
    """It stays also when the download is collected again."""
    files_of(tmp_path, ["bee_LATE_102_9_f.ipynb"])
    path = tmp_path / "in" / ledger.NAME
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('"","yes"', '"2026-10-02 10:00:00+03:00","yes"'), encoding="utf-8")
    when = datetime.fromisoformat("2026-10-02T10:00:00+03:00").timestamp()
    for _ in range(2):
        assert timings(tmp_path / "in") == {"102": ("known", when)}
        files_of(tmp_path, ["bee_LATE_102_9_f.ipynb"])


def test_a_name_is_printed_as_it_is(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    path = packed(tmp_path, {"a_1_9_f.ipynb": "{}", ":skull: [red].txt": "x"})
    app(["collect", str(path), "hw1"], standalone_mode=False)
    assert "left aside: :skull: [red].txt: its name" in capsys.readouterr().out


# What: damaged, encrypted and packed files


@pytest.mark.parametrize(
    "kind, why",
    [
        ("crc", "it is damaged (Bad CRC-32"),
        ("encrypted", "it is encrypted"),
        ("method", "it is compressed in a way that cannot be read here"),
        ("deflate", "it is damaged ("),
        ("header", "it is damaged ("),
    ],
)
def test_one_entry_that_cannot_be_read_stops_nothing(tmp_path, kind, why):
    path = tmp_path / "all.zip"
    content = json.dumps(notebook("1.15", {"a_region": "k1 > 0"}))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as into:
        for number in (1, 2, 3):
            method = zipfile.ZIP_DEFLATED if kind == "deflate" else zipfile.ZIP_STORED
            entry = zipfile.ZipInfo(f"s_{number}_9_ch1-p15.ipynb", WHEN)
            into.writestr(entry, f"{number}{content}", method)
        bad = into.infolist()[1]
        start = bad.header_offset + 30 + len(bad.filename)
    raw = bytearray(path.read_bytes())
    directory = raw.index(b"PK\x01\x02", raw.index(b"PK\x01\x02") + 4)
    if kind == "crc":
        raw[start] ^= 1
    elif kind == "deflate":
        raw[start : start + 40] = b"\xff" * 40
    elif kind == "encrypted":
        raw[bad.header_offset + 6] |= 1
        raw[directory + 8] |= 1
    elif kind == "method":
        raw[bad.header_offset + 8] = raw[directory + 10] = 97
    else:
        raw[bad.header_offset] = 0
    path.write_bytes(raw)
    collected = collect(path, "hw1", tmp_path / "in")
    assert list(collected.files) == ["1", "3"]
    ((where, reason),) = collected.aside
    assert where == "s_2_9_ch1-p15.ipynb" and reason.startswith(why)
    (aside,) = (entry for entry in find(tmp_path / "in") if isinstance(entry, LeftAside))
    assert (aside.student, aside.assignment, aside.reason) == ("2", "hw1", reason)
    good = {f"s_{number}_9_ch1-p15.ipynb": content for number in (2, 3)}
    collect(packed(tmp_path, good, "again.zip"), "hw1", tmp_path / "in")
    assert not any(isinstance(entry, LeftAside) for entry in find(tmp_path / "in"))


def a_zip(files):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as into:
        for path, content in files.items():
            into.writestr(path, content)
    return buffer.getvalue()


def test_a_zip_of_notebooks_is_opened_by_the_same_rules(tmp_path):
    content = json.dumps(notebook("1.15", {"a_region": "k1 > 0"}))
    inside = {
        "work/ch1-p15.ipynb": content,
        "../../ch1-p17.ipynb": content,
        "Bob_2_assignsubmission_file_/x.ipynb": content,
        ".ipynb_checkpoints/ch1-p15-checkpoint.ipynb": content,
        "__MACOSX/work/._ch1-p15.ipynb": "x",
        "photo.png": "x",
    }
    path = packed(tmp_path, {"Ann_1_assignsubmission_file_/work.zip": a_zip(inside)})
    collect(path, "hw1", tmp_path / "in")
    assert handed_in(tmp_path) == {
        "all.zip",
        *(
            f"in/Ann_1/hw1/{name}"
            for name in ("work.zip", "ch1-p15.ipynb", "ch1-p17.ipynb", "x.ipynb")
        ),
    }
    entries = list(find(tmp_path / "in"))
    assert {entry.timing for entry in entries if isinstance(entry, Submission)} == {"unknown"}
    (aside,) = (entry for entry in entries if isinstance(entry, LeftAside))
    assert aside.is_extra and "work.zip" in aside.reason


@pytest.mark.parametrize(
    "content, why",
    [
        (b"no archive", "it is no .zip archive that can be opened"),
        (a_zip({f"{k}.ipynb": "" for k in range(101)}), "it holds more than 100 notebooks"),
        (a_zip({"a.ipynb": "x" * 2000}), "MB of them"),
        (a_zip(dict.fromkeys(map(str, range(10_001)), "")), "it holds more than 10000 files"),
    ],
    ids=["no archive", "notebooks", "size", "files"],
)
def test_a_zip_that_cannot_be_opened_is_named(tmp_path, monkeypatch, content, why):
    monkeypatch.setattr("workbook.grading.course.archives.MAX_FILE", 1000)
    path = packed(tmp_path, {"Ann_1_assignsubmission_file_/work.zip": content})
    collected = collect(path, "hw1", tmp_path / "in")
    assert collected.files == {"Ann_1": ["work.zip"]} and why in collected.aside[0][1]
    assert handed_in(tmp_path / "in") == {"Ann_1/hw1/work.zip"}


def test_what_all_archives_of_a_student_unpack_to_is_limited(tmp_path, monkeypatch):
    """Each of them is small, packed, and holds no more than one archive may."""
    monkeypatch.setattr("workbook.grading.course.collecting.MAX_STUDENT", 2 * 2**20)
    folder = "Ann_1_assignsubmission_file_"
    large = {f"{folder}/{k}.zip": packed_zeros(f"{k}.ipynb") for k in "abc"}
    other = {"Bob_2_assignsubmission_file_/ch1-p15.ipynb": "{}"}
    path = packed(tmp_path, large | other)
    assert path.stat().st_size < 10_000
    collected = collect(path, "hw1", tmp_path / "in")
    assert collected.files == {
        "Ann_1": ["a.zip", "a.ipynb", "b.zip", "c.zip"],
        "Bob_2": ["ch1-p15.ipynb"],
    }
    assert [reason for _, reason in collected.aside] == [
        "with it the student's files would have 3 MB in all, unpacked; up to 2 MB of a student "
        "are collected from a download"
    ] * 2
    asides = [entry for entry in find(tmp_path / "in") if isinstance(entry, LeftAside)]
    assert sum("2 MB of a student" in entry.reason for entry in asides) == 2


def packed_zeros(name):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as into:
        into.writestr(name, b"0" * (3 * 2**19))
    return buffer.getvalue()


def test_a_time_that_a_student_hands_in_counts_for_nothing(tmp_path):
    """Neither nbgrader's file nor a ledger: both are a student's, not a system's."""
    content = json.dumps(notebook("1.15", {}))
    folder = "Ann_1_assignsubmission_file_"
    collect(
        packed(
            tmp_path,
            {
                f"{folder}/ch1-p15.ipynb": content,
                f"{folder}/timestamp.txt": "2020-01-01 00:00:00 UTC",
                f"{folder}/ledger.csv": "assignment,student",
            },
        ),
        "hw1",
        tmp_path / "in",
    )
    assert timings(tmp_path / "in")["Ann_1"][0] == "unknown"
    (tmp_path / "in" / "Ann_1" / "hw1" / "mine.ipynb").write_text(content)
    times = [e.submitted for e in find(tmp_path / "in") if isinstance(e, Submission)]
    assert len(times) == 2 and min(times) > time.time() - 3600


@pytest.mark.parametrize(
    "path, is_extra",
    [
        ("Ann_1_assignsubmission_onlinetext/onlinetext.html", True),
        ("Ann_1_assignsubmission_file/photo.png", True),
        ("Ann_1_assignsubmission_file/ch1-p17.ipynb", False),
        ("Ann_1_assignsubmission_file/work.zip", False),
    ],
)
def test_only_what_may_be_a_notebook_makes_a_student_wait(tmp_path, monkeypatch, path, is_extra):
    monkeypatch.setattr("workbook.grading.course.collecting.MAX_FILE", 100)
    good = "Ann_1_assignsubmission_file/ch1-p15.ipynb"
    collect(packed(tmp_path, {good: "{}", path: "x" * 101}), "hw1", tmp_path / "in")
    (aside,) = (entry for entry in find(tmp_path / "in") if isinstance(entry, LeftAside))
    assert (aside.student, aside.is_extra) == ("Ann_1", is_extra)


def test_a_collected_folder_that_was_renamed_is_reported(tmp_path):
    """Else its files would be late by the time of copying, and their student absent."""
    files_of(tmp_path, ["bee_102_9_f.ipynb"])
    (tmp_path / "in" / "102").rename(tmp_path / "in" / "bob")
    aside = [entry for entry in find(tmp_path / "in") if isinstance(entry, LeftAside)]
    assert [(e.student, e.path) for e in aside] == [("102", "102/hw1/f.ipynb")]
    assert "ledger.csv has it" in aside[0].reason
