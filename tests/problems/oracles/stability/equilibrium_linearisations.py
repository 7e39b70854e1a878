"""Oracles of linearisations at equilibria and their spectra."""

from itertools import permutations

from oracles.sameness import same_value


def spectra(mutant, reference, field, state):
    """As `same_value` for rows of a point and its eigenvalues: rows and the eigenvalues of one row
    have no order."""
    n = len(state)

    def same_row(one, other):
        return (
            len(one) == len(other)
            and same_value(one[:n], other[:n])
            and any(same_value(list(order), other[n:]) for order in permutations(one[n:]))
        )

    return all(any(same_row(a, b) for b in reference) for a in mutant) and all(
        any(same_row(a, b) for a in mutant) for b in reference
    )


def same_matrices(mutant, reference, *_, **__):
    """True if two lists hold the same matrices, in any order, or one matrix is the other."""
    if not isinstance(reference, list):
        return same_value(mutant, reference)
    return all(any(same_value(a, b) for b in reference) for a in mutant) and all(
        any(same_value(a, b) for a in mutant) for b in reference
    )


ORACLES = {"equilibrium_linearisation": same_matrices, "spectra": spectra}
