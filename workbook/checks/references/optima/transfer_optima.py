"""The fastest or slowest transfer of a system to its target, found without the maximum principle.

- one state: the time is the integral of dx/(greatest rate towards the target);
- a system homogeneous of first degree in two states, a line through zero as the target: the
  direction (angle) obeys an equation of its own, and the time is the integral of dtheta/(greatest
  or least rate); the process ends when the line is met for the first time after the start;
- a linear system x' = Ax + bu with two states, the origin as the target: the least time is that of
  `fastest_times`. Whether there is one at all is told by time running back: x0 can be brought to
  the origin within T exactly if, for every direction q, q.x0 <= S_T(q) := int_0^T max_u(-q.e^{-As}b
  u) ds.
"""

import functools
import itertools
import math
import operator

import numpy as np
import sympy as sp

from workbook.checks.references.optima import reach
from workbook.checks.references.optima.convex_targets import ConvexTarget
from workbook.checks.references.optima.fastest_times import FastestTimes, directions
from workbook.checks.references.optima.linear_plant import Plant

#: For how many sets of parameters an answer is tried.
SAMPLES = 10
#: What is so many times as small as the others lies next to zero.
CLOSE = sp.Rational(1, 10**6)


class Unknown(RuntimeError):
    """No optimum of a problem is known that was found in one of these ways."""


