"""Extremals of a problem: found, evaluated, shown, compared.

The way from the statement to an extremal: a discrete picture (`searching`, `transcription`), its
arcs (`structure`), Newton's method for the boundary value problem over these arcs (`polishing`,
`shooting`, `flow`).
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp

from trajlib.pontryagin.chattering import refuse_chattering
from trajlib.pontryagin.errors import NotUnique, WrongStructure
from trajlib.pontryagin.flow import STEADY
from trajlib.pontryagin.guesses import read_guess
from trajlib.pontryagin.numeric import NumericProblem
from trajlib.pontryagin.optimality import Optimality, theorem_with_discs
from trajlib.pontryagin.polishing import arc_lengths, polish
from trajlib.pontryagin.searching import (
    INTERVALS,
    escaped,
    finer_picture,
    refuse_endless,
    refuse_falling,
    search,
    settled_duration,
    with_controls,
)
from trajlib.pontryagin.second_order import along_extremal, of_picture, second_variation
from trajlib.pontryagin.sliding import in_turn, refuse_sliding, relaxed_picture
from trajlib.pontryagin.structure import Arc, detect, name, read_structure, readings
from trajlib.pontryagin.transcription import Picture, target_multipliers
from trajlib.pontryagin.units import large_states, solve_in_units


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
            from trajlib.pontryagin.proof import prove

            return prove(self.problem, self.arcs, self.state(0), self.costate(0), self.multiplier)
        return self._certificate if points is None else self._certified(points)

    @cached_property
    def _certificate(self):
        return self._certified(None)

    def _certified(self, points):
        from trajlib.pontryagin.certificate import certify

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

        def known(kind, reason):
            return Optimality(kind, reason, self._starts, self._found)

        proof = theorem_with_discs(self.problem)
        if proof and (self.normal or not proof[1]):
            return known("proved", proof[0])
        if not self.normal:
            return known("extremal", "abnormal: the second variation of the cost says nothing")
        if self._variation.sign > 0:
            return known(
                "locally minimal",
                "the second variation is positive"
                if self._variation.states is not None
                else "no variation keeps to the target to first order",
            )
        return known(
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
        return along_extremal(self._numeric, self, duration)

    def plot(self, axes=None):
        """Phase plane and time plots of states, controls, costates and switching function; returns
        the Axes."""
        from trajlib.pontryagin.drawing import draw_extremal

        return draw_extremal(self, axes)

    @cached_property
    def _nodes(self):
        """For each arc the motion at the ends of its steps, (size, steps+1)."""
        shot = self._shot
        return [
            flow.nodes(np.append(start, 0.0), shot.multiplier, length, steps).T[:-1]
            for flow, start, length, steps in zip(shot.flows, shot.starts, shot.lengths, shot.steps)
        ]

    def _along(self, t, what):
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
            value = what(flow, y)
            result = np.empty((len(value), len(times))) if result is None else result
            result[:, mask] = value
        return result[:, 0] if np.ndim(t) == 0 else result

    def __repr__(self):
        shown = ", ".join(f"{kind} [{begin:.6g}, {end:.6g}]" for kind, begin, end in self.arcs)
        return f"Extremal(cost={self.cost:.12g}, duration={self.duration:.12g}, arcs: {shown})"

    def _repr_markdown_(self):
        rows = "".join(
            f"| {kind_latex(kind)} | {begin:.9g} | {end:.9g} |\n" for kind, begin, end in self.arcs
        )
        case = r"normal, $\lambda_0 = 1$" if self.normal else r"abnormal, $\lambda_0 = 0$"
        return (
            f"$J = {self.cost:.12g}$, $t_k = {self.duration:.12g}$ ({case})\n\n"
            f"| arc | begin | end |\n|---|---|---|\n{rows}\n{str(self.optimality).capitalize()}.\n"
        )


def solve(problem, structure=None, guess=None):
    """An extremal of a problem: `Extremal`. Called as `problem.solve(...)`.

    `structure`: the arcs, as a list of "u-", "u+", "interior", "singular" (of tuples of them, for
    several controls); with |u| in the running cost also "zero", where u = 0. Found by itself if
    left out. `guess`: what to start from, an `Extremal` of a similar problem or a dict with any of
    "duration": number, and state or control: a number, a list of values at equal steps, or a
    function of time.

    The result satisfies the conditions of the maximum principle to about 1e-12: its own certificate
    holds. Beyond that `Extremal.optimality` says what is known. For linear plants with a convex
    cost and a given duration, and for the least time to a point at which a linear plant can be
    held, the extremal is proved optimal. Otherwise the search goes from several starts, leaves
    saddles and maxima along the second variation, and returns the best extremal it found; a better
    one is not excluded (see `compare`).

    Raises ValueError if a parameter has no value; `StartOnTarget`; `Infeasible` with a proof (also
    for a duration that is too short); `Unbounded`; `Chattering`; `WrongStructure` if the arcs
    cannot be joined to an extremal, `NotUnique` where a control or a free duration is left open;
    `NotConverged` if no process was found, which proves nothing. All of them are `PontryaginError`.
    Source: Theorem 5.1 of the problem book.

    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x, u = sp.symbols("x u")
    >>> turnpike = Problem({x: u}, {u: (-1, 1)}, {x: 1}, {x: sp.Rational(1, 2)}, running=x**2, duration=2)
    >>> turnpike.solve()
    Extremal(cost=0.375, duration=2, arcs: u- [0, 1], singular [1, 1.5], u+ [1.5, 2])
    """
    if problem.running.has(sp.Abs):
        from trajlib.pontryagin.absolute import solve_split, split

        pairs = split(problem)
        if pairs:
            return solve_split(problem, pairs, structure, guess)
    units = large_states(problem)
    if units:
        return solve_in_units(problem, units, structure, guess)
    numeric = NumericProblem(problem)
    kinds = None if structure is None else read_structure(numeric, structure)
    found = search(numeric, read_guess(numeric, guess), kinds)
    made = {}
    if kinds is not None:
        picture, _ = found.pictures[0]
        arcs = _given_arcs(kinds, picture)
        shot = polish(
            numeric, picture, arcs, settled_duration(numeric, picture), made, keep_structure=True
        )
        extremal = found_extremal(problem, numeric, shot, found.starts, found.found)
        reason = _refused(extremal)
        if reason:
            raise WrongStructure(reason)
        return extremal
    refuse_falling(numeric, found)
    reasons = []
    for picture, side in found.pictures:
        extremal = _joined(problem, numeric, picture, side, found, made, reasons)
        if extremal is not None:
            return extremal
    picture, side = found.pictures[0]
    relaxed = relaxed_picture(numeric, picture, side)
    if relaxed is not None:
        separate = with_controls(numeric, relaxed, side, in_turn(numeric, relaxed))
        refuse_sliding(numeric, picture, relaxed, separate)
        extremal = _joined(problem, numeric, separate, side, found, made, reasons)
        if extremal is not None:
            return extremal
    if settled_duration(numeric, picture) is None:
        refuse_endless(numeric, finer_picture(numeric, picture, side, 4) or picture, side)
    cost = -picture.cost if problem.maximise else picture.cost
    open_control = next((reason for reason in reasons if isinstance(reason, NotUnique)), None)
    if open_control:
        raise NotUnique(
            f"{open_control}. So many controls may be equally good, as where several motions must "
            "end at one moment and only the slowest sets it; one of them has a cost of about "
            f"{cost:.6g} (a discrete picture). To single one out, give a structure, or the control "
            "a small cost."
        )
    raise WrongStructure(
        "the arcs that the discrete solution shows could not be joined to an extremal: "
        + "; ".join(dict.fromkeys(map(str, reasons)))
        + ". Give the structure, or a guess; look at the "
        f"discrete cost {cost:.6g} to see whether an optimal process exists."
    )


def _given_arcs(kinds, picture):
    ends = np.concatenate([[0.0], np.cumsum(picture.lengths)])
    if min(picture.lengths) < 1e-6 * picture.duration:
        short = int(np.argmin(picture.lengths))
        raise WrongStructure(
            f"the arc {name(kinds[short])} (number {short + 1}) shrinks to nothing: the best "
            "process "
            "with these arcs does not have it. Leave it out, or leave the structure to solve()."
        )
    return [Arc(kind, begin, end) for kind, begin, end in zip(kinds, ends, ends[1:])]


def _joined(problem, numeric, picture, side, found, made, reasons):
    """A certified extremal next to the picture, found on finer and finer grids; None, with the
    reasons noted."""
    factor = 1
    while factor is not None:
        duration = settled_duration(numeric, picture)
        refuse_chattering(numeric, detect(numeric, picture), picture.states[-1], duration)
        for arcs in readings(numeric, picture):
            try:
                shot = polish(numeric, picture, arcs, duration, made)
                extremal = found_extremal(problem, numeric, shot, found.starts, found.found)
                reason = _refused(extremal)
            except WrongStructure as error:
                reason = error
            if not reason:
                break
            reasons.append(reason)
        if not reason:
            if extremal.optimality.proved or not extremal.normal or extremal._variation.sign > 0:
                return extremal
            if extremal._variation.sign == 0:
                # More time may change nothing to second order because it costs nothing more at all.
                if duration is None:
                    refuse_endless(numeric, picture, side)
                return extremal
            reason = "the extremal found is a saddle: the cost falls along its second variation"
            better = _beside(numeric, extremal, side)
            if better is not None:
                picture, factor = better, 1
                continue
            reasons.append(reason)
        factor = {1: 4, 4: 10, 10: None}[factor]
        if factor is not None:
            picture = finer_picture(numeric, picture, side, factor) or picture
    return None


def _refused(extremal):
    """Why an extremal is not to be returned: conditions that its own certificate finds violated; ""
    if all hold."""
    failures = extremal.certificate().failures()
    if not failures:
        return ""
    worst = extremal.certificate().worst
    return (
        f"the certificate of the arcs {', '.join(str(kind) for kind, _, _ in extremal.arcs)} fails "
        f"({', '.join(failures)}; {worst:.1e})"
    )


def _beside(numeric, extremal, side):
    """A discrete picture with less cost than an extremal that is a saddle, or None."""
    times = np.linspace(0, extremal.duration, INTERVALS + 1)
    sign = -1 if extremal.problem.maximise else 1
    picture = Picture(
        times,
        extremal.state(times).T,
        extremal.costate(times).T,
        extremal.control((times[1:] + times[:-1]) / 2).T,
        sign * extremal.cost,
    )
    variation = second_variation(
        numeric, of_picture(numeric, picture, target_multipliers(numeric, picture))
    )
    return escaped(numeric, picture, variation, side) if variation.sign < 0 else None


def found_extremal(problem, numeric, shot, starts, found):
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
    shown = [tuple("interior" if kind in STEADY else kind for kind in flow.kinds) for flow in flows]
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


def kind_latex(kind):
    if not isinstance(kind, str):
        return "(" + ", ".join(map(kind_latex, kind)) + ")"
    return {"u-": "$u_-$", "u+": "$u_+$", "zero": "$0$"}.get(kind, kind)
