"""Feedback laws for time-optimal control, judged by what they do against an independent optimum.

The optimum is that of `fastest_times`: the plant is x' = Ax + bu with u between two bounds, the target a point, a
segment, a line, or the border of a convex set. A law that does as well is optimal, and one that does not is not.

How data are written. `field`: two expressions, linear in `state` and `control`. `target`: the expressions that vanish
at the end, [x1, x2] for the origin, [x1**2 + x2**2 - R**2] for a circle; or a list of number pairs, for the segment
between them. `parameters`: a dict from symbols to SymPy intervals, or finite sets where few cases tell enough. `start`:
a condition on the initial state, such as x1**2 + x2**2 > R**2.
"""

import functools

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import in_decimals, share
from trajlib.checks.contract.verdict import Wrong, judged
from trajlib.checks.pontryagin.closed_loop import SAME, Law, follow
from trajlib.checks.tools.samples import spread_over
from trajlib.checks.tools.values import real_function, truth_at
from trajlib.checks.truths.optima.fastest_times import Lanes
from trajlib.checks.truths.optima.sampled_optimum import BESIDE, BESIDE_DECIMALS, frozen, sampled_optimum
from trajlib.checks.truths.optima.target_families import TargetFamily


@judged
def time_optimal_law(answer, field, state, control, bounds, target, parameters=None, start=None, curve=None):
    """A law u(state) that brings every start, from which the target can be reached, there in the shortest time.

    `curve` = (symbol, abscissa, ends, variable, interval) lets the law use a switching curve that has no elementary
    equation: the symbol is the second coordinate of this curve where its first one is `abscissa`; the rest is as in
    `switching_points`.
    """
    parameters = dict(parameters or {})
    claim = coercion.as_expression(answer, [*state, *parameters, *([curve[0]] if curve else [])])
    curve = curve and (*curve[:2], tuple(sp.sympify(end) for end in curve[2]), *curve[3:])
    return _time_optimal(claim, frozen(field, state, control, bounds, target, parameters, start), curve)


@functools.lru_cache(maxsize=64)
def _time_optimal(claim, data, curve):
    """The sentence on a law that is optimal: a law is often judged again beside another answer."""
    field, state, control, bounds, target, parameters, start = data
    truth, parameters = sampled_optimum(*data), dict(parameters)
    law = Law(claim, state, list(parameters), truth)
    if curve:
        ends = _family(field, state, control, bounds, target, *curve[2:4], parameters | {curve[3]: curve[4]}, start)
        law = Law(claim, state, list(parameters), truth,
                  (curve[0], sp.lambdify([*state, *parameters], curve[1], "numpy"), ends))
    decimals = in_decimals(claim)
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
        follow(law, truth, few)
        if truth.beside_barrier(few.take(slice(0, 1)))[0]:
            continue
        raise Wrong(f"{truth.told(few, 0)} your law gives {control} = {law(few.x, few.case)[0]:.4g}, and the fastest "
                    f"motion from there begins with another value")
    followed = truth.kept.setdefault("followed", set())
    if (claim, str(curve)) not in followed:
        follow(law, truth, lanes)
        followed.add((claim, str(curve)))
    return f"from {len(lanes.x)} starts, some of them next to the switching curve, it needs the shortest time there is"


@judged
def minimal_time(answer, field, state, control, bounds, target, parameters=None, start=None):
    """The shortest time to the target as an expression in the initial state, where the target can be reached."""
    parameters = dict(parameters or {})
    claim = coercion.as_expression(answer, [*state, *parameters])
    truth = sampled_optimum(*frozen(field, state, control, bounds, target, parameters, start))
    lanes = truth.lanes(in_decimals(claim))
    said = Law(claim, state, list(parameters), truth)(lanes.x, lanes.case)
    tolerance = share(claim, computed=1e-4)
    good = np.isfinite(said) & (abs(said - lanes.time) <= tolerance * lanes.time + 1e-6)
    for k in np.flatnonzero(~good):
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        how = ", which no motion can do" if said[k] < lanes.time[k] else ", but a motion can be faster"
        raise Wrong(f"{truth.told(lanes, k)} your expression gives {told}" + (how if np.isfinite(said[k]) else ""))
    return f"it is the shortest time from {len(lanes.x)} starts"


