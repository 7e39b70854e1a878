"""The discrete filter against conditioning of the joint distribution, a plain loop, and statistics."""

import numpy as np
import pytest
import scipy.linalg
import scipy.stats
import sympy as sp

from trajlib import estimation
from trajlib.estimation import (
    KalmanFilter,
    Moments,
    segments,
)


def model_of(seed, n=3, m=2, radius=0.95):
    rng = np.random.default_rng(seed)
    Phi = rng.normal(size=(n, n))
    Phi *= radius / np.abs(np.linalg.eigvals(Phi)).max()
    B, C = rng.normal(size=(n, n)), rng.normal(size=(m, m))
    return Phi, rng.normal(size=(m, n)), B @ B.T, C @ C.T + np.eye(m) / 2


def root(P):
    values, vectors = np.linalg.eigh(P)
    return vectors * np.sqrt(np.maximum(values, 0)) @ vectors.T


def drawn(Phi, H, Q, R, start, count, seed, series=1):
    """States and measurements of a system, S x N x n and S x N x m."""
    rng = np.random.default_rng(seed)
    roots = [root(matrix) for matrix in (Q, R, start.covariance)]
    x = start.mean + rng.normal(size=(series, len(Phi))) @ roots[2]
    states, z = [], []
    for _ in range(count):
        states.append(x)
        z.append(x @ H.T + rng.normal(size=(series, len(H))) @ roots[1])
        x = x @ Phi.T + rng.normal(size=x.shape) @ roots[0]
    return np.stack(states, axis=1), np.stack(z, axis=1)


def conditioned(Phis, Hs, Qs, Rs, start, z, missing, known):
    """Means and covariances of x_k given z_0, ..., z_k, and the log-likelihood, from the joint
    distribution alone."""
    count, n = len(z), len(start.mean)
    # x = M (x_0; q_0; q_1; ...) + shift
    maps, shift, means = [np.hstack([np.eye(n), np.zeros((n, n * count))])], start.mean, []
    for k in range(count):
        means.append(shift)
        after = Phis[k] @ maps[k]
        after[:, n * (k + 1) : n * (k + 2)] += np.eye(n)
        maps.append(after)
        shift = Phis[k] @ shift + known[k]
    sources = scipy.linalg.block_diag(start.covariance, *Qs[:count])
    states = np.vstack(maps[:count])
    P, measurement_map = states @ sources @ states.T, scipy.linalg.block_diag(*Hs)
    result, data, present = [], z.ravel(), ~missing.ravel()
    noise = scipy.linalg.block_diag(*Rs)
    mean = np.concatenate(means)
    for k in range(count):
        rows = np.flatnonzero(present[: (k + 1) * z.shape[1]])
        C, part = measurement_map[rows], slice(k * n, (k + 1) * n)
        S = C @ P @ C.T + noise[np.ix_(rows, rows)]
        gain = np.linalg.solve(S, C @ P[:, part]).T
        result.append(
            (mean[part] + gain @ (data[rows] - C @ mean), P[part, part] - gain @ C @ P[:, part])
        )
    rows = np.flatnonzero(present)
    C = measurement_map[rows]
    log = scipy.stats.multivariate_normal(C @ mean, C @ P @ C.T + noise[np.ix_(rows, rows)]).logpdf(
        data[rows]
    )
    return [np.array(part) for part in zip(*result)], log


@pytest.mark.parametrize(
    "seed, gaps, varying", [(1, False, False), (2, True, False), (3, True, True)]
)
def test_filter_gives_the_conditional_distribution(seed, gaps, varying):
    count, rng = 14, np.random.default_rng(seed)
    models = [model_of(seed + 10 * k * varying) for k in range(count)]
    stacks = [np.array(part) for part in zip(*models)]
    start, known = Moments(rng.normal(size=3), np.diag([2.0, 0, 1])), rng.normal(size=(count, 3))
    z = drawn(*models[0], start, count, seed)[1][0]
    missing = rng.random(z.shape) < (0.4 if gaps else 0)
    missing[5] = gaps
    z = np.where(missing, np.nan, z)
    run = KalmanFilter(*(stacks if varying else models[0])).run(z, start, missing, known)
    (means, covariances), likelihood = conditioned(*stacks, start, np.nan_to_num(z), missing, known)
    assert np.allclose(run.estimates, means, atol=1e-11) and np.allclose(
        run.covariances, covariances, atol=1e-11
    )
    assert run.log_likelihood == pytest.approx(likelihood, rel=1e-11)
    assert (
        np.array_equal(np.isnan(run.innovations), missing)
        and run.measured.sum() == (~missing).sum()
    )


