"""A student's condition against the true one: decided for all values at once wherever that can be done.

What is true comes as two cases: `inside`, where the condition has to hold, and `outside`, where it must not; where
neither is so, both will do. A case is a condition in the parameters and further unknowns (a state of rest, a root) and
means that such unknowns exist, or, with `every`, that it is so for all of them. Polynomial conditions are decided by z3
(nlsat, Jovanovic and de Moura 2012) within a fixed number of its own steps, so the same question always ends the same
way. What z3 names as a difference is evaluated again, exactly, before it is told: "wrong" never rests on a solver.
Samples are left for what is not polynomial, or too large; the verdict then says at how many points it agrees.
"""

import functools
import itertools
import math
import operator
from dataclasses import dataclass
from fractions import Fraction

import mpmath
import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import Invalid, Wrong

#: z3's own steps before a question counts as undecided: so many, or more where its polynomials are small, so many times
#: their size; and its megabytes. What is decided takes hundreds of them, at most some 40,000. With large polynomials a
#: single step may take so long that minutes would go by.
STEPS, TIMES_SIZE, MEGABYTES = 200_000, 5_000_000, 300
#: Digits that terms are computed to where a value is irrational, and how small a zero is there.
DIGITS, NOTHING = 60, mpmath.mpf(10) ** -40
#: Terms larger than this a solver is not asked about.
LARGEST_DEGREE, MOST_TERMS, MOST_WRITTEN_OUT = 40, 4000, 20_000
#: The greatest of more terms would be written with twice as many absolute values for each.
MOST_COMPARED = 5
#: The product of the degrees of algebraic numbers up to which a value is told from zero exactly.
LARGEST_FIELD = 8
#: The "sign" of a number that is not real.
NOT_REAL = "not real"
HOW = {sp.Gt: operator.gt, sp.Ge: operator.ge, sp.Lt: operator.lt, sp.Le: operator.le, sp.Eq: operator.eq,
       sp.Ne: operator.ne}
REVERSED = {sp.Gt: sp.Lt, sp.Ge: sp.Le, sp.Lt: sp.Gt, sp.Le: sp.Ge}


@dataclass(frozen=True)
class Case:
    """The parameters for which `condition` holds for some values of `unknowns`, or for every one of them.

    `angles` are those symbols that run from 0 to 2 pi, without the end: then they may be compared with other angles.
    """

    condition: object
    unknowns: tuple = ()
    every: bool = False
    angles: tuple = ()


@dataclass(frozen=True)
class Truth:
    """Where a condition has to hold and where it must not, cases each; `at(values)` says so at one point: True, False,
    None.

    `at` serves where nothing can be decided, at `points()` or else along lines, and confirms what is said of every
    value of an unknown. A truth that only `at` knows has no cases.
    """

    inside: tuple = ()
    outside: tuple = ()
    at: object = None
    points: object = None

    @property
    def cases(self):
        return [*((case, True) for case in self.inside), *((case, False) for case in self.outside)]


def exactly(condition, given=sp.true, unknowns=(), at=None, points=None):
    """The truth `condition` at all parameters and unknowns with `given`; elsewhere either will do. Where it is None, no
    closed form being known, there is nothing but `at`."""
    if condition is None:
        return Truth(at=at, points=points)
    inside, outside = ((Case(sp.And(given, part), tuple(unknowns)),) for part in (condition, sp.Not(condition)))
    return Truth(inside, outside, at, points)


def read_condition(answer, parameters, truth):
    """A condition on parameters; a set of numbers stands for values of the one that the truth depends on, or of the
    first of several."""
    numbers = isinstance(answer, sp.Set) and not answer.has(sp.ConditionSet, sp.ProductSet)
    if numbers and len(parameters) > 1 and answer.is_subset(sp.S.Reals):
        asked = set().union(*(case.condition.free_symbols for case, _ in truth.cases))
        parameters = [p for p in parameters if p in asked] or parameters
        return coercion.as_condition(answer, parameters[:1])
    return coercion.as_condition(answer, parameters)


def contrary(reason):
    """The message that a condition says otherwise at a place, with the `reason(values)`."""
    def told(values, holds):
        return f"your condition {'does not hold' if holds else 'holds'} for {place_text(values)}; {reason(values)}"

    return told


