"""Matrix products with about 30 digits, as pairs of floats (high, low) whose sum is the value.

Each row of the left factor and each column of the right one is cut into slices of so few bits that
the products of slices are exact in floats, also as sums (K. Ozaki, T. Ogita, S. Oishi, S. M. Rump,
Error-free transformations of matrix multiplication, Numerical Algorithms 59, 2012). Products of one
size, of slice i with slice k - i, come from one product of matrices beside one another. What
rounding loses in a sum of pairs is itself a float (D. E. Knuth). This needs no other kind of number,
is the same on all machines, and takes some five ordinary products.
"""

from math import ceil, log2

import numpy as np

#: Bits of the factors that are used, of a float and its low part.
BITS = 106


def total(*pairs):
    """Return the sum of pairs."""
    high, low = pairs[0]
    for next_high, next_low in pairs[1:]:
        value = high + next_high
        part = value - high
        low = low + ((high - (value - part)) + (next_high - part)) + next_low
        high = value
    value = high + low
    return value, low - (value - high)


def product(left, right):
    """Return the product of two matrices, each an array or a pair, as a pair."""
    left, left_low = left if isinstance(left, tuple) else (left, None)
    right, right_low = right if isinstance(right, tuple) else (right, None)
    inner = len(right)
    bits = (53 - ceil(log2(6 * inner))) // 2
    count = -(-BITS // bits)
    rows = _slices(left, left_low, 1, bits, count)
    columns = _slices(right, right_low, 0, bits, count)
    beside, below = np.concatenate(rows, axis=1), np.concatenate(columns[::-1])
    high, low = None, 0.0
    for k in range(min(count, len(rows) + len(columns) - 1)):
        first, last = max(0, k - len(columns) + 1), min(k, len(rows) - 1)
        start = len(columns) - 1 - (k - first)
        part = (
            beside[:, first * inner : (last + 1) * inner]
            @ below[start * inner : (start + last - first + 1) * inner]
        )
        if high is None:
            high = part
            continue
        value = high + part
        rounded = value - high
        low = low + ((high - (value - rounded)) + (part - rounded))
        high = value
    value = high + low
    return value, low - (value - high)


def _slices(matrix, low, axis, bits, count):
    """Return matrices of so many bits each, beside the greatest entry along an axis, with this sum."""
    greatest = np.abs(matrix).max(axis=axis, keepdims=True)
    cut = np.ldexp(0.75, np.frexp(greatest)[1] + (53 - bits))
    slices = []
    for k in range(count):
        if k == 2 and low is not None:  # what is left is now of the size of the low part
            matrix = matrix + low
        if k > 1 and not matrix.any():
            break
        part = (matrix + cut) - cut
        slices.append(part)
        matrix, cut = matrix - part, cut * 2.0**-bits
    return slices
