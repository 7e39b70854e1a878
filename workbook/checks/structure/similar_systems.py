"""Similarity of linear systems, decided from their matrices.

A matrix T with T A = A' T and H = H' T is the solution of linear equations, and an invertible one
exists if a random solution is invertible.
"""

import functools

import numpy as np

from workbook.checks.contract.tolerance import EXACT, half_unit
from workbook.checks.tools.wording import number_text, where_text


def are_similar(A, H, new_A, new_H, tolerance, similar=None, open_=()):
    """Whether T A = A' T, H = H' T has a solution T of full rank; T has as many rows as A'.
    Decimals leave A' `open_` by so much; it has to be similar to the matrix `similar`."""
    # Decimals may have all their digits, or stand for simple fractions.
    if tolerance > 1e-6 and (
        are_similar(A, H, new_A, new_H, 1e-9)
        or are_similar(A, H, _as_fractions(new_A), _as_fractions(new_H), 1e-9)
    ):
        return True
    # Rounded entries leave some T almost a solution for an eigenvalue that is off; the
    # characteristic polynomial tells.
    if tolerance > 1e-6 and not _same_polynomial(new_A, similar, open_):
        return False
    rows, n = len(new_A), len(A)
    weight, unit = (
        max(np.linalg.norm(H), 1e-300),
        max(np.linalg.norm(A) + np.linalg.norm(new_A), 1e-300),
    )
    scale = max(np.linalg.norm(new_H), 1e-300)
    left, right = np.eye(rows), np.eye(n)
    # Row by row: the entry (i, j) of T is number n i + j of the unknowns, in units in which H and
    # H' have the same size.
    equations = np.vstack(
        [(np.kron(left, A.T) - np.kron(new_A, right)) / unit, np.kron(new_H / scale, right)]
    )
    sides = np.concatenate([np.zeros(rows * n), (H / weight).ravel()])
    u, sizes, v = np.linalg.svd(equations)
    count = int((sizes > 0.5 * tolerance).sum()) if tolerance > 1e-6 else int((sizes > 1e-9).sum())
    particular = v[:count].T.conj() @ ((u[:, :count].T.conj() @ sides) / sizes[:count])
    if not np.linalg.norm(equations @ particular - sides) <= max(2 * tolerance, 1e-8):
        return False
    random, free = np.random.default_rng(4), v[count:]
    for _ in range(3):
        step = free.T.conj() @ random.normal(size=len(free)) if len(free) else 0
        spread = np.linalg.svd(
            (particular + max(np.linalg.norm(particular), 1.0) * step).reshape(rows, n),
            compute_uv=False,
        )
        if spread.size == 0 or spread[-1] > (1e-3 if tolerance > 1e-6 else 1e-8) * spread[0]:
            return True
    return False


def _same_polynomial(claimed, true, open_):
    """Whether two matrices have the same characteristic polynomial, up to what the entries of the
    first are off by."""
    own = np.poly(claimed)
    allowed = EXACT * max(np.linalg.norm(claimed), np.linalg.norm(true)) ** np.arange(len(own))
    for i, j in np.ndindex(claimed.shape):
        step = np.zeros(claimed.shape)
        step[i, j] = open_[i, j]
        allowed = allowed + abs(np.poly(claimed + step) - own)
    # A hundredth for products of two such steps.
    return bool((abs(own - np.poly(true)) <= 1.01 * allowed).all())


@functools.partial(np.vectorize, otypes=[complex])
def _as_fractions(number):
    """The fraction with the smallest denominator up to 60 that the number is to three digits; else
    the number itself."""
    size = abs(number)
    if not size or number.imag:
        return number
    return next(
        (
            round(number.real * q) / q
            for q in range(1, 61)
            if abs(round(number.real * q) / q - number.real) <= half_unit(size)
        ),
        number,
    )


def difference_text(A, new_A, part, part_output, values, side):
    """The property in which a system differs from the given one."""
    if A is not None:
        own, true = np.poly(new_A), np.poly(A)
        if not np.allclose(own, true, rtol=1e-6, atol=1e-6 * max(abs(true))):
            at = place_of_difference(own, true)
            there, here = (number_text(np.polyval(poly, at)) for poly in (true, own))
            message = (
                f"det(lambda E - A) at lambda = {at} is {here} for your matrix, and another number "
                "for the given one"
                if there != here
                else "by rounding, your matrix has other eigenvalues; exact numbers would be safe"
            )
            return f"no change of variables turns the given system into yours: {message}{where_text(values)}"
    if not _observable(part, part_output):
        return f"in your system the part xi is not {side.part}{where_text(values)}"
    if side.by_control:
        return (
            f"no change of variables turns the given system into yours{where_text(values)}: "
            "controls have another influence there"
        )
    return f"no change of variables turns the given system into yours{where_text(values)}: it has other functions z(t)"


def place_of_difference(own, true):
    """Return where two polynomials differ; not 0, where the value is a coefficient of each."""
    return max(
        (1, -1, 2, -2, 3, 5),
        key=lambda x: min(abs(np.polyval(own - true, x)), 0.5 * max(abs(own - true))),
    )


def _observable(A, H):
    """Whether a small system of floats is observable, by Kalman's matrix with blocks of one
    size."""
    if not len(A):
        return True
    blocks = [H / max(np.linalg.norm(H), 1e-300)]
    for _ in range(len(A) - 1):
        blocks.append(blocks[-1] @ A / max(np.linalg.norm(A), 1e-300))
    return bool(np.linalg.svd(np.vstack(blocks), compute_uv=False)[-1] > 1e-6)
