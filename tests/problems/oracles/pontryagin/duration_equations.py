"""The oracle of equations for a shortest duration."""

import numpy as np
import sympy as sp
from scipy.optimize import brentq


def same_least_root(mutant, reference, problem, duration, parameters):
    """True if two equations for a duration have the same least positive root, for random values of
    the parameters."""
    random = np.random.default_rng(5)
    functions = [
        sp.lambdify([duration, *parameters], e.lhs - e.rhs if isinstance(e, sp.Eq) else e)
        for e in (mutant, reference)
    ]
    for _ in range(12):
        values = [random.uniform(float(part.inf), float(part.sup)) for part in parameters.values()]
        one, other = (_least_root(lambda T, f=f: f(T, *values)) for f in functions)
        if one is None or other is None or not abs(one - other) <= 1e-9 * (1 + other):
            return False
    return True


def _least_root(function):
    grid = np.linspace(1e-3, 12, 4001)
    values = [complex(function(T)) for T in grid]
    if not np.isfinite(values).all() or np.abs(np.imag(values)).max() > 0:
        return None
    signs = np.sign(np.real(values))
    changes = np.flatnonzero(signs[1:] * signs[:-1] <= 0)
    return (
        brentq(lambda T: float(function(T)), *grid[changes[0] : changes[0] + 2], xtol=1e-14)
        if changes.size
        else None
    )


ORACLES = {"duration_equation": same_least_root}
