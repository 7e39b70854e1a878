"""Phase curves, first integrals, and Dulac functions that exclude closed orbits.

`domain` is a dict from symbols of the state or parameters to SymPy intervals.
"""

import cmath
import math

import mpmath
import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.equilibria import equilibria_of
from workbook.checks.references.exceptional_values import judge_factors
from workbook.checks.tools.domains import endpoints, random_value
from workbook.checks.tools.samples import random_columns
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import left_open
from workbook.checks.tools.wording import NO_NUMBER, rounded_text, sample_text


@judged
def dulac_function(answer, field, state, parameters, domain=None):
    """Check a pair (B, div(B f)) whose second member has one sign in the domain.

    Then no closed orbit lies in the domain (Dulac, Bendixson).

    Can decide when the domain is given by intervals: the sign of the divergence is compared at
    points in it.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.dulac_function([1, -1], [y, -sp.sin(x) - y], [x, y], []).status
    'right'
    >>> checks.dulac_function([1, 1], [y, -sp.sin(x) - y], [x, y], []).status
    'wrong'
    """
    symbols = [*state, *parameters]
    multiplier, divergence = coercion.as_expressions(answer, symbols, length=2)

    def terms_of(multiplier):
        return [sp.diff(multiplier * component, x) for component, x in zip(field, state)]

    terms = terms_of(multiplier)
    random = np.random.default_rng(9)
    points = random_columns(random, symbols, domain, 300, [multiplier, divergence])
    with np.errstate(all="ignore"):
        parts, points = _within_reach(
            [_values(e, symbols, points) for e in (*terms, divergence, multiplier)], points
        )
    uncertain = left_open(
        [multiplier], lambda parts: _values(sp.Add(*terms_of(*parts)), symbols, points)
    ) + left_open([divergence], lambda parts: _values(*parts, symbols, points))
    for k, point in enumerate(points.T):
        where = rounded_text(dict(zip(symbols, point)))
        if not np.all(np.isfinite(parts[:, k])):
            raise Wrong(
                f"at {where}, a point of the domain, your multiplier or its divergence is not a "
                "real number"
            )
        true, claimed = parts[:-2, k].sum(), parts[-2, k]
        if not (
            math.isfinite(true)
            and agree(
                claimed,
                true,
                divergence,
                abs(parts[:-2, k]).sum(),
                uncertain=np.broadcast_to(uncertain, len(points.T))[k],
            )
        ):
            raise Wrong(
                f"at {where} the divergence of the field times your multiplier is not "
                f"{claimed:.4g}, which your second expression gives"
            )
    signs = np.sign(np.where(abs(parts[-2]) > 1e-12 * abs(parts[:-2]).sum(axis=0), parts[-2], 0))
    if not signs.any():
        raise Wrong(
            "the divergence vanishes everywhere, so it excludes nothing: such a field may well "
            "have closed orbits"
        )
    if signs.min() < 0 < signs.max():
        low, high = points[:, np.argmin(signs)], points[:, np.argmax(signs)]
        raise Wrong(
            "the divergence changes its sign in the domain: it is negative at "
            f"{rounded_text(dict(zip(symbols, low)))} and positive at "
            f"{rounded_text(dict(zip(symbols, high)))}"
        )
    judge_factors(terms, state, domain, "the divergence vanishes everywhere")
    return (
        "the divergence belongs to this multiplier and keeps one sign at 300 points of the domain"
    )


@judged
def first_integral(answer, field, state, parameters, domain=None):
    """Check a function of the state that is constant along the motions and not constant itself.

    Can decide when field and integral are rational functions; others are compared at points.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> checks.first_integral(2*x**2 + y**2/2, [y, -4*x], [x, y], []).status
    'right'
    >>> checks.first_integral(x**2 + y**2, [y, -4*x], [x, y], []).status
    'wrong'
    """
    symbols = [*state, *parameters]
    claim = coercion.as_expression(answer, symbols)
    slopes = [sp.diff(claim, x) for x in state]
    random = np.random.default_rng(10)
    points = random_columns(random, symbols, domain, 60, claim)
    with np.errstate(all="ignore"):
        (levels, *gradient), points = _within_reach(
            [_values(part, symbols, points) for part in (claim, *slopes)], points
        )
        velocity = np.array([_values(component, symbols, points) for component in field])
    gradient = np.array(gradient)
    for k in np.flatnonzero(~np.isfinite([levels, *gradient]).all(axis=0)):
        where = rounded_text(dict(zip(symbols, points[:, k])))
        raise Wrong(
            f"at {where}, a point of the domain, your expression or a derivative of it is {NO_NUMBER}"
        )
    if not np.any(abs(gradient) > 1e-12):
        raise Wrong(
            "your expression does not depend on the state: a constant is the same for all motions"
        )
    rates, sizes = (gradient * velocity).sum(axis=0), abs(gradient * velocity).sum(axis=0)
    allowed = 1e-9 * sizes + left_open(
        [claim],
        lambda parts: (
            np.array([_values(sp.diff(*parts, x), symbols, points) for x in state]) * velocity
        ).sum(axis=0),
    )
    worst = int(np.argmax(abs(rates) - allowed))
    if not abs(rates[worst]) <= allowed[worst] < math.inf:
        raise Wrong(
            f"along the motion through {rounded_text(dict(zip(symbols, points[:, worst])))} your "
            f"expression changes at the rate {rates[worst]:.4g}, not zero"
        )
    judge_factors(slopes, state, domain, "your expression does not depend on the state")
    return "it keeps its value along the motions, at random states"


