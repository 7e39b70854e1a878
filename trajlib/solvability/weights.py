"""Weights of the measurements: multiplication by L^{-1}, where W = L L^T.

It differs from W^{-1/2} by a rotation only.
"""

import contextlib

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._numerical_rank import zero_level


class Weights:
    """Covariance W as n variances, a full matrix, k blocks (k, r, r) of its diagonal, or None.

    None means unit variances.
    """

    def __init__(self, W, n) -> None:
        self.n = n
        self.factor = None
        if W is None:
            return
        W = read_array(W, "W", "variances as numbers")
        if not np.isfinite(W).all():
            raise ValueError("W: its entries must be finite; leave out what was not measured")
        if W.ndim == 1:
            self._check_size(W.size, W.shape)
            if (W <= 0).any():
                k = int(np.flatnonzero(W <= 0)[0])
                raise ValueError(
                    f"W: the variance of measurement {k} is {W[k]:g}; it must be positive (a "
                    "measurement without error has no weight)"
                )
            self.factor = np.sqrt(W)
            return
        if W.ndim not in (2, 3) or W.shape[-2] != W.shape[-1]:
            raise ValueError(
                f"W: expected {n} variances, a matrix ({n}, {n}) or square blocks (k, r, r), got "
                f"shape {W.shape}"
            )
        self._check_size(W.size // W.shape[-1], W.shape)
        if np.abs(W - W.swapaxes(-1, -2)).max() > 1e-10 * np.abs(W).max():
            raise ValueError("W: a covariance matrix is symmetric, this one is not")
        self.factor = _cholesky(W)

    def _check_size(self, size, shape):
        if size != self.n:
            raise ValueError(
                f"W: of shape {shape} it is for {size} scalar measurements, but there are {self.n}"
            )

    def apply(self, rows):
        """Return L^{-1} times a vector or matrix with n rows."""
        return self._solve(rows, transposed=False)

    def apply_transposed(self, rows):
        """Return L^{-T} times a vector or matrix with n rows."""
        return self._solve(rows, transposed=True)

    def apply_absolute(self, rows):
        """Return |L^{-1}| times bounds with n rows."""
        if self.factor is None or self.factor.ndim == 1:
            return self.apply(rows)
        if not rows.any():
            return rows
        inverse = _solved(
            self.factor, np.broadcast_to(np.eye(self.factor.shape[-1]), self.factor.shape)
        )
        r = self.factor.shape[-1]
        return (np.abs(inverse) @ rows.reshape(*self.factor.shape[:-2], r, -1)).reshape(rows.shape)

    def _solve(self, rows, transposed):
        if self.factor is None:
            return rows
        if self.factor.ndim == 1:
            return rows / (self.factor if rows.ndim == 1 else self.factor[:, None])
        r = self.factor.shape[-1]
        columns = rows.reshape(*self.factor.shape[:-2], r, -1)
        return _solved(self.factor, columns, transposed).reshape(rows.shape)


def _solved(factor, columns, transposed=False):
    """Return L^{-1} or L^{-T} times columns, for one triangular matrix or an array of blocks."""
    if factor.ndim == 2:
        from scipy.linalg import solve_triangular

        return solve_triangular(factor, columns, lower=True, trans="T" if transposed else "N")
    return np.linalg.solve(factor.swapaxes(-1, -2) if transposed else factor, columns)


def _cholesky(W):
    """Return the triangular factor of a matrix or of blocks that are positive definite.

    Eigenvalues are computed only for the message. That a definite matrix is not singular within
    rounding is seen from the pivots: of the share 1 - R_k^2 of a variance that the earlier ones
    leave free.
    """
    variances = np.diagonal(W, axis1=-2, axis2=-1)
    with contextlib.suppress(np.linalg.LinAlgError):
        factor = np.linalg.cholesky(W)
        free = np.diagonal(factor, axis1=-2, axis2=-1) ** 2 / variances
        if free.min() > zero_level(W.shape[-1]):
            return factor
    blocks = W.reshape(-1, *W.shape[-2:])
    least = np.linalg.eigvalsh(blocks)[:, 0]
    k = int(np.argmin(least))
    where = f"block {k} of W" if len(blocks) > 1 else "W"
    if not blocks[k].any():
        raise ValueError(
            f"{where} is zero: without errors of the measurements there is nothing to weigh; leave W "
            "out"
        )
    raise ValueError(
        f"{where} is not positive definite: its smallest eigenvalue is {least[k]:.3g}. Some "
        "combination of the measurements would have no error or a negative variance"
    )
