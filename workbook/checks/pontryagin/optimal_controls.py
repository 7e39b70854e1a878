"""Optimal controls in time, judged by the process that they give.

`problem` is a `pontryagin.Problem`, with one control. `parameters` are its symbols with the
intervals in which answers are tried, a dict; of a transfer in least or greatest time a list of
symbols suffices, and a state without an initial value that is one of them stands for its initial
value. The optimum comes from `best_processes`, which does not use costates. A process has to be
admissible, to keep to the ends, and to cost no more than the optimum that was found.
"""

import numpy as np

from workbook.checks.contract.direction import directed
from workbook.checks.contract.shapes import LIST_OR_RANGES
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.changes_compared import LOCATED
from workbook.checks.pontryagin.parameter_ranges import with_ranges
from workbook.checks.pontryagin.simulation import AT_OWN_END, Path, on_target, require_optimal
from workbook.checks.pontryagin.time_functions import INTEGRATED, Control, Steering, values_of
from workbook.checks.references.optima.best_processes import best_processes, free_at_the_start
from workbook.checks.references.optima.units import is_time_optimal
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.wording import prefix_text

#: Accuracy of a control on an arc of the best process, relative to its range; of the length of an
#: arc, relative to the duration; and the relative length below which an arc may be missed.
CONTROL_ACCURACY, ARC_ACCURACY, MISSED_ARC = 1e-3, 1e-6, 1e-4
#: Distance from a change of the best control within which the change of a claimed one is looked for,
#: relative to the duration; and the apparent jump of a numerical control, relative to the distance
#: of its bounds.
NEAR, BENT = 0.02, 4e-3
#: Values of a control that differ by less, relative to its jump, are equal; largest duration of a
#: jump, relative to that of the process.
SAME, SUDDEN = 1e-6, 1e-9
#: Factor on the tolerance of the end of the process if its duration is minimised, since then the
#: duration is known more accurately.
TIMED = 0.05


@judged(
    Control("time", "parameters", time="time"),
    problem="pontryagin.Problem with one control, its duration also an interval",
    parameters=LIST_OR_RANGES,
)
def optimal_control(claim, problem, time, parameters=None):
    """Check the control of an optimal process.

    It is an expression in time and parameters, or a list of arcs [value, until].

    Can decide when the problem has no constraints along the path and one control: the best process
    is searched numerically, without the maximum principle, at sample values of the parameters.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, u, L, t = sp.symbols("x u L t", positive=True)
    >>> move = Problem({x: u}, {u: (-sp.oo, sp.oo)}, {x: 0}, [x - L], u**2, duration=1)
    >>> checks.optimal_control(L, move, t, [L]).status, checks.optimal_control(2*L*t, move, t, [L]).status
    ('right', 'wrong')
    """
    parameters = with_ranges(problem, parameters)
    steering = Steering(claim, time, parameters)
    start_text = (
        ", begun as the best process is," if any(free_at_the_start(problem, parameters)) else ""
    )
    duration_factor = TIMED if is_time_optimal(problem) and steering.rounding == INTEGRATED else 1
    for values, best in best_processes(problem, parameters):
        where = prefix_text(values)
        source = "your control" + start_text
        _require_matching_end(steering, values, best, problem, where, source)
        sections = steering.sections(values, best.duration)
        path = Path(best, sections, where)
        path.require_admissible(steering.decimal_tolerance)

        def end_of(side, values=values, best=best, where=where):
            return Path(best, side.sections(values, best.duration), where).states[-1]

        ends = (
            [[*map(end_of, sides)] for sides in part]
            for part in (steering.perturbed, steering.perturbed_in_pairs)
        )
        process = path.times, path.states, best, problem
        require_optimal(*process, duration_factor * steering.rounding, where, source, *ends)
        _require_jumps(sections, best, steering.rounding, where)
        _require_continuous_changes(sections, steering.perturbed, best, values, where)
        if steering.decimal_tolerance == INTEGRATED:
            _require_same_changes(sections, best, where)
    return "it is admissible, keeps to the ends, and no process was found that does better"


def _require_matching_end(steering, values, best, problem, where, source):
    """Raise `Wrong` unless the arcs end when the best process does.

    The last arc may neither end too early nor begin after the end; but where the ends depend on
    parameters and the duration is given, what comes after the end does not count. With a free
    duration the process is judged at its own end if that is closer to the target, since a process
    that costs too much may end at another time.
    """
    counted = best.duration if steering.ends_vary and not problem.free_time else np.inf
    if not (ends := steering.ends(values, counted)):
        return
    (begin, end), uncertainties = [0.0, *ends][-2:], [0.0, *steering.end_uncertainties(values)][-2:]
    early = end < best.duration * (1 - steering.rounding) - uncertainties[1]
    late = begin > best.duration * (1 + steering.rounding) + uncertainties[0]
    if problem.free_time:
        own_path, cut_path = (
            Path(best, steering.sections(values, until), where) for until in (end, best.duration)
        )
        own, cut = (on_target(p.states[-1], best, steering.rounding) for p in (own_path, cut_path))
        if early or late or own > cut:
            own_path.require_admissible(steering.decimal_tolerance)
            process = own_path.times, own_path.states, best, problem
            require_optimal(*process, steering.rounding, where, source, when=AT_OWN_END)
    if early or late:
        raise Wrong(
            f"{where}your last arc "
            + directed(
                f"ends at {end:.4g}, and the process lasts longer"
                if early
                else f"begins at {begin:.4g}, when the process should be over",
                "does not end when the process should",
            )
        )


