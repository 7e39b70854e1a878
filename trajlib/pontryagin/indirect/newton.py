"""Damped least-squares Newton steps for the equations of multiple shooting."""

import numpy as np

from trajlib.pontryagin.indirect.valley import follow_valley
from trajlib.pontryagin.problem.log import current_log

# Size of cancelling terms up to which residuals are relative to them: the growth allowed on a
# segment.
CANCELLING = 1e3
# Share of the largest singular value of the Jacobian below which directions are left out where
# steps get short.
RANK = 1e-8
# Residual, relative to the values, beyond which a curved valley is followed.
SOLVED = 1e-9
ITERATIONS = 80
# Newton's method stops where the residual has not fallen to this share of itself within so many
# steps.
STAGNATION, PATIENCE = 0.9, 10
# Shortest share of a step that is tried with the test of corrections.
SHORTEST_NATURAL = 1 / 32


# Norms of residuals far from a solution may overflow: such trials are refused.
@np.errstate(over="ignore")
def newton(equations, z):
    """Solve by damped least-squares Newton steps; the lengths of the arcs stay positive.

    Returns (z, largest residual, uncertainty of the lengths): each residual relative to the terms
    that cancel in its equation (at least to one, at most to CANCELLING), the uncertainty relative
    to the duration.
    """
    z, r, J = _damped(equations, z)
    if np.isfinite(J).all() and np.linalg.norm(r) > SOLVED * (1 + np.linalg.norm(z)):
        solution = follow_valley(equations, z)
        if solution is not None:
            z, r, J = _damped(equations, solution)
    if not np.isfinite(J).all():
        return z, np.inf, np.inf
    step = _least_squares(J, r, 1e-13)[equations.lengths]
    residual = float(np.max(np.abs(r) / np.clip(np.abs(J) @ np.abs(z), 1.0, CANCELLING)))
    current_log().note("Newton", f"residual {residual:.1e}", residual)
    return (
        z,
        residual,
        float(np.max(np.abs(step)) / np.sum(z[equations.lengths])),
    )


def _damped(equations, z):
    """Return (z, r, J) after damped steps, as long as the residual falls."""
    r, J = equations.residual(z)
    sizes, log = [], current_log()
    for _ in range(ITERATIONS):
        sizes.append(np.linalg.norm(r))
        log.show("Newton", f"residual {sizes[-1]:.1e}")
        if not np.isfinite(J).all() or sizes[-1] > STAGNATION * max(
            sizes[-PATIENCE - 1 : -PATIENCE], default=np.inf
        ):
            break
        step = _least_squares(J, r, 1e-13)
        better = _shortened(equations, z, r, step, 1e-2)
        if not _rounded(z, sizes[-1]) and (
            better is None or np.linalg.norm(better[1]) > STAGNATION * sizes[-1]
        ):
            # Such a step may go along a family of solutions (a closed path may begin anywhere).
            across = _least_squares(J, r, RANK)
            if better is None or np.linalg.norm(across) < np.linalg.norm(step) / 2:
                truncated = _shortened(equations, z, r, across, 1e-7 if better is None else 1e-2)
                better = min(
                    filter(None, (better, truncated)),
                    key=lambda trial: np.linalg.norm(trial[1]),
                    default=None,
                )
            if better is None or np.linalg.norm(better[1]) > STAGNATION * sizes[-1]:
                better = _shortened_by_correction(equations, z, J, step) or better
        if better is None:
            break
        z, r, J = better
    return z, r, J


def _shortened(equations, z, r, step, shortest):
    """Return (z, r, J) after a step that lowers the residual, halved as needed, or None."""
    size = np.linalg.norm(r)
    alpha = _longest(equations, z, step)
    while alpha > shortest:
        trial = z + alpha * step
        r_trial, J_trial = equations.residual(trial)
        size_trial = np.linalg.norm(r_trial)
        if np.isfinite(size_trial) and size_trial < size * (1 - 1e-4 * alpha):
            return trial, r_trial, J_trial
        # Near rounding error only a full step can still help.
        if _rounded(z, size):
            break
        alpha /= 2
    return None


def _longest(equations, z, step):
    """Return the share of a step, at most 1, by which no arc loses more than 9/10 of its length."""
    lengths, change = z[equations.lengths], step[equations.lengths]
    shrinking = change < 0
    with np.errstate(over="ignore"):
        return min(1.0, 0.9 * np.min(-lengths[shrinking] / change[shrinking], initial=np.inf))


def _shortened_by_correction(equations, z, J, step):
    """Return (z, r, J) after a step that shortens the next step with the same Jacobian, or None.

    Along a curved valley (a process that may nearly begin at any time) the residuals rise at first
    although the solution gets nearer: Deuflhard's natural monotonicity test, which does not depend on
    the units of the equations.
    """
    size, alpha = np.linalg.norm(step), _longest(equations, z, step)
    while alpha > SHORTEST_NATURAL:
        trial = z + alpha * step
        r_trial, J_trial = equations.residual(trial)
        if np.isfinite(r_trial).all():
            correction = _least_squares(J, r_trial, 1e-13)
            if np.linalg.norm(correction) < (1 - alpha / 2) * size:
                return trial, r_trial, J_trial
        alpha /= 2
    return None


def _least_squares(J, r, rank):
    """Return the shortest step that minimises |J step + r|.

    Directions below the share `rank` of the largest singular value of J are left out. Where there
    are none, the step solves a square system without singular values, which take most of the time
    of long arcs with many segments.
    """
    count = len(r)
    if J.shape[1] == count:
        try:
            inverse = np.linalg.inv(J)
        except np.linalg.LinAlgError:
            inverse = np.full_like(J, np.inf)
        # The ratio of the singular values is at least 1/n of this one, by the norms.
        if 1 / (np.linalg.norm(J, 1) * np.linalg.norm(inverse, 1)) > count * rank:
            step = -inverse @ r
            return step - inverse @ (J @ step + r)
    return np.linalg.lstsq(J, -r, rcond=rank)[0]


def _rounded(z, size):
    """Check whether residuals of this size are near rounding error."""
    return size <= 1e-12 * (1 + np.linalg.norm(z))
