"""Kalman filter in discrete time on arrays (Theorem 4.1), with missing measurements.

While the gain is constant, the estimates obey x_{k+1} = F x_k + Phi K z_k with F = Phi (E - KH),
which runs in blocks.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_vector
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import ArrayLike
from trajlib.estimation.covariances import Moments
from trajlib.estimation.filter_covariances import at_steps, check_definiteness, filter_covariances
from trajlib.estimation.recursion import BLOCK, recursion, varying_recursion


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
    """

    predicted: np.ndarray
    estimates: np.ndarray
    innovations: np.ndarray
    matrix_index: np.ndarray
    log_likelihood: float | np.ndarray | None
    _steps: tuple[np.ndarray, ...]

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

    def __repr__(self):
        return (
            f"FilterRun of {self.estimates.shape[-2]} steps, {self.estimates.shape[-1]} states, "
            f"{self.innovations.shape[-1]} outputs, log-likelihood "
            f"{np.round(self.log_likelihood, 3)}"
        )


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
        Covariance of r_k, positive definite.

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

    def __post_init__(self):
        Phi = _stack(self.Phi, lambda matrix: read_matrix(matrix, "Phi", None, None, True))
        n = Phi.shape[-1]
        if Phi.shape[-2] != n:
            raise ValueError(f"Phi: expected a square matrix, got the shape {Phi.shape[-2:]}")
        H = _stack(self.H, lambda matrix: read_matrix(matrix, "H", None, n, True))
        Q = _stack(self.Q, lambda matrix: read_covariance(matrix, "Q", n, True))
        R = _stack(
            self.R, lambda matrix: read_covariance(matrix, "R", H.shape[-2], True, definite=True)
        )
        for name, matrix in zip(["Phi", "H", "Q", "R"], (Phi, H, Q, R)):
            object.__setattr__(self, name, matrix)

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
            else np.broadcast_to(np.asarray(inputs, dtype=float), (series, count, n))
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
        steps = tuple(np.concatenate(part) for part in zip(*parts))
        check_definiteness(steps[0])
        check_definiteness(steps[1])
        innovations = np.where(missing, np.nan, z - _times(self.H, predicted))
        run = FilterRun(predicted, estimates, innovations, index, None, steps)
        likelihood = -(run.normalised_innovations + steps[5][index]).sum(axis=1) / 2
        if single:
            return FilterRun(
                predicted[0], estimates[0], innovations[0], index[0], float(likelihood[0]), steps
            )
        return FilterRun(predicted, estimates, innovations, index, likelihood, steps)

    def _measurements(self, z, missing):
        if isinstance(z, np.ma.MaskedArray):
            if missing is not None:
                raise ValueError(
                    "missing: z is a masked array, which marks missing measurements itself"
                )
            z, missing = np.ma.getdata(z), np.ma.getmaskarray(z)
        z = np.asarray(z, dtype=float)
        m = self.H.shape[-2]
        shape = z.shape
        if z.ndim == 1 and m == 1:
            z = z[:, None]
        if z.ndim not in (2, 3) or z.shape[-1] != m or 0 in z.shape:
            raise ValueError(f"z: expected the shape (N, {m}) or (series, N, {m}), got {shape}")
        if missing is None:
            gaps = np.zeros(z.shape, dtype=bool)
        else:
            gaps = np.asarray(missing)
            if gaps.dtype != bool or gaps.shape not in (z.shape, z.shape[:-1], shape):
                raise ValueError(
                    f"missing: expected booleans of the shape {shape} or {z.shape[:-1]}, got "
                    f"{gaps.dtype} of the shape {gaps.shape}"
                )
            gaps = np.broadcast_to(gaps if gaps.ndim == z.ndim else gaps[..., None], z.shape)
        if not np.isfinite(z[~gaps]).all():
            entry = tuple(int(i) for i in np.argwhere(~np.isfinite(z) & ~gaps)[0])
            raise ValueError(
                f"z: the measurement {entry} is {z[entry]}; mark it in `missing` if there is none"
            )
        z = np.where(gaps, 0.0, z)
        for name in ("Phi", "H", "Q", "R"):
            matrix = getattr(self, name)
            if matrix.ndim == 3 and len(matrix) != z.shape[-2]:
                raise ValueError(
                    f"{name}: expected {z.shape[-2]} matrices, one for each step, got {len(matrix)}"
                )
        return z.reshape((-1, *z.shape[-2:])), gaps.reshape((-1, *z.shape[-2:])), z.ndim == 2


def _stack(matrices, read):
    if any_floats(matrices) and np.ndim(matrices) == 3:
        return np.stack([read(matrix) for matrix in matrices])
    return read(matrices)


def _means(model, mean, z, inputs, index, matrices):
    """Return predicted and corrected estimates.

    Stretches of constant gain use one recursion, the steps between them another.
    """
    series, count, n = len(z), z.shape[1], len(mean)
    Phis, Hs = at_steps(model.Phi, count), at_steps(model.H, count)
    predicted = np.empty((series, count, n))
    x, k = np.broadcast_to(mean, (series, n)), 0
    changes = np.append(np.flatnonzero(np.diff(index)) + 1, count)
    # Stretches of constant gain that are long enough for a recursion of their own.
    long = np.flatnonzero(np.diff(np.append(0, changes)) > BLOCK)
    ends = [(int(changes[i - 1]) if i else 0, int(changes[i])) for i in long]
    for first, last in [*ends, (count, count)]:
        for start, stop, constant in ((k, first, False), (first, last, True)):
            if start == stop:
                continue
            part = slice(start, stop)
            K = matrices[2][index[start] if constant else index[part]]
            Phi, H = (Phis[start], Hs[start]) if constant else (Phis[part], Hs[part])
            forcing = _times(Phi @ K, z[:, part])
            if inputs is not None:
                forcing = forcing + inputs[:, part]
            states = (recursion if constant else varying_recursion)(
                Phi @ (np.eye(n) - K @ H), forcing, x
            )
            predicted[:, part], x = states[:, :-1], states[:, -1]
        k = last
    gains = matrices[2][index] if len(matrices[2]) > 1 else matrices[2][0]
    H = model.H
    return predicted, predicted + _times(gains, z - _times(H, predicted))


def _times(matrix, vectors):
    """Return the product of each vector (S x N x n) with one matrix, or with that of its step."""
    if matrix.ndim == 2:
        return vectors @ matrix.T
    return np.einsum("kij,skj->ski", matrix, vectors)
