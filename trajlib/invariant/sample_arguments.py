"""Reading of samples, functions of time and covariances."""

from functools import lru_cache
from numbers import Real

import numpy as np

from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_seconds
from trajlib._numerical_rank import zero_level


def derivative_of(y, r):
    """Return the derivative of order r as a function of arrays."""
    if hasattr(y, "free_symbols"):
        return _lambdified(y, r)
    if hasattr(y, "deriv"):
        return y.deriv(r) if r else y
    if hasattr(y, "antiderivative"):
        return y.derivative(r) if r else y
    if isinstance(y, Real):
        return lambda t: np.full(np.shape(t), float(y) if r == 0 else 0.0)[()]
    if not callable(y):
        raise TypeError(f"basis, nuisance: expected functions of time, got {y!r}")
    if r:
        raise TypeError(
            "basis: a Python function has no derivative; give a SymPy expression, a polynomial of "
            "numpy.polynomial or a spline"
        )
    return y


@lru_cache(maxsize=512)
def _lambdified(expression, r):
    import sympy as sp

    symbols = sorted(expression.free_symbols, key=str)
    if len(symbols) > 1:
        raise ValueError(
            f"basis, nuisance: {expression} has the symbols {', '.join(map(str, symbols))}; "
            "expected a function of the time alone, give the others numbers"
        )
    t = symbols[0] if symbols else sp.Symbol("t")
    function = sp.lambdify(t, expression.diff(t, r) if r else expression, "numpy")
    return lambda times: function(np.asarray(times, dtype=float)) + np.zeros(np.shape(times))


def sample_functions(functions, times, name):
    """Return the samples of functions of time by rows."""
    with np.errstate(all="ignore"):
        rows = [
            np.broadcast_to(np.asarray(derivative_of(y, 0)(times), dtype=float), times.shape)
            for y in functions
        ]
    for k, row in enumerate(rows):
        if not np.isfinite(row).all():
            raise ValueError(
                f"{name}: function {k} is not finite at t = {times[~np.isfinite(row)][0]:g}"
            )
    return np.array(rows).reshape(len(rows), times.size)


def read_samples(h, size):
    """Return finite samples, shape (N,) or (N, records)."""
    h = read_array(h, "h", "samples as numbers")
    if h.ndim not in (1, 2) or h.shape[0] != size:
        raise ValueError(
            f"h: expected {size} samples, one a time, or ({size}, records), got shape {h.shape}"
        )
    if not np.isfinite(h).all():
        raise ValueError(
            f"h: sample {np.argwhere(~np.isfinite(h))[0][0]} is not finite; leave out what was not "
            f"measured, with its time"
        )
    return h


def read_covariance(covariance, size):
    """Return N variances or a positive definite matrix (N, N)."""
    K = read_array(covariance, "covariance", "variances as numbers")
    if K.shape not in ((), (size,), (size, size)):
        raise ValueError(
            f"covariance: expected a variance, {size} variances or a matrix ({size}, {size}), got "
            f"shape {K.shape}"
        )
    if not np.isfinite(K).all():
        raise ValueError("covariance: expected finite numbers")
    if K.ndim < 2:
        if (K <= 0).any():
            raise ValueError(f"covariance: variances must be positive, got {K.min():g}")
        return np.broadcast_to(K, (size,))
    if np.abs(K - K.T).max() > 1e-10 * np.abs(K).max():
        raise ValueError("covariance: the matrix must be symmetric")
    lowest = np.linalg.eigvalsh(K)
    if lowest[0] <= zero_level(size) * lowest[-1]:
        raise ValueError(
            f"covariance: the matrix must be positive definite, its smallest eigenvalue is "
            f"{lowest[0]:.3g}: some combination of the samples would have no error"
        )
    return K


def read_finite(t, name):
    """Return a finite number or an array of them."""
    t = read_seconds(t, name)
    if t.ndim > 1:
        raise ValueError(f"{name}: expected a number or a list of them, got shape {t.shape}")
    return t
