"""Laws of optimal processes, whatever the cost, and the curves on which they change.

`problem` is a `pontryagin.Problem` with one control, whose initial states are symbols. These are
among `parameters`, a dict from symbols to the intervals in which initial states and parameters are
sampled. The optimum comes from `direct_optimum`, which does not use costates. A law has to give the
control of the best process at its states and close to them, above all where the control changes,
since a small error of a switching curve changes the cost in the second order only. Then the motion
under the law is integrated; it has to keep to the ends and may cost no more.
"""

import itertools

import numpy as np

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.feedback_laws import STEPS, FeedbackLaw
from workbook.checks.pontryagin.simulation import point_text, require_optimal
from workbook.checks.references.optima.direct_optimum import optima
from workbook.checks.references.optima.runge_kutta import rk4
from workbook.checks.references.scales import TIME, first_difference, judge_at_every_scale, scales
from workbook.checks.tools.line_search import bisect
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import uncertainty_at
from workbook.checks.tools.wording import NO_NUMBER, prefix_text, process_part_text

#: Distance from a change of its control at which the best process is compared with a law, relative
#: to the duration, and distance of the states at which the law is evaluated, relative to the
#: coordinates; each for exact laws and for laws in decimals.
BEFORE, BESIDE = (3e-4, 2e-3), (5e-5, 5e-3)
#: Fractions of the time from a change to the next known time at which a varying control is compared.
CLOSER = (0.05, 0.15, 0.25, 0.4)
#: Accuracy of a control between its bounds along the best process, relative to their distance, and
#: close to where it reaches a bound smoothly: the time of this changes the cost in the third order
#: only.
CONTROL_ACCURACY, BENT = 2e-4, 1e-3
#: States smaller than this, relative to the largest one, are not compared: they are close to the
#: origin, where all switching curves meet.
AWAY = 0.05
#: Distance on both sides of a switching curve, relative to the way across, at which the law has to
#: have the values before and after the jump.
ACROSS = 1e-6
#: How many times smaller the steps are in which a motion under a law is computed once more.
SMALLER = 4
#: Accuracy of the state at a change of the control, relative to its coordinates.
LOCATED = 3e-4


@judged(problem="pontryagin.Problem with one control, its duration also an interval")
def optimal_law(answer, problem, parameters, time=None):
    """Check a law under which every initial state gives an optimal process.

    The law depends on the states, parameters and time.

    It is an expression, or an equation with the control in it that has one solution between the
    bounds: with sp.Piecewise one for each region.
    """
    law = FeedbackLaw(answer, problem, parameters, time)
    processes = list(optima(problem, parameters))
    for values, best in processes:
        _require_best_control(law, values, best)
    for factors in scales(problem, parameters):
        for values, best in processes:
            _require_scale_invariance(law, values, best, factors)
    for process, times, states in zip(processes, *_motions_under_law(law, processes)):
        arguments = process[1], problem, law.rounding, prefix_text(process[0]), "your law"
        try:
            require_optimal(times, states, *arguments)
        except Wrong:
            # late switchings may be what it costs: they are less late with smaller steps
            (times,), (states,) = _motions_under_law(law, [process], SMALLER * STEPS)
            require_optimal(times, states, *arguments)
    return "from all initial states tried it agrees with the best process found, keeps to the ends, and costs no more"


@judged(Expression("domain", "parameters"))
def arc_transition_curve(claim, problem, change, domain, parameters):
    """Check the curve on which optimal controls change from one kind of arc to another.

    The curve lies in the plane of the states.

    `change` is a pair of "bound" and "inside", before and after; `domain` gives the interval of
    one state, in which the claim is the other one.
    """
    ((variable, interval),) = domain.items()
    state = list(problem.dynamics)
    k, low, high = state.index(variable), float(interval.inf), float(interval.sup)
    other_parameters = [p for p in parameters if p not in state]
    curve, points = real_function([variable, *other_parameters], [claim]), []
    for values, best in optima(problem, parameters):
        for j, *kinds in best.changes():
            y = best.states[:, j]
            if [_kind(best, u) for u in kinds] != list(change) or not low <= y[k] <= high:
                continue
            claimed = float(curve(y[k], *(float(values[p]) for p in other_parameters))[0])
            true = y[1 - k]
            points.append({variable: y[k], **{p: values[p] for p in other_parameters}})
            uncertain = uncertainty_at(claim, points[-1])
            if not np.isfinite(claimed):
                raise Wrong(f"for {variable} = {y[k]:.4g} your curve gives {NO_NUMBER}")
            if not agree(claimed, true, claim, true, LOCATED, uncertain):
                raise Wrong(
                    f"for {variable} = {y[k]:.4g} your curve gives {state[1 - k]} = {claimed:.4g}; the "
                    f"control of the best process {prefix_text(values)}does not change there"
                )
    if not points:
        raise RuntimeError("on no process that was found the control changes so")
    judge_at_every_scale(claim, problem, parameters, points, state[1 - k], str(state[1 - k]))
    return f"the control of the best processes changes there, at {len(points)} points"


