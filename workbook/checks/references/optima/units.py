"""Units in which a problem of optimal control is solved, and its optimum in the student's units.

A search has tolerances and initial guesses for numbers of size one. The units are those in which
the coefficients, bounds, ends and initial values of the statement are nearest to one: their
logarithms solve linear equations in the sense of least squares, so that a problem stated in other
units is solved as the same numbers. Units near one are one, and most problems are solved as they are
stated. A constant in the cost is left out.
"""

import dataclasses
import functools
from typing import NamedTuple

import numpy as np
import sympy as sp

from workbook.checks.references.natural_units import COST, TIME, Sizes, natural_units


class Units(NamedTuple):
    """Units of times, of the states, of the controls and of costs, and what is added to the cost."""

    time: float = 1.0
    states: np.ndarray | float = 1.0
    control: np.ndarray | float = 1.0
    cost: float = 1.0
    constant: float = 0.0


def in_scaled_units(search):
    """Decorate `search(problem, parameters, ...)` so that it gets the problem in scaled units."""

    @functools.wraps(search)
    def searched(problem, parameters=None, *options):
        table = tuple(parameters.items()) if isinstance(parameters, dict) else ()
        named = any(x in (parameters or ()) for x in problem.state)
        scaled, units, constant = scaled_problem(problem, table, named)
        solutions = search(scaled, parameters, *options)
        if scaled is problem:
            return solutions
        return [
            (values, OptimumInUnits(best, units._replace(constant=float(constant.subs(values)))))
            for values, best in solutions
        ]

    return searched


def is_time_optimal(problem):
    """Return whether a cost is the duration, in any units and with any constant."""
    return bool(
        problem.duration is None
        and problem.running.is_number
        and problem.running > 0
        and not problem.final.free_symbols & set(problem.state)
    )


def constant_of(problem):
    """Return the part of a cost that is the same for all processes, an expression in parameters."""
    fixed = None if isinstance(problem.duration, tuple) else problem.duration
    running = 0 if fixed is None else fixed * _constant(problem.running, problem)
    return _constant(problem.final, problem) + running


@functools.lru_cache(maxsize=64)
def without_constant(problem):
    """Return a problem without the part of its cost that is the same for all processes."""
    if constant_of(problem) == 0:
        return problem
    fixed = problem.duration is not None and not isinstance(problem.duration, tuple)
    return dataclasses.replace(
        problem,
        running=problem.running - (_constant(problem.running, problem) if fixed else 0),
        final=problem.final - _constant(problem.final, problem),
    )


def _constant(expression, problem):
    return sp.sympify(expression).as_independent(*problem.state, *problem.control, as_Add=True)[0]


@functools.lru_cache(maxsize=64)
def scaled_problem(problem, parameters, only_cost=False):
    """Return a problem in scaled units, without a constant in its cost, these units, and the constant.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem, which is returned itself where nothing changes.
    parameters : tuple
        Pairs of a parameter and its domain.
    only_cost : bool
        Whether the units of the states are to be kept, whose symbols stand for initial values, too.
    """
    bare, constant = without_constant(problem), constant_of(problem)
    factors = _factors(bare, dict(parameters), only_cost)
    if all(factor == 1 for factor in factors.values()):
        terminal = [normalised_gap(gap, problem.state, parameters) for gap in problem.terminal]
        if terminal != list(problem.terminal):
            bare = dataclasses.replace(bare, terminal=terminal)
        return bare, Units(), constant
    scaled = in_units(bare, factors)
    gaps = [normalised_gap(gap, problem.state, parameters) for gap in scaled.terminal]
    several = [float(factors[u]) for u in problem.control]
    return (
        dataclasses.replace(scaled, terminal=gaps),
        Units(
            float(factors[TIME]),
            np.array([float(factors[x]) for x in problem.state]),
            np.array(several) if len(several) > 1 else several[0],
            float(factors[COST]),
        ),
        constant,
    )


def in_units(problem, units):
    """Return a problem in other units, given by symbol, with `TIME` and `COST` among them."""
    replacements = {s: s * f for s, f in units.items() if f != 1 and s not in (TIME, COST)}

    def value(expression, factor=1):
        expression = sp.sympify(expression)
        if replacements:
            expression = expression.subs(replacements, simultaneous=True)
        return expression / factor

    time, cost = units[TIME], units[COST]
    ends = tuple(None if end is None else end / time for end in _ends(problem))
    return dataclasses.replace(
        problem,
        dynamics={x: value(f, units[x] / time) for x, f in problem.dynamics.items()},
        controls={
            u: tuple(bound / units[u] for bound in bounds) for u, bounds in problem.controls.items()
        },
        initial={x: None if v is None else v / units[x] for x, v in problem.initial.items()},
        terminal=[value(gap) for gap in problem.terminal],
        running=value(problem.running, cost / time),
        final=value(problem.final, cost),
        duration=ends if isinstance(problem.duration, tuple) else ends[0],
    )


