"""Policies in `assignment.toml`: due dates, bonus, late credit, extensions, exemptions."""

import io
import sys
from datetime import datetime
from pathlib import Path

import pytest
from rich.console import Console

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, graded

from workbook.checks.contract.verdict import RIGHT, WRONG, Verdict
from workbook.grading.course import record
from workbook.grading.course.assignment import InputError
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports import exporting
from workbook.grading.reports.console_summary import print_summary
from workbook.grading.reports.feedback import feedback
from workbook.grading.reports.scores import scores

#: The scenarios on dates and credit in PrairieLearn's documentation of its access control (June
#: 2026): file, and the share of the points by student and time. Passwords, time limits within an
#: exam and what is shown when are affairs of the system that hands out and takes in the work.
HOMEWORK = 'problems = ["1.17"]\n'
DUE = f"{HOMEWORK}due = 2025-02-15T23:59:59Z\n"
SCENARIOS = {
    "homework with a due date": (
        DUE + "[late]\ncutoff_days = 0\n",
        [("ann", "2025-02-15T23:59:59", 1), ("ann", "2025-02-16T00:00:00", 0)],
    ),
    "always open practice": (HOMEWORK, [("ann", "2025-01-15", 1), ("ann", "2031-01-15", 1)]),
    "early bonus and late credit in steps": (
        DUE + "[early]\ndays = 14\nshare = 1.1\n[late]\nsteps = [[7, 0.8], [14, 0.5]]\n",
        [
            ("ann", "2025-02-01T23:59:59", 1.1),
            ("ann", "2025-02-02T00:00:00", 1),
            ("ann", "2025-02-15T23:59:59", 1),
            ("ann", "2025-02-16T00:00:00", 0.8),
            ("ann", "2025-02-22T23:59:59", 0.8),
            ("ann", "2025-02-23T00:00:00", 0.5),
            ("ann", "2025-03-01T23:59:59", 0.5),
            ("ann", "2025-03-02T00:00:00", 0),
        ],
    ),
    "extended due date for a label": (
        DUE
        + '[late]\ncutoff_days = 0\n[labels]\n"Extended time" = ["bob"]\n'
        + '[extensions]\n"Extended time" = 2025-02-22T23:59:59Z\n',
        [("ann", "2025-02-20", 0), ("bob", "2025-02-20", 1), ("bob", "2025-02-23", 0)],
    ),
    "extended due date for a student, which goes before that of a label": (
        DUE
        + '[late]\ncutoff_days = 0\n[labels]\nA = ["ann", "bob"]\nB = ["ann", "cid", "bob"]\n'
        + "[extensions]\nbob = 2025-02-18T00:00:00Z\n"
        + "A = 2025-03-01T00:00:00Z\nB = 2025-02-22T00:00:00Z\n",
        [
            ("bob", "2025-02-17", 1),
            ("bob", "2025-02-20", 0),
            ("ann", "2025-02-21", 1),
            ("ann", "2025-02-23", 0),  # of two labels the lower in the file
            ("cid", "2025-02-21", 1),
            ("dan", "2025-02-17", 0),
        ],
    ),
}


def seconds(text):
    return datetime.fromisoformat(
        f"{text}+00:00" if "T" in text else f"{text}T00:00:00+00:00"
    ).timestamp()


@pytest.mark.parametrize("name", SCENARIOS)
def test_points_tables_and_pages_follow_the_policy(tmp_path, store, name):
    text, rows = SCENARIOS[name]
    homework = an_assignment(tmp_path, text)
    for student, submitted, share in rows:
        row = f"{student} {submitted}"
        attempt = graded(
            store, student, "1.17", {"a_region": RIGHT, "b_region": WRONG}, seconds(submitted)
        )
        (score,) = [s for s in scores(store, homework) if s.student == student]
        assert score.points == pytest.approx(share), row
        (line,) = [r for r in exporting.grades_csv(homework, [score]).split("\r\n") if student in r]
        before = max(share, 1)
        assert f'"{share:.2f}","{share:.2f}","{before:.2f}","2.00"' in line, row
        assert (f"{share:.0%} of the points" in exporting.moodle_csv(homework, [score])) == (
            share != 1
        )
        page = feedback(homework, score)
        assert (" after the due date" in page or " before the due date" in page) == (share != 1), (
            row
        )
        store._database.execute("DELETE FROM result WHERE attempt = ?", (attempt,))
        store._database.execute("DELETE FROM attempt WHERE id = ?", (attempt,))


def test_the_page_explains_what_the_time_did(tmp_path, store):
    homework = an_assignment(tmp_path, SCENARIOS["early bonus and late credit in steps"][0])
    for student, submitted in [("ann", "2025-01-31"), ("bob", "2025-02-18"), ("cid", "2025-04-01")]:
        graded(store, student, "1.17", {"a_region": RIGHT, "b_region": RIGHT}, seconds(submitted))
    ann, bob, cid = (feedback(homework, score) for score in scores(store, homework))
    assert "at least 14 days before the due date: right answers have 1.1 times their points" in ann
    assert "3 days after the due date (a day begun counts): right answers have 80% of their" in bob
    assert "right answers have 0% of their points" in cid


