"""Reconstruction of a trajectory from noisy samples under an acceleration bound (Kirgetov and
Chernousko, 1995).

A point moves along a line, x' = y, y' = u, |u| <= D. Samples h_k of x with standard errors sigma_k
are given at the times t_0 < ... < t_N. With rho_k = 1/sigma_k^2 the motion minimises

    J = 1/2 sum_k rho_k (x(t_k) - h_k)^2 + M/2 integral u^2 dt,        both ends free,

and the weight M > 0 is chosen so that max |u| = D. The motion is a natural cubic spline (u is
linear between samples and vanishes at both ends), so max |u| is found at a sample. Several
coordinates are as many problems of their own.

The matrix sweep (progonka) writes the costate before sample k as an affine function of the state,
in the paper (psi_2, psi_1)^T = Q_k (x, y)^T + q_k. The pair is minus the gradient of the cost still
to come, so that with a symmetric P_k >= 0 and a vector c_k

    (psi_1, psi_2)^T = c_k - P_k (x, y)^T,      Q_k = -[[p12, p22], [p11, p12]].

Over an interval tau, with Phi = [[1, tau], [0, 1]] and S = 1/M [[tau^3/3, tau^2/2], [tau^2/2,
tau]],

    E_k = (I + S P_{k+1})^{-1} Phi,                     T_k = (I + S P_{k+1})^{-1} S,
    P_k = Phi^T P_{k+1} E_k + diag(rho_k, 0),           P_N = diag(rho_N, 0),
    c_k = E_k^T c_{k+1} + (rho_k h_k, 0)^T              backwards,
    xi_{k+1} = E_k xi_k + T_k c_{k+1}, P_0 xi_0 = c_0   forwards.

These are the paper's (4.3), (4.6)-(4.8). P_k, E_k, T_k do not depend on the samples h. Written out
and with det P carried along, the recursion for P_k adds, multiplies and divides positive numbers
only: nothing cancels, however small M is.
"""

import contextlib
from dataclasses import dataclass, field
from math import factorial

import numpy as np

from trajlib._arguments.numbers import read_times

#: The advice where two samples have one time.
REPEATED = "replace samples at one time by their weighted mean"
#: Weight of the integral of u^2 in the direct method, in units of rho tau^3: it chooses one of many
#: best motions.
TIE = 1e-7


