"""Quadratic regulators against python-control, Kleinman's equation and integration."""

import sys
from pathlib import Path

import control
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_lyapunov

import trajlib
from trajlib import feedback

A = sp.Matrix([[0, 1, 0], [1, 0, 2], [0, -1, 1]])
B = sp.Matrix([[0, 0], [1, 0], [0, 1]])
G, N, F = sp.diag(2, 0, 1), sp.Matrix([[2, 1], [1, 3]]), sp.diag(1, 0, 2)
MODES = {"-1": True, "0": False, "1": True}


def floats(*matrices):
    return [np.array(matrix, dtype=float) for matrix in matrices]


def test_python_control_has_the_same_cost_and_the_other_sign():
    ours = feedback.lqr(*floats(A, B, G, N))
    gain, cost, roots = control.lqr(*floats(A, B, G, N), method="scipy")
    np.testing.assert_allclose(ours.gain, -gain, atol=1e-10)
    np.testing.assert_allclose(ours.cost, cost, atol=1e-10)
    np.testing.assert_allclose(
        sorted(np.linalg.eigvals(ours.loop), key=np.real), sorted(roots, key=np.real), atol=1e-8
    )


@pytest.mark.parametrize(
    "matrix, weight",
    [
        ([[0, 1], [1, 0]], sp.diag(0, 1)),
        ([[0, 1], [0, 1]], sp.eye(2)),
        ([[0, 1], [-1, 0]], sp.diag(3, 0)),
        ([[1, 0], [1, 2]], sp.zeros(2)),
    ],
)
def test_exact_and_floating_point_agree(matrix, weight):
    exact = feedback.lqr(matrix, [0, 1] if matrix[0][0] == 0 else [1, 0], weight, 1)
    near = feedback.lqr(
        *floats(matrix, [[0], [1]] if matrix[0][0] == 0 else [[1], [0]], weight, [[1]])
    )
    for name in ("cost", "gain", "loop"):
        np.testing.assert_allclose(*floats(getattr(exact, name), getattr(near, name)), atol=1e-9)


@pytest.mark.parametrize("mode, attained", MODES.items())
def test_mode_unobservable_in_the_cost_is_stabilised_or_left_alone(mode, attained):
    """x1' = mode x1 + u, x2' = -x2 + u, and the cost contains x2 only."""
    for read in (lambda m: m, lambda m: np.array(m, dtype=float)):
        system = [
            read(m)
            for m in (sp.diag(int(mode), -1), sp.Matrix([1, 1]), sp.diag(0, 1), sp.Matrix([[1]]))
        ]
        best, lazy = feedback.lqr(*system), feedback.lqr(*system, stable=False)
        assert bool(best) == attained and lazy
        assert abs(float(lazy.gain[0, 0])) < 1e-12 and abs(float(lazy.cost[0, 0])) < 1e-12
        difference = np.array(best.cost - lazy.cost, dtype=float) if best else None
        if mode == "-1":
            np.testing.assert_allclose(difference, 0, atol=1e-12)
        elif mode == "1":  # the stabilising solution is the greater one
            assert np.linalg.eigvalsh(difference)[0] > -1e-12 and difference[0, 0] > 1


def test_a_law_is_shown_and_where_there_is_none_the_reason():
    law, none = feedback.lqr(1, 1, 0, 1), feedback.lqr(sp.diag(1, 2), [0, 1], sp.eye(2), 1)
    assert "S = " in law._repr_markdown_() and law.reason not in law._repr_markdown_()
    assert "not stabilisable" in none._repr_markdown_() and "$" not in none._repr_markdown_()


def test_unsolvable_problems_have_a_reason():
    assert "not stabilisable" in feedback.lqr(sp.diag(1, 2), [0, 1], sp.eye(2), 1).reason
    assert "imaginary axis" in feedback.lqr([[0, 1], [0, 0]], [0, 1], sp.diag(0, 1), 1).reason
    assert not feedback.lqg([[1]], [[1]], [[0]], 1, 1, 1, 1)
    for bad in [(A, B, G, sp.zeros(2)), (A, B[:2, :], G, N), (A[:2, :], B, G, N)]:
        with pytest.raises(ValueError):
            feedback.lqr(*bad)


@pytest.mark.parametrize("left", [0.0, 0.3, 2.0])
def test_finite_horizon_solves_the_riccati_equation(left):
    """Integrated backwards from F, in the weights and signs of the docstring."""
    a, b, g, n, f = floats(A, B, G, N, F)

    def rate(_, flat):
        S = flat.reshape(3, 3)
        return (a.T @ S + S @ a + g - S @ b @ np.linalg.solve(n, b.T @ S)).ravel()

    true = solve_ivp(rate, (0, left), f.ravel(), rtol=1e-10, atol=1e-12).y[:, -1].reshape(3, 3)
    ours = feedback.finite_lqr(a, b, g, n, f, left)
    np.testing.assert_allclose(ours.cost, true, atol=1e-7)
    np.testing.assert_allclose(ours.gain, -np.linalg.solve(n, b.T @ true), atol=1e-7)


def test_finite_horizon_exactly():
    left = sp.Symbol("left", positive=True)
    found = feedback.finite_lqr([[0, 1], [0, 0]], [0, 1], sp.zeros(2), 1, sp.eye(2), left)
    S = found.cost
    rest = (
        sp.Matrix([[0, 0], [1, 0]]) * S
        + S * sp.Matrix([[0, 1], [0, 0]])
        - S[:, 1] * S[1, :]
        - S.diff(left)
    )
    assert rest.applyfunc(sp.simplify) == sp.zeros(2) and S.subs(left, 0) == sp.eye(2)


