"""Continuous filters, discrete measurements, shaping filters, interpolation and sample paths."""

import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import sympy as sp

from trajlib import estimation
from trajlib.estimation import ContinuousFilter, KalmanFilter, Measurement, Moments

t, tau = sp.symbols("t tau", real=True)
a, Q, R, p = sp.symbols("a Q R p", positive=True)


def integrated(filter, P, end):
    n = len(P)

    def rate(_, flat):
        X = flat.reshape(n, n)
        return (
            filter.A @ X
            + X @ filter.A.T
            + filter.Q
            - X @ filter.H.T @ np.linalg.solve(filter.R, filter.H @ X)
        ).ravel()

    return (
        scipy.integrate.solve_ivp(rate, (0, end), P.ravel(), method="LSODA", rtol=1e-11, atol=1e-12)
        .y[:, -1]
        .reshape(n, n)
    )


@pytest.mark.parametrize(
    "A, H, intensity, noise, P",
    [(a, 1, Q, R, p), (0, 1, 0, R, p), (0, 1, Q, R, 0), (-1, 1, 2, 1, 1), (a, 0, Q, R, p)],
)
def test_closed_form_variance_solves_the_riccati_equation(A, H, intensity, noise, P):
    filter = ContinuousFilter(A, H, intensity, noise)
    result = filter.covariance(P, t)
    values = {a: sp.Rational(2, 3), Q: 3, R: 2, p: 5}
    value = (
        result.diff(t) - filter.rate(sp.Matrix([sp.Symbol("P")])).subs(sp.Symbol("P"), result[0])
    ).subs(values)
    for moment in (0, sp.Rational(1, 3), 2):
        assert abs(sp.N(value[0].subs(t, moment), 25)) < 1e-18
    assert sp.simplify(result[0].subs(t, 0) - P) == 0


@pytest.mark.parametrize(
    "A, intensity",
    [
        ([[0, 1], [0, 0]], sp.diag(0, 0)),
        ([[0, 1], [0, 0]], sp.diag(0, 4)),
        ([[0, 1], [1, 0]], sp.diag(0, 3)),
        ([[-1, 0], [0, 0]], sp.diag(5, 1)),
    ],
)
def test_closed_form_of_two_states_agrees_with_the_integrator(A, intensity):
    exact = ContinuousFilter(A, [[1, 1]], intensity, 1)
    filter = ContinuousFilter(np.array(A, dtype=float), [[1, 1]], intensity, 1)
    P = np.array([[2.0, 0.5], [0.5, 1.0]])
    closed = exact.covariance(sp.Matrix([[2, sp.Rational(1, 2)], [sp.Rational(1, 2), 1]]), t)
    for end in (0.0, 0.4, 3.0):
        peer = integrated(filter, P, end) if end else P
        assert np.allclose(filter.covariance(P, end), peer, rtol=1e-8, atol=1e-10)
        value = closed.subs(t, sp.Rational(str(end))).applyfunc(lambda e: sp.re(sp.N(e, 30)))
        assert np.allclose(np.array(value.tolist(), dtype=float), peer, rtol=1e-8, atol=1e-10)
    assert np.allclose(filter.gain(P), P @ [[1], [1]])


@pytest.mark.parametrize("seed", range(3))
def test_filter_is_stationary_after_a_long_time(seed):
    """X and Y alone would overflow long before t = 10^4."""
    rng = np.random.default_rng(seed)
    A, mixing = rng.normal(size=(4, 4)), rng.normal(size=(4, 4))
    filter = ContinuousFilter(A, rng.normal(size=(2, 4)), mixing @ mixing.T, np.diag([1.0, 3.0]))
    P = filter.covariance(np.eye(4), 1e4)
    limit = filter.stationary()
    assert np.allclose(P, limit.covariance, rtol=1e-9, atol=1e-11) and np.array_equal(P, P.T)
    assert np.abs(filter.rate(P)).max() < 1e-9 * np.abs(P).max()
    assert np.allclose(
        filter.covariance(np.eye(4), 0.7), integrated(filter, np.eye(4), 0.7), rtol=1e-7
    )


