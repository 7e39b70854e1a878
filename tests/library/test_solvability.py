"""Solvability against independent methods.

40- and 50-digit arithmetic, exact transition matrices, finite differences, random search for the
worst case, and mpmath's intervals.
"""

import math
import subprocess
import sys

import casadi as ca
import mpmath
import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from trajlib.solvability import (
    analyse,
    clohessy_wiltshire,
    guarantee,
    linearise,
    reflection_constant,
    rounding_bound,
    solve,
    stack,
    threshold,
    transition,
)
from trajlib.solvability.intervals import Interval

EARTH, RADIUS, RATE = 398600.4418, 6378.137, 7.2921159e-5  # km^3/s^2, km, 1/s
ORBIT = (EARTH / RATE**2) ** (1 / 3)


def with_condition(random, n, m, mu, dtype=float):
    U, V = (scipy.linalg.qr(random.standard_normal((k, m)), mode="economic")[0] for k in (n, m))
    return (U @ np.diag(np.geomspace(1, 1 / mu, m)) @ V.T).astype(dtype)


def exact_solution(A, b, digits=40):
    with mpmath.workdps(digits):
        A, b = mpmath.matrix(A.astype(float).tolist()), mpmath.matrix(b.astype(float).tolist())
        return mpmath.lu_solve(A.T * A, A.T * b), A, b


# --- constants of rounding
# ------------------------------------------------------------------------------------------------------


def test_constants_by_hand():
    assert reflection_constant(4, 10) == 2 * 5 * 67
    assert threshold(4, 10, 2.0**-52) == pytest.approx(2.0**52 / 681)
    assert rounding_bound(4, 10, 100, 1e-16) == pytest.approx(
        (670 + 80 + 58) * 1e-14 / (1 - (670 + 40 + 30) * 1e-14)
    )
    assert threshold(1, 50) == np.inf and rounding_bound(4, 10, 1e15) == np.inf
    assert all(threshold(m, 2 * n) < threshold(m, n) for m in (2, 6) for n in (10, 1000))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("n, m", [(6, 6), (40, 4), (200, 6)])
def test_rounding_bound_holds_for_consistent_equations_and_is_generous(dtype, n, m):
    random = np.random.default_rng(n + m)
    eps = float(np.finfo(dtype).eps)
    highest = 0.1 * threshold(m, n, eps)
    for mu in np.geomspace(2, max(highest, 3), 4):
        A = with_condition(random, n, m, mu, dtype)
        x = random.standard_normal(m)
        with mpmath.workdps(40):
            exact = mpmath.matrix(A.astype(float).tolist()) * mpmath.matrix(x.tolist())
            b = np.array([float(v) for v in exact]).astype(dtype)
        # b is rounded to machine numbers, one of the errors that the bound allows for
        Q, R = scipy.linalg.qr(A, mode="economic")
        result = scipy.linalg.solve_triangular(R, Q.T @ b)
        assert result.dtype == dtype
        error = np.linalg.norm(result - x) / np.linalg.norm(x)
        values = np.linalg.svd(A.astype(float), compute_uv=False)
        bound = rounding_bound(m, n, values[0] / values[-1], eps)
        assert error <= bound
        assert error < bound / 20  # in practice it is far from being reached


def test_residual_violates_the_bound_for_consistent_equations_only():
    random = np.random.default_rng(3)
    A = with_condition(random, 20, 4, 1e7)
    noise = random.standard_normal(20)
    noise -= A @ np.linalg.lstsq(A, noise, rcond=None)[0]
    b = A @ random.standard_normal(4) + 100 * noise
    exact, *_ = exact_solution(A, b, 60)
    exact = np.array([float(v) for v in exact])
    result = solve(A, b)
    error = np.linalg.norm(result.solvability.scaling * (result.x - exact))
    values = result.solvability.singular_values
    assert error > rounding_bound(4, 20, values[0] / values[-1]) * np.linalg.norm(
        result.solvability.scaling * exact
    )
    assert error <= result.rounding


@pytest.mark.parametrize("seed", range(12))
def test_bound_with_the_residual_holds(seed):
    random = np.random.default_rng(seed)
    m, n = int(random.integers(1, 6)), int(random.integers(6, 30))
    A = with_condition(random, n, m, 10 ** random.uniform(0, 8)) * 10 ** random.uniform(-3, 3, m)
    W = 10 ** random.uniform(-2, 2, n)
    b = A @ random.standard_normal(m) + 10 ** random.uniform(-8, 2) * random.standard_normal(n)
    roots = np.sqrt(W)
    exact, *_ = exact_solution(A / roots[:, None], b / roots, 60)
    result = solve(A, b, W)
    error = np.linalg.norm(
        result.solvability.scaling * (result.x - np.array([float(v) for v in exact]))
    )
    assert error <= result.rounding


