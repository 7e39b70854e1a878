"""Free durations: the best one, or the reason why there is none."""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.descent import finer_solution
from trajlib.pontryagin.direct.guesses import starting_guesses
from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    PATIENCE,
    DirectSolution,
    Transcription,
)
from trajlib.pontryagin.problem.errors import NotUnique, Unbounded
from trajlib.pontryagin.problem.hypotheses import (
    COST_OTHER_THAN_TIME,
    FREE_TIME,
    LINEAR_PLANT,
    LINEAR_TARGET,
    NO_FIRST_RETURN,
    UNCONSTRAINED,
)
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Decrease of the cost, as a share of it, that is more than the error of a discrete solution.
FALLS = 1e-3
# A free duration that changes by a smaller share from few intervals to many is not an effect of the
# steps.
SETTLED = 0.05


def fixed_duration(numeric: NumericProblem, solution: DirectSolution) -> float | None:
    """Return the duration if it is given or lies at a bound of the user's, None if it is free.

    Raises `Unbounded` where a free duration reached the bounds that it has by default.
    """
    if numeric.duration is not None:
        return numeric.duration
    EXTREME_DURATION.check(numeric, solution)
    if numeric.time_bounds_given:
        for bound in (numeric.shortest, numeric.longest):
            if abs(solution.duration - bound) <= 1e-6 * (1 + bound):
                return bound
    return None


def _refuse_extreme_duration(numeric, solution):
    T, low, high = solution.duration, numeric.shortest, numeric.longest
    if T <= 1.5 * low:
        raise Unbounded(
            f"the best duration tends to zero (it ran into {numeric.user_time(low):g}, with a cost of "
            f"{numeric.user_cost(solution.cost):.6g}): the infimum is approached by ever shorter "
            "processes and not attained. Bound the controls, or give a duration; if processes as "
            "short as that are meant, choose a smaller unit of time."
        )
    if T >= high * (1 - 1e-6):
        raise Unbounded(
            f"the best duration grows beyond every bound (it ran into {numeric.user_time(high):g}): there is no best "
            "process. Give a duration, or bounds for it; for a process that ends when it first "
            "meets the target, state it with first_return=True."
        )


def _refuse_any_duration(numeric):
    problem = numeric.problem
    slopes = sp.Matrix(problem.field).jacobian([*problem.state, *problem.control])
    n = len(problem.state)
    unbounded = [
        n + j for j, pair in enumerate(problem.controls.values()) if pair == (-sp.oo, sp.oo)
    ]
    A, B = slopes[:, :n], slopes.extract(range(n), unbounded)
    if unbounded and sp.Matrix.hstack(*(A**i * B for i in range(n))).rank() == n:
        names = ", ".join(str(u) for u, pair in problem.controls.items() if pair == (-sp.oo, sp.oo))
        raise Unbounded(
            f"the least time is not attained: {names} without bounds leads the plant, which is "
            "controllable, to the target in any time t > 0, however short. Bound the controls, or "
            "give a cost that grows with them."
        )


def _refuse_falling_cost(numeric, search_result):
    """Raise `Unbounded` if the cost falls with twice the duration, and further with four times.

    Then nothing in the solution is stationary but the errors of its steps, and joining its arcs
    takes minutes and fails. With longer steps it has another duration: where the duration is the
    same, nothing has to be tried.
    """
    solution, side = search_result.solutions[0]
    if fixed_duration(numeric, solution) is not None:
        return
    if any(
        abs(duration - solution.duration) < SETTLED * solution.duration
        for duration in search_result.coarse_durations
    ):
        return
    costs = [solution.cost]
    for factor in (2, 4):
        result = _solution_with_duration(numeric, solution, side, factor, PATIENCE)
        if not isinstance(result, DirectSolution) or not result.cost < costs[-1] - FALLS * abs(
            costs[-1]
        ):
            return
        costs.append(result.cost)
    refuse_unbounded_duration(numeric, solution, side)


def _solution_with_duration(numeric, solution, side, factor, patience=400):
    """Return the solution or failure for another duration, with steps of the same length."""
    duration = factor * solution.duration
    fixed = NumericProblem(replace(numeric.problem, duration=duration))
    programme = Transcription(
        fixed, int(np.ceil(factor * len(solution.controls))), side=side, patience=patience
    )
    return programme.solve((duration, solution.states, solution.controls))


