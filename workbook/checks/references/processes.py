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

from workbook.checks.references.fixed_modes import ON_BORDER, fixed_eigenvalues
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
    values = dict(values)
    start = (
        (process.mean, process.covariance) if start else (process.mean * 0, process.covariance * 0)
    )
    return [
        to_array(matrix, values) for matrix in (process.A, process.Q, process.H, process.R, *start)
    ]


@functools.lru_cache(maxsize=32)
def as_process(process):
    """Return a `Coloured` system or `FilterErrors` as a `Process`; a process as it is.

    Notes
    -----
    A correlation D exp(-a delay) belongs to the noise w' = -a w + q with the intensity 2 a D, from w(0)
    with the variance D; w is appended to x. The initial errors of a filter are those of the mean.
    """
    if isinstance(process, FilterErrors):
        one, gain = as_process(process.process), process.gain
        return Process(
            one.A - gain * one.H,
            one.Q + gain * one.R * gain.T,
            covariance=one.covariance,
            discrete=one.discrete,
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
        raise ValueError(f"the correlation {process.correlation} is not a single exponential")
    return D, a


def to_array(matrix, values):
    return np.array(sp.Matrix(matrix).subs(values).evalf(30).tolist(), dtype=float).reshape(
        matrix.shape
    )


def transition(one, duration):
    """Return (F, N): x(t + duration) = F x(t) + an independent vector of covariance N."""
    n = len(one.A)
    if one.discrete:
        powers = [np.linalg.matrix_power(one.A, k) for k in range(round(duration) + 1)]
        return powers[-1], sum((F @ one.Q @ F.T for F in powers[:-1]), np.zeros((n, n)))
    return _transition(one.A.tobytes(), one.Q.tobytes(), n, float(duration))


@functools.lru_cache(maxsize=256)
def _transition(A, Q, n, duration):
    """Return the same in continuous time, cached: its exponentials take most of the time."""
    from scipy.linalg import expm

    A, Q = (np.frombuffer(part).reshape(n, n) for part in (A, Q))
    # The linear equation of the n^2 entries of N, with 1 as one more: what decays stays small here.
    # The exponential of the block matrix of -A, Q and A^T (Van Loan 1978) grows with it and leaves
    # N few digits.
    sums = np.kron(A, np.eye(n)) + np.kron(np.eye(n), A)
    block = np.block([[sums, Q.reshape(-1, 1)], [np.zeros((1, n * n + 1))]])
    noise = expm(duration * block)[:-1, -1].reshape(n, n)
    found = expm(duration * A), (noise + noise.T) / 2
    for matrix in found:
        matrix.flags.writeable = False
    return found


def moments(one, time):
    """Return mean (n x 1) and covariance of x at a time."""
    F, N = transition(one, time)
    return F @ one.mean, F @ one.covariance @ F.T + N


def joint_moments(one, times):
    """Return mean and covariance of the states at several times, stacked."""
    n, found = len(one.A), [moments(one, time) for time in times]
    covariance = np.zeros((n * len(times), n * len(times)))
    for i, early in enumerate(times):
        for k, late in enumerate(times):
            if early <= late:
                block = transition(one, late - early)[0] @ found[i][1]
                covariance[k * n : (k + 1) * n, i * n : (i + 1) * n] = block
                covariance[i * n : (i + 1) * n, k * n : (k + 1) * n] = block.T
    return np.vstack([mean for mean, _ in found]), covariance


def conditional_moments(one, measured, at):
    """Return mean and covariance of x(at) given [(time, z), ...], z a list of numbers each."""
    n, m = len(one.A), len(one.H)
    if not measured:
        return moments(one, at)
    mean, covariance = joint_moments(one, [*(time for time, _ in measured), at])
    rows = np.kron(np.eye(len(measured)), one.H)
    rows = np.hstack([rows, np.zeros((m * len(measured), n))])
    noise = np.kron(np.eye(len(measured)), one.R)
    crossed = covariance[-n:] @ rows.T
    weights = np.linalg.solve(rows @ covariance @ rows.T + noise, crossed.T).T
    innovation = np.reshape([z for _, z in measured], (-1, 1)) - rows @ mean
    return mean[-n:] + weights @ innovation, covariance[-n:, -n:] - weights @ crossed.T


def stationary_covariance(one):
    """Return the covariance that x tends to from any initial covariance."""
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    return (
        solve_discrete_lyapunov(one.A, one.Q)
        if one.discrete
        else solve_continuous_lyapunov(one.A, -one.Q)
    )


def steady_covariances(one):
    """Return the error covariances of the steady filter before and after a measurement.

    In continuous time both are the same. Raises `numpy.linalg.LinAlgError` where there is no steady
    filter with decaying errors.
    """
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    solve = solve_discrete_are if one.discrete else solve_continuous_are
    found = solve(one.A.T, one.H.T, one.Q, one.R)
    for _ in range(2):  # Kleinman's iteration takes off the rounding of a pencil
        gain = filter_gain(one, found)
        found = error_covariance(one, (one.A @ gain if one.discrete else gain))
    return (
        (found, found - filter_gain(one, found) @ one.H @ found) if one.discrete else (found, found)
    )


def filter_gain(one, covariance):
    """Return the gain K of the best correction K (z - Hx) at this error covariance."""
    spread = one.H @ covariance @ one.H.T + one.R if one.discrete else one.R
    return np.linalg.solve(spread.T, one.H @ covariance.T).T


def error_covariance(one, gain):
    """Return the stationary covariance of the errors x - y of y' = A y + L (z - H y).

    In discrete time it is that of predictions.
    """
    loop = one.A - gain @ one.H
    largest = np.linalg.eigvals(loop)
    if (abs(largest).max() if one.discrete else 1 + largest.real.max()) >= 1 - 1e-12:
        raise np.linalg.LinAlgError("the errors do not decay")
    return stationary_covariance(replace(one, A=loop, Q=one.Q + gain @ one.R @ gain.T))


def steady_exists(process):
    """Return the `ReferenceCondition` that there is a steady filter whose errors decay.

    By the PBH test, for every number s = u + i w: the columns of s - A above H are independent unless s
    is that of a mode that decays, and those of s - A^T above Q unless it decays or grows.
    """
    u, w = sp.symbols("u w", real=True, cls=sp.Dummy)
    process = as_process(process)
    size = u**2 + w**2 - 1 if process.discrete else u
    hidden, quiet = (
        _dependent(u + sp.I * w, matrix, below)
        for matrix, below in ((process.A, process.H), (process.A.T, process.Q))
    )
    spoiled = sp.Or(sp.And(size >= 0, hidden), sp.And(sp.Eq(size, 0), quiet))

    def at(values):
        if not all(value.is_Rational for value in values.values()):
            return None
        one = process.subs(values)
        hidden, quiet = (
            np.concatenate(fixed_eigenvalues(pair_of(matrix, below)))
            for matrix, below in ((one.A, one.H), (one.A.T, one.Q))
        )
        rates = [abs(found) - 1 if process.discrete else found.real for found in (hidden, quiet)]
        return not ((rates[0] > -ON_BORDER).any() or (abs(rates[1]) < ON_BORDER).any())

    return ReferenceCondition(
        (Case(sp.Not(spoiled), (u, w), every=True),), (Case(spoiled, (u, w)),), at
    )


def _dependent(s, A, below):
    """Return the condition that the columns of s - A above a matrix are dependent."""
    pencil = (s * sp.eye(A.rows) - A).col_join(below)
    minors = (
        pencil.extract(list(rows), list(range(A.rows))).det(method="berkowitz")
        for rows in itertools.combinations(range(pencil.rows), A.rows)
    )
    return sp.And(*(sp.Eq(part, 0) for minor in minors for part in sp.expand(minor).as_real_imag()))
