"""Oracles of what Lyapunov functions prove."""

import sympy as sp

from oracles.sameness import LOGIC, excluded, same_condition


def basin_estimate(mutant, reference, function, field, state, parameters=(), given=()):
    """As `same_condition`, but the border itself is a convention: {V < c} and {V <= c} are the same
    estimate.

    Parameters that the problem excludes count for nothing.
    """
    return isinstance(mutant, LOGIC) and same_condition(
        _closed(mutant), _closed(reference), excluded(given)
    )


def _closed(condition):
    return condition.replace(
        lambda node: isinstance(node, (sp.StrictLessThan, sp.StrictGreaterThan)),
        lambda node: (sp.Le if isinstance(node, sp.StrictLessThan) else sp.Ge)(node.lhs, node.rhs),
    )


ORACLES = {"basin_estimate": basin_estimate}