def test_an_extension_moves_the_bonus_and_is_on_the_page(tmp_path, store):
    text = SCENARIOS["early bonus and late credit in steps"][0]
    homework = an_assignment(tmp_path, text + "[extensions]\nbob = 2025-02-20T23:59:59Z\n")
    assert homework.policy.share("bob", seconds("2025-02-06")) == 1.1
    assert homework.policy.share("bob", seconds("2025-02-25")) == 0.8
    graded(store, "bob", "1.17", {"a_region": RIGHT, "b_region": RIGHT}, seconds("2025-02-25"))
    (score,) = scores(store, homework)
    assert "by an extension from 2025-02-15 23:59" in feedback(homework, score)


def test_dates_in_the_zone_of_the_homework(tmp_path):
    """Summer time ends between the two dates."""
    text = (
        f'{HOMEWORK}zone = "Europe/Berlin"\ndue = 2026-10-01T23:59:00\n'
        '[extensions]\n"ann" = 2026-11-01T23:59:00\n"bob" = 2026-11-01T23:59:00+00:00\n'
    )
    policy = an_assignment(tmp_path, text).policy
    dates = [policy.due_of(student).timestamp() for student in ("cid", "ann", "bob")]
    assert dates == [
        seconds(text)
        for text in ("2026-10-01T21:59:00", "2026-11-01T22:59:00", "2026-11-01T23:59:00")
    ]


@pytest.mark.parametrize("timing, untimed", [("in time", True), ("known", False)])
def test_a_bonus_needs_a_time(tmp_path, store, timing, untimed):
    homework = an_assignment(tmp_path, DUE + "[early]\ndays = 1\nshare = 1.5\n")
    graded(store, "ann", "1.17", {"a_region": RIGHT, "b_region": RIGHT}, content="x")
    store.note_attempt("ann", "hw1", "1.17", "x", 0.0, timing)
    (score,) = scores(store, homework)
    assert (score.points, bool(score.untimed)) == (2 if untimed else 3, untimed)
    assert ("has no bonus" in feedback(homework, score)) == untimed


# Grace days

GRACE = (
    'problems = ["1.17"]\ndue = {due}\ngrace_days = 3\n[late]\nper_day = 0.25\ncutoff_days = 7\n'
)


def test_grace_days_of_the_course_are_used_up_by_the_earlier_homework(tmp_path, store):
    first, second = (
        an_assignment(tmp_path, GRACE.format(due=due), name)
        for name, due in (("hw1", "2025-02-15T23:59:59Z"), ("hw2", "2025-03-15T23:59:59Z"))
    )
    right = {"a_region": RIGHT, "b_region": RIGHT}
    for name, submitted in [("hw1", "2025-02-17"), ("hw2", "2025-03-19")]:
        graded(store, "ann", "1.17", right, seconds(submitted), name)
    graded(store, "bob", "1.17", right, seconds("2025-03-19"), "hw2")
    (ann,) = scores(store, first)
    # 2 days late: 2 of 3 grace days, and no points.
    assert (ann.points, ann.grace_days_used, ann.late) == (2, 2, ("1.17",))
    assert "uses 2 days of your grace and costs no points" in feedback(first, ann)
    ann, bob = scores(store, second, grace_days_used={"ann": 2})
    # 4 days late: ann has one day of grace left and 3 days to pay, bob 3 and 1.
    assert (ann.points, ann.grace_days_used) == (0.5, 1)
    assert (bob.points, bob.grace_days_used) == (1.5, 3)
    assert "4 days after the due date (a day begun counts); 1 day of your grace" in feedback(
        second, ann
    )
    row = exporting.grades_csv(second, [ann]).split("\r\n")[1]
    assert row == '"ann","0.50","0.50","2.00","2.00","yes","1.17","1","","no"'


def test_grace_days_move_the_cut_off(tmp_path, store):
    homework = an_assignment(tmp_path, GRACE.format(due="2025-02-15T23:59:59Z"))
    for student, submitted in [("ann", "2025-02-25"), ("bob", "2025-02-27")]:
        graded(store, student, "1.17", {"a_region": RIGHT, "b_region": RIGHT}, seconds(submitted))
    ann, bob = scores(store, homework)
    assert (ann.points, bob.points) == (0, 0), "0.25 a day leaves nothing after four days"
    assert "have 0% of their points" in feedback(homework, ann)
    assert "more than 7 days after the due date; 3 days of your grace" in feedback(homework, bob)


