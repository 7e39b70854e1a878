"""Cylindrical algebraic decomposition of a space into cells on which polynomials keep their signs.

Collins 1975, with Lazard's projection (leading and trailing coefficients, discriminants, resultants)
and Lazard's evaluation, valid in any number of variables (McCallum, Parusinski and Paunescu 2019):
above a cell of the projection the zeros of all polynomials are graphs that do not meet. Where the
projection or the numbers above which zeros are looked for become too large some cells are left out;
the others are still exact samples, also on the zeros of the polynomials.
"""

import itertools
from dataclasses import dataclass

import sympy as sp

from workbook.checks.tools.conditions.elimination import irreducible_factors
from workbook.checks.tools.conditions.evaluation import allowed, sign
from workbook.checks.tools.conditions.polynomial_form import Undecidable
from workbook.checks.tools.conditions.real_roots import cells_of_line, cells_over

#: The most polynomials with the same last variable, their greatest degree in one variable and their
#: most terms; and the most coefficients, discriminants and resultants.
MOST_POLYNOMIALS, LARGEST_DEGREE, MOST_TERMS, MOST_PROJECTED = 20, 12, 150, 200
#: The most work on the lines above points: one for each, and over an irrational number the product
#: of its degree and that of all polynomials.
MOST_WORK = 500


@dataclass(frozen=True)
class Cell:
    """A point of a cell of the space of the first variables.

    Parameters
    ----------
    coordinates : tuple of Coordinate
        Their values.
    vanishing : frozenset of sympy.Expr
        The polynomials in these variables that are zero there.
    """

    coordinates: tuple = ()
    vanishing: frozenset = frozenset()


class Decomposition:
    """The decomposition for irreducible polynomials; its cells are made when they are asked for.

    Parameters
    ----------
    factors : iterable of sympy.Expr
        The polynomials.
    symbols : list of sympy.Symbol
        The variables; the last one is projected away first.
    """

    def __init__(self, factors, symbols):
        self.symbols, self.is_complete, self._work = list(symbols), True, 0
        self._levels = [set() for _ in symbols]
        self._add(factors)
        projected = 0
        for level in range(len(symbols) - 1, 0, -1):
            polynomials = [sp.Poly(f, symbols[level]) for f in self._simplest(level)]
            for polynomial in _projected(polynomials):
                projected += 1
                if projected > MOST_PROJECTED:
                    self.is_complete = False
                    break
                if _is_small(polynomial):
                    self._add(irreducible_factors(polynomial))
                else:
                    self.is_complete = False
        self._levels = [
            [(f, sp.Poly(f, *self.symbols[: level + 1])) for f in self._simplest(level)]
            for level in range(len(symbols))
        ]

    def _add(self, factors):
        for factor in factors:
            level = max(map(self.symbols.index, factor.free_symbols))
            self._levels[level].add(factor)

    def _simplest(self, level):
        factors = sorted(
            self._levels[level], key=lambda f: (len(f.free_symbols), sp.count_ops(f), str(f))
        )
        if len(factors) > MOST_POLYNOMIALS:
            self.is_complete = False
        return factors[:MOST_POLYNOMIALS]

    def above(self, cell):
        """Return the cells above one of the space of fewer variables, over rational numbers first."""
        level = len(cell.coordinates)
        symbol, factors = self.symbols[level], [f for f, _ in self._levels[level]]
        try:
            stack, vanishing = self._stack(cell, level)
        except Undecidable:
            self.is_complete = False
            return []
        return [
            Cell(
                (*cell.coordinates, coordinate),
                cell.vanishing | vanishing | {factors[k] for k in indices},
            )
            for coordinate, indices in sorted(stack, key=lambda item: not item[0].is_rational)
            if allowed(symbol, sign(coordinate.number))
        ]

    def _stack(self, cell, level):
        """Return the cells of the line above a point, and the polynomials that vanish on all of it."""
        involved = set().union(*(f.free_symbols for f, _ in self._levels[level]))
        values = {s: x.resolved() for s, x in zip(self.symbols, cell.coordinates) if s in involved}
        irrational = [s for s, x in values.items() if not x.is_rational]
        if len(irrational) > 1:
            raise Undecidable
        vanishing, restricted = set(), []
        for factor, polynomial in self._levels[level]:
            for s in self.symbols[:level]:
                if s in irrational:
                    continue
                number = values[s].rational if s in involved else sp.Integer(0)
                value = polynomial.eval(s, number)
                while value.is_zero:
                    if irrational:
                        raise Undecidable
                    vanishing.add(factor)
                    polynomial = polynomial.quo(sp.Poly(s - number, *polynomial.gens))
                    value = polynomial.eval(s, number)
                polynomial = value
            restricted.append(polynomial)
        degrees = sum(p.degree(self.symbols[level]) for p in restricted)
        self._work += values[irrational[0]].polynomial.degree() * degrees if irrational else 1
        if self._work > MOST_WORK:
            raise Undecidable
        if irrational:
            return cells_over(values[irrational[0]], restricted, self.symbols[level]), vanishing
        return cells_of_line(restricted), vanishing


def _is_small(polynomial):
    symbols = polynomial.free_symbols
    if not symbols:
        return True
    polynomial = sp.Poly(polynomial, *symbols)
    return max(polynomial.degree_list()) <= LARGEST_DEGREE and len(polynomial.terms()) <= MOST_TERMS


def _projected(polynomials):
    """Yield leading and trailing coefficients, discriminants and resultants that are not zero."""
    for p in polynomials:
        yield p.LC()
        if p.TC() != 0:
            yield p.TC()
        if p.degree() > 1:
            yield p.discriminant()
    for p, q in itertools.combinations(polynomials, 2):
        yield p.resultant(q)
