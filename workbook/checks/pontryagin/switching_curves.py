"""Curves in the plane on which time-optimal control switches, divides or jumps.

The fastest times and controls are compared on both sides of a curve; the data are those of
`syntheses`.
"""

import functools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import agree, in_decimals, perturbed
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.synthesis_units import in_natural_units, ordinate_unit
from workbook.checks.references.optima.sampled_optimum import (
    BESIDE,
    BESIDE_DECIMALS,
    sampled_optimum,
    synthesis_data,
)
from workbook.checks.tools.domains import values_inside
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import summed_changes
from workbook.checks.tools.wording import NO_NUMBER

#: Accuracy of a switching curve, relative to its coordinates.
LOCATED = 1e-4


@judged(Expression("domain", "parameters"))
@in_natural_units(ordinate_unit)
def switching_curve(claim, system, target, domain, parameters=None, start=None, kind="switching"):
    """Check a curve of a time-optimal synthesis over the interval that `domain` gives.

    One state variable is an expression in the other. On a branch of the "switching" curve the control
    changes, from a "dispersal" curve two motions are equally fast, and across a "barrier" the fastest
    time jumps.

    Can decide when the system is linear in two states with one bounded control, and the target is
    a point, a line, a segment or the border of a convex set; optima on both sides are compared.

    Examples
    --------
    >>> from workbook.systems import Controlled
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> cart, near = Controlled({x: v, v: u}, {u: (-1, 1)}), {v: sp.Interval(-3, 3)}
    >>> checks.switching_curve(-v*sp.Abs(v)/2, cart, [x, v], near).status
    'right'
    >>> checks.switching_curve(-v*sp.Abs(v), cart, [x, v], near).status
    'wrong'
    """
    if kind not in KINDS:
        raise UnsuitableData(f"kind: expected one of {', '.join(KINDS)}, got {kind}")
    return _judge(kind, claim, *domain.items(), synthesis_data(system, target, parameters, start))


@functools.lru_cache(maxsize=64)
def _judge(kind, *curve):
    """Return the message on a curve of a kind, cached since a curve is often judged again."""
    return KINDS[kind](*curve)


def _judge_switching(*curve):
    points = list(_sides_of(*curve, (1.0,)))
    for message, (first,), (second,), away in points:
        if first.control == second.control:
            raise Wrong(f"{message} of your curve the optimal control is the same on both sides")
        if away:
            raise Wrong(
                f"{message} of your curve the fastest motions leave the curve on both sides: it is no "
                "place where they switch"
            )
    _require_change_on_curve(points, *curve)
    _require_extremal_switchings(*curve)
    return "optimal motions cross the curve, or follow it, and change their control there, at sample points"


def _judge_dispersal(*curve):
    points = list(_sides_of(*curve, (1.0,)))
    for message, (first,), (second,), away in points:
        if first.control == second.control or not away:
            raise Wrong(f"{message} of your curve the fastest motions from both sides do not part")
    for (message, *_), first_time, second_time in zip(
        points, *_require_change_on_curve(points, *curve)
    ):
        if not abs(first_time - second_time) <= 1e-3 * first_time:
            raise Wrong(f"{message} of your curve the fastest times differ on the two sides")
    return "on both sides the fastest motions leave the curve, and their times agree on it, at sample points"


def _require_extremal_switchings(claim, domain, data):
    """Raise `Wrong` where a curve does not contain the switching points of extremals.

    Only curves on both sides of a target point are compared, close to the target and far out.
    """
    reference, (variable, interval) = sampled_optimum(*data), domain
    index = data.state.index(variable)
    _, batch = reference.extremals() or (None, None)
    if batch is None or not all(
        interval.inf < reference.convex.corner(k)[index] < interval.sup for k in set(batch.case)
    ):
        return
    symbols = [variable, *dict(data.parameters)]
    cases = np.array(reference.cases, dtype=float).reshape(len(reference.cases), -1)[batch.case]
    numbers, true = (batch.x[:, index], *cases.T), batch.x[:, 1 - index]
    claimed, *sides = (
        real_function(symbols, [expression])(*numbers)[0]
        for expression in (claim, *(side for pair in perturbed(claim) or () for (side,) in pair))
    )
    uncertainty = summed_changes(claimed, zip(sides[::2], sides[1::2]))
    for k in np.flatnonzero(~(abs(claimed - true) <= LOCATED * abs(true) + uncertainty))[:1]:
        raise Wrong(
            f"for {variable} = {numbers[0][k]:.4g} the control of the fastest motions does not "
            "change on your curve, but beside it"
        )


