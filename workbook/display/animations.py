"""Motions that move on a page: a trajectory that was computed, played back by the reader.

A `Animation` is a row of pictures with one clock. It is drawn as SVG, with its data beside it; the
site's script moves it and gives it its button and its slider. Without the script, on paper and in
other notebooks, it stands still where `still` says; where not even HTML can be shown, that one
picture is there as SVG.

>>> import numpy as np
>>> t = np.linspace(0, 6, 61)
>>> motion = Animation(t, "A point that runs along a circle.")
>>> plane = motion.panel((-1.5, 1.5), (-1.5, 1.5), "x", "y")
>>> plane.trail(np.cos(t), np.sin(t))
>>> plane.dot(np.cos(t), np.sin(t))
>>> motion
Animation of 61 frames from t = 0 to 6: A point that runs along a circle.
"""

import html
import json

import numpy as np

__all__ = ["Animation"]

#: The side of a panel, in units of the drawing, and the room around it for names.
SIZE, ROOM = 240, 34


class Animation:
    """Pictures that move together (no MATLAB word; near: animatedline, VideoWriter).

    `times`: the increasing times of the frames, played in seconds of this clock divided by `speed`.
    `words`: a sentence for who cannot see the pictures. `still`: the number of the frame that is
    shown before it moves.
    """

    def __init__(self, times, words, speed=1.0, still=0):
        self.times = np.asarray(times, dtype=float)
        if self.times.ndim != 1 or len(self.times) < 2 or not (np.diff(self.times) > 0).all():
            raise ValueError("times: expected at least two, increasing")
        if not speed > 0:
            raise ValueError(f"speed: expected a positive number, got {speed}")
        self.words, self.speed, self.still, self.panels = (
            words,
            float(speed),
            int(still) % len(self.times),
            [],
        )

    def panel(self, x_range, y_range, x="", y=""):
        """A new picture to the right of the others, over pairs (low, high); `x` and `y` name its
        axes."""
        panel = Panel(self, x_range, y_range, x, y)
        self.panels.append(panel)
        return panel

    def __repr__(self):
        return f"Animation of {len(self.times)} frames from t = {self.times[0]:g} to {self.times[-1]:g}: {self.words}"

    def _repr_html_(self):
        moving = [part for panel in self.panels for part in panel.moving]
        data = {
            "times": _short(self.times),
            "speed": self.speed,
            "still": self.still,
            "parts": [{"kind": kind, "points": points} for kind, points in moving],
        }
        # Side by side where there is room, below one another on a phone.
        drawn = "".join(
            f'<svg viewBox="0 0 {SIZE + ROOM + 8} {SIZE + ROOM + 6}" style="flex: 1 1 160px; '
            f'max-width: 340px; fill: none; stroke: currentColor"><g transform="translate({ROOM} '
            '6)">'
            f"{panel.svg()}</g></svg>"
            for panel in self.panels
        )
        return (
            '<div class="motion" '
            f'data-motion="{html.escape(json.dumps(data, separators=(",", ":")))}">'
            f'<div role="img" aria-label="{html.escape(self.words)}" style="display: flex; '
            'flex-wrap: wrap">'
            f"{drawn}</div></div>"
        )

    def _repr_svg_(self):
        width, height = SIZE + ROOM + 8, SIZE + ROOM + 6
        drawn = "".join(
            f'<g transform="translate({ROOM + k * width} 6)">{panel.svg()}</g>'
            for k, panel in enumerate(self.panels)
        )
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * len(self.panels)}" '
            f'height="{height}" '
            f'fill="none" stroke="black" color="black">{drawn}</svg>'
        )


class Panel:
    """One picture of a `Animation`. What stands is a `curve`; `dot`, `rod` and `trail` move."""

    def __init__(self, motion, x_range, y_range, x, y):
        self._motion, self._x, self._y = (
            motion,
            tuple(map(float, x_range)),
            tuple(map(float, y_range)),
        )
        for low, high in (self._x, self._y):
            if not low < high:
                raise ValueError(f"range: expected (low, high) with low < high, got {(low, high)}")
        self._names, self._standing, self.moving = (x, y), [], []

    def curve(self, x, y, dashed=False, faint=False):
        """A line that stands, through points x, y; `dashed` and `faint` tell it from others."""
        style = ('stroke-dasharray="5 4" ' if dashed else "") + ('opacity="0.45" ' if faint else "")
        points = self._placed(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
        self._standing.append(f'<polyline {style}points="{_text(points)}"/>')

    def dot(self, x, y):
        """A point, at x, y for each frame."""
        self._move("dot", self._frames(x, y))

    def rod(self, x, y, to_x, to_y):
        """A straight line from x, y to to_x, to_y, numbers or an array of one for each frame."""
        self._move("rod", np.hstack([self._frames(x, y), self._frames(to_x, to_y)]))

    def trail(self, x, y):
        """The way so far of a point that is at x, y."""
        self._move("trail", self._frames(x, y))

    def svg(self):
        """The drawing, with what moves where it is in the frame `still`."""
        still = self._motion.still
        parts = "".join(_part(kind, points, still) for kind, points in self.moving)
        x, y = (html.escape(name) for name in self._names)
        origin = self._placed(np.zeros(1), np.zeros(1))[0]
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
        words = 'stroke="none" fill="currentColor" font-size="13"'
        corners = "".join(
            f'<text {words} x="{at}" y="{SIZE + 15}" text-anchor="{end}">{value:g}</text>'
            for at, end, value in ((0, "start", self._x[0]), (SIZE, "end", self._x[1]))
        )
        corners += "".join(
            f'<text {words} x="-4" y="{at}" text-anchor="end">{value:g}</text>'
            for at, value in ((SIZE, self._y[0]), (11, self._y[1]))
        )
        return (
            f'<rect width="{SIZE}" height="{SIZE}" opacity="0.4"/>{axes}{corners}'
            f'<text {words} font-style="italic" x="{SIZE / 2}" y="{SIZE + 16}" '
            f'text-anchor="middle">{x}</text>'
            f'<text {words} font-style="italic" x="6" y="14">{y}</text>'
            # within a drawing of its own a curve ends at the border
            f'<svg width="{SIZE}" height="{SIZE}">{"".join(self._standing)}</svg><g '
            f'stroke-width="2.2">{parts}</g>'
        )

    def _frames(self, x, y):
        n = len(self._motion.times)
        x, y = (np.asarray(values, dtype=float) for values in (x, y))
        for values in (x, y):
            if values.ndim and values.shape != (n,):
                raise ValueError(
                    f"expected a number or one for each of the {n} frames, got shape {values.shape}"
                )
        return self._placed(np.broadcast_to(x, n), np.broadcast_to(y, n))

    def _placed(self, x, y):
        """Points of the drawing, one a row, in a tenth of its units."""
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
    """Plain numbers with no more digits than are seen."""
    return [int(value) if value == int(value) else round(float(value), 3) for value in values]