@judged
def phase_curve(answer, field, state, parameters, through, domain=None):
    """Check the phase curve through given points of the border of the domain.

    It is an expression for the second state variable.

    Judged by its slope, which is that of the field everywhere, and by its limits at the points
    `through`.

    Can decide when the domain bounds the first variable: slopes are compared at random points and
    parameters.

    Examples
    --------
    >>> x, y = sp.symbols("x y", real=True)
    >>> upper = {x: sp.Interval.open(-1, 1), y: sp.Interval.open(0, sp.oo)}
    >>> checks.phase_curve(sp.sqrt(1 - x**2), [y, -x], [x, y], [], [(1, 0)], upper).status
    'right'
    >>> checks.phase_curve(1 - x**2, [y, -x], [x, y], [], [(1, 0)], upper).status
    'wrong'
    """
    first, second = state
    claim = coercion.as_expression(answer, [first, *parameters])
    slope = sp.diff(claim, first)
    family = equilibria_of(field, state, parameters, domain)
    random = np.random.default_rng(12)
    for values, numbers, _ in family.samples(claim, with_points=False, count=5):
        scale = 0.0
        for _ in range(6):
            x = sp.Rational(round(10**4 * random_value(random, first, domain)), 10**4)
            y, dy = (real_at(expression, values | {first: x}) for expression in (claim, slope))
            where = f"{sample_text(values)}at {first} = {float(x):.3g}"
            if y is None or dy is None or not family.inside(np.array([float(x), y])):
                raise Wrong(
                    f"{where} your expression gives "
                    + (
                        NO_NUMBER
                        if y is None or dy is None
                        else f"{second} = {y:.3g}, outside the domain"
                    )
                )
            velocity = family(np.array([float(x), y]), numbers)
            scale = max(scale, y)

            def turned(part, at=values | {first: x}, numbers=numbers):
                y, dy = (
                    real_at(expression, at) or 0.0 for expression in (part, sp.diff(part, first))
                )
                velocity = family(np.array([float(at[first]), y]), numbers)
                return dy * velocity[0] - velocity[1]

            allowed = 1e-8 * (np.linalg.norm(velocity) + abs(dy * velocity[0])) + left_open(
                [claim], lambda parts: turned(*parts)
            )
            if not abs(dy * velocity[0] - velocity[1]) <= allowed < math.inf:
                steep = abs(velocity[0]) <= 1e-9 * abs(velocity[1])
                raise Wrong(
                    f"{where} your curve has the slope {dy:.4g}, but a motion that is there "
                    + (
                        "moves straight up or down"
                        if steep
                        else "crosses it: the slope is not the ratio of the right-hand sides"
                    )
                )
        for end_x, end_y in through:
            middle = sum(endpoints(first, domain)) / 2
            close = sp.Float(middle + (1 - 1e-8) * (float(end_x) - middle), 25)
            y = real_at(claim, values | {first: close})
            if y is None or not abs(y - float(end_y)) <= 1e-3 * scale:
                raise Wrong(
                    f"{sample_text(values)}your curve does not go through ({end_x}, {end_y}): "
                    "close to it "
                    f"{second} is " + (NO_NUMBER if y is None else f"{y:.3g}")
                )
    return "its slope is that of the motions, and it goes through the points asked for"


def _within_reach(values, points):
    """Return values (a row for each expression) and points, without those that overflow a float."""
    fits = ~np.isinf(values).any(axis=0)
    if not fits.any():
        raise Invalid("your answer has no values of a size that can be computed with")
    return np.array(values)[:, fits], points[:, fits]


def _values(expression, symbols, points):
    """Return an expression at many points; nan where it is not real, inf where it overflows a float.

    Its symbols and functions were checked by `coercion.with_symbols`.
    """
    if expression.has(sp.nan, sp.zoo):
        return np.full(points.shape[1], math.nan)
    # The slope of a Max holds steps, for which SymPy would solve inequalities.
    expression = expression.replace(sp.Heaviside, lambda x, *_: (1 + sp.sign(x)) / 2)
    try:
        function = sp.lambdify(symbols, expression, "mpmath")
    except (ValueError, NotImplementedError):  # the slope of a floor
        return np.full(points.shape[1], math.nan)

    def value(point):
        try:
            result = function(*point)
            number = complex(result)
        # TypeError: a Piecewise without a case for this point; NameError: a function without
        # values, such as a delta function
        except (ZeroDivisionError, ValueError, OverflowError, TypeError, NameError):
            return math.nan
        if cmath.isinf(number) and isinstance(result, mpmath.mpf) and mpmath.isfinite(result):
            return math.inf
        return (
            number.real
            if cmath.isfinite(number) and abs(number.imag) < 1e-9 * (1 + abs(number))
            else math.nan
        )

    return np.array([value(point.tolist()) for point in points.T])
