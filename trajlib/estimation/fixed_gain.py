"""Filters with a gain of one's own: the covariance of their errors, and the gain that makes it
least.

With any K the errors of x~' = A x~ + K (z - H x~) obey d' = (A - KH) d + q - Kr, a Markov process
with the noise intensity Q + K R K^T; so its stationary covariance is a matter of Lyapunov's
equation. The least one is the Kalman filter's, for every entry of the diagonal at once, if K is
free; a gain of few parameters may come less far.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.symbols import read_symbols
from trajlib.estimation.exact_or_float import identity_like, latex, symmetric
from trajlib.estimation.stationary_covariance import (
    discrete_stationary_covariance,
    stationary_covariance,
)


def error_covariance(A, H, Q, R, K):
    """The stationary covariance of the errors with the gain K, whatever K is.

    `A`: n x n; `H`: m x n; `Q`: n x n and `R`: m x m, intensities; `K`: n x m (a flat list or a
    scalar for one output). Exact, also with symbols (those of the gain among them), or floats.
    Returns `StationaryCovariance`, which says "none" where A - KH is not asymptotically stable.
    Raises ValueError for shapes that do not fit. Source: problem 4.42.

    >>> import sympy as sp
    >>> K = sp.Symbol("K")
    >>> found = error_covariance(-1, 1, 2, 1, K)    # problem 4.42
    >>> found.covariance[0], found.where
    ((K**2 + 2)/(2*(K + 1)), K > -1)
    """
    A, H, Q, R, K = _read(A, H, Q, R, K, "A")
    return stationary_covariance(A - K @ H, symmetric(Q + K @ R @ K.T))


def discrete_error_covariance(Phi, H, Q, R, K):
    """The stationary covariance of the errors before a correction with the gain `K`, whatever it
    is.

    The process is x(i + 1) = Phi x(i) + q(i). Arguments, result and errors as for
    `error_covariance`, with covariances `Q` and `R` instead of intensities.

    >>> discrete_error_covariance(1, 1, 1, 1, 1).covariance[0]    # trust the measurement: P^+ = R
    2
    """
    Phi, H, Q, R, K = _read(Phi, H, Q, R, K, "Phi")
    kept = Phi @ (identity_like(Phi) - K @ H)
    return discrete_stationary_covariance(kept, symmetric(Q + Phi @ K @ R @ K.T @ Phi.T))


def _read(A, H, Q, R, K, name):
    floats = any_floats(A, H, Q, R, K)
    A = read_square(A, name, floats)
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
    """Values of the parameters of a gain that make a variance least.

    `values`: {symbol: value}; `variance`: what is reached.
    """

    values: dict
    variance: object

    def _repr_latex_(self):
        parts = [f"{sp.latex(symbol)} = {latex(value)}" for symbol, value in self.values.items()]
        return (
            r"$\displaystyle " + r",\quad ".join([*parts, rf"\min = {latex(self.variance)}"]) + "$"
        )


def least_gain(covariance, parameters, component=None):
    """The parameters of a gain for which the variance of a component, or the sum of all, is least.

    `covariance`: the `StationaryCovariance` of `error_covariance` with symbols in K; `parameters`:
    these symbols; `component`: the number of a state, from 0, left out for the trace. Exact: the
    stationary points inside `where` are found and compared; towards its border the variance grows
    without limit, or the least value is not reached and that is said. Returns `LeastGain`. Raises
    ValueError if there is no stationary covariance, or other symbols stand in it without a known
    sign where one is needed, or no least value is reached. Source: problem 4.42.

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
    real = {p: sp.Dummy(p.name, real=True) for p in parameters}
    back = {new: old for old, new in real.items()}
    cost = sp.together((P.trace() if component is None else P[component, component]).xreplace(real))
    where = covariance.where.xreplace(real)
    gradient = [sp.numer(sp.together(cost.diff(p))) for p in real.values()]
    inside = []
    for point in sp.solve(gradient, list(real.values()), dict=True):
        place = dict(point.items())
        if len(place) < len(real) or any(value.is_real is False for value in place.values()):
            continue
        holds = sp.simplify(where.subs(place))
        minors = [
            sp.simplify(sp.hessian(cost, list(real.values()))[:k, :k].det().subs(place))
            for k in range(1, len(real) + 1)
        ]
        if holds == sp.false or any(minor.is_positive is False for minor in minors):
            continue
        inside.append((place, sp.simplify(cost.subs(place))))
    known = [(place, value) for place, value in inside if not value.free_symbols]
    if len(known) == len(inside) > 1:
        inside = [min(known, key=lambda one: float(one[1]))]
    if len(inside) != 1:
        raise ValueError(
            f"parameters: {len(inside)} points inside {covariance.where} may be minima; give the "
            "other symbols values or signs (positive=True)"
            if inside
            else f"parameters: no minimum is reached inside {covariance.where}"
        )
    place, value = inside[0]
    return LeastGain(
        {back[p]: sp.simplify(v).xreplace(back) for p, v in place.items()}, value.xreplace(back)
    )
