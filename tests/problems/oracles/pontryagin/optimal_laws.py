"""Oracles of the laws of optimal processes, which may be written as equations for the control."""

import numpy as np
import sympy as sp

from oracles.pontryagin.transfers import same_transfer
from oracles.sameness import compiled


def same_law(mutant, reference, problem, parameters, time=None):
    """True if two laws agree at random states; of equations the solutions between the bounds
    count."""
    if not any(isinstance(one, sp.Eq) for one in (mutant, reference)):
        return not isinstance(mutant, (list, tuple)) and same_transfer(mutant, reference)
    ((control, bounds),) = problem.controls.items()
    sides = [
        one.lhs - one.rhs
        if isinstance(one, sp.Eq)
        else control - one
        if isinstance(one, sp.Expr)
        else None
        for one in (mutant, reference)
    ]
    if None in sides:
        return False
    symbols = tuple(
        sorted(set(problem.dynamics) | sides[0].free_symbols | sides[1].free_symbols, key=str)
    )
    grid, random = np.linspace(*map(float, bounds), 2001), np.random.default_rng(31)
    functions = [compiled(symbols, side) for side in sides]
    for _ in range(60):
        values = {s: random.normal() * random.choice((0.5, 2, 6)) for s in symbols}
        found = []
        for function in functions:
            with np.errstate(all="ignore"):
                left = np.broadcast_to(
                    np.asarray(function(*(values | {control: grid}).values()), complex), grid.shape
                )
            zeros = np.flatnonzero((left[:-1] * left[1:]).real <= 0)
            found.append(
                sorted({round(k / 20) for k in zeros}) if np.abs(left.imag).max() < 1e-9 else None
            )
        if found[0] is None or found[0] != found[1]:
            return False
    return True


ORACLES = {
    "optimal_law": same_law,
    "arc_transition_curve": lambda mutant, reference, *_: same_transfer(mutant, reference),
}
