"""Optimal control problems in phases, joined to one problem on the unit interval.

In phase k, of the duration T_k, y' = f_k(y, u) with bounds, constraints and a running cost of its own. At its end
terminal equations may hold, and the next phase begins at y(t+0) = j_k(y(t-0)). All phases run side by side in
s = (t - t_k) / T_k:

    dz_k/ds = T_k f_k(z_k + p_k, u_k),   p_k' = 0,   T_k' = 0,   0 <= s <= 1,
    z_k(0) = 0,   p_k+1 = j_k(z_k(1) + p_k),                    J = phi_0 + sum of T_k int_0^1 f_0k ds,

where p_k, free, is the state at the beginning of phase k, and T_k is free where the duration is (Betts, Practical
Methods for Optimal Control, 2010, section 3.7). So every theorem and the certificate of one problem hold for the
phases. The costate of z_k is psi in phase k, and transversality becomes the matching conditions

    psi(t-0) = (dj/dy)^T psi(t+0) - (dg/dy)^T nu   with the multipliers nu of terminal equations g = 0 of the phase,
    H_k = 0   in a phase of free duration.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib._arguments.symbols import exact_decimals, join_names, read_expression
from trajlib.pontryagin.optimal_control import Problem
from trajlib.pontryagin.phase import Phase, beginning, joined_duration, moving
from trajlib.pontryagin.problem.arguments import read_initial
from trajlib.pontryagin.problem.errors import PontryaginError, Unbounded

if TYPE_CHECKING:
    from trajlib.pontryagin.phased_extremal import PhasedExtremal

# Share of the cost by which it must fall with longer phases to be more than an error of the grid.
FALLS = 1e-3


class PhasedProblem:
    """An optimal control problem of several phases with jumps between them.

    Parameters
    ----------
    phases : list of Phase
        In their order. States and controls of two phases that have one name are the same quantity;
        the dynamics may differ, and so may the lists of states.
    initial : dict
        {state of the first phase: value at t = 0}, None for a free one.
    final : sympy.Expr, optional
        Cost of the state at the end of the last phase. If neither this nor a running cost is given,
        the cost is the time.
    maximise : bool, optional
        Whether the cost is to be as large as possible.

    Attributes
    ----------
    joined : Problem
        The same problem on the unit interval, with the states `y^(k)`, reckoned from the beginning
        of phase k, `y^(k,0)` at this beginning and the durations `T^(k)`. Its `conditions()`,
        `explain()` and `solve_direct()` are those of all phases together.

    Raises
    ------
    TypeError, ValueError
        If an argument is not of this form, or a phase begins with a state of unknown value.

    Notes
    -----
    Source: Betts, Practical Methods for Optimal Control (2010), section 3.7; the conditions at the
    jumps are in the head of the module.

    Examples
    --------
    The fastest drive over one metre, where the second half is slippery and half the brake is left:
    the drive brakes already on the first half.

    >>> import sympy as sp
    >>> x, v, u = sp.symbols("x v u")
    >>> dry = Phase({x: v, v: u}, {u: (-1, 1)}, [x - sp.Rational(1, 2)])
    >>> slippery = Phase({x: v, v: u}, {u: (-sp.Rational(1, 2), 1)}, [x - 1, v])
    >>> drive = PhasedProblem([dry, slippery], {x: 0, v: 0}).solve()
    >>> drive
    PhasedExtremal(cost=2.43915758876, durations: 1.02494402638, 1.41421356237, locally minimal, best of 7 starts)
    >>> [(kind, round(begin, 6)) for kind, begin, end in drive.phases[0].arcs]
    [('u+', 0.0), ('u-', 0.866025)]
    """

    def __init__(
        self,
        phases: Sequence[Phase],
        initial: Mapping,
        final: sp.Expr | None = None,
        maximise: bool = False,
    ):
        if isinstance(phases, Phase) or not isinstance(phases, Sequence) or len(phases) < 2:
            raise TypeError(f"phases: expected a list of two phases or more, got {phases!r}")
        if stray := [p for p in phases if not isinstance(p, Phase)]:
            raise TypeError(f"phases: expected Phase objects, got {stray[0]!r}")
        if phases[-1].jump:
            raise ValueError("phases: the last phase has a jump, and nothing follows it")
        self.phases, self.initial = tuple(phases), read_initial(initial)
        self.final = None if final is None else exact_decimals(read_expression(final, "final"))
        self.maximise = maximise
        self.joined = self._join()

    def solve(
        self,
        guess: Sequence[Mapping] | None = None,
        starts: int | None = None,
        time_limit: float | None = None,
        progress: bool | None = None,
    ) -> "PhasedExtremal":
        """Find an extremal: the durations, and states, controls and costates of each phase.

        Parameters
        ----------
        guess : list of dict, optional
            For each phase {"duration": number, state or control: number or list of values at equal
            steps}, any of them.
        starts, time_limit, progress : optional
            As for `Problem.solve`.

        Returns
        -------
        PhasedExtremal
            Satisfies the maximum principle in each phase and the matching conditions between them.

        Raises
        ------
        PontryaginError
            As `Problem.solve`; states of phase k are called `y^(k)` there.
        """
        # The solvers load with it.
        from trajlib.pontryagin.phased_extremal import PhasedExtremal

        joined = None if guess is None else self._joined_guess(guess)
        extremal = PhasedExtremal(
            self.phases, self.joined.solve(None, joined, starts, time_limit, progress)
        )
        self._refuse_growing_durations(extremal)
        return extremal

    def _join(self):
        dynamics, controls, initial, terminal, path = {}, {}, {}, [], []
        running, before = sp.Integer(0), {}
        least_time = self.final is None and all(p.running is None for p in self.phases)
        if least_time and not any(phase.free_duration for phase in self.phases):
            raise ValueError(
                "running, final: expected a cost, since the durations of all phases are given"
            )
        for index, phase in enumerate(self.phases):
            duration, own = joined_duration(phase, index), self._substitution(index)
            if phase.free_duration:
                low, high = phase.duration or (0, None)
                dynamics[duration], initial[duration] = sp.Integer(0), None
                terminal += [duration >= low] + ([] if high is None else [duration <= high])
            for y, rate in phase.dynamics.items():
                z, p = moving(y, index), beginning(y, index)
                dynamics[z], initial[z] = duration * _with(rate, own), sp.Integer(0)
                if index:
                    dynamics[p], initial[p] = sp.Integer(0), None
                    terminal.append(p - self._after_jump(index, y, before))
            if not index:
                self._check_initial()
                initial |= {moving(y, 0): value for y, value in self.initial.items()}
            for u, bounds in phase.controls.items():
                controls[moving(u, index)] = tuple(_with(b, own) for b in bounds)
            cost = sp.Integer(1) if least_time else phase.running or sp.Integer(0)
            running += duration * _with(cost, own)
            terminal += [_with(g, own) for g in phase.terminal]
            path += [_with(g, own) for g in phase.path]
            before = own
        final = sp.Integer(0) if self.final is None else _with(self.final, before)
        return Problem(
            dynamics, controls, initial, terminal, running, final, 1, self.maximise, path=path
        )

    def _check_initial(self):
        first = set(self.phases[0].dynamics)
        if set(self.initial) != first:
            odd = join_names(set(self.initial) ^ first)
            raise ValueError(
                f"initial: expected the states of the first phase, {join_names(first)}, each with "
                f"its value or None; look at {odd}"
            )

    def _after_jump(self, index, y, before):
        """Return the value with which state `y` begins phase `index`."""
        previous = self.phases[index - 1]
        if stray := set(previous.jump) - set(self.phases[index].dynamics):
            raise ValueError(
                f"jump: {join_names(stray)} of phase {index} is no state of phase {index + 1}"
            )
        if y not in previous.jump and y not in previous.dynamics:
            raise ValueError(
                f"jump: {y} begins in phase {index + 1}; give its value there in the jump of phase "
                f"{index}"
            )
        return _with(previous.jump.get(y, y), before)

    def _substitution(self, index):
        phase = self.phases[index]
        states = {y: moving(y, index) + beginning(y, index) for y in phase.dynamics}
        return states | {u: moving(u, index) for u in phase.controls}

    def _joined_guess(self, guess):
        """Return a guess for `joined`; read there."""
        if isinstance(guess, Mapping) or len(guess) != len(self.phases):
            raise ValueError(f"guess: expected a list of {len(self.phases)} dicts, one for a phase")
        result = {}
        for index, (phase, values) in enumerate(zip(self.phases, guess)):
            for key, value in values.items():
                if key == "duration":
                    result |= {joined_duration(phase, index): value} if phase.free_duration else {}
                elif key in phase.controls or (key in phase.dynamics and not index):
                    result[moving(key, index)] = value
                elif key in phase.dynamics:
                    first = value[0] if isinstance(value, Sequence) else value
                    result[beginning(key, index)] = first
                    if isinstance(value, Sequence):
                        result[moving(key, index)] = [v - first for v in value]
                else:
                    raise ValueError(
                        f"guess: {key!r} is no state or control of phase {index + 1}, and not "
                        '"duration"'
                    )
        return result

    def _refuse_growing_durations(self, extremal):
        """Raise `Unbounded` if the cost falls with twice the durations, and further with four times.

        Where no duration has a bound, an infimum that is not attained is approached by ever longer
        phases; the last of them nearly satisfies all conditions, but the second variation is not
        positive.
        """
        free = [index for index, phase in enumerate(self.phases) if phase.duration is None]
        if not free or extremal.optimality.kind != "extremal":
            return
        guess = [
            dict(zip(stated.dynamics, phase.state(_grid(phase)).tolist()))
            | dict(zip(stated.controls, phase.control(_grid(phase)).tolist()))
            for stated, phase in zip(self.phases, extremal.phases)
        ]
        costs, sign = [extremal.cost], -1 if self.maximise else 1
        for factor in (2, 4):
            phases = [
                replace(phase, duration=factor * duration) if index in free else phase
                for index, (phase, duration) in enumerate(zip(self.phases, extremal.durations))
            ]
            longer = PhasedProblem(phases, self.initial, self.final, self.maximise)
            try:
                costs.append(longer.joined.solve_direct(guess=longer._joined_guess(guess)).cost)
            except PontryaginError:
                return
            if not sign * (costs[-2] - costs[-1]) > FALLS * abs(costs[-2]):
                return
        raise Unbounded(
            "the cost improves with ever longer phases: it is "
            f"{costs[0]:.4g}, {costs[1]:.4g} and {costs[2]:.4g} with {extremal.duration:.4g} units of time, "
            "twice and four times as many. Give durations, or bounds for them."
        )

    def __repr__(self):
        return f"PhasedProblem({len(self.phases)} phases, final={self.final})"


def _grid(phase):
    return np.linspace(phase.begin, phase.end, 81)


def _with(expression, values):
    return expression.subs(values, simultaneous=True)
