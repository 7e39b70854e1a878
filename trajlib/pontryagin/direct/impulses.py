"""Infima that are approached by impulses: v' = u^3 with the cost int u^2, or x' = u with int x^2.

Where the running cost grows no faster with an unbounded control than the right-hand sides do, a
control u = h^(-1/p) during the time h changes the state by about 1 and costs h^(1 - q/p) at most (p
and q being the degrees in u): ever shorter and larger controls may cost ever less, and Tonelli's
condition for the existence of an optimal process fails. Then finer grids show whether it is so.
"""

from itertools import pairwise

import numpy as np
import sympy as sp

from trajlib.pontryagin.direct.descent import solution_from_controls
from trajlib.pontryagin.problem.errors import Unbounded
from trajlib.pontryagin.problem.steps import Hypothesis, Refusal

# Growth of the largest control from one grid to a finer one, and the mean decrease of the cost as a
# share of it, that are not errors of the steps.
GROWS, FALLS = 1.2, 1e-3
# A large control, with which the growth of terms is measured.
LARGE = 2**40
# How many intervals of a finer grid one of the coarser has.
FINER = 4


def _refuse_impulses(numeric, solution, side):
    degrees = _impulsive_degrees(numeric.problem)
    solutions = [solution]
    for _ in range(2):
        controls = _sharpened(solutions[-1].controls, degrees)
        finer = solution_from_controls(numeric, solutions[-1], side, controls)
        if finer is None:
            return
        solutions.append(finer)
    costs = [s.cost for s in solutions]
    falls = all(b < a for a, b in pairwise(costs))
    falls = falls and costs[-1] < costs[0] - 2 * FALLS * abs(costs[0])
    for j in degrees:
        largest = [float(np.max(np.abs(s.controls[:, j]))) for s in solutions]
        if falls and all(b > GROWS * a for a, b in pairwise(largest)):
            u = numeric.problem.control[j]
            values = ", ".join(
                f"{numeric.user_cost(cost):.6g} with {len(s.controls)} intervals"
                for s, cost in zip(solutions, costs)
            )
            raise Unbounded(
                f"impulses seem to approach the infimum, which is not attained then: {u} is "
                "unbounded, and the running cost grows no "
                f"faster with it than the dynamics do, so that ever shorter impulses of {u} cost ever "
                f"less ({values}). Bound {u}, or give it a cost that grows faster."
            )


def _impulsive_degrees(problem):
    """Return {index: degree of f} of the controls in which impulses may cost ever less."""
    return {
        j: degree
        for j, (u, (low, high)) in enumerate(problem.controls.items())
        if not (low.is_finite and high.is_finite)
        and (degree := _impulsive_degree(problem, u)) is not None
        and degree > 0
    }


def _impulsive_degree(problem, u):
    """Return the degree of f in u if that of f_0 is not larger; None elsewhere."""
    degrees = [_degree(e, u) for e in (problem.running, *problem.field)]
    if None in degrees:
        return None
    cost, *rates = degrees
    return max(rates) if cost <= max(rates) else None


def _degree(e, u):
    """Return the degree of a polynomial in u, or the power by which another term grows with u.

    The latter at a point without symmetry and to three decimals; None if it is not a power.
    """
    if not e.has(u):
        return 0
    if e.is_polynomial(u):
        return sp.degree(e, u)
    others = sorted(e.free_symbols - {u}, key=str)
    point = {s: sp.sqrt(2 + i) / 3 for i, s in enumerate(others)}
    sizes = [abs(complex(e.subs({**point, u: LARGE * factor}).evalf())) for factor in (1, 2, 4)]
    if not np.isfinite(sizes).all() or not min(sizes) > 0:
        return None
    first, second = np.round(np.diff(np.log2(sizes)), 3)
    return float(first) if first == second else None


def _sharpened(controls, degrees):
    """Return controls on intervals FINER times as short, with u^p on the first of each FINER."""
    finer = np.repeat(controls, FINER, axis=0)
    for j, degree in degrees.items():
        finer[:, j] = 0.0
        finer[::FINER, j] = controls[:, j] * FINER ** (1 / degree)
    return finer


GROWTH_FAILS = Hypothesis(
    "the running cost grows no faster with an unbounded control than the dynamics do",
    lambda p: bool(_impulsive_degrees(p)),
)
IMPULSES = Refusal(
    "impulses",
    "Ever shorter and larger controls cost ever less, and the infimum is not attained.",
    "Tonelli's condition for existence; Cesari, Optimization: Theory and Applications, 1983",
    (GROWTH_FAILS,),
    Unbounded,
    _refuse_impulses,
)
