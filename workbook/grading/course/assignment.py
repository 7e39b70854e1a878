"""Assignment: which problems, how many points, until when, which attempt counts.

It is one file, `assignment.toml`:

    title = "Homework 1: stability"
    problems = ["1.4", "1.15"]
    pool = ["3.3", "3.4", "3.10"]       # optional: each student gets one of these, by numbers.csv
    due = 2026-10-01T23:59:00+03:00     # optional; later work is marked late
    zone = "Europe/Moscow"              # optional: of times without a zone, as in Moodle's worksheet;
                                        # by default that of due
    grace_days = 3                      # optional: days of the course that lateness costs nothing
    attempt = "best"                    # or "last": which of several submissions counts
    attempts = 3                        # optional; further ones are kept but do not count
    direction = false                   # or true: whether messages say "greater" or "less" of a number
    kept_for_grading = ["1.15.e_region"]  # optional: answers that the notebook does not judge

    [exam]                              # optional: an exam, of which the notebooks judge no answer
    minutes = 90                        # the time allowed
    aids = "One sheet of notes."        # optional: what may be used

    [points]                            # optional; an answer is worth 1 point unless said otherwise
    "1.15" = 10                         # a problem: shared equally by its answers
    "1.4" = 10                          # with an answer named below: the others share what is left
    "1.4.a_matrix" = 2                  # one answer
    pool = 5                            # each of the pool; by default as much as the first

    [by_hand]                           # optional: what a lecturer grades, free text or on paper
    sketch = {points = 2, text = "the phase portrait of 1.4, on paper"}

    [early]                             # optional: a bonus for work that comes early
    days = 7                            # handed in so long before the due date,
    share = 1.1                         # right answers have this share of their points

    [late]                              # optional; without it lateness is marked and costs nothing
    per_day = 0.1                       # the share of the points that each day begun takes
    floor = 0.5                         # optional: the share that is kept until the cut-off
    cutoff_days = 7                     # optional: later work has no points
    # steps = [[7, 0.8], [14, 0.5]]     # in place of per_day: the share kept until so many days

    [budget]                            # optional: what one student's notebooks may use together
    notebooks = 500
    megabytes = 400
    cpu_minutes = 20

    [labels]                            # optional: groups of students
    "extended time" = ["bob@uni.example", "cid@uni.example"]

    [extensions]                        # optional: due dates of single students or labels
    "ann@uni.example" = 2026-10-08T23:59:00+03:00
    "extended time" = 2026-10-04T23:59:00+03:00

    [exemptions]                        # optional: what is not asked of a student or a label
    "ann@uni.example" = ["1.15.e_region"]
"""

import re
import tomllib
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.grading.course import policy as policies
from workbook.grading.course.policy import Policy
from workbook.grading.sandbox.sanitising import normalise_name, portable_name
from workbook.notebooks import exercises

#: Files in the folder of results, beside a folder for each homework: no homework has such a name.
RESERVED_NAMES = {
    "grades.sqlite",
    "grades.sqlite-wal",
    "grades.sqlite-shm",
    "grades.sqlite-journal",
    "points-by-hand.csv",
    "course.csv",
    "course.html",
}
#: In the place of a problem, for what a lecturer grades by hand.
BY_HAND = "by_hand"
#: What may be used in an exam unless its file says otherwise.
AIDS = "one sheet of notes of your own; neither the pages of the course nor other people"
#: The field of the pool, and in the table of numbers the column that says who has which problem.
POOL = "pool"
FIELDS = {
    "title",
    "problems",
    "attempt",
    "attempts",
    "direction",
    "kept_for_grading",
    "exam",
    "points",
    BY_HAND,
    POOL,
} | policies.FIELDS


#: No due date, and nothing that depends on one.
NO_POLICY = Policy()


class InputError(ValueError):
    """Input that the lecturer can correct; the message is one line."""


class AssignmentError(InputError):
    """The assignment file cannot be used; the message has the file, the field and what it takes."""


@dataclass(frozen=True)
class Exam:
    """What makes a homework an exam: the minutes allowed, and what may be used."""

    minutes: int
    aids: str = AIDS


