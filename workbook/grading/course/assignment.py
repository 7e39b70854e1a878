"""Assignment: which problems, how many points, until when, which attempt counts.

It is one file, `assignment.toml`:

    title = "Homework 1: stability"
    problems = ["1.4", "1.15"]
    due = 2026-10-01T23:59:00+03:00     # optional; later work is marked late
    attempt = "best"                    # or "last": which of several submissions counts
    attempts = 3                        # optional; further ones are kept but do not count
    direction = false                   # or true: whether messages say "greater" or "less" of a number

    [points]                            # optional; an answer is worth 1 point unless said otherwise
    "1.15" = 10                         # a problem: shared equally by its answers
    "1.4" = 10                          # with an answer named below: the others share what is left
    "1.4.a_matrix" = 2                  # one answer

    [late]                              # optional; without it lateness is marked and costs nothing
    per_day = 0.1                       # the share of the points that each day begun takes
    floor = 0.5                         # optional: the share that is kept until the cut-off
    cutoff_days = 7                     # optional: later work has no points

    [extensions]                        # optional: due dates of single students
    "ann@uni.example" = 2026-10-08T23:59:00+03:00
"""

import datetime
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from workbook.grading.course.lateness import LateRule
from workbook.grading.sandbox.sanitising import normalise_name
from workbook.notebooks import exercises

#: Files in the folder of results, beside a folder for each homework: no homework has such a name.
RESERVED_NAMES = {
    "grades.sqlite",
    "grades.sqlite-wal",
    "grades.sqlite-shm",
    "grades.sqlite-journal",
}
FIELDS = {
    "title",
    "problems",
    "due",
    "attempt",
    "attempts",
    "direction",
    "points",
    "late",
    "extensions",
}


class InputError(ValueError):
    """Input that the lecturer can correct; the message is one line."""


class AssignmentError(InputError):
    """The assignment file cannot be used; the message has the file, the field and what it takes."""


@dataclass(frozen=True)
class Assignment:
    """A homework.

    Parameters
    ----------
    name, title : str
        The name of its folder, and the title for people.
    problems : tuple of str
        The problems' numbers.
    points : dict
        {answer: points} by problem.
    due : datetime.datetime or None
        With a time zone.
    attempt : str
        Which attempt counts: "best" or "last".
    attempts : int or None
        How many attempts at a problem count.
    late_rule : LateRule or None
        What lateness costs; None is nothing.
    extensions : dict
        The due dates of students who have their own.
    direction : bool
        Whether verdicts say in which direction a number is wrong.
    numbers : dict or None
        {student: {problem: row}} where students have numbers of their own (`numbers.csv`).
    """

    name: str
    title: str
    problems: tuple
    points: dict
    due: datetime.datetime | None = None
    attempt: str = "best"
    attempts: int | None = None
    late_rule: LateRule | None = None
    extensions: dict = field(default_factory=dict)
    direction: bool = False
    numbers: dict | None = None

    def due_of(self, student):
        """Return the due date of a student, or None."""
        return self.extensions.get(student, self.due)

    def row(self, problem, student):
        """Return the row of numbers that a student has; 0 is the site's, None that there is none."""
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
        """The points of all answers."""
        return sum(sum(answers.values()) for answers in self.points.values())


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
    paths = sorted(Path(folder).glob("*/assignment.toml")) if folder is not None else ()
    return {normalise_name(path.parent.name): path for path in paths}


def can_be_name(name):
    """Return whether a homework can have this name, which is that of a folder."""
    return (
        bool(re.fullmatch(r"\w([\w .-]*\w)?", name))
        and len(name.encode()) <= 200
        and name not in RESERVED_NAMES
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
    problems = table.get("problems")
    _require(
        isinstance(problems, list) and problems and all(isinstance(p, str) for p in problems),
        path,
        'problems is a list of numbers in quotes, ["1.4", "1.15"]',
    )
    _require(len(set(problems)) == len(problems), path, "problems names a problem twice")
    due = table.get("due")
    if due is not None:
        _require_date(due, path, "due")
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
    return Assignment(
        name,
        title.strip(),
        tuple(problems),
        _points(path, problems, table.get("points", {})),
        due,
        attempt,
        attempts,
        _late_rule(path, due, table.get("late")),
        _extensions(path, due, table.get("extensions", {})),
        direction,
    )


def of_problems(name, problems):
    """Return an assignment without a file: one point an answer, no due date, the best attempt."""
    return Assignment(name, name, tuple(problems), _points(Path(name), problems, {}))


def can_be_due(date):
    """Return whether the date can be shown in every time zone."""
    return 1970 < date.year < 9999


def answers_of(problem):
    """Return the names of a problem's answers in order; raises `exercises.UnknownExercise`."""
    exercise = exercises.find(problem)
    if exercise.number != problem:
        raise exercises.UnknownExercise(
            f"there is no problem {problem}; it is written {exercise.number}"
        )
    return list(exercise.about["answers"])


def _points(path, problems, table):
    """Return the points of every answer of every problem, from the table `points`."""
    _require(isinstance(table, dict), path, 'points is a table: [points], and below it "1.15" = 10')
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
    return points


def _late_rule(path, due, table):
    if table is None:
        return None
    _require(
        isinstance(table, dict)
        and "per_day" in table
        and table.keys() <= {"per_day", "floor", "cutoff_days"},
        path,
        "late is a table: [late], and below it per_day = 0.1, and perhaps floor and cutoff_days",
    )
    for key, value in table.items():
        greatest = 10_000 if key == "cutoff_days" else 1
        _require(
            type(value) in (int, float) and 0 <= value <= greatest,
            path,
            f"late.{key} is a number from 0 to {greatest}",
        )
    _require(due is not None, path, "late needs a due date")
    return LateRule(**table)


def _extensions(path, due, table):
    _require(
        isinstance(table, dict),
        path,
        'extensions is a table: [extensions], and below it "ann" = 2026-10-08T23:59:00+03:00',
    )
    for student, date in table.items():
        _require_date(date, path, f'extensions."{student}"')
        _require(
            due is not None and date >= due,
            path,
            f'extensions."{student}" is before the due date, or there is none',
        )
    return {normalise_name(student): date for student, date in table.items()}


def _require_date(date, path, name):
    _require(
        isinstance(date, datetime.datetime) and date.tzinfo is not None,
        path,
        f"{name} is a date with time and zone, without quotes: 2026-10-01T23:59:00+03:00",
    )
    _require(can_be_due(date), path, f"{name} is a date of our time, from 1971 to 9998")


def _require(condition, path, message):
    if not condition:
        raise AssignmentError(f"{path}: {message}")
