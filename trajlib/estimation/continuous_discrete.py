"""Continuous-discrete Kalman filter.

Prediction follows (4.6), (4.7), with a correction at each measurement. Measurements may come at any
times, several at one time, and with missing components.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_exact_expression
from trajlib._typing import MatrixLike, ScalarLike
from trajlib.estimation.correction import corrected
from trajlib.estimation.covariances import Moments, trusted_moments
from trajlib.estimation.exact_or_float import solve, symmetric, tidy
from trajlib.estimation.markov import continuous_moments, discretise


@dataclass(frozen=True)
class Measurement:
    """Measurement z = H x(time) + r.

    Attributes
    ----------
    time : scalar_like
        Time.
    z : matrix_like
        m components, None for each that is missing (or None if all are).
    H : matrix_like, shape (m, n)
        Measurement matrix.
    R : matrix_like, shape (m, m)
        Covariance of r.
    """

    time: ScalarLike
    z: MatrixLike
    H: MatrixLike
    R: MatrixLike


@dataclass(frozen=True)
class ContinuousDiscreteRun:
    """Result of a continuous-discrete filter.

    Attributes
    ----------
    times : tuple
        Times of the measurements, increasing.
    before, after : tuple of Moments
        Mean and covariance of x at these times, before and after the measurement.
    corrections : tuple of Correction
        Corrections, None where all components were missing.
    """

    times: tuple
    before: tuple
    after: tuple
    corrections: tuple
    _process: tuple

    def at(self, t: ScalarLike) -> Moments:
        """Return the moments of x(t) given the measurements up to t, those at t included.

        Parameters
        ----------
        t : scalar_like
            Time from the initial time on; with symbols, a time after the last measurement.

        Returns
        -------
        Moments

        Raises
        ------
        ValueError
            If the time is before the initial time, or is a number where the measurements have
            symbols.
        """
        A, Q, start, initial_time = self._process
        t = read_exact_expression(t, "t")
        count = len(self.times) if t.free_symbols else sum(_is_past(time, t) for time in self.times)
        moments, time_of_moments = (
            (self.after[count - 1], self.times[count - 1]) if count else (start, initial_time)
        )
        return continuous_moments(A, Q, moments, t - time_of_moments)

    def smoothed(self) -> tuple[Moments, ...]:
        """Return the moments of x at the times of the measurements given all of them.

        Returns
        -------
        tuple of Moments
            Exact where the run is; at the last time those of the filter.

        Raises
        ------
        numpy.linalg.LinAlgError
            If a state is known exactly before a measurement, so that its covariance is singular.

        Notes
        -----
        The fixed-interval smoother of Rauch, Tung and Striebel. Source: added to the problem book.

        Examples
        --------
        >>> from trajlib.estimation import Moments
        >>> walk = [Measurement(0, 1, 1, 1), Measurement(1, 3, 1, 1)]
        >>> filter_measurements(0, 1, Moments(0, 1), walk).smoothed()[0].mean
        Matrix([[1]])
        """
        A, Q, _, _ = self._process
        moments = list(self.after)
        for k in range(len(moments) - 2, -1, -1):
            Phi = discretise(A, Q, self.times[k + 1] - self.times[k]).Phi
            after, before, later = self.after[k], self.before[k + 1], moments[k + 1]
            gain = solve(before.covariance, Phi @ after.covariance).T
            change = gain @ (later.covariance - before.covariance) @ gain.T
            moments[k] = trusted_moments(
                tidy(after.mean + gain @ (later.mean - before.mean)),
                symmetric(after.covariance + change),
            )
        return tuple(moments)

    def path(self, until: float, component: int = 0, count: int = 100) -> tuple:
        """Return the estimate of one component and its standard deviation over time, for a picture.

        Parameters
        ----------
        until : float
            Final time.
        component : int
            Index of the state.
        count : int
            Number of times for each interval between measurements.

        Returns
        -------
        tuple of ndarray
            Times, estimates and standard deviations; each time of a measurement occurs twice,
            before and after it.

        Notes
        -----
        For numbers only.
        """
        A, Q, start, initial_time = self._process
        A, Q = (
            np.asarray(matrix, dtype=float).reshape(A.shape)
            for matrix in (A, read_square(Q, "Q", False))
        )
        times = [time for time in self.times if time <= until]
        ends, rows = [initial_time, *times, until], []
        for low, high, moments in zip(ends, ends[1:], (start, *self.after)):
            moments = Moments(
                np.array(moments.mean, dtype=float).ravel(),
                np.array(moments.covariance, dtype=float),
            )
            for time in np.linspace(float(low), float(high), count):
                predicted = continuous_moments(A, Q, moments, time - float(low))
                rows.append((time, predicted.mean[component], predicted.deviations[component]))
        return tuple(np.array(rows).T)

    def __repr__(self):
        return f"ContinuousDiscreteRun of {len(self.times)} measurements"

    def _repr_latex_(self):
        last = self.after[-1]._repr_latex_() if self.after else "$$"
        return (
            rf"$\displaystyle t = {sp.latex(self.times[-1])}:\quad "
            + last[len(r"$\displaystyle ") :]
        )


@accepts_state_space("A", time="continuous", instead="use KalmanFilter")
def filter_measurements(
    A: MatrixLike,
    Q: MatrixLike,
    start: Moments,
    measurements: Iterable,
    initial_time: ScalarLike = 0,
) -> ContinuousDiscreteRun:
    """Return the optimal estimate of x' = Ax + q from measurements at discrete times.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols, or floats. A StateSpace stands for A.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    start : Moments
        Mean and covariance of x at the initial time.
    measurements : iterable of Measurement
        In any order (times with symbols: in order of time), with errors that are uncorrelated with
        one another.
    initial_time : scalar_like
        Initial time.

    Returns
    -------
    ContinuousDiscreteRun

    Raises
    ------
    ValueError
        If a measurement is before the initial time, shapes do not fit, Q or R is no covariance, or
        a measurement is nan, which does not mean "missing" here.

    Notes
    -----
    Each measurement may have its own H and R. For a long record of floats with one H and R
    `KalmanFilter.sampled` is a hundred times faster.
    Source: the remarks after Theorem 4.2, example 3, problems 4.26, 4.28 - 4.32.

    Examples
    --------
    >>> from trajlib.estimation import Moments
    >>> run = filter_measurements(-1, 1, Moments(1, 1), [Measurement(0, 2, 1, 1)])    # example 3
    >>> run.at(1).mean[0], run.at(1).covariance[0]
    (3*exp(-1)/2, 1/2)
    """
    floats = any_floats(A, Q, start.mean, start.covariance)
    A = read_square(A, "A", floats)
    initial_time = read_exact_expression(initial_time, "initial_time")
    ordered = [(read_exact_expression(entry.time, "time"), entry) for entry in measurements]
    if all(time.is_number for time, _ in ordered):
        ordered.sort(key=lambda entry: float(entry[0]))
    moments, time_of_moments, rows = start, initial_time, []
    for time, measurement in ordered:
        # With symbols the order is accepted unless it is known to be wrong.
        if sp.sympify(time >= time_of_moments) == sp.false:
            raise ValueError(
                f"measurements: the one at {time} comes before {time_of_moments}"
                + ", the initial time" * (time_of_moments == initial_time)
            )
        before = continuous_moments(A, Q, moments, time - time_of_moments)
        correction = _corrected(before, measurement)
        after = before if correction is None else correction.moments
        rows.append((time, before, after, correction))
        moments, time_of_moments = Moments(after.mean, after.covariance), time
    columns = zip(*rows) if rows else ((), (), (), ())
    times, priors, posteriors, corrections = (tuple(column) for column in columns)
    return ContinuousDiscreteRun(
        times, priors, posteriors, corrections, (A, Q, start, initial_time)
    )


def _is_past(time, t):
    if not time.is_number:
        raise ValueError(
            f"t: whether {t} comes after {time} is not known; ask for {time} + t instead"
        )
    return bool(time <= t)


def _corrected(before, measurement):
    if measurement.z is None:
        return None
    z = measurement.z
    z = z if isinstance(z, (list, tuple, np.ndarray, sp.MatrixBase)) else [z]
    present = [k for k, value in enumerate(z) if value is not None]
    if len(present) == len(z):
        return corrected(before, z, measurement.H, measurement.R)
    if not present:
        return None
    floats = any_floats(measurement.H, measurement.R)
    H, R = (
        read_matrix(measurement.H, "H", len(z), None, floats),
        read_matrix(measurement.R, "R", len(z), len(z), floats),
    )
    R_block = [[R[i, j] for j in present] for i in present]
    H_rows = [[H[i, j] for j in range(H.shape[1])] for i in present]
    make = np.array if floats else sp.Matrix
    return corrected(before, [z[k] for k in present], make(H_rows), make(R_block))
