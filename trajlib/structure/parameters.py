"""For which values of the parameters is a system observable, and where does the rank fall, and to
what?

The rank of N is that of its generic values but where all minors of that order vanish together. The
set of these exceptions is found piece by piece: one minor that does not vanish identically is
factored; on each piece where a factor is zero a parameter is eliminated and the rank computed
again, and so on until no parameter is left. For one output there is a single maximal minor, det N.
On a piece where no parameter can be eliminated (a circle) the rank comes from the arithmetic modulo
its equation. Parameters stand for real numbers: a factor without real zeros, or with none that the
assumptions (positive=True) allow, is no exception.
"""

from dataclasses import dataclass
from itertools import combinations
from math import comb
from textwrap import shorten

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_controlled, read_observed
from trajlib._arguments.symbols import join_names, read_symbols
from trajlib._real_symbols import as_real, restore_names
from trajlib.stability.inequalities import equation, sign_of
from trajlib.stability.regions import latex_region
from trajlib.stability.strict_inequalities import TooLarge, solution_point
from trajlib.structure import exact
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.pbh import LAMBDA, kernels_modulo

_MOST_MINORS = 300
#: Terms of a polynomial modulo which a rank can still be found in seconds.
_MOST_TERMS = 20
#: More parameters than these, with more terms in the Kalman matrix than those, take minutes.
_FEW, _MANY = 6, 150


@dataclass(frozen=True)
class RankConditions:
    """Where in the space of the parameters a system is observable (controllable).

    - `region`: the condition, `sp.true`, `sp.false` or an And of inequations Ne(...); where the
      system is not defined it is not observable;
    - `exceptions`: tuple of (where, rank): on the piece `where` (Eq(...), And of such, or `sp.true`
      if the rank falls short everywhere) the rank is `rank`, but for smaller pieces of lower rank,
      which come later in the tuple;
    - `minors`: the factored maximal minors of the Kalman matrix that are not identically zero, each
      once (the first of them, if there are very many);
    - `undefined`: where an entry of the system has a zero denominator, so that no rank is said:
      Eq(...), Or of such, or `sp.false`.
    """

    region: sp.Basic
    exceptions: tuple
    minors: tuple
    undefined: sp.Basic = sp.false

    def _repr_latex_(self):
        return f"$\\displaystyle {latex_region(self.region)}$"


def observability_conditions(A, H, parameters):
    """For which parameters is x' = Ax, z = Hx observable, and what is the rank elsewhere? (MATLAB:
    none; rank(obsv) by hand.)

    `A`: n x n, `H`: m x n, SymPy matrices; `parameters`: the symbols in them, taken as real, with
    their assumptions. Values for which an entry is not defined (a zero denominator) are excluded
    from the region, and named. Returns `RankConditions`. Raises ValueError for symbols that are not
    named as parameters and for shapes that do not fit, NotImplementedError if the minors are no
    polynomials that can be solved. Source: Theorem 2.1 and its corollary in the problem book.

    >>> import sympy as sp
    >>> alpha, beta = sp.symbols("alpha beta")
    >>> found = observability_conditions(sp.Matrix([[0, 1], [-beta, -alpha]]), sp.Matrix([[1, 1]]), [alpha, beta])
    >>> found.region, found.exceptions
    (Ne(alpha, beta + 1), ((Eq(alpha, beta + 1), 1),))
    >>> found = observability_conditions(sp.Matrix([[0, 1/alpha], [0, 0]]), sp.Matrix([[1, 0]]), [alpha])
    >>> found.region, found.exceptions, found.undefined
    (Ne(alpha, 0), (), Eq(alpha, 0))
    """
    return _conditions(*read_observed(A, H), parameters)


def controllability_conditions(A, B, parameters):
    """For which parameters is x' = Ax + Bu controllable, and what is the rank elsewhere? (MATLAB:
    none; rank(ctrb) by hand.)

    `A`: n x n, `B`: n x s; parameters, result and errors as in `observability_conditions`.
    Source: Theorem 2.2 and its corollary in the problem book.

    >>> import sympy as sp
    >>> beta = sp.Symbol("beta")
    >>> controllability_conditions(sp.Matrix([[1, -2], [4, -5]]), sp.Matrix([beta, 1]), [beta]).exceptions
    ((Eq(beta, 1/2), 1), (Eq(beta, 1), 1))
    """
    return _conditions(*read_controlled(A, B), parameters)


