"""Kinks of expressions: corners, jumps and steep transitions between sample points are found."""

import numpy as np
import pytest
import sympy as sp

from workbook.checks.tools.kinks import points_at_kinks

x, y = sp.symbols("x y", real=True)
POINTS = [{x: a, y: b} for a, b in ((-3.1, 0.2), (2.3, 1.4), (0.7, -2.2), (-1.9, 1.1))]


@pytest.mark.parametrize(
    "claim, on_border",
    [
        (sp.Abs(x), x),
        (x + sp.Max(x - y, 0) / 100, x - y),
        (sp.Piecewise((x, x + y > 1), (x + sp.Rational(1, 10**5), True)), x + y - 1),
        (y * sp.tanh(1000 * (x - 1)), x - 1),
        (y * sp.tanh(10**6 * (x - 1)), x - 1),
        (sp.sqrt(x**2 + sp.Rational(1, 10**8)), x),
        (sp.exp(x) * sp.sign(x**2 + y**2 - 4), x**2 + y**2 - 4),
        (x * sp.Abs(x), x),
    ],
)
def test_next_to_a_border_there_is_a_place(claim, on_border):
    found = points_at_kinks(claim, POINTS)
    assert found and all(abs(float(on_border.subs(point))) < 1e-3 for point in found)


def test_a_jump_has_two_sides():
    found = points_at_kinks(sp.Heaviside(x - y), POINTS[:2])
    assert sorted(np.sign(point[x] - point[y]) for point in found) == [-1, 1]


@pytest.mark.parametrize(
    "claim",
    [
        sp.Integer(3),
        x - 2 * y,
        x**2 * y,
        sp.exp(x - y),
        sp.sin(4 * x) * sp.cosh(y),
        1 / (20 + x),
        sp.sqrt(7 + x + y),
        sp.Integral(sp.Abs(y), (y, 0, x)),
    ],
)
def test_what_is_smooth_has_no_bends(claim):
    assert points_at_kinks(claim, POINTS) == []
