"""Drawings of bodies for the statements of problems: rods, masses, springs, carts, with their axes,
angles and symbols.

A drawing is a sheet whose unit is an inch, x to the right and y upwards: letters, hinges and arrows
have the same size in all drawings. Its methods each put one thing on it; what comes later lies
above. Points are pairs of numbers, directions are degrees, counterclockwise from the x axis; a text
between dollars is a formula. Forces are thick arrows, velocities have an open head, accelerations
two heads, axes are thin: so the drawing reads in black and white too. A drawing on the last line of
a cell shows itself.

>>> d = Drawing((-1, 1), (-1.6, 0.3))
>>> d.ground((-0.5, 0), (0.5, 0), above=True)
>>> bob = along((0, 0), 1.2, -60)
>>> d.rod((0, 0), bob)
>>> d.angle((0, 0), -90, -60, 0.7, r"$\\varphi$")
"""

import io

import numpy as np

from trajlib.plotting import BLACK, BLUE, GREY, RED

LETTERS, WORDS = 13, 11  # points
THIN, LINE, THICK = 0.9, 1.5, 2.6
BODY = "#DCE6EE"


def along(start, length, direction):
    """The point at a distance from another one, in a direction."""
    turn = np.deg2rad(direction)
    return start[0] + length * np.cos(turn), start[1] + length * np.sin(turn)


