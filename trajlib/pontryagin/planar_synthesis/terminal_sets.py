"""The target of a planar problem, and the covectors with which extremals end on it.

Transversality and H = 0 leave a family of one parameter s of end points with covectors (psi,
lambda_0), from which extremals start backwards: on a curve g = 0 the end point y runs along the
curve, and with n = -sigma grad g/|grad g|

    psi = nu n - lambda_0 grad phi_0,   max_u [nu a(u) - lambda_0 b(u)] = 0,   a = n^T f,   b = f_0 + grad phi_0^T f,

where sigma = +1, -1 is the sign of g on the side from which the target is met; at a single point n
= (cos s, sin s) turns. With lambda_0 = 1 the maximum is a convex function of nu, and the trajectory
comes from the side sigma where it rises: at the larger one of its zeros, if it has any. There the
crossing rate a(u) is positive; where the greatest of these rates, w(s), is zero, lambda_0 is zero
too: the extremal is abnormal and touches the target.
"""

from dataclasses import dataclass, replace

import numpy as np

from trajlib.pontryagin.planar_synthesis.plant import ROWS

#: Points at which w(s) is sampled to find where it changes its sign.
SAMPLES = 1441
#: w(s) below this share of its greatest value counts as zero: the extremal touches the target.
TOUCHES = 1e-9
#: Steps of Newton's method for nu, where controls lie between their bounds; from the right it
#: converges always.
ROUNDS = 12


@dataclass(frozen=True)
class EndFamily:
    """End points and covectors of a family of extremals, functions of low <= s <= high.

    Attributes
    ----------
    point, covector, cost : callable
        Of s, with values (2, N), (3, N) and (N,); the cost is that of ending there.
    side : int
        The sign of g before the end, 0 for a single point.
    special : tuple of float
        Values of s inside at which w = 0.
    held : int or None
        A mode with an open control, whose value is then s.
    """

    point: object
    covector: object
    cost: object
    low: float
    high: float
    side: int
    special: tuple = ()
    held: int | None = None


class PointTarget:
    """A single point of the plane; the parameter is the angle of the costate."""

    def __init__(self, point):
        self.at = np.asarray(point, dtype=float)
        self.low, self.high, self.closed = 0.0, 2 * np.pi, True
        self.sides = (0,)

    def point(self, s):
        return np.repeat(self.at[:, None], np.size(s), axis=1)  # the same for every angle

    def normal(self, s, side=0):
        s = np.atleast_1d(s)
        return np.array([np.cos(s), np.sin(s)])

    def outside(self, x, side):
        """Return the distance from the target, positive away from it."""
        return np.hypot(x[0] - self.at[0], x[1] - self.at[1])

    def pieces(self):
        return [(self.low, self.high, True)]


class CurveTarget:
    """The curve g = 0, traced in a box and refined by Newton's method, or parametrised."""

    def __init__(self, value, gradient, sides, box=None, parametrised=None):
        self.value, self.gradient, self.sides = value, gradient, sides
        if parametrised is None:
            self._trace(box)
        else:
            point, low, high = parametrised
            self._point = point
            ends = point(np.array([low, high]))
            self._pieces = [(low, high, bool(np.abs(ends[:, 0] - ends[:, 1]).max() < 1e-9))]
            self._check(point(np.linspace(low, high, 50)))
        self.low, self.high = self._pieces[0][0], self._pieces[-1][1]

    def point(self, s):
        s = np.array(s, dtype=float, ndmin=1)
        for low, high, closed in self._pieces:
            # A family may run across the seam of a closed curve: its parameter then begins below
            # the piece.
            if closed:
                across = (s < low) & (s >= 2 * low - high)
                s[across] += high - low
        return self._point(s)

    def normal(self, s, side):
        gradient = self.gradient(*self.point(s))
        return -side * gradient / np.hypot(*gradient)

    def outside(self, x, side):
        return side * self.value(*x)

    def pieces(self):
        return self._pieces

    def _check(self, points):
        """Raise ValueError where the gradient vanishes or the points do not lie on the curve."""
        size = np.hypot(*self.gradient(*points))
        if not np.isfinite(size).all() or (size < 1e-12).any():
            raise ValueError(
                "terminal: the gradient of its equation vanishes on the target, which is no "
                "smooth curve there"
            )
        if np.abs(self.value(*points) / size).max() > 1e-6:
            raise ValueError("curve: the parametrisation does not satisfy the terminal equation")

    def _trace(self, box):
        """Trace the curve in the box and parametrise it by its length."""
        from contourpy import contour_generator
        from scipy.interpolate import CubicSpline

        (left, right), (bottom, top) = box
        x, y = np.linspace(left, right, 601), np.linspace(bottom, top, 601)
        X, Y = np.meshgrid(x, y)
        lines = [
            line.T for line in contour_generator(x, y, self.value(X, Y)).lines(0) if len(line) > 3
        ]
        if not lines:
            raise ValueError(
                "terminal: the equation has no solutions in the window (and twice its size around "
                "it); enlarge the window"
            )
        self._splines, self._pieces, start = [], [], 0.0
        for line in lines:
            line = self._onto_curve(line)
            self._check(line)
            closed = np.hypot(*(line[:, 0] - line[:, -1])) < 1e-9 * (right - left)
            # Two corners of the grid can fall onto one point of the curve.
            keep = np.append(np.hypot(*np.diff(line)) > 1e-6 * (right - left), True)
            line = line[:, keep]
            if closed:
                line[:, -1] = line[:, 0]
            s = start + np.append(0, np.cumsum(np.hypot(*np.diff(line))))
            self._splines.append(
                CubicSpline(s, line, axis=1, bc_type="periodic" if closed else "not-a-knot")
            )
            self._pieces.append((s[0], s[-1], bool(closed)))
            # room for a parameter that begins below the next piece
            start = 2 * s[-1] - s[0] + 1.0

    def _point(self, s):
        starts = np.array([2 * low - high for low, high, _ in self._pieces])
        piece = np.clip(np.searchsorted(starts, s, side="right") - 1, 0, None)
        points = np.empty((2, s.size))
        for k, spline in enumerate(self._splines):
            points[:, piece == k] = spline(np.clip(s[piece == k], *self._pieces[k][:2]))
        return self._onto_curve(points)

    def _onto_curve(self, points):
        """Move points onto the curve by Newton's method."""
        for _ in range(4):
            gradient = self.gradient(*points)
            points = points - self.value(*points) * gradient / np.maximum(
                (gradient**2).sum(axis=0), 1e-300
            )
        return points


