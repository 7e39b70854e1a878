"""Gains in floats: known and exact gains, repeated and complex eigenvalues, units, errors."""

import control
import mpmath
import numpy as np
import pytest
import scipy.optimize
import scipy.signal
import sympy as sp

from trajlib.feedback import place, regulator
from trajlib.feedback.pole_placement import _again, _in_units


def chain(n):
    """A chain of n integrators: the gain is minus the coefficients of the polynomial."""
    return np.diag(np.ones(n - 1), 1), np.eye(n)[:, -1:]


def distance(A, B, gain, requested):
    left, worst = list(np.linalg.eigvals(A + B @ gain)), 0.0
    for value in requested:
        k = int(np.argmin([abs(value - other) for other in left]))
        worst = max(worst, abs(value - left.pop(k)))
    return worst


def random_pair(rng, n, s, spread=0.0):
    A, B = rng.normal(size=(n, n)) / np.sqrt(n), rng.normal(size=(n, s))
    units = 10.0 ** rng.uniform(-spread, spread, size=n)
    return A * units / units[:, None], B / units[:, None] * 10.0 ** rng.uniform(
        -spread, spread, size=s
    )


@pytest.mark.parametrize("n, s", [(3, 1), (6, 2), (12, 3)])
def test_good_units_undo_bad_ones(n, s):
    """Up to a factor that all have, the units D of x = D y are those that the states were given."""
    rng = np.random.default_rng(n)
    A, B = random_pair(rng, n, s)
    given = 10.0 ** rng.uniform(-5, 5, size=n)
    A, B = A * given / given[:, None], B / given[:, None]
    scaled, inputs, units, pushes, rate = _in_units(A, B)
    assert (units * given).max() < 10 * (units * given).min()
    assert scaled * units[:, None] / units * rate == pytest.approx(A, rel=1e-14)
    assert inputs * units[:, None] * rate / pushes == pytest.approx(B, rel=1e-14)


def test_one_correction_of_the_eigenvectors_takes_most_of_the_error_off():
    """In whatever order the eigenvalues are prescribed: here one further than those of the loop."""
    rng = np.random.default_rng(4)
    A, B = random_pair(rng, 6, 2)
    gain = place(A, B, -np.arange(1.0, 7)).gain
    near = gain * (1 + 1e-6 * rng.normal(size=gain.shape))
    requested = np.roll(np.round(np.linalg.eigvals(A + B @ near).real), 1)
    assert sorted(requested) == [-6, -5, -4, -3, -2, -1]
    corrected = _again(A, B, near, requested)
    before, after = (distance(A, B, K, requested) for K in (near, corrected))
    assert 1e-7 < before < 1e-3 and after < 1e-3 * before
    # eigenvectors in another order give the eigenvalues too, but far from the gain
    assert np.linalg.norm(corrected - gain) < 1e-3 * np.linalg.norm(gain)


@pytest.mark.parametrize("n", [1, 2, 5, 12, 20, 40])
def test_gain_of_a_chain_has_all_digits(n):
    found = place(*chain(n), [-1] * n)
    exact = sp.Poly((sp.Symbol("s") + 1) ** n).all_coeffs()
    assert found.gain[0].tolist() == [-float(c) for c in exact[:0:-1]]
    assert found.residual < 1e-14


@pytest.mark.parametrize("spread", [0, 3, 8])
@pytest.mark.parametrize(
    "requested", [[-1] * 6, [-1, -2, -3, -4, -5, -6], [-1 + 2j, -1 - 2j, -1 + 2j, -1 - 2j, -3, 0]]
)
def test_one_control_gives_the_exact_gain_rounded(requested, spread):
    A, B = random_pair(np.random.default_rng(len(str(requested))), 6, 1, spread)
    s = sp.Symbol("s")
    polynomial = sp.expand(sp.prod([s - sp.nsimplify(value) for value in requested]))
    exact = regulator(
        *(
            sp.Matrix(*part.shape, [sp.Rational(x) for x in part.ravel().tolist()])
            for part in (A, B)
        ),
        polynomial,
        s,
    ).gain
    found = place(A, B, requested)
    assert found.gain[0].tolist() == [float(k) for k in exact]


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:Convergence was not reached")
@pytest.mark.parametrize("spread", [0, 6])
@pytest.mark.parametrize(("n", "s"), [(4, 1), (8, 1), (16, 1), (40, 1), (6, 2), (9, 3)])
def test_no_peer_places_more_accurately(n, s, spread):
    """Compare medians up to a factor of two: differences in the last digits are chance."""
    rng, ratios = np.random.default_rng(100 * n + s), {"place_poles": [], "acker": []}
    requested = -np.linspace(0.5, 2, n)
    for _ in range(9 if n * s < 20 else 2):
        A, B = random_pair(rng, n, s, spread)
        ours = distance(A, B, place(A, B, requested).gain, requested)
        gains = {"place_poles": scipy.signal.place_poles(A, B, requested).gain_matrix}
        if s == 1 and np.linalg.matrix_rank(control.ctrb(A, B)) == n:  # else it refuses
            gains["acker"] = np.atleast_2d(control.acker(A, B, requested))
        for name, gain in gains.items():
            ratios[name].append(ours / max(distance(A, B, -gain, requested), 1e-15))
    assert all(np.median(found) <= 2 for found in ratios.values() if found), ratios


