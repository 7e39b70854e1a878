"""Where extremals stop to be optimal, and the curves that this leaves: switching curves, dispersal
curves, borders."""

from dataclasses import dataclass

import numpy as np

from trajlib.pontryagin.planar_synthesis.value_function import SQUARES

#: Jumps of the least cost below so many steps of the grid are not told from a steep rise.
SMALLEST_JUMP = 2
#: An extremal that costs less than another by this share of a step overtakes it.
GAIN = 1e-4
#: Interpolated costs may be wrong by less than this share of a step.
INTERPOLATED = 0.25
#: Two extremals meet at most so many steps before one is seen to be better.
BEFORE = 12
#: Parameters this close, in shares of their range, belong to one extremal.
SAME = 1e-7
#: Neighbouring extremals whose switchings are further apart, in shares of the window or in steps of
#: time, belong to two curves.
APART, STEPS_APART = 0.2, 20
#: Places where neighbouring extremals meet others lie closer together than this share of the
#: window, else they belong to two curves.
GAP = 0.05
#: Switchings within this share of the window are one place, and no curve.
SHORTEST = 1e-3


@dataclass(frozen=True)
class Curve:
    """A curve of the phase plane: `points`, shape (N, 2), with the time `times` that an optimal
    motion takes from each.

    Curves that leave the window end one point outside of it. `kind`: for switching curves "crossed"
    (second type), "followed" (first type: it is a trajectory) or "mixed"; for borders "abnormal" or
    "end of a family". For switching curves, `change`: the levels of the control before and after
    ("u-", "interior", "zero", "u+"; tuples for several controls), `velocities`: before and after,
    shape (2, 2, N). For borders, `jump`: the greatest jump of the least cost across it, `optimal`:
    whether the extremal is optimal all along, `arrives`: whether it is so at least next to the
    target, `controls`: u at the points. For parts of the target, `parameter`: from where to where.
    """

    points: np.ndarray
    times: np.ndarray
    jump: float = 0.0
    kind: str = ""
    optimal: bool = True
    arrives: bool = True
    parameter: tuple = ()
    controls: tuple = ()
    change: tuple = ()
    velocities: np.ndarray = None

    def __repr__(self):
        begin, end = (tuple(float(round(v, 6)) for v in self.points[k]) for k in (0, -1))
        change = f", {self.change[0]} to {self.change[1]}" if self.change else ""
        return f"Curve(from {begin} to {end}{change}{', ' + self.kind if self.kind else ''})"


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
    meetings = meetings[:, _in_window(meetings[5:], field)]
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
    inside = _in_window(fan.path[k, :, j].T, field)
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


def switching_curves(fans, window):
    """The curves on which the controls of optimal extremals change their levels."""
    (left, right), (bottom, top) = window
    size = np.array([right - left, top - bottom])
    curves = []
    for fan in fans:
        index, tau = fan.switchings[0].astype(int), fan.switchings[1]
        order = np.lexsort((tau, index))
        index, tau, x = index[order], tau[order], fan.switchings[2:4, order]
        before, after = fan.switchings[4:6, order].astype(int)
        velocities = fan.switchings[6:, order].reshape(2, 2, -1)
        number = np.arange(index.size) - np.searchsorted(index, index)
        optimal = tau <= fan.cut[index] + 1e-9
        for n, old, new in np.unique(np.stack([number, before, after]), axis=1).T:
            mine = np.flatnonzero((number == n) & (before == old) & (after == new) & optimal)
            for run in _together(index[mine]):
                rows = mine[np.isin(index[mine], run)]
                points = x[:, rows].T
                torn = np.abs(np.diff(points, axis=0) / size).max(axis=1, initial=0) > APART
                torn |= np.abs(np.diff(tau[rows])) > STEPS_APART * fan.times[1]
                jumps = np.flatnonzero(torn) + 1
                for piece in np.split(np.arange(rows.size), jumps):
                    inside = (
                        (points[piece] >= [left, bottom]) & (points[piece] <= [right, top])
                    ).all(axis=1)
                    for part in _together(np.flatnonzero(inside)):
                        if part.size > 2:
                            # One point more on both sides, so that the curve runs to the edge of
                            # the window.
                            take = piece[max(part[0] - 1, 0) : part[-1] + 2]
                            if (np.ptp(points[take], axis=0) < SHORTEST * size).all():
                                continue
                            v = velocities[:, :, rows[take]]
                            change = (fan.plant.name(old), fan.plant.name(new))
                            curves.append(
                                Curve(
                                    points[take],
                                    tau[rows[take]],
                                    kind=_kind(points[take], v),
                                    change=change,
                                    velocities=v,
                                )
                            )
    return curves


def crossing_angles(points, velocities):
    """Angles (radians, signed) from a curve to the velocities before and after the switching, at
    the middles of its pieces; shape (2, N - 1)."""
    tangent = np.diff(points, axis=0).T
    angles = []
    for v in velocities:
        v = (v[:, 1:] + v[:, :-1]) / 2
        angles.append(
            np.arcsin(
                np.clip(
                    (tangent[0] * v[1] - tangent[1] * v[0])
                    / (np.hypot(*tangent) * np.hypot(*v) + 1e-300),
                    -1,
                    1,
                )
            )
        )
    return np.array(angles)


