"""Controls in time under which the maximum principle holds."""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.pontryagin.sample_points import RIVALS, control_bounds
from workbook.checks.pontryagin.simulation import parabola_range
from workbook.checks.pontryagin.time_functions import Control, Steering
from workbook.checks.references.natural_units import COST, TIME
from workbook.checks.references.optima.runge_kutta import steered
from workbook.checks.references.optima.units import sample_units
from workbook.checks.references.singular_arcs import hamiltonian
from workbook.checks.tools.domains import sample_cases
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.wording import rounded_text


@judged(problem="pontryagin.Problem with one control and a given duration")
def extremal_control(answer, problem, time, parameters=None, start=None):
    """Check a control in time under which the maximum principle holds, optimal or not.

    For problems with one control, a given duration and a free end: the states are integrated
    forward in time, the costates backward. `parameters` is a dict from symbols in the control to
    intervals; with `start`, the control begins with this one of them.

    Can decide when the problem has one control, a given duration and a free end; constants of the
    control get sample values in their intervals.

    Examples
    --------
    >>> from trajlib.pontryagin import Problem
    >>> x, v, u = sp.symbols("x v u", real=True)
    >>> t = sp.Symbol("t", positive=True)
    >>> far = Problem({x: v, v: u}, {u: (-1, 1)}, {x: 0, v: 0}, final=-x, duration=1)
    >>> checks.extremal_control(1, far, t).status
    'right'
    >>> checks.extremal_control(-1, far, t).status
    'wrong'
    """
    u, (low, high) = problem.control[0], control_bounds(problem, {})[0]
    duration = float(problem.duration)
    arcs = Control.coerce(answer, [time, *(parameters or {})], time)
    steering, sign = Steering(arcs, time, parameters), -1 if problem.maximise else 1
    costates = [sp.Dummy() for _ in problem.state]
    units = sample_units(problem, costates, parameters)
    H, symbols = hamiltonian(problem, costates), [*problem.state, *costates, u]
    function = real_function(symbols, [H])
    flow = real_function(symbols, [*problem.field, *(-sp.diff(H, y) for y in problem.state)])
    final_costates = real_function(
        problem.state, [-sign * sp.diff(problem.final, y) for y in problem.state]
    )

    def advantage(steps):
        """Return H under the control minus H under others: a row a step, a column a control."""
        y = np.array([float(v) for v in problem.initial.values()])
        for _, h, controls in steps:
            y = steered(lambda z, v: flow(*z, *np.zeros_like(z), v)[: len(z)], controls, y, h)
        z, rows = np.concatenate([y, final_costates(*y)]), []
        for _, h, controls in reversed(steps):
            z = steered(lambda z, v: flow(*z, v), controls[::-1], z, -h)
            rows.append(
                function(*z, controls[0])[0] - function(*z, np.linspace(low, high, RIVALS))[0]
            )
        return np.array(rows[::-1])

    control_slack, unit = steering.rounding * float(units[u]), float(units[COST] / units[TIME])
    for case in sample_cases(parameters or {}):
        values = dict(zip(parameters or {}, case))
        where = f"for {rounded_text(values)} " if values else ""
        ends = steering.ends(values, duration)
        if ends and ends[-1] < (
            duration * (1 - steering.rounding) - steering.end_uncertainties(values)[-1]
        ):
            raise Wrong(
                f"{where}your last arc ends at {ends[-1]:.4g}, and the process lasts longer"
            )
        steps = _steps(steering.sections(values, duration))
        for t, _, controls in steps:
            for value in controls:
                if not low - control_slack <= value <= high + control_slack:
                    raise Wrong(
                        f"{where}your control is {value:.4g} near t = {t:.4g}, outside its bounds"
                    )
        if start is not None and not abs(steps[0][2][0] - values[start]) <= control_slack:
            raise Wrong(f"{where}your control begins with {steps[0][2][0]:.4g}")
        advantages = advantage(steps)
        uncertainty = np.zeros_like(advantages)
        for pair in steering.perturbed:
            sides = [advantage(_steps(side.sections(values, duration))) for side in pair]
            if all(side.shape == advantages.shape for side in sides):
                uncertainty += parabola_range(*(side - advantages for side in sides))[1]
        slack = 10 * steering.rounding * (unit + np.abs(advantages).max())
        for k in np.flatnonzero((advantages + uncertainty < -slack).any(axis=1))[-1:]:
            raise Wrong(
                f"{where}at t = {steps[k][0]:.4g} your control, with the costates that belong to "
                "it, gives a smaller H than another admissible one does"
            )
    return "it makes H greatest all the time, with the costates that belong to it"


def _steps(sections, count=120):
    """Return small steps of a control: (time, length, values at beginning, middle and end)."""
    steps = []
    for begin, end, u in sections:
        claimed, h = u(np.linspace(begin, end, 2 * count + 1)), (end - begin) / count
        steps += [(begin + k * h, h, claimed[2 * k : 2 * k + 3]) for k in range(count)]
    return steps
