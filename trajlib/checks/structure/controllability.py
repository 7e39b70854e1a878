"""Controllability of x' = A x + B u with A: n x n and B: n x s: what is asked of observability in `observability.py`,
of the transposed matrices."""

from trajlib.checks.contract.claims import Matrix, Vectors, YesNo
from trajlib.checks.contract.verdict import judged
from trajlib.checks.structure.dual_questions import (
    CONTROL,
    EIGENVALUES,
    judge_eigenvalues,
    judge_kalman,
    judge_region,
    judge_yes_no,
)
from trajlib.checks.structure.unseen_bases import bases_by_value, judge_basis, judge_where_lost
from trajlib.checks.truths.pairs import pair_of


@judged(YesNo())
def controllable(claim, A, B, parameters=()):
    """Whether x' = A x + B u (A: n x n, B: n x s) is controllable; with parameters, whether it is for all values that
    their assumptions allow."""
    return judge_yes_no(claim, pair_of(A.T, B.T, parameters), CONTROL)


@judged
def controllable_parameters(answer, A, B, parameters):
    """The condition on the parameters under which the system is controllable: true exactly there, at isolated values
    too."""
    return judge_region(answer, pair_of(A.T, B.T, parameters), CONTROL)


@judged(Matrix("parameters", shape=lambda data: (data["A"].rows, data["A"].rows * data["B"].cols)))
def controllability_matrix(claim, A, B, parameters=()):
    """Kalman's matrix W (n x n s) of Definition 2.4: the columns of B, then those of A B, and so on to A^(n-1) B."""
    return judge_kalman(claim.T, pair_of(A.T, B.T, parameters), CONTROL)


@judged(Vectors("parameters", size="A"))
def uncontrolled_combinations(claim, A, B, parameters=()):
    """A basis of the rows w whose combinations w x of the coordinates no control changes; an empty list if every one is
    changed.

    With parameters: for their values in general position, as the assumptions allow; with one, also where the answer
    might fail.
    """
    return judge_basis(claim, pair_of(A.T, B.T, parameters), CONTROL)


@judged(bases_by_value(CONTROL))
def uncontrolled_where_lost(claim, A, B, parameter):
    """Every real value of the parameter for which the system is not controllable, as {value: basis of the rows w}.

    For systems that lose controllability at finitely many values, all of them rational.
    """
    return judge_where_lost(claim, pair_of(A.T, B.T, (parameter,)), CONTROL,
                            lambda value: pair_of(A.T.subs(parameter, value), B.T.subs(parameter, value)))


@judged(EIGENVALUES)
def uncontrolled_eigenvalues(claim, A, B, parameters=()):
    """The different eigenvalues of A at which the rank of Theorem 2.4 falls; an empty list or set if there are none.

    With parameters: for their values in general position, as the assumptions allow.
    """
    return judge_eigenvalues(claim, pair_of(A.T, B.T, parameters), CONTROL)
