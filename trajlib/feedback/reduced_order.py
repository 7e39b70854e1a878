"""The observer that estimates only what is not measured (Luenberger).

Take z and y = Cx for coordinates, x = Pz + Qy. Then y' = A22 y + A21 z + B2 u, and z' - A11 z - B1
u = A12 y is known of y. The estimate of y is p + Gz with

    p' = (A22 - G A12)(p + Gz) + (A21 - G A11) z + (B2 - G B1) u,

in which no derivative of z is needed; its error obeys d' = (A22 - G A12) d, and the pair (A22, A12)
is observable exactly when (A, H) is.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib._arguments.matrices import is_float_array, read_controlled, read_observed
from trajlib.feedback.gains import GainFamily, observer
from trajlib.structure import exact


@dataclass(frozen=True)
class ReducedObserver:
    """p' = `matrix` p + `by_output` z + `by_control` u, with the estimate `state_by_p` p +
    `state_by_output` z of x.

    `matrix` is that of the errors too; `family` holds the gains G and what is free in them, which
    the simplest member leaves out; `coordinates` is C, the rows of y = Cx.
    """

    matrix: sp.Matrix
    by_output: sp.Matrix
    by_control: sp.Matrix
    state_by_p: sp.Matrix
    state_by_output: sp.Matrix
    coordinates: sp.Matrix
    family: GainFamily


def reduced_observer(A, B, H, polynomial=None, symbol=None, *, eigenvalues=None, margin=None):
    """An observer of order n - m for m independent outputs, with a prescribed spectrum (MATLAB:
    place on a block).

    `A`: n x n, `B`: n x s, `H`: m x n of rank m < n, exact; the spectrum is prescribed as in
    `observer`, of order n - m. Returns `ReducedObserver`. Raises ValueError for outputs that depend
    on one another or tell the whole state, for shapes that do not fit, and as `observer` does.
    Source: added; after D. G. Luenberger.

    >>> import sympy as sp
    >>> found = reduced_observer(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), sp.Matrix([[1, 0]]), margin=2)
    >>> found.matrix, found.by_output, found.by_control
    (Matrix([[-2]]), Matrix([[-3]]), Matrix([[1]]))
    >>> found.state_by_p.T, found.state_by_output.T
    (Matrix([[0, 1]]), Matrix([[1, 2]]))
    """
    A, H = read_observed(A, H)
    if is_float_array(A):
        raise ValueError("A: expected exact matrices (SymPy)")
    B = read_controlled(A, B)[1].T
    n, m = A.rows, H.rows
    if exact.rank(H) < m or m == n:
        raise ValueError("H: expected fewer independent outputs than state variables")
    C = exact.null_columns(H).T
    T = H.col_join(C)
    back = exact.inverse(T)
    a, b = exact.product(T, A, back), exact.product(T, B)
    family = observer(
        a[m:, m:], a[:m, m:], polynomial, symbol, eigenvalues=eigenvalues, margin=margin
    )
    G = family.simplest
    matrix = exact.tidy(a[m:, m:] - G * a[:m, m:])
    return ReducedObserver(
        matrix,
        exact.tidy(matrix * G + a[m:, :m] - G * a[:m, :m]),
        exact.tidy(b[m:, :] - G * b[:m, :]),
        back[:, m:],
        exact.tidy(back[:, :m] + back[:, m:] * G),
        C,
        family,
    )
