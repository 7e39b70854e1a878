"""Feedback laws for time-optimal control, judged by what they do against an independent optimum.

The plant is x' = Ax + bu with u between two bounds, the state is a point of the plane, and the target is a point, a segment, a
line, or the border of a convex set. Before the first moment at which the set R(T) of reachable states meets a convex D there is
a line between the two; so the shortest time is the first T at which, for every direction p,

    min p.y over R(T) = p.e^{AT}x0 + int_0^T min_u (p.e^{As}b u) ds  <=  sup p.y over D.

From inside D the border is met when for some direction the farthest point of R(T) is as far as that of D. Both are exact,
and neither a law nor a shooting comes in: a law that does as well is optimal, and one that does not is not.

How data are written. `field`: two expressions, linear in `state` and `control`. `target`: the expressions that vanish at the end,
[x1, x2] for the origin, [x1**2 + x2**2 - R**2] for a circle; or a list of number pairs, for the segment between them. `parameters`:
a dict from symbols to SymPy intervals, or finite sets where few cases tell enough. `start`: a condition on the initial state, such as
x1**2 + x2**2 > R**2.
"""

import functools

import numpy as np
import sympy as sp

from trajlib.checks import coercion
from trajlib.checks.verdict import Invalid, Wrong, judged

#: A law may be slower than the optimum by this share: its switching curve may be written in decimals.
SLOWER = 0.004
#: How close to the target counts as on it, in units of the size of the state.
CLOSE = 3e-5
#: Two values of a law this close are one.
SAME = 1e-6
#: Times up to this one are looked at closely, and up to twenty times as long roughly, where it is asked whether a target is in reach.
HORIZON = 20.0
#: The part of the fastest time for which a law is followed; whether the rest suffices is asked of the optimum.
FOLLOWED = 0.97
#: Directions up to this angle from a good one are searched for a better: nearly the half of all that can separate.
WIDE = 1.5705
#: How far from a border two answers must agree about a point, in units of the size of the state.
BESIDE, BESIDE_DECIMALS = 0.006, 0.015


@judged
def time_optimal_law(answer, field, state, control, bounds, target, parameters=None, start=None, curve=None):
    """A law u(state) that brings every start, from which the target can be reached, there in the shortest time.

    `curve` = (symbol, abscissa, ends, variable, interval) lets the law use a switching curve that has no elementary equation: the
    symbol is the second coordinate of this curve where its first one is `abscissa`; the rest is as in `switching_points`.
    """
    parameters = dict(parameters or {})
    claim = coercion.as_expression(answer, [*state, *parameters, *([curve[0]] if curve else [])])
    curve = curve and (*curve[:2], tuple(sp.sympify(end) for end in curve[2]), *curve[3:])
    return _time_optimal(claim, _frozen(field, state, control, bounds, target, parameters, start), curve)


@functools.lru_cache(maxsize=64)
def _time_optimal(claim, data, curve):
    """The sentence on a law that is optimal: a law is often judged again beside another answer."""
    field, state, control, bounds, target, parameters, start = data
    truth, parameters = _truth(*data), dict(parameters)
    law = _Law(claim, state, list(parameters), truth)
    if curve:
        ends = _Ends(field, state, control, bounds, target, *curve[2:4], parameters | {curve[3]: curve[4]}, start)
        law = _Law(claim, state, list(parameters), truth, (curve[0], sp.lambdify([*state, *parameters], curve[1], "numpy"), ends))
    decimals = claim.has(sp.Float)
    lanes = truth.lanes(decimals)
    values = law(lanes.x, lanes.case)
    low, high = truth.plant.bounds
    for k in np.flatnonzero(~np.isfinite(values)):
        raise Wrong(f"{truth.told(lanes, k)} your law gives no real number")
    for k in np.flatnonzero((values < low - SAME) | (values > high + SAME)):
        raise Wrong(f"{truth.told(lanes, k)} your law gives {control} = {values[k]:.4g}, outside its bounds")
    other = np.flatnonzero(abs(values - lanes.control) > SAME)
    # The starts far from the switching curve first: there a law loses most.
    other = other[np.argsort(-abs(lanes.switching[other]))]
    while len(other):
        few, other = other[:3], other[3:]
        few = lanes.take(few[truth.robust(lanes.take(few), decimals)])
        if not len(few.x):
            continue
        _follow(law, truth, few)
        if truth.beside_barrier(few.take(slice(0, 1)))[0]:
            continue
        raise Wrong(f"{truth.told(few, 0)} your law gives {control} = {law(few.x, few.case)[0]:.4g}, and the fastest motion from there "
                    "begins with another value")
    followed = truth._kept.setdefault("followed", set())
    if (claim, str(curve)) not in followed:
        _follow(law, truth, lanes)
        followed.add((claim, str(curve)))
    return f"from {len(lanes.x)} starts, some of them next to the switching curve, it needs the shortest time there is"


@judged
def minimal_time(answer, field, state, control, bounds, target, parameters=None, start=None):
    """The shortest time to the target as an expression in the initial state, where the target can be reached."""
    parameters = dict(parameters or {})
    claim = coercion.as_expression(answer, [*state, *parameters])
    truth = _truth(*_frozen(field, state, control, bounds, target, parameters, start))
    lanes = truth.lanes(claim.has(sp.Float))
    said = _Law(claim, state, list(parameters), truth)(lanes.x, lanes.case)
    tolerance = 5e-3 if claim.has(sp.Float) else 1e-4
    good = np.isfinite(said) & (abs(said - lanes.time) <= tolerance * lanes.time + 1e-6)
    for k in np.flatnonzero(~good):
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        how = ", which no motion can do" if said[k] < lanes.time[k] else ", but a motion can be faster"
        raise Wrong(f"{truth.told(lanes, k)} your expression gives {told}" + (how if np.isfinite(said[k]) else ""))
    return f"it is the shortest time from {len(lanes.x)} starts"


@judged
def reachable_starts(answer, field, state, control, bounds, target, parameters=None, start=None):
    """The condition on the initial state under which the target can be reached; the border of the set counts either way."""
    parameters = dict(parameters or {})
    claim = coercion.as_condition(answer, [*state, *parameters])
    truth = _truth(*_frozen(field, state, control, bounds, target, parameters, start))
    lanes = truth.border(claim.has(sp.Float))
    said = truth.condition(claim)(lanes.x, lanes.case)
    reached = np.isfinite(lanes.time)
    differs = np.flatnonzero(said != reached)[:12]
    for k in differs[~truth.on_border(lanes.take(differs))] if len(differs) else ():
        raise Wrong(f"{truth.told(lanes, k)} the target " + ("can be reached in a time of " + f"{lanes.time[k]:.4g}" if reached[k] else
                    "cannot be reached: a line separates it from all states that can be reached, at every time")
                    + "; your condition says otherwise")
    return f"it agrees with the reachable sets of {len(said)} starts, many of them close to the border"


