"""The least time to the target from overlapping families of extremals.

Neighbouring extremals and neighbouring moments make cells; a point of the plane may lie in none (the target is not
reached), in one, or in several, where the extremals overlap and the shortest time decides. Inside a cell the parameter
and the time are interpolated; Newton's method on x(s, tau) = point then makes them exact.
"""
from dataclasses import dataclass, fields

import numpy as np

#: Share of the window's size: cells are sorted into squares of this size to find those around a point.
SQUARES = 96
#: How far outside of a triangle (in its barycentric coordinates) a point still counts as inside: borders are curved.
SLACK = 0.02
#: How many steps of time an interpolated time may be wrong.
SOONEST = 1.5
#: Values of the terminal expression this close to zero count as zero.
ON_TARGET = 1e-10


@dataclass
class Fastest:
    """The fastest extremals from N points, each an array (N,): `time` (inf where there is none), `sign` of the control
    at the point, `fan` (-1 where there is none), the parameter `s` there, and the structure: `first` control and
    `count` of switchings.
    """

    time: np.ndarray
    sign: np.ndarray
    fan: np.ndarray
    s: np.ndarray
    first: np.ndarray
    count: np.ndarray

    @classmethod
    def none(cls, size):
        whole = [np.zeros(size, int) for _ in range(4)]
        return cls(np.full(size, np.inf), whole[0], whole[1] - 1, np.full(size, np.nan), *whole[2:])

    def at(self, which):
        """Those from some of the points."""
        return Fastest(*(getattr(self, f.name)[which] for f in fields(self)))

    def put(self, which, others):
        """Put others in the places of some."""
        for f in fields(self):
            getattr(self, f.name)[which] = getattr(others, f.name)


