"""Smoother, sampled filter and exact measurements against the joint normal distribution."""

import control
import numpy as np
import pytest
import scipy.linalg
import sympy as sp

from trajlib import estimation
from trajlib.estimation import KalmanFilter, Moments, segments, smoother


def joint(Phis, Hs, Qs, Rs, start, z, missing, inputs):
    """Return means and covariances of all states given all measurements, from least squares.

    The states are (x_0, ..., x_{N-1}) = M s + mean with independent sources s = (x_0; q_0; ...).
    """
    count, n = len(z), len(start.mean)
    maps, means = [np.hstack([np.eye(n), np.zeros((n, n * (count - 1)))])], [start.mean]
    for k in range(count - 1):
        image = Phis[k] @ maps[k]
        image[:, n * (k + 1) : n * (k + 2)] += np.eye(n)
        maps.append(image)
        means.append(Phis[k] @ means[k] + inputs[k])
    M, mean = np.vstack(maps), np.concatenate(means)
    P = M @ scipy.linalg.block_diag(start.covariance, *Qs[: count - 1]) @ M.T
    rows = np.flatnonzero(~missing.ravel())
    C = scipy.linalg.block_diag(*Hs)[rows]
    S = C @ P @ C.T + scipy.linalg.block_diag(*Rs)[np.ix_(rows, rows)]
    gain = np.linalg.solve(S, C @ P).T
    posterior = P - gain @ C @ P
    estimates = mean + gain @ (z.ravel()[rows] - C @ mean)
    blocks = [posterior[k * n : (k + 1) * n, k * n : (k + 1) * n] for k in range(count)]
    return estimates.reshape(count, n), np.array(blocks)


def random_model(seed, n=3, m=2):
    rng = np.random.default_rng(seed)
    mixing, errors = rng.normal(size=(n, n)), rng.normal(size=(m, m))
    Phi = rng.normal(size=(n, n)) / 2
    return Phi, rng.normal(size=(m, n)), mixing @ mixing.T, errors @ errors.T + np.eye(m) / 2


@pytest.mark.parametrize("varying", [False, True])
@pytest.mark.parametrize("gaps", [False, True])
@pytest.mark.parametrize("singular", [False, True])
def test_smoother_gives_the_conditional_distribution(varying, gaps, singular):
    count, rng = 23, np.random.default_rng(1)
    models = [random_model(k * varying) for k in range(count)]
    Phis, Hs, Qs, Rs = (np.array(part) for part in zip(*models))
    if singular:  # a constant that is known exactly, and a state without noise
        Phis[:, 0], Qs[:, 0], Qs[:, :, 0], Phis[:, 0, 0] = 0, 0, 0, 1
        Qs[:, 1], Qs[:, :, 1] = 0, 0
    start = Moments(rng.normal(size=3), np.diag([0.0 if singular else 2.0, 1, 4]))
    z, inputs = rng.normal(size=(count, 2)), rng.normal(size=(count, 3))
    missing = rng.random((count, 2)) < 0.4 * gaps
    model = KalmanFilter(*((Phis, Hs, Qs, Rs) if varying else (Phis[0], Hs[0], Qs[0], Rs[0])))
    run = model.run(z, start, missing, inputs)
    smoothed = run.smoothed()
    estimates, covariances = joint(Phis, Hs, Qs, Rs, start, z, missing, inputs)
    np.testing.assert_allclose(smoothed.estimates, estimates, atol=1e-9)
    np.testing.assert_allclose(smoothed.covariances, covariances, atol=1e-9)
    np.testing.assert_array_equal(smoothed.estimates[-1], run.estimates[-1])
    assert np.linalg.eigvalsh(smoothed.covariances).min() > -1e-12


@pytest.mark.parametrize("gaps", [False, True])
def test_smoother_of_a_long_run_agrees_with_a_plain_loop(gaps):
    Phi, H, Q, R = random_model(3)
    Phi = Phi / np.abs(np.linalg.eigvals(Phi)).max() * 0.99
    z, missing = np.random.default_rng(4).normal(size=(500, 2)), np.zeros(500, dtype=bool)
    missing[[250, 251, 400]] = gaps  # the gain settles before each and after each
    run = KalmanFilter(Phi, H, Q, R).run(z, Moments(np.zeros(3), np.eye(3)), missing)
    x, P = run.estimates[-1], run.covariances[-1]
    smoothed = run.smoothed()
    for k in range(len(z) - 2, -1, -1):
        before = run.predicted_covariances[k + 1]
        C = run.covariances[k] @ Phi.T @ np.linalg.inv(before)
        x = run.estimates[k] + C @ (x - run.predicted[k + 1])
        P = run.covariances[k] + C @ (P - before) @ C.T
        np.testing.assert_allclose(smoothed.estimates[k], x, atol=1e-10)
        np.testing.assert_allclose(smoothed.covariances[k], P, atol=1e-10)


