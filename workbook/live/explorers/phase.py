"""The phase portrait of a planar problem of chapter 1, redrawn while its parameter moves."""

import dataclasses
import warnings
from dataclasses import dataclass

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage, slider
from workbook.live.subjects import LiveError
from workbook.live.worked import Worked

#: Starts across and upwards; steps of a short line, each this share of the window; of the line from
#: a click.
GRID, STEPS, SHARE, LONG = (12, 9), 9, 0.012, 1500


@dataclass(frozen=True)
class Portrait:
    """What to draw: `field` and `state` are names of data, or functions of the data that give them;
    `parameters`: {name: (from, to, at first)}; `given`: numbers for the other symbols."""

    x_range: tuple
    y_range: tuple
    field: object = "field"
    state: object = "state"
    parameters: dict = dataclasses.field(default_factory=dict)
    given: dict = dataclasses.field(default_factory=dict)


def _matrix(name):
    return {"field": lambda data: data[name] * sp.Matrix(PLANE), "state": lambda data: PLANE}


def _oscillator(name):
    """x'' = ..., of an equation that is linear in x''."""

    def rates(data):
        t, x = data["t"], data["x"]
        second = sp.solve(data[name], x.diff(t, 2))[0]
        return [PLANE[1], second.subs(x.diff(t), PLANE[1]).subs(x, PLANE[0])]

    return {"field": rates, "state": lambda data: PLANE}


def _around(data):
    """1.12 in the plane: r' and phi' as given, x = r cos(phi), y = r sin(phi)."""
    x, y = PLANE
    radius = sp.sqrt(x**2 + y**2)
    grows, turns = (data[name].subs(data["r"], radius) for name in ("radial_rate", "angular_rate"))
    return [grows * x / radius - turns * y, grows * y / radius + turns * x]


def _heading(data):
    """1.10 at the constant speed V: the heading and its rate."""
    _alpha, omega = data["heading"]
    return [omega, data["field"][4].subs({data["u_D"]: 0})]


PLANE = sp.symbols("x1 x2", real=True)
GAINS = {"k1": (-4, 4, -2), "k2": (-4, 4, -3)}
PORTRAITS = {
    "1.1": {
        "a": Portrait((-3, 3), (-1.41, 1.41), "a_field", "a_state"),
        "b": Portrait((-3, 6), (-3, 3.5), "b_field", "b_state"),
        "c": Portrait((-3, 4), (-2, 7), "c_field", "c_state"),
    },
    "1.2": {
        "": Portrait(
            (-7.5, 7.5), (-3.4, 3.4), parameters={"delta": (-1, 3, 0.3), "omega": (0.3, 2, 1)}
        )
    },
    "1.3": {
        "": Portrait((-10, 10), (-10, 10), parameters={"b": (-0.1, 0.1, -0.04), "a": (-1, 3, 1)})
    },
    "1.4": {"": Portrait((-3, 3), (-4, 4), parameters={"epsilon": (-2, 3, 0.5)})},
    "1.6": {
        "a": Portrait(
            (-0.8, 3.6),
            (-2, 2.6),
            "a_field",
            parameters={"k": (-1.2, -0.05, -0.3)},
            given={"Omega": 1},
        ),
        "b": Portrait(
            (-0.8, 3.6),
            (-2, 2.6),
            "b_field",
            parameters={"k": (-1.2, -0.05, -0.3), "k1": (0.05, 2, 0.5)},
            given={"Omega": 1},
        ),
    },
    "1.7": {
        "": Portrait(
            (0, 10),
            (0, 3),
            lambda data: [data["v"], *data["field"]],
            lambda data: [PLANE[0], data["v"]],
            parameters={"P": (0.5, 4, 2)},
            given={"m": 1, "g": 1, "k": 0.5},
        )
    },
    "1.8": {
        "": Portrait(
            (-np.pi, np.pi),
            (0.05, 2.6),
            "b_field",
            parameters={"P": (0, 2.5, 0.5), "k": (0, 1, 0.3)},
            given={"g": 1},
        )
    },
    "1.9": {
        "": Portrait(
            (-np.pi, np.pi),
            (0.05, 2.6),
            parameters={"k": (0, 1, 0.2), "k1": (0.2, 2, 1)},
            given={"g": 1},
        )
    },
    "1.10": {
        "": Portrait(
            (-2, 2),
            (-2, 2),
            _heading,
            "heading",
            parameters={"V": (-2, 2, 1), "k2": (-2, 2, 1)},
            given={"k1": 1, "k3": 1},
        )
    },
    "1.11": {
        "": Portrait(
            (0.05, 4),
            (-np.pi, np.pi),
            "plus_field",
            parameters={"ubar": (0.1, 2, 0.6), "b": (0.05, 0.95, 0.5)},
        )
    },
    "1.12": {
        "": Portrait(
            (-1.8, 1.8), (-1.8, 1.8), _around, lambda data: PLANE, parameters={"u": (0, 5, 3)}
        )
    },
    "1.13": {item: Portrait((-1.8, 1.8), (-1.8, 1.8), f"{item}_field") for item in "abc"},
    "1.14": {
        item: Portrait(
            (-3, 3), (-3, 3), **_oscillator(f"{item}_equation"), parameters={"k": (low, high, at)}
        )
        for item, low, high, at in (
            ("a", -2, 2, -0.5),
            ("b", -2, 2, -0.5),
            ("c", -2, 0.95, -0.5),
            ("d", 0.05, 2, 0.5),
        )
    },
    "1.16": {
        item: Portrait((-3, 3), (-3, 3), **_matrix(f"{item}_matrix"), parameters=GAINS)
        for item in "abcdef"
    },
    "1.17": {
        "": Portrait(
            (-3, 3),
            (-3, 3),
            **_matrix("A"),
            parameters={"epsilon": (-1, 5, 1), "omega2": (-1, 6, 2)},
        )
    },
}


