"""assignment.toml: its fields, and an error of one line for everything wrong in it."""

import datetime
import json
import re
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, write_assignment

from workbook import checks
from workbook.checks.contract.check_cells import marked
from workbook.grading.course import assignment as assignments
from workbook.grading.course import handing_out, submissions
from workbook.grading.course.assignment import AssignmentError
from workbook.grading.course.policy import LateRule
from workbook.notebooks import exercises

FULL = """
title = "Homework 1: stability"
problems = ["1.4", "1.15"]
due = 2026-10-01T23:59:00+03:00
attempt = "last"
attempts = 3

[points]
"1.15" = 10
"1.4.a_matrix" = 2
"1.4.a_stable" = 0
"""


def test_all_fields(tmp_path):
    homework = an_assignment(tmp_path, FULL)
    assert (homework.name, homework.title) == ("hw1", "Homework 1: stability")
    assert homework.problems == ("1.4", "1.15") and list(homework.points) == ["1.4", "1.15"]
    assert homework.due == datetime.datetime(2026, 10, 1, 20, 59, tzinfo=datetime.UTC)
    assert (homework.attempt, homework.attempts) == ("last", 3)


def test_optional_fields(tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.15"]')
    assert (homework.title, homework.due, homework.attempt, homework.attempts) == (
        "hw1",
        None,
        "best",
        None,
    )
    assert homework.points == {
        "1.15": dict.fromkeys(["a_region", "b_region", "c_region", "d_region", "e_region"], 1.0)
    }
    assert homework.points == assignments.of_problems("hw1", ["1.15"]).points


def test_lateness_and_extensions(tmp_path):
    homework = an_assignment(
        tmp_path,
        f'{DUE}[late]\nper_day = 0.1\n[extensions]\n"ann@uni.example" = 2026-10-08T12:00:00Z\n',
    )
    assert homework.policy.late == LateRule(0.1) and homework.policy.due_of("bob") == homework.due
    assert homework.policy.due_of("ann@uni.example") - homework.due == datetime.timedelta(days=7)


def test_points(tmp_path):
    homework = an_assignment(tmp_path, FULL)
    assert set(homework.points["1.15"].values()) == {2.0}, (
        "a problem's points are shared equally by its answers"
    )
    assert homework.points["1.4"]["a_matrix"] == 2 and homework.points["1.4"]["a_stable"] == 0
    assert homework.points["1.4"]["b_rate"] == 1, "an answer that is not named is worth 1"
    assert homework.max_points == 10 + 2 + 0 + 6


def test_points_of_named_answers_are_part_of_the_problems(tmp_path):
    homework = an_assignment(
        tmp_path, 'problems = ["1.15"]\n[points]\n"1.15" = 10\n"1.15.a_region" = 6'
    )
    assert homework.points["1.15"]["a_region"] == 6 and homework.points["1.15"]["e_region"] == 1
    assert homework.max_points == pytest.approx(10)
    whole = an_assignment(
        tmp_path,
        'problems = ["1.17"]\n[points]\n"1.17" = 5\n"1.17.a_region" = 2\n"1.17.b_region" = 3',
    )
    assert whole.points["1.17"] == {"a_region": 2, "b_region": 3}


def test_the_name_is_that_of_the_folder(tmp_path, monkeypatch):
    path = write_assignment(tmp_path, 'problems = ["1.15"]', name="week 2")
    monkeypatch.chdir(path.parent)
    assert assignments.read("assignment.toml").name == "week 2"


ONE = 'problems = ["1.15"]\n'
DUE = f"{ONE}due = 2026-10-01T12:00:00Z\n"


@pytest.mark.parametrize(
    "text, message",
    [
        ("", "problems is a list"),
        ("problems = [1.15]", "problems is a list of numbers in quotes"),
        ('problems = "1.15"', "problems is a list of numbers in quotes"),
        ("problems = []", "problems is a list of numbers in quotes"),
        ('problems = ["1.15", "1.15"]', "names a problem twice"),
        ('problems = ["9.99"]', "no problem 9.99"),
        ('problems = ["1.04"]', "it is written 1.4"),
        ('problems = ["../ch1/p15"]', "there is no problem"),
        (
            ONE + "titel = 'x'",
            "unknown field titel; there are attempt, attempts, budget, by_hand, direction, due, early, exam, "
            "exemptions, extensions, grace_days, kept_for_grading, labels, late, points, pool, problems, "
            "title, zone",
        ),
        (ONE + "title = 3", "title is one line of text"),
        (ONE + 'title = " "', "title is one line of text"),
        (ONE + 'title = "two\\nlines"', "title is one line of text"),
        (ONE + 'due = "tomorrow"', "due is a date with time and zone"),
        (ONE + "due = 2026-10-01", "due is a date with time and zone"),
        (ONE + "due = 2026-10-01T23:59:00", "due is a date with time and zone"),
        (ONE + 'zone = "Moscow"', "zone is 'Moscow', and is to be the name of a time zone"),
        (ONE + 'zone = "../Europe"', "zone is '../Europe', and is to be the name of a time zone"),
        (ONE + "zone = 3", "zone is 3, and is to be the name of a time zone"),
        (ONE + "due = 0001-01-01T00:00:00+03:00", "due is a date of our time"),
        (ONE + 'attempt = "first"', 'attempt is "best" or "last"'),
        (ONE + "attempt = [1]", 'attempt is "best" or "last"'),
        (ONE + "attempts = 0", "attempts is a whole number from 1 up"),
        (ONE + "attempts = true", "attempts is a whole number from 1 up"),
        (ONE + "attempts = 1.5", "attempts is a whole number from 1 up"),
        (ONE + 'direction = "false"', "direction is true or false"),
        (
            ONE + 'kept_for_grading = ["1.15.z"]',
            "kept_for_grading is a list of problems or answers",
        ),
        (ONE + "points = 5", "points is a table"),
        (ONE + "[points]\n1.15 = 10", "in points a problem stands in quotes"),
        (ONE + '[points]\n"1.15" = -1', 'points."1.15" is a number from 0 up'),
        (ONE + '[points]\n"1.15" = "ten"', 'points."1.15" is a number from 0 up'),
        (ONE + '[points]\n"1.15" = nan', 'points."1.15" is a number from 0 up'),
        (ONE + '[points]\n"1.15" = inf', 'points."1.15" is a number from 0 up'),
        (ONE + '[points]\n"1.15" = true', 'points."1.15" is a number from 0 up'),
        (ONE + '[points]\n"1.4" = 1', 'points."1.4" names neither a problem of the assignment'),
        (ONE + '[points]\n"1.15.z_region" = 1', 'points."1.15.z_region" names neither'),
        (ONE + '[points]\n"a_region" = 1', 'points."a_region" names neither'),
        (
            ONE + '[points]\n"1.15" = 1\n"1.15.a_region" = 2',
            'points."1.15" is 1, but its answers named below have 2',
        ),
        (
            'problems = ["1.17"]\n[points]\n"1.17" = 9\n"1.17.a_region" = 2\n"1.17.b_region" = 3',
            "is 9, but its answers named below have 5",
        ),
        (DUE + "late = 0.1", "late is a table"),
        (DUE + "[late]\nfloor = 0.5", "late is a table: [late], and below it per_day"),
        (DUE + "[late]\nper_day = 0.1\nper_week = 1", "late is a table"),
        (DUE + "[late]\nper_day = 10", "late.per_day is a number from 0 to 1"),
        (DUE + "[late]\nper_day = true", "late.per_day is a number from 0 to 1"),
        (DUE + "[late]\nper_day = 0.1\nfloor = nan", "late.floor is a number from 0 to 1"),
        (DUE + "[late]\nper_day = 0.1\ncutoff_days = -1", "late.cutoff_days is a number from 0"),
        (ONE + "[late]\nper_day = 0.1", "late needs a due date"),
        (DUE + 'extensions = "ann"', "extensions is a table"),
        (DUE + "[extensions]\nann = 2026-10-08", 'extensions."ann" is a date with time and zone'),
        (DUE + "[extensions]\nann = 2026-09-30T00:00:00Z", 'extensions."ann" is before the due'),
        (ONE + "[extensions]\nann = 2026-09-30T00:00:00Z", 'extensions."ann" is before the due'),
        (DUE + "[late]\nfloor = 0.1", "late is a table"),
        (DUE + "[late]\nper_day = 0.1\nsteps = [[7, 0.8]]", "late is a table"),
        (DUE + "[late]\nsteps = [7, 0.8]", "late.steps is a list of [days, share]"),
        (DUE + "[late]\nsteps = [[7, 0.8], [7, 0.5]]", "late.steps is a list of [days, share]"),
        (DUE + "[late]\nsteps = [[7, 0.5], [9, 0.8]]", "late.steps is a list of [days, share]"),
        (DUE + "[late]\nsteps = [[7, 80]]", "each share in late.steps is a number from 0 to 1"),
        (DUE + "[early]\ndays = 7", "early is a table: [early], and below it days = 7"),
        (DUE + "[early]\ndays = 7\nshare = 0.9", "early.share is a number from 1 to 2"),
        (ONE + "[early]\ndays = 7\nshare = 1.1", "early needs a due date"),
        (ONE + '[labels]\n"extended time" = "ann"', 'labels."extended time" is a list of students'),
        (ONE + '[exemptions]\nann = ["1.17"]', 'exemptions."ann" is a list of problems or answers'),
        (ONE + "[exemptions]\nann = true", 'exemptions."ann" is a list of problems or answers'),
        ("problems = [", "is not TOML in UTF-8"),
        (ONE + ONE, "Cannot overwrite a value"),
    ],
)
def test_errors_are_one_line(tmp_path, text, message):
    path = write_assignment(tmp_path, text)
    with pytest.raises(AssignmentError) as error:
        assignments.read(path)
    assert (
        message in str(error.value)
        and str(path) in str(error.value)
        and "\n" not in str(error.value)
    )


def test_a_file_that_cannot_be_read(tmp_path):
    with pytest.raises(AssignmentError, match="No such file"):
        assignments.read(tmp_path / "assignment.toml")
    (tmp_path / "assignment.toml").write_bytes(b'title = "\xff"')
    with pytest.raises(AssignmentError, match="is not TOML in UTF-8"):
        assignments.read(tmp_path / "assignment.toml")


# A homework to hand out


def test_a_homework_to_hand_out(tmp_path):
    due = datetime.datetime(
        2026, 10, 1, 23, 59, tzinfo=datetime.timezone(datetime.timedelta(hours=3))
    )
    made = handing_out.make(
        tmp_path, "hw1", ["1.4", "1.15"], 'Week 1: "stability" \\ première', due
    )
    assert made == assignments.read(tmp_path / "hw1" / "assignment.toml")
    assert (
        made.title == 'Week 1: "stability" \\ première'
        and made.due == due
        and made.max_points == 13
    )
    assert sorted(path.name for path in (tmp_path / "hw1").iterdir()) == [
        "README.md",
        "assignment.toml",
        "ch1-p04.ipynb",
        "ch1-p15.ipynb",
    ]
    readme = (tmp_path / "hw1" / "README.md").read_text(encoding="utf-8")
    assert (
        "première" in readme
        and "2026-10-01 23:59 (UTC+03:00)" in readme
        and "`ch1-p15.ipynb`: 5 points for 5 answers" in readme
    )


def released_text(exercise, site=""):
    homework = assignments.of_problems("hw1", [exercise.number])
    return handing_out.release(homework, exercise.number, site)


def test_a_handed_out_notebook_is_the_exercise_without_dead_links(tmp_path):
    for exercise in exercises.read_all():
        pristine = json.loads(exercise.path.read_text(encoding="utf-8"))
        for site in ("", "https://example.org/course/"):
            released = json.loads(released_text(exercise, site))
            assert released["metadata"] == pristine["metadata"] and len(released["cells"]) == len(
                pristine["cells"]
            )
            for released_cell, pristine_cell in zip(
                released["cells"], pristine["cells"], strict=True
            ):
                if "check" in pristine_cell["metadata"].get("tags", ()):
                    source = "".join(released_cell["source"])
                    assert source.replace("checks.hide_direction()\n", "") == "".join(
                        pristine_cell["source"]
                    )
                else:
                    assert released_cell == pristine_cell or "places" in released_cell["metadata"]
            text = "".join(cell["source"] for cell in released["cells"])
            assert "_build/" not in text and not re.search(r"\]\(\.", text)
            if site:
                assert (
                    f"[chapter {exercise.number.split('.')[0]}](https://example.org/course/book/ch"
                    in text
                )
                assert "/solutions/" not in text, "homework leads to pages without solutions"
                assert 'page = "https://example.org/course/book/guides/install.html"' in text


def test_the_direction_of_a_wrong_number_is_left_out_unless_the_homework_tells_it(tmp_path):
    for direction in (False, True):
        name = f"hw{direction:d}"
        made = handing_out.make(tmp_path, name, ["5.63"], direction=direction)
        assert made == assignments.read(tmp_path / name / "assignment.toml")
        handed_out = exercises.read(tmp_path / name / "ch5-p63.ipynb")
        assert made.direction == direction and handed_out.cells == made.exercise("5.63").cells
        _, source = handed_out.code("check")[0]
        assert ("checks.hide_direction()\nchecks.report(" in source) is not direction
        for exercise in (exercises.find("5.63"), made.exercise("5.63")):
            assert exercise.sources_to_run([source, "1"]) == [marked(source), "1"]


def test_answers_kept_for_grading_are_not_judged_in_the_notebook(tmp_path):
    made = handing_out.make(tmp_path, "hw1", ["1.15", "1.17"], kept_for_grading=["1.15.e_region"])
    assert made == assignments.read(tmp_path / "hw1" / "assignment.toml")
    assert (made.kept_of("1.15"), made.kept_of("1.17")) == (["e_region"], [])
    assert "Only the grading judges `e_region` of 1.15." in (
        tmp_path / "hw1" / "README.md"
    ).read_text(encoding="utf-8")
    handed_out = exercises.read(tmp_path / "hw1" / "ch1-p15.ipynb")
    sources = [source for _, source in handed_out.code("check")]
    *others, last = made.exercise("1.15").code("check")
    assert sources[:-1] == [source for _, source in others]
    assert "e_region=checks.kept_for_grading(e_region))" in sources[-1]
    assert "stability_region" not in sources[-1] and "stability_region" in last[1]
    # The grader knows the cell as unchanged, and judges the answer by its own.
    assert exercises.find("1.15").sources_to_run(sources) == list(map(marked, sources))
    for answer, status in (("...", "missing"), ("lambda: 1", "invalid"), ("k1 > 0", "unchecked")):
        space = {}
        exec("".join(source + "\n" for _, source in handed_out.code("data")), space)
        exec(f"e_region = {answer}", space)
        with checks.collecting() as verdicts:
            exec(sources[-1], space)
        assert verdicts["e_region"].status == status


def test_a_handed_out_notebook_is_known_without_its_metadata(tmp_path):
    for exercise in exercises.read_all():
        notebook = json.loads(released_text(exercise))
        notebook["metadata"] = {}
        path = tmp_path / "ann" / "hw1" / handing_out.file_name(exercise.number)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(notebook))
    assert {entry.problem for entry in submissions.find(tmp_path)} == {
        exercise.number for exercise in exercises.read_all()
    }


