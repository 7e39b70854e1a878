"""Real roots of polynomials, exact: over the rationals, and over a field with one algebraic number.

The roots of a set of polynomials cut the line into cells on which each of them has one sign: the
roots themselves and the open intervals between them, of which one rational number stands for each.
Roots over the rationals are isolated by Vincent's theorem and then computed to `DIGITS` digits.
Over Q(alpha), where SymPy isolates none, common divisors are exact, so that a polynomial without
multiple factors is left; its roots are computed to so many digits that real ones are told from
pairs of conjugates.
"""

import functools
import itertools
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from sympy.polys.densearith import dup_mul, dup_quo
from sympy.polys.densetools import dup_diff
from sympy.polys.euclidtools import dup_gcd

from workbook.checks.tools.conditions.polynomial_form import Undecidable

#: Digits to which a root is computed, and by how much different ones differ at least.
DIGITS, APART = 90, mpmath.mpf(10) ** -40
#: The greatest degree of a polynomial over a field with an algebraic number.
LARGEST_OVER_FIELD = 24


@dataclass(frozen=True)
class Coordinate:
    """A real number: rational, or an irrational root of a polynomial over the rationals.

    Parameters
    ----------
    number : mpmath.mpf
        Its value to `DIGITS` digits.
    rational : sympy.Rational or None
        Its value, if it is known to be rational.
    polynomial : sympy.Poly or None
        An irreducible polynomial with this root otherwise.
    """

    number: object
    rational: object = None
    polynomial: object = None

    def resolved(self):
        """Return itself, with what is known of it."""
        return self

    @property
    def is_rational(self):
        return self.rational is not None

    @property
    def exact(self):
        """Its value as a SymPy number."""
        if self.is_rational:
            return self.rational
        for root in self.polynomial.real_roots():
            with mpmath.workdps(DIGITS):
                if abs(mpmath.mpmathify(root.evalf(60)) - self.number) < APART:
                    return root
        raise Undecidable


@dataclass(frozen=True)
class RootOver(Coordinate):
    """A root of a polynomial over Q(alpha): whether it is rational costs a resultant to know."""

    alpha: object = None
    symbol: object = None

    def resolved(self):
        """Return the root of the norm of its polynomial with this value."""
        (generator,) = self.alpha.polynomial.gens
        norm = sp.resultant(self.alpha.polynomial, self.polynomial.as_expr(), generator)
        for factor, _ in sp.Poly(norm, self.symbol).factor_list()[1]:
            for root in _roots_of_irreducible(factor):
                with mpmath.workdps(DIGITS):
                    if abs(root.number - self.number) < APART:
                        return root
        raise Undecidable

    @property
    def exact(self):
        """Its value as a SymPy number."""
        return self.resolved().exact


def rational_coordinate(number):
    """Return the coordinate of a rational number."""
    number = sp.Rational(number)
    with mpmath.workdps(DIGITS):
        return Coordinate(mpmath.mpf(number.p) / number.q, number)


def cells_of_line(polynomials):
    """Return the cells into which the roots of polynomials over the rationals cut the line.

    Parameters
    ----------
    polynomials : list of sympy.Poly
        In one variable, none of them zero.

    Returns
    -------
    list of (Coordinate, frozenset)
        A point of each cell, in order, and the indices of the polynomials that vanish there.
    """
    owners = {}
    for k, polynomial in enumerate(polynomials):
        for factor, _ in polynomial.factor_list()[1]:
            owners.setdefault(factor.monic(), set()).add(k)
    roots = [
        (root, frozenset(indices))
        for factor, indices in owners.items()
        for root in _roots_of_irreducible(factor)
    ]
    return _with_intervals(roots)


def cells_over(alpha, polynomials, symbol):
    """Return the cells into which roots of polynomials over Q(alpha) cut the line.

    Parameters
    ----------
    alpha : Coordinate
        An irrational number.
    polynomials : list of sympy.Poly
        In alpha's symbol and a second one, over the rationals, none of them zero at alpha.
    symbol : sympy.Symbol
        The second one.

    Returns
    -------
    list of (Coordinate, frozenset)
        As for `cells_of_line`.
    """
    field = _field(alpha.exact)
    (generator,) = alpha.polynomial.gens

    def at_alpha(coefficient):
        coefficients = sp.Poly(coefficient, generator).all_coeffs()
        return functools.reduce(
            lambda a, c: a * field.unit + field.from_sympy(c), coefficients, field.zero
        )

    square_free = [
        _square_free(list(map(at_alpha, sp.Poly(p.as_expr(), symbol).all_coeffs())), field)
        for p in polynomials
    ]
    joint = [field.one]
    for factors in square_free:
        joint = dup_mul(joint, dup_quo(factors, dup_gcd(joint, factors, field), field), field)
    if len(joint) - 1 > LARGEST_OVER_FIELD:
        raise Undecidable
    with mpmath.workdps(DIGITS):
        numeric = [_numeric(factors, alpha) for factors in square_free]
        complex_roots = _simple_roots(_numeric(joint, alpha))
        vanishing = [set() for _ in complex_roots]
        for k, coefficients in enumerate(numeric):
            sizes = [abs(mpmath.polyval(coefficients, root)) for root in complex_roots]
            zeros = [j for j, size in enumerate(sizes) if size < APART]
            if len(zeros) != len(coefficients) - 1:
                raise Undecidable
            for j in zeros:
                vanishing[j].add(k)
        roots = [
            (
                RootOver(root.real, None, polynomials[min(indices)], alpha, symbol),
                frozenset(indices),
            )
            for root, indices in zip(complex_roots, vanishing)
            if abs(root.imag) < APART
        ]
    return _with_intervals(roots)


