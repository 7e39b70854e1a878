"""Invariant-unbiased estimation of a linear functional under a nuisance and noise (Bulychev, 2020;
with Eliseev, 2008).

N samples h = y + s + xi of a function y at the times t_n hold a nuisance s and noise xi with the
covariance matrix K. Known are a basis of either,

    y(t) = sum_k Y_k psi_k(t),      s(t) = sum_p c_p theta_p(t),

not the coefficients. Wanted is a number omega{y}: a value, a derivative, an integral. Among all
weights P the estimate P^T h takes those of least variance P^T K P that are

    unbiased, Psi P = o, o_k = omega{psi_k},        invariant, Theta P = 0,

with the matrices Psi (K x N) and Theta (M x N) of the samples of the functions, by rows.
(4.8)-(4.10) of the paper are

    P = Z Psi^T (Psi Z Psi^T)^{-1} o,    sigma^2 = o^T (Psi Z Psi^T)^{-1} o,
    Z = K^{-1} - K^{-1} Theta^T (Theta K^{-1} Theta^T)^{-1} Theta K^{-1}.

It is computed by reflections and not by these inverses. With K = L L^T let

    L^{-1} [Theta^T, Psi^T] = [Q_1, Q_2] [[R_11, R_12], [0, R_22]];    then    P = L^{-T} Q_2 R_22^{-T} o,
    sigma = |R_22^{-T} o|.

R_22 is what is left of the signal's functions once the nuisance's are taken out. Where it is nearly
singular the two look alike, and noise and everything that psi leaves out are multiplied: the gain
|P| says how much.
"""

from dataclasses import dataclass
from functools import lru_cache
from numbers import Real

import numpy as np

from trajlib._arguments.numbers import read_times

#: Singular values below this many roundings are zero; a functional of which this share lies there
#: is lost.
ROUNDINGS, REACHED = 10, 1e-9


def value(t):
    """The functional y -> y(t); `t` may be an array, for as many functionals.

    >>> import sympy as sp
    >>> round(float(value(2)(sp.Symbol("t")**3)), 12)
    8.0
    """
    return derivative(t, 0)


def derivative(t, r=1):
    """The functional y -> the derivative of order r of y at `t`, a number or an array.

    >>> from numpy.polynomial import Polynomial
    >>> float(derivative(2, 2)(Polynomial([0, 0, 0, 1])))
    12.0
    """
    t = _finite(t, "t")
    if r != int(r) or r < 0:
        raise ValueError(
            f"r: expected the order of a derivative, a whole number from zero on, got {r}"
        )
    return lambda y: _derivative_of(y, int(r))(t)


def integral(a, b):
    """The functional y -> the integral of y from `a` to `b`, numbers or arrays.

    >>> from numpy.polynomial import Polynomial
    >>> float(integral(0, 3)(Polynomial([0, 0, 1])))
    9.0
    """
    a, b = _finite(a, "a"), _finite(b, "b")

    def omega(y):
        if hasattr(y, "antiderivative"):
            primitive = y.antiderivative()
        elif hasattr(y, "integ"):
            primitive = y.integ()
        else:
            return _quadrature(_derivative_of(y, 0), a, b)
        return primitive(b) - primitive(a)

    return omega


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
        self.times = read_times(times, repeated=None)
        self.basis, self.nuisance = list(basis), list(nuisance)
        if not self.basis:
            raise ValueError("basis: expected one or more functions of which the signal is made")
        #: Samples of the functions by rows: shapes (K, N) and (M, N).
        self.Psi = _sampled(self.basis, self.times, "basis")
        self.Theta = _sampled(self.nuisance, self.times, "nuisance")
        self._covariance = _covariance(covariance, self.times.size)
        self._window = _Window(self.Psi, self.Theta, self._covariance)

    def weights(self, functional):
        """The weights P, shape (N,), or (N, m) for m functionals at once."""
        return self._window.solve(_on(functional, self.basis))[0]

    def estimate(self, h, functional):
        """P^T h with its standard deviation and gain, an `Estimate`; `h`: N samples, or (N,
        records)."""
        P, std, gain = self._window.solve(_on(functional, self.basis))
        return Estimate(P.T @ _samples(h, self.times.size), std, gain)

    def methodical_error(self, y, functional):
        """The error without noise for a true signal `y`, a function of time as in `basis`: omega{y}
        - P^T y, (4.12) of the paper. It is zero if the basis holds y."""
        P = self.weights(functional)
        return np.asarray(functional(y)) - P.T @ _sampled([y], self.times, "y")[0]

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
        h = _samples(h, self._estimator.times.size)
        parts = [
            (P.T @ h[low:high], std, gain) for P, std, gain, low, high in self._solved(functional)
        ]
        return Estimate(*(np.array(part) for part in zip(*parts)), at=self.centres)

    def methodical_error(self, y, functional=value):
        """The errors without noise at all centres for a true signal `y`, (4.12) of the paper."""
        samples = _sampled([y], self._estimator.times, "y")[0]
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
            window = _Window(
                whole.Psi[:, part], whole.Theta[:, part], K[part] if K.ndim == 1 else K[part, part]
            )
            try:
                yield *window.solve(_on(functional(t), whole.basis)), low, high
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
        from trajlib import plotting

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


