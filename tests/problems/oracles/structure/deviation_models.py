"""Oracles of the models of deviations."""

import sympy as sp

from oracles.structure.linear_systems import similarity


def change_to_deviations(mutant, reference, A, field, state, motion):
    """True if S is invertible and turns A into the derivatives of the field along the motion, taken one by one."""
    along = sp.Matrix(len(state), len(state), lambda i, j: sp.diff(field[i], state[j]).subs(motion))
    return similarity(mutant, reference, A, along)


ORACLES = {"change_to_deviations": change_to_deviations}
