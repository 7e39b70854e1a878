"""Read the sections, figures and routes of `book/routes.toml`.

It is in book/ of a checkout, and in the package where it was installed from a wheel. A section has a
short name, its page, and what it needs; a part of a section has its label and the section `of` it. A
week names sections, a lecture, figures, problems for the class and the homework.
"""

import re
import tomllib
from dataclasses import dataclass
from functools import cache, cached_property

from workbook.authoring.contract import item_of
from workbook.authoring.study_time import rounded_minutes
from workbook.course import PACKAGE, WORKBOOK
from workbook.notebooks import exercises

#: A problem, or a problem with the items that are asked of it: "1.13 a, b".
TASK = re.compile(r"(\d+\.\d+)(?: ([a-z](?:, [a-z])*))?")
#: Questions inside a section, unless the file gives another number.
QUESTIONS = 3


class UnknownRoute(ValueError):
    """There is no route of a name, or no week of a number; the message is one line."""


@dataclass(frozen=True)
class Section:
    """A section, or a part of one.

    Attributes
    ----------
    label, name : str
        Its label in the book, and a short name.
    page : str
        Its page below book/, such as "ch1/hurwitz".
    of : str
        The label of the section that it is a part of; its own if it is whole.
    needs : tuple of str
        Labels of the sections that a reader has to know.
    at : tuple of int
        (column, row) on the map; empty if it is not there.
    questions : int
        How many questions its page has.
    """

    label: str
    name: str
    page: str
    of: str
    needs: tuple = ()
    at: tuple = ()
    questions: int = 0


@dataclass(frozen=True)
class Figure:
    """An interactive figure: the section that has it, and what it asks."""

    name: str
    section: str
    asks: str


@dataclass(frozen=True)
class Task:
    """A problem of a week; `items` are those that are asked, all if there are none."""

    problem: str
    items: tuple = ()

    @property
    def answers(self):
        """Names of the answers that are asked."""
        names = exercises.find(self.problem).about["answers"]
        return [name for name in names if not self.items or item_of(name) in self.items]

    @property
    def minutes(self):
        """Estimated minutes by the rule of `study_time`, to five minutes."""
        level = exercises.find(self.problem).about["level"]
        return rounded_minutes(level, len(self.answers))

    def __str__(self):
        return " ".join((self.problem, ", ".join(self.items))).strip()


@dataclass(frozen=True)
class Week:
    """A week, or another unit of a route; `asks` is its question, `library` names modules."""

    number: int
    sections: tuple = ()
    lecture: str = ""
    tutorial: str = ""
    figures: tuple = ()
    in_class: tuple = ()
    homework: tuple = ()
    library: tuple = ()
    asks: str = ""
    note: str = ""

    @property
    def minutes(self):
        """Estimated minutes of the homework."""
        return sum(task.minutes for task in self.homework)


@dataclass(frozen=True)
class Route:
    """A way through the course; `terms` are the weeks of each of its terms."""

    name: str
    title: str
    about: str
    unit: str
    terms: tuple
    weeks: tuple

    def week(self, number):
        """Return a week by its number, from 1 up; raises `UnknownRoute`."""
        if not 1 <= number <= len(self.weeks):
            raise UnknownRoute(f"{self.title} has the {self.unit}s 1 to {len(self.weeks)}")
        return self.weeks[number - 1]


@dataclass(frozen=True)
class Course:
    """All sections, figures and routes by their labels and names."""

    sections: dict
    figures: dict
    routes: dict

    @cached_property
    def needed(self):
        """All that each section needs, directly or through others: {label: set of labels}."""
        needed = {}

        def collect(label):
            if label not in needed:
                direct = self.sections[label].needs
                needed[label] = set(direct).union(*map(collect, direct))
            return needed[label]

        for label in self.sections:
            collect(label)
        return needed

    @property
    def edges(self):
        """Pairs (what is needed, for what) of the map, without those that follow from others."""
        return [
            (need, label)
            for label, section in self.sections.items()
            for need in section.needs
            if not any(need in self.needed[other] for other in section.needs)
        ]

    def pages_of(self, week):
        """Return the whole sections that a week reads, those of its parts included."""
        wholes = (self.sections[label].of for label in week.sections)
        return [self.sections[label] for label in dict.fromkeys(wholes)]

    def assumed(self, route):
        """Return the sections that the sections of a route need and that come not before them."""
        read, assumed = set(), {}
        for week in route.weeks:
            for section in self.pages_of(week):
                assumed |= dict.fromkeys(need for need in section.needs if need not in read)
                read.add(section.label)
        return [self.sections[label] for label in self.sections if label in assumed]

    def find(self, name):
        """Return a route by its name; raises `UnknownRoute`."""
        if name not in self.routes:
            raise UnknownRoute(f"there is no route {name}; there are {', '.join(self.routes)}")
        return self.routes[name]


@cache
def course():
    """Return what the file says."""
    path = WORKBOOK.folder / "book" / "routes.toml"
    if not path.is_file():
        path = PACKAGE / "_routes.toml"
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    sections = {
        label: _section(label, fields, table) for label, fields in table["sections"].items()
    }
    figures = {name: Figure(name, **fields) for name, fields in table["figures"].items()}
    routes = {name: _route(name, fields) for name, fields in table["routes"].items()}
    return Course(sections, figures, routes)


def _section(label, fields, table):
    of = fields.get("of", label)
    whole = table["sections"][of]
    on_map = "at" in whole
    return Section(
        label,
        fields["name"],
        whole["page"],
        of,
        tuple(fields.get("needs", ())),
        tuple(fields.get("at", ())),
        whole.get("questions", QUESTIONS if on_map else 0),
    )


def _route(name, fields):
    weeks = tuple(_week(k, week) for k, week in enumerate(fields["weeks"], start=1))
    return Route(
        name,
        fields["title"],
        fields["about"],
        fields.get("unit", "week"),
        tuple(fields.get("terms", [len(weeks)])),
        weeks,
    )


def _week(number, fields):
    tasks = {
        field: tuple(map(_task, fields.get(key, ())))
        for field, key in (("in_class", "class"), ("homework", "homework"))
    }
    others = {
        key: tuple(value) if isinstance(value, list) else value
        for key, value in fields.items()
        if key not in ("class", "homework")
    }
    return Week(number, **others, **tasks)


def _task(text):
    problem, items = TASK.fullmatch(text).groups()
    return Task(problem, tuple(items.split(", ")) if items else ())