class TimeField:
    """All triangles of several fans, with a search for those that contain given points."""

    def __init__(self, fans, window):
        self.fans = fans
        (left, right), (bottom, top) = window
        self.corner = np.array([left, bottom])
        self.square = np.array([right - left, top - bottom])/SQUARES
        parts = [self._triangles(number, fan) for number, fan in enumerate(fans)]
        self.points = np.concatenate([p[0] for p in parts])          # (M, 3, 2)
        self.values = np.concatenate([p[1] for p in parts])          # (M, 3, 2): s and tau at the corners
        self.count = np.concatenate([p[2] for p in parts])           # (M, 3): switchings so far
        self.first = np.concatenate([p[3] for p in parts])           # the control next to the target
        self.fan = np.concatenate([p[4] for p in parts])
        s = self.values[:, :, 0]
        low, high = (np.array([getattr(fan.ends, side) for fan in fans])[self.fan] for side in ("low", "high"))
        self.last = (s.min(axis=1) <= low) | (s.max(axis=1) >= high)
        self._sort()

    @staticmethod
    def _triangles(number, fan):
        steps = np.arange(fan.times.size - 1)[:, None]
        # A cell belongs to the fan if one of its extremals is alive at its begin; its other end may be the step beyond.
        alive = steps < np.maximum(fan.life + 1, 0)[None, :]
        alive &= (fan.life > 0)[None, :]
        either = alive[:, :-1] | alive[:, 1:]
        k, j = np.nonzero(either)
        corners = [(k, j), (k, j + 1), (k + 1, j), (k + 1, j + 1)]
        x = np.array([fan.path[a, :, b] for a, b in corners])
        s_tau = np.array([np.stack([fan.s[b], fan.times[a]], axis=-1) for a, b in corners])
        # A border of the first control is an extremal of the fan; seen from the other side it has switched once, at
        # once.
        middle = (fan.s[:-1] + fan.s[1:])/2
        first = fan.start(middle)[1] if middle.size else np.empty(0, int)
        count = np.array([fan.count[a, b] + (fan.sign[0, b] != first[j]) for a, b in corners])
        points = np.concatenate([x[[0, 1, 2]], x[[1, 3, 2]]], axis=1).transpose(1, 0, 2)
        values = np.concatenate([s_tau[[0, 1, 2]], s_tau[[1, 3, 2]]], axis=1).transpose(1, 0, 2)
        counts = np.concatenate([count[[0, 1, 2]], count[[1, 3, 2]]], axis=1).T
        first = np.tile(first[j], 2)
        a, b = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
        area = np.abs(a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0])
        size = np.maximum((a**2).sum(axis=1), (b**2).sum(axis=1))
        keep = np.isfinite(area) & (area > 1e-9*size) & (area > 0)
        return points[keep], values[keep], counts[keep], first[keep], np.full(keep.sum(), number)

    def _sort(self):
        low = self._square(self.points.min(axis=1) - SLACK*np.ptp(self.points, axis=1))
        high = self._square(self.points.max(axis=1) + SLACK*np.ptp(self.points, axis=1))
        inside = ((high >= 0) & (low < SQUARES)).all(axis=1)
        low, high = np.clip(low, 0, SQUARES - 1), np.clip(high, 0, SQUARES - 1)
        wide = np.where(inside[:, None], high - low + 1, 0)
        count = wide[:, 0]*wide[:, 1]
        triangle = np.repeat(np.arange(count.size), count)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        column = low[triangle, 0] + within % np.maximum(wide[triangle, 0], 1)
        row = low[triangle, 1] + within//np.maximum(wide[triangle, 0], 1)
        cell = row*SQUARES + column
        order = np.argsort(cell, kind="stable")
        self._in_cell = triangle[order]
        self._begin = np.searchsorted(cell[order], np.arange(SQUARES**2 + 1))

    def _square(self, points):
        return np.floor((points - self.corner)/self.square).astype(int)

    def candidates(self, x, slack=SLACK):
        """Pairs (point, triangle) with s and tau there, for points `x` of shape (2, N): four arrays and the triangle's
        signs."""
        place = np.clip(self._square(x.T), -1, SQUARES)
        ok = ((place >= 0) & (place < SQUARES)).all(axis=1)
        cell = np.where(ok, place[:, 1]*SQUARES + place[:, 0], 0)
        begin, end = self._begin[cell], np.where(ok, self._begin[cell + 1], self._begin[cell])
        count = end - begin
        point = np.repeat(np.arange(count.size), count)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        triangle = self._in_cell[np.repeat(begin, count) + within]
        corner = self.points[triangle]
        a, b = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        d = x.T[point] - corner[:, 0]
        det = a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0]
        v = (d[:, 0]*b[:, 1] - d[:, 1]*b[:, 0])/det
        w = (a[:, 0]*d[:, 1] - a[:, 1]*d[:, 0])/det
        inside = (v >= -slack) & (w >= -slack) & (v + w <= 1 + slack)
        # The cells of a fan reach beyond the target, where its extremals have ended already.
        inside &= self._outside(x)[self.fan[triangle], point]
        point, triangle, v, w = point[inside], triangle[inside], v[inside], w[inside]
        share = np.stack([1 - v - w, v, w], axis=-1)
        value = (share[:, :, None]*self.values[triangle]).sum(axis=1)
        return point, triangle, value[:, 0], value[:, 1]

    def _outside(self, x):
        """Whether points (2, N) lie on the side of the target from which each of the fans comes: (fans, N)."""
        return np.array([fan.target.outside(x, fan.ends.side) > -ON_TARGET for fan in self.fans])

    def interpolated(self, x, slack=SLACK):
        """For points (2, N): the least interpolated time (inf where there is none), its triangle (-1), s."""
        point, triangle, s, tau = self.candidates(x, slack)
        time, best, parameter = np.full(x.shape[1], np.inf), np.full(x.shape[1], -1), np.full(x.shape[1], np.nan)
        order = np.lexsort((-tau, point))            # the last one written is the shortest
        time[point[order]], best[point[order]], parameter[point[order]] = tau[order], triangle[order], s[order]
        return time, best, parameter

    def exact(self, x):
        """For points (2, N): the least time, the sign of the control there and the fan (-1 where there is none)."""
        found = self.polished(x)
        self._fall_back(x, found)
        return found.time, found.sign, found.fan

    def polished(self, x):
        """The fastest extremals from points (2, N) that Newton's method finds: `Fastest`."""
        found = Fastest.none(x.shape[1])
        self._polish(x, np.arange(x.shape[1]), found, SOONEST)
        # Where the soonest cells only seemed to contain the point, later ones count too.
        self._polish(x, np.flatnonzero(~np.isfinite(found.time)), found, np.inf)
        return found

    def _polish(self, x, which, found, later):
        """Newton's method for the points `which` in cells that are not more than `later` steps behind the soonest."""
        point, triangle, s, tau = self._distinct(x[:, which], later)
        point = which[point]
        # Newton's method starts inside of the cell: at its edge the family may have a fold.
        corner = self.values[triangle][:, :, 0]
        low, width = corner.min(axis=1), np.ptp(corner, axis=1)
        s = np.clip(s, low + 0.1*width, low + 0.9*width)
        for number, family in enumerate(self.fans):
            mine = np.flatnonzero(self.fan[triangle] == number)
            if not mine.size:
                continue
            pick, first, switchings = self.structures(triangle[mine])
            mine = mine[pick]
            exact_s, exact_tau, signs, ok = polish(family, x[:, point[mine]], s[mine], tau[mine], first, switchings)
            order = np.flatnonzero(ok)[np.argsort(-exact_tau[ok], kind="stable")]
            order = order[exact_tau[order] < found.time[point[mine[order]]]]
            for_point = point[mine[order]]                  # the last one written is the shortest
            for name, values in (("time", exact_tau), ("sign", signs), ("s", exact_s), ("first", first),
                                 ("count", switchings)):
                getattr(found, name)[for_point] = values[order]
            found.fan[for_point] = number

    def _fall_back(self, x, found):
        """Where Newton's method failed inside of a cell (next to a fold of the family) the interpolated values stand.

        Not in the last cells of a family: their edges are chords of its last extremal, and reach a little beyond it.
        """
        open_ = np.flatnonzero(~np.isfinite(found.time))
        if open_.size:
            tau, triangle, _ = self.interpolated(x[:, open_], slack=0)
            inner = (triangle >= 0) & ~self.last[triangle]
            open_, triangle = open_[inner], triangle[inner]
            found.time[open_], found.fan[open_] = tau[inner], self.fan[triangle]
            found.sign[open_] = self.first[triangle]*np.where(np.median(self.count[triangle], axis=1) % 2, -1, 1)

    def structures(self, triangle):
        """First control and numbers of switchings that occur in triangles: (which triangle, first, switchings)."""
        first, count = self.first[triangle], self.count[triangle]
        low, high = count.min(axis=1), count.max(axis=1)
        number = high - low + 1
        pick = np.repeat(np.arange(triangle.size), number)
        within = np.arange(pick.size) - np.repeat(np.cumsum(number) - number, number)
        return pick, first[pick], low[pick] + within

    def _distinct(self, x, later):
        """Of all candidates of a point those that may be the fastest: the first in time of each structure, if not far
        behind."""
        point, triangle, s, tau = self.candidates(x)
        kind = (self.fan[triangle]*2 + (self.first[triangle] > 0))*64 + self.count[triangle].min(axis=1)
        order = np.lexsort((tau, kind, point))
        point, triangle, s, tau, kind = point[order], triangle[order], s[order], tau[order], kind[order]
        if not point.size:
            return point, triangle, s, tau
        new = np.append(True, (np.diff(point) != 0) | (np.diff(kind) != 0))
        rank = np.arange(point.size) - np.flatnonzero(new)[np.cumsum(new) - 1]
        least = np.full(x.shape[1], np.inf)
        np.minimum.at(least, point, tau)
        # A few cells of each structure: a point next to the border of one may belong to its neighbour.
        keep = (rank < 4) & (tau < least[point] + later*self.fans[0].times[1])
        return point[keep], triangle[keep], s[keep], tau[keep]