def _conditions(A, H, parameters):
    parameters = read_symbols(parameters, "parameters")
    if isinstance(A, np.ndarray):
        raise ValueError(
            "A: expected SymPy matrices with the parameters in them; an array of floats has none"
        )
    if undeclared := (A.free_symbols | H.free_symbols) - set(parameters):
        raise ValueError(
            f"parameters: the system also has {join_names(undeclared)}; name every "
            "symbol that is not a number"
        )
    if roots := sorted(
        (p for p in (A.atoms(sp.Pow) | H.atoms(sp.Pow)) if p.free_symbols and not p.exp.is_Integer),
        key=str,
    ):
        raise ValueError(
            f"A: {roots[0]} stands in the system, and conditions are found for rational functions "
            "of the parameters; put a symbol for it"
        )
    below = sp.Mul(*{sp.denom(sp.together(entry)) for entry in (*A, *H)})
    return rank_conditions(stacked_powers(A, H), parameters, below)


def rank_conditions(N, parameters, below=sp.Integer(1)):
    """`RankConditions` for the full column rank of a matrix, where the denominator `below` of the
    system does not vanish."""
    if len(parameters) > _FEW and exact.number_of_terms(N) > _MANY:
        raise NotImplementedError(
            f"parameters: {len(parameters)} of them in a matrix this large are beyond the "
            "methods here; give some of the parameters values"
        )
    to_real, back = as_real(N, below)
    real, symbols = N.xreplace(to_real), tuple(to_real.get(p, p) for p in parameters)
    generic = exact.rank(real)
    try:
        pieces = _pieces(real, symbols, below.xreplace(to_real))
    except (_NotSolved, sp.PolynomialError) as problem:
        where = shorten(restore_names(str(problem), back), 200, placeholder=" ...")
        raise NotImplementedError(
            f"parameters: the equation {where} = 0, on which the rank may fall, is beyond the "
            "methods here; give some of the parameters values, or study the minors of the Kalman "
            "matrix by hand"
        ) from None
    whole = [(sp.true, generic)] if generic < N.cols else []
    largest = [p for p in pieces if not any(_inside(p, q) for q in pieces if q is not p)]
    undefined = [equation(factor) for factor in exact.factors(below.xreplace(to_real))]
    region = (
        sp.false
        if whole
        else sp.And(
            *map(sp.Not, undefined),
            *(sp.Or(*map(sp.Not, sp.And.make_args(p.where()))) for p in largest),
        )
    )
    return RankConditions(
        region.xreplace(back),
        (*whole, *((p.where().xreplace(back), p.rank) for p in pieces)),
        tuple(m.xreplace(back) for m in _maximal_minors(real)),
        sp.Or(*undefined).xreplace(back),
    )


class _NotSolved(Exception):
    """The argument is a polynomial whose zeros are not found here."""


@dataclass(frozen=True)
class _Piece:
    """A part of the parameter space: parameters with `values` in terms of the others, where
    `equations` hold besides."""

    values: dict
    equations: tuple = ()
    rank: int | None = None

    def where(self):
        return sp.And(
            *(_written(s, v) for s, v in self.values.items()),
            *(equation(e) for e in self.equations),
        )


def _written(symbol, value):
    """s = v without fractions: k1*k2 = 1 rather than k1 = 1/k2."""
    numerator, denominator = sp.fraction(sp.together(symbol - value))
    return equation(numerator) if denominator.free_symbols else sp.Eq(symbol, value)


