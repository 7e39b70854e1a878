"""Feedback laws for time-optimal control, judged by what they do against an independent optimum.

The optimum is that of `fastest_times`: the plant is x' = Ax + bu with u between two bounds, the
target a point, a segment, a line, or the border of a convex set. A law that does as well is
optimal, and one that does not is not.

How data are written. `system`: a record `workbook.systems.Controlled`, linear in two states.
`target`: the expressions that vanish at the end, [x1, x2] for the origin, [x1**2 + x2**2 - R**2]
for a circle; or a list of number pairs, for the segment between them. `parameters`: a dict from
symbols to SymPy intervals, or finite sets where few cases tell enough. `start`: a condition on the
initial state, such as x1**2 + x2**2 > R**2.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import ConditionOn, Expression, Expressions
from workbook.checks.contract.tolerance import agree, in_decimals, perturbed, relative_tolerance
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.closed_loop import SAME, Law, follow
from workbook.checks.references.optima import reach
from workbook.checks.references.optima.fastest_times import Lanes
from workbook.checks.references.optima.sampled_optimum import (
    BESIDE,
    BESIDE_DECIMALS,
    frozen,
    sampled_optimum,
)
from workbook.checks.references.optima.target_families import TargetFamily
from workbook.checks.tools.conditions import Case, Truth, compare, place_text, readings
from workbook.checks.tools.samples import spread_over
from workbook.checks.tools.searching import bisected
from workbook.checks.tools.values import real_function

#: To what share of its coordinates a switching curve is found.
LOCATED = 1e-4


def of_state(data):
    """The symbols of the state, which an answer may hold."""
    return data["system"].state


@judged(Expression(of_state, "parameters", lambda data: (data["curve"] or ())[:1]))
def time_optimal_law(claim, system, target, parameters=None, start=None, curve=None):
    """A law u(state) that brings every start, from which the target can be reached, there in the
    shortest time.

    `curve` = (symbol, abscissa, ends, variable, interval) lets the law use a switching curve that
    has no elementary equation: the symbol is the second coordinate of this curve where its first
    one is `abscissa`; the rest is as in `switching_points`.
    """
    return _time_optimal(
        claim,
        frozen(system, target, parameters, start),
        curve and (*curve[:2], tuple(map(sp.sympify, curve[2])), *curve[3:]),
    )


@functools.lru_cache(maxsize=64)
def _time_optimal(claim, data, curve):
    """The sentence on a law that is optimal: a law is often judged again beside another answer."""
    truth, control = sampled_optimum(*data), data.control
    if curve:
        parameters = dict(data.parameters)
        ends = _family_of(data._replace(parameters=(*data.parameters, curve[3:])), *curve[2:4])
        curve = curve[0], sp.lambdify([*data.state, *parameters], curve[1], "numpy"), ends
    law, *others = [Law(reading, truth, curve) for reading in (claim, *readings(claim))]
    decimals = in_decimals(claim)
    lanes = truth.lanes(decimals)
    values = law(lanes.x, lanes.case)
    low, high = truth.plant.bounds
    for k in np.flatnonzero(~np.isfinite(values)):
        raise Wrong(f"{truth.told(lanes, k)} your law gives no real number")
    for k in np.flatnonzero((values < low - SAME) | (values > high + SAME)):
        raise Wrong(
            f"{truth.told(lanes, k)} your law gives {control} = {values[k]:.4g}, outside its bounds"
        )
    _judge_on_extremals(others, truth, control)
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
        raise Wrong(
            f"{truth.told(few, 0)} your law gives {control} = {law(few.x, few.case)[0]:.4g}, and "
            "the fastest motion from there begins with another value"
        )
    _judge_next_to_curves(others, truth, control)
    _judge_change(law, truth, lanes, control)
    followed = truth.kept.setdefault("followed", set())
    if (claim, str(curve)) not in followed:
        follow(law, truth, lanes)
        followed.add((claim, str(curve)))
    return f"from {len(lanes.x)} starts, some of them next to the switching curve, it needs the shortest time there is"


def _judge_next_to_curves(laws, truth, control):
    """Raise `Wrong` where all readings of a law differ from the optimum next to a switching curve:
    there it may lose hardly any time."""
    lanes = truth.next_to_curves()
    if lanes is None:
        return
    said = np.array([law(lanes.x, lanes.case) for law in laws])
    differ = np.flatnonzero((abs(said - lanes.control) > SAME).all(axis=0))
    # Next to a barrier a thin target may have been missed by the optimum too.
    if len(differ) and truth.convex.kind == "hull":
        differ = differ[~truth.beside_barrier(lanes.take(differ), far=True)]
    for k in differ[:1]:
        raise Wrong(
            f"{truth.told(lanes, k)} your law gives {control} = {said[0][k]:.4g}, and the fastest "
            "motion from there begins with another value"
        )


def _judge_on_extremals(laws, truth, control):
    """Raise `Wrong` where all readings of a law differ from the control of an extremal, next to the
    target or far out."""
    lanes, _ = truth.extremals() or (None, None)
    if lanes is None:
        return
    said = np.array([law(lanes.x, lanes.case) for law in laws])
    differ = np.flatnonzero(~(abs(said - lanes.control) <= SAME).any(axis=0))
    # Of states that are neither small nor large a student knows best what happens there.
    for k in sorted(differ, key=lambda k: abs(np.log(np.linalg.norm(lanes.x[k]))))[:1]:
        gives = f"{control} = {said[0][k]:.4g}" if np.isfinite(said[0][k]) else "no real number"
        raise Wrong(
            f"{truth.told(lanes, k)} your law gives {gives}, and the fastest motion from there "
            "begins with another value"
        )


def _judge_change(law, truth, lanes, control):
    """Raise `Wrong` for a law that goes over from one bound to the other by steps."""
    said, (low, high) = law(lanes.x, lanes.case), truth.plant.bounds
    ends = (np.flatnonzero(abs(said - bound) < SAME)[:40] for bound in (low, high))
    pairs = np.array(
        [
            (a, b)
            for a, b in itertools.product(*ends)
            if lanes.case[a] == lanes.case[b] and lanes.inside[a] == lanes.inside[b]
        ][::7]
    )
    if not len(pairs):
        return
    case = lanes.case[pairs[:, 0]]
    ends = bisected(
        lambda x, rows: law(x, case[rows]) < low + (high - low) / 4, *lanes.x[pairs.T], 45
    )
    between = [(low + SAME < law(x, case)) & (law(x, case) < high - SAME) for x in ends]
    stepped = between[0] & between[1] & truth.allowed(ends[1], case)
    found = truth.solve(ends[1][stepped], case[stepped])
    for k in np.flatnonzero(np.isfinite(found.time)):
        raise Wrong(
            f"{truth.told(found, k)} your law gives {control} = {law(found.x, found.case)[k]:.4g}, "
            "and the fastest motion from there begins with another value"
        )


@judged(Expression(of_state, "parameters"))
def minimal_time(claim, system, target, parameters=None, start=None):
    """The shortest time to the target as an expression in the initial state, where the target can
    be reached."""
    truth = sampled_optimum(*frozen(system, target, parameters, start))
    lanes = truth.lanes(in_decimals(claim))
    said = Law(claim, truth)(lanes.x, lanes.case)
    tolerance = relative_tolerance(claim, computed=1e-4)
    good = np.isfinite(said) & (abs(said - lanes.time) <= tolerance * lanes.time + 1e-6)
    for k in np.flatnonzero(~good):
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        how = (
            ", which no motion can do"
            if said[k] < lanes.time[k]
            else ", but a motion can be faster"
        )
        raise Wrong(
            f"{truth.told(lanes, k)} your expression gives {told}"
            + (how if np.isfinite(said[k]) else "")
        )
    return f"it is the shortest time from {len(lanes.x)} starts"


@judged(ConditionOn(of_state, "parameters"))
def reachable_initial_states(claim, system, target, parameters=None, start=None):
    """The condition on the initial state under which the target can be reached; the border of the
    set counts either way."""
    truth = sampled_optimum(*frozen(system, target, parameters, start))
    lanes = truth.border(in_decimals(claim))
    said = truth.condition(claim)(lanes.x, lanes.case)
    reached = np.isfinite(lanes.time)
    differs = np.flatnonzero(said != reached)[:12]
    for k in differs[~truth.on_border(lanes.take(differs))] if len(differs) else ():
        raise Wrong(
            f"{truth.told(lanes, k)} the target "
            + (
                "can be reached in a time of " + f"{lanes.time[k]:.4g}"
                if reached[k]
                else "cannot be reached: a line separates it from all states that can be reached, at every time"
            )
            + "; your condition says otherwise"
        )
    return (
        f"it agrees with the reachable sets of {len(said)} starts, many of them close to the border"
    )


@judged
def reached_target_points(answer, system, target, ends, variable, parameters=None, start=None):
    """The points of the target at which optimal motions end: a condition on `variable`, which
    numbers the points `ends`.

    `parameters` gives the interval of `variable` too. The ends of an arc count either way.
    """
    family = _family(system, target, ends, variable, parameters, start)
    arrive, avoid = (Case(part, angles=family.angles) for part in family.reached())
    truth = Truth((arrive,), (avoid,), family.arrives, functools.partial(_arrivals, family))

    def told(place, holds):
        how = (
            "optimal motions end"
            if holds
            else "no admissible motion arrives from the side of the starts"
        )
        return (
            f"for {place_text(place)}, at the point {family.point_text(place)} of the target, "
            f"{how}; your condition says otherwise"
        )

    agreement = compare(answer, [variable, *family.parameters], truth, told)
    return f"optimal motions end there, and no motion can arrive at the rest of the target: {agreement}"


def _family(system, target, ends, variable, domain, start):
    return _family_of(frozen(system, target, domain, start), tuple(map(sp.sympify, ends)), variable)


@functools.lru_cache(maxsize=32)
def _family_of(data, ends, variable):
    return TargetFamily(*data[:5], ends, variable, dict(data.parameters), data.start)


@functools.lru_cache(maxsize=32)
def _arrivals(family, beside=0.002):
    """Places on the target, many of them on both sides of where the arcs end that are reached. No
    answer changes them."""
    found = []
    for values in family.samples():
        places = family.places(values)
        rates = family.rates(places, values)
        changes = [
            family.change(a, b, values)
            for a, b in itertools.pairwise(places)
            if np.sign(family.rates(np.array([a, b]), values)).prod() < 0
        ]
        # Samples at which the rate hardly differs from zero stay undecided; the borders are tried
        # on both sides instead.
        tried = np.concatenate(
            [
                places[abs(rates) > 1e-3 * abs(rates).max()],
                *[[c - beside, c + beside] for c in changes],
            ]
        )
        low, high = family.interval
        symbols = family.variable, *family.parameters
        found += [
            dict(zip(symbols, map(sp.Rational, (place, *values))))
            for place in tried
            if low < place < high and all(abs(place - c) > beside / 2 for c in changes)
        ]
    return found


@judged(Expressions("variable", "parameters", length=2))
def switching_points(claim, system, target, ends, variable, parameters=None, start=None):
    """The switching curve [x1, x2]: the last switching of the optimal motion that ends at the point
    `ends` of the target."""
    target = _family(system, target, ends, variable, parameters, start)
    said = real_function([variable, *target.parameters], claim)
    tolerance = relative_tolerance(*claim, computed=1e-6)
    met = 0
    for values in target.samples():
        places = target.places(values, count=24)
        points, times, _ = target.switchings(places, values)
        given = said(places, *values).T
        for k in np.flatnonzero(np.isfinite(times)):
            met += 1
            if not np.all(np.isfinite(given[k])):
                raise Wrong(f"{target.told(values, places[k])} your point is not real")
            if not np.linalg.norm(given[k] - points[k]) <= tolerance * (
                1 + np.linalg.norm(points[k])
            ):
                raise Wrong(
                    f"{target.told(values, places[k])} the optimal motion switches {times[k]:.4g} "
                    f"before its end, at a distance {np.linalg.norm(given[k] - points[k]):.4g} "
                    f"from your point ({given[k][0]:.4g}, {given[k][1]:.4g})"
                )
    if not met:
        raise RuntimeError("no motion that ends there switches")
    return "the optimal motions to the target change their control there, for sample values"


@judged(Expressions("variable", "parameters", length=2))
def switching_curve_crossing(claim, system, target, ends, variable, parameters=None, start=None):
    """[before, after]: the determinants of (dP/ds, velocity) on the switching curve P(s) with the
    two controls.

    `variable` is the s that numbers the curve by the end points, as in `switching_points`. Equal
    signs: motions cross the curve.
    """
    target = _family(system, target, ends, variable, parameters, start)
    said = real_function([variable, *target.parameters], claim)
    tolerance = relative_tolerance(*claim, computed=1e-5)
    for values in target.samples():
        places = target.places(values, count=12)
        points, times, after = target.switchings(places, values)
        step = 1e-5
        tangent = (
            target.switchings(places + step, values)[0]
            - target.switchings(places - step, values)[0]
        ) / (2 * step)
        low, high = target.plant.bounds
        given = said(places, *values)
        for name, u, numbers in (
            ("before", low + high - after, given[0]),
            ("after", after, given[1]),
        ):
            velocity = points @ target.plant.A.T + np.outer(u, target.plant.b)
            true = tangent[:, 0] * velocity[:, 1] - tangent[:, 1] * velocity[:, 0]
            size = np.linalg.norm(tangent, axis=1) * np.linalg.norm(velocity, axis=1)
            for k in np.flatnonzero(
                np.isfinite(times) & ~(abs(numbers - true) <= tolerance * size)
            ):
                raise Wrong(
                    f"{target.told(values, places[k])} the determinant of the tangent of the curve "
                    f"and the velocity {name} the switching is not {numbers[k]:.4g}: look at the "
                    "sign and the size of both"
                )
    return "these are the determinants, for sample values"


@judged(Expression("domain", "parameters"))
def switching_curve(claim, system, target, domain, parameters=None, start=None):
    """A branch of the switching curve, one state variable as an expression in the other, over the
    interval that `domain` gives."""
    return _crossed(claim, *domain.items(), frozen(system, target, parameters, start))


@judged(Expression("domain", "parameters"))
def dispersal_curve(claim, system, target, domain, parameters=None, start=None):
    """The curve from which two motions are equally fast, written as for `switching_curve`."""
    return _parting(claim, *domain.items(), frozen(system, target, parameters, start))


@judged(Expression("domain", "parameters"))
def barrier(claim, system, target, domain, parameters=None, start=None):
    """The curve across which the fastest time jumps, written as for `switching_curve`."""
    return _jumping(claim, *domain.items(), frozen(system, target, parameters, start))


@functools.lru_cache(maxsize=64)
def _crossed(*curve):
    places = list(_sides_of(*curve, (1.0,)))
    for told, (one,), (other,), away in places:
        if one.control == other.control:
            raise Wrong(f"{told} of your curve the optimal control is the same on both sides")
        if away:
            raise Wrong(
                f"{told} of your curve the fastest motions leave the curve on both sides: it is no "
                "place where they switch"
            )
    _change_on(places, *curve)
    _through_the_target(*curve)
    return "optimal motions cross the curve, or follow it, and change their control there, at sample points"


@functools.lru_cache(maxsize=64)
def _parting(*curve):
    places = list(_sides_of(*curve, (1.0,)))
    for told, (one,), (other,), away in places:
        if one.control == other.control or not away:
            raise Wrong(f"{told} of your curve the fastest motions from both sides do not part")
    for (told, *_), one, other in zip(places, *_change_on(places, *curve)):
        if not abs(one - other) <= 1e-3 * one:
            raise Wrong(
                f"{told} of your curve the fastest times differ on the two sides: {one:.4g} and "
                f"{other:.4g}"
            )
    return "on both sides the fastest motions leave the curve, and their times agree on it, at sample points"


def _through_the_target(claim, domain, data):
    """Raise `Wrong` where a curve on both sides of a target that is a point leaves the places at
    which extremals switch, next to the target or far out."""
    truth, (variable, interval) = sampled_optimum(*data), domain
    given = data.state.index(variable)
    _, lanes = truth.extremals() or (None, None)
    if lanes is None or not all(
        interval.inf < truth.convex.corner(k)[given] < interval.sup for k in set(lanes.case)
    ):
        return
    symbols = [variable, *dict(data.parameters)]
    cases = np.array(truth.cases, dtype=float).reshape(len(truth.cases), -1)[lanes.case]
    numbers, true = (lanes.x[:, given], *cases.T), lanes.x[:, 1 - given]
    said, *sides = (
        real_function(symbols, [one])(*numbers)[0]
        for one in (claim, *(side for pair in perturbed(claim) or () for (side,) in pair))
    )
    open_ = sum(
        np.fmax(abs(one - said), abs(other - said)) for one, other in zip(sides[::2], sides[1::2])
    )
    for k in np.flatnonzero(~(abs(said - true) <= LOCATED * abs(true) + open_))[:1]:
        raise Wrong(
            f"for {variable} = {numbers[0][k]:.4g} the control of the fastest motions does not "
            "change on your curve, but beside it"
        )


def _change_on(places, claim, domain, data):
    """Raise `Wrong` where the control of the fastest motions changes beside a curve and not on it;
    else their times just before this change and behind it."""
    truth, given = sampled_optimum(*data), 1 - data.state.index(domain[0])
    first, last = (np.array([place[side][0].x for place in places]) for side in (1, 2))
    control, case = (
        np.array([getattr(one, name) for _, (one,), *_ in places]) for name in ("control", "case")
    )
    on, across = (first + last) / 2, (first - last) / np.linalg.norm(first - last, axis=1)[:, None]
    first, last = bisected(
        lambda x, rows: truth.solve(x, case[rows]).control == control[rows], first, last, 24
    )
    off = (((first + last) / 2 - on) * across).sum(axis=1) / across[:, given]
    right = agree(on[:, given], on[:, given] + off, claim, np.linalg.norm(on, axis=1), LOCATED)
    for k in np.flatnonzero(~right):
        raise Wrong(
            f"{places[k][0]} of your curve the control of the fastest motions does not change on "
            "it, but beside it"
        )
    return [truth.solve(x, case).time for x in (first, last)]


@functools.lru_cache(maxsize=64)
def _jumping(*curve):
    for told, one, other, _ in _sides_of(*curve, (0.04, 0.01)):
        jump, left = (abs(a.time - b.time) for a, b in zip(one, other))
        # At the edge of what is in reach the time may jump to infinity, or grow to it steadily:
        # that is no jump.
        if np.isinf(jump) and any(
            abs(a.time - b.time) > 0.3 for a, b in (one, other) if np.isfinite(a.time + b.time)
        ):
            raise Wrong(
                f"{told} of your curve the fastest time does not jump: it grows without bound as "
                "the curve is approached"
            )
        # What grows like a root, as next to a motion that grazes the target, would fall to the
        # half.
        if not (jump > 0.02 and (left > 0.7 * jump or (np.isinf(jump) and np.isinf(left)))):
            raise Wrong(
                f"{told} of your curve the fastest time does not jump: on its two sides it is "
                f"{one[0].time:.4g} and "
                f"{other[0].time:.4g}, closer to it {one[1].time:.4g} and {other[1].time:.4g}"
            )
    return "the fastest time jumps across the curve, at sample points"


def _sides_of(claim, domain, data, shares):
    """For points of a curve: a text, the optima on one side and on the other at some distances,
    whether both motions move away."""
    truth, parameters, (variable, interval) = sampled_optimum(*data), dict(data.parameters), domain
    beside = BESIDE_DECIMALS if in_decimals(claim) else BESIDE / 2
    index = data.state.index(variable)
    function = real_function([variable, *parameters], [claim])
    for case, values in enumerate(truth.cases):
        ends = [
            float(sp.sympify(end).subs(dict(zip(parameters, values))))
            for end in (interval.inf, interval.sup)
        ]
        places = spread_over(*ends, count=9 if len(truth.cases) == 1 else 5)
        step = 1e-6 * (1 + abs(places))
        (other,), (ahead,) = (function(at, *values) for at in (places, places + step))
        told = "".join(f"for {p} = {v:.4g}, " for p, v in zip(parameters, values))
        for k in np.flatnonzero(~np.isfinite(other + ahead)):
            raise Wrong(f"{told}at {variable} = {places[k]:.4g} your curve is not real")
        slope = (ahead - other) / step
        on = np.column_stack([places, other] if index == 0 else [other, places])
        normal = np.column_stack(
            [-slope, np.ones_like(slope)] if index == 0 else [np.ones_like(slope), -slope]
        )
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        shift = beside * (0.3 + np.linalg.norm(on, axis=1))[:, None]
        moves = [sign * share * shift * normal for sign in (1, -1) for share in shares]
        solved = truth.solve(
            np.concatenate([on + move for move in moves]), np.full(len(on) * len(moves), case)
        )
        n, m = len(on), len(shares)
        sides = [
            [solved.take(slice(n * (m * side + k), n * (m * side + k + 1))) for k in range(m)]
            for side in (0, 1)
        ]
        away = [
            sign
            * (
                (side[0].x @ truth.plant.A.T + np.outer(side[0].control, truth.plant.b)) * normal
            ).sum(axis=1)
            > 0
            for sign, side in zip((1, -1), sides)
        ]
        for k in range(n):
            yield (
                f"{told}at the point ({on[k][0]:.4g}, {on[k][1]:.4g})",
                *([lane.take(k) for lane in side] for side in sides),
                away[0][k] and away[1][k],
            )


@judged
def minimal_time_continuous(answer, system, target, ends, variable, parameters, start=None):
    """The values of a parameter for which the fastest time is continuous where the target can be
    reached; borders count either way.

    It jumps where a motion touches the target from the side of the starts while no control could
    bring it closer: from beyond this motion the target is missed.
    """
    ((name, interval),) = ((p, i) for p, i in parameters.items() if p != variable)
    data, ends = frozen(system, target, parameters, start), tuple(map(sp.sympify, ends))
    jump = functools.partial(_jump, data=data, ends=ends, variable=variable, name=name)
    touched, almost = reach.touching(
        *data[:4], _family_of(data, ends, variable).side * data.target[0]
    )
    truth = Truth(
        (Case(sp.And(interval.as_relational(name), sp.Not(almost)), data.state, every=True),),
        (Case(sp.And(interval.as_relational(name), touched), data.state),),
        lambda place: jump(float(place[name])) == 0,
        lambda: _beside_changes(jump, name, interval),
    )
    agreement = compare(
        answer,
        [name],
        truth,
        lambda place, holds: (
            f"for {place_text(place)} the fastest time "
            + (
                "jumps nowhere: it is the same on both sides of all motions that touch the target"
                if holds
                else "jumps across a motion that only touches the target"
            )
            + "; your condition says otherwise"
        ),
    )
    return f"next to the motions that touch the target the fastest time jumps for the other values alone: {agreement}"


def _beside_changes(jump, name, interval, beside=0.03):
    """Values of a parameter, some of them on both sides of where the fastest time begins to
    jump."""
    values = [
        float(value) for value in sorted(spread_over(float(interval.inf), float(interval.sup), 8))
    ]
    for low, high in itertools.pairwise(values):
        yield {name: sp.Rational(low)}
        if (jump(low) > 0) == (jump(high) > 0):
            continue
        first = jump(low) > 0
        while high - low > beside / 4:
            middle = (low + high) / 2
            low, high = (middle, high) if (jump(middle) > 0) == first else (low, middle)
        yield from ({name: sp.Rational(value)} for value in (low - beside, high + beside))
    yield {name: sp.Rational(values[-1])}


@functools.lru_cache(maxsize=256)
def _jump(value, data, ends, variable, name):
    """By how much the fastest time jumps next to the motions that touch the target, for a value of
    a parameter."""
    fixed = {name: sp.Float(value)}
    data = data._replace(
        target=tuple(part.subs(fixed) for part in data.target),
        start=None if data.start is None else data.start.subs(fixed),
    )
    truth = sampled_optimum(*data._replace(parameters=()))
    data = data._replace(parameters=tuple(pair for pair in data.parameters if pair[0] == variable))
    family = _family_of(data, tuple(end.subs(fixed) for end in ends), variable)
    places = family.places((), count=361)
    rates, jump = family.rates(places, ()), 0.0
    for a, b in zip(
        places[np.append(rates[:-1] * rates[1:] < 0, False)], places[1:][rates[:-1] * rates[1:] < 0]
    ):
        place = np.array([family.change(a, b, ())])
        x, u = family.before(place, (), 0.2)
        speed = truth.plant.A @ x[0] + truth.plant.b * u[0]
        normal = np.array([-speed[1], speed[0]]) / np.linalg.norm(speed)
        sides = truth.solve(x + np.outer((2e-4, -2e-4), normal), np.zeros(2, dtype=int)).time
        if np.isfinite(sides).all():
            jump = max(jump, abs(sides[0] - sides[1]))
    return jump if jump > 0.05 else 0.0


@judged
def other_extremal_exists(answer, system, target, start=None):
    """The condition on the start under which there is an extremal to the line besides the fastest
    one; it may cross the line before."""
    truth = _second_extremal(system, target, start)
    agreement = compare(
        answer,
        system.state,
        truth,
        lambda place, holds: (
            f"from {place_text(place)} there is {'another' if holds else 'no other'} extremal "
            "besides the fastest one"
        ),
    )
    return f"there is another extremal from these starts and from no others: {agreement}"


def _second_extremal(system, target, start):
    """From which starts off the line there are two extremals: decided where the controls on them do
    not switch."""
    state, control, bounds = system.state, system.control, system.bounds
    line, zero = sp.sympify(target[0]), dict.fromkeys([*state, control], 0)
    plant = sp.Matrix([sp.sympify(f) for f in system.field])
    first, second = (sp.Dummy(name, real=True) for name in ("T1", "T2"))
    beyond = (
        reach.beyond_line(
            plant.jacobian(state),
            plant.diff(control),
            list(map(sp.sympify, bounds)),
            state,
            line,
            first,
        )
        if not any(plant.subs(zero))
        else None
    )
    if beyond is None:
        lanes, later = _line_extremals(sampled_optimum(*frozen(system, target, {}, start)))
        found = {tuple(map(sp.Rational, x)): np.isfinite(T) for x, T in zip(lanes.x, later)}
        return Truth(
            at=lambda place: found[tuple(place.values())],
            points=lambda: (dict(zip(state, x)) for x in found),
        )

    def ends(time, steepness):
        """An extremal ends at the time: it crosses the line, or touches it, which counts either
        way."""
        return sp.Or(
            *(
                sp.And(sp.Eq(F.subs(first, time), 0), steepness(F.diff(first).subs(first, time), 0))
                for F in beyond
            )
        )

    def two(steepness):
        return sp.And(0 < first, first < second, ends(first, steepness), ends(second, steepness))

    off = sp.And(sp.Ne(line, 0), sp.true if start is None else start)

    def at(place):
        times = {T for F in beyond for T in sp.Poly(F.subs(place), first).real_roots() if T > 0}
        crossed, met = (
            sum(bool(ends(T, steepness).subs(place)) for T in times) >= 2
            for steepness in (sp.Gt, sp.Ge)
        )
        return crossed if crossed == met else None

    return Truth(
        (Case(sp.And(off, two(sp.Gt)), (first, second)),),
        (Case(sp.And(off, sp.Not(two(sp.Ge))), (first, second), every=True),),
        at,
    )


@judged(Expression(of_state))
def other_extremal_time(claim, system, target, start=None):
    """The time that the other extremal of `other_extremal_exists` takes, where there is one."""
    truth = sampled_optimum(*frozen(system, target, {}, start))
    lanes, later = _line_extremals(truth)
    said = Law(claim, truth)(lanes.x, lanes.case)
    tolerance = relative_tolerance(claim, computed=1e-6)
    for k in np.flatnonzero(np.isfinite(later) & ~(abs(said - later) <= tolerance * later)):
        place = ", ".join(f"{s} = {v:.4g}" for s, v in zip(system.state, lanes.x[k]))
        told = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        raise Wrong(
            f"from {place} your expression gives {told}, which is not the time of an extremal "
            "slower than the fastest one"
        )
    return "it is the time of the slower extremal, from all sample starts that have one"


def _line_extremals(truth):
    """Starts, and the time of the extremal to a line that is next to the fastest one (inf where
    there is none).

    The costate at the end is p = +-c for the line c.y + d = 0, so F(T) = max p.y over R(T) says it
    all: an extremal ends at T if F reaches the line there, and rises, since its rate is the
    Hamiltonian; the first of all is the fastest one. Starts next to a border of their set are left
    out.
    """
    if "extremals" in truth.kept:
        return truth.kept["extremals"]
    plant, (points, case) = truth.plant, truth._points(1000, seed=7)
    c, d = truth.convex._c[0], truth.convex._d[0]
    times = 60 * (np.arange(0, 1501) / 1500) ** 1.5
    whole = plant.exponential(times)
    owner, found, doubtful = [], [], np.zeros(len(points), dtype=bool)
    for p, level in ((c, -d), (-c, d)):

        def ahead(T, x, p=p, level=level):
            rows = np.tile(p, (len(T), 1))
            return (
                np.einsum("i,nij,nj->n", p, plant.exponential(T), x)
                + plant.extreme(rows, T, np.ones(len(T)))
                - level
            )

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
        turning = (F[:, 1:-1] < F[:, :-2]) & (F[:, 1:-1] < F[:, 2:]) | (F[:, 1:-1] > F[:, :-2]) & (
            F[:, 1:-1] > F[:, 2:]
        )
        doubtful |= (
            turning & (abs(F[:, 1:-1]) < 0.004 * (0.3 + np.linalg.norm(points, axis=1))[:, None])
        ).any(axis=1)
    ends = np.full((len(points), 1 + max(np.bincount(np.concatenate(owner)), default=0)), np.inf)
    rows, column = np.concatenate(owner), np.zeros(len(points), dtype=int)
    for n, T in zip(rows, np.concatenate(found)):
        ends[n, column[n]], column[n] = T, column[n] + 1
    ends = np.sort(ends, axis=1)
    first = ends[:, 0].copy()
    ends[ends <= first[:, None] * (1 + 1e-6) + 1e-6] = np.inf
    keep = ~doubtful & np.isfinite(first) & (first > 0.02)
    truth.kept["extremals"] = (
        Lanes(x=points, case=case, time=first).take(keep),
        ends.min(axis=1)[keep],
    )
    return truth.kept["extremals"]
