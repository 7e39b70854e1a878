"""Measurements with an unknown error, and time-varying outputs: problems 2.16 and 2.17.

An error c w with w' = S w (a constant: S = 0; an oscillation of known frequency: S = [[0, omega],
[-omega, 0]]) becomes a part of the state: (x; w)' = diag(A, S) (x; w), z = (H, c) (x; w).

For an output z = H(t) x that depends on time analytically, the Kalman matrix is built of the
derivatives of z: N_0 = H, N_(k+1) = N_k' + N_k A. The system is observable on every interval
exactly when the rank of N_0, ..., N_(n-1) is n for some t (and then for all but isolated t): rows
that depend on the earlier ones over the functions of t make all later ones depend on them too. The
rank of H, HA, ... with t frozen in H decides nothing.

Polynomials, exponentials, sines and cosines in H(t) satisfy a linear equation with constant
coefficients, of order d say; then z satisfies one of order nd, and z vanishes identically exactly
when its first nd derivatives vanish at t = 0. So for conditions on parameters the matrix is (N_0;
...; N_(nd-1)) at t = 0, whose entries are polynomials in the parameters.
"""

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import (
    any_floats,
    read_exact_matrix,
    read_float_matrix,
    read_observed,
)
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import join_names, read_symbols
from trajlib._typing import Matrix, MatrixLike, Symbols
from trajlib.structure.parameters import RankConditions, rank_conditions


@accepts_state_space("A", "H", C="H")
def with_measurement_error(
    A: MatrixLike, H: MatrixLike, S: MatrixLike, c: MatrixLike
) -> tuple[Matrix, Matrix]:
    """Return (A', H'): the state augmented by the error w of z = Hx + cw, w' = Sw.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax; exact, with symbols, or floats. A StateSpace stands for A and H:
        `with_measurement_error(sys, S, c)`.
    H : matrix_like, shape (m, n)
        Matrix of the output.
    S : matrix_like, shape (k, k)
        Matrix of the error.
    c : matrix_like, shape (m, k)
        Matrix of the error in the output; a flat list or a row for one output.

    Returns
    -------
    A' : matrix, shape (n + k, n + k)
        diag(A, S).
    H' : matrix, shape (m, n + k)
        (H, c).

    Raises
    ------
    ValueError
        If shapes do not fit.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB: ``blkdiag(A, S)``, ``[C c]``. Source: examples 4 and 5 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> omega = sp.Symbol("omega")
    >>> S = sp.Matrix([[0, omega], [-omega, 0]])
    >>> A, H = with_measurement_error(sp.Matrix([[0, 1], [-1, 0]]), sp.Matrix([[1, 0]]), S, [1, 0])
    >>> H
    Matrix([[1, 0, 1, 0]])
    >>> from trajlib.structure import observability_matrix
    >>> sp.factor(observability_matrix(A, H).det())
    omega*(omega - 1)**2*(omega + 1)**2
    """
    A, H = read_observed(A, H)
    floating = isinstance(A, np.ndarray) or any_floats(S, c)
    if floating:
        A, H = read_float_matrix(A, "A"), read_float_matrix(H, "H")
        S, c = read_float_matrix(S, "S", square=True), np.atleast_2d(read_float_matrix(c, "c"))
    else:
        S, c = read_exact_matrix(S, "S", square=True), read_exact_matrix(c, "c")
    if tuple(c.shape) != (H.shape[0], S.shape[0]):
        raise ValueError(
            f"c: expected shape {(H.shape[0], S.shape[0])}, a row for each output and a column for "
            f"each w, got {tuple(c.shape)}"
        )
    if floating:
        n, k = len(A), len(S)
        return np.block([[A, np.zeros((n, k))], [np.zeros((k, n)), S]]), np.hstack([H, c])
    return sp.diag(A, S), sp.Matrix.hstack(H, c)


