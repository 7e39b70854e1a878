"""Sliding regimes: ever faster switching between two values, without an optimal process.

Where H is not concave in the controls, ever faster switching between two values u and v may cost
ever less (min of int (u^2 - 1)^2 + x^2). The limit is a process of the relaxed problem
(Gamkrelidze; Young's generalised curves)

    y' = a f(y, u) + (1 - a) f(y, v),   J = int a f_0(y, u) + (1 - a) f_0(y, v) dt,   0 <= a <= 1,

whose cost is the infimum of the ordinary one. With convex velocities the relaxed problem gains
nothing.
"""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.descent import solution_from_controls
from trajlib.pontryagin.direct.transcription import DirectSolution, Transcription
from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.hypotheses import NO_PATH, NONLINEAR_HAMILTONIAN
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.steps import Refusal

# Gain of the relaxed problem, as a share of the cost, and share of the intervals on which both
# values are used, from which on it counts.
GAIN, USED = 1e-3, 0.1


def _relaxed_solution(numeric, solution, side):
    """Return the relaxed problem's solution with controls (u, v, a), or None without a gain."""
    problem = numeric.problem
    second = {u: sp.Dummy(f"{u}_2") for u in problem.control}
    share = sp.Dummy("share")

    def mixed(e):
        return share * e + (1 - share) * e.subs(second, simultaneous=True)

    bounds = {
        **problem.controls,
        **{v: problem.controls[u] for u, v in second.items()},
        share: (0, 1),
    }
    mixed_numeric = NumericProblem(
        replace(
            problem,
            dynamics={y: mixed(f) for y, f in problem.dynamics.items()},
            controls=bounds,
            running=mixed(problem.running),
        )
    )
    # From guesses near the solution, or oscillating as it does, the search would return to it.
    width = np.where(
        np.isfinite(numeric.upper - numeric.lower),
        numeric.upper - numeric.lower,
        1 + np.ptp(solution.controls, axis=0),
    )
    mean = np.tile(solution.controls.mean(axis=0), (len(solution.controls), 1))
    controls = np.hstack([mean + width, mean - width, np.full((len(mean), 1), 0.5)])
    programme = Transcription(mixed_numeric, len(solution.controls), side=side)
    states = np.linspace(solution.states[0], solution.states[-1], len(solution.states))
    result = programme.solve(
        (solution.duration, states, np.clip(controls, mixed_numeric.lower, mixed_numeric.upper))
    )
    if not isinstance(result, DirectSolution) or result.cost > solution.cost - GAIN * (
        GAIN + abs(solution.cost)
    ):
        return None
    return result if _mixing(result.controls, numeric.k).mean() > USED else None


def _sequential_controls(numeric, relaxed):
    """Return controls (N, k) that take the two values of a relaxed solution one after the other.

    Where the cost does not ask for both at once, such a process is as good.
    """
    k, mixing = numeric.k, _mixing(relaxed.controls, numeric.k)
    first, second, share = (
        relaxed.controls[:, :k],
        relaxed.controls[:, k : 2 * k],
        relaxed.controls[:, -1],
    )
    chosen = share > 0.5
    mixed = np.nonzero(mixing)[0]
    chosen[mixed] = np.arange(len(mixed)) < share[mixed].sum()
    return np.where(chosen[:, None], first, second)


def _refuse_sliding(numeric, solution, side):
    """Raise `Unbounded`: ever faster switching seems to approach the relaxed infimum.

    Not if the solution found from the sequential controls comes as close to it as a discrete
    solution can: then this is returned, to be tried in place of the first.
    """
    relaxed = _relaxed_solution(numeric, solution, side)
    if relaxed is None:
        return None
    sequential = solution_from_controls(
        numeric, relaxed, side, _sequential_controls(numeric, relaxed)
    )
    if sequential and sequential.cost < relaxed.cost + GAIN * (GAIN + abs(relaxed.cost)):
        return sequential
    sign = -1 if numeric.problem.maximise else 1
    k, mixing = numeric.k, _mixing(relaxed.controls, numeric.k)
    middle = np.nonzero(mixing)[0][mixing.sum() // 2]
    values = [
        ", ".join(f"{u} = {value:.3g}" for u, value in zip(numeric.problem.control, part))
        for part in (relaxed.controls[middle, :k], relaxed.controls[middle, k : 2 * k])
    ]
    raise Unbounded(
        "no optimal process was found, and it seems that there is none: H is not concave in the "
        f"control, and the cost falls with ever faster switching, as between {values[0]} and "
        f"{values[1]} at t = {relaxed.times[middle]:.3g}. The infimum is about "
        f"{sign * relaxed.cost:.3g}, that of the relaxed problem y' = a f(y, u) + (1 - a) f(y, v), "
        "0 <= a <= 1 (a discrete solution; the best ordinary one found has "
        f"{sign * solution.cost:.3g}). State that problem, or give each change of the control a "
        "cost."
    )


def _mixing(controls, k):
    """Return on which intervals two different values are used at once, (N,)."""
    share, distance = (
        controls[:, -1],
        np.max(np.abs(controls[:, :k] - controls[:, k : 2 * k]), axis=1),
    )
    return (
        (share > 0.02)
        & (share < 0.98)
        & (distance > 0.05 * max(np.ptp(controls[:, : 2 * k]), 1e-12))
    )


SLIDING = Refusal(
    "sliding regime",
    "Ever faster switching between two values approaches the infimum of the relaxed problem, which "
    "no process attains.",
    "Gamkrelidze 1962; Young 1969, generalised curves",
    (NO_PATH, NONLINEAR_HAMILTONIAN),
    Unbounded,
    _refuse_sliding,
)
