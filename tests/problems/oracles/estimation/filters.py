"""Oracles of the checks of filters and processes: eigenvalues in any order, and again, are the same
ones; a condition for a steady filter is tried at a grid of values."""

import functools
import itertools

import numpy as np
import sympy as sp

from oracles.structure.linear_systems import same_numbers

GRID = [sp.Rational(*pair) for pair in ((-2, 1), (-1, 50), (0, 1), (1, 50), (1, 2), (1, 1))]


def steady_filter_exists(mutant, reference, process, parameters):
    """True if the condition agrees, at a grid of values, with Popov's ranks at the eigenvalues that
    floats give."""
    return all(
        bool(mutant.subs(values)) == settles
        for values, settles in _truths(process, tuple(parameters))
    )


@functools.cache
def _truths(process, parameters):
    grids = [
        [
            value
            for value in GRID
            if not ((p.is_nonnegative and value < 0) or (p.is_positive and value == 0))
        ]
        for p in parameters
    ]
    places = [dict(zip(parameters, place)) for place in itertools.product(*grids)]
    return [(values, _settles(process.subs(values))) for values in places]


def _settles(process):
    A, H, Q = (np.array(matrix, dtype=float) for matrix in (process.A, process.H, process.Q))
    for value in np.linalg.eigvals(A):
        rate, pencil = (
            (abs(value) - 1 if process.discrete else value.real),
            value * np.eye(len(A)) - A,
        )
        if (rate > -1e-9 and _loses_rank(np.vstack([pencil, H]))) or (
            abs(rate) < 1e-9 and _loses_rank(np.hstack([pencil, Q]))
        ):
            return False
    return True


def _loses_rank(matrix):
    return np.linalg.svd(matrix, compute_uv=False)[-1] < 1e-9


ORACLES = {
    "covariance_exponents": same_numbers,
    "error_eigenvalues": same_numbers,
    "steady_filter_exists": steady_filter_exists,
}