# --- singular values, scaling, weights
# ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mu", [10, 1e5, 1e10])
def test_singular_values_against_fifty_digits(mu):
    random = np.random.default_rng(8)
    A = with_condition(random, 12, 5, mu) * np.array([1, 1e-3, 1e4, 10, 1e-6])
    result = analyse(A, scale=False)
    with mpmath.workdps(50):
        exact = np.array(
            [float(v) for v in mpmath.svd_r(mpmath.matrix(A.tolist()), compute_uv=False)]
        )
    assert (
        np.abs(result.singular_values * result.scaling[0] - exact).max()
        <= exact[0] * (reflection_constant(5, 12) + 11) * result.eps
    )
    scaled = analyse(A)
    with mpmath.workdps(50):
        B = mpmath.matrix(A.tolist())
        norms = [mpmath.sqrt(sum(B[i, j] ** 2 for i in range(12))) for j in range(5)]
        B = mpmath.matrix([[B[i, j] / norms[j] for j in range(5)] for i in range(12)])
        exact = np.array([float(v) for v in mpmath.svd_r(B, compute_uv=False)])
    assert np.abs(scaled.singular_values - exact).max() < 1e-14
    assert scaled.mu_scaled == pytest.approx(exact[0] / exact[-1], rel=1e-3 if mu > 1e9 else 1e-6)


@given(seed=st.integers(0, 10**6), powers=st.lists(st.floats(-12, 12), min_size=4, max_size=4))
@settings(max_examples=40, deadline=None)
def test_units_of_the_unknowns_do_not_matter(seed, powers):
    A = np.random.default_rng(seed).standard_normal((15, 4))
    units = 10.0 ** np.array(powers)
    first, other = analyse(A), analyse(A * units)
    assert np.allclose(first.singular_values, other.singular_values, rtol=1e-12)
    assert (
        first.mu_scaled == pytest.approx(other.mu_scaled, rel=1e-12)
        and first.solvable == other.solvable
    )
    assert np.allclose(first.standard_deviations, other.standard_deviations * units, rtol=1e-9)
    # scaling is within sqrt(m) of the best (van der Sluis)
    assert other.mu >= other.mu_scaled / 2 - 1


@given(seed=st.integers(0, 10**6))
@settings(max_examples=30, deadline=None)
def test_weights_in_all_their_forms(seed):
    random = np.random.default_rng(seed)
    A, Z = random.standard_normal((12, 3)), random.standard_normal(12)
    roots = random.standard_normal((4, 3, 3))
    blocks = roots @ roots.transpose(0, 2, 1) + 0.1 * np.eye(3)
    full = scipy.linalg.block_diag(*blocks)
    normal = np.linalg.solve(A.T @ np.linalg.solve(full, A), A.T @ np.linalg.solve(full, Z))
    covariance = np.linalg.inv(A.T @ np.linalg.solve(full, A))
    for W in (blocks, full):
        result = solve(A, Z, W)
        assert np.allclose(result.x, normal, rtol=1e-7, atol=1e-9)
        assert np.allclose(result.standard_errors, np.sqrt(np.diag(covariance)), rtol=1e-7)
        assert np.allclose(result.solvability.estimator @ Z, result.x, rtol=1e-7, atol=1e-9)
        assert np.allclose(result.residual, Z - A @ result.x)
    variances = np.diag(full)
    assert np.allclose(
        analyse(A, variances).singular_values, analyse(A, np.diag(variances)).singular_values
    )


def test_the_estimate_does_not_square_the_condition_number():
    t = np.linspace(0, 1, 60)
    A = t[:, None] ** np.arange(10)
    x = np.arange(1.0, 11)
    result = solve(A, A @ x)
    assert np.abs(result.x - x).max() < 1e-6
    # the normal equations do worse by orders of magnitude
    with pytest.raises(AssertionError):
        assert np.abs(np.linalg.solve(A.T @ A, A.T @ (A @ x)) - x).max() < 1e-6


# --- bounded noise and an inexact matrix
# ----------------------------------------------------------------------------------------


def test_noise_bound_is_never_exceeded_and_is_attained():
    random = np.random.default_rng(5)
    A, limits = random.standard_normal((9, 3)), random.uniform(0.1, 2, 9)
    W = np.diag(random.uniform(0.5, 2, 9)) + 0.1
    result = analyse(A, W)
    bound = result.noise_bound(limits)
    weights = np.linalg.inv(W)
    P = np.linalg.solve(A.T @ weights @ A, A.T @ weights)
    errors = np.abs(P @ (random.uniform(-1, 1, (9, 20000)) * limits[:, None]))
    assert (errors.max(axis=1) <= bound).all()
    corners = np.array(np.meshgrid(*[[-1, 1]] * 9)).reshape(9, -1) * limits[:, None]
    assert np.allclose(np.abs(P @ corners).max(axis=1), bound)
    state = np.array([1.0, -2.0, 3.0])
    entry = random.uniform(0, 0.05, A.shape)
    result = analyse(A, W, matrix_error=entry)
    bound, worst = result.noise_bound(limits, state), np.zeros(3)
    for _ in range(3000):
        true = A + entry * random.choice([-1, 1], A.shape)
        Z = true @ state + limits * random.choice([-1, 1], 9)
        worst = np.maximum(worst, np.abs(P @ Z - state))
    assert (worst <= bound).all() and (worst > 0.5 * bound).all()


