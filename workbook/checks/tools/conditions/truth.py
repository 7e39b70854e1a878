"""What is true of a condition on parameters: where it has to hold and where it must not.

A truth comes as cases: `inside`, where the condition has to hold, and `outside`, where it must not;
where neither is so, both will do. A case is a condition in the parameters and further unknowns (a
state of rest, a root) and means that such unknowns exist, or, with `every`, that it is so for all
of them.
"""

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Case:
    """The parameters for which `condition` holds for some values of `unknowns`, or for every one of
    them.

    `angles` are those symbols that run from 0 to 2 pi, without the end: then they may be compared
    with other angles.
    """

    condition: object
    unknowns: tuple = ()
    every: bool = False
    angles: tuple = ()


@dataclass(frozen=True)
class Truth:
    """Where a condition has to hold and where it must not, cases each; `at(values)` says so at one
    point: True, False, None.

    `at` serves where nothing can be decided, at `points()` or else along lines, and confirms what
    is said of every value of an unknown. A truth that only `at` knows has no cases.
    """

    inside: tuple = ()
    outside: tuple = ()
    at: object = None
    points: object = None

    @property
    def cases(self):
        return [*((case, True) for case in self.inside), *((case, False) for case in self.outside)]


def exactly(condition, given=sp.true, unknowns=(), at=None, points=None):
    """The truth `condition` at all parameters and unknowns with `given`; elsewhere either will do.
    Where it is None, no closed form being known, there is nothing but `at`."""
    if condition is None:
        return Truth(at=at, points=points)
    inside, outside = (
        (Case(sp.And(given, part), tuple(unknowns)),) for part in (condition, sp.Not(condition))
    )
    return Truth(inside, outside, at, points)
