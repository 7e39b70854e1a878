"""Lyapunov functions: the derivative along the motions, where it vanishes, what stability and what
basin it proves."""

import functools
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import ConditionOn, Expression
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.fields import Field
from workbook.checks.tools.conditions import (
    Case,
    Condition,
    Truth,
    compare,
    decide,
    exactly,
    on_borders,
    place_text,
    readings,
)
from workbook.checks.tools.samples import allowed_values, in_every_case, joined, sample_values
from workbook.checks.tools.values import number_at, uncertain_at
from workbook.checks.tools.wording import point_text, values_text


@judged(Expression("state", "parameters"))
def lyapunov_derivative(claim, function, field, state, parameters=()):
    """The derivative of V along the motions of x' = f(x) (Definition 1.4), as an expression in the
    state."""
    random = np.random.default_rng(4)
    for values in in_every_case(sample_values(parameters), claim):
        flow, level = Field(field, state, values), Field([function], state, values)
        for at in in_every_case(
            [dict(zip(state, random.normal(size=len(state)))) for _ in range(4)],
            claim.xreplace(values),
        ):
            point = np.array(list(at.values()))
            true = level.derivative(point, flow(point))[0]
            said = number_at(claim, values | dict(zip(state, point)))
            # The size of the terms of grad V . f, not of their sum, sets the scale: the sum may
            # cancel.
            size = abs(level.derivative(point, np.ones(len(state)))[0]) * np.linalg.norm(
                flow(point)
            ) + abs(true)
            if not abs(said - true) <= 1e-9 * size:
                where = ", ".join(
                    f"{s} = {v:.3g}"
                    for s, v in [*zip(state, point), *((p, float(v)) for p, v in values.items())]
                )
                raise Wrong(
                    f"at {where} the function changes along the motion at the rate {true:.4g}; "
                    f"your expression gives {said.real:.4g}"
                )
    return "it is the rate at which the function changes along the motions, at random states"


@judged
def vanishing_set(answer, function, field, state, parameters=()):
    """The set of states where the derivative of V along the motions is zero, for parameters that
    are not zero."""
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    (sample,) = sample_values(parameters, count=1) if parameters else ({},)
    given = sp.And(*(sp.Ne(p, 0) for p in parameters))
    # A factor that is not zero may stay in the equation.
    kept = [
        p for p in parameters if p.name in {s.name for s in getattr(answer, "free_symbols", ())}
    ]
    truth = exactly(
        sp.Eq(rate, 0),
        given,
        tuple(p for p in parameters if p not in kept),
        lambda values: sp.simplify(rate.subs(values).subs(sample)) == 0,
    )

    def told(values, holds):
        return (
            f"at {place_text(values)} the derivative is {'zero' if holds else 'not zero'}, and "
            f"your set {'does not hold' if holds else 'holds'} this state"
        )

    agreement = compare(answer, [*state, *kept], truth, told)
    return f"the derivative is zero at the states of this set and at no others: {agreement}"


@judged
def rate_on_vanishing_set(answer, function, field, state, parameters=()):
    """The rate of the last state variable where V' vanishes: what takes a motion out of this set
    (Theorem 1.5).

    Judged at states of the set alone, so terms that vanish on it may stay or go.
    """
    symbols = [*state, *parameters]
    claim, true = coercion.as_expression(answer, symbols), sp.sympify(field[-1])
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    zero = Condition(sp.And(sp.Eq(rate, 0), *(sp.Ne(p, 0) for p in parameters)), symbols)

    def at(values):
        return True if zero.holds(values.values()) else None

    def told(values, holds):
        said = number_at(claim, values)
        return (
            f"at {place_text(values)} the derivative of V is zero, and {state[-1]} changes there "
            f"at the rate {float(true.subs(values)):.4g}; your expression gives {said.real:.4g}"
        )

    same = Truth((Case(zero.condition),), (Case(sp.false),), at, lambda: on_borders(zero, symbols))
    agreement = compare(sp.Eq(claim, true), symbols, same, told)
    return f"it is this rate at the states where the derivative vanishes: {agreement}"


