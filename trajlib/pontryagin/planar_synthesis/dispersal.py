"""Where extremals meet others of the same cost: the dispersal curves, beyond which they are not optimal."""

import numpy as np

from trajlib.pontryagin.planar_synthesis.curves import Curve, in_window
from trajlib.pontryagin.planar_synthesis.value_function import SQUARES

#: An extremal that costs less than another by this share of a step overtakes it.
GAIN = 1e-4
#: Interpolated costs may be wrong by less than this share of a step.
INTERPOLATED = 0.25
#: Two extremals meet at most so many steps before one is seen to be better.
BEFORE = 12
#: Parameters this close, in shares of their range, belong to one extremal.
SAME = 1e-7
#: Points where neighbouring extremals meet others lie closer together than this share of the
#: window, else they belong to two curves.
GAP = 0.05


def cut_at_overlaps(fan, field):
    """Find the time at which each extremal is overtaken (`fan.cut`); returns where it meets the
    better one.

    Rows: number of one fan and its s, number of the other and its s, time, x1, x2; those of the fan
    that comes first in front.
    """
    h, own, meetings = fan.times[1], field.fans.index(fan), []
    words = fan.plant.words
    fan.cut = fan.times[fan.life] * (fan.life > 0)
    overtaken, first, better = _overtaken(fan, field)
    fan.cut[overtaken] = fan.times[np.maximum(first - 1, 0)]
    for number, other in enumerate(field.fans):
        mine = np.flatnonzero(better.fan == number)
        if not mine.size:
            continue
        which, begin = overtaken[mine], fan.times[first[mine]]
        tau, partner = np.full(mine.size, np.inf), np.full(mine.size, np.nan)
        # The place where they meet may lie before the last switching of either.
        for back, back2 in ((0, 0), (1, 0), (0, 1), (1, 1)):
            word, word2 = (
                _shortened(words, fan.word[first[mine], which], back),
                _shortened(words, better.word[mine], back2),
            )
            earlier = words.length[fan.word[np.maximum(first[mine] - BEFORE, 0), which]]
            tried = (word >= 0) & (word2 >= 0)
            tried &= words.length[word] >= earlier
            some = np.flatnonzero(tried & ~np.isfinite(tau) if back2 else tried)
            when, s2, ok = _meet(
                fan,
                which[some],
                word[some],
                other,
                begin[some],
                better.s[mine[some]],
                better.time[mine[some]],
                word2[some],
            )
            ok &= (
                (when > 0)
                & (when < begin[some] + 0.5 * h)
                & (when > begin[some] - BEFORE * h)
                & (when < tau[some])
            )
            node = np.clip((when / h).astype(int), 0, fan.times.size - 2)
            length = words.length[word[some]]
            ok &= (words.length[fan.word[node, which[some]]] <= length) & (
                length <= words.length[fan.word[node + 1, which[some]]]
            )
            if other is fan:
                ok &= np.abs(s2 - fan.s[which[some]]) > 1e-4 * (fan.ends.high - fan.ends.low)
            tau[some[ok]], partner[some[ok]] = when[ok], s2[ok]
        ok = np.isfinite(tau)
        which, tau, partner = which[ok], tau[ok], partner[ok]
        fan.cut[which] = tau
        z, _ = fan.flow(fan.s[which], tau)
        pair = np.array(
            [np.full(which.size, own), fan.s[which], np.full(which.size, number), partner]
        )
        turned = (own > number) | ((own == number) & (partner < fan.s[which]))
        meetings.append(np.vstack([np.where(turned, pair[[2, 3, 0, 1]], pair), tau, z[:2]]))
    return np.hstack([np.empty((7, 0)), *meetings])


def _shortened(words, word, back):
    """Words without their last mode if `back` is 1; -1 where nothing is left."""
    return np.where(word >= 0, words.parent[word], -1) if back else word


def dispersal_curves(meetings, field):
    """The curves of the places where extremals meet, from the rows of `cut_at_overlaps` for all
    fans.

    Each extremal meets once, and along a curve its parameter grows: so the places are sorted by it.
    A curve is drawn by the extremals of both its sides, since those of one side may be sparse where
    those of the other are dense. If it is itself an extremal, which all of the other side meet, the
    parameter of these decides.
    """
    curves = []
    meetings = meetings[:, in_window(meetings[5:], field)]
    for pair in np.unique(meetings[[0, 2]], axis=1).T:
        mine = meetings[:, (meetings[[0, 2]] == pair[:, None]).all(axis=0)]
        mine = mine[:, np.argsort(mine[1], kind="stable")]
        ends = field.fans[int(pair[0])].ends
        one = np.cumsum(np.append(0, np.diff(mine[1]) > SAME * (ends.high - ends.low)))
        mine = mine[:, np.lexsort((mine[3], one))]
        far = (
            np.abs(np.diff(mine[5:], axis=1) / (SQUARES * field.square[:, None])).max(
                axis=0, initial=0
            )
            > GAP
        )
        for part in np.split(mine, np.flatnonzero(far) + 1, axis=1):
            if part.shape[1] > 2:
                curves.append(Curve(part[5:].T, part[4]))
    return curves


