"""Processes from a direct solution: evaluated at any time, with their errors, shown."""

from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np
import sympy as sp

from trajlib import plotting
from trajlib.pontryagin.problem.derivation import conditions
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.times_of_process import times_of_process

# Steps of the finer grid on each interval.
FINER = 16


@dataclass(frozen=True, eq=False)
class DirectProcess:
    """A process with costates estimated from the multipliers of a nonlinear programme.

    Attributes
    ----------
    problem : Problem
        The problem that was discretised.
    scheme : str
        "runge-kutta", "trapezoidal" or "hermite-simpson".
    times : ndarray, shape (N+1,)
        The nodes.
    states, costates : ndarray, shape (N+1, n)
        At the nodes; the costates with lambda_0 = 1 and the signs of `Extremal`.
    control_times : ndarray, shape (M,)
        In the middle of the intervals, at the nodes, or at both, by the scheme.
    controls : ndarray, shape (M, k)
        At these times.
    path_multipliers : ndarray, shape (N+1, c)
        Estimates of eta of the path constraints at the nodes; a jump of the costate is a peak.
    terminal_multipliers : tuple of float
        Of the terminal equations, then of the terminal inequalities.
    cost : float
        J by the scheme.
    iterations : int
        Of IPOPT.
    nlp : dict
        The programme {"x": variables, "f": cost, "g": constraints} in CasADi symbols, in natural
        units; the variables are the states, the controls and the duration.
    inner : DirectProcess or None
        That of the reformulated problem, where `solve` reformulates the statement.
    """

    problem: Statement
    scheme: str
    times: np.ndarray
    states: np.ndarray
    costates: np.ndarray
    control_times: np.ndarray
    controls: np.ndarray
    path_multipliers: np.ndarray
    terminal_multipliers: tuple[float, ...]
    cost: float
    iterations: int
    nlp: dict[str, Any] = field(repr=False)
    inner: "Self | None" = None

    @property
    def duration(self) -> float:
        """The final time."""
        return float(self.times[-1])

    @property
    def defects(self) -> np.ndarray:
        """The errors of the states at the end of each interval, shape (N, n).

        From the node before it, integrated by Runge-Kutta steps of a sixteenth of the interval with
        the control of the scheme.
        """
        if self.inner is not None:
            return self.inner.defects
        rate, y = self._rate, self.states[:-1].T
        h = np.diff(self.times) / FINER
        for step in range(FINER):
            begin, middle, end = (
                self._controls_at((step + part) / FINER) for part in (0.0, 0.5, 1.0)
            )
            k1 = rate(y, begin)
            k2 = rate(y + h / 2 * k1, middle)
            k3 = rate(y + h / 2 * k2, middle)
            k4 = rate(y + h * k3, end)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return (y - self.states[1:].T).T

    @property
    def path_violations(self) -> np.ndarray:
        """The largest positive values of the path constraints on a finer grid, shape (c,)."""
        if not self.problem.path:
            return np.zeros(0)
        fine = np.linspace(0, 1, FINER, endpoint=False)
        times = (self.times[:-1, None] + np.diff(self.times)[:, None] * fine).ravel()
        values = _function(self.problem, "constraints")(
            self.state(np.append(times, self.duration)), np.zeros((len(self.problem.control), 1))
        )
        return np.maximum(values.max(axis=1), 0.0)

    def state(self, t) -> np.ndarray:
        """Return the state at given times, by cubics through the nodes with the slopes f(y, u).

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            The states in the order of the problem.
        """
        index, share, h = self._located(t)
        left, right = self.states[index].T, self.states[index + 1].T
        slopes = [
            self._rate(y, self._controls_at(end)[:, index]) * h
            for y, end in ((left, 0.0), (right, 1.0))
        ]
        s = share
        values = (
            left * (1 + 2 * s) * (1 - s) ** 2
            + slopes[0] * s * (1 - s) ** 2
            + right * s**2 * (3 - 2 * s)
            - slopes[1] * s**2 * (1 - s)
        )
        return values[:, 0] if np.ndim(t) == 0 else values

    def costate(self, t) -> np.ndarray:
        """Return the costate psi at given times, linear between the nodes.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            With lambda_0 = 1.
        """
        index, share, _ = self._located(t)
        values = (self.costates[index].T * (1 - share)) + self.costates[index + 1].T * share
        return values[:, 0] if np.ndim(t) == 0 else values

    def control(self, t) -> np.ndarray:
        """Return the controls at given times: constant, linear or quadratic by the scheme.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (k,) or (k, N)
            The controls in the order of the problem.
        """
        index, share, _ = self._located(t)
        values = self._controls_at(share, index)
        return values[:, 0] if np.ndim(t) == 0 else values

    def to_dataframe(self):
        """Return states, controls, costates and path multipliers at the nodes as a table.

        Returns
        -------
        pandas.DataFrame
            One row for each node, the times as index "t"; columns have the names of the symbols,
            eta1, ... for the path multipliers.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        try:
            import pandas  # type: ignore[import-untyped]
        except ImportError:
            raise ImportError(
                "to_dataframe: needs pandas; install it by `pip install pandas`"
            ) from None
        problem = self.problem
        names = [*problem.state, *problem.control, *conditions(problem).costate]
        names += [f"eta{j + 1}" for j in range(len(problem.path))]
        values = [self.states, self.control(self.times).T, self.costates, self.path_multipliers]
        index = pandas.Index(self.times, name="t")
        return pandas.DataFrame(np.hstack(values), index, [str(name) for name in names])

    def plot(self, axes=None) -> np.ndarray:
        """Draw states, controls and costates against time.

        Parameters
        ----------
        axes : array of matplotlib Axes, optional
            Three of them; new ones by default.

        Returns
        -------
        ndarray of Axes
            Those that were drawn on.
        """

        if axes is None:
            import matplotlib.pyplot as plt

            with plotting.style():
                _, axes = plt.subplots(3, 1, figsize=(5, 8), sharex=True)
        axes = np.atleast_1d(axes).ravel()
        if len(axes) != 3:
            raise ValueError(f"axes: expected 3 Axes, got {len(axes)}")
        problem, fine = self.problem, np.linspace(0, self.duration, 1000)
        parts = {
            "state": (problem.state, self.state(fine), self.times, self.states),
            "control": (problem.control, self.control(fine), self.control_times, self.controls),
            "costate": (
                conditions(problem).costate,
                self.costate(fine),
                self.times,
                self.costates,
            ),
        }
        for ax, (label, (symbols, curves, nodes, values)) in zip(axes, parts.items()):
            for symbol, curve, column in zip(symbols, curves, values.T):
                (line,) = ax.plot(fine, curve, label=f"${sp.latex(symbol)}$")
                ax.plot(nodes, column, ".", markersize=3, color=line.get_color())
            ax.set_ylabel(label)
            ax.legend()
        axes[-1].set_xlabel("$t$")
        return axes

    def __repr__(self):
        largest = float(np.max(np.abs(self.defects)))
        return (
            f"{type(self).__name__}(cost={self.cost:.9g}, duration={self.duration:.9g}, "
            f"{len(self.times) - 1} intervals, {self.scheme}, largest defect {largest:.1e})"
        )

    @property
    def _rate(self):
        return _function(self.problem, "field")

    def _controls_at(self, share, index=None):
        """Return the controls at a share of the intervals of these indices (all of them), (k, N)."""
        u = self.controls
        if index is None:
            index = np.arange(len(self.times) - 1)
        if self.scheme == "runge-kutta":
            return u[index].T
        if self.scheme == "trapezoidal":
            return u[index].T * (1 - share) + u[index + 1].T * share
        s = np.asarray(share)
        return (
            u[2 * index].T * (1 - s) * (1 - 2 * s)
            + u[2 * index + 1].T * 4 * s * (1 - s)
            + u[2 * index + 2].T * s * (2 * s - 1)
        )

    def _located(self, t):
        """Return the interval of each time, its share of the interval, and the length of this."""
        times = times_of_process(t, self.duration)
        index = np.clip(np.searchsorted(self.times, times, "right") - 1, 0, len(self.times) - 2)
        h = np.diff(self.times)[index]
        return index, np.clip((times - self.times[index]) / h, 0.0, 1.0), h


def _function(problem, name):
    """Return (states (n, N), controls (k, N)) -> values (m, N) of expressions of a problem."""

    def build():
        expressions = getattr(problem, name)
        raw = sp.lambdify([*problem.state, *problem.control], list(expressions), "numpy")

        def values(y, u):
            return np.array(
                [np.broadcast_to(np.asarray(row, float), y.shape[1]) for row in raw(*y, *u)]
            )

        return values

    return problem.cached(f"function: {name}", build)
