"""Covariances and gains of the discrete Kalman filter.

They do not depend on the data. Where they converge for constant matrices, the rest of the
convergence is known to first order: with the error matrix F = Phi (E - KH) the changes after a
change D add up to the X with X = F X F^T + D. Once X is below 1e-13 of the variances the gain is
kept. A missing measurement ends that, and the covariances are stepped again.
"""

import numpy as np

from trajlib._arguments.covariances import ROUNDING
from trajlib.estimation.compiled_recursion import LEAST_STEPS as COMPILED_FROM
from trajlib.estimation.compiled_recursion import MOST_STATES, covariance_steps
from trajlib.estimation.lane_recursion import LEAST_STEPS as LANES_FROM
from trajlib.estimation.lane_recursion import covariance_lanes

#: The gain is kept once the rest of the convergence is below this share of the variances.
SETTLED = 1e-13
#: With fewer gaps among the steps than this, most steps keep the gain of the one before.
GAPS = 1 / 300

#: Entries of the covariances that are checked together: what stays in the processor's cache.
BLOCK = 8192

LOST = (
    "the covariance has lost its definiteness to rounding: the variances differ by too many "
    "powers of ten, or the model is unstable and unobserved; scale the states, or check Q and R"
)


def at_steps(matrix, count):
    """Return a matrix, or a stack with one for each step, as a stack of `count` matrices."""
    return np.broadcast_to(matrix, (count, *matrix.shape[-2:]))


REPEATED = (
    "R: an exact measurement (R is singular) repeats what is known exactly already, so that its gain is "
    "not determined (measurement {}); leave it out, or give it a variance"
)


def filter_covariances(model, P, missing):
    """Return for each step the index of its matrices, and these.

    They are P-, P+, K, S, the inverse of S for the measured components, and log det S + m log 2 pi.
    """
    constant = all(getattr(model, name).ndim == 2 for name in ("Phi", "H", "Q", "R"))
    count = len(missing)
    gaps = missing.any(axis=1).sum()
    differing = count if not constant or gaps > GAPS * count else 0
    if differing and not has_exact_measurements(model.R):
        if len(P) <= MOST_STATES and differing >= COMPILED_FROM:
            return _compiled(model, P, missing)
        if differing >= LANES_FROM and (lanes := covariance_lanes(model, P, missing)) is not None:
            return np.arange(count), _finished(model.H, model.R, missing, *lanes)
    Phis, Hs, Qs, Rs = (
        at_steps(matrix, count) for matrix in (model.Phi, model.H, model.Q, model.R)
    )
    complete, all_missing = ~missing.any(axis=1), missing.all(axis=1)
    # The first step from each on at which something is missing.
    gaps = np.append(np.flatnonzero(~complete), count)
    following = gaps[np.searchsorted(gaps, np.arange(count))]
    index, steps, first, k = np.empty(count, dtype=np.int64), [], [], 0
    no_gain, failed = np.zeros((len(P), Hs.shape[1])), False
    while k < count:
        Phi = Phis[k]
        try:
            if all_missing[k]:
                after, K = P, no_gain
            elif complete[k]:
                after, K = _corrected(P, Hs[k], Rs[k])
            else:
                rows = np.flatnonzero(~missing[k])
                after, gain = _corrected(P, Hs[k][rows], Rs[k][np.ix_(rows, rows)])
                K = no_gain.copy()
                K[:, rows] = gain
        except np.linalg.LinAlgError:
            after, K, failed = P, no_gain, True
        index[k] = len(steps)
        steps.append((P, after, K))
        first.append(k)
        if failed:
            break
        predicted = Phi @ after @ Phi.T + Qs[k]
        predicted = (predicted + predicted.T) / 2
        if constant and following[k] > k + 1 and _settled(model, P, K, predicted - P):
            index[k : following[k]] = len(steps) - 1
            k = following[k]
        else:
            k += 1
        P = predicted
    before, after, gains = (np.array(part) for part in zip(*steps))
    after = (after + after.transpose(0, 2, 1)) / 2
    first = np.array(first)
    if has_exact_measurements(model.R):
        _check_new(_spread(Hs[first], Rs[first], before), missing[first], first)
    if failed:
        raise ValueError(LOST)
    matrices = Hs[first], Rs[first]
    return index, _finished(*matrices, missing[first], before, after, gains)


def _spread(H, R, before):
    return H @ before @ np.swapaxes(H, -1, -2) + R


