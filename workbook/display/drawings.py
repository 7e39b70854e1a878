"""Drawings of bodies for the statements of problems: rods, masses, springs, axes, forces.

The unit of a drawing is an inch, x to the right and y upwards; letters, hinges and arrows have the
same size in all drawings. Each method adds one shape above the earlier ones. Points are pairs of
numbers in inches; directions are angles in degrees, counterclockwise from the x axis; formulas
stand between dollars. Forces are thick arrows, velocities have an open head, accelerations two
heads, axes are thin, so that the kinds differ without colours too. A drawing on the last line of a
cell is displayed.

>>> d = Drawing((-1, 1), (-1.6, 0.3))
>>> d.ground((-0.5, 0), (0.5, 0), above=True)
>>> bob = along((0, 0), 1.2, -60)
>>> d.rod((0, 0), bob)
>>> d.angle((0, 0), -90, -60, 0.7, r"$\\varphi$")
"""

import numpy as np

from trajlib.plotting import BLACK, BLUE, GREY, RED
from workbook.display.sheet import LINE, THICK, THIN, Sheet, along, arc_points, direction_to

BODY = "#DCE6EE"


class Drawing(Sheet):
    """A sheet to draw bodies on, with axes, angles and symbols.

    Parameters
    ----------
    x_range, y_range : (float, float)
        Ranges (low, high) of the coordinates, in inches.
    """

    # Bodies

    def rod(self, start, end):
        """Draw a thick line between two points, in inches."""
        self.line(start, end, width=THICK)

    def point(self, centre):
        """Draw a small dot at a point in inches, such as an origin or a distant body."""
        self.mass(centre, 0.035)

    def mass(self, centre, radius=0.11):
        """Draw a black disc; centre and radius in inches."""
        self._patch(arc_points(centre, radius, 0, 360), BLACK)

    def disc(self, centre, radius):
        """Draw a disc in the colour of bodies; centre and radius in inches."""
        self._patch(arc_points(centre, radius, 0, 360), BODY)

    def hinge(self, centre):
        """Draw a hinge, a small white circle, at a point in inches."""
        self._patch(arc_points(centre, 0.055, 0, 360), "white")

    def shape(self, points, position=(0, 0), turn=0, size=1):
        """Draw a body by its outline, which is scaled, rotated and translated.

        Parameters
        ----------
        points : sequence of (float, float)
            The outline about the origin, in inches.
        position : (float, float)
            Position of the origin of the outline, in inches.
        turn : float
            Angle of rotation, in degrees counterclockwise.
        size : float
            Scale factor.
        """
        c, s = np.cos(np.deg2rad(turn)), np.sin(np.deg2rad(turn))
        self._patch(
            [
                (position[0] + size * (c * x - s * y), position[1] + size * (s * x + c * y))
                for x, y in points
            ],
            BODY,
        )

    def box(self, centre, width, height, turn=0):
        """Draw a rectangle in the colour of bodies.

        Parameters
        ----------
        centre : (float, float)
            Its centre, in inches.
        width, height : float
            Its sides, in inches.
        turn : float
            Angle of rotation, in degrees counterclockwise.
        """
        self.shape(
            [(x * width / 2, y * height / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))],
            centre,
            turn,
        )

    def cart(self, x, floor, width=1.1, height=0.36):
        """Draw a cart with two wheels.

        Parameters
        ----------
        x : float
            Coordinate of its middle, in inches.
        floor : float
            Coordinate y on which the wheels stand, in inches.
        width, height : float
            Sides of its body, in inches.

        Returns
        -------
        (float, float)
            The middle of its upper side.
        """
        radius = 0.12
        self.box((x, floor + 2 * radius + height / 2), width, height)
        for wheel in (x - 0.3 * width, x + 0.3 * width):
            self._patch(arc_points((wheel, floor + radius), radius, 0, 360), "white")
            self.point((wheel, floor + radius))
        return x, floor + 2 * radius + height

    def ground(self, start, end, above=False):
        """Draw a fixed line, hatched on one side.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches.
        above : bool
            Whether it is hatched on the left of the direction from start to end, else on the right.
        """
        direction = direction_to(start, end)
        for k in np.arange(0.12, np.hypot(*np.subtract(end, start)) + 1e-9, 0.12):
            root = along(start, k, direction)
            self.line(root, along(root, 0.14, direction + (135 if above else -135)), width=THIN)
        self.line(start, end)

    def spring(self, start, end, coils=6, depth=0.11):
        """Draw a spring between two points.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches.
        coils : int
            Number of coils.
        depth : float
            Half its width, in inches.
        """
        sides = [0, *[depth * (-1) ** k for k in range(2 * coils - 1)], 0]
        self._between(
            start, end, [(0, 0), *zip(np.linspace(0.15, 0.85, len(sides)), sides), (1, 0)]
        )

    def damper(self, start, end, depth=0.13):
        """Draw a damper between two points; `depth` is half its width, all in inches."""
        self._between(start, end, [(0, 0), (0.38, 0)])
        self._between(start, end, [(0.66, depth), (0.38, depth), (0.38, -depth), (0.66, -depth)])
        self._between(start, end, [(0.54, 0.8 * depth), (0.54, -0.8 * depth)])
        self._between(start, end, [(0.54, 0), (1, 0)])

    # Coordinates, velocities and forces

    def axis(self, start, end, name="", side=None):
        """Draw the axis of a coordinate, a thin arrow.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches; the head is at `end`.
        name : str
            Text at the head; formulas stand between dollars.
        side : float, optional
            Direction from the head to the text, in degrees; without it that of the arrow.
        """
        self._arrow(start, end, name, side, "-|>", THIN, BLACK, 11)

    def towards_viewer(self, point, name, side=45):
        """Draw an axis that points to the viewer, a circle with a dot.

        Parameters
        ----------
        point : (float, float)
            Where it meets the sheet, in inches.
        name : str
            Text beside it; formulas stand between dollars.
        side : float
            Direction from the point to the text, in degrees.
        """
        self._patch(arc_points(point, 0.09, 0, 360), "white")
        self.point(point)
        self.label(point, name, side, 0.13)

    def velocity(self, start, end, name="", side=None):
        """Draw a velocity, an arrow with an open head.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches; the head is at `end`.
        name : str
            Text at the head; formulas stand between dollars.
        side : float, optional
            Direction from the head to the text, in degrees; without it that of the arrow.
        """
        self._arrow(start, end, name, side, "->", LINE, BLUE, 14)

    def acceleration(self, start, end, name="", side=None):
        """Draw an acceleration, an arrow with two heads.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches; the head is at `end`.
        name : str
            Text at the head; formulas stand between dollars.
        side : float, optional
            Direction from the head to the text, in degrees; without it that of the arrow.
        """
        self._arrow(start, end, "", None, "-|>", LINE, RED, 14)
        self._arrow(
            start, along(end, -0.12, direction_to(start, end)), "", None, "-|>", LINE, RED, 14
        )
        self.label(end, name, direction_to(start, end) if side is None else side, 0.06)

    def force(self, start, end, name="", side=None):
        """Draw a force, a thick arrow.

        Parameters
        ----------
        start, end : (float, float)
            Its ends, in inches; the head is at `end`.
        name : str
            Text at the head; formulas stand between dollars.
        side : float, optional
            Direction from the head to the text, in degrees; without it that of the arrow.
        """
        self._arrow(start, end, name, side, "-|>", THICK, RED, 16)

    def angle(self, vertex, start, end, radius, name, side=None):
        """Draw an angle as an arc with an arrow head.

        Parameters
        ----------
        vertex : (float, float)
            Its vertex, in inches.
        start, end : float
            Directions between which it is measured, in degrees; the head is at `end`.
        radius : float
            Radius of the arc, in inches.
        name : str
            Text beside the middle of the arc; formulas stand between dollars.
        side : float, optional
            Direction from the middle of the arc to the text, in degrees; without it outwards.
        """
        arc = arc_points(vertex, radius, start, end)
        self.line(*arc[:-4], width=THIN)
        self._arrow(arc[-5], arc[-1], "", None, "-|>", THIN, BLACK, 10)
        middle = (start + end) / 2
        self.label(along(vertex, radius, middle), name, middle if side is None else side, 0.06)

    def dimension(self, start, end, name, side=90, offset=0):
        """Draw the length between two points as a dimension line.

        Parameters
        ----------
        start, end : (float, float)
            The points, in inches.
        name : str
            Text beside its middle; formulas stand between dollars.
        side : float
            Direction from the middle to the text, in degrees.
        offset : float
            Distance of the line from the points, to the left of the direction from start to end,
            in inches.
        """
        across = direction_to(start, end) + 90
        ends = [along(point, offset, across) for point in (start, end)]
        if offset:
            for point, reached in zip((start, end), ends):
                self.line(
                    point, along(reached, 0.06 * np.sign(offset), across), width=0.5, colour=GREY
                )
        self._arrow(*ends, "", None, "<|-|>", THIN, BLACK, 9)
        self.label(np.mean(ends, axis=0), name, side, 0.07)