@judged
def asymptotic_stability_by_lyapunov(answer, function, field, state, parameters):
    """The parameters for which V proves asymptotic stability of zero by Theorem 1.5.

    That is: V > 0 and V' <= 0 near zero, and V' is not identically zero (that no motion stays where
    it vanishes is for the author of the problem to know). Values that the assumptions of a
    parameter exclude are left alone.
    """
    circle = 0.1 * _directions(len(state))
    level, rate = _numeric(function, state, parameters), _rate(function, field, state, parameters)

    def at(values):
        heights, rates = level(circle, values.values()), rate(circle, values.values())
        return bool(min(heights) > 0 and max(rates) <= 1e-12 and min(rates) < -1e-12)

    def told(values, holds):
        rates = rate(circle, values.values())
        return (
            f"for {place_text(values)} the derivative of V on the circle of radius 0.1 lies "
            f"between {min(rates):.3g} and {max(rates):.3g}, which "
            f"{'proves' if holds else 'does not prove'} asymptotic stability"
        )

    near = sum(x**2 for x in state) <= sp.Rational(1, 100)
    truth = Truth(*_proved(function, field, state, near), at)
    agreement = compare(answer, parameters, truth, told)
    return f"there the derivative is nowhere positive near zero and not identically zero, and only there: {agreement}"


@judged
def global_stability_by_lyapunov(answer, function, field, state, parameters, given=()):
    """The values of `parameters` for which V proves asymptotic stability of zero in the large.

    That is: V > 0 grows without bound in every direction, and V' <= 0 everywhere, but not
    identically (that no motion stays where it vanishes is for the author of the problem to know).
    Other symbols get values that satisfy `given`.
    """
    others = set().union(*(sp.sympify(f).free_symbols for f in [*field, function])) - {
        *state,
        *parameters,
    }
    (sample,) = allowed_values(sorted(others, key=str), given, 1)
    field, function = [sp.sympify(f).subs(sample) for f in field], sp.sympify(function).subs(sample)
    radii = np.geomspace(1e-2, 1e4, 41)
    points = (radii[:, None, None] * _directions(len(state), 60)).reshape(-1, len(state))
    level, rate = _numeric(function, state, parameters), _rate(function, field, state, parameters)

    def reason(values):
        """Why V proves nothing in the large, or nothing."""
        lowest = level(points, values.values()).reshape(len(radii), -1).min(axis=1)
        rates = rate(points, values.values())
        if min(lowest) <= 0 or np.any(np.diff(lowest) <= 0):
            worst = int(np.argmax((lowest <= 0) | (np.diff(lowest, prepend=0) <= 0)))
            return (
                "V does not grow in all directions: "
                f"on the circle of radius {radii[worst]:.3g} its least value is {lowest[worst]:.3g}"
            )
        if max(rates) > 1e-12 * max(abs(rates)) or min(rates) == 0:
            return f"the derivative of V takes values between {min(rates):.3g} and {max(rates):.3g}"
        return ""

    def at(values):
        # Closer to zero the far ends of V lie beyond the states that are looked at.
        return (
            None if 0 < max(abs(float(x)) for x in values.values()) < 1e-6 else not reason(values)
        )

    def told(values, holds):
        why = (
            ""
            if holds
            else reason(values) or "V does not grow, or its derivative is positive, far from zero"
        )
        return f"for {place_text(values)} " + (
            f"{why}, which proves nothing in the large"
            if why
            else (
                "V grows without bound in every direction and its derivative is nowhere positive: "
                "it proves stability in the large"
            )
        )

    grows = sum(x * sp.diff(function, x) for x in state) > 0
    truth = Truth(*_proved(function, field, state, sp.true, grows), at)
    agreement = compare(answer, parameters, truth, told)
    return f"there V grows in every direction and its derivative is nowhere positive, and only there: {agreement}"


