"""An assignment: which problems, how many points, until when, which attempt counts. One file, `assignment.toml`.

    title = "Homework 1: stability"
    problems = ["1.4", "1.15"]
    due = 2026-10-01T23:59:00+03:00     # optional; later work is marked late
    attempt = "best"                    # or "last": which of several submissions counts
    attempts = 3                        # optional; further ones are kept but do not count

    [points]                            # optional; an answer is worth 1 point unless said otherwise
    "1.15" = 10                         # a problem: shared equally by its answers
    "1.4.a_matrix" = 2                  # one answer
"""

import datetime
import tomllib
from dataclasses import dataclass
from pathlib import Path

from trajlib import exercises

FIELDS = {"title", "problems", "due", "attempt", "attempts", "points"}


class AssignmentError(ValueError):
    """The assignment file cannot be used; the message names the file, the field and what was expected."""


@dataclass(frozen=True)
class Assignment:
    """`points` maps a problem to {answer: points}; `due` is an aware datetime or None."""

    name: str
    title: str
    problems: tuple
    points: dict
    due: datetime.datetime | None = None
    attempt: str = "best"
    attempts: int | None = None

    @property
    def max_points(self):
        return sum(sum(answers.values()) for answers in self.points.values())


def read(path):
    """The assignment in the file `path`; its name is that of the folder. Raises `AssignmentError`."""
    path = Path(path)
    try:
        given = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise AssignmentError(f"{path}: {error}") from None
    unknown = set(given) - FIELDS
    if unknown:
        raise AssignmentError(f"{path}: unknown field {', '.join(sorted(unknown))}; there are {', '.join(sorted(FIELDS))}")
    problems = given.get("problems")
    if not (isinstance(problems, list) and problems and all(isinstance(p, str) for p in problems)):
        raise AssignmentError(f'{path}: problems is a list of numbers in quotes, ["1.4", "1.15"]')
    if len(set(problems)) != len(problems):
        raise AssignmentError(f"{path}: problems names a problem twice")
    due = given.get("due")
    if due is not None and not (isinstance(due, datetime.datetime) and due.tzinfo is not None):
        raise AssignmentError(f"{path}: due is a date with time and zone, 2026-10-01T23:59:00+03:00")
    if given.get("attempt", "best") not in ("best", "last"):
        raise AssignmentError(f'{path}: attempt is "best" or "last"')
    attempts = given.get("attempts")
    if attempts is not None and not (type(attempts) is int and attempts > 0):
        raise AssignmentError(f"{path}: attempts is a whole number from 1 up")
    return Assignment(path.parent.name, str(given.get("title", path.parent.name)), tuple(problems),
                      _points(path, problems, given.get("points", {})), due, given.get("attempt", "best"), attempts)


def of_problems(name, problems):
    """The assignment that needs no file: one point an answer, no due date, the best attempt."""
    return Assignment(name, name, tuple(problems), _points(Path(name), problems, {}))


def _points(path, problems, given):
    """Points of every answer of every problem, from the table `points`."""
    points = {}
    for problem in problems:
        try:
            answers = exercises.find(problem).about["answers"]
        except exercises.UnknownExercise as error:
            raise AssignmentError(f"{path}: {error}") from None
        whole = _number(path, problem, given.get(problem, len(answers)))
        points[problem] = dict.fromkeys(answers, whole / len(answers))
    for key, value in given.items():
        problem, _, answer = key.rpartition(".")
        if key in points:
            continue
        if problem not in points or answer not in points[problem]:
            raise AssignmentError(f'{path}: points."{key}" names neither a problem of the assignment nor one of its answers')
        points[problem][answer] = _number(path, key, value)
    return points


def _number(path, key, value):
    if type(value) not in (int, float) or not 0 <= value < 1e6:
        raise AssignmentError(f'{path}: points."{key}" is a number from 0 up')
    return float(value)