def test_record_filter_has_second_order_errors_in_the_step():
    filter = ContinuousFilter(np.array([[0.0, 1], [-2, -0.3]]), [[1, 0]], np.diag([0, 0.5]), 0.2)
    start = Moments([1, 0], [[2, 0.3], [0.3, 1]])

    def rate(time, flat):
        x, P = flat[:2], flat[2:].reshape(2, 2)
        K = P @ filter.H.T / 0.2
        return np.concatenate(
            [
                filter.A @ x + K @ (np.sin(3 * time) - filter.H @ x),
                filter.rate((P + P.T) / 2).ravel(),
            ]
        )

    peer = scipy.integrate.solve_ivp(
        rate, (0, 2), [1, 0, 2, 0.3, 0.3, 1], rtol=1e-11, atol=1e-12
    ).y[:, -1]
    apart = []
    for count in (50, 100):
        times = np.linspace(0, 2, count + 1)
        run = filter.run(-np.diff(np.cos(3 * times)) / 3 / np.diff(times), times, start)
        assert np.allclose(run.covariances[-1].ravel(), peer[2:], rtol=1e-8)
        apart.append(np.abs(run.estimates[-1] - peer[:2]).max())
    assert apart[1] < 5e-4 and 3.3 < apart[0] / apart[1] < 4.7


def test_errors_of_a_continuous_filter_agree_with_its_covariance():
    """State and integral of z drawn together, so that the record is exact."""
    A, H, start = (
        np.array([[0.0, 1], [-2, -0.3]]),
        np.array([[1.0, 0]]),
        Moments([0, 0], [[1, 0], [0, 1]]),
    )
    filter = ContinuousFilter(A, H, np.diag([0, 0.5]), 0.2)
    joint = np.block([[A, np.zeros((2, 1))], [H, np.zeros((1, 1))]])
    times = np.linspace(0, 3, 76)
    drawn = estimation.simulate_continuous(
        joint, np.diag([0, 0.5, 0.2]), Moments([0, 0, 0], sp.diag(1, 1, 0)), times, 150, seed=6
    )
    states, record = (
        filter.simulate(start, times, 150, seed=6),
        np.diff(drawn.states[:, :, 2:], axis=1) / 0.04,
    )
    assert np.allclose(states.states, drawn.states[:, :, :2]) and np.allclose(
        states.measurements, record
    )
    assert np.allclose(
        filter.run(record, times, start).estimates[7], filter.run(record[7], times, start).estimates
    )
    squares = []
    for path in drawn.states:
        run = filter.run(np.diff(path[:, 2]) / np.diff(times), times, start)
        error = run.estimates[-1] - path[-1, :2]
        squares.append(error @ np.linalg.solve(run.covariances[-1], error))
    assert abs(np.mean(squares) - 2) < 3.3 * np.sqrt(4 / 150)


def test_run_rejects_records_that_do_not_fit():
    filter = ContinuousFilter(np.array([[-1.0]]), 1, 1, 1)
    for averages, times in (([1.0, 2.0], [0, 1]), ([np.nan], [0, 1]), ([1.0], [1, 1])):
        with pytest.raises(ValueError, match="averages|must increase|is repeated"):
            filter.run(averages, times, Moments(0, 1))
    with pytest.raises(ValueError, match="arrays"):
        ContinuousFilter(-1, 1, 1, 1).run([1], [0, 1], Moments(0, 1))
    with pytest.raises(ValueError, match="arrays"):
        ContinuousFilter(-1, 1, 1, 1).simulate(Moments(0, 1), [0, 1], 2, seed=1)


def test_equations_of_problem_4_33():
    b, p11, p12, p22 = sp.symbols("b p11 p12 p22", real=True)
    filter = ContinuousFilter([[0, 1], [-b, -a]], [[0, 1]], sp.diag(0, Q), R)
    rate = filter.rate([[p11, p12], [p12, p22]])
    assert sp.simplify(rate[0, 0] - (2 * p12 - p12**2 / R)) == 0
    assert sp.simplify(rate[0, 1] - (p22 - b * p11 - a * p12 - p12 * p22 / R)) == 0
    assert sp.simplify(rate[1, 1] - (-2 * b * p12 - 2 * a * p22 + Q - p22**2 / R)) == 0
    assert filter.gain([[p11, p12], [p12, p22]]) == sp.Matrix([p12 / R, p22 / R])


