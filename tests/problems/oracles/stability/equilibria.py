"""Oracles of planar portraits."""

import sympy as sp

from oracles.sameness import same_value, vanishes


def first_integral(mutant, reference, field, state, *_):
    """True for every function of the state, not constant, whose derivative along the motions is
    identically zero."""
    rate = sum(sp.diff(mutant, x) * f for x, f in zip(state, field))
    return bool(mutant.free_symbols & set(state)) and vanishes(rate)


def same_points(mutant, reference, field, state, *_, **__):
    """The same value, whatever the order of several points."""
    several = isinstance(reference, (list, tuple)) and (
        len(state) == 1 or isinstance(reference[0], (list, tuple))
    )
    if several and isinstance(mutant, (list, tuple)) and len(mutant) != len(reference):
        return False  # a point is missing, or given twice
    return same_value(mutant, reference, "list of vector" if several else "")


ORACLES = {"equilibria": same_points, "first_integral": first_integral}