@dataclass(frozen=True)
class Assignment:
    """A homework, or an exam.

    Parameters
    ----------
    name, title : str
        The name of its folder, and the title for people.
    problems : tuple of str
        The problems' numbers, those of the pool last.
    points : dict
        {answer: points} by problem; all problems of the pool are worth the same.
    policy : Policy
        When it is due, for whom, and what the time does to the points.
    attempt : str
        Which attempt counts: "best" or "last".
    attempts : int or None
        How many attempts at a problem count.
    direction : bool
        Whether verdicts say in which direction a number is wrong.
    kept_for_grading : tuple of str
        Problems, and answers such as "1.15.e_region", that only the grading judges.
    numbers : dict or None
        {student: {problem: row}} where students have numbers of their own (`numbers.csv`); by `POOL`
        it has the student's problem of the pool.
    by_hand : dict
        What a lecturer grades by hand: {name: what it is}; its points are those of `BY_HAND`.
    pool : tuple of str
        Problems of which each student has one.
    exam : Exam or None
        What an exam has beside; only the grading judges its answers.
    """

    name: str
    title: str
    problems: tuple
    points: dict
    policy: Policy = NO_POLICY
    attempt: str = "best"
    attempts: int | None = None
    direction: bool = False
    kept_for_grading: tuple = ()
    numbers: dict | None = None
    by_hand: dict = field(default_factory=dict)
    pool: tuple = ()
    exam: Exam | None = None

    @property
    def due(self):
        """The due date of the class, or None."""
        return self.policy.due

    @property
    def automatic(self):
        """The homework without what a lecturer grades by hand."""
        points = {problem: self.points[problem] for problem in self.problems}
        return replace(self, points=points, by_hand={})

    def points_of(self, student):
        """Return the points of the answers that are asked of a student.

        The other answers share the points of those from which the student is exempt, each as it is
        worth: so the homework is worth the same for all. Points by hand stay as the lecturer gives
        them, unless nothing else is asked.
        """
        exempt = self.exempt_of(student)
        points = {
            problem: {
                answer: worth
                for answer, worth in answers.items()
                if not exempt & {problem, f"{problem}.{answer}"}
            }
            for problem, answers in self.points.items()
        }
        worth = {problem: sum(answers.values()) for problem, answers in points.items()}
        sharing = [p for p in worth if p != BY_HAND and worth[p]] or [p for p in worth if worth[p]]
        shared = sum(worth[problem] for problem in sharing)
        gained = self.max_points - sum(worth.values())
        for problem in sharing:
            for answer in points[problem]:
                points[problem][answer] *= 1 + gained / shared
        return points

    def kept_of(self, problem):
        """Return the names of a problem's answers that only the grading judges."""
        return [
            answer
            for answer in self.points[problem]
            if self.exam or {problem, f"{problem}.{answer}"} & set(self.kept_for_grading)
        ]

    def exempt_of(self, student):
        """Return the problems and answers that are not asked of a student."""
        # a student who was forgotten in the table owes the first problem of the pool
        drawn = self.drawn(student) or next(iter(self.pool), None)
        return self.policy.exempt_of(student) | (set(self.pool) - {drawn})

    def drawn(self, student):
        """Return the problem of the pool that a student has, None if there is none."""
        return (self.numbers or {}).get(student, {}).get(POOL)

    def row(self, problem, student):
        """Return the row of numbers that a student has; 0 is the site's, None that there is none."""
        if problem in self.pool and problem != self.drawn(student):
            return None
        if self.numbers is None or all(problem not in rows for rows in self.numbers.values()):
            return 0
        return self.numbers.get(student, {}).get(problem)

    def variant(self, problem, student):
        """Return the name of what a student has to solve, such as 2.4~17, or 2.4 without a row."""
        row = self.row(problem, student)
        return f"{problem}~{row}" if row else problem

    def other_variants(self, problem, student):
        """Return the names of what the site and classmates have instead, the site's first."""
        own = self.row(problem, student)
        rows = {rows[problem] for rows in (self.numbers or {}).values() if problem in rows}
        return [problem, *(f"{problem}~{row}" for row in sorted(rows - {own}))] if own else []

    def exercise(self, variant):
        """Return the exercise of a problem or variant with the check cells of this homework."""
        notebook = exercises.find(variant)
        return notebook if self.direction else exercises.in_homework(notebook)

    @property
    def max_points(self):
        """The points of all answers; of the pool one problem counts."""
        counted = self.points.keys() - set(self.pool[1:])
        return sum(sum(self.points[problem].values()) for problem in counted)


