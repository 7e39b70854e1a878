"""Motions, and their final states, under a law in time that is given up to some constants.

`problem` is a `pontryagin.Problem` with a given duration and one control, `law` its value as an
expression in `time` and `parameters`, continuous in time: a dict from symbols to the intervals in
which answers are compared. Nothing is optimised here: the motion is integrated in small steps from
the initial state of the problem.
"""

import functools
import itertools

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Expression, Expressions
from workbook.checks.contract.tolerance import agree
from workbook.checks.contract.verdict import Wrong, judged
from workbook.checks.references.optima.runge_kutta import steered
from workbook.checks.tools.domains import sample_cases
from workbook.checks.tools.numeric_functions import real_function
from workbook.checks.tools.values import uncertainty_at, value_at
from workbook.checks.tools.wording import prefix_text, rounded_text, tried_text

#: Number of steps in which a motion is integrated, and the relative accuracy of its states.
STEPS, COMPUTED = 240, 1e-7
#: An answer is compared at each step whose number is a multiple of this.
STRIDE = 30
#: Number of initial values of each unknown for Newton's method and of its iterations; the residual
#: of the final conditions at convergence, relative to the size of the states.
STARTS, ITERATIONS, CONVERGED = 4, 30, 1e-10


@judged(
    Expressions(lambda data: [data["by"] or data["time"]], "parameters", length="problem.state"),
    problem="pontryagin.Problem with one control and a given duration",
)
def motion_under_law(claims, problem, law, time, parameters, by=None):
    """Check all states of the motion under a law as functions of time.

    With `by`, the control, they are functions of the control instead of the time.
    """
    run, (control,) = _Run(problem, law, time, list(parameters)), problem.control
    variable = time if by is None else control
    for case in sample_cases(parameters):
        values = dict(zip(parameters, case))
        times, states, controls = run(*(np.array([float(v)]) for v in case))
        size = np.abs(states).max(axis=0)
        for k in range(0, STEPS + 1, STRIDE):
            point = values | {variable: sp.Float((times if by is None else controls)[k, 0], 17)}
            for name, claim, true, scale in zip(problem.state, claims, states[k, :, 0], size[:, 0]):
                claimed = value_at(claim, point, str(name))
                if not agree(claimed, true, claim, scale, COMPUTED, uncertainty_at(claim, point)):
                    raise Wrong(
                        f"for {rounded_text(point)} your {name} is {claimed:.4g}; this "
                        + (
                            "is not reached under the given law, if the initial conditions hold"
                            if k
                            else "does not satisfy the initial condition"
                        )
                    )
    return f"it is the motion under the law{tried_text(parameters, 'times')}"


@judged(Expression("parameters"))
def final_value_under_law(claim, quantity, problem, law, time, unknown, parameters):
    """Check a final quantity in the final states, the constants of the law and the parameters.

    The constants of the law are unknown.

    `unknown` is a dict from these constants, the duration perhaps among them, to intervals, as
    many as the problem has conditions at the end. These conditions determine one value of each
    constant in its interval.
    """
    names = [*unknown, *parameters]
    final_quantity = real_function([*problem.state, *names], [sp.sympify(quantity)])
    for case, constants, state, sizes in _final_states(
        problem, law, time, tuple(unknown.items()), tuple(parameters.items())
    ):
        values = dict(zip(parameters, case))
        true = final_quantity(*state, *constants, *case)[0]
        claimed = value_at(claim, values, str(quantity))
        # how far relative errors of the states could move the quantity
        shifted = [final_quantity(*y, *constants, *case)[0] for y in state + np.diag(1e-6 * sizes)]
        size = abs(true) + 1e6 * sum(abs(value - true) for value in shifted)
        if not agree(claimed, true, claim, size, 10 * COMPUTED, uncertainty_at(claim, values)):
            # The true number would be the answer itself where there are no parameters.
            raise Wrong(
                f"{prefix_text(values)}your {quantity} is {claimed:.4g}; this is not its value where the "
                "constants of the law satisfy the conditions at the end"
            )
    return f"it is the value that the conditions at the end give{tried_text(parameters)}"


