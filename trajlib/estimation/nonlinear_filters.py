"""Extended and unscented Kalman filters of x_{k+1} = f(x_k, u_k) + q_k, z_k = h(x_k) + r_k.

Both keep a mean and a covariance and differ in how these pass a nonlinear function. The extended filter
takes the Jacobians F of f at the estimate and H of h at the prediction,

    x^- = f(x^+),    P^- = F P^+ F^T + Q,    K = P^- H^T (H P^- H^T + R)^-1,    x^+ = x^- + K (z - h(x^-)).

The unscented filter (S. J. Julier, J. K. Uhlmann, 1997) takes the points x and x +- sqrt(n + kappa) s_i,
where s_i are the columns of a square root of P, with the weights kappa/(n + kappa) and 1/(2(n + kappa)):
their mean and covariance are x and P, and the weighted mean and covariances of their images replace
f(x), F P F^T and P H^T. Both are the Kalman filter where f and h are linear.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance, read_covariance_stack
from trajlib._arguments.matrices import read_vector
from trajlib._arguments.numbers import read_number
from trajlib._arguments.records import read_inputs, read_record, read_stack
from trajlib._arguments.symbols import join_names, read_expressions, read_symbols
from trajlib._typing import ArrayLike
from trajlib.estimation.covariances import Moments
from trajlib.estimation.filter_covariances import (
    LOST,
    at_steps,
    check_definiteness,
    innovation_inverses,
)
from trajlib.estimation.filter_run import FilterRun, finished_run
from trajlib.estimation.smoother import pseudo_solve


@dataclass(frozen=True)
class ExtendedKalmanFilter:
    """Extended Kalman filter (EKF) of x_{k+1} = f(x_k, u_k) + q_k, z_k = h(x_k) + r_k.

    Parameters
    ----------
    f : iterable of sympy.Expr
        Right-hand sides, n expressions in the states and inputs.
    h : iterable of sympy.Expr
        Measured quantities, m expressions in the states.
    states : iterable of sympy.Symbol
        States, n symbols.
    Q : array_like, shape (n, n)
        Covariance of q_k, positive semidefinite; also a stack with a matrix for each step.
    R : array_like, shape (m, m)
        Covariance of r_k, positive semidefinite; also a stack.
    inputs : iterable of sympy.Symbol, optional
        Known inputs u, s symbols; the time may be one of them.

    Raises
    ------
    ValueError
        If shapes do not fit, Q or R is no covariance, or f or h has other symbols.

    Notes
    -----
    The Jacobians are exact. A system x' = F(x) becomes such a map by a step of an integrator in
    symbols, as f = x + step F(x). MATLAB: ``extendedKalmanFilter``; filterpy: ``ExtendedKalmanFilter``.
    Source: added to the problem book; Theorem 4.1 for the linearised system.

    Examples
    --------
    >>> import numpy as np
    >>> from trajlib.estimation import Moments
    >>> x = sp.Symbol("x")
    >>> run = ExtendedKalmanFilter([x], [x**2], [x], 0, 1).run(np.array([4.0]), Moments(1, 1))
    >>> run.estimates.ravel().round(3).tolist()    # H = 2, K = 0.4
    [2.2]
    """

    f: tuple
    h: tuple
    states: tuple
    Q: np.ndarray
    R: np.ndarray
    inputs: tuple = ()

    def __post_init__(self):
        states, inputs = read_symbols(self.states, "states"), read_symbols(self.inputs, "inputs")
        n = len(states)
        f = read_expressions(self.f, n, "f")
        h = tuple(self.h) if not isinstance(self.h, sp.Expr) else (self.h,)
        h = read_expressions(h, len(h), "h")
        for name, expressions, allowed in (("f", f, {*states, *inputs}), ("h", h, {*states})):
            if foreign := set().union(*(e.free_symbols for e in expressions)) - allowed:
                raise ValueError(
                    f"{name}: {join_names(foreign)} is neither a state nor an input; substitute a number"
                )
        values = {
            "f": f,
            "h": h,
            "states": states,
            "inputs": inputs,
            "Q": read_stack(self.Q, "Q", n, n, read_covariance_stack),
            "R": read_stack(self.R, "R", len(h), len(h), read_covariance_stack),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def run(
        self,
        z: ArrayLike,
        start: Moments,
        missing: ArrayLike | None = None,
        inputs: ArrayLike | None = None,
    ) -> FilterRun:
        """Filter the measurements and return an estimate before and after each.

        Parameters
        ----------
        z : array_like, shape (N, m)
            Measurements; of shape (N,) for one output. A masked array marks its missing measurements
            itself.
        start : Moments
            Mean and covariance of x at the time of the first measurement, before it.
        missing : array_like, optional
            Booleans of the shape of z, or (N,) for whole rows; True where there is no measurement.
        inputs : array_like, shape (N, s), optional
            Inputs u_k of each step; needed if the filter has any.

        Returns
        -------
        FilterRun
            With `smoothed`, the smoother of the linearised system.

        Raises
        ------
        ValueError
            If shapes do not fit, a measurement is not finite, a function is not finite at an estimate,
            or a covariance has lost its definiteness.
        """
        z, missing, single = read_record(z, missing, len(self.h))
        if not single:
            raise ValueError("z: expected the shape (N, m); run each series by itself")
        return _run(self, self._passes(), z[0], missing[0], start, inputs)

    def __repr__(self):
        return f"{type(self).__name__} of {len(self.states)} states, {len(self.h)} outputs"

    def _passes(self):
        return _Linearised(self)


@dataclass(frozen=True, repr=False)
class UnscentedKalmanFilter(ExtendedKalmanFilter):
    """Unscented Kalman filter (UKF) of x_{k+1} = f(x_k, u_k) + q_k, z_k = h(x_k) + r_k.

    Parameters
    ----------
    f, h, states, Q, R, inputs
        As for `ExtendedKalmanFilter`.
    kappa : float, optional
        Weight of the central point, not negative; the other 2n points have the weight 1/2. Left out it
        is 3 - n for n < 3, which gives normal distributions their fourth moments, and zero else: the
        cubature filter.

    Raises
    ------
    ValueError
        As for `ExtendedKalmanFilter`, or if kappa is negative.

    Notes
    -----
    With weights that are not negative the covariances are positive semidefinite. Means of quadratic
    functions are exact; for one normal variable so are their covariances.
    MATLAB: ``unscentedKalmanFilter``; filterpy: ``UnscentedKalmanFilter``. Source: added to the problem
    book.

    Examples
    --------
    >>> import numpy as np
    >>> from trajlib.estimation import Moments
    >>> x = sp.Symbol("x")
    >>> run = UnscentedKalmanFilter([x**2], [x], [x], 0, 1).run(np.zeros(2), Moments(1, 2), [True, True])
    >>> run.predicted[1].round(9).tolist(), run.predicted_covariances[1].round(9).tolist()
    ([3.0], [[16.0]])
    """

    kappa: float | None = None

    def __post_init__(self):
        super().__post_init__()
        n = len(self.states)
        kappa = float(max(3 - n, 0)) if self.kappa is None else read_number(self.kappa, "kappa")
        if kappa < 0:
            raise ValueError(f"kappa: expected a number that is not negative, got {self.kappa}")
        object.__setattr__(self, "kappa", kappa)

    def _passes(self):
        return _Unscented(self)


class _Linearised:
    """How a mean and a covariance pass f and h in the extended filter."""

    def __init__(self, filter):
        n, m = len(filter.states), len(filter.h)
        f, h = sp.Matrix(filter.f), sp.Matrix(filter.h)
        symbols = filter.states + filter.inputs
        self._f = _compiled(symbols, [*f, *f.jacobian(filter.states)])
        self._h = _compiled(filter.states, [*h, *h.jacobian(filter.states)])
        self._shapes = (n, n), (m, n)

    def predicted(self, x, P, u, Q):
        """Return mean and covariance of f(x, u) + q, and the Jacobian."""
        image, F = self._at(self._f, "f", (*x, *u), self._shapes[0])
        return image, F @ P @ F.T + Q, F

    def measured(self, x, P):
        """Return mean and covariance of h(x), and its covariance with x."""
        image, H = self._at(self._h, "h", x, self._shapes[1])
        return image, H @ P @ H.T, P @ H.T

    @staticmethod
    def _at(function, name, arguments, shape):
        values = _finite(np.array(function(*arguments), dtype=float), name)
        return values[: shape[0]], values[shape[0] :].reshape(shape)


class _Unscented:
    """How a mean and a covariance pass f and h in the unscented filter."""

    def __init__(self, filter):
        n = len(filter.states)
        self._f = _compiled(filter.states + filter.inputs, filter.f)
        self._h = _compiled(filter.states, filter.h)
        self._spread = np.sqrt(n + filter.kappa)
        self._weights = np.full(2 * n + 1, 0.5 / (n + filter.kappa))
        self._weights[0] = filter.kappa / (n + filter.kappa)

    def predicted(self, x, P, u, Q):
        """Return mean and covariance of f(x, u) + q, and the matrix of the best linear fit of f."""
        image, covariance, common = self._passed(self._f, "f", x, P, u)
        # With singular P the fit is determined on the range of P only, and needed only there.
        return image, covariance + Q, pseudo_solve(P[None], common)[0].T

    def measured(self, x, P):
        """Return mean and covariance of h(x), and its covariance with x."""
        return self._passed(self._h, "h", x, P, ())

    def _passed(self, function, name, x, P, u):
        values, vectors = np.linalg.eigh(P)
        arms = self._spread * vectors * np.sqrt(np.maximum(values, 0))
        offsets = np.hstack([np.zeros((len(x), 1)), arms, -arms])
        points = [np.broadcast_to(part, offsets.shape[1]) for part in (*(x[:, None] + offsets), *u)]
        images = [np.broadcast_to(part, offsets.shape[1]) for part in function(*points)]
        images = _finite(np.array(images, dtype=float), name)
        mean = images @ self._weights
        deviations = images - mean[:, None]
        weighted = deviations * self._weights
        return mean, weighted @ deviations.T, offsets @ weighted.T


def _compiled(symbols, expressions):
    function = sp.lambdify(symbols, list(expressions), "numpy", cse=True)

    def evaluated(*arguments):
        # What is not finite is reported by `_finite`.
        with np.errstate(all="ignore"):
            return function(*arguments)

    return evaluated


def _finite(values, name):
    if not np.isfinite(values).all():
        raise ValueError(f"{name}: not a finite real number at an estimate; start closer, or scale")
    return values


def _run(filter, passes, z, missing, start, inputs):
    from scipy.linalg import cho_factor, cho_solve

    count, n, m = len(z), len(filter.states), len(filter.h)
    inputs = _inputs_of_steps(inputs, count, len(filter.inputs))
    Qs, Rs = at_steps(filter.Q, count), at_steps(filter.R, count)
    x, P = (
        read_vector(start.mean, "mean", n, True),
        read_covariance(start.covariance, "covariance", n, True),
    )
    predicted, estimates = np.empty((2, count, n))
    images, spread = np.empty((count, m)), np.empty((count, m, m))
    before, after, transitions = np.zeros((3, count, n, n))
    gains = np.zeros((count, n, m))
    for k in range(count):
        predicted[k], before[k] = x, P
        images[k], spread[k], common = passes.measured(x, P)
        spread[k] += Rs[k]
        rows = np.flatnonzero(~missing[k])
        if rows.size:
            block = spread[k][np.ix_(rows, rows)]
            try:
                gain = cho_solve(cho_factor(block), common[:, rows].T).T
            except np.linalg.LinAlgError:
                raise ValueError(LOST) from None
            gains[k][:, rows] = gain
            x = x + gain @ (z[k] - images[k])[rows]
            P = P - gain @ common[:, rows].T - common[:, rows] @ gain.T + gain @ block @ gain.T
            P = (P + P.T) / 2
        estimates[k], after[k] = x, P
        if k + 1 < count:
            x, P, transitions[k] = passes.predicted(x, P, inputs[k], Qs[k])
            P = (P + P.T) / 2
    check_definiteness(before)
    check_definiteness(after)
    noise = _effective_noise(before, after, transitions, Qs)
    steps = (before, after, gains, spread, *innovation_inverses(spread, missing))
    innovations = np.where(missing, np.nan, z - images)
    return finished_run(
        predicted[None],
        estimates[None],
        innovations[None],
        np.arange(count)[None],
        np.arange(count, dtype=float),
        steps,
        (transitions, noise, None),
        True,
    )


def _effective_noise(before, after, transitions, Qs):
    """Return the noise with which the linear fits of f give the predicted covariances."""
    noise = np.array(Qs)
    F = transitions[:-1]
    noise[:-1] = before[1:] - F @ after[:-1] @ F.transpose(0, 2, 1)
    return noise


def _inputs_of_steps(inputs, count, length):
    if inputs is None and not length:
        return np.zeros((count, 0))
    if inputs is None:
        raise ValueError(f"inputs: expected {length} number{'s' * (length != 1)} for each step")
    return read_inputs(inputs, count, length)
