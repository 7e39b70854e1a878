"""One correction by a measurement: the step that all filters of the chapter share.

    K = P H^T (H P H^T + R)^-1,    x+ = x- + K (z - H x-),    P+ = (E - KH) P (E - KH)^T + K R K^T

The last is Joseph's form of (E - KH) P: equal for this K, and a sum of two covariances whatever the
rounding of K.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance, read_measurement
from trajlib._arguments.matrices import any_floats, read_vector
from trajlib.estimation.covariances import trusted_moments
from trajlib.estimation.exact_or_float import identity_like, latex, solve, symmetric, tidy


@dataclass(frozen=True)
class Correction:
    """An estimate after a measurement.

    `estimate`: n components, `covariance`: n x n, that of its error; `gain`: K, n x m;
    `innovation`: z - H x-, m components, with the covariance `innovation_covariance` = H P H^T + R,
    m x m.
    """

    estimate: object
    covariance: object
    gain: object
    innovation: object
    innovation_covariance: object

    @property
    def moments(self):
        """Estimate and covariance as `Moments`, from which to predict or correct again."""
        return trusted_moments(self.estimate, self.covariance)

    def _repr_latex_(self):
        shown = sp.Matrix(self.estimate) if isinstance(self.estimate, np.ndarray) else self.estimate
        return (
            rf"$\displaystyle \tilde x^+ = {latex(shown)},\quad P^+ = "
            rf"{latex(self.covariance)},\quad "
            rf"K = {latex(self.gain)}$"
        )


def corrected(prior, z, H, R):
    """The estimate corrected by z = Hx + r (correction step of the Kalman filter, Theorem 4.1).

    `prior`: `Moments` of x before, mean n and covariance n x n; `z`: m numbers; `H`: m x n; `R`: m
    x m, the covariance of r, positive definite (None: the unit matrix). Exact, also with symbols,
    or floats. Several measurements at one time are rows of one H, or corrections one after the
    other if their errors do not correlate: the result is the same. The prediction step is
    `discrete_moments(Phi, Q, correction.moments, 1)` or `continuous_moments`. Returns `Correction`.
    Raises ValueError for shapes that do not fit and an R that is not positive definite.

    >>> from trajlib.estimation import Moments
    >>> found = corrected(Moments(1, 1), 2, 1, 1)    # example 3
    >>> found.estimate[0], found.covariance[0], found.gain[0]
    (3/2, 1/2, 1/2)
    """
    floats = any_floats(prior.mean, prior.covariance, z, H, R)
    n = prior.covariance.shape[0]
    H, z, R = read_measurement(H, z, R, n, floats)
    x, P = (
        read_vector(prior.mean, "mean", n, floats),
        read_covariance(prior.covariance, "covariance", n, floats),
    )
    innovation, spread = tidy(z - H @ x), symmetric(H @ P @ H.T + R)
    gain = solve(spread, H @ P).T
    kept = identity_like(P) - gain @ H
    covariance = kept @ P @ kept.T + gain @ R @ gain.T if floats else kept * P
    return Correction(tidy(x + gain @ innovation), symmetric(covariance), gain, innovation, spread)
