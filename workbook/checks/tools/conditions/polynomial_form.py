"""Conditions with roots, absolute values, cases and angles as polynomial ones in more symbols."""

import functools
import math

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.verdict import Invalid
from workbook.checks.tools.conditions.decimals import rational
from workbook.checks.tools.conditions.evaluation import OPERATORS

REVERSED = {sp.Gt: sp.Lt, sp.Ge: sp.Le, sp.Lt: sp.Gt, sp.Le: sp.Ge}
#: The greatest of more terms would be written with twice as many absolute values for each.
MOST_COMPARED = 5
#: Terms larger than this are not decided about.
LARGEST_DEGREE, MOST_TERMS, MOST_WRITTEN_OUT = 40, 4000, 20_000


class Undecidable(Exception):
    """Raised for what is no polynomial condition, or one too large."""


class PolynomialForm:
    """Rewrites conditions as polynomial ones in more symbols.

    A root, an absolute value, a point of the circle for an angle, a number such as pi each become a
    symbol; `sides` are the conditions that define them. The order of `angles`, which run from 0 to
    2 pi, is that of points on the circle.
    """

    def __init__(self, angles=()):
        self.sides, self.circles, self._symbols = [], {}, {}
        self._bare, self._angles = set(), angles

    @property
    def definitions(self):
        """What each symbol stands for, in the order in which one may depend on others.

        {symbol: ("root", base, degree), ("size", base), ("sign", base), ("number", near value) or
        ("algebraic", near value, polynomial in the symbol)}.
        """
        return {symbol: _definition(key, symbol) for key, symbol in self._symbols.items()}

    @property
    def numbers(self):
        """The symbols that stand for numbers such as pi."""
        return {key: w for key, w in self._symbols.items() if isinstance(key, sp.Expr)}

    def copy(self):
        """Return a copy that can be extended without changing this one."""
        copy = PolynomialForm(self._angles)
        copy.sides, copy.circles = list(self.sides), dict(self.circles)
        copy._symbols, copy._bare = dict(self._symbols), set(self._bare)
        return copy

    def condition(self, node):
        """Return a condition in polynomial form."""
        if node in (sp.true, sp.false):
            return node
        if isinstance(node, Relational):
            if not is_finite(node):
                return _compared_with_infinity(node)
            defined, difference = [], rational(node.lhs - node.rhs)
            for angle in difference.free_symbols.intersection(self._angles):
                angle_bound = angle - difference / difference.coeff(angle)
                if difference.coeff(angle).is_number and not angle_bound.has(angle):
                    relation = (
                        node.func
                        if difference.coeff(angle) > 0
                        else REVERSED.get(node.func, node.func)
                    )
                    ordered = self._ordered(angle, relation, angle_bound, defined)
                    return sp.And(*defined, ordered)
            squares = _squares(difference) if isinstance(node, (sp.Eq, sp.Ne)) else None
            terms = [self._term(part, defined) for part in squares or [difference]]
            if isinstance(node, sp.Ne) and any(isinstance(part, sp.Ge) for part in defined):
                return self._not_equal(terms, defined)
            parts = [node.func(term, 0) for term in terms]
            return sp.And(*defined, (sp.Or if isinstance(node, sp.Ne) else sp.And)(*parts))
        if isinstance(node, (sp.Implies, sp.Equivalent)):
            node = sp.to_nnf(node, simplify=False)
        if not isinstance(node, (sp.And, sp.Or, sp.Not, sp.Xor, sp.ITE)):
            raise Invalid("expected inequalities joined by And, Or and Not")
        return node.func(*map(self.condition, node.args))

    def _not_equal(self, terms, defined):
        """Return that a difference with a root is not zero, which is so where the root is not real.

        That is known only if nothing else that is not real is added to or multiplied with the root.
        """
        root_conditions = [part for part in defined if isinstance(part, sp.Ge)]
        remaining = [part for part in defined if part not in root_conditions]
        w = next(
            (
                w
                for key, w in self._symbols.items()
                if isinstance(key, tuple) and key[:2] == ("root", root_conditions[0].lhs)
            ),
            None,
        )
        if (
            w is None
            or not len(terms) == len(root_conditions) == 1
            or not terms[0].is_polynomial(w)
            or sp.degree(terms[0], w) != 1
            or not terms[0].expand().coeff(w).is_number
        ):
            raise Undecidable
        return sp.And(*remaining, sp.Or(sp.Not(root_conditions[0]), sp.Ne(terms[0], 0)))

    def _term(self, node, defined):
        if node.is_Symbol:
            self._bare.add(node)
            if node in self.circles:
                raise Undecidable  # an angle beside its own sine
            return node
        if node.is_Rational:
            return node
        if isinstance(node, (sp.Add, sp.Mul)):
            return node.func(*(self._term(part, defined) for part in node.args))
        if isinstance(node, sp.Pow) and node.exp.is_Rational:
            base, p, q = self._term(node.base, defined), node.exp.p, node.exp.q
            if p < 0:
                defined.append(sp.Ne(base, 0))
            if q == 1:
                return base**p
            defined.append(base >= 0)
            return (
                self._symbol(
                    ("root", base, q),
                    base,
                    lambda w: (sp.And(sp.Eq(w**q, base), w >= 0), sp.Eq(w, 0)),
                )
                ** p
            )
        if isinstance(node, sp.Abs):
            base = self._term(node.args[0], defined)
            return self._symbol(("size", base), base, lambda w: (sp.Eq(w, base), sp.Eq(w, -base)))
        if isinstance(node, sp.sign):
            base = self._term(node.args[0], defined)
            return self._symbol(
                ("sign", base),
                base,
                lambda w: (
                    sp.Or(sp.And(base > 0, sp.Eq(w, 1)), sp.And(sp.Eq(base, 0), sp.Eq(w, 0))),
                    sp.Eq(w, -1),
                ),
            )
        if isinstance(node, (sp.Max, sp.Min)):
            if len(node.args) > MOST_COMPARED:
                raise Undecidable
            sign = 1 if isinstance(node, sp.Max) else -1
            return self._term(
                functools.reduce(lambda a, b: (a + b + sign * sp.Abs(a - b)) / 2, node.args),
                defined,
            )
        if node.is_number and node.is_real:
            # A number with so many digits distinguishes from zero what a student writes; a difference
            # is evaluated again.
            near, w = (
                _near(node),
                self._symbols.setdefault(node, sp.Dummy("number", real=True)),
            )
            if isinstance(node, sp.CRootOf):
                self.sides.append(sp.Eq(node.poly.as_expr().subs(node.poly.gen, w), 0))
            self.sides += [w > near - sp.Rational(1, 10**45), w < near + sp.Rational(1, 10**45)]
            return w
        if isinstance(node, (sp.cos, sp.sin, sp.tan)):
            return self._trigonometric_term(node, defined)
        raise Undecidable

    def _ordered(self, angle, relation, bound, defined):
        """Return the relation of an angle in [0, 2 pi) to another, by points on the circle."""
        low, high = _range(bound)
        if bound.is_number and not 0 <= low < 2 * math.pi:
            return sp.sympify(OPERATORS[relation](0, low))
        # Both from 0 to pi and beyond pi the order is that of the cosines.
        c, s, cosine, sine = (
            self._term(sp.expand_trig(f(part)), defined)
            for part in (angle, bound)
            for f in (sp.cos, sp.sin)
        )
        equal = sp.And(sp.Eq(c, cosine), sp.Eq(s, sine))
        # an angle zero, not a whole turn
        in_upper_half = sp.And(sine >= 0, sp.Or(low <= 0, sp.Ne(cosine, 1)))
        less = sp.Or(
            sp.And(s >= 0, sp.Not(in_upper_half)),
            sp.And(s >= 0, in_upper_half, c > cosine),
            sp.And(s < 0, sp.Not(in_upper_half), c < cosine),
        )
        if -math.pi < low < 0 and high < math.pi:
            less, equal = sp.And(sine >= 0, less), sp.And(sine >= 0, equal)
        elif math.pi < low and 2 * math.pi < high < 3 * math.pi:
            less, equal = sp.Or(sine >= 0, less), sp.And(sine < 0, equal)
        elif not (0 <= low and high <= 2 * math.pi):
            raise Undecidable
        return {
            sp.Lt: less,
            sp.Le: sp.Or(less, equal),
            sp.Gt: sp.Not(sp.Or(less, equal)),
            sp.Ge: sp.Not(less),
            sp.Eq: equal,
            sp.Ne: sp.Not(equal),
        }[relation]

    def _symbol(self, key, base, where):
        """Return the symbol of a function of `base`.

        `where(w)` is the pair of conditions that define it: where base is not negative, and where it is.
        """
        if key not in self._symbols:
            w = self._symbols[key] = sp.Dummy("w", real=True)
            positive, negative = where(w)
            denominator = sp.fraction(sp.together(base))[1]
            self.sides.append(
                sp.Or(
                    sp.And(base >= 0, positive), sp.And(base < 0, negative), sp.Eq(denominator, 0)
                )
            )
        return self._symbols[key]

    def _trigonometric_term(self, node, defined):
        (angle,) = node.args
        if not angle.is_Symbol:
            expanded = sp.expand_trig(node)
            if expanded == node:
                raise Undecidable
            return self._term(expanded, defined)
        if angle in self._bare:
            raise Undecidable
        if angle not in self.circles:
            self.circles[angle] = c, s = sp.Dummy("c", real=True), sp.Dummy("s", real=True)
            self.sides.append(sp.Eq(c**2 + s**2, 1))
        c, s = self.circles[angle]
        if isinstance(node, sp.tan):
            defined.append(sp.Ne(c, 0))
        return {sp.cos: c, sp.sin: s, sp.tan: s / c}[node.func]