def compare(answer, parameters, truth, told):
    """Compare a student's condition, in any form that is read, with the truth.

    Returns how the agreement is known, for the end of a sentence. `told(values, holds)` is the message at a place,
    given as SymPy numbers, where the truth is `holds` and the claim says otherwise.
    """
    parameters = list(parameters)
    said = readings(read_condition(answer, parameters, truth))
    decided, place = _decided(said[:1], parameters, truth)
    if decided and place and len(said) > 1:
        # Decimals stand for all numbers that round to them, but a border that they meet exactly is not rounded.
        off_border = [sp.Ne(atom.lhs, atom.rhs) for atom in said[0].atoms(Relational) if _is_finite(atom)]
        decided, elsewhere = _decided(said[:1], parameters, truth, sp.And(*off_border))
        if decided and elsewhere:
            decided, place = _decided(said, parameters, truth)
    if decided and place is None:
        return "proved for all values"
    count = 0
    if not decided:
        place, count = _sampled(said, parameters, truth)
    if place is not None:
        values, holds = place
        raise Wrong(told(values, holds))
    return f"agrees at {count} points"


def decide(condition, symbols, truth):
    """(whether it could be decided, where a condition is not as the truth: (values, what holds), or None)."""
    return _decided([condition], list(symbols), truth)


class Condition:
    """A condition in given symbols that can be evaluated at exact numbers."""

    def __init__(self, condition, symbols):
        self.symbols = list(symbols)
        self.condition = sp.to_nnf(condition, simplify=False) if condition.has(sp.Implies, sp.Equivalent) else condition
        self._atoms = {atom: _sign_of(atom, tuple(self.symbols)) for atom in self.condition.atoms(Relational)}

    def holds(self, place):
        """The truth value at a place, exact numbers in a row; where a term is undefined the condition does not hold."""
        return self._truth(self.condition, tuple(place))

    def borders(self, base, varied):
        """Where a term can change its sign along one symbol from `base`: floats, of rational terms alone."""
        return sorted({root for sign in self._atoms.values() for root in sign.roots(tuple(base), varied)})

    def _truth(self, node, place):
        if node in (sp.true, sp.false):
            return bool(node)
        if isinstance(node, Relational):
            return _compared(node, self._atoms[node](place))
        if isinstance(node, sp.And):
            return all(self._truth(part, place) for part in node.args)
        if isinstance(node, sp.Or):
            return any(self._truth(part, place) for part in node.args)
        if isinstance(node, sp.Not):
            return not self._truth(node.args[0], place)
        if isinstance(node, sp.Xor):
            return sum(self._truth(part, place) for part in node.args) % 2 == 1
        if isinstance(node, sp.ITE):
            test, yes, no = node.args
            return self._truth(yes if self._truth(test, place) else no, place)
        raise Invalid("expected inequalities joined by And, Or and Not")


def place_text(values):
    """A place for a message: `k1 = 1/2, k2 = -3`."""
    return ", ".join(f"{p} = {x if x.is_Rational and x.q < 1000 else f'{float(x):.6g}'}" for p, x in values.items())


def allowed(symbol, sign):
    """Whether a value of this sign agrees with what is assumed of a symbol."""
    return not (symbol.is_positive and sign <= 0 or symbol.is_negative and sign >= 0 or symbol.is_nonnegative
                and sign < 0 or symbol.is_nonpositive and sign > 0 or symbol.is_nonzero and sign == 0)


