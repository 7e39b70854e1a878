"""Transfers in least or greatest time: initial states, times and numbers of switchings.

`problem` is a `pontryagin.Problem` whose cost is the time. Its parameters are a list; a state without
an initial value that is one of them is the symbol of its initial value. Optimal controls, motions,
costates and times are judged in `optimal_controls`, `optimal_motions`, `costates` and
`optimal_values`. The optimum comes from `transfer_optima`, which uses neither the maximum principle
nor shooting.
"""

import functools
import math

import numpy as np
import sympy as sp

from workbook.checks.contract import coercion
from workbook.checks.contract.claims import Expression, Number
from workbook.checks.contract.direction import directed
from workbook.checks.contract.shapes import COMMON
from workbook.checks.contract.tolerance import agree, in_decimals
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.time_functions import INTEGRATED
from workbook.checks.references.optima.transfer_optima import CLOSE, SAMPLES, Transfer
from workbook.checks.tools.comparisons import SameValue
from workbook.checks.tools.conditions import compare, contradiction_message, exactly
from workbook.checks.tools.substitution import real_at
from workbook.checks.tools.values import no_number_text, uncertainty_at
from workbook.checks.tools.wording import values_text


@judged(Expression("count"))
def meeting_time(claim, problem, count):
    """Check the least, or greatest, time of the meeting number `count` with the target.

    An initial state on the target is the meeting number 0.
    """
    transfer = Transfer(problem)
    shortest = transfer.at({}).duration
    for number in (0, 1, 2, 3, 7):
        claimed = real_at(claim, {count: number})
        best = transfer.at({}, meetings=number)
        if claimed is None or not (
            _close(claimed, best.duration, claim) if number else abs(claimed) < 1e-9 * shortest
        ):
            if number == 0:
                raise Wrong(
                    f"the initial state lies on the target already; for {count} = 0 your expression "
                    "does not give the initial time"
                )
            message = (
                no_number_text(claim, {count: number})
                if claimed is None
                else f"{claimed:.4g}; {best.duration_message(claimed)}"
            )
            raise Wrong(f"for {count} = {number} your time is {message}")
    return "it is the time of this meeting, for several numbers"


@judged(Expression("angle", "problem.controls"))
def polar_angle_rate(claim, problem, angle):
    """Check the rate of the polar angle of a planar state, in the angle and the control.

    Can decide when the system is homogeneous of first degree in two states, at random states and
    controls.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> angle = sp.Symbol("angle", real=True)
    >>> swing = Problem({x: v, v: -u*x}, {u: (1, 4)}, {x: 1, v: 0}, [v], first_return=True)
    >>> checks.polar_angle_rate(-sp.sin(angle)**2 - u*sp.cos(angle)**2, swing, angle).status
    'right'
    >>> checks.polar_angle_rate(-u, swing, angle).status
    'wrong'
    """
    (x, y), ((control, bounds),) = problem.dynamics, problem.controls.items()
    generator = np.random.default_rng(9)
    for _ in range(20):
        theta = generator.uniform(-math.pi, math.pi)
        u = generator.uniform(*map(float, bounds))
        r = generator.uniform(0.3, 3)
        point = {x: r * math.cos(theta), y: r * math.sin(theta), control: u}
        rates = [float(f.subs(point)) for f in problem.dynamics.values()]
        terms = np.array([point[x] * rates[1], -point[y] * rates[0]]) / r**2
        values = {angle: sp.Float(theta, 20), control: sp.Float(u, 20)}
        quantity = "the rate at which the direction of the state turns"
        yield SameValue(claim, terms.sum(), quantity, values, np.abs(terms).max())
    return "it is the rate at which the direction turns, at random states and controls"


@judged(Expression("problem.dynamics"))
def least_rate(claim, quantity, problem):
    """Check the least rate of change of a quantity that an admissible control can give.

    It is an expression in the state.

    Can decide when the quantity is differentiable at random states, where all admissible controls
    are compared.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> grow = Problem({x: x + u}, {u: (-1, 1)}, {x: None}, [x])
    >>> checks.least_rate(sp.Abs(x) - 1, sp.Abs(x), grow).status
    'right'
    >>> checks.least_rate(x - 1, sp.Abs(x), grow).status
    'wrong'
    """
    state, ((control, bounds),) = list(problem.dynamics), problem.controls.items()
    slope = sum(sp.diff(quantity, x) * f for x, f in problem.dynamics.items())
    generator = np.random.default_rng(3)
    for k in range(20):
        point = {
            x: sp.Rational(int(generator.integers(2, 60)), 13) * int(generator.choice((-1, 1)))
            for x in state
        }
        if k >= 16:
            point = {x: value * CLOSE for x, value in point.items()}
        rates = [float(slope.subs(point).subs(control, u)) for u in bounds]
        quantity = "the least of the rates that the admissible controls give"
        yield SameValue(claim, min(rates), quantity, point, max(map(abs, rates)))
    return "it is the least of the rates that the admissible controls give, at random states of both signs"