class Transversality:
    """The covectors with which extremals can end, for one target, plant, terminal cost and side."""

    def __init__(self, target, plant, final, side):
        self.target, self.plant, self.final, self.side = target, plant, final, side

    def point(self, s):
        return self.target.point(s)

    def cost(self, s):
        return self.final.value(*self.target.point(s))[0]

    def crossing_rate(self, s, sign=1):
        """Return w(s), the greatest crossing rate for the normal or its opposite."""
        x, n = self.target.point(s), sign * self.target.normal(s, self.side)
        return np.max(
            [
                (n * self.plant.at(x, self._columns(u, x))[0]).sum(axis=0)
                for u in self.plant.corners()
            ],
            axis=0,
        )

    def admissible(self, s):
        """Return w(s) where some covector satisfies H = 0 at the end, a negative number elsewhere."""
        w, (_, exists) = self.crossing_rate(s), self._solved(s)
        return np.where((w <= 0) | exists, w, -np.abs(w) - 1e-300)

    def covector(self, s):
        return self._solved(np.atleast_1d(s))[0]

    def abnormal(self, s, sign):
        """Return the covector of an extremal that touches the target."""
        n = sign * self.target.normal(np.atleast_1d(s), self.side)
        return np.vstack([n, np.zeros(n.shape[1])])

    def _solved(self, s):
        """Return (psi, lambda_0), (3, N), of length about one, and whether H = 0 has a solution."""
        x, n = self.target.point(s), self.target.normal(s, self.side)
        gradient = self.final.gradient(*x)
        best, a, b, rates = np.full(s.shape, np.inf), np.zeros(s.shape), np.ones(s.shape), []
        for u in self.plant.corners():
            rate, cost_rate = self._rates(x, n, gradient, self._columns(u, x))
            if not rates:
                b = np.where(cost_rate < 0, -b, b)
            rates.append((rate, cost_rate))
            with np.errstate(all="ignore"):
                ratio = np.where(rate > 0, cost_rate / rate, np.inf)
            smaller = ratio < best
            best, a, b = (
                np.where(smaller, ratio, best),
                np.where(smaller, rate, a),
                np.where(smaller, cost_rate, b),
            )
        if self.plant.has_interior:
            a, b = self._between(x, n, gradient, a, b)
            rates.append((a, b))
        size = np.hypot(a, b) + 1e-300
        exists = np.isfinite(best) & (a > 0)
        for rate, cost_rate in rates:
            exists &= b * rate - a * cost_rate <= 1e-9 * size * (np.hypot(rate, cost_rate) + 1e-300)
        return np.vstack([b * n - a * gradient, a]) / size, exists

    def _between(self, x, n, gradient, a, b):
        """Solve for the larger zero nu of the maximum by Newton's method from that of a corner."""
        z = np.zeros((ROWS, a.size))
        z[:2] = x
        for _ in range(ROUNDS):
            z[2:4], z[4] = b * n - a * gradient, a
            normal = a > 1e-9 * np.abs(b)
            with np.errstate(all="ignore"):
                mode = np.maximum(self.plant.first_mode(z), 0)
                u = self.plant.control(z, mode)
            rate, cost_rate = self._rates(x, n, gradient, np.where(normal, u, 0))
            # With nu = b/a the next value is that of the control which maximises H now.
            update = normal & (rate > 0)
            a, b = np.where(update, rate, a), np.where(update, cost_rate, b)
        return a, b

    def _rates(self, x, n, gradient, u):
        f, cost_rate = self.plant.at(x, u)
        return (n * f).sum(axis=0), cost_rate + (gradient * f).sum(axis=0)

    def _columns(self, u, x):
        return np.repeat(np.asarray(u, dtype=float)[:, None], x.shape[1], axis=1)