@pytest.mark.parametrize(
    ("n", "s", "requested"),
    [
        (4, 2, [-1] * 4),
        (6, 2, [-1] * 6),
        (7, 3, [-2] * 7),
        (6, 2, [-1 + 1j, -1 - 1j] * 3),
        (5, 2, [0] * 5),
        (8, 2, [-1] * 4 + [-2] * 4),
    ],
)
def test_eigenvalues_repeated_more_often_than_there_are_controls(n, s, requested):
    A, B = random_pair(np.random.default_rng(n + s), n, s)
    found = place(A, B, requested)
    assert found.gain.shape == (s, n) and found.residual < 1e-12
    # As many chains as controls: no eigenvalue is spread more than a chain of that length spreads
    # it.
    assert found.distance < 20 * (1e-14 * np.linalg.norm(A + B @ found.gain)) ** (
        1 / np.ceil(n / s)
    )
    assert found.condition > 1e6


def test_bad_units_of_several_controls():
    A, B = random_pair(np.random.default_rng(8), 8, 2, 6)
    requested = -np.arange(1.0, 9)
    found = place(A, B, requested)
    assert found.distance < 1e-7 and found.residual < 1e-14


def test_reported_accuracy_is_true():
    A, B = random_pair(np.random.default_rng(4), 5, 1)
    found = place(A, B, [-1, -2, -3, -4 + 1j, -4 - 1j])
    assert sorted(found.reached, key=lambda z: (z.real, z.imag)) == pytest.approx(
        sorted(np.linalg.eigvals(A + B @ found.gain), key=lambda z: (z.real, z.imag))
    )
    assert found.distance == pytest.approx(abs(found.reached - found.requested).max())
    assert found.distance < 1e-6


REPEATED = [-1] * 4, [-1] * 6, [-5, -5, -6, -6], [-1 + 1j, -1 - 1j] * 3
SIMPLE = [-1, -2, -3, -4 + 1j, -4 - 1j], list(-np.linspace(0.5, 2, 10))


@pytest.mark.parametrize("eigenvalues", [*REPEATED, *SIMPLE])
@pytest.mark.parametrize("s", [1, 2])
def test_uncertainty_is_above_the_error_and_near_it(eigenvalues, s):
    """The eigenvalues of A + BK, for the K of floats, with sixty digits."""
    ratios, n = [], len(eigenvalues)
    for seed in range(4):
        A, B = random_pair(np.random.default_rng(seed), n, s, 5 * (seed % 2))
        found = place(A, B, eigenvalues)
        with mpmath.workdps(60):
            exact_A, exact_B, gain = (mpmath.matrix(M.tolist()) for M in (A, B, found.gain))
            values = mpmath.eig(exact_A + exact_B * gain, left=False, right=False)
        distances = abs(np.subtract.outer(eigenvalues, [complex(value) for value in values]))
        error = distances[scipy.optimize.linear_sum_assignment(distances)].max()
        assert error < found.uncertainty
        ratios.append(found.uncertainty / max(error, 1e-16))
    assert np.median(ratios) < 1000


@pytest.mark.parametrize("spread", [0, 5])
def test_limits_of_floats_are_reported(spread):
    A, B = random_pair(np.random.default_rng(1), 40, 1, spread)
    found = place(A, B, -np.linspace(0.5, 2, 40))
    assert found.uncertainty > 1


def test_a_state_space_and_the_observer():
    A, B = chain(3)
    assert place(control.ss(A, B, np.eye(3), 0), None, [-1, -1, -1]).gain == pytest.approx(
        np.array([[-1, -3, -3]])
    )
    H = np.array([[1.0, 0, 0]])
    L = -place(A.T, H.T, [-1, -2, -3]).gain.T
    assert np.sort(np.linalg.eigvals(A - L @ H).real) == pytest.approx([-3, -2, -1])


def test_uncontrollable_modes_are_named():
    with pytest.raises(ValueError, match=r"controllable.*2|2.*controllable"):
        place(np.diag([1.0, 2.0]), np.array([[1.0], [0.0]]), [-1, -2])
    A, B = chain(3)
    for requested, words in (
        ([-1, -2], "expected 3"),
        ([-1, -2, np.inf], "finite"),
        ([-1, -2 + 1j, -2], "pairs"),
    ):
        with pytest.raises(ValueError, match=words):
            place(A, B, requested)