@functools.lru_cache(maxsize=64)
def _field(number):
    return sp.QQ.algebraic_field(number)


def _square_free(coefficients, field):
    while coefficients and not coefficients[0]:
        coefficients = coefficients[1:]
    if not coefficients:
        raise Undecidable
    common = dup_gcd(coefficients, dup_diff(coefficients, 1, field), field)
    return dup_quo(coefficients, common, field)


def _numeric(coefficients, alpha):
    """Return coefficients in Q(alpha), divided by the first, as numbers."""
    numbers = [
        mpmath.polyval(
            [mpmath.mpf(int(c.numerator)) / int(c.denominator) for c in item.to_list()],
            alpha.number,
        )
        if item
        else mpmath.mpf(0)
        for item in coefficients
    ]
    return [number / numbers[0] for number in numbers]


def _simple_roots(coefficients):
    """Return the complex roots of a polynomial without multiple ones."""
    if len(coefficients) == 1:
        return []
    try:
        floats = np.array([float(c) for c in coefficients])
        if not np.isfinite(floats).all():
            raise Undecidable
        near = np.roots(floats)
        distinct = near * (1 + 1e-12 * np.arange(len(near)))
        roots = mpmath.polyroots(
            coefficients, maxsteps=100, extraprec=100, roots_init=[mpmath.mpc(x) for x in distinct]
        )
    except mpmath.libmp.NoConvergence:
        raise Undecidable from None
    if any(abs(a - b) < 10 * APART for a, b in itertools.combinations(roots, 2)):
        raise Undecidable
    return [mpmath.mpc(root) for root in roots]


def _roots_of_irreducible(factor):
    """Yield the real roots of an irreducible polynomial over the rationals."""
    if factor.degree() == 1:
        yield rational_coordinate(-factor.nth(0) / factor.nth(1))
        return
    with mpmath.workdps(DIGITS + 10):
        coefficients = [mpmath.mpf(c.p) / c.q for c in factor.all_coeffs()]
        for (low, high), _ in factor.intervals(eps=sp.Rational(1, 10**6)):
            number = mpmath.findroot(
                lambda x: mpmath.polyval(coefficients, x),
                [mpmath.mpf(end.p) / end.q for end in (low, high)],
                solver="anderson",
                tol=mpmath.mpf(10) ** (-2 * DIGITS),
                verify=False,
            )
            around = [mpmath.polyval(coefficients, number + side * APART) for side in (-1, 1)]
            if not around[0] * around[1] < 0:
                raise Undecidable
            yield Coordinate(number, polynomial=factor)


def _with_intervals(roots):
    """Return roots in order, and between and beyond them one rational number for each interval."""
    roots = sorted(roots, key=lambda item: item[0].number)
    cells = []
    for (left, _), (right, _) in itertools.pairwise(roots):
        if right.number - left.number < APART:
            raise Undecidable
    nothing = frozenset()
    for k, (root, indices) in enumerate(roots):
        before = (
            _simplest_between(roots[k - 1][0].number, root.number)
            if k
            else sp.Integer(int(mpmath.floor(root.number)) - 1)
        )
        cells += [(rational_coordinate(before), nothing), (root, indices)]
    last = sp.Integer(int(mpmath.ceil(roots[-1][0].number)) + 1) if roots else sp.Integer(0)
    return [*cells, (rational_coordinate(last), nothing)]


def _simplest_between(low, high):
    """Return the rational number with the least denominator in the middle half of an interval."""
    quarter = (high - low) / 4
    low, high = (
        Fraction(*mpmath.libmp.to_rational(x._mpf_)) for x in (low + quarter, high - quarter)
    )
    simplest = _simplest(low, high)
    return sp.Rational(simplest.numerator, simplest.denominator)


def _simplest(low, high):
    """Return the fraction with the least denominator between two fractions (Stern and Brocot)."""
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -_simplest(-high, -low)
    whole = -(-low.numerator // low.denominator)  # the ceiling
    if whole <= high:
        return Fraction(whole)
    return whole - 1 + 1 / _simplest(1 / (high - whole + 1), 1 / (low - whole + 1))