class SweepGains:
    """Gains of the matrix sweep for times `t`, standard errors `sigma` and a weight `M`, computed
    ahead of the data.

    `t`: N + 1 increasing times. `sigma`: a number or N + 1 standard errors in the unit of the
    samples; infinity says that nothing was measured at this time. `M`: units of time^3/sigma^2.
    Source: (4.6), (4.7) of the paper.

    >>> gains = SweepGains([0, 1, 2, 3], sigma=1.0, M=0.5)
    >>> x, y, u = gains.apply([0.0, 2.0, 4.0, 6.0])       # samples on a line: the line itself
    >>> x.round(12).tolist(), y.round(12).tolist(), float(abs(u).max().round(12))
    ([0.0, 2.0, 4.0, 6.0], [2.0, 2.0, 2.0, 2.0], 0.0)
    """

    def __init__(self, t, sigma, M):
        self.t = read_times(t, "t", 2, repeated=REPEATED)
        self.rho = _weights(sigma, self.t.size)
        if not (np.isscalar(M) and np.isfinite(M) and M > 0):
            raise ValueError(
                f"M: expected a positive finite number, got {M}; max |u| grows as M falls, a "
                "straight line is M = inf"
            )
        self.M = float(M)
        self._tau = np.diff(self.t)
        self._p11, self._p12, self._p22, self._det_p, det = _riccati(self._tau, self.rho, self.M)
        tau, p11, p12, p22 = self._tau, self._p11[1:], self._p12[1:], self._p22[1:]
        s22 = tau / self.M
        s12 = s22 * tau / 2
        s11 = s12 * tau * 2 / 3
        det_s = s22 * s11 / 4
        self.closed_loop = np.moveaxis(
            np.array(
                [
                    [1 + s12 * p12 + s22 * p22, tau + p12 * s11 / 2 + p22 * s12],
                    [-(s12 * p11 + s22 * p12), 1 - p11 * s11 / 2 - p12 * s12],
                ]
            )
            / det,
            -1,
            0,
        )
        self._t11, self._t12, self._t22 = (
            (s11 + det_s * p22) / det,
            (s12 - det_s * p12) / det,
            (s22 + det_s * p11) / det,
        )
        # The unit upper triangular matrix of the backward recursion; the forward one is its
        # transpose.
        self._band = np.zeros((4, 2 * self.t.size), order="F")
        self._band[3] = 1
        self._band[1, 2::2], self._band[0, 3::2] = (
            -self.closed_loop[:, 0, 0],
            -self.closed_loop[:, 1, 0],
        )
        self._band[2, 2::2], self._band[1, 3::2] = (
            -self.closed_loop[:, 0, 1],
            -self.closed_loop[:, 1, 1],
        )

    @property
    def Q(self):
        """The matrices Q_k of the paper, shape (N + 1, 2, 2): (psi_2, psi_1)^T = Q_k (x, y)^T + q_k
        before sample k."""
        return -np.moveaxis(np.array([[self._p12, self._p22], [self._p11, self._p12]]), -1, 0)

    def apply(self, h):
        """Position, velocity and acceleration at the samples for records `h` of shape (N + 1, ...),
        three arrays of this shape."""
        records = _samples(h, self.rho)
        shape = records.shape
        records = records.reshape(shape[0], -1)
        # The motion of h + a + b t is that of h plus a + b t: what is left after a straight line
        # has smaller rounding errors.
        line, slope = _straight_line(self.t, self.rho, records)
        rest = np.where(self.rho[:, None] > 0, records - line, 0)

        c = np.zeros((2 * shape[0], rest.shape[1]))
        c[::2] = self.rho[:, None] * rest
        c = _substitute(self._band, c, transpose=False)
        forced = np.zeros_like(c)
        det = self._det_p[0]
        forced[0] = (self._p22[0] * c[0] - self._p12[0] * c[1]) / det
        forced[1] = (self._p11[0] * c[1] - self._p12[0] * c[0]) / det
        forced[2::2] = self._t11[:, None] * c[2::2] + self._t12[:, None] * c[3::2]
        forced[3::2] = self._t12[:, None] * c[2::2] + self._t22[:, None] * c[3::2]
        state = _substitute(self._band, forced, transpose=True)
        x, y = state[::2], state[1::2]
        u = self._accelerations(x, y, c[1::2])
        return (x + line).reshape(shape), (y + slope).reshape(shape), u.reshape(shape)

    def _accelerations(self, x, y, c2):
        """u = psi_2/M, or where that cancels (small M) from the cubic through neighbouring states;
        zero at both ends."""
        tau = self._tau[:, None]
        u = (c2 - self._p12[:, None] * x - self._p22[:, None] * y) / self.M
        by_states = (6 * np.diff(x, axis=0) / tau - 4 * y[:-1] - 2 * y[1:]) / tau
        cancels = self._p12[1:-1] / self.M > 6 / self._tau[1:] ** 2
        u[1:-1][cancels] = by_states[1:][cancels]
        u[[0, -1]] = 0
        return u


