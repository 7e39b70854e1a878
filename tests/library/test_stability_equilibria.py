"""Equilibria of problems 1.1 - 1.13; incomplete solutions are reported."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import equilibria

x, y, v, phi, theta, beta = sp.symbols("x y v phi theta beta")
a, b, d, k, w, eps, Om = sp.symbols("a b delta k omega epsilon Omega")
g, K, k1, P, m, V, rho, u, B = sp.symbols("g k k1 P m v rho u b", positive=True)
n = sp.Symbol("n", integer=True)


@pytest.mark.parametrize(
    "field, points",
    [
        ([sp.log(2 - y**2), sp.exp(x) - sp.exp(y)], {(1, 1), (-1, -1)}),
        ([sp.log(y**2 - x), x - y - 1], {(3, 2), (0, -1)}),
        ([-(x**2) + y, -sp.log(1 - x + x**2) + sp.log(3)], {(2, 4), (-1, 1)}),
    ],
    ids=["1.1a", "1.1b", "1.1c"],
)
def test_problem_1_1(field, points):
    found = equilibria(field, [x, y])
    assert set(found) == points and found.complete and set(found.conditions) == {sp.true}


def test_pendulum_has_two_families():
    field = [v, -d * v - w**2 * sp.sin(x)]
    found = equilibria(field, [x, v], [d, w])
    (n,) = found.integers
    assert set(found) == {(2 * sp.pi * n, 0), (2 * sp.pi * n + sp.pi, 0)} and found.complete
    assert "omega != 0" in found.reason
    window = {x: sp.Interval.Lopen(-sp.pi, sp.pi)}
    assert list(equilibria(field, [x, v], [d, w], domain=window)) == [(0, 0), (sp.pi, 0)]
    assert (
        len(equilibria(field, [x, v], [d, w], domain={x: sp.Interval(-2 * sp.pi, 2 * sp.pi)})) == 5
    )


def test_duffing_with_symbols_and_with_numbers():
    found = equilibria([v, -a * v - x - b * x**3], [x, v], [a, b])
    assert dict(zip(found, found.conditions)) == {
        (0, 0): sp.true,
        (sp.sqrt(-1 / b), 0): b < 0,
        (-sp.sqrt(-1 / b), 0): b < 0,
    }
    assert set(equilibria([v, -v - x + 0.04 * x**3], [x, v])) == {(0, 0), (5, 0), (-5, 0)}
    positive = sp.Symbol("b", positive=True)
    assert list(equilibria([v, -a * v - x - positive * x**3], [x, v], [a, positive])) == [(0, 0)]


def test_straight_approach_1_6():
    field = [v, -2 * k * Om * v + sp.Rational(3, 2) * Om**2 * sp.sin(2 * phi) - 2 * k * Om**2]
    found = equilibria(field, [phi, v], [k, Om])
    (n,) = found.integers
    exists = sp.And(k >= -sp.Rational(3, 4), k <= sp.Rational(3, 4))
    angle = sp.asin(4 * k / 3) / 2
    assert dict(zip(found, found.conditions)) == {
        (sp.pi * n + angle, 0): exists,
        (sp.pi * n + sp.pi / 2 - angle, 0): exists,
    }
    negative = sp.Symbol("k", negative=True)
    half_turn = {phi: sp.Interval.Ropen(0, sp.pi)}
    found = equilibria(
        [f.subs(k, negative) for f in field], [phi, v], [negative, Om], domain=half_turn
    )
    angle = sp.asin(4 * negative / 3) / 2
    assert dict(zip(found, found.conditions)) == {
        (sp.pi + angle, 0): negative >= -sp.Rational(3, 4),
        (sp.pi / 2 - angle, 0): negative >= -sp.Rational(3, 4),
    }


def test_rocket_1_7():
    # Only the upward motion, v > 0, makes sense; at P = mg the rocket would hover.
    found = equilibria([(P - K * V**2) / m - g], [V], [P, K, m, g])
    assert list(found) == [(sp.sqrt(P - g * m) / sp.sqrt(K),)] and found.conditions == (P > g * m,)


def test_projectile_1_8_and_glider_1_9():
    field = [P - K * V**2 - g * sp.sin(theta), -g * sp.cos(theta) / V]
    passive = equilibria([f.subs(P, 0) for f in field], [V, theta], [K, g])
    (n,) = passive.integers
    assert list(passive) == [(sp.sqrt(g) / sp.sqrt(K), 2 * sp.pi * n - sp.pi / 2)]
    thrust = equilibria(field, [V, theta], [K, g, P])
    assert thrust.conditions == (sp.true, P > g)
    assert [p[1].subs(thrust.integers[0], 0) for p in thrust] == [-sp.pi / 2, sp.pi / 2]

    glide = equilibria(
        [-K * V**2 - g * sp.sin(theta), k1 * V - g * sp.cos(theta) / V],
        [V, theta],
        [K, g, k1],
        domain={theta: sp.Interval.Lopen(-sp.pi, sp.pi)},
    )
    assert (
        list(glide) == [(sp.sqrt(g) / (K**2 + k1**2) ** sp.Rational(1, 4), -sp.atan(K / k1))]
        and glide.complete
    )


def test_pursuit_1_11():
    window = {beta: sp.Interval.Lopen(-sp.pi, sp.pi)}
    for side in (1, -1):
        found = equilibria(
            [B - sp.cos(beta), sp.sin(beta) / rho + side * u], [rho, beta], [B, u], domain=window
        )
        assert list(found) == [
            (sp.sqrt(1 - B**2) / u, -side * sp.acos(B))
        ] and found.conditions == (B < 1,)


def test_worked_examples_and_cycles():
    assert list(equilibria([-k * x, -sp.Symbol("g") - k * y], [x, y], [k, sp.Symbol("g")])) == [
        (0, -sp.Symbol("g") / k)
    ]
    assert set(equilibria([y, -2 * b * x - a * y - 3 * x**2], [x, y], [a, b])) == {
        (0, 0),
        (-2 * b / 3, 0),
    }
    R = x**2 + y**2 - 1
    for field in ([y - x * R, -x - y * R], [y + x * R, -x + y * R], [y - x * R**2, -x - y * R**2]):
        assert list(equilibria(field, [x, y])) == [(0, 0)]


def test_lines_of_equilibria():
    found = equilibria([y, -y], [x, y])
    assert list(found) == [(x, 0)] and found.complete


def test_incomplete_solutions_are_reported():
    found = equilibria([sp.cos(x) - x], [x])
    assert not found.complete and "x - cos(x) = 0" in found.reason
    assert not equilibria([x**3 + a * x + b], [x], [a, b]).complete


def test_points_where_the_field_is_undefined_are_no_equilibria():
    assert list(equilibria([sp.log(x) - sp.log(x - 2) - sp.log(3)], [x])) == [(3,)]
    assert list(equilibria([(x - 1) * (x - 2) / (x - 1) ** 2], [x])) == [(2,)]


def test_polynomial_systems_have_all_real_solutions():
    assert set(equilibria([x**2 + y**2 - 5, x * y - 2], [x, y])) == {
        (1, 2),
        (2, 1),
        (-1, -2),
        (-2, -1),
    }
    # A root that has no radicals: x = y^2 - 1, (y^2 - 1)^3 = y + 1.
    roots = np.roots([1, 0, -3, 0, 3, -1, -2])
    expected = sorted(r.real for r in roots if abs(r.imag) < 1e-9)
    found = equilibria([x**3 - y - 1, y**2 - x - 1], [x, y])
    assert np.allclose(sorted(float(p[1]) for p in found), expected)
    assert all(
        abs(sp.N(f.subs({x: p[0], y: p[1]}))) < 1e-9
        for p in found
        for f in (x**3 - y - 1, y**2 - x - 1)
    )


def test_latex():
    text = equilibria([v, -v - sp.sin(x)], [x, v])._repr_latex_()
    assert r"2 \pi n" in text and r"\mathbb{Z}" in text


@pytest.mark.parametrize(
    "call, error, named",
    [
        (lambda: equilibria([v, -w * x], [x, v]), ValueError, "parameters: .*omega"),
        (lambda: equilibria([v], [x, v]), ValueError, "field: expected 2"),
        (lambda: equilibria([v, x], [x, x]), ValueError, "state"),
        (lambda: equilibria(["v", x], [x, v]), TypeError, "field"),
        (
            lambda: equilibria([v, x], [x, v], domain={y: sp.Interval(0, 1)}),
            ValueError,
            "domain: y",
        ),
        (lambda: equilibria([v, x], [x, v], domain=[(0, 1)]), TypeError, "domain"),
    ],
)
def test_errors_name_the_argument(call, error, named):
    with pytest.raises(error, match=named):
        call()


small = st.integers(-3, 3)


@settings(max_examples=25, deadline=None)
@given(
    st.lists(small, min_size=3, max_size=3, unique=True),
    st.lists(small, min_size=2, max_size=2, unique=True),
    small,
)
def test_planted_equilibria_are_all_found(xs, ys, slope):
    """x' = (x - x1)(x - x2)(x - x3), y' = (y - y1)(y - y2) + slope (x - x1): solved against
    NumPy."""
    field = [
        sp.expand(sp.prod(x - c for c in xs)),
        sp.expand(sp.prod(y - c for c in ys)) + slope * (x - xs[0]),
    ]
    expected = set()
    for c in xs:
        for root in np.roots([1, -sum(ys), ys[0] * ys[1] + slope * (c - xs[0])]):
            if abs(root.imag) < 1e-6:
                expected.add((c, round(root.real, 4)))
    found = equilibria(field, [x, y])
    assert found.complete and {(int(p[0]), round(float(p[1]), 4)) for p in found} == expected
