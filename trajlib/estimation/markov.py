"""Means and covariances of linear Markov processes in discrete and in continuous time.

    x_{i+1} = Phi x_i + q_i,   mu_{i+1} = Phi mu_i,   P_{i+1} = Phi P_i Phi^T + Q             (4.4), (4.5)
    x' = A x + q,              mu' = A mu,            P' = A P + P A^T + Q                    (4.6), (4.7)

In discrete time Q is a covariance, in continuous time an intensity, M[q(t) q(s)^T] = Q delta(t -
s). A process x' = Ax + Bq, with noise in some of its equations, has the intensity B Q B^T.
"""

from typing import NamedTuple

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_square, read_vector
from trajlib._arguments.symbols import exact_decimals
from trajlib._real_symbols import as_real
from trajlib.estimation.covariances import trusted_moments
from trajlib.estimation.exact_or_float import identity_like, symmetric
from trajlib.estimation.modes import (
    Modes,
    continuous_basis,
    discrete_basis,
    exact_spectrum,
    products,
    sums,
)


class DiscreteModel(NamedTuple):
    """x_{i+1} = Phi x_i + q_i with the covariance Q of q_i; both n x n."""

    Phi: object
    Q: object


def discrete_moments(Phi, Q, start, steps):
    """Mean and covariance after some steps of x_{i+1} = Phi x_i + q_i.

    `Phi`: n x n; `Q`: n x n, the covariance of q_i, positive semidefinite; `start`: `Moments` of
    x_0; `steps`: a whole number >= 0, or a SymPy symbol k for the closed form in k (exact matrices
    only; it holds for k = 0, 1, 2, ..., where `where` of the result holds; an eigenvalue zero gives
    terms KroneckerDelta(k, j)). Returns `Moments`. Raises ValueError for shapes that do not fit and
    a Q that is no covariance, NotImplementedError for a closed form whose eigenvalues need more
    than square roots. Source: (4.4), (4.5); problems 4.19, 4.20.

    >>> import sympy as sp
    >>> from trajlib.estimation import Moments
    >>> k, q = sp.symbols("k q")
    >>> process = [[0, 2], [0, 0]], sp.diag(0, q), Moments([0, 0], sp.eye(2))
    >>> discrete_moments(*process, 2).covariance
    Matrix([
    [4*q, 0],
    [  0, q]])
    >>> discrete_moments(1, q, Moments(1, 0), k).covariance
    Matrix([[k*q]])
    """
    Phi, Q, mean, P, floats = _read(Phi, Q, start, "Phi")
    steps = sp.sympify(steps)
    if steps.is_Integer and steps >= 0:
        reach, noise = _repeated(Phi, Q, int(steps))
        return trusted_moments(reach @ mean, symmetric(reach @ P @ reach.T + noise))
    if floats or steps.is_number:
        raise ValueError(
            f"steps: expected a whole number that is not negative{' or a symbol' * (not floats)}, "
            f"got {steps}"
        )
    return _closed_form(
        Phi, Q, mean, P, lambda X: Phi * X * Phi.T, 1, products, discrete_basis(steps)
    )


def continuous_moments(A, Q, start, t):
    """Mean and covariance of x' = Ax + q after the time t.

    `A`: n x n; `Q`: n x n, the intensity of q, positive semidefinite; `start`: `Moments` at the
    beginning; `t`: the time since then, a number >= 0 or, for exact matrices, a SymPy symbol: then
    P(t) in closed form, for zero and repeated eigenvalues as well. With symbols in A it holds where
    `where` of the result does; at the exceptional values substitute them into A and ask again.
    Returns `Moments`. Raises as `discrete_moments` does. Source: (4.6), (4.7); problems 4.15 -
    4.17, example 5.

    >>> import sympy as sp
    >>> from trajlib.estimation import Moments
    >>> t, Q, a, p = sp.symbols("t Q a p")
    >>> continuous_moments([[0, 1], [0, 0]], sp.diag(0, Q), Moments([0, 0], sp.zeros(2)), t).covariance   # example 5
    Matrix([
    [Q*t**3/3, Q*t**2/2],
    [Q*t**2/2,      Q*t]])
    >>> found = continuous_moments(a, Q, Moments(0, p), t)
    >>> found.covariance[0], found.where
    (-Q/(2*a) + (Q + 2*a*p)*exp(2*a*t)/(2*a), Ne(a, 0))
    """
    A, Q, mean, P, floats = _read(A, Q, start, "A")
    t = exact_decimals(sp.sympify(t))
    if t.is_negative or t.is_real is False or t in (sp.oo, sp.nan) or (floats and not t.is_number):
        raise ValueError(
            f"t: expected a time that is not negative{' or a symbol' * (not floats)}, got {t}"
        )
    if floats:
        reach, noise = _discretised_floats(A, Q, float(t))
        return trusted_moments(reach @ mean, symmetric(reach @ P @ reach.T + noise))
    return _closed_form(A, Q, mean, P, lambda X: A * X + X * A.T, 0, sums, continuous_basis(t))


