"""Distance to the nearest unobservable pair: its bracket against formulas and brute force."""

import control
import numpy as np
import pytest
import sympy as sp
from scipy.optimize import minimize

from trajlib.structure import distance_to_uncontrollable, distance_to_unobservable
from trajlib.structure.distance import _least_in_squares


def chain(n):
    return np.diag(np.ones(n - 1), 1), np.eye(n)[[0]]


def random_pair(rng, largest=6):
    n, m = int(rng.integers(1, largest)), int(rng.integers(1, 3))
    return rng.normal(size=(n, n)), rng.normal(size=(m, n))


def sigma(A, H, place):
    return np.linalg.svd(np.vstack([A - complex(*place) * np.eye(len(A)), H]), compute_uv=False)[-1]


def brute_force_distance(A, H):
    """Return the least value on a dense grid, refined from the best points."""
    reach = np.linalg.norm(A, 2)
    places = [(x, y) for x in np.linspace(-reach, reach, 61) for y in np.linspace(0, reach, 31)]
    best = sorted(places, key=lambda place: sigma(A, H, place))[:8]
    return min(
        minimize(
            lambda place: sigma(A, H, place),
            place,
            method="Nelder-Mead",
            options={"xatol": 1e-9, "fatol": 1e-12},
        ).fun
        for place in best
    )


@pytest.mark.parametrize("n", [2, 5, 12, 30])
def test_chains_of_integrators(n):
    found = distance_to_unobservable(*chain(n))
    assert found.lower <= np.sin(np.pi / (n + 1)) <= found.upper <= 1.0102 * found.lower


def test_brute_force_on_small_pairs():
    rng = np.random.default_rng(1)
    for _ in range(12):
        A, H = random_pair(rng)
        found, true = distance_to_unobservable(A, H), brute_force_distance(A, H)
        assert found.lower <= true * (1 + 1e-9) and true <= found.upper * (1 + 1e-6), (A, H)
        assert found.upper <= 1.0102 * found.lower


def test_a_change_of_the_upper_bound_makes_the_named_eigenvalue_unobservable():
    rng = np.random.default_rng(2)
    for _ in range(12):
        A, H = random_pair(rng)
        found, n = distance_to_unobservable(A, H), len(A)
        pencil = np.vstack([A - found.eigenvalue * np.eye(n), H])
        left, values, right = np.linalg.svd(pencil)
        change = -values[-1] * np.outer(left[:, n - 1], right[-1])
        assert np.linalg.norm(change, 2) <= found.upper
        assert np.linalg.svd(pencil + change, compute_uv=False)[-1] < 1e-12


def test_no_change_below_the_lower_bound_destroys_observability():
    """A change of half the lower bound leaves at least half of it at every lambda tried."""
    rng = np.random.default_rng(3)
    for _ in range(8):
        A, H = random_pair(rng)
        n, lower = len(A), distance_to_unobservable(A, H).lower
        for _ in range(20):
            change = rng.normal(size=(n + len(H), n))
            change *= lower / 2 / np.linalg.norm(change, 2)
            near = distance_to_unobservable(A + change[:n], H + change[n:])
            assert near.upper >= 0.5 * lower


def corners_of(A, H, centre, side):
    return np.array(
        [
            [
                sigma(A, H, (centre[0] + x, centre[1] + y))
                for x in (-side, side)
                for y in (-side, side)
            ]
        ]
    )


def test_bound_in_a_square_is_below_all_its_values_and_attained():
    """For one state sigma^2 = |lambda - a|^2 + h^2, and the bound about a is its least value h."""
    rng = np.random.default_rng(7)
    for side in (0.1, 1.0, 3.0):
        (bound,) = _least_in_squares(corners_of([[0.5]], [[2.0]], (0.5, 0), side / 2), side)
        assert bound == pytest.approx(2, rel=1e-12)
        for _ in range(10):
            A, H = random_pair(rng)
            centre = rng.normal(size=2)
            (bound,) = _least_in_squares(corners_of(A, H, centre, side / 2), side)
            inside = centre + rng.uniform(-side / 2, side / 2, size=(50, 2))
            assert bound <= min(sigma(A, H, place) for place in inside) + 1e-12


