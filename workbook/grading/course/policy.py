"""Policy of a homework: due dates, the share of its points that an attempt has by its time, exemptions.

All days count from the student's own due date, so an extension moves the whole timeline:

    early bonus | all points | late credit, by days or in steps | nothing

A student has the due date given by name; else that of the last label in the file that has one; else
that of the class. So every grade follows from `assignment.toml` and the times of submission.
"""

import datetime
import math
from dataclasses import dataclass, field, fields
from itertools import pairwise
from zoneinfo import ZoneInfo

from workbook.grading.sandbox.sanitising import normalise_name

DAY = 86400
#: What is read here of `assignment.toml`.
FIELDS = {
    "due",
    "zone",
    "early",
    "late",
    "grace_days",
    "budget",
    "extensions",
    "exemptions",
    "labels",
}


class PolicyError(ValueError):
    """The policy cannot be used; the message has the field and what it takes."""


@dataclass(frozen=True)
class EarlyBonus:
    """What an early attempt gains.

    Parameters
    ----------
    days : float
        How long before the due date it has to be handed in.
    share : float
        The share of the points that right answers then have, above 1.
    """

    days: float
    share: float


@dataclass(frozen=True)
class LateRule:
    """What lateness costs.

    Parameters
    ----------
    per_day : float
        The share of the points that each day begun after the due date takes, from 0 to 1.
    steps : tuple of (float, float)
        Instead: (days, share that is kept until then), later steps keeping less; then nothing.
    floor : float
        The share that is kept in any case until the cut-off.
    cutoff_days : float or None
        After how many days nothing is kept; None is never.
    """

    per_day: float = 0.0
    steps: tuple = ()
    floor: float = 0.0
    cutoff_days: float | None = None

    def share(self, seconds):
        """Return the share of its points that an attempt keeps, so many seconds after the date.

        >>> LateRule(0.25, floor=0.4, cutoff_days=7).share(DAY), LateRule(0.25).share(DAY + 1)
        (0.75, 0.5)
        >>> LateRule(steps=((7, 0.8), (14, 0.5))).share(8 * DAY)
        0.5
        """
        if seconds <= 0:
            return 1.0
        if self.is_cut_off(seconds):
            return 0.0
        if self.steps:
            remaining = [share for days, share in self.steps if seconds <= days * DAY]
            return max(remaining[0] if remaining else 0.0, self.floor)
        return max(1.0 - self.per_day * days_begun(seconds), self.floor, 0.0)

    def is_cut_off(self, seconds):
        """Return whether nothing is kept any more."""
        return self.cutoff_days is not None and seconds > self.cutoff_days * DAY


@dataclass(frozen=True)
class Budget:
    """What the notebooks of one student may use together for a homework.

    Parameters
    ----------
    notebooks : int
        How many are read, the earliest first.
    megabytes : float
        The sizes of all files that are read.
    cpu_minutes : float
        Of computing; a notebook is begun while any of it is left.
    """

    notebooks: int = 500
    megabytes: float = 400
    cpu_minutes: float = 20


