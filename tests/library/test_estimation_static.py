"""Moments, least squares, Gauss-Newton and position fixes: exact cases and seeded samples."""

import numpy as np
import pytest
import scipy.linalg
import scipy.optimize
import sympy as sp

from trajlib import estimation

half, third = sp.Rational(1, 2), sp.Rational(1, 3)


def test_problems_4_5_to_4_9():
    angle = sp.Symbol("alpha", real=True)
    turn = sp.Matrix([[sp.cos(angle), sp.sin(angle)], [-sp.sin(angle), sp.cos(angle)]])
    turned = estimation.Moments([0, 0], [[5, 1], [1, 3]]).transformed(turn)
    assert sp.simplify(turned.covariance[0, 1] - (sp.cos(2 * angle) - sp.sin(2 * angle))) == 0
    assert turned.covariance.subs(angle, sp.pi / 8).applyfunc(sp.simplify)[0, 1] == 0
    K = [[1, half, 0], [half, 4, 0], [0, 0, 1]]
    x = estimation.Moments([0, 0, 0], K)
    assert x.transformed([[1, 1, 1], [1, -2, 1]]).covariance[0, 1] == -6 - half
    assert x.transformed([[1, 1, 1], [1, -2, -1]]).covariance[0, 1] == -8 - half
    y = estimation.Moments([1, 2, 3, 4], sp.diag(1, 4, 9, 1)).transformed(
        [[1, 5, 2, 0], [-1, 0, 0, 1]]
    )
    assert y.mean.T == sp.Matrix([[17, 3]]) and y.covariance[0, 1] == -1
    assert y.correlation[0, 1] == -1 / sp.sqrt(137 * 2)


def test_correlation_of_floats_is_that_of_numpy():
    sample = np.random.default_rng(4).normal(size=(50, 3))
    moments = estimation.Moments(sample.mean(axis=0), np.cov(sample.T))
    assert np.allclose(moments.correlation, np.corrcoef(sample.T))
    assert np.allclose(moments.deviations, sample.std(axis=0, ddof=1))


@pytest.mark.parametrize(
    "mean, covariance, message",
    [
        ([0, 0], [[1, 2], [0, 1]], "symmetric"),
        ([0, 0], [[1, 2], [2, 1]], "semidefinite"),
        ([0, 0], np.array([[1.0, 2.0], [2.0, 1.0]]), "semidefinite"),
        ([0], [[1, 0], [0, 1]], "mean: expected 2 components"),
        ([0, 0], np.array([[1.0, 1e-3], [0.0, 1.0]]), "symmetric"),
        ([0, 0], np.array([[np.nan, 0], [0, 1]]), "finite"),
        ([0, 0], [[0, 1], [1, 5]], "semidefinite"),
        ([0, 0], [[sp.sqrt(2), 2], [2, sp.sqrt(2)]], "semidefinite"),
        ([0, 0], [[sp.Symbol("p", negative=True), 0], [0, 1]], "semidefinite"),
        ([[0, 0], [0, 0]], [[1]], "vector"),
    ],
)
def test_moments_reject_what_is_no_covariance(mean, covariance, message):
    with pytest.raises(ValueError, match=message):
        estimation.Moments(mean, covariance)


def test_singular_covariances_are_accepted():
    assert estimation.Moments([0, 0], [[1, 1], [1, 1]]).transformed(
        [[1, -1]]
    ).covariance == sp.zeros(1)
    # nanoradians beside megametres
    P = np.outer([1e-9, 1e6], [1e-9, 1e6])
    assert estimation.Moments(np.zeros(2), P).transformed([[1, 0]]).covariance == pytest.approx(
        1e-18
    )
    with pytest.raises(ValueError, match="semidefinite"):
        estimation.Moments(np.zeros(2), [[1e-18, 2e-3], [2e-3, 1e12]])
    with pytest.raises(ValueError, match="without variance"):
        estimation.Moments([0, 0], sp.diag(1, 0)).correlation


def test_latex_and_substitution_of_moments():
    p = sp.Symbol("p", positive=True)
    x = estimation.Moments([p, 0], sp.diag(p, 1))
    assert r"\mu" in x._repr_latex_() and x.subs(p, 2).covariance == sp.diag(2, 1)
    assert "0.5" in estimation.Moments(np.array([0.5]), 1)._repr_latex_()


