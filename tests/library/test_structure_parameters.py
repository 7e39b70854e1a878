"""Parameters for which the rank is full, and the lower ranks elsewhere."""

import itertools

import pytest
import sympy as sp

from trajlib.structure import (
    controllability_conditions,
    controllability_matrix,
    controllable_subspace,
    first_order_form,
    observability,
    observability_conditions,
    observability_decomposition,
    observability_matrix,
    unobservable_subspace,
    with_measurement_error,
)

M, Ne, Eq, And = sp.Matrix, sp.Ne, sp.Eq, sp.And
a, b, k, w, h, l1, l2 = sp.symbols("alpha beta k omega h l1 l2")
Omega, r0 = sp.symbols("Omega r0", positive=True)
half = sp.Rational(1, 2)


def orbit(Omega, r0):
    return M(
        [
            [0, 0, 1, 0],
            [0, 0, 0, 1],
            [0, 0, 0, -2 * Omega / r0],
            [0, 3 * Omega**2, 2 * Omega * r0, 0],
        ]
    )


OBSERVED = [
    ("2.2", M([[0, 1], [a, 1]]), [[1, 1]], [a], Ne(a, 2), {(Eq(a, 2), 1)}),
    ("2.3i", sp.eye(2), [[1, a]], [a], sp.false, {(sp.true, 1)}),
    ("2.4a", M([[0, 1], [-b, -a]]), [[1, 1]], [a, b], Ne(a, b + 1), {(Eq(a, b + 1), 1)}),
    (
        "2.4b",
        M([[0, 1], [-2, -3]]),
        [[h, 1]],
        [h],
        Ne(h, 1) & Ne(h, 2),
        {(Eq(h, 1), 1), (Eq(h, 2), 1)},
    ),
    (
        "2.5g",
        M([[1, -1, 1], [1, 1, -1], [2, -1, 0]]),
        [[1, 0, a]],
        [a],
        Ne(a, -1) & Ne(a, sp.Rational(1, 5)),
        {(Eq(a, -1), 1), (Eq(a, sp.Rational(1, 5)), 2)},
    ),
    (
        "2.5h",
        M([[-1, 1, -2], [4, 1, 0], [2, 1, -1]]),
        [[0, 1, a]],
        [a],
        Ne(a, -2),
        {(Eq(a, -2), 1)},
    ),
    (
        "2.5i",
        M([[2, -1, -1], [3, -2, -3], [-1, 1, 2]]),
        [[1, 0, 0], [0, 1, a]],
        [a],
        Ne(a, 1),
        {(Eq(a, 1), 2)},
    ),
    (
        "2.5j",
        M([[3, -2, -1], [3, -4, -3], [2, -4, 0]]),
        [[1, 0, a], [0, 1, 0]],
        [a],
        Ne(a, -1),
        {(Eq(a, -1), 2)},
    ),
    ("2.6a", orbit(Omega, r0), [[1, 0, 0, 0]], [Omega, r0], sp.true, set()),
    ("2.6b", orbit(Omega, r0), [[0, 1, 0, 0]], [Omega, r0], sp.false, {(sp.true, 3)}),
    ("2.6d", orbit(Omega, r0), [[0, 0, 0, 1]], [Omega, r0], sp.false, {(sp.true, 2)}),
    ("2.6e", orbit(Omega, r0), [[1, 1, 0, 0]], [Omega, r0], sp.true, set()),
    (
        "2.6e without signs",
        orbit(w, k),
        [[1, 1, 0, 0]],
        [w, k],
        Ne(w, 0) & Ne(k, 0),
        {(Eq(w, 0), 2)},
    ),
    ("2.8", sp.diag(l1, l2), [[1, 1]], [l1, l2], Ne(l1, l2), {(Eq(l1, l2), 1)}),
    (
        "2.16c",
        *with_measurement_error(M([[-3, -2], [1, 0]]), M([[1, 0]]), M([[a]]), [1]),
        [a],
        Ne(a, -1) & Ne(a, -2),
        {(Eq(a, -1), 2), (Eq(a, -2), 2)},
    ),
    (
        "2.16d",
        *with_measurement_error(M([[0, 1], [-1, 0]]), M([[1, 0]]), M([[0, w], [-w, 0]]), [1, 0]),
        [w],
        Ne(w, 0) & Ne(w, 1) & Ne(w, -1),
        {(Eq(w, 0), 3), (Eq(w, 1), 2), (Eq(w, -1), 2)},
    ),
    ("2.27", M([[-1, -1], [0, -2]]), [[1, a]], [a, b], Ne(a, -1), {(Eq(a, -1), 1)}),
    (
        "several lines through a point",
        sp.zeros(2),
        [[a, b], [b, a]],
        [a, b],
        Ne(a, b) & Ne(a, -b),
        {(Eq(a, b), 1), (Eq(a, -b), 1), (Eq(a, 0) & Eq(b, 0), 0)},
    ),
    ("hyperbola", M([[0, 1], [a * b, 1]]), [[1, 1]], [a, b], Ne(a * b, 2), {(Eq(a * b, 2), 1)}),
    (
        "hyperbola that passes a zero slope",
        sp.zeros(2),
        [[1, k], [a, b]],
        [a, b, k],
        Ne(b, a * k),
        {(Eq(b, a * k), 1)},
    ),
    (
        "circle",
        M([[0, 1], [a**2 + b**2 - 1, 0]]),
        [[0, 1]],
        [a, b],
        Ne(a**2 + b**2, 1),
        {(Eq(a**2 + b**2, 1), 1)},
    ),
    (
        "a point of the plane",
        M([[0, 1], [0, 0]]),
        [[a**2 + b**2, 0]],
        [a, b],
        Ne(a, 0) | Ne(b, 0),
        {(Eq(a, 0) & Eq(b, 0), 0)},
    ),
    ("no real zero", M([[0, 1], [a**2 - a * b + b**2 + 1, 0]]), [[0, 1]], [a, b], sp.true, set()),
    (
        "no closed form",
        M([[0, 1], [a**3 - a + 1, 0]]),
        [[0, 1]],
        [a],
        Ne(a**3 + 1, a),
        {(Eq(a**3 + 1, a), 1)},
    ),
    (
        "points of a circle",
        sp.zeros(2),
        [[a**2 + b**2 - 1, 0], [0, a**2 - b**2]],
        [a, b],
        Ne(a**2 + b**2, 1) & Ne(a, b) & Ne(a, -b),
        None,
    ),
    (
        "all entries unknown",
        M([[l1, l2], [a, b]]),
        [[h, k]],
        [l1, l2, a, b, h, k],
        Ne(l1 * h * k + a * k**2, l2 * h**2 + b * h * k),
        None,
    ),
    (
        "a denominator is not zero",
        orbit(w, k),
        [[0, 0, 0, 1], [1, 0, 0, 0]],
        [w, k],
        Ne(w, 0) & Ne(k, 0),
        {(Eq(w, 0), 3)},
    ),
    (
        "square roots",
        M([[0, 1], [a**2 - 2, 0]]),
        [[0, 1]],
        [a],
        Ne(a, sp.sqrt(2)) & Ne(a, -sp.sqrt(2)),
        {(Eq(a, sp.sqrt(2)), 1), (Eq(a, -sp.sqrt(2)), 1)},
    ),
    ("no parameter in it", M([[0, 1], [1, 0]]), [[1, 1]], [a], sp.false, {(sp.true, 1)}),
]


