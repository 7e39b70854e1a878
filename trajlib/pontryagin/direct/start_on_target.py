"""Initial states that satisfy the terminal equations, where the final time is free."""

import numpy as np

from trajlib.pontryagin.problem.errors import StartOnTarget
from trajlib.pontryagin.problem.hypotheses import FREE_TIME, GIVEN_START, NO_FIRST_RETURN, TARGET
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

ANY_TIME = Hypothesis(
    "no shortest time is given",
    lambda p: not isinstance(p.duration, tuple) or p.duration[0] <= NumericProblem.SHORTEST,
)


def _refuse_start_on_target(numeric):
    values = numeric.target_value(numeric.start)[0].full().ravel()
    if np.max(np.abs(values)) <= 1e-12 * (1 + np.max(np.abs(numeric.start))):
        raise StartOnTarget(
            "the initial state satisfies the terminal conditions already: the process ends at "
            "once, after zero time. For the first return to the target after it has been left, "
            "state the problem with first_return=True."
        )


START_ON_TARGET = Refusal(
    "initial state on the target",
    "The process ends after zero time if the initial state satisfies the terminal equations.",
    "definition of the final time, (5.2) of the problem book",
    (FREE_TIME, TARGET, GIVEN_START, NO_FIRST_RETURN, ANY_TIME),
    StartOnTarget,
    _refuse_start_on_target,
)