@pytest.mark.parametrize(
    "H, z, R, estimate",
    [
        # 4.10
        ([[1, 1], [1, -1], [1, 2]], [2, 0, 4], None, [sp.Rational(8, 7), sp.Rational(9, 7)]),
        # 4.11
        ([[1, 0], [1, 1], [1, 2]], [2, 1, 4], None, [sp.Rational(4, 3), 1]),
        # 4.12
        (
            [[1, 0], [1, 2], [1, 3], [1, 5]],
            [1, 2, 3, 4],
            None,
            [sp.Rational(25, 26), sp.Rational(8, 13)],
        ),
        # 4.13
        (
            [[1, 1], [1, 2], [1, 4], [1, 5]],
            [0, 1, 2, 4],
            None,
            [-sp.Rational(19, 20), sp.Rational(9, 10)],
        ),
        # 4.14
        ([[1, 1], [1, 2], [1, 3]], [1, 2, 3], sp.diag(1, sp.Rational(1, 4), 1), [0, 1]),
    ],
)
def test_problems_4_10_to_4_14(H, z, R, estimate):
    result = estimation.least_squares(H, z, R)
    assert list(result.estimate) == estimate
    H, z = sp.Matrix(H), sp.Matrix(z)
    R = sp.eye(H.rows) if R is None else R
    # the gradient of the misfit
    assert H.T * R.inv() * (z - H * result.estimate) == sp.zeros(2, 1)
    assert result.covariance == (H.T * R.inv() * H).inv()
    assert result.misfit == ((z - H * result.estimate).T * R.inv() * (z - H * result.estimate))[0]
    floats = estimation.least_squares(np.array(H, dtype=float), z, R)
    assert np.allclose(floats.estimate, np.array(result.estimate, dtype=float).ravel(), atol=1e-12)
    assert np.allclose(floats.covariance, np.array(result.covariance, dtype=float), atol=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_sequential_updates_agree_with_all_measurements_at_once(seed):
    rng = np.random.default_rng(seed)
    H, z = rng.normal(size=(12, 3)), rng.normal(size=12)
    mixing = rng.normal(size=(12, 12))
    R = scipy.linalg.block_diag(
        *(
            mixing[k : k + 4, k : k + 4] @ mixing[k : k + 4, k : k + 4].T + np.eye(4)
            for k in (0, 4, 8)
        )
    )
    at_once = estimation.least_squares(H, z, R)
    parts = estimation.least_squares(H[:4], z[:4], R[:4, :4])
    for k in (4, 8):
        parts = parts.updated(H[k : k + 4], z[k : k + 4], R[k : k + 4, k : k + 4])
    assert (
        np.allclose(parts.estimate, at_once.estimate, atol=1e-12)
        and parts.degrees_of_freedom == at_once.degrees_of_freedom == 9
    )
    assert np.allclose(parts.covariance, at_once.covariance, atol=1e-13)
    assert parts.misfit == pytest.approx(at_once.misfit, rel=1e-11)
    root = np.linalg.inv(np.linalg.cholesky(R))
    assert np.allclose(
        at_once.estimate, np.linalg.lstsq(root @ H, root @ z, rcond=None)[0], atol=1e-12
    )


def test_prior_is_equivalent_to_a_measurement_of_the_state():
    m, p, r = sp.symbols("m p r", positive=True)
    zs = sp.symbols("z0:3")
    result = estimation.least_squares([[1]] * 3, zs, r * sp.eye(3), prior=estimation.Moments(m, p))
    # problem 4.27
    assert sp.simplify(result.estimate[0] - (m / p + sum(zs) / r) / (1 / p + 3 / r)) == 0
    assert sp.simplify(result.covariance[0] - 1 / (1 / p + 3 / r)) == 0
    alone = estimation.least_squares([[1]] * 3, zs, r * sp.eye(3))
    assert (
        sp.simplify(alone.estimate[0] - sum(zs) / 3) == 0
        and sp.simplify(alone.covariance[0] - r / 3) == 0
    )
    certain = estimation.least_squares(
        [[1, 0]], [5], prior=estimation.Moments([1, 2], sp.diag(0, 1))
    )
    assert list(certain.estimate) == [1, 2] and certain.covariance == sp.diag(0, 1)


def test_fit_in_bad_units_keeps_its_digits():
    """Columns of sizes 1e-8 and 1e8, nearly parallel: against the same numbers in exact
    arithmetic."""
    H = [
        [sp.Rational(1, 10**8), 10**8],
        [sp.Rational(2, 10**8), 2 * 10**8 + 1],
        [sp.Rational(3, 10**8), 3 * 10**8 + 5],
    ]
    z = [1, 3, 4]
    exact = estimation.least_squares(H, z)
    floats = estimation.least_squares(np.array(H, dtype=float), z)
    assert np.allclose(floats.estimate, np.array(exact.estimate, dtype=float).ravel(), rtol=1e-6)


def test_errors_of_estimates_have_the_returned_covariance():
    rng = np.random.default_rng(11)
    H, mixing = rng.normal(size=(6, 2)), rng.normal(size=(6, 6))
    R = mixing @ mixing.T + np.eye(6)
    truth, root = np.array([1.0, -2.0]), np.linalg.cholesky(R)
    draws = [
        estimation.least_squares(H, H @ truth + root @ rng.normal(size=6), R) for _ in range(2000)
    ]
    errors = np.array([fit.estimate - truth for fit in draws])
    inverse = np.linalg.inv(draws[0].covariance)
    squares = np.einsum("ki,ij,kj->k", errors, inverse, errors)
    # chi-squared with 2 degrees of freedom each; 4 standard deviations of the mean of 2000, and of
    # the misfits' mean
    assert abs(squares.mean() - 2) < 4 * np.sqrt(4 / 2000)
    assert abs(np.mean([fit.misfit for fit in draws]) - 4) < 4 * np.sqrt(8 / 2000)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([[1, 1], [2, 2]], [1, 2]), "dependent"),
        ((np.array([[1.0, 1.0], [2.0, 2.0]]), [1, 2]), "dependent"),
        (([[1, 1]], [1]), r"multiple of \[1, -1\]"),
        ((np.array([[1.0, 1.0]]), [1]), "dependent"),
        (([[1, 0], [0, 1]], [1]), "2 components"),
        (([[1], [1]], [1, sp.nan]), "finite"),
        ((np.array([[1.0], [1.0]]), [1, np.nan]), "finite"),
        (([[1], [1]], [1, 2], sp.diag(1, 0)), "positive definite"),
        (([[1], [1]], [1, 2], np.diag([1.0, -1.0])), "positive definite"),
        (([[1], [1]], [1, 2], [[1, 1], [0, 1]]), "symmetric"),
        ((None, [1]), "H: expected"),
    ],
)
def test_least_squares_rejects_bad_arguments(arguments, message):
    with pytest.raises(ValueError, match=message):
        estimation.least_squares(*arguments)


