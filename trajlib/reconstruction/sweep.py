"""The matrix sweep (progonka): the best motion for a given weight M of the acceleration.

The sweep writes the costate before sample k as an affine function of the state, in the paper
(psi_2, psi_1)^T = Q_k (x, y)^T + q_k. The pair is minus the gradient of the cost to go, so that
with a symmetric P_k >= 0 and a vector c_k

    (psi_1, psi_2)^T = c_k - P_k (x, y)^T,      Q_k = -[[p12, p22], [p11, p12]].

Over an interval tau, with Phi = [[1, tau], [0, 1]] and S = 1/M [[tau^3/3, tau^2/2], [tau^2/2,
tau]],

    E_k = (I + S P_{k+1})^{-1} Phi,                     T_k = (I + S P_{k+1})^{-1} S,
    P_k = Phi^T P_{k+1} E_k + diag(rho_k, 0),           P_N = diag(rho_N, 0),
    c_k = E_k^T c_{k+1} + (rho_k h_k, 0)^T              backwards,
    xi_{k+1} = E_k xi_k + T_k c_{k+1}, P_0 xi_0 = c_0   forwards.

These are the paper's (4.3), (4.6)-(4.8). P_k, E_k, T_k do not depend on the samples h. Written out
and with det P carried along, the recursion for P_k adds, multiplies and divides positive numbers
only: nothing cancels, however small M is.
"""

import numpy as np

from trajlib._typing import ArrayLike
from trajlib.reconstruction.record_arguments import read_record_times, read_samples, read_weights
from trajlib.reconstruction.splines import straight_line


