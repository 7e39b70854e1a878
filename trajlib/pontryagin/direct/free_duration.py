"""Free durations: the best one, or the reason why there is none."""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.guesses import starting_guesses
from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    PATIENCE,
    DirectSolution,
    Transcription,
)
from trajlib.pontryagin.problem.errors import NotUnique, Unbounded
from trajlib.pontryagin.problem.numeric import NumericProblem

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
    T, low, high = solution.duration, numeric.shortest, numeric.longest
    if T <= 1.5 * low and not numeric.time_bounds_given:
        raise Unbounded(
            f"the best duration tends to zero (it ran into {numeric.user_time(low):g}, with a cost of "
            f"{numeric.user_cost(solution.cost):.6g}): the infimum is approached by ever shorter "
            "processes and not attained. Bound the controls, or give a duration; if processes as "
            "short as that are meant, choose a smaller unit of time."
        )
    if T >= high * (1 - 1e-6) and not numeric.time_bounds_given:
        raise Unbounded(
            f"the best duration grows beyond every bound (it ran into {numeric.user_time(high):g}): there is no best "
            "process. Give a duration, or bounds for it; for a process that ends when it first "
            "meets the target, state it with first_return=True."
        )
    if numeric.time_bounds_given:
        for bound in (low, high):
            if abs(T - bound) <= 1e-6 * (1 + bound):
                return bound
    return None


def refuse_any_duration(numeric: NumericProblem) -> None:
    """Raise `Unbounded` if a linear plant reaches the target in any time, and as fast as possible.

    Controls without bounds lead a controllable plant from any state to any other in any time t > 0.
    """
    problem = numeric.problem
    slopes = sp.Matrix(problem.field).jacobian([*problem.state, *problem.control])
    if (
        not problem.time_optimal
        or problem.maximise
        or problem.duration is not None
        or problem.constrained
        or slopes.free_symbols
        or sp.Matrix(problem.terminal).jacobian(problem.state).free_symbols
    ):
        return
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


def refuse_falling_cost(numeric, search_result):
    """Raise `Unbounded` if the cost falls with twice the duration, and further with four times.

    Then nothing in the solution is stationary but the errors of its steps, and joining its arcs
    takes minutes and fails. With longer steps it has another duration: where the duration is the
    same, nothing has to be tried.
    """
    problem, (solution, side) = numeric.problem, search_result.solutions[0]
    if (
        problem.time_optimal
        or problem.first_return
        or fixed_duration(numeric, solution) is not None
    ):
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


def least_time(numeric: NumericProblem) -> float | None:
    """Return the least time to the target by transcription; None if none was found."""
    fastest = NumericProblem(
        replace(numeric.problem, running=1, final=0, duration=None, maximise=False)
    )
    programme = Transcription(fastest, INTERVALS)
    results = (programme.solve(start) for start in starting_guesses(fastest, INTERVALS))
    return next((result.duration for result in results if isinstance(result, DirectSolution)), None)
