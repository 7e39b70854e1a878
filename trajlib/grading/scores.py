"""From verdicts to points: partial credit by answer, which attempt counts, and manual scores that beat automatic ones."""

from dataclasses import dataclass

from trajlib.checks.verdict import MISSING, RIGHT, UNCHECKED, Verdict

NOT_SUBMITTED = Verdict(MISSING, "nothing was submitted for this problem")


@dataclass(frozen=True)
class AnswerScore:
    """Points of one answer, given as `text`; `manual` is the lecturer's comment if the points were given by hand, else None."""

    problem: str
    answer: str
    verdict: Verdict
    points: float
    max_points: float
    text: str = ""
    manual: str | None = None

    @property
    def needs_review(self):
        """True where the checks could not judge and no lecturer has: it counts neither as right nor as wrong."""
        return self.verdict.status == UNCHECKED and self.manual is None


@dataclass(frozen=True)
class StudentScore:
    """A student's homework: a score for every answer asked for, which problems were late, how often each was tried."""

    student: str
    answers: tuple
    late: tuple
    remarks: dict
    tried: dict

    @property
    def points(self):
        return sum(answer.points for answer in self.answers)

    @property
    def max_points(self):
        return sum(answer.max_points for answer in self.answers)

    @property
    def needs_review(self):
        return any(answer.needs_review for answer in self.answers)


def scores(store, assignment, students=()):
    """The scores of everyone who submitted, and of `students` who did not, sorted by name."""
    attempts = {}
    for attempt in store.attempts(assignment.name):
        attempts.setdefault((attempt.student, attempt.problem), []).append(attempt)
    manual = store.manual(assignment.name)
    names = sorted({student for student, _ in attempts} | {student for student, _, _ in manual} | set(students))
    return [_student(name, assignment, attempts, manual) for name in names]


def _student(name, assignment, attempts, manual):
    answers, late, remarks = [], [], {}
    for problem, points in assignment.points.items():
        counted = _counted(attempts.get((name, problem), []), assignment, points)
        if counted is not None:
            remarks[problem] = counted.remarks
            if assignment.due is not None and counted.submitted > assignment.due.timestamp():
                late.append(problem)
        for answer, worth in points.items():
            verdict = counted.verdicts.get(answer, NOT_SUBMITTED) if counted else NOT_SUBMITTED
            given = manual.get((name, problem, answer))
            earned, comment = given if given else (worth if verdict.status == RIGHT else 0.0, None)
            text = counted.answers.get(answer, "") if counted else ""
            answers.append(AnswerScore(problem, answer, verdict, earned, worth, text, comment))
    tried = {problem: len(attempts.get((name, problem), [])) for problem in assignment.points}
    return StudentScore(name, tuple(answers), tuple(late), remarks, tried)


def _counted(tried, assignment, points):
    """The attempt that counts: the last, or the best; between equals the earlier, which cannot be late sooner."""
    graded = [attempt for attempt in tried[:assignment.attempts] if attempt.verdicts]
    if not graded or assignment.attempt == "last":
        return graded[-1] if graded else None
    return max(graded, key=lambda a: (sum(points[n] for n, v in a.verdicts.items() if v.status == RIGHT and n in points), -a.submitted))