def plain_loop(Phi, H, Q, R, z, start, missing=None):
    """Theorem 4.1 as it stands, with inverses."""
    x, P, result = start.mean, start.covariance, []
    for k, row in enumerate(z):
        predicted = x, P
        if missing is None or not missing[k]:
            K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
            x, P = x + K @ (row - H @ x), (np.eye(len(x)) - K @ H) @ P
        result.append((*predicted, x, P))
        x, P = Phi @ x, Phi @ P @ Phi.T + Q
    return [np.array(part) for part in zip(*result)]


@pytest.mark.parametrize("radius", [0.5, 0.99, 1.02])
def test_converged_gain_agrees_with_the_full_recursion(radius):
    model = model_of(4, 4, 2, radius)
    start = Moments(np.ones(4), np.eye(4))
    z = drawn(*model, start, 700, 5)[1][0]
    missing = np.zeros(700, dtype=bool)
    missing[[300, 301, 450]] = True
    run = KalmanFilter(*model).run(z, start, missing)
    assert len(set(run.matrix_index)) < 400  # it was kept
    peers = plain_loop(*model, z, start, missing)
    for mine, peer in zip(
        (run.predicted, run.predicted_covariances, run.estimates, run.covariances), peers
    ):
        scale = np.abs(peer).max(axis=0)
        assert np.abs((mine - peer) / scale).max() < 1e-12


def test_slowly_converging_gain_is_not_kept():
    """A state that barely moves: one step changes little long before the limit is reached."""
    model = [np.array([[1.0]]), np.array([[1.0]]), np.array([[1e-12]]), np.array([[1.0]])]
    start = Moments(np.zeros(1), np.eye(1))
    run = KalmanFilter(*model).run(np.ones(4000), start)
    peer = plain_loop(*model, np.ones((4000, 1)), start)
    assert len(set(run.matrix_index)) == 4000 and np.allclose(run.covariances, peer[3], rtol=1e-11)


def test_many_series_agree_with_single_ones():
    model = model_of(6)
    start = Moments(np.zeros(3), np.eye(3))
    z = drawn(*model, start, 120, 7, series=5)[1]
    missing = np.zeros(z.shape, dtype=bool)
    missing[1:3, 20:25], missing[4, 7, 1] = True, True
    both = KalmanFilter(*model).run(z, start, missing)
    for s in range(5):
        single = KalmanFilter(*model).run(z[s], start, missing[s])
        assert np.allclose(single.estimates, both.estimates[s], atol=1e-13)
        assert np.allclose(single.covariances, both.covariances[s], atol=1e-14)
        assert single.log_likelihood == pytest.approx(both.log_likelihood[s], rel=1e-12)
    masked = KalmanFilter(*model).run(np.ma.array(z, mask=missing), start)
    assert np.array_equal(masked.estimates, both.estimates) and "120 steps" in repr(both)


def test_innovations_and_errors_agree_with_their_covariances():
    """For the right model; a gain that is wrong by 5 % is seen."""
    model = model_of(8, 4, 2, 0.9)
    Phi, H, Q, R = model
    start = Moments(np.zeros(4), estimation.discrete_stationary_covariance(Phi, Q).covariance)
    states, z = drawn(*model, start, 250, 9, series=400)
    run = KalmanFilter(*model).run(z, start)
    count = 400 * 250
    squares = run.normalised_innovations
    assert abs(squares.mean() - 2) < 3 * np.sqrt(2 * 2 / count)
    assert 0.001 < scipy.stats.kstest(squares.ravel()[::7], "chi2", (2,)).pvalue
    errors = run.estimates - states
    ends = errors[:, -1]
    sure = np.linalg.inv(run.covariances[0, -1])
    assert abs(np.einsum("si,ij,sj->s", ends, sure, ends).mean() - 4) < 3 * np.sqrt(2 * 4 / 400)
    # successive innovations do not correlate: lagged by one step, white ones stay below the limit
    roots, limit = np.linalg.cholesky(run.innovation_covariances[0, -1]), 4 / np.sqrt(400 * 199)

    def lagged(innovations):
        white = np.linalg.solve(roots, innovations.reshape(-1, 2).T).T.reshape(400, 200, 2)
        return np.abs(np.einsum("ski,skj->ij", white[:, 1:], white[:, :-1]) / (400 * 199)).max()

    assert lagged(run.innovations[:, 50:]) < limit
    for factor in (0.95, 1.05):
        x, measurement_map = run.predicted[:, 50], []
        for k in range(50, 250):
            measurement_map.append(z[:, k] - x @ H.T)
            x = (x + measurement_map[-1] @ (factor * run.gains[0, -1]).T) @ Phi.T
        assert lagged(np.stack(measurement_map, axis=1)) > 2 * limit
    off = KalmanFilter(Phi, H, Q, 1.2 * R).run(z, start).normalised_innovations
    # the test has the power to see it
    assert abs(off.mean() - 2) > 10 * np.sqrt(2 * 2 / count)


