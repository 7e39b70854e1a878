"""The Gramian of a linear system on an interval: which states a control of a given energy reaches.

    W(T) = integral from 0 to T of e^(As) B B^T e^(A^T s) ds,      dW/dT = A W + W A^T + B B^T,   W(0) = 0.

The least energy, the integral of u^T u, that brings x' = Ax + Bu from 0 to xi in the time T is xi^T
W^-1 xi; where W is singular, the states in its range are reached and no others. Numbers in floats
come from one exponential (C. F. Van Loan, 1978).
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled
from trajlib._arguments.symbols import read_expression


def controllability_gramian(A, B=None, duration=None):
    """The Gramian W(T) of x' = Ax + Bu on an interval of length T, n x n (MATLAB: gram with a
    finite TimeInterval).

    `A`: n x n, `B`: n x s, SymPy matrices or lists of rows (exact) or NumPy arrays (floats); a
    StateSpace in place of `A` brings its own `B`. `duration`: T > 0 in the unit of time of A, a
    number, or an expression with exact matrices. Raises ValueError if `A` is not square, if `B` has
    not n rows, for entries not real, and for a duration that is not positive. Source: problem 5.22
    of the problem book; with `A.T`, `H.T` it is the Gramian of observability.

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
    """Real exponentials as they are, imaginary ones as cosines and sines: so they are integrated
    fast."""
    real = all(symbol.is_real for symbol in e.free_symbols)
    return sp.simplify(sp.expand(e, complex=True) if real else e.rewrite(sp.cos))


def _in_floats(A, B, duration):
    from scipy.linalg import expm

    n = len(A)
    blocks = np.block([[-A, B @ B.T], [np.zeros((n, n)), A.T]])
    # Halved until the exponential is harmless: W(2T) = W(T) + e^(AT) W(T) e^(A^T T).
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=1).max() * duration, 1e-300)))))
    whole = expm(blocks * duration / 2**halvings)
    flow = whole[n:, n:].T
    W = flow @ whole[:n, n:]
    for _ in range(halvings):
        W, flow = W + flow @ W @ flow.T, flow @ flow
    return (W + W.T) / 2
