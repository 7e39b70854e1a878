"""Closed trajectories of negative cost: repeated, they make the cost fall without bound.

Where the final time is free, a process that ends on the target may run through a closed trajectory
from its final state any number of times before it ends. If one of these costs less than nothing, no
cost is the least. A local search shows nothing of this: the shortest process may be a local minimum.
"""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.direct.descent import finer_solution
from trajlib.pontryagin.direct.free_duration import FALLS, NO_TIME_BOUNDS
from trajlib.pontryagin.direct.guesses import oscillating_guesses
from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    PATIENCE,
    DirectSolution,
    Transcription,
)
from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.hypotheses import NO_FIRST_RETURN
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Durations of the loops that are tried, as multiples of that of the process.
MULTIPLES = (1, 4, 16)


def _refuse_negative_loop(numeric, solution):
    for multiple in MULTIPLES:
        cost = _negative_cost(numeric, solution, multiple)
        if cost is not None:
            rising = numeric.problem.maximise
            raise Unbounded(
                f"the cost {'rises' if rising else 'falls'} without bound: a closed trajectory that "
                f"returns to the final state of a process after the time "
                f"{numeric.user_time(multiple * solution.duration):.3g} adds "
                f"{numeric.user_cost(cost) - numeric.user_cost(0):.3g} to it, and can be repeated any "
                "number of times. There is no best process: give a duration, or bounds for it."
            )


def _negative_cost(numeric, solution, multiple):
    """Return the cost of a loop that lasts a multiple of a process if it is negative, else None.

    The loop is found with few steps, and counts if its cost is negative with steps as short as those
    of the process.
    """
    loop = NumericProblem(_loops(numeric.problem, solution, multiple * solution.duration))
    programme = Transcription(loop, INTERVALS, patience=PATIENCE)
    for guess in oscillating_guesses(loop, INTERVALS, loop.duration):
        found = programme.solve(guess)
        if isinstance(found, DirectSolution) and multiple > 1 and _is_negative(loop, found):
            found = finer_solution(loop, found, None, multiple)
        if isinstance(found, DirectSolution) and _is_negative(loop, found):
            return found.cost
    return None


def _loops(problem, solution, duration):
    """Return the problem of the cheapest loop from the final state of a process in a given time.

    Controls without bounds stay below twice their largest values in the process, or below 1.
    """
    reach = 2 * float(np.max(np.abs(solution.controls), initial=0.5))
    end = {y: sp.Rational(value) for y, value in zip(problem.state, solution.states[-1])}
    return replace(
        problem,
        controls={
            u: (low if low.is_finite else -reach, high if high.is_finite else reach)
            for u, (low, high) in problem.controls.items()
        },
        initial=end,
        terminal=[y - end[y] for y, rate in problem.dynamics.items() if rate != 0],
        terminal_inequalities=(),
        final=0,
        duration=duration,
    )


def _is_negative(loop, found):
    """Check whether the cost of a loop is negative, and not by the errors of its steps."""
    middles = (found.states[1:] + found.states[:-1]) / 2
    density = ca.Function("density", [loop.x, loop.u], [loop.density])
    sizes = np.abs(density.map(len(middles))(middles.T, found.controls.T).full())
    return found.cost < -FALLS * loop.duration * np.mean(sizes)


def _may_be_negative(problem):
    real = {s: sp.Dummy(real=True) for s in (*problem.state, *problem.control)}
    for u, (low, high) in problem.controls.items():
        if low.is_nonnegative:
            real[u] = sp.Dummy(nonnegative=True)
        elif high.is_nonpositive:
            real[u] = sp.Dummy(nonpositive=True)
    cost = (-problem.running if problem.maximise else problem.running).subs(real)
    return not cost.is_nonnegative


def _is_rate(problem):
    rates = (rate for rate in problem.field if rate != 0)
    return any(sp.cancel(problem.running / rate).is_number for rate in rates)


NEGATIVE_RUNNING_COST = Hypothesis("the running cost may be negative", _may_be_negative)
# Its integral over a closed trajectory is zero then.
NO_RATE = Hypothesis(
    "the running cost is not the rate of a state times a number", lambda p: not _is_rate(p)
)
NO_CLOCK = Hypothesis(
    "no state always grows or always falls",
    lambda p: not any(rate.is_positive or rate.is_negative for rate in p.field),
)
NEGATIVE_LOOP = Refusal(
    "closed trajectory of negative cost",
    "Repeated before the process ends, it makes the cost fall without bound.",
    "numerical evidence",
    (NO_TIME_BOUNDS, NO_FIRST_RETURN, NEGATIVE_RUNNING_COST, NO_RATE, NO_CLOCK),
    Unbounded,
    _refuse_negative_loop,
)