def sample_units(problem, costates=(), domain=None):
    """Return the units of states, controls, time, cost and costates in which conditions are tried.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    costates : list of sympy.Symbol
        The costates, in the order of the states.
    domain : dict, optional
        Intervals of symbols, those of parameters among them.
    """
    parameters = {p: domain[p] for p in problem.parameters if p in (domain or {})}
    units = _factors(without_constant(problem), parameters, False)
    return units | {psi: units[COST] / units[x] for psi, x in zip(costates, problem.state)}


def _factors(problem, parameters, only_cost):
    """Return the units as exact numbers, by symbol."""
    symbols = [*problem.state, *problem.control, TIME, COST]
    factors = dict.fromkeys(symbols, sp.S.One) if only_cost else natural_units(problem, parameters)
    if is_time_optimal(problem):
        factors[COST] = problem.running * factors[TIME]
    return factors


def normalised_gap(gap, state, parameters):
    """Return what vanishes on the target times a power of ten, so that states have factors of size one.

    Then a tolerance of the states is one of it.
    """
    sizes = Sizes(None, dict(parameters))
    logs = [
        log
        for part in sp.Add.make_args(sp.expand(gap))
        if part.free_symbols & set(state)
        for log, _ in sizes.terms(part)
    ]
    return gap / sp.Integer(10) ** round(max(logs)) if logs else gap


def _ends(problem):
    return problem.duration if isinstance(problem.duration, tuple) else (problem.duration,)


def _in_units_of(name, unit):
    """Return a property of an optimum: a number or an array, times its unit."""
    return property(lambda self: np.asarray(getattr(self._best, name)) * unit(self))


class OptimumInUnits:
    """An optimum that was found in scaled units, in those of the statement.

    What a target makes vanish, `gap`, and its `size` stay in scaled units. The constant of the cost is
    in none of its numbers; `units` has it.
    """

    def __init__(self, best, units):
        self._best, self.units = best, units

    def __getattr__(self, name):
        return getattr(self._best, name)

    def _scaled_state(self, y):
        return np.append(np.asarray(y[:-1]) / self.units.states, y[-1] / self.units.cost)

    @property
    def _sizes(self):
        """The units of the states and of the cost."""
        return np.append(np.ones(len(self._best.start) - 1) * self.units.states, self.units.cost)

    duration = _in_units_of("duration", lambda self: self.units.time)
    cost = _in_units_of("cost", lambda self: self.units.cost)
    times = _in_units_of("times", lambda self: self.units.time)
    controls = _in_units_of("controls", lambda self: self.units.control)
    start = _in_units_of("start", lambda self: self._sizes)

    @property
    def states(self):
        return (np.asarray(self._best.states).T * self.units.states).T

    @property
    def bounds(self):
        return tuple(bound * self.units.control for bound in self._best.bounds)

    @property
    def arcs(self):
        return [
            (None if u is None else u * self.units.control, *(t * self.units.time for t in ends))
            for u, *ends in self._best.arcs
        ]

    def breaks(self):
        """Return the times at which the control of a fastest transfer switches."""
        return [t * self.units.time for t in self._best.breaks()]

    def changes(self):
        """Return where arcs follow one another, as `optimum.Optimum.changes` does."""
        return [
            (k, *(None if u is None else u * self.units.control for u in kinds))
            for k, *kinds in self._best.changes()
        ]

    def remaining_costs(self):
        """Return states on the way, and the remaining cost there."""
        states, cost = self._best.remaining_costs()
        return (np.asarray(states).T * self.units.states).T, cost * self.units.cost

    def field(self, y, u):
        """Return the rates of the states and of the cost."""
        rates = self._best.field(self._scaled_state(y), u / self.units.control)
        return rates * self._sizes / self.units.time

    def gap(self, y):
        """Return what vanishes at the end, in scaled units."""
        return self._best.gap(self._scaled_state(y))

    def total(self, y):
        """Return the cost of a process that ends in y, without its constant."""
        return self._best.total(self._scaled_state(y)) * self.units.cost

    def jacobians(self, y, u):
        """Return derivatives in the states, as `optimum.Optimum.jacobians` does."""
        states, sizes = self._sizes[:-1], self._sizes
        field, final, gap = self._best.jacobians(np.asarray(y) / states, u / self.units.control)
        return (
            field * sizes[:, None] / states / self.units.time,
            final * self.units.cost / states,
            gap / states if len(gap) else gap,
        )

    def cost_size(self):
        """Return the size of the terms of the cost, without its constant."""
        return self._best.cost_size() * self.units.cost

    def duration_message(self, duration):
        """Return the text on a wrong duration."""
        return self._best.duration_message(duration / self.units.time)

    def switching_function(self):
        """Return pairs (time, dH/du), the costate being followed back from the end."""
        unit = self.units.cost / self.units.time / self.units.control
        return [(t * self.units.time, value * unit) for t, value in self._best.switching_function()]
