"""Families of end points of a target, and the optimal motions that end there."""

import numpy as np
import sympy as sp

from workbook.checks.references.optima import reach
from workbook.checks.references.optima.linear_plant import Plant
from workbook.checks.tools.domains import sample_cases
from workbook.checks.tools.line_search import bisect

#: Switchings earlier than this before the end are not asked for.
LONGEST = 12.0


class TargetFamily:
    """A family of points of the target, numbered by a variable, and the optimal motions to them."""

    def __init__(self, field, state, control, bounds, target, ends, variable, domain, start):
        self.plant, self.variable = Plant(field, state, control, bounds), variable
        self.parameters, self._domain = [p for p in domain if p != variable], domain
        self._interval = domain.get(variable, sp.Interval.open(-sp.oo, sp.oo))
        self._cases = sample_cases({p: domain[p] for p in self.parameters})
        target = target[0] if isinstance(target, (list, tuple)) else target
        symbols = [variable, *self.parameters]
        end_point = dict(zip(state, ends))
        gradient = [sp.diff(target, v).subs(end_point, simultaneous=True) for v in state]
        self._point = sp.lambdify(symbols, list(ends), "numpy")
        self._gradient = sp.lambdify(symbols, gradient, "numpy")
        self._target = state, control, bounds, field, target, ends
        self.side = 1 if start is None else self._starts_side(state, start, end_point, gradient)

    def _starts_side(self, state, start, end_point, gradient):
        """Return 1 if the starts lie where the target's expression is positive, else -1."""
        probe = dict(zip(self.parameters, self._cases[0]))
        argument = {self.variable: self.arguments(count=3)[1]}
        point = {s: sp.sympify(e).subs(argument).subs(probe) for s, e in end_point.items()}
        slope = [sp.sympify(g).subs(argument).subs(probe) for g in gradient]
        probe_point = {s: float(point[s]) + 1e-3 * float(g) for s, g in zip(state, slope)}
        return 1 if start.subs(probe).subs(probe_point) is sp.true else -1

    def reached(self):
        """Return the conditions that optimal motions end there, and that no motion can arrive.

        Between the two lie the ends of arcs.
        """
        state, control, bounds, field, target, ends = self._target
        rate = reach.arrivals(field, state, control, bounds, self.side * target, ends)
        domain_condition = sp.And(
            *(interval.as_relational(symbol) for symbol, interval in self._domain.items())
        )
        return sp.And(domain_condition, rate < 0), sp.And(domain_condition, rate > 0)

    @property
    def angles(self):
        """The variable, if it numbers the points as an angle from 0 on."""
        interval = self._interval
        is_angle = interval.inf >= 0 and interval.sup <= 2 * sp.pi
        return (self.variable,) if is_angle else ()

    @property
    def interval(self):
        """The interval of the variable, cut at 6 if infinite."""
        return tuple(
            float(end) if end.is_finite else np.sign(float(end)) * 6
            for end in (self._interval.inf, self._interval.sup)
        )

    def samples(self):
        """Return the cases of the parameters."""
        return self._cases

    def arguments(self, count=181):
        """Return values of the variable, off the middle, which may be a special point."""
        low, high = self.interval
        return low + (high - low) * (np.arange(count) + 0.47) / count

    def point(self, arguments, values):
        """Return the points of the target at these values of the variable."""
        return self._columns(self._point, arguments, values)

    def _columns(self, function, arguments, values):
        with np.errstate(all="ignore"):
            parts = function(arguments, *values)
        return np.column_stack(
            [np.broadcast_to(np.asarray(part, dtype=float), arguments.shape) for part in parts]
        )

    def _normals(self, arguments, values):
        """Return the normals of the target on the side of the starts."""
        return self.side * self._columns(self._gradient, arguments, values)

    def rates(self, arguments, values):
        """Return the least rate along the normal; if positive, no motion can arrive."""
        y, n = self.point(arguments, values), self._normals(arguments, values)
        push = n @ self.plant.b
        return (
            (n * (y @ self.plant.A.T)).sum(axis=1)
            + self.plant.mean * push
            - self.plant.half * abs(push)
        )

    def arrives(self, argument):
        """Return whether optimal motions end at these values; None for the end of an arc."""
        (rate,) = self.rates(*self._numbers(argument))
        return None if rate == 0 else bool(rate < 0)

    def point_text(self, argument):
        """Return the point at these values of the symbols for a message."""
        ((first, second),) = self.point(*self._numbers(argument)).round(12) + 0.0
        return f"({first:.4g}, {second:.4g})"

    def _numbers(self, argument):
        return np.array([float(argument[self.variable])]), [
            float(argument[p]) for p in self.parameters
        ]

    def change(self, first, second, values):
        """Return where between two values of the variable the sign of the rate changes."""
        ends = np.array([first]), np.array([second])
        sign = np.sign(self.rates(ends[0], values))
        ends = bisect(lambda points, _: np.sign(self.rates(points, values)) == sign, *ends, 50)
        return sum(ends)[0] / 2

    def switchings(self, arguments, values):
        """Return (points, times before the end, controls after) of the last switchings of extremals."""
        y, n = self.point(arguments, values), self._normals(arguments, values)
        time, sign = self.plant.first_zero(n, LONGEST)
        after = np.where(sign > 0, *self.plant.bounds)
        back = self.plant.exponential(-time)
        points = np.einsum("nij,nj->ni", back, y - after[:, None] * self.plant.response(time)[1])
        usable = (time < LONGEST) & (self.rates(arguments, values) < -1e-9)
        return points, np.where(usable, time, np.inf), after

    def before(self, arguments, values, time):
        """Return (states, controls) on the extremals a short time before their ends."""
        y, n = self.point(arguments, values), self._normals(arguments, values)
        q = (self.plant.response(np.full(len(arguments), time / 2))[0] * n).sum(axis=1)
        u = np.where(q > 0, *self.plant.bounds)
        span = np.full(len(arguments), time)
        return self.plant.free(y - u[:, None] * self.plant.response(span)[1], -span), u

    def table(self, values):
        """Return the switching curve as two arrays, the first of them increasing."""
        low, high = self.interval
        ends = np.geomspace(1e-12, 0.2, 2500)
        share = np.unique(np.concatenate([ends, np.linspace(0.2, 0.8, 2500), 1 - ends]))
        points, times, _ = self.switchings(low + (high - low) * share, values)
        points = points[np.isfinite(times)]
        return tuple(points[np.argsort(points[:, 0])].T)

    def values_text(self, values, argument):
        """Return the values of the parameters and of the variable for a message."""
        numbers = zip((*self.parameters, self.variable), (*values, argument))
        return "for " + ", ".join(f"{s} = {number:.4g}" for s, number in numbers)
