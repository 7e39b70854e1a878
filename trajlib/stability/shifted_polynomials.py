"""Polynomials with shifted roots, p(s - margin), for a stability margin."""

from fractions import Fraction

import numpy as np
import sympy as sp

from trajlib._arguments.symbols import exact_decimals, read_expression
from trajlib._typing import ExprLike, PolynomialLike
from trajlib.stability.hurwitz import read_coefficients


def shift(
    poly: PolynomialLike, margin: ExprLike, symbol: sp.Symbol | None = None
) -> PolynomialLike:
    """Return p(s - margin), whose roots are those of p moved to the right by `margin`.

    All roots of p satisfy Re s < -margin exactly when those of p(s - margin) satisfy Re s < 0.

    Parameters
    ----------
    poly : sympy.Expr, sympy.Poly or sequence of coefficients
        The polynomial p; coefficients stand with the highest power first.
    margin : float or sympy.Expr
        The shift.
    symbol : sympy.Symbol, optional
        The variable of an expression; may be left out if it is its only symbol.

    Returns
    -------
    sympy.Expr, sympy.Poly or list
        The shifted polynomial, of the kind of `poly`.

    Raises
    ------
    ValueError
        As `hurwitz_matrix`.

    Notes
    -----
    Source: worked example 4 of the problem book.

    Examples
    --------
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
    shifted = shifted_coefficients(coefficients, exact_decimals(margin))
    if isinstance(poly, sp.Poly):
        return sp.Poly(shifted, *poly.gens)
    if isinstance(poly, sp.Expr):
        variable = symbol if symbol is not None else next(iter(poly.free_symbols))
        return sp.expand(sum(c * variable ** (len(shifted) - 1 - i) for i, c in enumerate(shifted)))
    return np.array(shifted, dtype=float) if floats else shifted


def shifted_coefficients(coefficients, margin):
    """Return the coefficients of p(s - margin) by repeated Horner division."""
    work = list(coefficients)
    for last in range(len(work), 1, -1):
        for i in range(1, last):
            work[i] = sp.expand(work[i] - margin * work[i - 1])
    return work