def _overtaken(fan, field):
    """(which extremals are overtaken in the window, the first step of each at which another is
    better, these: `Best`).

    Once overtaken, always overtaken: interpolated costs show it, and exact ones then lead back to
    the first step. Where two extremals run side by side the gain grows so slowly that it lies far
    before.
    """
    k, j = np.nonzero(np.arange(fan.times.size)[:, None] <= fan.life[None, :])
    inside = in_window(fan.path[k, :, j].T, field)
    k, j = k[inside], j[inside]
    seen = field.interpolated(fan.path[k, :, j].T)[0] < fan.value[k, j] - INTERPOLATED * field.grain
    last = np.zeros(fan.s.size, int)
    np.maximum.at(last, j, k)
    high = last.copy()
    np.minimum.at(high, j[seen], k[seen])
    which = np.flatnonzero(high > 0)
    high = high[which]
    better, late = _better(fan, field, which, high)
    # Interpolated costs can err: then the last step tells.
    again = np.flatnonzero(~late & (high < last[which]))
    high[again] = last[which[again]]
    found, late[again] = _better(fan, field, which[again], high[again])
    better.put(again, found)
    which, high, better = which[late], high[late], better.at(late)
    # Back in steps of growing width to a node where nothing is better, then by bisection.
    low, back = high - 1, np.ones(high.size, int)
    going = np.arange(high.size)
    while going.size:
        found, late = _better(fan, field, which[going], low[going])
        better.put(going[late], found.at(late))
        going = going[late]
        high[going] = low[going]
        back[going] *= 2
        low[going] = np.maximum(high[going] - back[going], 0)
        going = going[high[going] > 0]
    while (open_ := np.flatnonzero(high - low > 1)).size:
        middle = (low[open_] + high[open_]) // 2
        found, late = _better(fan, field, which[open_], middle)
        high[open_[late]] = middle[late]
        better.put(open_[late], found.at(late))
        low[open_[~late]] = middle[~late]
    return which, high, better


def _better(fan, field, which, step):
    """The best extremals from the points of a fan at given steps, and whether they are better than
    those of the fan."""
    x, cost = fan.path[step, :, which].T, fan.value[step, which]
    found = field.polished(x)
    late = found.cost < cost - GAIN * field.grain
    # Where Newton's method fails (next to a fold of a family) interpolated costs have to do.
    missing = np.flatnonzero(~np.isfinite(found.cost))
    late[missing] = (
        field.interpolated(x[:, missing])[0] < cost[missing] - INTERPOLATED * field.grain
    )
    return found, late


def _meet(fan, which, word, other, tau, s2, tau2, word2):
    """Newton's method for x(s, tau) = y(s2, tau2): two extremals that start at one point and cost
    the same."""
    s2, tau, tau2, good = s2.copy(), tau.copy(), tau2.copy(), np.zeros(which.size, bool)
    plant, low, high = fan.plant, other.ends.low, other.ends.high
    ds, longest = 1e-6 * (high - low), 4 * fan.times[1]
    mode, mode2 = plant.words.mode[word], plant.words.mode[word2]
    busy = np.arange(which.size)
    for _ in range(12):
        z, begin = fan.arcs(fan.s[which[busy]], tau[busy], word[busy])
        up, down = np.minimum(s2[busy] + ds, high), np.maximum(s2[busy] - ds, low)
        y, begin2 = other.arcs(
            np.concatenate([s2[busy], up, down]), np.tile(tau2[busy], 3), np.tile(word2[busy], 3)
        )
        n = busy.size
        # The cost as a third coordinate, in units of a step.
        miss = np.vstack([z[:2] - y[:2, :n], z[5] - y[5, :n]])
        size = np.sqrt((miss**2).sum(axis=0))
        good[busy] = (size < 1e-8) & (tau[busy] > begin - 1e-9) & (tau2[busy] > begin2[:n] - 1e-9)
        slope = (y[[0, 1, 5], n : 2 * n] - y[[0, 1, 5], 2 * n :]) / (up - down)
        rate, rate2 = (
            plant.rate(m, at)[[0, 1, 5]] for m, at in ((z, mode[busy]), (y[:, :n], mode2[busy]))
        )
        go = size > 1e-13
        with np.errstate(all="ignore"):
            ds2, dtau, dtau2 = _cramer(-slope[:, go], rate[:, go], -rate2[:, go], -miss[:, go])
        busy = busy[go]
        if not busy.size:
            break
        s2[busy] = np.clip(
            s2[busy] + np.nan_to_num(ds2).clip(-0.05 * (high - low), 0.05 * (high - low)), low, high
        )
        for values, change in ((tau, dtau), (tau2, dtau2)):
            values[busy] = np.clip(
                values[busy] + np.nan_to_num(change).clip(-longest, longest), 0, fan.times[-1]
            )
    return tau, s2, good


def _cramer(a, b, c, right):
    """Solutions (p, q, r) of a p + b q + c r = right in space, columns of (3, N)."""
    normal = np.cross(b.T, c.T).T
    det = (a * normal).sum(axis=0)
    return (
        (right * normal).sum(axis=0) / det,
        (a * np.cross(right.T, c.T).T).sum(axis=0) / det,
        (a * np.cross(b.T, right.T).T).sum(axis=0) / det,
    )
