"""Parts of the computation of an `Explorer`: parameters, steps, and the series that they compute."""

from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

__all__ = ["Parameter", "Series", "Step", "numbers", "with_values"]


@dataclass(frozen=True)
class Parameter:
    """A scalar that the reader sets: by a slider, or by a point that is dragged.

    Raises
    ------
    ValueError
        If the limits are empty, the value is not between them, or the step or the seconds are not
        positive.
    """

    symbol: sp.Symbol
    value: float
    limits: tuple
    label: str
    step: float
    play: float | None

    def __post_init__(self):
        low, high = self.limits
        if not low < high:
            raise ValueError(f"limits: expected (low, high) with low < high, got {self.limits}")
        if not low <= self.value <= high:
            raise ValueError(
                f"{self.symbol}: expected a number from {low:g} to {high:g}, got {self.value:g}"
            )
        if not self.step > 0:
            raise ValueError(f"step: expected a positive number, got {self.step:g}")
        if self.play is not None and not self.play > 0:
            raise ValueError(f"play: expected a positive number of seconds, got {self.play}")


@dataclass(frozen=True)
class Step:
    """A computation: its kind, its formulas by role, the constants that it needs."""

    kind: str
    formulas: dict
    constants: dict
    inputs: frozenset  # the names of the parameters on which its result depends


class Series:
    """Rows of named columns that a step computes; made by the methods of `Explorer`.

    Attributes
    ----------
    columns : tuple of sympy.Symbol
        The symbols that expressions of a row may contain.
    """

    def __init__(self, explorer, index, columns, inputs):
        self._explorer, self.index, self.columns, self.inputs = explorer, index, columns, inputs

    def last(self, symbol, value):
        """Define a scalar: the value of an expression at the last row.

        Parameters
        ----------
        symbol : sympy.Symbol
            The scalar.
        value : sympy.Expr
            An expression in the columns and the scalars so far.

        Raises
        ------
        ValueError
            If the symbol has a value already or the expression contains an unknown symbol.
        """
        self._explorer._reduce(self, "last", symbol, value)

    def largest(self, symbol, value):
        """Define a scalar: the largest value of an expression over all rows; see `last`."""
        self._explorer._reduce(self, "largest", symbol, value)


def numbers(argument, values):
    """Return a list of finite numbers as an array, or raise ValueError that names the argument."""
    array = np.asarray(values, dtype=float)
    if array.ndim != 1 or not np.isfinite(array).all():
        raise ValueError(f"{argument}: expected a list of finite numbers")
    return array


def with_values(parameters, values):
    """Return parameters with other first values, given by name; see `Explorer.set`."""
    by_name = {str(parameter.symbol): parameter for parameter in parameters}
    for name, value in values.items():
        if name not in by_name:
            raise ValueError(f"there is no parameter {name}; there is {', '.join(by_name)}")
        try:
            number = float(value)
        except (TypeError, ValueError):
            raise ValueError(f"{name}: expected a number, got {value}") from None
        by_name[name] = replace(by_name[name], value=number)
    return list(by_name.values())
