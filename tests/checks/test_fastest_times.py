"""The optimum by support functions against laws and times in closed form, close to where the
control changes."""

import numpy as np
import pytest
import sympy as sp

from workbook.checks.references.optima.convex_targets import ConvexTarget
from workbook.checks.references.optima.fastest_times import FastestTimes
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.references.optima.sampled_optimum import sampled_optimum

x1, x2, u = STATE = sp.symbols("x1 x2 u", real=True)
#: How far from a curve a start lies, as a share of the size of its state.
CLOSEST, FARTHEST = 1e-4, 0.1


def _optimum(acceleration, target):
    plane = [x1, x2]
    return FastestTimes(
        Plant([x2, acceleration], plane, u, (-1, 1)), ConvexTarget(target, plane, [], [()])
    )


def _beside(random, size, count):
    signs = random.choice((-1, 1), count)
    return signs * np.exp(random.uniform(np.log(CLOSEST), np.log(FARTHEST), count)) * (0.3 + size)


def _semicircles(x):
    return -np.sign(x) * np.sqrt(1 - (np.mod(abs(x), 2) - 1) ** 2)


@pytest.mark.parametrize("size", [4, 12, 16, 24, 40])
def test_an_oscillator_far_out_begins_as_the_semicircles_say(size):
    optimum, random = _optimum(u - x1, [x1, x2]), np.random.default_rng(size)
    angle = random.uniform(0, 2 * np.pi, 300)
    spread = (
        size
        * random.uniform(0.8, 1.2, 300)[:, None]
        * np.column_stack([np.cos(angle), np.sin(angle)])
    )
    positions = random.uniform(-size, size, 300)
    near = np.column_stack(
        [positions, _semicircles(positions) + _beside(random, abs(positions), 300)]
    )
    starts = np.concatenate([spread, near])
    found = optimum.solve(starts, np.zeros(600, dtype=int), far=True)
    assert (found.control == -np.sign(starts[:, 1] - _semicircles(starts[:, 0]))).all()
    assert found.time.max() > 1.4 * size


def test_a_mass_beside_its_switching_curve():
    optimum, random = _optimum(u, [x1, x2]), np.random.default_rng(1)
    v = random.uniform(-3, 3, 600)
    starts = np.column_stack([-v * abs(v) / 2 + _beside(random, abs(v), 600), v])
    found = optimum.solve(starts, np.zeros(600, dtype=int))
    side = np.sign(starts[:, 0] + v * abs(v) / 2)
    assert (found.control == -side).all()
    np.testing.assert_allclose(
        found.time, side * v + 2 * np.sqrt(side * starts[:, 0] + v**2 / 2), rtol=1e-7
    )


def test_inside_a_parabola_beside_the_curve_where_motions_part():
    optimum, random = _optimum(u, [x2**2 - x1]), np.random.default_rng(2)
    v = random.uniform(0.1, 2, 600)
    starts = np.column_stack([13 * v**2 + _beside(random, 13 * v**2, 600), v])
    found = optimum.solve(starts, np.zeros(600, dtype=int))
    x = starts[:, 0]
    pushed, braked = v + np.sqrt((2 * x + v**2) / 3), -v + np.sqrt(2 * x - v**2)
    np.testing.assert_allclose(found.time, np.minimum(pushed, braked), rtol=1e-7)
    assert (found.control == np.where(pushed < braked, -1, 1)).all()


@pytest.mark.parametrize("push", [u, u - x1, u + x1, u - x2, u - x1 - x2 / 5], ids=str)
def test_extremals_followed_back_are_the_fastest_motions(push):
    truth = sampled_optimum((x2, push), (x1, x2), u, (-1, 1), (x1, x2), (), None)
    lanes, changes = truth.extremals()
    size = np.abs(lanes.x).max(axis=1)
    known = lanes.take((size > 0.05) & (size < 8))
    assert len(known.x) > 15 and size.min() < 1e-4 and size.max() > 50
    np.testing.assert_array_equal(truth.solve(known.x, known.case, far=True).control, known.control)
    assert len(changes.x) > 15


def test_extremals_are_not_followed_back_from_where_no_control_can_stay():
    assert sampled_optimum((x2, u), (x1, x2), u, (1, 2), (x1, x2), (), None).extremals() is None
    assert sampled_optimum((x2, u), (x1, x2), u, (-1, 1), (x1,), (), None).extremals() is None
