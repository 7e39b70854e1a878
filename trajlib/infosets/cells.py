"""Guaranteed step: each node represents a closed cell of headings and speeds.

Rounding is outwards. A cell is |psi - psi_j| <= a, |V - V_l| <= b, with a = dpsi/2, b = dV/2. Before
and after a step of the length D there are numbers c_V and, for each row l of speeds, c_l >= 0, such
that **for each state (x, y, psi, V) compatible with the measurements the section of each cell that
contains some (psi*, V*) with |V* - V| <= c_V and |psi* - psi| <= c_l, l the cell's row, contains
(x, y).** In words, each state has been given to all cells that are so near to it, the *lead*.

- *Speed.* V changes by D (mu1 + mu2)/2, by which the nodes move, and by up to g = D (mu2 - mu1)/2 to
  either side. Sections go to the q rows below and above, q the least number with

      c_V' = c_V + q dV - g >= 0.

  A new V* within c_V' of V(D) lies within g + c_V' = c_V + q dV of V(0): it is q rows from a V*
  within c_V of V(0).
- *Heading.* |psi(s) - psi(0)| <= kappa s, kappa = k/V_min, with V_min the smallest speed of a row's
  states in the step. For the same reason a section goes from the row l to the r nearest headings of
  the row l' on both sides, with any c_l' >= 0 and r the least number such that

      c_l + r dpsi >= kappa_l D + c_l'.

  The fraction of a cell by which a step goes beyond what is possible is so carried to the next one.
  c_l' is what the greatest possible turn R_l' = max (R_l + kappa_l D), over the rows l that lead to
  l', lacks of a whole number of cells. Then no state's way of turning spreads further than R_l'
  rounded up to whole cells.
- *Position.* States that count on the cell have |psi - psi_j| <= a + c_l and |V - V_l| <= b + c_V. For
  each normal n = (sin phi, cos phi) and d = |psi_j - phi|

      n (displacement) = integral of V(s) cos(psi(s) - phi) <= integral of V(s) c(s) <= integral of
      Vmax c+ - Vmin c-,

  where c(s) = cos(max(d - a - c_l - kappa s, 0)) = c+ - c-. The last integrals have a closed form
  (`trajlib.infosets.turning`) if Vmax and Vmin are replaced by their values at the end of each of a
  few parts of the step. The support values of the section grow by this bound.
- *Measurement.* The true position lies in its sections and in the measured region, so in their
  intersection, which is never made smaller by rounding. Only cells whose intersection is empty are
  dropped. If heading or speed are measured or bounded, cells are dropped that are further than c_l
  and c_V from the measured ones.

Nodes and reaches are computed with rounding: cells are widened by a millionth of their width on each
side, and no step takes more than 4e-12 of it, so that 1e5 steps are covered. Support values are
rounded upwards.
"""

import numpy as np

