"""Linear regulators in discrete time with a quadratic cost: infinite and finite horizon.

For x_{i+1} = A x_i + B u_i the cost is J = sum of (x_i^T G x_i + u_i^T N u_i), up to a last step T - 1
plus x_T^T F x_T. Its least value from x is x^T S x, and

    K_i = -(N + B^T S_{i+1} B)^-1 B^T S_{i+1} A,
    S_i = G + K_i^T N K_i + (A + B K_i)^T S_{i+1} (A + B K_i),    S_T = F.

For the infinite horizon S is constant: it is the covariance before the measurement of the stationary
filter for (A^T, B^T, G, N), and is solved there; with indefinite weights in `indefinite_cost`.
"""

import sympy as sp

from trajlib._arguments.covariances import is_semidefinite, read_symmetric
from trajlib._arguments.matrices import any_floats
from trajlib._arguments.numbers import read_count
from trajlib._arguments.state_space import accepts_state_space
from trajlib._typing import MatrixLike
from trajlib.estimation.exact_or_float import solve, symmetric, tidy
from trajlib.estimation.hypotheses import DETECTABLE, DRIVEN, GENERAL, failed_hypothesis
from trajlib.estimation.stationary_filters import solve_filter
from trajlib.feedback.indefinite_cost import solve_indefinite, why_no_law
from trajlib.feedback.keywords import reads_weights
from trajlib.feedback.quadratic_cost import (
    QuadraticRegulator,
    read_regulator,
    shifted,
    without_cross_term,
)

#: A hypothesis on a filter, in the words of the regulator that is dual to it.
_DUAL = {
    DETECTABLE: "not stabilisable, a mode that does not decay is not controlled",
    DRIVEN: "a mode on the unit circle is unobservable in the cost",
    GENERAL: (
        "for general values of the symbols the pair is not stabilisable, or a mode on the unit circle "
        "is unobservable in the cost"
    ),
}


@reads_weights
@accepts_state_space("A", "B", time="discrete", instead="use lqr", Q="G", R="N")
def discrete_lqr(
    A: MatrixLike,
    B: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    cross: MatrixLike | None = None,
) -> QuadraticRegulator:
    """Return the linear law u = Kx of least quadratic cost for all steps of a discrete system.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x_{i+1} = A x_i + B u_i; exact, also with symbols (then for general values), or
        floats. A StateSpace stands for A and B: `discrete_lqr(sys, G, N)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    G : matrix_like, shape (n, n)
        Weight of the state, symmetric. If it is indefinite, or the whole form with `cross` is, the
        verdict is a law, or that the cost has no lower bound, with a frequency at which it falls.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    cross : matrix_like, shape (n, s), optional
        Weight C of a further term 2 x^T C u of the cost.

    Returns
    -------
    QuadraticRegulator
        The best of the laws that bring every state to zero; false in an `if`, with a reason, if there
        is none. There is one if and only if (A, B) is stabilisable and every mode on the unit circle is
        observable in the cost.

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
    The sign is u = Kx. MATLAB: ``-dlqr(A, B, G, N, C)``; python-control: ``-dlqr(A, B, G, N, C)[0]``. Source:
    added to the problem book; dual to Theorem 4.2.

    Examples
    --------
    >>> law = discrete_lqr(1, 1, 1, 1)
    >>> law.cost[0], law.gain[0]
    (1/2 + sqrt(5)/2, 1/2 - sqrt(5)/2)
    >>> half = sp.Rational(1, 2)
    >>> discrete_lqr(half, 1, -half / 3, 1).cost[0]
    -1/4
    >>> "no lower bound" in discrete_lqr(half, 1, -half, 1).reason
    True
    """
    if cross is not None:
        A, B, G, N, shift = without_cross_term(A, B, G, N, cross)
        return shifted(discrete_lqr(A, B, G, N), shift)
    A, B, G, N = read_regulator(A, B, G, N, weight=read_symmetric)
    if not is_semidefinite(G):
        return QuadraticRegulator(*solve_indefinite(A, B, G, N, True))
    filter = solve_filter(A.T, B.T, G, N, True)
    if not filter:
        reason = f"no stabilising law of least cost: {_DUAL[failed_hypothesis(A.T, B.T, G, True)]}"
        return QuadraticRegulator(None, None, None, sp.false, reason)
    general = "" if filter.where == sp.true else f"; where {filter.where}"
    return QuadraticRegulator(
        filter.covariance,
        tidy(-filter.gain.T @ A),
        filter.errors.T,
        filter.where,
        f"the stabilising law of least cost{general}",
        filter.residual,
        filter.error,
    )


