"""Information set of a vehicle with unknown speed: states (x, y, psi, V)."""

import numpy as np

from trajlib._arguments.numbers import read_count, read_interval, read_positive
from trajlib._typing import ArrayLike
from trajlib.infosets import heading_arguments
from trajlib.infosets.cells import Cells
from trajlib.infosets.polygons import SupportPolygons
from trajlib.infosets.published import Nodes
from trajlib.infosets.regions import Region, read_region
from trajlib.infosets.sections import FULL, Bounds, Sections


class InformationSet(Sections):
    """Set of all states (x, y, psi, V) compatible with the measurements.

    Parameters
    ----------
    region : Region or array_like
        Initial set of (x, y): a `Region`, or points of a convex polygon.
    k : float
        Largest lateral acceleration.
    mu : tuple of float
        Bounds (mu1, mu2) on V', mu1 < 0 < mu2.
    speeds : tuple of float
        Initial speeds (low, high), low > 0.
    dt : float
        Longest step of time D; as published, the step.
    headings : int
        Nodes on the circle.
    heading_range : float or tuple, optional
        Initial headings, (low, high) in radians or a single one; all if left out.
    normals : int
        Number m of normals of the polygons.
    mode : {"guaranteed", "published"}
        See the notes.
    speed_step : float, optional
        Width dV of a cell of speeds in the guaranteed mode, dt (mu2 - mu1)/2 if left out. The cost
        of a step grows like 1/dV.
    speed_limits : tuple of float, optional
        Interval (low, high) that the speed never leaves, in the guaranteed mode.
    max_speeds : int, optional
        Largest number N_V of nodes of speed of the published mode, 20 if left out.
    counted_from : {"start", "measurement"}, optional
        From when the published mode counts the steps of which every q-th shifts the speeds (4.3):
        from the start, if left out, or anew from each measurement. The paper divides each interval
        between measurements anew and does not say which steps it counts.

    Raises
    ------
    ValueError
        If arguments do not fit.

    Notes
    -----
    "guaranteed" encloses all motions of the model, with u(t) and w(t) of any kind within their
    bounds. A node represents a cell around it; in a step a section grows by a bound on the
    displacement from its whole cell and is given to all cells that can be reached, so that each
    true state stays in a section of its cell (the proof: `trajlib.infosets.cells`). Steps may be of
    any length, so measurements may come at any times (`advance(to=...)`). "published" is
    the algorithm of the paper, sections 3 and 4. It is faster and may lose the true state.

    Examples
    --------
    >>> from trajlib.infosets import Region
    >>> states = InformationSet(Region.box([0, 0], 400), k=6, mu=(-1, 3), speeds=(180, 200), headings=120,
    ...                         heading_range=(0, 0.5))
    >>> states.advance(20).bounds().speed
    (160.0, 260.0)
    >>> states.measure(Region.box([1000, 3800], 400)).contains([900, 3900, 0.3, 195])
    True
    """

    _state = 4

    def __init__(
        self,
        region: Region | ArrayLike,
        *,
        k: float,
        mu: tuple,
        speeds: tuple,
        dt: float = 1.0,
        headings: int = 600,
        heading_range: float | tuple | None = None,
        normals: int = 12,
        mode: str = "guaranteed",
        speed_step: float | None = None,
        speed_limits: tuple | None = None,
        max_speeds: int | None = None,
        counted_from: str | None = None,
    ) -> None:
        self.mode, self.k = (
            heading_arguments.read_mode(mode),
            read_positive(k, "k", "length/time^2"),
        )
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
            heading_arguments.read_arc(heading_range, "heading_range"),
        )
        self.time = 0.0
        inapplicable = (
            {"speed_step": speed_step, "speed_limits": speed_limits}
            if mode == "published"
            else {"max_speeds": max_speeds, "counted_from": counted_from}
        )
        for name in (name for name, value in inapplicable.items() if value is not None):
            owner = "published" if mode == "guaranteed" else "guaranteed"
            raise ValueError(f"{name}: it belongs to the {owner} mode")
        if mode == "published":
            counted_from = "start" if counted_from is None else counted_from
            if counted_from not in ("start", "measurement"):
                raise ValueError(
                    f'counted_from: expected "start" or "measurement", got {counted_from!r}'
                )
            count = read_count(20 if max_speeds is None else max_speeds, "max_speeds", 4)
            self._grid = Nodes(
                section, self.k, self.mu, speeds, self.dt, headings, arc, count, counted_from
            )
            return
        width = self.dt * (self.mu[1] - self.mu[0]) / 2
        if speed_step is not None:
            width = read_positive(speed_step, "speed_step", "length/time")
        limits = (0.0, np.inf)
        if speed_limits is not None:
            limits = read_interval(speed_limits, "speed_limits")
            speeds = max(speeds[0], limits[0]), min(speeds[1], limits[1])
            if limits[0] < 0 or speeds[0] > speeds[1]:
                raise ValueError(
                    f"speed_limits: expected positive speeds with some of the initial ones, got "
                    f"{speed_limits!r}"
                )
        self._grid = Cells(section, self.k, self.mu, speeds, width, headings, arc, limits=limits)

    @property
    def speed_nodes(self) -> np.ndarray:
        """Nodes of speed, one a row of `sections`."""
        return self._grid.speeds

    @property
    def heading_nodes(self) -> np.ndarray:
        """Nodes of heading in [0, 2 pi), one a column of `sections`."""
        return self._grid.headings % FULL

    def projection(self, onto: str = "xy") -> SupportPolygons | np.ndarray:
        """Return the projection on the plane or on heading and speed.

        Parameters
        ----------
        onto : {"xy", "psi-V"}
            "xy": all sections that are not empty; their union is the projection. "psi-V": their
            nodes (psi, V), shape (count, 2).

        Returns
        -------
        SupportPolygons or ndarray
        """
        if onto == "xy":
            return self._nonempty()
        if onto != "psi-V":
            raise ValueError(f'onto: expected "xy" or "psi-V", got {onto!r}')
        rows, columns = np.nonzero(~self.sections.empty)
        return np.column_stack([self.heading_nodes[columns], self.speed_nodes[rows]])

    def bounds(self) -> Bounds:
        """Return intervals of all coordinates; in the guaranteed mode they contain the true ones.

        Returns
        -------
        Bounds
        """
        x, y = self._extent()
        return Bounds(x, y, self._grid.heading_bounds(), self._grid.speed_bounds())

    def __repr__(self):
        count = int(np.sum(~self.sections.empty))
        return (
            f"{self.mode} information set at t = {self.time:g}: {count} sections, {self.bounds()}"
        )
