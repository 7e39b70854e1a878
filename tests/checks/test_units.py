"""What vanishes on a target is measured as the states are, in whatever units it is written."""

import pytest
import sympy as sp

from trajlib.pontryagin import Problem
from workbook.checks.references.optima.units import scaled_problem

x1, x2, u, a = sp.symbols("x1 x2 u a", real=True)


@pytest.mark.parametrize("length", [sp.Integer(10) ** k for k in (-6, -1, 0, 1, 6)])
def test_a_target_has_the_size_of_the_states(length):
    problem = Problem(
        {x1: x2, x2: u},
        {u: (-length, length)},
        {x1: a, x2: 0},
        [x1 / length, 30 * x2 / length],
        running=1 + sp.Abs(u) / length,
    )
    starts = ((a, sp.Interval(-16 * length, 16 * length)),)
    scaled, *_ = scaled_problem(problem, starts)
    assert list(scaled.terminal) == [x1, 3 * x2]
