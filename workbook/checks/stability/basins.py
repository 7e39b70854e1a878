"""Basins of attraction estimated by level sets of a Lyapunov function."""

import functools
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract.claims import ConditionOn, Expression
from workbook.checks.contract.direction import directed
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.references.fields import Field
from workbook.checks.stability.lyapunov import numeric, rate_of, unit_directions
from workbook.checks.tools.conditions import (
    Case,
    ReferenceCondition,
    compare,
    decide,
    readings,
)
from workbook.checks.tools.samples import allowed_values, conjunction
from workbook.checks.tools.values import number_at, uncertainty_at
from workbook.checks.tools.wording import point_text, values_text

#: The failure of a level that is too low.
HIGHER = "V proves attraction up to this level, but also up to a higher one"


@judged(Expression("parameters"))
def basin_level(claim, function, field, state, parameters=(), given=()):
    """Check the largest level c that V proves for the basin of attraction.

    The part of {V < c} around zero belongs to the basin; for a larger level V does not prove this.

    Can decide when the level lines of V about zero are closed curves in the plane; with parameters
    at sample values.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.basin_level(sp.Rational(1, 2), (x**2 + y**2)/2, [y, -x + y*(x**2 - 1)], [x, y]).status
    'right'
    >>> checks.basin_level(1, (x**2 + y**2)/2, [y, -x + y*(x**2 - 1)], [x, y]).status
    'wrong'
    """
    directions = unit_directions(len(state))
    for values, level, equilibria, rate, largest in _stable_systems(
        function, field, state, parameters, given
    ):
        number = number_at(claim, values, "your level")
        real = abs(number.imag) <= 1e-9 * abs(number)
        message = (
            f"for {values_text(values)} " if values else ""
        ) + f"your level is {f'{number.real:.4g}' if real else 'not real'}"
        if not real or number.real <= 0:
            raise Wrong(
                f"{message}; V is positive near zero, so the level has to be a positive number"
            )
        low, high = (
            _exit_distances(lambda points, c=c: level(points) < c, directions)
            for c in (0.994 * number.real, 1.008 * number.real)
        )
        failure = _wrong_level(number, low, high, directions, rate, equilibria, level)
        true = None if failure else largest(number.real, directions * low[:, None])
        if true is not None and not agree(
            number, float(true), claim, uncertain=uncertainty_at(claim, values)
        ):
            failure = "V does not prove attraction quite up to it" if number.real > true else HIGHER
        if failure:
            raise Wrong(
                f"{message}: "
                + directed(failure, "it is not the greatest level up to which V proves attraction")
            )
    return (
        "up to this level the derivative of V is nowhere positive and no other equilibrium is "
        "met, and beyond it this ends"
    )


def _wrong_level(number, low, high, directions, rate, equilibria, level):
    """Return what is wrong with a level, from the boundaries just below and above it, or ""."""
    if not np.all(np.isfinite(low)):
        return (
            "the set V < c around zero is unbounded in the direction "
            f"{point_text(directions[np.argmax(~np.isfinite(low))])}"
        )
    obstacle = _obstacle(rate, directions * low[:, None], equilibria, level, 0.994 * number.real)
    if obstacle:
        return f"V does not prove attraction for all of this set: {obstacle}"
    if np.all(np.isfinite(high)) and not _obstacle(
        rate, directions * high[:, None], equilibria, level, 1.008 * number.real
    ):
        return HIGHER
    return ""


