"""Fastest and slowest transfers: minimal times, controls and motions in time, costates, starts that can be brought to
the target.

A transfer is given as a problem states it: `system`, a record `trajlib.systems.Controlled`, `initial` {state: value},
`terminal` expressions that vanish at the end. The values at the start may be parameters, or the state symbols
themselves where a function of the start is asked for. The optimum comes from `transfer_optima`, where
neither the maximum principle nor a shooting is used.
"""

import math

import numpy as np
import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.claims import Claim, Expression, Integer, Number
from trajlib.checks.contract.tolerance import in_decimals, same, share
from trajlib.checks.contract.verdict import Invalid, Wrong, judged
from trajlib.checks.pontryagin.open_loop import INTEGRATED, Control, Path
from trajlib.checks.tools.conditions import compare, contrary, exactly, place_text
from trajlib.checks.tools.values import real_at, real_function
from trajlib.checks.tools.wording import values_text
from trajlib.checks.truths.optima.transfer_optima import SAMPLES, Transfer

#: Where the end is looked at, as a part of the duration: a law may be defined up to the end alone, which is known up to
#: rounding.
ENDING = 1 - 1e-9


class Motion(Claim):
    """All states as functions of time, or the first of them, where the others are its derivatives: x1' = x2."""

    @staticmethod
    def coerce(answer, symbols, system, time):
        alone = not isinstance(answer, (list, tuple, sp.MatrixBase, sp.Tuple, np.ndarray))
        claims, state = coercion.as_expressions([answer] if alone else answer, symbols), system.state
        if len(claims) not in (1, len(state)):
            raise Invalid(f"expected {state[0]} as an expression in {time}, or all states")
        while len(claims) < len(state):
            if system.dynamics[state[len(claims) - 1]] != state[len(claims)]:
                raise Invalid("expected all states as expressions in time")
            claims.append(sp.diff(claims[-1], time))
        return claims


class Costates(Claim):
    """An expression for each state; of one state the expression alone will do."""

    @staticmethod
    def coerce(answer, symbols, system):
        n = len(system.state)
        alone = n == 1 and not isinstance(answer, (list, tuple, sp.MatrixBase, np.ndarray))
        return coercion.as_expressions([answer] if alone else answer, symbols, n)


@judged(Expression("parameters"))
def fastest_time(claim, system, initial, terminal, parameters=()):
    """The least time of the transfer, as an expression in the parameters."""
    return _judge_time(claim, Transfer(system, initial, terminal, parameters))


@judged(Expression("parameters"))
def slowest_time(claim, system, initial, terminal, parameters=()):
    """The greatest time at which the target can be met for the first time."""
    return _judge_time(claim, Transfer(system, initial, terminal, parameters, slowest=True))


@judged
def fastest_control(answer, system, initial, terminal, time, parameters=()):
    """The control of the fastest transfer: an expression in time and parameters, or a list of arcs [value, until]."""
    return _judge_control(answer, Transfer(system, initial, terminal, parameters), time)


@judged
def slowest_control(answer, system, initial, terminal, time, parameters=()):
    """The control that meets the target for the first time as late as possible, in the same forms."""
    return _judge_control(answer, Transfer(system, initial, terminal, parameters, slowest=True), time)


@judged(Motion("time", "parameters", system="system", time="time"))
def fastest_motion(claim, system, initial, terminal, time, parameters=()):
    """The motion of the fastest transfer: the first state as a function of time, or all states."""
    return _judge_motion(claim, Transfer(system, initial, terminal, parameters), time)


@judged(Motion("time", "parameters", system="system", time="time"))
def slowest_motion(claim, system, initial, terminal, time, parameters=()):
    """The motion that meets the target for the first time as late as possible."""
    return _judge_motion(claim, Transfer(system, initial, terminal, parameters, slowest=True), time)


@judged(Costates("time", "parameters", system="system"))
def fastest_costate(claim, system, initial, terminal, time, parameters=()):
    """The costates along the fastest transfer, with lambda_0 = 1: psi.f = 1 along it."""
    return _judge_costate(claim, Transfer(system, initial, terminal, parameters), time)


