"""Measurement errors as states, time-varying outputs, equations with input derivatives."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from trajlib.structure import (
    controllability,
    observability,
    observability_matrix,
    scalar_equation,
    state_form,
    time_varying_conditions,
    time_varying_observability_matrix,
    with_measurement_error,
)

M = sp.Matrix
t, omega, a, b = sp.symbols("t omega alpha beta")
OSCILLATOR = M([[0, 1], [-1, 0]])


def test_examples_4_and_5():
    A, H = with_measurement_error(M([[0, 1], [1, 0]]), M([[1, 0]]), M([[0]]), [1])
    assert (
        observability_matrix(A, H) == M([[1, 0, 1], [0, 1, 0], [1, 0, 0]])
        and observability(A, H).holds
    )
    A, H = with_measurement_error(OSCILLATOR, M([[1, 0]]), M([[0, omega], [-omega, 0]]), [1, 0])
    assert observability_matrix(A, H) == M(
        [[1, 0, 1, 0], [0, 1, 0, omega], [-1, 0, -(omega**2), 0], [0, -1, 0, -(omega**3)]]
    )
    assert sp.expand(observability_matrix(A, H).det() - omega * (omega**2 - 1) ** 2) == 0


def test_floats_and_two_outputs():
    A, H = with_measurement_error(np.eye(2), np.eye(2), np.zeros((2, 2)), np.eye(2))
    assert A.shape == (4, 4) and np.array_equal(H, [[1, 0, 1, 0], [0, 1, 0, 1]])
    with pytest.raises(ValueError, match="c: expected shape"):
        with_measurement_error(sp.eye(2), M([[1, 0]]), M([[0]]), [1, 2])
    with pytest.raises(ValueError, match="S: expected a square"):
        with_measurement_error(sp.eye(2), M([[1, 0]]), M([[0, 1]]), [1])


def test_rotating_output_2_17():
    H = M([[sp.sin(omega * t), sp.cos(omega * t)]])
    N = time_varying_observability_matrix(OSCILLATOR, H, t)
    assert sp.simplify(N.det() - (1 - omega)) == 0
    found = time_varying_conditions(OSCILLATOR, H, t, [omega])
    assert found.region == sp.Ne(omega, 1) and found.exceptions == ((sp.Eq(omega, 1), 1),)
    # Independent of it: with omega = 1 the output is constant along every motion, x1(0) sin 0 +
    # x2(0) cos 0.
    motion = M([[sp.cos(t), sp.sin(t)], [-sp.sin(t), sp.cos(t)]])
    assert motion.diff(t) == OSCILLATOR * motion and sp.simplify((H * motion).subs(omega, 1)) == M(
        [[0, 1]]
    )


@pytest.mark.parametrize(
    "A, H, observable",
    [
        (sp.zeros(2), [[1, t]], True),
        (sp.zeros(3), [[1, t, t**2]], True),
        (sp.zeros(3), [[1, t, 1 + t]], False),
        (sp.zeros(2), [[sp.sin(t) ** 2, 1 - sp.cos(2 * t)]], False),
        (M([[1, 0], [0, 2]]), [[sp.exp(t), 1]], False),
        (M([[1, 0], [0, 2]]), [[sp.exp(-t), 1]], True),
        (M([[0, 1], [0, 0]]), [[-t, t**2]], False),
        (M([[0, 1], [0, 0]]), [[0, t**3]], False),
    ],
)
def test_time_varying_outputs(A, H, observable):
    found = time_varying_conditions(A, M(H), t)
    assert (found.region == sp.true) == observable
    # z(t) = H(t) exp(At) x0 at many moments: some x0 never shows exactly when these rows are
    # dependent.
    rows = [
        np.array(M(H).subs(t, moment), dtype=float) @ expm(np.array(A, dtype=float) * moment)
        for moment in np.linspace(0.1, 2, 9)
    ]
    assert (np.linalg.matrix_rank(np.vstack(rows), tol=1e-9) == A.rows) == observable


def test_time_varying_errors():
    with pytest.raises(ValueError, match="H: expected sums of polynomials"):
        time_varying_conditions(sp.eye(2), M([[1, 1 / (1 + t)]]), t)
    with pytest.raises(ValueError, match="A: expected a constant matrix"):
        time_varying_conditions(M([[0, t], [0, 0]]), M([[1, 1]]), t)
    with pytest.raises(ValueError, match="parameters: the system also has omega"):
        time_varying_conditions(sp.eye(2), M([[1, sp.sin(omega * t)]]), t)
    with pytest.raises(ValueError, match="formulas"):
        time_varying_observability_matrix(np.eye(2), np.ones((1, 2)), t)


def transfer(A, b, h, s):
    return sp.cancel((M(h) * (s * sp.eye(A.rows) - A).inv() * M(b))[0])


def test_state_form_2_29():
    A, b_, h = state_form([1, -1, -2], [1, 1])
    assert (A, b_, h) == (M([[0, 1], [2, 1]]), M([1, 2]), M([[1, 0]]))
    found = controllability(A, b_)
    assert found.rank == 1 and [m.eigenvalue for m in found.hidden_modes] == [-1]
    d = sp.Symbol("d")
    assert (
        state_form(d**2 - d - 2, d + 1, d)
        == (A, b_, h)
        == state_form(sp.Poly(d**2 - d - 2, d), sp.Poly(d + 1, d))
    )
    back = scalar_equation(A, b_, h)
    s = back.symbol
    assert (
        sp.expand(back.left - (s**2 - s - 2)) == 0
        and sp.expand(back.right - (s + 1)) == 0
        and back.order == 2
    )
    assert back._repr_latex_() == r"$\displaystyle \ddot z - \dot z - 2z = \dot u + u$"


coefficients = st.lists(st.integers(-4, 4), min_size=1, max_size=4)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(coefficients, coefficients, st.integers(1, 3))
def test_scalar_equation_inverts_state_form(lower, right, lead):
    left, right = [lead, *lower], right[: len(lower)]
    A, b_, h = state_form(left, right)
    s = sp.Symbol("s")
    asked = sp.Poly(right, s).as_expr() / sp.Poly(left, s).as_expr()
    assert sp.cancel(transfer(A, b_, h, s) - asked) == 0
    assert observability(A, h).holds
    back = scalar_equation(A, b_, h)
    assert sp.expand(back.left * lead - sp.Poly(left, s).as_expr()) == 0
    assert sp.expand(back.right * lead - sp.Poly(right, s).as_expr()) == 0
    assert controllability(A, b_).holds == (
        sp.gcd(sp.Poly(left, s), sp.Poly(right, s)).degree() == 0 and any(right)
    )


def test_scalar_equations_2_20_to_2_22():
    for A, b_ in (
        (M([[1, a], [-3, -2]]), M([1, 1])),
        (M([[1, -2], [4, -5]]), M([b, 1])),
        (M([[1, 1], [-3, 1]]), M([0, 1])),
    ):
        found = scalar_equation(A, b_)
        assert found.right == 1 and sp.expand(found.left - A.charpoly(found.symbol).as_expr()) == 0
        assert sp.cancel(transfer(A, b_, found.output, found.symbol) - 1 / found.left) == 0
        full = scalar_equation(A, b_, M([[1, 0]]))
        assert sp.cancel(transfer(A, b_, M([[1, 0]]), full.symbol) - full.right / full.left) == 0
    found = scalar_equation(M([[1, -2], [4, -5]]), M([b, 1]), [1, 0])
    assert r"\beta" in found._repr_latex_()


def test_scalar_equation_of_an_unobservable_pair():
    """z = x1 + x2 satisfies a first-order equation; the factor of an uncontrollable mode stays."""
    found = scalar_equation(M([[0, 1], [1, 0]]), M([0, 1]), M([[1, 1]]))
    assert found.order == 1 and found.right == 1 and sp.expand(found.left - (found.symbol - 1)) == 0


def test_equation_errors():
    with pytest.raises(ValueError, match="right: expected derivatives of u up to order 1"):
        state_form([1, 2, 3], [1, 0, 0])
    with pytest.raises(ValueError, match="left: expected an equation of order 1"):
        state_form([2], [1])
    with pytest.raises(ValueError, match="left: expected the list of coefficients"):
        state_form(sp.Symbol("d") ** 2, [1])
    with pytest.raises(ValueError, match="left: .* is not a polynomial"):
        state_form(sp.exp(t), [1], t)
    with pytest.raises(ValueError, match="not controllable"):
        scalar_equation(sp.eye(2), M([1, 1]))
    with pytest.raises(ValueError, match="vanishes identically"):
        scalar_equation(sp.eye(2), M([1, 1]), [0, 0])
    with pytest.raises(ValueError, match="h: expected one row"):
        scalar_equation(sp.eye(2), M([1, 1]), sp.eye(2))
    with pytest.raises(ValueError, match="exact"):
        scalar_equation(np.eye(2), np.ones((2, 1)), np.ones((1, 2)))
