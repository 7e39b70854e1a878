"""Systems whose fastest transfer to a target has a formula: one state, and homogeneous ones."""

import functools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.runge_kutta import rk4
from workbook.checks.references.optima.units import Units


class TransferSystem:
    """A system with numbers for its parameters."""

    def __init__(self, state, control, field, bounds, terminal):
        self.bounds = tuple(map(float, bounds))
        symbols = [*state, control]
        self._field = sp.lambdify(symbols, field, "math")
        self._jacobian = sp.lambdify(
            symbols, sp.Matrix(field).jacobian(list(state)).tolist(), "math"
        )
        self._gap = sp.lambdify(list(state), terminal, "math")
        self._normals = np.array(sp.Matrix(terminal).jacobian(list(state)), dtype=float)

    def field(self, y, u):
        return np.array(self._field(*y, u), dtype=float)

    def jacobian(self, y, u):
        return np.array(self._jacobian(*y, u), dtype=float)

    def gap(self, y):
        """Return what vanishes on the target."""
        return np.array(self._gap(*y), dtype=float)

    def normals(self):
        return self._normals

    def foresee(self, starts):
        """Find the optima from many starts at once, where that is quicker than one by one."""

    def path(self, start, duration, slowest, count):
        times = duration * (np.arange(count) + 0.37) / count
        states, controls, y, t = [], [], np.array(start, dtype=float), 0.0
        for target in times:
            y = self._advance(y, t, target, start, duration, slowest)
            t = target
            states.append(y)
            controls.append(self.law(y, t, start, duration, slowest))
        return times, states, controls

    def _advance(self, y, begin, end, start, duration, slowest, steps=12):
        breaks = [t for t in self.breaks(start, duration) if begin < t < end]
        for left, right in zip([begin, *breaks], [*breaks, end]):
            h = (right - left) / steps
            for k in range(steps):
                middle = left + (k + 0.5) * h
                y = rk4(
                    lambda s, z: self.field(z, self.law(z, middle, start, duration, slowest)),
                    left + k * h,
                    y,
                    h,
                )
        return y

    def breaks(self, start, duration):
        return []


class ScalarTransfer(TransferSystem):
    """One state: everything depends on the rate towards the target."""

    def _target(self):
        slope, gap_at_zero = self._normals[0, 0], self.gap([0.0])[0]
        return -gap_at_zero / slope

    def _rate(self, x, direction):
        return max(direction * self.field([x], u)[0] for u in self.bounds)

    def possible(self, start):
        begin, end = float(start[0]), self._target()
        direction = np.sign(end - begin)
        return all(self._rate(x, direction) > 0 for x in np.linspace(begin, end, 100))

    def duration(self, start, slowest, meetings):
        from scipy.integrate import quad

        if slowest or meetings != 1:
            raise RuntimeError("with one state only the fastest transfer is known")
        begin, end = float(start[0]), self._target()
        direction = np.sign(end - begin)
        if direction == 0:
            return 0.0
        if not self.possible(start):
            return math.inf
        return quad(
            lambda x: 1 / self._rate(x, direction),
            *sorted((begin, end)),
            epsabs=0,
            epsrel=1e-11,
            limit=200,
        )[0]

    def law(self, y, t, start, duration, slowest):
        direction = np.sign(self._target() - float(start[0]))
        return max(self.bounds, key=lambda u: direction * self.field(y, u)[0])

    def time_message(self, start, claimed, true):
        return "moving towards the target as fast as the bounds allow, the state " + directed(
            "has not arrived by then" if claimed < true else "arrives earlier",
            "does not arrive just then",
        )

    def switchings(self, start, duration):
        return 0