@judged
def reached_part(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """The points of the target at which optimal motions end: a condition on `variable`, which numbers the points `ends`.

    `parameters` gives the interval of `variable` too. The ends of an arc count either way.
    """
    domain = dict(parameters or {})
    claim = coercion.as_condition(answer, [variable, *[p for p in domain if p != variable]])
    target = _Ends(field, state, control, bounds, target, ends, variable, domain, start)
    test = sp.lambdify([variable, *target.parameters], claim, "numpy")
    beside = 0.006 if claim.has(sp.Float) else 0.002
    for values in target.samples():
        places = target.places(values)
        rates = target.rates(places, values)
        changes = [target.change(a, b, values) for a, b in zip(places, places[1:])
                   if np.sign(target.rates(np.array([a, b]), values)).prod() < 0]
        # Samples at which the rate hardly differs from zero stay undecided; the borders are tried on both sides instead.
        tried = np.concatenate([places[abs(rates) > 1e-3 * abs(rates).max()], *[[c - beside, c + beside] for c in changes]])
        low, high = target.interval
        tried = tried[(tried > low) & (tried < high)]
        tried = tried[[all(abs(t - c) > beside / 2 for c in changes) for t in tried]]
        reached = target.rates(tried, values) < 0
        with np.errstate(all="ignore"):
            said = np.broadcast_to(np.asarray(test(tried, *values), dtype=bool), tried.shape)
        for k in np.flatnonzero(said != reached):
            point = target.point(tried[k:k + 1], values)[0]
            raise Wrong(f"{target.told(values, tried[k])}, at the point ({point[0]:.4g}, {point[1]:.4g}) of the target, "
                        + ("optimal motions end" if reached[k] else "no admissible motion arrives from the side of the starts")
                        + "; your condition says otherwise")
    return "optimal motions end there, and no motion can arrive at the rest of the target"


@judged
def switching_points(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """The switching curve [x1, x2]: the last switching of the optimal motion that ends at the point `ends` of the target."""
    domain = dict(parameters or {})
    claim = coercion.as_expressions(answer, [variable, *[p for p in domain if p != variable]], length=2)
    target = _Ends(field, state, control, bounds, target, ends, variable, domain, start)
    said = sp.lambdify([variable, *target.parameters], claim, "numpy")
    tolerance = 5e-3 if any(part.has(sp.Float) for part in claim) else 1e-6
    met = 0
    for values in target.samples():
        places = target.places(values, count=24)
        points, times, _ = target.switchings(places, values)
        with np.errstate(all="ignore"):
            given = np.column_stack([np.broadcast_to(np.asarray(part, dtype=float), places.shape) for part in said(places, *values)])
        for k in np.flatnonzero(np.isfinite(times)):
            met += 1
            if not np.all(np.isfinite(given[k])):
                raise Wrong(f"{target.told(values, places[k])} your point is not real")
            if np.linalg.norm(given[k] - points[k]) > tolerance * (1 + np.linalg.norm(points[k])):
                raise Wrong(f"{target.told(values, places[k])} the optimal motion switches {times[k]:.4g} before its end, at a distance "
                            f"{np.linalg.norm(given[k] - points[k]):.4g} from your point ({given[k][0]:.4g}, {given[k][1]:.4g})")
    if not met:
        raise RuntimeError("no motion that ends there switches")
    return "the optimal motions to the target change their control there, for sample values"


@judged
def switching_crossing(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """[before, after]: the determinants of (dP/ds, velocity) on the switching curve P(s) with the two controls.

    `variable` is the s that numbers the curve by the end points, as in `switching_points`. Equal signs: motions cross the curve.
    """
    domain = dict(parameters or {})
    claim = coercion.as_expressions(answer, [variable, *[p for p in domain if p != variable]], length=2)
    target = _Ends(field, state, control, bounds, target, ends, variable, domain, start)
    said = sp.lambdify([variable, *target.parameters], claim, "numpy")
    tolerance = 5e-3 if any(part.has(sp.Float) for part in claim) else 1e-5
    for values in target.samples():
        places = target.places(values, count=12)
        points, times, after = target.switchings(places, values)
        step = 1e-5
        tangent = (target.switchings(places + step, values)[0] - target.switchings(places - step, values)[0]) / (2 * step)
        low, high = target.plant.bounds
        with np.errstate(all="ignore"):
            given = [np.broadcast_to(np.asarray(part, dtype=float), places.shape) for part in said(places, *values)]
        for name, u, numbers in (("before", low + high - after, given[0]), ("after", after, given[1])):
            velocity = points @ target.plant.A.T + np.outer(u, target.plant.b)
            true = tangent[:, 0] * velocity[:, 1] - tangent[:, 1] * velocity[:, 0]
            size = np.linalg.norm(tangent, axis=1) * np.linalg.norm(velocity, axis=1)
            for k in np.flatnonzero(np.isfinite(times) & ~(abs(numbers - true) <= tolerance * size)):
                raise Wrong(f"{target.told(values, places[k])} the determinant of the tangent of the curve and the velocity {name} the "
                            f"switching is not {numbers[k]:.4g}: look at the sign and the size of both")
    return "these are the determinants, for sample values"


@judged
def switching_curve(answer, field, state, control, bounds, target, domain, parameters=None, start=None):
    """A branch of the switching curve, one state variable as an expression in the other, over the interval that `domain` gives."""
    return _crossed(*_curve_and_data(answer, field, state, control, bounds, target, domain, parameters, start))


@judged
def dispersal_curve(answer, field, state, control, bounds, target, domain, parameters=None, start=None):
    """The curve from which two motions are equally fast, written as for `switching_curve`."""
    return _parting(*_curve_and_data(answer, field, state, control, bounds, target, domain, parameters, start))


@judged
def barrier(answer, field, state, control, bounds, target, domain, parameters=None, start=None):
    """The curve across which the fastest time jumps, written as for `switching_curve`."""
    return _jumping(*_curve_and_data(answer, field, state, control, bounds, target, domain, parameters, start))


def _curve_and_data(answer, field, state, control, bounds, target, domain, parameters, start):
    parameters = dict(parameters or {})
    (variable, interval), = domain.items()
    claim = coercion.as_expression(answer, [variable, *parameters])
    return claim, variable, interval, _frozen(field, state, control, bounds, target, parameters, start)


@functools.lru_cache(maxsize=64)
def _crossed(*curve):
    for told, one, other, away in _sides_of(*curve, (1.0,)):
        if one[0].control == other[0].control:
            raise Wrong(f"{told} of your curve the optimal control is the same on both sides")
        if away:
            raise Wrong(f"{told} of your curve the fastest motions leave the curve on both sides: it is no place where they switch")
    return "optimal motions cross the curve, or follow it, and change their control there, at sample points"


@functools.lru_cache(maxsize=64)
def _parting(*curve):
    for told, (one,), (other,), away in _sides_of(*curve, (0.06,)):
        if one.control == other.control or not away:
            raise Wrong(f"{told} of your curve the fastest motions from both sides do not part")
        if abs(one.time - other.time) > 0.12 * one.time + 0.01:
            raise Wrong(f"{told} of your curve the fastest times differ on the two sides: {one.time:.4g} and {other.time:.4g}")
    return "on both sides the fastest motions leave the curve, and their times agree on it, at sample points"


@functools.lru_cache(maxsize=64)
def _jumping(*curve):
    for told, one, other, _ in _sides_of(*curve, (0.04, 0.01)):
        jump, left = (abs(a.time - b.time) for a, b in zip(one, other))
        # At the edge of what is in reach the time may jump to infinity, or grow to it steadily: that is no jump.
        if np.isinf(jump) and any(abs(a.time - b.time) > 0.3 for a, b in (one, other) if np.isfinite(a.time + b.time)):
            raise Wrong(f"{told} of your curve the fastest time does not jump: it grows without bound as the curve is approached")
        # What grows like a root, as next to a motion that grazes the target, would fall to the half.
        if not (jump > 0.02 and (left > 0.7 * jump or np.isinf(jump) and np.isinf(left))):
            raise Wrong(f"{told} of your curve the fastest time does not jump: on its two sides it is {one[0].time:.4g} and "
                        f"{other[0].time:.4g}, closer by {one[1].time:.4g} and {other[1].time:.4g}")
    return "the fastest time jumps across the curve, at sample points"


def _sides_of(claim, variable, interval, data, shares):
    """For points of a curve: a text, the optima on one side and on the other at some distances, whether both motions move away."""
    truth, state, parameters = _truth(*data), data[1], dict(data[5])
    beside = BESIDE_DECIMALS if claim.has(sp.Float) else BESIDE / 2
    index = list(state).index(variable)
    function = sp.lambdify([variable, *parameters], claim, "numpy")
    for case, values in enumerate(truth.cases):
        ends = [float(sp.sympify(end).subs(dict(zip(parameters, values)))) for end in (interval.inf, interval.sup)]
        places = _spread_over(*ends, count=9 if len(truth.cases) == 1 else 5)
        step = 1e-6 * (1 + abs(places))
        with np.errstate(all="ignore"):
            other, ahead = (np.broadcast_to(np.asarray(function(at, *values), dtype=complex), places.shape)
                            for at in (places, places + step))
        told = "".join(f"for {p} = {v:.4g}, " for p, v in zip(parameters, values))
        for k in np.flatnonzero(~np.isfinite(other + ahead) | (abs(other.imag) > 1e-9)):
            raise Wrong(f"{told}at {variable} = {places[k]:.4g} your curve is not real")
        other, slope = other.real, (ahead.real - other.real) / step
        on = np.column_stack([places, other] if index == 0 else [other, places])
        normal = np.column_stack([-slope, np.ones_like(slope)] if index == 0 else [np.ones_like(slope), -slope])
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        shift = beside * (0.3 + np.linalg.norm(on, axis=1))[:, None]
        moves = [sign * share * shift * normal for sign in (1, -1) for share in shares]
        solved = truth.solve(np.concatenate([on + move for move in moves]), np.full(len(on) * len(moves), case))
        n, m = len(on), len(shares)
        sides = [[solved.take(slice(n * (m * side + k), n * (m * side + k + 1))) for k in range(m)] for side in (0, 1)]
        away = [sign * ((side[0].x @ truth.plant.A.T + np.outer(side[0].control, truth.plant.b)) * normal).sum(axis=1) > 0
                for sign, side in zip((1, -1), sides)]
        for k in range(n):
            yield (f"{told}at the point ({on[k][0]:.4g}, {on[k][1]:.4g})", *([lane.take(k) for lane in side] for side in sides),
                   away[0][k] and away[1][k])


@judged
def continuous_time(answer, field, state, control, bounds, target, ends, variable, parameters, start=None):
    """The values of a parameter for which the fastest time is continuous where the target can be reached; borders count either way.

    Tried next to the extremals that touch the target: from beyond them it is missed.
    """
    (name, interval), = ((p, i) for p, i in parameters.items() if p != variable)
    claim = coercion.as_condition(answer, [name])
    values = sorted(_spread_over(float(interval.inf), float(interval.sup), 8))
    data = (field, state, control, bounds, target, ends, variable, parameters[variable], start, name)
    found = [_jump(float(value), *data) for value in values]
    beside = 0.03 if claim.has(sp.Float) else 0.016
    tried = list(zip(values, found))
    for low, high, at_low, at_high in zip(values, values[1:], found, found[1:]):
        if (at_low > 0) == (at_high > 0):
            continue
        while high - low > beside / 2:
            middle = (low + high) / 2
            low, high = (middle, high) if (_jump(float(middle), *data) > 0) == (at_low > 0) else (low, middle)
        tried += [(low - beside, at_low), (high + beside, at_high)]
    for value, jump in tried:
        if bool(claim.subs(name, sp.Float(value))) != (jump == 0):
            raise Wrong(f"for {name} = {value:.4g} the fastest time " + ("jumps across a motion that only touches the target" if jump else
                        "jumps nowhere: it is the same on both sides of all motions that touch the target")
                        + "; your condition says otherwise")
    return "next to the motions that touch the target the fastest time jumps for the other values alone"


@functools.lru_cache(maxsize=256)
def _jumps(value, field, state, control, bounds, target, ends, variable, interval, start, name):
    fixed = {name: sp.Float(value)}
    target, ends, start = target.subs(fixed), [end.subs(fixed) for end in ends], None if start is None else start.subs(fixed)
    truth = _truth(*_frozen(field, state, control, bounds, [target], {}, start))
    family = _Ends(field, state, control, bounds, target, ends, variable, {variable: interval}, start)
    places = family.places((), count=361)
    rates, jump = family.rates(places, ()), 0.0
    for a, b in zip(places[np.append(rates[:-1] * rates[1:] < 0, False)], places[1:][rates[:-1] * rates[1:] < 0]):
        place = np.array([family.change(a, b, ())])
        x, u = family.before(place, (), 0.2)
        speed = truth.plant.A @ x[0] + truth.plant.b * u[0]
        normal = np.array([-speed[1], speed[0]]) / np.linalg.norm(speed)
        sides = truth.solve(x + np.outer((2e-4, -2e-4), normal), np.zeros(2, dtype=int)).time
        if np.isfinite(sides).all():
            jump = max(jump, abs(sides[0] - sides[1]))
    return jump if jump > 0.05 else 0.0


def _jump(value, field, state, control, bounds, target, ends, variable, interval, start, name):
    target = target[0] if isinstance(target, (list, tuple)) else target
    return _jumps(value, tuple(field), tuple(state), control, tuple(bounds), target, tuple(map(sp.sympify, ends)), variable, interval,
                  start, name)


@judged
def other_extremals(answer, field, state, control, bounds, target, start=None):
    """The condition on the start under which there is an extremal to the line besides the fastest one; it may cross the line before."""
    claim = coercion.as_condition(answer, state)
    lanes, later = _line_extremals(field, state, control, bounds, target, start)
    said = _truth(*_frozen(field, state, control, bounds, target, {}, start)).condition(claim)(lanes.x, lanes.case)
    for k in np.flatnonzero(said != np.isfinite(later)):
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(state, lanes.x[k]))
        raise Wrong(f"from {place} there is " + (f"another extremal, which takes {later[k]:.4g}" if np.isfinite(later[k]) else
                    "no other extremal") + f", besides the fastest one of {lanes.time[k]:.4g}")
    return f"it agrees with the extremals from {len(said)} starts"


@judged
def other_extremal_time(answer, field, state, control, bounds, target, start=None):
    """The time that the other extremal of `other_extremals` takes, where there is one."""
    claim = coercion.as_expression(answer, state)
    lanes, later = _line_extremals(field, state, control, bounds, target, start)
    truth = _truth(*_frozen(field, state, control, bounds, target, {}, start))
    said = _Law(claim, state, [], truth)(lanes.x, lanes.case)
    tolerance = 5e-3 if claim.has(sp.Float) else 1e-6
    for k in np.flatnonzero(np.isfinite(later) & ~(abs(said - later) <= tolerance * later)):
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(state, lanes.x[k]))
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        raise Wrong(f"from {place} your expression gives {told}, which is not the time of an extremal slower than the fastest one")
    return "it is the time of the slower extremal, from all sample starts that have one"


def _line_extremals(field, state, control, bounds, target, start):
    """Starts, and the time of the extremal to a line that is next to the fastest one (inf where there is none).

    The costate at the end is p = +-c for the line c.y + d = 0, so F(T) = max p.y over R(T) says it all: an extremal ends at T if F
    reaches the line there, and rises, since its rate is the Hamiltonian; the first of all is the fastest one. Starts next to a
    border of their set are left out.
    """
    truth = _truth(*_frozen(field, state, control, bounds, target, {}, start))
    if "extremals" in truth._kept:
        return truth._kept["extremals"]
    plant, (points, case) = truth.plant, truth._points(1000, seed=7)
    c, d = truth.convex._c[0], truth.convex._d[0]
    times = 60 * (np.arange(0, 1501) / 1500)**1.5
    whole = plant.exponential(times)
    owner, found, doubtful = [], [], np.zeros(len(points), dtype=bool)
    for p, level in ((c, -d), (-c, d)):
        def ahead(T, x, p=p, level=level):
            rows = np.tile(p, (len(T), 1))
            return np.einsum("i,nij,nj->n", p, plant.exponential(T), x) + plant.extreme(rows, T, np.ones(len(T))) - level

        reach = plant.extreme(np.tile(p, (len(times), 1)), times, np.ones(len(times)))
        F = np.einsum("i,tij,nj->nt", p, whole, points) + reach - level
        n, j = np.nonzero((F[:, :-1] < 0) & (F[:, 1:] >= 0))
        low, high = times[j], times[j + 1]
        for _ in range(45):
            middle = (low + high) / 2
            before = ahead(middle, points[n]) < 0
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        owner.append(n)
        found.append((low + high) / 2)
        turning = (F[:, 1:-1] < F[:, :-2]) & (F[:, 1:-1] < F[:, 2:]) | (F[:, 1:-1] > F[:, :-2]) & (F[:, 1:-1] > F[:, 2:])
        doubtful |= (turning & (abs(F[:, 1:-1]) < 0.004 * (0.3 + np.linalg.norm(points, axis=1))[:, None])).any(axis=1)
    ends = np.full((len(points), 1 + max(np.bincount(np.concatenate(owner)), default=0)), np.inf)
    rows, column = np.concatenate(owner), np.zeros(len(points), dtype=int)
    for n, T in zip(rows, np.concatenate(found)):
        ends[n, column[n]], column[n] = T, column[n] + 1
    ends = np.sort(ends, axis=1)
    first = ends[:, 0].copy()
    ends[ends <= first[:, None] * (1 + 1e-6) + 1e-6] = np.inf
    keep = ~doubtful & np.isfinite(first) & (first > 0.02)
    truth._kept["extremals"] = _Lanes(x=points, case=case, time=first).take(keep), ends.min(axis=1)[keep]
    return truth._kept["extremals"]


# A law followed from many starts at once.


class _Law:
    """An expression of the state and the parameters, on many states at once."""

    def __init__(self, expression, state, parameters, truth, curve=None):
        # Symbols are the data's own and functions are SymPy's (coercion.with_symbols), so the code made is ours.
        self._function = sp.lambdify([*state, *parameters, *([curve[0]] if curve else [])], expression, "numpy")
        self._cases = np.array(truth.cases, dtype=float).reshape(len(truth.cases), len(parameters))
        self._abscissa, self._tables = (curve[1], self._tabulated(curve[2], truth)) if curve else (None, [])

    @staticmethod
    def _tabulated(ends, truth):
        key = ("table", str(ends.variable), ends.interval)
        if key not in truth._kept:
            truth._kept[key] = [ends.table(case) for case in truth.cases]
        return truth._kept[key]

    def __call__(self, x, case):
        values = [*x.T, *self._cases[case].T]
        if self._tables:
            places = np.broadcast_to(self._abscissa(*values), len(x))
            ordinate = np.full(len(x), np.nan)
            for k, (first, second) in enumerate(self._tables):
                ordinate[case == k] = np.interp(places[case == k], first, second, left=np.nan, right=np.nan)
            values.append(ordinate)
        with np.errstate(all="ignore"):
            try:
                values = self._function(*values)
            except (TypeError, ValueError, AttributeError, NameError):
                raise Invalid("the law cannot be evaluated: it has to be a real expression in the state, such as a Piecewise") from None
            values = np.broadcast_to(np.asarray(values, dtype=complex), len(x))
        return np.where(abs(values.imag) < 1e-9 * (1 + abs(values)), values.real, np.nan)


def _follow(law, truth, lanes):
    """Raise `Wrong` for a start from which the law needs longer than the optimum."""
    x, passed = _closed_loop(law, truth.plant, lanes)
    left = lanes.time * (1 + SLOWER) + 1e-3 - passed
    missing = truth.missing(x, lanes.case, left, lanes.inside)
    late = np.flatnonzero(~(missing <= CLOSE * (1 + np.linalg.norm(lanes.x, axis=1))))[:8]
    # Next to a barrier a thin target may have been missed by the optimum too.
    for k in late[~truth.beside_barrier(lanes.take(late))] if len(late) else ():
        raise Wrong(f"{truth.told(lanes, k)} the target can be reached in a time of {lanes.time[k]:.4g}; your law has brought the state to "
                    f"({x[k][0]:.4g}, {x[k][1]:.4g}) after {passed[k]:.4g}, and from there it cannot be reached in the time left")


def _closed_loop(law, plant, lanes, steps=48):
    """Where the law has brought each start after the greater part of its fastest time: (states, times).

    The control is held until no value of the law next to the state is the control held: rounding, and what the law says on a
    curve alone, decide nothing. The moment of a switching is found by bisection.
    """
    x, case, end = lanes.x.copy(), lanes.case, FOLLOWED * lanes.time
    t, h, rest, turns = np.zeros(len(x)), end / steps, np.full(len(x), -np.inf), np.zeros(len(x))
    low, high = plant.bounds
    around = np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]) * 1e-8

    def value(x, case):
        return np.clip(np.nan_to_num(law(x, case)), low, high)

    def holds(x, u, case):
        near = (x[:, None] + (1 + abs(x).max(axis=1))[:, None, None] * around).reshape(-1, 2)
        return (abs(value(near, np.repeat(case, 5)).reshape(-1, 5) - u[:, None]) < SAME).any(axis=1)

    u = value(x, case)
    for _ in range(5 * steps):
        busy = np.flatnonzero(t < end - 1e-12)
        if not len(busy):
            break
        step = np.minimum(h[busy], end[busy] - t[busy])
        after = plant.move(x[busy], u[busy], step)
        switching = ~holds(after, u[busy], case[busy])
        here = busy[switching]
        if len(here):
            # A law that chatters is followed with a small delay; where this delay decides, there is nothing to search for.
            late = step[switching].copy()
            early = np.clip(rest[here] + h[here] / 40 - t[here], 0, late)
            delayed = (early > 0) & ~holds(plant.move(x[here], u[here], early), u[here], case[here])
            late[delayed] = early[delayed]
            sought = np.flatnonzero(~delayed)
            if len(sought):
                there = here[sought]
                first, last = early[sought], late[sought]
                for _ in range(40):
                    middle = (first + last) / 2
                    held = holds(plant.move(x[there], u[there], middle), u[there], case[there])
                    first, last = np.where(held, middle, first), np.where(held, last, middle)
                late[sought] = last
            x[here], t[here] = plant.move(x[here], u[here], late), t[here] + late
            said = law(x[here], case[here])
            for k in np.flatnonzero((said < low - SAME) | (said > high + SAME)):
                raise Wrong(f"a motion under your law comes to ({x[here[k]][0]:.4g}, {x[here[k]][1]:.4g}), where it gives {said[k]:.4g}, "
                            "outside the bounds of the control")
            u[here], rest[here] = value(x[here], case[here]), t[here]
        on = busy[~switching]
        x[on], t[on] = after[~switching], t[on] + step[~switching]
    return x, t


