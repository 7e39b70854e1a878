"""Linear stability in all cases: problems 1.5, 1.10, and random Jordan structures."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from trajlib.stability import linear_stability

x = sp.Symbol("x")
Om, r0, V0, k0, k1, k2, k3 = sp.symbols("Omega r0 V0 k0 k1 k2 k3", positive=True)
M = sp.Matrix


def companion(poly):
    return M.companion(sp.Poly(poly, x))


def test_satellite_1_5():
    full = M(
        [
            [0, 0, 0, 1, 0, 0],
            [0, 0, 0, 0, 1, 0],
            [0, 0, 0, 0, 0, 1],
            [0, 0, 0, 0, -2 * Om / r0, 0],
            [0, 3 * Om**2, 0, 2 * r0 * Om, 0, 0],
            [0, 0, -(Om**2), 0, 0, 0],
        ]
    )
    found = linear_stability(full)
    assert found.verdict == "unstable"
    (mode,) = found.deciding_modes
    assert (mode.eigenvalues, mode.multiplicity, mode.eigenvectors, mode.semisimple) == (
        (0,),
        2,
        1,
        False,
    )

    reduced = linear_stability(full[1:, 1:])
    assert reduced.verdict == "stable"
    assert {(m.eigenvalues, m.multiplicity, m.semisimple) for m in reduced.deciding_modes} == {
        ((0,), 1, True),
        ((-sp.I * Om, sp.I * Om), 2, True),
    }


def test_robot_1_10():
    assert linear_stability(M([[0, 1], [0, -1]])).verdict == "stable"
    sideways = M([[0, V0, k0], [0, 0, 1], [0, 0, -k3 * (1 + k2 / k1 * V0)]])
    found = linear_stability(sideways)
    assert found.verdict == "unstable" and found.deciding_modes[0].multiplicity == 2
    # Standing still, the deviations do not grow.
    assert linear_stability(sideways.subs(V0, 0)).verdict == "stable"
    # A speed of unknown sign may be zero.
    unknown = sp.Symbol("V")
    assert linear_stability(M([[0, unknown, k0], [0, 0, 1], [0, 0, -k3]])).verdict == "undecided"


@pytest.mark.parametrize(
    "matrix, verdict",
    [
        (companion(x**2 + 3 * x + 2), "asymptotically stable"),
        (companion(x**4 + 3 * x**2 + 1), "stable"),
        (companion(x**4 + x**2 + 1), "unstable"),
        (companion((x**2 + 1) ** 2), "unstable"),
        (companion((x**2 + 1) * (x**2 + 2) * x), "stable"),
        (companion(x**5 + x + 1), "unstable"),
        (companion(x**6 + 6 * x**4 + 9 * x**2 + 1), "stable"),
        (sp.diag(companion(x**2 + 1), companion(x**2 + 1)), "stable"),
        (sp.zeros(3, 3), "stable"),
        (M([[0, 1], [0, 0]]), "unstable"),
        (M([[sp.sqrt(2), 1], [0, sp.sqrt(2)]]) - 2 * sp.eye(2), "asymptotically stable"),
        (M([[0, sp.pi], [-sp.pi, 0]]), "stable"),
        (M([[0, 1], [-k0, -k1]]), "asymptotically stable"),
        (M([[0, 1], [-k0, k1]]), "unstable"),
        (M([[0, 1], [k0, sp.Symbol("k")]]), "unstable"),
        (M([[0, 1], [-sp.Symbol("k"), -1]]), "undecided"),
        (sp.diag(M([[0, 1], [-(k0**2), 0]]), M([[0, 1], [-(k1**2), 0]])), "undecided"),
    ],
)
def test_exact_verdicts(matrix, verdict):
    assert linear_stability(matrix).verdict == verdict


def test_long_polynomials_name_the_roots_to_the_right():
    (mode,) = linear_stability(companion(x**5 + x**4 + x**3 + x**2 + 2)).deciding_modes
    assert mode.eigenvalues and all(sp.re(e.evalf()) > 0 for e in mode.eigenvalues)


def test_float_matrices():
    stable = linear_stability(np.array([[0.0, 1.0], [-1.0, -0.001]]))
    assert stable.verdict == "asymptotically stable" and stable.degree == pytest.approx(0.0005)
    assert linear_stability(np.array([[0.0, 1.0], [1.0, 0.0]])).verdict == "unstable"
    for critical in ([[0, 1], [-1, 0]], [[0, 1], [0, 0]], [[-1, 0], [0, 0]]):
        found = linear_stability(np.array(critical, dtype=float))
        assert found.verdict == "undecided" and "exactly" in found.reason
    # A large Jordan block: its computed spectrum lies on both sides of the axis, at a distance of
    # 1e-2.
    block = np.diag(np.ones(7), 1)
    rotation = np.linalg.qr(np.random.default_rng(0).normal(size=(8, 8)))[0]
    assert linear_stability(rotation @ block @ rotation.T).verdict == "undecided"


@pytest.mark.parametrize(
    "matrix", [sp.zeros(2, 3), M([[sp.I]]), np.ones((2, 3)), np.array([[np.nan]]), np.array([[1j]])]
)
def test_errors(matrix):
    with pytest.raises(ValueError, match="^A: "):
        linear_stability(matrix)


def block(eigenvalue, order):
    """A real Jordan block of a real eigenvalue or of a pair a +- i b given as (a, b)."""
    if isinstance(eigenvalue, tuple):
        (re, im), unit = eigenvalue, sp.eye(2)
        core = M([[re, im], [-im, re]])
    else:
        core, unit = M([[eigenvalue]]), sp.eye(1)
    n = core.rows
    J = sp.zeros(n * order, n * order)
    for i in range(order):
        J[n * i : n * i + n, n * i : n * i + n] = core
        if i:
            J[n * (i - 1) : n * i, n * i : n * i + n] = unit
    return J


half = sp.Rational(1, 2)
blocks = st.lists(
    st.tuples(
        st.sampled_from([-1, -half, 0, 0, half, (0, 1), (0, 1), (0, 2), (-half, 1)]),
        st.integers(1, 2),
    ),
    min_size=1,
    max_size=3,
)


@settings(max_examples=60, deadline=None)
@given(blocks, st.randoms(use_true_random=False))
def test_random_jordan_structures(structure, random):
    """Against the growth of the matrix exponential, in coordinates mixed by a unimodular matrix."""
    J = sp.diag(*(block(*b) for b in structure))
    n = J.rows
    T = sp.eye(n)
    for _ in range(n):
        i, j = random.randrange(n), random.randrange(n)
        if i != j:
            T[i, :] = T[i, :] + random.choice((-1, 1)) * T[j, :]
    A = T * J * T.inv()

    numeric = np.array(J.tolist(), dtype=float)
    early, late = (
        max(np.linalg.norm(expm(numeric * t)) for t in start + np.linspace(0, 7, 15))
        for start in (50, 200)
    )
    growth = late / early
    expected = "asymptotically stable" if growth < 0.1 else "unstable" if growth > 1.5 else "stable"
    assert linear_stability(A).verdict == expected
