"""Steps of differential equations for many columns at once."""

import numpy as np

#: Numbers of substeps of the extrapolated midpoint rule.
SUBSTEPS = (2, 4, 6, 8)
#: Norm of matrix times time up to which the terms of the exponential series lose few digits by
#: cancellation.
SERIES_NORM = 3.0


def steps_needed(times, longest):
    """Return the number of steps of at most `longest` for all these times."""
    return max(int(np.ceil(np.abs(times).max(initial=0, where=np.isfinite(times)) / longest)), 1)


def series_step(matrix, growth, rate, z, h):
    """Return a step of z' = A z + b from its rate at z by the exponential series, to rounding.

    The series is z + h (1 + hA/2! + (hA)^2/3! + ...) z'; `growth`: a norm of A.
    """
    size = growth * np.max(np.abs(h), initial=0, where=np.isfinite(h))
    terms, bound = 1, 1.0
    while 1e-17 < bound < np.inf:
        terms += 1
        bound *= size / terms
    total = rate
    for k in range(terms, 1, -1):
        total = rate + h / k * (matrix @ total)
    return z + h * total


def extrapolated_step(rate, z, h):
    """Return a step of the extrapolated midpoint rule (Gragg, Bulirsch, Stoer) of order 8."""
    table, first = [], rate(z)
    for n in SUBSTEPS:
        d = h / n
        before, now = z, z + d * first
        for _ in range(n - 1):
            before, now = now, before + 2 * d * rate(now)
        row = [(before + now + d * rate(now)) / 2]
        for k, earlier in enumerate(table[-1] if table else []):
            row.append(row[k] + (row[k] - earlier) / ((n / SUBSTEPS[len(table) - k - 1]) ** 2 - 1))
        table.append(row)
    return table[-1][-1]