@judged(ConditionOn("state", "parameters"))
def basin_estimate(condition, function, field, state, parameters=(), given=()):
    """Check the largest set {V < c} that V proves to belong to the basin of attraction of zero.

    Judged for values of the parameters with an asymptotically stable linearisation: the
    boundary is a level line of V, inside V' <= 0 and no other equilibrium, and a slightly
    higher level breaks one of these. The set may contain the parameters; where V < c has parts
    away from zero, it has to leave them out.

    Can decide when the level lines of V about zero are closed curves in the plane; with parameters
    at sample values.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.basin_estimate(x**2 + y**2 < 1, (x**2 + y**2)/2, [y, -x + y*(x**2 - 1)], [x, y]).status
    'right'
    >>> checks.basin_estimate(x**2 + y**2 < 4, (x**2 + y**2)/2, [y, -x + y*(x**2 - 1)], [x, y]).status
    'wrong'
    """
    directions = unit_directions(len(state))
    for values, level, equilibria, rate, largest in _stable_systems(
        function, field, state, parameters, given
    ):
        claim = condition.subs(values)
        where = f" (for {values_text(values)})" if values else ""
        distances = _boundary_distances(claim, state, directions, where)
        border = directions * distances[:, None]
        heights = level(border)
        if np.ptp(heights) > 0.01 * np.mean(heights):
            raise Wrong(
                f"the boundary is no level line of V: V is {min(heights):.4g} at one point of it and "
                f"{max(heights):.4g} at another{where}"
            )
        height = np.mean(heights)
        obstacle = _obstacle(
            rate, 0.997 * border, equilibria, level, 0.994 * height
        ) or _contained_equilibrium(condition, field, state, values, equilibria)
        if obstacle:
            raise Wrong(f"V does not prove attraction for all of this set: {obstacle}{where}")
        _has_no_holes(claim, state, sp.sympify(function).subs(values), height, border, where)
        true = largest(height, border)
        if true is not None:
            compare(
                claim,
                state,
                _part_around_zero(
                    sp.sympify(function).subs(values), true, state, equilibria, border
                ),
                lambda position, attracted, where=where: (
                    f"your set leaves out the state {values_text(position)}, which V proves to be "
                    f"attracted{where}"
                    if attracted
                    else f"your set holds the state {values_text(position)}; V does not prove that it is "
                    f"attracted{where}"
                ),
            )
        if not _obstacle(rate, 1.004 * border, equilibria, level, 1.008 * height):
            raise Wrong(
                "the set is contained in the basin, but V proves more: "
                f"its derivative is still nowhere positive on a larger level set{where}"
            )
    return (
        "its boundary is a level line of V, the derivative is nowhere positive inside, and no "
        "higher level has this property"
    )


def _largest_level(height, rate, motion, state, equilibria, estimate, border):
    """Return the exact largest level c that V proves, near an estimate; None if it is undecided.

    At this level the set meets an equilibrium, or V' > 0 occurs just above it; below it, neither.
    """
    exact = [
        {x: sp.Rational(Fraction(float(v)).limit_denominator(1000)) for x, v in zip(state, point)}
        for point in equilibria
    ]
    equilibrium_levels = {
        height.subs(point) for point in exact if all(f.subs(point) == 0 for f in motion)
    }
    box = sp.And(
        *(
            sp.Abs(x) <= 2 * sp.Rational(float(end)).limit_denominator(100)
            for x, end in zip(state, np.abs(border).max(axis=0))
        )
    )

    def rises_below(level):
        return decide(
            sp.true,
            state,
            ReferenceCondition((Case(sp.false),), (Case(sp.And(box, height < level, rate > 0)),)),
        )

    simple_levels = {
        sp.Rational(float(estimate)).limit_denominator(q) for q in (1, 2, 4, 8, 12, 60, 1000)
    }
    for level in sorted(equilibrium_levels | simple_levels, key=lambda c: abs(c - estimate)):
        if (
            abs(level - estimate) < estimate / 80
            and rises_below(level) == (True, None)
            and (level in equilibrium_levels or rises_below(level * (1 + sp.Rational(1, 10**9)))[1])
        ):
            return level
    return None


def _part_around_zero(height, level, state, equilibria, border):
    """Return the reference condition for the part of {V < level} around zero.

    Where an equilibrium on its boundary separates it from other parts, the box around it ends there.
    """
    ends = [
        next(
            (
                sp.Rational(Fraction(abs(float(v))).limit_denominator(1000))
                for v in coordinates
                if abs(abs(v) - reach) < reach / 50
            ),
            sp.Rational(51, 50) * sp.Rational(float(reach)),
        )
        for reach, coordinates in zip(
            np.abs(border).max(axis=0), np.reshape(equilibria, (-1, len(state))).T
        )
    ]
    inside = sp.And(*(sp.Abs(x) < end for x, end in zip(state, ends)))
    beyond = sp.Or(*(sp.Abs(x) > end for x, end in zip(state, ends)))
    return ReferenceCondition(
        (Case(sp.And(height < level, inside)),), (Case(sp.Or(height > level, beyond)),)
    )


