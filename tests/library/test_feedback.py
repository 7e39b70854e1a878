"""Gains, fixed modes, regions of gains and observer-based loops, on random exact systems."""

import random

import numpy as np
import pytest
import sympy as sp

from trajlib import feedback, structure
from trajlib.stability import characteristic_polynomial, stability_conditions

lam = sp.Symbol("lambda")


def whole_matrix(rows, columns, seed):
    draw = random.Random(seed)
    return sp.Matrix(rows, columns, lambda i, j: draw.randint(-4, 4))


def with_hidden_part(observable, unobservable, outputs, seed):
    """Return a pair (A, H) with an unobservable part in mixed coordinates, and that block."""
    for trial in range(50):
        A11, A21, A22 = (
            whole_matrix(*shape, seed + 100 * trial + k)
            for k, shape in enumerate(
                [(observable, observable), (unobservable, observable), (unobservable, unobservable)]
            )
        )
        H1, T = (
            whole_matrix(outputs, observable, seed + 7 + trial),
            whole_matrix(observable + unobservable, observable + unobservable, seed + trial),
        )
        if structure.observability(A11, H1) and T.det() != 0:
            A = A11.row_join(sp.zeros(observable, unobservable)).col_join(A21.row_join(A22))
            return T.inv() * A * T, H1.row_join(sp.zeros(outputs, unobservable)) * T, A22
    raise AssertionError("no such system was drawn")


def test_a_double_eigenvalue_is_moved_by_two_outputs_together():
    """Its eigenvectors are a plane, so that no single output, or sum of outputs, observes the pair."""
    T = sp.Matrix([[1, 2, 0], [0, 1, 1], [1, 0, 1]])
    A, H = T.inv() * sp.diag(3, 3, -1) * T, sp.Matrix([[1, 0, 2], [0, 1, 1]])
    family = feedback.observer(A, H, eigenvalues=[-1, -2, -5])
    wanted = sp.expand((lam + 1) * (lam + 2) * (lam + 5))
    assert (A - family.gain * H).charpoly(lam).as_expr() == wanted
    dual = feedback.regulator(A.T, H.T, eigenvalues=[-1, -2, -5])
    assert (A.T + H.T * dual.gain).charpoly(lam).as_expr() == wanted


@pytest.mark.parametrize(
    "observable, unobservable, outputs, seed",
    [
        (3, 0, 1, 1),
        (4, 0, 1, 2),
        (2, 1, 1, 3),
        (2, 2, 1, 4),
        (1, 2, 1, 5),
        (3, 0, 2, 6),
        (3, 1, 2, 7),
        (4, 0, 3, 8),
    ],
)
def test_every_gain_of_a_family_gives_the_polynomial(observable, unobservable, outputs, seed):
    A, H, A22 = with_hidden_part(observable, unobservable, outputs, seed)
    roots = [-1, -2, -2, -5][:observable]
    family = feedback.observer(A, H, eigenvalues=roots)
    wanted = sp.expand(
        sp.prod([family.symbol - r for r in roots]) * A22.charpoly(family.symbol).as_expr()
    )
    assert sp.expand((A - family.gain * H).charpoly(family.symbol).as_expr() - wanted) == 0
    assert sp.expand(family.polynomial - wanted) == 0
    assert len(family.free) == unobservable * outputs and family.gain.free_symbols == set(
        family.free
    )
    dual = feedback.regulator(A.T, H.T, eigenvalues=roots)
    assert sp.expand((A.T + H.T * dual.gain).charpoly(family.symbol).as_expr() - wanted) == 0
    assert family.complete == (outputs == 1)


