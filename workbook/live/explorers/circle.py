"""Time-optimal synthesis of problem 5.8: the oscillator to a circle whose radius is changed."""

import numpy as np

from trajlib import plotting
from workbook.live.explorers.blitting import BlittedFigure
from workbook.live.explorers.explorer import Explorer, slider

WINDOW, HEIGHT, GRID = 6.0, 3.6, (220, 132)
#: Time step, and the largest number of steps.
STEP, MAX_STEPS = 0.05, 420


def circle_synthesis():
    """Show the oscillator to the circle of radius R in least time; a click draws a motion.

    R is between 0.3 and 4; the region with u = 1 is shaded. Inside the circle there is a dispersal
    curve for R <= 2; for larger R two semicircles are crossed (solution of 5.8). The figure uses
    the control laws of the solution, since computing a synthesis takes seconds.
    """
    figure = BlittedFigure(1, height=6.2)
    (plane,) = figure.axes
    plane.set(
        xlim=(-WINDOW, WINDOW),
        ylim=(-HEIGHT, HEIGHT),
        aspect="equal",
        xlabel="$x_1$",
        ylabel="$x_2$",
        title="5.8: the oscillator to a circle; shaded: $u = 1$",
    )
    x, y = np.meshgrid(np.linspace(-WINDOW, WINDOW, GRID[0]), np.linspace(-HEIGHT, HEIGHT, GRID[1]))
    colours = np.array([[255, 255, 255], [205, 228, 243]], dtype=np.uint8)
    image = figure.animate(
        plane.imshow(
            colours[np.zeros(x.shape, int)],
            extent=(-WINDOW, WINDOW, -HEIGHT, HEIGHT),
            origin="lower",
            interpolation="nearest",
        )
    )
    lines = [figure.line(plane, "-", color=plotting.BLACK, linewidth=1) for _ in range(2)]
    circle = figure.line(plane, "-", color=plotting.ORANGE, linewidth=3)
    clicked_path = figure.line(plane, "-", color=plotting.RED, linewidth=2.6)
    clicked_point = figure.line(plane, "o", color=plotting.RED, markersize=8)
    angles = np.linspace(0, 2 * np.pi, 240)
    outside = [complex(a, b) for a in (-5.6, -3.4, -1.1, 1.1, 3.4, 5.6) for b in (-3.2, 3.2)]
    clicked = [complex(-4, 2)]

    def draw(R):
        image.set_data(colours[(control_law(x, y, R) > 0).astype(int)])
        circle.set_data(R * np.cos(angles), R * np.sin(angles))
        initial_states = np.array(
            outside
            + [
                0.93 * R * np.exp(1j * angle) * fraction
                for fraction in (0.3, 0.75)
                for angle in np.arange(0.2, 6.2, 0.9)
            ]
            + clicked
        )
        paths, times = trajectories(initial_states, R)
        for line, columns in zip(lines, (paths[:, : len(outside)], paths[:, len(outside) : -1])):
            line.set_data(*_as_one_line(columns))
        clicked_path.set_data(paths[:, -1].real, paths[:, -1].imag)
        clicked_point.set_data([clicked[0].real], [clicked[0].imag])
        return f"from the red point: {times[-1]:.2f} to the circle"

    def on_stroke(axes, points):
        clicked[0] = complex(*points[-1])

    return Explorer(figure, {"R": slider("R", 0.3, 4.0, 1.0)}, draw, on_stroke)


def control_law(x1, x2, R):
    """Return the optimal control at points (arrays), outside and inside the circle of radius R.

    On the switching curves it has any value.
    """
    with np.errstate(all="ignore"):
        r = np.hypot(x1, x2)
        semicircle = np.sqrt(1 - ((np.abs(x1) - R) % 2 - 1) ** 2)
        outside = np.where(np.abs(x1) > R, -np.sign(x2 + np.sign(x1) * semicircle), -np.sign(x2))
        rho = R - 2 * np.floor((R - r) / 2)
        gain = (rho**2 - r**2) / 2
        crossed = np.sqrt(1 - (np.abs(x1) - rho + 1) ** 2)
        inside = np.where(
            rho <= 2,
            np.sign(x2 - x1 * np.sqrt(gain / (2 - gain))),
            np.where(np.abs(x1) > rho - 2, np.sign(x2 - np.sign(x1) * crossed), np.sign(x2)),
        )
    return np.where(r > R, outside, inside)


def trajectories(initial_states, R):
    """Return the trajectories under the control law up to the circle, and their times.

    Under a constant control the state turns about (u, 0), so that a step is exact between switching
    times.

    Parameters
    ----------
    initial_states : ndarray of complex, shape (N,)
        States x1 + i x2.
    R : float
        Radius of the circle.

    Returns
    -------
    paths : ndarray of complex, shape (steps, N)
        States at multiples of `STEP`, nan after the circle.
    times : ndarray, shape (N,)
        Times to the circle.
    """
    rotation = np.exp(-1j * STEP)
    outside, state = np.abs(initial_states) > R, np.array(initial_states)
    paths, arrived, times = [state], np.zeros(len(state), bool), np.full(len(state), np.nan)
    for step in range(MAX_STEPS):
        control = control_law(state.real, state.imag, R)
        control = np.where(np.isfinite(control) & (control != 0), control, 1)
        state = np.where(arrived, np.nan, control + (state - control) * rotation)
        paths.append(state)
        arrives = ~arrived & ((np.abs(state) > R) != outside)
        times[arrives] = (step + 1) * STEP
        arrived |= arrives
        if arrived.all():
            break
    return np.array(paths), times


def _as_one_line(paths):
    """Return the coordinates of all columns as one line with gaps."""
    line = np.vstack([paths, np.full((1, paths.shape[1]), np.nan)]).T.ravel()
    return line.real, line.imag
