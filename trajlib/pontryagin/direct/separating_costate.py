"""Targets that a costate separates from all states that can be reached.

For a linear plant and a given time all states that can be reached lie on one side of a hyperplane,
and the target on the other: q^T (G y(T) - d) > 0 for the control that minimises it.
"""

import numpy as np

from trajlib.pontryagin.direct.free_duration import least_time
from trajlib.pontryagin.direct.infeasibility import linear_plant, linear_target
from trajlib.pontryagin.problem.errors import Infeasible
from trajlib.pontryagin.problem.hypotheses import (
    GIVEN_START,
    LINEAR_TARGET,
    RELAXED_LINEAR_PLANT,
)
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal
from trajlib.pontryagin.verification.optimality import target_can_be_held


def _refuse_separated(numeric, search):
    """Raise `Infeasible` if the target is separated from all states reachable in the time."""
    if not search.distance_text or search.structure:
        return
    duration, end = search.nearest
    longest = numeric.duration if numeric.duration is not None else numeric.longest
    if duration != longest or not _is_separated(numeric, duration, end):
        return
    text = (
        f"no admissible control leads to the target in the time {numeric.user_time(duration):.6g}: a costate "
        f"separates it from all states that can be reached; {search.distance_text}"
    )
    shortest = least_time(numeric) if numeric.duration is not None else None
    if shortest is not None and shortest > numeric.duration:
        raise Infeasible(
            f"the duration {numeric.user_time(duration):.6g} is too short: the least time in which the target is "
            f"reached is {numeric.user_time(shortest):.6g}. {text[0].upper() + text[1:]}."
        )
    raise Infeasible(text + ". Try another duration, or a free one.")


def _is_separated(numeric, duration, final_state):
    """Check whether a hyperplane separates the target from all states reachable at a time.

    `final_state`: the reachable state closest to the target. False where the separation is not
    clear of errors of integration.
    """
    from scipy.linalg import expm

    G, d = linear_target(numeric.problem)
    A, B, c = linear_plant(numeric.angle_relaxation.problem)
    residual = G @ final_state - d
    n, panels = len(A), 2000
    # psi(T - s) = e^(A^T s) G^T q on a grid; (c, 1) as a further state of the plant.
    extended = np.zeros((n + 1, n + 1))
    extended[:n, :n], extended[:n, n] = A, c
    step, row = expm(extended * duration / panels), np.append(residual @ G, 0.0)
    rows = [row]
    for _ in range(panels):
        row = row @ step
        rows.append(row)
    least = numeric.angle_relaxation.least(np.array(rows)[:, :n] @ B)
    if not np.isfinite(least).all():
        return False  # a control without bounds leads beyond every hyperplane
    gap = (
        rows[-1] @ np.append(numeric.start, 1.0)
        - residual @ d
        + duration * (np.sum(least) - (least[0] + least[-1]) / 2) / panels
    )
    return bool(np.isfinite(gap) and gap > 0.1 * residual @ residual > 0)


TIME_GIVEN_OR_HELD = Hypothesis(
    "the duration is given, or the target is a point at which the plant can be held",
    lambda p: not p.free_time or target_can_be_held(p),
)
SEPARATING_COSTATE = Refusal(
    "separating costate",
    "A hyperplane separates the target from all states that can be reached in the time.",
    "convexity of the reachable set; trajlib.pontryagin.direct.separating_costate",
    (LINEAR_TARGET, GIVEN_START, RELAXED_LINEAR_PLANT, TIME_GIVEN_OR_HELD),
    Infeasible,
    _refuse_separated,
)
