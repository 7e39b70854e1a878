"""Lyapunov functions of problems 1.2 - 1.4, worked example 2 and problem 1.13."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import (
    barbashin_krasovskii,
    basin_estimate,
    is_positive_definite,
    lyapunov_derivative,
)

x, y = sp.symbols("x y")
a, b, d, w = sp.symbols("a b delta omega", positive=True)
R = x**2 + y**2 - 1
half = sp.Rational(1, 2)


def duffing(b):
    return (b * x**4 + 2 * x**2 + 2 * y**2) / 4, [y, -a * y - x - b * x**3]


example_2 = half * y**2 + b * x**2 + x**3, [y, -2 * b * x - a * y - 3 * x**2]


def test_derivatives():
    assert lyapunov_derivative(*duffing(b), [x, y]) == -a * y**2
    assert lyapunov_derivative(*example_2, [x, y]) == -a * y**2
    assert (
        lyapunov_derivative(half * (y**2 + w**2 * x**2), [y, -d * y - w**2 * x], [x, y])
        == -d * y**2
    )
    eps = sp.Symbol("epsilon")
    vdp = lyapunov_derivative(half * (x**2 + y**2), [y, -eps * (x**2 - 1) * y - x], [x, y])
    assert sp.expand(vdp + eps * (x**2 - 1) * y**2) == 0
    cycle = lyapunov_derivative(half * (x**2 + y**2), [y - x * R, -x - y * R], [x, y])
    assert cycle == sp.factor(-(x**2 + y**2) * R)


@pytest.mark.parametrize(
    "V, condition",
    [
        (x**2 + x * y + y**2, sp.true),
        (x**2 + 2 * x * y + y**2, sp.false),
        (x**2 + 3 * x * y + y**2, sp.false),
        (x**2, sp.false),
        (x**2 + y**2 + 1, sp.false),
        (x + x**2 + y**2, sp.false),
        (x**3 + y**2, sp.false),
        (x**4 + y**2, sp.true),
        (x**4 - x**2 * y**2 + y**4, sp.true),
        (x**4 - 3 * x**2 * y**2 + y**4, sp.false),
        (1 - sp.cos(x) + y**2, sp.true),
        (example_2[0], sp.true),
        (x**4 + (x + y) ** 2, None),
    ],
)
def test_definiteness(V, condition):
    assert is_positive_definite(V, [x, y]).condition is condition


def test_definiteness_with_parameters():
    p, q = sp.symbols("p q")
    assert is_positive_definite(half * y**2 + p * x**2 + x**3, [x, y]).condition == (p > 0)
    assert is_positive_definite(half * y**2 + p * x**2 + x**4, [x, y]).condition == (p >= 0)
    assert is_positive_definite(p * x**2 + 2 * x * y + q * y**2, [x, y]).condition == sp.And(
        p > 0, p * q > 1
    )
    assert bool(is_positive_definite(x**2 + y**2, [x, y])) is True
    with pytest.raises(TypeError, match="depends on parameters"):
        bool(is_positive_definite(p * x**2 + y**2, [x, y]))


def test_set_of_zero_derivative():
    p = sp.Symbol("b")
    M = barbashin_krasovskii(*duffing(p), [x, y])
    assert M.zero_set == sp.Eq(y, 0) and M.only_origin == (p >= 0)
    assert {what for what, _ in M.others} == {(sp.sqrt(-1 / p), 0), (-sp.sqrt(-1 / p), 0)}
    assert barbashin_krasovskii(*duffing(b), [x, y]).only_origin is sp.true

    M = barbashin_krasovskii(*example_2, [x, y])
    assert M.others == (((-2 * b / 3, 0), sp.true),) and M.only_origin is sp.false

    M = barbashin_krasovskii(half * (y**2 + w**2 * x**2), [y, -d * y - w**2 * x], [x, y])
    assert M.zero_set == sp.Eq(y, 0) and M.only_origin is sp.true

    eps = sp.Symbol("epsilon")
    M = barbashin_krasovskii(half * (x**2 + y**2), [y, -eps * (x**2 - 1) * y - x], [x, y])
    assert M.only_origin is sp.true and "epsilon != 0" in M.reason


def test_cycles_lie_in_the_set_of_zero_derivative():
    for field in ([y - x * R, -x - y * R], [y - x * R**2, -x - y * R**2]):
        M = barbashin_krasovskii(half * (x**2 + y**2), field, [x, y])
        assert M.others == ((sp.Eq(R, 0), sp.true),) and M.only_origin is sp.false


def test_conservative_system():
    M = barbashin_krasovskii(x**2 + y**2, [y, -x], [x, y])
    assert M.zero_set is sp.true and M.only_origin is sp.false


@pytest.mark.slow
def test_basins_of_the_problem_book():
    found = basin_estimate(*example_2, [x, y])
    assert found.level == sp.Rational(4, 27) * b**3 and found.obstacles == ((-2 * b / 3, 0),)

    weak = sp.Symbol("b", negative=True)
    found = basin_estimate(*duffing(weak), [x, y])
    assert sp.simplify(found.level - 1 / (4 * sp.Abs(weak))) == 0 and len(found.obstacles) == 2
    assert basin_estimate(*duffing(sp.Rational(-1, 25)), [x, y]).level == sp.Rational(25, 4)
    assert basin_estimate(*duffing(b), [x, y]).level == sp.oo

    eps = sp.Symbol("epsilon", negative=True)
    assert (
        basin_estimate(half * (x**2 + y**2), [y, -eps * (x**2 - 1) * y - x], [x, y]).level == half
    )

    pendulum = half * y**2 + w**2 * (1 - sp.cos(x)), [y, -d * y - w**2 * sp.sin(x)]
    assert basin_estimate(*pendulum, [x, y]).level == 2 * w**2
    assert (
        basin_estimate(half * (y**2 + w**2 * x**2), [y, -d * y - w**2 * x], [x, y]).level == sp.oo
    )
    # 1.13 b and c: the disc inside the cycle, an unstable and a semistable one.
    for field in ([y + x * R, -x + y * R], [y - x * R**2, -x - y * R**2]):
        assert basin_estimate(half * (x**2 + y**2), field, [x, y]).level == half


def test_basin_with_a_constraint():
    assert (
        sp.simplify(basin_estimate(*example_2, [x, y], constraint=x > -b / 3).level - 2 * b**3 / 27)
        == 0
    )
    assert (
        basin_estimate(x**2 + y**2, [-x, -y], [x, y], constraint=sp.And(x < 2, y > -1)).level == 1
    )


def test_basin_against_a_grid():
    """V' > 0 nowhere below the level, and somewhere just above it."""
    V, field = x**2 + x * y + y**2, [y, -x - y + x**3]
    level = float(basin_estimate(V, field, [x, y]).level)
    X, Y = np.meshgrid(np.linspace(-2, 2, 1001), np.linspace(-2, 2, 1001))
    rising = sp.lambdify((x, y), lyapunov_derivative(V, field, [x, y]))(X, Y) > 1e-12
    lowest = sp.lambdify((x, y), V)(X, Y)[rising].min()
    assert level <= lowest <= 1.02 * level


