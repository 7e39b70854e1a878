"""Canonical forms by observation (2.5) and by control (2.4), and the changes of variables that lead to them; the matrix
in the basis b, A b, A^2 b, ...

A form is judged by its shape and by its characteristic polynomial; a change of variables by what it makes of the
equations. The form by control is the other one of the transposed matrix, with rows and columns in reverse order; the
matrix in the basis of the chain is the form by observation with rows and columns in reverse order.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import same, share
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.tools.values import matrix_at
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.invariant_subspaces import characteristic_coefficients, to_floats
from trajlib.checks.truths.pairs import pair_of


@dataclass(frozen=True)
class _Form:
    """The words of one of the forms; `place` names the entry that stands at (i, j) of the form by observation of order
    n."""

    shape: str
    ones_and_zeros: str
    place: Callable
    # what a matrix is that has the shape when flipped, when transposed, when its rows and columns are reversed
    relatives: tuple


_BELOW = "your matrix has its ones below the diagonal"
BY_OBSERVATION = _Form("the shape (2.5)", "ones above the diagonal and zeros elsewhere, but for the first column",
                       lambda i, j, n: (i + 1, j + 1), ("this has the shape (2.4)", _BELOW, _BELOW))
BY_CONTROL = _Form("the shape (2.4)", "ones above the diagonal and zeros elsewhere, but for the last row",
                   lambda i, j, n: (n - j, n - i), ("this has the shape (2.5)", _BELOW, _BELOW))
OF_CHAIN = _Form("the shape that A g^i = g^(i+1) gives",
                 "ones below the diagonal and zeros elsewhere, but for the last column",
                 lambda i, j, n: (n - i, n - j), ("your matrix has its coefficients in the first row",
                                                  "this has the shape (2.4)",
                                                  "this has the shape (2.5)"))


@judged
def observer_canonical_matrix(answer, A, parameters=()):
    """The matrix of the canonical form by observation (2.5): its first column, ones above the diagonal, and the
    eigenvalues of A."""
    claim = coercion.as_matrix(answer, parameters, A.shape)
    return judge_form(claim, pair_of(A, A[:1, :], parameters), BY_OBSERVATION)


@judged
def controller_canonical_matrix(answer, A, parameters=()):
    """The matrix of the canonical form by control (2.4): its last row, ones above the diagonal, and the eigenvalues of
    A."""
    claim = coercion.as_matrix(answer, parameters, A.shape)
    return judge_form(_flipped(claim), pair_of(A.T, A.T[:1, :], parameters), BY_CONTROL)


@judged
def observer_canonical_transformation(answer, A, H, parameters=()):
    """The matrix T of xi = T x that leads to the canonical form by observation (2.5): z = xi1, xi1' = alpha_n xi1 +
    xi2, and so on."""
    claim = coercion.as_matrix(answer, parameters, A.shape)
    said = [f"xi{k}" for k in range(1, A.rows + 1)]
    return _judge_change(claim, pair_of(A, H, parameters), said, by_rows=True)


@judged
def controller_canonical_basis(answer, A, B, parameters=()):
    """The matrix P of x = P xi that leads to the canonical form by control (2.4): its last column is b, and A P = P
    A0."""
    claim = coercion.as_matrix(answer, parameters, A.shape)
    said = [f"column {k}" for k in range(A.rows, 0, -1)]
    return _judge_change(claim.T[::-1, :], pair_of(A.T, B.T, parameters), said, by_rows=False)


@judged
def chain_basis_matrix(answer, A, B, parameters=()):
    """The matrix of a controllable system with one control in the basis g^1 = b, g^2 = A b, ..., g^n = A^(n-1) b.

    Column i holds the coordinates of A g^i: ones below the diagonal, and the last column as the eigenvalues of A
    demand.
    """
    claim, pair = coercion.as_matrix(answer, parameters, A.shape), pair_of(A.T, B.T, parameters)
    if pair.outputs != 1 or any(pair.unseen):
        raise ValueError("b, A b, A^2 b, ... are no basis")
    return judge_form(claim[::-1, ::-1], pair, OF_CHAIN)


def judge_form(claim, pair, form):
    """Shape and characteristic polynomial of a matrix that is to be the form by observation of the pair's A."""
    tolerance = share(claim)
    for values, place in pair.samples:
        said, rows = matrix_at(claim, values), pair.at(place)[0]
        shape_of_form(said, tolerance, form, where_text(values))
        true = np.array([float(c) for c in characteristic_coefficients(rows)])
        own = np.array([1, *(0 - said[:, 0])])  # not -said: a zero would be told as -0
        if not same(own[1:], true[1:], list(claim[:, 0]), max(abs(true))).all():
            at = max((0, 1, -1, 2, -2, 3, 5),
                     key=lambda x: min(abs(np.polyval(own - true, x)), 0.5 * max(abs(own - true))))
            raise Wrong(f"the characteristic polynomials differ{where_text(values)}: at lambda = {at} that of A is "
                        f"{number_text(np.polyval(true, at))}, that of your matrix {number_text(np.polyval(own, at))}")
    return f"it has {form.shape} and the characteristic polynomial of A"


