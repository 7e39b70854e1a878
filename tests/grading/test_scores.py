"""From verdicts to points, on attempts recorded by hand."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import an_assignment, graded

from workbook.checks.contract.verdict import INVALID, MISSING, RIGHT, UNCHECKED, WRONG
from workbook.grading.course.store import HandPoints
from workbook.grading.course.submissions import LeftAside
from workbook.grading.pool.judging import Judgement
from workbook.grading.reports.scores import scores

TWO = ["a_region", "b_region"]  # the answers of problem 1.17
HOMEWORK = 'problems = ["1.17"]\ndue = 2026-10-01T12:00:00Z\n[points]\n"1.17.a_region" = 3\n'
DUE = 1790856000.0


def statuses(a, b):
    return {"a_region": a, "b_region": b}


def only(store, homework):
    (score,) = scores(store, homework)
    return score


@pytest.mark.parametrize(
    "a, b, points", [(RIGHT, RIGHT, 4), (RIGHT, WRONG, 3), (MISSING, RIGHT, 1), (INVALID, WRONG, 0)]
)
def test_partial_credit_by_answer(tmp_path, store, a, b, points):
    graded(store, "ann", "1.17", statuses(a, b), texts={"a_region": "k1 > 0"})
    score = only(store, an_assignment(tmp_path, HOMEWORK))
    assert score.points == points and score.max_points == 4 and not score.needs_review
    assert [answer.answer for answer in score.answers] == TWO and [
        answer.verdict.status for answer in score.answers
    ] == [a, b]
    assert score.answers[0].text == "k1 > 0" and score.handed_in


def test_not_submitted(tmp_path, store):
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT))
    homework = an_assignment(tmp_path, 'problems = ["1.17", "1.18"]')
    ann, bob = scores(store, homework, students=["bob"])
    assert (ann.student, ann.points, ann.max_points) == ("ann", 2, 4) and ann.handed_in
    assert {answer.verdict.message for answer in ann.of_problem("1.18")} == {
        "nothing was submitted for this problem"
    }
    assert ann.attempt_counts == {"1.17": 1, "1.18": 0} and list(ann.counted) == ["1.17"]
    assert (
        (bob.student, bob.points, bob.max_points) == ("bob", 0, 4)
        and not bob.handed_in
        and not bob.late
        and not bob.needs_review
    )


@pytest.mark.parametrize("submitted, late", [(DUE - 1, ()), (DUE, ()), (DUE + 1, ("1.17",))])
def test_late(tmp_path, store, submitted, late):
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=submitted)
    score = only(store, an_assignment(tmp_path, HOMEWORK))
    assert score.late == late and score.points == 4, "lateness is said, not punished"


def test_lateness_is_that_of_the_attempt_that_counts(tmp_path, store):
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=DUE - 5)
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=DUE + 5)
    assert only(store, an_assignment(tmp_path, HOMEWORK)).late == (), (
        "of two equal attempts the earlier counts"
    )
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=DUE + 9)
    assert only(store, an_assignment(tmp_path, HOMEWORK)).late == ("1.17",)


@pytest.mark.parametrize(
    "rule, points",
    [
        ('attempt = "best"', 3),
        ('attempt = "last"', 1),
        ('attempt = "best"\nattempts = 1', 0),
        ('attempt = "last"\nattempts = 2', 3),
    ],
)
def test_which_attempt_counts(tmp_path, store, rule, points):
    for k, pair in enumerate([(WRONG, WRONG), (RIGHT, WRONG), (WRONG, RIGHT)]):
        graded(store, "ann", "1.17", statuses(*pair), submitted=float(k))
    score = only(store, an_assignment(tmp_path, f"{rule}\n{HOMEWORK}"))
    assert score.points == points and score.attempt_counts == {"1.17": 3}


def test_best_is_by_points_not_by_number_of_right_answers(tmp_path, store):
    graded(store, "ann", "1.18", statuses(RIGHT, RIGHT), submitted=1.0)
    graded(store, "ann", "1.18", statuses(RIGHT, WRONG), submitted=2.0)
    homework = an_assignment(tmp_path, 'problems = ["1.18"]\n[points]\n"1.18.b_region" = 0')
    assert only(store, homework).counted["1.18"].submitted == 1.0


def test_the_same_notebook_again_is_not_a_new_attempt(tmp_path, store):
    for when in (1.0, 2.0):
        graded(store, "ann", "1.17", statuses(WRONG, RIGHT), submitted=when, content="same")
    assert only(store, an_assignment(tmp_path, HOMEWORK)).attempt_counts == {"1.17": 1}


def test_an_attempt_without_a_result_yet_does_not_count(tmp_path, store):
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=1.0)
    store.note_attempt("ann", "hw1", "1.17", "still to be graded", 2.0)
    score = only(store, an_assignment(tmp_path, 'attempt = "last"\n' + HOMEWORK))
    assert score.points == 3 and score.attempt_counts == {"1.17": 2}


def test_manual_points_replace_automatic_ones_until_removed(tmp_path, store):
    homework = an_assignment(tmp_path, HOMEWORK)
    attempt = graded(store, "ann", "1.17", statuses(WRONG, RIGHT))
    store.set_points({("ann", "hw1", "1.17", "a_region"): HandPoints(1.5, "right idea")})
    score = only(store, homework)
    assert (
        score.points == 2.5
        and score.answers[0].manual == "right idea"
        and score.answers[0].verdict.status == WRONG
    )
    # A regrade by changed checks finds it right; the lecturer's points stay.
    store.record(
        attempt,
        "second",
        Judgement({name: type(score.answers[0].verdict)(RIGHT, "") for name in TWO}, {}, ()),
    )
    assert (
        only(store, homework).points == 2.5
        and only(store, homework).answers[0].verdict.status == RIGHT
    )
    # So they do after a resubmission.
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=9.0)
    assert only(store, homework).points == 2.5
    store.set_points({("ann", "hw1", "1.17", "a_region"): HandPoints(0.0, "")})
    assert only(store, homework).points == 1 and only(store, homework).answers[0].manual == ""
    store.take_back("ann", "hw1", "1.17", "a_region")
    assert only(store, homework).points == 4 and only(store, homework).answers[0].manual is None


def test_manual_points_for_work_that_was_not_submitted(tmp_path, store):
    store.set_points({("zoe", "hw1", "1.17", "a_region"): HandPoints(3.0, "handed in on paper")})
    score = only(store, an_assignment(tmp_path, HOMEWORK))
    assert score.points == 3 and score.handed_in and score.counted == {}


def test_unchecked_needs_review(tmp_path, store):
    homework = an_assignment(tmp_path, HOMEWORK)
    graded(store, "ann", "1.17", statuses(UNCHECKED, RIGHT), texts={"a_region": "odd"})
    score = only(store, homework)
    assert score.needs_review and score.points == 1
    assert [(answer.answer, answer.text) for answer in score.to_review] == [("a_region", "odd")]
    store.set_points({("ann", "hw1", "1.17", "a_region"): HandPoints(3.0, "")})
    assert not only(store, homework).needs_review and only(store, homework).points == 4


def test_a_better_attempt_that_could_not_be_judged_is_not_lost(tmp_path, store):
    homework = an_assignment(tmp_path, HOMEWORK)
    graded(store, "ann", "1.17", statuses(WRONG, RIGHT), submitted=1.0)
    graded(
        store, "ann", "1.17", statuses(UNCHECKED, WRONG), submitted=2.0, texts={"a_region": "odd"}
    )
    score = only(store, homework)
    assert score.points == 1 and score.counted["1.17"].submitted == 1.0, (
        "what is sure counts so far"
    )
    assert [(answer.answer, answer.text) for answer in score.to_review] == [("a_region", "odd")]
    # Of two attempts with equal points the one that may still rise counts, so that the student sees
    # it.
    graded(store, "ann", "1.17", statuses(UNCHECKED, RIGHT), submitted=3.0)
    assert only(store, homework).counted["1.17"].submitted == 3.0


def test_what_cannot_raise_the_grade_needs_no_review(tmp_path, store):
    graded(store, "ann", "1.17", statuses(UNCHECKED, WRONG), submitted=1.0)
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=2.0)
    assert not only(store, an_assignment(tmp_path, HOMEWORK)).needs_review
    assert not only(store, an_assignment(tmp_path, 'attempt = "last"\n' + HOMEWORK)).needs_review


def test_students_are_sorted_and_separate(tmp_path, store):
    for student in ("žofie", "ann", "Ben", "=cmd"):
        graded(store, student, "1.17", statuses(RIGHT, WRONG))
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), assignment="hw2")
    store.set_points({("ann", "hw2", "1.17", "a_region"): HandPoints(0.0, "another homework")})
    class_scores = scores(store, an_assignment(tmp_path, HOMEWORK))
    assert [score.student for score in class_scores] == sorted(
        ["žofie", "ann", "Ben", "=cmd"]
    ) and {score.points for score in class_scores} == {3}


# What the system says, and what was left aside


@pytest.mark.parametrize(
    "timing, submitted, late, untimed",
    [
        ("known", DUE + 1, True, False),
        ("known", DUE - 1, False, False),
        ("late", DUE - 1, True, False),
        ("in time", DUE + 1, False, False),
        ("unknown", DUE + 1, False, True),
    ],
)
def test_late_is_what_the_system_says(tmp_path, store, timing, submitted, late, untimed):
    attempt = graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), content="x")
    assert store.note_attempt("ann", "hw1", "1.17", "x", submitted, timing) == attempt
    score = only(store, an_assignment(tmp_path, HOMEWORK))
    assert (bool(score.late), bool(score.untimed)) == (late, untimed)
    without_due = only(store, an_assignment(tmp_path, 'problems = ["1.17"]'))
    assert (bool(without_due.late), without_due.untimed) == (timing == "late", ())


@pytest.mark.parametrize(
    "options, points_by_hand, waits",
    [
        ({}, False, True),
        ({}, True, True),
        ({"by_hand": True}, False, True),
        ({"by_hand": True}, True, False),
        ({"by_hand": True, "is_extra": True}, False, False),
    ],
)
def test_what_is_no_notebook_waits_for_points_by_hand(
    tmp_path, store, options, points_by_hand, waits
):
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG))
    if points_by_hand:
        store.set_points({("ann", "hw1", "1.17", "b_region"): HandPoints(0.5, "on paper")})
    aside = [LeftAside("notes.pdf", "no notebook", "ann", "hw1", **options)]
    (score,) = scores(store, an_assignment(tmp_path, HOMEWORK), (), aside)
    assert score.needs_review == waits and score.aside == tuple(aside)


# What lateness costs

DAY = 86400
LATE_RULE = "[late]\nper_day = 0.2\nfloor = 0.5\ncutoff_days = 7\n"


@pytest.mark.parametrize(
    "seconds, share",
    [
        (-1, 1),
        (0, 1),
        (1, 0.8),
        (DAY, 0.8),
        (DAY + 1, 0.6),
        (2 * DAY + 1, 0.5),
        (7 * DAY, 0.5),
        (7 * DAY + 1, 0),
    ],
)
def test_each_day_begun_takes_its_share(tmp_path, store, seconds, share):
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=DUE + seconds)
    graded(store, "bob", "1.17", statuses(RIGHT, WRONG), submitted=DUE + seconds + 3 * DAY)
    extension = '[extensions]\n"bob" = 2026-10-04T12:00:00Z\n'
    for score in scores(store, an_assignment(tmp_path, HOMEWORK + LATE_RULE + extension)):
        assert score.points == pytest.approx(3 * share) and score.max_points == 4
        assert [answer.late_penalty for answer in score.answers] == pytest.approx(
            [3 - 3 * share, 0]
        )
        assert bool(score.late) == (seconds > 0)


@pytest.mark.parametrize("floor, share", [("", 0), ("floor = 0.3", 0.3)])
def test_lateness_never_costs_more_than_all(tmp_path, store, floor, share):
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=DUE + 99 * DAY)
    rule = f"[late]\nper_day = 0.2\n{floor}\n"
    assert only(store, an_assignment(tmp_path, HOMEWORK + rule)).points == pytest.approx(4 * share)


@pytest.mark.parametrize("timing", ["late", "unknown", "in time"])
def test_without_a_time_lateness_costs_nothing(tmp_path, store, timing):
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), content="x")
    store.note_attempt("ann", "hw1", "1.17", "x", DUE + 99 * DAY, timing)
    score = only(store, an_assignment(tmp_path, HOMEWORK + LATE_RULE))
    assert score.points == 4 and bool(score.untimed) == (timing != "in time")


def test_the_best_attempt_is_so_after_lateness(tmp_path, store):
    homework = an_assignment(tmp_path, HOMEWORK + LATE_RULE)
    graded(store, "ann", "1.17", statuses(RIGHT, WRONG), submitted=DUE - 1)
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=DUE + 2 * DAY)
    assert only(store, homework).points == 3 and not only(store, homework).late
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=DUE + 1)
    assert only(store, homework).points == pytest.approx(3.2) and only(store, homework).late


def test_what_was_not_judged_may_rise_by_what_lateness_leaves(tmp_path, store):
    homework = an_assignment(tmp_path, HOMEWORK + LATE_RULE)
    graded(store, "ann", "1.17", statuses(WRONG, RIGHT), submitted=DUE - 1)
    graded(store, "ann", "1.17", statuses(UNCHECKED, WRONG), submitted=DUE + 8 * DAY)
    assert not only(store, homework).needs_review
    graded(store, "ann", "1.17", statuses(UNCHECKED, WRONG), submitted=DUE + 3 * DAY)
    assert only(store, homework).needs_review


def test_points_by_hand_are_as_they_were_given(tmp_path, store):
    graded(store, "ann", "1.17", statuses(RIGHT, RIGHT), submitted=DUE + 1)
    store.set_points({("ann", "hw1", "1.17", "a_region"): HandPoints(2.5, "")})
    score = only(store, an_assignment(tmp_path, HOMEWORK + LATE_RULE))
    assert score.points == pytest.approx(2.5 + 0.8) and score.answers[0].late_penalty == 0
