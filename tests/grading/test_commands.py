"""`workbook grade`, `workbook score`, `workbook assignment`: files, output and errors."""

import csv
import io
import json
import os
import shutil
import subprocess
import sys
import time
import zipfile
from pathlib import Path
from unicodedata import normalize

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, RIGHT_2_4, SITE_2_4, hand_in, notebook, write_assignment
from guide import like, steps

from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import describe
from workbook.course import WORKBOOK
from workbook.grading import commands
from workbook.grading.course.assignment import InputError
from workbook.grading.course.collecting import collect
from workbook.grading.course.options import GradingOptions
from workbook.grading.pool import grader, worker_pool
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports import points_by_hand
from workbook.grading.sandbox.limits import Limits
from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

HOMEWORK = 'title = "Homework 1"\nproblems = ["1.15", "1.17"]\ndue = 2026-10-01T12:00:00Z\n[points]\n"1.15" = 10\n'
DUE = 1790856000.0
WRONG = dict.fromkeys(RIGHT_1_15, "(k1 > 5) & (k2 > 5)")


def workbook(*arguments, cwd):
    environment = os.environ | {"COLUMNS": "200", "NO_COLOR": "1", "TERM": "dumb"}
    return subprocess.run(
        [sys.executable, "-m", "workbook.cli", *map(str, arguments)],
        cwd=cwd,
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
    )


def table(path):
    return list(csv.reader(io.StringIO(path.read_bytes().decode("utf-8-sig"), newline="")))


@pytest.fixture
def here(monkeypatch):
    """Run notebooks without worker processes and sandbox, for tests of what follows."""

    def grade_all(waiting, count, settings, forkserver=None):
        for task in waiting:
            ran.append(task.problem)
            exercise = exercises.find(task.problem)
            run = run_notebook(
                [source for _, source in exercise.code("data")] + task.sources, task.names
            )
            verdicts = judge(exercise.code("data", "check"), run, task.names)
            texts = {name: describe(decode(data)) for name, data in run.encoded.items()}
            yield task.key, grader.to_plain(Judgement(verdicts, texts, ()))

    ran = []
    monkeypatch.setattr(worker_pool, "grade_all", grade_all)
    return ran


def grade(folder, **options):
    arguments = {
        "assignment_folder": folder / "assignments",
        "processes": 1,
        "limits": Limits.of_time(60),
        "trusting": True,
        "quiet": True,
    } | options
    return commands.grade_course(
        GradingOptions(folder / "submitted", folder / "graded", **arguments)
    )


@pytest.fixture
def course(tmp_path):
    """Ann has all of 1.15, Bob two wrong answers and late, Cid no answers in 1.17, Dan nothing."""
    write_assignment(tmp_path, HOMEWORK)
    hand_in(tmp_path, "ann", "1.15", RIGHT_1_15, at=DUE - 60)
    hand_in(
        tmp_path,
        "bob",
        "1.15",
        RIGHT_1_15 | {"a_region": "k1 > 0", "b_region": "k2 > k1"},
        at=DUE + 60,
    )
    hand_in(tmp_path, "cid", "1.17", {}, at=DUE - 60)
    (tmp_path / "submitted" / "dan").mkdir()
    return tmp_path


def test_a_course_in_the_sandbox_from_the_command_line(course):
    done = workbook(
        "grade", "submitted", "--out", "graded", "--site", "https://example.org/course", cwd=course
    )
    assert done.returncode == 0, done.stderr
    assert (
        "hw1: 12 points, due 2026-10-01 12:00 (UTC), by assignments/hw1/assignment.toml"
        in done.stderr
    )
    assert (
        "3 of 4 students handed something in, 1 late; tables and pages in graded/hw1" in done.stderr
        and "3/3" in done.stderr
    )
    assert table(course / "graded" / "hw1" / "grades.csv") == [
        [
            "student",
            "1.15",
            "1.17",
            "total",
            "before lateness",
            "max",
            "handed in",
            "late",
            "grace days used",
            "time unknown",
            "needs review",
        ],
        ["ann", "10.00", "0.00", "10.00", "10.00", "12.00", "yes", "", "", "", "no"],
        ["bob", "6.00", "0.00", "6.00", "6.00", "12.00", "yes", "1.15", "", "", "no"],
        ["cid", "0.00", "0.00", "0.00", "0.00", "12.00", "yes", "", "", "", "no"],
        ["dan", "0.00", "0.00", "0.00", "0.00", "12.00", "no", "", "", "", "no"],
    ]
    # Dan, who handed in nothing, has a grade once it was due.
    absent = ["dan"] if time.time() > DUE else []
    assert [row[0] for row in table(course / "graded" / "hw1" / "moodle.csv")] == [
        "ID number",
        "ann",
        "bob",
        "cid",
        *absent,
    ]
    assert [row[3] for row in table(course / "graded" / "hw1" / "nbgrader.csv")] == [
        "student_id",
        "ann",
        "bob",
        "cid",
        "dan",
    ]
    assert {path.name for path in (course / "graded" / "hw1").iterdir()} == {
        "grades.csv",
        "changes.csv",
        "moodle.csv",
        "nbgrader.csv",
        "items.csv",
        "mail-merge.csv",
        "grades.json",
        "summary.html",
        "feedback",
    }
    bob = (course / "graded" / "hw1" / "feedback" / "bob.html").read_text(encoding="utf-8")
    assert "Handed in after the due date" in bob and "<code>k1 &gt; 0</code>" in bob.replace(
        "0 &lt; k1", "k1 &gt; 0"
    )
    assert "https://example.org/course/book/ch1.html" in bob
    again = workbook("grade", "submitted", "--out", "graded", "--json", cwd=course)
    summary = json.loads(again.stdout)
    assert again.stderr == "" and summary["graded"] == 0 and summary["already graded"] == 3
    assert summary["assignments"] == {"hw1": {"ann": 10, "bob": 6, "cid": 0, "dan": 0}} and summary[
        "late"
    ] == {"hw1": {"bob": ["1.15"]}}


