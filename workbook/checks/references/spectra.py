"""The spectrum of a linear system with parameters, and where in their space it is stable.

The reference is polynomial: Hurwitz determinants for asymptotic stability, and for a root to the
right of the border that some u + i w with u > 0 satisfies the characteristic equation. Where a
claim is not, it is compared at points, with the Routh reduction in exact fractions.
"""

import functools
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.polyerrors import BasePolynomialError

from workbook.checks.tools.conditions import Case, ReferenceCondition, compare
from workbook.checks.tools.wording import values_text

#: A real part computed in floats has its sign where it is a greater share of the roots than this.
SURE = 1e-3
#: For how many points it is kept whether they are stable.
MOST_CACHED = 8192


def compare_region(answer, system, parameters, description, degree=0, unstable=False):
    """Compare a claimed region with the stable polynomials, or the unstable ones.

    Parameters
    ----------
    answer : object
        The condition.
    system : sympy.Expr or sympy.Matrix
        The polynomial or the matrix.
    parameters : list of sympy.Symbol
        Its parameters.
    description : str
        The property, for the message.
    degree : number
        The border is where the largest real part is -degree; with a degree of stability both sides are accepted.
    unstable : bool
        Whether the region is that of unstable polynomials.
    """
    if isinstance(system, sp.MatrixBase):
        system = system.as_immutable()
    spectrum = _spectrum(system, tuple(parameters), degree)
    reference = spectrum.instability if unstable else spectrum.stability

    def message(values, holds):
        side, verb = ("outside", "is") if holds else ("inside", "is not")
        return (
            f"the point {values_text(values)} lies {side} your region, yet it {verb} {description}: "
            f"{spectrum.describe(values)}"
        )

    return f"agrees with the roots: {compare(answer, parameters, reference, message)}"


def decays(A, discrete=False):
    """Return the condition on the symbols of A that all motions decay.

    Of x' = A x, or in discrete time of x(k + 1) = A x(k). There z = (1 + s)/(1 - s) maps the left
    half-plane to the inside of the circle; where z = -1 is an eigenvalue, the polynomial in s loses its
    order.
    """
    symbol = sp.Dummy("s")
    coefficients = A.charpoly().all_coeffs()
    above, below = (1 + symbol, 1 - symbol) if discrete else (symbol, sp.S.One)
    terms = (c * above ** (A.rows - k) * below**k for k, c in enumerate(coefficients))
    polynomial = sp.expand(sum(terms))
    if sp.degree(polynomial, symbol) < A.rows:
        return sp.false
    spectrum = Spectrum(polynomial, A.free_symbols, 0)
    return sp.And(*spectrum.order_kept, spectrum.hurwitz)


@functools.lru_cache(maxsize=8)
def _spectrum(system, parameters, degree):
    """Return the spectrum of data; many claims are compared with the same."""
    return Spectrum(system, parameters, degree)


def _rational(matrix):
    """Return a matrix with symbols for irrational entries, and their meaning.

    SymPy cannot order the factors of its characteristic polynomial otherwise.
    """
    symbols = {
        entry: sp.Dummy("entry", real=True)
        for entry in matrix
        if entry.free_symbols and not entry.is_rational_function(*entry.free_symbols)
    }
    return matrix.applyfunc(lambda entry: symbols.get(entry, entry)), {
        symbol: entry for entry, symbol in symbols.items()
    }


def _is_hurwitz(current):
    """Return whether all roots have negative real parts, by the exact Routh reduction."""
    current = current if current[0] > 0 else [-c for c in current]
    while len(current) > 1:
        if any(c <= 0 for c in current):
            return False
        ratio = current[0] / current[1]
        current = [
            c - ratio * (current[k + 1] if k % 2 == 0 and k + 1 < len(current) else 0)
            for k, c in enumerate(current)
        ][1:]
    return True


def _has_root_right(coefficients):
    """Return, exactly, whether a polynomial with rational coefficients has a root with Re > 0.

    The roots on the imaginary axis are those of its common factor with p(-s), whose other roots lie
    symmetrically: a polynomial in s^2 times a power of s.
    """
    s = sp.Dummy("s")
    p = sp.Poly(coefficients, s)
    common = sp.gcd(p, p.compose(sp.Poly(-s, s)))
    if not _is_hurwitz(p.quo(common).all_coeffs()):
        return True
    even = common.terms_gcd()[1]
    squares = sp.Poly(even.all_coeffs()[::2], s)
    squares = squares.quo(sp.gcd(squares, squares.diff(s)))
    return bool(squares.degree() > 0 and squares.count_roots(None, 0) < squares.degree())