def _require_change_on_curve(points, claim, domain, data):
    """Raise `Wrong` where the control of the fastest motions changes beside a curve.

    Return their times on the two sides of the change.
    """
    reference, index = sampled_optimum(*data), 1 - data.state.index(domain[0])
    first, last = (np.array([point[side][0].x for point in points]) for side in (1, 2))
    control, case = (
        np.array([getattr(optimum, name) for _, (optimum,), *_ in points])
        for name in ("control", "case")
    )
    curve_points = (first + last) / 2
    across = (first - last) / np.linalg.norm(first - last, axis=1)[:, None]
    first, last = bisect(
        lambda x, rows: reference.solve(x, case[rows]).control == control[rows], first, last, 24
    )
    offsets = (((first + last) / 2 - curve_points) * across).sum(axis=1) / across[:, index]
    agrees = agree(
        curve_points[:, index],
        curve_points[:, index] + offsets,
        claim,
        np.linalg.norm(curve_points, axis=1),
        LOCATED,
    )
    for k in np.flatnonzero(~agrees):
        raise Wrong(
            f"{points[k][0]} of your curve the control of the fastest motions does not change on "
            "it, but beside it"
        )
    return [reference.solve(x, case).time for x in (first, last)]


def _judge_barrier(*curve):
    for message, first, second, _ in _sides_of(*curve, (0.04, 0.01)):
        jump, closer_jump = (abs(a.time - b.time) for a, b in zip(first, second))
        # At the border of the reachable set the time may jump to infinity, or grow without bound,
        # which is no jump.
        if np.isinf(jump) and any(
            abs(a.time - b.time) > 0.3 for a, b in (first, second) if np.isfinite(a.time + b.time)
        ):
            raise Wrong(
                f"{message} of your curve the fastest time does not jump: it grows without bound as "
                "the curve is approached"
            )
        # A difference that grows like a square root, as close to a motion that touches the target,
        # would fall to half.
        if not (
            jump > 0.02 and (closer_jump > 0.7 * jump or (np.isinf(jump) and np.isinf(closer_jump)))
        ):
            raise Wrong(
                f"{message} of your curve the fastest time does not jump: close to the curve it is "
                "nearly the same on both sides"
            )
    return "the fastest time jumps across the curve, at sample points"


KINDS = {
    "switching": _judge_switching,
    "dispersal": _judge_dispersal,
    "barrier": _judge_barrier,
}


def _sides_of(claim, domain, data, shares):
    """Yield (text, optima on the first side, on the second, away) for points of a curve.

    The optima are at the distances `shares`; `away` is whether both motions leave the curve.
    """
    reference = sampled_optimum(*data)
    parameters = dict(data.parameters)
    variable, interval = domain
    relative_distance = BESIDE_DECIMALS if in_decimals(claim) else BESIDE / 2
    index = data.state.index(variable)
    function = real_function([variable, *parameters], [claim])
    for case, values in enumerate(reference.cases):
        ends = [
            float(sp.sympify(end).subs(dict(zip(parameters, values))))
            for end in (interval.inf, interval.sup)
        ]
        points = values_inside(*ends, count=9 if len(reference.cases) == 1 else 5)
        step = 1e-6 * (1 + abs(points))
        (ordinates,), (ordinates_ahead,) = (
            function(abscissae, *values) for abscissae in (points, points + step)
        )
        message = "".join(f"for {p} = {v:.4g}, " for p, v in zip(parameters, values))
        for k in np.flatnonzero(~np.isfinite(ordinates + ordinates_ahead)):
            raise Wrong(f"{message}at {variable} = {points[k]:.4g} your curve gives {NO_NUMBER}")
        slope = (ordinates_ahead - ordinates) / step
        curve_points = np.column_stack([points, ordinates] if index == 0 else [ordinates, points])
        normal = np.column_stack(
            [-slope, np.ones_like(slope)] if index == 0 else [np.ones_like(slope), -slope]
        )
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        distance = relative_distance * (0.3 + np.linalg.norm(curve_points, axis=1))[:, None]
        shifts = [sign * share * distance * normal for sign in (1, -1) for share in shares]
        solved = reference.solve(
            np.concatenate([curve_points + shift for shift in shifts]),
            np.full(len(curve_points) * len(shifts), case),
        )
        n, m = len(curve_points), len(shares)
        sides = [
            [solved.take(slice(n * (m * side + k), n * (m * side + k + 1))) for k in range(m)]
            for side in (0, 1)
        ]
        away = [
            sign
            * (
                (side[0].x @ reference.plant.A.T + np.outer(side[0].control, reference.plant.b))
                * normal
            ).sum(axis=1)
            > 0
            for sign, side in zip((1, -1), sides)
        ]
        for k in range(n):
            yield (
                f"{message}at the point ({curve_points[k][0]:.4g}, {curve_points[k][1]:.4g})",
                *([batch.take(k) for batch in side] for side in sides),
                away[0][k] and away[1][k],
            )
