"""Pieces of the parameter space on which the rank of a matrix is lower than in general.

They are found by factoring one minor and eliminating a parameter where a factor vanishes, again and
again; see `parameters`.
"""

from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from trajlib.stability.inequalities import equation, sign_of
from trajlib.stability.strict_inequalities import TooLarge, solution_point
from trajlib.structure import exact
from trajlib.structure.pbh import LAMBDA, kernels_modulo

#: Terms of a polynomial modulo which a rank can still be found in seconds.
_MOST_TERMS = 20


class NotSolved(Exception):
    """Signals a polynomial, its argument, whose zeros are not found here."""


@dataclass(frozen=True)
class Piece:
    """A part of the parameter space: `values` of some parameters, `equations` for the others."""

    values: dict
    equations: tuple = ()
    rank: int | None = None

    def where(self):
        return sp.And(
            *(_written(s, v) for s, v in self.values.items()),
            *(equation(e) for e in self.equations),
        )


def _written(symbol, value):
    """Return s = v without fractions: k1*k2 = 1 rather than k1 = 1/k2."""
    numerator, denominator = sp.fraction(sp.together(symbol - value))
    return equation(numerator) if denominator.free_symbols else sp.Eq(symbol, value)


def rank_pieces(N, symbols, below):
    """Return the pieces of lower than generic rank, the larger ones first, none redundant."""
    pieces = sorted(_fallen(N, symbols, Piece({}), below), key=_order)
    return [
        p
        for i, p in enumerate(pieces)
        if not any(
            q.rank <= p.rank and lies_in(p, q) and (q != p or j < i)
            for j, q in enumerate(pieces)
            if j != i
        )
    ]


def _order(piece):
    return (
        len(piece.values) + len(piece.equations),
        -piece.rank,
        [
            (str(s), (float(v), "") if v.is_number else (0.0, str(v)))
            for s, v in piece.values.items()
        ],
    )


def _fallen(N, symbols, piece, below):
    """Yield the parts of a piece on which the rank of N is lower and `below` is not zero."""
    rank = exact.rank(N)
    if not rank or not N.free_symbols:
        return
    for factor in _zero_factors(_some_minor(N, rank)):
        for values, equations in _zeros([factor], symbols):
            if equations:
                # No parameter can be eliminated: the rank comes from the arithmetic modulo the
                # polynomial.
                if (
                    sp.rem(
                        below * exact.denominator(N), factor, *sorted(factor.free_symbols, key=str)
                    )
                    == 0
                ):
                    continue
                rank_here = _rank_modulo(N, factor)
                if rank_here < rank:
                    yield Piece(piece.values | values, equations, rank_here)
                for deeper, unsolved in _zeros(_lower_on(factor, N, rank_here), symbols):
                    if unsolved:
                        raise NotSolved(*unsolved)
                    yield from _restricted(N, symbols, piece, below, deeper, rank)
                continue
            yield from _restricted(N, symbols, piece, below, values, rank)


def _restricted(N, symbols, piece, below, values, rank):
    """Yield the part of a piece with given `values`, if its rank is lower, and its own parts."""
    below = _at(sp.Matrix([below]), values)[0]
    if below == 0:
        return
    N = _at(N, values)
    inner = Piece(
        {s: _simplified(v.subs(values)) for s, v in piece.values.items()} | values,
        rank=exact.rank(N),
    )
    if inner.rank < rank:
        yield inner
    yield from _fallen(N, tuple(s for s in symbols if s not in values), inner, below)


def _at(N, values):
    restricted = N
    for symbol, value in values.items():
        restricted = restricted.subs(symbol, value)
    return restricted.applyfunc(_simplified)


def _simplified(expression):
    return sp.radsimp(sp.cancel(expression))


def _some_minor(N, rank):
    """Return the numerator of a minor of order `rank` that is not identically zero."""
    at_point = exact.at_a_point(N)
    at_point = N if at_point is None or exact.rank(at_point) < rank else at_point
    columns = list(exact.field_matrix(at_point).rref()[1])
    rows = list(exact.independent_rows(at_point.extract(list(range(N.rows)), columns)))
    return sp.numer(sp.together(exact.determinant(N.extract(rows, columns))))


def _rank_modulo(N, polynomial):
    """Return the rank on an irreducible hypersurface."""
    if len(sp.Add.make_args(polynomial)) > _MOST_TERMS:
        raise NotSolved(polynomial)
    symbol = max(polynomial.free_symbols, key=str)
    f = sp.Poly(polynomial.subs(symbol, LAMBDA), LAMBDA).to_field().monic()
    polynomial_rows = sp.Matrix(
        [(exact.denominator(N[i, :]) * N[i, :]).applyfunc(sp.cancel) for i in range(N.rows)]
    )
    (_, kernel), *further = kernels_modulo(polynomial_rows.subs(symbol, LAMBDA), f)
    if further:
        raise NotSolved(polynomial)
    return N.cols - kernel.cols


