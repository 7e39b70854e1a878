"""The shortest time from any start to a convex target, by support functions, without any law.

The plant is x' = Ax + bu with u between two bounds, the state is a point of the plane, and the
target is a point, a segment, a line, or the border of a convex set. Before the first time at which
the set R(T) of reachable states meets a convex D there is a line between the two; so the shortest
time is the first T at which, for every direction p,

    min p.y over R(T) = p.e^{AT}x0 + int_0^T min_u (p.e^{As}b u) ds  <=  sup p.y over D.

From inside D the border is met when for some direction the farthest point of R(T) is as far as that
of D. Both are exact, and neither a law nor a shooting comes in.
"""

import functools

import numpy as np

from workbook.checks.references.optima.separating_lines import WIDE, SeparatingLines
from workbook.checks.references.optima.state_batch import StateBatch, directions, rows_of
from workbook.checks.tools.line_search import golden_section

#: Times up to this one are looked at closely, and up to twenty times as long roughly, where it is
#: asked whether a target is in reach.
HORIZON = 20.0
NEAR, FAR = HORIZON * (np.arange(1, 131) / 130) ** 1.6, HORIZON * 1.1 ** np.arange(1, 33)
TIMES = np.concatenate([NEAR, FAR])
#: Times further apart than this are so far apart that the best line may have turned away in
#: between.
LONG = 0.3
#: How many starts are looked at together: fewer take nearly the same time, more need much memory.
TOGETHER = 640
#: What is found from each start; starts that agree to so many decimals are the same, and so many
#: are kept.
FOUND, SAME, KEPT = ("time", "control", "switching", "angle"), 12, 5_000