@pytest.mark.parametrize("varying, series", [(False, None), (True, None), (False, 2)])
@pytest.mark.parametrize("variance, noise", [(1.0, 1.0), (1e8, 1.0), (1e8, 0.0)])
def test_a_long_record_is_smoothed_as_by_single_steps(
    varying, series, variance, noise, monkeypatch
):
    """The variance of a state not yet observed falls by many powers of ten."""
    # 35 segments; steps that lose digits are among them, not among the 25 steps before.
    count, rng = 1250 if variance == 1 else 1225, np.random.default_rng(20)
    Phi, H, Q, R = random_model(21, 4)
    Phi = np.linalg.qr(Phi)[0]
    if varying:
        Q, R = Q * rng.uniform(0.5, 2, (count, 1, 1)), R * rng.uniform(0.5, 2, (count, 1, 1))
    z = rng.normal(size=(count, 2) if series is None else (series, count, 2))
    missing = np.broadcast_to(rng.random((count, 2)) < 0.2, z.shape)
    run = KalmanFilter(Phi, H, noise * Q, R).run(
        z, Moments(np.zeros(4), variance * np.eye(4)), missing
    )
    smoothed = run.smoothed()
    monkeypatch.setattr(segments, "LEAST_STEPS", np.inf)
    stepped = run.smoothed()
    deviations = np.sqrt(np.einsum("...ii->...i", stepped.covariances))
    errors = (smoothed.estimates - stepped.estimates) / deviations
    changes = smoothed.covariances - stepped.covariances
    assert np.abs(errors).max() < 1e-9
    assert np.abs(changes / (deviations[..., None] * deviations[..., None, :])).max() < 1e-9
    assert (smoothed.estimates != stepped.estimates).any()  # by another recursion


def test_steps_that_repeat_in_part_are_smoothed_as_by_single_steps(monkeypatch):
    Phi, H, Q, R = random_model(3)
    Phi, missing = Phi / np.abs(np.linalg.eigvals(Phi)).max() * 0.99, np.zeros(1250, dtype=bool)
    missing[[250, 500, 750, 1000]] = True
    z = np.random.default_rng(4).normal(size=(1250, 2))
    run = KalmanFilter(Phi, H, Q, R).run(z, Moments(np.zeros(3), np.eye(3)), missing)
    monkeypatch.setattr(smoother, "REPEATED", 0)
    smoothed = run.smoothed()
    assert len(np.unique(run.matrix_index)) < len(z)
    monkeypatch.setattr(segments, "LEAST_STEPS", np.inf)
    stepped = run.smoothed()
    np.testing.assert_allclose(smoothed.estimates, stepped.estimates, atol=1e-10)
    np.testing.assert_allclose(smoothed.covariances, stepped.covariances, atol=1e-10)


def test_smoothed_covariances_have_the_scale_of_the_model():
    """Whether they have converged is judged by their own size."""
    Phi, (_, H, Q, R) = 0.9 * np.eye(3), random_model(3)
    z, covariances = np.random.default_rng(4).normal(size=(300, 2)), []
    for c in (1, 1e-12):
        run = KalmanFilter(Phi, H, c * Q, c * R).run(z, Moments(np.zeros(3), c * np.eye(3)))
        covariances.append(run.smoothed().covariances / c)
    np.testing.assert_allclose(covariances[1], covariances[0], atol=1e-10)


def test_many_series_are_smoothed_like_single_ones():
    Phi, H, Q, R = random_model(5)
    rng = np.random.default_rng(6)
    z, missing = rng.normal(size=(4, 30, 2)), rng.random((4, 30, 2)) < 0.3
    missing[2] = missing[0]
    model, start = KalmanFilter(Phi, H, Q, R), Moments(np.zeros(3), np.eye(3))
    smoothed = model.run(z, start, missing).smoothed()
    for series in range(4):
        alone = model.run(z[series], start, missing[series]).smoothed()
        np.testing.assert_allclose(smoothed.estimates[series], alone.estimates, atol=1e-12)
        np.testing.assert_allclose(smoothed.covariances[series], alone.covariances, atol=1e-12)