def test_relative_bound_holds_where_the_printed_one_fails():
    A = np.array([[1.0, 0], [0, 1e-3], [0, 0]])
    x, e = np.array([1.0, 0]), np.array([0, 10.0, 0])
    finding = analyse(A, scale=False)
    error = np.linalg.norm(np.linalg.lstsq(A, A @ x + e, rcond=None)[0] - x)
    printed = finding.mu * np.linalg.norm(e) / np.linalg.norm(A @ x + e)
    assert error > 5 * printed
    assert error <= finding.relative_noise_bound(e, x) * (1 + 1e-12)
    random = np.random.default_rng(2)
    for _ in range(300):
        A, x, e = (
            random.standard_normal((6, 3)),
            random.standard_normal(3),
            3 * random.standard_normal(6),
        )
        finding = analyse(A)
        y = finding.scaling * (np.linalg.lstsq(A, A @ x + e, rcond=None)[0] - x)
        assert np.linalg.norm(y) <= finding.relative_noise_bound(e, x) * np.linalg.norm(
            finding.scaling * x
        )


@given(seed=st.integers(0, 10**6), log_error=st.floats(-12, -2))
@settings(max_examples=60, deadline=None)
def test_guaranteed_rank_is_never_above_the_rank(seed, log_error):
    random = np.random.default_rng(seed)
    rank = int(random.integers(1, 5))
    true = random.standard_normal((12, rank)) @ random.standard_normal((rank, 5))
    size = 10.0**log_error * np.abs(true).max(axis=0)
    result = analyse(
        true + random.uniform(-1, 1, true.shape) * size, matrix_error=size * np.ones_like(true)
    )
    assert result.rank <= rank < result.m and not result.solvable
    assert result.unobservable.shape == (5 - result.rank, 5)
    if result.rank == rank and log_error < -8:  # what is unseen is (nearly) in the kernel
        assert (
            np.abs(true @ result.unobservable.T).max()
            < 1e-3 * np.abs(result.unobservable * np.abs(true).max(axis=0)).max()
        )


# --- the examples
# ---------------------------------------------------------------------------------------------------------------


def station(latitude, longitude):
    latitude, longitude = np.radians([latitude, longitude])
    return RADIUS * np.array(
        [
            np.cos(latitude) * np.cos(longitude),
            np.cos(latitude) * np.sin(longitude),
            np.sin(latitude),
        ]
    )


def line_of_sight(place):
    direction = np.array([ORBIT, 0, 0]) - place
    return np.append(direction / np.linalg.norm(direction), np.zeros(3))


def test_transition_matrices_are_exact():
    t = np.array([0.0, 1e-3, 600, 40000, 86400.0])
    w = RATE
    A = np.zeros((6, 6))
    A[:3, 3:] = np.eye(3)
    A[3, 0], A[3, 4], A[4, 3], A[5, 2] = 3 * w * w, 2 * w, -2 * w, -w * w
    unit = np.array([1, 1, 1, w, w, w])  # lengths and velocities of the same size
    ours, by_series = clohessy_wiltshire(w, t), transition(A, t)
    assert np.abs((ours - by_series) * unit / unit[:, None]).max() < 1e-12
    with mpmath.workdps(40):
        small = mpmath.mpf(w) * mpmath.mpf(1e-3)
        assert ours[1, 1, 0] == pytest.approx(float(6 * (mpmath.sin(small) - small)), rel=1e-14)
    middle = clohessy_wiltshire(w, t, reference=600.0)
    assert (
        np.abs(
            (middle @ clohessy_wiltshire(w, [0.0, 600.0])[1] - ours) * unit / unit[:, None]
        ).max()
        < 1e-12
    )


@pytest.mark.parametrize("hours", [1, 6, 24, 200])
def test_geostationary_orbit_from_one_and_two_stations(hours):
    Phi = clohessy_wiltshire(RATE, np.linspace(0, 3600 * hours, 150))
    first = analyse(stack(line_of_sight(station(51, 30))[None], Phi))
    two = analyse(
        stack(np.stack([line_of_sight(station(51, 30)), line_of_sight(station(45, -20))]), Phi)
    )
    assert first.rank == 4 and two.rank == 6
    # lengths beside velocities: scaling gains orders
    assert two.mu > 1e3 * two.mu_scaled
    # the unseen motions, in closed form: free x and vx with y = 2 vx/w, vy = -2 w x, and z against
    # them
    a, b, c = line_of_sight(station(51, 30))[:3]
    kernel = np.array(
        [
            [1, 0, -a / c, 0, -2 * RATE, 2 * b * RATE / c],
            [0, 2 / RATE, -2 * b / (RATE * c), 1, 0, -a / c],
        ]
    )
    both = np.concatenate([first.unobservable, kernel]) * first.scaling
    assert np.linalg.matrix_rank(both / np.linalg.norm(both, axis=1, keepdims=True), tol=1e-6) == 2


def kepler(t, s):
    x, y, z, vx, vy, vz = s
    r3 = (x * x + y * y + z * z) ** 1.5
    return [vx, vy, vz, -EARTH * x / r3, -EARTH * y / r3, -EARTH * z / r3]


def ranges_from(places):
    """Ranges in axes that do not turn."""

    def h(t, s):
        c, k = np.cos(RATE * t), np.sin(RATE * t)
        return [
            np.sqrt(
                (s[0] - c * p[0] + k * p[1]) ** 2
                + (s[1] - k * p[0] - c * p[1]) ** 2
                + (s[2] - p[2]) ** 2
            )
            for p in places
        ]

    return h


