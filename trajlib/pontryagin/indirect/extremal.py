"""Extremals of a problem: evaluated at any time, certified, shown."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Literal, overload

import numpy as np

from trajlib.pontryagin.indirect.drawing import draw_extremal
from trajlib.pontryagin.indirect.shooting import ShootingSolution
from trajlib.pontryagin.problem.arcs import BOUNDARY, arc_latex
from trajlib.pontryagin.problem.log import Log, current_log
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.times_of_process import times_of_process
from trajlib.pontryagin.verification.certificate import Certificate, certify
from trajlib.pontryagin.verification.optimality import Optimality, relaxed_sufficiency_theorem
from trajlib.pontryagin.verification.second_variation import extremal_second_variation

if TYPE_CHECKING:
    from trajlib.pontryagin.verification.proof import Proof


@dataclass(frozen=True, eq=False)
class Extremal:
    """A trajectory with control and costate that satisfies the maximum principle.

    Attributes
    ----------
    problem : Problem
        The problem that was solved.
    cost, duration : float
        J and t_k.
    arcs : tuple of tuple
        (kind, begin, end), kind being "u-", "u+" (at a bound), "interior", "singular", "boundary"
        (of a path constraint, numbered if there are several), or "zero" (u = 0 where the cost
        contains |u|); with several controls a tuple of them.
    multiplier : float
        lambda_0: 1 in the normal case, 0 in the abnormal one (then |psi(0)| = 1).
    terminal_multipliers : tuple of float
        lambda_1, ..., lambda_m of the terminal equations, then those of the terminal inequalities.
    residual : float
        The largest residual of the boundary value problem that was solved.
    jumps : tuple of tuple
        (path constraint, time, nu) where the costate may jump: psi(t+0) = psi(t-0) + nu dg/dy.
    log : Log
        What `solve` tried: starting guesses, lists of arcs, Newton's residuals, with their times.
    """

    problem: Statement
    cost: float
    duration: float
    arcs: tuple[tuple, ...]
    multiplier: float
    terminal_multipliers: tuple[float, ...]
    residual: float
    jumps: tuple[tuple, ...]
    _numeric: NumericProblem
    _shot: ShootingSolution
    _starts: int = 1
    _processes: int = 1
    _proof: str | None = None
    log: Log = field(default_factory=current_log)

    @property
    def switching_times(self) -> tuple[float, ...]:
        """The times between the arcs."""
        return tuple(begin for _, begin, _ in self.arcs[1:])

    @property
    def normal(self) -> bool:
        """Whether lambda_0 > 0."""
        return self.multiplier > 0

    def state(self, t) -> np.ndarray:
        """Return the state at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            As exact as the nodes of the integrator.

        Raises
        ------
        ValueError
            For times outside of [0, duration].
        """
        return self._along(t, lambda flow, y: y[: self._numeric.n])

    def costate(self, t) -> np.ndarray:
        """Return the costate psi at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (n,) or (n, N)
            With lambda_0 = `multiplier`.
        """
        return self._along(t, lambda flow, y: y[self._numeric.n : 2 * self._numeric.n])

    def control(self, t) -> np.ndarray:
        """Return the controls at given times; at a switching the value after it.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (k,) or (k, N)
            The controls in the order of the problem.
        """
        return self._along(t, lambda flow, y: flow.values("control", y, self.multiplier))

    def switching(self, t) -> np.ndarray:
        """Return dH/du at given times: the switching function of a control in which H is linear.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (k,) or (k, N)
            One row for each control.
        """
        return self._along(t, lambda flow, y: flow.values("slopes", y, self.multiplier))

    @property
    def touches_boundary(self) -> bool:
        """Whether the trajectory touches the boundary of a path constraint."""
        kinds = ((kind,) if isinstance(kind, str) else kind for kind, _, _ in self.arcs)
        return bool(self.jumps) or any(k.startswith(BOUNDARY) for arc in kinds for k in arc)

    def path_multiplier(self, t) -> np.ndarray:
        """Return the multipliers eta of the path constraints at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        ndarray, shape (c,) or (c, N)
            Zero off the boundaries; psi' = -dH/dy + sum of eta_j dg_j/dy.
        """
        count = len(self.problem.path)

        def multipliers(flow, y):
            result = np.zeros((count, y.shape[1]))
            if flow.boundary is not None:
                result[flow.boundary] = flow.values("path multiplier", y, self.multiplier)
            return result

        return self._along(t, multipliers)

    def hamiltonian(self, t) -> float | np.ndarray:
        """Return the Pontryagin function H at given times.

        Parameters
        ----------
        t : float or array_like, shape (N,)
            Times in [0, duration].

        Returns
        -------
        float or ndarray, shape (N,)
            Constant along the extremal; zero for a free final time.
        """
        value = self._along(t, lambda flow, y: flow.values("hamiltonian", y, self.multiplier))
        return float(value[0]) if np.ndim(t) == 0 else value[0]

    @overload
    def certificate(
        self, points: int | None = None, proved: Literal[False] = False
    ) -> Certificate: ...

    @overload
    def certificate(self, points: int | None = None, *, proved: Literal[True]) -> "Proof": ...

    def certificate(self, points: int | None = None, proved: bool = False) -> "Certificate | Proof":
        """Return evidence that this is an extremal, computed from the trajectory alone.

        Parameters
        ----------
        points : int, optional
            Number of panels on an arc; see `certify`.
        proved : bool, optional
            Whether to prove in ball arithmetic that the exact extremal next to it is optimal, for
            linear plants and costs that are at most quadratic; needs python-flint.

        Returns
        -------
        Certificate or Proof
            The residuals of all conditions and what is known beyond them; with `proved` the proof,
            or the reason why there is none.
        """
        if proved:
            # Proofs load on demand: no extremal needs them.
            from trajlib.pontryagin.verification.proof import prove

            return prove(self.problem, self.arcs, self.state(0), self.costate(0), self.multiplier)
        residuals = self._residuals if points is None else self._certificate_at(points)
        return replace(residuals, optimality=self.optimality)

    @cached_property
    def _residuals(self):
        return self._certificate_at(None)

    def _certificate_at(self, points):
        return certify(
            self.problem,
            self.state,
            self.costate,
            self.control,
            self.duration,
            self.switching_times,
            multiplier=self.multiplier,
            arcs=[kind for kind, _, _ in self.arcs],
            points=points,
        )

    @cached_property
    def optimality(self) -> Optimality:
        """What is known beyond the necessary conditions: proved, locally minimal, or best found."""

        def optimality(kind, reason):
            return Optimality(kind, reason, self._starts, self._processes)

        if self._proof:
            return optimality("proved", self._proof)
        proof = relaxed_sufficiency_theorem(self.problem)
        if proof and (self.normal or not proof[1]):
            return optimality("proved", proof[0])
        if self.touches_boundary:
            return optimality(
                "extremal",
                "whether it is a local minimum is not tested along the boundary of a path constraint",
            )
        if not self.normal:
            return optimality("extremal", "abnormal: the second variation of the cost says nothing")
        if self._variation.sign > 0:
            return optimality(
                "locally minimal",
                "the second variation is positive"
                if self._variation.states is not None
                else "no variation keeps to the target to first order",
            )
        return optimality(
            "extremal",
            "the second variation is negative in some direction"
            if self._variation.sign < 0
            else "the second variation is zero in some direction, to within its error",
        )

    @cached_property
    def _variation(self):
        """The second variation along the extremal; at a bound of the duration this is fixed."""
        duration = self._numeric.duration
        if duration is None and self._numeric.time_bounds_given:
            ends = np.array([self._numeric.shortest, self._numeric.longest])
            duration = (
                self.duration
                if np.min(np.abs(ends - self.duration)) < 1e-9 * (1 + self.duration)
                else None
            )
        return extremal_second_variation(self._numeric, self, duration)

    def plot(self, axes=None) -> np.ndarray:
        """Draw the phase plane, and states, controls, costates and switching functions against time.

        Parameters
        ----------
        axes : array of matplotlib.axes.Axes, optional
            Three Axes, or four with the phase plane first, for two states or more; new ones if left
            out.

        Returns
        -------
        ndarray of matplotlib.axes.Axes
            The Axes.
        """
        return draw_extremal(self, axes)

    @cached_property
    def _nodes(self):
        """For each arc the trajectory at the ends of its steps, (size, steps+1)."""
        shot = self._shot
        return [
            flow.nodes(np.append(start, 0.0), shot.multiplier, length, steps).T[:-1]
            for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps)
        ]

    def _along(self, t, evaluate):
        """Evaluate a function of (flow, y) at times."""
        times = self._times(t)
        begins = np.concatenate([[0.0], np.cumsum(self._shot.lengths)[:-1]])
        segment = np.searchsorted(begins, times, side="right") - 1
        result = None
        for index in np.unique(segment):
            flow, length = self._shot.flows[index], self._shot.lengths[index]
            steps, mask = self._shot.steps[index], segment == index
            inside = np.clip(times[mask] - begins[index], 0, length)
            node = np.minimum((inside / length * steps).astype(int), steps - 1)
            # One step of the integrator from the node before: as exact as the nodes themselves.
            start = np.vstack([self._nodes[index][:, node], np.zeros(len(node))])
            y = flow.step.map(len(node))(
                start, self._shot.multiplier, inside - node * length / steps
            ).full()[:-1]
            value = evaluate(flow, y)
            result = np.empty((len(value), len(times))) if result is None else result
            result[:, mask] = value
        return result[:, 0] if np.ndim(t) == 0 else result

    def _times(self, t):
        return times_of_process(t, self.duration)

    def __repr__(self):
        shown = ", ".join(f"{kind} [{begin:.6g}, {end:.6g}]" for kind, begin, end in self.arcs)
        evidence = "" if self.optimality.proved else f", {self.optimality.summary}"
        return f"Extremal(cost={self.cost:.12g}, duration={self.duration:.12g}, arcs: {shown}{evidence})"

    def _repr_markdown_(self):
        rows = "".join(
            f"| {arc_latex(kind)} | {begin:.9g} | {end:.9g} |\n".replace("inf", r"$\infty$")
            for kind, begin, end in self.arcs
        )
        case = r"normal, $\lambda_0 = 1$" if self.normal else r"abnormal, $\lambda_0 = 0$"
        duration = f"{self.duration:.12g}".replace("inf", r"\infty")
        optimality = str(self.optimality)
        return (
            f"$J = {self.cost:.12g}$, $t_k = {duration}$ ({case})\n\n"
            f"| arc | begin | end |\n|---|---|---|\n{rows}\n{optimality[0].upper()}{optimality[1:]}.\n"
        )
