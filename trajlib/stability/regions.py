"""Regions of asymptotic stability in the space of parameters, with a margin where one is asked for.

The criterion of Hurwitz is used in the form of Lienard and Chipart: with positive coefficients of
one parity only every second Hurwitz minor need be tested (F. R. Gantmacher, The Theory of Matrices,
vol. 2, XV.13). What remains is reduced, and conditions that follow from the others are left out.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import is_float_array, read_exact_matrix
from trajlib._arguments.symbols import (
    exact_decimals,
    join_names,
    read_expression,
    read_expressions,
    read_symbols,
)
from trajlib._real_symbols import as_real
from trajlib.stability.hurwitz import characteristic_polynomial, hurwitz_minors, read_coefficients
from trajlib.stability.inequalities import conjunction, sign_of


def shift(poly, margin, symbol=None):
    """The polynomial p(s - margin), whose roots are those of p moved to the right by `margin`.

    All roots of p satisfy Re s < -margin exactly when those of p(s - margin) satisfy Re s < 0
    (worked example 4 of the problem book). `poly` is an expression with its `symbol`, a `Poly`, or
    a list of coefficients, highest power first; the result is of the same kind. Errors as in
    `hurwitz_matrix`.

    >>> import sympy as sp
    >>> s = sp.Symbol("s")
    >>> shift(s**2 + 4*s + 5, 2, s)
    s**2 + 1
    >>> shift([1, 4, 5], 2)
    [1, 0, 1]
    """
    margin = read_expression(margin, "margin")
    coefficients = read_coefficients(poly, symbol)
    floats = isinstance(coefficients[0], Fraction)
    if floats:
        coefficients = [sp.Rational(c.numerator, c.denominator) for c in coefficients]
    shifted = _shifted(coefficients, exact_decimals(margin))
    if isinstance(poly, sp.Poly):
        return sp.Poly(shifted, *poly.gens)
    if isinstance(poly, sp.Expr):
        variable = symbol if symbol is not None else next(iter(poly.free_symbols))
        return sp.expand(sum(c * variable ** (len(shifted) - 1 - i) for i, c in enumerate(shifted)))
    return np.array(shifted, dtype=float) if floats else shifted


def _shifted(coefficients, margin):
    """Coefficients of p(s - margin) by repeated Horner division."""
    work = list(coefficients)
    for last in range(len(work), 1, -1):
        for i in range(1, last):
            work[i] = sp.expand(work[i] - margin * work[i - 1])
    return work


@dataclass(frozen=True)
class Edge:
    """A part of the parameter space where the leading coefficient vanishes and the order of the
    equation drops.

    `where` is the equation of the edge, `polynomial` the characteristic polynomial left there,
    `region` the condition under which that equation of lower order is asymptotically stable (with
    the same margin) on the edge.
    """

    where: sp.Basic
    polynomial: sp.Expr
    region: sp.Basic


@dataclass(frozen=True)
class StabilityConditions:
    """Where in the space of `parameters` all roots of `polynomial` have real parts below -`margin`.

    - `region`: the answer as a condition: an And of strict inequalities in the shortest form found,
      `sp.true` or `sp.false`; an Or of such if a leading coefficient of either sign can do.
    - `minors`: the Hurwitz minors Delta_1, ..., Delta_n of the shifted polynomial as computed.
    - `degenerate`: the edges on which the order drops (tuple of `Edge`); they are no part of
      `region`.
    - `empty`: True if no parameters stabilise, False if some do, None if that could not be decided.
    """

    polynomial: sp.Expr
    symbol: sp.Symbol
    parameters: tuple
    margin: sp.Expr
    region: sp.Basic
    minors: tuple
    degenerate: tuple
    empty: bool | None

    def contains(self, point):
        """Whether `point` (a dict symbol -> number, or numbers in the order of the parameters) lies
        in the region.

        Floats count as the exact numbers they are, so that points close to the boundary are judged
        correctly.
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

    def plot(self, first_range, second_range, ax=None):
        """Draw the region over a rectangle of the two parameters; returns the Axes."""
        from trajlib import plotting

        if len(self.parameters) != 2:
            raise ValueError(
                f"plot: a picture needs two parameters, this region has {len(self.parameters)}"
            )
        return plotting.region(self.region, self.parameters, first_range, second_range, ax=ax)

    def _repr_latex_(self):
        return f"$\\displaystyle {latex_region(self.region)}$"


