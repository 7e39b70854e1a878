"""Sample paths, and consistency of a filter's errors with its covariances.

Errors of the estimates and innovations, divided by their covariances, have squares that are
chi-squared if the model is right, so their means over independent paths lie in known limits.
Continuous processes are drawn by their exact discrete counterparts, so the length of the step does
not matter.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.arrays import read_finite_array
from trajlib._arguments.covariances import read_covariance, read_covariance_stack
from trajlib._arguments.matrices import read_matrix, read_square, read_vector
from trajlib._arguments.numbers import read_count, read_times
from trajlib._arguments.records import read_stack
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import ArrayLike
from trajlib.estimation.covariances import Moments
from trajlib.estimation.filter_run import FilterRun
from trajlib.estimation.markov import discretise


@dataclass(frozen=True, repr=False)
class Paths:
    """Sample paths: S paths of N steps.

    Attributes
    ----------
    times : ndarray, shape (N,)
        Times, or step numbers.
    states : ndarray, shape (S, N, n)
        States.
    measurements : ndarray or None, shape (S, N, m)
        Measurements, None if no H was given.
    """

    times: np.ndarray
    states: np.ndarray
    measurements: np.ndarray | None

    def __repr__(self):
        return f"Paths: {self.states.shape[0]} of {self.states.shape[1]} steps, {self.states.shape[2]} states"


@accepts_state_space("Phi", time="discrete", instead="use simulate_continuous", A="Phi")
def simulate_discrete(
    Phi: ArrayLike,
    Q: ArrayLike,
    start: Moments,
    steps: int,
    paths: int,
    seed: int,
    H: ArrayLike | None = None,
    R: ArrayLike | None = None,
) -> Paths:
    """Draw paths of x_{i+1} = Phi x_i + q_i with z_i = H x_i + r_i, all noises normal.

    Parameters
    ----------
    Phi : array_like, shape (n, n)
        Transition matrix. A StateSpace stands for Phi.
    Q : array_like, shape (n, n)
        Covariance of q_i, positive semidefinite.
    start : Moments
        Mean and covariance of x_0.
    steps : int
        Number N of states in a path.
    paths : int
        Number S of paths.
    seed : int
        Seed of the random numbers; the same seed gives the same paths.
    H : array_like, shape (m, n), optional
        Measurement matrix; left out, nothing is measured.
    R : array_like, shape (m, m), optional
        Covariance of r_i, positive semidefinite; needed with H.

    Returns
    -------
    Paths
        In floats.

    Raises
    ------
    ValueError
        If shapes do not fit or Q or R is no covariance.

    Notes
    -----
    Keywords of python-control: `A` for `Phi`.
    Source: Definition 4.12.

    Examples
    --------
    >>> from trajlib.estimation import Moments
    >>> drawn = simulate_discrete(0.5, 3, Moments(0, 4), 50, 2000, seed=1)
    >>> bool(abs(drawn.states.var() - 4) < 0.1)    # the process is stationary
    True
    """
    Phi = read_square(Phi, "Phi", True)
    Q = read_covariance(Q, "Q", len(Phi), True)
    steps, paths = read_count(steps, "steps", 1), read_count(paths, "paths", 1)
    return _draw(
        len(Phi),
        [Phi] * (steps - 1),
        [_square_root(Q)] * (steps - 1),
        start,
        np.arange(steps),
        paths,
        seed,
        H,
        R,
    )


@accepts_state_space("A", time="continuous", instead="use simulate_discrete")
def simulate_continuous(
    A: ArrayLike,
    Q: ArrayLike,
    start: Moments,
    times: ArrayLike,
    paths: int,
    seed: int,
    H: ArrayLike | None = None,
    R: ArrayLike | None = None,
) -> Paths:
    """Draw paths of x' = Ax + q at given times, with measurements z_i = H x(t_i) + r_i at each.

    Parameters
    ----------
    A : array_like, shape (n, n)
        Matrix of the system. A StateSpace stands for A.
    Q : array_like, shape (n, n)
        Intensity of q, positive semidefinite.
    start : Moments
        Mean and covariance of x at the first time.
    times : array_like, shape (N,)
        Times that do not decrease.
    paths : int
        Number S of paths.
    seed : int
        Seed of the random numbers.
    H : array_like, shape (m, n), optional
        Measurement matrix; left out, nothing is measured.
    R : array_like, shape (m, m), optional
        Covariance of r_i, positive semidefinite; needed with H.

    Returns
    -------
    Paths
        In floats, with the exact distribution at these times, however far apart they are.

    Raises
    ------
    ValueError
        If shapes do not fit, Q or R is no covariance, or times decrease.

    Notes
    -----
    Source: Definition 4.13.
    """
    A = read_square(A, "A", True)
    Q = read_covariance(Q, "Q", len(A), True)
    paths = read_count(paths, "paths", 1)
    times = read_times(times, repeated=None)
    steps = equal_steps(times)
    models = {step: discretise(A, Q, step) for step in np.unique(steps)}
    roots = {step: _square_root(model.Q) for step, model in models.items()}
    return _draw(
        len(A),
        [models[step].Phi for step in steps],
        [roots[step] for step in steps],
        start,
        times,
        paths,
        seed,
        H,
        R,
    )


def equal_steps(times):
    """Return the differences of times, equal where they differ by rounding only."""
    steps = np.diff(times)
    unit = np.abs(times).max(initial=0.0) * 1e-13 or 1.0
    return np.round(steps / unit) * unit


def _draw(n, Phis, roots, start, times, paths, seed, H, R):
    rng = np.random.default_rng(seed)
    P = read_covariance(start.covariance, "covariance", n, True)
    states = np.empty((paths, len(times), n))
    x = read_vector(start.mean, "mean", n, True) + rng.normal(size=(paths, n)) @ _square_root(P).T
    for k in range(len(times)):
        states[:, k] = x
        if k < len(Phis):
            x = x @ Phis[k].T + rng.normal(size=(paths, n)) @ roots[k].T
    measurements = None
    if H is not None:
        H = read_matrix(H, "H", None, n, True)
        R = read_covariance(R, "R", len(H), True)
        measurements = (
            states @ H.T + rng.normal(size=(paths, len(times), len(H))) @ _square_root(R).T
        )
    return Paths(times, states, measurements)


def _square_root(P):
    """Return a square root, also of a singular covariance."""
    values, vectors = np.linalg.eigh(P)
    return vectors * np.sqrt(np.maximum(values, 0))


@dataclass(frozen=True)
class Consistency:
    """Mean square of normalised errors with its limits; true in an `if` if it lies inside.

    Attributes
    ----------
    mean : float
        Mean of the squares.
    expected : float
        Its expectation for the right model.
    low, high : float
        Limits that it keeps with the probability `level` if the model is right.
    level : float
        This probability.
    """

    mean: float
    expected: float
    low: float
    high: float
    level: float

    def __bool__(self):
        return bool(self.low <= self.mean <= self.high)

    def _repr_markdown_(self):
        return (
            f"mean square {self.mean:.4g}, expected {self.expected:.4g}, within [{self.low:.4g}, "
            f"{self.high:.4g}] "
            f"with probability {self.level}: {'consistent' if self else 'not consistent'}"
        )


def innovation_consistency(run: FilterRun, level: float = 0.999) -> Consistency:
    """Test whether the innovations of a filter agree with their covariances (NIS test).

    Parameters
    ----------
    run : FilterRun
        Result of `KalmanFilter.run`.
    level : float
        Probability with which the right model passes.

    Returns
    -------
    Consistency
        For the mean over the steps.

    Notes
    -----
    For the right model the innovations are independent, and the sum of their normalised squares is
    chi-squared with as many degrees of freedom as numbers were measured.
    """
    return _consistency(
        run.normalised_innovations.sum(), int(run.measured.sum()), run.measured.size, level
    )


def covariance_consistency(
    errors: ArrayLike, covariance: ArrayLike, level: float = 0.999
) -> Consistency:
    """Test whether independent errors agree with a covariance (NEES test).

    Parameters
    ----------
    errors : array_like, shape (S, n)
        Errors of mean zero; of shape (S,) for one component.
    covariance : array_like, shape (n, n)
        One covariance for all, or one for each of shape (S, n, n).
    level : float
        Probability with which the right covariance passes.

    Returns
    -------
    Consistency
        For the mean of e^T P^-1 e.

    Raises
    ------
    ValueError
        If shapes do not fit.

    Examples
    --------
    >>> errors = np.random.default_rng(1).normal(size=(4000, 1))
    >>> bool(covariance_consistency(2*errors, [[4]])), bool(covariance_consistency(2*errors, [[3.6]]))
    (True, False)
    """
    errors = read_finite_array(errors, "errors", "numbers, one row an error")
    errors = errors[:, None] if errors.ndim == 1 else errors
    if errors.ndim != 2 or 0 in errors.shape:
        raise ValueError(f"errors: expected the shape (S, n) or (S,), got {errors.shape}")
    n = errors.shape[-1]
    P = read_stack(covariance, "covariance", n, n, read_covariance_stack)
    if P.ndim == 3 and len(P) != len(errors):
        raise ValueError(f"covariance: expected {len(errors)}, one for each error, got {len(P)}")
    squares = np.einsum(
        "si,si->s",
        errors,
        np.linalg.solve(np.broadcast_to(P, (len(errors), n, n)), errors[:, :, None])[:, :, 0],
    )
    return _consistency(squares.sum(), squares.size * n, squares.size, level)


def _consistency(total, freedom, count, level):
    from scipy.stats import chi2

    low, high = chi2.ppf([(1 - level) / 2, (1 + level) / 2], freedom)
    return Consistency(
        float(total / count), freedom / count, float(low / count), float(high / count), level
    )