def read(path):
    """Return the assignment in a file, named after its folder; raises `AssignmentError`."""
    path = Path(path)
    try:
        return from_text(path.read_text(encoding="utf-8"), path)
    except OSError as error:
        raise AssignmentError(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise AssignmentError(f"{path} is not TOML in UTF-8: {error}") from None


def files(folder):
    """Return {homework: its file} of all in a folder, which may be None."""
    paths = sorted(Path(folder).glob("[!.]*/assignment.toml")) if folder is not None else ()
    return {normalise_name(path.parent.name): path for path in paths}


def can_be_name(name):
    """Return whether a homework can have this name, which is that of a folder."""
    return (
        bool(re.fullmatch(r"\w([\w .-]*\w)?", name))
        and len(name.encode()) <= 200
        and name not in RESERVED_NAMES
        and name == portable_name(name)
    )


def from_text(text, path):
    """Return the assignment of the text of a file `path`; raises `AssignmentError`."""
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise AssignmentError(f"{path} is not TOML in UTF-8: {error}") from None
    name = normalise_name(path.resolve().parent.name)
    unknown = set(table) - FIELDS
    _require(
        not unknown,
        path,
        f"unknown field {', '.join(sorted(unknown))}; there are {', '.join(sorted(FIELDS))}",
    )
    title = table.get("title", name)
    _require(
        isinstance(title, str) and len(title.strip().splitlines()) == 1,
        path,
        "title is one line of text in quotes",
    )
    pool = _problems(path, POOL, table.get(POOL, []), at_least=2 if POOL in table else 0)
    problems = _problems(path, "problems", table.get("problems", []), at_least=0 if pool else 1)
    problems += pool
    _require(len(set(problems)) == len(problems), path, "problems names a problem twice")
    attempt = table.get("attempt", "best")
    _require(attempt in ("best", "last"), path, 'attempt is "best" or "last"')
    attempts = table.get("attempts")
    _require(
        attempts is None or (type(attempts) is int and attempts > 0),
        path,
        "attempts is a whole number from 1 up",
    )
    direction = table.get("direction", False)
    _require(type(direction) is bool, path, "direction is true or false, without quotes")
    by_hand, points_by_hand = read_by_hand(path, table.get(BY_HAND, {}))
    points = _points(path, problems, table.get("points", {}), pool)
    kept = table.get("kept_for_grading", [])
    names = {*points, *(f"{p}.{a}" for p, answers in points.items() for a in answers)}
    _require(
        isinstance(kept, list) and all(name in names for name in kept),
        path,
        'kept_for_grading is a list of problems or answers of the assignment: ["1.17", "1.15.e_region"]',
    )
    exam = read_exam(path, table["exam"]) if "exam" in table else None
    _require(
        not (exam and (direction or kept)),
        path,
        "an exam judges no answer before the grading: leave direction and kept_for_grading out",
    )
    points |= points_by_hand
    try:
        policy = policies.read(table, points)
    except policies.PolicyError as error:
        raise AssignmentError(f"{path}: {error}") from None
    return Assignment(
        name,
        title.strip(),
        tuple(problems),
        points,
        policy,
        attempt,
        attempts,
        direction,
        tuple(kept),
        by_hand=by_hand,
        pool=tuple(pool),
        exam=exam,
    )


def of_problems(name, problems):
    """Return an assignment without a file: one point an answer, no due date, the best attempt."""
    return Assignment(name, name, tuple(problems), _points(Path(name), problems, {}))


def answers_of(problem):
    """Return the names of a problem's answers in order; raises `exercises.UnknownExercise`."""
    exercise = exercises.find(problem)
    if exercise.number != problem:
        raise exercises.UnknownExercise(
            f"there is no problem {problem}; it is written {exercise.number}"
        )
    return list(exercise.about["answers"])


def _problems(path, name, numbers, at_least):
    """Return a copy of a list of problems, which has `at_least` so many."""
    _require(
        isinstance(numbers, list)
        and len(numbers) >= at_least
        and all(isinstance(number, str) for number in numbers),
        path,
        f'{name} is a list of numbers in quotes, ["1.4", "1.15"]',
    )
    return list(numbers)


def _points(path, problems, table, pool=()):
    """Return the points of every answer of every problem, from the table `points`."""
    _require(isinstance(table, dict), path, 'points is a table: [points], and below it "1.15" = 10')
    if pool and POOL in table:  # each of its problems is worth so much
        table = dict.fromkeys(pool, table[POOL]) | {k: v for k, v in table.items() if k != POOL}
    points = {}
    for problem in problems:
        try:
            points[problem] = dict.fromkeys(answers_of(problem), 1.0)
        except exercises.UnknownExercise as error:
            raise AssignmentError(f"{path}: {error}") from None
    by_answer = {}
    for key, value in table.items():
        # TOML takes an unquoted 1.15 = 10 for a table "1" with a key "15".
        _require(
            not isinstance(value, dict),
            path,
            'in points a problem stands in quotes: "1.15" = 10, not 1.15 = 10',
        )
        _require(
            type(value) in (int, float) and 0 <= value < 1e6,
            path,
            f'points."{key}" is a number from 0 up',
        )
        problem, _, answer = key.rpartition(".")
        if key not in points:
            _require(
                answer in points.get(problem, ()),
                path,
                f'points."{key}" names neither a problem of the assignment nor one of its answers',
            )
            by_answer.setdefault(problem, {})[answer] = float(value)
    for problem, answers in points.items():
        named = by_answer.get(problem, {})
        if problem in table:
            remaining_points, unnamed_count = (
                table[problem] - sum(named.values()),
                len(answers) - len(named),
            )
            _require(
                remaining_points >= -1e-9 and (unnamed_count or remaining_points <= 1e-9),
                path,
                f'points."{problem}" is {table[problem]:g}, but its answers named below have '
                f"{sum(named.values()):g}",
            )
            answers.update(
                dict.fromkeys(answers, max(remaining_points, 0.0) / max(unnamed_count, 1))
            )
        answers.update(named)
    worths = {problem: sum(points[problem].values()) for problem in pool}
    for problem in pool:  # by default all of a pool are worth as much as the first
        if problem not in table and worths[problem]:
            factor = worths[pool[0]] / worths[problem]
            points[problem] = {name: worth * factor for name, worth in points[problem].items()}
    _require(
        len({round(sum(points[problem].values()), 6) for problem in pool}) < 2,
        path,
        "the problems of the pool are worth the same: [points], and below it pool = 5",
    )
    return points


def read_by_hand(path, table):
    """Return ({name: what it is}, its points by `BY_HAND`) of what a lecturer grades."""
    _require(
        isinstance(table, dict)
        and all(
            isinstance(item, dict)
            and item.keys() == {"points", "text"}
            and type(item["points"]) in (int, float)
            and 0 <= item["points"] < 1e6
            and isinstance(item["text"], str)
            for item in table.values()
        ),
        path,
        'by_hand is a table: [by_hand], and below it essay = {points = 2, text = "what it is"}',
    )
    points = {name: float(item["points"]) for name, item in table.items()}
    return {name: item["text"] for name, item in table.items()}, {BY_HAND: points} if points else {}


def read_exam(path, table):
    """Return the `Exam` of a table; raises `AssignmentError`."""
    _require(
        isinstance(table, dict)
        and {"minutes"} <= table.keys() <= {"minutes", "aids"}
        and type(table["minutes"]) is int
        and table["minutes"] > 0
        and isinstance(table.get("aids", AIDS), str),
        path,
        'exam is a table: [exam], and below it minutes = 90 and perhaps aids = "what may be used"',
    )
    return Exam(**table)


def _require(condition, path, message):
    if not condition:
        raise AssignmentError(f"{path}: {message}")