def test_points_by_hand_from_the_command_line(course, here):
    grade(course)
    done = workbook(
        "score",
        "bob",
        "hw1",
        "1.15",
        "a_region",
        "1.5",
        "--comment",
        "the idea is right",
        "--by",
        "Dr Lund",
        cwd=course,
    )
    assert (
        done.returncode == 0 and "bob, hw1, 1.15 a_region: 1.5 of 2 points by hand" in done.stdout
    )
    assert grade(course)["assignments"]["hw1"]["bob"] == 7.5
    page = (course / "graded" / "hw1" / "feedback" / "bob.html").read_text(encoding="utf-8")
    assert "the idea is right" in page and "Lund" not in page
    assert table(course / "graded" / "points-by-hand.csv")[1][-1] == "Dr Lund"
    done = workbook(
        "score",
        "bob",
        "hw1",
        "1.15",
        "a_region",
        "--remove",
        "--graded",
        course / "graded",
        cwd="/",
    )
    assert done.returncode == 0 and "the automatic points count again" in done.stdout
    assert grade(course)["assignments"]["hw1"]["bob"] == 6
    assert [row[-1] for row in table(course / "graded" / "hw1" / "changes.csv")[1:]] == [
        "points given by hand by Dr Lund",
        "points by hand taken back",
    ]


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["bib", "hw1", "1.15", "a_region", "1"], "hw1 has no student bib"),
        (["bob", "hw7", "1.15", "a_region", "1"], "there are no grades of hw7 in graded"),
        (
            ["bob", "hw1", "1.4", "a_region", "1"],
            "hw1 asks for no 1.4 a_region; there are 1.15 a_region",
        ),
        (["bob", "hw1", "1.15", "a_region", "2.5"], "is worth 2 points"),
        (["bob", "hw1", "1.15", "a_region", "nan"], "is worth 2 points"),
        (["bob", "hw1", "1.15", "a_region"], "and either POINTS or --remove"),
        (["bob", "hw1", "1.15", "a_region", "1", "--remove"], "and either POINTS or --remove"),
        (["bob", "hw1", "1.15", "a_region", "--remove"], "has no points by hand"),
    ],
)
def test_an_invalid_score_is_refused_in_one_line(course, here, arguments, message):
    grade(course)
    done = workbook("score", *arguments, cwd=course)
    assert (
        done.returncode == 2
        and message in done.stderr
        and len(done.stderr.strip().split("\n")) == 1
    )


# Regrading


@pytest.fixture
def changed_workbook(tmp_path, monkeypatch):
    """Exercises in a copy whose check cells `change(problem, old, new)` changes."""
    copy = tmp_path / "workbook"
    shutil.copytree(WORKBOOK.exercises, copy)
    monkeypatch.setattr(type(WORKBOOK), "exercises", copy)

    def change(problem, old, new):
        path = exercises.find(problem).path
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    return change


def test_a_changed_problem_regrades_and_lists_changes(course, here, changed_workbook, capsys):
    hand_in(course, "bob", "1.17", {}, at=DUE - 60)
    grade(course)
    points_by_hand.score_by_hand(course / "graded", "ann", "hw1", "1.15", "b_region", 1.0, "see me")
    grade(course)
    assert sorted(here) == ["1.15", "1.15", "1.17", "1.17"]
    here.clear()
    # Item a is now judged by the equation of item b: what was right is wrong, and the other way
    # round for nobody.
    changed_workbook(
        "1.15",
        "a_region=checks.stability_region(a_region, a_poly",
        "a_region=checks.stability_region(a_region, b_poly",
    )
    summary = grade(course, quiet=False)
    assert here == ["1.15", "1.15"], "1.17 is as it was"
    assert summary["assignments"]["hw1"] == {"ann": 7, "bob": 6, "cid": 0, "dan": 0}, (
        "points by hand stay after a regrade"
    )
    (change,) = summary["changes"]["hw1"]
    assert (change["student"], change["answer"], change["old_verdict"], change["new_verdict"]) == (
        "ann",
        "a_region",
        "right",
        "wrong",
    )
    assert (change["old_points"], change["new_points"], change["reason"]) == (
        2.0,
        0.0,
        "the problem or its checks changed",
    )
    output = capsys.readouterr().err
    assert "1 answer is not what it was:" in output
    assert (
        "ann 1.15 a_region: right -> wrong, 2 -> 0 points (the problem or its checks changed)"
        in output
    )
    assert table(course / "graded" / "hw1" / "changes.csv")[-1][1:] == [
        "ann",
        "1.15",
        "a_region",
        "right",
        "wrong",
        "2.00",
        "0.00",
        "the problem or its checks changed",
    ]
    assert grade(course)["changes"]["hw1"] == [], "a change is listed once"
    assert len(table(course / "graded" / "hw1" / "changes.csv")) == 1 + 2, "and stays in the table"


def test_a_change_of_a_problem_that_is_undone(course, here, changed_workbook):
    """The result that counts is by the problem as it is, not by the version that judged last."""
    right = "a_region=checks.stability_region(a_region, a_poly"
    mistaken = "a_region=checks.stability_region(a_region, b_poly"
    for old, new, points in (
        (right, mistaken, {"ann": 8, "bob": 6}),
        (mistaken, right, {"ann": 10, "bob": 6}),
    ):
        grade(course)
        changed_workbook("1.15", old, new)
        summary = grade(course)
        assert {name: summary["assignments"]["hw1"][name] for name in points} == points
    assert grade(course)["graded"] == 0