def test_covariance_stays_symmetric_and_definite_over_a_million_steps():
    """An almost exact measurement of a chain of integrators: the plain formula loses symmetry
    here."""
    Phi = np.eye(4) + np.diag(np.full(3, 1e-2), 1)
    model = KalmanFilter(Phi, np.eye(4)[:1], np.diag([0, 0, 0, 1e-8]), 1e-8)
    run = model.run(np.zeros(1_000_000), Moments(np.zeros(4), 1e6 * np.eye(4)))
    last = run._steps[1][run.matrix_index[-1]]
    units = np.sqrt(np.diag(last))
    assert np.array_equal(last, last.T) and np.linalg.eigvalsh(last / np.outer(units, units))[0] > 0
    limit = scipy.linalg.solve_discrete_are(Phi.T, model.H.T, model.Q, model.R)
    assert np.allclose(run._steps[0][run.matrix_index[-1]], limit, rtol=1e-6)


def test_covariances_of_a_long_time_varying_run_stay_definite():
    count, rng = 20_000, np.random.default_rng(1)
    Phi = np.eye(3) + np.diag([0.1, 0.1], 1)
    R = np.where(rng.random(count) < 0.5, 1e-10, 1e4).reshape(-1, 1, 1)
    run = KalmanFilter(Phi, np.eye(3)[:1], np.diag([0, 0, 1e-6]), R).run(
        np.zeros(count), Moments(np.zeros(3), 1e8 * np.eye(3))
    )
    P = run.covariances
    assert np.array_equal(P, P.transpose(0, 2, 1)) and (np.einsum("kii->ki", P) > 0).all()
    units = np.sqrt(np.einsum("kii->ki", P))
    assert np.linalg.eigvalsh(P / (units[:, :, None] * units[:, None, :])).min() > -1e-12


def test_simultaneous_measurements_together_or_sequentially():
    h1, h2 = sp.symbols("h1 h2")
    prior = Moments([1, 2], [[2, 1], [1, 3]])
    both = estimation.corrected(prior, [3, 4], [[1, 0], [h1, h2]], sp.diag(1, 2))
    first = estimation.corrected(prior, [3], [[1, 0]], 1)
    second = estimation.corrected(first.moments, [4], [[h1, h2]], 2)
    assert (both.estimate - second.estimate).applyfunc(sp.simplify) == sp.zeros(2, 1)
    assert (both.covariance - second.covariance).applyfunc(sp.simplify) == sp.zeros(2)
    floats = estimation.corrected(prior, np.array([3.0, 4.0]), [[1, 0], [5, 6]], sp.diag(1, 2))
    exact = both.estimate.subs({h1: 5, h2: 6})
    assert np.allclose(floats.estimate, np.array(exact, dtype=float).ravel(), atol=1e-14)
    assert "K =" in floats._repr_latex_() and "K =" in both._repr_latex_()


def test_example_5_and_problem_4_43():
    T, Q, R, D = sp.symbols("T Q R D", positive=True)
    P = estimation.continuous_moments(
        [[0, 1], [0, 0]], sp.diag(0, Q), Moments([0, 0], sp.zeros(2)), T
    )
    after = estimation.corrected(P, 0, [[0, 1]], R).covariance
    assert sp.simplify(after[0, 0] - (Q * T**3 / 3 - (Q * T**2 / 2) ** 2 / (Q * T + R))) == 0
    A = [[0, 1, 0], [0, 0, 1], [0, 0, 0]]
    P = estimation.continuous_moments(A, sp.zeros(3), Moments([0, 0, 0], sp.diag(0, 0, D)), T)
    after = estimation.corrected(P, 0, [[0, 1, 0]], R).covariance
    assert (
        P.correlation[0, 1] == 1
        and sp.simplify(after[0, 0] - D * T**4 / 4 * R / (D * T**2 + R)) == 0
    )