@pytest.mark.parametrize(
    "A, intensity, start, when, z, mean, variance",
    [
        # example 3
        (-1, 1, Moments(1, 1), 0, 2, sp.Rational(3, 2) / sp.E, sp.Rational(1, 2)),
        # 4.28
        (-1, 1, Moments(1, 3), 0, 3, sp.Rational(5, 2) / sp.E, sp.Rational(1, 2) + sp.exp(-2) / 4),
        # 4.29
        (
            -1,
            6,
            Moments(1, 3),
            1,
            3,
            1 / sp.E + sp.Rational(3, 4) * (3 - 1 / sp.E),
            sp.Rational(3, 4),
        ),
        # 4.30
        (0, 2, Moments(1, 1), 1, 2, sp.Rational(7, 4), sp.Rational(3, 4)),
        # 4.32
        (1, 1, Moments(1, 1), 0, 2, sp.Rational(3, 2) * sp.E, sp.exp(2) - sp.Rational(1, 2)),
    ],
)
def test_one_measurement_at_a_time(A, intensity, start, when, z, mean, variance):
    run = estimation.filter_measurements(A, intensity, start, [Measurement(when, z, 1, 1)])
    value = run.at(1)
    assert (
        sp.simplify(value.mean[0] - mean) == 0 and sp.simplify(value.covariance[0] - variance) == 0
    )


def test_problem_4_26():
    run = estimation.filter_measurements(
        [[0, 1], [0, 0]],
        sp.diag(0, 1),
        Moments([1, 1], sp.eye(2)),
        [Measurement(3, 3, [[1, 0]], 1)],
    )
    P = sp.Matrix([[19, sp.Rational(15, 2)], [sp.Rational(15, 2), 4]])
    assert run.before[0].covariance == P and list(run.before[0].mean) == [4, 1]
    assert list(run.after[0].mean) == [4 - sp.Rational(19, 20), 1 - sp.Rational(3, 8)]
    assert run.after[0].covariance == P - P[:, 0] * P[0, :] / 20
    assert (
        run.at(2).covariance
        == estimation.continuous_moments(
            [[0, 1], [0, 0]], sp.diag(0, 1), Moments([1, 1], sp.eye(2)), 2
        ).covariance
    )
    assert (
        "t = 3" in run._repr_latex_()
        and run.at(3 + t).covariance.subs(t, 0) == run.after[0].covariance
    )


@pytest.mark.parametrize("seed", range(2))
def test_irregular_measurements_give_the_conditional_distribution(seed):
    """Irregular, in any order, two at one time, some missing: against the joint distribution of all
    x(t_i)."""
    rng = np.random.default_rng(seed)
    A, mixing = rng.normal(size=(3, 3)) - np.eye(3), rng.normal(size=(3, 2))
    intensity, start = mixing @ mixing.T, Moments(rng.normal(size=3), np.eye(3))
    times = np.sort(rng.uniform(0, 3, 7))
    times[3] = times[2]
    H, noise = rng.normal(size=(7, 2, 3)), np.diag([0.3, 0.5])
    z = rng.normal(size=(7, 2))
    measurements = [
        Measurement(s, list(values), rows, noise) for s, values, rows in zip(times, z, H)
    ]
    measurements[4] = Measurement(times[4], [None, z[4, 1]], H[4], noise)
    measurements[5] = Measurement(times[5], None, H[5], noise)
    run = estimation.filter_measurements(
        A, intensity, start, [measurements[k] for k in rng.permutation(7)]
    )
    P = [estimation.continuous_moments(A, intensity, start, s).covariance for s in times]
    mean = np.concatenate([scipy.linalg.expm(A * s) @ start.mean for s in times])
    joint = np.block(
        [
            [
                P[i] @ scipy.linalg.expm(A * (times[j] - times[i])).T
                if j >= i
                else scipy.linalg.expm(A * (times[i] - times[j])) @ P[j]
                for j in range(7)
            ]
            for i in range(7)
        ]
    )
    C, rows = scipy.linalg.block_diag(*H), [k for k in range(14) if k not in (8, 10, 11)]
    C, data = C[rows], z.ravel()[rows]
    S = C @ joint @ C.T + np.kron(np.eye(7), noise)[np.ix_(rows, rows)]
    gain = np.linalg.solve(S, C @ joint[:, -3:]).T
    assert np.allclose(run.after[-1].mean, mean[-3:] + gain @ (data - C @ mean), atol=1e-11)
    assert np.allclose(
        run.after[-1].covariance, joint[-3:, -3:] - gain @ C @ joint[:, -3:], atol=1e-11
    )
    assert run.corrections[5] is None


