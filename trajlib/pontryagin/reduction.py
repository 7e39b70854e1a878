"""Extremals without costates: where H_u = 0 leaves the costates no freedom that matters, states and control obey
differential equations of their own, and these have stationary points and a phase portrait.
"""

import sympy as sp


def reduced_field(problem, state, factor=1):
    """The right-hand sides for some states and the control along extremals inside the bounds, as a list.

    problem: with one control; state: those of its states that are wanted; factor: each side is multiplied by it, which
    is another measure of time. The costates that the end tells (of states that enter nothing) have their values. Of
    the others H_u = 0 has to determine the one that occurs, or the ratio of the two that do; else ValueError.

    >>> from trajlib.pontryagin import Problem, reduced_field
    >>> x, v, u, g = sp.symbols("x v u g")
    >>> flight = Problem({x: v*sp.cos(u), v: -g*sp.sin(u)}, {u: None}, {x: 0, v: 1}, final=-x, duration=1)
    >>> reduced_field(flight, [v])
    [-g*sin(u), g*cos(u)/v]
    """
    (u,) = problem.control
    costates = sp.symbols(f"psi:{len(problem.state)}", cls=sp.Dummy, real=True)
    sign = -1 if problem.maximise else 1
    H = sum(psi * f for psi, f in zip(costates, problem.field)) - sign * problem.running
    slope = sp.diff(H, u)
    drift = sum(sp.diff(slope, y) * f - sp.diff(slope, psi) * sp.diff(H, y)
                for y, f, psi in zip(problem.state, problem.field, costates))
    parts = [sp.expand(e.subs(_told_at_the_end(problem, costates, sign))) for e in (slope, drift, sp.diff(slope, u))]
    left = [psi for psi in costates if any(e.has(psi) for e in parts)]
    rest, gains = parts[0].subs(dict.fromkeys(left, 0)), [sp.diff(parts[0], psi) for psi in left]
    if len(left) == 1:
        values = {left[0]: -rest / gains[0]}
    elif len(left) == 2 and rest == 0:
        values = {left[0]: gains[1], left[1]: -gains[0]}
    elif not left:
        values = {}
    else:
        raise ValueError(f"H_{u} = 0 does not tell the costates: {len(left)} of them are left")
    turned, bend = (sp.simplify(e.subs(values)) for e in parts[1:])
    sides = dict(problem.dynamics) | {u: -turned / bend}
    return [sp.simplify(factor * sides[s]) for s in (*state, u)]


def _told_at_the_end(problem, costates, sign):
    """Costates of states that enter neither the equations nor the target, and the final cost linearly."""
    entered = set().union(*(e.free_symbols for e in (*problem.field, problem.running, *problem.terminal)))
    told = {psi: -sign * sp.diff(problem.final, y) for psi, y in zip(costates, problem.state) if y not in entered}
    return {psi: value for psi, value in told.items() if not value.free_symbols & set(problem.state)}
