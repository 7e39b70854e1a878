"""Domains of symbols, and values within them.

A domain is a dict from symbols to SymPy intervals; what it does not name ranges over all that the
assumptions of the symbol allow.
"""

import functools
import math
from fractions import Fraction

import numpy as np
import sympy as sp

POSITIVE, NEGATIVE = sp.Interval.open(0, sp.oo), sp.Interval.open(-sp.oo, 0)


def sample_cases(parameters):
    """Return sample values of all parameters together: one row for each case."""
    if not parameters:
        return [()]
    columns = [
        [float(value) for value in domain]
        if isinstance(domain, sp.FiniteSet)
        else values_inside(float(domain.inf), float(domain.sup))
        for domain in parameters.values()
    ]
    return [
        tuple(float(column[(k + 2 * c) % len(column)]) for c, column in enumerate(columns))
        for k in range(len(columns[0]))
    ]


def values_inside(low, high, count=6):
    """Return values inside an interval, which may be infinite."""
    shares = (np.arange(count) + 0.55) / count
    if np.isfinite(low) and np.isfinite(high):
        return low + (high - low) * shares
    if np.isfinite(low):
        return low + 0.8 * shares / (1.1 - shares)
    if np.isfinite(high):
        return high - 0.8 * shares / (1.1 - shares)
    return 4 * (2 * shares - 1)


def interval_of(symbol, domain):
    """Return the interval of a symbol: from the domain, else from its assumptions."""
    if domain and symbol in domain:
        return domain[symbol]
    if symbol.is_positive:
        return POSITIVE
    if symbol.is_negative:
        return NEGATIVE
    return sp.S.Reals


def endpoints(symbol, domain):
    """Return the endpoints of the interval of a symbol, as floats."""
    return _ends_of(interval_of(symbol, domain))


def scaled_interval(interval, factor):
    """Return an interval, or finite set, times a positive factor."""
    if isinstance(interval, sp.FiniteSet):
        return sp.FiniteSet(*(factor * value for value in interval))
    return sp.Interval(
        factor * interval.start, factor * interval.end, interval.left_open, interval.right_open
    )


@functools.lru_cache(maxsize=64)
def _ends_of(interval):
    return float(interval.start), float(interval.end)


def lies_inside(value, symbol, domain):
    """Return whether a value of a symbol lies in the open interval of its domain."""
    low, high = endpoints(symbol, domain)
    return low < value < high


def random_value(random, symbol, domain, share=None, unit=1.0):
    """Return a random value of a symbol, of a moderate size.

    Parameters
    ----------
    random : numpy.random.Generator
        Source of random numbers, if no `share` is given.
    symbol : sympy.Symbol
        The symbol.
    domain : dict or None
        Intervals of symbols.
    share : float, optional
        Instead of a random value, the one at this share, between 0 and 1, of all values.
    unit : float
        The size that is moderate, where the interval is infinite.
    """
    low, high = endpoints(symbol, domain)
    share = random.uniform() if share is None else share
    if math.isfinite(low) and math.isfinite(high):
        return low + (0.02 + 0.96 * share) * (high - low)
    smallest, largest = math.log(0.15), math.log(8)
    if math.isfinite(low) or math.isfinite(high):
        size = unit * math.exp(smallest + share * (largest - smallest))
        return low + size if math.isfinite(low) else high - size
    sign, share = (1, 2 * share - 1) if share > 0.5 else (-1, 1 - 2 * share)
    return sign * unit * math.exp(smallest + share * (largest - smallest))


def rational(value):
    """Return a fraction near a value."""
    return Fraction(float(value)).limit_denominator(60 if abs(value) > 0.2 else 10**4)


def simple_rational(value, symbol, domain):
    """Return a simple fraction near a value, for messages that can be checked by hand."""
    simple = Fraction(value).limit_denominator(9)
    # Whole numbers are where formulas in a good form happen not to be defined, such as 1/(u - 3).
    return (
        simple
        if simple.denominator > 1 and lies_inside(float(simple), symbol, domain)
        else rational(value)
    )
