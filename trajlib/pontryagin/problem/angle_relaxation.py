"""Relaxation of angles: the vector (cos u, sin u) may lie in the disc |e| <= 1.

Where an angle occurs in cos u and sin u only, and linearly, a plant may be linear in the vector
e = (cos u, sin u) though it is not linear in u. The circle |e| = 1 lies in the disc |e| <= 1: what
the disc cannot reach, the circle cannot. And H, linear in e, is largest on the circle, so that an
extremal of the problem is one of the problem with discs.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import sympy as sp

from trajlib.pontryagin.problem.statement import Statement


@dataclass(frozen=True)
class AngleRelaxation:
    """A statement in which vectors in discs replace angles.

    Attributes
    ----------
    problem : Statement
        With one control for each component of a vector.
    blocks : tuple of tuple of int
        Indices of its controls, the two components of a disc together.
    """

    problem: Statement
    blocks: tuple[tuple[int, ...], ...]

    @cached_property
    def bounds(self) -> np.ndarray:
        """The bounds of the controls as numbers, shape (k, 2)."""
        return np.array([[float(b) for b in pair] for pair in self.problem.controls.values()])

    def least(self, gains: np.ndarray) -> np.ndarray:
        """Return the minimum of gains^T u over the admissible controls.

        `gains` has shape (..., k); the minimum is -inf where no bound limits it.
        """
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
    """Check whether an unbounded control occurs only in sines and cosines of its multiples."""
    waves = {}
    for e in (*problem.field, problem.running):
        for wave in e.atoms(sp.sin, sp.cos):
            if sp.diff(wave.args[0], u).is_integer:
                waves[wave] = sp.Dummy()
    remaining_symbols = set().union(
        *(e.xreplace(waves).free_symbols for e in (*problem.field, problem.running))
    )
    return problem.controls[u] == (-sp.oo, sp.oo) and u not in remaining_symbols


def relax_angles(problem: Statement) -> AngleRelaxation | None:
    """Return the relaxation of a problem; without angles that of the problem itself.

    None if an angle occurs otherwise than linearly in cos u, sin u.
    """
    return problem.cached("angle relaxation", lambda: _relaxed(problem))


def _relaxed(problem: Statement) -> AngleRelaxation | None:
    controls: dict = {}
    table: dict = {}
    blocks: list[tuple[int, ...]] = []
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
        return AngleRelaxation(problem, tuple(blocks))
    rates, vectors = [e.xreplace(table) for e in _rates(problem)], list(table.values())
    if any(
        e.has(*(set(problem.control) - set(controls))) or not sp.hessian(e, vectors).is_zero_matrix
        for e in rates
    ):
        return None
    *field, running = rates
    return AngleRelaxation(
        replace(
            problem, dynamics=dict(zip(problem.state, field)), controls=controls, running=running
        ),
        tuple(blocks),
    )


def _rates(problem):
    return (*problem.field, problem.running)
