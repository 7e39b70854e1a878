"""Lines that separate the reachable set of a plane plant from a convex target."""

import numpy as np

from workbook.checks.references.optima.state_batch import directions, rows_of
from workbook.checks.tools.line_search import golden_section

#: Directions up to this angle from a good one are searched for a better: nearly the half of all
#: that can separate.
WIDE = 1.5705


class SeparatingLines:
    """The separating lines of a plant and a convex target, for batches of initial states."""

    def __init__(self, plant, convex):
        self.plant, self.convex = plant, convex
        self._angles, self._spacing = convex.angles()

    def _supports(self, p, x, case):
        """Return sup p.y over D for every direction, shape (directions, starts)."""
        rows = np.repeat(p, len(x), axis=0), np.tile(case, len(p)), np.tile(x, (len(p), 1))
        return self.convex.support(*rows).reshape(len(p), len(x))

    def _middle(self, gap):
        """Return the middle of the directions that separate: they form a convex cone."""
        p = np.maximum(gap > 0, gap == gap.max(axis=0)).T @ directions(self._angles)
        return np.arctan2(p[:, 1], p[:, 0])

    def _gap(self, theta, T, x, case, inside):
        p, free_states = directions(theta), self.plant.free(x, T)
        return (
            p[:, 0] * free_states[:, 0]
            + p[:, 1] * free_states[:, 1]
            + self.plant.extreme(p, T, np.where(inside, 1, -1))
            - self.convex.support(p, case, x)
        )

    def _best(self, theta, T, x, case, inside, width, steps, sufficient=np.inf):
        """Return the direction near theta with the largest gap, or any whose gap is large enough.

        With it comes the gap. From outside, min p.y over R(T) less sup p.y over D is concave in p: along
        the tangent of the unit circle at p(theta) it has one maximum, and its sign there decides whether
        any line separates. From inside the unit vectors themselves are compared.
        """
        if not self._spacing:
            return theta, self._gap(theta, T, x, case, inside)
        free_states = self.plant.free(x, T)
        integral, sign = self.plant.response(T)[1], np.where(inside, 1, -1)

        def gap(rotation, rows):
            p, y = directions(theta[rows] + rotation), free_states[rows]
            reached = self.plant.extreme(p, T[rows], sign[rows], integral[rows])
            return (
                p[:, 0] * y[:, 0]
                + p[:, 1] * y[:, 1]
                + reached
                - self.convex.support(p, case[rows], x[rows])
            )

        def normalised_gap(rotation, rows):
            return gap(rotation, rows) / np.where(inside[rows], 1, np.cos(rotation))

        rotation = golden_section(normalised_gap, np.zeros(len(x)), width, steps, sufficient)
        return theta + rotation, gap(rotation, slice(None))

    def _refine(self, x, case, inside, low, high, theta):
        """Return the first time from low to high without a separating line, and the last line.

        From inside: the time at which R(T) gets through the border, and the direction.
        """
        if not self._spacing:
            return self._halved(x, case, inside, low, high, theta)
        time, angle, proved = self._touching(x, case, inside, low, high, theta)
        unproved = np.flatnonzero(~proved)
        if len(unproved):
            halved = self._halved(*rows_of(unproved, x, case, inside, low, high, theta))
            time[unproved], angle[unproved] = self._newton_refined(
                *halved, *rows_of(unproved, x, case, inside)
            )
        return time, angle

    def _newton_refined(self, time, angle, x, case, inside, step=1e-6):
        """Refine the time and the line from outside D, also at a corner of R(T).

        In turn the best line at a time, and the time at which this line no longer separates are computed.
        """
        T, theta, width = time, angle, np.where(inside, 0, WIDE)
        with np.errstate(all="ignore"):
            for _ in range(3):
                theta, gap = self._best(theta, T, x, case, inside, width, 48)
                gap_after = self._gap(theta, T + step, x, case, inside)
                T = T - gap * step / (gap_after - gap)
        accepted = ~inside & (abs(T - time) < 1e-3 * (1 + time))
        return np.where(accepted, T, time), np.where(accepted, theta, angle)

    def _touching(self, x, case, inside, low, high, theta, step=1e-5):
        """Return (time, angle, proved) by Newton's iteration, alternating between time and line.

        It is proved, to the precision of the bisection, where that line separates before the time and
        none does after it.
        """
        start, T, rows = theta, (low + high) / 2, np.arange(len(x))

        def gaps(*points):
            repeated = np.tile(rows, len(points))
            angles, times = (np.concatenate(column) for column in zip(*points))
            return self._gap(angles, times, x[repeated], case[repeated], inside[repeated]).reshape(
                len(points), -1
            )

        with np.errstate(all="ignore"):
            for _ in range(6):
                gap_now, gap_after = gaps((theta, T), (theta, T + step))
                T = np.clip(T - np.nan_to_num(gap_now * step / (gap_after - gap_now)), low, high)
                # Seen along the tangent of the unit circle, as in `_best`.
                left, middle, right = gaps((theta - step, T), (theta, T), (theta + step, T))
                left, right = (
                    np.where(inside, side, side / np.cos(step)) for side in (left, right)
                )
                rotation = np.nan_to_num((right - left) / 2 * step / (2 * middle - left - right))
                theta = theta + np.clip(rotation, -0.3, 0.3)
            offset = np.where(inside, 1, -1) * (high - low) / 2**24
            separates = self._gap(theta, T + offset, x, case, inside) > 0
            proved = np.flatnonzero(separates & (~inside | (abs(theta - start) < 0.15)))
            x, case, inside, after = (part[proved] for part in (x, case, inside, T - offset))
            none = (
                self._best(theta[proved], after, x, case, inside, np.where(inside, 0.15, WIDE), 24)[
                    1
                ]
                <= 0
            )
        return T, theta, np.isin(rows, proved[none])

    def _halved(self, x, case, inside, low, high, theta):
        """Return time and angle by bisection, whatever the shape of the distance."""
        centre = theta
        for iteration in range(18):
            middle = (low + high) / 2
            # The best line may jump from one side of a cone to the other, so at first the whole
            # cone is searched each time.
            around, width, steps = (
                (centre, WIDE, 24) if iteration < 8 else (theta, 0.04 * 0.85**iteration, 10)
            )
            width = np.where(inside, np.minimum(width, 0.15), width)
            angle, gap = self._best(around, middle, x, case, inside, width, steps)
            reached = np.where(inside, gap >= 0, gap <= 0)
            low, high = np.where(reached, low, middle), np.where(reached, middle, high)
            theta = np.where(reached & ~inside, theta, angle)
        return (low + high) / 2, theta