def test_changes_of_a_killed_run_are_listed_by_the_next(
    course, here, changed_workbook, monkeypatch
):
    grade(course)
    changed_workbook(
        "1.15",
        "a_region=checks.stability_region(a_region, a_poly",
        "a_region=checks.stability_region(a_region, b_poly",
    )
    with monkeypatch.context() as killed:
        killed.setattr(commands, "write", lambda *_, **__: (_ for _ in ()).throw(KeyboardInterrupt))
        with pytest.raises(KeyboardInterrupt):
            grade(course)
    summary = grade(course)
    assert summary["graded"] == 0 and [
        change["student"] for change in summary["changes"]["hw1"]
    ] == ["ann"]


def test_resubmission(course, here):
    grade(course)
    hand_in(course, "bob", "1.15", RIGHT_1_15, at=DUE + 120)
    hand_in(course, "dan", "1.15", RIGHT_1_15, at=DUE + 120)
    summary = grade(course)
    assert (
        summary["graded"] == 2
        and summary["assignments"]["hw1"]["bob"] == 10
        and summary["assignments"]["hw1"]["dan"] == 10
    )
    assert {
        (change["student"], change["answer"], change["reason"])
        for change in summary["changes"]["hw1"]
    } == {
        ("bob", "a_region", "another attempt counts"),
        ("bob", "b_region", "another attempt counts"),
    }, "Dan's first one changes no grade"
    hand_in(course, "bob", "1.15", WRONG, at=DUE + 180)
    assert grade(course)["assignments"]["hw1"]["bob"] == 10, "the best counts"
    write_assignment(course, 'attempt = "last"\n' + HOMEWORK)
    summary = grade(course)
    assert (
        summary["graded"] == 0
        and summary["assignments"]["hw1"]["bob"] == 0
        and len(summary["changes"]["hw1"]) == 5
    )
    page = (course / "graded" / "hw1" / "feedback" / "bob.html").read_text(encoding="utf-8")
    assert "You handed this in 3 times" in page


def test_changed_points_are_a_change(course, here):
    grade(course)
    write_assignment(course, HOMEWORK.replace("= 10", "= 5"))
    summary = grade(course)
    assert {change["reason"] for change in summary["changes"]["hw1"]} == {
        "the assignment's points changed"
    }
    assert len(summary["changes"]["hw1"]) == 8 and summary["assignments"]["hw1"]["ann"] == 5


# Canvas


def test_roster(course, here, capsys):
    roster = course / "canvas.csv"
    roster.write_text(
        'Student,ID,SIS Login ID,Section\n    Points Possible,,,\n"Able, Ann",1,ann,A\n"Bee, '
        'Bob",2,bob,A\n',
        encoding="utf-8",
    )
    summary = grade(course, roster=roster, quiet=False)
    assert table(course / "graded" / "hw1" / "canvas.csv") == [
        ["Student", "ID", "SIS Login ID", "Section", "Homework 1"],
        ["    Points Possible", "", "", "", "12.00"],
        ["Able, Ann", "1", "ann", "A", "10.00"],
        ["Bee, Bob", "2", "bob", "A", "6.00"],
    ]
    assert (
        summary["not in the roster"] == {"hw1": ["cid", "dan"]}
        and "not in the roster: cid, dan" in capsys.readouterr().err
    )


def test_different_points_possible_in_canvas_are_reported(course, here, capsys):
    roster = course / "canvas.csv"
    for possible, output in (
        ("10", True),
        ("12", False),
        ("12.00", False),
        ("", False),
        ("(read only)", False),
    ):
        roster.write_text(
            f"Student,ID,SIS Login ID,Section,Homework 1 (5)\n    Points "
            f"Possible,,,,{possible}\nAnn,1,ann,A,\n",
            encoding="utf-8",
        )
        grade(course, roster=roster, quiet=False)
        assert table(course / "graded" / "hw1" / "canvas.csv")[2][-1] == "10.00", (
            "the points of the homework, as they are"
        )
        assert (
            "Canvas has 10 points possible for Homework 1, the homework has 12"
            in capsys.readouterr().err
        ) == output


def test_a_bad_roster_is_an_error_before_anything_is_graded(course, here):
    (course / "canvas.csv").write_text("name,grade\n", encoding="utf-8")
    with pytest.raises(InputError, match="the roster is to have a line of headers"):
        grade(course, roster=course / "canvas.csv")
    assert here == [] and not (course / "graded").exists()


def test_everybody_in_a_roster_is_named(course, here, capsys):
    """Any table does; who has no folder has a line, and is not one who left all empty."""
    (course / "roster.csv").write_text(
        "\ufeffГруппа;Логин;Имя\n1;ann;Ann Able\n1;bob;Bob Bee\n2;eve;Eve Eve\n", encoding="utf-8"
    )
    summary = grade(course, roster=course / "roster.csv", quiet=False)
    assert summary["handed in nothing"] == {"hw1": ["dan", "eve"]}
    assert summary["not in the roster"] == {"hw1": ["cid", "dan"]}
    output = capsys.readouterr().err
    assert "  handed in nothing: dan, eve\n" in output and "not in the roster: cid, dan" in output
    rows = {row[0]: row[6] for row in table(course / "graded" / "hw1" / "grades.csv")}
    assert rows["cid"] == "yes" and rows["dan"] == rows["eve"] == "no"
    page = (course / "graded" / "hw1" / "summary.html").read_text(encoding="utf-8")
    assert "Nothing was handed in by <bdi>dan</bdi>, <bdi>eve</bdi>." in page
    assert not (course / "graded" / "hw1" / "canvas.csv").exists()


