"""Dispersal curves, where extremals meet others of the same cost."""

import numpy as np

from trajlib.pontryagin.planar_synthesis.curves import Curve, in_window
from trajlib.pontryagin.planar_synthesis.value_function import GRID

#: An extremal that costs less than another by this share of a step overtakes it.
GAIN = 1e-4
#: Interpolated costs may be wrong by less than this share of a step.
INTERPOLATED = 0.25
#: Largest number of steps between the meeting of two extremals and the step at which one is better.
BEFORE = 12
#: Parameters this close, in shares of their range, belong to one extremal.
SAME = 1e-7
#: Points where neighbouring extremals meet others lie closer together than this share of the
#: window, else they belong to two curves.
GAP = 0.05


def find_overtakings(fan, value_function):
    """Set the time at which each extremal is overtaken; return where it meets the better one.

    The time is `fan.optimal_until`. Rows of the result: number of one fan and its s, number of the
    other and its s, time, x1, x2; the fan that comes first in front.
    """
    h, fan_number, meetings = fan.times[1], value_function.fans.index(fan), []
    sequences = fan.plant.sequences
    fan.optimal_until = fan.times[fan.last_step] * (fan.last_step > 0)
    overtaken, first, better = _overtaken(fan, value_function)
    fan.optimal_until[overtaken] = fan.times[np.maximum(first - 1, 0)]
    for number, other_fan in enumerate(value_function.fans):
        members = np.flatnonzero(better.fan == number)
        if not members.size:
            continue
        columns, begin = overtaken[members], fan.times[first[members]]
        tau, partner = np.full(members.size, np.inf), np.full(members.size, np.nan)
        # The point where they meet may lie before the last switching of either.
        for back, back2 in ((0, 0), (1, 0), (0, 1), (1, 1)):
            sequence, sequence2 = (
                _shortened(sequences, fan.sequence[first[members], columns], back),
                _shortened(sequences, better.sequence[members], back2),
            )
            earlier = sequences.length[
                fan.sequence[np.maximum(first[members] - BEFORE, 0), columns]
            ]
            candidates = (sequence >= 0) & (sequence2 >= 0)
            candidates &= sequences.length[sequence] >= earlier
            selected = np.flatnonzero(candidates & ~np.isfinite(tau) if back2 else candidates)
            when, s2, ok = _meet(
                fan,
                columns[selected],
                sequence[selected],
                other_fan,
                begin[selected],
                better.s[members[selected]],
                better.time[members[selected]],
                sequence2[selected],
            )
            ok &= (
                (when > 0)
                & (when < begin[selected] + 0.5 * h)
                & (when > begin[selected] - BEFORE * h)
                & (when < tau[selected])
            )
            node = np.clip((when / h).astype(int), 0, fan.times.size - 2)
            length = sequences.length[sequence[selected]]
            ok &= (sequences.length[fan.sequence[node, columns[selected]]] <= length) & (
                length <= sequences.length[fan.sequence[node + 1, columns[selected]]]
            )
            if other_fan is fan:
                ok &= np.abs(s2 - fan.s[columns[selected]]) > 1e-4 * (fan.ends.high - fan.ends.low)
            tau[selected[ok]], partner[selected[ok]] = when[ok], s2[ok]
        ok = np.isfinite(tau)
        columns, tau, partner = columns[ok], tau[ok], partner[ok]
        fan.optimal_until[columns] = tau
        z, _ = fan.flow(fan.s[columns], tau)
        pair = np.array(
            [
                np.full(columns.size, fan_number),
                fan.s[columns],
                np.full(columns.size, number),
                partner,
            ]
        )
        turned = (fan_number > number) | ((fan_number == number) & (partner < fan.s[columns]))
        meetings.append(np.vstack([np.where(turned, pair[[2, 3, 0, 1]], pair), tau, z[:2]]))
    return np.hstack([np.empty((7, 0)), *meetings])


def _shortened(sequences, sequence, back):
    """Remove the last mode of sequences if `back` is 1; -1 where nothing is left."""
    return np.where(sequence >= 0, sequences.parent[sequence], -1) if back else sequence


def dispersal_curves(meetings, value_function):
    """Return the curves of the points where extremals meet, from `find_overtakings` of all fans.

    Each extremal meets once, and along a curve its parameter grows: so the points are sorted by it.
    A curve is drawn by the extremals of both its sides, since those of one side may be sparse where
    those of the other are dense. If it is itself an extremal, which all of the other side meet, the
    parameter of these decides.
    """
    curves = []
    meetings = meetings[:, in_window(meetings[5:], value_function)]
    for pair in np.unique(meetings[[0, 2]], axis=1).T:
        rows = meetings[:, (meetings[[0, 2]] == pair[:, None]).all(axis=0)]
        rows = rows[:, np.argsort(rows[1], kind="stable")]
        ends = value_function.fans[int(pair[0])].ends
        groups = np.cumsum(np.append(0, np.diff(rows[1]) > SAME * (ends.high - ends.low)))
        rows = rows[:, np.lexsort((rows[3], groups))]
        far = (
            np.abs(np.diff(rows[5:], axis=1) / (GRID * value_function.square[:, None])).max(
                axis=0, initial=0
            )
            > GAP
        )
        for part in np.split(rows, np.flatnonzero(far) + 1, axis=1):
            if part.shape[1] > 2:
                curves.append(Curve(part[5:].T, part[4]))
    return curves


