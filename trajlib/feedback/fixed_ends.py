"""Linear system with a quadratic cost between two given states.

For x' = Ax + Bu, x(0) = a, x(T) = b the cost is J = integral of (x^T G x + u^T N u) dt. With the costates p,
u = -N^-1 B^T p and

    x' = A x - B N^-1 B^T p,    p' = -G x - A^T p,

whose solutions obey, with bounded matrices,

    x(T) = F^T x(0) - W p(T),    p(0) = V x(0) + F p(T).

So W p(T) = F^T a - b is one linear system, and J = p(0)^T a - p(T)^T b. For G = 0 it is F^T = e^{AT}, V = 0,
and W is the controllability Gramian of (A, B N^-1/2). W is positive definite if (A, B) is controllable.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, read_vector
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals
from trajlib._typing import Matrix, MatrixLike, ScalarLike
from trajlib.estimation.continuous_filter import riccati_flow
from trajlib.estimation.exact_or_float import latex, solve, symmetric, tidy
from trajlib.estimation.markov import transition
from trajlib.feedback.quadratic_cost import read_regulator
from trajlib.structure.rank_tests import controllability
from trajlib.typesetting import escape_markdown


class StateAndControl(NamedTuple):
    """State and control at one time.

    Attributes
    ----------
    state : matrix
        x(t), n components.
    control : matrix
        u(t), s components.
    """

    state: Matrix
    control: Matrix


@dataclass(frozen=True)
class FixedEndsControl:
    """The control of least cost between two states; false in an `if` if there is none.

    Attributes
    ----------
    cost : sympy.Expr or float or None
        J; None if there is no such control.
    gramian : matrix or None, shape (n, n)
        W; for G = 0 the controllability Gramian with the weight N^-1.
    costates : tuple of matrix
        p(0) and p(T), half the derivatives of J by a, and by -b.
    reason : str
        What it is, or why there is none.
    """

    cost: sp.Expr | float | None
    gramian: Matrix
    costates: tuple
    reason: str
    _problem: tuple = ()

    def __bool__(self):
        return self.cost is not None

    def at(self, t: ScalarLike) -> StateAndControl:
        """Return state and control at a time.

        Parameters
        ----------
        t : scalar_like
            Time from 0 to T; for exact matrices also a symbol.

        Returns
        -------
        StateAndControl

        Raises
        ------
        ValueError
            If there is no control, or the time is not between 0 and T.
        """
        if not self:
            raise ValueError(f"t: {self.reason}")
        A, B, G, N, start, duration = self._problem
        t = exact_decimals(sp.sympify(t))
        if t.is_number and not 0 <= t <= duration:
            raise ValueError(f"t: expected a time from 0 to {duration}, got {t}")
        if not isinstance(A, np.ndarray):
            flow = transition(_hamiltonian(A, B, G, N), t) * sp.Matrix([start, self.costates[0]])
            control = -solve(N, B.T * flow[A.rows :, :])
            return StateAndControl(
                *(part.applyfunc(sp.simplify) for part in (flow[: A.rows, :], control))
            )
        S = B @ np.linalg.solve(N, B.T)
        (F, W, _), (onward, _, V) = (
            riccati_flow(A.T, S, G, part) for part in (float(t), float(duration - t))
        )
        # x = F^T a - W p of the time up to t, and p = V x + F p(T) of the time from then on.
        push = onward @ self.costates[1]
        state = np.linalg.solve(np.eye(len(A)) + W @ V, F.T @ start - W @ push)
        return StateAndControl(state, -np.linalg.solve(N, B.T @ (V @ state + push)))

    def _repr_markdown_(self):
        if not self:
            return escape_markdown(self.reason)
        return rf"$\displaystyle J = {latex(self.cost)},\quad W = {latex(self.gramian)}$"


@accepts_state_space(
    "A", "B", time="continuous", instead="solve for the controls of all steps", Q="G", R="N"
)
def fixed_ends_lqr(
    A: MatrixLike,
    B: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    start: MatrixLike,
    end: MatrixLike,
    duration: ScalarLike,
) -> FixedEndsControl:
    """Return the control of least quadratic cost from one given state to another.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; exact or floats. A StateSpace stands for A and B:
        `fixed_ends_lqr(sys, G, N, start, end, duration)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    G : matrix_like, shape (n, n)
        Weight of the state, positive semidefinite; zero for the least energy of the control.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    start, end : matrix_like
        x(0) and x(T), n components each; for exact matrices also symbols.
    duration : scalar_like
        T > 0; for exact matrices also a positive symbol.

    Returns
    -------
    FixedEndsControl
        False in an `if`, with a reason, if the pair is not controllable.

    Raises
    ------
    ValueError
        If shapes do not fit, a weight is not symmetric or not positive (semi)definite, or the duration is
        not positive.
    NotImplementedError
        For exact spectra beyond square roots.

    Notes
    -----
    Keywords of python-control: `Q`, `R` for `G`, `N`.
    In floats no exponential of the whole duration is computed, so that long ones lose no digits.
    Source: added to the problem book; the maximum principle (Theorem 5.1) for fixed ends.

    Examples
    --------
    >>> T, t = sp.symbols("T t", positive=True)
    >>> push = fixed_ends_lqr([[0, 1], [0, 0]], [0, 1], sp.zeros(2), 1, [0, 0], [1, 0], T)
    >>> push.cost, sp.factor(push.at(t).control[0])
    (12/T**3, -6*(-T + 2*t)/T**3)
    """
    floats = any_floats(A, B, G, N, start, end)
    A, B, G, N = read_regulator(A, B, G, N, floats)
    n = A.shape[0]
    start, end = (
        read_vector(vector, name, n, floats) for vector, name in ((start, "start"), (end, "end"))
    )
    duration = exact_decimals(sp.sympify(duration))
    if duration.is_positive is not True or (floats and not duration.is_number):
        raise ValueError(f"duration: expected a positive time, got {duration}")
    test = controllability(A, B)
    if not test:
        reason = f"not every end can be reached: {test.reason}"
        return FixedEndsControl(None, None, (), reason)
    if floats:
        F, W, V = riccati_flow(A.T, B @ np.linalg.solve(N, B.T), G, float(duration))
        last = _solve_symmetric(W, F.T @ start - end)
        costates = V @ start + F @ last, last
        cost = float(costates[0] @ start - costates[1] @ end)
    else:
        flow = transition(_hamiltonian(A, B, G, N), duration)
        first = solve(flow[:n, n:], end - flow[:n, :n] * start)
        costates = first, tidy(flow[n:, :n] * start + flow[n:, n:] * first)
        W = symmetric(-solve(flow[n:, n:].T, flow[:n, n:].T).T)
        cost = sp.simplify((costates[0].T * start - costates[1].T * end)[0])
    return FixedEndsControl(
        cost, W, costates, "the control of least cost", (A, B, G, N, start, duration)
    )


def _hamiltonian(A, B, G, N):
    return sp.Matrix(sp.BlockMatrix([[A, -B * solve(N, B.T)], [-G, -A.T]]))


def _solve_symmetric(W, right):
    """Return W^-1 r in units in which W has a unit diagonal."""
    units = np.sqrt(np.diag(W))
    return np.linalg.solve(W / np.outer(units, units), right / units) / units
