"""Decide whether a condition agrees with its reference by one point of each cell of a decomposition.

It serves where z3 is absent or gives up, for conditions in at most two variables. A value at a point
is computed to many digits; that a polynomial vanishes there is known from the decomposition, exactly.
"""

import functools
import itertools

import mpmath
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.tools.conditions.decomposition import columns
from workbook.checks.tools.conditions.elimination import Elimination, half_tangent
from workbook.checks.tools.conditions.evaluation import NOTHING, OPERATORS, sign
from workbook.checks.tools.conditions.polynomial_form import (
    Undecidable,
    as_fraction,
    polynomial_case,
    terms,
)
from workbook.checks.tools.conditions.real_roots import DIGITS

#: A decomposition is made in so many variables.
MOST_VARIABLES = 2


def points_of_difference(readings, parameters, case, holds, restriction):
    """Yield points of all cells where all readings of a claim are wrong in one case.

    Parameters
    ----------
    readings : list
        Readings of the claim.
    parameters : list of sympy.Symbol
        Its symbols.
    case : Case
        The case of the reference.
    holds : bool
        What the claim has to be there.
    restriction : sympy condition
        A condition that the point also has to satisfy.

    Yields
    ------
    tuple
        Exact numbers of the parameters, and of the unknowns unless the case is about every value.
        If there is no point, none exists.

    Raises
    ------
    Undecidable
        If no decomposition can be made.
    """
    form, condition = polynomial_case(case.condition, case.angles)
    form = form.copy()
    claims = [form.condition(reading) for reading in readings]
    claimed = [sp.Not(claim) if holds else claim for claim in claims]
    claimed.append(form.condition(restriction))
    written = set().union(*(part.free_symbols for part in (*readings, restriction, case.condition)))
    others = sorted(written.difference(parameters, case.unknowns), key=str)
    for count in range(len(form.circles) + 1):
        for straight in itertools.combinations(form.circles, count):
            search = _Search(form, frozenset(straight), parameters, case, others)
            yield from search.points(claimed, condition)


class _Search:
    """The decomposition for one case, with some of its angles equal to pi."""

    def __init__(self, form, straight, parameters, case, others):
        self.form, self.straight, self.case = form, straight, case
        self.elimination = Elimination(form, straight)
        self.parameters = list(parameters)
        self.variables = {
            s: half_tangent(s) if s in form.circles else s
            for s in [*parameters, *others, *case.unknowns]
            if s not in straight
        }

    def points(self, claimed, condition):
        borders = self.elimination.borders([*claimed, condition])
        borders |= {s for s in self.variables.values() if _has_sign(s)}
        used = set().union(*(factor.free_symbols for factor in borders))
        symbols = [t for t in self.variables.values() if t in used]
        if (
            used - set(symbols)
            or len(symbols) > MOST_VARIABLES
            or any(s.is_integer for s in symbols)
        ):
            raise Undecidable
        inner = {self.variables.get(s) for s in self.case.unknowns} if self.case.every else set()
        if (
            not inner
            and len(symbols) == 2
            and _degree(borders, symbols[0]) < _degree(borders, symbols[1])
        ):
            symbols.reverse()  # resultants of smaller degree
        factors = sorted(borders, key=lambda f: (len(f.free_symbols), str(f)))
        for column in columns(factors, symbols):
            cells = [_Values(cell, self) for cell in column]
            if self.case.every:
                # within a column only the unknown varies, if there is one
                groups = [cells] if symbols and symbols[-1] in inner else [[cell] for cell in cells]
                if len(inner & set(symbols)) == 2:
                    raise Undecidable
            else:
                groups = [[cell] for cell in cells]
            for group in groups:
                if all(group[0].truth(claim) for claim in claimed) and all(
                    cell.truth(condition) for cell in group
                ):
                    yield group[0].exact()


def _has_sign(symbol):
    return any(
        (
            symbol.is_positive,
            symbol.is_negative,
            symbol.is_nonnegative,
            symbol.is_nonpositive,
            symbol.is_nonzero,
        )
    )


def _degree(factors, symbol):
    return sum(sp.degree(f, symbol) for f in factors)


