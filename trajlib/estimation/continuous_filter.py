"""Kalman-Bucy filter for continuous measurements (Theorem 4.3).

The Riccati equation of its covariance is solved without integration:

    x~' = A x~ + K (z - H x~),    K = P H^T R^-1,    P' = A P + P A^T + Q - P S P,    S = H^T R^-1 H

becomes linear by P = Y X^-1 with X' = -A^T X + S Y, Y' = Q X + A Y, X(0) = E, Y(0) = P(0). In
floats the transition of a short step is written as P -> Q~ + F P (E + G P)^-1 F^T and doubled: all
three matrices stay bounded, where X and Y grow without limit and lose P in rounding.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import sympy as sp

from trajlib._arguments.arrays import read_finite_array
from trajlib._arguments.covariances import read_covariance, read_noise
from trajlib._arguments.matrices import any_floats, read_matrix, read_square, read_vector
from trajlib._arguments.numbers import read_count, read_times
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_duration
from trajlib._real_symbols import as_real
from trajlib._typing import ArrayLike, Matrix, MatrixLike, ScalarLike
from trajlib.estimation.covariances import Moments
from trajlib.estimation.exact_or_float import solve, symmetric
from trajlib.estimation.modes import Modes, continuous_basis, exact_spectrum
from trajlib.estimation.simulation import Paths, equal_steps, simulate_continuous
from trajlib.estimation.stationary_filters import StationaryFilter, stationary_filter


@accepts_state_space("A", "H", time="continuous", instead="use KalmanFilter", C="H", QN="Q", RN="R")
@dataclass(frozen=True)
class ContinuousFilter:
    """Kalman-Bucy filter of x' = Ax + q, z = Hx + r with white noises.

    Exact, also with symbols, or in floats.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system. A StateSpace stands for A and H: `ContinuousFilter(sys, Q, R)`.
    H : matrix_like, shape (m, n)
        Measurement matrix.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    R : matrix_like, shape (m, m)
        Intensity of r, positive definite.

    Raises
    ------
    ValueError
        If shapes do not fit or Q or R is no covariance.

    Notes
    -----
    Keywords of python-control: `C`, `QN`, `RN` for `H`, `Q`, `R`. With a system python-control takes
    QN for the noise of the inputs; here that is Q = B QN B^T.
    Source: Theorem 4.3, example 4, problems 4.33 - 4.42.

    Examples
    --------
    >>> import sympy as sp
    >>> t, p = sp.symbols("t p", positive=True)
    >>> filter = ContinuousFilter(0, 1, 0, 1)    # a constant
    >>> filter.covariance(p, t)[0], filter.rate(p)[0]
    (p/(p*t + 1), -p**2)
    """

    A: MatrixLike
    H: MatrixLike
    Q: MatrixLike
    R: MatrixLike

    def __post_init__(self):
        floats = any_floats(self.A, self.H, self.Q, self.R)
        A = read_square(self.A, "A", floats)
        H = read_matrix(self.H, "H", None, A.shape[0], floats)
        Q = read_covariance(self.Q, "Q", A.shape[0], floats)
        R = read_noise(self.R, H.shape[0], floats)
        for name, matrix in zip("AHQR", (A, H, Q, R)):
            object.__setattr__(self, name, matrix)

    def gain(self, P: MatrixLike) -> Matrix:
        """Return the gain K = P H^T R^-1.

        Parameters
        ----------
        P : matrix_like, shape (n, n)
            Covariance.

        Returns
        -------
        matrix, shape (n, m)
        """
        return solve(self.R, self.H @ self._read(P)).T

    def rate(self, P: MatrixLike) -> Matrix:
        """Return the right side of the Riccati equation.

        Parameters
        ----------
        P : matrix_like, shape (n, n)
            Covariance, or a symmetric matrix of symbols.

        Returns
        -------
        matrix, shape (n, n)
        """
        P = self._read(P)
        S = self.H.T @ solve(self.R, self.H)
        return symmetric(self.A @ P + P @ self.A.T + self.Q - P @ S @ P)

    def covariance(self, P: MatrixLike, t: ScalarLike) -> Matrix:
        """Return P(t) from P(0).

        Parameters
        ----------
        P : matrix_like, shape (n, n)
            Covariance P(0).
        t : scalar_like
            Time, t >= 0; for exact matrices also a symbol.

        Returns
        -------
        matrix, shape (n, n)

        Raises
        ------
        ValueError
            If P is no covariance or the time is negative.
        NotImplementedError
            If the eigenvalues of the Hamiltonian matrix need more than square roots.
        """
        P = self._read(P)
        floats = isinstance(P, np.ndarray)
        t = read_duration(t, "t", floats)
        S = self.H.T @ solve(self.R, self.H)
        return (
            propagate_riccati(P, *riccati_flow(self.A, S, self.Q, float(t)))
            if floats
            else riccati_closed_form(self.A, S, self.Q, P, t)
        )

    def run(self, averages: ArrayLike, times: ArrayLike, start: Moments) -> ContinuousRun:
        """Return estimates from averages of z over the steps between given times.

        Parameters
        ----------
        averages : array_like, shape (N, m)
            Integral of z over each step divided by its length; of shape (N,) for one output,
            (S, N, m) for S records.
        times : array_like, shape (N + 1,)
            Increasing times.
        start : Moments
            Mean and covariance of x at the first time.

        Returns
        -------
        ContinuousRun

        Raises
        ------
        ValueError
            If the filter is exact, averages are not finite or shapes do not fit.

        Notes
        -----
        In floats only. The covariances are exact; within a step the gain is that of its middle, so
        the error of the estimates is of second order in the step.
        """
        if not isinstance(self.A, np.ndarray):
            raise ValueError("A: expected arrays; a record is filtered in floats")
        n, m = len(self.A), len(self.H)
        times = read_times(times, repeated="a step takes time")
        steps = np.diff(times)
        z = read_finite_array(averages, "averages", "numbers, a row for each step")
        z = z[:, None] if z.ndim == 1 and m == 1 else z
        if z.ndim not in (2, 3) or z.shape[-2:] != (len(steps), m):
            raise ValueError(
                f"averages: expected a row for each step, of the shape "
                f"{(len(steps), m)}, got the shape {z.shape}"
            )
        return _filter_record(
            self, z, times, read_vector(start.mean, "mean", n, True), self._read(start.covariance)
        )

    def simulate(self, start: Moments, times: ArrayLike, paths: int, seed: int) -> Paths:
        """Draw states at the times and averages of z between them from their exact distribution.

        Parameters
        ----------
        start : Moments
            Mean and covariance of x at the first time.
        times : array_like, shape (N + 1,)
            Increasing times.
        paths : int
            Number S of paths.
        seed : int
            Seed of the random numbers.

        Returns
        -------
        Paths
            States, shape (S, N + 1, n), and as measurements the averages of z over the steps, shape
            (S, N, m), as `run` takes them.

        Raises
        ------
        ValueError
            If the filter is exact: paths are drawn in floats.
        """
        if not isinstance(self.A, np.ndarray):
            raise ValueError("A: expected arrays; paths are drawn in floats")
        n, m = len(self.A), len(self.H)
        times, paths = (
            read_times(times, repeated="a step takes time"),
            read_count(paths, "paths", 1),
        )
        # the integral of z as further states, with the error of the measurement for their noise
        joint = np.block([[self.A, np.zeros((n, m))], [self.H, np.zeros((m, m))]])
        noise, covariance = np.zeros((2, n + m, n + m))
        noise[:n, :n], noise[n:, n:], covariance[:n, :n] = (
            self.Q,
            self.R,
            self._read(start.covariance),
        )
        mean = np.concatenate([read_vector(start.mean, "mean", n, True), np.zeros(m)])
        drawn = simulate_continuous(joint, noise, Moments(mean, covariance), times, paths, seed)
        averages = np.diff(drawn.states[:, :, n:], axis=1) / np.diff(drawn.times)[:, None]
        return Paths(drawn.times, drawn.states[:, :, :n], averages)

    def stationary(self) -> StationaryFilter:
        """Return the stationary filter, as `stationary_filter` does.

        Returns
        -------
        StationaryFilter
        """
        return stationary_filter(self.A, self.H, self.Q, self.R)

    def __repr__(self):
        return f"ContinuousFilter of {self.A.shape[0]} states, {self.H.shape[0]} outputs"

    def _read(self, P):
        return read_covariance(P, "P", self.A.shape[0], isinstance(self.A, np.ndarray))


def riccati_closed_form(A, S, Q, P, t):
    """Return the exact P(t) from P(0), S = H^T R^-1 H; t may be a symbol."""
    n = A.rows
    M = sp.Matrix(sp.BlockMatrix([[-A.T, S], [Q, A]]))
    to_real, from_real = as_real(M, P)
    M, P = M.xreplace(to_real), P.xreplace(to_real)
    modes = Modes(lambda v: M * v, exact_spectrum(M), sp.eye(n).col_join(P))
    solution = modes.at(*continuous_basis(t))
    X, Y = solution[:n, :], solution[n:, :]
    covariance = (Y * X.adjugate() / X.det()).applyfunc(
        lambda e: sp.factor(sp.together(e)) if n == 1 else sp.together(e)
    )
    return covariance.xreplace(from_real)


class ContinuousRun(NamedTuple):
    """Result of a continuous filter for one record or several.

    Attributes
    ----------
    times : ndarray, shape (N + 1,)
        Times.
    estimates : ndarray, shape (N + 1, n)
        Estimates; of shape (S, N + 1, n) for S records.
    covariances : ndarray, shape (N + 1, n, n)
        Covariances of their errors.
    """

    times: np.ndarray
    estimates: np.ndarray
    covariances: np.ndarray

    def __repr__(self):
        return f"ContinuousRun of {len(self.times) - 1} steps, {self.estimates.shape[-1]} states"


def _filter_record(filter, z, times, x, P):
    from scipy.linalg import expm

    S, n = filter.H.T @ solve(filter.R, filter.H), len(x)
    steps = equal_steps(times)
    halves = {step: riccati_flow(filter.A, S, filter.Q, step / 2) for step in np.unique(steps)}
    x = np.broadcast_to(x, (*z.shape[:-2], n))
    estimates, covariances = [x], [P]
    for k, step in enumerate(steps):
        middle = propagate_riccati(P, *halves[step])
        gain = filter.gain(middle)
        # x~' = (A - KH) x~ + K z with a constant z, as one exponential
        m = gain.shape[1]
        exponential = expm(
            np.block([[filter.A - gain @ filter.H, gain], [np.zeros((m, n + m))]]) * step
        )
        x, P = (
            x @ exponential[:n, :n].T + z[..., k, :] @ exponential[:n, n:].T,
            propagate_riccati(middle, *halves[step]),
        )
        estimates.append(x)
        covariances.append(P)
    return ContinuousRun(times, np.stack(estimates, axis=-2), np.array(covariances))


def riccati_flow(A, S, Q, t):
    """Return (F, G, Q~) of P(t) = Q~ + F P (E + G P)^-1 F^T."""
    import scipy.linalg

    n, identity = len(A), np.eye(len(A))
    M = np.block([[-A.T, S], [Q, A]])
    doublings = max(0, int(np.ceil(np.log2(max(np.abs(M).sum(axis=1).max() * t, 1)))))
    flow = scipy.linalg.expm(M * t / 2**doublings)
    inverse = np.linalg.inv(flow[:n, :n])
    F, G, noise = inverse.T, symmetric(inverse @ flow[:n, n:]), symmetric(flow[n:, :n] @ inverse)
    for _ in range(doublings):
        factor = F @ np.linalg.inv(identity + noise @ G)
        F, G, noise = (
            factor @ F,
            symmetric(G + F.T @ np.linalg.solve(identity + G @ noise, G @ F)),
            symmetric(noise + factor @ noise @ F.T),
        )
    return F, G, noise


def propagate_riccati(P, F, G, noise):
    """Return P at the end of a step with the matrices of `riccati_flow`."""
    return symmetric(noise + F @ P @ np.linalg.solve(np.eye(len(P)) + G @ P, F.T))
