"""The same problem in other units: y = s Y, u = r U, t = tau t', J = c J' + J_0.

With psi = (c/s) Psi the conditions of the maximum principle keep their form and lambda_0 its value,

    Y' = (tau/s) f,   f_0' = (tau/c) f_0,   phi_0' = (phi_0 - J_0)/c,   H = (c/tau) H',

so that one extremal belongs to both. Units are powers of two, which change no digit, but for angles,
which are in radians, and for a cost that is a multiple of the time, which becomes the time. A
constant in phi_0, and one in f_0 where the duration is given, changes no process and is left out
(J_0).

`natural_units` finds units from the statement alone. In them the terms of all equations are about 1
in size; the logarithms of the units solve linear equations, log(coefficient) + sum of log(units) =
log(unit of the left-hand side), one for each term, in the sense of least squares. The same problem
in other units has the same solution, so that numbers in them do not depend on the user's units.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.arguments import inequalities
from trajlib.pontryagin.problem.statement import Statement

# Units between 1/WIDE and WIDE (as exponents of two) are left at 1: no digit is gained by others.
WIDE = 6
# Exponent of two by which a value may be below what is to be expected; it has no unit of its own if
# it is smaller, since it may be a rounding error, or zero.
SMALL = 14
# Largest exponent of a unit.
LARGEST = 300
# The logarithms of the units of time and cost.
_TIME, _COST = sp.Dummy("time"), sp.Dummy("cost")


@dataclass(frozen=True, eq=False)
class Scaling:
    """A problem in other units.

    Attributes
    ----------
    original : Statement
        The problem in the user's units, without parameters.
    states, controls : tuple of sympy.Rational
        The units s and r.
    time, cost : sympy.Rational
        The units tau and c.
    """

    original: Statement
    states: tuple[sp.Rational, ...]
    controls: tuple[sp.Rational, ...]
    time: sp.Rational
    cost: sp.Rational

    @cached_property
    def constant_cost(self) -> sp.Expr:
        """The part J_0 of the cost that does not depend on the process."""
        return _constant_cost(self.original)

    @cached_property
    def terminal(self) -> tuple[sp.Expr, ...]:
        """The units of the terminal equations, then inequalities: their largest terms."""
        sizes = {y: np.log2(float(s)) for y, s in zip(self.original.state, self.states)}
        equations = (*self.original.terminal, *self.original.end_constraints)
        return tuple(_power_of_two(largest_term(g, sizes)) for g in equations)

    @cached_property
    def path(self) -> tuple[sp.Expr, ...]:
        """The units of the path constraints: their largest terms."""
        sizes = {y: np.log2(float(s)) for y, s in zip(self.original.state, self.states)}
        return tuple(_power_of_two(largest_term(g, sizes)) for g in self.original.constraints)

    @cached_property
    def problem(self) -> Statement:
        """The problem for (Y, U, t', J'), under the same names."""
        problem = self.original
        units = dict(zip((*problem.state, *problem.control), (*self.states, *self.controls)))
        table = {s: unit * s for s, unit in units.items() if unit != 1}
        running, final = _without_constant(problem)
        duration = problem.duration
        if isinstance(duration, tuple):
            duration = tuple(d / self.time for d in duration)
        elif duration is not None:
            duration = duration / self.time
        return replace(
            problem,
            dynamics={
                y: f.xreplace(table) * (self.time / units[y]) for y, f in problem.dynamics.items()
            },
            controls={
                u: tuple(b / units[u] for b in bounds) for u, bounds in problem.controls.items()
            },
            initial={y: None if v is None else v / units[y] for y, v in problem.initial.items()},
            terminal=[g.xreplace(table) / unit for g, unit in zip(problem.terminal, self.terminal)],
            running=running.xreplace(table) * (self.time / self.cost),
            final=final.xreplace(table) / self.cost,
            duration=duration,
            path=inequalities(
                sp.expand(g.xreplace(table) / unit)
                for g, unit in zip(problem.constraints, self.path)
            ),
            terminal_inequalities=inequalities(
                sp.expand(g.xreplace(table) / unit)
                for g, unit in zip(problem.end_constraints, self.terminal[len(problem.terminal) :])
            ),
        )


def natural_units(problem: Statement) -> Scaling | None:
    """Return the problem in units that follow from it; None where the user's are as good.

    `problem`: without parameters. A cost that is a multiple of the time becomes the time.
    """
    return problem.cached("natural units", lambda: _natural_units(problem))


def _natural_units(problem):
    logs = [sizes(problem)[name] for name in (*problem.state, *problem.control, _TIME, _COST)]
    if max(map(abs, logs)) <= WIDE:
        logs = [0.0] * len(logs)
    units = [_power_of_two(value) for value in logs]
    for i, u in enumerate(problem.control, len(problem.state)):
        units[i] = _angle_unit(problem, u) or units[i]
    running, final = _without_constant(problem)
    # The time itself, up to a factor.
    if problem.free_time and final == 0 and running.is_number and running.is_positive:
        units[-1] = running * units[-2]
    if all(unit == 1 for unit in units) and _constant_cost(problem) == 0:
        return None
    n = len(problem.state)
    return Scaling(problem, tuple(units[:n]), tuple(units[n:-2]), units[-2], units[-1])


def _angle_unit(problem, u):
    """Return the unit of an angle that makes its factors in sines and cosines integers, or None."""
    if problem.controls[u] != (-sp.oo, sp.oo):
        return None
    waves = set().union(*(e.atoms(sp.sin, sp.cos) for e in (*problem.field, problem.running)))
    factors = {abs(sp.diff(wave.args[0], u)) for wave in waves} - {sp.Integer(0)}
    if not factors or any(factor.free_symbols for factor in factors):
        return None
    least = min(factors)
    return 1 / least if all((factor / least).is_Integer for factor in factors) else None


def units_of_process(
    problem: Statement,
    states: np.ndarray,
    costates: np.ndarray,
    controls: np.ndarray,
    duration: float,
    multiplier: float = 1.0,
) -> Scaling | None:
    """Return the problem in units in which the values of a process are about 1 in size.

    None where they are so already. Shapes: (n, N), (n, N), (k, N). A state that nearly vanishes has
    a unit by the terms that drive it, since these cancel. The unit of the cost is that of the
    products psi_i y_i and of the terms of lambda_0 J.
    """
    symbols, values = (*problem.state, *problem.control), (*states, *controls)
    natural = sizes(problem)
    logs = {
        symbol: max(_log(np.max(np.abs(row))), natural[symbol] - SMALL)
        for symbol, row in zip(symbols, values)
    }
    time = _log(duration)
    driven = [largest_term(f, logs) + time - SMALL for f in problem.field]
    logs |= {y: max(logs[y], least) for y, least in zip(problem.state, driven)}
    running, final = _without_constant(problem)
    cost = max(
        *(_log(np.max(np.abs(row))) + logs[y] for y, row in zip(problem.state, costates)),
        _log(multiplier) + largest_term(running, logs) + time,
        _log(multiplier) + largest_term(final, logs),
        _log(multiplier) + natural[_COST] - SMALL,
    )
    units = [*(logs[symbol] for symbol in symbols), time, cost]
    if max(abs(unit) for unit in units if np.isfinite(unit)) <= WIDE:
        return None
    n, rounded = len(problem.state), [_power_of_two(unit) for unit in units]
    return Scaling(problem, tuple(rounded[:n]), tuple(rounded[n:-2]), rounded[-2], rounded[-1])


def largest_term(e: sp.Expr, logs: dict) -> float:
    """Return log2 of the size of the largest term, for log2 of the sizes of the symbols."""
    if e.is_Symbol:
        return logs[e]
    if e.is_number:
        return _log(e)
    if e.is_Add:
        return max(largest_term(term, logs) for term in e.args)
    if e.is_Mul:
        return sum(largest_term(factor, logs) for factor in e.args)
    if e.is_Pow and e.exp.is_number:
        base = largest_term(e.base, logs)
        return float(e.exp) * base if np.isfinite(base) or e.exp > 0 else 0.0
    return largest_term(e.args[0], logs) if isinstance(e, sp.Abs) else 0.0


def sizes(problem: Statement) -> dict:
    """Return {symbol: log2 of its size} for all symbols, the time and the cost."""
    return problem.cached("sizes", lambda: _Equations(problem).solution())


class _Equations:
    """The equations for log2 of all sizes, (constant, {symbol: factor}), each the size of one term.

    Auxiliary symbols are the sizes of sums inside of functions and of terminal equations.
    """

    def __init__(self, problem):
        self.equations = []
        for y, f in problem.dynamics.items():
            self._terms(f, {y: 1.0, _TIME: -1.0})
            value = problem.initial[y]
            if value is not None and value != 0:
                self._equation((_log(value), {}), {y: 1.0})
        for u, bounds in problem.controls.items():
            for bound in bounds:
                if bound.is_finite and bound != 0:
                    self._equation((_log(bound), {}), {u: 1.0})
        for g in (*problem.terminal, *problem.end_constraints):
            self._terms(g, {sp.Dummy("terminal"): 1.0})
        for g in problem.constraints:
            self._terms(g, {sp.Dummy("path"): 1.0})
        running, final = _without_constant(problem)
        self._terms(running, {_COST: 1.0, _TIME: -1.0})
        self._terms(final, {_COST: 1.0})
        if not problem.free_time:
            self._equation((_log(problem.duration), {}), {_TIME: 1.0})
        self.names = [*problem.state, *problem.control, _TIME, _COST]

    def solution(self):
        """Return the least-squares solution without the terms that are far smaller than others."""
        equations = list(self.equations)
        while True:
            auxiliary = {s for _, row in equations for s in row} - set(self.names)
            names = [*self.names, *sorted(auxiliary, key=lambda s: s.dummy_index)]
            matrix = np.array([[row.get(s, 0.0) for s in names] for _, row in equations])
            constants = np.array([constant for constant, _ in equations])
            logs = np.linalg.lstsq(matrix, -constants, rcond=1e-9)[0]
            excess = matrix @ logs + constants
            smallest = int(np.argmin(excess))
            if excess[smallest] > -SMALL:
                return dict(zip(names, logs))
            del equations[smallest]

    def _equation(self, size, unit):
        """Append the equation that a size is that of the unit, both as sums of logarithms."""
        constant, row = size
        row = dict(row)
        for symbol, factor in unit.items():
            row[symbol] = row.get(symbol, 0.0) - factor
        self.equations.append((constant, row))

    def _terms(self, e, unit):
        for term in sp.Add.make_args(e):
            if term != 0:
                self._equation(self._size(term), unit)

    def _size(self, e):
        """Return (constant, {symbol: factor}) of the logarithm of the size of an expression."""
        if e.is_Symbol:
            return 0.0, {e: 1.0}
        if e.is_number:
            return _log(e), {}
        if e.is_Mul or isinstance(e, sp.Abs):
            constant, row = 0.0, {}
            for part, factors in map(self._size, e.args):
                constant += part
                for symbol, factor in factors.items():
                    row[symbol] = row.get(symbol, 0.0) + factor
            return constant, row
        if e.is_Pow and e.exp.is_number:
            constant, row = self._size(e.base)
            return float(e.exp) * constant, {s: float(e.exp) * f for s, f in row.items()}
        if e.is_Add:
            total = sp.Dummy("sum")
            self._terms(e, {total: 1.0})
            return 0.0, {total: 1.0}
        # The argument of a function such as sin is a number without a unit.
        for argument in e.args:
            self._terms(argument, {})
        return 0.0, {}


def _constant_cost(problem):
    """Return the part of the cost that is the same for all processes."""
    constant = problem.final.as_independent(*problem.state, as_Add=True)[0]
    if not problem.free_time and problem.final is not None:
        symbols = (*problem.state, *problem.control)
        density = problem.running.as_independent(*symbols, as_Add=True)[0]
        constant += problem.duration * density
    return constant


def _without_constant(problem):
    """Return f_0 and phi_0 without the terms that are the same for all processes."""
    symbols = (*problem.state, *problem.control)
    final = problem.final.as_independent(*symbols, as_Add=True)[1]
    if problem.free_time:
        return problem.running, final
    return problem.running.as_independent(*symbols, as_Add=True)[1], final


def _log(value):
    size = abs(float(value))
    return float(np.log2(size)) if size > 0 else -np.inf


def _power_of_two(log):
    return sp.Integer(2) ** round(float(np.clip(log, -LARGEST, LARGEST)))
