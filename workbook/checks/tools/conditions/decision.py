"""Decide whether a condition agrees with its reference everywhere, by z3 (nlsat) or by cells.

Jovanovic and de Moura 2012. A question has a fixed number of z3's own steps, so the same one always
ends the same way. Where it is undecided, or z3 absent, `cell_search` is asked. A difference is
evaluated again, exactly, before it is reported: "wrong" never rests on a solver.

Both have a place, by `benchmarks/deciders.py`: a page has no z3, and cells leave 5 of 144 conditions to
samples, in four to six symbols, for which they take 1.4 to 3.3 s and z3 at most 0.2 s. Elsewhere the
medians are 12 to 26 ms by z3 and 5 to 105 ms by cells. The numbers that several decimals stand for
are found by z3 in three tests of `test_conditions.py` where cells do not find them.
"""

import functools
import itertools
import math
import operator
from contextlib import suppress

import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.tools.conditions.cell_search import cells_of_symbol, points_of_difference
from workbook.checks.tools.conditions.evaluation import (
    DIGITS,
    NOTHING,
    OPERATORS,
    allowed,
    prepared,
    sign,
)
from workbook.checks.tools.conditions.polynomial_form import (
    PolynomialForm,
    Undecidable,
    as_fraction,
    polynomial_case,
    terms,
)

#: z3's own steps before a question counts as undecided: so many, or more where its polynomials are
#: small, so many times their size; and its megabytes. What is decided takes hundreds of them, at
#: most some 40,000. With large polynomials a single step may take so long that minutes would go by.
STEPS, TIMES_SIZE, MEGABYTES = 200_000, 5_000_000, 300
#: Points that may differ, of which so many are evaluated exactly.
MOST_POINTS = 20
#: Changes of a coordinate, to leave a border of the reference.
STEPS_ASIDE = [sp.Rational(1, q) for q in (1, 2, 10, 100)]
#: Combinations of numbers that decimals may stand for, of which so many are tried.
MOST_COMBINED = 60


def find_difference(readings, parameters, reference, restriction=sp.true):
    """Return (decided, difference) of a claim and its reference.

    Parameters
    ----------
    readings : list
        Readings of the claim; a point counts if all of them are wrong there.
    parameters : list of sympy.Symbol
        Its symbols.
    reference : ReferenceCondition
        Where the condition has to hold.
    restriction : sympy condition
        A condition that the point also has to satisfy.

    Returns
    -------
    tuple
        Whether it could be decided, and (values, what holds) or None.
    """
    if not reference.inside or not reference.outside:
        return False, None
    decided = True
    for case, holds in reference.cases:
        try:
            for point in _points(readings, parameters, case, holds, restriction):
                with suppress(ArithmeticError):  # a point that cannot be evaluated exactly
                    difference = _simplified(point, readings, parameters, case, holds, reference)
                    if difference:
                        return True, difference
                decided = False
        except (Undecidable, sp.PolynomialError, ArithmeticError, NotImplementedError):
            decided = False
    return decided, None


def _points(readings, parameters, case, holds, restriction):
    """Return points where all readings are wrong in a case; if there are none, none exists."""
    try:
        point = _Question(parameters, case).answer(readings, holds, restriction)
    except Undecidable:
        points = points_of_difference(readings, parameters, case, holds, restriction)
        return itertools.islice(points, MOST_POINTS)
    return [] if point is None else [point]