@dataclass(frozen=True)
class Policy:
    """When a homework is due, for whom, and what its time does to an attempt's points.

    Parameters
    ----------
    due : datetime.datetime or None
        With a time zone.
    early : EarlyBonus or None
        What an early attempt gains.
    late : LateRule or None
        What lateness costs; None is nothing.
    extensions : dict
        Later due dates by student or label, in the order of the file.
    exemptions : dict
        The problems, and answers such as "1.15.a_region", not asked of a student or label.
    labels : dict
        The students who have a label.
    zone : datetime.tzinfo or None
        The time zone of times that a system writes without one; that of `due` by default.
    grace_days : int
        Days of the whole course that a student may be late without loss: those that no homework
        with an earlier due date has used up.
    budget : Budget
        What the notebooks of one student may use.
    """

    due: datetime.datetime | None = None
    early: EarlyBonus | None = None
    late: LateRule | None = None
    extensions: dict = field(default_factory=dict)
    exemptions: dict = field(default_factory=dict)
    labels: dict = field(default_factory=dict)
    zone: datetime.tzinfo | None = None
    grace_days: int = 0
    budget: Budget = Budget()

    def due_of(self, student):
        """Return the due date of a student, or None."""
        if student in self.extensions:
            return self.extensions[student]
        dates = [
            date for label, date in self.extensions.items() if student in self.labels.get(label, ())
        ]
        return dates[-1] if dates else self.due

    def exempt_of(self, student):
        """Return the problems and answers that are not asked of a student."""
        return {
            name
            for owner, names in self.exemptions.items()
            if student == owner or student in self.labels.get(owner, ())
            for name in names
        }

    @property
    def students(self):
        """The students whom the policy names."""
        return {*self.extensions, *self.exemptions}.difference(self.labels).union(
            *self.labels.values()
        )

    def share(self, student, submitted, grace_days=0):
        """Return the share of its points that an attempt has, handed in at a time since 1970.

        `grace_days` are those that the student has left.
        """
        due = self.due_of(student)
        if due is None:
            return 1.0
        seconds = submitted - due.timestamp()
        if self.early and seconds <= -self.early.days * DAY:
            return self.early.share
        return self.late.share(seconds - grace_days * DAY) if self.late else 1.0

    def grace_days_used(self, student, submitted, grace_days):
        """Return how many of so many grace days an attempt uses up: those begun after the date."""
        due = self.due_of(student)
        late_by = days_begun(submitted - due.timestamp()) if due else 0
        return min(max(late_by, 0), grace_days)

    def explanation(self, student, submitted, grace_days=0):
        """Return a sentence on what the time does to an attempt's points, "" if nothing."""
        share, due = self.share(student, submitted, grace_days), self.due_of(student)
        if share > 1:
            return (
                f"Handed in at least {_days(self.early.days)} before the due date: right answers have "
                f"{share:.4g} times their points."
            )
        seconds = submitted - due.timestamp() if due else 0.0
        if seconds <= 0:
            return ""
        if self.late is None:
            return "Handed in after the due date."
        used = self.grace_days_used(student, submitted, grace_days)
        if used == days_begun(seconds):
            return (
                f"Handed in {_days(used)} after the due date (a day begun counts), which uses "
                f"{_days(used)} of your grace and costs no points."
            )
        grace = f"; {_days(used)} of your grace count as in time" if used else ""
        if self.late.is_cut_off(seconds - used * DAY):
            limit = f"more than {_days(self.late.cutoff_days)} " if self.late.cutoff_days else ""
            return f"Handed in {limit}after the due date{grace}: right answers have no points any more."
        return (
            f"Handed in {_days(days_begun(seconds))} after the due date (a day begun counts){grace}: "
            f"right answers have {_percent(share)} of their points."
        )


def days_begun(seconds):
    """Return how many days have begun."""
    return math.ceil(seconds / DAY)


def _days(number):
    return f"{number:g} day{'s' * (number != 1)}"


def _percent(share):
    return f"{100 * share:.3g}%"


# From the file


def read(table, points):
    """Return the `Policy` in the table of an assignment file; raises `PolicyError`.

    `points` are those of each answer by problem.
    """
    due, zone = table.get("due"), table.get("zone")
    if zone is not None:
        zone = time_zone(zone)
    if due is not None:
        due = _date(due, "due", zone)
    for name in ("early", "late"):
        _require(due is not None or name not in table, f"{name} needs a due date")
    grace_days = table.get("grace_days", 0)
    _require(
        type(grace_days) is int and 0 <= grace_days <= 365,
        "grace_days is a whole number of days from 0 to 365",
    )
    _require(
        not grace_days or "late" in table, "grace_days needs a table [late], which they soften"
    )
    labels = {
        label: _students(label, students)
        for label, students in _table(table, "labels", '"extended time" = ["ann", "bob"]').items()
    }
    extensions = {
        owner: _date(date, f'extensions."{owner}"', zone)
        for owner, date in _table(table, "extensions", '"ann" = 2026-10-08T23:59:00+03:00').items()
    }
    for owner, date in extensions.items():
        _require(
            due is not None and date >= due,
            f'extensions."{owner}" is before the due date, or there is none',
        )
    exemptions = _table(table, "exemptions", '"ann" = ["1.17"]')
    names = {*points, *(f"{p}.{a}" for p, answers in points.items() for a in answers)}
    for owner, exempt in exemptions.items():
        _require(
            isinstance(exempt, list) and exempt and all(name in names for name in exempt),
            f'exemptions."{owner}" is a list of problems or answers of the assignment: '
            '["1.15", "1.17.a_region"]',
        )
    return Policy(
        due,
        _early(table.get("early")),
        _late(table.get("late")),
        {normalise_name(owner): date for owner, date in extensions.items()},
        {normalise_name(owner): tuple(exempt) for owner, exempt in exemptions.items()},
        labels,
        zone or (due.tzinfo if due else None),
        grace_days,
        _budget(table.get("budget", {})),
    )


