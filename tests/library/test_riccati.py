"""Riccati equations in floats: true errors below their estimates, failures never called theorems."""

import control
import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from riccati_pairs import difference, reference, riccati_pairs

from trajlib import estimation, feedback
from trajlib.estimation import compensated
from trajlib.estimation.hypotheses import failed_hypothesis


def test_errors_are_below_their_estimates_and_near_them():
    """The whole, 500 equations of up to 100 states, is `benchmarks/riccati.py`."""
    ratios = []
    for kind, *equation in riccati_pairs(40, 10):
        A, H, Q, R, discrete = equation
        solve = estimation.discrete_stationary_filter if discrete else estimation.stationary_filter
        try:
            found = solve(A, H, Q, R)
        except np.linalg.LinAlgError as not_found:
            assert kind == "1 and 1 + 1e-6" and "not found" in str(not_found)
            continue
        assert found, f"{kind}, {len(A)} states: {found.reason}"
        error = difference(reference(*equation), found.covariance)
        assert error <= found.error, (kind, len(A), error, found.error)
        ratios.append(found.error / max(error, 1e-17))
        assert found.residual < 1e-14
    assert len(ratios) > 35 and np.median(ratios) < 1000


@pytest.mark.parametrize("inner", [1, 7, 100])
def test_products_of_pairs_have_twice_the_digits(inner):
    rng = np.random.default_rng(inner)

    def random_pair(*shape):
        high = rng.normal(size=shape)
        return high, high * rng.uniform(-1, 1, size=shape) * 2.0**-54

    A, B = random_pair(3, inner), random_pair(inner, 4)
    exact = [
        sum(map(sp.Matrix, map(rationals, factor)), sp.zeros(*factor[0].shape)) for factor in (A, B)
    ]
    high, low = map(rationals, compensated.product(A, B))
    rest = np.array(exact[0] * exact[1] - sp.Matrix(high) - sp.Matrix(low), dtype=float)
    size = np.abs(A[0]).max(axis=1)[:, None] * np.abs(B[0]).max(axis=0)
    assert np.abs(rest / size).max() < inner * 1e-30


def rationals(matrix):
    return [[sp.Rational(*entry.as_integer_ratio()) for entry in row] for row in matrix.tolist()]


# A position in nm; noise of a velocity in bad units; a slowly decaying state without cost.
SOLVABLE = [
    (feedback.lqr, ([[0, 1e9], [0, 0]], [[0], [1.0]], np.diag([1e-18, 0]), np.eye(1))),
    (estimation.discrete_stationary_filter, ([[1, 1e9], [0, 1]], [[1.0, 0]], np.diag([0, 1e-18]), np.eye(1))),
    (feedback.lqr, ([[-1e-10]], [[1.0]], [[0.0]], [[1.0]])),
    (estimation.stationary_filter, ([[-1e-10]], [[1.0]], [[0.0]], [[1.0]])),
    (estimation.discrete_stationary_filter, ([[1 - 1e-10]], [[1.0]], [[0.0]], [[1.0]])),
    (feedback.lqr, (np.diag([1, 1 + 1e-6]), np.ones((2, 1)), np.eye(2), np.eye(1))),
    (feedback.lqr, (np.diag([1, 2.0]), [[1.0], [1e-9]], np.eye(2), np.eye(1))),
]  # fmt: skip


@pytest.mark.parametrize("solve, matrices", SOLVABLE)
def test_bad_units_and_weak_inputs_are_solved(solve, matrices):
    found = solve(*map(np.array, matrices))
    assert found and found.error < 1e-10 and found.residual < 1e-15


def test_a_position_in_nanometres_has_the_poles_of_one_in_metres():
    found = feedback.lqr(*map(np.array, SOLVABLE[0][1]))
    poles = np.sort_complex(np.linalg.eigvals(found.loop))
    np.testing.assert_allclose(poles, [-(1 + 1j) / np.sqrt(2), -(1 - 1j) / np.sqrt(2)], rtol=1e-12)


@pytest.mark.parametrize("gap", [10**-4, 10**-5, 10**-12])
def test_exact_modes_may_be_near_one_another(gap):
    gap = sp.Rational(str(gap))
    A, B = sp.diag(1, 1 + gap), sp.Matrix([1, 1])
    law, filter = (
        feedback.lqr(A, B, sp.eye(2), 1),
        estimation.stationary_filter(A, B.T, sp.eye(2), 1),
    )
    assert law and filter and law.cost == filter.covariance
    S = law.cost
    assert (A * S + S * A + sp.eye(2) - S * B * B.T * S).applyfunc(sp.expand).applyfunc(
        sp.radsimp
    ) == sp.zeros(2)
    assert law.loop.trace() < 0 < law.loop.det()  # two stable modes


def test_exact_weights_may_be_tiny():
    tiny = sp.Rational(1, 10**40)
    assert feedback.lqr(-tiny, 1, 0, 1) and feedback.lqr(0, 1, tiny, 1).gain[0] == -sp.sqrt(tiny)
    assert "imaginary axis" in feedback.lqr(0, 1, 0, 1).reason


