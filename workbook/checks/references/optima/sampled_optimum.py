"""Optima from sample starts: spread over the plane, and close to where laws and answers change.

A law is optimal or not on both sides of a switching curve, and a set of starts is right or wrong at
its border; so the starts next to these lines are the most informative, and they are found by
bisection between neighbours that differ. The optima themselves are those of `fastest_times`.
"""

import functools
from typing import NamedTuple

import numpy as np
import sympy as sp

from workbook.checks.references.optima.fastest_times import HORIZON
from workbook.checks.references.optima.sampled_starts import SampledStarts
from workbook.checks.references.optima.state_batch import StateBatch

#: How far from a border two answers must agree about a point, in units of the size of the state.
BESIDE, BESIDE_DECIMALS = 0.006, 0.015
#: How far from its switching curve a law is asked what it says, and the size of starts far out.
NEXT, FAR_OUT = 0.0002, 14.0
#: Up to this time the directions tried lie close enough for these.
FAR_IN_TIME = 1.5 * HORIZON
#: How long the last arcs of extremals are, the first of them the arcs of motions next to the
#: target; from `WHOLE` on extremals are followed farther back than over one switching, until their
#: states have the size `OUT` or time is up.
LAST_ARCS = (1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.8, 1.4, 2.0, 2.6)
WHOLE, OUT, BACK = 0.3, 80.0, 130.0
#: How far before a switching states are taken, in units of the last arc.
EARLIER = (0.02, 1.0, 15.0, 49.0)


class SynthesisData(NamedTuple):
    """The data of a synthesis as hashable values, so that its optimum is computed once."""

    field: tuple
    state: tuple
    control: sp.Symbol
    bounds: tuple
    target: tuple
    parameters: tuple
    start: object


