"""Linear plants with a quadratic cost: the extremal by one linear solve.

y' = A y + B u + c with f_0 and phi_0 of at most the second degree, R = d2f_0/du2 positive definite,
no bounds on u, linear terminal equations G y = d and a given duration. Then H_u = 0 gives

    u = R^-1 (B^T psi - S^T y - r),        S = d2f_0/dy du,   r = df_0/du at zero,

and with it a linear system z' = K z for z = (y, psi, 1) with linear conditions at both ends. The cost
follows from their values, since with the linear terms q y + r u and the constant w of f_0

    2 f_0 = d/dt psi^T y + q^T y + r^T u - c^T psi + 2 w.

The fundamental matrix e^(K T) has entries of very different sizes (T^j/j! with j < 2n for a chain of n
integrators), and the linear equations for z(0) lose as many digits as these sizes differ: so they
are solved with as many digits as it takes until the rounded values no longer change.

The cost need not be convex. It is a quadratic functional of the variation v of a process,
J = J(extremal) + Q(v), Q being half the second variation: if Q is positive, the extremal is the
only optimal process; if it is negative in one direction, the cost falls without bound along it.
Where the linear equations have no solution, it falls without bound too (`conjugate_end`).
"""

from dataclasses import replace

import mpmath
import numpy as np
import sympy as sp

from trajlib.pontryagin.indirect.assembly import extremal_of_shot
from trajlib.pontryagin.indirect.conjugate_end import refuse_conjugate_end
from trajlib.pontryagin.indirect.extremal import Extremal
from trajlib.pontryagin.indirect.flow import ArcFlow
from trajlib.pontryagin.indirect.linear_boundary_problem import (
    boundary_problem,
    evaluated,
    linear_equations,
)
from trajlib.pontryagin.indirect.newton import CANCELLING
from trajlib.pontryagin.indirect.refinement import INTEGRATED, finer_steps, growth
from trajlib.pontryagin.indirect.scaled_extremal import restore_units
from trajlib.pontryagin.indirect.shooting import ShootingSolution
from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.hypotheses import GIVEN_TIME, UNBOUNDED_CONTROLS
from trajlib.pontryagin.problem.numeric import NumericProblem
from trajlib.pontryagin.problem.scaling import units_of_process
from trajlib.pontryagin.problem.steps import Hypothesis, Method
from trajlib.pontryagin.verification.optimality import sufficiency_theorem
from trajlib.pontryagin.verification.second_variation import EXTRAPOLATED

# Decimal digits of the first attempt, doubled until two attempts agree, and at most so many.
DIGITS, MAX_DIGITS = 40, 1280
# Relative difference of attempts that agree.
AGREEMENT = 1e-15
# Largest number of segments, along each of which errors grow by CANCELLING at most.
MAX_SEGMENTS = 512
PROOF = "a linear plant, and a quadratic cost whose second variation is positive in floats"
# Points on each segment at which the sizes of the values are taken.
SAMPLES = 16


def solve_linear_quadratic(numeric: NumericProblem) -> Extremal | None:
    """Return the extremal of a linear-quadratic problem.

    None for other problems, and where the linear equations have no unique solution. The target must
    not be infeasible (`direct.infeasibility`). Raises `Unbounded` if the second variation is
    negative, or if the linear equations have no solution (`conjugate_end`).
    """
    problem, duration = numeric.problem, numeric.duration
    if duration is None or not LINEAR_QUADRATIC.applies(problem):
        return None
    boundary = boundary_problem(problem)
    count = boundary and _segment_count(boundary.K, duration)
    if not count:
        return None
    solution = _solution(boundary, problem.duration, SAMPLES * count)
    if not solution:
        # The direction in which the cost falls may violate an inequality.
        if not problem.constrained:
            refuse_conjugate_end(boundary, problem, SAMPLES * count)
        return None
    samples, nu, (cost,) = solution
    cost = float(-cost if problem.maximise else cost)
    multipliers = np.zeros(numeric.m)
    multipliers[list(boundary.rows)] = nu
    n = numeric.n
    scaling = units_of_process(
        problem, samples[:, :n].T, samples[:, n : 2 * n].T, samples[:, 2 * n :].T, duration
    )
    if scaling is None:
        extremal = _decided(_extremal(numeric, samples, multipliers), problem)
        return replace(extremal, cost=cost)
    states, terminal = (
        np.array(v, dtype=float) for v in (scaling.states, scaling.terminal[: numeric.m])
    )
    unit = float(scaling.cost)
    units = np.concatenate([states, unit / states, np.array(scaling.controls, dtype=float)])
    inner = NumericProblem(scaling.problem, scaling)
    extremal = _decided(_extremal(inner, samples / units, multipliers * terminal / unit), problem)
    return replace(restore_units(scaling, extremal), cost=cost)


def _is_linear_quadratic(problem):
    """Check for a linear plant with linear terminal equations and a quadratic cost."""
    arguments = [*problem.state, *problem.control]
    slopes = [
        sp.diff(e, s)
        for e in (*problem.field, *problem.terminal, *_gradient(problem))
        for s in arguments
    ]
    return not any(slope.free_symbols & set(arguments) for slope in slopes)


def _gradient(problem):
    """Return the derivatives of f_0 and phi_0 by states and controls."""
    arguments = [*problem.state, *problem.control]
    return [sp.diff(e, s) for e in (problem.running, problem.final) for s in arguments]


