"""Discrete solutions that pass beyond a path constraint between their nodes.

Where no process keeps to a constraint and the duration is free, steps may become so long that the
nodes alone keep to it.
"""

import numpy as np

from trajlib.pontryagin.problem.errors import NotConverged
from trajlib.pontryagin.problem.hypotheses import PATH
from trajlib.pontryagin.problem.numeric import runge_kutta
from trajlib.pontryagin.problem.steps import Refusal

# Steps into which an interval is cut, and the excess, as a share of the distance of the ends from
# the boundary, that is no error of the discretisation.
STEPS, EXCESS = 16, 0.02


def _refuse_passing_beyond(numeric, solution, _side):
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


PASSING_BEYOND = Refusal(
    "discrete solutions that pass beyond a path constraint",
    "They keep to it at their nodes and violate it between them, so that no process was found.",
    "integration between the nodes",
    (PATH,),
    NotConverged,
    _refuse_passing_beyond,
)