from trajlib.infosets.polygons import EPS
from trajlib.infosets.sections import FULL
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

    def __init__(
        self, section, k, mu, speeds, speed_step, headings, arc, wrapped=True, limits=(0.0, np.inf)
    ):
        self.k, self.mu, self.m, self.limits = k, mu, len(section), limits
        self.heading_step, self.speed_step = FULL / headings, speed_step
        self.circle, self.wrapped = headings, wrapped
        # nodes are first + drift*elapsed + index*step: computed anew each time, so that rounding
        # does not add up
        self._first_speed, self._row, self._elapsed = speeds[0] + speed_step / 2, 0, 0.0
        self._first_heading, self._column = arc[0] + self.heading_step / 2, 0
        rows = _count(speeds[1] - speeds[0], speed_step) if speed_step else 1
        columns = min(_count(arc[1], self.heading_step), headings)
        self.values = np.tile(section, (rows, columns, 1))
        self._divisor = int(np.lcm(headings, self.m))
        # In nodes: the greatest turn of each row, of which only the fraction counts, and the lead
        # in speed.
        self._turned, self._speed_lead = np.zeros(rows), 0.0

    @property
    def speeds(self):
        """Nodes V_l."""
        drift = (self.mu[0] + self.mu[1]) / 2
        return (
            self._first_speed
            + drift * self._elapsed
            + self.speed_step * (self._row + np.arange(len(self.values)))
        )

    @property
    def headings(self):
        """Nodes psi_j, not reduced to [0, 2 pi)."""
        return self._first_heading + self.heading_step * (
            self._column + np.arange(self.values.shape[1])
        )

    @property
    def _heading_lead(self):
        """Leads c_l of all rows, in nodes."""
        return _lead(self._turned)

    @property
    def _half_speed(self):
        """Distance in speed from a node within which states count on its row: b + c_V."""
        return (WIDER / 2 + self._speed_lead) * self.speed_step

    @property
    def _half_heading(self):
        """Distances in heading from a node within which states count on it: a + c_l."""
        return (WIDER / 2 + self._heading_lead) * self.heading_step

    def advance(self, step, elapsed):
        """Advance by a step that ends at the time `elapsed` since the start."""
        least, greatest = self.speed_bounds()
        low = np.maximum(self.speeds - self._half_speed, least)
        high = np.minimum(self.speeds + self._half_speed, greatest)
        slowest = np.maximum(low + self.mu[0] * step, self.limits[0])
        if slowest[0] <= 0:
            raise ValueError(
                f"the least possible speed after the next step is {slowest[0]:.4g}, but the model "
                "needs V > 0; measure earlier, begin with higher speeds, or give speed_limits"
            )
        turn = self.k * step / slowest
        if turn[0] >= np.pi:
            raise ValueError(
                f"dt: a step may turn the slowest vehicle by {turn[0]:.3g} rad, more than half a "
                f"circle; take dt below {step * np.pi / turn[0]:.3g}"
            )
        grown = self.values + self._displacements(low, high, turn / step, step)
        grown += EPS * (8 * grown.max() + ROUNDED * high[-1] * step * (1 + 1 / turn[-1]))
        self._spread(grown, turn / self.heading_step, step)
        self._elapsed = elapsed
        self._drop_rows(self._rows_within(self.limits))
        self.trim()

    def _displacements(self, low, high, rate, step):
        """Return bounds on n (displacement) for all rows, columns and normals.

        The angles psi_j - phi_i are multiples of 2 pi/lcm(headings, normals) up to a constant: each
        is computed once.
        """
        shared, (rows, columns, m) = self._divisor, self.values.shape
        angle = angle_between(self.headings[0] + FULL * np.arange(shared) / shared)
        angle = angle - self._half_heading[:, None]
        total, plus, minus = np.zeros((rows, shared)), 0.0, 0.0
        parts = PARTS if self.speed_step else 1
        for end in step * np.arange(1, parts + 1) / parts:
            plus_before, minus_before = plus, minus
            plus, minus = cosine_parts(angle, rate[:, None], end)
            fast, slow = (
                np.clip(speed + mu * end, *self.limits)[:, None]
                for speed, mu in ((high, self.mu[1]), (low, self.mu[0]))
            )
            total += fast * (plus - plus_before) - slow * (minus - minus_before)
        index = np.arange(columns)[:, None] * (shared // self.circle) - np.arange(m) * (shared // m)
        return total[:, index % shared]

    def _spread(self, values, turn, step):
        """Give sections to all rows and columns that are reached, with the leads carried on."""
        wider = step * (self.mu[1] - self.mu[0]) / 2 / self.speed_step if self.speed_step else 0.0
        q = max(int(np.ceil(wider - self._speed_lead - SHORT)), 0)
        count, lead = len(values), self._heading_lead
        turned = np.full(count + 2 * q, -np.inf)
        for shift in range(2 * q + 1):
            part = turned[shift : shift + count]
            np.maximum(part, self._turned + turn, out=part)
        targets = np.arange(count)[:, None] + np.arange(2 * q + 1)
        reach = np.ceil((turn - lead)[:, None] + _lead(turned)[targets] - SHORT)
        self.values = self._hulls(values, np.maximum(reach, 0).astype(int))
        self._speed_lead = max(self._speed_lead + q - wider, 0.0)
        self._turned, self._row = turned - np.floor(turned.min()), self._row - q

    def _hulls(self, values, reach):
        """Return hulls over neighbours: row l goes to the row l + i over reach[l, i] columns."""
        max_reach, of_row = int(reach.max()), reach.max(axis=1)
        if self._closed:
            padded = np.concatenate(
                [values[:, len(values[0]) - max_reach :], values, values[:, :max_reach]], axis=1
            )
        else:
            ends = np.full((len(values), 2 * max_reach, self.m), -np.inf)
            padded = np.concatenate([ends, values, ends], axis=1)
            self._column -= max_reach
        count = padded.shape[1] - 2 * max_reach
        result = np.full((len(values) + reach.shape[1] - 1, count, self.m), -np.inf)
        hull = padded[:, max_reach : max_reach + count].copy()
        for offset in range(max_reach + 1):
            # slow rows come first and turn furthest
            going_on = slice(0, 1 + int(np.flatnonzero(of_row >= offset)[-1]))
            for start in {max_reach - offset, max_reach + offset}:
                part = hull[going_on]
                np.maximum(part, padded[going_on, start : start + count], out=part)
            for shift, reached in enumerate((reach == offset).T):
                if reached.any():
                    rows = np.flatnonzero(reached)
                    result[rows + shift] = np.maximum(result[rows + shift], hull[rows])
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

    def possible(self, arc, speeds):
        """Return whether cells hold a heading of an arc and a speed of an interval, (rows, columns)."""
        rows = self._rows_within(speeds)
        middle = arc[0] + arc[1] / 2
        apart = angle_between(self.headings - middle) - arc[1] / 2
        return rows[:, None] & (apart <= self._half_heading[:, None])

    def _rows_within(self, speeds):
        half = self._half_speed if self.speed_step else EPS * speeds[0]
        return (self.speeds + half >= speeds[0]) & (self.speeds - half <= speeds[1])

    def trim(self):
        """Drop rows and columns that are empty at the ends; open a circle in its widest gap."""
        possible = ~np.isneginf(self.values[..., 0])
        columns = np.flatnonzero(possible.any(axis=0))
        first, last = columns[0], columns[-1]
        if self._closed and len(columns) < self.circle:
            gaps = np.append(columns[1:], columns[0] + self.circle) - columns
            widest = int(np.argmax(gaps))
            first, last = columns[widest] + gaps[widest], columns[widest] + self.circle
        if last < self.values.shape[1]:
            self.values = self.values[:, first : last + 1]
        else:
            self.values = self.values[:, np.arange(first, last + 1) % self.circle]
        self._column += int(first)
        self._drop_rows(possible.any(axis=1))

    def _drop_rows(self, nonempty):
        """Drop rows at the ends."""
        rows = np.flatnonzero(nonempty)
        part = slice(rows[0], rows[-1] + 1)
        self.values, self._turned = self.values[part], self._turned[part]
        self._row += int(rows[0])

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
        """Return the interval of speeds, less the lead, within the limits."""
        rows = np.flatnonzero(~np.isneginf(self.values[..., 0]).all(axis=1))
        half = (0.5 - self._speed_lead) * self.speed_step
        low, high = sorted((self.speeds[rows[0]] - half, self.speeds[rows[-1]] + half))
        return float(max(low, self.limits[0])), float(min(high, self.limits[1]))

    def heading_bounds(self):
        """Return the arc of headings, less the lead of each row."""
        possible = ~np.isneginf(self.values[..., 0])
        rows = np.flatnonzero(possible.any(axis=1))
        half = (0.5 - self._heading_lead[rows]) * self.heading_step
        first = self.headings[possible[rows].argmax(axis=1)] - half
        last = self.headings[-1 - possible[rows, ::-1].argmax(axis=1)] + half
        low, high = float(np.minimum(first, last).min()), float(np.maximum(first, last).max())
        if self._closed or high - low >= FULL:
            return 0.0, FULL
        turns = FULL * np.floor((low + self.heading_step / 2) / FULL)
        return float(low - turns), float(high - turns)


def _count(width, step):
    return max(int(np.ceil(width / step * (1 - 1e-12))), 1)


def _lead(turned):
    """Return what turns lack of whole nodes."""
    return np.maximum(np.ceil(turned - SHORT) - turned, 0.0)
