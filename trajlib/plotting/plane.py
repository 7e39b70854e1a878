"""Axes over a plane of two symbols, and functions on the grid of their window."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib.plotting.appearance import BLUE, SKY, new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def window(symbols: Sequence, x_range: tuple, y_range: tuple, ax: Axes | None = None) -> Axes:
    """Return Axes over a rectangle of two symbols, labelled with their names.

    Parameters
    ----------
    symbols : sequence of sympy.Symbol
        The two symbols.
    x_range, y_range : tuple of float
        Intervals (low, high).
    ax : matplotlib.axes.Axes, optional
        Axes to use; new ones if left out.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If there are not two symbols or an interval is empty.
    """
    symbols = read_two_symbols(symbols, "symbols")
    x_low, x_high, y_low, y_high = read_ranges(x_range, y_range)
    ax = new_axes() if ax is None else ax
    ax.set_xlabel(f"${sp.latex(symbols[0])}$")
    ax.set_ylabel(f"${sp.latex(symbols[1])}$")
    ax.set(xlim=(x_low, x_high), ylim=(y_low, y_high))
    return ax


def hatch(ax, X, Y, depth):
    ax.contourf(X, Y, depth, levels=[0, np.inf], colors=[SKY], alpha=0.35, zorder=1)
    hatching = ax.contourf(
        X, Y, depth, levels=[0, np.inf], colors="none", hatches=["///"], zorder=1
    )
    hatching.set_edgecolor(BLUE)
    hatching.set_linewidth(0)


def window_grid(ax):
    if ax is None:
        raise TypeError("ax: expected the Axes to draw on, whose window is used")
    return np.meshgrid(*(np.linspace(*ends, 401) for ends in (ax.get_xlim(), ax.get_ylim())))


def read_ranges(x_range, y_range):
    ends = []
    for pair, name in ((x_range, "x_range"), (y_range, "y_range")):
        low, high = read_number_pair(pair, name)
        if not low < high:
            raise ValueError(f"{name}: expected (low, high) with low < high, got {tuple(pair)}")
        ends += [low, high]
    return ends


def read_number_pair(pair, name):
    try:
        first, second = (float(v) for v in pair)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected pairs of numbers, got {pair!r}") from None
    return first, second


def read_two_symbols(symbols, name):
    symbols = tuple(symbols) if isinstance(symbols, Iterable) else (symbols,)
    if len(symbols) != 2 or not all(isinstance(s, sp.Symbol) for s in symbols):
        raise ValueError(f"{name}: a picture of the plane needs two symbols, got {symbols}")
    return symbols


def planar_functions(field, state, params):
    state = read_two_symbols(state, "state")
    field = list(field)
    if len(field) != 2:
        raise ValueError(f"field: expected two components, got {len(field)}")
    if params is not None and not isinstance(params, Mapping):
        raise TypeError(f"params: expected a dict from symbols to numbers, got {params!r}")
    field = [sp.sympify(f).subs(params or {}) for f in field]
    undeclared = set().union(*(f.free_symbols for f in field)) - set(state)
    if undeclared:
        raise ValueError(f"params: no value for {', '.join(sorted(map(str, undeclared)))}")
    return [numeric_function(f, state) for f in field], state


def plane_function(V, state, name):
    state = read_two_symbols(state, "state")
    V = sp.sympify(V)
    undeclared = V.free_symbols - set(state)
    if undeclared:
        raise ValueError(
            f"{name}: substitute numbers for {', '.join(sorted(map(str, undeclared)))} first"
        )
    return numeric_function(V, state), state


def numeric_function(expression, symbols):
    """Return a NumPy function of two arguments, NaN where the expression is not defined."""
    raw = sp.lambdify(symbols, expression, "numpy")

    def value(x, y):
        with np.errstate(all="ignore"):
            return np.asarray(raw(x, y), dtype=float) + 0 * np.asarray(x, dtype=float)

    return value
