"""Places in the space of parameters, rational and irrational ones, where a condition and a property are compared
exactly.

A property such as observability fails at isolated values of a parameter, so everything depends on these. On a line
through the parameters each boundary becomes a polynomial in t. The real roots of its irreducible factors are places of
their own: a rational root is a fraction, another one is a residue modulo its factor, in which sums, products and the
question "is it zero?" are exact.
"""

import functools
import itertools
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from trajlib.checks.tools import semialgebraic
from trajlib.checks.tools.exact_polynomials import exact, rational_roots
from trajlib.checks.tools.semialgebraic import Condition

#: Digits that terms of a condition are computed to at irrational places, and how small a zero is there.
DIGITS, NOTHING = 60, mpmath.mpf(10) ** -40
#: Boundaries of higher degree along a line are compared at their rational roots alone.
LARGEST_DEGREE = 24


class Rational:
    """A place whose coordinates are fractions."""

    irrational = False

    def __init__(self, coordinates):
        self.coordinates = tuple(coordinates)

    def value(self, poly):
        return exact(poly).value(self.coordinates)

    def sign(self, poly):
        return exact(poly).sign(self.coordinates)

    def numbers(self):
        with mpmath.workdps(DIGITS):
            return [mpmath.mpf(x.numerator) / x.denominator for x in self.coordinates]

    def signs(self):
        return [(x > 0) - (x < 0) for x in self.coordinates]


class Irrational:
    """The place `point + t * direction`, where t is an irrational root of an irreducible polynomial."""

    irrational = True

    def __init__(self, point, direction, modulus, root):
        self.point, self.direction, self.modulus, self.root = point, direction, modulus, root

    def value(self, poly):
        return Residue(exact(poly).along(self.point, self.direction), self.modulus)

    def sign(self, poly):
        value = self.value(poly)
        if not value:
            return 0
        with mpmath.workdps(DIGITS):
            return int(mpmath.sign(mpmath.polyval([mpmath.mpf(c.numerator) / c.denominator for c in value.coefficients],
                                                  self.root)))

    def numbers(self):
        with mpmath.workdps(DIGITS):
            return [mpmath.mpf(p.numerator) / p.denominator + self.root * mpmath.mpf(d.numerator) / d.denominator
                    for p, d in zip(self.point, self.direction)]

    def signs(self):
        return [int(mpmath.sign(x)) for x in self.numbers()]


class Residue:
    """A number of the field of rational polynomials modulo an irreducible one; coefficients from the highest power
    down."""

    __slots__ = ("coefficients", "modulus")

    def __init__(self, coefficients, modulus):
        self.coefficients, self.modulus = tuple(_divided(list(coefficients), modulus)[1]), modulus

    def __bool__(self):
        return bool(self.coefficients)

    def __add__(self, other):
        return Residue(_sum(self.coefficients, self._of(other)), self.modulus)

    def __neg__(self):
        return Residue([-c for c in self.coefficients], self.modulus)

    def __sub__(self, other):
        return Residue(_sum(self.coefficients, [-c for c in self._of(other)]), self.modulus)

    def __rsub__(self, other):
        return -(self - other)

    def __mul__(self, other):
        return Residue(_times(self.coefficients, self._of(other)), self.modulus)

    def __truediv__(self, other):
        return self * (1 / other)

    def __rtruediv__(self, other):
        """Euclid's algorithm: it ends at a number, since the modulus has no factors."""
        rest, last = list(self.coefficients), list(self.modulus)
        factor, before = [Fraction(1)], []
        while len(rest) > 1:
            quotient, left = _divided(last, rest)
            rest, last = left, rest
            factor, before = _sum(before, [-c for c in _times(quotient, factor)]), factor
        return Residue([c / rest[0] for c in factor], self.modulus) * other

    __radd__, __rmul__ = __add__, __mul__

    def _of(self, other):
        return other.coefficients if isinstance(other, Residue) else [Fraction(other)] if other else []


class Claim(Condition):
    """A student's condition that can be asked at rational and at irrational places."""

    def __init__(self, condition, parameters):
        self.parameters = list(parameters)
        self.condition = sp.to_nnf(condition, simplify=False) if condition.has(sp.Implies, sp.Equivalent) else condition
        self._atoms = {atom: _Term(atom.lhs - atom.rhs, self.parameters) for atom in self.condition.atoms(Relational)}

    @property
    def boundaries(self):
        return [poly for term in self._atoms.values() for poly in term.curves or ()]

    @property
    def is_semialgebraic(self):
        """True if the boundaries of all terms are known."""
        return all(term.curves is not None for term in self._atoms.values())

    def holds(self, place):
        """The truth value at a place; where a term is undefined the condition does not hold."""
        return self._truth(self.condition, place)


