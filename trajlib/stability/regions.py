"""Regions of asymptotic stability in the space of parameters, also with a degree of stability.

The Hurwitz criterion is used in the form of Lienard and Chipart: with positive coefficients of one
parity only every second Hurwitz minor need be tested (F. R. Gantmacher, The Theory of Matrices,
vol. 2, XV.13). The remaining conditions are reduced, and those that follow from the others are left
out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp

from trajlib import plotting
from trajlib._arguments.matrices import has_floats, read_exact_matrix
from trajlib._arguments.renamed import renamed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import (
    exact_decimals,
    join_names,
    read_expression,
    read_expressions,
    read_symbols,
)
from trajlib._real_symbols import as_real
from trajlib._typing import ExprLike, MatrixLike, PolynomialLike, Symbols
from trajlib.stability.hurwitz import characteristic_polynomial, hurwitz_minors, read_coefficients
from trajlib.stability.inequalities import conjunction, sign_of
from trajlib.stability.shifted_polynomials import shifted_coefficients


@dataclass(frozen=True)
class Edge:
    """A part of the parameter space where the leading coefficient vanishes and the order drops.

    Attributes
    ----------
    where : sympy.Basic
        The equation of the edge.
    polynomial : sympy.Expr
        The characteristic polynomial there, of lower order.
    region : sympy.Basic
        The condition under which that equation is asymptotically stable on the edge, with the same
        degree of stability.
    """

    where: sp.Basic
    polynomial: sp.Expr
    region: sp.Basic


@dataclass(frozen=True)
class StabilityConditions:
    """The set of parameters for which all roots of `polynomial` have a degree of stability.

    Attributes
    ----------
    polynomial : sympy.Expr
        The characteristic polynomial.
    symbol : sympy.Symbol
        Its variable.
    parameters : tuple of sympy.Symbol
        The coordinates of the parameter space.
    degree : sympy.Expr
        mu >= 0 in Re lambda < -mu, in discrete time in |z| < 1 - mu.
    region : sympy.Basic
        The answer as a condition: an And of strict inequalities in the shortest form found,
        `sp.true` or `sp.false`; an Or of such if a leading coefficient may have either sign.
    minors : tuple
        The Hurwitz minors Delta_1, ..., Delta_n of the shifted polynomial as computed, in discrete time
        of the transformed one.
    degenerate : tuple of Edge
        The edges on which the order drops; they are no part of `region`.
    empty : bool or None
        True if no parameters stabilise, False if some do, None if that could not be decided.
    """

    polynomial: sp.Expr
    symbol: sp.Symbol
    parameters: tuple[sp.Symbol, ...]
    degree: sp.Expr
    region: sp.Basic
    minors: tuple[sp.Expr, ...]
    degenerate: tuple[Edge, ...]
    empty: bool | None

    def contains(self, point: Mapping[sp.Symbol, ExprLike] | Sequence[ExprLike]) -> bool:
        """Decide whether a point lies in the region.

        Floats count as the exact numbers they are, so that points close to the boundary are judged
        correctly.

        Parameters
        ----------
        point : dict or sequence of number
            A dict from parameters to numbers, or numbers in the order of `parameters`.

        Returns
        -------
        bool
            Whether the point lies in `region`.

        Raises
        ------
        ValueError
            If a parameter has no value, a value is not a real number, or the condition cannot be
            decided.
        """
        if isinstance(point, Mapping):
            missing = set(self.parameters) - set(point)
            if missing:
                raise ValueError(f"point: no value for {join_names(missing)}")
            values = [point[s] for s in self.parameters]
        else:
            values = read_expressions(point, len(self.parameters), "point")
        exact = {s: _exact_number(v) for s, v in zip(self.parameters, values)}
        verdict = self.region.subs(exact, simultaneous=True)
        if verdict not in (sp.true, sp.false):
            raise ValueError(f"point: could not decide {verdict}")
        return bool(verdict)

    def plot(
        self, first_range: tuple[float, float], second_range: tuple[float, float], ax: Any = None
    ) -> Any:
        """Draw the region over a rectangle of the two parameters.

        Parameters
        ----------
        first_range, second_range : tuple of float
            (low, high) of each parameter.
        ax : matplotlib.axes.Axes, optional
            The axes to draw on; new ones by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.

        Raises
        ------
        ValueError
            If there are not two parameters.
        """
        if len(self.parameters) != 2:
            raise ValueError(
                f"plot: a picture needs two parameters, this region has {len(self.parameters)}"
            )
        return plotting.region(self.region, self.parameters, first_range, second_range, ax=ax)

    def _repr_latex_(self):
        return f"$\\displaystyle {latex_region(self.region)}$"


@renamed(margin="degree")
@accepts_state_space("A", time="continuous", instead="use jury_conditions")
def stability_conditions(
    poly_or_matrix: PolynomialLike | MatrixLike,
    parameters: Symbols,
    degree: ExprLike = 0,
    symbol: sp.Symbol | None = None,
) -> StabilityConditions:
    """Return the conditions on `parameters` for asymptotic stability, or a degree of it.

    Parameters
    ----------
    poly_or_matrix : sympy.Expr, sympy.Poly, sequence of coefficients or matrix_like, shape (n, n)
        The characteristic polynomial (coefficients with the highest power first), or the matrix A
        of x' = Ax. A StateSpace stands for its A.
    parameters : sequence of sympy.Symbol
        All symbols in it; they stand for real numbers, and their assumptions (positive=True) are
        used.
    degree : float or sympy.Expr, default 0
        mu >= 0, for Re lambda < -mu.
    symbol : sympy.Symbol, optional
        The variable of the polynomial; may be left out if it is its only symbol beside `parameters`.

    Returns
    -------
    StabilityConditions
        The region with its minors and degenerate edges.

    Raises
    ------
    ValueError
        For symbols that are not named as parameters, for a negative degree of stability, and as
        `hurwitz_matrix`.

    Notes
    -----
    Definition 1.5 of the problem book, with its sign corrected, asks for Re lambda <= -mu; the
    region here is the interior of that set: the points of its boundary, where a root lies on the
    line Re lambda = -mu, are not in it. With mu = 0 it is the Hurwitz criterion, Theorem 1.2.

    Examples
    --------
    >>> import sympy as sp
    >>> k1, k2 = sp.symbols("k1 k2")
    >>> found = stability_conditions(sp.Matrix([[k1, 1], [1, k2]]), [k1, k2], degree=2)
    >>> found.region
    (k1 + k2 < -4) & (k1*k2 + 2*k1 + 2*k2 > -3)
    >>> found.contains([-5, -5]), found.contains([-2, -3])
    (True, False)
    """
    parameters = read_symbols(parameters, "parameters")
    coefficients, symbol = read_equation(poly_or_matrix, parameters, symbol)
    degree = read_degree(degree, coefficients, parameters, symbol)

    def judge(part):
        return _region(part, parameters, degree)

    region, decided = judge(coefficients)
    return StabilityConditions(
        polynomial=polynomial_of(coefficients, symbol),
        symbol=symbol,
        parameters=parameters,
        degree=degree,
        region=region,
        minors=tuple(hurwitz_minors(shifted_coefficients(coefficients, degree))),
        degenerate=tuple(edges(coefficients, symbol, parameters, judge)),
        empty=region is sp.false if decided else None,
    )


def read_degree(degree, coefficients, parameters, symbol):
    """Return the degree of stability for an equation, all symbols of which are named."""
    degree = exact_decimals(read_expression(degree, "degree"))
    named = set(parameters) | {symbol}
    undeclared = set().union(degree.free_symbols, *(c.free_symbols for c in coefficients)) - named
    if undeclared:
        raise ValueError(
            f"parameters: the equation also has {join_names(undeclared)}; "
            "name every symbol that is not a number"
        )
    if degree.is_real is False or degree.is_negative:
        raise ValueError(f"degree: expected a real number that is not negative, got {degree}")
    return degree


def read_equation(poly_or_matrix, parameters, symbol):
    """Return the coefficients of a characteristic polynomial or of that of a matrix, and its symbol."""
    if has_floats(poly_or_matrix) and np.ndim(poly_or_matrix) == 2:
        poly_or_matrix = sp.Matrix(poly_or_matrix)
    if isinstance(poly_or_matrix, sp.MatrixBase):
        symbol = sp.Symbol("lambda") if symbol is None else read_symbols(symbol, "symbol")[0]
        poly_or_matrix = characteristic_polynomial(
            read_exact_matrix(poly_or_matrix, square=True), symbol
        )
    if symbol is None and isinstance(poly_or_matrix, sp.Expr):
        left = poly_or_matrix.free_symbols - set(parameters)
        symbol = left.pop() if len(left) == 1 else None
    coefficients = read_coefficients(poly_or_matrix, symbol)
    if isinstance(coefficients[0], Fraction):
        coefficients = [sp.Rational(c.numerator, c.denominator) for c in coefficients]
    if symbol is None:
        symbol = (
            poly_or_matrix.gens[0]
            if isinstance(poly_or_matrix, sp.Poly)
            else next(iter(poly_or_matrix.free_symbols))
            if isinstance(poly_or_matrix, sp.Expr)
            else sp.Symbol("lambda")
        )
    return coefficients, symbol


def polynomial_of(coefficients, symbol):
    """Return the polynomial with these coefficients, the highest power first."""
    order = len(coefficients) - 1
    return sum(c * symbol ** (order - i) for i, c in enumerate(coefficients))


def _region(coefficients, parameters, degree):
    """Return the reduced region and whether its emptiness is decided."""
    shifted = shifted_coefficients(coefficients, degree)
    sign = sign_of(shifted[0].xreplace(as_real(shifted[0])[0]))
    return reduced_region(shifted, parameters, (1, -1) if sign is None else (sign,))


def reduced_region(coefficients, parameters, signs):
    """Return where the Hurwitz criterion holds with one of the signs, and whether it is decided if empty."""
    to_real, from_real = as_real(*coefficients)
    real, symbols = (
        [c.xreplace(to_real) for c in coefficients],
        [to_real.get(p, p) for p in parameters],
    )
    regions = []
    for sign in signs:
        candidates = [conjunction(c, symbols) for c in _lienard_chipart([sign * c for c in real])]
        regions.append(min(candidates, key=lambda c: (not c[1], _length(c[0]))))
    return sp.Or(*(region for region, _ in regions)).xreplace(from_real), all(
        decided for _, decided in regions
    )


def _lienard_chipart(coefficients):
    """Return two equivalent lists of expressions that must be positive."""
    n = len(coefficients) - 1
    minors = hurwitz_minors(coefficients)
    every_second = [minors[k - 1] for k in range(n - 1, 0, -2)]
    even = [coefficients[i] for i in range(n, -1, -2)]
    odd = [coefficients[n]] + [coefficients[i] for i in range(n - 1, -1, -2)]
    return [[coefficients[0], *even, *every_second], [coefficients[0], *odd, *every_second]]


def _length(region):
    return len(region.args) if isinstance(region, sp.And) else 1, region.count_ops()


def edges(coefficients, symbol, parameters, judge, where=()):
    """Yield the edges where the leading coefficient vanishes, and then the next one."""
    lead, lower = coefficients[0], coefficients[1:]
    if sign_of(lead.xreplace(as_real(lead)[0])) is not None:
        return
    where += (sp.Eq(lead, 0),)
    for parameter in parameters:
        slope = sp.diff(lead, parameter)
        if slope != 0 and slope.is_number:
            value = sp.expand(parameter - lead / slope)
            lower = [sp.expand(c.subs(parameter, value)) for c in lower]
            where = (*where[:-1], sp.Eq(parameter, value))
            break
    while len(lower) > 1 and lower[0] == 0:
        lower = lower[1:]
    if len(lower) < 2:
        return
    yield Edge(sp.And(*where), polynomial_of(lower, symbol), judge(lower)[0])
    yield from edges(lower, symbol, parameters, judge, where)


def _exact_number(value):
    if isinstance(value, (float, np.floating)):
        if not np.isfinite(value):
            raise ValueError(f"point: expected finite numbers, got {value}")
        return sp.Rational(*float(value).as_integer_ratio())
    value = read_expression(value, "point")
    if isinstance(value, sp.Float):
        return sp.Rational(*float(value).as_integer_ratio())
    if not value.is_number or value.is_real is False:
        raise ValueError(f"point: expected real numbers, got {value}")
    return value


def latex_region(region):
    """Return LaTeX of a region of parameters, also of an empty one and of the whole space."""
    if region in (sp.true, sp.false):
        return r"\text{all values of the parameters}" if region == sp.true else r"\varnothing"
    return latex_condition(region)


def latex_condition(condition):
    """Return LaTeX of a condition with commas for 'and', as in the problem book."""
    if isinstance(condition, sp.And):
        return r",\quad ".join(
            sp.latex(c) for c in sorted(condition.args, key=lambda c: c.count_ops())
        )
    if isinstance(condition, sp.Or):
        return r"\quad\text{or}\quad ".join(latex_condition(c) for c in condition.args)
    return sp.latex(condition)