@dataclass(frozen=True)
class Reconstruction:
    """A reconstructed motion; what `reconstruct` returns.

    `M`: the weight (0 where the bound is not active, one number a column for several columns).
    `active`: whether the bound `bound` holds the motion back. `misfit`: sum of ((x_k -
    h_k)/sigma_k)^2. `max_acceleration`: the greatest |u|. The motion before the first and after the
    last sample is uniform.
    """

    t: np.ndarray
    h: np.ndarray
    sigma: np.ndarray
    method: str
    bound: float | np.ndarray | None
    M: float | np.ndarray
    active: bool | np.ndarray
    misfit: float | np.ndarray
    max_acceleration: float | np.ndarray
    _spline: object = field(repr=False)

    def position(self, t):
        """x at the times `t`: an array of the shape of `t` (and of the columns)."""
        inside, beyond = self._inside(t)
        return self._spline(inside) + beyond * self._spline(inside, 1)

    def velocity(self, t):
        """y = x' at the times `t`."""
        return self._spline(self._inside(t)[0], 1)

    def acceleration(self, t):
        """u = x'' at the times `t`; zero outside the record."""
        inside, beyond = self._inside(t)
        return np.where(beyond == 0, self._spline(inside, 2), 0.0)

    def _inside(self, t):
        t = np.asarray(t, dtype=float)
        if not np.isfinite(t).all():
            raise ValueError("t: the times asked for must be finite")
        inside = np.clip(t, self.t[0], self.t[-1])
        return inside, (t - inside).reshape(t.shape + (1,) * (self.h.ndim - 1))

    def plot(self, column=0):
        """The samples with the motion, and below its acceleration with the bound; returns the two
        Axes."""
        import matplotlib.pyplot as plt

        from trajlib import plotting

        columns = self.h.reshape(self.t.size, -1)
        times = np.union1d(np.linspace(self.t[0], self.t[-1], 1200), self._spline.x)
        with plotting.style():
            _, (upper, lower) = plt.subplots(
                2, 1, figsize=(6, 5.2), sharex=True, height_ratios=[3, 2]
            )
            upper.plot(
                self.t,
                columns[:, column],
                "o",
                ms=5,
                mfc="white",
                mec="k",
                ls="none",
                label="samples",
            )
            upper.plot(
                times,
                self.position(times).reshape(times.size, -1)[:, column],
                color=plotting.BLUE,
                ls="-",
                label="motion",
            )
            lower.plot(
                times,
                self.acceleration(times).reshape(times.size, -1)[:, column],
                color=plotting.BLUE,
                ls="-",
            )
            if self.bound is not None:
                bound = np.broadcast_to(self.bound, self.h.shape[1:]).ravel()[column]
                for level in (-bound, bound):
                    lower.axhline(level, color=plotting.RED, ls="--", lw=1.2)
            upper.set_ylabel("position")
            upper.legend()
            lower.set(xlabel="time", ylabel="acceleration")
        return upper, lower


def reconstruct(t, h, sigma, *, max_acceleration=None, M=None, method="sweep"):
    """The motion that fits noisy samples of its position under an acceleration bound (MATLAB:
    csaps, spaps).

    `t`: N + 1 increasing times; `h`: samples, shape (N + 1,) or (N + 1, ...) with a column for each
    coordinate or record; `sigma`: standard errors, a number or N + 1 of them (infinity: not
    measured, `h` may be nan there). Give either `max_acceleration` (a number, or one a column), or
    the weight `M`, not both.

    `method="sweep"` (the paper): M is found such that max |u| = max_acceleration; `active` is False
    and M = 0 where already the natural spline through all samples keeps the bound. (max |u| need
    not fall as M grows: where several M meet the bound, one of them is found.) `method="direct"`:
    least misfit among all motions with |u| <= max_acceleration, a convex programme that is exact up
    to the tolerance of its solver (1e-11); of equally good motions one with a small integral of
    u^2.

    >>> import numpy as np
    >>> t = np.arange(9.0)
    >>> motion = reconstruct(t, abs(t - 4), 0.5, max_acceleration=0.5)
    >>> motion.active, round(motion.max_acceleration, 9), round(float(motion.position(4.0)), 3)
    (True, 0.5, 1.033)
    """
    t = read_times(t, "t", 2, repeated=REPEATED)
    rho = _weights(sigma, t.size)
    h = _samples(h, rho)
    if method not in ("sweep", "direct"):
        raise ValueError(f'method: expected "sweep" or "direct", got {method!r}')
    if (M is None) == (max_acceleration is None):
        raise ValueError(
            "give either max_acceleration, the bound, or M, the weight of the acceleration, and "
            "not both"
        )
    if M is not None:
        if method == "direct":
            raise ValueError(
                "M belongs to the sweep; the direct method takes max_acceleration alone"
            )
        x, y, u = SweepGains(t, sigma, M).apply(h)
        return _result(t, h, rho, _cubic(t, x, y, u), method, None, float(M), False)

    bound = np.asarray(max_acceleration, dtype=float)
    if not (bound > 0).all():
        raise ValueError(
            f"max_acceleration: expected a positive bound, got {max_acceleration}; no motion has "
            "|u| below zero, and with 0 it is uniform: fit a straight line"
        )
    try:
        bounds = np.broadcast_to(bound, h.shape[1:]).ravel()
    except ValueError:
        raise ValueError(
            f"max_acceleration: expected a number or an array of shape {h.shape[1:]}, got shape "
            f"{bound.shape}"
        ) from None
    columns = h.reshape(t.size, -1)
    solve = _swept if method == "sweep" else _direct
    found = [solve(t, columns[:, k], rho, bounds[k]) for k in range(columns.shape[1])]
    weight, active = (_as_given(np.array([f[j] for f in found]), h) for j in (1, 2))
    spline = _side_by_side([f[0] for f in found], h.shape[1:])
    return _result(t, h, rho, spline, method, max_acceleration, weight, active)