@pytest.mark.parametrize(
    "measurement, message",
    [
        (Measurement(-1, 1, 1, 1), "before 0, the initial time"),
        (Measurement(0, sp.nan, 1, 1), "finite"),
        (Measurement(0, float("nan"), 1, 1), "finite"),
        (Measurement(0, 1, 1, -1), "positive semidefinite"),
        (Measurement(0, [1, 2], 1, 1), "2 components|got 2"),
        (Measurement(0, 1, [[1, 0]], 1), "any x 1"),
    ],
)
def test_filter_measurements_rejects_bad_measurements(measurement, message):
    with pytest.raises(ValueError, match=message):
        estimation.filter_measurements(-1, 1, Moments(0, 1), [measurement])


def test_time_of_a_measurement_may_be_a_symbol():
    """Example 5 in one call."""
    T = sp.Symbol("T", positive=True)
    run = estimation.filter_measurements(
        [[0, 1], [0, 0]],
        sp.diag(0, Q),
        Moments([0, 0], sp.zeros(2)),
        [Measurement(T, 0, [[0, 1]], R)],
    )
    assert (
        sp.simplify(
            run.after[0].covariance[0, 0] - (Q * T**3 / 3 - (Q * T**2 / 2) ** 2 / (Q * T + R))
        )
        == 0
    )
    assert run.at(T).covariance == run.after[0].covariance
    with pytest.raises(ValueError, match="not known"):
        run.at(5)
    with pytest.raises(ValueError, match="before 0, the initial time"):
        estimation.filter_measurements(0, 1, Moments(0, 1), [Measurement(-T, 0, 1, 1)])


def test_filter_without_measurements_is_the_process():
    run = estimation.filter_measurements(-1, 1, Moments(0, 1), [Measurement(1, [None], 1, 1)])
    assert run.corrections == (None,) and run.at(2).covariance[0] == sp.exp(-4) / 2 + sp.Rational(
        1, 2
    )
    with pytest.raises(ValueError, match="not negative"):
        run.at(-1)
    with pytest.raises(ValueError, match="not negative"):
        ContinuousFilter(0, 1, 1, 1).covariance(1, -1)
    with pytest.raises(ValueError, match="semidefinite"):
        ContinuousFilter(0, 1, 1, 1).covariance(-1, 1)


def test_shaping_filter_has_the_given_correlation():
    result = estimation.shaping_filter(8 * sp.exp(-tau) + 3 * sp.exp(-a * tau) + 2, tau)
    assert sp.simplify(result.correlation(tau) - 8 * sp.exp(-tau) - 3 * sp.exp(-a * tau) - 2) == 0
    A, P = result.A, result.covariance
    # stationary from the beginning
    assert (A * P + P * A.T + result.Q).applyfunc(sp.simplify) == sp.zeros(3)
    shaped = estimation.with_shaping(0, estimation.shaping_filter(8 * sp.exp(-tau), tau), B=1, H=1)
    filter = estimation.stationary_filter(shaped.A, shaped.H, shaped.Q, 1)
    assert filter.covariance[0, 0] == 2 and filter.where == sp.true  # 4.41
    constant = estimation.shaping_filter(p, tau)  # 4.43
    error = estimation.with_shaping([[0, 1], [0, 0]], constant, B=[0, 1], H=[[0, 1]])
    start = Moments([0, 0, 0], sp.diag(sp.zeros(2), error.noise_covariance))
    P = estimation.continuous_moments(error.A, error.Q, start, a).covariance
    assert P[:2, :2] == sp.Matrix([[p * a**4 / 4, p * a**3 / 2], [p * a**3 / 2, p * a**2]])


def test_shaped_measurement_noise():
    shaped = estimation.with_shaping(
        [[0, 1], [-1, 0]],
        estimation.shaping_filter(sp.exp(-2 * tau), tau),
        Q=sp.diag(0, Q),
        H=[[1, 0]],
        C=1,
    )
    assert shaped.H == sp.Matrix([[1, 0, 1]]) and shaped.A == sp.Matrix(
        [[0, 1, 0], [-1, 0, 0], [0, 0, -2]]
    )
    assert shaped.Q == sp.diag(0, Q, 4)


