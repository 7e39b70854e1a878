"""The figure of a planar synthesis; each kind of curve has its own line style."""

import numpy as np
import sympy as sp

from trajlib.plotting import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, style, window


def draw(synthesis, ax=None, isochrones=(), extremals=24):
    """Draw regions of the levels (u_+ hatched), extremals, curves and barriers; return the Axes."""
    import matplotlib.pyplot as plt

    with style():
        if ax is None:
            _, ax = plt.subplots(figsize=(6.4, 5))
        ax = window(synthesis.problem.state, *synthesis.window, ax=ax)
        _regions(synthesis, ax)
        for points, _ in synthesis.extremals(extremals) if extremals else ():
            _extremal(ax, points, synthesis)
        for time in isochrones:
            for line in synthesis.isochrone(time):
                _line(ax, line, "isochrones", color=GREY, ls=(0, (1, 1.5)), lw=1.3, zorder=2)
        for curve in synthesis.switching_curves:
            _line(ax, curve.points, "switching curve", color=RED, ls="-", lw=2.8, zorder=5)
        for curve in synthesis.dispersal_curves:
            _line(ax, curve.points, "dispersal curve", color=GREEN, ls=":", lw=3, zorder=5)
        barriers = synthesis.barriers
        for curve in synthesis.borders:
            if any(curve is barrier for barrier in barriers):
                _line(ax, curve.points, "barrier", color=PURPLE, ls="-.", lw=2.6, zorder=5)
            elif curve.optimal and synthesis.reached:
                _line(ax, curve.points, "abnormal extremal", color=BLUE, ls="--", lw=2.2, zorder=4)
        _target(synthesis, ax)
        ax.legend(loc="upper right", fontsize=10)
    return ax


#: Looks of the regions of a mode: colour, its strength, hatching, its colour. The last of two is
#: u_+, as everywhere.
LOOKS = (
    (GREY, 0.0, None, GREY),
    (SKY, 0.3, "///", "#9CCBE6"),
    (GREY, 0.3, None, GREY),
    (ORANGE, 0.2, "...", "#E8C58A"),
    (GREEN, 0.15, "xxx", "#A9D8C6"),
    (PURPLE, 0.15, "\\\\\\", "#D9B8CC"),
)


def _regions(synthesis, ax):
    """Draw a colour and a hatching for each mode of the controls."""
    (left, right), (bottom, top) = synthesis.window
    value_function, plant = synthesis._value_function, synthesis.plant
    X, Y = np.meshgrid(np.linspace(left, right, 301), np.linspace(bottom, top, 301))
    x = np.array([X.ravel(), Y.ravel()])
    triangle = value_function.interpolated(x)[1]
    mode = value_function.modes(triangle)
    # A cell in which the mode changes is divided by the switching curve.
    corners = plant.sequences.mode[value_function.sequence[triangle]]
    divided = np.flatnonzero((triangle >= 0) & (np.ptp(corners, axis=1) > 0))
    mode[divided] = value_function.exact(x[:, divided]).mode
    mode = mode.reshape(X.shape)
    shown = [m for m in range(len(plant.modes)) if (mode == m).any()]
    for m, (colour, strength, hatch, line) in zip(_legend_order(shown, len(plant.modes)), LOOKS):
        is_mode = (mode == m).astype(float)
        if is_mode.any() and strength:
            ax.contourf(
                X, Y, is_mode, levels=[0.5, 1.5], colors=[colour], alpha=strength, zorder=0
            ).set_linewidth(0)
        if is_mode.any() and hatch:
            hatching = ax.contourf(
                X, Y, is_mode, levels=[0.5, 1.5], colors="none", hatches=[hatch], zorder=0
            )
            hatching.set_linewidth(0)
            hatching.set_edgecolor(line)
        if is_mode.any() or len(plant.modes) == 2:
            # Empty outlines, for the legend only.
            face = "white" if not strength else _tint(colour, strength)
            ax.fill(
                [],
                [],
                facecolor=face,
                hatch=hatch,
                edgecolor=line,
                ls="-",
                label=_mode_label(synthesis, m),
            )


def _legend_order(shown, count):
    """Return the modes in the order of `LOOKS`: the lowest, the highest, those between."""
    if count == 2:
        return [0, 1]
    return [shown[0], shown[-1], *shown[1:-1]] if len(shown) > 1 else shown


def _tint(colour, strength):
    from matplotlib.colors import to_rgb

    return tuple(1 - strength * (1 - c) for c in to_rgb(colour))


def _mode_label(synthesis, mode):
    terms, names = synthesis.plant.terms, synthesis.plant.name(mode)
    labels = []
    for term, name in zip(terms, (names,) if len(terms) == 1 else names):
        u, low, high = sp.latex(term.u), sp.latex(term.low), sp.latex(term.high)
        labels.append(
            {
                "u-": f"{u} = {low}",
                "u+": f"{u} = {high}",
                "zero": f"{u} = 0",
                "interior": f"{low} < {u} < {high}",
                "open": rf"{u}\ \mathrm{{open}}",
            }[name]
        )
    return f"${', '.join(labels)}$"


def _line(ax, points, label, **look):
    """Draw a line; a label is shown once for all lines of its kind."""
    legend = ax.get_legend_handles_labels()[1]
    ax.plot(*points.T, label=None if label in legend else label, **look)


def _extremal(ax, points, synthesis):
    ax.plot(*points.T, color=BLACK, ls="-", lw=0.8, alpha=0.75, zorder=3)
    middle = len(points) // 2
    inside = synthesis._inside(points.T)
    visible = np.flatnonzero(inside)
    if visible.size > 6:
        middle = visible[visible.size // 2]
        ax.annotate(
            "",
            xy=points[middle + 1] if middle + 1 < len(points) else points[middle],
            xytext=points[middle],
            zorder=3,
            arrowprops={"arrowstyle": "-|>", "color": BLACK, "lw": 0.8, "mutation_scale": 9},
        )


def _target(synthesis, ax):
    if not synthesis.reached:
        ax.plot(*synthesis._target.at, "o", color=BLACK, ms=6, zorder=6, label="target")
        return
    for low, high, _ in synthesis._target.pieces():
        ax.plot(
            *synthesis._target.point(np.linspace(low, high, 600)),
            color=BLACK,
            ls="-",
            lw=1.2,
            zorder=4,
        )
    for arc in synthesis.reached:
        _line(
            ax,
            arc.points,
            "target, where reached",
            color=ORANGE,
            ls="-",
            lw=4.5,
            zorder=4,
            solid_capstyle="butt",
        )
        ax.plot(*arc.points.T, color=BLACK, ls="-", lw=1.2, zorder=4)
