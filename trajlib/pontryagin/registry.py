"""Optimal control problems with known solutions, as data for tests of other programs too.

`problems.json` has the statements in SymPy syntax, costs and times as decimals with the digits on which two
routes agree, sources, and printed digits that agree or are refuted; `problems.schema.json`
describes its fields. Both routes are run by the tests of the library, which hold the file.
"""

import json
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cache
from importlib.resources import files
from typing import Any

import sympy as sp

from trajlib.pontryagin.optimal_control import Problem


@dataclass(frozen=True)
class KnownProblem:
    """An optimal control problem with its solution by two routes.

    Attributes
    ----------
    name : str
        By which `problems` finds it.
    problem : Problem
        The statement, without parameters, in its original units.
    cost : float
        Of the best process known.
    digits : str
        The cost with the digits on which both routes agree.
    arcs : list or None
        Kinds of arcs in order; None where they are not compared.
    times : list of float or None
        Ends of the arcs but for the last one.
    route : str
        The route other than `Problem.solve`.
    source : str
        Where the problem is stated; empty for one that was made for tests.
    published, refuted : list of [str, float]
        Printed values, with the place, that agree with both routes, and that do not.
    group : str
        "classical", "unconstrained", "integrated" or "constrained".
    """

    name: str
    problem: Problem = field(repr=False)
    cost: float
    digits: str
    arcs: list | None
    times: list[float] | None
    route: str
    source: str
    published: list
    refuted: list
    group: str


def problems(name: str | None = None) -> "tuple[str, ...] | KnownProblem":
    """Return the names of all problems with known solutions, or the problem of a name.

    Parameters
    ----------
    name : str, optional
        One of the names; case does not count.

    Returns
    -------
    tuple of str or KnownProblem
        All names, or the problem.

    Raises
    ------
    ValueError
        If there is no problem of this name.

    Examples
    --------
    >>> from trajlib.pontryagin import problems
    >>> goddard = problems("goddard")
    >>> goddard.arcs, goddard.digits
    (['u+', 'singular', 'u-'], '1.01283692')
    >>> round(goddard.problem.solve().cost, 8)
    1.01283692
    """
    table = _data()
    if name is None:
        return tuple(table)
    found = {known.lower(): known for known in table}
    key = str(name).lower()
    if key not in found:
        near = get_close_matches(key, found, 1, 0.5)
        meant = f"; did you mean {found[near[0]]!r}?" if near else ""
        raise ValueError(f"name: expected one of problems(), got {name!r}{meant}")
    return _known(found[key])


@cache
def _data():
    """Return name -> fields of the data file."""
    text = files(__package__).joinpath("problems.json").read_text(encoding="utf-8")
    return json.loads(text)["problems"]


@cache
def _known(name):
    entry = _data()[name]
    symbols = {s: sp.Symbol(s, real=True) for part in ("dynamics", "controls") for s in entry[part]}

    def read(value: Any):
        if isinstance(value, list):
            return [read(part) for part in value]
        if isinstance(value, dict):
            return {symbols[key]: read(part) for key, part in value.items()}
        return sp.parse_expr(value, symbols) if isinstance(value, str) else value

    parts = ("dynamics", "controls", "initial", "terminal", "running", "final", "duration", "path")
    problem = Problem(
        **{part: read(entry[part]) for part in parts},
        terminal_inequalities=read(entry["terminal_inequalities"]),
        maximise=entry["maximise"],
    )
    return KnownProblem(
        name,
        problem,
        float(entry["cost"]),
        entry["cost"],
        entry["arcs"],
        entry["times"] and [float(time) for time in entry["times"]],
        *(entry[part] for part in ("route", "source", "published", "refuted", "group")),
    )