def test_a_homework_is_not_overwritten(tmp_path):
    handing_out.make(tmp_path, "hw1", ["1.15"])
    before = (tmp_path / "hw1" / "assignment.toml").read_bytes()
    with pytest.raises(AssignmentError, match="already there"):
        handing_out.make(tmp_path, "hw1", ["1.4"])
    assert (tmp_path / "hw1" / "assignment.toml").read_bytes() == before


@pytest.mark.parametrize(
    "name, numbers, message",
    [
        ("hw1", ["9.99"], "no problem 9.99"),
        ("hw1", ["1.15", "1.15"], "named twice"),
        ("a/b", ["1.15"], "names a folder"),
        ("..", ["1.15"], "names a folder"),
        ("", ["1.15"], "names a folder"),
        ("x" * 300, ["1.15"], "names a folder"),
        ("grades.sqlite", ["1.15"], "names a folder"),
        ("hw1 ", ["1.15"], "names a folder"),
    ],
)
def test_a_homework_that_cannot_be_made_leaves_nothing_behind(tmp_path, name, numbers, message):
    with pytest.raises(AssignmentError, match=message):
        handing_out.make(tmp_path, name, numbers)
    assert list(tmp_path.iterdir()) == []


def test_an_invalid_title_leaves_nothing_behind(tmp_path):
    with pytest.raises(AssignmentError, match="title is one line of text"):
        handing_out.make(tmp_path, "hw1", ["1.15"], "two\nlines")
    assert list(tmp_path.iterdir()) == []
    assert handing_out.make(tmp_path, "hw1", ["1.15"], "one line").title == "one line"


