"""Starts from which laws are tried, with the optimum of each: spread over the plane, and close to
where laws and answers change.

A law is optimal or not on both sides of a switching curve, and a set of starts is right or wrong at
its border; so the starts next to these places tell most, and they are found by bisection between
neighbours that differ.
"""

import functools
from typing import NamedTuple

import numpy as np
import sympy as sp

from workbook.checks.references.optima.convex_targets import ConvexTarget
from workbook.checks.references.optima.fastest_times import HORIZON, FastestTimes, Lanes
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.tools.domains import sample_cases
from workbook.checks.tools.line_search import bisect

#: How far from a border two answers must agree about a point, in units of the size of the state.
BESIDE, BESIDE_DECIMALS = 0.006, 0.015
#: How far from its switching curve a law is asked what it says, and the size of starts far out.
NEXT, FAR_OUT = 0.0002, 14.0
#: Up to this time the directions tried lie close enough for these.
FAR_IN_TIME = 1.5 * HORIZON
#: How long the last arcs of extremals are, the first of them the arcs of motions next to the
#: target; from `WHOLE` on extremals are followed farther back than over one switching, until their
#: states have the size `OUT` or time is up.
LAST_ARCS, WHOLE, OUT, BACK = (
    (1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.8, 1.4, 2.0, 2.6),
    0.3,
    80.0,
    130.0,
)
#: How far before a switching states are taken, in units of the last arc.
EARLIER = (0.02, 1.0, 15.0, 49.0)
#: How many sets of states around starts are kept with their optima.
RINGS = 64


class Asked(NamedTuple):
    """The data of a synthesis as values that can be compared, so that its optimum is computed
    once."""

    field: tuple
    state: tuple
    control: sp.Symbol
    bounds: tuple
    target: tuple
    parameters: tuple
    start: object


def frozen(system, target, parameters, start):
    """The data of a synthesis; what is given as a list becomes a tuple."""

    def fixed(value):
        return (
            tuple(map(fixed, value))
            if isinstance(value, (list, tuple, sp.MatrixBase))
            else sp.sympify(value)
        )

    target = list(target) if isinstance(target, (list, tuple)) else [target]
    return Asked(
        fixed(system.field),
        tuple(system.state),
        system.control,
        fixed(system.bounds),
        fixed(target),
        tuple((parameters or {}).items()),
        None if start is None else sp.sympify(start),
    )


@functools.lru_cache(maxsize=64)
def sampled_optimum(field, state, control, bounds, target, parameters, start):
    return SampledOptimum(field, state, control, bounds, target, parameters, start)


