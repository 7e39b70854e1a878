"""Observability of x' = A x, z = H x with A: n x n and H: m x n, for the `parameters` (a list of symbols) in them."""

from trajlib.checks.contract.claims import Vectors, YesNo
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import (
    EIGENVALUES,
    OUTPUT,
    judge_eigenvalues,
    judge_region,
    judge_yes_no,
)
from trajlib.checks.structure.unseen_bases import bases_by_value, judge_basis, judge_where_lost
from trajlib.checks.truths.pairs import pair_of


@judged(YesNo())
def observable(claim, A, H, parameters=()):
    """Whether x' = A x, z = H x (A: n x n, H: m x n) is observable; with parameters, whether it is for all values that
    their assumptions allow."""
    return judge_yes_no(claim, pair_of(A, H, parameters), OUTPUT)


@judged
def observable_parameters(answer, A, H, parameters):
    """The condition on the parameters under which the system is observable: true exactly there, at isolated values
    too."""
    return judge_region(answer, pair_of(A, H, parameters), OUTPUT)


@judged
def unobservable_parameters(answer, A, H, parameters):
    """The condition on the parameters under which the system is not observable; a set or a list of values of the only
    one as well."""
    return judge_region(answer, pair_of(A, H, parameters), OUTPUT, holds=False)


@judged(Vectors("parameters", size="A"))
def unseen_states(claim, A, H, parameters=()):
    """A basis of the initial states whose motions give z = 0 for all time; an empty list if zero is the only one.

    With parameters: for their values in general position, as the assumptions allow, and wherever as much is unseen.
    """
    return judge_basis(claim, pair_of(A, H, parameters), OUTPUT)


@judged(bases_by_value(OUTPUT))
def unseen_where_lost(claim, A, H, parameter):
    """Every real value of the parameter for which the system is not observable, as {value: basis of the unseen states}.

    For systems that lose observability at finitely many values, all of them rational.
    """
    return judge_where_lost(claim, pair_of(A, H, (parameter,)), OUTPUT,
                            lambda value: pair_of(A.subs(parameter, value), H.subs(parameter, value)))


@judged(EIGENVALUES)
def lost_eigenvalues(claim, A, H, parameters=()):
    """The different eigenvalues of A at which the rank of Theorem 2.3 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return judge_eigenvalues(claim, pair_of(A, H, parameters), OUTPUT)
