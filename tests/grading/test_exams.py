"""Exams: papers are built and graded, and nothing judges an answer before the grading."""

import json
import re
import shlex
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment
from guide import like, steps

from workbook import checks
from workbook.authoring import read_master
from workbook.cli import app
from workbook.grading import commands
from workbook.grading.course import assignment as assignments
from workbook.grading.course import exams, handing_out, text_cells
from workbook.grading.course.assignment import AssignmentError, Exam
from workbook.grading.course.options import GradingOptions
from workbook.grading.sandbox.limits import Limits
from workbook.notebooks import exercises
from workbook.notebooks.new_cells import new_code_cell

ROOT = Path(__file__).resolve().parents[2]
TOTALS = {
    "linear-control-midterm": 40,
    "linear-control-exam": 70,
    "estimation-midterm": 40,
    "estimation-exam": 70,
}
EXAM = 'problems = ["2.4"]\n[exam]\nminutes = 30\n'


def run(*arguments):
    return CliRunner().invoke(app, list(map(str, arguments)))


def cells(path, tag):
    return [
        "".join(cell["source"])
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if tag in cell["metadata"].get("tags", ())
    ]


def solve(path, problem):
    """Put the computations of the master into a handed-out notebook, in place of its stubs."""
    document = json.loads(path.read_text(encoding="utf-8"))
    worked = read_master(exercises.master_path(problem)).code("answer")
    tags = [cell["metadata"].get("tags", ()) for cell in document["cells"]]
    first = next(k for k, tag in enumerate(tags) if "answer" in tag)
    rest = [cell for cell, tag in zip(document["cells"], tags) if "answer" not in tag]
    rest[first:first] = [new_code_cell(source, tags=["answer"]) for source in worked]
    path.write_text(json.dumps(document | {"cells": rest}), encoding="utf-8")


def test_the_papers_have_their_marks_and_problems_that_vary():
    assert {name: exams.find(name).title for name in exams.papers()}.keys() == TOTALS.keys()
    for name, total in TOTALS.items():
        paper = exams.find(name)
        marks = sum(sum(answers.values()) for answers in paper.marks.values())
        assert marks + sum(item["points"] for item in paper.by_hand.values()) == total
        assert sum(map(len, paper.marks.values())) * 6 <= paper.exam.minutes
        for problem in paper.marks:
            assert read_master(exercises.master_path(problem)).numbers, f"{problem} does not vary"
        for item in paper.by_hand.values():
            assert item["text"].replace(":", " ").split()[0] in paper.marks


@pytest.mark.slow
@pytest.mark.parametrize("name", TOTALS)
def test_a_paper_is_built_and_graded(name, tmp_path):
    """The answers of the masters earn all marks but those by hand; what is untouched earns none."""
    folder = tmp_path / "assignments"
    made = run("assignment", "new", "e", "--exam", "--paper", name, "--assignments", folder)
    assert made.exit_code == 0, made.output
    homework = assignments.read(folder / "e" / "assignment.toml")
    assert homework.exam == exams.find(name).exam and homework.max_points == TOTALS[name]
    for student in ("ann", "ben"):
        target = tmp_path / "submitted" / student / "e"
        target.mkdir(parents=True)
        for problem in homework.problems:
            path = target / handing_out.file_name(problem)
            path.write_bytes((folder / "e" / path.name).read_bytes())
            if student == "ann":
                solve(path, problem)
    result = commands.grade_course(
        GradingOptions(
            tmp_path / "submitted",
            tmp_path / "graded",
            folder,
            1,
            limits=Limits.of_time(60),
            quiet=True,
        )
    )
    by_hand = sum(homework.points[assignments.BY_HAND].values())
    assert result["assignments"]["e"] == {"ann": TOTALS[name] - by_hand, "ben": 0.0}
    # nothing in the notebooks as handed out passes for a text of the student's
    assert text_cells.read(tmp_path / "submitted", homework) == {}


def test_a_notebook_of_an_exam_judges_nothing(tmp_path):
    made = run(
        *("assignment", "new", "e", "2.4", "--exam", "--minutes", "30"),
        *("--assignments", tmp_path, "--title", "Test", "--aids", "a pencil"),
    )
    assert made.exit_code == 0, made.output
    path = tmp_path / "e" / "ch2-p04.ipynb"
    text = path.read_text(encoding="utf-8")
    assert "<summary>Hint" not in text and "Which functions" not in text
    assert not cells(path, "steps") and "checks.observable_parameters(" not in text
    (line,) = cells(path, "instruction")
    assert line.startswith("**Test: 30 minutes for all problems.** This one has 3 marks: ")
    assert "a pencil" in line and exams.HONESTY in line
    for source in cells(path, "check"):
        assert exercises.find("2.4").sources_to_run([source]) != [source], "the grader knows it"
    solve(path, "2.4")
    space = {}
    exec(cells(path, "data")[0], space)
    for source in cells(path, "answer"):
        exec(source, space)
    with checks.collecting() as verdicts:
        for source in cells(path, "check"):
            exec(source, space)
    assert {verdict.status for verdict in verdicts.values()} == {"unchecked"}
    # neither does the command
    checked = run("check", path, "--json")
    found = json.loads(checked.stdout)["verdicts"]
    assert {name: verdict["verdict"] for name, verdict in found.items()} == dict.fromkeys(
        assignments.answers_of("2.4"), "unchecked"
    )
    assert "0 of 0 right; the grading judges 3" in run("check", path).output


