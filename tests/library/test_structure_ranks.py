"""Rank tests, exact and in floats, of first-order and mechanical systems; duality; errors."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.structure import (
    controllability,
    controllability_conditions,
    controllability_decomposition,
    controllability_matrix,
    controllable_subspace,
    controller_canonical_form,
    exact,
    first_order_form,
    mechanical_controllability,
    mechanical_observability,
    observability,
    observability_decomposition,
    observability_matrix,
    observer_canonical_form,
    unobservable_subspace,
)

M = sp.Matrix
w, lam = sp.Symbol("omega"), sp.Symbol("lambda")


# Exact systems


def hidden_eigenvalues(found):
    return {m.eigenvalue for m in found.hidden_modes}


def test_a_factor_without_closed_roots_is_given_itself():
    cubic = M([[0, 1, 0], [0, 0, 1], [1, 1, 0]])
    A, H = sp.diag(cubic, M([[5]])), M([[0, 0, 0, 1]])
    (mode,) = observability(A, H).hidden_modes
    assert isinstance(mode.eigenvalue, sp.Poly) and mode.eigenvalue.as_expr() == lam**3 - lam - 1
    for root in sp.Poly(lam**3 - lam - 1, lam).nroots():
        v = np.array(mode.vectors.subs(lam, root).evalf(), dtype=complex)
        assert (
            np.linalg.norm(v) > 0.1
            and np.allclose(np.array(A, dtype=float) @ v, complex(root) * v)
            and v[3] == 0
        )
    assert "lambda**3" in observability(A, H).reason
    (mode,) = controllability(A.T, H.T).hidden_modes
    assert mode.vectors.shape == (1, 4)


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_determinants_have_their_sign(n):
    matrix = M(n, n, lambda i, j: w + i if i == j else i - 2 * j)
    assert sp.expand(exact.determinant(matrix) - matrix.det()) == 0 != matrix.det()


def test_eigenvalues_with_roots_of_symbols():
    """sqrt(a) and sqrt(a + 1) depend on each other, so that no field of SymPy holds both."""
    a = sp.Symbol("a", positive=True)
    A = sp.diag(sp.sqrt(a), sp.sqrt(a + 1), 1)
    found = observability(A, M([[0, 0, 1]]))
    assert found.rank == 1 and len(found.hidden_modes) == 2
    assert {m.eigenvalue: m.vectors for m in found.hidden_modes} == {
        sp.sqrt(a): M([1, 0, 0]),
        sp.sqrt(a + 1): M([0, 1, 0]),
    }


def test_complex_and_irrational_numbers():
    A = sp.diag(M([[0, 1], [-2, 0]]), M([[0, 1], [2, 0]]), M([[7]]))
    found = observability(A, M([[0, 0, 0, 0, 1]]))
    assert found.rank == 1 and hidden_eigenvalues(found) == {
        sp.sqrt(2),
        -sp.sqrt(2),
        sp.I * sp.sqrt(2),
        -sp.I * sp.sqrt(2),
    }
    for mode in found.hidden_modes:
        assert (A * mode.vectors - mode.eigenvalue * mode.vectors).expand().is_zero_matrix
    root = sp.sqrt(2)
    assert observability(M([[root, 1], [0, -root]]), M([[1, root]])).holds
    assert not observability(M([[root, 0], [2, -root]]), M([[1, 0]])).holds
    found = observability(M([[0, root], [root, 0]]), M([[1, 1]]))
    assert hidden_eigenvalues(found) == {-root} and found.rank == 1
    # A field in which SymPy cannot factor.
    p = sp.Symbol("p", positive=True)
    found = observability(M([[0, sp.sqrt(p)], [sp.sqrt(p), 0]]), M([[1, 1]]))
    assert hidden_eigenvalues(found) == {-sp.sqrt(p)} and found.rank == 1


def test_generic_verdicts_with_symbols_are_marked():
    found = observability(sp.diag(M([[0, w], [-w, 0]]), M([[0, w], [-w, 0]])), M([[1, 0, 1, 0]]))
    assert (
        found.rank == 2
        and hidden_eigenvalues(found) == {sp.I * w, -sp.I * w}
        and "general values" in found.reason
    )
    A, H = M([[0, 1], [0, w]]), M([[0, 1]])
    assert observability(A, H).rank == 1 and hidden_eigenvalues(observability(A, H)) == {0}
    # The user's own lambda does no harm.
    found = observability(sp.diag(lam, lam), M([[1, 1]]))
    assert hidden_eigenvalues(found) == {lam}
    assert observer_canonical_form(M([[0, 1], [lam, 0]]), [1, 0]).polynomial.free_symbols > {lam}


def test_several_vectors_at_one_eigenvalue():
    found = observability(2 * sp.eye(3), M([[1, 1, 1]]))
    (mode,) = found.hidden_modes
    assert mode.eigenvalue == 2 and mode.vectors.shape == (3, 2) and mode.vectors.rank() == 2


@st.composite
def split_systems(draw, size=4):
    """Return (A, H, k) with an unobservable part of order k, mixed by a unimodular matrix."""
    n = draw(st.integers(1, size))
    k, m = draw(st.integers(0, n)), draw(st.integers(1, 2))
    small = st.integers(-2, 2)

    def matrix(rows, columns):
        return M(
            rows, columns, draw(st.lists(small, min_size=rows * columns, max_size=rows * columns))
        )

    A, H = matrix(n, n), matrix(m, n)
    A[: n - k, n - k :], H[:, n - k :] = sp.zeros(n - k, k), sp.zeros(m, k)
    T = sp.eye(n)
    for _ in range(3 if n > 1 else 0):
        i, j = draw(st.permutations(range(n)))[:2]
        T[i, :] += draw(small) * T[j, :]
    return T.inv() * A * T, H * T, k


def unobservable_dimension(A, H):
    """Return the degree of the gcd of the maximal minors of (A - lambda I; H)."""
    from itertools import combinations

    P = M.vstack(A - lam * sp.eye(A.rows), H)
    minors = (
        P.extract(list(rows), list(range(A.rows))).det(method="berkowitz")
        for rows in combinations(range(P.rows), A.rows)
    )
    divisor = sp.gcd_list([sp.expand(m) for m in minors])
    return sp.degree(divisor, lam)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(split_systems())
def test_exact_ranks(system):
    A, H, k = system
    found, n = observability(A, H), A.rows
    assert found.rank <= n - k and found.rank == n - unobservable_dimension(A, H)
    assert found.holds == (not found.hidden_modes)
    for mode in found.hidden_modes:
        if not isinstance(mode.eigenvalue, sp.Poly):
            v, number = np.array(mode.vectors.evalf(), dtype=complex), complex(mode.eigenvalue)
            Af, Hf = np.array(A, dtype=float), np.array(H, dtype=float)
            assert (
                np.linalg.matrix_rank(v) == v.shape[1]
                and np.allclose(Af @ v, number * v)
                and np.allclose(Hf @ v, 0)
            )
    dual = controllability(A.T, H.T)
    assert (dual.holds, dual.rank, hidden_eigenvalues(dual)) == (
        found.holds,
        found.rank,
        hidden_eigenvalues(found),
    )
    assert controllability_matrix(A.T, H.T) == observability_matrix(A, H).T

    unobservable, reached = unobservable_subspace(A, H), controllable_subspace(A.T, H.T)
    assert unobservable.cols + reached.cols == n and (unobservable.T * reached).is_zero_matrix
    split = observability_decomposition(A, H)
    assert split.sizes == (found.rank, n - found.rank)
    assert (
        split.matrix[: found.rank, found.rank :].is_zero_matrix and split.transformation.det() != 0
    )
    assert controllability_decomposition(A.T, H.T).basis == split.transformation.T


# Floats


@pytest.mark.parametrize("n", [6, 12, 20, 40])
def test_pbh_test_decides_where_the_rank_of_the_kalman_matrix_fails(n):
    A, H = np.diag(np.arange(1.0, n + 1)), np.ones((1, n))
    found = observability(A, H)
    assert found.holds and found.rank == n and 0.4 < n * found.margin < 0.6
    assert controllability(A, H.T).holds
    assert (np.linalg.matrix_rank(observability_matrix(A, H)) < n) == (n >= 12)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(split_systems(size=5))
def test_float_verdicts_agree_with_exact_ones(system):
    A, H, _ = system
    exact, found = (
        observability(A, H),
        observability(np.array(A, dtype=float), np.array(H, dtype=float)),
    )
    assert (found.holds, found.rank) == (exact.holds, exact.rank)
    seen_margin = found.margin
    assert (
        seen_margin > 1e-8
        if found.holds
        else seen_margin < 1e-12 * (1 + float(A.norm()) + float(H.norm()))
    )
    Af, Hf = np.array(A, dtype=float), np.array(H, dtype=float)
    for mode in found.hidden_modes:
        scale = 1e-6 * (1 + np.abs(Af).max())
        assert (
            np.abs(Af @ mode.vectors - mode.eigenvalue * mode.vectors).max() < scale
            and np.abs(Hf @ mode.vectors).max() < scale
        )


@pytest.mark.parametrize("position, rank", [(3, 1), (2, 2), (1, 3), (0, 4)])
def test_multiple_eigenvalue_in_floats(position, rank):
    """Rounding spreads the eigenvalues of a 4 x 4 Jordan block over a circle of radius 1e-4."""
    Q = np.linalg.qr(np.random.default_rng(1).normal(size=(4, 4)))[0]
    A = Q @ (np.diag([2.0] * 4) + np.diag([1.0] * 3, 1)) @ Q.T
    found = observability(A, np.eye(4)[[position]] @ Q.T)
    assert found.rank == rank and (
        found.holds or [m.eigenvalue for m in found.hidden_modes] == pytest.approx([2.0])
    )


def test_subspaces_and_decompositions_of_floats():
    rng = np.random.default_rng(2)
    A, H = rng.normal(size=(9, 9)), np.zeros((2, 9))
    A[:6, 6:], H[:, :6] = 0, rng.normal(size=(2, 6))
    T = rng.normal(size=(9, 9))
    A, H = np.linalg.solve(T, A @ T), H @ T
    unobservable = unobservable_subspace(A, H)
    assert unobservable.shape == (9, 3) and np.abs(H @ unobservable).max() < 1e-11
    assert np.linalg.norm(
        A @ unobservable - unobservable @ (unobservable.T @ A @ unobservable)
    ) < 1e-10 * np.linalg.norm(A)
    found = observability_decomposition(A, H)
    assert (
        found.sizes == (6, 3)
        and np.abs(found.matrix[:6, 6:]).max() < 1e-10
        and np.abs(found.outputs[:, 6:]).max() < 1e-11
    )
    assert np.allclose(found.basis @ found.matrix @ found.transformation, A)
    dual = controllability_decomposition(A.T, H.T)
    assert (
        dual.sizes == (6, 3)
        and np.abs(dual.matrix[6:, :6]).max() < 1e-10
        and np.abs(dual.inputs[6:]).max() < 1e-11
    )
    assert controllable_subspace(A.T, H.T).shape == (9, 6)
    assert "T" in found._repr_latex_() and "margin" in observability(A, H).reason


def test_margins_near_the_tolerance_are_reported():
    found = observability(np.diag([1.0, 1.0 + 1e-9]), np.array([[1.0, 1.0]]))
    assert found.holds and found.margin < 1e-9 and "small" in found.reason
    found = observability(np.diag([1.0, 1.0]), np.array([[1.0, 1.0]]))
    assert not found.holds and found.rank == 1
    assert "small" not in observability(np.diag([1.0, 2.0]), np.array([[1.0, 1.0]])).reason


def test_state_space_of_python_control():
    system = control.ss([[0, 1], [1, 0]], [[0], [1]], [[1, 1]], 0)
    assert not observability(system).holds and controllability(system).holds
    assert np.array_equal(controllability_matrix(system), [[0, 1], [1, 0]])
    assert observability_decomposition(system).sizes == (1, 1)
    assert controller_canonical_form(system).matrix[1] == pytest.approx([1, 0])


@pytest.mark.parametrize("n", [1, 2, 3])
def test_the_vector_of_a_canonical_form_may_be_a_row_or_a_column(n):
    A, row = M(n, n, lambda i, j: (i + 2 * j) ** 2 % 5), M(1, n, lambda i, j: j + 1)
    assert observer_canonical_form(A, row) == observer_canonical_form(A, row.T)
    assert controller_canonical_form(A, row) == controller_canonical_form(A, row.T)


def test_canonical_forms_of_floats():
    A, h = np.array([[1.0, 1.0], [1.0, -1.0]]), np.array([1.0, 0.0])
    found = observer_canonical_form(A, h)
    assert np.allclose(found.transformation @ A, found.matrix @ found.transformation)
    assert np.allclose(found.vector @ found.transformation, h)
    rng = np.random.default_rng(3)
    A, b = rng.normal(size=(5, 5)), rng.normal(size=(5, 1))
    found = controller_canonical_form(A, b)
    assert np.allclose(found.transformation @ A @ found.basis, found.matrix) and np.allclose(
        found.transformation @ b, found.vector
    )
    with pytest.raises(ValueError, match="condition number"):
        observer_canonical_form(np.diag(np.arange(1.0, 21)), np.ones((1, 20)))


# Mechanical systems

MECHANICAL = {
    "2.7a": (
        M([[2, 1], [1, 2]]),
        sp.zeros(2),
        M([[0, -1], [-1, 0]]),
        M([[1, 0]]),
        M([[1, 0]]),
        set(),
    ),
    "2.7b": (
        M([[2, 1], [1, 1]]),
        sp.zeros(2),
        sp.diag(-5, 6),
        M([[1, 3]]),
        sp.zeros(1, 2),
        {sp.sqrt(3), -sp.sqrt(3)},
    ),
    "2.7c": (
        M([[2, -1], [-1, 3]]),
        sp.zeros(2),
        M([[0, -1], [0, -2]]),
        M([[1, 0]]),
        M([[0, 1]]),
        {-1},
    ),
    "2.7d": (
        sp.diag(3, 1),
        M([[0, -1], [1, 0]]),
        M([[-2, 1], [1, -1]]),
        sp.zeros(1, 2),
        M([[1, 2]]),
        {-1},
    ),
}


@pytest.mark.parametrize("name", MECHANICAL)
def test_mechanical_observability(name):
    Mass, D, K, H1, H2, numbers = MECHANICAL[name]
    found = mechanical_observability(Mass, D, K, H1, H2)
    assert hidden_eigenvalues(found) == numbers and found.order == 4
    A, _, H = first_order_form(Mass, D, K, H1=H1, H2=H2)
    assert found.rank == observability(A, H).rank and numbers == hidden_eigenvalues(
        observability(A, H)
    )
    for mode in found.hidden_modes:
        s, v = mode.eigenvalue, mode.vectors
        assert ((Mass * s**2 + D * s + K) * v).expand().is_zero_matrix and (
            (H1 + s * H2) * v
        ).expand().is_zero_matrix
    floats = mechanical_observability(*(np.array(m, dtype=float) for m in (Mass, D, K, H1, H2)))
    assert (floats.holds, floats.rank) == (found.holds, found.rank)
    assert all(m.vectors.shape == (2, 1) for m in floats.hidden_modes)


def test_mechanical_controllability():
    M26, K26 = M([[2, 1], [1, 3]]), M([[3, 1], [1, -2]])
    assert mechanical_controllability(M26, sp.zeros(2), K26, M([2, 1])).holds
    beta = sp.Symbol("beta")
    found = mechanical_controllability(
        M([[1, 1], [1, 2]]), sp.zeros(2), M([[1, 1], [3, beta]]), M([1, 3])
    )
    assert found.holds and "general values" in found.reason
    at = mechanical_controllability(
        M([[1, 1], [1, 2]]), sp.zeros(2), M([[1, 1], [3, 3]]), M([1, 3])
    )
    assert at.rank == 2
    for mode in at.hidden_modes:
        assert (
            (mode.vectors * (M([[1, 1], [1, 2]]) * mode.eigenvalue**2 + M([[1, 1], [3, 3]])))
            .expand()
            .is_zero_matrix
        )
        assert (mode.vectors * M([1, 3])).is_zero_matrix
    # Problem 2.31: along the track the satellite is controllable, along the radius it is not.
    D, K = M([[0, 2 * w], [-2 * w, 0]]), sp.diag(0, -3 * w**2)
    assert mechanical_controllability(sp.eye(2), D, K, M([1, 0])).holds
    radial = mechanical_controllability(sp.eye(2), D, K, M([0, 1]))
    assert radial.rank == 3 and hidden_eigenvalues(radial) == {0}
    # Problem 2.36, in the masses' general values.
    m1, m2, L1, L2, g = sp.symbols("m1 m2 l1 l2 g", positive=True)
    Mass, K = M([[(m1 + m2) * L1, m2 * L2], [L1, L2]]), -g * sp.diag(m1 + m2, 1)
    assert mechanical_controllability(Mass, sp.zeros(2), K, M([-m1 - m2, -1])).holds
    A, B, _ = first_order_form(Mass, sp.zeros(2), K, M([-m1 - m2, -1]))
    assert controllability_conditions(A, B, [m1, m2, L1, L2, g]).region is sp.true


def test_a_singular_mass_matrix():
    """Problem 2.7d as printed, x2' in the place of x2'': of third order."""
    found = mechanical_observability(
        sp.diag(3, 0), M([[0, -1], [1, 1]]), M([[-2, 1], [1, -1]]), sp.zeros(1, 2), M([[1, 2]])
    )
    assert (found.holds, found.order) == (True, 3)
    with pytest.raises(ValueError, match="M: expected an invertible matrix"):
        first_order_form(sp.diag(3, 0), sp.eye(2), sp.eye(2))
    with pytest.raises(ValueError, match="vanishes identically"):
        mechanical_observability(sp.diag(3, 0), sp.zeros(2), sp.zeros(2), sp.ones(1, 2))


