"""Instants at which an answer in time changes its formula, read from the answer itself."""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import is_slow, real_function

#: Number of parts of the duration in which a change is looked for, and of halvings of such a part.
PARTS, HALVINGS = 720, 46
#: Changes that are closer to each other or to the ends, relative to the duration, count as one.
APART = 2e-9


class FormulaChanges:
    """The instants at which expressions in time pass from one formula to another."""

    def __init__(self, claims, symbols):
        borders = [] if any(map(is_slow, claims)) else _borders(claims)
        self._functions = [real_function(symbols, [border]) for border in borders]

    def instants(self, numbers, begin, end):
        """Return them between two instants, in order; `numbers` are those of the parameters."""
        times, changes = np.linspace(begin, end, PARTS + 1), []
        for function in self._functions:

            def is_positive(points, _=None, function=function):
                return function(points, *numbers)[0] > 0

            positive = is_positive(times)
            parts = np.flatnonzero(positive[:-1] != positive[1:])
            if len(parts):
                _, last = bisect(
                    lambda points, rows, parts=parts, positive=positive: (
                        is_positive(points) == positive[parts[rows]]
                    ),
                    times[parts],
                    times[parts + 1],
                    HALVINGS,
                )
                changes += last.tolist()
        apart = APART * (end - begin)
        inside = [t for t in sorted(changes) if begin + apart < t < end - apart]
        return [t for k, t in enumerate(inside) if not k or t - inside[k - 1] > apart]


def _borders(claims):
    """Return the expressions whose signs decide which formula of a piecewise one holds."""
    borders = set()
    for claim in claims:
        borders |= {
            relation.lhs - relation.rhs for relation in claim.atoms(sp.core.relational.Relational)
        }
        borders |= {e.args[0] for e in claim.atoms(sp.Abs, sp.sign, sp.Heaviside)}
        borders |= {
            first - second
            for e in claim.atoms(sp.Max, sp.Min)
            for first, second in itertools.combinations(e.args, 2)
        }
    return sorted(borders, key=sp.default_sort_key)
