"""Roots of polynomials in the complex plane, and estimates over time."""

from itertools import cycle

import numpy as np
import sympy as sp

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


def roots(polys, symbol, ax=None, labels=None):
    """The roots of one or several polynomials in the complex plane, with the imaginary axis
    (MATLAB: rlocus, pzmap).

    `polys`: an expression or a list of expressions with numeric coefficients in `symbol`; `labels`:
    one for each. The half-plane of stability is shaded.
    """
    polys = [polys] if isinstance(polys, (sp.Expr, sp.Poly)) else list(polys)
    labels = [None] * len(polys) if labels is None else list(labels)
    if len(labels) != len(polys):
        raise ValueError(
            f"labels: expected one for each of the {len(polys)} polynomials, got {len(labels)}"
        )
    found = [_roots_of(poly, symbol) for poly in polys]
    ax = new_axes() if ax is None else ax
    colours = (BLUE, RED, GREEN, PURPLE, ORANGE, BLACK, SKY)
    for values, label, marker, colour in zip(found, labels, cycle("osD^vP*"), cycle(colours)):
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
    everything = np.concatenate(found)
    reach = 1.15 * max([1.0, *np.abs(everything.real), *np.abs(everything.imag)])
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
    ax.axvspan(-reach, 0, color=SKY, alpha=0.2, linewidth=0, zorder=0)
    ax.axvline(0, color=BLACK, linewidth=1.6, zorder=2)
    ax.axhline(0, color=GREY, linewidth=0.8, zorder=1)
    ax.set_xlabel(rf"$\mathrm{{Re}}\,{sp.latex(symbol)}$")
    ax.set_ylabel(rf"$\mathrm{{Im}}\,{sp.latex(symbol)}$")
    if any(labels):
        add_legend(ax)
    return ax


def _roots_of(poly, symbol):
    try:
        return np.roots([complex(c) for c in sp.Poly(poly, symbol).all_coeffs()])
    except (TypeError, sp.PolynomialError):
        raise ValueError(
            f"polys: expected polynomials in {symbol} with numeric coefficients, got {poly}"
        ) from None


def estimate(times, mean, deviation, ax=None, label=None, colour=BLUE, line="-"):
    """An estimate over time with the band of two standard deviations of its error on either side.

    `times`, `mean`, `deviation`: arrays of N numbers; a time that stands there twice is a jump.
    """
    times, mean, deviation = (np.asarray(part, dtype=float) for part in (times, mean, deviation))
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