def test_a_student_twice_in_the_roster_is_an_error_before_anything_is_graded(course, here):
    (course / "roster.csv").write_text("name,login\nA,ann\nB,bob\nC,ann\n")
    with pytest.raises(InputError, match="the roster has ann more than once"):
        grade(course, roster=course / "roster.csv")
    assert here == []


# Collected from a learning platform


def collected(folder, files):
    with zipfile.ZipFile(folder / "all.zip", "w") as archive:
        for name, answers in files.items():
            archive.writestr(name, json.dumps(notebook("1.15", answers)))
    collect(folder / "all.zip", "hw1", folder / "submitted")


def test_a_file_name_takes_no_points_from_another_student(tmp_path, here, capsys):
    """And nobody is late by the time of the download."""
    write_assignment(tmp_path, HOMEWORK.replace("[points]", 'attempt = "last"\n[points]'))
    evil = "Some Body_1000_assignsubmission_file_ch1-p15.ipynb"
    files = {evil: RIGHT_1_15, f"Eve Evil_1777_assignsubmission_file_{evil}": WRONG}
    collected(tmp_path, files)
    summary = grade(tmp_path, quiet=False)
    assert summary["assignments"]["hw1"] == {"Eve Evil_1777": 0, "Some Body_1000": 10}
    assert summary["late"] == {"hw1": {}} and len(summary["time unknown"]["hw1"]) == 2
    assert "of 2 students it is not known when they handed in" in capsys.readouterr().err
    page = tmp_path / "graded" / "hw1" / "feedback" / "Some Body_1000.html"
    assert "It is not known when you handed this in" in page.read_text(encoding="utf-8")
    nbgrader = table(tmp_path / "graded" / "hw1" / "nbgrader.csv")
    assert [row[2] for row in nbgrader] == ["timestamp", "", ""]


def test_canvas_says_who_is_late(tmp_path, here):
    write_assignment(tmp_path, HOMEWORK.replace("due = 2026-10-01T12:00:00Z\n", ""))
    names = ("ableann_1_11_ch1-p15.ipynb", "beebob_LATE_2_12_ch1-p15.ipynb")
    collected(tmp_path, dict.fromkeys(names, RIGHT_1_15))
    summary = grade(tmp_path)
    assert summary["late"] == {"hw1": {"2": ["1.15"]}} and summary["time unknown"] == {"hw1": {}}


# What lateness costs


def test_points_pages_and_tables_agree_on_lateness(course, here, capsys):
    """Bob is a minute late, and has three of five answers right, of 2 points each."""
    grade(course)
    rule = '[late]\nper_day = 0.25\n[extensions]\n"cid" = 2026-10-09T12:00:00Z\n"bbo" = {}\n'
    write_assignment(course, HOMEWORK + rule.format("2026-10-09T12:00:00Z"))
    roster = course / "canvas.csv"
    roster.write_text("Student,ID,SIS Login ID,Section\nBee,2,bob,A\n", encoding="utf-8")
    summary = grade(course, roster=roster, quiet=False)
    assert summary["assignments"]["hw1"] == {"ann": 10, "bob": 4.5, "cid": 0, "dan": 0}
    assert {(c["student"], c["reason"]) for c in summary["changes"]["hw1"]} == {
        ("bob", "lateness counts otherwise")
    }
    output = capsys.readouterr().err
    assert "labels in assignment.toml for nobody here: bbo" in output
    folder = course / "graded" / "hw1"
    page = (folder / "feedback" / "bob.html").read_text(encoding="utf-8")
    assert "<p>4.5 of 12 points.</p>" in page
    assert "Handed in 1 day after the due date (a day begun counts): right answers have 75%" in page
    assert "1.5 / 2" in page
    assert "Due 2026-10-09" in (folder / "feedback" / "cid.html").read_text(encoding="utf-8")
    rows = {row[0]: row for row in table(folder / "grades.csv")}
    assert rows["bob"][3] == "4.50"
    (moodle,) = (row for row in table(folder / "moodle.csv") if row[0] == "bob")
    assert moodle[1] == "4.50" and "right, late: 75% of the points" in moodle[2]
    (nbgrader,) = (row for row in table(folder / "nbgrader.csv") if row[3] == "bob")
    assert nbgrader[7:10] == ["6.00", "1.50", "4.50"]
    assert table(folder / "canvas.csv")[-1][-1] == "4.50"
    write_assignment(course, HOMEWORK + "[late]\nper_day = 0.1\ncutoff_days = 0\n")
    assert grade(course)["assignments"]["hw1"]["bob"] == 0
    page = (folder / "feedback" / "bob.html").read_text(encoding="utf-8")
    assert "Handed in after the due date: right answers have no points any more" in page


# Messages and refusals


def test_without_a_file_every_answer_is_a_point(course, here, capsys):
    hand_in(course, "dan", "1.17", {})
    grade(course, assignment_folder=None, quiet=False)
    output = capsys.readouterr().err
    assert (
        "hw1: 7 points, no due date, one for each answer, since there is no assignment.toml for it"
        in output
    )
    assert "  problems: 1.15 (from 2 students), 1.17 (from 2 students)\n" in output


def test_without_a_file_a_problem_of_one_student_is_not_asked_for(course, here, capsys):
    summary = grade(course, assignment_folder=None, quiet=False)
    output = capsys.readouterr().err
    assert "hw1: 5 points" in output and "1.15 (from 2 students)\n" in output
    assert (
        "submitted/cid/hw1/ch1-p17.ipynb: only cid handed in problem 1.17, while others share 1.15"
        in output
    )
    assert summary["to review"] == {"hw1": {"cid": []}}