@pytest.mark.parametrize(
    "V, field, named",
    [
        (x**2 - y**2, [-x, -y], "positive definite"),
        (x**2 + y**2, [y, -x], "vanishes identically"),
        (half * (x**2 + y**2), [y - x * R, -x - y * R], "positive near the origin"),
        (half * (x**2 + y**2), [y, -a * (x**2 - 1) * y - x], "positive near the origin"),
        (half * (x**2 + y**2), [y, -x - x * y], "changes sign near the origin"),
        (x**2 + y**2, [1 - x, -y], "not an equilibrium"),
        (duffing(sp.Symbol("q"))[0], duffing(sp.Symbol("q"))[1], "depends on q < 0"),
        (half * (x**2 + y**2), [y, -sp.Symbol("q") * y - x], "depends on that of q"),
        (x**2 + y**2, [-x, 0], "whole trajectories"),
    ],
)
def test_unsuitable_functions_are_refused(V, field, named):
    with pytest.raises(ValueError, match=named):
        basin_estimate(V, field, [x, y])


def test_display():
    assert "27" in basin_estimate(*example_2, [x, y])._repr_markdown_()
    assert r"\dot V" in barbashin_krasovskii(*example_2, [x, y])._repr_markdown_()


@settings(max_examples=40, deadline=None)
@given(st.lists(st.integers(-4, 4), min_size=6, max_size=6))
def test_quadratic_forms_agree_with_their_eigenvalues(entries):
    z = sp.Symbol("z")
    p = sp.Matrix(
        [
            [entries[0], entries[1], entries[2]],
            [entries[1], entries[3], entries[4]],
            [entries[2], entries[4], entries[5]],
        ]
    )
    state = sp.Matrix([x, y, z])
    smallest = np.linalg.eigvalsh(np.array(p.tolist(), dtype=float)).min()
    if abs(smallest) > 1e-9:
        assert bool(is_positive_definite((state.T * p * state)[0], list(state))) == (smallest > 0)
