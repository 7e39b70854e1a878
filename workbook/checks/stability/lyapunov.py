"""Lyapunov functions: derivative along the motions, its zeros, and the stability proved."""

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.fields import Field
from workbook.checks.tools.conditions import (
    Case,
    Condition,
    ReferenceCondition,
    compare,
    exactly,
    on_borders,
)
from workbook.checks.tools.samples import allowed_values, in_every_case, sample_values
from workbook.checks.tools.values import number_at
from workbook.checks.tools.wording import other_text, rounded_text, values_text


@judged(Expression("state", "parameters"))
def lyapunov_derivative(claim, function, field, state, parameters=()):
    """Check the derivative of V along the motions of x' = f(x), in the state (Definition 1.4).

    Can decide when function and field have values at sample points; the identity is compared
    there.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.lyapunov_derivative(-2*y**2, x**2 + y**2, [y, -x - y], [x, y], []).status
    'right'
    >>> checks.lyapunov_derivative(2*y**2, x**2 + y**2, [y, -x - y], [x, y], []).status
    'wrong'
    """
    random = np.random.default_rng(4)
    for values in in_every_case(sample_values(parameters), claim):
        flow, level = Field(field, state, values), Field([function], state, values)
        for at in in_every_case(
            [dict(zip(state, random.normal(size=len(state)))) for _ in range(4)],
            claim.xreplace(values),
        ):
            point = np.array(list(at.values()))
            true = level.derivative(point, flow(point))[0]
            claimed = number_at(claim, values | dict(zip(state, point)))
            # The size of the terms of grad V . f, not of their sum, sets the scale: the sum may
            # cancel.
            size = abs(level.derivative(point, np.ones(len(state)))[0]) * np.linalg.norm(
                flow(point)
            ) + abs(true)
            if not abs(claimed - true) <= 1e-9 * size:
                quantity = "the rate at which the function changes along the motion"
                raise Wrong(
                    f"at {rounded_text(dict(zip(state, point)) | values)} "
                    + other_text(quantity, claimed.real, true)
                )
    return "it is the rate at which the function changes along the motions, at random states"


@judged
def vanishing_set(answer, function, field, state, parameters=()):
    """Check the set of states where the derivative of V along the motions is zero.

    It is asked for parameters that are not zero.

    Can decide when V and the field are polynomials; elsewhere the set is compared at points.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.vanishing_set(sp.Eq(y, 0), x**2 + y**2, [y, -x - y], [x, y]).status
    'right'
    >>> checks.vanishing_set(sp.Eq(x, 0), x**2 + y**2, [y, -x - y], [x, y]).status
    'wrong'
    """
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    (sample,) = sample_values(parameters, count=1) if parameters else ({},)
    nonzero = sp.And(*(sp.Ne(p, 0) for p in parameters))
    # A factor that is not zero may stay in the equation.
    free_parameters = [
        p for p in parameters if p.name in {s.name for s in getattr(answer, "free_symbols", ())}
    ]
    reference = exactly(
        sp.Eq(rate, 0),
        nonzero,
        tuple(p for p in parameters if p not in free_parameters),
        lambda values: sp.simplify(rate.subs(values).subs(sample)) == 0,
    )

    def message(values, holds):
        return (
            f"at {values_text(values)} the derivative is {'zero' if holds else 'not zero'}, and "
            f"your set {'does not hold' if holds else 'holds'} this state"
        )

    agreement = compare(answer, [*state, *free_parameters], reference, message)
    return f"the derivative is zero at the states of this set and at no others: {agreement}"


@judged
def rate_on_vanishing_set(answer, function, field, state, parameters=()):
    """Check the rate of the last state variable on the set where V' vanishes.

    This rate takes a motion out of the set (Theorem 1.5).

    Judged at states of the set alone, so terms that vanish on it may stay or go.

    Can decide when V, the field and the answer are polynomials; others are compared at points of
    the set.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.rate_on_vanishing_set(-x, x**2 + y**2, [y, -x - y], [x, y]).status
    'right'
    >>> checks.rate_on_vanishing_set(0, x**2 + y**2, [y, -x - y], [x, y]).status
    'wrong'
    """
    symbols = [*state, *parameters]
    claim, true = coercion.as_expression(answer, symbols), sp.sympify(field[-1])
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    zero = Condition(sp.And(sp.Eq(rate, 0), *(sp.Ne(p, 0) for p in parameters)), symbols)

    def at(values):
        return True if zero.holds(values.values()) else None

    def message(values, holds):
        return f"at {values_text(values)} the derivative of V is zero, and there " + other_text(
            f"the rate of {state[-1]}",
            number_at(claim, values).real,
            float(true.subs(values)),
        )

    reference = ReferenceCondition(
        (Case(zero.condition),), (Case(sp.false),), at, lambda: on_borders(zero, symbols)
    )
    agreement = compare(sp.Eq(claim, true), symbols, reference, message)
    return f"it is this rate at the states where the derivative vanishes: {agreement}"