@judged(Costates("time", "parameters", system="system"))
def slowest_costate(claim, system, initial, terminal, time, parameters=()):
    """The costates along the slowest transfer, with lambda_0 = 1: psi.f = -1 along it."""
    return _judge_costate(claim, Transfer(system, initial, terminal, parameters, slowest=True), time)


@judged(Expression("time"))
def fastest_switching(claim, system, initial, terminal, time):
    """The switching function dH/du along the fastest transfer to a line, with lambda_0 = 1, as a function of time."""
    return _judge_switching(claim, Transfer(system, initial, terminal, ()), time)


@judged(Expression("time"))
def slowest_switching(claim, system, initial, terminal, time):
    """The switching function dH/du along the slowest transfer to a line, with lambda_0 = 1."""
    return _judge_switching(claim, Transfer(system, initial, terminal, (), slowest=True), time)


@judged(Expression("count"))
def fastest_meeting(claim, system, initial, terminal, count):
    """The least time of the meeting number `count` with the target, a start on the target being the meeting number
    0."""
    return _judge_meetings(claim, Transfer(system, initial, terminal, ()), count)


@judged(Expression("count"))
def slowest_meeting(claim, system, initial, terminal, count):
    """The greatest time of the meeting number `count` with the target, counted in the same way."""
    return _judge_meetings(claim, Transfer(system, initial, terminal, (), slowest=True), count)


@judged(Expression("angle", lambda data: data["system"].control))
def turning_rate(claim, system, angle):
    """The rate of the polar angle of the state of a planar system, as an expression in the angle and the control."""
    (first, second), control, bounds = system.state, system.control, system.bounds
    field = sp.lambdify([first, second, control], system.field, "math")
    random = np.random.default_rng(9)
    for _ in range(20):
        theta, u, r = random.uniform(-math.pi, math.pi), random.uniform(*map(float, bounds)), random.uniform(0.3, 3)
        x = r * math.cos(theta), r * math.sin(theta)
        rates = field(*x, u)
        true = (x[0] * rates[1] - x[1] * rates[0]) / r**2
        said = real_at(claim, {angle: sp.Float(theta, 20), control: sp.Float(u, 20)})
        if said is None or not abs(said - true) <= 1e-9 * (1 + abs(true)):
            told = "no real number" if said is None else f"{said:.4g}"
            raise Wrong(f"at {first} = {x[0]:.4g}, {second} = {x[1]:.4g} with {control} = {u:.4g} the direction turns "
                        f"at the rate "
                        f"{true:.4g}; your "
                        f"expression gives {told}")
    return "it is the rate at which the direction turns, at random states and controls"


@judged
def transfer_starts(answer, system, initial, terminal, parameters):
    """The starts, or parameters, for which the target can be reached; a start on the target may be counted either
    way."""
    transfer = Transfer(system, initial, terminal, parameters)
    truth = exactly(transfer.solvable_condition(), transfer.off_target(), at=transfer.solvable)
    agreement = compare(answer, parameters, truth, contrary(transfer.told_solvable))
    return f"it agrees with what the controls can reach: {agreement}"


@judged
def reached_within(answer, system, initial, terminal, duration, parameters):
    """The condition, in the parameters and the symbol `duration`, for the target to be reached in a time not longer
    than it."""
    transfer = Transfer(system, initial, terminal, parameters)
    found = list(transfer.samples())

    def points():
        for values, best in found:
            for part in (0.3, 0.999, 1.001, 4):
                yield {duration: sp.Rational(best.duration * part).limit_denominator(10**9), **values}

    def in_time(place):
        values = {p: place[p] for p in parameters}
        return next(best for known, best in found if known == values).duration <= place[duration]

    truth = exactly(transfer.in_time_condition(duration), at=in_time, points=points)
    agreement = compare(answer, [duration, *parameters], truth, lambda values, holds: (
        f"for {place_text(values)} the target {'can' if holds else 'cannot'} be reached in time; your condition "
        f"{'does not hold' if holds else 'holds'}"))
    return f"it tells the times that suffice from those that do not: {agreement}"


