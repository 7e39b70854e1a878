"""Stationary Kalman filters, Theorems 4.2 and 4.4: the gain to which the filter tends after a long
time.

    A P + P A^T + Q - P H^T R^-1 H P = 0,                                          K = P H^T R^-1
    P = Phi P Phi^T + Q - Phi P H^T (H P H^T + R)^-1 H P Phi^T,   K = P H^T (H P H^T + R)^-1,   P+ = (E - KH) P

Of the solutions the one is taken that makes the errors of the filter asymptotically stable. It
exists if and only if (A, H) is detectable and no mode on the border of stability is free of noise;
observability and controllability by the noise, which the theorems ask for, are enough for it and
make P positive definite.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib.estimation.exact_or_float import identity_like, latex, solve, symmetric
from trajlib.estimation.riccati import Stabilising, continuous_hamiltonian, discrete_hamiltonian
from trajlib.stability.regions import latex_condition
from trajlib.structure.rank_tests import controllability, observability
from trajlib.typesetting import escape_markdown

#: Errors that decay by less than this share of the size of the matrix count as not decaying, in
#: floats.
BORDER = 1e-9


@dataclass(frozen=True)
class StationaryFilter:
    """A stationary filter; false in an `if` if there is none.

    - `covariance`: n x n, of the error of the estimate: P in continuous time; in discrete time P^-,
      before the measurement, and `corrected` is P^+, after it (None in continuous time);
    - `gain`: K, n x m; `errors`: n x n, the matrix of the errors, A - KH or Phi (E - KH), whose
      modes decay;
    - `where`: the condition on symbols under which all this holds; `reason`: what there is, or why
      there is nothing.
    """

    covariance: object
    corrected: object
    gain: object
    errors: object
    where: object
    reason: str

    def __bool__(self):
        return self.covariance is not None

    def _repr_markdown_(self):
        if not self:
            return escape_markdown(self.reason)
        parts = {"P": self.covariance, "P^+": self.corrected, "K": self.gain}
        shown = r",\quad ".join(
            f"{name} = {latex(part)}" for name, part in parts.items() if part is not None
        )
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle {shown}{where}$"


def stationary_filter(A, H, Q, R):
    """The stationary filter of x' = Ax + q, z = Hx + r (MATLAB: lqe, kalman; python-control: lqe).

    `A`: n x n; `H`: m x n; `Q`: n x n, the intensity of q, positive semidefinite; `R`: m x m, that
    of r, positive definite. Exact, also with symbols, or floats. Exact results are found for those
    spectra that square roots can express, always for n <= 2. Returns `StationaryFilter`, for
    general values of the symbols, with the condition under which it holds: at the values that
    `where` excludes substitute them and ask again. Raises ValueError for shapes and covariances
    that are none, NotImplementedError for exact spectra beyond square roots. Source: Theorem 4.4,
    example 4, problems 4.33 - 4.41.

    >>> import sympy as sp
    >>> a, Q, R = sp.symbols("a Q R", positive=True)
    >>> stationary_filter(a, 1, Q, R).covariance[0]    # example 4
    sqrt(R)*sqrt(Q + R*a**2) + R*a
    >>> found = stationary_filter([[-1, 1], [0, 0]], [[1, 0]], sp.diag(0, sp.Rational(9, 4)), 1)    # problem 4.36
    >>> found.gain.T, found.errors
    (Matrix([[1, 3/2]]), Matrix([
    [  -2, 1],
    [-3/2, 0]]))
    >>> print(stationary_filter([[0, 1], [0, 0]], [[0, 1]], sp.diag(0, 1), 1).reason)
    no stationary filter: not detectable, a mode that does not decay is not measured
    """
    return _stationary(A, H, Q, R, "A", _Continuous)


def discrete_stationary_filter(Phi, H, Q, R):
    """The stationary filter of x_{i+1} = Phi x_i + q_i, z_i = H x_i + r_i (MATLAB: dlqe;
    python-control: dlqe).

    `Phi`: n x n, also singular; `H`: m x n; `Q`, `R`: covariances of q_i and r_i. The gain is that
    of the correction, x~+ = x~- + K (z - H x~-); the gain of the one-step predictor is Phi K.
    Returns and raises as `stationary_filter`. Source: Theorem 4.2, problems 4.22 - 4.25.

    >>> import sympy as sp
    >>> found = discrete_stationary_filter([[0, 1], [0, 1]], [[0, 1]], sp.diag(0, 2), 1)    # problem 4.22
    >>> found.covariance, found.gain.T
    (Matrix([
    [-1 + sqrt(3), -1 + sqrt(3)],
    [-1 + sqrt(3),  1 + sqrt(3)]]), Matrix([[-5 + 3*sqrt(3), -1 + sqrt(3)]]))
    """
    return _stationary(Phi, H, Q, R, "Phi", _Discrete)


def _stationary(A, H, Q, R, name, time):
    floats = any_floats(A, H, Q, R)
    A = read_square(A, name, floats)
    n = A.shape[0]
    H = read_matrix(H, "H", None, n, floats)
    Q = read_covariance(Q, "Q", n, floats)
    R = read_covariance(R, "R", H.shape[0], floats, definite=True)
    found = _floats(A, H, Q, R, time) if floats else _exact(A, H, Q, R, time)
    if found is None:
        return StationaryFilter(None, None, None, None, sp.false, _why_none(A, H, Q, time))
    return StationaryFilter(*found, _which(A, H, Q, found[-1]))


def _exact(A, H, Q, R, time):
    solution = Stabilising(time.hamiltonian(A, H, Q, R))
    if solution.P is None:
        return None
    parts = time.parts(A, H, R, solution.P)
    return *(part if part is None else solution.finished(part) for part in parts), solution.where


def _floats(A, H, Q, R, time):
    try:
        P = symmetric(time.solve_floats(A, H, Q, R))
    except (np.linalg.LinAlgError, ValueError):
        return None
    parts = time.parts(A, H, R, P)
    return (
        (*parts, sp.true)
        if np.isfinite(P).all() and time.rate(parts[3]) < -BORDER * max(1, np.linalg.norm(A, 2))
        else None
    )


def _which(A, H, Q, where):
    seen, driven = bool(observability(A, H)), bool(controllability(A, Q))
    told = {
        (
            True,
            True,
        ): "observable and driven by noise in all modes: P is positive definite, and it is the limit "
        "from every beginning",
        (False, True): "detectable, not observable; driven by noise in all modes",
        (True, False): "observable; not all modes are driven by noise, so P may be singular",
        (
            False,
            False,
        ): "detectable, not observable; not all modes are driven by noise, so P may be singular",
    }
    general = "" if where == sp.true else f"; where {where}"
    return f"a stationary filter: {told[seen, driven]}{general}"


def _why_none(A, H, Q, time):
    """Popov's criterion at the eigenvalues that do not decay, in floats; only the words depend on
    it."""
    if not isinstance(A, np.ndarray):
        if (A.free_symbols | H.free_symbols | Q.free_symbols) or not A.is_Matrix:
            return (
                "no stationary filter, for general values of the symbols: the pair is not "
                "detectable, or a mode on the border of stability is free of noise"
            )
        A, H, Q = (np.array(matrix.evalf(30).tolist(), dtype=float) for matrix in (A, H, Q))
    size = max(1, np.linalg.norm(A, 2))
    for value in np.linalg.eigvals(A):
        if time.rate(np.array([[value]])) < -1e-6 * size:
            continue
        pencil = A - value * np.eye(len(A))
        if np.linalg.svd(np.vstack([pencil, H]), compute_uv=False)[-1] < 1e-6 * size:
            return (
                "no stationary filter: not detectable, a mode that does not decay is not measured"
            )
    return (
        "no stationary filter: a mode on the border of stability is free of noise, so that its "
        "gain tends to zero and its errors do not decay with it"
    )


class _Continuous:
    hamiltonian = staticmethod(continuous_hamiltonian)

    @staticmethod
    def solve_floats(A, H, Q, R):
        from scipy.linalg import solve_continuous_are

        return solve_continuous_are(A.T, H.T, Q, R)

    @staticmethod
    def parts(A, H, R, P):
        gain = solve(R, H @ P).T
        return P, None, gain, A - gain @ H

    @staticmethod
    def rate(matrix):
        return np.linalg.eigvals(matrix).real.max()


class _Discrete:
    hamiltonian = staticmethod(discrete_hamiltonian)

    @staticmethod
    def solve_floats(A, H, Q, R):
        from scipy.linalg import solve_discrete_are

        return solve_discrete_are(A.T, H.T, Q, R)

    @staticmethod
    def parts(A, H, R, P):
        spread = H @ P @ H.T + R
        if isinstance(P, np.ndarray):
            gain = solve(spread, H @ P).T
        else:
            # The entries stand in auxiliary symbols for roots, which no field knows: Cramer's rule.
            gain = P * H.T * spread.adjugate() / spread.det()
        kept = identity_like(P) - gain @ H
        after = kept @ P @ kept.T + gain @ R @ gain.T if isinstance(P, np.ndarray) else kept * P
        return P, symmetric(after) if isinstance(P, np.ndarray) else after, gain, A @ kept

    @staticmethod
    def rate(matrix):
        return np.abs(np.linalg.eigvals(matrix)).max() - 1
