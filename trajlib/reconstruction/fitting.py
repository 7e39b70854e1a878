"""Reconstruction of a motion from its samples by either method."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from trajlib import plotting
from trajlib._arguments.numbers import read_seconds
from trajlib._typing import ArrayLike
from trajlib.reconstruction.arguments import read_record_times, read_samples, read_weights
from trajlib.reconstruction.direct import bounded_fit
from trajlib.reconstruction.splines import cubic_spline, join_splines
from trajlib.reconstruction.sweep import SweepGains
from trajlib.reconstruction.weight import sweep_fit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from scipy.interpolate import PPoly


@dataclass(frozen=True)
class Reconstruction:
    """Reconstructed motion, the result of `reconstruct`.

    Before the first and after the last sample the motion is uniform.

    Attributes
    ----------
    t : ndarray, shape (N + 1,)
        Times of the samples.
    h : ndarray, shape (N + 1, ...)
        Samples.
    sigma : ndarray, shape (N + 1,)
        Standard errors.
    method : str
        "sweep" or "direct".
    bound : float, ndarray or None
        Acceleration bound, None if M was given.
    M : float or ndarray
        Weight of the acceleration, 0 where the bound is not active; one number a column.
    active : bool or ndarray
        Whether the bound is active.
    misfit : float or ndarray
        Sum of ((x_k - h_k)/sigma_k)^2.
    max_acceleration : float or ndarray
        Greatest |u|.
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
    _spline: PPoly = field(repr=False)

    def position(self, t: ArrayLike) -> np.ndarray:
        """Return the position x.

        Parameters
        ----------
        t : array_like
            Finite times.

        Returns
        -------
        ndarray
            Of the shape of `t` (and of the columns).
        """
        inside, beyond = self._inside(t)
        return self._spline(inside) + beyond * self._spline(inside, 1)

    def velocity(self, t: ArrayLike) -> np.ndarray:
        """Return the velocity y = x'.

        Parameters
        ----------
        t : array_like
            Finite times.

        Returns
        -------
        ndarray
            Of the shape of `t` (and of the columns).
        """
        return self._spline(self._inside(t)[0], 1)

    def acceleration(self, t: ArrayLike) -> np.ndarray:
        """Return the acceleration u = x'', zero outside the record.

        Parameters
        ----------
        t : array_like
            Finite times.

        Returns
        -------
        ndarray
            Of the shape of `t` (and of the columns).
        """
        inside, beyond = self._inside(t)
        return np.where(beyond == 0, self._spline(inside, 2), 0.0)

    def _inside(self, t):
        t = read_seconds(t, "t")
        inside = np.clip(t, self.t[0], self.t[-1])
        return inside, (t - inside).reshape(t.shape + (1,) * (self.h.ndim - 1))

    def plot(self, column: int = 0) -> tuple[Axes, Axes]:
        """Draw the samples with the motion, and below its acceleration with the bound.

        Parameters
        ----------
        column : int
            Index of the coordinate or record.

        Returns
        -------
        (matplotlib.axes.Axes, matplotlib.axes.Axes)
        """
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


def reconstruct(
    t: ArrayLike,
    h: ArrayLike,
    sigma: ArrayLike,
    *,
    max_acceleration: ArrayLike | None = None,
    M: float | None = None,
    method: str = "sweep",
) -> Reconstruction:
    """Return the motion that fits noisy samples of its position under an acceleration bound.

    Parameters
    ----------
    t : array_like, shape (N + 1,)
        Increasing times; dates become seconds since the first of them.
    h : array_like, shape (N + 1, ...)
        Samples, a column for each coordinate or record; nan is allowed where nothing was measured.
    sigma : array_like
        Standard error, or N + 1 standard errors; infinity where nothing was measured.
    max_acceleration : array_like, optional
        Acceleration bound, a number or one for each column. Give either it or `M`.
    M : float, optional
        Weight of the acceleration.
    method : {"sweep", "direct"}
        "sweep" is the method of the paper, "direct" a convex programme.

    Returns
    -------
    Reconstruction

    Raises
    ------
    ValueError
        If times do not increase, shapes do not fit, or not exactly one of `max_acceleration` and
        `M` is given.
    ArithmeticError
        If no weight is found within the range of floats or the solver does not converge.

    Notes
    -----
    "sweep" finds M such that max |u| = max_acceleration; `active` is False and M = 0 where already
    the natural spline through all samples keeps the bound. Max |u| need not decrease as M grows:
    where several M meet the bound, one of them is found. "direct" minimises the misfit among all
    motions with |u| <= max_acceleration, exact up to the tolerance of its solver (1e-11); of
    equally good motions it returns one with a small integral of u^2. MATLAB: ``csaps``, ``spaps``.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(9.0)
    >>> motion = reconstruct(t, abs(t - 4), 0.5, max_acceleration=0.5)
    >>> motion.active, round(motion.max_acceleration, 9), round(float(motion.position(4.0)), 3)
    (True, 0.5, 1.033)
    """
    t = read_record_times(t)
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
    fit = sweep_fit if method == "sweep" else bounded_fit
    fits = [fit(t, columns[:, k], rho, bounds[k]) for k in range(columns.shape[1])]
    weight, active = (_in_column_shape(np.array([f[j] for f in fits]), h) for j in (1, 2))
    spline = join_splines([f[0] for f in fits], h.shape[1:])
    return _result(t, h, rho, spline, method, max_acceleration, weight, active)


def _result(t, h, rho, spline, method, bound, M, active):
    columns = (1,) * (h.ndim - 1)
    residuals = np.where(rho.reshape(-1, *columns) > 0, spline(t) - h, 0)
    sigma = np.full(rho.shape, np.inf)
    sigma[rho > 0] = rho[rho > 0] ** -0.5
    misfit = np.sum(rho.reshape(-1, *columns) * residuals**2, axis=0)
    lengths = np.diff(spline.x).reshape(-1, *columns)
    max_acceleration = np.maximum(
        np.abs(2 * spline.c[1]), np.abs(2 * spline.c[1] + 6 * spline.c[0] * lengths)
    ).max(axis=0)
    return Reconstruction(
        t,
        h,
        sigma,
        method,
        bound,
        M,
        active,
        _in_column_shape(misfit, h),
        _in_column_shape(max_acceleration, h),
        spline,
    )


def _in_column_shape(values, h):
    return values.reshape(h.shape[1:]) if h.ndim > 1 else values.reshape(()).item()
