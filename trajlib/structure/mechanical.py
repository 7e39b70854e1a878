"""Mechanical systems M x'' + D x' + K x = L u, z = H1 x + H2 x', in second-order form.

Theorems 2.5 and 2.6 of the problem book: the system is observable exactly when the rank of (M l^2 +
D l + K; H1 + l H2) is n at every root l of det(M l^2 + D l + K), and controllable exactly when that
of (M l^2 + D l + K, L) is. The number of hidden dimensions is the degree of the greatest common
divisor of the minors of order n, which is the determinant of the greatest common divisor of the two
matrix polynomials.
"""

from itertools import combinations

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import any_floats, has_floats, read_exact_matrix, read_float_matrix
from trajlib._typing import Matrix, MatrixLike
from trajlib.structure import exact
from trajlib.structure.pbh import LAMBDA, HiddenMode, hidden_modes
from trajlib.structure.rank_tests import RankTest, float_test, rank_test


def mechanical_observability(
    M: MatrixLike, D: MatrixLike, K: MatrixLike, H1: MatrixLike, H2: MatrixLike | None = None
) -> RankTest:
    """Decide whether M x'' + D x' + K x = 0, z = H1 x + H2 x' is observable.

    Parameters
    ----------
    M, D, K : matrix_like, shape (n, n)
        Matrices of inertia, damping and stiffness; exact, with symbols (generic), or floats.
    H1, H2 : matrix_like, shape (t, n)
        Matrices of the output; one of them may be None, which is zero.

    Returns
    -------
    RankTest
        Its `order` is the degree of det(M l^2 + D l + K): 2n if M is invertible. The vectors of its
        modes are columns v of length n, with (M l^2 + D l + K) v = 0, (H1 + l H2) v = 0: the output
        of the motion v exp(l t) is zero.

    Raises
    ------
    ValueError
        If shapes do not fit, if det(M l^2 + D l + K) vanishes identically, or for floats and a
        singular M.

    Notes
    -----
    MATLAB: ``obsv`` of the state form. Source: Theorem 2.5 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> M, zero, K = sp.Matrix([[2, 1], [1, 1]]), sp.zeros(2), sp.diag(-5, 6)
    >>> found = mechanical_observability(M, zero, K, sp.Matrix([[1, 3]]), sp.zeros(1, 2))
    >>> found.rank, found.order, [m.eigenvalue for m in found.hidden_modes]
    (2, 4, [-sqrt(3), sqrt(3)])
    """
    H1, H2 = _output_pair(H1, H2)
    M, D, K = _read_square(M, D, K, optional=(H1, H2))
    n = M.shape[0]
    H1, H2 = (_read_rows(H, n, name) for H, name in ((H1, "H1"), (H2, "H2")))
    if H1.shape != H2.shape:
        raise ValueError(f"H2: expected the shape of H1, {tuple(H1.shape)}, got {tuple(H2.shape)}")
    return _test(M, D, K, H1, H2, "observable", lambda v: v)


def mechanical_controllability(
    M: MatrixLike, D: MatrixLike, K: MatrixLike, L: MatrixLike
) -> RankTest:
    """Decide whether M x'' + D x' + K x = L u is controllable.

    Parameters
    ----------
    M, D, K : matrix_like, shape (n, n)
        Matrices of inertia, damping and stiffness; exact, with symbols (generic), or floats.
    L : matrix_like, shape (n, s)
        Matrix of the control.

    Returns
    -------
    RankTest
        The vectors of its modes are rows w of length n with w (M l^2 + D l + K) = 0, w L = 0.

    Raises
    ------
    ValueError
        As `mechanical_observability`.

    Notes
    -----
    MATLAB: ``ctrb`` of the state form. Source: Theorem 2.6 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> M, zero, K = sp.Matrix([[2, 1], [1, 3]]), sp.zeros(2), sp.Matrix([[3, 1], [1, -2]])
    >>> mechanical_controllability(M, zero, K, sp.Matrix([2, 1])).holds
    True
    """
    M, D, K = _read_square(M, D, K, optional=(L,))
    if isinstance(M, np.ndarray):
        L = read_float_matrix(L, "L")
        L = L[:, None] if L.ndim == 1 else L
    else:
        L = read_exact_matrix(L, "L", flat="column")
    if len(L.shape) != 2 or L.shape[0] != M.shape[0] or not L.shape[1]:
        raise ValueError(
            f"L: expected a matrix with {M.shape[0]} rows, one for each coordinate, got shape "
            f"{tuple(L.shape)}"
        )
    return _test(M.T, D.T, K.T, L.T, 0 * L.T, "controllable", lambda v: v.T)