def end_families(transversality):
    """Return the families of ends, and the ends (s, sign) of abnormal extremals.

    Abnormal extremals touch the target. The sign is -1 where the covector points the other way: all
    velocities but one lead back to the side from which the extremal comes.
    """
    families, touching = [], []
    for low, high, closed in transversality.target.pieces():
        s = np.linspace(low, high, SAMPLES)
        for sign in (1, -1) if transversality.side else (1,):

            def greatest(values, sign=sign):
                return (
                    transversality.admissible(values)
                    if sign == 1
                    else transversality.crossing_rate(values, -1)
                )

            w = greatest(s)
            scale = max(np.abs(w).max(), 1e-300)
            zeros = _zeros(lambda v: greatest(np.atleast_1d(v))[0], s, w, scale)
            touching += [
                (z, sign)
                for z in zeros
                if np.abs(transversality.crossing_rate(np.array([z]), sign))[0] <= 1e-6 * scale
            ]
            if sign == 1:
                families += _joined(
                    _intervals(s, w, zeros, scale, transversality), low, high, closed
                )
    return families, touching


def _last_admissible(function, low, high):
    """Return the zero of w between low and high, rounded to the side where w is not negative.

    On the other side there is no extremal.
    """
    from scipy.optimize import brentq

    zero, inner = brentq(function, low, high, xtol=1e-13), high if function(high) > 0 else low
    step = 1e-15 * (high - low)
    while function(zero) < 0:
        zero += np.sign(inner - zero) * step
        step *= 2
    return zero


def _zeros(function, s, w, scale):
    """Return where w changes its sign, and where it touches zero from above."""
    from scipy.optimize import minimize_scalar

    zeros = [_last_admissible(function, s[k], s[k + 1]) for k in np.flatnonzero(w[:-1] * w[1:] < 0)]
    zeros += list(s[np.abs(w) <= TOUCHES * scale])
    step = s[1] - s[0]
    lowest = (
        np.flatnonzero(
            (w[1:-1] <= w[:-2])
            & (w[1:-1] <= w[2:])
            & (w[1:-1] > TOUCHES * scale)
            & (w[1:-1] < 0.01 * scale)
        )
        + 1
    )
    for k in lowest:
        best = minimize_scalar(
            function, bounds=(s[k] - step, s[k] + step), method="bounded", options={"xatol": 1e-12}
        )
        if best.fun < 1e-7 * scale:
            zeros.append(best.x)
    zeros = np.array(sorted(zeros))
    if zeros.size > SAMPLES // 4:
        return []  # w vanishes on whole arcs: nothing moves there
    return [
        float(z) for k, z in enumerate(zeros) if k == 0 or z - zeros[k - 1] > 1e-7 * (s[-1] - s[0])
    ]


def _joined(ends, low, high, closed):
    """Join the first and the last interval of a closed curve if they meet at the seam."""
    if not (closed and len(ends) > 1 and ends[0].low == low and ends[-1].high == high):
        return ends
    first, last = ends[0], ends[-1]
    shift = high - low
    special = tuple(z - shift for z in last.special) + first.special
    return [*ends[1:-1], replace(first, low=float(last.low - shift), special=special)]


def _intervals(s, w, zeros, scale, transversality):
    """Return the families on intervals of s with w > 0, joined where w only touches zero."""
    positive = w > TOUCHES * scale
    for z in zeros:  # a touched zero does not end an interval
        k = int(np.clip(np.searchsorted(s, z), 1, s.size - 1))
        near = slice(max(k - 2, 0), k + 2)
        before, after = w[max(k - 3, 0)], w[min(k + 2, s.size - 1)]
        if before > TOUCHES * scale and after > TOUCHES * scale:
            positive[near] = True
    edges = np.flatnonzero(np.diff(positive.astype(int)))
    starts = ([0] if positive[0] else []) + [e + 1 for e in edges if not positive[e]]
    ends = [e for e in edges if positive[e]] + ([s.size - 1] if positive[-1] else [])
    result = []
    for first, last in zip(starts, ends):
        low, high = s[first], s[last]
        below = [z for z in zeros if s[max(first - 1, 0)] - 1e-12 <= z <= low]
        above = [z for z in zeros if high <= z <= s[min(last + 1, s.size - 1)] + 1e-12]
        low, high = (min(below) if below else low), (max(above) if above else high)
        if high > low:
            inside = tuple(z for z in zeros if low < z < high)
            result.append(
                EndFamily(
                    transversality.point,
                    transversality.covector,
                    transversality.cost,
                    float(low),
                    float(high),
                    transversality.side,
                    inside,
                )
            )
    return result
