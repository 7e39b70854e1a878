"""Reconstruction against independent methods.

SciPy's smoothing spline, dense least squares, the paper's own recursion, a general solver of bounded
least squares, and the conditions of the optimum.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, make_smoothing_spline
from scipy.optimize import lsq_linear

from trajlib.reconstruction import SweepGains, reconstruct, sweep_eigenvalues


def record(seed, n=30, ratio=10.0):
    random = np.random.default_rng(seed)
    t = np.cumsum(ratio ** random.uniform(-0.5, 0.5, n))
    sigma = random.uniform(0.5, 3, n)
    return t, 20 * np.sin(t / 4) + 3 * t + sigma * random.standard_normal(n), sigma


def paper_matrices(tau, rho, M):
    """A_k of (3.5) for (x, y, psi_2, psi_1), with the minus signs that the integration gives."""
    return np.array(
        [
            [1 - rho * tau**3 / (6 * M), tau, tau**2 / (2 * M), -(tau**3) / (6 * M)],
            [-rho * tau**2 / (2 * M), 1, tau / M, -(tau**2) / (2 * M)],
            [-rho * tau, 0, 1, -tau],
            [rho, 0, 0, 1],
        ]
    )


def dense(t, h, sigma, M):
    """Positions and velocities at the samples from the normal equations of the discretised cost,
    exact between samples."""
    n = t.size
    cost, right = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)
    # the least integral of u^2 between two states, a quadratic form
    for k, tau in enumerate(np.diff(t)):
        miss = np.zeros((2, 2 * n))
        miss[0, [2 * k, 2 * k + 1, 2 * k + 2]] = -1, -tau, 1
        miss[1, [2 * k + 1, 2 * k + 3]] = -1, 1
        cost += M * miss.T @ np.array([[12 / tau**3, -6 / tau**2], [-6 / tau**2, 4 / tau]]) @ miss
    cost[range(0, 2 * n, 2), range(0, 2 * n, 2)] += sigma**-2.0
    right[::2] = h * sigma**-2.0
    solution = np.linalg.solve(cost, right)
    return solution[::2], solution[1::2]


@given(
    seed=st.integers(0, 10**6),
    n=st.integers(2, 60),
    log_m=st.floats(-2, 2),
    ratio=st.sampled_from([1.0, 10.0, 1e4]),
)
@settings(max_examples=60, deadline=None)
def test_agrees_with_dense_least_squares(seed, n, log_m, ratio):
    t, h, sigma = record(seed, n, ratio)
    x, y, _ = SweepGains(t, sigma, 10.0**log_m).apply(h)
    # the dense matrix is ill-conditioned for clustered times, not the sweep
    tolerance = 1e-9 if ratio < 100 else 1e-4
    expected = dense(t, h, sigma, 10.0**log_m)
    assert np.abs(x - expected[0]).max() < tolerance * np.abs(h).max()
    assert (
        np.abs(y - expected[1]).max()
        < tolerance * np.abs(expected[1]).max() + tolerance * np.abs(h).max() / np.diff(t).min()
    )


@pytest.mark.parametrize("M", [1e-2, 1.0, 1e2])
def test_coincides_with_the_smoothing_spline_of_scipy(M):
    t, h, sigma = record(5, 50)
    spline = make_smoothing_spline(t, h, w=sigma**-2.0, lam=M)
    motion = reconstruct(t, h, sigma, M=M)
    fine = np.linspace(t[0], t[-1], 777)
    for order, ours in enumerate((motion.position, motion.velocity, motion.acceleration)):
        scale = np.abs(spline(fine, order)).max()
        assert np.abs(ours(fine) - spline(fine, order)).max() < 1e-10 * scale


def test_far_limits_of_the_weight():
    t, h, sigma = record(7, 40)
    scale = np.abs(h).max()
    interpolant = CubicSpline(t, h, bc_type="natural")
    x, y, u = SweepGains(t, sigma, 1e-16).apply(h + 1000)
    assert (
        np.abs(x - h - 1000).max() < 1e-12 * scale
        and np.abs(y - interpolant(t, 1)).max() < 1e-11 * scale
    )
    assert np.abs(u - interpolant(t, 2)).max() < 1e-9 * np.abs(u).max()
    x, _, _ = SweepGains(t, sigma, 1e20).apply(h)
    assert np.abs(x - np.polyval(np.polyfit(t, h, 1, w=1 / sigma), t)).max() < 1e-11 * scale


def test_the_recursion_of_the_paper_gives_the_same_gains_and_motion():
    t, h, sigma = record(11, 25)
    M = 3.0
    rho = sigma**-2.0
    Q, q = [np.array([[0, 0], [-rho[-1], 0]])], [np.array([0, rho[-1] * h[-1]])]
    steps = list(zip(np.diff(t), rho, h))
    for tau, r, value in reversed(steps):
        A = paper_matrices(tau, r, M)
        b = r * value * np.array([tau**3 / (6 * M), tau**2 / (2 * M), tau, -1])
        L = A[2:, 2:] - Q[0] @ A[:2, 2:]
        q.insert(0, np.linalg.solve(L, Q[0] @ b[:2] - b[2:] + q[0]))
        Q.insert(0, np.linalg.solve(L, Q[0] @ A[:2, :2] - A[2:, :2]))
    gains = SweepGains(t, sigma, M)
    assert np.allclose(gains.Q, Q, rtol=1e-9, atol=1e-12 * np.abs(Q).max())
    state, states = np.linalg.solve(-Q[0], q[0]), []
    for k, (tau, r, value) in enumerate(steps):
        states.append(state)
        A = paper_matrices(tau, r, M)
        state = (
            (A[:2, :2] + A[:2, 2:] @ Q[k]) @ state
            + A[:2, 2:] @ q[k]
            + r * value * np.array([tau**3 / (6 * M), tau**2 / (2 * M)])
        )
    x, y, u = gains.apply(h)
    assert np.allclose(np.transpose([*states, state]), [x, y], atol=1e-8)
    assert np.allclose(u[:-1], [(Q[k] @ s + q[k])[0] / M for k, s in enumerate(states)], atol=1e-8)


@given(seed=st.integers(0, 10**6), log_m=st.floats(-3, 3))
@settings(max_examples=40, deadline=None)
def test_the_costate_vanishes_after_the_last_sample(seed, log_m):
    t, h, sigma = record(seed)
    motion = reconstruct(t, h, sigma, M=10.0**log_m)
    # the jumps of psi_1 sum to nothing, and so do their moments: the misses carry neither force nor
    # torque
    jumps = (motion.position(t) - h) / sigma**2
    assert (
        abs(jumps.sum()) < 1e-9 * np.abs(jumps).sum()
        and abs(jumps @ (t - t[0])) < 1e-9 * np.abs(jumps * (t - t[0])).sum()
    )
    assert motion.misfit == pytest.approx(np.sum(((motion.position(t) - h) / sigma) ** 2))


@given(seed=st.integers(0, 10**6), log_d=st.floats(-6, 0.5), n=st.integers(3, 80))
@settings(max_examples=40, deadline=None)
def test_the_bound_is_met(seed, log_d, n):
    t, h, sigma = record(seed, n)
    bound = 10.0**log_d
    motion = reconstruct(t, h, sigma, max_acceleration=bound)
    free = np.abs(CubicSpline(t, h, bc_type="natural")(t, 2)).max()
    assert motion.active == (free > bound)
    if motion.active:
        assert motion.max_acceleration == pytest.approx(bound, rel=1e-8)
        fine = np.linspace(t[0], t[-1], 1000)
        assert np.abs(motion.acceleration(fine)).max() <= bound * (1 + 1e-8)
    else:
        assert motion.M == 0 and motion.misfit < 1e-15 * np.sum((h / sigma) ** 2)


def test_an_inactive_bound_gives_the_interpolant():
    t, h, sigma = record(3)
    spline = CubicSpline(t, h, bc_type="natural")
    fine = np.linspace(t[0], t[-1], 500)
    for method in ("sweep", "direct"):
        motion = reconstruct(t, h, sigma, max_acceleration=1e3, method=method)
        assert not motion.active and np.allclose(motion.position(fine), spline(fine), atol=1e-9)


def test_greatest_acceleration_need_not_decrease_with_the_weight():
    t, h, sigma = np.arange(4), [5, 4, 1, -4], [1, 10, 0.1, 0.1]
    assert [
        round(reconstruct(t, h, sigma, M=M).max_acceleration, 2) for M in (1e-9, 0.028, 1.0)
    ] == [2.4, 2.96, 2.34]
    # the interpolant keeps it, though two weights meet it too
    between = reconstruct(t, h, sigma, max_acceleration=2.7)
    assert not between.active and between.misfit < 1e-20
    assert reconstruct(t, h, sigma, max_acceleration=2.39).active


def test_heavy_smoothing_of_a_long_record_meets_the_bound():
    random = np.random.default_rng(0)
    t = np.arange(20000.0)
    h = 100 * np.sin(t / 20) + 2 * random.standard_normal(t.size)
    # the banded matrix is no longer positive definite in machine numbers for the second
    for bound in (1e-5, 1e-12):
        assert reconstruct(t, h, 2.0, max_acceleration=bound).max_acceleration == pytest.approx(
            bound, rel=1e-8
        )


def bounded_least_squares(t, h, sigma, bound, pieces):
    """Least misfit by SciPy's solver with u linear on so many pieces of each interval: unknowns
    x_0, y_0 and u."""
    knots = np.append(
        (t[:-1, None] + np.diff(t)[:, None] * np.arange(pieces) / pieces).ravel(), t[-1]
    )
    x, y, rows = np.eye(2, knots.size + 2)[0], np.eye(2, knots.size + 2)[1], []
    for k, tau in enumerate(np.diff(knots)):
        rows.append(x)
        one, two = np.zeros((2, knots.size + 2))
        one[k + 2] = two[k + 3] = 1
        x, y = x + tau * y + tau**2 * (2 * one + two) / 6, y + tau * (one + two) / 2
    matrix = np.array([*rows, x])[::pieces]
    limits = np.append([np.inf, np.inf], np.full(knots.size, bound))
    return (
        2
        * lsq_linear(
            matrix / sigma[:, None], h / sigma, (-limits, limits), tol=1e-13, method="bvls"
        ).cost
    )


@pytest.mark.parametrize("bound", [0.05, 0.5, 2.0])
def test_direct_method_against_bounded_least_squares(bound):
    """Finer and finer pieces come down to the exact minimum, and none of them below it."""
    t, h, sigma = record(2, 12)
    motion = reconstruct(t, h, sigma, max_acceleration=bound, method="direct")
    coarse, fine = (bounded_least_squares(t, h, sigma, bound, pieces) for pieces in (4, 16))
    above = np.array([coarse, fine]) - motion.misfit
    slack = 1e-6 * (1 + motion.misfit)
    assert -slack <= above[1] <= above[0] / 4 + slack
    assert motion.max_acceleration <= bound * (1 + 1e-9)
    assert motion.misfit <= reconstruct(t, h, sigma, max_acceleration=bound).misfit


@pytest.mark.parametrize("bound", [0.05, 0.5, 2.0])
def test_direct_motion_is_continuous_and_within_the_bound(bound):
    """Position and velocity go on over all knots, and the states at the samples follow from the
    acceleration alone."""
    t, h, sigma = record(5, 30)
    motion = reconstruct(t, h, sigma, max_acceleration=bound, method="direct")
    before, after = np.nextafter(motion._spline.x[1:-1], -np.inf), motion._spline.x[1:-1]
    assert np.abs(motion.position(before) - motion.position(after)).max() < 1e-9
    assert np.abs(motion.velocity(before) - motion.velocity(after)).max() < 1e-9
    fine = np.linspace(t[0], t[-1], 5000)
    assert np.abs(motion.acceleration(fine)).max() <= bound * (1 + 1e-9)
    rate = np.diff(motion.velocity(fine)) / np.diff(fine)
    assert np.abs(rate).max() <= bound * (1 + 1e-6) and np.abs(rate).max() > 0.99 * bound


def test_direct_method_finds_the_least_misfit_of_three_samples():
    # x0 - 2 x1 + x2 is the integral of u times a hat of area tau^2, so it is at most bound tau^2
    motion = reconstruct([0, 2, 4], [0, -5, 0], 0.5, max_acceleration=1.0, method="direct")
    assert motion.misfit == pytest.approx((10 - 4) ** 2 / 6 / 0.25, rel=1e-6)


def test_columns_are_separate_problems():
    t, h, sigma = record(4)
    both = np.stack([h, np.cos(t)], axis=1)
    for method in ("sweep", "direct"):
        motion = reconstruct(t, both, sigma, max_acceleration=[1.0, 0.2], method=method)
        for k, bound in enumerate((1.0, 0.2)):
            alone = reconstruct(t, both[:, k], sigma, max_acceleration=bound, method=method)
            assert np.allclose(motion.position(t)[:, k], alone.position(t), atol=1e-9)
            assert motion.misfit[k] == pytest.approx(alone.misfit)
    records = np.stack([h, 2 * h, h - 7], axis=1).reshape(-1, 3, 1)
    x, _, u = SweepGains(t, sigma, 2.0).apply(records)
    assert (
        x.shape == records.shape
        and np.allclose(x[:, 1], 2 * x[:, 0])
        and np.allclose(u[:, 2], u[:, 0], atol=1e-9)
    )


def test_times_without_a_measurement_change_nothing():
    t, h, sigma = record(6, 20)
    more_t = np.concatenate([[t[0] - 3], t[:7], [(t[6] + t[7]) / 2], t[7:], [t[-1] + 5]])
    more_h = np.concatenate([[np.nan], h[:7], [np.nan], h[7:], [np.nan]])
    more_sigma = np.concatenate([[np.inf], sigma[:7], [np.inf], sigma[7:], [np.inf]])
    for choice in ({"M": 2.0}, {"max_acceleration": 0.5}, {"max_acceleration": 100.0}):
        less, more = (
            reconstruct(t, h, sigma, **choice),
            reconstruct(more_t, more_h, more_sigma, **choice),
        )
        at = np.linspace(t[0] - 6, t[-1] + 9, 300)
        for name in ("position", "velocity", "acceleration"):
            assert np.allclose(getattr(less, name)(at), getattr(more, name)(at), atol=1e-8), name


def test_two_samples_are_joined_by_a_line():
    for choice in (
        {"M": 1.0},
        {"max_acceleration": 0.1},
        {"max_acceleration": 0.1, "method": "direct"},
    ):
        motion = reconstruct([1, 3], [2, 6], 1.0, **choice)
        assert (
            np.allclose(motion.position([0, 1, 2, 5]), [0, 2, 4, 10])
            and motion.max_acceleration < 1e-12
        )


@given(kappa=st.floats(1e-6, 1e6))
@settings(max_examples=50, deadline=None)
def test_eigenvalues(kappa):
    result = sweep_eigenvalues(kappa)
    assert (
        (np.abs(result[:2]) < 1).all()
        and (np.abs(result[2:]) > 1).all()
        and np.abs(result[0] * result[3]) == pytest.approx(1)
    )
    polynomial = [1, kappa / 6 - 4, 2 * kappa / 3 + 6, kappa / 6 - 4, 1]
    assert np.abs(np.polyval(polynomial, result)).max() < 1e-9 * np.polyval(
        np.abs(polynomial), np.abs(result).max()
    )
    assert np.allclose(
        np.poly(paper_matrices(1.0, kappa, 1.0)), polynomial, rtol=1e-9, atol=1e-9 * max(1, kappa)
    )


def test_gains_tend_to_the_stable_subspace():
    tau, sigma, M = 0.7, 1.3, 2.0
    gains = SweepGains(tau * np.arange(60), sigma, M)
    values, vectors = np.linalg.eig(paper_matrices(tau, sigma**-2.0, M))
    stable = vectors[:, np.abs(values) < 1]
    assert np.allclose(gains.Q[0], (stable[2:] @ np.linalg.inv(stable[:2])).real, rtol=1e-10)
    assert np.allclose(
        np.sort(np.abs(np.linalg.eigvals(gains.closed_loop[0]))),
        np.abs(sweep_eigenvalues(sigma**-2.0 * tau**3 / M)[:2]),
    )


GOOD = {"t": [0, 1, 2, 3], "h": [0, 1, 5, 2], "sigma": 1.0, "max_acceleration": 1.0}


@pytest.mark.parametrize(
    "change, words",
    [
        ({"t": [0, 2, 1, 3]}, "must increase"),
        ({"t": [0, 1, 1, 3]}, "is repeated"),
        ({"t": [0, 1, np.nan, 3]}, "finite"),
        ({"t": [0], "h": [1]}, "two or more"),
        ({"t": [[0, 1], [2, 3]]}, "list of two or more"),
        ({"h": [0, 1, 2]}, "expected 4 samples"),
        ({"h": [0, 1, np.nan, 2]}, "sample 2"),
        ({"sigma": 0.0}, "must be positive"),
        ({"sigma": [1, 1, -1, 1]}, r"sigma\[2\]"),
        ({"sigma": [1, 1, np.nan, 1]}, "must be positive"),
        ({"sigma": [1, 1]}, "expected a number, 4"),
        ({"sigma": [1, np.inf, np.inf, np.inf]}, "needs two"),
        ({"sigma": 1e-200}, "change the unit"),
        ({"max_acceleration": -1.0}, "no motion"),
        ({"max_acceleration": 0.0}, "straight line"),
        ({"max_acceleration": np.nan}, "positive bound"),
        ({"max_acceleration": [1.0, 2.0]}, "shape"),
        ({"max_acceleration": None}, "give either"),
        ({"M": 1.0}, "give either"),
        ({"max_acceleration": None, "M": -1.0}, "positive finite"),
        ({"max_acceleration": None, "M": 1.0, "method": "direct"}, "belongs to the sweep"),
        ({"method": "magic"}, "sweep"),
    ],
)
def test_bad_arguments_are_named(change, words):
    with pytest.raises(ValueError, match=words):
        reconstruct(**(GOOD | change))


def test_plot_draws_motion_and_bound():
    upper, lower = reconstruct(**GOOD).plot()
    assert len(upper.lines) == 2 and len(lower.lines) == 3
    assert np.abs(lower.lines[0].get_ydata()).max() == pytest.approx(1.0, rel=1e-6)


# --- standard deviations, columns of different accuracy, robust weights


@pytest.mark.parametrize("M", [1e-2, 1.0, 1e3])
def test_standard_deviations_against_dense_least_squares(M):
    t, h, sigma = record(3, n=25)
    maps = [dense(t, unit, sigma, M) for unit in np.eye(25)]
    u_maps = [make_smoothing_spline(t, unit, w=sigma**-2.0, lam=M)(t, 2) for unit in np.eye(25)]
    motion = reconstruct(t, h, sigma, M=M)
    x, y, u = motion.standard_deviations(t)
    for found, rows in zip((x, y, u), (*zip(*maps), u_maps)):
        expected = np.sqrt(np.sum((np.array(rows) * sigma[:, None]) ** 2, axis=0))
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-9 * expected.max())


@pytest.mark.parametrize("options", [{"M": 2.0}, {"max_acceleration": 50.0}])
def test_standard_deviations_agree_with_simulation(options):
    """4000 records with a fixed seed; a share of 5 per cent more or less would be noticed."""
    t, _, sigma = record(4, n=12, ratio=3.0)
    sigma[5] = np.inf
    noise = np.where(np.isfinite(sigma), sigma, 0) * np.random.default_rng(6).standard_normal(
        (4000, 12)
    )
    at = np.array([t[0] - 1, t[3], (t[6] + t[7]) / 2, t[5], t[-1] + 2])
    motion = reconstruct(t, np.zeros(12), sigma, **options)
    if "M" not in options:
        assert motion.M == 0  # the natural spline through all samples
        options = {"max_acceleration": 1e9}
    records = reconstruct(t, noise.T, sigma, **options)
    drawn = records.position(at), records.velocity(at), records.acceleration(at)
    for found, values in zip(motion.standard_deviations(at), drawn):
        assert found == pytest.approx(values.std(axis=1), rel=0.04, abs=1e-12)


def test_standard_deviations_of_known_cases():
    # the mean and slope of a straight line through equal samples
    line = reconstruct(np.arange(5.0), np.zeros(5), 2.0, M=1e12)
    x, y, u = line.standard_deviations([2.0, 4.0, 6.0])
    assert x == pytest.approx(2 * np.sqrt(0.2 + np.array([0, 4, 16]) / 10), rel=1e-6)
    assert y == pytest.approx(2 / np.sqrt(10), rel=1e-6) and u == pytest.approx(0, abs=1e-6)
    # two samples
    pair = reconstruct([0, 2], [0, 1], 1.0, max_acceleration=1.0)
    assert pair.standard_deviations(1.0)[0] == pytest.approx(np.sqrt(0.5))
    with pytest.raises(ValueError, match="direct method is no smooth function"):
        reconstruct(
            [0, 1, 2], [0, -1, 0], 1.0, max_acceleration=1.0, method="direct"
        ).standard_deviations(0)


@pytest.mark.parametrize("options", [{"M": 0.7}, {"max_acceleration": 1.5}])
def test_columns_may_differ_in_accuracy(options):
    t, h, sigma = record(5)
    records = np.stack([h, h**2 / 50, -h], axis=1)
    rows = {
        "one a column": np.array([[0.5, 3.0, 1.0]]),
        "flat": np.array([0.5, 3.0, 1.0]),
        "one a sample": sigma[:, None] * [1, 2, 0.5],
    }
    rows["one a sample"][4, 1] = np.inf
    at = np.linspace(t[0] - 1, t[-1] + 1, 40)
    for name, errors in rows.items():
        motion = reconstruct(t, records, errors, **options)
        each = np.broadcast_to(errors, records.shape)
        for k in range(3):
            alone = reconstruct(t, records[:, k], each[:, k], **options)
            assert motion.position(at)[:, k] == pytest.approx(alone.position(at), abs=1e-8), name
            assert motion.misfit[k] == pytest.approx(alone.misfit)
            for both, single in zip(motion.standard_deviations(at), alone.standard_deviations(at)):
                assert both[:, k] == pytest.approx(single, rel=1e-7, abs=1e-9)
    records[4, 1] = np.nan
    assert np.isfinite(reconstruct(t, records, rows["one a sample"], **options).misfit).all()
    with pytest.raises(ValueError, match="sigma: expected a number, 30 standard errors"):
        reconstruct(t, records, np.ones((30, 2)), **options)
    with pytest.raises(ValueError, match="h: sample 4 is not a finite number"):
        reconstruct(t, records, rows["flat"], **options)


@pytest.mark.parametrize("options", [{"M": 2.0}, {"max_acceleration": 4.0}])
def test_robust_weights_resist_gross_errors(options):
    """Five outliers of 1200 samples."""
    t, random = np.arange(1200.0), np.random.default_rng(7)
    truth = 400 * np.sin(t / 12) + 20 * t
    clean = truth + 3 * random.standard_normal(1200)
    spoiled = clean.copy()
    spoiled[random.choice(1200, 5, replace=False)] += 300 * random.choice([-1, 1], 5)

    def rms(h, **more):
        motion = reconstruct(t, h, 3.0, **options, **more)
        return np.sqrt(np.mean((motion.position(t) - truth) ** 2))

    best = rms(clean)
    assert rms(spoiled) > 2 * best and rms(spoiled, robust=1.5) < 1.25 * best
    assert rms(clean, robust=1.5) < 1.1 * best and rms(clean, robust=100) == pytest.approx(best)


def test_robust_motion_minimises_the_cost_of_huber():
    t, h, sigma = record(8, n=14)
    h[3] += 80
    motion = reconstruct(t, h, sigma, M=0.5, robust=1.2)
    assert motion.weights[3] < 0.1 and (motion.weights <= 1).all()

    def gradient_of_cost(x):
        """By the position at each sample: Huber's function is r within c, then +-c."""
        residuals = np.clip((x - h) / sigma, -1.2, 1.2) / sigma
        jumps = np.diff(np.append(motion._spline.c[0] * 6, 0), prepend=0)
        return residuals + 0.5 * jumps

    assert np.abs(gradient_of_cost(motion.position(t))).max() < 1e-4
    with pytest.raises(ValueError, match="robust: expected a positive number"):
        reconstruct(t, h, sigma, M=0.5, robust=0.0)
