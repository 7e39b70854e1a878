"""States that begin at large numbers are solved for in other units.

Residuals are judged against the terms that cancel in an equation up to a size of CANCELLING; a
state far beyond it (a volume of 12000 cubic millimetres) leaves rounding errors that look like a
wrong structure. x = s X with a power of two s changes no digit of the equations, and psi = Psi/s.
"""

from copy import copy
from dataclasses import replace

import numpy as np

from trajlib.pontryagin.guesses import read_guess, refuse_start_on_target
from trajlib.pontryagin.infeasibility import refuse_infeasible
from trajlib.pontryagin.numeric import NumericProblem
from trajlib.pontryagin.shooting import CANCELLING, build_flows


def large_states(problem):
    """{state: power of two near its initial value}, for those that begin beyond CANCELLING."""
    start = {x: abs(float(v)) for x, v in problem.initial.items() if v is not None and v.is_number}
    return {x: 2 ** round(np.log2(v)) for x, v in start.items() if v > CANCELLING}


def measured_in(problem, units):
    """The same problem for x = s X, under the same names."""

    def put(e):
        return e.subs({x: s * x for x, s in units.items()}, simultaneous=True)

    return replace(
        problem,
        dynamics={x: put(f) / units.get(x, 1) for x, f in problem.dynamics.items()},
        initial={x: v if v is None else v / units.get(x, 1) for x, v in problem.initial.items()},
        terminal=[put(g) for g in problem.terminal],
        running=put(problem.running),
        final=put(problem.final),
    )


def solve_in_units(problem, units, structure, guess):
    """The extremal of a problem, found for states in these units."""
    from trajlib.pontryagin.extremal import found_extremal, solve

    numeric = NumericProblem(problem)
    # What is refused is told in the user's units.
    refuse_start_on_target(numeric)
    refuse_infeasible(numeric)
    sizes = np.array([float(units.get(x, 1)) for x in problem.state])
    start = read_guess(numeric, guess)
    if start is not None:
        duration, states, controls = start
        guess = {
            "duration": duration,
            **dict(zip(problem.state, (states / sizes).T)),
            **dict(zip(problem.control, controls.T)),
        }
    inner = solve(measured_in(problem, units), structure, guess)
    shot, n, made = copy(inner._shot), numeric.n, {}
    shot.flows = build_flows(numeric, [flow.kinds for flow in shot.flows], made)
    shot.starts = [
        np.concatenate([y[:n] * sizes, y[n : 2 * n] / sizes, y[2 * n :]]) for y in shot.starts
    ]
    return found_extremal(problem, numeric, shot, inner._starts, inner._found)