class HomogeneousTransfer(TransferSystem):
    """Two states, homogeneous of degree one: the angle theta obeys an equation of its own."""

    def possible(self, start):
        return True

    def _rates(self, theta):
        c, s = math.cos(theta), math.sin(theta)
        return [c * f[1] - s * f[0] for f in (self.field((c, s), u) for u in self.bounds)]

    @functools.cached_property
    def _sense(self):
        """The sense in which the direction turns, the same for all controls."""
        rates = [r for theta in np.linspace(0, math.pi, 181) for r in self._rates(theta)]
        if min(rates) < 1e-9 < max(rates) or max(map(abs, rates)) < 1e-9:
            raise RuntimeError("the direction does not turn in one sense for all controls")
        return math.copysign(1, rates[0])

    def _angle(self, start, meetings):
        """Return the angle from the start to the meeting with the target, in the sense of turning."""
        normal = self._normals[0]
        line = math.atan2(normal[0], -normal[1])
        theta = math.atan2(start[1], start[0])
        first = (self._sense * (line - theta)) % math.pi
        return (math.pi if first < 1e-12 or first > math.pi - 1e-12 else first) + math.pi * (
            meetings - 1
        )

    def _speed(self, theta, slowest):
        return (min if slowest else max)(map(abs, self._rates(theta)))

    def duration(self, start, slowest, meetings):
        from scipy.integrate import quad

        theta, sense = math.atan2(start[1], start[0]), self._sense
        angle = self._angle(start, meetings)
        return quad(
            lambda a: 1 / self._speed(theta + sense * a, slowest),
            0,
            angle,
            epsabs=0,
            epsrel=1e-11,
            limit=400,
        )[0]

    def law(self, y, t, start, duration, slowest):
        rates = [abs(r) for r in self._rates(math.atan2(y[1], y[0]))]
        return self.bounds[(np.argmin if slowest else np.argmax)(rates)]

    def switching_function(self, start, duration, slowest, steps=240):
        h, y, states = (
            duration / steps,
            np.array(start, dtype=float),
            [np.array(start, dtype=float)],
        )
        for k in range(steps):
            y = rk4(
                lambda t, z: self.field(z, self.law(z, t, start, duration, slowest)), k * h, y, h
            )
            states.append(y)
        # At the end psi is normal to the target, and psi.f = 1 (-1 for the slowest) gives its
        # length.
        u = self.law(y, duration, start, duration, slowest)
        normal = self._normals[0]
        psi = normal * (-1 if slowest else 1) / (normal @ self.field(y, u))
        samples = []
        for k in range(steps, 0, -2):
            first, middle, last = states[k], states[k - 1], states[k - 2]
            slopes = [
                self.jacobian(z, self.law(z, 0, start, duration, slowest)).T
                for z in (first, middle, last)
            ]
            samples.append(
                (
                    k * h,
                    float(
                        psi
                        @ (self.field(first, self.bounds[1]) - self.field(first, self.bounds[0]))
                    )
                    / (self.bounds[1] - self.bounds[0]),
                )
            )
            a = slopes[0] @ psi
            b = slopes[1] @ (psi + h * a)
            c = slopes[1] @ (psi + h * b)
            d = slopes[2] @ (psi + 2 * h * c)
            psi = psi + h / 3 * (a + 2 * b + 2 * c + d)
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


class TransferOptimum:
    """The fastest or slowest transfer from a start, like a `direct_optimum.Optimum`.

    The last entry of `start` and `field` is the time that has passed.
    """

    units = Units()

    def __init__(self, system, start, slowest, meetings=1):
        self.system, self.begin, self.slowest, self.meetings = system, start, slowest, meetings
        self.start, self.bounds = np.append(start, 0.0), system.bounds

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
        return (
            float(np.linalg.norm(self.begin) + np.linalg.norm(self.system.gap(self.begin))) or 1.0
        )

    def remaining_costs(self):
        """Return states on the way, and the remaining time there."""
        return self.states, self.duration - self.times

    def duration_message(self, duration):
        return self.system.time_message(self.begin, duration, self.duration)

    def switchings(self):
        return self.system.switchings(self.begin, self.duration)

    def breaks(self):
        """Return the times at which the control switches."""
        return self.system.breaks(self.begin, self.duration)

    def switching_function(self):
        """Return pairs (time, dH/du), the costate being followed back from the end."""
        return self.system.switching_function(self.begin, self.duration, self.slowest)

    def field(self, y, u):
        return np.append(self.system.field(y[:-1], u), 1.0)

    def gap(self, y):
        return self.system.gap(y[:-1])

    def total(self, y):
        return float(y[-1])

    def jacobians(self, y, u):
        n = len(y)
        return (
            np.vstack([self.system.jacobian(y, u), np.zeros(n)]),
            np.zeros((1, n)),
            self.system.normals(),
        )

    @functools.cached_property
    def _path(self):
        """Times, states and controls along the optimum, at instants away from the switchings."""
        return self.system.path(self.begin, self.duration, self.slowest, 37)

    times = property(lambda self: self._path[0])
    states = property(lambda self: np.array(self._path[1]).T)
    controls = property(lambda self: self._path[2])