class Transfer:
    """The transfers of a `pontryagin.Problem` in least or greatest time, for all values of the
    parameters; raises `Unknown` for another problem. A state that is free at the start and stands
    among the parameters is the start itself."""

    def __init__(self, problem, parameters=()):
        self.dynamics, self.slowest, self.parameters = (
            problem.dynamics,
            problem.maximise,
            list(parameters),
        )
        self.initial = [
            x if value is None and x in self.parameters else value
            for x, value in problem.initial.items()
        ]
        self.terminal, state = list(problem.terminal), list(problem.dynamics)
        bounds = [bound for pair in problem.controls.values() for bound in pair]
        if (
            problem.running != 1
            or problem.final != 0
            or problem.duration is not None
            or len(bounds) != 2
            or any(bound.is_infinite for bound in bounds)
            or None in self.initial
        ):
            raise Unknown(
                "the independent optimum of this kind is known where the cost is the time of one "
                "control"
            )
        (self.control,), self.bounds = problem.controls, bounds
        self._decided, self._found = _kept(self._key())
        scale = sp.Dummy("scale", positive=True)
        if len(state) == 1:
            self._kind = _Line
        elif self._linear() and set(self.terminal) == set(state):
            self._kind = _Linear
        elif (
            len(state) == 2
            and len(self.terminal) == 1
            and self.terminal[0].subs(dict.fromkeys(state, 0)) == 0
            and all(
                sp.expand(f.subs({x: scale * x for x in state}, simultaneous=True) - scale * f) == 0
                for f in [*self.dynamics.values(), *self.terminal]
            )
        ):
            self._kind = _Turn
        else:
            raise Unknown("no independent optimum is known for a transfer of this kind")

    def _linear(self):
        symbols = [*self.dynamics, self.control]
        return len(self.dynamics) == 2 and all(
            sp.diff(f, x).free_symbols == set() for f in self.dynamics.values() for x in symbols
        )

    def at(self, values, **options):
        """The optimum for given values of the parameters."""

        def put(e):
            return e.subs(values, simultaneous=True)

        start = np.array([float(put(e)) for e in self.initial])
        # State symbols that stand for the start are values of parameters, never to be replaced in
        # the dynamics.
        free = {p: v for p, v in values.items() if p not in self.dynamics}
        parts = (
            tuple(e.subs(free) for e in expressions)
            for expressions in (self.dynamics.values(), self.bounds, self.terminal)
        )
        system = _system(self._kind, tuple(self.dynamics), self.control, *parts)
        return _Optimum(system, start, self.slowest, **options)

    def samples(self, count=SAMPLES):
        """Sets of parameters for which the target can be reached, with the optimum: of several
        sizes and both signs."""
        if not self.parameters:
            return [({}, self.at({}))]
        if count not in self._found:
            self._found[count] = self._sampled(count)
        return self._found[count]

    def _sampled(self, count):
        solvable, found = filter(self.solvable, _drawn(self.parameters, 400 * count)), []
        while len(found) < count:
            fresh = [
                (values, self.at(values))
                for values in itertools.islice(solvable, count - len(found))
            ]
            if not fresh:
                raise RuntimeError("too few starts from which the target can be reached were met")
            for system in {best.system for _, best in fresh}:
                system.foresee([best.begin for _, best in fresh if best.system is system])
            found += [
                (values, best)
                for values, best in fresh
                if math.isfinite(best.duration) and best.duration > 0
            ]
        # next to zero too: a smooth function is not the sign of its argument there
        if self._kind is _Line:
            near = (
                {p: v if p.is_positive or p.is_integer else v * CLOSE for p, v in values.items()}
                for values, _ in found[:2]
            )
            found += [(values, self.at(values)) for values in near if self.solvable(values)]
        return found

    def _key(self):
        return (
            tuple(self.dynamics.items()),
            self.control,
            tuple(self.bounds),
            tuple(self.initial),
            tuple(self.terminal),
            tuple(self.parameters),
            self.slowest,
        )

    def solvable(self, values):
        """Whether the target can be reached, None for a start that lies on it."""
        place = tuple(values.items())
        if place not in self._decided:
            self._decided[place] = self._decide(values)
        return self._decided[place]

    def _decide(self, values):
        start = [
            values[e] if e in values else e.subs(values, simultaneous=True) for e in self.initial
        ]
        # Thousands of starts are asked about: what SymPy need not look at is left out.
        at = dict(zip(self.dynamics, start))
        gaps = ((at[g] if g in at else g.xreplace(at)) for g in self.terminal)
        if all((gap.subs(values) if gap.free_symbols else gap) == 0 for gap in gaps):
            return None
        if self._kind is not _Linear:
            return self.at(values).possible()
        return self._modes_allow(start) and self._system().holds(np.array(start, dtype=float))

    def solvable_condition(self):
        """The condition on the parameters under which the target can be reached from a start off
        it, or None."""
        if self._kind is _Line:
            return reach.on_a_line(self.dynamics, self.control, self.bounds, *self._ends())
        matrix, column, constant = _linear_parts(self.dynamics, self.control)
        if self._kind is not _Linear or any(constant):
            return None
        return reach.to_origin(matrix, column, self.bounds, self.initial)

    def off_target(self):
        """The condition that the start does not lie on the target."""
        at = dict(zip(self.dynamics, self.initial))
        return sp.Or(*(sp.Ne(gap.subs(at, simultaneous=True), 0) for gap in self.terminal))

    def in_time_condition(self, duration):
        """The condition under which the target is reached within the duration, or None."""
        return (
            reach.in_time(self.dynamics, self.control, self.bounds, *self._ends(), duration)
            if self._kind is _Line
            else None
        )

    def _ends(self):
        """The start and the target of a transfer with one state."""
        (x,), (gap,) = self.dynamics, self.terminal
        return self.initial[0], sp.solve(gap, x)[0]

    def told_solvable(self, values):
        return "from there the target " + (
            "can be reached" if self.solvable(values) else "cannot be reached, whatever the control"
        )

    def reach(self, duration):
        """Distances from zero of the starts from which `duration` is the least time, in many
        directions."""
        return self._system().radii(duration)

    def _system(self):
        return _system(
            _Linear,
            tuple(self.dynamics),
            self.control,
            tuple(self.dynamics.values()),
            tuple(self.bounds),
            tuple(self.terminal),
        )

    def _modes_allow(self, start):
        """Exactly: the part of the start along each mode that does not decay must lie in what the
        control can undo."""
        return all(
            low < -sum(map(operator.mul, left, start)) < high for left, low, high in self._modes
        )

    @functools.cached_property
    def _modes(self):
        """Left eigenvectors w of modes that do not decay, with the ends of the open interval in
        which -w.x0 has to lie.

        -w.x0 = int e^{-lambda s} w.b u ds, and the ends would need an infinite time, or one extreme
        control throughout.
        """
        matrix, column, constant = _linear_parts(self.dynamics, self.control)
        if any(constant):
            raise RuntimeError("a linear system without a constant part was expected")
        found = []
        for value, _, vectors in matrix.T.eigenvects():
            for left in vectors if value.is_real and value >= 0 else ():
                effect = (left.T * column)[0]
                pushes = [effect * b for b in self.bounds]
                found.append(
                    (
                        left,
                        *sorted(
                            push / value if value else sp.oo * sp.sign(push) if push else 0
                            for push in pushes
                        ),
                    )
                )
        return found