def test_a_misspelt_homework_is_reported(course, here, capsys):
    """Where there are assignment files, no folder makes a homework of its own."""
    for student, name in (("dan", "HW1"), ("hw1", "eva"), ("fay", "stuff")):
        hand_in(course, student, "1.15", RIGHT_1_15, assignment=name)
    summary = grade(course, quiet=False)
    output = capsys.readouterr().err
    assert set(summary["assignments"]) == {"hw1"} and list(summary["to review"]["hw1"]) == [
        "dan",
        "fay",
        "hw1",
    ]
    assert (
        "submitted/dan/HW1/ch1-p15.ipynb: there is no homework HW1; hw1 is another name: rename "
        "the folder" in output
    )
    assert (
        "hw1 is a homework, so this has to lie in eva/hw1: first the student, then the homework"
        in output
    )
    assert (
        "there is no homework stuff: no assignment.toml stands in a folder of this name" in output
    )
    (course / "submitted" / "dan" / "HW1").rename(course / "submitted" / "dan" / "hw1")
    assert grade(course)["assignments"]["hw1"]["dan"] == 10


def test_an_assignment_is_found_in_either_unicode_form(course, here):
    write_assignment(course, HOMEWORK, name=normalize("NFD", "été"))
    hand_in(
        course, normalize("NFD", "renée"), "1.15", RIGHT_1_15, assignment=normalize("NFC", "été")
    )
    roster = course / "canvas.csv"
    roster.write_text(
        normalize("NFD", "Student,ID,SIS Login ID,Section\nRenée,1,renée,A\n"), encoding="utf-8"
    )
    assert grade(course, roster=roster)["assignments"]["été"] == {
        name: 10 * (name == "renée") for name in ("ann", "bob", "cid", "dan", "renée")
    }
    assert table(course / "graded" / "été" / "canvas.csv")[2][-1] == "10.00"
    points_by_hand.score_by_hand(
        course / "graded",
        normalize("NFD", "renée"),
        normalize("NFD", "été"),
        "1.15",
        "a_region",
        1.0,
    )


def test_attempts_beyond_the_limit_are_not_graded(course, here):
    write_assignment(course, "attempts = 1\n" + HOMEWORK)
    for k in range(5):
        hand_in(
            course,
            "bob",
            "1.15",
            RIGHT_1_15 | {"a_region": f"k1 > {k}"},
            at=DUE + 100 + k,
            name=f"ch1-p15-{k}.ipynb",
        )
    assert grade(course)["graded"] == 3 and sorted(here) == ["1.15", "1.15", "1.17"]
    write_assignment(course, "attempts = 2\n" + HOMEWORK)
    assert grade(course)["graded"] == 1
    (course / "submitted" / "bob" / "hw1" / "ch1-p15.ipynb").unlink()
    assert grade(course)["graded"] == 0, "an attempt that was taken away is one all the same"


# Changes


def test_a_problem_taken_out_of_the_homework_is_a_change(course, here, capsys):
    grade(course)
    write_assignment(course, 'problems = ["1.17"]\n')
    changes = grade(course, quiet=False)["changes"]["hw1"]
    assert len(changes) == 5 + 3 and {change["reason"] for change in changes} == {
        "the homework asks for it no longer"
    }
    assert (
        "ann 1.15 a_region: right -> not asked for, 2 -> 0 points (the homework asks for it no "
        "longer)" in capsys.readouterr().err
    )
    assert len(table(course / "graded" / "hw1" / "changes.csv")) == 1 + 8
    assert grade(course)["changes"]["hw1"] == []
    write_assignment(course, HOMEWORK)
    back = grade(course, quiet=False)["changes"]["hw1"]
    assert len(back) == 5 + 3 and {change["reason"] for change in back} == {
        "the homework asks for it again"
    }
    assert (
        "ann 1.15 a_region: not asked for -> right, 0 -> 2 points (the homework asks for it again)"
        in capsys.readouterr().err
    )
    assert (
        len(table(course / "graded" / "hw1" / "changes.csv")) == 1 + 8 + 8
        and grade(course)["changes"]["hw1"] == []
    )


def test_points_by_hand_are_capped_at_what_the_answer_is_worth(course, here, capsys):
    grade(course)
    points_by_hand.score_by_hand(course / "graded", "bob", "hw1", "1.15", "a_region", 2.0, "well")
    assert grade(course)["assignments"]["hw1"]["bob"] == 8
    write_assignment(course, HOMEWORK.replace("= 10", "= 5"))
    summary = grade(course, quiet=False)
    assert summary["assignments"]["hw1"]["bob"] == 4
    (change,) = [
        change
        for change in summary["changes"]["hw1"]
        if (change["student"], change["answer"]) == ("bob", "a_region")
    ]
    assert (change["old_points"], change["new_points"], change["reason"]) == (
        2,
        1,
        "the assignment's points changed",
    )
    assert (
        "points by hand above what the answer is worth now count as that: bob 1.15 a_region (2, "
        "worth 1)" in capsys.readouterr().err
    )
    write_assignment(course, HOMEWORK)
    assert grade(course)["assignments"]["hw1"]["bob"] == 8, "nothing that was entered is lost"


# Work that was left aside or could not be read


