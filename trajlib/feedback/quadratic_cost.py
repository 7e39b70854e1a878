"""Linear regulators with a quadratic cost: infinite and finite horizon.

For x' = Ax + Bu the cost is J = integral of (x^T G x + u^T N u) dt, with a final time T plus x(T)^T
F x(T). Its least value from x is x^T S x, the law u = Kx has K = -N^-1 B^T S, and S obeys the
Riccati equation

    -S' = A^T S + S A + G - S B N^-1 B^T S,    S(T) = F,

without S' for the infinite horizon. It is that of a filter's covariance for (A^T, B^T, G, N) with
time reversed, and is solved there. A factor before the whole cost, as 1/2, changes neither S nor K:
then J = x^T S x / 2.
"""

from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from trajlib._arguments.covariances import is_semidefinite, read_covariance, read_symmetric
from trajlib._arguments.matrices import any_floats, read_matrix, read_square
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals
from trajlib._typing import ExprLike, Matrix, MatrixLike
from trajlib.estimation.continuous_filter import ContinuousFilter
from trajlib.estimation.exact_or_float import latex, solve, symmetric, tidy
from trajlib.estimation.hypotheses import DETECTABLE, DRIVEN, GENERAL, failed_hypothesis
from trajlib.estimation.stationary_filters import solve_filter
from trajlib.feedback.indefinite_cost import solve_indefinite, solve_indefinite_until
from trajlib.feedback.keywords import reads_weights
from trajlib.stability.regions import latex_condition
from trajlib.structure.decomposition import observability_decomposition
from trajlib.typesetting import escape_markdown

#: A hypothesis on a filter, in the words of the regulator that is dual to it.
_DUAL = {
    DETECTABLE: "not stabilisable, a mode that does not decay is not controlled",
    DRIVEN: "a mode on the imaginary axis is unobservable in the cost",
    GENERAL: (
        "for general values of the symbols the pair is not stabilisable, or a mode on the imaginary "
        "axis is unobservable in the cost"
    ),
}


@dataclass(frozen=True)
class QuadraticRegulator:
    """The optimal linear law u = Kx for a quadratic cost; false in an `if` if there is none.

    Attributes
    ----------
    cost : matrix, shape (n, n)
        S; the least cost from x is x^T S x. None if there is no law.
    gain : matrix, shape (s, n)
        K of u = Kx.
    loop : matrix, shape (n, n)
        A + BK.
    where : sympy.Basic
        The condition on symbols under which all this holds.
    reason : str
        What the law is, or why there is none.
    residual : float or None
        For floats the norm of what is left of the Riccati equation beside the norms of the factors of
        its terms.
    error : float or None
        For floats an estimate of |dS|/|S|, the relative error of `cost` in Frobenius norms, the greater
        of those in the given and in balanced units.
    """

    cost: Matrix
    gain: Matrix
    loop: Matrix
    where: sp.Basic
    reason: str
    residual: float | None = None
    error: float | None = None

    def __bool__(self):
        return self.cost is not None

    def _repr_markdown_(self):
        if not self:
            return escape_markdown(self.reason)
        shown = rf"S = {latex(self.cost)},\quad K = {latex(self.gain)}"
        where = "" if self.where == sp.true else rf",\quad {latex_condition(self.where)}"
        return rf"$\displaystyle {shown}{where}$"