@functools.lru_cache(maxsize=64)
def _kept(key):
    """What is known of a transfer: which starts can reach the target, as far as it has been asked,
    and its samples. Every answer is tried at the same ones."""
    return {}, {}


def _drawn(parameters, count):
    random = np.random.default_rng(51)
    for k in range(count):
        scale = (sp.S.One, sp.Rational(1, 4), sp.Integer(3))[k % 3]
        values = {}
        for p in parameters:
            size = (
                sp.Integer(int(random.integers(1, 6)))
                if p.is_integer
                else scale * sp.Rational(int(random.integers(3, 40)), 13)
            )
            values[p] = (
                size if p.is_positive or not (p.is_negative or random.integers(2)) else -size
            )
        yield values


class _Optimum:
    """The fastest or slowest transfer of a system from one start, with the attributes of
    `direct_optimum.Optimum`: the last entry of `start` and `field` is the time that has passed."""

    def __init__(self, system, start, slowest, meetings=1):
        self.system, self.begin, self.slowest, self.meetings = system, start, slowest, meetings
        self.start, self.bounds = np.append(start, 0.0), system.bounds

    @functools.cached_property
    def duration(self):
        return self.system.duration(self.begin, self.slowest, self.meetings)

    @property
    def cost(self):
        return self.duration

    def cost_size(self):
        return self.duration

    def possible(self):
        """Whether the target can be reached at all."""
        return self.system.possible(self.begin)

    def size(self):
        """The size of the states of this transfer."""
        return (
            float(np.linalg.norm(self.begin) + np.linalg.norm(self.system.gap(self.begin))) or 1.0
        )

    def left(self):
        """States on the way, and the time that is left there."""
        return self.states, self.duration - self.times

    def told_duration(self, said):
        return self.system.told_time(self.begin, said, self.duration)

    def switchings(self):
        return self.system.switchings(self.begin, self.duration)

    def breaks(self):
        """The times at which the control switches."""
        return self.system.breaks(self.begin, self.duration)

    def switching_function(self):
        """Pairs (time, dH/du), the costate being followed back from the end."""
        return self.system.switching_function(self.begin, self.duration, self.slowest)

    def field(self, y, u):
        return np.append(self.system.field(y[:-1], u), 1.0)

    def gap(self, y):
        return self.system.gap(y[:-1])

    def total(self, y):
        return float(y[-1])

    def jacobians(self, y, u):
        n = len(y)
        return (
            np.vstack([self.system.jacobian(y, u), np.zeros(n)]),
            np.zeros((1, n)),
            self.system.normals(),
        )

    @functools.cached_property
    def _path(self):
        """Times, states and controls along the optimum, at instants away from the switchings."""
        return self.system.path(self.begin, self.duration, self.slowest, 37)

    times = property(lambda self: self._path[0])
    states = property(lambda self: np.array(self._path[1]).T)
    controls = property(lambda self: self._path[2])


@functools.lru_cache(maxsize=256)
def _system(kind, state, control, field, bounds, terminal):
    return kind(state, control, field, bounds, terminal)


