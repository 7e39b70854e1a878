"""Constants of the rounding errors of orthogonal reflections (Malyshev 1991, as quoted by Kryzhko
and Glushakova).

For n rows, m >= 2 unknowns, a relative precision eps of the machine numbers and a condition number
mu

    K = sqrt(m) (2m - 3) (4n + 27),        mu* = 1/((K + 11) eps),
    |dx| <= (K + 8n + 58) eps mu/(1 - (K + 4n + 30) eps mu) |x|        for consistent equations.

The last line has the form (a + b) mu/(1 - a mu), which is what a computation gives that is exact
for a matrix and a right-hand side with relative errors a = (K + 4n + 30) eps and b = (4n + 28) eps.
With these two numbers the bound extends to equations with a residual r, which the paper leaves out:
see `trajlib.solvability.reflections`.
"""

import math
import operator

import numpy as np

EPS = float(np.finfo(float).eps)


def reflection_constant(m, n):
    """K = sqrt(m) (2m - 3) (4n + 27) for m unknowns and n scalar rows (rows, not epochs).

    m = 1 has no K: the factor 2m - 3 would be negative.
    """
    m, n = _sizes(m, n)
    if m == 1:
        raise ValueError(
            "m = 1: the constant has no meaning for one unknown (2m - 3 < 0), whose condition "
            "number is always 1"
        )
    return math.sqrt(m) * (2 * m - 3) * (4 * n + 27)


def threshold(m, n, eps=EPS):
    """mu*: a condition number computed to be below it proves that the matrix has full rank.
    Infinite for m = 1.

    >>> f"{threshold(6, 100):.3g}"
    '4.78e+11'
    """
    eps = _precision(eps)
    if _sizes(m, n)[0] == 1:
        return math.inf
    return 1 / ((reflection_constant(m, n) + 11) * eps)


def rounding_bound(m, n, mu, eps=EPS):
    """The number by which rounding changes the solution of consistent equations at most, relative
    to its norm.

    Infinite where the bound does not hold, for mu >= 1/((K + 4n + 30) eps); this limit is a little
    below mu*.

    >>> f"{rounding_bound(6, 100, 1e6):.2g}"
    '2.3e-06'
    """
    of_matrix, of_right_side = backward_errors(m, n, eps)
    if not mu >= 1:
        raise ValueError(f"mu: a condition number is 1 or more, got {mu}")
    if of_matrix * mu >= 1:
        return math.inf
    return (of_matrix + of_right_side) * mu / (1 - of_matrix * mu)


def backward_errors(m, n, eps=EPS):
    """(a, b): relative errors of matrix and right-hand side to which the rounding errors of
    reflections amount.

    For m = 1 there is nothing but one reflection, and K = 0 is put into the same formulas.
    """
    eps = _precision(eps)
    m, n = _sizes(m, n)
    K = reflection_constant(m, n) if m > 1 else 0.0
    return (K + 4 * n + 30) * eps, (4 * n + 28) * eps


def _sizes(m, n):
    try:
        m, n = operator.index(m), operator.index(n)
    except TypeError:
        raise TypeError(
            f"m, n: expected the numbers of unknowns and of rows, got {m!r}, {n!r}"
        ) from None
    if m < 1:
        raise ValueError(f"m: expected one unknown or more, got {m}")
    if n < m:
        raise ValueError(
            f"n: {n} rows cannot determine {m} unknowns; n counts scalar measurements, so add "
            f"measurements"
        )
    return m, n


def _precision(eps):
    if not 0 < eps < 1:
        raise ValueError(
            "eps: expected the relative precision of the machine numbers, such as 2.2e-16, got "
            f"{eps}"
        )
    return float(eps)
