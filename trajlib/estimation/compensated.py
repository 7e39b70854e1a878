"""Matrix products with about 30 digits, as pairs of floats (high, low) whose sum is the value.

Each row of the left factor and each column of the right one is cut into slices of so few bits that
the products of slices are exact in floats, also as sums (K. Ozaki, T. Ogita, S. Oishi, S. M. Rump,
Error-free transformations of matrix multiplication, Numerical Algorithms 59, 2012). What rounding
loses in a sum of pairs is itself a float (D. E. Knuth). This needs no other kind of number, is the
same on all machines, and takes some fifteen ordinary products.
"""

import numpy as np

#: Bits of the factors that are used, of a float and its low part.
BITS = 106


def pair(matrix):
    """Return a matrix as a pair."""
    return matrix, np.zeros_like(matrix)


def transpose(matrix):
    high, low = matrix
    return high.T, low.T


def negative(matrix):
    high, low = matrix
    return -high, -low


def total(*pairs):
    """Return the sum of pairs."""
    high, low = pairs[0]
    for next_high, next_low in pairs[1:]:
        high, error = _two_sum(high, next_high)
        low = low + error + next_low
    return _two_sum(high, low)


def product(first, *factors):
    """Return the product of pairs."""
    for factor in factors:
        first = _product(first, factor)
    return first


def _product(left, right):
    inner = left[0].shape[1]
    bits = (53 - int(np.ceil(np.log2(inner)))) // 2
    count = -(-BITS // bits)
    rows = _slices(left, bits, count)
    columns = [part.T for part in _slices(transpose(right), bits, count)]
    high = low = np.zeros((len(left[0]), right[0].shape[1]))
    for i, row in enumerate(rows):
        for column in columns[: count - i]:
            high, error = _two_sum(high, row @ column)
            low = low + error
    return _two_sum(high, low)


def _slices(matrix, bits, count):
    """Return matrices of so many bits each, beside the greatest entry of a row, with this sum."""
    remainder, low = matrix
    greatest = np.abs(remainder).max(axis=1, keepdims=True)
    exponents = np.where(greatest > 0, np.frexp(greatest)[1], 0)
    slices = []
    for k in range(count):
        if k == 2:  # what is left of the high part is now of the size of the low part
            remainder = remainder + low
        if not remainder.any():
            break
        cut = np.ldexp(0.75, exponents + 53 - bits * (k + 1))
        slices.append((remainder + cut) - cut)
        remainder = remainder - slices[-1]
    if len(slices) < 2 and low.any():
        slices.append(low)
    return slices


def _two_sum(a, b):
    """Return the rounded sum and its rounding error."""
    value = a + b
    part = value - a
    return value, (a - (value - part)) + (b - part)
