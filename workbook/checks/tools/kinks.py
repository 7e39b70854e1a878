"""Kinks of expressions: corners, jumps and steep transitions between sample points.

Next to them an answer may be wrong that is right at all other points.
"""

import numpy as np

from workbook.checks.contract.verdict import Invalid
from workbook.checks.tools.numeric_functions import is_slow, real_function

#: In so many parts the way from one point to the next is divided, so often; the strongest bends of
#: so many ways count, by what they are after so many rounds, unless they are a smaller share of the
#: values than this.
PARTS, ROUNDS, MOST, JUDGED, NONE = 32, 8, 2, 3, 1e-11
#: Differences of this order are small where an expression is smooth.
ORDER = 4
#: How far from a bend, as a part of the way, its two sides are looked at, and up to which share of
#: it a value is the same on both: then one of them will do.
ASIDE, SAME = 1e-7, 1e-6


def points_at_kinks(claim, points):
    """Return points at the strongest kinks of an expression on segments between points.

    Parameters
    ----------
    claim : sympy.Expr
        The expression.
    points : list of dict
        {symbol: real number} each, of the same symbols.

    Returns
    -------
    list of dict
        Points on both sides of a kink if the values there differ, else on one. Empty if there is no
        kink, or if the expression is too slow to be evaluated so often, as an integral is.
    """
    if is_slow(claim):
        return []
    symbols = list(points[0])
    function = real_function(symbols, [claim])
    ends = np.array([[float(point[s]) for s in symbols] for point in points])
    begin, segment, rows = ends[:-1], np.diff(ends, axis=0), np.arange(len(ends) - 1)

    def values(parts):
        at = begin[:, None] + segment[:, None] * parts[..., None]
        return at, np.broadcast_to(function(*np.moveaxis(at, -1, 0))[0], parts.shape)

    first, width, strength = np.zeros(len(rows)), np.ones(len(rows)), []
    for _ in range(ROUNDS):
        parts = first[:, None] + width[:, None] * np.arange(PARTS + 1) / PARTS
        try:
            numbers = values(parts)[1]
        except Invalid:
            return []
        differences = np.nan_to_num(np.abs(np.diff(numbers, ORDER, axis=1)), nan=np.inf)
        top = differences.argmax(axis=1)
        strength.append(differences[rows, top] / np.nanmax(np.abs(numbers), axis=1, initial=1e-300))
        first, width = parts[rows, top], ORDER * width / PARTS
    # Looked at so much closer, what is smooth bends less by the power ORDER, a corner by the first
    # or the second one.
    has_kink = (strength[1] > strength[0] * (ORDER / PARTS) ** 2.5) & (strength[1] > NONE)
    at, numbers = values(np.clip((first + width / 2)[:, None] + [-ASIDE, ASIDE], 0, 1))
    return [
        dict(zip(symbols, at[k, side].tolist()))
        for k in sorted(np.flatnonzero(has_kink), key=lambda k: -strength[JUDGED][k])[:MOST]
        for side in range(
            1 if abs(numbers[k, 1] - numbers[k, 0]) <= SAME * abs(numbers[k, 0]) else 2
        )
    ]