def test_a_full_disk_leaves_nothing_behind(tmp_path, monkeypatch):
    real = Path.write_text

    def fail(path, *text, **how):
        if path.name == "README.md":
            raise OSError(28, "No space left on device")
        return real(path, *text, **how)

    monkeypatch.setattr(Path, "write_text", fail)
    with pytest.raises(AssignmentError, match="hw1 cannot be written: No space left on device"):
        handing_out.make(tmp_path, "hw1", ["1.15"])
    assert list(tmp_path.iterdir()) == []


def test_due_dates():
    zone = datetime.timezone(datetime.timedelta(hours=3))
    assert handing_out.due_date("2026-10-01T23:59:00+03:00") == datetime.datetime(
        2026, 10, 1, 23, 59, tzinfo=zone
    )
    local = handing_out.due_date("2026-10-01 12:30")
    assert local.tzinfo is not None and local == datetime.datetime(2026, 10, 1, 12, 30).astimezone()
    assert (
        handing_out.due_date("2026-10-01")
        == datetime.datetime(2026, 10, 1, 23, 59, 59).astimezone()
    ), "the end of the day"
    assert handing_out.due_date("2026-10-01T23:59:30Z") == datetime.datetime(
        2026, 10, 1, 23, 59, 30, tzinfo=datetime.UTC
    )


@pytest.mark.parametrize(
    "text",
    [
        "Friday",
        "2026-W40-4",
        "2026W404",
        "20261001",
        "2026-10-01 23",
        "2026-02-30",
        "2026-10-01 23:59:00.5",
        "0001-01-01",
        "9999-12-31",
        "0001-01-01T00:00+03:00",
        "2026-10-01 24:61",
        "２026-10-01",
        " 2026-10-01",
    ],
)
def test_invalid_due_dates(text):
    with pytest.raises(AssignmentError, match='is not a date; write "2026-10-01 23:59"'):
        handing_out.due_date(text)