class _Term:
    """The sign (-1, 0, 1, or None where undefined) of an expression at a place."""

    def __init__(self, expression, parameters):
        expression = sp.nsimplify(expression, rational=True) if expression.has(sp.Float) else expression
        self.curves, self._parts = _curves(expression, parameters), None
        if expression.is_rational_function(*parameters):
            polys = [sp.Poly(part, *parameters) for part in sp.fraction(sp.together(expression))]
            if all(poly.domain.is_QQ or poly.domain.is_ZZ for poly in polys):
                self._parts = polys
        if self._parts is None:
            # Symbols are the data's own and functions are SymPy's (coercion.with_symbols), so the code made is ours.
            self._numeric = sp.lambdify(parameters, expression, "mpmath")

    def __call__(self, place):
        if self._parts is not None:
            numerator, denominator = (place.sign(poly) for poly in self._parts)
            return None if denominator == 0 else numerator * denominator
        try:
            with mpmath.workdps(DIGITS):
                number = mpmath.mpmathify(self._numeric(*place.numbers()))
        except (ZeroDivisionError, ValueError, TypeError, OverflowError):
            # TypeError: a Piecewise without a case for this place gives None, and complex numbers have no order.
            return None
        if mpmath.isnan(number) or abs(mpmath.im(number)) > NOTHING:
            return None
        # At 60 digits a value this small is a zero: no answer of a student lives at that scale.
        return 0 if abs(number) < NOTHING else int(mpmath.sign(mpmath.re(number)))


def places(point, direction, boundaries, extra=0, irrational=True):
    """The places of a line: one inside each interval between neighbouring boundaries, and every boundary itself.

    `extra` more places are spread over the line where boundaries are not known; `irrational` asks for irrational ones
    too.
    """
    factors = sorted(set().union(*(_factors(tuple(exact(poly).along(point, direction)), irrational)
                                   for poly in set(boundaries))))
    ends = {Fraction(0)} | {-p / d for p, d in zip(point, direction) if d}
    on, found = [], []
    for factor in factors:
        if len(factor) == 2:
            ends.add(-factor[1] / factor[0])
            continue
        for root in _real_roots(factor):
            found.append(root)
            on.append(Irrational(point, direction, factor, root))
    spread = [float(x) for x in 5 * np.tan(np.linspace(-1.5, 1.5, extra))]
    ordered = sorted({*map(float, ends), *map(float, found), *spread})
    between = [ordered[0] - 1 - abs(ordered[0]), *((a + b) / 2 for a, b in itertools.pairwise(ordered)),
               ordered[-1] + 1 + abs(ordered[-1])]
    steps = [*(Fraction(x).limit_denominator(10**9) for x in between), *sorted(ends)]
    return [Rational(p + t * d for p, d in zip(point, direction)) for t in steps] + on


def lines(parameters, count=24):
    """Lines through the parameter space as `semialgebraic.lines`, moved to where the parameters are positive if they
    are."""
    for point, direction in semialgebraic.lines(parameters, count=count):
        yield tuple(_allowed(p, x) if len(parameters) > 1 else x for p, x in zip(parameters, point)), direction


def lines_through_meetings(one, other, parameters):
    """Lines through the rational points of a plane where two polynomials vanish together, though they have no common
    factor."""
    x, y = parameters
    for first, second in ((x, y), (y, x)):
        meeting = sp.Poly(sp.resultant(one.as_expr(), other.as_expr(), second), first, domain="QQ")
        for at in rational_roots([Fraction(int(c.p), int(c.q))
                                  for c in meeting.all_coeffs()]) if meeting.degree() > 0 else ():
            yield ((at, Fraction(0)), (Fraction(0), Fraction(1))) if first == x else ((Fraction(0), at),
                                                                                      (Fraction(1), Fraction(0)))


def allowed(place, parameters):
    """True if a place agrees with what the data assume of the signs of the parameters."""
    return all(_agrees(symbol, sign) for symbol, sign in zip(parameters, place.signs()))


