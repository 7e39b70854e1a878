"""Linear-quadratic problems whose end is a conjugate point: the cost that falls in proportion.

The extremals of a linear plant with a quadratic cost solve a linear boundary value problem
(`linear_quadratic`). Where its homogeneous part has a solution (v, p, nu) other than zero, with
w = R^-1 (B^T p - S^T v), the variation v keeps both ends, and the second variation is zero along it.
For an admissible process (x, u) then

    J(x + c v, u + c w) = J(x, u) + c l,
    l = int (q^T v + r^T w - c_0^T p) dt + (grad phi_0(0))^T v(T) - d^T nu - x(0)^T p(0),

G y = d being the target and c_0 the constant of the plant: integrate (x^T p)' with p' = -A^T p + Q v
+ S w. The number l does not depend on the process, and for l other than zero the cost falls without
bound. For example x' = u, J = int (u^2 - x^2) dt from x(0) = 1 to x(T) = 0 with T = pi: v = sin t,
p = 2 cos t, l = -2.
"""

import mpmath

from trajlib.pontryagin.indirect.linear_boundary_problem import (
    BoundaryProblem,
    evaluated,
    linear_equations,
)
from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.statement import Statement

# Decimal digits of the arithmetic, and to how many of them the homogeneous equations must hold.
DIGITS, HOLDING = 320, 80


def refuse_conjugate_end(boundary: BoundaryProblem, problem: Statement, count: int) -> None:
    """Raise `Unbounded` if the cost changes along a solution of the homogeneous equations.

    `boundary`: equations that were not solved; `problem`: without inequalities; `count`: number of
    steps that follow a solution from one end to the other.
    """
    with mpmath.workdps(DIGITS):
        step, matrix, right = linear_equations(boundary, problem.duration, count)
        # Where the equations have no solution, those with a small disturbance have a large one,
        # which solves the homogeneous equations up to the disturbance.
        disturbance = mpmath.mpf(10) ** (-DIGITS // 2)
        solution = mpmath.lu_solve(matrix + disturbance * mpmath.eye(matrix.rows), right)
        unknown, tolerance = boundary.final.cols - 1, mpmath.mpf(10) ** -HOLDING
        path = [mpmath.matrix([*solution[:unknown], 0, 0])]
        for _ in range(count):
            path.append(step * path[-1])
        size = max(mpmath.norm(z[:unknown], mpmath.inf) for z in path)
        slope, scale = _first_variation(boundary, path, solution[unknown:])
        holds = mpmath.norm(matrix * solution, mpmath.inf) <= tolerance * size
        if not holds or abs(slope) <= tolerance * scale:
            return
    raise Unbounded(
        f"the cost {'rises' if problem.maximise else 'falls'} without bound: it is quadratic, the plant "
        f"is linear, and the final time is a conjugate point (to {HOLDING} digits): along a variation "
        "that keeps both ends the second variation is zero and the first is not, so that the cost "
        "changes in proportion to the distance. Choose a shorter duration, or bound the controls."
    )


def _first_variation(boundary, path, nu):
    """Return l and the sum of the sizes of its terms."""
    last = boundary.final.cols - 1
    n = last // 2
    start, end = path[0], path[-1]
    # The equations at the ends contain -x(0) and -d as their constants.
    products = [
        (evaluated(boundary.terminal_cost[1]), end[:n]),
        (evaluated(boundary.initial[:, last]), start[n:last]),
        (evaluated(boundary.final[: len(nu), last]), nu),
    ]
    terms = [end[last + 1], *(a * b for values, others in products for a, b in zip(values, others))]
    return mpmath.fsum(terms), mpmath.fsum(abs(term) for term in terms)
