"""The weight M for which the greatest acceleration of the motion meets the bound."""

import contextlib

import numpy as np

from trajlib.reconstruction.splines import (
    cubic_spline,
    natural_spline,
    spline_accelerations,
)
from trajlib.reconstruction.sweep import SweepGains


def sweep_fit(t, h, rho, bound):
    """Return the motion of one column, its weight M and whether the bound is active.

    M comes from the banded equations, the motion from the sweep.
    """
    measured = np.flatnonzero(rho)
    accelerations = spline_accelerations(t[measured], h[measured], rho[measured])
    spline_u = accelerations(0.0)
    if np.abs(spline_u).max(initial=0) <= bound:
        return cubic_spline(*natural_spline(t, h, measured, spline_u)), 0.0, False

    sigma = np.full(rho.shape, np.inf)
    sigma[measured] = rho[measured] ** -0.5

    def by_band(log_m):
        return np.log(np.abs(accelerations(np.exp(log_m))).max() / bound)

    def by_sweep(log_m):
        return np.log(np.abs(SweepGains(t, sigma, np.exp(log_m)).apply(h)[2]).max() / bound)

    log_m, width = np.log(np.median(rho[measured]) * np.mean(np.diff(t[measured])) ** 3), 2.0
    with contextlib.suppress(np.linalg.LinAlgError):
        log_m, width = _root(by_band, log_m, width), 0.01
    # Under heavy smoothing the banded matrix loses digits, in the end its definiteness. The sweep
    # does not.
    if width > 1 or abs(by_sweep(log_m)) > 1e-9:
        log_m = _root(by_sweep, log_m, width)
    M = float(np.exp(log_m))
    return cubic_spline(t, *SweepGains(t, sigma, M).apply(h)), M, True


def _root(excess, log_m, width):
    """Return the logarithm of M at which max |u| passes the bound.

    The search begins at `start` and takes growing steps.
    """
    from scipy.optimize import brentq

    value = excess(log_m)
    while abs(log_m) < 600:
        next_log_m = log_m + (width if value > 0 else -width)
        next_value = excess(next_log_m)
        if (next_value > 0) != (value > 0):
            return brentq(excess, min(log_m, next_log_m), max(log_m, next_log_m), xtol=1e-12)
        log_m, value, width = next_log_m, next_value, 2 * width
    raise ArithmeticError(
        "no weight M was found that meets the acceleration bound: it is beyond the range of "
        "machine numbers; change the units of time or length, or fit a straight line"
    )