class Drawing:
    """A sheet between `x_range` and `y_range`, in inches."""

    def __init__(self, x_range, y_range):
        from matplotlib.figure import Figure

        size = x_range[1] - x_range[0], y_range[1] - y_range[0]
        self._figure = Figure(figsize=size, facecolor="white")
        self._ax = self._figure.add_axes((0, 0, 1, 1), xlim=x_range, ylim=y_range)
        self._ax.set_axis_off()
        self._layer = 1

    def _repr_svg_(self):
        return self._saved("svg", metadata={"Date": None, "Creator": None}).decode()

    def png(self, dpi=120):
        """The drawing as the bytes of a PNG file."""
        return self._saved("png", dpi=dpi, metadata={"Software": None})

    def _saved(self, form, **how):
        import matplotlib

        file = io.BytesIO()
        # the same drawing is the same file
        with matplotlib.rc_context({"svg.hashsalt": "workbook"}):
            self._figure.savefig(file, format=form, **how)
        return file.getvalue()

    # Lines and letters

    def line(self, *points, dashed=False, width=LINE, colour=BLACK):
        """A broken line through the points."""
        self._ax.plot(
            *zip(*points),
            color=colour,
            linewidth=width,
            linestyle=(0, (5, 3)) if dashed else "-",
            solid_capstyle="round",
            solid_joinstyle="round",
            zorder=self._above(),
        )

    def reference(self, start, end):
        """A thin dashed line, from which something is measured."""
        self.line(start, end, dashed=True, width=THIN)

    def arc(self, centre, radius, start=0, end=360, dashed=False, width=THIN):
        """A piece of a circle between two directions."""
        self.line(*_arc(centre, radius, start, end), dashed=dashed, width=width)

    def label(self, point, text, side=90, gap=0.1):
        """A text beside a point: above it (`side` 90), to its right (0), below it (-90), ..."""
        towards = along((0, 0), 1, side)
        self._ax.text(
            *along(point, gap, side),
            text,
            fontsize=LETTERS if "$" in text else WORDS,
            math_fontfamily="cm",
            ha=_aligned(towards[0], "right", "center", "left"),
            va=_aligned(towards[1], "top", "center", "bottom"),
            zorder=self._above() + 1000,
        )

    # Bodies

    def rod(self, start, end):
        self.line(start, end, width=THICK)

    def point(self, centre):
        """A dot without a size of its own: an origin, a point mass far away."""
        self.mass(centre, 0.035)

    def mass(self, centre, radius=0.11):
        self._patch(_arc(centre, radius, 0, 360), BLACK)

    def disc(self, centre, radius):
        self._patch(_arc(centre, radius, 0, 360), BODY)

    def hinge(self, centre):
        self._patch(_arc(centre, 0.055, 0, 360), "white")

    def shape(self, points, place=(0, 0), turn=0, size=1):
        """A body by its outline, which is drawn about the origin: enlarged, then turned, then
        brought to its place."""
        c, s = np.cos(np.deg2rad(turn)), np.sin(np.deg2rad(turn))
        self._patch(
            [
                (place[0] + size * (c * x - s * y), place[1] + size * (s * x + c * y))
                for x, y in points
            ],
            BODY,
        )

    def box(self, centre, width, height, turn=0):
        self.shape(
            [(x * width / 2, y * height / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))],
            centre,
            turn,
        )

    def cart(self, x, floor, width=1.1, height=0.36):
        """A cart over `x` whose wheels run at the height `floor`; returns the middle of its upper
        side."""
        radius = 0.12
        self.box((x, floor + 2 * radius + height / 2), width, height)
        for wheel in (x - 0.3 * width, x + 0.3 * width):
            self._patch(_arc((wheel, floor + radius), radius, 0, 360), "white")
            self.point((wheel, floor + radius))
        return x, floor + 2 * radius + height

    def ground(self, start, end, above=False):
        """A fixed line, hatched on its right-hand side as one goes from start to end; on its left
        if `above`."""
        onwards = _direction(start, end)
        for k in np.arange(0.12, np.hypot(*np.subtract(end, start)) + 1e-9, 0.12):
            root = along(start, k, onwards)
            self.line(root, along(root, 0.14, onwards + (135 if above else -135)), width=THIN)
        self.line(start, end)

    def spring(self, start, end, coils=6, depth=0.11):
        sides = [0, *[depth * (-1) ** k for k in range(2 * coils - 1)], 0]
        self._between(
            start, end, [(0, 0), *zip(np.linspace(0.15, 0.85, len(sides)), sides), (1, 0)]
        )

    def damper(self, start, end, depth=0.13):
        self._between(start, end, [(0, 0), (0.38, 0)])
        self._between(start, end, [(0.66, depth), (0.38, depth), (0.38, -depth), (0.66, -depth)])
        self._between(start, end, [(0.54, 0.8 * depth), (0.54, -0.8 * depth)])
        self._between(start, end, [(0.54, 0), (1, 0)])

    # What is measured, and what acts

    def axis(self, start, end, name="", side=None):
        self._arrow(start, end, name, side, "-|>", THIN, BLACK, 11)

    def towards_viewer(self, point, name, side=45):
        """An axis that stands upright on the sheet: the point of its arrow."""
        self._patch(_arc(point, 0.09, 0, 360), "white")
        self.point(point)
        self.label(point, name, side, 0.13)

    def velocity(self, start, end, name="", side=None):
        self._arrow(start, end, name, side, "->", LINE, BLUE, 14)

    def acceleration(self, start, end, name="", side=None):
        self._arrow(start, end, "", None, "-|>", LINE, RED, 14)
        self._arrow(
            start, along(end, -0.12, _direction(start, end)), "", None, "-|>", LINE, RED, 14
        )
        self.label(end, name, _direction(start, end) if side is None else side, 0.06)

    def force(self, start, end, name="", side=None):
        self._arrow(start, end, name, side, "-|>", THICK, RED, 16)

    def angle(self, vertex, start, end, radius, name, side=None):
        """An angle counted from the direction `start` to the direction `end`, where its arrow has
        its head."""
        arc = _arc(vertex, radius, start, end)
        self.line(*arc[:-4], width=THIN)
        self._arrow(arc[-5], arc[-1], "", None, "-|>", THIN, BLACK, 10)
        middle = (start + end) / 2
        self.label(along(vertex, radius, middle), name, middle if side is None else side, 0.06)

    def dimension(self, start, end, name, side=90, offset=0):
        """A length between two points, drawn at a distance `offset` beside them (to the left of the
        way)."""
        across = _direction(start, end) + 90
        ends = [along(point, offset, across) for point in (start, end)]
        if offset:
            for point, reached in zip((start, end), ends):
                self.line(
                    point, along(reached, 0.06 * np.sign(offset), across), width=0.5, colour=GREY
                )
        self._arrow(*ends, "", None, "<|-|>", THIN, BLACK, 9)
        self.label(np.mean(ends, axis=0), name, side, 0.07)

    def _arrow(self, start, end, name, side, head, width, colour, size):
        self._ax.annotate(
            "",
            end,
            start,
            zorder=self._above(),
            arrowprops={
                "arrowstyle": head,
                "linewidth": width,
                "color": colour,
                "shrinkA": 0,
                "shrinkB": 0,
                "mutation_scale": size,
                "joinstyle": "miter",
            },
        )
        self.label(end, name, _direction(start, end) if side is None else side, 0.06)

    def _between(self, start, end, points):
        """A line given by pairs (part of the way from start to end, inches to its left)."""
        (x, y), way = start, np.subtract(end, start)
        left = np.array([-way[1], way[0]]) / np.hypot(*way)
        self.line(
            *[(x + s * way[0] + d * left[0], y + s * way[1] + d * left[1]) for s, d in points],
            width=LINE,
        )

    def _patch(self, points, colour):
        from matplotlib.patches import Polygon

        self._ax.add_patch(
            Polygon(
                points,
                closed=True,
                facecolor=colour,
                edgecolor=BLACK,
                linewidth=LINE,
                joinstyle="round",
                zorder=self._above(),
            )
        )

    def _above(self):
        self._layer += 1
        return self._layer


def _arc(centre, radius, start, end):
    turns = np.linspace(start, end, max(12, int(abs(end - start) / 4)) + 1)
    return [along(centre, radius, turn) for turn in turns]


def _direction(start, end):
    return np.degrees(np.arctan2(end[1] - start[1], end[0] - start[0]))


def _aligned(component, negative, none, positive):
    return none if abs(component) < 0.4 else positive if component > 0 else negative