@pytest.mark.parametrize(
    "A, H, parameters, region, exceptions",
    [case[1:] for case in OBSERVED],
    ids=[case[0] for case in OBSERVED],
)
def test_observability_conditions(A, H, parameters, region, exceptions):
    found = observability_conditions(A, M(H), parameters)
    assert found.region == region and exceptions in (None, set(found.exceptions))
    dual = controllability_conditions(A.T, M(H).T, parameters)
    assert dual == found


CONTROLLED = [
    ("2.20", M([[1, a], [-3, -2]]), [1, 1], a),
    ("2.21", M([[1, -2], [4, -5]]), [b, 1], b),
    ("2.24a", M([[0, -1, 1], [0, 0, 1], [-1, 0, 1]]), [a, 1, 1], a),
    ("2.24b", M([[1, -2, -1], [-1, 1, 1], [1, 0, -1]]), [1, 0, a], a),
    ("2.24c", M([[2, 1, 0], [0, 2, 4], [1, 0, -1]]), [1, a, 0], a),
    ("2.24d", M([[2, -1, 2], [1, 0, 2], [-2, 1, -1]]), [1, 1, a], a),
    ("2.25a", M([[4, -1, -1], [1, 2, -1], [1, -1, 2]]), [[1, 0], [0, 1], [a, 0]], a),
    ("2.25b", M([[0, 1, 0], [-4, 4, 0], [-2, 1, 2]]), [[1, 0], [0, 1], [1, a]], a),
    (
        "2.26d",
        *first_order_form(M([[1, 1], [1, 2]]), sp.zeros(2), M([[1, 1], [3, b]]), M([1, 3]))[:2],
        b,
    ),
    ("2.27", M([[-1, -1], [0, -2]]), [1, b], b),
]


