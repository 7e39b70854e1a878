"""Linear plants with a quadratic running cost and a polynomial of one state as terminal cost.

phi_0 = p(y_i). Among the processes that end with y_i = s the least running cost V(s) is a convex
quadratic function, and -V' is the multiplier of the terminal equation y_i = s: two linear solves
give it. So the least value of V + p on the real line decides the problem, and it lies at a root of
V' + p'. The extremal there is that of the linear terminal cost p'(s) y_i.
"""

from dataclasses import replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.infeasibility import LINEAR_TARGETS
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.linear_quadratic import solve_linear_quadratic
from trajlib.pontryagin.problem.errors import Infeasible, Unbounded
from trajlib.pontryagin.problem.hypotheses import GIVEN_TIME, UNBOUNDED_CONTROLS
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.scaling import sizes
from trajlib.pontryagin.problem.statement import Statement
from trajlib.pontryagin.problem.steps import Hypothesis, Method

PROOF = "a linear plant, a convex quadratic running cost, and the least of all stationary ends"


def solve_polynomial_end(problem: Statement) -> Extremal | None:
    """Return the best extremal for a terminal cost of degree three or more in one state.

    None where the rest of the problem is not linear-quadratic, or the certificate does not hold.
    Raises `Unbounded` if the cost falls without bound as that state grows.
    """
    (state,) = problem.final.free_symbols
    sign = -1 if problem.maximise else 1
    terminal_cost = sp.Poly(sign * problem.final, state)
    plain = replace(problem, running=sign * problem.running, final=0, maximise=False)
    # V' at two ends, the larger one as large as the state is expected to be.
    ends = (sp.Integer(0), sp.Integer(2) ** round(sizes(problem)[state]))
    slopes = [_cost_slope(plain, state, end) for end in ends]
    if None in slopes:
        return None
    running_slope = np.array([(slopes[1] - slopes[0]) / float(ends[1]), slopes[0]])
    if terminal_cost.degree() % 2 or terminal_cost.LC() < 0:
        raise Unbounded(
            f"the cost {'rises' if problem.maximise else 'falls'} without bound as {state} grows at "
            f"the final time: the terminal cost {problem.final} outweighs any running cost, which is "
            "quadratic. Check its sign, or bound the controls."
        )
    coefficients = [float(c) for c in terminal_cost.all_coeffs()]
    total_slope = np.polyadd(np.polyder(coefficients), running_slope)
    total = np.polyint(total_slope)
    roots = np.roots(total_slope)
    # A double root may come out as a complex pair; the real part of any other is no minimum.
    end = min(roots.real, key=lambda s: np.polyval(total, s))
    for _ in range(3):
        curvature = np.polyval(np.polyder(total_slope), end)
        end -= np.polyval(total_slope, end) / curvature if curvature > 0 else 0.0
    slope = sp.Rational(float(np.polyval(np.polyder(coefficients), end)))
    extremal = solve_linear_quadratic(NumericProblem(replace(plain, final=slope * state)))
    if extremal is None:
        return None
    reached = float(extremal.state(extremal.duration)[problem.state.index(state)])
    cost = extremal.cost - float(slope) * reached + np.polyval(coefficients, reached)
    extremal = replace(extremal, problem=problem, cost=float(sign * cost), _proof=PROOF)
    return extremal if extremal.certificate().holds() else None


def _cost_slope(problem, state, end):
    """Return dV/ds for processes that end with the state s = end; None if none does."""
    problem = replace(problem, terminal=[*problem.terminal, state - end])
    numeric = NumericProblem(problem)
    try:
        for refusal in LINEAR_TARGETS:
            refusal.check(numeric)
    except Infeasible:
        return None
    extremal = solve_linear_quadratic(numeric)
    return None if extremal is None else -extremal.terminal_multipliers[-1]


def _is_polynomial(problem):
    final = problem.final
    return (
        len(final.free_symbols) == 1
        and final.is_polynomial()
        and sp.degree(final, *final.free_symbols) >= 3
    )


POLYNOMIAL_END = Method(
    "polynomial terminal cost",
    "The least running cost to an end y_i = s is quadratic in s: the minimum over s is a root of a "
    "polynomial.",
    "trajlib.pontryagin.indirect.polynomial_end",
    (
        GIVEN_TIME,
        UNBOUNDED_CONTROLS,
        Hypothesis(
            "the terminal cost is a polynomial of degree three or more in one state",
            _is_polynomial,
        ),
    ),
    solve_polynomial_end,
)
