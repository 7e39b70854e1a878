"""Reconstruction of a motion from its samples by either method."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from trajlib import plotting
from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_positive, read_seconds
from trajlib._typing import ArrayLike
from trajlib.reconstruction import influence
from trajlib.reconstruction.direct import bounded_fit
from trajlib.reconstruction.record_arguments import read_errors, read_record_times, read_samples
from trajlib.reconstruction.robust import robust_fit
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
    sigma : ndarray, shape (N + 1,) or (N + 1, ...)
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
        Sum of ((x_k - h_k)/sigma_k)^2, each term times its weight.
    max_acceleration : float or ndarray
        Greatest |u|.
    weights : ndarray, shape (N + 1, ...)
        Robust weights of the samples, 1 unless `robust` was given.
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
    weights: np.ndarray
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
        inside, excess = self._inside(t)
        return self._spline(inside) + excess * self._spline(inside, 1)

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
        inside, excess = self._inside(t)
        return np.where(excess == 0, self._spline(inside, 2), 0.0)

    def standard_deviations(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the standard deviations of position, velocity and acceleration.

        Parameters
        ----------
        t : array_like
            Finite times.

        Returns
        -------
        (ndarray, ndarray, ndarray)
            Each of the shape of `t` (and of the columns).

        Raises
        ------
        ValueError
            For the direct method, whose motion is no smooth function of the samples.

        Notes
        -----
        They are caused by independent errors of the samples for the weight M (and the robust
        weights) that was used. What the smoothing changes in the true motion is not included.

        Examples
        --------
        >>> mean = reconstruct([0, 1, 2], [0, 0, 0], 1.0, M=1e9)      # nearly a straight line
        >>> [part.round(3).item() for part in mean.standard_deviations(1.0)]
        [0.577, 0.707, 0.0]
        """
        if self.method == "direct":
            raise ValueError(
                "standard_deviations: the motion of the direct method is no smooth function of the "
                'samples; take method="sweep"'
            )
        inside, _ = self._inside(t)
        excess = read_seconds(t, "t") - inside
        count, shape = self.h[0].size, inside.shape + self.h.shape[1:]
        sigma = np.broadcast_to(self.sigma.reshape(self.t.size, -1), (self.t.size, count))
        weights = self.weights.reshape(self.t.size, count)
        M = np.broadcast_to(self.M, self.h.shape[1:]).ravel()
        deviations: dict = {}
        for k in range(count):
            key = sigma[:, k].tobytes(), weights[:, k].tobytes(), M[k]
            if key not in deviations:
                effective = sigma[:, k] / np.sqrt(weights[:, k])
                deviations[key] = influence.standard_deviations(
                    inside.ravel(), excess.ravel(), self.t, sigma[:, k], effective, M[k]
                )
            deviations[k] = deviations[key]
        x, y, u = np.stack([deviations[k] for k in range(count)], axis=-1).reshape(3, *shape)
        return x, y, u

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
    robust: float | None = None,
) -> Reconstruction:
    """Return the motion that fits noisy samples of its position under an acceleration bound.

    Parameters
    ----------
    t : array_like, shape (N + 1,)
        Increasing times; dates become seconds since the first of them.
    h : array_like, shape (N + 1, ...)
        Samples, a column for each coordinate or record; nan is allowed where nothing was measured.
    sigma : array_like
        Standard error, or N + 1 standard errors, one a time; for columns of different accuracy one
        a column, shape (1, columns), or one a sample. Infinity where nothing was measured.
    max_acceleration : array_like, optional
        Acceleration bound, a number or one for each column. Give either it or `M`.
    M : float, optional
        Weight of the acceleration.
    method : {"sweep", "direct"}
        "sweep" is the method of the paper, "direct" a convex programme.
    robust : float, optional
        Residuals beyond this number of standard errors, such as 1.5, count linearly and not by
        their squares (Huber), so that gross errors hardly matter.

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
    sigma = read_errors(sigma, h, t.size)
    h = read_samples(h, np.isfinite(sigma))
    if method not in ("sweep", "direct"):
        raise ValueError(f'method: expected "sweep" or "direct", got {method!r}')
    if (M is None) == (max_acceleration is None):
        raise ValueError(
            "give either max_acceleration, the bound, or M, the weight of the acceleration, and "
            "not both"
        )
    if M is not None and method == "direct":
        raise ValueError("M belongs to the sweep; the direct method takes max_acceleration alone")
    robust = None if robust is None else read_positive(robust, "robust", "standard errors")
    bounds = None if M is not None else _read_bounds(max_acceleration, h)
    if M is not None and robust is None and sigma.ndim == 1:
        spline = cubic_spline(t, *SweepGains(t, sigma, M).apply(h))
        return _result(t, h, sigma, spline, method, None, float(M), False, np.ones(t.size))
    columns, fits = h.reshape(t.size, -1), []
    errors = np.broadcast_to(sigma.reshape(t.size, -1), columns.shape)
    for k in range(columns.shape[1]):
        standard_errors, column = errors[:, k], columns[:, k]

        def fit(effective, column=column, k=k):
            if M is not None:
                return cubic_spline(t, *SweepGains(t, effective, M).apply(column)), M, False
            method_fit = sweep_fit if method == "sweep" else bounded_fit
            return method_fit(t, column, effective**-2.0, bounds[k])

        fitted, weights = fit(standard_errors), np.ones(t.size)
        if robust is not None:
            fitted, weights = robust_fit(fit, t, column, standard_errors, robust)
        fits.append((*fitted, weights))
    M_used, active = (_in_column_shape(np.array([f[j] for f in fits]), h) for j in (1, 2))
    weights = np.stack([f[3] for f in fits], axis=1).reshape(h.shape)
    spline = join_splines([f[0] for f in fits], h.shape[1:])
    return _result(t, h, sigma, spline, method, max_acceleration, M_used, active, weights)


def _read_bounds(max_acceleration, h):
    """Return the acceleration bounds of all columns, flat."""
    bound = read_array(max_acceleration, "max_acceleration", "a positive number")
    if not (bound > 0).all():
        raise ValueError(
            f"max_acceleration: expected a positive bound, got {bound.min():g}; no motion has "
            "|u| below zero, and with 0 it is uniform: fit a straight line"
        )
    try:
        return np.broadcast_to(bound, h.shape[1:]).ravel()
    except ValueError:
        raise ValueError(
            f"max_acceleration: expected a number or an array of shape {h.shape[1:]}, got shape "
            f"{bound.shape}"
        ) from None


def _result(t, h, sigma, spline, method, bound, M, active, weights):
    columns = (1,) * (h.ndim - 1)
    errors = sigma.reshape(t.size, *columns) if sigma.ndim == 1 else sigma
    residuals = np.where(np.isfinite(errors), (spline(t) - h) / errors, 0)
    shares = weights if weights.ndim == h.ndim else weights.reshape(t.size, *columns)
    misfit = np.sum(shares * residuals**2, axis=0)
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
        np.broadcast_to(shares, h.shape),
        spline,
    )


def _in_column_shape(values, h):
    return values.reshape(h.shape[1:]) if h.ndim > 1 else values.reshape(()).item()
