"""The motion of a control inside its bounds, with the costates eliminated.

Where H is greatest inside the bounds, H_u = 0 all the time, and so is its derivative along the
motion and the adjoint equations: u' = -(derivative of H_u for a fixed u)/H_uu. If one costate that
enters is not known from the end of the process, H_u = 0 expresses it by the state and the control;
if two are, and nothing stands beside them, it tells their ratio, which is enough.
"""

from collections.abc import Sequence
from functools import cached_property

import sympy as sp


class ControlField(Sequence):
    """The right-hand sides for a control and some states, the costates eliminated, as data of a
    statement.

    They are those of `conditions().control_field`. problem: a `Problem` with one control; symbols:
    the control and states, in the order that is wanted; factor: each side is multiplied by it,
    which is another measure of time. The sides are worked out when they are asked for, so that a
    statement can name what the student is to find.

    >>> from trajlib.pontryagin import ControlField, Problem
    >>> x, v, u, g = sp.symbols("x v u g")
    >>> flight = Problem({x: v*sp.cos(u), v: -g*sp.sin(u)}, {u: None}, {x: 0, v: 1}, final=-x, duration=1)
    >>> field = ControlField(flight, [u, v])
    >>> field
    ControlField: u', v' along extremals
    >>> list(field)
    [g*cos(u)/v, -g*sin(u)]
    """

    def __init__(self, problem, symbols, factor=1):
        self.problem, self.symbols, self.factor = problem, tuple(symbols), sp.sympify(factor)

    def __len__(self):
        return len(self.symbols)

    def __getitem__(self, k):
        return self._sides[k]

    def __repr__(self):
        return "ControlField: " + ", ".join(f"{s}'" for s in self.symbols) + " along extremals"

    def subs(self, values):
        """The same with values, {parameter: value}, for parameters of the problem."""
        return ControlField(self.problem.subs(values), self.symbols, self.factor.subs(values))

    @cached_property
    def _sides(self):
        sides = dict(self.problem.dynamics) | control_field(self.problem)
        return [
            sp.simplify(self.factor * sides[s]) if self.factor != 1 else sides[s]
            for s in self.symbols
        ]


def control_field(problem):
    """{control: u', state: ...}: the equation of the control, and those of the states that enter
    it, in their order."""
    if len(problem.control) != 1:
        raise ValueError("problem: the costates are eliminated for problems with one control")
    (u,), sign = problem.control, -1 if problem.maximise else 1
    costates = sp.symbols(f"psi:{len(problem.state)}", cls=sp.Dummy, real=True)
    H = sum(psi * f for psi, f in zip(costates, problem.field)) - sign * problem.running
    slope = sp.diff(H, u)
    drift = sum(
        sp.diff(slope, y) * f - sp.diff(slope, psi) * sp.diff(H, y)
        for y, f, psi in zip(problem.state, problem.field, costates)
    )
    known = _known(problem, costates, sign)
    slope, drift, bend = (sp.expand(e.subs(known)) for e in (slope, drift, sp.diff(slope, u)))
    free = [psi for psi in costates if any(e.has(psi) for e in (slope, drift, bend))]
    rest, gains = slope.subs(dict.fromkeys(free, 0)), [sp.diff(slope, psi) for psi in free]
    if len(free) == 2 and rest == 0:
        values = {free[0]: gains[1], free[1]: -gains[0]}
    elif len(free) == 1:
        values = {free[0]: -rest / gains[0]}
    elif not free:
        values = {}
    else:
        raise ValueError(
            f"problem: {len(free)} costates are not known from the end of the process, and the "
            "condition H_u = 0 does not eliminate them"
        )
    rate = -sp.simplify(drift.subs(values)) / sp.simplify(bend.subs(values))
    field = {u: sp.expand(sp.trigsimp(sp.simplify(rate)))}
    met = {y for y in problem.dynamics if field[u].has(y)}
    while more := {
        y for y in problem.dynamics if y not in met and any(problem.dynamics[z].has(y) for z in met)
    }:
        met |= more
    return field | {y: f for y, f in problem.dynamics.items() if y in met}


def _known(problem, costates, sign):
    """Costates of states that enter neither the equations nor the target, and the final cost
    linearly: the end tells them, and they do not change."""
    entered = set().union(
        *(e.free_symbols for e in (*problem.field, problem.running, *problem.terminal))
    )
    told = {
        psi: -sign * sp.diff(problem.final, y)
        for psi, y in zip(costates, problem.state)
        if y not in entered
    }
    return {
        psi: value for psi, value in told.items() if not value.free_symbols & set(problem.state)
    }