def test_first_order_form():
    A, B, H = first_order_form(sp.eye(2), sp.zeros(2), sp.diag(1, 4))
    assert (
        B is None
        and H is None
        and A == M([[0, 0, 1, 0], [0, 0, 0, 1], [-1, 0, 0, 0], [0, -4, 0, 0]])
    )
    A, B, H = first_order_form(
        2 * np.eye(1), np.eye(1), np.eye(1), L=np.array([[3.0]]), H2=np.array([[1.0]])
    )
    assert (
        np.array_equal(A, [[0, 1], [-0.5, -0.5]])
        and np.array_equal(B, [[0], [1.5]])
        and np.array_equal(H, [[0, 1]])
    )


# Errors


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: observability(M([[1, 2]]), M([[1, 0]])), "A: expected a square matrix"),
        (lambda: observability(sp.eye(2), M([1, 0])), "one row"),
        (lambda: observability(sp.eye(2), M([[1, 0, 0]])), "H: expected a matrix with 2 columns"),
        (lambda: observability(sp.eye(2)), "H: expected a matrix beside A"),
        (lambda: controllability(sp.eye(2)), "B: expected a matrix beside A"),
        (lambda: controllability(sp.eye(2), M([[1, 0]])), "one column"),
        (lambda: observability(sp.eye(2), M([[1, sp.I]])), "H: expected a real matrix"),
        (lambda: observability(np.eye(2), np.array([[1.0, np.nan]])), "H: expected finite"),
        (lambda: observability(M([[1, sp.nan], [0, 1]]), M([[1, 0]])), "A: expected finite"),
        (lambda: observability(sp.eye(2), M([[1, sp.oo]])), "H: expected finite"),
        (
            lambda: controllability(np.array([[1, np.inf], [0, 1]]), np.ones((2, 1))),
            "A: expected finite",
        ),
        (
            lambda: mechanical_observability(np.array([[np.nan]]), np.eye(1), np.eye(1), np.eye(1)),
            "M: expected finite",
        ),
        (
            lambda: observability(M([[sp.exp(w), 1], [0, 1]]), M([[1, 0]])),
            r"exp\(omega\) stands in the system.*put sym",
        ),
        (
            lambda: controllability(M([[2**w, 1], [0, 1]]), M([1, 0])),
            r"2\*\*omega stands in the system",
        ),
        (lambda: observability(np.eye(2), M([[1, w]])), "exactly"),
        (lambda: observability(np.eye(2) * 1j, np.ones((1, 2))), "real"),
        (
            lambda: observer_canonical_form(sp.eye(2), [1, 0]),
            "rank 1 of 2.*observability_decomposition",
        ),
        (
            lambda: controller_canonical_form(sp.eye(2), [1, 0]),
            "rank 1 of 2.*controllability_decomposition",
        ),
        (lambda: controller_canonical_form(np.eye(2), np.ones((2, 1))), "rank 1 of 2"),
        (lambda: observer_canonical_form(sp.eye(2), sp.eye(2)), "decompose_by_outputs"),
        (
            lambda: mechanical_observability(sp.eye(2), sp.eye(3), sp.eye(2), sp.ones(1, 2)),
            "D: expected a square matrix",
        ),
        (
            lambda: mechanical_observability(sp.eye(2), sp.eye(2), sp.eye(2), sp.ones(1, 3)),
            "H1: expected a matrix with 2 columns",
        ),
        (
            lambda: mechanical_observability(sp.eye(2), sp.eye(2), sp.eye(2), None),
            "H1: expected a matrix",
        ),
        (
            lambda: mechanical_observability(
                sp.eye(2), sp.eye(2), sp.eye(2), sp.ones(1, 2), sp.ones(2, 2)
            ),
            "H2: expected the shape",
        ),
        (
            lambda: mechanical_controllability(sp.eye(2), sp.eye(2), sp.eye(2), sp.ones(3, 1)),
            "L: expected a matrix with 2 rows",
        ),
    ],
)
def test_errors(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_text_is_refused_as_a_matrix():
    with pytest.raises(TypeError, match="H: expected a matrix"):
        observability(sp.eye(2), "x1")


def test_decimals_are_the_numbers_written():
    assert observability(M([[0.1, 0], [0, 0.1]]), M([[1, 1]])).rank == 1
    assert observability(M([[0.1 + 0.2, 0], [0, 0.3]]), M([[1, 1]])).rank != 0
