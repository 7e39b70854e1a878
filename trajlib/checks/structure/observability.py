"""Observability of x' = A x, z = H x: yes or no, for which parameters, what stays unseen and which eigenvalues are
lost.

The truth does not come from the rank of Kalman's matrix but from the states it is about: the largest subspace of ker H
that A maps into itself, exactly (`invariant_subspaces`), at every exceptional value of a parameter too (`pairs`).
"""

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import (
    OUTPUT,
    judge_eigenvalues,
    judge_kalman,
    judge_rank,
    judge_region,
    judge_yes_no,
)
from trajlib.checks.structure.unseen_bases import judge_basis, judge_where_lost
from trajlib.checks.truths.pairs import pair_of


@judged
def observable(answer, A, H, parameters=()):
    """Whether x' = A x, z = H x is observable; with parameters, whether it is for all values that their assumptions
    allow."""
    return judge_yes_no(answer, pair_of(A, H, parameters), OUTPUT)


@judged
def observable_parameters(answer, A, H, parameters):
    """The condition on the parameters under which the system is observable: true exactly there, at isolated values
    too."""
    return judge_region(answer, pair_of(A, H, parameters), OUTPUT, holds=True)


@judged
def unobservable_parameters(answer, A, H, parameters):
    """The condition on the parameters under which the system is not observable; a set or a list of values of the only
    one as well."""
    return judge_region(answer, pair_of(A, H, parameters), OUTPUT, holds=False)


@judged
def observability_matrix(answer, A, H, parameters=()):
    """Kalman's matrix N of Definition 2.3: the rows of H, then those of H A, and so on to H A^(n-1)."""
    pair = pair_of(A, H, parameters)
    return judge_kalman(coercion.as_matrix(answer, parameters, (pair.order * pair.outputs, pair.order)), pair, OUTPUT)


@judged
def observability_rank(answer, A, H):
    """The rank of N: the order of the system less the number of independent states that the output never shows."""
    return judge_rank(answer, pair_of(A, H), OUTPUT)


@judged
def unseen_states(answer, A, H, parameters=()):
    """A basis of the initial states whose motions give z = 0 for all time; an empty list if zero is the only one.

    With parameters: for their values in general position, as the assumptions allow; with one, also where the answer
    might fail.
    """
    return judge_basis(answer, pair_of(A, H, parameters), OUTPUT)


@judged
def unseen_where_lost(answer, A, H, parameter):
    """Every real value of the parameter for which the system is not observable, as {value: basis of the unseen states}.

    For systems that lose observability at finitely many values, all of them rational.
    """
    return judge_where_lost(answer, pair_of(A, H, (parameter,)), OUTPUT,
                            lambda value: pair_of(A.subs(parameter, value), H.subs(parameter, value)))


@judged
def lost_eigenvalues(answer, A, H, parameters=()):
    """The different eigenvalues of A at which the rank of Theorem 2.3 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return judge_eigenvalues(answer, pair_of(A, H, parameters), OUTPUT)
