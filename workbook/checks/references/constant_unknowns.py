"""Which constant unknowns x the measurements z = h(x) determine locally.

They are determined where the Jacobian has full rank. The unknowns are a state that does not move,
and the rows of the Jacobian its output; so the reference is that of `pairs`. Each row is first freed
of denominators and roots, which does not change its kernel.
"""

import functools

import sympy as sp

from workbook.checks.references.invariant_subspaces import maximal_minors
from workbook.checks.references.pairs import Pair


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
    def _observability_cases(self):
        minors = set(map(sp.factor, maximal_minors(self._rows)))
        return self._cases_where(sp.And(*(sp.Eq(_squarefree(minor), 0) for minor in minors)))


def _squarefree(product):
    """Return the product of the distinct factors."""
    return sp.prod([factor for factor, _ in sp.factor_list(product)[1]]) if product else product


def _cleared(row):
    """Return a row times a function without zeros, so that its entries are polynomials."""
    parts = [sp.fraction(sp.together(entry)) for entry in row]
    denominators = {denominator for _, denominator in parts}
    return [
        sp.expand(numerator * sp.prod(denominators - {denominator}))
        for numerator, denominator in parts
    ]