@pytest.mark.parametrize(
    "change, message",
    [
        ({"z": [1.0, np.nan]}, r"\(1, 0\) is nan; mark it"),
        ({"z": [1.0, np.inf]}, "mark it"),
        ({"z": np.zeros((2, 2))}, "expected the shape"),
        ({"R": 0, "Q": np.zeros((2, 2))}, "repeats what is known exactly"),
        ({"R": -1}, "positive semidefinite"),
        ({"Q": [[1, 1], [0, 1]]}, "symmetric"),
        ({"Q": np.diag([1.0, -1.0])}, "semidefinite"),
        ({"Phi": [[1, 0]]}, "square"),
        ({"H": [[1, 0, 0]]}, "any x 2"),
        ({"start": Moments([0], [[1]])}, "2 components"),
        ({"missing": [True]}, "booleans"),
        ({"missing": [0, 1]}, "booleans"),
        ({"Q": np.zeros((3, 2, 2))}, "each step"),
        ({"z": []}, "expected the shape"),
    ],
)
def test_bad_arguments_are_rejected(change, message):
    arguments = {
        "Phi": np.eye(2),
        "H": [[1, 0]],
        "Q": np.eye(2),
        "R": 1,
        "z": [1.0, 2.0],
        "missing": None,
        "start": Moments([0, 0], sp.eye(2)),
    } | change
    with pytest.raises(ValueError, match=message):
        KalmanFilter(arguments["Phi"], arguments["H"], arguments["Q"], arguments["R"]).run(
            arguments["z"], arguments["start"], arguments["missing"]
        )


def test_overflowing_covariance_is_rejected():
    """Unobserved and unstable: the variance overflows, and no number is given."""
    model = KalmanFilter([[3, 0], [0, 1]], [[0, 1]], np.eye(2), 1)
    with pytest.raises(ValueError, match="definiteness"), np.errstate(all="ignore"):
        model.run(np.zeros(800), Moments([0, 0], sp.eye(2)))


@pytest.mark.parametrize("n, m", [(1, 1), (2, 3), (4, 2), (8, 1), (9, 1), (16, 2)])
@pytest.mark.parametrize("varying, series", [(False, None), (True, None), (False, 3), (False, 6)])
def test_fast_steps_agree_with_single_ones(n, m, varying, series, monkeypatch):
    count, rng = 1300, np.random.default_rng(n + m)
    Phi, H, Q, R = model_of(n, n, m)
    if varying:
        Phi = Phi * rng.uniform(0.5, 1, (count, 1, 1))
        Q, R = Q * rng.uniform(0.5, 2, (count, 1, 1)), R * rng.uniform(0.5, 2, (count, 1, 1))
    shape = (count,) if series is None else (series, count)
    z, inputs = rng.normal(size=(*shape, m)), rng.normal(size=(*shape, n))
    missing = np.broadcast_to(rng.random((count, m)) < 0.2, z.shape)
    model, start = KalmanFilter(Phi, H, Q, R), Moments(rng.normal(size=n), np.eye(n))
    compiled = model.run(z, start, missing, inputs)
    monkeypatch.setattr(segments, "LEAST_STEPS", np.inf)
    stepped = model.run(z, start, missing, inputs)
    assert len(np.unique(compiled.matrix_index)) == count
    for name in ("predicted", "estimates", "innovations", "log_likelihood"):
        np.testing.assert_allclose(
            getattr(compiled, name), getattr(stepped, name), atol=1e-10, rtol=1e-11
        )
    for compiled_part, stepped_part in zip(compiled._steps, stepped._steps):
        stepped_part = stepped_part[stepped.matrix_index.reshape(-1, count)[0]]
        np.testing.assert_allclose(compiled_part, stepped_part, atol=1e-11)


@pytest.mark.parametrize("n", [9, 17])
def test_a_filter_that_forgets_slowly_agrees_with_a_plain_loop(n):
    count = 900
    Phi, Q, H = 0.9999 * np.eye(n), 1e-6 * np.eye(n), np.ones((1, n))
    missing = np.random.default_rng(1).random((count, 1)) < 0.2
    model, start = KalmanFilter(Phi, H, Q, 1.0), Moments(np.zeros(n), np.eye(n))
    z = np.random.default_rng(2).normal(size=(count, 1))
    run = model.run(z, start, missing)
    estimates = plain_loop(Phi, H, Q, np.eye(1), z, start, missing[:, 0])[2]
    np.testing.assert_allclose(run.estimates, estimates, atol=1e-11)


