"""Feedback laws for time-optimal control, judged by their effect against an independent optimum.

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
from workbook.checks.contract.tolerance import in_decimals, relative_tolerance
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.closed_loop import SAME, Law, follow
from workbook.checks.pontryagin.target_points import family_of
from workbook.checks.references.optima.sampled_optimum import (
    sampled_optimum,
    synthesis_data,
)
from workbook.checks.tools.conditions import readings
from workbook.checks.tools.line_search import bisect


@judged(Expression("system.state", "parameters", lambda data: (data["curve"] or ())[:1]))
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
    """The sentence on a law that is optimal: a law is often judged again beside another answer."""
    truth, control = sampled_optimum(*data), data.control
    if curve:
        parameters = dict(data.parameters)
        ends = family_of(data._replace(parameters=(*data.parameters, curve[3:])), *curve[2:4])
        curve = curve[0], sp.lambdify([*data.state, *parameters], curve[1], "numpy"), ends
    law, *others = [Law(reading, truth, curve) for reading in (claim, *readings(claim))]
    decimals = in_decimals(claim)
    lanes = truth.batch(decimals)
    values = law(lanes.x, lanes.case)
    low, high = truth.plant.bounds
    for k in np.flatnonzero(~np.isfinite(values)):
        raise Wrong(f"{truth.start_text(lanes, k)} your law gives no real number")
    for k in np.flatnonzero((values < low - SAME) | (values > high + SAME)):
        raise Wrong(
            f"{truth.start_text(lanes, k)} your law gives {control} = {values[k]:.4g}, outside its bounds"
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
            f"{truth.start_text(few, 0)} your law gives {control} = {law(few.x, few.case)[0]:.4g}, and "
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
            f"{truth.start_text(lanes, k)} your law gives {control} = {said[0][k]:.4g}, and the fastest "
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
            f"{truth.start_text(lanes, k)} your law gives {gives}, and the fastest motion from there "
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
    ends = bisect(
        lambda x, rows: law(x, case[rows]) < low + (high - low) / 4, *lanes.x[pairs.T], 45
    )
    between = [(low + SAME < law(x, case)) & (law(x, case) < high - SAME) for x in ends]
    stepped = between[0] & between[1] & truth.allowed(ends[1], case)
    found = truth.solve(ends[1][stepped], case[stepped])
    for k in np.flatnonzero(np.isfinite(found.time)):
        raise Wrong(
            f"{truth.start_text(found, k)} your law gives {control} = {law(found.x, found.case)[k]:.4g}, "
            "and the fastest motion from there begins with another value"
        )


@judged(Expression("system.state", "parameters"))
def minimal_time(claim, system, target, parameters=None, start=None):
    """Check the shortest time to the target as an expression in the initial state.

    It is asked where the target can be reached.
    """
    truth = sampled_optimum(*synthesis_data(system, target, parameters, start))
    lanes = truth.batch(in_decimals(claim))
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
            f"{truth.start_text(lanes, k)} your expression gives {told}"
            + (how if np.isfinite(said[k]) else "")
        )
    return f"it is the shortest time from {len(lanes.x)} starts"


@judged(ConditionOn("system.state", "parameters"))
def reachable_initial_states(claim, system, target, parameters=None, start=None):
    """Check the condition on the initial state under which the target can be reached.

    The border of the set counts either way.
    """
    truth = sampled_optimum(*synthesis_data(system, target, parameters, start))
    lanes = truth.border(in_decimals(claim))
    said = truth.condition(claim)(lanes.x, lanes.case)
    reached = np.isfinite(lanes.time)
    differs = np.flatnonzero(said != reached)[:12]
    for k in differs[~truth.on_border(lanes.take(differs))] if len(differs) else ():
        raise Wrong(
            f"{truth.start_text(lanes, k)} the target "
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
