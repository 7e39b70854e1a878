"""The borders of a planar synthesis: extremals that touch the target or end a family."""

import numpy as np

from trajlib.pontryagin.planar_synthesis.curves import Curve, consecutive_runs, in_window
from trajlib.pontryagin.planar_synthesis.value_function import GRID

#: Jumps of the least cost below so many steps of the grid cannot be distinguished from a steep
#: rise.
SMALLEST_JUMP = 2


def border_extremals(fans, value_function, touching):
    """Return these extremals as curves with the jump of the least cost across them.

    `touching`: fans of one extremal, those that touch the target.
    """
    candidates = [("abnormal", alone, 0) for alone in touching if alone.last_step[0] > 1]
    for fan in fans:
        ends = np.array([fan.ends.low, fan.ends.high])
        closed = (
            np.abs(np.diff(np.vstack([fan.ends.point(ends), fan.ends.covector(ends)]))).max() < 1e-9
        )
        if not closed:
            candidates += [
                ("end of a family", fan, j) for j in (0, fan.s.size - 1) if fan.last_step[j] > 1
            ]
    traces, distinct_paths = [], []
    for kind, fan, j in candidates:
        steps = np.arange(fan.last_step[j] + 1)
        stretch = consecutive_runs(
            np.flatnonzero(in_window(fan.path[steps, :, j].T, value_function))
        )
        if not stretch or stretch[0][0] > 1:
            continue
        k = np.unique(np.append(stretch[0][:: max(stretch[0].size // 20, 1)], stretch[0][-1]))
        x = fan.path[k, :, j].T
        if not any(x.shape == y.shape and np.abs(x - y).max() < 1e-9 for y in distinct_paths):
            distinct_paths.append(x)
            traces.append((kind, fan, j, k, x))
    if not traces:
        return []
    points = []
    for _, fan, j, k, x in traces:
        v = fan.plant.velocity(fan.motion[k, :, j].T, fan.mode[k, j])
        normal = np.array([-v[1], v[0]]) / (np.hypot(*v) + 1e-300)
        points.append(
            np.hstack(
                [
                    x + far * GRID * np.max(value_function.square) * normal
                    for far in (0, 1e-4, -1e-4, 1e-7, -1e-7)
                ]
            )
        )
    costs = np.split(
        value_function.exact(np.hstack(points)).cost, np.cumsum([a.shape[1] for a in points])[:-1]
    )
    return [
        _border(value_function, trace, *np.split(cost, 5)) for trace, cost in zip(traces, costs)
    ]


def _border(value_function, trace, on_border, *sides):
    """Return the curve of a border from the costs on it and on both sides at two distances."""
    kind, fan, j, k, x = trace
    step_cost, tau = value_function.step_cost, fan.times[k]
    # At a fold of high order the cost is as uncertain as a root of the accuracy of the point.
    optimal = (on_border > fan.value[k, j] - 0.25 * step_cost) | ~np.isfinite(on_border)
    last = int(np.argmax(~optimal)) if not optimal.all() else k.size
    controls = tuple(_one_or_all(fan.plant.control(fan.motion[k, :, j].T, fan.mode[k, j])))
    if last < 6:
        return Curve(x.T, tau, 0.0, kind, optimal=False, arrives=False, controls=controls)
    # Next to the target one side may lie behind it; the jump is measured further away, where a
    # single point is no jump.
    inner = slice(2, last)
    far_left, far_right, left, right = (
        np.where(np.isfinite(side), side, np.nan)[inner] for side in sides
    )
    far, near = np.abs(far_left - far_right), np.abs(left - right)
    # Where the cost only rises steeply, like a root of the distance, the difference is smaller at
    # the smaller distance.
    jump = np.where((near > 0.5 * far) & (near > SMALLEST_JUMP * step_cost), near, 0)
    jump = np.fmin(np.fmin(jump[:-2], jump[1:-1]), jump[2:])
    jump = float(np.max(jump, initial=0))
    # Beyond the horizon nothing is known: a missing side counts only where the other one is well
    # within it.
    alone = np.isnan(left) != np.isnan(right)
    if (alone & (tau[inner] < 0.9 * fan.times[-1])).mean() > 0.25:
        jump = np.inf
    points, times = x.T[:last], tau[:last]
    # one more point, so that the curve runs to the edge of the window
    if last == k.size and k[-1] < fan.last_step[j]:
        points = np.vstack([points, fan.path[k[-1] + 1, :, j]])
        times, controls = np.append(times, fan.times[k[-1] + 1]), (*controls, controls[-1])
    return Curve(points, times, jump, kind, optimal=last == k.size, controls=controls[: len(times)])


def _one_or_all(u):
    """Return the values of one control, or rows of several, from an array (k, N)."""
    return u[0] if len(u) == 1 else u.T
