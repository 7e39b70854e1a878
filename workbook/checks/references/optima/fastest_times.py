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
        #: Results by start, since equivalent laws lead through the same states.
        self._solved_starts = {}

    @functools.cached_property
    def _near_supports(self):
        return self._supports_at(NEAR)

    @functools.cached_property
    def _far_supports(self):
        return self._supports_at(FAR)

    def _moments(self, far):
        yield from self._near_supports
        # An oscillator's control switches often in long times: they cost more than all the near
        # ones, and are seldom needed.
        yield from self._far_supports if far else ()

    def _supports_at(self, times):
        """Return for times T, directions p: (T, p.e^{AT}, least and largest p.y reached from 0)."""
        p = directions(self._angles)
        rows = np.tile(p, (len(times), 1)), np.repeat(times, len(p))
        least, greatest = (
            self.plant.extreme(*rows, sign).reshape(len(times), -1) for sign in (-1, 1)
        )
        return list(
            zip(times, np.einsum("ki,tij->tkj", p, self.plant.exponential(times)), least, greatest)
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
            With `time` (inf if the target is unreachable), the `control` at first, the `switching`
            function there, and the `angle` of the separating line.
        """
        x, case = np.asarray(x, dtype=float), np.asarray(case)
        inside = self.convex.inside(x, case)
        starts = [(far, *start) for start in np.column_stack([x.round(SAME), case]).tolist()]
        if len(self._solved_starts) > KEPT:
            self._solved_starts.clear()
        new_indices = np.array(
            [k for k, start in enumerate(starts) if start not in self._solved_starts], dtype=int
        )
        for group in (
            np.split(new_indices, range(TOGETHER, len(new_indices), TOGETHER))
            if len(new_indices)
            else ()
        ):
            solved = self._solve(x[group], case[group], inside[group], far)
            rows = np.column_stack([getattr(solved, name) for name in FOUND]).tolist()
            self._solved_starts.update(zip([starts[k] for k in group], rows))
        solved = (
            np.array([self._solved_starts[start] for start in starts]).reshape(-1, len(FOUND)).T
        )
        return StateBatch(x=x, case=case, inside=inside, **dict(zip(FOUND, solved)))

    def _solve(self, x, case, inside, far, careful=False):
        starts = x, case, inside
        low, high, theta, second = self._first_contact(*starts, far, careful)
        self._shorten(low, high, theta, *starts)
        time, reached = np.full(len(x), np.inf), np.isfinite(high)
        separated = (
            []
            if careful
            else self._still_separated(np.flatnonzero(reached & ~inside), high, theta, *starts)
        )
        reached[separated] = False
        time[reached], theta[reached] = self._refine(*rows_of(reached, *starts, low, high, theta))
        self._improve_elsewhere(np.flatnonzero(reached & inside), low, second, time, theta, *starts)
        if len(separated):
            refined = self._solve(*rows_of(separated, *starts), far, careful=True)
            time[separated], theta[separated] = refined.time, refined.angle
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

    def _first_contact(self, x, case, inside, far, careful):
        """Return (low, high, theta, second): R(T) meets D first between the times low and high.

        From outside, theta is the last line that separates; from inside, the direction in which R(T) gets
        through D first, and second another one, if there is one. `careful`: lines between the directions
        tried count, too.
        """
        n, p = len(x), directions(self._angles)
        low, high = np.full((2, n), np.inf)
        theta, second, todo = np.zeros(n), np.zeros(n), np.arange(n)
        support, outward, state = self._supports(p, x, case), inside, x.T
        before, dips = p @ state - support, []
        line = self._middle(before) if careful else None
        # the distance of x and D, later R(T) and D, at the last two times
        distances = np.array([np.full(n, np.inf), before.max(axis=0)])
        for j, (T, carried, least, greatest) in enumerate(self._moments(far)):
            gap = carried @ state - support
            gap += (
                np.where(outward, greatest[:, None], least[:, None])
                if outward.any()
                else least[:, None]
            )
            best = gap.argmax(axis=0)
            distance = largest = gap[best, np.arange(len(todo))]
            if careful:
                largest, line_before = distance.copy(), line
                line = np.where(outward, self._angles[best], self._middle(gap))
                rows, starts = (
                    np.flatnonzero(~outward & (largest <= 0)),
                    rows_of(todo, x, case, inside),
                )
                self._look_between(rows, T, line_before, largest, line, *starts)
            meets = np.where(outward, largest >= 0, largest <= 0)
            if j and not self.convex.point:
                # A distance that falls and rises again may have been zero in between, if it does so
                # steeply enough.
                drop = (
                    np.where(np.isfinite(distances[0]), distances[0], distances[1]) - distances[1]
                )
                rise = distance - distances[1]
                dip = np.flatnonzero(
                    ~outward
                    & (drop >= 0)
                    & (rise > 0)
                    & (distances[1] <= 2 * np.maximum(drop, rise))
                )
                times = (np.full(len(dip), end) for end in (TIMES[j - 2] if j > 1 else 0.0, T))
                dips.append((todo[dip], *times))
            distances = np.array([distances[1], distance])
            if meets.any():
                rows, is_outward = todo[meets], outward[meets]
                high[rows] = T
                # From inside, a direction between those tried may have got through one or two of
                # the times before.
                low[rows] = np.where(
                    is_outward, TIMES[j - 3] if j > 2 else 0.0, TIMES[j - 1] if j else 0.0
                )
                theta[rows] = line_before[meets] if careful else self._middle(before[:, meets])
                if is_outward.any():
                    outward_rows = rows[is_outward]
                    gap_now = gap[:, meets][:, is_outward]
                    gap_before = before[:, meets][:, is_outward]
                    with np.errstate(all="ignore"):
                        share = np.where(gap_now >= 0, -gap_before / (gap_now - gap_before), np.inf)
                    theta[outward_rows] = self._angles[share.argmin(axis=0)]
                    second[outward_rows] = self._angles[
                        self._second_maximum(gap_now, theta[outward_rows])
                    ]
                unmet = ~meets
                todo, outward = rows_of(unmet, todo, outward)
                support, state, gap = support[:, unmet], state[:, unmet], gap[:, unmet]
                distances, line = distances[:, unmet], line[unmet] if careful else None
                if not len(todo):
                    break
            before = gap
        self._find_dips(dips, low, high, theta, x, case, inside)
        return low, high, theta, second

    def _look_between(self, rows, T, line, largest, angle, *starts):
        """Put into largest and angle, for some rows, a separating line between directions.

        It is the last one, one close to it, or one close to the best of those tried.
        """
        best_angle = angle[rows].copy()
        starts, T = rows_of(rows, *starts), np.full(len(rows), T)
        angle[rows], largest[rows] = line[rows], self._gap(line[rows], T, *starts)
        for around in (line[rows], best_angle):
            unseparated = np.flatnonzero(largest[rows] <= 0)
            angle[rows[unseparated]], largest[rows[unseparated]] = self._best(
                around[unseparated],
                *rows_of(unseparated, T, *starts),
                np.full(len(unseparated), WIDE),
                30,
                sufficient=0,
            )

    def _still_separated(self, rows, high, theta, *starts):
        """Return rows for which a line between the directions tried separates at the time high.

        For them all times have to be examined more closely.
        """
        if not self._spacing or not len(rows):
            return rows[:0]
        return rows[
            self._best(*rows_of(rows, theta, high, *starts), np.full(len(rows), WIDE), 26)[1] > 0
        ]

    def _improve_elsewhere(self, rows, low, second, time, theta, *starts):
        """Put into time and theta where R(T) gets through the border elsewhere, but earlier."""
        if not self._spacing or not len(rows):
            return
        width = np.full(len(rows), 0.2)
        rows = rows[self._best(*rows_of(rows, second, time, *starts), width, 16)[1] > -1e-6]
        if len(rows):
            other_time, angle = self._refine(*rows_of(rows, *starts, low, time, second))
            is_earlier = (self._gap(angle, other_time, *rows_of(rows, *starts)) > -1e-6) & (
                other_time < time[rows]
            )
            time[rows], theta[rows] = (
                np.where(is_earlier, other_time, time[rows]),
                np.where(is_earlier, angle, theta[rows]),
            )

    def _find_dips(self, dips, low, high, theta, x, case, inside):
        """Put into low, high and theta where R(T) meets a thin D only between two of the times.

        There the distance has a dip.
        """
        if not any(len(dip_rows) for dip_rows, *_ in dips):
            return
        dip_rows, first, last = (np.concatenate(column) for column in zip(*dips))
        K, (x, case, inside) = len(self._angles), rows_of(dip_rows, x, case, inside)

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

        closest_times = golden_section(
            lambda T, rows: -distance(T, rows), (first + last) / 2, (last - first) / 2, 12
        )
        line, touches = self._middle(gaps_of(first)), distance(closest_times) <= 0
        for k in np.flatnonzero(touches)[::-1]:  # the earliest last
            if not closest_times[k] > high[dip_rows[k]]:
                low[dip_rows[k]], high[dip_rows[k]], theta[dip_rows[k]] = (
                    first[k],
                    closest_times[k],
                    line[k],
                )

    def _second_maximum(self, gap, angle):
        """Return the index of another direction in which the gap has a local maximum."""
        top = (gap >= np.roll(gap, 1, axis=0)) & (gap >= np.roll(gap, -1, axis=0))
        return np.where(top & (np.cos(self._angles[:, None] - angle) < 0.95), gap, -np.inf).argmax(
            axis=0
        )

    def _coarse_angles(self, T, x, case, inside):
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
            len(rows := np.flatnonzero(~inside & np.isfinite(high) & (high - low > LONG)))
            and self._spacing
        ):
            T, starts = (low[rows] + high[rows]) / 2, (x[rows], case[rows], inside[rows])
            angles, gaps = zip(
                *(
                    self._best(around, T, *starts, np.full(len(T), WIDE), 26)
                    for around in (theta[rows], self._coarse_angles(T, *starts))
                )
            )
            separated = np.maximum(*gaps) > 0
            low[rows], high[rows] = (
                np.where(separated, T, low[rows]),
                np.where(separated, high[rows], T),
            )
            theta[rows] = np.where(separated, np.where(gaps[0] > gaps[1], *angles), theta[rows])

    def missing(self, x, case, remaining_time, inside):
        """Return the distance from the target at the best time within `remaining_time`."""
        n, p, steps = len(x), directions(self._angles), 16
        best, best_time, angle = np.full(n, np.inf), remaining_time, np.zeros(n)
        rows, sign = np.repeat(p, n, axis=0), np.tile(np.where(inside, 1, -1), len(p))
        support = self._supports(p, x, case)
        for T in remaining_time * (np.arange(1, steps + 1) / steps)[:, None]:
            free_states = self.plant.free(x, T)
            gaps = (
                p @ free_states.T
                + self.plant.extreme(rows, np.tile(T, len(p)), sign).reshape(len(p), n)
                - support
            )
            top = np.where(inside, -gaps.max(axis=0), gaps.max(axis=0))
            better = top < best
            best, best_time = np.where(better, top, best), np.where(better, T, best_time)
            angle = np.where(better, self._angles[gaps.argmax(axis=0)], angle)
        width = np.full(n, WIDE)

        def distance(T, rows=slice(None)):
            starts = (part[rows] for part in (x, case, inside, width))
            gap = self._best(angle[rows], np.clip(T, 1e-9, remaining_time[rows]), *starts, 24)[1]
            return np.where(inside[rows], -gap, gap)

        closest_times = golden_section(
            lambda T, rows: -distance(T, rows), best_time, remaining_time / steps, steps=12
        )
        return np.minimum(distance(closest_times), distance(best_time))
