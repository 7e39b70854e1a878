"""assignment.toml: what it says, and one clear line for everything that is wrong in it."""

import datetime
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, write_assignment  # noqa: E402

from trajlib.grading import assignment as assignments  # noqa: E402
from trajlib.grading.assignment import AssignmentError  # noqa: E402

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


def test_everything_it_can_say(tmp_path):
    homework = an_assignment(tmp_path, FULL)
    assert (homework.name, homework.title) == ("hw1", "Homework 1: stability")
    assert homework.problems == ("1.4", "1.15") and list(homework.points) == ["1.4", "1.15"]
    assert homework.due == datetime.datetime(2026, 10, 1, 20, 59, tzinfo=datetime.timezone.utc)
    assert (homework.attempt, homework.attempts) == ("last", 3)


def test_what_it_need_not_say(tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.15"]')
    assert (homework.title, homework.due, homework.attempt, homework.attempts) == ("hw1", None, "best", None)
    assert homework.points == {"1.15": dict.fromkeys(["a_region", "b_region", "c_region", "d_region", "e_region"], 1.0)}
    assert homework.points == assignments.of_problems("hw1", ["1.15"]).points


def test_points(tmp_path):
    homework = an_assignment(tmp_path, FULL)
    assert set(homework.points["1.15"].values()) == {2.0}, "a problem's points are shared equally by its answers"
    assert homework.points["1.4"]["a_matrix"] == 2 and homework.points["1.4"]["a_stable"] == 0
    assert homework.points["1.4"]["b_rate"] == 1, "an answer that is not named is worth 1"
    assert homework.max_points == 10 + 2 + 0 + 6


def test_points_of_a_problem_with_some_answers_named_stay_those_of_the_problem(tmp_path):
    homework = an_assignment(tmp_path, 'problems = ["1.15"]\n[points]\n"1.15" = 10\n"1.15.a_region" = 6')
    assert homework.points["1.15"]["a_region"] == 6 and homework.points["1.15"]["e_region"] == 1
    assert homework.max_points == pytest.approx(10)
    whole = an_assignment(tmp_path, 'problems = ["1.17"]\n[points]\n"1.17" = 5\n"1.17.a_region" = 2\n"1.17.b_region" = 3')
    assert whole.points["1.17"] == {"a_region": 2, "b_region": 3}


def test_the_name_is_that_of_the_folder_also_from_inside_it(tmp_path, monkeypatch):
    path = write_assignment(tmp_path, 'problems = ["1.15"]', name="week 2")
    monkeypatch.chdir(path.parent)
    assert assignments.read("assignment.toml").name == "week 2"


ONE = 'problems = ["1.15"]\n'


@pytest.mark.parametrize("text, said", [
    ("", "problems is a list"),
    ("problems = [1.15]", "problems is a list of numbers in quotes"),
    ('problems = "1.15"', "problems is a list of numbers in quotes"),
    ("problems = []", "problems is a list of numbers in quotes"),
    ('problems = ["1.15", "1.15"]', "names a problem twice"),
    ('problems = ["9.99"]', "no problem 9.99"),
    ('problems = ["1.04"]', "it is written 1.4"),
    ('problems = ["../ch1/p15"]', "there is no problem"),
    (ONE + "titel = 'x'", "unknown field titel; there are attempt, attempts, due, points, problems, title"),
    (ONE + "title = 3", "title is one line of text"),
    (ONE + 'title = " "', "title is one line of text"),
    (ONE + 'title = "two\\nlines"', "title is one line of text"),
    (ONE + 'due = "tomorrow"', "due is a date with time and zone"),
    (ONE + "due = 2026-10-01", "due is a date with time and zone"),
    (ONE + "due = 2026-10-01T23:59:00", "due is a date with time and zone"),
    (ONE + 'attempt = "first"', 'attempt is "best" or "last"'),
    (ONE + "attempt = [1]", 'attempt is "best" or "last"'),
    (ONE + "attempts = 0", "attempts is a whole number from 1 up"),
    (ONE + "attempts = true", "attempts is a whole number from 1 up"),
    (ONE + "attempts = 1.5", "attempts is a whole number from 1 up"),
    (ONE + "points = 5", "points is a table"),
    (ONE + "[points]\n1.15 = 10", 'in points a problem stands in quotes'),
    (ONE + '[points]\n"1.15" = -1', 'points."1.15" is a number from 0 up'),
    (ONE + '[points]\n"1.15" = "ten"', 'points."1.15" is a number from 0 up'),
    (ONE + '[points]\n"1.15" = nan', 'points."1.15" is a number from 0 up'),
    (ONE + '[points]\n"1.15" = inf', 'points."1.15" is a number from 0 up'),
    (ONE + '[points]\n"1.15" = true', 'points."1.15" is a number from 0 up'),
    (ONE + '[points]\n"1.4" = 1', 'points."1.4" names neither a problem of the assignment'),
    (ONE + '[points]\n"1.15.z_region" = 1', 'points."1.15.z_region" names neither'),
    (ONE + '[points]\n"a_region" = 1', 'points."a_region" names neither'),
    (ONE + '[points]\n"1.15" = 1\n"1.15.a_region" = 2', 'points."1.15" is 1, but its answers named below have 2'),
    ('problems = ["1.17"]\n[points]\n"1.17" = 9\n"1.17.a_region" = 2\n"1.17.b_region" = 3', "is 9, but its answers named below have 5"),
    ("problems = [", "is not TOML in UTF-8"),
    (ONE + ONE, "Cannot overwrite a value"),
])
def test_what_is_wrong_is_said_in_one_line(tmp_path, text, said):
    path = write_assignment(tmp_path, text)
    with pytest.raises(AssignmentError) as error:
        assignments.read(path)
    assert said in str(error.value) and str(path) in str(error.value) and "\n" not in str(error.value)


def test_a_file_that_cannot_be_read(tmp_path):
    with pytest.raises(AssignmentError, match="No such file"):
        assignments.read(tmp_path / "assignment.toml")
    (tmp_path / "assignment.toml").write_bytes(b'title = "\xff"')
    with pytest.raises(AssignmentError, match="is not TOML in UTF-8"):
        assignments.read(tmp_path / "assignment.toml")
