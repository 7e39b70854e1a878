"""The modes of a mechanical system M x'' + D x' + K x = 0 with invertible M: their roots, and the motions no output
shows.

Both are found in the state (x, x'), and not in the matrix polynomial, in which students and `mechanical` work.
"""

import dataclasses

import sympy as sp

from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import OUTPUT, compare_eigenvalues
from trajlib.checks.structure.mechanical import first_order
from trajlib.checks.structure.unseen_bases import judge_basis
from trajlib.checks.truths.invariant_subspaces import characteristic_coefficients, different_roots

#: A root is a value at which the square matrix loses its rank: the question of Theorem 2.5 with an output that shows
#: nothing.
ALONE = dataclasses.replace(OUTPUT, pencil="M lambda^2 + D lambda + K",
                            spectrum="root of det(M lambda^2 + D lambda + K) = 0",
                            vector="vector v other than 0 with (M lambda^2 + D lambda + K) v = 0")


@judged
def mechanical_roots(answer, M, D, K, parameters=()):
    """The different roots of det(M lambda^2 + D lambda + K), also complex ones; with parameters for their values in
    general position."""
    pair = first_order(M, D, K, sp.zeros(1, M.cols), sp.zeros(1, M.cols), parameters)
    roots = [different_roots(characteristic_coefficients(pair.at(place)[0])) for _, place in pair.samples]
    compare_eigenvalues(answer, pair.parameters, [values for values, _ in pair.samples], roots, roots, ALONE)
    return "the determinant vanishes at each of them and nowhere else"


@judged
def mechanical_unseen_states(answer, M, D, K, H1, H2):
    """A basis of the initial states (x, x') whose motions give z = H1 x + H2 x' = 0 for all time; an empty list if zero
    is the only one."""
    return judge_basis(answer, first_order(M, D, K, H1, H2, ()), OUTPUT)
