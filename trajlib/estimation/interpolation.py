"""Optimal interpolation, smoothing and prediction of stationary processes.

The linear estimate of x(t) from z_i = x(t_i) + r_i of least variance has the weights w with (K + R)
w = k(t), where K_ij = k(t_i - t_j) and k(t)_i = k(t - t_i); its error has the variance k(0) -
k(t)^T w. Between the times t_i this interpolates (with R: smooths), after them it predicts.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_square, read_vector
from trajlib._arguments.numbers import read_seconds
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib._typing import ArrayLike, Matrix, MatrixLike, Scalar, ScalarLike
from trajlib.estimation.exact_or_float import latex, solve


@dataclass(frozen=True)
class OptimalWeights:
    """Weights of the estimate of x(t), the sum of weights[i] z_i, for a process of mean zero.

    With a symbol for t both attributes are Piecewise, with a formula between neighbouring times.

    Attributes
    ----------
    weights : matrix
        N weights (a column; for floats with T times an array of shape (T, N)).
    variance : scalar
        Variance of the error (for floats an array of shape (T,)).
    """

    weights: Matrix
    variance: Scalar

    def estimate(self, z: MatrixLike, mean: ScalarLike = 0) -> Scalar | np.ndarray:
        """Return x~(t) from the measurements, for a process with a known constant mean.

        Parameters
        ----------
        z : matrix_like
            N measurements.
        mean : scalar_like
            Mean of the process.

        Returns
        -------
        scalar or ndarray
        """
        if isinstance(self.weights, np.ndarray):
            return mean + self.weights @ (read_vector(z, "z", self.weights.shape[-1], True) - mean)
        z = read_vector(z, "z", len(self.weights), False)
        return mean + sum(w * (value - mean) for w, value in zip(self.weights, z))

    def _repr_latex_(self):
        return rf"$\displaystyle w = {latex(self.weights)},\quad \sigma^2 = {latex(self.variance)}$"


def optimal_weights(
    correlation: sp.Expr,
    tau: sp.Symbol,
    times: MatrixLike,
    t: ScalarLike | ArrayLike,
    noise: MatrixLike = 0,
) -> OptimalWeights:
    """Return the weights of the best linear estimate of x(t) from measurements at given times.

    Parameters
    ----------
    correlation : sympy.Expr
        Even correlation function, given for tau >= 0.
    tau : sympy.Symbol
        Time difference.
    times : matrix_like
        N times of measurements, distinct unless there is noise.
    t : scalar_like or array_like
        A number, a symbol (for exact times only), or an array of T times for floats.
    noise : matrix_like, shape (N, N)
        Variance of the errors of measurement, or their covariance.

    Returns
    -------
    OptimalWeights

    Raises
    ------
    ValueError
        If the correlation matrix of the times is not positive definite, for a time given twice or a
        function that is no correlation.

    Notes
    -----
    Also called simple kriging, or the Wiener filter. Source: problem 4.31.

    Examples
    --------
    >>> import sympy as sp
    >>> tau, t = sp.symbols("tau t", real=True)
    >>> best = optimal_weights(sp.exp(-tau), tau, [1, 2, 3], t)    # problem 4.31
    >>> [w.subs(t, 4) for w in best.weights], sp.simplify(best.variance.subs(t, 4))
    ([0, 0, exp(-1)], 1 - exp(-2))
    """
    (tau,) = read_symbols(tau, "tau")
    correlation = exact_decimals(read_expression(correlation, "correlation"))
    if any_floats(times, noise, t):
        return _float_weights(correlation, tau, times, t, noise)
    times = read_vector(times, "times", None, False)
    if times.free_symbols:
        raise ValueError("times: expected numbers")
    t = exact_decimals(read_expression(t, "t"))
    K = sp.Matrix(
        len(times), len(times), lambda i, j: correlation.subs(tau, abs(times[i] - times[j]))
    )
    K = read_covariance(
        K + _noise_covariance(noise, len(times), False),
        "correlation",
        len(times),
        False,
        definite=True,
    )
    sorted_times = sorted(times, key=float)
    if t.is_number:
        return _between(correlation, tau, times, K, t, t)
    pieces = []
    for low, high in zip([None, *sorted_times], [*sorted_times, None]):
        representative = high - 1 if low is None else low + 1 if high is None else (low + high) / 2
        pieces.append(
            (
                _between(correlation, tau, times, K, t, representative),
                sp.true if high is None else t <= high,
            )
        )
    weights = sp.Matrix(
        [
            sp.Piecewise(*((piece.weights[i], where) for piece, where in pieces))
            for i in range(len(times))
        ]
    )
    return OptimalWeights(
        weights, sp.Piecewise(*((piece.variance, where) for piece, where in pieces))
    )


def _between(correlation, tau, times, K, t, representative):
    """Return the formulas for a t on the same side of all times as `representative`."""
    k = sp.Matrix([correlation.subs(tau, t - s if representative >= s else s - t) for s in times])
    weights = solve(K, k.applyfunc(lambda e: sp.expand(e, power_exp=True))).applyfunc(_shortest)
    return OptimalWeights(weights, _shortest(correlation.subs(tau, 0) - k.dot(weights)))


def _shortest(entry):
    return sp.powsimp(sp.factor(sp.cancel(sp.expand(entry, power_exp=True))))


def _noise_covariance(noise, count, floats):
    noise = read_square(noise, "noise", floats)
    if noise.shape == (1, 1):
        noise = (np.eye if floats else sp.eye)(count) * noise[0, 0]
    return read_covariance(noise, "noise", count, floats)


def _float_weights(correlation, tau, times, t, noise):
    times = read_vector(read_seconds(times, "times"), "times", None, True)
    t = read_seconds(t, "t")
    function = sp.lambdify(tau, correlation, "numpy")

    def correlation_at(gaps):
        return np.broadcast_to(function(np.abs(gaps)), gaps.shape).astype(float)

    K = read_covariance(
        correlation_at(times[:, None] - times) + _noise_covariance(noise, len(times), True),
        "correlation",
        len(times),
        True,
        definite=True,
    )
    k = correlation_at(t[..., None] - times)
    weights = np.linalg.solve(K, k.reshape(-1, len(times)).T).T.reshape(k.shape)
    return OptimalWeights(weights, float(function(0.0)) - (k * weights).sum(axis=-1))
