"""The fastest motion from where one clicks: in the plane, and beside it the costate that drives
it."""

from functools import cache

import ipywidgets
import numpy as np

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage
from workbook.live.subjects import LiveError
from workbook.live.worked import Worked

FRAMES, TOP = 121, 2.4
#: Of each plant that goes to rest at the origin: its name in the data, the window, the horizon.
PLANTS = {
    ("5.3", "a"): ("a_system", ((-2.5, 2.5), (-2.0, 2.0)), 6),
    ("5.7", "a"): ("a_system", ((-4.0, 4.0), (-2.5, 2.5)), 8),
    ("5.7", "b"): ("b_system", ((-1.2, 1.2), (-1.2, 1.2)), 5),
    ("5.7", "c"): ("c_system", ((-2.5, 2.5), (-2.0, 2.0)), 6),
}


def fastest_motion(problem="5.3", item="a"):
    """The switching curve of a plant of second order, and the fastest motion to rest from where one
    clicks.

    Beside the plane stand the costate and the switching function over time; the play button moves
    the state along its way. `problem`, `item`: "5.3" a, or "5.7" a, b, c.
    """
    found = _synthesis(problem, item)
    stage = Stage(2, height=4.8)
    plane, over_time = stage.axes
    found.plot(ax=plane, extremals=12)
    plane.get_legend().remove()
    plane.set_title(f"{problem} {item}: the switching curve; click a start")
    over_time.set(
        xlim=(0, found.horizon), ylim=(-TOP, TOP), xlabel="$t$", title="costate and control"
    )
    over_time.axhline(0, color=plotting.GREY, linewidth=0.8)
    way = stage.line(plane, "-", color=plotting.ORANGE, linewidth=3.2, zorder=7)
    here = stage.line(plane, "o", color=plotting.BLACK, markersize=10, zorder=8)
    lines = [
        stage.line(over_time, style, color=colour, linewidth=width, label=name)
        for style, colour, width, name in (
            (":", plotting.GREEN, 2, r"$\psi_1$"),
            ("--", plotting.BLUE, 2, r"$\psi_2$"),
            ("-", plotting.RED, 2.6, r"switching function $\psi^T f_1$"),
            ("-", plotting.BLACK, 1.2, "$u$"),
        )
    ]
    moment = stage.line(over_time, "-", color=plotting.GREY, linewidth=1)
    over_time.legend(loc="upper right", fontsize=10)
    motion = {}

    def start(point):
        motion.clear()
        motion.update(_extremal(found, point))
        way.set_data(*motion.get("state", ([], [])))
        for line, values in zip(lines, motion.get("over time", [[]] * 4)):
            line.set_data(motion.get("times", []), values)

    def draw(frame):
        if not motion:
            here.set_data([], [])
            moment.set_data([], [])
            return "from there the origin is not reached within the horizon"
        here.set_data(*motion["state"][:, [frame]])
        moment.set_data([motion["times"][frame]] * 2, [-TOP, TOP])
        _, _, switching, control = (values[frame] for values in motion["over time"])
        return (
            f"least time {motion['times'][-1]:.3f}; now t = {motion['times'][frame]:.2f}, u = "
            f"{control:g}, switching function {switching:.3f}"
        )

    def pointed(axes, points):
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
    start(np.array([sum(side) / 2 + 0.3 * (side[1] - side[0]) for side in found.window]))
    return Explorer(stage, controls, draw, pointed, beside=[play])


@cache
def _synthesis(problem, item):
    from trajlib.pontryagin import Problem, synthesis

    if (problem, item) not in PLANTS:
        raise LiveError(
            f"no plant {problem} {item} to rest at the origin; there is "
            + ", ".join(" ".join(names) for names in PLANTS)
        )
    name, window, horizon = PLANTS[problem, item]
    system = Worked(problem).data[name]
    return synthesis(
        Problem(*system, dict.fromkeys(system.state), system.state), window=window, horizon=horizon
    )


def _extremal(found, point):
    """Times, states, and what runs beside them, of the fastest motion from a point; empty where
    there is none."""
    fastest = found._field.polished(point[:, None])
    if not np.isfinite(fastest.cost[0]):
        return {}
    fan = found._field.fans[fastest.fan[0]]
    left = np.linspace(fastest.time[0], 0, FRAMES)
    along, mode = fan.flow(np.full(FRAMES, fastest.s[0]), left)
    state, psi = along[:2], along[2:4]
    psi /= np.hypot(*psi).max()  # the costate has any length: this one is seen
    with_control, without = (fan.plant.at(state, np.full((1, FRAMES), u))[0] for u in (1.0, 0.0))
    switching = (psi * (with_control - without)).sum(axis=0)
    return {
        "times": left[0] - left,
        "state": state,
        "over time": [*psi, switching, fan.plant.control(along, mode)[0]],
    }
