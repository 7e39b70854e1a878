"""Linear Markov processes against their equations, SciPy's integrators, and single steps."""

import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import sympy as sp

from trajlib import estimation
from trajlib.estimation import Moments

t, h, a, b, Q = sp.symbols("t h a b Q")
k = sp.Symbol("k", integer=True, nonnegative=True)
p11, p12, p22, m1, m2 = sp.symbols("p11 p12 p22 m1 m2")
ANY = Moments([m1, m2], [[p11, p12], [p12, p22]])
PUSH = sp.diag(0, Q)
JORDAN = sp.Matrix([[0, 1, 0], [0, 0, 1], [0, 0, 0]])


def zero(matrix):
    return all(sp.simplify(sp.expand(e)) == 0 for e in matrix)


@pytest.mark.parametrize(
    "A, extra",
    [
        # 4.16: sums of eigenvalues are zero
        (sp.Matrix([[0, 1], [-1, 0]]), {}),
        (sp.Matrix([[0, 1], [0, 0]]), {}),  # example 5: zero, twice
        # simple, double
        (sp.Matrix([[0, 1], [-6, -5]]), {}),
        (sp.Matrix([[0, 1], [-1, -2]]), {}),
        (sp.Matrix([[1, 0], [0, -1]]), {}),
        (sp.Matrix([[-1, 3], [0, -1]]), {}),
        (sp.Matrix([[0, 1], [-5, -2]]), {}),
        (sp.Matrix([[0, 1], [2, 0]]), {}),  # irrational
        (sp.Matrix([[0, 1], [0, -a]]), {a: 3}),
        (sp.Matrix([[0, 1], [-(a**2), -2 * a]]), {a: 2}),
    ],
)
def test_closed_forms_solve_their_equations(A, extra):
    result = estimation.continuous_moments(A, PUSH, ANY, t)
    P, mean = result.covariance.subs(extra), result.mean.subs(extra)
    A = A.subs(extra)
    assert zero(P.diff(t) - A * P - P * A.T - PUSH) and zero(P.subs(t, 0) - ANY.covariance)
    assert zero(mean.diff(t) - A * mean) and zero(mean.subs(t, 0) - ANY.mean)
    assert not P.has(sp.I) and not P.has(sp.nan, sp.zoo)


@pytest.mark.slow
def test_cases_of_problem_4_17():
    A = sp.Matrix([[0, 1], [-b, -a]])
    result = estimation.continuous_moments(A, PUSH, ANY, t)
    assert result.where == (sp.Ne(a, 0) & sp.Ne(b, 0) & sp.Ne(a**2, 4 * b))
    point = {p11: 2, p12: 1, p22: 3, Q: 5}
    # real, complex, unstable, saddle
    for values in ({a: 3, b: 1}, {a: 1, b: 5}, {a: -2, b: 3}, {a: 1, b: -2}):
        exact = (
            estimation.continuous_moments(A.subs(values), PUSH, ANY, t)
            .covariance.subs(point)
            .subs(t, 0.7)
        )
        generic = result.covariance.subs(values).subs(point).subs(t, 0.7)
        assert max(abs(sp.N(e, 20)) for e in exact - generic) < 1e-14
    for values in ({a: 0}, {b: 0}, {b: a**2 / 4}, {a: 0, b: 0}):
        special = estimation.continuous_moments(A.subs(values), PUSH, ANY, t)
        near = {symbol: value + sp.Rational(1, 10**12) for symbol, value in values.items()}
        place = {a: sp.Rational(3, 2), b: 2, t: 1, **point}
        limit = result.covariance.subs(near).subs(place).applyfunc(lambda e: sp.re(sp.N(e, 60)))
        assert max(abs(sp.N(e, 20)) for e in special.covariance.subs(place) - limit) < 1e-9


def test_problem_4_15():
    result = estimation.continuous_moments(a, Q, Moments(m1, p11), t)
    assert result.where == sp.Ne(a, 0)
    assert zero(
        result.covariance
        - sp.Matrix([p11 * sp.exp(2 * a * t) + Q * (sp.exp(2 * a * t) - 1) / (2 * a)])
    )
    # Wiener
    assert estimation.continuous_moments(0, Q, Moments(m1, p11), t).covariance[0] == Q * t + p11


def test_three_states_with_a_frequency():
    w = sp.Symbol("omega", positive=True)
    A = sp.Matrix([[0, 1], [-(w**2), 0]])
    P = estimation.continuous_moments(A, PUSH, ANY, t).covariance
    assert zero(P.diff(t) - A * P - P * A.T - PUSH) and not P.has(sp.Abs)
    start = Moments([1, 2, 3], sp.diag(1, 2, 3))
    for A in (
        JORDAN,
        sp.diag(sp.Matrix([[0, 1], [-1, 0]]), 0),
        sp.Matrix([[-1, 1, 0], [0, -1, 1], [0, 0, 2]]),
    ):
        P = estimation.continuous_moments(A, sp.diag(0, 1, Q), start, t).covariance
        assert (
            zero(P.diff(t) - A * P - P * A.T - sp.diag(0, 1, Q))
            and P.subs(t, 0) == start.covariance
        )


