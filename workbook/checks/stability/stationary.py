"""Stationary points of planar systems that contain parameters: where they are, of what type, and
what excludes closed orbits.

`domain` is a dict from symbols of the state or parameters to SymPy intervals, as in
`trajlib.stability.equilibria`; an interval of length 2 pi makes a state variable an angle, for
which values modulo 2 pi are the same. What `domain` does not name ranges over all numbers that the
assumptions of the symbol allow. The truth is found from the field alone, for sample values of the
parameters, by Newton's method from many starts at once. "The stationary point" of a check is the
only one in the domain: a data cell that leaves room for two makes the answer unchecked.
"""

import cmath
import math

import mpmath
import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Choice, Expression
from workbook.checks.contract.members import VECTORS, in_order
from workbook.checks.contract.tolerance import agree, half_unit, in_decimals, perturbed
from workbook.checks.contract.verdict import Invalid, Wrong, judged
from workbook.checks.references.exceptional_values import judge_factors
from workbook.checks.references.stationary_points import rest_points
from workbook.checks.stability.nominal_motions import is_angle_equation, judge_angle_roots
from workbook.checks.tools.conditions import Case, Truth, compare, exactly, place_text
from workbook.checks.tools.samples import draw, drawn, ends
from workbook.checks.tools.values import real_at, uncertain_at
from workbook.checks.tools.wording import other_rate, point_text, roots_text, sample_text

STABILITY = ("asymptotically stable", "stable", "unstable")
TYPES = tuple(
    f"{how} {what}"
    for what in ("node", "star", "degenerate node", "focus")
    for how in ("stable", "unstable")
)
TYPES += ("saddle", "centre")


@judged
def stationary_points(answer, field, state, parameters, domain=None, zeros=None):
    """All stationary points in the domain, as expressions in the parameters: one point, or a list
    of points.

    A point whose formula is not real, or leaves the domain, for some values of the parameters
    stands for no point there. Where derivatives vanish at a point as well, `zeros` are functions
    that have the same zeros, all simple.
    """
    searched = rest_points(field if zeros is None else zeros, state, parameters, domain)
    return _judge_points(
        answer, rest_points(field, state, parameters, domain), "stationary point", searched
    )


@judged
def nullcline(answer, rate, variable, parameters, domain=None):
    """The curve on which `rate` vanishes, solved for `variable`; the other state variables count as
    parameters."""
    return _judge_points(
        answer, rest_points([rate], [variable], parameters, domain), "point of the curve"
    )


@judged
def stationary_exists(answer, field, state, parameters, domain=None):
    """The parameters for which there is a stationary point in the domain."""
    return _judge_existence(
        answer, rest_points(field, state, parameters, domain), "stationary point"
    )


@judged(Expression("parameters"))
def cycle_period(claim, radial, angular, radius, parameters):
    """The period of the closed orbit of r' = R(r), phi' = W(r): at the rate W the angle gains 2 pi
    in it."""
    family = rest_points([radial], [radius], parameters, _cycles(radius))
    turning = rest_points([angular], [radius], parameters, _cycles(radius))
    for values, numbers, rest in family.samples(claim):
        period = real_at(claim, values)
        if period is None:
            raise Wrong(
                f"for {sample_text(values)} there is a closed orbit, but your expression gives no "
                "real number"
            )
        rate = float(turning(rest, numbers)[0])
        if period <= 0 or not agree(rate * period, math.copysign(2 * math.pi, rate), claim):
            raise Wrong(
                f"for {sample_text(values)} the angle gains {rate * period:.4g} within your time "
                f"{period:.4g}, which is not one turn"
            )
    return "in this time the angle gains one full turn on the closed orbit"


