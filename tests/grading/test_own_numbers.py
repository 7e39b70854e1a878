"""A homework in which each student has numbers of their own, from the table to the points."""

import csv
import io
import json
import shutil
import sys
import zipfile
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_18, RIGHT_2_4, SITE_2_4, an_assignment, notebook, write_assignment

from workbook import own_numbers
from workbook.authoring.variants import variants_of
from workbook.grading import commands
from workbook.grading.course import (
    handing_out,
    notebook_for_all,
    numbers,
    student_archives,
    student_folders,
)
from workbook.grading.course.assignment import AssignmentError, InputError
from workbook.grading.course.options import GradingOptions
from workbook.grading.gradescope import bundle
from workbook.grading.reports.canvas import read_roster
from workbook.grading.sandbox.limits import Limits
from workbook.notebooks import exercises

ROOT = Path(__file__).resolve().parents[2]
CLASS = ["ann", "ben", "cat", "dan", "eva", "fay"]


@pytest.mark.parametrize("count", [6, 16, 40])
def test_no_row_is_drawn_twice_before_each_was_drawn_once(count):
    rows = {"2.4": list(range(1, 17)), "3.8": [2, 5]}
    table = numbers.draw({"s0": {"2.4": 3}}, [f"s{k}" for k in range(count)], rows)
    assert len(table) == count and table["s0"]["2.4"] == 3
    for problem, proved in rows.items():
        times = Counter(own[problem] for own in table.values())
        assert set(times) <= set(proved) and max(times.values()) == -(-count // len(proved))
    assert {"s0", "s1"} <= numbers.draw(table, ["s1"], rows).keys()
    assert numbers.draw(table, list(table), rows) == table


def test_a_table_is_read_as_it_was_written_and_edited(tmp_path):
    table = {"ann": {"2.4": 3, "3.8": 1}, "Li, Wei": {"3.8": 2}}
    path = tmp_path / numbers.NAME
    path.write_text(numbers.text(table, ["2.4", "3.8"]), encoding="utf-8")
    assert numbers.read(path) == table
    path.write_text("student;2.4\r\nann; 3\r\n", encoding="utf-8")  # by a spreadsheet
    assert numbers.read(path) == {"ann": {"2.4": 3}}


@pytest.mark.parametrize(
    "text, message",
    [
        ("student,2.4\nann,0\n", "no row of 2.4 for ann"),
        ("student,2.4\nann,three\n", "no row of 2.4 for ann"),
        ("student,2.4\nann,1\nann,2\n", "ann stands there twice"),
        ("student,2.5\nann,1\n", "2.5 is no problem of the homework"),
        ("", "the first line names the problems"),
    ],
)
def test_a_table_that_cannot_be_used(tmp_path, text, message):
    path = write_assignment(tmp_path, 'problems = ["2.4"]')
    path.with_name(numbers.NAME).write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message):
        numbers.read_homework(path)


def test_whose_numbers_a_student_has(tmp_path):
    homework = replace(
        an_assignment(tmp_path, 'problems = ["2.4", "1.15"]'),
        numbers={"ann": {"2.4": 3}, "ben": {"2.4": 5}},
    )
    assert homework.variant("2.4", "ann") == "2.4~3"
    assert homework.other_variants("2.4", "ann") == ["2.4", "2.4~5"]
    assert homework.row("2.4", "eva") is None  # who was forgotten
    assert homework.variant("1.15", "ann") == "1.15"  # the same for all
    assert homework.other_variants("1.15", "ann") == []


def test_what_cannot_be_handed_out(tmp_path):
    def homework(problem, table=""):
        path = write_assignment(tmp_path, f'problems = ["{problem}"]')
        path.with_name("README.md").write_text("How to work", encoding="utf-8")
        path.with_name(numbers.NAME).write_text(table or f"student,{problem}\n", encoding="utf-8")

    for problem, table, students, message in [
        ("1.4", "", CLASS, "none of the problems 1.4 varies"),
        ("2.4", "", [], "give --roster"),
        ("2.4", "", ["../ann"], "cannot be the name of a folder"),
        ("2.4", "student,2.4\nann,999\n", [], "no proved row 999"),
    ]:
        homework(problem, table)
        with pytest.raises(InputError, match=message):
            student_folders.hand_out(tmp_path / "assignments", "hw1", students)
    with pytest.raises(InputError, match="hands the same file to all"):
        bundle.make(tmp_path / "assignments", "hw1", tmp_path / "out.zip")