def _kind(points, velocities):
    """Whether the curve is followed (it is a trajectory for one of the two levels) or crossed."""
    step = np.hypot(*np.diff(points, axis=0).T)
    angles = np.abs(crossing_angles(points, velocities))[:, step > 1e-9]
    if not angles.size:
        return ""
    along = angles.min(axis=0) < 0.02
    return "followed" if along.mean() > 0.95 else "crossed" if along.mean() < 0.2 else "mixed"


def border_extremals(fans, field, touching):
    """Extremals that touch the target (fans of one, `touching`) or end a family, with the jump of
    the least cost across them."""
    found = [("abnormal", alone, 0) for alone in touching if alone.life[0] > 1]
    for fan in fans:
        ends = np.array([fan.ends.low, fan.ends.high])
        closed = (
            np.abs(np.diff(np.vstack([fan.ends.point(ends), fan.ends.covector(ends)]))).max() < 1e-9
        )
        if not closed:
            found += [("end of a family", fan, j) for j in (0, fan.s.size - 1) if fan.life[j] > 1]
    traces, known = [], []
    for kind, fan, j in found:
        steps = np.arange(fan.life[j] + 1)
        stretch = _together(np.flatnonzero(_in_window(fan.path[steps, :, j].T, field)))
        if not stretch or stretch[0][0] > 1:
            continue
        k = np.unique(np.append(stretch[0][:: max(stretch[0].size // 20, 1)], stretch[0][-1]))
        x = fan.path[k, :, j].T
        if not any(x.shape == y.shape and np.abs(x - y).max() < 1e-9 for y in known):
            known.append(x)
            traces.append((kind, fan, j, k, x))
    if not traces:
        return []
    asked = []
    for _, fan, j, k, x in traces:
        v = fan.plant.velocity(fan.motion[k, :, j].T, fan.mode[k, j])
        normal = np.array([-v[1], v[0]]) / (np.hypot(*v) + 1e-300)
        asked.append(
            np.hstack(
                [
                    x + far * SQUARES * np.max(field.square) * normal
                    for far in (0, 1e-4, -1e-4, 1e-7, -1e-7)
                ]
            )
        )
    costs = np.split(
        field.exact(np.hstack(asked)).cost, np.cumsum([a.shape[1] for a in asked])[:-1]
    )
    return [_border(field, trace, *np.split(cost, 5)) for trace, cost in zip(traces, costs)]


def _border(field, trace, here, *sides):
    """The curve of a border from the least costs on it, and on both sides of it at two
    distances."""
    kind, fan, j, k, x = trace
    grain, tau = field.grain, fan.times[k]
    # At a fold of high order the cost is as uncertain as a root of the accuracy of the point.
    optimal = (here > fan.value[k, j] - 0.25 * grain) | ~np.isfinite(here)
    last = int(np.argmax(~optimal)) if not optimal.all() else k.size
    controls = tuple(_one_or_all(fan.plant.control(fan.motion[k, :, j].T, fan.mode[k, j])))
    if last < 6:
        return Curve(x.T, tau, 0.0, kind, optimal=False, arrives=False, controls=controls)
    # Next to the target one side may lie behind it; the jump is read off further away, where one
    # point alone is no jump.
    inner = slice(2, last)
    far_left, far_right, left, right = (
        np.where(np.isfinite(side), side, np.nan)[inner] for side in sides
    )
    far, near = np.abs(far_left - far_right), np.abs(left - right)
    # Where the cost only rises steeply, like a root of the distance, the difference is smaller at
    # the smaller distance.
    jump = np.where((near > 0.5 * far) & (near > SMALLEST_JUMP * grain), near, 0)
    jump = np.fmin(np.fmin(jump[:-2], jump[1:-1]), jump[2:])
    jump = float(np.max(jump, initial=0))
    # Beyond the horizon nothing is known: a missing side counts only where the other one is well
    # within it.
    alone = np.isnan(left) != np.isnan(right)
    if (alone & (tau[inner] < 0.9 * fan.times[-1])).mean() > 0.25:
        jump = np.inf
    points, times = x.T[:last], tau[:last]
    # one more point, so that the curve runs to the edge of the window
    if last == k.size and k[-1] < fan.life[j]:
        points = np.vstack([points, fan.path[k[-1] + 1, :, j]])
        times, controls = np.append(times, fan.times[k[-1] + 1]), (*controls, controls[-1])
    return Curve(points, times, jump, kind, optimal=last == k.size, controls=controls[: len(times)])


def _one_or_all(u):
    """The values of one control, or rows of several, from an array (k, N)."""
    return u[0] if len(u) == 1 else u.T


def _in_window(x, field):
    size = SQUARES * field.square
    low, high = field.corner - 1e-9 * size, field.corner + (1 + 1e-9) * size
    return ((x >= low[:, None]) & (x <= high[:, None])).all(axis=0)


def _together(index):
    """Stretches of consecutive integers."""
    return np.split(index, np.flatnonzero(np.diff(index) > 1) + 1) if index.size else []
