"""A run over a course: which notebooks are graded, and graded again."""

import os
import sqlite3
import sys
from contextlib import closing
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, hand_in, write_assignment

from workbook.checks.contract.verdict import Verdict
from workbook.course import WORKBOOK
from workbook.grading import commands
from workbook.grading.course import course, ledger
from workbook.grading.course.assignment import InputError
from workbook.grading.course.options import GradingOptions
from workbook.grading.course.store import HandPoints, Store
from workbook.grading.pool import fingerprint, grader, worker_pool
from workbook.grading.pool.judging import Judgement, grader_failure
from workbook.grading.reports.scores import scores
from workbook.grading.sandbox import forkserver, preloading
from workbook.grading.sandbox.limits import Limits
from workbook.notebooks import exercises


def points(out, known):
    with Store(out / "grades.sqlite") as store:
        return {score.student: score.points for score in scores(store, known["hw1"])}


@pytest.fixture
def failing_workers(monkeypatch):
    """Worker processes that die on every notebook with one of these words."""
    words = set()

    def grade_all(tasks, count, settings, forkserver=None):
        for task in tasks:
            broken = any(name in "".join(task.sources) for name in words)
            judgement = (
                grader_failure(task.names, "it died")
                if broken
                else Judgement({name: Verdict("right", "yes") for name in task.names}, {}, ())
            )
            yield task.key, grader.to_plain(judgement)

    monkeypatch.setattr(worker_pool, "grade_all", grade_all)
    return words


def test_notebooks_that_the_grader_failed_on_are_graded_again(tmp_path, failing_workers):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15 | {"a_region": "'ADA'"})
    hand_in(tmp_path, "bela", "1.15", RIGHT_1_15)
    failing_workers.add("ADA")
    known, plan, count = course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    assert (len(plan.pending), count) == (2, 1) and points(tmp_path, known) == {
        "ada": 0.0,
        "bela": 5.0,
    }
    with Store(tmp_path / "grades.sqlite") as store:
        (ada, _) = store.attempts("hw1")
        assert {verdict.status for verdict in ada.verdicts.values()} == {
            "unchecked"
        } and ada.remarks == ("grader: it failed on this notebook (it died)",)
    failing_workers.clear()
    known, plan, count = course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    assert (len(plan.pending), plan.graded_before, count) == (1, 1, 0) and points(
        tmp_path, known
    ) == {
        "ada": 5.0,
        "bela": 5.0,
    }
    assert course.grade(GradingOptions(tmp_path / "submitted", tmp_path))[1].pending == ()


def test_only_a_first_run_imports_while_it_reads(tmp_path, failing_workers, monkeypatch):
    started = []

    class Stub:
        load = close = lambda *_: None

    monkeypatch.setattr(
        forkserver.Forkserver, "start", lambda modules: started.append(modules) or Stub()
    )
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    assert started == [preloading.ALWAYS], "the second run has nothing to grade"


def test_a_worker_process_that_dies_is_replaced(tmp_path, monkeypatch):
    """With real processes: each exits at the first notebook that contains DIE."""
    monkeypatch.setattr(
        forkserver,
        "START",
        "import os\nfrom workbook.grading.pool import grader\nreal = grader.Grader.grade\n"
        "grader.Grader.grade = lambda self, task: os._exit(1) if 'DIE' in ''.join(task.sources) "
        "else real(self, task)\n" + forkserver.START,
    )
    for student, answers in (
        ("ada", RIGHT_1_15),
        ("bela", {"a_region": "'DIE'"}),
        ("cyd", RIGHT_1_15),
    ):
        hand_in(tmp_path, student, "1.15", answers)
    known, _plan, count = course.grade(
        GradingOptions(tmp_path / "submitted", tmp_path, processes=1)
    )
    assert count == 1 and points(tmp_path, known) == {"ada": 5.0, "bela": 0.0, "cyd": 5.0}


