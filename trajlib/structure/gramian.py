"""The controllability Gramian of a linear system on an interval.

    W(T) = integral from 0 to T of e^(As) B B^T e^(A^T s) ds,
    dW/dT = A W + W A^T + B B^T,   W(0) = 0.

The least energy, the integral of u^T u, that brings x' = Ax + Bu from 0 to xi in the time T is xi^T
W^-1 xi; where W is singular, the states in its range are reached and no others. Numbers in floats
come from one exponential (C. F. Van Loan, 1978).
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_expression
from trajlib._typing import ExprLike, Matrix, MatrixLike


@accepts_state_space("A", "B", time="continuous", instead="its gramian is a sum, not an integral")
def controllability_gramian(
    A: MatrixLike, B: MatrixLike | None = None, duration: ExprLike | None = None
) -> Matrix:
    """Return the controllability Gramian W(T) of x' = Ax + Bu on an interval of length T.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu. A StateSpace stands for A and B:
        `controllability_gramian(sys, duration)`.
    B : matrix_like, shape (n, s)
        Matrix of the control.
    duration : float or sympy.Expr
        T > 0 in the unit of time of A: a number, or an expression with exact matrices.

    Returns
    -------
    matrix, shape (n, n)
        Exact for SymPy matrices or lists of rows, floats for NumPy arrays or a StateSpace.

    Raises
    ------
    ValueError
        If `A` is not square, if `B` has not n rows, for entries that are not real, or for a
        duration that is not positive.

    Notes
    -----
    With `A.T`, `H.T` it is the observability Gramian. MATLAB: ``gram`` with a finite TimeInterval.
    Source: problem 5.22 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> controllability_gramian(sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([0, 1]), 1)
    Matrix([
    [1/3, 1/2],
    [1/2,   1]])
    """
    transposed, row = read_controlled(A, B)
    A, B = transposed.T, row.T
    T = read_expression(duration, "duration")
    if T.is_positive is False or T.is_finite is False or T.is_real is False:
        raise ValueError(f"duration: expected a positive number, got {duration}")
    if isinstance(A, np.ndarray):
        if not T.is_number:
            raise ValueError(f"duration: expected a number with matrices of floats, got {duration}")
        return _in_floats(A, B, float(T))
    s = sp.Dummy("s", positive=True)
    push = ((A * s).exp() * B).applyfunc(_without_i)
    return (push * push.T).applyfunc(lambda e: sp.integrate(sp.expand(e), (s, 0, T)))


def _without_i(e):
    """Write imaginary exponentials as cosines and sines, which are integrated fast."""
    real = all(symbol.is_real for symbol in e.free_symbols)
    return sp.simplify(sp.expand(e, complex=True) if real else e.rewrite(sp.cos))


def _in_floats(A, B, duration):
    from scipy.linalg import expm

    n = len(A)
    blocks = np.block([[-A, B @ B.T], [np.zeros((n, n)), A.T]])
    # Halved until the exponential is harmless: W(2T) = W(T) + e^(AT) W(T) e^(A^T T).
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=1).max() * duration, 1e-300)))))
    exponential = expm(blocks * duration / 2**halvings)
    flow = exponential[n:, n:].T
    W = flow @ exponential[:n, n:]
    for _ in range(halvings):
        W, flow = W + flow @ W @ flow.T, flow @ flow
    return (W + W.T) / 2
