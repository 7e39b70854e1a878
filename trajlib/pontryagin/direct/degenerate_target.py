"""Targets on which the gradient of a terminal equation vanishes, as x^2 = 0.

They have no normal, so that transversality says nothing; and an equation that holds to 1e-16 holds
at a distance of 1e-8 already. Newton's method for such an equation alone converges like a geometric
series, its gradient tending to zero; elsewhere it converges quadratically to a gradient that does
not vanish.
"""

import numpy as np

from trajlib.pontryagin.problem.errors import PontryaginError
from trajlib.pontryagin.problem.hypotheses import LINEAR_TARGET, TARGET
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Share of the way from the initial state that Newton's method begins before the end; its steps; and
# the share to which the gradient falls where it vanishes on the target.
BEFORE, STEPS, VANISHING = 0.01, 60, 1e-6


def refuse_degenerate_target(numeric: NumericProblem, states: np.ndarray) -> None:
    """Raise `PontryaginError` if the gradient of a terminal equation vanishes where a process ends.

    `states`: those of a process that ends on the target or near it, (N+1, n).
    """
    end = states[-1]
    span = np.max(np.abs(states - end), axis=0)
    for j in range(numeric.m):
        # Off the target in a direction that no symmetry of the equation prefers.
        point = end + BEFORE * span * (1 + 0.1 * np.arange(numeric.n))
        first = None
        for _ in range(STEPS):
            value, gradient = (part.full()[j] for part in numeric.target_value(point))
            size = float(np.linalg.norm(gradient))
            first = first or size
            if not size > VANISHING * first or not np.isfinite(size):
                break
            point = point - value[0] * gradient / size**2
        if first and size <= VANISHING * first:
            problem = numeric.problem if numeric.scaling is None else numeric.scaling.original
            raise PontryaginError(
                f"terminal: the gradient of {problem.terminal[j]} vanishes on the target, which has "
                "no normal there: the conditions at the end do not determine the process. Write "
                "equations whose gradients do not vanish, as x = 0 in place of x**2 = 0."
            )


NONLINEAR_TARGET = Hypothesis(
    "a terminal equation is nonlinear", lambda p: not LINEAR_TARGET.holds(p)
)
DEGENERATE_TARGET = Refusal(
    "target without a normal",
    "The gradient of a terminal equation vanishes on the target, so that transversality determines "
    "nothing.",
    "Theorem 5.1 of the problem book, regular targets",
    (TARGET, NONLINEAR_TARGET),
    PontryaginError,
    lambda numeric, search_result: refuse_degenerate_target(
        numeric, search_result.solutions[0][0].states
    ),
)
