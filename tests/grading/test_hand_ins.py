"""What a student hands in at once is one attempt at each problem, however many files it has."""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, hand_in, notebook
from test_collecting import WORKSHEET, a_zip, packed

from workbook.grading.course import course
from workbook.grading.course.collecting import collect
from workbook.grading.course.submissions import find

MOODLE = "Ann Able_101_assignsubmission_file/"


def text(answer, problem="1.15"):
    return json.dumps(notebook(problem, {"a_region": answer}))


def attempts(folder):
    """Return ([(student, problem, the files that are an attempt)], {file aside: reason})."""
    homework = an_assignment(folder, 'problems = ["1.15", "1.17"]')
    copies, aside = course._by_attempt(list(find(folder / "in")), {"hw1": homework}, {}, {})
    names = sorted(
        (student, problem, *(Path(each.path).name for each in submissions))
        for (student, _, problem, _), submissions in copies.items()
    )
    return names, {Path(entry.path).name: entry for entry in aside}


def collected(folder, files, *more):
    collect(packed(folder, files), "hw1", folder / "in", *more)
    return attempts(folder)


def test_many_notebooks_of_one_problem_are_one_attempt(tmp_path):
    """With sixteen yes or no answers could be guessed, which only the grading judges."""
    guesses = {f"guess{k:02d}.ipynb": text(f"k1 > {k}") for k in range(16)}
    names, aside = collected(tmp_path, {MOODLE + "all.zip": a_zip(guesses)})
    assert names == [("Ann Able_101", "1.15", "guess15.ipynb")]
    others = [aside[name] for name in guesses if name != "guess15.ipynb"]
    assert {entry.reason for entry in others} == {
        "of what is handed in at once one file a problem counts, here guess15.ipynb"
    }
    assert all(entry.is_extra and entry.student == "Ann Able_101" for entry in others)


@pytest.mark.parametrize(
    "files, counts",
    [
        (["eve_7_9_b.ipynb", "eve_7_10_a.ipynb"], "a.ipynb"),
        (["eve_7_10_b.ipynb", "eve_7_9_z.ipynb"], "b.ipynb"),
        ([MOODLE + "ch1-p15.ipynb", MOODLE + "ch1-p15 (1).ipynb"], "ch1-p15.ipynb"),
        ([MOODLE + "ch1-p15.ipynb", MOODLE + "ch1-p15-Copy1.ipynb"], "ch1-p15.ipynb"),
        ([MOODLE + "ch1-p15.ipynb", MOODLE + "ch1-p15_final.ipynb"], "ch1-p15_final.ipynb"),
        ([MOODLE + "1/a.ipynb", MOODLE + "2/a.ipynb"], "a (2).ipynb"),
    ],
)
def test_which_of_two_counts(tmp_path, files, counts):
    """By the number that Canvas gave, else by name; never by a time in a student's archive."""
    contents = {name: text(f"k1 > {k}") for k, name in enumerate(files)}
    names, aside = collected(tmp_path, contents)
    assert [name for _, _, name in names] == [counts] and len(aside) == 1


def test_a_file_goes_before_one_in_an_archive_and_before_one_that_is_broken(tmp_path):
    files = {
        MOODLE + "ch1-p15.ipynb": text("k1 > 0"),
        MOODLE + "old.zip": a_zip({"z.ipynb": text("k1 > 1")}),
        MOODLE + "z15.ipynb": "",
        MOODLE + "ch1-p15_broken.ipynb": "{}",
        MOODLE + "ch1-p17.ipynb": text("k1 > 0", "1.17"),
    }
    names, aside = collected(tmp_path, files)
    student = "Ann Able_101"
    assert names == [(student, "1.15", "ch1-p15.ipynb"), (student, "1.17", "ch1-p17.ipynb")]
    assert {"z.ipynb", "ch1-p15_broken.ipynb"} < set(aside)


def test_a_new_file_beside_the_old_one_is_the_next_attempt(tmp_path):
    """Moodle keeps what was handed in before, and then has all of it at the new time."""
    (tmp_path / "sheet.csv").write_text(WORKSHEET, encoding="utf-8")
    first = {MOODLE + "ch1-p15.ipynb": text("k1 > 0")}
    collected(tmp_path, first, tmp_path / "sheet.csv")
    (tmp_path / "sheet.csv").write_text(WORKSHEET.replace("2:14", "5:14"), encoding="utf-8")
    second = first | {MOODLE + "ch1-p15 (new).ipynb": text("k1 > 1")}
    names, aside = collected(tmp_path, second, tmp_path / "sheet.csv")
    student = "ann@uni.example"
    assert sorted(names) == [
        (student, "1.15", "ch1-p15 (new).ipynb"),
        (student, "1.15", "ch1-p15.ipynb"),
    ]
    assert not any(aside)


def test_two_downloads_in_one_second_are_two_attempts(tmp_path):
    for k in range(3):
        names, aside = collected(tmp_path, {MOODLE + "ch1-p15.ipynb": text(f"k1 > {k}")})
    assert len(names) == 3 and not aside


def test_files_without_a_system_are_attempts_by_their_times(tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "submitted").symlink_to(tmp_path / "in")
    for k in range(2):
        path = hand_in(
            tmp_path, "ann", "1.15", {"a_region": f"k1 > {k}"}, at=5.0, name=f"{k}.ipynb"
        )
    assert len(attempts(tmp_path)[0]) == 2
    (path.parent / "timestamp.txt").write_text("2026-09-30 12:00:00 UTC")
    names, aside = attempts(tmp_path)
    assert names == [("ann", "1.15", "1.ipynb")] and list(aside) == ["0.ipynb"]
