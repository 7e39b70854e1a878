"""Types of planar equilibria and the Bendixson-Dulac test: problems 1.4, 1.6, 1.8, 1.11."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import classify_planar, dulac

M = sp.Matrix
x, y = sp.symbols("x y")
e, k = sp.symbols("epsilon k", real=True)
b, u, Om, p, q = sp.symbols("b u Omega p q", positive=True)


@pytest.mark.parametrize(
    "rows, kind",
    [
        ([[-1, 0], [0, -3]], "stable node"),
        ([[1, 0], [0, 3]], "unstable node"),
        ([[0, 1], [-2, -1]], "stable focus"),
        ([[0, 1], [-2, 1]], "unstable focus"),
        ([[1, 0], [0, -1]], "saddle"),
        ([[0, 1], [-1, 0]], "centre"),
        ([[-1, 1], [0, -1]], "stable degenerate node"),
        ([[2, 0], [0, 2]], "unstable star"),
        ([[-1, 0], [0, 0]], "stable line of equilibria"),
        ([[0, 1], [0, 1]], "unstable line of equilibria"),
        ([[0, 1], [0, 0]], "line of equilibria with drift"),
        ([[0, 0], [0, 0]], "plane of equilibria"),
        ([[0, 2], [-sp.E, -sp.E]], "stable focus"),
    ],
)
def test_numeric_matrices(rows, kind):
    assert classify_planar(M(rows)) == kind


def test_van_der_pol_1_4():
    rows = {kind: condition for condition, kind in classify_planar(M([[0, 1], [-1, e]]))}
    assert rows == {
        "stable node": e < -2,
        "stable degenerate node": sp.Eq(e, -2),
        "stable focus": sp.And(e > -2, e < 0),
        "centre": sp.Eq(e, 0),
        "unstable focus": sp.And(e > 0, e < 2),
        "unstable degenerate node": sp.Eq(e, 2),
        "unstable node": e > 2,
    }


def test_pursuit_1_11():
    s = sp.sqrt(1 - b**2)
    rows = {
        kind: condition
        for condition, kind in classify_planar(M([[0, -s], [u**2 / s, b * u / s * u / u]]))
    }
    border = 2 * sp.sqrt(5) / 5
    assert rows == {
        "unstable focus": b < border,
        "unstable degenerate node": sp.Eq(b, border),
        "unstable node": sp.And(b > border, b < 1),
    }


def test_approach_1_6():
    rows = {
        kind: condition
        for condition, kind in classify_planar(
            M([[0, 1], [3 * Om**2 * sp.sqrt(1 - 16 * k**2 / 9), -2 * k * Om]])
        )
    }
    three_quarters = sp.Rational(3, 4)
    assert rows["saddle"] == sp.And(k > -three_quarters, k < three_quarters)
    assert set(rows) == {"saddle", "stable line of equilibria", "unstable line of equilibria"}


def test_worked_example_2():
    rows = {kind: condition for condition, kind in classify_planar(M([[0, 1], [-2 * b, -u]]))}
    assert rows == {
        "stable node": 8 * b < u**2,
        "stable focus": 8 * b > u**2,
        "stable degenerate node": sp.Eq(8 * b, u**2),
    }


@pytest.mark.slow
def test_the_table_covers_the_parameters_once():
    """Of the general matrix, at points of all kinds."""
    entries = sp.symbols("a11 a12 a21 a22", real=True)
    table = classify_planar(M(2, 2, entries))
    random = np.random.default_rng(3)
    samples = [tuple(map(int, row)) for row in random.integers(-2, 3, size=(150, 4))]
    for values in samples:
        point = dict(zip(entries, values))
        kinds = [kind for condition, kind in table if condition.subs(point) is sp.true]
        assert kinds == [classify_planar(M(2, 2, values))]


@settings(max_examples=80, deadline=None)
@given(st.lists(st.integers(-6, 6), min_size=4, max_size=4))
def test_against_eigenvalues(entries):
    A = np.array(entries, dtype=float).reshape(2, 2)
    first, second = np.linalg.eigvals(A)
    kind = classify_planar(M(2, 2, entries))
    if min(abs(first.real), abs(second.real)) > 1e-6 and abs(first - second) > 1e-6:
        if first.real * second.real < 0:
            assert kind == "saddle"
        else:
            shape = "focus" if abs(first.imag) > 1e-9 else "node"
            assert kind == f"{'stable' if first.real < 0 else 'unstable'} {shape}"
        assert classify_planar(A) == kind


def test_floats_on_a_border_are_refused():
    for matrix in ([[0, 1], [-1, 0]], [[-1, 0], [0, -1]], [[0, 1], [0, -1]]):
        with pytest.raises(ValueError, match="within rounding"):
            classify_planar(np.array(matrix, dtype=float))


def test_dulac_test_excludes_cycles_in_1_11():
    rho, beta = sp.Symbol("rho", positive=True), sp.Symbol("beta", real=True)
    field = [b - sp.cos(beta), sp.sin(beta) / rho + u]
    test = dulac(field, [rho, beta], multiplier=rho)
    assert (test.divergence, test.sign, test.excludes_cycles) == (b, "positive", True)
    plain = dulac(field, [rho, beta])
    assert sp.simplify(plain.divergence - sp.cos(beta) / rho) == 0 and plain.excludes_cycles is None


@pytest.mark.parametrize(
    "field, region, sign, excludes",
    [
        ([y, -x - y], None, "negative", True),
        ([y, -x], None, "zero", None),
        ([y, -x + (1 - x**2) * y], None, "changes", None),
        ([y, -x + (1 - x**2) * y], sp.And(x < 1, x > -1), "nonnegative", True),
        ([y, -x + (1 - x**2) * y], sp.And(x > 1), "nonpositive", True),
        ([y, -x + e * (1 - x**2) * y], sp.And(x < 1, x > -1), "changes", None),
        ([x - x**3, -(y**3)], None, "changes", None),
        ([-(x**3), -(y**3) + x], None, "nonpositive", True),
        ([sp.sin(x) + y, 0 * x], None, None, None),
    ],
)
def test_dulac_signs(field, region, sign, excludes):
    found = dulac(field, [x, y], region=region)
    assert (found.sign, found.excludes_cycles) == (sign, excludes)


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: classify_planar(sp.eye(3)), "2 x 2"),
        (lambda: classify_planar(np.eye(3)), "2 x 2"),
        (lambda: dulac([x], [x]), "planar"),
        (lambda: dulac([x, y], [x, y], region=sp.Eq(x, 1)), "region"),
    ],
)
def test_errors_name_the_argument(call, named):
    with pytest.raises(ValueError, match=named):
        call()


def test_undecidable_roots_of_parameters_are_refused_with_advice():
    g, k, P = sp.symbols("g k P", positive=True)
    speed = sp.sqrt((P - g) / k)
    with pytest.raises(
        ValueError, match="A: cannot decide where .* put a positive symbol in the place of the root"
    ):
        classify_planar(sp.diag(g / speed, -2 * k * speed))
    assert classify_planar(sp.diag(-sp.sqrt(2), -2 * sp.sqrt(2))) == "stable node"
