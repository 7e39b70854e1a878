"""Linearisation about points and along motions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import linearise, linearise_along

x, y, v, t = sp.symbols("x y v t")


def test_pendulum():
    d, w = sp.symbols("delta omega")
    field = [v, -d * v - w**2 * sp.sin(x)]
    assert linearise(field, [x, v], at=[0, 0]) == sp.Matrix([[0, 1], [-(w**2), -d]])
    assert linearise(field, [x, v], at=[sp.pi, 0]) == sp.Matrix([[0, 1], [w**2, -d]])
    n = sp.Symbol("n", integer=True)
    assert linearise(field, [x, v], at=[2 * sp.pi * n, 0]) == sp.Matrix([[0, 1], [-(w**2), -d]])


def test_worked_example_2():
    a, b = sp.symbols("a b")
    field = [y, -2 * b * x - a * y - 3 * x**2]
    assert linearise(field, [x, y], at=[-2 * b / 3, 0]) == sp.Matrix([[0, 1], [2 * b, -a]])


def test_glider_1_9():
    g, k, k1, V = sp.symbols("g k k1 v", positive=True)
    theta = sp.Symbol("theta", real=True)
    field = [-k * V**2 - g * sp.sin(theta), k1 * V - g * sp.cos(theta) / V]
    speed, angle = sp.sqrt(g) / (k**2 + k1**2) ** sp.Rational(1, 4), -sp.atan(k / k1)
    A = linearise(field, [V, theta], at=[speed, angle])
    expected = sp.Matrix([[-2 * k * speed, -k1 * speed**2], [2 * k1, -k * speed]])
    assert sp.simplify(A - expected) == sp.zeros(2, 2)


def test_robot_1_10_along_its_track():
    alpha, V, omega, uS, uD, V0 = sp.symbols("alpha V omega u_S u_D V0")
    k0, k1, k2, k3 = sp.symbols("k0:4", positive=True)
    field = [
        V * sp.cos(alpha) - k0 * omega * sp.sin(alpha),
        V * sp.sin(alpha) + k0 * omega * sp.cos(alpha),
        omega,
        -V + k1 * k2 * omega**2 + uS,
        -k3 * (1 + k2 / k1 * V) * omega + k3 / k1 * uD,
    ]
    A, B = linearise_along(
        field, [x, y, alpha, V, omega], [V0 * t, 0, 0, V0, 0], t, [uS, uD], [V0, 0]
    )
    assert A == sp.Matrix(
        [
            [0, 0, 0, 1, 0],
            [0, 0, V0, 0, k0],
            [0, 0, 0, 0, 1],
            [0, 0, 0, -1, 0],
            [0, 0, 0, 0, -k3 * (1 + V0 * k2 / k1)],
        ]
    )
    assert B == sp.Matrix([[0, 0], [0, 0], [0, 0], [1, 0], [0, k3 / k1]])
    # With u_S = 0 the robot does not keep its speed.
    with pytest.raises(ValueError, match="motion: .*V0"):
        linearise_along(field, [x, y, alpha, V, omega], [V0 * t, 0, 0, V0, 0], t, [uS, uD], [0, 0])


def test_a_motion_that_depends_on_time():
    A, B = linearise_along([-(x**2)], [x], [1 / t], t)
    assert A == sp.Matrix([[-2 / t]]) and B.shape == (1, 0)


def test_inputs_give_a_pair_and_floats_give_arrays():
    u = sp.Symbol("u")
    A, B = linearise([v, -(x**3) + u], [x, v], at=[1, 0], inputs=[u], inputs_at=[1])
    assert A == sp.Matrix([[0, 1], [-3, 0]]) and B == sp.Matrix([0, 1])
    numeric = linearise([v, -sp.sin(x)], [x, v], at=np.array([np.pi, 0.0]))
    assert isinstance(numeric, np.ndarray) and np.allclose(numeric, [[0, 1], [1, 0]])


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: linearise([v, -x + 1], [x, v], at=[0, 0]), "at: .*not an equilibrium.*1"),
        (lambda: linearise([v, -x], [x, v], at=[0]), "at: expected 2"),
        (lambda: linearise([v, -x], [x, v], at=np.array([0.1, 0.0])), "not an equilibrium"),
        (lambda: linearise([sp.log(x)], [x], at=[0]), "not defined"),
        (lambda: linearise([v, sp.Symbol("k") * x], [x, v], at=np.zeros(2)), "k"),
        (lambda: linearise_along([v, -x], [x, v], [sp.sin(t), sp.sin(t)], t), "motion"),
        (lambda: linearise_along([v, -x], [x, v], [0, 0], x), "time"),
    ],
)
def test_errors_name_the_argument(call, named):
    with pytest.raises(ValueError, match=named):
        call()


coefficient = st.integers(-4, 4)


@settings(max_examples=30, deadline=None)
@given(st.lists(coefficient, min_size=8, max_size=8), st.floats(-2, 2), st.floats(-2, 2))
def test_agrees_with_finite_differences(c, x0, y0):
    raw = [
        c[0] * sp.sin(x * y) + c[1] * x**2 + c[2] * y + c[3] * sp.exp(y / 3),
        c[4] * x * y + c[5] * sp.cos(x) + c[6] * y**3 + c[7] * x,
    ]
    x0, y0 = sp.Rational(round(64 * x0), 64), sp.Rational(round(64 * y0), 64)
    field = [f - f.subs({x: x0, y: y0}) for f in raw]
    A = np.array(linearise(field, [x, y], at=[x0, y0]).tolist(), dtype=float)
    f = sp.lambdify((x, y), field)
    h = 1e-5
    p = np.array([x0, y0], dtype=float)
    columns = [(np.array(f(*(p + h * e))) - np.array(f(*(p - h * e)))) / (2 * h) for e in np.eye(2)]
    assert np.allclose(A, np.column_stack(columns), atol=1e-6 * (1 + np.abs(A).max()))
