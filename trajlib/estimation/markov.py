"""Means and covariances of linear Markov processes in discrete and in continuous time.

    x_{i+1} = Phi x_i + q_i,   mu_{i+1} = Phi mu_i,   P_{i+1} = Phi P_i Phi^T + Q             (4.4), (4.5)
    x' = A x + q,              mu' = A mu,            P' = A P + P A^T + Q                    (4.6), (4.7)

In discrete time Q is a covariance, in continuous time an intensity, E[q(t) q(s)^T] = Q delta(t -
s). A process x' = Ax + Bq, with noise in some of its equations, has the intensity B Q B^T.
"""

from typing import NamedTuple

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_square, read_vector
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_duration, read_exact_expression
from trajlib._real_symbols import as_real
from trajlib._typing import Matrix, MatrixLike, ScalarLike
from trajlib.estimation.covariances import Moments, trusted_moments
from trajlib.estimation.exact_or_float import identity_like, symmetric
from trajlib.estimation.modes import (
    Modes,
    continuous_basis,
    discrete_basis,
    exact_spectrum,
    products,
    sums,
)
from trajlib.estimation.van_loan import discretise_steps


class DiscreteModel(NamedTuple):
    """Discrete process x_{i+1} = Phi x_i + q_i.

    Attributes
    ----------
    Phi : matrix, shape (n, n)
        Transition matrix.
    Q : matrix, shape (n, n)
        Covariance of q_i.
    """

    Phi: Matrix
    Q: Matrix


class DrivenModel(NamedTuple):
    """Discrete process x_{i+1} = Phi x_i + B u_i + q_i.

    Attributes
    ----------
    Phi : matrix, shape (n, n)
        Transition matrix.
    B : matrix, shape (n, s)
        Matrix of the control.
    Q : matrix, shape (n, n)
        Covariance of q_i.
    """

    Phi: Matrix
    B: Matrix
    Q: Matrix