@pytest.mark.parametrize("observable, unobservable, seed", [(2, 1, 11), (2, 2, 12), (3, 1, 13)])
def test_a_family_for_one_output_is_complete(observable, unobservable, seed):
    """All solutions of the linear equations for the entries of L are members."""
    A, H, _A22 = with_hidden_part(observable, unobservable, 1, seed)
    family = (
        feedback.observer(A, H, degree=1)
        if feedback.best_degree(A, H=H) >= 1
        else feedback.observer(A, H, (lam + 1) ** observable, lam)
    )
    entries = sp.symbols(f"l1:{observable + unobservable + 1}")
    left = sp.Poly(
        (A - sp.Matrix(entries) * H).charpoly(family.symbol).as_expr() - family.polynomial,
        family.symbol,
    )
    (solution,) = sp.linsolve(left.all_coeffs(), entries)
    assert (
        len(set(solution).union(*(e.free_symbols for e in solution)) & set(entries)) == unobservable
    )
    difference = sp.Matrix(solution) - family.gain
    found = sp.solve(list(difference), family.free, dict=True)
    assert found and difference.subs(found[0]).expand() == sp.zeros(observable + unobservable, 1)


def test_coefficients_may_be_symbols_and_so_may_the_system():
    a, b1, b2 = sp.symbols("a beta1 beta2")
    A, B = sp.Matrix([[0, 1], [a, 0]]), sp.Matrix([0, 1])
    family = feedback.regulator(A, B, lam**2 + b1 * lam + b2, lam)
    assert family.gain.expand() == sp.Matrix([[-a - b2, -b1]]) and family.free == ()


def test_a_polynomial_of_full_degree_has_to_keep_the_fixed_factor():
    A, H = sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 1]])
    family = feedback.observer(A, H, (lam + 1) * (lam + 4), lam)
    assert sp.expand(family.polynomial - (lam + 1) * (lam + 4)) == 0 and family.fixed == lam + 1
    with pytest.raises(ValueError, match=r"lambda \+ 1 is fixed"):
        feedback.observer(A, H, (lam + 2) * (lam + 4), lam)
    with pytest.raises(ValueError, match="degree of stability of at most 1"):
        feedback.observer(A, H, degree=2)


def test_an_unstable_fixed_mode_may_stay_but_no_degree_is_given():
    A, H = sp.Matrix([[1, 1], [0, 1]]), sp.Matrix([[0, 1]])
    assert feedback.observer(A, H, eigenvalues=[-3]).fixed == lam - 1
    with pytest.raises(ValueError, match="not detectable"):
        feedback.observer(A, H, degree=0)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({}, "one of the three"),
        ({"degree": 1, "eigenvalues": [-1, -1]}, "one of the three"),
        ({"eigenvalues": [-1]}, "degree 2"),
        ({"eigenvalues": [-1, sp.I]}, "conjugate"),
        ({"polynomial": lam**2 + sp.Symbol("b")}, "say which symbol"),
    ],
)
def test_invalid_prescriptions(arguments, message):
    with pytest.raises(ValueError, match=message):
        feedback.regulator(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), **arguments)


def test_float_arrays_are_refused():
    with pytest.raises(ValueError, match="exact"):
        feedback.regulator(np.eye(2), np.array([[1.0], [2.0]]), degree=1)


@pytest.mark.parametrize(
    "A, B, margin",
    [
        ([[0, 1], [0, -1]], [1, 0], 1),  # example 5
        # example 6
        ([[2, 1, 2, 0], [6, 2, 5, 1], [-4, -1, -4, 0], [1, 0, 1, -1]], [1, 0, -1, 0], 1),
        ([[1, 1], [0, 1]], [1, 0], -1),
        ([[0, 1], [0, 0]], [1, 0], 0),
        ([[0, 1], [1, 0]], [0, 1], sp.oo),
    ],
)
def test_the_best_degree_is_that_of_the_slowest_fixed_mode(A, B, margin):
    A, B = sp.Matrix(A), sp.Matrix(B)
    found = feedback.stabilisability(A, B)
    assert found.degree == margin and bool(found) == (margin > 0)
    for mode in found.modes:
        assert mode.vectors * A == mode.eigenvalue * mode.vectors and mode.vectors * B == sp.zeros(
            mode.vectors.rows, 1
        )
    floats = feedback.stabilisability(np.array(A, dtype=float), np.array(B, dtype=float))
    assert floats.degree == pytest.approx(float(margin)) and (
        margin == 0 or bool(floats) == bool(found)
    )


