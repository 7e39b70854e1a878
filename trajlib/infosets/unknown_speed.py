"""The information set of a vehicle whose speed is not known: states (x, y, psi, V)."""

import numpy as np

from trajlib._arguments.numbers import read_count, read_interval, read_positive
from trajlib.infosets import arguments
from trajlib.infosets.cells import Cells
from trajlib.infosets.published import Nodes
from trajlib.infosets.regions import read_region
from trajlib.infosets.sections import FULL, Bounds, Sections


class InformationSet(Sections):
    """All states (x, y, psi, V) that agree with what was measured (no MATLAB word).

    `region`: where (x, y) is at the start, a `Region` or points of a convex polygon. `k`: greatest
    lateral acceleration; `mu` = (mu1, mu2): bounds on V', mu1 < 0 < mu2; `speeds` = (low, high): of
    V at the start; `heading_range`: of psi at the start, (low, high) in radians or one heading, all
    if None. `dt`: the step D. `headings`: nodes on the circle; `normals`: m of the polygons.

    `mode="guaranteed"` encloses all motions of the model, with u(t) and w(t) of any kind within
    their bounds. A node stands for a cell around it; in a step a section grows by a bound on the
    displacement from its whole cell and is given to all cells that can be reached, so that each
    true state stays in a section of its cell (the proof: `trajlib.infosets.cells`).
    `mode="published"` is the algorithm of the paper, sections 3 and 4. It is quicker and may lose
    the true state; `max_speeds`: its N_V, 20 if left out.

    >>> from trajlib.infosets import Region
    >>> place = InformationSet(Region.box([0, 0], 400), k=6, mu=(-1, 3), speeds=(180, 200), headings=120,
    ...                        heading_range=(0, 0.5))
    >>> place.advance(20).bounds().speed
    (160.0, 260.0)
    >>> place.measure(Region.box([1000, 3800], 400)).contains([900, 3900, 0.3, 195])
    True
    """

    _state = 4

    def __init__(
        self,
        region,
        *,
        k,
        mu,
        speeds,
        dt=1.0,
        headings=600,
        heading_range=None,
        normals=12,
        mode="guaranteed",
        max_speeds=None,
    ):
        self.mode, self.k = arguments.mode(mode), read_positive(k, "k", "length/time^2")
        self.dt = read_positive(dt, "dt", "time")
        self.mu = read_interval(mu, "mu", "(mu1, mu2)")
        if not self.mu[0] < 0 < self.mu[1]:
            raise ValueError(
                f"mu: expected mu1 < 0 < mu2, got {mu!r}; a speed that is known and constant is "
                "for ConstantSpeedInformationSet"
            )
        speeds = read_interval(speeds, "speeds")
        if speeds[0] <= 0:
            raise ValueError(f"speeds: the model needs V > 0, got {speeds[0]:g}")
        headings = read_count(headings, "headings", 8)
        self.normals = read_count(normals, "normals", 3)
        section, arc = (
            read_region(region, self.normals).values,
            arguments.arc(heading_range, "heading_range"),
        )
        self._steps = 0
        common = section, self.k, self.mu, speeds, self.dt, headings, arc
        if mode == "published":
            self._grid = Nodes(
                *common, read_count(20 if max_speeds is None else max_speeds, "max_speeds", 4)
            )
        elif max_speeds is not None:
            raise ValueError(
                "max_speeds: it belongs to the published mode; the guaranteed one keeps all speeds"
            )
        else:
            self._grid = Cells(*common)

    @property
    def speed_nodes(self):
        """The nodes of speed, one a row of `sections`."""
        return self._grid.speeds

    @property
    def heading_nodes(self):
        """The nodes of heading in [0, 2 pi), one a column of `sections`."""
        return self._grid.headings % FULL

    def projection(self, onto="xy"):
        """`"xy"`: all sections that are not empty, SupportPolygons whose union is the projection on
        the plane. `"psi-V"`: the nodes (psi, V) at which they stand, shape (count, 2)."""
        if onto == "xy":
            return self._kept()
        if onto != "psi-V":
            raise ValueError(f'onto: expected "xy" or "psi-V", got {onto!r}')
        rows, columns = np.nonzero(~self.sections.empty)
        return np.column_stack([self.heading_nodes[columns], self.speed_nodes[rows]])

    def bounds(self):
        """Intervals of all four coordinates; in the guaranteed mode they hold the true ones."""
        return Bounds(*self._extent(), self._grid.heading_bounds(), self._grid.speed_bounds())

    def __repr__(self):
        there = int(np.sum(~self.sections.empty))
        return (
            f"{self.mode} information set at t = {self.time:g}: {there} sections, {self.bounds()}"
        )
