"""Least squares for z = Hx + r, with the weights R^-1 and with measurements that arrive later.

    x~ = (H^T R^-1 H)^-1 H^T R^-1 z,    P = (H^T R^-1 H)^-1

A later measurement corrects what is there, x~ + K (z - H x~) with K = P H^T (H P H^T + R)^-1, and
gives the same numbers as all measurements at once. Floats go through the singular values of the
whitened H, whose condition is the root of that of the normal equations; exact numbers through the
normal equations.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_measurement
from trajlib._arguments.matrices import any_floats
from trajlib.estimation.correction import corrected
from trajlib.estimation.covariances import Moments
from trajlib.estimation.exact_or_float import latex, solve, symmetric, tidy
from trajlib.structure import exact


@dataclass(frozen=True)
class LeastSquares:
    """An estimate by least squares.

    - `estimate`: n components; `covariance`: n x n, that of its error if R is that of the
      measurements (with R left out: in units of the common variance of the measurements);
    - `residuals`: z - H x~ of the measurements that came last;
    - `misfit`: the weighted sum of squares (z - H x~)^T R^-1 (z - H x~) at the minimum, with the
      prior's share;
    - `excess`: how many measurements there are beyond those that determine x. The misfit divided by
      it estimates the common variance if R was left out, and is near 1 if R is right.
    """

    estimate: object
    covariance: object
    residuals: object
    misfit: object
    excess: int

    @property
    def moments(self):
        """Estimate and covariance as `Moments`, a prior for others."""
        return Moments(self.estimate, self.covariance)

    def updated(self, H, z, R=None):
        """The estimate with further measurements z = Hx + r, whose errors do not correlate with the
        earlier ones.

        `H`: k x n, `z`: k numbers, `R`: k x k positive definite (left out: the unit matrix).
        Returns `LeastSquares`, the same as from all measurements at once.
        """
        return _corrected(self, H, z, R)

    def _repr_latex_(self):
        shown = sp.Matrix(self.estimate) if isinstance(self.estimate, np.ndarray) else self.estimate
        return rf"$\displaystyle \tilde x = {latex(shown)},\quad P = {latex(self.covariance)}$"


def least_squares(H, z, R=None, prior=None):
    """The unbiased linear estimate of least variance from z = Hx + r (MATLAB: lscov; H \\ z).

    `H`: m x n, `z`: m numbers, `R`: m x m, the covariance of r, positive definite; left out, the
    measurements are equally accurate and uncorrelated and R is the unit matrix. `prior`: `Moments`
    of x from before, whose errors do not correlate with r; its covariance may be singular. Exact or
    floats; symbols may stand in z and, where they do not spoil the rank, in H and R. Returns
    `LeastSquares`. Raises ValueError if the columns of H are dependent (it names a combination that
    the measurements do not show) and there is no prior, for shapes that do not fit, and if R is not
    a positive definite covariance. Source: (4.1), (4.2) and the formulas below; the book's M[rr^T]
    = R.

    >>> found = least_squares([[1, 1], [1, -1], [1, 2]], [2, 0, 4])    # problem 4.10
    >>> found.estimate.T, found.misfit
    (Matrix([[8/7, 9/7]]), 2/7)
    >>> trend = least_squares([[1, 0], [1, 1]], [2, 1]).updated([1, 2], 4)    # problem 4.11
    >>> trend.estimate.T, trend.covariance[1, 1]
    (Matrix([[4/3, 1]]), 1/2)
    """
    if prior is not None:
        known = LeastSquares(prior.mean, prior.covariance, [], 0, 0)
        return _corrected(known, H, z, R)
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
        both = solve(normal, sp.eye(H.cols).row_join(weighted.T * z))
    except np.linalg.LinAlgError:
        unseen = exact.null_columns(H)
        raise ValueError(_not_determined(unseen[:, 0].tolist())) from None
    return both[:, -1], both[:, :-1]


def _fit_floats(H, z, R):
    factor = np.linalg.cholesky(R)
    whitened = np.linalg.solve(factor, np.column_stack([H, z]))
    # Columns of norm one: what is in small units is not taken for missing.
    lengths = np.linalg.norm(whitened[:, :-1], axis=0)
    scale = np.where(lengths > 0, lengths, 1)
    U, s, Vt = np.linalg.svd(whitened[:, :-1] / scale, full_matrices=False)
    n = H.shape[1]
    if len(s) < n or s[-1] <= max(H.shape) * np.finfo(float).eps * s[0]:
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


def _corrected(known, H, z, R):
    after = corrected(Moments(known.estimate, known.covariance), z, H, R)
    floats = isinstance(after.covariance, np.ndarray)
    H, z, _ = read_measurement(H, z, R, None, floats)
    return LeastSquares(
        after.estimate,
        after.covariance,
        tidy(z - H @ after.estimate),
        known.misfit + _weighted_square(after.innovation, after.innovation_covariance),
        known.excess + H.shape[0],
    )