def find_numbers(claim, intervals, parameters, reference):
    """Return (decided, numbers) with which a claim agrees with its reference everywhere.

    Parameters
    ----------
    claim : sympy condition
        The claim in its symbols and in those of `intervals`.
    intervals : dict
        {symbol: (low, high)}, between which its number is looked for.
    parameters : list of sympy.Symbol
        The symbols of the claim.
    reference : ReferenceCondition
        Where the condition has to hold.

    Returns
    -------
    tuple
        Whether it could be decided, and {symbol: exact number} or None.
    """
    try:
        if not reference.inside or not reference.outside:
            raise Undecidable
        questions = [(_Question(parameters, case), holds) for case, holds in reference.cases]
        first = questions[0][0]
        formulas = [first.between(*item) for item in intervals.items()]
        shared_names = {}  # a number such as pi has one symbol in all of them
        for question, _ in questions[1:]:
            question.context, question.names = first.context, {s: first.names[s] for s in intervals}
        for question, holds in questions:
            formulas += question.agreement(claim, intervals, holds)
            for number, symbol in question.form.numbers.items():
                name = question.names[symbol]
                formulas.append(name == shared_names.setdefault(number, name))
        model = first.model(formulas, quantified=True)
        return True, model and {symbol: first.value(model, symbol) for symbol in intervals}
    except (Undecidable, sp.PolynomialError, ArithmeticError, NotImplementedError):
        pass
    try:
        return _find_numbers_by_cells(claim, intervals, parameters, reference)
    except (Undecidable, sp.PolynomialError, ArithmeticError, NotImplementedError):
        return False, None


def _find_numbers_by_cells(claim, intervals, parameters, reference):
    """Return what `find_numbers` does, by trying a number of each cell in each interval."""
    if not reference.inside or not reference.outside:
        return False, None
    is_decided, lines = len([e for e in intervals.values() if e != (0, 1)]) == 1, []
    for symbol, (low, high) in intervals.items():
        numbers = {sp.sympify(low), sp.sympify(high)}
        for case, _ in reference.cases if (low, high) != (0, 1) else ():
            cells, is_complete = cells_of_symbol(symbol, claim, parameters, case)
            numbers.update(number for number in cells if low < number < high)
            is_decided = is_decided and is_complete
        lines.append(sorted(numbers))
    if math.prod(map(len, lines)) > MOST_COMBINED:
        return False, None
    for chosen in itertools.product(*lines):
        numbers = dict(zip(intervals, chosen))
        decided, difference = find_difference([claim.xreplace(numbers)], parameters, reference)
        if decided and difference is None:
            return True, numbers
        is_decided = is_decided and decided
    return is_decided, None


def _confirmed(point, readings, parameters, case, holds, reference):
    """Return whether at a point all readings are wrong, by exact evaluation."""
    symbols = [*parameters, *case.unknowns]
    parameter_values = point[: len(parameters)]
    if not all(allowed(p, sign(x)) for p, x in zip(symbols, point)):
        return False
    if any(
        prepared(reading, tuple(parameters)).holds(parameter_values) == holds
        for reading in readings
    ):
        return False
    if case.every:
        return (
            reference.at is not None
            and reference.at(dict(zip(parameters, parameter_values))) is holds
        )
    return prepared(case.condition, tuple(symbols)).holds(point)


def _simplified(point, readings, parameters, case, holds, reference):
    """Return a confirmed difference at values of the parameters as simple as possible, or None."""

    def confirm(point):
        return _confirmed(point, readings, parameters, case, holds, reference)

    if not confirm(point):
        return None
    # With unknowns every coordinate hangs on the others, so the point stays as it is.
    if not case.unknowns or case.every:
        point = _simplest(point, confirm, lambda p: _is_inner(dict(zip(parameters, p)), case))
    return dict(zip(parameters, point)), holds


def _simplest(point, confirm, is_inner):
    """Return a confirmed point with simple coordinates, on no border if one is found beside it.

    A point on a border of the reference would give the border away.
    """
    if not is_inner(point):
        point = next((p for p in _beside(point) if is_inner(p) and confirm(p)), point)
    keeps = is_inner if is_inner(point) else lambda p: True
    for k, x in enumerate(point):
        for q in (1, 2, 10, 100, 1000):
            rational = sp.Rational(round(float(x) * q), q) if abs(float(x)) < 1e12 else x
            simpler = (*point[:k], rational, *point[k + 1 :])
            if rational == x or (confirm(simpler) and keeps(simpler)):
                point = simpler
                break
    return point


