"""The synthesis of problem 5.8 while the circle grows: the oscillator, from outside and from inside
to its border."""

import numpy as np

from trajlib import plotting
from workbook.live.explorers.stage import Explorer, Stage, slider

WINDOW, HEIGHT, GRID = 6.0, 3.6, (220, 132)
STEP, MOST = 0.05, 420


def circle_synthesis():
    """The oscillator to the circle of radius R in the least time, for R from 0.3 to 4; a click
    draws its motion.

    Shaded where u = 1. Inside there is a dispersal curve up to R = 2, from where on two semicircles
    are crossed; see the solution of 5.8. The picture is drawn by the laws found there, since
    computing a synthesis takes seconds.
    """
    stage = Stage(1, height=6.2)
    (plane,) = stage.axes
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
    image = stage.moving(
        plane.imshow(
            colours[np.zeros(x.shape, int)],
            extent=(-WINDOW, WINDOW, -HEIGHT, HEIGHT),
            origin="lower",
            interpolation="nearest",
        )
    )
    ways = [stage.line(plane, "-", color=plotting.BLACK, linewidth=1) for _ in range(2)]
    border = stage.line(plane, "-", color=plotting.ORANGE, linewidth=3)
    chosen = stage.line(plane, "-", color=plotting.RED, linewidth=2.6)
    begin = stage.line(plane, "o", color=plotting.RED, markersize=8)
    turn = np.linspace(0, 2 * np.pi, 240)
    far = [complex(a, b) for a in (-5.6, -3.4, -1.1, 1.1, 3.4, 5.6) for b in (-3.2, 3.2)]
    clicked = [complex(-4, 2)]

    def draw(R):
        image.set_data(colours[(law(x, y, R) > 0).astype(int)])
        border.set_data(R * np.cos(turn), R * np.sin(turn))
        starts = np.array(
            far
            + [
                0.93 * R * np.exp(1j * angle) * part
                for part in (0.3, 0.75)
                for angle in np.arange(0.2, 6.2, 0.9)
            ]
            + clicked
        )
        paths, times = followed(starts, R)
        for way, some in zip(ways, (paths[:, : len(far)], paths[:, len(far) : -1])):
            way.set_data(*_joined(some))
        chosen.set_data(paths[:, -1].real, paths[:, -1].imag)
        begin.set_data([clicked[0].real], [clicked[0].imag])
        return f"from the red point: {times[-1]:.2f} to the circle"

    def pointed(axes, points):
        clicked[0] = complex(*points[-1])

    return Explorer(stage, {"R": slider("R", 0.3, 4.0, 1.0)}, draw, pointed)


def law(x1, x2, R):
    """The control of the solution of 5.8 at points (arrays), from outside and from inside; on its
    curves any."""
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


def followed(starts, R):
    """(paths, times): states x1 + i x2 under the law, a column for each start, up to the circle;
    nan after it.

    Under a constant control the state turns about (u, 0), so that a step is exact as long as the
    control stays.
    """
    turned = np.exp(-1j * STEP)
    outside, state = np.abs(starts) > R, np.array(starts)
    paths, arrived, times = [state], np.zeros(len(state), bool), np.full(len(state), np.nan)
    for step in range(MOST):
        control = law(state.real, state.imag, R)
        control = np.where(np.isfinite(control) & (control != 0), control, 1)
        state = np.where(arrived, np.nan, control + (state - control) * turned)
        paths.append(state)
        now = ~arrived & ((np.abs(state) > R) != outside)
        times[now] = (step + 1) * STEP
        arrived |= now
        if arrived.all():
            break
    return np.array(paths), times


def _joined(paths):
    """All columns as one line, with gaps."""
    line = np.vstack([paths, np.full((1, paths.shape[1]), np.nan)]).T.ravel()
    return line.real, line.imag