def time_zone(name):
    """Return the time zone of a name such as Europe/Moscow; raises `PolicyError`."""
    try:
        return ZoneInfo(name)
    except (KeyError, ValueError, TypeError, OSError):  # as of a path that is a folder
        raise PolicyError(
            f'zone is {name!r}, and is to be the name of a time zone: "Europe/Moscow", "UTC"'
        ) from None


def can_be_due(date):
    """Return whether the date can be shown in every time zone."""
    return 1970 < date.year < 9999


def _table(table, name, example):
    _require(
        isinstance(table.get(name, {}), dict),
        f"{name} is a table: [{name}], and below it {example}",
    )
    return table.get(name, {})


def _students(label, students):
    _require(
        isinstance(students, list) and all(isinstance(student, str) for student in students),
        f'labels."{label}" is a list of students in quotes, as their folders are named',
    )
    return frozenset(map(normalise_name, students))


def _budget(table):
    _require(
        isinstance(table, dict) and table.keys() <= {part.name for part in fields(Budget)},
        "budget is a table: [budget], and below it notebooks = 500, megabytes = 400 or "
        "cpu_minutes = 20",
    )
    for name, value in table.items():
        _require_number(value, f"budget.{name}", 0, 1_000_000)
    _require(type(table.get("notebooks", 0)) is int, "budget.notebooks is a whole number")
    return Budget(**table)


def _early(table):
    if table is None:
        return None
    _require(
        isinstance(table, dict) and table.keys() == {"days", "share"},
        "early is a table: [early], and below it days = 7 and share = 1.1",
    )
    _require_number(table["days"], "early.days", 0, 10_000)
    _require_number(table["share"], "early.share", 1, 2)
    return EarlyBonus(**table)


def _late(table):
    if table is None:
        return None
    _require(
        isinstance(table, dict)
        and table.keys() <= {rule.name for rule in fields(LateRule)}
        and len(table.keys() & {"per_day", "steps"}) <= 1
        and table.keys() & {"per_day", "steps", "cutoff_days"},
        "late is a table: [late], and below it per_day = 0.1 or steps = [[7, 0.8], [14, 0.5]], and "
        "perhaps floor and cutoff_days",
    )
    rule = dict(table)
    for name in rule.keys() - {"steps"}:
        _require_number(rule[name], f"late.{name}", 0, 10_000 if name == "cutoff_days" else 1)
    if "steps" in rule:
        rule["steps"] = _steps(rule["steps"])
    return LateRule(**rule)


def _steps(steps):
    message = "late.steps is a list of [days, share], each later than the one before and less: [[7, 0.8], [14, 0.5]]"
    _require(
        isinstance(steps, list)
        and steps
        and all(isinstance(step, list) and len(step) == 2 for step in steps),
        message,
    )
    for days, share in steps:
        _require_number(days, "each number of days in late.steps", 0, 10_000)
        _require_number(share, "each share in late.steps", 0, 1)
    _require(
        all(a[0] < b[0] and a[1] > b[1] for a, b in pairwise(steps)),
        message,
    )
    return tuple((days, share) for days, share in steps)


def _require_number(value, name, least, greatest):
    _require(
        type(value) in (int, float) and least <= value <= greatest,
        f"{name} is a number from {least} to {greatest}",
    )


def _date(date, name, zone):
    """Return a date of the file with its time zone, which may be that of the whole file."""
    is_date = isinstance(date, datetime.datetime)
    if is_date and date.tzinfo is None and zone is not None:
        date = date.replace(tzinfo=zone)
    _require(
        is_date and date.tzinfo is not None,
        f"{name} is a date with time and zone, without quotes: 2026-10-01T23:59:00+03:00",
    )
    _require(can_be_due(date), f"{name} is a date of our time, from 1971 to 9998")
    return date


def _require(condition, message):
    if not condition:
        raise PolicyError(message)
