"""Fixed-interval smoother of Rauch, Tung and Striebel (1965): estimates from all measurements.

Backwards from the last step, where both are those of the filter,

    C_k = P_k^+ Phi_k^T (P_{k+1}^-)^-1,
    x_k = x_k^+ + C_k (x_{k+1} - x_{k+1}^-),
    P_k = (E - C_k Phi_k) P_k^+ (E - C_k Phi_k)^T + C_k (P_{k+1} + Q_k) C_k^T,

the last equal to P_k^+ + C_k (P_{k+1} - P_{k+1}^-) C_k^T, but a sum of covariances whatever the rounding
of C_k. Missing measurements and steps of different lengths need nothing of their own. Where P^- is
singular, a state being known exactly, its pseudo-inverse stands for the inverse.

While C_k is constant, the estimates are a linear recursion and the covariances converge. Other long
records of linear models are smoothed in `segments` by the recursion of Bryson and Frazier, which needs no
inverse of P^-. It ends in a difference of covariances; where most digits cancel, the step above is taken.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajlib._typing import ArrayLike
from trajlib.estimation.filter_covariances import BLOCK, settled
from trajlib.estimation.filter_plots import plot_states
from trajlib.estimation.recursion import recursion
from trajlib.estimation.segments import number_of_segments, smoothed_segments

#: A scaled covariance whose inverse is greater than this is singular within rounding.
SINGULAR = 1e13
#: Variances that become smaller than this share lose digits in the difference of Bryson and Frazier.
CANCELLED = 1e-4
#: With fewer different matrices than this share of the steps, those that repeat are taken together.
REPEATED = 1 / 8


@dataclass(frozen=True, repr=False)
class SmoothedRun:
    """Estimates from all measurements of an interval: N steps, n states.

    With S series each array has S as its first dimension.

    Attributes
    ----------
    times : ndarray, shape (N,)
        Times, or step numbers.
    estimates : ndarray, shape (N, n)
        Estimates of x_k from z_0, ..., z_{N-1}.
    """

    times: np.ndarray
    estimates: np.ndarray
    _covariances: np.ndarray
    _group: np.ndarray | None

    @property
    def covariances(self) -> np.ndarray:
        """Covariances of the errors, shape (N, n, n)."""
        return self._covariances[0 if self._group is None else self._group]

    def plot(self, series: int = 0, truth: ArrayLike | None = None) -> np.ndarray:
        """Draw each state over time with a band of two standard deviations.

        Parameters
        ----------
        series : int
            Index of the series, if there are several.
        truth : array_like, shape (N, n), optional
            True states, drawn beside the estimates.

        Returns
        -------
        ndarray of matplotlib.axes.Axes, shape (n,)
        """
        estimates = self.estimates.reshape(-1, *self.estimates.shape[-2:])[series]
        covariances = self._covariances[0 if self._group is None else self._group[series]]
        return plot_states(self.times, estimates, covariances, truth, "from all measurements")

    def __repr__(self):
        return f"SmoothedRun of {self.estimates.shape[-2]} steps, {self.estimates.shape[-1]} states"


def smooth(run, times, transitions, steps):
    """Return the `SmoothedRun` of a filter's run.

    `transitions` are Phi, Q and H, each one matrix or one for each step (H is None if a map is not
    linear), and `steps` the matrices of the filter to which `run.matrix_index` refers.
    """
    single = run.estimates.ndim == 2
    predicted, estimates, innovations, index = (
        part[None] if single else part
        for part in (run.predicted, run.estimates, run.innovations, run.matrix_index)
    )
    smoothed = np.array(estimates)
    # Series with the same matrices have the same covariances.
    patterns: dict[bytes, list[int]] = {}
    for i, pattern in enumerate(index):
        patterns.setdefault(pattern.tobytes(), []).append(i)
    group = np.empty(len(index), dtype=np.int64)
    covariances = np.empty((len(patterns), *estimates.shape[1:], estimates.shape[-1]))
    for number, members in enumerate(patterns.values()):
        group[members], pattern = number, index[members[0]]
        own = predicted[members], estimates[members], innovations[members]
        smoothed[members], covariances[number] = _smoothed(*own, transitions, steps, pattern)
    return SmoothedRun(
        times, smoothed[0] if single else smoothed, covariances, None if single else group
    )


def _smoothed(predicted, estimates, innovations, transitions, steps, index):
    Phi, Q, H = transitions
    (count, n), states = estimates.shape[1:], estimates.copy()
    rows = slice(index[0], index[-1] + 1)
    after, gains, inverses = (steps[i][rows] for i in (1, 2, 4))
    index, distinct, covariances = index - index[0], len(after), np.empty((count, n, n))
    covariances[-1], left = after[-1], np.arange(count - 1)
    segments = 1 if H is None or distinct < REPEATED * count else number_of_segments(count, n)
    if segments > 1:
        head, filtered = count % segments, after
        if distinct < count:
            filtered, gains, inverses = after[index], gains[index], inverses[index]
        matrices = [M if M.ndim == 2 else M[head:] for M in (Phi, H)]
        states[:, head:], covariances[head:] = smoothed_segments(
            *matrices,
            gains[head:],
            inverses[head:],
            np.nan_to_num(innovations[:, head:]),
            filtered[head:],
            estimates[:, head:],
            segments,
        )
        variances = [np.einsum("kii->ki", P)[:-1] for P in (covariances, filtered)]
        lost = ~(variances[0] >= CANCELLED * variances[1]).all(axis=1)
        left = np.flatnonzero(lost | (left < head))
    # Steps beside each other with the same matrices are taken together.
    new = (np.diff(left, prepend=-2) != 1) | (np.diff(index[left], prepend=-1) != 0)
    firsts, ends = left[new], left[np.roll(new, -1)] + 1
    matrices = [M if M.ndim == 2 else M[firsts] for M in (Phi, Q)]
    gains, noises = _gains(after[index[firsts]], *matrices)
    corrections = estimates - predicted
    for first, end, C, noise in zip(*(part[::-1] for part in (firsts, ends, gains, noises))):
        forcing = corrections[:, first + 1 : end + 1][:, ::-1] @ C.T
        changes = recursion(C, forcing, states[:, end] - estimates[:, end])
        states[:, first:end] = estimates[:, first:end] + changes[:, :0:-1]
        for k in range(end - 1, first - 1, -1):
            P = C @ covariances[k + 1] @ C.T + noise
            covariances[k] = P = (P + P.T) / 2
            if k > first and settled(C, P, P - covariances[k + 1]):
                covariances[first:k] = P
                break
    return states, covariances


def _gains(P, Phi, Q):
    """Return C_k and (E - C_k Phi_k) P_k^+ (E - C_k Phi_k)^T + C_k Q_k C_k^T for each step."""
    gains, noises = np.empty_like(P), np.empty_like(P)
    size = max(1, BLOCK // P.shape[-1] ** 2)
    for first in range(0, len(P), size):
        part = slice(first, min(first + size, len(P)))
        matrices = (M if M.ndim == 2 else M[part] for M in (Phi, Q))
        gains[part], noises[part] = _gains_of_block(P[part], *matrices)
    return gains, noises


def _gains_of_block(P, Phi, Q):
    transported = Phi @ P
    predicted = transported @ np.swapaxes(np.broadcast_to(Phi, P.shape), 1, 2) + Q
    gains = np.swapaxes(pseudo_solve(predicted, transported), 1, 2)
    reduction = np.eye(P.shape[-1]) - gains @ Phi
    noises = reduction @ P @ np.swapaxes(reduction, 1, 2) + gains @ Q @ np.swapaxes(gains, 1, 2)
    return gains, (noises + np.swapaxes(noises, 1, 2)) / 2


def pseudo_solve(covariances, right):
    """Return P^-1 B for stacks of covariances, P^+ B where P is singular within rounding."""
    n = covariances.shape[-1]
    units = np.sqrt(np.einsum("kii->ki", covariances))
    units = np.where(units > 0, units, 1.0)
    scaled = covariances / (units[:, :, None] * units[:, None, :])
    # So little more noise than rounding that only what is singular is changed by it.
    inverses = np.linalg.inv(scaled + np.finfo(float).eps * np.eye(n))
    for k in np.flatnonzero(np.abs(inverses).max(axis=(1, 2), initial=0) > SINGULAR):
        inverses[k] = np.linalg.pinv(scaled[k], rcond=1 / SINGULAR, hermitian=True)
    return inverses @ (right / units[:, :, None]) / units[:, :, None]