def test_the_cover_has_the_marks_and_lines_to_sign(tmp_path):
    run(
        "assignment",
        "new",
        "e",
        "--exam",
        "--paper",
        "linear-control-midterm",
        "--assignments",
        tmp_path,
    )
    cover = (tmp_path / "e" / "cover.html").read_text(encoding="utf-8")
    readme = (tmp_path / "e" / "README.md").read_text(encoding="utf-8")
    for page in (cover, readme):
        assert "Linear control, midterm" in page and "90 minutes" in page and exams.HONESTY in page
        assert "1.15 c: which root crosses each border" in page
    assert "<code>a_region</code> 3, <code>c_region</code> 3, <code>e_region</code> 3" in cover
    assert "http" not in cover and cover.count('<p class="line">') == 3
    not_asked = [
        source
        for source in cells(tmp_path / "e" / "ch1-p15.ipynb", "answer")
        if "NOT ASKED" in source
    ]
    assert [exams.STUB.findall(source) for source in not_asked] == [["b_region"], ["d_region"]]
    (line,) = cells(tmp_path / "e" / "ch1-p15.ipynb", "instruction")
    assert "In words (2 marks), in a text cell or on paper: 1.15 c" in line and "2.4" not in line


def test_a_paper_of_ones_own(tmp_path):
    path = tmp_path / "quiz.toml"
    path.write_text(
        'title = "Quiz"\nminutes = 20\nmarks."1.17" = {a_region = 4}\n', encoding="utf-8"
    )
    made = run(
        "assignment",
        "new",
        "q",
        "--exam",
        "--paper",
        path,
        "--assignments",
        tmp_path,
        "--minutes",
        "25",
    )
    assert "1 problem, 1 answer, 4 points" in made.output
    homework = assignments.read(tmp_path / "q" / "assignment.toml")
    assert homework.exam == Exam(25) and homework.points["1.17"] == {"a_region": 4, "b_region": 0}


@pytest.mark.parametrize(
    "text, message",
    [
        ("title = 3", "a paper has title, minutes"),
        ('title = "Q"\nminutes = 20\nmarks."1.17" = 3', "a paper has title, minutes"),
        ('title = "Q"\nminutes = 20\nmarks."1.17" = {a_region = 0}', "each above 0"),
        ('title = "Q"\nminutes = "x"\nmarks."1.17" = {a_region = 1}', "exam is a table"),
        (
            'title = "Q"\nminutes = 9\nmarks."1.17" = {a_region = 1}\nby_hand.a = 1',
            "by_hand is a table",
        ),
        ("title", "is not TOML"),
    ],
)
def test_a_paper_that_cannot_be_used(tmp_path, text, message):
    path = tmp_path / "quiz.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(AssignmentError, match=message) as error:
        exams.find(str(path))
    assert str(path) in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["--exam"], "give either problems"),
        (["1.15", "--exam"], "needs the time allowed"),
        (["1.15", "--minutes", "30"], "are for an --exam"),
        (["1.15", "--exam", "--minutes", "30", "--direction"], "leave --direction and --keep out"),
        (["--exam", "--paper", "nope"], "there is no paper nope; there are linear-control-midterm"),
    ],
)
def test_options_that_do_not_go_together(tmp_path, arguments, message):
    made = run("assignment", "new", "e", *arguments, "--assignments", tmp_path)
    assert made.exit_code != 0 and message in str(made.exception)


def test_the_policy_of_an_exam(tmp_path):
    homework = an_assignment(tmp_path, EXAM)
    assert homework.exam == Exam(30)
    assert homework.kept_of("2.4") == assignments.answers_of("2.4")
    for text, message in (
        (EXAM.replace("30", "0"), "exam is a table"),
        (EXAM + "hours = 1", "exam is a table"),
        ("direction = true\n" + EXAM, "an exam judges no answer before the grading"),
    ):
        with pytest.raises(AssignmentError, match=message):
            an_assignment(tmp_path, text)


@pytest.mark.slow
def test_the_guide(tmp_path, monkeypatch):
    """Each command of the page prints what the page shows, and its paper is one."""
    page = (ROOT / "book" / "guides" / "exams.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    for _, command, shown in steps(page):
        if command.startswith("workbook "):
            printed = run(*shlex.split(command)[1:]).output
        else:
            printed = "\n".join(
                sorted(path.name for path in (tmp_path / command.split()[1]).iterdir())
            )
        assert like(shown, printed), printed
    (paper,) = re.findall("```toml\n(.*?)```", page, re.DOTALL)
    (tmp_path / "my-midterm.toml").write_text(paper, encoding="utf-8")
    made = run("assignment", "new", "own", "--exam", "--paper", "my-midterm.toml")
    assert "own: 2 problems, 4 answers, 14 points" in made.output
    rows = re.findall(r"^\| `([\w-]+)` \|.*\| (\d+) \| (\d+) \|$", page, re.MULTILINE)
    assert {name: int(marks) for name, marks, _ in rows} == TOTALS
    assert all(exams.find(name).exam.minutes == int(minutes) for name, _, minutes in rows)