class _Sign:
    """The sign of the difference of the sides of a relation, -1, 0 or 1, NOT_REAL, or None where it is undefined."""

    def __init__(self, relation, symbols):
        self.symbols, self._numeric, self._parts = symbols, None, None
        difference = _rational(relation.lhs - relation.rhs)
        if difference.is_rational_function(*symbols):
            parts = sp.fraction(sp.together(difference))
            if all(sp.Poly(part, *symbols).domain in (sp.ZZ, sp.QQ) for part in parts):
                # Whole coefficients, so that fractions stay fractions in the code that is made of them.
                cleared = [sp.Poly(part, *symbols).clear_denoms(convert=True) for part in parts]
                self._factor = sp.prod([whole for whole, _ in cleared])
                self._polys = [poly for _, poly in cleared]
                self._parts = [sp.lambdify(symbols, poly.as_expr(), []) for poly in self._polys]
        if self._parts is None:
            # Symbols are the data's own and functions are SymPy's (coercion.with_symbols), so the code made is ours.
            self._numeric = sp.lambdify(symbols, difference, "mpmath")

    def __call__(self, place):
        if self._parts is not None and all(x.is_Rational for x in place):
            at = [Fraction(int(x.p), int(x.q)) for x in place]
            above, below = (part(*at) for part in self._parts)
            return None if below == 0 else _sign(above) * _sign(below)
        try:
            with mpmath.workdps(DIGITS):
                at = [mpmath.mpf(x.p) / x.q if x.is_Rational else mpmath.mpmathify(x.evalf(DIGITS)) for x in place]
                if self._parts is not None:
                    above, below = (self._exactly(k, place, part(*at)) for k, part in enumerate(self._parts))
                    return None if below == 0 else above * below
                number = mpmath.mpmathify(self._numeric(*at))
        except (ZeroDivisionError, ValueError, TypeError, OverflowError):
            # TypeError: a Piecewise without a case for this place gives None, and complex numbers have no order.
            return None
        if mpmath.isnan(number):
            return None
        if abs(mpmath.im(number)) > NOTHING:
            return NOT_REAL
        # At 60 digits a value this small is a zero: no answer of a student lives at that scale.
        return 0 if abs(number) < NOTHING else _sign(mpmath.re(number))

    def _exactly(self, k, place, number):
        """The sign of a polynomial at algebraic numbers: a value close to zero has to have the minimal polynomial x."""
        if abs(number) >= NOTHING:
            return _sign(number)
        if math.prod(number.poly.degree() for number in sp.Tuple(*place).atoms(sp.CRootOf)) > LARGEST_FIELD:
            raise ArithmeticError("algebraic numbers of so high a degree are not computed with")
        x, value = sp.Dummy("x"), self._polys[k].as_expr().subs(dict(zip(self.symbols, place)), simultaneous=True)
        if value != 0 and value.is_algebraic and sp.minimal_polynomial(value, x) != x:
            raise ArithmeticError("a number that is not zero could not be told from it")
        return 0

    def roots(self, base, varied):
        if self._parts is None:
            return
        t = sp.Dummy("t")
        place = {s: t if k == varied else x for k, (s, x) in enumerate(zip(self.symbols, base))}
        for poly in self._polys:
            line = sp.Poly(poly.as_expr().subs(place, simultaneous=True), t)
            coefficients = [float(c) for c in line.all_coeffs()]
            if len(coefficients) > 1 and np.isfinite(coefficients).all():
                # A double root comes back as a close complex pair; its real part still separates the cells.
                yield from (float(r.real) for r in np.roots(coefficients) if abs(r.imag) < 1e-5 * (1 + abs(r)))


@functools.lru_cache(maxsize=256)
def _sign_of(relation, symbols):
    return _Sign(relation, symbols)


# Decimals

def readings(claim):
    """The claim with its decimals as they are written, and with each half a unit of the third digit up or down."""
    claim = _with_plain_powers(claim)
    decimals = sorted(claim.atoms(sp.Float), key=float)
    ranges = []
    for number in decimals:
        whole = sp.nsimplify(number, rational=True)
        # By mpmath, since it may be beyond what a float holds.
        half = sp.Rational(1, 2) * sp.Integer(10) ** (int(mpmath.floor(mpmath.log10(abs(whole)))) - 2) if whole else 0
        ranges.append((whole, whole - half, whole + half) if half else (whole,))
    exact = claim.xreplace({number: choices[0] for number, choices in zip(decimals, ranges)})
    if not any(len(choices) > 1 for choices in ranges) or len(ranges) > 4:
        return [exact]
    corners = [dict(zip(decimals, chosen)) for chosen in itertools.product(*(part[1:] or part for part in ranges))]
    # An equation with decimals stands for one that holds somewhere between the corners.
    widened = {}
    for atom in claim.atoms(sp.Eq, sp.Ne):
        if atom.has(sp.Float):
            low, high = (atom.lhs.xreplace(corner) - atom.rhs.xreplace(corner) for corner in (corners[0], corners[-1]))
            widened[atom] = low * high <= 0 if isinstance(atom, sp.Eq) else low * high > 0
    return [exact, *(claim.xreplace(corner) for corner in corners),
            *([claim.xreplace(widened).xreplace(corners[0])] if widened else [])]


