"""Where extremals stop to be optimal, and the curves that this leaves: switching curves, dispersal curves, borders."""
from dataclasses import dataclass

import numpy as np

from .time_field import SQUARES

#: Jumps of the least time below so many steps of the grid are not told from a steep rise.
SMALLEST_JUMP = 2
#: Neighbouring extremals whose switchings are further apart, in shares of the window or in steps of time, belong to two curves.
APART, STEPS_APART = 0.2, 20


@dataclass(frozen=True)
class Curve:
    """A curve of the phase plane: `points`, shape (N, 2), with the least time `times` from each.

    Curves that leave the window end one point outside of it. `kind`: for switching curves "crossed" (second type), "followed"
    (first type: it is a trajectory) or "mixed"; for borders "abnormal" or "end of a family". For borders, `jump`: the greatest
    jump of the least time across it, `optimal`: whether the extremal is optimal all along, `controls`: u at the points.
    For parts of the target, `parameter`: from where to where.
    """

    points: np.ndarray
    times: np.ndarray
    jump: float = 0.0
    kind: str = ""
    optimal: bool = True
    parameter: tuple = ()
    controls: tuple = ()

    def __repr__(self):
        begin, end = (tuple(float(round(v, 6)) for v in self.points[k]) for k in (0, -1))
        return f"Curve(from {begin} to {end}{', ' + self.kind if self.kind else ''})"


def cut_at_overlaps(fan, field):
    """Find the time at which each extremal is overtaken (`fan.cut`); returns the dispersal curves."""
    h = fan.times[1]
    count = fan.s.size
    fan.cut = fan.times[fan.life]*(fan.life > 0)
    nodes = np.arange(fan.times.size)[:, None] <= fan.life[None, :]
    k, j = np.nonzero(nodes)
    time, triangle, s2 = field.interpolated(fan.path[k, :, j].T)
    late = np.full(nodes.shape, False)
    late[k, j] = time < fan.times[k] - 0.25*h
    overtaken = np.flatnonzero(late.any(axis=0) & (fan.life > 0))
    if not overtaken.size:
        return []
    first = late[:, overtaken].argmax(axis=0)
    fan.cut[overtaken] = fan.times[np.maximum(first - 1, 0)]
    _, triangle, s2 = field.interpolated(fan.path[first, :, overtaken].T)
    meeting = np.full(count, False)
    for number, other in enumerate(field.fans):
        mine = np.flatnonzero((triangle >= 0) & (field.fan[triangle] == number))
        if not mine.size:
            continue
        pick, first2, switchings2 = field.structures(triangle[mine])
        mine = mine[pick]
        which, begin = overtaken[mine], fan.times[first[mine]]
        tau, partner, ok = _meet(fan, which, fan.count[first[mine], which], other, begin, s2[mine], first2, switchings2)
        ok &= (tau > 0) & (tau < begin + 0.5*h) & (tau > begin - 12*h)
        if other is fan:
            ok &= np.abs(partner - fan.s[which]) > 1e-4*(fan.ends.high - fan.ends.low)
        fan.cut[which[ok]] = tau[ok]
        # Each point of a dispersal curve is found twice, once on each of the two extremals.
        mine = field.fans.index(fan)
        ok &= (mine < number) | ((mine == number) & (partner > fan.s[which]))
        meeting[which[ok]] = True
    curves = []
    for run in _together(np.flatnonzero(meeting)):
        z, _ = fan.flow(fan.s[run], fan.cut[run])
        for part in _together(np.flatnonzero(_in_window(z[:2], field))):
            if part.size > 2:
                curves.append(Curve(z[:2, part].T, fan.cut[run][part]))
    return curves


def _meet(fan, which, count, other, tau, s2, first2, count2):
    """Newton's method for x(s, tau) = y(s2, tau): two extremals that start at one point and take equal time."""
    s2, tau = s2.copy(), tau.copy()
    low, high = other.ends.low, other.ends.high
    ds = 1e-6*(high - low)
    first = fan.sign[0, which]
    for _ in range(12):
        z, sign, begin = fan.arcs(fan.s[which], tau, first, count)
        up, down = np.minimum(s2 + ds, high), np.maximum(s2 - ds, low)
        y, sign2, begin2 = other.arcs(np.concatenate([s2, up, down]), np.tile(tau, 3), np.tile(first2, 3), np.tile(count2, 3))
        n = s2.size
        miss = z[:2] - y[:2, :n]
        if not (np.hypot(*miss) > 1e-11).any():
            break
        slope = (y[:2, n:2*n] - y[:2, 2*n:])/(up - down)
        rate = fan.plant.velocity(z[:2], sign) - other.plant.velocity(y[:2, :n], sign2[:n])   # d(miss)/dtau = -rate
        det = slope[0]*rate[1] - slope[1]*rate[0]
        with np.errstate(all="ignore"):
            ds2 = (miss[0]*rate[1] - miss[1]*rate[0])/det
            dtau = (slope[0]*miss[1] - slope[1]*miss[0])/det
        s2 = np.clip(s2 + np.nan_to_num(ds2).clip(-0.05*(high - low), 0.05*(high - low)), low, high)
        tau = np.clip(tau + np.nan_to_num(dtau).clip(-4*fan.times[1], 4*fan.times[1]), 0, fan.times[-1])
    good = (np.hypot(*miss) < 1e-8) & (tau > begin - 1e-9) & (tau > begin2[:n] - 1e-9)
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
                            curves.append(Curve(points[take], tau[rows[take]], kind=_kind(fan, points[take])))
    return curves


def crossing_angles(plant, points):
    """Angles (radians, signed) from the curve to the velocities for u_- and u_+, at the middles of its pieces; shape (2, N - 1)."""
    tangent = np.diff(points, axis=0).T
    middle = (points[1:] + points[:-1]).T/2
    angles = []
    for sign in (-1, 1):
        v = plant.velocity(middle, np.full(middle.shape[1], sign))
        angles.append(np.arcsin(np.clip((tangent[0]*v[1] - tangent[1]*v[0])/(np.hypot(*tangent)*np.hypot(*v) + 1e-300), -1, 1)))
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
    """Extremals that touch the target (fans of one, `touching`) or end a family, with the jump of the least time across them."""
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
        return Curve(x.T, tau, 0.0, kind, optimal=False, controls=controls)
    # Next to the target one side may lie behind it; the jump is read off further away, where one point alone is no jump.
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
    high = field.corner + SQUARES*field.square
    return ((x >= field.corner[:, None]) & (x <= high[:, None])).all(axis=0)


def _together(index):
    """Stretches of consecutive integers."""
    return np.split(index, np.flatnonzero(np.diff(index) > 1) + 1) if index.size else []