def _lower_on(polynomial, N, rank):
    """Return polynomials that vanish together where the rank on `polynomial` = 0 is lower."""
    symbols = sorted(N.free_symbols | polynomial.free_symbols, key=str)
    if len(symbols) == 1 or not rank:
        return [sp.Integer(1)]
    minors = (
        sp.numer(sp.together(exact.determinant(N.extract(list(rows), list(columns)))))
        for rows in combinations(range(N.rows), rank)
        for columns in combinations(range(N.cols), rank)
    )
    return sp.groebner([polynomial, *(m for m in minors if m != 0)], *symbols, order="lex").exprs


def _zero_factors(polynomial):
    """Yield irreducible factors that vanish for some real values within the assumptions."""
    extension = (
        {"extension": True}
        if any(e.is_number and not e.is_rational for e in polynomial.atoms(sp.Pow))
        else {}
    )
    for factor, _ in sp.factor_list(
        polynomial, *sorted(polynomial.free_symbols, key=str), **extension
    )[1]:
        if factor.free_symbols and not sign_of(factor):
            yield factor


def _zeros(polynomials, symbols):
    """Yield the common real zeros of polynomials: pairs (values, equations left unsolved)."""
    polynomials = [p for p in polynomials if p != 0]
    if not polynomials:
        yield {}, ()
        return
    first, *further_polynomials = sorted(
        polynomials, key=lambda p: (len(p.free_symbols), p.count_ops())
    )
    for factor in _zero_factors(first):
        for values, equations in _zeros_of_irreducible(factor, symbols):
            if equations and further_polynomials:
                raise NotSolved(*equations)
            remaining = [sp.numer(_simplified(p.subs(values))) for p in further_polynomials]
            for further, equations_left in _zeros(
                remaining, tuple(s for s in symbols if s not in values)
            ):
                yield (
                    {s: _simplified(v.subs(further)) for s, v in values.items()} | further,
                    equations or equations_left,
                )


def _zeros_of_irreducible(f, symbols):
    free = [s for s in symbols if s in f.free_symbols]
    if len(free) == 1:
        yield from _roots(f, free[0])
        return
    if _one_signed(f, symbols):
        # Zeros of a polynomial that never changes its sign are critical points.
        yield from _zeros([f, *(sp.expand(f.diff(s)) for s in free)], symbols)
        return
    linear = [s for s in free if sp.degree(f, s) == 1]
    if not linear:
        yield {}, (f,)
        return
    symbol = min(linear, key=lambda s: bool(sp.Poly(f, s).LC().free_symbols))
    slope, constant = sp.Poly(f, symbol).nth(1), sp.Poly(f, symbol).nth(0)
    value = sp.cancel(-constant / slope)
    if _allowed(symbol, value):
        yield {symbol: value}, ()
    if slope.free_symbols:
        yield from _zeros([slope, constant], symbols)


def _roots(f, symbol):
    """Yield the real roots in closed form, or the equation itself: its roots are conjugate."""
    polynomial = sp.Poly(f, symbol, extension=True)
    if polynomial.degree() <= 2 or (
        polynomial.degree() == 4 and polynomial.nth(3) == polynomial.nth(1) == 0
    ):
        yield from (
            ({symbol: r}, ()) for r in sp.roots(polynomial) if r.is_real and _allowed(symbol, r)
        )
    elif not (polynomial.domain.is_ZZ or polynomial.domain.is_QQ):
        raise NotSolved(f)
    elif any(_allowed(symbol, r) for r in polynomial.real_roots()):
        yield {}, (f,)


def _one_signed(f, symbols):
    try:
        return solution_point([f], symbols) is None or solution_point([-f], symbols) is None
    except TooLarge:
        return False


def _allowed(symbol, value):
    """Whether the assumptions on a parameter admit a value."""
    return not (
        (symbol.is_positive and value.is_nonpositive)
        or (symbol.is_negative and value.is_nonnegative)
        or (symbol.is_nonzero and value.is_zero)
        or (symbol.is_nonnegative and value.is_negative)
        or (symbol.is_nonpositive and value.is_positive)
    )


def lies_in(piece, container):
    """Whether a piece lies in another one, whose equations are taken without denominators."""
    equations = (
        *(sp.numer(sp.together(s - v)) for s, v in container.values.items()),
        *container.equations,
    )
    return all(e in piece.equations or sp.simplify(e.subs(piece.values)) == 0 for e in equations)
