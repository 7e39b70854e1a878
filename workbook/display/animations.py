"""Animations on a page: a computed trajectory that the reader plays back.

An `Animation` is a row of panels with one clock. It is an SVG picture with its data beside it, to
which the site's script adds a button and a slider. Without the script, on paper and in other
notebooks, the frame `still` is shown.

>>> import numpy as np
>>> t = np.linspace(0, 6, 61)
>>> animation = Animation(t, "A point that runs along a circle.")
>>> plane = animation.panel((-1.5, 1.5), (-1.5, 1.5), "x", "y")
>>> plane.trail(np.cos(t), np.sin(t))
>>> plane.dot(np.cos(t), np.sin(t))
>>> animation
Animation of 61 frames from t = 0 to 6: A point that runs along a circle.
"""

import html
import json

import numpy as np

__all__ = ["Animation"]

#: Side of a panel and margin for the names of its axes, in user units of the SVG.
SIZE, MARGIN = 240, 34


class Animation:
    """A row of panels that move together.

    Parameters
    ----------
    times : array_like, shape (N,)
        Increasing times of the frames, N >= 2.
    description : str
        A sentence for readers who cannot see the pictures.
    speed : float
        Units of `times` that are played in a second.
    still : int
        Index of the frame that is shown before it is played.

    Raises
    ------
    ValueError
        If the times do not increase or the speed is not positive.

    Notes
    -----
    There is no MATLAB counterpart; near are ``animatedline`` and ``VideoWriter``.
    """

    def __init__(self, times, description, speed=1.0, still=0):
        self.times = np.asarray(times, dtype=float)
        if self.times.ndim != 1 or len(self.times) < 2 or not (np.diff(self.times) > 0).all():
            raise ValueError("times: expected at least two, increasing")
        if not speed > 0:
            raise ValueError(f"speed: expected a positive number, got {speed}")
        self.description, self.speed = description, float(speed)
        self.still, self.panels = int(still) % len(self.times), []

    def panel(self, x_range, y_range, x="", y=""):
        """Add a panel to the right of the others.

        Parameters
        ----------
        x_range, y_range : (float, float)
            Ranges (low, high) of the axes.
        x, y : str
            Names of the axes, as plain text.

        Returns
        -------
        Panel
            The panel, to draw on.

        Raises
        ------
        ValueError
            If a range is empty.
        """
        panel = Panel(self, x_range, y_range, x, y)
        self.panels.append(panel)
        return panel

    def __repr__(self):
        start, *_, end = self.times
        return (
            f"Animation of {len(self.times)} frames from t = {start:g} to {end:g}: "
            f"{self.description}"
        )

    def _repr_html_(self):
        moving = [part for panel in self.panels for part in panel.moving]
        data = {
            "times": _short(self.times),
            "speed": self.speed,
            "still": self.still,
            "parts": [{"kind": kind, "points": points} for kind, points in moving],
        }
        # side by side where there is room, below one another on a phone
        panels = "".join(
            f'<svg viewBox="0 0 {SIZE + MARGIN + 8} {SIZE + MARGIN + 6}" style="flex: 1 1 160px; '
            f'max-width: 340px; fill: none; stroke: currentColor"><g transform="translate({MARGIN} '
            '6)">'
            f"{panel.svg()}</g></svg>"
            for panel in self.panels
        )
        return (
            '<div class="animation" '
            f'data-animation="{html.escape(json.dumps(data, separators=(",", ":")))}">'
            f'<div role="img" aria-label="{html.escape(self.description)}" style="display: flex; '
            'flex-wrap: wrap">'
            f"{panels}</div></div>"
        )

    def _repr_svg_(self):
        width, height = SIZE + MARGIN + 8, SIZE + MARGIN + 6
        panels = "".join(
            f'<g transform="translate({MARGIN + k * width} 6)">{panel.svg()}</g>'
            for k, panel in enumerate(self.panels)
        )
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * len(self.panels)}" '
            f'height="{height}" '
            f'fill="none" stroke="black" color="black">{panels}</svg>'
        )


