"""Sample paths, and whether a filter's errors are as large as it says.

Errors of the estimates and innovations, divided by their covariances, have squares that are
chi-squared if the model is right; their means over independent paths lie in known limits.
Continuous processes are drawn by their exact discrete counterparts, so that the length of the step
does not matter.
"""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import read_matrix, read_square, read_vector
from trajlib.estimation.markov import discretised


@dataclass(frozen=True, repr=False)
class Paths:
    """Drawn paths: `times`: N; `states`: S x N x n; `measurements`: S x N x m, None if no H was
    given."""

    times: np.ndarray
    states: np.ndarray
    measurements: object

    def __repr__(self):
        return f"Paths: {self.states.shape[0]} of {self.states.shape[1]} steps, {self.states.shape[2]} states"


def simulate_discrete(Phi, Q, start, steps, paths, seed, H=None, R=None):
    """Paths of x_{i+1} = Phi x_i + q_i with z_i = H x_i + r_i, all noises normal.

    `Phi`, `Q`: n x n; `start`: `Moments` of x_0; `steps` and `paths`: N and S; `seed`: a whole
    number, the same for the same paths; `H`: m x n and `R`: m x m, positive semidefinite, for
    measurements. In floats. Returns `Paths`. Raises ValueError for shapes that do not fit and
    covariances that are none. Source: Definition 4.12.

    >>> from trajlib.estimation import Moments
    >>> drawn = simulate_discrete(0.5, 3, Moments(0, 4), 50, 2000, seed=1)
    >>> bool(abs(drawn.states.var() - 4) < 0.1)    # the process is stationary
    True
    """
    Phi = read_square(np.asarray(Phi, dtype=float), "Phi", True)
    Q = read_covariance(np.asarray(Q, dtype=float), "Q", len(Phi), True)
    return _drawn(
        [Phi] * (steps - 1), [_root(Q)] * (steps - 1), start, np.arange(steps), paths, seed, H, R
    )


def simulate_continuous(A, Q, start, times, paths, seed, H=None, R=None):
    """Paths of x' = Ax + q at the given times, with measurements z_i = H x(t_i) + r_i at each of
    them.

    `A`: n x n; `Q`: n x n, the intensity of q; `start`: `Moments` at the first time; `times`: N
    rising numbers; the rest as for `simulate_discrete`. The paths have the exact distribution at
    these times, whatever their distances. Returns `Paths`. Source: Definition 4.13.
    """
    A = read_square(np.asarray(A, dtype=float), "A", True)
    Q = read_covariance(np.asarray(Q, dtype=float), "Q", len(A), True)
    times = read_vector(np.asarray(times, dtype=float), "times", None, True)
    if (np.diff(times) < 0).any():
        raise ValueError("times: expected rising numbers")
    steps = equal_steps(times)
    models = {step: discretised(A, Q, step) for step in np.unique(steps)}
    roots = {step: _root(model.Q) for step, model in models.items()}
    return _drawn(
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
    """The differences of times; those that differ by rounding alone are equal."""
    steps = np.diff(times)
    unit = np.abs(times).max(initial=0.0) * 1e-13 or 1.0
    return np.round(steps / unit) * unit


def _drawn(Phis, roots, start, times, paths, seed, H, R):
    rng = np.random.default_rng(seed)
    n = start.covariance.shape[0]
    P = read_covariance(start.covariance, "covariance", n, True)
    states = np.empty((paths, len(times), n))
    x = read_vector(start.mean, "mean", n, True) + rng.normal(size=(paths, n)) @ _root(P).T
    for k in range(len(times)):
        states[:, k] = x
        if k < len(Phis):
            x = x @ Phis[k].T + rng.normal(size=(paths, n)) @ roots[k].T
    measurements = None
    if H is not None:
        H = read_matrix(np.asarray(H, dtype=float), "H", None, n, True)
        R = read_covariance(np.asarray(R, dtype=float), "R", len(H), True)
        measurements = states @ H.T + rng.normal(size=(paths, len(times), len(H))) @ _root(R).T
    return Paths(times, states, measurements)


def _root(P):
    """A square root, also of a singular covariance."""
    values, vectors = np.linalg.eigh(P)
    return vectors * np.sqrt(np.maximum(values, 0))


@dataclass(frozen=True)
class Consistency:
    """Whether squares of normalised errors are as large as they should be; true in an `if` if their
    mean lies inside.

    `mean`: of the squares; `expected`: what it should be; `low`, `high`: limits that it keeps with
    the probability `level` if the model is right.
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


def innovation_consistency(run, level=0.999):
    """Are the innovations of a `FilterRun` as large as their covariances say? (NIS test.)

    For the right model they are independent, and the sum of their normalised squares is chi-squared
    with as many degrees of freedom as numbers were measured. Returns `Consistency` for the mean a
    step.
    """
    return _consistency(
        run.normalised_innovations.sum(), int(run.measured.sum()), run.measured.size, level
    )


def error_consistency(run, states, level=0.999):
    """Are the errors of a `FilterRun` as large as its covariances say? (NEES test, over independent
    paths.)

    `run`: of S series; `states`: S x N x n, the true ones. Errors of one path depend on one
    another, so the last step alone is judged. Returns `Consistency` for the mean a path. Raises
    ValueError if there is one series.
    """
    states = np.asarray(states, dtype=float)
    if run.estimates.ndim != 3 or states.shape != run.estimates.shape:
        raise ValueError(
            f"states: expected several series and the shape {run.estimates.shape}, got "
            f"{states.shape}"
        )
    return covariance_consistency(
        (run.estimates - states)[:, -1], run._steps[1][run.kinds[:, -1]], level
    )


def covariance_consistency(errors, covariance, level=0.999):
    """Are independent errors as large as a covariance says? (NEES test.)

    `errors`: S x n, or S for one component, of mean zero; `covariance`: n x n, one for all or one
    for each, S x n x n. Returns `Consistency` for the mean of e^T P^-1 e. Raises ValueError for
    shapes that do not fit.

    >>> errors = np.random.default_rng(1).normal(size=(4000, 1))
    >>> bool(covariance_consistency(2*errors, [[4]])), bool(covariance_consistency(2*errors, [[3.6]]))
    (True, False)
    """
    errors, P = np.asarray(errors, dtype=float), np.asarray(covariance, dtype=float)
    errors = errors[:, None] if errors.ndim == 1 else errors
    n = errors.shape[-1]
    if errors.ndim != 2 or P.shape not in ((n, n), (len(errors), n, n)):
        raise ValueError(
            f"covariance: expected {n} x {n}, or as many of these as errors, got the shape "
            f"{P.shape}"
        )
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
