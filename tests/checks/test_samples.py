"""Halving many intervals at once is halving each of them."""

import numpy as np
import pytest

from trajlib.checks.tools.searching import bisected


@pytest.mark.parametrize("rows", [1, 12, 50, 300])
@pytest.mark.parametrize("turns", [0, 1, 7, 40])
def test_halving_several_times_in_one_call_is_halving(rows, turns):
    """Bit for bit, also where what is sought changes more than once."""
    chance = np.random.default_rng(rows)
    first, last, phase = chance.uniform(0, 1, rows), chance.uniform(2, 9, rows), chance.uniform(0, 6, rows)

    def like_first(places, which):
        return np.sin(3 * places + phase[which]) * np.sin(3 * first[which] + phase[which]) > 0

    low, high = first, last
    for _ in range(turns):
        middle = (low + high) / 2
        same = like_first(middle, np.arange(rows))
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = bisected(like_first, first, last, turns)
    assert (found[0] == low).all() and (found[1] == high).all()
