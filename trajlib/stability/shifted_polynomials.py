"""Polynomials with shifted roots, p(s - degree), for a degree of stability."""

from fractions import Fraction

import numpy as np
import sympy as sp

from trajlib._arguments.renamed import renamed
from trajlib._arguments.symbols import exact_decimals, read_expression
from trajlib._typing import ExprLike, PolynomialLike
from trajlib.stability.hurwitz import read_coefficients


@renamed(margin="degree")
def shift(
    poly: PolynomialLike, degree: ExprLike, symbol: sp.Symbol | None = None
) -> PolynomialLike:
    """Return p(s - degree), whose roots are those of p moved to the right by `degree`.

    All roots of p satisfy Re s < -degree exactly when those of p(s - degree) satisfy Re s < 0.

    Parameters
    ----------
    poly : sympy.Expr, sympy.Poly or sequence of coefficients
        The polynomial p; coefficients stand with the highest power first.
    degree : float or sympy.Expr
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
    degree = read_expression(degree, "degree")
    coefficients = read_coefficients(poly, symbol)
    floats = isinstance(coefficients[0], Fraction)
    if floats:
        coefficients = [sp.Rational(c.numerator, c.denominator) for c in coefficients]
    shifted = shifted_coefficients(coefficients, exact_decimals(degree))
    if isinstance(poly, sp.Poly):
        return sp.Poly(shifted, *poly.gens)
    if isinstance(poly, sp.Expr):
        variable = symbol if symbol is not None else next(iter(poly.free_symbols))
        return sp.expand(sum(c * variable ** (len(shifted) - 1 - i) for i, c in enumerate(shifted)))
    return np.array(shifted, dtype=float) if floats else shifted


def shifted_coefficients(coefficients, degree):
    """Return the coefficients of p(s - degree) by repeated Horner division."""
    work = list(coefficients)
    for last in range(len(work), 1, -1):
        for i in range(1, last):
            work[i] = sp.expand(work[i] - degree * work[i - 1])
    return work