class SweepGains:
    """Gains of the matrix sweep, computed before the samples are known.

    Parameters
    ----------
    t : array_like, shape (N + 1,)
        Increasing times.
    sigma : array_like
        Standard error of the samples, in their unit, or N + 1 standard errors; infinity where
        nothing was measured.
    M : float
        Weight of the acceleration, positive, in units of time^3/sigma^2.

    Attributes
    ----------
    Q : ndarray, shape (N + 1, 2, 2)
        Matrices Q_k of the paper.
    closed_loop : ndarray, shape (N, 2, 2)
        Matrices E_k.

    Raises
    ------
    ValueError
        If the times do not increase or M or a standard error is not positive.

    Notes
    -----
    Source: (4.6), (4.7) of the paper.

    Examples
    --------
    >>> gains = SweepGains([0, 1, 2, 3], sigma=1.0, M=0.5)
    >>> x, y, u = gains.apply([0.0, 2.0, 4.0, 6.0])       # samples on a line: the line itself
    >>> x.round(12).tolist(), y.round(12).tolist(), float(abs(u).max().round(12))
    ([0.0, 2.0, 4.0, 6.0], [2.0, 2.0, 2.0, 2.0], 0.0)
    """

    def __init__(self, t: ArrayLike, sigma: ArrayLike, M: float) -> None:
        self.t = read_record_times(t)
        self.rho = read_weights(sigma, self.t.size)
        is_scalar: bool = np.isscalar(M)
        if not (is_scalar and np.isfinite(M) and M > 0):
            raise ValueError(
                f"M: expected a positive finite number, got {M}; max |u| grows as M falls, a "
                "straight line is M = inf"
            )
        self.M = float(M)
        self._tau = np.diff(self.t)
        self._p11, self._p12, self._p22, self._det_p, det = _riccati(self._tau, self.rho, self.M)
        tau, p11, p12, p22 = self._tau, self._p11[1:], self._p12[1:], self._p22[1:]
        s22 = tau / self.M
        s12 = s22 * tau / 2
        s11 = s12 * tau * 2 / 3
        det_s = s22 * s11 / 4
        self.closed_loop = np.moveaxis(
            np.array(
                [
                    [1 + s12 * p12 + s22 * p22, tau + p12 * s11 / 2 + p22 * s12],
                    [-(s12 * p11 + s22 * p12), 1 - p11 * s11 / 2 - p12 * s12],
                ]
            )
            / det,
            -1,
            0,
        )
        self._t11, self._t12, self._t22 = (
            (s11 + det_s * p22) / det,
            (s12 - det_s * p12) / det,
            (s22 + det_s * p11) / det,
        )
        # The unit upper triangular matrix of the backward recursion; the forward one is its
        # transpose.
        self._band = np.zeros((4, 2 * self.t.size), order="F")
        self._band[3] = 1
        self._band[1, 2::2], self._band[0, 3::2] = (
            -self.closed_loop[:, 0, 0],
            -self.closed_loop[:, 1, 0],
        )
        self._band[2, 2::2], self._band[1, 3::2] = (
            -self.closed_loop[:, 0, 1],
            -self.closed_loop[:, 1, 1],
        )

    @property
    def Q(self) -> np.ndarray:
        """Matrices Q_k of the paper, (psi_2, psi_1)^T = Q_k (x, y)^T + q_k before sample k."""
        return -np.moveaxis(np.array([[self._p12, self._p22], [self._p11, self._p12]]), -1, 0)

    def apply(self, h: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return position, velocity and acceleration at the samples.

        Parameters
        ----------
        h : array_like, shape (N + 1, ...)
            Samples, a column for each coordinate or record.

        Returns
        -------
        (ndarray, ndarray, ndarray)
            x, y and u, each of the shape of `h`.
        """
        records = read_samples(h, self.rho)
        shape = records.shape
        records = records.reshape(shape[0], -1)
        # The motion of h + a + b t is that of h plus a + b t: the remainder after a straight line
        # has smaller rounding errors.
        line, slope = straight_line(self.t, self.rho, records)
        remainder = np.where(self.rho[:, None] > 0, records - line, 0)

        c = np.zeros((2 * shape[0], remainder.shape[1]))
        c[::2] = self.rho[:, None] * remainder
        c = _substitute(self._band, c, transpose=False)
        forced = np.zeros_like(c)
        det = self._det_p[0]
        forced[0] = (self._p22[0] * c[0] - self._p12[0] * c[1]) / det
        forced[1] = (self._p11[0] * c[1] - self._p12[0] * c[0]) / det
        forced[2::2] = self._t11[:, None] * c[2::2] + self._t12[:, None] * c[3::2]
        forced[3::2] = self._t12[:, None] * c[2::2] + self._t22[:, None] * c[3::2]
        state = _substitute(self._band, forced, transpose=True)
        x, y = state[::2], state[1::2]
        u = self._accelerations(x, y, c[1::2])
        return (x + line).reshape(shape), (y + slope).reshape(shape), u.reshape(shape)

    def _accelerations(self, x, y, c2):
        """Return u, zero at both ends.

        It is psi_2/M, or where that cancels (small M) comes from the cubic through neighbouring
        states.
        """
        tau = self._tau[:, None]
        u = (c2 - self._p12[:, None] * x - self._p22[:, None] * y) / self.M
        from_states = (6 * np.diff(x, axis=0) / tau - 4 * y[:-1] - 2 * y[1:]) / tau
        cancels = self._p12[1:-1] / self.M > 6 / self._tau[1:] ** 2
        u[1:-1][cancels] = from_states[1:][cancels]
        u[[0, -1]] = 0
        return u


def sweep_eigenvalues(kappa: float) -> np.ndarray:
    """Return the four eigenvalues of the transition matrix A_k, by increasing modulus.

    Parameters
    ----------
    kappa : float
        Dimensionless number rho tau^3/M, positive.

    Returns
    -------
    ndarray, shape (4,)
        Complex.

    Raises
    ------
    ValueError
        If kappa is not positive and finite.

    Notes
    -----
    They are the roots of (3.9), a reciprocal polynomial: with w = lambda + 1/lambda it is w^2 +
    (kappa/6 - 4) w + 2 kappa/3 + 4 = 0.

    Examples
    --------
    >>> sweep_eigenvalues(144).real.round(3).tolist()        # the only kappa > 0 with multiple roots
    [-0.101, -0.101, -9.899, -9.899]
    """
    if not (np.isfinite(kappa) and kappa > 0):
        raise ValueError(f"kappa: expected a positive finite number, got {kappa}")
    half = 2 - kappa / 12
    root = np.sqrt(complex(kappa * (kappa / 144 - 1)))
    large = []
    for w in (half + root, half - root):
        s = np.sqrt(w * w - 4)
        large.append(max(((w + s) / 2, (w - s) / 2), key=abs))
    large.sort(key=abs)
    return np.array([1 / large[1], 1 / large[0], *large])


def _riccati(tau, rho, M):
    """Return p11, p12, p22 and det of P_k for all k, and det(I + S P_{k+1}).

    A plain loop over floats, without subtractions.
    """
    a, b, c, d = float(rho[-1]), 0.0, 0.0, 0.0
    rows, steps = [(a, b, c, d)], []
    for step, weight in zip(tau[::-1].tolist(), rho[-2::-1].tolist()):
        s22 = step / M
        s12 = 0.5 * step * s22
        s11 = step * s12 / 1.5
        det = 1 + s11 * a + 2 * s12 * b + s22 * c + 0.25 * s11 * s22 * d
        step_a = step * a
        c = (step * step_a + 2 * step * b + c + s11 * d) / det
        b = (step_a + b + s12 * d) / det
        a = (a + s22 * d) / det + weight
        d = d / det + weight * c
        rows.append((a, b, c, d))
        steps.append(det)
    return *np.array(rows[::-1]).T.copy(), np.array(steps[::-1])


def _substitute(band, right, transpose):
    from scipy.linalg.lapack import dtbtrs

    solution, info = dtbtrs(band, right, uplo="U", trans="T" if transpose else "N", diag="U")
    if info:
        raise ArithmeticError(f"the banded substitution failed ({info})")
    return solution
