"""Tables for other systems: each format as a golden text, and unusual names."""

import csv
import dataclasses
import io
import json
import sys
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import graded

from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, WRONG
from workbook.grading.course import collecting, ledger
from workbook.grading.course.assignment import InputError
from workbook.grading.course.record import Change
from workbook.grading.course.store import HandPoints
from workbook.grading.reports import canvas, exporting, handing_back
from workbook.grading.reports.canvas import Gradebook
from workbook.grading.reports.scores import scores

HOMEWORK = (
    'title = "Homework 1, stability"\nproblems = ["1.17", "1.18"]\ndue = '
    '2026-10-01T12:00:00+03:00\n[points]\n"1.17" = 5\n'
)
BEFORE = datetime(2026, 10, 1, 8, 30, tzinfo=UTC).timestamp()
AFTER = datetime(2026, 10, 1, 9, 0, 1, tzinfo=UTC).timestamp()
#: A comma, a quote, formulas, accents, right to left, a line end; identifiers that begin with a
#: sign or have leading zeros.
AWKWARD = [
    "O'Neill, Zoë",
    'Ann "the best"',
    "=cmd|'/C calc'!A0",
    "@SUM(1+1)",
    "-12345",
    "+380441234567",
    "-1+1",
    "007",
    "Łukasz Ŝtérn",
    "محمد",
    "עדה (ada)",
    "line\nend",
    "\tcalc",
    "semi;colon",
    "naïve@uni.example",
    "山田",
]


@pytest.fixture
def small(store, homework):
    """Ann has all, Bob some of it and late, Cid an answer that needs review, Dan nothing."""
    graded(store, "ann", "1.17", {"a_region": RIGHT, "b_region": RIGHT}, BEFORE)
    graded(store, "ann", "1.18", {"a_region": RIGHT, "b_region": RIGHT}, BEFORE)
    graded(store, "bob", "1.17", {"a_region": RIGHT, "b_region": WRONG}, AFTER)
    graded(store, "cid", "1.18", {"a_region": UNCHECKED, "b_region": RIGHT}, BEFORE)
    store.set_points({("bob", "hw1", "1.18", "a_region"): HandPoints(0.5, 'on paper; "almost"')})
    return scores(store, homework, ["dan"])


def awkward(store, homework):
    for name in AWKWARD:
        graded(store, name, "1.17", {"a_region": RIGHT, "b_region": WRONG}, BEFORE)
    return scores(store, homework)


def rows(text, delimiter=","):
    return list(
        csv.reader(
            io.StringIO(text.removeprefix("\ufeff"), newline=""), delimiter=delimiter, strict=True
        )
    )


def test_grades_csv(small, homework):
    assert exporting.grades_csv(homework, small) == (
        '\ufeff"student","1.17","1.18","total","before lateness","max","handed in","late",'
        '"grace days used","time unknown","needs review"\r\n'
        '"ann","5.00","2.00","7.00","7.00","7.00","yes","","","","no"\r\n'
        '"bob","2.50","0.50","3.00","3.00","7.00","yes","1.17","","","no"\r\n'
        '"cid","0.00","1.00","1.00","1.00","7.00","yes","","","","yes"\r\n'
        '"dan","0.00","0.00","0.00","0.00","7.00","no","","","","no"\r\n'
    )


def test_moodle_csv(small, homework):
    """A student without a grade has no row: feedback without a grade would delete one."""
    before = exporting.moodle_csv(homework, small, homework.due.timestamp())
    after = exporting.moodle_csv(homework, small, homework.due.timestamp() + 1)
    assert after == before + '"dan","0.00","nothing was handed in"\r\n', "absent when it was due"
    assert before == (
        '"ID number","Homework 1, stability","Homework 1, stability (feedback)"\r\n'
        '"ann","7.00","1.17 a_region: right; 1.17 b_region: right; 1.18 a_region: right; 1.18 '
        'b_region: right"\r\n'
        '"bob","3.00","1.17 a_region: right; 1.17 b_region: wrong; 1.18 a_region: 0.50 by hand (on '
        'paper; ""almost""); '
        '1.18 b_region: missing"\r\n'
    )


def test_moodle_csv_with_addresses(store, homework):
    for name in ("ann@uni.example", "bob@uni.example"):
        graded(store, name, "1.17", {"a_region": RIGHT, "b_region": WRONG})
    assert rows(exporting.moodle_csv(homework, scores(store, homework)))[0][0] == "Email address"


