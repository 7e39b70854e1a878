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

All three have such a direction: it is constant in the first, with d = 0, and turns round at sigma = 0
in the last. They stay beside `direct_optimum`, which takes up to five seconds for each of these
transfers and knows the time of those on a line to 7e-4 alone, as no piece ends where they turn.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.direct_problem import DirectProblem, statement
from workbook.checks.references.optima.optimum import FastestTransfer
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
    stated = DirectProblem(statement(problem), names)
    cases = (
        sample_cases(parameters or {}) if points is None else [tuple(p.values()) for p in points]
    )
    return [
        (
            dict(zip(names, case)),
            ThrustOptimum(stated, case, np.array(numbers(*case), dtype=float), read[-1]),
        )
        for case in cases
    ]


def _read(problem):
    """Return (start, target, thrust, constant accelerations, whether it ends at rest), or None."""
    sizes, cost = (len(problem.state), len(problem.control)), (problem.running, problem.final)
    kind = problem.duration, problem.maximise, problem.first_return
    if (sizes, cost, kind) != ((4, 1), (1, 0), (None, False, False)):
        return None
    if None in problem.initial.values():
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
    ends = target[0][x], target[0][y]
    return *problem.initial.values(), *ends, thrust, *accelerations, ends_at_rest


class ThrustOptimum(FastestTransfer):
    """The fastest transfer, by its direction e(sigma) = sigma p + d q at the angle z[0] of p.

    z is (this angle, d, the remaining time at which sigma is zero, the duration).
    """

    def __init__(self, problem, case, numbers, ends_at_rest):
        begin, thrust, pull = numbers[:4], numbers[6], numbers[7:]
        position, speed = begin[:2] - numbers[4:6], begin[2:]
        scaled = position / thrust, speed / thrust
        size = np.linalg.norm(position) * np.linalg.norm(speed)
        if not ends_at_rest:
            z = _to_position(*scaled, pull / thrust)
        elif abs(position[0] * speed[1] - position[1] * speed[0]) <= ON_A_LINE * size:
            z = _on_a_line(*scaled)
        else:
            z = _to_rest(*scaled)
        times = z[3] * np.arange(INSTANTS + 1) / INSTANTS
        fast, far = (thrust * part for part in _thrust_effect(z, z[3] - times))
        states = np.vstack(
            [
                begin[:2, None] + np.outer(speed, times) + np.outer(pull, times**2 / 2) + far,
                speed[:, None] + np.outer(pull, times) + fast,
            ]
        )
        direction, normal = _unit_vectors(z[0])
        e = np.outer(direction, z[3] - times[1:] - z[2]) + z[1] * normal[:, None]
        angles = np.arctan2(e[1], e[0])
        super().__init__(
            problem, case, z[3], times, states, np.unwrap(angles) if z[1] else angles, []
        )

    def duration_message(self, duration):
        """Return the text on a wrong duration."""
        return directed(
            "the point can come there earlier"
            if duration > self.duration
            else "with no direction of the thrust does the point reach its target at that time",
            "that is not the earliest time at which the point can come there",
        )


def _to_position(position, speed, pull):
    half = pull / 2
    square = speed @ speed + 2 * half @ position
    ends = 2 * speed @ position, position @ position
    roots = np.roots([half @ half - 1 / 4, 2 * half @ speed, square, *ends])
    real = roots.real[(abs(roots.imag) <= 1e-7 * abs(roots)) & (roots.real > 0)]
    if not real.size:
        raise RuntimeError("the thrust does not bring the point to its target")
    T = real.min()
    miss = -(position + speed * T + half * T**2)
    return np.arctan2(miss[1], miss[0]), 0.0, -T, T


def _on_a_line(position, speed):
    direction = position if position.any() else speed
    direction = direction / np.linalg.norm(direction)
    x, w = position @ direction, speed @ direction
    sign = 1 if x + w * abs(w) / 2 >= 0 else -1  # the first push is against it
    x, w, back = sign * x, sign * w, -sign * direction
    root = np.sqrt(w**2 / 2 + x)
    return np.arctan2(back[1], back[0]), 0.0, root, w + 2 * root


def _to_rest(position, speed):
    from scipy.optimize import fsolve

    shortest = max(
        np.linalg.norm(speed), np.sqrt(2 * np.linalg.norm(position)) - np.linalg.norm(speed), 1e-6
    )
    size = np.abs(position).max() + np.abs(speed).max()
    for span, k, d in itertools.product(SPANS, range(DIRECTIONS), (0.3, -0.3)):
        guess = np.array([2 * np.pi * k / DIRECTIONS, d * span, span / 2, span])
        guess[1:] *= shortest
        z, *_ = fsolve(_ends, guess, args=(position, speed), full_output=True, xtol=1e-14)
        if z[3] > 0 and np.abs(_ends(z, position, speed)).max() <= SOLVED * size:
            return z
    raise RuntimeError("the directions that bring the point to rest on its target were not found")


def _unit_vectors(angle):
    """Return the unit vector of an angle, and the one orthogonal to it."""
    return np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])


def _thrust_effect(z, remaining_times):
    """Return what a unit thrust along sigma p + d q adds to velocity and position, as columns.

    From the beginning until `remaining_times` are left.
    """
    angle, d, middle, T = z
    direction, normal = _unit_vectors(angle)
    ends = np.array([remaining_times, np.full_like(remaining_times, T)]) - middle
    root = np.hypot(ends, d)
    arcsinh_terms = np.arcsinh(ends / abs(d)) if d else np.zeros_like(ends)

    def combined(along, across):
        return np.outer(direction, along[1] - along[0]) + np.outer(normal, across[1] - across[0])

    fast = combined(root, d * arcsinh_terms)
    far = combined((ends * root - d**2 * arcsinh_terms) / 2, d * root)
    return fast, far + (middle - remaining_times) * fast


def _ends(z, position, speed):
    """Return velocity and position, relative to the target, at the end."""
    fast, far = (part[:, 0] for part in _thrust_effect(z, np.zeros(1)))
    return np.concatenate([position + speed * z[3] + far, speed + fast])