class _System:
    """A system with numbers for its parameters."""

    def __init__(self, state, control, field, bounds, terminal):
        self.bounds = tuple(map(float, bounds))
        symbols = [*state, control]
        self._field = sp.lambdify(symbols, field, "math")
        self._jacobian = sp.lambdify(
            symbols, sp.Matrix(field).jacobian(list(state)).tolist(), "math"
        )
        self._gap = sp.lambdify(list(state), terminal, "math")
        self._normals = np.array(sp.Matrix(terminal).jacobian(list(state)), dtype=float)

    def field(self, y, u):
        return np.array(self._field(*y, u), dtype=float)

    def jacobian(self, y, u):
        return np.array(self._jacobian(*y, u), dtype=float)

    def gap(self, y):
        """What vanishes on the target."""
        return np.array(self._gap(*y), dtype=float)

    def normals(self):
        return self._normals

    def foresee(self, starts):
        """Find the optima from many starts at once, where that is quicker than one by one."""

    def path(self, start, duration, slowest, count):
        times = duration * (np.arange(count) + 0.37) / count
        states, controls, y, t = [], [], np.array(start, dtype=float), 0.0
        for target in times:
            y = self._advance(y, t, target, start, duration, slowest)
            t = target
            states.append(y)
            controls.append(self.law(y, t, start, duration, slowest))
        return times, states, controls

    def _advance(self, y, begin, end, start, duration, slowest, steps=12):
        breaks = [t for t in self.breaks(start, duration) if begin < t < end]
        for left, right in zip([begin, *breaks], [*breaks, end]):
            h = (right - left) / steps
            for k in range(steps):
                middle = left + (k + 0.5) * h
                y = rk4(
                    lambda s, z: self.field(z, self.law(z, middle, start, duration, slowest)),
                    left + k * h,
                    y,
                    h,
                )
        return y

    def breaks(self, start, duration):
        return []


class _Line(_System):
    """One state: everything is the rate towards the target."""

    def _target(self):
        slope, here = self._normals[0, 0], self.gap([0.0])[0]
        return -here / slope

    def _rate(self, x, way):
        return max(way * self.field([x], u)[0] for u in self.bounds)

    def possible(self, start):
        begin, end = float(start[0]), self._target()
        way = np.sign(end - begin)
        return all(self._rate(x, way) > 0 for x in np.linspace(begin, end, 100))

    def duration(self, start, slowest, meetings):
        from scipy.integrate import quad

        if slowest or meetings != 1:
            raise RuntimeError("with one state only the fastest transfer is known")
        begin, end = float(start[0]), self._target()
        way = np.sign(end - begin)
        if way == 0:
            return 0.0
        if not self.possible(start):
            return math.inf
        return quad(
            lambda x: 1 / self._rate(x, way),
            *sorted((begin, end)),
            epsabs=0,
            epsrel=1e-11,
            limit=200,
        )[0]

    def law(self, y, t, start, duration, slowest):
        way = np.sign(self._target() - float(start[0]))
        return max(self.bounds, key=lambda u: way * self.field(y, u)[0])

    def told_time(self, start, said, true):
        if said < true:
            return "moving towards the target as fast as the bounds allow, the state has not arrived by then"
        return "moving towards the target as fast as the bounds allow, the state arrives earlier"

    def switchings(self, start, duration):
        return 0