@judged
def stationary_linearisation(answer, field, state, parameters, domain=None):
    """The matrix A of the linear equations in deviations from the stationary point; a number for
    one equation."""
    n = len(state)
    if n == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase, np.ndarray)):
        answer = [[answer]]
    matrix = coercion.as_matrix(answer, parameters, (n, n))
    family = rest_points(field, state, parameters, domain)
    for values, numbers, rest in family.samples(matrix):
        true = family.jacobian(rest, numbers)
        size = np.linalg.norm(true)
        for k in range(n):
            said = [real_at(entry, values) for entry in matrix[:, k]]
            if any(value is None for value in said):
                raise Wrong(f"for {sample_text(values)} your matrix is not real")
            if not agree(said, true[:, k], list(matrix[:, k]), size).all():
                raise Wrong(f"for {sample_text(values)} {other_rate(state[k], said, true[:, k])}")
    return "small deviations from the stationary solution change the right-hand sides as it says"


@judged(Expression("parameters"))
def stationary_value(claim, expression, field, state, parameters, domain=None):
    """The value of an expression of the state at the stationary point."""
    family = rest_points(field, state, parameters, domain)
    reading = rest_points([expression], state, parameters, domain)
    for values, numbers, rest in family.samples(claim):
        true, said = float(reading(rest, numbers)[0]), real_at(claim, values)
        if said is None or not agree(said, true, claim, _scale(expression, values, state, rest)):
            told = "no real number" if said is None else f"{said:.4g}"
            if not values:  # the true number would be the answer itself
                raise Wrong(f"the value at the stationary solution is another one than {told}")
            raise Wrong(
                f"for {sample_text(values)} the value is {true:.4g}; your expression gives {told}"
            )
    return "it is the value at the stationary solution, for sample values of the parameters"


@judged(Choice(words=STABILITY))
def stationary_stability(claim, field, state, parameters, domain=None):
    """Whether the stationary point is asymptotically stable, stable (and no more) or unstable, by
    Theorem 1.4."""
    family = rest_points(field, state, parameters, domain)
    for values, numbers, rest in family.samples():
        eigenvalues = np.linalg.eigvals(family.jacobian(rest, numbers))
        largest = max(eigenvalues.real)
        if abs(largest) < 1e-9 * (1 + max(abs(eigenvalues))):
            raise RuntimeError("the first approximation does not decide here")
        if claim != ("unstable" if largest > 0 else "asymptotically stable"):
            raise Wrong(
                f"this does not agree with the first approximation: for {sample_text(values)} its "
                f"{'roots are' if len(eigenvalues) > 1 else 'root is'} {roots_text(eigenvalues)}"
            )
    return (
        "it agrees with the roots of the first approximation, for sample values of the parameters"
    )


@judged
def stationary_type(answer, field, state, parameters, domain=None):
    """The type of the stationary point of a planar system, the same for all values of the
    parameters."""
    spelled = (
        answer.lower().replace("center", "centre").replace("star node", "star")
        if isinstance(answer, str)
        else answer
    )
    claim = coercion.as_choice(spelled, TYPES)
    family = rest_points(field, state, parameters, domain)
    for values, numbers, rest in family.samples():
        matrix = family.jacobian(rest, numbers)
        kind = _kind(matrix)
        if claim != kind:
            raise Wrong(
                f"this does not agree with the first approximation: for {sample_text(values)} its "
                f"roots are {roots_text(np.linalg.eigvals(matrix))}"
            )
    return (
        "it agrees with the roots of the first approximation, for sample values of the parameters"
    )


@judged
def focus_region(answer, field, state, parameters, domain=None):
    """The parameters for which the stationary point is a focus; the border, where the roots are
    equal, counts either way.

    Without a domain, of an equation phi'' = f(phi, phi') that is periodic in phi: for which all
    stationary angles that are no saddles are foci.
    """
    return _judge_roots(answer, field, state, parameters, domain, -1)


@judged
def node_region(answer, field, state, parameters, domain=None):
    """The parameters for which the stationary point is a node; the border, where the roots are
    equal, counts either way.

    Without a domain, of an equation phi'' = f(phi, phi') that is periodic in phi: for which all
    stationary angles that are no saddles are nodes.
    """
    return _judge_roots(answer, field, state, parameters, domain, 1)