def _kind(best, value):
    return "bound" if value is not None and value in best.bounds else "inside"


def _require_best_control(law, values, best):
    """Raise `Wrong` where the law differs from the best control at all states around a best one."""
    coarse = law.decimals and not law.perturbed
    times, states, controls = _compared_points(best, BEFORE[coarse])
    low, high = best.bounds
    largest = np.abs(best.states).max(axis=1, initial=0, keepdims=True)
    selected = (np.abs(states) > AWAY * largest).any(axis=0)
    times, states, controls = times[selected], states[:, selected], controls[selected]
    width = high - low if np.isfinite(high - low) else best.units.control + np.abs(controls)
    n, steps = len(states), BESIDE[coarse] * (np.abs(states) + 0.02 * largest)
    shifts = np.array(
        [s for s in itertools.product((-1, 0, 1), repeat=n) if n < 3 or np.count_nonzero(s) < 2]
    )
    around = states + shifts[:, :, None] * steps
    around, at = np.concatenate(list(around), axis=1), np.tile(times, len(shifts))
    claimed = law(around, at, values, best.bounds).reshape(len(shifts), -1)
    bends = [best.times[j] for j, *kinds in best.changes() if None in kinds]
    beside_bends = [any(abs(t - bend) < AWAY * best.duration for bend in bends) for t in times]
    accuracy = np.where(beside_bends, BENT, CONTROL_ACCURACY)
    slack = (accuracy + (law.rounding if coarse else 0)) * width
    for pair in law.perturbed:
        claimed_here, *sides = (
            variant(states, times, values, best.bounds) for variant in (law, *pair)
        )
        slack = slack + np.nan_to_num(np.fmax(*(abs(side - claimed_here) for side in sides)))
    inside = (np.nanmin(claimed, axis=0, initial=np.inf) - slack <= controls) & (
        controls <= np.nanmax(claimed, axis=0, initial=-np.inf) + slack
    )
    for k in np.flatnonzero(~inside)[:1]:
        value = law(states[:, [k]], times[[k]], values, best.bounds)[0]
        value_text = f"{value:.4g}" if np.isfinite(value) else law.no_value
        raise Wrong(
            f"{prefix_text(values)}the best process found comes to {point_text(states[:, k])}; "
            f"there your law gives {value_text}, unlike the best control"
        )
    _require_jumps(law, values, best)


def _require_scale_invariance(law, values, best, factors):
    """Raise `Wrong` for a law that changes with the units, in which the problem is the same."""
    times, states, _ = _compared_points(best, BEFORE[law.decimals])
    weights = [float(factors[x]) for x in law.state]
    scaled_states = np.array(weights)[:, None] * states
    scaled_values = {p: v * factors[p] for p, v in values.items()}
    scale, time = float(factors[law.control]), float(factors[TIME])
    bounds = [scale * bound for bound in best.bounds]
    claimed = law(scaled_states, times * time, scaled_values, bounds)
    expected = scale * law(states, times, values, best.bounds)
    for k in first_difference(
        claimed,
        expected,
        CONTROL_ACCURACY,
        lambda k: law.multiprecision()(
            scaled_states[:, [k]], times[[k]] * time, scaled_values, bounds
        )[0],
    ):
        raise Wrong(
            f"{prefix_text(values)}at {point_text(states[:, k])} your law gives "
            f"{expected[k] / scale:.4g}. In other units the problem is the same, but there your law gives "
            "another control at this state"
        )


