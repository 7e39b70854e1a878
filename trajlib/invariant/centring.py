"""Polynomials in centred and scaled time, and the rank of samples beyond that of floats.

Far from zero the powers of a time t are one function in floats: 1, t and t^2 at t = 1.7e9 differ by
less than their rounding. But only their span matters, and it is also that of the powers of

    tau = t/unit - shift,    unit a power of two, shift whole,    |tau| <= 3/2 on the record,

which floats give without cancellation. So all polynomials of the basis are read exactly and reduced
exactly (Gauss-Jordan, highest power first), and so are those of the nuisance. A member of the basis
may moreover be replaced by its remainder after the nuisance's polynomials: the weights give zero on
those. What floats still take for dependent is so exactly or by their rounding: 60 digits decide.
"""

from fractions import Fraction
from numbers import Real

import numpy as np
from numpy.polynomial import Polynomial

#: Decimal digits in which samples are computed if floats do not decide their rank, and the digits
#: to which a remainder has to vanish.
DIGITS, VANISHING = 60, 40


def time_scale(times):
    """Return (unit, shift) of tau = t/unit - shift, floats without rounding."""
    half = (times.max() - times.min()) / 2
    unit = 2.0 ** np.ceil(np.log2(half)) if half > 0 else 1.0
    return unit, float(np.rint((times.max() + times.min()) / 2 / unit))


def centred(functions, scale):
    """Return functions with the span of the given ones, and C: they are C times the given ones.

    Each new polynomial has the leading coefficient 1, and its power in no other one. The third
    result is the list of (index, polynomial) of the new ones that are polynomials.
    """
    import sympy as sp

    read = [_polynomial(y, scale) for y in functions]
    powers = [k for k, polynomial in enumerate(read) if polynomial is not None]
    non_polynomials = [k for k, polynomial in enumerate(read) if polynomial is None]
    if not powers:
        return list(functions), np.eye(len(functions)), []
    width = 1 + max(max(read[k].degree() for k in powers), 0)
    rows = [[read[k].nth(j) for j in range(width)][::-1] for k in powers]
    reduced, pivots = sp.Matrix(rows).row_join(sp.eye(len(rows))).rref()
    count = sum(pivot < width for pivot in pivots)
    polynomials = [_poly(list(reduced.row(i)[:width])) for i in range(count)]
    combination = np.zeros((count, len(functions)))
    combination[:, powers] = np.array(reduced[:count, width:].tolist(), dtype=float)
    symbols = set().union(*(getattr(functions[k], "free_symbols", set()) for k in powers))
    symbol = min(symbols, key=str) if symbols else None
    return (
        [functions[k] for k in non_polynomials]
        + [_function(p, scale, symbol) for p in polynomials],
        np.vstack([np.eye(len(functions))[non_polynomials], combination]),
        list(enumerate(polynomials, start=len(non_polynomials))),
    )


def remainders(polynomials, divisors, scale):
    """Return (index, function) of polynomials after subtraction of multiples of the `divisors`."""
    result = []
    for k, remainder in polynomials:
        for _, divisor in divisors:
            remainder -= remainder.nth(divisor.degree()) * divisor
        result.append((k, _series(remainder, scale)))
    return result


def exact_rank(functions, times):
    """Return the rank of the samples in 60 digits; None if a function has floats only."""
    import mpmath

    with mpmath.workdps(DIGITS):
        columns = [_long_samples(y, [mpmath.mpf(float(t)) for t in times]) for y in functions]
        if any(column is None for column in columns):
            return None
        columns = [column / size for column in columns if (size := mpmath.sqrt(column @ column))]
        rank = 0
        while columns:
            sizes = [mpmath.sqrt(column @ column) for column in columns]
            k = max(range(len(sizes)), key=sizes.__getitem__)
            if sizes[k] < mpmath.mpf(10) ** -VANISHING:
                break
            direction = columns.pop(k) / sizes[k]
            columns = [column - (direction @ column) * direction for column in columns]
            rank += 1
        return rank


def _polynomial(y, scale):
    """Return a function of time as an exact SymPy polynomial in tau, or None if it is none."""
    import sympy as sp

    unit, shift = (sp.Rational(part) for part in scale)
    t = _poly([unit, unit * shift])
    if hasattr(y, "free_symbols"):
        if len(y.free_symbols) > 1 or not y.is_polynomial(*y.free_symbols):
            return None
        variable = next(iter(y.free_symbols), sp.Dummy())
        coefficients = [_exact(c) for c in sp.Poly(y, variable).all_coeffs()]
    elif isinstance(y, Real):
        coefficients = [_exact(y)]
    elif hasattr(y, "deriv") and hasattr(y, "window"):
        (low, high), (first, last) = (
            [_exact(end) for end in ends] for ends in (y.domain, y.window)
        )
        series = y.convert(kind=Polynomial, domain=y.domain, window=y.window)
        coefficients = [_exact(c) for c in series.coef[::-1]]
        t = first + (t - low) * ((last - first) / (high - low))
    else:
        return None
    if any(c is None for c in coefficients):
        return None
    return _poly(coefficients).compose(t)


def _poly(coefficients):
    """Return the polynomial in tau with rational coefficients, that of the highest power first."""
    import sympy as sp

    return sp.Poly(coefficients, sp.Symbol("tau"), domain="QQ")


def _exact(number):
    """Return a real number as a rational one, a float as what it is, others to 60 digits."""
    import sympy as sp

    number = sp.sympify(number)
    if number.is_Float:
        return sp.Rational(*(int(part) for part in Fraction(float(number)).as_integer_ratio()))
    if number.is_Rational:
        return number
    return sp.Rational(str(sp.N(number, DIGITS))) if number.is_real and number.is_finite else None


def _function(polynomial, scale, symbol):
    """Return a polynomial in tau as a function of t: SymPy's if `symbol` is given."""
    if symbol is None:
        return _series(polynomial, scale)
    import sympy as sp

    # Horner's form: SymPy would multiply out a number times a sum, and tau would lose its digits.
    unit, shift = (sp.Rational(part) for part in scale)
    result = sp.S.Zero
    for coefficient in polynomial.all_coeffs():
        result = result * (symbol / unit - shift) + coefficient
    return result


def _series(polynomial, scale):

    unit, shift = scale
    coefficients = [float(c) for c in polynomial.all_coeffs()[::-1]]
    return Polynomial(coefficients, domain=[unit * (shift - 1), unit * (shift + 1)])


def _long_samples(y, times):
    import mpmath
    import sympy as sp

    if isinstance(y, Real):
        y = sp.Float(y) if isinstance(y, float) else sp.sympify(y)
    elif hasattr(y, "deriv") and hasattr(y, "window"):
        y = _polynomial(y, (1.0, 0.0)).as_expr()
    elif not hasattr(y, "free_symbols"):
        return None
    (symbol,) = y.free_symbols or {sp.Dummy()}
    function = sp.lambdify(symbol, y, "mpmath")
    return np.array([mpmath.mpf(function(t)) for t in times], dtype=object)
