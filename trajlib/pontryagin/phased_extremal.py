"""Extremals of problems in phases: each phase in its own time, with its own costate."""

from dataclasses import dataclass, field
from functools import cached_property
from itertools import groupby, pairwise

import numpy as np
import sympy as sp

from trajlib import plotting
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.phase import Phase, beginning, joined_duration, moving
from trajlib.pontryagin.verification.certificate import Certificate
from trajlib.pontryagin.verification.optimality import Optimality

_POINTS = 200


@dataclass(frozen=True, eq=False)
class ExtremalPhase:
    """One phase of a `PhasedExtremal`.

    Attributes
    ----------
    begin, end : float
        Times since the start of the process.
    arcs : tuple of tuple
        (kind, begin, end) as of an `Extremal`; a tuple of kinds for several controls.
    """

    begin: float
    end: float
    arcs: tuple[tuple, ...]
    _joined: Extremal = field(repr=False)
    # Rows of the joined problem: states since the beginning of the phase, their values at it (none
    # for the first phase), controls.
    _states: list[int] = field(repr=False)
    _beginnings: list[int] = field(repr=False)
    _controls: list[int] = field(repr=False)

    def state(self, t) -> np.ndarray:
        """Return the states of the phase at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [begin, end].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            In the order of the phase's dynamics.

        Raises
        ------
        ValueError
            For times outside of [begin, end].
        """
        values = self._joined.state(self._fraction(t))
        since = values[self._states]
        return since + values[self._beginnings] if self._beginnings else since

    def costate(self, t) -> np.ndarray:
        """Return the costates psi of the phase at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [begin, end].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            psi' = -dH/dy with H = psi^T f - lambda_0 f_0 of the phase.

        Raises
        ------
        ValueError
            For times outside of [begin, end].
        """
        return self._joined.costate(self._fraction(t))[self._states]

    def control(self, t) -> np.ndarray:
        """Return the controls of the phase at given times; at a switching the value after it.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [begin, end].

        Returns
        -------
        ndarray, shape (k,) or (k, N)
            In the order of the phase's controls.

        Raises
        ------
        ValueError
            For times outside of [begin, end].
        """
        return self._joined.control(self._fraction(t))[self._controls]

    def _fraction(self, t):
        """Return times as fractions of the phase."""
        times, slack = np.asarray(t, dtype=float), 1e-9 * self.end
        if not np.all((times >= self.begin - slack) & (times <= self.end + slack)):
            raise ValueError(
                f"t: expected times of the phase, between {self.begin:.6g} and {self.end:.6g}"
            )
        return np.clip((times - self.begin) / (self.end - self.begin or 1.0), 0, 1)


@dataclass(frozen=True, eq=False)
class PhasedExtremal:
    """An extremal of a `PhasedProblem`.

    Attributes
    ----------
    stated : tuple of Phase
        The phases as they were stated.
    joined : Extremal
        The extremal of the joined problem, with its multipliers and its log.
    """

    stated: tuple[Phase, ...]
    joined: Extremal

    @property
    def cost(self) -> float:
        """The cost J of all phases together."""
        return self.joined.cost

    @property
    def durations(self) -> tuple[float, ...]:
        """The durations of the phases."""
        end = dict(zip(self.joined.problem.state, self.joined.state(1.0)))
        durations = (joined_duration(phase, index) for index, phase in enumerate(self.stated))
        return tuple(float(end.get(T, T)) for T in durations)

    @property
    def duration(self) -> float:
        """The time of all phases together."""
        return sum(self.durations)

    @property
    def optimality(self) -> Optimality:
        """What is known beyond the necessary conditions."""
        return self.joined.optimality

    def certificate(self) -> Certificate:
        """Return the residuals of all conditions, in all phases and at the jumps.

        Returns
        -------
        Certificate
            Of the joined problem, computed from the trajectory alone.
        """
        return self.joined.certificate()

    @cached_property
    def phases(self) -> tuple[ExtremalPhase, ...]:
        """The phases in their order, with states, costates and controls in the user's time."""
        times = np.concatenate([[0.0], np.cumsum(self.durations)]).tolist()
        return tuple(
            self._phase(index, begin, end) for index, (begin, end) in enumerate(pairwise(times))
        )

    def _phase(self, index, begin, end):
        phase, problem = self.stated[index], self.joined.problem
        states = [problem.state.index(moving(y, index)) for y in phase.dynamics]
        controls = [problem.control.index(moving(u, index)) for u in phase.controls]
        beginnings = [problem.state.index(beginning(y, index)) for y in phase.dynamics if index]
        arcs = []
        for kinds, run in groupby(
            self.joined.arcs, key=lambda arc: tuple(arc[0][column] for column in controls)
        ):
            pieces = list(run)
            first, last = (begin + s * (end - begin) for s in (pieces[0][1], pieces[-1][2]))
            arcs.append((kinds if len(kinds) > 1 else kinds[0], first, last))
        return ExtremalPhase(begin, end, tuple(arcs), self.joined, states, beginnings, controls)

    def plot(self, axes=None) -> np.ndarray:
        """Draw states, controls and costates against time; dotted lines separate the phases.

        Parameters
        ----------
        axes : array of matplotlib.axes.Axes, optional
            Three Axes; new ones if left out.

        Returns
        -------
        ndarray of matplotlib.axes.Axes
            The Axes.
        """
        import matplotlib.pyplot as plt

        with plotting.style():
            axes = plt.subplots(3, 1, figsize=(5, 8.4), sharex=True)[1] if axes is None else axes
        axes = np.atleast_1d(axes).ravel()
        if len(axes) != 3:
            raise ValueError(f"axes: expected 3 Axes, got {len(axes)}")
        for ax, name in zip(axes, ("state", "control", "costate")):
            lines: dict[sp.Symbol, list] = {}
            for phase, stated in zip(self.phases, self.stated):
                t = np.linspace(phase.begin, phase.end, _POINTS)
                symbols = stated.controls if name == "control" else stated.dynamics
                for symbol, values in zip(symbols, getattr(phase, name)(t)):
                    # What has a jump between two phases is not joined across it.
                    lines.setdefault(symbol, []).extend([(t, values), ([np.nan], [np.nan])])
            for symbol, pieces in lines.items():
                shown = sp.latex(symbol)
                label = rf"$\psi_{{{shown}}}$" if name == "costate" else f"${shown}$"
                ax.plot(*map(np.concatenate, zip(*pieces)), label=label)
            for phase in self.phases[1:]:
                ax.axvline(phase.begin, color=plotting.GREY, linestyle=":")
            ax.set_ylabel(name)
            ax.legend(loc="best")
        axes[-1].set_xlabel("$t$")
        return axes

    def __repr__(self):
        durations = ", ".join(f"{duration:.12g}" for duration in self.durations)
        evidence = "" if self.optimality.proved else f", {self.optimality.summary}"
        return f"PhasedExtremal(cost={self.cost:.12g}, durations: {durations}{evidence})"