def _proved(function, field, state, where, besides=sp.true):
    """The cases in which V proves stability or does not: V > 0, V' <= 0 and `besides` hold at all
    states but zero `where` it is asked, and V' is not identically zero."""
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    if not (rate.is_polynomial(*state) and sp.sympify(function).is_polynomial(*state)):
        return (), ()
    nothing = sp.And(*(sp.Eq(c, 0) for c in sp.Poly(rate, *state).coeffs()))
    asked = sp.And(where, sp.Or(*(sp.Ne(x, 0) for x in state)))
    proved = sp.And(sp.sympify(function) > 0, rate <= 0)
    inside = Case(
        sp.And(sp.Not(nothing), sp.Or(sp.Not(asked), sp.And(proved, besides))),
        tuple(state),
        every=True,
    )
    return (inside,), (Case(sp.And(asked, sp.Not(proved)), tuple(state)), Case(nothing))


@judged(Expression("parameters"))
def basin_level(claim, function, field, state, parameters=(), given=()):
    """The largest level c for which V proves that the part of {V < c} around zero belongs to the
    basin of attraction."""
    directions = _directions(len(state))
    for values, level, others, rate, largest in _stable_systems(
        function, field, state, parameters, given
    ):
        number = number_at(claim, values, "your level")
        real = abs(number.imag) <= 1e-9 * abs(number)
        told = (
            f"for {values_text(values)} " if values else ""
        ) + f"your level is {f'{number.real:.4g}' if real else 'not real'}"
        if not real or number.real <= 0:
            raise Wrong(
                f"{told}; V is positive near zero, so the level has to be a positive number"
            )
        low, high = (
            _border(lambda points, c=c: level(points) < c, directions)
            for c in (0.994 * number.real, 1.008 * number.real)
        )
        if not np.all(np.isfinite(low)):
            raise Wrong(
                f"{told}: the set V < c around zero is unbounded in the direction "
                f"{point_text(directions[np.argmax(~np.isfinite(low))])}"
            )
        broken = _breaks(rate, directions * low[:, None], others, level, 0.994 * number.real)
        if broken:
            raise Wrong(f"{told}: V does not prove attraction for all of this set: {broken}")
        if np.all(np.isfinite(high)) and not _breaks(
            rate, directions * high[:, None], others, level, 1.008 * number.real
        ):
            raise Wrong(
                f"{told}: V proves attraction up to this level, but also up to a higher one"
            )
        true = largest(number.real, directions * low[:, None])
        if true is not None and not agree(
            number, float(true), claim, uncertain=uncertain_at(claim, values)
        ):
            raise Wrong(
                f"{told}: "
                + (
                    "V does not prove attraction quite up to it"
                    if number.real > true
                    else "V proves attraction up to this level, but also up to a higher one"
                )
            )
    return (
        "up to this level the derivative of V is nowhere positive and no other equilibrium is "
        "met, and beyond it this ends"
    )


@judged(ConditionOn("state", "parameters"))
def basin_estimate(condition, function, field, state, parameters=(), given=()):
    """The largest set {V < c} around zero that V proves to belong to the basin of attraction.

    Judged for values of the parameters with an asymptotically stable first approximation: the
    boundary is a level line of V, inside V' <= 0 and no other equilibrium, and a slightly higher
    level breaks one of these. The set may contain the parameters; where V < c has parts away from
    zero, it has to leave them out.
    """
    directions = _directions(len(state))
    for values, level, others, rate, largest in _stable_systems(
        function, field, state, parameters, given
    ):
        claim = condition.subs(values)
        where = f" (for {values_text(values)})" if values else ""
        reach = _reach(claim, state, directions, where)
        border = directions * reach[:, None]
        heights = level(border)
        if np.ptp(heights) > 0.01 * np.mean(heights):
            low, high = border[np.argmin(heights)], border[np.argmax(heights)]
            raise Wrong(
                f"the boundary is no level line of V: V is {min(heights):.4g} at {point_text(low)} "
                f"and {max(heights):.4g} at {point_text(high)}{where}"
            )
        height = np.mean(heights)
        broken = _breaks(rate, 0.997 * border, others, level, 0.994 * height) or _holds_equilibrium(
            condition, field, state, values, others
        )
        if broken:
            raise Wrong(f"V does not prove attraction for all of this set: {broken}{where}")
        _has_no_holes(claim, state, sp.sympify(function).subs(values), height, border, where)
        true = largest(height, border)
        if true is not None:
            compare(
                claim,
                state,
                _part_around_zero(sp.sympify(function).subs(values), true, state, others, border),
                lambda place, holds, where=where: (
                    f"your set leaves out the state {place_text(place)}, which V proves to be "
                    f"attracted{where}"
                    if holds
                    else f"your set holds the state {place_text(place)}; V does not prove that it is "
                    f"attracted{where}"
                ),
            )
        if not _breaks(rate, 1.004 * border, others, level, 1.008 * height):
            raise Wrong(
                "the set is contained in the basin, but V proves more: "
                f"its derivative is still nowhere positive on a larger level set{where}"
            )
    return (
        "its boundary is a level line of V, the derivative is nowhere positive inside, and no "
        "higher level has this property"
    )


