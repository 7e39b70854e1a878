"""The fastest or slowest transfer of a system to its target, without the maximum principle.

- one state: the time is the integral of dx/(greatest rate towards the target);
- a system homogeneous of first degree in two states, a line through zero as the target: the
  direction (angle) obeys an equation of its own, and the time is the integral of dtheta/(greatest
  or least rate); the process ends when the line is met for the first time after the start;
- a linear system x' = Ax + bu with two states, the origin as the target: the least time is that of
  `fastest_times`. Whether there is one is decided with time running back: x0 can be brought to the
  origin within T exactly if, for every direction q, q.x0 <= S_T(q) := int_0^T max_u(-q.e^{-As}b u)
  ds.
"""

import functools
import itertools
import math
import operator

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.natural_units import COST, TIME, natural_units
from workbook.checks.references.optima import reach
from workbook.checks.references.optima.direct_problem import statement
from workbook.checks.references.optima.linear_transfers import LinearTransfer
from workbook.checks.references.optima.transfer_systems import (
    HomogeneousTransfer,
    ScalarTransfer,
    TransferOptimum,
)
from workbook.checks.references.optima.units import (
    OptimumInUnits,
    Units,
    constant_of,
    in_units,
    is_time_optimal,
)

#: For how many sets of parameters an answer is tried.
SAMPLES = 10
#: What is so many times as small as the others lies next to zero.
CLOSE = sp.Rational(1, 10**6)


class Unknown(UnsuitableData):
    """Raised for a problem whose optimum is not known in one of these ways."""