@pytest.mark.slow
def test_other_limits_regrade_what_exceeded_the_former_ones(tmp_path):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    hand_in(
        tmp_path,
        "bela",
        "1.15",
        RIGHT_1_15
        | {
            "a_region": "[1 for _ in iter(lambda: __import__('time').process_time() < 2, False)]",
            "b_region": f"{RIGHT_1_15['b_region']}",
        },
    )
    known, plan, _ = course.grade(
        GradingOptions(
            tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=2, wall_seconds=60)
        )
    )
    assert len(plan.pending) == 2 and points(tmp_path, known) == {"ada": 5.0, "bela": 4.0}
    with Store(tmp_path / "grades.sqlite") as store:
        assert store.attempts("hw1")[1].remarks == (
            "limits: code cell 3 was stopped: it took half of the time that was left",
        )
    assert (
        course.grade(
            GradingOptions(
                tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=2, wall_seconds=60)
            )
        )[1].pending
        == ()
    )
    again = course.grade(
        GradingOptions(
            tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=30, wall_seconds=90)
        )
    )[1]
    assert (len(again.pending), again.graded_before) == (1, 1)
    with Store(tmp_path / "grades.sqlite") as store:
        assert store.attempts("hw1")[1].remarks == ()


def test_the_same_notebook_twice_is_one_attempt(tmp_path, failing_workers):
    path = hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    (path.parent / "ch1-p15 (copy).ipynb").write_bytes(path.read_bytes())
    known, plan, _ = course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    assert len(plan.pending) == 1 and points(tmp_path, known) == {"ada": 5.0}


LAST = 'problems = ["1.15"]\ndue = 2020-01-02T00:00:00Z\nattempt = "last"\n'
DUE = 1577923200.0


@pytest.fixture
def by_content(monkeypatch):
    """Worker processes that judge right what contains GOOD."""

    def grade_all(tasks, count, settings, forkserver=None):
        for task in tasks:
            status = "right" if "GOOD" in "".join(task.sources) else "wrong"
            yield (
                task.key,
                grader.to_plain(
                    Judgement({name: Verdict(status, "") for name in task.names}, {}, ())
                ),
            )

    monkeypatch.setattr(worker_pool, "grade_all", grade_all)


def late(out, known):
    with Store(out / "grades.sqlite") as store:
        return {score.student: bool(score.late) for score in scores(store, known["hw1"])}


def run(folder):
    known, plan, _ = course.grade(
        GradingOptions(folder / "submitted", folder, folder / "assignments")
    )
    return len(plan.pending), points(folder, known), late(folder, known)


def test_an_earlier_version_handed_in_again_is_the_last_attempt(tmp_path, by_content):
    write_assignment(tmp_path, LAST)
    for k, answers, expected in ((0, "GOOD", (1, 5)), (1, "BAD", (1, 0)), (2, "GOOD", (0, 5))):
        hand_in(tmp_path, "ann", "1.15", {"a_region": f"'{answers}'"}, at=DUE - 9 + k)
        graded, late_by_student, _ = run(tmp_path)
        assert (graded, late_by_student["ann"]) == expected


@pytest.mark.parametrize("rule, points_, is_late", [("last", 5, True), ("best", 5, False)])
def test_copies_side_by_side(tmp_path, by_content, rule, points_, is_late):
    write_assignment(tmp_path, LAST.replace("last", rule))
    for name, answers, at in (
        ("ch1-p15.ipynb", "GOOD", DUE - 9),
        ("ch1-p15 (1).ipynb", "BAD", DUE - 5),
        ("ch1-p15 (2).ipynb", "GOOD", DUE + 5),
    ):
        hand_in(tmp_path, "ann", "1.15", {"a_region": f"'{answers}'"}, at=at, name=name)
    assert run(tmp_path) == (2, {"ann": points_}, {"ann": is_late})
    assert run(tmp_path) == (0, {"ann": points_}, {"ann": is_late})


