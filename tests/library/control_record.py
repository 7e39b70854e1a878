"""The form of a test problem of optimal control with its solution by two routes."""

from dataclasses import dataclass

from trajlib.pontryagin import Problem


@dataclass
class Record:
    """A problem with its arcs, junction times and cost by a route other than `Problem.solve`.

    `arcs` and `times` are None where they are not compared. `source` is empty for a problem that was
    made for these tests. `published`: (print, value, tolerance) that agree; `refuted`: (print, value)
    that do not.
    """

    problem: Problem
    arcs: list | None
    times: list | None
    cost: float
    route: str
    source: str = ""
    tolerance: float = 1e-10
    published: tuple = ()
    refuted: tuple = ()