def _with_plain_powers(claim):
    """Exponents in decimals as fractions: x**0.5 is a square root, not a rounded power."""
    powers = {power: sp.Pow(power.base, sp.nsimplify(power.exp, rational=True))
              for power in claim.atoms(sp.Pow) if power.exp.is_Float}
    return claim.xreplace(powers) if powers else claim


def _rational(expression):
    return sp.nsimplify(expression, rational=True) if expression.has(sp.Float) else expression


# Decisions

class _Undecidable(Exception):
    """Something that is no polynomial condition, or one too large."""


def _decided(readings, parameters, truth, besides=sp.true):
    """(decided, place): a place where all readings of a claim are wrong, as (values, what holds), or None."""
    try:
        if not truth.inside or not truth.outside:
            raise _Undecidable
        for case, holds in truth.cases:
            found = _Question(parameters, case).answer(readings, holds, besides)
            if found is not None:
                place = _simplified(found, readings, parameters, case, holds, truth)
                return (True, place) if place else (False, None)
    except (_Undecidable, sp.PolynomialError, ArithmeticError, NotImplementedError):
        return False, None
    return True, None


def _confirmed(place, readings, parameters, case, holds, truth):
    """Whether at a place, numbers of the parameters and the unknowns, all readings are wrong: by exact evaluation."""
    symbols = [*parameters, *case.unknowns]
    here = place[:len(parameters)]
    if not all(allowed(p, _sign(x)) for p, x in zip(symbols, place)):
        return False
    if any(_of(reading, tuple(parameters)).holds(here) == holds for reading in readings):
        return False
    if case.every:
        return truth.at is not None and truth.at(dict(zip(parameters, here))) is holds
    return _of(case.condition, tuple(symbols)).holds(place)


@functools.lru_cache(maxsize=64)
def _of(condition, symbols):
    return Condition(condition, symbols)


def _simplified(place, readings, parameters, case, holds, truth):
    """The values of the parameters, as simple as they can be, at a difference that exact evaluation confirms."""
    confirm = functools.partial(_confirmed, readings=readings, parameters=parameters, case=case, holds=holds,
                                truth=truth)
    if not confirm(place):
        return None
    # With unknowns every coordinate hangs on the others, so the place stays as it is.
    for k, x in enumerate(place if not case.unknowns or case.every else ()):
        for q in (1, 2, 10, 100, 1000):
            near = sp.Rational(round(float(x) * q), q) if abs(float(x)) < 1e12 else x
            simpler = (*place[:k], near, *place[k + 1:])
            if near == x or confirm(simpler):
                place = simpler
                break
    return dict(zip(parameters, place)), holds


