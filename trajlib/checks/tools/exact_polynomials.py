"""Polynomials with rational coefficients at rational places and along rational lines, exactly.

A verdict on a condition asks for thousands of values and for hundreds of lines; in Python's own integers each is a
hundred times quicker than SymPy's substitution and factorisation, and as exact.
"""

import functools
import math
from fractions import Fraction

import numpy as np
import sympy as sp

#: A polynomial without a root modulo one of these has no rational root.
PRIMES = (5, 7, 11, 13, 17, 19, 23, 29)


@functools.lru_cache(maxsize=512)
def exact(poly):
    """The `Polynomial` of a SymPy `Poly` with rational coefficients: a condition asks for the same one at every
    place."""
    return Polynomial(poly)


class Polynomial:
    """A polynomial in several variables with rational coefficients."""

    def __init__(self, poly):
        terms = [(powers, Fraction(int(c.p), int(c.q))) for powers, c in poly.terms()]
        self._common = math.lcm(*(c.denominator for _, c in terms))
        self._terms = [(powers, int(c * self._common)) for powers, c in terms]
        self._degrees = [max(powers) for powers in zip(*(powers for powers, _ in terms))]

    def value(self, place):
        """The value at a place, a tuple of fractions."""
        return Fraction(self._numerator(place),
                        self._common * math.prod(x.denominator**m for x, m in zip(place, self._degrees)))

    def sign(self, place):
        """The sign at a place: -1, 0 or 1."""
        value = self._numerator(place)
        return (value > 0) - (value < 0)

    def _numerator(self, place):
        tables = [[x.numerator**k * x.denominator**(m - k) for k in range(m + 1)] for x, m in zip(place, self._degrees)]
        return sum(c * math.prod(table[k] for table, k in zip(tables, powers)) for powers, c in self._terms)

    def along(self, point, direction):
        """The coefficients, fractions from the highest power down, of the polynomial in t at `point + t *
        direction`."""
        tables, denominator = [], self._common
        for p, d, m in zip(point, direction, self._degrees):
            common = math.lcm(p.denominator, d.denominator)
            line = [int(p * common), int(d * common)] if d else [int(p * common)]
            powers = [[1]]
            for _ in range(m):
                powers.append(_product(powers[-1], line))
            tables.append([[common**(m - k) * c for c in power] for k, power in enumerate(powers)])
            denominator *= common**m
        total = [0] * (1 + sum(self._degrees))
        for powers, c in self._terms:
            term = [c]
            for table, k in zip(tables, powers):
                term = _product(term, table[k])
            for j, part in enumerate(term):
                total[j] += part
        while total and total[-1] == 0:
            total.pop()
        return [Fraction(c, denominator) for c in reversed(total)]


def rational_roots(coefficients):
    """All rational roots, as a set of fractions, of a polynomial that is not zero: its coefficients from the highest
    power down."""
    common = math.lcm(*(c.denominator for c in coefficients))
    left, found = [int(c * common) for c in coefficients], set()
    while left[-1] == 0:
        found.add(Fraction(0))
        left.pop()
    for root in np.roots([float(c) for c in coefficients]) if len(left) > 3 else ():
        near = Fraction(float(root.real)).limit_denominator(10**4)
        while len(left) > 3 and _at(left, near) == 0:
            found.add(near)
            left = _without(left, near)
    return found | _other_rational_roots(left)


def _other_rational_roots(coefficients):
    """The rational roots of a polynomial with integer coefficients: by formulas, and for higher degrees by SymPy if
    there can be any."""
    if len(coefficients) == 1:
        return set()
    if len(coefficients) == 2:
        return {Fraction(-coefficients[1], coefficients[0])}
    if len(coefficients) == 3:
        a, b, c = coefficients
        discriminant = b * b - 4 * a * c
        if discriminant < 0 or math.isqrt(discriminant)**2 != discriminant:
            return set()
        return {Fraction(-b + sign * math.isqrt(discriminant), 2 * a) for sign in (1, -1)}
    # A rational root is one modulo every prime that does not divide the leading coefficient.
    for prime in PRIMES:
        rest = [c % prime for c in coefficients]
        if rest[0] and not any(_at(rest, x) % prime == 0 for x in range(prime)):
            return set()
    return {Fraction(int(r.p), int(r.q)) for r in sp.Poly(coefficients, sp.Symbol("t")).ground_roots() if r.is_Rational}


def _product(one, other):
    """The product of two polynomials in t, integers from the lowest power up."""
    if len(other) == 1:
        return [other[0] * a for a in one]
    result = [0] * (len(one) + len(other) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            result[i + j] += a * b
    return result


def _at(coefficients, x):
    value = 0
    for c in coefficients:
        value = value * x + c
    return value


def _without(coefficients, root):
    """The integer polynomial divided by the factor of a rational root: with integer coefficients again (Gauss)."""
    quotient, carried = [], Fraction(0)
    for c in coefficients[:-1]:
        carried = carried * root + c
        quotient.append(carried / root.denominator)
    return [int(c) for c in quotient]
