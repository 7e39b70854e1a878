"""Guaranteed step: each node represents a closed cell of headings and speeds.

Rounding is outwards. The invariant before and after a step: **each state (x, y, psi, V) compatible
with the measurements has a cell with (psi, V) in it whose section contains (x, y).** Let the cell
be |psi - psi_j| <= a, |V - V_l| <= b, with a = dpsi/2, b = dV/2, and the step have the length D.

- *Speed.* At the time s of the step V(s) lies between V_l - b + mu1 s and V_l + b + mu2 s. The
  nodes move by D (mu1 + mu2)/2, and dV = D (mu2 - mu1)/2, so that V(D) differs from the moved node
  by at most b + dV: it lies in the cell, or in the next one below or above. All three get the
  section.
- *Heading.* |psi(s) - psi_j| <= a + kappa s, kappa = k/V_min, with V_min the smallest speed of the
  step. So psi(D) lies in one of the cells j - r, ..., j + r, r = ceil(kappa D/dpsi). All of them
  get the section.
- *Position.* For each normal n = (sin phi, cos phi) and d = |psi_j - phi|

      n (displacement) = integral of V(s) cos(psi(s) - phi) <= integral of V(s) c(s) <= integral of
      Vmax c+ - Vmin c-,

  where c(s) = cos(max(d - a - kappa s, 0)) = c+ - c-. The last integrals have a closed form
  (`trajlib.infosets.turning`) if Vmax and Vmin are replaced by their values at the end of each of a
  few parts of the step. The support values of the section grow by this bound.
- *Measurement.* The true position lies in its section and in the measured region, so in their
  intersection, which is never made smaller by rounding. Only cells whose intersection is empty are
  dropped.

Nodes and r are computed with rounding: cells are widened by a millionth of their width on each
side, and no step takes more than 2e-12 of it, so that 1e5 steps are covered. Support values are
rounded upwards.
"""

import numpy as np

from trajlib.infosets.polygons import EPS
from trajlib.infosets.sections import FULL, covering_arc
from trajlib.infosets.turning import angle_between, cosine_parts

#: Factor of a cell's half width for the rounding of nodes and reaches, and tolerance of a reach, in
#: nodes.
WIDER, SHORT = 1 + 2e-6, 1e-12
#: Parts of a step, in each of which the bounds on the speed are constant.
PARTS = 4
#: Roundings of a displacement, relative to the way: sines, their differences over kappa, PARTS
#: sums.
ROUNDED = 64


