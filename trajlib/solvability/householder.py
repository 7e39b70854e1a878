"""Weighted least squares by Householder reflections instead of normal equations.

Normal equations have the square of the condition number. With y = D x, the weighted residual r and
s the smallest singular value, a computation that is exact for a matrix wrong by A_e (norm) and a
right-hand side wrong by b_e gives, from Aplus(b + b_e) with the perturbed pseudo-inverse,

    |dy| <= (A_e |y| + b_e)/(s - A_e) + A_e |r|/(s - A_e)^2.

For r = 0 and the relative errors of `trajlib.solvability.rounding` this is (6) of the paper. The
last term is left out there: with measurement noise it can be the largest, since it grows like the
square of the condition number.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._typing import ArrayLike
from trajlib.solvability.analysis import analyse
from trajlib.solvability.result import Solvability
from trajlib.solvability.rounding import backward_errors
from trajlib.solvability.variational import Linearisation


@dataclass(frozen=True, repr=False)
class Estimate:
    """Estimate by weighted least squares, the result of `solve`.

    Attributes
    ----------
    x : ndarray, shape (m,)
        Estimate.
    residual : ndarray, shape (n,)
        Z - Htilde x.
    standard_errors : ndarray, shape (m,)
        Standard errors of x if W is the covariance of e.
    rounding : float
        Bound on the norm of D dx from rounding.
    solvability : Solvability
        Analysis of the system.
    """

    x: np.ndarray
    residual: np.ndarray
    standard_errors: np.ndarray
    rounding: float
    solvability: Solvability

    def __repr__(self):
        solvability = self.solvability
        return "\n".join(
            f"{name} = {value:.6g} ± {error:.2g} {unit}".rstrip()
            for name, value, error, unit in zip(
                solvability.names, self.x, self.standard_errors, solvability.units
            )
        )


def solve(
    matrix: ArrayLike | Linearisation,
    Z: ArrayLike,
    W: ArrayLike | None = None,
    *,
    matrix_error: ArrayLike | None = None,
    names: Sequence | None = None,
    units: Sequence | None = None,
) -> Estimate:
    """Return the weighted least-squares solution of Z = Htilde x + e.

    Parameters
    ----------
    matrix : array_like or Linearisation, shape (n, m)
        Htilde, as for `analyse`.
    Z : array_like, shape (n,)
        Measurements less their predicted values.
    W : array_like, optional
        Covariance of e, as for `analyse`.
    matrix_error : array_like, optional
        Bounds on the errors of the matrix, as for `analyse`.
    names, units : sequence of str, optional
        Names and units of the unknowns.

    Returns
    -------
    Estimate

    Raises
    ------
    ValueError
        If the system is not shown to be solvable (the message is the verdict), or arguments do not
        fit.

    Notes
    -----
    Computed by orthogonal reflections. MATLAB: ``lscov``, ``qr``.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(4.0)
    >>> estimate = solve(np.stack([np.ones(4), t], axis=1), 3 - 2*t, W=[1, 4, 4, 1], names=["a", "b"])
    >>> estimate.x.round(12).tolist(), estimate.rounding < 1e-11
    ([3.0, -2.0], True)
    """
    from scipy.linalg import qr_multiply, solve_triangular

    solvability = analyse(matrix, W, matrix_error=matrix_error, names=names, units=units)
    Z = read_array(Z, "Z", "measurements as numbers")
    if Z.shape != (solvability.n,):
        raise ValueError(
            f"Z: expected {solvability.n} measurements, one for each row of the matrix, got shape "
            f"{Z.shape}"
        )
    if not np.isfinite(Z).all():
        raise ValueError(
            f"Z: measurement {np.flatnonzero(~np.isfinite(Z))[0]} is not finite; leave its row out"
        )
    if not solvability.solvable:
        raise ValueError(solvability.verdict)
    weighted = solvability._weights.apply(Z)
    rotated, R = qr_multiply(solvability._scaled_matrix, weighted, mode="right")
    y = solve_triangular(R, rotated)
    residual = weighted - solvability._scaled_matrix @ y
    of_matrix, of_right_side = backward_errors(solvability.m, solvability.n, solvability.eps)
    greatest, least = solvability.singular_values[[0, -1]]
    wrong, margin = of_matrix * greatest, least - of_matrix * greatest
    rounding = np.inf
    if margin > 0:
        rounding = float(
            (wrong * np.linalg.norm(y) + of_right_side * np.linalg.norm(weighted)) / margin
            + wrong * np.linalg.norm(residual) / margin**2
        )
    x = y / solvability.scaling
    htilde = matrix.matrix if hasattr(matrix, "Phi") else read_array(matrix, "matrix", "a matrix")
    return Estimate(x, Z - htilde @ x, solvability.standard_deviations, rounding, solvability)
