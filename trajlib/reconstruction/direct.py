"""The direct method: least misfit among all motions under the acceleration bound.

With the bound as the unit of acceleration, dy = y_1 - y_0 and w = x_1 - x_0 - tau (y_0 + y_1)/2, a
control |u| <= 1 leads from one state to the next in the time tau if and only if |w| + dy^2/4 <=
tau^2/4: the extreme w for a given dy belong to u = +1, then -1, and to the reverse. So the misfit
is minimised by a convex programme in the states x, y at the times.
"""

import numpy as np

from trajlib.reconstruction.splines import (
    cubic_spline,
    natural_spline,
    spline_accelerations,
    straight_line,
)

#: Weight of the integral of u^2, in units of rho tau^3: it selects one of many optimal motions.
TIE = 1e-7


def bounded_fit(t, h, rho, bound):
    """Return the motion of least misfit under |u| <= bound, 0, and whether it is active."""
    import casadi

    measured = np.flatnonzero(rho)
    spline_u = spline_accelerations(t[measured], h[measured], rho[measured])(0.0)
    if np.abs(spline_u).max(initial=0) <= bound:
        return cubic_spline(*natural_spline(t, h, measured, spline_u)), 0.0, False
    # Dimensionless: time in mean steps, acceleration in units of the bound, samples less a straight
    # line.
    line, slope = (part[:, 0] for part in straight_line(t, rho, h[:, None]))
    unit = np.mean(np.diff(t))
    length = bound * unit**2
    tau = np.diff(t) / unit
    weight = rho / np.median(rho[measured])
    target = np.where(rho > 0, (h - line) / length, 0)

    x, y = casadi.SX.sym("x", t.size), casadi.SX.sym("y", t.size)
    dy, w = y[1:] - y[:-1], x[1:] - x[:-1] - tau * (y[1:] + y[:-1]) / 2
    misfit = casadi.dot(weight * (x - target), x - target)
    # the least integral of u^2 without a bound
    effort = casadi.dot(dy**2, 1 / tau) + 12 * casadi.dot(w**2, tau**-3)
    problem = {
        "x": casadi.vertcat(x, y),
        "f": (misfit + TIE * effort) / 2,
        "g": casadi.vertcat(dy**2 / 4 + w, dy**2 / 4 - w),
    }
    options = {
        "print_time": False,
        "ipopt.print_level": 0,
        "ipopt.sb": "yes",
        "ipopt.tol": 1e-11,
        "ipopt.max_iter": 300,
        "ipopt.bound_relax_factor": 0.0,
    }
    solver = casadi.nlpsol("direct", "ipopt", problem, options)
    solution = solver(x0=np.zeros(2 * t.size), lbg=-np.inf, ubg=np.tile(tau**2 / 4, 2))
    if not solver.stats()["success"]:
        raise ArithmeticError(
            f"the direct method did not converge ({solver.stats()['return_status']}); try "
            f'method="sweep"'
        )
    x, y = np.asarray(solution["x"]).ravel().reshape(2, t.size)
    lengths, first, last = _least_effort(tau, np.diff(y), np.diff(x) - tau * (y[1:] + y[:-1]) / 2)
    spline = _pieces(
        t,
        (x * length + line)[:-1],
        (y * length / unit + slope)[:-1],
        lengths * unit,
        first * bound,
        last * bound,
    )
    return spline, 0.0, True


def _least_effort(tau, dy, w):
    """Return the control |u| <= 1 with the least integral of u^2 for each interval.

    Lengths, first and last values of three pieces: at one bound, linear, at the other; shapes (N,
    3). The control is a linear function of time, cut off at the bounds. Where w > 0 it decreases.
    For dy >= 0 it reaches the upper bound first; for dy < 0 it is the one for -dy reversed in time,
    with the other sign.
    """
    sign, reversed_ = np.where(w < 0, -1.0, 1.0), w * dy < 0
    reversed_ |= (w == 0) & (dy < 0)
    dy, w = np.minimum(np.abs(dy), tau), np.abs(w)
    mean, half = dy / tau, 6 * w / tau**2
    slack = np.maximum(tau - dy, np.finfo(float).tiny)
    # upper bound, then linear for this time
    ramp = 1.5 * tau - 3 * w / slack
    drop = 2 * slack / np.maximum(ramp, np.finfo(float).tiny)
    # linear between both bounds
    half_ramp = np.sqrt(np.maximum(3 * (tau**2 / 4 - dy**2 / 4 - w), 0))
    no_bound, one_bound = mean + half <= 1, drop <= 2
    zero = np.zeros_like(tau)
    lengths = np.select(
        [no_bound[:, None], one_bound[:, None]],
        [np.stack([zero, tau, zero], axis=1), np.stack([tau - ramp, ramp, zero], axis=1)],
        np.stack([(tau + dy) / 2 - half_ramp, 2 * half_ramp, (tau - dy) / 2 - half_ramp], axis=1),
    )
    begin, end = (
        np.where(no_bound, mean + half, 1),
        np.select([no_bound, one_bound], [mean - half, 1 - drop], -1),
    )
    first, last = (
        np.stack([zero + 1, begin, zero - 1], axis=1),
        np.stack([zero + 1, end, zero - 1], axis=1),
    )
    reversed_ = reversed_[:, None]
    lengths = np.where(reversed_, lengths[:, ::-1], lengths)
    first, last = (
        np.where(reversed_, -last[:, ::-1], first),
        np.where(reversed_, -first[:, ::-1], last),
    )
    return np.maximum(lengths, 0), sign[:, None] * first, sign[:, None] * last


def _pieces(t, x, y, lengths, first, last):
    """Return the piecewise cubic from the states x, y at the start of each interval.

    On its three pieces u is linear.
    """
    from scipy.interpolate import PPoly

    jerk = (last - first) / np.where(lengths > 0, lengths, 1)
    states = [(x, y)]
    for k in range(2):
        x, y = states[-1]
        s = lengths[:, k]
        states.append(
            (
                x + s * y + s**2 * (first[:, k] / 2 + s * jerk[:, k] / 6),
                y + s * (first[:, k] + s * jerk[:, k] / 2),
            )
        )
    x, y = (np.stack(parts, axis=1) for parts in zip(*states))
    begin = t[:-1, None] + np.cumsum(np.c_[np.zeros(len(lengths)), lengths[:, :2]], axis=1)
    positive = lengths > 1e-12 * np.diff(t)[:, None]
    begin[np.arange(len(t) - 1), np.argmax(positive, axis=1)] = t[:-1]
    knots = np.append(begin[positive], t[-1])
    jerk = (last - first)[positive] / np.diff(knots)
    return PPoly(np.array([jerk / 6, first[positive] / 2, y[positive], x[positive]]), knots)
