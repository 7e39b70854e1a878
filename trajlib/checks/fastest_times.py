"""The shortest time from any start to a convex target, by support functions: an optimum that knows no law.

The plant is x' = Ax + bu with u between two bounds, the state is a point of the plane, and the target is a point, a segment, a
line, or the border of a convex set. Before the first moment at which the set R(T) of reachable states meets a convex D there is
a line between the two; so the shortest time is the first T at which, for every direction p,

    min p.y over R(T) = p.e^{AT}x0 + int_0^T min_u (p.e^{As}b u) ds  <=  sup p.y over D.

From inside D the border is met when for some direction the farthest point of R(T) is as far as that of D. Both are exact,
and neither a law nor a shooting comes in.
"""

import functools

import numpy as np
import sympy as sp

from trajlib.checks.convex_targets import ConvexTarget
from trajlib.checks.linear_plant import Plant
from trajlib.checks.sampling import largest, sample_cases

#: Times up to this one are looked at closely, and up to twenty times as long roughly, where it is asked whether a target is in reach.
HORIZON = 20.0
#: Directions up to this angle from a good one are searched for a better: nearly the half of all that can separate.
WIDE = 1.5705
#: How far from a border two answers must agree about a point, in units of the size of the state.
BESIDE, BESIDE_DECIMALS = 0.006, 0.015


def frozen(field, state, control, bounds, target, parameters, start):
    """The data as hashable values, so that the optimum is computed once."""
    def fixed(value):
        return tuple(map(fixed, value)) if isinstance(value, (list, tuple, sp.MatrixBase)) else sp.sympify(value)

    target = list(target) if isinstance(target, (list, tuple)) else [target]
    return (fixed(list(field)), tuple(state), control, fixed(list(bounds)), fixed(target),
            tuple(parameters.items()), None if start is None else sp.sympify(start))


@functools.lru_cache(maxsize=64)
def fastest_times(field, state, control, bounds, target, parameters, start):
    return FastestTimes(field, state, control, bounds, target, parameters, start)


class Lanes:
    """Many starts side by side, with what is known of each."""

    def __init__(self, **columns):
        self.__dict__.update(columns)

    def take(self, which):
        return Lanes(**{name: column[which] for name, column in self.__dict__.items()})

    @staticmethod
    def joined(parts):
        return Lanes(**{name: np.concatenate([part.__dict__[name] for part in parts]) for name in parts[0].__dict__})


