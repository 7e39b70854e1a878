"""Characteristic polynomials, Hurwitz matrices and minors."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import characteristic_polynomial, hurwitz_matrix, hurwitz_minors, shift

s, a, b, c, d = sp.symbols("s a b c d")


def test_matrix_and_minors_of_worked_example_3():
    poly = s**4 + a * s**3 + b * s**2 + s + 1
    assert hurwitz_matrix(poly, s) == sp.Matrix(
        [[a, 1, 0, 0], [1, b, 1, 0], [0, a, 1, 0], [0, 1, b, 1]]
    )
    minors = hurwitz_minors(poly, s)
    expected = [a, a * b - 1, a * b - a**2 - 1, a * b - a**2 - 1]
    assert all(sp.expand(m - e) == 0 for m, e in zip(minors, expected, strict=True))


def test_expression_poly_and_list_agree():
    poly = s**3 + a * s**2 + b * s + 2
    assert (
        hurwitz_minors(poly, s) == hurwitz_minors(sp.Poly(poly, s)) == hurwitz_minors([1, a, b, 2])
    )
    assert hurwitz_matrix([0, 0, 1, a, b, 2]) == hurwitz_matrix(poly, s)


def test_negative_leading_coefficient_changes_all_signs():
    assert hurwitz_minors(-(s**2) - 3 * s - 2) == hurwitz_minors(s**2 + 3 * s + 2)
    k = sp.Symbol("k", negative=True)
    assert hurwitz_matrix(k * s + a, s) == sp.Matrix([[-a]])


def test_zero_minor_on_the_way():
    """s^4 + s^3 + s^2 + s + 1: the second minor is zero and stops the elimination."""
    matrix = hurwitz_matrix(s**4 + s**3 + s**2 + s + 1)
    assert hurwitz_minors(s**4 + s**3 + s**2 + s + 1) == [matrix[:k, :k].det() for k in range(1, 5)]
    assert hurwitz_minors(s**3 + s + 1) == [0, -1, -1]


def test_floats_give_floats_with_exact_signs():
    minors = hurwitz_minors(np.array([1.0, 2.0, 3.0, 6.0]))
    assert minors == [2.0, 0.0, 0.0] and all(isinstance(m, float) for m in minors)
    assert isinstance(hurwitz_matrix([1.0, 2.0]), np.ndarray)
    # 0.1 + 0.2 > 0.3 in floats: the sign is that of the numbers given.
    assert hurwitz_minors([1.0, 1.0, 0.1 + 0.2, 0.3])[1] > 0


@pytest.mark.timeout(60)
def test_degree_six_with_four_symbols_is_quick():
    dense = sp.expand((s**2 + a * s + b) * (s**2 + c * s + d) * (s**2 + (a + c) * s + b * d))
    minors = hurwitz_minors(dense, s)
    point = {a: 1, b: 2, c: 3, d: 5}
    numeric = hurwitz_matrix(dense.subs(point), s)
    assert [m.subs(point) for m in minors] == [numeric[:k, :k].det() for k in range(1, 7)]


def test_characteristic_polynomial():
    A = sp.Matrix([[0, 1, 0], [0, 0, 1], [-a, -b, -c]])
    assert sp.expand(characteristic_polynomial(A, s) - (s**3 + c * s**2 + b * s + a)) == 0
    assert characteristic_polynomial([[1, 2], [3, 4]], s) == s**2 - 5 * s - 2
    floats = characteristic_polynomial(np.array([[0.0, 1.0], [-2.0, -3.0]]), s)
    assert np.allclose([float(v) for v in sp.Poly(floats, s).all_coeffs()], [1, 3, 2])


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: hurwitz_matrix(sp.Integer(0)), "identically zero"),
        (lambda: hurwitz_matrix([0, 0]), "identically zero"),
        (lambda: hurwitz_matrix(5 * s**0, s), "degree 1 or more"),
        (lambda: hurwitz_minors(sp.exp(s) + s, s), "not a polynomial in s"),
        (lambda: hurwitz_minors(1 / s + s, s), "not a polynomial in s"),
        (lambda: hurwitz_minors(s + a), "symbol"),
        (lambda: hurwitz_minors(s**2 + sp.I * s + 1, s), "real coefficients"),
        (lambda: hurwitz_minors([1.0, float("nan")]), "finite"),
        (lambda: hurwitz_minors(np.eye(2)), "list of coefficients"),
        (lambda: hurwitz_minors(sp.Poly(s * a, s, a)), "one symbol"),
        (lambda: characteristic_polynomial(sp.zeros(2, 3), s), "square"),
        (lambda: characteristic_polynomial(sp.Matrix([[sp.I]]), s), "real"),
        (lambda: characteristic_polynomial(sp.Matrix([[s]]), s), "symbol"),
        (lambda: characteristic_polynomial(np.ones((2, 3)), s), "square"),
        (lambda: shift(s + 1, sp.nan, s), "degree"),
    ],
)
def test_value_errors_name_the_argument(call, named):
    with pytest.raises(ValueError, match=named):
        call()


@pytest.mark.parametrize(
    "call",
    [
        lambda: hurwitz_minors("s + 1"),
        lambda: hurwitz_minors([1.0, a]),
        lambda: characteristic_polynomial([[1]], "s"),
    ],
)
def test_type_errors(call):
    with pytest.raises(TypeError):
        call()


def test_shift_moves_the_roots():
    assert sp.expand(shift((s + 1) * (s + 3), 2, s) - (s - 1) * (s + 1)) == 0
    assert shift([1, 4, 5], 2) == [1, 0, 1]
    assert shift(sp.Poly(s**2 + a * s, s), 1) == sp.Poly(s**2 + (a - 2) * s + 1 - a, s)
    assert np.allclose(shift([1.0, 4.0, 5.0], 2), [1, 0, 1])


@settings(max_examples=150, deadline=None)
@given(
    st.lists(st.integers(-20, 20), min_size=2, max_size=7).filter(
        lambda c: c[0] != 0 and c[-1] != 0
    )
)
def test_verdict_agrees_with_the_spectrum(coefficients):
    """All minors are positive exactly when all roots lie to the left of the imaginary axis."""
    rightmost = np.roots(coefficients).real.max()
    if abs(rightmost) > 1e-4:
        assert all(m > 0 for m in hurwitz_minors(coefficients)) == (rightmost < 0)


@settings(max_examples=30, deadline=None)
@given(st.lists(st.integers(-3, 3), min_size=9, max_size=9))
def test_cayley_hamilton(entries):
    A = sp.Matrix(3, 3, entries)
    value = sp.zeros(3, 3)
    for coefficient in sp.Poly(characteristic_polynomial(A, s), s).all_coeffs():
        value = value * A + coefficient * sp.eye(3)
    assert value == sp.zeros(3, 3)
