"""From a discrete solution to one of lower cost: needle variations and escape from saddles."""

import numpy as np

from trajlib.pontryagin.direct.transcription import (
    INTERVALS,
    DirectSolution,
    Transcription,
    target_multipliers,
)
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.verification.second_variation import (
    ABNORMAL,
    process_of_solution,
    second_variation,
)

# Decrease of the cost by needle variations, as a share of it, from which on they are tried.
NEEDLES = 1e-3


def descend(numeric: NumericProblem, solution: DirectSolution, side: int | None) -> DirectSolution:
    """Return a solution that needle variations and the second variation do not improve."""
    for _ in range(4):
        if np.max(np.abs(solution.costates)) > ABNORMAL:
            return solution
        better = _improved_by_needles(numeric, solution, side)
        if better is not None:
            solution = better
            continue
        if numeric.path_orders:
            # The second variation here does not keep to path constraints.
            return solution
        variation = second_variation(
            numeric, process_of_solution(numeric, solution, target_multipliers(numeric, solution))
        )
        if variation.sign >= 0:
            return solution
        better = escape_saddle(numeric, solution, variation, side)
        if better is None:
            return solution
        solution = better
    return solution


def _improved_by_needles(numeric, solution, side):
    """Return a solution of lower cost from controls that maximise H on each interval, or None.

    Stationary controls need not maximise H where it is not concave. The integral of what H lacks is
    the first-order decrease of the cost by short changes of the control (needle variations).
    """
    if not any(
        curved and bounded
        for curved, bounded in zip(
            ~np.array(numeric.affine), np.isfinite(numeric.upper - numeric.lower)
        )
    ):
        return None
    middles = (solution.states[1:] + solution.states[:-1]) / 2
    best, excess = numeric.best_controls(middles, solution.costates[1:], solution.controls)
    if not excess @ np.diff(solution.times) > NEEDLES * (NEEDLES + abs(solution.cost)):
        return None
    result = solution_from_controls(numeric, solution, side, best)
    return (
        result if result and result.cost < solution.cost - 1e-9 * (1 + abs(solution.cost)) else None
    )


def solution_from_controls(numeric, solution, side, controls):
    """Return the solution that the search finds from other controls, or None."""
    result = Transcription(numeric, len(controls), None, side).solve(
        (solution.duration, solution.states, controls)
    )
    return result if isinstance(result, DirectSolution) else None


def escape_saddle(numeric, solution, variation, side):
    """Return a solution of lower cost along the second variation's least eigenvector, or None."""
    programme, best = Transcription(numeric, len(solution.controls), None, side), None
    width = np.where(
        np.isfinite(numeric.upper - numeric.lower), (numeric.upper - numeric.lower) / 2, 1.0
    )
    length = np.max(
        np.abs(variation.controls) / width,
        initial=np.max(np.abs(variation.widths)) / np.min(np.diff(solution.times)),
    )
    grid = np.linspace(0, 1, len(solution.times))
    for size in (0.3 / length, -0.3 / length):
        # The intervals of an extremal differ, and shifted switchings change their widths.
        widths = np.diff(solution.times) + size * variation.widths
        ends = np.concatenate([[0.0], np.cumsum(widths)]) / widths.sum()
        interval = np.searchsorted(ends[1:-1], (grid[1:] + grid[:-1]) / 2)
        states = solution.states + size * variation.states
        result = programme.solve(
            (
                widths.sum(),
                np.stack([np.interp(grid, ends, column) for column in states.T], axis=1),
                (solution.controls + size * variation.controls)[interval],
            )
        )
        if isinstance(result, DirectSolution) and result.cost < (best or solution).cost - 1e-9 * (
            1 + abs(solution.cost)
        ):
            best = result
    return best


def finer_solution(numeric, solution, side, factor):
    """Return the solution on a grid that is finer by a factor, or None."""
    programme = Transcription(numeric, factor * INTERVALS, side=side)
    result = programme.solve((solution.duration, solution.states, solution.controls))
    return result if isinstance(result, DirectSolution) else None