class _Window:
    """Weights for samples of the functions and one covariance."""

    def __init__(self, Psi, Theta, covariance):
        self.K, self.N = Psi.shape
        if self.N < self.K + len(Theta):
            raise ValueError(
                f"times: {self.N} samples are fewer than the {self.K + len(Theta)} functions of "
                "signal and nuisance"
            )
        self.factor = (
            np.sqrt(covariance) if covariance.ndim == 1 else np.linalg.cholesky(covariance)
        )
        signal, self.sizes = _unit_columns(self._whitened(Psi.T))
        taken = _span(_unit_columns(self._whitened(Theta.T))[0])
        Q, R = np.linalg.qr(np.hstack([taken, signal]))
        self.Q = Q[:, taken.shape[1] :]
        self.U, self.s, self.Vt = np.linalg.svd(R[taken.shape[1] :, taken.shape[1] :])
        self.kept = self.s > ROUNDINGS * self.N * np.finfo(float).eps

    def solve(self, o):
        """P, sigma and |P| for o of shape (K,) or (K, m)."""
        scaled = (o.T / self.sizes).T
        along = self.Vt @ scaled
        lost = np.abs(along[~self.kept])
        if (lost > REACHED * np.linalg.norm(scaled, axis=0)).any():
            self._refuse(o, lost)
        w = self.U[:, self.kept] @ (along[self.kept].T / self.s[self.kept]).T
        P = self._whitened(self.Q @ w, transposed=True)
        return P, np.linalg.norm(w, axis=0), np.linalg.norm(P, axis=0)

    def _refuse(self, o, lost):
        row = int(np.argmax(lost.reshape(len(lost), -1).max(axis=1)))
        combination = self.Vt[~self.kept][row] / self.sizes
        combination = combination / combination[np.argmax(np.abs(combination))]
        words = " + ".join(
            f"{c:.4g} basis[{k}]" for k, c in enumerate(combination) if abs(c) > 1e-6
        ).replace("+ -", "- ")
        on_it = np.abs(combination @ o).max()
        raise ValueError(
            f"functional: the samples cannot tell it. At all of them {words} is a combination of "
            f"the nuisance's functions or zero, while the functional is {on_it:.4g} on it. Leave a "
            "function out, or sample longer or more densely; count the time from the record, not "
            "from far away"
        )

    def _whitened(self, rows, transposed=False):
        from scipy.linalg import solve_triangular

        if self.factor.ndim == 1:
            return (rows.T / self.factor).T
        return solve_triangular(self.factor, rows, lower=True, trans="T" if transposed else "N")


def _unit_columns(matrix):
    sizes = np.linalg.norm(matrix, axis=0)
    sizes = np.where(sizes > 0, sizes, 1)
    return matrix / sizes, sizes


def _span(columns):
    """An orthonormal basis of the span of unit columns, which may depend on each other."""
    from scipy.linalg import qr

    if columns.shape[1] == 0:
        return columns
    Q, R, _ = qr(columns, mode="economic", pivoting=True)
    return Q[:, np.abs(np.diag(R)) > ROUNDINGS * len(columns) * np.finfo(float).eps]


