"""The estimate by orthogonal reflections (Householder), never by normal equations, whose condition
number is the square.

With y = D x, the weighted residual r and s the smallest singular value, a computation that is exact
for a matrix wrong by A_e (norm) and a right-hand side wrong by b_e gives, from Aplus(b + b_e) with
the perturbed pseudo-inverse,

    |dy| <= (A_e |y| + b_e)/(s - A_e) + A_e |r|/(s - A_e)^2.

For r = 0 and the relative errors of `trajlib.solvability.rounding` this is (6) of the paper. The
last term is left out there: with measurement noise it can be the greatest, since it grows like the
square of the condition number.
"""

from dataclasses import dataclass

import numpy as np

from trajlib.solvability.rounding import backward_errors
from trajlib.solvability.verdicts import Solvability, analyse


@dataclass(frozen=True, repr=False)
class Estimate:
    """What `solve` returns: the estimate `x`, the residual Z - Htilde x, `standard_errors` of x if
    W is the covariance of e, `rounding`, a bound on the norm of D dx from rounding, and the
    `solvability`."""

    x: np.ndarray
    residual: np.ndarray
    standard_errors: np.ndarray
    rounding: float
    solvability: Solvability

    def __repr__(self):
        finding = self.solvability
        return "\n".join(
            f"{name} = {value:.6g} ± {error:.2g} {unit}".rstrip()
            for name, value, error, unit in zip(
                finding.names, self.x, self.standard_errors, finding.units
            )
        )


def solve(matrix, Z, W=None, *, matrix_error=None, names=None, units=None):
    """Weighted least squares for Z = Htilde x + e by orthogonal reflections (MATLAB: lscov, qr).

    `Z`: n measurements less their predicted values; the other arguments are those of `analyse`.
    Raises ValueError with the verdict if the system is not shown to be solvable.

    >>> import numpy as np
    >>> t = np.arange(4.0)
    >>> found = solve(np.stack([np.ones(4), t], axis=1), 3 - 2*t, W=[1, 4, 4, 1], names=["a", "b"])
    >>> found.x.round(12).tolist(), found.rounding < 1e-11
    ([3.0, -2.0], True)
    """
    from scipy.linalg import qr_multiply, solve_triangular

    finding = analyse(matrix, W, matrix_error=matrix_error, names=names, units=units)
    Z = np.asarray(Z, dtype=float)
    if Z.shape != (finding.n,):
        raise ValueError(
            f"Z: expected {finding.n} measurements, one for each row of the matrix, got shape "
            f"{Z.shape}"
        )
    if not np.isfinite(Z).all():
        raise ValueError(
            f"Z: measurement {np.flatnonzero(~np.isfinite(Z))[0]} is not finite; leave its row out"
        )
    if not finding.solvable:
        raise ValueError(finding.verdict)
    weighted = finding._weights.apply(Z)
    rotated, R = qr_multiply(finding._judged, weighted, mode="right")
    y = solve_triangular(R, rotated)
    residual = weighted - finding._judged @ y
    of_matrix, of_right_side = backward_errors(finding.m, finding.n, finding.eps)
    greatest, least = finding.singular_values[[0, -1]]
    wrong, gap = of_matrix * greatest, least - of_matrix * greatest
    rounding = np.inf
    if gap > 0:
        rounding = float(
            (wrong * np.linalg.norm(y) + of_right_side * np.linalg.norm(weighted)) / gap
            + wrong * np.linalg.norm(residual) / gap**2
        )
    x = y / finding.scaling
    given = matrix.matrix if hasattr(matrix, "Phi") else np.asarray(matrix, dtype=float)
    return Estimate(x, Z - given @ x, finding.standard_deviations, rounding, finding)
