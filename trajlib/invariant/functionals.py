"""Linear functionals of a function of time: a value, a derivative, an integral."""

import numpy as np

from trajlib.invariant.arguments import derivative_of, read_finite


def value(t):
    """The functional y -> y(t); `t` may be an array, for as many functionals.

    >>> import sympy as sp
    >>> round(float(value(2)(sp.Symbol("t")**3)), 12)
    8.0
    """
    return derivative(t, 0)


def derivative(t, r=1):
    """The functional y -> the derivative of order r of y at `t`, a number or an array.

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


def integral(a, b):
    """The functional y -> the integral of y from `a` to `b`, numbers or arrays.

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
        else:
            return _quadrature(derivative_of(y, 0), a, b)
        return primitive(b) - primitive(a)

    return omega


def _quadrature(function, a, b):
    from scipy.integrate import quad

    return np.vectorize(
        lambda low, high: quad(function, low, high, epsabs=1e-12, epsrel=1e-12, limit=200)[0]
    )(a, b)[()]


def on_basis(functional, basis):
    """o = omega{psi_k}, shape (K,) or (K, m)."""
    o = np.array([functional(psi) for psi in basis], dtype=float)
    if o.ndim > 2 or not np.isfinite(o).all():
        raise ValueError(
            "functional: expected a finite number for each function of the basis, or a list of "
            f"them, got {o.tolist() if o.size < 9 else f'shape {o.shape}'}"
        )
    return o
