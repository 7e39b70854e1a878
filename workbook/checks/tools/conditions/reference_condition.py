"""References of conditions on parameters: where one has to hold and where it must not.

A reference consists of cases: `inside`, where the condition has to hold, and `outside`, where it
must not; elsewhere either truth value is accepted. A case is a condition in the parameters and
further unknowns (an equilibrium, a root) and means that such unknowns exist, or, with `every`, that
it holds for all of them.
"""

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Case:
    """The parameters for which a condition holds for some, or for all, values of unknowns.

    Parameters
    ----------
    condition : sympy condition
        In the parameters and the unknowns.
    unknowns : tuple of sympy.Symbol
        The unknowns.
    every : bool
        Whether the condition holds for all values of the unknowns.
    angles : tuple of sympy.Symbol
        Symbols that run from 0 to 2 pi, without the end: they may be compared with other angles.
    """

    condition: object
    unknowns: tuple = ()
    every: bool = False
    angles: tuple = ()


@dataclass(frozen=True)
class ReferenceCondition:
    """Where a condition has to hold and where it must not.

    Parameters
    ----------
    inside, outside : tuple of Case
        The cases where it has to hold and where it must not; empty if only `at` is known.
    at : callable, optional
        `at(values)` at one point: True, False, or None where either is accepted. It serves where
        nothing can be decided, and confirms claims about every value of an unknown.
    points : callable, optional
        `points()` yields points for `at`; without it they are taken along lines.
    """

    inside: tuple = ()
    outside: tuple = ()
    at: object = None
    points: object = None

    @property
    def cases(self):
        return [*((case, True) for case in self.inside), *((case, False) for case in self.outside)]


def exactly(condition, domain=sp.true, unknowns=(), at=None, points=None):
    """Return the reference that a condition holds, for all parameters and unknowns of a domain.

    Parameters
    ----------
    condition : sympy condition or None
        The true condition, or None if no closed form is known; then only `at` is used.
    domain : sympy condition
        Where either truth value is not accepted.
    unknowns : tuple of sympy.Symbol
        Unknowns in these conditions.
    at, points : callable, optional
        As for `ReferenceCondition`.
    """
    if condition is None:
        return ReferenceCondition(at=at, points=points)
    inside, outside = (
        (Case(sp.And(domain, part), tuple(unknowns)),) for part in (condition, sp.Not(condition))
    )
    return ReferenceCondition(inside, outside, at, points)