def sweep_eigenvalues(kappa):
    """The four eigenvalues of the transition matrix A_k, by growing modulus; `kappa` = rho tau^3/M.

    The roots of (3.9), a reciprocal polynomial: with w = lambda + 1/lambda it is w^2 + (kappa/6 -
    4) w + 2 kappa/3 + 4 = 0.

    >>> sweep_eigenvalues(144).real.round(3).tolist()        # the only kappa > 0 with multiple roots
    [-0.101, -0.101, -9.899, -9.899]
    """
    if not (np.isfinite(kappa) and kappa > 0):
        raise ValueError(f"kappa: expected a positive finite number, got {kappa}")
    half = 2 - kappa / 12
    root = np.sqrt(complex(kappa * (kappa / 144 - 1)))
    large = []
    for w in (half + root, half - root):
        s = np.sqrt(w * w - 4)
        large.append(max(((w + s) / 2, (w - s) / 2), key=abs))
    large.sort(key=abs)
    return np.array([1 / large[1], 1 / large[0], *large])


def _riccati(tau, rho, M):
    """p11, p12, p22 and det of P_k for all k, and det(I + S P_{k+1}); a plain loop over floats,
    nothing is subtracted."""
    a, b, c, d = float(rho[-1]), 0.0, 0.0, 0.0
    rows, steps = [(a, b, c, d)], []
    for step, weight in zip(tau[::-1].tolist(), rho[-2::-1].tolist()):
        s22 = step / M
        s12 = 0.5 * step * s22
        s11 = step * s12 / 1.5
        det = 1 + s11 * a + 2 * s12 * b + s22 * c + 0.25 * s11 * s22 * d
        across = step * a
        c = (step * across + 2 * step * b + c + s11 * d) / det
        b = (across + b + s12 * d) / det
        a = (a + s22 * d) / det + weight
        d = d / det + weight * c
        rows.append((a, b, c, d))
        steps.append(det)
    return *np.array(rows[::-1]).T.copy(), np.array(steps[::-1])


def _substitute(band, right, transpose):
    from scipy.linalg.lapack import dtbtrs

    solution, info = dtbtrs(band, right, uplo="U", trans="T" if transpose else "N", diag="U")
    if info:
        raise ArithmeticError(f"the banded substitution failed ({info})")
    return solution


def _swept(t, h, rho, bound):
    """Knots with states, M and activity for one column: M from the banded form, the motion from the
    sweep."""
    seen = np.flatnonzero(rho)
    accelerations = _banded(t[seen], h[seen], rho[seen])
    free = accelerations(0.0)
    if np.abs(free).max(initial=0) <= bound:
        return _cubic(*_interpolant(t, h, seen, free)), 0.0, False

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
    return _cubic(t, *SweepGains(t, sigma, M).apply(h)), M, True