def _is_inner(values, case):
    """Return whether values of the parameters are on no border of a case."""
    borders = (
        relation.lhs - relation.rhs
        for relation in case.condition.atoms(Relational)
        if relation.free_symbols <= values.keys()
    )
    return not any(_vanishes(border.xreplace(values)) for border in borders)


def _vanishes(number):
    """Return whether a number is zero; one that is undefined is not."""
    for digits, size in ((15, 1e-6), (DIGITS, NOTHING)):
        magnitude = abs(sp.N(number, digits))
        if magnitude is sp.nan or magnitude >= size:
            return False
    return True


def _beside(point):
    """Yield points that differ from a point in one coordinate by a simple number."""
    for step in STEPS_ASIDE:
        for k, x in enumerate(point):
            yield from ((*point[:k], x + change, *point[k + 1 :]) for change in (step, -step))


class _Question:
    """A question to z3: is there a point where all readings of a claim are wrong in one case?

    It has a context of its own, so that no earlier question changes the count of steps.
    """

    def __init__(self, parameters, case):
        try:
            import z3  # here, since only a verdict on a condition needs it
        except ImportError:
            # where it does not run, as in some browsers, samples have to do
            raise Undecidable from None
        self.z3, self.context, self.parameters, self.case = z3, z3.Context(), parameters, case
        self.names, self.form, self.size = {}, PolynomialForm(case.angles), 10

    def answer(self, readings, holds, restriction):
        """Return exact numbers of the parameters and the unknowns, or None without such a point."""
        z3, case = self.z3, self.case
        if not case.every:
            self.form, condition = polynomial_case(case.condition, case.angles)
            self.form = self.form.copy()
        claims = [self._formula(self.form.condition(reading)) for reading in readings]
        conditions = [z3.Not(claim) if holds else claim for claim in claims]
        conditions.append(self._formula(self.form.condition(restriction)))
        claim_symbols = {*self.parameters, *self.names}
        first = len(self.form.sides)
        case_formula = self._formula(
            self.form.condition(case.condition) if case.every else condition
        )
        sides = [self._formula(side) for side in self.form.sides]
        inner = (
            [symbol for symbol in self.names if symbol not in claim_symbols] if case.every else []
        )
        if inner:
            conditions += sides[:first]
            assumed = [*sides[first:], *(self._assumed(symbol) for symbol in inner)]
            case_formula = z3.ForAll(
                [self.names[s] for s in inner], z3.Implies(self._and(assumed), case_formula)
            )
        else:
            conditions += sides
        conditions += [self._assumed(symbol) for symbol in self.names if symbol not in inner]
        model = self.model([*conditions, case_formula], quantified=bool(inner))
        symbols = [*self.parameters, *(() if case.every else case.unknowns)]
        return None if model is None else tuple(self.value(model, symbol) for symbol in symbols)

    def agreement(self, claim, chosen, holds):
        """Return formulas that, for all but the chosen numbers, a claim is `holds` in the case."""
        z3, case = self.z3, self.case
        claimed = self._formula(self.form.condition(claim))
        claim_symbols, first = {*self.parameters, *self.names}, len(self.form.sides)
        assumed = self._formula(self.form.condition(case.condition))
        numbers = {*chosen, *self.form.numbers.values()}
        free = [symbol for symbol in self.names if symbol not in numbers]
        outer = [symbol for symbol in free if symbol in claim_symbols or not case.every]
        inner = [symbol for symbol in free if symbol not in outer]
        sides = [(side, self._formula(side)) for side in self.form.sides]
        number_conditions = [formula for side, formula in sides if side.free_symbols <= numbers]
        before, after = (
            [formula for side, formula in part if not side.free_symbols <= numbers]
            for part in (sides[:first], sides[first:])
        )
        if inner:
            assumptions = self._and([*after, *map(self._assumed, inner)])
            assumed = z3.ForAll([self.names[s] for s in inner], z3.Implies(assumptions, assumed))
        else:
            before += after
        assumptions = self._and([*before, *map(self._assumed, outer), assumed])
        agrees = z3.Implies(assumptions, claimed if holds else z3.Not(claimed))
        return [
            *number_conditions,
            z3.ForAll([self.names[s] for s in outer], agrees) if outer else agrees,
        ]

    def between(self, symbol, ends):
        """Return the formula that a symbol has a value of a closed interval."""
        low, high = (self.z3.RealVal(str(end), self.context) for end in ends)
        return self._and([low <= self._real(symbol), self._real(symbol) <= high])

    def model(self, question, quantified):
        """Return values that fulfil formulas, or None without any."""
        z3 = self.z3
        names = (
            ("simplify", "nlqsat")
            if quantified
            else ("simplify", "propagate-values", "qfnra-nlsat")
        )
        solver = z3.Then(
            *(z3.Tactic(name, self.context) for name in names), ctx=self.context
        ).solver()
        solver.set("rlimit", max(STEPS, TIMES_SIZE // self.size))
        solver.set("max_memory", MEGABYTES)
        solver.add(*question)
        try:
            outcome = solver.check()
        except z3.Z3Exception:
            raise Undecidable from None
        if outcome == z3.unknown:
            raise Undecidable
        return solver.model() if outcome == z3.sat else None

    def _formula(self, node):
        z3 = self.z3
        if node in (sp.true, sp.false):
            return z3.BoolVal(bool(node), self.context)
        if isinstance(node, Relational):
            numerator, denominator = (
                self._polynomial(part) for part in as_fraction(node.lhs - node.rhs)
            )
            side = numerator if isinstance(node, (sp.Eq, sp.Ne)) else numerator * denominator
            return z3.And(denominator != 0, OPERATORS[type(node)](side, 0))
        parts = [self._formula(part) for part in node.args]
        join = {
            sp.And: z3.And,
            sp.Or: z3.Or,
            sp.Not: z3.Not,
            sp.ITE: z3.If,
            sp.Xor: lambda *parts: functools.reduce(z3.Xor, parts),
        }[type(node)]
        return join(*parts)

    def _polynomial(self, expression):
        summands, written = [], terms(expression)
        self.size = max(
            self.size, len(written) * max((len(symbols) for _, symbols in written), default=0)
        )
        for coefficient, symbols in written:
            term = self.z3.RealVal(coefficient, self.context)
            for symbol in symbols:
                term = term * self._real(symbol)
            summands.append(term)
        return functools.reduce(lambda a, b: a + b, summands)

    def _real(self, symbol):
        if symbol not in self.names:
            if symbol.is_integer or symbol.is_real is False:
                raise Undecidable
            self.names[symbol] = self.z3.FreshReal("v", self.context)
        return self.names[symbol]

    def _assumed(self, symbol):
        return self._and(
            [
                operation(self.names[symbol], 0)
                for holds, operation in (
                    (symbol.is_positive, operator.gt),
                    (symbol.is_negative, operator.lt),
                    (symbol.is_nonnegative, operator.ge),
                    (symbol.is_nonpositive, operator.le),
                    (symbol.is_nonzero, operator.ne),
                )
                if holds
            ]
        )

    def _and(self, parts):
        return self.z3.And(self.z3.BoolVal(True, self.context), *parts)

    def value(self, model, symbol):
        """Return the exact value of a symbol."""
        if symbol in self.form.circles:
            c, s = (self.value(model, part) for part in self.form.circles[symbol])
            return sp.atan2(s, c) + (2 * sp.pi if symbol in self.case.angles and s < 0 else 0)
        if symbol not in self.names:
            return sp.Integer(-1 if symbol.is_negative or symbol.is_nonpositive else 1)
        value = model.eval(self.names[symbol], model_completion=True)
        if self.z3.is_rational_value(value):
            return sp.Rational(str(value.as_fraction()))
        coefficients = [int(str(c)) for c in value.poly()]
        return sp.rootof(sp.Poly(coefficients[::-1], sp.Symbol("t")), value.index() - 1)
