"""Scaling of states whose initial values are large numbers.

Residuals are judged against the terms that cancel in an equation up to a size of CANCELLING; a
state far beyond it (a volume of 12000 cubic millimetres) leaves rounding errors that look like a
wrong structure. x = s X with a power of two s changes no digit of the equations, and psi = Psi/s.
"""

from copy import copy
from dataclasses import dataclass, replace

import numpy as np

from trajlib.pontryagin.direct.guesses import read_guess, refuse_start_on_target
from trajlib.pontryagin.direct.infeasibility import refuse_infeasible
from trajlib.pontryagin.indirect.extremal import Extremal, extremal_of_shot
from trajlib.pontryagin.indirect.shooting import CANCELLING, build_flows
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class StateScaling:
    """The scaling x = s X of a problem.

    Attributes
    ----------
    numeric : NumericProblem
        The original problem.
    problem : Statement
        For the scaled states, under the same names.
    scales : ndarray, shape (n,)
        Powers of two, 1 for states that are not scaled.
    """

    numeric: NumericProblem
    problem: Statement
    scales: np.ndarray

    def structure(self, structure):
        """Return the arcs, which are the same."""
        return structure

    def guess(self, guess):
        """Return a guess for the scaled states."""
        start = read_guess(self.numeric, guess)
        if start is None:
            return None
        duration, states, controls = start
        return {
            "duration": duration,
            **dict(zip(self.problem.state, (states / self.scales).T)),
            **dict(zip(self.problem.control, controls.T)),
        }

    def restore(self, extremal: Extremal) -> Extremal:
        """Return the extremal in the original states."""
        shot, n = copy(extremal._shot), self.numeric.n
        shot.flows = build_flows(self.numeric, [flow.kinds for flow in shot.flows], {})
        shot.starts = [
            np.concatenate([y[:n] * self.scales, y[n : 2 * n] / self.scales, y[2 * n :]])
            for y in shot.starts
        ]
        return extremal_of_shot(self.numeric, shot, extremal._starts, extremal._processes)


def scale_large_states(problem: Statement) -> StateScaling | None:
    """Scale the states with initial values beyond CANCELLING; return None if there are none."""
    start = {x: abs(float(v)) for x, v in problem.initial.items() if v is not None and v.is_number}
    scales = {x: 2 ** round(np.log2(v)) for x, v in start.items() if v > CANCELLING}
    if not scales:
        return None
    numeric = NumericProblem(problem)
    # Errors about the ends show numbers in the user's units, so they are raised before scaling.
    refuse_start_on_target(numeric)
    refuse_infeasible(numeric)
    return StateScaling(
        numeric,
        _scaled(problem, scales),
        np.array([float(scales.get(x, 1)) for x in problem.state]),
    )


def _scaled(problem, scales):
    """Return the same problem for x = s X, under the same names."""

    def substituted(e):
        return e.subs({x: s * x for x, s in scales.items()}, simultaneous=True)

    return replace(
        problem,
        dynamics={x: substituted(f) / scales.get(x, 1) for x, f in problem.dynamics.items()},
        initial={x: v if v is None else v / scales.get(x, 1) for x, v in problem.initial.items()},
        terminal=[substituted(g) for g in problem.terminal],
        running=substituted(problem.running),
        final=substituted(problem.final),
    )