def test_bracket_is_proved_where_the_search_for_the_minimum_fails(monkeypatch):
    """The upper bound is then a value elsewhere; the lower one holds all the same."""
    monkeypatch.setattr("trajlib.structure.distance._MOST_SQUARES", 3000)
    rng = np.random.default_rng(8)
    for _ in range(4):
        A, H = random_pair(rng)
        true, scale = brute_force_distance(A, H), np.linalg.norm(np.vstack([A, H]), 2)
        elsewhere = 3 * true / scale, 0j, None
        monkeypatch.setattr("trajlib.structure.distance.descend", lambda *_, e=elsewhere: e)
        found = distance_to_unobservable(A, H)
        assert 0 < found.lower <= true * (1 + 1e-9) < found.upper


def test_rotations_change_nothing_and_units_scale_it():
    rng = np.random.default_rng(4)
    for A, H in (chain(12), random_pair(rng), random_pair(rng)):
        n, found = len(A), distance_to_unobservable(A, H)
        Q = np.linalg.qr(rng.normal(size=(n, n)))[0]
        turned = distance_to_unobservable(Q @ A @ Q.T, H @ Q.T)
        assert turned.lower <= found.upper and found.lower <= turned.upper
        assert turned.upper == pytest.approx(found.upper, rel=1e-2)
        larger = distance_to_unobservable(1e6 * A, 1e6 * H)
        assert (larger.lower, larger.upper) == pytest.approx((1e6 * found.lower, 1e6 * found.upper))


def test_controllability_is_dual_and_the_order_in_memory_changes_no_digit():
    for seed in range(12):
        A, H = random_pair(np.random.default_rng(seed))
        found = distance_to_unobservable(A, H)
        assert distance_to_uncontrollable(A.T, H.T) == found
        assert distance_to_uncontrollable(A.T.copy(), H.T.copy()) == found
        by_columns = np.asfortranarray(A), np.asfortranarray(H)
        assert distance_to_unobservable(*by_columns) == found


def test_state_spaces_and_exact_matrices_are_accepted():
    A, H = random_pair(np.random.default_rng(5))
    found = distance_to_unobservable(A, H)
    assert distance_to_unobservable(control.ss(A, np.eye(len(A)), H, 0)) == found
    exact = distance_to_unobservable(sp.Matrix([[0, 1], [0, 0]]), sp.Matrix([[1, 0]]))
    assert exact == distance_to_unobservable(*chain(2))


def test_unobservable_pairs_have_distance_zero():
    for A, H in (
        (np.eye(2), np.ones((1, 2))),
        (np.diag([1.0, 2, 3]), np.array([[1.0, 0, 1]])),
        (np.zeros((3, 3)), np.zeros((1, 3))),
    ):
        found = distance_to_unobservable(A, H)
        assert found.lower == 0 < found.upper < 1e-10


def test_the_bracket_is_wide_but_true_where_squares_are_too_many():
    """A chain whose third link is weak: sigma is tiny on an area about its multiple eigenvalue
    0."""
    A, H = chain(6)
    A[2, 3] = 1e-6
    found = distance_to_unobservable(A, H)
    assert 0 <= found.lower < found.upper <= 1e-6 + 1e-12
    A[2, 3] = 1e-2
    found = distance_to_unobservable(A, H)
    assert (
        found.lower <= brute_force_distance(A, H) <= found.upper * (1 + 1e-6)
        and found.upper <= 1.0102 * found.lower
    )


def test_a_narrower_bracket_lies_in_the_wider_one():
    A, H = random_pair(np.random.default_rng(6))
    wide, narrow = (distance_to_unobservable(A, H, within=within) for within in (0.2, 0.001))
    assert narrow.upper <= 1.002 * narrow.lower
    assert wide.lower <= narrow.upper <= wide.upper * (1 + 1e-9)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((sp.Matrix([[sp.Symbol("a")]]), sp.Matrix([[1]])), "real numbers"),
        ((np.eye(2), np.ones((1, 3))), "2 columns"),
        ((np.eye(2), np.ones((1, 2)), 0), "within"),
        ((np.eye(2), np.ones((1, 2)), 1.5), "within"),
    ],
)
def test_invalid_arguments(arguments, message):
    with pytest.raises(ValueError, match=message):
        distance_to_unobservable(*arguments)
