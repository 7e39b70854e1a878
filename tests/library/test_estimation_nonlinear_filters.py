"""Extended and unscented filters against the linear filter, loops by hand, and statistics."""

import numpy as np
import pytest
import sympy as sp

from trajlib import estimation
from trajlib.estimation import ExtendedKalmanFilter, KalmanFilter, Moments, UnscentedKalmanFilter

BOTH = [ExtendedKalmanFilter, UnscentedKalmanFilter]
x, y, v, w, u = sp.symbols("x y v w u")


@pytest.mark.parametrize("kind", BOTH)
@pytest.mark.parametrize("singular", [False, True])
def test_linear_functions_give_the_kalman_filter(kind, singular):
    rng = np.random.default_rng(1)
    Phi, H = rng.normal(size=(3, 3)) / 2, rng.normal(size=(2, 3))
    Q, R = np.diag([0.5, 0.2, 0.0 if singular else 0.1]), np.array([[1.0, 0.3], [0.3, 0.5]])
    z, inputs, missing = rng.normal(size=(25, 2)), rng.normal(size=25), rng.random((25, 2)) < 0.3
    start = Moments(rng.normal(size=3), np.diag([1.0, 4, 0 if singular else 2]))
    states = sp.Matrix([x, y, v])
    f = sp.Matrix(Phi) * states + sp.Matrix([0, u, 2 * u])
    filter = kind(f, sp.Matrix(H) * states, [x, y, v], Q, R, [u])
    run = filter.run(z, start, missing, inputs)
    known = inputs[:, None] * [0, 1, 2]
    linear = KalmanFilter(Phi, H, Q, R).run(z, start, missing, known)
    for name in ("predicted", "estimates", "covariances", "innovations", "gains"):
        np.testing.assert_allclose(getattr(run, name), getattr(linear, name), atol=1e-12)
    assert run.log_likelihood == pytest.approx(linear.log_likelihood, rel=1e-12)
    smoothed, other = run.smoothed(), linear.smoothed()
    np.testing.assert_allclose(smoothed.estimates, other.estimates, atol=1e-10)
    np.testing.assert_allclose(smoothed.covariances, other.covariances, atol=1e-10)


STEP = 0.1


def pendulum(state, push):
    """One Euler step of a pendulum, and its measured horizontal position and rate."""
    return np.array([state[0] + STEP * state[1], state[1] - STEP * np.sin(state[0]) + push])


def shown(state):
    return np.array([np.sin(state[0]), state[1]])


def by_complex_steps(function, state, *arguments):
    """Return the Jacobian: the imaginary part of a tiny imaginary step has no cancellation."""
    columns = [function(state + 1e-30j * e, *arguments).imag / 1e-30 for e in np.eye(len(state))]
    return np.array(columns).T


def test_extended_filter_agrees_with_a_loop_by_hand():
    rng = np.random.default_rng(2)
    Q, R, P, state = np.diag([1e-4, 1e-2]), np.diag([0.1, 0.2]), np.eye(2), np.array([0.5, 1.0])
    z, pushes = rng.normal(size=(40, 2)), rng.normal(size=40) / 10
    f, h = [x + STEP * y, y - STEP * sp.sin(x) + u], [sp.sin(x), y]
    run = ExtendedKalmanFilter(f, h, [x, y], Q, R, [u]).run(z, Moments(state, P), inputs=pushes)
    for k in range(40):
        np.testing.assert_allclose(run.predicted[k], state, atol=1e-12)
        H = by_complex_steps(shown, state)
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        state, P = state + K @ (z[k] - shown(state)), (np.eye(2) - K @ H) @ P
        np.testing.assert_allclose(run.estimates[k], state, atol=1e-12)
        np.testing.assert_allclose(run.covariances[k], P, atol=1e-12)
        F = by_complex_steps(pendulum, state, pushes[k])
        state, P = pendulum(state, pushes[k]), F @ P @ F.T + Q


def test_unscented_filter_agrees_with_a_loop_by_hand():
    z, mean, P, Q, R = np.random.default_rng(3).normal(size=20), 0.3, 0.8, 0.05, 0.4
    model = [sp.sin(x) + x / 2], [sp.exp(x / 3)], [x]
    run = UnscentedKalmanFilter(*model, Q, R).run(z, Moments(mean, P))
    weights = np.array([2, 0.5, 0.5]) / 3
    for k in range(20):
        points = mean + np.sqrt(3 * P) * np.array([0, 1, -1])
        images = np.exp(points / 3)
        spread = weights @ (images - weights @ images) ** 2 + R
        gain = weights @ ((points - mean) * (images - weights @ images)) / spread
        mean, P = mean + gain * (z[k] - weights @ images), P - gain**2 * spread
        assert run.estimates[k, 0] == pytest.approx(mean, abs=1e-12)
        assert run.covariances[k, 0, 0] == pytest.approx(P, rel=1e-10)
        images = np.sin(mean + np.sqrt(3 * P) * np.array([0, 1, -1]))
        images = images + (mean + np.sqrt(3 * P) * np.array([0, 1, -1])) / 2
        mean = weights @ images
        P = weights @ (images - mean) ** 2 + Q


