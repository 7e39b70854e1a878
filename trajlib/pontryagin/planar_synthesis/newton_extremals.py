"""Extremals through given points of the plane, by Newton's method."""

import numpy as np

ROUNDS = 20


def newton_extremals(fan, x, s, tau, sequence):
    """Solve x(s, tau) = x by Newton's method for extremals of given control sequences.

    Returns s, tau, costs, the modes at the points, the controls there (N, k), and which converged.
    On a switching curve the mode is that of the control that follows.
    """
    plant, sequences = fan.plant, fan.plant.sequences
    tau, count = tau.copy(), s.size
    s = np.clip(s, fan.ends.low, fan.ends.high)
    size = np.abs(x).max(initial=0) + 1
    ds = 1e-6 * (fan.ends.high - fan.ends.low)
    reach = 4 * np.abs(np.diff(fan.s)).max(initial=0)
    good, cost, mode = np.zeros(count, bool), np.full(count, np.inf), sequences.mode[sequence]
    last, controls = mode.copy(), np.full((count, len(plant.controls)), np.nan)
    active = np.arange(count)
    for number in range(ROUNDS):
        # One-sided where the parameter ends.
        up, down = (
            np.minimum(s[active] + ds, fan.ends.high),
            np.maximum(s[active] - ds, fan.ends.low),
        )
        z, start = fan.arcs(
            np.concatenate([s[active], up, down]),
            np.tile(tau[active], 3),
            np.tile(sequence[active], 3),
        )
        n = active.size
        current = z[:, :n]
        residual = x[:, active] - current[:2]
        error = np.hypot(*residual)
        done = error < 1e-11 * size
        # The sequence must occur: the last arc has a positive length, and the control maximises H
        # on it.
        consistent = (tau[active] >= start[:n] - 1e-9) & plant.maximises(
            current, last[active], 1e-9
        )
        settled = active[done]
        good[settled], cost[settled] = consistent[done], current[5, done]
        on_curve = (tau[settled] - start[:n][done] < 1e-8) & (
            sequences.length[sequence[settled]] > 0
        )
        mode[settled[on_curve]] = sequences.mode[sequences.parent[sequence[settled[on_curve]]]]
        controls[settled] = plant.control(current[:, done], mode[settled]).T
        # Points that are still far away after some rounds belong to another cell.
        continuing = ~done & (error < (np.inf if number < 6 else 1e-3 * size))
        if not continuing.any():
            break
        slope = (z[:2, n : 2 * n] - z[:2, 2 * n :]) / (up - down)
        rate = -plant.velocity(current, last[active])
        with np.errstate(all="ignore"):
            step_s, step_tau = _solve(
                slope[:, continuing], rate[:, continuing], residual[:, continuing]
            )
        # Next to a fold two solutions exist, one with a last arc of negative length: such a guess
        # is reflected.
        short = (start[:n] - tau[active])[continuing]
        active = active[continuing]
        back = short > 1e-12
        step_s[back], step_tau[back] = 0, 2 * short[back]
        new = s[active] + np.clip(step_s, -reach, reach)
        # The end of a family is approached by halves: there x(s, tau) may have a fold, at which
        # Newton's method stops.
        new = np.where(new <= fan.ends.low, (s[active] + fan.ends.low) / 2, new)
        s[active] = np.where(new >= fan.ends.high, (s[active] + fan.ends.high) / 2, new)
        tau[active] = np.maximum(
            tau[active] + np.clip(step_tau, -4 * fan.times[1], 4 * fan.times[1]), 0
        )
    return s, tau, cost, mode, controls, good


def _solve(a, b, c):
    """Solve a p + b q = c in the plane, for columns of (2, N); where a vanishes only q."""
    size = np.hypot(*a)
    det = a[0] * b[1] - a[1] * b[0]
    parallel = ~(np.abs(det) > 1e-10 * size * np.hypot(*b)) | (size < 1e-10)
    p = (c[0] * b[1] - c[1] * b[0]) / det
    q = (a[0] * c[1] - a[1] * c[0]) / det
    alone = (b * c).sum(axis=0) / (b**2).sum(axis=0)
    return np.where(parallel, 0, p), np.where(parallel, alone, q)
