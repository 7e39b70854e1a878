"""Exact evaluation of a condition at one point: by fractions, algebraic numbers, or 60 digits."""

import functools
import math
import operator
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.verdict import Invalid
from workbook.checks.tools.conditions.decimals import rational
from workbook.checks.tools.line_search import bisect

#: Digits that terms are computed to where a value is irrational, and how small a zero is there.
DIGITS, NOTHING = 60, mpmath.mpf(10) ** -40
#: The product of the degrees of algebraic numbers up to which a value is distinguished from zero exactly.
LARGEST_FIELD = 8
#: Points between which the changes of sign of a term that is not rational are looked for.
GRID = np.concatenate([-np.geomspace(1e6, 1e-3, 200), np.geomspace(1e-3, 1e6, 200)])
#: The "sign" of a number that is not real.
NOT_REAL = "not real"
OPERATORS = {
    sp.Gt: operator.gt,
    sp.Ge: operator.ge,
    sp.Lt: operator.lt,
    sp.Le: operator.le,
    sp.Eq: operator.eq,
    sp.Ne: operator.ne,
}


class Condition:
    """A condition in given symbols that can be evaluated at exact numbers."""

    def __init__(self, condition, symbols):
        self.symbols = list(symbols)
        self.condition = (
            sp.to_nnf(condition, simplify=False)
            if condition.has(sp.Implies, sp.Equivalent)
            else condition
        )
        self._atoms = {
            atom: _relation_sign(atom, tuple(self.symbols))
            for atom in self.condition.atoms(Relational)
        }

    def holds(self, point):
        """Return whether it holds at a point, exact numbers in a row; not where a term is undefined."""
        return self._truth(self.condition, tuple(point))

    def borders(self, base, varied):
        """Return the values of one symbol, from `base`, where a term can change its sign: floats."""
        return sorted(
            {root for sign in self._atoms.values() for root in sign.roots(tuple(base), varied)}
        )

    def irrational_borders(self, base, varied):
        """Return those of these values that are algebraic numbers and irrational, exact."""
        return {
            root for sign in self._atoms.values() for root in sign.irrational_roots(base, varied)
        }

    def _truth(self, node, point):
        if node in (sp.true, sp.false):
            return bool(node)
        if isinstance(node, Relational):
            return _compared(node, self._atoms[node](point))
        if isinstance(node, sp.And):
            return all(self._truth(part, point) for part in node.args)
        if isinstance(node, sp.Or):
            return any(self._truth(part, point) for part in node.args)
        if isinstance(node, sp.Not):
            return not self._truth(node.args[0], point)
        if isinstance(node, sp.Xor):
            return sum(self._truth(part, point) for part in node.args) % 2 == 1
        if isinstance(node, sp.ITE):
            test, yes, no = node.args
            return self._truth(yes if self._truth(test, point) else no, point)
        raise Invalid("expected inequalities joined by And, Or and Not")


@functools.lru_cache(maxsize=64)
def prepared(condition, symbols):
    """Return the `Condition` of a condition in these symbols."""
    return Condition(condition, symbols)


def allowed(symbol, sign):
    """Return whether a value of this sign agrees with the assumptions of a symbol."""
    return not (
        (symbol.is_positive and sign <= 0)
        or (symbol.is_negative and sign >= 0)
        or (symbol.is_nonnegative and sign < 0)
        or (symbol.is_nonpositive and sign > 0)
        or (symbol.is_nonzero and sign == 0)
    )


