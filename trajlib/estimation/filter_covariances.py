"""Covariances and gains of the discrete Kalman filter.

They do not depend on the data. Where they converge for constant matrices, the rest of the
convergence is known to first order: with the error matrix F = Phi (E - KH) the changes after a
change D add up to the X with X = F X F^T + D. Once X is below 1e-13 of the variances the gain is
kept. A missing measurement ends that, and the covariances are stepped again. Where they do not settle,
as without process noise, or with many gaps, the rest is left to `segments`.
"""

import numpy as np

from trajlib._arguments.covariances import ROUNDING
from trajlib.estimation.segments import (
    LEAST_STEPS,
    covariance_segments,
    number_of_segments,
    transposed,
)

#: The gain is kept once the rest of the convergence is below this share of the variances.
SETTLED = 1e-13
#: With fewer gaps among the steps than this, most steps keep the gain of the one before.
GAPS = 1 / 300
#: After so many steps that differ, those that follow are expected to differ as well.
PATIENCE = 300
#: Entries of the covariances that are checked together: what stays in the processor's cache.
BLOCK = 16384
#: Of long records the definiteness of each so manieth covariance is checked, the variances of all.
SAMPLE = 8

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
    matrices, (count, m) = (model.Phi, model.H, model.Q, model.R), missing.shape
    few_gaps = missing.any(axis=1).sum() <= GAPS * count
    # Exact measurements may repeat what is known, which is decided step by step.
    exact = has_exact_measurements(model.R)
    segments = 1 if exact else number_of_segments(count, len(P))
    patience = PATIENCE if few_gaps and all(M.ndim == 2 for M in matrices) else 0
    # Memory of steps that are not needed is never touched.
    results = [np.empty((count, len(P), columns)) for columns in (len(P), len(P), m)]
    index, first = np.empty(count, dtype=np.int64), []
    with np.errstate(all="ignore"):
        k, P = _stepped(matrices, P, missing, results, index, first, 0, segments, patience)
        if k < count and P is not None:
            rest, done = [M if M.ndim == 2 else M[k:] for M in matrices], len(first)
            parts = [part[done : done + count - k] for part in results]
            if covariance_segments(rest, P, missing[k:], segments, parts):
                index[k:] = np.arange(done, done + count - k)
                first += range(k, count)
            else:
                k, P = _stepped(matrices, P, missing, results, index, first, k)
        results = [part[: len(first)] for part in results]
        if len(first) < count / 2:
            results = [part.copy() for part in results]
        before, after, gains = results
        H, R = (M if M.ndim == 2 else M[first] for M in (model.H, model.R))
        spread, missing = H @ before @ transposed(H) + R, missing[first]
        if exact:
            _check_new(spread, missing, first)
        if P is None:
            raise ValueError(LOST)
        check_definiteness(after[:: SAMPLE if len(first) >= LEAST_STEPS else 1])
        if not (np.einsum("kii->ki", after) >= 0).all():
            raise ValueError(LOST)
        return index, (before, after, gains, spread, *innovation_inverses(spread, missing))


def _stepped(matrices, P, missing, results, index, first, k, segments=1, patience=0):
    """Take steps from k on, to the end or to a step from which `segments` can take the rest.

    They do so after as many steps that differ as `patience`. Returned are that step and its P-, None if
    the covariance is lost. `first` are the steps that differ, to which `index` refers.
    """
    before, afters, gains = results
    count, constant, begun = len(missing), all(M.ndim == 2 for M in matrices), len(first)
    Phis, Hs, Qs, Rs = (at_steps(matrix, count) for matrix in matrices)
    complete, all_missing = ~missing.any(axis=1), missing.all(axis=1)
    # The first step from each on at which something is missing.
    gaps = np.append(np.flatnonzero(~complete), count)
    following = gaps[np.searchsorted(gaps, np.arange(count))]
    no_gain = np.zeros(gains.shape[1:])
    while k < count and P is not None:
        left = count - k
        if (
            segments > 1
            and len(first) >= patience
            and left > LEAST_STEPS // 2
            and not left % segments
        ):
            break
        Phi, after, K, lost = Phis[k], P, no_gain, False
        try:
            if complete[k]:
                after, K = _corrected(P, Hs[k], Rs[k])
            elif not all_missing[k]:
                rows = np.flatnonzero(~missing[k])
                after, gain = _corrected(P, Hs[k][rows], Rs[k][np.ix_(rows, rows)])
                K = no_gain.copy()
                K[:, rows] = gain
        except np.linalg.LinAlgError:
            lost = True
        index[k] = step = len(first)
        before[step], afters[step], gains[step] = P, after, K
        first.append(k)
        predicted = Phi @ after @ Phi.T + Qs[k]
        predicted = (predicted + predicted.T) / 2
        loop = Phi - Phi @ K @ Hs[k]
        if constant and following[k] > k + 1 and settled(loop, P, predicted - P):
            index[k : following[k]] = step
            k = following[k]
        else:
            k += 1
        P = None if lost else predicted
    symmetrise(afters[begun : len(first)])
    return k, P


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
    inverses, logarithm = _inverse_and_logarithm(_measured_block(spread, missing))
    if not (np.isfinite(inverses).all() and np.isfinite(logarithm).all()):
        raise ValueError(LOST)
    inverses[~_both_measured(missing)] = 0
    return inverses, logarithm + (~missing).sum(axis=1) * np.log(2 * np.pi)


def _inverse_and_logarithm(matrices):
    """Return the inverses of positive definite matrices and log det, which is nan of others.

    Each component is eliminated from all matrices at once, which takes less time for few components
    than a call of LAPACK for each matrix.
    """
    inverses, logarithm = matrices.copy(), 0.0
    for j in range(matrices.shape[-1]):
        pivot = inverses[..., j, j].copy()
        row = inverses[..., j, :] / pivot[..., None]
        row[..., j] = 1 / pivot
        column = inverses[..., :, j].copy()
        column[..., j] = 0
        inverses[..., :, j] = 0
        inverses -= column[..., :, None] * row[..., None, :]
        inverses[..., j, :] = row
        logarithm = logarithm + np.log(pivot)
    return inverses, logarithm


def _measured_block(spread, missing):
    """Return the covariances with rows of the unit matrix for missing components.

    These do not change the others, and their determinant is one.
    """
    return np.where(_both_measured(missing), spread, np.eye(spread.shape[-1]) * missing[:, :, None])


def _both_measured(missing):
    return ~missing[:, :, None] & ~missing[:, None, :]


def settled(F, P, change):
    """Return whether the rest of the convergence, after a step of size `change`, is negligible.

    A step takes a difference D of covariances to F D F^T.
    """
    # One entry decides most steps at almost no cost.
    if not abs(change[0, 0]) <= SETTLED * P[0, 0]:
        return False
    units = np.sqrt(np.diag(P))
    if not ((units > 0).all() and np.abs(change / np.outer(units, units)).max() <= SETTLED):
        return False
    from scipy.linalg import solve_discrete_lyapunov

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


def symmetrise(covariances):
    """Make covariances symmetric in their place."""
    for block in _blocks(covariances):
        block[:] = (block + block.transpose(0, 2, 1)) / 2


def _blocks(covariances):
    """Yield parts of a stack of matrices that stay in the processor's cache."""
    size = max(1, BLOCK // covariances.shape[-1] ** 2)
    for first in range(0, len(covariances), size):
        yield covariances[first : first + size]


def check_definiteness(covariances):
    """Raise ValueError if a covariance has lost its definiteness to rounding."""
    for block in _blocks(covariances):
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
