"""Fixed-interval smoother of Rauch, Tung and Striebel (1965): estimates from all measurements.

Backwards from the last step, where both are those of the filter,

    C_k = P_k^+ Phi_k^T (P_{k+1}^-)^-1,
    x_k = x_k^+ + C_k (x_{k+1} - x_{k+1}^-),
    P_k = (E - C_k Phi_k) P_k^+ (E - C_k Phi_k)^T + C_k (P_{k+1} + Q_k) C_k^T,

the last equal to P_k^+ + C_k (P_{k+1} - P_{k+1}^-) C_k^T, but a sum of covariances whatever the rounding
of C_k. Missing measurements and steps of different lengths need nothing of their own. Where P^- is
singular, a state being known exactly, its pseudo-inverse stands for the inverse.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajlib._typing import ArrayLike
from trajlib.estimation.filter_plots import plot_states
from trajlib.estimation.recursion import congruence_recursion, varying_recursion

#: A scaled covariance whose inverse is greater than this is singular within rounding.
SINGULAR = 1e13


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

    `transitions` are Phi and Q, each one matrix or one for each step, and `steps` the covariances
    P^+ to which `run.matrix_index` refers.
    """
    single = run.estimates.ndim == 2
    predicted, estimates, index = (
        part[None] if single else part for part in (run.predicted, run.estimates, run.matrix_index)
    )
    smoothed = np.array(estimates)
    patterns, group = np.unique(index, axis=0, return_inverse=True)
    covariances = np.empty((len(patterns), *estimates.shape[1:], estimates.shape[-1]))
    for number, pattern in enumerate(patterns):
        members = np.flatnonzero(group.ravel() == number)
        gains, noises = _gains(steps, pattern[:-1], *transitions)
        forcing = estimates[members, :-1] - np.einsum("kij,skj->ski", gains, predicted[members, 1:])
        backwards = varying_recursion(gains[::-1], forcing[:, ::-1], estimates[members, -1])
        smoothed[members] = backwards[:, ::-1]
        covariances[number] = congruence_recursion(gains[::-1], noises[::-1], steps[pattern[-1]])[
            ::-1
        ]
    return SmoothedRun(
        times, smoothed[0] if single else smoothed, covariances, None if single else group.ravel()
    )


def _gains(steps, index, Phi, Q):
    """Return C_k and (E - C_k Phi_k) P_k^+ (E - C_k Phi_k)^T + C_k Q_k C_k^T for each step."""
    if Phi.ndim == 2 and Q.ndim == 2:
        # Steps with the same covariance have the same gain.
        distinct, position = np.unique(index, return_inverse=True)
        gains, noises = _gains_of_steps(steps[distinct], Phi, Q)
        return gains[position], noises[position]
    Phi, Q = (M if M.ndim == 2 else M[: len(index)] for M in (Phi, Q))
    return _gains_of_steps(steps[index], Phi, Q)


def _gains_of_steps(P, Phi, Q):
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