def discretised(A, Q, step):
    """The discrete process that x' = Ax + q is at the times 0, step, 2 step, ...: exact, not for
    short steps only (MATLAB: c2d, lqrd).

    `A`, `Q`: n x n; `step`: its length, a number >= 0 or, for exact matrices, a symbol. Returns
    `DiscreteModel`: Phi = e^{A step} and Q the integral of e^{As} Q e^{A^T s} from 0 to step.
    Floats come from a step so short that the series converges at once and doublings of it, so that
    Q stays positive semidefinite also for long steps of fast decaying processes. Raises as
    `continuous_moments` does. Source: (4.6), (4.7), (4.4).

    >>> import sympy as sp
    >>> h = sp.Symbol("h")
    >>> discretised([[0, 1], [0, 0]], [[0, 0], [0, 1]], h).Q
    Matrix([
    [h**3/3, h**2/2],
    [h**2/2,      h]])
    """
    floats = any_floats(A, Q)
    A = read_square(A, "A", floats)
    if floats:
        Q = read_covariance(Q, "Q", A.shape[0], True)
        if not (np.isfinite(float(step)) and float(step) >= 0):
            raise ValueError(f"step: expected a time that is not negative, got {step}")
        return DiscreteModel(*_discretised_floats(A, Q, float(step)))
    n = A.rows
    spread = continuous_moments(A, Q, trusted_moments(sp.zeros(n, 1), sp.zeros(n)), step)
    return DiscreteModel(_transition(A, exact_decimals(sp.sympify(step))), spread.covariance)


def _read(A, Q, start, name):
    floats = any_floats(A, Q, start.mean, start.covariance)
    A = read_square(A, name, floats)
    n = A.shape[0]
    return (
        A,
        read_covariance(Q, "Q", n, floats),
        read_vector(start.mean, "mean", n, floats),
        read_covariance(start.covariance, "covariance", n, floats),
        floats,
    )


def _repeated(Phi, Q, steps):
    """Phi^steps and the covariance that the noise has given by then, by doubling."""
    reach, noise = identity_like(Phi), 0 * Q
    while steps:
        if steps % 2:
            reach, noise = Phi @ reach, symmetric(Phi @ noise @ Phi.T + Q)
        Phi, Q, steps = Phi @ Phi, symmetric(Phi @ Q @ Phi.T + Q), steps // 2
    return reach, noise


def _closed_form(A, Q, mean, P, operator, kept, combined, basis):
    """Mean and covariance as sums of modes; the constant `c` that drives P with cQ is one component
    more."""
    n = A.rows
    there, back = as_real(sp.Matrix.hstack(A, Q, P, mean))
    A_, Q_, mean_, P_ = (matrix.xreplace(there) for matrix in (A, Q, mean, P))

    def driven(X):
        c = X[n, n]
        return sp.diag(operator(X[:n, :n].xreplace(back)).xreplace(there) + c * Q_, kept * c)

    spectrum = exact_spectrum(A_)
    means = Modes(lambda v: A_ * v, spectrum, mean_)
    covariances = Modes(driven, [sp.Integer(kept), *combined(spectrum)], sp.diag(P_, 1))
    mean = means.at(*basis) if means.terms else sp.zeros(n, 1)
    covariance = covariances.at(*basis)[:n, :n]
    return trusted_moments(
        mean.xreplace(back),
        covariance.xreplace(back),
        sp.And(means.where, covariances.where).xreplace(back),
    )


def _transition(A, t):
    """e^{At}, exact."""
    there, back = as_real(A)
    A = A.xreplace(there)
    return (
        Modes(lambda X: A * X, exact_spectrum(A), sp.eye(A.rows))
        .at(*continuous_basis(t))
        .xreplace(back)
    )


def _discretised_floats(A, Q, step):
    import scipy.linalg

    n = len(A)
    doublings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=1).max() * step, 1)))))
    short = step / 2**doublings
    # Van Loan: both integrals from one exponential, without growth since the step is short.
    both = scipy.linalg.expm(np.block([[-A, Q], [np.zeros((n, n)), A.T]]) * short)
    Phi = both[n:, n:].T
    noise = Phi @ both[:n, n:]
    return _repeated(Phi, (noise + noise.T) / 2, 2**doublings)
