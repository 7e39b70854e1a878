"""Estimators for a whole record and for a window that slides along it."""

from dataclasses import dataclass

import numpy as np

from trajlib import plotting
from trajlib.invariant.arguments import read_covariance, read_samples, read_times, sample_functions
from trajlib.invariant.functionals import on_basis, value
from trajlib.invariant.weights import WeightSolver


class InvariantEstimator:
    """Estimates of linear functionals of y from samples of y + nuisance + noise, unbiased and blind
    to the nuisance.

    `times`: N times that do not decrease. `basis`, `nuisance`: lists of functions of the time,
    psi_k and theta_p: SymPy expressions in one symbol, polynomials of `numpy.polynomial`, splines
    of SciPy, numbers, or Python functions (which have no derivatives). Powers of a time that is
    counted from far away depend on each other in machine numbers: count it from the record.
    `covariance` of the noise: a variance, N variances, or the matrix (N, N); it is sigma^2, not
    sigma.

    A functional is `value(t)`, `derivative(t, r)`, `integral(a, b)`, or any function that takes
    such a function of time to a number and is linear.

    >>> import sympy as sp
    >>> t = sp.Symbol("t")
    >>> line = InvariantEstimator(range(5), [1, t], nuisance=[(-1)**t], covariance=0.01)
    >>> h = 3 + 2*np.arange(5.0) + 7*(-1.0)**np.arange(5)
    >>> line.estimate(h, derivative(2))
    2 ± 0.0316 (gain 0.316)
    >>> line.estimate(h, value(5)).value.round(12).item()
    13.0
    """

    def __init__(self, times, basis, nuisance=(), covariance=1.0):
        self.times = read_times(times)
        self.basis, self.nuisance = list(basis), list(nuisance)
        if not self.basis:
            raise ValueError("basis: expected one or more functions of which the signal is made")
        #: Samples of the functions by rows: shapes (K, N) and (M, N).
        self.Psi = sample_functions(self.basis, self.times, "basis")
        self.Theta = sample_functions(self.nuisance, self.times, "nuisance")
        self._covariance = read_covariance(covariance, self.times.size)
        self._window = WeightSolver(self.Psi, self.Theta, self._covariance)

    def weights(self, functional):
        """The weights P, shape (N,), or (N, m) for m functionals at once."""
        return self._window.solve(on_basis(functional, self.basis))[0]

    def estimate(self, h, functional):
        """P^T h with its standard deviation and gain, an `Estimate`; `h`: N samples, or (N,
        records)."""
        P, std, gain = self._window.solve(on_basis(functional, self.basis))
        return Estimate(P.T @ read_samples(h, self.times.size), std, gain)

    def methodical_error(self, y, functional):
        """The error without noise for a true signal `y`, a function of time as in `basis`: omega{y}
        - P^T y, (4.12) of the paper. It is zero if the basis holds y."""
        P = self.weights(functional)
        return np.asarray(functional(y)) - P.T @ sample_functions([y], self.times, "y")[0]

    def sliding(self, window, *, ends="leave"):
        """The same on a window of so many samples (an odd number) that slides along the record:
        `SlidingWindow`.

        `ends="leave"`: full windows only. `ends="shorten"`: near an end the window is what the
        record has of it, and the estimate is no longer in its middle.
        """
        return SlidingWindow(self, window, ends)


class SlidingWindow:
    """An estimator of its own around each sample; made by `InvariantEstimator.sliding`. `centres`:
    the times to which the estimates belong. Here a functional is given as a function of the centre:
    `value`, `derivative`, or `lambda t: integral(t - 5, t)`."""

    def __init__(self, estimator, window, ends):
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

    def estimate(self, h, functional=value):
        """Estimates at all centres, an `Estimate` whose entries belong to `at`."""
        h = read_samples(h, self._estimator.times.size)
        parts = [
            (P.T @ h[low:high], std, gain) for P, std, gain, low, high in self._solved(functional)
        ]
        return Estimate(*(np.array(part) for part in zip(*parts)), at=self.centres)

    def methodical_error(self, y, functional=value):
        """The errors without noise at all centres for a true signal `y`, (4.12) of the paper."""
        samples = sample_functions([y], self._estimator.times, "y")[0]
        return np.array(
            [
                functional(t)(y) - P @ samples[low:high]
                for t, (P, _, _, low, high) in zip(self.centres, self._solved(functional))
            ]
        )

    def _solved(self, functional):
        whole = self._estimator
        for t, (_, low, high) in zip(self.centres, self._spans):
            part = slice(low, high)
            K = whole._covariance
            window = WeightSolver(
                whole.Psi[:, part], whole.Theta[:, part], K[part] if K.ndim == 1 else K[part, part]
            )
            try:
                yield *window.solve(on_basis(functional(t), whole.basis)), low, high
            except ValueError as reason:
                raise ValueError(f"{reason} (window around t = {t:g})") from None


@dataclass(frozen=True, repr=False)
class Estimate:
    """`value` with its standard deviation `std` and `gain`, the norm of the weights: independent
    errors of 1 in the samples make an error of `gain`. Unpacks as `value, std = ...`. `at`: the
    times, for a sliding window."""

    value: np.ndarray
    std: np.ndarray
    gain: np.ndarray
    at: np.ndarray | None = None

    def __iter__(self):
        return iter((self.value, self.std))

    def plot(self, ax=None, label=None):
        """The estimates of a sliding window with the band of two standard deviations; returns the
        Axes."""

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