@judged(Expression(lambda data: data["system"].state))
def least_rate(claim, quantity, system):
    """The least rate of change of a quantity that an admissible control can give, as an expression in the state."""
    state, control, bounds = system.state, system.control, system.bounds
    slope = sum(sp.diff(quantity, x) * f for x, f in system.dynamics.items())
    random = np.random.default_rng(3)
    for _ in range(20):
        place = {x: sp.Rational(int(random.integers(2, 60)), 13) * int(random.choice((-1, 1))) for x in state}
        rates = [float(slope.subs(place).subs(control, u)) for u in bounds]
        said = real_at(claim, place)
        if said is None or not _close(said, min(rates), claim, max(map(abs, rates))):
            told = "no real number" if said is None else f"{said:.4g}"
            raise Wrong(f"for {values_text(place)} the controls {bounds[0]} and {bounds[1]} give the rates "
                        f"{rates[0]:.4g} and "
                        f"{rates[1]:.4g}; "
                        f"your expression gives {told}")
    return "it is the least of the rates that the admissible controls give, at random states of both signs"


@judged(Expression("parameters"))
def switchings(claim, system, initial, terminal, parameters):
    """How often the fastest control switches, as an expression in the parameters; not asked where all of them are whole
    numbers."""
    transfer = Transfer(system, initial, terminal, parameters)
    for values, best in transfer.samples(4 * SAMPLES):
        if all(value.is_integer for value in values.values()):
            continue  # the number may be another one at exceptional starts: those on a switching curve
        said = real_at(claim, values)
        count = best.switchings()
        if said is None or not abs(said - count) <= 1e-9:
            told = "no real number" if said is None else f"{said:.4g}"
            raise Wrong(f"for {values_text(values)} the fastest control switches {_times(count)}; your expression "
                        f"gives {told}")
    return f"it counts the switchings of the fastest control for {4 * SAMPLES} starts"


@judged(Integer())
def most_switchings(claim, system, initial, terminal, parameters):
    """The greatest number of switchings that a fastest transfer needs."""
    transfer = Transfer(system, initial, terminal, parameters)
    most = max((best.switchings(), k) for k, (_, best) in enumerate(transfer.samples(4 * SAMPLES)))[0]
    if claim < most:
        raise Wrong(f"there are starts from which the fastest control switches more often than {_times(claim)}")
    if claim > most:
        raise Wrong(f"among {4 * SAMPLES} starts there is none from which the fastest control switches as often as "
                    f"{_times(claim)}")
    return f"the fastest controls from {4 * SAMPLES} starts confirm it"


@judged(Number())
def switching_interval(claim, system, initial, terminal, parameters):
    """The time between two switchings of fastest controls, where it is the same for all."""
    intervals = [b - a for _, best in Transfer(system, initial, terminal, parameters).samples(4 * SAMPLES)
                 for a, b in zip(best.breaks(), best.breaks()[1:])]
    if max(intervals) - min(intervals) > 1e-3 * max(intervals):
        raise RuntimeError("the intervals between switchings differ")
    if not _close(float(claim), float(np.mean(intervals)), claim, 0 if in_decimals(claim) else 4 * max(intervals)):
        raise Wrong(f"fastest controls from {len(intervals)} starts do not switch at such intervals: yours is too "
                    + ("short" if float(claim) < min(intervals) else "long"))
    return f"the fastest controls switch at such intervals, {len(intervals)} times"


@judged(Expression("count"))
def isochrone_radius(claim, system, terminal, duration, count):
    """The radius of the circle of starts whose least time is `duration`, an expression in the whole number `count`."""
    transfer = Transfer(system, {x: x for x in system.state}, terminal, system.state)
    for number in range(1, 6):
        said = real_at(claim, {count: number})
        radii = transfer.reach(float(sp.sympify(duration).subs(count, number)))
        if max(radii) - min(radii) > 1e-3 * max(radii):
            raise RuntimeError("this isochrone is no circle")
        if said is None or not _close(said, float(np.mean(radii)), claim):
            told = "is no real number" if said is None else f"is {said:.4g}"
            raise Wrong(f"for {count} = {number} your radius {told}; the farthest starts from which the origin can be "
                        f"reached in that "
                        "time lie "
                        + ("farther out" if said is not None and said < min(radii) else "closer"))
    return "all around the origin the starts that need this time lie at that distance"


# How each kind of answer is judged.