@pytest.mark.parametrize(
    "A", [JORDAN, sp.Matrix([[0, 1], [-3, -1]]), sp.Matrix([[-2, 1], [0, -2]])]
)
def test_exact_discretisation_agrees_with_floats(A):
    n = A.rows
    model = estimation.discretise(A, sp.ones(n), h)
    assert zero(model.Phi.subs(h, 0) - sp.eye(n)) and zero(model.Phi.diff(h) - A * model.Phi)
    floats = estimation.discretise(np.array(A, dtype=float), np.ones((n, n)), 0.8)
    for exact, array in zip(model, floats):
        assert np.allclose(
            np.array(exact.subs(h, sp.Rational(4, 5)).evalf(20), dtype=float), array, atol=1e-13
        )


@pytest.mark.parametrize("seed", range(3))
def test_moments_of_floats_agree_with_the_integrator_of_scipy(seed):
    rng = np.random.default_rng(seed)
    A, mixing, P0 = rng.normal(size=(4, 4)), rng.normal(size=(4, 2)), np.diag([1.0, 2, 0, 3])
    intensity, mean = mixing @ mixing.T, rng.normal(size=4)
    result = estimation.continuous_moments(A, intensity, Moments(mean, P0), 1.5)

    def rate(_, p):
        P = p.reshape(4, 4)
        return (A @ P + P @ A.T + intensity).ravel()

    peer = (
        scipy.integrate.solve_ivp(rate, (0, 1.5), P0.ravel(), rtol=1e-12, atol=1e-12)
        .y[:, -1]
        .reshape(4, 4)
    )
    assert np.allclose(result.covariance, peer, rtol=1e-8, atol=1e-8)
    assert np.allclose(result.mean, scipy.linalg.expm(1.5 * A) @ mean, rtol=1e-12)


