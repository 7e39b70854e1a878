"""Published step (Euler), which does not enclose the motion.

Sections move by D V (sin psi, cos psi) and are copied to the nodes of nine controls. In heading
(|u| <= 1) the copies go [D k/(V dpsi)] + 1 nodes away, in speed [D |mu|/dV] + 1 nodes, [.] the
integer part (4.1), (4.2); where several meet, their hull is taken. Since dV is large, speeds are
moved only every q-th step, q the largest number with [q D |mu|/dV] = [D |mu|/dV] (4.3). Steps are
counted from the start, or from each measurement: the paper divides the interval between two
measurements anew (section 3) and does not say which steps it counts. Between
[(N_V + 1)/2] and N_V nodes of speed are kept (section 4.3): too many are thinned by deleting every
second one, too few are doubled by unions of neighbours.

**This is an estimate and no enclosure** of the continuous motion: a true state may lie outside.
`trajlib.infosets.cells` has a step that encloses.
"""

import numpy as np

from trajlib.infosets.polygons import normals
from trajlib.infosets.sections import FULL, covering_arc
from trajlib.infosets.turning import angle_between


class Nodes:
    """Sections over nodes of headings and speeds, as published."""

    def __init__(self, section, k, mu, speeds, dt, headings, arc, max_speeds, counted_from):
        self.k, self.mu, self.dt, self.max_speeds, self.m = k, mu, dt, max_speeds, len(section)
        self.counted_from = counted_from
        self.min_speeds = (max_speeds + 1) // 2
        self.heading_step = FULL / headings
        self.headings = self.heading_step * np.arange(headings)
        # the number at the start is not given; 12 for N_V = 20 and 22 for N_V = 40 are
        rows = min(self.min_speeds + 2, max_speeds) if speeds[1] > speeds[0] else 1
        self.first, self.speed_step = (
            speeds[0],
            (speeds[1] - speeds[0]) / max(rows - 1, 1) or dt * max(-mu[0], mu[1]),
        )
        self.values = np.full((rows, headings, self.m), -np.inf)
        possible = (self.headings - arc[0] + 1e-9) % FULL <= arc[1] + 2e-9
        # an arc between two nodes: the nearest one
        if not possible.any():
            possible[int(np.rint((arc[0] + arc[1] / 2) / self.heading_step)) % headings] = True
        self.values[:, possible] = section
        self._steps = 0

    @property
    def speeds(self):
        """Nodes of speed."""
        return self.first + self.speed_step * np.arange(len(self.values))

    def advance(self, step, elapsed):
        """Advance by a step, which has the length dt."""
        speeds = self.speeds
        if speeds[0] <= 0:
            raise ValueError(
                f"the least node of the speed is {speeds[0]:.4g}, but the model needs V > 0; "
                "measure earlier, or begin with higher speeds"
            )
        turn = self.k * self.dt / speeds
        if turn[0] >= np.pi:
            raise ValueError(
                f"dt: a step may turn the slowest vehicle by {turn[0]:.3g} rad, more than half a "
                f"circle; take dt below {self.dt * np.pi / turn[0]:.3g}"
            )
        displacements = (
            np.stack([np.sin(self.headings), np.cos(self.headings)], axis=-1) @ normals(self.m).T
        )
        shifted = self.values + self.dt * speeds[:, None, None] * displacements
        turned = shifted.copy()
        for row, nodes in enumerate(np.floor(turn / self.heading_step).astype(int) + 1):
            for sign in (1, -1):
                np.maximum(
                    turned[row], np.roll(shifted[row], sign * nodes, axis=0), out=turned[row]
                )
        self.values = self._accelerated(turned)
        self._steps += 1
        self._thin()

    def _accelerated(self, values):
        rows_below, rows_above = (self._nodes_moved(bound) for bound in self.mu)
        result = np.full((rows_below + len(values) + rows_above, *values.shape[1:]), -np.inf)
        for start in {0, rows_below, rows_below + rows_above}:
            part = result[start : start + len(values)]
            np.maximum(part, values, out=part)
        self.first -= rows_below * self.speed_step
        return result

    def _nodes_moved(self, bound):
        """Return the number of nodes by which speeds move in this step, to one side."""
        relative = self.dt * abs(bound) / self.speed_step
        every = max(int(np.ceil(1 / relative)) - 1, 1) if relative < 1 else 1
        return int(relative) + 1 if self._steps and self._steps % every == 0 else 0

    def _thin(self):
        while len(self.values) > self.max_speeds:
            self.values, self.speed_step = self.values[::2], 2 * self.speed_step

    def possible(self, arc, speeds):
        """Return whether nodes are the nearest to a heading and a speed, shape (rows, columns)."""
        half = self.speed_step / 2
        rows = (self.speeds + half >= speeds[0]) & (self.speeds - half <= speeds[1])
        apart = angle_between(self.headings - arc[0] - arc[1] / 2) - arc[1] / 2
        return rows[:, None] & (apart <= self.heading_step / 2 * (1 + 1e-9))

    def trim(self):
        """Drop empty rows at the ends; add nodes of speed where too few are left."""
        if self.counted_from == "measurement":
            self._steps = 0
        rows = np.flatnonzero(~np.isneginf(self.values[..., 0]).all(axis=1))
        self.values, self.first = (
            self.values[rows[0] : rows[-1] + 1],
            self.first + rows[0] * self.speed_step,
        )
        if len(self.values) < self.min_speeds:
            self.values = self.values[np.r_[0, 0 : len(self.values), -1]]
            self.first -= self.speed_step
        while len(self.values) < self.min_speeds:
            doubled = np.repeat(self.values, 2, axis=0)[:-1]
            doubled[1::2] = np.maximum(self.values[:-1], self.values[1:])
            self.values, self.speed_step = doubled, self.speed_step / 2
        self._thin()

    def sections_at(self, heading, speed):
        """Return the section of the nearest node, shape (1, m); (0, m) for a speed beyond them."""
        row = int(np.rint((speed - self.first) / self.speed_step))
        if not 0 <= row < len(self.values):
            return self.values[0, :0]
        return self.values[row, int(np.rint(heading / self.heading_step)) % len(self.headings)][
            None
        ]

    def speed_bounds(self):
        rows = np.flatnonzero(~np.isneginf(self.values[..., 0]).all(axis=1))
        return float(self.speeds[rows[0]]), float(self.speeds[rows[-1]])

    def heading_bounds(self):
        columns = ~np.isneginf(self.values[..., 0]).all(axis=0)
        return (0.0, FULL) if columns.all() else covering_arc(self.headings[columns])