@judged
def dulac_function(answer, field, state, parameters, domain=None):
    """A pair (B, div(B f)) whose second member has one sign in the domain: no closed orbit lies
    there (Dulac, Bendixson)."""
    symbols = [*state, *parameters]
    multiplier, divergence = coercion.as_expressions(answer, symbols, length=2)
    terms = [sp.diff(multiplier * component, x) for component, x in zip(field, state)]
    random = np.random.default_rng(9)
    places = drawn(random, symbols, domain, 300, [multiplier, divergence])
    with np.errstate(all="ignore"):
        parts, places = _within_reach(
            [_values(e, symbols, places) for e in (*terms, divergence, multiplier)], places
        )
    for k, place in enumerate(places.T):
        where = ", ".join(f"{s} = {x:.3g}" for s, x in zip(symbols, place))
        if not np.all(np.isfinite(parts[:, k])):
            raise Wrong(
                f"at {where}, a point of the domain, your multiplier or its divergence is not a "
                "real number"
            )
        true, said = parts[:-2, k].sum(), parts[-2, k]
        if not (math.isfinite(true) and agree(said, true, divergence, abs(parts[:-2, k]).sum())):
            raise Wrong(
                f"at {where} the divergence of the field times your multiplier is {true:.4g}; "
                f"your second expression gives {said:.4g}"
            )
    signs = np.sign(np.where(abs(parts[-2]) > 1e-12 * abs(parts[:-2]).sum(axis=0), parts[-2], 0))
    if not signs.any():
        raise Wrong(
            "the divergence vanishes everywhere, so it excludes nothing: such a field may well "
            "have closed orbits"
        )
    if signs.min() < 0 < signs.max():
        low, high = places[:, np.argmin(signs)], places[:, np.argmax(signs)]
        raise Wrong(
            "the divergence changes its sign in the domain: it is negative at "
            + ", ".join(f"{s} = {x:.3g}" for s, x in zip(symbols, low))
            + " and positive at "
            + ", ".join(f"{s} = {x:.3g}" for s, x in zip(symbols, high))
        )
    judge_factors(terms, state, domain, "the divergence vanishes everywhere")
    return (
        "the divergence belongs to this multiplier and keeps one sign at 300 points of the domain"
    )


@judged
def first_integral(answer, field, state, parameters, domain=None):
    """A function of the state that keeps its value along the motions and is not constant."""
    symbols = [*state, *parameters]
    claim = coercion.as_expression(answer, symbols)
    slopes = [sp.diff(claim, x) for x in state]
    random = np.random.default_rng(10)
    places = drawn(random, symbols, domain, 60, claim)
    with np.errstate(all="ignore"):
        (levels, *gradient), places = _within_reach(
            [_values(part, symbols, places) for part in (claim, *slopes)], places
        )
        velocity = np.array([_values(component, symbols, places) for component in field])
    gradient = np.array(gradient)
    for k in np.flatnonzero(~np.isfinite([levels, *gradient]).all(axis=0)):
        where = ", ".join(f"{s} = {x:.3g}" for s, x in zip(symbols, places[:, k]))
        raise Wrong(
            f"your expression is not real, or has no derivatives, at {where}, a point of the domain"
        )
    if not np.any(abs(gradient) > 1e-12):
        raise Wrong(
            "your expression does not depend on the state: a constant tells nothing about the "
            "motions"
        )
    rates, sizes = (gradient * velocity).sum(axis=0), abs(gradient * velocity).sum(axis=0)
    allowed = 1e-9 * sizes + _left_open(
        claim,
        lambda part: (
            np.array([_values(sp.diff(part, x), symbols, places) for x in state]) * velocity
        ).sum(axis=0),
    )
    worst = int(np.argmax(abs(rates) - allowed))
    if not abs(rates[worst]) <= allowed[worst] < math.inf:
        raise Wrong(
            "along the motion through "
            + ", ".join(f"{s} = {x:.3g}" for s, x in zip(symbols, places[:, worst]))
            + f" your expression changes at the rate {rates[worst]:.4g}, not zero"
        )
    judge_factors(slopes, state, domain, "your expression does not depend on the state")
    return "it keeps its value along the motions, at random states"