def test_an_archive_for_moodle(tmp_path):
    target = tmp_path / "assignments" / "hw1"
    for student in ("ann@uni.example", "dan@uni.example"):
        (target / "students" / student).mkdir(parents=True)
        (target / "students" / student / "ch2-p04.ipynb").write_text(student, encoding="utf-8")
    table = {"ann@uni.example": {"2.4": 3}, "dan@uni.example": {"2.4": 4}}
    (target / numbers.NAME).write_text(numbers.text(table, ["2.4"]), encoding="utf-8")
    worksheet = tmp_path / "worksheet.csv"
    header = "Identifier,Full name,Email address,Status,Grade\n"
    worksheet.write_text(
        f"{header}Participant 1101,Ann_Able,ann@uni.example,,\n"
        "Participant 1102,Bob Bee,bob@uni.example,,\n",
        encoding="utf-8",
    )
    assert read_roster(worksheet).identities([]) == ["ann@uni.example", "bob@uni.example"]
    path, absent = student_archives.moodle_archive(tmp_path / "assignments", "hw1", worksheet)
    with zipfile.ZipFile(path) as archive:
        # Moodle splits the name at its underscores: name, participant, plugin
        assert archive.namelist() == ["Ann Able_1101_assignfeedback_file/ch2-p04.ipynb"]
        assert archive.read(archive.namelist()[0]) == b"ann@uni.example"
    assert absent == ["dan@uni.example"]
    worksheet.write_text(f"{header}Participant 1102,Bob Bee,bob@uni.example,,\n", encoding="utf-8")
    with pytest.raises(InputError, match="addresses of none of the students"):
        student_archives.moodle_archive(tmp_path / "assignments", "hw1", worksheet)


def test_an_archive_for_canvas(tmp_path):
    """Canvas attaches a file to the submission by the two numbers before its name."""
    target = tmp_path / "assignments" / "hw1"
    for student in ("101", "102", "103"):
        (target / "students" / student).mkdir(parents=True)
        (target / "students" / student / "ch2-p04.ipynb").write_text(student, encoding="utf-8")
    table = {student: {"2.4": 3} for student in ("101", "102", "103")}
    (target / numbers.NAME).write_text(numbers.text(table, ["2.4"]), encoding="utf-8")
    gradebook = tmp_path / "canvas.csv"
    gradebook.write_text(
        "Student,ID,SIS User ID,SIS Login ID,Section,HW (4711)\n"
        '"Able, Ann",101,u101,ann,G,\n"Bee, Bob",102,u102,bob,G,\n"Cee, Cid",103,u103,cid,G,\n',
        encoding="utf-8",
    )
    download = tmp_path / "submissions.zip"
    names = [
        "ableann_101_9001_ch2-p04.ipynb",
        "beebob_LATE_102_9002_ch2-p04-1.ipynb",
        "beebob_LATE_102_9003_ch2-p07.ipynb",  # not of this homework
        "ceecid_103_9004_notes.pdf",
        "deedan_104_9005_ch2-p04.ipynb",  # not in the table
    ]
    with zipfile.ZipFile(download, "w") as archive:
        for name in names:
            archive.writestr(name, "{}")
    roster = read_roster(gradebook)
    path, absent = student_archives.canvas_archive(
        tmp_path / "assignments", "hw1", download, roster
    )
    with zipfile.ZipFile(path) as archive:
        assert {name: archive.read(name) for name in archive.namelist()} == {
            names[0]: b"101",
            names[1]: b"102",
        }
    assert absent == ["103"]
    with zipfile.ZipFile(download, "w") as archive:
        archive.writestr(names[-1], "{}")
    with pytest.raises(InputError, match="of none of its students"):
        student_archives.canvas_archive(tmp_path / "assignments", "hw1", download)


