"""A course of one's own: a folder with problems, proved, handed out with 1.15 and graded."""

import json

import pytest
from own_problems import SUBSPACE, fill_in
from workbook_command import run

from workbook import course
from workbook.authoring import MasterError, new_course, new_problem, read_master
from workbook.notebooks import exercises, origin


@pytest.fixture(autouse=True)
def no_course(monkeypatch):
    monkeypatch.delenv(course.VARIABLE, raising=False)
    yield
    course.read.cache_clear()


@pytest.fixture(scope="module")
def robotics(tmp_path_factory):
    """A course of two problems, one of which is the template's."""
    folder = tmp_path_factory.mktemp("lecturer") / "robotics"
    new_course(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(course.VARIABLE, str(folder))
        paths = new_problem(folder / "solutions", "robotics.2")
    fill_in(*paths, *SUBSPACE)
    proved = run("prove", cwd=folder)
    assert proved.count(": proved") == 2, proved
    run("exercises", cwd=folder)
    return folder


def answered(path, target, **answers):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        for name, code in answers.items():
            if "".join(cell["source"]).endswith(" = ...") or f"{name} = ..." in cell["source"]:
                cell["source"] = f"{name} = {code}"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(notebook), encoding="utf-8")


def test_a_homework_of_a_course_and_the_workbook(robotics, tmp_path):
    run("assignment", "new", "hw1", "robotics.1", "robotics.2", "1.15", cwd=robotics)
    handed = robotics / "assignments" / "hw1"
    first, second = handed / "chrobotics-p01.ipynb", handed / "chrobotics-p02.ipynb"
    assert (handed / "ch1-p15.ipynb").is_file()
    submitted = tmp_path / "submitted"
    answered(first, submitted / "ann/hw1" / first.name, a_region="(k_p > 2) & (k_d > 0)")
    answered(second, submitted / "ann/hw1" / second.name, a_basis="[[0, 5]]")
    answered(first, submitted / "bob/hw1" / first.name, a_region="(k_d > 0) & (0 < k_p)")
    answered(second, submitted / "bob/hw1" / second.name, a_basis="[[2, 0]]")
    foreign = submitted / "cid/hw1/ch1-p15.ipynb"
    answered(handed / "ch1-p15.ipynb", foreign)
    notebook = json.loads(foreign.read_text())
    notebook["metadata"]["workbook"]["course"] = "mechanics"
    foreign.write_text(json.dumps(notebook))
    # a course inside a submission is not searched
    (submitted / "bob/hw1/workbook.toml").write_text('title = "Bob"\nname = "robotics"\n')
    output = run(
        "grade", submitted, "--out", tmp_path / "graded", "--processes", 1, "--trust-students",
        cwd=robotics,
    )  # fmt: skip
    assert f"course: robotics ({robotics})" in output
    assert "it is problem 1.15 of the course mechanics, not of workbook" in output
    grades = json.loads((tmp_path / "graded/hw1/grades.json").read_text())
    assert (
        "Did you forget the torque of gravity?"
        in (tmp_path / "graded/hw1/feedback/bob.html").read_text()
    )
    assert (
        "Is this state not the one that is measured?"
        in (tmp_path / "graded/hw1/feedback/bob.html").read_text()
    )
    assert grades


def test_what_is_not_a_course_is_refused(tmp_path, monkeypatch):
    for text, message in (
        ('title = "R"', 'name is missing: write name = "..."'),
        ('title = "R"\nname = "Rob1"', "name is a word of 2 to 20 small letters"),
        ('title = "R"\nname = "rob"\nworkbook = ">=99"', "its problems were proved with"),
        ('title = "R"\nname = "rob"\nwebsite = "x"', "unknown field website"),
        ("title = 3", "title is one line of text in quotes"),
    ):
        (tmp_path / course.FILE).write_text(text)
        with pytest.raises(course.CourseError, match=message.replace("...", r"\.\.\.")):
            course.read(tmp_path)


def test_a_folder_of_another_owner_counts_only_if_it_is_named(tmp_path, monkeypatch):
    (tmp_path / course.FILE).write_text('title = "R"\nname = "rob"\n')
    monkeypatch.chdir(tmp_path)
    assert course.current().name == "rob"
    monkeypatch.setattr(course, "_is_own", lambda path: False)
    with pytest.raises(course.CourseError, match="name it by --course"):
        course.current()
    monkeypatch.setenv(course.VARIABLE, str(tmp_path))
    assert course.current().name == "rob"
    monkeypatch.setenv(course.VARIABLE, "")
    assert course.current() is None


def test_a_number_of_a_course_that_is_not_here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(exercises.UnknownExercise, match="of a course that is not here"):
        exercises.find("rob.1")


def test_a_corrected_statement_is_the_same_problem_and_another_is_not():
    ours, other = exercises.find("1.15"), exercises.find("5.3")
    marks = origin.marks_of(ours.about)
    assert marks[0] == "workbook" and len(marks[1]) > 20
    corrected = (marks[0], marks[1][: 24 * origin.LETTERS])  # a quarter of the words gone
    assert origin.why_foreign(corrected, ours) == ""
    assert origin.why_foreign(("", ""), ours) == ""  # as notebooks were handed out before
    assert "another problem" in origin.why_foreign(("", origin.marks_of(other.about)[1]), ours)


def test_a_check_of_ones_own_in_a_data_cell(robotics, tmp_path, monkeypatch):
    monkeypatch.setenv(course.VARIABLE, str(robotics))
    page = (robotics / "solutions/chrobotics/p01.md").read_text(encoding="utf-8")
    own = "@checks.judged\ndef own(claim):\n    return 'it is'\n```\n\n```{exercise-end}"
    changed = page.replace("```\n\n```{exercise-end}", own, 1)
    changed = changed.replace(
        "checks.report(a_region=checks.stability_region", "checks.report(a_region=own"
    )
    assert changed.count("own(") == 2
    copy = tmp_path / "solutions/chrobotics/p01.md"
    copy.parent.mkdir(parents=True)
    trials = robotics / "solutions/chrobotics/p01.trials.py"
    copy.with_name(trials.name).write_text(trials.read_text(encoding="utf-8"), encoding="utf-8")
    copy.write_text(changed, encoding="utf-8")
    assert "own" in read_master(copy).code("check")[0]
    copy.write_text(changed.replace("def own", "def other"), encoding="utf-8")
    with pytest.raises(MasterError, match="own is neither an answer nor a name of a data cell"):
        read_master(copy)
