"""An expression as JavaScript and as a NumPy function.

Both take the same two lists: `v`, the scalars of the figure in the order of their declaration, and
`c`, the columns of a series at one of its rows, or the coordinates of a point of a panel.

>>> k, s = sp.symbols("k s")
>>> formula = Formula("curve", k * sp.exp(-s), (k,), (s,))
>>> formula.javascript
'v[0]*Math.exp(-c[0])'
>>> float(formula([2.0], [0.0]))
2.0
"""

from functools import cached_property

import numpy as np
import sympy as sp
from sympy.printing.codeprinter import PrintMethodNotImplementedError
from sympy.printing.jscode import JavascriptCodePrinter

__all__ = ["Formula", "expression", "pretty"]


class Formula:
    """An expression in scalars and columns.

    Parameters
    ----------
    argument : str
        The argument that it was given as, for messages.
    value : sympy.Expr, sympy.Boolean or float
        The expression or condition.
    scalars, columns : sequence of sympy.Symbol
        The symbols that it may contain. A symbol that is both is a column.

    Raises
    ------
    ValueError
        If it contains another symbol or a function that JavaScript does not have.
    """

    def __init__(self, argument, value, scalars, columns=()):
        self.expression = expression(argument, value)
        self.columns = tuple(columns)
        self.scalars = tuple(symbol for symbol in scalars if symbol not in self.columns)
        self._names = {symbol: f"v[{k}]" for k, symbol in enumerate(scalars)}
        self._names |= {symbol: f"c[{k}]" for k, symbol in enumerate(self.columns)}
        foreign = self.expression.free_symbols - self._names.keys()
        if foreign:
            names = ", ".join(sorted(map(str, foreign)))
            raise ValueError(f"{argument}: {names} is neither a parameter nor a quantity so far")
        try:
            self.javascript = _Printer(self._names).doprint(self.expression)
        except PrintMethodNotImplementedError as error:
            raise ValueError(
                f"{argument}: JavaScript has no function for {self.expression}"
            ) from error

    @property
    def symbols(self):
        """The scalars that the expression contains."""
        return self.expression.free_symbols.intersection(self.scalars)

    @cached_property
    def _function(self):
        arguments = [sp.Dummy() for _ in self._names]
        swapped = self.expression.xreplace(dict(zip(self._names, arguments)))
        return sp.lambdify(arguments, swapped, "numpy")

    def __call__(self, v, c=()):
        """Return the value, an array of the shape of the columns."""
        by_name = {f"v[{k}]": value for k, value in enumerate(v)}
        by_name |= {f"c[{k}]": np.asarray(value, dtype=float) for k, value in enumerate(c)}
        values = [by_name.get(name, np.nan) for name in self._names.values()]
        shape = np.broadcast_shapes(*(np.shape(value) for value in c))
        with np.errstate(all="ignore"):
            return np.broadcast_to(self._function(*values), shape)


def expression(argument, value):
    """Return `value` as an expression or condition of SymPy.

    Raises
    ------
    ValueError
        If it is none.
    """
    try:
        result = sp.sympify(value, strict=True)
    except sp.SympifyError as error:
        raise ValueError(f"{argument}: expected an expression of SymPy, got {value!r}") from error
    if not isinstance(result, (sp.Expr, sp.logic.boolalg.Boolean)):
        raise ValueError(f"{argument}: expected an expression of SymPy, got {value!r}")
    return result


def pretty(symbol):
    """Return the name of a symbol as it is written: k₁, δ."""
    return sp.pretty(symbol, use_unicode=True)


class _Printer(JavascriptCodePrinter):
    """Writes symbols as entries of the lists, and every expression on one line."""

    def __init__(self, names):
        super().__init__({"precision": 17})
        self._entries = names

    def doprint(self, value):
        return " ".join(super().doprint(value).split())

    def _print_Symbol(self, symbol):
        return self._entries[symbol]

    def _print_BooleanTrue(self, _):
        return "true"

    def _print_BooleanFalse(self, _):
        return "false"