def test_conjugate_fixed_modes_without_a_closed_form():
    hidden = sp.Matrix([[0, 1, 0], [0, 0, 1], [-3, -1, -1]])  # l^3 + l^2 + l + 3
    found = feedback.stabilisability(sp.diag(2, hidden), sp.Matrix([1, 0, 0, 0]))
    assert not found and len(found.obstacles) == 1
    assert float(found.degree) == pytest.approx(-max(np.roots([1, 1, 1, 3]).real))


def test_unknown_signs_are_refused_with_advice():
    a, p = sp.Symbol("a"), sp.Symbol("p", positive=True)
    with pytest.raises(ValueError, match="assumptions"):
        feedback.stabilisability(sp.diag(1, a), sp.Matrix([1, 0]))
    assert feedback.stabilisability(sp.diag(1, -p), sp.Matrix([1, 0])).degree == p
    with pytest.raises(ValueError, match="B, H"):
        feedback.best_degree(sp.eye(2))


def test_stabilising_gains_satisfy_the_hurwitz_criterion():
    k1, k2, l1, l2 = sp.symbols("k1 k2 l1 l2")
    A, B, H = sp.Matrix([[0, 1], [-2, 3]]), sp.Matrix([0, 1]), sp.Matrix([[1, 1]])
    assert feedback.stabilising_gains(A, B, [k1], H=H).region == (k1 < -3)  # example 7
    assert feedback.stabilising_gains(A, B, [k1], H=sp.Matrix([[1, 0]])).region == sp.false
    full = feedback.stabilising_gains(A, B, [k1, k2], degree=1)
    for point in ([-3, -6], [-30, -6], [-1, -6], [-3, -4]):
        roots = np.linalg.eigvals(np.array(A + B * sp.Matrix([point]), dtype=float))
        assert full.contains(point) == (max(roots.real) < -1)
    errors = feedback.convergent_gains(A, H, [l1, l2])
    assert errors.contains([0, 30]) == (
        max(np.linalg.eigvals(np.array([[0, 1], [-32, -27]])).real) < 0
    )
    with pytest.raises(ValueError, match="expected shape"):
        feedback.stabilising_gains(A, B, [k1])
    with pytest.raises(ValueError, match="expected shape"):
        feedback.convergent_gains(A, H, [l1])


def test_a_structured_gain_of_parameters():
    k, w, V = sp.symbols("k w V", positive=True)
    A = sp.Matrix([[0, V, 0], [0, 0, 1], [0, 0, -1]])
    found = feedback.stabilising_gains(A, sp.Matrix([0, 0, 1]), [[-k, 0, -w]], parameters=[k, w, V])
    assert found.region == sp.false or found.empty  # the angle is not fed back


def test_the_spectrum_of_a_loop_with_an_estimate_separates():
    A, B, H = whole_matrix(3, 3, 5), whole_matrix(3, 1, 6), whole_matrix(1, 3, 9)
    K, L = feedback.regulator(A, B, degree=1).gain, feedback.observer(A, H, degree=2).gain
    loop = feedback.feedback_by_estimate(A, B, H, K, L)
    product = sp.expand(sp.prod(loop.polynomials(lam)))
    assert product == sp.expand((lam + 1) ** 3 * (lam + 2) ** 3)
    for matrix in (loop.errors, loop.estimates):
        assert sp.expand(matrix.charpoly(lam).as_expr() - product) == 0
    # (x; e) and (x; d) are the same motion: e = x - d
    change = sp.Matrix(sp.BlockMatrix([[sp.eye(3), sp.zeros(3)], [sp.eye(3), -sp.eye(3)]]))
    assert change * loop.errors * change.inv() == loop.estimates


