"""The flow of a vector field: how fast a function of the state changes along the motions.

>>> import sympy as sp
>>> x, v, omega = sp.symbols("x v omega")
>>> oscillator = {x: v, v: -omega**2*x}
>>> lie_derivative(omega**2*x**2 + v**2, oscillator)
0
>>> lie_derivative(x, oscillator, order=2)
-omega**2*x
"""

import sympy as sp

__all__ = ["lie_derivative"]


def lie_derivative(function, flow, order=1):
    """The derivative of a function along the motions, sum of df/dx x', or one of higher `order`, as
    it comes.

    `function`: an expression; `flow`: {symbol: its rate}, of states and costates alike; symbols
    that it does not hold are constants, as a control is while it does not switch. Raises TypeError
    if `flow` is no dict and ValueError for an order that is no whole number from 0 on. Source:
    Definition 1.4 of the problem book.

    >>> import sympy as sp
    >>> x1, x2, psi1, psi2, u = sp.symbols("x1 x2 psi1 psi2 u")
    >>> lie_derivative(psi2, {x1: x2, x2: u, psi1: 0, psi2: -psi1})
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
