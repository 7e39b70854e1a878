"""The differential equation of a control inside its bounds, with the costates eliminated.

Where H is largest inside the bounds, H_u = 0 all the time, and so is its derivative along the
trajectory and the adjoint equations: u' = -(derivative of H_u for a fixed u)/H_uu. If one costate
that enters is not known from the terminal conditions, H_u = 0 expresses it by the state and the
control; if two are, and H_u is homogeneous in them, it determines their ratio, which is enough.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property

import sympy as sp

from trajlib.pontryagin.problem.statement import Statement


class ControlField(Sequence):
    """The right-hand sides for a control and some states, with the costates eliminated.

    They are those of `conditions().control_field`, computed on first access, so that a statement
    can name what the student is to find. The object is a sequence of expressions.

    Parameters
    ----------
    problem : Problem
        With one control.
    symbols : list of sympy.Symbol
        The control and states, in the order of the right-hand sides.
    factor : sympy.Expr, optional
        Multiplies each right-hand side, for another measure of time.

    Raises
    ------
    ValueError
        On access, if the problem has several controls or H_u = 0 does not eliminate the costates.

    Examples
    --------
    >>> from trajlib.pontryagin import ControlField, Problem
    >>> x, v, u, g = sp.symbols("x v u g")
    >>> flight = Problem({x: v*sp.cos(u), v: -g*sp.sin(u)}, {u: None}, {x: 0, v: 1}, final=-x, duration=1)
    >>> field = ControlField(flight, [u, v])
    >>> field
    ControlField: u', v' along extremals
    >>> list(field)
    [g*cos(u)/v, -g*sin(u)]
    """

    def __init__(self, problem: Statement, symbols, factor=1):
        self.problem, self.symbols, self.factor = problem, tuple(symbols), sp.sympify(factor)

    def __len__(self):
        return len(self.symbols)

    def __getitem__(self, k):
        return self._sides[k]

    def __repr__(self):
        return "ControlField: " + ", ".join(f"{s}'" for s in self.symbols) + " along extremals"

    def subs(self, values: Mapping) -> "ControlField":
        """Return the same right-hand sides with values for parameters of the problem.

        Parameters
        ----------
        values : dict
            {parameter: number or expression}.

        Returns
        -------
        ControlField
            With the values substituted in the problem and in the factor.
        """
        return ControlField(self.problem.subs(values), self.symbols, self.factor.subs(values))

    @cached_property
    def _sides(self):
        sides = dict(self.problem.dynamics) | control_field(self.problem)
        return [
            sp.simplify(self.factor * sides[s]) if self.factor != 1 else sides[s]
            for s in self.symbols
        ]


def control_field(problem: Statement) -> dict[sp.Symbol, sp.Expr]:
    """Return {control: u', state: ...} for the control and the states that enter its equation."""
    if len(problem.control) != 1:
        raise ValueError("problem: the costates are eliminated for problems with one control")
    if problem.constrained or problem.bounds_depend_on_state:
        raise ValueError("problem: the costates are eliminated for problems without inequalities")
    (u,), sign = problem.control, -1 if problem.maximise else 1
    costates = sp.symbols(f"psi:{len(problem.state)}", cls=sp.Dummy, real=True)
    H = sum(psi * f for psi, f in zip(costates, problem.field)) - sign * problem.running
    slope = sp.diff(H, u)
    drift = sum(
        sp.diff(slope, y) * f - sp.diff(slope, psi) * sp.diff(H, y)
        for y, f, psi in zip(problem.state, problem.field, costates)
    )
    from_end = _costates_from_end(problem, costates, sign)
    slope, drift, curvature = (
        sp.expand(e.subs(from_end)) for e in (slope, drift, sp.diff(slope, u))
    )
    free = [psi for psi in costates if any(e.has(psi) for e in (slope, drift, curvature))]
    constant_part, gains = slope.subs(dict.fromkeys(free, 0)), [sp.diff(slope, psi) for psi in free]
    if len(free) == 2 and constant_part == 0:
        values = {free[0]: gains[1], free[1]: -gains[0]}
    elif len(free) == 1:
        values = {free[0]: -constant_part / gains[0]}
    elif not free:
        values = {}
    else:
        raise ValueError(
            f"problem: {len(free)} costates are not known from the end of the process, and the "
            "condition H_u = 0 does not eliminate them"
        )
    rate = -sp.simplify(drift.subs(values)) / sp.simplify(curvature.subs(values))
    field = {u: sp.expand(sp.trigsimp(sp.simplify(rate)))}
    entering = {y for y in problem.dynamics if field[u].has(y)}
    while further := {
        y
        for y in problem.dynamics
        if y not in entering and any(problem.dynamics[z].has(y) for z in entering)
    }:
        entering |= further
    return field | {y: f for y, f in problem.dynamics.items() if y in entering}


def _costates_from_end(problem, costates, sign):
    """Return the constant costates, whose values the terminal conditions determine.

    They belong to states that enter neither the equations nor the target, and the final cost
    linearly.
    """
    occurring = set().union(
        *(e.free_symbols for e in (*problem.field, problem.running, *problem.terminal))
    )
    values = {
        psi: -sign * sp.diff(problem.final, y)
        for psi, y in zip(costates, problem.state)
        if y not in occurring
    }
    return {
        psi: value for psi, value in values.items() if not value.free_symbols & set(problem.state)
    }
