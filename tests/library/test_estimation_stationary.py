"""Stationary and fixed-gain filters against the equations, limits, SciPy and python-control."""

import control
import numpy as np
import pytest
import scipy.linalg
import sympy as sp

from trajlib import estimation, feedback
from trajlib.estimation import KalmanFilter, Moments

a, b, h = sp.symbols("a b h", real=True)
c, Q, R = sp.symbols("c Q R", positive=True)
PLACES = [
    {a: -2, b: 3, h: 1, c: 2, Q: 5, R: 7},
    {a: sp.Rational(3, 2), b: -1, h: -2, c: 1, Q: 2, R: sp.Rational(1, 3)},
    {a: sp.Rational(1, 3), b: sp.Rational(5, 2), h: 3, c: sp.Rational(1, 2), Q: 1, R: 4},
]
CONTINUOUS = [
    # example 4, 4.34
    ([[a]], [[1]], [[Q]], [[R]]),
    ([[a]], [[h]], [[Q]], [[R]]),
    ([[0, 1], [-b, -a]], [[0, 1]], [[0, 0], [0, Q]], [[R]]),
    ([[0, 1], [-b, -a]], [[1, 0]], [[0, 0], [0, Q]], [[R]]),
    # 4.35
    ([[0, 1], [0, 0]], [[1, 0]], [[0, 0], [0, Q]], [[R]]),
    # 4.36
    ([[-1, 1], [0, 0]], [[1, 0]], [[0, 0], [0, sp.Rational(9, 4)]], [[1]]),
    # 4.37
    ([[-1, 0], [0, 0]], [[1, 1]], [[5, 0], [0, 1]], [[1]]),
    # 4.39
    ([[0, 1], [a, 0]], [[0, 1]], [[0, 0], [0, Q]], [[1]]),
    # 4.40
    ([[0, 1], [1, 0]], [[1, 0]], [[0, 0], [0, 3]], [[1]]),
    # 4.41
    ([[0, 1], [0, -1]], [[1, 0]], [[0, 0], [0, 16]], [[1]]),
    ([[0, 1, 0], [0, 0, 1], [0, 0, 0]], [[1, 0, 0]], sp.diag(0, 0, 1), [[1]]),
    ([[1, 2], [3, 4]], [[1, 0], [0, 1]], [[2, 1], [1, 3]], [[1, 0], [0, 2]]),
    ([[-1, 0], [0, a]], [[0, 1]], [[1, 0], [0, Q]], [[R]]),
]
DISCRETE = [
    ([[0, 1], [0, 1]], [[0, 1]], [[0, 0], [0, Q]], [[R]]),
    ([[0, 1], [0, 1]], [[1, 0]], [[0, 0], [0, Q]], [[R]]),
    # 4.22 - 4.25
    ([[a]], [[h]], [[Q]], [[R]]),
    ([[0, 1], [0, 0]], [[0, 1]], [[0, 0], [0, Q]], [[R]]),
    ([[1, 1], [0, 1]], [[1, 0]], [[0, 0], [0, Q]], [[R]]),
    ([[-1]], [[1]], [[1]], [[1]]),
    ([[2, 0], [0, sp.Rational(1, 2)]], [[1, 0]], [[1, 0], [0, 1]], [[1]]),
]


def arrays(place, *matrices):
    return [np.array(sp.Matrix(m).subs(place).evalf(25).tolist(), dtype=float) for m in matrices]


@pytest.mark.parametrize("A, H, intensity, noise", CONTINUOUS)
def test_exact_filters_are_the_stabilising_solutions(A, H, intensity, noise):
    result = estimation.stationary_filter(A, H, intensity, noise)
    tried = 0
    for values in PLACES:
        if result.where.subs(values) == sp.false:
            continue
        tried += 1
        matrices = arrays(values, A, H, intensity, noise)
        P, K, errors = arrays(values, result.covariance, result.gain, result.errors)
        peer = scipy.linalg.solve_continuous_are(matrices[0].T, matrices[1].T, *matrices[2:])
        assert (
            np.allclose(P, peer, rtol=1e-8, atol=1e-9) and np.linalg.eigvals(errors).real.max() < 0
        )
        assert (
            np.allclose(K, P @ matrices[1].T @ np.linalg.inv(matrices[3]))
            and np.linalg.eigvalsh(P)[0] > -1e-12
        )
        floats = estimation.stationary_filter(*matrices)
        assert np.allclose(floats.covariance, P, rtol=1e-8, atol=1e-9) and floats.where == sp.true
        gain, _, _ = control.lqe(
            matrices[0], np.eye(len(P)), matrices[1], *matrices[2:], method="scipy"
        )
        assert np.allclose(floats.gain, gain, rtol=1e-7, atol=1e-9)
    assert tried == len(PLACES)