def test_what_was_left_aside_needs_review(course, here, capsys):
    for student, path_below in (
        ("dan", "hw1/inner/ch1-p15.ipynb"),
        ("eva", "ch1-p15.ipynb"),
        ("fay", "hw1/mine.ipynb"),
        ("ann", "ch1-p15.ipynb"),
    ):
        path = course / "submitted" / student / path_below
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text('{"cells": []}')
    (course / "submitted" / "gil" / "hw1").mkdir(parents=True)
    (course / "submitted" / "gil" / "hw1" / "ch1-p15.pdf").touch()
    (course / "submitted" / "hal" / "hw1").mkdir(parents=True)
    summary = grade(course, quiet=False)
    assert list(summary["to review"]["hw1"]) == ["dan", "eva", "fay", "gil"], (
        "what lies in no homework is Ann's of another one"
    )
    rows = {row[0]: row[-1] for row in table(course / "graded" / "hw1" / "grades.csv")}
    assert rows["dan"] == rows["gil"] == "yes" and rows["hal"] == "no"
    assert "dan" not in [row[0] for row in table(course / "graded" / "hw1" / "moodle.csv")]
    assert "4 need your look" in capsys.readouterr().err
    for student in ("dan", "eva", "fay", "gil"):
        page = (course / "graded" / "hw1" / "feedback" / f"{student}.html").read_text(
            encoding="utf-8"
        )
        assert (
            "Nothing was submitted" not in page and "Something you handed in was left aside" in page
        )
    assert "Nothing was submitted" in (
        course / "graded" / "hw1" / "feedback" / "hal.html"
    ).read_text(encoding="utf-8")
    summary = (course / "graded" / "hw1" / "summary.html").read_text(encoding="utf-8")
    summary = summary.split("<h2>Left aside</h2>")[1].split("<h2>")[0]
    assert (
        all(f"<bdi>{student}</bdi>" in summary for student in ("dan", "eva", "fay", "gil"))
        and "ann" not in summary
    )


def test_a_notebook_for_another_problem_needs_review_only_if_work_is_missing(course, here):
    for student, number in (("ann", "1.17"), ("ann", "1.4"), ("cid", "1.4")):
        hand_in(course, student, number, {})
    assert grade(course)["to review"]["hw1"] == {"cid": []}
    for student, looks in (("ann", False), ("cid", True)):
        page = (course / "graded" / "hw1" / "feedback" / f"{student}.html").read_text(
            encoding="utf-8"
        )
        assert (
            "it is for problem 1.4, which this homework does not ask for" in page
            and ("your lecturer will look at it" in page) == looks
        )


def test_a_homework_with_everything_left_aside(course, here):
    write_assignment(course, HOMEWORK, name="hw2")
    hand_in(course, "ann", "1.15", {}, assignment="hw2/inner")
    assert grade(course)["to review"]["hw2"] == {"ann": []}


def test_the_summary_lists_what_could_not_be_read(course, here, capsys):
    for student in ("dan", "eva"):
        hand_in(course, student, "1.15", {}).write_text("{ broken")
    grade(course, quiet=False)
    assert "2 notebooks could not be read or run" in capsys.readouterr().err
    page = (course / "graded" / "hw1" / "summary.html").read_text(encoding="utf-8")
    section = page.split("<h2>Notebooks that could not be read or run</h2>")[1].split("<h2>")[0]
    assert (
        section.count("<tr>") == 2
        and "no JSON in UTF-8" in section
        and "<bdi>dan</bdi> (1.15), <bdi>eva</bdi> (1.15)" in section
    )
    hand_in(course, "dan", "1.15", RIGHT_1_15)
    hand_in(course, "eva", "1.15", RIGHT_1_15)
    grade(course)
    assert "could not be read or run" not in (course / "graded" / "hw1" / "summary.html").read_text(
        encoding="utf-8"
    )


# A full disk and damaged files


def test_a_full_disk_is_one_line_and_changes_are_listed_next_time(course, here):
    grade(course)
    hand_in(course, "bob", "1.15", RIGHT_1_15, at=DUE + 120)
    before = (course / "graded" / "hw1" / "grades.csv").read_bytes()
    full = course / "graded" / "hw1" / ".grades.csv.writing"
    full.symlink_to("/dev/full")
    with pytest.raises(
        InputError,
        match="grades.csv cannot be written: No space left on device; nothing that was there "
        "is lost",
    ):
        grade(course)
    assert (course / "graded" / "hw1" / "grades.csv").read_bytes() == before
    summary = grade(course)
    assert summary["graded"] == 0 and {
        change["student"] for change in summary["changes"]["hw1"]
    } == {"bob"}


@pytest.mark.parametrize(
    "spoilt",
    [
        "[]",
        "3",
        '{"students": []}',
        '{"students": {"ann": {}}, "changes": []}',
        '{"students": {}, "changes": [1]}',
        '{"students": {"ann": {"answers": [{"problem": 1}]}}, "changes": []}',
        "[" * 10**5,
    ],
)
def test_a_record_of_another_form_is_an_error_of_one_line(course, here, spoilt):
    grade(course)
    (course / "graded" / "hw1" / "grades.json").write_text(spoilt)
    for act in (
        lambda: grade(course),
        lambda: points_by_hand.score_by_hand(
            course / "graded", "ann", "hw1", "1.15", "a_region", 1.0
        ),
    ):
        with pytest.raises(InputError, match="grades.json is not as workbook grade wrote it"):
            act()


def test_check_accepts_a_byte_order_mark(course):
    path = course / "submitted" / "ann" / "hw1" / "ch1-p15.ipynb"
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert exercises.read(path).number == "1.15"


