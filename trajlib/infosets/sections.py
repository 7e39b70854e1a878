"""What information sets of both kinds share: sections in the plane, one a node, measurements, and
pictures."""

from dataclasses import dataclass

import numpy as np

from trajlib._arguments.numbers import read_count, read_points
from trajlib.infosets.errors import EmptyInformationSet
from trajlib.infosets.polygons import SupportPolygons
from trajlib.infosets.regions import read_region

FULL = 2 * np.pi


@dataclass(frozen=True)
class Bounds:
    """Intervals (low, high) that hold the coordinates. `heading`: an arc from low clockwise to
    high, which may exceed 2 pi; `speed`: None where it is known."""

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
    """Sections of an information set over the nodes of a grid that it makes itself; `values` has
    the shape (..., m)."""

    def advance(self, steps=1):
        """The forecast after so many steps of length dt; returns the set itself, which it
        changes."""
        for _ in range(read_count(steps, "steps", 0)):
            self._grid.advance()
            self._steps += 1
        return self

    def measure(self, *regions):
        """Keep what agrees with a measurement now: (x, y) lies in each of `regions` (`Region`s,
        points of a convex polygon, or one of SupportPolygons). Returns the set itself. Raises
        EmptyInformationSet, with the time, if nothing is left; the set is then as it was before."""
        if not regions:
            raise ValueError(
                "regions: expected one or more; without a measurement there is nothing to do"
            )
        read = [
            read_region(region, self.normals, f"region {k}" if len(regions) > 1 else "region")
            for k, region in enumerate(regions)
        ]
        values = np.minimum.reduce([region.values for region in read])
        left = self.sections.intersect(SupportPolygons(values))
        if left.empty.all():
            raise EmptyInformationSet(self.time)
        self._grid.values = left.values
        self._grid.settle()
        return self

    @property
    def time(self):
        """The time since the start."""
        return self._steps * self.dt

    @property
    def sections(self):
        """All sections as SupportPolygons, of the shape of the grid; empty where no state is
        possible."""
        return SupportPolygons.of_tight(self._grid.values)

    def contains(self, state):
        """Whether the set holds a state (x, y, psi, V), or (x, y, psi) where the speed is known:
        whether the section of a cell that contains psi and V holds (x, y), or as published the
        section of the nearest node."""
        state = read_points(state, "state", self._state)
        if state.ndim != 1:
            raise ValueError(
                f"state: expected one of {self._state} numbers, got shape {state.shape}"
            )
        sections = self._grid.sections_at(*state[2:])
        return bool(len(sections) and SupportPolygons.of_tight(sections).contains(state[:2]).any())

    def _extent(self):
        """Intervals of x and y over all sections: by the normals along the axes if there are four,
        or by corners."""
        if self.normals % 4 == 0:
            up, right, down, left = self.sections.hull().values[:: self.normals // 4].tolist()
            return (-left, right), (-down, up)
        corners = self._kept().vertices.reshape(-1, 2)
        return tuple(
            (float(low), float(high)) for low, high in zip(corners.min(axis=0), corners.max(axis=0))
        )

    def _kept(self):
        return SupportPolygons.of_tight(self._grid.values[~self.sections.empty])

    def plot(self, ax=None, color="0.75", label=None, **options):
        """Draw the projection on the plane: all sections, one over the other; returns the Axes.
        Further options go to Matplotlib's PolyCollection."""
        import matplotlib.pyplot as plt
        from matplotlib.collections import PolyCollection

        if ax is None:
            _, ax = plt.subplots()
            ax.set(xlabel="$x$", ylabel="$y$")
        drawn = PolyCollection(
            self._kept().vertices,
            facecolors=color,
            edgecolors=color,
            linewidths=0.5,
            **({"rasterized": True, "zorder": 1} | options),
        )
        ax.add_collection(drawn)
        if label:
            ax.fill([], [], color=color, label=label)
        ax.set_aspect("equal")
        ax.autoscale_view()
        return ax


def arc_of(headings):
    """The shortest arc (low, high) that holds headings given in [0, 2 pi), 0 <= low < 2 pi."""
    found = np.unique(headings)
    gaps = np.append(found[1:], found[0] + FULL) - found
    widest = int(np.argmax(gaps))
    low = found[(widest + 1) % len(found)]
    return float(low), float(low + FULL - gaps[widest])
