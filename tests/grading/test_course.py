"""A run over a course: what is graded, what is graded again, and what is not."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, hand_in  # noqa: E402

from trajlib.grading import course, lanes, units  # noqa: E402
from trajlib.grading.judging import Judgement, failed  # noqa: E402
from trajlib.grading.sandbox import Limits  # noqa: E402
from trajlib.grading.scores import scores  # noqa: E402
from trajlib.grading.store import Store  # noqa: E402


def points(out, known):
    with Store(out / "grades.sqlite") as store:
        return {score.student: score.points for score in scores(store, known["hw1"])}


@pytest.fixture
def broken_lanes(monkeypatch):
    """Lanes that die on every unit of the students named."""
    unlucky = set()

    def grade_all(given, count, settings):
        for unit in given:
            broken = any(name in "".join(unit["sources"]) for name in unlucky)
            judgement = failed(unit["names"], "it died") if broken else Judgement(
                {name: course.units.Verdict("right", "yes") for name in unit["names"]}, {}, ())
            yield unit["key"], units.as_plain(judgement)

    monkeypatch.setattr(lanes, "grade_all", grade_all)
    return unlucky


def test_what_the_grader_failed_on_is_graded_again(tmp_path, broken_lanes):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15 | {"a_region": "'ADA'"})
    hand_in(tmp_path, "bela", "1.15", RIGHT_1_15)
    broken_lanes.add("ADA")
    known, plan, count = course.grade(tmp_path / "submitted", tmp_path)
    assert (len(plan.pending), count) == (2, 1) and points(tmp_path, known) == {"ada": 0.0, "bela": 5.0}
    with Store(tmp_path / "grades.sqlite") as store:
        (ada, _) = store.attempts("hw1")
        assert {verdict.status for verdict in ada.verdicts.values()} == {"unchecked"} and ada.remarks == ("grader: it failed on this notebook (it died)",)
    broken_lanes.clear()
    known, plan, count = course.grade(tmp_path / "submitted", tmp_path)
    assert (len(plan.pending), plan.known, count) == (1, 1, 0) and points(tmp_path, known) == {"ada": 5.0, "bela": 5.0}
    assert course.grade(tmp_path / "submitted", tmp_path)[1].pending == ()


def test_a_lane_that_dies_is_replaced(tmp_path, monkeypatch):
    """For real: every lane ends itself at the first notebook of its life that says so."""
    monkeypatch.setattr(lanes, "START", "import os\nfrom trajlib.grading import units\nreal = units.Bench.grade\n"
                        "units.Bench.grade = lambda bench, unit: os._exit(1) if 'DIE' in ''.join(unit['sources']) else real(bench, unit)\n" + lanes.START)
    for student, answers in (("ada", RIGHT_1_15), ("bela", {"a_region": "'DIE'"}), ("cyd", RIGHT_1_15)):
        hand_in(tmp_path, student, "1.15", answers)
    known, plan, count = course.grade(tmp_path / "submitted", tmp_path, count=1)
    assert count == 1 and points(tmp_path, known) == {"ada": 5.0, "bela": 0.0, "cyd": 5.0}


def test_other_limits_grade_again_what_met_the_former_ones(tmp_path):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    hand_in(tmp_path, "bela", "1.15", RIGHT_1_15 | {"a_region": "[1 for _ in iter(lambda: __import__('time').process_time() < 2, False)]",
                                                    "b_region": f"{RIGHT_1_15['b_region']}"})
    known, plan, _ = course.grade(tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=2, wall_seconds=60))
    assert len(plan.pending) == 2 and points(tmp_path, known) == {"ada": 5.0, "bela": 4.0}
    with Store(tmp_path / "grades.sqlite") as store:
        assert store.attempts("hw1")[1].remarks == ("limits: code cell 2 was stopped: it took half of the time that was left",)
    assert course.grade(tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=2, wall_seconds=60))[1].pending == ()
    again = course.grade(tmp_path / "submitted", tmp_path, limits=Limits(cpu_seconds=30, wall_seconds=90))[1]
    assert (len(again.pending), again.known) == (1, 1)
    with Store(tmp_path / "grades.sqlite") as store:
        assert store.attempts("hw1")[1].remarks == ()


def test_the_same_notebook_twice_is_one_attempt(tmp_path, broken_lanes):
    path = hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    (path.parent / "ch1-p15 (copy).ipynb").write_bytes(path.read_bytes())
    known, plan, _ = course.grade(tmp_path / "submitted", tmp_path)
    assert len(plan.pending) == 1 and points(tmp_path, known) == {"ada": 5.0}


def test_what_is_for_no_problem_is_named(tmp_path, broken_lanes):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    hand_in(tmp_path, "ada", "1.4", {})
    odd = hand_in(tmp_path, "bela", "1.15", RIGHT_1_15, name="essay\x1b.ipynb")
    odd.write_text(odd.read_text().replace('"number": "1.15"', '"number": "99.99"'))
    _, plan, _ = course.grade(tmp_path / "submitted", tmp_path)
    ((path, why),) = plan.aside
    assert path.endswith("essay\\x1b.ipynb") and "does not say which problem" in why


@pytest.mark.parametrize("out", ["submitted", "submitted/graded"])
def test_results_do_not_lie_among_the_students(tmp_path, broken_lanes, out):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    with pytest.raises(course.CourseError, match="every folder is a student's: put it beside"):
        course.grade(tmp_path / "submitted", tmp_path / out)
    assert [path.name for path in (tmp_path / "submitted").iterdir()] == ["ada"]


def test_a_mended_judge_grades_again(tmp_path, broken_lanes, monkeypatch):
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    course.grade(tmp_path / "submitted", tmp_path / "graded")
    assert course.grade(tmp_path / "submitted", tmp_path / "graded")[1].pending == ()
    closure = units.module_closure
    monkeypatch.setattr(units, "module_closure", lambda source: closure(source) | {"trajlib.checks.encoding": "mended"}
                        if "trajlib.checks.encoding" in closure(source) else closure(source))
    assert len(course.grade(tmp_path / "submitted", tmp_path / "graded")[1].pending) == 1
