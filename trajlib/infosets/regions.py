"""What a measurement says: a convex set of the plane, by its support function."""

import numpy as np

from trajlib._arguments.numbers import read_points, read_positive
from trajlib.infosets.polygons import EPS, ROUNDINGS, SupportPolygons, normals


class Region:
    """A convex set in the plane that holds (x, y): what a measurement says. Made by `box`, `disc`
    or `polygon`.

    >>> Region.box([100, 50], 40, 20).around(4).values.round(9).tolist()       # y <= 60, x <= 120, y >= 40, x >= 80
    [60.0, 120.0, -40.0, -80.0]
    """

    def __init__(self, corners, radius, words):
        self._corners, self._radius, self._words = corners, radius, words

    @classmethod
    def box(cls, centre, width, height=None):
        """A rectangle with sides along the axes; a square without `height`."""
        centre = _one(centre, "centre")
        half = (
            np.array(
                [
                    read_positive(width, "width", "length"),
                    read_positive(width if height is None else height, "height", "length"),
                ]
            )
            / 2
        )
        corners = centre + half * np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]])
        return cls(
            corners,
            0.0,
            f"box {2 * half[0]:g} x {2 * half[1]:g} around ({centre[0]:g}, {centre[1]:g})",
        )

    @classmethod
    def disc(cls, centre, radius):
        """All points within `radius` of `centre`."""
        centre, radius = _one(centre, "centre"), read_positive(radius, "radius", "length")
        return cls(
            centre[None], radius, f"disc of radius {radius:g} around ({centre[0]:g}, {centre[1]:g})"
        )

    @classmethod
    def polygon(cls, points):
        """The convex hull of points of shape (count, 2)."""
        points = read_points(points, "points")
        if points.ndim != 2 or len(points) == 0:
            raise ValueError(
                f"points: expected shape (count, 2) with a point or more, got {points.shape}"
            )
        return cls(points, 0.0, f"hull of {len(points)} points")

    def around(self, m):
        """The least polygon with m normals around it, rounded outwards: all of the set itself lies
        inside."""
        values = (self._corners @ normals(m).T).max(axis=0) + self._radius
        return SupportPolygons.of_tight(
            values + ROUNDINGS * EPS * (np.abs(self._corners).max() + self._radius)
        )

    def outline(self):
        """Points of the boundary in order, shape (count, 2); of a disc 120, of a hull all points
        that were given."""
        if self._radius:
            return self._corners[0] + self._radius * normals(120)
        return self._corners

    def __repr__(self):
        return self._words


def _one(point, name):
    point = read_points(point, name)
    if point.shape != (2,):
        raise ValueError(f"{name}: expected a point (x, y), got shape {point.shape}")
    return point


def read_region(region, m, name="region"):
    """A Region, or a polygon given as points or as SupportPolygons, as one SupportPolygons with m
    normals."""
    if isinstance(region, SupportPolygons):
        if region.shape != () or region.m != m:
            raise ValueError(f"{name}: expected one polygon with {m} normals, got {region!r}")
        if region.empty:
            raise ValueError(f"{name}: it is empty, so it says that the vehicle is nowhere")
        return region
    return (region if isinstance(region, Region) else Region.polygon(region)).around(m)
