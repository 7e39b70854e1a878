"""A control drawn by hand against the optimal one: the oscillator of problem 5.16."""

from dataclasses import replace

import ipywidgets
import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.kernel_figure import KernelFigure
from workbook.live.worked_problem import WorkedProblem

POINTS = 240
DURATION = 2 * sp.pi


def manual_control():
    """Draw u(t) with the pointer and compare the final energy with that of the optimal control.

    The mass of problem 5.16 b starts from x = 3 at rest, |u| <= 1; here the process lasts a whole
    period, 2 pi. The drawn control is clipped to the bounds, so that it is always admissible.
    """
    problem = replace(WorkedProblem("5.16").data["half_period"], duration=DURATION)
    optimum = problem.solve()
    times = np.linspace(0, optimum.duration, POINTS)
    control = np.zeros(POINTS)
    low, high = map(float, problem.controls[problem.control[0]])
    midpoints = times[:-1] + optimum.duration / POINTS / 2
    optimal_control = np.array([optimum.control(t)[0] for t in midpoints])
    figure = BlittedFigure(2, height=4.8)
    control_axes, plane = figure.axes
    control_axes.set(
        xlim=(0, optimum.duration),
        ylim=(1.25 * low, 1.25 * high),
        xlabel="$t$",
        ylabel="$u$",
        title="draw a control here",
    )
    control_axes.axhline(0, color=plotting.GREY, linewidth=0.8)
    for bound in (low, high):
        control_axes.axhline(bound, color=plotting.GREY, linewidth=1, linestyle=":")
    plotting.window(problem.state, (-6.5, 6.5), (-6.5, 6.5), ax=plane)
    plane.set(aspect="equal", title="the swing")
    by_hand = {"color": plotting.BLUE, "linewidth": 2.6}
    optimal = {"color": plotting.RED, "linewidth": 2.2}
    control_line = figure.line(control_axes, "-", label="by hand", **by_hand)
    optimal_line = figure.line(control_axes, "--", label="the best arcs", **optimal)
    path_line = figure.line(plane, "-", **by_hand)
    optimal_path_line = figure.line(plane, "--", **optimal)
    control_axes.legend(loc="upper right", fontsize=10)
    initial_state = np.array([float(value) for value in problem.initial.values()])

    def draw(best_arcs):
        path = _trajectory(initial_state, control, times[1])
        control_line.set_data(times, control)
        path_line.set_data(*path)
        if best_arcs:
            optimal_line.set_data(np.repeat(times, 2)[1:-1], np.repeat(optimal_control, 2))
            optimal_path_line.set_data(*np.array([optimum.state(t) for t in times]).T)
        else:
            optimal_line.set_data([], [])
            optimal_path_line.set_data([], [])
        energy = (path[:, -1] @ path[:, -1]) / 2
        return f"energy at the end: {energy:.2f} by hand" + (
            f", {-optimum.cost:.2f} is the best" if best_arcs else ""
        )

    def on_stroke(axes, points):
        if axes is control_axes:
            indices = np.round(points[:, 0] / optimum.duration * (POINTS - 1)).astype(int)
            indices = np.clip(indices, 0, POINTS - 1)
            values = np.clip(points[:, 1], low, high)
            control[indices[-1]] = values[-1]
            for before, after, a, b in zip(indices, indices[1:], values, values[1:]):
                span = np.arange(min(before, after), max(before, after) + 1)
                control[span] = np.interp(span, *zip(*sorted([(before, a), (after, b)])))

    toggle = ipywidgets.ToggleButton(description="the best arcs")
    return KernelFigure(figure, {"best_arcs": toggle}, draw, on_stroke)


def _trajectory(state, control, step):
    """Return states (2, N) of x'' + x = u with the control held for each step.

    The state turns about (u, 0).
    """
    state, rotation = complex(*state), np.exp(-1j * step)
    path = [state]
    for u in control[:-1]:
        state = u + (state - u) * rotation
        path.append(state)
    return np.array([np.real(path), np.imag(path)])
