"""Expressions as functions of floats and arrays, compiled by NumPy where it can."""

import builtins
import cmath
import dis

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import Invalid
from workbook.checks.tools.substitution import real_at

#: At how many points integrals are computed for one verdict.
MOST_INTEGRATED = 400
#: The digits of numbers of any size.
LONG = 100


def real_function(symbols, expressions):
    """Return a function of numbers or arrays for several expressions.

    Parameters
    ----------
    symbols : list of sympy.Symbol
        Its arguments.
    expressions : list of sympy.Expr
        Expressions in these symbols.

    Returns
    -------
    callable
        It returns an array with a row for each expression; nan where one is not a real number.
    """
    # Only SymPy functions of the data's own symbols come here (coercion.with_symbols), so the code
    # made is ours. A docstring would take as long as the code.
    compiled = [_compiled(symbols, e) for e in expressions]

    def value_of(function, numbers, shape):
        try:
            values = function(*numbers)
            # the way through arrays takes ten times as long, and a motion asks thousands of times
            if not shape:
                number = complex(values)
                return (
                    number.real
                    if cmath.isfinite(number) and abs(number.imag) < 1e-9 * (1 + abs(number))
                    else np.nan
                )
            if isinstance(values, np.ndarray) and values.dtype == float and values.shape == shape:
                return np.where(np.isfinite(values), values, np.nan)
            values = np.broadcast_to(np.asarray(values, dtype=complex), shape)
        except (ZeroDivisionError, OverflowError):  # of the numbers in the expression itself
            return np.full(shape, np.nan)
        except (TypeError, ValueError, AttributeError, NameError):
            raise Invalid(
                "your answer cannot be evaluated at numbers: write it with functions such as "
                "sqrt, sin, Abs, sign or Piecewise"
            ) from None
        return np.where(
            np.isfinite(values) & (abs(values.imag) < 1e-9 * (1 + abs(values))), values.real, np.nan
        )

    def evaluate(*numbers):
        # NumPy's numbers divide by zero without an error.
        numbers = [np.asarray(number, dtype=float)[()] for number in numbers]
        single = all(type(number) is np.float64 for number in numbers)
        shape = () if single else np.broadcast_shapes(*(number.shape for number in numbers))
        with np.errstate(all="ignore"):
            return np.array([value_of(function, numbers, shape) for function in compiled])

    return evaluate


def multiprecision_function(symbols, expressions):
    """Return the same as `real_function`, computed point by point in 100 digits.

    It is slow: for points where an answer would be wrong because floats on the way are too large, or
    all alike.
    """

    def evaluate(*numbers):
        points = [
            {s: sp.Float(number, LONG) for s, number in zip(symbols, point)}
            for point in np.broadcast(*numbers)
        ]
        return np.array(
            [[real_at(e, point) for point in points] for e in expressions], dtype=float
        ).reshape(len(expressions), *np.broadcast_shapes(*map(np.shape, numbers)))

    return evaluate


def is_slow(e):
    """Return whether an expression holds an integral or a sum, to be computed point by point."""
    return e.has(sp.Integral, sp.Sum)


def _compiled(symbols, e):
    """Return one expression as a function of arrays, by NumPy or SciPy's special functions."""
    for libraries in () if is_slow(e) else (["numpy"], ["scipy", "numpy"]):
        function = sp.lambdify(
            symbols, _printable(e), [{"select": _first_of}, *libraries], docstring_limit=0
        )
        globals_by_name = {
            name: function.__globals__.get(name, getattr(builtins, name, None))
            for name in function.__code__.co_names
        }
        unsupported = {
            name
            for name, value in globals_by_name.items()
            if value is None or getattr(value, "__module__", None) == "math"
        }
        # Some of these are attributes, as in `logical_and.reduce`.
        if not unsupported or not any(
            step.opname == "LOAD_GLOBAL" and step.argval in unsupported
            for step in dis.get_instructions(function)
        ):
            return function
    return _one_by_one(symbols, e)


def _one_by_one(symbols, e):
    """Return an expression with functions unknown to NumPy and SciPy, for one point at a time."""
    points = 0

    def value(*numbers):
        nonlocal points
        points += 1
        if points > MOST_INTEGRATED:
            raise Invalid(
                "your answer holds an integral, a sum or a special function and is asked for at "
                "many points; write it without"
            )
        number = real_at(e, dict(zip(symbols, map(sp.Float, numbers))))
        return np.nan if number is None else number

    return np.vectorize(value, otypes=[float])


def _printable(e):
    """Return the expression without choices that SymPy would simplify before printing."""
    if e.has(sp.nan, sp.zoo):
        return sp.nan
    if e.has(sp.Heaviside):
        e = e.rewrite(sp.Piecewise)
    return (
        e.replace(sp.ITE, lambda a, b, c: sp.Or(sp.And(a, b), sp.And(sp.Not(a), c)))
        if e.has(sp.ITE)
        else e
    )


def _first_of(conditions, values, default):
    """Replace NumPy's `select`, which a Piecewise becomes, in a fraction of its time."""
    chosen = default
    for condition, value in zip(conditions[::-1], values[::-1]):
        if not (isinstance(condition, bool) or condition.dtype == bool):
            raise TypeError("a case has to be given by a condition")
        chosen = np.where(condition, value, chosen)
    return chosen