class _Run:
    """Motions for arrays of values of the symbols `names`.

    A call returns times, states and controls, with a row for each step.
    """

    def __init__(self, problem, law, time, names):
        self._steered = real_function([time, *names], [sp.sympify(law)])
        self._field = real_function([*problem.state, *problem.control, *names], list(problem.field))
        self._start = real_function(names, [*problem.initial.values(), problem.duration])

    def __call__(self, *numbers):
        numbers = np.broadcast_arrays(*(np.atleast_1d(np.asarray(n, dtype=float)) for n in numbers))
        *y, duration = self._start(*numbers)
        y, h = np.array(y), duration / STEPS
        halves = [self._steered(k * h / 2, *numbers)[0] for k in range(2 * STEPS + 1)]
        states = [y]
        for k in range(STEPS):
            y = steered(lambda z, u: self._field(*z, u, *numbers), halves[2 * k : 2 * k + 3], y, h)
            states.append(y)
        return np.outer(range(STEPS + 1), h), np.array(states), np.array(halves[::2])


@functools.lru_cache(maxsize=32)
def _final_states(problem, law, time, unknown, parameters):
    """Return (case, constants, final state, sizes of the states) for each case of the parameters.

    With these constants the conditions at the end hold.
    """
    unknown, parameters = dict(unknown), dict(parameters)
    names, cases = [*unknown, *parameters], np.array(sample_cases(parameters)).T
    run = _Run(problem, law, time, names)
    terminal_conditions = real_function([*problem.state, *names], list(problem.terminal))
    low, high = (
        np.array([float(getattr(domain, side)) for domain in unknown.values()])[:, None]
        for side in ("inf", "sup")
    )
    shares = (np.arange(STARTS) + 0.5) / STARTS
    initial_points = (
        low + (high - low) * np.array(list(itertools.product(shares, repeat=len(unknown)))).T
    )
    points = np.tile(initial_points, cases.shape[1])
    point_cases = np.repeat(cases, initial_points.shape[1], axis=1)

    def residual(candidates, candidate_cases):
        states = run(*candidates, *candidate_cases)[1]
        return terminal_conditions(*states[-1], *candidates, *candidate_cases)

    converged, width = _newton(residual, points, point_cases, low, high), high - low
    solutions = []
    for k, _case in enumerate(cases.T):
        part = slice(k * initial_points.shape[1], (k + 1) * initial_points.shape[1])
        roots = points[:, part][:, converged[part]]
        if not roots.shape[1] or np.any(np.ptp(roots, axis=1) > 1e-6 * width[:, 0]):
            raise RuntimeError(f"the constants of the law are not determined: {roots.T.tolist()}")
        solutions.append(roots[:, 0])
    _, states, _ = run(*np.array(solutions).T, *cases)
    return [
        (tuple(case), constants, states[-1, :, k], np.abs(states[:, :, k]).max(axis=0))
        for k, (case, constants) in enumerate(zip(cases.T, solutions))
    ]


def _newton(residual, points, cases, low, high):
    """Move many points to roots by Newton's method; return which of them converged."""
    width, unknowns = high - low, len(points)
    increment, converged = 1e-6 * width, np.zeros(points.shape[1], dtype=bool)
    for _ in range(ITERATIONS):
        shifted_points = [
            points,
            *(points + increment * np.eye(unknowns)[:, [j]] for j in range(unknowns)),
        ]
        all_residuals = residual(np.hstack(shifted_points), np.tile(cases, unknowns + 1))
        residuals, *shifted_residuals = np.split(all_residuals, unknowns + 1, axis=1)
        # unknown, condition, point
        slopes = np.array(
            [(shifted - residuals) / increment[j] for j, shifted in enumerate(shifted_residuals)]
        )
        for k in np.flatnonzero(~converged):
            step = np.linalg.lstsq(slopes[:, :, k].T, -residuals[:, k], rcond=None)[0]
            # Conditions may have different units, the constants have the widths of their intervals.
            converged[k] = np.all(np.abs(step) <= CONVERGED * width[:, 0])
            step = np.clip(step, -0.3 * width[:, 0], 0.3 * width[:, 0])
            points[:, k] = np.clip(points[:, k] + step, low[:, 0], high[:, 0])
        if converged.all():
            break
    return converged