def test_answers_that_need_review(course, here, changed_workbook, capsys):
    # A check of ours that fails: it asks for a polynomial that is not there.
    changed_workbook("1.15", "stability_region(a_region, a_poly", "stability_region(a_region, None")
    summary = grade(course, quiet=False)
    assert summary["to review"] == {
        "hw1": {"ann": [["1.15", "a_region"]], "bob": [["1.15", "a_region"]]}
    }
    assert "2 need your look" in capsys.readouterr().err
    absent = ["dan"] if time.time() > DUE else []
    assert [row[0] for row in table(course / "graded" / "hw1" / "moodle.csv")] == [
        "ID number",
        "cid",
        *absent,
    ]
    points_by_hand.score_by_hand(course / "graded", "ann", "hw1", "1.15", "a_region", 2.0)
    summary = grade(course)
    assert (
        list(summary["to review"]["hw1"]) == ["bob"] and summary["assignments"]["hw1"]["ann"] == 10
    )


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["grade", "nowhere", "--out", "graded"], "nowhere is not a folder"),
        (
            ["grade", "submitted", "--out", "graded", "--assignments", "nowhere"],
            "nowhere is not a folder",
        ),
        (
            ["grade", "submitted", "--out", "graded", "--processes", "-1"],
            "--processes is a number from 1 up",
        ),
        (
            ["grade", "submitted", "--out", "graded", "--roster", "nowhere.csv"],
            "nowhere.csv: No such file or directory",
        ),
        (["assignment", "new", "hw1", "1.15"], "assignments/hw1 is already there"),
        (["assignment", "new", "hw2", "9.99"], "there is no problem 9.99"),
        (["assignment", "new", "hw2", "1.15", "--due", "Friday"], "'Friday' is not a date"),
        (["assignment", "new", "hw2", "1.15", "--due", "0001-01-01"], "'0001-01-01' is not a date"),
    ],
)
def test_bad_input_ends_in_one_line_and_code_2(course, arguments, message):
    done = workbook(*arguments, cwd=course)
    assert done.returncode == 2 and message in done.stderr, done.stderr
    assert len(done.stderr.strip().split("\n")) == 1 and "Traceback" not in done.stderr


def test_a_bad_assignment_file_ends_in_one_line_and_code_2(course):
    write_assignment(course, 'problems = ["1.15"]\n[points]\n"1.16" = 2')
    done = workbook("grade", "submitted", "--out", "graded", cwd=course)
    assert (
        done.returncode == 2
        and 'assignments/hw1/assignment.toml: points."1.16" names neither' in done.stderr
    )
    assert len(done.stderr.strip().split("\n")) == 1


def test_a_homework_from_the_command_line(tmp_path):
    done = workbook(
        "assignment",
        "new",
        "hw1",
        "1.4",
        "1.15",
        "--title",
        "Stability",
        "--due",
        "2026-10-01T23:59+03:00",
        cwd=tmp_path,
    )
    assert (
        done.returncode == 0
        and "assignments/hw1: 2 problems, 13 answers, 13 points, due 2026-10-01 23:59 (UTC+03:00)"
        in done.stdout
    )
    assert {path.name for path in (tmp_path / "assignments" / "hw1").iterdir()} == {
        "assignment.toml",
        "README.md",
        "ch1-p04.ipynb",
        "ch1-p15.ipynb",
    }


def test_a_damaged_record_is_an_error_of_one_line(course, here):
    grade(course)
    (course / "graded" / "hw1" / "grades.json").write_text("{")
    with pytest.raises(InputError, match="grades.json is not as workbook grade wrote it"):
        grade(course)
    (course / "graded" / "hw1" / "grades.json").unlink()
    assert grade(course)["changes"] == {"hw1": []}


def test_names_of_pages():
    assert commands.page_name("ann") == "ann.html"
    first, other = commands.page_name("ж" * 120 + "a"), commands.page_name("ж" * 120 + "b")
    assert first != other and len(first.encode()) <= 255 and len(other.encode()) <= 255


# The lecturer's guide


GUIDE = Path(__file__).resolve().parents[2] / "book" / "guides" / "lecturer.md"
RIGHT_1_17 = {
    "a_region": "(omega2 > 0) & (epsilon > 0)",
    "b_region": "(epsilon >= 2) & (omega2 >= epsilon - 1)",
}


def the_class_hands_in(folder):
    on_time, late = DUE - 86400, DUE + 86400
    hand_in(folder, "ann", "1.15", RIGHT_1_15, at=on_time)
    hand_in(folder, "ann", "1.17", RIGHT_1_17, at=on_time)
    hand_in(
        folder,
        "bob",
        "1.15",
        RIGHT_1_15 | {"a_region": "k1*k2 > 1", "b_region": "k2 > k1"},
        at=late,
    )
    hand_in(folder, "cid", "1.15", RIGHT_1_15 | {"e_region": "k2 > 0"}, at=on_time)
    (folder / "submitted" / "dan").mkdir()


def cid_hands_in_again(folder):
    hand_in(folder, "cid", "1.15", RIGHT_1_15, at=DUE - 3600)


def canvas_exports_its_gradebook(folder):
    (folder / "canvas.csv").write_text(
        "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1: stability regions (4711),Final "
        "Score\n"
        "    Points Possible,,,,,7,(read only)\n"
        '"Able, Ann",101,u101,ann,Group 1,,\n"Bee, Bob",102,u102,bob,Group 1,,\n"Cee, '
        'Cid",103,u103,cid,Group 2,,\n',
        encoding="utf-8",
    )