def _judge_time(claim, transfer):
    value_of = real_function(transfer.parameters, [claim])
    for values, best in transfer.samples(2 * SAMPLES):
        said = float(value_of(*map(float, values.values()))[0])
        if not np.isfinite(said):
            said = real_at(claim, values)  # a real value may come about through complex ones
        if said is None or not _close(said, best.duration, claim):
            where = f"for {values_text(values)} " if values else ""
            if said is None:
                raise Wrong(where + "your expression gives no real number, though the target can be reached")
            raise Wrong(f"{where}your time is {said:.4g}; " + best.told_time(said))
    return f"it is the {transfer.word} time" + (", for parameters of several sizes and signs" if transfer.parameters
                                                else "")


def _judge_control(answer, transfer, time):
    read = Control(answer, time, transfer.parameters)
    for values, best in transfer.samples():
        where = f"for {values_text(values)} " if values else ""
        sections = read.sections(values, best.duration)
        path = Path(best, sections, where)
        path.admissible(read.rounding)
        miss, size = path.miss()
        if not miss <= read.rounding * size:
            raise Wrong(f"{where}your control does not bring the system to the target at the {transfer.word} time "
                        f"possible: it ends there "
                        "at "
                        f"{_point(path.states[-1])}")
        if transfer.slowest and path.met_before_the_end():
            raise Wrong(f"{where}under your control the target is met before the greatest time possible, and the "
                        f"process ends there")
    return f"it is admissible and meets the target at the {transfer.word} time possible"


def _judge_motion(claims, transfer, time):
    symbols, states = [time, *transfer.parameters], list(transfer.dynamics)
    rates = [sp.diff(claim, time) for claim in claims]
    rounding = share(*claims, computed=INTEGRATED)
    values_of, rates_of = (real_function(symbols, part) for part in (claims, rates))
    for values, best in transfer.samples():
        where = f"for {values_text(values)} " if values else ""
        numbers = [float(values[p]) for p in transfer.parameters]
        size = best.size()
        start = values_of(0.0, *numbers)
        if not np.all(np.abs(start - best.start) <= rounding * size):
            raise Wrong(f"{where}your motion starts at {_point(start)}, not at {_point(best.start)}")
        # Odd fractions keep clear of the instants of switching, where a derivative may not exist.
        for part in np.arange(1, 24) / 24.013:
            t = part * best.duration
            y, rate = values_of(t, *numbers), rates_of(t, *numbers)
            if not np.all(np.isfinite([*y, *rate])):
                raise Wrong(f"{where}your motion is not real at t = {t:.4g}, before it has met the target")
            ends = [best.field(y, u) for u in best.bounds]
            low, high = np.minimum(*ends), np.maximum(*ends)
            slack = 10 * rounding * (np.abs(low) + np.abs(high) + size / best.duration)
            if not (np.all(rate >= low - slack) and np.all(rate <= high + slack)):
                k = int(np.argmax(np.maximum(low - slack - rate, rate - high - slack)))
                raise Wrong(f"{where}at t = {t:.4g} your motion is at {_point(y)} and changes with {states[k]}' = "
                            f"{rate[k]:.4g}; the "
                            "admissible "
                            f"controls give there " + (f"{low[k]:.4g}" if low[k] == high[k]
                                                       else f"{low[k]:.4g} to {high[k]:.4g}"))
            if transfer.slowest and best.met_between(start, y):
                raise Wrong(f"{where}your motion has met the target before t = {t:.4g} already")
        end = values_of(ENDING * best.duration, *numbers)
        if not np.max(np.abs(best.gap(end))) <= 2 * rounding * size:
            raise Wrong(f"{where}your motion is not on the target at the {transfer.word} time possible: it is at "
                        f"{_point(end)} then")
    return (f"it starts where it should, obeys the equations with an admissible control, and is on the target at the "
            f"{transfer.word} time")


