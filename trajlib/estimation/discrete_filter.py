"""Kalman filter in discrete time on arrays (Theorem 4.1), with missing measurements.

While the gain is constant, the estimates obey x_{k+1} = F x_k + Phi K z_k with F = Phi (E - KH),
which runs in blocks.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.covariances import read_covariance, read_covariance_stack
from trajlib._arguments.matrices import read_square, read_vector
from trajlib._arguments.numbers import read_times
from trajlib._arguments.records import read_inputs, read_record, read_stack
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import ArrayLike
from trajlib.estimation.covariances import Moments
from trajlib.estimation.filter_covariances import filter_covariances
from trajlib.estimation.filter_run import FilterRun, finished_run
from trajlib.estimation.recursion import BLOCK, recursion
from trajlib.estimation.segments import mean_segments, number_of_segments
from trajlib.estimation.van_loan import discretise_steps


@accepts_state_space(
    "Phi",
    "H",
    time="discrete",
    instead="discretise it first",
    A="Phi",
    F="Phi",
    C="H",
    QN="Q",
    RN="R",
)
@dataclass(frozen=True)
class KalmanFilter:
    """Kalman filter of x_{k+1} = Phi x_k + q_k, z_k = H x_k + r_k.

    Each matrix may be a stack with a matrix for each step (N x ...); Phi_k and Q_k lead from step
    k to k + 1.

    Parameters
    ----------
    Phi : array_like, shape (n, n)
        Transition matrix. A StateSpace stands for Phi and H: `KalmanFilter(sys, Q, R)`.
    H : array_like, shape (m, n)
        Measurement matrix.
    Q : array_like, shape (n, n)
        Covariance of q_k, positive semidefinite.
    R : array_like, shape (m, m)
        Covariance of r_k, positive semidefinite; a variance zero is an exact measurement, which gives
        an error where it repeats what is known exactly already.
    times : array_like, shape (N,), optional
        Times of the steps, for pictures; `sampled` sets them.

    Raises
    ------
    ValueError
        If shapes do not fit or Q or R is no covariance.

    Notes
    -----
    Keywords of python-control: `A`, `C`, `QN`, `RN` for `Phi`, `H`, `Q`, `R`; of filterpy: `F` for
    `Phi`. With a system python-control takes QN for the noise of the inputs; here that is
    Q = B QN B^T.
    All is computed in floats. MATLAB: ``kalman``; filterpy: ``KalmanFilter``. Source: Theorem 4.1.

    Examples
    --------
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
    times: np.ndarray | None = None

    def __post_init__(self):
        Phi = read_stack(self.Phi, "Phi", None, None)
        n = Phi.shape[-1]
        if Phi.shape[-2] != n:
            raise ValueError(f"Phi: expected a square matrix, got the shape {Phi.shape[-2:]}")
        H = read_stack(self.H, "H", None, n)
        Q = read_stack(self.Q, "Q", n, n, read_covariance_stack)
        R = read_stack(self.R, "R", H.shape[-2], H.shape[-2], read_covariance_stack)
        for name, matrix in zip(["Phi", "H", "Q", "R"], (Phi, H, Q, R)):
            object.__setattr__(self, name, matrix)

    @staticmethod
    @accepts_state_space(
        "A", "H", time="continuous", instead="use KalmanFilter(sys, Q, R)", C="H", QN="Q", RN="R"
    )
    def sampled(
        A: ArrayLike, H: ArrayLike, Q: ArrayLike, R: ArrayLike, times: ArrayLike
    ) -> KalmanFilter:
        """Return the filter of x' = Ax + q for measurements z_k = H x(t_k) + r_k at given times.

        Parameters
        ----------
        A : array_like, shape (n, n)
            Matrix of the system. A StateSpace in continuous time stands for A and H:
            `KalmanFilter.sampled(sys, Q, R, times)`.
        H : array_like, shape (m, n)
            Measurement matrix.
        Q : array_like, shape (n, n)
            Intensity of q, positive semidefinite.
        R : array_like, shape (m, m)
            Covariance of r_k.
        times : array_like, shape (N,)
            Times of the measurements, at any distances, not decreasing; or dates.

        Returns
        -------
        KalmanFilter
            With matrices of each step, exact for steps of any length; `run` takes N rows.

        Raises
        ------
        ValueError
            If shapes do not fit, times decrease, or Q or R is no covariance.

        Notes
        -----
        Keywords of python-control: `C`, `QN`, `RN` for `H`, `Q`, `R`. Source: (4.6), (4.7) with Theorem
        4.1.

        Examples
        --------
        >>> import numpy as np
        >>> from trajlib.estimation import Moments
        >>> filter = KalmanFilter.sampled(0, 1, 1, 1, [0, 1, 4])    # a random walk
        >>> filter.run(np.zeros(3), Moments(0, 1)).predicted_covariances.ravel().tolist()
        [1.0, 1.5, 3.6]
        """
        times = read_times(times, repeated=None)
        A = read_square(A, "A", True)
        Q = read_covariance(Q, "Q", len(A), True)
        filter = KalmanFilter(A, H, Q, R, times)
        # The last step leads nowhere.
        Phi, noise = discretise_steps(A, Q, np.append(np.diff(times), 0.0))
        object.__setattr__(filter, "Phi", Phi)
        object.__setattr__(filter, "Q", noise)
        return filter

    def run(
        self,
        z: ArrayLike,
        start: Moments,
        missing: ArrayLike | None = None,
        inputs: ArrayLike | None = None,
    ) -> FilterRun:
        """Filter the measurements and return an estimate before and after each.

        Parameters
        ----------
        z : array_like, shape (N, m)
            Measurements; of shape (N,) for one output, (S, N, m) for S series of the same model. A
            masked array marks its missing measurements itself.
        start : Moments
            Mean and covariance of x at the time of the first measurement, before it.
        missing : array_like, optional
            Booleans of the shape of z, or (N,) or (S, N) for whole rows; True where there is no
            measurement.
        inputs : array_like, shape (N, n), optional
            Known inputs B u_k of x_{k+1} = Phi x_k + B u_k + q_k; of shape (S, N, n) for S series.

        Returns
        -------
        FilterRun

        Raises
        ------
        ValueError
            If a measurement is not finite and not marked as missing, if shapes do not fit, or if a
            covariance has lost its definiteness to rounding.
        """
        z, missing, single = self._measurements(z, missing)
        series, count, _m = z.shape
        n = self.Phi.shape[-1]
        mean = read_vector(start.mean, "mean", n, True)
        P = read_covariance(start.covariance, "covariance", n, True)
        inputs = (
            None
            if inputs is None
            else np.broadcast_to(read_inputs(inputs, count, n, series), (series, count, n))
        )
        predicted, estimates = np.empty((series, count, n)), np.empty((series, count, n))
        index, parts, offset = np.empty((series, count), dtype=np.int64), [], 0
        # Series with the same gaps have the same covariances.
        groups: dict[bytes, list[int]] = {}
        for i, pattern in enumerate(missing):
            groups.setdefault(pattern.tobytes(), []).append(i)
        for members in groups.values():
            own_index, matrices = filter_covariances(self, P, missing[members[0]])
            index[members] = own_index + offset
            offset += len(matrices[0])
            parts.append(matrices)
            predicted[members], estimates[members] = _means(
                self,
                mean,
                z[members],
                inputs if inputs is None else inputs[members],
                own_index,
                matrices,
            )
        steps = tuple(part[0] if len(part) == 1 else np.concatenate(part) for part in zip(*parts))
        innovations = np.where(missing, np.nan, z - _times(self.H, predicted))
        times = np.arange(count, dtype=float) if self.times is None else self.times
        return finished_run(
            predicted,
            estimates,
            innovations,
            index,
            times,
            steps,
            (self.Phi, self.Q, self.H),
            single,
        )

    def __repr__(self):
        return f"KalmanFilter of {self.Phi.shape[-1]} states, {self.H.shape[-2]} outputs"

    def _measurements(self, z, missing):
        z, missing, single = read_record(z, missing, self.H.shape[-2])
        count = z.shape[1]
        for name in ("Phi", "H", "Q", "R"):
            matrix = getattr(self, name)
            if matrix.ndim == 3 and len(matrix) != count:
                raise ValueError(
                    f"{name}: expected {count} matrices, one for each step, got {len(matrix)}"
                )
        if self.times is not None and len(self.times) != count:
            raise ValueError(f"z: expected a row for each of {len(self.times)} times, got {count}")
        return z, missing, single


