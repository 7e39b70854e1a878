"""Feedback laws for time-optimal control, judged against an independent optimum.

The optimum is that of `fastest_times`: the plant is x' = Ax + bu with u between two bounds, the
target a point, a segment, a line, or the border of a convex set. A law is optimal if it needs no
longer time.

`system` is a record `workbook.systems.Controlled`, linear in two states. `target` lists the
expressions that vanish at the end, [x1, x2] for the origin, [x1**2 + x2**2 - R**2] for a circle, or
number pairs, for the segment between them. `parameters` is a dict from symbols to SymPy intervals,
or finite sets where few cases suffice. `start` is a condition on the initial state, such as
x1**2 + x2**2 > R**2.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import ConditionOn, Expression
from workbook.checks.contract.direction import directed
from workbook.checks.contract.tolerance import in_decimals
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.closed_loop import EQUAL_CONTROLS, Law, follow
from workbook.checks.pontryagin.synthesis_units import control_unit, in_natural_units, time_unit
from workbook.checks.pontryagin.target_points import family_of
from workbook.checks.references.optima.sampled_optimum import sampled_optimum, synthesis_data
from workbook.checks.tools.conditions import readings
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.values import left_open
from workbook.checks.tools.wording import NO_NUMBER, value_text


@judged(Expression("system.state", "parameters", lambda data: (data["curve"] or ())[:1]))
@in_natural_units(control_unit)
def time_optimal_law(claim, system, target, parameters=None, start=None, curve=None):
    """Check a time-optimal law u(state).

    It brings every initial state from which the target can be reached there in the shortest
    time.

    `curve` = (symbol, abscissa, ends, variable, interval) lets the law use a switching curve
    that has no elementary equation: the symbol is the second coordinate of this curve where its
    first one is `abscissa`; the rest is as in `switching_points`.
    """
    return _time_optimal(
        claim,
        synthesis_data(system, target, parameters, start),
        curve and (*curve[:2], tuple(map(sp.sympify, curve[2])), *curve[3:]),
    )


@functools.lru_cache(maxsize=64)
def _time_optimal(claim, data, curve):
    """Return the message on an optimal law, cached since a law is often judged again."""
    reference, control = sampled_optimum(*data), data.control
    if curve:
        parameters = dict(data.parameters)
        ends = family_of(data._replace(parameters=(*data.parameters, curve[3:])), *curve[2:4])
        curve = curve[0], sp.lambdify([*data.state, *parameters], curve[1], "numpy"), ends
    law, *readings_of_law = [
        Law(reading, reference, curve) for reading in (claim, *readings(claim))
    ]
    decimals = in_decimals(claim)
    batch = reference.batch(decimals)
    values = law(batch.x, batch.case)
    low, high = reference.plant.bounds
    for k in np.flatnonzero(~np.isfinite(values)):
        raise Wrong(f"{reference.start_text(batch, k)} your law gives {NO_NUMBER}")
    for k in np.flatnonzero((values < low - EQUAL_CONTROLS) | (values > high + EQUAL_CONTROLS)):
        raise Wrong(
            f"{reference.start_text(batch, k)} your law gives {control} = {values[k]:.4g}, outside its bounds"
        )
    _judge_on_extremals(readings_of_law, reference, control)
    differing = np.flatnonzero(abs(values - batch.control) > EQUAL_CONTROLS)
    # Initial states far from the switching curve come first: there a law loses most time.
    differing = differing[np.argsort(-abs(batch.switching[differing]))]
    while len(differing):
        subset, differing = differing[:3], differing[3:]
        subset = batch.take(subset[reference.robust(batch.take(subset), decimals)])
        if not len(subset.x):
            continue
        follow(law, reference, subset)
        if reference.beside_barrier(subset.take(slice(0, 1)))[0]:
            continue
        raise _not_first(reference, subset, 0, control, law(subset.x, subset.case)[0])
    _judge_next_to_curves(readings_of_law, reference, control)
    _judge_change(law, reference, batch, control)
    followed = reference.cache.setdefault("followed", set())
    if (claim, str(curve)) not in followed:
        follow(law, reference, batch)
        followed.add((claim, str(curve)))
    return f"from {len(batch.x)} initial states, some of them next to the switching curve, it needs the shortest time"


def _not_first(reference, batch, k, control, value):
    """Return the exception on a value of a law with which no fastest motion begins."""
    text = f"{control} = {value:.4g}" if np.isfinite(value) else NO_NUMBER
    return Wrong(
        f"{reference.start_text(batch, k)} your law gives {text}, and the fastest motion from there "
        "does not begin with it"
    )


def _judge_next_to_curves(laws, reference, control):
    """Raise `Wrong` where all readings of a law differ from the optimum near a switching curve.

    The time cannot decide there, since a wrong law loses hardly any.
    """
    batch = reference.next_to_curves()
    if batch is None:
        return
    claimed = np.array([law(batch.x, batch.case) for law in laws])
    differ = np.flatnonzero((abs(claimed - batch.control) > EQUAL_CONTROLS).all(axis=0))
    # Close to a barrier the computed optimum may have missed a thin target too.
    if len(differ) and reference.convex.kind == "hull":
        differ = differ[~reference.beside_barrier(batch.take(differ), far=True)]
    for k in differ[:1]:
        raise _not_first(reference, batch, k, control, claimed[0][k])


def _judge_on_extremals(laws, reference, control):
    """Raise `Wrong` where all readings of a law differ from the control of an extremal.

    The states are close to the target or far out.
    """
    batch, _ = reference.extremals() or (None, None)
    if batch is None:
        return
    claimed = np.array([law(batch.x, batch.case) for law in laws])
    differ = np.flatnonzero(~(abs(claimed - batch.control) <= EQUAL_CONTROLS).any(axis=0))
    # The message names a state that is neither small nor large, where motions are easiest to see.
    for k in sorted(differ, key=lambda k: abs(np.log(np.linalg.norm(batch.x[k]))))[:1]:
        raise _not_first(reference, batch, k, control, claimed[0][k])


def _judge_change(law, reference, batch, control):
    """Raise `Wrong` for a law with values between the bounds where it should jump between them."""
    claimed, (low, high) = law(batch.x, batch.case), reference.plant.bounds
    ends = (np.flatnonzero(abs(claimed - bound) < EQUAL_CONTROLS)[:40] for bound in (low, high))
    pairs = np.array(
        [
            (a, b)
            for a, b in itertools.product(*ends)
            if batch.case[a] == batch.case[b] and batch.inside[a] == batch.inside[b]
        ][::7]
    )
    if not len(pairs):
        return
    case = batch.case[pairs[:, 0]]
    ends = bisect(
        lambda x, rows: law(x, case[rows]) < low + (high - low) / 4, *batch.x[pairs.T], 45
    )
    between = [
        (low + EQUAL_CONTROLS < law(x, case)) & (law(x, case) < high - EQUAL_CONTROLS) for x in ends
    ]
    stepped = between[0] & between[1] & reference.allowed(ends[1], case)
    optima = reference.solve(ends[1][stepped], case[stepped])
    for k in np.flatnonzero(np.isfinite(optima.time)):
        raise _not_first(reference, optima, k, control, law(optima.x, optima.case)[k])


@judged(Expression("system.state", "parameters"))
@in_natural_units(time_unit)
def minimal_time(claim, system, target, parameters=None, start=None):
    """Check the shortest time to the target as an expression in the initial state.

    It is compared where the target can be reached.

    Can decide when the system is linear in two states with one bounded control, and the target is
    a point, a line, a segment or the border of a convex set.

    Examples
    --------
    >>> from workbook.systems import Controlled
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> cart = Controlled({x: v, v: u}, {u: (-1, 1)})
    >>> side = sp.sign(x + v*sp.Abs(v)/2)
    >>> checks.minimal_time(side*v + 2*sp.sqrt(v**2/2 + side*x), cart, [x, v]).status
    'right'
    >>> checks.minimal_time(2*sp.sqrt(sp.Abs(x)), cart, [x, v]).status
    'wrong'
    """
    reference = sampled_optimum(*synthesis_data(system, target, parameters, start))
    batch = reference.batch(in_decimals(claim))
    claimed = Law(claim, reference)(batch.x, batch.case)
    uncertainty = left_open([claim], lambda parts: Law(*parts, reference)(batch.x, batch.case))
    allowed = 1e-4 * batch.time + 1e-6 + uncertainty
    agrees = np.isfinite(claimed) & (abs(claimed - batch.time) <= allowed)
    for k in np.flatnonzero(~agrees):
        message = value_text(claimed[k])
        reason = directed(
            ", which no motion can do"
            if claimed[k] < batch.time[k]
            else ", but a motion can be faster",
            ", which is not the shortest time",
        )
        raise Wrong(
            f"{reference.start_text(batch, k)} your expression gives {message}"
            + (reason if np.isfinite(claimed[k]) else "")
        )
    return f"it is the shortest time from {len(batch.x)} initial states"


@judged(ConditionOn("system.state", "parameters"))
@in_natural_units()
def reachable_initial_states(claim, system, target, parameters=None, start=None):
    """Check the condition on the initial state under which the target can be reached.

    The border of the set counts either way.
    """
    reference = sampled_optimum(*synthesis_data(system, target, parameters, start))
    batch = reference.border(in_decimals(claim))
    claimed = reference.condition(claim)(batch.x, batch.case)
    reached = np.isfinite(batch.time)
    differs = np.flatnonzero(claimed != reached)[:12]
    for k in differs[~reference.on_border(batch.take(differs))] if len(differs) else ():
        raise Wrong(
            f"{reference.start_text(batch, k)} the target "
            + (
                "can be reached"
                if reached[k]
                else "cannot be reached: a line separates it from all states that can be reached, at every time"
            )
            + "; your condition gives the opposite"
        )
    return f"it agrees with the reachable sets from {len(claimed)} initial states, many of them close to the border"
