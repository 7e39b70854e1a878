"""Oracles of bases of unseen states: a basis may be any other one of the same space."""

import sympy as sp


def unseen_where_lost(mutant, reference, A, H, parameter):
    """At the same values, bases of what the rows H, H A, ... send to zero there."""
    if not isinstance(mutant, dict) or {sp.sympify(value) for value in mutant} != {sp.sympify(value)
                                                                                   for value in reference}:
        return False
    return all(_is_basis(basis, A.subs(parameter, value), H.subs(parameter, value)) for value, basis in mutant.items())


def uncontrolled_where_lost(mutant, reference, A, B, parameter):
    return unseen_where_lost(mutant, reference, A.T, B.T, parameter)


def mechanical_unseen_states(mutant, reference, system):
    """A basis for the equations solved for the accelerations."""
    M, n = system.M, system.M.rows
    A = sp.Matrix(sp.BlockMatrix([[sp.zeros(n), sp.eye(n)], [-M.LUsolve(system.K), -M.LUsolve(system.D)]]))
    return _is_basis(mutant, A, sp.Matrix.hstack(system.H1, system.H2))


def unseen_changes(mutant, reference, *data, **options):
    """Independent combinations of the vectors of the reference, as many."""
    size = len(reference[0]) if reference else 0
    if not isinstance(mutant, (list, tuple)) or len(mutant) != len(reference) or any(
            not isinstance(v, (list, tuple)) or len(v) != size for v in mutant):
        return False
    both = [sp.Matrix(vectors).T for vectors in (mutant, reference)]
    return both[0].rank(simplify=True) == sp.Matrix.hstack(*both).rank(simplify=True) == len(reference)


def _is_basis(vectors, A, H):
    if not isinstance(vectors, (list, tuple)) or any(not isinstance(v, (list, tuple)) or len(v) != A.rows
                                                     for v in vectors):
        return False
    columns = sp.Matrix(A.rows, len(vectors), lambda i, j: vectors[j][i])
    N = sp.Matrix.vstack(*(H*A**k for k in range(A.rows)))
    return columns.rank() == columns.cols == A.rows - N.rank() and (N*columns).expand().is_zero_matrix


ORACLES = {"unseen_where_lost": unseen_where_lost, "uncontrolled_where_lost": uncontrolled_where_lost,
           "mechanical_unseen_states": mechanical_unseen_states, "unseen_changes": unseen_changes}
