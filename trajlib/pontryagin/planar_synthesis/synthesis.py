"""Planar synthesis by backward integration of extremals from the target.

For the least (or greatest) phi_0(x(t_k)) + int f_0(x, u) dt, the end being free in time, at a point
or on a smooth curve g(x) = 0, the maximum principle leaves one-parameter families of extremals:
they end on the target with a covector that transversality and H = 0 determine (`terminal_sets`).
Followed backwards their controls change where H asks for another level (`plant`); they are given up
where they meet the target again (the process ends at the first hit) and where another extremal is
better. What is left is the synthesis:

    switching curve    where a control of optimal trajectories changes its level,
    dispersal curve    where two extremals of equal cost start: beyond it the other one is better,
    barrier            an extremal, mostly one that touches the target, across which the least cost jumps.

Extremals with singular arcs are not looked for. They need det(F, F_j, [F, F_j]) = 0 for the fields
with the cost as a third state, which is det(f1, [f0, f1]) for the least time: where this is
possible, `regularity()` says so, and for other costs such a problem is refused if an arc could be
followed. A control whose switching function can vanish only for good is left open there, and what
it may do is shown by the motions that hold it at one value.

Source: chapter 5 of the problem book (worked example 2, figure 5.1); V. G. Boltyansky's regular
synthesis.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from trajlib.pontryagin.planar_synthesis.arguments import (
    Final,
    greatest_rate,
    positive,
    read_plant,
    read_target,
    read_window,
    refuse_singular_arcs,
)
from trajlib.pontryagin.planar_synthesis.dispersal import (
    Curve,
    border_extremals,
    cut_at_overlaps,
    dispersal_curves,
    switching_curves,
)
from trajlib.pontryagin.planar_synthesis.fan import BEYOND, Fan
from trajlib.pontryagin.planar_synthesis.plant import Plant
from trajlib.pontryagin.planar_synthesis.terminal_sets import Ends, Transversality, families
from trajlib.pontryagin.planar_synthesis.value_function import ON_TARGET, ValueField
from trajlib.pontryagin.problem.statement import Statement

#: Neighbouring extremals are at most this share of the window apart (while there are not too many
#: of them).
SPACING = 0.025
MOST = 1500
SIDES = {"both": (1, -1), "positive": (1,), "negative": (-1,), "outside": (1,), "inside": (-1,)}


@dataclass(frozen=True)
class Synthesis:
    """What `synthesis` returns: the optimal cost, time and control in the window, and the curves on
    which they change.

    `switching_curves`, `dispersal_curves`: lists of `Curve` (`points`, shape (N, 2), `times` to the
    target). `borders`: extremals that touch the target or end a family, as `Curve` with `jump`, the
    greatest jump of the optimal cost across it (inf at the edge of the set from which the target is
    reached); `barriers` are those whose jump is not zero. `reached`: the parts of the target at
    which optimal trajectories end, as `Curve`; its `parameter` is (from, to).
    """

    problem: Statement
    window: tuple
    horizon: float
    switching_curves: list
    dispersal_curves: list
    reached: list
    _target: object = field(repr=False)
    _field: ValueField = field(repr=False)
    _touching: list = field(repr=False)
    _end_cost: object = field(repr=False)

    @cached_property
    def borders(self):
        """Extremals that touch the target or end a family; computed when first asked for."""
        return border_extremals(self._field.fans, self._field, self._touching)

    @property
    def barriers(self):
        """The borders across which the optimal cost jumps."""
        least = 1e-3 * self.horizon * self._field.grain / self._field.fans[0].times[1]
        return [curve for curve in self.borders if curve.jump > least]

    @property
    def plant(self):
        return self._field.fans[0].plant

    def cost(self, x1, x2):
        """Optimal cost from the points (arrays of one shape); nan where no extremal leads to the
        target within the horizon."""
        found, x, shape = self._best(x1, x2)
        cost = np.where(self._on_target(x), self._end_cost(x), found.cost)
        cost = np.where(np.isfinite(cost), -cost if self.problem.maximise else cost, np.nan)
        return _as_given(cost, shape)

    def time(self, x1, x2):
        """The time that the optimal process takes from the points (arrays of one shape); nan where
        the target is not reached within the horizon."""
        found, x, shape = self._best(x1, x2)
        return _as_given(np.where(self._on_target(x), 0, found.time), shape)

    def control(self, x1, x2):
        """The feedback u(x1, x2), arrays of one shape (with a row for each of several controls);
        nan where the target is not reached within the horizon.

        On a switching curve it is the control that follows. Where a control is open (`unique`), it
        is one of the values that it may have.
        """
        found, _, shape = self._best(x1, x2)
        if len(self.problem.control) == 1:
            return _as_given(found.control[:, 0], shape)
        return found.control.T.reshape(-1, *shape)

    def level(self, x1, x2):
        """The names of the controls' levels at the points: "u-", "interior", "zero", "u+" or "open"
        (tuples for several controls), "" where the target is not reached. One name, or an array of
        them in the points' shape."""
        found, _, shape = self._best(x1, x2)
        names = [self.plant.name(mode) for mode in range(len(self.plant.modes))] + [""]
        result = np.empty(len(found.mode), dtype=object)
        for k, mode in enumerate(found.mode):
            result[k] = names[mode]
        return result.reshape(shape) if shape else result[0]

    def unique(self, x1, x2):
        """Whether the maximum condition tells every control along the optimal process from the
        points; where it does not, many controls cost the same."""
        found, _, shape = self._best(x1, x2)
        held = np.array([fan.ends.held is not None for fan in self._field.fans])
        values = (found.fan < 0) | ~held[found.fan]
        return values.reshape(shape) if shape else bool(values[0])

    def reaches(self, x1, x2):
        """Whether the target can be reached from the points within the horizon."""
        time = self.time(x1, x2)
        return np.isfinite(time) if np.ndim(time) else bool(np.isfinite(time))

    def isochrone(self, time):
        """The points in the window from which the optimal process takes the time `time`: a list of
        arrays, (N, 2)."""
        if not 0 < time <= self.horizon:
            raise ValueError(
                f"time: expected a number between 0 and the horizon {self.horizon}, got {time}"
            )
        pieces = []
        for fan in self._field.fans:
            z, _ = fan.flow(fan.s, np.full(fan.s.size, float(time)))
            keep = (fan.cut >= time) & self._inside(z[:2])
            pieces += [z[:2, run].T for run in _runs(keep) if run.size > 1]
        return pieces

    def extremals(self, count=24):
        """About `count` optimal trajectories: a list of (points, controls), points of shape (K, 2)
        from far to the target."""
        chosen = []
        for fan in self._field.fans:
            long = np.flatnonzero((fan.cut > 0) & (fan.life > 1))
            share = max(
                round(count * long.size / max(sum(f.s.size for f in self._field.fans), 1)), 2
            )
            for j in self._spread(fan, long, share):
                keep = fan.times <= fan.cut[j]
                u = self.plant.control(fan.motion[keep, :, j].T, fan.mode[keep, j])
                chosen.append((fan.path[keep, :, j][::-1], (u[0] if len(u) == 1 else u.T)[::-1]))
        return chosen

    def regularity(self):
        """The conditions of Boltyansky's regular synthesis, each with what was found:
        `Regularity`."""
        from trajlib.pontryagin.planar_synthesis.regularity import regularity

        return regularity(self)

    def plot(self, ax=None, isochrones=(), extremals=24):
        """The synthesis in the phase plane; returns the Axes. `isochrones`: times whose lines are
        drawn."""
        from trajlib.pontryagin.planar_synthesis.drawing import draw

        return draw(self, ax, isochrones, extremals)

    def __repr__(self):
        return (
            f"Synthesis({len(self.switching_curves)} switching curves, "
            f"{len(self.dispersal_curves)} dispersal curves, {len(self.barriers)} barriers, "
            f"window={self.window}, horizon={self.horizon:g})"
        )

    def _best(self, x1, x2):
        """The best extremals from points, with the points (2, N) and their shape; the last question
        is remembered."""
        x, shape = self._points(x1, x2)
        last = self.__dict__.get("_asked")
        if last is None or last[0].shape != x.shape or (last[0] != x).any():
            last = self.__dict__["_asked"] = (x, self._field.exact(x))
        return last[1], x, shape

    def _points(self, x1, x2):
        x1, x2 = np.broadcast_arrays(np.asarray(x1, dtype=float), np.asarray(x2, dtype=float))
        x = np.array([x1.ravel(), x2.ravel()])
        if not (np.isfinite(x).all() and self._inside(x, 1e-9).all()):
            raise ValueError(f"x1, x2: expected finite points inside the window {self.window}")
        return x, x1.shape

    def _inside(self, x, slack=0.0):
        (left, right), (bottom, top) = self.window
        dx, dy = slack * (right - left), slack * (top - bottom)
        return (
            (x[0] >= left - dx) & (x[0] <= right + dx) & (x[1] >= bottom - dy) & (x[1] <= top + dy)
        )

    def _on_target(self, x):
        return np.abs(self._target.outside(x, 1)) < ON_TARGET

    def _spread(self, fan, long, share):
        """Indices of extremals whose far ends are evenly spread along the border of what they
        cover."""
        if not long.size:
            return []
        last = np.array([fan.path[np.flatnonzero(fan.times <= fan.cut[j])[-1], :, j] for j in long])
        along = np.append(0, np.cumsum(np.hypot(*np.diff(last, axis=0).T)))
        return long[
            np.unique(
                np.searchsorted(along, np.linspace(0, along[-1], share + 2)[1:-1]).clip(
                    0, long.size - 1
                )
            )
        ]