# The plant and the optimum.


class _Plant:
    """x' = Ax + bu in the plane, by closed formulas."""

    def __init__(self, field, state, control, bounds):
        field = sp.Matrix([sp.sympify(component) for component in field])
        A, b = field.jacobian(state), field.diff(control)
        if len(state) != 2 or (field - A * sp.Matrix(state) - b * control).applyfunc(sp.expand) != sp.zeros(2, 1):
            raise ValueError("the plant has to be linear in two state variables and the control")
        self.A, self.b = np.array(A, dtype=float), np.array(b, dtype=float).ravel()
        self.bounds = tuple(float(bound) for bound in bounds)
        self.mean, self.half = sum(self.bounds) / 2, (self.bounds[1] - self.bounds[0]) / 2
        self._trace, self._determinant = np.trace(self.A), self.A[0, 0] * self.A[1, 1] - self.A[0, 1] * self.A[1, 0]
        self._square = (self._trace / 2)**2 - self._determinant
        self._root = np.sqrt(abs(self._square))
        self._turned = self.A @ self.b - self._trace / 2 * self.b
        if abs(self._determinant) > 1e-12:
            self._inverse = np.linalg.inv(self.A)

    def exponential(self, s):
        """e^{As}, an array with two more axes than s."""
        s = np.asarray(s, dtype=float)
        centre, square, root = self._trace / 2, self._square, self._root
        if square > 1e-14:
            even, odd = np.cosh(root * s), np.sinh(root * s) / root
        elif square < -1e-14:
            even, odd = np.cos(root * s), np.sin(root * s) / root
        else:
            even, odd = np.ones_like(s), s
        growth = np.exp(centre * s)
        return (growth * even)[..., None, None] * np.eye(2) + (growth * odd)[..., None, None] * (self.A - centre * np.eye(2))

    def response(self, s):
        """(e^{As} b, its integral from 0 to s)."""
        s = np.asarray(s, dtype=float)[..., None]
        centre, square, root = self._trace / 2, self._square, self._root
        if square > 1e-14:
            even, odd = np.cosh(root * s), np.sinh(root * s) / root
        elif square < -1e-14:
            even, odd = np.cos(root * s), np.sin(root * s) / root
        else:
            even, odd = 1.0, s
        impulse = even * self.b + odd * self._turned
        if centre:
            impulse = impulse * np.exp(centre * s)
        if abs(self._determinant) > 1e-12:
            return impulse, (impulse - self.b) @ self._inverse.T
        if abs(self._trace) > 1e-12:
            second = (np.expm1(self._trace * s) / self._trace - s) / self._trace
        else:
            second = s**2 / 2
        return impulse, s * self.b + second * (self.A @ self.b)

    def move(self, x, u, s):
        """The states x after times s under constant controls u, each row its own."""
        return np.einsum("nij,nj->ni", self.exponential(s), x) + u[:, None] * self.response(s)[1]

    def extreme(self, p, T, sign, whole=None):
        """The integral over [0, T] of the least (sign -1) or largest (+1) value of p.e^{As}b u; rows of p and T.

        `whole` is the integral of e^{As}b, if it is known already.
        """
        whole = self.response(T)[1] if whole is None else whole
        zeros = self._zeros(p, T)
        inner = np.einsum("nci,ni->nc", self.response(zeros)[1], p)
        last = (whole * p).sum(axis=1)
        absolute = abs(inner[:, 0]) + abs(last - inner[:, -1])
        if inner.shape[1] > 1:
            absolute = absolute + abs(np.diff(inner, axis=1)).sum(axis=1)
        return self.mean * last + sign * self.half * absolute

    def _zeros(self, p, T):
        """The zeros of p.e^{As}b between 0 and T in order; rows are filled up with T."""
        start, other = p @ self.b, p @ self._turned
        with np.errstate(all="ignore"):
            if self._square < -1e-14:
                first = np.mod(np.arctan2(-self._root * start, other), np.pi) / self._root
                count = int(T.max(initial=0) * self._root / np.pi) + 1
                inner = first[:, None] + np.arange(count) * np.pi / self._root
            elif self._square > 1e-14:
                inner = np.arctanh(-self._root * start / other)[:, None] / self._root
            else:
                inner = (-start / other)[:, None]
        # Without a zero at positive times (nan or negative) the end stands in its place.
        return np.where(inner > 0, np.minimum(inner, T[:, None]), T[:, None])


