"""Tolerances: how far a number of an answer may be off. No other module defines one.

- Exact: what is written without decimals has to be right, up to the rounding of what is computed
  with it.
- Decimals: a decimal d may stand for each number e with |d - e| at most half a unit of the third
  significant digit of e, however many digits d has: 7.17 may be 43/6, 7.2 may not. In expressions
  and conditions the same holds for each decimal, as SymPy keeps it (of 2*0.318*a it keeps 0.636*a):
  it may be anywhere in its interval (`exact_values`), and the answer is right if some choice gives
  what is right. A value of an expression is as uncertain as these intervals make it (`perturbed`,
  `tools.values.left_open`); the numbers in a condition are looked for (`tools.conditions`).
- Share: where the decimals are too many to be followed, and in a few residuals of matrices, they
  make each term uncertain by the share `DECIMALS`, which is half a unit at worst.
- Zero: a decimal that should be 0 has to be 0 itself. Beside larger numbers, in a vector or a
  matrix, it has the digits of a thousandth of the largest.
- Complex: the real and the imaginary part are two decimals, each with digits of its own; one that
  is 0, or small, has the digits of a thousandth of the modulus.
- Computed: where the reference itself is known to a precision only, as by a search, that replaces
  `EXACT`.

Numbers are compared by `agree`, entry by entry; a residual has no digits of its own, and its
tolerance is a share of its terms (`relative_tolerance`).
"""

from decimal import Decimal

import numpy as np
import sympy as sp

#: Relative tolerance for exact answers (rounding only).
EXACT = 1e-9
#: Relative tolerance for a double eigenvalue, whose error is the square root of rounding.
REPEATED = 1e-7
#: Largest relative uncertainty of a number with three digits: half a unit of the last in 1.00.
DECIMALS = 5e-3
#: Relative tolerance of half a unit itself (rounding only).
ROUNDING = 1e-9
#: A number smaller than this share of its neighbours is compared to three digits of that share.
NEGLIGIBLE = 1e-3
#: The terms of an expression with symbols may cancel to this share of their size.
CANCELLED = 0.1
#: Most decimals of an answer whose changes are computed one by one: if motions are simulated,
#: and if the answer is only evaluated.
MOST_FOLLOWED, MOST_EVALUATED = 12, 48
#: Most decimals of an expression whose changes are computed in pairs.
MOST_TOGETHER = 3


def in_decimals(*written):
    """Return whether answers, SymPy objects or lists of them, hold decimals other than zero."""
    return any(
        in_decimals(*part)
        if isinstance(part, (list, tuple))
        else any(not number.is_zero for number in sp.sympify(part).atoms(sp.Float))
        for part in written
    )


def perturbed(*written, max_count=MOST_FOLLOWED):
    """Return SymPy objects with each decimal at the ends of its interval.

    Parameters
    ----------
    *written : sympy.Basic
        The objects; the exponent of a root is exact however it is written.
    max_count : int
        The number of decimals up to which they are changed.

    Returns
    -------
    list or None
        For each decimal, the same with either sign, a pair of lists of the objects: with it smaller
        and larger. None if there are more decimals than `max_count`.
    """
    written, decimals = _followed(written)
    if len(decimals) > max_count:
        return None
    return [[_perturbed_by(written, (number,), side) for side in (-1, 1)] for number in decimals]


def perturbed_in_pairs(*written):
    """Return SymPy objects with two of their decimals larger, as `perturbed` makes one larger.

    Returns
    -------
    list of list
        For each decimal a list with one entry for each that comes after it; empty if there are more
        than `MOST_TOGETHER`.
    """
    written, decimals = _followed(written)
    return (
        [
            [_perturbed_by(written, (first, second), 1) for second in decimals[k + 1 :]]
            for k, first in enumerate(decimals)
        ]
        if len(decimals) <= MOST_TOGETHER
        else []
    )


