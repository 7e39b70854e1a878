"""Estimators for a whole record and for a window that slides along it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from trajlib import plotting
from trajlib._arguments.numbers import read_times
from trajlib._typing import ArrayLike
from trajlib.invariant.functionals import value
from trajlib.invariant.sample_arguments import read_covariance, read_samples, sample_functions
from trajlib.invariant.weights import Sampled, WeightSolver

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class InvariantEstimator:
    """Unbiased estimator of linear functionals of y from samples of y + nuisance + noise.

    Its estimates do not depend on the nuisance.

    Parameters
    ----------
    times : array_like, shape (N,)
        Times that do not decrease; dates become seconds since the first of them.
    basis : iterable
        Functions psi_k of time that span the signal: SymPy expressions in one symbol, polynomials
        of `numpy.polynomial`, splines of SciPy, numbers, or Python functions (which have no
        derivatives). Polynomials are taken in centred and scaled time, however far the record is
        from zero; a functional may get them in another form of the same kind.
    nuisance : iterable
        Functions theta_p of time that span the nuisance, of the same kinds.
    covariance : array_like
        Covariance of the noise: a variance sigma^2, N variances, or a matrix (N, N).

    Attributes
    ----------
    Psi : ndarray, shape (K, N)
        Samples of the basis by rows.
    Theta : ndarray, shape (M, N)
        Samples of the nuisance by rows.

    Raises
    ------
    ValueError
        If there are fewer samples than functions, or arguments do not fit; if an estimate is asked
        for and the rank of the samples is lost to rounding.

    Notes
    -----
    A functional is `value(t)`, `derivative(t, r)`, `integral(a, b)`, or any linear function from
    functions of time to numbers.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.invariant import derivative
    >>> t = sp.Symbol("t")
    >>> line = InvariantEstimator(range(5), [1, t], nuisance=[(-1)**t], covariance=0.01)
    >>> h = 3 + 2*np.arange(5.0) + 7*(-1.0)**np.arange(5)
    >>> line.estimate(h, derivative(2))
    2 ± 0.0316 (gain 0.316)
    >>> line.estimate(h, value(5)).value.round(12).item()
    13.0
    """

    def __init__(
        self,
        times: ArrayLike,
        basis: Iterable,
        nuisance: Iterable = (),
        covariance: ArrayLike = 1.0,
    ) -> None:
        self.times = read_times(times, repeated=None)
        self.basis, self.nuisance = list(basis), list(nuisance)
        if not self.basis:
            raise ValueError("basis: expected one or more functions of which the signal is made")
        #: Samples of the functions by rows: shapes (K, N) and (M, N).
        self.Psi = sample_functions(self.basis, self.times, "basis")
        self.Theta = sample_functions(self.nuisance, self.times, "nuisance")
        self._covariance = read_covariance(covariance, self.times.size)
        self._sampled = Sampled.on(self.times, self.basis, self.nuisance)
        self._solver = WeightSolver(self._sampled, self._covariance)

    def weights(self, functional: Callable) -> np.ndarray:
        """Return the weights P of a functional.

        Parameters
        ----------
        functional : callable
            Functional, or m of them at once.

        Returns
        -------
        ndarray, shape (N,)
            Of shape (N, m) for m functionals.

        Raises
        ------
        ValueError
            If the samples do not determine the functional.
        """
        return self._solver.solve(functional)[0]

    def estimate(self, h: ArrayLike, functional: Callable) -> Estimate:
        """Return P^T h with its standard deviation and gain.

        Parameters
        ----------
        h : array_like, shape (N,)
            Samples; of shape (N, records) for several records.
        functional : callable
            Functional, or m of them at once.

        Returns
        -------
        Estimate

        Raises
        ------
        ValueError
            If the samples do not determine the functional.
        """
        P, std, gain = self._solver.solve(functional)
        return Estimate(P.T @ read_samples(h, self.times.size), std, gain)

    def methodical_error(self, y: Any, functional: Callable) -> float | np.ndarray:
        """Return the error without noise for a true signal, omega{y} - P^T y.

        Parameters
        ----------
        y : object
            Function of time as in `basis`.
        functional : callable
            Functional, or m of them at once.

        Returns
        -------
        float or ndarray
            Zero if y is in the span of the basis.

        Notes
        -----
        Source: (4.12) of the paper.
        """
        P = self.weights(functional)
        return np.asarray(functional(y)) - P.T @ sample_functions([y], self.times, "y")[0]

    def sliding(self, window: int, *, ends: str = "leave") -> SlidingWindow:
        """Return the estimator on a window that slides along the record.

        Parameters
        ----------
        window : int
            Number of samples in the window, odd.
        ends : {"leave", "shorten"}
            "leave": full windows only. "shorten": near an end the window is cut at the end of the
            record, and the estimate is no longer in its middle.

        Returns
        -------
        SlidingWindow
        """
        return SlidingWindow(self, window, ends)


class SlidingWindow:
    """Estimators on a window around each sample, made by `InvariantEstimator.sliding`.

    Here a functional is given as a function of the centre: `value`, `derivative`, or
    `lambda t: integral(t - 5, t)`.

    Parameters
    ----------
    estimator : InvariantEstimator
        Estimator of the whole record.
    window : int
        Number of samples in the window, odd.
    ends : str
        "leave" or "shorten".

    Attributes
    ----------
    centres : ndarray
        Times to which the estimates belong.
    """

    def __init__(self, estimator: InvariantEstimator, window: int, ends: str) -> None:
        size, count = estimator.times.size, len(estimator.basis) + len(estimator.nuisance)
        if window != int(window) or not 1 <= window <= size or int(window) % 2 == 0:
            raise ValueError(
                f"window: expected an odd number of samples up to {size}, got {window}"
            )
        if window < count:
            raise ValueError(
                f"window: {window} samples are fewer than the {count} functions of signal and "
                "nuisance"
            )
        if ends not in ("leave", "shorten"):
            raise ValueError(f'ends: expected "leave" or "shorten", got {ends!r}')
        half = int(window) // 2
        spans = [(k, max(k - half, 0), min(k + half + 1, size)) for k in range(size)]
        least = window if ends == "leave" else count
        self._spans = [span for span in spans if span[2] - span[1] >= least]
        self._estimator = estimator
        self.centres = estimator.times[[k for k, _, _ in self._spans]]

    def estimate(self, h: ArrayLike, functional: Callable = value) -> Estimate:
        """Return the estimates at all centres.

        Parameters
        ----------
        h : array_like, shape (N,)
            Samples; of shape (N, records) for several records.
        functional : callable
            Function from the centre to a functional.

        Returns
        -------
        Estimate
            Its entries belong to the times `at`.
        """
        h = read_samples(h, self._estimator.times.size)
        parts = [
            (P.T @ h[low:high], std, gain)
            for P, std, gain, low, high in self._solutions(functional)
        ]
        values, std, gain = (np.array(part) for part in zip(*parts))
        return Estimate(values, std, gain, self.centres)

    def methodical_error(self, y: Any, functional: Callable = value) -> np.ndarray:
        """Return the errors without noise at all centres for a true signal.

        Parameters
        ----------
        y : object
            Function of time as in `basis`.
        functional : callable
            Function from the centre to a functional.

        Returns
        -------
        ndarray

        Notes
        -----
        Source: (4.12) of the paper.
        """
        samples = sample_functions([y], self._estimator.times, "y")[0]
        return np.array(
            [
                functional(t)(y) - P @ samples[low:high]
                for t, (P, _, _, low, high) in zip(self.centres, self._solutions(functional))
            ]
        )

    def _solutions(self, functional):
        estimator = self._estimator
        for t, (_, low, high) in zip(self.centres, self._spans):
            samples = slice(low, high)
            K = estimator._covariance
            window = estimator._sampled.solver(
                samples, K[samples] if K.ndim == 1 else K[samples, samples]
            )
            try:
                yield *window.solve(functional(t)), low, high
            except ValueError as reason:
                raise ValueError(f"{reason} (window around t = {t:g})") from None


@dataclass(frozen=True, repr=False)
class Estimate:
    """Estimate with its standard deviation; unpacks as ``value, std = ...``.

    Attributes
    ----------
    value : ndarray
        Estimate.
    std : ndarray
        Standard deviation.
    gain : ndarray
        Norm of the weights: independent errors of size 1 in the samples cause an error of `gain`.
    at : ndarray or None
        Times, for a sliding window.
    """

    value: np.ndarray
    std: np.ndarray
    gain: np.ndarray
    at: np.ndarray | None = None

    def __iter__(self):
        return iter((self.value, self.std))

    def plot(self, ax: Axes | None = None, label: str | None = None) -> Axes:
        """Draw the estimates of a sliding window with the band of two standard deviations.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes to draw on; new ones if left out.
        label : str, optional
            Entry in the legend.

        Returns
        -------
        matplotlib.axes.Axes
        """

        if self.at is None or np.ndim(self.value) != 1:
            raise ValueError("plot: expected the estimates of one record by a sliding window")
        ax = plotting.estimate(self.at, self.value, self.std, ax, label)
        ax.set_xlabel("$t$")
        return ax

    def __repr__(self):
        if np.ndim(self.value) == 0:
            return f"{self.value:.5g} ± {self.std:.3g} (gain {self.gain:.3g})"
        std, gain = (
            " to ".join(dict.fromkeys(f"{end:.3g}" for end in (np.min(part), np.max(part))))
            for part in (self.std, self.gain)
        )
        return f"{np.size(self.value)} estimates, standard deviation {std}, gain {gain}"
