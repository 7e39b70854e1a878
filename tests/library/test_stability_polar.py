"""Polar form and limit cycles: problems 1.12 and 1.13."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from trajlib.stability import limit_cycles, polar_form

x1, x2, r, phi, u = sp.symbols("x1 x2 r phi u")
R = x1**2 + x2**2 - 1
SYSTEMS = {
    "a": [x2 - x1 * R, -x1 - x2 * R],
    "b": [x2 + x1 * R, -x1 + x2 * R],
    "c": [x2 - x1 * R**2, -x1 - x2 * R**2],
}


@pytest.mark.parametrize(
    "item, radial, stability",
    [
        ("a", -r * (r**2 - 1), "stable"),
        ("b", r * (r**2 - 1), "unstable"),
        ("c", -r * (r**2 - 1) ** 2, "semistable"),
    ],
)
def test_problem_1_13(item, radial, stability):
    rate, turn = polar_form(SYSTEMS[item], [x1, x2], r, phi)
    assert sp.expand(rate - radial) == 0 and turn == -1
    (cycle,) = limit_cycles(rate, r, turn)
    assert (cycle.radius, cycle.period, cycle.stability, cycle.condition) == (
        1,
        2 * sp.pi,
        stability,
        sp.true,
    )


@pytest.mark.parametrize("item", SYSTEMS)
def test_trajectories_agree(item):
    """Starts just inside and just outside the circle move as the name of the cycle says."""
    f = sp.lambdify((x1, x2), SYSTEMS[item])
    (cycle,) = limit_cycles(*polar_form(SYSTEMS[item], [x1, x2], r, phi)[:1], r)
    towards = []
    for start in (0.97, 1.03):
        end = solve_ivp(lambda t, p: f(*p), (0, 3), [start, 0.0], rtol=1e-9).y[:, -1]
        towards.append(abs(np.hypot(*end) - 1) < abs(start - 1))
    assert cycle.stability == {2: "stable", 0: "unstable", 1: "semistable"}[sum(towards)]


def test_problem_1_12():
    (cycle,) = limit_cycles((u - 2) * r - r**3, r, r + 1)
    assert (
        cycle.radius == sp.sqrt(u - 2)
        and cycle.condition == (u > 2)
        and cycle.stability == "stable"
    )
    assert sp.simplify(cycle.period - 2 * sp.pi / (1 + sp.sqrt(u - 2))) == 0
    assert limit_cycles(((u - 2) * r - r**3).subs(u, 1), r, r + 1) == []


def test_several_cycles_and_circles_of_equilibria():
    cycles = limit_cycles(r * (r - 1) * (r - 2) ** 2 * (r - 3), r, 1 - r)
    assert [(c.radius, c.stability) for c in cycles] == [(2, "semistable"), (3, "unstable")]
    assert [c.period for c in cycles] == [2 * sp.pi, sp.pi]


def test_other_fields():
    assert polar_form([x1, x2], [x1, x2], r, phi) == (r, 0)
    rate, turn = polar_form([x2, -2 * x1], [x1, x2], r, phi)
    assert (
        sp.simplify(rate + r * sp.sin(phi) * sp.cos(phi)) == 0
        and sp.simplify(turn + 1 + sp.cos(phi) ** 2) == 0
    )


def test_display():
    assert "u > 2" in limit_cycles((u - 2) * r - r**3, r, r + 1)[0]._repr_markdown_()


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: polar_form([x1], [x1], r, phi), "planar"),
        (lambda: polar_form([x1, x2], [x1, x2], x1, phi), "r, phi"),
        (lambda: limit_cycles(0 * r, r), "identically zero"),
        (lambda: limit_cycles(r * sp.cos(r) - r**2, r), "could not all be found"),
        (lambda: limit_cycles(u * r * (r - 1), r), "sign of u"),
    ],
)
def test_errors_name_the_argument(call, named):
    with pytest.raises(ValueError, match=named):
        call()