def inertial(rtol, places=((51, 30),)):
    return linearise(
        kepler,
        ranges_from([station(*p) for p in places]),
        [ORBIT, 0, 0, 0, ORBIT * RATE, 0],
        np.arange(0, 86401, 600.0),
        rtol=rtol,
    )


def test_integration_errors_hide_a_rank_deficit_from_the_condition_number():
    for rtol in (1e-4, 1e-6, 1e-8):
        result = inertial(rtol)
        naive, aware = analyse(result.matrix), analyse(result)
        # the test of the paper
        assert naive.mu_scaled < naive.threshold and naive.solvable
        assert aware.rank == 4 and not aware.solvable
    # mu follows the tolerance
    assert analyse(inertial(1e-4).matrix).mu_scaled < analyse(inertial(1e-8).matrix).mu_scaled / 1e3
    assert analyse(inertial(1e-6, ((51, 30), (45, -20)))).solvable


def test_estimated_errors_of_the_matrix_are_true_bounds():
    t = np.arange(0, 86401, 600.0)
    exact = stack(line_of_sight(station(51, 30))[None], clohessy_wiltshire(RATE, t))
    # from the axes that turn to those that do not, at t = 0: v_inertial = v + w x r
    to_turning = np.eye(6)
    to_turning[3, 1], to_turning[4, 0] = RATE, -RATE
    for rtol in (1e-4, 1e-7, 1e-10):
        result = inertial(rtol)
        true = np.abs(result.matrix - exact @ to_turning)
        assert (
            np.linalg.norm(true, axis=0)
            <= np.linalg.norm(result.error, axis=0) + 1e-11 * np.linalg.norm(exact, axis=0)
        ).all()


def test_levelled_platform():
    g, R = 9.81, 6.371e6
    A = np.array([[0, -g, 0, 1], [1 / R, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 0]])
    t = np.arange(0, 7200, 60.0)
    with_bias = analyse(
        stack([[1, 0, 0, 0]], transition(A, t)),
        np.full(t.size, 1e-4),
        names=["v", "phi", "eps", "b"],
    )
    assert with_bias.rank == 3 and with_bias.undetermined == ("phi", "b")
    unseen = with_bias.unobservable[0]
    assert unseen[1] * g == pytest.approx(unseen[3], rel=1e-6) and abs(unseen[0]) < 1e-6
    assert analyse(stack([[1, 0, 0]], transition(A[:3, :3], t)), np.full(t.size, 1e-4)).rank == 3
    G, L = sp.symbols("g R", positive=True)
    exact = sp.Matrix([[0, -G, 0, 1], [1 / L, 0, 1, 0], [0, 0, 0, 0], [0, 0, 0, 0]])
    assert sp.Matrix.vstack(*[(exact**k)[0, :] for k in range(4)]).rank() == 3


TARGET, BREAK = [8.0, 6.0, -0.15, 0.05], 15.0


def bearings(own, t):
    def h(t, s):
        px, py = own(t)
        return [np.arctan2(s[1] - py, s[0] - px)]

    return linearise(lambda t, s: [s[2], s[3], 0, 0], h, TARGET, t, names=["x", "y", "vx", "vy"])


def test_bearings_need_a_manoeuvre():
    t = np.arange(31.0)
    straight = analyse(bearings(lambda t: (0.3 * t, 0 * t), t))
    assert straight.rank == 3
    # position and velocity seen from the observer
    relative = np.array([8.0, 6.0, -0.45, 0.05])
    assert np.allclose(
        straight.unobservable[0] / straight.unobservable[0, 0], relative / relative[0]
    )
    turned = analyse(bearings(lambda t: (0.3 * ca.fmin(t, BREAK), 0.3 * ca.fmax(t - BREAK, 0)), t))
    assert turned.solvable and turned.mu_scaled < 100


# --- linearisation
# --------------------------------------------------------------------------------------------------------------


def test_linearisation_against_finite_differences():
    from scipy.integrate import solve_ivp

    def f(t, s):
        return [s[1], -np.sin(s[0]) - 0.1 * s[1] + s[2] * np.cos(t), 0]

    def h(t, s):
        return [s[0] * s[1], np.exp(-(s[0] ** 2)) + t]

    t, start = np.array([0.0, 0.7, 1.0, 4.0]), np.array([1.0, 0.2, 0.5])
    result = linearise(f, h, start, t, reference=0.7)

    def outputs(s):
        back = solve_ivp(f, (0.7, 0.0), s, rtol=1e-12, atol=1e-13).y[:, -1]
        motion = solve_ivp(f, (0.0, 4.0), back, t_eval=t, rtol=1e-12, atol=1e-13).y.T
        return np.array([h(at, state) for at, state in zip(t, motion)]).ravel()

    step = 1e-4
    differences = np.column_stack(
        [(outputs(start + step * e) - outputs(start - step * e)) / (2 * step) for e in np.eye(3)]
    )
    assert np.abs(result.matrix - differences).max() < 1e-6
    assert np.allclose(result.predicted.ravel(), outputs(start), atol=1e-9)
    assert np.array_equal(result.Phi[1], np.eye(3)) and np.array_equal(result.motion[1], start)


