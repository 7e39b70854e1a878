"""Lie derivatives against derivatives along known motions."""

import pytest
import sympy as sp

from trajlib.flows import lie_derivative

t, c = sp.symbols("t c")
x, y = sp.symbols("x y")


@pytest.mark.parametrize("order", [0, 1, 2, 3])
def test_lie_derivative_is_the_time_derivative_along_a_motion(order):
    # of a spiral that is known
    motion = {
        x: sp.exp(-t) * sp.cos(c * t),
        y: sp.exp(-t) * sp.sin(c * t),
    }
    spiral = {x: -x - c * y, y: c * x - y}
    function = x**2 * y + c * sp.sin(y)
    along = lie_derivative(function, spiral, order).subs(motion, simultaneous=True)
    directly = sp.diff(function.subs(motion, simultaneous=True), t, order)
    assert abs((along - directly).subs({t: sp.Rational(7, 10), c: 2}).evalf(30)) < 1e-25


def test_symbols_outside_the_flow_are_constant():
    assert lie_derivative(c**2, {x: c}) == 0 and lie_derivative(c * x, {x: y}) == c * y


def test_bad_arguments_are_rejected():
    with pytest.raises(TypeError, match="flow: expected a dict"):
        lie_derivative(x, [y])
    for order in (-1, 1.5):
        with pytest.raises(ValueError, match="order: expected a whole number"):
            lie_derivative(x, {x: y}, order)
