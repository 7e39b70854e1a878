"""Weights of the measurements: multiplication by L^{-1}, where W = L L^T.

It differs from W^{-1/2} by a rotation only.
"""

import numpy as np


class Weights:
    """Covariance W as n variances, a full matrix, k blocks (k, r, r) of its diagonal, or None.

    None means unit variances.
    """

    def __init__(self, W, n) -> None:
        self.n = n
        self.factor = None
        if W is None:
            return
        W = np.asarray(W, dtype=float)
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
        if W.ndim == 2:
            W = W[None]
        if W.ndim != 3 or W.shape[1] != W.shape[2]:
            raise ValueError(
                f"W: expected {n} variances, a matrix ({n}, {n}) or square blocks (k, r, r), got "
                f"shape {W.shape}"
            )
        self._check_size(W.shape[0] * W.shape[1], W.shape)
        if np.abs(W - W.transpose(0, 2, 1)).max() > 1e-10 * np.abs(W).max():
            raise ValueError("W: a covariance matrix is symmetric, this one is not")
        spectra = np.linalg.eigvalsh(W)
        if (spectra[:, 0] <= 1e-15 * W.shape[1] * np.abs(spectra).max(axis=1)).any():
            k = int(np.argmin(spectra[:, 0]))
            where = f"block {k} of W" if W.shape[0] > 1 else "W"
            if not W[k].any():
                raise ValueError(
                    f"{where} is zero: without errors of the measurements there is nothing to "
                    "weigh; leave W out"
                )
            raise ValueError(
                f"{where} is not positive definite: its smallest eigenvalue is {spectra[k, 0]:.3g}. "
                "Some combination of the measurements would have no error or a negative variance"
            )
        self.factor = np.linalg.cholesky(W)

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
        k, r, _ = self.factor.shape
        return (np.abs(np.linalg.inv(self.factor)) @ rows.reshape(k, r, -1)).reshape(rows.shape)

    def _solve(self, rows, transposed):
        if self.factor is None:
            return rows
        if self.factor.ndim == 1:
            return rows / (self.factor if rows.ndim == 1 else self.factor[:, None])
        k, r, _ = self.factor.shape
        factor = self.factor.transpose(0, 2, 1) if transposed else self.factor
        return np.linalg.solve(factor, rows.reshape(k, r, -1)).reshape(rows.shape)