def _left_open(claim, found):
    """By how much the decimals of an expression leave open what is `found` of it."""
    followed = perturbed(claim) if in_decimals(claim) else []
    if followed is None:
        raise Invalid("your answer holds more decimals than can be followed; write exact numbers")
    here = found(claim) if followed else 0.0
    return sum(np.maximum(*(abs(found(part) - here) for (part,) in sides)) for sides in followed)


@judged
def phase_curve(answer, field, state, parameters, through, domain=None):
    """The phase curve through given points of the border of the domain, as an expression for the
    second state variable.

    Judged by its slope, which is that of the field everywhere, and by its limits at the points
    `through`.
    """
    first, second = state
    claim = coercion.as_expression(answer, [first, *parameters])
    slope = sp.diff(claim, first)
    family = rest_points(field, state, parameters, domain)
    random = np.random.default_rng(12)
    for values, numbers, _ in family.samples(claim, need_rest=False, count=5):
        scale = 0.0
        for _ in range(6):
            x = sp.Rational(round(10**4 * draw(random, first, domain)), 10**4)
            y, dy = (real_at(expression, values | {first: x}) for expression in (claim, slope))
            where = f"for {sample_text(values)} at {first} = {float(x):.3g}"
            if y is None or dy is None or not family.inside(np.array([float(x), y])):
                raise Wrong(
                    f"{where} your expression gives "
                    + (
                        "no real number"
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

            allowed = 1e-8 * (np.linalg.norm(velocity) + abs(dy * velocity[0])) + _left_open(
                claim, turned
            )
            if not abs(dy * velocity[0] - velocity[1]) <= allowed < math.inf:
                steep = abs(velocity[0]) <= 1e-9 * abs(velocity[1])
                raise Wrong(
                    f"{where} your curve has the slope {dy:.4g}, but a motion that is there moves "
                    + (
                        "straight up or down"
                        if steep
                        else f"along the slope {velocity[1] / velocity[0]:.4g}"
                    )
                )
        for end_x, end_y in through:
            middle = sum(ends(first, domain)) / 2
            close = sp.Float(middle + (1 - 1e-8) * (float(end_x) - middle), 25)
            y = real_at(claim, values | {first: close})
            if y is None or not abs(y - float(end_y)) <= 1e-3 * scale:
                raise Wrong(
                    f"for {sample_text(values)} your curve does not go through ({end_x}, {end_y}): "
                    "close to it "
                    f"{second} is " + ("not real" if y is None else f"{y:.3g}")
                )
    return "its slope is that of the motions, and it goes through the points asked for"


# What the checks share: a point, a condition of existence, a condition on the roots.


def _judge_points(answer, family, noun, searched=None):
    """All rest points of a family, as one point or a list of points; they are those of
    `searched`."""
    points = _points(answer, family)
    met = [False] * len(points)
    for values, numbers, rests in (searched or family).samples(points, alone=False):
        missed, outside = list(rests), ""
        for k, point in enumerate(points):
            place = [real_at(coordinate, values) for coordinate in point]
            if any(coordinate is None for coordinate in place):
                outside = "; what your answer gives is not real"
                continue
            place = _rounded_inside(family.reduced(np.array(place)), point, family)
            if not family.inside(place):
                outside = f"; {_place_told(family.state, place)}, which your answer gives, lies outside the domain"
                continue
            met[k] = True
            open_ = [uncertain_at(coordinate, values) for coordinate in point]
            here = [j for j, rest in enumerate(missed) if family.same(place, rest, point, open_)]
            if not here:
                if any(family.same(place, rest, point, open_) for rest in rests):
                    raise Wrong(f"for {sample_text(values)} two of your points are the same")
                rates = family(place, numbers)
                if not rests and np.all(abs(rates) < 1e-9):
                    continue  # the search may have missed it
                told = (
                    f"sides are {_vector_told(rates)}"
                    if len(rates) > 1
                    else f"side is {rates[0]:.4g}"
                )
                raise Wrong(
                    f"for {sample_text(values)} your answer gives "
                    f"{_place_told(family.state, place)}; the right-hand {told} there, not zero"
                )
            del missed[here[0]]
        if missed:
            raise Wrong(
                f"for {sample_text(values)} there is a {noun} in the domain that your answer does "
                f"not give{outside}"
            )
    if not all(met):
        raise Wrong(
            f"point {met.index(False) + 1} of your list lies in the domain for none of the sample "
            "values"
        )
    return (
        f"for sample values of the parameters it gives every {noun} in the domain and nothing else"
    )


def _rounded_inside(place, written, family):
    """A place whose decimals were rounded to the other side of the border of the domain, on the
    border."""
    for k, (symbol, coordinate) in enumerate(zip(family.state, written)):
        low, high = ends(symbol, family.domain)
        for end in (low, high) if in_decimals(coordinate) and not low <= place[k] <= high else ():
            if math.isfinite(end) and abs(place[k] - end) <= half_unit(end):
                place[k] = end
    return place


def _judge_existence(answer, family, noun):
    def at(values):
        numbers = family.numbers(values)
        return (
            None if numbers is None else bool(family.settle(numbers, starts=32, steps=40)[1].any())
        )

    def told(values, holds):
        return (
            f"for {place_text(values)} there is {'a' if holds else 'no'} {noun}, yet your "
            f"condition {'does not hold' if holds else 'holds'}"
        )

    given, rest = family.given, family.at_rest
    truth = Truth(
        (Case(sp.And(given, rest), tuple(family.state)),),
        (Case(sp.And(given, sp.Not(rest)), tuple(family.state), every=True),),
        at,
    )
    agreement = compare(answer, family.parameters, truth, told)
    return f"there is a {noun} exactly for these parameters: {agreement}"


def _judge_roots(answer, field, state, parameters, domain, sign):
    """Compare a condition with the sign of the discriminant: -1 focus, 1 node."""
    if domain is None and is_angle_equation(field, state):
        return judge_angle_roots(answer, field, state, parameters, sign)
    return _judge_point_roots(
        answer,
        rest_points(field, state, parameters, domain),
        sign,
        "a node" if sign > 0 else "a focus",
    )


def _judge_point_roots(answer, family, sign, noun):

    def at(values):
        numbers = family.numbers(values)
        if numbers is None:
            return None
        places, exist = family.first_rests(numbers)
        ((a,), (b,)), ((c,), (d,)) = family.jacobian(places, numbers)
        trace, determinant, size = a + d, a * d - b * c, a**2 + b**2 + c**2 + d**2
        discriminant = trace**2 - 4 * determinant
        decided = (
            abs(discriminant) > 1e-9 * size
            and abs(determinant) > 1e-9 * size
            and trace**2 > 1e-9 * size
        )
        return (
            bool(np.sign(discriminant) == sign and determinant > 0)
            if exist[0] and decided
            else None
        )

    def told(values, holds):
        return (
            f"for {place_text(values)} the stationary point is {'' if holds else 'not '}{noun}, "
            f"yet your condition {'does not hold' if holds else 'holds'}"
        )

    _, determinant, discriminant = family.invariants
    decided = sp.And(family.given, family.at_rest, *(sp.Ne(x, 0) for x in family.invariants))
    truth = exactly(
        sp.And(sign * discriminant > 0, determinant > 0), decided, tuple(family.state), at
    )
    agreement = compare(answer, family.parameters, truth, told)
    return f"the stationary point is {noun} exactly for these parameters: {agreement}"


def _points(answer, family):
    """A list of points, each a list of expressions, from one point or a list of them."""
    n = len(family.state)

    def single(point):
        point = in_order(point, family.state)
        if n == 1 and not isinstance(point, VECTORS):
            point = [point]
        return coercion.as_expressions(point, family.parameters, length=n)

    if isinstance(answer, sp.MatrixBase) and 1 not in answer.shape:
        answer = [list(answer.row(k)) for k in range(answer.rows)]
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()
    if isinstance(answer, (set, frozenset, sp.FiniteSet)):
        return [single(point) for point in answer]
    if isinstance(answer, (list, tuple)) and (
        n == 1 or any(isinstance(point, (dict, *VECTORS)) for point in answer)
    ):
        if (
            n > 1
            and len(answer) == n
            and all(isinstance(p, (list, tuple)) and len(p) == 1 for p in answer)
        ):
            return [single(answer)]  # a column
        points = [single(point) for point in answer]
        if not points:
            raise Invalid("expected at least one point")
        return points
    return [single(answer)]


def _cycles(radius):
    return {radius: sp.Interval.open(0, sp.oo)}


def _within_reach(values, places):
    """Values, a row for each expression, and places without those where a value is too large for a
    float."""
    fits = ~np.isinf(values).any(axis=0)
    if not fits.any():
        raise Invalid("your answer has no values of a size that can be computed with")
    return np.array(values)[:, fits], places[:, fits]


def _values(expression, symbols, places):
    """An expression at many places; nan where it is not real, inf where a float cannot hold it.
    Symbols and functions are known (`coercion.with_symbols`)."""
    if expression.has(sp.nan, sp.zoo):
        return np.full(places.shape[1], math.nan)
    # The slope of a Max holds steps, for which SymPy would solve inequalities.
    expression = expression.replace(sp.Heaviside, lambda x, *_: (1 + sp.sign(x)) / 2)
    try:
        function = sp.lambdify(symbols, expression, "mpmath")
    except (ValueError, NotImplementedError):  # the slope of a floor
        return np.full(places.shape[1], math.nan)

    def value(place):
        try:
            found = function(*place)
            number = complex(found)
        # TypeError: a Piecewise without a case for this place; NameError: what has no values, as a
        # delta function
        except (ZeroDivisionError, ValueError, OverflowError, TypeError, NameError):
            return math.nan
        if cmath.isinf(number) and isinstance(found, mpmath.mpf) and mpmath.isfinite(found):
            return math.inf
        return (
            number.real
            if cmath.isfinite(number) and abs(number.imag) < 1e-9 * (1 + abs(number))
            else math.nan
        )

    return np.array([value(place.tolist()) for place in places.T])


def _scale(expression, values, state, rest):
    """The size of the terms of an expression at a place: their sum may cancel."""
    numbers = values | {x: sp.Float(float(v), 20) for x, v in zip(state, rest)}
    return sum(
        abs(real_at(term, numbers) or 0.0) for term in sp.Add.make_args(sp.expand(expression))
    )


def _kind(matrix):
    """The type of the stationary point whose first approximation is this matrix."""
    trace, determinant, size = np.trace(matrix), np.linalg.det(matrix), np.linalg.norm(matrix)
    if abs(determinant) < 1e-9 * size**2:
        raise RuntimeError("the first approximation has a root zero: it does not decide the type")
    if determinant < 0:
        return "saddle"
    if abs(trace) < 1e-9 * size:
        return "centre"
    how = "stable" if trace < 0 else "unstable"
    discriminant = trace**2 - 4 * determinant
    if abs(discriminant) < 1e-8 * size**2:
        star = np.linalg.norm(matrix - trace / 2 * np.eye(2)) < 1e-6 * size
        return f"{how} {'star' if star else 'degenerate node'}"
    return f"{how} {'node' if discriminant > 0 else 'focus'}"


def _place_told(state, place):
    return ", ".join(f"{s} = {x:.4g}" for s, x in zip(state, place))


def _vector_told(values):
    """Numbers for a message; what rounding leaves of a zero is one."""
    size = max(abs(value) for value in values)
    return point_text([value if abs(value) > 1e-12 * size else 0.0 for value in values])
