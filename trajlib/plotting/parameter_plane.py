"""Regions of two parameters, given by a condition."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib.plotting.appearance import BLUE, GREY
from trajlib.plotting.plane import hatch, numeric_function, read_two_symbols, window, window_grid

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def region(
    condition: sp.Basic,
    parameters: Sequence,
    x_range: tuple,
    y_range: tuple,
    ax: Axes | None = None,
) -> Axes:
    """Hatch the set of two parameters where a condition holds, and draw its boundary.

    Parameters
    ----------
    condition : sympy.Boolean
        Equations and inequalities joined by and/or.
    parameters : sequence of sympy.Symbol
        The two parameters.
    x_range, y_range : tuple of float
        Intervals (low, high).
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; new ones if left out.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError
        If the condition is no SymPy condition.
    ValueError
        If it has other symbols.

    Notes
    -----
    A dashed boundary does not belong to the set (strict inequality), a solid one does.
    """
    condition = sp.sympify(condition)
    if not isinstance(condition, sp.logic.boolalg.Boolean):
        raise TypeError(f"condition: expected a SymPy condition, got {condition!r}")
    parameters = read_two_symbols(parameters, "parameters")
    undeclared = condition.free_symbols - set(parameters)
    if undeclared:
        raise ValueError(
            f"condition: it also has {', '.join(sorted(map(str, undeclared)))}, which is no parameter"
        )
    ax = window(parameters, x_range, y_range, ax)
    X, Y = window_grid(ax)
    depth = _depth(sp.to_nnf(condition), parameters, X, Y)
    inside = depth > 0
    if inside.any():
        hatch(ax, X, Y, depth)
    # A line is boundary only where both the region and its complement are near.
    border = _dilate(inside) & _dilate(~inside)
    for relation in condition.atoms(sp.core.relational.Relational) if border.any() else ():
        margin = np.where(border, _depth(relation, parameters, X, Y), np.nan)
        ax.contour(
            X,
            Y,
            margin,
            levels=[0],
            colors=[BLUE],
            linewidths=2,
            zorder=3,
            linestyles="--" if isinstance(relation, (sp.Gt, sp.Lt)) else "-",
        )
    if not inside.any():
        ax.text(0.5, 0.5, "empty", transform=ax.transAxes, ha="center", va="center", fontsize=14)
    ax.axhline(0, color=GREY, linewidth=0.8, zorder=0)
    ax.axvline(0, color=GREY, linewidth=0.8, zorder=0)
    return ax


def _dilate(inside):
    from scipy import ndimage

    return ndimage.binary_dilation(inside, structure=np.ones((3, 3)), iterations=2)


def _depth(condition, symbols, X, Y):
    """Return a function on the grid that is positive where the condition holds.

    It is continuous across the boundary of the set.
    """
    if condition is sp.true:
        return np.ones_like(X)
    if condition is sp.false:
        return -np.ones_like(X)
    if isinstance(condition, (sp.And, sp.Or)):
        parts = [_depth(part, symbols, X, Y) for part in condition.args]
        return (np.minimum if isinstance(condition, sp.And) else np.maximum).reduce(parts)
    if isinstance(condition, (sp.Gt, sp.Ge, sp.Lt, sp.Le)):
        values = numeric_function(condition.gts - condition.lts, symbols)(X, Y)
        return np.where(np.isfinite(values), values, -1)
    if isinstance(condition, sp.Ne):
        return np.ones_like(X)
    if isinstance(condition, sp.Eq):
        return -np.ones_like(X)
    raise TypeError(
        f"condition: expected equations and inequalities joined by and/or, got {condition}"
    )