def _overtaken(fan, value_function):
    """Return the overtaken extremals, the first step at which each is, and the better ones.

    Once overtaken, always overtaken: interpolated costs show it, and exact ones then lead back to
    the first step. Where two extremals run side by side the gain grows so slowly that it lies far
    before.
    """
    k, j = np.nonzero(np.arange(fan.times.size)[:, None] <= fan.last_step[None, :])
    inside = in_window(fan.path[k, :, j].T, value_function)
    k, j = k[inside], j[inside]
    overtaken = (
        value_function.interpolated(fan.path[k, :, j].T)[0]
        < fan.value[k, j] - INTERPOLATED * value_function.step_cost
    )
    last = np.zeros(fan.s.size, int)
    np.maximum.at(last, j, k)
    high = last.copy()
    np.minimum.at(high, j[overtaken], k[overtaken])
    columns = np.flatnonzero(high > 0)
    high = high[columns]
    better, is_better = _better(fan, value_function, columns, high)
    # Interpolated costs may be wrong: then test the last step.
    again = np.flatnonzero(~is_better & (high < last[columns]))
    high[again] = last[columns[again]]
    best, is_better[again] = _better(fan, value_function, columns[again], high[again])
    better.assign(again, best)
    columns, high, better = columns[is_better], high[is_better], better.at(is_better)
    # Back in steps of growing width to a node where nothing is better, then by bisection.
    low, back = high - 1, np.ones(high.size, int)
    searching = np.arange(high.size)
    while searching.size:
        best, is_better = _better(fan, value_function, columns[searching], low[searching])
        better.assign(searching[is_better], best.at(is_better))
        searching = searching[is_better]
        high[searching] = low[searching]
        back[searching] *= 2
        low[searching] = np.maximum(high[searching] - back[searching], 0)
        searching = searching[high[searching] > 0]
    while (open_ := np.flatnonzero(high - low > 1)).size:
        middle = (low[open_] + high[open_]) // 2
        best, is_better = _better(fan, value_function, columns[open_], middle)
        high[open_[is_better]] = middle[is_better]
        better.assign(open_[is_better], best.at(is_better))
        low[open_[~is_better]] = middle[~is_better]
    return columns, high, better


def _better(fan, value_function, columns, step):
    """Return the best extremals from points of a fan, and whether the fan's are worse."""
    x, cost = fan.path[step, :, columns].T, fan.value[step, columns]
    best = value_function.by_newton(x)
    is_better = best.cost < cost - GAIN * value_function.step_cost
    # Where Newton's method fails (next to a fold of a family) interpolated costs are used.
    missing = np.flatnonzero(~np.isfinite(best.cost))
    is_better[missing] = (
        value_function.interpolated(x[:, missing])[0]
        < cost[missing] - INTERPOLATED * value_function.step_cost
    )
    return best, is_better


def _meet(fan, columns, sequence, other_fan, tau, s2, tau2, sequence2):
    """Find where two extremals meet at the same cost, x(s, tau) = y(s2, tau2), by Newton."""
    s2, tau, tau2, good = s2.copy(), tau.copy(), tau2.copy(), np.zeros(columns.size, bool)
    plant, low, high = fan.plant, other_fan.ends.low, other_fan.ends.high
    ds, longest = 1e-6 * (high - low), 4 * fan.times[1]
    mode, mode2 = plant.sequences.mode[sequence], plant.sequences.mode[sequence2]
    active = np.arange(columns.size)
    for _ in range(12):
        z, begin = fan.arcs(fan.s[columns[active]], tau[active], sequence[active])
        up, down = np.minimum(s2[active] + ds, high), np.maximum(s2[active] - ds, low)
        y, begin2 = other_fan.arcs(
            np.concatenate([s2[active], up, down]),
            np.tile(tau2[active], 3),
            np.tile(sequence2[active], 3),
        )
        n = active.size
        # The cost as a third coordinate, in units of a step.
        residual = np.vstack([z[:2] - y[:2, :n], z[5] - y[5, :n]])
        size = np.sqrt((residual**2).sum(axis=0))
        good[active] = (
            (size < 1e-8) & (tau[active] > begin - 1e-9) & (tau2[active] > begin2[:n] - 1e-9)
        )
        slope = (y[[0, 1, 5], n : 2 * n] - y[[0, 1, 5], 2 * n :]) / (up - down)
        rate, rate2 = (
            plant.rate(m, at)[[0, 1, 5]] for m, at in ((z, mode[active]), (y[:, :n], mode2[active]))
        )
        continuing = size > 1e-13
        with np.errstate(all="ignore"):
            ds2, dtau, dtau2 = _cramer(
                -slope[:, continuing],
                rate[:, continuing],
                -rate2[:, continuing],
                -residual[:, continuing],
            )
        active = active[continuing]
        if not active.size:
            break
        s2[active] = np.clip(
            s2[active] + np.nan_to_num(ds2).clip(-0.05 * (high - low), 0.05 * (high - low)),
            low,
            high,
        )
        for values, change in ((tau, dtau), (tau2, dtau2)):
            values[active] = np.clip(
                values[active] + np.nan_to_num(change).clip(-longest, longest), 0, fan.times[-1]
            )
    return tau, s2, good


def _cramer(a, b, c, right):
    """Solve a p + b q + c r = right in space, for columns of (3, N)."""
    normal = np.cross(b.T, c.T).T
    det = (a * normal).sum(axis=0)
    return (
        (right * normal).sum(axis=0) / det,
        (a * np.cross(right.T, c.T).T).sum(axis=0) / det,
        (a * np.cross(b.T, right.T).T).sum(axis=0) / det,
    )