POOL = 'problems = ["2.4"]\npool = ["1.15", "1.17", "3.3"]\n'


def test_all_problems_of_a_pool_are_worth_the_same(tmp_path):
    homework = replace(
        an_assignment(tmp_path, POOL), numbers={"ann": {"pool": "1.17"}, "ben": {"pool": "3.3"}}
    )
    assert homework.max_points == 3 + 5
    for student, problem in (("ann", "1.17"), ("ben", "3.3"), ("eva", "1.15")):
        points = homework.points_of(student)
        assert sum(points[problem].values()) == pytest.approx(5)
        assert sum(sum(answers.values()) for answers in points.values()) == pytest.approx(8)
        assert homework.row(problem, student) == (None if student == "eva" else 0)
    assert homework.row("1.15", "ann") is None
    worth = an_assignment(tmp_path, POOL + '[points]\npool = 10\n"1.15.a_region" = 2')
    assert worth.max_points == 13 and worth.points["1.15"]["b_region"] == 2


@pytest.mark.parametrize(
    "text, message",
    [
        ('pool = ["1.15"]', "pool is a list"),
        ('pool = "1.15"', "pool is a list"),
        ('problems = ["1.15"]\npool = ["1.15", "1.17"]', "names a problem twice"),
        (POOL + '[points]\n"1.17" = 1', "the problems of the pool are worth the same"),
        ("problems = []", "problems is a list"),
    ],
)
def test_a_pool_that_cannot_be_used(tmp_path, text, message):
    with pytest.raises(AssignmentError, match=message):
        an_assignment(tmp_path, text)


def test_each_student_has_one_problem_of_a_pool(tmp_path):
    assignments = tmp_path / "assignments"
    handing_out.make(assignments, "hw1", [], own_numbers=True, pool=["1.18", "1.4"])
    table = student_folders.hand_out(assignments, "hw1", CLASS)
    assert Counter(own["pool"] for own in table.values()) == {"1.18": 3, "1.4": 3}
    path = assignments / "hw1" / numbers.NAME
    assert numbers.read(path) == table
    path.write_text("student,pool\nann,1.18\nben,1.4\n", encoding="utf-8")

    def submit(student):
        file = tmp_path / "submitted" / student / "hw1" / "ch1-p18.ipynb"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps(notebook("1.18", RIGHT_1_18)), encoding="utf-8")

    submit("ann")
    submit("ben")  # right, and not asked of him
    grade = GradingOptions(
        tmp_path / "submitted",
        tmp_path / "graded",
        assignments,
        1,
        limits=Limits.of_time(60),
        quiet=True,
    )
    if table["ann"]["pool"] == table["ben"]["pool"]:  # their folders are those of the draw
        with pytest.raises(InputError, match="ch1-p(18|04).ipynb: numbers.csv says 1"):
            commands.grade_course(grade)
    student_folders.hand_out(assignments, "hw1")
    folders = assignments / "hw1" / "students"
    assert [file.name for file in folders.glob("ben/*.ipynb")] == ["ch1-p04.ipynb"]
    result = commands.grade_course(grade)
    assert result["assignments"]["hw1"] == {"ann": 2.0, "ben": 0.0}
    assert [reason for _, reason in result["left aside"]] == [
        "numbers.csv says 1.4 for ben, not 1.18"
    ]
    path.write_text("student,pool\nann,2.4\n", encoding="utf-8")
    with pytest.raises(InputError, match="2.4, which ann has, is not in the pool"):
        commands.grade_course(grade)
    path.unlink()
    with pytest.raises(InputError, match="who has which problem of the pool"):
        commands.grade_course(grade)


