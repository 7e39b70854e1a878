"""Decide whether a condition agrees with its reference by one point of each cell of a decomposition.

It serves where z3 is absent or gives up. A value at a point is computed to many digits; that a
polynomial vanishes there is known from the decomposition, exactly. Where a condition is false at a
point of the first variables already, no cells above it are made.
"""

import functools
import itertools

import mpmath
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.tools.conditions.decomposition import Cell, Decomposition
from workbook.checks.tools.conditions.elimination import Elimination, half_tangent
from workbook.checks.tools.conditions.evaluation import NOTHING, OPERATORS, sign
from workbook.checks.tools.conditions.polynomial_form import (
    PolynomialForm,
    Undecidable,
    as_fraction,
    polynomial_case,
    terms,
)
from workbook.checks.tools.conditions.real_roots import DIGITS
from workbook.checks.tools.conditions.reference_condition import Case


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
    solved = {} if case.every else _solved_angle(form, condition, case.unknowns)
    for angle, values in solved.items():
        condition = condition.xreplace(dict(zip(form.circles.pop(angle), values)))
        condition = sp.And(condition, sp.Eq(sum(value**2 for value in values), 1))
    # what holds for every angle holds for those that are not pi
    angles = [a for a in form.circles if not (case.every and a in case.unknowns)]
    for count in range(len(angles) + 1):
        for straight in itertools.combinations(angles, count):
            search = _Search(form, frozenset(straight), parameters, case, others, solved)
            yield from search.points(claimed, condition)


def _solved_angle(form, condition, unknowns):
    """Return {angle: (cosine, sine)} of an unknown that two linear equations determine, or {}.

    Without its half-angle tangent a decomposition has one variable less, and lower degrees.
    """
    equations = [
        as_fraction(part.lhs - part.rhs)[0]
        for part in sp.And.make_args(condition)
        if isinstance(part, sp.Eq)
    ]
    added = {*form.definitions}.union(*form.circles.values())
    for angle in (a for a in unknowns if a in form.circles):
        circle = form.circles[angle]
        linear = [e for e in equations if sp.Poly(e, *circle).total_degree() == 1]
        for pair in itertools.combinations(linear, 2):
            matrix, right = sp.linear_eq_to_matrix(pair, *circle)
            if not matrix.det().is_nonzero:
                continue
            values = matrix.LUsolve(right)
            if not values.free_symbols & added:
                return {angle: tuple(values)}
    return {}


def points_of_cells(condition, parameters):
    """Yield points of cells on which a condition does not change: dicts of exact numbers."""
    try:
        form = PolynomialForm()
        search = _Search(form, frozenset(), parameters, Case(sp.true), ())
        condition = form.condition(condition)
        space = Decomposition(*search.borders([condition]))
        cells = [Cell()]
        for _ in space.symbols:
            cells = itertools.chain.from_iterable(map(space.above, cells))
        for cell in cells:
            yield dict(zip(parameters, _Values(cell, space, search).exact()))
    except (Undecidable, sp.PolynomialError, ArithmeticError, NotImplementedError):
        return


def cells_of_symbol(symbol, claim, parameters, case):
    """Return numbers of a symbol, one of each cell off whose ends agreement does not change.

    Parameters
    ----------
    symbol : sympy.Symbol
        A symbol of the claim.
    claim : sympy condition
        The claim in this symbol, the parameters and others.
    parameters : list of sympy.Symbol
        The parameters.
    case : Case
        The case of the reference.

    Returns
    -------
    tuple
        The exact numbers, and whether all cells are among them.
    """
    form, condition = polynomial_case(case.condition, case.angles)
    form = form.copy()
    claimed = form.condition(claim)
    others = claim.free_symbols.difference(parameters)
    search = _Search(form, frozenset(), parameters, case, sorted(others, key=str))
    borders, symbols = search.borders([claimed, condition])
    ordered = sorted(symbols, key=lambda s: s is not symbol)
    space = Decomposition(borders, ordered)
    if ordered[:1] != [symbol]:
        return [], True
    return [cell.coordinates[0].exact for cell in space.above(Cell())], space.is_complete


