"""The switching curves of a planar synthesis, from the switchings of optimal extremals."""

import numpy as np

from trajlib.pontryagin.planar_synthesis.curves import Curve, consecutive_runs, crossing_angles

#: Neighbouring extremals whose switchings are further apart, in shares of the window or in steps of
#: time, belong to two curves.
APART, STEPS_APART = 0.2, 20
#: Switchings within this share of the window are one point, and no curve.
SHORTEST = 1e-3


def switching_curves(fans, window):
    """Return the curves on which the controls of optimal extremals change their levels."""
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
        optimal = tau <= fan.optimal_until[index] + 1e-9
        for n, old, new in np.unique(np.stack([number, before, after]), axis=1).T:
            members = np.flatnonzero((number == n) & (before == old) & (after == new) & optimal)
            for run in consecutive_runs(index[members]):
                rows = members[np.isin(index[members], run)]
                points = x[:, rows].T
                apart = np.abs(np.diff(points, axis=0) / size).max(axis=1, initial=0) > APART
                apart |= np.abs(np.diff(tau[rows])) > STEPS_APART * fan.times[1]
                jumps = np.flatnonzero(apart) + 1
                for piece in np.split(np.arange(rows.size), jumps):
                    inside = (
                        (points[piece] >= [left, bottom]) & (points[piece] <= [right, top])
                    ).all(axis=1)
                    for part in consecutive_runs(np.flatnonzero(inside)):
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


def _kind(points, velocities):
    """Return whether the curve is "followed" (a trajectory for one of both levels) or "crossed"."""
    step = np.hypot(*np.diff(points, axis=0).T)
    angles = np.abs(crossing_angles(points, velocities))[:, step > 1e-9]
    if not angles.size:
        return ""
    along = angles.min(axis=0) < 0.02
    return "followed" if along.mean() > 0.95 else "crossed" if along.mean() < 0.2 else "mixed"
