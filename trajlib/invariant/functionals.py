"""Linear functionals of a function of time: a value, a derivative, an integral."""

from collections.abc import Callable

import numpy as np

from trajlib._typing import ArrayLike
from trajlib.invariant.sample_arguments import derivative_of, read_finite


def value(t: ArrayLike) -> Callable:
    """Return the functional y -> y(t).

    Parameters
    ----------
    t : array_like
        Time, or an array for as many functionals.

    Returns
    -------
    callable

    Examples
    --------
    >>> import sympy as sp
    >>> round(float(value(2)(sp.Symbol("t")**3)), 12)
    8.0
    """
    return derivative(t, 0)


def derivative(t: ArrayLike, r: int = 1) -> Callable:
    """Return the functional y -> derivative of y at a time.

    Parameters
    ----------
    t : array_like
        Time, or an array for as many functionals.
    r : int
        Order of the derivative, from 0 on.

    Returns
    -------
    callable

    Raises
    ------
    ValueError
        If the order is no integer from 0 on or the time is not finite.

    Examples
    --------
    >>> from numpy.polynomial import Polynomial
    >>> float(derivative(2, 2)(Polynomial([0, 0, 0, 1])))
    12.0
    """
    t = read_finite(t, "t")
    if r != int(r) or r < 0:
        raise ValueError(
            f"r: expected the order of a derivative, a whole number from zero on, got {r}"
        )
    return lambda y: derivative_of(y, int(r))(t)


def integral(a: ArrayLike, b: ArrayLike) -> Callable:
    """Return the functional y -> integral of y from a to b.

    Parameters
    ----------
    a, b : array_like
        Limits, numbers or arrays for as many functionals.

    Returns
    -------
    callable

    Raises
    ------
    ValueError
        If a limit is not finite.

    Examples
    --------
    >>> from numpy.polynomial import Polynomial
    >>> float(integral(0, 3)(Polynomial([0, 0, 1])))
    9.0
    """
    a, b = read_finite(a, "a"), read_finite(b, "b")

    def omega(y):
        if hasattr(y, "antiderivative"):
            primitive = y.antiderivative()
        elif hasattr(y, "integ"):
            primitive = y.integ()
        elif hasattr(y, "free_symbols") and len(y.free_symbols) == 1 and y.is_polynomial():
            primitive = _exact_primitive(y)
        else:
            return _quadrature(derivative_of(y, 0), a, b)
        return np.asarray(primitive(b) - primitive(a), dtype=float)[()]

    return omega


def _exact_primitive(polynomial):
    """Return the primitive in rational arithmetic: far from zero its values would cancel."""
    import sympy as sp

    (t,) = polynomial.free_symbols
    primitive = sp.Poly(polynomial, t).integrate()
    return np.vectorize(lambda time: primitive.eval(sp.Rational(float(time))), otypes=[object])


def _quadrature(function, a, b):
    from scipy.integrate import quad

    return np.vectorize(
        lambda low, high: quad(function, low, high, epsabs=1e-12, epsrel=1e-12, limit=200)[0]
    )(a, b)[()]


def on_basis(functional, basis):
    """Return o = omega{psi_k}, shape (K,) or (K, m)."""
    o = np.array([functional(psi) for psi in basis], dtype=float)
    if o.ndim > 2 or not np.isfinite(o).all():
        raise ValueError(
            "functional: expected a finite number for each function of the basis, or a list of "
            f"them, got {o.tolist() if o.size < 9 else f'shape {o.shape}'}"
        )
    return o
