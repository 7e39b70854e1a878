"""The characteristic polynomial and the Hurwitz criterion (Theorems 1.1 - 1.3).

For a_0 l^n + a_1 l^(n-1) + ... + a_n with a_0 > 0 all roots have negative real parts if and only if
the leading principal minors Delta_1, ..., Delta_n of

    a_1  a_3  a_5  ...
    a_0  a_2  a_4  ...
     0   a_1  a_3  ...
     0   a_0  a_2  ...

are positive. The minors come from one fraction-free elimination (Bareiss), whose pivots they are:
every division in it is exact, so that nothing has to be simplified on the way.
"""

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from trajlib._arguments.matrices import has_floats, read_exact_matrix, read_float_matrix
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals, join_names, read_expression, read_symbols
from trajlib._typing import ExprLike, Matrix, MatrixLike, PolynomialLike


@accepts_state_space("A")
def characteristic_polynomial(A: MatrixLike, symbol: sp.Symbol) -> sp.Expr:
    """Return the characteristic polynomial det(lambda I - A), monic.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        A SymPy matrix or a list of rows (exact), or a NumPy array of floats. A StateSpace stands
        for A.
    symbol : sympy.Symbol
        The lambda of the result.

    Returns
    -------
    sympy.Expr
        Expanded polynomial in `symbol`, with decimal coefficients for a float array.

    Raises
    ------
    ValueError
        If `A` is not square, is empty, is not real, or contains `symbol`.

    Notes
    -----
    MATLAB: ``charpoly``, ``poly``. Source: Theorem 1.1 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> k, s = sp.symbols("k s")
    >>> characteristic_polynomial(sp.Matrix([[0, 1], [-k, -2]]), s)
    k + s**2 + 2*s
    """
    (symbol,) = read_symbols(symbol, "symbol")
    if has_floats(A):
        A = read_float_matrix(A, square=True)
        return sum(
            (float(c) * symbol ** (len(A) - i) for i, c in enumerate(np.poly(A))), sp.Integer(0)
        )
    A = read_exact_matrix(A, square=True)
    if symbol in A.free_symbols:
        raise ValueError(f"symbol: {symbol} stands in the matrix itself; choose another name")
    domain_matrix = DomainMatrix.from_Matrix(A)
    domain = domain_matrix.domain
    coefficients = [domain.to_sympy(c) for c in domain_matrix.charpoly()]
    return sp.expand(sum(sp.expand(c) * symbol ** (A.rows - i) for i, c in enumerate(coefficients)))


def hurwitz_matrix(poly: PolynomialLike, symbol: sp.Symbol | None = None) -> Matrix:
    """Return the Hurwitz matrix of a polynomial, with the odd coefficients in its first row.

    Parameters
    ----------
    poly : sympy.Expr, sympy.Poly or sequence of coefficients
        The polynomial; coefficients stand with the highest power first. A leading coefficient known
        to be negative is made positive by changing all signs; one of unknown sign stays as it is.
    symbol : sympy.Symbol, optional
        The variable of an expression; may be left out if it is its only symbol.

    Returns
    -------
    matrix, shape (n, n)
        A SymPy matrix for exact coefficients, a NumPy array for floats.

    Raises
    ------
    ValueError
        If the polynomial is zero, constant or not real, or if an expression is no polynomial.

    Notes
    -----
    Source: Theorem 1.2 of the problem book, Gamma, with a_0 instead of 1.

    Examples
    --------
    >>> import sympy as sp
    >>> a, b, s = sp.symbols("a b s")
    >>> hurwitz_matrix(s**4 + a*s**3 + b*s**2 + s + 1, s)
    Matrix([
    [a, 1, 0, 0],
    [1, b, 1, 0],
    [0, a, 1, 0],
    [0, 1, b, 1]])
    """
    coefficients = with_positive_lead(read_coefficients(poly, symbol))
    n = len(coefficients) - 1
    rows = [
        [coefficients[k] if 0 <= (k := 2 * j - i + 1) <= n else 0 for j in range(n)]
        for i in range(n)
    ]
    return np.array(rows, dtype=float) if isinstance(coefficients[0], Fraction) else sp.Matrix(rows)


