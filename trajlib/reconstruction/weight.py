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
    """Knots with states, M and activity for one column: M from the banded form, the motion from the
    sweep."""
    seen = np.flatnonzero(rho)
    accelerations = spline_accelerations(t[seen], h[seen], rho[seen])
    free = accelerations(0.0)
    if np.abs(free).max(initial=0) <= bound:
        return cubic_spline(*natural_spline(t, h, seen, free)), 0.0, False

    sigma = np.full(rho.shape, np.inf)
    sigma[seen] = rho[seen] ** -0.5

    def by_band(log_m):
        return np.log(np.abs(accelerations(np.exp(log_m))).max() / bound)

    def by_sweep(log_m):
        return np.log(np.abs(SweepGains(t, sigma, np.exp(log_m)).apply(h)[2]).max() / bound)

    log_m, width = np.log(np.median(rho[seen]) * np.mean(np.diff(t[seen])) ** 3), 2.0
    with contextlib.suppress(np.linalg.LinAlgError):
        log_m, width = _root(by_band, log_m, width), 0.01
    # Under heavy smoothing the banded matrix loses digits, in the end its definiteness. The sweep
    # does not.
    if width > 1 or abs(by_sweep(log_m)) > 1e-9:
        log_m = _root(by_sweep, log_m, width)
    M = float(np.exp(log_m))
    return cubic_spline(t, *SweepGains(t, sigma, M).apply(h)), M, True


def _root(excess, start, width):
    """The logarithm of M at which max |u| passes the bound, searched from `start` with growing
    steps."""
    from scipy.optimize import brentq

    here = excess(start)
    while abs(start) < 600:
        there = start + (width if here > 0 else -width)
        value = excess(there)
        if (value > 0) != (here > 0):
            return brentq(excess, min(start, there), max(start, there), xtol=1e-12)
        start, here, width = there, value, 2 * width
    raise ArithmeticError(
        "no weight M was found that meets the acceleration bound: it is beyond the range of "
        "machine numbers; change the units of time or length, or fit a straight line"
    )
