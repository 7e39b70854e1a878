"""Piecewise cubics with given states at their knots, and the spline through the samples.

The motion for a weight M is a natural cubic spline. Its accelerations u at the samples solve
(R + M G) u = second differences of h, five diagonals, positive definite (Reinsch).
"""

from math import factorial

import numpy as np


def spline_accelerations(t, h, rho):
    """Return the function M -> u at the samples."""
    from scipy.linalg import solveh_banded

    tau = np.diff(t)
    second = np.diff(np.diff(h) / tau)
    left, right = 1 / tau[:-1], 1 / tau[1:]
    middle = -(left + right)
    w = 1 / rho
    stiff = np.zeros((3, second.size))  # upper diagonals, as solveh_banded wants them
    stiff[2] = left**2 * w[:-2] + middle**2 * w[1:-1] + right**2 * w[2:]
    stiff[1, 1:] = middle[:-1] * left[1:] * w[1:-2] + right[:-1] * middle[1:] * w[2:-1]
    stiff[0, 2:] = right[:-2] * left[2:] * w[2:-2]
    mass = np.zeros_like(stiff)
    mass[2] = (tau[:-1] + tau[1:]) / 3
    mass[1, 1:] = tau[1:-1] / 6

    def accelerations(M):
        if not second.size:
            return np.zeros(t.size)
        rows = slice(None) if second.size > 2 else slice(3 - second.size, None)
        scale = 1 / max(1.0, M)
        inner = solveh_banded(
            (mass * scale + M * scale * stiff)[rows],
            second * scale,
            check_finite=False,
            overwrite_ab=True,
        )
        return np.concatenate([[0], inner, [0]])

    return accelerations


def natural_spline(t, h, measured, u):
    """Return t, x, y, u of the natural cubic spline, linear beyond the measured samples."""
    x, tau = h[measured], np.diff(t[measured])
    y = np.diff(x) / tau - tau * (2 * u[:-1] + u[1:]) / 6
    y = np.append(y, y[-1] + tau[-1] * (u[-2] + u[-1]) / 2)
    spline = cubic_spline(t[measured], x, y, u)
    inside = np.clip(t, t[measured[0]], t[measured[-1]])
    slope = spline(inside, 1)
    return (
        t,
        spline(inside) + (t - inside) * slope,
        slope,
        np.where(t == inside, spline(inside, 2), 0),
    )


def cubic_spline(t, x, y, u):
    """Return the piecewise cubic with the states x, y and the accelerations u at its knots."""
    from scipy.interpolate import PPoly

    tau = np.diff(t).reshape(-1, *(1,) * (x.ndim - 1))
    return PPoly(np.array([np.diff(u, axis=0) / (6 * tau), u[:-1] / 2, y[:-1], x[:-1]]), t)


def join_splines(splines, shape):
    """Return one piecewise cubic of several columns, with the knots of all of them."""
    from scipy.interpolate import PPoly

    knots = np.unique(np.concatenate([spline.x for spline in splines]))
    values = [
        np.stack([spline(knots[:-1], k) / factorial(k) for spline in splines], axis=-1)
        for k in (3, 2, 1, 0)
    ]
    return PPoly(np.array(values).reshape(4, -1, *shape), knots)


def straight_line(t, rho, records):
    """Return the weighted straight-line fit at the times and its slope, for columns of records."""
    measured = np.where(rho[:, None] > 0, records, 0)
    total = rho.sum()
    centre = rho @ t / total
    mean = rho @ measured / total
    slope = (rho * (t - centre)) @ (measured - mean) / (rho @ (t - centre) ** 2)
    return mean + (t - centre)[:, None] * slope, np.broadcast_to(slope, records.shape)