@judged(parameters=COMMON["parameters"])
def transferable_initial_states(answer, problem, parameters):
    """Check the initial states, or parameters, for which the target can be reached.

    An initial state on the target counts either way.

    Can decide when the cost is the time of one control with two bounds and the target is the
    origin, a line through it, or a value of the only state; the condition is compared for all
    parameters where it is polynomial.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> grow = Problem({x: x + u}, {u: (-1, 1)}, {x: None}, [x])
    >>> checks.transferable_initial_states(sp.Abs(x) < 1, grow, [x]).status
    'right'
    >>> checks.transferable_initial_states(sp.Abs(x) <= 1, grow, [x]).status
    'wrong'
    """
    transfer, reference = _reachable(problem, tuple(parameters))
    agreement = compare(
        answer, parameters, reference, contradiction_message(transfer.solvable_message)
    )
    return f"it agrees with what the controls can reach: {agreement}"


@functools.lru_cache(maxsize=32)
def _reachable(problem, parameters):
    """Return a transfer and the condition that its target can be reached, for all answers."""
    transfer = Transfer(problem, parameters)
    return transfer, exactly(
        transfer.solvable_condition(), transfer.off_target(), at=transfer.solvable
    )


@judged(parameters=COMMON["parameters"])
def reachable_in_time(answer, problem, duration, parameters):
    """Check the condition for the target to be reached in a time not longer than `duration`.

    It is a condition on the parameters and the symbol `duration`.

    Can decide when the cost is the time of one control with two bounds and the target is the
    origin, a line through it, or a value of the only state; for all parameters where the condition
    is polynomial.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, u, b = sp.symbols("x u b", real=True)
    >>> T = sp.Symbol("T", positive=True)
    >>> move = Problem({x: u}, {u: (-1, 1)}, {x: b}, [x])
    >>> checks.reachable_in_time(sp.Abs(b) <= T, move, T, [b]).status
    'right'
    >>> checks.reachable_in_time(sp.Abs(b) <= 2*T, move, T, [b]).status
    'wrong'
    """
    transfer = Transfer(problem, parameters)
    samples = list(transfer.samples())

    def points():
        for values, best in samples:
            for part in (0.3, 0.999, 1.001, 4):
                yield {duration: sp.Rational(f"{best.duration * part:.9g}"), **values}

    def in_time(point):
        values = {p: point[p] for p in parameters}
        return (
            next(best for sample_values, best in samples if sample_values == values).duration
            <= point[duration]
        )

    reference = exactly(transfer.in_time_condition(duration), at=in_time, points=points)
    agreement = compare(
        answer,
        [duration, *parameters],
        reference,
        lambda values, holds: (
            f"for {values_text(values)} the target {'can' if holds else 'cannot'} be reached in "
            f"time; your condition {'does not hold' if holds else 'holds'}"
        ),
    )
    return f"it separates the times that suffice from those that do not: {agreement}"


@judged(parameters=COMMON["parameters"])
def switching_count(answer, problem, parameters=()):
    """Check how often the fastest control switches, as an expression in the parameters.

    It is not compared where all of the parameters are whole numbers.

    Without parameters: the greatest number of switchings of a fastest transfer from any initial
    state.

    Can decide when the cost is the time of one control with two bounds and the target is the
    origin or a line through it, from sample initial states.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: None, v: None}, [x, v])
    >>> checks.switching_count(1, cart).status
    'right'
    >>> checks.switching_count(0, cart).status
    'wrong'
    """
    if not parameters:
        return _judge_greatest_count(coercion.as_integer(answer), problem)
    claim = coercion.as_expression(answer, parameters)
    transfer = Transfer(problem, parameters)
    for values, best in transfer.samples(4 * SAMPLES):
        if all(value.is_integer for value in values.values()):
            # The number may differ at exceptional initial states, on a switching curve.
            continue
        claimed = real_at(claim, values)
        count = best.switchings()
        if claimed is None or not abs(claimed - count) <= 1e-9:
            message = no_number_text(claim, values) if claimed is None else f"{claimed:.4g}"
            raise Wrong(
                f"for {values_text(values)} your expression gives {message}; this is not how "
                "often the fastest control switches"
            )
    return f"it counts the switchings of the fastest control for {4 * SAMPLES} initial states"


