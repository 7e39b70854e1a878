"""Oracles of bases of unseen states: a basis may be any other one of the same space."""

import sympy as sp

from oracles.structure.linear_systems import is_basis
from oracles.structure.records import reached, seen


def where_lost(rows):
    """At the same values, bases of what the derivatives of z send to zero there."""

    def oracle(mutant, reference, system, parameter):
        if not isinstance(mutant, dict) or {sp.sympify(value) for value in mutant} != {
            sp.sympify(value) for value in reference
        }:
            return False
        N = rows(system)
        return all(
            is_basis(basis, N.subs(parameter, value).as_immutable())
            for value, basis in mutant.items()
        )

    return oracle


ORACLES = {
    "unobservable_states_at": where_lost(seen),
    "uncontrollable_combinations_at": where_lost(reached),
}
