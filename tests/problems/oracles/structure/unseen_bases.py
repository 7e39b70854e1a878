"""Oracles of bases of unseen states: a basis may be any other one of the same space."""

import sympy as sp

from oracles.structure.linear_systems import is_basis
from oracles.structure.records import reached, seen


def where_lost(rows):
    """At the same values, bases of what the derivatives of z send to zero there."""
    def oracle(mutant, reference, system, parameter):
        if not isinstance(mutant, dict) or {sp.sympify(value) for value in mutant} != {sp.sympify(value)
                                                                                       for value in reference}:
            return False
        N = rows(system)
        return all(is_basis(basis, N.subs(parameter, value).as_immutable()) for value, basis in mutant.items())

    return oracle


def unseen_changes(mutant, reference, *data, **options):
    """Independent combinations of the vectors of the reference, as many."""
    size = len(reference[0]) if reference else 0
    if not isinstance(mutant, (list, tuple)) or len(mutant) != len(reference) or any(
            not isinstance(v, (list, tuple)) or len(v) != size for v in mutant):
        return False
    both = [sp.Matrix(vectors).T for vectors in (mutant, reference)]
    return both[0].rank(simplify=True) == sp.Matrix.hstack(*both).rank(simplify=True) == len(reference)


ORACLES = {"unseen_where_lost": where_lost(seen), "uncontrolled_where_lost": where_lost(reached),
           "unseen_changes": unseen_changes}