x, y, w = sp.symbols("x y w")


@pytest.mark.parametrize("seed", range(3))
def test_gauss_newton_finds_the_minimum_of_scipy(seed):
    rng = np.random.default_rng(seed)
    towers, truth = rng.uniform(-10, 10, (5, 2)), rng.uniform(-3, 3, 2)
    h = [sp.sqrt((x - a) ** 2 + (y - b) ** 2) for a, b in towers]
    R = np.diag(rng.uniform(0.01, 0.1, 5))
    z = np.linalg.norm(towers - truth, axis=1) + np.sqrt(np.diag(R)) * rng.normal(size=5)
    fit = estimation.gauss_newton(h, z, [x, y], truth + 0.3, R)
    peer = scipy.optimize.least_squares(
        lambda p: (np.linalg.norm(towers - p, axis=1) - z) / np.sqrt(np.diag(R)),
        truth,
        xtol=1e-15,
        ftol=1e-15,
        gtol=1e-15,
    )
    assert fit and np.allclose(fit.estimate, peer.x, atol=1e-7)
    assert fit.misfit == pytest.approx(2 * peer.cost, rel=1e-10)
    assert np.allclose(fit.covariance, np.linalg.inv(peer.jac.T @ peer.jac), rtol=1e-5)
    assert "local minimum" in fit._repr_markdown_()


def test_rate_is_the_ratio_of_successive_steps():
    """A far-off measurement: the residuals stay, and the steps fall by the factor that is told, not
    quadratically."""
    fit = estimation.gauss_newton([x, x**2], [1, -0.2], [x], [0.5])
    ratios = [b / a for a, b in zip(fit.steps[-6:-1], fit.steps[-5:])]
    assert fit and 0.05 < fit.rate < 1 and np.allclose(ratios, fit.rate, rtol=0.02)


