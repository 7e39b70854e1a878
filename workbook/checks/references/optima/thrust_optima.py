"""The fastest transfers of a point by a thrust of given size and free direction.

The equations are x'' = a cos u + g, y'' = a sin u + h.

To a position, with any velocity: in the time T the thrust can move the point to all positions of a
disc of radius a T^2/2 about where it would come without thrust, and to no others. The least time is
the first at which the disc contains the target, and then the direction of the thrust is constant.

To rest, without g and h: the direction is that of a vector e(sigma) = sigma p + d q, where p and q
are orthogonal unit vectors and sigma is the remaining time but for a constant. If directions of this
kind bring the point to rest on the target, the time is the least: e and its rate define a plane
between the target and all states that can be reached a little earlier, and the reachable set does
not shrink with time, since a thrust that turns about fast enough holds the point where it rests. If
position and velocity lie on one line through the target, the whole motion is on it.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.units import Units
from workbook.checks.tools.domains import sample_cases

#: At so many instants a process is sampled, and how well the equations of its ends are solved.
INSTANTS, SOLVED = 40, 1e-11
#: From so many directions, and from so many times the shortest time that may be thought of, a
#: search begins.
DIRECTIONS, SPANS = 8, (1.5, 2.5, 4.0)
#: As a part of their sizes, how little position and velocity may be off one line.
ON_A_LINE = 1e-12


def thrust_optima(problem, parameters=None, points=None):
    """Return pairs ({parameter: value}, `ThrustOptimum`), or None for a problem of another kind.

    Parameters
    ----------
    problem : pontryagin.Problem
        The problem.
    parameters : dict, optional
        {symbol: interval}, from which sample values are taken.
    points : list of dict, optional
        Values of the parameters instead.
    """
    read = _read(problem)
    if read is None:
        return None
    names = list(parameters or {})
    numbers = sp.lambdify(names, list(read[:-1]), "math")
    return [
        (
            dict(zip(names, case)),
            ThrustOptimum(np.array(numbers(*case), dtype=float), problem, read[-1]),
        )
        for case in (
            sample_cases(parameters or {})
            if points is None
            else (tuple(p.values()) for p in points)
        )
    ]


def _read(problem):
    """Return (start, target, thrust, constant accelerations, whether it ends at rest), or None."""
    if (
        len(problem.state) != 4
        or len(problem.control) != 1
        or problem.running != 1
        or problem.final != 0
        or problem.duration is not None
        or problem.maximise
        or problem.first_return
        or None in problem.initial.values()
    ):
        return None
    ((u, bounds),) = problem.controls.items()
    x, y, v, w = problem.state
    f = [sp.sympify(e) for e in problem.field]
    thrust = sp.diff(f[2], u, 2).subs(u, 0) * -1
    accelerations = [sp.expand(f[2] - thrust * sp.cos(u)), sp.expand(f[3] - thrust * sp.sin(u))]
    if (
        any(b.is_finite is not False for b in bounds)
        or f[:2] != [v, w]
        or any(e.free_symbols & {u, *problem.state} for e in (thrust, *accelerations))
    ):
        return None
    target = sp.solve(problem.terminal, list(problem.state), dict=True)
    ends_at_rest = len(problem.terminal) == 4
    if (
        len(target) != 1
        or set(target[0]) != ({x, y, v, w} if ends_at_rest else {x, y})
        or any(e.free_symbols & set(problem.state) for e in target[0].values())
    ):
        return None
    if ends_at_rest and any(e != 0 for e in (target[0][v], target[0][w], *accelerations)):
        return None
    return (
        *problem.initial.values(),
        target[0][x],
        target[0][y],
        thrust,
        *accelerations,
        ends_at_rest,
    )


class ThrustOptimum:
    """The fastest transfer, with the attributes of `direct_optimum.Optimum`."""

    bounds, MISSED, units = (-np.inf, np.inf), 0.0, Units()

    def __init__(self, numbers, problem, ends_at_rest):
        self.begin, self.target, self.thrust, self.pull = (
            numbers[:4],
            numbers[4:6],
            numbers[6],
            numbers[7:],
        )
        self.ends_at_rest, self.start = ends_at_rest, np.append(self.begin, 0.0)

    # The process.

    @functools.cached_property
    def _process(self):
        """(duration, direction of the thrust for times, states for times)."""
        position, speed = self.begin[:2] - self.target, self.begin[2:]
        if not self.ends_at_rest:
            return self._transfer_to_position(position, speed)
        cross_product = position[0] * speed[1] - position[1] * speed[0]
        is_collinear = abs(cross_product) <= ON_A_LINE * np.linalg.norm(position) * np.linalg.norm(
            speed
        )
        return (self._collinear_transfer if is_collinear else self._transfer_to_rest)(
            position / self.thrust, speed / self.thrust
        )

    def _transfer_to_position(self, position, speed):
        half = self.pull / 2
        roots = np.roots(
            [
                half @ half - self.thrust**2 / 4,
                2 * half @ speed,
                speed @ speed + 2 * half @ position,
                2 * speed @ position,
                position @ position,
            ]
        )
        real = roots.real[(abs(roots.imag) <= 1e-7 * abs(roots)) & (roots.real > 0)]
        if not real.size:
            raise RuntimeError("the thrust does not bring the point to its target")
        T = real.min()
        miss = -(position + speed * T + half * T**2)
        force = self.thrust * miss / np.linalg.norm(miss)

        def states(t):
            return np.vstack(
                [
                    self.begin[:2, None] + np.outer(speed, t) + np.outer(half + force / 2, t**2),
                    speed[:, None] + np.outer(2 * half + force, t),
                ]
            )

        return T, lambda t: np.full(np.shape(t), np.arctan2(force[1], force[0])), states

    def _collinear_transfer(self, position, speed):
        direction = position if position.any() else speed
        direction = direction / np.linalg.norm(direction)
        x, w = position @ direction, speed @ direction
        sign = 1 if x + w * abs(w) / 2 >= 0 else -1  # the first push is against it
        x, w = sign * x, sign * w
        root = np.sqrt(w**2 / 2 + x)
        first, T = w + root, w + 2 * root
        back = -sign * direction
        first_angle, second_angle = np.arctan2(back[1], back[0]), np.arctan2(-back[1], -back[0])

        def states(t):
            after = np.maximum(t - first, 0)
            displacements = np.outer(back, t**2 / 2 - after**2), np.outer(back, t - 2 * after)
            return np.vstack(
                [
                    self.begin[:2, None]
                    + np.outer(self.begin[2:], t)
                    + self.thrust * displacements[0],
                    self.begin[2:, None] + self.thrust * displacements[1],
                ]
            )

        return T, lambda t: np.where(np.asarray(t) < first, first_angle, second_angle), states

    def _transfer_to_rest(self, position, speed):
        from scipy.optimize import fsolve

        shortest = max(
            np.linalg.norm(speed),
            np.sqrt(2 * np.linalg.norm(position)) - np.linalg.norm(speed),
            1e-6,
        )
        for span in SPANS:
            for k in range(DIRECTIONS):
                for d in (0.3, -0.3):
                    guess = [
                        2 * np.pi * k / DIRECTIONS,
                        d * span * shortest,
                        span * shortest / 2,
                        span * shortest,
                    ]
                    z, _, _status, _ = fsolve(
                        _ends, guess, args=(position, speed), full_output=True, xtol=1e-14
                    )
                    residual = np.abs(_ends(z, position, speed)).max()
                    if z[3] > 0 and residual <= SOLVED * (
                        np.abs(position).max() + np.abs(speed).max()
                    ):
                        return z[3], *self._turning(z)
        raise RuntimeError(
            "the directions that bring the point to rest on its target were not found"
        )

    def _turning(self, z):
        _, d, middle, T = z
        direction, normal = _unit_vectors(z[0])

        def angle(t):
            sigma = T - np.asarray(t) - middle
            e = np.multiply.outer(direction, sigma) + np.multiply.outer(
                normal, d * np.ones_like(sigma)
            )
            return np.unwrap(np.arctan2(e[1], e[0]))

        def states(t):
            rows = [_thrust_effect(z, T - time) for time in t]
            free_positions = self.begin[:2, None] + np.outer(self.begin[2:], t)
            return np.vstack(
                [
                    free_positions + self.thrust * np.array([far for _, far in rows]).T,
                    self.begin[2:, None] + self.thrust * np.array([fast for fast, _ in rows]).T,
                ]
            )

        return angle, states

    # What the checks ask for.

    @property
    def duration(self):
        return self._process[0]

    cost = duration

    @functools.cached_property
    def times(self):
        return self.duration * np.arange(1, INSTANTS + 1) / INSTANTS

    @functools.cached_property
    def states(self):
        return self._process[2](self.times)

    @functools.cached_property
    def controls(self):
        return self._process[1](self.times)

    def field(self, y, u):
        acceleration = self.thrust * np.array([np.cos(u), np.sin(u)]) + self.pull
        return np.array([y[2], y[3], *acceleration, 1.0])

    def gap(self, y):
        return np.array([*(y[:2] - self.target), *(y[2:4] if self.ends_at_rest else ())])

    def total(self, y):
        return float(y[-1])

    def jacobians(self, y, u):
        rates = np.zeros((5, 4))
        rates[0, 2] = rates[1, 3] = 1
        return rates, np.zeros((1, 4)), np.eye(4)[: 4 if self.ends_at_rest else 2]

    def duration_message(self, duration):
        """Return the text on a wrong duration."""
        return directed(
            "the point can come there earlier"
            if duration > self.duration
            else "with no direction of the thrust does the point reach its target at that time",
            "that is not the earliest time at which the point can come there",
        )

    def size(self):
        return float(max(1e-9, np.abs(self.states).max(), np.abs(self.begin).max()))

    def cost_size(self):
        return self.duration


def _unit_vectors(angle):
    """Return the unit vector of an angle, and the one orthogonal to it."""
    return np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])


def _thrust_effect(z, remaining_time):
    """Return what a unit thrust along sigma p + d q adds to velocity and position.

    From the beginning until `remaining_time` is left.
    """
    angle, d, middle, T = z
    direction, normal = _unit_vectors(angle)
    ends = np.array([remaining_time, T]) - middle
    root = np.hypot(ends, d)
    arcsinh_terms = np.arcsinh(ends / abs(d)) if d else np.zeros(2)
    fast = direction * np.diff(root) + normal * d * np.diff(arcsinh_terms)
    far = direction * np.diff(ends * root - d**2 * arcsinh_terms) / 2 + normal * d * np.diff(root)
    return fast, far + (middle - remaining_time) * fast


def _ends(z, position, speed):
    """Return velocity and position, relative to the target, at the end."""
    fast, far = _thrust_effect(z, 0.0)
    return np.concatenate([position + speed * z[3] + far, speed + fast])
