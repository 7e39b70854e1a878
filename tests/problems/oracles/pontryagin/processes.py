"""Oracles of optimal processes, for which answers are functions of time, or lists of them."""

import sympy as sp

from oracles.pontryagin.transfers import same_transfer


def same_parts(mutant, reference, *_, **__):
    """True if two answers agree part by part."""
    lists = [list(one) if isinstance(one, (list, tuple, sp.MatrixBase)) else [one] for one in (mutant, reference)]
    return len(lists[0]) == len(lists[1]) and all(map(same_transfer, *lists))


ORACLES = dict.fromkeys((
    "optimal_control", "optimal_cost", "optimal_costate", "optimal_duration", "optimal_motion",
), same_parts)