class _Turn(_System):
    """Two states, homogeneous of the first degree: the direction theta of the state obeys an
    equation of its own."""

    def possible(self, start):
        return True

    def _rates(self, theta):
        c, s = math.cos(theta), math.sin(theta)
        return [c * f[1] - s * f[0] for f in (self.field((c, s), u) for u in self.bounds)]

    @functools.cached_property
    def _sense(self):
        """The sense in which the direction turns, the same for all controls."""
        rates = [r for theta in np.linspace(0, math.pi, 181) for r in self._rates(theta)]
        if min(rates) < 1e-9 < max(rates) or max(map(abs, rates)) < 1e-9:
            raise RuntimeError("the direction does not turn in one sense for all controls")
        return math.copysign(1, rates[0])

    def _angle(self, start, meetings):
        """The angle from the start to the meeting with the target, later than the start, in the
        sense of turning."""
        normal = self._normals[0]
        line = math.atan2(normal[0], -normal[1])
        theta = math.atan2(start[1], start[0])
        first = (self._sense * (line - theta)) % math.pi
        return (math.pi if first < 1e-12 or first > math.pi - 1e-12 else first) + math.pi * (
            meetings - 1
        )

    def _speed(self, theta, slowest):
        return (min if slowest else max)(map(abs, self._rates(theta)))

    def duration(self, start, slowest, meetings):
        from scipy.integrate import quad

        theta, sense = math.atan2(start[1], start[0]), self._sense
        angle = self._angle(start, meetings)
        return quad(
            lambda a: 1 / self._speed(theta + sense * a, slowest),
            0,
            angle,
            epsabs=0,
            epsrel=1e-11,
            limit=400,
        )[0]

    def law(self, y, t, start, duration, slowest):
        rates = [abs(r) for r in self._rates(math.atan2(y[1], y[0]))]
        return self.bounds[(np.argmin if slowest else np.argmax)(rates)]

    def switching_function(self, start, duration, slowest, steps=240):
        h, y, states = (
            duration / steps,
            np.array(start, dtype=float),
            [np.array(start, dtype=float)],
        )
        for k in range(steps):
            y = rk4(
                lambda t, z: self.field(z, self.law(z, t, start, duration, slowest)), k * h, y, h
            )
            states.append(y)
        # At the end psi is normal to the target, and psi.f = 1 (-1 for the slowest) gives its
        # length.
        u = self.law(y, duration, start, duration, slowest)
        normal = self._normals[0]
        psi = normal * (-1 if slowest else 1) / (normal @ self.field(y, u))
        found = []
        for k in range(steps, 0, -2):
            first, middle, last = states[k], states[k - 1], states[k - 2]
            slopes = [
                self.jacobian(z, self.law(z, 0, start, duration, slowest)).T
                for z in (first, middle, last)
            ]
            found.append(
                (
                    k * h,
                    float(
                        psi
                        @ (self.field(first, self.bounds[1]) - self.field(first, self.bounds[0]))
                    )
                    / (self.bounds[1] - self.bounds[0]),
                )
            )
            a = slopes[0] @ psi
            b = slopes[1] @ (psi + h * a)
            c = slopes[1] @ (psi + h * b)
            d = slopes[2] @ (psi + 2 * h * c)
            psi = psi + h / 3 * (a + 2 * b + 2 * c + d)
        return found

    def turned(self, start, duration, slowest, steps=400):
        """The angle turned by the fastest or slowest control in a given time."""
        theta, sense = math.atan2(start[1], start[0]), self._sense
        angle = 0.0
        for _k in range(steps):
            angle = rk4(
                lambda _, a: self._speed(theta + sense * a, slowest), 0, angle, duration / steps
            )
        return angle

    def told_time(self, start, said, true):
        if not 0 < said < 100 * true:
            return (
                "the process ends at a positive time"
                if said <= 0
                else "by then every admissible control has met the target long before"
            )
        least, most = (self.turned(start, said, s) for s in (True, False))
        return (
            f"by then the direction of (x, x') has turned by {least:.4g} at least and {most:.4g} "
            "at most, "
            "depending on the control: compare this with the angle from the start to the target"
        )


