"""Points of the target of a time-optimal problem, and the last switchings before them.

The points `ends` are numbered by a `variable`; the other data are those of `syntheses`.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expressions
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.synthesis_units import (
    determinant_units,
    in_natural_units,
    state_units,
)
from workbook.checks.references.optima import reach
from workbook.checks.references.optima.sampled_optimum import sampled_optimum, synthesis_data
from workbook.checks.references.optima.target_families import TargetFamily
from workbook.checks.tools.conditions import Case, ReferenceCondition, compare
from workbook.checks.tools.domains import values_inside
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import left_open
from workbook.checks.tools.wording import NO_NUMBER, value_text, values_text


@judged
@in_natural_units()
def reached_target_points(answer, system, target, ends, variable, parameters=None, start=None):
    """Check the points of the target at which optimal motions end.

    The answer is a condition on `variable`, which numbers the points `ends`.

    `parameters` gives the interval of `variable` too. The ends of an arc count either way.

    Can decide when the system is linear in two states and the target is a line or a smooth convex
    curve; for all points where the condition is polynomial.

    Examples
    --------
    >>> from workbook.systems import Controlled
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> cart = Controlled({x: v, v: u}, {u: (-1, 1)})
    >>> checks.reached_target_points(v < 1, cart, [x - v], [v, v], v, {}, x > v).status
    'right'
    >>> checks.reached_target_points(v > 1, cart, [x - v], [v, v], v, {}, x > v).status
    'wrong'
    """
    family = _family(system, target, ends, variable, parameters, start)
    arrive, avoid = (Case(part, angles=family.angles) for part in family.reached())
    reference = ReferenceCondition(
        (arrive,), (avoid,), family.arrives, functools.partial(_arrivals, family)
    )

    def message(point, holds):
        statement = (
            "optimal motions end"
            if holds
            else "no admissible motion arrives from the side of the initial states"
        )
        return (
            f"for {values_text(point)}, at the point {family.point_text(point)} of the target, "
            f"{statement}; your condition gives the opposite"
        )

    agreement = compare(answer, [variable, *family.parameters], reference, message)
    return f"optimal motions end there, and no motion can arrive at the rest of the target: {agreement}"


def _family(system, target, ends, variable, domain, start):
    return family_of(
        synthesis_data(system, target, domain, start), tuple(map(sp.sympify, ends)), variable
    )


@functools.lru_cache(maxsize=32)
def family_of(data, ends, variable):
    return TargetFamily(*data[:5], ends, variable, dict(data.parameters), data.start)


@functools.lru_cache(maxsize=32)
def _arrivals(family, offset=0.002):
    """Return points of the target, many of them on both sides of the ends of reached arcs.

    They do not depend on the answer.
    """
    points = []
    for values in family.samples():
        positions = family.arguments()
        rates = family.rates(positions, values)
        changes = [
            family.change(a, b, values)
            for a, b in itertools.pairwise(positions)
            if np.sign(family.rates(np.array([a, b]), values)).prod() < 0
        ]
        # Samples at which the rate is close to zero stay undecided; points on both sides of the
        # borders replace them.
        candidates = np.concatenate(
            [
                positions[abs(rates) > 1e-3 * abs(rates).max()],
                *[[c - offset, c + offset] for c in changes],
            ]
        )
        low, high = family.interval
        symbols = family.variable, *family.parameters
        points += [
            dict(zip(symbols, map(sp.Rational, (point, *values))))
            for point in candidates
            if low < point < high and all(abs(point - c) > offset / 2 for c in changes)
        ]
    return points


@judged(Expressions("variable", "parameters", length=2))
@in_natural_units(state_units)
def switching_points(claim, system, target, ends, variable, parameters=None, start=None):
    """Check the switching curve [x1, x2] by the end points of the optimal motions.

    The point is the last switching of the optimal motion that ends at the point `ends` of the
    target.
    """
    target = _family(system, target, ends, variable, parameters, start)
    symbols, count = [variable, *target.parameters], 0
    claimed = real_function(symbols, claim)
    for values in target.samples():
        positions = target.arguments(count=24)
        points, times, _ = target.switchings(positions, values)
        claimed_points = claimed(positions, *values).T
        uncertainty = left_open(
            claim, lambda parts, at=(positions, *values): real_function(symbols, parts)(*at)
        )
        uncertainty = np.linalg.norm(np.broadcast_to(uncertainty, claimed_points.T.shape), axis=0)
        allowed = 1e-6 * (1 + np.linalg.norm(points, axis=1)) + uncertainty
        for k in np.flatnonzero(np.isfinite(times)):
            count += 1
            if not np.all(np.isfinite(claimed_points[k])):
                raise Wrong(
                    f"{target.values_text(values, positions[k])} a coordinate of your point is {NO_NUMBER}"
                )
            if not np.linalg.norm(claimed_points[k] - points[k]) <= allowed[k]:
                raise Wrong(
                    f"{target.values_text(values, positions[k])} the optimal motion does not switch "
                    f"at your point ({claimed_points[k][0]:.4g}, {claimed_points[k][1]:.4g})"
                )
    if not count:
        raise RuntimeError("no motion that ends there switches")
    return "the optimal motions to the target change their control there, for sample values"


@judged(Expressions("variable", "parameters", length=2))
@in_natural_units(determinant_units)
def switching_curve_crossing(claim, system, target, ends, variable, parameters=None, start=None):
    """Check the determinants of (dP/ds, velocity) on the switching curve P(s), [before, after].

    The velocities are those with the two controls.

    `variable` is the s that numbers the curve by the end points, as in `switching_points`.
    Equal signs: motions cross the curve.
    """
    target = _family(system, target, ends, variable, parameters, start)
    symbols = [variable, *target.parameters]
    claimed = real_function(symbols, claim)
    for values in target.samples():
        positions = target.arguments(count=12)
        points, times, after = target.switchings(positions, values)
        step = 1e-5
        tangent = (
            target.switchings(positions + step, values)[0]
            - target.switchings(positions - step, values)[0]
        ) / (2 * step)
        low, high = target.plant.bounds
        claimed_determinants = claimed(positions, *values)
        uncertainties = left_open(
            claim, lambda parts, at=(positions, *values): real_function(symbols, parts)(*at)
        )
        for name, u, numbers, uncertainty in zip(
            ("before", "after"),
            (low + high - after, after),
            claimed_determinants,
            np.broadcast_to(uncertainties, claimed_determinants.shape),
        ):
            velocity = points @ target.plant.A.T + np.outer(u, target.plant.b)
            true = tangent[:, 0] * velocity[:, 1] - tangent[:, 1] * velocity[:, 0]
            size = np.linalg.norm(tangent, axis=1) * np.linalg.norm(velocity, axis=1)
            for k in np.flatnonzero(
                np.isfinite(times) & ~(abs(numbers - true) <= 1e-5 * size + uncertainty)
            ):
                raise Wrong(
                    f"{target.values_text(values, positions[k])} your determinant of the tangent of "
                    f"the curve and the velocity {name} the switching is {value_text(numbers[k])}; "
                    "look at the sign and the size of both"
                )
    return "these are the determinants, for sample values"


@judged
@in_natural_units()
def minimal_time_continuous(answer, system, target, ends, variable, parameters, start=None):
    """Check the values of a parameter for which the fastest time is continuous.

    It is continuous on the states from which the target can be reached; borders count either way.

    The time jumps where a motion touches the target from the side of the initial states while no
    control brings it closer: motions beyond this one miss the target.
    """
    ((name, interval),) = ((p, i) for p, i in parameters.items() if p != variable)
    data, ends = synthesis_data(system, target, parameters, start), tuple(map(sp.sympify, ends))
    jump = functools.partial(_jump, data=data, ends=ends, variable=variable, name=name)
    touched, almost = reach.touching(
        *data[:4], family_of(data, ends, variable).side * data.target[0]
    )
    reference = ReferenceCondition(
        (Case(sp.And(interval.as_relational(name), sp.Not(almost)), data.state, every=True),),
        (Case(sp.And(interval.as_relational(name), touched), data.state),),
        lambda point: jump(float(point[name])) == 0,
        lambda: _beside_changes(jump, name, interval),
    )
    agreement = compare(
        answer,
        [name],
        reference,
        lambda point, holds: (
            f"for {values_text(point)} the fastest time "
            + (
                "jumps nowhere: it is the same on both sides of all motions that touch the target"
                if holds
                else "jumps across a motion that only touches the target"
            )
            + "; your condition gives the opposite"
        ),
    )
    return f"next to the motions that touch the target the fastest time jumps for the other values alone: {agreement}"


def _beside_changes(jump, name, interval, offset=0.03):
    """Yield values of a parameter, some of them on both sides of where a jump appears."""
    values = [
        float(value) for value in sorted(values_inside(float(interval.inf), float(interval.sup), 8))
    ]
    for low, high in itertools.pairwise(values):
        yield {name: sp.Rational(low)}
        if (jump(low) > 0) == (jump(high) > 0):
            continue
        first = jump(low) > 0
        while high - low > offset / 4:
            middle = (low + high) / 2
            low, high = (middle, high) if (jump(middle) > 0) == first else (low, middle)
        yield from ({name: sp.Rational(value)} for value in (low - offset, high + offset))
    yield {name: sp.Rational(values[-1])}


@functools.lru_cache(maxsize=256)
def _jump(value, data, ends, variable, name):
    """Return the jump of the fastest time across motions that touch the target.

    `value` is that of the parameter `name`.
    """
    fixed = {name: sp.Float(value)}
    data = data._replace(
        target=tuple(part.subs(fixed) for part in data.target),
        start=None if data.start is None else data.start.subs(fixed),
    )
    reference = sampled_optimum(*data._replace(parameters=()))
    data = data._replace(parameters=tuple(pair for pair in data.parameters if pair[0] == variable))
    family = family_of(data, tuple(end.subs(fixed) for end in ends), variable)
    positions = family.arguments(count=361)
    rates, jump = family.rates(positions, ()), 0.0
    for a, b in zip(
        positions[np.append(rates[:-1] * rates[1:] < 0, False)],
        positions[1:][rates[:-1] * rates[1:] < 0],
    ):
        point = np.array([family.change(a, b, ())])
        x, u = family.before(point, (), 0.2)
        speed = reference.plant.A @ x[0] + reference.plant.b * u[0]
        normal = np.array([-speed[1], speed[0]]) / np.linalg.norm(speed)
        sides = reference.solve(x + np.outer((2e-4, -2e-4), normal), np.zeros(2, dtype=int)).time
        if np.isfinite(sides).all():
            jump = max(jump, abs(sides[0] - sides[1]))
    return jump if jump > 0.05 else 0.0
