"""The Jury criterion against the roots of polynomials, and what it shares with the Hurwitz criterion."""

import control
import numpy as np
import pytest
import sympy as sp

from trajlib.stability import jury_conditions, stability_conditions

a, b, c, k, m, z = sp.symbols("a b c k m z")

FAMILIES = [
    (z**2 + a * z + b, [a, b]),
    (z**3 + a * z + b, [a, b]),
    (z**3 + a * z**2 + b * z - sp.Rational(1, 3), [a, b]),
    (c * z**2 + a * z + b, [a, b, c]),
    (z**4 + a * z**2 + b * z + sp.Rational(1, 4), [a, b]),
]


@pytest.mark.parametrize("polynomial, parameters", FAMILIES)
@pytest.mark.parametrize("degree", [0, sp.Rational(1, 5)])
def test_region_is_where_all_roots_lie_inside_the_circle(polynomial, parameters, degree):
    found, rng = jury_conditions(polynomial, parameters, degree), np.random.default_rng(52)
    limit, inside = float(1 - degree), 0
    for _ in range(150):
        point = [sp.Rational(int(value), 16) for value in rng.integers(-30, 31, len(parameters))]
        coefficients = sp.Poly(polynomial.subs(dict(zip(parameters, point))), z).all_coeffs()
        if len(coefficients) <= sp.degree(polynomial, z):
            continue
        largest = np.abs(np.roots(np.array(coefficients, dtype=float))).max()
        if abs(largest - limit) > 1e-6:
            assert found.contains(point) == (largest < limit), point
            inside += largest < limit
    assert inside > 3


def test_order_drops_on_an_edge():
    found = jury_conditions(c * z**2 + a * z + b, [a, b, c])
    (edge,) = found.degenerate
    assert edge.where == sp.Eq(c, 0) and edge.polynomial == a * z + b
    assert edge.region.subs({a: -2, b: 1}) and not edge.region.subs({a: 1, b: 2})


@pytest.mark.parametrize("polynomial", [(z + 1) * (z - a), (z - 1) * (z - a), z**2 + a * z - 3])
def test_roots_on_or_outside_the_circle_for_all_parameters(polynomial):
    found = jury_conditions(sp.expand(polynomial), [a])
    assert found.region is sp.false and found.empty


def test_matrices_systems_and_arguments():
    matrix = sp.Matrix([[a, 1], [0, b]])
    assert jury_conditions(matrix, [a, b]).contains([0.5, -0.99])
    assert not jury_conditions(matrix, [a, b]).contains([0.5, -1])
    assert jury_conditions(control.ss([[0.5]], [[1]], [[1]], 0, True), []).region is sp.true
    with pytest.raises(ValueError, match="expected a system in discrete time.*stability_cond"):
        jury_conditions(control.ss([[0.5]], [[1]], [[1]], 0), [])
    with pytest.raises(ValueError, match="discrete time.*use jury_conditions"):
        stability_conditions(control.ss([[0.5]], [[1]], [[1]], 0, True), [])
    for degree in (-1, 1):
        with pytest.raises(ValueError, match="degree: "):
            jury_conditions(z + a, [a], degree)
    with pytest.raises(ValueError, match="parameters: the equation also has b"):
        jury_conditions(z + a + b, [a], symbol=z)


@pytest.mark.parametrize("function", [stability_conditions, jury_conditions])
def test_variable_is_the_symbol_that_is_left(function):
    found = function(m * z**2 + z + k, [k, m])
    assert found.symbol == z and found == function(m * z**2 + z + k, [k, m], symbol=z)
    with pytest.raises(ValueError, match="symbol: say which"):
        function(m * z**2 + z + k, [k])
