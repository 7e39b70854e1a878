"""Regions of stability: problems 1.14 - 1.18, worked examples 3 - 5 and random equations."""

import importlib

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from trajlib.stability import stability_conditions

s, k, k1, k2, a, b, W, e = sp.symbols("s k k1 k2 a b W epsilon")
M = sp.Matrix

REGIONS = [
    ("example 3", s**4 + a * s**3 + b * s**2 + s + 1, [a, b], 0, sp.And(a > 0, a * b > a**2 + 1)),
    (
        "example 4",
        M([[k1, 1], [1, k2]]),
        [k1, k2],
        2,
        sp.And(k1 + k2 < -4, k1 * k2 + 2 * k1 + 2 * k2 > -3),
    ),
    ("example 5", M([[k1, 1], [k2, 1]]), [k1, k2], 0, sp.And(k1 < -1, k1 > k2)),
    ("1.14a", s**2 + s + 1 + k, [k], 0, k > -1),
    ("1.14b", s**2 + (1 + k) * s + 1, [k], 0, k > -1),
    ("1.14c", (1 + k) * s**2 + s + 1, [k], 0, k > -1),
    ("1.14d", k * s**2 + s + 1, [k], 0, k > 0),
    ("1.15a", s**3 + k1 * s**2 + k2 * s + 1, [k1, k2], 0, sp.And(k1 > 0, k1 * k2 > 1)),
    ("1.15b", s**3 + s**2 + k1 * s + k2, [k1, k2], 0, sp.And(k2 > 0, k1 > k2)),
    ("1.15c", k1 * s**3 + s**2 + s + k2, [k1, k2], 0, sp.And(k1 > 0, k2 > 0, k1 * k2 < 1)),
    ("1.15d", k1 * s**3 + s**2 + k2 * s + 1, [k1, k2], 0, sp.And(k1 > 0, k2 > k1)),
    ("1.15e", k1 * s**3 + k2 * s**2 + s + 1, [k1, k2], 0, sp.And(k1 > 0, k2 > k1)),
    ("1.16a", M([[k1, 1], [k2, 1]]), [k1, k2], 1, sp.And(k1 < -3, 2 * k1 + 2 > k2)),
    ("1.16b", M([[k1, k2], [1, 0]]), [k1, k2], 1, sp.And(k1 < -2, k1 + 1 > k2)),
    ("1.16c", M([[-k1, 1], [1, -k2]]), [k1, k2], 1, sp.And(k1 + k2 > 2, k1 * k2 > k1 + k2)),
    ("1.16d", M([[0, k1], [1, k2]]), [k1, k2], 1, sp.And(k2 < -2, k2 + 1 > k1)),
    ("1.16e", M([[-k1, k2], [-1, -1]]), [k1, k2], 1, sp.And(k1 > 1, k2 > 0)),
    ("1.16f", M([[1, 2 + k2], [k1 - 3, -2]]), [k1, k2], 1, sp.false),
    ("1.17a", M([[0, 1], [-W, -e]]), [W, e], 0, sp.And(W > 0, e > 0)),
    ("1.17b", M([[0, 1], [-W, -e]]), [W, e], 1, sp.And(e > 2, W + 1 > e)),
    ("1.18a", M([[-k1, 1, 0], [-k2, 0, 1], [-1, 0, 0]]), [k1, k2], 0, sp.And(k1 > 0, k1 * k2 > 1)),
    ("1.18b", M([[-1, 1, 0], [-k1, 0, 1], [-k2, 0, 0]]), [k1, k2], 0, sp.And(k2 > 0, k1 > k2)),
]


@pytest.mark.parametrize(
    "equation, parameters, degree, region", [r[1:] for r in REGIONS], ids=[r[0] for r in REGIONS]
)
def test_regions_of_the_problem_book(equation, parameters, degree, region):
    symbol = None if isinstance(equation, sp.MatrixBase) else s
    found = stability_conditions(equation, parameters, degree=degree, symbol=symbol)
    assert found.region == region
    assert found.empty is (region is sp.false)


def largest_real_part(equation, values):
    if isinstance(equation, sp.MatrixBase):
        return np.linalg.eigvals(np.array(equation.subs(values).tolist(), dtype=float)).real.max()
    return np.roots([float(c) for c in sp.Poly(equation.subs(values), s).all_coeffs()]).real.max()


@pytest.mark.slow
@pytest.mark.parametrize(
    "equation, parameters, degree", [r[1:4] for r in REGIONS], ids=[r[0] for r in REGIONS]
)
def test_regions_agree_with_the_spectrum(equation, parameters, degree):
    found = stability_conditions(
        equation, parameters, degree, None if isinstance(equation, sp.MatrixBase) else s
    )
    random = np.random.default_rng(1)
    points = list(random.uniform(-6, 6, size=(60, len(parameters))))
    # Close to the boundary: halve a segment between a point inside and one outside, and look at its
    # two ends.
    inside = [p for p in points if found.contains(p)]
    outside = [p for p in points if not found.contains(p)]
    for first, second in zip(inside[:6], outside[:6]):
        for _ in range(12):
            middle = (first + second) / 2
            first, second = (middle, second) if found.contains(middle) else (first, middle)
        points += [first, second]
    for point in points:
        worst = largest_real_part(equation, dict(zip(parameters, point))) + degree
        if abs(worst) > 1e-7:
            assert found.contains(point) == (worst < 0)