def synthesis_data(system, target, parameters, start):
    """Return the data of a synthesis, with lists as tuples."""

    def fixed(value):
        return (
            tuple(map(fixed, value))
            if isinstance(value, (list, tuple, sp.MatrixBase))
            else sp.sympify(value)
        )

    target = list(target) if isinstance(target, (list, tuple)) else [target]
    return SynthesisData(
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
    """Return the `SampledOptimum` of data, the same for the same data."""
    return SampledOptimum(field, state, control, bounds, target, parameters, start)


class SampledOptimum(SampledStarts):
    """The fastest times and first controls from sample starts at sample parameters."""

    def batch(self, decimals):
        """Return starts spread over the plane, and pairs on both sides of the switching curves."""
        batch = self.cache.get(decimals)
        if batch is None:
            batch = self.cache[decimals] = self._batch(BESIDE_DECIMALS if decimals else BESIDE)
        return batch

    def _batch(self, relative_offset):
        if "near" not in self.cache:
            count = 100 if len(self.cases) == 1 else 24
            spread_batch = self._safe(self.solve(*self._points(count)))
            if not len(spread_batch.x):
                raise RuntimeError("no sample start reaches the target within the horizon")
            self.cache["spread"] = spread_batch
            self.cache["near"] = self._between(
                spread_batch, lambda batch: batch.control, 28 if len(self.cases) == 1 else 7
            )
        spread_batch, near = self.cache["spread"], self.cache["near"]
        if near is None:
            return spread_batch
        return StateBatch.concatenated(
            [spread_batch, self._safe(self._beside(near, relative_offset))]
        )

    def _beside(self, near, share, far=False):
        """Return the optima on both sides of a curve, at a distance relative to the states."""
        middle, direction, case = near
        shift = share * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
        x, case = np.concatenate([middle + shift, middle - shift]), np.concatenate([case, case])
        keep = self.allowed(x, case)
        return self.solve(x[keep], case[keep], far)

    def _safe(self, batch):
        """Return the starts off the target that are in reach with all states next to them."""
        out_of_reach = batch.take(~np.isfinite(batch.time))
        shortest = 0.15 if self.convex.kind == "hull" else 0.02
        batch = batch.take(
            np.isfinite(batch.time) & (batch.time > shortest) & (batch.time < 0.9 * HORIZON)
        )
        if self._limited is None and len(out_of_reach.x):
            self._limited = not np.isfinite(
                self.solve(out_of_reach.x[:12], out_of_reach.case[:12], far=True).time
            ).all()
        if not self._limited or not len(batch.x):
            return batch
        return batch.take(np.isfinite(self._around(batch, 0.02, count=4).time).all(axis=1))

    def next_to_curves(self):
        """Return starts on both sides of the switching curves, as close as these are known.

        Also on both sides of a target with a border; far out too if the target is a point, which the
        optimum meets as well as nearby.
        """
        starts = self.cache.get("next")
        if starts is None:
            self.batch(False)
            curves = [self.cache["near"]]
            if self.convex.point:
                random = np.random.default_rng(8)
                x = random.normal(size=(60, 2)) * FAR_OUT
                case = random.integers(len(self.cases), size=60)
                far = self.solve(x[self.allowed(x, case)], case[self.allowed(x, case)], far=True)
                far = far.take(far.time < FAR_IN_TIME)
                curves.append(self._between(far, lambda batch: batch.control, 16, far=True))
            parts = [self._sides(near, 0.02) for near in curves if near is not None]
            if self.convex.g is not None:
                parts.append(self._sides(self._on_target(16), 0.0))
            starts = self.cache["next"] = StateBatch.concatenated(parts) if parts else None
        return starts

    def extremals(self):
        """Return states on extremals followed back from a target that is a point, without a search.

        They are states next to the target and far out with the control there, and those where it changes;
        None for another target. For a linear plant an extremal is optimal if an admissible control can hold
        the state on the target.
        """
        if "followed back" not in self.cache:
            parts = (
                [self._followed_back(k) for k in range(len(self.cases))]
                if self.convex.point
                else [None]
            )
            self.cache["followed back"] = (
                None if None in parts else tuple(map(StateBatch.concatenated, zip(*parts)))
            )
        return self.cache["followed back"]

    def _followed_back(self, case):
        plant, end = self.plant, self.convex.corner(case)
        free = plant.A @ end
        equilibrium_control = -(plant.b @ free) / (plant.b @ plant.b)
        if not (
            np.allclose(free + equilibrium_control * plant.b, 0)
            and plant.bounds[0] <= equilibrium_control <= plant.bounds[1]
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
            active = (begin < zero) & ((last >= WHOLE) | (k < 2))
            for part in EARLIER if k else ():
                step = part * np.minimum(last, (zero - begin) / 50)
                states.append((plant.move(x, u, -step)[active], u[active]))
            x, begin, active = plant.move(x, u, begin - zero), zero, active & (zero < BACK)
            changes.append((x[active], u[active]))
            u = sum(plant.bounds) - u
        return [self._inner(*map(np.concatenate, zip(*part)), case) for part in (states, changes)]

    def _inner(self, x, control, case):
        x, control = (part[np.abs(x).max(axis=1) < OUT] for part in (x, control))
        batch = StateBatch(x=x, case=np.full(len(x), case), control=control)
        return batch.take(self.allowed(batch.x, batch.case))

    def _on_target(self, count):
        """Return points of the border of the target: (points, directions across, cases)."""
        random, cases = np.random.default_rng(9), range(len(self.cases))
        x = np.concatenate([self.convex.around(random, k, count) for k in cases])
        case = np.repeat(cases, count)
        for _ in range(30):
            slope = self.convex.slope(x, case)
            size = np.maximum((slope**2).sum(axis=1), 1e-9)[:, None]
            x = x - self.convex.g(x, case)[:, None] * slope / size
        return x, slope / np.sqrt(size), case

    def _sides(self, near, shortest):
        """Return starts next to a curve around which all fastest motions begin alike."""
        batch = self._beside(near, NEXT, far=True)
        around = self._around(batch, NEXT / 2, far=True, count=5)
        same_control = (
            np.isfinite(around.time)
            & (around.time > 0)
            & (around.control == batch.control[:, None])
        )
        return batch.take(
            np.isfinite(batch.time) & (batch.time > shortest) & same_control.all(axis=1)
        )

    def robust(self, batch, decimals):
        """Return where the fastest motions around begin alike: far from switching curves."""
        around = self._around(batch, (BESIDE_DECIMALS if decimals else BESIDE) / 2, count=5)
        return (around.control == batch.control[:, None]).all(axis=1)

    def beside_barrier(self, batch, far=False):
        """Return where the fastest time jumps from one state next to the start to another."""
        times = np.column_stack([self._around(batch, 0.02, far).time, batch.time])
        times = np.sort(np.where(times > 0, times, np.nan), axis=1)
        # The largest gap between two of the times: a steep slope has a wide range of times too, but
        # no such gap.
        with np.errstate(all="ignore"):
            gaps = np.diff(times, axis=1)
            return np.where(np.isnan(gaps), 0, gaps).max(axis=1) > 0.25 * batch.time

    def border(self, decimals):
        """Return starts with and without a solution, many of them on both sides of the border between."""
        border = self.cache.get(("border", decimals))
        if border is None:
            spread_batch = self.solve(
                *self._points(100 if len(self.cases) == 1 else 40, seed=5), far=True
            )
            near = self._between(
                spread_batch,
                lambda batch: np.isfinite(batch.time),
                30 if len(self.cases) == 1 else 8,
                far=True,
            )
            parts = [spread_batch]
            for share in ((0.02,) if decimals else (0.008, 0.03)) if near is not None else ():
                parts.append(self._beside(near, share, far=True))
            border = StateBatch.concatenated(parts)
            self.cache[("border", decimals)] = border
        return border

    def on_border(self, batch):
        """Return where states next to the start are of the other kind: there rounding decides."""
        reach = np.isfinite(batch.time)
        return (np.isfinite(self._around(batch, 0.003, far=True).time) != reach[:, None]).any(
            axis=1
        )