def _compared_points(best, share):
    """Return times, states and controls of the best process, some of them close to changes."""
    offset = share * best.duration
    breaks = [best.times[j] for j, *_ in best.changes()]
    keep = [
        k
        for k, t in enumerate(best.times)
        if t < best.duration - offset / 2
        and all(abs(t - change_time) > offset / 2 for change_time in breaks)
    ]
    points = [(best.times[k], best.states[:, k], best.controls[k]) for k in keep]
    ends = [0.0, *breaks, best.duration]
    for (j, *kinds), begin, end in zip(best.changes(), ends, ends[2:]):
        for u, side, available in zip(kinds, (-1, 1), (best.times[j] - begin, end - best.times[j])):
            if u is not None and 2 * offset < available:
                state = _state_after(best, best.states[:, j], u, side * offset)
                points.append((best.times[j] + side * offset, state, u))
            elif u is None:
                points += [
                    part
                    for part in _points_near_change(best, j, side)
                    if abs(part[0] - best.times[j]) > offset / 2
                ]
    times, states, controls = zip(*points)
    return np.array(times), np.array(states).T, np.array(controls)


def _points_near_change(best, j, side):
    """Yield (time, state, control) between a change and the next time of a varying control."""
    next_control = best.controls[j + side]
    control_at_change = best.controls[j] if side < 0 else best.controls[j + 1]
    if side > 0:  # at the change only the control of the arc before it is known
        (t, s), (v, w) = best.times[j + 1 : j + 3] - best.times[j], best.controls[j + 1 : j + 3]
        control_at_change = v - (w - v) * t / (s - t)
    span, y = best.times[j + side] - best.times[j], np.append(best.states[:, j], 0)
    for part in CLOSER:

        def rates(t, z, slope=(next_control - control_at_change) / span):
            return best.field(z, control_at_change + slope * t)

        yield (
            best.times[j] + part * span,
            rk4(rates, 0, y, part * span)[:-1],
            control_at_change + part * (next_control - control_at_change),
        )


def _state_after(best, y, u, h):
    """Return the state after a short time, which may be negative, under a constant control."""
    return rk4(lambda _, z: best.field(z, u), 0, np.append(y, 0), h)[:-1]


def _require_jumps(law, values, best):
    """Raise `Wrong` for a law that changes gradually where the best control jumps.

    It is evaluated on the line from the state before the jump to the state that the motion would
    reach with the same control.
    """
    offset = BEFORE[law.decimals] * best.duration
    for j, before, after in best.changes():
        if before is None or after is None:
            continue
        t, state = best.times[[j]], best.states[:, j]
        before_jump, after_jump = (
            _state_after(best, state, before, h)[:, None] for h in (-offset, offset)
        )
        slack = law.rounding * abs(after - before)

        def near(u, points, t=t, start=before_jump, way=after_jump - before_jump, slack=slack):
            times = np.repeat(t, len(points))
            return abs(law(start + points * way, times, values, best.bounds) - u) <= slack

        if not (near(before, np.zeros(1)) and near(after, np.ones(1))):
            continue
        _, last = bisect(lambda points, _, u=before: near(u, points), np.zeros(1), np.ones(1), 30)
        if not near(after, np.minimum(last + ACROSS, 1)):
            raise Wrong(
                f"{prefix_text(values)}at {point_text(best.states[:, j])} the best control jumps; "
                "your law gives values between"
            )


def _motions_under_law(law, processes, steps=STEPS):
    """Return times and states of the motions under a law from all initial states.

    The control is constant in each of so many steps.
    """
    bests = [best for _, best in processes]
    values = {p: np.array([float(case[p]) for case, _ in processes]) for p in processes[0][0]}
    low, high = bounds = np.array([best.bounds for best in bests]).T
    slack = max(1e-9, law.rounding / 10) * np.where(np.isfinite(high - low), high - low, 1)
    h = np.array([best.duration for best in bests]) / steps
    y, t = np.array([best.start for best in bests]), 0 * h
    times, states = [], []
    for _ in range(steps):
        u = law(y[:, :-1].T, t, values, bounds)
        for k in np.flatnonzero(~((low - slack <= u) & (u <= high + slack))):
            claimed = "values outside the bounds" if np.isfinite(u[k]) else law.no_value
            raise Wrong(
                f"{prefix_text(processes[k][0])}the motion under your law comes to a state, "
                f"{process_part_text(t[k], bests[k].duration)}, for which the law gives {claimed}"
            )
        y = np.array(
            [
                rk4(lambda _, z, best=best, v=v: best.field(z, v), 0, *step)
                for best, v, *step in zip(bests, u.tolist(), y, h)
            ]
        )
        t = t + h
        states.append(y)
        times.append(t)
    return np.array(times).T, np.array(states).transpose(1, 0, 2)
