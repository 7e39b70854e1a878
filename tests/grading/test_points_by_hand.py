"""Points by hand: items without a check, tables out and in, and the copy outside the store."""

import base64
import contextlib
import csv
import hashlib
import html
import io
import json
import random
import re
import sys
import threading
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, graded, hand_in, notebook

from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, Verdict
from workbook.grading import commands
from workbook.grading.course import handing_out, submissions, text_cells
from workbook.grading.course.assignment import AssignmentError, InputError
from workbook.grading.course.store import COPY, HandPoints, Store
from workbook.grading.pool import grader
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports import points_by_hand
from workbook.grading.reports.feedback import feedback
from workbook.grading.reports.scores import scores
from workbook.grading.reports.text_page import text_page
from workbook.notebooks.execution import Child

HOMEWORK = (
    'problems = ["1.17"]\n[by_hand]\nsketch = {points = 3, text = "a sketch of <1.4>, on paper"}\n'
)

TABLES = ("grades.csv", "moodle.csv", "mail-merge.csv", "grades.json")


def grade(tmp_path, store, homework, students=()):
    result = scores(store, homework, students)
    commands.write(tmp_path / "graded" / "hw1", homework, result, "now")
    return {score.student: score for score in result}


@pytest.fixture
def three(tmp_path, store, homework):
    """Ann has handed in what no check could judge; Bob all right; Cid nothing."""
    graded(store, "ann", "1.17", {"a_region": UNCHECKED, "b_region": RIGHT})
    graded(store, "bob", "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    return grade(tmp_path, store, homework, ["cid"])


def rows(path):
    return list(csv.reader(io.StringIO(path.read_text(encoding="utf-8-sig"), newline="")))


def test_items_without_a_check_wait_for_the_lecturer(three, tmp_path, store, homework):
    assert homework.max_points == 5 and three["bob"].points == 2 and three["bob"].needs_review
    assert three["cid"].is_absent and not three["cid"].needs_review
    page = feedback(homework, three["bob"])
    assert "Graded by your lecturer" in page and "a sketch of &lt;1.4&gt;, on paper" in page
    assert "your lecturer grades this by hand" in page and "Nothing was submitted" not in page
    header = rows(tmp_path / "graded" / "hw1" / "grades.csv")[0]
    assert header[1:4] == ["1.17", "by_hand", "total"]
    points_by_hand.score_by_hand(tmp_path / "graded", "bob", "hw1", "by_hand", "sketch", 2.5)
    points_by_hand.score_by_hand(tmp_path / "graded", "cid", "hw1", "by_hand", "sketch", 1)
    after = grade(tmp_path, store, homework, ["cid"])
    assert (after["bob"].points, after["bob"].needs_review) == (4.5, False)
    assert (after["cid"].points, after["cid"].handed_in) == (1, True), "work on paper only"


@pytest.mark.parametrize(
    "text", ["by_hand = 3", "[by_hand]\nx = 3", "[by_hand]\nx = {points = -1, text = 'x'}"]
)
def test_an_item_has_points_and_a_text(tmp_path, text):
    with pytest.raises(AssignmentError, match="by_hand is a table"):
        an_assignment(tmp_path, 'problems = ["1.17"]\n' + text)


def test_a_table_goes_out_and_comes_back(three, tmp_path, store, homework):
    path = tmp_path / "points.csv"
    points_by_hand.score_by_hand(
        tmp_path / "graded", "ann", "hw1", "by_hand", "sketch", 1, "=1+1", "Łoś"
    )
    grade(tmp_path, store, homework, ["cid"])
    assert points_by_hand.export_table(tmp_path / "graded", path) == 3
    header, *lines = rows(path)
    assert [line[1:6] for line in lines] == [
        ["ann", "1.17", "a_region", "1", ""],
        ["ann", "by_hand", "sketch", "3", "1"],
        ["bob", "by_hand", "sketch", "3", ""],
    ]
    assert lines[1][6] == "'=1+1", "no formula for a spreadsheet"
    lines[0][5], lines[0][6] = "0,5", "half;\nof it"  # as a German spreadsheet saves it
    text = io.StringIO()
    csv.writer(text, delimiter=";").writerows([header, *lines])
    path.write_text(text.getvalue(), encoding="utf-8")
    assert points_by_hand.import_table(tmp_path / "graded", path, "Lund") == 2
    given = store.manual("hw1")
    assert [given[("ann", *key)].by for key in [("1.17", "a_region"), ("by_hand", "sketch")]] == [
        "Lund",
        "Łoś",
    ]
    after = grade(tmp_path, store, homework, ["cid"])
    assert after["ann"].points == 0.5 + 1 + 1 and after["ann"].answers[0].manual == "half;\nof it"
    assert after["ann"].answers[2].manual == "=1+1" and after["bob"].needs_review


@pytest.mark.parametrize(
    "line, message",
    [
        ("hw1,bob,by_hand,sketch,4", "row 3 is worth 3 points"),
        ("hw1,bob,by_hand,sketch,x", "row 3: points is 'x', and is to be a number from 0 to 3"),
        ("hw1,bob,by_hand,sketch,nan", "row 3 is worth 3 points"),
        ("hw1,zoe,by_hand,sketch,1", "row 3: hw1 has no student zoe"),
        ("hw1,bob,by_hand,essay,1", "row 3: hw1 asks for no by_hand essay"),
        ("hw9,bob,by_hand,sketch,1", "row 3: there are no grades of hw9"),
        ("hw1,ann,by_hand,sketch,1", "row 3: ann, hw1, by_hand, sketch has another row above"),
    ],
)
def test_a_table_with_an_error_changes_nothing(three, tmp_path, store, line, message):
    path = tmp_path / "points.csv"
    path.write_text(f"assignment,student,problem,answer,points\nhw1,ann,by_hand,sketch,2\n{line}\n")
    with pytest.raises(InputError, match=message):
        points_by_hand.import_table(tmp_path / "graded", path)
    assert store.manual("hw1") == {}


@pytest.mark.parametrize("text", ["", "student,points\nann,1\n"])
def test_a_table_without_its_columns_is_refused(three, tmp_path, text):
    (tmp_path / "points.csv").write_text(text)
    with pytest.raises(InputError, match="has no column assignment"):
        points_by_hand.import_table(tmp_path / "graded", tmp_path / "points.csv")


def test_a_torn_store_loses_no_points_by_hand(tmp_path):
    path = tmp_path / "graded" / "grades.sqlite"
    entries = {
        ("ann", "1.17", "a_region"): HandPoints(0.5, 'half;\n"=of" it', "Prof. Łoś"),
        ("bob", "1.17", "a_region"): HandPoints(1),
    }
    with Store(path) as store:
        for (student, *answer), entry in entries.items():
            store.set_points({(student, "hw1", *answer): entry})
        store.set_points({("cid", "hw1", "1.17", "a_region"): HandPoints(1, "")})
        assert store.take_back("cid", "hw1", "1.17", "a_region")
    path.write_bytes(b"torn" + path.read_bytes()[4:])
    with pytest.raises(InputError, match=f"move it away.*run workbook grade.*{COPY}"), Store(path):
        pass
    for file in path.parent.glob("grades.sqlite*"):
        file.unlink()
    with Store(path) as store:
        assert store.manual("hw1") == entries


def test_a_copy_that_was_changed_by_hand_is_an_error(tmp_path):
    (tmp_path / COPY).write_text("student,points\nann,1\n")
    with pytest.raises(InputError, match="is not as workbook score wrote it"):
        Store(tmp_path / "grades.sqlite")


# Text cells


def with_cells(number, *cells):
    data = notebook(number, {})
    data["cells"] += [{"cell_type": kind, "metadata": {}, "source": text} for kind, text in cells]
    return data


def test_the_page_has_each_students_own_text_beside_fields(three, tmp_path, homework):
    path = hand_in(tmp_path, "ann", "1.17", {})
    data = with_cells(
        "1.17", ("markdown", "Because <b>k</b> > 0,\n$x = 1$."), ("raw", "</pre>\x1b")
    )
    path.write_text(json.dumps(data))
    released = hand_in(tmp_path, "bob", "1.17", {})
    released.write_text(handing_out.release(homework, "1.17", "https://example.org"))
    texts = text_cells.read(tmp_path / "submitted", homework)
    assert texts == {"ann": [("ch1-p17.ipynb", ["Because <b>k</b> > 0,\n$x = 1$.", "</pre>\\x1b"])]}
    page = text_page(homework, three.values(), texts)
    assert "Because &lt;b&gt;k&lt;/b&gt; &gt; 0,\n$x = 1$." in page and "&lt;/pre&gt;" in page
    keys = [json.loads(html.unescape(key)) for key in re.findall(r'data-key="([^"]*)"', page)]
    assert keys == [
        ["hw1", "ann", "1.17", "a_region"],
        ["hw1", "ann", "by_hand", "sketch"],
        ["hw1", "bob", "by_hand", "sketch"],
    ]
    digest = re.search(r"script-src 'sha256-([^']+)'", page)[1]
    script = re.search(r"<script>(.*)</script>", page, re.DOTALL)[1]
    assert base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() == digest


def test_an_answer_cell_turned_into_text_is_reported(tmp_path):
    path = hand_in(tmp_path, "ann", "1.17", {})
    data = with_cells("1.17", ("markdown", "a_region = (omega2 > 0)\nso b_region == 3\n    c = 1"))
    path.write_text(json.dumps(data))
    (submission,) = submissions.find(tmp_path / "submitted")
    assert submission.names_in_text == ("a_region",)
    verdicts = {"a_region": Verdict(MISSING, ""), "b_region": Verdict(RIGHT, "")}
    judgement = grader.with_text_cells(Judgement(verdicts, {}, ()), submission.names_in_text)
    (remark,) = judgement.remarks
    assert remark.startswith("notebook: a_region stands in a cell of text, which is not run")
    verdicts["a_region"] = Verdict(RIGHT, "")
    assert grader.with_text_cells(Judgement(verdicts, {}, ()), ("a_region",)).remarks == ()


def _give(folder, given):
    for (student, answer), points in given:
        problem = "by_hand" if answer == "sketch" else "1.17"
        points_by_hand.score_by_hand(folder, student, "hw1", problem, answer, points, "seen")


def test_killed_twenty_times_while_points_are_given(three, tmp_path, store, homework):
    """The store and its copy are whole after each kill; the tables are as without one."""
    folder, numbers = tmp_path / "graded", random.Random(3)
    given = [(("ann", "a_region"), 0.5), (("ann", "sketch"), 2.5), (("bob", "sketch"), 3)]
    kills = 0
    while kills < 20:
        child = Child(_give, folder, 20 * given)
        killer = threading.Timer(numbers.random() * 0.2, child._process.kill)
        killer.start()
        with contextlib.suppress(RuntimeError):
            child.result(timeout=60)
        kills += child._process.exitcode not in (0, None)
        killer.join()
        child.end()
        known = {
            (student, answer): p.points for (student, _, answer), p in store.manual("hw1").items()
        }
        assert known.items() <= dict(given).items()
    _give(folder, given)
    grade(tmp_path, store, homework, ["cid"])
    killed = {name: (folder / "hw1" / name).read_text() for name in TABLES}
    with Store(tmp_path / "calm" / "grades.sqlite") as calm:
        graded(calm, "ann", "1.17", {"a_region": UNCHECKED, "b_region": RIGHT})
        graded(calm, "bob", "1.17", {"a_region": RIGHT, "b_region": RIGHT})
        commands.write(tmp_path / "calm" / "hw1", homework, scores(calm, homework, ["cid"]), "now")
        _give(tmp_path / "calm", given)
        commands.write(tmp_path / "calm" / "hw1", homework, scores(calm, homework, ["cid"]), "now")
    assert killed == {name: (tmp_path / "calm" / "hw1" / name).read_text() for name in TABLES}
