"""Regulators for definite and indefinite costs: their verdicts, exactly and in floats, against roots.

The systems are random ones of small integers, so that eigenvalues of the Hamiltonian matrix on the
axis, or of the symplectic pencil on the circle, are frequent. `exists` decides without a solution of
the Riccati equation: by the real roots of polynomials of integers.
"""

import numpy as np
import pytest
import sympy as sp

from trajlib.estimation.riccati_floats import stabilising_solution
from trajlib.feedback import discrete_lqr, lqr

#: A, B, G of systems that have no law of least cost with N = 1, and words of the exact reason.
WITHOUT_LAW = [
    (lqr, [[0, 1], [0, 0]], [0, 1], [[1, 0], [0, -3]], "no lower bound"),
    (lqr, [[0, 0], [2, -2]], [0, 1], [[-2, -1], [-1, 0]], "not stabilisable"),
    (lqr, [[0, 1], [-2, 2]], [-1, 0], [[0, -4], [-4, 0]], "no lower bound"),
    (lqr, [[-1, -2], [2, 1]], [1, -1], [[1, 0], [0, -1]], "approached, by no law"),
    (discrete_lqr, [[2, -1], [2, -1]], [2, -1], [[0, -2], [-2, 4]], "approached, by no law"),
    (discrete_lqr, [[-1, -1], [-2, 0]], [0, 1], [[0, 1], [1, 0]], "no lower bound"),
    (discrete_lqr, [[-1, 0], [2, 0]], [1, 0], [[-3, 3], [3, -1]], "no lower bound"),
    (discrete_lqr, [[-2]], [-1], [[-1]], "approached, by no law"),
]


def verdict(function, *system):
    """Return whether there is a law; None if that was not found."""
    try:
        return bool(function(*system))
    except np.linalg.LinAlgError as not_found:
        assert "not found" in str(not_found)
        return None


def floats(*matrices):
    return [np.array(matrix, dtype=float) for matrix in matrices]


@pytest.mark.parametrize("function, A, B, G, words", WITHOUT_LAW)
def test_no_law_is_invented(function, A, B, G, words):
    exact = function(sp.Matrix(A), sp.Matrix(B), sp.Matrix(G), 1)
    assert not exact and words in exact.reason
    assert not verdict(function, *floats(A, np.reshape(B, (-1, 1)), G, [[1]]))


def random_system(rng, largest):
    """Return A, B, G, N of integers; every third cost is definite."""
    n = int(rng.integers(1, largest + 1))
    s = int(rng.integers(1, 2 + (n > 1)))
    A, B, C = (rng.integers(-2, 3, size) for size in ((n, n), (n, s), (n, n)))
    G = C @ C.T if rng.integers(3) == 0 else C + C.T
    return A, B, G, np.eye(s, dtype=int) * int(rng.choice([1, 1, 2, 4]))


def exists(A, B, G, N, discrete):
    """Whether (A, B) is stabilisable, and Pi > 0 on the axis or the circle without a motion of no cost."""
    n, y = len(A), sp.Symbol("y")
    for value in np.linalg.eigvals(A):
        grows = abs(value) > 1 - 1e-6 if discrete else value.real > -1e-6
        pencil = np.hstack([value * np.eye(n) - A, B])
        if grows and np.linalg.svd(pencil, compute_uv=False)[-1] < 1e-6:
            return False
    A, B, G, N = map(sp.Matrix, (A, B, G, N))
    S, zero, one = B * N.inv() * B.T, sp.zeros(n), sp.eye(n)
    if discrete:  # (z - 1)/(z + 1) instead of z, which maps the circle to the axis
        left = sp.Matrix(sp.BlockMatrix([[A, zero], [-G, one]]))
        right = sp.Matrix(sp.BlockMatrix([[one, S], [zero, A.T]]))
        if (left + right).det() == 0:  # the eigenvalue z = -1
            return False
        hamiltonian = (left + right).LUsolve(left - right)
    else:
        hamiltonian = sp.Matrix(sp.BlockMatrix([[A, -S], [-G, -A.T]]))
    even = hamiltonian.charpoly().all_coeffs()[::2]
    in_squares = sp.Poly([c * (-1) ** k for k, c in enumerate(even)], y)
    if in_squares.count_roots(0, sp.oo):
        return False
    a, b, g, weight = floats(A, B, G, N)
    response = np.linalg.solve((0.6 + 0.8j if discrete else 2j) * np.eye(n) - a, b)
    return np.linalg.eigvalsh(weight + response.conj().T @ g @ response)[0] > 0


@pytest.mark.parametrize("function, discrete", [(lqr, False), (discrete_lqr, True)])
def test_verdict_of_floats_is_that_of_the_roots(function, discrete):
    rng, not_found = np.random.default_rng(52), 0
    found = {True: 0, False: 0}
    for _ in range(200):
        system = random_system(rng, 3)
        true, law = exists(*system, discrete), verdict(function, *floats(*system))
        not_found += law is None
        assert law is None or law == true, system
        assert law or not true, f"a law that exists was not found: {system}"
        found[true] += 1
    assert min(found.values()) > 40 and not_found < 30


@pytest.mark.parametrize("function, discrete", [(lqr, False), (discrete_lqr, True)])
def test_exact_verdict_is_that_of_the_roots_and_its_cost_that_of_floats(function, discrete):
    rng = np.random.default_rng(53)
    for _ in range(12):
        system = random_system(rng, 2)
        law = function(*map(sp.Matrix, system))
        assert bool(law) == exists(*system, discrete), system
        if law:
            near, cost = function(*floats(*system)), np.array(law.cost.evalf(30), dtype=float)
            assert np.linalg.norm(near.cost - cost) <= near.error * np.linalg.norm(cost), system


def test_nothing_uncertain_is_returned():
    """Beside -1 the weight -1 - d has no law; with -1 + d the loop has the eigenvalue -sqrt(d)."""
    for d in (1e-3, 1e-8, 1e-12):
        law = lqr(-1.0, 1.0, -1 + d, 1.0)
        assert law.loop[0, 0] == pytest.approx(-np.sqrt(d), rel=1e-3)
        assert not verdict(lqr, -1.0, 1.0, -1 - d, 1.0)
    unknown = stabilising_solution(
        *floats([[-1]], [[1]], [[-1]], [[1]]), False, False, lambda: "none"
    )
    assert unknown == "none"
