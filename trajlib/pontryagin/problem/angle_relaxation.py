"""Angles as vectors: where an angle occurs in cos u and sin u only, and linearly, its vector may
lie in a disc.

With e = (cos u, sin u) in place of the angle a plant may be linear though it is not linear in u.
The circle |e| = 1 lies in the disc |e| <= 1: what the disc cannot reach, the circle cannot. And H,
linear in e, is largest on the circle, so that an extremal of the problem is one of the problem with
discs.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import sympy as sp


@dataclass(frozen=True)
class Relaxed:
    """A statement in which vectors stand for angles: `problem`; `blocks`, the places of its
    controls, the two of a disc together.
    """

    problem: object
    blocks: tuple

    @cached_property
    def bounds(self):
        """The bounds of the controls as numbers, (k, 2)."""
        return np.array([[float(b) for b in pair] for pair in self.problem.controls.values()])

    def least(self, gains):
        """The least of gains^T u over the admissible controls, for gains (..., k); -inf where
        nothing bounds it."""
        total = np.zeros(gains.shape[:-1])
        for block in self.blocks:
            g = [gains[..., i] for i in block]
            if len(block) == 2:
                total -= np.hypot(*g)
            else:
                bound = np.where(g[0] > 0, *self.bounds[block[0]])
                total += np.multiply(g[0], bound, out=np.zeros_like(total), where=g[0] != 0)
        return total


def is_angle(problem, u):
    """Whether a control without bounds occurs only in sines and cosines of whole multiples of
    it."""
    turning = {}
    for e in (*problem.field, problem.running):
        for wave in e.atoms(sp.sin, sp.cos):
            if sp.diff(wave.args[0], u).is_integer:
                turning[wave] = sp.Dummy()
    rest = set().union(
        *(e.xreplace(turning).free_symbols for e in (*problem.field, problem.running))
    )
    return problem.controls[u] == (-sp.oo, sp.oo) and u not in rest


def relaxed(problem):
    """`Relaxed`, without angles the problem itself; None if an angle occurs otherwise than linearly
    in cos u, sin u.
    """
    controls, table, blocks = {}, {}, []
    for u, bounds in problem.controls.items():
        parts = {u: bounds}
        if is_angle(problem, u):
            occurring = [
                wave(u) for wave in (sp.cos, sp.sin) if any(e.has(wave(u)) for e in _rates(problem))
            ]
            vector = {wave: sp.Dummy(str(wave)) for wave in occurring}
            table, parts = table | vector, dict.fromkeys(vector.values(), (-1, 1))
        blocks.append(tuple(range(len(controls), len(controls) + len(parts))))
        controls |= parts
    if not table:
        return Relaxed(problem, tuple(blocks))
    rates, vectors = [e.xreplace(table) for e in _rates(problem)], list(table.values())
    if any(
        e.has(*(set(problem.control) - set(controls))) or not sp.hessian(e, vectors).is_zero_matrix
        for e in rates
    ):
        return None
    *field, running = rates
    return Relaxed(
        replace(
            problem, dynamics=dict(zip(problem.state, field)), controls=controls, running=running
        ),
        tuple(blocks),
    )


def _rates(problem):
    return (*problem.field, problem.running)
