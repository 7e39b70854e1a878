"""Bounds of a control that depend on the state: a(y) <= u <= b(y) as u = a + (b - a) v, 0 <= v <= 1.

With one bound, u = a + v or u = b - v with v >= 0. The costate is that of the original problem: its
adjoint system has, besides -dH/dy, the multiplier of the active bound, dH/du, times db/dy (da/dy),

    psi' = -dH/dy - dH/du db/dy = -d/dy H(psi, y, b(y)),

and this is the adjoint system for v.
"""

from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True, eq=False)
class StateBounds:
    """A problem with controls v between numbers in place of those with bounds in the state.

    Attributes
    ----------
    original, problem : Statement
        Before and after; the controls keep their order.
    offsets, factors : tuple of sympy.Expr
        u = offset + factor v for each control.
    """

    original: Statement
    problem: Statement
    offsets: tuple[sp.Expr, ...]
    factors: tuple[sp.Expr, ...]

    def values(self, states) -> np.ndarray:
        """Return (offset, factor) for each control at states (n, N): shape (2, k, N)."""
        raw = sp.lambdify(list(self.original.state), [*self.offsets, *self.factors], [np])
        count = np.shape(states)[1]
        rows = [np.broadcast_to(np.asarray(row, float), count) for row in raw(*states)]
        return np.array(rows).reshape(2, len(self.offsets), count)


def with_constant_bounds(problem: Statement) -> StateBounds | None:
    """Return the problem with constant bounds; None if no bound contains a state."""
    if not problem.bounds_depend_on_state:
        return None
    table: dict = {}
    controls: dict = {}
    offsets, factors = [], []
    for u, (low, high) in problem.controls.items():
        offset, factor, pair, v = sp.Integer(0), sp.Integer(1), (low, high), u
        if {*low.free_symbols, *high.free_symbols} & set(problem.state):
            v = sp.Dummy(f"v_{u}", real=True)
            if high == sp.oo:
                offset, pair = low, (0, sp.oo)
            elif low == -sp.oo:
                offset, factor, pair = high, sp.Integer(-1), (0, sp.oo)
            else:
                offset, factor, pair = low, high - low, (0, 1)
            table[u] = offset + factor * v
        controls[v] = pair
        offsets.append(offset)
        factors.append(factor)
    changed = replace(
        problem,
        dynamics={y: f.subs(table) for y, f in problem.dynamics.items()},
        running=problem.running.subs(table),
        controls=controls,
    )
    return StateBounds(problem, changed, tuple(offsets), tuple(factors))
