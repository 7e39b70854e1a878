"""Oracles of optimal processes, for which answers are functions of time, or lists of them."""

import sympy as sp

from oracles.pontryagin.transfers import same_transfer


def same_parts(mutant, reference, *_, **__):
    """True if two answers agree part by part."""
    lists = [
        list(one) if isinstance(one, (list, tuple, sp.MatrixBase)) else [one]
        for one in (mutant, reference)
    ]
    return len(lists[0]) == len(lists[1]) and all(
        map(same_transfer, *(map(sp.sympify, one) for one in lists))
    )


def same_or_mirrored(mutant, reference, problem, *_, **__):
    """True if a control is the other one, or its mirror image where this changes nothing in the
    problem, or another turn of the same angle."""
    mutant, reference = _with_length(mutant), _with_length(reference)
    return same_parts(mutant, reference) or (
        isinstance(mutant, sp.Expr)
        and (
            (_symmetric(problem) and same_parts(-mutant, reference))
            or (
                _of_angle(problem)
                and isinstance(reference, sp.Expr)
                and same_parts(
                    [sp.cos(mutant), sp.sin(mutant)], [sp.cos(reference), sp.sin(reference)]
                )
            )
        )
    )


def _with_length(control):
    """Return a list of arcs [value, until] without those that end where the one before ends."""
    if not isinstance(control, (list, tuple)):
        return control
    kept, begin = [], sp.Integer(0)
    for arc in control:
        if isinstance(arc, (list, tuple)) and len(arc) == 2 and sp.sympify(arc[1]) == begin:
            continue
        kept.append(arc)
        begin = sp.sympify(arc[1]) if isinstance(arc, (list, tuple)) and len(arc) == 2 else None
    return kept


def _of_angle(problem):
    """Whether the control is an angle without bounds, of which only the direction counts."""
    ((u, bounds),) = problem.controls.items()
    return all(b.is_infinite for b in bounds) and all(
        sp.expand(f.subs(u, u + 2 * sp.pi) - f) == 0 for f in (*problem.field, problem.running)
    )


def _symmetric(problem):
    """Whether a problem is the same after a change of all signs of states and controls."""
    changed = {s: -s for s in (*problem.state, *problem.control)}
    return (
        all(
            sp.expand(f.subs(changed, simultaneous=True) + f) == 0
            for f in (*problem.field, *problem.terminal)
        )
        and all(
            sp.expand(f.subs(changed, simultaneous=True) - f) == 0
            for f in (problem.running, problem.final)
        )
        and all(low + high == 0 for low, high in problem.controls.values())
        and set(problem.initial.values()) == {0}
    )


ORACLES = dict.fromkeys(
    (
        "initial_arc_duration",
        "optimal_cost",
        "optimal_costate",
        "optimal_duration",
        "optimal_range",
        "optimal_motion",
    ),
    same_parts,
) | {"optimal_control": same_or_mirrored}