@pytest.mark.parametrize(
    "correlation",
    [
        sp.exp(-(tau**2)),
        sp.cos(tau),
        sp.exp(tau),
        -sp.exp(-tau),
        tau * sp.exp(-tau),
        sp.exp(-sp.Symbol("w") * tau),
        0,
    ],
)
def test_shaping_filter_rejects_other_correlations(correlation):
    with pytest.raises(ValueError, match="correlation"):
        estimation.shaping_filter(correlation, tau)


def test_problem_4_31_by_the_correlation_and_by_the_filter():
    result = estimation.optimal_weights(sp.exp(-tau), tau, [1, 2, 3], t)
    expected = {
        sp.Rational(1, 2): (sp.exp(-sp.Rational(1, 2)), 0, 0),
        5: (0, 0, sp.exp(-2)),
        2: (0, 1, 0),
    }
    for point, weights in expected.items():
        assert all(sp.simplify(w.subs(t, point) - v) == 0 for w, v in zip(result.weights, weights))
    inside = [sp.sinh(2 - t) / sp.sinh(1), sp.sinh(t - 1) / sp.sinh(1), 0]
    for point in (sp.Rational(5, 4), sp.Rational(7, 4)):
        assert all(
            abs(sp.N((w - v).subs(t, point), 20)) < 1e-18 for w, v in zip(result.weights, inside)
        )
    # noise on the measurements, and the process as x' = -x + q of the variance 1: the filter
    # predicts the same
    noisy = estimation.optimal_weights(sp.exp(-tau), tau, [1, 2, 3], 4, noise=sp.Rational(1, 2))
    z = [3, -1, 2]
    run = estimation.filter_measurements(
        -1,
        2,
        Moments(0, 1),
        [Measurement(k + 1, value, 1, sp.Rational(1, 2)) for k, value in enumerate(z)],
    )
    assert sp.N(noisy.estimate(z) - run.at(4).mean[0], 30, chop=True) == 0
    assert sp.N(noisy.variance - run.at(4).covariance[0], 30, chop=True) == 0
    assert "w =" in noisy._repr_latex_()


def test_interpolation_in_floats_agrees_with_the_exact_one():
    correlation, times = sp.exp(-tau) * (1 + tau), [0, 1, sp.Rational(5, 2)]
    points = np.array([-0.5, 1.0, 2.0, 4.0])
    floats = estimation.optimal_weights(correlation, tau, np.array(times, dtype=float), points, 0.1)
    for k, point in enumerate(points):
        exact = estimation.optimal_weights(
            correlation, tau, times, sp.Rational(str(point)), sp.Rational(1, 10)
        )
        assert np.allclose(
            np.array(exact.weights.evalf(), dtype=float).ravel(), floats.weights[k], atol=1e-12
        )
        assert floats.variance[k] == pytest.approx(float(exact.variance), abs=1e-12)
    z = np.array([1.0, 2.0, 0.0])
    assert np.allclose(floats.estimate(z, mean=3), 3 + floats.weights @ (z - 3))
    assert estimation.optimal_weights(sp.exp(-tau), tau, [0, 1], 0).estimate([5, 7], mean=1) == 5


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((sp.exp(-tau), tau, [1, 1], t), "positive definite"),
        ((sp.exp(tau), tau, [1, 2], t), "positive definite"),
        ((sp.exp(-tau), tau, np.array([1.0, 1.0]), 2), "positive definite"),
        ((sp.exp(-tau), tau, [a, 1], t), "numbers"),
        ((sp.exp(-tau), tau, [1, 2], t, -1), "semidefinite"),
    ],
)
def test_optimal_weights_rejects_bad_arguments(arguments, message):
    with pytest.raises(ValueError, match=message):
        estimation.optimal_weights(*arguments)


