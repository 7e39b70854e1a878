"""Regions of asymptotic stability in the space of parameters, also with a margin.

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

from trajlib._arguments.matrices import has_floats, read_exact_matrix
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
        margin.
    """

    where: sp.Basic
    polynomial: sp.Expr
    region: sp.Basic


@dataclass(frozen=True)
class StabilityConditions:
    """The set of parameters for which all roots of `polynomial` have real parts below -`margin`.

    Attributes
    ----------
    polynomial : sympy.Expr
        The characteristic polynomial.
    symbol : sympy.Symbol
        Its variable.
    parameters : tuple of sympy.Symbol
        The coordinates of the parameter space.
    margin : sympy.Expr
        mu >= 0 in Re lambda < -mu.
    region : sympy.Basic
        The answer as a condition: an And of strict inequalities in the shortest form found,
        `sp.true` or `sp.false`; an Or of such if a leading coefficient may have either sign.
    minors : tuple
        The Hurwitz minors Delta_1, ..., Delta_n of the shifted polynomial as computed.
    degenerate : tuple of Edge
        The edges on which the order drops; they are no part of `region`.
    empty : bool or None
        True if no parameters stabilise, False if some do, None if that could not be decided.
    """

    polynomial: sp.Expr
    symbol: sp.Symbol
    parameters: tuple[sp.Symbol, ...]
    margin: sp.Expr
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
        # Matplotlib, for a plot only
        from trajlib import plotting

        if len(self.parameters) != 2:
            raise ValueError(
                f"plot: a picture needs two parameters, this region has {len(self.parameters)}"
            )
        return plotting.region(self.region, self.parameters, first_range, second_range, ax=ax)

    def _repr_latex_(self):
        return f"$\\displaystyle {latex_region(self.region)}$"


@accepts_state_space(
    "A", time="continuous", instead="write its characteristic polynomial in w, z = (1 + w)/(1 - w)"
)
def stability_conditions(
    poly_or_matrix: PolynomialLike | MatrixLike,
    parameters: Symbols,
    margin: ExprLike = 0,
    symbol: sp.Symbol | None = None,
) -> StabilityConditions:
    """Return the conditions on `parameters` for asymptotic stability, also with a margin.

    Parameters
    ----------
    poly_or_matrix : sympy.Expr, sympy.Poly, sequence of coefficients or matrix_like, shape (n, n)
        The characteristic polynomial (coefficients with the highest power first), or the matrix A
        of x' = Ax. A StateSpace stands for its A.
    parameters : sequence of sympy.Symbol
        All symbols in it; they stand for real numbers, and their assumptions (positive=True) are
        used.
    margin : float or sympy.Expr, default 0
        mu >= 0, for Re lambda < -mu.
    symbol : sympy.Symbol, optional
        The variable of the polynomial.

    Returns
    -------
    StabilityConditions
        The region with its minors and degenerate edges.

    Raises
    ------
    ValueError
        For symbols that are not named as parameters, for a negative margin, and as
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
    >>> found = stability_conditions(sp.Matrix([[k1, 1], [1, k2]]), [k1, k2], margin=2)
    >>> found.region
    (k1 + k2 < -4) & (k1*k2 + 2*k1 + 2*k2 > -3)
    >>> found.contains([-5, -5]), found.contains([-2, -3])
    (True, False)
    """
    parameters = read_symbols(parameters, "parameters")
    margin = exact_decimals(read_expression(margin, "margin"))
    coefficients, symbol = _read_equation(poly_or_matrix, symbol)
    named = set(parameters) | {symbol}
    undeclared = set().union(margin.free_symbols, *(c.free_symbols for c in coefficients)) - named
    if undeclared:
        raise ValueError(
            f"parameters: the equation also has {join_names(undeclared)}; "
            "name every symbol that is not a number"
        )
    if margin.is_real is False or margin.is_negative:
        raise ValueError(f"margin: expected a real number that is not negative, got {margin}")
    return _conditions(coefficients, symbol, parameters, margin)


def _read_equation(poly_or_matrix, symbol):
    if has_floats(poly_or_matrix) and np.ndim(poly_or_matrix) == 2:
        poly_or_matrix = sp.Matrix(poly_or_matrix)
    if isinstance(poly_or_matrix, sp.MatrixBase):
        symbol = sp.Symbol("lambda") if symbol is None else read_symbols(symbol, "symbol")[0]
        poly_or_matrix = characteristic_polynomial(
            read_exact_matrix(poly_or_matrix, square=True), symbol
        )
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


def _conditions(coefficients, symbol, parameters, margin):
    region, decided = _region(coefficients, parameters, margin)
    return StabilityConditions(
        polynomial=_polynomial(coefficients, symbol),
        symbol=symbol,
        parameters=parameters,
        margin=margin,
        region=region,
        minors=tuple(hurwitz_minors(shifted_coefficients(coefficients, margin))),
        degenerate=tuple(_edges(coefficients, symbol, parameters, margin)),
        empty=region is sp.false if decided else None,
    )


def _polynomial(coefficients, symbol):
    degree = len(coefficients) - 1
    return sum(c * symbol ** (degree - i) for i, c in enumerate(coefficients))


def _region(coefficients, parameters, margin):
    """Return the reduced region and whether its emptiness is decided."""
    shifted = shifted_coefficients(coefficients, margin)
    to_real, from_real = as_real(*shifted)
    real, symbols = [c.xreplace(to_real) for c in shifted], [to_real.get(p, p) for p in parameters]
    lead = sign_of(real[0])
    regions = []
    for sign in (1, -1) if lead is None else (lead,):
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


def _edges(coefficients, symbol, parameters, margin, where=()):
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
    yield Edge(sp.And(*where), _polynomial(lower, symbol), _region(lower, parameters, margin)[0])
    yield from _edges(lower, symbol, parameters, margin, where)


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