class _Convex:
    """A convex set D = {g <= 0}, or the hull of some points, by its support function; one for each case of the parameters."""

    def __init__(self, target, state, names, cases):
        target = list(target) if isinstance(target, (list, tuple, sp.MatrixBase)) else [target]
        zero = dict.fromkeys(state, 0)
        self.g, self.point = None, len(target) == 2 and isinstance(target[0], sp.Expr)
        if all(isinstance(part, (list, tuple, sp.Tuple)) for part in target):
            corners = [[[float(v) for v in corner] for corner in target]] * len(cases)
        elif len(target) == 2:
            rows = sp.Matrix([sp.sympify(part) for part in target])
            corner = rows.jacobian(state).inv() * -rows.subs(zero)
            corners = [[[float(v.subs(dict(zip(names, case)))) for v in corner]] for case in cases]
        else:
            self._curve(sp.sympify(target[0]), state, names, cases, zero)
            return
        self.kind, self._corners = "hull", np.array(corners)

    def _curve(self, g, state, names, cases, zero):
        hessian, gradient = sp.hessian(g, state), sp.Matrix([g.diff(v) for v in state])
        if any(v.free_symbols & set(state) for v in hessian):
            raise ValueError("a target of degree one or two is expected")
        gradient, constant = gradient.subs(zero), g.subs(zero)
        numbers = [[np.array(sp.Matrix(part).subs(dict(zip(names, case))), dtype=float) for part in (hessian, gradient, [constant])]
                   for case in cases]
        sign = -1.0 if np.linalg.eigvalsh(numbers[0][0]).min() < -1e-12 else 1.0
        self._H, self._c, self._d = (sign * np.array([n[k] for n in numbers]) for k in range(3))
        self._c, self._d = self._c[:, :, 0], self._d[:, 0, 0]
        self.g = lambda x, case: (np.einsum("ni,nij,nj->n", x, self._H[case], x) / 2 + (self._c[case] * x).sum(axis=1) + self._d[case])
        self.slope = lambda x, case: np.einsum("nij,nj->ni", self._H[case], x) + self._c[case]
        values, vectors = np.linalg.eigh(self._H[0])
        if values.max() < 1e-12:
            self.kind = "line"
        elif values.min() > 1e-12:
            self.kind = "ellipse"
            self._inverse = np.linalg.inv(self._H)
            self._centre = -np.einsum("nij,nj->ni", self._inverse, self._c)
            self._level = np.maximum(-self.g(self._centre, np.arange(len(cases))), 0)
        else:
            self._across, self._along = vectors[:, 1], vectors[:, 0]
            self.kind = "parabola" if abs(self._c @ self._along).min() > 1e-12 else "strip"

    def inside(self, x, case):
        """True where the start lies inside D, whose border is the target."""
        return np.zeros(len(x), dtype=bool) if self.g is None or self.kind == "line" else self.g(x, case) < 0

    def angles(self):
        """The directions to be tried: (angles, spacing); spacing 0 where no others matter."""
        if self.kind in ("line", "strip"):
            normal = self._c[0] if self.kind == "line" else self._across
            first = np.arctan2(normal[1], normal[0])
            return np.array([first, first + np.pi]), 0.0
        if self.kind == "parabola":
            along = self._along * np.sign(self._c[0] @ self._along)
            middle, count = np.arctan2(along[1], along[0]), 96
            return middle + np.pi * ((np.arange(count) + 0.5) / count - 0.5), np.pi / count
        return np.arange(112) * (2 * np.pi / 112), 2 * np.pi / 112

    def support(self, p, case, start):
        """sup p.y over D, for rows of directions; a line has D on its other side, seen from the rows `start`."""
        if self.kind == "hull":
            return np.einsum("nki,ni->nk", self._corners[case], p).max(axis=1)
        if self.kind == "line":
            side = np.sign(self.g(start, case))
            c, d = self._c[case] * side[:, None], self._d[case] * side
            size = np.linalg.norm(c, axis=1)
            return np.where((c * p).sum(axis=1) > 0.999 * size, -d / size, np.inf)
        if self.kind == "ellipse":
            spread = np.einsum("ni,nij,nj->n", p, self._inverse[case], p)
            return (p * self._centre[case]).sum(axis=1) + np.sqrt(2 * self._level[case] * spread)
        across, curvature = p @ self._across, np.einsum("i,nij,j->n", self._across, self._H[case], self._across)
        bend = self._c[case] @ self._across
        if self.kind == "strip":
            middle = -bend / curvature
            width = np.sqrt(np.maximum(middle**2 - 2 * self._d[case] / curvature, 0))
            return across * middle + width
        with np.errstate(all="ignore"):
            scale = (p @ self._along) / (self._c[case] @ self._along)
            return np.where(scale > 0, (across - scale * bend)**2 / (2 * scale * curvature) - scale * self._d[case], np.inf)

    def around(self, random, case, count):
        """Points near the target, on both sides."""
        if self.kind == "hull":
            corners = self._corners[case]
            weights = random.dirichlet(np.ones(corners.shape[0]), count)
            return weights @ corners + random.normal(scale=0.4, size=(count, 2))
        angle = random.uniform(0, 2 * np.pi, count)
        p = np.column_stack([np.cos(angle), np.sin(angle)])
        if self.kind == "ellipse":
            q = p @ self._inverse[case]
            on = self._centre[case] + q * np.sqrt(2 * self._level[case] / np.maximum((p * q).sum(axis=1), 1e-12))[:, None]
            return self._centre[case] + (on - self._centre[case]) * random.uniform(0.5, 1.6, count)[:, None] + 0.02 * p
        if self.kind == "line":
            c = self._c[case]
            along = np.array([-c[1], c[0]]) / np.linalg.norm(c)
            on = (-self._d[case] / (c @ c)) * c + np.outer(random.normal(scale=2, size=count), along)
            return on + random.normal(scale=0.5, size=(count, 2))
        across = random.uniform(-2.5, 2.5, count)
        middle = (self._c[case] @ self._across) * across + 0.5 * (self._across @ self._H[case] @ self._across) * across**2 + self._d[case]
        slope = self._c[case] @ self._along
        along = -middle / slope if self.kind == "parabola" else random.normal(scale=3, size=count)
        return np.outer(across, self._across) + np.outer(along, self._along) + random.normal(scale=0.4, size=(count, 2))


