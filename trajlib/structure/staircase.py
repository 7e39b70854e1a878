"""The staircase form of a pair (A, H), by orthogonal transformations only.

The first coordinates are those that H observes; the next ones are those that their derivatives
observe besides, and so on, until a step adds nothing: the remaining coordinates are unobservable.
Every step is a rank decision by singular values, and the whole is exact for a pair that differs
from (A, H) by rounding (C. C. Paige, Properties of numerical algorithms related to computing
controllability, 1981; P. Van Dooren, The generalized eigenstructure problem in linear system
theory, 1981).

A staircase without a small step may still hide a state, where many small steps multiply: `nearest`
looks for those.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Staircase:
    """Orthogonal `basis` Q, `matrix` Q^T A Q, `sizes` of the steps, their least singular values."""

    basis: np.ndarray
    matrix: np.ndarray
    sizes: tuple
    heights: tuple

    @property
    def rank(self):
        return sum(self.sizes)


def staircase(A, H, limit):
    """Return the `Staircase` of float matrices; singular values up to `limit` count as zero."""
    n = len(A)
    basis, matrix, shown = np.eye(n), A.copy(), H
    sizes, heights, done = [], [], 0
    while done < n:
        _, values, right = np.linalg.svd(shown)
        size = int(np.count_nonzero(values > limit))
        if not size:
            break
        basis[:, done:] = basis[:, done:] @ right.T
        matrix[:, done:] = matrix[:, done:] @ right.T
        matrix[done:] = right @ matrix[done:]
        sizes.append(size)
        heights.append(float(values[size - 1]))
        shown = matrix[done : done + size, done + size :]
        done += size
    return Staircase(basis, matrix, tuple(sizes), tuple(heights))
