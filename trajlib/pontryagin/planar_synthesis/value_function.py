"""The value function: the least cost to the target from overlapping families of extremals.

Neighbouring extremals and neighbouring times make cells; a point of the plane may lie in none (the
target is not reached), in one, or in several, where the extremals overlap and the least cost
decides. Inside a cell the parameter, the time and the cost are interpolated; Newton's method on
x(s, tau) = point then makes them exact.
"""

from dataclasses import dataclass, fields

import numpy as np

from trajlib.pontryagin.planar_synthesis.newton_extremals import newton_extremals

#: Share of the window's size: cells are sorted into squares of this size to find those around a
#: point.
GRID = 192
#: How far outside of a triangle (in its barycentric coordinates) a point still counts as inside:
#: borders are curved.
SLACK = 0.02
#: Number of points at once, for which the data of all candidates stay in the processor's cache.
CHUNK = 2000
#: Largest error of an interpolated cost, in steps.
SOONEST = 1.5
#: Values of the terminal expression this close to zero count as zero.
ON_TARGET = 1e-10


@dataclass
class BestExtremals:
    """The best extremals from N points, an array for each quantity.

    Attributes
    ----------
    cost, time, s : ndarray, shape (N,)
        The cost (inf where there is none), the duration, the parameter.
    mode, fan, sequence : ndarray of int, shape (N,)
        Mode at the point, fan (-1 where there is none), control sequence.
    control : ndarray, shape (N, k)
        At the point.
    """

    cost: np.ndarray
    time: np.ndarray
    mode: np.ndarray
    control: np.ndarray
    fan: np.ndarray
    s: np.ndarray
    sequence: np.ndarray

    @classmethod
    def none(cls, size, controls):
        """Return the record of points without extremals."""
        mode, fan, sequence = (np.full(size, -1) for _ in range(3))
        return cls(
            np.full(size, np.inf),
            np.full(size, np.nan),
            mode,
            np.full((size, controls), np.nan),
            fan,
            np.full(size, np.nan),
            sequence,
        )

    def at(self, indices):
        """Return those of some of the points."""
        return BestExtremals(*(getattr(self, f.name)[indices] for f in fields(self)))

    def assign(self, indices, replacements):
        """Replace those of some points by others."""
        for f in fields(self):
            getattr(self, f.name)[indices] = getattr(replacements, f.name)


