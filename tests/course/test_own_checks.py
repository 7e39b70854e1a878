"""Checks in a course's `checks.py`, that of the guide: where they judge, and what is refused."""

import os
import zipfile

import pytest
from own_problems import REACH, checks_of_the_guide, fill_in
from workbook_command import run

from workbook import checks, course, page
from workbook.authoring import MasterError, new_course, new_problem, read_master
from workbook.checks.course_checks import own_checks
from workbook.grading.course import handing_out
from workbook.grading.gradescope import bundle
from workbook.grading.pool.fingerprint import fingerprint
from workbook.notebooks import exercises

NOTEBOOK = "chrobotics-p04.ipynb"


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A course with the problem that the guide's check judges."""
    folder = tmp_path_factory.mktemp("lecturer") / "robotics"
    new_course(folder)
    (folder / "checks.py").write_text(checks_of_the_guide(), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(course.VARIABLE, str(folder))
        fill_in(*new_problem(folder / "solutions", "robotics.4"), *REACH)
    assert ": proved" in run("prove", "robotics.4", cwd=folder)
    run("exercises", cwd=folder)
    yield folder
    course.read.cache_clear()


@pytest.fixture
def robotics(written, monkeypatch):
    monkeypatch.setenv(course.VARIABLE, str(written))
    text = (written / "checks.py").read_text(encoding="utf-8")
    yield written
    (written / "checks.py").write_text(text, encoding="utf-8")


def answered(notebook, target, answer):
    target.parent.mkdir(parents=True, exist_ok=True)
    text = notebook.read_text(encoding="utf-8")
    target.write_text(text.replace("a_least = ...", f"a_least = {answer}"), encoding="utf-8")
    return target


def test_check_names_the_mistake_and_solve_judges(robotics, tmp_path):
    pristine = robotics / "exercises/chrobotics/p04.ipynb"
    wrong = answered(pristine, tmp_path / "wrong.ipynb", 8)
    assert "Is the arm stretched or folded?" in run("check", wrong, cwd=robotics, code=1)
    assert "the hand comes no nearer" in run("solve", "robotics.4", cwd=robotics)


def test_homework_is_judged_in_the_grading_alone_by_the_courses_file(robotics, tmp_path):
    run("assignment", "new", "hw1", "robotics.4", cwd=robotics)
    handed = robotics / "assignments/hw1" / NOTEBOOK
    text = handed.read_text(encoding="utf-8")
    assert "least_reach" not in text and "kept_for_grading(a_least)" in text
    assert "Only the grading judges `a_least`" in (handed.parent / "README.md").read_text()
    submitted = tmp_path / "submitted"
    answered(handed, submitted / "ann/hw1" / NOTEBOOK, 2)
    sent = answered(handed, submitted / "bob/hw1" / NOTEBOOK, 8)
    # a submission's own course and checks are not read
    (sent.parent / course.FILE).write_text('title = "Bob"\nname = "robotics"\n')
    (sent.parent / "checks.py").write_text(
        "from workbook.checks.authoring import judged\n\n\n@judged\n"
        "def least_reach(claim, lengths):\n    return 'it is'\n"
    )
    output = run(
        "grade", submitted, "--out", tmp_path / "graded", "--processes", 1, "--trust-students",
        cwd=robotics,
    )  # fmt: skip
    assert f"course: robotics ({robotics})" in output
    feedback = tmp_path / "graded/hw1/feedback"
    assert "the hand comes no nearer to the base" in (feedback / "ann.html").read_text()
    assert "Is the arm stretched or folded?" in (feedback / "bob.html").read_text()


def test_a_changed_file_makes_grades_stale_only_where_it_judges(robotics):
    numbers = ("robotics.1", "robotics.4", "1.15")
    before = [fingerprint(exercises.find(number)) for number in numbers]
    with (robotics / "checks.py").open("a", encoding="utf-8") as file:
        file.write("# changed\n")
    after = [fingerprint(exercises.find(number)) for number in numbers]
    assert [old != new for old, new in zip(before, after)] == [False, True, False]


def test_gradescope_gets_the_file(robotics, tmp_path):
    handing_out.make(robotics / "assignments", "hw2", ["robotics.4", "1.15"])
    bundle.make(robotics / "assignments", "hw2", tmp_path / "hw2.zip")
    with zipfile.ZipFile(tmp_path / "hw2.zip") as archive:
        assert archive.read("course/checks.py") == (robotics / "checks.py").read_bytes()


def test_it_is_read_anew_after_a_change_and_belongs_to_the_course_entered(
    robotics, tmp_path, monkeypatch
):
    assert checks.least_reach(2, [5, 3]).status == "right"
    assert checks.least_reach(..., [5, 3]).status == "missing"
    text = (robotics / "checks.py").read_text(encoding="utf-8")
    (robotics / "checks.py").write_text(text.replace("comes no", "does not come"))
    os.utime(robotics / "checks.py", ns=(1, 1))  # clocks of file systems are coarse
    assert "does not come" in checks.least_reach(2, [5, 3]).message
    monkeypatch.delenv(course.VARIABLE)
    monkeypatch.chdir(robotics / "exercises/chrobotics")  # as a kernel there
    assert checks.least_reach(2, [5, 3]).status == "right"
    monkeypatch.chdir(tmp_path)
    with pytest.raises(AttributeError, match="there is no check least_reach here"):
        checks.least_reach


def test_a_page_says_where_it_is_judged(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv(course.VARIABLE, raising=False)
    data = "from workbook import checks\nlengths = [5, 3]"
    result = page.run_cell(
        [data, "a_least = 2"], "checks.report(a_least=checks.least_reach(a_least, lengths))"
    )
    [error] = result["errors"]
    assert result["verdicts"] == {} and "when the homework is graded" in error["hint"]


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("x = 1\ndef f(:\n", 2, "SyntaxError: invalid syntax"),
        ("\n\nimport nothing_here\n", 3, "ModuleNotFoundError: No module named 'nothing_here'"),
        ("def _f():\n    return 1 / 0\n\n\n_f()\n", 2, "ZeroDivisionError: division by zero"),
        ("\ndef helper(x):\n    return x\n", 2, "helper is no check"),
        (
            "from workbook.checks.authoring import judged\n@judged\ndef steps(c):\n    return ''\n",
            2,
            "the workbook has a check steps",
        ),
    ],
)
def test_what_is_wrong_in_it_is_one_sentence_with_its_line(robotics, text, line, message):
    file = robotics / "checks.py"
    file.write_text(text, encoding="utf-8")
    os.utime(file, ns=(line, len(text)))
    with pytest.raises(course.CourseError) as refused:
        own_checks(course.current())
    assert str(refused.value).startswith(f"{file}:{line}: {message}")
    assert "\n" not in str(refused.value)
    assert checks.authoring.judged is not None  # the workbook's own names do not need it


def test_commands_that_judge_refuse_a_file_that_fails(robotics, tmp_path):
    (robotics / "checks.py").write_text("import nothing_here\n", encoding="utf-8")
    said = f"workbook: {robotics / 'checks.py'}:1: ModuleNotFoundError"
    answers = answered(robotics / "exercises/chrobotics/p04.ipynb", tmp_path / "mine.ipynb", 2)
    for command in (
        ("prove",),
        ("check", answers),
        ("grade", tmp_path, "--out", tmp_path / "graded"),
    ):
        output = run(*command, cwd=robotics, code=2)
        assert said in output and "Traceback" not in output


def test_a_master_names_checks_of_its_course_alone(robotics, tmp_path):
    page = (robotics / "solutions/chrobotics/p04.md").read_text(encoding="utf-8")
    copy = tmp_path / "solutions/chrobotics/p04.md"
    copy.parent.mkdir(parents=True)
    copy.with_name("p04.trials.py").write_text(REACH[1], encoding="utf-8")
    copy.write_text(page.replace("checks.least_reach", "checks.least_reech"), encoding="utf-8")
    with pytest.raises(MasterError, match="no check least_reech; did you mean least_reach"):
        read_master(copy)
