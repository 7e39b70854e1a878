"""Roots of polynomials in the complex plane, and estimates over time."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib._arguments.arrays import read_array
from trajlib._typing import ArrayLike
from trajlib.plotting.appearance import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    add_legend,
    new_axes,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def roots(
    polys: sp.Expr | Iterable,
    symbol: sp.Symbol,
    ax: Axes | None = None,
    labels: Iterable | None = None,
) -> Axes:
    """Draw the roots of one or several polynomials in the complex plane.

    Parameters
    ----------
    polys : sympy.Expr or iterable of sympy.Expr
        Polynomials with numeric coefficients.
    symbol : sympy.Symbol
        Their variable.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; new ones if left out.
    labels : iterable of str, optional
        Entry in the legend for each polynomial.

    Returns
    -------
    matplotlib.axes.Axes

    Notes
    -----
    The half-plane of stability is shaded. MATLAB: ``rlocus``, ``pzmap``.
    """
    polys = [polys] if isinstance(polys, (sp.Expr, sp.Poly)) else list(polys)
    labels = [None] * len(polys) if labels is None else list(labels)
    if len(labels) != len(polys):
        raise ValueError(
            f"labels: expected one for each of the {len(polys)} polynomials, got {len(labels)}"
        )
    root_sets = [_numeric_roots(poly, symbol) for poly in polys]
    ax = new_axes() if ax is None else ax
    colours = (BLUE, RED, GREEN, PURPLE, ORANGE, BLACK, SKY)
    for values, label, marker, colour in zip(root_sets, labels, cycle("osD^vP*"), cycle(colours)):
        ax.plot(
            values.real,
            values.imag,
            linestyle="none",
            marker=marker,
            markersize=8,
            color=colour,
            markeredgecolor="white",
            markeredgewidth=0.7,
            label=label or "_",
            zorder=4,
        )
    all_roots = np.concatenate(root_sets)
    extent = 1.15 * max([1.0, *np.abs(all_roots.real), *np.abs(all_roots.imag)])
    ax.set(xlim=(-extent, extent), ylim=(-extent, extent), aspect="equal")
    ax.axvspan(-extent, 0, color=SKY, alpha=0.2, linewidth=0, zorder=0)
    ax.axvline(0, color=BLACK, linewidth=1.6, zorder=2)
    ax.axhline(0, color=GREY, linewidth=0.8, zorder=1)
    ax.set_xlabel(rf"$\mathrm{{Re}}\,{sp.latex(symbol)}$")
    ax.set_ylabel(rf"$\mathrm{{Im}}\,{sp.latex(symbol)}$")
    if any(labels):
        add_legend(ax)
    return ax


def _numeric_roots(poly, symbol):
    try:
        return np.roots([complex(c) for c in sp.Poly(poly, symbol).all_coeffs()])
    except (TypeError, sp.PolynomialError):
        raise ValueError(
            f"polys: expected polynomials in {symbol} with numeric coefficients, got {poly}"
        ) from None


def estimate(
    times: ArrayLike,
    mean: ArrayLike,
    deviation: ArrayLike,
    ax: Axes | None = None,
    label: str | None = None,
    colour: str = BLUE,
    line: str = "-",
) -> Axes:
    """Draw an estimate over time with the band of two standard deviations of its error.

    Parameters
    ----------
    times, mean, deviation : array_like, shape (N,)
        Times (a time that occurs twice is a jump), estimates and standard deviations.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; new ones if left out.
    label : str, optional
        Entry in the legend.
    colour : str
        Colour of Matplotlib.
    line : str
        Line style of Matplotlib.

    Returns
    -------
    matplotlib.axes.Axes
    """
    times, mean, deviation = (
        read_array(part, name, "numbers")
        for name, part in (("times", times), ("mean", mean), ("deviation", deviation))
    )
    if not times.shape == mean.shape == deviation.shape:
        raise ValueError(
            f"deviation: expected three arrays of one shape, got {times.shape}, {mean.shape}, "
            f"{deviation.shape}"
        )
    ax = new_axes() if ax is None else ax
    ax.plot(times, mean, linestyle=line, color=colour, label=label, zorder=3)
    ax.fill_between(
        times,
        mean - 2 * deviation,
        mean + 2 * deviation,
        color=colour,
        alpha=0.18,
        linewidth=0,
        zorder=1,
    )
    for side in (-2, 2):
        ax.plot(
            times, mean + side * deviation, linestyle=line, color=colour, linewidth=0.7, zorder=2
        )
    return ax
