"""Polynomials in exact integers: the same values, lines and roots as SymPy's."""

import random
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from trajlib.checks.tools.exact_polynomials import exact, rational_roots
from trajlib.checks.tools.samples import bisected

x, y, z, t = sp.symbols("x y z t")


def some_polynomials(count=40):
    chance = random.Random(4)

    def fraction():
        return sp.Rational(chance.randint(-30, 30), chance.choice((1, 2, 3, 7)))

    for _ in range(count):
        terms = [fraction() * x**chance.randint(0, 3) * y**chance.randint(0, 3) * z**chance.randint(0, 2)
                 for _ in range(chance.randint(1, 6))]
        place = tuple(Fraction(chance.randint(-40, 40), chance.randint(1, 9)) for _ in range(3))
        direction = tuple(Fraction(chance.randint(-2, 2), chance.randint(1, 3)) for _ in range(3))
        yield sp.Poly(sum(terms), x, y, z), place, direction


def rational(number):
    return sp.Rational(number.numerator, number.denominator)


def test_values_signs_and_lines_are_those_of_sympy():
    for poly, place, direction in some_polynomials():
        true = poly.eval(tuple(map(rational, place)))
        assert rational(exact(poly).value(place)) == true and exact(poly).sign(place) == sp.sign(true)
        line = sp.Poly(poly.as_expr().subs(dict(zip((x, y, z), (rational(p) + rational(d) * t
                                                                for p, d in zip(place, direction))),
                                                ), simultaneous=True), t)
        assert [rational(c) for c in exact(poly).along(place, direction)] == ([] if line.is_zero else line.all_coeffs())


@pytest.mark.parametrize("expression", [
    t, t**3, 3 * t - 2, t**2 - 2, t**2 + 1, 4 * t**2 - 4 * t + 1, (t - 1)**3 * (2 * t + 5), (t**2 - 2) * (7 * t - 3),
    t**3 - 2, t**5 - t + 1,
    (t**2 + t + 1) * (t - sp.Rational(10**6, 10**6 + 1)), t**2 * (t - 1) * (t**4 + t + 1), sp.Integer(5),
    (t - 10**5) * (t**3 - 5) * (t + sp.Rational(1, 3)),
    (t**2 - 2) * (t**2 - 3) * (t**2 - 6),  # it has a root modulo every prime, and no rational one
])
def test_all_rational_roots_and_no_others(expression):
    poly = sp.Poly(expression, t)
    found = rational_roots([Fraction(int(c.p), int(c.q)) for c in poly.all_coeffs()])
    assert {rational(root) for root in found} == {root for root in poly.ground_roots() if root.is_Rational}


@pytest.mark.parametrize("rows", [1, 12, 50, 300])
@pytest.mark.parametrize("turns", [0, 1, 7, 40])
def test_halving_several_times_in_one_call_is_halving(rows, turns):
    """Bit for bit, also where what is sought changes more than once."""
    chance = np.random.default_rng(rows)
    first, last, phase = chance.uniform(0, 1, rows), chance.uniform(2, 9, rows), chance.uniform(0, 6, rows)

    def like_first(places, which):
        return np.sin(3 * places + phase[which]) * np.sin(3 * first[which] + phase[which]) > 0

    low, high = first, last
    for _ in range(turns):
        middle = (low + high) / 2
        same = like_first(middle, np.arange(rows))
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = bisected(like_first, first, last, turns)
    assert (found[0] == low).all() and (found[1] == high).all()
