"""Correction by one measurement, the step that all filters of the chapter share.

    K = P H^T (H P H^T + R)^-1,    x+ = x- + K (z - H x-),    P+ = (E - KH) P (E - KH)^T + K R K^T

The last is Joseph's form of (E - KH) P: equal for this K, and a sum of two covariances whatever the
rounding of K.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance, read_measurement
from trajlib._arguments.matrices import any_floats, read_vector
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.covariances import Moments, trusted_moments
from trajlib.estimation.exact_or_float import identity_like, latex, solve, symmetric, tidy


@dataclass(frozen=True)
class Correction:
    """Estimate after a measurement.

    Attributes
    ----------
    estimate : matrix
        Estimate x+, n components.
    covariance : matrix, shape (n, n)
        Covariance of its error.
    gain : matrix, shape (n, m)
        Gain K.
    innovation : matrix
        z - H x-, m components.
    innovation_covariance : matrix, shape (m, m)
        H P H^T + R.
    """

    estimate: Matrix
    covariance: Matrix
    gain: Matrix
    innovation: Matrix
    innovation_covariance: Matrix

    @property
    def moments(self) -> Moments:
        """Estimate and covariance as `Moments`, from which to predict or correct again."""
        return trusted_moments(self.estimate, self.covariance)

    def _repr_latex_(self):
        estimate = (
            sp.Matrix(self.estimate) if isinstance(self.estimate, np.ndarray) else self.estimate
        )
        return (
            rf"$\displaystyle \tilde x^+ = {latex(estimate)},\quad P^+ = "
            rf"{latex(self.covariance)},\quad "
            rf"K = {latex(self.gain)}$"
        )


def corrected(prior: Moments, z: MatrixLike, H: MatrixLike, R: MatrixLike) -> Correction:
    """Return the estimate corrected by z = Hx + r, the correction step of the Kalman filter.

    Parameters
    ----------
    prior : Moments
        Mean (n components) and covariance (n x n) of x before the measurement.
    z : matrix_like
        Measurement, m components.
    H : matrix_like, shape (m, n)
        Measurement matrix.
    R : matrix_like, shape (m, m)
        Covariance of r, positive semidefinite (a variance zero is an exact measurement); None for the
        unit matrix.

    Returns
    -------
    Correction
        Exact, also with symbols, or in floats.

    Raises
    ------
    ValueError
        If shapes do not fit, R is no covariance, or an exact measurement repeats what is known exactly.

    Notes
    -----
    Several measurements at one time are rows of one H, or corrections one after the other if
    their errors are uncorrelated: the result is the same. The prediction step is
    `discrete_moments(Phi, Q, correction.moments, 1)` or `continuous_moments`.
    Source: Theorem 4.1 of the problem book.

    Examples
    --------
    >>> from trajlib.estimation import Moments
    >>> correction = corrected(Moments(1, 1), 2, 1, 1)    # example 3
    >>> correction.estimate[0], correction.covariance[0], correction.gain[0]
    (3/2, 1/2, 1/2)
    """
    floats = any_floats(prior.mean, prior.covariance, z, H, R)
    n = prior.covariance.shape[0]
    H, z, R = read_measurement(H, z, R, n, floats, definite=False)
    x, P = (
        read_vector(prior.mean, "mean", n, floats),
        read_covariance(prior.covariance, "covariance", n, floats),
    )
    innovation, innovation_covariance = tidy(z - H @ x), symmetric(H @ P @ H.T + R)
    try:
        gain = solve(innovation_covariance, H @ P).T
    except np.linalg.LinAlgError:
        raise ValueError(
            "R: an exact measurement (R is singular) repeats what is known exactly already; leave it "
            "out, or give it a variance"
        ) from None
    reduction = identity_like(P) - gain @ H
    covariance = reduction @ P @ reduction.T + gain @ R @ gain.T if floats else reduction * P
    return Correction(
        tidy(x + gain @ innovation), symmetric(covariance), gain, innovation, innovation_covariance
    )