def _means(model, mean, z, inputs, index, matrices):
    """Return predicted and corrected estimates.

    Stretches of constant gain use one recursion, the steps between them another.
    """
    series, count, n = len(z), z.shape[1], len(mean)
    changes = np.append(np.flatnonzero(np.diff(index)) + 1, count)
    # Stretches of constant gain that are long enough for a recursion of their own.
    long = np.flatnonzero(np.diff(np.append(0, changes)) > BLOCK)
    ends = [(int(changes[i - 1]) if i else 0, int(changes[i])) for i in long]
    predicted = np.empty((series, count, n))
    x, k = np.broadcast_to(mean, (series, n)), 0
    for first, last in [*ends, (count, count)]:
        for start, stop, constant in ((k, first, False), (first, last, True)):
            if start == stop:
                continue
            part = slice(start, stop)
            Phi, H = (M if M.ndim == 2 else M[part] for M in (model.Phi, model.H))
            gains = matrices[2][index[part]]
            stretch_inputs = None if inputs is None else inputs[:, part]
            if constant:
                Phi, H, K = (M if M.ndim == 2 else M[0] for M in (Phi, H, gains))
                forcing = z[:, part] @ (Phi @ K).T
                forcing = forcing if stretch_inputs is None else forcing + stretch_inputs
                states = recursion(Phi @ (np.eye(n) - K @ H), forcing, x)
            else:
                # Many series are enough work for a step.
                segments = 1 if series > n else number_of_segments(stop - start, n)
                states = mean_segments(Phi, H, gains, z[:, part], stretch_inputs, x, segments)
            predicted[:, part], x = states[:, :-1], states[:, -1]
        k = last
    gains = matrices[2][index] if len(matrices[2]) > 1 else matrices[2][0]
    return predicted, predicted + _times(gains, z - _times(model.H, predicted))


def _times(matrix, vectors):
    """Return the product of each vector (S x N x n) with one matrix, or with that of its step."""
    if matrix.ndim == 2:
        return vectors @ matrix.T
    return np.einsum("kij,skj->ski", matrix, vectors)
