"""Conditions on parameters, compared exactly along lines.

On a line through the parameter space every polynomial becomes one in a single variable. Between two neighbouring
roots of all polynomials of two conditions neither can change, so one rational point per interval decides the whole
line, and the roots that are rational decide whether a boundary belongs to the region. Many lines at several scales
leave a difference no place to hide but a set that none of them meets.
"""

from fractions import Fraction
from random import Random

import mpmath
import numpy as np
import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from trajlib.checks.contract.verdict import Invalid
from trajlib.checks.tools.exact_polynomials import exact, rational_roots


class Condition:
    """A condition in given parameters that can be evaluated exactly at rational points."""

    def __init__(self, condition, parameters):
        self.parameters = list(parameters)
        self.condition = condition
        self._atoms = {atom: _Sign(atom.lhs - atom.rhs, self.parameters) for atom in condition.atoms(Relational)}

    @property
    def boundaries(self):
        """Polynomials (SymPy `Poly` in the parameters) among whose zeros the boundary lies."""
        return [poly for sign in self._atoms.values() for poly in sign.polynomials]

    @property
    def is_semialgebraic(self):
        """True if every term is a rational function, so that `boundaries` holds the whole boundary."""
        return all(sign.is_rational for sign in self._atoms.values())

    def holds(self, point):
        """The truth value at a point, a tuple of `Fraction`; where a term is undefined the condition does not hold."""
        return self._truth(self.condition, point)

    def _truth(self, node, point):
        if isinstance(node, BooleanTrue):
            return True
        if isinstance(node, BooleanFalse):
            return False
        if isinstance(node, Relational):
            return _compare(node, self._atoms[node](point))
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
        if isinstance(node, (sp.Implies, sp.Equivalent)):
            return self._truth(sp.to_nnf(node), point)
        raise Invalid("expected inequalities joined by And, Or and Not")


class _Sign:
    """The sign (-1, 0, 1, or None where undefined) of an expression at rational points."""

    def __init__(self, expression, parameters):
        self.parameters = parameters
        expression = sp.nsimplify(expression, rational=True) if expression.has(sp.Float) else expression
        self._parts = self._numeric = None
        if expression.is_rational_function(*parameters):
            numerator, denominator = sp.fraction(sp.together(expression))
            polys = [sp.Poly(part, *parameters) for part in (numerator, denominator)]
            if all(poly.domain.is_QQ or poly.domain.is_ZZ for poly in polys):
                self._parts = polys
        if self._parts is None:
            # Symbols are the data's own and functions are SymPy's (coercion.with_symbols), so the code made is ours.
            self._numeric = sp.lambdify(self.parameters, expression, "mpmath")

    @property
    def is_rational(self):
        return self._parts is not None

    @property
    def polynomials(self):
        return [poly for poly in self._parts if not poly.is_ground] if self._parts else []

    def __call__(self, point):
        if self._parts is not None:
            numerator, denominator = (exact(poly).sign(point) for poly in self._parts)
            return None if denominator == 0 else numerator * denominator
        try:
            with mpmath.workdps(30):
                number = mpmath.mpmathify(self._numeric(*(mpmath.mpf(x.numerator) / x.denominator for x in point)))
        except (ZeroDivisionError, ValueError, TypeError, OverflowError):
            # TypeError: a Piecewise without a case for this point gives None, and complex numbers have no order.
            return None
        if mpmath.isnan(number) or abs(number.imag) > 1e-20:
            return None
        # At 30 digits a value this small is a zero: no answer of a student lives at that scale.
        return 0 if abs(number) < 1e-20 else _sign(number.real)


def lines(parameters, count=40, seed=1):
    """Random rational lines through the parameter space, at several scales: pairs (point, direction)."""
    random = Random(seed)
    n = len(parameters)
    if n == 1:
        yield (Fraction(0),), (Fraction(1),)
        return
    axes = [tuple(Fraction(int(i == j)) for j in range(n)) for i in range(n)]
    for k in range(count):
        scale = (Fraction(1, 4), Fraction(1), Fraction(4), Fraction(20))[k % 4]
        point = tuple(scale * Fraction(random.randint(-60, 60), 20) for _ in range(n))
        # Lines along an axis cross boundaries that are linear in one parameter at rational points.
        yield point, axes[(k // 4) % n] if k % 3 else tuple(Fraction(random.randint(-9, 9) or 1, 5) for _ in range(n))


def cells(point, direction, polynomials, extent=100, extra=0):
    """Points of a line: one inside each interval between neighbouring roots, and the roots that are rational.

    Returns two lists of points, (inside, on), the second with the rational roots. `extra` more points are spread over
    the line where terms that are not rational functions hide their boundary from the polynomials.
    """
    roots, rational = {0.0, *(5 * np.tan(np.linspace(-1.5, 1.5, extra)))}, set()
    for poly in polynomials:
        along = exact(poly).along(point, direction)
        if len(along) > 1:
            roots.update(_real_roots(along))
            rational |= rational_roots(along)
    ordered = sorted(roots | {-float(extent), float(extent)} | {float(r) for r in rational})
    inside = []
    for left, right in zip(ordered, ordered[1:]):
        # Two computed roots this close are one root of two polynomials: nothing lies between them.
        if right - left > 1e-6 * (1 + abs(left)):
            inside.append(Fraction((left + right) / 2).limit_denominator(10**7))
    def place(s):
        return tuple(p + s * d for p, d in zip(point, direction))

    return [place(s) for s in inside], [place(s) for s in sorted(rational)]


def as_text(parameters, point):
    """A point for a message: `k1 = 1/2, k2 = -3`."""
    return ", ".join(f"{p} = {x if x.denominator < 1000 else f'{float(x):.4g}'}" for p, x in zip(parameters, point))


def _real_roots(coefficients):
    roots = np.roots([float(c) for c in coefficients])
    # A double root comes back as a close complex pair; its real part still separates the cells.
    return {float(r.real) for r in roots if abs(r.imag) < 1e-5 * (1 + abs(r))}


def _sign(number):
    return int(bool(number > 0)) - int(bool(number < 0))


def _compare(relation, sign):
    if sign is None:
        return False
    holds = {sp.StrictGreaterThan: sign > 0, sp.GreaterThan: sign >= 0, sp.StrictLessThan: sign < 0,
             sp.LessThan: sign <= 0, sp.Equality: sign == 0, sp.Unequality: sign != 0}
    return holds[type(relation)]
