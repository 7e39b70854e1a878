"""Optimal processes whatever the cost: controls and motions in time, costs and durations.

`problem` is a `pontryagin.Problem`, with one control. `parameters` are its symbols with the
intervals in which answers are tried, a dict; of a transfer in least or greatest time a list of
symbols will do, and a state without a value at the start that is one of them stands for its start.
The optimum comes from `best_processes`, which knows nothing of costates. All answers are judged in
one way: a process has to be admissible, to keep to the ends, and to cost no more than the optimum
that was found.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import agree, in_decimals
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.followed import (
    COSTS,
    ENDING_ITSELF,
    Path,
    does_as_well,
    keeps_to_the_ends,
    meets_once,
    on_target,
    point_text,
)
from workbook.checks.pontryagin.in_time import (
    ENDING,
    INTEGRATED,
    Control,
    InTime,
    Motion,
    Steering,
    jumps,
)
from workbook.checks.references.optima.best_processes import (
    best_processes,
    best_processes_at,
    free_at_the_start,
)
from workbook.checks.references.optima.transfer_optima import SAMPLES
from workbook.checks.references.scales import COST, TIME, same_at_every_scale
from workbook.checks.tools.kinks import next_to_bends
from workbook.checks.tools.searching import bisected
from workbook.checks.tools.values import real_function, uncertain_at_all, value_at, values_at_all
from workbook.checks.tools.wording import told_for

#: Where rates are no linear functions of the control, it is tried at so many places between its
#: bounds, then closer to the best of them, so often; and so far to both sides where it has no
#: bounds.
PARTS, ROUNDS, UNBOUNDED = 24, 7, 20.0
#: To what share of its range a control on an arc of the best process is known, and of the duration
#: an arc; a shorter one may be missed.
CERTAIN, ARC, MISSED = 1e-3, 1e-6, 1e-4
#: How far from a change of the best control, as a part of the duration, that of another one is
#: looked for, and by what share of the distance of its bounds a control that is found numerically
#: may seem to jump.
NEAR, BENT = 0.02, 4e-3
#: Values of a control that differ by a smaller part of its jump are one; a jump takes so small a
#: part of the duration.
SAME, SUDDEN = 1e-6, 1e-9
#: How much better the duration of the best process is known, and so where it ends, if it is what is
#: to be least.
TIMED = 0.05
#: A smaller part of a time than this is none; after so small parts of a way its growth is looked
#: at.
ABSENT, GROWN = 1e-13, (1e-2, 1e-6)
#: How close two places are that lie on both sides of a bend, and how many times as far as the truth
#: an expression may move between them.
BESIDE, LEAPS = 1e-5, 4
#: To what share the extreme values of a quantity along the best process are known.
FOLLOWED = 5e-4


@judged(Control("time", "parameters", time="time"))
def optimal_control(claim, problem, time, parameters=None):
    """The control of an optimal process: an expression in time and parameters, or a list of arcs
    [value, until]."""
    read = Steering(claim, time, parameters)
    begun = ", begun as the best process is," if any(free_at_the_start(problem, parameters)) else ""
    timed = TIMED if _only_time(problem) and read.rounding == INTEGRATED else 1
    for values, best in best_processes(problem, parameters):
        where = told_for(values)
        whose = "your control" + begun
        _ends_with_the_best(read, values, best, problem, where, whose)
        sections = read.sections(values, best.duration)
        path = Path(best, sections, where)
        path.admissible(read.lasting)
        others, together = (
            [
                [
                    Path(best, side.sections(values, best.duration), where).states[-1]
                    for side in sides
                ]
                for sides in part
            ]
            for part in (read.changed, read.together)
        )
        does_as_well(
            path.times,
            path.states,
            best,
            problem,
            timed * read.rounding,
            where,
            whose,
            others,
            together,
        )
        _jumps_where_it_should(sections, best, read.rounding, where)
        _bends_where_it_should(sections, read.changed, best, values, where)
    return "it is admissible, keeps to the ends, and no process was found that does better"


def _ends_with_the_best(read, values, best, problem, where, whose):
    """Raise `Wrong` for arcs that end too early, of which the last one begins after the end, or
    that come to the target later alone: by what they come to at their own end, since what costs too
    much may end at another time."""
    if not (ends := read.ends(values)):
        return
    begin, end = [0.0, *ends][-2:]
    early, late = (
        end < best.duration * (1 - read.lasting),
        begin > best.duration * (1 + read.lasting),
    )
    if problem.duration is None or isinstance(problem.duration, tuple):
        own, cut = (
            Path(best, read.sections(values, until), where) for until in (end, best.duration)
        )
        if (
            early
            or late
            or on_target(own.states[-1], best, read.rounding)
            > on_target(cut.states[-1], best, read.rounding)
        ):
            own.admissible(read.lasting)
            does_as_well(
                own.times,
                own.states,
                best,
                problem,
                read.rounding,
                where,
                whose,
                when=ENDING_ITSELF,
            )
    if early or late:
        raise Wrong(
            f"{where}your last arc "
            + (
                f"ends at {end:.4g}, and the process lasts longer"
                if early
                else f"begins at {begin:.4g}, when the process should be over"
            )
        )


def _jumps_where_it_should(sections, best, rounding, where):
    """Raise `Wrong` for a control that goes over by and by from one value to another where the best
    one jumps, or comes to the value of its first or last arc by and by: if it is quick, that costs
    next to nothing."""
    times, controls = np.asarray(best.times), np.asarray(best.controls)
    for k in range(1, len(times) - 2):
        before, after = controls[k], controls[k + 1]
        slack = max(rounding, SAME) * abs(after - before)
        if max(abs(controls[k - 1] - before), abs(controls[k + 2] - after)) < slack and (
            place := _slowly(
                sections, times[k - 1], before, times[k + 2], after, slack, best.duration
            )
        ):
            raise Wrong(
                f"{where}at t = {place:.4g} the best control jumps; yours takes values between"
            )
    for inner, k, end in ((1, 0, SUDDEN * best.duration), (-2, -1, (1 - SUDDEN) * best.duration)):
        held, slack = controls[k], max(rounding, SAME) * max(abs(controls[k]), SAME)
        if abs(controls[inner] - held) < slack and (
            place := _slowly(sections, times[inner], held, end, None, slack, best.duration)
        ):
            raise Wrong(
                f"{where}next to t = {place:.4g} the best control keeps one value; yours takes "
                "others"
            )


def _slowly(sections, first, before, last, after, slack, duration):
    """The time at which a control leaves the value before and does not come to the one after at
    once; None where it does, or has other values at the two instants. Without a value after that of
    the control itself stands for it."""
    low, high = sorted((first, last))
    for u in (u for begin, end, u in sections if begin <= low and high <= end):
        after = u(np.array([last]))[0] if after is None else after
        if abs(after - before) <= slack or not (
            abs(u(np.array([first]))[0] - before) <= slack
            and abs(u(np.array([last]))[0] - after) <= slack
        ):
            continue
        place = bisected(
            lambda t, _, u=u: abs(u(t) - before) <= slack, np.array([first]), np.array([last]), 50
        )[1]
        if not abs(u(place + np.sign(last - first) * SUDDEN * duration)[0] - after) <= slack:
            return float(place[0])
    return None


def _values(sections, times):
    """A control at instants."""
    times = np.clip(times, sections[0][0], sections[-1][1])
    found, left = np.empty(len(times)), np.ones(len(times), dtype=bool)
    for begin, end, u in sections:
        here = left & (begin <= times) & (times <= end)
        if here.any():
            found[here] = u(times[here])
        left &= ~here
    return found


def _bends_where_it_should(sections, changed, best, values, where):
    """Raise `Wrong` for a control that jumps where the best one leaves a bound, or comes to one,
    without a jump."""
    low, high = best.bounds
    for j, before, after in getattr(best, "changes", list)():
        if (before is None) == (after is None):
            continue
        (t, s), (v, w) = best.times[j + 1 : j + 3] - best.times[j], best.controls[j + 1 : j + 3]
        near, allowed = NEAR * best.duration, BENT * (high - low)
        if (
            abs((v - (w - v) * t / (s - t) if after is None else after) - best.controls[j])
            > allowed
        ):
            continue  # to a singular arc the best one jumps too
        bound, inner = best.times[j] + (near if before is None else -near) * np.array([1.0, -1.0])
        said, *others = (
            _leap(one, bound, inner, SAME * (high - low))
            for one in (
                sections,
                *(side.sections(values, best.duration) for sides in changed for side in sides),
            )
        )
        left_open = sum(
            max(abs(one - said), abs(other - said)) for one, other in zip(others[::2], others[1::2])
        )
        if not abs(said) <= allowed / 10 + left_open:
            raise Wrong(
                f"{where}your control jumps by {said:.2g} where the best one changes without a jump"
            )


def _leap(sections, first, last, same):
    """By how much a control jumps where it leaves the value that it has at the first of two
    instants."""
    held = _values(sections, [first])[0]
    place = bisected(
        lambda t, _: abs(_values(sections, t) - held) <= same,
        np.array([first]),
        np.array([last]),
        48,
    )[1]
    return _values(sections, place)[0] - held


def _only_time(problem):
    return problem.running == 1 and problem.final == 0 and problem.duration is None


@judged(Motion("time", "parameters", problem="problem", time="time"))
def optimal_motion(claims, problem, time, parameters=None):
    """An optimal motion: all states as functions of time and parameters, or the first one, if the
    others are its derivatives."""
    motion, given = (
        InTime(claims, time, parameters),
        ~np.array(free_at_the_start(problem, parameters)),
    )
    # A motion that arrives at the least time is optimal, whatever it does before.
    only_time = _only_time(problem)
    for values, best in best_processes(problem, parameters):
        where, slack = told_for(values), motion.rounding * best.size()
        start = motion.values(0.0, values)
        if not np.all(
            (np.abs(start - best.start[:-1]) <= slack + motion.uncertain(0.0, values)[0])[given]
        ):
            raise Wrong(f"{where}your motion starts at {point_text(start)}, not where it should")
        states = [_possible(motion, t, values, best, problem, where) for t in best.times]
        for j, name in enumerate(problem.dynamics):
            for t in jumps(lambda times, j=j: motion.values(times, values)[j], best.duration):
                before, after = (
                    motion.values(t * (1 + side * 1e-6), values)[j] for side in (-1, 1)
                )
                if (
                    not abs(after - before)
                    <= motion.uncertain(t * (1 - 1e-6), values)[0][j] + slack
                ):
                    raise Wrong(f"{where}on your motion {name} jumps at t = {t:.4g}")
        if problem.first_return:
            meets_once([0.0, *best.times], [start, *states], best, where)
        end = np.append(motion.values(ENDING * best.duration, values), 0)
        keeps_to_the_ends(
            end,
            best,
            motion.rounding,
            where + "on your motion",
            [
                (end - side, end + side)
                for side in np.diag(
                    np.append(motion.uncertain(ENDING * best.duration, values)[0], 0)
                )
            ],
        )
        differences = np.abs(np.array(states)[:, :-1].T - best.states)
        off = differences.max()
        if not (
            only_time or np.all(differences <= 3 * slack + motion.uncertain(best.times, values)[0])
        ):
            raise Wrong(
                f"{where}your motion is one that the system can have, but another one with the "
                f"same ends does better; the two come to be {off:.4g} apart"
            )
    return "it starts where it should, obeys the equations, keeps to the ends, and is the best motion found"


def _possible(motion, t, values, best, problem, where):
    """The state of a motion at an instant, with a zero for the cost; `Wrong` if it does not obey
    the equations there under any admissible control."""
    near = t * (1 - 1e-7)  # at a jump of the control a derivative need not exist
    y, rate = motion.values(near, values), motion.rates(near, values)
    if not np.all(np.isfinite([*y, *rate])):
        raise Wrong(f"{where}your motion is not real at t = {t:.4g}")
    scale = 10 * motion.rounding * (1 + np.abs(best.states).max() * (1 + 1 / best.duration))
    open_y, open_rate = motion.uncertain(near, values)
    if open_y.any():
        middle = np.mean(np.nan_to_num(best.bounds, posinf=0, neginf=0))
        scale += (open_rate + np.abs(best.jacobians(y, middle)[0])[:-1, : len(y)] @ open_y).sum()
    off = np.abs(_nearest_rates(best, y, rate) - rate)
    if not np.all(off <= scale):
        j = int(np.argmax(off))
        others = "" if len(y) == 1 else ", with the other rates that it has there"
        raise Wrong(
            f"{where}at t = {t:.4g} your motion is at {point_text(y)} with "
            f"{list(problem.dynamics)[j]}' = {rate[j]:.4g}, which no admissible control gives "
            f"there{others}"
        )
    return np.append(y, 0)


def _nearest_rates(best, y, rate):
    """Of the rates of the states that admissible controls give, those nearest to `rate`."""

    def rates(u):
        return np.array([best.field(np.append(y, 0), one)[:-1] for one in u]).T

    low, high = best.bounds
    zero, one, two = rates([0.0, 1.0, 2.0]).T
    slope = one - zero
    if np.allclose(two - one, slope, rtol=1e-12, atol=1e-12) and np.allclose(
        rates([-np.pi])[:, 0], zero - np.pi * slope, rtol=1e-9, atol=1e-9
    ):
        size = slope @ slope
        return zero + slope * np.clip(slope @ (rate - zero) / size if size else 0.0, low, high)
    # An angle is tried all round, what is no angle as far as `UNBOUNDED`.
    turns = np.allclose(
        rates([0.3, 1.7]), rates([0.3 + 2 * np.pi, 1.7 + 2 * np.pi]), rtol=1e-9, atol=1e-9
    )
    begin, end = np.clip(
        (-np.pi, np.pi) if turns and high - low >= 2 * np.pi else (-UNBOUNDED, UNBOUNDED), low, high
    )
    for _ in range(ROUNDS):
        places = np.linspace(begin, end, PARTS + 1)
        found = rates(places)
        k = int(np.argmin(np.linalg.norm(found - rate[:, None], axis=0)))
        begin, end = places[max(k - 1, 0)], places[min(k + 1, PARTS)]
    return found[:, k]


@judged(Expression("parameters"))
def optimal_cost(claim, problem, parameters=None):
    """The cost of the optimal process, as an expression in the parameters.

    Where these are the start and the duration is free, what is left of a process is optimal too:
    the cost is asked there as well.
    """
    better = "greater" if problem.maximise else "less"
    starts = list(problem.initial.values())
    anywhere = (
        problem.duration is None
        and not problem.first_return
        and len(set(starts)) == len(starts)
        and all(start in (parameters or {}) for start in starts)
    )
    cost_of = (
        real_function([*starts, *(p for p in parameters if p not in starts)], [claim])
        if anywhere
        else None
    )
    found = best_processes(problem, parameters, 2 * SAMPLES)
    for (values, best), said, open_ in _evaluated(claim, found, "the cost"):
        where = told_for(values)
        right = functools.partial(
            agree,
            true=best.cost,
            written=claim,
            size=best.cost_size(),
            computed=COSTS,
            uncertain=open_,
        )
        if not (right(said) or right(said := value_at(claim, values, "the cost"))):
            beyond = (said < best.cost) != problem.maximise
            raise Wrong(
                f"{where}your cost is {said:.4g}; "
                + (
                    "no admissible process that keeps to the ends was found that does so well"
                    if beyond
                    else f"there is an admissible process with a cost that is {better}"
                )
            )
        if anywhere:
            _left_over(claim, cost_of, values, best, starts, parameters)
    _right_next_to_bends(claim, problem, parameters, found, "cost")
    same_at_every_scale(claim, problem, parameters, [values for values, _ in found], COST, "cost")
    return "it is the cost of the best process found"


def _evaluated(claim, found, what):
    """The pairs found, each with what a claim is there, in the digits of floats, and what its
    decimals leave open."""
    places = [values for values, _ in found]
    return zip(found, values_at_all(claim, places, what), uncertain_at_all(claim, places))


def _right_next_to_bends(claim, problem, parameters, found, what):
    """Raise `Wrong` for an expression that is not the cost, or the duration, next to where it goes
    over from one form to another, on the way between the places of the processes found; decimals
    leave open where that is."""
    if (
        in_decimals(claim)
        or len(found) < 2
        or not isinstance(parameters, dict)
        or not all(isinstance(domain, sp.Interval) for domain in parameters.values())
    ):
        return
    size = max(abs(getattr(best, what)) for _, best in found)
    near = best_processes_at(
        problem, parameters, next_to_bends(claim, [values for values, _ in found])
    )
    seen = []
    for (values, best), said, open_ in _evaluated(claim, near, f"the {what}") if near else ():
        true = getattr(best, what)
        if not agree(said, true, claim, size, max(INTEGRATED, best.MISSED), open_):
            raise Wrong(
                f"{told_for(values)}your expression goes over from one form to another, and gives "
                f"{said:.4g} next to that; the {what} of the best process found is "
                f"{'less' if said > true else 'greater'}"
            )
        seen.append((values, said, true))
    for (values, one, least), (others, other, greatest) in itertools.pairwise(seen):
        beside = all(
            np.isclose(float(values[s]), float(others[s]), rtol=BESIDE, atol=BESIDE) for s in values
        )
        if beside and abs(other - one) > LEAPS * max(abs(greatest - least), COSTS * abs(one)):
            raise Wrong(
                f"{told_for(values)}your expression jumps, from one form to another; next to that "
                f"the {what} of the best process found hardly changes"
            )


def _left_over(claim, cost_of, values, best, starts, parameters):
    """Raise `Wrong` where a claim for all starts is not what the rest of the best process costs."""
    states, true = best.left()
    inside = np.all(
        [
            (y > float(parameters[s].inf)) & (y < float(parameters[s].sup))
            for s, y in zip(starts, states)
        ],
        axis=0,
    )
    states, true = states[:, inside], true[inside]
    said = cost_of(*states, *(float(v) for p, v in values.items() if p not in starts))[0]
    off = ~np.atleast_1d(
        agree(np.nan_to_num(said, nan=np.inf), true, claim, best.cost_size(), COSTS)
    )
    for k in np.flatnonzero(off)[:1]:
        gives = f"{said[k]:.4g}" if np.isfinite(said[k]) else "no real number"
        raise Wrong(
            f"from the start {point_text(states[:, k])} your cost is {gives}; the best process "
            "found costs "
            + ("more" if true[k] > said[k] else "less" if np.isfinite(said[k]) else "a real number")
        )


@judged(Expression("parameters"))
def optimal_duration(claim, problem, parameters=None):
    """The duration of the optimal process, as an expression in the parameters."""
    found = best_processes(problem, parameters, 2 * SAMPLES)
    for (values, best), said, open_ in _evaluated(claim, found, "the duration"):
        right = functools.partial(
            agree, true=best.duration, written=claim, computed=INTEGRATED, uncertain=open_
        )
        if not (right(said) or right(said := value_at(claim, values, "the duration"))):
            raise Wrong(
                f"{told_for(values)}your duration is {said:.4g}; {best.told_duration(said)}"
            )
    if _only_time(problem):
        _right_next_to_bends(claim, problem, parameters, found, "duration")
    same_at_every_scale(
        claim, problem, parameters, [values for values, _ in found], TIME, "duration"
    )
    return "it is the duration of the best process found"


@judged(Expression("parameters"))
def initial_arc_duration(claim, problem, control, value, parameters):
    """How long the best process keeps one of several controls at a value in the beginning; zero
    where it begins with another."""
    j = list(problem.controls).index(control)
    low, high = problem.controls[control]
    held, found = [], best_processes(problem, parameters)
    for (values, best), said in zip(
        found, values_at_all(claim, [values for values, _ in found], "the time")
    ):
        given = float(sp.sympify(value).subs(values))
        near = CERTAIN * float((high - low).subs(values))
        first = itertools.takewhile(lambda arc: abs(arc[1][j] - given) <= near, best.arcs)
        true = float(sum(length for length, _ in first))
        held.append((values, true))
        if not agree(said, true, claim, best.duration, ARC if true else MISSED):
            raise Wrong(
                f"{told_for(values)}you keep {control} = {value} for {said:.4g} at first; the best "
                "process found does so "
                + (
                    "longer"
                    if true > said
                    else "for a shorter time"
                    if true
                    else "at no time in the beginning"
                )
            )
    _begins_at_once(claim, held)
    same_at_every_scale(claim, problem, parameters, [values for values, _ in held], TIME, "time")
    return "the best processes found keep it so long"


def _begins_at_once(claim, held):
    """Raise `Wrong` for a time that grows from zero by and by, on the way from parameters for which
    it is zero to others: where the arc appears it grows with a corner, so that next to it the slope
    is no smaller."""
    symbols = [s for s in held[0][0] if s in claim.free_symbols]
    none, some = (
        np.array(
            [[float(values[s]) for s in symbols] for values, true in held if (true > 0) == part]
        )
        for part in (False, True)
    )
    function, count = real_function(symbols, [claim]), min(len(none), len(some))
    if not count:
        return

    def said(parts, rows):
        return function(*(none[rows] + parts[:, None] * (some[rows] - none[rows])).T)[0]

    rows = np.arange(count)
    whole = said(np.ones(count), rows)
    begun = bisected(
        lambda parts, rows: abs(said(parts, rows)) <= ABSENT * whole[rows],
        np.zeros(count),
        np.ones(count),
        50,
    )[1]
    here, *grown = (said(np.minimum(begun + step, 1), rows) for step in (0, *GROWN))
    far, near = ((one - here) / step for one, step in zip(grown, GROWN))
    for k in np.flatnonzero(
        ~((near > far / 2) & (abs(said(np.zeros(count), rows)) <= ABSENT * whole))
    )[:1]:
        at = dict(zip(symbols, none[k] + begun[k] * (some[k] - none[k])))
        raise Wrong(
            f"{told_for(at)}your time leaves zero by and by; that of the best process does so at "
            "once"
        )


@judged(Expression("parameters"))
def optimal_range(claim, problem, quantity, parameters=None):
    """How far a quantity ranges along the optimal process, from its least value to its greatest, as
    an expression in the parameters; where several processes are optimal, it is the same for all of
    them."""
    from scipy.interpolate import CubicHermiteSpline

    symbols, named = list(problem.dynamics), list(parameters or {})
    value = real_function([*symbols, *named], [quantity])
    slopes = real_function([*symbols, *named], [quantity.diff(s) for s in symbols])
    for values, best in best_processes(problem, parameters):
        given = [float(values[p]) for p in named]
        along = np.column_stack([best.start[:-1], best.states])
        controls = [best.controls[0], *best.controls]
        rates = [best.field(np.append(y, 0), u)[:-1] for y, u in zip(along.T, controls)]
        path = CubicHermiteSpline(
            np.append(0, best.times),
            value(*along, *given)[0],
            [slopes(*y, *given) @ rate for y, rate in zip(along.T, rates)],
        )
        true = float(np.ptp(path(np.linspace(0, best.duration, 4001))))
        said = value_at(claim, values, "the extent")
        if not agree(said, true, claim, computed=FOLLOWED):
            raise Wrong(
                f"{told_for(values)}your expression gives {said:.4g}; along the best process found "
                f"{quantity} ranges over {'less' if said > true else 'more'}"
            )
    return "so far it ranges along the best process found"