def test_linearisation_of_constant_coefficients_is_the_exponential():
    A = np.array([[0, 1.0, 0], [-2, -0.3, 1], [0, 0, -1]])
    t = np.linspace(-1, 3, 9)
    result = linearise(
        lambda t, x: A @ x, lambda t, x: [x[0], x[2] - x[1]], [1.0, 0, 1], t, reference=1.0
    )
    assert np.abs(result.Phi - transition(A, t, 1.0)).max() < 1e-10
    assert (
        np.abs(result.matrix - stack([[1, 0, 0], [0, -1, 1]], transition(A, t, 1.0)))
        <= result.error + 1e-12
    ).all()


@pytest.mark.parametrize("reference", [0.0, 1.0, 2.5, 4.0])
def test_jumps_of_the_field_are_exact(reference):
    """x' = v, v' = u(t) k: the variation by k is a double integral of a step."""

    def f(t, s):
        return [s[1], s[2] * ca.if_else(t < 1, 1, ca.if_else(t < 2.5, -3, 2)), 0]

    t = np.array([0.0, 0.5, 1.0, 2.0, 2.5, 4.0])
    result = linearise(
        f, lambda t, s: [s[0]], [0.0, 0.0, 1.0], t, reference=reference, breaks=[1, 2.5]
    )
    velocity = np.interp(t, [0, 1, 2.5, 4], [0, 1, -3.5, -0.5])
    assert np.allclose(
        result.motion[:, 1], velocity - np.interp(reference, t, velocity), atol=1e-12
    )


def test_stack_from_functions_and_arrays():
    A = np.array([[0, 1.0], [-1, 0]])
    t = np.array([1.0, 2.0, 5.0])
    arrays = stack([[1, 0], [0, 2]], transition(A, t, 0.0))
    functions = stack(
        lambda t: [[1, 0], [0, 2]], lambda t, s: scipy.linalg.expm(A * (t - s)), t, reference=0.0
    )
    assert arrays.shape == (6, 2) and np.allclose(arrays, functions)


# --- boxes
# ----------------------------------------------------------------------------------------------------------------------


@given(seed=st.integers(0, 10**6))
@settings(max_examples=60, deadline=None)
def test_intervals_contain_the_true_values(seed):
    random = np.random.default_rng(seed)
    a, b = sp.symbols("a b")
    forms = [
        a * b - a / 3,
        (a - b) ** 2 / (1 + a**2),
        sp.sin(3 * a) * sp.cos(b),
        sp.exp(a / 5) - sp.sqrt(b + 9),
        sp.log(b + 10) ** 3,
        1 / sp.sqrt(a**2 + b**2 + 1),
        a**3 - sp.pi * b,
        sp.cos(20 * a),
    ]
    centre, half = random.uniform(-6, 6, 2), 10.0 ** random.uniform(-6, 0.5, 2)
    ends = np.array([centre - half, centre + half])
    from trajlib.solvability.boxes import _enclosure

    result = _enclosure([sp.Matrix(forms)], [a, b])(ends[:1], ends[1:])
    low, high = result.low.ravel(), result.high.ravel()
    function = sp.lambdify([a, b], forms, "mpmath")
    for point in np.vstack([random.uniform(*ends, (20, 2)), ends, centre]):
        with mpmath.workdps(30):
            values = [mpmath.re(v) for v in function(*map(mpmath.mpf, point.tolist()))]
        defined = np.isfinite(low) & np.isfinite(high)
        assert all(least <= v <= h for least, v, h, ok in zip(low, values, high, defined) if ok)


def test_interval_division_and_roots_outside_their_domain_conclude_nothing():
    wide = Interval(np.array([-1.0]), np.array([1.0]))
    assert np.isinf((1 / wide).high).all() and not np.isfinite(wide.log().low).all()
    assert not np.isfinite(wide.sqrt().low + wide.sqrt().high).all()
    a = sp.Symbol("a")
    assert not guarantee(sp.Matrix([[1 / a]]), {a: (-1, 2)}, scaling=[1], cells=300).lower > 0.51


def test_guarantee_of_a_quotient_by_a_root():
    """Its derivative has the power -3/2, and that of the third power of a root 1/2."""
    a = sp.Symbol("a")
    result = guarantee(
        sp.Matrix([[1 / sp.sqrt(a)], [a ** sp.Rational(3, 2)]]), {a: (1, 2)}, scaling=[1]
    )
    assert result.proved and result.lower <= np.sqrt(2) <= result.upper


@pytest.mark.slow
@pytest.mark.parametrize("width", [0.4, 0.8])
def test_guarantee_against_random_motions_of_the_box(width):
    x, y, v = sp.symbols("x y v")
    rows = []
    for k in range(0, 31, 3):
        dx, dy = (
            x - v * k - sp.Rational(3, 10) * min(k, 15),
            y + k * sp.Rational(1, 20) - sp.Rational(3, 10) * max(k - 15, 0),
        )
        r2 = dx**2 + dy**2
        rows.append([-dy / r2, dx / r2, -k * dy / r2, k * dx / r2])
    matrix = sp.Matrix(rows)
    box = {
        x: (8 - width, 8 + width),
        y: (6 - width, 6 + width),
        v: (0.15 - width / 200, 0.15 + width / 200),
    }
    result = guarantee(matrix, box)
    function = sp.lambdify([x, y, v], matrix)
    middle = function(8.0, 6.0, 0.15)
    random = np.random.default_rng(0)
    drawn = (
        function(*(random.uniform(*box[s]) for s in (x, y, v))) / np.linalg.norm(middle, axis=0)
        for _ in range(2000)
    )
    smallest = min(np.linalg.svd(first, compute_uv=False)[-1] for first in drawn)
    assert result.proved and 0 < result.lower <= smallest and result.lower >= 0.4 * result.upper
    assert "solvable in the whole box" in str(result)