def test_cost_is_that_of_the_whole_loop():
    """The covariance of (x, e) gives the cost without separation; no gains nearby cost less."""
    a, b, g, n = floats(A, B, G, N)
    h, q, r = np.array([[1.0, 0, 0]]), np.diag([0.0, 2, 1]), np.array([[0.5]])
    found = feedback.lqg(a, b, h, g, n, q, r)

    def price(K, L):
        loop = np.block([[a, b @ K], [L @ h, a + b @ K - L @ h]])
        noise = np.block([[q, np.zeros((3, 3))], [np.zeros((3, 3)), L @ r @ L.T]])
        P = solve_continuous_lyapunov(loop, -noise)
        return np.trace(g @ P[:3, :3]) + np.trace(K.T @ n @ K @ P[3:, 3:])

    K, L = found.regulator.gain, found.filter.gain
    least = price(K, L)
    assert abs(found.cost - least) < 1e-8 * least
    rng = np.random.default_rng(54)
    for _ in range(20):
        assert (
            price(K + 0.01 * rng.normal(size=K.shape), L + 0.01 * rng.normal(size=L.shape)) > least
        )
    assert (
        np.trace(found.regulator.cost @ q) == pytest.approx(found.cost_of_known_state)
        and found.cost_of_known_state < found.cost
    )


@pytest.mark.parametrize(
    "system", [(A, B, G, N), (sp.diag(2, 1), sp.eye(2), sp.diag(0, 1), sp.eye(2))]
)
def test_discrete_law_is_that_of_python_control_with_the_other_sign(system):
    ours = feedback.discrete_lqr(*floats(*system))
    gain, cost, _ = control.dlqr(*floats(*system), method="scipy")
    np.testing.assert_allclose(ours.gain, -gain, rtol=1e-9)
    np.testing.assert_allclose(ours.cost, cost, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(ours.loop, floats(system[0])[0] + floats(system[1])[0] @ ours.gain)


def test_exact_discrete_law_costs_what_its_riccati_equation_says():
    matrix, push, r = sp.Matrix([[1, 1], [0, 1]]), sp.Matrix([0, 1]), sp.Symbol("r", positive=True)
    law = feedback.discrete_lqr(matrix, push, sp.diag(1, 0), 1)
    near = feedback.discrete_lqr(*floats(matrix, push, sp.diag(1, 0), [[1]]))
    for name in ("cost", "gain", "loop"):
        np.testing.assert_allclose(*floats(getattr(law, name).evalf(20), getattr(near, name)))
    scalar = feedback.discrete_lqr(2, 1, 0, r)  # mirrors the eigenvalue at the unit circle
    assert scalar.loop[0] == sp.Rational(1, 2) and scalar.cost[0] == 3 * r


@pytest.mark.parametrize(
    "matrix, push, weight, words",
    [
        (sp.diag(2, 3), [0, 1], sp.eye(2), "not stabilisable"),
        (sp.diag(-1, 3), [1, 1], sp.diag(0, 1), "unit circle"),
    ],
)
def test_unsolvable_discrete_problems_have_a_reason(matrix, push, weight, words):
    column = np.array(push, dtype=float)[:, None]
    for system in ((matrix, push, weight, 1), (*floats(matrix, column, weight), 1.0)):
        law = feedback.discrete_lqr(*system)
        assert not law and words in law.reason


def test_finite_discrete_laws_are_the_minimum_over_all_controls():
    """The cost is a quadratic form of (x, u_0, ..., u_3), minimised at once."""
    a, b, g, n, f = floats(A, B, G, N, F)
    laws = feedback.discrete_finite_lqr(a, b, g, n, f, 4)
    rows, total = np.eye(3, 3 + 8), np.zeros((11, 11))
    for i in range(4):
        control_rows = np.eye(11)[3 + 2 * i : 5 + 2 * i]
        total += rows.T @ g @ rows + control_rows.T @ n @ control_rows
        rows = a @ rows + b @ control_rows
    total += rows.T @ f @ rows
    best = -np.linalg.solve(total[3:, 3:], total[3:, :3])
    np.testing.assert_allclose(laws[0].gain, best[:2], rtol=1e-9)
    np.testing.assert_allclose(laws[0].cost, total[:3, :3] + total[:3, 3:] @ best, rtol=1e-9)
    exact = feedback.discrete_finite_lqr(A, B, G, N, F, 4)
    np.testing.assert_allclose(*floats(exact[0].cost, laws[0].cost), rtol=1e-9)
    far, limit = (
        feedback.discrete_finite_lqr(a, b, g, n, f, 200)[0],
        feedback.discrete_lqr(a, b, g, n),
    )
    np.testing.assert_allclose(far.gain, limit.gain, rtol=1e-9)
    with pytest.raises(ValueError, match="steps: expected 1 or more"):
        feedback.discrete_finite_lqr(a, b, g, n, f, 0)


def test_a_law_in_floats_takes_at_most_a_hundred_calls():
    """Calls of functions of trajlib, for a system with two states."""
    calls, folder = [], str(Path(trajlib.__file__).parent)

    def count(frame, event, argument):
        if event == "call" and frame.f_code.co_filename.startswith(folder):
            calls.append(frame.f_code.co_name)

    system = floats([[0, 1], [0, 0]], [[0], [1]], np.eye(2), [[1]])
    sys.setprofile(count)
    try:
        law = feedback.lqr(*system)
    finally:
        sys.setprofile(None)
    assert law.gain == pytest.approx(np.array([[-1, -np.sqrt(3)]]))
    assert "lqr" in calls and len(calls) <= 100, len(calls)
