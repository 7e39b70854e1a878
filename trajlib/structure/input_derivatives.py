"""Scalar equations with input derivatives and their state form: problems 2.20 - 2.22, 2.29.

An equation x^(n) + a_1 x^(n-1) + ... + a_n x = b_0 u^(n-1) + ... + b_(n-1) u has the state

    x_1 = x,    x_(k+1) = x_k' - beta_k u,    beta_k = b_(k-1) - a_1 beta_(k-1) - ... - a_(k-1) beta_1,

in which no derivative of u is left: A is the companion matrix (ones above the diagonal, last row
(-a_n, ..., -a_1)), the column is b = (beta_1, ..., beta_n), and x = x_1. The numbers beta_k are
those of the expansion right/left = beta_1/s + beta_2/s^2 + ... This state is always observable; it
is controllable exactly when both sides have no common factor.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib._arguments.matrices import read_exact_matrix, read_observed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import exact_decimals, read_expression, read_symbols
from trajlib._typing import MatrixLike, PolynomialLike
from trajlib.stability.hurwitz import characteristic_polynomial
from trajlib.structure import exact
from trajlib.structure.canonical import controller_canonical_form
from trajlib.structure.decomposition import observability_decomposition
from trajlib.structure.pbh import visible_symbol


def state_form(
    left: PolynomialLike, right: PolynomialLike, symbol: sp.Symbol | None = None
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Return the state form (A, b, h) of the scalar equation left(d/dt) x = right(d/dt) u.

    Parameters
    ----------
    left, right : sequence of sympy.Expr, sympy.Expr or sympy.Poly
        The coefficients, highest derivative first ([1, -1, -2] for x'' - x' - 2x), or polynomials
        in `symbol`; exact, also with symbols. The highest coefficient of `left` must not vanish.
    symbol : sympy.Symbol, optional
        Stands for d/dt in polynomials.

    Returns
    -------
    A : sympy.Matrix, shape (n, n)
        The companion matrix.
    b : sympy.Matrix, shape (n, 1)
        The column of the control.
    h : sympy.Matrix, shape (1, n)
        (1, 0, ...): x = h (x_1, ..., x_n), with x_1 = x, x_(k+1) = x_k' - b_k u.

    Raises
    ------
    ValueError
        If `left` is constant, or if the degree of `right` is that of `left` or more: then x
        contains u itself.

    Notes
    -----
    MATLAB: ``tf2ss``, ``ss(tf(...))``. Source: problem 2.29 of the problem book.

    Examples
    --------
    >>> A, b, h = state_form([1, -1, -2], [1, 1])
    >>> A, b.T, h
    (Matrix([
    [0, 1],
    [2, 1]]), Matrix([[1, 2]]), Matrix([[1, 0]]))
    """
    left, right = _coefficients(left, symbol, "left"), _coefficients(right, symbol, "right")
    n = len(left) - 1
    if n < 1:
        raise ValueError("left: expected an equation of order 1 or more for x")
    if len(right) > n:
        raise ValueError(
            f"right: expected derivatives of u up to order {n - 1}, below the order {n} of the "
            f"equation; with order {len(right) - 1} the output contains u itself: subtract a "
            "multiple of u from x first"
        )
    a = [sp.cancel(c / left[0]) for c in left]
    c = [sp.Integer(0)] * (n - len(right)) + [sp.cancel(e / left[0]) for e in right]
    beta: list[sp.Expr] = []
    for k in range(n):
        beta.append(sp.cancel(c[k] - sum(a[k - i] * beta[i] for i in range(k))))
    A = sp.Matrix(n, n, lambda i, j: -a[n - j] if i == n - 1 else int(j == i + 1))
    return A, sp.Matrix(beta), sp.Matrix([[1] + [0] * (n - 1)])


@dataclass(frozen=True)
class ScalarEquation:
    """The equation left(d/dt) z = right(d/dt) u.

    Attributes
    ----------
    left, right : sympy.Expr
        Polynomials in `symbol`; `left` is monic.
    symbol : sympy.Symbol
        Stands for d/dt.
    output : sympy.Matrix, shape (1, n)
        The row h of z = h x.
    """

    left: sp.Expr
    right: sp.Expr
    symbol: sp.Symbol
    output: sp.Matrix

    @property
    def order(self) -> int:
        """Return the order of the equation, the degree of `left`."""
        return sp.degree(self.left, self.symbol)

    def _repr_latex_(self):
        sides = [
            _in_derivatives(sp.Poly(p, self.symbol), name)
            for p, name in ((self.left, "z"), (self.right, "u"))
        ]
        return f"$\\displaystyle {sides[0]} = {sides[1]}$"