@pytest.mark.parametrize(
    "A, B, parameter", [case[1:] for case in CONTROLLED], ids=[case[0] for case in CONTROLLED]
)
def test_controllability_conditions_agree_with_ranks_at_values(A, B, parameter):
    found = controllability_conditions(A, M(B), [parameter])
    special = {where.rhs: rank for where, rank in found.exceptions if where is not sp.true}
    for value in {*special, *range(-5, 6), half, sp.Rational(7, 3)}:
        rank = controllability_matrix(A, M(B)).subs(parameter, value).rank()
        assert bool(found.region.subs(parameter, value)) == (rank == A.rows)
        assert rank == special.get(
            value, A.rows if found.region is not sp.false else dict(found.exceptions)[sp.true]
        )


def test_pendulums_on_a_cart_2_35():
    L1, L2, g = sp.symbols("l1 l2 g", positive=True)
    A, B, _ = first_order_form(sp.diag(L1, L2), sp.zeros(2), -g * sp.eye(2), M([-1, -1]))
    found = controllability_conditions(A, B, [L1, L2, g])
    assert found.region == Ne(L1, L2) and found.exceptions == ((Eq(L1, L2), 2),)


def test_ranks_on_a_grid():
    """The rank at every grid point is that of the smallest piece that contains the point."""
    x, y, z = sp.symbols("x y z")
    A, H = sp.diag(x, y, z), M([[1, 1, x]])
    found = observability_conditions(A, H, [x, y, z])
    for point in itertools.product((-1, 0, 1), repeat=3):
        values = dict(zip((x, y, z), point))
        rank = observability_matrix(A, H).subs(values).rank()
        lowest = min([3, *(r for where, r in found.exceptions if where.subs(values) == sp.true)])
        assert lowest == rank and (found.region.subs(values) == sp.true) == (rank == 3)


RATIONAL = [
    (M([[0, 1 / a], [0, 0]]), [[1, 0]], Eq(a, 0)),
    (M([[1 / a, 1], [0, a]]).T, [[1, 1]], Eq(a, 0)),
    (M([[1 / (a - 1), 0], [1, b / (a + b)]]), [[1, 1 / b]], Eq(a, 1) | Eq(b, 0) | Eq(a, -b)),
    (M([[0, 1], [a**2 + b**2 - 1, 0]]), [[0, 1 / (a**2 + b**2 + 1)]], sp.false),
    (M([[0, 1 / (a**2 + b**2 - 1)], [b, a]]), [[1, b / a]], Eq(a, 0) | Eq(a**2 + b**2, 1)),
]


