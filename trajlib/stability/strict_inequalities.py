"""Strict polynomial inequalities: existence of a solution, exactly, by sample points.

The set where several polynomials are all positive is open, so it is not empty exactly when it
contains one of the open cells into which the zero sets of the polynomials cut the space. One
rational point of every cell is found by removing the variables one at a time (leading coefficients,
discriminants and resultants bound the sets over which the cells stay the same) and putting them
back: the open part of Collins's cylindrical algebraic decomposition, A. Strzebonski, J. Symbolic
Computation 29 (2000) 471-480.
"""

from itertools import combinations, pairwise

import sympy as sp


class TooLarge(Exception):
    """Signals that the decision would take too long; the caller then continues without it."""


# Beyond these sizes an answer would take more than a few seconds: the degree of a resultant by the
# number of variables left in it, the number of polynomials and that of sample points.
_MAX_DEGREE = {1: 60, 2: 9}
_MAX_POLYNOMIALS = 30
_MAX_POINTS = 800


def solution_point(polynomials, symbols):
    """Return a rational point where all polynomials are positive, or None if there is none.

    The signs that the assumptions of the symbols give (positive=True) are part of the system.
    Raises `TooLarge` when the system is beyond the sizes above or is not polynomial over the
    rationals.
    """
    system = [sp.sympify(p) for p in polynomials]
    system += [s for s in symbols if s.is_positive] + [-s for s in symbols if s.is_negative]
    free = set().union(*(p.free_symbols for p in system))
    order = [s for s in symbols if s in free]
    if not all(p.is_polynomial(*order) and p.free_symbols <= set(order) for p in system):
        raise TooLarge
    constants = [p for p in system if p.is_number]
    if any(p <= 0 for p in constants):
        return None
    free_values = dict.fromkeys((s for s in symbols if s not in free), sp.Integer(0))
    positive_polynomials = [sp.Poly(p, *order) for p in system if not p.is_number]
    if not positive_polynomials:
        return free_values
    if any(not (p.domain.is_ZZ or p.domain.is_QQ) for p in positive_polynomials):
        raise TooLarge
    for point in _cell_points(_irreducible_factors(positive_polynomials), order):
        if all(p(*point) > 0 for p in positive_polynomials):
            return free_values | dict(zip(order, point))
    return None


def _irreducible_factors(polys):
    factors = {f.primitive()[1] for p in polys if not p.is_zero for f, _ in p.factor_list()[1]}
    if len(factors) > _MAX_POLYNOMIALS:
        raise TooLarge
    return factors


def _cell_points(factors, symbols):
    """Return one rational point in each open cell, as tuples in the order of `symbols`."""
    *leading, last = symbols
    if not leading:
        return [(value,) for value in _values_between_roots(factors)]
    dependent = [f.as_expr() for f in factors if f.degree(last) > 0]
    largest = sorted(sp.Poly(f, *symbols).total_degree() for f in dependent)[-2:]
    if dependent and largest[0] * largest[-1] > _MAX_DEGREE.get(len(leading), 4):
        raise TooLarge
    independent = {sp.Poly(f.as_expr(), *leading) for f in factors if f.degree(last) == 0}
    projected = [sp.LC(f, last) for f in dependent]
    projected += [sp.discriminant(f, last) for f in dependent if sp.degree(f, last) > 1]
    projected += [sp.resultant(f, g, last) for f, g in combinations(dependent, 2)]
    shadows = [sp.Poly(p, *leading) for p in projected]
    base = _irreducible_factors([p for p in shadows if not p.is_ground]) | independent
    points = []
    for point in _cell_points(base, leading):
        lines = [sp.Poly(f.subs(dict(zip(leading, point))), last) for f in dependent]
        points += [(*point, value) for value in _values_between_roots(lines)]
        if len(points) > _MAX_POINTS:
            raise TooLarge
    return points


def _values_between_roots(polys):
    """Return rational numbers, one in each interval between the real roots."""
    product = sp.prod([p for p in polys if not p.is_ground], start=sp.Integer(1))
    if product == 1:
        return [sp.Integer(0)]
    product = product.sqf_part()
    width = sp.Rational(1, 4)
    intervals = product.intervals(eps=width)
    if not intervals:
        return [sp.Integer(0)]
    ends = [(sp.Rational(a), sp.Rational(b)) for (a, b), _ in intervals]
    # Two isolating intervals may share an end; they are narrowed until the ends differ.
    while any(left[1] >= right[0] for left, right in pairwise(ends)):
        width /= 16
        ends = [(sp.Rational(a), sp.Rational(b)) for (a, b), _ in product.intervals(eps=width)]
    between = [(left[1] + right[0]) / 2 for left, right in pairwise(ends)]
    return [sp.floor(ends[0][0]) - 1, *between, sp.ceiling(ends[-1][1]) + 1]
