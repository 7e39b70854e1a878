"""Costates along optimal processes, and the switching function that they give.

They are judged by the conditions of the maximum principle with lambda_0 = 1. `problem` and
`parameters` are those of `optimal_controls`.
"""

import numpy as np

from workbook.checks.contract.claims import Expression
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.simulation import point_text
from workbook.checks.pontryagin.time_functions import ENDING, Costates, InTime
from workbook.checks.references.optima.best_processes import best_processes, free_at_the_start
from workbook.checks.tools.wording import prefix_text

#: To which share a control between its bounds is known.
KNOWN = 2e-3


@judged(Costates("time", "parameters", problem="problem"))
def optimal_costate(claims, problem, time, parameters=None):
    """Check costates along the optimal process with lambda_0 = 1.

    They are a list in the order of the states, or one expression.
    """
    costate, sign = InTime(claims, time, parameters), -1 if problem.maximise else 1
    free = np.array(free_at_the_start(problem, parameters))
    for values, best in best_processes(problem, parameters):
        where = prefix_text(values)
        units = best.units.cost / (best.units.states * np.ones(len(best.start) - 1))
        largest = np.abs(np.nan_to_num(costate.values(best.times, values)).T / units).max()
        for k, t in enumerate(best.times):
            psi, slope = (part(t * (1 - 1e-7), values) for part in (costate.values, costate.rates))
            if not np.all(np.isfinite([*psi, *slope])):
                raise Wrong(f"{where}at t = {t:.4g} your costates are not real")
            # H is the product of this with the rates, the running cost being the last of them.
            full, along = (
                np.append(psi, -sign),
                (best, best.states[:, k], best.controls[k], costate.rounding),
            )
            open_psi, open_slope = costate.uncertain(t * (1 - 1e-7), values)
            _adjoint(
                full,
                slope,
                *along,
                units,
                largest,
                list(problem.dynamics),
                f"{where}at t = {t:.4g}",
                (open_psi, open_slope),
            )
            _greatest(
                full, *along, problem.duration, f"{where}at t = {t:.4g}", np.append(open_psi, 0)
            )
        _equal_at_jumps(costate, best, values, sign, where)
        _, final, normals = best.jacobians(best.states[:, -1], best.controls[-1])
        psi, begin = costate.values(ENDING * best.duration, values), costate.values(0.0, values)
        _transversal(
            (psi + sign * final[0]) / units,
            normals / units if len(normals) else normals,
            costate.rounding * (largest + np.abs(final / units).sum()),
            f"{where}at the end your costates are {point_text(psi)}",
            costate.uncertain(ENDING * best.duration, values)[0] / units,
        )
        if not np.all(
            np.abs(begin[free])
            <= (10 * costate.rounding * largest * units + costate.uncertain(0.0, values)[0])[free]
        ):
            raise Wrong(
                f"{where}at the beginning your costates are {point_text(begin)}; what is free "
                "there has none"
            )
    return (
        "adjoint equations, maximum condition and transversality hold along the best process found"
    )


@judged(Expression("time"))
def optimal_switching(claim, problem, time):
    """Check the switching function dH/du along a transfer to a line, with lambda_0 = 1.

    The time of the transfer is minimised or maximised.
    """
    function, ((_, best),) = InTime([claim], time, ()), best_processes(problem)
    found = best.switching_function()
    size = max(abs(value) for _, value in found)
    for t, true in found:
        claimed = function.values(t, {})[0]
        if (
            not abs(claimed - true)
            <= 4 * function.rounding * size + function.uncertain(t, {})[0][0]
        ):
            raise Wrong(
                f"at t = {t:.4g} your function is {claimed:.4g}; dH/du has another "
                f"{'sign' if claimed * true < 0 else 'value'} there, if the costate that "
                "transversality and H = 0 "
                f"determine at the end is followed back along the best process"
            )
    return "it is dH/du along the best process, with the costate followed back from the end"


