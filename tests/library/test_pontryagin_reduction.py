"""Extremals without costates, as the problems of §5.2 know them."""
import pytest
import sympy as sp

from trajlib.pontryagin import Problem, reduced_field

x, y, v, w, u, k, b, c, r = sp.symbols("x y v w u k b c r", real=True)


def test_a_flight_in_air():
    flight = Problem({x: v*sp.cos(u), y: v*sp.sin(u), v: -v**2 - sp.sin(u)}, {u: None}, {x: 0, y: 0, v: 1}, final=-x,
                     duration=1)
    rates = reduced_field(flight, [v])
    assert rates[0] == -v**2 - sp.sin(u) and sp.simplify(rates[1] - sp.cos(u)*(1/v + 3*v*sp.sin(u))) == 0


def test_an_approach():
    approach = Problem({r: k*r, w: u - 2*k*w}, {u: None}, {r: 1, w: 0}, [r - 2], running=r**2*(u**2 + (k**2 - w**2)**2))
    assert sp.expand(reduced_field(approach, [w])[1] - 2*w*(w**2 - k**2)) == 0


@pytest.mark.parametrize("maximise", [False, True])
def test_an_evasion_in_its_own_time(maximise):
    turn = b*sp.sin(y) - sp.sin(u)
    evasion = Problem({r: sp.cos(u) - b*sp.cos(y), y: turn/(r*c)}, {u: None}, {r: 2, y: 1}, [r - 1], maximise=maximise)
    angle, heading = reduced_field(evasion, [y], factor=r)
    assert sp.simplify(angle - turn/c) == 0
    assert sp.simplify(heading - turn + b*(1 - c)/c*sp.cos(u)*sp.sin(u - y)) == 0


def test_costates_that_are_left():
    steered = Problem({x: v, y: w, v: sp.cos(u), w: sp.sin(u)}, {u: None}, {x: 0, y: 0, v: 0, w: 0}, [y - 1, w],
                      final=-v, duration=3)
    with pytest.raises(ValueError, match="does not tell the costates"):
        reduced_field(steered, [v, w])
