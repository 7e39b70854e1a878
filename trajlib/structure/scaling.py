r"""Balanced units: diagonal scalings of states, outputs and time.

x = D y, z = R^-1 w and t = s / alpha turn (A, H) into (D^-1 A D / alpha, R H D). None of this
changes the unobservable states, so that a verdict must not depend on it. The exponents are those that
bring all entries other than zero as near to 1 as possible,

    sum over a_ij of (log|a_ij| + d_j - d_i - tau)^2  +  sum over h_kj of (log|h_kj| + d_j - rho_k)^2  ->  min,

a linear problem of least squares (A. R. Curtis and J. K. Reid, On the automatic scaling of matrices
for Gaussian elimination, 1972). Other units shift the logarithms by what the unknowns can take up,
so that the scaled system is the same but for the rounding of the exponents to whole powers of two,
which costs no digit.
"""

from dataclasses import dataclass

import numpy as np

_ROUNDING = 4 * np.finfo(float).eps


@dataclass(frozen=True)
class Scaled:
    """The pair in balanced units, x = `units` y.

    Attributes
    ----------
    A : numpy.ndarray, shape (n, n)
        Has the norm 1.
    H : numpy.ndarray, shape (m, n)
        Its nonzero rows have the length 1.
    units : numpy.ndarray, shape (n,)
        The units of the states.
    rate : float
        The factor of the eigenvalues of `A` in the units given.
    cleared : bool
        Whether entries were taken as zero, being rounding beside the others of their row and
        column.
    """

    A: np.ndarray
    H: np.ndarray
    units: np.ndarray
    rate: float
    cleared: bool


def balanced(A, H):
    """Return the pair of float matrices, n x n and m x n, in balanced units."""
    stacked, n = np.vstack([A, H]), len(A)
    sizes = np.abs(stacked)
    neighbours = np.minimum(sizes.max(axis=1, keepdims=True), sizes.max(axis=0, keepdims=True))
    doubtful = (stacked != 0) & (sizes <= _ROUNDING * neighbours)
    rows, columns, time = _exponents(sizes, (stacked != 0) & ~doubtful)
    stacked = np.ldexp(stacked, columns - rows[:, None])
    # What is still tiny in the units that all the others ask for was not made tiny by its units.
    rounding = doubtful & (np.abs(stacked) <= _ROUNDING * np.abs(stacked).max())
    stacked[rounding] = 0
    A, H = stacked[:n], stacked[n:]
    size, lengths = np.linalg.norm(A, 2), np.linalg.norm(H, axis=1, keepdims=True)
    units = np.ldexp(1.0, np.clip(columns - columns.max(), -1000, 0))
    return Scaled(
        A / (size or 1),
        H / np.where(lengths == 0, 1, lengths),
        units,
        float(np.ldexp(size or 1, time)),
        bool(rounding.any()),
    )


def _exponents(sizes, used):
    """Return exponents of two: d_i + tau and rho_k for the rows, d_j for the columns, and tau."""
    m, n = sizes.shape
    i, j = np.nonzero(used)
    # The unknowns are d_1, ..., d_n, rho_1, ..., rho_(m-n), tau.
    equations, k = np.zeros((len(i), m + 1)), np.arange(len(i))
    equations[k, j] += 1
    equations[k, i] -= 1
    equations[k[i < n], m] = -1
    exponents = np.linalg.lstsq(
        equations.T @ equations, -equations.T @ np.log2(sizes[i, j]), rcond=1e-10
    )[0]
    # All states and outputs may shift together; the first state is taken as unit, so that other
    # units round alike.
    exponents[:m] = exponents[:m] - exponents[0]
    exponents = np.rint(exponents).astype(int)
    return exponents[:m] + exponents[m] * (np.arange(m) < n), exponents[:n], int(exponents[m])
