"""Margins that checks compute, against python-control and the roots of the closed loop."""

import control
import numpy as np
import pytest
import sympy as sp

from workbook.checks.references.loop_functions import loop_at
from workbook.systems import Linear


def random_loops(count, seed):
    """Random plants with the gain of a stable loop."""
    random = np.random.default_rng(seed)
    while count:
        n = int(random.integers(1, 5))
        A, B, K = (random.integers(-5, 6, size) for size in ((n, n), (n, 1), (1, n)))
        if K.any() and np.linalg.eigvals(A + B @ K).real.max() < -0.05:
            count -= 1
            yield A, B, K


@pytest.mark.parametrize("A, B, K", [*random_loops(15, seed=3)])
def test_random_loops(A, B, K):
    numbers = loop_at({}, Linear(sp.Matrix(A), sp.Matrix(B)), sp.Matrix(K))
    loop = control.ss(A, B, -K, 0)
    factors, degrees, distance, _, frequencies, _ = control.stability_margins(loop, returnall=True)
    low, high = numbers.gain
    assert high == pytest.approx(min((f for f in factors if f > 1), default=np.inf))
    assert low == pytest.approx(max((f for f in factors if 0 < f < 1), default=0))
    assert numbers.phase == pytest.approx(min(np.radians(abs(degrees)), default=np.inf))
    delays = np.radians(degrees % 360) / frequencies
    assert numbers.delay == pytest.approx(min(delays, default=np.inf))
    ends = [1, abs(1 + (K @ np.linalg.solve(A, B)).item())]
    assert numbers.disk == pytest.approx(min([*distance, *ends]))
    # a delay slightly longer than the margin gives growing motions, found by following the roots
    if np.isfinite(numbers.delay):
        (root, *_) = numbers.roots_with_delay(1.05 * numbers.delay)
        value = -(K @ np.linalg.solve(root * np.eye(len(A)) - A, B)).item()
        assert value * np.exp(-1.05 * root * numbers.delay) == pytest.approx(-1, abs=1e-6)
        assert root.real > 0
    near = numbers.frequency_within(1.2 * numbers.disk)
    assert abs(1 + complex(loop(1j * near))) < 1.2 * numbers.disk