def _require_jumps(sections, best, rounding, where):
    """Raise `Wrong` for a control that changes gradually where the best one jumps.

    It may not reach the value of its first or last arc gradually either. The cost cannot decide: a
    quick change costs hardly anything.
    """
    times, controls = np.asarray(best.times), np.asarray(best.controls)
    for k in range(1, len(times) - 2):
        before, after = controls[k], controls[k + 1]
        slack = max(rounding, SAME) * abs(after - before)
        if max(abs(controls[k - 1] - before), abs(controls[k + 2] - after)) < slack and (
            point := _gradual_change_time(
                sections, times[k - 1], before, times[k + 2], after, slack, best.duration
            )
        ):
            raise Wrong(
                f"{where}at t = {point:.4g} the best control jumps; yours takes values between"
            )
    for inner, k, end in ((1, 0, SUDDEN * best.duration), (-2, -1, (1 - SUDDEN) * best.duration)):
        bound_value = controls[k]
        slack = max(rounding, SAME) * max(abs(controls[k]), SAME * best.units.control)
        if abs(controls[inner] - bound_value) < slack and (
            point := _gradual_change_time(
                sections, times[inner], bound_value, end, None, slack, best.duration
            )
        ):
            raise Wrong(
                f"{where}next to t = {point:.4g} the best control keeps one value; yours takes "
                "others"
            )


def _require_same_changes(sections, best, where):
    """Raise `Wrong` for an exact control that jumps a little before or after the best one.

    The cost cannot decide: it changes in the second order only.
    """
    times, changes = best.times, [begin for begin, *_ in sections[1:]]
    slack = CONTROL_ACCURACY * (best.bounds[1] - best.bounds[0])
    for j, before, after in best.changes():
        if before is None or after is None:
            continue
        around = values_of(sections, times[[j - 1, j + 1]])
        if np.all(np.abs(around - [before, after]) <= slack) and not any(
            abs(t - times[j]) <= LOCATED * best.duration for t in changes
        ):
            raise Wrong(
                f"{where}your control keeps to the ends, but it does not jump when the best one does"
            )


def _gradual_change_time(sections, first, before, last, after, slack, duration):
    """Return the time at which a control begins to change gradually from one value to another.

    It is None if the control jumps, or has other values at the two instants. If `after` is None it
    is the value of the control itself at the last instant.
    """
    low, high = sorted((first, last))
    for u in (u for begin, end, u in sections if begin <= low and high <= end):
        after = u(np.array([last]))[0] if after is None else after
        if abs(after - before) <= slack or not (
            abs(u(np.array([first]))[0] - before) <= slack
            and abs(u(np.array([last]))[0] - after) <= slack
        ):
            continue
        point = bisect(
            lambda t, _, u=u: abs(u(t) - before) <= slack, np.array([first]), np.array([last]), 50
        )[1]
        if not abs(u(point + np.sign(last - first) * SUDDEN * duration)[0] - after) <= slack:
            return float(point[0])
    return None


def _require_continuous_changes(sections, perturbed, best, values, where):
    """Raise `Wrong` for a control that jumps where the best one meets a bound without a jump."""
    low, high = best.bounds
    for j, before, after in best.changes():
        if (before is None) == (after is None):
            continue
        (t, s), (v, w) = best.times[j + 1 : j + 3] - best.times[j], best.controls[j + 1 : j + 3]
        offset, allowed = NEAR * best.duration, BENT * (high - low)
        if (
            abs((v - (w - v) * t / (s - t) if after is None else after) - best.controls[j])
            > allowed
        ):
            continue  # at a singular arc the best one jumps too
        side = offset if before is None else -offset
        ends = best.times[j] + side, best.times[j] - side, SAME * (high - low)
        claimed = _jump(sections, *ends)
        jumps = (
            [_jump(variant.sections(values, best.duration), *ends) for variant in pair]
            for pair in perturbed
        )
        uncertainty = sum(max(abs(jump - claimed) for jump in pair) for pair in jumps)
        if not abs(claimed) <= allowed / 10 + uncertainty:
            raise Wrong(
                f"{where}your control jumps by {claimed:.2g} where the best one changes without a jump"
            )


def _jump(sections, first, last, tolerance):
    """Return the jump of a control where it leaves its value at the first of two instants."""
    first_value = values_of(sections, [first])[0]
    point = bisect(
        lambda t, _: abs(values_of(sections, t) - first_value) <= tolerance,
        np.array([first]),
        np.array([last]),
        48,
    )[1]
    return values_of(sections, point)[0] - first_value
