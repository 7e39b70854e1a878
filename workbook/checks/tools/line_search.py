"""Line searches, for many cases side by side: golden section and bisection."""

import numpy as np


def golden_section(function, centre, width, steps, sufficient=np.inf):
    """Return the arguments of the largest values within centre +- width, each row its own.

    Parameters
    ----------
    function : callable
        `function(points, rows)` returns the values of these rows at these points, one of each.
    centre, width : numpy.ndarray
        The interval of each row.
    steps : int
        The number of steps of the golden section.
    sufficient : float
        The search ends when all values are above this.

    Notes
    -----
    For few rows many points are evaluated in one call, until they are as close together as so many
    steps bring them: for few rows the call itself takes the time.
    """
    ratio, low, high = (np.sqrt(5) - 1) / 2, centre - width, centre + width
    count = 15 if len(centre) <= 16 else 7 if len(centre) <= 40 else 2
    if count > 2:
        row_index, rows = np.arange(len(centre)), np.repeat(np.arange(len(centre)), count)
        for _ in range(int(np.ceil(steps * np.log(ratio) / np.log(2 / (count + 1))))):
            points = low[:, None] + (high - low)[:, None] * np.arange(count + 2) / (count + 1)
            values = function(points[:, 1:-1].ravel(), rows).reshape(-1, count)
            top = values.argmax(axis=1)
            low, best, high = (points[row_index, top + k] for k in range(3))
            if sufficient < np.inf and (values[row_index, top] > sufficient).all():
                break
        return best
    rows = slice(None)
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    at_a, at_b = function(a, rows), function(b, rows)
    for _ in range(steps):
        if sufficient < np.inf and (np.maximum(at_a, at_b) > sufficient).all():
            break
        up = at_a < at_b
        low, high = np.where(up, a, low), np.where(up, high, b)
        point = np.where(up, low + ratio * (high - low), high - ratio * (high - low))
        new_values = function(point, rows)
        a, b = np.where(up, b, point), np.where(up, point, a)
        at_a, at_b = np.where(up, at_b, new_values), np.where(up, new_values, at_a)
    return np.where(at_a > at_b, a, b)


def bisect(like_first, first, last, halvings):
    """Return (first, last) after halving the intervals between them, each row its own.

    Parameters
    ----------
    like_first : callable
        `like_first(points, rows)` returns at which points the rows are as at their first ends.
    first, last : numpy.ndarray
        The ends.
    halvings : int
        The number of halvings.

    Notes
    -----
    The middles that the next few halvings may come to are evaluated in one call: for few rows the call
    itself takes the time.
    """
    rows = np.arange(len(first))
    while halvings > 0:
        depth = min(
            halvings,
            6
            if len(rows) < 4
            else 4
            if len(rows) < 10
            else 3
            if len(rows) < 30
            else 2
            if len(rows) < 120
            else 1,
        )
        parts = 2**depth
        ends = np.empty((len(rows), parts + 1, *np.shape(first)[1:]))
        ends[:, 0], ends[:, -1] = first, last
        for width in parts // 2 ** np.arange(depth):
            ends[:, width // 2 :: width] = (ends[:, :-1:width] + ends[:, width::width]) / 2
        middles = ends[:, 1:-1].reshape(-1, *np.shape(first)[1:])
        is_like_first = np.asarray(like_first(middles, np.repeat(rows, parts - 1))).reshape(
            len(rows), parts - 1
        )
        at = np.zeros(len(rows), dtype=int)
        for width in parts // 2 ** np.arange(1, depth + 1):
            at += width * is_like_first[rows, at + width - 1]
        first, last = ends[rows, at], ends[rows, at + 1]
        halvings -= depth
    return first, last