@functools.lru_cache(maxsize=128)  # one reference judges many answers
def polynomial_case(condition, angles):
    """Return a polynomial condition and its form, cached so that its symbols stay the same."""
    form = PolynomialForm(angles)
    return form, form.condition(condition)


def _definition(key, symbol):
    if isinstance(key, tuple):
        return key
    if isinstance(key, sp.CRootOf):
        return "algebraic", _near(key), key.poly.as_expr().subs(key.poly.gen, symbol)
    return "number", _near(key)


def _near(number):
    return sp.Rational(str(number.evalf(50)))


@functools.lru_cache(maxsize=512)
def as_fraction(expression):
    """Return numerator and denominator of a rational function."""
    return sp.fraction(sp.together(expression))


@functools.lru_cache(maxsize=512)
def terms(expression):
    """Return the terms of a polynomial: (coefficient, symbols as often as they are factors).

    Raises
    ------
    Undecidable
        If it is no polynomial with rational coefficients, or too large.
    """
    symbols = sorted(expression.free_symbols, key=str)
    if not expression.is_polynomial(*symbols) or _size(expression) > MOST_WRITTEN_OUT:
        raise Undecidable
    poly = sp.Poly(expression, *symbols or [sp.Dummy()])
    if (
        poly.domain not in (sp.ZZ, sp.QQ)
        or poly.total_degree() > LARGEST_DEGREE
        or len(poly.terms()) > MOST_TERMS
    ):
        raise Undecidable
    return [
        (str(coefficient), [symbol for symbol, power in zip(symbols, powers) for _ in range(power)])
        for powers, coefficient in poly.terms()
    ]


