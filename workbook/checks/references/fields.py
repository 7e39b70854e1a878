"""Vector fields of the data, made numeric: values, derivatives, equilibria, motions.

Only fields of data cells come here, never an answer: they are compiled by `lambdify`.
"""

import functools
from contextlib import suppress

import numpy as np
import sympy as sp

#: Step of the complex-step derivative: no subtraction, so the result is exact to rounding (Squire
#: and Trapp, 1998).
STEP = 1e-30


@functools.lru_cache(maxsize=16)
def cached_field(field, state):
    """Return the `Field` of data given as tuples, the same for the same data."""
    return Field(field, state)


class Field:
    """The field `f(state)`, with values for its parameters."""

    def __init__(self, field, state, values=None):
        self.state = list(state)
        self.expressions = [sp.sympify(component).subs(values or {}) for component in field]
        foreign = set().union(*(e.free_symbols for e in self.expressions)) - set(self.state)
        if foreign:
            raise ValueError(f"the field still contains {foreign}")
        self._function = sp.lambdify(self.state, self.expressions, "numpy")

    def __call__(self, point):
        """Return f at a point; nan where it is not defined."""
        with np.errstate(all="ignore"):
            return np.array(
                [
                    complex(value) if np.iscomplexobj(point) else value
                    for value in self._function(*point)
                ]
            )

    def velocity(self, _, point):
        """Return f at a real point and any time, for an integration, in Python's own fast numbers."""
        try:
            values = np.array(self._function(*point.tolist()))
        except (ZeroDivisionError, OverflowError):  # where NumPy's are infinite
            return self(point)
        return self(point) if np.iscomplexobj(values) else values  # and where they are nan

    def jacobian(self, point):
        """Return the matrix of partial derivatives at a point, by complex steps."""
        return self._jacobians(np.asarray(point, dtype=float)[:, None])[0]

    def _at(self, points):
        """Return f at many points, the columns of an array."""
        with np.errstate(all="ignore"):
            return np.array(
                [np.broadcast_to(value, points.shape[1:]) for value in self._function(*points)]
            )

    def _jacobians(self, points):
        """Return the Jacobians at the columns of an array, stacked along the first axis."""
        # the last axis: along which variable
        steps = points[:, :, None] + 1j * STEP * np.eye(len(self.state))[:, None, :]
        return self._at(steps).imag.transpose(1, 0, 2) / STEP

    def derivative(self, point, direction):
        """Return the derivative of f at a point along a direction."""
        return (
            self(np.asarray(point, dtype=complex) + 1j * STEP * np.asarray(direction)).imag / STEP
        )

    def refine(self, start):
        """Return the equilibrium that a damped Newton iteration reaches from `start`, or None."""
        (point,) = self._refined(np.array(start, dtype=float)[:, None])
        return point

    def _refined(self, starts, steps=60):
        """Return the equilibria reached from many starts, columns of an array, with None for failures."""
        x, points = starts.copy(), [None] * starts.shape[1]
        value, active = self._at(x), np.arange(starts.shape[1])
        with np.errstate(all="ignore"):
            for _ in range(steps):
                active = active[np.isfinite(value[:, active]).all(axis=0)]
                move, solved = _solved(self._jacobians(x[:, active]), -value[:, active])
                active, move = active[solved], move[:, solved]
                converged = np.linalg.norm(move, axis=0) < 1e-13 * (
                    1 + np.linalg.norm(x[:, active], axis=0)
                )
                for k in active[converged]:
                    points[k] = x[:, k].copy()
                active, move = active[~converged], move[:, ~converged]
                if not len(active):
                    break
                x[:, active] += self._shortened(
                    move, x[:, active], np.linalg.norm(value[:, active], axis=0)
                )
                value[:, active] = self._at(x[:, active])
        # Steps that do not shrink lead nowhere, however small the field has become: exp(x) falls
        # without end.
        return points

    def _shortened(self, move, x, size):
        """Return Newton steps halved, at most 30 times, until the field is not larger than `size`."""
        move, active = move.copy(), np.arange(move.shape[1])
        for _ in range(30):
            trial = self._at(x[:, active] + move[:, active])
            decreased = np.isfinite(trial).all(axis=0) & (
                np.linalg.norm(trial, axis=0) < size[active] * (1 + 1e-9)
            )
            active = active[~decreased]
            if not len(active):
                break
            move[:, active] /= 2
        return move

    def equilibria(self, starts=240, seed=3, reach=None):
        """Return the equilibria found from many starts, sorted.

        The starts are random at several scales, or uniform within `reach`.
        """
        random, n = np.random.default_rng(seed), len(self.state)
        points = [
            random.normal(scale=(0.5, 2, 8)[k % 3], size=n)
            if reach is None
            else random.uniform(-reach, reach, size=n)
            for k in range(starts)
        ]
        equilibria = []
        for point in self._refined(np.array(points).T):
            if point is not None and all(
                np.linalg.norm(point - equilibrium) > 1e-6 * (1 + np.linalg.norm(equilibrium))
                for equilibrium in equilibria
            ):
                equilibria.append(point)
        return sorted(equilibria, key=tuple)

    def motion(self, start, duration, escape=1e3):
        """Return the state after `duration`, or None if the motion leaves a ball before."""
        from scipy.integrate import solve_ivp

        def boundary(_, x):
            return escape - np.linalg.norm(x)

        boundary.terminal = True
        with np.errstate(all="ignore"):
            path = solve_ivp(
                self.velocity,
                (0, duration),
                start,
                method="DOP853",
                rtol=1e-9,
                atol=1e-12,
                events=boundary,
            )
        return None if path.t[-1] < duration else path.y[:, -1]


def _solved(matrices, sides):
    """Return solutions of linear systems, in columns, and which of the systems have one."""
    try:
        return np.linalg.solve(matrices, sides.T[:, :, None])[:, :, 0].T, np.ones(
            len(matrices), dtype=bool
        )
    except np.linalg.LinAlgError:
        pass
    # A singular matrix among them: the others count all the same.
    solutions, solved = np.full(sides.shape, np.nan), np.zeros(len(matrices), dtype=bool)
    for k, (matrix, side) in enumerate(zip(matrices, sides.T)):
        with suppress(np.linalg.LinAlgError):
            solutions[:, k], solved[k] = np.linalg.solve(matrix, side), True
    return solutions, solved
