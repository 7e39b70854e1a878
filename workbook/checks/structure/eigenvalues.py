"""Unobservable or uncontrollable eigenvalues by the PBH (Popov-Belevitch-Hautus) test.

Theorem 2.3 with an output, Theorem 2.4 with a control, Theorems 2.5 and 2.6 for a mechanical
system.

No check here is declared by a reference: a wrong value is explained by the rank there.
"""

from workbook.checks.contract.verdict import judged
from workbook.checks.references.records import controlled_pair, has_control, observed_pair
from workbook.checks.structure.dual_questions import CONTROL, EIGENVALUES, OUTPUT, judge_eigenvalues
from workbook.checks.structure.mechanical import CONTROL_PENCIL, OUTPUT_PENCIL, judge_roots
from workbook.systems import Mechanical


@judged(EIGENVALUES, system="Linear, Process or Mechanical")
def fixed_eigenvalues(claim, system, parameters=()):
    """Check the different eigenvalues that are unobservable or, with a control, uncontrollable.

    At these eigenvalues of A, for a `Mechanical` system at these values of lambda, the rank of
    the matrix with the output or, if the system has one, with the control falls; an empty list
    or set says that there are none.

    With parameters: for their values in general position, as the assumptions allow.

    Can decide when the entries are exact numbers: the rank of the PBH test is computed exactly.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> plant = Linear(A=[[1, 2], [1, 0]], B=[[1], [-1]])
    >>> checks.fixed_eigenvalues([2], plant).status, checks.fixed_eigenvalues([-1], plant).status
    ('right', 'wrong')
    """
    control = has_control(system)
    if isinstance(system, Mechanical):
        side = CONTROL_PENCIL if control else OUTPUT_PENCIL
        return judge_roots(claim, system.dual if control else system, parameters, side)
    pair = (controlled_pair if control else observed_pair)(system, parameters)
    return judge_eigenvalues(claim, pair, CONTROL if control else OUTPUT)