def _finished(H, R, missing, before, after, gains):
    """Return the matrices of steps with the covariances of their innovations."""
    check_definiteness(after)
    spread = _spread(H, R, before)
    return before, after, gains, spread, *innovation_inverses(spread, missing)


def _compiled(model, P, missing):
    before, after, gains, spread, inverse, logarithm, definite = covariance_steps(model, P, missing)
    if not (np.isfinite(definite).all() and np.isfinite(before).all()):
        raise ValueError(LOST)
    logarithm = logarithm + (~missing).sum(axis=1) * np.log(2 * np.pi)
    return np.arange(len(missing)), (before, after, gains, spread, inverse, logarithm)


def _corrected(P, H, R):
    """Return P+ and K in as few operations as possible, since each step may need them."""
    from scipy.linalg.lapack import dposv

    HP = H @ P
    _, solution, failed = dposv(HP @ H.T + R, HP)
    if failed:
        raise np.linalg.LinAlgError
    gain = solution.T
    # Joseph's form by two changes of rank m.
    once = P - gain @ HP
    return once + (gain @ R - once @ H.T) @ solution, gain


def innovation_inverses(spread, missing):
    """Return S^-1 of the measured components, zero elsewhere, and their log det S + m log 2 pi."""
    block = _measured_block(spread, missing)
    if not np.isfinite(block).all():
        raise ValueError(LOST)
    logarithm = np.linalg.slogdet(block)[1] + (~missing).sum(axis=1) * np.log(2 * np.pi)
    return np.where(_both_measured(missing), np.linalg.inv(block), 0.0), logarithm


def _measured_block(spread, missing):
    """Return the covariances with rows of the unit matrix for missing components.

    These do not change the others, and their determinant is one.
    """
    return np.where(_both_measured(missing), spread, np.eye(spread.shape[-1]) * missing[:, :, None])


def _both_measured(missing):
    return ~missing[:, :, None] & ~missing[:, None, :]


def _settled(model, P, K, change):
    """Return whether the rest of the convergence, after a step of size `change`, is negligible."""
    # One entry decides most steps at almost no cost.
    if not abs(change[0, 0]) <= SETTLED * P[0, 0]:
        return False
    units = np.sqrt(np.diag(P))
    if not ((units > 0).all() and np.abs(change / np.outer(units, units)).max() <= SETTLED):
        return False
    from scipy.linalg import solve_discrete_lyapunov

    F = model.Phi @ (np.eye(len(P)) - K @ model.H)
    if np.abs(np.linalg.eigvals(F)).max() >= 1 - 1e-10:
        return False
    remaining = solve_discrete_lyapunov(F, change)
    return np.abs(remaining / np.outer(units, units)).max() <= SETTLED


def has_exact_measurements(R):
    """Whether a covariance R, or one of a stack, is singular within rounding."""
    variances = np.einsum("...ii->...i", R)
    units = np.sqrt(np.where(variances > 0, variances, 1))
    return bool(
        np.linalg.eigvalsh(R / (units[..., :, None] * units[..., None, :])).min() < ROUNDING
    )


def _check_new(spread, missing, numbers):
    """Raise ValueError if the covariance of an innovation is singular but for rounding.

    That is judged beside the greatest variances of the innovations up to then: what an exact
    measurement leaves is rounding of these.
    """
    variances = np.where(missing, 0.0, np.einsum("kii->ki", spread))
    units = np.sqrt(np.maximum.accumulate(variances, axis=0))
    units = np.where(missing | (units == 0), 1.0, units)
    block = _measured_block(spread, missing) / (units[:, :, None] * units[:, None, :])
    repeated = np.linalg.eigvalsh(block)[:, 0] < SETTLED
    if repeated.any():
        raise ValueError(REPEATED.format(numbers[np.argmax(repeated)]))


def check_definiteness(covariances):
    """Raise ValueError if a covariance has lost its definiteness to rounding."""
    size = max(1, BLOCK // covariances.shape[-1] ** 2)
    for first in range(0, len(covariances), size):
        block = covariances[first : first + size]
        variances = np.einsum("kii->ki", block)
        shifted = block.copy()
        # As much more as would make a difference of ROUNDING in units of their own.
        np.einsum("kii->ki", shifted)[:] += ROUNDING * np.where(variances > 0, variances, 1)
        try:
            roots = np.linalg.cholesky(shifted)
        except np.linalg.LinAlgError:
            raise ValueError(LOST) from None
        if not ((variances >= 0).all() and np.isfinite(roots).all()):
            raise ValueError(LOST)
