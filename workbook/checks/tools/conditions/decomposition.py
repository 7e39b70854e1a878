"""Cylindrical algebraic decomposition of the line and the plane, to decide a condition exactly.

Collins 1975, with McCallum's projection, which in the plane is always valid: above a cell of the
line between the zeros of all leading coefficients, discriminants and resultants the curves are
graphs that do not meet. On every cell all polynomials have one sign, so that one point of it
decides.
"""

import itertools
from dataclasses import dataclass

import sympy as sp

from workbook.checks.tools.conditions.evaluation import allowed, sign
from workbook.checks.tools.conditions.polynomial_form import Undecidable
from workbook.checks.tools.conditions.real_roots import (
    cells_of_line,
    cells_over,
)

#: The most polynomials in two variables, their greatest degree in one of them, and the greatest
#: degree of all polynomials in the projection together.
MOST_CURVES, LARGEST_DEGREE, LARGEST_PROJECTION = 12, 12, 120


@dataclass(frozen=True)
class Cell:
    """A point of a cell.

    Parameters
    ----------
    point : dict
        {symbol: Coordinate}.
    vanishing : frozenset of sympy.Expr
        The polynomials of the decomposition that are zero there.
    """

    point: dict
    vanishing: frozenset


def columns(factors, symbols):
    """Yield the cells of a decomposition, those above one cell of the first symbol together.

    Parameters
    ----------
    factors : list of sympy.Expr
        Irreducible polynomials in the symbols.
    symbols : list of sympy.Symbol
        At most two.

    Yields
    ------
    list of Cell
        All cells of one column; those over rational numbers come first.

    Raises
    ------
    Undecidable
        If there are too many polynomials, or too large ones.
    """
    if not symbols:
        yield [Cell({}, frozenset())]
    elif len(symbols) == 1:
        (symbol,) = symbols
        cells = cells_of_line([sp.Poly(f, symbol) for f in factors])
        for coordinate, indices in _allowed_cells(symbol, cells):
            yield [Cell({symbol: coordinate}, frozenset(factors[k] for k in indices))]
    elif len(symbols) == 2:
        yield from _columns_of_plane(factors, *symbols)
    else:
        raise Undecidable


def _columns_of_plane(factors, first, second):
    curves = [f for f in factors if f.has(second)]
    points = [f for f in factors if not f.has(second)]
    polynomials = [sp.Poly(f, second) for f in curves]
    if len(curves) > MOST_CURVES or any(
        sp.degree(f, symbol) > LARGEST_DEGREE for f in curves for symbol in (first, second)
    ):
        raise Undecidable
    projection = [sp.Poly(f, first) for f in [*points, *_projected(polynomials)] if f.has(first)]
    if sum(p.degree() for p in projection) > LARGEST_PROJECTION:
        raise Undecidable
    for coordinate, indices in _allowed_cells(first, cells_of_line(projection)):
        below = frozenset(points[k] for k in indices if k < len(points))
        if coordinate.is_rational:
            at = [sp.Poly(f.subs(first, coordinate.rational), second) for f in curves]
            stack = cells_of_line(at)
        else:
            stack = cells_over(coordinate, [sp.Poly(f, first, second) for f in curves], second)
        yield [
            Cell({first: coordinate, second: height}, below | {curves[k] for k in vanishing})
            for height, vanishing in _allowed_cells(second, stack)
        ]


def _projected(polynomials):
    """Return leading coefficients, discriminants and resultants."""
    yield from (p.LC() for p in polynomials)
    yield from (p.discriminant() for p in polynomials if p.degree() > 1)
    for p, q in itertools.combinations(polynomials, 2):
        yield p.resultant(q)


def _allowed_cells(symbol, cells):
    """Return the cells where a symbol has a sign that it may have; rational numbers first."""
    return sorted(
        (cell for cell in cells if allowed(symbol, sign(cell[0].number))),
        key=lambda cell: not cell[0].is_rational,
    )
