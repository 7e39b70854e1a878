"""Stationary Kalman filters, Theorems 4.2 and 4.4: the constant filter whose errors decay.

    A P + P A^T + Q - P H^T R^-1 H P = 0,                                          K = P H^T R^-1
    P = Phi P Phi^T + Q - Phi P H^T (H P H^T + R)^-1 H P Phi^T,   K = P H^T (H P H^T + R)^-1,   P+ = (E - KH) P

The stabilising solution is returned, for which the errors of the filter are asymptotically stable.
It exists if and only if (A, H) is detectable and the noise drives every mode on the border of
stability, and it is unique. The Kalman filter tends to it from every P(0) > 0. From a singular
P(0) >= 0 it does if the noise drives every growing mode; otherwise it may not: x_{i+1} = 2 x_i
without noise and with P(0) = 0 keeps K = 0, and its errors double in each step. Observability, and
controllability by the noise, which the theorems assume, are sufficient and make P positive definite.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._typing import Matrix, MatrixLike
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
    """Stationary filter; false in an `if` if there is none.

    Attributes
    ----------
    covariance : matrix or None, shape (n, n)
        Covariance of the error of the estimate: P in continuous time, P^- (before the measurement)
        in discrete time.
    corrected : matrix or None, shape (n, n)
        P^+ (after the measurement) in discrete time, None in continuous time.
    gain : matrix or None, shape (n, m)
        Gain K.
    errors : matrix or None, shape (n, n)
        Stable matrix of the error equations, A - KH or Phi (E - KH).
    where : sympy.Boolean
        Condition on symbols under which all this holds.
    reason : str
        What kind of filter it is, or why there is none.
    """

    covariance: Matrix
    corrected: Matrix
    gain: Matrix
    errors: Matrix
    where: sp.Basic
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


def stationary_filter(
    A: MatrixLike, H: MatrixLike, Q: MatrixLike, R: MatrixLike
) -> StationaryFilter:
    """Return the stationary filter of x' = Ax + q, z = Hx + r.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols, or floats.
    H : matrix_like, shape (m, n)
        Measurement matrix.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.
    R : matrix_like, shape (m, m)
        Intensity of r, positive definite.

    Returns
    -------
    StationaryFilter
        For general values of the symbols, with the condition under which it holds; for the values
        that `where` excludes, substitute them and call it again.

    Raises
    ------
    ValueError
        If shapes do not fit or Q or R is no covariance.
    NotImplementedError
        If an exact spectrum needs more than square roots, which is possible for n > 2 only.

    Notes
    -----
    MATLAB: ``lqe``, ``kalman``; python-control: ``lqe``. Source: Theorem 4.4, example 4, problems
    4.33 - 4.41.

    Examples
    --------
    >>> import sympy as sp
    >>> a, Q, R = sp.symbols("a Q R", positive=True)
    >>> stationary_filter(a, 1, Q, R).covariance[0]    # example 4
    sqrt(R)*sqrt(Q + R*a**2) + R*a
    >>> result = stationary_filter([[-1, 1], [0, 0]], [[1, 0]], sp.diag(0, sp.Rational(9, 4)), 1)    # problem 4.36
    >>> result.gain.T, result.errors
    (Matrix([[1, 3/2]]), Matrix([
    [  -2, 1],
    [-3/2, 0]]))
    >>> print(stationary_filter([[0, 1], [0, 0]], [[0, 1]], sp.diag(0, 1), 1).reason)
    no stationary filter: not detectable, a mode that does not decay is not measured
    """
    return _stationary(A, H, Q, R, "A", _Continuous)


def discrete_stationary_filter(
    Phi: MatrixLike, H: MatrixLike, Q: MatrixLike, R: MatrixLike
) -> StationaryFilter:
    """Return the stationary filter of x_{i+1} = Phi x_i + q_i, z_i = H x_i + r_i.

    Parameters
    ----------
    Phi : matrix_like, shape (n, n)
        Transition matrix, which may be singular.
    H : matrix_like, shape (m, n)
        Measurement matrix.
    Q : matrix_like, shape (n, n)
        Covariance of q_i, positive semidefinite.
    R : matrix_like, shape (m, m)
        Covariance of r_i, positive definite.

    Returns
    -------
    StationaryFilter
        As for `stationary_filter`.

    Raises
    ------
    ValueError, NotImplementedError
        As for `stationary_filter`.

    Notes
    -----
    The gain is that of the correction, x~+ = x~- + K (z - H x~-); the gain of the one-step
    predictor is Phi K. MATLAB: ``dlqe``; python-control: ``dlqe``. Source: Theorem 4.2, problems
    4.22 - 4.25.

    Examples
    --------
    >>> import sympy as sp
    >>> result = discrete_stationary_filter([[0, 1], [0, 1]], [[0, 1]], sp.diag(0, 2), 1)    # problem 4.22
    >>> result.covariance, result.gain.T
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
    solution = _floats(A, H, Q, R, time) if floats else _exact(A, H, Q, R, time)
    if solution is None:
        return StationaryFilter(None, None, None, None, sp.false, _reason_for_none(A, H, Q, time))
    return StationaryFilter(*solution, _kind(A, H, Q, solution[-1]))


def _exact(A, H, Q, R, time):
    solution = Stabilising(time.hamiltonian(A, H, Q, R))
    if solution.P is None:
        return None
    parts = time.parts(A, H, R, solution.P)
    return *(
        part if part is None else solution.in_given_symbols(part) for part in parts
    ), solution.where


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


def _kind(A, H, Q, where):
    observable, controllable = bool(observability(A, H)), bool(controllability(A, Q))
    kinds = {
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
    condition = "" if where == sp.true else f"; where {where}"
    return f"a stationary filter: {kinds[observable, controllable]}{condition}"


def _reason_for_none(A, H, Q, time):
    """Return the reason why there is no stationary filter.

    It comes from the PBH test, in floats, at the eigenvalues that do not decay.
    """
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
        innovation_covariance = H @ P @ H.T + R
        if isinstance(P, np.ndarray):
            gain = solve(innovation_covariance, H @ P).T
        else:
            # Cramer's rule: the entries have auxiliary symbols for roots, which no field of SymPy
            # has.
            gain = P * H.T * innovation_covariance.adjugate() / innovation_covariance.det()
        reduction = identity_like(P) - gain @ H
        corrected = (
            reduction @ P @ reduction.T + gain @ R @ gain.T
            if isinstance(P, np.ndarray)
            else reduction * P
        )
        return (
            P,
            symmetric(corrected) if isinstance(P, np.ndarray) else corrected,
            gain,
            A @ reduction,
        )

    @staticmethod
    def rate(matrix):
        return np.abs(np.linalg.eigvals(matrix)).max() - 1
