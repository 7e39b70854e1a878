"""Linear-quadratic-Gaussian (LQG) control: a regulator that is fed by a stationary filter.

For x' = Ax + Bu + q, z = Hx + r the feedback of least mean cost lim E[x^T G x + u^T N u] is u = Ke with
the gain K of the regulator for a known state and the estimate e of the filter (separation theorem):

    e' = A e + B u + L (z - H e),    cost = tr(SQ) + tr(P K^T N K).

In discrete time the control uses the estimate after the measurement of the same step,

    u_i = K e_i^+,   e_i^+ = e_i + L (z_i - H e_i),   e_{i+1} = (A + BK) e_i^+,
    cost = tr(SQ) + tr(P^+ K^T (N + B^T S B) K).
"""

from dataclasses import dataclass, field

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import read_covariance
from trajlib._arguments.matrices import any_floats, read_matrix
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import Matrix, MatrixLike
from trajlib.estimation.exact_or_float import identity_like, tidy
from trajlib.estimation.stationary_filters import (
    StationaryFilter,
    discrete_stationary_filter,
    stationary_filter,
)
from trajlib.feedback.discrete_cost import discrete_lqr
from trajlib.feedback.keywords import reads_keywords
from trajlib.feedback.quadratic_cost import QuadraticRegulator, lqr, read_regulator

reads_noises = reads_keywords("QN", "RN", Q="G", R="N", QN="Q", RN="R")


@dataclass(frozen=True)
class StochasticRegulator:
    """The optimal feedback by a measurement with noise; false in an `if` if there is none.

    As a system from z to u it is `controller`.

    Attributes
    ----------
    regulator : QuadraticRegulator
        The regulator for a known state, with the gain K.
    filter : StationaryFilter
        The filter without control, with the gain L and the covariance P of x - e (separation theorem).
    matrices : tuple of matrix
        (F, M, K, D) of the controller e' = F e + M z, u = K e + D z, exact where the rest is: F = A + BK - LH,
        M = L and D = 0, in discrete time (A + BK)(E - LH), (A + BK) L, K (E - LH) and K L. Empty if there
        is no feedback.
    cost : sympy.Expr or float
        lim E[x^T G x + u^T N u]; None if there is no feedback.
    cost_of_known_state : sympy.Expr or float
        The first term, tr(SQ): the cost with noise if the state is known.
    """

    regulator: QuadraticRegulator
    filter: StationaryFilter
    matrices: tuple[Matrix, ...]
    cost: sp.Expr | float | None
    cost_of_known_state: sp.Expr | float | None
    _dt: bool = field(default=False, repr=False)

    def __bool__(self):
        return self.cost is not None

    @property
    def controller(self):
        """The controller from z to u as python-control's StateSpace, in floats.

        Raises
        ------
        ValueError
            If there is no feedback, or if its matrices have symbols.

        Notes
        -----
        Its output is u = +K e, so the loop is closed by `control.feedback(plant, controller, sign=1)`.
        For python-control's default sign = -1, and to compare with the controllers of other tools, take
        `-controller`. In discrete time it has dt = True and takes the step of the plant.
        """
        import control

        if not self:
            reasons = [part.reason for part in (self.regulator, self.filter) if not part]
            raise ValueError(f"there is no feedback: {'; '.join(reasons)}")
        if any(isinstance(M, sp.MatrixBase) and M.free_symbols for M in self.matrices):
            raise ValueError("a StateSpace holds floats; substitute numbers for the symbols first")
        return control.ss(*(np.array(M.tolist(), dtype=float) for M in self.matrices), self._dt)


