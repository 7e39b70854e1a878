"""Costs, durations and ranges of optimal processes, as expressions in the parameters.

The data are those of `optimal_controls`.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.direction import directed
from workbook.checks.contract.shapes import LIST_OR_RANGES
from workbook.checks.contract.tolerance import agree, in_decimals
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.optimal_controls import ARC_ACCURACY, CONTROL_ACCURACY, MISSED_ARC
from workbook.checks.pontryagin.parameter_ranges import with_ranges
from workbook.checks.pontryagin.simulation import COSTS, point_text
from workbook.checks.pontryagin.time_functions import INTEGRATED
from workbook.checks.references.optima.best_processes import best_processes, best_processes_at
from workbook.checks.references.optima.transfer_optima import SAMPLES
from workbook.checks.references.optima.units import constant_of, is_time_optimal, without_constant
from workbook.checks.references.scales import COST, TIME, judge_at_every_scale
from workbook.checks.tools.kinks import points_at_kinks
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import (
    no_number_text,
    uncertainties_at,
    uncertainty_at,
    value_at,
    values_at,
)
from workbook.checks.tools.wording import other_text, prefix_text

#: A time smaller than this, relative to the largest one, is zero; the growth of a time from zero is
#: compared at these fractions of the way.
ABSENT, GROWN = 1e-13, (1e-2, 1e-6)
#: Tolerance within which two points lie on both sides of a kink, and the largest ratio of the change
#: of an expression between them to that of the reference.
BESIDE, LEAPS = 1e-5, 4
#: The name in messages of what a process is compared by; a cost may be a speed.
NOUNS = {"cost": "value", "duration": "duration"}
#: Relative accuracy of the range of a quantity along the best process.
RANGE_ACCURACY = 5e-4


@judged(
    Expression("parameters"),
    problem="pontryagin.Problem with one control, its duration also an interval",
    parameters=LIST_OR_RANGES,
)
def optimal_cost(claim, problem, parameters=None):
    """Check the cost of the optimal process, as an expression in the parameters.

    Where these are the initial state and the duration is free, the remaining part of a process is
    optimal too: the cost is compared at its states as well.

    Can decide when the problem has no constraints along the path and one control: the best process
    is searched numerically, without the maximum principle, at sample values of the parameters.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, u, L, t = sp.symbols("x u L t", positive=True)
    >>> move = Problem({x: u}, {u: (-sp.oo, sp.oo)}, {x: 0}, [x - L], u**2, duration=1)
    >>> checks.optimal_cost(L**2, move, [L]).status, checks.optimal_cost(2*L**2, move, [L]).status
    ('right', 'wrong')
    """
    parameters = with_ranges(problem, parameters)
    better = "greater" if problem.maximise else "less"
    starts = list(problem.initial.values())
    for_all_starts = (
        problem.duration is None
        and not problem.first_return
        and len(set(starts)) == len(starts)
        and all(start in (parameters or {}) for start in starts)
    )
    # An added constant hides digits of a decimal answer, but not of an exact one.
    constant = sp.S.Zero if in_decimals(claim) else constant_of(problem)
    varying = claim - constant
    cost_of = (
        real_function([*starts, *(p for p in parameters if p not in starts)], [varying])
        if for_all_starts
        else None
    )
    processes = best_processes(problem, parameters, 2 * SAMPLES)
    for (values, best), claimed, uncertain in _evaluated(varying, processes, "the value"):
        where = prefix_text(values)
        removed_constant = float(constant.subs(values))
        kept_constant = best.units.constant - removed_constant
        agrees = functools.partial(
            agree,
            true=best.cost + kept_constant,
            written=claim,
            size=best.cost_size(),
            computed=COSTS,
            uncertain=uncertain,
        )
        if not (agrees(claimed) or agrees(claimed := value_at(varying, values, "the value"))):
            claimed += removed_constant
            unattainable = (claimed < best.cost + best.units.constant) != problem.maximise
            raise Wrong(
                f"{where}your value is {claimed:.4g}; "
                + directed(
                    "no admissible process with these ends was found for which it is as good"
                    if unattainable
                    else f"there is an admissible process for which it is {better}",
                    "it is not that of the best process found",
                )
            )
        if for_all_starts:
            _require_remaining_cost(
                varying, cost_of, values, best, starts, parameters, kept_constant
            )
    _require_cost_at_kinks(varying, problem, parameters, processes, "cost")
    scaled = problem if in_decimals(claim) else without_constant(problem)
    judge_at_every_scale(
        varying, scaled, parameters, [values for values, _ in processes], COST, "value"
    )
    return "it is the value for the best process found"


def _evaluated(claim, processes, quantity):
    """Return triples (pair of `processes`, value of the claim, uncertainty from its decimals)."""
    points = [values for values, _ in processes]
    return zip(processes, values_at(claim, points, quantity), uncertainties_at(claim, points))


def _require_cost_at_kinks(claim, problem, parameters, processes, quantity):
    """Raise `Wrong` unless an expression is the cost, or the duration, close to its kinks.

    They are looked for between the parameters of the processes. With decimals their positions are
    uncertain, and nothing is compared.
    """
    if (
        in_decimals(claim)
        or len(processes) < 2
        or not isinstance(parameters, dict)
        or not all(isinstance(domain, sp.Interval) for domain in parameters.values())
    ):
        return
    size = max(abs(getattr(best, quantity)) for _, best in processes)
    processes_at_kinks = best_processes_at(
        problem, parameters, points_at_kinks(claim, [values for values, _ in processes])
    )
    if not processes_at_kinks:
        return
    compared, noun = [], NOUNS[quantity]
    for (values, best), claimed, uncertain in _evaluated(claim, processes_at_kinks, f"the {noun}"):
        true = getattr(best, quantity)
        if not agree(claimed, true, claim, size, max(INTEGRATED, best.MISSED), uncertain):
            raise Wrong(
                f"{prefix_text(values)}your expression changes from one formula to another near this "
                f"point, and gives {claimed:.4g}; the {noun} of the best process found is "
                + directed("less" if claimed > true else "greater", "not this")
            )
        compared.append((values, claimed, true))
    for first, second in itertools.pairwise(compared):
        values, first_claimed, first_true = first
        second_values, second_claimed, second_true = second
        points = ([float(point[s]) for s in values] for point in (values, second_values))
        adjacent = np.allclose(*points, rtol=BESIDE, atol=BESIDE)
        if adjacent and abs(second_claimed - first_claimed) > LEAPS * max(
            abs(second_true - first_true), COSTS * abs(first_claimed)
        ):
            raise Wrong(
                f"{prefix_text(values)}your expression jumps where it changes its formula; near this "
                f"point the {noun} of the best process found hardly changes"
            )


def _require_remaining_cost(claim, cost_of, values, best, starts, parameters, kept_constant):
    """Raise `Wrong` where a claim is not the remaining cost of the best process at its states."""
    states, true = best.remaining_costs()
    inside = np.all(
        [
            (y > float(parameters[s].inf)) & (y < float(parameters[s].sup))
            for s, y in zip(starts, states)
        ],
        axis=0,
    )
    states, true = states[:, inside], true[inside] + kept_constant
    claimed = cost_of(*states, *(float(v) for p, v in values.items() if p not in starts))[0]
    uncertain = uncertainties_at(claim, [values | dict(zip(starts, y)) for y in states.T])
    wrong = ~np.atleast_1d(
        agree(np.nan_to_num(claimed, nan=np.inf), true, claim, best.cost_size(), COSTS, uncertain)
    )
    for k in np.flatnonzero(wrong)[:1]:
        value_text = (
            f"{claimed[k]:.4g}"
            if np.isfinite(claimed[k])
            else no_number_text(claim, values | dict(zip(starts, states[:, k])))
        )
        raise Wrong(
            f"from the initial state {point_text(states[:, k])} your value is {value_text}; for the best "
            "process found it is "
            + (
                directed("greater" if true[k] > claimed[k] else "less", "not this number")
                if np.isfinite(claimed[k])
                else "a real number"
            )
        )


@judged(
    Expression("parameters"),
    problem="pontryagin.Problem with any number of controls",
    parameters=LIST_OR_RANGES,
)
def optimal_duration(claim, problem, parameters=None):
    """Check the duration of the optimal process, as an expression in the parameters.

    Can decide when the problem has no constraints along the path: the best process is searched
    numerically, without the maximum principle, at sample values of the parameters.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u")
    >>> cart = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 4, v: 0}, [x, v])
    >>> checks.optimal_duration(4, cart).status, checks.optimal_duration(2, cart).status
    ('right', 'wrong')
    """
    parameters = with_ranges(problem, parameters)
    processes = best_processes(problem, parameters, 2 * SAMPLES)
    for (values, best), claimed, uncertain in _evaluated(claim, processes, "the duration"):
        agrees = functools.partial(
            agree, true=best.duration, written=claim, computed=INTEGRATED, uncertain=uncertain
        )
        if not (agrees(claimed) or agrees(claimed := value_at(claim, values, "the duration"))):
            raise Wrong(
                f"{prefix_text(values)}your duration is {claimed:.4g}; {best.duration_message(claimed)}"
            )
    if is_time_optimal(problem):
        _require_cost_at_kinks(claim, problem, parameters, processes, "duration")
    judge_at_every_scale(
        claim, problem, parameters, [values for values, _ in processes], TIME, "duration"
    )
    return "it is the duration of the best process found"


@judged(Expression("parameters"), problem="pontryagin.Problem with any number of controls")
def initial_arc_duration(claim, problem, control, value, parameters):
    """Check how long the optimal process keeps a control at a value from the beginning.

    The control is one of several; the duration is zero where it begins with another value.
    """
    if len(problem.controls) < 2:
        raise UnsuitableData("problem: expected one with several controls")
    if control not in problem.controls:
        raise UnsuitableData(f"control: expected one of {', '.join(map(str, problem.controls))}")
    j = list(problem.controls).index(control)
    low, high = problem.controls[control]
    true_durations, processes = [], best_processes(problem, parameters)
    for (values, best), claimed in zip(
        processes, values_at(claim, [values for values, _ in processes], "the time")
    ):
        level = float(sp.sympify(value).subs(values))
        tolerance = CONTROL_ACCURACY * float((high - low).subs(values))
        initial_arcs = itertools.takewhile(
            lambda arc: abs(arc[0][j] - level) <= tolerance, best.arcs
        )
        true = float(sum(end - begin for _, begin, end in initial_arcs))
        true_durations.append((values, true))
        accuracy, uncertain = ARC_ACCURACY if true else MISSED_ARC, uncertainty_at(claim, values)
        if not agree(claimed, true, claim, best.duration, accuracy, uncertain):
            raise Wrong(
                f"{prefix_text(values)}by your answer {control} is {value} for the first {claimed:.4g} "
                "units of time; in the best process found it is so "
                + directed(
                    f"for a {'longer' if true > claimed else 'shorter'} time"
                    if true > min(claimed, 0)
                    else "not at the beginning",
                    "not for just this time",
                )
            )
    _require_corner(claim, true_durations)
    judge_at_every_scale(
        claim, problem, parameters, [values for values, _ in true_durations], TIME, "time"
    )
    return "the best processes found keep this value for this time"


def _require_corner(claim, true_durations):
    """Raise `Wrong` for a duration of an arc that grows from zero without a corner.

    On the way from parameters without the arc to others with it, the true duration has a corner
    where the arc appears, so that the slope is no smaller close to it.
    """
    symbols = [s for s in true_durations[0][0] if s in claim.free_symbols]
    points = np.array([[float(values[s]) for s in symbols] for values, _ in true_durations])
    is_present = np.array([true > 0 for _, true in true_durations])
    absent, present = points[~is_present], points[is_present]
    function, count = real_function(symbols, [claim]), min(len(absent), len(present))
    if not count:
        return

    def claimed_times(parts, rows):
        return function(*(absent[rows] + parts[:, None] * (present[rows] - absent[rows])).T)[0]

    rows = np.arange(count)
    full_times = claimed_times(np.ones(count), rows)
    onset = bisect(
        lambda parts, rows: abs(claimed_times(parts, rows)) <= ABSENT * full_times[rows],
        np.zeros(count),
        np.ones(count),
        50,
    )[1]
    time_at_onset, *later_times = (
        claimed_times(np.minimum(onset + step, 1), rows) for step in (0, *GROWN)
    )
    far_rate, near_rate = ((time - time_at_onset) / step for time, step in zip(later_times, GROWN))
    for k in np.flatnonzero(
        ~(
            (near_rate > far_rate / 2)
            & (abs(claimed_times(np.zeros(count), rows)) <= ABSENT * full_times)
        )
    )[:1]:
        point = dict(zip(symbols, absent[k] + onset[k] * (present[k] - absent[k])))
        raise Wrong(
            f"{prefix_text(point)}next to parameters for which it is zero your time grows too slowly; that "
            "of the best process has a corner there"
        )


@judged(
    Expression("parameters"),
    problem="pontryagin.Problem with one control, its duration also an interval",
    parameters=LIST_OR_RANGES,
)
def optimal_range(claim, problem, quantity, parameters=None):
    """Check the range of a quantity along the optimal process.

    The range is the greatest value of the quantity minus its least one, as an expression in the
    parameters; where several processes are optimal, it is the same for all of them.
    """
    parameters = with_ranges(problem, parameters)
    from scipy.interpolate import CubicHermiteSpline

    symbols, names = list(problem.dynamics), list(parameters or {})
    value = real_function([*symbols, *names], [quantity])
    slopes = real_function([*symbols, *names], [quantity.diff(s) for s in symbols])
    for values, best in best_processes(problem, parameters):
        parameter_values = [float(values[p]) for p in names]
        states = np.column_stack([best.start[:-1], best.states])
        controls = [best.controls[0], *best.controls]
        rates = [best.field(np.append(y, 0), u)[:-1] for y, u in zip(states.T, controls)]
        path = CubicHermiteSpline(
            np.append(0, best.times),
            value(*states, *parameter_values)[0],
            [slopes(*y, *parameter_values) @ rate for y, rate in zip(states.T, rates)],
        )
        true = float(np.ptp(path(np.linspace(0, best.duration, 4001))))
        claimed = value_at(claim, values, "the extent")
        if not agree(
            claimed, true, claim, computed=RANGE_ACCURACY, uncertain=uncertainty_at(claim, values)
        ):
            raise Wrong(
                prefix_text(values)
                + other_text(f"the range of {quantity} along the best process found", claimed, true)
            )
    return "it is the range along the best process found"