@judged
def asymptotic_stability_by_lyapunov(answer, function, field, state, parameters):
    """Check the parameters for which V proves asymptotic stability of zero (Theorem 1.5).

    That is: V > 0 and V' <= 0 near zero, and V' is not identically zero (that no motion stays
    where it vanishes is the responsibility of the author of the problem). Values that the
    assumptions of a parameter exclude are not judged.

    Can decide when V and the field are polynomials near zero: then for all parameters; elsewhere
    the condition is compared at points.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> d = sp.Symbol("d", real=True)
    >>> checks.asymptotic_stability_by_lyapunov(d > 0, x**2 + y**2, [y, -x - d*y], [x, y], [d]).status
    'right'
    >>> checks.asymptotic_stability_by_lyapunov(d >= 0, x**2 + y**2, [y, -x - d*y], [x, y], [d]).status
    'wrong'
    """
    circle = 0.1 * unit_directions(len(state))
    level, rate = numeric(function, state, parameters), rate_of(function, field, state, parameters)

    def at(values):
        heights, rates = level(circle, values.values()), rate(circle, values.values())
        return bool(min(heights) > 0 and max(rates) <= 1e-12 and min(rates) < -1e-12)

    def message(values, holds):
        rates = rate(circle, values.values())
        return (
            f"for {values_text(values)} the derivative of V on the circle of radius 0.1 lies "
            f"between {min(rates):.3g} and {max(rates):.3g}, which "
            f"{'proves' if holds else 'does not prove'} asymptotic stability"
        )

    near = sum(x**2 for x in state) <= sp.Rational(1, 100)
    reference = ReferenceCondition(*_proved(function, field, state, near), at)
    agreement = compare(answer, parameters, reference, message)
    return f"there the derivative is nowhere positive near zero and not identically zero, and only there: {agreement}"


@judged
def global_stability_by_lyapunov(answer, function, field, state, parameters, given=()):
    """Check the values of `parameters` for which V proves global asymptotic stability of zero.

    That is: V > 0 grows without bound in every direction, and V' <= 0 everywhere, but not
    identically (that no motion stays where it vanishes is the responsibility of the author of the
    problem). Other symbols get values that satisfy `given`.

    Can decide when V and its derivative are polynomials; elsewhere the condition is compared at
    points.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> d = sp.Symbol("d", real=True)
    >>> checks.global_stability_by_lyapunov(d > 0, x**2 + y**2, [y, -x - d*y], [x, y], [d]).status
    'right'
    >>> checks.global_stability_by_lyapunov(d >= 0, x**2 + y**2, [y, -x - d*y], [x, y], [d]).status
    'wrong'
    """
    other_symbols = set().union(*(sp.sympify(f).free_symbols for f in [*field, function])) - {
        *state,
        *parameters,
    }
    (sample,) = allowed_values(sorted(other_symbols, key=str), given, 1)
    field, function = [sp.sympify(f).subs(sample) for f in field], sp.sympify(function).subs(sample)
    radii = np.geomspace(1e-2, 1e4, 41)
    points = (radii[:, None, None] * unit_directions(len(state), 60)).reshape(-1, len(state))
    level, rate = numeric(function, state, parameters), rate_of(function, field, state, parameters)

    def reason(values):
        """Return why V does not prove global stability, or ""."""
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
        # For parameters closer to zero the growth of V shows only beyond the sampled states.
        return (
            None if 0 < max(abs(float(x)) for x in values.values()) < 1e-6 else not reason(values)
        )

    def message(values, holds):
        failure = (
            ""
            if holds
            else reason(values) or "V does not grow, or its derivative is positive, far from zero"
        )
        return f"for {values_text(values)} " + (
            f"{failure}, which proves nothing in the large"
            if failure
            else (
                "V grows without bound in every direction and its derivative is nowhere positive: "
                "it proves stability in the large"
            )
        )

    grows = sum(x * sp.diff(function, x) for x in state) > 0
    reference = ReferenceCondition(*_proved(function, field, state, sp.true, grows), at)
    agreement = compare(answer, parameters, reference, message)
    return f"there V grows in every direction and its derivative is nowhere positive, and only there: {agreement}"


def _proved(function, field, state, neighbourhood, growth=sp.true):
    """Return the cases in which V proves stability, and those in which it does not.

    V proves it if V > 0, V' <= 0 and `growth` hold at all states of `neighbourhood` but zero, and
    V' is not identically zero.
    """
    rate = sp.expand(sum(sp.diff(function, x) * f for x, f in zip(state, field)))
    if not (rate.is_polynomial(*state) and sp.sympify(function).is_polynomial(*state)):
        return (), ()
    rate_is_zero = sp.And(*(sp.Eq(c, 0) for c in sp.Poly(rate, *state).coeffs()))
    domain = sp.And(neighbourhood, sp.Or(*(sp.Ne(x, 0) for x in state)))
    proved = sp.And(sp.sympify(function) > 0, rate <= 0)
    inside = Case(
        sp.And(sp.Not(rate_is_zero), sp.Or(sp.Not(domain), sp.And(proved, growth))),
        tuple(state),
        every=True,
    )
    return (inside,), (Case(sp.And(domain, sp.Not(proved)), tuple(state)), Case(rate_is_zero))


def unit_directions(n, count=240):
    if n == 2:
        angles = 2 * np.pi * (np.arange(count) + 0.5) / count
        return np.column_stack([np.cos(angles), np.sin(angles)])
    sample = np.random.default_rng(6).normal(size=(count, n))
    return sample / np.linalg.norm(sample, axis=1)[:, None]


def numeric(expression, state, parameters=()):
    """Return `expression` as a function of an array of states (rows) and parameter values."""
    function = sp.lambdify([*state, *parameters], expression, "numpy")

    def value(points, parameter_values=()):
        with np.errstate(all="ignore"):
            return np.broadcast_to(function(*points.T, *map(float, parameter_values)), len(points))

    return value


def rate_of(function, field, state, parameters=()):
    """Return V' as a function of an array of states (rows) and parameter values."""
    return numeric(sum(sp.diff(function, x) * f for x, f in zip(state, field)), state, parameters)