def _decided(extremal, problem):
    """Return the extremal, proved optimal where the second variation is clearly positive.

    `problem`: in the user's units. Raises `Unbounded` where it is clearly negative. Clear are values
    beyond the errors of extrapolation; smaller ones with a sign are evidence, not more.
    """
    if sufficiency_theorem(problem) is not None:
        return extremal
    variation = extremal._variation
    if not abs(variation.least) > EXTRAPOLATED * variation.largest and variation.least != np.inf:
        return extremal
    sign = variation.sign
    # The direction in which the cost falls may violate an inequality.
    if sign < 0 and not problem.constrained:
        raise Unbounded(
            f"the cost {'rises' if problem.maximise else 'falls'} without bound: it is quadratic, the "
            "plant is linear, and the second variation is "
            f"{'positive' if problem.maximise else 'negative'} in some direction, along which the cost "
            "changes with the square of the distance. Check the sign of the cost, bound the controls, or "
            "choose a shorter duration."
        )
    return replace(extremal, _proof=PROOF) if sign > 0 else extremal


def _extremal(numeric, samples, multipliers):
    """Return the extremal through (y, psi, u) at equal steps, (N+1, 2n+k)."""
    flow, every = ArcFlow(numeric, ("interior",) * numeric.k), SAMPLES
    while every > 1:
        length = every * numeric.duration / (len(samples) - 1)
        if growth(flow, samples[:-1:every], 1.0, length) <= CANCELLING:
            break
        every //= 2
    nodes = samples[::every]
    count = len(nodes) - 1
    shot = ShootingSolution(
        [flow] * count,
        [node.copy() for node in nodes[:-1]],
        np.full(count, numeric.duration / count),
        1.0,
        multipliers,
        [1] * count,
        uncertainty=0.0,
    )
    while (steps := finer_steps(shot, INTEGRATED)) != shot.steps:
        shot.steps = steps
    shot.residual = max(
        np.max(np.abs(flow.nodes(np.append(start, 0.0), 1.0, length, s)[-1, :-1] - end))
        for start, length, s, end in zip(shot.starts, shot.lengths, shot.steps, nodes[1:])
    )
    return extremal_of_shot(numeric, shot, 0, 1)


def _segment_count(K, duration):
    """Return the number of segments along which errors grow by CANCELLING at most, or None.

    Errors are measured in units in which K is balanced. The last variable, s, acts on no other.
    """
    from scipy.linalg import expm, matrix_balance

    K, count = matrix_balance(np.array(K[:-1, :-1].evalf(), dtype=float), permute=False)[0], 1
    while count <= MAX_SEGMENTS:
        with np.errstate(all="ignore"):
            largest = np.max(np.abs(expm(K * duration / count)))
        if largest <= CANCELLING:
            return count
        count *= 2
    return None


def _solution(boundary, duration, count):
    """Return (y, psi, u) at equal steps, (count+1, 2n+k), nu and the cost; None if not unique."""
    digits, previous = DIGITS, None
    while digits <= MAX_DIGITS:
        solution = _solved(boundary, duration, count, digits)
        if solution is not None and not all(np.isfinite(a).all() for a in solution):
            return None
        if solution is not None and previous is not None:
            differences = [np.max(np.abs(a - b), initial=0) for a, b in zip(solution, previous)]
            sizes = [np.max(np.abs(a), initial=0) for a in solution]
            if all(d <= AGREEMENT * size for d, size in zip(differences, sizes)):
                return solution
        digits, previous = 2 * digits, solution
    return None


def _solved(boundary, duration, count, digits):
    """Return the solution with so many digits in the arithmetic, rounded; None if it fails."""
    with mpmath.workdps(digits):
        unknown = boundary.final.cols - 1
        step, matrix, right = linear_equations(boundary, duration, count)
        try:
            solution = mpmath.lu_solve(matrix, right)
        except (ZeroDivisionError, TypeError):  # TypeError: mpmath's for a column of zeros
            return None
        path = [mpmath.matrix([*solution[:unknown], 1, 0])]
        for _ in range(count):
            path.append(step * path[-1])
        feedback, n = evaluated(boundary.feedback), unknown // 2
        rows = [[*z[:unknown], *(feedback * z[: unknown + 1])] for z in path]
        products = [mpmath.fdot(z[:n], z[n:unknown]) for z in (path[0], path[-1])]
        value, slope, curvature = boundary.terminal_cost
        y = path[-1][:n]
        cost = (products[1] - products[0] + path[-1][unknown + 1]) / 2 + value.evalf(digits)
        cost += (y.T * (evaluated(slope) + evaluated(curvature) * y / 2))[0]
        return (
            np.array(rows, dtype=float),
            np.array(list(solution[unknown:]), dtype=float),
            np.array([cost], dtype=float),
        )


LINEAR_QUADRATIC = Method(
    "linear-quadratic boundary value problem",
    "The conditions of the maximum principle are linear equations; the second variation decides.",
    "trajlib.pontryagin.indirect.linear_quadratic; Mangasarian 1966",
    (
        GIVEN_TIME,
        UNBOUNDED_CONTROLS,
        Hypothesis(
            "the plant and the terminal equations are linear, and the cost is quadratic",
            _is_linear_quadratic,
        ),
    ),
    solve_linear_quadratic,
)
