"""Filling of fans: extremals are added until neighbours stay close together."""

from dataclasses import replace

import numpy as np

from trajlib.pontryagin.planar_synthesis.fan import BEYOND, Fan
from trajlib.pontryagin.planar_synthesis.terminal_sets import EndFamily

#: Neighbouring extremals are at most this share of the window apart (while there are not too many
#: of them).
SPACING = 0.025
MAX_EXTREMALS = 1500


def fill(fan, window):
    """Add extremals to a fan until neighbours stay close.

    Those around a jump (a second hit of the target) become nearly equal.
    """
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
        met = fan.outcome == 1
        jumping = (
            (met[1:] | met[:-1]) & (np.abs(np.diff(fan.last_step)) >= BEYOND) & (gap > 1e-8 * span)
        )
        # The last extremal of a family may be abnormal, without the switchings of its neighbours.
        edge = np.zeros(gap.size, bool)
        edge[[0, -1]] = (
            (fan.sequence[:, [0, -2]] != fan.sequence[:, [1, -1]]) & near[:, [0, -2]]
        ).any(axis=0)
        jumping |= edge & (gap > 1e-4 * span)
        if fan.s.size > MAX_EXTREMALS:
            split[:] = False
        if not (split | jumping).any():
            return
        parts = np.where(split, np.clip(np.ceil(parts), 2, 6), np.where(jumping, 2, 1)).astype(int)
        fan.add(
            np.concatenate(
                [
                    np.linspace(fan.s[k], fan.s[k + 1], parts[k] + 1)[1:-1]
                    for k in np.flatnonzero(parts > 1)
                ]
            )
        )


def _first_control_changes(fan):
    """Return the parameters at which the control next to the target changes: corners of cells."""
    if fan.ends.held is not None:
        return []
    return np.concatenate([[], *(values for _, values in _changes(fan))])


def _changes(fan):
    """Return (surface, parameters s at which it vanishes and the first mode changes)."""
    from scipy.optimize import brentq

    s = np.linspace(fan.ends.low, fan.ends.high, 721)
    z, mode = fan.start(s)
    result = []
    for k, values in enumerate(fan.plant.surfaces(z)):

        def e(v, k=k):
            return float(fan.plant.surfaces(fan.start(v)[0])[k, 0])

        changes = np.flatnonzero((values[:-1] * values[1:] < 0) & (mode[:-1] != mode[1:]))
        exact = s[np.abs(values) < 1e-14]
        result.append(
            (
                k,
                np.append(
                    [brentq(e, s[i], s[i + 1], xtol=1e-14) for i in changes],
                    exact if exact.size < 50 else [],
                ),
            )
        )
    return result


def held_fans(fan, window):
    """Return a fan over the held values for each end at which a control is open for good."""
    plant, ends, fans = fan.plant, fan.ends, []
    if not any(term.open for term in plant.terms):
        return []
    for surface, values in _changes(fan):
        j = plant.owner(surface)
        if not plant.terms[j].open:
            continue
        low, high = float(plant.terms[j].low), float(plant.terms[j].high)
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
                fan_of_end = Fan(
                    plant, fan.target, held, fan.times[-1], fan.times.size - 1, fan.box
                )
                fill(fan_of_end, window)
                fans.append(fan_of_end)
    return fans


def _constant(value):
    """Return the function of s with this value, with as many columns as numbers s."""
    return lambda s: np.repeat(np.asarray(value)[..., :1], np.size(s), axis=-1)


def single_extremal(transversality, touch, horizon, steps, box):
    """Return a fan of one extremal, for an abnormal end whose covector may point the other way."""
    s, sign = touch
    ends = EndFamily(
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
