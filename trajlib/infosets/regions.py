"""Measured regions: convex sets of the plane, by their support functions."""

from __future__ import annotations

import numpy as np

from trajlib._arguments.numbers import read_points, read_positive
from trajlib._typing import ArrayLike
from trajlib.infosets.polygons import EPS, ROUNDINGS, SupportPolygons, normals


class Region:
    """Convex set in the plane that contains (x, y), made by `box`, `disc` or `polygon`.

    Parameters
    ----------
    corners : ndarray, shape (count, 2)
        Points whose convex hull is taken.
    radius : float
        Distance by which the hull is enlarged.
    description : str
        Description.

    Examples
    --------
    >>> Region.box([100, 50], 40, 20).around(4).values.round(9).tolist()       # y <= 60, x <= 120, y >= 40, x >= 80
    [60.0, 120.0, -40.0, -80.0]
    """

    def __init__(self, corners: np.ndarray, radius: float, description: str) -> None:
        self._corners, self._radius, self._description = corners, radius, description

    @classmethod
    def box(cls, centre: ArrayLike, width: float, height: float | None = None) -> Region:
        """Return a rectangle with sides along the axes.

        Parameters
        ----------
        centre : array_like, shape (2,)
            Centre.
        width : float
            Length along x.
        height : float, optional
            Length along y; a square if left out.

        Returns
        -------
        Region
        """
        centre = _read_point(centre, "centre")
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
    def disc(cls, centre: ArrayLike, radius: float) -> Region:
        """Return all points within a distance of the centre.

        Parameters
        ----------
        centre : array_like, shape (2,)
            Centre.
        radius : float
            Radius.

        Returns
        -------
        Region
        """
        centre, radius = _read_point(centre, "centre"), read_positive(radius, "radius", "length")
        return cls(
            centre[None], radius, f"disc of radius {radius:g} around ({centre[0]:g}, {centre[1]:g})"
        )

    @classmethod
    def polygon(cls, points: ArrayLike) -> Region:
        """Return the convex hull of points.

        Parameters
        ----------
        points : array_like, shape (count, 2)
            Points.

        Returns
        -------
        Region
        """
        points = read_points(points, "points")
        if points.ndim != 2 or len(points) == 0:
            raise ValueError(
                f"points: expected shape (count, 2) with a point or more, got {points.shape}"
            )
        return cls(points, 0.0, f"hull of {len(points)} points")

    def around(self, m: int) -> SupportPolygons:
        """Return the smallest polygon with m normals around the set, rounded outwards.

        Parameters
        ----------
        m : int
            Number of normals.

        Returns
        -------
        SupportPolygons
        """
        values = (self._corners @ normals(m).T).max(axis=0) + self._radius
        return SupportPolygons.of_tight(
            values + ROUNDINGS * EPS * (np.abs(self._corners).max() + self._radius)
        )

    def outline(self) -> np.ndarray:
        """Return points of the boundary in order.

        Returns
        -------
        ndarray, shape (count, 2)
            120 points for a disc, all given points for a hull.
        """
        if self._radius:
            return self._corners[0] + self._radius * normals(120)
        return self._corners

    def __repr__(self):
        return self._description


def _read_point(point, name):
    point = read_points(point, name)
    if point.shape != (2,):
        raise ValueError(f"{name}: expected a point (x, y), got shape {point.shape}")
    return point


def read_region(region, m, name="region"):
    """Return a Region, or a polygon given as points or SupportPolygons, as one SupportPolygons."""
    if isinstance(region, SupportPolygons):
        if region.shape != () or region.m != m:
            raise ValueError(f"{name}: expected one polygon with {m} normals, got {region!r}")
        if region.empty:
            raise ValueError(f"{name}: it is empty, so no position is possible")
        return region
    return (region if isinstance(region, Region) else Region.polygon(region)).around(m)