class Transfer:
    """The transfers of a `pontryagin.Problem` in least or greatest time, for all parameters.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    parameters : list of sympy.Symbol
        Its parameters; a state that is free at the start and among them is its own initial value.

    Raises
    ------
    Unknown
        For a problem of another kind.
    """

    def __init__(self, problem, parameters=()):
        self.dynamics, self.slowest = problem.dynamics, problem.maximise
        self.parameters = list(parameters)
        self.initial = [
            x if value is None and x in self.parameters else value
            for x, value in problem.initial.items()
        ]
        state = list(problem.dynamics)
        self.terminal = _without_factors(problem)
        bounds = [bound for pair in problem.controls.values() for bound in pair]
        bounded = len(bounds) == 2 and not any(bound.is_infinite for bound in bounds)
        if not is_time_optimal(problem) or not bounded or None in self.initial:
            raise Unknown(
                "problem: expected the least or greatest time of one control with two bounds"
            )
        (self.control,), self.bounds = problem.controls, bounds
        self._in_units(problem)
        self._decided, self._found = _cached_results(statement(problem), tuple(self.parameters))
        scale = sp.Dummy("scale", positive=True)
        if len(state) == 1:
            self._kind = ScalarTransfer
        elif self._linear() and set(self.terminal) == set(state):
            self._kind = LinearTransfer
        elif (
            len(state) == 2
            and len(self.terminal) == 1
            and self.terminal[0].subs(dict.fromkeys(state, 0)) == 0
            and all(
                sp.expand(f.subs({x: scale * x for x in state}, simultaneous=True) - scale * f) == 0
                for f in [*self.dynamics.values(), *self.terminal]
            )
        ):
            self._kind = HomogeneousTransfer
        else:
            raise Unknown("problem: expected a transfer to the origin or to a line, or one state")

    def _in_units(self, problem):
        """State the problem in its natural units, in which optima are computed and samples drawn."""
        sizes = [p for p in self.parameters if not p.is_integer]
        units = natural_units(problem, unknown=[p for p in sizes if p not in self.dynamics])
        self._sizes = [units.get(p, sp.S.One) for p in self.parameters]
        fields = {*problem.state, self.control, TIME}
        scaled = in_units(
            problem, {s: f for s, f in units.items() if s in fields} | {COST: sp.S.One}
        )
        self._scaled = scaled.field, scaled.controls[self.control], _without_factors(scaled)
        self._units = Units(
            float(units[TIME]),
            np.array([float(units[x]) for x in problem.state]),
            float(units[self.control]),
            float(problem.running * units[TIME]),
        )
        self._constant = constant_of(problem)

    def _linear(self):
        symbols = [*self.dynamics, self.control]
        return len(self.dynamics) == 2 and all(
            sp.diff(f, x).free_symbols == set() for f in self.dynamics.values() for x in symbols
        )

    def at(self, values, **options):
        """Return the optimum for given values of the parameters."""

        def substituted(e):
            return e.subs(values, simultaneous=True)

        start = np.array([float(substituted(e)) for e in self.initial]) / self._units.states
        # State symbols that stand for the start are values of parameters, never to be replaced in
        # the dynamics.
        free = {p: v for p, v in values.items() if p not in self.dynamics}
        parts = (tuple(e.subs(free) for e in expressions) for expressions in self._scaled)
        system = _system(self._kind, tuple(self.dynamics), self.control, *parts)
        best = TransferOptimum(system, start, self.slowest, **options)
        return OptimumInUnits(
            best, self._units._replace(constant=float(substituted(self._constant)))
        )

    def samples(self, count=SAMPLES):
        """Return sets of parameters for which the target can be reached, with the optimum.

        They are of several sizes and both signs.
        """
        if not self.parameters:
            return [({}, self.at({}))]
        if count not in self._found:
            self._found[count] = self._sampled(count)
        return self._found[count]

    def _sampled(self, count):
        candidates = _random_values(dict(zip(self.parameters, self._sizes)), 400 * count)
        solvable, samples = filter(self.solvable, candidates), []
        while len(samples) < count:
            candidates = [
                (values, self.at(values))
                for values in itertools.islice(solvable, count - len(samples))
            ]
            if not candidates:
                raise RuntimeError("too few starts from which the target can be reached were met")
            for system in {best.system for _, best in candidates}:
                system.foresee([best.begin for _, best in candidates if best.system is system])
            samples += [
                (values, best)
                for values, best in candidates
                if math.isfinite(best.duration) and best.duration > 0
            ]
        # next to zero too: a smooth function is not the sign of its argument there
        for values, _ in samples[:2] if self._kind is ScalarTransfer else ():
            near = {p: v if p.is_positive or p.is_integer else v * CLOSE for p, v in values.items()}
            if self.solvable(near):
                samples.append((near, self.at(near)))
        return samples

    def solvable(self, values):
        """Return whether the target can be reached; None for a start that lies on it."""
        point = tuple(values.items())
        if point not in self._decided:
            self._decided[point] = self._decide(values)
        return self._decided[point]

    def _decide(self, values):
        start = [
            values[e] if e in values else e.subs(values, simultaneous=True) for e in self.initial
        ]
        # Thousands of starts are asked about: what SymPy need not look at is left out.
        at = dict(zip(self.dynamics, start))
        gaps = ((at[g] if g in at else g.xreplace(at)) for g in self.terminal)
        if all((gap.subs(values) if gap.free_symbols else gap) == 0 for gap in gaps):
            return None
        if self._kind is not LinearTransfer:
            return self.at(values).possible()
        if self._condition is not None:  # the directions below are right for limited times only
            return bool(self._condition.subs(values))
        return self._modes_allow(start) and self._system().holds(
            np.array(start, dtype=float) / self._units.states
        )

    def solvable_condition(self):
        """Return the condition that the target can be reached from a start off it, or None."""
        if self._kind is ScalarTransfer:
            return reach.on_a_line(self.dynamics, self.control, self.bounds, *self._ends())
        matrix, column, constant = reach.linear_parts(self.dynamics, self.control)
        if self._kind is not LinearTransfer or any(constant):
            return None
        return reach.to_origin(matrix, column, self.bounds, self.initial)

    @functools.cached_property
    def _condition(self):
        return self.solvable_condition()

    def off_target(self):
        """Return the condition that the start does not lie on the target."""
        at = dict(zip(self.dynamics, self.initial))
        return sp.Or(*(sp.Ne(gap.subs(at, simultaneous=True), 0) for gap in self.terminal))

    def in_time_condition(self, duration):
        """Return the condition that the target is reached within the duration, or None."""
        return (
            reach.in_time(self.dynamics, self.control, self.bounds, *self._ends(), duration)
            if self._kind is ScalarTransfer
            else None
        )

    def _ends(self):
        """Return the start and the target of a transfer with one state."""
        (x,), (gap,) = self.dynamics, self.terminal
        return self.initial[0], sp.solve(gap, x)[0]

    def solvable_message(self, values):
        """Return the text on whether the target can be reached."""
        return "from there the target " + (
            "can be reached" if self.solvable(values) else "cannot be reached, whatever the control"
        )

    def reach(self, duration):
        """Return distances from zero, in many directions, of the starts with this least time."""
        return self._system().radii(duration / self._units.time, self._units.states)

    def _system(self):
        parts = map(tuple, self._scaled)
        return _system(LinearTransfer, tuple(self.dynamics), self.control, *parts)

    def _modes_allow(self, start):
        """Return, exactly, whether the control can undo the start's part along each growing mode."""
        return all(
            low < -sum(map(operator.mul, left_vector, start)) < high
            for left_vector, low, high in self._modes
        )

    @functools.cached_property
    def _modes(self):
        """Left eigenvectors w of modes that do not decay, with the open interval of -w.x0.

        -w.x0 = int e^{-lambda s} w.b u ds, and the ends would need an infinite time, or one extreme
        control throughout.
        """
        matrix, column, constant = reach.linear_parts(self.dynamics, self.control)
        if any(constant):
            raise RuntimeError("a linear system without a constant part was expected")
        modes = []
        for value, _, vectors in matrix.T.eigenvects():
            for left_vector in vectors if value.is_real and value >= 0 else ():
                pushes = ((left_vector.T * column)[0] * b for b in self.bounds)
                ends = sorted(
                    push / value if value else sp.oo * sp.sign(push) if push else 0
                    for push in pushes
                )
                modes.append((left_vector, *ends))
        return modes


def _without_factors(problem):
    """Return what vanishes on the target, without constant factors."""
    return [
        sp.sympify(gap).as_independent(*problem.state, as_Add=False)[1] for gap in problem.terminal
    ]


@functools.lru_cache(maxsize=64)
def _cached_results(stated, parameters):
    """Return the cached reachability of starts of a transfer, and its samples, for all answers."""
    return {}, {}


def _random_values(sizes, count):
    """Yield values of parameters, given with their sizes."""
    random = np.random.default_rng(51)
    for k in range(count):
        scale = (sp.S.One, sp.Rational(1, 4), sp.Integer(3))[k % 3]
        values = {}
        for p, unit in sizes.items():
            size = unit * (
                sp.Integer(int(random.integers(1, 6)))
                if p.is_integer
                else scale * sp.Rational(int(random.integers(3, 40)), 13)
            )
            values[p] = (
                size if p.is_positive or not (p.is_negative or random.integers(2)) else -size
            )
        yield values


@functools.lru_cache(maxsize=256)
def _system(kind, state, control, field, bounds, terminal):
    return kind(state, control, field, bounds, terminal)