def test_steps_are_shortened_where_plain_gauss_newton_diverges():
    # h = (x, x^2) with z = (0.02, -3): the rate at the minimum is above 1, and full steps jump
    # across it
    fit = estimation.gauss_newton([x, x**2], [0.02, -3], [x], [0.4])
    assert fit and fit.rate > 1
    derivative = np.polynomial.Polynomial([-0.02, 1 + 2 * 3, 0, 2])  # of half the misfit
    (root,) = [r.real for r in derivative.roots() if abs(r.imag) < 1e-12]
    assert fit.estimate[0] == pytest.approx(root, abs=1e-6)


@pytest.mark.parametrize(
    "h, z, start, word",
    [
        # a minimum: h is far from z, yet nearest there
        ([x**2 + 1, 3 * x], [-4, 0], [1e-3], None),
        # the infimum lies at infinity
        ([sp.exp(-x), 0 * x + 1], [-1, 1], [0.0], "not converged"),
        ([x**2 - 1], [0], [1e-6], None),
    ],
)
def test_failed_convergence_is_reported(h, z, start, word):
    fit = estimation.gauss_newton(h, z, [x], start)
    assert bool(fit) == (word is None) and (word or "converged") in fit.reason


def test_stationary_point_that_is_no_minimum_is_reported():
    # the misfit (1 + x^2 - 5)^2 + x^2 has a maximum at 0, where a full step is zero
    fit = estimation.gauss_newton([1 + x**2, x], [5, 0], [x], [0.0])
    assert not fit and "no minimum" in fit.reason


@pytest.mark.parametrize(
    "h, z, start, message",
    [
        ([x + y, 2 * x + 2 * y], [1, 2], [0, 0], "dependent"),
        ([x, w], [1, 2], [0, 0], "also has w"),
        ([sp.log(x), y], [1, 2], [-1, 0], "not finite"),
        ([x, y], [1], [0, 0], "2 components"),
        ([x, y], [1, 2], [0], "2 components"),
    ],
)
def test_gauss_newton_rejects_bad_arguments(h, z, start, message):
    with pytest.raises(ValueError, match=message):
        estimation.gauss_newton(h, z, [x, y], start)


def ranges_squared(satellites, place):
    return [sum((r - p) ** 2 for r, p in zip(row, place)) for row in satellites]


SATELLITES = [[20, 3, 1], [-4, 22, 5], [2, -6, 25], [15, 14, 9]]


@pytest.mark.parametrize("count", [3, 4])
def test_ranges_without_error_give_the_position_and_its_image(count):
    position, satellites = [1, 2, -1], SATELLITES[:count]
    fix = estimation.satellite_fix(satellites, ranges_squared(satellites, position))
    assert len(fix.roots) == 2 and list(fix.nearest(position)) == position
    assert all(sp.simplify(e) == 0 for e in fix.residuals[fix.roots.index(fix.nearest(position))])
    if count == 3:
        image = next(root for root in fix.roots if list(root) != position)
        flat = sp.Plane(*(sp.Point3D(*row) for row in satellites))
        middle = sp.Point3D(*((sp.Matrix(position) + image) / 2))
        assert flat.distance(middle) == 0 and all(m == 0 for m in fix.misfits)
        assert flat.perpendicular_line(sp.Point3D(*position)).contains(sp.Point3D(*image))
    else:
        assert fix.misfits[0] == 0 and fix.misfits[1] > 0 and list(fix.roots[0]) == position
    floats = estimation.satellite_fix(
        np.array(satellites, float), ranges_squared(satellites, position)
    )
    assert (
        np.allclose(floats.nearest(position), position, atol=1e-9)
        and "position" in floats._repr_latex_()
    )


def test_the_roots_satisfy_the_normal_equations_with_their_own_square():
    rng = np.random.default_rng(7)
    satellites = np.array(SATELLITES, float)
    squares = np.array(ranges_squared(SATELLITES, [1, 2, -1]), float) + rng.normal(size=4)
    fix = estimation.satellite_fix(satellites, squares)
    for root in fix.roots:
        right = satellites.T @ ((satellites**2).sum(axis=1) - squares + root @ root)
        assert np.allclose(2 * satellites.T @ satellites @ root, right, rtol=1e-10)
    assert list(fix.misfits) == sorted(fix.misfits)
    optimum = estimation.gauss_newton(
        [(x - a) ** 2 + (y - b) ** 2 + (w - c) ** 2 for a, b, c in SATELLITES],
        squares,
        [x, y, w],
        fix.roots[0],
    )
    # problem 4.2: near, not optimal
    assert optimum and optimum.misfit < fix.misfits[0] < 2 * optimum.misfit