class _Search:
    """The decomposition for one case, with some of its angles equal to pi."""

    def __init__(self, form, straight, parameters, case, others, solved=None):
        self.form, self.straight, self.case, self.solved = form, straight, case, solved or {}
        self.elimination = Elimination(form, straight)
        self.parameters = list(parameters)
        self.variables = {
            s: half_tangent(s) if s in form.circles else s
            for s in [*parameters, *others, *case.unknowns]
            if s not in straight and s not in self.solved
        }

    def borders(self, conditions):
        """Return the polynomials on whose zeros conditions may change, and their variables."""
        borders = self.elimination.borders(conditions)
        borders |= {s for s in self.variables.values() if _has_sign(s)}
        used = set().union(*(factor.free_symbols for factor in borders))
        symbols = [t for t in self.variables.values() if t in used]
        if used - set(symbols) or any(s.is_integer for s in symbols):
            raise Undecidable
        # unknowns are projected away first, and what occurs in low powers only
        unknowns = {self.variables.get(s) for s in self.case.unknowns}
        return borders, sorted(symbols, key=lambda s: (s in unknowns, -_degree(borders, s)))

    def points(self, claimed, condition):
        """Yield points as `points_of_difference` does."""
        every = self.case.every
        borders, symbols = self.borders([*claimed, condition])
        inner = {self.variables.get(s) for s in self.case.unknowns} if every else set()
        space = Decomposition(borders, symbols)
        outer = len([s for s in symbols if s not in inner])
        required = [*claimed] if every else [*claimed, condition]

        def search(cell):
            values = _Values(cell, space, self)
            truth_values = [values.truth(part) for part in required]
            if False in truth_values:
                return
            if len(cell.coordinates) < outer:
                for upper in space.above(cell):
                    yield from search(upper)
            elif not every or holds_above(cell):
                yield values.exact()

        def holds_above(cell):
            truth = _Values(cell, space, self).truth(condition)
            return all(map(holds_above, space.above(cell))) if truth is None else truth

        yield from search(Cell())
        if not space.is_complete:
            raise Undecidable


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
    """Values of the symbols of a polynomial form at the point of a cell, as far as it has any."""

    def __init__(self, cell, space, search):
        self._cell, self._search, self._signs = cell, search, {}
        self.coordinates = dict(zip(space.symbols, cell.coordinates))
        self._open = set(space.symbols[len(cell.coordinates) :])

    @functools.cached_property
    def _numbers(self):
        """Numbers of the symbols that have one; None of those that have none yet."""
        numbers = {symbol: x.number for symbol, x in self.coordinates.items()}
        for symbol in self._search.variables.values():
            free = None if symbol in self._open else mpmath.mpf(_default(symbol))
            numbers.setdefault(symbol, free)
        for angle, (cosine, sine) in self._search.form.circles.items():
            if angle in self._search.straight:
                numbers[cosine], numbers[sine] = mpmath.mpf(-1), mpmath.mpf(0)
            else:
                t = numbers[half_tangent(angle)]
                numbers[cosine] = None if t is None else (1 - t**2) / (1 + t**2)
                numbers[sine] = None if t is None else 2 * t / (1 + t**2)
        return numbers

    def _number(self, symbol):
        if symbol not in self._numbers:
            self._numbers[symbol] = self._defined(*self._search.form.definitions[symbol])
        return self._numbers[symbol]

    def _defined(self, kind, base, degree=1):
        numerator, denominator = as_fraction(base)
        signs = self.sign(numerator), self.sign(denominator)
        if None in signs:
            return None
        if 0 in signs:  # zero, or without a value
            return mpmath.mpf(0)
        if kind == "sign":
            return mpmath.mpf(signs[0] * signs[1])
        value = self._value(numerator) / self._value(denominator)
        if kind == "root":
            return mpmath.root(value, degree) if value > 0 else mpmath.mpf(0)
        return abs(value) if kind == "size" else value

    def _value(self, polynomial):
        return sum(
            coefficient * mpmath.fprod(map(self._number, symbols))
            for coefficient, symbols in _numeric_terms(polynomial)
        )

    def sign(self, polynomial):
        """Return the sign of a polynomial; with a root in it a value of 60 zeros is zero."""
        if polynomial not in self._signs:
            self._signs[polynomial] = self._sign(polynomial)
        return self._signs[polynomial]

    def _sign(self, polynomial):
        search = self._search
        if any(self._number(symbol) is None for symbol in polynomial.free_symbols):
            return None
        value = self._value(polynomial)
        if polynomial.free_symbols & search.form.definitions.keys():
            return 0 if abs(value) < NOTHING else sign(value)
        is_zero = polynomial == 0 or search.elimination.factors(polynomial) & self._cell.vanishing
        return 0 if is_zero else sign(value)

    def truth(self, node):
        """Return whether a condition in polynomial form holds; None if that is open."""
        with mpmath.workdps(DIGITS):
            return self._truth(node)

    def _truth(self, node):
        if node in (sp.true, sp.false):
            return bool(node)
        if isinstance(node, Relational):
            numerator, denominator = map(self.sign, as_fraction(node.lhs - node.rhs))
            if denominator == 0:
                return False
            if numerator is None or denominator is None:
                return None
            return OPERATORS[type(node)](numerator * denominator, 0)
        if isinstance(node, (sp.And, sp.Or)):
            absorbing = isinstance(node, sp.Or)
            truth_values = set()
            for part in node.args:
                truth_values.add(self._truth(part))
                if absorbing in truth_values:
                    return absorbing
            return None if None in truth_values else not absorbing
        if isinstance(node, sp.ITE):
            test, yes, no = node.args
            return self._truth(sp.Or(sp.And(test, yes), sp.And(sp.Not(test), no)))
        truth_values = list(map(self._truth, node.args))
        if None in truth_values:
            return None
        if isinstance(node, sp.Not):
            return not truth_values[0]
        if isinstance(node, sp.Xor):
            return sum(truth_values) % 2 == 1
        raise Undecidable

    def exact(self):
        """Return exact numbers of the parameters, and of the unknowns unless all are meant."""
        search = self._search
        return tuple(
            self._exact(symbol)
            for symbol in [*search.parameters, *(() if search.case.every else search.case.unknowns)]
        )

    def _exact(self, symbol):
        search = self._search
        if symbol in search.straight:
            return sp.pi
        if symbol in search.solved:
            used = sp.Tuple(*search.solved[symbol])
            cosine, sine = used.xreplace({s: self._exact(s) for s in used.free_symbols})
            return sp.atan2(sine, cosine) + (
                2 * sp.pi if symbol in search.case.angles and sine < 0 else 0
            )
        variable = search.variables[symbol]
        number = (
            self.coordinates[variable].exact
            if variable in self.coordinates
            else sp.Integer(_default(variable))
        )
        if variable is symbol:
            return number
        angle = 2 * sp.atan(number)
        return angle + 2 * sp.pi if symbol in search.case.angles and number < 0 else angle


def _default(symbol):
    return -1 if symbol.is_negative or symbol.is_nonpositive else 1


@functools.lru_cache(maxsize=1024)
def _numeric_terms(polynomial):
    with mpmath.workdps(DIGITS):
        return [
            (mpmath.mpf(c.p) / c.q, symbols)
            for c, symbols in ((sp.Rational(text), symbols) for text, symbols in terms(polynomial))
        ]
