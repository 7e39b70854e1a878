"""Where extremals stop to be optimal, and the curves that this leaves: switching curves, dispersal curves, borders."""
from dataclasses import dataclass

import numpy as np

from .time_field import SQUARES

#: Jumps of the least time below so many steps of the grid are not told from a steep rise.
SMALLEST_JUMP = 2
#: An extremal that needs less time than another by this share of a step overtakes it.
GAIN = 1e-4
#: Interpolated times may be wrong by less than this share of a step.
INTERPOLATED = 0.25
#: Two extremals meet at most so many steps before one is seen to be faster.
BEFORE = 12
#: Parameters this close, in shares of their range, belong to one extremal.
SAME = 1e-7
#: Neighbouring extremals whose switchings are further apart, in shares of the window or in steps of time, belong to two
#: curves.
APART, STEPS_APART = 0.2, 20
#: Places where neighbouring extremals meet others lie closer together than this share of the window, else they belong
#: to two curves.
GAP = 0.05
#: Switchings within this share of the window are one place, and no curve.
SHORTEST = 1e-3


@dataclass(frozen=True)
class Curve:
    """A curve of the phase plane: `points`, shape (N, 2), with the least time `times` from each.

    Curves that leave the window end one point outside of it. `kind`: for switching curves "crossed" (second type),
    "followed" (first type: it is a trajectory) or "mixed"; for borders "abnormal" or "end of a family". For borders,
    `jump`: the greatest jump of the least time across it, `optimal`: whether the extremal is optimal all along,
    `arrives`: whether it is so at least next to the target, `controls`: u at the points. For parts of the target,
    `parameter`: from where to where.
    """

    points: np.ndarray
    times: np.ndarray
    jump: float = 0.0
    kind: str = ""
    optimal: bool = True
    arrives: bool = True
    parameter: tuple = ()
    controls: tuple = ()

    def __repr__(self):
        begin, end = (tuple(float(round(v, 6)) for v in self.points[k]) for k in (0, -1))
        return f"Curve(from {begin} to {end}{', ' + self.kind if self.kind else ''})"


def cut_at_overlaps(fan, field):
    """Find the time at which each extremal is overtaken (`fan.cut`); returns where it meets the faster one.

    Rows: number of one fan and its s, number of the other and its s, time, x1, x2; those of the fan that comes first in
    front.
    """
    h, own, meetings = fan.times[1], field.fans.index(fan), []
    fan.cut = fan.times[fan.life]*(fan.life > 0)
    overtaken, first, faster = _overtaken(fan, field)
    fan.cut[overtaken] = fan.times[np.maximum(first - 1, 0)]
    for number, other in enumerate(field.fans):
        mine = np.flatnonzero(faster.fan == number)
        if not mine.size:
            continue
        which, begin = overtaken[mine], fan.times[first[mine]]
        tau, partner = np.full(mine.size, np.inf), np.full(mine.size, np.nan)
        # The place where they meet may lie before the last switching of either.
        for back, back2 in ((0, 0), (1, 0), (0, 1), (1, 1)):
            count, count2 = fan.count[first[mine], which] - back, faster.count[mine] - back2
            tried = (count >= fan.count[np.maximum(first[mine] - BEFORE, 0), which]) & (count2 >= 0)
            some = np.flatnonzero(tried & ~np.isfinite(tau) if back2 else tried)
            when, s2, ok = _meet(fan, which[some], count[some], other, begin[some], faster.s[mine[some]],
                                 faster.first[mine[some]],
                                 count2[some])
            ok &= (when > 0) & (when < begin[some] + 0.5*h) & (when > begin[some] - BEFORE*h) & (when < tau[some])
            node = np.clip((when/h).astype(int), 0, fan.times.size - 2)
            ok &= (fan.count[node, which[some]] <= count[some]) & (count[some] <= fan.count[node + 1, which[some]])
            if other is fan:
                ok &= np.abs(s2 - fan.s[which[some]]) > 1e-4*(fan.ends.high - fan.ends.low)
            tau[some[ok]], partner[some[ok]] = when[ok], s2[ok]
        ok = np.isfinite(tau)
        which, tau, partner = which[ok], tau[ok], partner[ok]
        fan.cut[which] = tau
        z, _ = fan.flow(fan.s[which], tau)
        pair = np.array([np.full(which.size, own), fan.s[which], np.full(which.size, number), partner])
        turned = (own > number) | ((own == number) & (partner < fan.s[which]))
        meetings.append(np.vstack([np.where(turned, pair[[2, 3, 0, 1]], pair), tau, z[:2]]))
    return np.hstack([np.empty((7, 0)), *meetings])