@pytest.mark.parametrize("kappa", [None, 0, 1.5])
def test_unscented_means_of_quadratic_functions_are_exact(kappa):
    P = np.array([[2.0, 0.7, 0.1], [0.7, 1.0, -0.3], [0.1, -0.3, 0.5]])
    mean = np.array([1.0, -2.0, 0.5])
    filter = UnscentedKalmanFilter([x * y, v**2, x], [x], [x, y, v], 0 * P, 1, kappa=kappa)
    predicted = filter.run(np.zeros(2), Moments(mean, P), [True, True]).predicted[1]
    np.testing.assert_allclose(predicted, [-2 + 0.7, 0.25 + 0.5, 1], atol=1e-12)


@pytest.mark.parametrize("kind", BOTH)
def test_errors_of_a_vehicle_seen_by_range_and_bearing_agree_with_the_covariances(kind):
    rng = np.random.default_rng(4)
    f, h = [x + v, y + w, v, w], [sp.sqrt(x**2 + y**2), sp.atan2(y, x)]
    Q, R = np.diag([0.0, 0, 0.01, 0.01]), np.diag([0.25, 1e-5])
    states, errors = [], []
    filter = kind(f, h, [x, y, v, w], Q, R)
    wrong = kind(f, h, [x, y, v, w], Q, R / 2)
    start = Moments(np.array([100.0, 50, -1, 1]), np.diag([4.0, 4, 0.1, 0.1]))
    for _ in range(60):
        state = start.mean + rng.normal(size=4) * np.sqrt(np.diag(start.covariance))
        path = [state]
        for _ in range(39):
            state = state + np.append(state[2:], rng.normal(size=2) / 10)
            path.append(state)
        path = np.array(path)
        exact = np.stack([np.hypot(path[:, 0], path[:, 1]), np.arctan2(path[:, 1], path[:, 0])], 1)
        z = exact + rng.normal(size=exact.shape) * np.sqrt(np.diag(R))
        run = filter.run(z, start)
        states.append(run.normalised_innovations.sum())
        errors.append(wrong.run(z, start).normalised_innovations.sum())
        smoothed = run.smoothed()
        assert np.trace(smoothed.covariances[5]) < np.trace(run.covariances[5])
    total, freedom = np.sum(states), 60 * 40 * 2
    assert abs(total / freedom - 1) < 3.5 * np.sqrt(2 / freedom)
    assert abs(np.sum(errors) / freedom - 1) > 5 * np.sqrt(2 / freedom)


@pytest.mark.parametrize("kind", BOTH)
@pytest.mark.parametrize(
    "change, message",
    [
        ({"f": [w * x]}, "f: w is neither a state nor an input"),
        ({"h": [u]}, "h: u is neither"),
        ({"f": [x, x]}, "f: expected 1 components"),
        ({"Q": -1}, "Q: expected a positive semidefinite"),
        ({"R": np.eye(2)}, "R: expected a matrix 1 x 1"),
        ({"f": [sp.log(x - 5)]}, "f: not a finite real number"),
        ({"f": [x + u], "inputs": [u]}, "inputs: expected 1 number for"),
        ({"z": np.zeros((2, 3, 1))}, "run each series by itself"),
    ],
)
def test_bad_arguments_are_rejected(kind, change, message):
    arguments = {"f": [x], "h": [x], "states": [x], "Q": 1, "R": 1, "z": np.zeros(3)} | change
    z = arguments.pop("z")
    with pytest.raises(ValueError, match=message):
        kind(**arguments).run(z, Moments(0, 1))


def test_negative_weight_is_refused():
    with pytest.raises(ValueError, match="kappa"):
        UnscentedKalmanFilter([x], [x], [x], 1, 1, kappa=-1)


def test_innovations_are_tested_as_those_of_the_linear_filter():
    start = Moments(np.zeros(1), np.eye(1))
    paths = estimation.simulate_discrete(0.9, 1, start, 3000, 1, 5, 1, 1)
    run = UnscentedKalmanFilter([sp.Rational(9, 10) * x], [x], [x], 1, 1).run(
        paths.measurements[0], start
    )
    assert estimation.innovation_consistency(run)
