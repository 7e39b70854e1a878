"""Costates along optimal processes, and the switching function that they give.

They are judged by the conditions of the maximum principle with lambda_0 = 1. `problem` and
`parameters` are those of `optimal_controls`.
"""

import numpy as np

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.shapes import LIST_OR_RANGES
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.pontryagin.changes_compared import (
    jumps_between_formulas,
    processes_between_changes,
)
from workbook.checks.pontryagin.parameter_ranges import with_ranges
from workbook.checks.pontryagin.simulation import point_text
from workbook.checks.pontryagin.time_functions import ENDING, Costates, InTime
from workbook.checks.references.optima.best_processes import best_processes, free_at_the_start
from workbook.checks.references.optima.units import is_time_optimal
from workbook.checks.tools.wording import NO_NUMBER, prefix_text, process_part_text

#: Relative accuracy of a control between its bounds.
CONTROL_ACCURACY = 2e-3
#: So much earlier, as a share of the time, costates are taken: formulas in parts may change at the time.
BEFORE = 1e-7
#: Costates and their rates that are smaller than this, in the units of the problem, are zero.
VANISHING = 1e-6


@judged(
    Costates("time", "parameters", problem="problem"),
    problem="pontryagin.Problem with one control, its duration also an interval",
    parameters=LIST_OR_RANGES,
)
def optimal_costate(claims, problem, time, parameters=None):
    """Check costates along the optimal process with lambda_0 = 1.

    They are a list in the order of the states, or one expression.

    Can decide when the problem has no constraints along the path and one control; the conditions
    of the maximum principle are tried along the best process found.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, u, L, t = sp.symbols("x u L t", positive=True)
    >>> move = Problem({x: u}, {u: (-sp.oo, sp.oo)}, {x: 0}, [x - L], u**2, duration=1)
    >>> checks.optimal_costate(2*L, move, t, [L]).status, checks.optimal_costate(L, move, t, [L]).status
    ('right', 'wrong')
    """
    parameters = with_ranges(problem, parameters)
    costate, sign = InTime(claims, time, parameters), -1 if problem.maximise else 1
    free = np.array(free_at_the_start(problem, parameters))
    for values, best in best_processes(problem, parameters):
        where = prefix_text(values)
        units = best.units.cost / (best.units.states * np.ones(len(best.start) - 1))
        largest = np.abs(np.nan_to_num(costate.values(best.times, values)).T / units).max()
        for t, jump, allowed in jumps_between_formulas(costate, values, best.duration):
            for x in np.array(problem.state)[~(np.abs(jump) <= allowed)][:1]:
                raise Wrong(f"{where}your costate of {x} jumps at t = {t:.4g}")
        points = [
            *(
                (t * (1 - BEFORE), y, u)
                for t, y, u in zip(best.times, best.states.T, best.controls)
            ),
            *processes_between_changes(costate.changes(values, best.duration), best),
        ]
        for t, y, u in points:
            psi, slope = (part(t, values) for part in (costate.values, costate.rates))
            if not np.all(np.isfinite([*psi, *slope])):
                part_text = process_part_text(t, best.duration)
                raise Wrong(f"{where}one of your costates is {NO_NUMBER}, {part_text}")
            # H is the product of these extended costates with the rates, the last of which is the
            # running cost.
            extended = np.append(psi, -sign)
            psi_uncertainty, slope_uncertainty = costate.uncertainty(t, values)
            psi_uncertainty = psi_uncertainty + BEFORE * t * np.abs(slope)
            location = f"{where}{process_part_text(t, best.duration)}"
            point, uncertainty = (best, y, u, units, location), np.append(psi_uncertainty, 0)
            accuracy = costate.rounding, largest, uncertainty, slope_uncertainty
            _require_adjoint_equation(extended, slope, problem.state, point, *accuracy)
            _require_maximum(extended, point, costate.rounding, problem.free_time, uncertainty)
        _require_equal_at_jumps(costate, best, values, sign, where)
        _, final, normals = best.jacobians(best.states[:, -1], best.controls[-1])
        psi, initial = costate.values(ENDING * best.duration, values), costate.values(0.0, values)
        _require_transversality(
            (psi + sign * final[0]) / units,
            normals / units if len(normals) else normals,
            costate.rounding * (largest + np.abs(final / units).sum()),
            f"{where}at the end your costates are {point_text(psi)}",
            costate.uncertainty(ENDING * best.duration, values)[0] / units,
        )
        if not np.all(
            np.abs(initial[free])
            <= (10 * costate.rounding * largest * units + costate.uncertainty(0.0, values)[0])[free]
        ):
            raise Wrong(
                f"{where}at the initial time your costates are {point_text(initial)}; that of a state "
                "whose initial value is free does not vanish there, against transversality"
            )
    return (
        "adjoint equations, maximum condition and transversality hold along the best process found"
    )