def test_paths_have_the_moments_of_the_process():
    A, intensity = np.array([[0.0, 1], [-2, -1]]), np.diag([0.0, 1.5])
    start, times = Moments([1, 0], [[0.5, 0.2], [0.2, 0.3]]), [0, 0.1, 0.9, 1.0, 2.7]
    drawn = estimation.simulate_continuous(
        A, intensity, start, times, 40_000, seed=2, H=[[1, 0]], R=0.2
    )
    for k, moment in enumerate(times):
        expected = estimation.continuous_moments(A, intensity, start, moment)
        sample = drawn.states[:, k]
        assert np.abs(sample.mean(axis=0) - expected.mean).max() < 4 * np.sqrt(
            expected.covariance.max() / 40_000
        )
        assert (
            np.abs(np.cov(sample.T) - expected.covariance).max()
            < 4 * np.sqrt(2 / 40_000) * expected.covariance.max()
        )
    errors = drawn.measurements[:, :, 0] - drawn.states[:, :, 0]
    assert abs(errors.var() / 0.2 - 1) < 4 * np.sqrt(2 / 200_000) and "40000" in repr(drawn)
    again = estimation.simulate_continuous(
        A, intensity, start, times, 40_000, seed=2, H=[[1, 0]], R=0.2
    )
    assert np.array_equal(again.measurements, drawn.measurements)
    with pytest.raises(ValueError, match="must not decrease"):
        estimation.simulate_continuous(A, intensity, start, [0, 2, 1], 5, seed=1)


def last_error_consistency(run, states):
    """The NEES test over independent paths; errors of one path depend on one another."""
    errors = (run.estimates - states)[:, -1]
    return estimation.covariance_consistency(errors, run.covariances[:, -1])


def test_consistency_of_right_and_wrong_models():
    Phi, H, variance, noise = np.array([[1.0, 0.1], [-0.2, 0.9]]), [[1, 0]], np.diag([0, 0.04]), 0.3
    start = Moments([0, 0], sp.eye(2))
    drawn = estimation.simulate_discrete(Phi, variance, start, 200, 300, seed=5, H=H, R=noise)
    run = KalmanFilter(Phi, H, variance, noise).run(drawn.measurements, start)
    assert estimation.innovation_consistency(run) and last_error_consistency(run, drawn.states)
    assert "consistent" in estimation.innovation_consistency(run)._repr_markdown_()
    for wrong in (
        KalmanFilter(Phi, H, variance, 1.1 * noise),
        KalmanFilter(Phi, H, 3 * variance, noise),
    ):
        assert not estimation.innovation_consistency(wrong.run(drawn.measurements, start))
    poor = KalmanFilter(Phi, H, 3 * variance, noise).run(drawn.measurements, start)
    assert not last_error_consistency(poor, drawn.states)
    missing = np.random.default_rng(1).random(200) < 0.3
    gaps = KalmanFilter(Phi, H, variance, noise).run(
        drawn.measurements, start, np.broadcast_to(missing, (300, 200))
    )
    assert estimation.innovation_consistency(gaps) and last_error_consistency(gaps, drawn.states)


def test_path_of_an_estimate_jumps_at_measurements():
    run = estimation.filter_measurements(
        [[0, 1], [0, 0]],
        sp.diag(0, 1),
        Moments([1, 1], sp.eye(2)),
        [estimation.Measurement(3, 3, [[1, 0]], 1)],
    )
    times, means, deviations = run.path(5, count=50)
    assert len(times) == 100 and (times == 3).sum() == 2 and times[-1] == 5
    assert np.allclose(means[[49, 50]], [4, 61 / 20]) and np.allclose(
        deviations[[49, 50]] ** 2, [19, 19 / 20]
    )
    assert np.allclose(
        [means[-1], deviations[-1] ** 2], [float(run.at(5).mean[0]), float(run.at(5).covariance[0])]
    )
    assert len(run.path(2)[0]) == 100 and np.isclose(run.path(4, component=1)[1][-1], 5 / 8)


def test_covariance_consistency_of_right_and_wrong_covariances():
    drawn = np.random.default_rng(8).multivariate_normal([0, 0], [[2, 1], [1, 3]], 20000)
    assert estimation.covariance_consistency(drawn, [[2, 1], [1, 3]])
    assert not estimation.covariance_consistency(drawn, [[2.1, 1.05], [1.05, 3.15]])
    with pytest.raises(ValueError, match="covariance: expected a matrix 2 x 2"):
        estimation.covariance_consistency(drawn, [[1]])