def synthesis(problem, *, window=((-3, 3), (-3, 3)), horizon=6.0, side="both", curve=None):
    """The synthesis of the optimal control of a planar system with bounded controls.

    `problem`: a `Problem` with two states, a free final time and numbers for all parameters; two
    terminal equations (a point) or one (a smooth curve), at which the process ends when it first
    meets it. Its initial state is not used. The cost may be the time or another one, to be least or
    greatest: the dynamics are linear in the controls, the running cost is of the second degree in
    each, with multiples of |u|, without products of two; the bounds are finite. `window`: ((left,
    right), (bottom, top)); `horizon`: the longest process looked at. `side`: for a curve, from
    which side it is met, "positive" or "negative" by the sign of the terminal expression
    ("outside", "inside" are the same words for closed curves), or "both". `curve`: ((x1(s), x2(s)),
    (s, low, high)), a parametrisation of the terminal curve in SymPy; `reached` then speaks of its
    parameter. Without it the curve is traced and the parameter is its length.

    Raises TypeError or ValueError for a problem of another kind (a given duration, for which the
    law depends on the time that is left; a running cost that is not positive at a target point;
    singular arcs that would have to be part of it), and where no extremal ends on the target.

    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> plant, bounds, anywhere = {x1: x2, x2: u}, {u: (-1, 1)}, {x1: None, x2: None}
    >>> to_rest = Problem(plant, bounds, anywhere, terminal=[x1, x2])
    >>> found = synthesis(to_rest, window=((-2, 2), (-2, 2)))
    >>> round(float(found.time(1, 0)), 9), float(found.control(1, 0)), float(found.control(-1, 0))
    (2.0, -1.0, 1.0)
    >>> saving = Problem(plant, bounds, anywhere, terminal=[x1, x2], running=1 + u**2/2)
    >>> found = synthesis(saving, window=((-2, 2), (-2, 2)))
    >>> round(float(found.cost(1, 0))**2, 9), found.level(1, 0), found.level(1, -1)
    (7.666666667, 'u-', 'interior')
    """
    window = read_window(window)
    horizon = positive(horizon, "horizon")
    plant = Plant(problem, read_plant(problem))
    if side not in SIDES:
        raise ValueError(f"side: expected one of {', '.join(map(repr, SIDES))}, got {side!r}")
    # extremals may leave the window for a while
    box = tuple((3 * low - 2 * high, 3 * high - 2 * low) for low, high in window)
    target, final = read_target(problem, SIDES[side], box, curve), Final(problem)
    refuse_singular_arcs(problem, plant, window)
    steps = int(
        np.clip(np.ceil(max(100, horizon * greatest_rate(problem, window) / 0.12)), 100, 1200)
    )

    fans, arcs, touches = [], [], []
    for sigma in target.sides:
        transversality = Transversality(target, plant, final, sigma)
        ends, touching = families(transversality)
        touches += [_single(transversality, touch, horizon, steps, box) for touch in touching]
        for family in ends:
            fan = Fan(plant, target, family, horizon, steps, box)
            _fill(fan, window)
            if (fan.life > 0).any():
                arcs.append(family)
            fans += [one for one in (fan, *_held(fan, window)) if (one.life > 0).any()]
    if not fans:
        raise ValueError(
            "terminal: no extremal ends on this target: no admissible velocity crosses it towards "
            "the side asked for"
        )
    field_ = ValueField(fans, window)
    dispersal = dispersal_curves(np.hstack([cut_at_overlaps(fan, field_) for fan in fans]), field_)
    return Synthesis(
        problem,
        window,
        horizon,
        switching_curves(fans, window),
        dispersal,
        _reached(arcs) if target.sides != (0,) else [],
        target,
        field_,
        touches,
        lambda x: final.value(*x)[0],
    )


