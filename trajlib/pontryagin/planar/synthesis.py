"""Planar time-optimal synthesis by backward integration of extremals from the target.

For x' = f0(x) + f1(x) u, u_- <= u <= u_+ and the least time to a point or a smooth curve g(x) = 0 the maximum principle
leaves one-parameter families of extremals: they end on the target, the costate there is normal to it (transversality)
and max_u psi^T f = lambda_0 >= 0 (H = 0). Followed backwards they switch where psi^T f1 = 0; they are given up where
they meet the target again (the process ends at the first hit) and where another extremal is faster. What is left is the
synthesis:

    switching curve    where the control of optimal trajectories jumps,
    dispersal curve    where two extremals of equal time start: beyond it the other one is faster,
    barrier            an extremal, mostly one that touches the target, across which the least time jumps.

Extremals with singular arcs are not looked for. They need det(f1, [f0, f1]) = 0: where this is possible, `regularity()`
says so. Source: chapter 5 of the problem book (worked example 2, figure 5.1); V. G. Boltyansky's regular synthesis.
"""
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..statement import Problem
from .cuts import Curve, border_extremals, cut_at_overlaps, dispersal_curves, switching_curves
from .fan import BEYOND, Fan
from .reading import greatest_rate, positive, read_plant, read_target, read_window
from .terminal_sets import Ends, families
from .time_field import ON_TARGET, TimeField

#: Neighbouring extremals are at most this share of the window apart (while there are not too many of them).
SPACING = 0.025
MOST = 1500
SIDES = {"both": (1, -1), "positive": (1,), "negative": (-1,), "outside": (1,), "inside": (-1,)}