def _stable_systems(function, field, state, parameters, given):
    """Return rows (values, V, other equilibria, V', exact level near an estimate).

    They belong to sampled parameters at which the linearisation is stable.
    """
    return _sampled_systems(
        sp.sympify(function), tuple(field), tuple(state), tuple(parameters), conjunction(given)
    )


@functools.lru_cache(maxsize=16)
def _sampled_systems(function, field, state, parameters, given):
    systems = []
    for values in allowed_values(parameters, given, 8):
        # Squares, so that equilibria at roots of parameters are rational and can be put into a
        # condition exactly.
        values = {
            p: sp.sign(v) * sp.Rational(sp.ceiling(4 * abs(v)), 4) ** 2 for p, v in values.items()
        }
        flow = Field(field, state, values)
        if max(np.linalg.eigvals(flow.jacobian(np.zeros(len(state)))).real) >= 0:
            continue
        height, motion = function.subs(values), [sp.sympify(f).subs(values) for f in field]
        rate = sum(sp.diff(height, x) * f for x, f in zip(state, motion))
        (points,) = equilibria_of(flow.expressions, state).points(np.zeros((0, 1)))
        equilibria = [point for point in points if np.linalg.norm(point) > 1e-6]
        systems.append(
            (
                values,
                numeric(height, state),
                equilibria,
                rate_of(height, motion, state),
                functools.partial(_largest_level, height, rate, motion, state, equilibria),
            )
        )
        if len(systems) == 2:
            return systems
    if not systems:
        raise RuntimeError("no parameters with a stable linearisation were met")
    return systems


def _boundary_distances(claim, state, directions, where):
    """Return the distance of the boundary along each ray from zero; the set must end there."""
    inside = _membership(claim, state)
    if not np.all(inside(1e-3 * directions)):
        raise Wrong(f"the set does not contain a neighbourhood of zero{where}")
    distances = _exit_distances(inside, directions)
    if not np.all(np.isfinite(distances)):
        raise Wrong(
            "the set is unbounded in the direction "
            f"{point_text(directions[np.argmax(~np.isfinite(distances))])}; "
            f"a level set that proves attraction is bounded{where}"
        )
    for fraction in np.geomspace(1.001, 50, 300):
        beyond = fraction * distances[:, None] * directions
        reentered = inside(beyond)
        if np.any(reentered):
            position = beyond[np.argmax(reentered)]
            raise Wrong(_detached_part_text(point_text(position), where))
    return distances


def _detached_part_text(position, where):
    return (
        f"the set has a part away from zero, at {position} for instance, and motions from there need "
        f"not come to zero{where}"
    )


def _has_no_holes(claim, state, height, level, border, where):
    """Raise `Wrong` for a missing line or point, or an extra part, that no sampled ray meets."""
    shrunk, grown = (
        sp.Rational(factor * level).limit_denominator(10**6) for factor in (0.98, 1.02)
    )
    size = [sp.Rational(float(end)).limit_denominator(10**6) for end in np.abs(border).max(axis=0)]
    inside = sp.And(height < shrunk, *(sp.Abs(x) < end for x, end in zip(state, size)))
    outside = sp.Or(
        height > grown, *(sp.Abs(x) > sp.Rational(51, 50) * end for x, end in zip(state, size))
    )
    claimed, no_cases = readings(claim)[0], (Case(sp.false),)
    _, position = decide(claimed, state, ReferenceCondition(no_cases, (Case(outside),)))
    if position:
        raise Wrong(_detached_part_text(values_text(position[0]), where))
    _, position = decide(claimed, state, ReferenceCondition((Case(inside),), no_cases))
    if position:
        point = np.array([float(x) for x in position[0].values()])
        # Some other part of {V < c} may lie in the box.
        away = np.linalg.norm(border - point, axis=1)
        if np.linalg.norm(point) <= 1.01 * np.linalg.norm(border[np.argmin(away)]):
            raise Wrong(
                f"your set leaves out the state {values_text(position[0])}, where V is smaller than on "
                f"its boundary{where}"
            )