def refuse_unbounded_duration(numeric, solution, side):
    """Raise `Unbounded` if a longer duration never costs more, `NotUnique` if it costs the same."""
    durations, costs = [], []
    for factor in (2, 1, 1 / 2, 1 / 4, 1 / 8):
        duration = factor * solution.duration
        result = _solution_with_duration(numeric, solution, side, factor)
        if not isinstance(result, DirectSolution) or (
            costs and result.cost < costs[-1] - 1e-6 * abs(costs[-1])
        ):
            break
        durations.append(duration)
        costs.append(result.cost)
    if len(costs) < 2:
        return
    if costs[-1] - costs[0] <= 1e-6 * abs(costs[0]):
        times = " and ".join(
            f"{numeric.user_time(duration):.3g}" for duration in durations[:2][::-1]
        )
        raise NotUnique(
            f"the best duration is left open: processes that last {times} cost the same, about "
            f"{numeric.user_cost(costs[0]):.7g}, so that many may be equally good. Give a duration, "
            "or the time a small cost."
        )
    values = ", ".join(
        f"{numeric.user_cost(cost):.7g} for {numeric.user_time(duration):.3g}"
        for duration, cost in zip(durations[::-1], costs[::-1])
    )
    raise Unbounded(
        "no best duration was found: the cost keeps "
        f"{'rising' if numeric.problem.maximise else 'falling'} with the duration ({values}), "
        f"towards about {numeric.user_cost(costs[0]):.7g}. It seems that this value is approached as "
        "the duration grows, and not attained. Give a duration."
    )


def _refuse_open_duration(numeric, solution, side):
    if fixed_duration(numeric, solution) is None:
        finer = finer_solution(numeric, solution, side, 4) or solution
        refuse_unbounded_duration(numeric, finer, side)


def least_time(numeric: NumericProblem) -> float | None:
    """Return the least time to the target by transcription; None if none was found."""
    fastest = NumericProblem(
        replace(numeric.problem, running=1, final=0, duration=None, maximise=False)
    )
    programme = Transcription(fastest, INTERVALS)
    results = (programme.solve(start) for start in starting_guesses(fastest, INTERVALS))
    return next((result.duration for result in results if isinstance(result, DirectSolution)), None)


LEAST_TIME = Hypothesis(
    "the cost is the time, which is free and to be least",
    lambda p: p.time_optimal and not p.maximise and p.duration is None,
)
NO_TIME_BOUNDS = Hypothesis("the final time is free without bounds", lambda p: p.duration is None)
CONTROL_WITHOUT_BOUNDS = Hypothesis(
    "a control has no bounds",
    lambda p: any(pair == (-sp.oo, sp.oo) for pair in p.controls.values()),
)
ANY_DURATION = Refusal(
    "least time with controls without bounds",
    "They lead a controllable linear plant to the target in any time, so that none is the least.",
    "Kalman 1960, controllability in any time",
    (LEAST_TIME, UNCONSTRAINED, LINEAR_PLANT, LINEAR_TARGET, CONTROL_WITHOUT_BOUNDS),
    Unbounded,
    _refuse_any_duration,
)
FALLING_COST = Refusal(
    "cost that falls with the duration",
    "The cost of the discrete solutions falls with twice and four times the duration.",
    "numerical evidence",
    (FREE_TIME, COST_OTHER_THAN_TIME, NO_FIRST_RETURN),
    Unbounded,
    _refuse_falling_cost,
)
EXTREME_DURATION = Refusal(
    "duration that tends to zero or grows without end",
    "The best duration of a discrete solution ran into the bounds that every duration has here.",
    "numerical evidence",
    (NO_TIME_BOUNDS,),
    Unbounded,
    _refuse_extreme_duration,
)
OPEN_DURATION = Refusal(
    "duration that is not determined",
    "A longer duration never costs more (no best one), or the same (many best ones).",
    "numerical evidence",
    (FREE_TIME,),
    Unbounded,
    _refuse_open_duration,
)