@dataclass(frozen=True)
class Synthesis:
    """What `synthesis` returns: the least time and the optimal control in the window, and the curves on which they
    change.

    `switching_curves`, `dispersal_curves`: lists of `Curve` (`points`, shape (N, 2), `times` to the target).
    `borders`: extremals that touch the target or end a family, as `Curve` with `jump`, the greatest jump of the least
    time across it (inf at the edge of the set from which the target is reached); `barriers` are those whose jump is not
    zero. `reached`: the parts of the target at which optimal trajectories end, as `Curve`; its `parameter` is (from,
    to).
    """

    problem: Problem
    window: tuple
    horizon: float
    switching_curves: list
    dispersal_curves: list
    reached: list
    _target: object = field(repr=False)
    _field: TimeField = field(repr=False)
    _touching: list = field(repr=False)

    @cached_property
    def borders(self):
        """Extremals that touch the target or end a family; computed when first asked for."""
        return border_extremals(self._field.fans, self._field, self._touching)

    @property
    def barriers(self):
        """The borders across which the least time jumps."""
        return [curve for curve in self.borders if curve.jump > 1e-3*self.horizon]

    @property
    def plant(self):
        return self._field.fans[0].plant

    def time(self, x1, x2):
        """Least time from the points (arrays of one shape); nan where the target is not reached within the horizon."""
        x, shape = self._points(x1, x2)
        time, _, _ = self._field.exact(x)
        time[self._on_target(x)] = 0
        return _as_given(np.where(np.isfinite(time), time, np.nan), shape)

    def control(self, x1, x2):
        """The feedback u(x1, x2), arrays of one shape; nan where the target is not reached within the horizon.

        On a switching curve it is the control that follows.
        """
        x, shape = self._points(x1, x2)
        time, sign, _ = self._field.exact(x)
        return _as_given(np.where(np.isfinite(time), self.plant.control(sign), np.nan), shape)

    def reaches(self, x1, x2):
        """Whether the target can be reached from the points within the horizon."""
        time = self.time(x1, x2)
        return np.isfinite(time) if np.ndim(time) else bool(np.isfinite(time))

    def isochrone(self, time):
        """The points from which the least time is `time`: a list of arrays, shape (N, 2), inside the window."""
        if not 0 < time <= self.horizon:
            raise ValueError(f"time: expected a number between 0 and the horizon {self.horizon}, got {time}")
        pieces = []
        for fan in self._field.fans:
            z, _ = fan.flow(fan.s, np.full(fan.s.size, float(time)))
            keep = (fan.cut >= time) & self._inside(z[:2])
            pieces += [z[:2, run].T for run in _runs(keep) if run.size > 1]
        return pieces

    def extremals(self, count=24):
        """About `count` optimal trajectories: a list of (points, controls), points of shape (K, 2) from far to the
        target."""
        chosen = []
        for fan in self._field.fans:
            long = np.flatnonzero((fan.cut > 0) & (fan.life > 1))
            share = max(int(round(count*long.size/max(sum(f.s.size for f in self._field.fans), 1))), 2)
            for j in self._spread(fan, long, share):
                keep = fan.times <= fan.cut[j]
                chosen.append((fan.path[keep, :, j][::-1], self.plant.control(fan.sign[keep, j])[::-1]))
        return chosen

    def regularity(self):
        """The conditions of Boltyansky's regular synthesis, each with what was found: `Regularity`."""
        from .regularity import regularity

        return regularity(self)

    def plot(self, ax=None, isochrones=(), extremals=24):
        """The synthesis in the phase plane; returns the Axes. `isochrones`: times whose lines are drawn."""
        from .picture import draw

        return draw(self, ax, isochrones, extremals)

    def __repr__(self):
        return (f"Synthesis({len(self.switching_curves)} switching curves, {len(self.dispersal_curves)} dispersal "
                f"curves, "
                f"{len(self.barriers)} barriers, window={self.window}, horizon={self.horizon:g})")

    def _points(self, x1, x2):
        x1, x2 = np.broadcast_arrays(np.asarray(x1, dtype=float), np.asarray(x2, dtype=float))
        x = np.array([x1.ravel(), x2.ravel()])
        if not (np.isfinite(x).all() and self._inside(x, 1e-9).all()):
            raise ValueError(f"x1, x2: expected finite points inside the window {self.window}")
        return x, x1.shape

    def _inside(self, x, slack=0.0):
        (left, right), (bottom, top) = self.window
        dx, dy = slack*(right - left), slack*(top - bottom)
        return (x[0] >= left - dx) & (x[0] <= right + dx) & (x[1] >= bottom - dy) & (x[1] <= top + dy)

    def _on_target(self, x):
        return np.abs(self._target.outside(x, 1)) < ON_TARGET

    def _spread(self, fan, long, share):
        """Indices of extremals whose far ends are evenly spread along the border of what they cover."""
        if not long.size:
            return []
        last = np.array([fan.path[np.flatnonzero(fan.times <= fan.cut[j])[-1], :, j] for j in long])
        along = np.append(0, np.cumsum(np.hypot(*np.diff(last, axis=0).T)))
        return long[np.unique(np.searchsorted(along, np.linspace(0, along[-1], share
                                                                 + 2)[1:-1]).clip(0, long.size - 1))]


def synthesis(problem, *, window=((-3, 3), (-3, 3)), horizon=6.0, side="both", curve=None):
    """The time-optimal synthesis of a planar system that is affine in one bounded control.

    `problem`: a `Problem` whose cost is the time, with two states, one control and numbers for all parameters; two
    terminal equations (a point) or one (a smooth curve). Its initial state is not used. `window`: ((left, right),
    (bottom, top)); `horizon`: the longest time looked at. `side`: for a curve, from which side it is met, "positive" or
    "negative" by the sign of the terminal expression ("outside", "inside" are the same words for closed curves), or
    "both". `curve`: ((x1(s), x2(s)), (s, low, high)), a parametrisation of the terminal curve in SymPy; `reached` then
    speaks of its parameter. Without it the curve is traced and the parameter is its length.

    Raises TypeError or ValueError for a problem of another kind, and where no extremal ends on the target.

    >>> import sympy as sp
    >>> from trajlib.pontryagin import Problem
    >>> x1, x2, u = sp.symbols("x1 x2 u")
    >>> to_rest = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: None, x2: None}, terminal=[x1, x2])
    >>> found = synthesis(to_rest, window=((-2, 2), (-2, 2)))
    >>> round(float(found.time(1, 0)), 9), float(found.control(1, 0)), float(found.control(-1, 0))
    (2.0, -1.0, 1.0)
    """
    window = read_window(window)
    horizon = positive(horizon, "horizon")
    plant = read_plant(problem)
    if side not in SIDES:
        raise ValueError(f'side: expected one of {", ".join(map(repr, SIDES))}, got {side!r}')
    # extremals may leave the window for a while
    box = tuple((3*low - 2*high, 3*high - 2*low) for low, high in window)
    target = read_target(problem, SIDES[side], box, curve)
    steps = int(np.clip(np.ceil(max(100, horizon*greatest_rate(problem, window)/0.12)), 100, 1200))

    fans, arcs, touching = [], [], []
    for sigma in target.sides:
        ends, touches = families(target, plant, sigma)
        touching += [(sigma, s, sign) for s, sign in touches]
        for family in ends:
            fan = Fan(plant, target, family, horizon, steps, box)
            _fill(fan, window)
            if (fan.life > 0).any():
                fans.append(fan)
                arcs.append(family)
    if not fans:
        raise ValueError("terminal: no extremal ends on this target: no admissible velocity crosses it towards the "
                         "side asked for")
    field_ = TimeField(fans, window)
    dispersal = dispersal_curves(np.hstack([cut_at_overlaps(fan, field_) for fan in fans]), field_)
    touches = [_single(plant, target, touch, horizon, steps, box) for touch in touching]
    return Synthesis(problem, window, horizon, switching_curves(fans, window), dispersal, _reached(arcs)
                     if target.sides != (0,) else [],
                     target, field_, touches)


