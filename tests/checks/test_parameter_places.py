"""Places at irrational values of a parameter are exact, and so is what is found of a system there."""

from fractions import Fraction

import pytest
import sympy as sp

from trajlib.checks.tools.places import Claim, Irrational, Rational, Residue, allowed, places
from trajlib.checks.truths.invariant_subspaces import characteristic_coefficients, kernel, restricted, unseen_subspace
from trajlib.checks.truths.pairs import pair_of

x, y = sp.symbols("x y", real=True)
LINE = ((Fraction(0),), (Fraction(1),))


def irrational_places(*polys):
    return [place for place in places(*LINE, [sp.Poly(poly, x) for poly in polys]) if place.irrational]


def test_a_residue_is_a_number_of_its_field():
    modulus = (Fraction(1), Fraction(0), Fraction(-2))
    root = Residue([Fraction(1), Fraction(0)], modulus)
    assert not root * root - 2 and not 2 - root * root and root
    inverse = 1 / (root + 1)
    assert not inverse - (root - 1)
    assert not root / root - 1 and not (root - root) and bool(Fraction(3) * root)


def test_every_real_root_is_a_place_and_places_stand_between():
    found = places(*LINE, [sp.Poly((x**2 - 2) * (3 * x - 1) * (x**2 + 1), x)])
    exact = sorted(float(place.numbers()[0]) for place in found if place.irrational)
    assert exact == pytest.approx([-2**0.5, 2**0.5], rel=1e-15)
    rational = [place.coordinates[0] for place in found if not place.irrational]
    assert Fraction(1, 3) in rational
    for low, high in [(-9, -1.42), (-1.41, 0), (0, 0.33), (0.34, 1.41), (1.42, 9)]:
        assert any(low < value < high for value in rational), (low, high)


@pytest.mark.parametrize("condition, positive, negative", [
    (sp.Ne(x, sp.sqrt(2)), False, True), (sp.Ne(x**2, 2), False, False), (sp.Ne(sp.Abs(x), sp.sqrt(2)), False, False),
    (x > 1, True, False), (x * sp.sqrt(2) >= 2, True, False), (sp.Eq(1 / (x**2 - 2), 1), False, False),
    (sp.Implies(x > 0, sp.Eq(x**2, 2)), True, True), (sp.Ne(x, 1.41), True, True), (sp.log(x) > 0, True, False),
])
def test_a_condition_at_the_roots_of_two(condition, positive, negative):
    low, high = sorted(irrational_places(x**2 - 2), key=lambda place: place.numbers())
    claim = Claim(condition, [x])
    assert (claim.holds(high), claim.holds(low)) == (positive, negative)


@pytest.mark.parametrize("condition, zeros", [
    (sp.Ne(x, sp.sqrt(3)), 3), (sp.Ne(sp.Abs(x), sp.sqrt(3)), 3), (sp.Ne(sp.sqrt(x), sp.sqrt(3)), 9),
    (sp.Ne(1 / x, sp.Rational(1, 3)), 9),
])
def test_the_boundary_of_a_condition_is_known(condition, zeros):
    claim = Claim(condition, [x])
    assert claim.is_semialgebraic
    assert any(poly.eval(sp.sqrt(zeros)) == 0 for poly in claim.boundaries)
    assert not Claim(sp.log(x) > 0, [x]).is_semialgebraic


def test_what_a_system_hides_at_an_irrational_value():
    # x1 - 2^(1/2) x2 and its like: z = x x1 + x2 loses an eigenvalue of [[0, 1], [2, 0]] exactly for x^2 = 1/2.
    pair = pair_of(sp.Matrix([[0, 1], [2, 0]]), sp.Matrix([[2 * x, 2]]), [x])
    for place in irrational_places(x**2 - 2):
        (vector,) = pair.unseen_at(place)
        assert not place.value(sp.Poly(x, x)) * vector[0] + vector[1]
    assert pair.unseen_at(Rational([Fraction(7, 5)])) == []


def test_the_largest_invariant_subspace():
    A = [[Fraction(a) for a in row] for row in ([0, 1, 0], [1, 1, 1], [1, 0, 1])]
    (vector,) = unseen_subspace(A, [[Fraction(0), Fraction(1), Fraction(0)]])
    assert vector[0] == -vector[2] and vector[1] == 0
    assert restricted(A, [vector]) == [[0]]
    assert characteristic_coefficients(A) == [1, -2, 0, 0]
    assert kernel([], 2) == [[1, 0], [0, 1]]


def test_the_signs_that_the_data_assume():
    positive, negative = sp.symbols("p n", positive=True), sp.symbols("m", negative=True)
    assert allowed(Rational([Fraction(1)]), [positive[0]]) and not allowed(Rational([Fraction(0)]), [positive[0]])
    assert allowed(Rational([Fraction(-1)]), [negative]) and not allowed(Rational([Fraction(1)]), [negative])
    place = Irrational((Fraction(0),), (Fraction(-1),), (Fraction(1), Fraction(0), Fraction(-2)),
                       irrational_places(x**2 - 2)[0].root)
    assert place.signs()[0] == -sp.sign(irrational_places(x**2 - 2)[0].root)