@reads_noises
@accepts_state_space("A", "B", "H", time="continuous", instead="use discrete_lqg", C="H")
def lqg(
    A: MatrixLike,
    B: MatrixLike,
    H: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    Q: MatrixLike,
    R: MatrixLike,
) -> StochasticRegulator:
    """Return the optimal feedback for x' = Ax + Bu + q, z = Hx + r and a quadratic cost.

    The cost is lim E[x^T G x + u^T N u].

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact or floats. A StateSpace stands for A, B and H:
        `lqg(sys, G, N, Q, R)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    H : matrix_like, shape (m, n)
        Matrix of the measurement.
    G : matrix_like, shape (n, n)
        Weight of the state, positive semidefinite.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    Q : matrix_like, shape (n, n)
        Intensity of the white noise q.
    R : matrix_like, shape (m, m)
        Intensity of the white noise r.

    Returns
    -------
    StochasticRegulator
        Regulator, filter, controller and cost.

    Raises
    ------
    ValueError, numpy.linalg.LinAlgError, NotImplementedError
        As `lqr`.

    Notes
    -----
    Keywords of python-control: `C` for `H`; `QN`, `RN` for `Q`, `R`, and beside them its `Q`, `R` for
    `G`, `N`: `lqg(sys, Q=, R=, QN=, RN=)`. Without `QN` and `RN` the letters are those here.
    MATLAB: ``lqg``. Source: section 5.4 of the problem book, with Theorem 4.4.

    Examples
    --------
    >>> feedback = lqg([[0, 1], [-1, 0]], [0, 1], [[0, 1]], sp.diag(0, 1), 1, sp.diag(0, 4), 1)    # problem 5.70
    >>> feedback.regulator.gain, feedback.filter.gain.T, feedback.cost
    (Matrix([[0, -1]]), Matrix([[0, 2]]), 6)
    >>> feedback.controller.A.tolist()
    [[0.0, 1.0], [-1.0, -3.0]]
    """
    A, B, H, G, N, Q, R = _read(A, B, H, G, N, Q, R)
    regulator, filter = lqr(A, B, G, N), stationary_filter(A, H, Q, R)
    if not (regulator and filter):
        return StochasticRegulator(regulator, filter, (), None, None)
    K, L, P = regulator.gain, filter.gain, filter.covariance
    matrices = (tidy(regulator.loop - L @ H), L, K, 0 * K @ L)
    return _joined(regulator, filter, Q, P @ K.T @ N @ K, matrices, False)


@reads_noises
@accepts_state_space("A", "B", "H", time="discrete", instead="use lqg", C="H")
def discrete_lqg(
    A: MatrixLike,
    B: MatrixLike,
    H: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    Q: MatrixLike,
    R: MatrixLike,
) -> StochasticRegulator:
    """Return the optimal feedback for x_{i+1} = A x_i + B u_i + q_i, z_i = H x_i + r_i.

    The cost is lim E[x_i^T G x_i + u_i^T N u_i], and u_i may use z_i.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Transition matrix; exact or floats. A StateSpace stands for A, B and H:
        `discrete_lqg(sys, G, N, Q, R)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    H : matrix_like, shape (m, n)
        Matrix of the measurement.
    G : matrix_like, shape (n, n)
        Weight of the state, positive semidefinite.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    Q : matrix_like, shape (n, n)
        Covariance of q_i.
    R : matrix_like, shape (m, m)
        Covariance of r_i.

    Returns
    -------
    StochasticRegulator
        Regulator, filter, controller and cost.

    Raises
    ------
    ValueError, numpy.linalg.LinAlgError, NotImplementedError
        As `discrete_lqr`.

    Notes
    -----
    Keywords of python-control: `C` for `H`; `QN`, `RN` for `Q`, `R`, and beside them its `Q`, `R` for
    `G`, `N`. MATLAB: ``lqg`` with the option "current". Source: added to the problem book; section 5.4
    in discrete time, with Theorem 4.2.

    Examples
    --------
    >>> feedback = discrete_lqg(1, 1, 1, 1, 1, 1, 1)
    >>> feedback.regulator.gain[0], feedback.filter.gain[0], sp.radsimp(feedback.cost)
    (1/2 - sqrt(5)/2, -1/2 + sqrt(5)/2, sqrt(5))
    """
    A, B, H, G, N, Q, R = _read(A, B, H, G, N, Q, R)
    regulator, filter = discrete_lqr(A, B, G, N), discrete_stationary_filter(A, H, Q, R)
    if not (regulator and filter):
        return StochasticRegulator(regulator, filter, (), None, None)
    K, L, S = regulator.gain, filter.gain, regulator.cost
    reduction, advanced = identity_like(A) - L @ H, regulator.loop
    matrices = tuple(tidy(M) for M in (advanced @ reduction, advanced @ L, K @ reduction, K @ L))
    weight = K.T @ (N + B.T @ S @ B) @ K
    return _joined(regulator, filter, Q, filter.corrected @ weight, matrices, True)


def _read(A, B, H, G, N, Q, R):
    """Return all matrices as exact ones or all as floats."""
    floats = any_floats(A, B, H, G, N, Q, R)
    A, B, G, N = read_regulator(A, B, G, N, floats)
    H = read_matrix(H, "H", None, A.shape[0], floats)
    Q, R = (read_covariance(M, name, None, floats) for M, name in ((Q, "Q"), (R, "R")))
    return A, B, H, G, N, Q, R


def _joined(regulator, filter, Q, estimation_cost, matrices, dt):
    """Return the feedback whose estimation errors cost the trace of `estimation_cost`."""
    control_cost, further_cost = _trace(regulator.cost @ Q), _trace(estimation_cost)
    return StochasticRegulator(
        regulator, filter, matrices, control_cost + further_cost, control_cost, dt
    )


def _trace(matrix):
    return (
        float(np.trace(matrix)) if isinstance(matrix, np.ndarray) else sp.simplify(matrix.trace())
    )
