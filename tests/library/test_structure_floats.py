"""Verdicts in floats: units, defective eigenvalues and hundreds of pairs of known structure."""

import warnings

import control
import numpy as np
import pytest
import scipy.linalg
from known_pairs import known_pair

from trajlib.feedback import stabilisability
from trajlib.structure import (
    controllability,
    controllability_decomposition,
    controllable_subspace,
    observability,
    observability_decomposition,
    unobservable_subspace,
)
from trajlib.structure.nearest import smallest


def rotated(A, H, seed):
    Q = np.linalg.qr(np.random.default_rng(seed).normal(size=A.shape))[0]
    return Q @ A @ Q.T, H @ Q.T


@pytest.mark.slow
def test_known_pairs():
    """No wrong verdict and no wrong rank."""
    rng, wrong = np.random.default_rng(20261122), []
    for _ in range(500):
        A, H, unobservable, name = known_pair(
            rng, largest=int(rng.choice([8, 16, 24, 60], p=[0.4, 0.3, 0.2, 0.1]))
        )
        found = observability(A, H)
        if (found.holds, found.rank) != (unobservable == 0, len(A) - unobservable):
            wrong.append(f"{name}: {unobservable} unobservable, found {found.reason}")
    assert not wrong, "\n".join(wrong)


def test_defective_eigenvalue_is_not_reported_observable():
    Q = np.triu(np.ones((6, 6)))
    Q = Q @ Q.T
    A, B = np.round(Q @ np.diag(np.ones(5), 1) @ np.linalg.inv(Q)), Q[:, [3]]
    found = controllability(A, B)
    assert (found.holds, found.rank) == (False, 4) and found.margin < 1e-12


@pytest.mark.parametrize("n", range(3, 13))
def test_two_unobservable_states_of_a_rotated_chain(n):
    A, H = rotated(np.diag(np.ones(n - 1), 1), np.eye(n)[[2]], n)
    found = observability(A, H)
    assert found.rank == n - 2
    assert [m.eigenvalue for m in found.hidden_modes] == pytest.approx([0], abs=1e-6)
    basis = unobservable_subspace(A, H)
    assert basis.shape == (n, 2) and np.abs(H @ basis).max() < 1e-10
    assert np.linalg.norm(A @ basis - basis @ (basis.T @ A @ basis)) < 1e-7


def motor():
    """The angle of a DC motor: textbook data in SI units."""
    J, b, K, R, L = 3.2284e-6, 3.5077e-6, 0.0274, 4, 2.75e-6
    return (
        np.array([[0, 1, 0], [0, -b / J, K / J], [0, -K / L, -R / L]]),
        np.array([[1.0, 0, 0]]),
        np.array([[0], [0], [1 / L]]),
    )


def two_masses(k, m=1.0):
    A = np.block(
        [[np.zeros((2, 2)), np.eye(2)], [k / m * np.array([[-2, 1], [1, -2]]), np.zeros((2, 2))]]
    )
    return A, np.array([[1.0, 0, 0, 0]]), np.array([[0], [0], [0], [1 / m]])


@pytest.mark.parametrize(
    "A, H, B",
    [
        pytest.param(*motor(), id="motor"),
        *(pytest.param(*two_masses(k), id=f"masses {k:g}") for k in (1, 3e8, 1e12, 1e18)),
        *(
            pytest.param(
                np.array([[0, 1], [-(w**2), 0]]),
                np.array([[1.0, 0]]),
                np.array([[0], [1.0]]),
                id=f"oscillator {w:g}",
            )
            for w in (1, 3e4, 1e9, 1e-9)
        ),
        pytest.param(
            np.diag([1.0, 2.0, 3.0]),
            np.array([[1e-9, 1.0, 1e6]]),
            np.array([[1e3], [1.0], [1e-8]]),
            id="modes",
        ),
    ],
)
def test_bad_units_do_not_change_the_verdict(A, H, B):
    n = len(A)
    for found in (
        observability(A, H),
        controllability(A, B),
        controllability(control.ss(A, B, H, 0)),
    ):
        assert found.holds and found.margin > 1e-6 and "small" not in found.reason
    assert controllable_subspace(A, B).shape == (n, n) and unobservable_subspace(A, H).shape == (
        n,
        0,
    )
    assert (
        controllability_decomposition(A, B).sizes
        == observability_decomposition(A, H).sizes
        == (n, 0)
    )