def first_order_form(
    M: MatrixLike,
    D: MatrixLike,
    K: MatrixLike,
    L: MatrixLike | None = None,
    H1: MatrixLike | None = None,
    H2: MatrixLike | None = None,
) -> tuple[Matrix, Matrix | None, Matrix | None]:
    """Return the first-order form (A, B, H) of a mechanical system in the state (x, x').

    Parameters
    ----------
    M, D, K : matrix_like, shape (n, n)
        Matrices of inertia, damping and stiffness; exact, with symbols (generic), or floats.
    L : matrix_like, shape (n, s), optional
        Matrix of the control; without it B is None.
    H1, H2 : matrix_like, shape (t, n), optional
        Matrices of the output; without both H is None.

    Returns
    -------
    A : matrix, shape (2n, 2n)
        [[0, I], [-M^-1 K, -M^-1 D]].
    B : matrix, shape (2n, s), or None
        (0; M^-1 L).
    H : matrix, shape (t, 2n), or None
        (H1, H2).

    Raises
    ------
    ValueError
        If shapes do not fit, or for a singular M: then the state is smaller.

    Notes
    -----
    MATLAB: ``ss`` of a second-order model.

    Examples
    --------
    >>> import sympy as sp
    >>> A, B, H = first_order_form(sp.eye(1), sp.Matrix([[3]]), sp.Matrix([[2]]), L=[1], H1=[[1]])
    >>> A, B.T, H
    (Matrix([
    [ 0,  1],
    [-2, -3]]), Matrix([[0, 1]]), Matrix([[1, 0]]))
    """
    optional = [m for m in (L, H1, H2) if m is not None]
    M, D, K = _read_square(M, D, K, optional=optional)
    n, floating = M.shape[0], isinstance(M, np.ndarray)
    singular = np.linalg.cond(M) > 1e14 if floating else sp.simplify(M.det()) == 0
    if singular:
        raise ValueError(
            "M: expected an invertible matrix; with a singular one some accelerations drop out: "
            "remove these coordinates first, or ask mechanical_observability, which needs no "
            "inverse"
        )
    if floating:
        A = np.block(
            [[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]]
        )
    else:
        mass_inverse = exact.inverse(M)
        A = sp.Matrix(
            sp.BlockMatrix(
                [
                    [sp.zeros(n), sp.eye(n)],
                    [exact.product(-mass_inverse, K), exact.product(-mass_inverse, D)],
                ]
            )
        )
    B = H = None
    if L is not None:
        L = (
            read_float_matrix(L, "L").reshape(n, -1)
            if floating
            else read_exact_matrix(L, "L", flat="column")
        )
        if L.shape[0] != n:
            raise ValueError(f"L: expected a matrix with {n} rows, got shape {tuple(L.shape)}")
        B = (
            np.vstack([0 * L, np.linalg.solve(M, L)])
            if floating
            else sp.Matrix.vstack(0 * L, exact.product(mass_inverse, L))
        )
    if H1 is not None or H2 is not None:
        H1, H2 = (_read_rows(h, n, name) for h, name in zip(_output_pair(H1, H2), ("H1", "H2")))
        if floating:
            H1, H2 = read_float_matrix(H1, "H1"), read_float_matrix(H2, "H2")
        H = np.hstack([H1, H2]) if floating else sp.Matrix.hstack(H1, H2)
    return A, B, H


def _output_pair(H1, H2):
    """Return H1 and H2, of which one may be left out as zero."""
    if H1 is None and H2 is None:
        raise ValueError("H1: expected a matrix (only one of H1, H2 may be None)")
    return (
        (0 * _matrix(H2), H2) if H1 is None else (H1, 0 * _matrix(H1)) if H2 is None else (H1, H2)
    )


def _matrix(H):
    return read_float_matrix(H, "H1") if has_floats(H) else read_exact_matrix(H, "H1")


def _read_square(M, D, K, optional):
    """Return M, D, K of one size, all exact, or all floats if anything in the system is."""
    matrices = {"M": M, "D": D, "K": K}
    if any_floats(M, D, K, *optional):
        read = {name: read_float_matrix(m, name) for name, m in matrices.items()}
    else:
        read = {name: read_exact_matrix(m, name) for name, m in matrices.items()}
    n = read["M"].shape[0]
    for name, m in read.items():
        if tuple(m.shape) != (n, n) or not n:
            raise ValueError(
                f"{name}: expected a square matrix of the size of M, got shape {tuple(m.shape)}"
            )
    return tuple(read.values())


def _read_rows(H, n, name):
    H = np.atleast_2d(read_float_matrix(H, name)) if has_floats(H) else read_exact_matrix(H, name)
    if len(H.shape) != 2 or H.shape[1] != n or not H.shape[0]:
        raise ValueError(
            f"{name}: expected a matrix with {n} columns, one for each coordinate, got shape "
            f"{tuple(H.shape)}"
        )
    return H


def _test(M, D, K, H1, H2, word, orient):
    if isinstance(M, np.ndarray):
        A, _, H = first_order_form(
            M, D, K, H1=read_float_matrix(H1, "H1"), H2=read_float_matrix(H2, "H2")
        )
        return float_test(A, H, word, lambda v: orient(v[: len(M)]))
    pencil = (M * LAMBDA**2 + D * LAMBDA + K).applyfunc(sp.expand)
    determinant = sp.expand(exact.determinant(pencil))
    if sp.simplify(determinant) == 0:
        raise ValueError(
            "M: det(M l^2 + D l + K) vanishes identically, so the equations do not determine the "
            "motion"
        )
    stacked = sp.Matrix.vstack(pencil, (H1 + LAMBDA * H2).applyfunc(sp.expand))
    n = M.rows
    divisor = sp.Integer(0)
    for rows in combinations(range(stacked.rows), n):
        divisor = sp.gcd(
            divisor,
            sp.numer(sp.together(exact.determinant(stacked.extract(list(rows), list(range(n)))))),
        )
        if not divisor.has(LAMBDA) and divisor != 0:
            break
    order = sp.degree(sp.numer(sp.together(determinant)), LAMBDA) if determinant.has(LAMBDA) else 0
    dimensions = sp.degree(divisor, LAMBDA) if divisor.has(LAMBDA) else 0
    modes = [
        HiddenMode(m.eigenvalue, orient(m.vectors))
        for m in (hidden_modes(stacked, divisor) if dimensions else ())
    ]
    return rank_test(
        int(order - dimensions),
        int(order),
        modes,
        word,
        generic=bool(stacked.free_symbols - {LAMBDA}),
    )