def _judge_costate(claims, transfer, time):
    states, symbols = list(transfer.dynamics), [time, *transfer.parameters]
    rounding = share(*claims, computed=INTEGRATED)
    values_of, slopes_of = real_function(symbols, claims), real_function(symbols, [sp.diff(claim, time)
                                                                                   for claim in claims])
    for values, best in transfer.samples():
        where = f"for {values_text(values)} " if values else ""
        numbers = [float(values[p]) for p in transfer.parameters]
        times, path, controls = best.path
        for t, y, u in zip(times, path, controls):
            psi, slope = values_of(t, *numbers), slopes_of(t, *numbers)
            there = f"{where}at t = {t:.4g}"
            if not np.all(np.isfinite([*psi, *slope])):
                raise Wrong(f"{there} your costates are not real")
            terms = -best.jacobian(y, u).T * psi
            wanted, size = terms.sum(axis=1), np.abs(terms).sum() + np.abs(psi).sum() / best.duration
            if not np.all(np.abs(slope - wanted) <= 10 * rounding * size):
                k = int(np.argmax(np.abs(slope - wanted)))
                raise Wrong(f"{there} the adjoint equation for {states[k]} does not hold: the derivative of your "
                            f"costate is "
                            f"{slope[k]:.4g}, the "
                            f"equation with your costates demands {wanted[k]:.4g}")
            products = [psi @ best.field(y, v) for v in best.bounds]
            here = psi @ best.field(y, u)
            size = max(map(abs, products)) + 1e-3
            if not here >= max(products) - 4 * rounding * size:
                raise Wrong(f"{there} the control of the {transfer.manner} motion does not make psi.f greatest with "
                            f"your costates: it "
                            f"gives {here:.4g}, "
                            f"another one {max(products):.4g}")
            if not abs(here - (-1 if transfer.slowest else 1)) <= 4 * rounding * size:
                raise Wrong(f"{there} psi.f is {here:.4g} with your costates; H = 0 with lambda_0 = 1 demands "
                            f"{-1 if transfer.slowest else 1}")
        psi, normal = values_of(ENDING * best.duration, *numbers), best.normals()
        if not np.all(np.isfinite(psi)):
            raise Wrong(f"{where}at the end, t = {best.duration:.4g}, your costates are not real")
        rest = psi - normal.T @ np.linalg.lstsq(normal.T, psi, rcond=None)[0]
        if not np.all(np.abs(rest) <= 4 * rounding * np.abs(psi).sum()):
            raise Wrong(f"{where}at the end your costates are {_point(psi)}; the condition of transversality does not "
                        f"hold for them")
    return f"adjoint equations, maximum condition, transversality and H = 0 hold along the {transfer.manner} motion"


def _judge_meetings(claim, transfer, count):
    for number in (0, 1, 2, 3, 7):
        said = real_at(claim, {count: number})
        best = transfer.at({}, meetings=number)
        if said is None or not (_close(said, best.duration, claim) if number else abs(said) < 1e-9):
            if number == 0:
                raise Wrong(f"the start lies on the target already; for {count} = 0 your expression gives another "
                            f"time than that of the "
                            "start")
            told = "no real number" if said is None else f"{said:.4g}; {best.told_time(said)}"
            raise Wrong(f"for {count} = {number} your time is {told}")
    return f"it is the {transfer.word} time of this meeting, for several numbers"


def _judge_switching(claim, transfer, time):
    best = transfer.at({})
    rounding = share(claim, computed=INTEGRATED)
    value_of = real_function([time], [claim])
    found = best.switching_function()
    size = max(abs(value) for _, value in found)
    for t, true in found:
        said = value_of(t)[0]
        if not abs(said - true) <= 4 * rounding * size:
            raise Wrong(f"at t = {t:.4g} your function is {said:.4g}; dH/du has another "
                        f"{'sign' if said * true < 0 else 'value'} there, if the costate that transversality and H = 0 "
                        f"determine at the end is followed back along the {transfer.manner} motion")
    return f"it is dH/du along the {transfer.manner} motion, with the costate followed back from the end"


# Small things.


def _close(said, true, claim, size=0.0):
    """Equality to the precision of the optimum; three digits where the claim holds decimals."""
    return same(said, true, claim, size, computed=2 * INTEGRATED)


def _point(values):
    return f"{values[0]:.4g}" if len(values) == 1 else "(" + ", ".join(f"{v:.4g}" for v in values) + ")"


def _times(count):
    return {0: "never", 1: "once", 2: "twice"}.get(int(count), f"{count} times")