def shape_of_form(said, tolerance, form, where):
    """Raise `Wrong` unless a matrix of numbers, turned so that it should be the form by observation, has ones above the
    diagonal and zeros outside its first column."""
    n = len(said)
    pattern = np.eye(n, k=1)
    if _has_shape(said, pattern, tolerance):
        return
    for view, relative in zip((said.T[::-1, ::-1], said.T, said[::-1, ::-1]), form.relatives):
        if _has_shape(view, pattern, tolerance):
            raise Wrong(f"{relative}{where}; asked is {form.shape}: {form.ones_and_zeros}")
    off = abs(said - pattern) * (np.arange(n) > 0)
    i, j = map(int, np.unravel_index(np.argmax(off), off.shape))
    raise Wrong(f"the entry {form.place(i, j, n)} of your matrix is {number_text(said[i, j])}{where}; {form.shape} has "
                f"{form.ones_and_zeros}")


def _has_shape(matrix, pattern, tolerance):
    return bool((abs(matrix - pattern)[:, 1:] <= min(tolerance, 1e-6)).all())


def _judge_change(claim, pair, said_rows, by_rows):
    """The rows r of a change of variables: r1 = h, and r_k A = alpha r1 + r_(k+1) with the coefficients of A's
    polynomial."""
    n, tolerance = pair.order, share(claim)
    for values, place in pair.samples:
        if pair.unseen_at(place):
            raise ValueError("there is no canonical form: the system loses an eigenvalue")
        where = where_text(values)
        exact_rows, H = pair.at(place)
        A, h = to_floats(exact_rows, n), to_floats(H, n)[0]
        alpha = [-float(c) for c in characteristic_coefficients(exact_rows)[1:]]
        said = matrix_at(claim, values)
        true = [h]
        for k in range(n - 1):
            true.append(true[-1] @ A - alpha[k] * h)
        right = same(said, np.array(true), claim, np.linalg.norm(true, axis=1)[:, None])
        for k, row in enumerate(true):
            if right[k].all():
                continue
            _hint_at_inverse(said, np.array(true), tolerance, by_rows)
            if k == 0:
                raise Wrong((f"z has to be xi1 alone{where}, so the first row of T times x has to be z" if by_rows else
                             f"the control has to enter xi{n}' alone, with the coefficient 1{where}, so the last "
                             f"column is not free")
                            + f"; the entry {_largest(said[0] - row)} of yours does not fit")
            last, own, free = said_rows[k - 1], said_rows[k], f"alpha_{n + 1 - k}"
            if by_rows:
                raise Wrong(f"by {last}' = {free} xi1 + {own}, {own} as a combination of x is determined by "
                            f"{last}{where}; the "
                            f"coefficient of x{_largest(said[k] - row)} in your row {k + 1} does not fit")
            raise Wrong(f"A times {last} has to be {own} + {free} ({said_rows[0]}){where}; the entry "
                        f"{_largest(said[k] - row)} of your {own} does not fit")
    return ("z = xi1 and each derivative is as the form says" if by_rows else
            "the control enters the last equation alone and the equations are as the form says")


def _hint_at_inverse(said, true, tolerance, by_rows):
    own, wanted = (said, true) if by_rows else (said[::-1].T, true[::-1].T)
    with np.errstate(all="ignore"):
        if np.linalg.cond(wanted) < 1e12 and np.linalg.norm(own @ wanted - np.eye(len(true))) <= 10 * tolerance:
            raise Wrong("this is the inverse of the matrix asked: it gives "
                        + ("x from xi; asked is T in xi = T x" if by_rows else
                                                                                 "xi from x; asked is P in x = P xi"))


def _largest(difference):
    return int(np.argmax(abs(difference))) + 1


def _flipped(matrix):
    """The form by control as the form by observation: transposed, rows and columns in reverse order."""
    return matrix.T[::-1, ::-1]