def test_segments_meet_what_single_steps_give():
    Phi, H, Q, R = model_of(4, 12, 2)
    missing = np.random.default_rng(3).random((2000, 2)) < 0.2
    parts = [np.empty((2000, 12, columns)) for columns in (12, 12, 2)]
    assert segments.covariance_segments((Phi, H, Q, R), np.eye(12), missing, 40, parts)
    P = np.eye(12)
    for k in range(2000):
        np.testing.assert_allclose(parts[0][k], P, atol=1e-11)
        rows = ~missing[k]
        gain = np.linalg.solve(H[rows] @ P @ H[rows].T + R[np.ix_(rows, rows)], H[rows] @ P).T
        P = Phi @ (P - gain @ H[rows] @ P) @ Phi.T + Q


@pytest.mark.parametrize("n", [2, 6])
def test_a_record_that_never_settles_is_compiled_after_some_steps(n, monkeypatch):
    """Without noise the covariance tends to zero, but never is constant."""
    Phi, H, _, R = model_of(n, n, 2)
    Phi = np.linalg.qr(Phi)[0]
    model, start = KalmanFilter(Phi, H, np.zeros((n, n)), R), Moments(np.zeros(n), np.eye(n))
    z = np.random.default_rng(n).normal(size=(2000, 2))
    missing = np.zeros((2000, 2), dtype=bool)
    missing[[200, 1100]] = True
    run = model.run(z, start, missing)
    monkeypatch.setattr(segments, "LEAST_STEPS", np.inf)
    stepped = model.run(z, start, missing)
    assert len(np.unique(run.matrix_index)) == len(np.unique(stepped.matrix_index)) == 2000
    for name in ("estimates", "covariances", "gains", "log_likelihood", "normalised_innovations"):
        np.testing.assert_allclose(
            getattr(run, name), getattr(stepped, name), rtol=1e-9, atol=1e-13
        )


def test_compiled_steps_refuse_an_overflowing_covariance():
    missing = np.ones(2000, dtype=bool)
    missing[:3] = False
    with pytest.raises(ValueError, match="lost its definiteness"):
        KalmanFilter(2, 1, 1, 1).run(np.zeros(2000), Moments(0, 1), missing)


@pytest.mark.parametrize("gaps", [0.0, 0.2])
@pytest.mark.parametrize("n", [3, 7])
def test_maps_of_segments_compose_where_nothing_is_forgotten(n, gaps):
    """Without noise the initial covariance has influence to the end, in units far apart."""
    count, rng = 1600, np.random.default_rng(n)
    _, H, _, R = model_of(n, n, 2)
    units = np.logspace(-4, 4, n)
    Phi = np.linalg.qr(rng.normal(size=(n, n)))[0] * units[:, None] / units
    H, P = H / units, np.diag(units**2)
    missing = rng.random((count, 2)) < gaps
    parts = [np.empty((count, n, columns)) for columns in (n, n, 2)]
    arguments = (Phi, H, np.zeros((n, n)), R), P, missing, 40, parts
    assert segments.covariance_segments(*arguments)
    scale = np.outer(units, units)
    for k in range(count):
        np.testing.assert_allclose(parts[0][k] / scale, P / scale, rtol=1e-9, atol=1e-13)
        rows = ~missing[k]
        gain = np.linalg.solve(H[rows] @ P @ H[rows].T + R[np.ix_(rows, rows)], H[rows] @ P).T
        reduction = np.eye(n) - gain @ H[rows]
        P = reduction @ P @ reduction.T + gain @ R[np.ix_(rows, rows)] @ gain.T
        P = Phi @ P @ Phi.T


def test_maps_spoilt_by_rounding_are_refused_and_the_steps_taken_one_by_one():
    """Unstable without noise: from P = 0 nothing is corrected, and the product of the matrices grows."""
    count, H, R, Q = 1200, np.array([[1.0, 1.0]]), np.eye(1), np.zeros((2, 2))
    Phi = np.array([[3.0, 1.0], [1.0, 2.0]])
    missing = np.random.default_rng(5).random((count, 1)) < 0.1
    parts = [np.empty((count, 2, columns)) for columns in (2, 2, 1)]
    with np.errstate(all="ignore"):
        assert not segments.covariance_segments((Phi, H, Q, R), np.eye(2), missing, 30, parts)
    start, z = Moments(np.zeros(2), np.eye(2)), np.zeros((count, 1))
    run = KalmanFilter(Phi, H, Q, R).run(z, start, missing)
    covariances = plain_loop(Phi, H, Q, R, z, start, missing[:, 0])[3]
    np.testing.assert_allclose(run.covariances, covariances, rtol=1e-8)
