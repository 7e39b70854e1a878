"""Objections of students, and the replies to them."""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import graded

from workbook.checks.contract.verdict import RIGHT, WRONG
from workbook.grading import commands
from workbook.grading.course import objections, submissions
from workbook.grading.reports.scores import scores

HOMEWORK = 'problems = ["1.17"]\n'


@pytest.fixture
def grade(tmp_path, store, homework):
    """Grade what lies there, at a time."""
    graded(store, "ann", "1.17", {"a_region": RIGHT, "b_region": WRONG})

    def grade_now(when):
        return commands.write(
            tmp_path / "graded" / "hw1",
            homework,
            scores(store, homework),
            when,
            submitted=tmp_path / "submitted",
        )[1]

    return grade_now


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def test_an_objection_and_its_reply_are_kept(tmp_path, grade):
    objection = tmp_path / "submitted" / "ann" / "hw1" / "Objection b.txt"
    replies = tmp_path / "graded" / "hw1" / "replies" / "ann.md"
    page = tmp_path / "graded" / "hw1" / "feedback" / "ann.html"
    write(objection, "b is <right>:\nsee page 3\x1b")
    assert grade("2026-10-05") == ["ann"]
    assert "b is &lt;right&gt;:\nsee page 3\\x1b" in page.read_text()
    assert "has not replied yet" in page.read_text()
    write(replies, "It is not: k = 1.")
    assert grade("2026-10-06") == [] and "It is not: k = 1." in page.read_text()
    # A second objection stands beside the first, and the old reply is not its reply.
    write(objection, "But k > 0!")
    assert grade("2026-10-07") == ["ann"]
    write(replies, "You are right.")
    assert grade("2026-10-08") == []
    objection.unlink()
    replies.unlink()
    assert grade("2026-10-09") == []
    record = json.loads((tmp_path / "graded" / "hw1" / "grades.json").read_text())["objections"]
    assert [(o["noted"], o["reply"], o["replied"]) for o in record] == [
        ("2026-10-05", "It is not: k = 1.", "2026-10-06"),
        ("2026-10-07", "You are right.", "2026-10-08"),
    ]
    assert "But k &gt; 0!" in (tmp_path / "graded" / "hw1" / "summary.html").read_text()


def test_an_objection_is_no_work_that_waits(tmp_path):
    write(tmp_path / "ann" / "hw1" / "objection.md", "x")
    (entry,) = submissions.find(tmp_path)
    assert entry.student == "", "nothing of hers is missing"


def test_a_link_to_a_foreign_file_is_not_read(tmp_path):
    write(tmp_path / "secret", "x")
    folder = tmp_path / "submitted" / "ann" / "hw1"
    folder.mkdir(parents=True)
    (folder / "objection.md").symlink_to(tmp_path / "secret")
    assert objections.handed_in(tmp_path / "submitted", "hw1") == []


def test_a_long_objection_is_cut(tmp_path):
    write(tmp_path / "ann" / "hw1" / "objection.md", "x" * 10**6)
    ((_, text),) = objections.handed_in(tmp_path, "hw1")
    assert len(text) < 21_000 and text.endswith(" ...")