def _largest_level(height, change, motion, state, others, near, border):
    """The level c of V that the basin reaches, near one that is known, or None if it cannot be told
    exactly: an equilibrium stands on it, or V' > 0 at once above it; below neither is so."""
    exact = [
        {x: sp.Rational(Fraction(float(v)).limit_denominator(1000)) for x, v in zip(state, point)}
        for point in others
    ]
    met = {height.subs(point) for point in exact if all(f.subs(point) == 0 for f in motion)}
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
            Truth((Case(sp.false),), (Case(sp.And(box, height < level, change > 0)),)),
        )

    simple = {sp.Rational(float(near)).limit_denominator(q) for q in (1, 2, 4, 8, 12, 60, 1000)}
    for level in sorted(met | simple, key=lambda c: abs(c - near)):
        if (
            abs(level - near) < near / 80
            and rises_below(level) == (True, None)
            and (level in met or rises_below(level * (1 + sp.Rational(1, 10**9)))[1])
        ):
            return level
    return None


def _part_around_zero(height, level, state, others, border):
    """The truth that the part of {V < level} around zero is; an equilibrium on its boundary cuts it
    off from others."""
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
            np.abs(border).max(axis=0), np.reshape(others, (-1, len(state))).T
        )
    ]
    inside = sp.And(*(sp.Abs(x) < end for x, end in zip(state, ends)))
    beyond = sp.Or(*(sp.Abs(x) > end for x, end in zip(state, ends)))
    return Truth((Case(sp.And(height < level, inside)),), (Case(sp.Or(height > level, beyond)),))


def _directions(n, count=240):
    if n == 2:
        angles = 2 * np.pi * (np.arange(count) + 0.5) / count
        return np.column_stack([np.cos(angles), np.sin(angles)])
    sample = np.random.default_rng(6).normal(size=(count, n))
    return sample / np.linalg.norm(sample, axis=1)[:, None]


def _numeric(expression, state, parameters=()):
    """`expression` at many states, the rows of an array, for values of the parameters."""
    function = sp.lambdify([*state, *parameters], expression, "numpy")

    def value(points, place=()):
        with np.errstate(all="ignore"):
            return np.broadcast_to(function(*points.T, *map(float, place)), len(points))

    return value


def _rate(function, field, state, parameters=()):
    """V' at many states."""
    return _numeric(sum(sp.diff(function, x) * f for x, f in zip(state, field)), state, parameters)


def _stable_systems(function, field, state, parameters, given):
    """(values, V, other equilibria, V', the exact level near one) for sampled parameters at which
    the first approximation is stable."""
    return _sampled(
        sp.sympify(function), tuple(field), tuple(state), tuple(parameters), joined(given)
    )


@functools.lru_cache(maxsize=16)
def _sampled(function, field, state, parameters, given):
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
        change = sum(sp.diff(height, x) * f for x, f in zip(state, motion))
        others = [point for point in flow.rest_points(60) if np.linalg.norm(point) > 1e-6]
        systems.append(
            (
                values,
                _numeric(height, state),
                others,
                _rate(height, motion, state),
                functools.partial(_largest_level, height, change, motion, state, others),
            )
        )
        if len(systems) == 2:
            return systems
    if not systems:
        raise RuntimeError("no parameters with a stable first approximation were met")
    return systems


