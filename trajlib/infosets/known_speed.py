"""Information set of a vehicle with known constant speed: states (x, y, psi).

As published, headings are not bound to a grid: a section of the heading psi is moved along the
exact arcs of u = -1, 0, 1 to psi + D k u/V, and sections of close headings are replaced by their
hull at the mean heading. Three controls reach less than all, and no state needs to have the mean
heading: this is no enclosure. The guaranteed mode uses cells of headings, `trajlib.infosets.cells`
with one row.
"""

import numpy as np

from trajlib._arguments.numbers import read_count, read_positive
from trajlib._typing import ArrayLike
from trajlib.infosets import heading_arguments
from trajlib.infosets.cells import Cells
from trajlib.infosets.polygons import SupportPolygons
from trajlib.infosets.polygons import normals as unit_normals
from trajlib.infosets.regions import Region, read_region
from trajlib.infosets.sections import FULL, Bounds, Sections, covering_arc
from trajlib.infosets.turning import angle_between


class ConstantSpeedInformationSet(Sections):
    """Set of all states (x, y, psi) compatible with the measurements, for a known speed.

    Parameters
    ----------
    region : Region or array_like
        Initial set of (x, y): a `Region`, or points of a convex polygon.
    speed : float
        Speed V.
    k : float
        Largest lateral acceleration.
    dt : float
        Longest step of time; as published, the step.
    headings : int
        Nodes on the circle; as published, sections are merged within 2 pi/headings.
    heading_range : float or tuple, optional
        Initial headings, (low, high) in radians or a single one; all if left out.
    normals : int
        Number m of normals of the polygons.
    mode : {"guaranteed", "published"}
        "guaranteed" encloses all motions with |u| <= 1; "published" is section 6 of the paper and
        does not.
    wrapped : bool
        Whether headings that differ by full turns are identified; otherwise the sets are smaller.

    Raises
    ------
    ValueError
        If arguments do not fit or a step may turn the vehicle by half a circle.

    Examples
    --------
    >>> from trajlib.infosets import Region
    >>> states = ConstantSpeedInformationSet(Region.disc([0, 0], 50), speed=200, k=5, heading_range=0.0, headings=720)
    >>> states.advance(10).contains([0, 2000, 0]), states.contains([0, 1900, 0])
    (True, False)
    """

    _state = 3

    def __init__(
        self,
        region: Region | ArrayLike,
        *,
        speed: float,
        k: float,
        dt: float = 1.0,
        headings: int = 600,
        heading_range: float | tuple | None = None,
        normals: int = 12,
        mode: str = "guaranteed",
        wrapped: bool = True,
    ) -> None:
        self.mode, self.k = (
            heading_arguments.read_mode(mode),
            read_positive(k, "k", "length/time^2"),
        )
        self.dt = read_positive(dt, "dt", "time")
        self.speed = read_positive(speed, "speed", "length/time")
        headings = read_count(headings, "headings", 8)
        self.normals = read_count(normals, "normals", 3)
        if self.k * self.dt / self.speed >= np.pi:
            raise ValueError(
                f"dt: a step may turn the vehicle by {self.k * self.dt / self.speed:.3g} rad, more "
                f"than half a circle; take dt below {np.pi * self.speed / self.k:.3g}"
            )
        section, arc = (
            read_region(region, self.normals).values,
            heading_arguments.read_arc(heading_range, "heading_range"),
        )
        self.time = 0.0
        if mode == "published":
            self._grid = FloatingHeadings(section, self.speed, self.k, headings, arc, wrapped)
        else:
            self._grid = Cells(
                section,
                self.k,
                (0.0, 0.0),
                (self.speed, self.speed),
                0.0,
                headings,
                arc,
                wrapped,
            )

    @property
    def heading_nodes(self) -> np.ndarray:
        """Headings of `sections`, radians; in [0, 2 pi) if wrapped."""
        return self._grid.headings

    def projection(self, onto: str = "xy") -> SupportPolygons | np.ndarray:
        """Return the projection on the plane or on the heading.

        Parameters
        ----------
        onto : {"xy", "psi"}
            "xy": all sections that are not empty. "psi": their headings.

        Returns
        -------
        SupportPolygons or ndarray
        """
        if onto == "xy":
            return self._nonempty()
        if onto != "psi":
            raise ValueError(f'onto: expected "xy" or "psi", got {onto!r}')
        return self.heading_nodes[~self.sections.empty.reshape(-1)]

    def bounds(self) -> Bounds:
        """Return intervals of x, y and psi; in the guaranteed mode they contain the true ones.

        Returns
        -------
        Bounds
        """
        x, y = self._extent()
        return Bounds(x, y, self._grid.heading_bounds())

    def __repr__(self):
        count = int(np.sum(~self.sections.empty))
        return (
            f"{self.mode} information set at t = {self.time:g}: {count} sections, {self.bounds()}"
        )


class FloatingHeadings:
    """Sections at headings of any value, as published."""

    def __init__(self, section, speed, k, headings, arc, wrapped):
        self.speed, self.k, self.wrapped, self.m = speed, k, wrapped, len(section)
        self.width = FULL / headings
        count = max(int(np.rint(arc[1] / self.width)), 1)
        self.headings = arc[0] + self.width * np.arange(count) if arc[1] else np.array([arc[0]])
        self.values = np.tile(section, (count, 1))

    def advance(self, step, elapsed):
        """Advance by a step."""
        turn, n = self.k * step / self.speed, unit_normals(self.m)
        psi = self.headings
        headings, values = (
            [psi],
            [self.values + step * self.speed * np.stack([np.sin(psi), np.cos(psi)], axis=-1) @ n.T],
        )
        for u in (-1, 1):
            after = psi + u * turn
            arc = (
                self.speed**2
                / (self.k * u)
                * np.stack([np.cos(psi) - np.cos(after), np.sin(after) - np.sin(psi)], axis=-1)
            )
            headings.append(after)
            values.append(self.values + arc @ n.T)
        self._merge(np.concatenate(headings), np.concatenate(values))

    def _merge(self, headings, values):
        """Merge groups of headings whose neighbours are closer than half the width.

        No group is wider than the width.
        """
        if self.wrapped:
            headings = headings % FULL
        order = np.argsort(headings, kind="stable")
        headings, values = headings[order], values[order]
        starts, first = [0], headings[0]
        for k in range(1, len(headings)):
            if headings[k] - headings[k - 1] > self.width / 2 or headings[k] - first > self.width:
                starts.append(k)
                first = headings[k]
        sizes = np.diff(np.append(starts, len(headings)))
        self.headings = np.add.reduceat(headings, starts) / sizes
        self.values = np.maximum.reduceat(values, starts, axis=0)

    def possible(self, arc, speeds):
        """Return whether headings lie within the width of an arc, shape (count,)."""
        apart = angle_between(self.headings - arc[0] - arc[1] / 2) - arc[1] / 2
        return (apart <= self.width) & (speeds[0] <= self.speed <= speeds[1])

    def trim(self):
        """Drop the empty sections."""
        possible = ~np.isneginf(self.values[:, 0])
        self.headings, self.values = self.headings[possible], self.values[possible]

    def sections_at(self, heading):
        """Return the section of the nearest heading within the width, shape (1, m) or (0, m)."""
        distance = angle_between(self.headings - heading)
        nearest = int(np.argmin(distance))
        return self.values[nearest : nearest + int(distance[nearest] <= self.width)]

    def heading_bounds(self):
        return covering_arc(self.headings % FULL)
