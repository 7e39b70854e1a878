"""A sheet to draw on: lines, arcs, arrows and letters in inches.

Each shape is above the earlier ones. Points are pairs of numbers in inches; directions are angles
in degrees, counterclockwise from the x axis; formulas stand between dollars.
"""

import io

import numpy as np

from trajlib.plotting import BLACK

#: Font sizes of formulas and of words, in points.
FORMULA_SIZE, TEXT_SIZE = 13, 11
#: Line widths in points.
THIN, LINE, THICK = 0.9, 1.5, 2.6


def along(start, length, direction):
    """Return the point at a distance from another one, in a direction.

    Parameters
    ----------
    start : (float, float)
        The other point, in inches.
    length : float
        The distance, in inches.
    direction : float
        The direction, in degrees counterclockwise from the x axis.

    Returns
    -------
    (float, float)
        The point, in inches.

    Examples
    --------
    >>> x, y = along((1, 2), 3, 0)
    >>> print(x, y)
    4.0 2.0
    """
    angle = np.deg2rad(direction)
    return start[0] + length * np.cos(angle), start[1] + length * np.sin(angle)


class Sheet:
    """A sheet of a given size, with lines and letters.

    Parameters
    ----------
    x_range, y_range : (float, float)
        Ranges (low, high) of the coordinates, in inches.
    """

    def __init__(self, x_range, y_range):
        from matplotlib.figure import Figure

        size = x_range[1] - x_range[0], y_range[1] - y_range[0]
        self._figure = Figure(figsize=size)
        self._ax = self._figure.add_axes((0, 0, 1, 1), xlim=x_range, ylim=y_range)
        self._ax.set_axis_off()
        self._layer = 1

    def _repr_svg_(self):
        return self._save("svg", metadata={"Date": None, "Creator": None}).decode()

    def png(self, dpi=120):
        """Return the drawing as the bytes of a PNG file.

        Parameters
        ----------
        dpi : float
            Pixels per inch.
        """
        return self._save("png", dpi=dpi, metadata={"Software": None})

    def _save(self, form, **options):
        import matplotlib

        file = io.BytesIO()
        # reproducible bytes
        with matplotlib.rc_context({"svg.hashsalt": "workbook"}):
            self._figure.savefig(file, format=form, **options)
        return file.getvalue()

    # Lines and letters

    def line(self, *points, dashed=False, width=LINE, colour=BLACK):
        """Draw straight lines from point to point.

        Parameters
        ----------
        *points : (float, float)
            The points, in inches.
        dashed : bool
            Whether the lines are dashed.
        width : float
            Line width, in points.
        colour : str
            A colour of Matplotlib.
        """
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
        """Draw a thin dashed line between two points, from which angles or lengths are measured."""
        self.line(start, end, dashed=True, width=THIN)

    def arc(self, centre, radius, start=0, end=360, dashed=False, width=THIN):
        """Draw an arc of a circle.

        Parameters
        ----------
        centre : (float, float)
            Centre, in inches.
        radius : float
            Radius, in inches.
        start, end : float
            Directions of its ends, in degrees.
        dashed : bool
            Whether it is dashed.
        width : float
            Line width, in points.
        """
        self.line(*arc_points(centre, radius, start, end), dashed=dashed, width=width)

    def label(self, point, text, side=90, gap=0.1):
        """Write a text beside a point.

        Parameters
        ----------
        point : (float, float)
            The point, in inches.
        text : str
            The text; formulas stand between dollars.
        side : float
            Direction from the point to the text, in degrees: 90 above it, 0 to its right.
        gap : float
            Distance from the point, in inches.
        """
        direction = along((0, 0), 1, side)
        self._ax.text(
            *along(point, gap, side),
            text,
            fontsize=FORMULA_SIZE if "$" in text else TEXT_SIZE,
            math_fontfamily="cm",
            ha=_aligned(direction[0], "right", "center", "left"),
            va=_aligned(direction[1], "top", "center", "bottom"),
            zorder=self._above() + 1000,
        )

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
        self.label(end, name, direction_to(start, end) if side is None else side, 0.06)

    def _between(self, start, end, points):
        """Draw a line through points (fraction of the way from start to end, inches to its left)."""
        (x, y), chord = start, np.subtract(end, start)
        normal = np.array([-chord[1], chord[0]]) / np.hypot(*chord)
        self.line(
            *[
                (x + s * chord[0] + d * normal[0], y + s * chord[1] + d * normal[1])
                for s, d in points
            ],
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


def arc_points(centre, radius, start, end):
    """Return points of an arc of a circle between two directions, in degrees."""
    angles = np.linspace(start, end, max(12, int(abs(end - start) / 4)) + 1)
    return [along(centre, radius, angle) for angle in angles]


def direction_to(start, end):
    """Return the direction from a point to another one, in degrees."""
    return np.degrees(np.arctan2(end[1] - start[1], end[0] - start[0]))


def _aligned(component, negative, neutral, positive):
    return neutral if abs(component) < 0.4 else positive if component > 0 else negative
