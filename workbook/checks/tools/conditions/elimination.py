"""Polynomials off whose zeros a condition in polynomial form does not change.

Each relation of the condition compares a rational function with zero. What stands in it for a root,
an absolute value or a sign is eliminated by resultants with its definition, and an angle by the
half-angle substitution cos a = (1 - t^2)/(1 + t^2), sin a = 2 t/(1 + t^2).
"""

import functools

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.tools.conditions.polynomial_form import as_fraction, terms


@functools.cache
def half_tangent(angle):
    """Return the symbol of the tangent of half an angle."""
    return sp.Dummy(f"half_tangent_{angle}", real=True)


class Elimination:
    """Eliminates what a polynomial form has added from its polynomials.

    Parameters
    ----------
    form : PolynomialForm
        What made conditions polynomial.
    straight : frozenset of sympy.Symbol
        The angles that are pi, where the tangent of the half has no value.
    """

    def __init__(self, form, straight=frozenset()):
        self._definitions = form.definitions
        self._turn, self._cache = {}, {}
        for angle, (cosine, sine) in form.circles.items():
            t = half_tangent(angle)
            self._turn[cosine] = sp.Integer(-1) if angle in straight else (1 - t**2) / (1 + t**2)
            self._turn[sine] = sp.Integer(0) if angle in straight else 2 * t / (1 + t**2)

    def borders(self, conditions):
        """Return the irreducible polynomials on whose zeros conditions may change."""
        borders = set()
        for condition in conditions:
            for relation in condition.atoms(Relational):
                for part in as_fraction(relation.lhs - relation.rhs):
                    borders |= self.factors(part)
        used = set().union(*(condition.free_symbols for condition in conditions))
        for symbol, (_, base, *_) in reversed(self._definitions.items()):
            if symbol in used:
                used |= base.free_symbols
                for part in as_fraction(base):
                    borders |= self.factors(part)
        return borders

    def factors(self, polynomial):
        """Return the irreducible polynomials off whose zeros a polynomial is not zero.

        Where it is zero on a whole branch of a root or an absolute value, they bound that branch.
        """
        if polynomial not in self._cache:
            remaining = {polynomial}
            for symbol, definition in reversed(self._definitions.items()):
                remaining = set().union(
                    *(
                        _without(part, symbol, definition) if part.has(symbol) else {part}
                        for part in remaining
                    )
                )
            remaining = {as_fraction(part.xreplace(self._turn))[0] for part in remaining}
            self._cache[polynomial] = frozenset().union(*map(irreducible_factors, remaining))
        return self._cache[polynomial]


@functools.lru_cache(maxsize=512)
def irreducible_factors(polynomial):
    """Return the irreducible factors of a polynomial over the rationals, without numbers."""
    terms(polynomial)  # raises Undecidable if it is none, or too large
    if not polynomial.free_symbols:
        return frozenset()
    factors = sp.Poly(polynomial, *sorted(polynomial.free_symbols, key=str)).factor_list()[1]
    return frozenset(factor.as_expr() for factor, _ in factors)


def _without(polynomial, symbol, definition):
    """Return polynomials without a symbol whose zeros contain those of a polynomial with it."""
    kind, base, *degree = definition
    if kind == "number":
        return {polynomial.xreplace({symbol: base})}
    if kind == "algebraic":
        return {sp.resultant(polynomial, degree[0], symbol)}
    if kind == "root":
        numerator, denominator = as_fraction(base)
        # one factor for each branch: that of sqrt(x^2) is x or -x
        branches = irreducible_factors(denominator * symbol ** degree[0] - numerator)
        return {sp.resultant(polynomial, part, symbol) for part in branches if part.has(symbol)}
    values = (base, -base) if kind == "size" else map(sp.Integer, (-1, 0, 1))
    return {as_fraction(polynomial.xreplace({symbol: value}))[0] for value in values}
