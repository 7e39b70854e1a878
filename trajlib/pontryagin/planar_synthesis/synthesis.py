"""A planar synthesis: optimal cost, time and control in a window of the phase plane, and its curves."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from trajlib.pontryagin.planar_synthesis.borders import border_extremals
from trajlib.pontryagin.planar_synthesis.curves import consecutive_runs
from trajlib.pontryagin.planar_synthesis.drawing import draw
from trajlib.pontryagin.planar_synthesis.regularity import regularity
from trajlib.pontryagin.planar_synthesis.value_function import ON_TARGET, ValueFunction
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class Synthesis:
    """What `synthesis` returns: the optimal cost, time and control in the window, and the curves on
    which they change.

    `switching_curves`, `dispersal_curves`: lists of `Curve` (`points`, shape (N, 2), `times` to the
    target). `borders`: extremals that touch the target or end a family, as `Curve` with `jump`, the
    greatest jump of the optimal cost across it (inf at the edge of the set from which the target is
    reached); `barriers` are those whose jump is not zero. `reached`: the parts of the target at
    which optimal trajectories end, as `Curve`; its `parameter` is (from, to).
    """

    problem: Statement
    window: tuple
    horizon: float
    switching_curves: list
    dispersal_curves: list
    reached: list
    _target: object = field(repr=False)
    _value_function: ValueFunction = field(repr=False)
    _touching: list = field(repr=False)
    _end_cost: object = field(repr=False)

    @cached_property
    def borders(self):
        """Extremals that touch the target or end a family; computed when first asked for."""
        return border_extremals(self._value_function.fans, self._value_function, self._touching)

    @property
    def barriers(self):
        """The borders across which the optimal cost jumps."""
        least = (
            1e-3
            * self.horizon
            * self._value_function.step_cost
            / self._value_function.fans[0].times[1]
        )
        return [curve for curve in self.borders if curve.jump > least]

    @property
    def plant(self):
        return self._value_function.fans[0].plant

    def cost(self, x1, x2):
        """Optimal cost from the points (arrays of one shape); nan where no extremal leads to the
        target within the horizon."""
        best, x, shape = self._best(x1, x2)
        cost = np.where(self._on_target(x), self._end_cost(x), best.cost)
        cost = np.where(np.isfinite(cost), -cost if self.problem.maximise else cost, np.nan)
        return _in_shape(cost, shape)

    def time(self, x1, x2):
        """The time that the optimal process takes from the points (arrays of one shape); nan where
        the target is not reached within the horizon."""
        best, x, shape = self._best(x1, x2)
        return _in_shape(np.where(self._on_target(x), 0, best.time), shape)

    def control(self, x1, x2):
        """The feedback u(x1, x2), arrays of one shape (with a row for each of several controls);
        nan where the target is not reached within the horizon.

        On a switching curve it is the control that follows. Where a control is open (`unique`), it
        is one of the values that it may have.
        """
        best, _, shape = self._best(x1, x2)
        if len(self.problem.control) == 1:
            return _in_shape(best.control[:, 0], shape)
        return best.control.T.reshape(-1, *shape)

    def level(self, x1, x2):
        """The names of the controls' levels at the points: "u-", "interior", "zero", "u+" or "open"
        (tuples for several controls), "" where the target is not reached. One name, or an array of
        them in the points' shape."""
        best, _, shape = self._best(x1, x2)
        names = [self.plant.name(mode) for mode in range(len(self.plant.modes))] + [""]
        result = np.empty(len(best.mode), dtype=object)
        for k, mode in enumerate(best.mode):
            result[k] = names[mode]
        return result.reshape(shape) if shape else result[0]

    def unique(self, x1, x2):
        """Whether the maximum condition tells every control along the optimal process from the
        points; where it does not, many controls cost the same."""
        best, _, shape = self._best(x1, x2)
        held = np.array([fan.ends.held is not None for fan in self._value_function.fans])
        values = (best.fan < 0) | ~held[best.fan]
        return values.reshape(shape) if shape else bool(values[0])

    def reaches(self, x1, x2):
        """Whether the target can be reached from the points within the horizon."""
        time = self.time(x1, x2)
        return np.isfinite(time) if np.ndim(time) else bool(np.isfinite(time))

    def isochrone(self, time):
        """The points in the window from which the optimal process takes the time `time`: a list of
        arrays, (N, 2)."""
        if not 0 < time <= self.horizon:
            raise ValueError(
                f"time: expected a number between 0 and the horizon {self.horizon}, got {time}"
            )
        pieces = []
        for fan in self._value_function.fans:
            z, _ = fan.flow(fan.s, np.full(fan.s.size, float(time)))
            keep = (fan.optimal_until >= time) & self._inside(z[:2])
            pieces += [
                z[:2, run].T for run in consecutive_runs(np.flatnonzero(keep)) if run.size > 1
            ]
        return pieces

    def extremals(self, count=24):
        """About `count` optimal trajectories: a list of (points, controls), points of shape (K, 2)
        from far to the target."""
        chosen = []
        for fan in self._value_function.fans:
            long = np.flatnonzero((fan.optimal_until > 0) & (fan.last_step > 1))
            share = max(
                round(count * long.size / max(sum(f.s.size for f in self._value_function.fans), 1)),
                2,
            )
            for j in self._spread(fan, long, share):
                keep = fan.times <= fan.optimal_until[j]
                u = self.plant.control(fan.motion[keep, :, j].T, fan.mode[keep, j])
                chosen.append((fan.path[keep, :, j][::-1], (u[0] if len(u) == 1 else u.T)[::-1]))
        return chosen

    def regularity(self):
        """The conditions of Boltyansky's regular synthesis, each with what was found:
        `Regularity`."""
        return regularity(self)

    def plot(self, ax=None, isochrones=(), extremals=24):
        """The synthesis in the phase plane; returns the Axes. `isochrones`: times whose lines are
        drawn."""
        return draw(self, ax, isochrones, extremals)

    def __repr__(self):
        return (
            f"Synthesis({len(self.switching_curves)} switching curves, "
            f"{len(self.dispersal_curves)} dispersal curves, {len(self.barriers)} barriers, "
            f"window={self.window}, horizon={self.horizon:g})"
        )

    def _best(self, x1, x2):
        """The best extremals from points, with the points (2, N) and their shape; the last question
        is remembered."""
        x, shape = self._points(x1, x2)
        last = self.__dict__.get("_last_query")
        if last is None or last[0].shape != x.shape or (last[0] != x).any():
            last = self.__dict__["_last_query"] = (x, self._value_function.exact(x))
        return last[1], x, shape

    def _points(self, x1, x2):
        x1, x2 = np.broadcast_arrays(np.asarray(x1, dtype=float), np.asarray(x2, dtype=float))
        x = np.array([x1.ravel(), x2.ravel()])
        if not (np.isfinite(x).all() and self._inside(x, 1e-9).all()):
            raise ValueError(f"x1, x2: expected finite points inside the window {self.window}")
        return x, x1.shape

    def _inside(self, x, slack=0.0):
        (left, right), (bottom, top) = self.window
        dx, dy = slack * (right - left), slack * (top - bottom)
        return (
            (x[0] >= left - dx) & (x[0] <= right + dx) & (x[1] >= bottom - dy) & (x[1] <= top + dy)
        )

    def _on_target(self, x):
        return np.abs(self._target.outside(x, 1)) < ON_TARGET

    def _spread(self, fan, long, share):
        """Indices of extremals whose far ends are evenly spread along the border of what they
        cover."""
        if not long.size:
            return []
        last = np.array(
            [fan.path[np.flatnonzero(fan.times <= fan.optimal_until[j])[-1], :, j] for j in long]
        )
        along = np.append(0, np.cumsum(np.hypot(*np.diff(last, axis=0).T)))
        return long[
            np.unique(
                np.searchsorted(along, np.linspace(0, along[-1], share + 2)[1:-1]).clip(
                    0, long.size - 1
                )
            )
        ]


def _in_shape(values, shape):
    return values.reshape(shape) if shape else float(values[0])
