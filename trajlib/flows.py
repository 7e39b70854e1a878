"""Lie derivatives along a vector field."""

from collections.abc import Mapping

import sympy as sp

__all__ = ["lie_derivative"]


def lie_derivative(function: sp.Expr, flow: Mapping, order: int = 1) -> sp.Expr:
    """Return the Lie derivative of a function along a vector field, sum of df/dx x'.

    Parameters
    ----------
    function : sympy.Expr
        Function of the state.
    flow : mapping
        Rate of each symbol, of states and costates; other symbols are constants, as a control
        is between its switching times.
    order : int
        Order of the derivative, from 0 on.

    Returns
    -------
    sympy.Expr
        Not simplified.

    Raises
    ------
    TypeError
        If `flow` is no mapping.
    ValueError
        If the order is no integer from 0 on.

    Notes
    -----
    Source: Definition 1.4 of the problem book.

    Examples
    --------
    >>> import sympy as sp
    >>> x, v, omega = sp.symbols("x v omega")
    >>> oscillator = {x: v, v: -omega**2*x}
    >>> lie_derivative(omega**2*x**2 + v**2, oscillator)
    0
    >>> lie_derivative(x, oscillator, order=2)
    -omega**2*x
    >>> psi1, psi2, u = sp.symbols("psi1 psi2 u")
    >>> lie_derivative(psi2, {x: v, v: u, psi1: 0, psi2: -psi1})
    -psi1
    """
    if not hasattr(flow, "items"):
        raise TypeError(
            f"flow: expected a dict from symbols to their rates, got {type(flow).__name__}"
        )
    if order != int(order) or order < 0:
        raise ValueError(f"order: expected a whole number from 0 on, got {order}")
    derivative = sp.sympify(function)
    for _ in range(int(order)):
        derivative = sum(
            (sp.diff(derivative, symbol) * rate for symbol, rate in flow.items()), sp.Integer(0)
        )
    return derivative