class _Values:
    """Values of all symbols of a polynomial form at the point of a cell."""

    def __init__(self, cell, search):
        self.cell, self._search, self._signs = cell, search, {}

    @functools.cached_property
    def _numbers(self):
        form, numbers = (
            self._search.form,
            {symbol: coordinate.number for symbol, coordinate in self.cell.point.items()},
        )
        for symbol in self._search.variables.values():
            numbers.setdefault(symbol, mpmath.mpf(_default(symbol)))
        for angle, (cosine, sine) in form.circles.items():
            if angle in self._search.straight:
                numbers[cosine], numbers[sine] = mpmath.mpf(-1), mpmath.mpf(0)
            else:
                t = numbers[half_tangent(angle)]
                numbers[cosine], numbers[sine] = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)
        return numbers

    def _number(self, symbol):
        if symbol not in self._numbers:
            kind, base, *degree = self._search.form.definitions[symbol]
            size, direction = self._fraction(base)
            self._numbers[symbol] = (
                size
                if kind == "number"
                else mpmath.mpf(direction)
                if kind == "sign"
                else abs(size)
                if kind == "size"
                else mpmath.root(size, degree[0])
                if direction > 0
                else mpmath.mpf(0)
            )
        return self._numbers[symbol]

    def _fraction(self, expression):
        """Return value and sign of a rational function; zero where it has no value."""
        numerator, denominator = as_fraction(expression)
        if self.sign(numerator) * self.sign(denominator) == 0:
            return mpmath.mpf(0), 0
        value = self._value(numerator) / self._value(denominator)
        return value, sign(value)

    def _value(self, polynomial):
        return sum(
            coefficient * mpmath.fprod(map(self._number, symbols))
            for coefficient, symbols in _numeric_terms(polynomial)
        )

    def sign(self, polynomial):
        """Return the sign of a polynomial; with a root in it a value of 60 zeros is zero."""
        if polynomial not in self._signs:
            search, value = self._search, self._value(polynomial)
            if polynomial.free_symbols & search.form.definitions.keys():
                is_zero = abs(value) < NOTHING
            else:
                is_zero = (
                    polynomial == 0 or search.elimination.factors(polynomial) & self.cell.vanishing
                )
            self._signs[polynomial] = 0 if is_zero else sign(value)
        return self._signs[polynomial]

    def truth(self, node):
        """Return whether a condition in polynomial form holds."""
        with mpmath.workdps(DIGITS):
            return self._truth(node)

    def _truth(self, node):
        if node in (sp.true, sp.false):
            return bool(node)
        if isinstance(node, Relational):
            numerator, denominator = as_fraction(node.lhs - node.rhs)
            below = self.sign(denominator)
            return below != 0 and OPERATORS[type(node)](self.sign(numerator) * below, 0)
        if isinstance(node, sp.And):
            return all(map(self._truth, node.args))
        if isinstance(node, sp.Or):
            return any(map(self._truth, node.args))
        if isinstance(node, sp.Not):
            return not self._truth(node.args[0])
        if isinstance(node, sp.Xor):
            return sum(map(self._truth, node.args)) % 2 == 1
        if isinstance(node, sp.ITE):
            return self._truth(node.args[1 if self._truth(node.args[0]) else 2])
        raise Undecidable

    def exact(self):
        """Return exact numbers of the parameters, and of the unknowns unless all are meant."""
        search = self._search
        return tuple(
            self._exact(symbol)
            for symbol in [*search.parameters, *(() if search.case.every else search.case.unknowns)]
        )

    def _exact(self, symbol):
        if symbol in self._search.straight:
            return sp.pi
        variable = self._search.variables[symbol]
        number = (
            self.cell.point[variable].exact
            if variable in self.cell.point
            else sp.Integer(_default(variable))
        )
        if variable is symbol:
            return number
        angle = 2 * sp.atan(number)
        return angle + 2 * sp.pi if symbol in self._search.case.angles and number < 0 else angle


def _default(symbol):
    return -1 if symbol.is_negative or symbol.is_nonpositive else 1


@functools.lru_cache(maxsize=1024)
def _numeric_terms(polynomial):
    with mpmath.workdps(DIGITS):
        return [
            (mpmath.mpf(c.p) / c.q, symbols)
            for c, symbols in ((sp.Rational(text), symbols) for text, symbols in terms(polynomial))
        ]