class _Linear(_System):
    """x' = Ax + bu in the plane, the origin as the target.

    Time runs back here: what can be brought to the origin within T is what x' = -Ax - bu reaches
    from there, and it only grows with T. The least times are those of `fastest_times`, to more
    digits.
    """

    DIRECTIONS = 720

    def __init__(self, state, control, field, bounds, terminal):
        super().__init__(state, control, field, bounds, terminal)
        if not self.bounds[0] <= 0 <= self.bounds[1]:
            raise RuntimeError("the origin has to be a state of rest for an admissible control")
        self._back = Plant([-f for f in field], state, control, bounds)
        # Sums of powers of time grow slowly, exponentials fast.
        self._longest = 4096.0 if not (self._back.A @ self._back.A).any() else 128.0
        self._found, self._plans = {}, {}

    def duration(self, start, slowest, meetings):
        if slowest or meetings != 1:
            raise RuntimeError("with the origin as the target only the fastest transfer is known")
        return self._optimum(start)[0]

    def _optimum(self, start):
        """(least time, angle of a direction p for which no state that can be brought to the origin
        in this time has a smaller p.x)."""
        self.foresee([start])
        return self._found[tuple(start)]

    def foresee(self, starts):
        starts = [start for start in dict.fromkeys(map(tuple, starts)) if start not in self._found]
        if not starts:
            return
        x, case = np.array(starts), np.arange(len(starts))
        lanes = FastestTimes(self._back, ConvexTarget.points(x)).solve(
            np.zeros_like(x), case, far=True
        )
        time, angle, reached = lanes.time, lanes.angle, np.isfinite(lanes.time)
        time[reached], angle[reached] = self._closer(x[reached], time[reached], angle[reached])
        self._found.update(zip(starts, zip(time.tolist(), angle.tolist())))

    def _closer(self, x, time, angle, step=1e-6):
        """The same to about ten digits, by Newton's iteration for the motion, time running back, to
        end at the start x."""

        def miss(time, angle):
            return self._back.farthest(directions(angle), time, -1) - x

        def slopes(time, angle):
            return np.stack(
                [
                    miss(time + step, angle) - miss(time - step, angle),
                    miss(time, angle + step) - miss(time, angle - step),
                ],
                axis=2,
            ) / (2 * step)

        better, turned = time, angle
        for _ in range(5):
            # Without a switching the end does not depend on the angle, and the least step leaves
            # the angle as it is.
            change = np.einsum(
                "nij,nj->ni",
                np.linalg.pinv(slopes(better, turned), rcond=1e-9),
                miss(better, turned),
            )
            better, turned = better - change[:, 0], turned - change[:, 1]
        closer = np.linalg.norm(miss(better, turned), axis=1) <= np.linalg.norm(
            miss(time, angle), axis=1
        )
        good = closer & (abs(better - time) < 1e-3 * time)
        return np.where(good, better, time), np.where(good, turned, angle)

    def holds(self, start):
        """Whether some time suffices, up to the precision of the grid of directions."""
        normals, support = self._limits
        return bool(np.all(normals @ start <= support + 1e-9 * np.abs(start).sum()))

    @functools.cached_property
    def _limits(self):
        """Directions q, and S_T(q) for a time T as long as any that is looked at."""
        normals = directions((np.arange(self.DIRECTIONS) + 0.5) * 2 * math.pi / self.DIRECTIONS)
        return normals, self._support(normals, self._longest)

    def _support(self, normals, time):
        return self._back.extreme(normals, np.full(len(normals), time), 1)

    def radii(self, duration):
        normals = directions(np.linspace(0, 2 * math.pi, 90, endpoint=False))
        support = self._support(normals, duration)
        # The set {q.x <= S(q) for all q} is met along a direction d at the least S(q)/q.d.
        along = normals @ normals.T
        return np.min(
            np.where(along > 1e-9, support[:, None] / np.where(along > 1e-9, along, 1), np.inf),
            axis=0,
        )

    def breaks(self, start, duration):
        return self._plan(start, duration)[0]

    def _plan(self, start, duration):
        """The switching times of the fastest control and its first value: time running back, it
        makes p.y least at the end."""
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
            pushed = float(p[0] @ self._back.response(duration * 2e-4)[0])
            self._plans[key] = inner, self.bounds[1] if pushed < 0 else self.bounds[0]
        return self._plans[key]

    def switchings(self, start, duration):
        return len(self.breaks(start, duration))

    def law(self, y, t, start, duration, slowest):
        breaks, first = self._plan(start, duration)
        return first if sum(b < t for b in breaks) % 2 == 0 else sum(self.bounds) - first

    def told_time(self, start, said, true):
        return (
            "that is not enough for any admissible control"
            if said < true
            else "an admissible control arrives earlier"
        )


def _linear_parts(dynamics, control):
    state = list(dynamics)
    field = sp.Matrix(list(dynamics.values()))
    zero = dict.fromkeys([*state, control], 0)
    return field.jacobian(state), field.jacobian([control]), list(field.subs(zero))


def rk4(field, t, y, h):
    """A step of the classical method of Runge and Kutta."""
    a = field(t, y)
    b = field(t + h / 2, y + h / 2 * a)
    c = field(t + h / 2, y + h / 2 * b)
    d = field(t + h, y + h * c)
    return y + h / 6 * (a + 2 * b + 2 * c + d)