def test_long_steps_of_stiff_processes_give_covariances():
    """Van Loan's exponential of the whole step would overflow: e^{-Ah} has entries of 1e4342."""
    A, intensity = np.array([[-1e4, 1e3], [0, -1e-3]]), np.diag([1.0, 1.0])
    model = estimation.discretise(A, intensity, 1.0)
    assert np.linalg.eigvalsh(model.Q)[0] > 0 and np.array_equal(model.Q, model.Q.T)
    exact = estimation.stationary_covariance(A, intensity).covariance
    left = exact - model.Phi @ exact @ model.Phi.T  # what is stationary stays
    assert np.allclose(model.Q, left, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(
    "Phi",
    [
        # 4.20, 4.21
        sp.Matrix([[0, 2], [0, 0]]),
        sp.Matrix([[1, sp.Rational(1, 2)], [-sp.Rational(1, 2), 0]]),
        # and 4.22
        sp.Matrix([[0, 1], [-1, 0]]),
        sp.Matrix([[1, 1], [0, 1]]),
        sp.Matrix([[0, 1], [0, 1]]),
        sp.Matrix([[2, 0], [0, sp.Rational(1, 2)]]),
        sp.Matrix([[1, 1], [-1, 1]]) / 2,
        sp.Matrix([[0, 1], [1, 1]]),
    ],
)
def test_closed_form_in_k_agrees_with_the_recursion(Phi):
    closed = estimation.discrete_moments(Phi, PUSH, ANY, k)
    P, mean = ANY.covariance, ANY.mean
    for step in range(6):
        assert zero(closed.covariance.subs(k, step) - P) and zero(
            closed.mean.subs(k, step) - mean
        ), step
        direct = estimation.discrete_moments(Phi, PUSH, ANY, step)
        assert zero(direct.covariance - P) and zero(direct.mean - mean)
        P, mean = Phi * P * Phi.T + PUSH, Phi * mean


def test_problem_4_19_and_its_condition():
    result = estimation.discrete_moments(a, Q, Moments(m1, p11), k)
    assert result.where == (sp.Ne(a, 1) & sp.Ne(a, -1))
    assert zero(
        result.covariance - sp.Matrix([a ** (2 * k) * p11 + Q * (1 - a ** (2 * k)) / (1 - a**2)])
    )
    for sign in (1, -1):
        assert zero(
            estimation.discrete_moments(sign, Q, Moments(m1, p11), k).covariance
            - sp.Matrix([p11 + k * Q])
        )


def test_many_steps_of_floats_agree_with_single_steps():
    rng = np.random.default_rng(5)
    Phi, mixing = rng.normal(size=(3, 3)) / 2, rng.normal(size=(3, 3))
    noise, P, mean = mixing @ mixing.T, np.eye(3), np.ones(3)
    result = estimation.discrete_moments(Phi, noise, Moments(mean, P), 37)
    for _ in range(37):
        P, mean = Phi @ P @ Phi.T + noise, Phi @ mean
    assert np.allclose(result.covariance, P, rtol=1e-11) and np.allclose(
        result.mean, mean, rtol=1e-9, atol=1e-15
    )


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: estimation.continuous_moments([[0, 1]], 1, ANY, t), "square"),
        (lambda: estimation.continuous_moments(sp.eye(2), sp.diag(1, -1), ANY, t), "semidefinite"),
        (lambda: estimation.continuous_moments(sp.eye(3), sp.eye(3), ANY, t), "3 components"),
        (lambda: estimation.continuous_moments(sp.eye(2), sp.eye(2), ANY, -1), "not negative"),
        (
            lambda: estimation.continuous_moments(
                np.eye(2), np.eye(2), Moments([0, 0], sp.eye(2)), t
            ),
            "not negative",
        ),
        (lambda: estimation.discrete_moments(sp.eye(2), sp.eye(2), ANY, -1), "whole number"),
        (
            lambda: estimation.discrete_moments(
                np.eye(2), np.eye(2), Moments([0, 0], sp.eye(2)), k
            ),
            "whole number",
        ),
        (lambda: estimation.discretise(np.eye(2), np.eye(2), -1.0), "not negative"),
        (lambda: estimation.discretise(np.eye(2), [[1, 2], [0, 1]], 1.0), "symmetric"),
    ],
)
def test_bad_arguments_are_rejected(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_eigenvalues_without_a_closed_form_are_rejected():
    A = sp.Matrix([[0, 1, 0], [0, 0, 1], [-1, -1, -3]])
    with pytest.raises(NotImplementedError, match="square roots"):
        estimation.continuous_moments(A, sp.eye(3), Moments([0, 0, 0], sp.eye(3)), t)


def test_stationary_covariances_are_limits():
    A = sp.Matrix([[0, 1], [-6, -5]])
    result = estimation.stationary_covariance(A, sp.diag(0, 1))
    # 4.18
    assert result.covariance == sp.diag(sp.Rational(1, 60), sp.Rational(1, 10))
    P = estimation.continuous_moments(A, sp.diag(0, 1), ANY, t).covariance
    assert zero(P.applyfunc(lambda e: sp.limit(e, t, sp.oo)) - result.covariance)
    general = estimation.stationary_covariance([[0, 1], [-b, -a]], PUSH)
    assert general.where == ((a > 0) & (b > 0)) and zero(
        general.covariance - sp.diag(Q / (2 * a * b), Q / (2 * a))
    )
    # 4.20
    discrete = estimation.discrete_stationary_covariance([[0, a], [0, 0]], PUSH)
    assert discrete.covariance == sp.diag(a**2 * Q, Q) and discrete.where == sp.true
    first = estimation.discrete_stationary_covariance(a, Q)
    assert sp.simplify(first.where.as_set() - sp.Interval.open(-1, 1)) == sp.S.EmptySet
    assert zero(first.covariance - sp.Matrix([Q / (1 - a**2)]))


@pytest.mark.parametrize("seed", range(3))
def test_stationary_covariances_of_floats(seed):
    rng = np.random.default_rng(seed)
    A, intensity = rng.normal(size=(5, 5)) - 4 * np.eye(5), np.eye(5)
    P = estimation.stationary_covariance(A, intensity).covariance
    assert np.allclose(A @ P + P @ A.T, -intensity, atol=1e-12) and np.array_equal(P, P.T)
    late = estimation.continuous_moments(
        A, intensity, Moments(np.zeros(5), 7 * np.eye(5)), 60.0
    ).covariance
    assert np.allclose(P, late, rtol=1e-8)
    Phi = scipy.linalg.expm(A)
    P = estimation.discrete_stationary_covariance(Phi, intensity).covariance
    assert np.allclose(Phi @ P @ Phi.T + intensity, P, atol=1e-12)


@pytest.mark.parametrize(
    "verdict",
    [
        lambda: estimation.stationary_covariance([[0, 1], [-1, 0]], sp.diag(0, 1)),
        lambda: estimation.stationary_covariance(np.array([[0.0, 1], [-1, 0]]), np.diag([0.0, 1])),
        # the equation has a solution
        lambda: estimation.stationary_covariance([[1, 0], [0, -3]], sp.eye(2)),
        lambda: estimation.stationary_covariance([[0, 1], [0, -1]], sp.diag(0, 1)),
        lambda: estimation.discrete_stationary_covariance([[1]], [[1]]),
        lambda: estimation.discrete_stationary_covariance(-1, 1),
        lambda: estimation.discrete_stationary_covariance(2, 1),
        lambda: estimation.discrete_stationary_covariance(np.array([[0.0, 1], [1, 0]]), np.eye(2)),
    ],
)
def test_no_stationary_covariance_of_unstable_processes(verdict):
    result = verdict()
    assert not result and result.covariance is None and result.where == sp.false
    assert (
        "no stationary covariance" in result._repr_markdown_() and "does not decay" in result.reason
    )
