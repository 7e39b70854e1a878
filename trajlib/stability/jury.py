"""Regions of asymptotic stability in discrete time: the Jury criterion.

All roots of p(z) = a_0 z^n + ... + a_n, a_0 > 0, lie inside the unit circle (Schur stability) if and only if
p(1) > 0, (-1)^n p(-1) > 0 and certain minors of the coefficients are positive (E. I. Jury, Theory and
Application of the z-Transform Method, 1964). With z = (1 + w)/(1 - w) the circle becomes the left
half-plane, and

    q(w) = (1 - w)^n p(z),    q(0) = p(1),    leading coefficient (-1)^n p(-1),    q(1) = 2^n a_0,

has to satisfy the Hurwitz criterion with the sign of a_0, whose conditions are reduced in `regions`.
"""

import sympy as sp

from trajlib._arguments.renamed import renamed
from trajlib._arguments.state_space import accepts_state_space
from trajlib._arguments.symbols import read_symbols
from trajlib._real_symbols import as_real
from trajlib._typing import ExprLike, MatrixLike, PolynomialLike, Symbols
from trajlib.stability.hurwitz import hurwitz_minors
from trajlib.stability.inequalities import sign_of
from trajlib.stability.regions import (
    StabilityConditions,
    edges,
    polynomial_of,
    read_degree,
    read_equation,
    reduced_region,
)


@renamed(margin="degree")
@accepts_state_space("A", time="discrete", instead="use stability_conditions")
def jury_conditions(
    poly_or_matrix: PolynomialLike | MatrixLike,
    parameters: Symbols,
    degree: ExprLike = 0,
    symbol: sp.Symbol | None = None,
) -> StabilityConditions:
    """Return the conditions on `parameters` for asymptotic stability in discrete time.

    Parameters
    ----------
    poly_or_matrix : sympy.Expr, sympy.Poly, sequence of coefficients or matrix_like, shape (n, n)
        The characteristic polynomial (coefficients with the highest power first), or the matrix A
        of x_{i+1} = A x_i. A StateSpace stands for its A.
    parameters : sequence of sympy.Symbol
        All symbols in it; they stand for real numbers, and their assumptions (positive=True) are
        used.
    degree : float or sympy.Expr, default 0
        mu, at least 0 and less than 1, for |z| < 1 - mu.
    symbol : sympy.Symbol, optional
        The variable of the polynomial; may be left out if it is its only symbol beside `parameters`.

    Returns
    -------
    StabilityConditions
        The region, where all roots have |z| < 1 - mu, with the edges on which the order drops. Its
        minors are those of Hurwitz for q(w).

    Raises
    ------
    ValueError
        For symbols that are not named as parameters, for a degree of stability outside [0, 1), and as
        `hurwitz_matrix`.

    Notes
    -----
    Source: added to the problem book; the Jury criterion for Schur stability, in the form that the
    bilinear transformation z = (1 + w)/(1 - w) gives it.

    Examples
    --------
    >>> import sympy as sp
    >>> a, b, z = sp.symbols("a b z")
    >>> jury_conditions(z**2 + a*z + b, [a, b]).region
    (b < 1) & (a + b > -1) & (b + 1 > a)
    >>> jury_conditions(sp.Matrix([[a, 1], [0, b]]), [a, b]).contains([0.5, -0.99])
    True
    """
    parameters = read_symbols(parameters, "parameters")
    coefficients, symbol = read_equation(poly_or_matrix, parameters, symbol)
    degree = read_degree(degree, coefficients, parameters, symbol)
    if degree.is_number and degree >= 1:
        raise ValueError(f"degree: expected a number less than 1, got {degree}")

    def judge(part):
        return _region(_in_half_plane(part, degree), part[0], parameters)

    region, decided = judge(coefficients)
    half_plane = _in_half_plane(coefficients, degree)
    return StabilityConditions(
        polynomial=polynomial_of(coefficients, symbol),
        symbol=symbol,
        parameters=parameters,
        degree=degree,
        region=region,
        # where z = -1 is a root for all parameters, q(w) has lost its degree
        minors=() if half_plane[0] == 0 else tuple(hurwitz_minors(half_plane)),
        degenerate=tuple(edges(coefficients, symbol, parameters, judge)),
        empty=region is sp.false if decided else None,
    )


def _in_half_plane(coefficients, degree):
    """Return the n + 1 coefficients of q(w) for p((1 - degree) z)."""
    w, n = sp.Dummy("w"), len(coefficients) - 1
    transformed = sum(
        c * (1 - degree) ** (n - i) * (1 + w) ** (n - i) * (1 - w) ** i
        for i, c in enumerate(coefficients)
    )
    found = sp.Poly(sp.expand(transformed), w)
    return [found.nth(k) for k in range(n, -1, -1)]


def _region(transformed, lead, parameters):
    if transformed[0] == 0:  # z = -1 is a root for all parameters
        return sp.false, True
    sign = sign_of(lead.xreplace(as_real(lead)[0]))
    return reduced_region(transformed, parameters, (1, -1) if sign is None else (sign,))
