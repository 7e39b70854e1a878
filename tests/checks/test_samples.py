"""Every case that an answer distinguishes is met by a sample; what is found of the data is found
once; halving many intervals at once is halving each of them."""

import numpy as np
import pytest
import sympy as sp

from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.samples import cached_points, in_every_case, sample_values

x, y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    "added",
    [
        sp.Piecewise((0, x < 50), (1, True)),
        sp.Piecewise((0, sp.Or(x < 70, x > 71)), (1, True)),
        sp.Max(x - 50, 0),
        sp.Abs(x + 60) - x - 60,
        1 - sp.sign(60 - x),
        sp.Heaviside(-x - 80),
        sp.Piecewise((0, sp.Ne(x, 7)), (1, True)),
        sp.Min(x * y, 90) - x * y,
        sp.Piecewise((0, sp.Abs(x) < 50), (1, True)),
        sp.Piecewise((0, sp.exp(y) < 10**9), (1, True)),
        sp.Piecewise((0, sp.sqrt(sp.Abs(x * y)) < 1000), (1, True)),
    ],
    ids=str,
)
def test_every_case_of_an_answer_is_met(added):
    samples = sample_values([x, y])
    assert all(added.subs(values) == 0 for values in samples)
    more = in_every_case(samples, [sp.Matrix([x * y + added])])
    assert {bool(added.subs(values) == 0) for values in more} == {True, False}
    assert in_every_case(samples, x * y) == samples
    assert in_every_case(samples, x + added, sp.And(abs(x) <= 3, abs(y) <= 3)) == samples


def test_places_are_looked_for_once():
    asked = []

    @cached_points
    def points(symbols, domain=None, far=False):
        asked.append((symbols, domain, far))
        yield dict.fromkeys(symbols, 2.0 if far else 1.0)

    (point,) = points([x, y], {x: sp.Interval(0, 3)})
    point[x] = 0.5  # who takes a point may change it
    assert points([x, y], {x: sp.Interval(0, 3)}) == [{x: 1.0, y: 1.0}] and len(asked) == 1
    assert points([x, y], {x: sp.Interval(0, 4)}) == [{x: 1.0, y: 1.0}] and len(asked) == 2
    assert (
        points([x, y], far=True) == [{x: 2.0, y: 2.0}]
        and points([x]) == [{x: 1.0}]
        and len(asked) == 4
    )


@pytest.mark.parametrize("as_matrix", [sp.Matrix, sp.ImmutableMatrix, list])
@pytest.mark.parametrize(
    "limit",
    [sp.Piecewise((0, sp.Eq(x, 7)), (x, True)), sp.Piecewise((x, sp.Ne(x - 7, 0)), (0, True))],
    ids=str,
)
def test_a_limit_in_one_entry_obliges_no_other(limit, as_matrix):
    samples = sample_values([x, y])
    assert in_every_case(samples, as_matrix([limit, y / (x - 7)])) == samples
    # a value everywhere; left out in the case that is for it
    for others in ([y], [limit / (x - 7)]):
        assert in_every_case(samples, as_matrix([limit, *others]))[len(samples)][x] == 7


@pytest.mark.parametrize("rows", [1, 12, 50, 300])
@pytest.mark.parametrize("turns", [0, 1, 7, 40])
def test_halving_several_times_in_one_call_is_halving(rows, turns):
    """Bit for bit, also where what is sought changes more than once."""
    chance = np.random.default_rng(rows)
    first, last, phase = (
        chance.uniform(0, 1, rows),
        chance.uniform(2, 9, rows),
        chance.uniform(0, 6, rows),
    )

    def like_first(points, which):
        return np.sin(3 * points + phase[which]) * np.sin(3 * first[which] + phase[which]) > 0

    low, high = first, last
    for _ in range(turns):
        middle = (low + high) / 2
        same = like_first(middle, np.arange(rows))
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = bisect(like_first, first, last, turns)
    assert (found[0] == low).all() and (found[1] == high).all()
