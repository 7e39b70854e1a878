"""Fastest transfers to a target that have a formula, since one coordinate decides.

Its rate depends on the coordinate and the control alone: it is the only state, or the angle of a
state in the plane, where the system is homogeneous of first degree. The fastest transfer gives it the
greatest rate towards the target, so that the time is an integral over the coordinate, for any number
of meetings with the target and next to zero too; `direct_optimum` has no such transfers.
"""

import functools
import itertools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.direct_problem import DirectProblem
from workbook.checks.references.optima.optimum import FastestTransfer
from workbook.checks.references.optima.runge_kutta import rk4

#: At so many instants a process is sampled, and steps of the integration between two of them.
INSTANTS, STEPS = 37, 12


class TransferSystem:
    """A system with numbers for its parameters."""

    def __init__(self, state, control, field, bounds, terminal):
        self.bounds = tuple(map(float, bounds))
        dynamics, initial = tuple(zip(state, field)), tuple((x, None) for x in state)
        least_time = sp.S.One, sp.S.Zero, None, False, False
        self.problem = DirectProblem(
            (dynamics, ((control, bounds),), initial, tuple(terminal), *least_time), ()
        )

    def foresee(self, starts):
        """Find the optima from many starts at once, where that is quicker than one by one."""

    def breaks(self, start, duration):
        """Return the times at which the control switches, where it does so at known ones."""
        return []


class CoordinateTransfer(TransferSystem):
    """A system with a coordinate whose rate depends on it and the control alone."""

    def duration(self, start, slowest, meetings):
        from scipy.integrate import quad

        begin, way = self._way(start, meetings)
        if not way:
            return 0.0
        if not self.possible(start):
            return math.inf
        sense, extreme = math.copysign(1, way), min if slowest else max
        return quad(
            lambda a: 1 / extreme(sense * rate for rate in self._rates(begin + sense * a)),
            0,
            abs(way),
            epsabs=0,
            epsrel=1e-11,
            limit=400,
        )[0]

    def law(self, y, t, start, duration, slowest):
        rates = self._rates(self._coordinate(y))
        speeds = math.copysign(1, self._way(start)[1]) * np.array(rates)
        return self.bounds[(np.argmin if slowest else np.argmax)(speeds)]

    def _velocity(self, y, u):
        return np.array(self.problem.rates(*y, u)[:-1], dtype=float)


class ScalarTransfer(CoordinateTransfer):
    """One state, which is the coordinate."""

    def _coordinate(self, y):
        return y[0]

    def _rates(self, x):
        return [self._velocity([x], u)[0] for u in self.bounds]

    def _way(self, start, meetings=1):
        """Return the coordinate at the start, and its change on the way to the target."""
        (gap,), slope = self.problem.gap(0.0), self._slope
        return float(start[0]), -gap / slope - float(start[0])

    @functools.cached_property
    def _slope(self):
        return float(self.problem.jacobians(0.0, 0.0)[2][0][0])

    def possible(self, start):
        begin, way = self._way(start)
        return all(
            max(np.sign(way) * np.array(self._rates(x))) > 0
            for x in np.linspace(begin, begin + way, 100)
        )

    def duration(self, start, slowest, meetings):
        if slowest or meetings != 1:
            raise RuntimeError("with one state only the fastest transfer is known")
        return super().duration(start, slowest, meetings)

    def switchings(self, start, duration):
        return 0

    def time_message(self, start, claimed, true):
        return "moving towards the target as fast as the bounds allow, the state " + directed(
            "has not arrived by then" if claimed < true else "arrives earlier",
            "does not arrive just then",
        )