class Spectrum:
    """The characteristic polynomial with coefficients in the parameters, shifted by the degree of stability."""

    def __init__(self, system, parameters, degree):
        self.parameters, self.degree = list(parameters), sp.nsimplify(degree)
        if isinstance(system, sp.MatrixBase):
            system, entries = _rational(system)
            characteristic = system.charpoly()
            symbol, polynomial = characteristic.gen, characteristic.as_expr().xreplace(entries)
        else:
            (symbol,) = system.free_symbols - set(parameters)
            polynomial = sp.sympify(system)
        shifted = sp.Poly(sp.expand(polynomial.subs(symbol, symbol - self.degree)), symbol)
        self._terms = [sp.nsimplify(c, rational=True) for c in shifted.all_coeffs()]
        self.root = sp.symbols("u w", real=True, cls=sp.Dummy)
        # all claims are tried at like points
        self._stable_at = functools.lru_cache(maxsize=MOST_CACHED)(self._decide)

    @functools.cached_property
    def stability(self):
        """The `ReferenceCondition` that all roots have real parts below -degree."""
        stable = sp.And(*self.order_kept, self.hurwitz)
        unstable = Case(sp.And(*self.order_kept, sp.Not(self.hurwitz)))
        return ReferenceCondition(
            (Case(stable),), (self._right[0] if self.degree else unstable,), self.is_stable
        )

    @functools.cached_property
    def instability(self):
        """The `ReferenceCondition` that some root has a real part above -degree."""
        some, none = self._right
        return ReferenceCondition((some,), (none,), self.is_unstable)

    @property
    def order_kept(self):
        """The condition that the order does not drop; elsewhere nothing is asked, by convention."""
        return [sp.Ne(self._terms[0], 0)]

    @functools.cached_property
    def hurwitz(self):
        """The condition that Hurwitz determinants have the signs of the leading coefficient."""
        n = len(self._terms) - 1
        hurwitz = sp.Matrix(
            n, n, lambda i, j: self._terms[2 * j - i + 1] if 0 <= 2 * j - i + 1 <= n else 0
        )
        minors = [self._terms[0]]
        for k in range(1, n + 1):
            rational, entries = _rational(hurwitz[:k, :k])
            matrix = DomainMatrix.from_Matrix(rational)
            # The characteristic polynomial of a matrix of order k ends with (-1)^k times its
            # determinant.
            constant = matrix.domain.to_sympy(matrix.charpoly()[-1]).xreplace(entries)
            minors.append(sp.expand((-1) ** k * constant))
        return sp.Or(
            *(
                sp.And(*(sign ** (k + (k == 0)) * minor > 0 for k, minor in enumerate(minors)))
                for sign in (1, -1)
            )
        )

    @property
    def _right(self):
        """The cases that some u + i w with u > 0 is a root, and that none is."""
        u, w = self.root
        terms = (c * (u + sp.I * w) ** k for k, c in enumerate(self._terms[::-1]))
        real, imaginary = sp.expand(sum(terms)).as_real_imag()
        root = sp.And(u > 0, sp.Eq(real, 0), sp.Eq(imaginary, 0))
        return Case(sp.And(*self.order_kept, root), self.root), Case(
            sp.And(*self.order_kept, sp.Not(root)), self.root, every=True
        )

    def _coefficients(self, values):
        """Return the coefficients at values of the parameters, as fractions if all is rational."""
        point = [values[p] for p in self.parameters]
        if self._in_fractions and all(x.is_Rational for x in point):
            return self._in_fractions(*(Fraction(int(x.p), int(x.q)) for x in point))
        return [c.subs(values) for c in self._terms]

    @functools.cached_property
    def _in_fractions(self):
        """The coefficients as a function of fractions, or None if they are no rational polynomials."""
        try:
            polys = [sp.Poly(c, *self.parameters) for c in self._terms]
        except BasePolynomialError:
            return None
        if not all(poly.domain.is_ZZ or poly.domain.is_QQ for poly in polys):
            return None
        # Whole coefficients, so that fractions stay fractions in the code that is made of them.
        denominators, cleared = zip(*(poly.clear_denoms(convert=True) for poly in polys))
        function = sp.lambdify(self.parameters, [poly.as_expr() for poly in cleared], [])
        return lambda *point: [
            Fraction(value) / int(denominator)
            for value, denominator in zip(function(*point), denominators)
        ]

    def is_stable(self, values):
        """Return whether all roots have negative real parts, by the exact Routh reduction.

        None where the order drops, or on the border of a degree of stability.
        """
        return self._stable_at(tuple(values[p] for p in self.parameters))

    def _decide(self, point):
        values = dict(zip(self.parameters, point))
        current = self._coefficients(values)
        if current[0] == 0:
            return None
        if self.degree and abs(self._largest(values)) < 1e-9:
            return None
        return _is_hurwitz(current)

    def is_unstable(self, values):
        """Return whether a root has a positive real part.

        None where the order drops, or where that can only be computed, and rounding would decide.
        """
        current = self._coefficients(values)
        if current[0] == 0:
            return None
        largest = self._largest(values)
        if abs(largest) > SURE:
            return bool(largest > 0)
        rational = [sp.Rational(c) for c in current if isinstance(c, (Fraction, sp.Rational))]
        return _has_root_right(rational) if len(rational) == len(current) else None

    def _largest(self, values):
        """Return the largest real part of a root beyond the degree of stability, relative to their size."""
        roots = np.roots([float(c) for c in self._coefficients(values)])
        return max(roots.real) / (1 + max(abs(roots)))

    def describe(self, values):
        """Return a text on the largest real part of a root at values of the parameters."""
        try:
            largest = max(np.roots([float(c) for c in self._coefficients(values)]).real) - float(
                self.degree
            )
        except OverflowError:
            return "by Routh's scheme, with coefficients beyond 1e308"
        # Roots computed in floating point: below this the point lies on the imaginary axis, which
        # without a degree of stability Routh has decided.
        on_axis = abs(largest) < 1e-7 and (
            self.degree or not (self.is_stable(values) or self.is_unstable(values))
        )
        text = f"{largest:.4g}" if not on_axis else "0" if self.degree else "exactly 0"
        return f"the largest real part of a root is {text}"
