"""Observability of a system given as a record.

The records are x' = A x, z = H x as `Linear` or `Process`, with an error in the measurement as
`WithError`, with a row H(t) as `Varying`, and `Mechanical`; of constants as `Measurements`,
locally. The `parameters` in them are a list of symbols.

No check here is declared by a reference: conditions and bases are decided exactly.
"""

from workbook.checks.contract.claims import Vectors, YesNo
from workbook.checks.contract.verdict import judged
from workbook.checks.references.records import observed_pair
from workbook.checks.structure.dual_questions import OUTPUT, judge_region, judge_yes_no
from workbook.checks.structure.mechanical import OUTPUT_PENCIL, judge_rank
from workbook.checks.structure.output_wording import PARTS, words
from workbook.checks.structure.unobservable_bases import (
    bases_by_value,
    judge_basis,
    judge_exceptional_bases,
)
from workbook.systems import Mechanical


@judged(YesNo(), system="Linear, WithError, Varying, Process, Mechanical or Measurements")
def observable(claim, system, parameters=()):
    """Check whether z determines every initial state.

    With an error its size has to be determined too; with parameters: whether this holds for all
    values that their assumptions allow.

    Can decide when the entries are exact numbers, or polynomials in the parameters: the rank is
    computed exactly.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> spring = Linear(A=[[0, 1], [-1, 0]], H=[[1, 0]])
    >>> checks.observable("yes", spring).status, checks.observable("no", spring).status
    ('right', 'wrong')
    """
    if isinstance(system, Mechanical) and not parameters:
        return judge_rank(claim, system, OUTPUT_PENCIL)
    return judge_yes_no(claim, observed_pair(system, parameters), words(system))


@judged(system="Linear, WithError, Varying, Process, Mechanical or Measurements with outputs")
def observable_parameters(answer, system, parameters, part=None):
    """Check the condition on the parameters under which the system is observable.

    It has to be true exactly there, at isolated values too.

    Of a system `WithError` a `part` may be asked for, "state" or "error": that it is found,
    whether or not the other one is. Where the M of a `Mechanical` system is singular its order
    drops; what is said of these values does not count. Of `Measurements` it is that their
    Jacobian has full rank.

    Can decide when the entries are polynomials in the parameters, at isolated values too;
    elsewhere the condition is compared at points.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k = sp.Symbol("k", real=True)
    >>> pair = Linear(A=[[0, 1], [2, 0]], H=[[k, 1]])
    >>> checks.observable_parameters(sp.Ne(k**2, 2), pair, [k]).status
    'right'
    >>> checks.observable_parameters(sp.Ne(k, 0), pair, [k]).status
    'wrong'
    """
    selected = PARTS[part](system) if part else None
    return judge_region(answer, observed_pair(system, parameters, selected), words(system, part))


@judged(system="Linear, WithError, Varying, Process, Mechanical or Measurements with outputs")
def unobservable_parameters(answer, system, parameters):
    """Check the condition on the parameters under which the system is not observable.

    A set or a list of values of the only parameter is accepted as well.

    Can decide when the entries are polynomials in the parameters, at isolated values too;
    elsewhere the condition is compared at points.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k = sp.Symbol("k", real=True)
    >>> pair = Linear(A=[[1, 0], [0, 2]], H=[[k, 1]])
    >>> checks.unobservable_parameters([0], pair, [k]).status
    'right'
    >>> checks.unobservable_parameters([1], pair, [k]).status
    'wrong'
    """
    return judge_region(answer, observed_pair(system, parameters), words(system), holds=False)


@judged(
    Vectors("parameters", size="system.unknowns", names="start"),
    system="Linear, WithError, Varying, Process, Mechanical or Measurements",
)
def unobservable_states(claim, system, parameters=(), start=()):
    """Check a basis of the initial states whose motions give z = 0 for all time.

    An empty list says that zero is the only one. The vectors are x(0), with an error (x(0), C),
    for a `Mechanical` system with invertible M (x(0), x'(0)); of `Measurements` the changes of
    the unknowns that alter none to first order.

    With parameters: for their values in general position, as the assumptions allow, and
    wherever as much is unobservable. By the symbols of the `start` a vector may be given as a dict.

    Can decide when the entries are exact numbers; with parameters for their values in general
    position, exactly. Any basis is right.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> pair = Linear(A=[[0, 0], [0, 0]], H=[[2, 1]])
    >>> checks.unobservable_states([[-3, 6]], pair).status
    'right'
    >>> checks.unobservable_states([[2, 1]], pair).message
    'the motion from your vector 1 gives z = 5 at t = 0, not 0'
    """
    return judge_basis(claim, observed_pair(system, parameters), words(system))


@judged(bases_by_value(OUTPUT), system="Linear, WithError, Varying or Mechanical")
def unobservable_states_at(claim, system, parameter):
    """Check the parameter values without observability, as {value: basis of initial states}.

    Every real value of the parameter for which the system is not observable is asked for, with
    the initial states that give z = 0.

    For systems that lose observability at finitely many values, all of them rational.

    Can decide when the entries are polynomials in the parameter: all its values are examined
    exactly.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> k = sp.Symbol("k", real=True)
    >>> pair = Linear(A=[[1, 0], [0, 2]], H=[[1, k]])
    >>> checks.unobservable_states_at({0: [[0, 1]]}, pair, k).status
    'right'
    >>> checks.unobservable_states_at({}, pair, k).status
    'wrong'
    """
    return judge_exceptional_bases(
        claim,
        observed_pair(system, (parameter,)),
        words(system),
        lambda value: observed_pair(system.subs(parameter, value)),
    )