class _Sign:
    """The sign of the difference of the sides of a relation at a point.

    It is -1, 0 or 1, NOT_REAL, or None where the difference is undefined.
    """

    def __init__(self, relation, symbols):
        self.symbols, self._numeric, self._parts = symbols, None, None
        difference = self._written = rational(relation.lhs - relation.rhs)
        if difference.is_rational_function(*symbols):
            parts = sp.fraction(sp.together(difference))
            if all(sp.Poly(part, *symbols).domain in (sp.ZZ, sp.QQ) for part in parts):
                # Whole coefficients, so that fractions stay fractions in the code that is made of
                # them.
                cleared = [sp.Poly(part, *symbols).clear_denoms(convert=True) for part in parts]
                self._factor = sp.prod([denominator for denominator, _ in cleared])
                self._polys = [poly for _, poly in cleared]
                self._parts = [sp.lambdify(symbols, poly.as_expr(), []) for poly in self._polys]
        if self._parts is None:
            # Symbols are the data's own and functions are SymPy's (coercion.with_symbols), so the
            # code made is ours.
            roots = {root: root.evalf(DIGITS) for root in difference.atoms(sp.CRootOf)}
            self._difference = difference.xreplace(roots)
            self._numeric = sp.lambdify(symbols, self._difference, "mpmath")

    def __call__(self, point):
        if self._parts is not None and all(x.is_Rational for x in point):
            at = [Fraction(int(x.p), int(x.q)) for x in point]
            numerator, denominator = (part(*at) for part in self._parts)
            return None if denominator == 0 else sign(numerator) * sign(denominator)
        try:
            with mpmath.workdps(DIGITS):
                at = [
                    mpmath.mpf(x.p) / x.q if x.is_Rational else mpmath.mpmathify(x.evalf(DIGITS))
                    for x in point
                ]
                if self._parts is not None:
                    numerator, denominator = (
                        self._exactly(k, point, part(*at)) for k, part in enumerate(self._parts)
                    )
                    return None if denominator == 0 else numerator * denominator
                number = mpmath.mpmathify(self._numeric(*at))
        except (ZeroDivisionError, ValueError, TypeError, OverflowError):
            # TypeError: a Piecewise without a case for this point gives None, and complex numbers
            # have no order.
            return None
        if mpmath.isnan(number):
            return None
        if abs(mpmath.im(number)) > NOTHING:
            return NOT_REAL
        # At 60 digits a value this small is a zero: no student's answer contains such a number.
        return 0 if abs(number) < NOTHING else sign(mpmath.re(number))

    def _exactly(self, k, point, number):
        """Return the sign of a polynomial at algebraic numbers; zero only if that is proved."""
        if abs(number) >= NOTHING:
            return sign(number)
        if (
            math.prod(number.poly.degree() for number in sp.Tuple(*point).atoms(sp.CRootOf))
            > LARGEST_FIELD
        ):
            raise ArithmeticError("algebraic numbers of so high a degree are not computed with")
        x, value = (
            sp.Dummy("x"),
            self._polys[k].as_expr().subs(dict(zip(self.symbols, point)), simultaneous=True),
        )
        if value != 0 and value.is_algebraic and sp.minimal_polynomial(value, x) != x:
            raise ArithmeticError("a number that is not zero could not be told from it")
        return 0

    def roots(self, base, varied):
        if self._parts is None:
            yield from self._crossings(base, varied)
            return
        t = sp.Dummy("t")
        point = {s: t if k == varied else x for k, (s, x) in enumerate(zip(self.symbols, base))}
        for poly in self._polys:
            line = sp.Poly(poly.as_expr().subs(point, simultaneous=True), t)
            coefficients = [float(c) for c in line.all_coeffs()]
            if len(coefficients) > 1 and np.isfinite(coefficients).all():
                # A double root comes back as a close complex pair; its real part still separates
                # the cells.
                yield from (
                    float(r.real)
                    for r in np.roots(coefficients)
                    if abs(r.imag) < 1e-5 * (1 + abs(r))
                )

    def irrational_roots(self, base, varied):
        """Yield the exact roots that are irrational, of polynomials of small degree."""
        t = sp.Dummy("t", real=True)
        point = {s: t if k == varied else x for k, (s, x) in enumerate(zip(self.symbols, base))}
        numerator, _ = sp.fraction(sp.together(self._written.subs(point, simultaneous=True)))
        try:
            line = sp.Poly(numerator, t, extension=True)
        except sp.PolynomialError:
            return
        if line.degree() == 1:
            roots = [sp.radsimp(-line.nth(0) / line.nth(1))]
        elif line.domain in (sp.ZZ, sp.QQ) and 1 < line.degree() <= LARGEST_FIELD:
            roots = [root for root, _ in line.real_roots(multiple=False)]
        else:
            return
        yield from (
            root for root in roots if root.is_real and root.is_algebraic and not root.is_Rational
        )

    def _crossings(self, base, varied):
        """Yield where the difference goes through zero or infinity between neighbours of a grid."""
        base_values = [float(x) for x in base]

        def values(x):
            with np.errstate(all="ignore"):
                numbers = self._floats(*base_values[:varied], x, *base_values[varied + 1 :])
            return np.broadcast_to(np.where(np.isreal(numbers), np.real(numbers), np.nan), x.shape)

        try:
            signs = np.sign(values(GRID))
            change = np.flatnonzero(signs[:-1] * signs[1:] < 0)
            _, crossings = bisect(
                lambda x, rows: np.sign(values(x)) == signs[change][rows],
                GRID[change],
                GRID[change + 1],
                60,
            )
        except (TypeError, ValueError, NameError, AttributeError, ZeroDivisionError, OverflowError):
            return  # a function that NumPy does not have
        yield from map(float, [*crossings, *GRID[signs == 0]])

    @functools.cached_property
    def _floats(self):
        return sp.lambdify(self.symbols, self._difference, "numpy")


@functools.lru_cache(maxsize=256)
def _relation_sign(relation, symbols):
    return _Sign(relation, symbols)


def _compared(relation, sign):
    if sign is NOT_REAL:
        return isinstance(relation, sp.Ne)  # such a number is not zero, and it has no order
    if sign is None:
        return False
    return OPERATORS[type(relation)](sign, 0)


def sign(number):
    return int(bool(number > 0)) - int(bool(number < 0))
