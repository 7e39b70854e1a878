"""Phase portraits of planar systems, equilibria, nullclines and level curves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from trajlib.plotting.appearance import BLACK, BLUE, GREEN, ORANGE, RED, add_legend
from trajlib.plotting.plane import (
    hatch,
    planar_functions,
    plane_function,
    read_number_pair,
    window,
    window_grid,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def phase_portrait(
    field: Sequence,
    state: Sequence,
    x_range: tuple,
    y_range: tuple,
    ax: Axes | None = None,
    starts: Iterable | None = None,
    params: Mapping | None = None,
) -> Axes:
    """Draw the phase portrait of a planar system x' = f(x).

    Parameters
    ----------
    field : sequence of sympy.Expr
        The two components of f.
    state : sequence of sympy.Symbol
        The two state variables.
    x_range, y_range : tuple of float
        Intervals (low, high).
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; new ones if left out.
    starts : iterable of tuple, optional
        Points whose trajectories are drawn, integrated forwards and backwards until they leave the
        picture.
    params : mapping, optional
        Numbers for the other symbols.

    Returns
    -------
    matplotlib.axes.Axes

    Notes
    -----
    Where the field is not defined nothing is drawn. MATLAB: ``quiver``, ``streamslice``.
    """
    from scipy.integrate import solve_ivp

    functions, state = planar_functions(field, state, params)
    ax = window(state, x_range, y_range, ax)
    (x_low, x_high), (y_low, y_high) = ax.get_xlim(), ax.get_ylim()
    X, Y = np.meshgrid(np.linspace(x_low, x_high, 60), np.linspace(y_low, y_high, 60))
    U, V = (f(X, Y) for f in functions)
    if np.isfinite(U + V).any():
        ax.streamplot(
            X,
            Y,
            np.ma.masked_invalid(U),
            np.ma.masked_invalid(V),
            color="#B5B5B5",
            linewidth=0.8,
            arrowsize=0.9,
            density=1.1,
            zorder=1,
        )

    width, height = x_high - x_low, y_high - y_low

    def relative_speed(point):
        velocity = np.array([f(point[0], point[1]) for f in functions])
        return velocity, np.hypot(velocity[0] / width, velocity[1] / height)

    def rate(_, point):
        # Arc length in the units of the picture instead of time: equilibria are approached, never
        # overshot.
        velocity, speed = relative_speed(point)
        return velocity / (speed + 1e-3) if np.isfinite(speed) else np.zeros(2)

    def arrived(_, point):
        # Such slow motions are close to an equilibrium, where further integration shows nothing and
        # is slow.
        return relative_speed(point)[1] - 1e-3

    arrived.terminal, arrived.direction = True, -1  # type: ignore[attr-defined]

    def inside(_, point):
        return min(
            point[0] - x_low + 0.02 * width,
            x_high - point[0] + 0.02 * width,
            point[1] - y_low + 0.02 * height,
            y_high - point[1] + 0.02 * height,
        )

    inside.terminal = True  # type: ignore[attr-defined]
    for start in () if starts is None else starts:
        start = read_number_pair(start, "starts")
        for direction in (1, -1):
            path = solve_ivp(
                lambda s, p: direction * rate(s, p),
                (0, 12),
                start,
                events=[inside, arrived],
                rtol=1e-7,
                atol=1e-9,
                max_step=0.05,
            )
            ax.plot(*path.y, color=BLUE, linestyle="-", linewidth=1.6, zorder=3)
            if direction == 1:
                _arrow(ax, path.y[:, path.t <= 0.4])
        ax.plot(*start, marker="o", markersize=3, color=BLUE, zorder=3)
    return ax


def mark_equilibria(points: Iterable, labels: Iterable, ax: Axes) -> Axes:
    """Mark points of a phase plane, with one legend entry for each kind.

    Parameters
    ----------
    points : iterable of tuple
        Points of the plane.
    labels : iterable of str
        Kind of each point, such as "stable focus" or "saddle" (as `classify_planar` returns).
    ax : matplotlib.axes.Axes
        Axes to draw on.

    Returns
    -------
    matplotlib.axes.Axes

    Notes
    -----
    A filled circle is stable, an open one unstable, a cross a saddle, a square any other.
    """
    points = [read_number_pair(p, "points") for p in points]
    labels = list(labels)
    if len(labels) != len(points):
        raise ValueError(
            f"labels: expected one for each of the {len(points)} points, got {len(labels)}"
        )
    for kind in dict.fromkeys(labels):
        xs, ys = zip(*(p for p, label in zip(points, labels) if label == kind))
        ax.plot(xs, ys, linestyle="none", label=kind, zorder=5, **_marker(kind))
    add_legend(ax)
    return ax


def _marker(kind):
    kind = kind.lower()
    if "saddle" in kind:
        return {
            "marker": "X",
            "markersize": 9,
            "color": RED,
            "markeredgecolor": "white",
            "markeredgewidth": 0.8,
        }
    if "unstable" in kind:
        return {
            "marker": "o",
            "markersize": 8,
            "markerfacecolor": "white",
            "markeredgecolor": RED,
            "markeredgewidth": 2,
        }
    if "stable" in kind:
        return {"marker": "o", "markersize": 8, "color": BLACK}
    return {
        "marker": "s",
        "markersize": 7,
        "markerfacecolor": "white",
        "markeredgecolor": BLACK,
        "markeredgewidth": 1.6,
    }


def level_curve(
    V: sp.Expr, state: Sequence, level: float, ax: Axes, label: str | None = None
) -> Axes:
    """Draw the curve V = level over the window of the Axes.

    Parameters
    ----------
    V : sympy.Expr
        Function of the two state variables.
    state : sequence of sympy.Symbol
        The two state variables.
    level : float
        Level.
    ax : matplotlib.axes.Axes
        Axes to draw on.
    label : str, optional
        Entry in the legend.

    Returns
    -------
    matplotlib.axes.Axes
    """
    value, state = plane_function(V, state, "V")
    X, Y = window_grid(ax)
    drawn = ax.contour(
        X,
        Y,
        np.ma.masked_invalid(value(X, Y)),
        levels=[float(level)],
        colors=[RED],
        linewidths=2.2,
        linestyles="--",
        zorder=4,
    )
    if label and any(len(s) for s in drawn.allsegs[0]):
        ax.plot([], [], color=RED, linewidth=2.2, linestyle="--", label=label)
        add_legend(ax)
    return ax


def sublevel_component(V: sp.Expr, state: Sequence, level: float, ax: Axes) -> Axes:
    """Hatch the connected component of {V < level} that contains the origin.

    Parameters
    ----------
    V : sympy.Expr
        Function of the two state variables.
    state : sequence of sympy.Symbol
        The two state variables.
    level : float
        Level.
    ax : matplotlib.axes.Axes
        Axes to draw on.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If the origin is not in the set.
    """
    from scipy import ndimage

    value, state = plane_function(V, state, "V")
    X, Y = window_grid(ax)
    values = value(X, Y)
    # Two parts that touch in a saddle are kept apart by a slightly lower level.
    parts, _ = ndimage.label(values < float(level) * (1 - 1e-3))
    origin = parts[np.abs(Y[:, 0]).argmin(), np.abs(X[0]).argmin()]
    if origin == 0:
        raise ValueError("level: the origin is not inside V < level in this window")
    # The other parts are lifted above the level, so that the curve itself stays sharp.
    near = ndimage.binary_dilation(parts == origin, iterations=3) & (
        (parts == origin) | (parts == 0)
    )
    lifted = np.where(near, values, np.nanmax(values) + abs(float(level)) + 1)
    hatch(ax, X, Y, float(level) - lifted)
    return ax


def nullclines(field: Sequence, state: Sequence, ax: Axes, params: Mapping | None = None) -> Axes:
    """Draw the curves on which one component of a planar field vanishes.

    Parameters
    ----------
    field : sequence of sympy.Expr
        The two components of the field.
    state : sequence of sympy.Symbol
        The two state variables.
    ax : matplotlib.axes.Axes
        Axes to draw on, whose window is used.
    params : mapping, optional
        Numbers for the other symbols.

    Returns
    -------
    matplotlib.axes.Axes
    """
    functions, state = planar_functions(field, state, params)
    X, Y = window_grid(ax)
    for f, symbol, colour, line in zip(functions, state, (GREEN, ORANGE), ("--", "-.")):
        ax.contour(
            X,
            Y,
            np.ma.masked_invalid(f(X, Y)),
            levels=[0],
            colors=[colour],
            linestyles=[line],
            linewidths=1.8,
            zorder=2,
        )
        ax.plot([], [], color=colour, linestyle=line, label=f"${_dotted(symbol)} = 0$")
    add_legend(ax)
    return ax


def _arrow(ax, path):
    """Draw an arrow in the middle of a piece of a trajectory."""
    middle = path.shape[1] // 2
    if middle and middle + 1 < path.shape[1]:
        ax.annotate(
            "",
            xy=path[:, middle + 1],
            xytext=path[:, middle],
            zorder=4,
            arrowprops={"arrowstyle": "-|>", "color": BLUE, "linewidth": 1.6, "mutation_scale": 14},
        )


def _dotted(symbol):
    """Return the derivative of a symbol in mathtext, with the dot over its letter alone."""
    letter, _, index = sp.latex(symbol).partition("_")
    return rf"\dot{{{letter}}}" + (f"_{index}" if index else "")