class SampledOptimum(FastestTimes):
    """The fastest times, and how the fastest motions begin, for sample starts and sample values of
    the parameters."""

    def __init__(self, field, state, control, bounds, target, parameters, start):
        self.state, self.parameters, self.start = state, dict(parameters), start
        self.cases = sample_cases(self.parameters)
        super().__init__(
            Plant(field, state, control, bounds),
            ConvexTarget(target, state, list(self.parameters), self.cases),
        )
        # whether some starts are out of reach: not known yet
        self.kept, self._limited = {}, None
        self._rings = {}

    def lanes(self, decimals):
        """Starts spread over the plane, and pairs on both sides of the switching curves."""
        kept = self.kept.get(decimals)
        if kept is None:
            kept = self.kept[decimals] = self._lanes(BESIDE_DECIMALS if decimals else BESIDE)
        return kept

    def _points(self, count, seed=4):
        """Starts that the problem allows: about half of all for each case, also where few satisfy
        its condition."""
        for more in (1, 4, 16):
            points, cases = self._drawn(more * count, seed)
            if len(points) > count * len(self.cases) / 2:
                break
        return points, cases

    def _drawn(self, count, seed):
        random, points, cases = np.random.default_rng(seed), [], []
        for case in range(len(self.cases)):
            spread = (
                random.normal(size=(count, 2)) * np.array([0.7, 2, 4])[np.arange(count) % 3, None]
            )
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
        test = sp.lambdify([*self.state, *self.parameters], condition, "numpy", docstring_limit=0)
        cases = np.array(self.cases, dtype=float).reshape(len(self.cases), len(self.parameters))

        def holds(x, case):
            with np.errstate(all="ignore"):
                return np.broadcast_to(
                    np.asarray(test(x[:, 0], x[:, 1], *cases[case].T), dtype=bool), len(x)
                )

        return holds

    def _lanes(self, beside):
        if "near" not in self.kept:
            count = 100 if len(self.cases) == 1 else 24
            spread = self._safe(self.solve(*self._points(count)))
            self.kept["spread"] = spread
            self.kept["near"] = self._between(
                spread, lambda lanes: lanes.control, 28 if len(self.cases) == 1 else 7
            )
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
        """Starts in reach, with all states next to them in reach too, and not on the target
        already."""
        out_of_reach = lanes.take(~np.isfinite(lanes.time))
        shortest = 0.15 if self.convex.kind == "hull" else 0.02
        lanes = lanes.take(
            np.isfinite(lanes.time) & (lanes.time > shortest) & (lanes.time < 0.9 * HORIZON)
        )
        if self._limited is None and len(out_of_reach.x):
            self._limited = not np.isfinite(
                self.solve(out_of_reach.x[:12], out_of_reach.case[:12], far=True).time
            ).all()
        if not self._limited or not len(lanes.x):
            return lanes
        return lanes.take(np.isfinite(self._around(lanes, 0.02, count=4).time).all(axis=1))

    def _around(self, lanes, share, far=False, count=8):
        """The optimum at some states around each, as columns.

        Laws that differ from the optimum do so from the same starts, mostly; so the rings asked for
        last are kept.
        """
        asked = (lanes.x.tobytes(), lanes.case.tobytes(), share, far, count)
        if asked not in self._rings:
            while len(self._rings) >= RINGS:
                del self._rings[next(iter(self._rings))]
            self._rings[asked] = self._ring(lanes, share, far, count)
        return self._rings[asked]

    def _ring(self, lanes, share, far, count):
        angle = np.arange(count) * 2 * np.pi / count + 0.3
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        size = share * (0.3 + np.linalg.norm(lanes.x, axis=1))
        points = (lanes.x[:, None] + size[:, None, None] * ring).reshape(-1, 2)
        case = np.repeat(lanes.case, count)
        solved = self.solve(points, case, far)
        same = (solved.inside == np.repeat(lanes.inside, count)) & self.allowed(points, case)
        return Lanes(
            time=np.where(same, solved.time, 0).reshape(-1, count),
            control=np.where(same, solved.control, np.repeat(lanes.control, count)).reshape(
                -1, count
            ),
        )

    def next_to_curves(self):
        """Starts on both sides of the switching curves, as close as they are known, and of a target
        with a border; far out too if the target is a point, which the optimum meets as well as
        nearby."""
        kept = self.kept.get("next")
        if kept is None:
            self.lanes(False)
            curves = [self.kept["near"]]
            if self.convex.point:
                random = np.random.default_rng(8)
                x, case = (
                    random.normal(size=(60, 2)) * FAR_OUT,
                    random.integers(len(self.cases), size=60),
                )
                far = self.solve(x[self.allowed(x, case)], case[self.allowed(x, case)], far=True)
                far = far.take(far.time < FAR_IN_TIME)
                curves.append(self._between(far, lambda lanes: lanes.control, 16, far=True))
            parts = [self._sides(near, 0.02) for near in curves if near is not None]
            if self.convex.g is not None:
                parts.append(self._sides(self._on_target(16), 0.0))
            kept = self.kept["next"] = Lanes.joined(parts) if parts else None
        return kept

    def extremals(self):
        """(states next to a target that is a point, and far out, with the control there; places
        where it changes), as extremals that are followed back tell without a search; None for
        another target.

        For a linear plant an extremal is optimal if an admissible control can hold the state on the
        target.
        """
        if "followed back" not in self.kept:
            parts = (
                [self._followed_back(k) for k in range(len(self.cases))]
                if self.convex.point
                else [None]
            )
            self.kept["followed back"] = (
                None if None in parts else tuple(map(Lanes.joined, zip(*parts)))
            )
        return self.kept["followed back"]

    def _followed_back(self, case):
        plant, end = self.plant, self.convex.corner(case)
        free = plant.A @ end
        rest = -(plant.b @ free) / (plant.b @ plant.b)
        if not (
            np.allclose(free + rest * plant.b, 0) and plant.bounds[0] <= rest <= plant.bounds[1]
        ):
            return None
        last = np.repeat(LAST_ARCS, 2)
        p = (
            plant.response(last)[0]
            @ np.array([[0, 1], [-1, 0]])
            * np.tile((1, -1), len(LAST_ARCS))[:, None]
        )
        moves = np.max(
            [p @ (free + u * plant.b) for u in plant.bounds], axis=0
        ) > 1e-9 * np.linalg.norm(p, axis=1)
        last, p = last[moves], p[moves]
        u = np.where(p @ plant.b > 0, plant.bounds[1], plant.bounds[0])
        x, begin, states, changes = np.tile(end, (len(last), 1)), np.zeros(len(last)), [], []
        zeros = plant.zeros(p, np.full(len(last), BACK))
        for k, zero in enumerate((*zeros.T, np.full(len(last), BACK))):
            on = (begin < zero) & ((last >= WHOLE) | (k < 2))
            for part in EARLIER if k else ():
                step = part * np.minimum(last, (zero - begin) / 50)
                states.append((plant.move(x, u, -step)[on], u[on]))
            x, begin, on = plant.move(x, u, begin - zero), zero, on & (zero < BACK)
            changes.append((x[on], u[on]))
            u = sum(plant.bounds) - u
        return [self._inner(*map(np.concatenate, zip(*part)), case) for part in (states, changes)]

    def _inner(self, x, control, case):
        x, control = (part[np.abs(x).max(axis=1) < OUT] for part in (x, control))
        lanes = Lanes(x=x, case=np.full(len(x), case), control=control)
        return lanes.take(self.allowed(lanes.x, lanes.case))

    def _on_target(self, count):
        """Points of the border of the target: (points, directions across, cases)."""
        random, cases = np.random.default_rng(9), range(len(self.cases))
        x, case = (
            np.concatenate([self.convex.around(random, k, count) for k in cases]),
            np.repeat(cases, count),
        )
        for _ in range(30):
            slope = self.convex.slope(x, case)
            size = np.maximum((slope**2).sum(axis=1), 1e-9)[:, None]
            x = x - self.convex.g(x, case)[:, None] * slope / size
        return x, slope / np.sqrt(size), case

    def _sides(self, near, shortest):
        """The starts next to a curve on which the fastest motions from all states around begin
        alike."""
        middle, direction, case = near
        shift = NEXT * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
        x, case = np.concatenate([middle + shift, middle - shift]), np.concatenate([case, case])
        keep = self.allowed(x, case)
        lanes = self.solve(x[keep], case[keep], far=True)
        around = self._around(lanes, NEXT / 2, far=True, count=5)
        alike = (
            np.isfinite(around.time)
            & (around.time > 0)
            & (around.control == lanes.control[:, None])
        )
        return lanes.take(np.isfinite(lanes.time) & (lanes.time > shortest) & alike.all(axis=1))

    def robust(self, lanes, decimals):
        """True where the fastest motions from all states around begin alike: no switching curve is
        close."""
        around = self._around(lanes, (BESIDE_DECIMALS if decimals else BESIDE) / 2, count=5)
        return (around.control == lanes.control[:, None]).all(axis=1)

    def beside_barrier(self, lanes, far=False):
        """True where the fastest time jumps from one state next to the start to another."""
        times = np.column_stack([self._around(lanes, 0.02, far).time, lanes.time])
        times = np.sort(np.where(times > 0, times, np.nan), axis=1)
        # The largest gap between two of the times: a steep slope has a wide range of times too, but
        # no such gap.
        with np.errstate(all="ignore"):
            gaps = np.diff(times, axis=1)
            return np.where(np.isnan(gaps), 0, gaps).max(axis=1) > 0.25 * lanes.time

    def _between(self, lanes, kind, count, far=False):
        """Points where `kind` changes: (points, directions across, cases), by bisection between
        neighbours that differ."""
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
                    near = alike[
                        np.argsort(np.linalg.norm(x[alike] - x[one], axis=1))[
                            random.integers(0, min(3, len(alike)))
                        ]
                    ]
                    left.append(x[one])
                    right.append(x[near])
                    case.append(k)
        if not left:
            return None
        left, right, case = np.array(left), np.array(right), np.array(case)
        direction = (right - left) / np.linalg.norm(right - left, axis=1)[:, None]
        one = kind(self.solve(left, case, far))
        left, right = bisect(
            lambda places, rows: kind(self.solve(places, case[rows], far)) == one[rows],
            left,
            right,
            16,
        )
        return (left + right) / 2, direction, case

    def border(self, decimals):
        """Starts in reach and out of reach, many of them on both sides of the border between."""
        kept = self.kept.get(("border", decimals))
        if kept is None:
            spread = self.solve(
                *self._points(100 if len(self.cases) == 1 else 40, seed=5), far=True
            )
            near = self._between(
                spread,
                lambda lanes: np.isfinite(lanes.time),
                30 if len(self.cases) == 1 else 8,
                far=True,
            )
            parts = [spread]
            for share in ((0.02,) if decimals else (0.008, 0.03)) if near is not None else ():
                middle, direction, case = near
                shift = share * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
                both, cases = (
                    np.concatenate([middle + shift, middle - shift]),
                    np.concatenate([case, case]),
                )
                keep = self.allowed(both, cases)
                parts.append(self.solve(both[keep], cases[keep], far=True))
            kept = Lanes.joined(parts)
            self.kept[("border", decimals)] = kept
        return kept

    def on_border(self, lanes):
        """True where states next to the start are of the other kind: there rounding decides."""
        reach = np.isfinite(lanes.time)
        return (np.isfinite(self._around(lanes, 0.003, far=True).time) != reach[:, None]).any(
            axis=1
        )

    def told(self, lanes, k):
        values = self.cases[lanes.case[k]]
        named = ", ".join(f"{p} = {v:.4g}" for p, v in zip(self.parameters, values))
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(self.state, lanes.x[k]))
        return f"{'for ' + named + ', ' if named else ''}from {place}"