@pytest.mark.parametrize(
    "first, second, expected",
    [
        ((-60, None), (-30, None), (5, False)),
        ((-30, None), (-60, None), (0, False)),
        ((-60, None), (30, None), (5, True)),
        ((None, False), (None, True), (5, True)),
        ((None, None), (None, None), (5, False)),
    ],
)
def test_the_last_attempt_is_so_by_the_ledger(tmp_path, by_content, first, second, expected):
    """Not by the times of the files, which are those of copying."""
    write_assignment(tmp_path, LAST)
    noted = ledger.Ledger(tmp_path / "submitted")
    for k, (answer, (submitted, late)) in enumerate((("BAD", first), ("GOOD", second))):
        name = f"ch1-p15 ({k}).ipynb"
        hand_in(tmp_path, "ann", "1.15", {"a_region": f"'{answer}'"}, at=DUE + 90 - k, name=name)
        when = None if submitted is None else DUE + submitted
        noted.add(
            ledger.Entry(
                "hw1", "ann", file=name, submitted=when, late=late, source=name, collected=DUE + k
            )
        )
    (tmp_path / "submitted" / ledger.NAME).write_text(noted.text(), encoding="utf-8")
    assert run(tmp_path)[1:] == ({"ann": expected[0]}, {"ann": expected[1]})
    # A time that is put right counts by the next run, and nothing is graded again.
    path = tmp_path / "submitted" / ledger.NAME
    path.unlink()
    assert run(tmp_path) == (0, {"ann": 0}, {"ann": True})


def test_a_corrected_time_of_a_file(tmp_path, by_content):
    write_assignment(tmp_path, LAST)
    path = hand_in(tmp_path, "ann", "1.15", {"a_region": "'GOOD'"}, at=DUE + 5)
    assert run(tmp_path) == (1, {"ann": 5}, {"ann": True})
    os.utime(path, (DUE - 5, DUE - 5))
    assert run(tmp_path) == (0, {"ann": 5}, {"ann": False})
    path.unlink()
    hand_in(tmp_path, "bob", "1.15", {}, at=DUE - 5)
    assert run(tmp_path)[1:] == ({"ann": 5, "bob": 0}, {"ann": False, "bob": False}), (
        "a result stays when its notebook is gone"
    )


@pytest.mark.parametrize(
    "name", [b"grades.sqlite", b"grades.sqlite-wal", b".grading", b"\x01" * 250]
)
def test_a_homework_folder_of_an_invalid_name_stops_nothing(tmp_path, by_content, name):
    write_assignment(tmp_path, LAST)
    normal = hand_in(tmp_path, "ann", "1.15", {"a_region": "'GOOD'"}, at=DUE - 9)
    folder = os.fsencode(tmp_path / "submitted") + b"/eve/" + name
    os.makedirs(folder)
    Path(os.fsdecode(folder + b"/x.ipynb")).write_bytes(normal.read_bytes())
    done = commands.grade_course(
        GradingOptions(
            tmp_path / "submitted",
            tmp_path / "graded",
            tmp_path / "assignments",
            1,
            limits=Limits.of_time(60),
            trusting=True,
            quiet=True,
        )
    )
    assert done["assignments"]["hw1"] == {"ann": 5, "eve": 0}
    assert len(done["left aside"]) == (name != b".grading")


def test_a_problem_of_one_student_takes_no_points_away(tmp_path, by_content):
    write_assignment(tmp_path, LAST)
    hand_in(tmp_path, "ann", "1.15", {"a_region": "'GOOD'"}, at=DUE - 9)
    hand_in(tmp_path, "ann", "1.17", {}, at=DUE - 5)
    assert run(tmp_path) == (1, {"ann": 5}, {"ann": False})


