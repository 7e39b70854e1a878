"""Common part of both information sets: sections in the plane, measurements and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from trajlib._arguments.numbers import read_count, read_points
from trajlib._typing import ArrayLike
from trajlib.infosets.errors import EmptyInformationSet
from trajlib.infosets.polygons import SupportPolygons
from trajlib.infosets.regions import Region, read_region

if TYPE_CHECKING:
    from matplotlib.axes import Axes


FULL = 2 * np.pi


@dataclass(frozen=True)
class Bounds:
    """Intervals (low, high) that contain the coordinates.

    Attributes
    ----------
    x, y : tuple of float
        Position.
    heading : tuple of float
        Arc from low clockwise to high, which may exceed 2 pi.
    speed : tuple of float or None
        Speed, None where it is known.
    """

    x: tuple
    y: tuple
    heading: tuple
    speed: tuple | None = None

    def __str__(self):
        parts = [
            f"{name} in [{low:.6g}, {high:.6g}]"
            for name, (low, high) in (
                ("x", self.x),
                ("y", self.y),
                ("psi", self.heading),
                ("V", self.speed or (0, 0)),
            )
        ]
        return ", ".join(parts if self.speed else parts[:-1])


class Sections:
    """Sections of an information set over the nodes of a grid, which a subclass makes.

    `_grid.values` has the shape (..., m).
    """

    _grid: Any
    _state: int
    _steps: int
    dt: float
    normals: int

    def advance(self, steps: int = 1) -> Self:
        """Advance the set by prediction over some steps of length dt.

        Parameters
        ----------
        steps : int
            Number of steps.

        Returns
        -------
        Self
            The set itself, which is changed.
        """
        for _ in range(read_count(steps, "steps", 0)):
            self._grid.advance()
            self._steps += 1
        return self

    def measure(self, *regions: Region | SupportPolygons | ArrayLike) -> Self:
        """Keep the states that are compatible with a measurement at this time.

        Parameters
        ----------
        *regions : Region, SupportPolygons or array_like
            Sets that contain (x, y): `Region`, points of a convex polygon, or one of
            SupportPolygons.

        Returns
        -------
        Self
            The set itself, which is changed.

        Raises
        ------
        EmptyInformationSet
            If no state is left; the set is then unchanged.
        """
        if not regions:
            raise ValueError(
                "regions: expected one or more; without a measurement there is nothing to do"
            )
        polygons = [
            read_region(region, self.normals, f"region {k}" if len(regions) > 1 else "region")
            for k, region in enumerate(regions)
        ]
        values = np.minimum.reduce([region.values for region in polygons])
        remaining = self.sections.intersect(SupportPolygons(values))
        if remaining.empty.all():
            raise EmptyInformationSet(self.time)
        self._grid.values = remaining.values
        self._grid.trim()
        return self

    @property
    def time(self) -> float:
        """Time since the start."""
        return self._steps * self.dt

    @property
    def sections(self) -> SupportPolygons:
        """All sections, of the shape of the grid; empty where no state is possible."""
        return SupportPolygons.of_tight(self._grid.values)

    def contains(self, state: ArrayLike) -> bool:
        """Return whether the set contains a state.

        Parameters
        ----------
        state : array_like, shape (4,)
            State (x, y, psi, V), or (x, y, psi) where the speed is known.

        Returns
        -------
        bool
            Whether the section of a cell that contains psi and V contains (x, y); as published, the
            section of the nearest node.
        """
        state = read_points(state, "state", self._state)
        if state.ndim != 1:
            raise ValueError(
                f"state: expected one of {self._state} numbers, got shape {state.shape}"
            )
        sections = self._grid.sections_at(*state[2:])
        return bool(len(sections) and SupportPolygons.of_tight(sections).contains(state[:2]).any())

    def _extent(self):
        """Return intervals of x and y over all sections.

        From the normals along the axes if there are four, otherwise from corners.
        """
        if self.normals % 4 == 0:
            up, right, down, left = self.sections.hull().values[:: self.normals // 4].tolist()
            return (-left, right), (-down, up)
        corners = self._nonempty().vertices.reshape(-1, 2)
        return tuple(
            (float(low), float(high)) for low, high in zip(corners.min(axis=0), corners.max(axis=0))
        )

    def _nonempty(self):
        return SupportPolygons.of_tight(self._grid.values[~self.sections.empty])

    def plot(
        self, ax: Axes | None = None, color: str = "0.75", label: str | None = None, **options: Any
    ) -> Axes:
        """Draw the projection on the plane, all sections one over the other.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Axes to draw on; new ones if left out.
        color : str
            Colour of Matplotlib.
        label : str, optional
            Entry in the legend.
        **options : object
            Options of Matplotlib's PolyCollection.

        Returns
        -------
        matplotlib.axes.Axes
        """
        import matplotlib.pyplot as plt
        from matplotlib.collections import PolyCollection

        if ax is None:
            _, ax = plt.subplots()
            ax.set(xlabel="$x$", ylabel="$y$")
        collection = PolyCollection(
            self._nonempty().vertices,
            facecolors=color,
            edgecolors=color,
            linewidths=0.5,
            **({"rasterized": True, "zorder": 1} | options),
        )
        ax.add_collection(collection)
        if label:
            ax.fill([], [], color=color, label=label)
        ax.set_aspect("equal")
        ax.autoscale_view()
        return ax


def covering_arc(headings):
    """Return the shortest arc (low, high) that contains headings in [0, 2 pi), 0 <= low < 2 pi."""
    headings_sorted = np.unique(headings)
    gaps = np.append(headings_sorted[1:], headings_sorted[0] + FULL) - headings_sorted
    widest = int(np.argmax(gaps))
    low = headings_sorted[(widest + 1) % len(headings_sorted)]
    return float(low), float(low + FULL - gaps[widest])
