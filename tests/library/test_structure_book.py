"""The systems of chapter 2: ranks computed by hand, decompositions checked by definition."""

import pytest
import sympy as sp

from trajlib.structure import (
    controllability,
    controllability_decomposition,
    controllability_matrix,
    controllable_subspace,
    controller_canonical_form,
    observability,
    observability_decomposition,
    observability_matrix,
    observer_canonical_form,
    unobservable_subspace,
)

M = sp.Matrix
lam = sp.Symbol("lambda")
half = sp.Rational(1, 2)
SWING, OSCILLATOR = M([[0, 1], [1, 0]]), M([[0, 1], [-1, 0]])
THIRD = M([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
SATELLITE = M(
    [
        [0, 0, -1, 1, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [1, 0, 0, 0, 0, 1],
        [-1, 0, 0, 0, 0, -1],
        [0, -1, 0, 0, 0, 0],
        [0, 0, 2, 1, 0, 0],
    ]
)
PLANE = M([[0, -1, 1, 0], [1, 0, 0, 1], [-1, 0, 0, -1], [0, 2, 1, 0]])

# name: (A, H, rank of N)
OBSERVED = {
    "2.1a": (M([[1, 1], [1, -1]]), [[1, 0]], 2),
    "2.1b": (THIRD, [[1, 0, 0]], 3),
    "2.3a": (SWING, [[1, 0]], 2),
    "2.3b": (SWING, [[0, 1]], 2),
    "2.3c": (SWING, [[1, 1]], 1),
    "2.3d": (OSCILLATOR, [[1, 0]], 2),
    "2.3e": (OSCILLATOR, [[0, 1]], 2),
    "2.3f": (OSCILLATOR, [[1, 1]], 2),
    "2.3g": (M([[1, 1], [0, 1]]), [[0, 1]], 1),
    "2.3h": (M([[1, 1], [0, 1]]), [[1, 1]], 2),
    "2.5a": (THIRD, [[1, 0, 0]], 3),
    "2.5b": (THIRD, [[0, 1, 0]], 3),
    "2.5c": (M([[1, 1, 1], [1, 0, 0], [0, 1, 1]]), [[1, 0, 0]], 2),
    "2.5d": (M([[-1, 1, 1], [1, 0, -1], [0, 1, 0]]), [[0, 1, 0]], 2),
    "2.5e": (M([[0, 1, 1], [1, 1, -1], [0, 1, 1]]), [[0, 1, 0]], 2),
    "2.5f": (M([[2, -5, 0], [-1, 3, 0], [1, -2, 1]]), [[1, 1, 0]], 2),
    "2.10": (M([[0, 1, 0], [1, 1, -1], [1, 0, -1]]), [[0, 1, 0]], 2),
    "example 3": (M([[0, 1, 0], [1, 1, 1], [1, 0, 1]]), [[0, 1, 0]], 2),
    "2.11c": (M([[-1, 0, -2], [3, 1, 3], [2, 1, 2]]), [[1, 0, 1]], 2),
    "2.11d": (M([[1, 0, -1], [3, 3, 2], [0, 1, 1]]), [[1, 0, 1]], 2),
    "2.11e": (M([[2, 3, -2], [1, -1, 3], [-1, -2, 2]]), [[1, 0, 1]], 2),
    "2.11f": (M([[-1, -2, 1], [1, 2, 1], [1, 1, -1]]), [[1, 0, 1]], 2),
    "2.11g": (M([[2, 1, -1], [-2, 1, 2], [2, 0, -1]]), [[1, 0, -1]], 2),
    "2.11h": (M([[0, 1, -2], [1, 0, -1], [0, 0, -2]]), [[-1, 1, -1]], 2),
    "2.12a": (M([[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]), [[1, 0, 0, 1]], 3),
    "2.12b": (M([[3, 0, 2, 0], [1, 3, 0, 0], [0, 0, 0, 0], [0, 0, 1, 2]]), [[0, 1, 1, 0]], 3),
    "2.12c": (
        half * M([[1, -1, 1, 1], [-1, 1, 1, 1], [0, 2, 1, -1], [-2, 0, -1, 1]]),
        [[half, half, 0, 0]],
        3,
    ),
    "2.13a": (SATELLITE, [[0, 0, 1, 0, 0, 0]], 3),
    "2.13b": (
        M(
            [
                [0, 1, 1, 0, 0, 0],
                [-1, 0, 0, 1, 0, 0],
                [-1, 0, 0, 1, 0, 0],
                [0, -1, 2, 0, 0, 0],
                [0, 0, 0, 0, 0, 1],
                [0, 0, 0, 0, -1, 0],
            ]
        ),
        [[1, 0, 0, 0, 0, 0]],
        4,
    ),
    "2.14": (PLANE, [[1, 0, 0, 0], [0, 1, 0, 0]], 4),
    "2.15": (
        half * M([[3, 1, -1, 1], [0, 2, 0, 0], [-1, 1, 3, -1], [0, 0, 0, 4]]),
        [[1, 0, 1, 1], [1, 1, -1, 0]],
        4,
    ),
    "2.16a": (M([[-1, 0, 0], [1, 0, 0], [0, 0, 0]]), [[1, 0, 1]], 2),
    "2.16b": (M([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]), [[0, 1, 1]], 3),
    "nothing measured": (SWING, [[0, 0]], 0),
}
SIX = M([[0, 1, 1], [1, 1, 0], [0, -1, -1]])
TWO = M([[-2, 1, -2], [-2, 2, -1], [1, 0, 2]])
E_32 = M([[-3, 2, 1, 2], [-6, 3, 5, 4], [-4, 2, 2, 3], [-1, 0, 1, 0]])
F_32 = M([[-3, -2, 1, 2], [-6, 3, 5, 4], [-4, 2, 2, 3], [-1, 0, 1, 0]])
SEVEN = M([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 2, 1], [0, 0, 0, 2]])
# name: (A, B, rank of W)
CONTROLLED = {
    "2.18": (SWING, [0, 1], 2),
    "2.19": (M([[0, 1, 1], [1, 1, 0], [0, 1, -1]]), [1, 0, 0], 3),
    "2.22": (M([[1, 1], [-3, 1]]), [0, 1], 2),
    "2.28": (M([[1, 1], [2, 0]]), [1, 1], 1),
    "2.29": (M([[0, 1], [2, 1]]), [1, 2], 1),
    "2.30a": (M([[2, 1, 1], [3, 1, 1], [0, -1, 1]]), [0, 1, 0], 2),
    "2.30b": (M([[-1, 1, 0], [1, 0, 1], [1, -1, 0]]), [0, 1, 0], 2),
    "2.30c": (M([[0, 1, 0], [1, 1, 1], [1, -1, 1]]), [0, 1, 0], 2),
    "2.30d": (TWO, [1, 1, 0], 2),
    "2.30e": (M([[1, 1, 1], [0, 2, 0], [0, 0, 1]]), [0, 0, 1], 2),
    "2.30f": (M([[2, -1, 1], [-5, 3, -2], [0, 0, 1]]), [1, 1, 0], 2),
    "2.30g": (M([[0, 0, 1], [1, 1, -1], [1, 1, 1]]), [0, 0, 1], 2),
    "2.30h": (M([[-1, 0, -3], [-2, 2, -1], [1, 0, 4]]), [1, 1, 0], 2),
    "2.30i": (M([[-3, 2, -2], [1, -1, 0], [3, -2, 1]]), [1, 1, 0], 2),
    "example 6": (SIX, [0, 1, 0], 2),
    "2.32a": (M([[2, 0, 0, 0], [1, 2, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]), [1, 0, 0, 1], 3),
    "2.32b": (M([[3, 1, 0, 0], [0, 3, 0, 0], [0, 0, 2, 1], [0, 0, 0, 2]]), [0, 1, 1, 0], 3),
    "2.32c": (M([[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]), [0, 1, 1, 0], 3),
    "2.32d": (M([[2, 1, 0, 0], [1, -1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]), [0, 1, 1, 0], 3),
    "2.32e": (E_32, [1, 1, 1, 0], 2),
    "2.32f": (F_32, [1, 1, 1, 0], 4),
    "example 7": (SEVEN, [[1, 0], [0, 1], [0, 1], [1, 0]], 4),
    "2.33": (
        M([[1, -1, 0, 0], [0, 1, 0, 0], [0, 0, 2, -1], [0, 0, 0, 2]]),
        [[1, 0], [0, 1], [0, 1], [1, 0]],
        4,
    ),
    "2.34": (
        half * M([[0, 2, 2, 0], [1, 3, -1, 0], [1, 1, 1, 0], [2, -2, 2, 2]]),
        half * M([[0, 0], [1, 1], [1, 1], [0, 2]]),
        3,
    ),
    "nothing steered": (SWING, [0, 0], 0),
}


@pytest.mark.parametrize("name", OBSERVED)
def test_observability_of_the_examples(name):
    A, H, known = OBSERVED[name]
    H, n = M(H), A.rows
    N = observability_matrix(A, H)
    rank = N.rank()
    assert rank == known
    found = observability(A, H)
    assert (found.holds, found.rank, found.order, bool(found)) == (rank == n, rank, n, rank == n)

    subspace = unobservable_subspace(A, H)
    assert (
        subspace.shape == (n, n - rank)
        and subspace.rank() == n - rank
        and (N * subspace).is_zero_matrix
    )

    split = observability_decomposition(A, H)
    T, k = split.transformation, rank
    assert split.sizes == (k, n - k) and T.det() != 0 and split.basis * T == sp.eye(n)
    assert (split.matrix * T - T * A).is_zero_matrix and (split.outputs * T - H).is_zero_matrix
    assert split.matrix[:k, k:].is_zero_matrix and split.outputs[:, k:].is_zero_matrix
    if not k:
        return
    A11, H1 = split.part
    assert observability_matrix(A11, H1).rank() == k
    for i in range(2 * n):
        assert H1 * A11**i * T[:k, :] == H * A**i
    whole, hidden = (
        (m.charpoly(lam).as_expr() for m in (A, split.complement))
        if k < n
        else (A.charpoly(lam).as_expr(), sp.Integer(1))
    )
    assert sp.expand(A11.charpoly(lam).as_expr() * hidden - whole) == 0
    if H.rows == 1:
        assert T[:k, :] == N[:k, :]

    roots = {m.eigenvalue for m in found.hidden_modes}
    assert roots == set(sp.roots(sp.Poly(hidden, lam)))
    for mode in found.hidden_modes:
        v = mode.vectors
        assert (
            v.rank() == v.cols > 0
            and (A * v - mode.eigenvalue * v).expand().is_zero_matrix
            and (H * v).expand().is_zero_matrix
        )


@pytest.mark.parametrize("name", CONTROLLED)
def test_controllability_of_the_examples(name):
    A, B, known = CONTROLLED[name]
    B, n = M(B), A.rows
    W = controllability_matrix(A, B)
    rank = W.rank()
    assert rank == known
    found = controllability(A, B)
    assert (found.holds, found.rank, found.order) == (rank == n, rank, n)

    reached = controllable_subspace(A, B)
    assert (
        reached.shape == (n, rank) and sp.Matrix.hstack(reached, W).rank() == rank == reached.rank()
    )

    split = controllability_decomposition(A, B)
    P, k = split.basis, rank
    assert split.sizes == (k, n - k) and P * split.transformation == sp.eye(n)
    assert (P * split.matrix - A * P).is_zero_matrix and (P * split.inputs - B).is_zero_matrix
    assert split.matrix[k:, :k].is_zero_matrix and split.inputs[k:, :].is_zero_matrix
    if not k:
        return
    A11, B1 = split.part
    assert controllability_matrix(A11, B1).rank() == k
    if B.cols == 1:
        assert P[:, :k] == W[:, :k]
    for mode in found.hidden_modes:
        w = mode.vectors
        assert (
            w.rank() == w.rows > 0
            and (w * A - mode.eigenvalue * w).expand().is_zero_matrix
            and (w * B).expand().is_zero_matrix
        )
    assert {m.eigenvalue for m in found.hidden_modes} == (
        set(split.complement.eigenvals()) if k < n else set()
    )


@pytest.mark.parametrize(
    "name",
    [
        name
        for name, (A, H, _) in OBSERVED.items()
        if len(H) == 1 and observability_matrix(A, H).rank() == A.rows
    ],
)
def test_observer_canonical_form(name):
    A, h, _ = OBSERVED[name]
    n = A.rows
    found = observer_canonical_form(A, M(h))
    alphas = [-c for c in A.charpoly(lam).all_coeffs()[1:]]
    assert found.matrix == M(n, n, lambda i, j: alphas[i] if j == 0 else int(j == i + 1))
    assert found.vector == sp.eye(n)[0, :]
    assert (
        found.matrix * found.transformation == found.transformation * A
        and found.vector * found.transformation == M(h)
    )
    assert sp.expand(found.polynomial - A.charpoly(lam).as_expr()) == 0
    # The pair is observable, so no other T does this.
    assert found.transformation == observability_matrix(
        found.matrix, found.vector
    ).inv() * observability_matrix(A, h)


@pytest.mark.parametrize("name", ["2.18", "2.19", "2.22", "2.32f"])
def test_controller_canonical_form(name):
    A, b, _ = CONTROLLED[name]
    n = A.rows
    found = controller_canonical_form(A, M(b))
    alphas = [-c for c in A.charpoly(lam).all_coeffs()[:0:-1]]
    assert found.matrix == M(n, n, lambda i, j: alphas[j] if i == n - 1 else int(j == i + 1))
    assert found.vector == sp.eye(n)[:, n - 1]
    assert found.basis * found.matrix == A * found.basis and found.basis * found.vector == M(b)


def test_bases_of_the_examples():
    A, H, _ = OBSERVED["example 3"]
    found = observability_decomposition(A, H)
    assert found.transformation == M([[0, 1, 0], [1, 1, 1], [1, 0, -1]])
    assert found.matrix == M([[0, 1, 0], [0, 2, 0], [2, -1, 0]])
    found = controllability_decomposition(SIX, [0, 1, 0])
    assert found.basis == M([[0, 1, 1], [1, 1, 0], [0, -1, 1]]) and found.matrix == M(
        [[0, 2, 0], [1, 0, 1], [0, 0, 0]]
    )
    assert found.inputs == M([1, 0, 0])


def test_parameters_in_canonical_forms():
    alpha, beta = sp.symbols("alpha beta")
    # Problem 2.2: possible unless alpha = 2, where det N vanishes.
    A, h = M([[0, 1], [alpha, 1]]), M([[1, 1]])
    found = observer_canonical_form(A, h)
    assert found.matrix == M([[1, 1], [alpha, 0]]) and found.vector == M([[1, 0]])
    assert (found.transformation * A - found.matrix * found.transformation).expand().is_zero_matrix
    assert sp.expand(found.transformation.det() - (2 - alpha)) == 0
    # Problem 2.21: possible unless beta = 1 or beta = 1/2.
    A, b = M([[1, -2], [4, -5]]), M([beta, 1])
    found = controller_canonical_form(A, b)
    assert found.matrix == M([[0, 1], [-3, -4]])
    assert (found.basis * found.matrix - A * found.basis).applyfunc(sp.cancel).is_zero_matrix
    assert sp.solve(found.basis.det(), beta) == [sp.Rational(1, 2), 1]