@pytest.mark.parametrize("A, H, undefined", RATIONAL)
def test_values_with_undefined_entries_are_excluded_and_named(A, H, undefined):
    found, N = observability_conditions(A, M(H), [a, b]), observability_matrix(A, M(H))
    below = [sp.denom(sp.together(entry)) for entry in (*A, *M(H))]
    for values in itertools.product([-2, -1, -half, 0, half, 1, sp.Rational(3, 2), 2], repeat=2):
        point = dict(zip((a, b), values))
        nowhere = any(entry.subs(point) == 0 for entry in below)
        assert (found.undefined.subs(point) == sp.true) == nowhere
        if nowhere:
            assert found.region.subs(point) == sp.false
            continue
        rank = N.subs(point).rank()
        lowest = min([2, *(r for where, r in found.exceptions if where.subs(point) == sp.true)])
        assert lowest == rank and (found.region.subs(point) == sp.true) == (rank == 2)
    assert sp.simplify_logic(sp.Equivalent(found.undefined, undefined)) == sp.true


def test_assumptions_are_used_and_symbols_restored():
    p = sp.Symbol("p", positive=True)
    found = observability_conditions(M([[0, 1], [p + 1, 0]]), M([[p, 1 - p]]), [p])
    assert found.region.free_symbols <= {p}
    assert observability_conditions(M([[0, 1], [0, 0]]), M([[p, 0]]), [p]).region is sp.true
    assert observability_conditions(M([[0, 1], [0, 0]]), M([[a, 0]]), [a]).region == Ne(a, 0)


def test_minors_and_display():
    found = observability_conditions(M([[0, 1], [-2, -3]]), M([[h, 1]]), [h])
    assert [sp.expand(m - (h - 1) * (h - 2)) for m in found.minors] == [0]
    assert r"\neq" in found._repr_latex_()
    assert "varnothing" in observability_conditions(sp.eye(2), M([[1, a]]), [a])._repr_latex_()
    assert (
        "all values"
        in observability_conditions(M([[0, 1], [0, 0]]), M([[1, a]]), [a])._repr_latex_()
    )


def test_errors():
    with pytest.raises(ValueError, match="parameters: the system also has beta"):
        observability_conditions(M([[0, 1], [b, a]]), M([[1, 0]]), [a])
    with pytest.raises(ValueError, match="H: expected a matrix with 2 columns"):
        observability_conditions(M([[0, 1], [b, a]]), M([[1, 0, 0]]), [a, b])
    with pytest.raises(TypeError, match="parameters"):
        observability_conditions(M([[0, 1], [b, a]]), M([[1, 0]]), "alpha")
    with pytest.raises(ValueError, match=r"cos\(alpha\)"):
        observability_conditions(M([[0, 1], [0, sp.sin(a)]]), M([[1, sp.cos(a)]]), [a])
    with pytest.raises(
        ValueError, match=r"sqrt\(alpha\) stands in the system.*put a symbol for it"
    ):
        observability_conditions(M([[0, sp.sqrt(a)], [0, a]]), M([[1, 0]]), [a])
    # A curve on which no parameter can be eliminated, with points of lower rank on it: said, not
    # guessed.
    with pytest.raises(NotImplementedError, match="beyond the methods"):
        observability_conditions(sp.zeros(2), M([[a**2 + b**2 - 1, 0], [0, a**2 - b**3]]), [a, b])


@pytest.mark.slow
def test_systems_with_many_symbols_are_decided_or_refused_at_once():
    A, H = M(4, 4, lambda i, j: sp.Symbol(f"a{i}{j}")), M(1, 4, lambda i, j: sp.Symbol(f"h{j}"))
    assert observability(A, H).holds
    assert unobservable_subspace(A, H).shape == (4, 0) and controllable_subspace(
        A.T, H.T
    ).shape == (4, 4)
    for row in (H, M([[1, 0, 0, 0]])):
        with pytest.raises(NotImplementedError, match="give some of the symbols values"):
            observability_decomposition(A, row)
    for n in (3, 4):
        inner, row = A[:n, :n], H[:, :n]
        with pytest.raises(NotImplementedError, match="give some of the parameters values"):
            observability_conditions(
                inner, row, sorted(inner.free_symbols | row.free_symbols, key=str)
            )
