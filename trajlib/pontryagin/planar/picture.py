"""The picture of a planar synthesis, readable in greyscale: every kind of curve has a line style of its own."""
import numpy as np
import sympy as sp

from ...plotting import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, style, window


def draw(synthesis, ax=None, isochrones=(), extremals=24):
    """Regions of u_+ (hatched) and u_-, extremals, switching curves, dispersal curves, barriers; returns the Axes."""
    import matplotlib.pyplot as plt

    with style():
        if ax is None:
            _, ax = plt.subplots(figsize=(6.4, 5))
        ax = window(synthesis.problem.state, *synthesis.window, ax=ax)
        _regions(synthesis, ax)
        for points, controls in synthesis.extremals(extremals) if extremals else ():
            _extremal(ax, points, controls, synthesis)
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


def _regions(synthesis, ax):
    """Hatch where the control is u_+."""
    (left, right), (bottom, top) = synthesis.window
    field = synthesis._field
    X, Y = np.meshgrid(np.linspace(left, right, 301), np.linspace(bottom, top, 301))
    x = np.array([X.ravel(), Y.ravel()])
    _, triangle, _ = field.interpolated(x)
    count = field.count[triangle]
    sign = np.where(triangle >= 0, field.first[triangle]*np.where(count[:, 0] % 2, -1, 1), 0.0)
    # A cell in which the control switches is divided by the switching curve.
    divided = np.flatnonzero((triangle >= 0) & (np.ptp(count, axis=1) > 0))
    sign[divided] = field.exact(x[:, divided])[1]
    sign = sign.reshape(X.shape)
    plus = ax.contourf(X, Y, (sign > 0).astype(float), levels=[0.5, 1.5], colors=[SKY], alpha=0.3, zorder=0)
    hatching = ax.contourf(X, Y, (sign > 0).astype(float), levels=[0.5, 1.5], colors="none", hatches=["///"], zorder=0)
    for part in (plus, hatching):
        part.set_linewidth(0)
    hatching.set_edgecolor("#9CCBE6")
    low, high = (sp.latex(b) for b in synthesis.problem.controls[synthesis.problem.control[0]])
    name = sp.latex(synthesis.problem.control[0])
    # Empty outlines, for the legend only.
    ax.fill([], [], facecolor="#D2E9F6", hatch="///", edgecolor="#5AA0C8", ls="-", label=f"${name} = {high}$")
    ax.fill([], [], facecolor="white", edgecolor=GREY, ls="-", label=f"${name} = {low}$")


def _line(ax, points, label, **look):
    """Draw a line; a label is shown once, however many lines there are of the kind."""
    known = ax.get_legend_handles_labels()[1]
    ax.plot(*points.T, label=None if label in known else label, **look)


def _extremal(ax, points, controls, synthesis):
    ax.plot(*points.T, color=BLACK, ls="-", lw=0.8, alpha=0.75, zorder=3)
    middle = len(points)//2
    inside = synthesis._inside(points.T)
    visible = np.flatnonzero(inside)
    if visible.size > 6:
        middle = visible[visible.size//2]
        ax.annotate("", xy=points[middle + 1] if middle + 1 < len(points) else points[middle], xytext=points[middle],
                    zorder=3,
                    arrowprops=dict(arrowstyle="-|>", color=BLACK, lw=0.8, mutation_scale=9))


def _target(synthesis, ax):
    if not synthesis.reached:
        ax.plot(*synthesis._target.at, "o", color=BLACK, ms=6, zorder=6, label="target")
        return
    for low, high, _ in synthesis._target.pieces():
        ax.plot(*synthesis._target.point(np.linspace(low, high, 600)), color=BLACK, ls="-", lw=1.2, zorder=4)
    for arc in synthesis.reached:
        _line(ax, arc.points, "target, where reached", color=ORANGE, ls="-", lw=4.5, zorder=4, solid_capstyle="butt")
        ax.plot(*arc.points.T, color=BLACK, ls="-", lw=1.2, zorder=4)