@judged(Expression("time"))
def optimal_switching(claim, problem, time):
    """Check the switching function dH/du along a transfer to a line, with lambda_0 = 1.

    The time of the transfer is minimised or maximised.

    Can decide when the time of a transfer to a line has a least or greatest value that
    `optimal_duration` knows.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> t = sp.Symbol("t", positive=True)
    >>> swing = Problem({x: v, v: -u*x}, {u: (1, 4)}, {x: 1, v: 0}, [v], maximise=True, first_return=True)
    >>> checks.optimal_switching(-sp.cos(t)**2, swing, t).status
    'right'
    >>> checks.optimal_switching(-1, swing, t).status
    'wrong'
    """
    if len(problem.terminal) != 1 or not is_time_optimal(problem):
        raise UnsuitableData("problem: expected a transfer to a line in the least or greatest time")
    function, ((_, best),) = InTime([claim], time, ()), best_processes(problem)
    samples = best.switching_function()
    size = max(abs(value) for _, value in samples)
    for t, true in samples:
        claimed = function.values(t, {})[0]
        if (
            not abs(claimed - true)
            <= 4 * function.rounding * size + function.uncertainty(t, {})[0][0]
        ):
            raise Wrong(
                f"{process_part_text(t, best.duration)} your function does not have the "
                f"{'sign' if claimed * true < 0 else 'value'} of dH/du, if the costate that "
                "transversality and H = 0 determine at the end is followed back along the best process"
            )
    return "it is dH/du along the best process, with the costate followed back from the end"


def _require_adjoint_equation(
    extended, slope, state, point, rounding, largest, uncertainty, slope_uncertainty
):
    best, y, u, units, location = point
    slopes = best.jacobians(y, u)[0].T
    terms = -slopes * extended
    size = np.abs(terms / units[:, None]).sum() + largest / best.duration
    # All of it is rounding where the best process stays at zero: there the problem has the scale.
    size = max(size, VANISHING / best.units.time)
    expected = terms.sum(axis=1)
    allowed = 10 * rounding * size * units + slope_uncertainty + np.abs(slopes) @ uncertainty
    if not np.all(np.abs(slope - expected) <= allowed):
        j = int(np.argmax(np.abs(slope - expected) / units))
        raise Wrong(
            f"{location} the adjoint equation for {state[j]} does not hold: your costate does not "
            f"change at the rate -dH/d{state[j]}"
        )


def _require_maximum(extended, point, rounding, free_time, uncertainty):
    best, y, u, _, location = point
    fields = [best.field(np.append(y, 0), v) for v in (u, *_rival_controls(best, u))]
    terms, *rival_terms = (extended * field for field in fields)
    H = terms.sum()
    greatest_rival = max(
        rival.sum() - uncertainty @ np.abs(field - fields[0])
        for rival, field in zip(rival_terms, fields[1:])
    )
    size = max(abs(H), *(abs(rival.sum()) for rival in rival_terms)) + np.abs(terms).sum()
    if not H >= greatest_rival - 10 * rounding * size:
        raise Wrong(
            f"{location} the optimal control does not make H greatest with your costates: another one "
            "gives more"
        )
    _require_stationary(extended, point, uncertainty)
    H_uncertainty = uncertainty @ np.abs(fields[0])
    unit = best.units.cost / best.units.time
    if free_time and not abs(H) <= 10 * rounding * (size + unit) + H_uncertainty:
        raise Wrong(f"{location} H with your costates is not zero, as a free duration requires")


def _require_equal_at_jumps(costate, best, values, sign, where):
    """Raise `Wrong` unless H has equal values before and after each jump of the best control.

    For the fastest transfers H = 0 implies it.
    """
    for j, *kinds in best.changes():
        if None in kinds:
            continue
        t, y = best.times[j], np.append(best.states[:, j], 0)
        extended = np.append(costate.values(t * (1 - BEFORE), values), -sign)
        uncertainty = np.append(costate.uncertainty(t * (1 - BEFORE), values)[0], 0)
        before, after = (best.field(y, u) for u in kinds)
        unit = best.units.cost / best.units.time
        allowed = (
            10 * costate.rounding * (np.abs(extended) @ (np.abs(before) + np.abs(after)) + unit)
        )
        if not abs(extended @ (after - before)) <= allowed + uncertainty @ np.abs(after - before):
            raise Wrong(
                f"{where}where the optimal control jumps H has two values with your costates, one "
                "before the jump and another after it"
            )


def _require_stationary(extended, point, uncertainty):
    """Raise `Wrong` unless dH/du = 0 where the control lies between its bounds."""
    best, y, u, units, location = point
    step = 1e-4 * (best.units.control + abs(u))
    if not best.bounds[0] < u - 9 * step < u + 9 * step < best.bounds[1]:
        return
    before, middle, after = (best.field(np.append(y, 0), u + side * step) for side in (-1, 0, 1))
    rate, curvature = (after - before) / (2 * step), after + before - 2 * middle
    sizes = np.append(units, 1)
    if (sizes * np.abs(curvature)).max() > 1e-2 * (sizes * np.abs(after - before)).max():
        return  # a corner, as of |u| at zero
    if not abs(extended @ rate) <= CONTROL_ACCURACY * np.abs(extended * rate).sum() + (
        uncertainty + CONTROL_ACCURACY / 10 * sizes
    ) @ np.abs(rate):
        raise Wrong(
            f"{location} dH/du is not zero with your costates, where the optimal control lies between "
            "its bounds"
        )


def _require_transversality(residual, normals, allowed, message, uncertainty):
    projection = np.eye(len(residual))
    if len(normals):
        projection -= np.linalg.pinv(normals) @ normals
    if not np.all(
        np.abs(projection @ residual) <= 10 * allowed + 1e-9 + np.abs(projection) @ uncertainty
    ):
        raise Wrong(f"{message}; the transversality condition does not hold for them")


def _rival_controls(best, u):
    """Return admissible controls with which the optimal control is compared."""
    low, high = best.bounds
    around = u + (best.units.control + abs(u)) * np.array([-1, -0.1, 0.1, 1])
    return [*np.clip(around, low, high), *(v for v in (low, high) if np.isfinite(v))]
