"""Optimal motions, judged as the process with the control that produces them.

The data are those of `optimal_controls`.
"""

import numpy as np

from workbook.checks.contract.shapes import LIST_OR_RANGES
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.changes_compared import (
    jumps_between_formulas,
    processes_between_changes,
)
from workbook.checks.pontryagin.parameter_ranges import with_ranges
from workbook.checks.pontryagin.simulation import (
    point_text,
    require_end_conditions,
    require_single_meeting,
)
from workbook.checks.pontryagin.time_functions import ENDING, InTime, Motion, jumps
from workbook.checks.references.optima.best_processes import best_processes, free_at_the_start
from workbook.checks.references.optima.units import is_time_optimal
from workbook.checks.tools.wording import NO_NUMBER, prefix_text, process_part_text, round_instants

#: Where rates are not linear in the control: number of parts of its interval, number of refinements
#: around the best value, and the largest absolute value where it has no bounds.
PARTS, ROUNDS, UNBOUNDED = 24, 7, 20.0


@judged(
    Motion("time", "parameters", problem="problem", time="time"),
    problem="pontryagin.Problem with one control, its duration also an interval",
    parameters=LIST_OR_RANGES,
)
def optimal_motion(claims, problem, time, parameters=None):
    """Check an optimal motion, all states as functions of time and parameters.

    The first state suffices if the others are its derivatives.

    Can decide when the problem has no constraints along the path and one control: the best process
    is searched numerically, without the maximum principle, at sample values of the parameters.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, u, L, t = sp.symbols("x u L t", positive=True)
    >>> move = Problem({x: u}, {u: (-sp.oo, sp.oo)}, {x: 0}, [x - L], u**2, duration=1)
    >>> checks.optimal_motion(L*t, move, t, [L]).status, checks.optimal_motion(L*t**2, move, t, [L]).status
    ('right', 'wrong')
    """
    parameters = with_ranges(problem, parameters)
    motion = InTime(claims, time, parameters)
    has_initial_value = ~np.array(free_at_the_start(problem, parameters))
    # A motion that arrives in the least time is optimal, whatever its earlier states are.
    only_time = is_time_optimal(problem)
    for values, best in best_processes(problem, parameters):
        where, slack = prefix_text(values), motion.rounding * best.size() * best.units.states
        start = motion.values(0.0, values)
        if not np.isfinite(start[has_initial_value]).all():
            raise Wrong(f"{where}your motion is {NO_NUMBER}, at the initial time")
        allowed = slack + motion.uncertainty(0.0, values)[0]
        if not np.all((np.abs(start - best.start[:-1]) <= allowed)[has_initial_value]):
            raise Wrong(
                f"{where}your motion does not satisfy the initial conditions: it starts at "
                f"{point_text(start)}"
            )
        states = [_admissible_state(motion, t, values, best, problem, where) for t in best.times]
        for j, name in enumerate(problem.dynamics):
            for t in jumps(lambda times, j=j: motion.values(times, values)[j], best.duration):
                before, after = (
                    motion.values(t * (1 + side * 1e-6), values)[j] for side in (-1, 1)
                )
                if (
                    not abs(after - before)
                    <= (motion.uncertainty(t * (1 - 1e-6), values)[0] + slack)[j]
                ):
                    raise Wrong(f"{where}on your motion {name} jumps at t = {t:.4g}")
        for t, jump, allowed in jumps_between_formulas(motion, values, best.duration):
            for name in np.array(problem.state)[~(np.abs(jump) <= allowed)][:1]:
                raise Wrong(f"{where}on your motion {name} jumps at t = {t:.4g}")
        if problem.first_return:
            require_single_meeting([0.0, *best.times], [start, *states], best, where)
        end = np.append(motion.values(ENDING * best.duration, values), 0)
        sides = np.diag(np.append(motion.uncertainty(ENDING * best.duration, values)[0], 0))
        ends = [(end - side, end + side) for side in sides]
        require_end_conditions(end, best, motion.rounding, where + "on your motion", ends)
        differences = np.abs(np.array(states)[:, :-1].T - best.states)
        if not (
            only_time
            or np.all(differences.T <= 3 * slack + motion.uncertainty(best.times, values)[0].T)
        ):
            raise Wrong(
                f"{where}your motion is one that the system can have, but another one with the "
                "same ends does better"
            )
        if not only_time:
            _require_same_rates(motion, values, best, where)
    return "it starts where it should, obeys the equations, keeps to the ends, and is the best motion found"


