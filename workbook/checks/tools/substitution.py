"""Values of symbols substituted into an expression or a condition, and its evaluation there."""

import cmath
import functools
from contextlib import suppress

import mpmath
import sympy as sp

from workbook.checks.contract.coercion import LARGEST, MOST_ADDED
from workbook.checks.contract.verdict import Invalid

#: The digits to which a series is summed.
DIGITS = 25


def substituted(claim, values):
    """Return a claim with all values put in at once; `subs` would simplify after each of them."""
    if binds_symbols(claim):
        return claim.subs(values)
    return claim.xreplace({symbol: sp.sympify(value) for symbol, value in values.items()})


def evaluated(claim, values):
    """Return a claim at values, to 20 digits; nan if that compares complex numbers."""
    claim = sp.sympify(claim)
    if not binds_symbols(claim):
        # All values at once take a third of the time. What comes out finite is the number; where a
        # factor vanishes beside an infinite one, or a case that is not reached has no value, the
        # order matters and `subs` is asked.
        with suppress(TypeError, ValueError, AttributeError, ArithmeticError):
            numbers = {symbol: sp.sympify(value) for symbol, value in values.items()}
            number = _without_extremes(claim, numbers).xreplace(numbers).evalf(20)
            if cmath.isfinite(complex(number)):
                return number
    try:
        return _added(claim.subs(values)).evalf(20)
    except (TypeError, ValueError, ArithmeticError):
        # ValueError: the greater of two such numbers, in Max or Min; ArithmeticError: all digits of
        # a floor cancel.
        return sp.nan


def _without_extremes(claim, numbers):
    """Replace each Max and Min by its argument that clearly is the greatest or least.

    SymPy compares exact arguments, such as an angle with zero, by slow simplification.
    """
    chosen = {}
    # those within others first
    for part in sorted(claim.atoms(sp.Max, sp.Min), key=sp.count_ops):
        sign = 1 if isinstance(part, sp.Max) else -1
        sizes = {
            simplified: sign * complex(simplified.xreplace(numbers).evalf(20))
            for arg in part.args
            for simplified in [arg.xreplace(chosen)]
        }
        first, second, *_ = sorted(sizes, key=lambda arg: -sizes[arg].real)
        if not any(size.imag for size in sizes.values()) and (
            sizes[first] - sizes[second]
        ).real > 1e-9 * (1 + abs(sizes[first])):
            chosen[part] = first
    return claim.xreplace(chosen)


def _added(claim):
    """Return a claim with its sums added up term by term; SymPy may take minutes for a long one."""

    def added(term, limits, *outer_limits):
        index, first, last = limits
        steps_from_integer = not outer_limits and first.is_number and first == sp.floor(first)
        if steps_from_integer and last is sp.oo:
            return _series(lambda k: term.xreplace({index: sp.Integer(int(k))}), int(first))
        if not (
            steps_from_integer
            and last.is_number
            and last == sp.floor(last)
            and last - first < MOST_ADDED
        ):
            raise Invalid(
                f"a sum is added up term by term, between whole numbers and up to {MOST_ADDED} "
                "terms; yours cannot be: write it without `sp.Sum`"
            )
        return sp.Add(
            *(term.xreplace({index: sp.Integer(k)}) for k in range(int(first), int(last) + 1))
        )

    return claim.replace(sp.Sum, added) if claim.has(sp.Sum) else claim


def _series(term, first):
    """Return the sum of the terms term(first), term(first + 1), ... by extrapolation.

    Extrapolation gives a diverging series a sum too, so the terms have to fall faster than those of the
    harmonic series.
    """

    def number(k):
        # of which nsum wants more and more
        return mpmath.mpmathify(term(k).evalf(mpmath.mp.dps))

    with mpmath.workdps(DIGITS):
        near, far = (
            max(abs(number(first + count + k)) for k in range(8))
            for count in (MOST_ADDED // 4, MOST_ADDED // 2)
        )
        if not (far <= 0.48 * near or far == 0):
            raise Invalid(
                "your answer holds an infinite sum that does not converge fast enough to be "
                "computed: write it without `sp.Sum`"
            )
        return sp.sympify(mpmath.nsum(number, [first, mpmath.inf]))


@functools.lru_cache(maxsize=256)
def binds_symbols(claim):
    """Return whether a claim has bound symbols, such as the variable of an integral."""
    return any(
        getattr(part, "bound_symbols", None) or isinstance(part, sp.Derivative)
        for part in sp.preorder_traversal(claim)
    )


def real_at(claim, values):
    """Return the real number that an expression becomes; None if not real or not defined."""
    try:
        number = complex(evaluated(claim, values))
    except TypeError:
        return None
    is_finite = cmath.isfinite(number) and abs(number) < LARGEST
    return number.real if is_finite and abs(number.imag) < 1e-12 * (1 + abs(number)) else None
