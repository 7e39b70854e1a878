"""Sample values of parameters, and a search for the largest value, for many cases side by side."""

import numpy as np
import sympy as sp


def sample_cases(parameters):
    """Sample values of all parameters together: one row for each case."""
    if not parameters:
        return [()]
    columns = [[float(value) for value in domain] if isinstance(domain, sp.FiniteSet)
               else spread_over(float(domain.inf), float(domain.sup))
               for domain in parameters.values()]
    return [tuple(float(column[(k + 2 * c) % len(column)]) for c, column in enumerate(columns)) for k in range(len(columns[0]))]


def spread_over(low, high, count=6):
    """Values inside an interval, which may be infinite."""
    shares = (np.arange(count) + 0.55) / count
    if np.isfinite(low) and np.isfinite(high):
        return low + (high - low) * shares
    if np.isfinite(low):
        return low + 0.8 * shares / (1.1 - shares)
    if np.isfinite(high):
        return high - 0.8 * shares / (1.1 - shares)
    return 4 * (2 * shares - 1)


def largest(function, centre, width, steps, enough=np.inf):
    """The place of the largest value within centre +- width, each row its own, by golden section; values above `enough` will do."""
    ratio = (np.sqrt(5) - 1) / 2
    low, high = centre - width, centre + width
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    at_a, at_b = function(a), function(b)
    for _ in range(steps):
        if (np.maximum(at_a, at_b) > enough).all():
            break
        up = at_a < at_b
        low, high = np.where(up, a, low), np.where(up, high, b)
        a, b = np.where(up, b, high - ratio * (high - low)), np.where(up, low + ratio * (high - low), a)
        fresh = function(np.where(up, b, a))
        at_a, at_b = np.where(up, at_b, fresh), np.where(up, fresh, at_a)
    return np.where(at_a > at_b, a, b)
