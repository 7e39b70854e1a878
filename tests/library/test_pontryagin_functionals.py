"""Euler-Poisson equation and natural conditions, against the first variation and `solve`."""

import pytest
import sympy as sp

from trajlib.pontryagin import (
    control_problem,
    end_conditions,
    euler_equation,
    functional_value,
    momenta,
    natural_conditions,
)
from workbook.systems import Functional

t, T, eps = sp.symbols("t T epsilon", positive=True)
x = sp.Function("x")
v = x(t).diff(t)
w = v.diff(t)
A, B, C, D = sp.symbols("A B C D")
GROWTH = Functional(v**2 + x(t) ** 2, x(t), (t, 0, 1), start=[1], final=-(x(1) ** 2))
BEAM = Functional(w**2 - 48 * x(t), x(t), (t, 0, 1), start=[0, 0])
LOADED = Functional(t**2 * x(t) - v**2, x(t), (t, 0, 1), start=[0], end=[0], maximise=True)
PUSHED = Functional(w**2, x(t), (t, 0, 1), final=x(1) + v.subs(t, 1) ** 2)


@pytest.mark.parametrize(
    "functional, motion, moves",
    [
        (GROWTH, 1 + 2 * t**2, [t, t * (1 - t)]),
        (BEAM, t**2 + t**3, [t**2, t**2 * (1 - t) ** 2, t**3]),
        (PUSHED, t**2 + t**3, [1, t, t**2, t**3]),
    ],
)
def test_first_variation(functional, motion, moves):
    """dJ/d epsilon is the integral of E times the variation, and the momenta at the ends."""
    euler = euler_equation(functional).lhs.subs(x(t), motion).doit()
    at_motion = [p.subs(x(t), motion).doit() for p in momenta(functional)]
    for move in map(sp.sympify, moves):
        rate = functional_value(functional, motion + eps * move).diff(eps).subs(eps, 0)
        final = functional.final
        for derivative in (v, x(t)):
            at = derivative.subs(t, 1)
            final = final.subs(at, derivative.subs(x(t), motion + eps * move).doit().subs(t, 1))
        ends = sum(
            (p * move.diff(t, k)).subs(t, 1) - (p * move.diff(t, k)).subs(t, 0)
            for k, p in enumerate(at_motion)
        )
        assert (
            sp.simplify(
                rate
                - sp.integrate(sp.expand(euler * move), (t, 0, 1))
                - ends
                - final.diff(eps).subs(eps, 0)
            )
            == 0
        )


def test_conditions_determine_the_extremal():
    assert sp.solve(end_conditions(GROWTH, A * sp.cosh(t) + B * sp.sinh(t)), [A, B]) == {A: 1, B: 1}
    found = sp.solve(end_conditions(BEAM, t**4 + A * t**3 + B * t**2 + C * t + D), [A, B, C, D])
    assert found == {A: -4, B: 6, C: 0, D: 0}
    assert len(natural_conditions(PUSHED)) == 4 and len(natural_conditions(BEAM)) == 2


@pytest.mark.parametrize(
    "functional, motion",
    [(GROWTH, sp.exp(t)), (BEAM, t**4 - 4 * t**3 + 6 * t**2), (LOADED, (t - t**4) / 24)],
)
def test_control_problem(functional, motion):
    extremal = control_problem(functional).solve()
    assert extremal.cost == pytest.approx(float(functional_value(functional, motion)), abs=1e-9)
    sign = -1 if functional.maximise else 1
    for moment in (0.2, 0.7):
        state, costate = extremal.state(moment), extremal.costate(moment)
        for k, p in enumerate(momenta(functional)):
            assert state[k] == pytest.approx(float(motion.diff(t, k).subs(t, moment)), abs=1e-8)
            assert costate[k] == pytest.approx(
                sign * float(p.subs(x(t), motion).doit().subs(t, moment)), abs=1e-7
            )


def test_values_for_parameters():
    falling = Functional(v**2 - x(t), x(t), (t, 0, T), [0], [2])
    assert falling.parameters == (T,) and falling.subs({T: 4}) == Functional(
        v**2 - x(t), x(t), (t, 0, 4), [0], [2]
    )
    assert functional_value(falling, 2 * t / T) == 4 / T - T


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((x(t) ** 2, x(t), (t, 0, 1)), "no derivative"),
        ((v**2, t, (t, 0, 1)), "expected a function of t"),
        ((v**2, x(t), (0, 1)), r"expected \(t, begin, end\)"),
        ((v**2, x(t), (t, 0, 1), [0, 0]), "at most 1 can be given"),
    ],
)
def test_invalid_functionals(arguments, message):
    with pytest.raises(ValueError, match=message):
        Functional(*arguments)