class _Question:
    """One question to z3: is there a place where all readings of a claim are wrong in one case? It has a context of
    its own, so that no earlier question changes the count of steps."""

    def __init__(self, parameters, case):
        try:
            import z3  # here, since only a verdict on a condition needs it
        except ImportError:
            raise _Undecidable from None  # where it does not run, as in some browsers, samples have to do
        self.z3, self.context, self.parameters, self.case = z3, z3.Context(), parameters, case
        self.names, self.plain, self.size = {}, Plain(case.angles), 10

    def answer(self, readings, holds, besides):
        """A place, exact numbers of the parameters and the unknowns, or None if there is none."""
        z3, case = self.z3, self.case
        if not case.every:
            self.plain, plain = _plain_truth(case.condition, case.angles)
            self.plain = self.plain.copy()
        claims = [self._formula(self.plain.condition(reading)) for reading in readings]
        told = [z3.Not(claim) if holds else claim for claim in claims]
        told.append(self._formula(self.plain.condition(besides)))
        known = {*self.parameters, *self.names}
        first = len(self.plain.sides)
        truth = self._formula(self.plain.condition(case.condition) if case.every else plain)
        sides = [self._formula(side) for side in self.plain.sides]
        inner = [symbol for symbol in self.names if symbol not in known] if case.every else []
        if inner:
            told += sides[:first]
            given = [*sides[first:], *(self._assumed(symbol) for symbol in inner)]
            truth = z3.ForAll([self.names[s] for s in inner], z3.Implies(self._and(given), truth))
        else:
            told += sides
        told += [self._assumed(symbol) for symbol in self.names if symbol not in inner]
        model = self._model(self._and([*told, truth]), quantified=bool(inner))
        symbols = [*self.parameters, *(() if case.every else case.unknowns)]
        return None if model is None else tuple(self._value(model, symbol) for symbol in symbols)

    def _model(self, question, quantified):
        z3 = self.z3
        names = ("simplify", "nlqsat") if quantified else ("simplify", "propagate-values", "qfnra-nlsat")
        solver = z3.Then(*(z3.Tactic(name, self.context) for name in names), ctx=self.context).solver()
        solver.set("rlimit", max(STEPS, TIMES_SIZE // self.size))
        solver.set("max_memory", MEGABYTES)
        solver.add(question)
        try:
            found = solver.check()
        except z3.Z3Exception:
            raise _Undecidable from None
        if found == z3.unknown:
            raise _Undecidable
        return solver.model() if found == z3.sat else None

    def _formula(self, node):
        z3 = self.z3
        if node in (sp.true, sp.false):
            return z3.BoolVal(bool(node), self.context)
        if isinstance(node, Relational):
            above, below = (self._polynomial(part) for part in _as_fraction(node.lhs - node.rhs))
            side = above if isinstance(node, (sp.Eq, sp.Ne)) else above * below
            return z3.And(below != 0, HOW[type(node)](side, 0))
        parts = [self._formula(part) for part in node.args]
        join = {sp.And: z3.And, sp.Or: z3.Or, sp.Not: z3.Not, sp.ITE: z3.If,
                sp.Xor: lambda *parts: functools.reduce(z3.Xor, parts)}[type(node)]
        return join(*parts)

    def _polynomial(self, expression):
        terms, found = [], _terms(expression)
        self.size = max(self.size, len(found) * max((len(symbols) for _, symbols in found), default=0))
        for coefficient, symbols in found:
            term = self.z3.RealVal(coefficient, self.context)
            for symbol in symbols:
                term = term * self._real(symbol)
            terms.append(term)
        return functools.reduce(lambda one, other: one + other, terms)

    def _real(self, symbol):
        if symbol not in self.names:
            if symbol.is_integer or symbol.is_real is False:
                raise _Undecidable
            self.names[symbol] = self.z3.Real(f"v{len(self.names)}", self.context)
        return self.names[symbol]

    def _assumed(self, symbol):
        return self._and([how(self.names[symbol], 0) for assumed, how in (
            (symbol.is_positive, operator.gt), (symbol.is_negative, operator.lt), (symbol.is_nonnegative, operator.ge),
            (symbol.is_nonpositive, operator.le), (symbol.is_nonzero, operator.ne)) if assumed])

    def _and(self, parts):
        return self.z3.And(self.z3.BoolVal(True, self.context), *parts)

    def _value(self, model, symbol):
        if symbol in self.plain.circles:
            c, s = (self._value(model, part) for part in self.plain.circles[symbol])
            return sp.atan2(s, c) + (2 * sp.pi if symbol in self.case.angles and s < 0 else 0)
        if symbol not in self.names:
            return sp.Integer(-1 if symbol.is_negative or symbol.is_nonpositive else 1)
        value = model.eval(self.names[symbol], model_completion=True)
        if self.z3.is_rational_value(value):
            return sp.Rational(str(value.as_fraction()))
        coefficients = [int(str(c)) for c in value.poly()]
        return sp.rootof(sp.Poly(coefficients[::-1], sp.Symbol("t")), value.index() - 1)


@functools.lru_cache(maxsize=128)  # the same truth is asked about again and again
def _plain_truth(condition, angles):
    """A condition made plain, and what made it: the same symbols each time, so that their polynomials are known."""
    plain = Plain(angles)
    return plain, plain.condition(condition)


@functools.lru_cache(maxsize=512)
def _as_fraction(expression):
    return sp.fraction(sp.together(expression))


@functools.lru_cache(maxsize=512)
def _terms(expression):
    """A polynomial as (coefficient, symbols as often as they are factors), a pair a term."""
    symbols = sorted(expression.free_symbols, key=str)
    if not expression.is_polynomial(*symbols) or _size(expression) > MOST_WRITTEN_OUT:
        raise _Undecidable
    poly = sp.Poly(expression, *symbols or [sp.Dummy()])
    if poly.domain not in (sp.ZZ, sp.QQ) or poly.total_degree() > LARGEST_DEGREE or len(poly.terms()) > MOST_TERMS:
        raise _Undecidable
    return [(str(coefficient), [symbol for symbol, power in zip(symbols, powers) for _ in range(power)])
            for powers, coefficient in poly.terms()]


def _size(expression):
    """How many terms a polynomial may have when its powers and products are written out."""
    if isinstance(expression, sp.Add):
        return sum(map(_size, expression.args))
    if isinstance(expression, sp.Mul):
        return math.prod(map(_size, expression.args))
    if isinstance(expression, sp.Pow) and expression.exp.is_Integer and expression.exp > 0:
        return math.comb(_size(expression.base) + int(expression.exp) - 1, int(expression.exp))
    return 1


def _squares(expression):
    """The bases of a sum of even powers with positive factors, which vanishes where all of them do; otherwise None."""
    parts = [part.as_coeff_Mul() for part in sp.Add.make_args(expression)]
    even = all(factor > 0 and power.is_Pow and power.exp.is_Integer and power.exp > 0 and power.exp % 2 == 0
               for factor, power in parts)
    return [power.base for _, power in parts] if even else None


class Plain:
    """Conditions as polynomial ones in more symbols: a root, an absolute value, a point of the circle for an angle, a
    number such as pi each become a symbol; `sides` say what they are. The order of `angles`, which run from 0 to 2 pi,
    is that of points on the circle."""

    def __init__(self, angles=()):
        self.sides, self.circles, self._known, self._bare, self._angles = [], {}, {}, set(), angles

    def copy(self):
        other = Plain(self._angles)
        other.sides, other.circles = list(self.sides), dict(self.circles)
        other._known, other._bare = dict(self._known), set(self._bare)
        return other

    def condition(self, node):
        if node in (sp.true, sp.false):
            return node
        if isinstance(node, Relational):
            if not _is_finite(node):
                return _beyond_all(node)
            defined, difference = [], _rational(node.lhs - node.rhs)
            for angle in difference.free_symbols.intersection(self._angles):
                other = angle - difference / difference.coeff(angle)
                if difference.coeff(angle).is_number and not other.has(angle):
                    how = node.func if difference.coeff(angle) > 0 else REVERSED.get(node.func, node.func)
                    ordered = self._ordered(angle, how, other, defined)
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
        """That a difference with a root is not zero: where the root is not real, it is not, if nothing else is added to
        or multiplied with it that is not."""
        under = [part for part in defined if isinstance(part, sp.Ge)]
        others = [part for part in defined if part not in under]
        w = next((w for key, w in self._known.items() if isinstance(key, tuple) and key[:2] == ("root", under[0].lhs)),
                 None)
        if (w is None or not len(terms) == len(under) == 1 or not terms[0].is_polynomial(w)
                or sp.degree(terms[0], w) != 1 or not terms[0].expand().coeff(w).is_number):
            raise _Undecidable
        return sp.And(*others, sp.Or(sp.Not(under[0]), sp.Ne(terms[0], 0)))

    def _term(self, node, defined):
        if node.is_Symbol:
            self._bare.add(node)
            if node in self.circles:
                raise _Undecidable  # an angle beside its own sine
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
            return self._symbol(("root", base, q), base, lambda w: (sp.And(sp.Eq(w**q, base), w >= 0), sp.Eq(w, 0)))**p
        if isinstance(node, sp.Abs):
            base = self._term(node.args[0], defined)
            return self._symbol(("size", base), base, lambda w: (sp.Eq(w, base), sp.Eq(w, -base)))
        if isinstance(node, sp.sign):
            base = self._term(node.args[0], defined)
            return self._symbol(("sign", base), base, lambda w: (
                sp.Or(sp.And(base > 0, sp.Eq(w, 1)), sp.And(sp.Eq(base, 0), sp.Eq(w, 0))), sp.Eq(w, -1)))
        if isinstance(node, (sp.Max, sp.Min)):
            if len(node.args) > MOST_COMPARED:
                raise _Undecidable
            sign = 1 if isinstance(node, sp.Max) else -1
            return self._term(functools.reduce(lambda a, b: (a + b + sign * sp.Abs(a - b)) / 2, node.args), defined)
        if node.is_number and node.is_real:
            # A number known to so many digits tells from zero what a student writes; a difference is evaluated again.
            near, w = sp.Rational(str(node.evalf(50))), self._known.setdefault(node, sp.Dummy("number", real=True))
            self.sides += [w > near - sp.Rational(1, 10**45), w < near + sp.Rational(1, 10**45)]
            return w
        if isinstance(node, (sp.cos, sp.sin, sp.tan)):
            return self._turned(node, defined)
        raise _Undecidable

    def _ordered(self, angle, how, other, defined):
        """The relation of an angle from 0 to 2 pi to another one, in the coordinates of their points on the circle."""
        low, high = _range(other)
        if other.is_number and not 0 <= low < 2 * math.pi:
            return sp.sympify(HOW[how](0, low))
        # Both from 0 to pi and beyond pi the order is that of the cosines.
        c, s, cosine, sine = (self._term(sp.expand_trig(f(part)), defined) for part in (angle, other)
                              for f in (sp.cos, sp.sin))
        same = sp.And(sp.Eq(c, cosine), sp.Eq(s, sine))
        above = sp.And(sine >= 0, sp.Or(low <= 0, sp.Ne(cosine, 1)))  # no zero but a whole turn
        less = sp.Or(sp.And(s >= 0, sp.Not(above)), sp.And(s >= 0, above, c > cosine),
                     sp.And(s < 0, sp.Not(above), c < cosine))
        if -math.pi < low < 0 and high < math.pi:
            less, same = sp.And(sine >= 0, less), sp.And(sine >= 0, same)
        elif math.pi < low and 2 * math.pi < high < 3 * math.pi:
            less, same = sp.Or(sine >= 0, less), sp.And(sine < 0, same)
        elif not (0 <= low and high <= 2 * math.pi):
            raise _Undecidable
        return {sp.Lt: less, sp.Le: sp.Or(less, same), sp.Gt: sp.Not(sp.Or(less, same)), sp.Ge: sp.Not(less),
                sp.Eq: same, sp.Ne: sp.Not(same)}[how]

    def _symbol(self, key, base, where):
        """The symbol for something of `base`, `where(w)` where that is not negative and where it is."""
        if key not in self._known:
            w = self._known[key] = sp.Dummy("w", real=True)
            positive, negative = where(w)
            below = sp.fraction(sp.together(base))[1]
            self.sides.append(sp.Or(sp.And(base >= 0, positive), sp.And(base < 0, negative), sp.Eq(below, 0)))
        return self._known[key]

    def _turned(self, node, defined):
        (angle,) = node.args
        if not angle.is_Symbol:
            expanded = sp.expand_trig(node)
            if expanded == node:
                raise _Undecidable
            return self._term(expanded, defined)
        if angle in self._bare:
            raise _Undecidable
        if angle not in self.circles:
            self.circles[angle] = c, s = sp.Dummy("c", real=True), sp.Dummy("s", real=True)
            self.sides.append(sp.Eq(c**2 + s**2, 1))
        c, s = self.circles[angle]
        if isinstance(node, sp.tan):
            defined.append(sp.Ne(c, 0))
        return {sp.cos: c, sp.sin: s, sp.tan: s / c}[node.func]


# Samples

def _sampled(readings, parameters, truth):
    """(place, count): the first point of the samples where all readings are wrong, as (values, what holds), or None.

    Along lines on which one parameter varies, the places where the truth changes are found by bisection; it is asked
    there, on both sides, far out, and on and between all places where the claim or the truth can change.
    """
    symbols = tuple(parameters)
    claims = [_of(reading, symbols) for reading in readings]
    truth_at = truth.at or _truth_at(parameters, truth)
    seen = {}

    def at(values):
        place = tuple(values.values())
        if place not in seen:
            seen[place] = truth_at(values)
        return seen[place]

    known = [_of(case.condition, symbols) for case, _ in truth.cases if not case.unknowns]
    places = truth.points() if truth.points else (
        dict(zip(parameters, (*base[:varied], x, *base[varied + 1:]))) for base, varied in _lines(parameters)
        for x in _along(base, varied, parameters, [claims[0], *known], at))
    count = 0
    for values in places:
        holds = at(values)
        if holds is None:
            continue
        count += 1
        if all(claim.holds(values[p] for p in parameters) != holds for claim in claims):
            return (values, holds), count
    if not count:
        raise RuntimeError("no point was found to try this condition at")
    return None, count


def _truth_at(parameters, truth):
    if not truth.cases or any(case.unknowns for case, _ in truth.cases):
        raise RuntimeError("this condition could not be decided, and there is nothing to try")
    cases = [(_of(case.condition, tuple(parameters)), holds) for case, holds in truth.cases]
    return lambda values: next((holds for case, holds in cases if case.holds(values.values())), None)


def _lines(parameters, count=8):
    """Pairs (a random place, which parameter varies)."""
    random = np.random.default_rng(12)
    for k in range(count if len(parameters) > 1 else 1):
        sizes = [sp.Rational(int(random.integers(1, 60)), 20) for _ in parameters]
        yield tuple(size if allowed(p, 1) and (not allowed(p, -1) or random.integers(2)) else -size
                    for p, size in zip(parameters, sizes)), k % len(parameters)


def _along(base, varied, parameters, conditions, at):
    """Values of one parameter at which to compare."""
    def place(x):
        return (*base[:varied], x, *base[varied + 1:])

    def fits(x):
        return allowed(parameters[varied], _sign(x))

    # Far out only what is exact can be trusted.
    far = [1e3, 1e6] if len(conditions) > 1 else []
    sizes = [_near(x, 1000) for x in [*np.geomspace(1 / 50, 40, 24), *far]]
    grid = sorted(x for size in sizes for x in (size, -size) if fits(x))
    true, claimed = (_changes(lambda x: at(dict(zip(parameters, place(x)))), grid),
                     _changes(lambda x: conditions[0].holds(place(x)), grid))
    changes, roots = [*true, *claimed], [_near(x, 10**12) for c in conditions for x in c.borders(base, varied)]
    # What bisection finds in the truth is one of these again, or a border that the truth knows less well.
    exact = [*roots, *claimed]
    ordered = sorted({*exact, *(x for x in true if all(abs(x - root) > abs(x) / 500 for root in exact))})
    sides = [_near(float(x) * (1 + e), 10**9) for x in changes for e in (1e-3, -1e-3)]
    between = [(x + y) / 2 for x, y in itertools.pairwise(ordered) if y - x > (1 + abs(x)) / 10**9]
    on = [near for x in {*roots, *changes} if abs(x - (near := _near(x, 5000))) < sp.Rational(1, 10**9)]
    beyond = [ordered[0] - 1, ordered[-1] + 1] if ordered and far else []
    return sorted(x for x in {*grid, *sides, *between, *on, *beyond, sp.Integer(0)} if fits(x))


def on_borders(condition, symbols):
    """Places along lines where a condition changes and its terms are rational: to be tried where it means an equation.
    """
    for base, varied in _lines(symbols, 60):
        for x in condition.borders(base, varied):
            yield dict(zip(symbols, (*base[:varied], _near(x, 5000), *base[varied + 1:])))


def _changes(function, grid):
    """The places between neighbours of a grid where a function of few values changes, to ten digits."""
    found, values = [], [function(x) for x in grid]
    for left, right, value, last in zip(grid, grid[1:], values, values[1:]):
        # A third value may lie between two others, so the search goes on from each change to the next.
        while value != last and len(found) < 40:
            inner, outer = left, right
            for _ in range(42):
                middle = (inner + outer) / 2
                inner, outer = (middle, outer) if function(middle) == value else (inner, middle)
            found.append(inner)
            left = outer = outer + (outer - inner)
            value = function(left)
    return found


def _near(x, largest):
    near = Fraction(float(x)).limit_denominator(largest)
    return sp.Rational(near.numerator, near.denominator)


def _sign(number):
    return int(bool(number > 0)) - int(bool(number < 0))


def _range(angle):
    """The least and the greatest value of a number, or of a number and one inverse function: floats."""
    inverse = angle.atoms(sp.acos, sp.asin, sp.atan)
    for function in inverse:
        sign, number = angle.coeff(function), angle - angle.coeff(function) * function
        if len(inverse) == 1 and abs(sign) == 1 and number.is_number:
            ends = (0.0, math.pi) if isinstance(function, sp.acos) else (-math.pi / 2, math.pi / 2)
            return tuple(sorted(float(number) + float(sign) * end for end in ends))
    if not angle.is_number:
        raise _Undecidable
    return float(angle), float(angle)


def _is_finite(relation):
    return not relation.has(sp.oo, -sp.oo)


def _beyond_all(relation):
    """A comparison with infinity, which every number is below."""
    found = relation.subs({s: 0 for s in relation.free_symbols})
    if found not in (sp.true, sp.false):
        raise _Undecidable
    return found


def _compared(relation, sign):
    if sign is NOT_REAL:
        return isinstance(relation, sp.Ne)  # such a number is not zero, and it has no order
    if sign is None:
        return False
    return HOW[type(relation)](sign, 0)