@accepts_state_space("Phi", time="discrete", instead="use continuous_moments", A="Phi")
def discrete_moments(
    Phi: MatrixLike, Q: MatrixLike, start: Moments, steps: int | sp.Symbol
) -> Moments:
    """Return mean and covariance of x_{i+1} = Phi x_i + q_i after some steps.

    Parameters
    ----------
    Phi : matrix_like, shape (n, n)
        Transition matrix. A StateSpace stands for Phi.
    Q : matrix_like, shape (n, n)
        Covariance of q_i, positive semidefinite.
    start : Moments
        Mean and covariance of x_0.
    steps : int or sympy.Symbol
        Number of steps, or for exact matrices a symbol k for the closed form in k.

    Returns
    -------
    Moments
        A closed form holds for k = 0, 1, 2, ... where its `where` does; an eigenvalue zero gives
        terms KroneckerDelta(k, j).

    Raises
    ------
    ValueError
        If shapes do not fit or Q is no covariance.
    NotImplementedError
        If the eigenvalues of a closed form need more than square roots.

    Notes
    -----
    Keywords of python-control: `A` for `Phi`.
    Source: (4.4), (4.5); problems 4.19, 4.20.

    Examples
    --------
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
    steps = read_exact_expression(steps, "steps")
    if steps.is_Integer and steps >= 0:
        transition, noise = _repeated(Phi, Q, int(steps))
        return trusted_moments(transition @ mean, symmetric(transition @ P @ transition.T + noise))
    if floats or steps.is_number:
        raise ValueError(
            f"steps: expected a whole number that is not negative{' or a symbol' * (not floats)}, "
            f"got {steps}"
        )
    return _closed_form(
        Phi, Q, mean, P, lambda X: Phi * X * Phi.T, 1, products, discrete_basis(steps)
    )


@accepts_state_space("A", time="continuous", instead="use discrete_moments")
def continuous_moments(A: MatrixLike, Q: MatrixLike, start: Moments, t: ScalarLike) -> Moments:
    """Return mean and covariance of x' = Ax + q after the time t.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system. A StateSpace stands for A.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    start : Moments
        Mean and covariance of x at the initial time.
    t : scalar_like
        Time since then, t >= 0, or for exact matrices a symbol for the closed form.

    Returns
    -------
    Moments
        With symbols in A a closed form holds where its `where` does; for the exceptional values
        substitute them into A and call again.

    Raises
    ------
    ValueError
        If shapes do not fit, Q is no covariance or t is negative.
    NotImplementedError
        If the eigenvalues of a closed form need more than square roots.

    Notes
    -----
    Zero and repeated eigenvalues are included. Source: (4.6), (4.7); problems 4.15 - 4.17, example
    5.

    Examples
    --------
    >>> import sympy as sp
    >>> from trajlib.estimation import Moments
    >>> t, Q, a, p = sp.symbols("t Q a p")
    >>> continuous_moments([[0, 1], [0, 0]], sp.diag(0, Q), Moments([0, 0], sp.zeros(2)), t).covariance   # example 5
    Matrix([
    [Q*t**3/3, Q*t**2/2],
    [Q*t**2/2,      Q*t]])
    >>> moments = continuous_moments(a, Q, Moments(0, p), t)
    >>> moments.covariance[0], moments.where
    (-Q/(2*a) + (Q + 2*a*p)*exp(2*a*t)/(2*a), Ne(a, 0))
    """
    A, Q, mean, P, floats = _read(A, Q, start, "A")
    t = read_duration(t, "t", floats)
    if floats:
        (transition,), (noise,) = discretise_steps(A, Q, [float(t)])
        return trusted_moments(transition @ mean, symmetric(transition @ P @ transition.T + noise))
    return _closed_form(A, Q, mean, P, lambda X: A * X + X * A.T, 0, sums, continuous_basis(t))


@accepts_state_space("A", time="continuous", instead="it is discretised already")
def discretise(A: MatrixLike, Q: MatrixLike, step: ScalarLike) -> DiscreteModel:
    """Return the exact discrete process of x' = Ax + q at the times 0, step, 2 step, ...

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system. A StateSpace stands for A.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    step : scalar_like
        Length of the step, not negative; for exact matrices also a symbol.

    Returns
    -------
    DiscreteModel
        Phi = e^{A step} and Q, the integral of e^{As} Q e^{A^T s} from 0 to step.

    Raises
    ------
    ValueError, NotImplementedError
        As for `continuous_moments`.

    Notes
    -----
    Exact for long steps, too. In floats a step for which the series converges at once is doubled
    repeatedly, so that Q stays positive semidefinite also for long steps of fast decaying
    processes. With an input: `discretise_with_input`. MATLAB: ``c2d``, ``lqrd``. Source: (4.4), (4.6), (4.7).

    Examples
    --------
    >>> import sympy as sp
    >>> h = sp.Symbol("h")
    >>> discretise([[0, 1], [0, 0]], [[0, 0], [0, 1]], h).Q
    Matrix([
    [h**3/3, h**2/2],
    [h**2/2,      h]])
    """
    floats = any_floats(A, Q)
    A = read_square(A, "A", floats)
    step = read_duration(step, "step", floats)
    if floats:
        Q = read_covariance(Q, "Q", A.shape[0], True)
        Phi, noise = discretise_steps(A, Q, [float(step)])
        return DiscreteModel(Phi[0], noise[0])
    n = A.rows
    moments = continuous_moments(A, Q, trusted_moments(sp.zeros(n, 1), sp.zeros(n)), step)
    return DiscreteModel(transition(A, step), moments.covariance)


@accepts_state_space("A", "B", time="continuous", instead="it is discretised already")
def discretise_with_input(
    A: MatrixLike, B: MatrixLike, Q: MatrixLike, step: ScalarLike
) -> DrivenModel:
    """Return the exact discrete process of x' = Ax + Bu + q for a u constant in each step.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system. A StateSpace stands for A and B: `discretise_with_input(sys, Q, step)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    step : scalar_like
        Length of the step, not negative; for exact matrices also a symbol.

    Returns
    -------
    DrivenModel
        Phi = e^{A step}, B, the integral of e^{As} B from 0 to step, and Q, that of e^{As} Q e^{A^T s}.

    Raises
    ------
    ValueError, NotImplementedError
        As for `continuous_moments`.

    Notes
    -----
    B is a block of the exponential of the system augmented by u' = 0 (C. F. van Loan, 1978). MATLAB:
    ``c2d`` with ``zoh``; python-control: ``sample_system``. Source: added to the problem book; (4.4),
    (4.6), (4.7).

    Examples
    --------
    >>> import sympy as sp
    >>> h = sp.Symbol("h")
    >>> discretise_with_input([[0, 1], [0, 0]], [[0], [1]], [[0, 0], [0, 1]], h).B.T
    Matrix([[h**2/2, h]])
    """
    floats = any_floats(A, B, Q)
    A = read_square(A, "A", floats)
    n = A.shape[0]
    B = read_matrix(B, "B", n, None, floats)
    Q = read_covariance(Q, "Q", n, floats)
    order = n + B.shape[1]
    # The input in units in which it is as fast as the system, so that it makes no step a long one.
    scale = (np.abs(A).max() or 1.0) / (np.abs(B).max() or 1.0) if floats else 1
    augmented, noise = np.zeros((2, order, order)) if floats else (sp.zeros(order), sp.zeros(order))
    augmented[:n, :n], augmented[:n, n:], noise[:n, :n] = A, scale * B, Q
    Phi, covariance = discretise(augmented, noise, step)
    return DrivenModel(Phi[:n, :n], Phi[:n, n:] / scale, covariance[:n, :n])


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
    """Return Phi^steps and the covariance that the noise contributes, by doubling."""
    transition, noise = identity_like(Phi), 0 * Q
    while steps:
        if steps % 2:
            transition, noise = Phi @ transition, symmetric(Phi @ noise @ Phi.T + Q)
        Phi, Q, steps = Phi @ Phi, symmetric(Phi @ Q @ Phi.T + Q), steps // 2
    return transition, noise


def _closed_form(A, Q, mean, P, operator, factor, pair_eigenvalues, basis):
    """Return mean and covariance as sums of modes.

    The constant `c` that drives P with cQ is one component more.
    """
    n = A.rows
    to_real, from_real = as_real(sp.Matrix.hstack(A, Q, P, mean))
    A_, Q_, mean_, P_ = (matrix.xreplace(to_real) for matrix in (A, Q, mean, P))

    def driven(X):
        c = X[n, n]
        return sp.diag(
            operator(X[:n, :n].xreplace(from_real)).xreplace(to_real) + c * Q_, factor * c
        )

    spectrum = exact_spectrum(A_)
    means = Modes(lambda v: A_ * v, spectrum, mean_)
    covariances = Modes(driven, [sp.Integer(factor), *pair_eigenvalues(spectrum)], sp.diag(P_, 1))
    mean = means.at(*basis) if means.terms else sp.zeros(n, 1)
    covariance = covariances.at(*basis)[:n, :n]
    return trusted_moments(
        mean.xreplace(from_real),
        covariance.xreplace(from_real),
        sp.And(means.where, covariances.where).xreplace(from_real),
    )


def transition(A, t):
    """Return e^{At}, exact."""
    to_real, from_real = as_real(A)
    A = A.xreplace(to_real)
    return (
        Modes(lambda X: A * X, exact_spectrum(A), sp.eye(A.rows))
        .at(*continuous_basis(t))
        .xreplace(from_real)
    )
