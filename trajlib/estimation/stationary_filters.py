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

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance, read_noise
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.exact_or_float import latex, solve, symmetric
from trajlib.estimation.hypotheses import failed_hypothesis
from trajlib.estimation.riccati import Stabilising, continuous_hamiltonian, discrete_hamiltonian
from trajlib.estimation.riccati_floats import stabilising_solution
from trajlib.stability.regions import latex_condition
from trajlib.structure.rank_tests import controllability, observability
from trajlib.typesetting import escape_markdown


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
    residual : float or None
        For floats the norm of what is left of the Riccati equation beside the norms of the factors of
        its terms.
    error : float or None
        For floats an estimate of |dP|/|P|, the relative error of `covariance` in Frobenius norms, the
        greater of those in the given and in balanced units.
    """

    covariance: Matrix
    corrected: Matrix
    gain: Matrix
    errors: Matrix
    where: sp.Basic
    residual: float | None = None
    error: float | None = None
    # It takes longer than the filter.
    _explain: Callable[[], str] = field(default=str, repr=False, compare=False)

    def __bool__(self):
        return self.covariance is not None

    @cached_property
    def reason(self) -> str:
        """What kind of filter it is, or why there is none."""
        return self._explain()

    def _repr_markdown_(self):
        if not self:
            return escape_markdown(self.reason)
        parts = {"P": self.covariance, "P^+": self.corrected, "K": self.gain}
        shown = r",\quad ".join(
            f"{name} = {latex(part)}" for name, part in parts.items() if part is not None
        )
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle {shown}{where}$"


@accepts_state_space(
    "A", "H", time="continuous", instead="use discrete_stationary_filter", C="H", QN="Q", RN="R"
)
def stationary_filter(
    A: MatrixLike, H: MatrixLike, Q: MatrixLike, R: MatrixLike
) -> StationaryFilter:
    """Return the stationary filter of x' = Ax + q, z = Hx + r.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols, or floats. A StateSpace stands for A and H:
        `stationary_filter(sys, Q, R)`.
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
    numpy.linalg.LinAlgError
        If there is a filter, but the digits of floats did not suffice to find it.
    NotImplementedError
        If an exact spectrum needs more than square roots, which is possible for n > 2 only.

    Notes
    -----
    Keywords of python-control: `C`, `QN`, `RN` for `H`, `Q`, `R`. With a system its `lqe` takes QN for
    the noise of the inputs; here that is Q = B QN B^T.
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
    return _stationary(A, H, Q, R, "A", False)


@accepts_state_space(
    "Phi", "H", time="discrete", instead="use stationary_filter", A="Phi", C="H", QN="Q", RN="R"
)
def discrete_stationary_filter(
    Phi: MatrixLike, H: MatrixLike, Q: MatrixLike, R: MatrixLike
) -> StationaryFilter:
    """Return the stationary filter of x_{i+1} = Phi x_i + q_i, z_i = H x_i + r_i.

    Parameters
    ----------
    Phi : matrix_like, shape (n, n)
        Transition matrix, which may be singular. A StateSpace stands for Phi and H:
        `discrete_stationary_filter(sys, Q, R)`.
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
    ValueError, numpy.linalg.LinAlgError, NotImplementedError
        As for `stationary_filter`.

    Notes
    -----
    Keywords of python-control: `A`, `C`, `QN`, `RN` for `Phi`, `H`, `Q`, `R`. With a system its `dlqe`
    takes QN for the noise of the inputs; here that is Q = B QN B^T.
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
    return _stationary(Phi, H, Q, R, "Phi", True)


def _stationary(A, H, Q, R, name, discrete):
    floats = any_floats(A, H, Q, R)
    A = read_square(A, name, floats)
    n = A.shape[0]
    H = read_matrix(H, "H", None, n, floats)
    Q = read_covariance(Q, "Q", n, floats)
    return solve_filter(A, H, Q, read_noise(R, H.shape[0], floats), discrete)


def solve_filter(A, H, Q, R, discrete):
    """Return the stationary filter for matrices that are read already."""
    time = _Discrete if discrete else _Continuous
    solved = (_floats if isinstance(A, np.ndarray) else _exact)(A, H, Q, R, time)
    if isinstance(solved, str):
        reason = f"no stationary filter: {solved}"
        return StationaryFilter(None, None, None, None, sp.false, _explain=partial(str, reason))
    explain = partial(_kind, A, H, Q, solved[4])
    return StationaryFilter(*solved, _explain=explain)


def _exact(A, H, Q, R, time):
    """Return the fields of a `StationaryFilter`, or why there is none."""
    solution = Stabilising(time.hamiltonian(A, H, Q, R))
    if solution.P is not None:
        parts = time.parts(A, H, R, solution.P)
        return *(
            part if part is None else solution.in_given_symbols(part) for part in parts
        ), solution.where
    if reason := failed_hypothesis(A, H, Q, time.discrete):
        return reason
    raise NotImplementedError(
        "not found: there is a stationary filter, but its covariance could not be written down; "
        "give the matrices as arrays of floats"
    )


def _floats(A, H, Q, R, time):
    """Return the fields of a `StationaryFilter`, or why there is none."""
    solution = stabilising_solution(
        A, H, Q, R, time.discrete, True, partial(failed_hypothesis, A, H, Q, time.discrete)
    )
    if isinstance(solution, str):
        return solution
    P, gain, loop = solution.P, solution.gain, solution.loop
    corrected = _joseph(P, gain, H, R) if time.discrete else None
    return P, corrected, gain, loop, sp.true, solution.residual, solution.error


def _joseph(P, gain, H, R):
    """Return the covariance after the measurement, which rounding leaves positive."""
    reduction = np.eye(len(P)) - gain @ H
    return symmetric(reduction @ P @ reduction.T + gain @ R @ gain.T)


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


class _Continuous:
    discrete = False
    hamiltonian = staticmethod(continuous_hamiltonian)

    @staticmethod
    def parts(A, H, R, P):
        gain = solve(R, H @ P).T
        return P, None, gain, A - gain @ H


class _Discrete:
    discrete = True
    hamiltonian = staticmethod(discrete_hamiltonian)

    @staticmethod
    def parts(A, H, R, P):
        innovation_covariance = H * P * H.T + R
        # Cramer's rule: the entries have auxiliary symbols for roots, which no field of SymPy has.
        gain = P * H.T * innovation_covariance.adjugate() / innovation_covariance.det()
        reduction = sp.eye(P.rows) - gain * H
        return P, reduction * P, gain, A * reduction