def test_edges_where_the_order_drops():
    edges = {
        edge.where: edge.region
        for edge in stability_conditions(
            k1 * s**3 + k2 * s**2 + s + 1, [k1, k2], symbol=s
        ).degenerate
    }
    assert edges == {sp.Eq(k1, 0): k2 > 0, sp.And(sp.Eq(k1, 0), sp.Eq(k2, 0)): sp.true}
    (edge,) = stability_conditions((1 + k) * s**2 + s + 1, [k], symbol=s).degenerate
    assert (edge.where, edge.polynomial, edge.region) == (sp.Eq(k, -1), s + 1, sp.true)
    # The degree of stability is asked of the equation of lower order too: s + 1 has not the degree 2.
    (edge,) = stability_conditions(k * s**2 + s + 1, [k], degree=2, symbol=s).degenerate
    assert edge.region is sp.false
    assert stability_conditions(s**2 + k * s + 1, [k], symbol=s).degenerate == ()


def test_other_readings_of_problem_1_14():
    def region(poly):
        return stability_conditions(poly, [k], symbol=s).region

    assert region(s**3 + s + 1 + k) is sp.false and region(s**3 + (1 + k) * s + 1) is sp.false
    assert region(s**3 + k * s**2 + s + 1) == (k > 1)
    assert region(s**3 + s**2 + s + 1 + k) == sp.And(k > -1, k < 0)
    assert region(s**3 + s**2 + (1 + k) * s + 1) == (k > 0)
    assert region(s**3 + (1 + k) * s**2 + s + 1) == (k > 0)
    assert region(k * s**3 + s**2 + s + 1) == sp.And(k > 0, k < 1)


def test_the_corrected_reading_of_problem_1_16f():
    region = stability_conditions(M([[1 + k1, 2], [-3, -2 + k2]]), [k1, k2], degree=1).region
    assert region == sp.And(k1 + k2 < -1, k1 * k2 + 2 * k2 + 4 > k1)


def test_leading_coefficient_of_either_sign():
    region = stability_conditions(a * s**2 + b * s + a, [a, b], symbol=s).region
    assert region == sp.Or(sp.And(a > 0, b > 0), sp.And(a < 0, b < 0))


def test_contains():
    found = stability_conditions(s**3 + k1 * s**2 + k2 * s + 1, [k1, k2], symbol=s)
    assert found.contains({k1: 2, k2: 1}) and found.contains([sp.Rational(1, 2), 3])
    assert not found.contains([1, 1])  # on the boundary
    assert found.contains([1, 1 + 2.0**-50])
    with pytest.raises(ValueError, match="no value for k2"):
        found.contains({k1: 1})
    with pytest.raises(ValueError, match="point"):
        found.contains([1, 2, 3])
    with pytest.raises(ValueError, match="real"):
        found.contains([1, sp.I])


def test_assumptions_are_used():
    p = sp.Symbol("p", positive=True)
    assert stability_conditions(s**2 + p * s + a, [p, a], symbol=s).region == (a > 0)
    assert stability_conditions(s**2 + p * s + p, [p], symbol=s).region is sp.true


def test_degree_may_be_a_symbol():
    mu = sp.Symbol("mu", positive=True)
    region = stability_conditions(s + a, [a, mu], degree=mu, symbol=s).region
    assert region == (a > mu)


def test_latex():
    assert r"\varnothing" in stability_conditions(s**3 + s + k, [k], symbol=s)._repr_latex_()
    assert "k_{1} k_{2} > 1" in stability_conditions([1, k1, k2, 1], [k1, k2])._repr_latex_()


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: stability_conditions(s**2 + a * s + b, [a], symbol=s), "parameters: .*b"),
        (lambda: stability_conditions(s**2 + a * s + 1, [a], degree=-1, symbol=s), "degree"),
        (lambda: stability_conditions(s**2 + a * s + 1, [a], degree=k, symbol=s), "parameters"),
        (lambda: stability_conditions(sp.zeros(2, 3), []), "square"),
        (lambda: stability_conditions(sp.sin(s), [], symbol=s), "polynomial"),
        (lambda: stability_conditions([1, a, 1], [a]).plot((0, 1), (0, 1)), "two parameters"),
    ],
)
def test_errors_name_the_argument(call, named):
    with pytest.raises(ValueError, match=named):
        call()


numbers = st.integers(-3, 3)


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(
    st.lists(st.tuples(numbers, numbers, numbers), min_size=2, max_size=4),
    st.lists(st.tuples(st.integers(-40, 40), st.integers(-40, 40)), min_size=15, max_size=15),
)
def test_random_regions_agree_with_the_spectrum(rows, points):
    """Equations of order 2 to 4 whose coefficients are affine in two parameters."""
    coefficients = [1, *(c + i * k1 + j * k2 for c, i, j in rows)]
    found = stability_conditions(coefficients, [k1, k2])
    for x, y in points:
        point = {k1: sp.Rational(x, 8), k2: sp.Rational(y, 8)}
        worst = np.roots([float(sp.sympify(c).subs(point)) for c in coefficients]).real.max()
        if abs(worst) > 1e-4:
            assert found.contains(point) == (worst < 0)
            assert not (worst < 0 and found.empty)


@pytest.mark.parametrize(
    "function",
    [
        *("stability.stability_conditions", "stability.jury_conditions"),
        *("feedback.observer", "feedback.regulator", "feedback.reduced_observer"),
        *("feedback.stabilising_gains", "feedback.convergent_gains"),
    ],
)
def test_the_former_name_of_the_degree_is_refused(function):
    package, name = function.split(".")
    with pytest.raises(TypeError, match=rf"^{name}: margin is called degree now \(degree=2\)$"):
        getattr(importlib.import_module(f"trajlib.{package}"), name)(None, margin=2)