def test_nbgrader_csv(small, homework):
    from nbgrader.plugins import export

    text = exporting.nbgrader_csv(homework, small)
    assert text == (
        '"assignment","duedate","timestamp","student_id","last_name","first_name","email","raw_score","late_submission_penalty",'
        '"score","max_score"\r\n'
        '"hw1","2026-10-01 09:00:00","2026-10-01 '
        '08:30:00","ann","","","","7.00","0.00","7.00","7.00"\r\n'
        '"hw1","2026-10-01 09:00:00","2026-10-01 '
        '09:00:01","bob","","","","3.00","0.00","3.00","7.00"\r\n'
        '"hw1","2026-10-01 09:00:00","2026-10-01 08:30:00","cid","","","","","0.00","","7.00"\r\n'
        '"hw1","2026-10-01 09:00:00","","dan","","","","0.00","0.00","0.00","7.00"\r\n'
    )
    source = Path(export.__file__).read_text(encoding="utf-8")
    assert all(f'"{name}"' in source for name in rows(text)[0]), "the columns are nbgrader's own"


ROSTER = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Old (11),Homework 1\\, stability (22),Final "
    "Score\n"
    "    Points Possible,,,,,10,7,(read only)\n"
    '"Able, Ann",101,u1,ann,"Fall, A",9,,80\n'
    '"Bee, Bob",102,u2,bob,"Fall, A",8,1.00,70\n'
    '"Cee, Cid",103,u3,cid,B,7,EX,60\n'
    '"Zee, Zoe",104,u4,zoe,B,7,2.00,60\n'
    '"Student, Test",105,,f00d,B,,,\n'
).replace("Homework 1\\, stability (22)", '"Homework 1, stability (22)"')


def test_canvas_csv_fills_its_own_column(small, homework):
    text = canvas.canvas_csv(homework, small, Gradebook(ROSTER))
    assert text == (
        '"Student","ID","SIS User ID","SIS Login ID","Section","Homework 1, stability (22)"\r\n'
        '"    Points Possible","","","","","7"\r\n'
        '"Able, Ann","101","u1","ann","Fall, A","7.00"\r\n'
        '"Bee, Bob","102","u2","bob","Fall, A","3.00"\r\n'
        '"Cee, Cid","103","u3","cid","B","EX"\r\n'
        '"Zee, Zoe","104","u4","zoe","B","2.00"\r\n'
        '"Student, Test","105","","f00d","B",""\r\n'
    )


def test_canvas_csv_makes_a_new_column(small, homework):
    roster = ("\ufeff" + ROSTER.replace(" (22)", " (other)")).replace(
        "\n    Points", "\n,,,,,Manual Posting,,\n    Points"
    )
    text = canvas.canvas_csv(homework, small, Gradebook(roster))
    assert [row[5] for row in rows(text)] == [
        "Homework 1, stability",
        "7.00",
        "7.00",
        "3.00",
        "",
        "",
        "",
    ]
    assert [row[1] for row in rows(text)] == ["ID", "", "101", "102", "103", "104", "105"], (
        "a line about columns is no student"
    )