def hurwitz_minors(poly: PolynomialLike, symbol: sp.Symbol | None = None) -> list[ExprLike]:
    """Return the leading principal minors Delta_1, ..., Delta_n of the Hurwitz matrix.

    Parameters
    ----------
    poly : sympy.Expr, sympy.Poly or sequence of coefficients
        As in `hurwitz_matrix`, also for a negative leading coefficient.
    symbol : sympy.Symbol, optional
        The variable of an expression; may be left out if it is its only symbol.

    Returns
    -------
    list of sympy.Expr or float
        Expanded expressions for exact coefficients. Floats are taken as the rational numbers they
        are, so that the signs returned are those of the exact minors.

    Raises
    ------
    ValueError
        As `hurwitz_matrix`.

    Notes
    -----
    Source: Theorem 1.2 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> a, b, s = sp.symbols("a b s")
    >>> hurwitz_minors(s**4 + a*s**3 + b*s**2 + s + 1, s)
    [a, a*b - 1, -a**2 + a*b - 1, -a**2 + a*b - 1]
    >>> hurwitz_minors([1.0, 2.0, 3.0])
    [2.0, 6.0]
    """
    coefficients = with_positive_lead(read_coefficients(poly, symbol))
    floats = isinstance(coefficients[0], Fraction)
    n = len(coefficients) - 1
    exact = [sp.Rational(c.numerator, c.denominator) if floats else c for c in coefficients]
    domain, elements = sp.construct_domain(exact)
    rows = [
        [elements[k] if 0 <= (k := 2 * j - i + 1) <= n else domain.zero for j in range(n)]
        for i in range(n)
    ]
    minors = [domain.to_sympy(minor) for minor in leading_minors(rows, domain)]
    return [float(m) for m in minors] if floats else [sp.expand(m) for m in minors]


def leading_minors(rows, domain):
    """Return the leading principal minors of a square matrix over `domain` (Bareiss)."""
    n = len(rows)
    work = [list(row) for row in rows]
    minors, previous = [], domain.one
    for k in range(n):
        pivot = work[k][k]
        minors.append(pivot)
        if not pivot:
            # A zero pivot stops the elimination; the larger minors then need determinants of their
            # own.
            return minors + [
                DomainMatrix([row[:m] for row in rows[:m]], (m, m), domain).det()
                for m in range(k + 2, n + 1)
            ]
        for i in range(k + 1, n):
            for j in range(k + 1, n):
                work[i][j] = domain.exquo(work[i][j] * pivot - work[i][k] * work[k][j], previous)
        previous = pivot
    return minors


def read_coefficients(poly, symbol=None):
    """Return the coefficients, highest power first: SymPy expressions, or Fractions for floats."""
    if isinstance(poly, np.ndarray) and poly.ndim != 1:
        raise ValueError(
            f"poly: expected a list of coefficients, got an array of shape {poly.shape}"
        )
    if isinstance(poly, (Sequence, np.ndarray)) and not isinstance(poly, str):
        coefficients = _from_list(poly)
    else:
        coefficients = _from_expression(poly, symbol)
    while coefficients and coefficients[0] == 0:
        coefficients = coefficients[1:]
    if not coefficients:
        raise ValueError("poly: expected a polynomial that is not identically zero")
    if len(coefficients) == 1:
        raise ValueError(
            f"poly: expected a polynomial of degree 1 or more, got the constant {coefficients[0]}"
        )
    return coefficients


def _from_list(values):
    if any(isinstance(v, (float, np.floating)) for v in values):
        if not all(isinstance(v, (int, float, np.integer, np.floating)) for v in values):
            raise TypeError(
                "poly: floats and other kinds of coefficients stand in one list; write the floats "
                "exactly"
            )
        if not np.all(np.isfinite(np.asarray(values, dtype=float))):
            raise ValueError("poly: expected finite coefficients")
        return [Fraction(float(v)) for v in values]
    return [_real_coefficient(read_expression(v, "poly")) for v in values]


def _from_expression(poly, symbol):
    if isinstance(poly, sp.Poly):
        if len(poly.gens) > 1:
            raise ValueError(f"poly: expected a Poly in one symbol, got one in {poly.gens}")
        return [_real_coefficient(c) for c in poly.all_coeffs()]
    poly = exact_decimals(read_expression(poly, "poly"))
    if not poly.free_symbols:
        return [_real_coefficient(poly)]
    if symbol is None:
        if len(poly.free_symbols) > 1:
            names = join_names(poly.free_symbols)
            raise ValueError(f"symbol: say which symbol the polynomial is in (it has: {names})")
        (symbol,) = poly.free_symbols
    (symbol,) = read_symbols(symbol, "symbol")
    try:
        return [_real_coefficient(c) for c in sp.Poly(poly, symbol).all_coeffs()]
    except sp.PolynomialError:
        raise ValueError(f"poly: {poly} is not a polynomial in {symbol}") from None


def _real_coefficient(coefficient):
    coefficient = exact_decimals(coefficient)
    if coefficient.is_real is False or coefficient.has(sp.I):
        raise ValueError(f"poly: expected real coefficients, got {coefficient}")
    return coefficient


def with_positive_lead(coefficients):
    """Change all signs if the leading coefficient is negative: the roots stay the same."""
    lead = coefficients[0]
    negative = lead < 0 if isinstance(lead, Fraction) else lead.is_negative
    return [-c for c in coefficients] if negative else list(coefficients)