def test_noise_may_leave_no_position():
    satellites = SATELLITES[:3]
    flat = sp.Plane(*(sp.Point3D(*row) for row in satellites))
    foot = [sum(row[k] for row in satellites) / sp.Integer(3) for k in range(3)]
    squares = [e - 1 for e in ranges_squared(satellites, foot)]
    fix = estimation.satellite_fix(satellites, squares)
    assert flat.distance(sp.Point3D(*foot)) == 0 and not fix and "complex" in fix.reason
    with pytest.raises(ValueError, match="complex"):
        fix.nearest(foot)


@pytest.mark.parametrize(
    "satellites, squares, message",
    [
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0]], [1, 1, 1], "one plane with the origin"),
        (np.array([[1.0, 0, 0], [0, 1, 0], [1, 1, 0]]), [1, 1, 1], "one plane"),
        ([[1, 0, 0]], [1], "one plane"),
        (SATELLITES, [1, 1, 1], "4 components"),
        (SATELLITES, [1, 1, 1, -1], "not negative"),
    ],
)
def test_satellite_fix_rejects_bad_arguments(satellites, squares, message):
    with pytest.raises(ValueError, match=message):
        estimation.satellite_fix(satellites, squares)


def test_observability_by_ranges_depends_on_points_not_vectors():
    """The reading of problem 4.1: vectors that span the space, points in one plane."""
    flat = [[1, 0, 1], [0, 1, 1], [-1, 0, 1]]
    test = estimation.satellite_observability([0, 0, 1], flat)
    assert not test and test.rank == 2 and list(test.unobservable) == [0, 0, 1]
    assert sp.Matrix([[0, 0, 1], *flat]).rank() == 3
    floats = estimation.satellite_observability(np.array([0, 0, 1.0]), flat)
    assert not floats and np.allclose(np.abs(floats.unobservable.ravel()), [0, 0, 1])
    assert estimation.satellite_observability(np.array([0, 0, 1.1]), flat)
    assert "plane" in test._repr_markdown_()


def test_bearings_give_the_position_and_which_targets_lie_behind():
    observers, target = [[0, 0, 0], [3, 1, 0], [1, 5, 2]], sp.Matrix([4, 4, 7])
    directions = [list(target - sp.Matrix(r)) for r in observers]
    fix = estimation.bearing_fix(observers, directions)
    assert fix.position.applyfunc(sp.simplify) == target and fix.ahead == (True,) * 3
    assert fix.residuals.applyfunc(sp.simplify) == sp.zeros(3)
    directions[1] = [-e for e in directions[1]]
    assert estimation.bearing_fix(observers, directions).ahead == (True, False, True)
    rng = np.random.default_rng(3)
    units = np.array([np.array(d, float) / np.linalg.norm(np.array(d, float)) for d in directions])
    noisy = units + 0.01 * rng.normal(size=units.shape)
    floats = estimation.bearing_fix(np.array(observers, float), noisy)

    def from_lines(p):
        """The sum of squared distances from the lines of sight."""
        e = noisy / np.linalg.norm(noisy, axis=1)[:, None]
        return (np.cross(e, p - np.array(observers)) ** 2).sum()

    assert np.allclose(
        floats.position, scipy.optimize.minimize(from_lines, [4, 4, 7], tol=1e-14).x, atol=1e-5
    )
    assert (floats.residuals**2).sum() == pytest.approx(from_lines(floats.position))


def test_bearings_along_the_line_of_motion_do_not_determine_the_position():
    v, t = sp.symbols("v t", positive=True)
    # problem 4.3
    assert not estimation.bearing_observability([5, 0, 0], [[0, 0, 0], [v * t, 0, 0]])
    assert estimation.bearing_observability([5, 1, 0], [[0, 0, 0], [v * t, 0, 0]])
    assert not estimation.bearing_observability(np.array([5.0, 1, 0]), [[0, 0, 0], [0, 0, 0]])
    with pytest.raises(ValueError, match="that of observer 2"):
        estimation.bearing_observability([5, 1, 0], [[0, 0, 0], [5, 1, 0]])
    with pytest.raises(ValueError, match="parallel"):
        estimation.bearing_fix([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [2, 0, 0]])
    with pytest.raises(ValueError, match="is zero"):
        estimation.bearing_fix([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 0, 0]])