def _banded(t, h, rho):
    """M -> u at the samples, from (R + M G) u = second differences: five diagonals, positive
    definite (Reinsch)."""
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


def _interpolant(t, h, seen, u):
    """States at all times of the natural cubic spline through the samples seen, straight beyond
    them."""
    x, tau = h[seen], np.diff(t[seen])
    y = np.diff(x) / tau - tau * (2 * u[:-1] + u[1:]) / 6
    y = np.append(y, y[-1] + tau[-1] * (u[-2] + u[-1]) / 2)
    spline = _cubic(t[seen], x, y, u)
    inside = np.clip(t, t[seen[0]], t[seen[-1]])
    slope = spline(inside, 1)
    return (
        t,
        spline(inside) + (t - inside) * slope,
        slope,
        np.where(t == inside, spline(inside, 2), 0),
    )


def _direct(t, h, rho, bound):
    """Least misfit under |u| <= bound, exactly, as a convex programme in the states x, y at the
    times.

    With `bound` as the unit of acceleration, dy = y_1 - y_0 and w = x_1 - x_0 - tau (y_0 + y_1)/2,
    a control |u| <= 1 leads from one state to the next in the time tau if and only if |w| + dy^2/4
    <= tau^2/4: the extreme w for a given dy belong to u = +1, then -1, and to the reverse.
    """
    import casadi

    seen = np.flatnonzero(rho)
    free = _banded(t[seen], h[seen], rho[seen])(0.0)
    if np.abs(free).max(initial=0) <= bound:
        return _cubic(*_interpolant(t, h, seen, free)), 0.0, False
    # Dimensionless: time in mean steps, acceleration in units of the bound, what a straight line
    # leaves of the samples.
    line, slope = (part[:, 0] for part in _straight_line(t, rho, h[:, None]))
    unit = np.mean(np.diff(t))
    length = bound * unit**2
    tau = np.diff(t) / unit
    weight = rho / np.median(rho[seen])
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
    found = solver(x0=np.zeros(2 * t.size), lbg=-np.inf, ubg=np.tile(tau**2 / 4, 2))
    if not solver.stats()["success"]:
        raise ArithmeticError(
            f"the direct method did not converge ({solver.stats()['return_status']}); try "
            f'method="sweep"'
        )
    x, y = np.asarray(found["x"]).ravel().reshape(2, t.size)
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
    """The control |u| <= 1 with the least integral of u^2 for each interval: lengths, first and
    last values of three pieces, at one bound, linear, at the other; shapes (N, 3).

    It is a linear function of time, cut off at the bounds. Where w > 0 it falls. For dy >= 0 it
    reaches the upper bound first; for dy < 0 it is the one for -dy run backwards, with the other
    sign.
    """
    sign, turned = np.where(w < 0, -1.0, 1.0), w * dy < 0
    turned |= (w == 0) & (dy < 0)
    dy, w = np.minimum(np.abs(dy), tau), np.abs(w)
    mean, half = dy / tau, 6 * w / tau**2
    rest = np.maximum(tau - dy, np.finfo(float).tiny)
    # upper bound, then linear for this time
    ramp = 1.5 * tau - 3 * w / rest
    drop = 2 * rest / np.maximum(ramp, np.finfo(float).tiny)
    # linear between both bounds
    half_ramp = np.sqrt(np.maximum(3 * (tau**2 / 4 - dy**2 / 4 - w), 0))
    unbounded, one = mean + half <= 1, drop <= 2
    zero = np.zeros_like(tau)
    lengths = np.select(
        [unbounded[:, None], one[:, None]],
        [np.stack([zero, tau, zero], axis=1), np.stack([tau - ramp, ramp, zero], axis=1)],
        np.stack([(tau + dy) / 2 - half_ramp, 2 * half_ramp, (tau - dy) / 2 - half_ramp], axis=1),
    )
    begin, end = (
        np.where(unbounded, mean + half, 1),
        np.select([unbounded, one], [mean - half, 1 - drop], -1),
    )
    first, last = (
        np.stack([zero + 1, begin, zero - 1], axis=1),
        np.stack([zero + 1, end, zero - 1], axis=1),
    )
    turned = turned[:, None]
    lengths = np.where(turned, lengths[:, ::-1], lengths)
    first, last = np.where(turned, -last[:, ::-1], first), np.where(turned, -first[:, ::-1], last)
    return np.maximum(lengths, 0), sign[:, None] * first, sign[:, None] * last


