"""Planar syntheses: optimal cost, time and control in a window of the phase plane."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from trajlib.pontryagin.planar_synthesis.borders import border_extremals
from trajlib.pontryagin.planar_synthesis.curves import Curve, consecutive_runs
from trajlib.pontryagin.planar_synthesis.drawing import draw
from trajlib.pontryagin.planar_synthesis.plant import Plant
from trajlib.pontryagin.planar_synthesis.regularity import Regularity, regularity
from trajlib.pontryagin.planar_synthesis.value_function import ON_TARGET, ValueFunction
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class Synthesis:
    """The optimal synthesis of a planar problem in a window, as `synthesis` computes it.

    Attributes
    ----------
    problem : Problem
        The problem.
    window : tuple
        ((left, right), (bottom, top)).
    horizon : float
        The longest duration of a process.
    switching_curves, dispersal_curves : list of Curve
        Their points, with the times to the target.
    reached : list of Curve
        The parts of the target at which optimal trajectories end; their `parameter` is (from, to).
    """

    problem: Statement
    window: tuple[tuple[float, float], tuple[float, float]]
    horizon: float
    switching_curves: list[Curve]
    dispersal_curves: list[Curve]
    reached: list[Curve]
    _target: object = field(repr=False)
    _value_function: ValueFunction = field(repr=False)
    _touching: list = field(repr=False)
    _end_cost: Callable = field(repr=False)

    @cached_property
    def borders(self) -> list[Curve]:
        """Extremals that touch the target or end a family, with the `jump` of the cost across them.

        The jump is inf at the edge of the set from which the target is reached. Computed on first
        access.
        """
        return border_extremals(self._value_function.fans, self._value_function, self._touching)

    @property
    def barriers(self) -> list[Curve]:
        """The borders across which the optimal cost jumps."""
        least = (
            1e-3
            * self.horizon
            * self._value_function.step_cost
            / self._value_function.fans[0].times[1]
        )
        return [curve for curve in self.borders if curve.jump > least]

    @property
    def plant(self) -> Plant:
        """The right-hand sides of the extremals."""
        return self._value_function.fans[0].plant

    def cost(self, x1, x2) -> float | np.ndarray:
        """Return the optimal cost from given points.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        float or ndarray
            In that shape; nan where no extremal leads to the target within the horizon.

        Raises
        ------
        ValueError
            For points outside of the window.
        """
        best, x, shape = self._best(x1, x2)
        cost = np.where(self._on_target(x), self._end_cost(x), best.cost)
        cost = np.where(np.isfinite(cost), -cost if self.problem.maximise else cost, np.nan)
        return _in_shape(cost, shape)

    def time(self, x1, x2) -> float | np.ndarray:
        """Return the time that the optimal process takes from given points.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        float or ndarray
            In that shape; nan where the target is not reached within the horizon.

        Raises
        ------
        ValueError
            For points outside of the window.
        """
        best, x, shape = self._best(x1, x2)
        return _in_shape(np.where(self._on_target(x), 0, best.time), shape)

    def control(self, x1, x2) -> float | np.ndarray:
        """Return the feedback u(x1, x2) at given points.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        float or ndarray
            In that shape, with a row for each of several controls; nan where the target is not
            reached within the horizon. On a switching curve it is the control that follows. Where a
            control is open (`unique`), it is one of its possible values.

        Raises
        ------
        ValueError
            For points outside of the window.
        """
        best, _, shape = self._best(x1, x2)
        if len(self.problem.control) == 1:
            return _in_shape(best.control[:, 0], shape)
        return best.control.T.reshape(-1, *shape)

    def level(self, x1, x2) -> str | tuple | np.ndarray:
        """Return the names of the controls' levels at given points.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        str, tuple or ndarray
            "u-", "interior", "zero", "u+" or "open" (tuples for several controls), "" where the
            target is not reached; one name, or an array of them in the points' shape.
        """
        best, _, shape = self._best(x1, x2)
        names = [self.plant.name(mode) for mode in range(len(self.plant.modes))] + [""]
        result = np.empty(len(best.mode), dtype=object)
        for k, mode in enumerate(best.mode):
            result[k] = names[mode]
        return result.reshape(shape) if shape else result[0]

    def unique(self, x1, x2) -> bool | np.ndarray:
        """Check whether the maximum condition determines every control along the optimal process.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        bool or ndarray
            False where many controls cost the same.
        """
        best, _, shape = self._best(x1, x2)
        held = np.array([fan.ends.held is not None for fan in self._value_function.fans])
        values = (best.fan < 0) | ~held[best.fan]
        return values.reshape(shape) if shape else bool(values[0])

    def reaches(self, x1, x2) -> bool | np.ndarray:
        """Check whether the target can be reached from given points within the horizon.

        Parameters
        ----------
        x1, x2 : float or array_like
            Points in the window, arrays of one shape.

        Returns
        -------
        bool or ndarray
            In that shape.
        """
        time = self.time(x1, x2)
        return np.isfinite(time) if np.ndim(time) else bool(np.isfinite(time))

    def isochrone(self, time: float) -> list[np.ndarray]:
        """Return the points in the window from which the optimal process takes a given time.

        Parameters
        ----------
        time : float
            Positive, at most the horizon.

        Returns
        -------
        list of ndarray, shape (N, 2)
            The pieces of the isochrone.

        Raises
        ------
        ValueError
            For another time.
        """
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

    def extremals(self, count: int = 24) -> list[tuple[np.ndarray, np.ndarray]]:
        """Return optimal trajectories that cover the window evenly.

        Parameters
        ----------
        count : int, optional
            About how many.

        Returns
        -------
        list of tuple
            (points, controls) of each, points of shape (K, 2) with the target last.
        """
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

    def regularity(self) -> Regularity:
        """Test the conditions of Boltyansky's regular synthesis.

        Returns
        -------
        Regularity
            The conditions A to F, each with the number that decides.
        """
        return regularity(self)

    def plot(self, ax=None, isochrones: Sequence[float] = (), extremals: int = 24):
        """Draw the synthesis in the phase plane.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            A new one if left out.
        isochrones : list of float, optional
            Times whose isochrones are drawn.
        extremals : int, optional
            About how many extremals are drawn; 0 for none.

        Returns
        -------
        matplotlib.axes.Axes
            The Axes.
        """
        return draw(self, ax, isochrones, extremals)

    def __repr__(self):
        return (
            f"Synthesis({len(self.switching_curves)} switching curves, "
            f"{len(self.dispersal_curves)} dispersal curves, {len(self.barriers)} barriers, "
            f"window={self.window}, horizon={self.horizon:g})"
        )

    def _best(self, x1, x2):
        """Return the best extremals from points, the points (2, N) and their shape.

        The last result is kept.
        """
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
        """Return indices of extremals whose far ends are evenly spread."""
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