def test_guarantee_does_not_prove_false_statements():
    a, b = sp.symbols("a b")
    # of rank 1 at a = 1, b = -1/3 too: the columns are equal at a = 1
    matrix = sp.Matrix([[1, a], [a, 1], [a + b, a + b]])
    result = guarantee(matrix, {a: (0, 3), b: (-1, 1)}, cells=3000)
    assert not result.proved and result.upper < 0.05 and "not proved" in str(result)
    assert abs(result.where["a"] - 1) < 0.1


# --- errors, words, appearance
# --------------------------------------------------------------------------------------------------

GOOD = np.array([[1.0, 0], [1, 1], [1, 2]])


@pytest.mark.parametrize(
    "matrix, options, words",
    [
        ([[1.0, 0], [2, 0], [3, 0]], {"names": ["x", "v"]}, "column of v is zero"),
        ([[1.0, 2, 3]], {}, "1 scalar measurements for 3 unknowns"),
        ([[1.0, np.nan], [1, 2]], {}, r"\(0, 1\) is not finite"),
        ([[1.0, np.inf], [1, 2]], {}, "not finite"),
        ([1.0, 2.0], {}, "expected a matrix"),
        (np.zeros((3, 0)), {}, "no columns"),
        (GOOD, {"W": [1, 0, 1]}, "variance of measurement 1 is 0"),
        (GOOD, {"W": [1, -2, 1]}, "must be positive"),
        (GOOD, {"W": np.zeros((3, 3))}, "W is zero"),
        (GOOD, {"W": np.diag([1.0, -1, 1])}, "smallest eigenvalue is -1"),
        (GOOD, {"W": np.ones((3, 3))}, "not positive definite"),
        (GOOD, {"W": [[1.0, 1, 0], [0, 1, 0], [0, 0, 1]]}, "symmetric"),
        (GOOD, {"W": [1, 1]}, "for 2 scalar measurements, but there are 3"),
        (GOOD, {"W": [1, np.inf, 1]}, "finite"),
        (GOOD, {"W": np.ones((3, 1, 2))}, "square blocks"),
        (GOOD, {"names": ["a"]}, "expected 2"),
        (GOOD, {"matrix_error": -1.0}, "matrix_error"),
        (GOOD, {"matrix_error": [1.0, 2.0]}, "shape"),
        (GOOD, {"eps": 0.0}, "relative precision"),
        (GOOD * 1e200, {"W": [1e-300, 1, 1]}, "change the units"),
    ],
)
def test_bad_systems_are_named(matrix, options, words):
    with pytest.raises(ValueError, match=words), np.errstate(over="ignore"):
        analyse(matrix, **options)


def test_other_errors():
    with pytest.raises(TypeError, match="matrix of numbers"):
        analyse([[sp.Symbol("a"), 1], [1, 2]])
    with pytest.raises(ValueError, match="one unknown"):
        reflection_constant(1, 5)
    with pytest.raises(ValueError, match="n: 2 rows"):
        threshold(3, 2)
    with pytest.raises(ValueError, match="1 or more"):
        rounding_bound(3, 5, 0.5)
    with pytest.raises(TypeError, match="numbers of unknowns"):
        threshold(3.5, 9)
    with pytest.raises(ValueError, match="shown to be solvable"):
        solve(np.ones((3, 2)), [1, 2, 3])
    with pytest.raises(ValueError, match="expected 3 measurements"):
        solve(GOOD, [1, 2])
    with pytest.raises(ValueError, match="measurement 1 is not finite"):
        solve(GOOD, [1, np.nan, 2])
    with pytest.raises(ValueError, match="standard deviations would have no meaning"):
        analyse(np.ones((3, 2))).standard_deviations
    with pytest.raises(ValueError, match="e: expected finite"):
        analyse(GOOD).noise_bound(-1)
    with pytest.raises(ValueError, match="must increase"):
        transition(np.eye(2), [0, 2, 1])
    with pytest.raises(ValueError, match="is repeated"):
        clohessy_wiltshire(1.0, [0, 1, 1])
    with pytest.raises(ValueError, match="positive angular"):
        clohessy_wiltshire(0.0, [0, 1])
    with pytest.raises(ValueError, match="square"):
        transition(np.ones((2, 3)), [0, 1])
    with pytest.raises(ValueError, match="needs the times"):
        stack(lambda t: [[1, 0]], np.zeros((2, 2, 2)))
    with pytest.raises(ValueError, match="H: expected shape"):
        stack([[1, 0, 0]], np.zeros((4, 2, 2)))


MOVE = {
    "f": lambda t, x: [x[1], 0],
    "h": lambda t, x: [x[0]],
    "state": [1.0, 1.0],
    "times": [0, 1, 2],
}