@pytest.mark.slow
@pytest.mark.parametrize("Phi, H, variance, noise", DISCRETE)
def test_exact_discrete_filters_are_limits_of_the_recursion(Phi, H, variance, noise):
    result = estimation.discrete_stationary_filter(Phi, H, variance, noise)
    tried = 0
    for values in PLACES:
        if result.where.subs(values) == sp.false:
            continue
        tried += 1
        matrices = arrays(values, Phi, H, variance, noise)
        P, after, K, errors = arrays(
            values, result.covariance, result.corrected, result.gain, result.errors
        )
        n = len(P)
        run = KalmanFilter(*matrices).run(
            np.zeros((4000, len(matrices[1]))), Moments(np.zeros(n), 3 * np.eye(n))
        )
        assert np.allclose(run.predicted_covariances[-1], P, rtol=1e-9, atol=1e-12)
        assert np.allclose(run.covariances[-1], after, rtol=1e-9, atol=1e-12)
        assert (
            np.allclose(run.gains[-1], K, rtol=1e-9) and np.abs(np.linalg.eigvals(errors)).max() < 1
        )
        floats = estimation.discrete_stationary_filter(*matrices)
        predictor, _, _ = control.dlqe(matrices[0], np.eye(n), *matrices[1:], method="scipy")
        assert np.allclose(predictor, matrices[0] @ K, rtol=1e-7, atol=1e-9)
        for exact, array in zip(
            (P, after, K, errors), (floats.covariance, floats.corrected, floats.gain, floats.errors)
        ):
            assert np.allclose(exact, array, rtol=1e-8, atol=1e-10)
    assert tried == len(PLACES)


def test_cases_of_problem_4_33():
    push = sp.diag(0, Q)
    general = estimation.stationary_filter([[0, 1], [-b, -a]], [[0, 1]], push, R)
    assert sp.Ne(b, 0) in general.where.args
    # b > 0
    stable = estimation.stationary_filter([[0, 1], [-c, -a]], [[0, 1]], push, R)
    assert stable.covariance[0, 1] == 0 and stable.where == sp.true
    assert sp.simplify(stable.covariance[1, 1] - (sp.sqrt(R**2 * a**2 + Q * R) - R * a)) == 0
    # b < 0
    unstable = estimation.stationary_filter([[0, 1], [c, -a]], [[0, 1]], push, R)
    assert sp.simplify(unstable.covariance[0, 1] - 2 * R) == 0
    # b = 0
    none = estimation.stationary_filter([[0, 1], [0, -a]], [[0, 1]], push, R)
    assert not none and "no stationary filter" in none._repr_markdown_()


def test_problems_4_38_and_4_41():
    d = sp.Symbol("d", positive=True)
    P = estimation.stationary_filter([[0, 1], [-c, -d]], [[0, 1]], sp.diag(0, Q), R).covariance
    free = estimation.stationary_covariance([[0, 1], [-c, -d]], sp.diag(0, Q)).covariance
    assert (P.applyfunc(lambda e: sp.limit(e, R, sp.oo)) - free).applyfunc(sp.simplify) == sp.zeros(
        2
    )
    assert (
        estimation.stationary_filter([[0, 1], [0, -1]], [[1, 0]], sp.diag(0, 16), 1).covariance[
            0, 0
        ]
        == 2
    )