def test_a_constant_error_of_the_measurement_is_estimated_too():
    A, B, H = sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([0, 1]), sp.Matrix([[1, 1]])
    K = feedback.regulator(A, B, degree=1).gain
    wide = structure.with_measurement_error(A, sp.Matrix([[1, 0]]), sp.zeros(1), [1])
    L = feedback.observer(*wide, degree=2).gain
    loop = feedback.feedback_by_estimate(A, B, sp.Matrix([[1, 0]]), K, L, S=[[0]], c=[1])
    assert loop.errors.shape == (5, 5) and loop.estimates.shape == (6, 6)
    assert (
        sp.expand(characteristic_polynomial(loop.errors, lam) - (lam + 1) ** 2 * (lam + 2) ** 3)
        == 0
    )
    assert (
        sp.expand(
            characteristic_polynomial(loop.estimates, lam) - lam * (lam + 1) ** 2 * (lam + 2) ** 3
        )
        == 0
    )
    with pytest.raises(ValueError, match="both or neither"):
        feedback.feedback_by_estimate(A, B, H, K, L, S=[[0]])
    with pytest.raises(ValueError, match="L: expected shape"):
        feedback.feedback_by_estimate(A, B, H, K, L)
    with pytest.raises(ValueError, match="K: expected shape"):
        feedback.feedback_by_estimate(A, B, H, [[1]], L)


@pytest.mark.parametrize("n, m, seed", [(2, 1, 21), (3, 1, 22), (3, 2, 23), (4, 2, 24)])
def test_the_error_of_a_reduced_observer_has_the_spectrum(n, m, seed):
    A, B, H = whole_matrix(n, n, seed), whole_matrix(n, 1, seed + 1), whole_matrix(m, n, seed + 2)
    found = feedback.reduced_observer(A, B, H, degree=3)
    assert sp.expand(found.matrix.charpoly(lam).as_expr() - (lam + 3) ** (n - m)) == 0
    # x - (estimate) obeys d' = M d for any x, p and u
    x, p, u = (
        sp.Matrix(sp.symbols(f"x1:{n + 1}")),
        sp.Matrix(sp.symbols(f"p1:{n - m + 1}")),
        sp.Symbol("u"),
    )
    rate = found.matrix * p + found.by_output * H * x + found.by_control * u
    error = found.coordinates * (x - found.state_by_p * p - found.state_by_output * H * x)
    moved = found.coordinates * (
        A * x + B * u - found.state_by_p * rate - found.state_by_output * H * (A * x + B * u)
    )
    assert (moved - found.matrix * error).expand() == sp.zeros(n - m, 1)
    assert (H * (x - found.state_by_p * p - found.state_by_output * H * x)).expand() == sp.zeros(
        m, 1
    )


def test_reduced_observer_needs_unmeasured_states():
    with pytest.raises(ValueError, match="fewer independent outputs"):
        feedback.reduced_observer(sp.eye(2), sp.Matrix([1, 0]), sp.eye(2), degree=1)


def test_display():
    family = feedback.observer(sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 1]]), degree=1)
    assert "lambda" in family._repr_latex_() and family.simplest.free_symbols == set()
    assert (
        "fixed"
        in feedback.detectability(
            sp.Matrix([[0, 1], [1, 0]]), sp.Matrix([[1, 1]])
        )._repr_markdown_()
    )
    assert (
        stability_conditions(
            sp.Matrix([[0, 1], [1, 0]]) - family.simplest * sp.Matrix([[1, 1]]), []
        ).region
        == sp.true
    )


def test_several_fixed_eigenvalues_are_listed_together():
    found = feedback.stabilisability(sp.diag(-1, -2, 3), sp.Matrix([0, 0, 1]))
    assert "lambda = -1, lambda = -2 are fixed" in found.reason and found.degree == 1
    assert (
        r"\mathrm{free}_{1}"
        in feedback.regulator(sp.diag(-1, 3), sp.Matrix([0, 1]), degree=1)._repr_latex_()
    )


def test_the_former_name_of_the_degree_is_refused():
    with pytest.raises(AttributeError, match="^margin is called degree now$"):
        feedback.stabilisability(sp.diag(1, -2), sp.Matrix([1, 0])).margin