def test_verdict_and_margin_do_not_depend_on_units():
    rng = np.random.default_rng(5)
    for _ in range(20):
        n, m = int(rng.integers(2, 9)), int(rng.integers(1, 3))
        A, H = rng.normal(size=(n, n)), rng.normal(size=(m, n))
        units, time_unit = 2.0 ** rng.integers(-20, 20, size=n), 2.0 ** rng.integers(-20, 20)
        here, there = (
            observability(A, H),
            observability(A * units / units[:, None] * time_unit, H * units),
        )
        # The exponents of the scaling are rounded to whole ones, here and there alike.
        assert here.holds and there.margin == pytest.approx(here.margin, rel=1e-6)


def test_decompositions_in_bad_units():
    rng = np.random.default_rng(6)
    A, H = rng.normal(size=(7, 7)), rng.normal(size=(2, 7))
    A[:4, 4:], H[:, 4:] = 0, 0
    A, H = rotated(A, H, 7)
    units = 10.0 ** rng.uniform(-5, 5, size=7)
    A, H = A * units / units[:, None], H * units
    found = observability_decomposition(A, H)
    assert found.sizes == (4, 3)
    assert np.abs(found.matrix[:4, 4:]).max() < 1e-10 * np.abs(found.matrix).max()
    assert np.abs(found.outputs[:, 4:]).max() < 1e-10 * np.abs(found.outputs).max()
    assert observability(*found.part).holds
    back = found.basis @ found.matrix @ found.transformation
    assert np.abs((back - A) / (np.abs(A) + 1e-300)).max() < 1e-6
    dual = controllability_decomposition(A.T, H.T)
    assert (
        dual.sizes == (4, 3)
        and np.abs(dual.matrix[4:, :4]).max() < 1e-10 * np.abs(dual.matrix).max()
    )


def test_margin_of_a_chain():
    """For a chain the least singular value depends on |lambda| alone: a line shows all of them."""
    A, H = np.diag(np.ones(29), 1), np.eye(30)[[0]]
    least = min(smallest(A, H, x)[0] for x in np.linspace(0, 2, 201))
    assert least == pytest.approx(np.sin(np.pi / 31), rel=1e-2)
    assert observability(A, H).margin == pytest.approx(least, rel=1e-2)
    for seed in range(3):
        assert observability(*rotated(A, H, seed)).margin == pytest.approx(least, rel=0.1)


def test_entries_of_rounding_size_count_as_zero_but_not_small_units():
    A, H = np.array([[1.0, 1e-17], [1.0, 2.0]]), np.array([[1.0, 0.0]])
    found = observability(A, H)
    assert not found.holds and "zero within rounding" in found.reason
    units = np.array([1e10, 1e-10])
    assert observability(
        np.array([[1.0, 1.0], [1.0, 2.0]]) * units / units[:, None], H * units
    ).holds


def test_doubtful_splits_warn():
    A, H = np.diag([1.0, 1.0 + 1e-9]), np.array([[1.0, 1.0]])
    for function in (unobservable_subspace, observability_decomposition):
        with pytest.warns(UserWarning, match="nothing is split off, but a change"):
            function(A, H)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert unobservable_subspace(np.diag([1.0, 2.0]), H).shape == (2, 0)
        assert unobservable_subspace(np.eye(2), H).shape == (2, 1)
        assert controllable_subspace(np.eye(2), np.zeros((2, 1))).shape == (2, 0)


def test_hidden_eigenvalues_of_a_large_pair():
    values = np.arange(1.0, 31)
    H = np.ones((1, 30))
    H[0, 10:20] = 0
    A, H = rotated(np.diag(values), H, 1)
    found = observability(A, H)
    assert sorted(m.eigenvalue for m in found.hidden_modes) == pytest.approx(values[10:20])
    for mode in found.hidden_modes:
        assert np.linalg.norm(A @ mode.vectors - mode.eigenvalue * mode.vectors) < 1e-10
    spiral = np.kron(np.diag([1.0, 3.0]), np.array([[0, 1], [-1, 0]]))
    found = observability(*rotated(spiral, np.array([[1.0, 0, 0, 0]]), 2))
    assert sorted(m.eigenvalue.imag for m in found.hidden_modes) == pytest.approx([-3, 3])


@pytest.mark.parametrize(
    "block, name", [([[0.0, 0], [0, -1]], "lambda = 0"), ([[0.0, 1], [-1, 0]], "lambda = 0+1j")]
)
def test_zero_within_rounding_is_named_zero(block, name):
    """An uncontrollable eigenvalue 0, or the real part of +-i, in rotated coordinates."""
    for seed in range(5):
        A, B = rotated(scipy.linalg.block_diag(block, 2.0), np.array([[0.0, 0, 1]]), seed)
        for test in (controllability, stabilisability):
            reason = test(A, B.T).reason.split("; margin")[0]
            assert name in reason and "e-" not in reason