def test_a_notebook_for_all_does_not_decide(tmp_path, monkeypatch):
    """It shows a row by name; a student who writes another name is graded by the own row."""
    assignments = tmp_path / "assignments"
    handing_out.make(assignments, "hw1", ["2.4"], own_numbers=True)
    path = assignments / "hw1" / numbers.NAME
    path.write_text("student,2.4\nann,1\nben,2\ncat,3\n", encoding="utf-8")
    student_folders.proved_rows(["2.4"])
    (file,) = notebook_for_all.write(assignments, "hw1")
    homework = numbers.read_homework(path.with_name("assignment.toml"))
    text = file.read_text(encoding="utf-8")
    assert "ann" not in text and json.loads(text)["metadata"]["workbook"]["number"] == "2.4"
    for row in (1, 2, 3):  # the texts and numbers are those of the student's own notebook
        shown = _run_for_all(text, ("ann", "ben", "cat")[row - 1], monkeypatch)
        own = json.loads(handing_out.release(homework, f"2.4~{row}"))
        assert shown[0] == own["cells"][0]["source"].replace(f"2.4~{row}", "2.4")
        names = variants_of(ROOT, "2.4").names(row)
        assert shown[-1] == tuple(names[n] for n in ("weight", "friction", "stiffness"))
    with pytest.raises(ValueError, match="'eve' is nobody in the course"):
        _run_for_all(text, "eve", monkeypatch)
    for student, name in (("ann", '"ann"'), ("ben", '"ann"'), ("cat", "...")):
        document = notebook("2.4", RIGHT_2_4)
        document["cells"] = [
            answered if "answer" in cell["metadata"].get("tags", ()) else cell
            for cell, answered in _with_answers(json.loads(text)["cells"])
        ]
        document["cells"][0]["source"] = f"student = {name}"
        target = tmp_path / "submitted" / student / "hw1" / "ch2-p04.ipynb"
        target.parent.mkdir(parents=True)
        target.write_text(json.dumps(document), encoding="utf-8")
    result = commands.grade_course(
        GradingOptions(
            tmp_path / "submitted",
            tmp_path / "graded",
            assignments,
            1,
            limits=Limits.of_time(60),
            quiet=True,
        )
    )
    assert result["assignments"]["hw1"] == {"ann": 3.0, "ben": 0.0, "cat": 3.0}


def _with_answers(cells):
    for cell in cells:
        name = "".join(cell["source"]).rpartition("\n")[2].partition(" = ")[0]
        yield cell, cell | {"source": f"{name} = {RIGHT_2_4.get(name)}"}


def _run_for_all(text, student, monkeypatch):
    """Return the texts that the notebook for all shows to a student, and the numbers of its data."""
    shown, names = [], {}
    monkeypatch.setattr(own_numbers, "show", lambda texts, row: shown.append(texts[row]))
    for cell in json.loads(text)["cells"]:
        source = "".join(cell["source"])
        tags = cell["metadata"].get("tags", ())
        if cell["cell_type"] == "code" and not {"setup", "answer", "check", "steps"} & set(tags):
            exec(source.replace("student = ...", f"student = {student!r}"), names)
    return [*shown, tuple(names[name] for name in ("weight", "friction", "stiffness"))]