class Cells:
    """Sections over cells of headings and speeds.

    With `speed_step` = 0 and `mu` = (0, 0) there is one row, for a known speed.
    """

    def __init__(self, section, k, mu, speeds, dt, headings, arc, wrapped=True):
        self.k, self.mu, self.dt, self.m = k, mu, dt, len(section)
        self.heading_step = FULL / headings
        self.speed_step = dt * (mu[1] - mu[0]) / 2
        self.circle, self.wrapped = headings, wrapped
        lowest, speed_width = speeds[0], speeds[1] - speeds[0]
        rows = (
            max(int(np.ceil(speed_width / self.speed_step * (1 - 1e-12))), 1)
            if self.speed_step
            else 1
        )
        # nodes are first + steps*drift + index*step: computed anew each time, so that rounding does
        # not add up
        self._first_speed, self._row, self._steps = lowest + self.speed_step / 2, 0, 0
        self._first_heading, self._column = arc[0] + self.heading_step / 2, 0
        columns = min(max(int(np.ceil(arc[1] / self.heading_step * (1 - 1e-12))), 1), headings)
        self.values = np.tile(section, (rows, columns, 1))
        self._divisor = int(np.lcm(headings, self.m))

    @property
    def speeds(self):
        """Nodes V_l."""
        drift = (self.mu[0] + self.mu[1]) / 2 * self.dt
        return (
            self._first_speed
            + drift * self._steps
            + self.speed_step * (self._row + np.arange(len(self.values)))
        )

    @property
    def headings(self):
        """Nodes psi_j, not reduced to [0, 2 pi)."""
        return self._first_heading + self.heading_step * (
            self._column + np.arange(self.values.shape[1])
        )

    def advance(self):
        lowest = self.speeds - WIDER * self.speed_step / 2
        slowest = lowest + self.mu[0] * self.dt
        if slowest[0] <= 0:
            raise ValueError(
                f"the least possible speed after the next step is {slowest[0]:.4g}, but the model "
                "needs V > 0; measure earlier, or begin with higher speeds"
            )
        turn = self.k * self.dt / slowest
        if turn[0] >= np.pi:
            raise ValueError(
                f"dt: a step may turn the slowest vehicle by {turn[0]:.3g} rad, more than half a "
                f"circle; take dt below {self.dt * np.pi / turn[0]:.3g}"
            )
        grown = self.values + self._displacements(lowest, turn / self.dt)
        grown += EPS * (8 * grown.max() + ROUNDED * self.speeds[-1] * self.dt * (1 + 1 / turn[-1]))
        grown = self._turned(grown, np.ceil(turn / self.heading_step - SHORT).astype(int))
        self.values = self._accelerated(grown) if self.speed_step else grown
        self._steps += 1

    def _displacements(self, low, rate):
        """Return bounds on n (displacement) for all rows, columns and normals.

        The angles psi_j - phi_i are multiples of 2 pi/lcm(headings, normals) up to a constant: each
        is computed once.
        """
        shared, (rows, columns, m) = self._divisor, self.values.shape
        angle = (
            angle_between(self.headings[0] + FULL * np.arange(shared) / shared)
            - WIDER * self.heading_step / 2
        )
        high = low + WIDER * self.speed_step
        total, plus, minus = np.zeros((rows, shared)), 0.0, 0.0
        parts = PARTS if self.speed_step else 1
        for end in self.dt * np.arange(1, parts + 1) / parts:
            plus_before, minus_before = plus, minus
            plus, minus = cosine_parts(angle, rate[:, None], end)
            total += (high + self.mu[1] * end)[:, None] * (plus - plus_before)
            total -= (low + self.mu[0] * end)[:, None] * (minus - minus_before)
        index = np.arange(columns)[:, None] * (shared // self.circle) - np.arange(m) * (shared // m)
        return total[:, index % shared]

    def _turned(self, values, reach):
        """Return hulls over the neighbours on both sides, `reach` of them in each row."""
        max_reach = int(reach.max())
        if self._closed:
            padded = np.concatenate([values[:, -max_reach:], values, values[:, :max_reach]], axis=1)
        else:
            ends = np.full((len(values), 2 * max_reach, self.m), -np.inf)
            padded = np.concatenate([ends, values, ends], axis=1)
            self._column -= max_reach
        count = padded.shape[1] - 2 * max_reach
        result = padded[:, max_reach : max_reach + count].copy()
        for offset in range(1, max_reach + 1):
            # slow rows come first and turn furthest
            rows = slice(0, int(np.sum(reach >= offset)))
            for start in (max_reach - offset, max_reach + offset):
                np.maximum(result[rows], padded[rows, start : start + count], out=result[rows])
        return self._folded(result) if self.wrapped else result

    @property
    def _closed(self):
        return self.wrapped and self.values.shape[1] == self.circle

    def _folded(self, values):
        """Join columns of the same heading, if there are more than a circle has."""
        if values.shape[1] <= self.circle:
            return values
        result = values[:, : self.circle].copy()
        for start in range(self.circle, values.shape[1], self.circle):
            further = values[:, start : start + self.circle]
            part = result[:, : further.shape[1]]
            np.maximum(part, further, out=part)
        return result

    def _accelerated(self, values):
        """Return hulls over the rows below and above, with a further row at either end."""
        result = np.full((len(values) + 2, *values.shape[1:]), -np.inf)
        for shift in range(3):
            part = result[shift : shift + len(values)]
            np.maximum(part, values, out=part)
        self._row -= 1
        return result

    def trim(self):
        """Drop rows and columns that are empty at the ends; open a circle in its widest gap."""
        possible = ~np.isneginf(self.values[..., 0])
        rows, columns = np.flatnonzero(possible.any(axis=1)), np.flatnonzero(possible.any(axis=0))
        first, last = columns[0], columns[-1]
        if self._closed and len(columns) < self.circle:
            gaps = np.append(columns[1:], columns[0] + self.circle) - columns
            widest = int(np.argmax(gaps))
            first, last = columns[widest] + gaps[widest], columns[widest] + self.circle
        columns_kept = np.arange(first, last + 1) % self.values.shape[1]
        self.values = self.values[rows[0] : rows[-1] + 1, columns_kept]
        self._row, self._column = self._row + int(rows[0]), self._column + int(first)

    def sections_at(self, heading, speed=None):
        """Return the sections of all cells that contain a heading and a speed, shape (count, m)."""
        rows = (
            np.flatnonzero(np.abs(self.speeds - speed) <= WIDER * self.speed_step / 2)
            if self.speed_step
            else [0]
        )
        columns = np.flatnonzero(
            angle_between(self.headings - heading) <= WIDER * self.heading_step / 2
        )
        return self.values[np.ix_(rows, columns)].reshape(-1, self.m)

    def speed_bounds(self):
        rows = np.flatnonzero(~np.isneginf(self.values[..., 0]).all(axis=1))
        return (
            float(self.speeds[rows[0]] - self.speed_step / 2),
            float(self.speeds[rows[-1]] + self.speed_step / 2),
        )

    def heading_bounds(self):
        columns = ~np.isneginf(self.values[..., 0]).all(axis=0)
        if self._closed and columns.all():
            return 0.0, FULL
        low, high = covering_arc(self.headings[columns] % FULL)
        half = self.heading_step / 2
        return (low - half, high + half) if high - low + 2 * half < FULL else (0.0, FULL)