def test_errors_of_the_smoother_agree_with_its_covariances():
    Phi, H, Q, R = random_model(7)
    start = Moments(np.zeros(3), np.eye(3))
    paths = estimation.simulate_discrete(Phi, Q, start, 12, 4000, 8, H, R)
    missing = np.zeros((4000, 12, 2), dtype=bool)
    missing[:, 4:7] = True
    smoothed = KalmanFilter(Phi, H, Q, R).run(paths.measurements, start, missing).smoothed()
    for k in (0, 5, 11):
        errors, P = paths.states[:, k] - smoothed.estimates[:, k], smoothed.covariances[0, k]
        assert estimation.covariance_consistency(errors, P)
        assert not estimation.covariance_consistency(errors, 0.9 * P)


# An oscillator, x and v, with its position measured.
A, H = np.array([[0.0, 1.0], [-4.0, -0.4]]), np.array([[1.0, 0.0]])
INTENSITY, R = np.diag([0.0, 2.0]), np.array([[0.1]])
TIMES = np.cumsum(np.random.default_rng(9).exponential(0.5, 30)).round(2)


def test_sampled_filter_agrees_with_the_continuous_discrete_one():
    start, z = Moments(np.array([1.0, 0]), np.eye(2)), np.random.default_rng(10).normal(size=30)
    system = control.ss(A, np.eye(2), H, 0)
    run = KalmanFilter.sampled(system, INTENSITY, R, TIMES).run(z, start)
    rows = [estimation.Measurement(time, value, H, R) for time, value in zip(TIMES, z)]
    other = estimation.filter_measurements(A, INTENSITY, start, rows, TIMES[0])
    np.testing.assert_allclose(run.estimates, [after.mean for after in other.after], atol=1e-12)
    np.testing.assert_allclose(run.covariances, [a.covariance for a in other.after], atol=1e-12)
    np.testing.assert_array_equal(run.times, TIMES)

    for k, moments in enumerate(other.smoothed()):
        np.testing.assert_allclose(run.smoothed().estimates[k], moments.mean, atol=1e-11)
        np.testing.assert_allclose(run.smoothed().covariances[k], moments.covariance, atol=1e-11)


def test_exact_smoother_of_two_measurements():
    """By least squares: x_0 of variance 1, then x_1 - x_0 of variance q t, both measured."""
    q, t, z0, z1 = sp.symbols("q t z0 z1", positive=True)
    rows = [estimation.Measurement(0, z0, 1, 1), estimation.Measurement(t, z1, 1, 1)]
    first, _ = estimation.filter_measurements(0, q, Moments(0, 1), rows).smoothed()
    inverse = sp.Matrix([[2 + 1 / (q * t), -1 / (q * t)], [-1 / (q * t), 1 + 1 / (q * t)]])
    covariance = inverse.inv()
    assert sp.simplify(first.covariance[0] - covariance[0]) == 0
    assert sp.simplify(first.mean[0] - (covariance * sp.Matrix([z0, z1]))[0]) == 0


def test_smoother_at_irregular_times_does_not_depend_on_times_without_measurement():
    start, z = Moments(np.zeros(2), np.eye(2)), np.random.default_rng(11).normal(size=30)
    whole = KalmanFilter.sampled(A, H, INTENSITY, R, TIMES).run(z, start).smoothed()
    between = np.sort(np.concatenate([TIMES, (TIMES[1:] + TIMES[:-1]) / 2]))
    measured = np.isin(between, TIMES)
    data = np.zeros(len(between))
    data[measured] = z
    finer = KalmanFilter.sampled(A, H, INTENSITY, R, between).run(data, start, ~measured)
    np.testing.assert_allclose(finer.smoothed().estimates[measured], whole.estimates, atol=1e-11)
    np.testing.assert_allclose(
        finer.smoothed().covariances[measured], whole.covariances, atol=1e-11
    )


def test_steps_of_all_lengths_are_discretised_as_by_scipy():
    rng = np.random.default_rng(12)
    system, noise = rng.normal(size=(4, 4)), rng.normal(size=(4, 4))
    noise = noise @ noise.T
    steps = np.concatenate([[0.0], np.geomspace(1e-9, 5, 40)])
    times = np.cumsum(steps)
    filter = KalmanFilter.sampled(system, np.eye(4), noise, np.eye(4), times)
    for k, step in enumerate(np.diff(times)):
        both = np.block([[-system, noise], [np.zeros((4, 4)), system.T]])
        power = scipy.linalg.expm(both * step)
        Phi = power[4:, 4:].T
        scale = np.abs(filter.Q[k]).max() or 1
        np.testing.assert_allclose(filter.Phi[k], Phi, atol=1e-12 * np.abs(Phi).max())
        np.testing.assert_allclose(filter.Q[k], Phi @ power[:4, 4:], atol=1e-11 * scale)


