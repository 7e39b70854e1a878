"""Extremals of a problem: evaluated at any time, certified, shown."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajlib.pontryagin.indirect.drawing import draw_extremal
from trajlib.pontryagin.indirect.refinement import arc_lengths
from trajlib.pontryagin.problem.arcs import CONSTANT_ANGLES, arc_latex
from trajlib.pontryagin.problem.errors import WrongStructure
from trajlib.pontryagin.verification.certificate import certify
from trajlib.pontryagin.verification.optimality import Optimality, relaxed_sufficiency_theorem
from trajlib.pontryagin.verification.proof import prove
from trajlib.pontryagin.verification.second_variation import extremal_second_variation


@dataclass(frozen=True, eq=False)
class Extremal:
    """An extremal: a trajectory with a control and a costate that satisfy the conditions of the
    maximum principle.

    - `cost`, `duration`: J and t_k
    - `arcs`: [(kind, begin, end)], kind being "u-", "u+" (at a bound), "interior" or "singular", or
      "zero" (u = 0 where the cost holds |u|); with several controls a tuple of them
    - `switching_times`: the times between the arcs
    - `multiplier`: lambda_0, 1 in the normal case and 0 in the abnormal one (then |psi(0)| = 1)
    - `terminal_multipliers`: lambda_1, ..., lambda_m of the terminal equations
    - `residual`: the largest residual of the boundary value problem that was solved
    - `optimality`: what is known beyond the necessary conditions, `Optimality`: proved optimal,
      locally minimal, or best of the extremals found
    - `state(t)`, `costate(t)`, `control(t)`, `switching(t)` = dH/du, `hamiltonian(t)`
    """

    problem: object
    cost: float
    duration: float
    arcs: tuple
    multiplier: float
    terminal_multipliers: tuple
    residual: float
    _numeric: object
    _shot: object
    _starts: int = 1
    _found: int = 1

    @property
    def switching_times(self):
        return tuple(begin for _, begin, _ in self.arcs[1:])

    @property
    def normal(self):
        return self.multiplier > 0

    def state(self, t):
        """State at time t: an array (n,) for a number, (n, N) for an array of N times in [0,
        duration].

        Raises ValueError for times outside.
        """
        return self._along(t, lambda flow, y: y[: self._numeric.n])

    def costate(self, t):
        """Costate psi at time t, shaped like the state."""
        return self._along(t, lambda flow, y: y[self._numeric.n : 2 * self._numeric.n])

    def control(self, t):
        """Controls at time t, (k,) or (k, N); at a switching the value after it."""
        return self._along(t, lambda flow, y: flow.values("control", y, self.multiplier))

    def switching(self, t):
        """dH/du at time t, (k,) or (k, N): the switching functions of the controls in which H is
        linear."""
        return self._along(t, lambda flow, y: flow.values("slopes", y, self.multiplier))

    def hamiltonian(self, t):
        """The Pontryagin function at time t, a number or (N,)."""
        value = self._along(t, lambda flow, y: flow.values("hamiltonian", y, self.multiplier))
        return float(value[0]) if np.ndim(t) == 0 else value[0]

    def certificate(self, points=None, proved=False):
        """Evidence that this is an extremal, from the trajectory alone: `Certificate` (see
        `certify`).

        With `proved=True` a `Proof` in ball arithmetic that the exact extremal next to it is
        optimal, or the reason why there is none (see `proof.prove`). For linear plants and costs
        that are at most quadratic; needs python-flint.
        """
        if proved:
            return prove(self.problem, self.arcs, self.state(0), self.costate(0), self.multiplier)
        return self._certificate if points is None else self._certificate_at(points)

    @cached_property
    def _certificate(self):
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
    def optimality(self):
        """What is known beyond the necessary conditions: `Optimality`."""

        def optimality(kind, reason):
            return Optimality(kind, reason, self._starts, self._found)

        proof = relaxed_sufficiency_theorem(self.problem)
        if proof and (self.normal or not proof[1]):
            return optimality("proved", proof[0])
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
            else "the second variation vanishes in some direction",
        )

    @cached_property
    def _variation(self):
        duration = self._numeric.duration
        if duration is None and self._numeric.time_bounds_given:
            ends = np.array([self._numeric.shortest, self._numeric.longest])
            duration = (
                self.duration
                if np.min(np.abs(ends - self.duration)) < 1e-9 * (1 + self.duration)
                else None
            )
        return extremal_second_variation(self._numeric, self, duration)

    def plot(self, axes=None):
        """Phase plane and time plots of states, controls, costates and switching function; returns
        the Axes."""
        return draw_extremal(self, axes)

    @cached_property
    def _nodes(self):
        """For each arc the motion at the ends of its steps, (size, steps+1)."""
        shot = self._shot
        return [
            flow.nodes(np.append(start, 0.0), shot.multiplier, length, steps).T[:-1]
            for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps)
        ]

    def _along(self, t, evaluate):
        times = np.atleast_1d(np.asarray(t, dtype=float))
        if times.ndim != 1:
            raise ValueError(
                f"t: expected a number or a one-dimensional array, got shape {times.shape}"
            )
        slack = 1e-9 * (1 + self.duration)
        if not np.all((times >= -slack) & (times <= self.duration + slack)):
            raise ValueError(f"t: expected times between 0 and the duration {self.duration:.6g}")
        times = np.clip(times, 0, self.duration)
        begins = np.concatenate([[0.0], np.cumsum(self._shot.lengths)[:-1]])
        where = np.searchsorted(begins, times, side="right") - 1
        result = None
        for index in np.unique(where):
            flow, length = self._shot.flows[index], self._shot.lengths[index]
            steps, mask = self._shot.steps[index], where == index
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

    def __repr__(self):
        shown = ", ".join(f"{kind} [{begin:.6g}, {end:.6g}]" for kind, begin, end in self.arcs)
        return f"Extremal(cost={self.cost:.12g}, duration={self.duration:.12g}, arcs: {shown})"

    def _repr_markdown_(self):
        rows = "".join(
            f"| {arc_latex(kind)} | {begin:.9g} | {end:.9g} |\n" for kind, begin, end in self.arcs
        )
        case = r"normal, $\lambda_0 = 1$" if self.normal else r"abnormal, $\lambda_0 = 0$"
        return (
            f"$J = {self.cost:.12g}$, $t_k = {self.duration:.12g}$ ({case})\n\n"
            f"| arc | begin | end |\n|---|---|---|\n{rows}\n{str(self.optimality).capitalize()}.\n"
        )


def extremal_of_shot(problem, numeric, shot, starts, found):
    """An `Extremal` of a converged shot, with lambda_0 scaled to one in the normal case."""
    n = numeric.n
    largest = max(np.max(np.abs(start[n : 2 * n])) for start in shot.starts)
    normal = shot.multiplier > 1e-9 * largest
    scale = shot.multiplier if normal else np.linalg.norm(shot.starts[0][n : 2 * n])
    for start in shot.starts:
        start[n : 2 * n] /= scale
    shot.multiplier = 1.0 if normal else 0.0
    shot.terminal_multipliers = shot.terminal_multipliers / scale
    ends = [
        flow.nodes(np.append(start, 0.0), shot.multiplier, length, steps)[-1]
        for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps)
    ]
    times = [float(t) for t in np.concatenate([[0.0], np.cumsum(arc_lengths(shot))])]
    flows = [flow for i, flow in enumerate(shot.flows) if not i or flow is not shot.flows[i - 1]]
    shown = [
        tuple("interior" if kind in CONSTANT_ANGLES else kind for kind in flow.kinds)
        for flow in flows
    ]
    arcs = tuple(
        (kinds[0] if numeric.k == 1 else kinds, begin, end)
        for kinds, begin, end in zip(shown, times, times[1:])
    )
    cost = sum(end[-1] for end in ends) + float(numeric.final_value(ends[-1][:n]))
    extremal = Extremal(
        problem,
        float(-cost if problem.maximise else cost),
        times[-1],
        arcs,
        shot.multiplier,
        tuple(float(v) for v in shot.terminal_multipliers),
        shot.residual,
        numeric,
        shot,
        starts,
        found,
    )
    if problem.first_return and _passes_target(extremal):
        raise WrongStructure(
            "the trajectory with these arcs meets the target before its end, against first_return"
        )
    return extremal


def _passes_target(extremal):
    """Whether the single terminal equation changes its sign before the end."""
    between = extremal.state(np.linspace(0, extremal.duration, 402)[1:-1])
    values = extremal._numeric.target_value.map(400)(between)[0].full().ravel()
    largest = np.max(np.abs(values))
    return bool(np.min(values) < -1e-9 * largest and np.max(values) > 1e-9 * largest)
