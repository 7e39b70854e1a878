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

    Attributes
    ----------
    javascript : str
        The expression in `v` and `c`, on one line.

    Raises
    ------
    ValueError
        If it contains another symbol or a function that JavaScript does not have.
    """

    def __init__(self, argument, value, scalars, columns=()):
        self.expression = expression(argument, value)
        self.columns = tuple(map(str, columns))
        # symbols are known by their names, whatever is assumed of them
        self._entries = {str(symbol): f"v[{k}]" for k, symbol in enumerate(scalars)}
        self._entries |= {name: f"c[{k}]" for k, name in enumerate(self.columns)}
        foreign = {str(symbol) for symbol in self.expression.free_symbols} - self._entries.keys()
        if foreign:
            names = ", ".join(sorted(foreign))
            raise ValueError(f"{argument}: {names} is neither a parameter nor a quantity so far")
        try:
            self.javascript = _Printer(self._entries).doprint(self.expression)
        except PrintMethodNotImplementedError as error:
            raise ValueError(
                f"{argument}: JavaScript has no function for {self.expression}"
            ) from error

    @property
    def scalars(self):
        """The names of the scalars that the expression contains."""
        return {str(symbol) for symbol in self.expression.free_symbols}.difference(self.columns)

    @cached_property
    def _function(self):
        arguments = {name: sp.Dummy() for name in self._entries}
        swapped = self.expression.xreplace(
            {symbol: arguments[str(symbol)] for symbol in self.expression.free_symbols}
        )
        return sp.lambdify(list(arguments.values()), swapped, "numpy")

    def __call__(self, v, c=()):
        """Return the value, an array of the shape of the columns."""
        by_entry = {f"v[{k}]": value for k, value in enumerate(v)}
        by_entry |= {f"c[{k}]": np.asarray(value, dtype=float) for k, value in enumerate(c)}
        values = [by_entry.get(entry, np.nan) for entry in self._entries.values()]
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
        return self._entries[str(symbol)]

    def _print_Mod(self, value):
        # SymPy leaves out the outer brackets, also where the remainder is a factor
        return f"({super()._print_Mod(value)})"

    def _print_BooleanTrue(self, _):
        return "true"

    def _print_BooleanFalse(self, _):
        return "false"

    def _print_NaN(self, _):
        return "NaN"