def _fill(fan, window):
    """Put extremals into a fan until neighbours stay close, and those around a jump (a second hit)
    are as good as equal."""
    ends = fan.ends
    span = ends.high - ends.low
    fan.add(
        np.unique(
            np.concatenate(
                [np.linspace(ends.low, ends.high, 97), ends.special, _first_control_changes(fan)]
            )
        )
    )
    (left, right), (bottom, top) = window
    size = np.array([right - left, top - bottom])
    for _ in range(26):
        gap = np.diff(fan.s)
        step = np.diff(fan.path, axis=2) / size[None, :, None]
        near = ((fan.path >= [[left], [bottom]]) & (fan.path <= [[right], [top]])).all(axis=1)
        with np.errstate(invalid="ignore"):
            wide = (np.hypot(step[:, 0], step[:, 1]) > SPACING) & (near[:, 1:] | near[:, :-1])
        parts = np.where(wide, np.hypot(step[:, 0], step[:, 1]) / SPACING, 0).max(axis=0)
        split = (parts > 1) & (gap > 1e-5 * span)
        met = fan.dead == 1
        torn = (met[1:] | met[:-1]) & (np.abs(np.diff(fan.life)) >= BEYOND) & (gap > 1e-8 * span)
        # The last extremal of a family may be abnormal, without the switchings of its neighbours.
        edge = np.zeros(gap.size, bool)
        edge[[0, -1]] = ((fan.word[:, [0, -2]] != fan.word[:, [1, -1]]) & near[:, [0, -2]]).any(
            axis=0
        )
        torn |= edge & (gap > 1e-4 * span)
        if fan.s.size > MOST:
            split[:] = False
        if not (split | torn).any():
            return
        parts = np.where(split, np.clip(np.ceil(parts), 2, 6), np.where(torn, 2, 1)).astype(int)
        fan.add(
            np.concatenate(
                [
                    np.linspace(fan.s[k], fan.s[k + 1], parts[k] + 1)[1:-1]
                    for k in np.flatnonzero(parts > 1)
                ]
            )
        )


