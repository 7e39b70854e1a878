"""Singular arcs: control, costates, surface, order and Kelley condition.

`problem` is a `pontryagin.Problem`; `costates` are the symbols psi_1, ..., psi_n in the order of
its states. The cost has the multiplier lambda_0 = 1: H = psi^T f - f_0, or + f_0 if the cost is
maximised. Points of singular arcs come from `references.singular_arcs`.
"""

import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions, Integer, YesNo
from workbook.checks.contract.members import members
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.sample_points import (
    POINT_ACCURACY,
    SAMPLES,
    ZeroSet,
    as_difference,
    control_bounds,
    is_in_domain,
)
from workbook.checks.references.natural_units import COST, TIME
from workbook.checks.references.singular_arcs import singular_arcs
from workbook.checks.tools.comparisons import SameWord
from workbook.checks.tools.domains import random_value
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import uncertainty_at, value_at
from workbook.checks.tools.wording import rounded_text

#: An angle is looked for on so many turns on either side of zero.
TURNS = 2


@judged(
    Integer(),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def singular_order(claim, problem, costates, control=None):
    """Check the order q of the singular arcs.

    The control appears first in the derivative of order 2q of dH/du.

    Can decide when points of singular arcs can be computed from the data; the derivatives are
    taken there.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> area = Problem({x: u, v: x**2}, {u: (-1, 1)}, {x: 0, v: 0}, final=v, duration=1)
    >>> checks.singular_order(1, area, [p1, p2]).status, checks.singular_order(2, area, [p1, p2]).status
    ('right', 'wrong')
    """
    arcs = _arcs(problem, costates, control)
    if claim != arcs.order:
        raise Wrong(
            f"differentiate dH/du along the trajectories: {arcs.control} does not appear first in "
            f"the derivative of order {2 * int(claim)}"
        )
    return f"{arcs.control} appears first in the derivative of order {2 * arcs.order}"


@judged(problem="pontryagin.Problem with one control, its duration also an interval")
def singular_surface(answer, problem, costates, control=None, domain=None):
    """Check the surface of the singular arcs in states and parameters.

    It is an equation, or a list of equations that hold together; equations joined by Or, of which
    one holds, count as one.

    Can decide when points of singular arcs can be computed from the data; the zeros of the answer
    are compared with them.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> area = Problem({x: u, v: x**2}, {u: (-1, 1)}, {x: 0, v: 0}, final=v, duration=1)
    >>> checks.singular_surface([sp.Eq(x, 0)], area, [p1, p2]).status
    'right'
    >>> checks.singular_surface([sp.Eq(x, 1)], area, [p1, p2]).status
    'wrong'
    """
    arcs = _arcs(problem, costates, control)
    symbols = [*problem.state, *problem.parameters]
    claims = [
        as_difference(part, symbols)
        for part in members(
            answer, "an equation in the states, or several", single=(sp.Expr, sp.Eq, sp.Or)
        )
    ]
    surface = ZeroSet(claims, list(problem.state), list(problem.parameters), arcs.units)
    angles = [x for x in problem.state if _is_angle(x, problem)]
    for values in _points(arcs, domain):
        same_states = list(_same_states(values, angles))
        # Floats may have overflowed, or large terms cancelled.
        if not any(
            distance(same) <= surface.uncertainty(same)
            for distance in (surface.distance, surface.precise_distance)
            for same in same_states
        ):
            raise Wrong("there are singular arcs on which your equation does not hold")
    count = 0
    generator = np.random.default_rng(23)
    for _ in range(6 * SAMPLES):
        values = {
            s: random_value(generator, s, domain, unit=float(arcs.units.get(s, 1))) for s in symbols
        }
        point = surface.zero_near(values)
        if point is None or not is_in_domain(point, domain):
            continue
        share = 20 * surface.uncertainty(point)
        exist = arcs.multipliers_exist(point, share)
        if exist is False:  # floats may have cancelled
            exist = arcs.multiprecision().multipliers_exist(point, share)
        if exist is None or (not exist and surface.precise_distance(point) > share):
            continue
        count += 1
        if not exist:
            raise Wrong(
                f"at {rounded_text(point)} your equation holds, and with no costates this is a "
                "point of a singular arc"
            )
        if count == SAMPLES:
            break
    if not count:
        raise UnsuitableData("domain: no point of the surface could be decided in it")
    return f"singular arcs lie there and nowhere else, tried at {count} points"


@judged(
    Expression("problem.state", "problem.control", "costates", "problem.parameters"),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def singular_control(claim, problem, costates, control=None, domain=None):
    """Check the control on singular arcs, in states and parameters.

    What holds on the arcs may be used.

    Can decide when points of singular arcs can be computed from the data; the control is compared
    there.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> area = Problem({x: u, v: x**2}, {u: (-1, 1)}, {x: 0, v: 0}, final=v, duration=1)
    >>> checks.singular_control(0, area, [p1, p2]).status, checks.singular_control(1, area, [p1, p2]).status
    ('right', 'wrong')
    """
    arcs = _arcs(problem, costates, control)
    without_control, slope = arcs.highest.subs(arcs.control, 0), sp.diff(arcs.highest, arcs.control)
    _without_control(claim, arcs)
    unit = float(arcs.units[arcs.control])
    rate = float(arcs.units[COST] / arcs.units[TIME] ** (2 * arcs.order + 1)) / unit
    for values in _points(arcs, domain):
        a, b = (real_at(e, values) for e in (without_control, slope))
        if b is None or abs(b) * unit < POINT_ACCURACY * (rate + abs(a)):
            continue
        claimed = value_at(claim, values, f"the singular {arcs.control}")
        low, high = control_bounds(problem, values)[list(problem.control).index(arcs.control)]
        # A relative accuracy means nothing for a control that is zero.
        agrees_absolutely = np.isfinite(high - low) and abs(claimed + a / b) <= POINT_ACCURACY * (
            high - low
        )
        if not agrees_absolutely and not agree(
            claimed, -a / b, claim, abs(a / b), POINT_ACCURACY, uncertainty_at(claim, values)
        ):
            raise Wrong(
                f"at a point of a singular arc your control gives {claimed:.4g}, under which "
                f"dH/d{arcs.control} does not stay zero"
            )
    return "it keeps dH/du at zero on singular arcs"


@judged(
    Expressions("problem.state", "problem.control", "problem.parameters", length="costates"),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def singular_costates(claims, problem, costates, control=None, domain=None):
    """Check the costates with lambda_0 = 1 as long as one control is singular.

    They are expressions in states, parameters and the other controls, which lie on their
    bounds; the conditions at the end are not used.
    """
    arcs = singular_arcs(problem, control or problem.control[0], tuple(costates))
    for values in _points(arcs, domain):
        for psi, claim in zip(costates, claims):
            if arcs.control in claim.free_symbols:
                raise Wrong(
                    f"your {psi} depends on {arcs.control}, which can have any value at a "
                    "single instant there"
                )
            claimed = value_at(claim, values, str(psi))
            size = max(abs(values[costate]) for costate in costates)
            if not agree(
                claimed, values[psi], claim, size, POINT_ACCURACY, uncertainty_at(claim, values)
            ):
                raise Wrong(
                    f"for {rounded_text({s: values[s] for s in (*arcs.state, *arcs.other_controls)})} your "
                    f"{psi} is {claimed:.4g}; with it dH/d{arcs.control} does not vanish for a while, "
                    "or H does not"
                )
    return "with them dH/du stays zero, and H is what it has to be"


@judged(
    Expression("problem.state", "problem.control", "costates", "problem.parameters"),
    problem="pontryagin.Problem with any number of controls, its duration also an interval",
)
def kelley_expression(claim, problem, costates, control=None, domain=None):
    """Check the left-hand side of the Kelley condition on singular arcs.

    It is (-1)^q d/du d^(2q)/dt^(2q) dH/du.

    Can decide when points of singular arcs can be computed from the data; the expression is
    compared there.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> area = Problem({x: u, v: x**2}, {u: (-1, 1)}, {x: 0, v: 0}, final=v, duration=1)
    >>> checks.kelley_expression(-2, area, [p1, p2]).status, checks.kelley_expression(2, area, [p1, p2]).status
    ('right', 'wrong')
    """
    arcs = _arcs(problem, costates, control)
    true = (-1) ** arcs.order * sp.diff(arcs.highest, arcs.control)
    _without_control(claim, arcs)
    for values in _points(arcs, domain):
        claimed, uncertain = (
            value_at(claim, values, "Kelley's expression"),
            uncertainty_at(claim, values),
        )
        if not agree(claimed, real_at(true, values), claim, 0, POINT_ACCURACY, uncertain):
            raise Wrong(
                f"at a point of a singular arc your expression gives {claimed:.4g}, which is not the "
                "left-hand side of Kelley's condition there"
            )
    return "it is Kelley's expression on singular arcs"


@judged(
    YesNo(), problem="pontryagin.Problem with any number of controls, its duration also an interval"
)
def kelley_holds(claim, problem, costates, control=None, domain=None):
    """Check whether the Kelley condition holds on the singular arcs.

    Can decide when points of singular arcs can be computed from the data; the sign is taken there.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> p1, p2 = sp.symbols("p1 p2")
    >>> area = Problem({x: u, v: x**2}, {u: (-1, 1)}, {x: 0, v: 0}, final=v, duration=1)
    >>> checks.kelley_holds("yes", area, [p1, p2]).status, checks.kelley_holds("no", area, [p1, p2]).status
    ('right', 'wrong')
    """
    arcs = _arcs(problem, costates, control)
    kelley = (-1) ** arcs.order * sp.diff(arcs.highest, arcs.control)
    signs = {bool(real_at(kelley, values) <= 0) for values in _points(arcs, domain)}
    if len(signs) > 1:
        raise RuntimeError("Kelley's condition holds on a part of the singular arcs")
    yield SameWord(
        claim,
        signs.pop(),
        "look at the sign of (-1)^q d/du d^(2q)/dt^(2q) dH/du on the arc, with lambda_0 = 1",
    )
    return "its sign was looked at on singular arcs"


def _arcs(problem, costates, control):
    arcs = singular_arcs(problem, control or problem.control[0], tuple(costates))
    if arcs.order is None:
        raise UnsuitableData("problem: no derivative of dH/du holds the control")
    return arcs


def _without_control(claim, arcs):
    if arcs.control in claim.free_symbols:
        raise Wrong(
            f"your expression contains {arcs.control} itself, on which nothing depends that is "
            "asked for here"
        )


def _is_angle(x, problem):
    """Return whether a turn more of a state changes nothing in the problem."""
    parts = [*problem.dynamics.values(), problem.running, problem.final, *problem.terminal]
    parts = [part for part in map(sp.sympify, parts) if part.has(x)]
    return bool(parts) and all(part.subs(x, x + 2 * sp.pi) == part for part in parts)


def _same_states(values, angles):
    """Yield a state with each of its angles within a few turns of zero."""
    for turns in itertools.product(range(-TURNS, TURNS + 1), repeat=len(angles)):
        yield values | {x: values[x] % (2 * np.pi) + 2 * np.pi * k for x, k in zip(angles, turns)}


def _points(arcs, domain):
    points = arcs.points(domain)
    if len(points) < 3:
        raise UnsuitableData("domain: no points of singular arcs were found in it")
    return points