def test_what_floats_cannot_hold_is_not_found():
    """A general A of 100 unstable modes and two inputs; a mode that is measured by 1e-14."""
    rng = np.random.default_rng(0)
    A, H = np.triu(rng.normal(size=(40, 40))) + 5 * np.eye(40), rng.normal(size=(1, 40))
    with pytest.raises(np.linalg.LinAlgError, match="not found"):
        estimation.stationary_filter(A, H, np.eye(40), np.eye(1))
    with pytest.raises(np.linalg.LinAlgError, match="not found"):
        feedback.lqr(A.T, H.T, np.eye(40), np.eye(1))


def rotated(A, H, Q):
    T = np.linalg.qr(np.random.default_rng(3).normal(size=(len(A), len(A))))[0]
    return T @ A @ T.T, H @ T.T, T @ Q @ T.T


UNSOLVABLE = [
    (np.diag([1.0, 2, -3]), [[1.0, 0, 1]], np.eye(3), False, "not detectable"),
    (np.diag([0.0, 2, -3]), [[0.0, 1, 1]], np.eye(3), False, "not detectable"),
    (np.diag([0.0, 2, -3]), [[1.0, 1, 1]], np.diag([0.0, 1, 1]), False, "free of noise"),
    (np.diag([0.5, -1.5, 0.1]), [[1.0, 0, 1]], np.eye(3), True, "not detectable"),
    (np.diag([0.5, -1, 0.1]), [[1.0, 1, 1]], np.diag([1.0, 0, 1]), True, "free of noise"),
    (np.diag([-1.0, 2, 3]), [[0.0, 1, 1]], np.diag([0.0, 0, 0]), False, None),
    (np.diag([0.5, 1.5, -0.1]), [[0.0, 1, 1]], np.eye(3), True, None),
]


@pytest.mark.parametrize("A, H, Q, discrete, words", UNSOLVABLE)
@pytest.mark.parametrize("turn", [lambda *matrices: matrices, rotated])
def test_hypotheses_are_decided_by_the_rank_tests(A, H, Q, discrete, words, turn):
    A, H, Q = turn(A, np.array(H), Q)
    solve = estimation.discrete_stationary_filter if discrete else estimation.stationary_filter
    found, failed = solve(A, H, Q, np.eye(1)), failed_hypothesis(A, H, Q, discrete)
    assert bool(found) == (words is None) == (failed is None)
    assert words is None or (words in found.reason and words in failed)


def test_solution_is_that_of_scipy_and_python_control():
    rng = np.random.default_rng(8)
    A, B = rng.normal(size=(6, 6)), rng.normal(size=(6, 2))
    C, G, N = rng.normal(size=(1, 6)), np.eye(6), np.diag([1.0, 4.0])
    law = feedback.lqr(A, B, G, N)
    np.testing.assert_allclose(law.cost, scipy.linalg.solve_continuous_are(A, B, G, N), rtol=1e-9)
    filter = estimation.discrete_stationary_filter(A, C, G, [[2.0]])
    gain, P, _ = control.dlqe(A, np.eye(6), C, G, [[2.0]], method="scipy")
    np.testing.assert_allclose(filter.covariance, P, rtol=1e-8)
    np.testing.assert_allclose(A @ filter.gain, gain, rtol=1e-7)


def test_no_words_are_computed_before_they_are_asked_for(monkeypatch):
    """The rank tests take many times as long as the solution."""
    from trajlib.estimation import stationary_filters

    monkeypatch.setattr(stationary_filters, "observability", lambda *_: pytest.fail("computed"))
    estimation.stationary_filter(np.eye(3), np.eye(3), np.eye(3), np.eye(3))


@pytest.mark.parametrize("gap", [1e-1, 1e-3, 1e-6])
@pytest.mark.parametrize("solve", [feedback.lqr, feedback.discrete_lqr])
def test_close_unstable_modes_are_not_found_without_warnings(solve, gap):
    """Twenty-five modes from 1 on, one input: pytest turns a warning of SciPy into an error."""
    with pytest.raises(np.linalg.LinAlgError, match="not found"):
        solve(np.diag(1 + gap * np.arange(25)), np.ones((25, 1)), np.eye(25), np.eye(1))


ROTATION = sp.Matrix([[3, -4], [4, 3]]) / 5
#: Eigenvalues without a closed form: those of the companion matrix of l^3 + l^2 + l + 3 grow.
COMPANION = sp.Matrix([[0, 1, 0], [0, 0, 1], [-3, -1, -1]])


@pytest.mark.parametrize(
    "A, H, Q, discrete, words",
    [
        (ROTATION, [[1, 0]], sp.zeros(2), True, "free of noise"),
        (ROTATION, [[0, 0]], sp.eye(2), True, "not detectable"),
        (ROTATION / 2, [[0, 0]], sp.eye(2), True, None),
        (COMPANION, [[0, 0, 0]], sp.eye(3), False, "not detectable"),
        (COMPANION / 4, [[0, 0, 0]], sp.eye(3), True, None),
        (sp.diag(1, 1 + sp.Rational(1, 10**30)), [[1, 0]], sp.eye(2), False, "not detectable"),
        (sp.diag(-sp.Rational(1, 10**30), 1), [[0, 1]], sp.diag(0, 1), False, None),
        (sp.diag(0, 1), [[1, 1]], sp.diag(0, 1), False, "free of noise"),
    ],
)
def test_exact_hypotheses_are_decided_exactly(A, H, Q, discrete, words):
    failed = failed_hypothesis(A, sp.Matrix(H), Q, discrete)
    assert (failed is None) if words is None else words in failed
