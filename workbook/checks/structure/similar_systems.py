"""Similarity of linear systems, decided from their matrices.

A matrix T with T A = A' T and H = H' T is the solution of linear equations, and an invertible one
exists if a random solution is invertible.
"""

import functools

import numpy as np

from workbook.checks.contract.tolerance import EXACT, half_unit
from workbook.checks.tools.wording import number_text, where_text


def are_similar(A, H, new_A, new_H, tolerance, reference=None, uncertainty=()):
    """Return whether T A = A' T, H = H' T has a solution T of full rank, with as many rows as A'.

    `uncertainty` holds the rounding errors of the entries of A', which has to be similar to the
    matrix `reference`.
    """
    # Decimals may have all their digits, or stand for simple fractions.
    if tolerance > 1e-6 and (
        are_similar(A, H, new_A, new_H, 1e-9)
        or are_similar(A, H, _as_fractions(new_A), _as_fractions(new_H), 1e-9)
    ):
        return True
    # With rounded entries some T is almost a solution even if an eigenvalue is wrong; the
    # characteristic polynomial shows it.
    if tolerance > 1e-6 and not _same_polynomial(new_A, reference, uncertainty):
        return False
    rows, n = len(new_A), len(A)
    weight, unit = np.linalg.norm(H), np.linalg.norm(A) + np.linalg.norm(new_A)
    weight, unit = max(weight, 1e-300), max(unit, 1e-300)
    scale = max(np.linalg.norm(new_H), 1e-300)
    row_identity, column_identity = np.eye(rows), np.eye(n)
    # Row by row: the entry (i, j) of T is number n i + j of the unknowns, in units in which H and
    # H' have the same size.
    equations = np.vstack(
        [
            (np.kron(row_identity, A.T) - np.kron(new_A, column_identity)) / unit,
            np.kron(new_H / scale, column_identity),
        ]
    )
    right_side = np.concatenate([np.zeros(rows * n), (H / weight).ravel()])
    u, sizes, v = np.linalg.svd(equations)
    count = int((sizes > (0.5 * tolerance if tolerance > 1e-6 else 1e-9)).sum())
    particular = v[:count].T.conj() @ ((u[:, :count].T.conj() @ right_side) / sizes[:count])
    if not np.linalg.norm(equations @ particular - right_side) <= max(2 * tolerance, 1e-8):
        return False
    random, free = np.random.default_rng(4), v[count:]
    for _ in range(3):
        step = free.T.conj() @ random.normal(size=len(free)) if len(free) else 0
        solution = (particular + max(np.linalg.norm(particular), 1.0) * step).reshape(rows, n)
        spread = np.linalg.svd(solution, compute_uv=False)
        if spread.size == 0 or spread[-1] > (1e-3 if tolerance > 1e-6 else 1e-8) * spread[0]:
            return True
    return False


def _same_polynomial(claimed, true, uncertainty):
    """Return whether two matrices have the same characteristic polynomial.

    The entries of the first are known up to `uncertainty`.
    """
    coefficients = np.poly(claimed)
    allowed = EXACT * max(np.linalg.norm(claimed), np.linalg.norm(true)) ** np.arange(
        len(coefficients)
    )
    for i, j in np.ndindex(claimed.shape):
        step = np.zeros(claimed.shape)
        step[i, j] = uncertainty[i, j]
        allowed = allowed + abs(np.poly(claimed + step) - coefficients)
    # A hundredth for products of two such steps.
    return bool((abs(coefficients - np.poly(true)) <= 1.01 * allowed).all())


@functools.partial(np.vectorize, otypes=[complex])
def _as_fractions(number):
    """Return the simplest fraction (denominator up to 60) equal to a number to three digits.

    If there is none, return the number itself.
    """
    size = abs(number)
    if not size or number.imag:
        return number
    fractions = (round(number.real * q) / q for q in range(1, 61))
    return next((x for x in fractions if abs(x - number.real) <= half_unit(size)), number)


def difference_text(A, new_A, part, part_output, values, side):
    """Return a text on the property in which a system differs from the given one."""
    if A is not None:
        claimed, true = np.poly(new_A), np.poly(A)
        if not np.allclose(claimed, true, rtol=1e-6, atol=1e-6 * max(abs(true))):
            point = point_of_difference(claimed, true)
            true_value, claimed_value = (
                number_text(np.polyval(poly, point)) for poly in (true, claimed)
            )
            message = (
                f"det(lambda I - A) at lambda = {point} is {claimed_value} for your matrix, and "
                "not for the given one: the characteristic polynomials differ"
                if true_value != claimed_value
                else "by rounding, your matrix has other eigenvalues; exact numbers would be safe"
            )
            return f"no change of variables turns the given system into yours: {message}{where_text(values)}"
    if not _observable(part, part_output):
        return f"in your system the part xi is not {side.part}{where_text(values)}"
    return f"no change of variables turns the given system into yours{where_text(values)}: " + (
        "started at zero, the same control does not lead both to corresponding states"
        if side.by_control
        else "its outputs z(t) are not those of the given system"
    )


def point_of_difference(claimed, true):
    """Return a point where two polynomials differ; not 0, where a value is a coefficient."""
    return max(
        (1, -1, 2, -2, 3, 5),
        key=lambda x: min(abs(np.polyval(claimed - true, x)), 0.5 * max(abs(claimed - true))),
    )


def _observable(A, H):
    """Return whether a small system of floats is observable, by its scaled Kalman matrix."""
    if not len(A):
        return True
    blocks = [H / max(np.linalg.norm(H), 1e-300)]
    for _ in range(len(A) - 1):
        blocks.append(blocks[-1] @ A / max(np.linalg.norm(A), 1e-300))
    return bool(np.linalg.svd(np.vstack(blocks), compute_uv=False)[-1] > 1e-6)