def _exit_distances(inside, directions):
    """Return the distance along each ray at which it first leaves a set, inf where it does not."""
    # A step of 1.2 per cent: less than the gap that a ray beside a saddle passes through.
    distances = np.geomspace(1e-2, 60.0, 740)
    grid = inside((distances[:, None, None] * directions).reshape(-1, directions.shape[1])).reshape(
        len(distances), -1
    )
    first = np.argmin(grid, axis=0)
    outer = distances[first]
    inner = np.where(first > 0, distances[first - 1], 0.0)
    for _ in range(30):
        middle = (inner + outer) / 2
        holds = inside(middle[:, None] * directions)
        inner, outer = np.where(holds, middle, inner), np.where(holds, outer, middle)
    return np.where(np.all(grid, axis=0), np.inf, inner)


def _membership(condition, state):
    """Return a condition as a function of an array of states; False where it is undefined."""
    if condition in (sp.true, sp.false):
        return lambda points: np.full(len(points), bool(condition))
    if isinstance(condition, (sp.And, sp.Or)):
        parts = [_membership(part, state) for part in condition.args]
        join = np.logical_and if isinstance(condition, sp.And) else np.logical_or
        return lambda points: join.reduce([part(points) for part in parts])
    if isinstance(condition, sp.Not):
        negated = _membership(condition.args[0], state)
        return lambda points: ~negated(points)
    if not isinstance(condition, Relational):
        raise Invalid("expected inequalities joined by And, Or and Not")
    # Symbols are the data's own and functions are SymPy's (condition_coercion.as_condition), so the code made
    # is ours.
    try:
        difference = numeric(condition.lhs - condition.rhs, state)
    except NotImplementedError:
        raise Invalid(
            "the condition cannot be evaluated at many states: write it without integrals and sums"
        ) from None
    compare = {
        sp.StrictGreaterThan: np.greater,
        sp.GreaterThan: np.greater_equal,
        sp.StrictLessThan: np.less,
        sp.LessThan: np.less_equal,
        sp.Equality: np.equal,
        sp.Unequality: np.not_equal,
    }[type(condition)]

    def holds(points):
        try:
            values = difference(points)
        except (OverflowError, TypeError, AttributeError):
            raise Invalid(
                "the condition cannot be evaluated at numbers: write it without such functions"
            ) from None
        return compare(values.real, 0) & (np.imag(values) == 0) & np.isfinite(values)

    return holds


def _obstacle(rate, border, equilibria, level, height):
    """Return why V does not prove that the set inside `border` lies in the basin, or ""."""
    points = np.concatenate(
        [fraction * border for fraction in (0.3, 0.6, 0.8, 0.9, 0.95, 0.98, 1.0)]
    )
    rates = rate(points)
    worst = int(np.argmax(rates))
    if rates[worst] > 1e-9 * max(abs(rates)):
        return f"at {point_text(points[worst])} the derivative is {rates[worst]:.3g}"
    radius = 1.01 * max(np.linalg.norm(border, axis=1))
    contained = [
        point
        for point in equilibria
        if level(point[None])[0] < height and np.linalg.norm(point) < radius
    ]
    return f"it contains the equilibrium {point_text(contained[0])}" if contained else ""


def _contained_equilibrium(claim, field, state, values, equilibria):
    """Return a text on an equilibrium other than zero that belongs to the claimed set, or "".

    A boundary in decimals may be rounded to either side of it.
    """
    claims = [reading.subs(values) for reading in readings(claim)]
    for point in equilibria:
        exact = {
            x: sp.Rational(Fraction(float(v)).limit_denominator(1000)) for x, v in zip(state, point)
        }
        if all(sp.sympify(f).subs(values).subs(exact) == 0 for f in field) and all(
            claim.subs(exact) is sp.true for claim in claims
        ):
            return f"it contains the equilibrium {point_text(point)}"
    return ""
