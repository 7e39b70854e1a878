"""The phase portrait of a planar problem of chapter 1, redrawn while a parameter changes."""

import warnings
from collections import Counter

import numpy as np
import sympy as sp

from trajlib import plotting
from workbook.live.errors import LiveError
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.kernel_figure import KernelFigure, slider
from workbook.live.explorers.portraits import PORTRAITS
from workbook.live.worked_problem import WorkedProblem

#: Initial points across and upwards; steps of a short line and their length as a share of the window;
#: points of the line from a click.
GRID, STEPS, STEP, POINTS = (12, 9), 9, 0.012, 1500


def phase_portrait(problem="1.4", item=""):
    """Show a phase portrait with sliders for its parameters; a click draws a motion.

    Equilibria are marked: filled if stable, open if unstable, a cross for a saddle.

    Parameters
    ----------
    problem : str
        A problem of chapter 1.
    item : str
        The letter of the system, where the problem has several.

    Raises
    ------
    LiveError
        If the problem has no planar system with this letter.
    """
    item, portrait = _portrait(problem, item)
    data = WorkedProblem(problem).data
    rates, state = (
        part(data) if callable(part) else data[part] for part in (portrait.field, portrait.state)
    )
    symbols_by_name = {
        symbol.name: symbol for rate in rates for symbol in sp.sympify(rate).free_symbols
    }
    rates = sp.Matrix(
        [
            sp.sympify(rate).subs(
                {
                    symbols_by_name[name]: value
                    for name, value in portrait.constants.items()
                    if name in symbols_by_name
                }
            )
            for rate in rates
        ]
    )
    arguments = [
        *state,
        *(symbols_by_name.get(name, sp.Symbol(name)) for name in portrait.parameters),
    ]
    field, jacobian, scalar_field = (
        sp.lambdify(arguments, *form)
        for form in (
            (list(rates), "numpy"),
            (list(rates.jacobian(list(state))), "numpy"),
            (list(rates), "math"),
        )
    )

    figure = BlittedFigure(1, height=5.6)
    (plane,) = figure.axes
    plotting.window(state, portrait.x_range, portrait.y_range, ax=plane)
    plane.axhline(0, color=plotting.GREY, linewidth=0.6)
    plane.axvline(0, color=plotting.GREY, linewidth=0.6)
    plane.set_title(f"problem {problem}" + (f", item {item}" if item else ""))
    window = np.array([portrait.x_range, portrait.y_range], dtype=float)
    initial_points = _initial_points(window)
    lines = figure.animate(_lines(plane, len(initial_points[0])))
    heads = figure.animate(
        plane.quiver(
            *initial_points,
            *initial_points,
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
    motion = figure.line(plane, "-", color=plotting.BLUE, linewidth=2.4)
    clicked_point = figure.line(plane, "o", color=plotting.BLUE, markersize=7)
    marks = {
        "stable": figure.line(plane, "o", color=plotting.BLACK, markersize=9),
        "unstable": figure.line(
            plane,
            "o",
            markerfacecolor="white",
            markeredgecolor=plotting.RED,
            markersize=9,
            markeredgewidth=2,
        ),
        "saddle": figure.line(plane, "X", color=plotting.RED, markersize=10),
    }
    clicked = []

    def draw(**values):
        numbers = list(values.values())
        paths = _short_lines(lambda x, y: field(x, y, *numbers), initial_points, window)
        lines.set_segments(paths)
        heads.set_offsets(paths[:, -2])
        heads.set_UVC(*(paths[:, -1] - paths[:, -2]).T)
        equilibria = _equilibria(field, jacobian, initial_points, numbers, window)
        for kind, artist in marks.items():
            artist.set_data(
                *np.array([point for point, its_kind in equilibria if its_kind == kind])
                .reshape(-1, 2)
                .T
            )
        if clicked:
            clicked_point.set_data(*np.transpose([clicked[-1]]))
            motion.set_data(*_motion(scalar_field, clicked[-1], numbers, window))
        counts = Counter(kind for _, kind in equilibria)
        return "equilibria here: " + (
            ", ".join(f"{counts[kind]} {kind}" for kind in marks if counts[kind]) or "none"
        )

    def on_stroke(axes, points):
        clicked.append(points[-1])

    controls = {name: slider(name, *ends) for name, ends in portrait.parameters.items()}
    return KernelFigure(figure, controls, draw, on_stroke)


def _portrait(problem, item):
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


def _initial_points(window):
    """Return the points of a grid, every other row shifted by half a mesh."""
    (left, right), (low, high) = window
    columns, rows = GRID
    x, y = np.meshgrid((np.arange(columns) + 0.25) / columns, (np.arange(rows) + 0.5) / rows)
    x[::2] += 0.5 / columns
    return left + (right - left) * x.ravel(), low + (high - low) * y.ravel()


def _lines(axes, count):
    from matplotlib.collections import LineCollection

    lines = LineCollection(np.zeros((count, 2, 2)), colors="#9A9A9A", linewidths=1.1, zorder=1)
    axes.add_collection(lines, autolim=False)
    return lines


def _short_lines(field, initial_points, window):
    """Return pieces of trajectories of the same length in the picture, shape (N, steps + 1, 2).

    They are integrated by the midpoint rule over the arc length.
    """
    size = (window[:, 1] - window[:, 0])[:, None]

    def direction(points):
        with np.errstate(all="ignore"):
            rate = (
                np.array(
                    [np.broadcast_to(part, points[0].shape) for part in field(*points)],
                    dtype=float,
                )
                / size
            )
            rate = rate / (np.hypot(*rate) + 1e-3)
        return np.where(np.isfinite(rate).all(axis=0), rate, 0) * size

    points = np.array(initial_points, dtype=float)
    paths = [points]
    for _ in range(STEPS):
        half = points + STEP / 2 * direction(points)
        points = points + STEP * direction(half)
        paths.append(points)
    return np.array(paths).transpose(2, 0, 1)


def _equilibria(field, jacobian, initial_points, numbers, window):
    """Return [(point, "stable", "unstable" or "saddle")] by Newton's method from many points.

    Centres and points outside the window are left out.
    """
    points = np.array(initial_points, dtype=float)
    with np.errstate(all="ignore"):
        for _ in range(14):
            f, (a, b, c, d) = (_values(function, points, numbers) for function in (field, jacobian))
            determinant = a * d - b * c
            points = points - np.array([d * f[0] - b * f[1], a * f[1] - c * f[0]]) / determinant
        f, (a, b, c, d) = (_values(function, points, numbers) for function in (field, jacobian))
        size = window[:, 1] - window[:, 0]
        converged = (np.hypot(*f) < 1e-9) & (
            (points.T >= window[:, 0]) & (points.T <= window[:, 1])
        ).all(axis=1)
    kinds = {}
    for k in np.flatnonzero(converged):
        rounded = tuple(np.round(points[:, k] / size, 4))
        trace, determinant = a[k] + d[k], a[k] * d[k] - b[k] * c[k]
        if determinant < -1e-9:
            kinds[rounded] = points[:, k], "saddle"
        elif determinant > 1e-9 and abs(trace) > 1e-9:
            kinds[rounded] = points[:, k], "stable" if trace < 0 else "unstable"
    return list(kinds.values())


def _values(function, points, numbers):
    return [
        np.broadcast_to(np.asarray(part, dtype=float), points[0].shape)
        for part in function(*points, *numbers)
    ]


def _motion(scalar_field, point, numbers, window):
    """Return the motion through a point, forwards and backwards, as far as it is in the picture."""
    from scipy.integrate import ODEintWarning, odeint

    (left, right), (low, high) = window
    width, height = right - left, high - low

    def rate(state, _, sign):
        x, y = state
        if not (
            left - width / 2 < x < right + width / 2 and low - height / 2 < y < high + height / 2
        ):
            return 0.0, 0.0
        try:
            u, v = scalar_field(x, y, *numbers)
        except (ArithmeticError, ValueError):  # outside the domain of the field
            return 0.0, 0.0
        speed = sign * (np.hypot(u / width, v / height) + 1e-3)
        return u / speed, v / speed

    def integrate(sign):
        length = np.linspace(0, 12, POINTS)
        with warnings.catch_warnings():
            # where the equation is too stiff, the line ends
            warnings.simplefilter("ignore", ODEintWarning)
            path, information = odeint(
                rate, point, length, args=(sign,), rtol=1e-6, atol=1e-8, full_output=True
            )
        accurate = np.append(
            True, (information["tcur"] >= length[1:]) & np.isfinite(path[1:]).all(axis=1)
        )
        return path[: len(accurate) if accurate.all() else np.argmin(accurate)]

    return np.concatenate([integrate(-1)[::-1], integrate(1)]).T
