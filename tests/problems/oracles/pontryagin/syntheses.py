"""Oracles of time-optimal feedback."""

import sympy as sp

from oracles.sameness import agree_at_random


def same_synthesis(mutant, reference, field, state, control, bounds, target, parameters=None, start=None, curve=None):
    """True if two laws, or two conditions on the start, agree at random starts: on curves they may differ."""
    parameters = parameters or {}
    return agree_at_random(mutant, reference, {**dict.fromkeys([*state, *([curve[0]] if curve else [])], sp.S.Reals),
                                               **parameters}, start)


def same_extremals(mutant, reference, field, state, control, bounds, target, start=None):
    """True if two conditions on the start, or two times, agree at random starts."""
    return agree_at_random(mutant, reference, dict.fromkeys(state, sp.S.Reals), start)


def same_arcs(mutant, reference, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """True if two conditions on the end points or parameters agree at random values: at single values they may
    differ."""
    return agree_at_random(mutant, reference, {variable: sp.S.Reals, **(parameters or {})})


def same_curve(mutant, reference, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """True if two lists of expressions have the same values at random places: quicker than to simplify trigonometric
    functions."""
    if not isinstance(mutant, (list, tuple)) or len(mutant) != len(reference):
        return False
    return all(agree_at_random(a, b, {variable: sp.S.Reals, **(parameters or {})}) for a, b in zip(mutant, reference))


ORACLES = {
    "time_optimal_law": same_synthesis, "minimal_time": same_synthesis, "reachable_starts": same_synthesis,
    "other_extremals": same_extremals, "other_extremal_time": same_extremals,
    "reached_part": same_arcs, "continuous_time": same_arcs,
    "switching_points": same_curve, "switching_crossing": same_curve,
}