def stability_conditions(poly_or_matrix, parameters, margin=0, symbol=None):
    """Conditions on `parameters` for asymptotic stability, with margin where one is asked for.

    `poly_or_matrix`: a characteristic polynomial (expression with its `symbol`, `Poly`, or
    coefficients, highest power first) or a square SymPy matrix A of x' = Ax. `parameters`: the
    symbols in it; they stand for real numbers, and their assumptions (positive=True) are used.
    `margin` mu >= 0 asks for Re lambda < -mu. Returns `StabilityConditions`. Raises ValueError for
    symbols that are not named as parameters and for whatever `hurwitz_matrix` refuses.

    Definition 1.5 of the problem book, with its sign put right, asks for Re lambda <= -mu; the
    region here is the interior of that set: the points of its boundary, where a root lies on the
    line Re lambda = -mu, are not in it. With mu = 0 it is the criterion of Hurwitz, Theorem 1.2.

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
    if is_float_array(poly_or_matrix) and poly_or_matrix.ndim == 2:
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
        minors=tuple(hurwitz_minors(_shifted(coefficients, margin))),
        degenerate=tuple(_edges(coefficients, symbol, parameters, margin)),
        empty=region is sp.false if decided else None,
    )


def _polynomial(coefficients, symbol):
    degree = len(coefficients) - 1
    return sum(c * symbol ** (degree - i) for i, c in enumerate(coefficients))


def _region(coefficients, parameters, margin):
    """The reduced region and whether its emptiness is decided."""
    shifted = _shifted(coefficients, margin)
    to_real, back = as_real(*shifted)
    real, symbols = [c.xreplace(to_real) for c in shifted], [to_real.get(p, p) for p in parameters]
    lead = sign_of(real[0])
    found = []
    for sign in (1, -1) if lead is None else (lead,):
        candidates = [conjunction(c, symbols) for c in _lienard_chipart([sign * c for c in real])]
        found.append(min(candidates, key=lambda c: (not c[1], _length(c[0]))))
    return sp.Or(*(region for region, _ in found)).xreplace(back), all(
        decided for _, decided in found
    )


def _lienard_chipart(coefficients):
    """Two equivalent lists of expressions that must be positive."""
    n = len(coefficients) - 1
    minors = hurwitz_minors(coefficients)
    every_second = [minors[k - 1] for k in range(n - 1, 0, -2)]
    even = [coefficients[i] for i in range(n, -1, -2)]
    odd = [coefficients[n]] + [coefficients[i] for i in range(n - 1, -1, -2)]
    return [[coefficients[0], *even, *every_second], [coefficients[0], *odd, *every_second]]


def _length(region):
    return len(region.args) if isinstance(region, sp.And) else 1, region.count_ops()


def _edges(coefficients, symbol, parameters, margin, where=()):
    """The edges where the leading coefficient vanishes, and where after that the next one does."""
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
    """A region of parameters in LaTeX, also an empty one and the whole space."""
    if region in (sp.true, sp.false):
        return r"\text{all values of the parameters}" if region == sp.true else r"\varnothing"
    return latex_condition(region)


def latex_condition(condition):
    """A condition in LaTeX with commas for 'and', as in the problem book."""
    if isinstance(condition, sp.And):
        return r",\quad ".join(
            sp.latex(c) for c in sorted(condition.args, key=lambda c: c.count_ops())
        )
    if isinstance(condition, sp.Or):
        return r"\quad\text{or}\quad ".join(latex_condition(c) for c in condition.args)
    return sp.latex(condition)