@pytest.mark.parametrize("step", [1e-3, 0.7, 40.0])
def test_discretisation_with_input_agrees_with_python_control(step):
    B = np.array([[0.0, 3e3], [1.0, 0.2]])
    model = estimation.discretise_with_input(A, B, INTENSITY, step)
    sampled = control.sample_system(control.ss(A, B, H, 0), step)
    np.testing.assert_allclose(model.Phi, sampled.A, atol=1e-12)
    np.testing.assert_allclose(model.B, sampled.B, rtol=1e-10, atol=1e-11)
    np.testing.assert_allclose(model.Q, estimation.discretise(A, INTENSITY, step).Q, atol=1e-13)


def test_exact_measurement_is_the_limit_of_precise_ones():
    Phi, H2, Q, _ = random_model(13)
    z, start = np.random.default_rng(14).normal(size=(40, 2)), Moments(np.zeros(3), np.eye(3))
    exact = KalmanFilter(Phi, H2, Q, np.diag([0.0, 1.0])).run(z, start)
    precise = KalmanFilter(Phi, H2, Q, np.diag([1e-9, 1.0])).run(z, start)
    np.testing.assert_allclose(exact.estimates, precise.estimates, atol=1e-6)
    np.testing.assert_allclose(exact.estimates @ H2[0], z[:, 0], atol=1e-11)
    smoothed = exact.smoothed()
    np.testing.assert_allclose(smoothed.estimates @ H2[0], z[:, 0], atol=1e-9)
    np.testing.assert_allclose(smoothed.estimates, precise.smoothed().estimates, atol=1e-6)


@pytest.mark.parametrize("row", [[1.0, 0, 0], [0.3, -0.7, 1.1]])
def test_exact_measurement_of_what_is_known_exactly_is_refused(row):
    model = KalmanFilter(np.eye(3), [row], np.zeros((3, 3)), [[0.0]])
    with pytest.raises(ValueError, match=r"repeats what is known exactly already.*measurement 1"):
        model.run(np.ones(3), Moments(np.zeros(3), np.eye(3)))
    assert model.run(np.ones(1), Moments(np.zeros(3), np.eye(3))).covariances.shape == (1, 3, 3)


def test_exact_measurements_in_single_corrections():
    exact = estimation.corrected(Moments([0, 0], [[2, 1], [1, 1]]), 3, [[1, 0]], 0)
    assert exact.estimate.tolist() == [[3], [sp.Rational(3, 2)]]
    assert exact.covariance.tolist() == [[0, 0], [0, sp.Rational(1, 2)]]
    with pytest.raises(ValueError, match="repeats what is known exactly already"):
        estimation.corrected(exact.moments, 3, [[1, 0]], 0)
    with pytest.raises(ValueError, match="R: .*positive definite.*an exact measurement"):
        estimation.ContinuousFilter(0, 1, 1, 0)
    with pytest.raises(ValueError, match="R: .*positive definite.*an exact measurement"):
        estimation.stationary_filter(A, H, INTENSITY, [[0.0]])


def test_pictures_show_states_bands_and_innovations():
    import matplotlib.pyplot as plt

    start = Moments(np.zeros(2), np.eye(2))
    paths = estimation.simulate_continuous(A, INTENSITY, start, TIMES, 2, 15, H, R)
    missing = np.zeros((2, 30), dtype=bool)
    missing[1, 3:8] = True
    run = KalmanFilter.sampled(A, H, INTENSITY, R, TIMES).run(paths.measurements, start, missing)
    axes = run.plot(series=1, truth=paths.states[1])
    assert len(axes) == 3 and axes[-1].get_ylabel() == "innovations"
    drawn = axes[0].lines[0]
    np.testing.assert_array_equal(drawn.get_xdata(), TIMES)
    np.testing.assert_array_equal(drawn.get_ydata(), run.estimates[1, :, 0])
    deviations = np.sqrt(run.covariances[1, :, 0, 0])
    np.testing.assert_allclose(
        axes[0].lines[2].get_ydata(), run.estimates[1, :, 0] + 2 * deviations
    )
    scaled = run.innovations[1, :, 0] / np.sqrt(run.innovation_covariances[1, :, 0, 0])
    np.testing.assert_allclose(axes[-1].lines[0].get_ydata(), scaled)
    assert len(run.smoothed().plot(series=1)) == 2
    plt.close("all")


def test_segments_start_from_the_right_covariances_without_process_noise():
    """No step is forgotten then; wrong starts would only be slow, as all steps are taken again."""
    Phi, H, Q, R = random_model(21, 4)
    matrices, missing = (np.linalg.qr(Phi)[0], H, 0 * Q, R), np.zeros((1200, 2), dtype=bool)
    results = [np.empty((1200, 4, columns)) for columns in (4, 4, 2)]
    assert segments.covariance_segments(matrices, np.eye(4), missing, 30, results)
