"""The fastest transfers of a plane linear system to the origin, a case of `fastest_times`."""

import functools
import math

import numpy as np

from workbook.checks.contract.direction import directed
from workbook.checks.references.optima.convex_targets import ConvexTarget
from workbook.checks.references.optima.fastest_times import FastestTimes
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.references.optima.state_batch import directions
from workbook.checks.references.optima.transfer_systems import TransferSystem


class LinearTransfer(TransferSystem):
    """x' = Ax + bu in the plane, the origin as the target.

    Time runs back here: the states that can be brought to the origin within T are those that
    x' = -Ax - bu reaches from there, and they only grow with T. The least times are those of
    `fastest_times`, to ten digits.
    """

    DIRECTIONS = 720

    def __init__(self, state, control, field, bounds, terminal):
        super().__init__(state, control, field, bounds, terminal)
        if not self.bounds[0] <= 0 <= self.bounds[1]:
            raise RuntimeError("the origin has to be an equilibrium for an admissible control")
        self._back = Plant([-f for f in field], state, control, bounds)
        # Sums of powers of time grow slowly, exponentials fast.
        self._longest = 4096.0 if not (self._back.A @ self._back.A).any() else 128.0
        self._found, self._plans = {}, {}

    def duration(self, start, slowest, meetings):
        if slowest or meetings != 1:
            raise RuntimeError("with the origin as the target only the fastest transfer is known")
        return self._optimum(start)[0]

    def _optimum(self, start):
        """Return (least time, angle of p), where p.x is least for the start among all states.

        All states means those that can be brought to the origin in this time.
        """
        self.foresee([start])
        return self._found[tuple(start)]

    def foresee(self, starts):
        starts = [start for start in dict.fromkeys(map(tuple, starts)) if start not in self._found]
        if not starts:
            return
        x, case = np.array(starts), np.arange(len(starts))
        batch = FastestTimes(self._back, ConvexTarget.points(x)).solve(
            np.zeros_like(x), case, far=True
        )
        self._found.update(zip(starts, zip(batch.time.tolist(), batch.angle.tolist())))

    def holds(self, start):
        """Return whether some time suffices, up to the precision of the grid of directions."""
        normals, support = self._limits
        return bool(np.all(normals @ start <= support + 1e-9 * np.abs(start).sum()))

    @functools.cached_property
    def _limits(self):
        """Directions q, and S_T(q) for a time T as long as any that is considered."""
        normals = directions((np.arange(self.DIRECTIONS) + 0.5) * 2 * math.pi / self.DIRECTIONS)
        return normals, self._support(normals, self._longest)

    def _support(self, normals, time):
        return self._back.extreme(normals, np.full(len(normals), time), 1)

    def radii(self, duration, units):
        """Return distances from zero, in all directions, of the states with this least time.

        The distances are those of the statement, in which the states here have these `units`.
        """
        normals = directions(np.linspace(0, 2 * math.pi, 90, endpoint=False))
        support = self._support(normals * units, duration)
        # The set {q.x <= S(q) for all q} is met along a direction d at the least S(q)/q.d.
        cosines = normals @ normals.T
        met = cosines > 1e-9
        return np.where(met, support[:, None] / np.where(met, cosines, 1), np.inf).min(axis=0)

    def breaks(self, start, duration):
        return self._plan(start, duration)[0]

    def _plan(self, start, duration):
        """Return the switching times of the fastest control and its first value.

        Time running back, it makes p.y least at the end.
        """
        key = tuple(start)
        if key not in self._plans:
            p = directions(np.array([self._optimum(start)[1]]))
            # A zero next to an end belongs to a start on the switching curve, or to the target: no
            # switching.
            inner = [
                t
                for t in self._back.zeros(p, np.array([duration]))[0]
                if 1e-4 * duration < t < (1 - 1e-4) * duration
            ]
            switching_value = float(p[0] @ self._back.response(duration * 2e-4)[0])
            self._plans[key] = inner, self.bounds[1] if switching_value < 0 else self.bounds[0]
        return self._plans[key]

    def switchings(self, start, duration):
        return len(self.breaks(start, duration))

    def law(self, y, t, start, duration, slowest):
        breaks, first = self._plan(start, duration)
        return first if sum(b < t for b in breaks) % 2 == 0 else sum(self.bounds) - first

    def time_message(self, start, claimed, true):
        return directed(
            "no admissible control needs so little time"
            if claimed < true
            else "an admissible control arrives earlier",
            "that is not the least time of an admissible control",
        )