def test_detectable_pairs_that_are_not_observable():
    result = estimation.stationary_filter(sp.diag(1, -2), [[1, 0]], sp.eye(2), 1)
    assert result and "not observable" in result.reason
    assert not feedback.detectability(sp.diag(1, 2), sp.Matrix([[1, 0]]))
    assert (
        "not detectable"
        in estimation.stationary_filter(sp.diag(1, 2), [[1, 0]], sp.eye(2), 1).reason
    )
    # an unstable mode, no noise
    quiet = estimation.stationary_filter(sp.diag(1, -2), [[1, 0]], sp.zeros(2), 1)
    assert quiet.covariance == sp.diag(2, 0) and "may be singular" in quiet.reason


@pytest.mark.parametrize(
    "verdict, word",
    [
        (
            lambda: estimation.stationary_filter([[0, 1], [0, 0]], [[0, 1]], sp.diag(0, 1), 1),
            "not detectable",
        ),
        (
            lambda: estimation.stationary_filter(np.diag([1.0, 2.0]), [[1, 0]], np.eye(2), 1),
            "not detectable",
        ),
        (
            lambda: estimation.stationary_filter([[0, 1], [-1, 0]], [[1, 0]], sp.zeros(2), 1),
            "free of noise",
        ),
        (lambda: estimation.stationary_filter(np.array([[0.0]]), 1, 0, 1), "free of noise"),
        # 4.27
        (lambda: estimation.discrete_stationary_filter(1, 1, 0, 1), "free of noise"),
        (lambda: estimation.discrete_stationary_filter(-1, 1, 0, 1), "free of noise"),
        (
            lambda: estimation.discrete_stationary_filter(np.array([[1.0]]), 1, 0, 1),
            "free of noise",
        ),
        (
            lambda: estimation.discrete_stationary_filter(sp.diag(2, 3), [[1, 0]], sp.eye(2), 1),
            "not detectable",
        ),
        (
            lambda: estimation.stationary_filter(sp.diag(c, 2), [[1, 0]], sp.eye(2), 1),
            "general values",
        ),
    ],
)
def test_no_stationary_filter_of_undetectable_pairs(verdict, word):
    result = verdict()
    assert (
        not result
        and word in result.reason
        and result.gain is None
        and word in result._repr_markdown_()
    )


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([[0, 1]], [[1, 0]], 1, 1), "square"),
        (([[0]], [[1]], [[-1]], 1), "semidefinite"),
        (([[0]], [[1]], 1, 0), "positive definite"),
        ((sp.eye(2), [[1]], sp.eye(2), 1), "any x 2"),
        ((np.eye(2), [[1, 0]], [[1, 2], [0, 1]], 1), "symmetric"),
    ],
)
def test_bad_arguments_are_rejected(arguments, message):
    for function in (estimation.stationary_filter, estimation.discrete_stationary_filter):
        with pytest.raises(ValueError, match=message):
            function(*arguments)


def test_spectra_beyond_square_roots_are_rejected():
    A = sp.Matrix([[0, 1, 0], [0, 0, 1], [1, 2, 1]])
    with pytest.raises(NotImplementedError, match="floats"):
        estimation.stationary_filter(A, [[1, 0, 0]], sp.diag(1, 0, 1), 1)
    floats = estimation.stationary_filter(
        np.array(A, dtype=float), [[1, 0, 0]], sp.diag(1, 0, 1), 1
    )
    assert floats and "P =" in floats._repr_markdown_()


def test_least_gain_is_that_of_the_kalman_filter():
    K = sp.Symbol("K")
    result = estimation.error_covariance(-1, 1, 2, 1, K)  # 4.42
    least, filtered = estimation.least_gain(result, [K]), estimation.stationary_filter(-1, 1, 2, 1)
    assert least.values[K] == filtered.gain[0] == least.variance == sp.sqrt(3) - 1
    general = estimation.least_gain(estimation.error_covariance(a, 1, Q, R, K), [K])
    assert (
        sp.simplify(general.values[K] - (a + sp.sqrt(a**2 + Q / R))) == 0
        and "min" in general._repr_latex_()
    )
    k1, k2 = sp.symbols("k1 k2")
    both = estimation.error_covariance([[0, 1], [0, 0]], [[1, 0]], sp.diag(0, 1), 1, [k1, k2])
    best = estimation.least_gain(both, [k1, k2], component=0)
    # 4.35 with Q = R = 1
    assert best.values == {k1: sp.sqrt(2), k2: 1} and best.variance == sp.sqrt(2)