def _agrees(symbol, sign):
    return not (symbol.is_positive and sign <= 0 or symbol.is_negative and sign >= 0 or symbol.is_nonnegative
                and sign < 0
                or symbol.is_nonpositive and sign > 0 or symbol.is_nonzero and sign == 0)


def _allowed(symbol, number):
    return (abs(number) or Fraction(1) if symbol.is_positive else -abs(number) or Fraction(-1) if symbol.is_negative
            else number)


@functools.lru_cache(maxsize=512)
def _factors(coefficients, irrational):
    """The irreducible factors with real roots, as tuples of fractions with leading coefficient 1; `coefficients` a
    tuple."""
    if len(coefficients) < 2:
        return frozenset()
    linear = {(Fraction(1), -root) for root in rational_roots(list(coefficients))}
    if not irrational or len(coefficients) - 1 > LARGEST_DEGREE:
        return frozenset(linear)
    left = list(coefficients)
    for factor in linear:
        while not (divided := _divided(left, factor))[1]:
            left = divided[0]
    if len(left) == 1:
        return frozenset(linear)
    _, others = sp.Poly([sp.Rational(c.numerator, c.denominator) for c in left], sp.Symbol("t")).factor_list()
    monic = [poly.monic().all_coeffs() for poly, _ in others]
    return frozenset(linear | {tuple(Fraction(int(c.p), int(c.q)) for c in factor) for factor in monic})


@functools.lru_cache(maxsize=512)
def _real_roots(factor):
    """The real roots of an irreducible polynomial, to `DIGITS` digits."""
    near = np.roots([float(c) for c in factor])
    with mpmath.workdps(DIGITS + 15):
        exactly = [mpmath.mpf(c.numerator) / c.denominator for c in factor]
        roots = mpmath.polyroots(exactly, maxsteps=200, extraprec=200, roots_init=list(near)) if len(factor) > 3 else \
            [(-exactly[1] + sign * mpmath.sqrt(exactly[1]**2 - 4 * exactly[2])) / 2 for sign in (1, -1)]
        return [mpmath.re(root) for root in roots if abs(mpmath.im(root)) < NOTHING]


def _curves(expression, parameters):
    """Polynomials with rational coefficients among whose zeros those of an expression and its denominators lie; None if
    unknown.

    A root or an absolute value in it is taken for a further unknown w, with the equation that w satisfies, and
    eliminated.
    """
    found, left = [], list(sp.fraction(sp.together(expression)))
    for _ in range(12):
        if not left:
            return found
        part = left.pop()
        irrational = sorted((e for e in part.atoms(sp.Pow, sp.Abs) if isinstance(e, sp.Abs) or not e.exp.is_Integer
                             and e.exp.is_Rational),
                            key=lambda e: (-e.count_ops(), str(e)))
        if not irrational:
            if not part.is_polynomial(*parameters):
                return None
            poly = sp.Poly(part, *parameters)
            if not (poly.domain.is_QQ or poly.domain.is_ZZ):
                return None
            found += [] if poly.is_ground else [poly]
            continue
        root, w = irrational[0], sp.Dummy("w")
        base, p, q = (root.args[0], 2, 2) if isinstance(root, sp.Abs) else (root.base, abs(root.exp.p), root.exp.q)
        if not isinstance(root, sp.Abs) and root.exp.p < 0:
            base = 1 / base
        top, bottom = sp.fraction(sp.together(base))
        part = sp.numer(sp.together(part.xreplace({root: w})))
        if not part.is_polynomial(w):
            return None
        left += [sp.resultant(part, bottom**p * w**q - top**p, w), bottom]
    return None


def _divided(one, other):
    """(quotient, rest) of two polynomials; the rest comes without leading zeros."""
    rest, quotient = list(one), []
    while len(rest) >= len(other):
        factor = rest[0] / other[0]
        quotient.append(factor)
        rest = [a - factor * b for a, b in zip(rest[1:], [*other[1:], *[0] * (len(rest) - len(other))])]
    return quotient, list(itertools.dropwhile(lambda c: not c, rest))


def _sum(one, other):
    size = max(len(one), len(other))
    return [a + b for a, b in zip([0] * (size - len(one)) + list(one), [0] * (size - len(other)) + list(other))]


def _times(one, other):
    if not one or not other:
        return []
    result = [Fraction(0)] * (len(one) + len(other) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            result[i + j] += a * b
    return result
