"""Observability and controllability conditions on parameters, and the ranks where they fail.

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
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import join_names, read_symbols
from trajlib._real_symbols import as_real, restore_names
from trajlib._typing import MatrixLike, Symbols
from trajlib.stability.inequalities import equation
from trajlib.stability.regions import latex_region
from trajlib.structure import exact
from trajlib.structure.kalman_matrices import stacked_powers
from trajlib.structure.rank_pieces import NotSolved, lies_in, rank_pieces

_MOST_MINORS = 300
#: More parameters than these, with more terms in the Kalman matrix than those, take minutes.
_FEW, _MANY = 6, 150


@dataclass(frozen=True)
class RankConditions:
    """The set of parameters for which a system is observable (controllable).

    Attributes
    ----------
    region : sympy.Basic
        The condition, `sp.true`, `sp.false` or an And of inequations Ne(...); where the system is
        not defined it is not observable.
    exceptions : tuple of (sympy.Basic, int)
        Pairs (where, rank): on the piece `where` (Eq(...), And of such, or `sp.true` if the rank
        falls short everywhere) the rank is `rank`, but for smaller pieces of lower rank, which come
        later.
    minors : tuple of sympy.Expr
        The factored maximal minors of the Kalman matrix that are not identically zero, each once
        (the first of them, if there are very many).
    undefined : sympy.Basic
        Where an entry of the system has a zero denominator, so that there is no rank: Eq(...), Or
        of such, or `sp.false`.
    """

    region: sp.Basic
    exceptions: tuple[tuple[sp.Basic, int], ...]
    minors: tuple[sp.Expr, ...]
    undefined: sp.Basic = sp.false

    def _repr_latex_(self):
        return f"$\\displaystyle {latex_region(self.region)}$"


@accepts_state_space("A", "H", C="H")
def observability_conditions(A: MatrixLike, H: MatrixLike, parameters: Symbols) -> RankConditions:
    """Return the parameters for which x' = Ax, z = Hx is observable, and the rank elsewhere.

    Values for which an entry is not defined (a zero denominator) are excluded from the region, and
    named.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax, exact.
    H : matrix_like, shape (m, n)
        Matrix of the output z = Hx, exact.
    parameters : sequence of sympy.Symbol
        All symbols in `A` and `H`, taken as real, with their assumptions.

    Returns
    -------
    RankConditions
        The region and the exceptional pieces with their ranks.

    Raises
    ------
    ValueError
        For symbols that are not named as parameters, for floats, or if shapes do not fit.
    NotImplementedError
        If the minors are no polynomials that can be solved.

    Notes
    -----
    Keywords of python-control: `C` for `H`.
    MATLAB has no word for it (``rank(obsv(A, C))`` by hand). Source: Theorem 2.1 and
    its corollary in the problem book.

    Examples
    --------
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


@accepts_state_space("A", "B")
def controllability_conditions(A: MatrixLike, B: MatrixLike, parameters: Symbols) -> RankConditions:
    """Return the parameters for which x' = Ax + Bu is controllable, and the rank elsewhere.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of x' = Ax + Bu, exact.
    B : matrix_like, shape (n, s)
        Matrix of the control, exact.
    parameters : sequence of sympy.Symbol
        All symbols in `A` and `B`, taken as real, with their assumptions.

    Returns
    -------
    RankConditions
        The region and the exceptional pieces with their ranks.

    Raises
    ------
    ValueError, NotImplementedError
        As `observability_conditions`.

    Notes
    -----
    MATLAB has no word for it (``rank(ctrb(A, B))`` by hand). Source: Theorem 2.2 and its corollary
    in the problem book.

    Examples
    --------
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
    """Return the `RankConditions` of full column rank of N where `below` does not vanish."""
    if len(parameters) > _FEW and exact.number_of_terms(N) > _MANY:
        raise NotImplementedError(
            f"parameters: {len(parameters)} of them in a matrix this large are beyond the "
            "methods here; give some of the parameters values"
        )
    to_real, from_real = as_real(N, below)
    real, symbols = N.xreplace(to_real), tuple(to_real.get(p, p) for p in parameters)
    generic = exact.rank(real)
    try:
        pieces = rank_pieces(real, symbols, below.xreplace(to_real))
    except (NotSolved, sp.PolynomialError) as problem:
        where = shorten(restore_names(str(problem), from_real), 200, placeholder=" ...")
        raise NotImplementedError(
            f"parameters: the equation {where} = 0, on which the rank may fall, is beyond the "
            "methods here; give some of the parameters values, or study the minors of the Kalman "
            "matrix by hand"
        ) from None
    everywhere = [(sp.true, generic)] if generic < N.cols else []
    largest = [p for p in pieces if not any(lies_in(p, q) for q in pieces if q is not p)]
    undefined = [equation(factor) for factor in exact.factors(below.xreplace(to_real))]
    region = (
        sp.false
        if everywhere
        else sp.And(
            *map(sp.Not, undefined),
            *(sp.Or(*map(sp.Not, sp.And.make_args(p.where()))) for p in largest),
        )
    )
    return RankConditions(
        region.xreplace(from_real),
        (*everywhere, *((p.where().xreplace(from_real), p.rank) for p in pieces)),
        tuple(m.xreplace(from_real) for m in _maximal_minors(real)),
        sp.Or(*undefined).xreplace(from_real),
    )


def _maximal_minors(N):
    """Return the factored maximal minors that do not vanish, one for each up to a number."""
    if comb(N.rows, N.cols) <= _MOST_MINORS:
        choices = combinations(range(N.rows), N.cols)
    else:
        choices = [exact.independent_rows(N)] if exact.rank(N) == N.cols else []
    minors = {}
    for rows in choices:
        minor = sp.factor(exact.determinant(N.extract(list(rows), list(range(N.cols)))))
        if minor != 0:
            numerator, denominator = (sp.factor_list(part)[1] for part in sp.fraction(minor))
            minors.setdefault((frozenset(numerator), frozenset(denominator)), minor)
    return list(minors.values())