class FastestTimes:
    """The fastest times, and how the fastest motions begin, for sample starts and sample values of the parameters."""

    def __init__(self, field, state, control, bounds, target, parameters, start):
        self.state, self.parameters, self.start = state, dict(parameters), start
        self.plant = Plant(field, state, control, bounds)
        self.cases = sample_cases(self.parameters)
        self.convex = ConvexTarget(target, state, list(self.parameters), self.cases)
        self._angles, self._spacing = self.convex.angles()
        # Fine at first; far starts may be in reach too, but no law is asked about them.
        self._times = np.concatenate([HORIZON * (np.arange(1, 131) / 130)**1.6, HORIZON * 1.1**np.arange(1, 33)])
        p = directions(self._angles)
        rows = np.repeat(p, len(self._times), axis=0), np.tile(self._times, len(p))
        self._least, self._most = (self.plant.extreme(*rows, sign).reshape(len(p), -1) for sign in (-1, 1))
        self._carried = np.einsum("ki,tij->tkj", p, self.plant.exponential(self._times))
        self.kept, self._limited = {}, None  # whether some starts are out of reach: not known yet

    def solve(self, x, case, far=False):
        """The optimum from each start: `time` (inf where out of reach), `control` it begins with, `switching` function there.

        `far`: times beyond the horizon count too.
        """
        x, case = np.asarray(x, dtype=float), np.asarray(case)
        inside = self.convex.inside(x, case)
        parts = [self._solve(x[k:k + 160], case[k:k + 160], inside[k:k + 160], far) for k in range(0, len(x), 160)]
        if not parts:
            return Lanes(x=x, case=case, inside=inside, **dict.fromkeys(("time", "control", "switching", "angle"), np.zeros(0)))
        return Lanes.joined(parts)

    def _solve(self, x, case, inside, far, careful=False):
        n, p = len(x), directions(self._angles)
        support = np.array([self.convex.support(np.broadcast_to(d, (n, 2)), case, x) for d in p])
        low, high, theta, second, todo = np.full(n, np.inf), np.full(n, np.inf), np.zeros(n), np.zeros(n), np.arange(n)
        before = p @ x.T - support
        line, suspects = self._middle(before), []
        apart = np.array([np.full(n, np.inf), before.max(axis=0)])  # the distance of x and D, later R(T) and D, at the last two times
        for j, T in enumerate(self._times if far else self._times[:130]):
            outward = inside[todo]
            gap = self._carried[j] @ x[todo].T - support[:, todo] + np.where(outward, self._most[:, j, None], self._least[:, j, None])
            best = gap.argmax(axis=0)
            largest, angle = gap[best, np.arange(len(todo))], np.where(outward, self._angles[best], self._middle(gap))
            maybe = np.flatnonzero(~outward & (largest <= 0))
            if len(maybe) and careful:
                # Between the directions tried there may be one that separates.
                same = self._gap(line[maybe], np.full(len(maybe), T), x[todo[maybe]], case[todo[maybe]], inside[todo[maybe]])
                angle[maybe], largest[maybe] = line[maybe], same
                here = todo[maybe := maybe[same <= 0]]
                angle[maybe], largest[maybe] = self._best(line[maybe], np.full(len(here), T), x[here], case[here], inside[here],
                                                          np.full(len(here), WIDE), 30, enough=0)
            hit = np.where(outward, largest >= 0, largest <= 0)
            if j and not self.convex.point:
                # A distance that falls and rises again may have been zero in between, if it does so steeply enough.
                drop, rise = np.where(np.isfinite(apart[0]), apart[0], apart[1]) - apart[1], gap.max(axis=0) - apart[1]
                dip = np.flatnonzero(~outward & (drop >= 0) & (rise > 0) & (apart[1] <= 2 * np.maximum(drop, rise)))
                if len(dip):
                    ends = (self._times[j - 2] if j > 1 else 0.0, T)
                    suspects.append((todo[dip], *(np.full(len(dip), end) for end in ends)))
            here = todo[hit]
            if len(here):
                # From inside, a direction between those tried may have got through one or two of the times before.
                earlier = np.where(inside[here], self._times[j - 3] if j > 2 else 0.0, self._times[j - 1] if j else 0.0)
                # From inside, the direction that gets through first; from outside, the last line that separates.
                with np.errstate(all="ignore"):
                    share = np.where(gap[:, hit] >= 0, -before[:, hit] / (gap[:, hit] - before[:, hit]), np.inf)
                begin = np.where(inside[here], self._angles[share.argmin(axis=0)], line[hit])
                low[here], high[here], theta[here] = earlier, T, begin
                elsewhere = np.cos(self._angles[:, None] - begin) < 0.95
                second[here] = self._angles[np.where(elsewhere, share, np.inf).argmin(axis=0)]
            on = ~hit
            todo, before, line, apart = todo[on], gap[:, on], angle[on], np.array([apart[1, on], gap[:, on].max(axis=0)])
            if not len(todo):
                break
        self._dips(suspects, low, high, theta, x, case, inside)
        time, met = np.full(n, np.inf), np.isfinite(high)
        again = np.flatnonzero(met & ~inside) if self._spacing and not careful else ()
        if len(again):
            # Between the directions tried there may be one that separates still. Then all times have to be looked at more closely.
            gap = self._best(theta[again], high[again], x[again], case[again], inside[again], np.full(len(again), WIDE), 26)[1]
            again = again[gap > 0]
            met[again] = False
        time[met], theta[met] = self._refine(x[met], case[met], inside[met], low[met], high[met], theta[met])
        # From inside, R(T) may get through in two places at nearly the same time.
        both = np.flatnonzero(met & inside)
        if len(both) and self._spacing:
            other, angle = self._refine(x[both], case[both], inside[both], low[both], high[both], second[both])
            opened = self._gap(angle, other, x[both], case[both], inside[both]) > -1e-6
            sooner = opened & (other < time[both])
            time[both], theta[both] = np.where(sooner, other, time[both]), np.where(sooner, angle, theta[both])
        if len(again):
            closer = self._solve(x[again], case[again], inside[again], far, careful=True)
            time[again], theta[again] = closer.time, closer.angle
        impulse = self.plant.response(np.where(np.isfinite(time), time, 0))[0]
        switching = (impulse * directions(theta)).sum(axis=1) * np.where(inside, -1, 1)
        return Lanes(x=x, case=case, inside=inside, time=time, control=np.where(switching > 0, *self.plant.bounds), switching=switching,
                      angle=theta)

    def _dips(self, suspects, low, high, theta, x, case, inside):
        """Put into low, high and theta where R(T) meets a thin D between two of the times only: there the distance has a dip."""
        if not suspects:
            return
        here, first, last = (np.concatenate(column) for column in zip(*suspects))
        n, K = len(here), len(self._angles)
        rows = [np.tile(part[here], (K, 1) if part.ndim > 1 else K) for part in (x, case, inside)]

        def gaps_of(T):
            return self._gap(np.repeat(self._angles, n), np.tile(T, K), *rows).reshape(K, n)

        def distance(T):
            gaps = gaps_of(T)
            if not self._spacing:
                return gaps.max(axis=0)
            angle = self._angles[gaps.argmax(axis=0)]
            return np.maximum(self._best(angle, T, x[here], case[here], inside[here], np.full(n, WIDE), 16)[1], gaps.max(axis=0))

        closest = largest(lambda T: -distance(T), (first + last) / 2, (last - first) / 2, 12)
        line, through = self._middle(gaps_of(first)), distance(closest) <= 0
        for k in np.flatnonzero(through)[::-1]:  # the earliest last
            if not closest[k] > high[here[k]]:
                low[here[k]], high[here[k]], theta[here[k]] = first[k], closest[k], line[k]

    def _middle(self, gap):
        """The middle of the directions that separate: they form a convex cone."""
        p = np.maximum(gap > 0, gap == gap.max(axis=0)).T @ directions(self._angles)
        return np.arctan2(p[:, 1], p[:, 0])

    def _gap(self, theta, T, x, case, inside):
        p = directions(theta)
        moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
        return (p * moved).sum(axis=1) + self.plant.extreme(p, T, np.where(inside, 1, -1)) - self.convex.support(p, case, x)

    def _best(self, theta, T, x, case, inside, width, steps, enough=np.inf):
        """(direction near theta in which the gap is largest, this gap); or any gap that is large enough.

        From outside, min p.y over R(T) less sup p.y over D is concave in p: along the tangent of the unit circle at p(theta) it has
        one top, and its sign there tells whether any line separates. From inside the unit vectors themselves are compared.
        """
        if not self._spacing:
            return theta, self._gap(theta, T, x, case, inside)
        moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
        whole, sign = self.plant.response(T)[1], np.where(inside, 1, -1)

        def gap(turn):
            p = directions(theta + turn)
            return (p * moved).sum(axis=1) + self.plant.extreme(p, T, sign, whole) - self.convex.support(p, case, x)

        turn = largest(lambda turn: gap(turn) / np.where(inside, 1, np.cos(turn)), np.zeros(len(x)), width, steps, enough)
        return theta + turn, gap(turn)

    def _refine(self, x, case, inside, low, high, theta):
        """The first time between low and high at which no line separates, and the last separating direction.

        From inside: at which R(T) gets through the border, and the direction in which it does.
        """
        centre = theta
        for turn in range(18):
            middle = (low + high) / 2
            # The best line may jump from one side of a cone to the other, so at first the whole cone is searched each time.
            around, width, steps = (centre, WIDE, 24) if turn < 8 else (theta, 0.04 * 0.85**turn, 10)
            angle, gap = self._best(around, middle, x, case, inside, np.where(inside, np.minimum(width, 0.15), width), steps)
            met = np.where(inside, gap >= 0, gap <= 0)
            low, high = np.where(met, low, middle), np.where(met, middle, high)
            theta = np.where(met & ~inside, theta, angle)
        return (low + high) / 2, theta

    def missing(self, x, case, left, inside):
        """The distance from the target at the best moment within the times `left`."""
        n, p, steps = len(x), directions(self._angles), 16
        best, when, angle = np.full(n, np.inf), left, np.zeros(n)
        rows, cases, starts = np.repeat(p, n, axis=0), np.tile(case, len(p)), np.tile(x, (len(p), 1))
        sign = np.tile(np.where(inside, 1, -1), len(p))
        support = self.convex.support(rows, cases, starts).reshape(len(p), n)
        for T in left * (np.arange(1, steps + 1) / steps)[:, None]:
            moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
            gaps = p @ moved.T + self.plant.extreme(rows, np.tile(T, len(p)), sign).reshape(len(p), n) - support
            top = np.where(inside, -gaps.max(axis=0), gaps.max(axis=0))
            better = top < best
            best, when = np.where(better, top, best), np.where(better, T, when)
            angle = np.where(better, self._angles[gaps.argmax(axis=0)], angle)
        width = np.full(n, WIDE)

        def apart(T):
            gap = self._best(angle, np.clip(T, 1e-9, left), x, case, inside, width, 24)[1]
            return np.where(inside, -gap, gap)

        closest = largest(lambda T: -apart(T), when, left / steps, steps=12)
        return np.minimum(apart(closest), apart(when))

    # Which starts are looked at.

    def lanes(self, decimals):
        """Starts spread over the plane, and pairs on both sides of the switching curves."""
        kept = self.kept.get(decimals)
        if kept is None:
            kept = self.kept[decimals] = self._lanes(BESIDE_DECIMALS if decimals else BESIDE)
        return kept

    def _points(self, count, seed=4):
        random, points, cases = np.random.default_rng(seed), [], []
        for case in range(len(self.cases)):
            spread = random.normal(size=(count, 2)) * np.array([0.7, 2, 4])[np.arange(count) % 3, None]
            both = np.concatenate([spread, self.convex.around(random, case, count // 2)])
            points.append(both)
            cases.append(np.full(len(both), case))
        points, cases = np.concatenate(points), np.concatenate(cases)
        keep = self.allowed(points, cases)
        return points[keep], cases[keep]

    def allowed(self, x, case):
        return self.condition(self.start if self.start is not None else sp.true)(x, case)

    def condition(self, condition):
        """A SymPy condition as a function of states and cases."""
        test = sp.lambdify([*self.state, *self.parameters], condition, "numpy")
        cases = np.array(self.cases, dtype=float).reshape(len(self.cases), len(self.parameters))

        def holds(x, case):
            with np.errstate(all="ignore"):
                return np.broadcast_to(np.asarray(test(x[:, 0], x[:, 1], *cases[case].T), dtype=bool), len(x))

        return holds

    def _lanes(self, beside):
        if "near" not in self.kept:
            count = 100 if len(self.cases) == 1 else 24
            spread = self._safe(self.solve(*self._points(count)))
            self.kept["spread"] = spread
            self.kept["near"] = self._between(spread, lambda lanes: lanes.control, 28 if len(self.cases) == 1 else 7)
        spread, near = self.kept["spread"], self.kept["near"]
        if near is None:
            return spread
        middle, direction, case = near
        shift = beside * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
        sides = np.concatenate([middle + shift, middle - shift])
        case = np.concatenate([case, case])
        keep = self.allowed(sides, case)
        return Lanes.joined([spread, self._safe(self.solve(sides[keep], case[keep]))])

    def _safe(self, lanes):
        """Starts in reach, with all states next to them in reach too, and not on the target already."""
        out_of_reach = lanes.take(~np.isfinite(lanes.time))
        shortest = 0.15 if self.convex.kind == "hull" else 0.02
        lanes = lanes.take(np.isfinite(lanes.time) & (lanes.time > shortest) & (lanes.time < 0.9 * HORIZON))
        if self._limited is None and len(out_of_reach.x):
            self._limited = not np.isfinite(self.solve(out_of_reach.x[:12], out_of_reach.case[:12], far=True).time).all()
        if not self._limited or not len(lanes.x):
            return lanes
        return lanes.take(np.isfinite(self._around(lanes, 0.02, count=4).time).all(axis=1))

    def _around(self, lanes, share, far=False, count=8):
        """The optimum at some states around each, as columns."""
        angle = np.arange(count) * 2 * np.pi / count + 0.3
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        size = share * (0.3 + np.linalg.norm(lanes.x, axis=1))
        points = (lanes.x[:, None] + size[:, None, None] * ring).reshape(-1, 2)
        case = np.repeat(lanes.case, count)
        solved = self.solve(points, case, far)
        same = (solved.inside == np.repeat(lanes.inside, count)) & self.allowed(points, case)
        return Lanes(time=np.where(same, solved.time, 0).reshape(-1, count),
                      control=np.where(same, solved.control, np.repeat(lanes.control, count)).reshape(-1, count))

    def robust(self, lanes, decimals):
        """True where the fastest motions from all states around begin alike: no switching curve is close."""
        around = self._around(lanes, (BESIDE_DECIMALS if decimals else BESIDE) / 2, count=5)
        return (around.control == lanes.control[:, None]).all(axis=1)

    def beside_barrier(self, lanes):
        """True where the fastest time jumps from one state next to the start to another."""
        times = np.column_stack([self._around(lanes, 0.02).time, lanes.time])
        times = np.sort(np.where(times > 0, times, np.nan), axis=1)
        # The largest gap between two of the times: a steep slope has a wide range of times too, but no such gap.
        with np.errstate(all="ignore"):
            gaps = np.diff(times, axis=1)
            return np.where(np.isnan(gaps), 0, gaps).max(axis=1) > 0.25 * lanes.time

    def _between(self, lanes, kind, count, far=False):
        """Points where `kind` changes: (points, directions across, cases), by bisection between neighbours that differ."""
        left, right, case, random = [], [], [], np.random.default_rng(6)
        for k in range(len(self.cases)):
            here = np.flatnonzero(lanes.case == k)
            if not len(here):
                continue
            marks, x = kind(lanes)[here], lanes.x[here]
            ones = random.permutation(np.flatnonzero(marks == marks.max()))
            others = np.flatnonzero(marks != marks.max())
            if not len(others):
                continue
            for one in ones[:count]:
                # A start inside D is no neighbour of one outside: between the two lies the target.
                alike = others[lanes.inside[here][others] == lanes.inside[here][one]]
                if self.convex.kind == "line":
                    side = np.sign(self.convex.g(x, np.full(len(x), k)))
                    alike = alike[side[alike] == side[one]]
                if len(alike):
                    near = alike[np.argsort(np.linalg.norm(x[alike] - x[one], axis=1))[random.integers(0, min(3, len(alike)))]]
                    left.append(x[one])
                    right.append(x[near])
                    case.append(k)
        if not left:
            return None
        left, right, case = np.array(left), np.array(right), np.array(case)
        direction = (right - left) / np.linalg.norm(right - left, axis=1)[:, None]
        one = kind(self.solve(left, case, far))
        for _ in range(9):
            middle = (left + right) / 2
            same = (kind(self.solve(middle, case, far)) == one)[:, None]
            left, right = np.where(same, middle, left), np.where(same, right, middle)
        return (left + right) / 2, direction, case

    def border(self, decimals):
        """Starts in reach and out of reach, many of them on both sides of the border between."""
        kept = self.kept.get(("border", decimals))
        if kept is None:
            spread = self.solve(*self._points(100 if len(self.cases) == 1 else 40, seed=5), far=True)
            near = self._between(spread, lambda lanes: np.isfinite(lanes.time), 30 if len(self.cases) == 1 else 8, far=True)
            parts = [spread]
            for share in ((0.02,) if decimals else (0.008, 0.03)) if near is not None else ():
                middle, direction, case = near
                shift = share * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
                both, cases = np.concatenate([middle + shift, middle - shift]), np.concatenate([case, case])
                keep = self.allowed(both, cases)
                parts.append(self.solve(both[keep], cases[keep], far=True))
            kept = Lanes.joined(parts)
            self.kept[("border", decimals)] = kept
        return kept

    def on_border(self, lanes):
        """True where states next to the start are of the other kind: there rounding decides."""
        reach = np.isfinite(lanes.time)
        return (np.isfinite(self._around(lanes, 0.003, far=True).time) != reach[:, None]).any(axis=1)

    def told(self, lanes, k):
        values = self.cases[lanes.case[k]]
        named = ", ".join(f"{p} = {v:.4g}" for p, v in zip(self.parameters, values))
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(self.state, lanes.x[k]))
        return f"{'for ' + named + ', ' if named else ''}from {place}"


def directions(angles):
    return np.column_stack([np.cos(angles), np.sin(angles)])
