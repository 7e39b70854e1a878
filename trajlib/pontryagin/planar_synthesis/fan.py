"""Fans: extremals of a planar problem, integrated backwards from the target together.

With reversed time tau = t_k - t

    dx/dtau = -f,   dpsi/dtau = (df/dx)^T psi - lambda_0 df_0/dx,   dV/dtau = f_0,

and the controls at the levels that maximise H (`plant`). Steps are taken by extrapolation of the
midpoint rule; where a level changes the step is divided.
"""

import numpy as np

from trajlib.pontryagin.planar_synthesis.integration import steps_needed
from trajlib.pontryagin.planar_synthesis.plant import HELD, ROWS

#: For so many steps an extremal that has met the target again is continued, for neighbours that end
#: later: the cells between them have to reach as far as these.
BEYOND = 4
#: Rows of `Fan.switchings` before the modes and velocities: index, tau, x1, x2.
POSITION_ROWS = 4


class Fan:
    """Extremals for parameters s of a family of ends, on a grid of K + 1 reversed times.

    Attributes
    ----------
    motion : ndarray, shape (K + 1, 7, N)
        The columns z of `plant`, nan some steps after the end of an extremal; `path` are its
        states, `value` its cost.
    mode, sequence : ndarray of int, shape (K + 1, N)
        Of the controls, and of the control sequence so far.
    switchings : ndarray
        Rows: index of the extremal, tau, x1, x2, modes before and after (in forward time),
        velocities before and after.
    last_step, outcome : ndarray of int, shape (N,)
        The last step of an extremal; 1 if it then met the target again, 2 if it left the box.
    optimal_until : ndarray, shape (N,)
        Reversed time at which another extremal is better, set by `find_overtakings`.
    """

    def __init__(self, plant, target, ends, horizon, steps, box):
        self.plant, self.target, self.ends = plant, target, ends
        self.times = np.linspace(0, horizon, steps + 1)
        self.box = box
        self.s = np.empty(0)
        self._clear()

    def _clear(self):
        count = self.times.size
        self.motion = np.empty((count, ROWS, 0))
        self.mode, self.sequence = np.empty((count, 0), int), np.empty((count, 0), int)
        self.last_step, self.outcome = np.empty(0, int), np.empty(0, int)
        self.switchings = np.empty((POSITION_ROWS + 6, 0))

    @property
    def path(self):
        """The states, shape (K + 1, 2, N)."""
        return self.motion[:, :2]

    @property
    def value(self):
        """The cost to the target, shape (K + 1, N)."""
        return self.motion[:, 5]

    def start(self, s):
        """Return z at the end of the process and the mode before it."""
        s = np.atleast_1d(np.asarray(s, dtype=float))
        z = np.zeros((ROWS, s.size))
        z[:2], z[2:5], z[5] = self.ends.point(s), self.ends.covector(s), self.ends.cost(s)
        if self.ends.held is None:
            return z, self.plant.first_mode(z)
        z[HELD] = s
        return z, np.full(s.size, self.ends.held)

    def add(self, s):
        """Integrate extremals for more values of the parameter; the fan stays sorted by s."""
        s = np.asarray(s, dtype=float)
        motion, mode, sequence, last_step, outcome, switchings = self._integrate(s)
        order = np.argsort(np.append(self.s, s), kind="stable")
        new_index = np.empty(order.size, int)
        new_index[order] = np.arange(order.size)
        old = self.switchings.copy()
        old[0] = new_index[old[0].astype(int)]
        switchings[0] = new_index[switchings[0].astype(int) + self.s.size]
        self.switchings = np.hstack([old, switchings])
        self.s = np.append(self.s, s)[order]
        self.motion = np.concatenate([self.motion, motion], axis=2)[:, :, order]
        self.mode = np.concatenate([self.mode, mode], axis=1)[:, order]
        self.sequence = np.concatenate([self.sequence, sequence], axis=1)[:, order]
        self.last_step = np.append(self.last_step, last_step)[order]
        self.outcome = np.append(self.outcome, outcome)[order]

    def _integrate(self, s):
        count, plant = self.times.size, self.plant
        z, mode = self.start(s)
        motion = np.full((count, ROWS, s.size), np.nan)
        modes, sequences = np.full((count, s.size), -1), np.full((count, s.size), -1)
        has_mode = mode >= 0
        motion[0], modes[0] = z, mode
        sequence = np.full(s.size, -1)
        sequence[has_mode] = plant.sequences.after(-1, mode[has_mode])
        sequences[0] = sequence
        # Where a surface and its derivative vanish the extremal is singular; where the velocity is
        # zero it never leaves.
        speed = np.zeros(s.size)
        speed[has_mode] = np.hypot(*plant.velocity(z[:, has_mode], mode[has_mode]))
        active = has_mode & (speed > 1e-12 * (1 + np.nanmax(speed, initial=0)))
        last_step, outcome = np.where(active, count - 1, 0), np.where(active, 0, 1)
        switchings = []
        h = self.times[1]
        (left, right), (bottom, top) = self.box
        for k in range(1, count):
            active_columns = np.flatnonzero(active)
            if not active_columns.size:
                break
            z_new, mode_new, switched = plant.advance(z[:, active_columns], mode[active_columns], h)
            z[:, active_columns], mode[active_columns] = z_new, mode_new
            for crossing, gone, switching_z, old, new in switched:
                sequence[active_columns[crossing]] = plant.sequences.after(
                    sequence[active_columns[crossing]], new
                )
                switchings.append(
                    np.vstack(
                        [
                            active_columns[crossing],
                            self.times[k - 1] + gone,
                            switching_z[:2],
                            new,
                            old,
                            plant.velocity(switching_z, new),
                            plant.velocity(switching_z, old),
                        ]
                    )
                )
            sequences[k] = sequence
            motion[k][:, active_columns], modes[k, active_columns] = z_new, mode_new
            x1, x2 = z_new[:2]
            met_target = self.target.outside(z_new[:2], self.ends.side) <= 0
            left_box = ~((x1 >= left) & (x1 <= right) & (x2 >= bottom) & (x2 <= top))
            ended = (met_target | left_box) & (outcome[active_columns] == 0)
            last_step[active_columns[ended]] = k - 1
            outcome[active_columns[ended]] = np.where(met_target, 1, 2)[ended]
            active[active_columns[left_box | (k - last_step[active_columns] >= BEYOND)]] = False
        return (
            motion,
            modes,
            sequences,
            last_step,
            outcome,
            np.hstack([np.empty((POSITION_ROWS + 6, 0)), *switchings]),
        )

    def flow(self, s, tau):
        """Return z and mode at the reversed times `tau` on the extremals `s`, one to one."""
        s, tau = np.atleast_1d(np.asarray(s, float)), np.atleast_1d(np.asarray(tau, float))
        z, mode = self.start(np.clip(s, self.ends.low, self.ends.high))
        mode = np.maximum(mode, 0)
        # the grid is finer than the accuracy of the steps asks for
        steps = steps_needed(tau, 2 * self.times[1])
        for _ in range(steps):
            z, mode, _ = self.plant.advance(z, mode, tau / steps)
        return z, mode

    def arcs(self, s, tau, sequence):
        """Return z at the ends of extremals with given sequences, and where their last arcs begin.

        The last arc begins at the last switching, wherever this is, and ends at `tau`, also if that
        is earlier: so the end is a smooth function of s and tau, to which Newton's method can be
        applied. nan where there are fewer switchings.
        """
        plant = self.plant
        z, _ = self.start(s)
        modes, switchings = plant.sequences.table(sequence), plant.sequences.length[sequence]
        begin = np.zeros(s.size)
        stride = 2 * self.times[1]
        longest = self.times[-1] + 4 * stride
        for n in range(switchings.max(initial=0)):
            waiting = np.flatnonzero(switchings > n)
            while waiting.size:
                now, mode = z[:, waiting], modes[waiting, n]
                surface = plant.crossing[mode, modes[waiting, n + 1]]
                end = plant.step(now, mode, stride)
                e = plant.surfaces(end)[surface, np.arange(waiting.size)]
                crossed = e * plant.required_sign[mode, surface] < 0
                ready = waiting[crossed]
                if ready.size:
                    when, crossing_z = plant.first_zero(
                        now[:, crossed],
                        mode[crossed],
                        surface[crossed],
                        np.full(ready.size, stride),
                        end[:, crossed],
                    )
                    z[:, ready] = crossing_z
                    begin[ready] += when
                waiting = waiting[~crossed]
                z[:, waiting] = end[:, ~crossed]
                begin[waiting] += stride
                too_late = ~(begin[waiting] < longest)
                begin[waiting[too_late]] = np.nan
                waiting = waiting[~too_late]
        return plant.follow(z, plant.sequences.mode[sequence], tau - begin, stride), begin