def _require_same_rates(motion, values, best, where):
    """Raise `Wrong` where the motion follows another control than the best one, if only briefly."""
    for t, y, u in processes_between_changes(motion.changes(values, best.duration), best):
        difference = np.abs(motion.rates(t, values) - best.field(np.append(y, 0), u)[:-1])
        if not np.all(difference <= _rate_tolerance(motion, t, values, best, y)):
            raise Wrong(
                f"{where}your motion follows another control than the best one for a while: its "
                "control changes too early or too late"
            )


def _rate_tolerance(motion, t, values, best, y):
    units = best.units.states * np.ones(len(y))
    largest = (np.abs(best.states).T / units).max()
    scale = 10 * motion.rounding * (1 + largest * (1 + best.units.time / best.duration))
    scale = scale * units / best.units.time
    y_uncertainty, rate_uncertainty = motion.uncertainty(t, values)
    if y_uncertainty.any():
        middle = np.mean(np.nan_to_num(best.bounds, posinf=0, neginf=0))
        total_uncertainty = (
            rate_uncertainty + np.abs(best.jacobians(y, middle)[0])[:-1, : len(y)] @ y_uncertainty
        )
        scale += (total_uncertainty / units).sum() * units
    return scale


def _admissible_state(motion, t, values, best, problem, where):
    """Return the state of a motion at an instant, with a zero for the cost.

    Raise `Wrong` if it does not obey the equations there under any admissible control.
    """
    instant = t * (1 - 1e-7)  # at a jump of the control a derivative need not exist
    y, part_text = motion.values(instant, values), process_part_text(t, best.duration)
    if not np.all(np.isfinite([*y, *motion.rates(instant, values)])):
        raise Wrong(f"{where}your motion is {NO_NUMBER}, {part_text}")
    if (k := _inadmissible_rate(motion, instant, values, best)) is not None:
        ending = "" if len(y) == 1 else ", with the other rates that it has there"
        text = f"{part_text} your motion has a rate {problem.state[k]}'"
        for named in round_instants(best.duration):
            rates, j = motion.rates(named, values), _inadmissible_rate(motion, named, values, best)
            if j is not None and np.isfinite(rates[j]):
                text = f"at t = {named:.4g} your motion has {problem.state[j]}' = {rates[j]:.4g}"
                break
        raise Wrong(f"{where}{text}, which no admissible control gives there{ending}")
    return np.append(y, 0)


def _inadmissible_rate(motion, t, values, best):
    """Return the index of the worst rate of a motion if no admissible control gives its rates."""
    y, rate = motion.values(t, values), motion.rates(t, values)
    units = best.units.states * np.ones(len(y))
    scale = _rate_tolerance(motion, t, values, best, y)
    differences = np.abs(_nearest_rates(best, y, rate / units) * units - rate)
    return None if np.all(differences <= scale) else int(np.argmax(differences / units))


def _nearest_rates(best, y, rate):
    """Return the rates of the states under an admissible control that are nearest to `rate`.

    States and control are in their units.
    """
    unit = best.units.control

    def rates(u):
        return np.array(
            [best.field(np.append(y, 0), unit * v)[:-1] / best.units.states for v in u]
        ).T

    low, high = (bound / unit for bound in best.bounds)
    rates_0, rates_1, rates_2 = rates([0.0, 1.0, 2.0]).T
    slope = rates_1 - rates_0
    if np.allclose(rates_2 - rates_1, slope, rtol=1e-12, atol=1e-12) and np.allclose(
        rates([-np.pi])[:, 0], rates_0 - np.pi * slope, rtol=1e-9, atol=1e-9
    ):
        size = slope @ slope
        return rates_0 + slope * np.clip(
            slope @ (rate - rates_0) / size if size else 0.0, low, high
        )
    # An angle is tried over a full turn, any other control up to `UNBOUNDED`.
    is_angle = np.allclose(
        rates([0.3, 1.7]), rates([0.3 + 2 * np.pi, 1.7 + 2 * np.pi]), rtol=1e-9, atol=1e-9
    )
    begin, end = np.clip(
        (-np.pi, np.pi) if is_angle and high - low >= 2 * np.pi else (-UNBOUNDED, UNBOUNDED),
        low,
        high,
    )
    for _ in range(ROUNDS):
        points = np.linspace(begin, end, PARTS + 1)
        sampled_rates = rates(points)
        k = int(np.argmin(np.linalg.norm(sampled_rates - rate[:, None], axis=0)))
        begin, end = points[max(k - 1, 0)], points[min(k + 1, PARTS)]
    return sampled_rates[:, k]
