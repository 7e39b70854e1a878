"""Constants of the rounding errors of orthogonal reflections.

For n rows, m >= 2 unknowns, a relative precision eps of the floats and a condition number mu

    K = sqrt(m) (2m - 3) (4n + 27),        mu* = 1/((K + 11) eps),
    |dx| <= (K + 8n + 58) eps mu/(1 - (K + 4n + 30) eps mu) |x|        for consistent equations.

The last line has the form (a + b) mu/(1 - a mu), the bound for a computation that is exact for a
matrix and a right-hand side with relative errors a = (K + 4n + 30) eps and b = (4n + 28) eps. With
these two numbers the bound extends to equations with a residual r, which the paper leaves out: see
`trajlib.solvability.householder`. Source: Malyshev (1991), as quoted by Kryzhko and Glushakova.
"""

import math
import operator

import numpy as np

EPS = float(np.finfo(float).eps)


def reflection_constant(m: int, n: int) -> float:
    """Return the constant K = sqrt(m) (2m - 3) (4n + 27).

    Parameters
    ----------
    m : int
        Number of unknowns, 2 or more (for m = 1 the factor 2m - 3 would be negative).
    n : int
        Number of scalar rows (rows, not epochs).

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If m < 2 or n < m.
    """
    m, n = _sizes(m, n)
    if m == 1:
        raise ValueError(
            "m = 1: the constant has no meaning for one unknown (2m - 3 < 0), whose condition "
            "number is always 1"
        )
    return math.sqrt(m) * (2 * m - 3) * (4 * n + 27)


def threshold(m: int, n: int, eps: float = EPS) -> float:
    """Return mu*, the condition number below which a computed one proves full rank.

    Parameters
    ----------
    m, n : int
        Numbers of unknowns and of scalar rows.
    eps : float
        Relative precision of the floats.

    Returns
    -------
    float
        Infinite for m = 1.

    Examples
    --------
    >>> f"{threshold(6, 100):.3g}"
    '4.78e+11'
    """
    eps = _precision(eps)
    if _sizes(m, n)[0] == 1:
        return math.inf
    return 1 / ((reflection_constant(m, n) + 11) * eps)


def rounding_bound(m: int, n: int, mu: float, eps: float = EPS) -> float:
    """Return the bound on the relative change of a solution of consistent equations by rounding.

    Parameters
    ----------
    m, n : int
        Numbers of unknowns and of scalar rows.
    mu : float
        Condition number, 1 or more.
    eps : float
        Relative precision of the floats.

    Returns
    -------
    float
        Relative to the norm of the solution. Infinite where the bound does not hold, for mu >=
        1/((K + 4n + 30) eps); this limit is a little below mu*.

    Raises
    ------
    ValueError
        If mu < 1 or n < m.

    Examples
    --------
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
    """Return relative backward errors (a, b) of matrix and right-hand side by reflections.

    For m = 1 there is a single reflection, and K = 0 is used in the same formulas.
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
