"""The ledger: what a system says of each file stays, also through a spreadsheet."""

import sys
from datetime import datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import hand_in

from workbook.grading.course import ledger, submissions
from workbook.grading.course.assignment import InputError
from workbook.grading.course.ledger import Entry, Ledger
from workbook.grading.course.transaction import transaction

NOON = datetime(2026, 9, 30, 12).timestamp()
OFFSET = datetime(2026, 9, 30, 12).astimezone().isoformat()[-6:]
COLLECTED = datetime(2026, 10, 2, 9).timestamp()


def entry(file="a.ipynb", source="x/a.ipynb", **facts):
    return Entry(
        "hw1",
        facts.pop("student", "ann"),
        "101",
        "Ann",
        file,
        source=source if file or facts.get("trouble") else "",
        collected=COLLECTED,
        **facts,
    )


def added(folder, *entries):
    """Add entries, each in a run of its own, and return all that are there."""
    for each in entries:
        with transaction(folder, ledger.NAME) as current:
            kept = Ledger(folder)
            kept.add(each)
            current.record(kept.text())
    return ledger.read(folder)


@pytest.mark.parametrize(
    "name",
    [
        "ann",
        "=cmd",
        "'=cmd",
        "''x",
        "@SUM(1)",
        "-1",
        "-1+1",
        "+380",
        'q"u,o;te',
        "עדה",
        "\tx",
        "line\nend",
    ],
)
def test_every_name_comes_back(tmp_path, name):
    one = Entry("hw1", name, name, name, name, NOON, None, name, name, COLLECTED, name)
    assert added(tmp_path, one) == [one]
    text = (tmp_path / ledger.NAME).read_text(encoding="utf-8-sig")
    assert not any(cell.startswith(("=", "@", "\t", "-1+")) for cell in text.split('"'))


def test_through_a_spreadsheet(tmp_path):
    """It saves with semicolons, adds a column and moves others."""
    written = added(tmp_path, entry(submitted=NOON), entry("b.ipynb", late=True))
    text = (tmp_path / ledger.NAME).read_text(encoding="utf-8-sig").replace('"', "")
    lines = [";".join(["remark", *reversed(line.split(","))]) for line in text.splitlines()]
    (tmp_path / ledger.NAME).write_text("\n".join(lines), encoding="utf-8")
    assert ledger.read(tmp_path) == written


def test_through_a_russian_spreadsheet(tmp_path):
    written = added(tmp_path, entry(submitted=NOON, student="Иванов Пётр_101"))
    text = (tmp_path / ledger.NAME).read_text(encoding="utf-8-sig").replace('"', "")
    (tmp_path / ledger.NAME).write_bytes(text.replace(",", ";").encode("cp1251"))
    assert ledger.read(tmp_path) == written


@pytest.mark.parametrize(
    "old, new",
    [
        ("student", "who"),
        ("2026-09-30", "30.9.26"),
        ('"yes"', '"perhaps"'),
        (f"12:00:00{OFFSET}", "12:00:00"),
    ],
)
def test_a_ledger_that_cannot_be_read(tmp_path, old, new):
    added(tmp_path, entry(submitted=NOON), entry("b.ipynb", late=True))
    path = tmp_path / ledger.NAME
    path.write_text(path.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    with pytest.raises(InputError, match="ledger.csv is not as workbook collect wrote it"):
        list(submissions.find(tmp_path))


UNTIMED, TIMED, LATER = entry(), entry(submitted=NOON), entry(submitted=NOON + 60)
ABSENT, TROUBLE = entry(""), entry("", trouble="it is damaged")


@pytest.mark.parametrize(
    "entries, kept",
    [
        ([UNTIMED, UNTIMED], [UNTIMED]),
        ([UNTIMED, TIMED], [TIMED]),
        ([TIMED, UNTIMED], [TIMED]),
        ([TIMED, entry(late=True)], [TIMED]),
        ([TIMED, TIMED], [TIMED]),
        ([TIMED, LATER, TIMED], [TIMED, LATER]),
        ([entry(late=False), entry(late=True)], [entry(late=True)]),
        ([entry(late=False), entry(late=False, source="y/a.ipynb")], "both"),
        ([ABSENT, TIMED], [TIMED]),
        ([TIMED, ABSENT], [TIMED]),
        ([ABSENT, ABSENT], [ABSENT]),
        ([ABSENT, TROUBLE], [TROUBLE]),
        ([TROUBLE, ABSENT], [TROUBLE]),
        ([TROUBLE, TROUBLE], [TROUBLE]),
        ([TROUBLE, TIMED], [TIMED]),
        ([TIMED, TROUBLE], [TIMED]),
        ([TROUBLE, entry("b.ipynb", "x/b.ipynb")], "both"),
        ([TIMED, entry(submitted=NOON, student="bob")], "both"),
    ],
)
def test_what_is_known_better_is_kept(tmp_path, entries, kept):
    assert added(tmp_path, *entries) == (entries if kept == "both" else kept)


@pytest.mark.parametrize(
    "facts, timing, when",
    [
        ({"submitted": NOON}, "known", NOON),
        ({"late": True}, "late", COLLECTED),
        ({"late": False}, "in time", COLLECTED),
        ({}, "unknown", COLLECTED),
    ],
)
def test_the_time_of_a_collected_file_is_that_of_the_ledger(tmp_path, facts, timing, when):
    path = hand_in(tmp_path, "ann", "1.15", {}, at=5.0)
    added(tmp_path / "submitted", entry(path.name, **facts))
    (found,) = submissions.find(tmp_path / "submitted")
    assert (found.timing, found.submitted) == (timing, when)


@pytest.mark.parametrize(
    "note, timing, when",
    [
        ("2026-09-30 12:00:00.5 UTC\n", "known", 1790769600.5),
        ("2026-09-30 12:00:00", "known", 1790769600.0),
        ("2026-09-30T15:00:00+03:00", "known", 1790769600.0),
        ("2026-09-30 12:00:00 EST", "unknown", 5.0),
        ("", "unknown", 5.0),
        ("9" * 1000, "unknown", 5.0),
        (None, "known", 5.0),
    ],
)
def test_the_time_that_nbgrader_notes(tmp_path, note, timing, when):
    path = hand_in(tmp_path, "ann", "1.15", {}, at=5.0)
    if note is not None:
        (path.parent / "timestamp.txt").write_text(note)
    (found,) = submissions.find(tmp_path / "submitted")
    assert (found.timing, found.submitted) == (timing, when)


def test_other_files_are_listed(tmp_path):
    path = hand_in(tmp_path, "ann", "1.15", {})
    for k in range(7):
        (path.parent / f"photo{k}.png").touch()
    (path.parent / ".DS_Store").touch()
    _, aside = submissions.find(tmp_path / "submitted")
    assert (aside.student, aside.assignment, aside.is_extra) == ("ann", "hw1", True)
    assert "photo0.png, photo1.png, photo2.png, photo3.png, photo4.png, and 2 more" in aside.reason
