"""Oracles of time-optimal feedback."""

import sympy as sp

from oracles.sameness import agree_at_random


def same_synthesis(mutant, reference, system, target, parameters=None, start=None, curve=None):
    """True if two laws, or two conditions on the start, agree at random starts: on curves they may
    differ."""
    free = [*system.state, *(curve or ())[:1]]
    return agree_at_random(
        mutant, reference, dict.fromkeys(free, sp.S.Reals) | (parameters or {}), start
    )


def same_extremals(mutant, reference, system, target, start=None):
    """True if two conditions on the start, or two times, agree at random starts."""
    return agree_at_random(mutant, reference, dict.fromkeys(system.state, sp.S.Reals), start)


def same_arcs(mutant, reference, system, target, ends, variable, parameters=None, start=None):
    """True if two conditions on the end points or parameters agree at random values: at single
    values they may differ."""
    return agree_at_random(mutant, reference, {variable: sp.S.Reals, **(parameters or {})})


def same_points(mutant, reference, system, target, ends, variable, parameters=None, start=None):
    """True if two conditions on the end points agree at random values, and where the mutant asks
    for an equation, which random values do not meet: there it has to say what the reference says,
    or what it says beside."""
    domain = {variable: sp.S.Reals, **(parameters or {})}
    if not agree_at_random(mutant, reference, domain):
        return False
    values = {
        p: interval.inf + 1 if interval.sup == sp.oo else (interval.inf + interval.sup) / 2
        for p, interval in domain.items()
        if p != variable
    }
    mutant, reference = (sp.sympify(condition).subs(values) for condition in (mutant, reference))
    for equation in mutant.atoms(sp.Eq, sp.Ne):
        for root in sp.solve(equation.lhs - equation.rhs, variable):
            step = sp.Rational(1, 99)
            true = {
                bool(reference.subs(variable, place)) for place in (root - step, root, root + step)
            }
            if root in domain[variable] and bool(mutant.subs(variable, root)) not in true:
                return False
    return True


def same_curve(mutant, reference, system, target, ends, variable, parameters=None, start=None):
    """True if two lists of expressions have the same values at random places: quicker than to
    simplify trigonometric functions."""
    if not isinstance(mutant, (list, tuple)) or len(mutant) != len(reference):
        return False
    return all(
        agree_at_random(a, b, {variable: sp.S.Reals, **(parameters or {})})
        for a, b in zip(mutant, reference)
    )


ORACLES = {
    "time_optimal_law": same_synthesis,
    "minimal_time": same_synthesis,
    "reachable_initial_states": same_synthesis,
    "other_extremal_exists": same_extremals,
    "other_extremal_time": same_extremals,
    "reached_target_points": same_points,
    "minimal_time_continuous": same_arcs,
    "switching_points": same_curve,
    "switching_curve_crossing": same_curve,
}