@accepts_state_space("A", "b", "h", C="h")
def scalar_equation(A: MatrixLike, b: MatrixLike, h: MatrixLike | None = None) -> ScalarEquation:
    """Return the scalar equation between the output z = hx and the control of x' = Ax + bu.

    It has the lowest order that all motions allow: the rank of the observability matrix, n for an
    observable pair; common factors of both sides, which belong to uncontrollable modes, stay.

    Parameters
    ----------
    A : matrix_like, shape (n, n)
        Matrix of the system; exact, also with symbols (generic).
    b : matrix_like, shape (n, 1)
        Column of the control.
    h : matrix_like, shape (1, n), optional
        Row of the output; without it z is the first coordinate of the controller canonical form,
        and the equation is Delta(d/dt) z = u.

    Returns
    -------
    ScalarEquation
        Both sides and the row h.

    Raises
    ------
    ValueError
        For floats, if shapes do not fit, and, without `h`, for a pair that is not controllable.

    Notes
    -----
    MATLAB: ``tf(ss(A, b, h, 0))``. Source: problems 2.20 - 2.22 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> found = scalar_equation(sp.Matrix([[1, 1], [-3, 1]]), sp.Matrix([0, 1]))
    >>> found.left, found.right, found.output
    (s**2 - 2*s + 4, 1, Matrix([[1, 0]]))
    """
    if h is None:
        h = controller_canonical_form(A, b).transformation[0, :]
    A, h = read_observed(A, h, "h")
    if isinstance(A, np.ndarray):
        raise ValueError("A: expected exact matrices (SymPy); for floats use control.ss2tf")
    b = read_exact_matrix(b, "b", flat="column")
    if b.shape != (A.rows, 1):
        raise ValueError(f"b: expected one column of length {A.rows}, got shape {b.shape}")
    if h.rows != 1:
        raise ValueError(f"h: expected one row, got {h.rows}; take the outputs one by one")
    s = visible_symbol(A, b, h, names=("s", "p", "lambda", "d"))
    split = observability_decomposition(A, h)
    k = split.sizes[0]
    if not k:
        raise ValueError("h: the output vanishes identically; there is no equation for it")
    A11, h1 = split.part
    b1 = exact.product(split.transformation, b)[:k, :]
    left = characteristic_polynomial(A11, s)
    right = sum(
        sp.expand((h1 * _adjugate_coefficient(A11, left, s, i) * b1)[0]) * s**i for i in range(k)
    )
    return ScalarEquation(left, sp.expand(right), s, h)


def _adjugate_coefficient(A, polynomial, s, power):
    """Return the coefficient of s^power in adj(sI - A), by Horner's rule."""
    a = sp.Poly(polynomial, s).all_coeffs()
    result = sp.zeros(A.rows)
    for coefficient in a[: A.rows - power]:
        result = result * A + coefficient * sp.eye(A.rows)
    return result


def _coefficients(polynomial, symbol, name):
    """Return exact coefficients, highest first, without leading zeros; also of a constant."""
    if isinstance(polynomial, sp.Poly):
        coefficients = polynomial.all_coeffs()
    elif symbol is not None:
        (symbol,) = read_symbols(symbol, "symbol")
        expression = exact_decimals(read_expression(polynomial, name))
        if not expression.is_polynomial(symbol):
            raise ValueError(f"{name}: {expression} is not a polynomial in {symbol}")
        coefficients = sp.Poly(expression, symbol).all_coeffs()
    elif isinstance(polynomial, (str, sp.Expr)) or not isinstance(polynomial, Iterable):
        raise ValueError(
            f"{name}: expected the list of coefficients, highest derivative first, or an "
            f"expression together with `symbol`, which stands for d/dt; got {polynomial!r}"
        )
    else:
        coefficients = [exact_decimals(read_expression(c, name)) for c in polynomial]
    while coefficients and coefficients[0] == 0:
        coefficients = coefficients[1:]
    return coefficients


def _in_derivatives(polynomial, name):
    """Return a sum of derivatives in LaTeX, highest first."""
    marks = {0: "", 1: r"\dot ", 2: r"\ddot "}
    terms = []
    for (power,), coefficient in polynomial.terms():
        sign = "-" if coefficient.could_extract_minus_sign() else "+"
        size = (
            abs(coefficient)
            if coefficient.is_number
            else (-coefficient if sign == "-" else coefficient)
        )
        factor = "" if size == 1 else (f"({sp.latex(size)})" if size.is_Add else sp.latex(size))
        derivative = f"{marks[power]}{name}" if power in marks else f"{name}^{{({power})}}"
        terms.append((sign, f"{factor}{derivative}"))
    if not terms:
        return "0"
    text = ("-" if terms[0][0] == "-" else "") + terms[0][1]
    return text + "".join(f" {sign} {term}" for sign, term in terms[1:])