class FastestTimes(SeparatingLines):
    """The fastest times of a plant to a convex target, and how the fastest motions begin."""

    def __init__(self, plant, convex):
        super().__init__(plant, convex)
        #: What has been found from a start, since the same law in other words leads through the
        #: same states.
        self._known = {}

    @functools.cached_property
    def _near(self):
        return self._carried(NEAR)

    @functools.cached_property
    def _far(self):
        return self._carried(FAR)

    def _moments(self, far):
        yield from self._near
        # An oscillator's control switches often in long times: they cost more than all the near
        # ones, and are seldom needed.
        yield from self._far if far else ()

    def _carried(self, times):
        """Return for times T, directions p: (T, p.e^{AT}, least and largest p.y reached from 0)."""
        p = directions(self._angles)
        rows = np.tile(p, (len(times), 1)), np.repeat(times, len(p))
        least, most = (self.plant.extreme(*rows, sign).reshape(len(times), -1) for sign in (-1, 1))
        return list(
            zip(times, np.einsum("ki,tij->tkj", p, self.plant.exponential(times)), least, most)
        )

    def solve(self, x, case, far=False):
        """Return the optimum from each start.

        Parameters
        ----------
        x : numpy.ndarray, shape (k, 2)
            The starts.
        case : numpy.ndarray, shape (k,)
            The case of the parameters of each.
        far : bool
            Whether times beyond the horizon count, too.

        Returns
        -------
        StateBatch
            With `time` (inf if the target is out of reach), the `control` at first, the `switching`
            function there, and the `angle` of the separating line.
        """
        x, case = np.asarray(x, dtype=float), np.asarray(case)
        inside = self.convex.inside(x, case)
        starts = [(far, *start) for start in np.column_stack([x.round(SAME), case]).tolist()]
        if len(self._known) > KEPT:
            self._known.clear()
        fresh = np.array(
            [k for k, start in enumerate(starts) if start not in self._known], dtype=int
        )
        for group in np.split(fresh, range(TOGETHER, len(fresh), TOGETHER)) if len(fresh) else ():
            solved = self._solve(x[group], case[group], inside[group], far)
            rows = np.column_stack([getattr(solved, name) for name in FOUND]).tolist()
            self._known.update(zip([starts[k] for k in group], rows))
        solved = np.array([self._known[start] for start in starts]).reshape(-1, len(FOUND)).T
        return StateBatch(x=x, case=case, inside=inside, **dict(zip(FOUND, solved)))

    def _solve(self, x, case, inside, far, careful=False):
        starts = x, case, inside
        low, high, theta, second = self._first_met(*starts, far, careful)
        self._shorten(low, high, theta, *starts)
        time, met = np.full(len(x), np.inf), np.isfinite(high)
        apart = (
            []
            if careful
            else self._still_apart(np.flatnonzero(met & ~inside), high, theta, *starts)
        )
        met[apart] = False
        time[met], theta[met] = self._refine(*rows_of(met, *starts, low, high, theta))
        self._try_elsewhere(np.flatnonzero(met & inside), low, second, time, theta, *starts)
        if len(apart):
            closer = self._solve(*rows_of(apart, *starts), far, careful=True)
            time[apart], theta[apart] = closer.time, closer.angle
        impulse = self.plant.response(np.where(np.isfinite(time), time, 0))[0]
        switching = (impulse * directions(theta)).sum(axis=1) * np.where(inside, -1, 1)
        return StateBatch(
            x=x,
            case=case,
            inside=inside,
            time=time,
            control=np.where(switching > 0, *self.plant.bounds),
            switching=switching,
            angle=theta,
        )

    def _first_met(self, x, case, inside, far, careful):
        """Return (low, high, theta, second): R(T) meets D first between the times low and high.

        From outside, theta is the last line that separates; from inside, the direction in which R(T) gets
        through D first, and second another one, if there is one. `careful`: lines between the directions
        tried count, too.
        """
        n, p = len(x), directions(self._angles)
        low, high, theta, second, todo = (
            np.full(n, np.inf),
            np.full(n, np.inf),
            np.zeros(n),
            np.zeros(n),
            np.arange(n),
        )
        support, outward, state = self._supports(p, x, case), inside, x.T
        before, suspects = p @ state - support, []
        line = self._middle(before) if careful else None
        # the distance of x and D, later R(T) and D, at the last two times
        apart = np.array([np.full(n, np.inf), before.max(axis=0)])
        for j, (T, carried, least, most) in enumerate(self._moments(far)):
            gap = carried @ state - support
            gap += (
                np.where(outward, most[:, None], least[:, None])
                if outward.any()
                else least[:, None]
            )
            best = gap.argmax(axis=0)
            distance = largest = gap[best, np.arange(len(todo))]
            if careful:
                largest, line_before = distance.copy(), line
                line = np.where(outward, self._angles[best], self._middle(gap))
                self._look_between(
                    np.flatnonzero(~outward & (largest <= 0)),
                    T,
                    line_before,
                    largest,
                    line,
                    *rows_of(todo, x, case, inside),
                )
            hit = np.where(outward, largest >= 0, largest <= 0)
            if j and not self.convex.point:
                # A distance that falls and rises again may have been zero in between, if it does so
                # steeply enough.
                drop, rise = (
                    np.where(np.isfinite(apart[0]), apart[0], apart[1]) - apart[1],
                    distance - apart[1],
                )
                dip = np.flatnonzero(
                    ~outward & (drop >= 0) & (rise > 0) & (apart[1] <= 2 * np.maximum(drop, rise))
                )
                suspects.append(
                    (
                        todo[dip],
                        np.full(len(dip), TIMES[j - 2] if j > 1 else 0.0),
                        np.full(len(dip), T),
                    )
                )
            apart = np.array([apart[1], distance])
            if hit.any():
                here, out = todo[hit], outward[hit]
                high[here] = T
                # From inside, a direction between those tried may have got through one or two of
                # the times before.
                low[here] = np.where(
                    out, TIMES[j - 3] if j > 2 else 0.0, TIMES[j - 1] if j else 0.0
                )
                theta[here] = line_before[hit] if careful else self._middle(before[:, hit])
                if out.any():
                    through, now, then = here[out], gap[:, hit][:, out], before[:, hit][:, out]
                    with np.errstate(all="ignore"):
                        share = np.where(now >= 0, -then / (now - then), np.inf)
                    theta[through] = self._angles[share.argmin(axis=0)]
                    second[through] = self._angles[self._other_top(now, theta[through])]
                on = ~hit
                todo, support, outward, state, gap = (
                    todo[on],
                    support[:, on],
                    outward[on],
                    state[:, on],
                    gap[:, on],
                )
                apart, line = apart[:, on], line[on] if careful else None
                if not len(todo):
                    break
            before = gap
        self._dips(suspects, low, high, theta, x, case, inside)
        return low, high, theta, second

    def _look_between(self, maybe, T, line, largest, angle, *starts):
        """Put into largest and angle, for rows `maybe`, a separating line between directions.

        It is the last one, one close to it, or one close to the best of those tried.
        """
        tried = angle[maybe].copy()
        starts, T = rows_of(maybe, *starts), np.full(len(maybe), T)
        angle[maybe], largest[maybe] = line[maybe], self._gap(line[maybe], T, *starts)
        for around in (line[maybe], tried):
            left = np.flatnonzero(largest[maybe] <= 0)
            angle[maybe[left]], largest[maybe[left]] = self._best(
                around[left], *rows_of(left, T, *starts), np.full(len(left), WIDE), 30, enough=0
            )

    def _still_apart(self, here, high, theta, *starts):
        """Return rows for which a line between the directions tried separates at the time high.

        For them all times have to be examined more closely.
        """
        if not self._spacing or not len(here):
            return here[:0]
        return here[
            self._best(*rows_of(here, theta, high, *starts), np.full(len(here), WIDE), 26)[1] > 0
        ]

    def _try_elsewhere(self, here, low, second, time, theta, *starts):
        """Put into time and theta where R(T) gets through the border elsewhere, but sooner."""
        if not self._spacing or not len(here):
            return
        width = np.full(len(here), 0.2)
        here = here[self._best(*rows_of(here, second, time, *starts), width, 16)[1] > -1e-6]
        if len(here):
            other, angle = self._refine(*rows_of(here, *starts, low, time, second))
            sooner = (self._gap(angle, other, *rows_of(here, *starts)) > -1e-6) & (
                other < time[here]
            )
            time[here], theta[here] = (
                np.where(sooner, other, time[here]),
                np.where(sooner, angle, theta[here]),
            )

    def _dips(self, suspects, low, high, theta, x, case, inside):
        """Put into low, high and theta where R(T) meets a thin D only between two of the times.

        There the distance has a dip.
        """
        if not any(len(here) for here, *_ in suspects):
            return
        here, first, last = (np.concatenate(column) for column in zip(*suspects))
        K, (x, case, inside) = len(self._angles), rows_of(here, x, case, inside)

        def gaps_of(T, rows=slice(None)):
            starts = (
                np.tile(part[rows], (K, 1) if part.ndim > 1 else K) for part in (x, case, inside)
            )
            return self._gap(np.repeat(self._angles, len(T)), np.tile(T, K), *starts).reshape(
                K, len(T)
            )

        def distance(T, rows=slice(None)):
            gaps = gaps_of(T, rows)
            if not self._spacing:
                return gaps.max(axis=0)
            angle = self._angles[gaps.argmax(axis=0)]
            best = self._best(
                angle, T, x[rows], case[rows], inside[rows], np.full(len(T), WIDE), 16
            )[1]
            return np.maximum(best, gaps.max(axis=0))

        closest = golden_section(
            lambda T, rows: -distance(T, rows), (first + last) / 2, (last - first) / 2, 12
        )
        line, through = self._middle(gaps_of(first)), distance(closest) <= 0
        for k in np.flatnonzero(through)[::-1]:  # the earliest last
            if not closest[k] > high[here[k]]:
                low[here[k]], high[here[k]], theta[here[k]] = first[k], closest[k], line[k]

    def _other_top(self, gap, angle):
        """Return the index of another direction in which the gap has a local maximum."""
        top = (gap >= np.roll(gap, 1, axis=0)) & (gap >= np.roll(gap, -1, axis=0))
        return np.where(top & (np.cos(self._angles[:, None] - angle) < 0.95), gap, -np.inf).argmax(
            axis=0
        )

    def _likely(self, T, x, case, inside):
        """Return the direction, of every fourth, with the largest gap, close to the best line."""
        angles, n = self._angles[::4], len(x)
        rows = np.tile(np.arange(n), len(angles))
        gaps = self._gap(np.repeat(angles, n), T[rows], x[rows], case[rows], inside[rows]).reshape(
            len(angles), n
        )
        return angles[gaps.argmax(axis=0)]

    def _shorten(self, low, high, theta, x, case, inside):
        """Halve long times in low and high, until the best line cannot turn away in between."""
        while (
            len(here := np.flatnonzero(~inside & np.isfinite(high) & (high - low > LONG)))
            and self._spacing
        ):
            T, starts = (low[here] + high[here]) / 2, (x[here], case[here], inside[here])
            angles, gaps = zip(
                *(
                    self._best(around, T, *starts, np.full(len(T), WIDE), 26)
                    for around in (theta[here], self._likely(T, *starts))
                )
            )
            apart = np.maximum(*gaps) > 0
            low[here], high[here] = np.where(apart, T, low[here]), np.where(apart, high[here], T)
            theta[here] = np.where(apart, np.where(gaps[0] > gaps[1], *angles), theta[here])

    def missing(self, x, case, left, inside):
        """Return the distance from the target at the best time within the times `left`."""
        n, p, steps = len(x), directions(self._angles), 16
        best, when, angle = np.full(n, np.inf), left, np.zeros(n)
        rows, sign = np.repeat(p, n, axis=0), np.tile(np.where(inside, 1, -1), len(p))
        support = self._supports(p, x, case)
        for T in left * (np.arange(1, steps + 1) / steps)[:, None]:
            moved = self.plant.free(x, T)
            gaps = (
                p @ moved.T
                + self.plant.extreme(rows, np.tile(T, len(p)), sign).reshape(len(p), n)
                - support
            )
            top = np.where(inside, -gaps.max(axis=0), gaps.max(axis=0))
            better = top < best
            best, when = np.where(better, top, best), np.where(better, T, when)
            angle = np.where(better, self._angles[gaps.argmax(axis=0)], angle)
        width = np.full(n, WIDE)

        def apart(T, rows=slice(None)):
            starts = (part[rows] for part in (x, case, inside, width))
            gap = self._best(angle[rows], np.clip(T, 1e-9, left[rows]), *starts, 24)[1]
            return np.where(inside[rows], -gap, gap)

        closest = golden_section(lambda T, rows: -apart(T, rows), when, left / steps, steps=12)
        return np.minimum(apart(closest), apart(when))