def dispersal_curves(meetings, field):
    """The curves of the places where extremals meet, from the rows of `cut_at_overlaps` for all fans.

    Each extremal meets once, and along a curve its parameter grows: so the places are sorted by it. A curve is drawn by
    the extremals of both its sides, since those of one side may be sparse where those of the other are dense. If it is
    itself an extremal, which all of the other side meet, the parameter of these decides.
    """
    curves = []
    meetings = meetings[:, _in_window(meetings[5:], field)]
    for pair in np.unique(meetings[[0, 2]], axis=1).T:
        mine = meetings[:, (meetings[[0, 2]] == pair[:, None]).all(axis=0)]
        mine = mine[:, np.argsort(mine[1], kind="stable")]
        ends = field.fans[int(pair[0])].ends
        one = np.cumsum(np.append(0, np.diff(mine[1]) > SAME*(ends.high - ends.low)))
        mine = mine[:, np.lexsort((mine[3], one))]
        far = np.abs(np.diff(mine[5:], axis=1)/(SQUARES*field.square[:, None])).max(axis=0, initial=0) > GAP
        for part in np.split(mine, np.flatnonzero(far) + 1, axis=1):
            if part.shape[1] > 2:
                curves.append(Curve(part[5:].T, part[4]))
    return curves


def _overtaken(fan, field):
    """(which extremals are overtaken in the window, the first step of each at which another is faster, these:
    `Fastest`).

    Once overtaken, always overtaken: interpolated times show it, and exact times then lead back to the first step.
    Where two extremals run side by side the gain grows so slowly that it lies far before.
    """
    k, j = np.nonzero(np.arange(fan.times.size)[:, None] <= fan.life[None, :])
    inside = _in_window(fan.path[k, :, j].T, field)
    k, j = k[inside], j[inside]
    seen = field.interpolated(fan.path[k, :, j].T)[0] < fan.times[k] - INTERPOLATED*fan.times[1]
    last = np.zeros(fan.s.size, int)
    np.maximum.at(last, j, k)
    high = last.copy()
    np.minimum.at(high, j[seen], k[seen])
    which = np.flatnonzero(high > 0)
    high = high[which]
    faster, late = _faster(fan, field, which, high)
    # Interpolated times can err: then the last step tells.
    again = np.flatnonzero(~late & (high < last[which]))
    high[again] = last[which[again]]
    found, late[again] = _faster(fan, field, which[again], high[again])
    faster.put(again, found)
    which, high, faster = which[late], high[late], faster.at(late)
    # Back in steps of growing width to a node where nothing is faster, then by bisection.
    low, back = high - 1, np.ones(high.size, int)
    going = np.arange(high.size)
    while going.size:
        found, late = _faster(fan, field, which[going], low[going])
        faster.put(going[late], found.at(late))
        going = going[late]
        high[going] = low[going]
        back[going] *= 2
        low[going] = np.maximum(high[going] - back[going], 0)
        going = going[high[going] > 0]
    while (open_ := np.flatnonzero(high - low > 1)).size:
        middle = (low[open_] + high[open_])//2
        found, late = _faster(fan, field, which[open_], middle)
        high[open_[late]] = middle[late]
        faster.put(open_[late], found.at(late))
        low[open_[~late]] = middle[~late]
    return which, high, faster


def _faster(fan, field, which, step):
    """The fastest extremals from the points of a fan at given steps, and whether they are faster than those of the
    fan."""
    x, tau, h = fan.path[step, :, which].T, fan.times[step], fan.times[1]
    found = field.polished(x)
    late = found.time < tau - GAIN*h
    # Where Newton's method fails (next to a fold of a family) interpolated times have to do.
    missing = np.flatnonzero(~np.isfinite(found.time))
    late[missing] = field.interpolated(x[:, missing])[0] < tau[missing] - INTERPOLATED*h
    return found, late


