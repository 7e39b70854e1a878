"""Stationary covariances: the limits of P(t) and P_i, where they exist.

The limit solves A P + P A^T + Q = 0, or P = Phi P Phi^T + Q. These equations also have solutions
that are no limits (indefinite ones for an unstable A), so stability is decided first.
"""

from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_square
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.exact_or_float import latex, solve, symmetric
from trajlib.stability.jury import jury_conditions
from trajlib.stability.regions import latex_condition, stability_conditions
from trajlib.typesetting import escape_markdown


@dataclass(frozen=True)
class StationaryCovariance:
    """Limit of the covariance for every initial covariance; false in an `if` if there is none.

    Attributes
    ----------
    covariance : matrix or None, shape (n, n)
        The limit, None if there is none.
    where : sympy.Boolean
        Condition on symbols under which it exists.
    reason : str
        Explanation in words.
    """

    covariance: Matrix
    where: sp.Basic
    reason: str

    def __bool__(self):
        return self.covariance is not None

    def _repr_markdown_(self):
        if not self:
            return escape_markdown(self.reason)
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle P_\infty = {latex(self.covariance)}{where}$"


@accepts_state_space("A", time="continuous", instead="use discrete_stationary_covariance")
def stationary_covariance(A: MatrixLike, Q: MatrixLike) -> StationaryCovariance:
    """Return the limit of the covariance of x' = Ax + q.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols, or floats. A StateSpace stands for A.
    Q : matrix_like, shape (n, n)
        Intensity of q, positive semidefinite.

    Returns
    -------
    StationaryCovariance
        False unless A is asymptotically stable; with symbols it has the condition for that.

    Raises
    ------
    ValueError
        If shapes do not fit or Q is no covariance.

    Notes
    -----
    MATLAB: ``lyap``, ``covar``. Source: (4.7); problem 4.18.

    Examples
    --------
    >>> import sympy as sp
    >>> stationary_covariance([[0, 1], [-6, -5]], sp.diag(0, 1)).covariance    # problem 4.18
    Matrix([
    [1/60,    0],
    [   0, 1/10]])
    >>> a = sp.Symbol("a")
    >>> limit = stationary_covariance(a, 1)
    >>> limit.covariance[0], limit.where
    (-1/(2*a), a < 0)
    >>> bool(stationary_covariance([[0, 1], [-1, 0]], sp.diag(0, 1)))
    False
    """
    return _limit(A, Q, "A", _Continuous)


@accepts_state_space("Phi", time="discrete", instead="use stationary_covariance", A="Phi")
def discrete_stationary_covariance(Phi: MatrixLike, Q: MatrixLike) -> StationaryCovariance:
    """Return the limit of the covariance of x_{i+1} = Phi x_i + q_i.

    Parameters
    ----------
    Phi : matrix_like, shape (n, n)
        Transition matrix; exact, also with symbols, or floats. A StateSpace stands for Phi.
    Q : matrix_like, shape (n, n)
        Covariance of q_i, positive semidefinite.

    Returns
    -------
    StationaryCovariance
        False unless all eigenvalues of Phi have moduli below 1.

    Raises
    ------
    ValueError
        If shapes do not fit or Q is no covariance.

    Notes
    -----
    Keywords of python-control: `A` for `Phi`.
    MATLAB: ``dlyap``. Source: (4.5); problems 4.20, 4.21.

    Examples
    --------
    >>> import sympy as sp
    >>> discrete_stationary_covariance([[1, sp.Rational(1, 2)], [-sp.Rational(1, 2), 0]], sp.diag(0, 1)).covariance
    Matrix([
    [20/27, -8/27],
    [-8/27, 32/27]])
    """
    return _limit(Phi, Q, "Phi", _Discrete)


def _limit(A, Q, name, time):
    floats = any_floats(A, Q)
    A = read_square(A, name, floats)
    Q = read_covariance(Q, "Q", A.shape[0], floats)
    where, reason = time.stable(A)
    if where == sp.false:
        return StationaryCovariance(None, sp.false, f"no stationary covariance: {reason}")
    P = time.solve_floats(A, Q) if floats else _solved(time.operator(A), Q)
    condition = "" if where == sp.true else f" where {where}"
    return StationaryCovariance(symmetric(P), where, f"there is a stationary covariance{condition}")


def _solved(operator, Q):
    """Return the symmetric P with operator(P) = -Q, by a linear system for its lower triangle."""
    n = Q.rows
    lower = [(i, j) for i in range(n) for j in range(i + 1)]
    columns = []
    for i, j in lower:
        unit = sp.zeros(n)
        unit[i, j] = unit[j, i] = 1
        image = operator(unit)
        columns.append(sp.Matrix([image[position] for position in lower]))
    solution = solve(sp.Matrix.hstack(*columns), -sp.Matrix([Q[position] for position in lower]))
    P = sp.zeros(n)
    for (i, j), entry in zip(lower, solution):
        P[i, j] = P[j, i] = entry
    return P


class _Continuous:
    @staticmethod
    def stable(A):
        if isinstance(A, np.ndarray):
            greatest = np.linalg.eigvals(A).real.max()
            limit = -100 * len(A) * np.finfo(float).eps * np.linalg.norm(A, 2)
            return sp.sympify(
                bool(greatest < limit)
            ), f"a mode does not decay, its rate is {greatest:.3g}"
        return (
            stability_conditions(A, sorted(A.free_symbols, key=str)).region,
            "a mode does not decay, an eigenvalue of A has no negative real part",
        )

    @staticmethod
    def operator(A):
        return lambda P: A * P + P * A.T

    @staticmethod
    def solve_floats(A, Q):
        from scipy.linalg import solve_continuous_lyapunov

        return solve_continuous_lyapunov(A, -Q)


class _Discrete:
    @staticmethod
    def stable(A):
        if isinstance(A, np.ndarray):
            greatest = np.abs(np.linalg.eigvals(A)).max()
            limit = 1 - 100 * len(A) * np.finfo(float).eps * max(np.linalg.norm(A, 2), 1)
            reason = f"a mode does not decay, its factor has the modulus {greatest:.6g}"
            return sp.sympify(bool(greatest < limit)), reason
        return (
            jury_conditions(A, sorted(A.free_symbols, key=str)).region,
            "a mode does not decay, an eigenvalue of Phi has no modulus below 1",
        )

    @staticmethod
    def operator(A):
        return lambda P: A * P * A.T - P

    @staticmethod
    def solve_floats(A, Q):
        from scipy.linalg import solve_discrete_lyapunov

        return solve_discrete_lyapunov(A, Q)
