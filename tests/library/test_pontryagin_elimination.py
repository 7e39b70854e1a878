"""Differential equations of controls without costates (section 5.2 of the problem book)."""

import pytest
import sympy as sp

from trajlib.pontryagin import ControlField, Problem

x, y, v, w, u, k, b, c, r = sp.symbols("x y v w u k b c r", real=True)


def test_constant_costates():
    approach = Problem(
        {r: k * r, w: u - 2 * k * w},
        {u: None},
        {r: 1, w: 0},
        [r - 2],
        running=r**2 * (u**2 + (k**2 - w**2) ** 2),
    )
    assert sp.expand(approach.conditions().control_field[u] - 2 * w * (w**2 - k**2)) == 0
    named = ControlField(approach, [w, u])
    assert str(named) == "ControlField: w', u' along extremals" and len(named) == 2
    assert named[0] == u - 2 * k * w and sp.expand(named.subs({k: -1})[1] - 2 * w**3 + 2 * w) == 0


@pytest.mark.slow
@pytest.mark.parametrize("maximise", [False, True])
def test_ratio_of_two_costates(maximise):
    turn = b * sp.sin(y) - sp.sin(u)
    evasion = Problem(
        {r: sp.cos(u) - b * sp.cos(y), y: turn / (r * c)},
        {u: None},
        {r: 2, y: 1},
        [r - 1],
        maximise=maximise,
    )
    field = evasion.conditions().control_field
    assert set(field) == {u, r, y}
    assert sp.simplify(ControlField(evasion, [y, u], factor=r)[0] - turn / c) == 0
    assert sp.simplify(r * field[u] - turn + b * (1 - c) / c * sp.cos(u) * sp.sin(u - y)) == 0


def test_costates_that_cannot_be_eliminated():
    steered = Problem(
        {x: v, y: w, v: sp.cos(u), w: sp.sin(u)},
        {u: None},
        {x: 0, y: 0, v: 0, w: 0},
        [y - 1, w],
        final=-v,
        duration=3,
    )
    with pytest.raises(ValueError, match="costates are not known"):
        steered.conditions().control_field