def _meet(fan, which, count, other, tau, s2, first2, count2):
    """Newton's method for x(s, tau) = y(s2, tau): two extremals that start at one point and take equal time."""
    s2, tau, good = s2.copy(), tau.copy(), np.zeros(which.size, bool)
    low, high = other.ends.low, other.ends.high
    ds = 1e-6*(high - low)
    first = fan.sign[0, which]
    busy = np.arange(which.size)
    for _ in range(12):
        z, sign, begin = fan.arcs(fan.s[which[busy]], tau[busy], first[busy], count[busy])
        up, down = np.minimum(s2[busy] + ds, high), np.maximum(s2[busy] - ds, low)
        y, sign2, begin2 = other.arcs(np.concatenate([s2[busy], up, down]), np.tile(tau[busy], 3),
                                      np.tile(first2[busy], 3),
                                      np.tile(count2[busy], 3))
        n = busy.size
        miss = z[:2] - y[:2, :n]
        size = np.hypot(*miss)
        good[busy] = (size < 1e-8) & (tau[busy] > begin - 1e-9) & (tau[busy] > begin2[:n] - 1e-9)
        slope = (y[:2, n:2*n] - y[:2, 2*n:])/(up - down)
        rate = fan.plant.velocity(z[:2], sign) - other.plant.velocity(y[:2, :n], sign2[:n])   # d(miss)/dtau = -rate
        det = slope[0]*rate[1] - slope[1]*rate[0]
        with np.errstate(all="ignore"):
            ds2 = (miss[0]*rate[1] - miss[1]*rate[0])/det
            dtau = (slope[0]*miss[1] - slope[1]*miss[0])/det
        go = size > 1e-11
        busy = busy[go]
        if not busy.size:
            break
        s2[busy] = np.clip(s2[busy] + np.nan_to_num(ds2[go]).clip(-0.05*(high - low), 0.05*(high - low)), low, high)
        tau[busy] = np.clip(tau[busy] + np.nan_to_num(dtau[go]).clip(-4*fan.times[1], 4*fan.times[1]), 0, fan.times[-1])
    return tau, s2, good


def switching_curves(fans, window):
    """The curves on which the control of optimal extremals jumps."""
    (left, right), (bottom, top) = window
    size = np.array([right - left, top - bottom])
    curves = []
    for fan in fans:
        index, tau = fan.switchings[0].astype(int), fan.switchings[1]
        order = np.lexsort((tau, index))
        index, tau, x = index[order], tau[order], fan.switchings[2:, order]
        number = np.arange(index.size) - np.searchsorted(index, index)
        optimal = tau <= fan.cut[index] + 1e-9
        for n in range(number.max(initial=-1) + 1):
            mine = np.flatnonzero((number == n) & optimal)
            for run in _together(index[mine]):
                rows = mine[np.isin(index[mine], run)]
                points = x[:, rows].T
                torn = np.abs(np.diff(points, axis=0)/size).max(axis=1, initial=0) > APART
                torn |= np.abs(np.diff(tau[rows])) > STEPS_APART*fan.times[1]
                jumps = np.flatnonzero(torn) + 1
                for piece in np.split(np.arange(rows.size), jumps):
                    inside = ((points[piece] >= [left, bottom]) & (points[piece] <= [right, top])).all(axis=1)
                    for part in _together(np.flatnonzero(inside)):
                        if part.size > 2:
                            # One point more on both sides, so that the curve runs to the edge of the window.
                            take = piece[max(part[0] - 1, 0):part[-1] + 2]
                            if (np.ptp(points[take], axis=0) < SHORTEST*size).all():
                                continue
                            curves.append(Curve(points[take], tau[rows[take]], kind=_kind(fan, points[take])))
    return curves


def crossing_angles(plant, points):
    """Angles (radians, signed) from the curve to the velocities for u_- and u_+, at the middles of its pieces; shape
    (2, N - 1)."""
    tangent = np.diff(points, axis=0).T
    middle = (points[1:] + points[:-1]).T/2
    angles = []
    for sign in (-1, 1):
        v = plant.velocity(middle, np.full(middle.shape[1], sign))
        angles.append(np.arcsin(np.clip((tangent[0]*v[1] - tangent[1]*v[0])/(np.hypot(*tangent)*np.hypot(*v) + 1e-300),
                                        -1, 1)))
    return np.array(angles)


def _kind(fan, points):
    """Whether the curve is followed (it is a trajectory of one of the two controls) or crossed."""
    step = np.hypot(*np.diff(points, axis=0).T)
    angles = np.abs(crossing_angles(fan.plant, points))[:, step > 1e-9]
    if not angles.size:
        return ""
    along = angles.min(axis=0) < 0.02
    return "followed" if along.mean() > 0.95 else "crossed" if along.mean() < 0.2 else "mixed"