@judged
def reachable_starts(answer, field, state, control, bounds, target, parameters=None, start=None):
    """The condition on the initial state under which the target can be reached; the border of the set counts either
    way."""
    parameters = dict(parameters or {})
    claim = coercion.as_condition(answer, [*state, *parameters])
    truth = sampled_optimum(*frozen(field, state, control, bounds, target, parameters, start))
    lanes = truth.border(in_decimals(claim))
    said = truth.condition(claim)(lanes.x, lanes.case)
    reached = np.isfinite(lanes.time)
    differs = np.flatnonzero(said != reached)[:12]
    for k in differs[~truth.on_border(lanes.take(differs))] if len(differs) else ():
        raise Wrong(f"{truth.told(lanes, k)} the target " + ("can be reached in a time of " + f"{lanes.time[k]:.4g}"
                                                             if reached[k] else
                    "cannot be reached: a line separates it from all states that can be reached, at every time")
                    + "; your condition says otherwise")
    return f"it agrees with the reachable sets of {len(said)} starts, many of them close to the border"


@judged
def reached_part(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """The points of the target at which optimal motions end: a condition on `variable`, which numbers the points
    `ends`.

    `parameters` gives the interval of `variable` too. The ends of an arc count either way.
    """
    domain = dict(parameters or {})
    claim = coercion.as_condition(answer, [variable, *[p for p in domain if p != variable]])
    family = _family(field, state, control, bounds, target, ends, variable, domain, start)
    test = sp.lambdify([variable, *family.parameters], claim, "numpy")
    for values, tried, reached, points in _arrivals(family, 0.006 if in_decimals(claim) else 0.002):
        with np.errstate(all="ignore"):
            said = np.broadcast_to(np.asarray(test(tried, *values), dtype=bool), tried.shape)
        for k in np.flatnonzero(said != reached):
            raise Wrong(f"{family.told(values, tried[k])}, at the point ({points[k][0]:.4g}, {points[k][1]:.4g}) of "
                        f"the target, "
                        + ("optimal motions end" if reached[k]
                           else "no admissible motion arrives from the side of the starts")
                        + "; your condition says otherwise")
    return "optimal motions end there, and no motion can arrive at the rest of the target"


def _family(field, state, control, bounds, target, ends, variable, domain, start):
    field, state, control, bounds, target, domain, start = frozen(field, state, control, bounds, target, domain, start)
    return _family_of(field, state, control, bounds, target, tuple(map(sp.sympify, ends)), variable, domain, start)


@functools.lru_cache(maxsize=32)
def _family_of(field, state, control, bounds, target, ends, variable, domain, start):
    return TargetFamily(field, state, control, bounds, target, ends, variable, dict(domain), start)


@functools.lru_cache(maxsize=32)
def _arrivals(family, beside):
    """For each case: its values, places on the target, whether optimal motions end there, the points. No answer changes
    them."""
    found = []
    for values in family.samples():
        places = family.places(values)
        rates = family.rates(places, values)
        changes = [family.change(a, b, values) for a, b in zip(places, places[1:])
                   if np.sign(family.rates(np.array([a, b]), values)).prod() < 0]
        # Samples at which the rate hardly differs from zero stay undecided; the borders are tried on both sides
        # instead.
        tried = np.concatenate([places[abs(rates) > 1e-3 * abs(rates).max()],
                                *[[c - beside, c + beside] for c in changes]])
        low, high = family.interval
        tried = tried[(tried > low) & (tried < high)]
        tried = tried[[all(abs(t - c) > beside / 2 for c in changes) for t in tried]]
        found.append((values, tried, family.rates(tried, values) < 0, family.point(tried, values)))
    return found


@judged
def switching_points(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """The switching curve [x1, x2]: the last switching of the optimal motion that ends at the point `ends` of the
    target."""
    domain = dict(parameters or {})
    claim = coercion.as_expressions(answer, [variable, *[p for p in domain if p != variable]], length=2)
    target = _family(field, state, control, bounds, target, ends, variable, domain, start)
    said = real_function([variable, *target.parameters], claim)
    tolerance = share(*claim, computed=1e-6)
    met = 0
    for values in target.samples():
        places = target.places(values, count=24)
        points, times, _ = target.switchings(places, values)
        given = said(places, *values).T
        for k in np.flatnonzero(np.isfinite(times)):
            met += 1
            if not np.all(np.isfinite(given[k])):
                raise Wrong(f"{target.told(values, places[k])} your point is not real")
            if not np.linalg.norm(given[k] - points[k]) <= tolerance * (1 + np.linalg.norm(points[k])):
                raise Wrong(f"{target.told(values, places[k])} the optimal motion switches {times[k]:.4g} before its "
                            f"end, at a distance "
                            f"{np.linalg.norm(given[k] - points[k]):.4g} from your point ({given[k][0]:.4g}, "
                            f"{given[k][1]:.4g})")
    if not met:
        raise RuntimeError("no motion that ends there switches")
    return "the optimal motions to the target change their control there, for sample values"


@judged
def switching_crossing(answer, field, state, control, bounds, target, ends, variable, parameters=None, start=None):
    """[before, after]: the determinants of (dP/ds, velocity) on the switching curve P(s) with the two controls.

    `variable` is the s that numbers the curve by the end points, as in `switching_points`. Equal signs: motions cross
    the curve.
    """
    domain = dict(parameters or {})
    claim = coercion.as_expressions(answer, [variable, *[p for p in domain if p != variable]], length=2)
    target = _family(field, state, control, bounds, target, ends, variable, domain, start)
    said = real_function([variable, *target.parameters], claim)
    tolerance = share(*claim, computed=1e-5)
    for values in target.samples():
        places = target.places(values, count=12)
        points, times, after = target.switchings(places, values)
        step = 1e-5
        tangent = (target.switchings(places + step, values)[0]
                   - target.switchings(places - step, values)[0]) / (2 * step)
        low, high = target.plant.bounds
        given = said(places, *values)
        for name, u, numbers in (("before", low + high - after, given[0]), ("after", after, given[1])):
            velocity = points @ target.plant.A.T + np.outer(u, target.plant.b)
            true = tangent[:, 0] * velocity[:, 1] - tangent[:, 1] * velocity[:, 0]
            size = np.linalg.norm(tangent, axis=1) * np.linalg.norm(velocity, axis=1)
            for k in np.flatnonzero(np.isfinite(times) & ~(abs(numbers - true) <= tolerance * size)):
                raise Wrong(f"{target.told(values, places[k])} the determinant of the tangent of the curve and the "
                            f"velocity {name} the "
                            f"switching is not {numbers[k]:.4g}: look at the sign and the size of both")
    return "these are the determinants, for sample values"


@judged
def switching_curve(answer, field, state, control, bounds, target, domain, parameters=None, start=None):
    """A branch of the switching curve, one state variable as an expression in the other, over the interval that
    `domain` gives."""
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
    return claim, variable, interval, frozen(field, state, control, bounds, target, parameters, start)


@functools.lru_cache(maxsize=64)
def _crossed(*curve):
    for told, one, other, away in _sides_of(*curve, (1.0,)):
        if one[0].control == other[0].control:
            raise Wrong(f"{told} of your curve the optimal control is the same on both sides")
        if away:
            raise Wrong(f"{told} of your curve the fastest motions leave the curve on both sides: it is no place "
                        f"where they switch")
    return "optimal motions cross the curve, or follow it, and change their control there, at sample points"


@functools.lru_cache(maxsize=64)
def _parting(*curve):
    for told, (one,), (other,), away in _sides_of(*curve, (0.06,)):
        if one.control == other.control or not away:
            raise Wrong(f"{told} of your curve the fastest motions from both sides do not part")
        if not abs(one.time - other.time) <= 0.12 * one.time + 0.01:
            raise Wrong(f"{told} of your curve the fastest times differ on the two sides: {one.time:.4g} and "
                        f"{other.time:.4g}")
    return "on both sides the fastest motions leave the curve, and their times agree on it, at sample points"


@functools.lru_cache(maxsize=64)
def _jumping(*curve):
    for told, one, other, _ in _sides_of(*curve, (0.04, 0.01)):
        jump, left = (abs(a.time - b.time) for a, b in zip(one, other))
        # At the edge of what is in reach the time may jump to infinity, or grow to it steadily: that is no jump.
        if np.isinf(jump) and any(abs(a.time - b.time) > 0.3 for a, b in (one, other) if np.isfinite(a.time + b.time)):
            raise Wrong(f"{told} of your curve the fastest time does not jump: it grows without bound as the curve is "
                        f"approached")
        # What grows like a root, as next to a motion that grazes the target, would fall to the half.
        if not (jump > 0.02 and (left > 0.7 * jump or np.isinf(jump) and np.isinf(left))):
            raise Wrong(f"{told} of your curve the fastest time does not jump: on its two sides it is "
                        f"{one[0].time:.4g} and "
                        f"{other[0].time:.4g}, closer by {one[1].time:.4g} and {other[1].time:.4g}")
    return "the fastest time jumps across the curve, at sample points"


def _sides_of(claim, variable, interval, data, shares):
    """For points of a curve: a text, the optima on one side and on the other at some distances, whether both motions
    move away."""
    truth, state, parameters = sampled_optimum(*data), data[1], dict(data[5])
    beside = BESIDE_DECIMALS if in_decimals(claim) else BESIDE / 2
    index = list(state).index(variable)
    function = real_function([variable, *parameters], [claim])
    for case, values in enumerate(truth.cases):
        ends = [float(sp.sympify(end).subs(dict(zip(parameters, values)))) for end in (interval.inf, interval.sup)]
        places = spread_over(*ends, count=9 if len(truth.cases) == 1 else 5)
        step = 1e-6 * (1 + abs(places))
        (other,), (ahead,) = (function(at, *values) for at in (places, places + step))
        told = "".join(f"for {p} = {v:.4g}, " for p, v in zip(parameters, values))
        for k in np.flatnonzero(~np.isfinite(other + ahead)):
            raise Wrong(f"{told}at {variable} = {places[k]:.4g} your curve is not real")
        slope = (ahead - other) / step
        on = np.column_stack([places, other] if index == 0 else [other, places])
        normal = np.column_stack([-slope, np.ones_like(slope)] if index == 0 else [np.ones_like(slope), -slope])
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        shift = beside * (0.3 + np.linalg.norm(on, axis=1))[:, None]
        moves = [sign * share * shift * normal for sign in (1, -1) for share in shares]
        solved = truth.solve(np.concatenate([on + move for move in moves]), np.full(len(on) * len(moves), case))
        n, m = len(on), len(shares)
        sides = [[solved.take(slice(n * (m * side + k), n * (m * side + k + 1))) for k in range(m)] for side in (0, 1)]
        away = [sign * ((side[0].x @ truth.plant.A.T + np.outer(side[0].control, truth.plant.b)) * normal).sum(axis=1)
                > 0
                for sign, side in zip((1, -1), sides)]
        for k in range(n):
            yield (f"{told}at the point ({on[k][0]:.4g}, {on[k][1]:.4g})",
                   *([lane.take(k) for lane in side] for side in sides),
                   away[0][k] and away[1][k])


@judged
def continuous_time(answer, field, state, control, bounds, target, ends, variable, parameters, start=None):
    """The values of a parameter for which the fastest time is continuous where the target can be reached; borders count
    either way.

    Tried next to the extremals that touch the target: from beyond them it is missed.
    """
    (name, interval), = ((p, i) for p, i in parameters.items() if p != variable)
    claim = coercion.as_condition(answer, [name])
    values = sorted(spread_over(float(interval.inf), float(interval.sup), 8))
    data = (field, state, control, bounds, target, ends, variable, parameters[variable], start, name)
    found = [_jump(float(value), *data) for value in values]
    beside = 0.03 if in_decimals(claim) else 0.016
    tried = list(zip(values, found))
    for low, high, at_low, at_high in zip(values, values[1:], found, found[1:]):
        if (at_low > 0) == (at_high > 0):
            continue
        while high - low > beside / 2:
            middle = (low + high) / 2
            low, high = (middle, high) if (_jump(float(middle), *data) > 0) == (at_low > 0) else (low, middle)
        tried += [(low - beside, at_low), (high + beside, at_high)]
    for value, jump in tried:
        if truth_at(claim, {name: sp.Float(value)}) != (jump == 0):
            raise Wrong(f"for {name} = {value:.4g} the fastest time "
                        + ("jumps across a motion that only touches the target" if jump else
                        "jumps nowhere: it is the same on both sides of all motions that touch the target")
                        + "; your condition says otherwise")
    return "next to the motions that touch the target the fastest time jumps for the other values alone"


@functools.lru_cache(maxsize=256)
def _jumps(value, field, state, control, bounds, target, ends, variable, interval, start, name):
    fixed = {name: sp.Float(value)}
    target, ends, start = target.subs(fixed), [end.subs(fixed)
                                               for end in ends], None if start is None else start.subs(fixed)
    truth = sampled_optimum(*frozen(field, state, control, bounds, [target], {}, start))
    family = TargetFamily(field, state, control, bounds, target, ends, variable, {variable: interval}, start)
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
    return _jumps(value, tuple(field), tuple(state), control, tuple(bounds), target, tuple(map(sp.sympify, ends)),
                  variable, interval,
                  start, name)


@judged
def other_extremals(answer, field, state, control, bounds, target, start=None):
    """The condition on the start under which there is an extremal to the line besides the fastest one; it may cross the
    line before."""
    claim = coercion.as_condition(answer, state)
    lanes, later = _line_extremals(field, state, control, bounds, target, start)
    said = sampled_optimum(*frozen(field, state, control, bounds, target, {},
                                   start)).condition(claim)(lanes.x, lanes.case)
    for k in np.flatnonzero(said != np.isfinite(later)):
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(state, lanes.x[k]))
        raise Wrong(f"from {place} there is " + (f"another extremal, which takes {later[k]:.4g}"
                                                 if np.isfinite(later[k]) else
                    "no other extremal") + f", besides the fastest one of {lanes.time[k]:.4g}")
    return f"it agrees with the extremals from {len(said)} starts"


@judged
def other_extremal_time(answer, field, state, control, bounds, target, start=None):
    """The time that the other extremal of `other_extremals` takes, where there is one."""
    claim = coercion.as_expression(answer, state)
    lanes, later = _line_extremals(field, state, control, bounds, target, start)
    truth = sampled_optimum(*frozen(field, state, control, bounds, target, {}, start))
    said = Law(claim, state, [], truth)(lanes.x, lanes.case)
    tolerance = share(claim, computed=1e-6)
    for k in np.flatnonzero(np.isfinite(later) & ~(abs(said - later) <= tolerance * later)):
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(state, lanes.x[k]))
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        raise Wrong(f"from {place} your expression gives {told}, which is not the time of an extremal slower than the "
                    f"fastest one")
    return "it is the time of the slower extremal, from all sample starts that have one"