@pytest.mark.parametrize(
    "change, words",
    [
        ({"times": [0, 2, 1]}, "must increase"),
        ({"times": [0, 1, 1]}, "repeated"),
        ({"times": []}, "list of times"),
        ({"times": [0, np.nan]}, "not finite"),
        ({"state": [1.0, np.inf]}, "finite numbers"),
        ({"f": lambda t, x: [x[1]]}, "expected 2 rates"),
        ({"f": lambda t, x: [x[5], 0]}, "f: it cannot be called"),
        ({"h": lambda t, x: [1.0] if x[0] > 0 else [0.0]}, "without an `if`"),
        ({"h": lambda t, x: []}, "no measurement"),
        ({"h": lambda t, x: [np.sqrt(x[0] - 2)]}, "not finite at t = 0"),
        ({"f": lambda t, x: [x[0] ** 2, 0], "times": [0, 5]}, "could not be continued"),
        ({"f": lambda t, x: [math.sin(x[0]), 0]}, "not finite at the start.*module `math`"),
        ({"f": lambda t, x: [np.sqrt(x[0] - 2), 0]}, "not finite at the start"),
        ({"f": lambda t, x: [-1 / np.sqrt(x[0]), 0], "times": [0, 5]}, "could not be continued"),
        ({"reference": np.nan}, "reference"),
        ({"rtol": 0.0}, "rtol"),
        ({"names": ["x"]}, "expected 2"),
    ],
)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_bad_motions_are_named(change, words):
    with pytest.raises(ValueError, match=words):
        linearise(**(MOVE | change))


@pytest.mark.parametrize(
    "change, words",
    [
        ({"box": {sp.Symbol("a"): (1, 1)}}, "low < high"),
        ({"box": {sp.Symbol("b"): (1, 2)}}, "no interval for a"),
        ({"box": {}, "matrix": sp.Matrix([[1]])}, "no parameters"),
        ({"matrix": sp.Matrix([[sp.Symbol("a"), 1]])}, "1 rows cannot"),
        ({"matrix": sp.Matrix([[sp.gamma(sp.Symbol("a"))]])}, "gamma is not among"),
        ({"scaling": [0.0]}, "positive numbers"),
        ({"ratio": 2.0}, "ratio"),
    ],
)
def test_bad_boxes_are_named(change, words):
    with pytest.raises(ValueError, match=words):
        guarantee(
            **({"matrix": sp.Matrix([[sp.Symbol("a")]]), "box": {sp.Symbol("a"): (1, 2)}} | change)
        )


def test_one_unknown():
    result = analyse([[2.0], [1.0]], names=["x"])
    assert (
        result.solvable
        and result.mu == 1
        and result.threshold == np.inf
        and 0 < result.rounding_bound < 1e-13
    )
    assert solve([[2.0], [1.0]], [4.0, 2.0]).x == pytest.approx([2.0])
    assert not analyse([[1e-3], [-1e-3]], matrix_error=[[2e-3], [2e-3]]).solvable


def test_infinite_condition_number():
    result = analyse([[1.0, 0.5], [0, 0], [0, 0]])
    assert result.mu == np.inf or result.mu > 1e15
    assert not result.solvable and result.rank == 1 and result.rounding_bound == np.inf
    assert "x0 by" in result.verdict and "x1 by" in result.verdict


def test_verdict_for_a_matrix_without_errors():
    matrix = np.random.default_rng(1).normal(size=(5, 2))
    assert "taken as exact" in analyse(matrix).verdict
    assert "taken as exact" not in analyse(matrix, matrix_error=1e-9).verdict


def test_verdict_names_unknowns_with_their_units():
    result = analyse(
        np.array([[1.0, 2, 0], [2, 4, 1], [3, 6, 0], [1, 2, 5]]),
        names=["length", "width", "mass"],
        units=["km", "km", "t"],
    )
    assert result.undetermined == ("length", "width")
    assert "km" in result.verdict and "Determined by themselves: mass." in result.verdict
    assert repr(result) == result.verdict
    text = str(solve(GOOD, [1, 2, 3], names=["a", "b"], units=["m", "m/s"]))
    assert "a = 1 ±" in text and "m/s" in text


def test_plot_shows_all_singular_values():
    left, right = analyse(GOOD).plot()
    assert sum(line.get_xdata().size for line in left.lines[:1]) == 2 and right.images


@given(seed=st.integers(0, 10**6), error=st.floats(1e-6, 0.3))
@settings(max_examples=40, deadline=None)
def test_solvable_means_that_no_matrix_within_the_error_is_singular(seed, error):
    random = np.random.default_rng(seed)
    A = random.standard_normal((8, 3))
    result = analyse(A, matrix_error=error)
    assume(result.solvable)
    for _ in range(50):
        other = A + error * np.abs(A).max(axis=0) * random.uniform(-1, 1, A.shape)
        assert np.linalg.svd(other / result.scaling, compute_uv=False)[-1] > 0
    gap = np.linalg.svd(A / result.scaling, compute_uv=False)[-1] - np.linalg.norm(
        error * np.abs(A).max(axis=0) / result.scaling * np.ones_like(A)
    )
    assert gap > 0


def test_importing_costs_neither_casadi_nor_scipy():
    code = (
        "import sys; from trajlib.solvability import analyse, stack; import numpy as np; "
        "analyse(np.eye(3)); assert not {'casadi', 'scipy.integrate', 'sympy', 'matplotlib'} & "
        "set(sys.modules), sys.modules.keys()"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)