def _pieces(N, symbols, below):
    """The pieces on which the rank is lower than generic; larger ones first, none inside another of
    the same or a lower rank."""
    pieces = sorted(_fallen(N, symbols, _Piece({}), below), key=_order)
    return [
        p
        for i, p in enumerate(pieces)
        if not any(
            q.rank <= p.rank and _inside(p, q) and (q != p or j < i)
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
    """All parts of a piece on which the rank of N is lower than on the piece, and the denominator
    `below` is not zero."""
    rank = exact.rank(N)
    if not rank or not N.free_symbols:
        return
    for factor in _zero_factors(_some_minor(N, rank), symbols):
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
                    yield _Piece(piece.values | values, equations, rank_here)
                for deeper, unsolved in _zeros(_lower_on(factor, N, rank_here), symbols):
                    if unsolved:
                        raise _NotSolved(*unsolved)
                    yield from _restricted(N, symbols, piece, below, deeper, rank)
                continue
            yield from _restricted(N, symbols, piece, below, values, rank)


def _restricted(N, symbols, piece, below, values, rank):
    """The part of a piece on which some parameters have `values`, if the rank is lower there, and
    its own parts."""
    below = _at(sp.Matrix([below]), values)[0]
    if below == 0:
        return
    N = _at(N, values)
    inner = _Piece(
        {s: _plain(v.subs(values)) for s, v in piece.values.items()} | values, rank=exact.rank(N)
    )
    if inner.rank < rank:
        yield inner
    yield from _fallen(N, tuple(s for s in symbols if s not in values), inner, below)


def _at(N, values):
    restricted = N
    for symbol, value in values.items():
        restricted = restricted.subs(symbol, value)
    return restricted.applyfunc(_plain)


def _plain(expression):
    return sp.radsimp(sp.cancel(expression))


def _some_minor(N, rank):
    """The numerator of a minor of order `rank` that is not identically zero, from the first rows
    and columns that give one."""
    at_point = exact.at_a_point(N)
    at_point = N if at_point is None or exact.rank(at_point) < rank else at_point
    columns = list(exact.field_matrix(at_point).rref()[1])
    rows = list(exact.independent_rows(at_point.extract(list(range(N.rows)), columns)))
    return sp.numer(sp.together(exact.determinant(N.extract(rows, columns))))


def _rank_modulo(N, polynomial):
    """The rank on an irreducible hypersurface."""
    if len(sp.Add.make_args(polynomial)) > _MOST_TERMS:
        raise _NotSolved(polynomial)
    symbol = max(polynomial.free_symbols, key=str)
    f = sp.Poly(polynomial.subs(symbol, LAMBDA), LAMBDA).to_field().monic()
    whole = sp.Matrix(
        [(exact.denominator(N[i, :]) * N[i, :]).applyfunc(sp.cancel) for i in range(N.rows)]
    )
    (_, kernel), *more = kernels_modulo(whole.subs(symbol, LAMBDA), f)
    if more:
        raise _NotSolved(polynomial)
    return N.cols - kernel.cols


def _lower_on(polynomial, N, rank):
    """Polynomials whose common zeros are those zeros of an irreducible polynomial at which the rank
    is below `rank`."""
    symbols = sorted(N.free_symbols | polynomial.free_symbols, key=str)
    if len(symbols) == 1 or not rank:
        return [sp.Integer(1)]
    minors = (
        sp.numer(sp.together(exact.determinant(N.extract(list(rows), list(columns)))))
        for rows in combinations(range(N.rows), rank)
        for columns in combinations(range(N.cols), rank)
    )
    return sp.groebner([polynomial, *(m for m in minors if m != 0)], *symbols, order="lex").exprs


def _zero_factors(polynomial, symbols):
    """Irreducible factors that vanish for some real values within the assumptions."""
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
    """The common real zeros of polynomials as pairs (values of parameters, equations left
    unsolved), within the assumptions."""
    polynomials = [p for p in polynomials if p != 0]
    if not polynomials:
        yield {}, ()
        return
    first, *others = sorted(polynomials, key=lambda p: (len(p.free_symbols), p.count_ops()))
    for factor in _zero_factors(first, symbols):
        for values, equations in _zeros_of_irreducible(factor, symbols):
            if equations and others:
                raise _NotSolved(*equations)
            left = [sp.numer(_plain(p.subs(values))) for p in others]
            for more, equations_left in _zeros(left, tuple(s for s in symbols if s not in values)):
                yield (
                    {s: _plain(v.subs(more)) for s, v in values.items()} | more,
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
    """Real roots in closed form; where there is none that helps, the equation itself: its roots are
    conjugate, of one rank."""
    polynomial = sp.Poly(f, symbol, extension=True)
    if polynomial.degree() <= 2 or (
        polynomial.degree() == 4 and polynomial.nth(3) == polynomial.nth(1) == 0
    ):
        yield from (
            ({symbol: r}, ()) for r in sp.roots(polynomial) if r.is_real and _allowed(symbol, r)
        )
    elif not (polynomial.domain.is_ZZ or polynomial.domain.is_QQ):
        raise _NotSolved(f)
    elif any(_allowed(symbol, r) for r in polynomial.real_roots()):
        yield {}, (f,)


def _one_signed(f, symbols):
    try:
        return solution_point([f], symbols) is None or solution_point([-f], symbols) is None
    except TooLarge:
        return False


def _allowed(symbol, value):
    """Whether the assumptions on a parameter leave room for a value."""
    return not (
        (symbol.is_positive and value.is_nonpositive)
        or (symbol.is_negative and value.is_nonnegative)
        or (symbol.is_nonzero and value.is_zero)
        or (symbol.is_nonnegative and value.is_negative)
        or (symbol.is_nonpositive and value.is_positive)
    )


def _inside(piece, other):
    """Whether a piece lies in another one, whose equations are taken without denominators."""
    equations = (*(sp.numer(sp.together(s - v)) for s, v in other.values.items()), *other.equations)
    return all(e in piece.equations or sp.simplify(e.subs(piece.values)) == 0 for e in equations)


def _maximal_minors(N):
    """The maximal minors that do not vanish identically, factored, one of those that differ by a
    number only."""
    if comb(N.rows, N.cols) <= _MOST_MINORS:
        choices = combinations(range(N.rows), N.cols)
    else:
        choices = [exact.independent_rows(N)] if exact.rank(N) == N.cols else []
    minors = {}
    for rows in choices:
        minor = sp.factor(exact.determinant(N.extract(list(rows), list(range(N.cols)))))
        if minor != 0:
            above, below = (sp.factor_list(part)[1] for part in sp.fraction(minor))
            minors.setdefault((frozenset(above), frozenset(below)), minor)
    return list(minors.values())