def _on(functional, basis):
    """o = omega{psi_k}, shape (K,) or (K, m)."""
    o = np.array([functional(psi) for psi in basis], dtype=float)
    if o.ndim > 2 or not np.isfinite(o).all():
        raise ValueError(
            "functional: expected a finite number for each function of the basis, or a list of "
            f"them, got {o.tolist() if o.size < 9 else f'shape {o.shape}'}"
        )
    return o


def _derivative_of(y, r):
    """The derivative of order r as a function of arrays."""
    if hasattr(y, "free_symbols"):
        return _lambdified(y, r)
    if hasattr(y, "deriv"):
        return y.deriv(r) if r else y
    if hasattr(y, "antiderivative"):
        return y.derivative(r) if r else y
    if isinstance(y, Real):
        return lambda t: np.full(np.shape(t), float(y) if r == 0 else 0.0)[()]
    if not callable(y):
        raise TypeError(f"basis, nuisance: expected functions of time, got {y!r}")
    if r:
        raise TypeError(
            "basis: a Python function has no derivative; give a SymPy expression, a polynomial of "
            "numpy.polynomial or a spline"
        )
    return y


@lru_cache(maxsize=512)
def _lambdified(expression, r):
    import sympy as sp

    symbols = sorted(expression.free_symbols, key=str)
    if len(symbols) > 1:
        raise ValueError(
            f"basis, nuisance: {expression} has the symbols {', '.join(map(str, symbols))}; "
            "expected a function of the time alone, give the others numbers"
        )
    t = symbols[0] if symbols else sp.Symbol("t")
    function = sp.lambdify(t, expression.diff(t, r) if r else expression, "numpy")
    return lambda at: function(np.asarray(at, dtype=float)) + np.zeros(np.shape(at))


def _quadrature(function, a, b):
    from scipy.integrate import quad

    return np.vectorize(
        lambda low, high: quad(function, low, high, epsabs=1e-12, epsrel=1e-12, limit=200)[0]
    )(a, b)[()]


def _sampled(functions, times, name):
    with np.errstate(all="ignore"):
        rows = [
            np.broadcast_to(np.asarray(_derivative_of(y, 0)(times), dtype=float), times.shape)
            for y in functions
        ]
    for k, row in enumerate(rows):
        if not np.isfinite(row).all():
            raise ValueError(
                f"{name}: function {k} is not finite at t = {times[~np.isfinite(row)][0]:g}"
            )
    return np.array(rows).reshape(len(rows), times.size)


def _samples(h, size):
    h = np.asarray(h, dtype=float)
    if h.ndim not in (1, 2) or h.shape[0] != size:
        raise ValueError(
            f"h: expected {size} samples, one a time, or ({size}, records), got shape {h.shape}"
        )
    if not np.isfinite(h).all():
        raise ValueError(
            f"h: sample {np.argwhere(~np.isfinite(h))[0][0]} is not finite; leave out what was not "
            f"measured, with its time"
        )
    return h


def _covariance(covariance, size):
    """N variances or a matrix (N, N)."""
    K = np.asarray(covariance, dtype=float)
    if K.shape not in ((), (size,), (size, size)):
        raise ValueError(
            f"covariance: expected a variance, {size} variances or a matrix ({size}, {size}), got "
            f"shape {K.shape}"
        )
    if not np.isfinite(K).all():
        raise ValueError("covariance: expected finite numbers")
    if K.ndim < 2:
        if (K <= 0).any():
            raise ValueError(f"covariance: variances must be positive, got {K.min():g}")
        return np.broadcast_to(K, (size,))
    if np.abs(K - K.T).max() > 1e-10 * np.abs(K).max():
        raise ValueError("covariance: the matrix must be symmetric")
    lowest = np.linalg.eigvalsh(K)
    if lowest[0] <= ROUNDINGS * size * np.finfo(float).eps * lowest[-1]:
        raise ValueError(
            f"covariance: the matrix must be positive definite, its smallest eigenvalue is "
            f"{lowest[0]:.3g}: some combination of the samples would have no error"
        )
    return K


def _finite(t, name):
    t = np.asarray(t, dtype=float)
    if t.ndim > 1 or not np.isfinite(t).all():
        raise ValueError(f"{name}: expected a finite number or a list of them, got {t.tolist()}")
    return t
