"""Whether two answers are the same, whatever their form: by value, as conditions at many points, as
functions at random places."""

import functools
import itertools
import math
from fractions import Fraction
from random import Random

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

LOGIC = (Relational, sp.And, sp.Or, sp.Not, sp.logic.boolalg.BooleanAtom)


def same_value(one, other, kind=""):
    """True if two answers are the same value, whatever their form; sets and lists of points have no
    order."""
    if isinstance(one, (list, tuple)) or isinstance(other, (list, tuple)):
        if not (isinstance(one, (list, tuple)) and isinstance(other, (list, tuple))):
            return False
        if kind.startswith(("list of vector", "set")):
            return all(any(same_value(a, b) for b in other) for a in one) and all(
                any(same_value(a, b) for a in one) for b in other
            )
        return len(one) == len(other) and all(map(same_value, one, other))
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same_value(one[key], other[key]) for key in one)
    if isinstance(one, str) or isinstance(other, str) or isinstance(one, bool):
        return one == other
    if isinstance(one, LOGIC) or isinstance(other, LOGIC):
        return same_condition(one, other)
    if isinstance(one, sp.MatrixBase) or isinstance(other, sp.MatrixBase):
        return sp.Matrix(one).shape == sp.Matrix(other).shape and all(
            map(same_value, sp.Matrix(one), sp.Matrix(other))
        )
    return vanishes(sp.sympify(one) - sp.sympify(other))


def vanishes(difference):
    """True if an expression is zero everywhere. That it is not is soon seen at a few places, and
    then nothing has to be simplified."""
    return difference == 0 or (not _differs_somewhere(difference) and sp.simplify(difference) == 0)


def _differs_somewhere(difference):
    random = Random(5)
    for _ in range(4):
        place = {
            symbol: _some_value(symbol, random)
            for symbol in sorted(difference.free_symbols, key=str)
        }
        value = difference.subs(place)
        # It may be a complex number: where a root of a negative one comes in, say.
        if (
            value.is_number
            and value.is_finite is not False
            and 1e-12 < abs(complex(value.evalf(30))) < math.inf
        ):
            return True
    return False


def _some_value(symbol, random):
    size = (
        sp.Integer(random.randint(1, 9))
        if symbol.is_integer
        else sp.Rational(random.randint(3, 60), 20)
    )
    return -size if symbol.is_negative else size


def same_condition(one, other, leave_out=lambda point: False):
    """True if two conditions agree at many rational points, those on the boundaries of both among
    them."""
    symbols = sorted(one.free_symbols | other.free_symbols, key=str)
    tests = [sp.lambdify(symbols, condition, modules="math") for condition in (one, other)]
    return all(
        holds(tests[0], point) == holds(tests[1], point) or leave_out(dict(zip(symbols, point)))
        for point in _points(symbols, one, other)
    )


def _points(symbols, *conditions):
    random = Random(11)

    def anywhere():
        return [
            Fraction(random.randint(-80, 80), random.choice((1, 2, 7, 20, 40))) for _ in symbols
        ]

    yield from (anywhere() for _ in range(600))
    for atom in sorted(
        set().union(*(condition.atoms(Relational) for condition in conditions)), key=str
    ):
        numerator = sp.numer(sp.together(atom.lhs - atom.rhs))
        for symbol in sorted(numerator.free_symbols, key=str):
            if not numerator.is_polynomial(symbol):
                continue
            coefficients = sp.lambdify(
                symbols, sp.Poly(numerator, symbol).all_coeffs(), modules="math"
            )
            for _ in range(12):
                point = anywhere()
                try:
                    line = coefficients(*point)
                except (ZeroDivisionError, ValueError, TypeError, OverflowError):
                    line = []
                # roots of numbers come in
                if not line or not all(isinstance(c, (int, Fraction)) for c in line):
                    place = {
                        s: sp.Rational(x.numerator, x.denominator)
                        for s, x in zip(symbols, point)
                        if s != symbol
                    }
                    here = numerator.xreplace(place)
                    line = (
                        sp.Poly(here, symbol).all_coeffs()
                        if here.is_polynomial(symbol) and here.has(symbol)
                        else []
                    )
                for at in _rational_roots(line):
                    for value in (at, at + Fraction(1, 10**4), at - Fraction(1, 10**4)):
                        yield [value if s == symbol else x for s, x in zip(symbols, point)]


def _rational_roots(coefficients):
    """The rational roots of a polynomial, its coefficients from the highest power down."""
    coefficients = list(itertools.dropwhile(lambda c: c == 0, coefficients))
    if len(coefficients) < 2:
        return []
    if len(coefficients) == 2 and isinstance(coefficients[0], (int, Fraction)):
        return [-coefficients[1] / Fraction(coefficients[0])]
    roots = sp.Poly([sp.sympify(c) for c in coefficients], sp.Symbol("t")).ground_roots()
    return [Fraction(int(root.p), int(root.q)) for root in roots if root.is_Rational]


def holds(test, point):
    try:
        return bool(test(*point))
    except (ZeroDivisionError, ValueError, TypeError):
        return False


def excluded(given):
    """The test whether a point violates the condition or conditions that a problem takes for
    granted."""
    given = sp.And(*given) if isinstance(given, (list, tuple)) else given
    return lambda point: (
        given.subs({s: sp.Rational(v.numerator, v.denominator) for s, v in point.items()})
        == sp.false
    )


@functools.lru_cache(maxsize=32)
def compiled(symbols, answer):
    """An answer as a function of numbers or arrays: the reference is asked for again with every
    mutant."""
    # a docstring would take as long as the code
    return sp.lambdify(symbols, answer, "numpy", docstring_limit=0)


def agree_at_random(one, other, domain, given=None, count=6000):
    random, symbols = np.random.default_rng(23), tuple(domain)
    columns = []
    for interval in domain.values():
        low, high = (float(end) for end in (interval.inf, interval.sup))
        spread = random.normal(size=count) * random.choice((0.3, 1, 3), size=count)
        columns.append(
            random.uniform(low, high, count)
            if math.isfinite(high - low)
            else low + abs(spread)
            if math.isfinite(low)
            else high - abs(spread)
            if math.isfinite(high)
            else spread
        )
    with np.errstate(all="ignore"):
        values = [
            np.broadcast_to(np.asarray(compiled(symbols, answer)(*columns), dtype=float), count)
            for answer in (one, other)
        ]
        keep = (
            np.ones(count, dtype=bool)
            if given is None
            else np.asarray(compiled(symbols, given)(*columns), dtype=bool)
        )
    one, other = (value[keep] for value in values)
    return np.allclose(one, other, rtol=1e-9, equal_nan=True)
