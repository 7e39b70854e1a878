"""The time-optimal motion from a clicked state, with its costate and switching function."""

from functools import cache

import ipywidgets
import numpy as np

from trajlib import plotting
from workbook.live.errors import LiveError
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.explorer import Explorer
from workbook.live.worked_problem import WorkedProblem

#: Frames of a motion; the vertical axis over time is from -TOP to TOP.
FRAMES, TOP = 121, 2.4
#: Plants to the origin, by problem and item: name in the data, window, horizon.
PLANTS = {
    ("5.3", "a"): ("a_system", ((-2.5, 2.5), (-2.0, 2.0)), 6),
    ("5.7", "a"): ("a_system", ((-4.0, 4.0), (-2.5, 2.5)), 8),
    ("5.7", "b"): ("b_system", ((-1.2, 1.2), (-1.2, 1.2)), 5),
    ("5.7", "c"): ("c_system", ((-2.5, 2.5), (-2.0, 2.0)), 6),
}


def fastest_motion(problem="5.3", item="a"):
    """Show a switching curve and the fastest motion to the origin from a clicked state.

    Beside the plane are the costate and the switching function over time; the play button moves the
    state along its trajectory.

    Parameters
    ----------
    problem, item : str
        "5.3" a, or "5.7" a, b, c.

    Raises
    ------
    LiveError
        For another problem or item.
    """
    synthesis = _synthesis(problem, item)
    figure = BlittedFigure(2, height=4.8)
    plane, over_time = figure.axes
    synthesis.plot(ax=plane, extremals=12)
    plane.get_legend().remove()
    plane.set_title(f"{problem} {item}: the switching curve; click a start")
    over_time.set(
        xlim=(0, synthesis.horizon), ylim=(-TOP, TOP), xlabel="$t$", title="costate and control"
    )
    over_time.axhline(0, color=plotting.GREY, linewidth=0.8)
    path = figure.line(plane, "-", color=plotting.ORANGE, linewidth=3.2, zorder=7)
    state = figure.line(plane, "o", color=plotting.BLACK, markersize=10, zorder=8)
    lines = [
        figure.line(over_time, style, color=colour, linewidth=width, label=name)
        for style, colour, width, name in (
            (":", plotting.GREEN, 2, r"$\psi_1$"),
            ("--", plotting.BLUE, 2, r"$\psi_2$"),
            ("-", plotting.RED, 2.6, r"switching function $\psi^T f_1$"),
            ("-", plotting.BLACK, 1.2, "$u$"),
        )
    ]
    instant = figure.line(over_time, "-", color=plotting.GREY, linewidth=1)
    over_time.legend(loc="upper right", fontsize=10)
    motion = {}

    def start(point):
        motion.clear()
        motion.update(_extremal(synthesis, point))
        path.set_data(*motion.get("state", ([], [])))
        for line, values in zip(lines, motion.get("functions", [[]] * 4)):
            line.set_data(motion.get("times", []), values)

    def draw(frame):
        if not motion:
            state.set_data([], [])
            instant.set_data([], [])
            return "from there the origin is not reached within the horizon"
        state.set_data(*motion["state"][:, [frame]])
        instant.set_data([motion["times"][frame]] * 2, [-TOP, TOP])
        _, _, switching, control = (values[frame] for values in motion["functions"])
        return (
            f"least time {motion['times'][-1]:.3f}; now t = {motion['times'][frame]:.2f}, u = "
            f"{control:g}, switching function {switching:.3f}"
        )

    def on_stroke(axes, points):
        if axes is plane:
            start(points[-1])
            controls["frame"].value = 0

    controls = {
        "frame": ipywidgets.IntSlider(
            0, min=0, max=FRAMES - 1, readout=False, layout={"width": "480px"}
        )
    }
    play = ipywidgets.Play(max=FRAMES - 1, interval=40, show_repeat=False)
    ipywidgets.link((play, "value"), (controls["frame"], "value"))
    start(np.array([sum(side) / 2 + 0.3 * (side[1] - side[0]) for side in synthesis.window]))
    return Explorer(figure, controls, draw, on_stroke, extra_widgets=[play])


@cache
def _synthesis(problem, item):
    # loads SymPy and the engine, when the first plant is chosen
    from trajlib.pontryagin import Problem, synthesis

    if (problem, item) not in PLANTS:
        raise LiveError(
            f"no plant {problem} {item} to rest at the origin; there is "
            + ", ".join(" ".join(names) for names in PLANTS)
        )
    name, window, horizon = PLANTS[problem, item]
    system = WorkedProblem(problem).data[name]
    return synthesis(
        Problem(*system, dict.fromkeys(system.state), system.state), window=window, horizon=horizon
    )


def _extremal(synthesis, point):
    """Return times, states and functions of time of the fastest motion; empty if there is none."""
    fastest = synthesis._value_function.by_newton(point[:, None])
    if not np.isfinite(fastest.cost[0]):
        return {}
    fan = synthesis._value_function.fans[fastest.fan[0]]
    remaining = np.linspace(fastest.time[0], 0, FRAMES)
    states, mode = fan.flow(np.full(FRAMES, fastest.s[0]), remaining)
    state, psi = states[:2], states[2:4]
    psi /= np.hypot(*psi).max()  # the costate is determined up to a positive factor
    with_control, without_control = (
        fan.plant.at(state, np.full((1, FRAMES), u))[0] for u in (1.0, 0.0)
    )
    switching = (psi * (with_control - without_control)).sum(axis=0)
    return {
        "times": remaining[0] - remaining,
        "state": state,
        "functions": [*psi, switching, fan.plant.control(states, mode)[0]],
    }