def _pieces(t, x, y, lengths, first, last):
    """The piecewise cubic from the states x, y at the begin of each interval, with u linear on its
    three pieces."""
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
    kept = lengths > 1e-12 * np.diff(t)[:, None]
    begin[np.arange(len(t) - 1), np.argmax(kept, axis=1)] = t[:-1]
    knots = np.append(begin[kept], t[-1])
    jerk = (last - first)[kept] / np.diff(knots)
    return PPoly(np.array([jerk / 6, first[kept] / 2, y[kept], x[kept]]), knots)


def _cubic(t, x, y, u):
    """The piecewise cubic with the states x, y and the accelerations u at its knots."""
    from scipy.interpolate import PPoly

    tau = np.diff(t).reshape(-1, *(1,) * (x.ndim - 1))
    return PPoly(np.array([np.diff(u, axis=0) / (6 * tau), u[:-1] / 2, y[:-1], x[:-1]]), t)


def _side_by_side(splines, shape):
    """One piecewise cubic of several, with the knots of all of them."""
    from scipy.interpolate import PPoly

    knots = np.unique(np.concatenate([spline.x for spline in splines]))
    values = [
        np.stack([spline(knots[:-1], k) / factorial(k) for spline in splines], axis=-1)
        for k in (3, 2, 1, 0)
    ]
    return PPoly(np.array(values).reshape(4, -1, *shape), knots)


def _result(t, h, rho, spline, method, bound, M, active):
    columns = (1,) * (h.ndim - 1)
    off = np.where(rho.reshape(-1, *columns) > 0, spline(t) - h, 0)
    sigma = np.full(rho.shape, np.inf)
    sigma[rho > 0] = rho[rho > 0] ** -0.5
    misfit = np.sum(rho.reshape(-1, *columns) * off**2, axis=0)
    lengths = np.diff(spline.x).reshape(-1, *columns)
    greatest = np.maximum(
        np.abs(2 * spline.c[1]), np.abs(2 * spline.c[1] + 6 * spline.c[0] * lengths)
    ).max(axis=0)
    return Reconstruction(
        t, h, sigma, method, bound, M, active, _as_given(misfit, h), _as_given(greatest, h), spline
    )


def _as_given(values, h):
    return values.reshape(h.shape[1:]) if h.ndim > 1 else values.reshape(()).item()


def _straight_line(t, rho, records):
    """The weighted straight-line fit at the times and its slope, for columns of records."""
    known = np.where(rho[:, None] > 0, records, 0)
    total = rho.sum()
    centre = rho @ t / total
    mean = rho @ known / total
    slope = (rho * (t - centre)) @ (known - mean) / (rho @ (t - centre) ** 2)
    return mean + (t - centre)[:, None] * slope, np.broadcast_to(slope, records.shape)


def _weights(sigma, size):
    sigma = np.asarray(sigma, dtype=float)
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


def _samples(h, rho):
    h = np.asarray(h, dtype=float)
    if h.ndim == 0 or h.shape[0] != rho.size or 0 in h.shape:
        raise ValueError(
            f"h: expected {rho.size} samples, one a time (several records as columns), got shape "
            f"{h.shape}"
        )
    lost = ~np.isfinite(h.reshape(rho.size, -1)).all(axis=1) & (rho > 0)
    if lost.any():
        k = np.flatnonzero(lost)[0]
        raise ValueError(
            f"h: sample {k} is not a finite number; where nothing was measured give sigma[{k}] = "
            "inf"
        )
    return h
