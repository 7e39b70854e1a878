"""The Gramian on an interval: known values, its differential equation, floats, errors."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad_vec
from scipy.linalg import expm

from trajlib.structure import controllability_gramian

M = sp.Matrix
T, a, w = sp.symbols("T a omega", positive=True)
CARRIAGE, SWING = M([[0, 1], [0, 0]]), M([[0, 1], [-1, 0]])
DRIVEN = M([0, 1])


@pytest.mark.parametrize(
    ("A", "B", "duration", "expected"),
    [
        (CARRIAGE, DRIVEN, T, M([[T**3 / 3, T**2 / 2], [T**2 / 2, T]])),
        (SWING, DRIVEN, 2 * sp.pi, sp.pi * sp.eye(2)),
        (-sp.eye(2), M([1, 1]), 1, (1 - sp.exp(-2)) / 2 * sp.ones(2)),
        ([[a]], [1], T, M([[(sp.exp(2 * a * T) - 1) / (2 * a)]])),
        (sp.zeros(2), sp.eye(2), 3, 3 * sp.eye(2)),
    ],
)
def test_known_gramians(A, B, duration, expected):
    assert sp.simplify(controllability_gramian(A, B, duration) - expected) == sp.zeros(
        *expected.shape
    )


@pytest.mark.parametrize(
    ("A", "B"),
    [
        (M([[0, 1], [-(w**2), 0]]), DRIVEN),
        (M([[0, 1], [0, -a]]), DRIVEN),
        (M([[0, 1], [-2, -3]]), M([[1, 0], [1, 1]])),
    ],
)
def test_gramian_satisfies_its_differential_equation(A, B):
    W = controllability_gramian(A, B, T)
    assert sp.simplify(W.diff(T) - A * W - W * A.T - B * B.T) == sp.zeros(2)
    assert W.subs(T, 0).applyfunc(sp.simplify) == sp.zeros(2)


@pytest.mark.slow
@pytest.mark.parametrize("duration", [1e-3, 1.0, 40.0])
def test_float_gramian_equals_the_integral(duration):
    A, B = np.array([[0.0, 1.0], [-1.0, -0.5]]), np.array([0.0, 1.0])
    found = controllability_gramian(A, B, duration)
    integral, _ = quad_vec(
        lambda s: np.outer(expm(A * s) @ B, expm(A * s) @ B), 0, duration, epsrel=1e-11
    )
    assert np.allclose(found, integral, rtol=1e-9, atol=1e-12 * np.abs(integral).max())
    exact = controllability_gramian(
        M([[0, 1], [-1, sp.Rational(-1, 2)]]), DRIVEN, sp.nsimplify(duration)
    )
    assert np.allclose(found, np.array(exact.evalf(30), dtype=float), rtol=1e-9)


@pytest.mark.parametrize(
    ("A", "B", "duration", "message"),
    [
        (CARRIAGE, DRIVEN, 0, "duration: expected a positive number, got 0"),
        (CARRIAGE, DRIVEN, -T, "duration: expected a positive number"),
        (CARRIAGE, DRIVEN, sp.oo, "duration: expected a positive number"),
        (np.eye(2), np.ones(2), T, "duration: expected a number with matrices of floats"),
        (CARRIAGE, M([[0, 1]]), 1, "B: expected a matrix with 2 rows"),
    ],
)
def test_errors(A, B, duration, message):
    with pytest.raises(ValueError, match=message):
        controllability_gramian(A, B, duration)
