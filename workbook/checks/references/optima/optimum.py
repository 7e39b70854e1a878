"""What a check asks of an optimal process, whichever search has found it."""

import itertools

import numpy as np

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.direct_programme import FINE
from workbook.checks.references.optima.radau import integrals
from workbook.checks.references.optima.units import Units

#: Which part of the duration an arc has to take to be one.
SHORT = 1e-4
#: Terms of a cost that are smaller than this count as so large: a least cost may be zero.
SMALLEST = 1e-3


class Optimum:
    """An optimal process.

    It has `cost`, `duration`, `times` after the start with `states` (n rows) and `controls` there, and
    `arcs`: triples (value, begin, end), the value being None where the control is not constant. The
    last entry of `start` and of `field(y, u)` belongs to the integral of the running cost.
    """

    #: To what share the cost is known next to parameters for which an arc vanishes: a short one may
    #: be missed.
    MISSED, units = 5e-4, Units()

    def __init__(self, problem, case, cost, times, states, controls, arcs):
        self.cost, self.duration, self.controls, self.arcs = cost, times[-1], controls, arcs
        self.times, self.states, self.start = times[1:], states[:, 1:], np.append(states[:, 0], 0.0)
        self.bounds = problem.bounds(case)
        self._problem, self._case = problem, case

    def changes(self):
        """Return where arcs follow one another: (index of time, value before, value after).

        A value is None for a control that is not constant.
        """
        long = [arc for arc in self.arcs if arc[2] - arc[1] > SHORT * self.duration]
        return [
            (
                int(np.argmin(abs(self.times - (previous[2] + following[1]) / 2))),
                previous[0],
                following[0],
            )
            for previous, following in itertools.pairwise(long)
            if previous[0] is None or previous[0] != following[0]
        ]

    def remaining_costs(self):
        """Return states away from changes and the last arc, and the remaining cost there."""
        degree = FINE[1]
        rates = np.array(
            [self.field(np.append(y, 0), u)[-1] for y, u in zip(self.states.T, self.controls)]
        )
        steps = np.diff(np.append(0, self.times[degree - 1 :: degree]))
        parts = (
            np.einsum("ij,kj->ki", integrals(degree), rates.reshape(-1, degree)) * steps[:, None]
        )
        accumulated_cost = (parts + np.append(0, np.cumsum(parts[:, -1])[:-1])[:, None]).ravel()
        borders = [self.times[j] for j, *_ in self.changes()]
        keep = self.times < max(borders, default=0)
        for border in borders:
            keep &= abs(self.times - border) > 1e-3 * self.duration
        return self.states[:, keep], (self.cost - accumulated_cost)[keep]

    def jacobians(self, y, u):
        """Return derivatives in the states: of `field`, (n + 1) x n, of the final cost, of the gap."""
        return [
            np.array(matrix, dtype=float) for matrix in self._problem.jacobians(*y, u, *self._case)
        ]

    def field(self, y, u):
        """Return the rates of the states and of the cost."""
        return np.array(self._problem.rates(*y[:-1], u, *self._case), dtype=float)

    def gap(self, y):
        """Return what vanishes at the end."""
        return np.array(self._problem.gap(*y[:-1], *self._case), dtype=float)

    def total(self, y):
        """Return the cost of a process that ends in y."""
        return float(y[-1] + self._problem.final(*y[:-1], *self._case))

    def duration_message(self, duration):
        """Return the text on a wrong duration."""
        return "the best process found " + directed(
            "ends earlier" if duration > self.duration else "ends later", "does not end then"
        )

    def size(self):
        """Return the size of the states."""
        return float(max(1e-9, np.abs(self.states).max()))

    def cost_size(self):
        """Return the size of the terms of the cost, which may cancel."""
        ends = [
            abs(self._problem.final(*y, *self._case))
            for y in (self.states[:, 0], self.states[:, -1])
        ]
        rates = [self.field(np.append(y, 0), u)[-1] for y, u in zip(self.states.T, self.controls)]
        return float(max(SMALLEST, abs(self.cost), *ends, np.abs(rates).mean() * self.duration))


class FastestTransfer(Optimum):
    """A fastest transfer that a formula gives, to all digits."""

    MISSED, arcs = 0.0, ()

    def remaining_costs(self):
        """Return states on the way, and the remaining time there."""
        return self.states, self.duration - self.times