# --- stiff systems, poles, full covariances


def fast_and_slow(t, x):
    return [-1e6 * (x[0] - np.cos(t)), x[0] - x[1]]


def test_stiff_motion_needs_the_implicit_method():
    """The fast component follows (lambda^2 cos t + lambda sin t)/(1 + lambda^2) after microseconds."""
    times = np.array([0, 0.5, 2.0])
    line = linearise(fast_and_slow, lambda t, x: [x[0], x[1]], [1.0, 0.5], times, method="Radau")
    followed = (1e12 * np.cos(times) + 1e6 * np.sin(times)) / (1e12 + 1)
    assert line.predicted[1:, 0] == pytest.approx(followed[1:], abs=1e-9)
    assert line.Phi[:, 1, 1] == pytest.approx(np.exp(-times), rel=1e-9)
    assert line.Phi[1:, 1, 0] == pytest.approx(np.exp(-times[1:]) / (1e6 - 1), rel=1e-6)
    with pytest.raises(ArithmeticError, match=r'f: 3000 evaluations .* take method="Radau"'):
        linearise(fast_and_slow, fast_and_slow, [1.0, 0.5], times, max_evaluations=3000)
    with pytest.raises(ArithmeticError, match="f: 9 evaluations .* only; end earlier"):
        linearise(fast_and_slow, fast_and_slow, [1, 1], times, max_evaluations=9, method="Radau")


def test_both_methods_agree_where_nothing_is_stiff():
    explicit, implicit = (
        linearise(
            lambda t, x: [x[1], -np.sin(x[0])],
            lambda t, x: [x[0]],
            [1.0, 0.0],
            [-1.0, 0.0, 0.7, 2.0],
            reference=0.0,
            breaks=[0.5],
            rtol=1e-8,
            method=method,
        )
        for method in ("DOP853", "Radau")
    )
    assert np.abs(explicit.matrix - implicit.matrix).max() < 1e-9
    assert implicit.error.max() < 1e-7


P, Q = sp.symbols("p q")


@pytest.mark.parametrize(
    "entry, box, near",
    [
        (1 / P, {P: (-1, 1)}, {"p": 0}),
        (1 / (P - sp.sqrt(2) / 2), {P: (0, 1)}, {"p": 0.70710678}),
        (sp.sqrt(P) + 1, {P: (-1, 2)}, {"p": -0.25}),
        (sp.log(P) + 9, {P: (-0.1, 2)}, {"p": -0.034375}),
        (1 / (P - Q / 3), {P: (0, 1), Q: (0, 1)}, None),
    ],
)
def test_a_pole_and_a_negative_root_are_named(entry, box, near):
    bounds = guarantee(sp.Matrix([[1, 0], [0, entry]]), box, scaling=[1, 1], cells=3000)
    assert not bounds.proved and "matrix or its derivative is not finite" in repr(bounds)
    if near:
        assert bounds.undefined == pytest.approx(near, abs=1e-6)
    else:
        assert bounds.undefined["p"] == pytest.approx(bounds.undefined["q"] / 3, abs=1e-2)
    assert "near p = 0 the" in repr(guarantee(sp.Matrix([[1 / P]]), {P: (-1, 1)}))


def test_a_singular_matrix_is_no_pole():
    bounds = guarantee(sp.Matrix([[1, 0], [0, P]]), {P: (-1, 3)}, scaling=[1, 1])
    assert (
        bounds.undefined is None
        and bounds.upper == 0
        and "singular value found is 0" in repr(bounds)
    )


def test_full_covariance_is_factorised_once(monkeypatch):
    """An exact matrix needs neither the spectrum of W nor an inverse: 55 s became 3 for n = 3000."""
    t = np.linspace(0, 10, 300)
    H, gaps = np.stack([np.ones(300), t, np.sin(t)], axis=1), np.abs(np.subtract.outer(t, t))
    W = np.exp(-gaps) + 0.1 * np.eye(300)
    expected = np.linalg.inv(H.T @ np.linalg.inv(W) @ H)
    bounded = np.abs(np.linalg.inv(np.linalg.cholesky(W))) @ np.abs(1e-9 * H)

    def refuse(*_, **__):
        raise AssertionError("spectrum or inverse of a matrix")

    for name in ("eigvalsh", "eigh", "inv", "solve"):
        monkeypatch.setattr(np.linalg, name, refuse)
    result = analyse(H, W)
    assert result.standard_deviations**2 == pytest.approx(np.diag(expected), rel=1e-9)
    estimate = solve(H, H @ [1.0, 2.0, 3.0], W)
    assert estimate.x == pytest.approx([1, 2, 3], rel=1e-9)
    inexact = analyse(H, W, matrix_error=1e-9 * np.abs(H))
    assert inexact.matrix_error == pytest.approx(np.linalg.norm(bounded / inexact.scaling))


def test_a_singular_full_covariance_is_refused():
    H = np.ones((60, 1))
    for W in (np.ones((60, 60)), np.diag([1.0] * 59 + [-1e-3])):
        with pytest.raises(ValueError, match="W is not positive definite"):
            analyse(H, W)