def discrete_error_covariance(Phi, H, Q, R, K):
    """The stationary covariance of the errors before a correction with any gain K."""
    F = Phi @ (np.eye(len(Phi)) - K @ H)
    noise = Q + Phi @ K @ R @ K.T @ Phi.T
    return estimation.discrete_stationary_covariance(F, noise).covariance


@pytest.mark.parametrize("seed", range(3))
def test_no_other_gain_has_a_smaller_covariance(seed):
    rng = np.random.default_rng(seed)
    A, H, mixing = rng.normal(size=(3, 3)), rng.normal(size=(2, 3)), rng.normal(size=(3, 3))
    intensity, noise = mixing @ mixing.T, np.diag([1.0, 2.0])
    best = estimation.stationary_filter(A, H, intensity, noise)
    same = estimation.error_covariance(A, H, intensity, noise, best.gain)
    assert np.allclose(same.covariance, best.covariance, rtol=1e-9)
    for _ in range(20):
        other = estimation.error_covariance(
            A, H, intensity, noise, best.gain + 0.1 * rng.normal(size=(3, 2))
        )
        assert not other or np.linalg.eigvalsh(other.covariance - best.covariance)[0] > -1e-10
    Phi = scipy.linalg.expm(A / 2)
    best = estimation.discrete_stationary_filter(Phi, H, intensity, noise)
    same = discrete_error_covariance(Phi, H, intensity, noise, best.gain)
    assert np.allclose(same, best.covariance, rtol=1e-9)


def test_error_covariance_of_a_poor_gain_agrees_with_simulation():
    """A simulated filter with a gain that is 40 % too large."""
    Phi, H, variance, noise = (
        np.array([[0.9, 0.1], [0, 0.8]]),
        np.array([[1.0, 0]]),
        np.diag([0.1, 0.3]),
        [[0.5]],
    )
    K = 1.4 * estimation.discrete_stationary_filter(Phi, H, variance, noise).gain
    predicted = discrete_error_covariance(Phi, H, variance, noise, K)
    rng = np.random.default_rng(3)
    error, sums, paths = np.zeros((4000, 2)), [], 4000
    for step in range(120):
        measured = error - (error @ H.T + np.sqrt(0.5) * rng.normal(size=(paths, 1))) @ K.T
        error = measured @ Phi.T + rng.normal(size=(paths, 2)) * np.sqrt([0.1, 0.3])
        if step > 60 and step % 10 == 0:
            sums.append(error.T @ error / paths)
    assert np.abs(np.mean(sums, axis=0) / predicted - 1).max() < 0.05


def test_gains_without_a_stationary_covariance_are_rejected():
    K, _w = sp.symbols("K w")
    assert not estimation.error_covariance(1, 1, 1, 1, 0)
    with pytest.raises(ValueError, match="no stationary covariance"):
        estimation.least_gain(estimation.error_covariance(1, 1, 1, 1, 0), [K])
    with pytest.raises(ValueError, match="K: expected a matrix 2 x 1"):
        estimation.error_covariance(sp.eye(2), [[1, 0]], sp.eye(2), 1, [1, 2, 3])
    with pytest.raises(ValueError, match="exact one"):
        estimation.least_gain(estimation.error_covariance(np.array([[-1.0]]), 1, 2, 1, 1), [K])
    with pytest.raises(ValueError, match="no minimum is reached"):
        estimation.least_gain(estimation.error_covariance(-1, 0, 2, 1, 0), [K])


@pytest.mark.parametrize("start, limit", [(0.0, 0.0), (1e-6, 3.0), (9.0, 3.0)])
def test_an_undisturbed_growing_mode_is_estimated_from_a_positive_variance_only(start, limit):
    zero, one = np.zeros((1, 1)), np.eye(1)
    run = estimation.KalmanFilter(2 * one, one, zero, one).run(
        np.zeros((60, 1)), estimation.Moments([0.0], [[start]])
    )
    assert run.predicted_covariances[-1].item() == pytest.approx(limit)
    assert estimation.discrete_stationary_filter(2, 1, 0, 1).covariance[0] == 3
