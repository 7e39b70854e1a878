"""Discrete solutions that pass beyond a path constraint between their nodes.

Where no process keeps to a constraint and the duration is free, steps may become so long that the
nodes alone keep to it.
"""

import numpy as np

from trajlib.pontryagin.direct.transcription import DirectSolution
from trajlib.pontryagin.problem.errors import NotConverged
from trajlib.pontryagin.problem.numeric import NumericProblem, runge_kutta

# Steps into which an interval is cut, and the excess, as a share of the distance of the ends from
# the boundary, that is no error of the discretisation.
STEPS, EXCESS = 16, 0.02


def refuse_passing_beyond(numeric: NumericProblem, solution: DirectSolution) -> None:
    """Raise `NotConverged` if a solution violates a path constraint between its nodes."""
    if not numeric.path_orders:
        return
    step = runge_kutta(numeric).map(len(solution.controls))
    states, widths, samples = solution.states[:-1].T, np.diff(solution.times), []
    for _ in range(STEPS):
        states = step(states, solution.controls.T, widths[None] / STEPS)[0].full()
        samples.append(numeric.path_value.map(states.shape[1])(states)[0].full())
    values = np.stack(samples)
    ends = numeric.path_value.map(2)(solution.states[[0, -1]].T)[0].full()
    for j in range(len(numeric.path_orders)):
        if np.max(values[:, j]) > EXCESS * np.max(np.abs(ends[j])):
            problem = numeric.problem if numeric.scaling is None else numeric.scaling.original
            raise NotConverged(
                f"no process that keeps to {problem.path[j]} was found: the discrete solutions keep "
                "to it at their nodes, and pass beyond it between them. Nothing is proved by that: "
                "give a guess, or look whether any process can keep to it."
            )
