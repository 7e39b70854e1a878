"""Reading of times, standard errors and samples of a record."""

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_times


def read_record_times(t):
    """Return two or more increasing finite times."""
    return read_times(
        t, "t", least=2, repeated="replace samples at one time by their weighted mean"
    )


def read_weights(sigma, size):
    """Return rho_k = 1/sigma_k^2, zero where nothing was measured."""
    sigma = read_array(sigma, "sigma", "standard errors")
    if sigma.shape not in ((), (size,)):
        raise ValueError(
            f"sigma: expected a number or {size} standard errors, one a time, got shape "
            f"{sigma.shape}"
        )
    sigma = np.broadcast_to(sigma, (size,))
    if np.isnan(sigma).any() or (sigma <= 0).any():
        k = np.flatnonzero(np.isnan(sigma) | (sigma <= 0))[0]
        raise ValueError(
            f"sigma: standard errors must be positive, sigma[{k}] = {sigma[k]:g} (infinity: not "
            "measured)"
        )
    if np.isfinite(sigma).sum() < 2:
        raise ValueError(
            f"sigma: {np.isfinite(sigma).sum()} of {size} times are measured; a motion needs two "
            "at least"
        )
    with np.errstate(over="ignore"):
        rho = sigma**-2.0
    if not np.isfinite(rho).all():
        raise ValueError("sigma: too small to be squared; change the unit of length")
    return rho


def read_errors(sigma, h, size):
    """Return standard errors, shape (N + 1,), or that of h if they differ by column."""
    sigma = read_array(sigma, "sigma", "standard errors")
    shape = np.shape(h)
    if sigma.shape in ((), (size,)):
        read_weights(sigma, size)
        return np.broadcast_to(sigma, (size,)).copy()
    by_column = sigma[None] if sigma.shape == shape[1:] else sigma
    try:
        errors = np.broadcast_to(by_column, shape).copy()
    except ValueError:
        raise ValueError(
            f"sigma: expected a number, {size} standard errors, one a time, or an array for h of shape "
            f"{shape} (one a column, or one a sample), got shape {sigma.shape}"
        ) from None
    for column in errors.reshape(size, -1).T:
        read_weights(column, size)
    return errors


def read_samples(h, rho):
    """Return samples, finite wherever something was measured."""
    h, size = read_array(h, "h", "samples as numbers"), len(rho)
    if h.ndim == 0 or h.shape[0] != size or 0 in h.shape:
        raise ValueError(
            f"h: expected {size} samples, one a time (several records as columns), got shape "
            f"{h.shape}"
        )
    missing = ~np.isfinite(h.reshape(size, -1)) & (rho.reshape(size, -1) > 0)
    if missing.any():
        k = np.flatnonzero(missing.any(axis=1))[0]
        raise ValueError(
            f"h: sample {k} is not a finite number; where nothing was measured give sigma[{k}] = "
            "inf"
        )
    return h