def phase_portrait(problem="1.4", item=""):
    """The portrait of a problem of chapter 1, with a slider for each parameter; a click draws the
    motion through it.

    `problem`: a number, `item`: a letter where the problem has several systems. Rest points are
    marked: filled if stable, open if unstable, a cross for a saddle.
    """
    item, portrait = _asked(problem, item)
    data = Worked(problem).data
    rates, state = (
        part(data) if callable(part) else data[part] for part in (portrait.field, portrait.state)
    )
    known = {symbol.name: symbol for rate in rates for symbol in sp.sympify(rate).free_symbols}
    rates = sp.Matrix(
        [
            sp.sympify(rate).subs(
                {known[name]: value for name, value in portrait.given.items() if name in known}
            )
            for rate in rates
        ]
    )
    arguments = [*state, *(known.get(name, sp.Symbol(name)) for name in portrait.parameters)]
    velocity, slopes, alone = (
        sp.lambdify(arguments, *form)
        for form in (
            (list(rates), "numpy"),
            (list(rates.jacobian(list(state))), "numpy"),
            (list(rates), "math"),
        )
    )

    stage = Stage(1, height=5.6)
    (plane,) = stage.axes
    plotting.window(state, portrait.x_range, portrait.y_range, ax=plane)
    plane.axhline(0, color=plotting.GREY, linewidth=0.6)
    plane.axvline(0, color=plotting.GREY, linewidth=0.6)
    plane.set_title(f"problem {problem}" + (f", item {item}" if item else ""))
    window = np.array([portrait.x_range, portrait.y_range], dtype=float)
    starts = _starts(window)
    lines = stage.moving(_lines(plane, len(starts[0])))
    heads = stage.moving(
        plane.quiver(
            *starts,
            *starts,
            angles="xy",
            scale_units="xy",
            scale=1,
            color="#7A7A7A",
            width=0.0022,
            headwidth=5,
            headlength=6,
            headaxislength=6,
            minlength=0,
            zorder=2,
        )
    )
    motion = stage.line(plane, "-", color=plotting.BLUE, linewidth=2.4)
    begin = stage.line(plane, "o", color=plotting.BLUE, markersize=7)
    marks = {
        "stable": stage.line(plane, "o", color=plotting.BLACK, markersize=9),
        "unstable": stage.line(
            plane,
            "o",
            markerfacecolor="white",
            markeredgecolor=plotting.RED,
            markersize=9,
            markeredgewidth=2,
        ),
        "saddle": stage.line(plane, "X", color=plotting.RED, markersize=10),
    }
    clicked = []

    def draw(**values):
        numbers = list(values.values())
        _there, paths = _short_lines(lambda x, y: velocity(x, y, *numbers), starts, window)
        lines.set_segments(paths)
        heads.set_offsets(paths[:, -2])
        heads.set_UVC(*(paths[:, -1] - paths[:, -2]).T)
        kinds = _rest_points(velocity, slopes, starts, numbers, window)
        for kind, artist in marks.items():
            artist.set_data(
                *np.array([point for point, said in kinds if said == kind]).reshape(-1, 2).T
            )
        if clicked:
            begin.set_data(*np.transpose([clicked[-1]]))
            motion.set_data(*_motion(alone, clicked[-1], numbers, window))
        counts = [
            f"{sum(said == kind for _, said in kinds)} {kind}"
            for kind in marks
            if any(said == kind for _, said in kinds)
        ]
        return "rest points here: " + (", ".join(counts) or "none")

    def pointed(axes, points):
        clicked.append(points[-1])

    controls = {name: slider(name, *ends) for name, ends in portrait.parameters.items()}
    return Explorer(stage, controls, draw, pointed)


