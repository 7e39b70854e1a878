"""Controllability of x' = A x + B u, a `Linear`, and of a `Mechanical` system.

The questions are those of `observability.py` about the dual system.

No check here is declared by a reference: conditions and bases are decided exactly.
"""

from workbook.checks.contract.claims import Matrix, Vectors, YesNo
from workbook.checks.contract.verdict import judged
from workbook.checks.references.records import controlled_pair
from workbook.checks.structure.dual_questions import (
    CONTROL,
    judge_kalman,
    judge_region,
    judge_yes_no,
)
from workbook.checks.structure.mechanical import CONTROL_PENCIL, judge_rank
from workbook.checks.structure.unobservable_bases import (
    bases_by_value,
    judge_basis,
    judge_exceptional_bases,
)
from workbook.systems import Mechanical


@judged(YesNo(), system="Linear or Mechanical")
def controllable(claim, system, parameters=()):
    """Check whether the system is controllable.

    With parameters: whether it is for all values that their assumptions allow.

    Can decide when the entries are exact numbers, or polynomials in the parameters: the rank is
    computed exactly.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> cart = Linear(A=[[0, 1], [0, 0]], B=[[0], [1]])
    >>> checks.controllable("yes", cart).status, checks.controllable("no", cart).status
    ('right', 'wrong')
    """
    if isinstance(system, Mechanical) and not parameters:
        return judge_rank(claim, system.dual, CONTROL_PENCIL)
    return judge_yes_no(claim, controlled_pair(system, parameters), CONTROL)


@judged(system="Linear or Mechanical with controls")
def controllable_parameters(answer, system, parameters):
    """Check the condition on the parameters under which the system is controllable.

    It has to be true exactly there, at isolated values too.

    Where the M of a `Mechanical` system is singular its order drops; what is said of these
    values does not count.

    Can decide when the entries are polynomials in the parameters, at isolated values too;
    elsewhere the condition is compared at points.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k = sp.Symbol("k", real=True)
    >>> plant = Linear(A=[[0, 1], [-1, 0]], B=[[k], [1]])
    >>> checks.controllable_parameters(True, plant, [k]).status
    'right'
    >>> checks.controllable_parameters(sp.Ne(k, 1), plant, [k]).status
    'wrong'
    """
    return judge_region(answer, controlled_pair(system, parameters), CONTROL)


@judged(
    Matrix(
        "parameters",
        shape=lambda data: (data["system"].A.rows, data["system"].A.rows * data["system"].B.cols),
    ),
    system="Linear with controls",
)
def controllability_matrix(claim, system, parameters=()):
    """Check the controllability matrix W = (B, A B, ..., A^(n-1) B) of Definition 2.4.

    Its shape is n x n s: the columns of B, then those of A B, and so on.

    Can decide when the entries are exact: each block has to be A times the one before.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> plant = Linear(A=[[0, 1], [2, 1]], B=[[0], [1]])
    >>> checks.controllability_matrix([[0, 1], [1, 1]], plant).status
    'right'
    >>> checks.controllability_matrix([[0, 1], [1, 0]], plant).status
    'wrong'
    """
    return judge_kalman(claim.T, controlled_pair(system, parameters), CONTROL)


@judged(Vectors("parameters", size="system.unknowns"), system="Linear or Mechanical with controls")
def uncontrollable_combinations(claim, system, parameters=()):
    """Check a basis of the rows w whose combinations w x no control changes.

    An empty list says that every combination is changed by some control.

    With parameters: for their values in general position, as the assumptions allow; with one,
    also where the answer might fail.

    Can decide when the entries are exact numbers; with parameters for their values in general
    position, exactly. Any basis is right.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> plant = Linear(A=[[1, 2], [1, 0]], B=[[1], [-1]])
    >>> checks.uncontrollable_combinations([[2, 2]], plant).status
    'right'
    >>> checks.uncontrollable_combinations([], plant).status
    'wrong'
    """
    return judge_basis(claim, controlled_pair(system, parameters), CONTROL)


@judged(bases_by_value(CONTROL), system="Linear or Mechanical with controls")
def uncontrollable_combinations_at(claim, system, parameter):
    """Check the parameter values without controllability, as {value: basis of the rows w}.

    Every real value of the parameter for which the system is not controllable is asked for.

    For systems that lose controllability at finitely many values, all of them rational.

    Can decide when the entries are polynomials in the parameter: all its values are examined
    exactly.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k = sp.Symbol("k", real=True)
    >>> plant = Linear(A=[[1, 0], [0, 2]], B=[[1], [k]])
    >>> checks.uncontrollable_combinations_at({0: [[0, 1]]}, plant, k).status
    'right'
    >>> checks.uncontrollable_combinations_at({}, plant, k).status
    'wrong'
    """
    return judge_exceptional_bases(
        claim,
        controlled_pair(system, (parameter,)),
        CONTROL,
        lambda value: controlled_pair(system.subs(parameter, value)),
    )