class _Lanes:
    """Many starts side by side, with what is known of each."""

    def __init__(self, **columns):
        self.__dict__.update(columns)

    def take(self, which):
        return _Lanes(**{name: column[which] for name, column in self.__dict__.items()})

    @staticmethod
    def joined(parts):
        return _Lanes(**{name: np.concatenate([part.__dict__[name] for part in parts]) for name in parts[0].__dict__})


class _Truth:
    """The fastest times, and how the fastest motions begin, for sample starts and sample values of the parameters."""

    def __init__(self, field, state, control, bounds, target, parameters, start):
        self.state, self.parameters, self.start = state, dict(parameters), start
        self.plant = _Plant(field, state, control, bounds)
        self.cases = _cases(self.parameters)
        self.convex = _Convex(target, state, list(self.parameters), self.cases)
        self._angles, self._spacing = self.convex.angles()
        # Fine at first; far starts may be in reach too, but no law is asked about them.
        self._times = np.concatenate([HORIZON * (np.arange(1, 131) / 130)**1.6, HORIZON * 1.1**np.arange(1, 33)])
        p = _directions(self._angles)
        rows = np.repeat(p, len(self._times), axis=0), np.tile(self._times, len(p))
        self._least, self._most = (self.plant.extreme(*rows, sign).reshape(len(p), -1) for sign in (-1, 1))
        self._carried = np.einsum("ki,tij->tkj", p, self.plant.exponential(self._times))
        self._kept, self._limited = {}, None  # whether some starts are out of reach: not known yet

    def solve(self, x, case, far=False):
        """The optimum from each start: `time` (inf where out of reach), `control` it begins with, `switching` function there.

        `far`: times beyond the horizon count too.
        """
        x, case = np.asarray(x, dtype=float), np.asarray(case)
        inside = self.convex.inside(x, case)
        parts = [self._solve(x[k:k + 160], case[k:k + 160], inside[k:k + 160], far) for k in range(0, len(x), 160)]
        if not parts:
            return _Lanes(x=x, case=case, inside=inside, **dict.fromkeys(("time", "control", "switching", "angle"), np.zeros(0)))
        return _Lanes.joined(parts)

    def _solve(self, x, case, inside, far, careful=False):
        n, p = len(x), _directions(self._angles)
        support = np.array([self.convex.support(np.broadcast_to(d, (n, 2)), case, x) for d in p])
        low, high, theta, second, todo = np.full(n, np.inf), np.full(n, np.inf), np.zeros(n), np.zeros(n), np.arange(n)
        before = p @ x.T - support
        line, suspects = self._middle(before), []
        apart = np.array([np.full(n, np.inf), before.max(axis=0)])  # the distance of x and D, later R(T) and D, at the last two times
        for j, T in enumerate(self._times if far else self._times[:130]):
            outward = inside[todo]
            gap = self._carried[j] @ x[todo].T - support[:, todo] + np.where(outward, self._most[:, j, None], self._least[:, j, None])
            best = gap.argmax(axis=0)
            largest, angle = gap[best, np.arange(len(todo))], np.where(outward, self._angles[best], self._middle(gap))
            maybe = np.flatnonzero(~outward & (largest <= 0))
            if len(maybe) and careful:
                # Between the directions tried there may be one that separates.
                same = self._gap(line[maybe], np.full(len(maybe), T), x[todo[maybe]], case[todo[maybe]], inside[todo[maybe]])
                angle[maybe], largest[maybe] = line[maybe], same
                here = todo[maybe := maybe[same <= 0]]
                angle[maybe], largest[maybe] = self._best(line[maybe], np.full(len(here), T), x[here], case[here], inside[here],
                                                          np.full(len(here), WIDE), 30, enough=0)
            hit = np.where(outward, largest >= 0, largest <= 0)
            if j and not self.convex.point:
                # A distance that falls and rises again may have been zero in between, if it does so steeply enough.
                drop, rise = np.where(np.isfinite(apart[0]), apart[0], apart[1]) - apart[1], gap.max(axis=0) - apart[1]
                dip = np.flatnonzero(~outward & (drop >= 0) & (rise > 0) & (apart[1] <= 2 * np.maximum(drop, rise)))
                if len(dip):
                    ends = (self._times[j - 2] if j > 1 else 0.0, T)
                    suspects.append((todo[dip], *(np.full(len(dip), end) for end in ends)))
            here = todo[hit]
            if len(here):
                # From inside, a direction between those tried may have got through one or two of the times before.
                earlier = np.where(inside[here], self._times[j - 3] if j > 2 else 0.0, self._times[j - 1] if j else 0.0)
                # From inside, the direction that gets through first; from outside, the last line that separates.
                with np.errstate(all="ignore"):
                    share = np.where(gap[:, hit] >= 0, -before[:, hit] / (gap[:, hit] - before[:, hit]), np.inf)
                begin = np.where(inside[here], self._angles[share.argmin(axis=0)], line[hit])
                low[here], high[here], theta[here] = earlier, T, begin
                elsewhere = np.cos(self._angles[:, None] - begin) < 0.95
                second[here] = self._angles[np.where(elsewhere, share, np.inf).argmin(axis=0)]
            on = ~hit
            todo, before, line, apart = todo[on], gap[:, on], angle[on], np.array([apart[1, on], gap[:, on].max(axis=0)])
            if not len(todo):
                break
        self._dips(suspects, low, high, theta, x, case, inside)
        time, met = np.full(n, np.inf), np.isfinite(high)
        again = np.flatnonzero(met & ~inside) if self._spacing and not careful else ()
        if len(again):
            # Between the directions tried there may be one that separates still. Then all times have to be looked at more closely.
            gap = self._best(theta[again], high[again], x[again], case[again], inside[again], np.full(len(again), WIDE), 26)[1]
            again = again[gap > 0]
            met[again] = False
        time[met], theta[met] = self._refine(x[met], case[met], inside[met], low[met], high[met], theta[met])
        # From inside, R(T) may get through in two places at nearly the same time.
        both = np.flatnonzero(met & inside)
        if len(both) and self._spacing:
            other, angle = self._refine(x[both], case[both], inside[both], low[both], high[both], second[both])
            opened = self._gap(angle, other, x[both], case[both], inside[both]) > -1e-6
            sooner = opened & (other < time[both])
            time[both], theta[both] = np.where(sooner, other, time[both]), np.where(sooner, angle, theta[both])
        if len(again):
            closer = self._solve(x[again], case[again], inside[again], far, careful=True)
            time[again], theta[again] = closer.time, closer.angle
        impulse = self.plant.response(np.where(np.isfinite(time), time, 0))[0]
        switching = (impulse * _directions(theta)).sum(axis=1) * np.where(inside, -1, 1)
        return _Lanes(x=x, case=case, inside=inside, time=time, control=np.where(switching > 0, *self.plant.bounds), switching=switching,
                      angle=theta)

    def _dips(self, suspects, low, high, theta, x, case, inside):
        """Put into low, high and theta where R(T) meets a thin D between two of the times only: there the distance has a dip."""
        if not suspects:
            return
        here, first, last = (np.concatenate(column) for column in zip(*suspects))
        n, K = len(here), len(self._angles)
        rows = [np.tile(part[here], (K, 1) if part.ndim > 1 else K) for part in (x, case, inside)]

        def gaps_of(T):
            return self._gap(np.repeat(self._angles, n), np.tile(T, K), *rows).reshape(K, n)

        def distance(T):
            gaps = gaps_of(T)
            if not self._spacing:
                return gaps.max(axis=0)
            angle = self._angles[gaps.argmax(axis=0)]
            return np.maximum(self._best(angle, T, x[here], case[here], inside[here], np.full(n, WIDE), 16)[1], gaps.max(axis=0))

        closest = _largest(lambda T: -distance(T), (first + last) / 2, (last - first) / 2, 12)
        line, through = self._middle(gaps_of(first)), distance(closest) <= 0
        for k in np.flatnonzero(through)[::-1]:  # the earliest last
            if not closest[k] > high[here[k]]:
                low[here[k]], high[here[k]], theta[here[k]] = first[k], closest[k], line[k]

    def _middle(self, gap):
        """The middle of the directions that separate: they form a convex cone."""
        p = np.maximum(gap > 0, gap == gap.max(axis=0)).T @ _directions(self._angles)
        return np.arctan2(p[:, 1], p[:, 0])

    def _gap(self, theta, T, x, case, inside):
        p = _directions(theta)
        moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
        return (p * moved).sum(axis=1) + self.plant.extreme(p, T, np.where(inside, 1, -1)) - self.convex.support(p, case, x)

    def _best(self, theta, T, x, case, inside, width, steps, enough=np.inf):
        """(direction near theta in which the gap is largest, this gap); or any gap that is large enough.

        From outside, min p.y over R(T) less sup p.y over D is concave in p: along the tangent of the unit circle at p(theta) it has
        one top, and its sign there tells whether any line separates. From inside the unit vectors themselves are compared.
        """
        if not self._spacing:
            return theta, self._gap(theta, T, x, case, inside)
        moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
        whole, sign = self.plant.response(T)[1], np.where(inside, 1, -1)

        def gap(turn):
            p = _directions(theta + turn)
            return (p * moved).sum(axis=1) + self.plant.extreme(p, T, sign, whole) - self.convex.support(p, case, x)

        turn = _largest(lambda turn: gap(turn) / np.where(inside, 1, np.cos(turn)), np.zeros(len(x)), width, steps, enough)
        return theta + turn, gap(turn)

    def _refine(self, x, case, inside, low, high, theta):
        """The first time between low and high at which no line separates, and the last separating direction.

        From inside: at which R(T) gets through the border, and the direction in which it does.
        """
        centre = theta
        for turn in range(18):
            middle = (low + high) / 2
            # The best line may jump from one side of a cone to the other, so at first the whole cone is searched each time.
            around, width, steps = (centre, WIDE, 24) if turn < 8 else (theta, 0.04 * 0.85**turn, 10)
            angle, gap = self._best(around, middle, x, case, inside, np.where(inside, np.minimum(width, 0.15), width), steps)
            met = np.where(inside, gap >= 0, gap <= 0)
            low, high = np.where(met, low, middle), np.where(met, middle, high)
            theta = np.where(met & ~inside, theta, angle)
        return (low + high) / 2, theta

    def missing(self, x, case, left, inside):
        """The distance from the target at the best moment within the times `left`."""
        n, p, steps = len(x), _directions(self._angles), 16
        best, when, angle = np.full(n, np.inf), left, np.zeros(n)
        rows, cases, starts = np.repeat(p, n, axis=0), np.tile(case, len(p)), np.tile(x, (len(p), 1))
        sign = np.tile(np.where(inside, 1, -1), len(p))
        support = self.convex.support(rows, cases, starts).reshape(len(p), n)
        for T in left * (np.arange(1, steps + 1) / steps)[:, None]:
            moved = np.einsum("nij,nj->ni", self.plant.exponential(T), x)
            gaps = p @ moved.T + self.plant.extreme(rows, np.tile(T, len(p)), sign).reshape(len(p), n) - support
            top = np.where(inside, -gaps.max(axis=0), gaps.max(axis=0))
            better = top < best
            best, when = np.where(better, top, best), np.where(better, T, when)
            angle = np.where(better, self._angles[gaps.argmax(axis=0)], angle)
        width = np.full(n, WIDE)

        def apart(T):
            gap = self._best(angle, np.clip(T, 1e-9, left), x, case, inside, width, 24)[1]
            return np.where(inside, -gap, gap)

        closest = _largest(lambda T: -apart(T), when, left / steps, steps=12)
        return np.minimum(apart(closest), apart(when))

    # Which starts are looked at.

    def lanes(self, decimals):
        """Starts spread over the plane, and pairs on both sides of the switching curves."""
        kept = self._kept.get(decimals)
        if kept is None:
            kept = self._kept[decimals] = self._lanes(BESIDE_DECIMALS if decimals else BESIDE)
        return kept

    def _points(self, count, seed=4):
        random, points, cases = np.random.default_rng(seed), [], []
        for case in range(len(self.cases)):
            spread = random.normal(size=(count, 2)) * np.array([0.7, 2, 4])[np.arange(count) % 3, None]
            both = np.concatenate([spread, self.convex.around(random, case, count // 2)])
            points.append(both)
            cases.append(np.full(len(both), case))
        points, cases = np.concatenate(points), np.concatenate(cases)
        keep = self.allowed(points, cases)
        return points[keep], cases[keep]

    def allowed(self, x, case):
        return self.condition(self.start if self.start is not None else sp.true)(x, case)

    def condition(self, condition):
        """A SymPy condition as a function of states and cases."""
        test = sp.lambdify([*self.state, *self.parameters], condition, "numpy")
        cases = np.array(self.cases, dtype=float).reshape(len(self.cases), len(self.parameters))

        def holds(x, case):
            with np.errstate(all="ignore"):
                return np.broadcast_to(np.asarray(test(x[:, 0], x[:, 1], *cases[case].T), dtype=bool), len(x))

        return holds

    def _lanes(self, beside):
        if "near" not in self._kept:
            count = 100 if len(self.cases) == 1 else 24
            spread = self._safe(self.solve(*self._points(count)))
            self._kept["spread"] = spread
            self._kept["near"] = self._between(spread, lambda lanes: lanes.control, 28 if len(self.cases) == 1 else 7)
        spread, near = self._kept["spread"], self._kept["near"]
        if near is None:
            return spread
        middle, direction, case = near
        shift = beside * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
        sides = np.concatenate([middle + shift, middle - shift])
        case = np.concatenate([case, case])
        keep = self.allowed(sides, case)
        return _Lanes.joined([spread, self._safe(self.solve(sides[keep], case[keep]))])

    def _safe(self, lanes):
        """Starts in reach, with all states next to them in reach too, and not on the target already."""
        out_of_reach = lanes.take(~np.isfinite(lanes.time))
        shortest = 0.15 if self.convex.kind == "hull" else 0.02
        lanes = lanes.take(np.isfinite(lanes.time) & (lanes.time > shortest) & (lanes.time < 0.9 * HORIZON))
        if self._limited is None and len(out_of_reach.x):
            self._limited = not np.isfinite(self.solve(out_of_reach.x[:12], out_of_reach.case[:12], far=True).time).all()
        if not self._limited or not len(lanes.x):
            return lanes
        return lanes.take(np.isfinite(self._around(lanes, 0.02, count=4).time).all(axis=1))

    def _around(self, lanes, share, far=False, count=8):
        """The optimum at some states around each, as columns."""
        angle = np.arange(count) * 2 * np.pi / count + 0.3
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        size = share * (0.3 + np.linalg.norm(lanes.x, axis=1))
        points = (lanes.x[:, None] + size[:, None, None] * ring).reshape(-1, 2)
        case = np.repeat(lanes.case, count)
        solved = self.solve(points, case, far)
        same = (solved.inside == np.repeat(lanes.inside, count)) & self.allowed(points, case)
        return _Lanes(time=np.where(same, solved.time, 0).reshape(-1, count),
                      control=np.where(same, solved.control, np.repeat(lanes.control, count)).reshape(-1, count))

    def robust(self, lanes, decimals):
        """True where the fastest motions from all states around begin alike: no switching curve is close."""
        around = self._around(lanes, (BESIDE_DECIMALS if decimals else BESIDE) / 2, count=5)
        return (around.control == lanes.control[:, None]).all(axis=1)

    def beside_barrier(self, lanes):
        """True where the fastest time jumps from one state next to the start to another."""
        times = np.column_stack([self._around(lanes, 0.02).time, lanes.time])
        times = np.sort(np.where(times > 0, times, np.nan), axis=1)
        # The largest gap between two of the times: a steep slope has a wide range of times too, but no such gap.
        with np.errstate(all="ignore"):
            gaps = np.diff(times, axis=1)
            return np.where(np.isnan(gaps), 0, gaps).max(axis=1) > 0.25 * lanes.time

    def _between(self, lanes, kind, count, far=False):
        """Points where `kind` changes: (points, directions across, cases), by bisection between neighbours that differ."""
        left, right, case, random = [], [], [], np.random.default_rng(6)
        for k in range(len(self.cases)):
            here = np.flatnonzero(lanes.case == k)
            if not len(here):
                continue
            marks, x = kind(lanes)[here], lanes.x[here]
            ones = random.permutation(np.flatnonzero(marks == marks.max()))
            others = np.flatnonzero(marks != marks.max())
            if not len(others):
                continue
            for one in ones[:count]:
                # A start inside D is no neighbour of one outside: between the two lies the target.
                alike = others[lanes.inside[here][others] == lanes.inside[here][one]]
                if self.convex.kind == "line":
                    side = np.sign(self.convex.g(x, np.full(len(x), k)))
                    alike = alike[side[alike] == side[one]]
                if len(alike):
                    near = alike[np.argsort(np.linalg.norm(x[alike] - x[one], axis=1))[random.integers(0, min(3, len(alike)))]]
                    left.append(x[one])
                    right.append(x[near])
                    case.append(k)
        if not left:
            return None
        left, right, case = np.array(left), np.array(right), np.array(case)
        direction = (right - left) / np.linalg.norm(right - left, axis=1)[:, None]
        one = kind(self.solve(left, case, far))
        for _ in range(9):
            middle = (left + right) / 2
            same = (kind(self.solve(middle, case, far)) == one)[:, None]
            left, right = np.where(same, middle, left), np.where(same, right, middle)
        return (left + right) / 2, direction, case

    def border(self, decimals):
        """Starts in reach and out of reach, many of them on both sides of the border between."""
        kept = self._kept.get(("border", decimals))
        if kept is None:
            spread = self.solve(*self._points(100 if len(self.cases) == 1 else 40, seed=5), far=True)
            near = self._between(spread, lambda lanes: np.isfinite(lanes.time), 30 if len(self.cases) == 1 else 8, far=True)
            parts = [spread]
            for share in ((0.02,) if decimals else (0.008, 0.03)) if near is not None else ():
                middle, direction, case = near
                shift = share * (0.3 + np.linalg.norm(middle, axis=1))[:, None] * direction
                both, cases = np.concatenate([middle + shift, middle - shift]), np.concatenate([case, case])
                keep = self.allowed(both, cases)
                parts.append(self.solve(both[keep], cases[keep], far=True))
            kept = _Lanes.joined(parts)
            self._kept[("border", decimals)] = kept
        return kept

    def on_border(self, lanes):
        """True where states next to the start are of the other kind: there rounding decides."""
        reach = np.isfinite(lanes.time)
        return (np.isfinite(self._around(lanes, 0.003, far=True).time) != reach[:, None]).any(axis=1)

    def told(self, lanes, k):
        values = self.cases[lanes.case[k]]
        named = ", ".join(f"{p} = {v:.4g}" for p, v in zip(self.parameters, values))
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(self.state, lanes.x[k]))
        return f"{'for ' + named + ', ' if named else ''}from {place}"


class _Ends:
    """A family of points of the target, numbered by a variable, and the optimal motions that end there."""

    def __init__(self, field, state, control, bounds, target, ends, variable, domain, start):
        self.plant, self.variable = _Plant(field, state, control, bounds), variable
        self.parameters = [p for p in domain if p != variable]
        self._interval = domain.get(variable, sp.Interval.open(-sp.oo, sp.oo))
        self._cases = _cases({p: domain[p] for p in self.parameters})
        target = target[0] if isinstance(target, (list, tuple)) else target
        symbols = [variable, *self.parameters]
        along = dict(zip(state, ends))
        gradient = [sp.diff(target, v).subs(along, simultaneous=True) for v in state]
        self._point, self._gradient = sp.lambdify(symbols, list(ends), "numpy"), sp.lambdify(symbols, gradient, "numpy")
        self._side = 1 if start is None else self._starts_side(target, state, start, along, gradient)

    def _starts_side(self, target, state, start, along, gradient):
        """1 if the starts lie where the target's expression is positive."""
        probe = {p: v for p, v in zip(self.parameters, self._cases[0])}
        place = {self.variable: self.places(self._cases[0], count=3)[1]}
        point = {s: sp.sympify(e).subs(place).subs(probe) for s, e in along.items()}
        slope = [sp.sympify(g).subs(place).subs(probe) for g in gradient]
        ahead = {s: float(point[s]) + 1e-3 * float(g) for s, g in zip(state, slope)}
        return 1 if start.subs(probe).subs(ahead) == True else -1  # noqa: E712

    @property
    def interval(self):
        return tuple(float(end) if end.is_finite else np.sign(float(end)) * 6 for end in (self._interval.inf, self._interval.sup))

    def samples(self):
        return self._cases

    def places(self, values, count=181):
        low, high = self.interval
        return low + (high - low) * (np.arange(count) + 0.47) / count  # off the middle, which may be a special point

    def point(self, places, values):
        return self._columns(self._point, places, values)

    def _columns(self, function, places, values):
        with np.errstate(all="ignore"):
            parts = function(places, *values)
        return np.column_stack([np.broadcast_to(np.asarray(part, dtype=float), places.shape) for part in parts])

    def _towards(self, places, values):
        """The normals of the target on the side of the starts."""
        return self._side * self._columns(self._gradient, places, values)

    def rates(self, places, values):
        """The least rate along the normal towards the starts: where it is positive, no motion can arrive."""
        y, n = self.point(places, values), self._towards(places, values)
        push = n @ self.plant.b
        return (n * (y @ self.plant.A.T)).sum(axis=1) + self.plant.mean * push - self.plant.half * abs(push)

    def change(self, one, other, values):
        sign = np.sign(self.rates(np.array([one]), values)[0])
        for _ in range(50):
            middle = (one + other) / 2
            same = np.sign(self.rates(np.array([middle]), values)[0]) == sign
            one, other = (middle, other) if same else (one, middle)
        return (one + other) / 2

    def switchings(self, places, values):
        """(points, times before the end, controls after): where the extremals that end at `places` switch for the last time."""
        y, n = self.point(places, values), self._towards(places, values)
        s = np.linspace(0, 12, 1201)
        q = n @ self.plant.response(s)[0].T
        first = np.where(abs(q[:, 0]) > 1e-12, q[:, 0], q[:, 1])
        turned = np.sign(q) == -np.sign(first)[:, None]
        cell = turned.argmax(axis=1)
        low, high = s[np.maximum(cell - 1, 0)], s[cell]
        for _ in range(60):
            middle = (low + high) / 2
            same = np.sign((self.plant.response(middle)[0] * n).sum(axis=1)) == np.sign(first)
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        time = (low + high) / 2
        after = np.where(first > 0, *self.plant.bounds)
        back = self.plant.exponential(-time)
        points = np.einsum("nij,nj->ni", back, y - after[:, None] * self.plant.response(time)[1])
        usable = turned.any(axis=1) & (self.rates(places, values) < -1e-9)
        return points, np.where(usable, time, np.inf), after

    def before(self, places, values, time):
        """(states, controls) on the extremals that end at `places`, a short time before."""
        y, n = self.point(places, values), self._towards(places, values)
        q = (self.plant.response(np.full(len(places), time / 2))[0] * n).sum(axis=1)
        u = np.where(q > 0, *self.plant.bounds)
        span = np.full(len(places), time)
        return np.einsum("nij,nj->ni", self.plant.exponential(-span), y - u[:, None] * self.plant.response(span)[1]), u

    def table(self, values):
        """The switching curve as two arrays, the first of them increasing."""
        low, high = self.interval
        share = np.concatenate([np.geomspace(1e-12, 0.2, 2500), np.linspace(0.2, 0.8, 2500), 1 - np.geomspace(1e-12, 0.2, 2500)])
        share = np.unique(share)
        points, times, _ = self.switchings(low + (high - low) * share, values)
        points = points[np.isfinite(times)]
        return tuple(points[np.argsort(points[:, 0])].T)

    def told(self, values, place):
        named = [f"{p} = {v:.4g}" for p, v in zip(self.parameters, values)] + [f"{self.variable} = {place:.4g}"]
        return "for " + ", ".join(named)


# Samples.


def _directions(angles):
    return np.column_stack([np.cos(angles), np.sin(angles)])

def _frozen(field, state, control, bounds, target, parameters, start):
    """The data as hashable values, so that the optimum is computed once."""
    def fixed(value):
        return tuple(map(fixed, value)) if isinstance(value, (list, tuple, sp.MatrixBase)) else sp.sympify(value)

    target = list(target) if isinstance(target, (list, tuple)) else [target]
    return (fixed(list(field)), tuple(state), control, fixed(list(bounds)), fixed(target),
            tuple(parameters.items()), None if start is None else sp.sympify(start))


@functools.lru_cache(maxsize=64)
def _truth(field, state, control, bounds, target, parameters, start):
    return _Truth(field, state, control, bounds, target, parameters, start)


def _cases(parameters):
    """Sample values of all parameters together: one row for each case."""
    if not parameters:
        return [()]
    columns = [[float(value) for value in domain] if isinstance(domain, sp.FiniteSet)
               else _spread_over(float(domain.inf), float(domain.sup))
               for domain in parameters.values()]
    return [tuple(float(column[(k + 2 * c) % len(column)]) for c, column in enumerate(columns)) for k in range(len(columns[0]))]


def _spread_over(low, high, count=6):
    """Values inside an interval, which may be infinite."""
    shares = (np.arange(count) + 0.55) / count
    if np.isfinite(low) and np.isfinite(high):
        return low + (high - low) * shares
    if np.isfinite(low):
        return low + 0.8 * shares / (1.1 - shares)
    if np.isfinite(high):
        return high - 0.8 * shares / (1.1 - shares)
    return 4 * (2 * shares - 1)


def _largest(function, centre, width, steps, enough=np.inf):
    """The place of the largest value within centre +- width, each row its own, by golden section; values above `enough` will do."""
    ratio = (np.sqrt(5) - 1) / 2
    low, high = centre - width, centre + width
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    at_a, at_b = function(a), function(b)
    for _ in range(steps):
        if (np.maximum(at_a, at_b) > enough).all():
            break
        up = at_a < at_b
        low, high = np.where(up, a, low), np.where(up, high, b)
        a, b = np.where(up, b, high - ratio * (high - low)), np.where(up, low + ratio * (high - low), a)
        fresh = function(np.where(up, b, a))
        at_a, at_b = np.where(up, at_b, fresh), np.where(up, fresh, at_a)
    return np.where(at_a > at_b, a, b)