def polish(fan, x, s, tau, first, switchings, rounds=20):
    """Newton's method on x(s, tau) = x for extremals of a given structure; returns s, tau, the control's sign, which
    are good.

    On a switching curve the sign is that of the control that follows.
    """
    tau, count = tau.copy(), s.size
    s = np.clip(s, fan.ends.low, fan.ends.high)
    size = np.abs(x).max(initial=0) + 1
    ds = 1e-6*(fan.ends.high - fan.ends.low)
    reach = 4*np.abs(np.diff(fan.s)).max(initial=0)
    good, begin, sign = np.zeros(count, bool), np.zeros(count), first.copy()
    busy = np.arange(count)
    for number in range(rounds):
        # One-sided where the parameter ends.
        up, down = np.minimum(s[busy] + ds, fan.ends.high), np.maximum(s[busy] - ds, fan.ends.low)
        z, last, start = fan.arcs(np.concatenate([s[busy], up, down]), np.tile(tau[busy], 3), np.tile(first[busy], 3),
                                  np.tile(switchings[busy], 3))
        n = busy.size
        here = z[:, :n]
        miss = x[:, busy] - here[:2]
        error = np.hypot(*miss)
        done = error < 1e-11*size
        # The structure must be real: the last arc has a positive length, and the control maximises on it.
        phi = fan.plant.switching(here)
        consistent = (tau[busy] >= start[:n]
                      - 1e-9) & (last[:n]*phi >= -1e-9*np.hypot(*here[2:])*(1 + np.hypot(*here[:2])))
        settled = busy[done]
        good[settled], begin[settled] = consistent[done], start[:n][done]
        on_curve = (tau[settled] - begin[settled] < 1e-8) & (switchings[settled] > 0)
        sign[settled] = np.where(on_curve, -last[:n][done], last[:n][done])
        # Whoever is still far away after some rounds belongs to another cell.
        go = ~done & (error < (np.inf if number < 6 else 1e-3*size))
        if not go.any():
            break
        slope = (z[:2, n:2*n] - z[:2, 2*n:])/(up - down)
        rate = -fan.plant.velocity(here[:2], last[:n])
        with np.errstate(all="ignore"):
            step_s, step_tau = _solve(slope[:, go], rate[:, go], miss[:, go])
        # Next to a fold two solutions exist, one with a last arc of negative length: such a guess is reflected.
        short = (start[:n] - tau[busy])[go]
        busy = busy[go]
        back = short > 1e-12
        step_s[back], step_tau[back] = 0, 2*short[back]
        new = s[busy] + np.clip(step_s, -reach, reach)
        # The end of a family is approached by halves: there x(s, tau) may have a fold, at which Newton's method stops.
        new = np.where(new <= fan.ends.low, (s[busy] + fan.ends.low)/2, new)
        s[busy] = np.where(new >= fan.ends.high, (s[busy] + fan.ends.high)/2, new)
        tau[busy] = np.maximum(tau[busy] + np.clip(step_tau, -4*fan.times[1], 4*fan.times[1]), 0)
    return s, tau, sign, good


def _solve(a, b, c):
    """Solutions of a p + b q = c in the plane, columns of (2, N); where a vanishes (extremals that coincide) only q."""
    size = np.hypot(*a)
    det = a[0]*b[1] - a[1]*b[0]
    parallel = ~(np.abs(det) > 1e-10*size*np.hypot(*b)) | (size < 1e-10)
    p = (c[0]*b[1] - c[1]*b[0])/det
    q = (a[0]*c[1] - a[1]*c[0])/det
    alone = (b*c).sum(axis=0)/(b**2).sum(axis=0)
    return np.where(parallel, 0, p), np.where(parallel, alone, q)
