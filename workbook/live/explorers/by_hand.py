"""A control drawn by hand against the best one: problem 5.16, the oscillator that is to have the
greatest energy."""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage
from workbook.live.worked import Worked

POINTS = 240
DURATION = 2 * sp.pi


def against_the_best():
    """Draw u(t) with the pointer: the swing it makes, its energy at the end, and the best arcs
    beside it.

    The mass of problem 5.16 b starts from x = 3 at rest, |u| <= 1; here the process lasts a whole
    swing, 2 pi. What is drawn is held between the bounds, so that every hand finds an admissible
    control.
    """
    import ipywidgets

    problem = replace(Worked("5.16").data["half_period"], duration=DURATION)
    best = problem.solve()
    times = np.linspace(0, best.duration, POINTS)
    control = np.zeros(POINTS)
    low, high = map(float, problem.controls[problem.control[0]])
    best_control = np.array([best.control(t)[0] for t in times[:-1] + best.duration / POINTS / 2])
    stage = Stage(2, height=4.8)
    drawn, plane = stage.axes
    drawn.set(
        xlim=(0, best.duration),
        ylim=(1.25 * low, 1.25 * high),
        xlabel="$t$",
        ylabel="$u$",
        title="draw a control here",
    )
    drawn.axhline(0, color=plotting.GREY, linewidth=0.8)
    for bound in (low, high):
        drawn.axhline(bound, color=plotting.GREY, linewidth=1, linestyle=":")
    plotting.window(problem.state, (-6.5, 6.5), (-6.5, 6.5), ax=plane)
    plane.set(aspect="equal", title="the swing")
    hand = stage.line(drawn, "-", color=plotting.BLUE, linewidth=2.6, label="by hand")
    arcs = stage.line(drawn, "--", color=plotting.RED, linewidth=2.2, label="the best arcs")
    swing = stage.line(plane, "-", color=plotting.BLUE, linewidth=2.6)
    best_swing = stage.line(plane, "--", color=plotting.RED, linewidth=2.2)
    drawn.legend(loc="upper right", fontsize=10)
    start = np.array([float(value) for value in problem.initial.values()])

    def draw(best_arcs):
        path = _swing(start, control, times[1])
        hand.set_data(times, control)
        swing.set_data(*path)
        if best_arcs:
            arcs.set_data(np.repeat(times, 2)[1:-1], np.repeat(best_control, 2))
            best_swing.set_data(*np.array([best.state(t) for t in times]).T)
        else:
            arcs.set_data([], [])
            best_swing.set_data([], [])
        energy = (path[:, -1] @ path[:, -1]) / 2
        return f"energy at the end: {energy:.2f} by hand" + (
            f", {-best.cost:.2f} is the best" if best_arcs else ""
        )

    def pointed(axes, points):
        if axes is drawn:
            places = np.clip(
                np.round(points[:, 0] / best.duration * (POINTS - 1)).astype(int), 0, POINTS - 1
            )
            values = np.clip(points[:, 1], low, high)
            control[places[-1]] = values[-1]
            for before, after, a, b in zip(places, places[1:], values, values[1:]):
                span = np.arange(min(before, after), max(before, after) + 1)
                control[span] = np.interp(span, *zip(*sorted([(before, a), (after, b)])))

    shown = ipywidgets.ToggleButton(description="the best arcs")
    return Explorer(stage, {"best_arcs": shown}, draw, pointed)


def _swing(state, control, step):
    """States (2, N) of x'' + x = u, the control held for a step: it turns about (u, 0)."""
    state, turned = complex(*state), np.exp(-1j * step)
    path = [state]
    for u in control[:-1]:
        state = u + (state - u) * turned
        path.append(state)
    return np.array([np.real(path), np.imag(path)])
