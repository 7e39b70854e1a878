"""What the derivatives of z at t = 0 say of the unknowns of a system, as the rows of a matrix N:
those with N v = 0 are not seen. By Kalman's matrix, or by the product rule."""

import functools

import sympy as sp

from workbook.systems import Mechanical, Varying, WithError


def seen(system):
    if isinstance(system, WithError):
        return _with_error(system)
    if isinstance(system, Varying):
        return _varying(system.A, system.H, system.time)
    A, _, H = in_states(system)
    return kalman(A, H)


def reached(system):
    """The same for the rows w with w B = w A B = ... = 0, transposed."""
    A, B, _ = in_states(system)
    return kalman(A.T, B.T)


def in_states(system):
    """(A, B, H), those of a mechanical system by its equations solved for the accelerations."""
    if not isinstance(system, Mechanical):
        return system.A, getattr(system, "B", None), system.H
    n, solve = system.M.rows, system.M.LUsolve
    A = sp.Matrix(sp.BlockMatrix([[sp.zeros(n), sp.eye(n)], [-solve(system.K), -solve(system.D)]]))
    return (
        A,
        sp.zeros(n, system.L.cols).col_join(solve(system.L)),
        sp.Matrix.hstack(system.H1, system.H2),
    )


def kalman(A, H):
    return _kalman(A.as_immutable(), H.as_immutable())


@functools.lru_cache(maxsize=32)
def _kalman(A, H):
    """The same for all mutants of an answer."""
    return sp.ImmutableMatrix.vstack(*[H * A**k for k in range(A.rows)])


def _with_error(system):
    """The rows for (x(0), C), as many as decide whether z vanishes."""
    return sp.Matrix.vstack(
        *(
            (system.H * system.A**k).row_join(system.c * system.S**k * system.start)
            for k in range(system.A.rows + system.S.rows)
        )
    )


def _varying(A, H, time):
    """The rows for x(0): twelve derivatives are enough for a plane and a sine."""
    rows = [H]
    for _ in range(11):
        rows.append(rows[-1].diff(time) + rows[-1] * A)
    return sp.Matrix.vstack(*(row.subs(time, 0) for row in rows)).expand()