@reads_weights
@accepts_state_space("A", "B", time="continuous", instead="use discrete_lqr", Q="G", R="N")
def lqr(
    A: MatrixLike,
    B: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    cross: MatrixLike | None = None,
    *,
    stable: bool = True,
) -> QuadraticRegulator:
    """Return the linear law u = Kx of least quadratic cost for all time.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; exact, also with symbols (then for general values), or floats. A
        StateSpace stands for A and B: `lqr(sys, G, N)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    G : matrix_like, shape (n, n)
        Weight of the state, symmetric. If it is indefinite, or the whole form with `cross` is, the
        verdict is a law, or that the cost has no lower bound, with a frequency at which it falls.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    cross : matrix_like, shape (n, s), optional
        Weight C of a further term 2 x^T C u of the cost.
    stable : bool, default True
        If true, the best of the laws that bring every state to zero, from the stabilising solution of
        the Riccati equation; it exists if and only if (A, B) is stabilisable and every mode on the
        imaginary axis is observable in the cost. If false, the best of all laws, also where states that
        are unobservable in the cost do not decay: the least S >= 0 that solves the equation; for
        semidefinite weights.

    Returns
    -------
    QuadraticRegulator
        False in an `if`, with a reason, if there is no such law.

    Raises
    ------
    ValueError
        If shapes do not fit, a weight is not symmetric, or N is not positive definite.
    numpy.linalg.LinAlgError
        If there is such a law, but the digits of floats did not suffice to find it.
    NotImplementedError
        For exact spectra beyond square roots.

    Notes
    -----
    Keywords of python-control: `Q`, `R` for `G`, `N`, and with `R` its `N` for `cross`.
    The sign is u = Kx. MATLAB: ``-lqr(A, B, G, N, C)``; python-control: ``-lqr(A, B, G, N, C)[0]``.
    Source: section 5.4 of the problem book; added are cross terms and indefinite weights.

    Examples
    --------
    >>> lqr(1, 1, 1, 2).gain    # problem 5.63
    Matrix([[-sqrt(6)/2 - 1]])
    >>> lqr(1, 1, 0, 1).gain[0], lqr(1, 1, 0, 1, stable=False).gain[0]
    (-2, 0)
    >>> print(lqr([[0, 1], [0, 1]], [0, 1], [[0, 0], [0, 1]], 1).reason)    # problem 5.67b
    no stabilising law of least cost: a mode on the imaginary axis is unobservable in the cost
    >>> lqr(-1, 1, -sp.Rational(3, 4), 1).cost[0], "no lower bound" in lqr(-1, 1, -2, 1).reason
    (-1/2, True)
    """
    if not isinstance(stable, (bool, np.bool_)):
        raise TypeError(f"stable: expected True or False, got {stable!r}")
    if cross is not None:
        A, B, G, N, shift = without_cross_term(A, B, G, N, cross)
        return shifted(lqr(A, B, G, N, stable=stable), shift)
    A, B, G, N = read_regulator(A, B, G, N, weight=read_symmetric)
    if not is_semidefinite(G):
        if not stable:
            raise ValueError("stable: the least cost without stability is for semidefinite weights")
        return QuadraticRegulator(*solve_indefinite(A, B, G, N, False))
    if not stable:
        return _without_unobserved_states(A, B, G, N)
    filter = solve_filter(A.T, B.T, G, N, False)
    if not filter:
        reason = f"no stabilising law of least cost: {_DUAL[failed_hypothesis(A.T, B.T, G, False)]}"
        return QuadraticRegulator(None, None, None, sp.false, reason)
    general = "" if filter.where == sp.true else f"; where {filter.where}"
    return QuadraticRegulator(
        filter.covariance,
        -filter.gain.T,
        filter.errors.T,
        filter.where,
        f"the stabilising law of least cost{general}",
        filter.residual,
        filter.error,
    )


