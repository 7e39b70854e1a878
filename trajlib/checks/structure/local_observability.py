"""What measurements z = h(x) of constant unknowns determine locally: all of them where the Jacobian has full rank.

The unknowns are a state that does not move, and the rows of the Jacobian its output; so the truth is that of `pairs`.
Each row is freed of its denominators and roots first, which do not change what it shows.
"""

import functools
import itertools
from dataclasses import replace

import sympy as sp

from trajlib.checks.contract.claims import Vectors
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import OUTPUT, judge_region
from trajlib.checks.structure.unseen_bases import judge_basis
from trajlib.checks.tools.conditions import Case
from trajlib.checks.truths.pairs import Pair


def _measurement_changes(k, order, number, value):
    return f"your change {k} alters the measurement {number or 1} at first order: its rate is {value}, up to a factor"


SIDE = replace(OUTPUT, holds="locally observable", fails="not locally observable",
               free="change of the unknowns, not zero, that alters no measurement to first order",
               none_free="every change of the unknowns alters a measurement to first order",
               basis_right="none of them alters a measurement to first order, they are independent, and there are no "
                           "more",
               shows=_measurement_changes, shows_little="your change {k} alters a measurement, though little")


@judged
def locally_determined(answer, measured, unknowns, parameters, at=None):
    """The condition on the parameters under which the Jacobian of the measured quantities by the unknowns has full
    rank.

    `at` are the values of the unknowns, {symbol: expression}, where they are not parameters themselves.
    """
    return judge_region(answer, _pair(tuple(measured), tuple(unknowns), tuple(parameters), _items(at)), SIDE)


@judged(Vectors("parameters", "unknowns", size="unknowns"))
def unseen_changes(claim, measured, unknowns, parameters=(), at=None):
    """A basis of the changes of the unknowns that alter none of the measured quantities to first order; an empty list
    if there are none."""
    return judge_basis(claim, _pair(tuple(measured), tuple(unknowns), tuple(parameters), _items(at)), SIDE)


class _Constants(Pair):
    """The rows of a Jacobian as the output of a state that does not move; decided by its minors one by one, which are
    simpler than the sum of their squares."""

    def __init__(self, rows, parameters):
        super().__init__(sp.zeros(rows.cols), rows, parameters)
        self._rows = rows

    @functools.cached_property
    def _seen(self):
        return Case(sp.And(self._given, sp.Not(self._lost))), Case(sp.And(self._given, self._lost))

    @functools.cached_property
    def _lost(self):
        minors = {sp.factor(self._rows.extract(list(some), list(range(self.order))).det(method="berkowitz"))
                  for some in itertools.combinations(range(self.outputs), self.order)}
        return sp.And(*(sp.Eq(_plain(minor), 0) for minor in minors))


def _plain(product):
    """The product of the different factors."""
    return sp.prod([factor for factor, _ in sp.factor_list(product)[1]]) if product != 0 else product


def _items(at):
    return tuple((at or {}).items())


@functools.lru_cache(maxsize=32)
def _pair(measured, unknowns, parameters, at):
    jacobian = sp.Matrix(measured).jacobian(unknowns).subs(dict(at), simultaneous=True)
    return _Constants(sp.ImmutableMatrix([_cleared(row) for row in jacobian.tolist()]), parameters)


def _cleared(row):
    """The row times a function that is nowhere zero, so that its entries are polynomials."""
    parts = [sp.fraction(sp.together(entry)) for entry in row]
    below = {one for _, one in parts}
    return [sp.expand(above * sp.prod(below - {one})) for above, one in parts]