def _size(expression):
    """Return how many terms a polynomial may have when its powers and products are expanded."""
    if isinstance(expression, sp.Add):
        return sum(map(_size, expression.args))
    if isinstance(expression, sp.Mul):
        return math.prod(map(_size, expression.args))
    if isinstance(expression, sp.Pow) and expression.exp.is_Integer and expression.exp > 0:
        return math.comb(_size(expression.base) + int(expression.exp) - 1, int(expression.exp))
    return 1


def _squares(expression):
    """Return the bases of a sum of even powers with positive factors, or None if it is none.

    Such a sum vanishes where all bases do.
    """
    parts = [part.as_coeff_Mul() for part in sp.Add.make_args(expression)]
    even = all(
        factor > 0
        and power.is_Pow
        and power.exp.is_Integer
        and power.exp > 0
        and power.exp % 2 == 0
        for factor, power in parts
    )
    return [power.base for _, power in parts] if even else None


def _range(angle):
    """Return the least and the greatest value of a number plus at most one inverse function."""
    inverse = angle.atoms(sp.acos, sp.asin, sp.atan)
    for function in inverse:
        sign, number = angle.coeff(function), angle - angle.coeff(function) * function
        if len(inverse) == 1 and abs(sign) == 1 and number.is_number:
            ends = (0.0, math.pi) if isinstance(function, sp.acos) else (-math.pi / 2, math.pi / 2)
            return tuple(sorted(float(number) + float(sign) * end for end in ends))
    if not angle.is_number:
        raise Undecidable
    return float(angle), float(angle)


def is_finite(relation):
    """Return whether a relation does not contain infinity."""
    return not relation.has(sp.oo, -sp.oo)


def _compared_with_infinity(relation):
    """Return the truth of a comparison with infinity, which every number is below."""
    value = relation.subs(dict.fromkeys(relation.free_symbols, 0))
    if value not in (sp.true, sp.false):
        raise Undecidable
    return value