class HomogeneousTransfer(CoordinateTransfer):
    """Two states, homogeneous of degree one: the angle theta is the coordinate."""

    def _coordinate(self, y):
        return math.atan2(y[1], y[0])

    def _rates(self, theta):
        c, s = math.cos(theta), math.sin(theta)
        return [c * f[1] - s * f[0] for f in (self._velocity((c, s), u) for u in self.bounds)]

    @functools.cached_property
    def _sense(self):
        """The sense in which the direction turns, the same for all controls."""
        rates = [r for theta in np.linspace(0, math.pi, 181) for r in self._rates(theta)]
        if min(rates) < 1e-9 < max(rates) or max(map(abs, rates)) < 1e-9:
            raise RuntimeError("the direction does not turn in one sense for all controls")
        return math.copysign(1, rates[0])

    @functools.cached_property
    def _normal(self):
        return np.array(self.problem.jacobians(1.0, 1.0, 0.0)[2][0], dtype=float)

    def _way(self, start, meetings=1):
        """Return the angle of the start, and its change until a meeting with the target."""
        line, theta = math.atan2(self._normal[0], -self._normal[1]), self._coordinate(start)
        first = (self._sense * (line - theta)) % math.pi
        if first < 1e-12 or first > math.pi - 1e-12:
            first = math.pi
        return theta, self._sense * (first + math.pi * (meetings - 1))

    def possible(self, start):
        return True

    def switching_function(self, start, duration, slowest, steps=240):
        def law(y):
            return self.law(y, 0, start, duration, slowest)

        def field(_, y):
            return self._velocity(y, law(y))

        def extended(_, z):
            y, psi = z[:2], z[2:]
            slopes = np.array(self.problem.jacobians(*y, law(y))[0][:-1])
            return np.concatenate([field(_, y), -psi @ slopes])

        h, y = duration / steps, np.array(start, dtype=float)
        for _ in range(steps):
            y = rk4(field, 0, y, h)
        # At the end psi is normal to the target, and psi.f = 1 (-1 for the slowest) gives its
        # length.
        psi = self._normal * (-1 if slowest else 1) / (self._normal @ field(0, y))
        z, (low, high), samples = np.append(y, psi), self.bounds, []
        for k in range(steps, 0, -1):
            effect = self._velocity(z[:2], high) - self._velocity(z[:2], low)
            samples.append((k * h, float(z[2:] @ effect) / (high - low)))
            z = rk4(extended, 0, z, -h)
        return samples

    def time_message(self, start, claimed, true):
        if not 0 < claimed < 100 * true:
            return (
                "the process ends at a positive time"
                if claimed <= 0
                else "by then every admissible control has met the target long before"
            )
        return (
            "the vector (x, x') has not turned by the angle between the initial state and the target "
            "at that time"
        )


class TransferOptimum(FastestTransfer):
    """The fastest or slowest transfer from a start."""

    def __init__(self, system, start, slowest, meetings=1):
        self.system, self.begin, self.slowest, self.meetings = system, start, slowest, meetings
        self.start, self.bounds = np.append(start, 0.0), system.bounds
        self._problem, self._case = system.problem, ()

    @functools.cached_property
    def duration(self):
        return self.system.duration(self.begin, self.slowest, self.meetings)

    @property
    def cost(self):
        return self.duration

    def cost_size(self):
        return self.duration

    def possible(self):
        """Return whether the target can be reached at all."""
        return self.system.possible(self.begin)

    def size(self):
        """Return the size of the states of this transfer."""
        return float(np.linalg.norm(self.begin) + np.linalg.norm(self.gap(self.start))) or 1.0

    def duration_message(self, duration):
        return self.system.time_message(self.begin, duration, self.duration)

    def breaks(self):
        """Return the times at which the control switches."""
        return self.system.breaks(self.begin, self.duration)

    def switchings(self):
        """Return how often the control switches."""
        return self.system.switchings(self.begin, self.duration)

    def switching_function(self):
        """Return pairs (time, dH/du), the costate being followed back from the end."""
        return self.system.switching_function(self.begin, self.duration, self.slowest)

    def _law(self, y, t):
        return self.system.law(y, t, self.begin, self.duration, self.slowest)

    @functools.cached_property
    def _path(self):
        """Times, states and controls along the optimum, at instants away from the switchings."""
        times = self.duration * (np.arange(INSTANTS) + 0.37) / INSTANTS
        states, controls, y, begin = [], [], np.array(self.begin, dtype=float), 0.0
        for end in times:
            breaks = [t for t in self.breaks() if begin < t < end]
            for left, right in itertools.pairwise([begin, *breaks, end]):
                h = (right - left) / STEPS
                for k in range(STEPS):
                    t = left + (k + 0.5) * h
                    y = rk4(
                        lambda _, z, t=t: self.field(np.append(z, 0), self._law(z, t))[:-1], t, y, h
                    )
            states.append(y)
            controls.append(self._law(y, end))
            begin = end
        return times, np.array(states).T, controls

    times = property(lambda self: self._path[0])
    states = property(lambda self: self._path[1])
    controls = property(lambda self: self._path[2])