def _line_extremals(field, state, control, bounds, target, start):
    """Starts, and the time of the extremal to a line that is next to the fastest one (inf where there is none).

    The costate at the end is p = +-c for the line c.y + d = 0, so F(T) = max p.y over R(T) says it all: an extremal
    ends at T if F reaches the line there, and rises, since its rate is the Hamiltonian; the first of all is the fastest
    one. Starts next to a border of their set are left out.
    """
    truth = sampled_optimum(*frozen(field, state, control, bounds, target, {}, start))
    if "extremals" in truth.kept:
        return truth.kept["extremals"]
    plant, (points, case) = truth.plant, truth._points(1000, seed=7)
    c, d = truth.convex._c[0], truth.convex._d[0]
    times = 60 * (np.arange(0, 1501) / 1500)**1.5
    whole = plant.exponential(times)
    owner, found, doubtful = [], [], np.zeros(len(points), dtype=bool)
    for p, level in ((c, -d), (-c, d)):
        def ahead(T, x, p=p, level=level):
            rows = np.tile(p, (len(T), 1))
            return np.einsum("i,nij,nj->n", p, plant.exponential(T),
                             x) + plant.extreme(rows, T, np.ones(len(T))) - level

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
        turning = ((F[:, 1:-1] < F[:, :-2]) & (F[:, 1:-1] < F[:, 2:]) | (F[:, 1:-1] > F[:, :-2])
                   & (F[:, 1:-1] > F[:, 2:]))
        doubtful |= (turning & (abs(F[:, 1:-1]) < 0.004 * (0.3 + np.linalg.norm(points, axis=1))[:, None])).any(axis=1)
    ends = np.full((len(points), 1 + max(np.bincount(np.concatenate(owner)), default=0)), np.inf)
    rows, column = np.concatenate(owner), np.zeros(len(points), dtype=int)
    for n, T in zip(rows, np.concatenate(found)):
        ends[n, column[n]], column[n] = T, column[n] + 1
    ends = np.sort(ends, axis=1)
    first = ends[:, 0].copy()
    ends[ends <= first[:, None] * (1 + 1e-6) + 1e-6] = np.inf
    keep = ~doubtful & np.isfinite(first) & (first > 0.02)
    truth.kept["extremals"] = Lanes(x=points, case=case, time=first).take(keep), ends.min(axis=1)[keep]
    return truth.kept["extremals"]
