"""The Kalman filter in discrete time on arrays (Theorem 4.1), for one series or many, with missing
measurements.

The covariances do not depend on the data. For constant matrices they converge, and what is left to
converge is known to first order: with the error matrix F = Phi (E - KH) a change D of one step adds
up to the X with X = F X F^T + D. Once X is below 1e-13 of the variances the gain is kept, and the
estimates obey x_{k+1} = F x_k + Phi K z_k, which runs in blocks. A missing measurement ends that,
and the covariances are stepped again.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.covariances import ROUNDING, read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib.estimation.recursion import BLOCK, recursion, varying_recursion

#: How much of the variances may be left to converge when the gain is kept.
SETTLED = 1e-13
LOST = (
    "the covariance has lost its definiteness to rounding: the variances differ by too many "
    "powers of ten, or the model is unstable and unobserved; scale the states, or check Q and R"
)


@dataclass(frozen=True, repr=False)
class FilterRun:
    """What a Kalman filter found. N steps, n states, m outputs; with S series each array of data
    has S in front.

    - `predicted`, `estimates`: N x n, x~_k^- and x~_k^+ before and after the measurement z_k;
    - `innovations`: N x m, z_k - H x~_k^-, nan where a measurement is missing;
    - `kinds`: N, for each step the number of its matrices in the arrays behind `covariances`;
    - `log_likelihood`: of the measurements under the model, for normal errors, a number for each
      series.
    """

    predicted: np.ndarray
    estimates: np.ndarray
    innovations: np.ndarray
    kinds: np.ndarray
    log_likelihood: object
    _steps: tuple

    @property
    def covariances(self):
        """P_k^+, N x n x n."""
        return self._steps[1][self.kinds]

    @property
    def predicted_covariances(self):
        """P_k^-, N x n x n."""
        return self._steps[0][self.kinds]

    @property
    def gains(self):
        """K_k, N x n x m; zero in the columns of missing measurements."""
        return self._steps[2][self.kinds]

    @property
    def innovation_covariances(self):
        """H P_k^- H^T + R, N x m x m, those of missing measurements included."""
        return self._steps[3][self.kinds]

    @property
    def normalised_innovations(self):
        """The squares nu^T S^-1 nu of the innovations, N: chi-squared with `measured` degrees of
        freedom each."""
        known = np.nan_to_num(self.innovations)
        return np.einsum("...ki,...kij,...kj->...k", known, self._steps[4][self.kinds], known)

    @property
    def measured(self):
        """How many components were measured at each step, N."""
        return (~np.isnan(self.innovations)).sum(axis=-1)

    def __repr__(self):
        return (
            f"FilterRun of {self.estimates.shape[-2]} steps, {self.estimates.shape[-1]} states, "
            f"{self.innovations.shape[-1]} outputs, log-likelihood "
            f"{np.round(self.log_likelihood, 3)}"
        )


@dataclass(frozen=True)
class KalmanFilter:
    """The filter of x_{k+1} = Phi x_k + q_k, z_k = H x_k + r_k (MATLAB: kalman; filterpy:
    KalmanFilter).

    `Phi`: n x n, `H`: m x n, `Q`: n x n, the covariance of q_k, positive semidefinite, `R`: m x m,
    that of r_k, positive definite; arrays or lists, computed in floats. Each may be a stack with a
    matrix for each step (N x ...); Phi_k and Q_k lead from step k to k + 1. The state comes with
    its control: for x_{k+1} = Phi x_k + B u_k + q_k pass `known` = B u_k to `run`. Raises
    ValueError for shapes that do not fit and for covariances that are none.

    >>> import numpy as np
    >>> from trajlib.estimation import Moments
    >>> run = KalmanFilter(1, 1, 0, 1).run(np.array([1.0, 3.0]), Moments(0, 1))
    >>> run.estimates.ravel().round(3).tolist(), run.covariances.ravel().round(3).tolist()
    ([0.5, 1.333], [0.5, 0.333])
    """

    Phi: np.ndarray
    H: np.ndarray
    Q: np.ndarray
    R: np.ndarray

    def __post_init__(self):
        Phi = _stack(self.Phi, lambda one: read_matrix(one, "Phi", None, None, True))
        n = Phi.shape[-1]
        if Phi.shape[-2] != n:
            raise ValueError(f"Phi: expected a square matrix, got the shape {Phi.shape[-2:]}")
        H = _stack(self.H, lambda one: read_matrix(one, "H", None, n, True))
        Q = _stack(self.Q, lambda one: read_covariance(one, "Q", n, True))
        R = _stack(self.R, lambda one: read_covariance(one, "R", H.shape[-2], True, definite=True))
        for name, matrix in zip(["Phi", "H", "Q", "R"], (Phi, H, Q, R)):
            object.__setattr__(self, name, matrix)

    def run(self, z, start, missing=None, known=None):
        """Filter the measurements; `FilterRun` with an estimate before and after each.

        `z`: N x m, or N for one output, or S x N x m for S series of the same model; `start`:
        `Moments` of x at the first measurement, before it; `missing`: booleans of the shape of z,
        or N (S x N) for whole rows, True where there is no measurement (or z is a masked array);
        `known`: N x n, S x N x n, added to Phi x_k. Raises ValueError for a measurement that is not
        finite and not marked as missing, for shapes that do not fit, and if rounding has cost a
        covariance its definiteness.
        """
        z, missing, alone = self._measurements(z, missing)
        series, count, _m = z.shape
        n = self.Phi.shape[-1]
        mean = read_vector(start.mean, "mean", n, True)
        P = read_covariance(start.covariance, "covariance", n, True)
        known = (
            None
            if known is None
            else np.broadcast_to(np.asarray(known, dtype=float), (series, count, n))
        )
        predicted, estimates = np.empty((series, count, n)), np.empty((series, count, n))
        kinds, steps, offset = np.empty((series, count), dtype=np.int64), [], 0
        # Series with the same gaps have the same covariances.
        groups = {}
        for i, pattern in enumerate(missing):
            groups.setdefault(pattern.tobytes(), []).append(i)
        for chosen in groups.values():
            numbers, matrices = _covariances(self, P, missing[chosen[0]])
            kinds[chosen] = numbers + offset
            offset += len(matrices[0])
            steps.append(matrices)
            predicted[chosen], estimates[chosen] = _means(
                self, mean, z[chosen], known if known is None else known[chosen], numbers, matrices
            )
        steps = tuple(np.concatenate(part) for part in zip(*steps))
        _hold(steps[0])
        _hold(steps[1])
        innovations = np.where(missing, np.nan, z - _times(self.H, predicted))
        run = FilterRun(predicted, estimates, innovations, kinds, None, steps)
        likelihood = -(run.normalised_innovations + steps[5][kinds]).sum(axis=1) / 2
        if alone:
            return FilterRun(
                predicted[0], estimates[0], innovations[0], kinds[0], float(likelihood[0]), steps
            )
        return FilterRun(predicted, estimates, innovations, kinds, likelihood, steps)

    def _measurements(self, z, missing):
        if isinstance(z, np.ma.MaskedArray):
            if missing is not None:
                raise ValueError("missing: z is a masked array and says itself what is missing")
            z, missing = np.ma.getdata(z), np.ma.getmaskarray(z)
        z = np.asarray(z, dtype=float)
        m = self.H.shape[-2]
        shape = z.shape
        if z.ndim == 1 and m == 1:
            z = z[:, None]
        if z.ndim not in (2, 3) or z.shape[-1] != m or 0 in z.shape:
            raise ValueError(f"z: expected the shape (N, {m}) or (series, N, {m}), got {shape}")
        if missing is None:
            gone = np.zeros(z.shape, dtype=bool)
        else:
            gone = np.asarray(missing)
            if gone.dtype != bool or gone.shape not in (z.shape, z.shape[:-1], shape):
                raise ValueError(
                    f"missing: expected booleans of the shape {shape} or {z.shape[:-1]}, got "
                    f"{gone.dtype} of the shape {gone.shape}"
                )
            gone = np.broadcast_to(gone if gone.ndim == z.ndim else gone[..., None], z.shape)
        if not np.isfinite(z[~gone]).all():
            place = tuple(int(i) for i in np.argwhere(~np.isfinite(z) & ~gone)[0])
            raise ValueError(
                f"z: the measurement {place} is {z[place]}; mark it in `missing` if there is none"
            )
        z = np.where(gone, 0.0, z)
        for name in ("Phi", "H", "Q", "R"):
            matrix = getattr(self, name)
            if matrix.ndim == 3 and len(matrix) != z.shape[-2]:
                raise ValueError(
                    f"{name}: expected {z.shape[-2]} matrices, one for each step, got {len(matrix)}"
                )
        return z.reshape((-1, *z.shape[-2:])), gone.reshape((-1, *z.shape[-2:])), z.ndim == 2

    def _all(self, name, count):
        matrix = getattr(self, name)
        return np.broadcast_to(matrix, (count, *matrix.shape[-2:]))


def _stack(given, read):
    if any_floats(given) and given.ndim == 3:
        return np.stack([read(one) for one in given])
    return read(given)


def _covariances(model, P, missing):
    """For each step the number of its matrices, and these: P-, P+, K, S, the inverse of S among
    what is measured, and log det S + m log 2 pi."""
    constant = all(getattr(model, name).ndim == 2 for name in ("Phi", "H", "Q", "R"))
    count = len(missing)
    Phis, Hs, Qs, Rs = (model._all(name, count) for name in ("Phi", "H", "Q", "R"))
    whole, nothing = ~missing.any(axis=1), missing.all(axis=1)
    # The first step from each on at which something is missing.
    gaps = np.append(np.flatnonzero(~whole), count)
    following = gaps[np.searchsorted(gaps, np.arange(count))]
    numbers, kept, first, k = np.empty(count, dtype=np.int64), [], [], 0
    one, no_gain = np.eye(len(P)), np.zeros((len(P), Hs.shape[1]))
    while k < count:
        Phi = Phis[k]
        if nothing[k]:
            after, K = P, no_gain
        elif whole[k]:
            after, K = _corrected(P, Hs[k], Rs[k], one)
        else:
            rows = np.flatnonzero(~missing[k])
            after, gain = _corrected(P, Hs[k][rows], Rs[k][np.ix_(rows, rows)], one)
            K = no_gain.copy()
            K[:, rows] = gain
        numbers[k] = len(kept)
        kept.append((P, after, K))
        first.append(k)
        predicted = Phi @ after @ Phi.T + Qs[k]
        predicted = (predicted + predicted.T) / 2
        if constant and following[k] > k + 1 and _settled(model, P, K, predicted - P):
            numbers[k : following[k]] = len(kept) - 1
            k = following[k]
        else:
            k += 1
        P = predicted
    before, after, gains = (np.array(part) for part in zip(*kept))
    first = np.array(first)
    H, R = Hs[first], Rs[first]
    spread = H @ before @ H.transpose(0, 2, 1) + R
    return numbers, (before, after, gains, spread, *_inverses(spread, missing[first]))


def _corrected(P, H, R, one):
    """P+ and K, in as few calls as it takes: this is done for each step that has a covariance of
    its own."""
    from scipy.linalg.lapack import dposv

    HP = H @ P
    _, solved, failed = dposv(HP @ H.T + R, HP)
    if failed:
        raise ValueError(LOST)
    gain = solved.T
    left = one - gain @ H
    after = left @ P @ left.T + gain @ R @ gain.T
    return (after + after.T) / 2, gain


def _inverses(spread, missing):
    """For each step S^-1 among what is measured, zero elsewhere, and log det S + m log 2 pi of that
    part."""
    m = spread.shape[-1]
    # What is missing becomes a unit: it does not touch the rest, and its determinant is one.
    there = ~missing[:, :, None] & ~missing[:, None, :]
    part = np.where(there, spread, np.eye(m) * missing[:, :, None])
    if not np.isfinite(part).all():
        raise ValueError(LOST)
    logarithm = np.linalg.slogdet(part)[1] + (m - missing.sum(axis=1)) * np.log(2 * np.pi)
    return np.where(there, np.linalg.inv(part), 0.0), logarithm


def _settled(model, P, K, change):
    """Whether what is still to converge, after a step that changed the covariance by `change`, does
    not count."""
    # One entry decides it for most steps, at the price of none.
    if not abs(change[0, 0]) <= SETTLED * P[0, 0]:
        return False
    units = np.sqrt(np.diag(P))
    if not ((units > 0).all() and np.abs(change / np.outer(units, units)).max() <= SETTLED):
        return False
    from scipy.linalg import solve_discrete_lyapunov

    F = model.Phi @ (np.eye(len(P)) - K @ model.H)
    if np.abs(np.linalg.eigvals(F)).max() >= 1 - 1e-10:
        return False
    rest = solve_discrete_lyapunov(F, change)
    return np.abs(rest / np.outer(units, units)).max() <= SETTLED


def _means(model, mean, z, known, numbers, matrices):
    """Predicted and corrected estimates; stretches of one gain by one recursion, what lies between
    by another."""
    series, count, n = len(z), z.shape[1], len(mean)
    Phis, Hs = model._all("Phi", count), model._all("H", count)
    predicted = np.empty((series, count, n))
    x, k = np.broadcast_to(mean, (series, n)), 0
    changes = np.append(np.flatnonzero(np.diff(numbers)) + 1, count)
    # Where the stretches of one gain begin that are long enough for a recursion of their own.
    long = np.flatnonzero(np.diff(np.append(0, changes)) > BLOCK)
    ends = [(int(changes[i - 1]) if i else 0, int(changes[i])) for i in long]
    for begin, end in [*ends, (count, count)]:
        for low, high, alike in ((k, begin, False), (begin, end, True)):
            if low == high:
                continue
            part = slice(low, high)
            K = matrices[2][numbers[low] if alike else numbers[part]]
            Phi, H = (Phis[low], Hs[low]) if alike else (Phis[part], Hs[part])
            inputs = _times(Phi @ K, z[:, part])
            if known is not None:
                inputs = inputs + known[:, part]
            states = (recursion if alike else varying_recursion)(
                Phi @ (np.eye(n) - K @ H), inputs, x
            )
            predicted[:, part], x = states[:, :-1], states[:, -1]
        k = end
    gains = matrices[2][numbers] if len(matrices[2]) > 1 else matrices[2][0]
    H = model.H
    return predicted, predicted + _times(gains, z - _times(H, predicted))


def _times(matrix, vectors):
    """Each vector (S x N x n) by one matrix, or by that of its step."""
    if matrix.ndim == 2:
        return vectors @ matrix.T
    return np.einsum("kij,skj->ski", matrix, vectors)


def _hold(covariances):
    """No covariance may have lost its definiteness to rounding."""
    variances = np.einsum("kii->ki", covariances)
    units = np.sqrt(np.where(variances > 0, variances, 1))
    least = np.linalg.eigvalsh(covariances / (units[:, :, None] * units[:, None, :])).min()
    if not (least > -ROUNDING and (variances >= 0).all()):
        raise ValueError(LOST)