class Panel:
    """A panel of an `Animation`, made by `Animation.panel`: fixed curves and moving parts.

    Coordinates are those of the axes. Methods raise ValueError for points that are not finite and
    for arrays with another length than the number N of frames.
    """

    def __init__(self, animation, x_range, y_range, x, y):
        self._animation, self._x, self._y = (
            animation,
            tuple(map(float, x_range)),
            tuple(map(float, y_range)),
        )
        for low, high in (self._x, self._y):
            if not low < high:
                raise ValueError(f"range: expected (low, high) with low < high, got {(low, high)}")
        self._axis_names, self._fixed, self.moving = (x, y), [], []

    def curve(self, x, y, dashed=False, faint=False):
        """Add a fixed line.

        Parameters
        ----------
        x, y : array_like, shape (M,)
            Its points.
        dashed, faint : bool
            Style of the line.
        """
        style = ('stroke-dasharray="5 4" ' if dashed else "") + ('opacity="0.45" ' if faint else "")
        points = self._to_svg(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
        self._fixed.append(f'<polyline {style}points="{_text(points)}"/>')

    def dot(self, x, y):
        """Add a moving point.

        Parameters
        ----------
        x, y : float or array_like, shape (N,)
            Its coordinates in each frame.
        """
        self._move("dot", self._frames(x, y))

    def rod(self, x, y, to_x, to_y):
        """Add a moving straight line.

        Parameters
        ----------
        x, y, to_x, to_y : float or array_like, shape (N,)
            Coordinates of its ends in each frame.
        """
        self._move("rod", np.hstack([self._frames(x, y), self._frames(to_x, to_y)]))

    def trail(self, x, y):
        """Add the path of a moving point up to the current frame.

        Parameters
        ----------
        x, y : float or array_like, shape (N,)
            Coordinates of the point in each frame.
        """
        self._move("trail", self._frames(x, y))

    def svg(self):
        """Return the SVG elements of the panel in the frame `still`."""
        still = self._animation.still
        parts = "".join(_part(kind, points, still) for kind, points in self.moving)
        x, y = (html.escape(name) for name in self._axis_names)
        origin = self._to_svg(np.zeros(1), np.zeros(1))[0]
        axes = "".join(
            f'<line {ends} opacity="0.3"/>'
            for inside, ends in (
                (
                    0 <= origin[0] <= SIZE,
                    f'x1="{origin[0]:g}" x2="{origin[0]:g}" y1="0" y2="{SIZE}"',
                ),
                (
                    0 <= origin[1] <= SIZE,
                    f'x1="0" x2="{SIZE}" y1="{origin[1]:g}" y2="{origin[1]:g}"',
                ),
            )
            if inside
        )
        text_style = 'stroke="none" fill="currentColor" font-size="13"'
        corners = "".join(
            f'<text {text_style} x="{at}" y="{SIZE + 15}" text-anchor="{end}">{value:g}</text>'
            for at, end, value in ((0, "start", self._x[0]), (SIZE, "end", self._x[1]))
        )
        corners += "".join(
            f'<text {text_style} x="-4" y="{at}" text-anchor="end">{value:g}</text>'
            for at, value in ((SIZE, self._y[0]), (11, self._y[1]))
        )
        return (
            f'<rect width="{SIZE}" height="{SIZE}" opacity="0.4"/>{axes}{corners}'
            f'<text {text_style} font-style="italic" x="{SIZE / 2}" y="{SIZE + 16}" '
            f'text-anchor="middle">{x}</text>'
            f'<text {text_style} font-style="italic" x="6" y="14">{y}</text>'
            # an SVG of its own clips the curves at the border
            f'<svg width="{SIZE}" height="{SIZE}">{"".join(self._fixed)}</svg><g '
            f'stroke-width="2.2">{parts}</g>'
        )

    def _frames(self, x, y):
        n = len(self._animation.times)
        x, y = (np.asarray(values, dtype=float) for values in (x, y))
        for values in (x, y):
            if values.ndim and values.shape != (n,):
                raise ValueError(
                    f"expected a number or one for each of the {n} frames, got shape {values.shape}"
                )
        return self._to_svg(np.broadcast_to(x, n), np.broadcast_to(y, n))

    def _to_svg(self, x, y):
        """Return points in units of the SVG, rounded to tenths, shape (M, 2)."""
        if not (np.isfinite(x).all() and np.isfinite(y).all()):
            raise ValueError("points: expected finite numbers")
        (left, right), (low, high) = self._x, self._y
        return np.column_stack(
            [(x - left) / (right - left) * SIZE, (high - y) / (high - low) * SIZE]
        ).round(1)

    def _move(self, kind, points):
        self.moving.append((kind, _short(points.ravel())))


def _part(kind, points, still):
    if kind == "dot":
        x, y = points[2 * still : 2 * still + 2]
        return f'<circle class="moving" r="6" fill="currentColor" cx="{x}" cy="{y}"/>'
    if kind == "rod":
        x, y, to_x, to_y = points[4 * still : 4 * still + 4]
        return f'<line class="moving" x1="{x}" y1="{y}" x2="{to_x}" y2="{to_y}"/>'
    pairs = [f"{x},{y}" for x, y in zip(points[: 2 * still + 2 : 2], points[1 : 2 * still + 2 : 2])]
    return f'<polyline class="moving" points="{" ".join(pairs)}"/>'


def _text(points):
    return " ".join(f"{x:g},{y:g}" for x, y in points)


def _short(values):
    """Return plain numbers with at most three decimals."""
    return [int(value) if value == int(value) else round(float(value), 3) for value in values]
