"""Linear random processes at numbers: their moments in time, and conditional on measurements.

Moments at any set of times come at once, from a matrix exponential, and measurements are taken all
together, by the conditional moments of a Gaussian vector: no covariance equation is integrated and
no filter is run. Steady filters come from the invariant subspaces of their Hamiltonian or
symplectic pencils (SciPy).
"""

import functools
import itertools
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData
from workbook.checks.references.fixed_modes import (
    ON_BORDER,
    fixed_eigenvalues,
    unobservable_eigenvalues_at,
)
from workbook.checks.references.invariant_subspaces import rank_falls
from workbook.checks.references.pairs import pair_of
from workbook.checks.tools.conditions import Case, ReferenceCondition
from workbook.systems import Coloured, FilterErrors, Process


@dataclass(frozen=True)
class NumericProcess:
    """A `Process` at values of its symbols: arrays of floats."""

    A: np.ndarray
    Q: np.ndarray
    H: np.ndarray
    R: np.ndarray
    mean: np.ndarray
    covariance: np.ndarray
    discrete: bool


def at_values(process, values, start=True):
    """Return the process at values of its symbols; without `start`, with zero initial moments."""
    process = as_process(process)
    arrays = _arrays(process, tuple(values.items()), start)
    return NumericProcess(*(part.copy() for part in arrays), process.discrete)


@functools.lru_cache(maxsize=256)
def _arrays(process, values, start):
    """Return the arrays of a process at values; every claim about it is tried at the same ones."""
    moments = [part if start else 0 * part for part in (process.mean, process.covariance)]
    matrices = process.A, process.Q, process.H, process.R, *moments
    return [to_array(matrix, dict(values)) for matrix in matrices]


@functools.lru_cache(maxsize=32)
def as_process(process):
    """Return a `Coloured` system or `FilterErrors` as a `Process`; a process as it is.

    Notes
    -----
    A correlation D exp(-a delay) belongs to the noise w' = -a w + q with the intensity 2 a D, from w(0)
    with the variance D; w is appended to x. The initial errors of a filter are those of the mean.
    """
    if isinstance(process, FilterErrors):
        measured, gain = as_process(process.process), process.gain
        return Process(
            measured.A - gain * measured.H,
            measured.Q + gain * measured.R * gain.T,
            covariance=measured.covariance,
            discrete=measured.discrete,
        )
    if not isinstance(process, Coloured):
        return process
    D, a = variance_and_rate(process)
    n = process.A.rows
    A, noise, start = (sp.zeros(n + 1) for _ in range(3))
    A[:n, :n], A[:n, n:], A[n, n] = process.A, process.B, -a
    noise[n, n], start[:n, :n], start[n, n] = 2 * a * D, process.covariance, D
    return Process(A, noise, process.H.row_join(process.C), process.R, 0, start)


def shape_of(name):
    """Return a function of the data: the shape of this matrix of the process among them."""
    return lambda data: getattr(as_process(data["process"]), name).shape


def variance_and_rate(process):
    """Return (D, a) of the correlation D exp(-a delay) of a `Coloured` process."""
    D = process.correlation.subs(process.delay, 0)
    a = sp.simplify(-process.correlation.diff(process.delay) / process.correlation)
    if a.has(process.delay):
        raise UnsuitableData(f"the correlation {process.correlation} is not a single exponential")
    return D, a


def to_array(matrix, values):
    return np.array(sp.Matrix(matrix).subs(values).evalf(30).tolist(), dtype=float).reshape(
        matrix.shape
    )


def transition(process, duration):
    """Return (F, N): x(t + duration) = F x(t) + an independent vector of covariance N."""
    n = len(process.A)
    if process.discrete:
        powers = [np.linalg.matrix_power(process.A, k) for k in range(round(duration) + 1)]
        return powers[-1], sum((F @ process.Q @ F.T for F in powers[:-1]), np.zeros((n, n)))
    return _transition(process.A.tobytes(), process.Q.tobytes(), n, float(duration))


@functools.lru_cache(maxsize=256)
def _transition(A, Q, n, duration):
    """Return (F, N) in continuous time, cached: the exponentials take most of the time."""
    from scipy.linalg import expm

    A, Q = (np.frombuffer(part).reshape(n, n) for part in (A, Q))
    # The linear equation of the n^2 entries of N, with 1 as one more: what decays stays small here.
    # The exponential of the block matrix of -A, Q and A^T (Van Loan 1978) grows with it and leaves
    # N few digits.
    sums = np.kron(A, np.eye(n)) + np.kron(np.eye(n), A)
    block = np.block([[sums, Q.reshape(-1, 1)], [np.zeros((1, n * n + 1))]])
    noise = expm(duration * block)[:-1, -1].reshape(n, n)
    matrices = expm(duration * A), (noise + noise.T) / 2
    for matrix in matrices:
        matrix.flags.writeable = False
    return matrices


def moments(process, time):
    """Return mean (n x 1) and covariance of x at a time."""
    F, N = transition(process, time)
    return F @ process.mean, F @ process.covariance @ F.T + N


