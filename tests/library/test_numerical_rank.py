"""One rule decides for all modules which singular values of floats are zero."""

import numpy as np
import pytest

from trajlib._numerical_rank import zero_level
from trajlib.estimation import least_squares
from trajlib.invariant import InvariantEstimator
from trajlib.solvability import analyse


def nearly_parallel(share):
    """Two columns of norm 1 over 20 rows, whose least singular value is `share` of the greatest."""
    first, second = np.linalg.qr(np.random.default_rng(0).standard_normal((20, 2)))[0].T
    angle = 2 * np.arctan(share)
    return np.column_stack([first, np.cos(angle) * first + np.sin(angle) * second])


def through(column):
    return lambda t: column[np.asarray(t, dtype=int)]


def by_least_squares(H):
    least_squares(H, np.ones(20))


def by_invariant_weights(H):
    InvariantEstimator(range(20), [through(c) for c in H.T]).weights(lambda y: y(0))


@pytest.mark.parametrize("decides", [by_least_squares, by_invariant_weights])
def test_columns_are_told_apart_above_the_level_only(decides):
    decides(nearly_parallel(3 * zero_level(20, 2)))
    with pytest.raises(ValueError):
        decides(nearly_parallel(zero_level(20, 2) / 3))


def test_a_proved_rank_needs_as_much():
    """The level that solvability proves for six unknowns is of the same size."""
    H = np.linalg.qr(np.random.default_rng(1).standard_normal((100, 6)))[0]
    level = analyse(H).level
    assert 0.3 < level / zero_level(100, 6) < 3
