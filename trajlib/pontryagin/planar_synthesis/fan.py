"""Extremals of a planar problem, integrated backwards from the target, all at once.

With reversed time tau = t_k - t

    dx/dtau = -f,   dpsi/dtau = (df/dx)^T psi - lambda_0 df_0/dx,   dV/dtau = f_0,

and the controls at the levels at which H is greatest (`plant`). Steps are taken by extrapolation of
the midpoint rule; where a level changes the step is divided.
"""

import numpy as np

from trajlib.pontryagin.planar_synthesis.plant import HELD, ROWS, steps_needed

#: For so many steps an extremal that has met the target again is followed further, for neighbours
#: that live longer: the cells between them have to reach as far as these.
BEYOND = 4
#: Rows of `Fan.switchings` before the modes and velocities: index, tau, x1, x2.
PLACE = 4


class Fan:
    """Extremals for the parameters s of a family of ends, on a grid of reversed times; `add` puts
    more between them.

    `motion`: shape (K + 1, 7, N), nan some steps after an extremal has died; `path` is its part of
    the states, `value` the cost. `mode`, `word`: of the controls, and of the structure so far, (K +
    1, N). `switchings`: rows index of the extremal, tau, x1, x2, modes before and after (in forward
    time), the velocities before and after. `life`: the last step at which it lives; `dead`: 1 if it
    then met the target again, 2 if it left the box. `cut`: when it stops to be optimal (set by
    `cut_at_overlaps`).
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
        self.mode, self.word = np.empty((count, 0), int), np.empty((count, 0), int)
        self.life, self.dead = np.empty(0, int), np.empty(0, int)
        self.switchings = np.empty((PLACE + 6, 0))

    @property
    def path(self):
        return self.motion[:, :2]

    @property
    def value(self):
        return self.motion[:, 5]

    def start(self, s):
        """The motion at the end and the mode before it."""
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
        motion, mode, word, life, dead, switchings = self._integrate(s)
        order = np.argsort(np.append(self.s, s), kind="stable")
        place = np.empty(order.size, int)
        place[order] = np.arange(order.size)
        old = self.switchings.copy()
        old[0] = place[old[0].astype(int)]
        switchings[0] = place[switchings[0].astype(int) + self.s.size]
        self.switchings = np.hstack([old, switchings])
        self.s = np.append(self.s, s)[order]
        self.motion = np.concatenate([self.motion, motion], axis=2)[:, :, order]
        self.mode = np.concatenate([self.mode, mode], axis=1)[:, order]
        self.word = np.concatenate([self.word, word], axis=1)[:, order]
        self.life = np.append(self.life, life)[order]
        self.dead = np.append(self.dead, dead)[order]

    def _integrate(self, s):
        count, plant = self.times.size, self.plant
        z, mode = self.start(s)
        motion = np.full((count, ROWS, s.size), np.nan)
        modes, words = np.full((count, s.size), -1), np.full((count, s.size), -1)
        known = mode >= 0
        motion[0], modes[0] = z, mode
        word = np.full(s.size, -1)
        word[known] = plant.words.after(-1, mode[known])
        words[0] = word
        # Where a surface and its derivative vanish the extremal is singular; where the velocity is
        # zero it never leaves.
        speed = np.zeros(s.size)
        speed[known] = np.hypot(*plant.velocity(z[:, known], mode[known]))
        active = known & (speed > 1e-12 * (1 + np.nanmax(speed, initial=0)))
        life, dead = np.where(active, count - 1, 0), np.where(active, 0, 1)
        found = []
        h = self.times[1]
        (left, right), (bottom, top) = self.box
        for k in range(1, count):
            now = np.flatnonzero(active)
            if not now.size:
                break
            z_new, mode_new, switched = plant.advance(z[:, now], mode[now], h)
            z[:, now], mode[now] = z_new, mode_new
            for which, gone, there, old, new in switched:
                word[now[which]] = plant.words.after(word[now[which]], new)
                found.append(
                    np.vstack(
                        [
                            now[which],
                            self.times[k - 1] + gone,
                            there[:2],
                            new,
                            old,
                            plant.velocity(there, new),
                            plant.velocity(there, old),
                        ]
                    )
                )
            words[k] = word
            motion[k][:, now], modes[k, now] = z_new, mode_new
            x1, x2 = z_new[:2]
            met = self.target.outside(z_new[:2], self.ends.side) <= 0
            lost = ~((x1 >= left) & (x1 <= right) & (x2 >= bottom) & (x2 <= top))
            ended = (met | lost) & (dead[now] == 0)
            life[now[ended]] = k - 1
            dead[now[ended]] = np.where(met, 1, 2)[ended]
            active[now[lost | (k - life[now] >= BEYOND)]] = False
        return motion, modes, words, life, dead, np.hstack([np.empty((PLACE + 6, 0)), *found])

    def flow(self, s, tau):
        """Motion and mode at the reversed times `tau` on the extremals `s`, one to one."""
        s, tau = np.atleast_1d(np.asarray(s, float)), np.atleast_1d(np.asarray(tau, float))
        z, mode = self.start(np.clip(s, self.ends.low, self.ends.high))
        mode = np.maximum(mode, 0)
        # the grid is finer than the accuracy of the steps asks for
        steps = steps_needed(tau, 2 * self.times[1])
        for _ in range(steps):
            z, mode, _ = self.plant.advance(z, mode, tau / steps)
        return z, mode

    def arcs(self, s, tau, word):
        """Extremals with given structures, the words `word`.

        The last arc begins at the last switching, wherever this is, and ends at `tau`, also if that
        is earlier: so the end is a smooth function of s and tau, to which Newton's method can be
        applied. Returns the motion at the end and the reversed time at which the last arc begins;
        nan where there are not so many switchings.
        """
        plant = self.plant
        z, _ = self.start(s)
        modes, switchings = plant.words.table(word), plant.words.length[word]
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
                crossed = e * plant.demand[mode, surface] < 0
                ready = waiting[crossed]
                if ready.size:
                    when, there = plant.first_zero(
                        now[:, crossed],
                        mode[crossed],
                        surface[crossed],
                        np.full(ready.size, stride),
                        end[:, crossed],
                    )
                    z[:, ready] = there
                    begin[ready] += when
                waiting = waiting[~crossed]
                z[:, waiting] = end[:, ~crossed]
                begin[waiting] += stride
                lost = ~(begin[waiting] < longest)
                begin[waiting[lost]] = np.nan
                waiting = waiting[~lost]
        return plant.follow(z, plant.words.mode[word], tau - begin, stride), begin
