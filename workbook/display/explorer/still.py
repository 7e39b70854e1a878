"""The static picture of an `Explorer`, drawn by Matplotlib: on paper and without JavaScript."""

import numpy as np

from trajlib.plotting import BLACK, BLUE, GREY, ORANGE, PURPLE, SKY
from workbook.display.explorer.evaluation import evaluate

__all__ = ["draw"]

LINES = {
    "solid": {"color": BLUE, "linewidth": 2},
    "dashed": {"color": ORANGE, "linewidth": 2, "linestyle": (0, (6, 3))},
    "dotted": {"color": PURPLE, "linewidth": 2, "linestyle": (0, (1, 1.5))},
    "thin": {"color": GREY, "linewidth": 1},
}
MARKS = {
    "cross": {"marker": "x", "color": ORANGE, "markersize": 9, "markeredgewidth": 2.4},
    "dot": {"marker": "o", "color": GREY, "markersize": 3.5},
    "ring": {"marker": "o", "color": PURPLE, "markersize": 8, "markerfacecolor": "none"},
}
#: Width of a panel, and height of what stands below its axis, in inches.
WIDTH, MARGIN = 3.6, 0.6
#: Points of a region, and arrows of a field, along an axis.
GRID, ARROWS = 201, 15


def draw(explorer, values):
    """Return the figure for given values of parameters by name."""
    from matplotlib.figure import Figure

    columns = []
    for panel in explorer.panels:
        columns[-1].append(panel) if panel.below else columns.append([panel])
    heights = [sum(WIDTH * panel.height + MARGIN for panel in column) for column in columns]
    size = WIDTH * len(columns), max(heights)
    figure = Figure(figsize=size, layout="constrained")
    parts = figure.subfigures(1, len(columns), squeeze=False)[0]
    computed = evaluate(explorer, values)
    for part, column in zip(parts, columns):
        ratios = [panel.height for panel in column]
        axes = part.subplots(len(column), 1, squeeze=False, height_ratios=ratios)[:, 0]
        for ax, panel in zip(axes, column):
            _panel(ax, panel, computed)
    return figure


def _panel(ax, panel, computed):
    ax.set(xlim=panel.x_range, ylim=panel.y_range, xlabel=panel.names[0])
    ax.set_title(panel.names[1], loc="left", fontsize="medium")
    if not panel.names[1]:  # a track, a body
        ax.set_yticks([])
    ax.grid(color="0.9")
    ax.set_axisbelow(True)
    for part in panel.parts:
        DRAWN[part.kind](ax, panel, part, computed)
    labels = [part.label for part in panel.parts if part.label]
    if labels:
        _legend(ax, 2 if max(map(len, labels)) <= 20 else 1)


def _legend(ax, columns):
    """Place the legend below the name of the axis, where it covers no curve."""
    from matplotlib.transforms import ScaledTranslation

    below = ax.transAxes + ScaledTranslation(-0.25, -0.48, ax.figure.dpi_scale_trans)
    style = {"fontsize": 8, "frameon": False, "borderaxespad": 0, "borderpad": 0}
    ax.legend(ncols=columns, loc="upper left", bbox_to_anchor=(0, 0), bbox_transform=below, **style)


def _line(ax, panel, part, computed):
    ax.plot(*_coordinates(part, computed), label=part.label, **LINES[part.style])


def _marks(ax, panel, part, computed):
    style = MARKS[part.style]
    ax.plot(*_coordinates(part, computed), linestyle="none", label=part.label, **style)


def _point(ax, panel, part, computed):
    marker = {"marker": "o", "color": BLACK, "markersize": 9, "linestyle": "none"}
    ax.plot(*_coordinates(part, computed), label=part.label, zorder=5, **marker)


def _segments(ax, panel, part, computed):
    x, y = ([float(f(computed.scalars)) for f in part.formulas[role]] for role in ("x", "y"))
    ax.plot(x, y, label=part.label, **LINES[part.style])


def _region(ax, panel, part, computed):
    grid = _grid(panel, GRID)
    inside = part.formulas["condition"][0](computed.scalars, grid).astype(float)
    ax.contourf(*grid, inside, levels=(0.5, 1.5), colors=[SKY], alpha=0.3)
    if 0 < inside.mean() < 1:
        ax.contour(*grid, inside, levels=(0.5,), colors=[BLACK], linewidths=1)
    if part.label:
        ax.fill([], [], facecolor=SKY, alpha=0.3, edgecolor=BLACK, label=part.label)


def _field(ax, panel, part, computed):
    grid = _grid(panel, ARROWS)
    spans = np.ptp(panel.x_range), np.ptp(panel.y_range)
    rates = [
        part.formulas[role][0](computed.scalars, grid) / span for role, span in zip("xy", spans)
    ]
    length = np.hypot(*rates)
    length[length == 0] = 1
    u, v = (rate / length for rate in rates)
    style = {"color": GREY, "alpha": 0.6, "pivot": "mid", "angles": "uv", "width": 0.004}
    ax.quiver(*grid, u, v, scale=24, headwidth=4, **style)


def _coordinates(part, computed):
    columns = () if part.series is None else computed.series[part.series]
    return [part.formulas[role][0](computed.scalars, columns) for role in ("x", "y")]


def _grid(panel, count):
    return np.meshgrid(np.linspace(*panel.x_range, count), np.linspace(*panel.y_range, count))


DRAWN = {
    "line": _line,
    "marks": _marks,
    "point": _point,
    "segments": _segments,
    "region": _region,
    "field": _field,
}
