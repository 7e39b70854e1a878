"""Sufficient conditions: extremals that are proved optimal, or locally minimal.

Two theorems make the maximum principle sufficient. Both are for linear plants y' = A y + B u + c
with bounds on the controls and linear terminal equations.

- *Convexity* (Mangasarian): duration given, f_0 convex in (y, u), phi_0 convex. With lambda_0 = 1,
  H - max H is concave along the extremal, and J(v) - J(u) >= 0 for every admissible v that
  satisfies the terminal equations.
- *Least time to a point that can be held*, A y_k + B u_k + c = 0 with an admissible u_k. A faster
  process could wait at y_k, and would end there at t_k like the extremal: it maximises H almost
  everywhere, so that max H = 0 while it waits. This contradicts lambda_0 > 0; and for lambda_0 = 0
  controllability by each single control makes the maximising control unique, so that both are one
  process.

Path constraints g <= 0 with convex g (linear g for the least time, and g <= 0 at y_k) change neither:
eta dg/dy (z - y) <= eta g(z) <= 0 and the same for the jumps, for every admissible z. So do
terminal inequalities with convex g where the duration is given.

A plant that is linear in the cosine and the sine of an angle is linear in a vector of the disc
(`angle_relaxation`): an extremal of the problem is one of the problem with discs, and what is
optimal there is optimal here.
"""

from dataclasses import dataclass

import sympy as sp

from trajlib.pontryagin.problem.angle_relaxation import relax_angles
from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class Optimality:
    """What is known of an extremal beyond the necessary conditions.

    Attributes
    ----------
    kind : str
        "proved" (no process is better, by a theorem), "locally minimal" (the second variation is
        positive) or "extremal" (the necessary conditions alone, as where the trajectory touches the
        boundary of a path constraint and no theorem applies).
    reason : str
        The theorem, or the sign of the second variation.
    starts : int
        Number of starting guesses of the search; 0 where linear equations have this as their only
        solution.
    processes : int
        Number of different processes to which they led; this is the best.
    """

    kind: str
    reason: str
    starts: int
    processes: int

    @property
    def proved(self) -> bool:
        """Whether no process is better, by a theorem."""
        return self.kind == "proved"

    @property
    def summary(self) -> str:
        """In a few words: proved optimal, or the kind and the best of how many starts."""
        if self.proved:
            return "proved optimal"
        if self.starts == 0:
            return f"{self.kind}, the only one"
        if self.starts == 1:
            return f"{self.kind}, found from the start given"
        return f"{self.kind}, best of {self.starts} starts"

    def __str__(self):
        if self.proved:
            return f"proved optimal: {self.reason}"
        if self.starts == 0:
            best = "the only one"
        elif self.starts == 1:
            best = "the one found from the start given"
        else:
            best = f"the best of {self.processes}" if self.processes > 1 else "the only one"
            best += f" found from {self.starts} starts"
        return f"{self.kind} ({self.reason}), {best}; a better process is not excluded"


def sufficiency_theorem(problem: Statement) -> tuple[str, bool] | None:
    """Return the theorem by which an extremal is optimal: (name, needs lambda_0 > 0), or None.

    `problem`: without parameters. None means that neither theorem applies, not that extremals are
    not optimal.
    """
    blocks = [(i,) for i in range(len(problem.control))]
    return problem.cached("theorem", lambda: _theorem(problem, blocks))


def relaxed_sufficiency_theorem(problem: Statement) -> tuple[str, bool] | None:
    """Return the theorem as `sufficiency_theorem` does, angles being vectors in discs too.

    A stationary process need not be the best one then (a thrust in the opposite direction is
    stationary as well); an extremal is.
    """
    relaxation = relax_angles(problem)
    return (
        sufficiency_theorem(problem)
        if relaxation is None or relaxation.problem is problem
        else _theorem(relaxation.problem, relaxation.blocks)
    )


def _theorem(problem, blocks):
    y, u = sp.Matrix(problem.state), sp.Matrix(problem.control)
    arguments = [*y, *u]
    slopes = sp.Matrix(problem.field).jacobian(arguments)
    targets = sp.Matrix(problem.terminal).jacobian(y) if problem.terminal else sp.zeros(0, len(y))
    if not _constant(slopes, arguments) or not _constant(targets, arguments):
        return None
    constraints = problem.constraints
    if problem.bounds_depend_on_state or not all(
        _convex(g, list(y)) for g in (*constraints, *problem.end_constraints)
    ):
        return None
    sign = -1 if problem.maximise else 1
    if not problem.free_time:
        if _convex(sign * problem.running, arguments) and _convex(sign * problem.final, list(y)):
            return "a linear plant, a convex cost and a given duration", True
        return None
    fastest = (
        problem.time_optimal
        and not problem.maximise
        and problem.duration is None
        and not problem.first_return
        and not problem.end_constraints
        and _constant(sp.Matrix([constraints]).jacobian(y), list(y))
    )
    if fastest and _can_be_held(problem, slopes, targets, blocks):
        return "least time of a linear plant to a point at which it can be held", not _normal(
            slopes, len(y), blocks
        )
    return None


def target_can_be_held(problem: Statement) -> bool:
    """Check whether the target of a linear plant is a point at which it can be held."""
    y, u = sp.Matrix(problem.state), sp.Matrix(problem.control)
    slopes = sp.Matrix(problem.field).jacobian([*y, *u])
    targets = sp.Matrix(problem.terminal).jacobian(y)
    blocks = [(i,) for i in range(len(u))]
    return (
        not slopes.free_symbols
        and not targets.free_symbols
        and _can_be_held(problem, slopes, targets, blocks)
    )


def _constant(matrix, symbols):
    return not matrix.free_symbols & set(symbols)


def _convex(expression, symbols):
    """Check whether a quadratic function is convex; False for one that is not quadratic."""
    hessian = sp.hessian(expression, symbols)
    if not _constant(hessian, symbols):
        return False
    return hessian.is_zero_matrix or bool(hessian.is_positive_semidefinite)


def _can_be_held(problem, slopes, targets, blocks):
    """Check whether the target is one point, an equilibrium for some admissible control."""
    n = len(problem.state)
    if targets.rows != n or targets.rank() < n:
        return False
    point = targets.LUsolve(-sp.Matrix(problem.terminal).subs(dict.fromkeys(problem.state, 0)))
    drift = (
        sp.Matrix(problem.field)
        .subs(dict(zip(problem.state, point)))
        .subs(dict.fromkeys(problem.control, 0))
    )
    gains, bounds = slopes[:, n:], problem.controls.values()
    # The smallest control that holds the point, if there is one.
    hold = -gains.pinv() * drift if any(drift) else sp.zeros(gains.cols, 1)
    return bool(
        (gains * hold + drift).applyfunc(sp.simplify).is_zero_matrix
        and all(low <= value <= high for value, (low, high) in zip(hold, bounds))
        and all(sum(hold[i] ** 2 for i in block) <= 1 for block in blocks if len(block) == 2)
    )


def _normal(slopes, n, blocks):
    """Check whether every single control, or vector of a disc, controls the plant."""
    A, B = slopes[:, :n], slopes[:, n:]
    return all(
        sp.Matrix.hstack(*(A**i * B[:, list(block)] for i in range(n))).rank() == n
        for block in blocks
    )