@pytest.mark.parametrize(
    "column, names",
    [("ID", ["101", "102"]), ("SIS User ID", ["u1", "u2"]), ("SIS Login ID", ["ann", "bob"])],
)
def test_canvas_students_are_matched_by_the_id_that_fits_most(store, homework, column, names):
    for name in names:
        graded(store, name, "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    text = canvas.canvas_csv(homework, scores(store, homework), Gradebook(ROSTER))
    assert [row[5] for row in rows(text)][2:4] == ["5.00", "5.00"]


def test_ids_of_different_kinds_are_not_mixed(store, homework):
    """102 is Bob's ID in Canvas and Ann's of the university: one kind is used for all."""
    roster = ROSTER.replace("101,u1", "101,102").replace("102,u2", "102,103")
    for name in ("102", "103"):
        graded(store, name, "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    text = canvas.canvas_csv(
        homework, scores(store, homework), Gradebook(roster.replace("103,u3", "999,u3"))
    )
    assert [row[5] for row in rows(text)][2:5] == ["5.00", "5.00", "EX"]


def test_a_canvas_roster_with_semicolons_keeps_them(small, homework):
    roster = 'Student;ID;Section\n    Points Possible;;\n"Able; Ann";ann;A\n'
    text = canvas.canvas_csv(homework, small, Gradebook(roster))
    assert rows(text, ";")[2] == ["Able; Ann", "ann", "A", "7.00"]


@pytest.mark.parametrize("text", ["", "name,grade\n", "Student,ID,Section\n", "Student\n", "{}"])
def test_files_that_are_no_roster(tmp_path, text):
    (tmp_path / "roster.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="roster.csv: the roster is to have a line of headers"):
        canvas.read_roster(tmp_path / "roster.csv")


def test_a_roster_that_cannot_be_read(tmp_path):
    with pytest.raises(InputError, match="No such file"):
        canvas.read_roster(tmp_path / "canvas.csv")
    (tmp_path / "canvas.csv").write_bytes(b"PK\x03\x04\x14\x00Student,ID,Section\nZo\xeb,1,A\n")
    with pytest.raises(InputError, match="not CSV in UTF-8"):
        canvas.read_roster(tmp_path / "canvas.csv")


# Awkward names


def test_identifiers_are_unchanged_for_other_systems(store, homework):
    class_scores = awkward(store, homework)
    assert sorted(
        row[0] for row in rows(exporting.moodle_csv(homework, class_scores))[1:]
    ) == sorted(AWKWARD)
    assert sorted(
        row[3] for row in rows(exporting.nbgrader_csv(homework, class_scores))[1:]
    ) == sorted(AWKWARD)
    out = io.StringIO()
    csv.writer(out).writerows(
        [
            ["Student", "ID", "SIS User ID", "Section"],
            *([name, name, name, "A"] for name in AWKWARD),
        ]
    )
    text = canvas.canvas_csv(homework, class_scores, Gradebook(out.getvalue()))
    assert [row[:4] for row in rows(text)[2:]] == [[name, name, name, "A"] for name in AWKWARD]
    assert {row[4] for row in rows(text)[2:]} == {"2.50"}


def test_no_cell_for_people_is_a_formula(store, homework):
    class_scores = awkward(store, homework)
    change = [
        Change("now", name, "1.17", "a_region", "wrong", "right", 0.0, 1.0, "graded again")
        for name in AWKWARD
    ]
    for text, column in (
        (exporting.grades_csv(homework, class_scores), 0),
        (exporting.changes_csv(change), 1),
    ):
        shown = [row[column] for row in rows(text)[1:]]
        assert len(shown) == len(AWKWARD) and all(
            len(row) == len(rows(text)[0]) for row in rows(text)
        )
        for cell in shown:
            assert cell[0] not in "=@\t\r\n" and (cell[0] not in "+-" or cell[1:].isdigit()), cell
        assert {
            "'=cmd|'/C calc'!A0",
            "'@SUM(1+1)",
            "'-1+1",
            "'\tcalc",
            "-12345",
            "+380441234567",
            "O'Neill, Zoë",
        } <= set(shown)


def test_changes_csv():
    change = Change(
        "2026-10-02T10:00:00+03:00",
        "ann",
        "1.17",
        "a_region",
        "wrong",
        "right",
        0.0,
        2.5,
        "the problem or its checks changed",
    )
    assert exporting.changes_csv([change]) == (
        '\ufeff"when","student","problem","answer","old verdict","new verdict","old points","new '
        'points","reason"\r\n'
        '"2026-10-02T10:00:00+03:00","ann","1.17","a_region","wrong","right","0.00","2.50","the '
        "problem or its checks "
        'changed"\r\n'
    )


# Gradescope

#: The fields of the specification, with their types; others are an error there or ignored.
RESULT = {
    "score": (int, float),
    "execution_time": int,
    "output": str,
    "output_format": str,
    "visibility": str,
    "stdout_visibility": str,
    "tests": list,
}
TEST = {
    "score": (int, float),
    "max_score": (int, float),
    "status": str,
    "name": str,
    "output": str,
    "output_format": str,
    "visibility": str,
}


def test_gradescope_json(small, homework):
    _ann, bob, cid, dan = small
    hints = {("1.17", "b_region"): 2}
    result = json.loads(
        exporting.gradescope_json(
            bob, homework, hints, ["1.17: notebook: code cell 2: NameError"], 3.5, 12.4
        )
    )
    assert result == {
        "score": 3.5,
        "output": "1.17: notebook: code cell 2: NameError",
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "execution_time": 12,
        "tests": [
            test | {"output_format": "text", "visibility": "visible"}
            for test in (
                {
                    "name": "1.17 a_region",
                    "score": 2.5,
                    "max_score": 2.5,
                    "status": "passed",
                    "output": "right: a_region is right",
                },
                {
                    "name": "1.17 b_region",
                    "score": 0.0,
                    "max_score": 2.5,
                    "status": "failed",
                    "output": "wrong: b_region is wrong\nThe notebook has 2 hints to this answer.",
                },
                {
                    "name": "1.18 a_region",
                    "score": 0.5,
                    "max_score": 1.0,
                    "status": "failed",
                    "output": "missing: nothing was submitted for this problem",
                },
                {
                    "name": "1.18 b_region",
                    "score": 0.0,
                    "max_score": 1.0,
                    "status": "failed",
                    "output": "missing: nothing was submitted for this problem",
                },
            )
        ],
    }
    for score in small:
        result = json.loads(exporting.gradescope_json(score, homework, {}, [], score.points, 0.1))
        assert all(isinstance(result[key], RESULT[key]) for key in result)
        assert all(
            isinstance(test[key], TEST[key]) and set(test) == set(TEST)
            for test in result["tests"]
            for key in test
        )
        assert sum(test["score"] for test in result["tests"]) == pytest.approx(result["score"])
    (unchecked,) = [
        test
        for test in json.loads(exporting.gradescope_json(cid, homework, {}, [], 1.0, 0.1))["tests"]
        if "unchecked" in test["output"]
    ]
    assert "It is not judged wrong" in unchecked["output"]
    keeping = dataclasses.replace(homework, kept_for_grading=("1.17.a_region",))
    tests = json.loads(exporting.gradescope_json(cid, keeping, {}, [], 1.0, 0.1))["tests"]
    assert {test["name"] for test in tests if test["visibility"] != "visible"} == {"1.17 a_region"}
    assert MISSING not in {
        test["status"]
        for test in json.loads(exporting.gradescope_json(dan, homework, {}, [], 0.0, 0.1))["tests"]
    }


# The way back


def collected(tmp_path, names):
    """Collect files of these names, and return the lines of the ledger."""
    with zipfile.ZipFile(tmp_path / "all.zip", "w") as archive:
        for name in names:
            archive.writestr(name, name)
    collecting.collect(tmp_path / "all.zip", "hw1", tmp_path / "submitted")
    return ledger.read(tmp_path / "submitted")


def moodle_reads(name, participants):
    """Return the participant and the name of a feedback file, as Moodle's importer splits it."""
    _, number, plugin_type, plugin, file = name.split("_", 4)
    assert (plugin_type, plugin) == ("assignsubmission", "file") and number in participants
    return number, file


def canvas_reads(name):
    """Return the numbers of user and attachment, as Canvas infers them from a name."""
    return [part for part in name.split("_") if part.isdigit()][:2]


@pytest.mark.parametrize("flat", [False, True])
def test_moodle_knows_whose_each_page_is(tmp_path, flat):
    mark = "_" if flat else "/"
    names = [
        f"Ann Äble_1101_assignsubmission_file{mark}a.ipynb",
        f"Bob_7_assignsubmission_file{mark}b_9_c.ipynb",
    ]
    entries = collected(tmp_path, names)
    pages = {entry.student: f"page of {entry.number}" for entry in entries}
    archives = handing_back.archives(pages, entries)
    assert list(archives) == ["feedback-moodle.zip"]
    assert archives == handing_back.archives(pages, entries), "the same bytes"
    with zipfile.ZipFile(io.BytesIO(archives["feedback-moodle.zip"])) as archive:
        assert len(archive.namelist()) == 2
        for name in archive.namelist():
            number, file = moodle_reads(name, {"1101", "7"})
            assert file == "feedback.html" and archive.read(name).decode() == f"page of {number}"


def test_canvas_knows_whose_each_page_is(tmp_path):
    names = [
        "ableann_101_9001_ch1_5.ipynb",
        "beebob_LATE_102_9002_x.zip",
        "ceecid_103_9003_x.ipynb",
    ]
    entries = collected(tmp_path, names)
    pages = {
        entry.student: f"page of {entry.number}" for entry in entries if entry.student != "103"
    }
    archives = handing_back.archives(pages, entries)
    assert list(archives) == ["feedback-canvas.zip"]
    with zipfile.ZipFile(io.BytesIO(archives["feedback-canvas.zip"])) as archive:
        assert {
            tuple(canvas_reads(name)): archive.read(name).decode() for name in archive.namelist()
        } == {
            ("101", "9001"): "page of 101",
            ("102", "9002"): "page of 102",
        }
        assert all(name.endswith("_feedback.html") for name in archive.namelist())


def test_without_a_ledger_there_is_no_archive(small):
    assert handing_back.archives({score.student: "" for score in small}, []) == {}


def test_a_table_for_a_mail_merge(store, homework):
    for student in ("ann@uni.example", "bob"):
        graded(store, student, "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    class_scores = scores(store, homework, ["dan"])
    entry = ledger.Entry("hw1", "bob", "7", "=Bob")
    names = {score.student: f"feedback/{score.student}.html" for score in class_scores}
    _, ann, bob, dan = rows(handing_back.mail_merge(class_scores, [entry], names))
    assert ann[0] == "ann@uni.example" and ann[-1] == "feedback/ann@uni.example.html"
    assert bob[:3] == ["", "'=Bob", "bob"] and dan[-2] == "no"