def _followed(written):
    """Return the objects without decimals in roots, and the sizes of their decimals."""
    written = [sp.sympify(part) for part in written]
    roots = {
        power: sp.Pow(power.base, sp.nsimplify(power.exp, rational=True))
        for part in written
        for power in part.atoms(sp.Pow)
        if power.exp.is_Float and float(4 * power.exp).is_integer()
    }
    written = [part.xreplace(roots) for part in written]
    return written, sorted(
        {abs(n) for part in written for n in part.atoms(sp.Float) if n != 0}, key=float
    )


def _perturbed_by(written, numbers, side):
    ends = {}
    for number in numbers:
        end = sp.Float(exact_values(number)[side > 0], precision=number._prec)
        end += ROUNDING * (end - number)
        ends |= {number: end, -number: -end}
    return [part.xreplace(ends) for part in written]


def relative_tolerance(*written, computed=EXACT):
    """Return the tolerance of a residual relative to the size of its terms.

    Parameters
    ----------
    *written : sympy.Basic
        The answers that the residual is computed from.
    computed : float
        The relative precision of the reference.
    """
    return DECIMALS if in_decimals(*written) else computed


def exact_values(decimal):
    """Return the ends of the interval of numbers that a decimal may stand for, as fractions.

    Below a power of ten the third digit is finer: 1.00 may be from 0.9995 to 1.005. Of the numbers
    that one such as 9.99 may stand for, those next to it count.
    """
    if decimal < 0:
        return tuple(-end for end in reversed(exact_values(-decimal)))
    number = sp.Rational(str(decimal))
    if number == 0:
        return number, number
    # by Decimal, since it may be beyond what a float holds
    power = sp.Integer(10) ** Decimal(str(decimal)).adjusted()
    half = power / 200
    low = max(number - half, min(power, number - half / 10))
    return low, number + half if number + half < 10 * power else number + 10 * half


def half_unit(size):
    """Return half a unit of the third significant digit of numbers of this size; zero for zero."""
    with np.errstate(divide="ignore"):
        return 0.5 * (1 + ROUNDING) * 10.0 ** (np.floor(np.log10(np.abs(size))) - 2)


def rounds_to(value, true, size=0.0):
    """Return whether a real number equals another to three significant digits.

    Parameters
    ----------
    value, true : float
        The number of the answer and the true one.
    size : float
        The size of the numbers beside it, with which a small number has fewer digits.
    """
    return bool(
        abs(float(value) - float(true))
        <= half_unit(max(abs(float(true)), NEGLIGIBLE * float(size)))
    )


def agree(values, true, written, size=0.0, computed=EXACT, uncertain=None):
    """Return whether numbers that an answer became are the true ones.

    Parameters
    ----------
    values, true : complex or numpy.ndarray
        The numbers of the answer and the true ones.
    written : sympy.Expr or sympy.Matrix
        The answer, of the same shape.
    size : float or numpy.ndarray
        The size of the numbers that were computed with, in an array of those beside each.
    computed : float
        The relative precision of the true numbers.
    uncertain : array_like, optional
        By how much the decimals of an expression with symbols change its value; nan if not known.

    Returns
    -------
    bool or numpy.ndarray of bool
    """
    difference, true = np.asarray(values) - true, np.asarray(true)
    # a number alone has the digits of its own
    negligible_size = NEGLIGIBLE * np.maximum(np.abs(true), size if difference.shape else 0)
    allowed = np.array(2 * [computed * np.maximum(np.abs(true), size)])
    if in_decimals(written):
        has_symbols = np.vectorize(lambda e: bool(sp.sympify(e).free_symbols), otypes=[bool])(
            _entries(written)
        )
        uncertainty = DECIMALS * np.maximum(np.abs(true), CANCELLED * size)
        if uncertain is not None:
            uncertainty = np.where(np.isfinite(uncertain), uncertain, uncertainty)
        allowed = np.maximum(
            allowed,
            np.where(
                has_symbols,
                uncertainty,
                [half_unit(np.maximum(np.abs(p), negligible_size)) for p in (true.real, true.imag)],
            ),
        )
    correct = (np.abs([difference.real, difference.imag]) <= allowed).all(axis=0)
    return correct if correct.shape else bool(correct)


def _entries(written):
    if isinstance(written, sp.MatrixBase):
        return np.array(list(written), dtype=object).reshape(written.shape)
    return np.array(written, dtype=object)