@reads_weights
@accepts_state_space("A", "B", time="continuous", instead="use discrete_finite_lqr", Q="G", R="N")
def finite_lqr(
    A: MatrixLike,
    B: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    F: MatrixLike,
    time_to_go: ExprLike,
    cross: MatrixLike | None = None,
) -> QuadraticRegulator:
    """Return the law u = K(t) x of least cost up to a final time T, at one instant before it.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu; exact or floats. A StateSpace stands for A and B:
        `finite_lqr(sys, G, N, F, time_to_go)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    G : matrix_like, shape (n, n)
        Weight of the state, symmetric. If it or F is indefinite, the verdict, for numbers, is a law, or
        that the cost has no lower bound, with the time to go at which S escapes to infinity.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    F : matrix_like, shape (n, n)
        Weight of the final state, x(T)^T F x(T); symmetric.
    time_to_go : float or sympy.Expr
        T - t >= 0: a number or, for exact matrices and semidefinite weights, a symbol.
    cross : matrix_like, shape (n, s), optional
        Weight C of a further term 2 x^T C u of the cost.

    Returns
    -------
    QuadraticRegulator
        S, K and A + BK at the instant T - `time_to_go`; false in an `if`, with a reason, if the cost
        has no lower bound.

    Raises
    ------
    ValueError
        If shapes do not fit, a weight is not symmetric, or N is not positive definite.
    numpy.linalg.LinAlgError
        If floats do not tell whether S escapes before the time to go.
    NotImplementedError
        For exact spectra beyond square roots, and for symbols with indefinite weights.

    Notes
    -----
    Keywords of python-control: `Q`, `R` for `G`, `N`, and with `R` its `N` for `cross`.
    The sign is u = Kx. Source: section 5.4 of the problem book; added are cross terms and indefinite
    weights.

    Examples
    --------
    >>> left = sp.Symbol("left", positive=True)
    >>> finite_lqr(0, 1, 0, 1, 1, left).gain[0]
    -1/(left + 1)
    >>> print(finite_lqr(0, 1, -1, 1, 0, 2).reason)    # S = -tan(T - t)
    no law of least cost: the cost has no lower bound, S escapes to infinity at the time to go 1.5708
    """
    if cross is not None:
        A, B, G, N, shift = without_cross_term(A, B, G, N, cross)
        return shifted(finite_lqr(A, B, G, N, F, time_to_go), shift)
    A, B, G, N = read_regulator(A, B, G, N, weight=read_symmetric)
    floats = isinstance(A, np.ndarray)
    F = read_symmetric(F, "F", A.shape[0], floats)
    time_to_go = exact_decimals(sp.sympify(time_to_go))
    if time_to_go is sp.oo:
        raise ValueError("time_to_go: expected a finite time, got oo; lqr is for all time")
    if (
        time_to_go.is_negative
        or time_to_go.is_real is False
        or (floats and time_to_go.free_symbols)
    ):
        kind = "time that is not negative" + " or a symbol" * (not floats)
        raise ValueError(f"time_to_go: expected a {kind}, got {time_to_go}")
    if is_semidefinite(G) and is_semidefinite(F):
        cost = ContinuousFilter(A.T, B.T, G, N).covariance(F, time_to_go)
        reason = "the law of least cost up to the end"
    else:
        cost, reason = solve_indefinite_until(A, B, G, N, F, time_to_go)
        if cost is None:
            return QuadraticRegulator(None, None, None, sp.false, reason)
    gain = -(np.linalg.solve(N, B.T @ cost) if floats else N.inv() * B.T * cost)
    return QuadraticRegulator(cost, gain, A + B @ gain, sp.true, reason)


def without_cross_term(A, B, G, N, cross):
    """Return the matrices of a cost without 2 x^T C u, and the gain N^-1 C^T that its laws are short of.

    With u = v - N^-1 C^T x the cost is x^T (G - C N^-1 C^T) x + v^T N v, and the system A - B N^-1 C^T.
    """
    if isinstance(cross, (bool, np.bool_)):
        raise TypeError(f"cross: expected a matrix, got {cross}")
    floats = any_floats(A, B, G, N, cross)
    A, B, G, N = read_regulator(A, B, G, N, floats, read_symmetric)
    C = read_matrix(cross, "cross", *B.shape, floats, flat="column" if B.shape[0] > 1 else "row")
    shift = solve(N, C.T)
    return tidy(A - B @ shift), B, symmetric(G - C @ shift), N, shift


def shifted(regulator, shift):
    """Return the regulator with u = v - `shift` x in place of v."""
    return replace(regulator, gain=tidy(regulator.gain - shift)) if regulator else regulator


def read_regulator(A, B, G, N, floats=None, weight=read_covariance):
    """Return the matrices of a regulator; a flat B is a column, and `weight` reads G."""
    floats = any_floats(A, B, G, N) if floats is None else floats
    A = read_square(A, "A", floats)
    n = A.shape[0]
    B = read_matrix(B, "B", n, None, floats, flat="column" if n > 1 else "row")
    return (
        A,
        B,
        weight(G, "G", n, floats),
        read_covariance(N, "N", B.shape[1], floats, definite=True),
    )


def _without_unobserved_states(A, B, G, N):
    """Return the law for the part that is observable in the cost, where S is unique."""
    split = observability_decomposition(A, G)
    n, floats = split.sizes[0], isinstance(A, np.ndarray)
    if not n:
        zero = B.T * 0
        return QuadraticRegulator(
            G * 0,
            zero,
            A + B @ zero,
            sp.true,
            "no state is observable in the cost: u = 0 costs least",
        )
    T = split.transformation
    back = np.linalg.inv(T) if floats else T.inv()
    observable, into = T[:n, :], back[:, :n]
    part = lqr((T @ A @ back)[:n, :n], observable @ B, symmetric(into.T @ G @ into), N)
    if not part:
        return part
    cost, gain = symmetric(observable.T @ part.cost @ observable), tidy(part.gain @ observable)
    return QuadraticRegulator(
        cost,
        gain,
        tidy(A + B @ gain),
        part.where,
        part.reason.replace("stabilising ", ""),
        part.residual,
        part.error,
    )