def _first_control_changes(fan):
    """The parameters at which a control next to the target changes: they have to be corners of the
    cells."""
    if fan.ends.held is not None:
        return []
    return np.concatenate([[], *(found for _, found in _changes(fan))])


def _changes(fan):
    """(number of a surface, the parameters s at which it vanishes and the first mode changes) for
    all surfaces."""
    from scipy.optimize import brentq

    s = np.linspace(fan.ends.low, fan.ends.high, 721)
    z, mode = fan.start(s)
    found = []
    for k, values in enumerate(fan.plant.surfaces(z)):

        def e(v, k=k):
            return float(fan.plant.surfaces(fan.start(v)[0])[k, 0])

        changes = np.flatnonzero((values[:-1] * values[1:] < 0) & (mode[:-1] != mode[1:]))
        exact = s[np.abs(values) < 1e-14]
        found.append(
            (
                k,
                np.append(
                    [brentq(e, s[i], s[i + 1], xtol=1e-14) for i in changes],
                    exact if exact.size < 50 else [],
                ),
            )
        )
    return found


def _held(fan, window):
    """The motions from ends at which a control is open for good: one fan for each such end, over
    the values held."""
    plant, ends, found = fan.plant, fan.ends, []
    if not any(part.open for part in plant.parts):
        return []
    for surface, values in _changes(fan):
        j = plant.owner(surface)
        if not plant.parts[j].open:
            continue
        low, high = float(plant.parts[j].low), float(plant.parts[j].high)
        for s in np.unique(np.round(values, 12)):
            # The other controls are those of the neighbours, at both sides of the end.
            near = np.clip(
                s + np.array([-1e-6, 1e-6]) * (ends.high - ends.low), ends.low, ends.high
            )
            for mode in {plant.open_mode(mode, j) for mode in fan.start(near)[1] if mode >= 0}:
                held = replace(
                    ends,
                    point=_constant(ends.point(s)),
                    covector=_constant(ends.covector(s)),
                    cost=_constant(ends.cost(s)),
                    low=low,
                    high=high,
                    special=(),
                    held=mode,
                )
                one = Fan(plant, fan.target, held, fan.times[-1], fan.times.size - 1, fan.box)
                _fill(one, window)
                found.append(one)
    return found


def _constant(value):
    """The function of s with this value, arrays with as many columns as numbers s."""
    return lambda s: np.repeat(np.asarray(value)[..., :1], np.size(s), axis=-1)


def _single(transversality, touch, horizon, steps, box):
    """One extremal by itself, for an abnormal end whose covector may point the other way."""
    s, sign = touch
    ends = Ends(
        transversality.point,
        lambda v: transversality.abnormal(v, sign),
        transversality.cost,
        s,
        s,
        transversality.side,
    )
    fan = Fan(transversality.plant, transversality.target, ends, horizon, steps, box)
    fan.add([s])
    return fan


def _reached(families_):
    """Where w > 0 a trajectory that starts near enough is optimal: the target lies at once before
    it."""
    arcs = []
    for family in families_:
        s = np.linspace(family.low, family.high, 201)
        arcs.append(Curve(family.point(s).T, np.zeros(s.size), parameter=(family.low, family.high)))
    return arcs


def _runs(keep):
    """Index arrays of the stretches on which a mask is true."""
    where = np.flatnonzero(keep)
    return np.split(where, np.flatnonzero(np.diff(where) > 1) + 1) if where.size else []


def _as_given(values, shape):
    return values.reshape(shape) if shape else float(values[0])