class ValueFunction:
    """All triangles of several fans, with a search for those that contain given points."""

    def __init__(self, fans, window):
        self.fans, self.plant = fans, fans[0].plant
        (left, right), (bottom, top) = window
        self.corner = np.array([left, bottom])
        self.square = np.array([right - left, top - bottom]) / GRID
        parts = [self._triangles(number, fan) for number, fan in enumerate(fans)]
        self.points = np.concatenate([p[0] for p in parts])  # (M, 3, 2)
        # (M, 3, 3): s, tau, cost at the corners
        self.values = np.concatenate([p[1] for p in parts])
        # (M, 3): the structures so far
        self.sequence = np.concatenate([p[2] for p in parts])
        self.fan = np.concatenate([p[3] for p in parts])
        #: Approximate cost of a step of time.
        self.step_cost = self.fans[0].times[1] * self._usual_price()
        s = self.values[:, :, 0]
        low, high = (
            np.array([getattr(fan.ends, side) for fan in fans])[self.fan]
            for side in ("low", "high")
        )
        self.last = (s.min(axis=1) <= low) | (s.max(axis=1) >= high)
        self._sort()

    @staticmethod
    def _triangles(number, fan):
        """Return the corners of a fan's triangles, their (s, tau, cost), sequences and fan numbers."""
        steps = np.arange(fan.times.size - 1)[:, None]
        # A cell belongs to the fan if one of its extremals has not ended before it; its other end
        # may be the step beyond.
        active = steps < np.maximum(fan.last_step + 1, 0)[None, :]
        active &= (fan.last_step > 0)[None, :]
        either = active[:, :-1] | active[:, 1:]
        k, j = np.nonzero(either)
        corners = [(k, j), (k, j + 1), (k + 1, j), (k + 1, j + 1)]
        x = np.array([fan.path[a, :, b] for a, b in corners])
        parameters = np.array(
            [np.stack([fan.s[b], fan.times[a], fan.value[a, b]], axis=-1) for a, b in corners]
        )
        # A border of the first mode is an extremal of the fan; for the cell on its other side it
        # has switched once, at its end.
        middle = (fan.s[:-1] + fan.s[1:]) / 2
        first = (fan.start(middle)[1] if middle.size else np.empty(0, int))[j]
        inside = first >= 0
        k, j, first, parameters, x = (
            k[inside],
            j[inside],
            first[inside],
            parameters[:, inside],
            x[:, inside],
        )
        corners = [(k, j), (k, j + 1), (k + 1, j), (k + 1, j + 1)]
        sequences = np.array([_seen_from(fan, first, a, b) for a, b in corners])
        points = np.concatenate([x[[0, 1, 2]], x[[1, 3, 2]]], axis=1).transpose(1, 0, 2)
        values = np.concatenate([parameters[[0, 1, 2]], parameters[[1, 3, 2]]], axis=1).transpose(
            1, 0, 2
        )
        sequences = np.concatenate([sequences[[0, 1, 2]], sequences[[1, 3, 2]]], axis=1).T
        a, b = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
        area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
        size = np.maximum((a**2).sum(axis=1), (b**2).sum(axis=1))
        keep = np.isfinite(area) & (area > 1e-9 * size) & (area > 0) & (sequences >= 0).all(axis=1)
        return points[keep], values[keep], sequences[keep], np.full(keep.sum(), number)

    def _usual_price(self):
        """Return about what a unit of time costs."""
        if self.plant.counts_time:
            return 1.0
        prices = [np.abs(np.diff(fan.value, axis=0)).ravel() / fan.times[1] for fan in self.fans]
        prices = np.concatenate(prices)
        # Where only the terminal cost counts, its range gives the size of a difference.
        ends = np.ptp(np.concatenate([fan.value[0] for fan in self.fans]))
        return float(np.median(prices[np.isfinite(prices)])) + float(ends) / self.fans[0].times[-1]

    def _sort(self):
        # A corner, two edges and their determinant, in one row each, since rows are fetched in any
        # order.
        """Sort the triangles into the squares of the grid that they meet."""
        corner, edges = self.points[:, 0], self.points[:, 1:] - self.points[:, :1]
        (a1, a2), (b1, b2) = edges[:, 0].T, edges[:, 1].T
        self._shape = np.column_stack([corner, a1, a2, b1, b2, a1 * b2 - a2 * b1])
        low = self._square(self.points.min(axis=1) - SLACK * np.ptp(self.points, axis=1))
        high = self._square(self.points.max(axis=1) + SLACK * np.ptp(self.points, axis=1))
        inside = ((high >= 0) & (low < GRID)).all(axis=1)
        low, high = np.clip(low, 0, GRID - 1), np.clip(high, 0, GRID - 1)
        wide = np.where(inside[:, None], high - low + 1, 0)
        count = wide[:, 0] * wide[:, 1]
        triangle = np.repeat(np.arange(count.size), count)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        column = low[triangle, 0] + within % np.maximum(wide[triangle, 0], 1)
        row = low[triangle, 1] + within // np.maximum(wide[triangle, 0], 1)
        cell = row * GRID + column
        order = np.argsort(cell, kind="stable")
        self._in_cell = triangle[order]
        self._begin = np.searchsorted(cell[order], np.arange(GRID**2 + 1))

    def _square(self, points):
        return np.floor((points - self.corner) / self.square).astype(int)

    def candidates(self, x, slack=SLACK):
        """Return pairs (point, triangle) with (s, tau, cost) there, for points (2, N)."""
        begins = range(0, max(x.shape[1], 1), CHUNK)
        parts = [self._candidates(x[:, begin : begin + CHUNK], slack) for begin in begins]
        points, triangles, values = zip(*parts)
        points = [begin + point for begin, point in zip(begins, points)]
        return np.concatenate(points), np.concatenate(triangles), np.hstack(values)

    def _candidates(self, x, slack):
        square = np.clip(self._square(x.T), -1, GRID)
        # The upper and the right edge belong to the window.
        square -= (square == GRID) & (x.T <= self.corner + GRID * self.square * (1 + 1e-9))
        ok = ((square >= 0) & (square < GRID)).all(axis=1)
        cell = np.where(ok, square[:, 1] * GRID + square[:, 0], 0)
        begin, end = self._begin[cell], np.where(ok, self._begin[cell + 1], self._begin[cell])
        count = end - begin
        point = np.repeat(np.arange(count.size), count)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        triangle = self._in_cell[np.repeat(begin, count) + within]
        x1, x2, a1, a2, b1, b2, det = self._shape[triangle].T
        d1, d2 = np.repeat(x[0], count) - x1, np.repeat(x[1], count) - x2
        v = (d1 * b2 - d2 * b1) / det
        w = (a1 * d2 - a2 * d1) / det
        inside = (v >= -slack) & (w >= -slack) & (v + w <= 1 + slack)
        # The cells of a fan reach beyond the target, where its extremals have ended already.
        inside &= self._outside(x)[self.fan[triangle], point]
        point, triangle, v, w = point[inside], triangle[inside], v[inside], w[inside]
        share = np.stack([1 - v - w, v, w], axis=-1)
        value = (share[:, :, None] * self.values[triangle]).sum(axis=1)
        return point, triangle, value.T

    def _outside(self, x):
        """Check whether points (2, N) lie on the side from which each fan comes: (fans, N)."""
        return np.array([fan.target.outside(x, fan.ends.side) > -ON_TARGET for fan in self.fans])

    def interpolated(self, x, slack=SLACK):
        """Return the least interpolated cost at points (2, N), its triangle, s and tau.

        Where there is none, the cost is inf and the triangle -1.
        """
        point, triangle, (s, tau, cost) = self.candidates(x, slack)
        least, best = np.full(x.shape[1], np.inf), np.full(x.shape[1], -1)
        parameters = np.full((2, x.shape[1]), np.nan)
        order = np.lexsort((-cost, point))  # the last one written is the cheapest
        least[point[order]], best[point[order]] = cost[order], triangle[order]
        parameters[:, point[order]] = s[order], tau[order]
        return least, best, *parameters

    def modes(self, triangle):
        """Return the modes in triangles (N,), -1 where there is none.

        Where the corners differ it is that of the corner with the middle number of switchings.
        """
        sequences = self.plant.sequences
        corner = np.argsort(sequences.length[self.sequence[triangle]], axis=1, kind="stable")[:, 1]
        return np.where(triangle >= 0, sequences.mode[self.sequence[triangle, corner]], -1)

    def exact(self, x):
        """Return the best extremals from points (2, N)."""
        best = self.by_newton(x)
        self._interpolate_failures(x, best)
        return best

    def by_newton(self, x):
        """Return the best extremals from points (2, N) that Newton's method finds."""
        best = BestExtremals.none(x.shape[1], len(self.plant.controls))
        self._newton(x, np.arange(x.shape[1]), best, SOONEST)
        # Where the cheapest cells only seemed to contain the point, others count too.
        self._newton(x, np.flatnonzero(~np.isfinite(best.cost)), best, np.inf)
        return best

    def _newton(self, x, indices, best, later):
        """Apply Newton's method in cells that are at most `later` steps behind the cheapest."""
        point, triangle, s, tau = self._distinct(x[:, indices], later)
        point = indices[point]
        # Newton's method starts inside of the cell: at its edge the family may have a fold.
        corner = self.values[triangle][:, :, 0]
        low, width = corner.min(axis=1), np.ptp(corner, axis=1)
        s = np.clip(s, low + 0.1 * width, low + 0.9 * width)
        for number, family in enumerate(self.fans):
            members = np.flatnonzero(self.fan[triangle] == number)
            if not members.size:
                continue
            pick, sequences = self.plant.sequences.between(self.sequence[triangle[members]])
            members = members[pick]
            exact_s, exact_tau, cost, modes, controls, ok = newton_extremals(
                family, x[:, point[members]], s[members], tau[members], sequences
            )
            order = np.flatnonzero(ok)[np.argsort(-cost[ok], kind="stable")]
            order = order[cost[order] < best.cost[point[members[order]]]]
            # the last one written is the cheapest
            for_point = point[members[order]]
            for name, values in (
                ("cost", cost),
                ("time", exact_tau),
                ("mode", modes),
                ("s", exact_s),
                ("sequence", sequences),
                ("control", controls),
            ):
                getattr(best, name)[for_point] = values[order]
            best.fan[for_point] = number

    def _interpolate_failures(self, x, best):
        """Keep the interpolated values where Newton's method failed inside of a cell (near a fold).

        Not in the last cells of a family: their edges are chords of its last extremal, and reach a
        little beyond it.
        """
        open_ = np.flatnonzero(~np.isfinite(best.cost))
        if not open_.size:
            return
        cost, triangle, s, tau = self.interpolated(x[:, open_], slack=0)
        inner = (triangle >= 0) & ~self.last[triangle]
        open_, triangle, s, tau = open_[inner], triangle[inner], s[inner], tau[inner]
        best.cost[open_], best.time[open_], best.fan[open_] = (
            cost[inner],
            tau,
            self.fan[triangle],
        )
        best.mode[open_] = self.modes(triangle)
        for number, family in enumerate(self.fans):
            members = np.flatnonzero(self.fan[triangle] == number)
            if members.size:
                z, _ = family.flow(s[members], tau[members])
                best.control[open_[members]] = self.plant.control(z, best.mode[open_[members]]).T

    def _distinct(self, x, later):
        """Return the candidates that may be best: the cheapest of each sequence, if not far behind."""
        point, triangle, (s, tau, cost) = self.candidates(x)
        sequences = self.sequence[triangle]
        kind = self.fan[triangle] * (self.plant.sequences.length.size + 1)
        if triangle.size:
            kind = (
                kind
                + sequences[
                    np.arange(triangle.size), self.plant.sequences.length[sequences].argmin(axis=1)
                ]
            )
        order = np.lexsort((cost, kind, point))
        point, triangle, s, tau, cost, kind = (
            v[order] for v in (point, triangle, s, tau, cost, kind)
        )
        if not point.size:
            return point, triangle, s, tau
        new = np.append(True, (np.diff(point) != 0) | (np.diff(kind) != 0))
        rank = np.arange(point.size) - np.flatnonzero(new)[np.cumsum(new) - 1]
        least = np.full(x.shape[1], np.inf)
        np.minimum.at(least, point, cost)
        # A few cells of each sequence: a point next to the border of one may belong to its
        # neighbour.
        keep = (rank < 4) & (cost < least[point] + later * self.step_cost)
        return point[keep], triangle[keep], s[keep], tau[keep]


def _seen_from(fan, first, steps, columns):
    """Return the sequences at corners of cells that begin with the modes `first`."""
    sequences, root = fan.sequence[steps, columns], fan.mode[0, columns]
    changed = np.flatnonzero((root != first) & (sequences >= 0))
    if changed.size:
        sequences = sequences.copy()
        sequences[changed] = fan.plant.sequences.prefixed(first[changed], sequences[changed])
    # The extremal itself may be singular: it does not move, and only its end is a corner.
    singular = (sequences < 0) & (steps == 0)
    sequences = np.where(singular, fan.plant.sequences.after(-1, first), sequences)
    return sequences
