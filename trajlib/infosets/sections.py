"""Common part of both information sets: sections in the plane, measurements and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from trajlib._arguments.numbers import read_count, read_interval, read_number, read_points
from trajlib._typing import ArrayLike
from trajlib.infosets.errors import EmptyInformationSet
from trajlib.infosets.heading_arguments import read_arc
from trajlib.infosets.polygons import SupportPolygons
from trajlib.infosets.regions import Region, read_region

if TYPE_CHECKING:
    from matplotlib.axes import Axes


FULL = 2 * np.pi
#: Share of a step by which a time may miss a whole number of steps.
TOGETHER = 1e-9


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
    dt: float
    mode: str
    normals: int
    #: Time since the start.
    time: float

    def advance(self, steps: int | None = None, *, to: float | None = None) -> Self:
        """Advance the set by prediction.

        Parameters
        ----------
        steps : int, optional
            Number of steps of length dt; 1 if neither it nor `to` is given.
        to : float, optional
            Time to which to advance instead, from the start: in the fewest equal steps that are not
            longer than dt. As published, a whole number of steps dt.

        Returns
        -------
        Self
            The set itself, which is changed.

        Raises
        ------
        ValueError
            If the time is past, or the model ends: no speed is left above zero, or a step may turn
            the vehicle by half a circle.
        """
        if steps is not None and to is not None:
            raise ValueError("to: give either the number of steps or the time, and not both")
        if to is None:
            count, step = read_count(1 if steps is None else steps, "steps", 0), self.dt
        else:
            count, step = self._steps_until(read_number(to, "to"))
        begin = self.time
        for k in range(1, count + 1):
            time = float(to) if to is not None and k == count else begin + k * step
            self._grid.advance(step, time)
            self.time = time
        return self

    def _steps_until(self, to):
        """Return number and length of the steps to a time."""
        duration = to - self.time
        if duration < 0:
            raise ValueError(f"to: the time {to:g} is past, the set is at {self.time:g}")
        count = int(np.ceil(duration / self.dt - TOGETHER))
        if self.mode == "published":
            if abs(duration - count * self.dt) > TOGETHER * self.dt:
                raise ValueError(
                    f"to: {to:g} is no whole number of steps dt = {self.dt:g} from {self.time:g}, "
                    "and the published step has this length; the guaranteed one has any"
                )
            return count, self.dt
        return (count, duration / count) if count else (int(duration > 0), duration)

    def measure(
        self,
        *regions: Region | SupportPolygons | ArrayLike,
        heading: float | tuple | None = None,
        speed: tuple | None = None,
    ) -> Self:
        """Keep the states that are compatible with a measurement at this time.

        Parameters
        ----------
        *regions : Region, SupportPolygons or array_like
            Sets that contain (x, y): `Region`, points of a convex polygon, or one of
            SupportPolygons.
        heading : float or tuple, optional
            Arc (low, high) that contains the heading, radians, or the heading itself.
        speed : tuple, optional
            Interval (low, high) that contains the speed.

        Returns
        -------
        Self
            The set itself, which is changed.

        Raises
        ------
        EmptyInformationSet
            If no state is left; the set is then unchanged.

        Notes
        -----
        Headings and speeds are told apart up to a cell of the grid (as published, a node).
        """
        if not regions and heading is None and speed is None:
            raise ValueError(
                "regions: expected one or more, or heading or speed; without a measurement there is "
                "nothing to do"
            )
        polygons = [
            read_region(region, self.normals, f"region {k}" if len(regions) > 1 else "region")
            for k, region in enumerate(regions)
        ]
        arc = read_arc(heading, "heading")
        interval = (0.0, np.inf) if speed is None else read_interval(speed, "speed")
        remaining = self.sections
        if polygons:
            values = np.minimum.reduce([region.values for region in polygons])
            remaining = remaining.intersect(SupportPolygons(values))
        possible = self._grid.possible(arc, interval)
        values = np.where(possible[..., None], remaining.values, -np.inf)
        if np.isneginf(values).all():
            raise EmptyInformationSet(self.time)
        self._grid.values = values
        self._grid.trim()
        return self

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
