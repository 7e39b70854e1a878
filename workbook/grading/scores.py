"""From verdicts to points: partial credit by answer, which attempt counts, and manual scores that
beat automatic ones.

An answer that no check could judge is worth nothing yet, but it is not wrong: as long as it may
raise the grade, the score needs a lecturer's look, and that stands beside it wherever the score
goes. So does the score of a student of whom something was left aside that may be the work that is
missing.
"""

from dataclasses import dataclass, field

from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, Verdict
from workbook.grading.store import Attempt

NOT_SUBMITTED = Verdict(MISSING, "nothing was submitted for this problem")
NOT_FOUND = Verdict(MISSING, "no notebook for this problem was found, but something was left aside")


@dataclass(frozen=True)
class AnswerScore:
    """Points of one answer, given as `text`, which is short; answers with the same `hash` are the
    same.

    `manual` is the lecturer's comment if the points were given by hand, else None; `by_hand` are
    the points then given, which may be more than the answer is worth now, and count as that.
    """

    problem: str
    answer: str
    verdict: Verdict
    points: float
    max_points: float
    text: str = ""
    manual: str | None = None
    by_hand: float | None = None
    hash: str = ""

    @property
    def is_capped(self):
        return self.by_hand is not None and self.by_hand > self.max_points


@dataclass(frozen=True)
class StudentScore:
    """A student's homework: a score for every answer asked for.

    `counted` maps a problem to the attempt that counts (a problem without one is absent), `tried`
    to the number of attempts. `to_review` are answers that could not be judged and may still raise
    the grade, also those of another attempt than the one that counts so far. `aside` is what was
    left aside of the student's work (`submissions.Aside`), and `spoilt` maps a problem to the
    remarks on the newest attempt if that one could not be read or gave no answer.
    """

    student: str
    answers: tuple
    counted: dict
    late: tuple
    tried: dict
    to_review: tuple
    aside: tuple = ()
    spoilt: dict = field(default_factory=dict)

    @property
    def points(self):
        return sum(answer.points for answer in self.answers)

    @property
    def max_points(self):
        return sum(answer.max_points for answer in self.answers)

    @property
    def needs_review(self):
        return bool(self.to_review or self.waits_aside)

    @property
    def waits_aside(self):
        """Whether something left aside is to be looked at: not if it is for another problem, and
        all that is asked for is here."""
        return any(not one.problem or 0 in self.tried.values() for one in self.aside)

    @property
    def handed_in(self):
        """True if there is something to grade, be it by hand, or something that a lecturer has to
        look at."""
        return bool(self.counted or self.aside) or any(
            answer.manual is not None for answer in self.answers
        )

    def of_problem(self, problem):
        return tuple(answer for answer in self.answers if answer.problem == problem)


def scores(store, assignment, students=(), aside=()):
    """The scores of everyone who submitted, and of `students` who did not, sorted by name; `aside`
    is all that was left aside."""
    attempts = {}
    for attempt in store.attempts(assignment.name):
        attempts.setdefault(attempt.student, []).append(attempt)
    manual = {}
    for (student, problem, answer), given in store.manual(assignment.name).items():
        manual.setdefault(student, {})[problem, answer] = given
    theirs = {}
    for one in aside:
        # What lies in no homework's folder may be for this one if the student has nothing else
        # here.
        if one.student and (
            one.assignment == assignment.name or not (one.assignment or one.student in attempts)
        ):
            theirs.setdefault(one.student, []).append(one)
    return [
        of_student(
            name,
            assignment,
            attempts.get(name, []),
            manual.get(name, {}),
            tuple(theirs.get(name, ())),
        )
        for name in sorted({*attempts, *manual, *students, *theirs})
    ]


def of_student(student, assignment, attempts, manual, aside=()):
    """The score of one student: `attempts` oldest first, `manual` maps (problem, answer) to
    (points, comment)."""
    answers, counted, tried, to_review, spoilt = [], {}, {}, [], {}
    none = NOT_FOUND if aside else NOT_SUBMITTED
    for problem, points in assignment.points.items():
        mine = [attempt for attempt in attempts if attempt.problem == problem]
        tried[problem] = len(mine)
        graded = [
            _answers(attempt, problem, points, manual)
            for attempt in mine[: assignment.attempts]
            if attempt.verdicts
        ]
        chosen = _that_counts(graded, assignment.attempt) or _answers(
            NOTHING, problem, points, manual, none
        )
        answers += chosen.answers
        if chosen.attempt is not NOTHING:
            counted[problem] = chosen.attempt
        if mine and _gave_nothing(mine[-1]):
            spoilt[problem] = mine[-1].remarks
        candidates = (
            [chosen]
            if assignment.attempt == "last"
            else [one for one in graded if one.possible > chosen.sure]
        )
        # Each answer once: a lecturer's points for it count whichever attempt does.
        to_review += {
            answer.answer: answer for one in candidates for answer in one.unjudged
        }.values()
    late = tuple(
        problem
        for problem, attempt in counted.items()
        if assignment.due is not None and attempt.submitted > assignment.due.timestamp()
    )
    return StudentScore(
        student, tuple(answers), counted, late, tried, tuple(to_review), tuple(aside), spoilt
    )


#: Stands for the attempt of a student who handed nothing in.
NOTHING = Attempt(0, "", "", "", "", 0.0, None, {}, {}, ())


@dataclass(frozen=True)
class _Graded:
    """An attempt with its points: those that are `sure`, and those that are `possible` if all that
    was not judged is right."""

    attempt: Attempt
    answers: tuple

    @property
    def unjudged(self):
        return [
            answer
            for answer in self.answers
            if answer.verdict.status == UNCHECKED and answer.manual is None
        ]

    @property
    def sure(self):
        return sum(answer.points for answer in self.answers)

    @property
    def possible(self):
        return self.sure + sum(answer.max_points for answer in self.unjudged)


def _answers(attempt, problem, points, manual, none=NOT_SUBMITTED):
    scored = []
    for answer, worth in points.items():
        verdict = attempt.verdicts.get(answer, none)
        by_hand, comment = manual.get((problem, answer), (None, None))
        automatic = worth if verdict.status == RIGHT else 0.0
        scored.append(
            AnswerScore(
                problem,
                answer,
                verdict,
                automatic if by_hand is None else min(by_hand, worth),
                worth,
                attempt.answers.get(answer, ""),
                comment,
                by_hand,
                attempt.hashes.get(answer, ""),
            )
        )
    return _Graded(attempt, tuple(scored))


def _gave_nothing(attempt):
    """Whether a notebook could not be read, or was run without an answer of any kind, and something
    is said of why."""
    return bool(attempt.verdicts and attempt.remarks) and {
        verdict.status for verdict in attempt.verdicts.values()
    } == {MISSING}


def _that_counts(graded, which):
    """The last, or the best; between equals the one that may still rise, then the earlier, which
    cannot be late sooner."""
    if not graded or which == "last":
        return graded[-1] if graded else None
    return max(graded, key=lambda one: (one.sure, one.possible, -one.attempt.submitted))