def _asked(problem, item):
    if problem not in PORTRAITS:
        raise LiveError(f"problem {problem} moves in no plane; there is {', '.join(PORTRAITS)}")
    items = PORTRAITS[problem]
    if not item:
        return next(iter(items.items()))
    if item not in items:
        raise LiveError(
            f"problem {problem} has no system {item}; "
            + (f"there is {', '.join(items)}" if "" not in items else "it has one only")
        )
    return item, items[item]


def _starts(window):
    """Points of a grid, every other row shifted by half a mesh."""
    (left, right), (low, high) = window
    across, upwards = GRID
    x, y = np.meshgrid((np.arange(across) + 0.25) / across, (np.arange(upwards) + 0.5) / upwards)
    x[::2] += 0.5 / across
    return left + (right - left) * x.ravel(), low + (high - low) * y.ravel()


def _lines(axes, count):
    from matplotlib.collections import LineCollection

    lines = LineCollection(np.zeros((count, 2, 2)), colors="#9A9A9A", linewidths=1.1, zorder=1)
    axes.add_collection(lines, autolim=False)
    return lines


def _short_lines(velocity, starts, window):
    """Pieces of trajectories, all of one length in the picture: the midpoint rule, with the length
    for the time."""
    size = (window[:, 1] - window[:, 0])[:, None]

    def direction(points):
        with np.errstate(all="ignore"):
            rate = (
                np.array(
                    [np.broadcast_to(part, points[0].shape) for part in velocity(*points)],
                    dtype=float,
                )
                / size
            )
            rate = rate / (np.hypot(*rate) + 1e-3)
        return np.where(np.isfinite(rate).all(axis=0), rate, 0) * size

    points = np.array(starts, dtype=float)
    paths = [points]
    for _ in range(STEPS):
        half = points + SHARE / 2 * direction(points)
        points = points + SHARE * direction(half)
        paths.append(points)
    return paths[0], np.array(paths).transpose(2, 0, 1)


def _rest_points(velocity, slopes, starts, numbers, window):
    """[(point, "stable", "unstable" or "saddle")] by Newton's method from all starts at once;
    centres count as neither and are left out, as are points outside of the window."""
    points = np.array(starts, dtype=float)
    with np.errstate(all="ignore"):
        for _ in range(14):
            f, (a, b, c, d) = _values(velocity, points, numbers), _values(slopes, points, numbers)
            determinant = a * d - b * c
            points = points - np.array([d * f[0] - b * f[1], a * f[1] - c * f[0]]) / determinant
        f, (a, b, c, d) = _values(velocity, points, numbers), _values(slopes, points, numbers)
        size = window[:, 1] - window[:, 0]
        found = (np.hypot(*f) < 1e-9) & (
            (points.T >= window[:, 0]) & (points.T <= window[:, 1])
        ).all(axis=1)
    kinds = {}
    for k in np.flatnonzero(found):
        place = tuple(np.round(points[:, k] / size, 4))
        trace, determinant = a[k] + d[k], a[k] * d[k] - b[k] * c[k]
        if determinant < -1e-9:
            kinds[place] = points[:, k], "saddle"
        elif determinant > 1e-9 and abs(trace) > 1e-9:
            kinds[place] = points[:, k], "stable" if trace < 0 else "unstable"
    return list(kinds.values())


def _values(function, points, numbers):
    return [
        np.broadcast_to(np.asarray(part, dtype=float), points[0].shape)
        for part in function(*points, *numbers)
    ]


def _motion(alone, start, numbers, window):
    """The motion through a point, forwards and backwards, as long as it is in the picture."""
    from scipy.integrate import ODEintWarning, odeint

    (left, right), (low, high) = window
    width, height = right - left, high - low

    def rate(point, _, sign):
        x, y = point
        if not (
            left - width / 2 < x < right + width / 2 and low - height / 2 < y < high + height / 2
        ):
            return 0.0, 0.0
        try:
            u, v = alone(x, y, *numbers)
        except (ArithmeticError, ValueError):  # outside of where it is defined
            return 0.0, 0.0
        speed = sign * (np.hypot(u / width, v / height) + 1e-3)
        return u / speed, v / speed

    def followed(sign):
        along = np.linspace(0, 12, LONG)
        with warnings.catch_warnings():
            # it ends where it gets too stiff, and so does the line
            warnings.simplefilter("ignore", ODEintWarning)
            path, about = odeint(
                rate, start, along, args=(sign,), rtol=1e-6, atol=1e-8, full_output=True
            )
        good = np.append(True, (about["tcur"] >= along[1:]) & np.isfinite(path[1:]).all(axis=1))
        return path[: len(good) if good.all() else np.argmin(good)]

    return np.concatenate([followed(-1)[::-1], followed(1)]).T
