"""Filters with a given gain: the covariance of their errors, and the gain of least variance.

With any K the errors of x~' = A x~ + K (z - H x~) obey d' = (A - KH) d + q - Kr, a Markov process
with the noise intensity Q + K R K^T, so their stationary covariance solves a Lyapunov equation. The
least one is the Kalman filter's, for every entry of the diagonal at once, if K is free; a gain with
few parameters may not attain it.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_symbols
from trajlib._typing import MatrixLike, Scalar
from trajlib.estimation.exact_or_float import latex, symmetric
from trajlib.estimation.stationary_covariances import StationaryCovariance, stationary_covariance


@accepts_state_space(
    "A",
    "H",
    time="continuous",
    instead="use discrete_stationary_covariance for Phi (E - KH)",
    C="H",
)
def error_covariance(
    A: MatrixLike, H: MatrixLike, Q: MatrixLike, R: MatrixLike, K: MatrixLike
) -> StationaryCovariance:
    """Return the stationary covariance of the errors of a filter with the gain K.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols (in the gain, too), or floats. A StateSpace
        stands for A and H: `error_covariance(sys, Q, R, K)`.
    H : matrix_like, shape (m, n)
        Measurement matrix.
    Q : matrix_like, shape (n, n)
        Intensity of the process noise, positive semidefinite.
    R : matrix_like, shape (m, m)
        Intensity of the measurement noise, positive definite.
    K : matrix_like, shape (n, m)
        Gain; for one output also a flat list or a scalar.

    Returns
    -------
    StationaryCovariance
        False where A - KH is not asymptotically stable.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    Source: problem 4.42.

    Examples
    --------
    >>> import sympy as sp
    >>> K = sp.Symbol("K")
    >>> limit = error_covariance(-1, 1, 2, 1, K)    # problem 4.42
    >>> limit.covariance[0], limit.where
    ((K**2 + 2)/(2*(K + 1)), K > -1)
    """
    A, H, Q, R, K = _read(A, H, Q, R, K)
    return stationary_covariance(A - K @ H, symmetric(Q + K @ R @ K.T))


def _read(A, H, Q, R, K):
    floats = any_floats(A, H, Q, R, K)
    A = read_square(A, "A", floats)
    n = A.shape[0]
    H = read_matrix(H, "H", None, n, floats)
    m = H.shape[0]
    K = read_matrix(K, "K", None, None, floats)
    K = K.T if K.shape == (m, n) and m == 1 else K
    if tuple(K.shape) != (n, m):
        raise ValueError(f"K: expected a matrix {n} x {m}, got the shape {tuple(K.shape)}")
    return (
        A,
        H,
        read_covariance(Q, "Q", n, floats),
        read_covariance(R, "R", m, floats, definite=True),
        K,
    )


@dataclass(frozen=True)
class LeastGain:
    """Parameters of a gain that minimise a variance.

    Attributes
    ----------
    values : dict
        Value of each symbol.
    variance : scalar
        Least variance.
    """

    values: dict
    variance: Scalar

    def _repr_latex_(self):
        parts = [f"{sp.latex(symbol)} = {latex(value)}" for symbol, value in self.values.items()]
        return (
            r"$\displaystyle " + r",\quad ".join([*parts, rf"\min = {latex(self.variance)}"]) + "$"
        )


def least_gain(
    covariance: StationaryCovariance, parameters: sp.Symbol | Iterable, component: int | None = None
) -> LeastGain:
    """Return the parameters of a gain that minimise the variance of a component or their sum.

    Parameters
    ----------
    covariance : StationaryCovariance
        Result of `error_covariance` with symbols in K.
    parameters : sympy.Symbol or iterable of sympy.Symbol
        These symbols.
    component : int, optional
        Index of a state, from 0; left out, the trace is minimised.

    Returns
    -------
    LeastGain

    Raises
    ------
    ValueError
        If there is no stationary covariance, if the sign of another symbol is needed and not known,
        or if no least value is attained.

    Notes
    -----
    Exact: the stationary points inside `covariance.where` are found and compared. Towards its
    border the variance grows without bound, or the least value is not attained, which is an error.
    Source: problem 4.42.

    Examples
    --------
    >>> import sympy as sp
    >>> K = sp.Symbol("K")
    >>> least_gain(error_covariance(-1, 1, 2, 1, K), [K])
    LeastGain(values={K: -1 + sqrt(3)}, variance=-1 + sqrt(3))
    """
    parameters = read_symbols(parameters, "parameters")
    if not covariance:
        raise ValueError(f"covariance: {covariance.reason}")
    P = covariance.covariance
    if isinstance(P, np.ndarray):
        raise ValueError("covariance: expected an exact one with symbols in the gain")
    to_real = {p: sp.Dummy(p.name, real=True) for p in parameters}
    from_real = {new: old for old, new in to_real.items()}
    cost = sp.together(
        (P.trace() if component is None else P[component, component]).xreplace(to_real)
    )
    where = covariance.where.xreplace(to_real)
    gradient = [sp.numer(sp.together(cost.diff(p))) for p in to_real.values()]
    minima = []
    for point in sp.solve(gradient, list(to_real.values()), dict=True):
        values = dict(point.items())
        if len(values) < len(to_real) or any(value.is_real is False for value in values.values()):
            continue
        holds = sp.simplify(where.subs(values))
        minors = [
            sp.simplify(sp.hessian(cost, list(to_real.values()))[:k, :k].det().subs(values))
            for k in range(1, len(to_real) + 1)
        ]
        if holds == sp.false or any(minor.is_positive is False for minor in minors):
            continue
        minima.append((values, sp.simplify(cost.subs(values))))
    numeric = [(values, variance) for values, variance in minima if not variance.free_symbols]
    if len(numeric) == len(minima) > 1:
        minima = [min(numeric, key=lambda minimum: float(minimum[1]))]
    if len(minima) != 1:
        raise ValueError(
            f"parameters: {len(minima)} points inside {covariance.where} may be minima; give the "
            "other symbols values or signs (positive=True)"
            if minima
            else f"parameters: no minimum is reached inside {covariance.where}"
        )
    values, variance = minima[0]
    return LeastGain(
        {from_real[p]: sp.simplify(v).xreplace(from_real) for p, v in values.items()},
        variance.xreplace(from_real),
    )