def joint_moments(process, times):
    """Return mean and covariance of the states at several times, stacked."""
    means, covariances = zip(*(moments(process, time) for time in times))
    blocks = [[None] * len(times) for _ in times]
    for (i, start), (k, end) in itertools.product(enumerate(times), repeat=2):
        if start <= end:
            blocks[k][i] = transition(process, end - start)[0] @ covariances[i]
            blocks[i][k] = blocks[k][i].T
    return np.vstack(means), np.block(blocks)


def conditional_moments(process, measured, at):
    """Return mean and covariance of x(at) given [(time, z), ...], z a list of numbers each."""
    n, m = len(process.A), len(process.H)
    if not measured:
        return moments(process, at)
    mean, covariance = joint_moments(process, [*(time for time, _ in measured), at])
    rows = np.kron(np.eye(len(measured)), process.H)
    rows = np.hstack([rows, np.zeros((m * len(measured), n))])
    noise = np.kron(np.eye(len(measured)), process.R)
    crossed = covariance[-n:] @ rows.T
    weights = np.linalg.solve(rows @ covariance @ rows.T + noise, crossed.T).T
    innovation = np.reshape([z for _, z in measured], (-1, 1)) - rows @ mean
    return mean[-n:] + weights @ innovation, covariance[-n:, -n:] - weights @ crossed.T


def stationary_covariance(process):
    """Return the covariance that x tends to from any initial covariance."""
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    if process.discrete:
        return solve_discrete_lyapunov(process.A, process.Q)
    return solve_continuous_lyapunov(process.A, -process.Q)


def steady_covariances(process):
    """Return the error covariances of the steady filter before and after a measurement.

    In continuous time both are the same. Raises `numpy.linalg.LinAlgError` where there is no steady
    filter with decaying errors.
    """
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    solve = solve_discrete_are if process.discrete else solve_continuous_are
    covariance = solve(process.A.T, process.H.T, process.Q, process.R)
    for _ in range(2):  # Kleinman's iteration takes off the rounding of a pencil
        gain = filter_gain(process, covariance)
        covariance = error_covariance(process, (process.A @ gain if process.discrete else gain))
    if not process.discrete:
        return covariance, covariance
    return covariance, covariance - filter_gain(process, covariance) @ process.H @ covariance


def filter_gain(process, covariance):
    """Return the gain K of the best correction K (z - Hx) at this error covariance."""
    innovation_covariance = (
        process.H @ covariance @ process.H.T + process.R if process.discrete else process.R
    )
    return np.linalg.solve(innovation_covariance.T, process.H @ covariance.T).T


def changes_covariance(process, covariance, after):
    """Return whether the Riccati equation changes an error covariance, in discrete time in one step.

    With `after`, in discrete time, the covariance is that after a measurement. Raises
    `numpy.linalg.LinAlgError` where exact measurements leave no gain.
    """
    A, H, Q = process.A, process.H, process.Q

    def updated(P):
        return P - filter_gain(process, P) @ H @ P

    if not process.discrete:
        terms = A @ covariance, covariance @ A.T, Q, updated(covariance) - covariance
    else:
        new = updated(A @ covariance @ A.T + Q) if after else A @ updated(covariance) @ A.T + Q
        terms = new, -covariance
    return abs(sum(terms)).max() > 1e-9 * sum(map(abs, terms)).max()


def error_covariance(process, gain):
    """Return the stationary covariance of the errors x - y of y' = A y + L (z - H y).

    In discrete time it is that of predictions.
    """
    loop = process.A - gain @ process.H
    largest = np.linalg.eigvals(loop)
    if (abs(largest).max() if process.discrete else 1 + largest.real.max()) >= 1 - 1e-12:
        raise np.linalg.LinAlgError("the errors do not decay")
    return stationary_covariance(replace(process, A=loop, Q=process.Q + gain @ process.R @ gain.T))


def steady_exists(process):
    """Return the `ReferenceCondition` that there is a steady filter whose errors decay.

    By the PBH test, for every number s = u + i w: the columns of s - A above H are independent unless s
    is that of a mode that decays, and those of s - A^T above Q unless it decays or grows.
    """
    u, w = sp.symbols("u w", real=True, cls=sp.Dummy)
    process = as_process(process)
    size = u**2 + w**2 - 1 if process.discrete else u
    pairs = (process.A, process.H), (process.A.T, process.Q)
    unobservable, uncontrollable = (rank_falls(u + sp.I * w, *pair) for pair in pairs)
    none_exists = sp.Or(sp.And(size >= 0, unobservable), sp.And(sp.Eq(size, 0), uncontrollable))

    def at(values):

        if all(value.is_Rational for value in values.values()):
            fixed = [
                np.concatenate(fixed_eigenvalues(pair_of(*(part.subs(values) for part in pair))))
                for pair in pairs
            ]
        elif all(value.is_algebraic for value in values.values()):
            fixed = [unobservable_eigenvalues_at(*pair, values) for pair in pairs]
        else:
            return None
        rates = [abs(roots) - 1 if process.discrete else roots.real for roots in fixed]
        return not ((rates[0] > -ON_BORDER).any() or (abs(rates[1]) < ON_BORDER).any())

    return ReferenceCondition(
        (Case(sp.Not(none_exists), (u, w), every=True),), (Case(none_exists, (u, w)),), at
    )
