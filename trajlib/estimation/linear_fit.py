"""Linear least squares for z = Hx + r with the weights R^-1, also recursively.

    x~ = (H^T R^-1 H)^-1 H^T R^-1 z,    P = (H^T R^-1 H)^-1

A later measurement corrects the estimate, x~ + K (z - H x~) with K = P H^T (H P H^T + R)^-1, and
gives the same numbers as all measurements at once. Floats use the singular values of the whitened
H, whose condition number is the root of that of the normal equations; exact numbers use the normal
equations.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_measurement
from trajlib._arguments.matrices import any_floats
from trajlib._numerical_rank import zero_level
from trajlib._typing import Matrix, MatrixLike, Scalar
from trajlib.estimation.correction import corrected
from trajlib.estimation.covariances import Moments
from trajlib.estimation.exact_or_float import latex, solve, symmetric, tidy
from trajlib.structure import exact


@dataclass(frozen=True)
class LeastSquares:
    """Estimate by least squares.

    Attributes
    ----------
    estimate : matrix
        Estimate x~, n components.
    covariance : matrix, shape (n, n)
        Covariance of its error if R is that of the measurements; with R left out, in units of the
        common variance of the measurements.
    residuals : matrix
        z - H x~ of the latest measurements.
    misfit : scalar
        Weighted sum of squares (z - H x~)^T R^-1 (z - H x~) at the minimum, with the prior's part.
    degrees_of_freedom : int
        Number of measurements less the number of unknowns. The misfit divided by it estimates the
        common variance if R was left out, and is near 1 if R is right.
    """

    estimate: Matrix
    covariance: Matrix
    residuals: Matrix
    misfit: Scalar
    degrees_of_freedom: int

    @property
    def moments(self) -> Moments:
        """Estimate and covariance as `Moments`, a prior for other functions."""
        return Moments(self.estimate, self.covariance)

    def updated(self, H: MatrixLike, z: MatrixLike, R: MatrixLike = None) -> LeastSquares:
        """Return the estimate with further measurements z = Hx + r.

        Parameters
        ----------
        H : matrix_like, shape (k, n)
            Measurement matrix.
        z : matrix_like
            k measurements.
        R : matrix_like, shape (k, k), optional
            Covariance of r, positive definite; left out, the unit matrix.

        Returns
        -------
        LeastSquares
            The same as from all measurements at once.

        Notes
        -----
        Errors of the further measurements must be uncorrelated with the earlier ones.
        """
        return _corrected(self, H, z, R)

    def _repr_latex_(self):
        estimate = (
            sp.Matrix(self.estimate) if isinstance(self.estimate, np.ndarray) else self.estimate
        )
        return rf"$\displaystyle \tilde x = {latex(estimate)},\quad P = {latex(self.covariance)}$"


def least_squares(
    H: MatrixLike, z: MatrixLike, R: MatrixLike = None, prior: Moments | None = None
) -> LeastSquares:
    r"""Return the unbiased linear estimate of least variance from z = Hx + r.

    Parameters
    ----------
    H : matrix_like, shape (m, n)
        Measurement matrix; exact or floats. Symbols are allowed where the rank does not depend on
        them.
    z : matrix_like
        m measurements, also with symbols.
    R : matrix_like, shape (m, m), optional
        Covariance of r, positive definite; left out, the measurements are equally accurate and
        uncorrelated, and R is the unit matrix.
    prior : Moments, optional
        Earlier knowledge of x, with errors that are uncorrelated with r; its covariance may be
        singular.

    Returns
    -------
    LeastSquares

    Raises
    ------
    ValueError
        If the columns of H are dependent (the message has a combination that the measurements do
        not determine) and there is no prior, if shapes do not fit, or if R is no positive definite
        covariance.

    Notes
    -----
    MATLAB: ``lscov``, ``H \ z``. Source: (4.1), (4.2) and the formulas below; the book's E[rr^T] =
    R.

    Examples
    --------
    >>> fit = least_squares([[1, 1], [1, -1], [1, 2]], [2, 0, 4])    # problem 4.10
    >>> fit.estimate.T, fit.misfit
    (Matrix([[8/7, 9/7]]), 2/7)
    >>> trend = least_squares([[1, 0], [1, 1]], [2, 1]).updated([1, 2], 4)    # problem 4.11
    >>> trend.estimate.T, trend.covariance[1, 1]
    (Matrix([[4/3, 1]]), 1/2)
    """
    if prior is not None:
        earlier = LeastSquares(prior.mean, prior.covariance, [], 0, 0)
        return _corrected(earlier, H, z, R)
    floats = any_floats(H, z, R)
    H, z, R = read_measurement(H, z, R, None, floats)
    if floats:
        estimate, covariance = _fit_floats(H, z, R)
    else:
        estimate, covariance = _fit_exact(H, z, R)
    residuals = tidy(z - H @ estimate)
    return LeastSquares(
        estimate, covariance, residuals, _weighted_square(residuals, R), H.shape[0] - H.shape[1]
    )


def _fit_exact(H, z, R):
    weighted = H if R == sp.eye(R.rows) else solve(R, H)
    normal = (H.T * weighted).applyfunc(sp.expand)
    try:
        solution = solve(normal, sp.eye(H.cols).row_join(weighted.T * z))
    except np.linalg.LinAlgError:
        null_space = exact.null_columns(H)
        raise ValueError(_not_determined(null_space[:, 0].tolist())) from None
    return solution[:, -1], solution[:, :-1]


def _fit_floats(H, z, R):
    factor = np.linalg.cholesky(R)
    whitened = np.linalg.solve(factor, np.column_stack([H, z]))
    # Columns of norm one, so that small units do not look like a rank deficit.
    lengths = np.linalg.norm(whitened[:, :-1], axis=0)
    scale = np.where(lengths > 0, lengths, 1)
    U, s, Vt = np.linalg.svd(whitened[:, :-1] / scale, full_matrices=False)
    n = H.shape[1]
    if len(s) < n or s[-1] <= zero_level(*H.shape) * s[0]:
        direction = np.linalg.svd(whitened[:, :-1] / scale)[2][-1] / scale
        raise ValueError(_not_determined(np.round(direction / np.abs(direction).max(), 6).tolist()))
    back = Vt.T / s / scale[:, None]
    return back @ (U.T @ whitened[:, -1]), symmetric(back @ back.T)


def _not_determined(direction):
    return (
        "H: its columns are dependent, so the measurements do not determine x: adding any "
        f"multiple of {[entry[0] if isinstance(entry, list) else entry for entry in direction]} to "
        "it changes none of them"
    )


def _weighted_square(residuals, R):
    if isinstance(R, np.ndarray):
        return float(residuals @ np.linalg.solve(R, residuals))
    return tidy(residuals.T * solve(R, residuals))[0, 0]


def _corrected(earlier, H, z, R):
    after = corrected(Moments(earlier.estimate, earlier.covariance), z, H, R)
    floats = isinstance(after.covariance, np.ndarray)
    H, z, _ = read_measurement(H, z, R, None, floats)
    return LeastSquares(
        after.estimate,
        after.covariance,
        tidy(z - H @ after.estimate),
        earlier.misfit + _weighted_square(after.innovation, after.innovation_covariance),
        earlier.degrees_of_freedom + H.shape[0],
    )