def _fill(fan, window):
    """Put extremals into a fan until neighbours stay close, and those around a jump (a second hit) are as good as
    equal."""
    ends = fan.ends
    span = ends.high - ends.low
    fan.add(np.unique(np.concatenate([np.linspace(ends.low, ends.high, 97), ends.special,
                                      _first_control_changes(fan)])))
    (left, right), (bottom, top) = window
    size = np.array([right - left, top - bottom])
    for _ in range(26):
        gap = np.diff(fan.s)
        step = np.diff(fan.path, axis=2)/size[None, :, None]
        near = ((fan.path >= [[left], [bottom]]) & (fan.path <= [[right], [top]])).all(axis=1)
        with np.errstate(invalid="ignore"):
            wide = (np.hypot(step[:, 0], step[:, 1]) > SPACING) & (near[:, 1:] | near[:, :-1])
        parts = np.where(wide, np.hypot(step[:, 0], step[:, 1])/SPACING, 0).max(axis=0)
        split = (parts > 1) & (gap > 1e-5*span)
        met = fan.dead == 1
        torn = (met[1:] | met[:-1]) & (np.abs(np.diff(fan.life)) >= BEYOND) & (gap > 1e-8*span)
        if fan.s.size > MOST:
            split[:] = False
        if not (split | torn).any():
            return
        parts = np.where(split, np.clip(np.ceil(parts), 2, 6), np.where(torn, 2, 1)).astype(int)
        fan.add(np.concatenate([np.linspace(fan.s[k], fan.s[k + 1], parts[k] + 1)[1:-1]
                                for k in np.flatnonzero(parts > 1)]))


def _first_control_changes(fan):
    """The parameters at which the control next to the target changes: they have to be corners of the cells."""
    from scipy.optimize import brentq

    s = np.linspace(fan.ends.low, fan.ends.high, 721)
    z, sign = fan.start(s)

    def phi(v):
        return float(fan.plant.switching(fan.start(np.array([v]))[0])[0])

    values = fan.plant.switching(z)
    changes = np.flatnonzero((values[:-1]*values[1:] < 0) & (sign[:-1] != sign[1:]))
    exact = s[np.abs(values) < 1e-14]
    return np.append([brentq(phi, s[k], s[k + 1], xtol=1e-14) for k in changes], exact if exact.size < 50 else [])


def _single(plant, target, touch, horizon, steps, box):
    """One extremal by itself, for an abnormal end whose costate may point the other way."""
    sigma, s, sign = touch
    fan = Fan(plant, target, Ends(target.point, lambda v: target.costate(v, sigma), s, s, sigma), horizon, steps, box)
    fan.flip = sign
    fan.add([s])
    return fan


def _reached(families_):
    """Where w > 0 a trajectory that starts near enough is optimal: the target lies at once before it."""
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