def border_extremals(fans, field, touching):
    """Extremals that touch the target (fans of one, `touching`) or end a family, with the jump of the least time across
    them."""
    found = [("abnormal", alone, 0) for alone in touching if alone.life[0] > 1]
    for fan in fans:
        ends = np.array([fan.ends.low, fan.ends.high])
        closed = np.abs(np.diff(np.vstack([fan.ends.point(ends), fan.ends.costate(ends)]))).max() < 1e-9
        if not closed:
            found += [("end of a family", fan, j) for j in (0, fan.s.size - 1) if fan.life[j] > 1]
    traces, known = [], []
    for kind, fan, j in found:
        steps = np.arange(fan.life[j] + 1)
        stretch = _together(np.flatnonzero(_in_window(fan.path[steps, :, j].T, field)))
        if not stretch or stretch[0][0] > 1:
            continue
        k = np.unique(np.append(stretch[0][::max(stretch[0].size//20, 1)], stretch[0][-1]))
        x = fan.path[k, :, j].T
        if not any(x.shape == y.shape and np.abs(x - y).max() < 1e-9 for y in known):
            known.append(x)
            traces.append((kind, fan, j, k, x))
    if not traces:
        return []
    asked = []
    for _, fan, j, k, x in traces:
        v = fan.plant.velocity(x, fan.sign[k, j])
        normal = np.array([-v[1], v[0]])/(np.hypot(*v) + 1e-300)
        asked.append(np.hstack([x + far*SQUARES*np.max(field.square)*normal for far in (0, 1e-4, -1e-4, 1e-7, -1e-7)]))
    times = np.split(field.exact(np.hstack(asked))[0], np.cumsum([a.shape[1] for a in asked])[:-1])
    return [_border(trace, *np.split(time, 5)) for trace, time in zip(traces, times)]


def _border(trace, here, *sides):
    """The curve of a border from the least times on it, and on both sides of it at two distances."""
    kind, fan, j, k, x = trace
    h, tau = fan.times[1], fan.times[k]
    # At a fold of high order the time is as uncertain as a root of the accuracy of the point.
    optimal = (here > tau - 0.25*h) | ~np.isfinite(here)
    last = int(np.argmax(~optimal)) if not optimal.all() else k.size
    controls = tuple(fan.plant.control(fan.sign[k, j]))
    if last < 6:
        return Curve(x.T, tau, 0.0, kind, optimal=False, arrives=False, controls=controls)
    # Next to the target one side may lie behind it; the jump is read off further away, where one point alone is no
    # jump.
    inner = slice(2, last)
    far_left, far_right, left, right = (np.where(np.isfinite(side), side, np.nan)[inner] for side in sides)
    far, near = np.abs(far_left - far_right), np.abs(left - right)
    # Where the time only rises steeply, like a root of the distance, the difference is smaller at the smaller distance.
    jump = np.where((near > 0.5*far) & (near > SMALLEST_JUMP*h), near, 0)
    jump = np.fmin(np.fmin(jump[:-2], jump[1:-1]), jump[2:])
    jump = float(np.max(jump, initial=0))
    # Beyond the horizon nothing is known: a missing side counts only where the other one is well within it.
    alone = np.isnan(left) != np.isnan(right)
    if (alone & (tau[inner] < 0.9*fan.times[-1])).mean() > 0.25:
        jump = np.inf
    points, times = x.T[:last], tau[:last]
    if last == k.size and k[-1] < fan.life[j]:   # one more point, so that the curve runs to the edge of the window
        points = np.vstack([points, fan.path[k[-1] + 1, :, j]])
        times, controls = np.append(times, fan.times[k[-1] + 1]), (*controls, controls[-1])
    return Curve(points, times, jump, kind, optimal=last == k.size, controls=controls[:len(times)])


def _in_window(x, field):
    size = SQUARES*field.square
    low, high = field.corner - 1e-9*size, field.corner + (1 + 1e-9)*size
    return ((x >= low[:, None]) & (x <= high[:, None])).all(axis=0)


def _together(index):
    """Stretches of consecutive integers."""
    return np.split(index, np.flatnonzero(np.diff(index) > 1) + 1) if index.size else []
