"""Controllability of x' = A x + B u: what is asked of observability in `observability.py`, of the transposed
matrices."""

from trajlib.checks.contract import coercion
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import (
    CONTROL,
    judge_eigenvalues,
    judge_kalman,
    judge_rank,
    judge_region,
    judge_yes_no,
)
from trajlib.checks.structure.unseen_bases import judge_basis, judge_where_lost
from trajlib.checks.truths.pairs import pair_of


@judged
def controllable(answer, A, B, parameters=()):
    """Whether x' = A x + B u is controllable; with parameters, whether it is for all values that their assumptions
    allow."""
    return judge_yes_no(answer, pair_of(A.T, B.T, parameters), CONTROL)


@judged
def controllable_parameters(answer, A, B, parameters):
    """The condition on the parameters under which the system is controllable: true exactly there, at isolated values
    too."""
    return judge_region(answer, pair_of(A.T, B.T, parameters), CONTROL, holds=True)


@judged
def controllability_matrix(answer, A, B, parameters=()):
    """Kalman's matrix W of Definition 2.4: the columns of B, then those of A B, and so on to A^(n-1) B."""
    pair = pair_of(A.T, B.T, parameters)
    return judge_kalman(coercion.as_matrix(answer, parameters, (pair.order, pair.order * pair.outputs)).T, pair,
                        CONTROL)


@judged
def controllability_rank(answer, A, B):
    """The rank of W: the order of the system less the number of independent combinations of x that no control
    changes."""
    return judge_rank(answer, pair_of(A.T, B.T), CONTROL)


@judged
def uncontrolled_combinations(answer, A, B, parameters=()):
    """A basis of the rows w whose combinations w x of the coordinates no control changes; an empty list if every one is
    changed.

    With parameters: for their values in general position, as the assumptions allow; with one, also where the answer
    might fail.
    """
    return judge_basis(answer, pair_of(A.T, B.T, parameters), CONTROL)


@judged
def uncontrolled_where_lost(answer, A, B, parameter):
    """Every real value of the parameter for which the system is not controllable, as {value: basis of the rows w}.

    For systems that lose controllability at finitely many values, all of them rational.
    """
    return judge_where_lost(answer, pair_of(A.T, B.T, (parameter,)), CONTROL,
                            lambda value: pair_of(A.T.subs(parameter, value), B.T.subs(parameter, value)))


@judged
def uncontrolled_eigenvalues(answer, A, B, parameters=()):
    """The different eigenvalues of A at which the rank of Theorem 2.4 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return judge_eigenvalues(answer, pair_of(A.T, B.T, parameters), CONTROL)