def time_varying_observability_matrix(A: MatrixLike, H: MatrixLike, time: sp.Symbol) -> sp.Matrix:
    """Return the observability matrix (N_0; ...; N_(n-1)) of a time-varying output z = H(t) x.

    N_0 = H, N_(k+1) = N_k' + N_k A.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax, exact; it may contain `time`.
    H : matrix_like, shape (m, n)
        Matrix of the output, exact.
    time : sympy.Symbol
        The time t.

    Returns
    -------
    sympy.Matrix, shape (m n, n)
        The derivatives of z as rows.

    Raises
    ------
    ValueError
        If shapes do not fit, or for floats.

    Notes
    -----
    MATLAB: ``obsv`` for A, C(t). Source: the derivatives of z, as asked by problem 2.17.

    Examples
    --------
    >>> import sympy as sp
    >>> t, omega = sp.symbols("t omega")
    >>> H = sp.Matrix([[sp.sin(omega*t), sp.cos(omega*t)]])
    >>> N = time_varying_observability_matrix(sp.Matrix([[0, 1], [-1, 0]]), H, t)
    >>> sp.simplify(N.det())
    1 - omega
    """
    (time,) = read_symbols(time, "time")
    A, H = read_observed(A, H)
    if isinstance(A, np.ndarray):
        raise ValueError(
            "H: expected SymPy matrices; an output that changes with time is given by its formulas"
        )
    blocks = [H]
    while len(blocks) < A.rows:
        blocks.append((blocks[-1].diff(time) + blocks[-1] * A).applyfunc(sp.expand))
    return sp.Matrix.vstack(*blocks)


def time_varying_conditions(
    A: MatrixLike, H: MatrixLike, time: sp.Symbol, parameters: Symbols = ()
) -> RankConditions:
    """Return the parameters for which x' = Ax, z = H(t) x is observable on every interval.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax, constant and exact.
    H : matrix_like, shape (m, n)
        Sums of polynomials, exponentials, sines and cosines of `time`.
    time : sympy.Symbol
        The time t.
    parameters : sequence of sympy.Symbol, optional
        The other symbols, real.

    Returns
    -------
    RankConditions
        With `sp.true` or `sp.false` as the region if there are no parameters; its minors are those
        of the derivatives of z at t = 0.

    Raises
    ------
    ValueError
        For other functions of time, for an A that depends on time, or for symbols that are not
        named.

    Notes
    -----
    MATLAB has no word for it (rank of the Gramian). Source: problem 2.17 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> t, omega = sp.symbols("t omega")
    >>> H = sp.Matrix([[sp.sin(omega*t), sp.cos(omega*t)]])
    >>> found = time_varying_conditions(sp.Matrix([[0, 1], [-1, 0]]), H, t, [omega])
    >>> found.region, found.exceptions
    (Ne(omega, 1), ((Eq(omega, 1), 1),))
    """
    parameters = read_symbols(parameters, "parameters")
    N = time_varying_observability_matrix(A, H, time)
    A, H = read_observed(A, H)
    if time in A.free_symbols:
        raise ValueError(
            f"A: expected a constant matrix, got one that contains {time}; study the rank of "
            "time_varying_observability_matrix instead"
        )
    if undeclared := H.free_symbols - {time, *parameters} | A.free_symbols - {*parameters}:
        raise ValueError(
            f"parameters: the system also has {join_names(undeclared)}; name every "
            "symbol that is not a number"
        )
    blocks = [N[: H.rows, :]]
    for _ in range(A.rows * _order_of_equation(H, time) - 1):
        blocks.append((blocks[-1].diff(time) + blocks[-1] * A).applyfunc(sp.expand))
    return rank_conditions(sp.Matrix.vstack(*(b.subs(time, 0) for b in blocks)), parameters)


def _order_of_equation(H, time):
    """Return the order of a linear constant-coefficient equation that all entries satisfy."""
    powers = {}
    for entry in H:
        for term in sp.Add.make_args(sp.expand(sp.expand(entry.rewrite(sp.exp)), power_exp=False)):
            factors, exponent = [], sp.Integer(0)
            for factor in sp.Mul.make_args(term):
                if isinstance(factor, sp.exp) and factor.has(time):
                    exponent += factor.args[0]
                else:
                    factors.append(factor)
            polynomial = sp.Mul(*factors)
            rate = sp.expand(exponent).coeff(time, 1)
            if not polynomial.is_polynomial(time) or sp.expand(exponent - rate * time).has(time):
                raise ValueError(
                    f"H: expected sums of polynomials, exponentials, sines and cosines of {time}, "
                    f"got {entry}"
                )
            powers[rate] = max(
                powers.get(rate, 0), sp.degree(polynomial, time) if polynomial.has(time) else 0
            )
    return int(sum(degree + 1 for degree in powers.values()))