@pytest.mark.parametrize(
    "text, message",
    [
        (DUE + "grace_days = 1", "grace_days needs a table"),
        (DUE + "grace_days = 1.5\n[late]\nper_day = 0.1", "grace_days is a whole number of days"),
        (DUE + "grace_days = true\n[late]\nper_day = 0.1", "grace_days is a whole number of days"),
        (DUE + "grace_days = -1\n[late]\nper_day = 0.1", "grace_days is a whole number of days"),
    ],
)
def test_errors_in_grace_days(tmp_path, text, message):
    with pytest.raises(InputError, match=message):
        an_assignment(tmp_path, text)


# Exemptions

EXEMPT = (
    'problems = ["1.17", "1.18"]\n[points]\n"1.17.a_region" = 3\n[labels]\nill = ["cid"]\n'
    '[exemptions]\nbob = ["1.18"]\nill = ["1.17.a_region", "1.18"]\n"dan" = ["1.17", "1.18"]\n'
)


@pytest.mark.parametrize(
    "timing, advice",
    [("unknown", "workbook collect --worksheet"), ("late", "the column submitted of ledger.csv")],
)
def test_the_advice_where_lateness_costs_something_and_the_time_is_unknown(
    tmp_path, store, timing, advice
):
    """Canvas has no worksheet."""
    homework = an_assignment(tmp_path, DUE + "[late]\nper_day = 0.1\n")
    attempt = store.note_attempt("ann", "hw1", "1.17", "x", 5.0, timing)
    store.record(attempt, "first", Judgement({"a_region": Verdict(RIGHT, "it holds")}, {}, ()))
    console = Console(file=io.StringIO(), width=1000)
    print_summary(console, tmp_path, homework, scores(store, homework), [], None)
    said = console.file.getvalue()
    assert advice in said and said.count("of 1 student ") == 1


def test_other_answers_share_the_points_of_what_is_not_asked(tmp_path, store):
    homework = an_assignment(tmp_path, EXEMPT)
    for student in ("ann", "bob", "cid"):
        graded(store, student, "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    ann, bob, cid, dan = scores(store, homework, students=["dan"])
    assert [score.max_points for score in (ann, bob, cid, dan)] == [6, 6, 6, 0]
    assert [score.points for score in (ann, bob, cid, dan)] == [4, 6, 6, 0]
    assert [answer.points for answer in bob.answers] == [4.5, 1.5]
    assert (ann.is_absent, dan.is_absent) == (False, False) and not dan.handed_in
    assert "You are exempt from 1.18." in feedback(homework, bob)
    assert "exempt" not in feedback(homework, ann)
    lines = exporting.grades_csv(homework, [ann, bob, cid, dan]).split("\r\n")
    assert lines[2].startswith('"bob","6.00","exempt","6.00","6.00"')
    assert "dan" not in exporting.moodle_csv(homework, [ann, bob, cid, dan])


def test_points_by_hand_do_not_grow_with_an_exemption(tmp_path):
    by_hand = '[by_hand]\nsketch = {points = 3, text = "a sketch"}\n'
    homework = an_assignment(tmp_path, EXEMPT.replace("[labels]", by_hand + "[labels]"))
    assert homework.points_of("bob") == {
        "1.17": {"a_region": 4.5, "b_region": 1.5},
        "1.18": {},
        "by_hand": {"sketch": 3},
    }
    assert homework.points_of("dan")["by_hand"] == {"sketch": 9}, "nothing else is asked of dan"


def test_an_exemption_is_the_reason_of_a_change(tmp_path, store):
    graded(store, "bob", "1.17", {"a_region": RIGHT, "b_region": RIGHT})
    graded(store, "bob", "1.18", {"a_region": RIGHT, "b_region": RIGHT})
    path = tmp_path / "grades.json"
    before = an_assignment(tmp_path, EXEMPT.split("[labels]")[0])
    path.write_text(record.compared(path, before, scores(store, before), "1")[2])
    after = an_assignment(tmp_path, EXEMPT)
    changes, _, _ = record.compared(path, after, scores(store, after), "2")
    assert {(change.problem, change.reason) for change in changes} == {
        ("1.18", "the student is exempt from it"),
        ("1.17", "the assignment's points changed"),
    }


def test_names_of_nobody_are_known(tmp_path):
    homework = an_assignment(tmp_path, EXEMPT)
    assert homework.policy.students == {"bob", "cid", "dan"}


def test_the_policy_of_the_guide_is_one(tmp_path):
    guide = Path(__file__).resolve().parents[2] / "book" / "guides" / "lecturer.md"
    blocks = [block.split("```")[0] for block in guide.read_text().split("```toml\n")[1:]]
    text = 'problems = ["1.15", "1.17"]\ndue = 2026-10-01T23:59:00+03:00\n'
    homework = an_assignment(tmp_path, text + "\n".join(blocks))
    assert homework.policy.early and homework.policy.late.steps and homework.by_hand
    assert homework.policy.due_of("cid").day == 4 and homework.policy.due_of("ann").day == 8
