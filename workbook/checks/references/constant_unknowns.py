"""Which constant unknowns x the measurements z = h(x) determine locally.

They are determined where the Jacobian has full rank. The unknowns are a state that does not move,
and the rows of the Jacobian its output; so the reference is that of `pairs`. Each row is first freed
of denominators and roots, which does not change its kernel.
"""

import functools
import itertools

import sympy as sp

from workbook.checks.references.pairs import Pair
from workbook.checks.tools.conditions import Case


@functools.lru_cache(maxsize=32)
def constants_of(jacobian, parameters):
    """Return the `Pair` of an immutable Jacobian, for a tuple of parameters."""
    return _Constants(sp.ImmutableMatrix([_cleared(row) for row in jacobian.tolist()]), parameters)


class _Constants(Pair):
    """The rows of a Jacobian as the output of a state that does not move.

    Observability is decided by the minors one by one, which are simpler than the sum of their squares.
    """

    def __init__(self, rows, parameters):
        super().__init__(sp.zeros(rows.cols), rows, parameters)
        self._rows = rows

    @functools.cached_property
    def _seen(self):
        return Case(sp.And(self._given, sp.Not(self._lost))), Case(sp.And(self._given, self._lost))

    @functools.cached_property
    def _lost(self):
        minors = {
            sp.factor(
                self._rows.extract(list(some), list(range(self.order))).det(method="berkowitz")
            )
            for some in itertools.combinations(range(self.outputs), self.order)
        }
        return sp.And(*(sp.Eq(_plain(minor), 0) for minor in minors))


def _plain(product):
    """Return the product of the different factors."""
    return (
        sp.prod([factor for factor, _ in sp.factor_list(product)[1]]) if product != 0 else product
    )


def _cleared(row):
    """Return a row times a function without zeros, so that its entries are polynomials."""
    parts = [sp.fraction(sp.together(entry)) for entry in row]
    below = {denominator for _, denominator in parts}
    return [sp.expand(above * sp.prod(below - {denominator})) for above, denominator in parts]
