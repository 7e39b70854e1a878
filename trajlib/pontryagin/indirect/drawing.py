"""Figures of an extremal: its phase plane and its time plots, arc by arc."""

import numpy as np
import sympy as sp

from trajlib import plotting
from trajlib.pontryagin.problem.derivation import conditions

_BAND = {
    "u-": plotting.SKY,
    "u+": plotting.ORANGE,
    "interior": plotting.GREEN,
    "singular": plotting.PURPLE,
    "boundary": plotting.RED,
    "zero": plotting.GREY,
}
_NAME = {"u-": "$u_-$", "u+": "$u_+$", "zero": "$0$"}
_POINTS = 120


def draw_extremal(extremal, axes=None):
    """Draw phase plane, states, controls with dH/du, and costates; return the array of Axes.

    `axes`: three Axes, or four with the phase plane first, for two states or more. The arcs are
    coloured bands with their names; the phase plane marks the initial state, the switchings and the
    end.
    """
    planar = len(extremal.problem.state) > 1
    count = 3 + planar
    axes = _new_axes(count) if axes is None else np.atleast_1d(axes).ravel()
    if len(axes) != count:
        raise ValueError(f"axes: expected {count} Axes, got {len(axes)}")
    if planar:
        phase_plane(extremal, axes[0])
    states, controls, costates = axes[planar:]
    problem, derived = extremal.problem, conditions(extremal.problem)
    _time_plots(extremal, states, [(extremal.state, problem.state)], "state")
    _time_plots(extremal, controls, [(extremal.control, problem.control)], "control")
    _slopes(extremal, controls)
    _time_plots(extremal, costates, [(extremal.costate, derived.costate)], "costate")
    for ax in (states, controls, costates):
        _bands(extremal, ax)
        ax.set_xlabel("$t$")
        ax.set_xlim(0, extremal.duration)
        ax.locator_params(axis="x", nbins=5)
    return axes


def phase_plane(extremal, ax=None):
    """Draw the trajectory in the plane of the first two states; return the Axes."""
    ax = _new_axes(1)[0] if ax is None else ax
    for _kind, begin, end in extremal.arcs:
        path = extremal.state(np.linspace(begin, max(begin, end - 1e-12 * (1 + end)), _POINTS))
        ax.plot(path[0], path[1], color=plotting.BLUE, linestyle="-")
        middle = path[:2, _POINTS // 2 : _POINTS // 2 + 2]
        ax.annotate(
            "",
            xy=middle[:, 1],
            xytext=middle[:, 0],
            arrowprops={"arrowstyle": "-|>", "color": plotting.BLUE, "mutation_scale": 14},
        )
    start, finish = extremal.state(0.0), extremal.state(extremal.duration)
    ax.plot(*start[:2], "o", color=plotting.BLACK, label="start")
    if extremal.switching_times:
        ax.plot(
            *extremal.state(np.array(extremal.switching_times))[:2],
            "s",
            color=plotting.RED,
            linestyle="none",
            label="switching",
        )
    ax.plot(*finish[:2], "D", color=plotting.GREEN, linestyle="none", label="end")
    ax.set_xlabel(f"${sp.latex(extremal.problem.state[0])}$")
    ax.set_ylabel(f"${sp.latex(extremal.problem.state[1])}$")
    ax.margins(0.08)
    ax.locator_params(axis="x", nbins=5)
    ax.legend(loc="best")
    return ax


def _time_plots(extremal, ax, functions, label):
    """Draw components against time, broken at the switchings where they jump."""
    for function, symbols in functions:
        lines = {}
        for _, begin, end in extremal.arcs:
            times = np.linspace(begin, end, _POINTS)
            # The value at the end of an arc belongs to the next one.
            times[-1] -= 1e-9 * (end - begin)
            values = function(times)
            for i in range(len(values)):
                lines.setdefault(i, []).append((times, values[i]))
        for i, pieces in lines.items():
            ax.plot(
                np.concatenate([t for t, _ in pieces]),
                np.concatenate([v for _, v in pieces]),
                label=f"${sp.latex(symbols[i])}$",
            )
    ax.set_ylabel(label)


def _slopes(extremal, ax):
    """Draw the switching functions, scaled to the figure of the controls."""
    derived = conditions(extremal.problem)
    times = np.linspace(0, extremal.duration, 4 * _POINTS)
    values = extremal.switching(times)
    for j, u in enumerate(extremal.problem.control):
        if u not in derived.switching:
            continue
        largest = np.max(np.abs(values[j]))
        height = max(abs(v) for v in ax.get_ylim())
        scale = height / largest if largest > 0 else 1.0
        factor = "" if abs(scale - 1) < 1e-9 else f"{scale:.2g}\\,"
        ax.plot(
            times,
            scale * values[j],
            color=plotting.BLACK,
            linestyle=":",
            label=rf"${factor}\partial H/\partial {sp.latex(u)}$",
        )
    ax.axhline(0, color=plotting.GREY, linewidth=0.8, linestyle="-")


def _bands(extremal, ax):
    """Draw the arcs as coloured bands with their names."""
    for index, (kind, begin, end) in enumerate(extremal.arcs):
        first = kind if isinstance(kind, str) else kind[0]
        ax.axvspan(
            begin,
            end,
            color=_BAND[first.split()[0]],
            alpha=0.16 if index % 2 else 0.10,
            linewidth=0,
        )
        kinds = [kind] if isinstance(kind, str) else kind
        text = ", ".join(_NAME.get(k, k) for k in kinds)
        # Names are written where their bands have room for them.
        if end - begin > (0.03 + 0.02 * len("".join(k[:8] for k in kinds))) * extremal.duration:
            ax.text(
                (begin + end) / 2,
                1.01,
                text,
                transform=ax.get_xaxis_transform(),
                ha="center",
                va="bottom",
                fontsize=10,
            )
    ax.legend(loc="best")


def _new_axes(count):
    import matplotlib.pyplot as plt

    with plotting.style():
        # Four in a square; three time plots below one another.
        rows, columns = (2, 2) if count == 4 else (count, 1)
        _figure, axes = plt.subplots(
            rows,
            columns,
            figsize=(4.6 * columns + 0.4, 3.5 * rows - 0.7 * (count == 3) * rows),
            squeeze=False,
        )
    return axes.ravel()