def the_systems_give_archives(folder):
    """As Canvas and a Russian Moodle write them; Bob's archive is encrypted."""
    content = json.dumps(notebook("1.15", {}))
    with zipfile.ZipFile(folder / "canvas-submissions.zip", "w") as archive:
        for name in ("ableann_101_9001", "beebob_LATE_102_9002", "ceecid_103_9003"):
            archive.writestr(f"{name}_ch1-p15.ipynb", content)
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w") as archive:
        archive.writestr("ch1-p15.ipynb", content)
    with zipfile.ZipFile(folder / "moodle.zip", "w") as archive:
        archive.writestr("Ann Able_1101_assignsubmission_file/ch1-p15.ipynb", content)
        archive.writestr("Bob Bee_1102_assignsubmission_file/photos.zip", b"")
        archive.writestr("Cid Cee_1103_assignsubmission_file/homework.zip", inner.getvalue())
        archive.infolist()[1].flag_bits |= 1
    when = '"вторник, 29 сентября 2026, 14:14"'
    (folder / "worksheet.csv").write_text(
        "\ufeffИдентификатор;Полное имя;Адрес электронной почты;Состояние;Оценка;Максимальная оценка;"
        "Оценка может быть изменена;Последнее изменение (ответ);Последнее изменение (оценка)\n"
        + "".join(
            f"Участник{number};{name};{name.split()[0].lower()}@uni.example;;;5,00;Да;{time};-\n"
            for number, name, time in (
                (1101, "Ann Able", when),
                (1102, "Bob Bee", when),
                (1103, "Cid Cee", when),
                (1104, "Dan Dee", "-"),
            )
        ),
        encoding="utf-8",
    )


def the_class_is_known(folder):
    (folder / "class.csv").write_text("login\nann\nbob\ncid\ndan\n", encoding="utf-8")


def students_of_canvas_hand_in_untouched_notebooks(folder):
    content = json.dumps(notebook("2.4", {}))
    with zipfile.ZipFile(folder / "untouched.zip", "w") as archive:
        for name in ("ableann_101_9101", "beebob_102_9102"):
            archive.writestr(f"{name}_ch2-p04.ipynb", content)


def friends_hand_in(folder):
    """Ann her own work, Bob hers, Cid the site's answers with the site's data cell."""
    lines = (folder / "assignments" / "hw3" / "numbers.csv").read_text("utf-8").split()
    row = dict(line.split(",") for line in lines)["ann"]
    for student in ("ann", "bob"):
        hand_in(folder, student, f"2.4~{row}", RIGHT_2_4, "hw3", name="ch2-p04.ipynb")
    hand_in(folder, "cid", "2.4", SITE_2_4, "hw3")


#: What people do between the commands, at the beginning of a section.
MEANWHILE = {
    "Collect": the_class_hands_in,
    "Collect from Canvas or Moodle": the_systems_give_archives,
    "When something changes": cid_hands_in_again,
    "Hand the grades on": canvas_exports_its_gradebook,
    "A homework with other numbers for each student": the_class_is_known,
    "Hand them out by Moodle, Canvas or one file": students_of_canvas_hand_in_untouched_notebooks,
    "Grade them": friends_hand_in,
}


def test_every_command_of_the_lecturers_guide(tmp_path):
    environment = os.environ | {
        "COLUMNS": "120",
        "NO_COLOR": "1",
        "TERM": "dumb",
        "LC_ALL": "C.UTF-8",
        "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}",
    }
    commands_run, waiting = [], dict(MEANWHILE)
    for section, command, shown in steps(GUIDE.read_text(encoding="utf-8")):
        if section in waiting:
            waiting.pop(section)(tmp_path)
        if command.startswith("make "):
            # The tests of the site run these for real; here they are only looked up.
            command, folder, shown = (
                command.replace("make", "make -n", 1),
                GUIDE.parents[2],
                ["..."],
            )
        elif command == "source .venv/bin/activate":
            # The environment of these tests, in a terminal that knows nothing of it.
            command = f"PATH=/usr/bin:/bin; source {sys.prefix}/bin/activate && command -v workbook"
            folder, shown = tmp_path, [f"{sys.prefix}/bin/workbook"]
        else:
            folder = tmp_path
        done = subprocess.run(
            ["bash", "-c", command],
            cwd=folder,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=300,
        )
        assert done.returncode == (1 if command.startswith("workbook check") else 0), (
            f"{command}: {done.stdout}"
        )
        assert not shown or like(shown, done.stdout), (
            f"{command} prints\n{done.stdout}\nand the page shows\n" + "\n".join(shown)
        )
        commands_run.append(command)
    assert waiting == {} and len(commands_run) > 15
    grades = json.loads((tmp_path / "graded" / "hw3" / "grades.json").read_text("utf-8"))
    earned = {name: score["points"] for name, score in grades["students"].items()}
    # an answer may be the same for two rows
    assert (earned["ann"], earned["cid"], earned["dan"]) == (3, 0, 0) and earned["bob"] <= 1
    for written in (
        "summary.html",
        "feedback/ann.html",
        "grades.csv",
        "changes.csv",
        "moodle.csv",
        "nbgrader.csv",
        "items.csv",
        "mail-merge.csv",
        "grades.json",
        "canvas.csv",
    ):
        assert (tmp_path / "graded" / "hw1" / written).exists() and written in GUIDE.read_text(
            encoding="utf-8"
        )


def test_the_five_commands_of_the_readme(tmp_path):
    the_systems_give_archives(tmp_path)
    readme = (GUIDE.parents[2] / "README.md").read_text(encoding="utf-8")
    lines = readme.split("in five commands")[1].split("```")[1].strip().splitlines()
    assert len(lines) == 5
    environment = os.environ | {
        "COLUMNS": "200",
        "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}",
    }
    for line in lines:
        done = subprocess.run(
            ["bash", "-c", line],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert done.returncode == 0, f"{line}: {done.stdout}{done.stderr}"
    rows = {row[0]: row for row in table(tmp_path / "graded" / "hw1" / "moodle.csv")}
    assert rows["Email address"] and rows["ann@uni.example"][1] == "0.50"
    assert "handed in nothing: dan@uni.example" in done.stderr
    # Bob's photos cannot be opened, and may be his work.
    # Dan, who handed in nothing, has no points once it was due.
    absent = {"dan@uni.example"} if time.time() > DUE else set()
    assert set(rows) == {"Email address", "ann@uni.example", "cid@uni.example", *absent}