@reads_weights
@accepts_state_space("A", "B", time="discrete", instead="use finite_lqr", Q="G", R="N")
def discrete_finite_lqr(
    A: MatrixLike,
    B: MatrixLike,
    G: MatrixLike,
    N: MatrixLike,
    F: MatrixLike,
    steps: int,
    cross: MatrixLike | None = None,
) -> tuple[QuadraticRegulator, ...]:
    """Return the laws u_i = K_i x_i of least cost for a given number of steps.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x_{i+1} = A x_i + B u_i; exact or floats. A StateSpace stands for A and B:
        `discrete_finite_lqr(sys, G, N, F, steps)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    G : matrix_like, shape (n, n)
        Weight of the state, symmetric.
    N : matrix_like, shape (s, s)
        Weight of the control, positive definite.
    F : matrix_like, shape (n, n)
        Weight of the state after the last step; symmetric.
    steps : int
        Number of steps T, at least 1.
    cross : matrix_like, shape (n, s), optional
        Weight C of a further term 2 x^T C u of the cost.

    Returns
    -------
    tuple of QuadraticRegulator
        T laws in the order of time; the cost of each is that from its step on. If the weights are
        indefinite, a law is false in an `if`, with a reason, where N + B^T S B is not positive definite
        from then on: the cost has no lower bound, or no single law attains it.

    Raises
    ------
    ValueError
        If shapes do not fit, a weight is not symmetric, or N is not positive definite.
    numpy.linalg.LinAlgError
        If floats do not tell whether N + B^T S B is positive definite.

    Notes
    -----
    Keywords of python-control: `Q`, `R` for `G`, `N`, and with `R` its `N` for `cross`.
    The sign is u = Kx. Source: added to the problem book; R. E. Bellman's dynamic programming.

    Examples
    --------
    >>> [law.gain[0] for law in discrete_finite_lqr(1, 1, 1, 1, 0, 3)]
    [-3/5, -1/2, 0]
    >>> [bool(law) for law in discrete_finite_lqr(1, 1, -1, 2, 0, 3)]
    [False, True, True]
    """
    if cross is not None:
        A, B, G, N, shift = without_cross_term(A, B, G, N, cross)
        return tuple(shifted(law, shift) for law in discrete_finite_lqr(A, B, G, N, F, steps))
    floats = any_floats(A, B, G, N, F)
    A, B, G, N = read_regulator(A, B, G, N, floats, read_symmetric)
    F = read_symmetric(F, "F", A.shape[0], floats)
    laws: list[QuadraticRegulator] = []
    cost, steps = F, read_count(steps, "steps", 1)
    semidefinite = is_semidefinite(G) and is_semidefinite(F)
    while len(laws) < steps:
        spread = symmetric(N + B.T @ cost @ B)
        if not semidefinite and (reason := why_no_law(spread, len(laws) + 1)):
            none = QuadraticRegulator(None, None, None, sp.false, reason)
            laws += [none] * (steps - len(laws))
            break
        gain = -solve(spread, B.T @ cost @ A)
        loop = tidy(A + B @ gain)
        cost = symmetric(G + gain.T @ N @ gain + loop.T @ cost @ loop)
        laws.append(QuadraticRegulator(cost, gain, loop, sp.true, "the law of least cost"))
    return tuple(reversed(laws))