def _judge_greatest_count(claim, problem):
    transfer = Transfer(problem, [x for x in problem.dynamics if problem.initial.get(x) is None])
    greatest = max(best.switchings() for _, best in transfer.samples(4 * SAMPLES))
    if claim < greatest:
        failure = f"there are initial states from which the fastest control switches more often than {_times(claim)}"
    elif claim > greatest:
        failure = (
            f"among {4 * SAMPLES} initial states there is none from which the fastest control switches as "
            f"often as {_times(claim)}"
        )
    else:
        return f"the fastest controls from {4 * SAMPLES} initial states confirm it"
    raise Wrong(directed(failure, f"{claim} is not the greatest number of switchings"))


@judged(Number(), parameters=COMMON["parameters"])
def switching_interval(claim, problem, parameters):
    """Check the time between two switchings of fastest controls, where it is always the same.

    Can decide when the cost is the time of one control with two bounds and the target is the
    origin, from sample initial states.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> swing = Problem({x: v, v: u - x}, {u: (-1, 1)}, {x: None, v: None}, [x, v])
    >>> checks.switching_interval(sp.pi, swing, [x, v]).status
    'right'
    >>> checks.switching_interval(2*sp.pi, swing, [x, v]).status
    'wrong'
    """
    intervals = [
        b - a
        for _, best in Transfer(problem, parameters).samples(4 * SAMPLES)
        for a, b in zip(best.breaks(), best.breaks()[1:])
    ]
    if not intervals or max(intervals) - min(intervals) > 1e-3 * max(intervals):
        raise UnsuitableData("problem: the intervals between switchings differ")
    if not _close(
        float(claim),
        float(np.mean(intervals)),
        claim,
        0 if in_decimals(claim) else 4 * max(intervals),
    ):
        raise Wrong(
            f"fastest controls from {len(intervals)} initial states do not switch at such intervals"
            + directed(f": yours is too {'short' if float(claim) < min(intervals) else 'long'}", "")
        )
    return f"the fastest controls switch at such intervals, {len(intervals)} times"


@judged(Expression("count"))
def isochrone_radius(claim, problem, duration, count):
    """Check the radius of the circle of initial states whose least time is `duration`.

    It is an expression in the whole number `count`.

    Can decide when the system is linear in two states, the target is the origin and the states
    that need this time lie on a circle.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> n = sp.Symbol("n", integer=True, positive=True)
    >>> swing = Problem({x: v, v: u - x}, {u: (-1, 1)}, {x: None, v: None}, [x, v])
    >>> checks.isochrone_radius(2*n, swing, sp.pi*n, n).status
    'right'
    >>> checks.isochrone_radius(n, swing, sp.pi*n, n).status
    'wrong'
    """
    transfer = Transfer(problem, list(problem.dynamics))
    for number in range(1, 6):
        claimed = real_at(claim, {count: number})
        radii = transfer.reach(float(sp.sympify(duration).subs(count, number)))
        if max(radii) - min(radii) > 1e-3 * max(radii):
            raise UnsuitableData("problem: this isochrone is no circle")
        if claimed is None or not _close(
            claimed, float(np.mean(radii)), claim, uncertain=uncertainty_at(claim, {count: number})
        ):
            reason = no_number_text(claim, {count: number})
            message = f"is {reason}" if claimed is None else f"is {claimed:.4g}"
            raise Wrong(
                f"for {count} = {number} your radius {message}; the farthest initial states from which the "
                "origin can be reached in that time lie "
                + directed(
                    "farther out" if claimed is not None and claimed < min(radii) else "closer",
                    "elsewhere",
                )
            )
    return "all around the origin the initial states that need this time lie at that distance"


def _close(claimed, true, claim, size=0.0, uncertain=None):
    """Return whether a claim agrees to the accuracy of the optimum, decimals to three digits."""
    return agree(claimed, true, claim, size, computed=2 * INTEGRATED, uncertain=uncertain)


def _times(count):
    return {0: "never", 1: "once", 2: "twice"}.get(int(count), f"{count} times")
