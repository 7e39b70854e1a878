"""Reconstruction of a motion from its samples by either method."""

from dataclasses import dataclass, field

import numpy as np

from trajlib import plotting
from trajlib.reconstruction.arguments import read_samples, read_times, read_weights
from trajlib.reconstruction.direct import bounded_fit
from trajlib.reconstruction.splines import cubic_spline, join_splines
from trajlib.reconstruction.sweep import SweepGains
from trajlib.reconstruction.weight import sweep_fit


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
    t = read_times(t)
    rho = read_weights(sigma, t.size)
    h = read_samples(h, rho)
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
        return _result(t, h, rho, cubic_spline(t, x, y, u), method, None, float(M), False)

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
    solve = sweep_fit if method == "sweep" else bounded_fit
    found = [solve(t, columns[:, k], rho, bounds[k]) for k in range(columns.shape[1])]
    weight, active = (_as_given(np.array([f[j] for f in found]), h) for j in (1, 2))
    spline = join_splines([f[0] for f in found], h.shape[1:])
    return _result(t, h, rho, spline, method, max_acceleration, weight, active)


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