def test_six_students(tmp_path):
    """Own work earns everything; a friend's, the site's and a smuggled data cell earn nothing."""
    assignments = tmp_path / "assignments"
    handing_out.make(assignments, "hw1", ["2.4"], own_numbers=True)
    table = student_folders.hand_out(assignments, "hw1", CLASS)
    # rows without a common weight or root with row 0 or each other, so that nothing is right by luck
    rows = dict(zip(CLASS, (1, 2, 3, 4, 13, 10)))
    assert set(table) == set(CLASS) and len({own["2.4"] for own in table.values()}) == 6
    path = assignments / "hw1" / numbers.NAME
    path.write_text(
        numbers.text({name: {"2.4": row} for name, row in rows.items() if name != "fay"}, ["2.4"]),
        encoding="utf-8",
    )
    shutil.rmtree(assignments / "hw1" / "students" / "fay")
    student_folders.hand_out(assignments, "hw1", site="https://site.example")
    folders = assignments / "hw1" / "students"
    assert not list((assignments / "hw1").glob("*.ipynb"))

    def submit(student, document):
        path = tmp_path / "submitted" / student / "hw1" / "ch2-p04.ipynb"
        path.parent.mkdir(parents=True)
        path.write_text(json.dumps(document), encoding="utf-8")

    def solved(student, answers):
        return notebook(f"2.4~{rows[student]}", answers)

    own = json.loads((folders / "ann" / "ch2-p04.ipynb").read_text(encoding="utf-8"))
    assert own["metadata"]["workbook"]["number"] == "2.4~1" and "site.example" in json.dumps(own)
    submit("ann", solved("ann", RIGHT_2_4))
    submit("ben", solved("ann", _written_out(rows["ann"])))  # a friend's, with its data cell
    submit("cat", solved("cat", SITE_2_4))
    smuggled = solved("dan", SITE_2_4)
    for cell in smuggled["cells"]:
        if cell["metadata"].get("tags") == ["data"]:
            cell["source"] = exercises.find("2.4").code("data")[0][1]
    submit("dan", smuggled)
    submit(
        "eva",
        solved("eva", RIGHT_2_4 | {"b_unobservable_states": SITE_2_4["b_unobservable_states"]}),
    )
    submit("fay", solved("fay", RIGHT_2_4))

    result = commands.grade_course(
        GradingOptions(
            tmp_path / "submitted",
            tmp_path / "graded",
            assignments,
            1,
            limits=Limits.of_time(60),
            quiet=True,
        )
    )
    assert result["assignments"]["hw1"] == {
        "ann": 3.0,
        "ben": 0.0,
        "cat": 0.0,
        "dan": 0.0,
        "eva": 2.0,
        "fay": 0.0,
    }
    assert [reason for _, reason in result["left aside"]] == [
        "numbers.csv has no row of 2.4 for fay: add it"
    ]
    summary = (tmp_path / "graded" / "hw1" / "summary.html").read_text(encoding="utf-8")
    part = summary.partition("Right for other numbers")[2]
    assert part.count("row 0 (the site)") == 3 and "row 1 (" in part
    everything = "a_observable, b_unobservable, b_unobservable_states"
    assert part.count(everything) == 3 and part.count("<code>b_unobservable_states</code>") == 1
    for name in ("ben", "cat"):
        page = next((tmp_path / "graded" / "hw1").rglob(f"*{name}*.html")).read_text("utf-8")
        assert "2.4~" in page and "right for row" not in page
    record = json.loads((tmp_path / "graded" / "hw1" / "grades.json").read_text("utf-8"))
    assert record["students"]["ben"]["numbers"] == {"2.4": 2}

    # a row given to somebody else, of which the folder does not know
    path.write_text(path.read_text("utf-8").replace("eva,13", "eva,10"), encoding="utf-8")
    with pytest.raises(InputError, match=r"eva/ch2-p04\.ipynb: it has other numbers than 2\.4~10"):
        commands.grade_course(
            GradingOptions(
                tmp_path / "submitted",
                tmp_path / "graded",
                assignments,
                1,
                limits=Limits.of_time(60),
                quiet=True,
            )
        )
    path.write_text(path.read_text("utf-8").replace("eva,10", "eva,13"), encoding="utf-8")
    # a line added for fay: she is graded, and nobody else again
    path.write_text(path.read_text("utf-8") + f"fay,{rows['fay']}\n", encoding="utf-8")
    again = commands.grade_course(
        GradingOptions(
            tmp_path / "submitted",
            tmp_path / "graded",
            assignments,
            1,
            limits=Limits.of_time(60),
            quiet=True,
        )
    )
    assert (again["graded"], again["assignments"]["hw1"]["fay"]) == (1, 3.0)
    lines = csv.DictReader(io.StringIO(path.read_text("utf-8")))
    assert {line["student"]: int(line["2.4"]) for line in lines} == rows


def _written_out(row):
    """Return right answers for a row of problem 2.4 as a student writes them, in numbers."""
    variants = variants_of(ROOT, "2.4")
    weight, friction, stiffness = variants.numbers.rows[row]
    p, q = sorted(-root for root in variants.names(row)["b_matrix"].eigenvals())
    return {
        "a_observable": f"sp.Ne({weight}*alpha - beta, {weight**2})",
        "b_unobservable": f"sp.Eq(h**2 - {friction}*h + {stiffness}, 0)",
        "b_unobservable_states": f"{{{p}: [[1, {-p}]], {q}: [[1, {-q}]]}}",
    }