def _reach(claim, state, directions, where):
    """How far rays from zero stay in the claimed set, which has to end there for good."""
    inside = _membership(claim, state)
    if not np.all(inside(1e-3 * directions)):
        raise Wrong(f"the set does not contain a neighbourhood of zero{where}")
    reach = _border(inside, directions)
    if not np.all(np.isfinite(reach)):
        raise Wrong(
            "the set is unbounded in the direction "
            f"{point_text(directions[np.argmax(~np.isfinite(reach))])}; "
            f"a level set that proves attraction is bounded{where}"
        )
    for fraction in np.geomspace(1.001, 50, 300):
        beyond = fraction * reach[:, None] * directions
        again = inside(beyond)
        if np.any(again):
            place = beyond[np.argmax(again)]
            raise Wrong(_away(point_text(place), where))
    return reach


def _away(place, where):
    return (
        f"the set has a part away from zero, at {place} for instance, and motions from there need "
        f"not come to zero{where}"
    )


def _has_no_holes(claim, state, height, level, border, where):
    """Raise `Wrong` where the set leaves out a line or a point that rays from zero do not meet, or
    has a part that they miss."""
    shrunk, grown = (
        sp.Rational(factor * level).limit_denominator(10**6) for factor in (0.98, 1.02)
    )
    size = [sp.Rational(float(end)).limit_denominator(10**6) for end in np.abs(border).max(axis=0)]
    inside = sp.And(height < shrunk, *(sp.Abs(x) < end for x, end in zip(state, size)))
    outside = sp.Or(
        height > grown, *(sp.Abs(x) > sp.Rational(51, 50) * end for x, end in zip(state, size))
    )
    said, never = readings(claim)[0], (Case(sp.false),)
    _, place = decide(said, state, Truth(never, (Case(outside),)))
    if place:
        raise Wrong(_away(place_text(place[0]), where))
    _, place = decide(said, state, Truth((Case(inside),), never))
    if place:
        point = np.array([float(x) for x in place[0].values()])
        # Some other part of {V < c} may lie in the box.
        away = np.linalg.norm(border - point, axis=1)
        if np.linalg.norm(point) <= 1.01 * np.linalg.norm(border[np.argmin(away)]):
            raise Wrong(
                f"your set leaves out the state {place_text(place[0])}, where V is smaller than on "
                f"its boundary{where}"
            )


def _border(inside, directions, nearest=1e-2, extent=60.0):
    """The distance along each ray at which it first leaves a set, inf where it does not."""
    # A step of 1.2 per cent: less than the gap that a ray beside a saddle passes through.
    distances = np.geomspace(nearest, extent, 740)
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
    """A condition as a function of many states in floating-point numbers; False where it is not
    defined."""
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
        difference = _numeric(condition.lhs - condition.rhs, state)
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


def _breaks(rate, border, others, level, height):
    """What keeps the set inside `border` from being proved to lie in the basin, or an empty
    string."""
    points = np.concatenate(
        [fraction * border for fraction in (0.3, 0.6, 0.8, 0.9, 0.95, 0.98, 1.0)]
    )
    rates = rate(points)
    worst = int(np.argmax(rates))
    if rates[worst] > 1e-9 * max(abs(rates)):
        return f"at {point_text(points[worst])} the derivative is {rates[worst]:.3g}"
    near = 1.01 * max(np.linalg.norm(border, axis=1))
    inside = [
        point for point in others if level(point[None])[0] < height and np.linalg.norm(point) < near
    ]
    return f"it contains the equilibrium {point_text(inside[0])}" if inside else ""


def _holds_equilibrium(claim, field, state, values, others):
    """The other equilibrium that lies in the claimed set or on a part of its boundary that belongs
    to it, in words; a boundary in decimals may be rounded to either side of it."""
    claims = [reading.subs(values) for reading in readings(claim)]
    for point in others:
        exact = {
            x: sp.Rational(Fraction(float(v)).limit_denominator(1000)) for x, v in zip(state, point)
        }
        if all(sp.sympify(f).subs(values).subs(exact) == 0 for f in field) and all(
            claim.subs(exact) is sp.true for claim in claims
        ):
            return f"it contains the equilibrium {point_text(point)}"
    return ""
