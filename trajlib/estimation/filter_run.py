"""Result of a Kalman filter in discrete time, linear or not."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from trajlib._typing import ArrayLike
from trajlib.estimation.filter_plots import plot_innovations, plot_states
from trajlib.estimation.smoother import SmoothedRun, smooth


@dataclass(frozen=True, repr=False)
class FilterRun:
    """Result of a Kalman filter: N steps, n states, m outputs.

    With S series each array of data has S as its first dimension.

    Attributes
    ----------
    predicted : ndarray, shape (N, n)
        Estimates x~_k^- before the measurement z_k.
    estimates : ndarray, shape (N, n)
        Estimates x~_k^+ after it.
    innovations : ndarray, shape (N, m)
        z_k - H x~_k^-, nan where a measurement is missing.
    matrix_index : ndarray, shape (N,)
        For each step the index of its matrices among those that differ.
    log_likelihood : float or ndarray
        Log-likelihood of the measurements under the model for normal errors, one number a series.
    times : ndarray, shape (N,)
        Times of the steps, or their numbers.
    """

    predicted: np.ndarray
    estimates: np.ndarray
    innovations: np.ndarray
    matrix_index: np.ndarray
    log_likelihood: float | np.ndarray | None
    times: np.ndarray
    _steps: tuple[np.ndarray, ...]
    _transitions: tuple[np.ndarray, np.ndarray, np.ndarray | None]

    @property
    def covariances(self) -> np.ndarray:
        """Covariances P_k^+ after the measurements, shape (N, n, n)."""
        return self._steps[1][self.matrix_index]

    @property
    def predicted_covariances(self) -> np.ndarray:
        """Covariances P_k^- before the measurements, shape (N, n, n)."""
        return self._steps[0][self.matrix_index]

    @property
    def gains(self) -> np.ndarray:
        """Gains K_k, shape (N, n, m); zero in the columns of missing measurements."""
        return self._steps[2][self.matrix_index]

    @property
    def innovation_covariances(self) -> np.ndarray:
        """Covariances H P_k^- H^T + R, shape (N, m, m), those of missing measurements included."""
        return self._steps[3][self.matrix_index]

    @property
    def normalised_innovations(self) -> np.ndarray:
        """Normalised squares nu^T S^-1 nu of the innovations, shape (N,).

        Notes
        -----
        For the right model each is chi-squared with `measured` degrees of freedom.
        """
        innovations = np.nan_to_num(self.innovations)
        return np.einsum(
            "...ki,...kij,...kj->...k", innovations, self._steps[4][self.matrix_index], innovations
        )

    @property
    def measured(self) -> np.ndarray:
        """Number of components measured at each step, shape (N,)."""
        return (~np.isnan(self.innovations)).sum(axis=-1)

    def smoothed(self) -> SmoothedRun:
        """Return the estimates of all states from all measurements, of the past and of the future.

        Returns
        -------
        SmoothedRun

        Notes
        -----
        The fixed-interval smoother of Rauch, Tung and Striebel; measurements may be missing, and steps
        may differ in length. MATLAB: ``smoother``; filterpy: ``rts_smoother``. Source: added to the
        problem book.

        Examples
        --------
        >>> import numpy as np
        >>> from trajlib.estimation import KalmanFilter, Moments
        >>> run = KalmanFilter(1, 1, 1, 1).run(np.array([1.0, 3.0]), Moments(0, 1))
        >>> smoothed = run.smoothed()
        >>> smoothed.estimates.ravel().round(9).tolist(), smoothed.covariances.ravel().round(9).tolist()
        ([1.0, 2.0], [0.4, 0.6])
        """
        return smooth(self, self.times, self._transitions, self._steps)

    def plot(self, series: int = 0, truth: ArrayLike | None = None) -> np.ndarray:
        """Draw each state with a band of two standard deviations, and below the innovations.

        Parameters
        ----------
        series : int
            Index of the series, if there are several.
        truth : array_like, shape (N, n), optional
            True states, drawn beside the estimates.

        Returns
        -------
        ndarray of matplotlib.axes.Axes, shape (n + 1,)
            One for each state, the last for the innovations in units of their standard deviations: of
            the right model 19 of 20 lie between -2 and 2.
        """
        estimates, innovations, index = (
            part.reshape(-1, *part.shape[part.ndim - dimensions :])[series]
            for part, dimensions in (
                (self.estimates, 2),
                (self.innovations, 2),
                (self.matrix_index, 1),
            )
        )
        axes = plot_states(
            self.times, estimates, self._steps[1][index], truth, "from measurements so far", rows=1
        )
        plot_innovations(self.times, innovations, self._steps[3][index], axes[-1])
        return axes

    def __repr__(self):
        return (
            f"FilterRun of {self.estimates.shape[-2]} steps, {self.estimates.shape[-1]} states, "
            f"{self.innovations.shape[-1]} outputs, log-likelihood "
            f"{np.round(self.log_likelihood, 3)}"
        )


def finished_run(predicted, estimates, innovations, index, times, steps, transitions, single):
    """Return the `FilterRun` with its log-likelihood, of the one series if it is `single`.

    `steps` are P-, P+, K, S, the inverse of S for what is measured, and log det S + m log 2 pi.
    """
    run = FilterRun(predicted, estimates, innovations, index, None, times, steps, transitions)
    likelihood = -(run.normalised_innovations + steps[5][index]).sum(axis=1) / 2
    if not single:
        return replace(run, log_likelihood=likelihood)
    return FilterRun(
        predicted[0],
        estimates[0],
        innovations[0],
        index[0],
        float(likelihood[0]),
        times,
        steps,
        transitions,
    )
