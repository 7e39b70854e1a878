"""Scores: partial credit by answer, the attempt that counts, and points given by hand.

An answer that no check could judge has no points yet, but is not wrong: while it may still raise
the grade, the score needs a lecturer's look (`StudentScore.needs_review`), which all tables and
pages say. So does the score of a student if something that was left aside may be the missing work.
"""

from dataclasses import dataclass, field

from workbook.checks.contract.verdict import MISSING, RIGHT, UNCHECKED, Verdict
from workbook.grading.course.assignment import BY_HAND
from workbook.grading.course.ledger import IN_TIME, KNOWN, LATE, UNKNOWN
from workbook.grading.course.store import Attempt, HandPoints

NOT_SUBMITTED = Verdict(MISSING, "nothing was submitted for this problem")
FOR_LECTURER = Verdict(UNCHECKED, "your lecturer grades this by hand")
NOT_FOUND = Verdict(MISSING, "no notebook for this problem was found, but something was left aside")


@dataclass(frozen=True)
class AnswerScore:
    """The points of one answer.

    Parameters
    ----------
    problem, answer : str
        Number of the problem, name of the answer.
    verdict : Verdict
        The check's.
    points, max_points : float
        What it has, and what it is worth.
    text : str
        The answer, shortened.
    manual : str or None
        The lecturer's comment, if the points were given by hand.
    by_hand : float or None
        The points then given, which count up to `max_points`, should that be less by now.
    given_by : str
        Who gave them, if that was said.
    hash : str
        Of the whole answer: the same for equal answers.
    share : float
        The share of its automatic points that its time leaves, above 1 with an early bonus.
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
    share: float = 1.0
    given_by: str = ""

    @property
    def late_penalty(self):
        """The points that lateness takes."""
        is_right = self.verdict.status == RIGHT and self.by_hand is None
        return self.max_points * max(1 - self.share, 0.0) if is_right else 0.0

    @property
    def is_capped(self):
        """Whether more points were given by hand than the answer is worth now."""
        return self.by_hand is not None and self.by_hand > self.max_points


@dataclass(frozen=True)
class StudentScore:
    """A student's homework.

    Parameters
    ----------
    student : str
        The name.
    answers : tuple of AnswerScore
        Every answer asked for.
    counted : dict
        The attempt that counts by problem; a problem without one is absent.
    late : tuple of str
        Problems whose counted attempt is late.
    attempt_counts : dict
        The number of attempts by problem.
    to_review : tuple of AnswerScore
        Answers that could not be judged and may still raise the grade, also of an attempt that does
        not count so far.
    aside : tuple of LeftAside
        What was left aside of the student's work.
    unusable : dict
        By problem, the remarks on the newest attempt if it could not be read or gave no answer.
    exempt : tuple of str
        Problems and answers that are not asked of the student.
    grace_days : int
        The grace days that the student had left for this homework.
    grace_days_used : int
        How many of them its late attempts use up.
    untimed : tuple of str
        Problems with a due date of whose counted attempt nobody knows when it was handed in, or by
        how much it is late where that matters.
    """

    student: str
    answers: tuple
    counted: dict
    late: tuple
    attempt_counts: dict
    to_review: tuple
    aside: tuple = ()
    unusable: dict = field(default_factory=dict)
    untimed: tuple = ()
    exempt: tuple = ()
    grace_days: int = 0
    grace_days_used: int = 0

    @property
    def points(self):
        """The points of all answers."""
        return sum(answer.points for answer in self.answers)

    @property
    def points_before_lateness(self):
        """The points of all answers, with those that lateness takes."""
        return self.points + sum(answer.late_penalty for answer in self.answers)

    @property
    def max_points(self):
        """What all answers are worth."""
        return sum(answer.max_points for answer in self.answers)

    @property
    def needs_review(self):
        """Whether a lecturer has to look at something."""
        return bool(self.to_review or self.aside_needs_review)

    @property
    def aside_needs_review(self):
        """Whether something left aside may be missing work.

        It is not, if it is for another problem and all problems asked for have an attempt, or lies
        beside a notebook. What only a lecturer can grade waits until there are points by hand.
        """
        has_points_by_hand = any(answer.manual is not None for answer in self.answers)
        return any(
            not (entry.is_extra or (entry.by_hand and has_points_by_hand))
            and (not entry.problem or 0 in self.attempt_counts.values())
            for entry in self.aside
        )

    @property
    def handed_in(self):
        """Whether there is something to grade, also by hand, or to look at."""
        return bool(self.counted or self.aside) or any(
            answer.manual is not None for answer in self.answers
        )

    @property
    def is_absent(self):
        """Whether something was asked of the student, who handed in nothing."""
        return bool(self.answers) and not self.handed_in

    def of_problem(self, problem):
        """Return the `AnswerScore` of each answer of a problem."""
        return tuple(answer for answer in self.answers if answer.problem == problem)


def scores(store, assignment, students=(), aside=(), grace_days_used=None):
    """Return the scores of a class for an assignment, sorted by name.

    Parameters
    ----------
    store : Store
        With the results.
    assignment : Assignment
        What is asked for.
    students : iterable of str
        Students to list even if they submitted nothing.
    aside : iterable of LeftAside
        All that was left aside.
    grace_days_used : dict, optional
        The grace days by student that homeworks with an earlier due date have used up.

    Returns
    -------
    list of StudentScore
        One for each student.
    """
    attempts, used = {}, grace_days_used or {}
    for attempt in store.attempts(assignment.name):
        attempts.setdefault(attempt.student, []).append(attempt)
    manual = {}
    for (student, problem, answer), entry in store.manual(assignment.name).items():
        manual.setdefault(student, {})[problem, answer] = entry
    aside_of = {}
    for entry in aside:
        # What lies in no homework's folder may be for this one if the student has nothing else
        # here.
        if entry.student and (
            entry.assignment == assignment.name
            or not (entry.assignment or entry.student in attempts)
        ):
            aside_of.setdefault(entry.student, []).append(entry)
    return [
        of_student(
            name,
            assignment,
            attempts.get(name, []),
            manual.get(name, {}),
            tuple(aside_of.get(name, ())),
            max(assignment.policy.grace_days - used.get(name, 0), 0),
        )
        for name in sorted({*attempts, *manual, *students, *aside_of})
    ]


def of_student(student, assignment, attempts, manual, aside=(), grace_days=0):
    """Return the score of one student.

    Parameters
    ----------
    student : str
        The name.
    assignment : Assignment
        What is asked for.
    attempts : list of Attempt
        The student's, oldest first.
    manual : dict
        `HandPoints` by (problem, answer).
    aside : tuple of LeftAside
        What was left aside of the student's work.
    grace_days : int
        The grace days that the student has left.

    Returns
    -------
    StudentScore
        The score.
    """
    answers, counted, attempt_counts, to_review, unusable = [], {}, {}, [], {}
    no_verdict = NOT_FOUND if aside else NOT_SUBMITTED
    policy = assignment.policy
    due = policy.due_of(student)
    for problem, points in assignment.points_of(student).items():
        if not points:
            continue
        of_problem = [attempt for attempt in attempts if attempt.problem == problem]
        if problem != BY_HAND:
            attempt_counts[problem] = len(of_problem)
        graded = [
            _graded(attempt, problem, points, manual, share=_share(attempt, policy, grace_days))
            for attempt in of_problem[: assignment.attempts]
            if attempt.verdicts
        ]
        waits = problem == BY_HAND and (attempts or aside or manual)
        chosen = _counting(graded, assignment.attempt) or _graded(
            NO_ATTEMPT, problem, points, manual, FOR_LECTURER if waits else no_verdict
        )
        answers += chosen.answers
        if chosen.attempt is not NO_ATTEMPT:
            counted[problem] = chosen.attempt
        if of_problem and _is_unusable(of_problem[-1]):
            unusable[problem] = of_problem[-1].remarks
        candidates = (
            [chosen]
            if assignment.attempt == "last" or not graded
            else [attempt for attempt in graded if attempt.possible > chosen.sure]
        )
        # Each answer once: a lecturer's points for it count whichever attempt does.
        to_review += {
            answer.answer: answer for candidate in candidates for answer in candidate.unjudged
        }.values()
    undecided = {UNKNOWN, *([LATE] if policy.late else []), *([IN_TIME] if policy.early else [])}
    return StudentScore(
        student,
        tuple(answers),
        counted,
        tuple(p for p, attempt in counted.items() if _is_late(attempt, due)),
        attempt_counts,
        tuple(to_review),
        tuple(aside),
        unusable,
        tuple(p for p, attempt in counted.items() if due and attempt.timing in undecided),
        tuple(sorted(policy.exempt_of(student))),
        grace_days,
        max(
            (
                policy.grace_days_used(student, attempt.submitted, grace_days)
                for attempt in counted.values()
                if attempt.timing == KNOWN and policy.late
            ),
            default=0,
        ),
    )


def _is_late(attempt, due):
    """Return whether an attempt is late: by its time, or because the system said so."""
    if attempt.timing == KNOWN:
        return due is not None and attempt.submitted > due.timestamp()
    return attempt.timing == LATE


def _share(attempt, policy, grace_days):
    """Return the share of its points that an attempt has; all, where no time is known."""
    if attempt.timing != KNOWN:
        return 1.0
    return policy.share(attempt.student, attempt.submitted, grace_days)


#: In place of points by hand where there are none.
NOT_GIVEN = HandPoints(None, None)
#: In place of the attempt of a student who handed nothing in.
NO_ATTEMPT = Attempt(0, "", "", "", "", 0.0, None, {}, {}, ())


@dataclass(frozen=True)
class _GradedAttempt:
    """An attempt with its points."""

    attempt: Attempt
    answers: tuple
    share: float

    @property
    def unjudged(self):
        """The answers that no check could judge, and no lecturer has."""
        return [
            answer
            for answer in self.answers
            if answer.verdict.status == UNCHECKED and answer.manual is None
        ]

    @property
    def sure(self):
        """The points that it has."""
        return sum(answer.points for answer in self.answers)

    @property
    def possible(self):
        """The points if all that was not judged is right."""
        return self.sure + sum(self.share * answer.max_points for answer in self.unjudged)


def _graded(attempt, problem, points, manual, no_verdict=NOT_SUBMITTED, share=1.0):
    scored = []
    for answer, worth in points.items():
        verdict = attempt.verdicts.get(answer, no_verdict)
        given = manual.get((problem, answer), NOT_GIVEN)
        automatic = worth * share if verdict.status == RIGHT else 0.0
        scored.append(
            AnswerScore(
                problem,
                answer,
                verdict,
                automatic if given.points is None else min(given.points, worth),
                worth,
                attempt.answers.get(answer, ""),
                given.comment,
                given.points,
                attempt.hashes.get(answer, ""),
                share,
                given.by,
            )
        )
    return _GradedAttempt(attempt, tuple(scored), share)


def _is_unusable(attempt):
    """Return whether a notebook gave no answer of any kind, with remarks that say why."""
    return bool(attempt.verdicts and attempt.remarks) and {
        verdict.status for verdict in attempt.verdicts.values()
    } == {MISSING}


def _counting(graded, rule):
    """Return the last attempt, or the best.

    Of equally good ones, the one that may still rise; then the earlier, which is late only if the
    others are.
    """
    if not graded or rule == "last":
        return graded[-1] if graded else None
    return max(
        graded,
        key=lambda attempt: (attempt.sure, attempt.possible, -attempt.attempt.submitted),
    )