def _adjoint(full, slope, best, y, u, rounding, units, largest, state, there, left_open):
    terms = -best.jacobians(y, u)[0].T * full
    size = np.abs(terms / units[:, None]).sum() + largest / best.duration
    wanted = terms.sum(axis=1)
    allowed = (
        10 * rounding * size * units
        + left_open[1]
        + np.abs(best.jacobians(y, u)[0].T) @ np.append(left_open[0], 0)
    )
    if not np.all(np.abs(slope - wanted) <= allowed):
        j = int(np.argmax(np.abs(slope - wanted) / units))
        raise Wrong(
            f"{there} the adjoint equation for {state[j]} does not hold: with your costates it "
            "demands another derivative than theirs"
        )


def _greatest(full, best, y, u, rounding, duration, there, left_open):
    here, *others = (full * best.field(np.append(y, 0), v) for v in (u, *_others(best, u)))
    fields = [best.field(np.append(y, 0), v) for v in (u, *_others(best, u))]
    H, most = (
        here.sum(),
        max(
            other.sum() - left_open @ np.abs(field - fields[0])
            for other, field in zip(others, fields[1:])
        ),
    )
    size = max(abs(H), *(abs(other.sum()) for other in others)) + np.abs(here).sum()
    if not H >= most - 10 * rounding * size:
        raise Wrong(
            f"{there} the optimal control does not make H greatest with your costates: another one "
            "gives more"
        )
    _stationary(full, best, y, u, left_open, there)
    open_H = left_open @ np.abs(fields[0])
    if (duration is None or isinstance(duration, tuple)) and not abs(H) <= 10 * rounding * (
        size + best.units.cost / best.units.time
    ) + open_H:
        raise Wrong(f"{there} H with your costates is not what a free duration demands")


def _equal_at_jumps(costate, best, values, sign, where):
    """Where the best control jumps H has to be the same for both of its values. Of the fastest
    transfers H = 0 says it."""
    for j, *kinds in getattr(best, "changes", list)():
        if None in kinds:
            continue
        t, y = best.times[j], np.append(best.states[:, j], 0)
        full, left_open = (
            np.append(part, last)
            for part, last in (
                (costate.values(t * (1 - 1e-7), values), -sign),
                (costate.uncertain(t * (1 - 1e-7), values)[0], 0),
            )
        )
        before, after = (best.field(y, u) for u in kinds)
        unit = best.units.cost / best.units.time
        allowed = 10 * costate.rounding * (np.abs(full) @ (np.abs(before) + np.abs(after)) + unit)
        if not abs(full @ (after - before)) <= allowed + left_open @ np.abs(after - before):
            raise Wrong(
                f"{where}where the optimal control jumps H has two values with your costates, one "
                "before the jump and another after it"
            )


def _stationary(full, best, y, u, left_open, there):
    """dH/du = 0 where the control lies between its bounds."""
    step = 1e-4 * (best.units.control + abs(u))
    if not best.bounds[0] < u - 9 * step < u + 9 * step < best.bounds[1]:
        return
    before, here, after = (best.field(np.append(y, 0), u + side * step) for side in (-1, 0, 1))
    rate, bend = (after - before) / (2 * step), after + before - 2 * here
    if np.abs(bend).max() > 1e-2 * np.abs(after - before).max():
        return  # a corner, as of |u| at zero
    if not abs(full @ rate) <= KNOWN * np.abs(full * rate).sum() + (
        left_open + KNOWN / 10
    ) @ np.abs(rate):
        raise Wrong(
            f"{there} dH/du is not zero with your costates, where the optimal control lies between "
            "its bounds"
        )


def _transversal(rest, normals, allowed, what, left_open):
    along = (
        np.eye(len(rest)) - np.linalg.pinv(normals) @ normals if len(normals) else np.eye(len(rest))
    )
    if not np.all(np.abs(along @ rest) <= 10 * allowed + 1e-9 + np.abs(along) @ left_open):
        raise Wrong(f"{what}; the condition of transversality does not hold for them")


def _others(best, u):
    """Controls with which that of the optimum is compared."""
    low, high = best.bounds
    around = u + (best.units.control + abs(u)) * np.array([-1, -0.1, 0.1, 1])
    return [*np.clip(around, low, high), *(v for v in (low, high) if np.isfinite(v))]