def test_a_store_that_is_full_or_no_database_is_an_error(tmp_path, by_content):
    hand_in(tmp_path, "ann", "1.15", {"a_region": "'GOOD'"})
    run(tmp_path)
    full = "grades.sqlite: database or disk is full; what is stored in it is kept"
    with pytest.raises(InputError, match=full), Store(tmp_path / "grades.sqlite") as store:
        store._database.execute("PRAGMA max_page_count = 1")
        for k in range(1000):
            store.set_points({("ann", "hw1", "1.15", f"a{k}"): HandPoints(1.0, "x" * 1000)})
    assert run(tmp_path)[:2] == (0, {"ann": 5})
    (tmp_path / "graded").mkdir()
    (tmp_path / "graded" / "grades.sqlite").write_text("this is something else " * 100)
    with pytest.raises(InputError, match="grades.sqlite: file is not a database"):
        course.grade(GradingOptions(tmp_path / "submitted", tmp_path / "graded"))


def test_a_store_of_an_older_version_is_read(tmp_path, by_content):
    hand_in(tmp_path, "ann", "1.15", {"a_region": "'GOOD'"})
    run(tmp_path)
    with closing(sqlite3.connect(tmp_path / "grades.sqlite")) as database:
        database.execute("ALTER TABLE result DROP COLUMN hashes")
        database.execute("ALTER TABLE attempt DROP COLUMN timing")
    assert run(tmp_path)[:2] == (0, {"ann": 5})


def test_a_notebook_for_no_problem_is_reported(tmp_path, failing_workers):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    hand_in(tmp_path, "ada", "1.4", {})
    odd = hand_in(tmp_path, "bela", "1.15", RIGHT_1_15, name="essay\x1b.ipynb")
    odd.write_text(odd.read_text().replace('"number": "1.15"', '"number": "99.99"'))
    _, plan, _ = course.grade(GradingOptions(tmp_path / "submitted", tmp_path))
    (aside,) = plan.aside
    assert aside.path.endswith("essay\\x1b.ipynb") and "does not say which problem" in aside.reason


@pytest.mark.parametrize("out", ["submitted", "submitted/graded"])
def test_results_among_the_submissions_are_refused(tmp_path, failing_workers, out):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    with pytest.raises(course.CourseError, match="every folder is a student's: put it beside"):
        course.grade(GradingOptions(tmp_path / "submitted", tmp_path / out))
    assert [path.name for path in (tmp_path / "submitted").iterdir()] == ["ada"]


def test_a_changed_judge_grades_again(tmp_path, failing_workers, monkeypatch):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    course.grade(GradingOptions(tmp_path / "submitted", tmp_path / "graded"))
    assert (
        course.grade(GradingOptions(tmp_path / "submitted", tmp_path / "graded"))[1].pending == ()
    )
    closure = fingerprint.module_closure
    monkeypatch.setattr(
        fingerprint,
        "module_closure",
        lambda source: (
            closure(source) | {"workbook.checks.contract.encoding": "mended"}
            if "workbook.checks.contract.encoding" in closure(source)
            else closure(source)
        ),
    )
    assert (
        len(course.grade(GradingOptions(tmp_path / "submitted", tmp_path / "graded"))[1].pending)
        == 1
    )


def test_an_exercise_is_read_again_when_its_file_has_changed(tmp_path, monkeypatch):
    """While it has not changed, it is not read again for each notebook."""
    notebook_path = tmp_path / "ch1" / "p15.ipynb"
    notebook_path.parent.mkdir()
    text = exercises.find("1.15").path.read_text(encoding="utf-8")
    monkeypatch.setattr(type(WORKBOOK), "exercises", tmp_path)
    notebook_path.write_text(text, encoding="utf-8")
    first = exercises.find("1.15")
    assert exercises.find("1.15") is first
    notebook_path.write_text(text.replace("a_region", "a_place"), encoding="utf-8")
    os.utime(notebook_path, ns=(0, notebook_path.stat().st_mtime_ns + 1))
    assert (
        "a_place" in exercises.find("1.15").about["answers"]
        and "a_region" in first.about["answers"]
    )
